// Trees of one's own: skeleton and leaves as C# arrays.
using System;
using System.Runtime.InteropServices;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>
    /// A skeleton, a row for each node, and leaves, a row for each blade; metres, +Y up. To make a tree of,
    /// or a copy of a tree's.
    /// </summary>
    public sealed unsafe class TreeColumns
    {
        /// <summary>What Parents has for the root, which is node 0.</summary>
        public const uint NoParent = TreeNative.TREE_NO_PARENT;

        /// <summary>Three for each node.</summary>
        public float[] Positions;
        /// <summary>Radius of the wood, for each node.</summary>
        public float[] Radii;
        /// <summary>The node that each node stands on; it comes before.</summary>
        public uint[] Parents;

        /// <summary>The node that bears each leaf.</summary>
        public uint[] LeafNodes = new uint[0];
        /// <summary>Three for each leaf: the base of the blade.</summary>
        public float[] LeafPositions = new float[0];
        /// <summary>
        /// Four for each leaf: the quaternion x, y, z, w that turns the leaf's own frame, midrib along +Y and
        /// upper face to +Z, into the tree's.
        /// </summary>
        public float[] LeafRotations = new float[0];
        /// <summary>Length from base to apex, for each leaf.</summary>
        public float[] LeafSizes = new float[0];
        /// <summary>The kind of each leaf: an index into LeafKindNames.</summary>
        public ushort[] LeafKinds = new ushort[0];

        /// <summary>Name of the species; null makes it an oak, with the oak's bark and leaves.</summary>
        public string Species;
        /// <summary>Name of the bark.</summary>
        public string Bark;
        /// <summary>Names of the leaf kinds.</summary>
        public string[] LeafKindNames = new string[0];

        /// <summary>No node and no leaf; an oak.</summary>
        public TreeColumns() { }

        internal TreeColumns(NativeCall call, tree_tree* tree)
        {
            tree_skeleton* skeleton;
            call.Check(TreeNative.tree_tree_skeleton(tree, &skeleton));
            try
            {
                var columns = new tree_skeleton_columns
                {
                    struct_size = (UIntPtr)sizeof(tree_skeleton_columns)
                };
                call.Check(TreeNative.tree_skeleton_view(skeleton, &columns));
                int nodes = checked((int)columns.n_nodes);
                Positions = Copy<float>(columns.positions, 3, nodes);
                Radii = Copy<float>(columns.radii, 1, nodes);
                Parents = Copy<uint>(columns.parents, 1, nodes);
            }
            finally
            {
                TreeNative.tree_skeleton_free(skeleton);
            }
            var foliage = new tree_foliage { struct_size = (UIntPtr)sizeof(tree_foliage) };
            call.Check(TreeNative.tree_tree_foliage(tree, &foliage));
            int leaves = checked((int)foliage.n_leaves);
            LeafNodes = Copy<uint>(foliage.nodes, 1, leaves);
            LeafPositions = Copy<float>(foliage.positions, 3, leaves);
            LeafRotations = Copy<float>(foliage.rotations, 4, leaves);
            LeafSizes = Copy<float>(foliage.sizes, 1, leaves);
            LeafKinds = Copy<ushort>(foliage.kinds, 1, leaves);
            ReadSpecies(call, tree);
        }

        void ReadSpecies(NativeCall call, tree_tree* tree)
        {
            var species = new tree_species { struct_size = (UIntPtr)sizeof(tree_species) };
            call.Check(TreeNative.tree_tree_species(tree, &species));
            Species = NativeText.Read(species.name);
            Bark = NativeText.Read(species.bark);
            LeafKindNames = new string[checked((int)species.n_leaf_kinds)];
            for (int kind = 0; kind < LeafKindNames.Length; kind++)
            {
                LeafKindNames[kind] = NativeText.Read(species.leaf_kinds[kind]);
            }
        }

        internal tree_tree* Make(NativeCall call)
        {
            int nodes = Rows("Positions, Radii and Parents", Parents, 1, Positions, 3, Radii, 1);
            int leaves = Rows(
                "the columns of leaves", LeafNodes, 1, LeafPositions, 3, LeafRotations, 4, LeafSizes, 1,
                LeafKinds, 1);
            fixed (float* positions = Positions, radii = Radii)
            fixed (uint* parents = Parents, leafNodes = LeafNodes)
            fixed (float* leafPositions = LeafPositions, rotations = LeafRotations, sizes = LeafSizes)
            fixed (ushort* kinds = LeafKinds)
            {
                var columns = new tree_skeleton_columns
                {
                    struct_size = (UIntPtr)sizeof(tree_skeleton_columns),
                    n_nodes = (UIntPtr)nodes,
                    positions = positions,
                    radii = radii,
                    parents = parents
                };
                var foliage = new tree_foliage
                {
                    struct_size = (UIntPtr)sizeof(tree_foliage),
                    n_leaves = (UIntPtr)leaves,
                    nodes = leafNodes,
                    positions = leafPositions,
                    rotations = rotations,
                    sizes = sizes,
                    kinds = kinds
                };
                tree_skeleton* skeleton;
                call.Check(TreeNative.tree_skeleton_from_columns(&columns, call.Control, &skeleton));
                try
                {
                    tree_species species = GivenSpecies(call);
                    tree_tree* made;
                    call.Check(TreeNative.tree_tree_new(
                        skeleton, &foliage, Species == null ? null : &species, call.Control, &made));
                    return made;
                }
                finally
                {
                    TreeNative.tree_skeleton_free(skeleton);
                }
            }
        }

        tree_species GivenSpecies(NativeCall call)
        {
            string[] names = LeafKindNames ?? new string[0];
            var kinds = (tree_str*)call.Block(names.Length * sizeof(tree_str));
            for (int kind = 0; kind < names.Length; kind++)
            {
                kinds[kind] = call.Str(names[kind]);
            }
            return new tree_species
            {
                struct_size = (UIntPtr)sizeof(tree_species),
                name = call.Str(Species),
                bark = call.Str(Bark),
                leaf_kinds = kinds,
                n_leaf_kinds = (UIntPtr)names.Length
            };
        }

        /// <summary>The library cannot see how long arrays are, so it is checked here.</summary>
        static int Rows(string what, params object[] columnsAndWidths)
        {
            var first = columnsAndWidths[0] as Array;
            for (int i = 0; i < columnsAndWidths.Length; i += 2)
            {
                var column = columnsAndWidths[i] as Array;
                if (first == null || column == null || column.Length != (long)first.Length * (int)columnsAndWidths[i + 1])
                {
                    throw new ArgumentException(what + " must be there and have as many rows each");
                }
            }
            return first.Length;
        }

        static T[] Copy<T>(void* column, int width, int rows)
        {
            var copy = new T[checked(width * rows)];
            GCHandle pinned = GCHandle.Alloc(copy, GCHandleType.Pinned);
            try
            {
                long bytes = Buffer.ByteLength(copy);
                if (bytes > 0)
                {
                    Buffer.MemoryCopy(column, (void*)pinned.AddrOfPinnedObject(), bytes, bytes);
                }
            }
            finally
            {
                pinned.Free();
            }
            return copy;
        }
    }
}
