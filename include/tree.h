/* The tree family's C interface. Made by cbindgen from tree-ffi/src: do not edit.
 * Licence: MIT OR Apache-2.0. */

#ifndef TREE_H
#define TREE_H

#include <stddef.h>
#include <stdint.h>
/* Length of a text that ends with a NUL byte instead. */
#define TREE_NUL_TERMINATED SIZE_MAX

// Done.
#define TREE_OK 0

// A pointer that must not be NULL is.
#define TREE_ERROR_NULL 1

// A handle is not alive: it was freed, is of another kind, or never was one.
#define TREE_ERROR_HANDLE 2

// A struct's `struct_size` fits no version of it. Usually it was not set.
#define TREE_ERROR_STRUCT_SIZE 3

// A text is not UTF-8, or a path or a name has a NUL byte in it.
#define TREE_ERROR_TEXT 4

// A number that should be one of a set of constants is none of them.
#define TREE_ERROR_ENUM 5

// A parameter lies outside its range, or is not finite.
#define TREE_ERROR_PARAMETER 6

// Columns do not fit together: lengths, orders, indices that name nothing, coordinates that are not
// finite.
#define TREE_ERROR_INVALID 7

// No preset, texture or format has this name.
#define TREE_ERROR_UNKNOWN_NAME 8

// More was asked for than the limits of `tree_control` allow.
#define TREE_ERROR_LIMIT 9

// The memory budget does not allow it.
#define TREE_ERROR_MEMORY 10

// The caller cancelled. Nothing was changed and nothing was written.
#define TREE_ERROR_CANCELLED 11

// A file could not be read or written.
#define TREE_ERROR_IO 12

// A file is not what its format asks for, or needs what this library cannot do.
#define TREE_ERROR_FORMAT 13

// The parameters are each in order, but no tree, mesh or picture comes of them.
#define TREE_ERROR_NO_RESULT 14

// The caller's buffer is too small.
#define TREE_ERROR_BUFFER 15

// A call that cannot be made now, such as freeing a pool that is at work.
#define TREE_ERROR_ORDER 16

// A defect in the library. Please report it with the text.
#define TREE_ERROR_PANIC 17

// Parent of the root: no node.
#define TREE_NO_PARENT 4294967295

// Version of the ABI that this header describes. A library with the same number has every function and
// struct of this header; additions do not change it.
#define TREE_ABI_VERSION 1

// A file in memory.
typedef struct tree_bytes tree_bytes;

// A switch that cancels the calls it was given to.
typedef struct tree_cancel tree_cancel;

// Surfaces with their materials, and the branches that move in the wind.
typedef struct tree_mesh tree_mesh;

// Threads that do the work of the calls it is given to (`tree_control.pool`). What calls make does not
// depend on it. A plug-in that may be unloaded gives every call a pool and frees it before that: the
// threads of calls without a pool never end.
typedef struct tree_pool tree_pool;

// Branches as a rooted tree of nodes with radii.
typedef struct tree_skeleton tree_skeleton;

// A whole tree: skeleton, leaves and species. Every leaf stands on a node that exists and has a kind
// that exists.
typedef struct tree_tree tree_tree;

// A solid, or a combination of solids.
typedef struct tree_volume tree_volume;

// What a function says of itself: `TREE_OK`, or one of the `TREE_ERROR_` codes. New codes may be
// added: treat those you do not know as errors.
typedef int32_t tree_status;

// Told how far a call has come: what is being done (UTF-8, NUL at the end, valid during the call) and
// the share of the whole that is done, 0 to 1. Returns 0 to go on, anything else to cancel. Called from
// whichever thread does the work, one call at a time or several; must not unwind.
typedef int32_t (*tree_progress_fn)(void *user, const char *stage, float fraction);

// Caps for one call: over the cap is `TREE_ERROR_LIMIT`, before the memory is asked for. Begin with
// `tree_limits_init` or `tree_limits_for_memory`.
typedef struct tree_limits {
    // `sizeof(tree_limits)`.
    size_t struct_size;
    // Nodes of a skeleton. Default 20 million.
    uint64_t nodes;
    // Nodes of all search graphs of one model together. Default 20 million.
    uint64_t graph_nodes;
    // Arcs of one search graph. Default 300 million.
    uint64_t graph_arcs;
    // Leaves of one tree. Default 20 million.
    uint64_t leaves;
    // Cells of a three-dimensional grid. Default 512³.
    uint64_t voxels;
    // Pixels of a picture, supersamples included. Default 16,384².
    uint64_t pixels;
    // Triangles of one mesh. Default 100 million.
    uint64_t triangles;
    // Bytes of an input file. Default 1 GiB.
    uint64_t input_bytes;
} tree_limits;

// How a call is done. Begin with `tree_control_init`.
typedef struct tree_control {
    // `sizeof(tree_control)`.
    size_t struct_size;
    // Told of progress. Default NULL.
    tree_progress_fn progress;
    // Handed to `progress`.
    void *user;
    // Cancels the call from any thread. Default NULL.
    const struct tree_cancel *cancel;
    // Caps on what the call may use. Default NULL: those of `tree_limits_init`.
    const struct tree_limits *limits;
    // Threads that do the work. Default NULL: one for each core, shared by all calls.
    const struct tree_pool *pool;
} tree_control;

// The host's allocator. Its functions are called from any thread and must not call the library.
typedef struct tree_allocator {
    // `sizeof(tree_allocator)`.
    size_t struct_size;
    // Handed to the functions.
    void *user;
    // `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
    void *(*alloc)(void *user, size_t size, size_t align);
    // Gives back what `alloc` gave for this size and alignment.
    void (*free)(void *user, void *block, size_t size, size_t align);
} tree_allocator;

// What the host runs on one of its threads: `run(worker)`, once. It returns when the pool is freed.
typedef void (*tree_worker_fn)(void *worker);

// Asks the host for a thread that calls `run(worker)`, on any thread but the asking one. Returns 0 when
// it will, anything else when it cannot (then `run` must not be called).
typedef int32_t (*tree_spawn_fn)(void *user, tree_worker_fn run, void *worker);

// Which threads a pool has. Begin with `tree_pool_options_init`.
typedef struct tree_pool_options {
    // `sizeof(tree_pool_options)`.
    size_t struct_size;
    // Number of threads, at most 1024. Default 0: one for each core.
    uint32_t n_threads;
    // Bytes of stack of each thread that the library starts. Default 0: the system's.
    size_t stack_size;
    // Gives the pool the host's own threads, for instance long-running jobs of its job system, each for
    // the pool's whole life. Default NULL: the library starts threads.
    tree_spawn_fn spawn;
    // Handed to `spawn`.
    void *user;
} tree_pool_options;

// A skeleton's columns: as input, or as a view of a `tree_skeleton`.
typedef struct tree_skeleton_columns {
    // `sizeof(tree_skeleton_columns)`.
    size_t struct_size;
    // Number of nodes, at least 1.
    size_t n_nodes;
    // Three floats for each node: where it is, in metres.
    const float *positions;
    // One for each node: radius of the wood in metres, 0 or more.
    const float *radii;
    // One for each node: the node it stands on, or `TREE_NO_PARENT` for the root.
    const uint32_t *parents;
} tree_skeleton_columns;

// Leaves in columns, a row for each blade (leaflet, needle): as input, or as a view of a tree's.
typedef struct tree_foliage {
    // `sizeof(tree_foliage)`.
    size_t struct_size;
    // Number of rows.
    size_t n_leaves;
    // One for each leaf: the skeleton's node that bears it.
    const uint32_t *nodes;
    // Three floats for each leaf: the base of the blade, in metres.
    const float *positions;
    // Four floats for each leaf: the quaternion x, y, z, w that turns the leaf's own frame (midrib
    // along +Y, upper face to +Z) into the tree's.
    const float *rotations;
    // One for each leaf: length from base to apex in metres, 0 or more.
    const float *sizes;
    // One for each leaf: its kind, an index into the species' leaf kinds.
    const uint16_t *kinds;
} tree_foliage;

// A text in UTF-8. As input, `len` may be `TREE_NUL_TERMINATED` and `data` NULL for an empty text. As
// output it is borrowed, and no NUL byte need follow it.
typedef struct tree_str {
    // The first byte.
    const char *data;
    // Number of bytes.
    size_t len;
} tree_str;

// What kind of tree it is. Built-in looks go by these names; see `tree_bark_names` and
// `tree_leaf_names`.
typedef struct tree_species {
    // `sizeof(tree_species)`.
    size_t struct_size;
    // Name for people and files.
    struct tree_str name;
    // Name of the bark.
    struct tree_str bark;
    // Names of the leaf kinds.
    const struct tree_str *leaf_kinds;
    // Number of leaf kinds.
    size_t n_leaf_kinds;
} tree_species;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// What went wrong in this thread's last call that failed, in UTF-8 and with a NUL at the end: what was
// wrong, where, and what would be right. Empty before any call failed. Never NULL; valid until the next
// call that fails in this thread.
const char *tree_error_text(void);

// The code of this thread's last call that failed; `TREE_OK` before any did.
tree_status tree_error_status(void);

// Forgets this thread's last error, and gives its memory back.
void tree_error_clear(void);

// Name of a status, such as `TREE_ERROR_NULL`. Never NULL, and valid for ever.
const char *tree_status_name(tree_status status);

// Makes `control`, of `size` bytes, the default.
tree_status tree_control_init(struct tree_control *control, size_t size);

// Makes `limits`, of `size` bytes, the default.
tree_status tree_limits_init(struct tree_limits *limits, size_t size);

// Makes `limits`, of `size` bytes, such that one call takes about `bytes` of memory at most; never more
// than the default. `tree_memory_set_budget` does so for all calls together.
tree_status tree_limits_for_memory(struct tree_limits *limits,
                                   size_t size,
                                   uint64_t bytes);

// Makes a switch, not set. Free it with `tree_cancel_free`.
tree_status tree_cancel_new(struct tree_cancel **cancel);

// Sets the switch, from any thread: calls it was given to end with `TREE_ERROR_CANCELLED`, mostly within
// milliseconds. It stays set.
tree_status tree_cancel_set(const struct tree_cancel *cancel);

// Ends a switch. Calls it was given to may still run.
tree_status tree_cancel_free(struct tree_cancel *cancel);

// Views the bytes: where they begin and how many there are.
tree_status tree_bytes_view(const struct tree_bytes *bytes, const uint8_t **data, size_t *len);

// Ends a file in memory.
tree_status tree_bytes_free(struct tree_bytes *bytes);

// Bytes that the library has allocated and not freed, objects and work in progress together.
uint64_t tree_memory_used(void);

// Most bytes in use at one time since the start, or since `tree_memory_reset_peak`.
uint64_t tree_memory_peak(void);

// Lets the peak begin anew at what is in use now.
void tree_memory_reset_peak(void);

// Sets how many bytes the library may have in use, all calls and objects together; 0 for no budget, as
// at the start. A call that would need more fails with `TREE_ERROR_LIMIT` before it takes the memory,
// or with `TREE_ERROR_MEMORY` while it works; what it had taken is free again then. Several calls at
// once may all be told so. Small calls, such as looking at a mesh, never fail.
void tree_memory_set_budget(uint64_t bytes);

// The budget in bytes; 0 when there is none.
uint64_t tree_memory_budget(void);

// Lets the library take its memory from the host's allocator. Only before anything else: once the
// library has memory of its own it is `TREE_ERROR_ORDER`. When `alloc` gives NULL the process aborts, as
// Rust does; set a budget below what the allocator has.
tree_status tree_memory_set_allocator(const struct tree_allocator *allocator);

// Ends a mesh, and with it all views of it.
tree_status tree_mesh_free(struct tree_mesh *mesh);

// Makes `options`, of `size` bytes, the default.
tree_status tree_pool_options_init(struct tree_pool_options *options, size_t size);

// Starts a pool, or asks the host for its threads. `options` may be NULL. Free it with
// `tree_pool_free`. Fails with `TREE_ERROR_NO_RESULT` when a thread cannot be had.
tree_status tree_pool_new(const struct tree_pool_options *options, struct tree_pool **pool);

// Number of threads of a pool.
tree_status tree_pool_threads(const struct tree_pool *pool, uint32_t *n_threads);

// Ends a pool, and returns when its threads are out of the library's code. `TREE_ERROR_ORDER`, and the
// pool lives on, while a call is at work on it.
tree_status tree_pool_free(struct tree_pool *pool);

// Makes a skeleton of columns, which are copied. Node 0 is the root, parents come before their children;
// for rows in another order there is `tree_skeleton_from_unordered`. `control` may be NULL; only its
// limits matter. Free the skeleton with `tree_skeleton_free`.
tree_status tree_skeleton_from_columns(const struct tree_skeleton_columns *columns,
                                       const struct tree_control *control,
                                       struct tree_skeleton **skeleton);

// Makes a skeleton of columns in any order, with the one root anywhere. `rows`, NULL or with room for
// `n_nodes` numbers, gets for each node of the skeleton its row in the columns. Otherwise as
// `tree_skeleton_from_columns`.
tree_status tree_skeleton_from_unordered(const struct tree_skeleton_columns *columns,
                                         const struct tree_control *control,
                                         uint32_t *rows,
                                         struct tree_skeleton **skeleton);

// Views a skeleton's columns. Set `columns->struct_size` first.
tree_status tree_skeleton_view(const struct tree_skeleton *skeleton,
                               struct tree_skeleton_columns *columns);

// The box around all nodes, without their radii: its lower corner, then its upper one, in metres.
tree_status tree_skeleton_bounds(const struct tree_skeleton *skeleton, float (*min_max)[6]);

// Ends a skeleton.
tree_status tree_skeleton_free(struct tree_skeleton *skeleton);

// Makes a tree of a skeleton, which is copied, and columns of leaves (NULL for none), which are copied.
// `species` may be NULL for an oak. `control` may be NULL; only its limits matter. Free the tree with
// `tree_tree_free`.
tree_status tree_tree_new(const struct tree_skeleton *skeleton,
                          const struct tree_foliage *foliage,
                          const struct tree_species *species,
                          const struct tree_control *control,
                          struct tree_tree **tree);

// The tree's skeleton, not copied. Free it with `tree_skeleton_free`; it may outlive the tree's handle.
tree_status tree_tree_skeleton(const struct tree_tree *tree,
                               struct tree_skeleton **skeleton);

// Views the tree's leaves. Set `foliage->struct_size` first.
tree_status tree_tree_foliage(const struct tree_tree *tree, struct tree_foliage *foliage);

// Views the tree's species. Set `species->struct_size` first.
tree_status tree_tree_species(const struct tree_tree *tree, struct tree_species *species);

// Ends a tree.
tree_status tree_tree_free(struct tree_tree *tree);

// The library's own `TREE_ABI_VERSION`: hold it against the header's before anything else.
uint32_t tree_abi_version(void);

// The library's version, such as `0.1.0`. Valid for ever.
const char *tree_version(void);

// Number of objects alive, of all kinds: for tests that look for leaks. Presets and their parts, which
// are never freed, do not count.
size_t tree_live_objects(void);

// Ends a volume. What was made of it lives on.
tree_status tree_volume_free(struct tree_volume *volume);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TREE_H */
