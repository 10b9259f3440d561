// Surfaces in the layout of an engine's vertex buffers, copied.
using System;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>An attribute of all vertices.</summary>
    public sealed unsafe class TreeStream
    {
        /// <summary>The engine's name for it.</summary>
        public readonly string Name;
        /// <summary>Numbers of one vertex, 1 to 4.</summary>
        public readonly int Components;
        /// <summary>What the numbers are: TreeNative.TREE_NUMBER_.</summary>
        public readonly int Number;
        /// <summary>
        /// The numbers of one vertex after the other, tightly packed, in the machine's order of bytes.
        /// </summary>
        public readonly byte[] Bytes;

        internal TreeStream(tree_stream view)
        {
            Name = NativeText.Read(view.name);
            Components = (int)view.components;
            Number = (int)view.number;
            Bytes = NativeText.Bytes(view.data, view.n_bytes);
        }

        /// <summary>The bytes as floats; for TREE_NUMBER_F32 only.</summary>
        public float[] Floats()
        {
            if (Number != TreeNative.TREE_NUMBER_F32)
            {
                throw new InvalidOperationException("The numbers of " + Name + " are not floats.");
            }
            var floats = new float[Bytes.Length / sizeof(float)];
            Buffer.BlockCopy(Bytes, 0, floats, 0, Bytes.Length);
            return floats;
        }
    }

    /// <summary>
    /// A surface in an engine's layout. TREE_LAYOUT_VERTEX has no streams: its vertices are had with
    /// TreeNative.tree_packed_vertices_view.
    /// </summary>
    public sealed unsafe class TreePacked
    {
        /// <summary>Whose axes the numbers are in: TreeNative.TREE_CONVENTION_.</summary>
        public readonly int Convention;
        /// <summary>Number of vertices.</summary>
        public readonly int VertexCount;
        /// <summary>The attributes.</summary>
        public readonly TreeStream[] Streams;
        /// <summary>Bytes of one index, 2 or 4.</summary>
        public readonly int IndexBytes;
        /// <summary>Three indices for each triangle, wound as the engine has its front faces.</summary>
        public readonly byte[] Indices;
        /// <summary>TREE_LAYOUT_SPEEDTREE9: `_ST_BranchStretchLimits`; else 0.</summary>
        public readonly float[] StretchLimits;

        internal TreePacked(NativeCall call, tree_packed* packed)
        {
            var view = new tree_packed_columns
            {
                struct_size = (UIntPtr)sizeof(tree_packed_columns)
            };
            call.Check(TreeNative.tree_packed_view(packed, &view));
            Convention = (int)view.convention;
            VertexCount = checked((int)view.n_vertices);
            Streams = new TreeStream[checked((int)view.n_streams)];
            for (int stream = 0; stream < Streams.Length; stream++)
            {
                Streams[stream] = new TreeStream(view.streams[stream]);
            }
            IndexBytes = (int)view.index_bytes;
            Indices = NativeText.Bytes(
                view.indices, (UIntPtr)checked((ulong)view.n_indices * view.index_bytes));
            StretchLimits = new[] { view.stretch_limits[0], view.stretch_limits[1] };
        }

        /// <summary>The stream of this name; null where the layout has none.</summary>
        public TreeStream Stream(string name)
        {
            return Array.Find(Streams, stream => stream.Name == name);
        }
    }
}
