// The oak in C#: what the library's own tests hold against Rust's numbers.
using System;
using System.IO;
using System.Text;
using System.Threading;
using TreeFamily;
using TreeFamily.Native;

public static class Oak
{
    const int Cycles = 200;

    public static int Main()
    {
        long before = TreeLibrary.LiveObjects;
        using (var tree = BotanicalTree.Grow("oak", 1))
        using (var mesh = tree.Build())
        {
            Print(mesh);
        }
        Errors();
        // In a thread of its own, so that no reference lingers on a stack.
        var cycles = new Thread(CreateAndFree);
        cycles.Start();
        cycles.Join();
        for (int tries = 0; tries < 50 && TreeLibrary.LiveObjects > before; tries++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            Thread.Sleep(20);
        }
        Demand(TreeLibrary.LiveObjects == before, TreeLibrary.LiveObjects + " objects are left");
        Console.WriteLine("done");
        return 0;
    }

    static void Print(TreeMesh mesh)
    {
        ulong positions = Fnv.Start, indices = Fnv.Start;
        Console.WriteLine("oak seed 1");
        for (int number = 0; number < mesh.SurfaceCount; number++)
        {
            TreeSurface surface = mesh.Surface(number);
            positions = Fnv.Of(positions, surface.Positions);
            indices = Fnv.Of(indices, surface.Indices);
            TreeMaterial material = mesh.Material(surface.Material);
            Console.WriteLine(
                "surface {0}: {1} vertices, {2} indices, material {3} with {4} x {5} pixels", number,
                surface.VertexCount, surface.Indices.Length, material.Name, material.Width,
                material.Height);
        }
        Console.WriteLine("positions {0:x16} indices {1:x16}", positions, indices);
    }

    static void Errors()
    {
        try
        {
            BotanicalTree.Grow("yggdrasil", 1).Dispose();
            Demand(false, "a preset that is none is an error");
        }
        catch (TreeException error)
        {
            Demand(error.Status == TreeNative.TREE_ERROR_UNKNOWN_NAME, "its code");
            Demand(error.Message.Contains("yggdrasil"), "its text");
            Console.WriteLine("error {0}: {1}", error.Status, error.Message);
        }

        var options = new CallOptions { Progress = (stage, share) => stage.Length == 0 };
        Cancelled(options, "progress that says no");
        options.Progress = (stage, share) => { throw new InvalidDataException("thrown in progress"); };
        try
        {
            BotanicalTree.Grow("oak", 1, options).Dispose();
            Demand(false, "progress that throws cancels");
        }
        catch (InvalidDataException error)
        {
            Demand(error.Message == "thrown in progress", "what progress threw comes out");
            Demand(error.StackTrace.Contains("Oak"), "with the place where it was thrown");
        }
        Cancelled(
            new CallOptions { Cancellation = new CancellationToken(true) }, "a cancelled token");

        var limits = TreeDefaults.Limits;
        limits.nodes = 10;
        try
        {
            BotanicalTree.Grow("oak", 1, new CallOptions { Limits = limits }).Dispose();
            Demand(false, "ten nodes are too few");
        }
        catch (TreeException error)
        {
            Demand(error.Status == TreeNative.TREE_ERROR_LIMIT, "the limit's code");
        }

        var gone = BotanicalTree.Grow("oak", 1);
        gone.Dispose();
        try
        {
            gone.Build();
            Demand(false, "a tree that was disposed of is an error");
        }
        catch (ObjectDisposedException)
        {
        }
    }

    static void Cancelled(CallOptions options, string how)
    {
        try
        {
            BotanicalTree.Grow("oak", 1, options).Dispose();
        }
        catch (OperationCanceledException)
        {
            return;
        }
        Demand(false, how + " cancels");
    }

    /// <summary>Trees small enough that two hundred take seconds.</summary>
    static void CreateAndFree()
    {
        tree_path_params parameters = TreeDefaults.Path("oak");
        parameters.n_levels = UIntPtr.Zero;
        tree_mesh_params coarse = TreeDefaults.Mesh;
        coarse.max_sides = 4;
        int calls = 0;
        using (var pool = new TreePool(2))
        {
            var options = new CallOptions
            {
                Pool = pool,
                Progress = (stage, share) => { Interlocked.Increment(ref calls); return true; }
            };
            TreeLook look = null;
            for (int cycle = 0; cycle < Cycles; cycle++)
            {
                var tree = BotanicalTree.Grow(parameters, (ulong)cycle, options);
                look = look ?? TreeLook.Of(tree, true);
                var mesh = tree.Build(look, coarse, options);
                Demand(mesh.Surface(0).VertexCount > 0, "bark");
                // Some end by Dispose, some are left to the collector.
                if (cycle % 2 == 0)
                {
                    mesh.Dispose();
                    tree.Dispose();
                }
            }
            look.Dispose();
        }
        Demand(calls >= Cycles, "progress is told");
        Console.WriteLine("{0} cycles", Cycles);
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

/// <summary>FNV-1a, 64 bits, over the bytes of arrays.</summary>
static class Fnv
{
    public const ulong Start = 0xcbf29ce484222325;

    public static ulong Of(ulong hash, Array numbers)
    {
        var bytes = new byte[Buffer.ByteLength(numbers)];
        Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
        foreach (byte part in bytes)
        {
            hash = unchecked((hash ^ part) * 0x100000001b3);
        }
        return hash;
    }
}
