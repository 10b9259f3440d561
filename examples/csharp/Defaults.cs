// Parameters to begin with: take the default, change fields, hand it to a method. What the fields mean, their
// units and ranges stand in TreeNative.cs at the structs.
using System;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>The library's defaults.</summary>
    public static unsafe class TreeDefaults
    {
        /// <summary>Caps for CallOptions.Limits.</summary>
        public static tree_limits Limits
        {
            get
            {
                tree_limits made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_limits_init(&made, (UIntPtr)sizeof(tree_limits)));
                }
                return made;
            }
        }

        /// <summary>Caps such that one call takes about this many bytes at most.</summary>
        public static tree_limits LimitsForMemory(long bytes)
        {
            tree_limits limits;
            using (var call = new NativeCall())
            {
                call.Check(TreeNative.tree_limits_for_memory(
                    &limits, (UIntPtr)sizeof(tree_limits), checked((ulong)bytes)));
            }
            return limits;
        }

        /// <summary>
        /// The parameters of a preset, for BotanicalTree.Grow. What they point at belongs to the library and
        /// lives for ever.
        /// </summary>
        public static tree_path_params Path(string preset)
        {
            tree_path_params parameters;
            using (var call = new NativeCall())
            {
                call.Check(TreeNative.tree_path_preset(
                    call.Text(Given(preset)), TreeNative.TREE_NUL_TERMINATED,
                    &parameters, (UIntPtr)sizeof(tree_path_params)));
            }
            return parameters;
        }

        /// <summary>For BotanicalTree.GrowLeaves.</summary>
        public static tree_leaf_params Leaves
        {
            get
            {
                tree_leaf_params made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_leaf_params_init(&made, (UIntPtr)sizeof(tree_leaf_params)));
                }
                return made;
            }
        }

        /// <summary>For BotanicalTree.GrowTwigs.</summary>
        public static tree_twig_params Twigs
        {
            get
            {
                tree_twig_params made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_twig_params_init(&made, (UIntPtr)sizeof(tree_twig_params)));
                }
                return made;
            }
        }

        /// <summary>Leaves, twigs and the name of the leaf kind of a species, such as oak.</summary>
        public static string Foliage(
            string species, out tree_leaf_params leaves, out tree_twig_params twigs)
        {
            leaves = Leaves;
            twigs = Twigs;
            tree_str kind;
            using (var call = new NativeCall())
            fixed (tree_leaf_params* toLeaves = &leaves)
            fixed (tree_twig_params* toTwigs = &twigs)
            {
                call.Check(TreeNative.tree_foliage_preset(
                    call.Text(Given(species)), TreeNative.TREE_NUL_TERMINATED, toLeaves, toTwigs,
                    &kind));
            }
            return NativeText.Read(kind);
        }

        /// <summary>For BotanicalTree.Build.</summary>
        public static tree_mesh_params Mesh
        {
            get
            {
                tree_mesh_params made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_mesh_params_init(&made, (UIntPtr)sizeof(tree_mesh_params)));
                }
                return made;
            }
        }

        /// <summary>For BotanicalTree.Skeletonize.</summary>
        public static tree_skeletonize_params Skeletonize
        {
            get
            {
                tree_skeletonize_params made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_skeletonize_params_init(&made, (UIntPtr)sizeof(tree_skeletonize_params)));
                }
                return made;
            }
        }

        /// <summary>For TreeMesh.Read.</summary>
        public static tree_import_options Import
        {
            get
            {
                tree_import_options made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_import_options_init(&made, (UIntPtr)sizeof(tree_import_options)));
                }
                return made;
            }
        }

        /// <summary>For TreeMesh.WriteGlb and ToGlb.</summary>
        public static tree_glb_options Glb
        {
            get
            {
                tree_glb_options made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_glb_options_init(&made, (UIntPtr)sizeof(tree_glb_options)));
                }
                return made;
            }
        }

        /// <summary>For TreeMesh.RenderPng.</summary>
        public static tree_view View
        {
            get
            {
                tree_view made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_view_init(&made, (UIntPtr)sizeof(tree_view)));
                }
                return made;
            }
        }

        /// <summary>For TreeMesh.RenderPng: a clear day on grass.</summary>
        public static tree_style Style
        {
            get
            {
                tree_style made;
                using (var call = new NativeCall())
                {
                    call.Check(TreeNative.tree_style_init(&made, (UIntPtr)sizeof(tree_style)));
                }
                return made;
            }
        }

        static string Given(string name)
        {
            if (name == null)
            {
                throw new ArgumentNullException("name");
            }
            return name;
        }
    }
}
