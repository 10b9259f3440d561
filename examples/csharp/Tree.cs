// Trees and what they look like. What is not wrapped here is called through TreeNative, with NativeCall.
using System;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>What a species looks like. Make it once for many meshes.</summary>
    public sealed unsafe class TreeLook : TreeHandle
    {
        /// <summary>Takes over what a call of your own made.</summary>
        public TreeLook(tree_look* made)
        {
            Own(made);
        }

        /// <summary>The built-in textures of a tree's species; or plain colours.</summary>
        public static TreeLook Of(BotanicalTree tree, bool plain)
        {
            using (var call = new NativeCall())
            {
                tree_look* made;
                call.Check(TreeNative.tree_look_of_tree(
                    (tree_tree*)call.Use(tree), plain ? 1u : 0u, &made));
                return new TreeLook(made);
            }
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_look_free((tree_look*)handle) == TreeNative.TREE_OK;
        }
    }

    /// <summary>A tree: skeleton, leaves and species.</summary>
    public sealed unsafe class BotanicalTree : TreeHandle
    {
        /// <summary>Takes over what a call of your own made.</summary>
        public BotanicalTree(tree_tree* made)
        {
            Own(made);
        }

        /// <summary>Grows a preset, such as "oak". The same seed gives the same tree everywhere.</summary>
        public static BotanicalTree Grow(string preset, ulong seed, CallOptions options = null)
        {
            return Grow(TreeDefaults.Path(preset), seed, options);
        }

        /// <summary>Grows a tree of least-cost paths; begin with TreeDefaults.Path.</summary>
        public static BotanicalTree Grow(
            tree_path_params parameters, ulong seed, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_tree* made;
                call.Check(TreeNative.tree_path_grow(
                    &parameters, seed, call.Control, null, &made));
                return new BotanicalTree(made);
            }
        }

        /// <summary>A tree of a skeleton of your own, with leaves or without.</summary>
        public static BotanicalTree FromColumns(TreeColumns columns, CallOptions options = null)
        {
            if (columns == null)
            {
                throw new ArgumentNullException("columns");
            }
            using (var call = new NativeCall(options))
            {
                return new BotanicalTree(columns.Make(call));
            }
        }

        /// <summary>Reads skeleton and leaves out of a mesh.</summary>
        public static BotanicalTree Skeletonize(
            TreeMesh mesh, tree_skeletonize_params? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_skeletonize_params given = parameters.GetValueOrDefault();
                tree_tree* made;
                call.Check(TreeNative.tree_skeletonize_mesh(
                    (tree_mesh*)call.Use(mesh), null, UIntPtr.Zero,
                    parameters.HasValue ? &given : null, call.Control, null, &made));
                return new BotanicalTree(made);
            }
        }

        /// <summary>
        /// A tree with the same skeleton and new leaves in place of the old; with stalks, petioles become
        /// thin branches.
        /// </summary>
        public BotanicalTree GrowLeaves(
            ulong seed, tree_leaf_params? parameters = null, bool withStalks = false,
            CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_leaf_params given = parameters.GetValueOrDefault();
                tree_tree* made;
                call.Check(TreeNative.tree_tree_grow_leaves(
                    (tree_tree*)call.Use(this), parameters.HasValue ? &given : null, IntPtr.Zero,
                    null, withStalks ? 1u : 0u, seed, call.Control, null, &made));
                return new BotanicalTree(made);
            }
        }

        /// <summary>A tree with the same leaves, and twigs on its youngest shoots.</summary>
        public BotanicalTree GrowTwigs(
            ulong seed, tree_twig_params? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_twig_params given = parameters.GetValueOrDefault();
                tree_tree* made;
                call.Check(TreeNative.tree_tree_grow_twigs(
                    (tree_tree*)call.Use(this), parameters.HasValue ? &given : null, IntPtr.Zero,
                    null, seed, call.Control, null, &made));
                return new BotanicalTree(made);
            }
        }

        /// <summary>Skeleton, leaves and species, copied.</summary>
        public TreeColumns Columns()
        {
            using (var call = new NativeCall())
            {
                return new TreeColumns(call, (tree_tree*)call.Use(this));
            }
        }

        /// <summary>
        /// Makes a mesh. Without a look the built-in one of the species is made anew for every call.
        /// </summary>
        public TreeMesh Build(
            TreeLook look = null, tree_mesh_params? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_mesh_params given = parameters.GetValueOrDefault();
                tree_mesh* made;
                call.Check(TreeNative.tree_mesh_build(
                    (tree_tree*)call.Use(this),
                    (tree_look*)call.Use(look),
                    parameters.HasValue ? &given : null,
                    call.Control,
                    null,
                    &made));
                return new TreeMesh(made);
            }
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_tree_free((tree_tree*)handle) == TreeNative.TREE_OK;
        }
    }
}
