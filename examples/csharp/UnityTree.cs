// A tree in Unity: add the component to a GameObject, choose preset and seed. Compiled by Unity only.
#if UNITY_5_3_OR_NEWER
using System;
using UnityEngine;
using UnityEngine.Rendering;
using TreeFamily;
using TreeFamily.Native;

/// <summary>Grows a tree and draws it, bark and leaf kinds as sub-meshes.</summary>
[RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
public sealed class UnityTree : MonoBehaviour
{
    [Tooltip("Name of a preset, such as oak.")]
    public string preset = "oak";
    [Tooltip("The same seed gives the same tree everywhere.")]
    public int seed = 1;
    [Tooltip("Factor on the length of every leaf."), Range(0.01f, 4f)]
    public float leafScale = 1f;
    [Tooltip("How far the mesh may leave the round branch, in metres."), Range(0.0001f, 0.1f)]
    public float error = 0.003f;
    [Tooltip("Empty: Standard, or the pipeline's Lit.")]
    public Shader shader;

    void Start()
    {
        Rebuild();
    }

    /// <summary>Grows the tree anew.</summary>
    [ContextMenu("Rebuild")]
    public void Rebuild()
    {
        // Threads of its own, that end here: the editor unloads its domain with no thread of ours in it.
        using (var pool = new TreePool(0))
        {
            var options = new CallOptions { Pool = pool };
            tree_mesh_params parameters = TreeDefaults.Mesh;
            parameters.leaf_scale = leafScale;
            parameters.error = error;
            parameters.tangents = 1;
            using (var tree = BotanicalTree.Grow(preset, unchecked((uint)seed), options))
            using (var mesh = tree.Build(null, parameters, options))
            {
                GetComponent<MeshFilter>().sharedMesh = ToMesh(mesh);
                GetComponent<MeshRenderer>().sharedMaterials = ToMaterials(mesh, shader);
            }
        }
    }

    /// <summary>All surfaces that have triangles as sub-meshes of one mesh, in Unity's axes.</summary>
    public static Mesh ToMesh(TreeMesh tree)
    {
        TreeSurface[] surfaces = Surfaces(tree);
        int count = 0;
        foreach (TreeSurface surface in surfaces)
        {
            count += surface.VertexCount;
        }
        var vertices = new Vector3[count];
        var normals = new Vector3[count];
        var uvs = new Vector2[count];
        var tangents = new Vector4[count];
        bool hasTangents = count > 0;
        var mesh = new Mesh
        {
            name = "botanical tree",
            // Before the indices: 16 bits end at vertex 65,535.
            indexFormat = count > 65535 ? IndexFormat.UInt32 : IndexFormat.UInt16
        };
        var starts = new int[surfaces.Length];
        int start = 0;
        for (int number = 0; number < surfaces.Length; number++)
        {
            TreeSurface surface = surfaces[number];
            surface.Convert(TreeNative.TREE_CONVENTION_UNITY);
            starts[number] = start;
            hasTangents &= surface.Tangents.Length > 0;
            for (int i = 0; i < surface.VertexCount; i++)
            {
                vertices[start + i] = Three(surface.Positions, i);
                normals[start + i] = Three(surface.Normals, i);
                uvs[start + i] = new Vector2(surface.Uvs[2 * i], surface.Uvs[2 * i + 1]);
                if (surface.Tangents.Length > 0)
                {
                    tangents[start + i] = new Vector4(
                        surface.Tangents[4 * i], surface.Tangents[4 * i + 1],
                        surface.Tangents[4 * i + 2], surface.Tangents[4 * i + 3]);
                }
            }
            start += surface.VertexCount;
        }
        mesh.vertices = vertices;
        mesh.normals = normals;
        mesh.uv = uvs;
        if (hasTangents)
        {
            mesh.tangents = tangents;
        }
        mesh.subMeshCount = surfaces.Length;
        for (int number = 0; number < surfaces.Length; number++)
        {
            int[] indices = surfaces[number].Indices;
            for (int i = 0; i < indices.Length; i++)
            {
                indices[i] += starts[number];
            }
            mesh.SetIndices(indices, MeshTopology.Triangles, number);
        }
        mesh.RecalculateBounds();
        return mesh;
    }

    /// <summary>A material for each sub-mesh. Names of properties are those of Standard and of URP's Lit.</summary>
    public static Material[] ToMaterials(TreeMesh tree, Shader shader)
    {
        TreeSurface[] surfaces = Surfaces(tree);
        var made = new Material[surfaces.Length];
        for (int number = 0; number < surfaces.Length; number++)
        {
            TreeMaterial from = tree.Material(surfaces[number].Material);
            var to = new Material(shader != null ? shader : DefaultShader()) { name = from.Name };
            // Unity takes material colours for sRGB.
            Color color = new Color(
                from.BaseColor[0], from.BaseColor[1], from.BaseColor[2], from.BaseColor[3]).gamma;
            Set(to, "_Color", "_BaseColor", name => to.SetColor(name, color));
            if (from.Pixels != null)
            {
                Texture2D picture = ToTexture(from);
                Set(to, "_MainTex", "_BaseMap", name => to.SetTexture(name, picture));
            }
            float smoothness = 1f - from.Roughness;
            Set(to, "_Glossiness", "_Smoothness", name => to.SetFloat(name, smoothness));
            if (from.AlphaCutoff > 0f)
            {
                to.SetFloat("_Cutoff", from.AlphaCutoff);
                Set(to, "_Mode", "_AlphaClip", name => to.SetFloat(name, 1f));
                to.EnableKeyword("_ALPHATEST_ON");
                to.renderQueue = (int)RenderQueue.AlphaTest;
            }
            if (from.DoubleSided)
            {
                Set(to, "_Cull", "_Cull", name => to.SetFloat(name, (float)CullMode.Off));
            }
            made[number] = to;
        }
        return made;
    }

    /// <summary>Unity's rows run from bottom to top.</summary>
    public static Texture2D ToTexture(TreeMaterial material)
    {
        int row = 4 * material.Width;
        var turned = new byte[material.Pixels.Length];
        for (int y = 0; y < material.Height; y++)
        {
            Buffer.BlockCopy(material.Pixels, y * row, turned, (material.Height - 1 - y) * row, row);
        }
        var texture = new Texture2D(
            material.Width, material.Height, TextureFormat.RGBA32, true, false)
        {
            name = material.Name,
            wrapMode = TextureWrapMode.Repeat
        };
        // Only the first level: Apply makes the smaller ones.
        texture.SetPixels32(Colors(turned));
        texture.Apply(true, false);
        return texture;
    }

    static Color32[] Colors(byte[] pixels)
    {
        var colors = new Color32[pixels.Length / 4];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = new Color32(
                pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2], pixels[4 * i + 3]);
        }
        return colors;
    }

    /// <summary>Those with triangles: leaf kinds that did not grow are empty.</summary>
    static TreeSurface[] Surfaces(TreeMesh tree)
    {
        var all = new TreeSurface[tree.SurfaceCount];
        for (int number = 0; number < all.Length; number++)
        {
            all[number] = tree.Surface(number);
        }
        return Array.FindAll(all, surface => surface.Indices.Length > 0);
    }

    static Vector3 Three(float[] column, int row)
    {
        return new Vector3(column[3 * row], column[3 * row + 1], column[3 * row + 2]);
    }

    static Shader DefaultShader()
    {
        Shader lit = Shader.Find("Universal Render Pipeline/Lit");
        return lit != null && GraphicsSettings.defaultRenderPipeline != null
            ? lit
            : Shader.Find("Standard");
    }

    static void Set(Material material, string standard, string lit, Action<string> set)
    {
        if (material.HasProperty(lit))
        {
            set(lit);
        }
        else if (material.HasProperty(standard))
        {
            set(standard);
        }
    }
}
#endif
