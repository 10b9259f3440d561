// The wrappers from another assembly, as a game's scripts see them: everything here must be public.
using System;
using System.IO;
using System.Linq;
using System.Text;
using TreeFamily;
using TreeFamily.Native;

public static unsafe class WholeCheck
{
    public static int Main(string[] arguments)
    {
        using (var bare = BotanicalTree.FromColumns(Fork()))
        {
            Columns(bare);
            using (var twigs = bare.GrowTwigs(3, Twigs()))
            using (var leafy = twigs.GrowLeaves(4))
            using (var mesh = leafy.Build())
            {
                Demand(Nodes(twigs) > Nodes(bare), "twigs");
                Demand(Nodes(leafy) == Nodes(twigs) && leafy.Columns().LeafSizes.Length > 5, "leaves");
                Files(mesh, arguments[0]);
                Packed(mesh);
                Skeletonized(mesh);
                using (var welded = Weld(mesh))
                {
                    Demand(welded.Surface(0).VertexCount < mesh.Surface(0).VertexCount, "welded");
                }
            }
            Own(bare);
        }
        Refused();
        Demand(TreeLibrary.LiveObjects == 0, TreeLibrary.LiveObjects + " objects are left");
        Console.WriteLine("whole check passed");
        return 0;
    }

    /// <summary>A trunk of two segments, forked, with one leaf.</summary>
    static TreeColumns Fork()
    {
        return new TreeColumns
        {
            Positions = new float[] { 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.5f, 2.6f, 0, -0.5f, 2.6f, 0.1f },
            Radii = new[] { 0.1f, 0.08f, 0.06f, 0.02f, 0.02f },
            Parents = new uint[] { TreeColumns.NoParent, 0, 1, 2, 2 },
            LeafNodes = new uint[] { 3 },
            LeafPositions = new[] { 0.5f, 2.6f, 0 },
            LeafRotations = new float[] { 0, 0, 0, 1 },
            LeafSizes = new[] { 0.1f },
            LeafKinds = new ushort[] { 1 },
            Species = "Bäumchen",
            Bark = "birch",
            LeafKindNames = new[] { "oak", "birch" }
        };
    }

    static void Columns(BotanicalTree tree)
    {
        TreeColumns from = Fork(), back = tree.Columns();
        Demand(back.Positions.SequenceEqual(from.Positions), "positions come back");
        Demand(back.Radii.SequenceEqual(from.Radii), "radii come back");
        Demand(back.Parents.SequenceEqual(from.Parents), "parents come back");
        Demand(back.LeafNodes.SequenceEqual(from.LeafNodes), "leaves come back");
        Demand(back.LeafPositions.SequenceEqual(from.LeafPositions), "their places come back");
        Demand(back.LeafRotations.SequenceEqual(from.LeafRotations), "how they are turned comes back");
        Demand(back.LeafSizes.SequenceEqual(from.LeafSizes), "their sizes come back");
        Demand(back.LeafKinds.SequenceEqual(from.LeafKinds), "their kinds come back");
        Demand(back.Species == "Bäumchen" && back.Bark == "birch", "names come back");
        Demand(back.LeafKindNames.SequenceEqual(from.LeafKindNames), "names of kinds come back");

        from.Species = null;
        from.LeafKinds[0] = 0;
        using (var oak = BotanicalTree.FromColumns(from))
        {
            Demand(oak.Columns().Bark == "oak", "without a species it is an oak");
        }
    }

    static tree_twig_params Twigs()
    {
        tree_leaf_params leaves;
        tree_twig_params twigs;
        Demand(TreeDefaults.Foliage("oak", out leaves, out twigs).Length > 0, "a leaf kind's name");
        Demand(leaves.size > 0f && twigs.length > 0f, "a species' own parameters");
        twigs.levels = 1;
        return twigs;
    }

    static void Files(TreeMesh mesh, string folder)
    {
        string path = Path.Combine(folder, "Bäumchen.glb");
        tree_glb_options options = TreeDefaults.Glb;
        options.quantize = 1;
        mesh.WriteGlb(path, options);
        Demand(File.ReadAllBytes(path).SequenceEqual(mesh.ToGlb(options)), "one file on disk and in memory");
        byte[] plain = mesh.ToGlb();
        Demand(Encoding.ASCII.GetString(plain, 0, 4) == "glTF", "a GLB's magic");
        File.WriteAllBytes(path, plain);
        using (var read = TreeMesh.Read(path))
        {
            Demand(read.Surface(0).Indices.Length == mesh.Surface(0).Indices.Length, "triangles come back");
            float[] box = mesh.Bounds();
            Demand(read.Bounds().Select((x, i) => Math.Abs(x - box[i])).Max() < 1e-5, "where they were");
        }

        tree_view view = TreeDefaults.View;
        view.width = view.height = 32;
        tree_style style = TreeDefaults.Style;
        style.sky_directions = 0;
        byte[] png = mesh.RenderPng(view, style);
        Demand(png[0] == 0x89 && Encoding.ASCII.GetString(png, 1, 3) == "PNG", "a picture");
        Demand(png[19] == 32 && png[23] == 32, "of the size asked for");
    }

    static void Packed(TreeMesh mesh)
    {
        TreeSurface ours = mesh.Surface(0);
        TreePacked packed = mesh.Pack(0, TreeNative.TREE_LAYOUT_GODOT);
        Demand(packed.VertexCount == ours.VertexCount && packed.Streams.Length > 5, "streams");
        Demand(packed.Convention == TreeNative.TREE_CONVENTION_GODOT, "in Godot's axes");
        TreeStream positions = packed.Stream("POSITION");
        Demand(positions.Components == 3 && positions.Floats().SequenceEqual(ours.Positions), "positions");
        Demand(packed.Indices.Length == packed.IndexBytes * ours.Indices.Length, "indices");
        Demand(BitConverter.ToUInt16(packed.Indices, packed.IndexBytes) == ours.Indices[2], "turned");
        Demand(packed.Stream("SIDEWAYS") == null, "no such stream");
        TreeStream half = mesh.Pack(0, TreeNative.TREE_LAYOUT_GODOT_HALF).Stream("CUSTOM0");
        Demand(half.Number == TreeNative.TREE_NUMBER_F16, "halves");
        Throws<InvalidOperationException>(() => half.Floats(), "which are no floats");
    }

    static void Skeletonized(TreeMesh mesh)
    {
        tree_skeletonize_params parameters = TreeDefaults.Skeletonize;
        parameters.leaves = 0;
        using (var tree = BotanicalTree.Skeletonize(mesh, parameters))
        {
            TreeColumns columns = tree.Columns();
            Demand(columns.LeafSizes.Length == 0 && columns.Radii.Length > 4, "wood alone");
            Demand(Math.Abs(columns.Positions[1]) < 0.1f, "that begins at the foot");
        }
    }

    /// <summary>A call that is not wrapped, as the README has it.</summary>
    static TreeMesh Weld(TreeMesh mesh)
    {
        using (var call = new NativeCall())
        {
            tree_mesh* made;
            call.Check(TreeNative.tree_mesh_weld(
                (tree_mesh*)call.Use(mesh), UIntPtr.Zero, call.Control, &made));
            return new TreeMesh(made);
        }
    }

    /// <summary>The same with progress, and a view.</summary>
    static void Own(BotanicalTree tree)
    {
        using (var call = new NativeCall(new CallOptions { Progress = (stage, share) => true }))
        using (var grown = Grown(call, tree))
        {
            tree_foliage foliage;
            foliage.struct_size = (UIntPtr)sizeof(tree_foliage);
            call.Check(TreeNative.tree_tree_foliage((tree_tree*)call.Use(grown), &foliage));
            Demand((int)foliage.n_leaves > 0, "leaves of a call of one's own");
        }
    }

    static BotanicalTree Grown(NativeCall call, BotanicalTree tree)
    {
        tree_tree* made;
        call.Check(TreeNative.tree_tree_grow_leaves(
            (tree_tree*)call.Use(tree), null, IntPtr.Zero, null, 1, 5, call.Control, null, &made));
        return new BotanicalTree(made);
    }

    static void Refused()
    {
        TreeColumns shorter = Fork();
        shorter.Radii = new float[4];
        Throws<ArgumentException>(() => BotanicalTree.FromColumns(shorter), "a column that is too short");
        shorter = Fork();
        shorter.LeafKinds = null;
        Throws<ArgumentException>(() => BotanicalTree.FromColumns(shorter), "a column that is not there");
        TreeColumns wrong = Fork();
        wrong.Parents[1] = 4;
        Throws<TreeException>(() => BotanicalTree.FromColumns(wrong), "a parent after its child");
        Throws<TreeException>(() => TreeMesh.Read("/nowhere/tree.glb"), "a file that is not there");
        Throws<ArgumentException>(() => TreeMesh.Read("tree.glb\0.png"), "a NUL in a path");
        Throws<ArgumentNullException>(() => BotanicalTree.Grow((string)null, 1), "no name");
    }

    static int Nodes(BotanicalTree tree)
    {
        return tree.Columns().Radii.Length;
    }

    static void Throws<T>(Action action, string what) where T : Exception
    {
        try
        {
            action();
        }
        catch (T)
        {
            return;
        }
        Demand(false, what + " is an error");
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
