// From the library's columns to Unity's mesh. Compiled by Unity only.
#if UNITY_5_3_OR_NEWER
using System;
using UnityEngine;
using UnityEngine.Rendering;
using TreeFamily;
using TreeFamily.Native;

/// <summary>All surfaces that have triangles as sub-meshes of one mesh, in Unity's axes.</summary>
public sealed class UnityTreeMesh
{
    readonly Vector3[] vertices;
    readonly Vector3[] normals;
    readonly Vector2[] uvs;
    readonly Vector4[] tangents;
    readonly int[][] triangles;
    bool hasTangents = true;
    int filled;

    /// <summary>
    /// A mesh, which is the caller's to destroy. With `backFaces`, for shaders that draw one side only,
    /// double-sided surfaces have all triangles a second time, turned over.
    /// </summary>
    public static Mesh Make(TreeMesh tree, bool backFaces)
    {
        TreeSurface[] surfaces = Surfaces(tree);
        var twice = new bool[surfaces.Length];
        int count = 0;
        for (int number = 0; number < surfaces.Length; number++)
        {
            twice[number] = backFaces && tree.Material(surfaces[number].Material).DoubleSided;
            count += surfaces[number].VertexCount * (twice[number] ? 2 : 1);
        }
        var made = new UnityTreeMesh(count, surfaces.Length);
        for (int number = 0; number < surfaces.Length; number++)
        {
            surfaces[number].Convert(TreeNative.TREE_CONVENTION_UNITY);
            made.Add(number, surfaces[number], twice[number]);
        }
        return made.ToMesh();
    }

    /// <summary>Those with triangles: leaf kinds that did not grow are empty.</summary>
    public static TreeSurface[] Surfaces(TreeMesh tree)
    {
        var all = new TreeSurface[tree.SurfaceCount];
        for (int number = 0; number < all.Length; number++)
        {
            all[number] = tree.Surface(number);
        }
        return Array.FindAll(all, surface => surface.Indices.Length > 0);
    }

    UnityTreeMesh(int count, int surfaces)
    {
        vertices = new Vector3[count];
        normals = new Vector3[count];
        uvs = new Vector2[count];
        tangents = new Vector4[count];
        triangles = new int[surfaces][];
    }

    void Add(int number, TreeSurface surface, bool twice)
    {
        int[] front = surface.Indices;
        triangles[number] = new int[front.Length * (twice ? 2 : 1)];
        for (int i = 0; i < front.Length; i++)
        {
            triangles[number][i] = filled + front[i];
        }
        AddVertices(surface, 1f);
        for (int i = 0; twice && i < front.Length; i += 3)
        {
            triangles[number][front.Length + i] = filled + front[i];
            triangles[number][front.Length + i + 1] = filled + front[i + 2];
            triangles[number][front.Length + i + 2] = filled + front[i + 1];
        }
        if (twice)
        {
            AddVertices(surface, -1f);
        }
    }

    /// <summary>`side` is 1 for the front and -1 for the back, where the bitangent stays as it was.</summary>
    void AddVertices(TreeSurface surface, float side)
    {
        bool tangential = surface.Tangents.Length > 0;
        hasTangents &= tangential;
        for (int i = 0; i < surface.VertexCount; i++, filled++)
        {
            vertices[filled] = Three(surface.Positions, i, 1f);
            normals[filled] = Three(surface.Normals, i, side);
            uvs[filled] = new Vector2(surface.Uvs[2 * i], surface.Uvs[2 * i + 1]);
            if (tangential)
            {
                tangents[filled] = new Vector4(
                    surface.Tangents[4 * i], surface.Tangents[4 * i + 1],
                    surface.Tangents[4 * i + 2], side * surface.Tangents[4 * i + 3]);
            }
        }
    }

    Mesh ToMesh()
    {
        var mesh = new Mesh
        {
            name = "botanical tree",
            // Before the indices: 16 bits end at vertex 65,535.
            indexFormat = filled > 65535 ? IndexFormat.UInt32 : IndexFormat.UInt16
        };
        mesh.vertices = vertices;
        mesh.normals = normals;
        mesh.uv = uvs;
        if (hasTangents)
        {
            mesh.tangents = tangents;
        }
        mesh.subMeshCount = triangles.Length;
        for (int number = 0; number < triangles.Length; number++)
        {
            mesh.SetIndices(triangles[number], MeshTopology.Triangles, number);
        }
        mesh.RecalculateBounds();
        return mesh;
    }

    static Vector3 Three(float[] column, int row, float factor)
    {
        return new Vector3(
            factor * column[3 * row], factor * column[3 * row + 1], factor * column[3 * row + 2]);
    }
}
#endif
