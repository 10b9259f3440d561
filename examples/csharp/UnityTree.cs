// A tree in Unity: add the component to a GameObject, choose preset and seed. Compiled by Unity only.
#if UNITY_5_3_OR_NEWER
using System.Collections.Generic;
using UnityEngine;
using TreeFamily;
using TreeFamily.Native;

/// <summary>
/// Grows a tree and draws it, bark and leaf kinds as sub-meshes. Mesh, materials and textures are its own,
/// are not stored in scenes, and go when it goes.
/// </summary>
[ExecuteAlways, RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
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

    // Unity frees these only when asked to. Not serialized: a copy of the component makes its own.
    readonly List<Object> made = new List<Object>();

    void OnEnable()
    {
        if (made.Count == 0)
        {
            Rebuild();
        }
    }

    void OnDisable()
    {
        // In the editor also before scripts are loaded anew, which forgets `made`.
        if (!Application.isPlaying)
        {
            Clear();
        }
    }

    void OnDestroy()
    {
        Clear();
    }

    /// <summary>Grows the tree anew. After an exception the old one is still there.</summary>
    [ContextMenu("Rebuild")]
    public void Rebuild()
    {
        var fresh = new List<Object>();
        Mesh filled;
        Material[] materials;
        try
        {
            Grow(fresh, out filled, out materials);
        }
        catch
        {
            Free(fresh);
            throw;
        }
        Clear();
        made.AddRange(fresh);
        foreach (Object part in made)
        {
            part.hideFlags = HideFlags.DontSave;
        }
        GetComponent<MeshFilter>().sharedMesh = filled;
        GetComponent<MeshRenderer>().sharedMaterials = materials;
    }

    void Grow(List<Object> fresh, out Mesh filled, out Material[] materials)
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
                Shader chosen = shader != null ? shader : UnityTreeMaterials.DefaultShader();
                materials = UnityTreeMaterials.Make(mesh, chosen, fresh);
                filled = UnityTreeMesh.Make(mesh, !UnityTreeMaterials.DrawsBackFaces(chosen));
                fresh.Add(filled);
            }
        }
    }

    void Clear()
    {
        if (made.Count == 0)
        {
            return;
        }
        // Either may be gone already when the whole GameObject goes.
        var filter = GetComponent<MeshFilter>();
        if (filter != null)
        {
            filter.sharedMesh = null;
        }
        var renderer = GetComponent<MeshRenderer>();
        if (renderer != null)
        {
            renderer.sharedMaterials = new Material[0];
        }
        Free(made);
    }

    static void Free(List<Object> objects)
    {
        foreach (Object part in objects)
        {
            if (Application.isPlaying)
            {
                Destroy(part);
            }
            else
            {
                // Destroy waits for a frame, which the editor does not have.
                DestroyImmediate(part);
            }
        }
        objects.Clear();
    }
}
#endif
