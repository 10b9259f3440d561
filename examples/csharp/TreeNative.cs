// The tree family's C interface for C#: made from include/tree.h, do not edit.
//   TREE_UPDATE=1 cargo test -p tree-ffi --test csharp
// Licence: MIT OR Apache-2.0.
//
// As in C: nothing here is checked, counted or freed for you. Tree.cs does that.
// size_t is UIntPtr, char a byte of UTF-8, a function pointer an IntPtr: what
// Marshal.GetFunctionPointerForDelegate makes of a delegate, which must be kept alive for as long as the
// library may call it.

using System;
using System.Runtime.InteropServices;

#pragma warning disable 0649, 1591

namespace TreeFamily.Native
{
    /// <summary>
    /// A file in memory.
    /// </summary>
    public struct tree_bytes { }

    /// <summary>
    /// A switch that cancels the calls it was given to.
    /// </summary>
    public struct tree_cancel { }

    /// <summary>
    /// Surfaces with their materials, and the branches that move in the wind.
    /// </summary>
    public struct tree_mesh { }

    /// <summary>
    /// Threads that do the work of the calls it is given to (`tree_control.pool`). What calls make does not
    /// depend on it. A plug-in that may be unloaded gives every call a pool and frees it before that: the
    /// threads of calls without a pool never end.
    /// </summary>
    public struct tree_pool { }

    /// <summary>
    /// Branches as a rooted tree of nodes with radii.
    /// </summary>
    public struct tree_skeleton { }

    /// <summary>
    /// A whole tree: skeleton, leaves and species. Every leaf stands on a node that exists and has a kind
    /// that exists.
    /// </summary>
    public struct tree_tree { }

    /// <summary>
    /// A solid, or a combination of solids.
    /// </summary>
    public struct tree_volume { }

    /// <summary>
    /// Told how far a call has come: what is being done (UTF-8, NUL at the end, valid during the call) and
    /// the share of the whole that is done, 0 to 1. Returns 0 to go on, anything else to cancel. Called from
    /// whichever thread does the work, one call at a time or several; must not unwind.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int tree_progress_fn(void* user, byte* stage, float fraction);

    /// <summary>
    /// `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void* tree_allocator_alloc(void* user, UIntPtr size, UIntPtr align);

    /// <summary>
    /// Gives back what `alloc` gave for this size and alignment.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void tree_allocator_free(void* user, void* block, UIntPtr size, UIntPtr align);

    /// <summary>
    /// What the host runs on one of its threads: `run(worker)`, once. It returns when the pool is freed.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void tree_worker_fn(void* worker);

    /// <summary>
    /// Asks the host for a thread that calls `run(worker)`, on any thread but the asking one. Returns 0 when
    /// it will, anything else when it cannot (then `run` must not be called).
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int tree_spawn_fn(void* user, IntPtr run, void* worker);

    /// <summary>
    /// Caps for one call: over the cap is `TREE_ERROR_LIMIT`, before the memory is asked for. Begin with
    /// `tree_limits_init` or `tree_limits_for_memory`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_limits
    {
        /// <summary>
        /// `sizeof(tree_limits)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Nodes of a skeleton. Default 20 million.
        /// </summary>
        public ulong nodes;
        /// <summary>
        /// Nodes of all search graphs of one model together. Default 20 million.
        /// </summary>
        public ulong graph_nodes;
        /// <summary>
        /// Arcs of one search graph. Default 300 million.
        /// </summary>
        public ulong graph_arcs;
        /// <summary>
        /// Leaves of one tree. Default 20 million.
        /// </summary>
        public ulong leaves;
        /// <summary>
        /// Cells of a three-dimensional grid. Default 512³.
        /// </summary>
        public ulong voxels;
        /// <summary>
        /// Pixels of a picture, supersamples included. Default 16,384².
        /// </summary>
        public ulong pixels;
        /// <summary>
        /// Triangles of one mesh. Default 100 million.
        /// </summary>
        public ulong triangles;
        /// <summary>
        /// Bytes of an input file. Default 1 GiB.
        /// </summary>
        public ulong input_bytes;
    }

    /// <summary>
    /// How a call is done. Begin with `tree_control_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_control
    {
        /// <summary>
        /// `sizeof(tree_control)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Told of progress. Default NULL.
        /// </summary>
        public IntPtr progress;
        /// <summary>
        /// Handed to `progress`.
        /// </summary>
        public void* user;
        /// <summary>
        /// Cancels the call from any thread. Default NULL.
        /// </summary>
        public tree_cancel* cancel;
        /// <summary>
        /// Caps on what the call may use. Default NULL: those of `tree_limits_init`.
        /// </summary>
        public tree_limits* limits;
        /// <summary>
        /// Threads that do the work. Default NULL: one for each core, shared by all calls.
        /// </summary>
        public tree_pool* pool;
    }

    /// <summary>
    /// The host's allocator. Its functions are called from any thread and must not call the library.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_allocator
    {
        /// <summary>
        /// `sizeof(tree_allocator)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Handed to the functions.
        /// </summary>
        public void* user;
        /// <summary>
        /// `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
        /// </summary>
        public IntPtr alloc;
        /// <summary>
        /// Gives back what `alloc` gave for this size and alignment.
        /// </summary>
        public IntPtr free;
    }

    /// <summary>
    /// Which threads a pool has. Begin with `tree_pool_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pool_options
    {
        /// <summary>
        /// `sizeof(tree_pool_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of threads, at most 1024. Default 0: one for each core.
        /// </summary>
        public uint n_threads;
        /// <summary>
        /// Bytes of stack of each thread that the library starts. Default 0: the system's.
        /// </summary>
        public UIntPtr stack_size;
        /// <summary>
        /// Gives the pool the host's own threads, for instance long-running jobs of its job system, each for
        /// the pool's whole life. Default NULL: the library starts threads.
        /// </summary>
        public IntPtr spawn;
        /// <summary>
        /// Handed to `spawn`.
        /// </summary>
        public void* user;
    }

    /// <summary>
    /// A skeleton's columns: as input, or as a view of a `tree_skeleton`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_skeleton_columns
    {
        /// <summary>
        /// `sizeof(tree_skeleton_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes, at least 1.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// Three floats for each node: where it is, in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// One for each node: radius of the wood in metres, 0 or more.
        /// </summary>
        public float* radii;
        /// <summary>
        /// One for each node: the node it stands on, or `TREE_NO_PARENT` for the root.
        /// </summary>
        public uint* parents;
    }

    /// <summary>
    /// Leaves in columns, a row for each blade (leaflet, needle): as input, or as a view of a tree's.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_foliage
    {
        /// <summary>
        /// `sizeof(tree_foliage)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of rows.
        /// </summary>
        public UIntPtr n_leaves;
        /// <summary>
        /// One for each leaf: the skeleton's node that bears it.
        /// </summary>
        public uint* nodes;
        /// <summary>
        /// Three floats for each leaf: the base of the blade, in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Four floats for each leaf: the quaternion x, y, z, w that turns the leaf's own frame (midrib
        /// along +Y, upper face to +Z) into the tree's.
        /// </summary>
        public float* rotations;
        /// <summary>
        /// One for each leaf: length from base to apex in metres, 0 or more.
        /// </summary>
        public float* sizes;
        /// <summary>
        /// One for each leaf: its kind, an index into the species' leaf kinds.
        /// </summary>
        public ushort* kinds;
    }

    /// <summary>
    /// A text in UTF-8. As input, `len` may be `TREE_NUL_TERMINATED` and `data` NULL for an empty text. As
    /// output it is borrowed, and no NUL byte need follow it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_str
    {
        /// <summary>
        /// The first byte.
        /// </summary>
        public byte* data;
        /// <summary>
        /// Number of bytes.
        /// </summary>
        public UIntPtr len;
    }

    /// <summary>
    /// What kind of tree it is. Built-in looks go by these names; see `tree_bark_names` and
    /// `tree_leaf_names`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_species
    {
        /// <summary>
        /// `sizeof(tree_species)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name for people and files.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Name of the bark.
        /// </summary>
        public tree_str bark;
        /// <summary>
        /// Names of the leaf kinds.
        /// </summary>
        public tree_str* leaf_kinds;
        /// <summary>
        /// Number of leaf kinds.
        /// </summary>
        public UIntPtr n_leaf_kinds;
    }

    /// <summary>The header's constants and functions.</summary>
    public static unsafe class TreeNative
    {
#if (UNITY_IOS || UNITY_WEBGL) && !UNITY_EDITOR
        /// <summary>The library is linked into the program there.</summary>
        public const string Library = "__Internal";
#else
        /// <summary>libtree_ffi.so, libtree_ffi.dylib or tree_ffi.dll.</summary>
        public const string Library = "tree_ffi";
#endif

        public static readonly UIntPtr TREE_NUL_TERMINATED = (UIntPtr)(UIntPtr.Size == 8 ? ulong.MaxValue : uint.MaxValue);

        /// <summary>
        /// Done.
        /// </summary>
        public const int TREE_OK = 0;

        /// <summary>
        /// A pointer that must not be NULL is.
        /// </summary>
        public const int TREE_ERROR_NULL = 1;

        /// <summary>
        /// A handle is not alive: it was freed, is of another kind, or never was one.
        /// </summary>
        public const int TREE_ERROR_HANDLE = 2;

        /// <summary>
        /// A struct's `struct_size` fits no version of it. Usually it was not set.
        /// </summary>
        public const int TREE_ERROR_STRUCT_SIZE = 3;

        /// <summary>
        /// A text is not UTF-8, or a path or a name has a NUL byte in it.
        /// </summary>
        public const int TREE_ERROR_TEXT = 4;

        /// <summary>
        /// A number that should be one of a set of constants is none of them.
        /// </summary>
        public const int TREE_ERROR_ENUM = 5;

        /// <summary>
        /// A parameter lies outside its range, or is not finite.
        /// </summary>
        public const int TREE_ERROR_PARAMETER = 6;

        /// <summary>
        /// Columns do not fit together: lengths, orders, indices that name nothing, coordinates that are not
        /// finite.
        /// </summary>
        public const int TREE_ERROR_INVALID = 7;

        /// <summary>
        /// No preset, texture or format has this name.
        /// </summary>
        public const int TREE_ERROR_UNKNOWN_NAME = 8;

        /// <summary>
        /// More was asked for than the limits of `tree_control` allow.
        /// </summary>
        public const int TREE_ERROR_LIMIT = 9;

        /// <summary>
        /// The memory budget does not allow it.
        /// </summary>
        public const int TREE_ERROR_MEMORY = 10;

        /// <summary>
        /// The caller cancelled. Nothing was changed and nothing was written.
        /// </summary>
        public const int TREE_ERROR_CANCELLED = 11;

        /// <summary>
        /// A file could not be read or written.
        /// </summary>
        public const int TREE_ERROR_IO = 12;

        /// <summary>
        /// A file is not what its format asks for, or needs what this library cannot do.
        /// </summary>
        public const int TREE_ERROR_FORMAT = 13;

        /// <summary>
        /// The parameters are each in order, but no tree, mesh or picture comes of them.
        /// </summary>
        public const int TREE_ERROR_NO_RESULT = 14;

        /// <summary>
        /// The caller's buffer is too small.
        /// </summary>
        public const int TREE_ERROR_BUFFER = 15;

        /// <summary>
        /// A call that cannot be made now, such as freeing a pool that is at work.
        /// </summary>
        public const int TREE_ERROR_ORDER = 16;

        /// <summary>
        /// A defect in the library. Please report it with the text.
        /// </summary>
        public const int TREE_ERROR_PANIC = 17;

        /// <summary>
        /// Parent of the root: no node.
        /// </summary>
        public const uint TREE_NO_PARENT = 4294967295;

        /// <summary>
        /// Version of the ABI that this header describes. A library with the same number has every function and
        /// struct of this header; additions do not change it.
        /// </summary>
        public const int TREE_ABI_VERSION = 1;

        /// <summary>
        /// What went wrong in this thread's last call that failed, in UTF-8 and with a NUL at the end: what was
        /// wrong, where, and what would be right. Empty before any call failed. Never NULL; valid until the next
        /// call that fails in this thread.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* tree_error_text();

        /// <summary>
        /// The code of this thread's last call that failed; `TREE_OK` before any did.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_error_status();

        /// <summary>
        /// Forgets this thread's last error, and gives its memory back.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void tree_error_clear();

        /// <summary>
        /// Name of a status, such as `TREE_ERROR_NULL`. Never NULL, and valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* tree_status_name(int status);

        /// <summary>
        /// Makes `control`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_control_init(tree_control* control, UIntPtr size);

        /// <summary>
        /// Makes `limits`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_limits_init(tree_limits* limits, UIntPtr size);

        /// <summary>
        /// Makes `limits`, of `size` bytes, such that one call takes about `bytes` of memory at most; never more
        /// than the default. `tree_memory_set_budget` does so for all calls together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_limits_for_memory(tree_limits* limits, UIntPtr size, ulong bytes);

        /// <summary>
        /// Makes a switch, not set. Free it with `tree_cancel_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cancel_new(tree_cancel** cancel);

        /// <summary>
        /// Sets the switch, from any thread: calls it was given to end with `TREE_ERROR_CANCELLED`, mostly within
        /// milliseconds. It stays set.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cancel_set(tree_cancel* cancel);

        /// <summary>
        /// Ends a switch. Calls it was given to may still run.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cancel_free(tree_cancel* cancel);

        /// <summary>
        /// Views the bytes: where they begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bytes_view(tree_bytes* bytes, byte** data, UIntPtr* len);

        /// <summary>
        /// Ends a file in memory.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bytes_free(tree_bytes* bytes);

        /// <summary>
        /// Bytes that the library has allocated and not freed, objects and work in progress together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern ulong tree_memory_used();

        /// <summary>
        /// Most bytes in use at one time since the start, or since `tree_memory_reset_peak`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern ulong tree_memory_peak();

        /// <summary>
        /// Lets the peak begin anew at what is in use now.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void tree_memory_reset_peak();

        /// <summary>
        /// Sets how many bytes the library may have in use, all calls and objects together; 0 for no budget, as
        /// at the start. A call that would need more fails with `TREE_ERROR_LIMIT` before it takes the memory,
        /// or with `TREE_ERROR_MEMORY` while it works; what it had taken is free again then. Several calls at
        /// once may all be told so. Small calls, such as looking at a mesh, never fail.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void tree_memory_set_budget(ulong bytes);

        /// <summary>
        /// The budget in bytes; 0 when there is none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern ulong tree_memory_budget();

        /// <summary>
        /// Lets the library take its memory from the host's allocator. Only before anything else: once the
        /// library has memory of its own it is `TREE_ERROR_ORDER`. When `alloc` gives NULL the process aborts, as
        /// Rust does; set a budget below what the allocator has.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_memory_set_allocator(tree_allocator* allocator);

        /// <summary>
        /// Ends a mesh, and with it all views of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_free(tree_mesh* mesh);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pool_options_init(tree_pool_options* options, UIntPtr size);

        /// <summary>
        /// Starts a pool, or asks the host for its threads. `options` may be NULL. Free it with
        /// `tree_pool_free`. Fails with `TREE_ERROR_NO_RESULT` when a thread cannot be had.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pool_new(tree_pool_options* options, tree_pool** pool);

        /// <summary>
        /// Number of threads of a pool.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pool_threads(tree_pool* pool, uint* n_threads);

        /// <summary>
        /// Ends a pool, and returns when its threads are out of the library's code. `TREE_ERROR_ORDER`, and the
        /// pool lives on, while a call is at work on it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pool_free(tree_pool* pool);

        /// <summary>
        /// Makes a skeleton of columns, which are copied. Node 0 is the root, parents come before their children;
        /// for rows in another order there is `tree_skeleton_from_unordered`. `control` may be NULL; only its
        /// limits matter. Free the skeleton with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_from_columns(tree_skeleton_columns* columns, tree_control* control, tree_skeleton** skeleton);

        /// <summary>
        /// Makes a skeleton of columns in any order, with the one root anywhere. `rows`, NULL or with room for
        /// `n_nodes` numbers, gets for each node of the skeleton its row in the columns. Otherwise as
        /// `tree_skeleton_from_columns`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_from_unordered(tree_skeleton_columns* columns, tree_control* control, uint* rows, tree_skeleton** skeleton);

        /// <summary>
        /// Views a skeleton's columns. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_view(tree_skeleton* skeleton, tree_skeleton_columns* columns);

        /// <summary>
        /// The box around all nodes, without their radii: its lower corner, then its upper one, in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_bounds(tree_skeleton* skeleton, float* min_max);

        /// <summary>
        /// Ends a skeleton.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_free(tree_skeleton* skeleton);

        /// <summary>
        /// Makes a tree of a skeleton, which is copied, and columns of leaves (NULL for none), which are copied.
        /// `species` may be NULL for an oak. `control` may be NULL; only its limits matter. Free the tree with
        /// `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_new(tree_skeleton* skeleton, tree_foliage* foliage, tree_species* species, tree_control* control, tree_tree** tree);

        /// <summary>
        /// The tree's skeleton, not copied. Free it with `tree_skeleton_free`; it may outlive the tree's handle.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_skeleton(tree_tree* tree, tree_skeleton** skeleton);

        /// <summary>
        /// Views the tree's leaves. Set `foliage-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_foliage(tree_tree* tree, tree_foliage* foliage);

        /// <summary>
        /// Views the tree's species. Set `species-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_species(tree_tree* tree, tree_species* species);

        /// <summary>
        /// Ends a tree.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_free(tree_tree* tree);

        /// <summary>
        /// The library's own `TREE_ABI_VERSION`: hold it against the header's before anything else.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint tree_abi_version();

        /// <summary>
        /// The library's version, such as `0.1.0`. Valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* tree_version();

        /// <summary>
        /// Number of objects alive, of all kinds: for tests that look for leaks. Presets and their parts, which
        /// are never freed, do not count.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr tree_live_objects();

        /// <summary>
        /// Ends a volume. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_free(tree_volume* volume);
    }
}
