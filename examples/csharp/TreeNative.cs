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
    /// The branches of a chain of modules or of a skeleton, with their modules, lengths and children (the paper's *tree
    /// abstract data type*). Branch 0 is the root, and parents come before their children.
    /// </summary>
    public struct tree_adt { }

    /// <summary>
    /// Cameras for several views of one tree.
    /// </summary>
    public struct tree_aligned { }

    /// <summary>
    /// Places that branches found.
    /// </summary>
    public struct tree_arranged { }

    /// <summary>
    /// Main branches in one picture, as a forest whose roots are at the tree's base.
    /// </summary>
    public struct tree_attractor { }

    /// <summary>
    /// All axes of a skeleton. An axis starts where it leaves another and runs to a tip.
    /// </summary>
    public struct tree_axes { }

    /// <summary>
    /// Which pixels a mesh covers: one bit for each. A bit is set where a triangle covers the middle of the pixel
    /// and the texture's alpha there is drawn. (`tree_mask` tells how much of each pixel is covered; this one is
    /// for comparing, and fast.)
    /// </summary>
    public struct tree_bits { }

    /// <summary>
    /// The bumps of an outline.
    /// </summary>
    public struct tree_bumps { }

    /// <summary>
    /// A file in memory.
    /// </summary>
    public struct tree_bytes { }

    /// <summary>
    /// A switch that cancels the calls it was given to.
    /// </summary>
    public struct tree_cancel { }

    /// <summary>
    /// Collision capsules of a tree.
    /// </summary>
    public struct tree_capsules { }

    /// <summary>
    /// What is drawn of a tree's leaves, and which boxes are open: one for each instance, kept from frame to frame.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it is `TREE_ERROR_ORDER`.
    /// </summary>
    public struct tree_card_choice { }

    /// <summary>
    /// Six diagonal planes for each box, with pictures of its leaves, in two atlases (Lluch et al. 2010, 4.2.2).
    /// </summary>
    public struct tree_cards { }

    /// <summary>
    /// The voxels that a tree may fill, and what they begin with.
    /// </summary>
    public struct tree_carved { }

    /// <summary>
    /// Triangles of a surface that cross each other.
    /// </summary>
    public struct tree_crossings { }

    /// <summary>
    /// A crown: polygons in the plan, and the solid they stand for. At every height each stretch of the inside is swept to
    /// a circle (or an ellipse, by the depth) about its own middle.
    /// </summary>
    public struct tree_crown { }

    /// <summary>
    /// Directions on a grid of cells over a picture.
    /// </summary>
    public struct tree_direction_field { }

    /// <summary>
    /// A drawing: strokes in the order they were drawn, in any units, y downwards as on screens and in SVG.
    /// </summary>
    public struct tree_drawing { }

    /// <summary>
    /// Drawings of one file.
    /// </summary>
    public struct tree_drawings { }

    /// <summary>
    /// The elements of a mesh: what is dropped and scaled as one, such as a leaf or a card. There is always at
    /// least one.
    /// </summary>
    public struct tree_elements { }

    /// <summary>
    /// The equations A x = b of a density: for each ray the densities x of the voxels on it, times its length in
    /// them in metres, add up to -ln of the transparency seen. Wanted is the x &gt;= 0 with the least
    /// |A x - b|^2 + lambda^2 |x / weights|^2.
    /// </summary>
    public struct tree_equations { }

    /// <summary>
    /// The factor graph of a sketch (Neubert 2012, section 4.5.1): what any depths and labels are worth. Segments are
    /// numbered generation by generation, as in a `tree_inferred` of the same plan.
    /// </summary>
    public struct tree_factor_graph { }

    /// <summary>
    /// Leaves found in a mesh, and their kinds.
    /// </summary>
    public struct tree_found_leaves { }

    /// <summary>
    /// Columns for a glTF file.
    /// </summary>
    public struct tree_gltf_attributes { }

    /// <summary>
    /// Leaves of a tree, one small mesh for each kind and where its copies stand.
    /// </summary>
    public struct tree_gltf_leaves { }

    /// <summary>
    /// An L-system's grammar: alphabet, axiom, productions, and rules of decomposition and interpretation.
    /// </summary>
    public struct tree_grammar { }

    /// <summary>
    /// An undirected graph with costs.
    /// </summary>
    public struct tree_graph { }

    /// <summary>
    /// Nodes strewn in a volume, ready to be linked.
    /// </summary>
    public struct tree_graph_nodes { }

    /// <summary>
    /// Numbers on a regular grid of cubic voxels. The number of a voxel is that at its centre. Densities are
    /// optical depth per metre: looking through d metres of density x shows a matte of 1 - exp(-x d).
    /// </summary>
    public struct tree_grid { }

    /// <summary>
    /// A surface around a plant: closed, facing outwards, in several pieces where points are far apart.
    /// </summary>
    public struct tree_hull { }

    /// <summary>
    /// A tree for all distances: its wood has levels that are prefixes, its leaves are drawn as they are or by pictures of
    /// boxes of them.
    /// </summary>
    public struct tree_hybrid { }

    /// <summary>
    /// What is drawn of an instance of a hybrid model, kept from frame to frame. It keeps the model alive.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it is `TREE_ERROR_ORDER`.
    /// </summary>
    public struct tree_hybrid_choice { }

    /// <summary>
    /// A sketch in space: what was inferred of it.
    /// </summary>
    public struct tree_inferred { }

    /// <summary>
    /// Boxes along the branches of a tree (Lluch et al. 2010, 4.2.1), that of the whole tree first: which leaves are seen
    /// as one, and an order of the leaves in which those of each box are one range. Parents come before their children,
    /// which lie side by side.
    /// </summary>
    public struct tree_leaf_boxes { }

    /// <summary>
    /// The mesh of one leaf: one sheet, without petiole. For engines that instance leaves themselves, and to
    /// see how much of its triangles is visible.
    /// </summary>
    public struct tree_leaf_model { }

    /// <summary>
    /// A drawn leaf in its own plane: base at the origin, tip at (0, 1), in triangles. Multiplied by the leaf's length it is in
    /// metres.
    /// </summary>
    public struct tree_leaf_outline { }

    /// <summary>
    /// Lines of text, for people: warnings, mostly. There may be none.
    /// </summary>
    public struct tree_lines { }

    /// <summary>
    /// Best scale and quality of a model for each share of geometry: rows with rising lambda, the last of which
    /// is the full model.
    /// </summary>
    public struct tree_lod_table { }

    /// <summary>
    /// What a species looks like: a material for the bark, and a leaf look for each leaf kind.
    /// </summary>
    public struct tree_look { }

    /// <summary>
    /// How much of each pixel a mesh covers.
    /// </summary>
    public struct tree_mask { }

    /// <summary>
    /// How much of each pixel of a photograph the tree covers, 0 (nothing) to 1 (all).
    /// </summary>
    public struct tree_matte { }

    /// <summary>
    /// Surfaces with their materials, and the branches that move in the wind.
    /// </summary>
    public struct tree_mesh { }

    /// <summary>
    /// A sum of metaballs (Neubert 2012, 7.3.1): every point adds `(1 - (distance / radius)^2)^2` to the places within
    /// its radius. 1 or more at each point, 0 far from all.
    /// </summary>
    public struct tree_metaballs { }

    /// <summary>
    /// The middle lines of a filled area.
    /// </summary>
    public struct tree_midlines { }

    /// <summary>
    /// A picture and its smaller levels, for a texture that is alpha-tested.
    /// </summary>
    public struct tree_mips { }

    /// <summary>
    /// The modules of a chain, most relevant branches first. Its first levels are a prefix, and each prefix that ends with a
    /// level is drawn by a turtle that knows `SAVE` and `RESTORE`.
    /// </summary>
    public struct tree_multi_chain { }

    /// <summary>
    /// Tubes and leaves in the order of their paths: the mesh of a level is a prefix of each index buffer, and a shader lets
    /// the path that comes next grow out of its fork.
    /// </summary>
    public struct tree_multi_mesh { }

    /// <summary>
    /// All branches, cut into paths: each begins at the root, or stems from a path before it. The first few show the
    /// tree's structure best.
    /// </summary>
    public struct tree_multi_paths { }

    /// <summary>
    /// A tree with its nodes and leaves sorted path by path: its first levels are its coarser forms, and a level is no more
    /// than a number. It is as large as the tree, and 8 bytes a level more.
    /// </summary>
    public struct tree_multires { }

    /// <summary>
    /// An octahedral impostor: a whole tree as pictures from all sides, with depths (Brucks 2018), for trees far away.
    /// </summary>
    public struct tree_octahedral { }

    /// <summary>
    /// A closed outline in metres, x to the right, y up: a polygon without crossings, against the clock.
    /// </summary>
    public struct tree_outline { }

    /// <summary>
    /// A drawing of outlines: the strokes of one tree or several, each of a level. Nothing is scaled: coordinates are those of
    /// the drawing or pixels, y downwards.
    /// </summary>
    public struct tree_outline_drawing { }

    /// <summary>
    /// A tree in the plane, level in level: trunk and crown, branches with the outlines of their foliage, their own branches
    /// where those were drawn, the leaf. In metres, x to the right, y up, the trunk's base near the origin.
    /// </summary>
    public struct tree_outline_plan { }

    /// <summary>
    /// A surface in the axes and the layout of an engine.
    /// </summary>
    public struct tree_packed { }

    /// <summary>
    /// A photograph: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
    /// </summary>
    public struct tree_photo { }

    /// <summary>
    /// A tree in the making: photographs, parameters, and what has been made of them so far.
    ///
    /// Every stage can be asked for by itself. What is there is kept, so that a change redoes only what comes
    /// after it: painting density keeps the branches found in the pictures, another seed keeps density and
    /// fields. A call that fails or is cancelled leaves the session as it was, with the stages done by then.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that
    /// comes while another is at work on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands
    /// out is copied, does not change with it, and outlives it.
    /// </summary>
    public struct tree_photo_session { }

    /// <summary>
    /// A picture: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
    /// </summary>
    public struct tree_picture { }

    /// <summary>
    /// Connected pieces of wood, each followed from its base.
    /// </summary>
    public struct tree_pieces { }

    /// <summary>
    /// A cleaned drawing: its branches as one tree in the plane, the lines of its crown, and what was done to its
    /// strokes.
    /// </summary>
    public struct tree_plan { }

    /// <summary>
    /// Threads that do the work of the calls it is given to (`tree_control.pool`). What calls make does not
    /// depend on it. A plug-in that may be unloaded gives every call a pool and frees it before that: the
    /// threads of calls without a pool never end.
    /// </summary>
    public struct tree_pool { }

    /// <summary>
    /// A drawn profile: radius over height, from the ground up.
    /// </summary>
    public struct tree_profile { }

    /// <summary>
    /// A mesh whose foliage can be drawn at any level: windows of its index buffers (Neubert 2012, chapter 7).
    /// </summary>
    public struct tree_pruned { }

    /// <summary>
    /// A closed surface round an axis, through outlines in planes through it: how far a branch reaches at any azimuth. Its frame
    /// has y along the straight span of the axis from its start, and r across.
    /// </summary>
    public struct tree_revolved { }

    /// <summary>
    /// Numbers of rows: for each node of a skeleton that was made of another the node there that it comes from,
    /// or the tips of a graph; for each row of a tree with levels the row of the tree it was made of.
    /// </summary>
    public struct tree_rows { }

    /// <summary>
    /// Tree models, and where they stand (Neubert 2012, 7.2.5 and 7.4). Make one `tree_scene_state` for each view of it.
    /// In each frame `tree_scene_state_select` finds what is drawn and how finely, and `tree_scene_state_draws` or
    /// `tree_scene_state_batches` write it into your own buffers; neither takes memory.
    ///
    /// It is an object that changes, in `tree_scene_set_instances` alone: a call that comes while that one is at
    /// work, or the other way round, is `TREE_ERROR_ORDER`. Any number of threads may select in it at once, each
    /// with a state of its own.
    /// </summary>
    public struct tree_scene { }

    /// <summary>
    /// Levels of a pruned model, for a `tree_scene_model`.
    /// </summary>
    public struct tree_scene_levels { }

    /// <summary>
    /// What one view of a scene (a camera, or a cascade of a shadow map) remembers from frame to frame, and all the
    /// room that a frame needs.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it is `TREE_ERROR_ORDER`.
    /// </summary>
    public struct tree_scene_state { }

    /// <summary>
    /// The triangles of a mesh, welded and sorted into connected components, each of which is wood, a leaf, a
    /// body of leaves or nothing. It holds copies of the parts.
    /// </summary>
    public struct tree_separation { }

    /// <summary>
    /// A tree being drawn: trunk, crown, outlines of branches, leaf. Strokes are in metres, y up, the trunk's base near
    /// the origin. The plan in the plane is ready after each edit; the tree in space is made when it is asked for.
    ///
    /// Branches are named by ids, which are above 0 and stay for as long as the branch is there. An edit is done whole or not
    /// at all, and can be undone.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
    /// and outlives it.
    /// </summary>
    public struct tree_silhouette { }

    /// <summary>
    /// What an edit of a `tree_silhouette` changed.
    /// </summary>
    public struct tree_silhouette_change { }

    /// <summary>
    /// Branches as a rooted tree of nodes with radii.
    /// </summary>
    public struct tree_skeleton { }

    /// <summary>
    /// Branch segments from fork to fork, parents first: those of a sketch, or those with what grew on them
    /// (`tree_sketch_branches_propagate`).
    /// </summary>
    public struct tree_sketch_branches { }

    /// <summary>
    /// A sketch on its way to a tree: a drawing, parameters, templates, and what has been made of them so far.
    ///
    /// Every stage can be asked for by itself and is done when its result, or that of a later one, is first asked for.
    /// Edits keep what does not depend on them: once depths have been inferred, strokes can be added and erased and
    /// depths moved, and those of all other branches stay, as do scale, template, Ω and what grew on other branches.
    /// `tree_sketch_session_infer_anew` forgets all of that. A call that fails or is cancelled leaves the session as it
    /// was, with the stages done by then.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
    /// and outlives it.
    /// </summary>
    public struct tree_sketch_session { }

    /// <summary>
    /// Trees that grew of one drawing: at least one.
    /// </summary>
    public struct tree_stand { }

    /// <summary>
    /// Takes the bytes of a stream as they arrive, and gives the tree that they make so far.
    ///
    /// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
    /// on it is `TREE_ERROR_ORDER`.
    /// </summary>
    public struct tree_stream_reader { }

    /// <summary>
    /// Strokes read from a drawing, a session's branches as strokes, or outlines.
    /// </summary>
    public struct tree_strokes { }

    /// <summary>
    /// What an SWC file held: a skeleton, and what a skeleton has no column for.
    /// </summary>
    public struct tree_swc { }

    /// <summary>
    /// Kinds of tree to guide a reconstruction by.
    /// </summary>
    public struct tree_templates { }

    /// <summary>
    /// A picture, shared by materials and meshes: RGBA, 8 bits, sRGB, straight alpha.
    /// </summary>
    public struct tree_texture { }

    /// <summary>
    /// Triangles that elements are drawn with: the full model first, then with fewer and fewer triangles of nearly the
    /// same outlines. All are of the model's own vertices.
    /// </summary>
    public struct tree_tiers { }

    /// <summary>
    /// What particles left behind: traces that join on their way to the base.
    /// </summary>
    public struct tree_traces { }

    /// <summary>
    /// A whole tree: skeleton, leaves and species. Every leaf stands on a node that exists and has a kind
    /// that exists.
    /// </summary>
    public struct tree_tree { }

    /// <summary>
    /// What is known of each pixel of a photograph.
    /// </summary>
    public struct tree_trimap { }

    /// <summary>
    /// What a turtle drew beside the tree: filled polygons; and the symbols that said nothing to it.
    /// </summary>
    public struct tree_turtle_trace { }

    /// <summary>
    /// A tree as a base mesh and a few unique twigs, set down many times: at a tenth of its memory and less.
    /// </summary>
    public struct tree_twigs { }

    /// <summary>
    /// What a layout holds of each vertex, back in our axes, metres and winding.
    /// </summary>
    public struct tree_unpacked { }

    /// <summary>
    /// A solid, or a combination of solids. Plain solids contain their surface; revolutions and meshes
    /// contain one side of it, so that solids set side by side share no point there.
    /// </summary>
    public struct tree_volume { }

    /// <summary>
    /// The way to the base from everywhere in a density.
    /// </summary>
    public struct tree_way { }

    /// <summary>
    /// The branches of a skeleton, as the wind sees them.
    /// </summary>
    public struct tree_wind_branches { }

    /// <summary>
    /// A string of modules with their parameters, such as `F(1)[+(30)F(0.5)]`, and the alphabet of their kinds.
    /// </summary>
    public struct tree_word { }

    /// <summary>
    /// Told how far a call has come: what is being done (UTF-8, NUL at the end, valid during the call) and
    /// the share of the whole that is done, 0 to 1. Returns 0 to go on, anything else to cancel. Called from
    /// whichever thread does the work, one call at a time for each call of the library; must not unwind.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int tree_progress_fn(void* user, byte* stage, float fraction);

    /// <summary>
    /// How densely leaves or twigs stand at `position`, three floats in metres: 0 none, 1 as the parameters
    /// say, 2 twice as many, up to `TREE_DENSITY_CAP`. Less than 1 is the chance that a place bears; whorls stay whole.
    /// Negative and not a number count as 0 and are reported. Asked once for each place, from any thread and
    /// from several at a time; must give the same answer for the same place, and must not unwind.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate float tree_density_fn(void* user, float* position);

    /// <summary>
    /// `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void* tree_allocator_allocate(void* user, UIntPtr size, UIntPtr align);

    /// <summary>
    /// Gives back what `allocate` gave for this size and alignment.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void tree_allocator_release(void* user, void* block, UIntPtr size, UIntPtr align);

    /// <summary>
    /// How much more points are wanted at `position`, three floats in metres, than the density says: 1 as much,
    /// 0 none. Negative and not a number count as 0. Asked once for the centre of each voxel that is not empty,
    /// from any thread and from several at a time; must give the same answer for the same place, and must not
    /// unwind.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate float tree_weight_fn(void* user, float* position);

    /// <summary>
    /// The share of the direction towards the nearest branch, 0 to 1, at a distance as a share of the picture's
    /// height. Not a number counts as 0. Called from any thread, by several at once; must give the same answer
    /// for the same distance, and must not unwind.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate float tree_blend_fn(void* user, float distance);

    /// <summary>
    /// A cost factor for a point in space, three floats in metres: finite and 0 or more, or the call fails
    /// with `TREE_ERROR_PARAMETER`. Called from any thread, by several at once; must not unwind. For the same
    /// tree each time it must give the same answer to the same point.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate float tree_cost_fn(void* user, float* point);

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
    /// How the radii of a whole skeleton are found. Begin with `tree_radius_rule_init`. No rule makes a
    /// branch thicker than the one below.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_radius_rule
    {
        /// <summary>
        /// `sizeof(tree_radius_rule)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// `TREE_STRANDS_BY_ANGLE`: strands at the base, from the number of tips to 2⁵³. No default: 0,
        /// which is refused.
        /// </summary>
        public ulong strand_base;
        /// <summary>
        /// Which rule. Default `TREE_RADII_PIPE`.
        /// </summary>
        public uint kind; // tree_radius_kind
        /// <summary>
        /// Pipe: Δ in r₀^Δ = Σ rᵢ^Δ, 1 to 10. Default 2.49, Murray's; da Vinci's is 2, Mandelbrot's 8/3. A
        /// larger one makes the trunk thinner for the same tips.
        /// </summary>
        public float exponent;
        /// <summary>
        /// Pipe: radius of every tip in metres, 1e-6 to 100. Default 0.002. With a `trunk_radius` only its
        /// proportion to `taper` matters.
        /// </summary>
        public float tip_radius;
        /// <summary>
        /// Pipe: how much the radius grows per metre towards the base, 0 to 1. Default 0.002: a bare shoot
        /// of one metre is twice as thick at its base as at its tip.
        /// </summary>
        public float taper;
        /// <summary>
        /// Pipe: radius of the root node in metres, 1e-6 to 100: all radii, those of tips too, are
        /// multiplied by the one factor that makes it so. Default 0: the tips decide.
        /// </summary>
        public float trunk_radius;
        /// <summary>
        /// Tip distance: radius on the trunk one metre from the tip, in metres, 1e-6 to 100. Default 0.05.
        /// </summary>
        public float scale;
        /// <summary>
        /// Tip distance: the power of the distance, 0 to 10. Default 0.3. The larger, the quicker branches
        /// taper.
        /// </summary>
        public float zeta;
        /// <summary>
        /// Tip distance: smallest radius of any node in metres, 0 to 100. Default 0.001. With 0 a branch
        /// ends in a point.
        /// </summary>
        public float min_radius;
        /// <summary>
        /// Strands: diameter of a branch of one strand in metres, 1e-6 to 100; one of S strands has √S
        /// times that. Default 0.004.
        /// </summary>
        public float strand_diameter;
        /// <summary>
        /// Strands: where their number comes from. Default `TREE_STRANDS_PER_TIP`.
        /// </summary>
        public uint strand_count; // tree_strand_count
    }

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
        /// <summary>
        /// Modules of a derived L-system word. Default 100 million.
        /// </summary>
        public ulong modules;
        /// <summary>
        /// Pairs of nodes kept while two trees are compared. Default 150 million.
        /// </summary>
        public ulong pairs;
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
    /// What follows from a row of the table of branches.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branch_motion
    {
        /// <summary>
        /// `sizeof(tree_branch_motion)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Share of the wind's full turn that it makes, 0 to 1.
        /// </summary>
        public float give;
        /// <summary>
        /// Its lowest natural frequency in hertz, as a bare, clamped, uniform rod of green wood; leaves make
        /// it slower, taper faster. Infinite for a branch without length.
        /// </summary>
        public float frequency;
        /// <summary>
        /// The direction it swings in: a unit vector square to the axis, another one for each phase.
        /// </summary>
        public fixed float swing[3];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A branch as the wind sees it: a rod that turns about its pivot, carried by its parent. Has no
    /// `struct_size`: it is a row of a table, and never changes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_wind_branch
    {
        /// <summary>
        /// The branch that carries this one; itself for the trunk. Parents come first.
        /// </summary>
        public uint parent;
        /// <summary>
        /// 0 for the trunk, one more than the parent otherwise.
        /// </summary>
        public uint level;
        /// <summary>
        /// Where it is attached: the point it turns about, in metres.
        /// </summary>
        public fixed float pivot[3];
        /// <summary>
        /// Unit vector from pivot to tip.
        /// </summary>
        public fixed float axis[3];
        /// <summary>
        /// Length along its bends in metres.
        /// </summary>
        public float length;
        /// <summary>
        /// Radius at the base in metres.
        /// </summary>
        public float radius;
        /// <summary>
        /// Distance from the pivot, in metres, up to which wood moves with the parent.
        /// </summary>
        public float collar;
        /// <summary>
        /// Where in the swing it starts, 0 to 1: so that branches do not move in step.
        /// </summary>
        public float phase;
        /// <summary>
        /// 1 does not give at all, 0 hangs in the wind: 1 / (1 + (length / radius / 100)³).
        /// </summary>
        public float stiffness;
    }

    /// <summary>
    /// How capsules are made. Begin with `tree_capsule_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_capsule_params
    {
        /// <summary>
        /// `sizeof(tree_capsule_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Most capsules, 1 to 4096. Default 32.
        /// </summary>
        public uint count_max;
        /// <summary>
        /// Wood thinner than this is passed over, in metres, 0 to 10. Default 0.05. When nothing is as
        /// thick, half the radius of the thickest wood is taken instead, so that saplings collide as well.
        /// </summary>
        public float radius_min;
        /// <summary>
        /// Share of the volume of the other wood that must lie inside, 0 to 1. Default 0.95.
        /// </summary>
        public float share;
        /// <summary>
        /// Which child goes on at a fork. Default `TREE_CONTINUATION_THICKEST`.
        /// </summary>
        public uint continuation; // tree_continuation
    }

    /// <summary>
    /// How well capsules fit.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_capsule_report
    {
        /// <summary>
        /// `sizeof(tree_capsule_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of capsules.
        /// </summary>
        public ulong n_capsules;
        /// <summary>
        /// Volume of the wood above the radius, in cubic metres: the sum of its frusta.
        /// </summary>
        public double volume;
        /// <summary>
        /// Share of that volume that lies in a capsule, 0 to 1, as measured; 1 when there is no wood.
        /// </summary>
        public double held;
        /// <summary>
        /// Volume of the capsules, those that overlap counted twice, over that of the wood they hold; 1 would
        /// be perfect. 0 when there is no wood.
        /// </summary>
        public double bulk;
        /// <summary>
        /// The radius above which wood counted, in metres.
        /// </summary>
        public float radius_min;
        /// <summary>
        /// Whether `held` reaches the share asked for.
        /// </summary>
        public uint is_enough;
    }

    /// <summary>
    /// A cylinder with round ends.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_capsule
    {
        /// <summary>
        /// Middle of one end, in metres.
        /// </summary>
        public fixed float a[3];
        /// <summary>
        /// Middle of the other end.
        /// </summary>
        public fixed float b[3];
        /// <summary>
        /// Radius in metres.
        /// </summary>
        public float radius;
    }

    /// <summary>
    /// What a convention says.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_convention_traits
    {
        /// <summary>
        /// `sizeof(tree_convention_traits)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Length units in one metre.
        /// </summary>
        public float unit;
        /// <summary>
        /// Whether the axes form a left hand.
        /// </summary>
        public uint is_left_handed;
        /// <summary>
        /// Whether front faces run clockwise, so that triangles must be turned.
        /// </summary>
        public uint is_clockwise;
        /// <summary>
        /// Whether texture v runs upwards.
        /// </summary>
        public uint is_v_up;
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
    /// One attribute of all vertices. Rows of an array; the array belongs to a `tree_packed`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stream
    {
        /// <summary>
        /// The engine's name for it.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// `components` numbers for each vertex, tightly packed, in the machine's order of bytes.
        /// </summary>
        public void* data;
        /// <summary>
        /// Number of bytes.
        /// </summary>
        public UIntPtr n_bytes;
        /// <summary>
        /// Numbers of one vertex, 1 to 4.
        /// </summary>
        public uint components;
        /// <summary>
        /// What the numbers are.
        /// </summary>
        public uint number; // tree_number
    }

    /// <summary>
    /// A view of a `tree_packed`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_packed_columns
    {
        /// <summary>
        /// `sizeof(tree_packed_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The layout.
        /// </summary>
        public uint layout; // tree_layout
        /// <summary>
        /// Whose axes the numbers are in.
        /// </summary>
        public uint convention; // tree_convention
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Bytes of one vertex, all streams together.
        /// </summary>
        public UIntPtr vertex_bytes;
        /// <summary>
        /// The attributes, each with a row for every vertex. None for `TREE_LAYOUT_VERTEX`.
        /// </summary>
        public tree_stream* streams;
        /// <summary>
        /// Number of streams.
        /// </summary>
        public UIntPtr n_streams;
        /// <summary>
        /// Three for each triangle, wound as the engine has its front faces: `uint16_t` or `uint32_t`.
        /// </summary>
        public void* indices;
        /// <summary>
        /// Number of indices.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Bytes of one index: 2 for at most 65,535 vertices, so that no index is 0xFFFF, or 4.
        /// </summary>
        public uint index_bytes;
        /// <summary>
        /// `TREE_LAYOUT_SPEEDTREE9`: `_ST_BranchStretchLimits`, the longest free lengths of branches 1 and 2
        /// in metres, the same for all surfaces of a mesh. Else 0.
        /// </summary>
        public fixed float stretch_limits[2];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// The textures of `TREE_LAYOUT_PIVOT_PAINTER`, the same for all surfaces of a mesh. Elements lie in rows
    /// from the top left, as their branches do in the table; the trunk is its own parent.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pivots
    {
        /// <summary>
        /// `sizeof(tree_pivots)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in texels, a power of two.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in texels, a power of two.
        /// </summary>
        public uint height;
        /// <summary>
        /// Four floats for each texel, row by row from the top: the pivot in centimetres, in Unreal's axes,
        /// and the parent's number as a float whose half has the bits number + 1024.
        /// </summary>
        public float* position_and_index;
        /// <summary>
        /// The same as halves; the parents' numbers are exact in them too.
        /// </summary>
        public ushort* position_and_index_half;
        /// <summary>
        /// Four bytes for each texel: (axis + 1) / 2, and extent / 2048 cm.
        /// </summary>
        public byte* axis_and_extent;
        /// <summary>
        /// One for each branch of the mesh: its element, or that of the branch it became part of.
        /// </summary>
        public uint* element_of;
        /// <summary>
        /// Number of branches.
        /// </summary>
        public UIntPtr n_branches;
        /// <summary>
        /// Texels in use.
        /// </summary>
        public UIntPtr n_elements;
        /// <summary>
        /// Branches that became part of the one that carries them, since they lie too deep.
        /// </summary>
        public UIntPtr n_merged;
        /// <summary>
        /// Levels of the mesh.
        /// </summary>
        public uint levels;
        /// <summary>
        /// Levels that are left, at most 4: as many as Epic's material functions follow.
        /// </summary>
        public uint kept_levels;
    }

    /// <summary>
    /// A texel of the pivot textures, read back as the shader does, in our axes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pivot_element
    {
        /// <summary>
        /// `sizeof(tree_pivot_element)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The element that carries it; itself for the trunk.
        /// </summary>
        public uint parent;
        /// <summary>
        /// Pivot in metres.
        /// </summary>
        public fixed float pivot[3];
        /// <summary>
        /// Axis, a unit vector.
        /// </summary>
        public fixed float axis[3];
        /// <summary>
        /// Length in metres, 0.08 to 20.48.
        /// </summary>
        public float extent;
    }

    /// <summary>
    /// A view of a `tree_unpacked`. A column is NULL when the layout has no place for it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_unpacked_columns
    {
        /// <summary>
        /// `sizeof(tree_unpacked_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Three floats for each vertex: positions in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Three floats for each vertex: normals.
        /// </summary>
        public float* normals;
        /// <summary>
        /// Four floats for each vertex: tangents, in the fourth the sign.
        /// </summary>
        public float* tangents;
        /// <summary>
        /// Two floats for each vertex: texture coordinates.
        /// </summary>
        public float* uvs;
        /// <summary>
        /// Two floats for each vertex: light-map coordinates.
        /// </summary>
        public float* uvs2;
        /// <summary>
        /// Three for each triangle.
        /// </summary>
        public uint* indices;
        /// <summary>
        /// Number of indices.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Ambient occlusion.
        /// </summary>
        public float* occlusion;
        /// <summary>
        /// The branch, its number in the table; for `TREE_LAYOUT_PIVOT_PAINTER` its element.
        /// </summary>
        public uint* branches;
        /// <summary>
        /// The branch, or element, that carries it.
        /// </summary>
        public uint* parents;
        /// <summary>
        /// Level of the branch.
        /// </summary>
        public uint* levels;
        /// <summary>
        /// Three floats for each vertex: pivot of the branch.
        /// </summary>
        public float* pivots;
        /// <summary>
        /// Three floats for each vertex: axis of the branch.
        /// </summary>
        public float* axes;
        /// <summary>
        /// Phase of the branch.
        /// </summary>
        public float* phases;
        /// <summary>
        /// Stiffness of the branch.
        /// </summary>
        public float* stiffness;
        /// <summary>
        /// How far along the branch.
        /// </summary>
        public float* reach;
        /// <summary>
        /// How far along the leaf.
        /// </summary>
        public float* flutter;
        /// <summary>
        /// Phase of the leaf.
        /// </summary>
        public float* leaf_phases;
        /// <summary>
        /// Three floats for each vertex: where the leaf is attached.
        /// </summary>
        public float* anchors;
        /// <summary>
        /// Whether the vertex is part of a leaf: 0 or 1.
        /// </summary>
        public byte* is_leaf;
        /// <summary>
        /// Two floats for each vertex: bend weights. SpeedTree 8: branch weight, 0; 9: those of branches 1
        /// and 2; Tree Creator: primary and secondary bend.
        /// </summary>
        public float* weights;
        /// <summary>
        /// Two vectors of three floats for each vertex. SpeedTree 8: swing, growth; 9: directions of
        /// branches 1 and 2.
        /// </summary>
        public float* directions;
    }

    /// <summary>
    /// A vertex of `TREE_LAYOUT_VERTEX`, in our axes. Errors are the largest, rounding of floats (1e-7 of the
    /// largest coordinate) apart. Parent, pivot and axis of a branch stand in the mesh's table of branches,
    /// to be uploaded as a buffer and read by the number of the branch.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_packed_vertex
    {
        /// <summary>
        /// Position: min + (max - min) * position / 65535 of the view's `bounds`. Error: extent / 131,070.
        /// </summary>
        public fixed ushort position[3];
        /// <summary>
        /// Angle about the normal in steps of a turn / 32768, and in the highest bit 1 for a negative sign:
        /// cos * x + sin * cross(n, x), where n is the normal as it is read back and x is (b, s + n.y * n.y *
        /// a, -n.y) with s the sign of n.z (1 or -1), a = -1 / (s + n.z) and b = n.x * n.y * a. Error: 3e-4
        /// radians.
        /// </summary>
        public ushort tangent;
        /// <summary>
        /// Octahedral normal: x and y / 32767, z = 1 - |x| - |y|; where z is negative, x is (1 - |y|) and y
        /// (1 - |x|), each with its old sign; then brought to unit length. Error: 1e-4 radians.
        /// </summary>
        public fixed short normal[2];
        /// <summary>
        /// Texture coordinates over the view's `uv_range`, as positions. Error: range / 131,070.
        /// </summary>
        public fixed ushort uv[2];
        /// <summary>
        /// Light-map coordinates / 65535.
        /// </summary>
        public fixed ushort uv2[2];
        /// <summary>
        /// Number of the branch.
        /// </summary>
        public uint branch;
        /// <summary>
        /// How far along the branch / 65535.
        /// </summary>
        public ushort reach;
        /// <summary>
        /// Ambient occlusion / 255.
        /// </summary>
        public byte occlusion;
        /// <summary>
        /// How far along the leaf / 255.
        /// </summary>
        public byte flutter;
        /// <summary>
        /// Phase of the branch / 255.
        /// </summary>
        public byte phase;
        /// <summary>
        /// Stiffness of the branch / 255.
        /// </summary>
        public byte stiffness;
        /// <summary>
        /// Level of the branch; 255 for more.
        /// </summary>
        public byte level;
        /// <summary>
        /// Phase of the leaf / 255.
        /// </summary>
        public byte leaf_phase;
    }

    /// <summary>
    /// The vertices of `TREE_LAYOUT_VERTEX`, and what a shader needs to read them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_packed_vertices
    {
        /// <summary>
        /// `sizeof(tree_packed_vertices)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The vertices.
        /// </summary>
        public tree_packed_vertex* vertices;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Three floats for each leaf: where it is attached, in metres. The leaf of vertex `i` is
        /// `i / (n_vertices / n_anchors)`.
        /// </summary>
        public float* anchors;
        /// <summary>
        /// Number of leaves; 0 for wood.
        /// </summary>
        public UIntPtr n_anchors;
        /// <summary>
        /// Box of the positions in metres: its lower corner, then its upper one.
        /// </summary>
        public fixed float bounds[6];
        /// <summary>
        /// Smallest, then largest texture coordinates.
        /// </summary>
        public fixed float uv_range[4];
    }

    /// <summary>
    /// A vertex in the wind. All but the anchor lie within 0 to 1.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_vertex_wind
    {
        /// <summary>
        /// The branch it moves with, in the mesh's table; 0 when the mesh has none.
        /// </summary>
        public uint branch;
        /// <summary>
        /// How far along the branch it lies; leaves as far as the place they are attached.
        /// </summary>
        public float reach;
        /// <summary>
        /// Leaves: how far from the anchor, 0 there and 1 at the leaf's farthest vertex. 0 for wood.
        /// </summary>
        public float flutter;
        /// <summary>
        /// Leaves: where in its flutter the leaf starts. 0 for wood.
        /// </summary>
        public float leaf_phase;
        /// <summary>
        /// Leaves: where the leaf is attached. Wood: the vertex itself.
        /// </summary>
        public fixed float anchor[3];
    }

    /// <summary>
    /// A steady wind with gusts. Begin with `tree_wind_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_wind
    {
        /// <summary>
        /// `sizeof(tree_wind)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where it blows to; its length does not matter. Each -1e6 to 1e6; default 1, 0, 0.
        /// </summary>
        public fixed float direction[3];
        /// <summary>
        /// Turn of a branch without any stiffness, in radians, -10 to 10. Default 0.5.
        /// </summary>
        public float strength;
        /// <summary>
        /// Share of the turn that swings to and fro, 0 to 1. Default 0.4.
        /// </summary>
        public float gusts;
        /// <summary>
        /// Swings in a second, 0 to 100. Default 0.5.
        /// </summary>
        public float frequency;
        /// <summary>
        /// How far leaves turn to and fro at their anchors, in radians, -10 to 10. Default 0.3.
        /// </summary>
        public float flutter;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Where leaves stand and how they are held. Lengths in metres, angles in radians. Begin with
    /// `tree_leaf_params_init`, or with a species' own from `tree_foliage_preset`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_params
    {
        /// <summary>
        /// `sizeof(tree_leaf_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How leaves stand along the shoot. Default `TREE_PHYLLOTAXIS_SPIRAL`.
        /// </summary>
        public uint arrangement; // tree_phyllotaxis
        /// <summary>
        /// Spiral: angle from one leaf to the next, -2π to 2π. Default the golden angle, 2.39996.
        /// </summary>
        public float divergence;
        /// <summary>
        /// Whorled: leaves at a node, 3 to 64. No default: 0, which is refused.
        /// </summary>
        public uint whorl;
        /// <summary>
        /// What one leaf consists of. Default `TREE_LEAVES_SIMPLE`.
        /// </summary>
        public uint form; // tree_leaves_form
        /// <summary>
        /// Pinnate: pairs of leaflets, 1 to 100. Default 4.
        /// </summary>
        public uint pinnate_pairs;
        /// <summary>
        /// Pinnate: whether a leaflet ends the rachis. Default 1.
        /// </summary>
        public uint pinnate_odd;
        /// <summary>
        /// Pinnate: length of the rachis above the petiole in lengths of the largest leaflet, 0 to 1000.
        /// Default 2.
        /// </summary>
        public float pinnate_rachis;
        /// <summary>
        /// Pinnate: how far the rachis bends back over its length, -π to π. Default 0.4.
        /// </summary>
        public float pinnate_droop;
        /// <summary>
        /// Pinnate: angle between rachis and leaflets at its base and at its tip, 0 to π. Default 1.2, 0.8.
        /// </summary>
        public fixed float pinnate_angle[2];
        /// <summary>
        /// Pinnate: size of the leaflets at base, middle and tip, 0.01 to 1. Default 0.75, 1, 0.8.
        /// </summary>
        public fixed float pinnate_profile[3];
        /// <summary>
        /// Pinnate: how far leaflets are raised out of the leaf's plane, -π/2 (hanging) to π/2. Default 0.
        /// </summary>
        public float pinnate_fold;
        /// <summary>
        /// Pinnate: length of a leaflet's stalk in lengths of the largest leaflet, 0 to 2. Default 0.03.
        /// </summary>
        public float pinnate_petiolule;
        /// <summary>
        /// Pinnate: pairs of leaflets on each pinna of a leaf that is pinnate twice, up to 50. Default 0:
        /// pinnate once.
        /// </summary>
        public uint pinnate_pinna_pairs;
        /// <summary>
        /// Pinnate twice: length of the longest pinna as a share of the rachis, 0.01 to 2. Default 0.5.
        /// </summary>
        public float pinnate_pinna;
        /// <summary>
        /// Palmate: leaflets, 2 to 64. Default 7.
        /// </summary>
        public uint palmate_leaflets;
        /// <summary>
        /// Palmate: angle from the first leaflet to the last, 0 to 2π. Default 4.
        /// </summary>
        public float palmate_spread;
        /// <summary>
        /// Palmate: size of the outermost leaflets against the middle one, 0.01 to 1. Default 0.55.
        /// </summary>
        public float palmate_outer;
        /// <summary>
        /// Palmate: angle by which leaflets hang below the leaf's plane, -π/2 to π/2. Default 0.2.
        /// </summary>
        public float palmate_droop;
        /// <summary>
        /// Fascicle: needles, 1 to 16. Rosette: needles, 1 to 128. No default: 0, which is refused.
        /// </summary>
        public uint needles;
        /// <summary>
        /// Fascicle: angle between a needle and the axis, 0 to π/2. Rosette: angle between the outermost
        /// needles and the axis, 0 to π. Default 0.
        /// </summary>
        public float needle_spread;
        /// <summary>
        /// Distance between leaf-bearing nodes along the shoot, 1e-4 to 1e6. Default 0.07.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Shoots bear leaves up to this distance from their tip, 0 to 1e6. Default 0.55.
        /// </summary>
        public float bearing;
        /// <summary>
        /// Length of a blade (of a full leaflet or needle where the leaf has many), 1e-6 to 1e6. Default
        /// 0.13.
        /// </summary>
        public float size;
        /// <summary>
        /// Sizes vary by up to this share either way, 0 to 0.9. Default 0.25.
        /// </summary>
        public float size_variation;
        /// <summary>
        /// How much smaller leaves are at the tip than at the lower end of the bearing zone, 0 to 0.9 of
        /// their size; a negative number, down to -0.9, makes those at the lower end smaller. Default 0.
        /// </summary>
        public float size_gradient;
        /// <summary>
        /// Length of the petiole in lengths of the blade, 0 to 100; the blade stands off the shoot by as
        /// much. Default 0: whatever petiole there is belongs to the picture of the leaf.
        /// </summary>
        public float petiole;
        /// <summary>
        /// Radius of the petiole in lengths of the blade, 0 to 0.5; used where stalks are grown too.
        /// Default 0.008.
        /// </summary>
        public float petiole_radius;
        /// <summary>
        /// Angle between shoot and petiole, 0 (along the shoot) to π (back along it). Default 0.9.
        /// </summary>
        public float pitch;
        /// <summary>
        /// Random deviation of all angles, 0 to π. Default 0.35.
        /// </summary>
        public float jitter;
        /// <summary>
        /// How far blades hang: 0 not at all, 1 straight down. The petiole does not hang. Default 0.15.
        /// </summary>
        public float droop;
        /// <summary>
        /// How far upper faces turn to the light by rolling about the midrib: 0 not at all, 1 as far as
        /// that brings them. Default 0.6.
        /// </summary>
        public float phototropism;
        /// <summary>
        /// Largest angle between petiole and blade, 0 to π: after the roll, the blade turns towards the
        /// light by the share `phototropism` of what is left, but no more than this. Default 0: the midrib
        /// goes on as it was.
        /// </summary>
        public float lamina_turn;
        /// <summary>
        /// Where light comes from; any length but 0. Default 0, 1, 0.
        /// </summary>
        public fixed float light[3];
        /// <summary>
        /// Whether each tip bears a leaf that goes on in its direction. Default 1.
        /// </summary>
        public uint terminal;
        /// <summary>
        /// The leaves' kind: an index into the species' leaf kinds, 0 to 65,535. Default 0.
        /// </summary>
        public uint kind;
    }

    /// <summary>
    /// What growing leaves did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_report
    {
        /// <summary>
        /// `sizeof(tree_leaf_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Leaf-bearing nodes of the shoots (a whorl is one, a tip's leaf too).
        /// </summary>
        public ulong n_bearing;
        /// <summary>
        /// Leaves; a compound leaf and a fascicle is one.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Blades: rows of the foliage.
        /// </summary>
        public ulong n_blades;
        /// <summary>
        /// Bearing nodes that the density left out.
        /// </summary>
        public ulong n_thinned;
        /// <summary>
        /// Bearing nodes where the density was negative or not a number, and counted as 0.
        /// </summary>
        public ulong n_bad_density;
        /// <summary>
        /// Axes without a leaf.
        /// </summary>
        public ulong n_barren;
        /// <summary>
        /// Nodes added for petioles and rachises.
        /// </summary>
        public ulong n_stalk_nodes;
    }

    /// <summary>
    /// Where twigs stand, how long they are and how they are held. Lengths in metres, angles in radians.
    /// Begin with `tree_twig_params_init`, or with a species' own from `tree_foliage_preset`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_twig_params
    {
        /// <summary>
        /// `sizeof(tree_twig_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How each twig goes on. Default `TREE_BRANCHING_MONOPODIAL`.
        /// </summary>
        public uint branching; // tree_branching
        /// <summary>
        /// Sympodial: internodes of a module, 1 to 100. Default 1, as linden has.
        /// </summary>
        public uint module_internodes;
        /// <summary>
        /// Sympodial: angle by which the next module turns off, 0 to π. Default 0.
        /// </summary>
        public float module_turn;
        /// <summary>
        /// Sympodial: angle from the side of one turn to that of the next, -2π to 2π. Default π, a zig-zag;
        /// 0 gives a curl, anything between a helix.
        /// </summary>
        public float module_divergence;
        /// <summary>
        /// Sympodial: length of the dead tip that stays where a module ended, in internodes, 0 to 10.
        /// Default 0: it is shed.
        /// </summary>
        public float module_stub;
        /// <summary>
        /// How twigs stand along shoots, and laterals along main twigs. Default `TREE_PHYLLOTAXIS_SPIRAL`.
        /// </summary>
        public uint arrangement; // tree_phyllotaxis
        /// <summary>
        /// Spiral: angle from one twig to the next, -2π to 2π. Default the golden angle, 2.39996.
        /// </summary>
        public float divergence;
        /// <summary>
        /// Whorled: twigs at a node, 3 to 64. No default: 0, which is refused.
        /// </summary>
        public uint whorl;
        /// <summary>
        /// Orders of twigs, 1 (no laterals) to 3. Default 2. Each multiplies the number of nodes.
        /// </summary>
        public uint levels;
        /// <summary>
        /// Twig-bearing nodes per metre of shoot, 1e-3 to 1e4. Default 10.
        /// </summary>
        public float per_metre;
        /// <summary>
        /// Shoots bear twigs up to this distance from their tip, 0 to 1e6. Default 0.6.
        /// </summary>
        public float bearing;
        /// <summary>
        /// Most twigs on one node of the skeleton, 1 to 64; more are left out and reported. Default 4.
        /// </summary>
        public uint crowd;
        /// <summary>
        /// Length of the longest twigs, 1e-5 to 1e6. Default 0.25.
        /// </summary>
        public float length;
        /// <summary>
        /// Lengths vary by up to this share either way, 0 to 0.9. Default 0.25.
        /// </summary>
        public float length_variation;
        /// <summary>
        /// How much shorter twigs are at the tip of the bearing shoot than at the lower end of the bearing
        /// zone, 0 to 1 of their length; a negative number, down to -1, makes the lower ones shorter. Holds
        /// for laterals along their twig too. Default 0.5.
        /// </summary>
        public float taper;
        /// <summary>
        /// Length of the twig that goes on at the tip of a shoot, in lengths of the longest, 0 (none) to 1.
        /// Default 0.6.
        /// </summary>
        public float terminal;
        /// <summary>
        /// Length of laterals against the twig that bears them, 0 to 1. Default 0.45.
        /// </summary>
        public float lateral;
        /// <summary>
        /// Length of an internode, 1e-5 to 1e6; a twig of less than half an internode is left out. Default
        /// 0.03.
        /// </summary>
        public float internode;
        /// <summary>
        /// Angle between a twig and what bears it, 0 to π. Default 0.85.
        /// </summary>
        public float angle;
        /// <summary>
        /// Random deviation of all angles, 0 to π; a quarter of it from one internode to the next. Default
        /// 0.2.
        /// </summary>
        public float jitter;
        /// <summary>
        /// Stiffness of the wood: its modulus of elasticity in gigapascal, 1e-4 to 1e6. Default 4, a green
        /// twig; 0.2 hangs like a weeping willow.
        /// </summary>
        public float stiffness;
        /// <summary>
        /// Weight of leaves and fruit in kilograms per metre of twig, 0 to 1000. Default 0.03.
        /// </summary>
        public float load;
        /// <summary>
        /// How strongly growth turns down, per metre, -1000 to 1000: a twig that points sideways turns by so
        /// many radians a metre. Negative turns up, as most shoots do. Default 0.
        /// </summary>
        public float gravitropism;
        /// <summary>
        /// How strongly growth turns to the light, per metre, -1000 to 1000. Default 0.5.
        /// </summary>
        public float phototropism;
        /// <summary>
        /// Where light comes from; any length but 0. Default 0, 1, 0.
        /// </summary>
        public fixed float light[3];
        /// <summary>
        /// Radius of every twig's tip, 1e-6 to 100. Default 0.0008.
        /// </summary>
        public float tip_radius;
        /// <summary>
        /// How much the radius grows per metre towards the base, 0 to 1. Default 0.003.
        /// </summary>
        public float radius_taper;
        /// <summary>
        /// Exponent of the pipe model where laterals leave, 1 to 10. Default 2.49.
        /// </summary>
        public float pipe_exponent;
        /// <summary>
        /// Thickest a twig may be at its base, as a share of the radius of what bears it there, 0 to 1; a
        /// thicker one is made thinner as a whole. Default 0.75.
        /// </summary>
        public float radius_share;
        /// <summary>
        /// Must be 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What growing twigs did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_twig_report
    {
        /// <summary>
        /// `sizeof(tree_twig_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Twigs that old nodes bear.
        /// </summary>
        public ulong n_twigs;
        /// <summary>
        /// Twigs that twigs bear.
        /// </summary>
        public ulong n_laterals;
        /// <summary>
        /// Nodes added.
        /// </summary>
        public ulong n_nodes;
        /// <summary>
        /// Axes of the old skeleton without a place for a twig: too short, beyond the bearing zone, or left
        /// out by the density.
        /// </summary>
        public ulong n_barren;
        /// <summary>
        /// Places that the density left out.
        /// </summary>
        public ulong n_thinned;
        /// <summary>
        /// Places where the density was negative or not a number, and counted as 0.
        /// </summary>
        public ulong n_bad_density;
        /// <summary>
        /// Twigs and laterals left out, shorter than half an internode.
        /// </summary>
        public ulong n_too_short;
        /// <summary>
        /// Twigs left out because their node bears `crowd` already. Many mean that the skeleton has too few
        /// nodes; see `tree_skeleton_refine`.
        /// </summary>
        public ulong n_crowded;
        /// <summary>
        /// Largest distance in metres from a twig's place on the shoot to the node that bears it.
        /// </summary>
        public double moved;
    }

    /// <summary>
    /// How much is drawn.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_hybrid_choice_report
    {
        /// <summary>
        /// `sizeof(tree_hybrid_choice_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Boxes drawn by their planes.
        /// </summary>
        public UIntPtr n_boxes;
        /// <summary>
        /// Ranges of leaves drawn as geometry.
        /// </summary>
        public UIntPtr n_ranges;
        /// <summary>
        /// Leaves in these.
        /// </summary>
        public UIntPtr n_leaves;
        /// <summary>
        /// Triangles of wood, leaves and planes.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Fractional level of the wood, at least 1, for the shader.
        /// </summary>
        public float level;
        /// <summary>
        /// Indices of the wood, surface 0, that are drawn, from the first on.
        /// </summary>
        public uint wood_indices;
    }

    /// <summary>
    /// Leaves one after another in the order that `tree_leaf_boxes_order` tells.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_range
    {
        /// <summary>
        /// The first row.
        /// </summary>
        public uint first;
        /// <summary>
        /// Number of rows.
        /// </summary>
        public uint n_leaves;
    }

    /// <summary>
    /// How a glTF file is written. Begin with `tree_glb_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_glb_options
    {
        /// <summary>
        /// `sizeof(tree_glb_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name of the node and the mesh, for people and engines. Default (`data` is NULL): `tree`.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Whether vertices are written in 8 and 16 bits (`KHR_mesh_quantization`), which more than halves
        /// them. Largest errors: positions the longest side of the bounds / 131,070 on each axis (0.1 mm
        /// for a tree of 13 m); normals and tangents 1/254 on each axis before they are brought to unit
        /// length (0.4 degrees); texture coordinates the range in use / 131,070; occlusion stays exact.
        /// Default 0.
        /// </summary>
        public uint quantize;
        /// <summary>
        /// Whether translucency is written, as `KHR_materials_diffuse_transmission`; programs that do not
        /// know it pass over it. Default 0: the Khronos validator accepts it, but remarks that it cannot
        /// look into it.
        /// </summary>
        public uint translucency;
        /// <summary>
        /// What becomes of ambient occlusion. Default `TREE_GLTF_OCCLUSION_ATTRIBUTE`.
        /// </summary>
        public uint occlusion; // tree_gltf_occlusion
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How branches are compared. Begin with `tree_metric_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_metric_params
    {
        /// <summary>
        /// `sizeof(tree_metric_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// For `TREE_METRIC_BRANCHING` and `TREE_METRIC_DENSITY_OF`: one for each branch, as `tree_adt_view` lists them, 0 to
        /// 1e30. NULL, the default, for all others.
        /// </summary>
        public double* worths;
        /// <summary>
        /// Number of worths: the number of branches, or 0 for the default.
        /// </summary>
        public UIntPtr n_worths;
        /// <summary>
        /// What a branch is worth: a `TREE_METRIC_` constant. Default `TREE_METRIC_DENSITY`.
        /// </summary>
        public uint metric; // tree_metric
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a tree becomes triangles. Lengths in metres, angles in radians. Begin with
    /// `tree_mesh_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mesh_params
    {
        /// <summary>
        /// `sizeof(tree_mesh_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Which child goes on at a fork and which start tubes of their own. Default
        /// `TREE_CONTINUATION_THICKEST`.
        /// </summary>
        public uint continuation; // tree_continuation
        /// <summary>
        /// Fewest sides of a tube, 3 to `sides_max`. Default 3.
        /// </summary>
        public uint sides_min;
        /// <summary>
        /// Most sides of a tube, 3 to 128. Default 20. The cost of trunk and boughs grows with it.
        /// </summary>
        public uint sides_max;
        /// <summary>
        /// The line drawn through the nodes of an axis. Default `TREE_CURVE_THROUGH`.
        /// </summary>
        public uint fit; // tree_curve_fit
        /// <summary>
        /// How it is said how far the mesh may leave the round, curved branch, which rules the number of
        /// sides between the two bounds above and the number of rings. Default `TREE_BOUND_METRES`.
        /// </summary>
        public uint error_kind; // tree_bound_kind
        /// <summary>
        /// With `TREE_BOUND_METRES`: the error, 0.01 mm to 1 m. Default 3 mm.
        /// </summary>
        public float error;
        /// <summary>
        /// With `TREE_BOUND_PIXELS`: width of the error on the screen, 0.01 to 1000. Default 1.
        /// </summary>
        public float error_pixels;
        /// <summary>
        /// With `TREE_BOUND_PIXELS`: from the eye to the tree in metres, 0.01 to 1e6. Default 10 m.
        /// </summary>
        public float error_distance;
        /// <summary>
        /// With `TREE_BOUND_PIXELS`: vertical field of view, 0.01 to 3. Default 1.
        /// </summary>
        public float error_fov_y;
        /// <summary>
        /// With `TREE_BOUND_PIXELS`: height of the screen in pixels, 1 or more. Default 1080.
        /// </summary>
        public uint error_height;
        /// <summary>
        /// Longest stretch of an axis without a ring, 1 mm to 1 km. Default 1 m: branches need rings to
        /// bend in the wind.
        /// </summary>
        public float strip_max;
        /// <summary>
        /// Thinner wood is drawn with this radius, 0.01 mm to 0.1 m. Default 0.5 mm.
        /// </summary>
        public float radius_min;
        /// <summary>
        /// Width of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m. Rounded for each axis so
        /// that it goes round a whole number of times.
        /// </summary>
        public float bark_width;
        /// <summary>
        /// Height of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m.
        /// </summary>
        public float bark_length;
        /// <summary>
        /// How much wider the trunk is at the ground, as a share of its radius, 0 to 3; 0 turns the root
        /// flare off. Default 0.35.
        /// </summary>
        public float flare;
        /// <summary>
        /// Height of the root flare in radii of the trunk, 0.1 to 20. Default 3.
        /// </summary>
        public float flare_height;
        /// <summary>
        /// Number of buttresses in the flare, 0 to 12. Default 5.
        /// </summary>
        public uint flare_lobes;
        /// <summary>
        /// How deep the flare is cut between buttresses, 0 (round) to 0.9. Default 0.5.
        /// </summary>
        public float flare_lobe_depth;
        /// <summary>
        /// Factor on the length of every leaf, 0.01 to 100. Default 1.
        /// </summary>
        public float leaf_scale;
        /// <summary>
        /// Factor on the width of every leaf, 0.01 to 100. Default 1: as wide as its look says.
        /// </summary>
        public float leaf_width;
        /// <summary>
        /// How far leaf normals turn from the leaf's own towards the outside of the crown, 0 to 1.
        /// Default 0.6: soft light over the whole crown.
        /// </summary>
        public float leaf_rounding;
        /// <summary>
        /// Whether vertices get tangents, 16 bytes each: for materials with normal maps. Default no.
        /// </summary>
        public uint tangents;
        /// <summary>
        /// Whether vertices get texture coordinates for a light map, 8 bytes each. Default no.
        /// </summary>
        public uint lightmap;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Which branches get a box. Begin with `tree_leaf_box_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_box_params
    {
        /// <summary>
        /// `sizeof(tree_leaf_box_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// A branch gets no box when its volume is less than this share of that of the box it is in, 0 to 1. Less makes more
        /// boxes. Default 0.02.
        /// </summary>
        public double least_volume;
        /// <summary>
        /// Nor when it is more than this share: its pictures would hardly be sharper. Its own branches are looked at
        /// instead. 0.01 to 1. Default 0.4.
        /// </summary>
        public double most_volume;
        /// <summary>
        /// Levels below the box of the whole tree, 0 to 16. Default 4.
        /// </summary>
        public uint levels;
        /// <summary>
        /// A branch gets no box when it has fewer leaves, 1 to 1,000,000: those are cheap as they are. Default 24.
        /// </summary>
        public uint least_leaves;
        /// <summary>
        /// Most boxes, 1 to 4096; larger ones come first. Default 64.
        /// </summary>
        public uint most_boxes;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How leaves are projected onto planes. Begin with `tree_card_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_card_params
    {
        /// <summary>
        /// `sizeof(tree_card_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Side of a picture in texels, gutters included, 16 to 1024. Default 64.
        /// </summary>
        public uint size;
        /// <summary>
        /// Samples of a texel in each direction, 1 to 8. Default 4.
        /// </summary>
        public uint samples;
        /// <summary>
        /// Texels around each picture that repeat what is at its edge, 1 to 8 and at most a quarter of `size`: so that
        /// filters do not mix pictures. Default 1.
        /// </summary>
        public uint gutter;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// When boxes are opened. Begin with `tree_card_choose_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_card_choose_params
    {
        /// <summary>
        /// `sizeof(tree_card_choose_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Pixels that a texel may cover before its box is opened, 0.01 to 100. Less is sharper and heavier. Default 1.
        /// </summary>
        public float texel_pixels;
        /// <summary>
        /// How much further, relatively, a box must be before it is closed again, 0 to 1: so that a camera that trembles
        /// does not make leaves flicker. Default 0.1.
        /// </summary>
        public float hysteresis;
    }

    /// <summary>
    /// Parameters of every step to a hybrid model. Begin with `tree_hybrid_params_init`. A part that is NULL, as all are
    /// then, is its default.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_hybrid_params
    {
        /// <summary>
        /// `sizeof(tree_hybrid_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// What branches are worth.
        /// </summary>
        public tree_metric_params* metric;
        /// <summary>
        /// How wood and leaves are drawn.
        /// </summary>
        public tree_mesh_params* mesh;
        /// <summary>
        /// How leaves are put into boxes.
        /// </summary>
        public tree_leaf_box_params* boxes;
        /// <summary>
        /// The pictures of the boxes.
        /// </summary>
        public tree_card_params* cards;
        /// <summary>
        /// When pictures take the place of leaves.
        /// </summary>
        public tree_card_choose_params* choose;
        /// <summary>
        /// For `TREE_METRIC_RANDOM` alone. Default 0.
        /// </summary>
        public ulong seed;
        /// <summary>
        /// Side in pixels, 0.01 to 100, of the square that a path must cover, seen from the side, to be drawn. Less shows
        /// finer twigs, more saves triangles. Default 0.5.
        /// </summary>
        public float wood_pixels;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How much there is of a hybrid model.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_hybrid_totals
    {
        /// <summary>
        /// `sizeof(tree_hybrid_totals)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Levels of the wood, at least 1.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Surfaces of its mesh, those without triangles included; surface 0 is the wood.
        /// </summary>
        public UIntPtr n_surfaces;
        /// <summary>
        /// Triangles when all is drawn as it is.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Boxes of leaves; 0 for a tree without leaves.
        /// </summary>
        public UIntPtr n_boxes;
        /// <summary>
        /// Rows of the order of the boxes: leaves that are drawn.
        /// </summary>
        public UIntPtr n_leaves;
    }

    /// <summary>
    /// A part of an index buffer.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_index_window
    {
        /// <summary>
        /// The first index.
        /// </summary>
        public uint first_index;
        /// <summary>
        /// Number of indices; may be 0.
        /// </summary>
        public uint index_count;
    }

    /// <summary>
    /// What became of the leaves.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_boxes_report
    {
        /// <summary>
        /// `sizeof(tree_leaf_boxes_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of boxes.
        /// </summary>
        public UIntPtr n_boxes;
        /// <summary>
        /// Number of levels, the whole tree being one.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Leaves in all.
        /// </summary>
        public UIntPtr n_leaves;
        /// <summary>
        /// Leaves that are in no box but that of the whole tree.
        /// </summary>
        public UIntPtr in_root_only;
        /// <summary>
        /// Branches that got no box because it would have been too small.
        /// </summary>
        public UIntPtr dropped;
    }

    /// <summary>
    /// The box of a branch with all its leaves.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_box
    {
        /// <summary>
        /// `sizeof(tree_leaf_box)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Volume in cubic metres.
        /// </summary>
        public double volume;
        /// <summary>
        /// The box it is in, or `TREE_NO_BOX`.
        /// </summary>
        public uint parent;
        /// <summary>
        /// 0 for the whole tree.
        /// </summary>
        public uint level;
        /// <summary>
        /// The node of the skeleton it begins at.
        /// </summary>
        public uint node;
        /// <summary>
        /// Where its leaves begin in the order.
        /// </summary>
        public uint first_leaf;
        /// <summary>
        /// Number of its leaves, those of its children included.
        /// </summary>
        public uint n_leaves;
        /// <summary>
        /// Number of leaves that are in no child: the first ones of its leaves.
        /// </summary>
        public uint n_own;
        /// <summary>
        /// The first of its children; the others follow it.
        /// </summary>
        public uint first_child;
        /// <summary>
        /// Number of its children.
        /// </summary>
        public uint n_children;
        /// <summary>
        /// Its middle in metres.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Half its sides in metres, along its own axes; none is 0.
        /// </summary>
        public fixed float half[3];
        /// <summary>
        /// Quaternion x, y, z, w that turns its own axes into those of the tree: x to the left of the branch, y along it,
        /// z up.
        /// </summary>
        public fixed float turn[4];
    }

    /// <summary>
    /// A rectangle on which the leaves of a box are projected. The unit vectors are at right angles to each other.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_card_plane
    {
        /// <summary>
        /// Its middle, that of the box, in metres.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Unit vector to the right of the picture: along the diagonal of a side of the box.
        /// </summary>
        public fixed float right[3];
        /// <summary>
        /// Unit vector up the picture: along an axis of the box.
        /// </summary>
        public fixed float up[3];
        /// <summary>
        /// Unit normal, to the viewer.
        /// </summary>
        public fixed float normal[3];
        /// <summary>
        /// Half its width and half its height in metres.
        /// </summary>
        public fixed float half[2];
        /// <summary>
        /// Half the depth of the box across the plane, in metres.
        /// </summary>
        public float reach;
    }

    /// <summary>
    /// What was baked.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_cards_report
    {
        /// <summary>
        /// `sizeof(tree_cards_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of boxes.
        /// </summary>
        public UIntPtr n_boxes;
        /// <summary>
        /// Number of pictures: six for each box.
        /// </summary>
        public UIntPtr n_images;
        /// <summary>
        /// Texels of all pictures.
        /// </summary>
        public ulong texels;
        /// <summary>
        /// Bytes of both atlases, as they are in memory.
        /// </summary>
        public UIntPtr bytes;
        /// <summary>
        /// Pictures in which nothing covers half a texel.
        /// </summary>
        public UIntPtr empty;
        /// <summary>
        /// Side of a picture in texels, gutters included.
        /// </summary>
        public uint size;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of a picture's pixels.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pixels
    {
        /// <summary>
        /// `sizeof(tree_pixels)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// Four bytes for each pixel (red, green, blue, alpha), rows from top to bottom.
        /// </summary>
        public byte* pixels;
        /// <summary>
        /// Number of bytes: `4 * width * height`.
        /// </summary>
        public UIntPtr n_bytes;
    }

    /// <summary>
    /// Size, quality and camera of a picture. Begin with `tree_view_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_view
    {
        /// <summary>
        /// `sizeof(tree_view)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels, 1 to 16,384. Default 1024.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels, 1 to 16,384. Default 1024.
        /// </summary>
        public uint height;
        /// <summary>
        /// Samples per pixel in each direction, 1 (jagged) to 4. Cost grows with the square; default 2.
        /// </summary>
        public uint samples;
        /// <summary>
        /// How the camera is placed. Default `TREE_CAMERA_FRAMED`.
        /// </summary>
        public uint camera; // tree_camera
        /// <summary>
        /// How the camera projects. Default `TREE_LENS_PERSPECTIVE`.
        /// </summary>
        public uint lens; // tree_lens
        /// <summary>
        /// Perspective: vertical field of view in radians, 0.017 to 2.8. Default 0.6, a portrait lens.
        /// </summary>
        public float fov;
        /// <summary>
        /// Framed: where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a
        /// quarter turn on +X. Finite; default 0.6.
        /// </summary>
        public float yaw;
        /// <summary>
        /// Framed: how far the camera looks down, in radians, -pi/2 (from below) to pi/2 (from above).
        /// Default 0.09.
        /// </summary>
        public float pitch;
        /// <summary>
        /// Framed: empty share of the picture on each side, 0 to 0.45. Default 0.06.
        /// </summary>
        public float margin;
        /// <summary>
        /// Placed and orthographic: height of the picture in metres, more than 0. Default 0: set it.
        /// </summary>
        public float lens_height;
        /// <summary>
        /// Placed: where the camera stands, in metres. Default 0, 0, 0.
        /// </summary>
        public fixed float eye[3];
        /// <summary>
        /// Placed: what is in the middle of the picture. Default 0, 0, 0: set it.
        /// </summary>
        public fixed float target[3];
        /// <summary>
        /// Placed: which way is up; must not be parallel to the line of sight. Default 0, 1, 0.
        /// </summary>
        public fixed float up[3];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How much is drawn.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_card_choice_report
    {
        /// <summary>
        /// `sizeof(tree_card_choice_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Boxes drawn by their planes.
        /// </summary>
        public UIntPtr n_boxes;
        /// <summary>
        /// Ranges of leaves drawn as geometry.
        /// </summary>
        public UIntPtr n_ranges;
        /// <summary>
        /// Leaves in these.
        /// </summary>
        public UIntPtr n_leaves;
    }

    /// <summary>
    /// A view, and how much of it is seen.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_octahedral_frame
    {
        /// <summary>
        /// Its column in the pictures.
        /// </summary>
        public uint column;
        /// <summary>
        /// Its row, from the top.
        /// </summary>
        public uint row;
        /// <summary>
        /// Its weight, 0 to 1.
        /// </summary>
        public float weight;
    }

    /// <summary>
    /// How a whole tree is baked. Begin with `tree_octahedral_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_octahedral_params
    {
        /// <summary>
        /// `sizeof(tree_octahedral_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Views along each side of the square of directions, 2 to 64. Default 12: 144 views.
        /// </summary>
        public uint grid;
        /// <summary>
        /// Whether only views from the horizon up are baked, which halves the angle between them. Default 1.
        /// </summary>
        public uint hemi;
        /// <summary>
        /// Side of the pictures in texels, 64 to 16,384, at least 16 for each view. Default 2048.
        /// </summary>
        public uint side;
        /// <summary>
        /// Samples of a texel in each direction, 1 to 8. Default 4.
        /// </summary>
        public uint samples;
        /// <summary>
        /// Empty texels around each view, 1 to 8 and at most a quarter of a view: so that filters do not mix views.
        /// Default 2.
        /// </summary>
        public uint gutter;
        /// <summary>
        /// Whether the picture of normals and depths has half the side. Memory goes from 33.6 MB to 21 MB at the default
        /// side, at some loss of quality. Default 0.
        /// </summary>
        public uint half_detail;
    }

    /// <summary>
    /// What was baked.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_octahedral_report
    {
        /// <summary>
        /// `sizeof(tree_octahedral_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of views.
        /// </summary>
        public UIntPtr n_views;
        /// <summary>
        /// Triangles drawn in each.
        /// </summary>
        public UIntPtr n_triangles;
        /// <summary>
        /// Texels covered at least by half, of all views.
        /// </summary>
        public ulong covered;
        /// <summary>
        /// Bytes of both pictures, as they are in memory.
        /// </summary>
        public UIntPtr bytes;
    }

    /// <summary>
    /// Numbers that go with the two pictures of an octahedral impostor: what a shader needs to know. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_octahedral_meta
    {
        /// <summary>
        /// `sizeof(tree_octahedral_meta)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Views along each side of the square of directions, 2 to 64.
        /// </summary>
        public uint grid;
        /// <summary>
        /// Whether only the upper hemisphere is there.
        /// </summary>
        public uint hemi;
        /// <summary>
        /// Side of the picture of colours in texels.
        /// </summary>
        public uint side;
        /// <summary>
        /// Side of a view in texels of the picture of colours, gutter included. View (column, row) begins at
        /// (column, row) * tile.
        /// </summary>
        public uint tile;
        /// <summary>
        /// Side of the picture of normals and depths: `side`, or half of it.
        /// </summary>
        public uint detail_side;
        /// <summary>
        /// Middle of the tree in metres.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Radius of the ball around it in metres. Depths go from minus this to it, towards the viewer.
        /// </summary>
        public float radius;
        /// <summary>
        /// Radius in metres of the upright cylinder around it, and a gutter more.
        /// </summary>
        public float wide;
        /// <summary>
        /// Half the height in metres of that cylinder, and a gutter more.
        /// </summary>
        public float high;
        /// <summary>
        /// Metres of a texel: the largest of any view. It follows from the others, and is not read.
        /// </summary>
        public float texel;
    }

    /// <summary>
    /// How a tree is divided into twigs. Begin with `tree_instancing_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_instancing_params
    {
        /// <summary>
        /// `sizeof(tree_instancing_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Most unique twigs, 1 to 1000. Default 30.
        /// </summary>
        public uint twigs_max;
        /// <summary>
        /// How many times smaller than the flattened tree the result should be, 1 to 1000. Default 11: ten,
        /// and some room. The truest way that reaches it is taken. Small trees may not reach it: see `ratio`
        /// of `tree_instancing_report`.
        /// </summary>
        public float ratio;
        /// <summary>
        /// Length of twigs in metres along the longest path in them, 0.001 to 1000. Default 0: it is chosen.
        /// </summary>
        public float reach;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What an instanced tree weighs and how near it comes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_instancing_report
    {
        /// <summary>
        /// `sizeof(tree_instancing_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Unique twigs.
        /// </summary>
        public ulong n_twigs;
        /// <summary>
        /// Instances of all twigs.
        /// </summary>
        public ulong n_instances;
        /// <summary>
        /// Bytes of the columns of base and twigs, and of the instances.
        /// </summary>
        public ulong bytes;
        /// <summary>
        /// Bytes of the columns of the flattened tree.
        /// </summary>
        public ulong bytes_flat;
        /// <summary>
        /// Leaves of the tree.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Leaves of the instanced tree.
        /// </summary>
        public ulong n_leaves_instanced;
        /// <summary>
        /// `bytes_flat / bytes`.
        /// </summary>
        public float ratio;
        /// <summary>
        /// Length that twigs were limited to, in metres.
        /// </summary>
        public float reach;
        /// <summary>
        /// How far middle and spread of a subtree's leaves are off those of the twig that stands for it, in
        /// metres: root mean square over all leaves.
        /// </summary>
        public float deviation;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// All places where a twig stands, in columns as glTF's `EXT_mesh_gpu_instancing` has them: as input, or as a
    /// view.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_twig_instances
    {
        /// <summary>
        /// `sizeof(tree_twig_instances)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of instances.
        /// </summary>
        public UIntPtr n_instances;
        /// <summary>
        /// Three floats for each instance: where its base is, in metres.
        /// </summary>
        public float* translations;
        /// <summary>
        /// Four floats for each instance: its turn, a unit quaternion x, y, z, w.
        /// </summary>
        public float* rotations;
        /// <summary>
        /// Three floats for each instance: factor on its size, the same along all axes.
        /// </summary>
        public float* scales;
        /// <summary>
        /// One for each instance: the branch of the base mesh that bears it.
        /// </summary>
        public uint* branches;
    }

    /// <summary>
    /// A mesh and where its copies stand: scaled, turned, then moved.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_gltf_instances
    {
        /// <summary>
        /// `sizeof(tree_gltf_instances)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name of the node and the mesh.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// What is drawn many times, with materials of its own. Copied while the file is written.
        /// </summary>
        public tree_mesh* mesh;
        /// <summary>
        /// Number of copies, at least 1.
        /// </summary>
        public UIntPtr n;
        /// <summary>
        /// Three floats for each copy: where the origin comes to lie, in metres.
        /// </summary>
        public float* translations;
        /// <summary>
        /// Four floats for each copy: how it is turned, a unit quaternion x, y, z, w.
        /// </summary>
        public float* rotations;
        /// <summary>
        /// Three floats for each copy: factors along the axes of the mesh.
        /// </summary>
        public float* scales;
    }

    /// <summary>
    /// A column of the caller's own, for one surface of a mesh.
    ///
    /// Blender 5.0.1 mixes up attributes of one mesh whose names begin with `_` when they differ in their
    /// number of components, and then now and then refuses the file: give all the same number there, and
    /// write occlusion in another way.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_gltf_attribute
    {
        /// <summary>
        /// `sizeof(tree_gltf_attribute)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of the surface in the mesh.
        /// </summary>
        public UIntPtr surface;
        /// <summary>
        /// Name in the file: `_` and then capital letters, digits and `_`, at most 64 in all.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Numbers per vertex, 1 to 4.
        /// </summary>
        public UIntPtr components;
        /// <summary>
        /// `components` finite numbers for each vertex.
        /// </summary>
        public float* values;
        /// <summary>
        /// Number of values: `components` times the number of vertices of the surface.
        /// </summary>
        public UIntPtr n_values;
    }

    /// <summary>
    /// One level of detail of a glTF file, or all of it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_gltf_level
    {
        /// <summary>
        /// `sizeof(tree_gltf_level)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// What is drawn once. May be NULL when there are instances.
        /// </summary>
        public tree_mesh* mesh;
        /// <summary>
        /// What is drawn many times.
        /// </summary>
        public tree_gltf_instances* instances;
        /// <summary>
        /// Number of `instances`, 0 to 65,536.
        /// </summary>
        public UIntPtr n_instances;
        /// <summary>
        /// More columns for the surfaces of `mesh`.
        /// </summary>
        public tree_gltf_attribute* attributes;
        /// <summary>
        /// Number of `attributes`, 0 to 65,536.
        /// </summary>
        public UIntPtr n_attributes;
        /// <summary>
        /// Share of the screen's height (0 to 1) from which this level is drawn, the finest first. Not used
        /// when there is one level.
        /// </summary>
        public float coverage;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a PLY file is written. Begin with `tree_ply_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_ply_options
    {
        /// <summary>
        /// `sizeof(tree_ply_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether numbers are written as text instead of little-endian binary: five times the size, for
        /// people and old programs. Default 0.
        /// </summary>
        public uint ascii;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How files are read. Begin with `tree_import_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_import_options
    {
        /// <summary>
        /// `sizeof(tree_import_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether files that the file names (buffers, textures, MTL) are read. Only those within its own
        /// folder and below are: no absolute path, no `..`, no scheme, no link that leads out. Default 0:
        /// textures and materials are left out and noted, missing buffers are an error.
        /// </summary>
        public uint external;
        /// <summary>
        /// The file's format. Default `TREE_MESH_FORMAT_BY_NAME`.
        /// </summary>
        public uint format; // tree_mesh_format
    }

    /// <summary>
    /// What a file held, and what was left out or changed.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_import_report
    {
        /// <summary>
        /// `sizeof(tree_import_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Nodes of the scene (glTF), objects and groups (OBJ), 1 for PLY.
        /// </summary>
        public ulong n_nodes;
        /// <summary>
        /// Surfaces made.
        /// </summary>
        public ulong n_surfaces;
        /// <summary>
        /// Vertices of all surfaces.
        /// </summary>
        public ulong n_vertices;
        /// <summary>
        /// Triangles of all surfaces.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Copies that `EXT_mesh_gpu_instancing` asked for.
        /// </summary>
        public ulong n_instances;
        /// <summary>
        /// Textures decoded.
        /// </summary>
        public ulong n_textures;
        /// <summary>
        /// How often each thing was left out or changed, by `TREE_NOTE_` constants; `tree_note_text` says
        /// what they mean.
        /// </summary>
        public fixed ulong notes[18];
    }

    /// <summary>
    /// Share of geometry for each distance: lambda, 0 to 1 and never rising, at the distances 0, 0.01, ... 0.1, 0.19,
    /// ... 1 (0 is near and shows the full model, 1 is far), and linear in between.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_distance
    {
        /// <summary>
        /// Lambda at each of these 21 distances.
        /// </summary>
        public fixed float lambdas[21];
    }

    /// <summary>
    /// A view of elements: a row each, in the order of surfaces and triangles.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_elements_columns
    {
        /// <summary>
        /// `sizeof(tree_elements_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of elements.
        /// </summary>
        public UIntPtr n_elements;
        /// <summary>
        /// Surfaces of the mesh that are pruned, rising; all others are always drawn.
        /// </summary>
        public uint* surfaces;
        /// <summary>
        /// Number of these surfaces.
        /// </summary>
        public UIntPtr n_surfaces;
        /// <summary>
        /// For each element the surface of the mesh it is on.
        /// </summary>
        public uint* surface;
        /// <summary>
        /// Where the triangles of each element begin in `triangles`, and their number at the end: `n_elements + 1`
        /// rows.
        /// </summary>
        public uint* starts;
        /// <summary>
        /// Triangles of each element: their numbers in its surface.
        /// </summary>
        public uint* triangles;
        /// <summary>
        /// Number of rows of `triangles`.
        /// </summary>
        public UIntPtr n_triangles;
        /// <summary>
        /// Three floats for each element: mean of its surface in metres, which it is scaled about.
        /// </summary>
        public float* centers;
        /// <summary>
        /// Three floats for each element: mean normal; zero where it has none (a closed blade, no area).
        /// </summary>
        public float* normals;
        /// <summary>
        /// For each element the area of its triangles in square metres.
        /// </summary>
        public float* areas;
        /// <summary>
        /// For each element the largest distance of a vertex from the mean of its own triangles, in metres.
        /// </summary>
        public float* radii;
    }

    /// <summary>
    /// Which surface of a field, and how finely. Begin with `tree_hull_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_hull_params
    {
        /// <summary>
        /// `sizeof(tree_hull_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Value of the field on the surface, 0.001 to 0.5. Default 0.05: a lone element gets a ball of 0.88 times
        /// the radius of influence.
        /// </summary>
        public float iso;
        /// <summary>
        /// Cells of the grid along the radius of influence, 2 to 16. Default 3. Cost grows with the cube.
        /// </summary>
        public float detail;
    }

    /// <summary>
    /// What orders by density and orientation need to know. Begin with `tree_order_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_order_params
    {
        /// <summary>
        /// `sizeof(tree_order_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The hull, for `tree_order_combined` and `tree_hull_of_elements`. NULL, the default: its defaults.
        /// </summary>
        public tree_hull_params* hull;
        /// <summary>
        /// Height of the plant in metres, 0 to 1e9. Default 0: measured, as `tree_elements_plant_height` does it.
        /// </summary>
        public float height;
        /// <summary>
        /// Radius of influence of an element, as a share of the height, 0.001 to 1. Default 0.05.
        /// </summary>
        public float radius;
        /// <summary>
        /// When densities count as uniform and thinning by density ends: at this standard deviation of the
        /// densities of what is left, divided by their mean, 0 (never) to 10 (at once). Default 0.15.
        /// </summary>
        public float uniform;
        /// <summary>
        /// Thinning by density ends at this share of the elements at the latest, 0 to 1. Default 0.25.
        /// </summary>
        public float least;
        /// <summary>
        /// How much chance is added to priorities, which lie within 0 to 1; 0 (none) to 1. Default 0.05.
        /// </summary>
        public float randomness;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of a hull.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_hull_columns
    {
        /// <summary>
        /// `sizeof(tree_hull_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Three floats for each vertex: where it is, in metres. Each place is there once.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Three floats for each vertex: unit normal, outwards.
        /// </summary>
        public float* normals;
        /// <summary>
        /// Number of indices: three for each triangle.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Vertices of the triangles, counter-clockwise seen from outside.
        /// </summary>
        public uint* indices;
    }

    /// <summary>
    /// Size of a mask of bits.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bits_size
    {
        /// <summary>
        /// `sizeof(tree_bits_size)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// Words of all rows: what `tree_bits_words` writes.
        /// </summary>
        public UIntPtr n_words;
        /// <summary>
        /// Pixels of all rows: what `tree_bits_bytes` writes.
        /// </summary>
        public UIntPtr n_pixels;
        /// <summary>
        /// Number of set bits.
        /// </summary>
        public ulong count;
    }

    /// <summary>
    /// Pixels of a simplified model against those of the full one: of one view, or added up over many.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_score
    {
        /// <summary>
        /// Covered by both.
        /// </summary>
        public ulong both;
        /// <summary>
        /// Covered by the simplified model only.
        /// </summary>
        public ulong wrong;
        /// <summary>
        /// Covered by the full model only.
        /// </summary>
        public ulong missed;
    }

    /// <summary>
    /// Views around a model, each of which frames all of it. Begin with `tree_around_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_around
    {
        /// <summary>
        /// `sizeof(tree_around)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How far the cameras look down in radians, -pi/2 to pi/2, each with all azimuths: every next ring is
        /// turned by a share of the step, so that no two stand above each other. NULL, the default: one ring,
        /// level.
        /// </summary>
        public float* pitches;
        /// <summary>
        /// Number of pitches, at most 64; 0 for the default.
        /// </summary>
        public UIntPtr n_pitches;
        /// <summary>
        /// Directions around the trunk for each pitch, evenly spread, 1 to 360. Default 8.
        /// </summary>
        public uint azimuths;
        /// <summary>
        /// Width and height of the masks in pixels, 8 to 4096. Default 512.
        /// </summary>
        public uint size;
        /// <summary>
        /// Where the first stands, in radians. Default 0. Views for measuring should not be those that an order
        /// was made with.
        /// </summary>
        public float turn;
        /// <summary>
        /// Vertical field of view in radians, 0.017 to 2.8, for perspective. 0, the default: parallel projection.
        /// </summary>
        public float fov;
    }

    /// <summary>
    /// How the order by coverage is made. Begin with `tree_coverage_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_coverage_params
    {
        /// <summary>
        /// `sizeof(tree_coverage_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Views that are looked at. More hold better for others, at proportional cost. NULL, the default: those of
        /// `tree_around_for_order`.
        /// </summary>
        public tree_around* around;
        /// <summary>
        /// Shares of triangles for which the choice is made, falling, more than 0, less than 1. NULL, the default:
        /// 0.5, 0.35, 0.2, 0.1, 0.05, 0.02.
        /// </summary>
        public float* stages;
        /// <summary>
        /// Number of stages, at most 32; 0 for the default.
        /// </summary>
        public UIntPtr n_stages;
        /// <summary>
        /// Whether leaves choose the point they grow about; otherwise it is their centre. Default 1.
        /// </summary>
        public uint pivots;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How large a pruned model is.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pruned_totals
    {
        /// <summary>
        /// `sizeof(tree_pruned_totals)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Surfaces that are pruned; all others are drawn whole.
        /// </summary>
        public UIntPtr n_parts;
        /// <summary>
        /// Number of tiers.
        /// </summary>
        public UIntPtr n_tiers;
        /// <summary>
        /// Number of elements.
        /// </summary>
        public UIntPtr n_elements;
        /// <summary>
        /// Triangles of the full foliage.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Number of states; neighbours differ in one element.
        /// </summary>
        public ulong n_steps;
        /// <summary>
        /// Bytes of the foliage's indices in the mesh that came in.
        /// </summary>
        public ulong indices_before;
        /// <summary>
        /// Bytes of the indices of all tiers.
        /// </summary>
        public ulong indices_after;
        /// <summary>
        /// Bytes of the foliage's vertices in the mesh that came in.
        /// </summary>
        public ulong vertices_before;
        /// <summary>
        /// Bytes of the vertices with copies and centres.
        /// </summary>
        public ulong vertices_after;
        /// <summary>
        /// The least lambda that can be kept: of the state with the fewest elements.
        /// </summary>
        public float least_lambda;
        /// <summary>
        /// Lambda of the last state in which all elements are drawn.
        /// </summary>
        public float lambda_of_all;
    }

    /// <summary>
    /// A view of a surface that is pruned.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_pruned_part
    {
        /// <summary>
        /// `sizeof(tree_pruned_part)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Four floats for each vertex of the surface: the point that its element is scaled about, in metres, and the
        /// lambda from which on it is drawn (0: always). A vertex of no element has itself as centre.
        /// </summary>
        public float* centers;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Number of the surface in the mesh.
        /// </summary>
        public uint surface;
        /// <summary>
        /// Mean linear colour of what is seen of the full model: texture times base colour.
        /// </summary>
        public fixed float mean[3];
    }

    /// <summary>
    /// What is drawn of the elements; *ranks* are places in the order, the most important is 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_cut
    {
        /// <summary>
        /// Triangles that are drawn.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Tier of the ranks below `fine`.
        /// </summary>
        public uint tier;
        /// <summary>
        /// Ranks from here to `end` are drawn with the next tier.
        /// </summary>
        public uint fine;
        /// <summary>
        /// Ranks from here on are not drawn.
        /// </summary>
        public uint end;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// When levels in a file change. Begin with `tree_lod_screen_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_screen
    {
        /// <summary>
        /// `sizeof(tree_lod_screen)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
        /// </summary>
        public tree_lod_distance* distance;
        /// <summary>
        /// Distance in metres up to which the full model is wanted, in a field of view of 60 degrees, 0 or more.
        /// Default 10.
        /// </summary>
        public float near;
        /// <summary>
        /// Distance from which on the least will do, more than `near`, at most 1e9. Default 500.
        /// </summary>
        public float far;
    }

    /// <summary>
    /// What is drawn for a lambda, and the numbers that the shader needs. Its windows stand in an array of their own.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_level
    {
        /// <summary>
        /// Share of the foliage's triangles, more than 0, at most 1. No less than what one element needs.
        /// </summary>
        public float lambda;
        /// <summary>
        /// Factor on the area of each element.
        /// </summary>
        public float scale;
        /// <summary>
        /// Factor on its lengths: the square root of `scale`.
        /// </summary>
        public float growth;
        /// <summary>
        /// Factor on the contrast of colours, more than 0, at most 1.
        /// </summary>
        public float contrast;
        /// <summary>
        /// Width in lambda over which the last elements fade; 0 where all are drawn.
        /// </summary>
        public float fade;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// Triangles of the foliage that are drawn.
        /// </summary>
        public ulong n_triangles;
    }

    /// <summary>
    /// A piece of a surface's index buffer.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_window
    {
        /// <summary>
        /// Number of the surface.
        /// </summary>
        public uint surface;
        /// <summary>
        /// First index.
        /// </summary>
        public uint first_index;
        /// <summary>
        /// Number of indices; may be 0.
        /// </summary>
        public uint index_count;
    }

    /// <summary>
    /// How a model is pruned. Begin with `tree_prune_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_prune_params
    {
        /// <summary>
        /// `sizeof(tree_prune_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Share of lambda over which the last elements fade, 0 to 1. More is smoother in motion, but shows fewer of the
        /// triangles that are drawn. 0: they pop. Default 0.1.
        /// </summary>
        public float fade;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How outlines become simpler. Begin with `tree_tiers_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_tiers_params
    {
        /// <summary>
        /// `sizeof(tree_tiers_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Share of its triangles that an element has in each tier after the first, falling, 0 to 1. Every element keeps
        /// a triangle, or two where a picture with a mask lies on it. NULL, the default: 1/2, 1/4, 1/8, 1/16.
        /// </summary>
        public float* shares;
        /// <summary>
        /// Number of shares, at most 16; 0 for the default.
        /// </summary>
        public UIntPtr n_shares;
        /// <summary>
        /// How far lengths of elements may differ, in lengths of a square of the same area, for them to share one answer,
        /// 0 to 1. Default 0.08.
        /// </summary>
        public float alike;
        /// <summary>
        /// Largest share of the triangles of the tier before that a tier may have; others are not worth their memory and
        /// are left out. 0 to 1. Default 0.9.
        /// </summary>
        public float worth;
    }

    /// <summary>
    /// How a table is measured. Begin with `tree_lod_table_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_table_params
    {
        /// <summary>
        /// `sizeof(tree_lod_table_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// From where to look. NULL, the default: 8 azimuths, level, with 256 pixels; fewer and smaller for a large
        /// model, as `tree_around_for_table` says.
        /// </summary>
        public tree_around* around;
        /// <summary>
        /// Rows of the table: rising, more than 0, the last 1. NULL, the default: 17 from 0.01 to 1.
        /// </summary>
        public float* lambdas;
        /// <summary>
        /// Number of lambdas, at most 256; 0 for the default.
        /// </summary>
        public UIntPtr n_lambdas;
        /// <summary>
        /// Which scale is measured: a `TREE_LOD_SCALE_` constant. Default `TREE_LOD_SCALE_BEST`.
        /// </summary>
        public uint scale; // tree_lod_scale
        /// <summary>
        /// `TREE_LOD_SCALE_FIXED`: the scale, a factor on area, 0.01 to 10,000. Default 1.
        /// </summary>
        public float @fixed;
    }

    /// <summary>
    /// Every step from a mesh to a pruned model. Begin with `tree_prune_make_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_prune_make_params
    {
        /// <summary>
        /// `sizeof(tree_prune_make_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Surfaces that are pruned, each once. NULL, the default: they are found, as `tree_elements_of_mesh` does it.
        /// </summary>
        public uint* surfaces;
        /// <summary>
        /// Number of these surfaces; 0 for the default.
        /// </summary>
        public UIntPtr n_surfaces;
        /// <summary>
        /// How outlines become simpler. NULL, the default: its defaults.
        /// </summary>
        public tree_tiers_params* outlines;
        /// <summary>
        /// How the order is found. NULL, the default: as is right for so many triangles.
        /// </summary>
        public tree_coverage_params* order;
        /// <summary>
        /// How scales are measured. NULL, the default: as is right for so many triangles.
        /// </summary>
        public tree_lod_table_params* table;
        /// <summary>
        /// How the model is pruned. NULL, the default: its defaults.
        /// </summary>
        public tree_prune_params* prune;
        /// <summary>
        /// What an element is: a `TREE_GRAIN_` constant. Default `TREE_GRAIN_BLADE`.
        /// </summary>
        public uint grain; // tree_grain
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What is measured: a model, its elements, in which order they are dropped, and what they are drawn with. Begin with
    /// `tree_lod_subject_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_subject
    {
        /// <summary>
        /// `sizeof(tree_lod_subject)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The full model. No default: NULL, which is refused.
        /// </summary>
        public tree_mesh* mesh;
        /// <summary>
        /// Its elements. No default: NULL, which is refused.
        /// </summary>
        public tree_elements* elements;
        /// <summary>
        /// All elements, the most important first, such as `tree_order_coverage` writes them.
        /// </summary>
        public uint* order;
        /// <summary>
        /// Number of rows of `order`: the number of elements.
        /// </summary>
        public UIntPtr n_order;
        /// <summary>
        /// Three floats for each element (not rank): the point it is scaled about, in metres. NULL, the default: its
        /// centre.
        /// </summary>
        public float* pivots;
        /// <summary>
        /// Number of pivots: the number of elements, or 0 for the default.
        /// </summary>
        public UIntPtr n_pivots;
        /// <summary>
        /// What the elements are drawn with. NULL, the default: the full model alone.
        /// </summary>
        public tree_tiers* tiers;
        /// <summary>
        /// Number of elements with which each tier begins, such as `tree_lod_plan` writes them: of the first all, then
        /// never more than before. NULL, the default: each begins with all.
        /// </summary>
        public uint* kept;
        /// <summary>
        /// Number of rows of `kept`: the number of tiers, or 0 for the default.
        /// </summary>
        public UIntPtr n_kept;
    }

    /// <summary>
    /// An ellipsoid along the axes of a model that nothing is seen through.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_occluder
    {
        /// <summary>
        /// Its centre in metres.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Half its size along each axis, more than 0.
        /// </summary>
        public fixed float radii[3];
    }

    /// <summary>
    /// A window of an index buffer.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_draw
    {
        /// <summary>
        /// First index.
        /// </summary>
        public uint first_index;
        /// <summary>
        /// Number of indices; 0 for a part that is not drawn.
        /// </summary>
        public uint index_count;
        /// <summary>
        /// Added to each index.
        /// </summary>
        public int base_vertex;
    }

    /// <summary>
    /// A tree model as a scene draws it. Lengths in metres, in the model's own space. Begin with
    /// `tree_scene_model_init`. All is copied into the scene.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_model
    {
        /// <summary>
        /// `sizeof(tree_scene_model)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Points on the crown's surface, evenly spread, three floats each, such as `tree_hull_sample` writes them.
        /// NULL, the default: the model is never taken for occluded.
        /// </summary>
        public float* samples;
        /// <summary>
        /// Number of points, at most 64; 32 do well.
        /// </summary>
        public UIntPtr n_samples;
        /// <summary>
        /// What hides other trees in the built-in occlusion pass: a few ellipsoids that are opaque for certain, such
        /// as the inner crown and the trunk. NULL, the default: the model hides nothing there.
        /// </summary>
        public tree_scene_occluder* occluders;
        /// <summary>
        /// Number of occluders, at most 64.
        /// </summary>
        public UIntPtr n_occluders;
        /// <summary>
        /// Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
        /// </summary>
        public tree_lod_distance* distance;
        /// <summary>
        /// For each level the share of the foliage's triangles, rising, more than 0, at most 1. The more levels, the
        /// smoother. No default: NULL, which is refused.
        /// </summary>
        public float* lambdas;
        /// <summary>
        /// For each level the factor on the area of each element, more than 0. NULL, the default: 1.
        /// </summary>
        public float* scales;
        /// <summary>
        /// For each level the width in lambda over which the last elements fade in, 0 (they pop; nothing fades in the full
        /// model) to 1. NULL, the default: 0.
        /// </summary>
        public float* fades;
        /// <summary>
        /// Number of levels, 1 to 1024.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// What is drawn of each part of the model (bark, leaves, fruit): the parts of the first level, then those of
        /// the next, `n_levels * n_parts` rows. A part that is always drawn whole has the same draw in every level.
        /// No default: NULL, which is refused.
        /// </summary>
        public tree_scene_draw* draws;
        /// <summary>
        /// Number of parts, 1 to 64.
        /// </summary>
        public UIntPtr n_parts;
        /// <summary>
        /// Centre of a sphere around the whole model, at its largest scale. Default 0, 0, 0.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Radius of that sphere, more than 0, at most 100,000. Default 1: set it.
        /// </summary>
        public float radius;
        /// <summary>
        /// Distance up to which the full model is drawn, for an instance of scale 1 in a field of view of 60 degrees
        /// from top to bottom; what counts is the size on the screen. 0 or more. Default 10.
        /// </summary>
        public float near;
        /// <summary>
        /// Distance from which on the least is drawn, more than `near`. Default 500.
        /// </summary>
        public float far;
    }

    /// <summary>
    /// A tree of a scene.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_instance
    {
        /// <summary>
        /// Which model of the scene it is.
        /// </summary>
        public uint model;
        /// <summary>
        /// Where the model's origin stands, in metres, within 1e7 of the origin.
        /// </summary>
        public fixed float position[3];
        /// <summary>
        /// How it is turned: a unit quaternion, x, y, z, w. 0, 0, 0, 1 is not at all.
        /// </summary>
        public fixed float rotation[4];
        /// <summary>
        /// Factor on its size, 0.001 to 1000.
        /// </summary>
        public float scale;
    }

    /// <summary>
    /// What is needed to draw a scene.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_needs
    {
        /// <summary>
        /// `sizeof(tree_scene_needs)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of instances: rows of `tree_instance_lod` that always suffice.
        /// </summary>
        public UIntPtr n_instances;
        /// <summary>
        /// Rows of `tree_draw_indexed` that always suffice: the parts of all instances.
        /// </summary>
        public UIntPtr most_draws;
        /// <summary>
        /// Indices of all instances at their finest level: what is drawn without selection.
        /// </summary>
        public ulong most_indices;
    }

    /// <summary>
    /// How an instance was drawn in the last frame.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_shown
    {
        /// <summary>
        /// Whether it was in view, 1 or 0; if not, all else is 0.
        /// </summary>
        public uint in_view;
        /// <summary>
        /// Level of its model.
        /// </summary>
        public uint level;
        /// <summary>
        /// Share of the foliage's triangles.
        /// </summary>
        public float lambda;
        /// <summary>
        /// Share of the sample points that are seen, 0 to 1.
        /// </summary>
        public float visible;
    }

    /// <summary>
    /// How shares of geometry follow what is seen. Begin with `tree_scene_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_params
    {
        /// <summary>
        /// `sizeof(tree_scene_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Least factor on lambda of a tree that is hidden, 0.001 to 1. Default 0.1.
        /// </summary>
        public float hidden;
        /// <summary>
        /// Width of the band in which nothing changes, as a share of lambda, 0 to 1. Default 0.05. Wider: calmer, but
        /// up to so much more is drawn.
        /// </summary>
        public float band;
        /// <summary>
        /// Seconds in which lambda comes nearer to its aim by two thirds, 0 (at once) to 60. Default 0.2.
        /// </summary>
        public float time;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One picture that is to be drawn. Begin with `tree_scene_frame_init`.
    ///
    /// Matrices have 16 floats, column by column, as engines hand them to shaders. A view turns and moves only; the
    /// eye looks along -Z of it. A projection is right-handed with depth from 0 to 1: perspective or orthographic, its
    /// far end finite or infinite, its depth reversed or not, off centre, upside down (Vulkan).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_frame
    {
        /// <summary>
        /// `sizeof(tree_scene_frame)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// From the world to the eye's space. No default: zeros, which are refused.
        /// </summary>
        public fixed float view[16];
        /// <summary>
        /// From the eye's space to clip space. No default: zeros, which are refused.
        /// </summary>
        public fixed float projection[16];
        /// <summary>
        /// Seconds since the last frame, 0 to 1e6. Default 0: no time has passed.
        /// </summary>
        public float seconds;
        /// <summary>
        /// Whether the camera has jumped: all shares are then what they should be at once. Default 0.
        /// </summary>
        public uint cut;
        /// <summary>
        /// What hides trees: a `TREE_SCENE_OCCLUSION_` constant. Default `TREE_SCENE_OCCLUSION_NONE`. All that follows
        /// is for `TREE_SCENE_OCCLUSION_DEPTH`.
        /// </summary>
        public uint occlusion; // tree_scene_occlusion
        /// <summary>
        /// Whether the first row of depths lies at clip y = -w, as in Vulkan and OpenGL; otherwise it lies at +w, as in
        /// Direct3D, Metal and WebGPU. Default 0.
        /// </summary>
        public uint depth_y_down;
        /// <summary>
        /// Depth of each pixel from 0 to 1, row by row, of the previous frame or some frames ago. They are not copied.
        /// </summary>
        public float* depths;
        /// <summary>
        /// Number of depths: `depth_width * depth_height`.
        /// </summary>
        public UIntPtr n_depths;
        /// <summary>
        /// Pixels in a row, 1 to 32,768. 256 by 144 do.
        /// </summary>
        public uint depth_width;
        /// <summary>
        /// Rows, 1 to 32,768.
        /// </summary>
        public uint depth_height;
        /// <summary>
        /// The view the depths were drawn with.
        /// </summary>
        public fixed float depth_view[16];
        /// <summary>
        /// The projection the depths were drawn with; it tells whether depth is reversed.
        /// </summary>
        public fixed float depth_projection[16];
    }

    /// <summary>
    /// What a frame draws.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_scene_report
    {
        /// <summary>
        /// `sizeof(tree_scene_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Instances in view.
        /// </summary>
        public ulong drawn;
        /// <summary>
        /// Instances out of view.
        /// </summary>
        public ulong culled;
        /// <summary>
        /// Instances in view of which some sample points are hidden. What is so far that it is drawn as coarsely as can
        /// be is not tested, and counts as seen.
        /// </summary>
        public ulong occluded;
        /// <summary>
        /// Instances in view of which all are.
        /// </summary>
        public ulong hidden;
        /// <summary>
        /// Indices drawn: what a vertex shader sees at most.
        /// </summary>
        public ulong indices;
        /// <summary>
        /// Triangles drawn, if all are lists.
        /// </summary>
        public ulong triangles;
    }

    /// <summary>
    /// Arguments of an indexed indirect draw, laid out as Vulkan, Direct3D 12, WebGPU and Metal take them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_draw_indexed
    {
        /// <summary>
        /// Number of indices.
        /// </summary>
        public uint index_count;
        /// <summary>
        /// Number of instances, never 0.
        /// </summary>
        public uint instance_count;
        /// <summary>
        /// First index.
        /// </summary>
        public uint first_index;
        /// <summary>
        /// Added to each index.
        /// </summary>
        public int base_vertex;
        /// <summary>
        /// Row of the first instance in the buffer of `tree_instance_lod`.
        /// </summary>
        public uint first_instance;
    }

    /// <summary>
    /// How an instance is drawn in this frame, 20 bytes: for a storage buffer that vertex shaders read.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_instance_lod
    {
        /// <summary>
        /// Number of the instance in the scene.
        /// </summary>
        public uint instance;
        /// <summary>
        /// Factor on the *length* of each element about its centre.
        /// </summary>
        public float scale;
        /// <summary>
        /// Share of the foliage's triangles, 0 to 1. It moves smoothly; the window drawn holds at least as much.
        /// </summary>
        public float lambda;
        /// <summary>
        /// Width in lambda of the end of the order that is fading: an element of rank u (0 first, 1 last) has the size
        /// `clamp((lambda - u) / fade, 0, 1)`. 0 where nothing fades: the full model.
        /// </summary>
        public float fade;
        /// <summary>
        /// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007).
        /// </summary>
        public float contrast;
    }

    /// <summary>
    /// A share of geometry, its best scale, and how good the model then is.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lod_row
    {
        /// <summary>
        /// Share of the foliage's triangles that is drawn, more than 0, at most 1.
        /// </summary>
        public float lambda;
        /// <summary>
        /// Factor on the area of each element; lengths grow by its square root.
        /// </summary>
        public float scale;
        /// <summary>
        /// Precision over the views that were looked at.
        /// </summary>
        public float precision;
        /// <summary>
        /// Recall over them.
        /// </summary>
        public float recall;
        /// <summary>
        /// Mean of the quality of the views.
        /// </summary>
        public float quality;
    }

    /// <summary>
    /// A view of a tier.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_tier_columns
    {
        /// <summary>
        /// `sizeof(tree_tier_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of elements.
        /// </summary>
        public UIntPtr n_elements;
        /// <summary>
        /// Where the triangles of each element begin, and their number at the end: `n_elements + 1` rows.
        /// </summary>
        public uint* starts;
        /// <summary>
        /// Three vertices of the element's surface for each triangle, in the winding of the model.
        /// </summary>
        public uint* triangles;
        /// <summary>
        /// Number of triangles.
        /// </summary>
        public UIntPtr n_triangles;
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

    /// <summary>
    /// What a surface looks like, in glTF's metallic-roughness terms; nothing on a tree is metal. As input
    /// (begin with `tree_material_init`), or as a view.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_material
    {
        /// <summary>
        /// `sizeof(tree_material)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name for people and files. As input, empty is `material`.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// As input: the picture wrapped on the surface, or NULL for none; the material keeps what it needs,
        /// so the handle may be freed. In views always NULL: `has_texture` says whether there is one, and
        /// `tree_mesh_texture` or `tree_look_texture` give a handle of it.
        /// </summary>
        public tree_texture* texture;
        /// <summary>
        /// Linear colour (0 or more; files hold up to 1) and alpha (0 to 1), multiplied with the texture.
        /// Default white.
        /// </summary>
        public fixed float base_color[4];
        /// <summary>
        /// 0 mirror-like to 1 matt. Default 0.9.
        /// </summary>
        public float roughness;
        /// <summary>
        /// How texture alpha is used. Default `TREE_ALPHA_OPAQUE`.
        /// </summary>
        public uint alpha; // tree_alpha
        /// <summary>
        /// With `TREE_ALPHA_MASK`: alpha below which pixels are not drawn, 0 to 1. Default 0.5.
        /// </summary>
        public float alpha_cutoff;
        /// <summary>
        /// Whether back faces are drawn, with their normals turned over. Default no.
        /// </summary>
        public uint double_sided;
        /// <summary>
        /// Share of the light on one face that shines through the other, 0 to 1. Leaves have about 0.4.
        /// Default 0.
        /// </summary>
        public float translucency;
        /// <summary>
        /// In views: whether there is a texture. Ignored in input.
        /// </summary>
        public uint has_texture;
    }

    /// <summary>
    /// One leaf as a small mesh in its own frame: base at the origin, midrib along +Y with the apex at a
    /// height of about 1, upper face towards +Z. Triangles counter-clockwise seen from above. As input, or as
    /// a view.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_mesh
    {
        /// <summary>
        /// `sizeof(tree_leaf_mesh)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of vertices, at most 65,536.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Number of indices, three for each triangle.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Three floats for each vertex: where it is, in lengths of the leaf.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Three floats for each vertex: its unit normal.
        /// </summary>
        public float* normals;
        /// <summary>
        /// Two floats for each vertex: texture coordinates, v downwards.
        /// </summary>
        public float* uvs;
        /// <summary>
        /// Two floats for each vertex, or NULL: where it lies on the leaf's own piece of the light map, 0 to 1
        /// both ways. NULL: above its place in the plane of the leaf, right for leaves that do not overlap
        /// themselves.
        /// </summary>
        public float* uvs2;
        /// <summary>
        /// Three for each triangle: its vertices.
        /// </summary>
        public uint* indices;
    }

    /// <summary>
    /// What leaves of one kind look like: as input (begin with `tree_leaf_look_init`), or as a view.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_look
    {
        /// <summary>
        /// `sizeof(tree_leaf_look)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Goes on the leaves. Should be double-sided, with an alpha mask where the texture has one. As input,
        /// NULL is the default material. In views always NULL: `tree_look_material` views it.
        /// </summary>
        public tree_material* material;
        /// <summary>
        /// With `TREE_LEAF_MESH`: the leaf, which is copied. In views always NULL: `tree_look_leaf_mesh` views
        /// it.
        /// </summary>
        public tree_leaf_mesh* mesh;
        /// <summary>
        /// Width of the picture in lengths of the leaf, 0.001 to 1000; 1 is square. Default 1. Unused by
        /// `TREE_LEAF_MESH`, which has its own.
        /// </summary>
        public float width;
        /// <summary>
        /// What a leaf is cut out of. Default `TREE_LEAF_CARD`.
        /// </summary>
        public uint form; // tree_leaf_form
        /// <summary>
        /// With `TREE_LEAF_OUTLINE` and `TREE_LEAF_MODELLED`: most vertices of the polygon, 4 to 64. Default
        /// 8; a modelled leaf of 12 has up to 20 triangles when folded or bent.
        /// </summary>
        public uint vertices_max;
        /// <summary>
        /// Copies of the leaf turned about its midrib, evenly over half a turn, 1 to 8. Two or three make
        /// clusters and needles look full from all sides. Default 1.
        /// </summary>
        public uint sheets;
        /// <summary>
        /// Angle in radians by which each half of a leaf stands up along the midrib, 0 to 1.4. Default 0.
        /// </summary>
        public float fold;
        /// <summary>
        /// Angle in radians by which the midrib bends down from base to apex, evenly, 0 to π. Default 0.
        /// </summary>
        public float bend;
        /// <summary>
        /// Rows of triangles that a bent leaf has at least, 1 to 16. Default 2.
        /// </summary>
        public uint rows;
        /// <summary>
        /// Width of petioles in lengths of the leaf, 0 to 0.2: a prism of three sides from the shoot to the
        /// base of the leaf, eight vertices and six triangles a leaf. Default 0, none.
        /// </summary>
        public float petiole;
    }

    /// <summary>
    /// Spots of another colour on bark. Has no `struct_size`: it is a row of an array, and never changes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bark_patches
    {
        /// <summary>
        /// sRGB colour.
        /// </summary>
        public fixed byte color[3];
        /// <summary>
        /// Not used.
        /// </summary>
        public byte reserved;
        /// <summary>
        /// Waves of the noise that shapes them, across and along, 1 to 256.
        /// </summary>
        public fixed uint count[2];
        /// <summary>
        /// Share of the bark they cover, roughly, 0 to 1.
        /// </summary>
        public float share;
        /// <summary>
        /// Width of their edges, 0.01 (hard) to 1.
        /// </summary>
        public float softness;
        /// <summary>
        /// How much of the colour below they hide, 0 to 1.
        /// </summary>
        public float opacity;
        /// <summary>
        /// How rough their surface is, 0 to 1: dark cracks along the trunk.
        /// </summary>
        public float roughness;
    }

    /// <summary>
    /// What bark looks like. One tile of the texture is meant for 0.5 to 1 metre of trunk; counts are per
    /// tile and 0 switches a layer off, so do strengths of 0. Begin with `tree_bark_style_init`, or with the
    /// style of a built-in bark by `tree_bark_style_of`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bark_style
    {
        /// <summary>
        /// `sizeof(tree_bark_style)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where the noise starts: another seed is another piece of the same bark. Default 0.
        /// </summary>
        public ulong seed;
        /// <summary>
        /// Spots of another colour, drawn in order (lichen, peeling, old bark). Default none.
        /// </summary>
        public tree_bark_patches* patches;
        /// <summary>
        /// Number of `patches`, at most 16.
        /// </summary>
        public UIntPtr n_patches;
        /// <summary>
        /// How much of `tint` is mixed in at most, 0 to 1. Default 0.3.
        /// </summary>
        public float tinting;
        /// <summary>
        /// Plates across and along, 0 to 256. Default none.
        /// </summary>
        public fixed uint plates[2];
        /// <summary>
        /// Width of the cracks between plates, in widths of a plate, 0 to 1. Default 0.2.
        /// </summary>
        public float crack;
        /// <summary>
        /// How much brightness differs from plate to plate, 0 to 1. Default 0.15.
        /// </summary>
        public float plate_contrast;
        /// <summary>
        /// Waves of the noise whose zero lines are furrows, across and along, 0 to 256. Default 8, 2.
        /// </summary>
        public fixed uint furrows[2];
        /// <summary>
        /// Width of the furrows, as height of that noise, 0 to 1. Default 0.3.
        /// </summary>
        public float furrow_width;
        /// <summary>
        /// Depth of the furrows, 0 to 1. Default 1.
        /// </summary>
        public float furrow_depth;
        /// <summary>
        /// How ragged edges are, 0 to 1. Default 0.4.
        /// </summary>
        public float ragged;
        /// <summary>
        /// How far points are shifted, in tiles, 0 to 0.5. Default 0.03.
        /// </summary>
        public float warp;
        /// <summary>
        /// Strength of the flakes, thin layers with stepped edges, 0 to 1. Default 0.
        /// </summary>
        public float flakes;
        /// <summary>
        /// Waves of the finest layer across and along, 0 to 256. Default 24, 12.
        /// </summary>
        public fixed uint grain[2];
        /// <summary>
        /// Height of the grain, 0 to 1. Default 0.3.
        /// </summary>
        public float grain_height;
        /// <summary>
        /// Rings around the trunk, waves along a tile, 0 to 256. Default 0.
        /// </summary>
        public uint rings;
        /// <summary>
        /// Strength of the rings, 0 to 1. Default 0.3.
        /// </summary>
        public float ring_contrast;
        /// <summary>
        /// Strength of the baked light, 0 to 3. Default 1.
        /// </summary>
        public float relief;
        /// <summary>
        /// Whether there are lenticels, short dark lines across the trunk, as on birch and cherry. Default no.
        /// </summary>
        public uint has_lenticels;
        /// <summary>
        /// With `has_lenticels`: places for one, across and along, 1 to 256. Default 5, 34.
        /// </summary>
        public fixed uint lenticel_count[2];
        /// <summary>
        /// With `has_lenticels`: share of the places taken, 0 to 1. Default 0.45.
        /// </summary>
        public float lenticel_share;
        /// <summary>
        /// With `has_lenticels`: length of the longest, in places, 0.01 to 1. Default 1.
        /// </summary>
        public float lenticel_length;
        /// <summary>
        /// With `has_lenticels`: thickness of the thickest, in places, 0.01 to 1. Default 0.45.
        /// </summary>
        public float lenticel_thickness;
        /// <summary>
        /// With `has_lenticels`: sRGB colour. Default a dark brown.
        /// </summary>
        public fixed byte lenticel_color[3];
        /// <summary>
        /// sRGB colour of the ridges. Default a grey brown.
        /// </summary>
        public fixed byte ridge[3];
        /// <summary>
        /// sRGB colour of the depths of cracks and furrows. Default a dark brown.
        /// </summary>
        public fixed byte furrow[3];
        /// <summary>
        /// sRGB colour that slow noise mixes in. Default a greenish grey.
        /// </summary>
        public fixed byte tint[3];
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a leaf's mesh came about.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_model_report
    {
        /// <summary>
        /// `sizeof(tree_leaf_model_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether the picture could not be outlined (no mask, or nothing of it visible) and the leaf is a card
        /// instead.
        /// </summary>
        public uint fallback;
        /// <summary>
        /// Whether the margin is modelled, so that no mask is needed.
        /// </summary>
        public uint opaque;
        /// <summary>
        /// Share of the picture's pixels that can be seen; 1 without a mask.
        /// </summary>
        public float visible;
        /// <summary>
        /// Area of the polygon in the picture as share of the picture; 1 for a card.
        /// </summary>
        public float drawn;
        /// <summary>
        /// Area of all triangles together, in squared lengths of the leaf.
        /// </summary>
        public float area;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// The shape and colours of a leaf, in lengths of its blade (the petiole joins at the origin, the apex is
    /// at 0, 1), and how leaves stand on a twig. Angles in radians, colours in sRGB. Begin with
    /// `tree_leaf_shape_init`, or with the shape of a built-in leaf by `tree_leaf_shape_of`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_shape
    {
        /// <summary>
        /// `sizeof(tree_leaf_shape)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where mottling and the irregularities of a spray start. Default 0.
        /// </summary>
        public ulong seed;
        /// <summary>
        /// Right half of the outline from the petiole to the apex, three floats for each point: x (0 to 2), y
        /// (-1 to 2) and sharpness (0 rounded, 1 a corner). Default an ovate leaf.
        /// </summary>
        public float* outline;
        /// <summary>
        /// Number of points of the outline, 2 to 256.
        /// </summary>
        public UIntPtr n_outline;
        /// <summary>
        /// Angles of the main veins of the right half with the midrib, 0 to π. The midrib is always there.
        /// Default none.
        /// </summary>
        public float* rays;
        /// <summary>
        /// Number of `rays`, at most 8.
        /// </summary>
        public UIntPtr n_rays;
        /// <summary>
        /// Pairs of secondary veins per blade length, 0 to 64. Default 8.
        /// </summary>
        public float vein_pairs;
        /// <summary>
        /// Rise of the secondary veins along the main vein per distance from it, 0 to 4. Default 0.8.
        /// </summary>
        public float vein_slope;
        /// <summary>
        /// How much lighter veins are, 0 to 1. Default 0.5.
        /// </summary>
        public float vein_contrast;
        /// <summary>
        /// Teeth on each half of the margin, 0 to 100. Default 0.
        /// </summary>
        public uint n_teeth;
        /// <summary>
        /// How far teeth stand out, in blade lengths, 0 to 0.2. Default 0.
        /// </summary>
        public float tooth_depth;
        /// <summary>
        /// Teeth from 0 for waves to 1 for a saw that points to the apex. Default 0.
        /// </summary>
        public float tooth_sharpness;
        /// <summary>
        /// Whether each tooth bears three smaller ones. Default no.
        /// </summary>
        public uint double_teeth;
        /// <summary>
        /// Length of the petiole, as share of the whole leaf, 0 to 0.8. Default 0.15.
        /// </summary>
        public float petiole;
        /// <summary>
        /// Strength of mottling and shading, 0 to 1. Default 0.5.
        /// </summary>
        public float mottle;
        /// <summary>
        /// Whether leaves stand on a twig, as the fields that begin with `spray` say (lengths in lengths of
        /// the twig; along it, angles and sizes go evenly from the first value to the last). Default no.
        /// </summary>
        public uint has_spray;
        /// <summary>
        /// Leaves on the main twig, 1 to 400; one of them ends it. Default 9.
        /// </summary>
        public uint spray_leaves;
        /// <summary>
        /// Whether leaves stand in pairs. Default no.
        /// </summary>
        public uint spray_opposite;
        /// <summary>
        /// Share of the twig below the first leaf, 0 to 0.9. Default 0.2.
        /// </summary>
        public float spray_bare;
        /// <summary>
        /// Angle of the lowest and the topmost leaf with the twig, 0 to π. Default 1.15, 0.5.
        /// </summary>
        public fixed float spray_angle[2];
        /// <summary>
        /// Length of the lowest, a middle and the topmost leaf, 0.01 to 2. Default 0.42, 0.46, 0.4.
        /// </summary>
        public fixed float spray_size[3];
        /// <summary>
        /// How irregular angle, size and brightness are, 0 to 1. Default 0.5.
        /// </summary>
        public float spray_jitter;
        /// <summary>
        /// How far leaves turn towards the tip of the twig on their way, in leaf lengths, -0.5 to 0.5. Default
        /// 0.08.
        /// </summary>
        public float spray_bend;
        /// <summary>
        /// Thickness of the twig at its base, 0.001 to 0.2. Default 0.022.
        /// </summary>
        public float spray_twig;
        /// <summary>
        /// Side shoots, 0 to 32; they bear the same leaves, fewer. Default 0.
        /// </summary>
        public uint spray_shoots;
        /// <summary>
        /// Angle of the side shoots, 0 to π. Default 0.8.
        /// </summary>
        public float spray_shoot_angle;
        /// <summary>
        /// Length of the lowest side shoot, 0.05 to 1. Default 0.5.
        /// </summary>
        public float spray_shoot_size;
        /// <summary>
        /// Colour of the blade. Default a mid green.
        /// </summary>
        public fixed byte @base[3];
        /// <summary>
        /// Colour of the veins.
        /// </summary>
        public fixed byte vein[3];
        /// <summary>
        /// Colour of the petiole.
        /// </summary>
        public fixed byte stalk[3];
        /// <summary>
        /// What `tree_leaf_shape_autumn` turns the blade to.
        /// </summary>
        public fixed byte autumn[3];
        /// <summary>
        /// Colour of the twig of a spray.
        /// </summary>
        public fixed byte spray_twig_color[3];
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public byte reserved;
    }

    /// <summary>
    /// How a picture of a leaf goes on a card.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_card
    {
        /// <summary>
        /// `sizeof(tree_leaf_card)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width of the card per length from base to apex: `width` of `tree_leaf_look`.
        /// </summary>
        public float width;
        /// <summary>
        /// Share of the height, from the base, that is stalk (for a spray: bare twig), 0 to 1.
        /// </summary>
        public float petiole;
    }

    /// <summary>
    /// A picture's name and pixels: as input, or as a view of a `tree_texture`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_texture_pixels
    {
        /// <summary>
        /// `sizeof(tree_texture_pixels)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name for people and files, without extension.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// `4 * width * height` bytes: red, green, blue and alpha in sRGB with straight alpha, rows from top
        /// to bottom.
        /// </summary>
        public byte* pixels;
        /// <summary>
        /// Width in pixels, 1 or more.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels, 1 or more.
        /// </summary>
        public uint height;
    }

    /// <summary>
    /// How a skeleton becomes a word. Begin with `tree_chain_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_chain_params
    {
        /// <summary>
        /// `sizeof(tree_chain_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How far a node may be from its place, as a share of the tree's extent, 0 to 0.01: numbers are rounded to
        /// as few decimals as this allows. 0 writes all digits. Default 1e-5.
        /// </summary>
        public double tolerance;
        /// <summary>
        /// Which child goes on at a fork; the others are in brackets. Default `TREE_CONTINUATION_THICKEST`.
        /// </summary>
        public uint continuation; // tree_continuation
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
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
    /// What a word leaves open when a turtle draws it. Lengths and widths are in the word's own units, which `unit`
    /// or `height` makes metres. Begin with `tree_turtle_params_init`, `tree_grammar_turtle`, `tree_chain_turtle` or
    /// `tree_lsystem_preset`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_turtle_params
    {
        /// <summary>
        /// `sizeof(tree_turtle_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Length of an `F`, `f` or `G` without parameter, 0 to 1e6 units. Default 1.
        /// </summary>
        public double step;
        /// <summary>
        /// Diameter of wood before the first `!`, 0 to 1e6 units. Default 0.1.
        /// </summary>
        public double width;
        /// <summary>
        /// Angle of a turn without parameter in degrees, -3600 to 3600. Default 22.5.
        /// </summary>
        public double angle;
        /// <summary>
        /// What a `!` without parameter multiplies the width by, 0.01 to 1; `#` divides by it. Default √½: the
        /// cross-section halves.
        /// </summary>
        public double width_ratio;
        /// <summary>
        /// Size of a `~` without parameter, 0 to 1e6 units. Default 1.
        /// </summary>
        public double leaf_size;
        /// <summary>
        /// How readily shoots bend towards `tropism`: after each `F` the heading turns by this times the sine of the
        /// angle between them, in radians. -10 to 10, default 0. A module `_(e)` sets it for the rest of its branch.
        /// </summary>
        public double elasticity;
        /// <summary>
        /// Metres in a unit, 1e-6 to 1e6. Default 1.
        /// </summary>
        public double unit;
        /// <summary>
        /// The direction shoots bend to, each number -1000 to 1000. Default straight down.
        /// </summary>
        public fixed float tropism[3];
        /// <summary>
        /// Height of the tree in metres, 0.001 to 1000, in place of `unit`. Default 0: `unit` decides.
        /// </summary>
        public float height;
        /// <summary>
        /// Radius of the base in metres, 1e-6 to 100: all radii are multiplied by the one factor that makes it so.
        /// Default 0: widths are in the same unit as lengths.
        /// </summary>
        public float trunk_radius;
        /// <summary>
        /// How widths become radii. Default `TREE_TAPER_SMOOTH`.
        /// </summary>
        public uint taper; // tree_taper
        /// <summary>
        /// Where radii come from. Default `TREE_THICKNESS_AUTO`.
        /// </summary>
        public uint thickness; // tree_thickness
        /// <summary>
        /// Whether polygons that look like leaves become leaves too. Default 1.
        /// </summary>
        public uint polygon_leaves;
        /// <summary>
        /// The rule for radii. Default NULL: that of `tree_radius_rule_init`.
        /// </summary>
        public tree_radius_rule* radii;
        /// <summary>
        /// What the tree is; its leaf kinds are those of `~(size, kind)`. Default NULL: an oak.
        /// </summary>
        public tree_species* species;
    }

    /// <summary>
    /// What drawing a word took, and what was left out.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_turtle_report
    {
        /// <summary>
        /// `sizeof(tree_turtle_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// `tree_lsystem_grow`: steps of the derivation. Else 0.
        /// </summary>
        public ulong n_steps;
        /// <summary>
        /// `tree_lsystem_grow`: modules that all steps wrote together. Else 0.
        /// </summary>
        public ulong n_produced;
        /// <summary>
        /// Modules read by the turtle.
        /// </summary>
        public ulong n_modules;
        /// <summary>
        /// Most brackets open at a time.
        /// </summary>
        public ulong depth;
        /// <summary>
        /// Gaps made by `f` before wood was drawn again. The skeleton runs on through them: a tree is connected.
        /// </summary>
        public ulong gaps;
        /// <summary>
        /// `F` and `G` of no length, which make no node.
        /// </summary>
        public ulong merged;
        /// <summary>
        /// Modules that a `%` cut off.
        /// </summary>
        public ulong cut;
        /// <summary>
        /// Polygons with fewer than three corners, left out.
        /// </summary>
        public ulong thin_polygons;
        /// <summary>
        /// Polygons that became leaves as well.
        /// </summary>
        public ulong polygon_leaves;
        /// <summary>
        /// Symbols that say nothing to the turtle: `tree_turtle_trace_skipped` names them.
        /// </summary>
        public ulong n_skipped;
        /// <summary>
        /// Metres in a unit of length.
        /// </summary>
        public double scale;
        /// <summary>
        /// Whether the word set any width: 1 or 0.
        /// </summary>
        public uint widths;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Where a text or a word is wrong, for an editor that marks the place; what is wrong is in
    /// `tree_error_text`. Written when the call fails, too.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_grammar_report
    {
        /// <summary>
        /// `sizeof(tree_grammar_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// `TREE_GRAMMAR_PLACE_TEXT`: line of the text, from 1; else 0.
        /// </summary>
        public ulong line;
        /// <summary>
        /// `TREE_GRAMMAR_PLACE_TEXT`: column in characters, from 1; else 0.
        /// </summary>
        public ulong column;
        /// <summary>
        /// `TREE_GRAMMAR_PLACE_MODULE`: index of the module in the word, from 0; else 0.
        /// </summary>
        public ulong module;
        /// <summary>
        /// Which of these hold.
        /// </summary>
        public uint place; // tree_grammar_place
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What a grammar says beside its productions.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_grammar_info
    {
        /// <summary>
        /// `sizeof(tree_grammar_info)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The text it was read from.
        /// </summary>
        public tree_str text;
        /// <summary>
        /// Angle of turns without a parameter in degrees (`angle:`). 90 where the text does not say.
        /// </summary>
        public double angle;
        /// <summary>
        /// Seed that the text proposes (`seed:`). 0 where it does not.
        /// </summary>
        public ulong seed;
        /// <summary>
        /// Number of productions, without those of decomposition and interpretation.
        /// </summary>
        public UIntPtr n_productions;
        /// <summary>
        /// Number of named constants: `tree_grammar_constant`.
        /// </summary>
        public UIntPtr n_constants;
        /// <summary>
        /// Number of kinds of modules: `tree_grammar_kind`.
        /// </summary>
        public UIntPtr n_kinds;
        /// <summary>
        /// Number of derivations that the text asks for (`steps:`), 0 to 1,000,000. 0 where it does not.
        /// </summary>
        public uint steps;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What is known of a preset. All texts are valid for ever.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_lsystem_preset_info
    {
        /// <summary>
        /// `sizeof(tree_lsystem_preset_info)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its name: `oak`, `honda-a`, `abop-1.24f`.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// What it looks like, in a few words.
        /// </summary>
        public tree_str title;
        /// <summary>
        /// Where it was published; empty for those of this library.
        /// </summary>
        public tree_str source;
        /// <summary>
        /// The text of its grammar, before its constants are changed.
        /// </summary>
        public tree_str text;
        /// <summary>
        /// Number of constants of the text that it changes: `tree_lsystem_preset_constant`.
        /// </summary>
        public UIntPtr n_constants;
    }

    /// <summary>
    /// A view of the polygons that a turtle drew between `{` and `}`, leaf or not, in the order of their ends.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_turtle_polygons
    {
        /// <summary>
        /// `sizeof(tree_turtle_polygons)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of polygons.
        /// </summary>
        public UIntPtr n_polygons;
        /// <summary>
        /// `n_polygons` + 1 places: polygon i has the corners from `starts[i]` to before `starts[i + 1]`, three or
        /// more.
        /// </summary>
        public ulong* starts;
        /// <summary>
        /// Number of corners of all polygons.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Three floats for each corner, in metres, in the order they were drawn.
        /// </summary>
        public float* vertices;
        /// <summary>
        /// One for each polygon: the colour number when it was closed (`'`).
        /// </summary>
        public uint* colors;
        /// <summary>
        /// One for each polygon: the skeleton's node it hangs on.
        /// </summary>
        public uint* nodes;
    }

    /// <summary>
    /// A word in columns: as input, or as a view of a `tree_word`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_word_columns
    {
        /// <summary>
        /// `sizeof(tree_word_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of modules.
        /// </summary>
        public UIntPtr n_modules;
        /// <summary>
        /// One for each module: its kind, which says its symbol and number of parameters (`tree_word_kind`).
        /// </summary>
        public ushort* kinds;
        /// <summary>
        /// Number of parameters of all modules together.
        /// </summary>
        public UIntPtr n_params;
        /// <summary>
        /// The parameters of all modules, one after another.
        /// </summary>
        public double* @params;
        /// <summary>
        /// Number of kinds in the alphabet. Not used as input.
        /// </summary>
        public UIntPtr n_kinds;
    }

    /// <summary>
    /// What a word came from. Columns that do not apply are NULL.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_word_history
    {
        /// <summary>
        /// `sizeof(tree_word_history)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Derived words: number of steps, and 1. Else 0.
        /// </summary>
        public UIntPtr n_growth;
        /// <summary>
        /// Number of modules of the axiom, and then of the word after each step.
        /// </summary>
        public ulong* growth;
        /// <summary>
        /// Words of skeletons: number of nodes that the word draws. Else 0.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// For each of these, in the order of the word, the node of the skeleton it stands for.
        /// </summary>
        public uint* nodes;
        /// <summary>
        /// Words of skeletons: number of leaves that the word draws. Else 0.
        /// </summary>
        public UIntPtr n_leaves;
        /// <summary>
        /// For each of these, in the order of the word, the leaf of the foliage it stands for.
        /// </summary>
        public uint* leaves;
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
        public IntPtr allocate;
        /// <summary>
        /// Gives back what `allocate` gave for this size and alignment.
        /// </summary>
        public IntPtr release;
    }

    /// <summary>
    /// What a mesh was made of and what was left out.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mesh_report
    {
        /// <summary>
        /// `sizeof(tree_mesh_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Vertices of all surfaces.
        /// </summary>
        public ulong n_vertices;
        /// <summary>
        /// Triangles of all surfaces.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Tubes drawn.
        /// </summary>
        public ulong n_tubes;
        /// <summary>
        /// Axes of which so little comes out of the parent's wood that they are drawn as a point.
        /// </summary>
        public ulong n_stubs;
        /// <summary>
        /// Axes not drawn because all their nodes lie at one place, or inside the parent's wood. What they
        /// carry is drawn on the axis below.
        /// </summary>
        public ulong skipped_axes;
        /// <summary>
        /// Laterals whose base was turned or moved because another one has its place.
        /// </summary>
        public ulong moved_axes;
        /// <summary>
        /// Nodes passed over because they lie within a tenth of a radius of the one before, or back inside
        /// the wood.
        /// </summary>
        public ulong skipped_nodes;
        /// <summary>
        /// Leaves of size 0, not drawn.
        /// </summary>
        public ulong skipped_leaves;
        /// <summary>
        /// Number of leaf kinds whose picture could not be outlined as their look asks (it has no mask, or
        /// nothing of it is visible): drawn as cards.
        /// </summary>
        public ulong n_leaf_fallbacks;
        /// <summary>
        /// Those leaf kinds, or NULL for none. Part of the mesh: valid until it is freed.
        /// </summary>
        public uint* leaf_fallbacks;
    }

    /// <summary>
    /// How a surface is subdivided. Begin with `tree_subdivide_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_subdivide_params
    {
        /// <summary>
        /// `sizeof(tree_subdivide_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How often each triangle becomes four, 0 to 8. Default 2.
        /// </summary>
        public uint levels;
        /// <summary>
        /// Angle between normals in radians above which an edge is a crease, 0 to π. Default 1.
        /// </summary>
        public float crease;
        /// <summary>
        /// Rounds in which the limit surface is brought to the old points, 0 (Loop's own, which shrinks) to
        /// 20. Default 1. More is for coarse meshes: where rings stand much closer than they are wide, as at
        /// the joints of a fine mesh, each round overshoots and the surface can fold. Fine meshes shrink
        /// little: 0 or 1 is enough.
        /// </summary>
        public uint fit;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How bark is displaced. Lengths in metres. Begin with `tree_displace_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_displace_params
    {
        /// <summary>
        /// `sizeof(tree_displace_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Height of the highest ridges and depth of the deepest furrows, 0 to 10 m; most points move less
        /// than half as far. Default 1 cm.
        /// </summary>
        public float amplitude;
        /// <summary>
        /// Wavelength across the branch, 0.1 mm to 100 m. Default 8 cm.
        /// </summary>
        public float scale;
        /// <summary>
        /// How many times longer the relief is along the branch, 1 to 20. Default 3.
        /// </summary>
        public float stretch;
        /// <summary>
        /// Layers of noise, each of half the wavelength and half the height, 1 to 8. Default 3. The cost grows
        /// with it.
        /// </summary>
        public uint octaves;
        /// <summary>
        /// Largest share of the local radius by which a point moves, 0 to 0.5. Default 0.15.
        /// </summary>
        public float share;
        /// <summary>
        /// The local radius where the mesh has no branches, 0 to 1000 m. Default 10 cm.
        /// </summary>
        public float radius;
        /// <summary>
        /// Whether points on the ground keep their height, so that the tree stands as it stood. Default yes.
        /// </summary>
        public uint has_ground;
        /// <summary>
        /// With `has_ground`: points at or below this height keep theirs. Default 1 mm.
        /// </summary>
        public float ground;
    }

    /// <summary>
    /// How ambient occlusion is computed. Begin with `tree_occlusion_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_occlusion_params
    {
        /// <summary>
        /// `sizeof(tree_occlusion_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Cells along the longest side of the tree, 4 to 512. Default 64. Cost grows with its third power.
        /// </summary>
        public uint cells;
        /// <summary>
        /// Directions that light comes from, 6 to 1024. Default 48. Cost grows with it.
        /// </summary>
        public uint directions;
        /// <summary>
        /// Share of the light that a leaf keeps back, 0 to 1. Default 0.5: leaves let light pass, and their
        /// cards are not full.
        /// </summary>
        public float leaf_opacity;
        /// <summary>
        /// Light from below the horizon as a share of that from above, 0.01 (dark ground) to 1. Default 0.5:
        /// what looks to the sky counts more than what looks to the ground.
        /// </summary>
        public float ground;
    }

    /// <summary>
    /// Triangles of one material, in columns: a view of a mesh's surface, or input. Columns that are absent
    /// are NULL. Triangles are counter-clockwise seen from outside; texture coordinates have their origin at
    /// the top left of the picture, v downwards.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_surface
    {
        /// <summary>
        /// `sizeof(tree_surface)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Number of indices, three for each triangle.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Number of leaves; 0 for bark.
        /// </summary>
        public UIntPtr n_anchors;
        /// <summary>
        /// Vertices of each leaf, `n_vertices / n_anchors`; 0 when the surface is not made of leaves. Ignored
        /// in input.
        /// </summary>
        public UIntPtr vertices_per_leaf;
        /// <summary>
        /// Three floats for each vertex: where it is, in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Three floats for each vertex: its unit normal.
        /// </summary>
        public float* normals;
        /// <summary>
        /// Two floats for each vertex: texture coordinates. Bark repeats beyond 0 to 1.
        /// </summary>
        public float* uvs;
        /// <summary>
        /// Four floats for each vertex, or NULL: the unit tangent, the direction in which u grows along the
        /// surface, and the sign that makes `sign * cross(normal, tangent)` point against v, up the picture
        /// (as glTF).
        /// </summary>
        public float* tangents;
        /// <summary>
        /// Two floats for each vertex, or NULL: texture coordinates for a light map, within 0 to 1, in which
        /// no two places of the whole mesh overlap.
        /// </summary>
        public float* uvs2;
        /// <summary>
        /// One for each vertex, or NULL: the branch it moves with, an index into the branches that
        /// `tree_mesh_branches` views.
        /// </summary>
        public uint* branches;
        /// <summary>
        /// One for each vertex, or NULL: ambient occlusion, 0 (dark) to 1 (open).
        /// </summary>
        public float* occlusion;
        /// <summary>
        /// One for each vertex, or NULL when no vertex is a copy: the first vertex that stands at the same
        /// point of the closed surface, itself unless it is a copy at a seam of the texture.
        /// </summary>
        public uint* welds;
        /// <summary>
        /// Three floats for each leaf, or NULL when there are none: where it is attached. All leaves have the
        /// same number of vertices and lie one after the other.
        /// </summary>
        public float* anchors;
        /// <summary>
        /// Three for each triangle: its vertices.
        /// </summary>
        public uint* indices;
        /// <summary>
        /// The material, an index into the mesh's materials.
        /// </summary>
        public uint material;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What `tree_mesh_examine` found. Vertices that are copies of one point, for a seam of the texture, count
    /// as one. Lengths in metres.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_topology
    {
        /// <summary>
        /// `sizeof(tree_topology)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Points that triangles use; copies at seams count once.
        /// </summary>
        public ulong n_points;
        /// <summary>
        /// Edges between points.
        /// </summary>
        public ulong n_edges;
        /// <summary>
        /// Triangles of three different points.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Triangles with two corners at one point. They have no area and are not counted elsewhere.
        /// </summary>
        public ulong collapsed_triangles;
        /// <summary>
        /// Edges of one triangle only: holes.
        /// </summary>
        public ulong boundary_edges;
        /// <summary>
        /// Edges of more than two triangles.
        /// </summary>
        public ulong non_manifold_edges;
        /// <summary>
        /// Edges of two triangles that run along them in the same direction: one faces inwards.
        /// </summary>
        public ulong misoriented_edges;
        /// <summary>
        /// Points whose triangles form more than one fan.
        /// </summary>
        public ulong non_manifold_points;
        /// <summary>
        /// Vertices that do not stand exactly where the vertex they are welded to stands: cracks.
        /// </summary>
        public ulong cracks;
        /// <summary>
        /// Pieces that share no point.
        /// </summary>
        public ulong components;
        /// <summary>
        /// Triangles with less area than `TREE_FLAT_SHARE` allows.
        /// </summary>
        public ulong flat_triangles;
        /// <summary>
        /// Euler characteristic, points − edges + triangles: 2 for each closed piece without handles.
        /// </summary>
        public long euler;
        /// <summary>
        /// Enclosed volume in m³; of a closed surface only. Negative when its triangles face inwards.
        /// </summary>
        public double volume;
        /// <summary>
        /// Area in m².
        /// </summary>
        public double area;
        /// <summary>
        /// Area of the smallest triangle in m²; infinite without triangles.
        /// </summary>
        public double smallest_area;
        /// <summary>
        /// Smallest angle of any triangle in radians, up to π/3; infinite without triangles.
        /// </summary>
        public double smallest_angle;
        /// <summary>
        /// Whether this is a closed, consistently oriented 2-manifold, of any number of pieces.
        /// </summary>
        public uint is_closed;
        /// <summary>
        /// Not used; 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of crossings. Pairs are two triangle numbers each, the lower one first, sorted.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_crossing_pairs
    {
        /// <summary>
        /// `sizeof(tree_crossing_pairs)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of `pairs`.
        /// </summary>
        public UIntPtr n_pairs;
        /// <summary>
        /// Number of `pairs_at_points`.
        /// </summary>
        public UIntPtr n_pairs_at_points;
        /// <summary>
        /// Triangles that share no point of the surface and yet have a place in common; NULL for none.
        /// </summary>
        public uint* pairs;
        /// <summary>
        /// Triangles that share one point of the surface and have another place in common; NULL for none.
        /// </summary>
        public uint* pairs_at_points;
        /// <summary>
        /// Different triangles in either list.
        /// </summary>
        public ulong n_triangles;
    }

    /// <summary>
    /// How much there is of a mesh.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mesh_totals
    {
        /// <summary>
        /// `sizeof(tree_mesh_totals)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of surfaces.
        /// </summary>
        public ulong n_surfaces;
        /// <summary>
        /// Number of materials.
        /// </summary>
        public ulong n_materials;
        /// <summary>
        /// Number of branches that move in the wind.
        /// </summary>
        public ulong n_branches;
        /// <summary>
        /// Vertices of all surfaces.
        /// </summary>
        public ulong n_vertices;
        /// <summary>
        /// Triangles of all surfaces.
        /// </summary>
        public ulong n_triangles;
    }

    /// <summary>
    /// A box and a ball around vertices, in metres. All 0 when there are no vertices.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bounds
    {
        /// <summary>
        /// `sizeof(tree_bounds)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Lower corner of the box.
        /// </summary>
        public fixed float min[3];
        /// <summary>
        /// Upper corner of the box.
        /// </summary>
        public fixed float max[3];
        /// <summary>
        /// Centre of a ball that holds every vertex: the middle of the box.
        /// </summary>
        public fixed float center[3];
        /// <summary>
        /// Its radius, at most √3 times that of the smallest such ball.
        /// </summary>
        public float radius;
    }

    /// <summary>
    /// A bracketed chain of modules, as far as its branches are concerned.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_token_columns
    {
        /// <summary>
        /// `sizeof(tree_token_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of modules, brackets included.
        /// </summary>
        public UIntPtr n_tokens;
        /// <summary>
        /// One for each: a `TREE_TOKEN_` constant.
        /// </summary>
        public byte* kinds;
        /// <summary>
        /// One for each: the length that it draws, finite and 0 or more; 0 for all that do not advance. Those of brackets
        /// are not looked at.
        /// </summary>
        public double* lengths;
    }

    /// <summary>
    /// Branches in columns.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_adt_columns
    {
        /// <summary>
        /// `sizeof(tree_adt_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of branches, at least 1.
        /// </summary>
        public UIntPtr n_branches;
        /// <summary>
        /// One for each branch: the branch it stems from, or `TREE_NO_PARENT` for branch 0.
        /// </summary>
        public uint* parents;
        /// <summary>
        /// One for each branch: the length of its own modules together.
        /// </summary>
        public double* lengths;
        /// <summary>
        /// One for each branch: the area that its own modules show from the side, in m² for skeletons and trees; that of its
        /// own leaves is in it for trees. Lengths for chains of modules.
        /// </summary>
        public double* areas;
    }

    /// <summary>
    /// A multi-chain in columns.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_multi_chain_columns
    {
        /// <summary>
        /// `sizeof(tree_multi_chain_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of items.
        /// </summary>
        public UIntPtr n_items;
        /// <summary>
        /// One for each item: a `TREE_ITEM_` constant.
        /// </summary>
        public byte* kinds;
        /// <summary>
        /// One for each item: the place of a module in the plain chain, or the number of a state.
        /// </summary>
        public uint* values;
        /// <summary>
        /// Number of levels, at least 1.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// One for each level: the item it ends before. The first `k` levels are the items before `ends[k - 1]`; level `i`
        /// alone begins at `ends[i - 1]`, level 0 at 0.
        /// </summary>
        public uint* ends;
        /// <summary>
        /// Number of states that a turtle has to keep at once.
        /// </summary>
        public uint n_states;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A level in a file, and when it is shown.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_level_share
    {
        /// <summary>
        /// The level, as in `tree_multi_mesh_mesh_at`.
        /// </summary>
        public float level;
        /// <summary>
        /// Share of the screen's height, 0 to 1, from which on it is shown.
        /// </summary>
        public float share;
    }

    /// <summary>
    /// How much there is of a mesh with levels.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_multi_mesh_totals
    {
        /// <summary>
        /// `sizeof(tree_multi_mesh_totals)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of levels, at least 1.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Number of surfaces, those without triangles included.
        /// </summary>
        public UIntPtr n_surfaces;
        /// <summary>
        /// Triangles of all levels together.
        /// </summary>
        public ulong n_triangles;
    }

    /// <summary>
    /// One more column of a surface, for the shader that lets branches grow in.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_multi_mesh_column
    {
        /// <summary>
        /// `sizeof(tree_multi_mesh_column)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Four floats for each vertex of the surface: the fork that its path stems from, in metres, and the number of the
        /// path, from 0 on.
        /// </summary>
        public float* branches;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
    }

    /// <summary>
    /// What is drawn of a surface: so many of its indices, from the first on.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_multi_draw
    {
        /// <summary>
        /// Number of the surface.
        /// </summary>
        public uint surface;
        /// <summary>
        /// Number of indices; may be 0.
        /// </summary>
        public uint index_count;
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
    /// How much of a stream has arrived.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stream_report
    {
        /// <summary>
        /// `sizeof(tree_stream_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Levels that are whole and checked.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Levels of the whole stream; 0 while its head is not there.
        /// </summary>
        public UIntPtr n_levels_in_all;
        /// <summary>
        /// Bytes that have been read.
        /// </summary>
        public ulong n_bytes;
        /// <summary>
        /// 1 when all has arrived and its check holds, otherwise 0.
        /// </summary>
        public uint is_complete;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a stream is written. Begin with `tree_stream_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stream_params
    {
        /// <summary>
        /// `sizeof(tree_stream_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Precision of positions and leaf sizes in metres, 0 or 1e-6 to 1; radii are eight times as precise, leaves are
        /// turned by at most 0.2 degrees. Default 0: exact, to the last bit, in two to three times the bytes.
        /// </summary>
        public float precision;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// The camera of one photograph. The tree's base is the world's origin, +Y is up. Begin with
    /// `tree_particle_camera_init`, or let `tree_align` find it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_particle_camera
    {
        /// <summary>
        /// `sizeof(tree_particle_camera)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a quarter turn on
        /// +X. -1e6 to 1e6; default 0.
        /// </summary>
        public float yaw;
        /// <summary>
        /// How far the camera looks down, in radians, -1.5 to 1.5. A photograph from the ground looks up:
        /// negative. Default 0.
        /// </summary>
        public float pitch;
        /// <summary>
        /// Vertical field of view of the whole picture in radians, 0.017 to 2.8: a phone held upright has about
        /// 1.2. 0, the default, is parallel projection, close enough for a photograph from afar.
        /// </summary>
        public float fov;
        /// <summary>
        /// Size of the picture in pixels, 1 to 1e6 each. Default 1, 1: set it.
        /// </summary>
        public fixed float size[2];
        /// <summary>
        /// Where the tree's base is in the picture, in pixels from the top left; may lie outside. Default 0.5, 1:
        /// set it.
        /// </summary>
        public fixed float @base[2];
        /// <summary>
        /// Metres for a pixel, at the tree's base, 1e-7 to 1e6. Default 1: set it.
        /// </summary>
        public float scale;
    }

    /// <summary>
    /// One photograph, ready to be used: what it shows of the tree and where it was taken from. Begin with
    /// `tree_particle_view_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_particle_view
    {
        /// <summary>
        /// `sizeof(tree_particle_view)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How much of each pixel the tree covers. No default: NULL, which is refused.
        /// </summary>
        public tree_matte* matte;
        /// <summary>
        /// The photograph itself, of the same size; may be NULL.
        /// </summary>
        public tree_photo* photo;
        /// <summary>
        /// Where it was taken from; its `size` is that of the matte. No default: NULL, which is refused.
        /// </summary>
        public tree_particle_camera* camera;
    }

    /// <summary>
    /// What a density depends on. Begin with `tree_density_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_density_params
    {
        /// <summary>
        /// `sizeof(tree_density_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Voxels along the tree's height, 4 to 256. Default 48. Memory and time grow with its cube. Trees more
        /// than four times as wide as high get larger voxels.
        /// </summary>
        public uint resolution;
        /// <summary>
        /// Voxels are thrown away where a view covers less of them than this, 0 to 1. Default 0.05. Higher
        /// values cut off thin foliage.
        /// </summary>
        public float threshold;
        /// <summary>
        /// How far horizontal sections of the crown are rounded, 0 (boxes from two views) to 1 (ellipses of the
        /// widths seen). Default 1.
        /// </summary>
        public float rounding;
        /// <summary>
        /// Rays for every side of a voxel, 0.25 to 4, in each view. Default 1. Memory and time grow with its
        /// square.
        /// </summary>
        public float rays;
        /// <summary>
        /// Least transparency of a pixel, 1e-4 to 0.5: what is opaque counts as letting so much through.
        /// Default 0.02. Lower values make the densest parts denser.
        /// </summary>
        public float least_transparency;
        /// <summary>
        /// Weight of the demand that densities are small and even, 0.01 to 10. Default 0.7. Higher values thin
        /// out what is few voxels deep; lower ones leave specks where views differ, and take longer.
        /// </summary>
        public float evenness;
        /// <summary>
        /// Most iterations of the solver, 1 to 100,000. Default 500.
        /// </summary>
        public uint iterations;
        /// <summary>
        /// The solver stops when the densities are surely within this share of the exact ones, 1e-4 to 1.
        /// Default 0.02.
        /// </summary>
        public float tolerance;
    }

    /// <summary>
    /// How a density came about.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_density_report
    {
        /// <summary>
        /// `sizeof(tree_density_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Rays: equations.
        /// </summary>
        public ulong n_rays;
        /// <summary>
        /// Voxels that were left after carving: unknowns.
        /// </summary>
        public ulong n_voxels;
        /// <summary>
        /// Voxels thrown away by carving.
        /// </summary>
        public ulong n_carved;
        /// <summary>
        /// Voxels that no picture shows.
        /// </summary>
        public ulong n_unseen;
        /// <summary>
        /// Entries of the system of equations that are not zero.
        /// </summary>
        public ulong n_entries;
        /// <summary>
        /// What looking through the density misses of the mattes, as a share: 0 when it gives them exactly.
        /// </summary>
        public double residual;
        /// <summary>
        /// Iterations of the solver.
        /// </summary>
        public uint n_iterations;
        /// <summary>
        /// 1 when the solver stopped at the most iterations allowed, and the density is not final.
        /// </summary>
        public uint not_converged;
        /// <summary>
        /// Views that contradict the others.
        /// </summary>
        public uint n_contradictions;
        /// <summary>
        /// Views that are covered all over, and say nothing about the tree's outline.
        /// </summary>
        public uint n_opaque;
    }

    /// <summary>
    /// How one view fits a density.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_density_view
    {
        /// <summary>
        /// What looking through the density misses of the view's matte, as a share: 0 when it gives it exactly.
        /// </summary>
        public double residual;
        /// <summary>
        /// 1 when the view contradicts the others.
        /// </summary>
        public uint contradicts;
        /// <summary>
        /// 1 when the view is covered all over, and says nothing about the tree's outline.
        /// </summary>
        public uint is_opaque;
    }

    /// <summary>
    /// A view of what carving left.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_carved_columns
    {
        /// <summary>
        /// `sizeof(tree_carved_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of voxels that are left.
        /// </summary>
        public UIntPtr n_voxels;
        /// <summary>
        /// For each of them its row in the grid, rising.
        /// </summary>
        public uint* voxels;
        /// <summary>
        /// For each of them how far it lies inside the rounded crown, 0 to 1.
        /// </summary>
        public float* weights;
        /// <summary>
        /// Voxels that were thrown away although a view shows them.
        /// </summary>
        public ulong n_carved;
        /// <summary>
        /// Voxels that no picture shows.
        /// </summary>
        public ulong n_unseen;
    }

    /// <summary>
    /// A view of equations. The entries of ray `i` are rows `starts[i]` up to, but not including,
    /// `starts[i + 1]`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_equations_columns
    {
        /// <summary>
        /// `sizeof(tree_equations_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of rays: rows of A.
        /// </summary>
        public UIntPtr n_rays;
        /// <summary>
        /// `n_rays + 1` numbers, 0 first and `n_entries` last.
        /// </summary>
        public ulong* starts;
        /// <summary>
        /// For each ray what is seen along it: b.
        /// </summary>
        public float* targets;
        /// <summary>
        /// Number of voxels: columns of A, in the order of `tree_carved_view`.
        /// </summary>
        public UIntPtr n_voxels;
        /// <summary>
        /// For each voxel how far it lies inside the rounded crown, above 0 to 1.
        /// </summary>
        public float* weights;
        /// <summary>
        /// Number of entries of A that are not zero.
        /// </summary>
        public UIntPtr n_entries;
        /// <summary>
        /// For each entry the voxel that the ray meets.
        /// </summary>
        public uint* voxels;
        /// <summary>
        /// For each entry the ray's length in it, in metres.
        /// </summary>
        public float* lengths;
        /// <summary>
        /// Weight of the demand that densities are small and even, in metres.
        /// </summary>
        public float lambda;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A stroke over a matte. Begin with `tree_density_stroke_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_density_stroke
    {
        /// <summary>
        /// `sizeof(tree_density_stroke)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its course: two floats for each point, in pixels from the top left. One point makes a dot.
        /// </summary>
        public float* points;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Width in pixels, above 0. Default 20.
        /// </summary>
        public float width;
        /// <summary>
        /// What the matte becomes in its middle, 0 (erase) to 1 (opaque). Default 1.
        /// </summary>
        public float value;
        /// <summary>
        /// Share of its width over which it fades, 0 (hard) to 1. Default 0.5.
        /// </summary>
        public float softness;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A stroke of a ball through a grid. Begin with `tree_density_brush_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_density_brush
    {
        /// <summary>
        /// `sizeof(tree_density_brush)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its course: three floats for each point, in metres. One point makes a ball.
        /// </summary>
        public float* points;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Radius in metres, above 0. Default 0.5.
        /// </summary>
        public float radius;
        /// <summary>
        /// What the grid becomes in its middle, 0 (erase) to 1e6 per metre. Default 1.
        /// </summary>
        public float value;
        /// <summary>
        /// Share of its radius over which it fades, 0 (hard) to 1. Default 0.5.
        /// </summary>
        public float softness;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a direction field is made. Begin with `tree_field_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_field_params
    {
        /// <summary>
        /// `sizeof(tree_field_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Table: two floats for each point: a distance as a share of the picture's height, ascending, and a
        /// share, 0 to 1. Before the first and after the last it is as there. Default NULL.
        /// </summary>
        public float* blend_table;
        /// <summary>
        /// Table: number of points, at least 1.
        /// </summary>
        public UIntPtr n_blend_table;
        /// <summary>
        /// Function. Default NULL. Sessions and `tree_from_photos` keep parameters longer than a call and take
        /// no functions: give them a table.
        /// </summary>
        public IntPtr blend_function;
        /// <summary>
        /// Handed to `blend_function`.
        /// </summary>
        public void* blend_user;
        /// <summary>
        /// How directions towards and along branches are blended. Default `TREE_BLEND_LINEAR`.
        /// </summary>
        public uint blend; // tree_blend
        /// <summary>
        /// Linear: distance as a share of the picture's height, 0.0001 to 10. Default 0.05.
        /// </summary>
        public float blend_reach;
        /// <summary>
        /// Linear: greatest share, 0 to 1. Default 0.85.
        /// </summary>
        public float blend_most;
        /// <summary>
        /// Constant: share, 0 to 1. Default 0.
        /// </summary>
        public float blend_share;
        /// <summary>
        /// Cells over the height of the picture, 1 to 4096. Default 100. Cost grows with the square.
        /// </summary>
        public uint rows;
        /// <summary>
        /// How far the grid reaches beyond the picture on every side, as a share of its height, 0 to 2. Default
        /// 0.1.
        /// </summary>
        public float margin;
    }

    /// <summary>
    /// A view of a direction field.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_direction_field_columns
    {
        /// <summary>
        /// `sizeof(tree_direction_field_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Two floats for each cell, row by row from the top left: x to the right, y up, length 0 to 1. 0, 0
        /// where there is no direction.
        /// </summary>
        public float* vectors;
        /// <summary>
        /// Number of cells: `size[0] * size[1]`.
        /// </summary>
        public UIntPtr n_vectors;
        /// <summary>
        /// Cells across and down.
        /// </summary>
        public fixed uint size[2];
        /// <summary>
        /// Pixels for a cell.
        /// </summary>
        public float cell;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How traces become a tree. Begin with `tree_finish_params_init`, which makes it an oak, or with
    /// `tree_finish_params_find`. What it points at then belongs to the library, lives for ever and is not to be
    /// written: to alter twigs or leaves, copy them to a struct of your own and point at that.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_finish_params
    {
        /// <summary>
        /// `sizeof(tree_finish_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How thick branches are: a rule of the kind `TREE_RADII_PIPE`. Without a `trunk_radius` that seen in
        /// the pictures is taken, and where they show no bare trunk, `slenderness`. NULL for the default: an
        /// exponent of 2.49.
        /// </summary>
        public tree_radius_rule* radii;
        /// <summary>
        /// Twigs on the ends of the traces; NULL for none. Default those of an oak.
        /// </summary>
        public tree_twig_params* twigs;
        /// <summary>
        /// Leaves; NULL for a bare tree. Default sprays of an oak's leaves.
        /// </summary>
        public tree_leaf_params* leaves;
        /// <summary>
        /// Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
        /// name.
        /// </summary>
        public tree_species* species;
        /// <summary>
        /// Passes of smoothing along branches, 0 to 100. Default 4.
        /// </summary>
        public uint smoothing;
        /// <summary>
        /// Nodes nearer to the one below than this share of the tree's height are left out, 0 to 0.1. Default
        /// 0.005.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Radius of the trunk as a share of the height where nothing tells it, 1e-4 to 0.2. Default 0.017.
        /// </summary>
        public float slenderness;
        /// <summary>
        /// Area of a blade as a share of its length squared, 1e-3 to 2: how much a leaf covers, and so how many
        /// it takes. Default 0.333, an oak's spray; an oak leaf has 0.28, a needle 0.04.
        /// </summary>
        public float blade;
        /// <summary>
        /// Leaves against what the pictures ask for, 0 to 10. Default 1.
        /// </summary>
        public float fullness;
        /// <summary>
        /// Times the leaves are counted in the pictures and their density put right, 0 to 10. Default 3.
        /// </summary>
        public uint corrections;
        /// <summary>
        /// Leaves and twigs where a picture's matte is below this are discarded, 0 (none) to 1. Default 0.5.
        /// </summary>
        public float empty;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What growing twigs and leaves did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_crown_report
    {
        /// <summary>
        /// `sizeof(tree_crown_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Nodes of twigs.
        /// </summary>
        public ulong n_twig_nodes;
        /// <summary>
        /// Nodes of twigs cut off because they reached where a picture is empty.
        /// </summary>
        public ulong n_twig_nodes_cut;
        /// <summary>
        /// Leaves (blades) that stayed.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Leaves discarded because a picture is empty there.
        /// </summary>
        public ulong n_leaves_discarded;
        /// <summary>
        /// Leaves the pictures ask for, as far as the last correction knows.
        /// </summary>
        public double leaves_asked;
    }

    /// <summary>
    /// How particles move and join. Lengths are shares of the tree's height, so that the same numbers do for a
    /// shrub and a giant. Begin with `tree_flow_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_flow_params
    {
        /// <summary>
        /// `sizeof(tree_flow_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Particles, 1 to 10 million: 500 to 1000 for trees of medium size, 1000 to 2000 for large ones.
        /// Default 1500. Cost grows a little more than linearly.
        /// </summary>
        public uint particles;
        /// <summary>
        /// Steps after which particles still on their way are steered straight to the base, 1 to 100,000.
        /// Default 200.
        /// </summary>
        public uint steps;
        /// <summary>
        /// Way of a particle in one step, 1e-4 to 0.1. Default 0.008. Smaller is smoother and slower.
        /// </summary>
        public float step;
        /// <summary>
        /// Particles nearer than this join, 1e-5 to 0.2. Default 0.02. Larger gives fewer, longer branches.
        /// </summary>
        public float join;
        /// <summary>
        /// How far a particle sees its nearest neighbour, 0 to 1. Default 0.1.
        /// </summary>
        public float sight;
        /// <summary>
        /// Pull along the pictures' direction fields, 0 to 10. Default 1. The pulls decide the direction only,
        /// so just their proportions matter.
        /// </summary>
        public float image;
        /// <summary>
        /// Pull towards the base, through the densest way, 0 to 10. Default 0.3. Where no field says anything
        /// it counts in full.
        /// </summary>
        public float @base;
        /// <summary>
        /// Pull of the nearest neighbour when it is close, 0 to 10. Default 0.7. Larger joins twigs sooner.
        /// </summary>
        public float neighbour;
        /// <summary>
        /// Way on which a lone particle turns most of the way into a new direction, 1e-4 to 1. Default 0.012.
        /// </summary>
        public float turn;
        /// <summary>
        /// How much more reluctant joined particles are: the way of turning grows with mass to this power, 0
        /// to 1. Default 0.15.
        /// </summary>
        public float inertia;
        /// <summary>
        /// Cost of the way down the stem against that through the crown, 0.05 to 1 (no stem). Default 0.6.
        /// Where no picture shows branches, they leave the stem at the angle whose cosine this is.
        /// </summary>
        public float stem;
        /// <summary>
        /// Least distance between nodes of a trace, 1e-4 to 0.2. Default 0.01.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Error of one step that is tolerated, as a share of `join`, 1e-4 to 1; worse steps are halved.
        /// Default 0.03.
        /// </summary>
        public float tolerance;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view that steers particles. Begin with `tree_flow_view_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_flow_view
    {
        /// <summary>
        /// `sizeof(tree_flow_view)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where its photograph was taken from. No default: NULL, which is refused.
        /// </summary>
        public tree_particle_camera* camera;
        /// <summary>
        /// Where particles go in its picture. No default: NULL, which is refused.
        /// </summary>
        public tree_direction_field* field;
    }

    /// <summary>
    /// What became of the particles.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_flow_report
    {
        /// <summary>
        /// `sizeof(tree_flow_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Parts that the integrator cut all steps of all particles into.
        /// </summary>
        public ulong n_parts;
        /// <summary>
        /// Particles that started.
        /// </summary>
        public uint n_particles;
        /// <summary>
        /// Joins of two particles.
        /// </summary>
        public uint n_joins;
        /// <summary>
        /// Particles that joined a trace whose particle had gone on.
        /// </summary>
        public uint n_followed;
        /// <summary>
        /// Particles, after joins, that reached the base on traces of their own.
        /// </summary>
        public uint n_arrived;
        /// <summary>
        /// Particles that were still on their way after `steps` and were steered to the base without heed to
        /// the pictures.
        /// </summary>
        public uint n_steered;
        /// <summary>
        /// Particles that could not even be steered and were led straight to the nearest trace.
        /// </summary>
        public uint n_led;
        /// <summary>
        /// Steps taken.
        /// </summary>
        public uint n_steps;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of traces. Nodes are in the order in which they were left behind; node 0 is the base.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_traces_columns
    {
        /// <summary>
        /// `sizeof(tree_traces_columns)`.
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
        /// For each node the one it leads to, on the way to the base; `TREE_NO_PARENT` at the base.
        /// </summary>
        public uint* next;
        /// <summary>
        /// For each node the number of particles whose way led through it.
        /// </summary>
        public uint* masses;
    }

    /// <summary>
    /// A view of a grid. Voxel (x, y, z) is row `(z * size[1] + y) * size[0] + x`; its centre is
    /// `corner + voxel * (x + 0.5, y + 0.5, z + 0.5)`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_grid_columns
    {
        /// <summary>
        /// `sizeof(tree_grid_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// One for each voxel: x runs fastest, then y, then z.
        /// </summary>
        public float* values;
        /// <summary>
        /// Number of voxels: `size[0] * size[1] * size[2]`.
        /// </summary>
        public UIntPtr n_values;
        /// <summary>
        /// Lowest corner in metres.
        /// </summary>
        public fixed float corner[3];
        /// <summary>
        /// Side of a voxel in metres.
        /// </summary>
        public float voxel;
        /// <summary>
        /// Voxels along x, y and z.
        /// </summary>
        public fixed uint size[3];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Where a photograph was taken from: found in the matte, or as the caller knows. Begin with
    /// `tree_photo_placing_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_placing
    {
        /// <summary>
        /// `sizeof(tree_photo_placing)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The camera, where it is known; then the other fields do not count. Default NULL: base, height and
        /// scale are found in the matte.
        /// </summary>
        public tree_particle_camera* camera;
        /// <summary>
        /// Where the camera stood around the trunk, in radians: 0, the default, on +Z, a quarter turn on +X.
        /// </summary>
        public float yaw;
        /// <summary>
        /// How far it looked down, in radians, -1.5 to 1.5. Default 0.
        /// </summary>
        public float pitch;
        /// <summary>
        /// Vertical field of view of the whole picture in radians, 0.017 to 2.8; 0, the default, is parallel
        /// projection.
        /// </summary>
        public float fov;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Strokes over a picture, or other lines of the plane. The points of stroke `i` are rows `starts[i]` up to,
    /// but not including, `starts[i + 1]`. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_strokes_columns
    {
        /// <summary>
        /// `sizeof(tree_strokes_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of strokes.
        /// </summary>
        public UIntPtr n_strokes;
        /// <summary>
        /// `n_strokes + 1` numbers: 0 first, none below the one before it, `n_points` last. NULL for no strokes.
        /// </summary>
        public ulong* starts;
        /// <summary>
        /// Number of points of all strokes.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Two floats for each point, in pixels from the top left of the picture where nothing else is said.
        /// </summary>
        public float* points;
    }

    /// <summary>
    /// A photograph's main branches. Begin with `tree_photo_branches_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_branches
    {
        /// <summary>
        /// `sizeof(tree_photo_branches)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Seeds: two floats for each point, in pixels from the top left. Default NULL.
        /// </summary>
        public float* seeds;
        /// <summary>
        /// Number of seeds.
        /// </summary>
        public UIntPtr n_seeds;
        /// <summary>
        /// Strokes: as `tree_attractor_from_strokes` takes them. Default NULL.
        /// </summary>
        public tree_strokes_columns* strokes;
        /// <summary>
        /// Graph: the graph. Default NULL.
        /// </summary>
        public tree_attractor* graph;
        /// <summary>
        /// Where they come from. Default `TREE_BRANCHES_LIVEWIRE`.
        /// </summary>
        public uint kind; // tree_branches_kind
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One photograph as it goes in. Begin with `tree_photo_shot_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_shot
    {
        /// <summary>
        /// `sizeof(tree_photo_shot)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How much of each pixel the tree covers. No default: NULL, which is refused.
        /// </summary>
        public tree_matte* matte;
        /// <summary>
        /// The photograph, of the same size, where livewire looks for branches. Default NULL: it looks at the
        /// matte.
        /// </summary>
        public tree_photo* photo;
        /// <summary>
        /// Where it was taken from. Default NULL: from the front.
        /// </summary>
        public tree_photo_placing* placing;
        /// <summary>
        /// Its main branches. Default NULL: livewire from points on the silhouette.
        /// </summary>
        public tree_photo_branches* branches;
    }

    /// <summary>
    /// Which points of the silhouette may be seeds. Begin with `tree_seed_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_seed_params
    {
        /// <summary>
        /// `sizeof(tree_seed_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Distance that seeds keep from the trunk as a share of the tree's height, 0 to 1. Default 0.08.
        /// </summary>
        public float from_trunk;
        /// <summary>
        /// Lowest height of a seed over the base as a share of the tree's height, -1 to 1. Default 0.05: what
        /// hangs lower is left out.
        /// </summary>
        public float lowest;
        /// <summary>
        /// How far the silhouette may face down at a seed, 0 (aside) to 1 (straight down). Default 0.8.
        /// </summary>
        public float downwards;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How paths are found. Begin with `tree_livewire_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_livewire_params
    {
        /// <summary>
        /// `sizeof(tree_livewire_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Rows of pixels over the height of the tree at which paths are sought, 16 to 1024. Default 256. Time
        /// and memory (120 bytes a pixel at most) grow with the square.
        /// </summary>
        public uint rows;
        /// <summary>
        /// How closely paths follow visible structures, 0 (not at all) to 0.98. Default 0.88: a step along the
        /// clearest branch costs 12 % of one through leaves.
        /// </summary>
        public float follow;
        /// <summary>
        /// Cost of a step outside the tree, in steps inside, 1 to 100. Default 12.
        /// </summary>
        public float outside;
        /// <summary>
        /// How much more a step at the silhouette costs than one in the middle, 0 to 10. Default 4.
        /// </summary>
        public float centre;
        /// <summary>
        /// How much more a step costs that leads back towards the base and down than one that leads away from
        /// it and up, 0 to 10. Default 0.6.
        /// </summary>
        public float outwards;
        /// <summary>
        /// How much less than a step through leaves one costs along a path found before, 0 (paths do not
        /// attract each other) to 0.9. Default 0.3.
        /// </summary>
        public float join;
        /// <summary>
        /// Passes of smoothing over paths of working pixels, 0 to 1000. Default 12.
        /// </summary>
        public uint smoothing;
        /// <summary>
        /// Distance between nodes as a share of the tree's height, 0.001 to 0.5. Default 0.02.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Side branches shorter than this share of the tree's height are left out, 0 to 0.5. Default 0.05.
        /// </summary>
        public float stub;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How strokes are cleaned and joined. Begin with `tree_stroke_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stroke_params
    {
        /// <summary>
        /// `sizeof(tree_stroke_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Distance between nodes as a share of the drawing's size, 0.001 to 0.5. Default 0.02.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Gaps up to this share of the drawing's size are closed by moving the stroke's end, 0 to 1; wider
        /// ones are bridged by a straight line and reported. Default 0.03.
        /// </summary>
        public float snap;
    }

    /// <summary>
    /// All parameters of the way from photographs to a tree. A part that is NULL, as all are after
    /// `tree_photo_params_init`, is its default.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_params
    {
        /// <summary>
        /// `sizeof(tree_photo_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// What points on the silhouettes are drawn with. They do not change with the tree's seed: what a
        /// photograph shows is the same for all trees made of it. Default 0.
        /// </summary>
        public ulong attractor_seed;
        /// <summary>
        /// Which points of a silhouette may be seeds.
        /// </summary>
        public tree_seed_params* seeds;
        /// <summary>
        /// How livewire finds branches.
        /// </summary>
        public tree_livewire_params* livewire;
        /// <summary>
        /// How drawn strokes are joined.
        /// </summary>
        public tree_stroke_params* strokes;
        /// <summary>
        /// How the density is found.
        /// </summary>
        public tree_density_params* density;
        /// <summary>
        /// How branches steer particles.
        /// </summary>
        public tree_field_params* field;
        /// <summary>
        /// How particles move.
        /// </summary>
        public tree_flow_params* flow;
        /// <summary>
        /// How traces become a tree.
        /// </summary>
        public tree_finish_params* finish;
        /// <summary>
        /// Height of the tree in metres, 0.01 to 1000. Default 10.
        /// </summary>
        public float height;
        /// <summary>
        /// Points on each silhouette from which livewire seeks branches, 0 to 10,000. Default 40.
        /// </summary>
        public uint branches;
        /// <summary>
        /// Whether a side is imagined where all photographs are from one side (or its back): the first photograph,
        /// mirrored, from a quarter turn round. Without it the depth of the crown is filled evenly. Default 1.
        /// </summary>
        public uint imagine;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What was found, repaired and left out on the way from photographs to a tree. The fields that begin with
    /// `density_`, `flow_` and `crown_` are those of `tree_density_report`, `tree_flow_report` and
    /// `tree_crown_report`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_report
    {
        /// <summary>
        /// `sizeof(tree_photo_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of views.
        /// </summary>
        public ulong n_views;
        /// <summary>
        /// Number of lines that `tree_photo_session_warnings` gives.
        /// </summary>
        public ulong n_warnings;
        /// <summary>
        /// Radius of the trunk that the views show, in metres; 0 where they show no bare trunk.
        /// </summary>
        public float trunk_radius;
        /// <summary>
        /// Height in metres below which no view shows more than the trunk.
        /// </summary>
        public float crown_base;
        /// <summary>
        /// Rays: equations.
        /// </summary>
        public ulong density_rays;
        /// <summary>
        /// Voxels that were left after carving: unknowns.
        /// </summary>
        public ulong density_voxels;
        /// <summary>
        /// Voxels thrown away by carving.
        /// </summary>
        public ulong density_carved;
        /// <summary>
        /// Voxels that no picture shows.
        /// </summary>
        public ulong density_unseen;
        /// <summary>
        /// Entries of the system of equations that are not zero.
        /// </summary>
        public ulong density_entries;
        /// <summary>
        /// What looking through the density misses of the mattes, as a share.
        /// </summary>
        public double density_residual;
        /// <summary>
        /// Iterations of the solver.
        /// </summary>
        public uint density_iterations;
        /// <summary>
        /// 1 when the density is not final.
        /// </summary>
        public uint density_not_converged;
        /// <summary>
        /// Views that contradict the others.
        /// </summary>
        public uint density_contradictions;
        /// <summary>
        /// Views that are covered all over.
        /// </summary>
        public uint density_opaque;
        /// <summary>
        /// Parts that the integrator cut all steps of all particles into.
        /// </summary>
        public ulong flow_parts;
        /// <summary>
        /// Particles that started.
        /// </summary>
        public uint flow_particles;
        /// <summary>
        /// Joins of two particles.
        /// </summary>
        public uint flow_joins;
        /// <summary>
        /// Particles that joined a trace whose particle had gone on.
        /// </summary>
        public uint flow_followed;
        /// <summary>
        /// Particles, after joins, that reached the base on traces of their own.
        /// </summary>
        public uint flow_arrived;
        /// <summary>
        /// Particles that were steered to the base after all steps.
        /// </summary>
        public uint flow_steered;
        /// <summary>
        /// Particles that were led straight to the nearest trace.
        /// </summary>
        public uint flow_led;
        /// <summary>
        /// Steps taken.
        /// </summary>
        public uint flow_steps;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// Nodes of twigs.
        /// </summary>
        public ulong crown_twig_nodes;
        /// <summary>
        /// Nodes of twigs cut off because they reached where a picture is empty.
        /// </summary>
        public ulong crown_twig_nodes_cut;
        /// <summary>
        /// Leaves (blades) that stayed.
        /// </summary>
        public ulong crown_leaves;
        /// <summary>
        /// Leaves discarded because a picture is empty there.
        /// </summary>
        public ulong crown_leaves_discarded;
        /// <summary>
        /// Leaves the pictures ask for, as far as the last correction knows.
        /// </summary>
        public double crown_leaves_asked;
    }

    /// <summary>
    /// What may be wrong with an alignment. Fields that the problem does not name are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_align_warning
    {
        /// <summary>
        /// Which problem. New ones may be added.
        /// </summary>
        public uint problem; // tree_align_problem
        /// <summary>
        /// Index into the views.
        /// </summary>
        public uint view;
        /// <summary>
        /// Number of parts.
        /// </summary>
        public uint parts;
        /// <summary>
        /// A share, 0 to 1 or more.
        /// </summary>
        public float found;
        /// <summary>
        /// What is found in most views.
        /// </summary>
        public float usual;
    }

    /// <summary>
    /// What one view gave.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_photo_view_report
    {
        /// <summary>
        /// `sizeof(tree_photo_view_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// What looking through the density misses of the view's matte, as a share; 0 where the density came
        /// from elsewhere.
        /// </summary>
        public double residual;
        /// <summary>
        /// 1 when the view contradicts the others.
        /// </summary>
        public uint contradicts;
        /// <summary>
        /// 1 when the view is covered all over.
        /// </summary>
        public uint is_opaque;
        /// <summary>
        /// What its alignment is doubtful about: rows of `warnings`. 0 where the caller placed the camera.
        /// </summary>
        public uint n_warnings;
        /// <summary>
        /// 1 when the view gives directions: not without branches.
        /// </summary>
        public uint attracts;
        /// <summary>
        /// 1 when livewire sought branches, and the fields from here to `trunk_width` count.
        /// </summary>
        public uint has_livewire;
        /// <summary>
        /// Seeds that were not finite and left out.
        /// </summary>
        public uint n_bad_seeds;
        /// <summary>
        /// Seeds outside the picture, moved to its border.
        /// </summary>
        public uint n_moved_seeds;
        /// <summary>
        /// Side branches left out as stubs.
        /// </summary>
        public uint n_stubs;
        /// <summary>
        /// Tips of the graph.
        /// </summary>
        public uint n_tips;
        /// <summary>
        /// Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
        /// </summary>
        public float outside;
        /// <summary>
        /// How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
        /// </summary>
        public float evidence;
        /// <summary>
        /// Width of the trunk at its foot in pixels; 0 where no trunk is seen.
        /// </summary>
        public float trunk_width;
        /// <summary>
        /// 1 when strokes were joined, and the fields after it count.
        /// </summary>
        public uint has_strokes;
        /// <summary>
        /// Points left out because they were not finite.
        /// </summary>
        public uint n_bad_points;
        /// <summary>
        /// Strokes left out because they had no length.
        /// </summary>
        public uint n_empty;
        /// <summary>
        /// Strokes that were joined over a gap wider than the snapping distance.
        /// </summary>
        public uint n_bridged;
        /// <summary>
        /// Strokes joined by their middle, in two parts.
        /// </summary>
        public uint n_split;
        /// <summary>
        /// Doubts about its alignment, the first `n_warnings` rows.
        /// </summary>
        public tree_align_warning warnings_0, warnings_1, warnings_2, warnings_3, warnings_4, warnings_5, warnings_6, warnings_7;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Makes edges dearer or cheaper inside a volume. Begin with `tree_paint_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_paint
    {
        /// <summary>
        /// `sizeof(tree_paint)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where: edges whose middle lies inside. No default: NULL, which is refused.
        /// </summary>
        public tree_volume* volume;
        /// <summary>
        /// Their cost is multiplied by this, 0 to 1000. Below 1 attracts branches, above 1 repels them.
        /// Default 1, which changes nothing.
        /// </summary>
        public float factor;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How nodes are linked and what edges cost. Begin with `tree_link_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_link_params
    {
        /// <summary>
        /// `sizeof(tree_link_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Painted edge costs; where several overlap, they multiply. Default NULL.
        /// </summary>
        public tree_paint* paints;
        /// <summary>
        /// Number of paints, at most 65,536.
        /// </summary>
        public UIntPtr n_paints;
        /// <summary>
        /// A cost factor for every point, multiplied with the paints. Default NULL.
        /// </summary>
        public IntPtr cost;
        /// <summary>
        /// Handed to `cost`.
        /// </summary>
        public void* cost_user;
        /// <summary>
        /// What no edge may pass through. Default NULL.
        /// </summary>
        public tree_volume* obstacle;
        /// <summary>
        /// Distance to keep from the obstacle in metres, 0 or more. Default 0.
        /// </summary>
        public float clearance;
        /// <summary>
        /// Linking distance in separations, 1.2 to 4. Default 2. More links make straighter paths and cost
        /// time and memory with the third power; under 1.6 graphs fall apart.
        /// </summary>
        public float reach;
        /// <summary>
        /// An edge costs its length times a random weight from `low` to 1; 0.01 to 1. Default 0.25.
        /// </summary>
        public float low;
        /// <summary>
        /// Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Default 1.
        /// </summary>
        public float bias;
    }

    /// <summary>
    /// One direction of an edge.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_graph_arc
    {
        /// <summary>
        /// The node it leads to.
        /// </summary>
        public uint to;
        /// <summary>
        /// What it costs, 0 or more.
        /// </summary>
        public float cost;
    }

    /// <summary>
    /// A view of a graph, as compressed rows: the arcs that leave node `i` are `arcs[starts[i]]` up to, but
    /// not including, `arcs[starts[i + 1]]`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_graph_columns
    {
        /// <summary>
        /// `sizeof(tree_graph_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// Three floats for each node, in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// `n_nodes + 1` numbers.
        /// </summary>
        public uint* starts;
        /// <summary>
        /// Number of arcs: two for each edge.
        /// </summary>
        public UIntPtr n_arcs;
        /// <summary>
        /// The arcs, node by node.
        /// </summary>
        public tree_graph_arc* arcs;
    }

    /// <summary>
    /// Subgraphs grown round the endpoints of the level before. Begin with `tree_path_level_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_path_level
    {
        /// <summary>
        /// `sizeof(tree_path_level)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Custom: any volume, drawn for a root at the origin, axis +Y and radius 1. Default NULL.
        /// </summary>
        public tree_volume* custom;
        /// <summary>
        /// Endpoints in each subgraph, 1 to 10,000. Default 4.
        /// </summary>
        public uint branching;
        /// <summary>
        /// Shape of the subgraphs. Default `TREE_PATH_SHAPE_SECTOR`.
        /// </summary>
        public uint shape; // tree_path_shape
        /// <summary>
        /// Sector: angle from the axis in radians, 0.05 to pi (the whole ball). Default 0.3 pi.
        /// </summary>
        public float angle;
        /// <summary>
        /// Cones: base radius as a share of the height, 0.05 to 5. No default: 0, which is refused.
        /// </summary>
        public float width;
        /// <summary>
        /// Nodes of each subgraph, 8 to `tree_limits.graph_nodes`. Default 110.
        /// </summary>
        public uint graph_nodes;
        /// <summary>
        /// Which way subgraphs point. Default `TREE_PATH_AXIS_OUTWARD`.
        /// </summary>
        public uint axis; // tree_path_axis
        /// <summary>
        /// Fixed axis: its direction, of any length but 0. Default 0, 0, 0, which is refused.
        /// </summary>
        public fixed float direction[3];
        /// <summary>
        /// Turn of the axis about the horizontal in radians, -pi to pi: positive bends branches down,
        /// negative up. Default 0.
        /// </summary>
        public float turn;
        /// <summary>
        /// Radius of the subgraphs in metres. Default 0: the one that follows from `size` and `shrink` of the
        /// `tree_path_params`.
        /// </summary>
        public float size;
        /// <summary>
        /// Where endpoints may lie. Default `TREE_PATH_PLACING_VOLUME`.
        /// </summary>
        public uint placing; // tree_path_placing
        /// <summary>
        /// Whether subgraphs grow round the endpoints of all levels before, not only the last. Default 0.
        /// </summary>
        public uint from_all_levels;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Everything that shapes a tree of least-cost paths. Lengths in metres, angles in radians. Begin with
    /// `tree_path_params_init`, which makes it an oak, or with `tree_path_preset`. What the structs of presets
    /// point at belongs to the library, lives for ever and is not to be written: to alter levels, copy them
    /// to an array of your own and point at that.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_path_params
    {
        /// <summary>
        /// `sizeof(tree_path_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The volume of level 1: trunk and crown, or root ball; bounded. It decides the shape of the tree
        /// more than all else. Oak: a trunk of 3 m under a round crown, 10.4 m high.
        /// </summary>
        public tree_volume* volume;
        /// <summary>
        /// Where all paths end; inside `volume` or within linking distance. Oak: the origin.
        /// </summary>
        public fixed float root[3];
        /// <summary>
        /// Nodes of the level 1 graph, 8 to `tree_limits.graph_nodes`; the graph has this many within about a
        /// tenth. More make branches finer and cost time in proportion. Oak: 5000.
        /// </summary>
        public uint graph_nodes;
        /// <summary>
        /// Endpoints of level 1 drawn at random, at most 10,000. Oak: 24.
        /// </summary>
        public uint endpoints_random;
        /// <summary>
        /// Where random endpoints may lie. Oak: `TREE_PATH_PLACING_VOLUME`.
        /// </summary>
        public uint endpoints_placing; // tree_path_placing
        /// <summary>
        /// Candidates drawn for each random endpoint, of which the one farthest from all others is taken, 1
        /// to 64. More spread the branches evenly and cost time with the square of `endpoints_random`. Oak: 4.
        /// </summary>
        public uint endpoints_candidates;
        /// <summary>
        /// Random endpoints lie above this share of the volume's height, 0 to 0.95; keeps main branches off
        /// the trunk. Oak: 0.25.
        /// </summary>
        public float endpoints_above;
        /// <summary>
        /// Endpoints placed by hand, three floats each. Oak: NULL.
        /// </summary>
        public float* placed;
        /// <summary>
        /// Number of endpoints placed by hand.
        /// </summary>
        public UIntPtr n_placed;
        /// <summary>
        /// Radius of the subgraphs of level 2 in metres, above 0. Oak: 2.2.
        /// </summary>
        public float size;
        /// <summary>
        /// Ratio of the subgraph radii of successive levels, 0.05 to 2. Oak: 0.62.
        /// </summary>
        public float shrink;
        /// <summary>
        /// Levels 2 and on. Oak: three.
        /// </summary>
        public tree_path_level* levels;
        /// <summary>
        /// Number of those levels, at most 16.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// How long branches live. Oak: `TREE_PATH_LIFESPAN_FULL`.
        /// </summary>
        public uint lifespan; // tree_path_lifespan
        /// <summary>
        /// Random lifespan: chance to end at each level, 0 to 1; the authors use 0.3. Oak: 0.
        /// </summary>
        public float lifespan_stop;
        /// <summary>
        /// Linking distance in separations, 1.2 to 4. Oak: 2. More links make straighter paths and cost time
        /// and memory with the third power; under 1.6 graphs fall apart.
        /// </summary>
        public float linking_reach;
        /// <summary>
        /// An edge costs its length times a random weight from this to 1; 0.01 to 1. Low values make crooked
        /// branches that run together, 1 makes straight ones. Oak: 0.2.
        /// </summary>
        public float linking_low;
        /// <summary>
        /// Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Above 1 cheap edges
        /// are many, below 1 few. Oak: 1.
        /// </summary>
        public float linking_bias;
        /// <summary>
        /// Smoothing passes over the branches, 0 to 50; each takes away some of the zigzag from node to node.
        /// Oak: 3.
        /// </summary>
        public uint smoothing;
        /// <summary>
        /// Painted edge costs; where several overlap, they multiply. Oak: NULL.
        /// </summary>
        public tree_paint* paints;
        /// <summary>
        /// Number of paints, at most 65,536.
        /// </summary>
        public UIntPtr n_paints;
        /// <summary>
        /// A cost factor for every point, multiplied with the paints. Oak: NULL.
        /// </summary>
        public IntPtr cost;
        /// <summary>
        /// Handed to `cost`.
        /// </summary>
        public void* cost_user;
        /// <summary>
        /// What no path may enter. Oak: NULL.
        /// </summary>
        public tree_volume* obstacle;
        /// <summary>
        /// How thick branches are; NULL for the defaults of `tree_radius_rule_init`. Oak: the pipe model,
        /// scaled to its trunk.
        /// </summary>
        public tree_radius_rule* radii;
        /// <summary>
        /// Leaves; NULL for none. Oak: clusters of oak leaves.
        /// </summary>
        public tree_leaf_params* leaves;
        /// <summary>
        /// Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
        /// name.
        /// </summary>
        public tree_species* species;
        /// <summary>
        /// A root system, grown by the same method from the same root. Its own `root` and `leaves` are
        /// ignored; its own `roots` must be NULL. Oak: NULL.
        /// </summary>
        public tree_path_params* roots;
        /// <summary>
        /// Distance to keep from the obstacle in metres, 0 or more. Oak: 0.
        /// </summary>
        public float clearance;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What one level took, and what it left out.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_path_level_report
    {
        /// <summary>
        /// Graphs searched.
        /// </summary>
        public ulong graphs;
        /// <summary>
        /// Nodes in them.
        /// </summary>
        public ulong graph_nodes;
        /// <summary>
        /// Arcs in them: two for each edge.
        /// </summary>
        public ulong graph_arcs;
        /// <summary>
        /// Nodes no path led to.
        /// </summary>
        public ulong stray_nodes;
        /// <summary>
        /// Graphs that fell apart at the linking distance asked for and were linked again with a longer one.
        /// </summary>
        public ulong widened;
        /// <summary>
        /// Bytes of the largest single graph.
        /// </summary>
        public ulong largest_bytes;
        /// <summary>
        /// Endpoints reached.
        /// </summary>
        public ulong endpoints;
        /// <summary>
        /// Random endpoints asked for that the graphs had no nodes for.
        /// </summary>
        public ulong missing;
        /// <summary>
        /// Endpoints of the levels before from which nothing grew, because an obstacle left no room or a
        /// narrow subgraph did not hang together.
        /// </summary>
        public ulong stunted;
        /// <summary>
        /// Endpoints of the level before whose lifespan had ended.
        /// </summary>
        public ulong ended;
    }

    /// <summary>
    /// What growing a tree took, and what it left out.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_path_report
    {
        /// <summary>
        /// `sizeof(tree_path_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// All levels together, roots included.
        /// </summary>
        public tree_path_level_report total;
        /// <summary>
        /// Number of levels of the tree.
        /// </summary>
        public ulong n_levels;
        /// <summary>
        /// Number of levels of its root system.
        /// </summary>
        public ulong n_root_levels;
        /// <summary>
        /// A row for each level of the tree, the first for the base volume.
        /// </summary>
        public tree_path_level_report levels_0, levels_1, levels_2, levels_3, levels_4, levels_5, levels_6, levels_7, levels_8, levels_9, levels_10, levels_11, levels_12, levels_13, levels_14, levels_15, levels_16;
        /// <summary>
        /// A row for each level of its root system.
        /// </summary>
        public tree_path_level_report root_levels_0, root_levels_1, root_levels_2, root_levels_3, root_levels_4, root_levels_5, root_levels_6, root_levels_7, root_levels_8, root_levels_9, root_levels_10, root_levels_11, root_levels_12, root_levels_13, root_levels_14, root_levels_15, root_levels_16;
    }

    /// <summary>
    /// Which nodes are strewn. Begin with `tree_strew_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_strew_params
    {
        /// <summary>
        /// `sizeof(tree_strew_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where there are no nodes. Default NULL.
        /// </summary>
        public tree_volume* obstacle;
        /// <summary>
        /// Points that become nodes wherever they lie, three floats each. Default NULL.
        /// </summary>
        public float* forced;
        /// <summary>
        /// Number of those points.
        /// </summary>
        public UIntPtr n_forced;
        /// <summary>
        /// Distance to keep from the obstacle in metres, 0 or more. Default 0.
        /// </summary>
        public float clearance;
        /// <summary>
        /// Nodes wanted, at most `tree_limits.graph_nodes`; there will be this many within about a tenth, and
        /// up to 2.8 times as many in a volume thinner than their distance. Default 5000, as for an oak.
        /// </summary>
        public uint n_nodes;
    }

    /// <summary>
    /// A view of strewn nodes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_graph_nodes_columns
    {
        /// <summary>
        /// `sizeof(tree_graph_nodes_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// Three floats for each node, in metres.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Number of forced points.
        /// </summary>
        public UIntPtr n_forced;
        /// <summary>
        /// For each forced point its node.
        /// </summary>
        public uint* forced;
        /// <summary>
        /// No two nodes are closer than this, in metres; forced ones may be.
        /// </summary>
        public float separation;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a drawing becomes a profile. Begin with `tree_profile_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_profile_options
    {
        /// <summary>
        /// `sizeof(tree_profile_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Height of the tree in metres, 0.01 to 10,000. Default 10.
        /// </summary>
        public float height;
        /// <summary>
        /// Factor on all radii, 0.01 to 100. Default 1.
        /// </summary>
        public float widen;
    }

    /// <summary>
    /// A view of a profile.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_profile_columns
    {
        /// <summary>
        /// `sizeof(tree_profile_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Two floats for each point, in metres: radius and height. `tree_volume_revolution` takes them.
        /// </summary>
        public float* points;
        /// <summary>
        /// Whether it was taken from a closed outline: 1 or 0.
        /// </summary>
        public uint from_outline;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What is known about a photograph. Begin with `tree_align_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_align_params
    {
        /// <summary>
        /// `sizeof(tree_align_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Height of the tree in metres, 0.01 to 1000. Default 10. `tree_align_all` takes its own.
        /// </summary>
        public float height;
        /// <summary>
        /// See `tree_particle_camera`. Default 0.
        /// </summary>
        public float yaw;
        /// <summary>
        /// See `tree_particle_camera`. Default 0.
        /// </summary>
        public float pitch;
        /// <summary>
        /// See `tree_particle_camera`. Default 0: parallel projection.
        /// </summary>
        public float fov;
    }

    /// <summary>
    /// What was found in a matte. Lengths are in pixels from the top left.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_align_report
    {
        /// <summary>
        /// `sizeof(tree_align_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The foot of the trunk.
        /// </summary>
        public fixed float @base[2];
        /// <summary>
        /// The highest point of the tree.
        /// </summary>
        public fixed float top[2];
        /// <summary>
        /// Top left corner of the crown.
        /// </summary>
        public fixed float crown_low[2];
        /// <summary>
        /// Bottom right corner of the crown.
        /// </summary>
        public fixed float crown_high[2];
        /// <summary>
        /// The row where the crown begins: between it and the base the trunk is bare. The base's row where no
        /// bare trunk shows.
        /// </summary>
        public float crown_base;
        /// <summary>
        /// Width of the bare trunk at about breast height (1.3 m); 0 where none shows.
        /// </summary>
        public float trunk_width;
        /// <summary>
        /// Number of warnings.
        /// </summary>
        public uint n_warnings;
        /// <summary>
        /// What may be wrong; `tree_align_warnings_text` puts it into words.
        /// </summary>
        public tree_align_warning warnings_0, warnings_1, warnings_2, warnings_3, warnings_4, warnings_5, warnings_6, warnings_7;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// The columns of an attractor graph. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_attractor_columns
    {
        /// <summary>
        /// `sizeof(tree_attractor_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// Two floats for each node, in pixels from the top left of the picture. Finite.
        /// </summary>
        public float* positions;
        /// <summary>
        /// For each node the one that it leads to, nearer to the base, which comes before it; `TREE_NO_PARENT`
        /// at the base.
        /// </summary>
        public uint* parents;
    }

    /// <summary>
    /// The point of a graph that is nearest to another.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_attractor_nearest_point
    {
        /// <summary>
        /// `sizeof(tree_attractor_nearest_point)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether there is one, 1 or 0: a graph without segments has none, a point that is not finite neither.
        /// </summary>
        public uint found;
        /// <summary>
        /// The node at the upper end of the segment it lies on.
        /// </summary>
        public uint node;
        /// <summary>
        /// Where on the segment: 0 at the parent, 1 at the node.
        /// </summary>
        public float share;
        /// <summary>
        /// The point, in pixels.
        /// </summary>
        public fixed float point[2];
        /// <summary>
        /// How far off it is, in pixels.
        /// </summary>
        public float distance;
    }

    /// <summary>
    /// How a matte is found with a trimap. Begin with `tree_natural_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_natural_params
    {
        /// <summary>
        /// `sizeof(tree_natural_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Longer side in pixels at which alpha is solved for, 16 to 4096. Default 768. Cost and memory grow
        /// with its square.
        /// </summary>
        public uint max_side;
        /// <summary>
        /// How far alpha may depart from a linear function of colour within a window, 1e-9 to 1: a variance of
        /// colours 0 to 1. Low keeps fine structure, high is smooth. Default 1e-7.
        /// </summary>
        public float epsilon;
        /// <summary>
        /// Share of the right side's size at which the solution is good enough, 1e-8 to 0.1. Default 2e-4.
        /// </summary>
        public float tolerance;
        /// <summary>
        /// Most iterations at each size, 1 to 100,000. Default 400.
        /// </summary>
        public uint max_iterations;
        /// <summary>
        /// Whether unknown pixels that clearly look like the known ones of one side count as known. Default 1;
        /// helps strokes much, full trimaps a little.
        /// </summary>
        public uint mark_clear;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a tree against sky is found. Begin with `tree_automatic_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_automatic_params
    {
        /// <summary>
        /// `sizeof(tree_automatic_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How the alpha of the pixels left unknown is found. Default NULL: that of `tree_natural_params_init`.
        /// </summary>
        public tree_natural_params* natural;
    }

    /// <summary>
    /// What was found in a photograph of a tree against sky.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_automatic_report
    {
        /// <summary>
        /// `sizeof(tree_automatic_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether the photograph's own alpha was taken, 1 or 0.
        /// </summary>
        public uint has_alpha;
        /// <summary>
        /// Whether the place where the trunk meets the ground was found, 1 or 0.
        /// </summary>
        public uint has_base;
        /// <summary>
        /// That place, in pixels of the photograph from the top left.
        /// </summary>
        public fixed float @base[2];
        /// <summary>
        /// How sure the result is, 0 to 1: below 0.5 look at it before you use it.
        /// </summary>
        public float confidence;
        /// <summary>
        /// Width at which alpha was solved for, in pixels; 0 where the photograph has alpha.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height at which alpha was solved for, in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// Iterations at that size.
        /// </summary>
        public uint iterations;
        /// <summary>
        /// Pixels that the trimap leaves unknown, at that size.
        /// </summary>
        public ulong n_unknown;
        /// <summary>
        /// Of them, pixels marked by their colour.
        /// </summary>
        public ulong n_marked;
        /// <summary>
        /// What is left of the right side, as a share.
        /// </summary>
        public float residual;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Something drawn onto a photograph. Coordinates are pixels from the top left; what lies outside is cut
    /// off, and what is not finite is left out.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mark
    {
        /// <summary>
        /// What it is.
        /// </summary>
        public uint kind; // tree_mark_kind
        /// <summary>
        /// Where it begins.
        /// </summary>
        public fixed float from[2];
        /// <summary>
        /// Where it ends.
        /// </summary>
        public fixed float to[2];
        /// <summary>
        /// Width of a line, or a dot's diameter, in pixels.
        /// </summary>
        public float width;
        /// <summary>
        /// Its colour, as `0xRRGGBBAA`: red, green, blue (sRGB) and how much it covers, 0 to 255 each.
        /// </summary>
        public uint color;
    }

    /// <summary>
    /// What became of strokes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stroke_report
    {
        /// <summary>
        /// `sizeof(tree_stroke_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Points left out because they were not finite.
        /// </summary>
        public uint n_bad_points;
        /// <summary>
        /// Strokes left out because they had no length.
        /// </summary>
        public uint n_empty;
        /// <summary>
        /// Strokes that were joined over a gap wider than the snapping distance.
        /// </summary>
        public uint n_bridged;
        /// <summary>
        /// Strokes joined by their middle, in two parts.
        /// </summary>
        public uint n_split;
    }

    /// <summary>
    /// What erasing did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_erase_report
    {
        /// <summary>
        /// `sizeof(tree_erase_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Segments under the eraser.
        /// </summary>
        public uint n_erased;
        /// <summary>
        /// Segments that went because they were cut off.
        /// </summary>
        public uint n_dropped;
        /// <summary>
        /// Parts that were cut off and joined again.
        /// </summary>
        public uint n_reconnected;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What livewire found.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_livewire_report
    {
        /// <summary>
        /// `sizeof(tree_livewire_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Seeds that were not finite and left out.
        /// </summary>
        public uint n_bad_seeds;
        /// <summary>
        /// Seeds outside the picture, moved to its border.
        /// </summary>
        public uint n_moved_seeds;
        /// <summary>
        /// Side branches left out as stubs.
        /// </summary>
        public uint n_stubs;
        /// <summary>
        /// Tips of the graph.
        /// </summary>
        public uint n_tips;
        /// <summary>
        /// Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
        /// </summary>
        public float outside;
        /// <summary>
        /// How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
        /// </summary>
        public float evidence;
        /// <summary>
        /// Width of the trunk at its foot in pixels; 0 where no trunk is seen.
        /// </summary>
        public float trunk_width;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of a matte. Pixel 0 is at the top left; its area runs from (0, 0) to (1, 1), so its centre is
    /// (0.5, 0.5), as everywhere where pixels are counted with fractions.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_matte_columns
    {
        /// <summary>
        /// `sizeof(tree_matte_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// One float for each pixel, rows from top to bottom: 0 is empty, 1 is full.
        /// </summary>
        public float* alpha;
        /// <summary>
        /// Number of pixels: `width * height`.
        /// </summary>
        public UIntPtr n_pixels;
        /// <summary>
        /// Covered area in pixels.
        /// </summary>
        public double area;
    }

    /// <summary>
    /// What matting with a trimap did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_natural_report
    {
        /// <summary>
        /// `sizeof(tree_natural_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Pixels that the trimap leaves unknown, at the size at which alpha was solved for.
        /// </summary>
        public ulong n_unknown;
        /// <summary>
        /// Of them, pixels marked by their colour.
        /// </summary>
        public ulong n_marked;
        /// <summary>
        /// That size: width and height in pixels.
        /// </summary>
        public fixed uint size[2];
        /// <summary>
        /// Iterations at that size; coarser ones cost little.
        /// </summary>
        public uint iterations;
        /// <summary>
        /// What is left of the right side, as a share.
        /// </summary>
        public float residual;
    }

    /// <summary>
    /// How a screen is found. Begin with `tree_screen_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_screen_params
    {
        /// <summary>
        /// `sizeof(tree_screen_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Colour of the screen. Default `TREE_SCREEN_BLUE`.
        /// </summary>
        public uint color; // tree_screen_color
        /// <summary>
        /// How fast alpha falls with the surplus of the screen's colour, 0 to 100. 1 over the surplus of the bare
        /// screen makes that fully transparent. Default 2.
        /// </summary>
        public float gain;
        /// <summary>
        /// How much of the screen's colour a pixel of the tree may hold for each part of the other one (green
        /// for blue, blue for green), 0 to 10. Default 1.
        /// </summary>
        public float balance;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a tree is told from a picture without it. Begin with `tree_difference_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_difference_params
    {
        /// <summary>
        /// `sizeof(tree_difference_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Difference of colours at which a pixel is half tree: distance in the RGB cube of side 1, 0 to 2.
        /// Default 0.15.
        /// </summary>
        public float threshold;
        /// <summary>
        /// Width of the soft step around the threshold, 0 (hard) to 2. Default 0.15.
        /// </summary>
        public float softness;
    }

    /// <summary>
    /// A camera as renderers want it: what it shows is what `tree_particle_camera_project` gives.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_particle_stand
    {
        /// <summary>
        /// `sizeof(tree_particle_stand)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where it stands, in metres. A parallel one stands far enough off.
        /// </summary>
        public fixed float eye[3];
        /// <summary>
        /// What is in the middle of the picture.
        /// </summary>
        public fixed float target[3];
        /// <summary>
        /// Which way is up.
        /// </summary>
        public fixed float up[3];
        /// <summary>
        /// Vertical field of view in radians; 0 for parallel projection.
        /// </summary>
        public float fov;
        /// <summary>
        /// Height of the picture in metres, at the target.
        /// </summary>
        public float height;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A scribble over a photograph. Begin with `tree_trimap_stroke_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_trimap_stroke
    {
        /// <summary>
        /// `sizeof(tree_trimap_stroke)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its course: two floats for each point, in pixels from the top left corner. One point makes a dot.
        /// </summary>
        public float* points;
        /// <summary>
        /// Number of points. Default 0.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Its width in pixels, above 0 to 1e6. Default 1.
        /// </summary>
        public float width;
        /// <summary>
        /// Whether it marks the tree; otherwise the background. Default 0.
        /// </summary>
        public uint foreground;
    }

    /// <summary>
    /// Colours picked from a photograph. Begin with `tree_color_samples_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_color_samples
    {
        /// <summary>
        /// `sizeof(tree_color_samples)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Colours of the tree: three bytes each, red, green and blue (sRGB).
        /// </summary>
        public byte* foreground;
        /// <summary>
        /// Number of colours of the tree; at least 1.
        /// </summary>
        public UIntPtr n_foreground;
        /// <summary>
        /// Colours of the background.
        /// </summary>
        public byte* background;
        /// <summary>
        /// Number of colours of the background; at least 1.
        /// </summary>
        public UIntPtr n_background;
        /// <summary>
        /// Pixels within this distance of a sample are known: a distance in the RGB cube of side 255, 0 to 442.
        /// Default 24.
        /// </summary>
        public float tolerance;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of a trimap.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_trimap_columns
    {
        /// <summary>
        /// `sizeof(tree_trimap_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// A `TREE_LEVEL_` constant for each pixel, rows from top to bottom.
        /// </summary>
        public byte* levels;
        /// <summary>
        /// Number of pixels: `width * height`.
        /// </summary>
        public UIntPtr n_pixels;
        /// <summary>
        /// Pixels that are certainly not the tree.
        /// </summary>
        public UIntPtr n_background;
        /// <summary>
        /// Pixels to be found.
        /// </summary>
        public UIntPtr n_unknown;
        /// <summary>
        /// Pixels that are certainly the tree.
        /// </summary>
        public UIntPtr n_foreground;
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
        /// 0.
        /// </summary>
        public uint reserved;
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
    /// A view of a mask.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mask_columns
    {
        /// <summary>
        /// `sizeof(tree_mask_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Width in pixels.
        /// </summary>
        public uint width;
        /// <summary>
        /// Height in pixels.
        /// </summary>
        public uint height;
        /// <summary>
        /// One byte for each pixel, rows from top to bottom: 0 is empty, 255 is full.
        /// </summary>
        public byte* coverage;
        /// <summary>
        /// Number of pixels: `width * height`.
        /// </summary>
        public UIntPtr n_pixels;
        /// <summary>
        /// Covered area in pixels.
        /// </summary>
        public double area;
    }

    /// <summary>
    /// Light, ground and backdrop of a picture. Begin with `tree_style_init`, a clear day on grass, or
    /// `tree_style_studio`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_style
    {
        /// <summary>
        /// `sizeof(tree_style)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where the sun stands around the trunk, in radians, as `yaw` of a view: 0 on +Z, a quarter turn on
        /// +X. Finite; default -0.35.
        /// </summary>
        public float sun_yaw;
        /// <summary>
        /// Height of the sun over the horizon in radians, 0.05 to pi/2. Default 0.85.
        /// </summary>
        public float sun_pitch;
        /// <summary>
        /// Strength of the sun, 0 (none) to 100. Default 2.3.
        /// </summary>
        public float sun;
        /// <summary>
        /// Strength of the sky, 0 (none) to 100. Default 1.
        /// </summary>
        public float sky;
        /// <summary>
        /// What the light is multiplied with before the tone curve, 0.01 to 100. Default 1.
        /// </summary>
        public float exposure;
        /// <summary>
        /// Sharpness of the sun's shadows: about this many texels squared, 16 to 8192. Cost grows with the
        /// square. Default 2048.
        /// </summary>
        public uint sun_map_px;
        /// <summary>
        /// From how many directions sky light is taken, 0 (unhindered everywhere) to 64. More gives smoother
        /// shade at a cost of one pass over all triangles each. Default 12.
        /// </summary>
        public uint sky_directions;
        /// <summary>
        /// Sharpness of the sky's shade: texels squared per direction, 16 to 2048. Default 256.
        /// </summary>
        public uint sky_map_px;
        /// <summary>
        /// What is behind the mesh. Default `TREE_BACKDROP_SKY`.
        /// </summary>
        public uint backdrop; // tree_backdrop
        /// <summary>
        /// Whether there is an endless ground; without, roots stay visible. Default 1.
        /// </summary>
        public uint has_ground;
        /// <summary>
        /// Height of the ground in metres, -1e6 to 1e6. Default 0, the base of the tree.
        /// </summary>
        public float ground;
        /// <summary>
        /// Linear colour of the ground, 0 to 1 each; varied a little over the ground under
        /// `TREE_BACKDROP_SKY`. Default 0.075, 0.098, 0.032.
        /// </summary>
        public fixed float ground_color[3];
    }

    /// <summary>
    /// How places are found. Begin with `tree_gibbs_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_gibbs_params
    {
        /// <summary>
        /// `sizeof(tree_gibbs_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How quickly branches stop to keep others away, 0 to 1000 for a distance of the whole length. Default 20.
        /// </summary>
        public float reach;
        /// <summary>
        /// Weight of closeness, 0 to 1000. Default 2.
        /// </summary>
        public float closeness;
        /// <summary>
        /// Weight of the pattern, 0 to 1000. Default 1.
        /// </summary>
        public float pattern;
        /// <summary>
        /// Most moves, 0 to 1,000,000. Default 3000.
        /// </summary>
        public uint moves;
        /// <summary>
        /// The process ends when four moves of each branch lower the cost by less than this share, 0 to 1. Default 0.0001.
        /// 0 makes all moves.
        /// </summary>
        public float quiet;
        /// <summary>
        /// How far branches of a node stand off from it along the parent, as a share of the average node length, 0 to 0.5.
        /// Default 0.06.
        /// </summary>
        public float scatter;
    }

    /// <summary>
    /// Where a branch may stand on its parent.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_domain
    {
        /// <summary>
        /// Lowest and highest share of the parent's length, 0 to 1. Equal where the place is given.
        /// </summary>
        public fixed float along[2];
        /// <summary>
        /// First and last azimuth in radians, -1000 to 1000, in the sense that azimuth turns: 0 is the right side of the
        /// drawing, π the left. The last may be less than the first (the domain then passes 2π); 2π or more apart is all round.
        /// </summary>
        public fixed float azimuth[2];
    }

    /// <summary>
    /// How branches are arranged round their parent: in the paper's terms n:φ. A part of other structs; zeros are
    /// `TREE_ARRANGEMENT_SPREAD`. `tree_arrangement_from_text` fills one in by name.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_arrangement
    {
        /// <summary>
        /// Which pattern.
        /// </summary>
        public uint kind; // tree_arrangement_kind
        /// <summary>
        /// Branches at a node, 1 to 64; read for whorls and custom patterns.
        /// </summary>
        public uint per_node;
        /// <summary>
        /// In radians, -2π to 2π: the turn from a node to the next of spirals, whorls and custom patterns, the azimuth
        /// of horizontal pairs.
        /// </summary>
        public float angle;
    }

    /// <summary>
    /// How places came about.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_arranged_report
    {
        /// <summary>
        /// `sizeof(tree_arranged_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The total cost of the places.
        /// </summary>
        public float cost;
        /// <summary>
        /// Moves tried.
        /// </summary>
        public uint moves;
        /// <summary>
        /// Moves kept.
        /// </summary>
        public uint accepted;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Where a branch stands on its parent.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_site
    {
        /// <summary>
        /// Share of the parent's length, 0 to 1.
        /// </summary>
        public float along;
        /// <summary>
        /// Azimuth round the parent in radians, 0 to 2π. 0 is the right side of the drawing, π the left.
        /// </summary>
        public float azimuth;
        /// <summary>
        /// The node it stands at, counted from the parent's base; without a pattern its rank along the parent.
        /// </summary>
        public uint node;
    }

    /// <summary>
    /// How closely branches gather at the privileged positions of a pattern.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_concentration
    {
        /// <summary>
        /// `sizeof(tree_concentration)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Angles tested.
        /// </summary>
        public uint pairs;
        /// <summary>
        /// Mean resultant length, 0 (evenly about) to 1 (all alike).
        /// </summary>
        public float resultant;
        /// <summary>
        /// Where they gather, as an angle from the privileged position in radians.
        /// </summary>
        public float offset;
        /// <summary>
        /// The probability that chance alone gathers them so closely.
        /// </summary>
        public float p_value;
        /// <summary>
        /// Angles by twelfths of the angle between neighbours at a node, the first bin centred on the privileged position.
        /// </summary>
        public fixed uint histogram[12];
        /// <summary>
        /// 1 where there is a pattern to keep to, else 0.
        /// </summary>
        public uint has_pattern;
        /// <summary>
        /// 1 where the test is passed: angles gather significantly (p below 0.001) and the fullest bin is the first; without a
        /// pattern, that they do not gather (p at least 0.05). Else 0.
        /// </summary>
        public uint passes;
    }

    /// <summary>
    /// The branching angle function: the angle between a parent's direction and that of its branches where they leave,
    /// along the parent. Between samples it is interpolated, beyond them it is constant. Begin with
    /// `tree_branching_angles_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branching_angles
    {
        /// <summary>
        /// `sizeof(tree_branching_angles)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of samples, at most 10,000; 0 for those of `tree_branching_angles_init`.
        /// </summary>
        public UIntPtr n_samples;
        /// <summary>
        /// Two floats for each: place along the parent, 0 at its base to 1 at its tip, in rising order; and angle in
        /// radians, 0 (straight on) to π (backwards). Default 1.35 at the base to 0.6 at the tip: low branches are near
        /// horizontal, high ones near upright.
        /// </summary>
        public float* samples;
    }

    /// <summary>
    /// How branches are inferred. Begin with `tree_branch_infer_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branch_infer_params
    {
        /// <summary>
        /// `sizeof(tree_branch_infer_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Places along the parent that are tried, 2 to 10,000. Default 48.
        /// </summary>
        public uint places;
        /// <summary>
        /// Points of a branch, 2 to 1000. Default 16.
        /// </summary>
        public uint points;
        /// <summary>
        /// Length of the tangents over the distance of base and end, 0 (straight) to 2. Default 0.5.
        /// </summary>
        public float tangents;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// From where to where a branch runs.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branch_span
    {
        /// <summary>
        /// Where it begins.
        /// </summary>
        public fixed float @base[2];
        /// <summary>
        /// Where it ends.
        /// </summary>
        public fixed float end[2];
        /// <summary>
        /// Whether it is on its parent's left side: a shape is mirrored between the sides.
        /// </summary>
        public uint left;
    }

    /// <summary>
    /// What the shape of a branch is like, whatever its size.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branch_shape_report
    {
        /// <summary>
        /// `sizeof(tree_branch_shape_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// The angle in radians from the span to the direction the branch leaves in, positive towards the outer side, away
        /// from the parent's tip.
        /// </summary>
        public float leaving;
        /// <summary>
        /// How far its outline reaches along the span, in spans; at least 1.
        /// </summary>
        public float reach;
    }

    /// <summary>
    /// How bumps are found. Begin with `tree_bump_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bump_params
    {
        /// <summary>
        /// `sizeof(tree_bump_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10.
        /// Between clear valleys half of it is enough, without any it takes twice as much. Default 0.2.
        /// </summary>
        public float prominence;
        /// <summary>
        /// Features that stand out less than this share of the outline's size (the longer side of its box) are no
        /// bumps, 0.001 to 0.5. Default 0.02.
        /// </summary>
        public float detail;
    }

    /// <summary>
    /// One bump of an outline: the foliage of one major branch.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_bump
    {
        /// <summary>
        /// Its central point, where the branch ends: the middle of a round end, and about the tip of a sharp one.
        /// </summary>
        public fixed float centre[2];
        /// <summary>
        /// Its outermost point, on the outline.
        /// </summary>
        public fixed float tip[2];
        /// <summary>
        /// Direction of the chordal axis at the centre, outwards, of unit length.
        /// </summary>
        public fixed float tangent[2];
        /// <summary>
        /// Radius of the disc about the centre that fits into the outline, in metres; about 0 at a sharp feature.
        /// </summary>
        public float radius;
        /// <summary>
        /// The part of the outline that is the bump's: from one length along it, in metres against the clock from its
        /// first corner, to another, which is greater than the perimeter where it passes that corner.
        /// </summary>
        public fixed float stretch[2];
    }

    /// <summary>
    /// How the branches on axes of one level stand, and what they are like where nobody drew any. Begin with
    /// `tree_silhouette_level_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_level
    {
        /// <summary>
        /// `sizeof(tree_silhouette_level)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Angles where no system of the level was drawn: NULL, the default, for 1.1 at the base and 0.6 at the tip. For the
        /// trunk it is `angles` of `tree_silhouette_params` that counts.
        /// </summary>
        public tree_branching_angles* angles;
        /// <summary>
        /// How they are arranged round the axis. Default `TREE_ARRANGEMENT_SPREAD`.
        /// </summary>
        public tree_arrangement arrangement;
        /// <summary>
        /// Branches added in space for each one in the plane, 0 to 100. Default 2.
        /// </summary>
        public float density;
        /// <summary>
        /// Branches in the plane on an axis where no system of the level was drawn, 0 to 4000. Default 18.
        /// </summary>
        public uint count;
        /// <summary>
        /// How far branches are turned about their span from base to end, in radians, -2π to 2π: a slight spiral.
        /// Default 0, planar.
        /// </summary>
        public float spiral;
        /// <summary>
        /// Variation of lengths, as a share, 0 to 0.9; angles vary by half of that in radians. Default 0.12.
        /// </summary>
        public float jitter;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// The leaves. NaN stands for what is to be found in the drawing. Begin with `tree_silhouette_leaves_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_leaves
    {
        /// <summary>
        /// `sizeof(tree_silhouette_leaves)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How they are arranged along a branch. Default the spiral of the golden angle.
        /// </summary>
        public tree_arrangement arrangement;
        /// <summary>
        /// Length in metres, 1e-5 to 100. NaN, the default, for that of the drawn leaf, or else what suits the branches that
        /// bear them.
        /// </summary>
        public float length;
        /// <summary>
        /// Distance of leaves along a branch in leaf lengths, all sides together, 0.001 to 100. NaN, the default, for what was
        /// drawn, or 0.3.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Angle to the branch, 0 to π. NaN, the default, for what was drawn, or 1.
        /// </summary>
        public float angle;
        /// <summary>
        /// Share of the branch that is bare, from its base, 0 to 1. NaN, the default, for what was drawn, or 0.1.
        /// </summary>
        public float bare;
        /// <summary>
        /// Petiole in leaf lengths, 0 to 10. Default 0.05.
        /// </summary>
        public float petiole;
        /// <summary>
        /// How far upper faces are turned up, 0 (as they grow) to 1. Default 0.5.
        /// </summary>
        public float facing;
        /// <summary>
        /// Variation of lengths, as a share, 0 to 0.9. Default 0.2.
        /// </summary>
        public float jitter;
    }

    /// <summary>
    /// How a plan becomes a tree. Begin with `tree_silhouette_grow_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_grow_params
    {
        /// <summary>
        /// `sizeof(tree_silhouette_grow_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of levels of axes that parameters are given for, at most 64. Default 0: all as by default.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Levels of axes that bear branches: the trunk first. Levels beyond are as the last.
        /// </summary>
        public tree_silhouette_level* levels;
        /// <summary>
        /// The leaves. NULL, the default, for `tree_silhouette_leaves_init`.
        /// </summary>
        public tree_silhouette_leaves* leaves;
        /// <summary>
        /// Names of the tree, its bark and its leaf, which is kind 0. NULL, the default, for an oak with clusters of leaves.
        /// </summary>
        public tree_species* species;
        /// <summary>
        /// The search for azimuths. NULL is the default.
        /// </summary>
        public tree_gibbs_params* gibbs;
        /// <summary>
        /// 0 for a bare tree. Default 1.
        /// </summary>
        public uint has_leaves;
        /// <summary>
        /// Levels of branches on the trunk, 1 to 8. 0, the default, for those drawn, but two at least where no leaf tells.
        /// </summary>
        public uint depth;
        /// <summary>
        /// How far a sketched branch may stand off the drawing's plane, in radians, 0 to below π/2. Default π/4.
        /// </summary>
        public float domain;
        /// <summary>
        /// Radius of the trunk in metres, 1e-6 to 100. 0, the default, for `slenderness` times the height.
        /// </summary>
        public float trunk_radius;
        /// <summary>
        /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
        /// </summary>
        public float slenderness;
        /// <summary>
        /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
        /// </summary>
        public float exponent;
        /// <summary>
        /// Whether twigs and leaves that would be seen outside the outlines are left out. Default 1.
        /// </summary>
        public uint fence;
        /// <summary>
        /// How full the outlines are made: leaf area in front of every cell of them over the cell's, 0 (what grows) to 10.
        /// Default 1.6.
        /// </summary>
        public float fill;
    }

    /// <summary>
    /// How a plan became a tree. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_grown
    {
        /// <summary>
        /// `sizeof(tree_silhouette_grown)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of levels of branches, the trunk's included.
        /// </summary>
        public UIntPtr n_levels;
        /// <summary>
        /// Branches of every level, the trunk first; levels beyond the array count with the last.
        /// </summary>
        public fixed ulong branches[16];
        /// <summary>
        /// Of those on the trunk, how many were sketched. The others were added in space.
        /// </summary>
        public ulong n_sketched;
        /// <summary>
        /// Leaves.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Branches without room in the outline of their parent, which were left out.
        /// </summary>
        public ulong n_without_room;
        /// <summary>
        /// Branches and leaves left out because they would be seen outside the outlines.
        /// </summary>
        public ulong n_fenced;
        /// <summary>
        /// Leaves added where the outlines were empty.
        /// </summary>
        public ulong n_filled;
        /// <summary>
        /// Different patterns that were made.
        /// </summary>
        public ulong n_patterns;
        /// <summary>
        /// Leaves and branches together: the paper's count of elements.
        /// </summary>
        public ulong n_elements;
    }

    /// <summary>
    /// A view of a drawn leaf, in lengths of the leaf.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_outline_columns
    {
        /// <summary>
        /// `sizeof(tree_leaf_outline_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of corners, at most 64.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Number of indices, three for each triangle.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// Two floats for each corner: the border, against the clock.
        /// </summary>
        public float* points;
        /// <summary>
        /// Three for each triangle, against the clock: its corners.
        /// </summary>
        public uint* indices;
        /// <summary>
        /// Lowest coordinates.
        /// </summary>
        public fixed float low[2];
        /// <summary>
        /// Highest coordinates.
        /// </summary>
        public fixed float high[2];
        /// <summary>
        /// Area for a leaf of length 1.
        /// </summary>
        public float area;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a drawn stroke becomes an outline. Begin with `tree_outline_close_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_close_params
    {
        /// <summary>
        /// `sizeof(tree_outline_close_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Ends closer than this share of the stroke's length count as closed by hand; wider gaps are noted as such, 0 to
        /// 1. Default 0.15.
        /// </summary>
        public float gap;
        /// <summary>
        /// Most corners of an outline, 8 to 4096; those that change its shape least are left out. Default 2000.
        /// </summary>
        public uint corners;
    }

    /// <summary>
    /// A view of an outline.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_columns
    {
        /// <summary>
        /// `sizeof(tree_outline_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of corners, three at least.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Two floats for each corner, against the clock. The last is joined to the first.
        /// </summary>
        public float* points;
        /// <summary>
        /// Lowest coordinates in metres.
        /// </summary>
        public fixed float low[2];
        /// <summary>
        /// Highest coordinates in metres.
        /// </summary>
        public fixed float high[2];
        /// <summary>
        /// Area in square metres.
        /// </summary>
        public float area;
        /// <summary>
        /// Length round in metres.
        /// </summary>
        public float perimeter;
    }

    /// <summary>
    /// One thing that was repaired or noticed of a stroke. Fields that its kind does not name are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_repair
    {
        /// <summary>
        /// What it was.
        /// </summary>
        public uint kind; // tree_outline_repair_kind
        /// <summary>
        /// How many there were.
        /// </summary>
        public uint count;
        /// <summary>
        /// How many there are now.
        /// </summary>
        public uint after;
        /// <summary>
        /// A length in metres.
        /// </summary>
        public float gap;
        /// <summary>
        /// A share, 0 to 1.
        /// </summary>
        public float share;
    }

    /// <summary>
    /// How gaps between branches are filled. Begin with `tree_cover_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_cover_params
    {
        /// <summary>
        /// `sizeof(tree_cover_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Places on each side of the axis that are tried, 0 to 10,000. Default 24.
        /// </summary>
        public uint places;
        /// <summary>
        /// Share of a new branch's outline that may overlap its siblings, 0 to 1. Default 0.2, as in the paper.
        /// </summary>
        public float overlap;
        /// <summary>
        /// Longest stretch of the outline that may stay bare, as a share of its length round, 0.005 to 1. Default 0.04.
        /// </summary>
        public float bare;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How sub-silhouettes are cut out. Begin with `tree_sub_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sub_params
    {
        /// <summary>
        /// `sizeof(tree_sub_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Opening of the cone at a sharp feature, in radians, 0.02 to 3. Default 20°.
        /// </summary>
        public float narrow;
        /// <summary>
        /// Opening where the radius at the end is the branch's span or more, in radians, 0.02 to 3. Default 110°.
        /// </summary>
        public float wide;
    }

    /// <summary>
    /// How the branches of a system are found: an axis with the outline of its foliage. A part that is NULL, as all are
    /// after `tree_branch_system_params_init`, is its default.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_branch_system_params
    {
        /// <summary>
        /// `sizeof(tree_branch_system_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How bumps are found.
        /// </summary>
        public tree_bump_params* bumps;
        /// <summary>
        /// How branches are inferred.
        /// </summary>
        public tree_branch_infer_params* infer;
        /// <summary>
        /// How sub-silhouettes are made.
        /// </summary>
        public tree_sub_params* sub;
        /// <summary>
        /// How gaps are filled.
        /// </summary>
        public tree_cover_params* cover;
    }

    /// <summary>
    /// All parameters from strokes to a tree. A part that is NULL, as all are after `tree_silhouette_params_init`, is its
    /// default.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_params
    {
        /// <summary>
        /// `sizeof(tree_silhouette_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How strokes become outlines.
        /// </summary>
        public tree_outline_close_params* outline;
        /// <summary>
        /// How branches are found in outlines.
        /// </summary>
        public tree_branch_system_params* system;
        /// <summary>
        /// Angles of the branches on the trunk, until branches are redrawn. Default 1.35 at the base, 0.6 at the tip.
        /// </summary>
        public tree_branching_angles* angles;
        /// <summary>
        /// How the plan becomes a tree.
        /// </summary>
        public tree_silhouette_grow_params* grow;
        /// <summary>
        /// A stroke redraws a branch when its ends are on average no farther off than this share of the branch's span, 0
        /// to 10; else it adds one. Default 0.35. Messages call it `near`.
        /// </summary>
        public float nearness;
        /// <summary>
        /// Height in metres of the tallest tree of a drawing, 0.001 to 1000. Default 10.
        /// </summary>
        public float height;
    }

    /// <summary>
    /// The numbers behind an arrangement.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_arrangement_numbers
    {
        /// <summary>
        /// `sizeof(tree_arrangement_numbers)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Branches at a node, n. 1 for `TREE_ARRANGEMENT_SPREAD`.
        /// </summary>
        public uint per_node;
        /// <summary>
        /// Turn from a node to the next, φ, in radians.
        /// </summary>
        public float turn;
        /// <summary>
        /// Angle between two neighbours at a node, γ, in radians.
        /// </summary>
        public float spacing;
        /// <summary>
        /// The azimuth that one privileged position of every node has, in radians, where `has_fixed` says so.
        /// </summary>
        public float @fixed;
        /// <summary>
        /// 1 where the arrangement fixes an azimuth, else 0.
        /// </summary>
        public uint has_fixed;
        /// <summary>
        /// 1 where branches have privileged positions at all, else 0.
        /// </summary>
        public uint has_pattern;
    }

    /// <summary>
    /// All branches of a `tree_outline_plan`, parents first: a view. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_plan_columns
    {
        /// <summary>
        /// `sizeof(tree_outline_plan_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of rows.
        /// </summary>
        public UIntPtr n_branches;
        /// <summary>
        /// Rows of the tree itself. Those after them are branches of other trees that it may copy the style of.
        /// </summary>
        public UIntPtr n_own;
        /// <summary>
        /// Id of each, above 0.
        /// </summary>
        public uint* ids;
        /// <summary>
        /// Id of the branch it stands on; `TREE_NO_BRANCH` for those on a trunk.
        /// </summary>
        public uint* parents;
        /// <summary>
        /// 1 for those on the trunk, 2 for those on these, and so on.
        /// </summary>
        public uint* levels;
        /// <summary>
        /// Why it is there.
        /// </summary>
        public uint* origins;
        /// <summary>
        /// Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
        /// </summary>
        public uint* styles;
        /// <summary>
        /// Where it leaves its parent, as a share of the parent's length.
        /// </summary>
        public float* places;
        /// <summary>
        /// Radius of its bump in metres, or of what stands for one.
        /// </summary>
        public float* radii;
        /// <summary>
        /// Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
        /// </summary>
        public float* azimuths;
        /// <summary>
        /// Two floats each: the part of the parent's outline it may share, as lengths along; NaN for all.
        /// </summary>
        public float* stretches;
        /// <summary>
        /// 1 where it is on the left side of its parent, looking towards the parent's tip.
        /// </summary>
        public byte* lefts;
        /// <summary>
        /// 1 where the outline of its foliage was drawn, so that it bears a system.
        /// </summary>
        public byte* refined;
        /// <summary>
        /// Number of points of all lines.
        /// </summary>
        public UIntPtr n_line_points;
        /// <summary>
        /// Where each line begins in `line_points`, and at last their number: `n_branches + 1` values.
        /// </summary>
        public uint* line_starts;
        /// <summary>
        /// Two floats for each point, from base to end.
        /// </summary>
        public float* line_points;
        /// <summary>
        /// Number of points of all outlines.
        /// </summary>
        public UIntPtr n_outline_points;
        /// <summary>
        /// Where each outline begins in `outline_points`, and at last their number: `n_branches + 1` values.
        /// </summary>
        public uint* outline_starts;
        /// <summary>
        /// Two floats for each point, against the clock, the first not repeated.
        /// </summary>
        public float* outline_points;
    }

    /// <summary>
    /// One branch of a plan: a view. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_branch
    {
        /// <summary>
        /// `sizeof(tree_outline_branch)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of points of its line.
        /// </summary>
        public UIntPtr n_line_points;
        /// <summary>
        /// Two floats for each, from base to end.
        /// </summary>
        public float* line_points;
        /// <summary>
        /// Number of points of the outline of its foliage.
        /// </summary>
        public UIntPtr n_outline_points;
        /// <summary>
        /// Two floats for each, against the clock, the first not repeated.
        /// </summary>
        public float* outline_points;
        /// <summary>
        /// Its id.
        /// </summary>
        public uint id;
        /// <summary>
        /// Id of the branch it stands on; `TREE_NO_BRANCH` for the trunk.
        /// </summary>
        public uint parent;
        /// <summary>
        /// 1 for one on the trunk, 2 for one on these, and so on.
        /// </summary>
        public uint level;
        /// <summary>
        /// Why it is there.
        /// </summary>
        public uint origin; // tree_branch_origin
        /// <summary>
        /// Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
        /// </summary>
        public uint style;
        /// <summary>
        /// 1 where it is on the left side of its parent, looking towards the parent's tip.
        /// </summary>
        public uint is_left;
        /// <summary>
        /// 1 where the outline of its foliage was drawn, so that it bears a system.
        /// </summary>
        public uint is_refined;
        /// <summary>
        /// Where it leaves its parent, as a share of the parent's length.
        /// </summary>
        public float place;
        /// <summary>
        /// Radius of its bump in metres, or of what stands for one.
        /// </summary>
        public float radius;
        /// <summary>
        /// Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
        /// </summary>
        public float azimuth;
    }

    /// <summary>
    /// An axis, the outline of its foliage and the angles at which branches leave it: a view. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_system
    {
        /// <summary>
        /// `sizeof(tree_outline_system)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of points of the axis: the trunk or branch.
        /// </summary>
        public UIntPtr n_axis_points;
        /// <summary>
        /// Two floats for each, from base to tip.
        /// </summary>
        public float* axis_points;
        /// <summary>
        /// Number of points of the outline of its foliage: the crown of the trunk.
        /// </summary>
        public UIntPtr n_outline_points;
        /// <summary>
        /// Two floats for each, against the clock, the first not repeated.
        /// </summary>
        public float* outline_points;
        /// <summary>
        /// Number of samples of the branching angles.
        /// </summary>
        public UIntPtr n_angles;
        /// <summary>
        /// Two floats for each: place along the axis, 0 at its base to 1 at its tip, in rising order; and angle, 0 (straight
        /// on) to π (backwards).
        /// </summary>
        public float* angles;
        /// <summary>
        /// Number of branches on it.
        /// </summary>
        public UIntPtr n_branches;
        /// <summary>
        /// Number of outlines in further planes; see `tree_outline_plan_section`.
        /// </summary>
        public UIntPtr n_sections;
    }

    /// <summary>
    /// A stroke of a drawing of outlines: as input, or as a view of a `tree_outline_drawing`. Zeros are its defaults: an axis of
    /// level 0 in the plane of the drawing. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_drawn_stroke
    {
        /// <summary>
        /// `sizeof(tree_drawn_stroke)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Two floats for each point, in units of the drawing, y downwards. All are finite.
        /// </summary>
        public float* points;
        /// <summary>
        /// Its name in the drawing; empty where it has none.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// What it belongs to. Default 0.
        /// </summary>
        public uint level; // tree_drawn_level
        /// <summary>
        /// What it shows. Default `TREE_DRAWN_KIND_AXIS`.
        /// </summary>
        public uint kind; // tree_drawn_kind
        /// <summary>
        /// By how much the plane it is drawn in is turned about the trunk, in radians. Default 0, the plane of the drawing.
        /// </summary>
        public float azimuth;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of one tree of a drawing.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_drawn_tree
    {
        /// <summary>
        /// `sizeof(tree_drawn_tree)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its name in the drawing; empty where it has none.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Number of strokes, one at least.
        /// </summary>
        public UIntPtr n_strokes;
        /// <summary>
        /// Width of the trunk in units of the drawing, where it was drawn as an area; else 0.
        /// </summary>
        public float trunk_width;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One thing that was repaired or noticed in a drawing. Fields that its kind does not name are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_drawn_repair
    {
        /// <summary>
        /// What it was.
        /// </summary>
        public uint kind; // tree_drawn_repair_kind
        /// <summary>
        /// How many there were.
        /// </summary>
        public uint count;
        /// <summary>
        /// A share, 0 to 1.
        /// </summary>
        public float share;
        /// <summary>
        /// A length in units of the drawing.
        /// </summary>
        public float width;
    }

    /// <summary>
    /// The frame of a surface.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_revolved_frame
    {
        /// <summary>
        /// `sizeof(tree_revolved_frame)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where it begins: the start of the axis, in the drawing.
        /// </summary>
        public fixed float origin[2];
        /// <summary>
        /// The unit vector along the span of the axis, in the drawing.
        /// </summary>
        public fixed float up[2];
    }

    /// <summary>
    /// What became of a drawing's strokes. `tree_silhouette_repairs` and `tree_silhouette_refused` tell more. Set
    /// `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_play_report
    {
        /// <summary>
        /// `sizeof(tree_silhouette_play_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Repairs of strokes.
        /// </summary>
        public ulong n_repairs;
        /// <summary>
        /// Strokes that could not be used.
        /// </summary>
        public ulong n_refused;
        /// <summary>
        /// Strokes that were used.
        /// </summary>
        public uint n_strokes;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of a `tree_silhouette_change`: ids of branches, in rising order. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_silhouette_change_columns
    {
        /// <summary>
        /// `sizeof(tree_silhouette_change_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of branches that are new.
        /// </summary>
        public UIntPtr n_added;
        /// <summary>
        /// Their ids.
        /// </summary>
        public uint* added;
        /// <summary>
        /// Number of branches that are gone.
        /// </summary>
        public UIntPtr n_removed;
        /// <summary>
        /// Their ids.
        /// </summary>
        public uint* removed;
        /// <summary>
        /// Number of branches whose line, outline or place is another.
        /// </summary>
        public UIntPtr n_reshaped;
        /// <summary>
        /// Their ids.
        /// </summary>
        public uint* reshaped;
        /// <summary>
        /// Number of branches that bear a drawn system which they did not, or another one, or take their style from
        /// elsewhere.
        /// </summary>
        public UIntPtr n_restyled;
        /// <summary>
        /// Their ids.
        /// </summary>
        public uint* restyled;
        /// <summary>
        /// Number of repairs of the stroke.
        /// </summary>
        public UIntPtr n_repairs;
        /// <summary>
        /// What was repaired in the stroke, in sentences.
        /// </summary>
        public tree_str* repairs;
        /// <summary>
        /// 1 where the trunk or the crown is another.
        /// </summary>
        public uint trunk;
        /// <summary>
        /// 1 where the leaf is another.
        /// </summary>
        public uint leaf;
    }

    /// <summary>
    /// How a drawing becomes a stand. Begin with `tree_stand_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stand_params
    {
        /// <summary>
        /// `sizeof(tree_stand_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Of each tree; `height` is that of the tallest. NULL, the default, for `tree_silhouette_params_init`.
        /// </summary>
        public tree_silhouette_params* silhouette;
        /// <summary>
        /// Number of rows of `lendings`. Default 0.
        /// </summary>
        public UIntPtr n_lendings;
        /// <summary>
        /// Who borrows from whom, where that is not to be the detailed tree with the most similar crown: two numbers each,
        /// places in the drawing from 0: the tree that borrows, and the one that lends, `TREE_NO_TREE` for nobody. The last row
        /// for a tree counts.
        /// </summary>
        public uint* lendings;
        /// <summary>
        /// How distances are read. Default `TREE_PERSPECTIVE_ESTIMATED`.
        /// </summary>
        public uint perspective; // tree_perspective
        /// <summary>
        /// For `TREE_PERSPECTIVE_HORIZON` the height of the horizon in the drawing: y in its units, downwards, -1e6 to 1e6.
        /// </summary>
        public float horizon;
        /// <summary>
        /// Angle under which the width of all trees is seen in the drawing, in radians, 0.05 to 2.5: what turns sizes into
        /// distances. Default 0.9, as in a photograph. Unused without perspective.
        /// </summary>
        public float fov;
        /// <summary>
        /// Without perspective: how far trees stand off their line, as a share of their mean distance, 0 to 10. Default 0.4.
        /// </summary>
        public float jitter;
        /// <summary>
        /// Borrowed branches and leaves are scaled as the crowns are, but at most by this factor up or down, 1 to 100.
        /// Default 3.
        /// </summary>
        public float scaling;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A stand as a whole: a view. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stand_whole
    {
        /// <summary>
        /// `sizeof(tree_stand_whole)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of trees.
        /// </summary>
        public UIntPtr n_trees;
        /// <summary>
        /// Leaves and branches of all trees together.
        /// </summary>
        public ulong n_elements;
        /// <summary>
        /// 1 where the drawing is in perspective, and the fields below count.
        /// </summary>
        public uint has_view;
        /// <summary>
        /// Distance of the drawing from the eye, in units of the drawing.
        /// </summary>
        public float focal;
        /// <summary>
        /// The point of the drawing that the eye looks at: on the horizon, in units of the drawing.
        /// </summary>
        public fixed float centre[2];
        /// <summary>
        /// The eye in metres; it looks level along -Z.
        /// </summary>
        public fixed float eye[3];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One tree of a stand: a view. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_stand_tree
    {
        /// <summary>
        /// `sizeof(tree_stand_tree)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Its name in the drawing, or `tree 3` for the third where it has none.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Its place among the trees of the drawing, from 0.
        /// </summary>
        public uint number;
        /// <summary>
        /// The tree, by its place in the drawing, whose branches or leaf it borrows; `TREE_NO_TREE` where it borrows nothing.
        /// </summary>
        public uint lender;
        /// <summary>
        /// Where its base stands in the stand, in metres: x as in the drawing, +Z towards the viewer.
        /// </summary>
        public fixed float position[3];
        /// <summary>
        /// Metres for a unit of the drawing, at this tree.
        /// </summary>
        public float scale;
        /// <summary>
        /// By how much what it borrows is scaled; 1 where it borrows nothing.
        /// </summary>
        public float borrowed_scale;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a sub-silhouette hangs together with its parent.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sub_report
    {
        /// <summary>
        /// `sizeof(tree_sub_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Begin and end of the shared part, in metres along the parent against the clock from its first corner; the second
        /// may be greater than the perimeter. Both are one place where nothing could be shared.
        /// </summary>
        public fixed float shared[2];
        /// <summary>
        /// The points where the curves join the shared part: its begin, then its end.
        /// </summary>
        public fixed float join_points[4];
        /// <summary>
        /// Directions of the outline there, against the clock, of unit length.
        /// </summary>
        public fixed float join_tangents[4];
        /// <summary>
        /// The curves from the branch's base to the begin, and from the end to the base. Of each: where it begins, the
        /// derivative there, where it ends, the derivative there, two floats each, of a cubic Hermite curve.
        /// </summary>
        public fixed float curves[16];
    }

    /// <summary>
    /// The axes in columns. Parent axes come first; axis 0 is the trunk.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_axis_columns
    {
        /// <summary>
        /// `sizeof(tree_axis_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of axes, at least 1.
        /// </summary>
        public UIntPtr n_axes;
        /// <summary>
        /// Number of nodes of the skeleton.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// One for each axis: its order after Gravelius, 0 for the trunk, one more than the parent axis for
        /// a lateral.
        /// </summary>
        public uint* orders;
        /// <summary>
        /// One more than there are axes: the nodes of axis `i` are `nodes[starts[i]]` up to, but not
        /// including, `nodes[starts[i + 1]]`.
        /// </summary>
        public uint* starts;
        /// <summary>
        /// `n_nodes` numbers: the nodes, axis after axis, each from base to tip. A lateral's first node is
        /// the first one above the fork; the fork itself belongs to the parent axis.
        /// </summary>
        public uint* nodes;
        /// <summary>
        /// One for each node: the axis it lies on.
        /// </summary>
        public uint* axis_of;
    }

    /// <summary>
    /// How an SWC file relates to this library. Begin with `tree_swc_options_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_swc_options
    {
        /// <summary>
        /// `sizeof(tree_swc_options)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Metres per unit of the file, for positions and radii; 1e-9 to 1e9. Default 1.
        /// </summary>
        public double scale;
        /// <summary>
        /// The file's upward axis. Default `TREE_SWC_UP_Z`.
        /// </summary>
        public uint up; // tree_swc_up
        /// <summary>
        /// Whether reading moves the root to the origin. Default 1. The move is made in double precision, so
        /// that coordinates of a map grid lose nothing. Not used in writing.
        /// </summary>
        public uint base_at_origin;
        /// <summary>
        /// What becomes of radii that the file does not know. Default `TREE_SWC_RADIUS_KEEP`. Not used in
        /// writing.
        /// </summary>
        public uint unknown_radius; // tree_swc_radius
        /// <summary>
        /// Must be 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What an SWC file held beside the skeleton, and what was noted while reading.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_swc_contents
    {
        /// <summary>
        /// `sizeof(tree_swc_contents)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// One for each node: its type as in the file; 3 continues its parent's axis, 4 starts a lateral.
        /// </summary>
        public int* types;
        /// <summary>
        /// One for each node: its id as in the file.
        /// </summary>
        public long* ids;
        /// <summary>
        /// All comments without their `#`, a line each.
        /// </summary>
        public tree_str comments;
        /// <summary>
        /// Rows without a known radius.
        /// </summary>
        public ulong n_unknown_radii;
        /// <summary>
        /// How many of these `unknown_radius` gave a radius.
        /// </summary>
        public ulong n_filled_radii;
        /// <summary>
        /// Rows with more than seven fields; the further ones were passed over.
        /// </summary>
        public ulong n_rows_with_more_fields;
        /// <summary>
        /// 1 if rows came before their parents, so that nodes have another order than rows; else 0.
        /// </summary>
        public uint reordered;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// What was added to every position to bring the root to the origin, in metres and this library's
        /// axes; zeros if nothing was moved.
        /// </summary>
        public fixed double moved_by[3];
    }

    /// <summary>
    /// How a mesh of a tree is read. Everything is relative, so the unit of the mesh does not matter. Begin
    /// with `tree_skeletonize_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_skeletonize_params
    {
        /// <summary>
        /// `sizeof(tree_skeletonize_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Vertices nearer than a quarter of this share of the mesh's size are one, 1e-7 to 0.01. Default
        /// 1e-5. Larger closes cracks and may melt twigs.
        /// </summary>
        public float weld;
        /// <summary>
        /// Least distance between nodes in bent wood, in halves of the radius, 0.1 to 20. Default 1. Straight
        /// wood gets fewer nodes, up to ten radii apart.
        /// </summary>
        public float spacing;
        /// <summary>
        /// How far a node may lie off the measured centre line, in radii, 0 to 0.5. Default 0.08.
        /// </summary>
        public float tolerance;
        /// <summary>
        /// Side shoots that stand out of their parent by less than this share of its radius, and by less than
        /// their own radius, are bumps of the bark, 0 to 2. Default 0.25.
        /// </summary>
        public float prune;
        /// <summary>
        /// Widest gap between separate pieces of wood that is bridged, as a share of the mesh's size, 0 to 1.
        /// Default 0.05. Wood farther away is left out and reported.
        /// </summary>
        public float bridge;
        /// <summary>
        /// Whether leaves are made. Default 1.
        /// </summary>
        public uint leaves;
    }

    /// <summary>
    /// Triangles of one material. Any unit of length; +Y up. Begin with `tree_mesh_part_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_mesh_part
    {
        /// <summary>
        /// `sizeof(tree_mesh_part)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name of the material or object. It names the leaf kind, and may tell wood from leaves.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// Three floats for each vertex, finite.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Two floats for each vertex: texture coordinates, v downwards. NULL for none.
        /// </summary>
        public float* uvs;
        /// <summary>
        /// Number of vertices.
        /// </summary>
        public UIntPtr n_vertices;
        /// <summary>
        /// Three for each triangle.
        /// </summary>
        public uint* indices;
        /// <summary>
        /// Number of indices, a multiple of 3.
        /// </summary>
        public UIntPtr n_indices;
        /// <summary>
        /// What it is made of. Default `TREE_HINT_AUTO`.
        /// </summary>
        public uint hint; // tree_hint
        /// <summary>
        /// Whether its texture has holes. Default 0.
        /// </summary>
        public uint alpha_masked;
        /// <summary>
        /// Whether both faces are drawn. Default 0.
        /// </summary>
        public uint double_sided;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A view of the kinds of leaves that were found.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_leaf_kinds
    {
        /// <summary>
        /// `sizeof(tree_leaf_kinds)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of kinds.
        /// </summary>
        public UIntPtr n_kinds;
        /// <summary>
        /// Names of the kinds: those of the parts they come from.
        /// </summary>
        public tree_str* names;
        /// <summary>
        /// Mean width of each kind as a share of its length.
        /// </summary>
        public float* widths;
    }

    /// <summary>
    /// What one piece of wood stands for.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_piece
    {
        /// <summary>
        /// Area of its surface, in squares of the mesh's own unit.
        /// </summary>
        public float area;
        /// <summary>
        /// Bumps of the bark dropped.
        /// </summary>
        public uint n_bumps;
        /// <summary>
        /// Branches cut where they had grown together.
        /// </summary>
        public uint n_cut;
    }

    /// <summary>
    /// A view of a separation. The triangles of component `i` are rows `starts[i]` up to, but not including,
    /// `starts[i + 1]`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_separation_columns
    {
        /// <summary>
        /// `sizeof(tree_separation_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of components; each lies within one part.
        /// </summary>
        public UIntPtr n_components;
        /// <summary>
        /// For each component what it is taken for.
        /// </summary>
        public uint* classes;
        /// <summary>
        /// `n_components + 1` numbers.
        /// </summary>
        public ulong* starts;
        /// <summary>
        /// Number of triangles: all that have an area, once.
        /// </summary>
        public UIntPtr n_triangles;
        /// <summary>
        /// Two numbers for each triangle: its part, and which triangle of that part it is.
        /// </summary>
        public uint* triangles;
    }

    /// <summary>
    /// What was found in a mesh.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_skeletonize_report
    {
        /// <summary>
        /// `sizeof(tree_skeletonize_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Triangles of all parts.
        /// </summary>
        public ulong n_triangles;
        /// <summary>
        /// Triangles without area after welding, and second ones at one place in a part.
        /// </summary>
        public ulong n_degenerate;
        /// <summary>
        /// Triangles of wood.
        /// </summary>
        public ulong n_wood_triangles;
        /// <summary>
        /// Connected pieces of wood.
        /// </summary>
        public ulong n_pieces;
        /// <summary>
        /// Pieces of wood too far from all others, left out.
        /// </summary>
        public ulong n_left_out;
        /// <summary>
        /// Bumps of the bark dropped.
        /// </summary>
        public ulong n_bumps;
        /// <summary>
        /// Branches cut where they had grown together.
        /// </summary>
        public ulong n_cut;
        /// <summary>
        /// Leaves made.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Closed bodies of leaves, for which nothing was made.
        /// </summary>
        public ulong n_blobs;
        /// <summary>
        /// Number of leaf kinds.
        /// </summary>
        public ulong n_leaf_kinds;
        /// <summary>
        /// Mean width of each leaf kind as a share of its length: of the first
        /// `TREE_SKELETONIZE_LEAF_WIDTHS` kinds; `tree_found_leaves_view` has them all.
        /// </summary>
        public fixed float leaf_widths[256];
        /// <summary>
        /// Share of the wood's surface that the skeleton stands for, 0 to 1.
        /// </summary>
        public float covered;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Columns of branches: as input, or as a view of a `tree_sketch_branches`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_branches_columns
    {
        /// <summary>
        /// `sizeof(tree_sketch_branches_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of segments, at least 1.
        /// </summary>
        public UIntPtr n_segments;
        /// <summary>
        /// Number of points of all segments.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Parent of each segment, which comes before it; `TREE_NO_PARENT` for segment 0.
        /// </summary>
        public uint* parents;
        /// <summary>
        /// Label of each segment; that of segment 0 is `TREE_SKETCH_APICAL`.
        /// </summary>
        public uint* labels;
        /// <summary>
        /// Where each segment's points begin in `points`, and at last their number: `n_segments + 1` values.
        /// </summary>
        public uint* starts;
        /// <summary>
        /// Three floats for each point, in metres: seen along -Z, as the sketch was drawn, z is the depth, positive
        /// towards the viewer. A segment's first point is its parent's last; those that propagation adds may begin on
        /// the way there.
        /// </summary>
        public float* points;
        /// <summary>
        /// A name for each segment that stays when others are drawn or erased: streams of randomness go by it. NULL where
        /// segments have none. Not read as input.
        /// </summary>
        public ulong* names;
        /// <summary>
        /// The generation of each segment, 0 for the sketched. Not read as input.
        /// </summary>
        public uint* generations;
        /// <summary>
        /// Where on its parent each segment begins, counted in the parent's points: 2.25 is a quarter of the way from its
        /// point 2 to its point 3. Not read as input.
        /// </summary>
        public float* forks;
        /// <summary>
        /// How many segments are sketched; they come first. Not read as input.
        /// </summary>
        public UIntPtr n_sketched;
        /// <summary>
        /// Whether segment 0 is not drawn: it stands below a base from which several stems rise, and only says that they
        /// rise.
        /// </summary>
        public uint imagined_root;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a drawing is cleaned and joined. Shares are of the drawing's height (or of a tenth of its width, where
    /// that is more). Begin with `tree_clean_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_clean_params
    {
        /// <summary>
        /// `sizeof(tree_clean_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Height of branches and crown together in metres, 0.01 to 1000. Default 10.
        /// </summary>
        public float height;
        /// <summary>
        /// Distance between nodes, a share, 0.001 to 0.2. Default 0.01. Corners get nodes of their own. Very long
        /// drawings are sampled more coarsely.
        /// </summary>
        public float spacing;
        /// <summary>
        /// Gaps up to this share count as drawn to touch, 0 to 0.2. Default 0.03. Ends that stick out beyond the
        /// stroke they join by up to this share are cut off.
        /// </summary>
        public float snap;
        /// <summary>
        /// A stroke that runs along another within this share is the same, 0 to 0.1. Default 0.012. 0: nothing is
        /// merged.
        /// </summary>
        public float merge;
        /// <summary>
        /// How far a stroke may be from the rest, a share, 0 to 10. Default 0.25.
        /// </summary>
        public float reach;
        /// <summary>
        /// What becomes of strokes beyond the reach. Default `TREE_ISOLATED_BRIDGE`.
        /// </summary>
        public uint isolated; // tree_isolated
        /// <summary>
        /// Whether `root` says where the tree's base is. Default no: it is found.
        /// </summary>
        public uint has_root;
        /// <summary>
        /// Where the tree's base is, in units of the drawing.
        /// </summary>
        public fixed float root[2];
        /// <summary>
        /// Whether strokes without a role may be taken for a crown, the ground, sides of a trunk or marks on its
        /// bark. Default yes; no: what is not marked is a branch.
        /// </summary>
        public uint guess;
        /// <summary>
        /// Forks on one branch closer together than this share are one, 0 (off) to 0.1. Default 0.01.
        /// </summary>
        public float gather;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How a drawn crown is understood. Begin with `tree_crown_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_crown_params
    {
        /// <summary>
        /// `sizeof(tree_crown_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// A stroke whose ends are closer than this share of its length is a loop of its own, 0 to 1. Default 0.15.
        /// </summary>
        public float gap;
        /// <summary>
        /// Ends of strokes closer than this share of the crown's size are joined, 0 to 1. Default 0.05.
        /// </summary>
        public float join;
        /// <summary>
        /// Depth of the crown, along the view, over its width, 0.05 to 20. Default 1: circles.
        /// </summary>
        public float depth;
        /// <summary>
        /// Whether a crown that no branch touches is an error. Default no: it is kept and reported.
        /// </summary>
        public uint refuse;
    }

    /// <summary>
    /// How large a crown is.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_crown_measures
    {
        /// <summary>
        /// `sizeof(tree_crown_measures)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Lowest coordinates of the polygons in metres.
        /// </summary>
        public fixed float low[2];
        /// <summary>
        /// Highest coordinates of the polygons in metres.
        /// </summary>
        public fixed float high[2];
        /// <summary>
        /// Area of the polygons in square metres.
        /// </summary>
        public float area;
        /// <summary>
        /// Volume of the solid in cubic metres.
        /// </summary>
        public float volume;
        /// <summary>
        /// Share of the branches' points that lay outside when it was closed, 0 to 1.
        /// </summary>
        public float outside;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One thing that was repaired or noticed of a drawn crown. Fields that its kind does not name are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_crown_repair
    {
        /// <summary>
        /// What it was.
        /// </summary>
        public uint kind; // tree_crown_repair_kind
        /// <summary>
        /// Number of a stroke of the crown, or of a loop.
        /// </summary>
        public uint stroke;
        /// <summary>
        /// How many there were.
        /// </summary>
        public uint count;
        /// <summary>
        /// How many there are now.
        /// </summary>
        public uint after;
        /// <summary>
        /// A length in metres.
        /// </summary>
        public float gap;
        /// <summary>
        /// A share, 0 to 1.
        /// </summary>
        public float share;
        /// <summary>
        /// 1 or 0.
        /// </summary>
        public uint round_branches;
    }

    /// <summary>
    /// How outlines are drawn. Begin with `tree_outline_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_outline_params
    {
        /// <summary>
        /// `sizeof(tree_outline_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Bays narrower than twice this share of the size are drawn across, 0.01 to 0.5. Default 0.06.
        /// </summary>
        public float closing;
        /// <summary>
        /// Most corners of all outlines together, 12 to 10,000. Default 120.
        /// </summary>
        public uint corners;
    }

    /// <summary>
    /// One line of a drawing: as input, or as a view of a `tree_drawing`. Zeros are its defaults. Set `struct_size`
    /// first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_stroke
    {
        /// <summary>
        /// `sizeof(tree_sketch_stroke)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Two floats for each point, in the drawing's own units, y downwards as on screens. Points that are not
        /// finite are taken: cleaning leaves them out and says so.
        /// </summary>
        public float* points;
        /// <summary>
        /// What messages call it besides its number. Default empty.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// What it shows. Default `TREE_ROLE_UNKNOWN`.
        /// </summary>
        public uint role; // tree_role
        /// <summary>
        /// Whether its end is joined to its beginning.
        /// </summary>
        public uint closed;
        /// <summary>
        /// Whether it is the outline of a filled area rather than a line: of a branch so drawn the middle line is
        /// meant.
        /// </summary>
        public uint filled;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// Which branches of a tree a person would draw. Begin with `tree_main_branches_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_main_branches
    {
        /// <summary>
        /// `sizeof(tree_main_branches)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Least length of axes of order 1 as a share of the longest of them, 0 to 1. Default 0.3.
        /// </summary>
        public float least;
        /// <summary>
        /// Least length of axes of order 2 as a share of their parent's, 0 to 1. Default 0.35.
        /// </summary>
        public float least_second;
        /// <summary>
        /// Most axes, 1 to 1000. Default 36.
        /// </summary>
        public uint most;
        /// <summary>
        /// Forks closer than this on an axis, as a share of the tree's extent, are taken for one, 0 to 0.5. Default
        /// 0.025.
        /// </summary>
        public float gather;
        /// <summary>
        /// What continues an axis at a fork. Default `TREE_CONTINUATION_THICKEST`.
        /// </summary>
        public uint continuation; // tree_continuation
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How branches become a tree. Begin with `tree_sketch_finish_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_finish_params
    {
        /// <summary>
        /// `sizeof(tree_sketch_finish_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whose twigs and leaves: one of the names that `tree_foliage_species_name` gives. Default "oak", which an empty text
        /// is too.
        /// </summary>
        public tree_str species;
        /// <summary>
        /// Whether there are leaves. Default 1.
        /// </summary>
        public uint leaves;
        /// <summary>
        /// Whether there are twigs. Default 1.
        /// </summary>
        public uint twigs;
        /// <summary>
        /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
        /// </summary>
        public float slenderness;
        /// <summary>
        /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
        /// </summary>
        public float exponent;
        /// <summary>
        /// Leaves against those of a tree in full leaf, 0 to 10. Default 1.
        /// </summary>
        public float fullness;
        /// <summary>
        /// Length of twigs against the usual of the species, 0.05 to 20. Default 1.
        /// </summary>
        public float twig_length;
    }

    /// <summary>
    /// What the finish did.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_finish_report
    {
        /// <summary>
        /// `sizeof(tree_sketch_finish_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Nodes of branches.
        /// </summary>
        public ulong n_wood_nodes;
        /// <summary>
        /// Nodes of twigs.
        /// </summary>
        public ulong n_twig_nodes;
        /// <summary>
        /// Nodes of twigs cut off because they left the crown or entered the ground.
        /// </summary>
        public ulong n_twig_nodes_cut;
        /// <summary>
        /// Blades that stayed: rows of the foliage.
        /// </summary>
        public ulong n_leaves;
        /// <summary>
        /// Blades left out because they left the crown or entered the ground.
        /// </summary>
        public ulong n_leaves_outside;
        /// <summary>
        /// How much larger leaves are than the species', because there would be too many; a factor.
        /// </summary>
        public float leaves_larger;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How depths, labels and Ω are inferred. Begin with `tree_sketch_infer_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_infer_params
    {
        /// <summary>
        /// `sizeof(tree_sketch_infer_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Whether Ω stays the template's (Neubert 2012, section 4.6.1) or fits itself to the sketch (section 4.6.2).
        /// Default 0.
        /// </summary>
        public uint keep_omega;
        /// <summary>
        /// Rounds of refining depths and, unless `keep_omega`, of estimating Ω, 0 to 100. Default 6; the thesis needed
        /// fewer than 10.
        /// </summary>
        public uint rounds;
        /// <summary>
        /// Passes of ICM over all segments in each round, at most, 1 to 1000. Default 8.
        /// </summary>
        public uint sweeps;
        /// <summary>
        /// ICM ends where the depths of a pass changed by less than this share of the drawing's size altogether, 0 to 1.
        /// Default 0.0005.
        /// </summary>
        public float settled;
        /// <summary>
        /// How many half-placed trees bottom-up inference keeps at once, 1 to 4096; 1 is the thesis. Large drawings get
        /// fewer, so that time stays linear. Default 64.
        /// </summary>
        public uint beam;
        /// <summary>
        /// How far angles and ratios spread as Ω says, 0 to 1. At 0 each segment aims at the means, as in the thesis, and
        /// all branches come out alike; at 1 each aims at a draw from Ω of its own. Default 1.
        /// </summary>
        public float spread;
        /// <summary>
        /// How strongly branches keep out of each other's space (`k_e` of Eq. 4.22), 0 to 1000. Default 0.2.
        /// </summary>
        public float competition;
        /// <summary>
        /// How much likelier, as the logarithm of a ratio, a stroke goes on as the same axis than as a lateral, 0 (the
        /// thesis) to 100. Default 3.
        /// </summary>
        public float follow;
        /// <summary>
        /// Standard deviation in radians by which a stroke bends towards or away from the viewer from one segment to the
        /// next, 0.01 to 10. Small keeps curvy strokes in their plane. Default 0.3.
        /// </summary>
        public float bending;
        /// <summary>
        /// Ω counts with so many imagined segments of the template when it is estimated, 0.1 to 1e6. Default 8.
        /// </summary>
        public float template_weight;
        /// <summary>
        /// Branches that cross in the drawing keep this multiple of their thickness apart, 0 (off) to 10. Default 1.3.
        /// </summary>
        public float clearance;
        /// <summary>
        /// Radius of the trunk as a share of the height, for the branches' thickness, 1e-4 to 0.2. Default 0.02.
        /// </summary>
        public float slenderness;
    }

    /// <summary>
    /// A normal distribution.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_normal
    {
        /// <summary>
        /// Its mean μ.
        /// </summary>
        public float mean;
        /// <summary>
        /// Its standard deviation σ, 1e-4 to 10.
        /// </summary>
        public float deviation;
    }

    /// <summary>
    /// How axes of one order go on and branch. Angles in radians.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_habit
    {
        /// <summary>
        /// Natural logarithm of the length of the apical segment over that of the segment below. The mean is -10 to 10.
        /// </summary>
        public tree_sketch_normal scale;
        /// <summary>
        /// Natural logarithm of the length of a lateral's first segment over that of the segment below. The mean is -10
        /// to 10.
        /// </summary>
        public tree_sketch_normal lateral_scale;
        /// <summary>
        /// α: the angle between the apical segment and the segment below. The mean is 0 to π.
        /// </summary>
        public tree_sketch_normal alpha;
        /// <summary>
        /// β: the angle between a lateral and the segment below. The mean is 0 to π.
        /// </summary>
        public tree_sketch_normal beta;
        /// <summary>
        /// γ: the turn about the axis from one lateral to the next. The mean is -2π to 2π.
        /// </summary>
        public tree_sketch_normal gamma;
    }

    /// <summary>
    /// Ω, the global parameters of a tree: a habit for axes of order 0 (the trunk), 1 and so on. Begin with
    /// `tree_sketch_omega_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_omega
    {
        /// <summary>
        /// `sizeof(tree_sketch_omega)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// How many orders have a habit of their own, 1 to `TREE_SKETCH_ORDERS`; the last one holds for all higher
        /// orders too. Default 1. Of a template with more of them the first are given.
        /// </summary>
        public uint n_orders;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// The habits; rows from `n_orders` on do not count. Default: a broad-leaved tree's, with nearly straight axes
        /// and laterals at half a right angle in a golden spiral.
        /// </summary>
        public tree_sketch_habit orders_0, orders_1, orders_2, orders_3, orders_4, orders_5, orders_6, orders_7;
    }

    /// <summary>
    /// A depth that is known: of the end of the segment that ends at a node of the plan.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_pin
    {
        /// <summary>
        /// Node of the plan: a tip or a fork.
        /// </summary>
        public uint node;
        /// <summary>
        /// Its depth in metres; positive is towards the viewer.
        /// </summary>
        public float depth;
    }

    /// <summary>
    /// The posterior's logarithm, part by part.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_posterior
    {
        /// <summary>
        /// The whole: the sum of the others.
        /// </summary>
        public double total;
        /// <summary>
        /// Sum of the factors between segments and their parents (Eq. 4.17).
        /// </summary>
        public double branches;
        /// <summary>
        /// Competition for space (Eq. 4.22).
        /// </summary>
        public double competition;
        /// <summary>
        /// Branches that cross without room, 0 where none does.
        /// </summary>
        public double crossings;
        /// <summary>
        /// Ω, seen from the template.
        /// </summary>
        public double omega;
    }

    /// <summary>
    /// The posterior after a step.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_trace_row
    {
        /// <summary>
        /// The step.
        /// </summary>
        public uint step; // tree_sketch_step
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// The posterior after it.
        /// </summary>
        public tree_sketch_posterior posterior;
    }

    /// <summary>
    /// The factor of one segment, part by part, as logarithms.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_factor_row
    {
        /// <summary>
        /// The segment.
        /// </summary>
        public uint segment;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// ln p(s | Ω).
        /// </summary>
        public double scale;
        /// <summary>
        /// ln p(α | Ω) or ln p(β | Ω).
        /// </summary>
        public double divergence;
        /// <summary>
        /// ln p(γ | Ω); 0 where there is no roll.
        /// </summary>
        public double roll;
        /// <summary>
        /// What the factors along strokes add.
        /// </summary>
        public double stroke;
        /// <summary>
        /// Competition and crossings that change with this segment's depth.
        /// </summary>
        public double shared;
    }

    /// <summary>
    /// A view of what was inferred.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_inferred_columns
    {
        /// <summary>
        /// `sizeof(tree_inferred_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of segments; `tree_inferred_branches` has their points and labels.
        /// </summary>
        public UIntPtr n_segments;
        /// <summary>
        /// Where the nodes of each segment begin in `nodes`, and at last their number: `n_segments + 1` values.
        /// </summary>
        public uint* node_starts;
        /// <summary>
        /// The plan's nodes that the points of each segment are, in their order; for an imagined root the base alone.
        /// </summary>
        public uint* nodes;
        /// <summary>
        /// Number of nodes in `nodes`.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// The posterior after each step. It never falls.
        /// </summary>
        public tree_sketch_trace_row* trace;
        /// <summary>
        /// Number of steps.
        /// </summary>
        public UIntPtr n_trace;
        /// <summary>
        /// The factor of each segment but the root.
        /// </summary>
        public tree_sketch_factor_row* factors;
        /// <summary>
        /// Number of factors.
        /// </summary>
        public UIntPtr n_factors;
        /// <summary>
        /// The posterior.
        /// </summary>
        public tree_sketch_posterior posterior;
        /// <summary>
        /// Crossings in the drawing of branches that could not be given room.
        /// </summary>
        public uint n_interpenetrations;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How middle lines are found. Begin with `tree_midline_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_midline_params
    {
        /// <summary>
        /// `sizeof(tree_midline_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Side lines shorter than this share of the area's width where they leave are no branches, 0 to 10. Default 1.
        /// </summary>
        public float spur;
        /// <summary>
        /// What lies inside. Default `TREE_FILL_NON_ZERO`.
        /// </summary>
        public uint rule; // tree_fill_rule
    }

    /// <summary>
    /// How a segment lies to its parent.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_relation
    {
        /// <summary>
        /// The segment.
        /// </summary>
        public uint segment;
        /// <summary>
        /// Its label.
        /// </summary>
        public uint label; // tree_sketch_label
        /// <summary>
        /// Gravelius order of its parent's axis: the order whose habit it follows.
        /// </summary>
        public uint order;
        /// <summary>
        /// 1 where `roll` counts: not for apical segments, nor for the first lateral of an axis.
        /// </summary>
        public uint has_roll;
        /// <summary>
        /// Natural logarithm of its length over its parent's.
        /// </summary>
        public double scale;
        /// <summary>
        /// Angle to its parent in radians: α of an apical segment, β of a lateral.
        /// </summary>
        public double divergence;
        /// <summary>
        /// For a lateral, the turn about the axis from the last lateral's side, less what its place in the fork's whorl
        /// gives, -π to π. 0 where there is none.
        /// </summary>
        public double roll;
    }

    /// <summary>
    /// The columns of a plan: as input, or as a view of a `tree_plan`. Set `struct_size` first.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_plan_columns
    {
        /// <summary>
        /// `sizeof(tree_plan_columns)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Number of nodes, at least 1. Node 0 is the base.
        /// </summary>
        public UIntPtr n_nodes;
        /// <summary>
        /// Two floats for each node, in metres: x to the right, y up, the base at the origin.
        /// </summary>
        public float* positions;
        /// <summary>
        /// Parent of each node, which comes before it; `TREE_NO_PARENT` for node 0.
        /// </summary>
        public uint* parents;
        /// <summary>
        /// The drawing's stroke that each node lies on. Where two meet, the node belongs to the one that bears the
        /// other.
        /// </summary>
        public uint* strokes;
        /// <summary>
        /// Where the base is in the drawing.
        /// </summary>
        public fixed float @base[2];
        /// <summary>
        /// Metres for one unit of the drawing, above 0.
        /// </summary>
        public float scale;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// One thing that was done to one stroke of a drawing. Fields that its kind does not name are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_clean_repair
    {
        /// <summary>
        /// Index of the stroke in the drawing.
        /// </summary>
        public uint stroke;
        /// <summary>
        /// What was done. New ones may be added.
        /// </summary>
        public uint kind; // tree_repair_kind
        /// <summary>
        /// Index of another stroke.
        /// </summary>
        public uint other;
        /// <summary>
        /// A number of points.
        /// </summary>
        public uint count;
        /// <summary>
        /// What it was taken to show.
        /// </summary>
        public uint role; // tree_role
        /// <summary>
        /// A length, as a share of the drawing's height.
        /// </summary>
        public float share;
    }

    /// <summary>
    /// How a sketch is filled up with branches. Begin with `tree_sketch_propagate_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_propagate_params
    {
        /// <summary>
        /// `sizeof(tree_sketch_propagate_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Generations of new segments where no crown is drawn, 0 (none) to 32. Default 5, as in the thesis.
        /// </summary>
        public uint generations;
        /// <summary>
        /// Most generations where a crown is drawn: its surface mostly ends growth before, 0 to 32. Default 7.
        /// </summary>
        public uint generations_in_crown;
        /// <summary>
        /// A sketched segment longer than this many times its natural length gets new laterals, 1 to 1e6. Default 1.5;
        /// 1e6 for none.
        /// </summary>
        public float long_from;
        /// <summary>
        /// Longest natural length of a segment from fork to fork, as a share of the tree's height, 1e-3 to 1. Default
        /// 0.045. Smaller gives more laterals along sketched branches.
        /// </summary>
        public float internode;
        /// <summary>
        /// Segments shorter than this share of the tree's height do not grow, 1e-4 to 1. Default 0.009.
        /// </summary>
        public float shortest;
        /// <summary>
        /// Share of a trunk without drawn branches that stays bare where no crown is drawn, 0 to 1. Default 0.25.
        /// </summary>
        public float bare;
        /// <summary>
        /// Whether a trunk with drawn branches gets new laterals below the first of them too. Default 0.
        /// </summary>
        public uint below_first;
        /// <summary>
        /// Highest Gravelius order of new axes, 0 to 32. Default 8. A palm has 1: its fronds do not branch.
        /// </summary>
        public uint orders;
        /// <summary>
        /// Most segments, sketched and new, 1 to 100 million. Default 20,000. The last generation is thinned evenly where
        /// there would be more.
        /// </summary>
        public uint max_segments;
        /// <summary>
        /// How far each new segment turns down: so many times straight down is added to its direction, -1 to 1. Negative
        /// turns up. Default 0.
        /// </summary>
        public float gravitropism;
        /// <summary>
        /// Random deviation of angles from those of the block, in radians, 0 to π. Default 0.12.
        /// </summary>
        public float jitter;
        /// <summary>
        /// Distance in metres that new segments keep from obstacles, 0 to 1e6. Default 0.1.
        /// </summary>
        public float clearance;
    }

    /// <summary>
    /// What propagation did. Numbers count segments unless they say otherwise.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_propagate_report
    {
        /// <summary>
        /// `sizeof(tree_sketch_propagate_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// New ones.
        /// </summary>
        public ulong n_new;
        /// <summary>
        /// Sketched ones so long that they got new laterals.
        /// </summary>
        public ulong n_long;
        /// <summary>
        /// New forks along those.
        /// </summary>
        public ulong n_forks;
        /// <summary>
        /// Open ends and forks of the sketch that lie outside the crown, where nothing grew.
        /// </summary>
        public ulong n_ends_outside;
        /// <summary>
        /// Those that end at the crown's surface.
        /// </summary>
        public ulong n_touched;
        /// <summary>
        /// Left out because the surface left too little of them.
        /// </summary>
        public ulong n_outside;
        /// <summary>
        /// Left out because they would have been shorter than `shortest`.
        /// </summary>
        public ulong n_too_short;
        /// <summary>
        /// Turned aside from an obstacle or the ground.
        /// </summary>
        public ulong n_turned_aside;
        /// <summary>
        /// Shortened because of an obstacle or the ground.
        /// </summary>
        public ulong n_shortened;
        /// <summary>
        /// Left out because of an obstacle or the ground.
        /// </summary>
        public ulong n_blocked;
        /// <summary>
        /// Left out because there would have been more than `max_segments`.
        /// </summary>
        public ulong n_over_cap;
        /// <summary>
        /// The last generation in which any grew.
        /// </summary>
        public uint generations;
        /// <summary>
        /// Replication blocks taken from the sketch.
        /// </summary>
        public uint n_blocks;
        /// <summary>
        /// Replication blocks drawn from Ω because the sketch has few of their order.
        /// </summary>
        public uint n_blocks_from_omega;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// How much the parts of the comparison weigh. Begin with `tree_select_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_select_params
    {
        /// <summary>
        /// `sizeof(tree_select_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Weight of the crown's footprint, 0 to 1000. Default 40.
        /// </summary>
        public float crown;
        /// <summary>
        /// Weight of the branches' footprint, 0 to 1000. Default 40.
        /// </summary>
        public float branches;
        /// <summary>
        /// Weight of the branching shape, 0 to 1000. Default 1.
        /// </summary>
        public float shape;
        /// <summary>
        /// Weight of the directions of branches, 0 to 1000. Default 15.
        /// </summary>
        public float directions;
        /// <summary>
        /// Added to every deviation of the branching shape, 0.001 to 10: what the hand adds. Default 0.3.
        /// </summary>
        public float hand;
        /// <summary>
        /// What one of the branching shape's three parts can take away at most, 0 to 1000. Default 2.
        /// </summary>
        public float most;
    }

    /// <summary>
    /// A template, and how well it suits a drawing.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_choice
    {
        /// <summary>
        /// Index of the template.
        /// </summary>
        public uint index;
        /// <summary>
        /// Where the eye stands round the template in the view that suits best, in radians, 0 to 2π.
        /// </summary>
        public float yaw;
        /// <summary>
        /// 0 for a perfect match, else below: the sum of the four parts.
        /// </summary>
        public float score;
        /// <summary>
        /// The crown's part, weighted; 0 where no crown is drawn.
        /// </summary>
        public float crown;
        /// <summary>
        /// The part of the branches' footprint, weighted.
        /// </summary>
        public float branches;
        /// <summary>
        /// The branching shape's part, weighted.
        /// </summary>
        public float shape;
        /// <summary>
        /// The directions' part, weighted.
        /// </summary>
        public float directions;
    }

    /// <summary>
    /// All parameters of the way from a drawing to a tree. A part that is NULL, as all are after
    /// `tree_sketch_params_init`, is its default.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_params
    {
        /// <summary>
        /// `sizeof(tree_sketch_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Name of the template. Empty, the default: the one that suits the drawing best.
        /// </summary>
        public tree_str template_name;
        /// <summary>
        /// Species whose twigs and leaves the tree bears: one of the names that `tree_foliage_species_name` gives. Empty,
        /// the default: the template's.
        /// </summary>
        public tree_str species;
        /// <summary>
        /// How strokes are cleaned and joined. Its `height` is not used here.
        /// </summary>
        public tree_clean_params* clean;
        /// <summary>
        /// How the crown is closed.
        /// </summary>
        public tree_crown_params* crown;
        /// <summary>
        /// How templates are compared with the drawing.
        /// </summary>
        public tree_select_params* select;
        /// <summary>
        /// How depths are inferred. Its `slenderness` is not used here.
        /// </summary>
        public tree_sketch_infer_params* infer;
        /// <summary>
        /// How branches are propagated.
        /// </summary>
        public tree_sketch_propagate_params* propagate;
        /// <summary>
        /// How branches become a tree. Its `species` is not used here, its `slenderness` counts relative to the default:
        /// the template has its own.
        /// </summary>
        public tree_sketch_finish_params* finish;
        /// <summary>
        /// Height of the drawing, branches and crown, in metres, 0.01 to 1000. 0, the default: the template's.
        /// </summary>
        public float height;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// What became of a drawing on the way to a tree. Numbers of propagation count segments unless they say otherwise.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_sketch_report
    {
        /// <summary>
        /// `sizeof(tree_sketch_report)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Repairs of strokes.
        /// </summary>
        public ulong n_stroke_repairs;
        /// <summary>
        /// Repairs of the crown; 0 where none is drawn.
        /// </summary>
        public ulong n_crown_repairs;
        /// <summary>
        /// The posterior's logarithm.
        /// </summary>
        public double posterior;
        /// <summary>
        /// New segments of propagation.
        /// </summary>
        public ulong grown_new;
        /// <summary>
        /// Sketched ones so long that they got new laterals.
        /// </summary>
        public ulong grown_long;
        /// <summary>
        /// New forks along those.
        /// </summary>
        public ulong grown_forks;
        /// <summary>
        /// Open ends and forks of the sketch that lie outside the crown, where nothing grew.
        /// </summary>
        public ulong grown_ends_outside;
        /// <summary>
        /// Those that end at the crown's surface.
        /// </summary>
        public ulong grown_touched;
        /// <summary>
        /// Left out because the surface left too little of them.
        /// </summary>
        public ulong grown_outside;
        /// <summary>
        /// Left out because they would have been too short.
        /// </summary>
        public ulong grown_too_short;
        /// <summary>
        /// Turned aside from an obstacle or the ground.
        /// </summary>
        public ulong grown_turned_aside;
        /// <summary>
        /// Shortened because of an obstacle or the ground.
        /// </summary>
        public ulong grown_shortened;
        /// <summary>
        /// Left out because of an obstacle or the ground.
        /// </summary>
        public ulong grown_blocked;
        /// <summary>
        /// Left out because there would have been too many.
        /// </summary>
        public ulong grown_over_cap;
        /// <summary>
        /// Nodes of branches.
        /// </summary>
        public ulong finish_wood_nodes;
        /// <summary>
        /// Nodes of twigs.
        /// </summary>
        public ulong finish_twig_nodes;
        /// <summary>
        /// Nodes of twigs cut off because they left the crown or entered the ground.
        /// </summary>
        public ulong finish_twig_nodes_cut;
        /// <summary>
        /// Blades that stayed: rows of the foliage.
        /// </summary>
        public ulong finish_leaves;
        /// <summary>
        /// Blades left out because they left the crown or entered the ground.
        /// </summary>
        public ulong finish_leaves_outside;
        /// <summary>
        /// How much larger leaves are than the species', because there would be too many; a factor.
        /// </summary>
        public float finish_leaves_larger;
        /// <summary>
        /// How well the template suits the drawing, 0 for a perfect match, else below; 0 where it was taken by name or kept
        /// through an edit.
        /// </summary>
        public float score;
        /// <summary>
        /// 1 where `score` counts.
        /// </summary>
        public uint has_score;
        /// <summary>
        /// 1 where a crown is drawn, and the fields of the crown count.
        /// </summary>
        public uint has_crown;
        /// <summary>
        /// Share of branch points outside the drawn crown, 0 to 1.
        /// </summary>
        public float crown_outside;
        /// <summary>
        /// Segments that were drawn, from fork to fork.
        /// </summary>
        public uint n_segments;
        /// <summary>
        /// Crossings of branches in the drawing that could not be given room.
        /// </summary>
        public uint n_interpenetrations;
        /// <summary>
        /// The last generation of propagation in which any grew.
        /// </summary>
        public uint grown_generations;
        /// <summary>
        /// Replication blocks taken from the sketch.
        /// </summary>
        public uint grown_blocks;
        /// <summary>
        /// Replication blocks drawn from Ω because the sketch has few of their order.
        /// </summary>
        public uint grown_blocks_from_omega;
    }

    /// <summary>
    /// How a template is measured. Begin with `tree_template_params_init`.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_template_params
    {
        /// <summary>
        /// `sizeof(tree_template_params)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Which branches are main ones; NULL for the default.
        /// </summary>
        public tree_main_branches* main;
        /// <summary>
        /// Views over half a turn, 1 to 180. Default 8, so with mirror images one every 22.5°.
        /// </summary>
        public uint views;
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
    }

    /// <summary>
    /// A template.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_template_view
    {
        /// <summary>
        /// `sizeof(tree_template_view)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// What it is called.
        /// </summary>
        public tree_str name;
        /// <summary>
        /// The species whose leaves it bears, as `tree_finish_params_find` takes it where it is built in.
        /// </summary>
        public tree_str species;
        /// <summary>
        /// Height of the exemplar in metres: what a drawing is scaled to unless its height is given.
        /// </summary>
        public float height;
        /// <summary>
        /// Radius of the trunk's base over the height, 0 to 1.
        /// </summary>
        public float slenderness;
        /// <summary>
        /// Number of orders of axes that have parameters of their own.
        /// </summary>
        public UIntPtr n_orders;
        /// <summary>
        /// Number of views; see `tree_templates_side`.
        /// </summary>
        public UIntPtr n_views;
    }

    /// <summary>
    /// What a template looks like from one side.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_template_side
    {
        /// <summary>
        /// `sizeof(tree_template_side)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Where the eye stands round the trunk, in radians, 0 to 2π: 0 on +Z, a quarter turn on +X.
        /// </summary>
        public float yaw;
        /// <summary>
        /// Mean and standard deviation of the natural logarithm of a segment's length over that of the one below. NaN where
        /// there are no forks.
        /// </summary>
        public fixed float scale[2];
        /// <summary>
        /// The same of the angle in radians at which the branch that bends least leaves the segment below.
        /// </summary>
        public fixed float alpha[2];
        /// <summary>
        /// The same of all other branches.
        /// </summary>
        public fixed float beta[2];
        /// <summary>
        /// 0.
        /// </summary>
        public uint reserved;
        /// <summary>
        /// `TREE_DIRECTION_BINS` shares of the branches' length: what goes straight up comes first, straight down last.
        /// </summary>
        public float* directions;
        /// <summary>
        /// Footprint of crown and branches without the root branch: `TREE_FOOTPRINT_DIRECTIONS` distances.
        /// </summary>
        public float* crown;
        /// <summary>
        /// Footprint of the branches alone, as many.
        /// </summary>
        public float* branches;
        /// <summary>
        /// Number of points of the silhouette.
        /// </summary>
        public UIntPtr n_silhouette;
        /// <summary>
        /// Outline of the crown, two floats for each point, in metres, y up, the tree's base at the origin of y.
        /// </summary>
        public float* silhouette;
    }

    /// <summary>
    /// A view of what a volume is made of. What its kind does not use is 0 or NULL.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct tree_solid
    {
        /// <summary>
        /// `sizeof(tree_solid)`.
        /// </summary>
        public UIntPtr struct_size;
        /// <summary>
        /// Columns of points: a profile's distance and height, two floats each; a mesh's positions, three
        /// floats each.
        /// </summary>
        public float* points;
        /// <summary>
        /// Number of points.
        /// </summary>
        public UIntPtr n_points;
        /// <summary>
        /// Three for each triangle of a mesh.
        /// </summary>
        public uint* indices;
        /// <summary>
        /// Number of triangles.
        /// </summary>
        public UIntPtr n_triangles;
        /// <summary>
        /// Number of parts of a combination: 2 for a difference, 1 for a transformed volume. See
        /// `tree_volume_part`.
        /// </summary>
        public UIntPtr n_parts;
        /// <summary>
        /// Which solid it is.
        /// </summary>
        public uint kind; // tree_solid_kind
        /// <summary>
        /// Centre, base, start, lower corner, point on the plane or apex.
        /// </summary>
        public fixed float a[3];
        /// <summary>
        /// Top, end, upper corner, radii of an ellipsoid, normal, or the axis of a sector or revolution.
        /// </summary>
        public fixed float b[3];
        /// <summary>
        /// Radius; that at the base of a frustum.
        /// </summary>
        public float radius;
        /// <summary>
        /// Radius at the top of a frustum.
        /// </summary>
        public float top_radius;
        /// <summary>
        /// Angle of a sector, in radians.
        /// </summary>
        public float angle;
        /// <summary>
        /// Map of a transformed volume, column by column as for `tree_volume_transformed`.
        /// </summary>
        public fixed float columns[12];
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

        /// <summary>
        /// A first tree, by the names of the functions: `tree_path_preset` fills in parameters, `tree_path_grow` makes
        /// a `tree_tree` of them, `tree_mesh_build` a `tree_mesh` of that, `tree_mesh_surface` shows its columns, which
        /// an engine uploads; `tree_mesh_write_glb` writes a file. `tree_mesh_free` and `tree_tree_free` at the end.
        /// `examples/c/oak.c` does this.
        ///
        /// From a sketch: `tree_drawing_new`, `tree_drawing_from_svg` or `tree_drawing_from_json` takes its strokes;
        /// `tree_drawing_clean` joins them to a `tree_plan` and tells what it repaired; `tree_crown_close` makes a solid of
        /// its crown; `tree_templates_select` says which kind of tree it looks like. `tree_sketch_infer` finds
        /// depths, `tree_sketch_branches_propagate` what was left out, `tree_sketch_branches_wood` and `tree_sketch_grow_crown`
        /// make the tree. A `tree_sketch_session` does all that and lets strokes and depths be changed; `tree_from_sketch` does
        /// it in one call.
        ///
        /// From outlines: `tree_outline_drawing_from_svg`, `tree_outline_drawing_of_matte` or `tree_outline_drawing_of_photo` reads what was
        /// drawn, `tree_outline_close` closes a stroke. Step by step, `tree_outline_bumps`, `tree_branch_infer` and `tree_outline_sub`
        /// find branches and their parts of the outline, `tree_arranged_new` and `tree_revolved_of` their places and lengths round the
        /// parent; `tree_leaf_outline_model` makes a drawn leaf one that a look takes.
        ///
        /// From grammars: `tree_lsystem_preset`, `tree_grammar_from_text` or `tree_grammar_read` gives a grammar,
        /// `tree_lsystem_grow` a tree of it. Step by step, `tree_grammar_derive` makes a `tree_word`, `tree_grammar_interpretation` what
        /// a turtle sees of it, `tree_word_interpret` a tree, `tree_word_lines` lines; `tree_tree_to_word` writes any tree as a word.
        ///
        /// Level of detail: `tree_elements_of_mesh` divides the foliage of a mesh, `tree_order_coverage` puts it in the
        /// order in which it is drawn, `tree_lod_table_measure` finds how large the rest must grow. `tree_tiers_of_mesh`
        /// makes outlines simpler, `tree_lod_plan` says when; `tree_pruned_new` makes a `tree_pruned` of it all,
        /// `tree_pruned_make` in one call. `tree_pruned_mesh` is uploaded once, `tree_pruned_level` says which window of it
        /// is drawn, with `tree_prune_shader`. A `tree_scene` of such models, `tree_pruned_scene_levels`, says in each
        /// frame what is drawn of which tree: `tree_scene_state_select`, then `tree_scene_state_draws` into your own
        /// buffers.
        ///
        /// Levels as prefixes: `tree_multires_new` sorts a tree such that a level is a prefix of its columns, `tree_multires_level`.
        /// `tree_multires_to_stream` makes bytes of which every prefix is a coarser tree; a `tree_stream_reader` takes them as they
        /// arrive. `tree_multi_mesh_new` draws it, `tree_multi_mesh_draws` says how much of each index buffer a level draws, and
        /// `tree_grow_shader` lets branches grow in. Chains of modules, with brackets: `tree_adt_of_tokens`, `tree_multi_paths_new`,
        /// `tree_multi_chain_new`.
        /// Impostors: `tree_leaf_bearers_of_tree` says which branch carries each leaf (elements of `TREE_GRAIN_LEAF`),
        /// `tree_leaf_boxes_along` finds boxes along the branches, `tree_cards_bake` pictures of their leaves.
        /// `tree_cards_pixels` and `tree_cards_mesh` are uploaded; in each frame `tree_card_choice_update` says which boxes,
        /// and which leaves, are drawn, with `tree_cards_shader`. From afar a whole tree is a `tree_octahedral_bake`.
        ///
        /// All distances: `tree_hybrid_make` puts a tree's wood with levels and its leaves with cards into one model. `tree_hybrid_mesh`
        /// is uploaded; in each frame `tree_hybrid_choice_update` says how much of the wood, which boxes and which leaves are drawn.
        /// `tree_hybrid_write_glb_levels` writes it for programs without shaders of ours.
        ///
        /// * Status. Functions that can fail return a `tree_status`, `TREE_OK` or a code. What was wrong,
        /// where, and what would be right is in `tree_error_text`, thread by thread. Nothing unwinds into the
        /// caller: a defect is `TREE_ERROR_PANIC`. Only memory that the system refuses ends the process; a budget
        /// (`tree_memory_set_budget`) comes before that.
        /// * Handles (`tree_mesh *` and so on) are made by the library, never change after that, may be read
        /// by any number of threads at once, and end by their `_free`, which accepts NULL. A handle that was
        /// freed, or is of another kind, is `TREE_ERROR_HANDLE` (unless its address has been given to a new object of
        /// its kind). Handles keep alive what they are made of. Some kinds change, `tree_photo_session`,
        /// `tree_sketch_session`, `tree_silhouette`, `tree_scene`, `tree_scene_state`, `tree_card_choice`,
        /// `tree_hybrid_choice` and `tree_stream_reader`: one thread at a time.
        /// * Out parameters come last. A handle's place is set to NULL first, so after an error it is NULL; what
        /// stood there before is not freed.
        /// * Views (`tree_surface` and so on) point into the object they were asked of: tightly packed,
        /// nothing copied, valid until that object is freed. A column without rows is NULL.
        /// * Structs of parameters and views begin with `struct_size`. Parameters: call `tree_X_init(&amp;x,
        /// sizeof x)`, which fills in the defaults, and change what should differ; NULL instead of parameters
        /// means the defaults. Views and reports: set `struct_size` to `sizeof x`; NULL where a report is not
        /// wanted. So programs built with an older header go on with a newer library. Fields named `reserved`
        /// are 0.
        /// * Texts are UTF-8, a pointer and a number of bytes; `TREE_NUL_TERMINATED` as number for C strings.
        /// * Constants of one kind share a `typedef` and a prefix. A number that is none of them is
        /// `TREE_ERROR_ENUM`. A yes or no is a `uint32_t`, 0 is no and anything else yes.
        /// * Control (`tree_control`) is taken by all that can run long: progress, cancellation, limits,
        /// threads. NULL means: no progress, no cancellation, default limits, all cores.
        /// * Axes: right-handed, +Y up, metres, radians, triangles counter-clockwise from outside, texture v
        /// downwards, quaternions as x, y, z, w; `tree_convention` lists others.
        /// * What cannot be caught is yours to keep: arrays as long as their count says, structs as long as their
        /// `struct_size` says, no view used after its object, nothing freed in one thread while another uses it, no
        /// exception thrown out of a callback.
        /// </summary>
        public static readonly UIntPtr TREE_NUL_TERMINATED = (UIntPtr)(UIntPtr.Size == 8 ? ulong.MaxValue : uint.MaxValue);

        /// <summary>
        /// Exponent of the pipe model by Leonardo da Vinci: the cross-sections above a fork together are the
        /// cross-section below.
        /// </summary>
        public const float TREE_PIPE_DA_VINCI = 2.0f;

        /// <summary>
        /// Exponent of the pipe model by Murray (1927), who measured circumferences against the weight they
        /// carry.
        /// </summary>
        public const float TREE_PIPE_MURRAY = 2.49f;

        /// <summary>
        /// Exponent of the pipe model by Mandelbrot (1983), 8/3.
        /// </summary>
        public const float TREE_PIPE_MANDELBROT = 2.6666667f;

        /// <summary>
        /// The pipe model, for most trees: at every fork the powers of the radii above add up to that below
        /// (da Vinci, Murray, Mandelbrot).
        /// </summary>
        public const int TREE_RADII_PIPE = 0;

        /// <summary>
        /// The further from the tip, the thicker; the higher the order of the axis, the thinner (Xu &amp; Mould).
        /// </summary>
        public const int TREE_RADII_TIP_DISTANCE = 1;

        /// <summary>
        /// By counting strands that run from the base to the tips (Holton).
        /// </summary>
        public const int TREE_RADII_STRANDS = 2;

        /// <summary>
        /// One strand for each tip, which makes the rule da Vinci's.
        /// </summary>
        public const int TREE_STRANDS_PER_TIP = 0;

        /// <summary>
        /// A number at the base, shared out at forks: the less a branch turns away, the more it gets.
        /// </summary>
        public const int TREE_STRANDS_BY_ANGLE = 1;

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
        /// A number, in a parameter or in a column, lies outside its range or is not finite.
        /// </summary>
        public const int TREE_ERROR_PARAMETER = 6;

        /// <summary>
        /// Columns do not fit together: lengths, orders, indices that name nothing.
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
        /// Ours: glTF, also Bevy and three.js.
        /// </summary>
        public const int TREE_CONVENTION_GLTF = 0;

        /// <summary>
        /// Godot 4.
        /// </summary>
        public const int TREE_CONVENTION_GODOT = 1;

        /// <summary>
        /// Unity.
        /// </summary>
        public const int TREE_CONVENTION_UNITY = 2;

        /// <summary>
        /// Unreal Engine.
        /// </summary>
        public const int TREE_CONVENTION_UNREAL = 3;

        /// <summary>
        /// Blender.
        /// </summary>
        public const int TREE_CONVENTION_BLENDER = 4;

        /// <summary>
        /// From our axes to theirs.
        /// </summary>
        public const int TREE_CONVERT_TO = 0;

        /// <summary>
        /// From their axes back to ours.
        /// </summary>
        public const int TREE_CONVERT_BACK = 1;

        /// <summary>
        /// Unity's SpeedTree 8 shader: one branch, and leaves.
        ///
        /// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
        /// times, blend (1); UV0 4 f32: u, v, branch weight, branch direction; UV1 4 f32: light map u, v, anchor
        /// x, y; UV2 4 f32: the vertex's place in the next level of detail (itself), anchor z; UV3 4 f32: leaf
        /// scale, growth, ripple, kind (0 wood, 2 leaf).
        /// </summary>
        public const int TREE_LAYOUT_SPEEDTREE8 = 0;

        /// <summary>
        /// Unity's SpeedTree 9 shader: two branches, and leaves. `stretch_limits` of the view belong into
        /// `_ST_BranchStretchLimits`.
        ///
        /// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
        /// times, blend (1); UV0 4 f32: u, v, noise and direction of branch 1; UV1 4 f32: light map u, v, weight
        /// of branch 1, ripple weight; UV2 4 f32: noise, direction and weight of branch 2, 0; UV3 4 f32: anchor
        /// x, y, z, 0.
        /// </summary>
        public const int TREE_LAYOUT_SPEEDTREE9 = 1;

        /// <summary>
        /// Unity's Tree Creator shaders, and most vegetation shaders: bend weights and a phase.
        ///
        /// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: branch phase,
        /// edge flutter, 0, occlusion; UV0 2 f32: u, v; UV1 2 f32: primary and secondary bend.
        /// </summary>
        public const int TREE_LAYOUT_TREE_CREATOR = 2;

        /// <summary>
        /// Unreal's Pivot Painter 2: the hierarchy, at most 4 levels, in two textures that
        /// `tree_packed_pivots` views.
        ///
        /// POSITION 3 f32, centimetres in Unreal's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion,
        /// flutter, leaf phase, 1; UV0 2 f32: u, v; UV1 2 f32: light map u, v; UV2 2 f32: texel of the element.
        /// </summary>
        public const int TREE_LAYOUT_PIVOT_PAINTER = 3;

        /// <summary>
        /// Godot 4, `CUSTOM0` to `CUSTOM3` as floats: the own branch in full, and the parent's part.
        ///
        /// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three times, 1; UV 2
        /// f32: u, v; UV2 2 f32: light map u, v; CUSTOM0 4: pivot x, y, z, reach; CUSTOM1 4: axis x, y, z, phase;
        /// CUSTOM2 4: stiffness, level, flutter, leaf phase; CUSTOM3 4: parent's pivot x, y, z, reach of the
        /// pivot on the parent.
        /// </summary>
        public const int TREE_LAYOUT_GODOT = 4;

        /// <summary>
        /// As `TREE_LAYOUT_GODOT`, with `CUSTOM0` to `CUSTOM3` as halves: 32 bytes a vertex instead of 64. Pivots
        /// are rounded to 4 mm at 8 m, 8 mm at 16 m.
        /// </summary>
        public const int TREE_LAYOUT_GODOT_HALF = 5;

        /// <summary>
        /// glTF attributes `_WIND*`: all of it. `tree_mesh_gltf_wind` gives them for files.
        ///
        /// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; `COLOR_0` 4 unorm8: occlusion three times, 1;
        /// `TEXCOORD_0` 2 f32; `TEXCOORD_1` 2 f32; `_WIND_PIVOT` 3 f32; `_WIND_AXIS` 3 f32; `_WIND` 4 f32:
        /// reach, phase, stiffness, length in metres; `_WIND_LEAF` 4 f32: flutter, leaf phase, level, 1 for
        /// leaves; `_WIND_ANCHOR` 3 f32; `_WIND_BRANCH` 4 u16: branch low, high, parent low, high.
        /// </summary>
        public const int TREE_LAYOUT_GLTF_WIND = 6;

        /// <summary>
        /// Own renderers: 32 bytes a vertex, quantised, in our axes; `tree_packed_vertices` views them. There are
        /// no streams.
        /// </summary>
        public const int TREE_LAYOUT_VERTEX = 7;

        /// <summary>
        /// 32-bit floats.
        /// </summary>
        public const int TREE_NUMBER_F32 = 0;

        /// <summary>
        /// 16-bit floats.
        /// </summary>
        public const int TREE_NUMBER_F16 = 1;

        /// <summary>
        /// Whole numbers of 16 bits, without sign.
        /// </summary>
        public const int TREE_NUMBER_U16 = 2;

        /// <summary>
        /// Bytes that stand for 0 to 1.
        /// </summary>
        public const int TREE_NUMBER_UNORM8 = 3;

        /// <summary>
        /// Element of a branch that has none.
        /// </summary>
        public const uint TREE_NO_ELEMENT = 4294967295;

        /// <summary>
        /// One at a node, each turned by the same angle from the last. Oak, poplar.
        /// </summary>
        public const int TREE_PHYLLOTAXIS_SPIRAL = 0;

        /// <summary>
        /// One at a node, in two rows. Beech, elm, linden.
        /// </summary>
        public const int TREE_PHYLLOTAXIS_DISTICHOUS = 1;

        /// <summary>
        /// Two at a node, all pairs in one plane.
        /// </summary>
        public const int TREE_PHYLLOTAXIS_OPPOSITE = 2;

        /// <summary>
        /// Two at a node, each pair across the last. Maple, ash.
        /// </summary>
        public const int TREE_PHYLLOTAXIS_DECUSSATE = 3;

        /// <summary>
        /// Three or more at a node, each whorl in the gaps of the last.
        /// </summary>
        public const int TREE_PHYLLOTAXIS_WHORLED = 4;

        /// <summary>
        /// Densities above this count as this.
        /// </summary>
        public const float TREE_DENSITY_CAP = 4.0f;

        /// <summary>
        /// One blade. Oak, beech, linden.
        /// </summary>
        public const int TREE_LEAVES_SIMPLE = 0;

        /// <summary>
        /// Leaflets along a rachis. Ash, walnut, rowan; palms with feathers.
        /// </summary>
        public const int TREE_LEAVES_PINNATE = 1;

        /// <summary>
        /// Leaflets from one point, like fingers. Horse chestnut; palms with fans.
        /// </summary>
        public const int TREE_LEAVES_PALMATE = 2;

        /// <summary>
        /// A few needles from one sheath, evenly round its axis. Pines.
        /// </summary>
        public const int TREE_LEAVES_FASCICLE = 3;

        /// <summary>
        /// Many needles on a short shoot, from its axis to all sides. Larch, cedar.
        /// </summary>
        public const int TREE_LEAVES_ROSETTE = 4;

        /// <summary>
        /// One main axis, with laterals. Spruce, oak.
        /// </summary>
        public const int TREE_BRANCHING_MONOPODIAL = 0;

        /// <summary>
        /// A chain of modules: each ends, and its topmost lateral takes over. Linden, elm, beech.
        /// </summary>
        public const int TREE_BRANCHING_SYMPODIAL = 1;

        /// <summary>
        /// Parent of the box of the whole tree: no box.
        /// </summary>
        public const uint TREE_NO_BOX = 4294967295;

        /// <summary>
        /// sRGB colour of the surface without light, and alpha: the covered share of each texel.
        /// </summary>
        public const int TREE_IMPOSTOR_COLOR = 0;

        /// <summary>
        /// Normal in the space of the tree, -1 to 1 as 0 to 255, and in alpha the depth. These are numbers, not colours: upload
        /// them without sRGB.
        /// </summary>
        public const int TREE_IMPOSTOR_DETAIL = 1;

        /// <summary>
        /// Planes of a box.
        /// </summary>
        public const int TREE_CARD_PLANES = 6;

        /// <summary>
        /// As the attribute `_OCCLUSION`, which only shaders that know it use.
        /// </summary>
        public const int TREE_GLTF_OCCLUSION_ATTRIBUTE = 0;

        /// <summary>
        /// As grey vertex colours (`COLOR_0`, 8 bits), which every program multiplies with the base colour:
        /// visible everywhere, but direct light is darkened too.
        /// </summary>
        public const int TREE_GLTF_OCCLUSION_COLOR = 1;

        /// <summary>
        /// Not at all.
        /// </summary>
        public const int TREE_GLTF_OCCLUSION_OMIT = 2;

        /// <summary>
        /// Primitives, elements or lines that are points or lines, left out.
        /// </summary>
        public const int TREE_NOTE_POINTS_OR_LINES = 0;

        /// <summary>
        /// Primitives without positions, left out.
        /// </summary>
        public const int TREE_NOTE_NO_POSITIONS = 1;

        /// <summary>
        /// Corners left over behind the last whole triangle, or faces with fewer than three.
        /// </summary>
        public const int TREE_NOTE_PARTIAL_FACES = 2;

        /// <summary>
        /// Surfaces (OBJ: corners) whose normals were computed because there were none.
        /// </summary>
        public const int TREE_NOTE_NORMALS_COMPUTED = 3;

        /// <summary>
        /// Single normals of no length, computed from the triangles around.
        /// </summary>
        public const int TREE_NOTE_NORMALS_REPAIRED = 4;

        /// <summary>
        /// Surfaces (OBJ: corners) without texture coordinates, which became 0.
        /// </summary>
        public const int TREE_NOTE_UVS_MISSING = 5;

        /// <summary>
        /// Vertex colours, which a surface has no column for. PLY: their mean became the material's.
        /// </summary>
        public const int TREE_NOTE_VERTEX_COLORS = 6;

        /// <summary>
        /// Skins and morph targets; the mesh is as it rests.
        /// </summary>
        public const int TREE_NOTE_DEFORMATIONS = 7;

        /// <summary>
        /// Nodes a scene lists as roots although they are not.
        /// </summary>
        public const int TREE_NOTE_LISTED_TWICE = 8;

        /// <summary>
        /// Materials that blend by alpha, cut at one half instead.
        /// </summary>
        public const int TREE_NOTE_BLEND_AS_MASK = 9;

        /// <summary>
        /// Normal, roughness, occlusion and emission maps, left out.
        /// </summary>
        public const int TREE_NOTE_OTHER_TEXTURES = 10;

        /// <summary>
        /// Colours and factors outside their range, brought back into it.
        /// </summary>
        public const int TREE_NOTE_CLAMPED = 11;

        /// <summary>
        /// Textures and materials in other files, which were not asked for.
        /// </summary>
        public const int TREE_NOTE_EXTERNAL_REFUSED = 12;

        /// <summary>
        /// Textures and materials in files that are not there.
        /// </summary>
        public const int TREE_NOTE_EXTERNAL_MISSING = 13;

        /// <summary>
        /// Textures that could not be decoded.
        /// </summary>
        public const int TREE_NOTE_TEXTURE_UNREADABLE = 14;

        /// <summary>
        /// Textures without a picture in a known format.
        /// </summary>
        public const int TREE_NOTE_TEXTURE_UNSUPPORTED = 15;

        /// <summary>
        /// Materials that faces name and no file defines.
        /// </summary>
        public const int TREE_NOTE_MATERIAL_UNKNOWN = 16;

        /// <summary>
        /// Statements or elements that are not understood, passed over.
        /// </summary>
        public const int TREE_NOTE_UNKNOWN = 17;

        /// <summary>
        /// Number of notes in this version; new ones may be added.
        /// </summary>
        public const int TREE_N_NOTES = 18;

        /// <summary>
        /// As the file's extension says: `glb`, `gltf`, `obj` or `ply`, in letters of any case.
        /// </summary>
        public const int TREE_MESH_FORMAT_BY_NAME = 0;

        /// <summary>
        /// glTF 2.0, as one file (GLB) or as JSON.
        /// </summary>
        public const int TREE_MESH_FORMAT_GLTF = 1;

        /// <summary>
        /// OBJ.
        /// </summary>
        public const int TREE_MESH_FORMAT_OBJ = 2;

        /// <summary>
        /// PLY, text or binary.
        /// </summary>
        public const int TREE_MESH_FORMAT_PLY = 3;

        /// <summary>
        /// Samples of a `tree_lod_distance`.
        /// </summary>
        public const int TREE_LOD_DISTANCE_SAMPLES = 21;

        /// <summary>
        /// A connected piece: a card, a leaflet of a compound leaf, a single leaf. The two sides of a doubled card are
        /// elements of their own.
        /// </summary>
        public const int TREE_GRAIN_BLADE = 0;

        /// <summary>
        /// A triangle, scaled about the centre of its blade: better pictures still, at the price of cut cards that
        /// are seen when one comes near.
        /// </summary>
        public const int TREE_GRAIN_TRIANGLE = 1;

        /// <summary>
        /// A leaf with all its blades, where the mesh tells (its surfaces have anchors), otherwise as
        /// `TREE_GRAIN_BLADE`. Nothing is ever half a leaf.
        /// </summary>
        public const int TREE_GRAIN_LEAF = 2;

        /// <summary>
        /// WGSL.
        /// </summary>
        public const int TREE_SHADER_WGSL = 0;

        /// <summary>
        /// GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
        /// </summary>
        public const int TREE_SHADER_GLSL = 1;

        /// <summary>
        /// HLSL, any shader model.
        /// </summary>
        public const int TREE_SHADER_HLSL = 2;

        /// <summary>
        /// Not at all: every tree counts as seen.
        /// </summary>
        public const int TREE_SCENE_OCCLUSION_NONE = 0;

        /// <summary>
        /// From depths the engine drew.
        /// </summary>
        public const int TREE_SCENE_OCCLUSION_DEPTH = 1;

        /// <summary>
        /// From the models' occluders, drawn by the library; ground and houses hide nothing.
        /// </summary>
        public const int TREE_SCENE_OCCLUSION_BUILT_IN = 2;

        /// <summary>
        /// The best for each lambda (Neubert 2012, eq. 7.6).
        /// </summary>
        public const int TREE_LOD_SCALE_BEST = 0;

        /// <summary>
        /// 1 / lambda (Cook et al. 2007).
        /// </summary>
        public const int TREE_LOD_SCALE_COOK = 1;

        /// <summary>
        /// Always 1: leaves keep their size.
        /// </summary>
        public const int TREE_LOD_SCALE_KEPT = 2;

        /// <summary>
        /// That of the field `fixed`.
        /// </summary>
        public const int TREE_LOD_SCALE_FIXED = 3;

        /// <summary>
        /// A rectangle as large as the picture. Two triangles; the least memory, the most overdraw.
        /// </summary>
        public const int TREE_LEAF_CARD = 0;

        /// <summary>
        /// A polygon of at most `vertices_max` vertices around all of the picture that is not cut away: no visible
        /// pixel is lost, few invisible ones are drawn. A picture without a mask, or all of it cut away, stays a
        /// card; the report says so.
        /// </summary>
        public const int TREE_LEAF_OUTLINE = 1;

        /// <summary>
        /// A leaf whose margin is modelled: a polygon along the margin of the picture, as much inside as outside,
        /// drawn without a mask. For close views and for renderers that pay for masks. Leaves are taken to be
        /// alike left and right. Pictures as above stay cards.
        /// </summary>
        public const int TREE_LEAF_MODELLED = 2;

        /// <summary>
        /// A leaf of your own, shared by all leaves of the kind.
        /// </summary>
        public const int TREE_LEAF_MESH = 3;

        /// <summary>
        /// Alpha is ignored.
        /// </summary>
        public const int TREE_ALPHA_OPAQUE = 0;

        /// <summary>
        /// Pixels with alpha below the material's `alpha_cutoff` are not drawn.
        /// </summary>
        public const int TREE_ALPHA_MASK = 1;

        /// <summary>
        /// Kind of the module `[`, in every alphabet: a branch begins.
        /// </summary>
        public const int TREE_KIND_PUSH = 0;

        /// <summary>
        /// Kind of the module `]`, in every alphabet: a branch ends.
        /// </summary>
        public const int TREE_KIND_POP = 1;

        /// <summary>
        /// As many derivations as the text of the grammar asks for.
        /// </summary>
        public const uint TREE_STEPS_OF_TEXT = 4294967295;

        /// <summary>
        /// None: there is no mistake, or it has no place.
        /// </summary>
        public const int TREE_GRAMMAR_PLACE_NONE = 0;

        /// <summary>
        /// A line and a column of the text.
        /// </summary>
        public const int TREE_GRAMMAR_PLACE_TEXT = 1;

        /// <summary>
        /// A module of the word.
        /// </summary>
        public const int TREE_GRAMMAR_PLACE_MODULE = 2;

        /// <summary>
        /// The width is that of a segment's base; it narrows to the thickest segment that follows. The default.
        /// </summary>
        public const int TREE_TAPER_SMOOTH = 0;

        /// <summary>
        /// The width is that of a segment's upper end, as words of skeletons have it.
        /// </summary>
        public const int TREE_TAPER_ENDS = 1;

        /// <summary>
        /// From the widths of the word where it sets any with `!` or `#`, or else from `radii`. The default.
        /// </summary>
        public const int TREE_THICKNESS_AUTO = 0;

        /// <summary>
        /// From the widths of the word.
        /// </summary>
        public const int TREE_THICKNESS_WORD = 1;

        /// <summary>
        /// From `radii`, whatever the word says.
        /// </summary>
        public const int TREE_THICKNESS_RULE = 2;

        /// <summary>
        /// Straight from node to node.
        /// </summary>
        public const int TREE_CURVE_STRAIGHT = 0;

        /// <summary>
        /// A clamped cubic B-spline through the nodes: what was modelled stays where it is.
        /// </summary>
        public const int TREE_CURVE_THROUGH = 1;

        /// <summary>
        /// A clamped cubic B-spline with the nodes as control points: passes near inner nodes, and calms what
        /// jitters, such as scanned skeletons.
        /// </summary>
        public const int TREE_CURVE_NEAR = 2;

        /// <summary>
        /// As a length.
        /// </summary>
        public const int TREE_BOUND_METRES = 0;

        /// <summary>
        /// As what a camera sees: the nearer it comes, the finer the mesh.
        /// </summary>
        public const int TREE_BOUND_PIXELS = 1;

        /// <summary>
        /// A triangle counts as flat when its area is below this share of the squared diagonal of the box around
        /// the surface: a square with a side of a ten-millionth of the diagonal, and a tenth as high. For a tree of
        /// 10 m that is 1e-13 m².
        /// </summary>
        public const float TREE_FLAT_SHARE = 1e-15f;

        /// <summary>
        /// Any module that is no bracket, with the length that it draws.
        /// </summary>
        public const int TREE_TOKEN_MODULE = 0;

        /// <summary>
        /// `[`: a branch begins.
        /// </summary>
        public const int TREE_TOKEN_PUSH = 1;

        /// <summary>
        /// `]`: it ends.
        /// </summary>
        public const int TREE_TOKEN_POP = 2;

        /// <summary>
        /// A module of the plain chain; its value is its place there.
        /// </summary>
        public const int TREE_ITEM_MODULE = 0;

        /// <summary>
        /// `SAVE`: the turtle keeps its state under this number.
        /// </summary>
        public const int TREE_ITEM_SAVE = 1;

        /// <summary>
        /// `RESTORE`: the turtle goes back to the state of this number, and a level begins.
        /// </summary>
        public const int TREE_ITEM_RESTORE = 2;

        /// <summary>
        /// Length of the branch and of all that it bears; what has been put into a path does not count any more. What the paper
        /// prefers.
        /// </summary>
        public const int TREE_METRIC_BRANCHING_LENGTH = 0;

        /// <summary>
        /// As `TREE_METRIC_BRANCHING_LENGTH`, with worths of your own in the place of lengths: areas of wood, numbers of leaves.
        /// </summary>
        public const int TREE_METRIC_BRANCHING = 1;

        /// <summary>
        /// Number of children.
        /// </summary>
        public const int TREE_METRIC_CHILDREN = 2;

        /// <summary>
        /// Number of descendants.
        /// </summary>
        public const int TREE_METRIC_DESCENDANTS = 3;

        /// <summary>
        /// Longest way to a tip, the branch itself included.
        /// </summary>
        public const int TREE_METRIC_LONGEST_PATH = 4;

        /// <summary>
        /// As derivations are undone: branches of low order first, siblings in the order of the chain. For comparison.
        /// </summary>
        public const int TREE_METRIC_GENERATION = 5;

        /// <summary>
        /// Any branch whose parent is there, by chance. For comparison.
        /// </summary>
        public const int TREE_METRIC_RANDOM = 6;

        /// <summary>
        /// Area of a branch and of what it bears, for each branch that has to be drawn for it. The default.
        /// </summary>
        public const int TREE_METRIC_DENSITY = 7;

        /// <summary>
        /// As `TREE_METRIC_DENSITY`, with worths of your own in the place of areas.
        /// </summary>
        public const int TREE_METRIC_DENSITY_OF = 8;

        /// <summary>
        /// From 0 on a branch to `blend_most` at a distance of `blend_reach` and beyond.
        /// </summary>
        public const int TREE_BLEND_LINEAR = 0;

        /// <summary>
        /// `blend_share` at every distance but 0: particles meet branches at a fixed angle.
        /// </summary>
        public const int TREE_BLEND_CONSTANT = 1;

        /// <summary>
        /// Straight lines between the points of `blend_table`.
        /// </summary>
        public const int TREE_BLEND_TABLE = 2;

        /// <summary>
        /// What `blend_function` says.
        /// </summary>
        public const int TREE_BLEND_FUNCTION = 3;

        /// <summary>
        /// Cameras: base, height and scale of each view.
        /// </summary>
        public const int TREE_PHOTO_STAGE_VIEWS = 0;

        /// <summary>
        /// Main branches in each view.
        /// </summary>
        public const int TREE_PHOTO_STAGE_ATTRACTORS = 1;

        /// <summary>
        /// The density in space, and the way to the base through it.
        /// </summary>
        public const int TREE_PHOTO_STAGE_DENSITY = 2;

        /// <summary>
        /// The direction field of each view.
        /// </summary>
        public const int TREE_PHOTO_STAGE_FIELDS = 3;

        /// <summary>
        /// The particles' traces.
        /// </summary>
        public const int TREE_PHOTO_STAGE_FLOW = 4;

        /// <summary>
        /// Branches.
        /// </summary>
        public const int TREE_PHOTO_STAGE_WOOD = 5;

        /// <summary>
        /// Twigs and leaves.
        /// </summary>
        public const int TREE_PHOTO_STAGE_CROWN = 6;

        /// <summary>
        /// Livewire from points on the silhouette.
        /// </summary>
        public const int TREE_BRANCHES_LIVEWIRE = 0;

        /// <summary>
        /// Livewire from `seeds`.
        /// </summary>
        public const int TREE_BRANCHES_SEEDS = 1;

        /// <summary>
        /// `strokes`, as a person drew them.
        /// </summary>
        public const int TREE_BRANCHES_STROKES = 2;

        /// <summary>
        /// `graph`.
        /// </summary>
        public const int TREE_BRANCHES_GRAPH = 3;

        /// <summary>
        /// None: this view's branches are left to chance.
        /// </summary>
        public const int TREE_BRANCHES_NONE = 4;

        /// <summary>
        /// Predecessor of the root, and of nodes that no path leads to.
        /// </summary>
        public const uint TREE_NO_NODE = 4294967295;

        /// <summary>
        /// Anywhere in the volume.
        /// </summary>
        public const int TREE_PATH_PLACING_VOLUME = 0;

        /// <summary>
        /// Within one separation of the volume's surface.
        /// </summary>
        public const int TREE_PATH_PLACING_SURFACE = 1;

        /// <summary>
        /// The part of a ball round the root that lies within an angle of the axis.
        /// </summary>
        public const int TREE_PATH_SHAPE_SECTOR = 0;

        /// <summary>
        /// A cone that stands on the root and narrows outwards.
        /// </summary>
        public const int TREE_PATH_SHAPE_CONE = 1;

        /// <summary>
        /// A cone with its tip on the root that widens outwards.
        /// </summary>
        public const int TREE_PATH_SHAPE_INVERTED_CONE = 2;

        /// <summary>
        /// Any volume.
        /// </summary>
        public const int TREE_PATH_SHAPE_CUSTOM = 3;

        /// <summary>
        /// From the root of the graph before through the endpoint.
        /// </summary>
        public const int TREE_PATH_AXIS_OUTWARD = 0;

        /// <summary>
        /// Straight down.
        /// </summary>
        public const int TREE_PATH_AXIS_DOWN = 1;

        /// <summary>
        /// One direction for all.
        /// </summary>
        public const int TREE_PATH_AXIS_FIXED = 2;

        /// <summary>
        /// A random direction for each.
        /// </summary>
        public const int TREE_PATH_AXIS_RANDOM = 3;

        /// <summary>
        /// Through all levels.
        /// </summary>
        public const int TREE_PATH_LIFESPAN_FULL = 0;

        /// <summary>
        /// At each level a branch ends with the chance `lifespan_stop`; else the number of levels left, L, falls
        /// by a number drawn from 0 to L. Makes irregular, livelier trees.
        /// </summary>
        public const int TREE_PATH_LIFESPAN_RANDOM = 1;

        /// <summary>
        /// Rows for levels in a report: as many as there can be.
        /// </summary>
        public const int TREE_PATH_REPORT_LEVELS = 17;

        /// <summary>
        /// The foot is at the picture's bottom: the trunk may go on, and the tree be higher than it seems.
        /// </summary>
        public const int TREE_ALIGN_BASE_CROPPED = 0;

        /// <summary>
        /// The crown touches the picture's border: the tree may go on beyond it.
        /// </summary>
        public const int TREE_ALIGN_CROWN_CROPPED = 1;

        /// <summary>
        /// No bare trunk shows: the base is the lowest point near the middle.
        /// </summary>
        public const int TREE_ALIGN_NO_TRUNK = 2;

        /// <summary>
        /// `parts` parts apart from the tree are left out; `found` is their share of all that is covered.
        /// </summary>
        public const int TREE_ALIGN_LEFT_OUT = 3;

        /// <summary>
        /// The tree is in `parts` parts, as a crown in tufts is.
        /// </summary>
        public const int TREE_ALIGN_PARTS = 4;

        /// <summary>
        /// In `view` the crown begins at the share `found` of the tree's height, in the middle of all views at
        /// `usual`.
        /// </summary>
        public const int TREE_ALIGN_CROWN_BASE = 5;

        /// <summary>
        /// In `view` the crown is `found` of the tree's height wide, in the middle of all views `usual`.
        /// </summary>
        public const int TREE_ALIGN_CROWN_WIDTH = 6;

        /// <summary>
        /// What this version of the interface has no name for.
        /// </summary>
        public const int TREE_ALIGN_OTHER = 7;

        /// <summary>
        /// Rows for warnings in a report: more than one view can have.
        /// </summary>
        public const int TREE_ALIGN_WARNINGS = 8;

        /// <summary>
        /// A line with round ends.
        /// </summary>
        public const int TREE_MARK_LINE = 0;

        /// <summary>
        /// A line with a head at `to`.
        /// </summary>
        public const int TREE_MARK_ARROW = 1;

        /// <summary>
        /// A disc round `from`; `to` is not looked at.
        /// </summary>
        public const int TREE_MARK_DOT = 2;

        /// <summary>
        /// The pixels whose corners lie from `from` up to `to`; `width` is not looked at.
        /// </summary>
        public const int TREE_MARK_FILL = 3;

        /// <summary>
        /// It goes too.
        /// </summary>
        public const int TREE_CUT_OFF_DROP = 0;

        /// <summary>
        /// It is joined to the nearest point of the rest by a straight line.
        /// </summary>
        public const int TREE_CUT_OFF_RECONNECT = 1;

        /// <summary>
        /// Blue: right for green leaves.
        /// </summary>
        public const int TREE_SCREEN_BLUE = 0;

        /// <summary>
        /// Green: for autumn leaves and bare branches.
        /// </summary>
        public const int TREE_SCREEN_GREEN = 1;

        /// <summary>
        /// Certainly not the tree.
        /// </summary>
        public const int TREE_LEVEL_BACKGROUND = 0;

        /// <summary>
        /// To be found.
        /// </summary>
        public const int TREE_LEVEL_UNKNOWN = 1;

        /// <summary>
        /// Certainly the tree.
        /// </summary>
        public const int TREE_LEVEL_FOREGROUND = 2;

        /// <summary>
        /// A clear sky.
        /// </summary>
        public const int TREE_BACKDROP_SKY = 0;

        /// <summary>
        /// Light grey paper under soft white light.
        /// </summary>
        public const int TREE_BACKDROP_STUDIO = 1;

        /// <summary>
        /// It chooses its place so that the whole mesh is in the picture.
        /// </summary>
        public const int TREE_CAMERA_FRAMED = 0;

        /// <summary>
        /// It stands where it is told to.
        /// </summary>
        public const int TREE_CAMERA_PLACED = 1;

        /// <summary>
        /// Far things are smaller.
        /// </summary>
        public const int TREE_LENS_PERSPECTIVE = 0;

        /// <summary>
        /// Parallel projection; what lies behind the eye is not drawn.
        /// </summary>
        public const int TREE_LENS_ORTHOGRAPHIC = 1;

        /// <summary>
        /// Number of bins in `tree_concentration`.
        /// </summary>
        public const int TREE_CONCENTRATION_BINS = 12;

        /// <summary>
        /// A leaf.
        /// </summary>
        public const uint TREE_LEVEL_OF_LEAF = 4294967295;

        /// <summary>
        /// An open line: a trunk or a branch, from either end.
        /// </summary>
        public const int TREE_DRAWN_KIND_AXIS = 0;

        /// <summary>
        /// The outline of a crown, of a branch's foliage or of a leaf. Its first point is not repeated.
        /// </summary>
        public const int TREE_DRAWN_KIND_OUTLINE = 1;

        /// <summary>
        /// Levels of branches that `tree_silhouette_grown` counts, the trunk's included.
        /// </summary>
        public const int TREE_SILHOUETTE_LEVELS = 16;

        /// <summary>
        /// `count` points were not finite or absurdly far away, and were left out.
        /// </summary>
        public const int TREE_OUTLINE_POINTS_DROPPED = 0;

        /// <summary>
        /// `count` points repeated at once were left out.
        /// </summary>
        public const int TREE_OUTLINE_DUPLICATES_DROPPED = 1;

        /// <summary>
        /// Of `count` points `after` were kept.
        /// </summary>
        public const int TREE_OUTLINE_THINNED = 2;

        /// <summary>
        /// It was open, with close ends, and was closed straight over `gap` metres.
        /// </summary>
        public const int TREE_OUTLINE_CLOSED = 3;

        /// <summary>
        /// It was wide open, by `gap` metres, a `share` of its length, and was closed straight.
        /// </summary>
        public const int TREE_OUTLINE_WIDE_GAP_CLOSED = 4;

        /// <summary>
        /// It ran out and straight back at `count` corners, which were left out.
        /// </summary>
        public const int TREE_OUTLINE_SPIKES_DROPPED = 5;

        /// <summary>
        /// It crossed or touched itself; what it winds round was kept.
        /// </summary>
        public const int TREE_OUTLINE_CROSSING_UNDONE = 6;

        /// <summary>
        /// Of what it winds round only the largest part was kept: `count` others, a `share` of the area, were left out.
        /// </summary>
        public const int TREE_OUTLINE_PARTS_DROPPED = 7;

        /// <summary>
        /// It ran with the clock and was turned.
        /// </summary>
        public const int TREE_OUTLINE_TURNED = 8;

        /// <summary>
        /// Something else: `tree_outline_repairs_text` says what.
        /// </summary>
        public const int TREE_OUTLINE_OTHER = 9;

        /// <summary>
        /// Evenly over length and azimuth, without a pattern. The default.
        /// </summary>
        public const int TREE_ARRANGEMENT_SPREAD = 0;

        /// <summary>
        /// One at a node, each turned against the last by `angle`.
        /// </summary>
        public const int TREE_ARRANGEMENT_SPIRAL = 1;

        /// <summary>
        /// Two at a node, all pairs in one plane.
        /// </summary>
        public const int TREE_ARRANGEMENT_OPPOSITE = 2;

        /// <summary>
        /// Two at a node, each pair across the last.
        /// </summary>
        public const int TREE_ARRANGEMENT_DECUSSATE = 3;

        /// <summary>
        /// `per_node` at a node, each whorl turned against the last by `angle`.
        /// </summary>
        public const int TREE_ARRANGEMENT_WHORLED = 4;

        /// <summary>
        /// Two at a node, all in the horizontal plane, which lies at the azimuth `angle`.
        /// </summary>
        public const int TREE_ARRANGEMENT_HORIZONTAL = 5;

        /// <summary>
        /// Any other: `per_node` at a node, each node turned against the last by `angle`.
        /// </summary>
        public const int TREE_ARRANGEMENT_CUSTOM = 6;

        /// <summary>
        /// In place of a branch's id: the trunk, as a parent; none, as the source of a style. No branch has this id.
        /// </summary>
        public const int TREE_NO_BRANCH = 0;

        /// <summary>
        /// A bump of the outline.
        /// </summary>
        public const int TREE_BRANCH_OF_BUMP = 0;

        /// <summary>
        /// The outline was not covered there.
        /// </summary>
        public const int TREE_BRANCH_OF_COVERAGE = 1;

        /// <summary>
        /// A person drew it.
        /// </summary>
        public const int TREE_BRANCH_DRAWN = 2;

        /// <summary>
        /// `count` shapes outside all layers, or outside the groups of trees, were left out.
        /// </summary>
        public const int TREE_DRAWN_STRAY_SHAPES = 0;

        /// <summary>
        /// `count` open lines beside filled shapes were left out.
        /// </summary>
        public const int TREE_DRAWN_LINES_DROPPED = 1;

        /// <summary>
        /// A trunk drawn as an area became its middle line.
        /// </summary>
        public const int TREE_DRAWN_TRUNK_THINNED = 2;

        /// <summary>
        /// A shape as large as the drawing was left out as its background.
        /// </summary>
        public const int TREE_DRAWN_BACKGROUND_DROPPED = 3;

        /// <summary>
        /// `count` parts near the tree were joined to it.
        /// </summary>
        public const int TREE_DRAWN_PARTS_BRIDGED = 4;

        /// <summary>
        /// `count` parts far from the tree, or too small, a `share` of the area, were left out.
        /// </summary>
        public const int TREE_DRAWN_PARTS_DROPPED = 5;

        /// <summary>
        /// Holes, a `share` of the area, were filled.
        /// </summary>
        public const int TREE_DRAWN_HOLES_FILLED = 6;

        /// <summary>
        /// Gaps in a frayed crown were closed, the widest of `width` in units of the drawing.
        /// </summary>
        public const int TREE_DRAWN_GAPS_CLOSED = 7;

        /// <summary>
        /// No trunk was seen: the silhouette is all crown.
        /// </summary>
        public const int TREE_DRAWN_NO_TRUNK = 8;

        /// <summary>
        /// A tree of which nothing could be used was left out.
        /// </summary>
        public const int TREE_DRAWN_TREE_DROPPED = 9;

        /// <summary>
        /// Something else: `tree_outline_drawing_repairs_text` says what.
        /// </summary>
        public const int TREE_DRAWN_OTHER = 10;

        /// <summary>
        /// All siblings that were not drawn themselves.
        /// </summary>
        public const int TREE_TRANSFER_SIBLINGS = 0;

        /// <summary>
        /// Those of them on the same side of the axis.
        /// </summary>
        public const int TREE_TRANSFER_SIDE = 1;

        /// <summary>
        /// The siblings that are listed, drawn or not.
        /// </summary>
        public const int TREE_TRANSFER_ONLY = 2;

        /// <summary>
        /// None.
        /// </summary>
        public const int TREE_TRANSFER_NOBODY = 3;

        /// <summary>
        /// The horizon follows from ground points and sizes; trees drawn on about one height stand on one line. The default.
        /// </summary>
        public const int TREE_PERSPECTIVE_ESTIMATED = 0;

        /// <summary>
        /// The horizon is given.
        /// </summary>
        public const int TREE_PERSPECTIVE_HORIZON = 1;

        /// <summary>
        /// There is none: all trees stand on one line, their sizes are as drawn.
        /// </summary>
        public const int TREE_PERSPECTIVE_FLAT = 2;

        /// <summary>
        /// In place of a tree's number: no tree.
        /// </summary>
        public const uint TREE_NO_TREE = 4294967295;

        /// <summary>
        /// Parent of the root: no node.
        /// </summary>
        public const uint TREE_NO_PARENT = 4294967295;

        /// <summary>
        /// The child with the largest radius, by length to the tip where radii are equal. The default.
        /// </summary>
        public const int TREE_CONTINUATION_THICKEST = 0;

        /// <summary>
        /// The child with the longest path to a tip.
        /// </summary>
        public const int TREE_CONTINUATION_LONGEST = 1;

        /// <summary>
        /// The child that bends least from the segment below; at the root, the longest.
        /// </summary>
        public const int TREE_CONTINUATION_STRAIGHTEST = 2;

        /// <summary>
        /// +Y, as in this library.
        /// </summary>
        public const int TREE_SWC_UP_Y = 0;

        /// <summary>
        /// +Z, as laser scanners and foresters have it.
        /// </summary>
        public const int TREE_SWC_UP_Z = 1;

        /// <summary>
        /// They stay 0, for example to be found by `tree_skeleton_by_rule`.
        /// </summary>
        public const int TREE_SWC_RADIUS_KEEP = 0;

        /// <summary>
        /// They go from the radius below to the thickest known radius above, in proportion to the path length.
        /// Where nothing is known above, the radius below is taken; where nothing is known below, the one above;
        /// where nothing is known at all, 0 stays.
        /// </summary>
        public const int TREE_SWC_RADIUS_INTERPOLATE = 1;

        /// <summary>
        /// Not known: name, alpha and shape decide.
        /// </summary>
        public const int TREE_HINT_AUTO = 0;

        /// <summary>
        /// Bark.
        /// </summary>
        public const int TREE_HINT_WOOD = 1;

        /// <summary>
        /// Leaves, needles, flowers, or cards of whole sprays.
        /// </summary>
        public const int TREE_HINT_LEAVES = 2;

        /// <summary>
        /// Neither: ground, pots, labels.
        /// </summary>
        public const int TREE_HINT_IGNORE = 3;

        /// <summary>
        /// Leaf widths in a report: those of the first kinds.
        /// </summary>
        public const int TREE_SKELETONIZE_LEAF_WIDTHS = 256;

        /// <summary>
        /// Bark.
        /// </summary>
        public const int TREE_CLASS_WOOD = 0;

        /// <summary>
        /// A card or a small thin surface: one leaf.
        /// </summary>
        public const int TREE_CLASS_LEAF = 1;

        /// <summary>
        /// A closed body of leaves.
        /// </summary>
        public const int TREE_CLASS_BLOB = 2;

        /// <summary>
        /// Not looked at.
        /// </summary>
        public const int TREE_CLASS_IGNORED = 3;

        /// <summary>
        /// The segment continues its parent's axis.
        /// </summary>
        public const uint TREE_SKETCH_APICAL = 4294967295;

        /// <summary>
        /// A straight line joins them, however far they are.
        /// </summary>
        public const int TREE_ISOLATED_BRIDGE = 0;

        /// <summary>
        /// Those beyond the reach are left out.
        /// </summary>
        public const int TREE_ISOLATED_DROP = 1;

        /// <summary>
        /// Those beyond the reach are an error.
        /// </summary>
        public const int TREE_ISOLATED_REFUSE = 2;

        /// <summary>
        /// `count` points that are not finite, or absurdly far away, were left out.
        /// </summary>
        public const int TREE_REPAIR_BAD_POINTS = 0;

        /// <summary>
        /// It has no length worth speaking of, and was left out.
        /// </summary>
        public const int TREE_REPAIR_EMPTY = 1;

        /// <summary>
        /// It was taken for the ground, and left out.
        /// </summary>
        public const int TREE_REPAIR_GROUND = 2;

        /// <summary>
        /// It was taken for a mark on the trunk's bark, and left out.
        /// </summary>
        public const int TREE_REPAIR_BARK_MARK = 3;

        /// <summary>
        /// It is a small mark that touches nothing, and was left out.
        /// </summary>
        public const int TREE_REPAIR_SPECK = 4;

        /// <summary>
        /// It shows roots below the ground: what is below was left out.
        /// </summary>
        public const int TREE_REPAIR_BELOW_GROUND = 5;

        /// <summary>
        /// It runs along the crown's outline, stroke `other`: that part is its ink, and was left out.
        /// </summary>
        public const int TREE_REPAIR_CROWN_INK = 6;

        /// <summary>
        /// It was not marked, and was taken to show `role`.
        /// </summary>
        public const int TREE_REPAIR_TAKEN_AS = 7;

        /// <summary>
        /// It shows the trunk and the crown in one go, and was cut at the corner between them.
        /// </summary>
        public const int TREE_REPAIR_CUT_AT_CORNER = 8;

        /// <summary>
        /// It is one side of the trunk and stroke `other` the other side: the line between them was taken.
        /// </summary>
        public const int TREE_REPAIR_MIDDLE_OF_SIDES = 9;

        /// <summary>
        /// It is an outline: its middle line was taken.
        /// </summary>
        public const int TREE_REPAIR_MIDDLE_OF_OUTLINE = 10;

        /// <summary>
        /// All of it runs along stroke `other`, and was merged into that.
        /// </summary>
        public const int TREE_REPAIR_MERGED = 11;

        /// <summary>
        /// A part of it runs along stroke `other`, and was merged into that.
        /// </summary>
        public const int TREE_REPAIR_MERGED_PARTLY = 12;

        /// <summary>
        /// It was drawn towards the base, and was turned round.
        /// </summary>
        public const int TREE_REPAIR_TURNED_ROUND = 13;

        /// <summary>
        /// It passes through where it joins, and was split there in two.
        /// </summary>
        public const int TREE_REPAIR_SPLIT = 14;

        /// <summary>
        /// It crosses stroke `other` a little: the end beyond it, `share` long, was cut off.
        /// </summary>
        public const int TREE_REPAIR_TRIMMED = 15;

        /// <summary>
        /// Its end was joined over a small gap of `share`.
        /// </summary>
        public const int TREE_REPAIR_SNAPPED = 16;

        /// <summary>
        /// It was joined by a straight line over a gap of `share`.
        /// </summary>
        public const int TREE_REPAIR_BRIDGED = 17;

        /// <summary>
        /// It begins on the ground beside the base, `share` away, and was joined to the base.
        /// </summary>
        public const int TREE_REPAIR_SECOND_ROOT = 18;

        /// <summary>
        /// It is `share` away from the rest, and was left out.
        /// </summary>
        public const int TREE_REPAIR_ISOLATED = 19;

        /// <summary>
        /// There are no branches: a straight trunk was imagined below this crown.
        /// </summary>
        public const int TREE_REPAIR_IMAGINED_TRUNK = 20;

        /// <summary>
        /// Something else: `tree_plan_repairs_text` says what.
        /// </summary>
        public const int TREE_REPAIR_OTHER = 21;

        /// <summary>
        /// It shows the flare of a root at the trunk's foot, which was left out.
        /// </summary>
        public const int TREE_REPAIR_ROOT_FLARE = 22;

        /// <summary>
        /// No branch reaches into the crown, stroke `other`: this one was drawn on.
        /// </summary>
        public const int TREE_REPAIR_DRAWN_ON = 23;

        /// <summary>
        /// Of stroke `stroke`, `count` points were not finite or absurdly far away, and were left out.
        /// </summary>
        public const int TREE_CROWN_POINTS_DROPPED = 0;

        /// <summary>
        /// Stroke `stroke` has no length, and was left out.
        /// </summary>
        public const int TREE_CROWN_STROKE_DROPPED = 1;

        /// <summary>
        /// Stroke `stroke` is open and lies inside a closed one: it is a detail, and was left out.
        /// </summary>
        public const int TREE_CROWN_DETAIL_DROPPED = 2;

        /// <summary>
        /// Stroke `stroke`, or several joined ones of which it is the first, was closed straight over `gap` metres.
        /// </summary>
        public const int TREE_CROWN_CLOSED = 3;

        /// <summary>
        /// Strokes were joined at `count` places where their ends were close.
        /// </summary>
        public const int TREE_CROWN_JOINED = 4;

        /// <summary>
        /// A wide gap of `gap` metres between ends was closed; `round_branches` says whether round branches in it.
        /// </summary>
        public const int TREE_CROWN_GAP_CLOSED = 5;

        /// <summary>
        /// Loop `stroke`, in the order they were closed, crossed itself; what it winds round was kept.
        /// </summary>
        public const int TREE_CROWN_CROSSING_UNDONE = 6;

        /// <summary>
        /// `count` loops that overlap were united, and `after` polygons are left of them.
        /// </summary>
        public const int TREE_CROWN_UNITED = 7;

        /// <summary>
        /// `count` loops inside others are details, and were left out.
        /// </summary>
        public const int TREE_CROWN_NESTED_DROPPED = 8;

        /// <summary>
        /// `count` tiny parts were left out.
        /// </summary>
        public const int TREE_CROWN_CRUMBS_DROPPED = 9;

        /// <summary>
        /// A `share` of the branches' points lies outside.
        /// </summary>
        public const int TREE_CROWN_BRANCHES_OUTSIDE = 10;

        /// <summary>
        /// No branch touches the crown.
        /// </summary>
        public const int TREE_CROWN_NO_BRANCH_INSIDE = 11;

        /// <summary>
        /// Something else: `tree_crown_repairs_text` says what.
        /// </summary>
        public const int TREE_CROWN_OTHER = 12;

        /// <summary>
        /// Not said: cleaning is to find out.
        /// </summary>
        public const int TREE_ROLE_UNKNOWN = 0;

        /// <summary>
        /// The trunk. It begins the tree.
        /// </summary>
        public const int TREE_ROLE_TRUNK = 1;

        /// <summary>
        /// A branch.
        /// </summary>
        public const int TREE_ROLE_BRANCH = 2;

        /// <summary>
        /// The crown's outline, or a piece of it.
        /// </summary>
        public const int TREE_ROLE_CROWN = 3;

        /// <summary>
        /// The seed of the trees that the built-in templates were measured by.
        /// </summary>
        public const int TREE_EXEMPLAR_SEED = 1;

        /// <summary>
        /// Number of distances in a footprint. Direction 0 is +x, then they turn against the clock where y goes up.
        /// </summary>
        public const int TREE_FOOTPRINT_DIRECTIONS = 64;

        /// <summary>
        /// Bottom-up inference.
        /// </summary>
        public const int TREE_SKETCH_STEP_BOTTOM_UP = 0;

        /// <summary>
        /// Passes of ICM.
        /// </summary>
        public const int TREE_SKETCH_STEP_ICM = 1;

        /// <summary>
        /// Branches swung to the other side.
        /// </summary>
        public const int TREE_SKETCH_STEP_SWING = 2;

        /// <summary>
        /// Crossing branches were moved apart.
        /// </summary>
        public const int TREE_SKETCH_STEP_SEPARATE = 3;

        /// <summary>
        /// Ω was estimated.
        /// </summary>
        public const int TREE_SKETCH_STEP_OMEGA = 4;

        /// <summary>
        /// What is wound round. The default, as in SVG.
        /// </summary>
        public const int TREE_FILL_NON_ZERO = 0;

        /// <summary>
        /// What is wound round an odd number of times.
        /// </summary>
        public const int TREE_FILL_EVEN_ODD = 1;

        /// <summary>
        /// Orders of axes that a `tree_sketch_omega` tells apart.
        /// </summary>
        public const int TREE_SKETCH_ORDERS = 8;

        /// <summary>
        /// Strokes joined, the crown closed.
        /// </summary>
        public const int TREE_SKETCH_STAGE_CLEAN = 0;

        /// <summary>
        /// Templates compared.
        /// </summary>
        public const int TREE_SKETCH_STAGE_SELECT = 1;

        /// <summary>
        /// Depths inferred.
        /// </summary>
        public const int TREE_SKETCH_STAGE_INFER = 2;

        /// <summary>
        /// Branches propagated.
        /// </summary>
        public const int TREE_SKETCH_STAGE_PROPAGATE = 3;

        /// <summary>
        /// Wood with radii.
        /// </summary>
        public const int TREE_SKETCH_STAGE_WOOD = 4;

        /// <summary>
        /// Twigs and leaves.
        /// </summary>
        public const int TREE_SKETCH_STAGE_TREE = 5;

        /// <summary>
        /// Number of shares in `directions` of a `tree_template_side`.
        /// </summary>
        public const int TREE_DIRECTION_BINS = 12;

        /// <summary>
        /// Version of the ABI that this header describes. A library with the same number has every function and
        /// struct of this header; additions do not change it.
        /// </summary>
        public const int TREE_ABI_VERSION = 1;

        /// <summary>
        /// None of those below: newer than this header.
        /// </summary>
        public const int TREE_SOLID_OTHER = 0;

        /// <summary>
        /// A ball.
        /// </summary>
        public const int TREE_SOLID_SPHERE = 1;

        /// <summary>
        /// An axis-aligned ellipsoid.
        /// </summary>
        public const int TREE_SOLID_ELLIPSOID = 2;

        /// <summary>
        /// A round cylinder.
        /// </summary>
        public const int TREE_SOLID_CYLINDER = 3;

        /// <summary>
        /// A cone, whole or truncated.
        /// </summary>
        public const int TREE_SOLID_FRUSTUM = 4;

        /// <summary>
        /// All within a distance of a segment.
        /// </summary>
        public const int TREE_SOLID_CAPSULE = 5;

        /// <summary>
        /// An axis-aligned box.
        /// </summary>
        public const int TREE_SOLID_BOX = 6;

        /// <summary>
        /// All on one side of a plane.
        /// </summary>
        public const int TREE_SOLID_HALF_SPACE = 7;

        /// <summary>
        /// The points of a ball within an angle of an axis.
        /// </summary>
        public const int TREE_SOLID_SECTOR = 8;

        /// <summary>
        /// What a profile sweeps.
        /// </summary>
        public const int TREE_SOLID_REVOLUTION = 9;

        /// <summary>
        /// What a closed mesh bounds.
        /// </summary>
        public const int TREE_SOLID_MESH = 10;

        /// <summary>
        /// What lies in any part.
        /// </summary>
        public const int TREE_SOLID_UNION = 11;

        /// <summary>
        /// What lies in all parts.
        /// </summary>
        public const int TREE_SOLID_INTERSECTION = 12;

        /// <summary>
        /// What lies in part 0 but not in part 1.
        /// </summary>
        public const int TREE_SOLID_DIFFERENCE = 13;

        /// <summary>
        /// Part 0, transformed.
        /// </summary>
        public const int TREE_SOLID_TRANSFORMED = 14;

        /// <summary>
        /// Murray's angles, at which a vessel of radius `r0` parts into `r1` and `r2` with the least volume:
        /// between the branch below and the first branch, then the second, in radians. Radii are above 0, and
        /// `r0` is from √|r1² - r2²| to √(r1² + r2²): elsewhere no such fork is.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_murray_angles(float r0, float r1, float r2, float* angles);

        /// <summary>
        /// Murray's angles where the branch below follows the pipe model with `exponent`, 2 to 10; exact for
        /// twigs however thin. `r1` and `r2` are above 0. Otherwise as `tree_murray_angles`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pipe_angles(float exponent, float r1, float r2, float* angles);

        /// <summary>
        /// Holton's angles: the more strands a branch has, the less it turns. `s1` and `s2` are the strands of
        /// the two branches, not both 0; `sum` is the angle between them in radians, 0 to 2π. Otherwise as
        /// `tree_murray_angles`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strand_angles(ulong s1, ulong s2, float sum, float* angles);

        /// <summary>
        /// The radius of every node by a rule, in metres: `radii` has room for `capacity` floats, at least one
        /// for each node. `rule` may be NULL for the default. The radii that are there do not matter.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_radii(tree_skeleton* skeleton, tree_radius_rule* rule, float* radii, UIntPtr capacity);

        /// <summary>
        /// A new skeleton with the radii that a rule gives, see `tree_skeleton_radii`. For radii of your own
        /// there is `tree_skeleton_with_radii`. Free it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_by_rule(tree_skeleton* skeleton, tree_radius_rule* rule, tree_skeleton** changed);

        /// <summary>
        /// The radius of every node by distance to the tip, in metres, with levels of your own in place of the
        /// axes' orders: `levels` has `n_levels` numbers, one for each node, 0 for the trunk. Of `rule`, which
        /// may be NULL for the default, the fields by distance to the tip count, whatever its kind is. `radii`
        /// has room for `capacity` floats, at least one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_radii_at_levels(tree_skeleton* skeleton, uint* levels, UIntPtr n_levels, tree_radius_rule* rule, float* radii, UIntPtr capacity);

        /// <summary>
        /// The number of strands through every node; at every fork the children's numbers add up to the
        /// parent's. Of `rule`, which may be NULL for the default, the fields of strands count, whatever its kind
        /// is. `strands` has room for `capacity` numbers, at least one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_strands(tree_skeleton* skeleton, tree_radius_rule* rule, ulong* strands, UIntPtr capacity);

        /// <summary>
        /// Whether all fields of a rule are in order: `TREE_OK`, or the error that its use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_radius_rule_check(tree_radius_rule* rule);

        /// <summary>
        /// Makes `rule`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_radius_rule_init(tree_radius_rule* rule, UIntPtr size);

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
        /// Frees a switch. Calls it was given to may still run.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cancel_free(tree_cancel* cancel);

        /// <summary>
        /// What a branch of a mesh does in the wind. Set `motion-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_branch_motion(tree_mesh* mesh, UIntPtr branch, tree_branch_motion* motion);

        /// <summary>
        /// How far along a branch of a mesh a point of three floats lies: 0 up to the collar, 1 at the tip and
        /// beyond.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_branch_reach(tree_mesh* mesh, UIntPtr branch, float* point, float* reach);

        /// <summary>
        /// One branch for each axis of a skeleton, in the same order, turning about its fork. Those of a built
        /// mesh turn about the places where their bark stands. Free them with `tree_wind_branches_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_wind_branches(tree_skeleton* skeleton, uint continuation, tree_wind_branches** branches);

        /// <summary>
        /// Views the branches: where they begin, and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_wind_branches_view(tree_wind_branches* branches, tree_wind_branch** rows, UIntPtr* n);

        /// <summary>
        /// Frees branches.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_wind_branches_free(tree_wind_branches* branches);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_capsule_params_init(tree_capsule_params* @params, UIntPtr size);

        /// <summary>
        /// Makes capsules of a skeleton's thick wood: few, and with nearly all of it inside. However few are
        /// allowed, the share asked for holds; what suffers is how tight they are, and the report says how tight.
        /// `params`, `control` and `report` may be NULL. Free the capsules with `tree_capsules_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_capsules(tree_skeleton* skeleton, tree_capsule_params* @params, tree_control* control, tree_capsule_report* report, tree_capsules** capsules);

        /// <summary>
        /// Views the capsules: where they begin, NULL for none, and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_capsules_view(tree_capsules* capsules, tree_capsule** rows, UIntPtr* n);

        /// <summary>
        /// Whether a point of three floats lies inside a capsule or on its border.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_capsule_contains(tree_capsule* capsule, float* point, uint* inside);

        /// <summary>
        /// Volume of a capsule in cubic metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_capsule_volume(tree_capsule* capsule, double* volume);

        /// <summary>
        /// Frees capsules.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_capsules_free(tree_capsules* capsules);

        /// <summary>
        /// What a convention says. Set `traits-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convention_view(uint convention, tree_convention_traits* traits);

        /// <summary>
        /// Converts `n` places of three floats each, units included. `to` has room for as many and may be `from`
        /// itself; otherwise the two must not overlap.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convert_positions(uint convention, uint way, float* from, UIntPtr n, float* to);

        /// <summary>
        /// Converts `n` unit vectors (normals, axes) of three floats each. `to` is as in
        /// `tree_convert_positions`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convert_directions(uint convention, uint way, float* from, UIntPtr n, float* to);

        /// <summary>
        /// Converts `n` tangents of four floats each. Their w is turned so that `w * cross(normal, tangent)`,
        /// with the arithmetic of their shaders, points the way green runs in their normal maps: up the picture,
        /// but down in Unreal. `to` is as in `tree_convert_positions`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convert_tangents(uint convention, uint way, float* from, UIntPtr n, float* to);

        /// <summary>
        /// Converts `n` texture coordinates of two floats each, to and back alike. `to` is as in
        /// `tree_convert_positions`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convert_uvs(uint convention, float* from, UIntPtr n, float* to);

        /// <summary>
        /// Turns `n_triangles` triangles of three indices each where front faces run clockwise, to and back
        /// alike. `to` is as in `tree_convert_positions`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convert_triangles(uint convention, uint* from, UIntPtr n_triangles, uint* to);

        /// <summary>
        /// Packs a surface of a mesh, in the axes of the engine the layout is for. `control` may be NULL; only a
        /// cancellation before the work begins matters. Free the result with `tree_packed_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_pack(tree_mesh* mesh, UIntPtr surface, uint layout, tree_control* control, tree_packed** packed);

        /// <summary>
        /// Views streams and indices. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_view(tree_packed* packed, tree_packed_columns* columns);

        /// <summary>
        /// Frees a packed surface, and with it all views of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_free(tree_packed* packed);

        /// <summary>
        /// Views the textures of a surface packed with `TREE_LAYOUT_PIVOT_PAINTER`. Set `pivots-&gt;struct_size`
        /// first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_pivots(tree_packed* packed, tree_pivots* pivots);

        /// <summary>
        /// Reads an element back, 0 to `n_elements - 1`, to check a shader against. Set `element-&gt;struct_size`
        /// first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_pivot_element(tree_packed* packed, uint number, tree_pivot_element* element);

        /// <summary>
        /// Reads a packed surface back as an engine would, to check a shader against: it differs from what was
        /// packed by the quantisation only. `mesh`, which gives the table of branches, is needed for
        /// `TREE_LAYOUT_VERTEX` and may be NULL else. Free the result with `tree_unpacked_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_unpack(tree_packed* packed, tree_mesh* mesh, tree_unpacked** unpacked);

        /// <summary>
        /// Views what was read back. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_unpacked_view(tree_unpacked* unpacked, tree_unpacked_columns* columns);

        /// <summary>
        /// Frees what was read back.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_unpacked_free(tree_unpacked* unpacked);

        /// <summary>
        /// Views the vertices of a surface packed with `TREE_LAYOUT_VERTEX`; its indices are in
        /// `tree_packed_view`. Set `vertices-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_packed_vertices_view(tree_packed* packed, tree_packed_vertices* vertices);

        /// <summary>
        /// Writes a row for each vertex of a surface; `capacity` must be the number of its vertices or more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_wind(tree_mesh* mesh, UIntPtr surface, tree_vertex_wind* rows, UIntPtr capacity);

        /// <summary>
        /// Makes `wind`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_wind_init(tree_wind* wind, UIntPtr size);

        /// <summary>
        /// Moves a surface by the wind, `seconds` after it began: the reference for a vertex shader. Writes three
        /// floats for each vertex, in metres; `capacity` is the room in floats, three times the number of
        /// vertices or more. `wind` may be NULL. A vertex whose branch is unknown stays where it is.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_bend(tree_mesh* mesh, tree_wind* wind, float seconds, UIntPtr surface, float* positions, UIntPtr capacity);

        /// <summary>
        /// Share of its branch's turn that a point at this reach (0 to 1, else brought there) makes: 0 at the
        /// collar, 1 at the tip, as a clamped beam under an even load.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_wind_sway(float reach, float* sway);

        /// <summary>
        /// Where in its flutter a leaf starts, 0 to 1, by its number in the surface.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_wind_leaf_phase(uint leaf, float* phase);

        /// <summary>
        /// Grows leaves on a tree: the new tree has the old skeleton and species, and the new leaves in place of
        /// the old ones. For leaves on a bare skeleton, make a tree of it with `tree_tree_new`.
        ///
        /// `params` may be NULL for the default; `kind` must be a leaf kind of the tree's species. `density` may
        /// be NULL for 1 everywhere, and is handed `user`. With `with_stalks` (a yes or no) petioles and rachises become thin
        /// branches, for close-ups: old nodes keep number, position, radius and parent, stalks come after them,
        /// and leaves name the stalk that bears them; without, leaflets name the shoot's node. The same seed
        /// gives the same leaves. `report` may be NULL. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_grow_leaves(tree_tree* tree, tree_leaf_params* @params, IntPtr density, void* user, uint with_stalks, ulong seed, tree_control* control, tree_leaf_report* report, tree_tree** grown);

        /// <summary>
        /// Grows twigs on the youngest shoots of a tree: the new tree has the old skeleton with twigs, and the
        /// old leaves and species. Old nodes keep number, position, radius and parent, so leaves stay where they
        /// are; twigs come after them, each starting at the node nearest to its place. What bears twigs is not
        /// made thicker: `tree_skeleton_by_rule` does that.
        ///
        /// `params` may be NULL for the default. `density` may be NULL for 1 everywhere, and is handed `user`.
        /// The same seed gives the same twigs. `report` may be NULL. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_grow_twigs(tree_tree* tree, tree_twig_params* @params, IntPtr density, void* user, ulong seed, tree_control* control, tree_twig_report* report, tree_tree** grown);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_params_init(tree_leaf_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields are in order for a species with `n_kinds` kinds of leaves: `TREE_OK`, or the error
        /// that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_params_check(tree_leaf_params* @params, UIntPtr n_kinds);

        /// <summary>
        /// Number of species whose leaves and twigs are known by name.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr tree_foliage_species_count();

        /// <summary>
        /// Name of the species with this number, from 0 up to, but not including, `tree_foliage_species_count`.
        /// Valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_foliage_species_name(UIntPtr index, tree_str* name);

        /// <summary>
        /// Leaves and twigs of a species by its name, of `len` bytes. Set `struct_size` of `leaves` and `twigs`
        /// first. `leaf_kind` is the name of the leaf kind that goes with them, valid for ever, for the
        /// `leaf_kinds` of a `tree_species`; it is kind 0 of the leaves. Each of the three may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_foliage_preset(byte* name, UIntPtr len, tree_leaf_params* leaves, tree_twig_params* twigs, tree_str* leaf_kind);

        /// <summary>
        /// Views the numbers: where they begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_rows_view(tree_rows* rows, uint** first, UIntPtr* n);

        /// <summary>
        /// Frees the numbers.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_rows_free(tree_rows* rows);

        /// <summary>
        /// A new skeleton, the same but with nodes at most `spacing` metres apart (1e-5 to 1e6) on all segments
        /// that lie within `bearing` metres (0 to 1e6) of a tip, so that twigs find a node near their place. Old
        /// nodes keep their order but get other numbers; positions and radii between them are linear.
        ///
        /// `rows`, which may be NULL, gets for each node the old node at its segment's upper end; free it with
        /// `tree_rows_free`, and the skeleton with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_refine(tree_skeleton* skeleton, float bearing, float spacing, tree_control* control, tree_rows** rows, tree_skeleton** refined);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twig_params_init(tree_twig_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twig_params_check(tree_twig_params* @params);

        /// <summary>
        /// Makes a choice for one instance of a model, with room for all there can ever be; level 1 and no leaves until it is
        /// updated. Free it with `tree_hybrid_choice_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_new(tree_hybrid* hybrid, tree_hybrid_choice** choice);

        /// <summary>
        /// What is drawn where the whole tree is `pixels` high, above 0 and at most 1e5, at the same scale everywhere: for files,
        /// previews, and levels of engines that have no shaders of ours. Free it with `tree_hybrid_choice_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_for_height(tree_hybrid* hybrid, float pixels, tree_hybrid_choice** choice);

        /// <summary>
        /// Chooses for a frame: a level of wood, and of leaves as `tree_card_choice_update` does it. It takes no memory.
        ///
        /// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
        /// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
        /// above 0, at most 1e9. `report` may be NULL when it is not wanted. `TREE_ERROR_PARAMETER` for numbers out of range; the
        /// choice is left as it was then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_update(tree_hybrid_choice* choice, float* eye, float pixels_per_metre, tree_hybrid_choice_report* report);

        /// <summary>
        /// Tells how much is drawn since the last update. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_measure(tree_hybrid_choice* choice, tree_hybrid_choice_report* report);

        /// <summary>
        /// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
        /// `n_boxes` of the report; as many as there are boxes are always enough.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_boxes(tree_hybrid_choice* choice, uint* boxes, UIntPtr capacity);

        /// <summary>
        /// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined: `tree_hybrid_leaf_window` tells their
        /// indices. `ranges` has room for `capacity` of them, at least `n_ranges` of the report; as many as there are boxes are
        /// always enough.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_ranges(tree_hybrid_choice* choice, tree_leaf_range* ranges, UIntPtr capacity);

        /// <summary>
        /// What is chosen as a plain mesh: the wood grown to its level, leaves, and three planes of each box, with light as on a
        /// crown. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free the mesh with
        /// `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_mesh(tree_hybrid_choice* choice, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// Frees a choice.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_choice_free(tree_hybrid_choice* choice);

        /// <summary>
        /// Levels as the `MSFT_lod` of one GLB file, each a mesh of its own, as `tree_hybrid_choice_mesh` makes it: for programs
        /// without shaders of ours. `heights` are `n_heights` heights of the tree on the screen in pixels, falling, at most 1024:
        /// each level is made for its height, and shown until the tree is as high as the next one says; the last is shown to the
        /// end. `screen` is the height of the screen in pixels, 1 to 1e5. `options` and `control` may be NULL, as in
        /// `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no heights or they do
        /// not fall.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_to_glb_levels(tree_hybrid* hybrid, float* heights, UIntPtr n_heights, float screen, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_hybrid_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_write_glb_levels(tree_hybrid* hybrid, float* heights, UIntPtr n_heights, float screen, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// Makes the model of a tree: sorts its branches (`tree_multires_new`), draws them (`tree_multi_mesh_new`), puts its
        /// leaves into boxes (`tree_leaf_boxes_along`) and takes their pictures (`tree_cards_bake`), which takes most of the
        /// time. `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL.
        /// Free the model with `tree_hybrid_free`. Errors are those of the steps.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_make(tree_tree* tree, tree_look* look, tree_hybrid_params* @params, tree_control* control, tree_hybrid** hybrid);

        /// <summary>
        /// Tells how large a model is. Set `totals-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_measure(tree_hybrid* hybrid, tree_hybrid_totals* totals);

        /// <summary>
        /// The mesh to upload, nothing copied: surface 0 is the wood, of which a level is a prefix; the others are leaves, kind by
        /// kind, in the order of the boxes, so that each box has one window (`tree_hybrid_leaf_window`). Free it with
        /// `tree_mesh_free`; it keeps alive what it is of.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_mesh(tree_hybrid* hybrid, tree_mesh** mesh);

        /// <summary>
        /// The sorted tree, nothing copied. Free it with `tree_multires_free`; it keeps alive what it is of.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_multires(tree_hybrid* hybrid, tree_multires** multires);

        /// <summary>
        /// The wood and its levels, with leaves in the order of their paths, nothing copied: `tree_multi_mesh_branches` of surface
        /// 0 and `tree_multi_mesh_draws` are right for the model's mesh too. Free it with `tree_multi_mesh_free`; it keeps alive
        /// what it is of.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_wood(tree_hybrid* hybrid, tree_multi_mesh** wood);

        /// <summary>
        /// Boxes and pictures of the leaves, nothing copied. Free them with `tree_cards_free`; they keep alive what they are of.
        /// `TREE_ERROR_NO_RESULT` when the tree has no leaves.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_cards(tree_hybrid* hybrid, tree_cards** cards);

        /// <summary>
        /// Which indices of surface `number` of the model's mesh draw `n_leaves` leaves from row `first_leaf` on, as
        /// `tree_hybrid_choice_ranges` gives them. None for the wood, and for rows that are not there. `TREE_ERROR_PARAMETER` when there is no such surface.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_leaf_window(tree_hybrid* hybrid, UIntPtr number, uint first_leaf, uint n_leaves, tree_index_window* window);

        /// <summary>
        /// The fractional level of the wood where a metre covers so many pixels, 0 to infinity; it changes without a step.
        /// `TREE_ERROR_PARAMETER` for less than 0, or NaN.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_level(tree_hybrid* hybrid, float pixels_per_metre, float* level);

        /// <summary>
        /// Frees a model. Its parts that were asked for, and choices, stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_free(tree_hybrid* hybrid);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_params_init(tree_hybrid_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params` and of its parts; `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
        /// fault.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hybrid_params_check(tree_hybrid_params* @params);

        /// <summary>
        /// Writes the node of the tree's skeleton that carries each element, leaf by leaf, exactly: for a mesh that was built
        /// of this tree. `elements` must be whole leaves (`TREE_GRAIN_LEAF`). `bearers` has room for `capacity` numbers, at least
        /// one for each element. `TREE_ERROR_INVALID` when mesh and tree have different numbers of leaves.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_bearers_of_tree(tree_tree* tree, tree_mesh* mesh, tree_elements* elements, uint* bearers, UIntPtr capacity);

        /// <summary>
        /// Writes the nearest node of the skeleton to the middle of each element: for meshes whose leaves are not known to a
        /// tree. `bearers` has room for `capacity` numbers, at least one for each element. `control` may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_bearers_nearest(tree_skeleton* skeleton, tree_elements* elements, tree_control* control, uint* bearers, UIntPtr capacity);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_box_params_init(tree_leaf_box_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_box_params_check(tree_leaf_box_params* @params);

        /// <summary>
        /// Finds the boxes of a tree. `elements` are its leaves, `bearers` the node of the skeleton that carries each of the
        /// `n_bearers` elements, as `tree_leaf_bearers_of_tree` or `tree_leaf_bearers_nearest` finds it. `params` and `control`
        /// may be NULL, `report` when it is not wanted. Progress is told in the stage `boxes`. Free the boxes with
        /// `tree_leaf_boxes_free`.
        ///
        /// `TREE_ERROR_INVALID` when there is not one bearer for each element, a bearer does not exist, the elements are of
        /// another mesh, or all leaves are one point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_along(tree_skeleton* skeleton, tree_mesh* mesh, tree_elements* elements, uint* bearers, UIntPtr n_bearers, tree_leaf_box_params* @params, tree_control* control, tree_leaf_boxes_report* report, tree_leaf_boxes** boxes);

        /// <summary>
        /// Tells how many boxes there are, and what became of the leaves. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_measure(tree_leaf_boxes* boxes, tree_leaf_boxes_report* report);

        /// <summary>
        /// Tells what box `number` is; 0 is the whole tree. Set `leaf_box-&gt;struct_size` first. `TREE_ERROR_PARAMETER` when there
        /// is no such box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_get(tree_leaf_boxes* boxes, uint number, tree_leaf_box* leaf_box);

        /// <summary>
        /// The numbers of all leaves (elements), in the order in which those of every box are one range: `n_leaves` of them,
        /// from `order` on. They stay for as long as the boxes do.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_order(tree_leaf_boxes* boxes, uint** order, UIntPtr* n_leaves);

        /// <summary>
        /// Distance in metres from `point`, three floats, to box `number`; 0 inside. `TREE_ERROR_PARAMETER` when there is no
        /// such box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_distance(tree_leaf_boxes* boxes, uint number, float* point, float* metres);

        /// <summary>
        /// Writes the six planes of box `number`, two for each of its axes, which lies in both: plane 2k holds axis k and the
        /// diagonal of the next two axes, plane 2k + 1 the other diagonal. `planes` has room for `capacity` of them.
        /// `TREE_ERROR_PARAMETER` when there is no such box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_planes(tree_leaf_boxes* boxes, uint number, tree_card_plane* planes, UIntPtr capacity);

        /// <summary>
        /// Frees boxes, and with them all views of their order.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_boxes_free(tree_leaf_boxes* boxes);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_params_init(tree_card_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_params_check(tree_card_params* @params);

        /// <summary>
        /// Projects the leaves of every box onto its planes. `boxes`, which are copied, are those of `elements` of `mesh`.
        /// `params` and `control` may be NULL, `report` when it is not wanted. Progress is told in the stage `cards`. The same
        /// input gives the same bytes for any number of threads. Free the cards with `tree_cards_free`.
        ///
        /// `TREE_ERROR_PARAMETER` also when the atlas would be wider than 16,384 texels, `TREE_ERROR_INVALID` when boxes,
        /// elements and mesh do not belong together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_bake(tree_mesh* mesh, tree_elements* elements, tree_leaf_boxes* boxes, tree_card_params* @params, tree_control* control, tree_cards_report* report, tree_cards** cards);

        /// <summary>
        /// Tells what was baked. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_measure(tree_cards* cards, tree_cards_report* report);

        /// <summary>
        /// The boxes of cards, nothing copied. Free them with `tree_leaf_boxes_free`; they keep the cards alive.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_boxes(tree_cards* cards, tree_leaf_boxes** boxes);

        /// <summary>
        /// Metres of a texel of the pictures of box `number`: the largest of its planes. `TREE_ERROR_INVALID` when there is no
        /// such box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_texel(tree_cards* cards, uint number, float* metres);

        /// <summary>
        /// Views the pixels of an atlas, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
        /// `TREE_IMPOSTOR_DETAIL` goes from minus the `reach` of the plane to it, on the side that its normal points to. Set
        /// `pixels-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_pixels(tree_cards* cards, uint map, tree_pixels* pixels);

        /// <summary>
        /// A copy of an atlas, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`. `map` is a
        /// `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_picture(tree_cards* cards, uint map, tree_control* control, tree_picture** picture);

        /// <summary>
        /// Frees cards, and with them all views of their pixels. Boxes and meshes made of them stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_free(tree_cards* cards);

        /// <summary>
        /// The planes of `n_boxes` boxes as a mesh, six squares of four vertices each, with the atlas as their texture: alpha is
        /// tested against one half, both sides are drawn. Without the shader (`tree_cards_shader`) all six planes of a box are
        /// drawn at once, which covers more than the leaves do. At most 65,536 boxes; `control` may be NULL. Free the mesh with
        /// `tree_mesh_free`. `TREE_ERROR_INVALID` when there is no such box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_mesh(tree_cards* cards, uint* boxes, UIntPtr n_boxes, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// As `tree_cards_mesh`, of some planes of each box only: `n_planes` numbers, 0 to 5, as `tree_leaf_boxes_planes` counts
        /// them, at most six. For programs without the shader: 0, 2 and 4, one for each axis, cover about as much as the leaves
        /// do. `TREE_ERROR_INVALID` when there is no such box or plane.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_mesh_of_planes(tree_cards* cards, uint* boxes, UIntPtr n_boxes, uint* planes, UIntPtr n_planes, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// What a camera sees of `n_boxes` boxes, at most 65,536, by one sample for each pixel: sRGB colour without light, alpha
        /// 0 or 255. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
        /// (`tree_view_place` helps). `control` may be NULL. Free the picture with `tree_picture_free`.
        ///
        /// `TREE_ERROR_INVALID` for a framed camera, a box that does not exist, or an eye in the middle of a box.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_view(tree_cards* cards, uint* boxes, UIntPtr n_boxes, tree_view* view, tree_control* control, tree_picture** picture);

        /// <summary>
        /// The planes of `n_boxes` boxes as a GLB file in memory: as `tree_cards_mesh`, and what the shader needs, four floats for
        /// each vertex: `_TREE_CENTER` (middle of the box in metres, number of the plane), `_TREE_HALF` (half its sides in
        /// metres, its number) and `_TREE_TURN` (the quaternion that turns its axes into those of the tree). `options` and
        /// `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
        /// `quantize`: shaders need positions in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_to_glb(tree_cards* cards, uint* boxes, UIntPtr n_boxes, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_cards_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_write_glb(tree_cards* cards, uint* boxes, UIntPtr n_boxes, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// The functions that weigh planes in a shader, as `tree_card_weights` does it: text to be put into your own. It tells what
        /// they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cards_shader(uint language, tree_str* text);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choose_params_init(tree_card_choose_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choose_params_check(tree_card_choose_params* @params);

        /// <summary>
        /// Makes a choice for one instance of a tree with these cards, with room for all there can ever be and all boxes
        /// closed. It does not keep the cards alive. Free it with `tree_card_choice_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_new(tree_cards* cards, tree_card_choice** choice);

        /// <summary>
        /// Chooses for a frame: from the box of the whole tree down, where a texel would be larger than a pixel, the children are
        /// drawn instead, and the box's own leaves as geometry. Every leaf is in one box or one range. It takes no memory.
        ///
        /// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
        /// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
        /// above 0, at most 1e9. `params` may be NULL, `report` when it is not wanted.
        ///
        /// `TREE_ERROR_PARAMETER` for numbers out of range, `TREE_ERROR_INVALID` when the choice was made for other cards. The
        /// choice is left as it was then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_update(tree_card_choice* choice, tree_cards* cards, float* eye, float pixels_per_metre, tree_card_choose_params* @params, tree_card_choice_report* report);

        /// <summary>
        /// Tells how much is drawn since the last update. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_measure(tree_card_choice* choice, tree_card_choice_report* report);

        /// <summary>
        /// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
        /// `n_boxes` of the report; as many as there are boxes are always enough.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_boxes(tree_card_choice* choice, uint* boxes, UIntPtr capacity);

        /// <summary>
        /// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined. `ranges` has room for `capacity` of
        /// them, at least `n_ranges` of the report; as many as there are boxes are always enough.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_ranges(tree_card_choice* choice, tree_leaf_range* ranges, UIntPtr capacity);

        /// <summary>
        /// Frees a choice.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_choice_free(tree_card_choice* choice);

        /// <summary>
        /// The place on the unit square of `direction`, three floats to the viewer, of any length. With `hemi`, directions below
        /// the horizon are brought up to it. `TREE_ERROR_PARAMETER` for a direction that is zero or not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_encode(float* direction, uint hemi, float* place);

        /// <summary>
        /// The unit direction of `place`, two floats on the unit square: the inverse of `tree_octahedral_encode`.
        /// `TREE_ERROR_PARAMETER` for a place outside the square.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_decode(float* place, uint hemi, float* direction);

        /// <summary>
        /// Writes the three views around `direction`, three floats to the viewer, and their weights, which sum to 1 and change
        /// continuously. `grid` and `hemi` are those of the impostor; `frames` has room for `capacity` views, at least 3.
        /// `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64, or a direction that is zero or not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_frames(float* direction, uint grid, uint hemi, tree_octahedral_frame* frames, UIntPtr capacity);

        /// <summary>
        /// Where a view was taken from: unit vectors to the right of the picture, up it, and to the viewer. Up is as near to +Y
        /// as it can be; seen from straight above or below, right is +X. `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64,
        /// or a column or row that it lacks.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_axes(uint column, uint row, uint grid, uint hemi, float* right, float* up, float* toward);

        /// <summary>
        /// A picture and its smaller levels, each half as wide and high (rounded down, at least 1): at most `most` in all, and at
        /// least the picture itself. Colours are means in linear light, weighted by alpha. Alpha is the mean, scaled so
        /// that the share of texels that pass a test against one half stays as in the first level: leaves do not vanish from
        /// afar. It is for colours, not for `TREE_IMPOSTOR_DETAIL`. `control` may be NULL; `pixels` of its limits caps twice
        /// those of the picture. Free the levels with `tree_mips_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mips_of_picture(tree_picture* picture, UIntPtr most, tree_control* control, tree_mips** mips);

        /// <summary>
        /// Number of levels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mips_count(tree_mips* mips, UIntPtr* n_levels);

        /// <summary>
        /// Views the pixels of level `number`; 0 is the picture itself. Set `pixels-&gt;struct_size` first.
        /// `TREE_ERROR_PARAMETER` when there is no such level.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mips_view(tree_mips* mips, UIntPtr number, tree_pixels* pixels);

        /// <summary>
        /// Frees levels, and with them all views of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mips_free(tree_mips* mips);

        /// <summary>
        /// Bakes all of a mesh, leaves and wood. `params` and `control` may be NULL, `report` when it is not wanted. Progress is
        /// told in the stage `views`. The same input gives the same bytes for any number of threads. Free the impostor with
        /// `tree_octahedral_free`.
        ///
        /// `TREE_ERROR_INVALID` when nothing of the mesh can be seen or all of it is one point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_bake(tree_mesh* mesh, tree_octahedral_params* @params, tree_control* control, tree_octahedral_report* report, tree_octahedral** octahedral);

        /// <summary>
        /// An impostor that was baked before: its numbers and its two pictures, which are copied. `control` may be NULL; `pixels`
        /// of its limits caps those of both. What `tree_octahedral_measure` tells of it is 0, but for the bytes. Free it with
        /// `tree_octahedral_free`. `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` when the parts do not fit each other.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_from_pictures(tree_octahedral_meta* meta, tree_picture* color, tree_picture* detail, tree_control* control, tree_octahedral** octahedral);

        /// <summary>
        /// Tells what was baked. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_measure(tree_octahedral* octahedral, tree_octahedral_report* report);

        /// <summary>
        /// The numbers that go with the pictures. Set `meta-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_describe(tree_octahedral* octahedral, tree_octahedral_meta* meta);

        /// <summary>
        /// The numbers that go with the pictures as JSON, to be stored beside them; they are read as the same bits. Free the
        /// bytes with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_to_json(tree_octahedral* octahedral, tree_bytes** bytes);

        /// <summary>
        /// Views the pixels of one of the two pictures, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
        /// `TREE_IMPOSTOR_DETAIL` goes from minus the `radius` to it, towards the viewer. Set `pixels-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_pixels(tree_octahedral* octahedral, uint map, tree_pixels* pixels);

        /// <summary>
        /// A copy of one of the two pictures, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`.
        /// `map` is a `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_picture(tree_octahedral* octahedral, uint map, tree_control* control, tree_picture** picture);

        /// <summary>
        /// What a camera sees, by one ray for each pixel: sRGB colour without light, and alpha, to be tested against one half or
        /// blended. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
        /// (`tree_view_place` helps); for a framed one `TREE_ERROR_INVALID`. `control` may be NULL. Free the picture with
        /// `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_view(tree_octahedral* octahedral, tree_view* view, tree_control* control, tree_picture** picture);

        /// <summary>
        /// Alpha alone, as `tree_octahedral_view`. Free the mask with `tree_mask_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_mask(tree_octahedral* octahedral, tree_view* view, tree_control* control, tree_mask** mask);

        /// <summary>
        /// The functions that draw an octahedral impostor in a shader, as `tree_octahedral_view` does it: text to be put into your
        /// own. It tells what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never
        /// freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_shader(uint language, tree_str* text);

        /// <summary>
        /// Frees an impostor, and with it all views of its pixels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_free(tree_octahedral* octahedral);

        /// <summary>
        /// Checks that the numbers fit each other: `TREE_ERROR_PARAMETER` names the first that is out of range,
        /// `TREE_ERROR_INVALID` says what is wrong with `detail_side`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_meta_check(tree_octahedral_meta* meta);

        /// <summary>
        /// Half width and half height in metres of a view whose direction to the viewer, of unit length, has this `y`, and half
        /// the depth of the tree in it: what the cylinder around it fills.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_meta_extent(tree_octahedral_meta* meta, float y, float* half, float* reach);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_params_init(tree_octahedral_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_octahedral_params_check(tree_octahedral_params* @params);

        /// <summary>
        /// The weights of the six planes of a box: `half` is three floats, half its sides, `direction` three floats, to the viewer
        /// along the box's own axes (turned by the inverse of its `turn`), of any length. They sum to 1 and change
        /// continuously; a plane seen edge-on has none. `TREE_ERROR_INVALID` for a direction that is zero or not finite, or half
        /// sides that are not all above 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_weights(float* half, float* direction, float* weights);

        /// <summary>
        /// The part of 0 to 1 that belongs to a plane, 0 to 5, given the six `weights`: as long as its weight, after those of the
        /// planes before it. A pixel draws the plane in whose interval its `tree_card_noise` lies.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_interval(float* weights, uint plane, float* interval);

        /// <summary>
        /// A pattern over pixels, 0 to 1, nearly even in each neighbourhood of 3 by 3: `pixel` is two floats, its middle as a
        /// shader is told it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_card_noise(float* pixel, float* share);

        /// <summary>
        /// Divides a tree into a base mesh and instances of at most `twigs_max` unique twigs. Light-map
        /// coordinates are left out, since instances share their vertices. `look` may be NULL: the built-in
        /// textures that the tree's species names. `mesh_params`, `params` and `report` may be NULL. Free the twigs
        /// with `tree_twigs_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_build(tree_tree* tree, tree_look* look, tree_mesh_params* mesh_params, tree_instancing_params* @params, ulong seed, tree_control* control, tree_instancing_report* report, tree_twigs** twigs);

        /// <summary>
        /// Number of unique twigs.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_count(tree_twigs* twigs, UIntPtr* n_twigs);

        /// <summary>
        /// What the twigs weigh and how near they come. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_report(tree_twigs* twigs, tree_instancing_report* report);

        /// <summary>
        /// The base mesh: wood and leaves that are not part of a twig, surfaces as `tree_mesh_build` makes them.
        /// Not copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_base(tree_twigs* twigs, tree_mesh** @base);

        /// <summary>
        /// The mesh of twig `number`, its base at the origin; surfaces and materials as in the base mesh. Not
        /// copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_mesh(tree_twigs* twigs, UIntPtr number, tree_mesh** mesh);

        /// <summary>
        /// Views all places where twig `number` stands. Set `instances-&gt;struct_size` first. Valid until the twigs
        /// are freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_instances(tree_twigs* twigs, UIntPtr number, tree_twig_instances* instances);

        /// <summary>
        /// Makes twigs of parts of your own: a base mesh, and for each of `n_twigs` twigs its mesh, with as many
        /// surfaces as the base, and where it stands. All is copied but the textures, and checked; scales must be
        /// the same along all axes. The report has the sizes; `reach` and `deviation` are 0 in it. `control` may
        /// be NULL; of its limits `triangles` caps those of all meshes together, and `leaves` the instances. Free
        /// the twigs with `tree_twigs_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_from_parts(tree_mesh* @base, tree_mesh** meshes, tree_twig_instances* instances, UIntPtr n_twigs, tree_control* control, tree_twigs** twigs);

        /// <summary>
        /// Makes one plain mesh of base and instances: surfaces as the base has them, with the instances'
        /// triangles behind. Columns that not all parts have, and light-map coordinates, are left out. Every
        /// instance gets branches of its own, carried by the branch it stands on. Free the mesh with
        /// `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_flatten(tree_twigs* twigs, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// Frees twigs. Meshes that were asked of them live on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_twigs_free(tree_twigs* twigs);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_instancing_params_init(tree_instancing_params* @params, UIntPtr size);

        /// <summary>
        /// Views the bytes: where they begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bytes_view(tree_bytes* bytes, byte** data, UIntPtr* len);

        /// <summary>
        /// Frees a file in memory.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bytes_free(tree_bytes* bytes);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_glb_options_init(tree_glb_options* options, UIntPtr size);

        /// <summary>
        /// Writes a mesh to a GLB file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends with
        /// a NUL and `path_len` is `TREE_NUL_TERMINATED`. `options` and `control` may be NULL; of `control`
        /// only threads and limits matter, and a cancellation before the work begins.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_write_glb(tree_mesh* mesh, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// A mesh as a GLB file in memory, as `tree_mesh_write_glb` writes it. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_to_glb(tree_mesh* mesh, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// Writes meshes, instances and levels of detail to a GLB file, whole or not at all.
        ///
        /// Several levels, the finest first, become the nodes of one `MSFT_lod` with their coverages; programs
        /// that do not know it draw the finest. Materials that are equal in several levels are written once.
        /// `options` and `control` may be NULL, as in `tree_mesh_write_glb`; of the limits, `leaves` caps the
        /// copies and `triangles` those of the meshes that are drawn many times, all rows together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_write_glb(tree_gltf_level* levels, UIntPtr n_levels, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// As `tree_gltf_write_glb`, in memory. Free the bytes with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_to_glb(tree_gltf_level* levels, UIntPtr n_levels, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_gltf_write_glb`, but in several files: the `.gltf` file of this path, and beside it the
        /// buffer (`STEM.bin`) and the textures (`STEM_NAME.png`), all or none. Blanks and other trouble in the
        /// stem are replaced by `_` in the names of the files beside.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_write_files(tree_gltf_level* levels, UIntPtr n_levels, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// Builds a tree with one mesh for each kind of leaf instead of a copy for each leaf. Normals of
        /// instanced leaves are those of the leaf itself: the parameters cannot turn them towards the outside of
        /// the crown. `look`, `params` and `control` are as in `tree_mesh_build`. Free the bark with
        /// `tree_mesh_free` and the leaves with `tree_gltf_leaves_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_build_instanced(tree_tree* tree, tree_look* look, tree_mesh_params* @params, tree_control* control, tree_mesh** bark, tree_gltf_leaves** leaves);

        /// <summary>
        /// Views the leaves, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
        /// kinds there are. Their meshes belong to the leaves and are freed with them; `tree_mesh_free` of
        /// one is `TREE_ERROR_ORDER`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_leaves_view(tree_gltf_leaves* leaves, tree_gltf_instances** rows, UIntPtr* n);

        /// <summary>
        /// Frees leaves, and their meshes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_leaves_free(tree_gltf_leaves* leaves);

        /// <summary>
        /// The attributes `_WIND*` of all surfaces of a mesh, for a level of a glTF file: the streams of
        /// `TREE_LAYOUT_GLTF_WIND` that are not glTF's own, four floats each, the missing ones 0, which every
        /// reader takes. For Blender write occlusion as colour or not at all. `control` may be NULL. Free them
        /// with `tree_gltf_attributes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_gltf_wind(tree_mesh* mesh, tree_control* control, tree_gltf_attributes** attributes);

        /// <summary>
        /// Views the attributes, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
        /// there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_attributes_view(tree_gltf_attributes* attributes, tree_gltf_attribute** rows, UIntPtr* n);

        /// <summary>
        /// Frees attributes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gltf_attributes_free(tree_gltf_attributes* attributes);

        /// <summary>
        /// What a note says, for people; the text is there for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_note_text(uint note, tree_str* text);

        /// <summary>
        /// Writes a mesh to an OBJ file (the path is as in `tree_mesh_write_glb`) and beside it the MTL file (`STEM.mtl`) and the textures
        /// (`STEM_NAME.png`), all or none. Blanks and other trouble in the stem are replaced by `_` in the names
        /// of the files beside. Tangents and the other optional columns have no place in OBJ. `control` may be
        /// NULL; only a cancellation before the work begins matters.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_write_obj(tree_mesh* mesh, byte* path, UIntPtr path_len, tree_control* control);

        /// <summary>
        /// The OBJ and MTL files that `tree_mesh_write_obj` would write to `stem.obj` and `stem.mtl`, in memory.
        /// Free both with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_to_obj(tree_mesh* mesh, byte* stem, UIntPtr stem_len, tree_control* control, tree_bytes** obj, tree_bytes** mtl);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_ply_options_init(tree_ply_options* options, UIntPtr size);

        /// <summary>
        /// Writes a mesh to a PLY file (the path is as in `tree_mesh_write_glb`), whole or not at all: all surfaces as one, each vertex with the colour of
        /// its material times the mean of its texture. `options` and `control` may be NULL; of `control` only a
        /// cancellation before the work begins matters.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_write_ply(tree_mesh* mesh, byte* path, UIntPtr path_len, tree_ply_options* options, tree_control* control);

        /// <summary>
        /// As `tree_mesh_write_ply`, in memory. Free the bytes with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_to_ply(tree_mesh* mesh, tree_ply_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_import_options_init(tree_import_options* options, UIntPtr size);

        /// <summary>
        /// Reads a mesh from a file; the path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
        /// `TREE_NUL_TERMINATED`. It is checked before memory is taken for it, and never trusted; what was
        /// left out or changed is in the report. `options`, `control` and `report` may be NULL. Free the mesh
        /// with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_read(byte* path, UIntPtr path_len, tree_import_options* options, tree_control* control, tree_import_report* report, tree_mesh** mesh);

        /// <summary>
        /// Reads a mesh from a file in memory; other files are never read. `format` must be stated. `mtl` is
        /// for OBJ only: the MTL file, or NULL for materials with names only; textures are not read. The bytes
        /// are needed during the call only. `control` and `report` may be NULL. Free the mesh with
        /// `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_from_bytes(uint format, byte* data, UIntPtr len, byte* mtl, UIntPtr mtl_len, tree_control* control, tree_import_report* report, tree_mesh** mesh);

        /// <summary>
        /// `(1 - d)^2` (Cook et al. 2007).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_cook(tree_lod_distance* distance);

        /// <summary>
        /// The least lambda of a measured model that is as good as asked for: a quality of `near` at distance 0, falling
        /// linearly to `far` at distance 1; each 0 to 1, both the same for one that is asked for everywhere.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_for_quality(tree_lod_table* table, float near, float far, tree_lod_distance* distance);

        /// <summary>
        /// The least lambda at which the model of `table` is as good as the one of `cook` is at `(1 - d)^2`: the same
        /// pictures with less geometry. `cook` is measured with `tree_order_stochastic` and `TREE_LOD_SCALE_COOK`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_parity(tree_lod_table* table, tree_lod_table* cook, tree_lod_distance* distance);

        /// <summary>
        /// One of your own samples, at the distances of `tree_lod_distance_places`: `TREE_LOD_DISTANCE_SAMPLES` numbers,
        /// each 0 to 1. A sample above the one before is lowered to it, for geometry must not grow with distance.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_from_samples(float* lambdas, UIntPtr n_lambdas, tree_lod_distance* distance);

        /// <summary>
        /// Writes the distances that are sampled, `TREE_LOD_DISTANCE_SAMPLES` of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_places(float* places, UIntPtr capacity);

        /// <summary>
        /// Lambda at a distance `d`, which is brought into 0 to 1; NaN is far. `TREE_ERROR_PARAMETER` when a sample is not
        /// within 0 to 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_distance_lambda(tree_lod_distance* distance, float d, float* lambda);

        /// <summary>
        /// Divides the foliage of a mesh into elements. `surfaces` names the `n_surfaces` surfaces that may be pruned,
        /// each once. Without any (NULL, 0) they are found: those with anchors of leaves, and where there are none, as
        /// in imported meshes, those whose material is alpha-tested, has two sides or is named after leaves. `grain`
        /// is a `TREE_GRAIN_` constant; blades are a good choice. `control` may be NULL; `triangles` of its limits caps
        /// the triangles. Free the elements with `tree_elements_free`.
        ///
        /// `TREE_ERROR_INVALID` when there is no foliage, or a surface that was named does not exist or is named
        /// twice.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_elements_of_mesh(tree_mesh* mesh, uint* surfaces, UIntPtr n_surfaces, uint grain, tree_control* control, tree_elements** elements);

        /// <summary>
        /// Elements of your own, which are copied: each a row of the columns, as `tree_elements_view` gives them. `mesh` is what
        /// they are elements of. `control` may be NULL; `triangles` of its limits caps elements and triangles. Free the
        /// elements with `tree_elements_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
        /// `n_triangles`, when the mesh lacks a surface or a triangle, or a centre is not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_elements_from_columns(tree_mesh* mesh, tree_elements_columns* columns, tree_control* control, tree_elements** elements);

        /// <summary>
        /// Views elements. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_elements_view(tree_elements* elements, tree_elements_columns* columns);

        /// <summary>
        /// Height in metres of the plant the elements belong to: from the ground at y = 0, where trees are based, to the
        /// highest centre. Of a model that is not based there (something lies below, or all is higher than two crown
        /// heights) the height of the crown. `TREE_ERROR_INVALID` when all elements are one point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_elements_plant_height(tree_elements* elements, float* metres);

        /// <summary>
        /// Frees elements, and with them all views of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_elements_free(tree_elements* elements);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_params_init(tree_hull_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_params_check(tree_hull_params* @params);

        /// <summary>
        /// The surface of a field of metaballs. `params` and `control` may be NULL; `voxels` and `triangles` of its limits
        /// cap the grid and the surface. Free the hull with `tree_hull_free`. `TREE_ERROR_INVALID` when the points stand so
        /// far from the origin that the numbers do not resolve the grid.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_of_metaballs(tree_metaballs* metaballs, tree_hull_params* @params, tree_control* control, tree_hull** hull);

        /// <summary>
        /// The hull of a plant, as `tree_order_combined` makes it: `tree_metaballs_of_elements` and `tree_hull_of_metaballs`
        /// in one, with `height`, `radius` and `hull` of `params`. `params` and `control` may be NULL. Free the hull with
        /// `tree_hull_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_of_elements(tree_elements* elements, tree_order_params* @params, tree_control* control, tree_hull** hull);

        /// <summary>
        /// Views a hull. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_view(tree_hull* hull, tree_hull_columns* columns);

        /// <summary>
        /// A mesh of one surface, for looking at the hull. Free it with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_mesh(tree_hull* hull, tree_mesh** mesh);

        /// <summary>
        /// Chooses `n_samples` places evenly by area: for the visibility of a model in a `tree_scene`, for example.
        /// `positions` and `normals` (unit, outwards) have room for `capacity` and `normals_capacity` floats, at least
        /// `3 * n_samples` each. `control` may be NULL; `nodes` of its limits caps the samples.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_sample(tree_hull* hull, UIntPtr n_samples, ulong seed, tree_control* control, float* positions, UIntPtr capacity, float* normals, UIntPtr normals_capacity);

        /// <summary>
        /// The place of the surface that is nearest to each of `n_points` points, three floats each in metres, or another
        /// that is at most a hundredth farther from it, and the unit normal there. For a point that is not finite, or too
        /// far off (1e18 m) to tell, both are zero. `positions` and `normals` have room for `capacity` and
        /// `normals_capacity` floats, at least `3 * n_points` each. `control` may be NULL; `nodes` of its limits caps the
        /// points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_nearest(tree_hull* hull, float* points, UIntPtr n_points, tree_control* control, float* positions, UIntPtr capacity, float* normals, UIntPtr normals_capacity);

        /// <summary>
        /// Frees a hull, and with it all views of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_hull_free(tree_hull* hull);

        /// <summary>
        /// The pixels that a mesh covers. Of `view`, which may be NULL for the default, camera and width count; it must
        /// be as high as it is wide, 8 to 4096 pixels. `control` may be NULL. Free the mask with `tree_bits_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_of_mesh(tree_mesh* mesh, tree_view* view, tree_control* control, tree_bits** bits);

        /// <summary>
        /// Tells how large a mask is, and how many of its bits are set. Set `found-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_measure(tree_bits* bits, tree_bits_size* found);

        /// <summary>
        /// Writes the words of all rows, from top to bottom, each begun in a word of its own: the pixel at x is bit
        /// `x % 64` of word `x / 64` of its row. `capacity` is at least `n_words` of `tree_bits_measure`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_words(tree_bits* bits, ulong* words, UIntPtr capacity);

        /// <summary>
        /// Writes a byte for each pixel, rows from top to bottom, 255 where it is set. `capacity` is at least
        /// `n_pixels` of `tree_bits_measure`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_bytes(tree_bits* bits, byte* bytes, UIntPtr capacity);

        /// <summary>
        /// Counts the pixels of `bits`, of a simplified model, against those of the `full` one. Masks of different sizes
        /// are compared where they overlap from the top left, by whole words.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_score(tree_bits* bits, tree_bits* full, tree_score* score);

        /// <summary>
        /// Frees a mask.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bits_free(tree_bits* bits);

        /// <summary>
        /// The field of `n_points` points, three floats each in metres, with `radius` metres of influence, 1e-9 to
        /// 1e9. `control` may be NULL; `nodes` of its limits caps the points. Free it with `tree_metaballs_free`.
        /// `TREE_ERROR_INVALID` when there are no points, `TREE_ERROR_PARAMETER` when a number is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_new(float* points, UIntPtr n_points, float radius, tree_control* control, tree_metaballs** metaballs);

        /// <summary>
        /// The field of the centres of all elements that have area. `radius` is a share of `height`, the height of the
        /// plant in metres; 0 for the height that `tree_elements_plant_height` measures. `control` may be NULL. Free it
        /// with `tree_metaballs_free`. `TREE_ERROR_INVALID` when no element has area.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_of_elements(tree_elements* elements, float radius, float height, tree_control* control, tree_metaballs** metaballs);

        /// <summary>
        /// Radius of influence in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_radius(tree_metaballs* metaballs, float* radius);

        /// <summary>
        /// Number of points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_n_points(tree_metaballs* metaballs, UIntPtr* n_points);

        /// <summary>
        /// The box around the points: its lower corner, then its upper one, in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_bounds(tree_metaballs* metaballs, float* min_max);

        /// <summary>
        /// The field at `n_points` points, three floats each in metres; 0 for a point that is not finite. `values` has
        /// room for `capacity` numbers, at least `n_points`. `control` may be NULL; `nodes` of its limits caps the
        /// points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_values(tree_metaballs* metaballs, float* points, UIntPtr n_points, tree_control* control, float* values, UIntPtr capacity);

        /// <summary>
        /// Where the field grows fastest, and how fast per metre, three floats for each of the `n_points` points; zero
        /// outside. `gradients` has room for `capacity` floats, at least `3 * n_points`. Else as `tree_metaballs_values`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_gradients(tree_metaballs* metaballs, float* points, UIntPtr n_points, tree_control* control, float* gradients, UIntPtr capacity);

        /// <summary>
        /// Frees a field. Hulls that were made of it stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metaballs_free(tree_metaballs* metaballs);

        /// <summary>
        /// Makes an order that has nothing to do with place, size, direction or colour: a shuffle (Cook et al. 2007).
        /// `order` has room for `capacity` numbers, at least one for each element; as of all orders, row k is the k-th
        /// most important element, and the first rows are drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_stochastic(tree_elements* elements, ulong seed, uint* order, UIntPtr capacity);

        /// <summary>
        /// Makes an order of which every beginning is evenly spread over the ground, by the golden section (Neubert 2012,
        /// 6.3.2, "drop and resize"). There is no chance in it. `order` as for `tree_order_stochastic`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_golden(tree_elements* elements, uint* order, UIntPtr capacity);

        /// <summary>
        /// Makes an order in which elements of dense places go first, until all places are about as dense; the rest is
        /// stochastic (Neubert 2012, 7.3.2). `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
        /// `TREE_ERROR_INVALID` when no element has area.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_density(tree_elements* elements, tree_order_params* @params, ulong seed, tree_control* control, uint* order, UIntPtr capacity);

        /// <summary>
        /// Makes an order in which elements that do not lie along the hull go first (Neubert 2012, 7.3.3), with
        /// `params-&gt;randomness`. `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_orientation(tree_elements* elements, tree_hull* hull, tree_order_params* @params, ulong seed, tree_control* control, uint* order, UIntPtr capacity);

        /// <summary>
        /// Makes the order by density and orientation together (Neubert 2012, eq. 7.8). It makes field and hull itself.
        /// `params` and `control` may be NULL; `order` as for `tree_order_stochastic`. `TREE_ERROR_INVALID` when no element
        /// has area.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_combined(tree_elements* elements, tree_order_params* @params, ulong seed, tree_control* control, uint* order, UIntPtr capacity);

        /// <summary>
        /// Makes the order that keeps the pixels covered: elements are drawn from many sides, and those come first that
        /// together make the best quality. Where leaves have grown, each chooses the point that it grows about. The best
        /// order of all, and the one that takes longest: some ten drawings of the foliage in every view.
        ///
        /// Elements are drawn as in tier `tier` of `tiers`: 0 is the full model, and NULL, with 0, has no other. For leaves of
        /// many triangles take one of about four triangles each: a quarter of the time, and nearly the same order.
        ///
        /// `params` and `control` may be NULL. `order` as for `tree_order_stochastic`; `pivots`, three floats for each
        /// element (not rank) in metres, has room for `pivots_capacity` floats, at least three for each element.
        /// `TREE_ERROR_INVALID` when the elements or tiers are not of this mesh, `TREE_ERROR_PARAMETER` when there is no such
        /// tier.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_coverage(tree_mesh* mesh, tree_elements* elements, tree_tiers* tiers, UIntPtr tier, tree_coverage_params* @params, tree_control* control, uint* order, UIntPtr capacity, float* pivots, UIntPtr pivots_capacity);

        /// <summary>
        /// Checks that an order of `n_order` rows has each of `n_elements` elements once; `TREE_ERROR_INVALID` names the
        /// first row at fault.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_check(uint* order, UIntPtr n_order, UIntPtr n_elements);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_params_init(tree_order_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_order_params_check(tree_order_params* @params);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_coverage_params_init(tree_coverage_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_coverage_params_check(tree_coverage_params* @params);

        /// <summary>
        /// Tells how large a model is, and the ends of its lambdas. Set `totals-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_measure(tree_pruned* pruned, tree_pruned_totals* totals);

        /// <summary>
        /// The mesh to upload, nothing copied. Its foliage must be drawn by windows, for its index buffers hold leaves several
        /// times. Free it with `tree_mesh_free`; it keeps the model alive.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_mesh(tree_pruned* pruned, tree_mesh** mesh);

        /// <summary>
        /// Views part `number`, rising with the surfaces. Set `part-&gt;struct_size` first. `TREE_ERROR_PARAMETER` when there is
        /// no such part.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_part_view(tree_pruned* pruned, UIntPtr number, tree_pruned_part* part);

        /// <summary>
        /// The scale for each lambda, a table of its own. Free it with `tree_lod_table_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_table(tree_pruned* pruned, tree_lod_table** table);

        /// <summary>
        /// Writes the number of elements with which each tier begins. `kept` has room for `capacity` numbers, at least one for
        /// each tier.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_kept(tree_pruned* pruned, uint* kept, UIntPtr capacity);

        /// <summary>
        /// The most elements that fit `lambda`, 0 to 1, of the full foliage's triangles: at least one, even if it has more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_cut(tree_pruned* pruned, float lambda, tree_lod_cut* cut);

        /// <summary>
        /// A state, counted from the full model, 0, down; from `n_steps` on it is the last.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_step(tree_pruned* pruned, ulong step, tree_lod_cut* cut);

        /// <summary>
        /// The least lambda for which so many triangles may be drawn; 1 for more than there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_lambda_of(tree_pruned* pruned, ulong n_triangles, float* lambda);

        /// <summary>
        /// Lambda from which on an element is drawn: 0 for those that always are, 1 for ranks that do not exist.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_lambda_of_rank(tree_pruned* pruned, uint rank, float* lambda);

        /// <summary>
        /// Frees a model, and with it all views of its parts. Meshes made of it stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_free(tree_pruned* pruned);

        /// <summary>
        /// Makes `screen`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_screen_init(tree_lod_screen* screen, UIntPtr size);

        /// <summary>
        /// Checks every field of `screen`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_screen_check(tree_lod_screen* screen);

        /// <summary>
        /// Share of the screen's height, 0 to 1, that something of `size` metres has where lambda has fallen to `lambda`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_screen_coverage(tree_lod_screen* screen, float lambda, float size, float* coverage);

        /// <summary>
        /// A model as a GLB file in memory, for engines that draw windows: foliage with all tiers in its index buffers, and an
        /// attribute `_TREE_CENTER` of 4 floats a vertex, as in `tree_pruned_part`. The levels go beside it, as
        /// `tree_pruned_to_json`. Programs that draw all of it draw leaves several times. `options` and `control` may be NULL,
        /// as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for `quantize`: shaders
        /// need positions in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_to_glb(tree_pruned* pruned, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_pruned_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_write_glb(tree_pruned* pruned, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// Levels for `n_lambdas` falling lambdas, each 0 to 1 and at most 1024 of them, as the `MSFT_lod` of one GLB file,
        /// each a mesh of its own: for programs without shaders of ours. A level is shown until the lambda of the distance
        /// has fallen to that of the next one; the last is shown to the end. `screen`, `options` and `control` may be NULL.
        /// Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no lambdas or they do not fall.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_to_glb_levels(tree_pruned* pruned, float* lambdas, UIntPtr n_lambdas, tree_lod_screen* screen, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_pruned_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_write_glb_levels(tree_pruned* pruned, float* lambdas, UIntPtr n_lambdas, tree_lod_screen* screen, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// What is drawn for `lambda`, 0 to 1: at most so much of the full foliage, but at least one element. `windows` has
        /// room for `capacity` of them, at least `n_parts` of `tree_pruned_measure`: one for each part, in their order. It is
        /// quick enough for every frame.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_level(tree_pruned* pruned, float lambda, tree_lod_level* level, tree_lod_window* windows, UIntPtr capacity);

        /// <summary>
        /// `n` levels, 2 to 1024, with rising lambda: from the first of the table to the full model, in equal ratios. `levels`
        /// has room for `levels_capacity` of them, at least `n`; `windows` for `windows_capacity`, at least `n` times the
        /// parts: those of the first level, then those of the next. `n_levels` says how many there are: fewer than `n` where
        /// the table begins at 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_levels(tree_pruned* pruned, UIntPtr n, tree_lod_level* levels, UIntPtr levels_capacity, tree_lod_window* windows, UIntPtr windows_capacity, UIntPtr* n_levels);

        /// <summary>
        /// The level for `lambda`, 0 to 1, as a plain mesh, wood included: elements scaled as the shader does, what is not
        /// drawn left out. Nothing fades in it. Free it with `tree_mesh_free`. `control` may be NULL; of it only threads
        /// matter, and a cancellation before the work begins.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_mesh_at(tree_pruned* pruned, float lambda, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// As `tree_pruned_mesh_at`, for a level with its `n_windows` windows, which may fade. `TREE_ERROR_INVALID` when
        /// they are of another model.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_mesh_of(tree_pruned* pruned, tree_lod_level* level, tree_lod_window* windows, UIntPtr n_windows, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// Levels as JSON, to be stored beside the mesh: counts, the surface and colour of each part, the table, and for
        /// each level its numbers and windows. `levels` and `windows` as `tree_pruned_levels` writes them. Free the bytes,
        /// which are UTF-8, with `tree_bytes_free`. `TREE_ERROR_PARAMETER` when there are not as many windows as levels
        /// times parts.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_to_json(tree_pruned* pruned, tree_lod_level* levels, UIntPtr n_levels, tree_lod_window* windows, UIntPtr n_windows, tree_bytes** bytes);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_params_init(tree_prune_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_params_check(tree_prune_params* @params);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_make_params_init(tree_prune_make_params* @params, UIntPtr size);

        /// <summary>
        /// Makes a pruned model of a mesh, all steps in one call: elements, tiers, order by coverage, plan, table and model.
        /// Some seconds for half a million triangles. `params` and `control` may be NULL; `triangles` of its limits caps those
        /// of all tiers together. Free the model with `tree_pruned_free`. `TREE_ERROR_INVALID` when there is no foliage.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_make(tree_mesh* mesh, tree_prune_make_params* @params, tree_control* control, tree_pruned** pruned);

        /// <summary>
        /// Makes a pruned model of what its steps have made: the subject with its order, pivots, tiers and plan, and `table`
        /// with the scale for each lambda. Surfaces of foliage keep their vertices and columns, their index buffers hold the
        /// triangles of all tiers; vertices that several elements share are doubled, and such a surface loses its anchors.
        /// `params` and `control` may be NULL. Free the model with `tree_pruned_free`.
        ///
        /// `TREE_ERROR_INVALID` when the parts of the subject do not belong together, or pivots are not finite;
        /// `TREE_ERROR_PARAMETER` for foliage further than 1000 km from the origin, or a `kept` that rises.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_new(tree_lod_subject* subject, tree_lod_table* table, tree_prune_params* @params, tree_control* control, tree_pruned** pruned);

        /// <summary>
        /// The model for a scene, with `n` levels, 2 to 1024, as `tree_pruned_levels` makes them: a draw for every surface,
        /// wood included, all surfaces one after another in one vertex buffer and one index buffer. `distance` says how lambda
        /// falls, NULL for that of `tree_lod_distance_cook`. Free the levels with `tree_scene_levels_free`.
        ///
        /// `TREE_ERROR_INVALID` when the model has more than 64 surfaces, or one buffer cannot hold them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pruned_scene_levels(tree_pruned* pruned, UIntPtr n, tree_lod_distance* distance, tree_scene_levels** levels);

        /// <summary>
        /// Makes `model` one of these levels, with sphere and distance; points for occlusion, occluders, `near` and `far` are
        /// left at their defaults, for you to set. Set `model-&gt;struct_size` first. It borrows from the levels: make the scene
        /// before they are freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_levels_model(tree_scene_levels* levels, tree_scene_model* model);

        /// <summary>
        /// Frees levels; no model may point at them any more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_levels_free(tree_scene_levels* levels);

        /// <summary>
        /// The functions `tree_prune_position` and `tree_prune_color` for a shader: text to be put into your own. It tells
        /// what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_shader(uint language, tree_str* text);

        /// <summary>
        /// Where a shader draws a vertex: `vertex`, three floats, moved from the centre of its element by `growth` (a factor on
        /// length), and towards it where the element fades. `center_rank` is four floats of `tree_pruned_part.centers`, the
        /// rest is of a level. For shaders of your own, and for checking them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_position(float* vertex, float* center_rank, float growth, float lambda, float fade, float* drawn);

        /// <summary>
        /// The linear colour that a shader gives a leaf, before light: `rgb`, three floats, with its contrast lowered, so that
        /// few large leaves look no more mottled than many small ones. `mean` is that of the part.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_prune_color(float* rgb, float* mean, float contrast, float* drawn);

        /// <summary>
        /// Scale after Cook et al. (2007): `1 / lambda`, a factor on area, so that the summed area stays. `lambda` is a
        /// share of geometry, more than 0; of 0 and less the scale is that of the smallest number.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_cook_scale(float lambda, float* scale);

        /// <summary>
        /// Share of geometry after Cook et al. (2007), `(1 - d)^2`, for a distance `d`, which is brought into 0 to 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_cook_lambda(float d, float* lambda);

        /// <summary>
        /// Share of geometry by size on the screen (Cook et al. 2007; Neubert 2012, 6.3.2): 1 where the bounding box is
        /// `full` pixels large or more, a half at `h * full`, and so on. `pixels` is its size now, 0 to 1e9; `full` 0.001 to
        /// 1e9, `h` 0.001 to 0.999: `TREE_ERROR_PARAMETER` outside.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_size_lambda(float pixels, float full, float h, float* lambda);

        /// <summary>
        /// Factor on *length* of `k` elements left of `n` (Deussen and Lintermann 2004; Neubert 2012, eq. 6.4 with the sign
        /// set right): `w * sqrt(n / k) + (1 - w)`, `w` from 0 (nothing grows) to 1 (area is kept). `TREE_ERROR_PARAMETER`
        /// for another `w`, or a `k` outside 1 to `n`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_drop_and_resize(uint n, uint k, float w, float* growth);

        /// <summary>
        /// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007) when a share of
        /// `lambda` of the elements is drawn, each `scale` times as large in area: `1 / (scale * sqrt(lambda))`, at most 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_contrast(float lambda, float scale, float* contrast);

        /// <summary>
        /// What a score is worth (Neubert 2012, eq. 7.3 to 7.7). `precision` is the share of the simplified model's pixels
        /// that are right, `recall` the share of the full model's pixels that are there, both 0 to 1, and 1 when there
        /// are none. `quality` is `1 - sqrt((1 - precision)^2 + (1 - recall)^2)`: 1 is perfect, 0 and less is useless.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_score_quality(tree_score* score, double* precision, double* recall, double* quality);

        /// <summary>
        /// Mean of the qualities of several views: what a table says of a model. 0 of none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_score_mean_quality(tree_score* scores, UIntPtr n_scores, double* quality);

        /// <summary>
        /// Scores of a simplified mesh against the full one, one for each view; both are framed as the full one is.
        /// `around`, NULL for the default, says from where to look; `scores` has room for `capacity` scores, at least
        /// `tree_around_n_views`. `control` may be NULL; `pixels` of its limits caps those of all views.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_score(tree_mesh* simplified, tree_mesh* full, tree_around* around, tree_control* control, tree_score* scores, UIntPtr capacity);

        /// <summary>
        /// Makes a scene of `n_models` models and `n_instances` instances, which are copied and numbered as they come.
        /// `control` may be NULL; `nodes` of its limits caps the instances. Free the scene with `tree_scene_free`. The text
        /// of an error names the first model or instance that is not right: `TREE_ERROR_INVALID`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_new(tree_scene_model* models, UIntPtr n_models, tree_scene_instance* instances, UIntPtr n_instances, tree_control* control, tree_scene** scene);

        /// <summary>
        /// Moves instances, or gives them other models: those from number `first` on become the `n_instances` given, all of
        /// them, or on an error none. Between frames: what was selected before holds the old ones. They keep their
        /// place in the order of drawing; when most move far, a new scene is faster to look through.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_set_instances(tree_scene* scene, UIntPtr first, tree_scene_instance* instances, UIntPtr n_instances);

        /// <summary>
        /// Tells how large a scene is, and how large the buffers for it must be. Set `needs-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_measure(tree_scene* scene, tree_scene_needs* needs);

        /// <summary>
        /// Frees a scene.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_free(tree_scene* scene);

        /// <summary>
        /// Makes a state for one view of `scene`, or of another scene with as many instances and the same models: 32 bytes for
        /// each instance, and 144 KiB. `control` may be NULL; `nodes` of its limits caps the instances. It does not keep the
        /// scene alive. Free it with `tree_scene_state_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_new(tree_scene* scene, tree_control* control, tree_scene_state** state);

        /// <summary>
        /// Number of the instances that were in view in the last frame: rows of `tree_instance_lod` that it needs.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_n_drawn(tree_scene_state* state, UIntPtr* n_drawn);

        /// <summary>
        /// How an instance of `scene` was drawn in the last frame; not in view when there is no such instance.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_shown(tree_scene_state* state, tree_scene* scene, UIntPtr instance, tree_scene_shown* shown);

        /// <summary>
        /// Frees a state.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_free(tree_scene_state* state);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_params_init(tree_scene_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_params_check(tree_scene_params* @params);

        /// <summary>
        /// Makes `frame`, of `size` bytes, the default: its matrices must be set.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_frame_init(tree_scene_frame* frame, UIntPtr size);

        /// <summary>
        /// Checks a camera, two matrices as in `tree_scene_frame`, and tells whether near things have the greater depth, 1 or
        /// 0. `TREE_ERROR_PARAMETER` names the matrix that is none of a camera.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_eye_check(float* view, float* projection, uint* is_reversed);

        /// <summary>
        /// Finds what of `scene` is in view, and how finely it is drawn. `state` keeps it for `tree_scene_state_draws` and
        /// `tree_scene_state_batches`. `params` may be NULL for the defaults, `report` when it is not wanted. It takes about 100 ns
        /// for each instance in view, and no memory.
        ///
        /// `TREE_ERROR_PARAMETER` for matrices that are no camera and numbers out of range, `TREE_ERROR_INVALID` for a depth
        /// buffer of the wrong size and for a state of another scene. The state is left as it was then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_select(tree_scene_state* state, tree_scene* scene, tree_scene_frame* frame, tree_scene_params* @params, tree_scene_report* report);

        /// <summary>
        /// Makes `model`, of `size` bytes, the default: a sphere of 1 m without levels, which are to be set.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_model_init(tree_scene_model* model, UIntPtr size);

        /// <summary>
        /// Checks every number of `model`; the text of an error tells what is at fault and what would be right.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_model_check(tree_scene_model* model);

        /// <summary>
        /// Writes a draw for each part of each instance in view, and a row for each instance: for multi-draw indirect. Draws
        /// of an instance follow one another; parts without indices are left out. `draws` and `rows` have room for
        /// `draws_capacity` and `rows_capacity` of them; `tree_scene_measure` says how many always suffice. `n_draws` and
        /// `n_rows` say how many were written. It takes no memory.
        ///
        /// `TREE_ERROR_BUFFER` when a buffer is too small; its text says how many are needed, and nothing is written then.
        /// Buffers may be mapped memory of a graphics processor: they are written once, in order, and not read.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_draws(tree_scene_state* state, tree_scene* scene, tree_draw_indexed* draws, UIntPtr draws_capacity, tree_instance_lod* rows, UIntPtr rows_capacity, UIntPtr* n_draws, UIntPtr* n_rows);

        /// <summary>
        /// As `tree_scene_state_draws`, with one draw for each part of all instances of the same model at the same level: fewer
        /// draws, of many instances each. Rows are not written in order.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_scene_state_batches(tree_scene_state* state, tree_scene* scene, tree_draw_indexed* draws, UIntPtr draws_capacity, tree_instance_lod* rows, UIntPtr rows_capacity, UIntPtr* n_draws, UIntPtr* n_rows);

        /// <summary>
        /// Makes `subject`, of `size` bytes, the default: its mesh, elements and order must be set.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_subject_init(tree_lod_subject* subject, UIntPtr size);

        /// <summary>
        /// Scores of a pruned model against the full one, one for each view: with a share of `lambda` of the
        /// foliage's triangles, 0 to 1, and elements grown to `scale` times their area, 0.01 to 10,000 (lengths grow by
        /// its square root). `around` says from where to look, NULL for the default; `scores` has room for `capacity`
        /// scores, at least `tree_around_n_views`. `control` may be NULL.
        ///
        /// `TREE_ERROR_INVALID` when the parts of the subject do not belong together,
        /// `TREE_ERROR_PARAMETER` names what is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_subject_score(tree_lod_subject* subject, float lambda, float scale, tree_around* around, tree_control* control, tree_score* scores, UIntPtr capacity);

        /// <summary>
        /// Finds when outlines should become simpler, and when elements should go: writes the number of elements with which
        /// each tier should begin, for `kept` of a subject. Tiers that are better left out begin with one. `kept` has room
        /// for `capacity` numbers, at least one for each tier of the subject (1 where it has none); what the subject has as
        /// `kept` is not looked at. It takes about as long as a table for each tier. `control` may be NULL.
        ///
        /// `TREE_ERROR_INVALID` when the parts of the subject do not belong together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_plan(tree_lod_subject* subject, tree_control* control, uint* kept, UIntPtr capacity);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_params_init(tree_lod_table_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range, and lambdas
        /// that do not rise to 1 are `TREE_ERROR_INVALID`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_params_check(tree_lod_table_params* @params);

        /// <summary>
        /// A table of `n_rows` rows, which are copied: of a model that was measured before. Free it with
        /// `tree_lod_table_free`. `TREE_ERROR_INVALID` when there are no rows, when lambda does not rise, leaves 0 to 1
        /// or does not end at 1, or when a number is not finite or a scale not positive; its text names the row.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_from_rows(tree_lod_row* rows, UIntPtr n_rows, tree_lod_table** table);

        /// <summary>
        /// Measures a table: for every lambda the pruned model is drawn into masks from all sides, at several scales,
        /// and compared with the full one; the scale of best mean quality is kept. It takes about ten drawings of
        /// lambda times the triangles for each lambda and view. `params` and `control` may be NULL. Free the table
        /// with `tree_lod_table_free`.
        ///
        /// `TREE_ERROR_INVALID` when the parts of the subject do not belong together; see
        /// `tree_lod_table_params_check` for the rest.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_measure(tree_lod_subject* subject, tree_lod_table_params* @params, tree_control* control, tree_lod_table** table);

        /// <summary>
        /// The rows of a table. They stay for as long as the table does.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_rows(tree_lod_table* table, tree_lod_row** rows, UIntPtr* n_rows);

        /// <summary>
        /// The row for a lambda, interpolated linearly; lambda is brought into the range of the table.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_at(tree_lod_table* table, float lambda, tree_lod_row* row);

        /// <summary>
        /// The least lambda from which on the quality is at least `quality`; 1 when only the full model is so good.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_lambda_for(tree_lod_table* table, float quality, float* lambda);

        /// <summary>
        /// Frees a table, and with it all views of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lod_table_free(tree_lod_table* table);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_params_init(tree_tiers_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_params_check(tree_tiers_params* @params);

        /// <summary>
        /// Makes the tiers of a model: its elements, and the same with fewer and fewer triangles. No element has more
        /// triangles in a later tier than in an earlier one. It takes 5 to 10 ms for each distinct shape of 16 triangles.
        /// `params` and `control` may be NULL; `triangles` of its limits caps those of all tiers together. Free the tiers
        /// with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of this mesh.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_of_mesh(tree_mesh* mesh, tree_elements* elements, tree_tiers_params* @params, tree_control* control, tree_tiers** tiers);

        /// <summary>
        /// The full model as the only tier. Free it with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of
        /// this mesh.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_full(tree_mesh* mesh, tree_elements* elements, tree_tiers** tiers);

        /// <summary>
        /// Tiers of your own, which are copied: the finest first, each as `tree_tiers_view` gives it. `mesh` and `elements` are
        /// what they are tiers of. `control` may be NULL; `triangles` of its limits caps the triangles of each. Free the tiers
        /// with `tree_tiers_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
        /// `n_triangles`, has no row for each element and one more, or a surface lacks a vertex.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_from_columns(tree_mesh* mesh, tree_elements* elements, tree_tier_columns* columns, UIntPtr n_columns, tree_control* control, tree_tiers** tiers);

        /// <summary>
        /// Number of tiers, at least 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_count(tree_tiers* tiers, UIntPtr* n_tiers);

        /// <summary>
        /// Views tier `tier`; 0 is the full model. Set `columns-&gt;struct_size` first. `TREE_ERROR_PARAMETER` when there is no
        /// such tier.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_view(tree_tiers* tiers, UIntPtr tier, tree_tier_columns* columns);

        /// <summary>
        /// Frees tiers, and with them all views of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tiers_free(tree_tiers* tiers);

        /// <summary>
        /// Makes `around`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_init(tree_around* around, UIntPtr size);

        /// <summary>
        /// Makes `around`, of `size` bytes, the views from which `tree_order_coverage` looks at a model whose foliage has
        /// so many triangles: 12 azimuths at pitches of 0 and 0.35 with 256 pixels, and fewer and smaller ones for a
        /// large model. Its pitches are never freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_for_order(tree_around* around, UIntPtr size, UIntPtr n_triangles);

        /// <summary>
        /// Makes `around`, of `size` bytes, the views from which `tree_lod_table_measure` looks at a model whose foliage
        /// has so many triangles: 8 azimuths, level, with 256 pixels, and fewer and smaller ones for a large model.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_for_table(tree_around* around, UIntPtr size, UIntPtr n_triangles);

        /// <summary>
        /// Checks every number of `around`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_check(tree_around* around);

        /// <summary>
        /// Number of the views: azimuths times pitches.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_n_views(tree_around* around, UIntPtr* n_views);

        /// <summary>
        /// View `number` (0 is the first), for pictures and masks from there: a framed camera, as wide and high as the
        /// masks. Set `view-&gt;struct_size` first. `TREE_ERROR_PARAMETER` when there is no such view.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_around_view(tree_around* around, UIntPtr number, tree_view* view);

        /// <summary>
        /// Makes a look of the built-in bark and leaf textures that the species names; NULL is an oak.
        /// `TREE_ERROR_UNKNOWN_NAME` for a name that is not built in: dress such species with `tree_look_plain`
        /// or textures of your own. Free the look with `tree_look_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_built_in(tree_species* species, tree_look** look);

        /// <summary>
        /// Makes a look of plain colours without textures, for a species; NULL is an oak. For previews, tests and
        /// engines that bring their own materials. Leaf cards show as whole rectangles. Free the look with
        /// `tree_look_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_plain(tree_species* species, tree_look** look);

        /// <summary>
        /// As `tree_look_built_in`, for the species of a tree; with `plain` other than 0 as `tree_look_plain`. Free
        /// the look with `tree_look_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_of_tree(tree_tree* tree, uint plain, tree_look** look);

        /// <summary>
        /// Makes a look of your own: `bark` goes on all wood (NULL is the default material), and `leaves` has one
        /// row for each of the species' leaf kinds, in that order. All is copied but the textures, which are
        /// shared. `control` may be NULL; only its limits matter. Free the look with `tree_look_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_new(tree_material* bark, tree_leaf_look* leaves, UIntPtr n_leaves, tree_control* control, tree_look** look);

        /// <summary>
        /// Makes a look that is as another but for the leaves of kind `kind`. Textures are shared; the other look stays as it is.
        /// `control` may be NULL; only its limits matter. Free the new look with `tree_look_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_with_leaf(tree_look* look, UIntPtr kind, tree_leaf_look* leaf, tree_control* control, tree_look** changed);

        /// <summary>
        /// Number of leaf kinds that a look dresses; it has one material more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_leaf_count(tree_look* look, UIntPtr* n_leaves);

        /// <summary>
        /// Views a material of a look, numbered as in the meshes it dresses: 0 is the bark's, 1 + k that of leaf
        /// kind k. Set `material-&gt;struct_size` first. Valid until the look is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_material(tree_look* look, UIntPtr number, tree_material* material);

        /// <summary>
        /// A handle of the texture of a look's material, numbered as for `tree_look_material`; the pixels are
        /// shared. NULL, and no error, where the material has none. Free it with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_texture(tree_look* look, UIntPtr number, tree_texture** texture);

        /// <summary>
        /// Views the look of leaf kind `kind`, but for its material and its mesh, which `tree_look_material` and
        /// `tree_look_leaf_mesh` view. Set `leaf-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_leaf(tree_look* look, UIntPtr kind, tree_leaf_look* leaf);

        /// <summary>
        /// Checks that a look has one leaf look for each leaf kind of the species (NULL is an oak).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_check(tree_look* look, tree_species* species);

        /// <summary>
        /// Frees a look. Meshes that were built with it keep their textures.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_free(tree_look* look);

        /// <summary>
        /// Makes `style`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bark_style_init(tree_bark_style* style, UIntPtr size);

        /// <summary>
        /// The style of a built-in bark, to be changed; what it points at is valid for ever. Set
        /// `style-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bark_style_of(byte* name, UIntPtr name_len, tree_bark_style* style);

        /// <summary>
        /// Draws a bark of your own, which tiles without a seam; its name is `bark`. `style` may be NULL; `size` is
        /// as for `tree_texture_bark`. Free the texture with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_bark_with(tree_bark_style* style, uint size, tree_control* control, tree_texture** texture);

        /// <summary>
        /// Makes `look`, of `size` bytes, the default: a square card.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_look_init(tree_leaf_look* look, UIntPtr size);

        /// <summary>
        /// Makes the mesh of one leaf of kind `kind`. `report` may be NULL. Free the model with
        /// `tree_leaf_model_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_leaf_model(tree_look* look, UIntPtr kind, tree_control* control, tree_leaf_model_report* report, tree_leaf_model** model);

        /// <summary>
        /// Views the columns of a leaf's mesh. Set `mesh-&gt;struct_size` first. Valid until the model is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_model_view(tree_leaf_model* model, tree_leaf_mesh* mesh);

        /// <summary>
        /// Frees a leaf's mesh.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_model_free(tree_leaf_model* model);

        /// <summary>
        /// Views the leaf of your own that kind `kind` of a look has; without vertices where its form is not
        /// `TREE_LEAF_MESH`. Set `mesh-&gt;struct_size` first. Valid until the look is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_look_leaf_mesh(tree_look* look, UIntPtr kind, tree_leaf_mesh* mesh);

        /// <summary>
        /// Makes `shape`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_shape_init(tree_leaf_shape* shape, UIntPtr size);

        /// <summary>
        /// The shape of a built-in leaf, to be changed; what it points at is valid for ever. Set
        /// `shape-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_shape_of(byte* name, UIntPtr name_len, tree_leaf_shape* shape);

        /// <summary>
        /// Turns the colours of a shape to those of autumn: `progress` 0 is summer and changes nothing, 1 is fully
        /// turned.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_shape_autumn(tree_leaf_shape* shape, float progress);

        /// <summary>
        /// Draws a leaf of your own, upright with the base at the bottom centre; its name is `leaf`. `shape` and
        /// `card` may be NULL; `size` and `card` are as for `tree_texture_leaf`. Free the texture with
        /// `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_leaf_with(tree_leaf_shape* shape, uint size, tree_control* control, tree_leaf_card* card, tree_texture** texture);

        /// <summary>
        /// Makes `material`, of `size` bytes, the default: white, matt, without texture.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_material_init(tree_material* material, UIntPtr size);

        /// <summary>
        /// Views the names of the built-in barks: where they begin and how many there are. Valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bark_names(tree_str** names, UIntPtr* n_names);

        /// <summary>
        /// Views the names of the built-in leaves (single ones, clusters, needles and fronds): where they begin
        /// and how many there are. Valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_names(tree_str** names, UIntPtr* n_names);

        /// <summary>
        /// Makes a texture of pixels, which are copied. `control` may be NULL; only its limits matter. Free the
        /// texture with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_from_pixels(tree_texture_pixels* pixels, tree_control* control, tree_texture** texture);

        /// <summary>
        /// Makes a texture of a PNG or JPEG file in memory, recognised by its content. A photograph is turned
        /// upright as its camera noted. `TREE_ERROR_LIMIT` when file or picture are larger than the limits
        /// `input_bytes` and `pixels` allow, before it is decoded. Free the texture with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_from_bytes(byte* name, UIntPtr name_len, byte* data, UIntPtr len, tree_control* control, tree_texture** texture);

        /// <summary>
        /// As `tree_texture_from_bytes`, of a file on disk. The texture is named after the file. Free it with
        /// `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_read(byte* path, UIntPtr path_len, tree_control* control, tree_texture** texture);

        /// <summary>
        /// Draws a built-in bark, which tiles without a seam; `tree_bark_names` has the names. `size` is width and
        /// height in pixels, 16 to 4096, or 0 for 512. Free the texture with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_bark(byte* name, UIntPtr name_len, uint size, tree_control* control, tree_texture** texture);

        /// <summary>
        /// Draws a built-in leaf, upright with the base at the bottom centre; `tree_leaf_names` has the names.
        /// Transparent pixels carry the colour of the leaf near them; meant for an alpha cutoff of 0.5. `size` is
        /// width and height in pixels, 16 to 4096, or 0 for 256, and 512 for clusters, needles and fronds. `card`
        /// says how to put it on a card; it may be NULL. Free the texture with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_leaf(byte* name, UIntPtr name_len, uint size, tree_control* control, tree_leaf_card* card, tree_texture** texture);

        /// <summary>
        /// Views a texture's name and pixels. Set `pixels-&gt;struct_size` first. Valid until the texture is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_view(tree_texture* texture, tree_texture_pixels* pixels);

        /// <summary>
        /// Makes a PNG file in memory of a texture. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_to_png(tree_texture* texture, tree_bytes** png);

        /// <summary>
        /// Writes a texture as a PNG file, whole or not at all.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_write_png(tree_texture* texture, byte* path, UIntPtr path_len);

        /// <summary>
        /// Frees a texture's handle. Materials and meshes that have the picture keep it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_texture_free(tree_texture* texture);

        /// <summary>
        /// Symbol and number of parameters of a kind of module, 0 to `tree_grammar_info.n_kinds` less 1. `F(1)` and
        /// `F(1,2)` are of two kinds. The name is valid until the grammar is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_kind(tree_grammar* grammar, ushort kind, tree_str* name, UIntPtr* n_params);

        /// <summary>
        /// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
        /// `TREE_ERROR_UNKNOWN_NAME` when the grammar has no such module.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_find_kind(tree_grammar* grammar, byte* name, UIntPtr len, UIntPtr n_params, ushort* kind);

        /// <summary>
        /// Symbol and number of parameters of a kind of module, 0 to `tree_word_columns.n_kinds` less 1. The name is
        /// valid until the word is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_kind(tree_word* word, ushort kind, tree_str* name, UIntPtr* n_params);

        /// <summary>
        /// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
        /// `TREE_ERROR_UNKNOWN_NAME` when the word's alphabet has no such module.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_find_kind(tree_word* word, byte* name, UIntPtr len, UIntPtr n_params, ushort* kind);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_chain_params_init(tree_chain_params* @params, UIntPtr size);

        /// <summary>
        /// Writes a skeleton as a word in metres from its base, with leaves in columns, or NULL for none: an internode is
        /// turns `+(a)` `&amp;(b)`, a diameter `!(w)` and a length `F(l)`, as far as they change; what leaves the axis at a node
        /// is in brackets, and so is each leaf, `~(size,kind)`. `tree_word_interpret` with `tree_chain_turtle` draws it.
        /// `tree_word_past` says which node and leaf is which. `params` and `control` may be NULL. `TREE_ERROR_INVALID`
        /// for a leaf on a node that is not there, `TREE_ERROR_LIMIT` for a word of many more modules than
        /// `tree_limits.modules`, which is looked at from time to time. Free the word with `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_to_word(tree_skeleton* skeleton, tree_foliage* foliage, tree_chain_params* @params, tree_control* control, tree_word** word);

        /// <summary>
        /// Writes a tree, wood and leaves, as a word. Otherwise as `tree_skeleton_to_word`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_tree_to_word(tree_tree* tree, tree_chain_params* @params, tree_control* control, tree_word** word);

        /// <summary>
        /// Applies a grammar's productions to all modules at once, `steps` times (0 to 1,000,000), beginning with the
        /// axiom; `TREE_STEPS_OF_TEXT` takes the number from the text. The same `seed` gives the same word for any number
        /// of threads. `control` may be NULL. `TREE_ERROR_INVALID` names module and production where an expression has no
        /// finite value; `TREE_ERROR_LIMIT` comes before the word grows beyond `tree_limits.modules`. `tree_word_past`
        /// tells how it grew. Free the word with `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_derive(tree_grammar* grammar, uint steps, ulong seed, tree_control* control, tree_word** word);

        /// <summary>
        /// Applies a grammar's productions to a word once: step `step`, counted from 0, of `of` steps, which conditions
        /// see as `itNum` and `maxIt`. Steps one by one from `tree_grammar_axiom` give the word of `tree_grammar_derive`
        /// (where the axiom is not random and not decomposed). `control` may be NULL. Errors are those of
        /// `tree_grammar_derive`, and `TREE_ERROR_INVALID` for a word of another alphabet. Free the new word with
        /// `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_step(tree_grammar* grammar, tree_word* word, uint step, uint of, ulong seed, tree_control* control, tree_word** next);

        /// <summary>
        /// The word as a turtle is to see it: the grammar's rules of interpretation applied, again to what they give,
        /// down to their `maximum depth`. Without such rules it is a copy. Otherwise as `tree_grammar_step`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_interpretation(tree_grammar* grammar, tree_word* word, ulong seed, tree_control* control, tree_word** seen);

        /// <summary>
        /// Draws a word as a tree: a turtle reads it from left to right.
        ///
        /// * `F(l)` draws wood of length l, `f(l)` moves without drawing, `G(l)` draws as `F` does;
        /// * `+(a)` `-(a)` turn left and right by a degrees, `&amp;(a)` `^(a)` pitch down and up, `\(a)` `/(a)` roll left and
        /// right, `|` turns round, `$` rolls until the turtle's left is horizontal;
        /// * `!(w)` `#(w)` set the diameter; without w it falls, or rises, by the width ratio; `_(e)` sets the elasticity;
        /// * `[` `]` are a branch, which saves and restores all this; `%` cuts off the rest of one;
        /// * `{` `.` `}` are a polygon, a corner where the turtle stands, and its end; in it `F` and `f` set corners;
        /// * `~(s,k)` is a leaf of size s and kind k; `'(n)` is colour n, `'` the next.
        ///
        /// Other symbols do nothing, and are counted. `turtle` may be NULL for the default, `control`, `report` and the
        /// place `trace` may be NULL. `TREE_ERROR_INVALID` names the module: a bracket or brace without its partner, a
        /// width or size below 0, a leaf kind that the species lacks. Free the tree with `tree_tree_free`, the trace with
        /// `tree_turtle_trace_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_interpret(tree_word* word, tree_turtle_params* turtle, tree_control* control, tree_turtle_report* report, tree_turtle_trace** trace, tree_tree** tree);

        /// <summary>
        /// Draws every `F` and `G` of a word as a line, in its order: six floats, where it begins and where it ends, in
        /// units times `turtle-&gt;unit`. The turtle starts at the origin and looks along +Y; `+` turns it to -X. Gaps stay
        /// open, braces draw nothing. `lines` has room for `capacity` floats; six for each module are always enough.
        /// `n_lines` says how many lines there are, also when the room was too small (`TREE_ERROR_BUFFER`, nothing is
        /// written). `turtle` and `control` may be NULL. Other errors are those of `tree_word_interpret`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_lines(tree_word* word, tree_turtle_params* turtle, tree_control* control, float* lines, UIntPtr capacity, UIntPtr* n_lines);

        /// <summary>
        /// Grows a tree of a grammar: derives the word, applies the rules of interpretation, and draws it. `steps` is the
        /// number of derivations, 0 to 1,000,000, or `TREE_STEPS_OF_TEXT`. `turtle` may be NULL for that of
        /// `tree_grammar_turtle`. The same grammar, parameters and `seed` give the same bits for any number of threads.
        /// `control`, `report` and the places `word` and `trace` may be NULL; the word is the one that was drawn, with the
        /// growth of the derivation as its past. Errors are those of `tree_grammar_derive` and `tree_word_interpret`. Free
        /// the tree with `tree_tree_free`, the others with `tree_word_free` and `tree_turtle_trace_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lsystem_grow(tree_grammar* grammar, uint steps, tree_turtle_params* turtle, ulong seed, tree_control* control, tree_turtle_report* report, tree_word** word, tree_turtle_trace** trace, tree_tree** tree);

        /// <summary>
        /// Reads a grammar in the notation of *The Algorithmic Beauty of Plants* and of the programs cpfg and L-studio,
        /// `text` of `len` bytes or `TREE_NUL_TERMINATED`. One line is a statement:
        ///
        /// * `#define r 0.5` or `r = 0.5`: a constant; `#symbols Apex`: symbols of more than one character;
        /// * `steps: 7`, `angle: 25.7`, `seed: 3`, `#ignore +-F`, `#consider AB`: settings;
        /// * `axiom: A(1)`: the word to begin with;
        /// * `A(x) : x &gt; 1 -&gt; F(x)[+A(x*r)]A(x*r)`: a production; `B(y) &lt; A(x) &gt; C` gives it a context,
        /// `A -(.3)-&gt; B` or `A -&gt; B : .3` a weight among others;
        /// * `decomposition`, `interpretation`, `productions`: what follows are rules of that section.
        ///
        /// `control` may be NULL; only its limits matter. `report` may be NULL; it says in which line and column a
        /// mistake is, with `TREE_ERROR_INVALID`. Free the grammar with `tree_grammar_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_from_text(byte* text, UIntPtr len, tree_control* control, tree_grammar_report* report, tree_grammar** grammar);

        /// <summary>
        /// Reads a grammar from a file in UTF-8. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and
        /// `path_len` is `TREE_NUL_TERMINATED`. Otherwise as `tree_grammar_from_text`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_read(byte* path, UIntPtr path_len, tree_control* control, tree_grammar_report* report, tree_grammar** grammar);

        /// <summary>
        /// Views what a grammar says. Set `info-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_view(tree_grammar* grammar, tree_grammar_info* info);

        /// <summary>
        /// Name and value of a constant of the text, in the order of their names; `steps` and `angle` are among them
        /// where the text sets them. `index` is below `tree_grammar_info.n_constants`. The name is valid until the
        /// grammar is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_constant(tree_grammar* grammar, UIntPtr index, tree_str* name, double* value);

        /// <summary>
        /// A copy of the grammar in which a constant of the text has another value; all that depends on it is computed
        /// anew. `steps` (fractions are cut off) and `angle` can be set as well. `name` has `len` bytes or
        /// `TREE_NUL_TERMINATED`. `TREE_ERROR_PARAMETER` for a value that is not finite or steps beyond 0 to 1,000,000,
        /// `TREE_ERROR_INVALID` when the text has no such constant, or an expression of constants has no value then:
        /// `report`, which may be NULL, says where. Words of the one grammar are words of the other. Free the copy with
        /// `tree_grammar_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_with_constant(tree_grammar* grammar, byte* name, UIntPtr len, double value, tree_grammar_report* report, tree_grammar** changed);

        /// <summary>
        /// Frees a grammar. Its words live on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_free(tree_grammar* grammar);

        /// <summary>
        /// Number of ready-made L-systems: leafy species of this library first, then those of the books.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr tree_lsystem_preset_count();

        /// <summary>
        /// Tells name, title, source and text of a preset. `index` is below `tree_lsystem_preset_count`. Set
        /// `info-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lsystem_preset_view(UIntPtr index, tree_lsystem_preset_info* info);

        /// <summary>
        /// Name and value of a constant of the text that a preset changes: presets of one figure share a text. `constant`
        /// is below `tree_lsystem_preset_info.n_constants`. The name is valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lsystem_preset_constant(UIntPtr index, UIntPtr constant, tree_str* name, double* value);

        /// <summary>
        /// The preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`): `turtle`, of `size` bytes, becomes how it is
        /// drawn, what that points at belongs to the library and lives for ever; `grammar` what it derives. Give both to
        /// `tree_lsystem_grow`. Free the grammar with `tree_grammar_free`. `TREE_ERROR_UNKNOWN_NAME` lists the names there
        /// are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lsystem_preset(byte* name, UIntPtr len, tree_turtle_params* turtle, UIntPtr size, tree_grammar** grammar);

        /// <summary>
        /// Views the polygons. Set `polygons-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_trace_view(tree_turtle_trace* trace, tree_turtle_polygons* polygons);

        /// <summary>
        /// A symbol that says nothing to the turtle, and how often it was met. `index` is below
        /// `tree_turtle_report.n_skipped`. The name is valid until the trace is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_trace_skipped(tree_turtle_trace* trace, UIntPtr index, tree_str* name, UIntPtr* n_times);

        /// <summary>
        /// All that may surprise, a sentence for each; there may be none. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_trace_warnings(tree_turtle_trace* trace, tree_lines** warnings);

        /// <summary>
        /// Frees what a turtle drew beside the tree.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_trace_free(tree_turtle_trace* trace);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_params_init(tree_turtle_params* @params, UIntPtr size);

        /// <summary>
        /// Checks that all parameters lie in their ranges, as functions that take them do first. `params` may be NULL for
        /// the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_turtle_params_check(tree_turtle_params* @params);

        /// <summary>
        /// Makes `params`, of `size` bytes, what a grammar says: its angle, and the constants of its text that have the
        /// names `step`, `width`, `width_ratio`, `leaf_size`, `elasticity`, `tropism_x`, `tropism_y`, `tropism_z`, `unit`,
        /// `height` and `trunk_radius`. `TREE_ERROR_PARAMETER` names one that is out of its range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_turtle(tree_grammar* grammar, tree_turtle_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the turtle that draws words of `tree_skeleton_to_word`: in metres, widths at
        /// the upper ends of internodes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_chain_turtle(tree_turtle_params* @params, UIntPtr size);

        /// <summary>
        /// Reads a word without a grammar: a symbol is one character, its parameters are numbers in parentheses, divided
        /// by commas. `text` has `len` bytes or `TREE_NUL_TERMINATED`. Brackets need not pair; `tree_word_check` looks.
        /// `control` may be NULL; only its limits matter. `report` may be NULL; it says which module is wrong, with
        /// `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_from_text(byte* text, UIntPtr len, tree_control* control, tree_grammar_report* report, tree_word** word);

        /// <summary>
        /// Reads a word of a grammar's modules, such as `F(1)[+F(0.5)]`. `TREE_ERROR_INVALID` also for modules that the
        /// grammar does not have, and for brackets that do not pair. Otherwise as `tree_word_from_text`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_word(tree_grammar* grammar, byte* text, UIntPtr len, tree_control* control, tree_grammar_report* report, tree_word** word);

        /// <summary>
        /// Makes a word of a grammar's modules from columns, which are copied: kinds are those of the grammar, each
        /// module has as many parameters as its kind says. `control` may be NULL; only its limits matter. `report` may
        /// be NULL; it says which module is wrong, with `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_word_from_columns(tree_grammar* grammar, tree_word_columns* columns, tree_control* control, tree_grammar_report* report, tree_word** word);

        /// <summary>
        /// The word that the grammar's derivations begin with; random numbers in it come from the seed of the text.
        /// Free it with `tree_word_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grammar_axiom(tree_grammar* grammar, tree_word** word);

        /// <summary>
        /// Views a word. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_view(tree_word* word, tree_word_columns* columns);

        /// <summary>
        /// Views what a word came from. Set `history-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_past(tree_word* word, tree_word_history* history);

        /// <summary>
        /// Writes a word as text, which `tree_word_from_text` and `tree_grammar_word` read back to the same bits (the
        /// former where all symbols are of one character). Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_to_text(tree_word* word, tree_bytes** text);

        /// <summary>
        /// Checks that every bracket of a word has its partner. `TREE_ERROR_INVALID` names the module that has none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_check(tree_word* word);

        /// <summary>
        /// Frees a word.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_word_free(tree_word* word);

        /// <summary>
        /// Bytes that the library has allocated and not freed, objects and work in progress together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern ulong tree_memory_used();

        /// <summary>
        /// Most bytes in use at one time since the start, or since `tree_memory_reset_peak`; small blocks may be
        /// missed by some kilobytes.
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
        /// once may all be told so. Calls that take no memory, such as looking at a mesh, never are. An eighth of
        /// the budget is kept for what is taken between two looks at it; a call that went beyond all the same fails
        /// at its end.
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
        /// library has memory of its own it is `TREE_ERROR_ORDER`. When `allocate` gives NULL the process aborts, as
        /// Rust does; set a budget below what the allocator has.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_memory_set_allocator(tree_allocator* allocator);

        /// <summary>
        /// Frees a mesh, and with it all views of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_free(tree_mesh* mesh);

        /// <summary>
        /// Views the branches that a mesh's vertices move with, parents first: where they begin, NULL for none,
        /// and how many there are. Valid until the mesh is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_branches(tree_mesh* mesh, tree_wind_branch** branches, UIntPtr* n_branches);

        /// <summary>
        /// Builds bark and leaves of a tree: surface 0 is the bark, surface 1 + k the leaves of kind k; those
        /// without triangles are there too. Materials are in the same order.
        ///
        /// `look` may be NULL: the built-in textures that the tree's species names, as `tree_look_of_tree` gives
        /// them; to build many meshes, make a look once. `params` may be NULL. `report` may be NULL. Free the mesh
        /// with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_build(tree_tree* tree, tree_look* look, tree_mesh_params* @params, tree_control* control, tree_mesh_report* report, tree_mesh** mesh);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_subdivide_params_init(tree_subdivide_params* @params, UIntPtr size);

        /// <summary>
        /// Makes a mesh whose surface `number` is finer and rounder: Loop subdivision with creases kept. A closed
        /// surface stays closed. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params`
        /// may be NULL. Free the mesh with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_subdivide(tree_mesh* mesh, UIntPtr number, tree_subdivide_params* @params, tree_control* control, tree_mesh** subdivided);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_displace_params_init(tree_displace_params* @params, UIntPtr size);

        /// <summary>
        /// Makes a mesh whose surface `number` has relief: points moved in and out by noise, normals and tangents
        /// tilted with them. A closed surface stays closed. The surface should be finer than `scale`: subdivide it
        /// first. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params` may be NULL.
        /// Free the mesh with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_displace(tree_mesh* mesh, UIntPtr number, tree_displace_params* @params, ulong seed, tree_control* control, tree_mesh** displaced);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_occlusion_params_init(tree_occlusion_params* @params, UIntPtr size);

        /// <summary>
        /// Makes a copy of a mesh whose surfaces have the column `occlusion`: 1 where all light arrives, 0 where
        /// none does. The cells count against the limit `voxels`. `params` may be NULL. Free the mesh with
        /// `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_bake_occlusion(tree_mesh* mesh, tree_occlusion_params* @params, tree_control* control, tree_mesh** baked);

        /// <summary>
        /// Makes a mesh whose surface `number` has one vertex for each point: for volumes, printers and other
        /// programs that take copies at seams for holes. Triangles that have two corners at one point are left
        /// out, and so are vertices without triangles. Normals are the means of the copies' normals, texture
        /// coordinates those of the first copy, so textures are torn at seams; tangents are dropped. Everything
        /// else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `control` may be NULL; only its pool
        /// matters. Free the mesh with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_weld(tree_mesh* mesh, UIntPtr number, tree_control* control, tree_mesh** welded);

        /// <summary>
        /// Makes a mesh of your own triangles: `n_surfaces` surfaces whose `material` is an index into the
        /// `n_materials` materials. `branches` may be NULL when `n_branches` is 0; no surface may name a branch
        /// then. All is copied but the textures, which are shared, and checked as by `tree_mesh_check`. `control`
        /// may be NULL; only its limits and its pool matter. Free the mesh with `tree_mesh_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_from_surfaces(tree_surface* surfaces, UIntPtr n_surfaces, tree_material* materials, UIntPtr n_materials, tree_wind_branch* branches, UIntPtr n_branches, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// Views material `number` of a mesh, from 0 on; `material` of `tree_surface` says which one a surface
        /// has. Set `material-&gt;struct_size` first. Valid until the mesh is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_material(tree_mesh* mesh, UIntPtr number, tree_material* material);

        /// <summary>
        /// A handle of the texture of material `number`; the pixels are shared, and outlive the mesh. NULL, and no
        /// error, where the material has none. Free it with `tree_texture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_texture(tree_mesh* mesh, UIntPtr number, tree_texture** texture);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_params_init(tree_mesh_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field against its range: `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
        /// fault.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_params_check(tree_mesh_params* @params);

        /// <summary>
        /// The error that the parameters allow as a length in metres, within 0.01 mm and 1 m: for
        /// `TREE_BOUND_PIXELS`, how large a pixel is at the tree. `params` may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_params_error(tree_mesh_params* @params, float* metres);

        /// <summary>
        /// Counts points, edges, holes, pieces and the like of surface `number`. Set `topology-&gt;struct_size` first.
        /// `control` may be NULL; only its pool matters.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_examine(tree_mesh* mesh, UIntPtr number, tree_control* control, tree_topology* topology);

        /// <summary>
        /// The points of surface `number`, numbered in the order of their first vertices: by its welds where it
        /// has them, otherwise vertices at exactly the same place are one point.
        ///
        /// `of_vertex`, NULL or with room for `of_vertex_capacity` numbers (one for each vertex), gets the point
        /// that each vertex stands at. `first`, NULL or with room for `first_capacity` numbers (as many as there are vertices are always
        /// enough), gets the first vertex of each point. `n_points` gets their number; it may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_points(tree_mesh* mesh, UIntPtr number, uint* of_vertex, UIntPtr of_vertex_capacity, uint* first, UIntPtr first_capacity, UIntPtr* n_points);

        /// <summary>
        /// Finds the triangles of surface `number` that cross or touch each other without sharing a point, and
        /// those that share one point and meet again beyond it. Triangles that share an edge are not tested (they
        /// cross only when folded flat on each other), nor are those with two corners at one point. Pairs count
        /// against the limit `triangles`. Free the answer with `tree_crossings_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_crossings(tree_mesh* mesh, UIntPtr number, tree_control* control, tree_crossings** crossings);

        /// <summary>
        /// Views crossings. Set `pairs-&gt;struct_size` first. Valid until they are freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crossings_view(tree_crossings* crossings, tree_crossing_pairs* pairs);

        /// <summary>
        /// Frees crossings.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crossings_free(tree_crossings* crossings);

        /// <summary>
        /// Counts what a mesh has. Set `totals-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_count(tree_mesh* mesh, tree_mesh_totals* totals);

        /// <summary>
        /// Number of surfaces of a mesh.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_surface_count(tree_mesh* mesh, UIntPtr* n_surfaces);

        /// <summary>
        /// Views surface `number` of a mesh, from 0 on: nothing is copied. Set `surface-&gt;struct_size` first. Valid
        /// until the mesh is freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_surface(tree_mesh* mesh, UIntPtr number, tree_surface* surface);

        /// <summary>
        /// The box and a ball around all vertices of surface `number`. Looks at each vertex: keep the answer.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_surface_bounds(tree_mesh* mesh, UIntPtr number, tree_bounds* bounds);

        /// <summary>
        /// The box and a ball around all vertices of a mesh. Looks at each vertex: keep the answer.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_bounds(tree_mesh* mesh, tree_bounds* bounds);

        /// <summary>
        /// Checks that a mesh can be drawn and written: columns of equal length, finite numbers, indices and
        /// materials that exist, looks within their ranges, textures filled, branches after those that carry them.
        /// Meshes of this library pass.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_check(tree_mesh* mesh);

        /// <summary>
        /// As `tree_mesh_check`, of the columns of surface `number` only.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_check_surface(tree_mesh* mesh, UIntPtr number);

        /// <summary>
        /// Checks that no colour of a material is brighter than 1, on which file formats rely; drawing does not.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_check_colors(tree_mesh* mesh);

        /// <summary>
        /// Checks that normals have unit length, within half a percent, on which file formats and engines rely;
        /// drawing does not.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_check_normals(tree_mesh* mesh);

        /// <summary>
        /// Finds the branches of a chain: one for each pair of brackets, and one for what is in none. Modules are named by
        /// their places in the chain, from 0 on, brackets counted. `control` may be NULL; `modules` of its limits caps the
        /// chain. Free the branches with `tree_adt_free`. `TREE_ERROR_INVALID` for brackets that do not match and for lengths
        /// that are negative or not finite, and says at which module.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_of_tokens(tree_token_columns* columns, tree_control* control, tree_adt** adt);

        /// <summary>
        /// Finds the branches of a skeleton: the runs of nodes between forks. Its modules are its nodes; the length of a node is
        /// that of the segment to its parent, in metres. `control` may be NULL; of it only a cancellation before the work
        /// begins matters. Free the branches with `tree_adt_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_of_skeleton(tree_skeleton* skeleton, tree_control* control, tree_adt** adt);

        /// <summary>
        /// As `tree_adt_of_skeleton` for the skeleton of a tree; its leaves count among the areas of the branches that bear
        /// them, as they do for `tree_multires_new`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_of_tree(tree_tree* tree, tree_control* control, tree_adt** adt);

        /// <summary>
        /// Views the branches. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_view(tree_adt* adt, tree_adt_columns* columns);

        /// <summary>
        /// Views the modules of a branch, in their order: places in the chain, or nodes of the skeleton. `TREE_ERROR_PARAMETER`
        /// when there is no such branch.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_modules(tree_adt* adt, uint branch, uint** modules, UIntPtr* n_modules);

        /// <summary>
        /// Views the branches that stem from a branch, in the order of the chain. `TREE_ERROR_PARAMETER` when there is no such
        /// branch.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_children(tree_adt* adt, uint branch, uint** children, UIntPtr* n_children);

        /// <summary>
        /// Frees the branches. Paths that were made of them stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_adt_free(tree_adt* adt);

        /// <summary>
        /// Writes paths one after another as a chain. States have numbers from 0 on, and only those that are needed are saved.
        /// `control` may be NULL; of it only a cancellation before the work begins matters. Free the chain with
        /// `tree_multi_chain_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_chain_new(tree_multi_paths* paths, tree_control* control, tree_multi_chain** chain);

        /// <summary>
        /// Views the items. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_chain_view(tree_multi_chain* chain, tree_multi_chain_columns* columns);

        /// <summary>
        /// The first `n_levels` levels as text, at most all, with `SAVE(0)` and `RESTORE(0)`. `text`, in UTF-8, is the plain
        /// chain of `text_len` bytes, or ends with a NUL and `text_len` is `TREE_NUL_TERMINATED`; `ends` has for each of its
        /// `n_ends` modules, brackets counted, the byte before which it ends. `control` may be NULL; `input_bytes` of its
        /// limits caps the text. Free the bytes, which are UTF-8, with `tree_bytes_free`.
        ///
        /// `TREE_ERROR_INVALID` when ends fall, lie within a letter or behind the text, or a module of the chain has none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_chain_to_text(tree_multi_chain* chain, UIntPtr n_levels, byte* text, UIntPtr text_len, uint* ends, UIntPtr n_ends, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// Frees a chain.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_chain_free(tree_multi_chain* chain);

        /// <summary>
        /// A mesh with all its levels as a GLB file in memory, for engines that draw prefixes: an attribute `_TREE_BRANCH` of 4
        /// floats a vertex, as in `tree_multi_mesh_column`, is what lets branches grow in. Other programs show the whole tree.
        /// `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`.
        /// `TREE_ERROR_PARAMETER` for `quantize`: shaders need positions in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_to_glb(tree_multi_mesh* multi_mesh, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_multi_mesh_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_write_glb(tree_multi_mesh* multi_mesh, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// Levels, at most 1024 of them, as the `MSFT_lod` of one GLB file, each a mesh of its own: for programs without shaders
        /// of ours. Both levels and shares fall. `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the
        /// bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no levels, or levels or shares do not fall.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_to_glb_levels(tree_multi_mesh* multi_mesh, tree_level_share* levels, UIntPtr n_levels, tree_glb_options* options, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_multi_mesh_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_write_glb_levels(tree_multi_mesh* multi_mesh, tree_level_share* levels, UIntPtr n_levels, byte* path, UIntPtr path_len, tree_glb_options* options, tree_control* control);

        /// <summary>
        /// The function `tree_grow_position` for a shader: text to be put into your own. It tells what it takes and where that
        /// comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grow_shader(uint language, tree_str* text);

        /// <summary>
        /// Where a shader draws a vertex at a level: `vertex`, three floats, drawn together about its fork while its path grows
        /// in. `branch` is four floats of `tree_multi_mesh_column.branches`. For shaders of your own, and for checking them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grow_position(float* vertex, float* branch, float level, float* drawn);

        /// <summary>
        /// Draws a tree: each path is a closed tube of its own, with a cap at either end, and begins inside the wood that bears
        /// it; it has a ring at each node, and as many sides all along as `params` ask for. Surface 0 is the wood, surface 1 + k
        /// the leaves of kind k. Of `params` those of curves, flares, tangents and light maps are not used.
        ///
        /// `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL. Free
        /// the mesh with `tree_multi_mesh_free`. `TREE_ERROR_PARAMETER` for more than 16,777,216 levels; otherwise as
        /// `tree_mesh_build`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_new(tree_multires* multires, tree_look* look, tree_mesh_params* @params, tree_control* control, tree_multi_mesh** multi_mesh);

        /// <summary>
        /// Tells how large a mesh is. Set `totals-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_measure(tree_multi_mesh* multi_mesh, tree_multi_mesh_totals* totals);

        /// <summary>
        /// The mesh to upload, with all levels, nothing copied. Free it with `tree_mesh_free`; it keeps alive what it is of.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_mesh(tree_multi_mesh* multi_mesh, tree_mesh** mesh);

        /// <summary>
        /// Views what shaders need of the vertices of surface `number`. Set `column-&gt;struct_size` first. `TREE_ERROR_PARAMETER`
        /// when there is no such surface.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_branches(tree_multi_mesh* multi_mesh, UIntPtr number, tree_multi_mesh_column* column);

        /// <summary>
        /// What is drawn at a level: 3.25 draws three paths whole and a quarter of the fourth, drawn together about its fork by
        /// the shader; levels are clamped to 1 and all. `draws` has room for `capacity` rows, at least one for each surface, in
        /// their order; `n_triangles` is how many triangles that is. It is quick enough for every frame.
        /// `TREE_ERROR_PARAMETER` for NaN.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_draws(tree_multi_mesh* multi_mesh, float level, tree_multi_draw* draws, UIntPtr capacity, ulong* n_triangles);

        /// <summary>
        /// Number of indices of the wood, surface 0, that are drawn at a level; levels are clamped to 1 and all.
        /// `TREE_ERROR_PARAMETER` for NaN.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_wood_indices(tree_multi_mesh* multi_mesh, float level, uint* n_indices);

        /// <summary>
        /// The greatest whole level with at most `n_triangles` triangles of wood; at least 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_level_of_wood(tree_multi_mesh* multi_mesh, ulong n_triangles, UIntPtr* n_levels);

        /// <summary>
        /// A level, clamped to 1 and all, as a plain mesh: what is not drawn is left out, and the last path has grown as the
        /// shader lets it. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free
        /// the mesh with `tree_mesh_free`. `TREE_ERROR_PARAMETER` for NaN.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_mesh_at(tree_multi_mesh* multi_mesh, float level, tree_control* control, tree_mesh** mesh);

        /// <summary>
        /// Frees a mesh with levels, and with it all views of its columns. Meshes made of it stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_mesh_free(tree_multi_mesh* multi_mesh);

        /// <summary>
        /// Sorts a tree, which is copied, by a metric, NULL for the default; its branches are those of `tree_adt_of_skeleton`.
        /// `seed` matters to `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free what is made with `tree_multires_free`.
        ///
        /// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_new(tree_tree* tree, tree_metric_params* @params, ulong seed, tree_control* control, tree_multires** multires);

        /// <summary>
        /// Sorts a tree, which is copied, by paths of its own branches, and tells where rows went: `nodes` and `leaves`, each
        /// of which may be NULL, get for each node and leaf its number in the tree that came in. Free them with
        /// `tree_rows_free`, and what is made with `tree_multires_free`. `control` may be NULL; of it only a cancellation before
        /// the work begins matters. `TREE_ERROR_INVALID` when the paths are those of another tree, or of a chain.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_of_paths(tree_tree* tree, tree_multi_paths* paths, tree_control* control, tree_rows** nodes, tree_rows** leaves, tree_multires** multires);

        /// <summary>
        /// Number of levels: of tips, at least 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_count(tree_multires* multires, UIntPtr* n_levels);

        /// <summary>
        /// Nodes and leaves of the first `n_levels` levels, at least one level, at most all.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_counts(tree_multires* multires, UIntPtr n_levels, UIntPtr* n_nodes, UIntPtr* n_leaves);

        /// <summary>
        /// Views the first `n_levels` levels, at least one, at most all: their nodes are a skeleton, and their leaves stand on
        /// these. Nothing is copied, and all levels begin at the same places. Each of `columns` and `foliage` may be NULL; set
        /// its `struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_level(tree_multires* multires, UIntPtr n_levels, tree_skeleton_columns* columns, tree_foliage* foliage);

        /// <summary>
        /// A copy of the first `n_levels` levels, at least one, at most all, as a tree of its own, with its species. `control`
        /// may be NULL; of it only a cancellation before the work begins matters. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_tree_at(tree_multires* multires, UIntPtr n_levels, tree_control* control, tree_tree** tree);

        /// <summary>
        /// How many levels have at most `n_nodes` nodes together; one if none has so few.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_level_of_nodes(tree_multires* multires, UIntPtr n_nodes, UIntPtr* n_levels);

        /// <summary>
        /// Frees a multiresolution tree, and with it all views of its levels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_free(tree_multires* multires);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_metric_params_init(tree_metric_params* @params, UIntPtr size);

        /// <summary>
        /// Cuts branches into paths and sorts them, the most relevant first. `params` may be NULL for the default metric. `seed` matters to
        /// `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free the paths with `tree_multi_paths_free`.
        ///
        /// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_paths_new(tree_adt* adt, tree_metric_params* @params, ulong seed, tree_control* control, tree_multi_paths** paths);

        /// <summary>
        /// Number of paths: of levels of detail, at least 1.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_paths_count(tree_multi_paths* paths, UIntPtr* n_paths);

        /// <summary>
        /// Views the branches of all paths one after another; those of the first few paths are a prefix.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_paths_branches(tree_multi_paths* paths, uint** branches, UIntPtr* n_branches);

        /// <summary>
        /// Views the branches of one path, from its fork up. `TREE_ERROR_PARAMETER` when there is no such path.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_paths_path(tree_multi_paths* paths, UIntPtr number, uint** branches, UIntPtr* n_branches);

        /// <summary>
        /// Frees the paths.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multi_paths_free(tree_multi_paths* paths);

        /// <summary>
        /// Makes a reader that nothing has reached yet. `control` may be NULL; the limits that it has now hold for all bytes to
        /// come: `nodes` and `leaves`, asked for as the head arrives, and `input_bytes` for all bytes together. Free the reader
        /// with `tree_stream_reader_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_reader_new(tree_control* control, tree_stream_reader** reader);

        /// <summary>
        /// Takes the next bytes, any number of them; they are needed during the call only, and never trusted. `report` may be
        /// NULL. `TREE_ERROR_FORMAT` for bytes that are no stream, are damaged, or follow its end, and `TREE_ERROR_LIMIT`: the
        /// levels before stay there, and the same comes again for more bytes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_reader_push(tree_stream_reader* reader, byte* data, UIntPtr len, tree_stream_report* report);

        /// <summary>
        /// How much has arrived. Set `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_reader_received(tree_stream_reader* reader, tree_stream_report* report);

        /// <summary>
        /// The tree of all levels that have arrived, a copy; the reader goes on. `control` may be NULL; of it only a
        /// cancellation before the work begins matters. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when
        /// the first level is not there yet.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_reader_multires(tree_stream_reader* reader, tree_control* control, tree_multires** multires);

        /// <summary>
        /// Frees a reader. Trees that came of it stay.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_reader_free(tree_stream_reader* reader);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_params_init(tree_stream_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stream_params_check(tree_stream_params* @params);

        /// <summary>
        /// The first `n_levels` levels of a tree, at least one, at most all, as bytes of which every prefix is a coarser tree:
        /// the stream of `k` levels begins that of `k + 1`. `params` and `control` may be NULL; of `control` only a
        /// cancellation before the work begins matters. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
        /// coordinates beyond 1000 km when there is a precision; `TREE_ERROR_FORMAT` for names of more than 4096 bytes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_to_stream(tree_multires* multires, UIntPtr n_levels, tree_stream_params* @params, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// As `tree_multires_to_stream`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_write_stream(tree_multires* multires, UIntPtr n_levels, byte* path, UIntPtr path_len, tree_stream_params* @params, tree_control* control);

        /// <summary>
        /// The tree as one chain with brackets, in the same code but without levels, to compare sizes with: nothing reads it.
        /// Otherwise as `tree_multires_to_stream`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_to_bracketed(tree_multires* multires, tree_stream_params* @params, tree_control* control, tree_bytes** bytes);

        /// <summary>
        /// Reads a stream, or what there is of it: levels up to the first that is cut off. The bytes are needed during the call
        /// only, and never trusted. `control` and `report` may be NULL; `nodes`, `leaves` and `input_bytes` of the limits cap
        /// what is read. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when not even the first level is
        /// whole, and for bytes that are no stream or are damaged.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_from_stream(byte* data, UIntPtr len, tree_control* control, tree_stream_report* report, tree_multires** multires);

        /// <summary>
        /// As `tree_multires_from_stream`, from a file; the path as in `tree_mesh_write_glb`. A file that was cut off is read as
        /// far as it goes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_multires_read_stream(byte* path, UIntPtr path_len, tree_control* control, tree_stream_report* report, tree_multires** multires);

        /// <summary>
        /// The density of a tree from `n_views` views, at least one: optical depth per metre, such that looking
        /// through the grid gives the mattes. It is `tree_carved_new` and `tree_carved_solve` in one.
        ///
        /// `params`, `control` and `report` may be NULL. `rows`, NULL or with room for `capacity` rows (one for each
        /// view), says how well each view fits. Free the grid with `tree_grid_free`. `TREE_ERROR_NO_RESULT` names a
        /// view that shows no tree, is not of its camera's size, or leaves nothing of what the others see;
        /// `TREE_ERROR_PARAMETER` what is out of range; `TREE_ERROR_LIMIT` comes before too many voxels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_from_views(tree_particle_view* views, UIntPtr n_views, tree_density_params* @params, tree_control* control, tree_density_report* report, tree_density_view* rows, UIntPtr capacity, tree_grid** grid);

        /// <summary>
        /// The first stage of `tree_grid_from_views`: lays a grid of cubes around what the views see and throws away
        /// those that a view shows to be empty. Arguments and errors are as there. Free it with `tree_carved_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_carved_new(tree_particle_view* views, UIntPtr n_views, tree_density_params* @params, tree_control* control, tree_carved** carved);

        /// <summary>
        /// Views what carving left. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_carved_view(tree_carved* carved, tree_carved_columns* columns);

        /// <summary>
        /// The grid of carving: in each voxel the least of the average mattes it projects to, 0 to 1; 0 where it was
        /// thrown away. Free it with `tree_grid_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_carved_alpha(tree_carved* carved, tree_grid** grid);

        /// <summary>
        /// The second stage of `tree_grid_from_views`: densities in the voxels that were left, for the views and
        /// params that were carved. Arguments and errors are as there. Free the grid with `tree_grid_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_carved_solve(tree_carved* carved, tree_particle_view* views, UIntPtr n_views, tree_density_params* @params, tree_control* control, tree_density_report* report, tree_density_view* rows, UIntPtr capacity, tree_grid** grid);

        /// <summary>
        /// Frees what carving left.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_carved_free(tree_carved* carved);

        /// <summary>
        /// Sets up the equations that `tree_carved_solve` solves, for the views and params that were carved. Arguments
        /// and errors are as there; `TREE_ERROR_LIMIT` too when there are more entries than the limit on voxels allows.
        /// Free them with `tree_equations_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_equations_new(tree_carved* carved, tree_particle_view* views, UIntPtr n_views, tree_density_params* @params, tree_control* control, tree_equations** equations);

        /// <summary>
        /// Views equations. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_equations_view(tree_equations* equations, tree_equations_columns* columns);

        /// <summary>
        /// Frees equations.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_equations_free(tree_equations* equations);

        /// <summary>
        /// The matte that a camera sees of a density: 1 - exp(-sum of density times length) along the ray of each
        /// pixel. `control` may be NULL. Free the matte with `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_look_through(tree_grid* grid, tree_particle_camera* camera, tree_control* control, tree_matte** matte);

        /// <summary>
        /// Cubic metres of the voxels above `threshold` (per metre).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_crown_volume(tree_grid* grid, float threshold, double* measure);

        /// <summary>
        /// How well the voxels above `threshold` agree with those of `other` above `other_threshold`: the shared
        /// volume over that of both together, 0 to 1. 0 when both are empty.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_overlap(tree_grid* grid, float threshold, tree_grid* other, float other_threshold, double* measure);

        /// <summary>
        /// Draws `n_points` points in proportion to the density times `weight`, spread evenly: where particles
        /// start. `weight` may be NULL for 1 everywhere, and is handed `user`. The same `seed` gives the same points.
        /// `control` may be NULL; `nodes` of its limits caps the points. `points` has room for `capacity` floats,
        /// three for each point. `TREE_ERROR_PARAMETER` when the grid is empty.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_draw_points(tree_grid* grid, uint n_points, IntPtr weight, void* user, ulong seed, tree_control* control, float* points, UIntPtr capacity);

        /// <summary>
        /// Makes `stroke`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_density_stroke_init(tree_density_stroke* stroke, UIntPtr size);

        /// <summary>
        /// Makes `brush`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_density_brush_init(tree_density_brush* brush, UIntPtr size);

        /// <summary>
        /// A matte with strokes over it, one after the other: paints what a photograph does not show, and erases
        /// what is not of the tree. Parts outside the picture do nothing. The first matte stays as it is. `control`
        /// may be NULL; `nodes` of its limits caps the points of a stroke. Free the painted one with
        /// `tree_matte_free`. `TREE_ERROR_PARAMETER` names the stroke that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_paint(tree_matte* matte, tree_density_stroke* strokes, UIntPtr n_strokes, tree_control* control, tree_matte** painted);

        /// <summary>
        /// A grid with balls drawn through it, one after the other. Parts outside the grid do nothing. The first
        /// grid stays as it is. `control` may be NULL; `nodes` of its limits caps the points of a brush. Free the
        /// painted one with `tree_grid_free`. `TREE_ERROR_PARAMETER` names the brush that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_paint(tree_grid* grid, tree_density_brush* brushes, UIntPtr n_brushes, tree_control* control, tree_grid** painted);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_density_params_init(tree_density_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_density_params_check(tree_density_params* @params);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_field_params_init(tree_field_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_field_params_check(tree_field_params* @params);

        /// <summary>
        /// The share of the direction towards the branches at a distance, as a share of the picture's height.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_field_params_blend_at(tree_field_params* @params, float distance, float* measure);

        /// <summary>
        /// The direction field of the branches in one picture of `width` by `height` pixels, each 1 to 1e6: near a
        /// branch along it and towards the tree's base, elsewhere towards the branch. A graph without segments has no
        /// directions: the field is zero. `base_x` and `base_y` are the base in pixels, where what lies beyond the
        /// graph's roots is directed. `params` and `control` may be NULL. Free it with `tree_direction_field_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_new(tree_attractor* attractor, float width, float height, float base_x, float base_y, tree_field_params* @params, tree_control* control, tree_direction_field** field);

        /// <summary>
        /// Views a direction field. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_view(tree_direction_field* field, tree_direction_field_columns* columns);

        /// <summary>
        /// The directions at `n_spots` points of the picture, two floats each in pixels, between cells by bilinear
        /// interpolation; outside the grid that of the nearest cell. `directions` has room for `capacity` floats, two
        /// for each point: x to the right, y up. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_sample(tree_direction_field* field, float* spots, UIntPtr n_spots, tree_control* control, float* directions, UIntPtr capacity);

        /// <summary>
        /// A picture of the field: one pixel for each cell; red is x and green is y, 128 for none. Free it with
        /// `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_picture(tree_direction_field* field, tree_photo** picture);

        /// <summary>
        /// A copy of a photograph, or any other picture of the same size, with the field as arrows over it. `color` is
        /// `0xRRGGBBAA`. Free it with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_draw_over(tree_direction_field* field, tree_photo* photo, uint color, tree_photo** drawn);

        /// <summary>
        /// Frees a direction field.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_direction_field_free(tree_direction_field* field);

        /// <summary>
        /// The tree's branches without twigs: traces thinned, smoothed, and as thick as the pipe model has it.
        /// `height` is the tree's, `trunk_radius` what the pictures show of the trunk, both in metres; 0 where they
        /// show none. `params` may be NULL for an oak. Free the skeleton with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_traces_grow_wood(tree_traces* traces, float height, float trunk_radius, tree_finish_params* @params, tree_control* control, tree_skeleton** wood);

        /// <summary>
        /// Grows twigs and leaves on branches, as many as the density and `n_views` views ask for and none where
        /// those are empty. `height` is the tree's in metres. `params` may be NULL for an oak; the same `seed` gives
        /// the same tree. `control` and `report` may be NULL. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_grow_crown(tree_skeleton* wood, tree_grid* density, tree_particle_view* views, UIntPtr n_views, float height, tree_finish_params* @params, ulong seed, tree_control* control, tree_crown_report* report, tree_tree** tree);

        /// <summary>
        /// Makes `params`, of `size` bytes, an oak.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_finish_params_init(tree_finish_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, those of a species by its name, of `len` bytes or
        /// `TREE_NUL_TERMINATED`: the defaults with its twigs, and sprays of its leaves or needles. Names are
        /// those of `tree_foliage_species_name`; `TREE_ERROR_UNKNOWN_NAME` lists them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_finish_params_find(tree_finish_params* @params, UIntPtr size, byte* name, UIntPtr len);

        /// <summary>
        /// As `tree_finish_params_find`, with single leaves and needles instead of sprays: far more of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_finish_params_of(tree_finish_params* @params, UIntPtr size, byte* name, UIntPtr len);

        /// <summary>
        /// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_finish_params_check(tree_finish_params* @params);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_flow_params_init(tree_flow_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_flow_params_check(tree_flow_params* @params);

        /// <summary>
        /// Lets particles flow from `n_starts` points, three floats each in metres, to the base, along `way` and the
        /// fields of `n_views` views (none will do). `height` is the tree's in metres, 1e-3 to 1e5. `params`,
        /// `control` and `report` may be NULL; `particles` of the params does not count. The same starts give the same
        /// bits for any number of threads. Free the traces with `tree_traces_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_traces_flow(tree_way* way, tree_flow_view* views, UIntPtr n_views, float* starts, UIntPtr n_starts, float height, tree_flow_params* @params, tree_control* control, tree_flow_report* report, tree_traces** traces);

        /// <summary>
        /// Views traces. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_traces_view(tree_traces* traces, tree_traces_columns* columns);

        /// <summary>
        /// Traces as a skeleton, from the base to where the particles started, with radii of 0. Free it with
        /// `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_traces_skeleton(tree_traces* traces, tree_control* control, tree_skeleton** skeleton);

        /// <summary>
        /// Frees traces.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_traces_free(tree_traces* traces);

        /// <summary>
        /// Finds the cheapest way to the origin from everywhere in `density`: it keeps to dense voxels and prefers
        /// the stem. `params` may be NULL; `stem` counts. Free it with `tree_way_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_way_new(tree_grid* density, tree_flow_params* @params, tree_control* control, tree_way** way);

        /// <summary>
        /// What the way to the base costs from the centre of each voxel: metres, more where it is not dense. Free
        /// the grid with `tree_grid_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_way_costs(tree_way* way, tree_grid** grid);

        /// <summary>
        /// The way on from `n_points` points, three floats each in metres; outside the grid as from its nearest
        /// point. `directions` has room for `capacity` floats, three for each point: vectors of length 0 to 1, and 0
        /// for points that are not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_way_sample(tree_way* way, float* points, UIntPtr n_points, tree_control* control, float* directions, UIntPtr capacity);

        /// <summary>
        /// Frees a way.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_way_free(tree_way* way);

        /// <summary>
        /// Makes `view`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_flow_view_init(tree_flow_view* view, UIntPtr size);

        /// <summary>
        /// The directions that particles take at `n_points` points, three floats each in metres, where no neighbour
        /// pulls: by the fields of `n_views` views (none will do) and the way to the base. `params` may be NULL.
        /// `directions` has room for `capacity` floats, three for each point: unit vectors, and 0 for points that are
        /// not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_way_directions(tree_way* way, tree_flow_view* views, UIntPtr n_views, float* points, UIntPtr n_points, tree_flow_params* @params, tree_control* control, float* directions, UIntPtr capacity);

        /// <summary>
        /// Makes a grid with its lowest corner at `corner`, three floats, of `nx` by `ny` by `nz` voxels (1 to 4096
        /// each) with sides of `voxel` metres (1e-6 to 1e6). `values` are copied, in the order of
        /// `tree_grid_columns`; without any (`n_values` 0) all are 0. `control` may be NULL; only its limits matter.
        /// Free the grid with `tree_grid_free`. `TREE_ERROR_INVALID` when there are not as many values as voxels,
        /// `TREE_ERROR_PARAMETER` names a value that is not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_new(float* corner, float voxel, uint nx, uint ny, uint nz, float* values, UIntPtr n_values, tree_control* control, tree_grid** grid);

        /// <summary>
        /// Views a grid. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_view(tree_grid* grid, tree_grid_columns* columns);

        /// <summary>
        /// The box that the grid fills: its lower corner, then its upper one, in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_bounds(tree_grid* grid, float* min_max);

        /// <summary>
        /// Row of a voxel among the grid's values; `SIZE_MAX` outside.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_index(tree_grid* grid, int x, int y, int z, UIntPtr* index);

        /// <summary>
        /// The voxel that holds a point, three floats in metres; outside the grid it is none of its voxels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_voxel_at(tree_grid* grid, float* point, int* voxel);

        /// <summary>
        /// Looks up the grid at `n_points` points, three floats each in metres: between voxel centres by trilinear
        /// interpolation, fading to 0 outside. `values` has room for `capacity` numbers, at least `n_points`.
        /// `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_sample(tree_grid* grid, float* points, UIntPtr n_points, tree_control* control, float* values, UIntPtr capacity);

        /// <summary>
        /// As `tree_grid_sample`, but the value of the voxel that holds each point, and 0 outside.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_nearest(tree_grid* grid, float* points, UIntPtr n_points, tree_control* control, float* values, UIntPtr capacity);

        /// <summary>
        /// Frees a grid.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_grid_free(tree_grid* grid);

        /// <summary>
        /// Begins with `n_shots` photographs, 1 to 1000, which are copied. `params` may be NULL for the defaults.
        /// `control` may be NULL; only its limits matter: no work is done yet. Free the session with
        /// `tree_photo_session_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
        /// photograph that is not of its matte's size.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_new(tree_photo_shot* shots, UIntPtr n_shots, tree_photo_params* @params, ulong seed, tree_control* control, tree_photo_session** session);

        /// <summary>
        /// A second session in the state of the first, with all that has been made so far: to try something, and
        /// go back. Free it too.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_copy(tree_photo_session* session, tree_photo_session** copy);

        /// <summary>
        /// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
        /// progress callback for instance: it lives on then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_free(tree_photo_session* session);

        /// <summary>
        /// Another seed: other particles, twigs and leaves in the same density.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_seed(tree_photo_session* session, ulong seed);

        /// <summary>
        /// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Painted
        /// density is lost when the density's parameters change. `control` may be NULL; only its limits matter.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_params(tree_photo_session* session, tree_photo_params* @params, tree_control* control);

        /// <summary>
        /// Moves a view's camera; NULL aligns it anew, from the front.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_placing(tree_photo_session* session, UIntPtr view, tree_photo_placing* placing);

        /// <summary>
        /// Paints and erases density in a view, in pixels. Branches found before stay as they are. `control` may be
        /// NULL; `nodes` of its limits caps the points of a stroke. `TREE_ERROR_PARAMETER` names the stroke that is
        /// out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_paint(tree_photo_session* session, UIntPtr view, tree_density_stroke* strokes, UIntPtr n_strokes, tree_control* control);

        /// <summary>
        /// Replaces a view's matte by one of the same size, for instance after another matting. Camera and branches
        /// found before stay as they are; `tree_photo_session_redo_from` finds them anew. `TREE_ERROR_NO_RESULT` for
        /// another size.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_matte(tree_photo_session* session, UIntPtr view, tree_matte* matte);

        /// <summary>
        /// Paints density in space, after it has been found from the pictures, which is done first where it is not
        /// there. `TREE_ERROR_PARAMETER` names the brush that is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_paint_volume(tree_photo_session* session, tree_density_brush* brushes, UIntPtr n_brushes, tree_control* control);

        /// <summary>
        /// Replaces the density, for instance by that of another source; it is copied.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_density(tree_photo_session* session, tree_grid* density);

        /// <summary>
        /// Where a view's branches come from; NULL is livewire from points on the silhouette. All views' branches
        /// are found anew. `control` may be NULL; only its limits matter.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_set_branches(tree_photo_session* session, UIntPtr view, tree_photo_branches* branches, tree_control* control);

        /// <summary>
        /// Changes a view's branches by hand: ask for them with `tree_photo_session_attractor`, change them with the
        /// functions of `tree_attractor`, and hand the new graph over here. Other views' branches are not found anew.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_edit_attractor(tree_photo_session* session, UIntPtr view, tree_attractor* attractor, tree_control* control);

        /// <summary>
        /// Forgets the result of a stage and of all that depend on it, so that they are done again.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_redo_from(tree_photo_session* session, uint stage);

        /// <summary>
        /// Number of photographs.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_count(tree_photo_session* session, UIntPtr* n_shots);

        /// <summary>
        /// Number of views: the photographs, and where all are from one side, an imagined one that comes last; see
        /// `imagine` of the `tree_photo_params`. Cameras, branches and fields can be asked for of all of them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_count_views(tree_photo_session* session, tree_control* control, UIntPtr* n_views);

        /// <summary>
        /// The seed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_seed(tree_photo_session* session, ulong* seed);

        /// <summary>
        /// The parameters, all parts given. What they point at belongs to the session and stays until
        /// `tree_photo_session_set_params` or `tree_photo_session_free`. Set `params-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_params(tree_photo_session* session, tree_photo_params* @params);

        /// <summary>
        /// How often a stage has been done so far.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_runs(tree_photo_session* session, uint stage, uint* n_runs);

        /// <summary>
        /// A view's matte as it is now, painted or not. Free it with `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_matte(tree_photo_session* session, UIntPtr view, tree_matte** matte);

        /// <summary>
        /// A view's photograph. Free it with `tree_photo_free`. `TREE_ERROR_NO_RESULT` for a view without one.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_photo(tree_photo_session* session, UIntPtr view, tree_photo** photo);

        /// <summary>
        /// A view's camera, found in its matte or as it was given. Set `camera-&gt;struct_size` first.
        /// `TREE_ERROR_NO_RESULT` names a photograph in which no tree is found.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_camera(tree_photo_session* session, UIntPtr view, tree_control* control, tree_particle_camera* camera);

        /// <summary>
        /// A view's main branches; an empty graph where there are none. Free it with `tree_attractor_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_attractor(tree_photo_session* session, UIntPtr view, tree_control* control, tree_attractor** attractor);

        /// <summary>
        /// A view's main branches as strokes, one for each segment: what `TREE_BRANCHES_STROKES` takes, to draw on
        /// where the library left off. Free them with `tree_strokes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_strokes(tree_photo_session* session, UIntPtr view, tree_control* control, tree_strokes** strokes);

        /// <summary>
        /// The density in space, optical depth per metre. Free it with `tree_grid_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_density(tree_photo_session* session, tree_control* control, tree_grid** density);

        /// <summary>
        /// The direction field of a view. Free it with `tree_direction_field_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_field(tree_photo_session* session, UIntPtr view, tree_control* control, tree_direction_field** field);

        /// <summary>
        /// The particles' traces. Free them with `tree_traces_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_traces(tree_photo_session* session, tree_control* control, tree_traces** traces);

        /// <summary>
        /// Branches without twigs. Free the skeleton with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_wood(tree_photo_session* session, tree_control* control, tree_skeleton** wood);

        /// <summary>
        /// The tree. The same photographs, parameters and seed give the same bits for any number of threads and in
        /// whatever order the session was changed. `control` and `report` may be NULL. Free the tree with
        /// `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_tree(tree_photo_session* session, tree_control* control, tree_photo_report* report, tree_tree** tree);

        /// <summary>
        /// What one view gave, an imagined one too. The tree is made first where it is not there. Set
        /// `report-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_view_report(tree_photo_session* session, UIntPtr view, tree_control* control, tree_photo_view_report* report);

        /// <summary>
        /// For each of a view's strokes the gap in pixels that was closed to join it; NaN where it was left out. The
        /// tree is made first where it is not there. `gaps` has room for `capacity` floats, one for each stroke.
        /// Nothing is written for a view without strokes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_gaps(tree_photo_session* session, UIntPtr view, tree_control* control, float* gaps, UIntPtr capacity);

        /// <summary>
        /// Where the views do not agree with each other: `TREE_ALIGN_CROWN_BASE` and `TREE_ALIGN_CROWN_WIDTH`. Their
        /// number goes into `n_warnings`, they themselves into `warnings`, which has room for `capacity` rows; with
        /// NULL they are only counted. The tree is made first where it is not there.
        /// `tree_align_warnings_text` puts them into words.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_disagreements(tree_photo_session* session, tree_control* control, tree_align_warning* warnings, UIntPtr capacity, UIntPtr* n_warnings);

        /// <summary>
        /// Everything doubtful, a line each, for a person to read; none where all went well. The tree is made first
        /// where it is not there. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_warnings(tree_photo_session* session, tree_control* control, tree_lines** warnings);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_params_init(tree_photo_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields and parts are in order: `TREE_OK`, or the error that their use would give. `control`
        /// may be NULL; only its limits matter.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_params_check(tree_photo_params* @params, tree_control* control);

        /// <summary>
        /// A view's matte: white where the tree covers. Free the picture with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_draw_matte(tree_photo_session* session, UIntPtr view, tree_photo** picture);

        /// <summary>
        /// A view's branches over its photograph, the base as a dot. Free the picture with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_draw_attractor(tree_photo_session* session, UIntPtr view, tree_control* control, tree_photo** picture);

        /// <summary>
        /// A view's direction field as arrows over its matte. Free the picture with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_draw_field(tree_photo_session* session, UIntPtr view, tree_control* control, tree_photo** picture);

        /// <summary>
        /// The particles' traces over a view's photograph, thicker where more went. Free the picture with
        /// `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_draw_traces(tree_photo_session* session, UIntPtr view, tree_control* control, tree_photo** picture);

        /// <summary>
        /// Horizontal slices through the density, from the base up: light where it is dense, seen from above with
        /// the front below. Free the picture with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_session_draw_density(tree_photo_session* session, tree_control* control, tree_photo** picture);

        /// <summary>
        /// Makes `placing`, of `size` bytes, the default: aligned, from the front, from afar.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_placing_init(tree_photo_placing* placing, UIntPtr size);

        /// <summary>
        /// Makes `branches`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_branches_init(tree_photo_branches* branches, UIntPtr size);

        /// <summary>
        /// Makes `shot`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_shot_init(tree_photo_shot* shot, UIntPtr size);

        /// <summary>
        /// Makes a tree of `n_shots` photographs, 1 to 1000: a session (`tree_photo_session`) that is asked for its
        /// tree, in one call. `params` may be NULL for the defaults, `control` and `report` may be NULL. Free the tree
        /// with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
        /// photograph of no use; `TREE_ERROR_LIMIT` comes before the memory is asked for.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_from_photos(tree_photo_shot* shots, UIntPtr n_shots, tree_photo_params* @params, ulong seed, tree_control* control, tree_photo_report* report, tree_tree** tree);

        /// <summary>
        /// Makes `view`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_view_init(tree_particle_view* view, UIntPtr size);

        /// <summary>
        /// Joins nodes that are nearer than a linking distance by edges of random cost. `params` and `control` may
        /// be NULL. The same `seed` gives the same graph. Free it with `tree_graph_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_link(tree_graph_nodes* nodes, tree_link_params* @params, ulong seed, tree_control* control, tree_graph** graph);

        /// <summary>
        /// Makes a graph from elsewhere: `positions` is `n_nodes` times three floats, `edges` is `n_edges` times
        /// the two nodes that it joins, `costs` a finite cost of 0 or more for each edge. `control` may be NULL;
        /// only its limits matter. Free the graph with `tree_graph_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_from_edges(float* positions, UIntPtr n_nodes, uint* edges, float* costs, UIntPtr n_edges, tree_control* control, tree_graph** graph);

        /// <summary>
        /// Views a graph. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_view(tree_graph* graph, tree_graph_columns* columns);

        /// <summary>
        /// Finds the least-cost paths from `root` to all nodes. `costs`, NULL or with room for `capacity` floats,
        /// gets for each node what the path to it costs, infinity where there is none; `predecessors`, NULL or with
        /// room for `capacity` numbers, gets the node before it on that path, or `TREE_NO_NODE`. `capacity` must
        /// reach for all nodes. A root that does not exist reaches nothing. `control` may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_search(tree_graph* graph, uint root, tree_control* control, float* costs, uint* predecessors, UIntPtr capacity);

        /// <summary>
        /// Frees a graph.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_free(tree_graph* graph);

        /// <summary>
        /// Grows a tree of least-cost paths. The same parameters and `seed` give the same bits for any number of
        /// threads. `params` may be NULL for an oak, `control` and `report` may be NULL. Free the tree with
        /// `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` says why
        /// nothing grows, for instance a root outside the volume; `TREE_ERROR_LIMIT` comes before the level that
        /// would exceed a limit.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_grow(tree_path_params* @params, ulong seed, tree_control* control, tree_path_report* report, tree_tree** tree);

        /// <summary>
        /// As `tree_path_grow`, and hands out the level at which each node of the skeleton was grown: a byte for
        /// each node, from 1 for the base volume, 0 for nodes of the root system. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_grow_with_levels(tree_path_params* @params, ulong seed, tree_control* control, tree_path_report* report, tree_bytes** node_levels, tree_tree** tree);

        /// <summary>
        /// Makes `level`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_level_init(tree_path_level* level, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strew_params_init(tree_strew_params* @params, UIntPtr size);

        /// <summary>
        /// Strews nodes evenly in a bounded volume, none closer than a separation that follows from their number.
        /// `params` and `control` may be NULL. The same `seed` gives the same nodes. Free them with
        /// `tree_graph_nodes_free`. `TREE_ERROR_NO_RESULT` when the volume has no end or no inside.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_strew(tree_volume* volume, tree_strew_params* @params, ulong seed, tree_control* control, tree_graph_nodes** nodes);

        /// <summary>
        /// Views strewn nodes. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_nodes_view(tree_graph_nodes* nodes, tree_graph_nodes_columns* columns);

        /// <summary>
        /// Frees strewn nodes. Graphs made of them live on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_graph_nodes_free(tree_graph_nodes* nodes);

        /// <summary>
        /// Makes `params`, of `size` bytes, an oak: a good tree to begin with.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_params_init(tree_path_params* @params, UIntPtr size);

        /// <summary>
        /// Checks that all parameters lie in their ranges, as `tree_path_grow` does first. `params` may be NULL for
        /// an oak; `control` may be NULL, only its limits matter.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_check(tree_path_params* @params, tree_control* control);

        /// <summary>
        /// Radius in metres of the subgraphs of `params-&gt;levels[index]`: its own, or the one that follows from
        /// `size` and `shrink`. `params` may be NULL for an oak.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_level_radius(tree_path_params* @params, UIntPtr index, float* radius);

        /// <summary>
        /// Number of presets: an oak, the twelve trees of Xu and Mould (2012), and two root systems.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr tree_path_preset_count();

        /// <summary>
        /// Name of a preset, such as `oak`, and what the tree looks like, in a few words. `index` is below
        /// `tree_path_preset_count`; `title` may be NULL. Both texts are valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_preset_name(UIntPtr index, tree_str* name, tree_str* title);

        /// <summary>
        /// Seconds that the tree took the authors of the method, in 2012; 0 where it is none of theirs. `index` is
        /// below `tree_path_preset_count`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_preset_paper_seconds(UIntPtr index, float* seconds);

        /// <summary>
        /// Makes `params`, of `size` bytes, the preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). What
        /// it points at belongs to the library and lives for ever. `TREE_ERROR_UNKNOWN_NAME` lists the names there
        /// are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_path_preset(byte* name, UIntPtr len, tree_path_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_profile_options_init(tree_profile_options* options, UIntPtr size);

        /// <summary>
        /// Reads a profile from an SVG drawing, `svg` of `len` bytes or `TREE_NUL_TERMINATED`. A closed shape is
        /// the outline of a tree: at every height half of its width becomes the radius. An open curve is a
        /// profile: its distance from the axis becomes the radius; the axis is an element whose id is `axis`, or
        /// else the vertical through the curve's leftmost point. `options` and `control` may be NULL. Free the
        /// profile with `tree_profile_free`. `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing to use.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_profile_from_svg(byte* svg, UIntPtr len, tree_profile_options* options, tree_control* control, tree_profile** profile);

        /// <summary>
        /// Views a profile. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_profile_view(tree_profile* profile, tree_profile_columns* columns);

        /// <summary>
        /// The solid of revolution of a profile round a vertical axis through `base`, three floats. Free it with
        /// `tree_volume_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_profile_volume(tree_profile* profile, float* @base, tree_volume** volume);

        /// <summary>
        /// Frees a profile.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_profile_free(tree_profile* profile);

        /// <summary>
        /// As `tree_profile_from_svg` and `tree_profile_volume` in one.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_from_svg(byte* svg, UIntPtr len, tree_profile_options* options, float* @base, tree_control* control, tree_volume** volume);

        /// <summary>
        /// Makes `paint`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_paint_init(tree_paint* paint, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_link_params_init(tree_link_params* @params, UIntPtr size);

        /// <summary>
        /// Whether the segment from `a` to `b`, three floats each, stays outside `obstacle` by at least
        /// `clearance` metres, 0 or more: 1 or 0. Where both are the same it is asked of the one point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_obstacle_is_free(tree_volume* obstacle, float clearance, float* a, float* b, uint* is_free);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_align_params_init(tree_align_params* @params, UIntPtr size);

        /// <summary>
        /// Warnings as lines of text, one for each of `n_warnings`. Free them with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_align_warnings_text(tree_align_warning* warnings, UIntPtr n_warnings, tree_lines** lines);

        /// <summary>
        /// Finds the tree's base and top in a matte, and so its camera: a first arrangement, which says where it may
        /// be wrong; a camera written by hand does as well. `params`, `control` and `report` may be NULL; set
        /// `camera-&gt;struct_size` first. `TREE_ERROR_NO_RESULT` when nothing or everything is covered, the tree is
        /// less than two rows high, or a camera of this pitch and field of view cannot see a tree so.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_align(tree_matte* matte, tree_align_params* @params, tree_control* control, tree_particle_camera* camera, tree_align_report* report);

        /// <summary>
        /// Several views of one tree, made consistent: each gets the scale that makes its tree `height` metres high,
        /// 0.01 to 1000, so that tops and bases coincide. `mattes` and `params` have one for each of `n_views`, 1 to
        /// 1000; the heights in `params` are not used. `control` may be NULL. Free the result with
        /// `tree_aligned_free`. Errors as for `tree_align`; the text names the view.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_align_all(tree_matte** mattes, tree_align_params* @params, UIntPtr n_views, float height, tree_control* control, tree_aligned** aligned);

        /// <summary>
        /// The number of views.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_aligned_count(tree_aligned* aligned, UIntPtr* n_views);

        /// <summary>
        /// The camera of one view, and what was found there. `report` may be NULL; set `camera-&gt;struct_size` first.
        /// `TREE_ERROR_PARAMETER` for an index that names no view.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_aligned_camera(tree_aligned* aligned, UIntPtr index, tree_particle_camera* camera, tree_align_report* report);

        /// <summary>
        /// Views what disagrees between the views: where the warnings begin and how many there are.
        /// `tree_align_warnings_text` puts them into words.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_aligned_warnings(tree_aligned* aligned, tree_align_warning** warnings, UIntPtr* n_warnings);

        /// <summary>
        /// Frees cameras of views.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_aligned_free(tree_aligned* aligned);

        /// <summary>
        /// Makes a graph of columns, which are copied. `control` may be NULL; `nodes` of its limits counts. Free
        /// the graph with `tree_attractor_free`. `TREE_ERROR_INVALID` where a parent does not come before its node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_from_columns(tree_attractor_columns* columns, tree_control* control, tree_attractor** attractor);

        /// <summary>
        /// Views the columns of a graph. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_view(tree_attractor* attractor, tree_attractor_columns* columns);

        /// <summary>
        /// The point of a graph nearest to `at_pixel`, two floats in pixels from the top left. Set
        /// `nearest-&gt;struct_size` first; `nearest-&gt;found` says whether there is one.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_nearest(tree_attractor* attractor, float* at_pixel, tree_attractor_nearest_point* nearest);

        /// <summary>
        /// Length of all segments together, in pixels.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_length(tree_attractor* attractor, float* length);

        /// <summary>
        /// The nodes that none leads to, roots without children included. Free them with `tree_rows_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_tips(tree_attractor* attractor, tree_rows** tips);

        /// <summary>
        /// The graph drawn over a photograph or any other picture of the same size, with lines of `width` pixels
        /// in a colour `0xRRGGBBAA`. Free the new photograph with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_draw(tree_attractor* attractor, tree_photo* photo, float width, uint rgba, tree_photo** drawn);

        /// <summary>
        /// Frees a graph. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_free(tree_attractor* attractor);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_automatic_params_init(tree_automatic_params* @params, UIntPtr size);

        /// <summary>
        /// The matte of a photograph of a tree against sky; of one with alpha, its alpha. `params`, `control` and
        /// `report` may be NULL. `trimap`, which may be NULL, gets the trimap that was made, at a size of its own: to
        /// look at, or to draw over and hand to `tree_matte_natural`. It gets NULL where the photograph has alpha.
        /// `warnings`, which may be NULL, gets lines on what the result may suffer from. Free them with
        /// `tree_lines_free`, the trimap with `tree_trimap_free` and the matte with `tree_matte_free`.
        /// `TREE_ERROR_NO_RESULT` when no sky or nothing that could be a tree is found.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_automatic(tree_photo* photo, tree_automatic_params* @params, tree_control* control, tree_automatic_report* report, tree_trimap** trimap, tree_lines** warnings, tree_matte** matte);

        /// <summary>
        /// Makes `camera`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_init(tree_particle_camera* camera, UIntPtr size);

        /// <summary>
        /// Checks all numbers of a camera: `TREE_ERROR_PARAMETER` names the one out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_check(tree_particle_camera* camera);

        /// <summary>
        /// The directions of a camera in the world, as unit vectors: `right` in the picture, always horizontal,
        /// `up` in it, and `forward` into it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_frame(tree_particle_camera* camera, float* right, float* up, float* forward);

        /// <summary>
        /// A copy of a photograph with `n_marks` marks drawn over it, in their order. `control` may be NULL;
        /// `nodes` of its limits caps the marks. Free the new photograph with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_draw(tree_photo* photo, tree_mark* marks, UIntPtr n_marks, tree_control* control, tree_photo** drawn);

        /// <summary>
        /// A photograph of one colour all over, `0xRRGGBBAA`, to draw on. `control` may be NULL; only its limits
        /// matter. Free the photograph with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_blank(uint width, uint height, uint rgba, tree_control* control, tree_photo** photo);

        /// <summary>
        /// A matte in grey, white where the tree covers, to draw on. Free the photograph with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_of_matte(tree_matte* matte, tree_photo** photo);

        /// <summary>
        /// A new graph with one more stroke of `n_points` points, two floats each in pixels, joined where it is
        /// nearest. On an empty graph the stroke's lowest point becomes the root. `params`, `control` and `report`
        /// may be NULL. `gap`, which may be NULL, gets the gap in pixels that was closed; NaN where the stroke was left
        /// out. Free the new graph with `tree_attractor_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_add_stroke(tree_attractor* attractor, float* stroke, UIntPtr n_points, tree_stroke_params* @params, tree_control* control, tree_stroke_report* report, float* gap, tree_attractor** changed);

        /// <summary>
        /// A new graph without the segments that come within `radius` pixels (0 to 1e9) of an eraser's path of
        /// `n_points` points, two floats each in pixels; one point is a dab. Points that are not finite are left
        /// out. Roots stay. `cut_off` is a `TREE_CUT_OFF_` constant; `report` may be NULL. Free the new graph with
        /// `tree_attractor_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_erase(tree_attractor* attractor, float* eraser, UIntPtr n_points, float radius, uint cut_off, tree_erase_report* report, tree_attractor** changed);

        /// <summary>
        /// A new graph with everything within `radius` pixels (0 to 1e9) of `at_pixel` moved by `by_pixels`, less the
        /// farther it is; both are two floats. Roots stay where they are. Free the new graph with
        /// `tree_attractor_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_move_near(tree_attractor* attractor, float* at_pixel, float* by_pixels, float radius, tree_attractor** changed);

        /// <summary>
        /// A new graph with left and right exchanged, in a picture `width` pixels wide. Free it with
        /// `tree_attractor_free`. `TREE_ERROR_PARAMETER` for a width with which nodes would not be finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_mirrored(tree_attractor* attractor, float width, tree_attractor** changed);

        /// <summary>
        /// Views the lines: where they begin and how many there are. Valid until `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lines_view(tree_lines* lines, tree_str** texts, UIntPtr* n_texts);

        /// <summary>
        /// Frees lines of text.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_lines_free(tree_lines* lines);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_livewire_params_init(tree_livewire_params* @params, UIntPtr size);

        /// <summary>
        /// Finds paths from every seed to the base through what a photograph and its matte show, and joins them:
        /// main branches as least-cost paths. `photo` may be NULL: then the matte alone is looked at. `base_pixel`
        /// is two floats, `seeds` two floats each, in pixels from the top left: those of `tree_silhouette_seeds`, or
        /// what a person clicked on. The root of the graph is at the base, its tips are at the seeds; without seeds the
        /// graph is the base alone. `params`, `control` and `report` may be NULL. Free the graph with
        /// `tree_attractor_free`. `TREE_ERROR_NO_RESULT` where the matte is empty, or the photograph is of another
        /// size.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_livewire(tree_matte* matte, tree_photo* photo, float* base_pixel, float* seeds, UIntPtr n_seeds, tree_livewire_params* @params, tree_control* control, tree_livewire_report* report, tree_attractor** attractor);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_seed_params_init(tree_seed_params* @params, UIntPtr size);

        /// <summary>
        /// Up to `most` points (100,000 at most) on the silhouette of the crown, evenly spread, other ones for every
        /// `seed`: two floats each in pixels into `seeds`, and their number into `n_seeds`. `capacity`, in floats,
        /// must be twice the number found or more: `2 * most` is enough. `base_pixel`, two floats, is the tree's base.
        /// `params` and `control` may be NULL. `TREE_ERROR_NO_RESULT` where the matte is empty.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_seeds(tree_matte* matte, float* base_pixel, uint most, tree_seed_params* @params, ulong seed, tree_control* control, float* seeds, UIntPtr capacity, UIntPtr* n_seeds);

        /// <summary>
        /// Makes a matte of `width * height` floats, which are copied, rows from top to bottom; clamped to 0 to 1,
        /// not NaN. `control` may be NULL; only its limits matter. Free the matte with `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_from_alpha(uint width, uint height, float* alpha, UIntPtr n_pixels, tree_control* control, tree_matte** matte);

        /// <summary>
        /// The alpha of a photograph as a matte. Free it with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where all
        /// pixels are opaque or all transparent.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_of_photo(tree_photo* photo, tree_matte** matte);

        /// <summary>
        /// Views a matte. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_view(tree_matte* matte, tree_matte_columns* columns);

        /// <summary>
        /// Writes the values at `n_spots` points of a matte, two floats each in pixels from the top left, between
        /// pixel centres by bilinear interpolation; 0 outside. `capacity` must be `n_spots` or more. `control` may
        /// be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_sample(tree_matte* matte, float* spots, UIntPtr n_spots, tree_control* control, float* values, UIntPtr capacity);

        /// <summary>
        /// A matte with left and right exchanged. Free it with `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_mirrored(tree_matte* matte, tree_matte** mirrored);

        /// <summary>
        /// A view mirrored and a quarter turn round: what a tree may look like from its side, where there is one
        /// photograph only. `photo` may be NULL, and `turned_photo` too, which gets NULL without a photograph. Set
        /// `turned_camera-&gt;struct_size` first. Free what comes out with `tree_photo_free` and `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_turned(tree_matte* matte, tree_photo* photo, tree_particle_camera* camera, tree_particle_camera* turned_camera, tree_photo** turned_photo, tree_matte** turned);

        /// <summary>
        /// A matte as a PNG file in memory: grey, black for 0 and white for 1. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_to_png(tree_matte* matte, tree_bytes** bytes);

        /// <summary>
        /// Writes a matte to a PNG file, as `tree_matte_to_png`, whole or not at all. The path, in UTF-8, has
        /// `path_len` bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_write_png(tree_matte* matte, byte* path, UIntPtr path_len);

        /// <summary>
        /// Frees a matte. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_free(tree_matte* matte);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_natural_params_init(tree_natural_params* @params, UIntPtr size);

        /// <summary>
        /// The matte of a photograph of which a trimap is known, by closed-form matting. A trimap of another size is
        /// sampled when its proportions agree within 2 %. Known pixels keep their alpha; an alpha channel of the
        /// photograph is ignored. `params`, `control` and `report` may be NULL. `warnings`, which may be NULL, gets
        /// lines on what the result may suffer from; free them with `tree_lines_free`, and the matte with
        /// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the trimap does not fit, or knows no tree or no background.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_natural(tree_photo* photo, tree_trimap* trimap, tree_natural_params* @params, tree_control* control, tree_natural_report* report, tree_lines** warnings, tree_matte** matte);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_screen_params_init(tree_screen_params* @params, UIntPtr size);

        /// <summary>
        /// The matte of a photograph taken before a blue or green screen. Its own alpha is ignored. `params` and
        /// `control` may be NULL. Free the matte with `tree_matte_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_screen(tree_photo* photo, tree_screen_params* @params, tree_control* control, tree_matte** matte);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_difference_params_init(tree_difference_params* @params, UIntPtr size);

        /// <summary>
        /// The matte of a photograph of which `plate` shows the same view without the tree: the tree is where both
        /// differ. Their own alpha is ignored. `params` and `control` may be NULL. Free the matte with
        /// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the photographs differ in size.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_matte_difference(tree_photo* photo, tree_photo* plate, tree_difference_params* @params, tree_control* control, tree_matte** matte);

        /// <summary>
        /// Makes a photograph of `4 * width * height` bytes of a program's own, which are copied: red, green, blue
        /// and alpha for each pixel, rows from top to bottom. `control` may be NULL; only its limits matter. Free
        /// the photograph with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_from_pixels(uint width, uint height, byte* pixels, UIntPtr n_bytes, tree_control* control, tree_photo** photo);

        /// <summary>
        /// Reads a PNG or JPEG file, recognised by its content. A photograph is turned upright as its camera noted.
        /// `control` may be NULL; `input_bytes` and `pixels` of its limits are looked at before the picture is
        /// decoded. Free the photograph with `tree_photo_free`. `TREE_ERROR_FORMAT` for what is no such picture.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_read(byte* path, UIntPtr path_len, tree_control* control, tree_photo** photo);

        /// <summary>
        /// As `tree_photo_read`, of a file held in memory: `len` bytes from `data` on, which are not kept.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_from_bytes(byte* data, UIntPtr len, tree_control* control, tree_photo** photo);

        /// <summary>
        /// Views a photograph's pixels, and says how large it is. Set `pixels-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_view(tree_photo* photo, tree_pixels* pixels);

        /// <summary>
        /// Whether any pixel is not fully opaque: 1 or 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_has_alpha(tree_photo* photo, uint* is_translucent);

        /// <summary>
        /// A photograph with left and right exchanged. Free it with `tree_photo_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_mirrored(tree_photo* photo, tree_photo** mirrored);

        /// <summary>
        /// A photograph as a PNG file in memory, with alpha. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_to_png(tree_photo* photo, tree_bytes** bytes);

        /// <summary>
        /// Writes a photograph to a PNG file, with alpha, whole or not at all. The path, in UTF-8, has `path_len`
        /// bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_write_png(tree_photo* photo, byte* path, UIntPtr path_len);

        /// <summary>
        /// Frees a photograph. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_free(tree_photo* photo);

        /// <summary>
        /// Writes the pixels that `n_points` points of the world fall on, of three floats each in metres: two floats
        /// for each, in pixels from the top left; NaN behind the camera or beside it. `capacity`, in floats, must be
        /// `2 * n_points` or more. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_project(tree_particle_camera* camera, float* points, UIntPtr n_points, tree_control* control, float* spots, UIntPtr capacity);

        /// <summary>
        /// Writes for each of `n_points` points of the world, three floats each in metres, how many metres a pixel
        /// is at its depth. `capacity` must be `n_points` or more. `control` as for `tree_particle_camera_project`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_pixel_sizes(tree_particle_camera* camera, float* points, UIntPtr n_points, tree_control* control, float* sizes, UIntPtr capacity);

        /// <summary>
        /// Writes the rays through `n_spots` points of the picture, two floats each in pixels from the top left: six
        /// floats for each, a point on it in metres and its unit direction. In perspective the point is where the
        /// camera stands, in parallel projection it lies on the plane through the base. `capacity`, in floats, must
        /// be `6 * n_spots` or more. `control` as for `tree_particle_camera_project`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_rays(tree_particle_camera* camera, float* spots, UIntPtr n_spots, tree_control* control, float* rays, UIntPtr capacity);

        /// <summary>
        /// The camera for a renderer, to draw the tree as the photograph shows it. Set `stand-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_stand(tree_particle_camera* camera, tree_particle_stand* stand);

        /// <summary>
        /// The same as a view for `tree_render` and `tree_render_mask`: of the photograph's size, with the camera
        /// placed; everything else is the default. Set `view-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_particle_camera_view(tree_particle_camera* camera, tree_view* view);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stroke_params_init(tree_stroke_params* @params, UIntPtr size);

        /// <summary>
        /// Makes a graph of strokes that a person drew, whose root is at `base_pixel`, two floats. `params`,
        /// `control` and `report` may be NULL; `nodes` of the limits caps the points. `gaps`, which may be NULL, gets
        /// for each stroke the gap in pixels that was closed, NaN where the stroke was left out; `capacity` must be the
        /// number of strokes or more. Free the graph with `tree_attractor_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_attractor_from_strokes(tree_strokes_columns* columns, float* base_pixel, tree_stroke_params* @params, tree_control* control, tree_stroke_report* report, float* gaps, UIntPtr capacity, tree_attractor** attractor);

        /// <summary>
        /// Reads the strokes of an SVG drawing made over a picture of `width` x `height` pixels, 1 to 1e6 each: `svg`
        /// of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line and polyline with its transforms is one, a
        /// closed shape is a loop. The drawing's view box (or its width and height) is stretched to the picture;
        /// without either its units are pixels. `control` may be NULL. Free the strokes with `tree_strokes_free`.
        /// `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strokes_from_svg(byte* svg, UIntPtr len, float width, float height, tree_control* control, tree_strokes** strokes);

        /// <summary>
        /// Views strokes, as `tree_attractor_from_strokes` takes them. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strokes_view(tree_strokes* strokes, tree_strokes_columns* columns);

        /// <summary>
        /// Frees strokes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strokes_free(tree_strokes* strokes);

        /// <summary>
        /// Makes a trimap of `width * height` bytes, each a `TREE_LEVEL_` constant, rows from top to bottom.
        /// `control` may be NULL; only its limits matter. Free the trimap with `tree_trimap_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_from_levels(uint width, uint height, byte* levels, UIntPtr n_pixels, tree_control* control, tree_trimap** trimap);

        /// <summary>
        /// Reads a drawn trimap: black is background, white the tree, grey (and transparent) unknown. Free the
        /// trimap with `tree_trimap_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_of_photo(tree_photo* photo, tree_trimap** trimap);

        /// <summary>
        /// Makes `stroke`, of `size` bytes, the default: one without points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_stroke_init(tree_trimap_stroke* stroke, UIntPtr size);

        /// <summary>
        /// Paints `n_strokes` strokes, in their order, over a trimap of `width` x `height` pixels of which nothing is
        /// known. `control` may be NULL; `pixels` of its limits caps the trimap, `nodes` the points of a stroke. Free
        /// the trimap with `tree_trimap_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_from_strokes(uint width, uint height, tree_trimap_stroke* strokes, UIntPtr n_strokes, tree_control* control, tree_trimap** trimap);

        /// <summary>
        /// Makes `samples`, of `size` bytes, the default: no colours.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_color_samples_init(tree_color_samples* samples, UIntPtr size);

        /// <summary>
        /// Marks the pixels of a photograph that look like one of the sampled colours; where both sides do, the
        /// nearer sample decides. `control` may be NULL; `nodes` of its limits caps the samples. Free the trimap
        /// with `tree_trimap_free`. `TREE_ERROR_INVALID` when either side has no sample.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_from_colors(tree_photo* photo, tree_color_samples* samples, tree_control* control, tree_trimap** trimap);

        /// <summary>
        /// Views a trimap. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_view(tree_trimap* trimap, tree_trimap_columns* columns);

        /// <summary>
        /// Frees a trimap.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_trimap_free(tree_trimap* trimap);

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
        /// Frees a pool, and returns when its threads have left its work. A host that unloads the library joins
        /// threads of its own first: what the library keeps for each thread goes when the thread ends. `TREE_ERROR_ORDER`, and the
        /// pool lives on, while a call is at work on it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pool_free(tree_pool* pool);

        /// <summary>
        /// Views a mask. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mask_view(tree_mask* mask, tree_mask_columns* columns);

        /// <summary>
        /// Writes a byte for each pixel, rows from top to bottom: 1 where at least half of the pixel is covered,
        /// else 0. `capacity` must be `width * height` or more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mask_bits(tree_mask* mask, byte* bits, UIntPtr capacity);

        /// <summary>
        /// The mask in black on white. Free the picture with `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mask_picture(tree_mask* mask, tree_picture** picture);

        /// <summary>
        /// Frees a mask.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mask_free(tree_mask* mask);

        /// <summary>
        /// Makes a picture of `4 * width * height` bytes of a program's own, which are copied. `control` may be
        /// NULL; only its limits matter. Free the picture with `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_picture_from_pixels(uint width, uint height, byte* pixels, UIntPtr n_bytes, tree_control* control, tree_picture** picture);

        /// <summary>
        /// Views a picture's pixels. Set `pixels-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_picture_view(tree_picture* picture, tree_pixels* pixels);

        /// <summary>
        /// Writes a picture to a PNG file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends
        /// with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_picture_write_png(tree_picture* picture, byte* path, UIntPtr path_len);

        /// <summary>
        /// A picture as a PNG file in memory. Free it with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_picture_to_png(tree_picture* picture, tree_bytes** bytes);

        /// <summary>
        /// Frees a picture.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_picture_free(tree_picture* picture);

        /// <summary>
        /// Draws a picture of a mesh. `view`, `style` and `control` may be NULL. Back faces are drawn too, with
        /// their normals turned over; an empty mesh gives the ground alone. Progress is told in the stages
        /// `textures`, `light` and `picture`. The same mesh and parameters give the same bytes on every platform
        /// and for any number of threads. Free the picture with `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_render(tree_mesh* mesh, tree_view* view, tree_style* style, tree_control* control, tree_picture** picture);

        /// <summary>
        /// The share of each pixel that a mesh covers, by samples. There is no ground. `view` and `control` may
        /// be NULL. Free the mask with `tree_mask_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_render_mask(tree_mesh* mesh, tree_view* view, tree_control* control, tree_mask** mask);

        /// <summary>
        /// The mask of a mesh in black on white. `view` and `control` may be NULL. Free the picture with
        /// `tree_picture_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_render_silhouette(tree_mesh* mesh, tree_view* view, tree_control* control, tree_picture** picture);

        /// <summary>
        /// Makes `style`, of `size` bytes, the default: a clear day on grass.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_style_init(tree_style* style, UIntPtr size);

        /// <summary>
        /// Makes `style`, of `size` bytes, light grey paper with ground.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_style_studio(tree_style* style, UIntPtr size);

        /// <summary>
        /// Makes `view`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_view_init(tree_view* view, UIntPtr size);

        /// <summary>
        /// The same view with the camera placed where it stands for this mesh. `view` may be NULL for the
        /// default; `placed` may be the same struct. Set `placed-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_view_place(tree_view* view, tree_mesh* mesh, tree_view* placed);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gibbs_params_init(tree_gibbs_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_gibbs_params_check(tree_gibbs_params* @params);

        /// <summary>
        /// Finds a place in each of `n_domains` domains, at most 20,000, by a Gibbs process: branches keep apart, and keep to the
        /// pattern of `arrangement`. The same seed gives the same places. `params`, `control` and `report` may be NULL. Free the
        /// places with `tree_arranged_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arranged_new(tree_domain* domains, UIntPtr n_domains, tree_arrangement* arrangement, tree_gibbs_params* @params, ulong seed, tree_control* control, tree_arranged_report* report, tree_arranged** arranged);

        /// <summary>
        /// A ready pattern of `n` branches, at most 20,000, that may stand anywhere, sorted along the parent. Other variants are
        /// other draws of the same seed. It has no trace. `control` may be NULL. Free the places with `tree_arranged_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arranged_ready(uint n, tree_arrangement* arrangement, ulong variant, ulong seed, tree_control* control, tree_arranged** arranged);

        /// <summary>
        /// Views the places, one for each domain in their order: where they begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arranged_sites(tree_arranged* arranged, tree_site** sites, UIntPtr* n_sites);

        /// <summary>
        /// Views the cost at the start and after each kept move, which never rises: where the numbers begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arranged_trace(tree_arranged* arranged, float** costs, UIntPtr* n_costs);

        /// <summary>
        /// Frees places.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arranged_free(tree_arranged* arranged);

        /// <summary>
        /// Tests whether `n_sites` branches of one parent keep to an arrangement, by Rayleigh's test of the angles between
        /// one and the next. `control` may be NULL; `nodes` of its limits caps the places. Set `concentration-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sites_privileged(tree_site* sites, UIntPtr n_sites, tree_arrangement* arrangement, tree_control* control, tree_concentration* concentration);

        /// <summary>
        /// Makes `angles`, of `size` bytes, the default; its samples are valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branching_angles_init(tree_branching_angles* angles, UIntPtr size);

        /// <summary>
        /// The angles at `n_places` places along the parent, shares of its length from 0 to 1, into `values`, which has room for
        /// `capacity`. `angles` and `control` may be NULL; `nodes` of the limits caps the places.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branching_angles_at(tree_branching_angles* angles, float* places, UIntPtr n_places, tree_control* control, float* values, UIntPtr capacity);

        /// <summary>
        /// Takes the angle of a redrawn branch as a sample; it replaces those close to it, but the function keeps its ends. The
        /// samples go into `samples`, two floats each; `capacity` counts floats: two more samples than there are always have room.
        /// `n_samples` gets their number. `angles` stays as it is, and may be NULL for the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branching_angles_set(tree_branching_angles* angles, float place, float angle, float* samples, UIntPtr capacity, UIntPtr* n_samples);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_infer_params_init(tree_branch_infer_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_infer_params_check(tree_branch_infer_params* @params);

        /// <summary>
        /// Infers the branch that ends at `end` along `tangent` (two floats each; a tangent of zeros: from where it comes): the
        /// shortest curve from the parent, which is left at the branching angle. `parent` has `n_parent` points, two floats each, from
        /// its base to its tip; the branch may leave it between the shares `from` and `to` of its length, 0 and 1 for anywhere.
        /// `outline` is that of the foliage, which the branch keeps within where it can; NULL where there is none. The
        /// branch's line goes into `points`, from base to end, two floats each; `capacity` counts floats, and two for each of `points`
        /// of the parameters always do. `n_points` gets their number, `share` where it leaves the parent. `angles`, `params` and
        /// `control` may be NULL; `nodes` of the limits caps the points. `TREE_ERROR_NO_RESULT` where the end lies on the parent.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_infer(float* parent, UIntPtr n_parent, tree_outline* outline, tree_branching_angles* angles, float* end, float* tangent, float from, float to, tree_branch_infer_params* @params, tree_control* control, float* points, UIntPtr capacity, UIntPtr* n_points, float* share);

        /// <summary>
        /// Where a drawn branch leaves its parent: `share` gets the place nearest to its start as a share of the parent's length,
        /// `angle` the angle there in radians, 0 to π, and `is_left` whether the branch is on the parent's left side. Both are lines of
        /// two floats a point, from base to tip. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_base(float* parent, UIntPtr n_parent, float* branch, UIntPtr n_branch, tree_control* control, float* share, float* angle, uint* is_left);

        /// <summary>
        /// Carries the shape of a branch to another span. `branch` is its line, `n_branch` points from base to end of two floats
        /// each, `left` says whether it is on its parent's left side, and `outline` is that of its foliage. The same line on `span`
        /// goes into `points`; `capacity` counts floats, and `2 * n_branch` always do. `n_points` gets their number, `carried` the
        /// outline there. `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline with
        /// `tree_outline_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_carry(float* branch, UIntPtr n_branch, uint left, tree_outline* outline, tree_branch_span* span, tree_control* control, tree_branch_shape_report* report, float* points, UIntPtr capacity, UIntPtr* n_points, tree_outline** carried);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bump_params_init(tree_bump_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bump_params_check(tree_bump_params* @params);

        /// <summary>
        /// Finds the bumps of an outline by its chordal axis, in their order against the clock along it: one at least, which is the
        /// whole of an outline where nothing stands out. The foot of a crown, where the trunk comes in, may be one like every other.
        /// `params` and `control` may be NULL. Free the bumps with `tree_bumps_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_bumps(tree_outline* outline, tree_bump_params* @params, tree_control* control, tree_bumps** bumps);

        /// <summary>
        /// Views bumps: where they begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bumps_view(tree_bumps* bumps, tree_bump** rows, UIntPtr* n_rows);

        /// <summary>
        /// Frees bumps.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_bumps_free(tree_bumps* bumps);

        /// <summary>
        /// Makes `level`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_level_init(tree_silhouette_level* level, UIntPtr size);

        /// <summary>
        /// Makes `leaves`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_leaves_init(tree_silhouette_leaves* leaves, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_grow_params_init(tree_silhouette_grow_params* @params, UIntPtr size);

        /// <summary>
        /// Grows a tree of a plan: the same plan, parameters and seed give the same bits for any number of threads. `params`,
        /// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of
        /// range; `TREE_ERROR_LIMIT` comes before the memory is asked for.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_grow(tree_outline_plan* plan, tree_silhouette_grow_params* @params, ulong seed, tree_control* control, tree_silhouette_grown* report, tree_tree** tree);

        /// <summary>
        /// Makes a leaf of an outline that is attached at `base` and points to `tip`, two floats each. Its border is thinned to at most
        /// 64 corners. Free the leaf with `tree_leaf_outline_free`. `TREE_ERROR_INVALID` where both are the same point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_of(tree_outline* outline, float* @base, float* tip, tree_leaf_outline** leaf);

        /// <summary>
        /// As `tree_leaf_outline_of`, with base and tip as `tree_leaf_outline_ends` finds them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_guess(tree_outline* outline, tree_leaf_outline** leaf);

        /// <summary>
        /// Where a drawn leaf is attached and what it points to, as it looks: `base` gets the end of its stalk where it has one,
        /// else the lowest point near the middle of an upright leaf and the left end of a lying one; `tip` the point farthest from
        /// there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_ends(tree_outline* outline, float* @base, float* tip);

        /// <summary>
        /// Views a drawn leaf. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_view(tree_leaf_outline* leaf, tree_leaf_outline_columns* columns);

        /// <summary>
        /// The flat mesh of a drawn leaf; its picture, if it gets one, spans the leaf's bounds. Free the model with
        /// `tree_leaf_model_free`. `tree_leaf_model_view` views it as `mesh` of a `tree_leaf_look` takes it: with the form
        /// `TREE_LEAF_MESH` that goes into `tree_look_new` or `tree_look_with_leaf`, and all leaves of the kind are as drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_model(tree_leaf_outline* leaf, tree_leaf_model** model);

        /// <summary>
        /// Frees a drawn leaf.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_leaf_outline_free(tree_leaf_outline* leaf);

        /// <summary>
        /// Length in metres of a line of `n_line` points, two floats each: points that are not finite, and repeated ones, are left
        /// out. `control` may be NULL; `nodes` of its limits caps the points. `TREE_ERROR_INVALID` where fewer than two are left.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_line_length(float* line, UIntPtr n_line, tree_control* control, float* length);

        /// <summary>
        /// The points at `n_places` places along a line, shares of its length from 0 to 1, and its directions there, of unit
        /// length. `points` and `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. The line
        /// and `control` are as for `tree_line_length`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_line_at(float* line, UIntPtr n_line, float* places, UIntPtr n_places, tree_control* control, float* points, float* tangents, UIntPtr capacity);

        /// <summary>
        /// The place along a line that is nearest to each of `n_spots` points, two floats each. `shares` gets where that is as a
        /// share of the length, and `distances` how far it is from the point; each has room for `capacity`, and one may be NULL.
        /// The line and `control` are as for `tree_line_length`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_line_nearest(float* line, UIntPtr n_line, float* spots, UIntPtr n_spots, tree_control* control, float* shares, float* distances, UIntPtr capacity);

        /// <summary>
        /// A line by points at even distances, from `from` to a greater `to`, shares of its length from 0 to 1: `count` of them,
        /// 2 at least, or 0 for its own points there. They go into `points`, two floats each; `capacity` counts floats. `n_points`
        /// gets their number. The line and `control` are as for `tree_line_length`. `TREE_ERROR_NO_RESULT` where nothing is left.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_line_part(float* line, UIntPtr n_line, float from, float to, uint count, tree_control* control, float* points, UIntPtr capacity, UIntPtr* n_points);

        /// <summary>
        /// Says of `n_spots` points, two floats each, whether they lie inside: 1 or 0 into `inside`, which has room for
        /// `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_contains(tree_outline* outline, float* spots, UIntPtr n_spots, tree_control* control, byte* inside, UIntPtr capacity);

        /// <summary>
        /// How far it is along `n_rays` rays to the outline, the first crossing in front: each ray is four floats, its beginning
        /// and its direction, of unit length. `exits`, which has room for `capacity`, gets metres, infinite where there is no
        /// crossing; from outside it is the near side. `control` as for `tree_outline_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_exits(tree_outline* outline, float* rays, UIntPtr n_rays, tree_control* control, float* exits, UIntPtr capacity);

        /// <summary>
        /// The place along the outline that is nearest to each of `n_spots` points, two floats each. `lengths` gets how far that
        /// is along it, in metres against the clock from the first corner, and `distances` how far it is from the point; each has room
        /// for `capacity`, and one may be NULL. `control` as for `tree_outline_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_nearest(tree_outline* outline, float* spots, UIntPtr n_spots, tree_control* control, float* lengths, float* distances, UIntPtr capacity);

        /// <summary>
        /// The points at `n_lengths` lengths along an outline, in metres against the clock from the first corner, below 0 and beyond
        /// the perimeter on round; and the outline's directions there, of unit length, with the inside to the left. `points` and
        /// `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. `control` as for
        /// `tree_outline_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_along(tree_outline* outline, float* lengths, UIntPtr n_lengths, tree_control* control, float* points, float* tangents, UIntPtr capacity);

        /// <summary>
        /// The corners of the stretch from one length along an outline to another, both ends among them, into `points`, two floats
        /// each; `capacity` counts floats, and twice the corners plus four always do. `to` may exceed the perimeter where
        /// the stretch passes the first corner; it ends after once round. `n_points` gets their number: one where `to` is not above
        /// `from`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_part(tree_outline* outline, float from, float to, float* points, UIntPtr capacity, UIntPtr* n_points);

        /// <summary>
        /// Area that two outlines have in common, in square metres, within about 1 %; and the same over the area they cover
        /// together, 0 to 1 (the intersection over union).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_overlap(tree_outline* outline, tree_outline* other, float* area, float* iou);

        /// <summary>
        /// Which of the `width` by `height` cells between the corners `low` and `high`, two floats each, have their centres
        /// inside: 1 or 0 into `cells`, row by row from the lowest, each from the left. `cells` has room for `capacity`. `control`
        /// may be NULL; `pixels` of its limits caps the cells.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_mask(tree_outline* outline, float* low, float* high, uint width, uint height, tree_control* control, byte* cells, UIntPtr capacity);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_close_params_init(tree_outline_close_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_close_params_check(tree_outline_close_params* @params);

        /// <summary>
        /// Makes an outline of a drawn stroke of `n_points` points, two floats each, in metres, y up: it is closed, made simple and
        /// turned against the clock. `tree_outline_repairs` tells what was done. `name`, of `name_len` bytes or
        /// `TREE_NUL_TERMINATED`, is what messages call the stroke; NULL for none. `params` and `control` may be NULL; `nodes` of the
        /// limits caps the points. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` where fewer than three different
        /// points are left, or it encloses next to nothing.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_close(float* stroke, UIntPtr n_points, byte* name, UIntPtr name_len, tree_outline_close_params* @params, tree_control* control, tree_outline** outline);

        /// <summary>
        /// Makes an outline of points that already are one, two floats each: closed (the first is not repeated at the end), against
        /// the clock, without crossings, in metres, at most 4096. Nothing is repaired. `control` may be NULL; only its limits
        /// matter. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` says what is wrong and at which point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_from_points(float* spots, UIntPtr n_spots, tree_control* control, tree_outline** outline);

        /// <summary>
        /// Views an outline's corners and tells how large it is. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_view(tree_outline* outline, tree_outline_columns* columns);

        /// <summary>
        /// Views what was repaired or noticed by `tree_outline_close`, in that order: where the repairs begin and how many there are.
        /// None for other outlines.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_repairs(tree_outline* outline, tree_outline_repair** repairs, UIntPtr* n_repairs);

        /// <summary>
        /// A sentence for each repair. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_repairs_text(tree_outline* outline, tree_lines** lines);

        /// <summary>
        /// The same outline by `n_points` corners at even lengths from the first on, at least 3 and at most 4096. Where so few
        /// would make it cross itself, or so many are not allowed, it stays as it is. Free it with `tree_outline_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_resampled(tree_outline* outline, uint n_points, tree_control* control, tree_outline** resampled);

        /// <summary>
        /// The outline with every corner moved by an affine map, turned against the clock where that mirrors it. `affine` is six
        /// floats, a, b, c, d, e, f, as in SVG's matrices: x becomes a·x + c·y + e, y becomes b·x + d·y + f. Free the outline with
        /// `tree_outline_free`. `TREE_ERROR_NO_RESULT` where nothing is enclosed then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_transformed(tree_outline* outline, float* affine, tree_outline** transformed);

        /// <summary>
        /// Frees an outline. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_free(tree_outline* outline);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_cover_params_init(tree_cover_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_branch_system_params_init(tree_branch_system_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_params_init(tree_silhouette_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_params_check(tree_silhouette_params* @params);

        /// <summary>
        /// Reads an arrangement by name: `spread`, `spiral` (144°), `golden` (137.5°), `opposite`, `decussate`, `whorl3` (any number),
        /// `horizontal`, or `2:90` for two at a node and a turn of 90°. An angle in degrees may follow the names that have one:
        /// `spiral:137.5`, `whorl3:45`, `horizontal:30`. `text` has `len` bytes or is `TREE_NUL_TERMINATED`.
        /// `TREE_ERROR_UNKNOWN_NAME` for another name, `TREE_ERROR_PARAMETER` for a number out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arrangement_from_text(byte* text, UIntPtr len, tree_arrangement* arrangement);

        /// <summary>
        /// Writes an arrangement as `tree_arrangement_from_text` reads it, angles in degrees to two places. Free the bytes, which
        /// are UTF-8, with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arrangement_to_text(tree_arrangement* arrangement, tree_bytes** bytes);

        /// <summary>
        /// Tells the numbers behind an arrangement, and checks its ranges on the way. Set `numbers-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_arrangement_measure(tree_arrangement* arrangement, tree_arrangement_numbers* numbers);

        /// <summary>
        /// The domain of a branch that was drawn: at the share `along` of the parent's length, within 45° of the side it was
        /// drawn on, the left where `left` is not 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_domain_drawn(float along, uint left, tree_domain* domain);

        /// <summary>
        /// Says whether a place lies in a domain.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_domain_contains(tree_domain* domain, float along, float azimuth, uint* inside);

        /// <summary>
        /// How far an azimuth lies outside a domain, in radians, 0 to π.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_domain_outside(tree_domain* domain, float azimuth, float* angle);

        /// <summary>
        /// Views all branches. Valid until `tree_outline_plan_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_view(tree_outline_plan* plan, tree_outline_plan_columns* columns);

        /// <summary>
        /// The row of the branch of this id. `TREE_ERROR_INVALID` for an id that is not there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_find(tree_outline_plan* plan, uint id, UIntPtr* row);

        /// <summary>
        /// Views the branch of this id. Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_branch(tree_outline_plan* plan, uint id, tree_outline_branch* branch);

        /// <summary>
        /// Views the system on the branch of this id, or with `TREE_NO_BRANCH` that of the trunk, whose outline is the crown.
        /// Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there, `TREE_ERROR_NO_RESULT` for a
        /// branch whose outline was not drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_system(tree_outline_plan* plan, uint id, tree_outline_system* system);

        /// <summary>
        /// Of the system on a branch, or on the trunk, the outline in a further plane: how far the plane is turned about the
        /// axis, in radians from +X towards +Z, goes into `azimuth`. Free the outline with `tree_outline_free`.
        /// `TREE_ERROR_INVALID` for a section that is not there; else as `tree_outline_plan_system`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_section(tree_outline_plan* plan, uint id, UIntPtr section, float* azimuth, tree_outline** outline);

        /// <summary>
        /// The outline of a branch's foliage, or with `TREE_NO_BRANCH` the crown, as an object of its own. Free it with
        /// `tree_outline_free`. `TREE_ERROR_INVALID` for an id that is not there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_outline(tree_outline_plan* plan, uint id, tree_outline** outline);

        /// <summary>
        /// Number of levels of outlines that were drawn: 1 for the crown only, 2 with that of a branch, and so on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_count_levels(tree_outline_plan* plan, uint* n_levels);

        /// <summary>
        /// The drawn leaf, one long, and its length in metres. Free it with `tree_leaf_outline_free`. `TREE_ERROR_NO_RESULT`
        /// where none was drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_leaf(tree_outline_plan* plan, float* length, tree_leaf_outline** leaf);

        /// <summary>
        /// Frees a plan.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_plan_free(tree_outline_plan* plan);

        /// <summary>
        /// Makes a drawing of one tree of strokes, which are copied: one at least, in the order they were drawn. `name`, of
        /// `name_len` bytes or `TREE_NUL_TERMINATED`, is the tree's, NULL for none; `trunk_width` is the trunk's in units of the drawing,
        /// 0 where it is not known. `control` may be NULL; `nodes` of its limits caps the points of all strokes. Free the drawing
        /// with `tree_outline_drawing_free`. `TREE_ERROR_INVALID` names a point that is not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_new(tree_drawn_stroke* strokes, UIntPtr n_strokes, byte* name, UIntPtr name_len, float trunk_width, tree_control* control, tree_outline_drawing** drawing);

        /// <summary>
        /// Reads outlines from an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. What is not seen is left out.
        ///
        /// Layers are groups, or single shapes, by id, class, layer label or name: `L0`, `L1`, `L2` and so on, and `leaf`. `L0@90` is
        /// drawn in a plane turned about the trunk by so many degrees. In `L0`, what is named *trunk* or *stem*, and an open line,
        /// is the trunk; what is closed or filled is the crown. In other layers what is closed or filled is the outline of a
        /// branch, and an open line a branch redrawn. Groups named `tree`, `tree1`, `tree-oak` hold one tree each.
        ///
        /// Without layers what is filled is one silhouette for each tree: its trunk is what is named so, or what is brown where
        /// something else is green, or the narrow part above the foot; the rest is its crown.
        ///
        /// `control` may be NULL; only its limits matter. Free the drawing with `tree_outline_drawing_free`. `TREE_ERROR_FORMAT` when
        /// the text is no SVG, draws nothing, or nothing of it is a tree.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_from_svg(byte* svg, UIntPtr len, tree_control* control, tree_outline_drawing** drawing);

        /// <summary>
        /// Trunk and crown of the tree that a matte shows, in pixels, y downwards. Pixels covered to `threshold` or more belong to
        /// it, 0.01 to 1; 0.5 is usual. Fine details are smoothed away and the gaps of a frayed crown closed, so that the outline is
        /// one that can be drawn: at most 400 points. `control` may be NULL. Free the drawing with `tree_outline_drawing_free`.
        /// `TREE_ERROR_INVALID` where nothing is covered.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_of_matte(tree_matte* matte, float threshold, tree_control* control, tree_outline_drawing** drawing);

        /// <summary>
        /// As `tree_outline_drawing_of_matte`, of a photograph that has been cut out, or of a mask in black and white: a half of
        /// `tree_photo_mask`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_of_photo(tree_photo* photo, tree_control* control, tree_outline_drawing** drawing);

        /// <summary>
        /// The matte of a picture of one tree: its alpha where it has one; else how dark it is, for a tree on a light border, or how
        /// light, for one on a dark border. `control` may be NULL. Free the matte with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where
        /// the picture is transparent everywhere.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_photo_mask(tree_photo* photo, tree_control* control, tree_matte** matte);

        /// <summary>
        /// Number of trees, one at least.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_count(tree_outline_drawing* drawing, UIntPtr* n_trees);

        /// <summary>
        /// Views a tree of a drawing. `index` is below `tree_outline_drawing_count`. Set `tree-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_tree(tree_outline_drawing* drawing, UIntPtr index, tree_drawn_tree* tree);

        /// <summary>
        /// Views a stroke of tree `number` of a drawing. `index` is below the tree's `n_strokes`. Set `stroke-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_stroke(tree_outline_drawing* drawing, UIntPtr number, UIntPtr index, tree_drawn_stroke* stroke);

        /// <summary>
        /// Views what was repaired or noticed when the drawing was read: where the repairs begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_repairs(tree_outline_drawing* drawing, tree_drawn_repair** repairs, UIntPtr* n_repairs);

        /// <summary>
        /// A sentence for each repair. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_repairs_text(tree_outline_drawing* drawing, tree_lines** lines);

        /// <summary>
        /// Frees a drawing of outlines. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_drawing_free(tree_outline_drawing* drawing);

        /// <summary>
        /// Makes the surface through `n_sections` outlines, 1 to 1000, round an axis of `n_axis` points, two floats each, which is drawn in the
        /// plane of azimuth 0. Outline `i` is what is seen in a plane turned about the vertical to `azimuths[i]` radians: 0 for the
        /// drawing, π/2 for one seen from its right side; metres, x to that plane's right, y up, the tree's base at the origin.
        /// Between their halves the surface is blended. `control` may be NULL; `nodes` of the limits caps the points of the axis.
        /// Free the surface with `tree_revolved_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_of(float* axis, UIntPtr n_axis, tree_outline** outlines, float* azimuths, UIntPtr n_sections, tree_control* control, tree_revolved** revolved);

        /// <summary>
        /// Tells the frame of a surface. Set `frame-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_view(tree_revolved* revolved, tree_revolved_frame* frame);

        /// <summary>
        /// Brings `n_spots` points of the drawing, two floats each, into the frame of the axis: (r, y) each into `places`, which has
        /// room for `capacity` floats. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_to_frame(tree_revolved* revolved, float* spots, UIntPtr n_spots, tree_control* control, float* places, UIntPtr capacity);

        /// <summary>
        /// The half of the surface at an azimuth: points (r, y) in metres, from top to bottom, two floats each into `points`;
        /// `capacity` counts floats. `n_points` gets their number; where `capacity` is too small, `TREE_ERROR_BUFFER` says how many floats
        /// are needed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_half(tree_revolved* revolved, float azimuth, float* points, UIntPtr capacity, UIntPtr* n_points);

        /// <summary>
        /// The outline of both halves at an azimuth and across from it, in (r, y). Free it with `tree_outline_free`.
        /// `TREE_ERROR_NO_RESULT` where nothing is left of it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_profile(tree_revolved* revolved, float azimuth, tree_outline** outline);

        /// <summary>
        /// How far it is along `n_rays` rays to the surface: each ray is four floats, its beginning (r, y) and its direction, of
        /// unit length, in the half-plane of the azimuth in `azimuths`. `exits`, which has room for `capacity`, gets metres,
        /// infinite from outside. A ray may lead across the axis. `control` may be NULL; `nodes` of its limits caps the rays.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_exits(tree_revolved* revolved, float* rays, float* azimuths, UIntPtr n_rays, tree_control* control, float* exits, UIntPtr capacity);

        /// <summary>
        /// Says of `n_points` points in the frame of the axis, three floats each (x to the right of the drawing, y along the span, z
        /// towards azimuth π/2), whether they lie inside: 1 or 0 into `inside`, which has room for `capacity`. `control` may be
        /// NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_contains(tree_revolved* revolved, float* points, UIntPtr n_points, tree_control* control, byte* inside, UIntPtr capacity);

        /// <summary>
        /// Frees a surface.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_revolved_free(tree_revolved* revolved);

        /// <summary>
        /// Begins with nothing drawn. `params` may be NULL for the defaults. Free it with `tree_silhouette_free`.
        /// `TREE_ERROR_PARAMETER` names what is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_new(tree_silhouette_params* @params, ulong seed, tree_silhouette** silhouette);

        /// <summary>
        /// Draws all strokes of one tree of a drawing, the first being number 0; its height becomes that of the parameters.
        /// Strokes of finer levels that cannot be used are left out: `report`, `tree_silhouette_repairs` and
        /// `tree_silhouette_refused` tell which, and why. What was read cannot be undone. `params`, `control` and `report` may be
        /// NULL. Free it with `tree_silhouette_free`. `TREE_ERROR_INVALID` says why level 0 gives no crown.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_of_drawing(tree_outline_drawing* drawing, UIntPtr tree, tree_silhouette_params* @params, ulong seed, tree_control* control, tree_silhouette_play_report* report, tree_silhouette** silhouette);

        /// <summary>
        /// A second one in the state of the first, with all that can be undone: to try something, and go back. Free it
        /// too.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_copy(tree_silhouette* silhouette, tree_silhouette** copy);

        /// <summary>
        /// Frees it. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a progress callback
        /// for instance: it lives on then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_free(tree_silhouette* silhouette);

        /// <summary>
        /// Views a change. Valid until `tree_silhouette_change_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_change_view(tree_silhouette_change* change, tree_silhouette_change_columns* columns);

        /// <summary>
        /// Frees a change.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_change_free(tree_silhouette_change* change);

        /// <summary>
        /// Draws the trunk, from the ground up; one drawn downwards is turned. Branches are inferred anew when there is a
        /// crown. `stroke` has two floats for each of `n_points` points, in metres, y up. `control` may be NULL; `nodes` of its
        /// limits caps the points. `change` may be NULL where it is not wanted; else free what is put there with
        /// `tree_silhouette_change_free`. `TREE_ERROR_INVALID` for a line without length or one that stays away from the crown.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_draw_trunk(tree_silhouette* silhouette, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws the crown's outline. Branches that were drawn or refined stay where the new crown has a branch near. `stroke`,
        /// `control` and `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or where
        /// the trunk stays away from it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_draw_crown(tree_silhouette* silhouette, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws the crown as it is seen when the tree is turned by `azimuth` radians, -2π to 2π, from +X towards +Z: another
        /// drawing plane. An outline in that plane is replaced. `stroke`, `control` and `change` as in
        /// `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_draw_section(tree_silhouette* silhouette, float azimuth, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws the outline of the foliage of a branch of a level, 1 (branches on the trunk) to 8. The branch is the one with
        /// the greatest length inside; its own branches are inferred, and its style spreads to its siblings. `stroke`, `control`
        /// and `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area or no part of a
        /// branch of that level.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_refine(tree_silhouette* silhouette, uint level, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws the outline of the foliage of the branch of this id. `stroke`, `control` and `change` as in
        /// `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, and an id that is not there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_refine_branch(tree_silhouette* silhouette, uint id, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws a branch of a level, 1 (branches on the trunk) to 8, over: the one whose ends are nearest to the stroke's.
        /// Where none is near, it is a new one. Its angle becomes a sample of the branching angles, and siblings take angle and
        /// shape as `transfer` says; `only` lists `n_only` ids for `TREE_TRANSFER_ONLY`, and may be NULL for the others. `stroke`,
        /// `control` and `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for a line without length, or where
        /// there is no axis of that level.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_redraw(tree_silhouette* silhouette, uint level, float* stroke, UIntPtr n_points, uint transfer, uint* only, UIntPtr n_only, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Draws a branch on the trunk as it is seen by a viewer who has gone round the tree by `yaw` radians, -2π to 2π,
        /// against the clock seen from above (0 is in front, +X to the right), and looks down by `pitch`, within ±1.4. It lies
        /// in the upright plane through the trunk that faces the viewer. A branch drawn from near there before, with ends near
        /// the stroke's, is replaced; else it is a new one. The rest as in `tree_silhouette_redraw`, which this is from in
        /// front.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_redraw_from(tree_silhouette* silhouette, float yaw, float pitch, float* stroke, UIntPtr n_points, uint transfer, uint* only, UIntPtr n_only, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Takes a branch away, with all on it. `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for an id
        /// that is not there.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_remove(tree_silhouette* silhouette, uint id, tree_silhouette_change** change);

        /// <summary>
        /// Draws the leaf. Its length is as drawn. `stroke`, `control` and `change` as in `tree_silhouette_draw_trunk`.
        /// `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_draw_leaf(tree_silhouette* silhouette, float* stroke, UIntPtr n_points, tree_control* control, tree_silhouette_change** change);

        /// <summary>
        /// Has `n_targets` branches take the style of the branch `source`, whose outline was drawn; 0: of the nearest such branch
        /// again. `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_INVALID` for ids that are not there, and a source
        /// whose outline was not drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_copy_style(tree_silhouette* silhouette, uint source, uint* targets, UIntPtr n_targets, tree_silhouette_change** change);

        /// <summary>
        /// Other parameters, NULL for the defaults. Where those of branches or angles differ, branches are inferred anew.
        /// `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_PARAMETER` names what is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_set_params(tree_silhouette* silhouette, tree_silhouette_params* @params, tree_silhouette_change** change);

        /// <summary>
        /// Another seed: only what is drawn by chance differs. This is no edit, and is not undone.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_set_seed(tree_silhouette* silhouette, ulong seed);

        /// <summary>
        /// Takes back the last edit, changes of parameters included. `change` as in `tree_silhouette_draw_trunk`.
        /// `TREE_ERROR_NO_RESULT` where there is none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_undo(tree_silhouette* silhouette, tree_silhouette_change** change);

        /// <summary>
        /// Does again what was taken back last. `change` as in `tree_silhouette_draw_trunk`. `TREE_ERROR_NO_RESULT` where there
        /// is nothing.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_redo(tree_silhouette* silhouette, tree_silhouette_change** change);

        /// <summary>
        /// The seed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_seed(tree_silhouette* silhouette, ulong* seed);

        /// <summary>
        /// The parameters, all parts given; a trunk drawn as an area tells its radius there. What they point at belongs to the
        /// session and stays until `tree_silhouette_set_params`, `tree_silhouette_undo`, `tree_silhouette_redo` or
        /// `tree_silhouette_free`. Set `params-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_get_params(tree_silhouette* silhouette, tree_silhouette_params* @params);

        /// <summary>
        /// Numbers of edits that can be undone, and done again.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_depth(tree_silhouette* silhouette, UIntPtr* n_undo, UIntPtr* n_redo);

        /// <summary>
        /// How well the outlines of branches cover the crown: shares of its area, 0 to 1, in those of branches from bumps, and in
        /// those of all. 0 before a crown was drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_coverage(tree_silhouette* silhouette, float* by_bumps, float* by_all);

        /// <summary>
        /// What was repaired in the drawing it began with, a line each, for a person to read. Free the lines with
        /// `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_repairs(tree_silhouette* silhouette, tree_lines** lines);

        /// <summary>
        /// Which strokes of the drawing it began with could not be used, and why, a line each. Free the lines with
        /// `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_refused(tree_silhouette* silhouette, tree_lines** lines);

        /// <summary>
        /// The plan as it is now: a copy, which later edits do not change. Free it with `tree_outline_plan_free`.
        /// `TREE_ERROR_NO_RESULT` before a crown was drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_plan(tree_silhouette* silhouette, tree_outline_plan** plan);

        /// <summary>
        /// The tree in space. The same strokes, parameters and seed give the same bits for any number of threads. `control` and
        /// `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_INVALID` before a crown was drawn;
        /// `TREE_ERROR_LIMIT` comes before the memory is asked for.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_silhouette_tree(tree_silhouette* silhouette, tree_control* control, tree_silhouette_grown* report, tree_tree** tree);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_params_init(tree_stand_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. Whether the trees of
        /// `lendings` are there is seen when they are used.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_params_check(tree_stand_params* @params);

        /// <summary>
        /// Grows all trees of a drawing, one outline for each, in parallel. Trees without details borrow branches and leaf of
        /// the detailed tree with the most similar crown, or of the one that `params` says. Trees that cannot be used are left
        /// out, and `tree_stand_notes` says so. `params` and `control` may be NULL. Free the stand with `tree_stand_free`.
        ///
        /// `TREE_ERROR_INVALID` when no tree can be used, and for a horizon below all of them; `TREE_ERROR_PARAMETER` names what
        /// is out of range; `TREE_ERROR_LIMIT` for more nodes or leaves, all trees together, than the limits allow.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_of_drawing(tree_outline_drawing* drawing, tree_stand_params* @params, ulong seed, tree_control* control, tree_stand** stand);

        /// <summary>
        /// Views a stand as a whole.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_view(tree_stand* stand, tree_stand_whole* whole);

        /// <summary>
        /// What was noticed, a line each, for a person to read. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_notes(tree_stand* stand, tree_lines** lines);

        /// <summary>
        /// Views a tree of a stand, the first being number 0, in the order of the drawing. Valid until `tree_stand_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_at(tree_stand* stand, UIntPtr index, tree_stand_tree* row);

        /// <summary>
        /// What grew as tree `index`, its base at the origin. `report` may be NULL. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_grown(tree_stand* stand, UIntPtr index, tree_silhouette_grown* report, tree_tree** tree);

        /// <summary>
        /// What was drawn and borrowed of tree `index`, to be looked at or drawn on: a copy, its base at the origin. `report`,
        /// which may be NULL, tells what became of its strokes. Its
        /// `tree_silhouette_seed` is the stand's, from which its own comes. Free it with `tree_silhouette_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_silhouette(tree_stand* stand, UIntPtr index, tree_silhouette_play_report* report, tree_silhouette** silhouette);

        /// <summary>
        /// Frees a stand. What it handed out lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_stand_free(tree_stand* stand);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sub_params_init(tree_sub_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sub_params_check(tree_sub_params* @params);

        /// <summary>
        /// Opening in radians of the cone of a branch of span `span` with radius `radius` at its end. `params` may be NULL.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sub_params_opening(tree_sub_params* @params, float radius, float span, float* angle);

        /// <summary>
        /// Cuts out the part of a parent's outline that is a branch's. `branch` is its line, `n_branch` points of two floats each from
        /// base to end, and `radius`, 0 or more, that of the disc at its end, as `tree_bump` has it. With `stretch`, two floats, only
        /// that part of the parent is shared: from 0 to the perimeter, to as much more again; NULL for whatever the cone reaches.
        /// `params`, `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline, which is simple
        /// whatever the branch, with `tree_outline_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_sub(tree_outline* parent, float* branch, UIntPtr n_branch, float radius, float* stretch, tree_sub_params* @params, tree_control* control, tree_sub_report* report, tree_outline** sub);

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
        /// Frees a skeleton.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_free(tree_skeleton* skeleton);

        /// <summary>
        /// Splits a skeleton into axes. Free them with `tree_axes_free`; they do not need the skeleton any more.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_axes(tree_skeleton* skeleton, uint rule, tree_axes** axes);

        /// <summary>
        /// Views the axes. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_axes_view(tree_axes* axes, tree_axis_columns* columns);

        /// <summary>
        /// Frees the axes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_axes_free(tree_axes* axes);

        /// <summary>
        /// A new skeleton with other radii: `radii` has `n` floats, one for each node, in metres, 0 or more. Free
        /// it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_with_radii(tree_skeleton* skeleton, float* radii, UIntPtr n, tree_skeleton** changed);

        /// <summary>
        /// A new skeleton with its nodes elsewhere: `positions` has three floats for each of `n` nodes, in
        /// metres. Free it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_with_positions(tree_skeleton* skeleton, float* positions, UIntPtr n, tree_skeleton** changed);

        /// <summary>
        /// Length of the segment between each node and its parent, in metres; 0 for the root. `lengths` has room
        /// for `capacity` floats, at least one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_segment_lengths(tree_skeleton* skeleton, float* lengths, UIntPtr capacity);

        /// <summary>
        /// Length of the path from the root to each node, in metres. `distances` has room for `capacity` floats,
        /// at least one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_distances_to_root(tree_skeleton* skeleton, float* distances, UIntPtr capacity);

        /// <summary>
        /// Length of the longest path from each node up to a tip, in metres; 0 at tips. `distances` has room for
        /// `capacity` floats, at least one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_distances_to_tip(tree_skeleton* skeleton, float* distances, UIntPtr capacity);

        /// <summary>
        /// Number of nodes from each node up, itself included. `sizes` has room for `capacity` numbers, at least
        /// one for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_subtree_sizes(tree_skeleton* skeleton, uint* sizes, UIntPtr capacity);

        /// <summary>
        /// Number of tips from each node up; 1 for a tip. `counts` has room for `capacity` numbers, at least one
        /// for each node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_tip_counts(tree_skeleton* skeleton, uint* counts, UIntPtr capacity);

        /// <summary>
        /// The children of every node: those of node `i` are `nodes[starts[i]]` up to, but not including,
        /// `nodes[starts[i + 1]]`, in rising order. `starts` has room for `starts_capacity` numbers, at least one
        /// more than there are nodes; `nodes` for `nodes_capacity`, at least one less than there are nodes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_children(tree_skeleton* skeleton, uint* starts, UIntPtr starts_capacity, uint* nodes, UIntPtr nodes_capacity);

        /// <summary>
        /// Makes `options`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_options_init(tree_swc_options* options, UIntPtr size);

        /// <summary>
        /// Reads an SWC file: metres, +Y up. Rows keep their order where parents come first; otherwise nodes come
        /// breadth-first. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
        /// `TREE_NUL_TERMINATED`. `options` may be NULL for the defaults, and
        /// so may `control`, of which only the limits matter. What is wrong with a file is told with its line.
        /// Free the file with `tree_swc_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_read(byte* path, UIntPtr path_len, tree_swc_options* options, tree_control* control, tree_swc** swc);

        /// <summary>
        /// Reads the text of an SWC file, of `len` bytes or `TREE_NUL_TERMINATED`. Otherwise as `tree_swc_read`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_from_text(byte* text, UIntPtr len, tree_swc_options* options, tree_control* control, tree_swc** swc);

        /// <summary>
        /// The skeleton of an SWC file, not copied. Free it with `tree_skeleton_free`; it may outlive `swc`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_skeleton(tree_swc* swc, tree_skeleton** skeleton);

        /// <summary>
        /// Views what an SWC file held beside the skeleton. Set `contents-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_view(tree_swc* swc, tree_swc_contents* contents);

        /// <summary>
        /// Frees an SWC file that was read.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_swc_free(tree_swc* swc);

        /// <summary>
        /// Writes a skeleton as an SWC file, which is whole or absent: written beside its name, then renamed. Ids
        /// count from 1 in node order; types are 3, which continues the axis, and 4, which starts a lateral. With
        /// a scale of 1, reading brings back every position and radius exactly, unless it moves the root.
        /// `options` may be NULL for the defaults.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_write_swc(tree_skeleton* skeleton, byte* path, UIntPtr path_len, tree_swc_options* options);

        /// <summary>
        /// Writes a skeleton as the text of an SWC file, as `tree_skeleton_write_swc` does. Free it with
        /// `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeleton_to_swc(tree_skeleton* skeleton, tree_swc_options* options, tree_bytes** text);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeletonize_params_init(tree_skeletonize_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `part`, of `size` bytes, the default: nothing.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_mesh_part_init(tree_mesh_part* part, UIntPtr size);

        /// <summary>
        /// The fourth stage: makes a leaf of each leaf component, on the nearest wood of a skeleton as
        /// `tree_pieces_link` returns it. Positions and sizes are in the units of the mesh already. `control` may
        /// be NULL. Free the leaves with `tree_found_leaves_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_leaves(tree_separation* separation, tree_skeleton* skeleton, tree_control* control, tree_found_leaves** leaves);

        /// <summary>
        /// Views the leaves, in the form that `tree_tree_new` takes. Set `foliage-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_found_leaves_foliage(tree_found_leaves* leaves, tree_foliage* foliage);

        /// <summary>
        /// Views the kinds of leaves. Set `kinds-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_found_leaves_view(tree_found_leaves* leaves, tree_leaf_kinds* kinds);

        /// <summary>
        /// Frees leaves found in a mesh.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_found_leaves_free(tree_found_leaves* leaves);

        /// <summary>
        /// The second stage: follows every connected piece of wood from its base, in parallel. `params` and
        /// `control` may be NULL. Free the pieces with `tree_pieces_free`. `TREE_ERROR_NO_RESULT` where there is
        /// no wood.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_follow(tree_separation* separation, tree_skeletonize_params* @params, tree_control* control, tree_pieces** pieces);

        /// <summary>
        /// Makes pieces of `n_pieces` skeletons, which are copied, and of what they stand for: for pieces that were
        /// changed, or come from elsewhere. `control` may be NULL; `nodes` of its limits caps those of all
        /// skeletons together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pieces_new(tree_skeleton** skeletons, tree_piece* rows, UIntPtr n_pieces, tree_control* control, tree_pieces** pieces);

        /// <summary>
        /// Number of pieces.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pieces_count(tree_pieces* pieces, UIntPtr* n_pieces);

        /// <summary>
        /// One piece, `index` below their number: its skeleton, copied, in units of the mesh's longest side, and
        /// what it stands for (NULL if not wanted). Free the skeleton with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pieces_piece(tree_pieces* pieces, UIntPtr index, tree_piece* row, tree_skeleton** skeleton);

        /// <summary>
        /// The third stage: links pieces over gaps of at most `params.bridge` to one skeleton, seen from its lowest
        /// thick end. `reached`, NULL or with room for `capacity` bytes (one for each piece), says whether it is part of it. Free
        /// the skeleton with `tree_skeleton_free`. `TREE_ERROR_NO_RESULT` without pieces.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pieces_link(tree_pieces* pieces, tree_skeletonize_params* @params, tree_control* control, byte* reached, UIntPtr capacity, tree_skeleton** skeleton);

        /// <summary>
        /// Frees pieces.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_pieces_free(tree_pieces* pieces);

        /// <summary>
        /// The first stage of `tree_skeletonize` by itself: welds the parts and says of each connected component
        /// what it is. Arguments and errors are as there; `params.weld` counts. Free it with
        /// `tree_separation_free`.
        ///
        /// The stages, one after the other: `tree_separation_new`, `tree_separation_follow`, `tree_pieces_link`,
        /// `tree_separation_leaves`, `tree_separation_outward`. Up to the last all is in units of the mesh's
        /// longest side, about its middle, whatever the mesh's own unit.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_new(tree_mesh_part* parts, UIntPtr n_parts, tree_skeletonize_params* @params, tree_control* control, tree_separation** separation);

        /// <summary>
        /// As `tree_separation_new`, of a mesh: see `tree_skeletonize_mesh`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_of_mesh(tree_mesh* mesh, uint* hints, UIntPtr n_hints, tree_skeletonize_params* @params, tree_control* control, tree_separation** separation);

        /// <summary>
        /// Views a separation. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_view(tree_separation* separation, tree_separation_columns* columns);

        /// <summary>
        /// The same separation with other classes, one for each component: what a component was taken for need
        /// not hold. The first one stays as it is. Free the other one too.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_with_classes(tree_separation* separation, uint* classes, UIntPtr n_classes, tree_separation** other);

        /// <summary>
        /// The last stage: brings a skeleton back to the units of the mesh. Free it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_outward(tree_separation* separation, tree_skeleton* skeleton, tree_skeleton** outward);

        /// <summary>
        /// Frees a separation.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_separation_free(tree_separation* separation);

        /// <summary>
        /// Makes a tree of a mesh, in the mesh's unit: closed surfaces, tubes stuck into each other, thousands of
        /// separate prisms; cards or blobs for leaves. `parts` is `n_parts` structs, which are not kept. Its bark is
        /// named after the part with most wood, leaf kinds after the parts their leaves come from; no look is built
        /// in by such names, so give `tree_mesh_build` one of `tree_look_of_tree(tree, 1, &amp;look)`, or of
        /// `tree_look_new` with the mesh's own textures. `params`,
        /// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_NO_RESULT` where
        /// nothing looks like wood; `TREE_ERROR_INVALID` for parts whose columns do not fit together.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeletonize(tree_mesh_part* parts, UIntPtr n_parts, tree_skeletonize_params* @params, tree_control* control, tree_skeletonize_report* report, tree_tree** tree);

        /// <summary>
        /// As `tree_skeletonize`, of a mesh: each surface is a part, named after its material. `hints` is NULL, or
        /// has one for each surface.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_skeletonize_mesh(tree_mesh* mesh, uint* hints, UIntPtr n_hints, tree_skeletonize_params* @params, tree_control* control, tree_skeletonize_report* report, tree_tree** tree);

        /// <summary>
        /// Makes branches of columns, which are copied: segments of a sketch, or measured elsewhere, on which nothing grew
        /// yet. Every segment but the first must begin where its parent ends. `control` may be NULL; `nodes` of its limits
        /// caps the points. Free them with `tree_sketch_branches_free`. `TREE_ERROR_INVALID` says which columns or which
        /// segment do not fit.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_from_columns(tree_sketch_branches_columns* columns, tree_control* control, tree_sketch_branches** branches);

        /// <summary>
        /// Views branches. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_view(tree_sketch_branches* branches, tree_sketch_branches_columns* columns);

        /// <summary>
        /// Writes the Gravelius order of each segment's axis: 0 for stems, one more than its parent's for a lateral.
        /// `orders` has room for `capacity` values, at least as many as there are segments.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_orders(tree_sketch_branches* branches, uint* orders, UIntPtr capacity);

        /// <summary>
        /// Frees branches. What was made of them lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_free(tree_sketch_branches* branches);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_clean_params_init(tree_clean_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_clean_params_check(tree_clean_params* @params);

        /// <summary>
        /// Cleans a drawing and joins its strokes to one tree in the plane: points that are none go, what nobody marked
        /// is told apart (ground, crown, wood), of wood drawn by its outline the middle line is taken, strokes drawn over
        /// one another become one, gaps are closed. What was done is told by `tree_plan_repairs`. `params` and `control` may
        /// be NULL; `nodes` of the limits caps the points. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where no
        /// stroke has a length, or one is too far from the rest and `TREE_ISOLATED_REFUSE` was asked for: the text names the
        /// stroke.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_clean(tree_drawing* drawing, tree_clean_params* @params, tree_control* control, tree_plan** plan);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_params_init(tree_crown_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_params_check(tree_crown_params* @params);

        /// <summary>
        /// Makes a crown of what was drawn: `columns` are lines in metres of the plan (x to the right, y up) such as those of
        /// `tree_plan_crown`. Ends that lie close are joined, wide gaps closed round the branches in them, and loops that cross
        /// are united. `spots` are `n_spots` points of the branches, two floats each, best without those below the first fork;
        /// there may be none. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the crown with
        /// `tree_crown_free`. `TREE_ERROR_INVALID` where nothing drawn encloses an area, or no branch touches the crown and
        /// `refuse` says so.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_close(tree_strokes_columns* columns, float* spots, UIntPtr n_spots, tree_crown_params* @params, tree_control* control, tree_crown** crown);

        /// <summary>
        /// Makes a crown of closed polygons, in metres of the plan. They are made simple and united as drawn ones are; points
        /// that are not finite are left out. `depth` is the crown's depth over its width, 0.05 to 20, 1 for circles. `control` may
        /// be NULL; `nodes` of the limits caps the points. Free the crown with `tree_crown_free`. `TREE_ERROR_INVALID` where they
        /// enclose no area.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_from_polygons(tree_strokes_columns* columns, float depth, tree_control* control, tree_crown** crown);

        /// <summary>
        /// Views the polygons in metres of the plan: simple, apart from each other, against the clock, the largest first.
        /// Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_polygons(tree_crown* crown, tree_strokes_columns* columns);

        /// <summary>
        /// Tells how large a crown is. Set `measures-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_measure(tree_crown* crown, tree_crown_measures* measures);

        /// <summary>
        /// Views what was repaired or noticed when the crown was closed, in that order: where the repairs begin and how many
        /// there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_repairs(tree_crown* crown, tree_crown_repair** repairs, UIntPtr* n_repairs);

        /// <summary>
        /// A sentence for each repair. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_repairs_text(tree_crown* crown, tree_lines** lines);

        /// <summary>
        /// Says of `n_spots` points of the plan, two floats each, whether they lie in the crown: 1 or 0 into `inside`, which
        /// has room for `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_contains(tree_crown* crown, float* spots, UIntPtr n_spots, tree_control* control, byte* inside, UIntPtr capacity);

        /// <summary>
        /// Says of `n_points` points, three floats each, how near the solid's surface they are, into `levels`, which has room
        /// for `capacity`: 0 on the axis of the stretch they lie in, up to 1 inside, above 1 outside; infinite where the crown
        /// has nothing at that height. The plan lies at z = 0. `control` as for `tree_crown_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_levels(tree_crown* crown, float* points, UIntPtr n_points, tree_control* control, float* levels, UIntPtr capacity);

        /// <summary>
        /// Where `n_ways` straight ways first leave the solid: each is six floats in `ways`, its beginning and its end. `exits`,
        /// which has room for `capacity`, gets a share of each way: 0 where it begins outside, infinite where it stays inside.
        /// `control` as for `tree_crown_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_exits(tree_crown* crown, float* ways, UIntPtr n_ways, tree_control* control, float* exits, UIntPtr capacity);

        /// <summary>
        /// Frees a crown. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_crown_free(tree_crown* crown);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_outline_params_init(tree_outline_params* @params, UIntPtr size);

        /// <summary>
        /// The outlines of a cloud of `n_spots` points, two floats each, such as a tree's leaves as seen from one side, drawn
        /// as a person would: gaps between leaves closed, corners rounded. They are against the clock, the largest first; none
        /// for fewer than three points. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the outlines
        /// with `tree_strokes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_strokes_outline(float* spots, UIntPtr n_spots, tree_outline_params* @params, tree_control* control, tree_strokes** strokes);

        /// <summary>
        /// Makes a drawing of strokes, which are copied; there may be none. `control` may be NULL; `nodes` of its
        /// limits caps the points of all strokes. Free the drawing with `tree_drawing_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_new(tree_sketch_stroke* strokes, UIntPtr n_strokes, tree_control* control, tree_drawing** drawing);

        /// <summary>
        /// Makes a drawing with the strokes of another and these after them. The other stays as it is. `control` may
        /// be NULL; only its limits matter. Free the new drawing with `tree_drawing_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_with_strokes(tree_drawing* drawing, tree_sketch_stroke* strokes, UIntPtr n_strokes, tree_control* control, tree_drawing** more);

        /// <summary>
        /// Reads the strokes of an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line, polyline,
        /// polygon, rectangle, circle and ellipse that is seen is one, with all transforms, in the drawing's units. A
        /// whole word in its id, class, layer label or name, or in those of the groups around it, says what it shows:
        /// `trunk`, `stem`; `branch`, `limb`, `twig`; `crown`, `outline`, `foliage`, `leaves`, `canopy`; and what is green
        /// is the crown. Its id becomes its name. Style sheets, `&lt;use&gt;` and texts are not read. `control` may be NULL;
        /// only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` when the text is no SVG or
        /// draws nothing.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_from_svg(byte* svg, UIntPtr len, tree_control* control, tree_drawing** drawing);

        /// <summary>
        /// Reads a drawing from JSON, `json` of `len` bytes or `TREE_NUL_TERMINATED`, at most 32 MiB, in any of these forms,
        /// y downwards:
        ///
        /// * `{"strokes": [{"points": [[x, y], …], "role": "branch", "closed": false, "filled": false, "name": ""}, …]}`,
        /// where all but the points may be missing; the role is `trunk`, `branch`, `crown` or `null`;
        /// * `[[[x, y], …], …]`, bare lines;
        /// * `{"drawing": [[[x…], [y…]], …]}`, a drawing of Quick, Draw!.
        ///
        /// `control` may be NULL; only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` names
        /// the stroke and the point at fault.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_from_json(byte* json, UIntPtr len, tree_control* control, tree_drawing** drawing);

        /// <summary>
        /// Writes a drawing as JSON, in the first form of `tree_drawing_from_json`. Free the bytes, which are UTF-8, with
        /// `tree_bytes_free`. `TREE_ERROR_INVALID` names a point that is not finite: JSON has no such numbers.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_to_json(tree_drawing* drawing, tree_bytes** bytes);

        /// <summary>
        /// Number of strokes.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_count(tree_drawing* drawing, UIntPtr* n_strokes);

        /// <summary>
        /// Views a stroke. `index` is below `tree_drawing_count`. Set `stroke-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_stroke(tree_drawing* drawing, UIntPtr index, tree_sketch_stroke* stroke);

        /// <summary>
        /// Frees a drawing. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_free(tree_drawing* drawing);

        /// <summary>
        /// Reads a drawing from each line that is not blank, in any form of `tree_drawing_from_json`: the files of Quick,
        /// Draw!. `ndjson` has `len` bytes or is `TREE_NUL_TERMINATED`. `control` may be NULL; only its limits matter. Free the
        /// drawings with `tree_drawings_free`. `TREE_ERROR_FORMAT` names the line, from 1, the stroke and the point.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawings_from_ndjson(byte* ndjson, UIntPtr len, tree_control* control, tree_drawings** drawings);

        /// <summary>
        /// Number of drawings.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawings_count(tree_drawings* drawings, UIntPtr* n_drawings);

        /// <summary>
        /// One of the drawings, not copied; it may outlive the others. `index` is below `tree_drawings_count`. Free it with
        /// `tree_drawing_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawings_at(tree_drawings* drawings, UIntPtr index, tree_drawing** drawing);

        /// <summary>
        /// Frees drawings. Those taken out live on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawings_free(tree_drawings* drawings);

        /// <summary>
        /// Number of exemplars: trees of clearly different habit, one for each built-in template.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr tree_exemplar_count();

        /// <summary>
        /// Name of an exemplar, such as `oak`, what the tree looks like, in a few words, and the name of the species whose
        /// leaves suit it. `index` is below `tree_exemplar_count`; `title` and `species` may be NULL. The texts are valid for ever.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_exemplar_name(UIntPtr index, tree_str* name, tree_str* title, tree_str* species);

        /// <summary>
        /// Grows one tree of the exemplar called `name` (`len` bytes, or `TREE_NUL_TERMINATED`), with leaves on cards. The same
        /// seed gives the same bits. `control` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_UNKNOWN_NAME` lists
        /// the names there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_exemplar_grow(byte* name, UIntPtr len, ulong seed, tree_control* control, tree_tree** tree);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_main_branches_init(tree_main_branches* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_main_branches_check(tree_main_branches* @params);

        /// <summary>
        /// The drawing that a person would make of a tree, in metres, y down: a stroke for each main branch, the trunk first, as
        /// an eye sees them that looks level from afar and stands at `yaw` radians round the trunk (0 on +Z, a quarter turn on
        /// +X), and `with_crown` the outline of its leaves. `main`, `outline` and `control` may be NULL. Free the drawing with
        /// `tree_drawing_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_drawing_of_tree(tree_tree* tree, float yaw, uint with_crown, tree_main_branches* main, tree_outline_params* outline, tree_control* control, tree_drawing** drawing);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_finish_params_init(tree_sketch_finish_params* @params, UIntPtr size);

        /// <summary>
        /// The branches as a skeleton with radii by the pipe model. Every point stays where it is: seen from the front,
        /// sketched branches are the strokes. `params` and `control` may be NULL. Free it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_wood(tree_sketch_branches* branches, tree_sketch_finish_params* @params, tree_control* control, tree_skeleton** wood);

        /// <summary>
        /// Grows twigs and leaves of a species on wood, as many leaves as cover its crown like those of a tree in full leaf;
        /// with a `crown`, which may be NULL, both stay in it but for half a leaf. `params`, `control` and `report` may be
        /// NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range,
        /// `TREE_ERROR_UNKNOWN_NAME` a species that is none.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_grow_crown(tree_skeleton* wood, tree_crown* crown, tree_sketch_finish_params* @params, ulong seed, tree_control* control, tree_sketch_finish_report* report, tree_tree** tree);

        /// <summary>
        /// The footprint of `n_spots` points, two floats each: the distances from the centre of their convex hull to the hull in
        /// `TREE_FOOTPRINT_DIRECTIONS` directions, as shares of the longer side of its bounding box, into `distances`, which has
        /// room for `capacity`. Points that are not finite do not count. `control` may be NULL; `nodes` of the limits caps the
        /// points. `TREE_ERROR_NO_RESULT` where the hull has no area.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_footprint_of(float* spots, UIntPtr n_spots, tree_control* control, float* distances, UIntPtr capacity);

        /// <summary>
        /// How unlike two footprints are, each `TREE_FOOTPRINT_DIRECTIONS` distances: the root of the mean square of their
        /// differences. 0 for equal shapes, about 0.2 for a circle and a poplar. `TREE_ERROR_INVALID` for other numbers of
        /// distances, or where one is not above 0 and at most 2.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_footprint_difference(float* first, UIntPtr n_first, float* second, UIntPtr n_second, float* difference);

        /// <summary>
        /// The convex hull of `n_spots` points, two floats each, against the clock where y goes up, without corners on straight
        /// sides, into `corners`, which has room for `capacity` floats: twice `n_spots` always do. `n_corners` gets their number,
        /// which is below 3 where the points lie on a line. Points that are not finite do not count. `control` may be NULL; `nodes`
        /// of the limits caps the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_convex_hull(float* spots, UIntPtr n_spots, tree_control* control, float* corners, UIntPtr capacity, UIntPtr* n_corners);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_infer_params_init(tree_sketch_infer_params* @params, UIntPtr size);

        /// <summary>
        /// Makes `params` those of the thesis alone: no beam, no spread, no preference for a stroke's own continuation, no
        /// bending prior. Set `params-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_infer_params_thesis(tree_sketch_infer_params* @params);

        /// <summary>
        /// Infers depths, labels and, unless it is to be kept, Ω, which begins as the template's, by inference in a Markov
        /// random field (Neubert 2012, sections 4.4 to 4.6): a sketch is seen from the front, x and y of every branch are
        /// drawn, its depth z is not. Depths that are known go in as `n_pins` `pins`, NULL for none, and stay. Ends that are
        /// drawn inside `crown`, which may be NULL, stay in its surface of local revolution as far as the factors allow.
        ///
        /// `omega`, `params` and `control` may be NULL. Free the result with `tree_inferred_free`. `TREE_ERROR_PARAMETER`
        /// names what is out of range, `TREE_ERROR_INVALID` a pin that is at no fork or tip of the plan.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_infer(tree_plan* plan, tree_sketch_omega* omega, tree_sketch_pin* pins, UIntPtr n_pins, tree_crown* crown, tree_sketch_infer_params* @params, ulong seed, tree_control* control, tree_inferred** inferred);

        /// <summary>
        /// Views what was inferred. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_inferred_view(tree_inferred* inferred, tree_inferred_columns* columns);

        /// <summary>
        /// The segments, with labels and points in space; seen along -Z their points are those of the plan. Free them with
        /// `tree_sketch_branches_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_inferred_branches(tree_inferred* inferred, tree_sketch_branches** branches);

        /// <summary>
        /// Ω of the sketch: the template's, or estimated. Set `omega-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_inferred_omega(tree_inferred* inferred, tree_sketch_omega* omega);

        /// <summary>
        /// Frees what was inferred. Branches of it live on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_inferred_free(tree_inferred* inferred);

        /// <summary>
        /// Builds the graph that `tree_sketch_infer` with the same arguments and no pins works on. `omega`, `params` and
        /// `control` may be NULL. Free it with `tree_factor_graph_free`. `TREE_ERROR_PARAMETER` names what is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_factor_graph_new(tree_plan* plan, tree_sketch_omega* omega, tree_sketch_infer_params* @params, ulong seed, tree_control* control, tree_factor_graph** graph);

        /// <summary>
        /// Parent of each segment, `TREE_NO_PARENT` for segment 0: where they begin and how many there are. Valid until
        /// `tree_factor_graph_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_factor_graph_parents(tree_factor_graph* graph, uint** parents, UIntPtr* n_segments);

        /// <summary>
        /// Length of a segment in the plane, from end to end, in metres.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_factor_graph_length(tree_factor_graph* graph, uint segment, double* metres);

        /// <summary>
        /// The posterior of depths, of the segments' ends in metres, and labels: `n_segments` of each. `omega` and `control`
        /// may be NULL. `TREE_ERROR_INVALID` where there are not as many as segments, `TREE_ERROR_PARAMETER` for a depth
        /// that is not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_factor_graph_posterior(tree_factor_graph* graph, tree_sketch_omega* omega, double* depths, uint* labels, UIntPtr n_segments, tree_control* control, tree_sketch_posterior* posterior);

        /// <summary>
        /// Frees a factor graph.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_factor_graph_free(tree_factor_graph* graph);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_midline_params_init(tree_midline_params* @params, UIntPtr size);

        /// <summary>
        /// Finds the middle lines of a filled area with these closed contours, which may cross: the main line first, then those
        /// that leave it, the strongest first. A side line begins at a point of the line that bears it. Points that are not finite
        /// are left out; what has no area has no lines. `params` and `control` may be NULL; `nodes` of the limits caps the
        /// points. Free the lines with `tree_midlines_free`. `tree_drawing_clean` does this for strokes that are `filled`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_midlines_of(tree_strokes_columns* columns, tree_midline_params* @params, tree_control* control, tree_midlines** midlines);

        /// <summary>
        /// Views middle lines, in the units of the contours. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_midlines_view(tree_midlines* midlines, tree_strokes_columns* columns);

        /// <summary>
        /// Views half the area's width at every point of `tree_midlines_view`: where the numbers begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_midlines_half_widths(tree_midlines* midlines, float** half_widths, UIntPtr* n_points);

        /// <summary>
        /// Frees middle lines.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_midlines_free(tree_midlines* midlines);

        /// <summary>
        /// Makes `omega`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_omega_init(tree_sketch_omega* omega, UIntPtr size);

        /// <summary>
        /// Whether all numbers are in range: `TREE_OK`, or the error that their use would give, which names order and
        /// field.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_omega_check(tree_sketch_omega* omega);

        /// <summary>
        /// Ω of branches. Orders with few segments borrow from all orders together; what the branches do not show at all
        /// is the default's. Set `omega-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_omega_fit(tree_sketch_branches* branches, tree_sketch_omega* omega);

        /// <summary>
        /// Ω of template `index`, which is below `tree_templates_count`: that of its exemplar's main branches. Set
        /// `omega-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_omega(tree_templates* templates, UIntPtr index, tree_sketch_omega* omega);

        /// <summary>
        /// Ω of `n_relations` relations, of one tree or of many: those of `tree_sketch_branches_relations`, joined.
        /// `control` may be NULL; `nodes` of its limits caps the relations. Set `omega-&gt;struct_size` first.
        /// `TREE_ERROR_PARAMETER` names the row with a number that is not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_omega_of_relations(tree_sketch_relation* relations, UIntPtr n_relations, tree_control* control, tree_sketch_omega* omega);

        /// <summary>
        /// The same parameters for the whole tree, as in the thesis: those of the orders of `omega`, averaged. `omega` may
        /// be NULL for the default. Set `whole-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_omega_without_orders(tree_sketch_omega* omega, tree_sketch_omega* whole);

        /// <summary>
        /// How each segment lies to its parent, in the order of segments; none for segments without length and those of an
        /// imagined root. Their number goes into `n_relations`, they themselves into `relations`, which has room for
        /// `capacity` rows; with NULL they are only counted. There are fewer than segments.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_relations(tree_sketch_branches* branches, tree_sketch_relation* relations, UIntPtr capacity, UIntPtr* n_relations);

        /// <summary>
        /// Makes a plan of columns, which are copied: without crown and without repairs. `control` may be NULL; `nodes`
        /// of its limits counts. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where a number is not finite,
        /// or a parent does not come before its node.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_from_columns(tree_plan_columns* columns, tree_control* control, tree_plan** plan);

        /// <summary>
        /// Views the columns of a plan. Set `columns-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_view(tree_plan* plan, tree_plan_columns* columns);

        /// <summary>
        /// Views the lines of the drawn crown in metres of the plan, as drawn and not yet closed; a closed one ends where it
        /// begins. There may be none. Set `columns-&gt;struct_size` first. `tree_crown_close` takes them.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_crown(tree_plan* plan, tree_strokes_columns* columns);

        /// <summary>
        /// Views the drawing's stroke of each line of the crown: where the numbers begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_crown_strokes(tree_plan* plan, uint** strokes, UIntPtr* n_strokes);

        /// <summary>
        /// Views what cleaning did to the drawing, in that order: where the repairs begin and how many there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_repairs(tree_plan* plan, tree_clean_repair** repairs, UIntPtr* n_repairs);

        /// <summary>
        /// A sentence for each repair, which names the stroke. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_repairs_text(tree_plan* plan, tree_lines** lines);

        /// <summary>
        /// The same plan, its crown with it, `factor` times as large in metres. Free it with `tree_plan_free`.
        /// `TREE_ERROR_INVALID` where the factor is not above 0 or coordinates become infinite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_scaled(tree_plan* plan, float factor, tree_plan** scaled);

        /// <summary>
        /// Where points of the plan lie in the drawing: `spots` are `n_spots` times two floats in metres, `drawn` gets as many
        /// in units of the drawing; `capacity` is its room in floats. `control` may be NULL; `nodes` of its limits caps the
        /// points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_points_to_drawing(tree_plan* plan, float* spots, UIntPtr n_spots, tree_control* control, float* drawn, UIntPtr capacity);

        /// <summary>
        /// Where points of the drawing lie in the plan: as `tree_plan_points_to_drawing`, the other way. `planned` gets
        /// the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_points_from_drawing(tree_plan* plan, float* spots, UIntPtr n_spots, tree_control* control, float* planned, UIntPtr capacity);

        /// <summary>
        /// Frees a plan. What was made of it lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_plan_free(tree_plan* plan);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_propagate_params_init(tree_sketch_propagate_params* @params, UIntPtr size);

        /// <summary>
        /// Fills a sketch up with branches after the pattern of its own (Neubert 2012, section 4.7): its forks are taken as
        /// replication blocks, which are attached to its open ends generation by generation, and along branches that are
        /// long without forks.
        ///
        /// With a `crown` growth stays inside it; with NULL it goes on for `generations`. New segments keep `clearance` away
        /// from `obstacles`, a volume or NULL for none; sketched ones stay as they are. `omega`, `params`, `control` and
        /// `report` may be NULL. The sketched segments keep their numbers, the new follow. Free them with
        /// `tree_sketch_branches_free`. `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_INVALID` says so for
        /// branches that have grown already.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_branches_propagate(tree_sketch_branches* branches, tree_sketch_omega* omega, tree_crown* crown, tree_volume* obstacles, tree_sketch_propagate_params* @params, ulong seed, tree_control* control, tree_sketch_propagate_report* report, tree_sketch_branches** grown);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_select_params_init(tree_select_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_select_params_check(tree_select_params* @params);

        /// <summary>
        /// Compares a plan with templates: one row for each into `choices`, best first; `capacity` is the number of templates or
        /// more. `crown` may be NULL for that which was drawn with the plan, as it was drawn. `params` and `control` may be NULL.
        /// `TREE_ERROR_INVALID` where there are no templates.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_select(tree_templates* templates, tree_plan* plan, tree_crown* crown, tree_select_params* @params, tree_control* control, tree_choice* choices, UIntPtr capacity);

        /// <summary>
        /// Begins with a drawing, which is copied. `params` may be NULL for the defaults. No work is done yet: what is wrong
        /// with the drawing comes to light with the first stage. Templates and obstacles are set with
        /// `tree_sketch_session_set_templates` and `tree_sketch_session_set_obstacles`. Free the session with
        /// `tree_sketch_session_free`. `TREE_ERROR_PARAMETER` names what is out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_new(tree_drawing* drawing, tree_sketch_params* @params, ulong seed, tree_sketch_session** session);

        /// <summary>
        /// A second session in the state of the first, with all that has been made so far: to try something, and
        /// go back. Free it too.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_copy(tree_sketch_session* session, tree_sketch_session** copy);

        /// <summary>
        /// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
        /// progress callback for instance: it lives on then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_free(tree_sketch_session* session);

        /// <summary>
        /// Another seed: other depths within Ω, another growth. Depths that edits kept are forgotten.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_set_seed(tree_sketch_session* session, ulong seed);

        /// <summary>
        /// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Where those of
        /// inference, the template or the height differ, depths that edits kept are forgotten.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_set_params(tree_sketch_session* session, tree_sketch_params* @params);

        /// <summary>
        /// Templates of one's own, which are copied, instead of those built in; NULL for these again. Depths that edits kept
        /// are forgotten.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_set_templates(tree_sketch_session* session, tree_templates* templates);

        /// <summary>
        /// What new branches are to keep out of: a volume in the tree's metres, its base at the origin, or NULL for nothing.
        /// Sketched branches stay as they are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_set_obstacles(tree_sketch_session* session, tree_volume* obstacles);

        /// <summary>
        /// Forgets depths, Ω, scale and the choice of template that edits keep, so that all are found anew.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_infer_anew(tree_sketch_session* session);

        /// <summary>
        /// Forgets the results of a stage and of all later ones, so that they are done again; what edits keep stays.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_redo_from(tree_sketch_session* session, uint stage);

        /// <summary>
        /// Draws one more stroke, which is copied; its number in the drawing goes into `number`. Depths of all other branches
        /// stay. `control` may be NULL; `nodes` of its limits caps the points. What is wrong with the stroke comes to light
        /// with the next stage; erase it then.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_add_stroke(tree_sketch_session* session, tree_sketch_stroke* stroke, tree_control* control, UIntPtr* number);

        /// <summary>
        /// Erases a stroke, and with a branch all that it bears. Depths of all other branches stay, and so do the numbers of
        /// their strokes. Numbers of those that are gone go into `gone`, which has room for `capacity` of them, at least as
        /// many as there are strokes (`tree_drawing_count` of `tree_sketch_session_drawing`), and how many they are into
        /// `n_gone`. Both may be NULL where they are not wanted. `TREE_ERROR_INVALID` for a stroke that is not there or was
        /// erased before.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_erase_stroke(tree_sketch_session* session, UIntPtr stroke, tree_control* control, uint* gone, UIntPtr capacity, UIntPtr* n_gone);

        /// <summary>
        /// Moves the tip or fork of a stroke that is nearest to `at`, two floats in the drawing's units, to `depth` in metres,
        /// positive towards the viewer. What it bears is inferred anew; the rest stays. The end of the root segment stays in
        /// the plane. `TREE_ERROR_INVALID` for a stroke that is not there, was erased, or has no tip or fork to move;
        /// `TREE_ERROR_PARAMETER` for numbers that are not finite.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_set_depth(tree_sketch_session* session, UIntPtr stroke, float* at, float depth, tree_control* control);

        /// <summary>
        /// The drawing as it is after all edits; erased strokes are there without points. Free it with `tree_drawing_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_drawing(tree_sketch_session* session, tree_drawing** drawing);

        /// <summary>
        /// The seed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_seed(tree_sketch_session* session, ulong* seed);

        /// <summary>
        /// The parameters, all parts given. What they point at belongs to the session and stays until
        /// `tree_sketch_session_set_params` or `tree_sketch_session_free`. Set `params-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_params(tree_sketch_session* session, tree_sketch_params* @params);

        /// <summary>
        /// How often a stage has been done so far.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_runs(tree_sketch_session* session, uint stage, uint* n_runs);

        /// <summary>
        /// The strokes as a tree in the plane, in metres, with what was done to them. Free it with `tree_plan_free`.
        /// `TREE_ERROR_INVALID` says which stroke is of no use, or why the drawing is.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_plan(tree_sketch_session* session, tree_control* control, tree_plan** plan);

        /// <summary>
        /// The closed crown. What was repaired of it is among `tree_sketch_session_warnings`. Free it with `tree_crown_free`.
        /// `TREE_ERROR_NO_RESULT` where none is drawn.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_crown(tree_sketch_session* session, tree_control* control, tree_crown** crown);

        /// <summary>
        /// The templates compared with the drawing, best first: indices count in the session's templates, or in those built
        /// in. Their number goes into `n_choices`, they themselves into `choices`, which has room for `capacity` rows; with
        /// NULL they are only counted. There are none where the template was taken by name, or kept through an edit.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_choices(tree_sketch_session* session, tree_control* control, tree_choice* choices, UIntPtr capacity, UIntPtr* n_choices);

        /// <summary>
        /// The template taken: templates of one row. Free them with `tree_templates_free`. `TREE_ERROR_UNKNOWN_NAME` lists
        /// the names there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_template_taken(tree_sketch_session* session, tree_control* control, tree_templates** taken);

        /// <summary>
        /// Depths, labels and Ω. Free them with `tree_inferred_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_inferred(tree_sketch_session* session, tree_control* control, tree_inferred** inferred);

        /// <summary>
        /// The sketched branches with what grew on them. `report` may be NULL. Free them with `tree_sketch_branches_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_branches(tree_sketch_session* session, tree_control* control, tree_sketch_propagate_report* report, tree_sketch_branches** branches);

        /// <summary>
        /// The branches as a skeleton with radii. Free it with `tree_skeleton_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_wood(tree_sketch_session* session, tree_control* control, tree_skeleton** wood);

        /// <summary>
        /// The tree. The same drawing, parameters and seed give the same bits for any number of threads. `control` and `report`
        /// may be NULL. Free the tree with `tree_tree_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_tree(tree_sketch_session* session, tree_control* control, tree_sketch_report* report, tree_tree** tree);

        /// <summary>
        /// All that was repaired or fell short, a line each, for a person to read; none where all went well. The tree is made
        /// first where it is not there. Free the lines with `tree_lines_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_session_warnings(tree_sketch_session* session, tree_control* control, tree_lines** warnings);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_params_init(tree_sketch_params* @params, UIntPtr size);

        /// <summary>
        /// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. The name of the
        /// template is looked up when it is needed.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_sketch_params_check(tree_sketch_params* @params);

        /// <summary>
        /// Makes a tree of a drawing: a session (`tree_sketch_session`) that is asked for its tree, in one call. Of
        /// `templates`, which may be NULL for those built in, the one that suits best guides it, or the one that `params`
        /// names; new branches keep out of `obstacles`, which may be NULL. `params`, `control` and `report` may be NULL too.
        /// The tree's species is called by the template's name, unless `params` has a species. Free the tree with
        /// `tree_tree_free`.
        ///
        /// `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_UNKNOWN_NAME` a template or species that there is
        /// not; `TREE_ERROR_INVALID` says why a drawing, and which stroke of it, is of no use; `TREE_ERROR_LIMIT` comes before
        /// the memory is asked for.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_from_sketch(tree_drawing* drawing, tree_templates* templates, tree_volume* obstacles, tree_sketch_params* @params, ulong seed, tree_control* control, tree_sketch_report* report, tree_tree** tree);

        /// <summary>
        /// The templates shipped: twenty trees of different habit. Free them with `tree_templates_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_builtin(tree_templates** templates);

        /// <summary>
        /// Reads templates from text, `text` of `len` bytes or `TREE_NUL_TERMINATED`, as `tree_templates_to_text` writes it.
        /// `control` may be NULL; only its limits matter. Free the templates with `tree_templates_free`. `TREE_ERROR_FORMAT`
        /// names the line and says what is wrong with it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_from_text(byte* text, UIntPtr len, tree_control* control, tree_templates** templates);

        /// <summary>
        /// Writes templates as text, some kilobytes for each. Free the bytes, which are UTF-8, with `tree_bytes_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_to_text(tree_templates* templates, tree_bytes** bytes);

        /// <summary>
        /// Makes `params`, of `size` bytes, the default.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_template_params_init(tree_template_params* @params, UIntPtr size);

        /// <summary>
        /// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_template_params_check(tree_template_params* @params);

        /// <summary>
        /// Measures one template of any tree, which grows along +Y: an exemplar of your own. `name` and `species` are one line of
        /// text each, of `name_len` and `species_len` bytes or `TREE_NUL_TERMINATED`; the species names its leaves. `params` and
        /// `control` may be NULL. Free the template with `tree_templates_free`; `tree_templates_join` puts it to others.
        /// `TREE_ERROR_INVALID` for trees without extent, height or branches.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_of_tree(byte* name, UIntPtr name_len, byte* species, UIntPtr species_len, tree_tree* tree, tree_template_params* @params, tree_control* control, tree_templates** templates);

        /// <summary>
        /// Templates and others after them, copied. Free them with `tree_templates_free`. `TREE_ERROR_INVALID` where two have one
        /// name.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_join(tree_templates* templates, tree_templates* others, tree_templates** joined);

        /// <summary>
        /// Number of templates.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_count(tree_templates* templates, UIntPtr* n_templates);

        /// <summary>
        /// Index of the template called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). `TREE_ERROR_UNKNOWN_NAME` lists the names
        /// there are.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_find(tree_templates* templates, byte* name, UIntPtr len, UIntPtr* index);

        /// <summary>
        /// Views a template. `index` is below `tree_templates_count`. Set `view-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_view(tree_templates* templates, UIntPtr index, tree_template_view* view);

        /// <summary>
        /// Views what a template looks like from one side. `index` is below `tree_templates_count`, `number` below `n_views` of
        /// the template. Set `side-&gt;struct_size` first.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_side(tree_templates* templates, UIntPtr index, UIntPtr number, tree_template_side* side);

        /// <summary>
        /// Frees templates. What was made of them lives on.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_templates_free(tree_templates* templates);

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
        /// Frees a tree.
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
        /// Frees a volume. What was made of it lives on. `TREE_ERROR_ORDER` for the volumes of presets, which
        /// belong to the library.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_free(tree_volume* volume);

        /// <summary>
        /// Makes what lies in any of `n_volumes` volumes, at least 1. As all that combine volumes: the volumes
        /// may be freed afterwards; combinations nest at most 48 deep (a union of unions is no deeper than one)
        /// and hold at most 1,048,576 solids.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_union(tree_volume** volumes, UIntPtr n_volumes, tree_volume** volume);

        /// <summary>
        /// Makes what lies in all of `n_volumes` volumes, at least 1. It may turn out empty, which is no error.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_intersection(tree_volume** volumes, UIntPtr n_volumes, tree_volume** volume);

        /// <summary>
        /// Makes what lies in `from` but not in `without`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_difference(tree_volume* from, tree_volume* without, tree_volume** volume);

        /// <summary>
        /// Makes `source` moved, turned, scaled or sheared. `columns` is twelve floats, column by column: where
        /// the X, Y and Z axes go, three floats each, and then where the origin goes. They must be finite and not
        /// flatten the volume.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_transformed(tree_volume* source, float* columns, tree_volume** volume);

        /// <summary>
        /// Says of `n_points` points, three floats each, whether they lie inside: 1 or 0 into `inside`, which has
        /// room for as many. 0 for points that are not finite. `control` may be NULL; `nodes` of its limits caps
        /// the points.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_contains(tree_volume* volume, float* points, UIntPtr n_points, tree_control* control, byte* inside);

        /// <summary>
        /// Writes the signed distance of `n_points` points, three floats each, from the surface into `distances`,
        /// which has room for as many: metres, negative inside, NaN for points that are not finite. It is exact,
        /// or never too long and of the right sign; see `tree_volume_distance_is_exact`. `control` as for
        /// `tree_volume_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_distance(tree_volume* volume, float* points, UIntPtr n_points, tree_control* control, float* distances);

        /// <summary>
        /// Whether `tree_volume_distance` is exact everywhere, 1 or 0: 1 for plain solids, turned, moved and
        /// uniformly scaled or not, 0 for combinations.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_distance_is_exact(tree_volume* volume, uint* is_exact);

        /// <summary>
        /// A box around the volume: its lower corner, then its upper one, in metres. The smallest for plain
        /// solids, else not always. Infinite for half-spaces; lower above upper where it is empty.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_bounds(tree_volume* volume, float* min_max);

        /// <summary>
        /// Whether the bounds are finite, 1 or 0, so that the volume can be sampled and trees can grow in it.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_is_bounded(tree_volume* volume, uint* is_bounded);

        /// <summary>
        /// Cubic metres inside, where there is a closed form: for all plain solids but half-spaces, and these
        /// transformed. Otherwise NaN; then there is `tree_volume_estimate_measure`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_measure(tree_volume* volume, float* measure);

        /// <summary>
        /// Cubic metres inside by sampling about `n_samples` points: the same in every run; the error falls a
        /// little faster than 1 / sqrt(`n_samples`). Infinite when the bounds are, 0 when they are empty. 20,000
        /// samples take some milliseconds.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_estimate_measure(tree_volume* volume, uint n_samples, tree_control* control, float* measure);

        /// <summary>
        /// Writes `n_points` random points, uniform in the volume, three floats each, into `points`. The same
        /// `seed` gives the same points. For each at most `attempts` points of the bounds are drawn; 64 do for
        /// any plain solid but very narrow ones. `TREE_ERROR_NO_RESULT`, and nothing is written, when none of them
        /// lay inside, or the bounds are infinite or empty. `control` as for `tree_volume_contains`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_sample(tree_volume* volume, UIntPtr n_points, uint attempts, ulong seed, tree_control* control, float* points);

        /// <summary>
        /// Makes a ball. `center` is three floats; `radius` is above 0. As all that make volumes: metres,
        /// `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` names what is out of range or not finite, and the
        /// volume is freed with `tree_volume_free`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_sphere(float* center, float radius, tree_volume** volume);

        /// <summary>
        /// Makes an axis-aligned ellipsoid. `center` and `radii` are three floats each; `radii` are half its
        /// extents, above 0. Turn it with `tree_volume_transformed`.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_ellipsoid(float* center, float* radii, tree_volume** volume);

        /// <summary>
        /// Makes a round cylinder between the middles of its ends, `base` and `top`, three floats each, which
        /// differ; `radius` is above 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_cylinder(float* @base, float* top, float radius, tree_volume** volume);

        /// <summary>
        /// Makes a truncated cone between the middles of its ends, `base` and `top`, three floats each, which
        /// differ. Radii are 0 or more, and one of them above 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_frustum(float* @base, float* top, float base_radius, float top_radius, tree_volume** volume);

        /// <summary>
        /// Makes the cone between a disc round `base` and a tip, `apex`, three floats each, which differ;
        /// `base_radius` is above 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_cone(float* @base, float* apex, float base_radius, tree_volume** volume);

        /// <summary>
        /// Makes all points within `radius`, above 0, of the segment from `start` to `end`, three floats each; a
        /// ball where both are the same.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_capsule(float* start, float* end, float radius, tree_volume** volume);

        /// <summary>
        /// Makes an axis-aligned box. `min` and `max` are three floats each; `min` lies below `max` on every
        /// axis.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_box(float* min, float* max, tree_volume** volume);

        /// <summary>
        /// Makes all on the side of a plane through `point` that `normal` points away from; three floats each,
        /// the normal of any length but 0. It has no end: to sample it, intersect it with a solid that has.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_half_space(float* point, float* normal, tree_volume** volume);

        /// <summary>
        /// Makes the points within `radius`, above 0, of `apex` and within `angle` of `axis`: radians above 0, at
        /// pi the whole ball. `apex` and `axis` are three floats each, the axis of any length but 0.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_sector(float* apex, float* axis, float angle, float radius, tree_volume** volume);

        /// <summary>
        /// Makes what a profile sweeps when it turns about `axis`, which has any length but 0 and along which
        /// heights are counted from `base`; three floats each. `profile` is `n_points` times two floats: distance
        /// from the axis, 0 or more and not all 0, and height, not all the same. The line is closed to the axis by
        /// a level line at both ends; heights may rise and fall. `control` may be NULL; only its limits matter
        /// (`nodes` caps the points).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_revolution(float* @base, float* axis, float* profile, UIntPtr n_points, tree_control* control, tree_volume** volume);

        /// <summary>
        /// Makes what a closed triangle mesh bounds. `positions` is `n_positions` times three floats; corners at
        /// the same place count as one. `indices` is `n_triangles` times three. Along each edge as many triangles
        /// run one way as the other; inside is where the winding number is not 0. `TREE_ERROR_PARAMETER` names an
        /// open edge or an index that is too large. `control` may be NULL; only its limits matter (`triangles`
        /// caps the triangles and the positions).
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_closed_mesh(float* positions, UIntPtr n_positions, uint* indices, UIntPtr n_triangles, tree_control* control, tree_volume** volume);

        /// <summary>
        /// Views what a volume is made of. Set `solid-&gt;struct_size` first; what it points at is valid until the
        /// volume is freed. A cone is a frustum; combinations are as the library keeps them, a union of unions as
        /// one union.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_view(tree_volume* volume, tree_solid* solid);

        /// <summary>
        /// A part of a combination, `index` below `tree_solid.n_parts`. Free it with `tree_volume_free`; it may
        /// outlive the combination.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int tree_volume_part(tree_volume* volume, UIntPtr index, tree_volume** part);
    }
}
