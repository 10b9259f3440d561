// Trees and meshes for C#: what most programs need. The rest of the interface is in TreeNative, and is
// wrapped in the same way.
using System;
using System.Runtime.InteropServices;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>The library as a whole.</summary>
    public static unsafe class TreeLibrary
    {
        static bool checkedOnce;

        /// <summary>Such as 0.1.0.</summary>
        public static string Version
        {
            get { return Utf8.Read(TreeNative.tree_version()); }
        }

        /// <summary>Objects alive, of all kinds: for tests that look for leaks.</summary>
        public static long LiveObjects
        {
            get { return (long)TreeNative.tree_live_objects(); }
        }

        /// <summary>Bytes that the library has in use.</summary>
        public static long MemoryUsed
        {
            get { return (long)TreeNative.tree_memory_used(); }
        }

        /// <summary>Bytes that the library may have in use, all objects and calls together; 0 for no budget.</summary>
        public static long MemoryBudget
        {
            get { return (long)TreeNative.tree_memory_budget(); }
            set { TreeNative.tree_memory_set_budget(checked((ulong)value)); }
        }

        /// <summary>Caps for one call.</summary>
        public static tree_limits DefaultLimits
        {
            get
            {
                tree_limits limits;
                using (var call = new Calling())
                {
                    call.Check(TreeNative.tree_limits_init(&limits, (UIntPtr)sizeof(tree_limits)));
                }
                return limits;
            }
        }

        /// <summary>Caps such that one call takes about this many bytes at most.</summary>
        public static tree_limits LimitsForMemory(long bytes)
        {
            tree_limits limits;
            using (var call = new Calling())
            {
                call.Check(TreeNative.tree_limits_for_memory(
                    &limits, (UIntPtr)sizeof(tree_limits), checked((ulong)bytes)));
            }
            return limits;
        }

        /// <summary>The defaults, to be changed and handed to BotanicalTree.Build.</summary>
        public static tree_mesh_params DefaultMeshParams
        {
            get
            {
                tree_mesh_params parameters;
                using (var call = new Calling())
                {
                    call.Check(TreeNative.tree_mesh_params_init(
                        &parameters, (UIntPtr)sizeof(tree_mesh_params)));
                }
                return parameters;
            }
        }

        /// <summary>
        /// The parameters of a preset, to be changed and handed to BotanicalTree.Grow. What they point at
        /// belongs to the library and lives for ever.
        /// </summary>
        public static tree_path_params Preset(string name)
        {
            if (name == null)
            {
                throw new ArgumentNullException("name");
            }
            tree_path_params parameters;
            using (var call = new Calling())
            {
                call.Check(TreeNative.tree_path_preset(
                    call.Text(name), TreeNative.TREE_NUL_TERMINATED,
                    &parameters, (UIntPtr)sizeof(tree_path_params)));
            }
            return parameters;
        }

        /// <summary>A library of another ABI would read our structs wrongly.</summary>
        internal static void CheckVersion()
        {
            if (checkedOnce)
            {
                return;
            }
            uint found = TreeNative.tree_abi_version();
            if (found != TreeNative.TREE_ABI_VERSION)
            {
                throw new DllNotFoundException(
                    "tree_ffi has ABI version " + found + ", these sources are for "
                    + TreeNative.TREE_ABI_VERSION);
            }
            checkedOnce = true;
        }
    }

    /// <summary>A switch that cancels calls.</summary>
    internal sealed unsafe class CancelSwitch : TreeHandle
    {
        public CancelSwitch()
        {
            tree_cancel* made;
            using (var call = new Calling())
            {
                call.Check(TreeNative.tree_cancel_new(&made));
            }
            Own(made);
        }

        public void Set()
        {
            using (var call = new Calling())
            {
                call.Check(TreeNative.tree_cancel_set((tree_cancel*)call.Use(this)));
            }
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_cancel_free((tree_cancel*)handle) == TreeNative.TREE_OK;
        }
    }

    /// <summary>
    /// Threads for calls. Where the program's domain is unloaded and loaded again, as in Unity's editor,
    /// give every call a pool and dispose of it before.
    /// </summary>
    public sealed unsafe class TreePool : TreeHandle
    {
        /// <summary>0 threads: one for each core.</summary>
        public TreePool(int threads)
        {
            using (var call = new Calling())
            {
                tree_pool_options options;
                tree_pool* made;
                call.Check(TreeNative.tree_pool_options_init(
                    &options, (UIntPtr)sizeof(tree_pool_options)));
                options.n_threads = checked((uint)threads);
                call.Check(TreeNative.tree_pool_new(&options, &made));
                Own(made);
            }
        }

        /// <summary>Number of threads.</summary>
        public int Threads
        {
            get
            {
                using (var call = new Calling())
                {
                    uint threads;
                    call.Check(TreeNative.tree_pool_threads(
                        (tree_pool*)call.Use(this), &threads));
                    return (int)threads;
                }
            }
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_pool_free((tree_pool*)handle) == TreeNative.TREE_OK;
        }
    }

    /// <summary>What a species looks like. Make it once for many meshes.</summary>
    public sealed unsafe class TreeLook : TreeHandle
    {
        TreeLook() { }

        /// <summary>The built-in textures of a tree's species; or plain colours.</summary>
        public static TreeLook Of(BotanicalTree tree, bool plain)
        {
            using (var call = new Calling())
            {
                tree_look* made;
                call.Check(TreeNative.tree_look_of_tree(
                    (tree_tree*)call.Use(tree), plain ? 1u : 0u, &made));
                var look = new TreeLook();
                look.Own(made);
                return look;
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
        BotanicalTree() { }

        /// <summary>Grows a preset, such as "oak". The same seed gives the same tree everywhere.</summary>
        public static BotanicalTree Grow(string preset, ulong seed, CallOptions options = null)
        {
            return Grow(TreeLibrary.Preset(preset), seed, options);
        }

        /// <summary>Grows a tree of least-cost paths; begin with TreeLibrary.Preset.</summary>
        public static BotanicalTree Grow(
            tree_path_params parameters, ulong seed, CallOptions options = null)
        {
            using (var call = new Calling(options))
            {
                tree_tree* made;
                call.Check(TreeNative.tree_path_grow(
                    &parameters, seed, call.Control, null, &made));
                var tree = new BotanicalTree();
                tree.Own(made);
                return tree;
            }
        }

        /// <summary>
        /// Makes a mesh. Without a look the built-in one of the species is made anew for every call.
        /// </summary>
        public TreeMesh Build(
            TreeLook look = null, tree_mesh_params? parameters = null, CallOptions options = null)
        {
            using (var call = new Calling(options))
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

    /// <summary>Surfaces with their materials.</summary>
    public sealed unsafe class TreeMesh : TreeHandle
    {
        internal TreeMesh(tree_mesh* made)
        {
            Own(made);
        }

        /// <summary>Number of surfaces: 0 is the bark, 1 + k the leaves of kind k. Some may be empty.</summary>
        public int SurfaceCount
        {
            get
            {
                using (var call = new Calling())
                {
                    UIntPtr count;
                    call.Check(TreeNative.tree_mesh_surface_count(
                        (tree_mesh*)call.Use(this), &count));
                    return (int)count;
                }
            }
        }

        /// <summary>A surface, copied: it outlives the mesh.</summary>
        public TreeSurface Surface(int number)
        {
            using (var call = new Calling())
            {
                var view = new tree_surface { struct_size = (UIntPtr)sizeof(tree_surface) };
                call.Check(TreeNative.tree_mesh_surface(
                    (tree_mesh*)call.Use(this), Size(number), &view));
                return new TreeSurface(view);
            }
        }

        /// <summary>The box around all vertices, in metres: its lower corner, then its upper one.</summary>
        public float[] Bounds()
        {
            using (var call = new Calling())
            {
                var found = new tree_bounds { struct_size = (UIntPtr)sizeof(tree_bounds) };
                call.Check(TreeNative.tree_mesh_bounds((tree_mesh*)call.Use(this), &found));
                return new[]
                {
                    found.min[0], found.min[1], found.min[2],
                    found.max[0], found.max[1], found.max[2],
                };
            }
        }

        /// <summary>A material, with its picture copied; TreeSurface.Material is its number.</summary>
        public TreeMaterial Material(int number)
        {
            using (var call = new Calling())
            {
                var mesh = (tree_mesh*)call.Use(this);
                var view = new tree_material { struct_size = (UIntPtr)sizeof(tree_material) };
                call.Check(TreeNative.tree_mesh_material(mesh, Size(number), &view));
                var material = new TreeMaterial(view);
                tree_texture* texture;
                call.Check(TreeNative.tree_mesh_texture(mesh, Size(number), &texture));
                if (texture != null)
                {
                    using (var handle = new TextureHandle(texture))
                    {
                        var pixels = new tree_texture_pixels
                        {
                            struct_size = (UIntPtr)sizeof(tree_texture_pixels)
                        };
                        call.Check(TreeNative.tree_texture_view(texture, &pixels));
                        material.CopyPixels(pixels);
                    }
                }
                return material;
            }
        }

        static UIntPtr Size(int number)
        {
            return (UIntPtr)checked((uint)number);
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_mesh_free((tree_mesh*)handle) == TreeNative.TREE_OK;
        }
    }

    internal sealed unsafe class TextureHandle : TreeHandle
    {
        public TextureHandle(tree_texture* made)
        {
            Own(made);
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_texture_free((tree_texture*)handle) == TreeNative.TREE_OK;
        }
    }
}
