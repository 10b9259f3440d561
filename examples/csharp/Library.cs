// The library as a whole, and threads.
using System;
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
            get { return NativeText.Read(TreeNative.tree_version()); }
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
            using (var call = new NativeCall())
            {
                call.Check(TreeNative.tree_cancel_new(&made));
            }
            Own(made);
        }

        public void Set()
        {
            using (var call = new NativeCall())
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
            using (var call = new NativeCall())
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
                using (var call = new NativeCall())
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
}
