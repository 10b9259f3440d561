// UnityTree.cs against FakeUnity.cs: is what Unity would be handed right, and is it taken back?
using System;
using System.Linq;
using System.Reflection;
using TreeFamily;
using UnityEngine;
using UnityEngine.Rendering;

public static class UnityCheck
{
    public static int Main()
    {
        using (var tree = BotanicalTree.Grow("oak", 1))
        using (var ours = tree.Build())
        {
            foreach (string pipeline in new[] { "Standard", "Universal Render Pipeline/Lit", "HDRP/Lit" })
            {
                Drawn(pipeline, ours);
            }
        }
        GraphicsSettings.currentRenderPipeline = null;
        Life();
        Demand(TreeLibrary.LiveObjects == 0, "nothing is left alive");
        Console.WriteLine("unity check passed");
        return 0;
    }

    static void Drawn(string pipeline, TreeMesh ours)
    {
        bool standard = pipeline == "Standard";
        bool high = pipeline == "HDRP/Lit";
        GraphicsSettings.currentRenderPipeline =
            standard ? null : high
            ? new HDRenderPipelineAsset()
            : (RenderPipelineAsset)new UniversalRenderPipelineAsset();
        var unity = new UnityTree();
        unity.Rebuild();
        Mesh mesh = unity.GetComponent<MeshFilter>().sharedMesh;
        Material[] materials = unity.GetComponent<MeshRenderer>().sharedMaterials;
        Demand(materials.Length == 2, "two materials");
        Demand(materials.All(material => material.shader.name == pipeline), "of " + pipeline);
        // Standard draws front faces only: leaves are there twice.
        Columns(mesh, ours, standard);
        Leaf(materials[1], ours.Material(1),
            high ? "_BaseColorMap" : standard ? "_MainTex" : "_BaseMap",
            high ? "_AlphaCutoff" : "_Cutoff");
        Demand(!materials[0].Set.ContainsKey("_Cutoff"), "bark is not cut out");
        Demand(!standard || !materials[1].Set.ContainsKey("_Cull"), "Standard has no _Cull");
        if (!standard)
        {
            string cull = high ? "_CullMode" : "_Cull";
            Demand((float)materials[1].Set[cull] == 0f, "both sides of leaves are drawn");
            Demand(!materials[0].Set.ContainsKey(cull), "and the outer side of bark");
        }
        Tell(unity, "OnDestroy");
        Demand(UnityEngine.Object.Alive.Count == 0, "nothing is left to Unity");
    }

    static void Columns(Mesh mesh, TreeMesh ours, bool twice)
    {
        TreeSurface bark = ours.Surface(0), leaves = ours.Surface(1);
        int n = bark.VertexCount, m = leaves.VertexCount;
        Demand(mesh.vertices.Length == n + (twice ? 2 * m : m), "vertices of both");
        Demand(mesh.tangents != null && mesh.tangents.All(t => Math.Abs(t.w) == 1f), "tangents");
        Demand(mesh.HasBounds && mesh.subMeshCount == 2, "two parts");
        Demand(mesh.indexFormat == IndexFormat.UInt32, "wide indices");
        for (int i = 0; i < n; i += 97)
        {
            Vector3 v = mesh.vertices[i];
            Demand(v.x == -bark.Positions[3 * i] && v.y == bark.Positions[3 * i + 1]
                && v.z == bark.Positions[3 * i + 2], "x is turned over");
            Demand(mesh.uv[i].y == 1f - bark.Uvs[2 * i + 1], "v runs upwards");
        }
        int[] first = mesh.Indices[1];
        int count = leaves.Indices.Length;
        Demand(first.Length == (twice ? 2 * count : count), "indices of the leaves");
        Demand(first[0] == n + leaves.Indices[0] && first[1] == n + leaves.Indices[2]
            && first[2] == n + leaves.Indices[1], "triangles are turned, and follow the bark");
        Demand(first.Max() == mesh.vertices.Length - 1, "the last vertex is used");
        for (int i = 0; twice && i < count; i += 3 * 97)
        {
            int front = first[i], back = first[count + i];
            Demand(back == front + m && first[count + i + 1] == first[i + 2] + m
                && first[count + i + 2] == first[i + 1] + m, "back faces are turned over");
            Vector3 up = mesh.normals[front], down = mesh.normals[back];
            Demand(up.x == -down.x && up.y == -down.y && up.z == -down.z, "with their normals");
            Demand(mesh.tangents[front].x == mesh.tangents[back].x
                && mesh.tangents[front].w == -mesh.tangents[back].w, "and the same bitangent");
            Demand(mesh.vertices[front].x == mesh.vertices[back].x
                && mesh.uv[front].x == mesh.uv[back].x, "in the same place");
        }
    }

    static void Leaf(Material material, TreeMaterial from, string picture, string cutoff)
    {
        var texture = (Texture2D)material.Set[picture];
        Color32 last = texture.Pixels[texture.Pixels.Length - texture.width];
        Demand(last.r == from.Pixels[0] && last.a == from.Pixels[3], "rows from bottom to top");
        Color32 second = texture.Pixels[texture.Pixels.Length - texture.width + 1];
        Demand(second.g == from.Pixels[5], "pixels from left to right");
        Demand((float)material.Set[cutoff] > 0f, "leaves are cut out");
    }

    static void Life()
    {
        foreach (bool playing in new[] { true, false })
        {
            Application.isPlaying = playing;
            var unity = new UnityTree();
            Tell(unity, "OnEnable");
            var first = UnityEngine.Object.Alive.ToArray();
            Demand(first.Length == 5, "a mesh, two materials, two textures");
            Demand(first.All(made => made.hideFlags == HideFlags.DontSave), "that scenes do not store");
            unity.Rebuild();
            var second = UnityEngine.Object.Alive.ToArray();
            Demand(second.Length == 5 && !first.Intersect(second).Any(), "the last ones are destroyed");

            unity.preset = "yggdrasil";
            try
            {
                unity.Rebuild();
                Demand(false, "no such preset");
            }
            catch (TreeException)
            {
            }
            Demand(UnityEngine.Object.Alive.SetEquals(second), "after an error the old tree is there");

            unity.preset = "oak";
            Tell(unity, "OnDisable");
            Demand(UnityEngine.Object.Alive.Count == (playing ? 5 : 0), "the editor may reload scripts");
            Tell(unity, "OnEnable");
            Demand(UnityEngine.Object.Alive.Count == 5, "it is there again");
            Tell(unity, "OnDestroy");
            Demand(UnityEngine.Object.Alive.Count == 0, "nothing is left");
            Demand(unity.GetComponent<MeshFilter>().sharedMesh == null, "nor asked for");
        }
    }

    /// <summary>As Unity calls its messages.</summary>
    static void Tell(UnityTree unity, string message)
    {
        const BindingFlags own = BindingFlags.Instance | BindingFlags.NonPublic;
        typeof(UnityTree).GetMethod(message, own).Invoke(unity, null);
    }

    static void Demand(bool holds, string what)
    {
        if (!holds)
        {
            Console.WriteLine("does not hold: " + what);
            Environment.Exit(1);
        }
    }
}
