// UnityTree.cs against FakeUnity.cs: is what Unity would be handed right?
using System;
using System.Linq;
using TreeFamily;
using UnityEngine;

public static class UnityCheck
{
    public static int Main()
    {
        var unity = new UnityTree();
        unity.Rebuild();
        Mesh mesh = unity.GetComponent<MeshFilter>().sharedMesh;
        Material[] materials = unity.GetComponent<MeshRenderer>().sharedMaterials;

        using (var tree = BotanicalTree.Grow("oak", 1))
        using (var ours = tree.Build())
        {
            var bark = ours.Surface(0);
            var leaves = ours.Surface(1);
            int n = bark.VertexCount;
            Demand(mesh.vertices.Length == n + leaves.VertexCount, "vertices of both");
            Demand(mesh.tangents != null && mesh.tangents.All(t => Math.Abs(t.w) == 1f), "tangents");
            Demand(mesh.HasBounds && mesh.subMeshCount == 2 && materials.Length == 2, "two parts");
            Demand(mesh.indexFormat == UnityEngine.Rendering.IndexFormat.UInt32, "wide indices");
            for (int i = 0; i < n; i += 97)
            {
                Vector3 v = mesh.vertices[i];
                Demand(v.x == -bark.Positions[3 * i] && v.y == bark.Positions[3 * i + 1]
                    && v.z == bark.Positions[3 * i + 2], "x is turned over");
                Demand(mesh.uv[i].y == 1f - bark.Uvs[2 * i + 1], "v runs upwards");
            }
            int[] first = mesh.Indices[1];
            Demand(first.Length == leaves.Indices.Length, "indices of the leaves");
            Demand(first[0] == n + leaves.Indices[0] && first[1] == n + leaves.Indices[2]
                && first[2] == n + leaves.Indices[1], "triangles are turned, and follow the bark");
            Demand(first.Max() == mesh.vertices.Length - 1, "the last vertex is used");

            var picture = (Texture2D)materials[1].Set["_MainTex"];
            var from = ours.Material(1);
            Color32 last = picture.Pixels[picture.Pixels.Length - picture.width];
            Demand(last.r == from.Pixels[0] && last.a == from.Pixels[3], "rows from bottom to top");
            Demand((float)materials[1].Set["_Cutoff"] > 0f, "leaves are cut out");
            Demand(!materials[0].Set.ContainsKey("_Cutoff"), "bark is not");
        }
        Demand(TreeLibrary.LiveObjects == 0, "nothing is left alive");
        Console.WriteLine("unity check passed");
        return 0;
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
