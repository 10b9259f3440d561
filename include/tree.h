/* The tree family's C interface. Made by cbindgen from tree-ffi/src: do not edit.
 * Licence: MIT OR Apache-2.0. */

#ifndef TREE_H
#define TREE_H

#include <stddef.h>
#include <stdint.h>

// A first tree, by the names of the functions: `tree_path_preset` fills in parameters, `tree_path_grow` makes
// a `tree_tree` of them, `tree_mesh_build` a `tree_mesh` of that, `tree_mesh_surface` shows its columns, which
// an engine uploads; `tree_mesh_write_glb` writes a file. `tree_mesh_free` and `tree_tree_free` at the end.
// `examples/c/oak.c` does this.
//
// From a sketch: `tree_drawing_new`, `tree_drawing_from_svg` or `tree_drawing_from_json` takes its strokes;
// `tree_drawing_clean` joins them to a `tree_plan` and tells what it repaired; `tree_crown_close` makes a solid of
// its crown; `tree_templates_select` says which kind of tree it looks like. `tree_sketch_infer` finds
// depths, `tree_sketch_branches_propagate` what was left out, `tree_sketch_branches_wood` and `tree_sketch_grow_crown`
// make the tree. A `tree_sketch_session` does all that and lets strokes and depths be changed; `tree_from_sketch` does
// it in one call.
//
// From outlines: `tree_outline_drawing_from_svg`, `tree_outline_drawing_of_matte` or `tree_outline_drawing_of_photo` reads what was
// drawn, `tree_outline_close` closes a stroke. Step by step, `tree_outline_bumps`, `tree_branch_infer` and `tree_outline_sub`
// find branches and their parts of the outline, `tree_arranged_new` and `tree_revolved_of` their places and lengths round the
// parent; `tree_leaf_outline_model` makes a drawn leaf one that a look takes.
//
// From grammars: `tree_lsystem_preset`, `tree_grammar_from_text` or `tree_grammar_read` gives a grammar,
// `tree_lsystem_grow` a tree of it. Step by step, `tree_grammar_derive` makes a `tree_word`, `tree_grammar_interpretation` what
// a turtle sees of it, `tree_word_interpret` a tree, `tree_word_lines` lines; `tree_tree_to_word` writes any tree as a word.
//
// Level of detail: `tree_elements_of_mesh` divides the foliage of a mesh, `tree_order_coverage` puts it in the
// order in which it is drawn, `tree_lod_table_measure` finds how large the rest must grow. `tree_tiers_of_mesh`
// makes outlines simpler, `tree_lod_plan` says when; `tree_pruned_new` makes a `tree_pruned` of it all,
// `tree_pruned_make` in one call. `tree_pruned_mesh` is uploaded once, `tree_pruned_level` says which window of it
// is drawn, with `tree_prune_shader`. A `tree_scene` of such models, `tree_pruned_scene_levels`, says in each
// frame what is drawn of which tree: `tree_scene_state_select`, then `tree_scene_state_draws` into your own
// buffers.
//
// Levels as prefixes: `tree_multires_new` sorts a tree such that a level is a prefix of its columns, `tree_multires_level`.
// `tree_multires_to_stream` makes bytes of which every prefix is a coarser tree; a `tree_stream_reader` takes them as they
// arrive. `tree_multi_mesh_new` draws it, `tree_multi_mesh_draws` says how much of each index buffer a level draws, and
// `tree_multi_mesh_shader` lets branches grow in. Chains of modules, with brackets: `tree_adt_of_tokens`, `tree_multi_paths_new`,
// `tree_multi_chain_new`.
// Impostors: `tree_leaf_bearers_of_tree` says which branch carries each leaf (elements of `TREE_GRAIN_LEAF`),
// `tree_leaf_boxes_along` finds boxes along the branches, `tree_cards_bake` pictures of their leaves.
// `tree_cards_pixels` and `tree_cards_mesh` are uploaded; in each frame `tree_card_choice_update` says which boxes,
// and which leaves, are drawn, with `tree_cards_shader`. From afar a whole tree is a `tree_octahedral_bake`.
//
// All distances: `tree_hybrid_make` puts a tree's wood with levels and its leaves with cards into one model. `tree_hybrid_mesh`
// is uploaded; in each frame `tree_hybrid_choice_update` says how much of the wood, which boxes and which leaves are drawn.
// `tree_hybrid_write_glb_levels` writes it for programs without shaders of ours.
//
// Scans: `tree_cloud_read` takes a file of points, `tree_skeletonize_scan` or `tree_skeletonize_cloud` finds the trees in it.
//
// Growing: `tree_growth_preset` and `tree_growth_grow` for a tree that stands alone; `tree_growth_new` plants several that compete,
// `tree_growth_step` lets years pass, `tree_growth_grown` hands out a tree. `tree_grown_view` has the ages of its nodes.
//
// Reacting: `tree_plastic_new` reads a tree; in a `tree_plastic_scene` trees, obstacles and the sky are put and moved,
// `tree_plastic_scene_update` works out what that means, `tree_plastic_scene_adapted` hands out a tree as it is then.
// `examples/c/wall.c` does this.
//
// Measuring: `tree_skeleton_branching` gives the figures of foresters, `tree_skeleton_runs` and
// `tree_skeleton_lateral_angles` the rows behind them.
//
// Comparing: `tree_skeleton_distance` says how different two trees are, `tree_skeleton_distance_pairs` which branch is which.
//
// * Status. Functions that can fail return a `tree_status`, `TREE_OK` or a code. What was wrong,
//   where, and what would be right is in `tree_error_text`, thread by thread. Nothing unwinds into the
//   caller: a defect is `TREE_ERROR_PANIC`. Only memory that the system refuses ends the process; a budget
//   (`tree_memory_set_budget`) comes before that.
// * Handles (`tree_mesh *` and so on) are made by the library, never change after that, may be read
//   by any number of threads at once, and end by their `_free`, which accepts NULL. A handle that was
//   freed, or is of another kind, is `TREE_ERROR_HANDLE` (unless its address has been given to a new object of
//   its kind). Handles keep alive what they are made of. Some kinds change, `tree_photo_session`,
//   `tree_sketch_session`, `tree_silhouette_session`, `tree_scene`, `tree_scene_state`, `tree_card_choice`,
//   `tree_hybrid_choice`, `tree_growth`, `tree_plastic_scene` and `tree_stream_reader`: one thread at a time.
// * Out parameters come last. A handle's place is set to NULL first, so after an error it is NULL; what
//   stood there before is not freed.
// * Views (`tree_surface` and so on) point into the object they were asked of: tightly packed,
//   nothing copied, valid until that object is freed. A column without rows is NULL.
// * Structs of parameters and views begin with `struct_size`. Parameters: call `tree_X_init(&x,
//   sizeof x)`, which fills in the defaults, and change what should differ; NULL instead of parameters
//   means the defaults. Views and reports: set `struct_size` to `sizeof x`; NULL where a report is not
//   wanted. So programs built with an older header go on with a newer library. Fields named `reserved`
//   are 0.
// * Texts are UTF-8, a pointer and a number of bytes; `TREE_NUL_TERMINATED` as number for C strings.
// * Constants of one kind share a `typedef` and a prefix. A number that is none of them is
//   `TREE_ERROR_ENUM`. A yes or no is a `uint32_t`, 0 is no and anything else yes.
// * Control (`tree_control`) is taken by all that can run long: progress, cancellation, limits,
//   threads. NULL means: no progress, no cancellation, default limits, all cores.
// * Axes: right-handed, +Y up, metres, radians, triangles counter-clockwise from outside, texture v
//   downwards, quaternions as x, y, z, w; `tree_convention` lists others.
// * What cannot be caught is yours to keep: arrays as long as their count says, structs as long as their
//   `struct_size` says, no view used after its object, nothing freed in one thread while another uses it, no
//   exception thrown out of a callback.
/* Length of a text that ends with a NUL byte instead. */
#define TREE_NUL_TERMINATED SIZE_MAX

// Exponent of the pipe model by Leonardo da Vinci: the cross-sections above a fork together are the
// cross-section below.
#define TREE_PIPE_DA_VINCI 2.0f

// Exponent of the pipe model by Murray (1927), who measured circumferences against the weight they
// carry.
#define TREE_PIPE_MURRAY 2.49f

// Exponent of the pipe model by Mandelbrot (1983), 8/3.
#define TREE_PIPE_MANDELBROT 2.6666667f

// The pipe model, for most trees: at every fork the powers of the radii above add up to that below
// (da Vinci, Murray, Mandelbrot).
#define TREE_RADII_PIPE 0

// The further from the tip, the thicker; the higher the order of the axis, the thinner (Xu & Mould).
#define TREE_RADII_TIP_DISTANCE 1

// By counting strands that run from the base to the tips (Holton).
#define TREE_RADII_STRANDS 2

// One strand for each tip, which makes the rule da Vinci's.
#define TREE_STRANDS_PER_TIP 0

// A number at the base, shared out at forks: the less a branch turns away, the more it gets.
#define TREE_STRANDS_BY_ANGLE 1

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

// A number, in a parameter or in a column, lies outside its range or is not finite.
#define TREE_ERROR_PARAMETER 6

// Columns do not fit together: lengths, orders, indices that name nothing.
#define TREE_ERROR_INVALID 7

// No preset, texture or format has this name.
#define TREE_ERROR_UNKNOWN_NAME 8

// More was asked for than the limits of `tree_control` allow.
#define TREE_ERROR_LIMIT 9

// The memory budget does not allow it.
#define TREE_ERROR_MEMORY 10

// The caller cancelled. Nothing was written, and nothing was changed but where a function says so.
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

// Its radius in metres; of a run or an axis, the mean over its length. The default.
#define TREE_EDIT_WEIGHT_RADIUS 0

// Radius times length of its segment in square metres, which goes with the bark, however finely a shoot is divided.
#define TREE_EDIT_WEIGHT_RADIUS_TIMES_LENGTH 1

// Radius squared times length in cubic metres, which goes with the wood.
#define TREE_EDIT_WEIGHT_RADIUS_SQUARED_TIMES_LENGTH 2

// 1 each: structure only.
#define TREE_EDIT_WEIGHT_UNIT 3

// Every node stays one.
#define TREE_EDIT_REDUCTION_NONE 0

// An unbranched run, from above a fork up to the next fork or a tip: how finely shoots are divided does not matter.
// The default.
#define TREE_EDIT_REDUCTION_RUNS 1

// An axis with all its nodes; its laterals are its children, wherever they leave it.
#define TREE_EDIT_REDUCTION_AXES 2

// Ours: glTF, also Bevy and three.js.
#define TREE_CONVENTION_GLTF 0

// Godot 4.
#define TREE_CONVENTION_GODOT 1

// Unity.
#define TREE_CONVENTION_UNITY 2

// Unreal Engine.
#define TREE_CONVENTION_UNREAL 3

// Blender.
#define TREE_CONVENTION_BLENDER 4

// From our axes to theirs.
#define TREE_CONVERT_TO 0

// From their axes back to ours.
#define TREE_CONVERT_BACK 1

// Unity's SpeedTree 8 shader: one branch, and leaves.
//
// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
// times, blend (1); UV0 4 f32: u, v, branch weight, branch direction; UV1 4 f32: light map u, v, anchor
// x, y; UV2 4 f32: the vertex's place in the next level of detail (itself), anchor z; UV3 4 f32: leaf
// scale, growth, ripple, kind (0 wood, 2 leaf).
#define TREE_LAYOUT_SPEEDTREE8 0

// Unity's SpeedTree 9 shader: two branches, and leaves. `stretch_limits` of the view belong into
// `_ST_BranchStretchLimits`.
//
// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
// times, blend (1); UV0 4 f32: u, v, noise and direction of branch 1; UV1 4 f32: light map u, v, weight
// of branch 1, ripple weight; UV2 4 f32: noise, direction and weight of branch 2, 0; UV3 4 f32: anchor
// x, y, z, 0.
#define TREE_LAYOUT_SPEEDTREE9 1

// Unity's Tree Creator shaders, and most vegetation shaders: bend weights and a phase.
//
// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: branch phase,
// edge flutter, 0, occlusion; UV0 2 f32: u, v; UV1 2 f32: primary and secondary bend.
#define TREE_LAYOUT_TREE_CREATOR 2

// Unreal's Pivot Painter 2: the hierarchy, at most 4 levels, in two textures that
// `tree_packed_pivots` views.
//
// POSITION 3 f32, centimetres in Unreal's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion,
// flutter, leaf phase, 1; UV0 2 f32: u, v; UV1 2 f32: light map u, v; UV2 2 f32: texel of the element.
#define TREE_LAYOUT_PIVOT_PAINTER 3

// Godot 4, `CUSTOM0` to `CUSTOM3` as floats: the own branch in full, and the parent's part.
//
// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three times, 1; UV 2
// f32: u, v; UV2 2 f32: light map u, v; CUSTOM0 4: pivot x, y, z, reach; CUSTOM1 4: axis x, y, z, phase;
// CUSTOM2 4: stiffness, level, flutter, leaf phase; CUSTOM3 4: parent's pivot x, y, z, reach of the
// pivot on the parent.
#define TREE_LAYOUT_GODOT 4

// As `TREE_LAYOUT_GODOT`, with `CUSTOM0` to `CUSTOM3` as halves: 32 bytes a vertex instead of 64. Pivots
// are rounded to 4 mm at 8 m, 8 mm at 16 m.
#define TREE_LAYOUT_GODOT_HALF 5

// glTF attributes `_WIND*`: all of it. `tree_mesh_gltf_wind` gives them for files.
//
// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; `COLOR_0` 4 unorm8: occlusion three times, 1;
// `TEXCOORD_0` 2 f32; `TEXCOORD_1` 2 f32; `_WIND_PIVOT` 3 f32; `_WIND_AXIS` 3 f32; `_WIND` 4 f32:
// reach, phase, stiffness, length in metres; `_WIND_LEAF` 4 f32: flutter, leaf phase, level, 1 for
// leaves; `_WIND_ANCHOR` 3 f32; `_WIND_BRANCH` 4 u16: branch low, high, parent low, high.
#define TREE_LAYOUT_GLTF_WIND 6

// Own renderers: 32 bytes a vertex, quantised, in our axes; `tree_packed_vertices` views them. There are
// no streams.
#define TREE_LAYOUT_VERTEX 7

// 32-bit floats.
#define TREE_NUMBER_F32 0

// 16-bit floats.
#define TREE_NUMBER_F16 1

// Whole numbers of 16 bits, without sign.
#define TREE_NUMBER_U16 2

// Bytes that stand for 0 to 1.
#define TREE_NUMBER_UNORM8 3

// Element of a branch that has none.
#define TREE_NO_ELEMENT 4294967295u

// One at a node, each turned by the same angle from the last. Oak, poplar.
#define TREE_PHYLLOTAXIS_SPIRAL 0

// One at a node, in two rows. Beech, elm, linden.
#define TREE_PHYLLOTAXIS_DISTICHOUS 1

// Two at a node, all pairs in one plane.
#define TREE_PHYLLOTAXIS_OPPOSITE 2

// Two at a node, each pair across the last. Maple, ash.
#define TREE_PHYLLOTAXIS_DECUSSATE 3

// Three or more at a node, each whorl in the gaps of the last.
#define TREE_PHYLLOTAXIS_WHORLED 4

// Densities above this count as this.
#define TREE_DENSITY_CAP 4.0f

// One blade. Oak, beech, linden.
#define TREE_LEAVES_SIMPLE 0

// Leaflets along a rachis. Ash, walnut, rowan; palms with feathers.
#define TREE_LEAVES_PINNATE 1

// Leaflets from one point, like fingers. Horse chestnut; palms with fans.
#define TREE_LEAVES_PALMATE 2

// A few needles from one sheath, evenly round its axis. Pines.
#define TREE_LEAVES_FASCICLE 3

// Many needles on a short shoot, from its axis to all sides. Larch, cedar.
#define TREE_LEAVES_ROSETTE 4

// One main axis, with laterals. Spruce, oak.
#define TREE_BRANCHING_MONOPODIAL 0

// A chain of modules: each ends, and its topmost lateral takes over. Linden, elm, beech.
#define TREE_BRANCHING_SYMPODIAL 1

// The extended Borchert-Honda model: main axis and laterals get shares λ Qₘ : (1 - λ) Qₗ for the light Q behind each.
// The default.
#define TREE_ALLOCATION_BORCHERT_HONDA 0

// The priority model: buds and branches of each axis are ranked by mean light, the terminal bud first, and get shares by
// light times weight.
#define TREE_ALLOCATION_PRIORITY 1

// By light: leaves shade what is below them. Crowns fill from the outside and self-prune within. The default.
#define TREE_GROWTH_BY_LIGHT 0

// By space: buds compete for markers of free space. Branches keep apart, and a crown can be prescribed.
#define TREE_GROWTH_BY_SPACE 1

// Parent of the box of the whole tree: no box.
#define TREE_NO_BOX 4294967295u

// sRGB colour of the surface without light, and alpha: the covered share of each texel.
#define TREE_IMPOSTOR_COLOR 0

// Normal in the space of the tree, -1 to 1 as 0 to 255, and in alpha the depth. These are numbers, not colours: upload
// them without sRGB.
#define TREE_IMPOSTOR_DETAIL 1

// Planes of a box.
#define TREE_CARD_PLANES 6

// PLY, text or binary, of either order of bytes: the vertices; other properties and elements are passed over.
#define TREE_CLOUD_FORMAT_PLY 1

// XYZ, TXT, CSV, ASC, PTS: a point on each line, columns parted by blanks, commas, semicolons or tabs. A line of names
// may say which columns are x, y and z; else they are the first three. Lines behind `#`, `//` and `;` are comments.
#define TREE_CLOUD_FORMAT_TEXT 2

// As the attribute `_OCCLUSION`, which only shaders that know it use.
#define TREE_GLTF_OCCLUSION_ATTRIBUTE 0

// As grey vertex colours (`COLOR_0`, 8 bits), which every program multiplies with the base colour:
// visible everywhere, but direct light is darkened too.
#define TREE_GLTF_OCCLUSION_COLOR 1

// Not at all.
#define TREE_GLTF_OCCLUSION_OMIT 2

// Primitives, elements or lines that are points or lines, left out.
#define TREE_NOTE_POINTS_OR_LINES 0

// Primitives without positions, left out.
#define TREE_NOTE_NO_POSITIONS 1

// Corners left over behind the last whole triangle, or faces with fewer than three.
#define TREE_NOTE_PARTIAL_FACES 2

// Surfaces (OBJ: corners) whose normals were computed because there were none.
#define TREE_NOTE_NORMALS_COMPUTED 3

// Single normals of no length, computed from the triangles around.
#define TREE_NOTE_NORMALS_REPAIRED 4

// Surfaces (OBJ: corners) without texture coordinates, which became 0.
#define TREE_NOTE_UVS_MISSING 5

// Vertex colours, which a surface has no column for. PLY: their mean became the material's.
#define TREE_NOTE_VERTEX_COLORS 6

// Skins and morph targets; the mesh is as it rests.
#define TREE_NOTE_DEFORMATIONS 7

// Nodes a scene lists as roots although they are not.
#define TREE_NOTE_LISTED_TWICE 8

// Materials that blend by alpha, cut at one half instead.
#define TREE_NOTE_BLEND_AS_MASK 9

// Normal, roughness, occlusion and emission maps, left out.
#define TREE_NOTE_OTHER_TEXTURES 10

// Colours and factors outside their range, brought back into it.
#define TREE_NOTE_CLAMPED 11

// Textures and materials in other files, which were not asked for.
#define TREE_NOTE_EXTERNAL_REFUSED 12

// Textures and materials in files that are not there.
#define TREE_NOTE_EXTERNAL_MISSING 13

// Textures that could not be decoded.
#define TREE_NOTE_TEXTURE_UNREADABLE 14

// Textures without a picture in a known format.
#define TREE_NOTE_TEXTURE_UNSUPPORTED 15

// Materials that faces name and no file defines.
#define TREE_NOTE_MATERIAL_UNKNOWN 16

// Statements or elements that are not understood, passed over.
#define TREE_NOTE_UNKNOWN 17

// Number of notes in this version; new ones may be added.
#define TREE_N_NOTES 18

// As the file's extension says: `glb`, `gltf`, `obj` or `ply`, in letters of any case.
#define TREE_MESH_FORMAT_BY_NAME 0

// glTF 2.0, as one file (GLB) or as JSON.
#define TREE_MESH_FORMAT_GLTF 1

// OBJ.
#define TREE_MESH_FORMAT_OBJ 2

// PLY, text or binary.
#define TREE_MESH_FORMAT_PLY 3

// Samples of a `tree_lod_distance`.
#define TREE_LOD_DISTANCE_SAMPLES 21

// A connected piece: a card, a leaflet of a compound leaf, a single leaf. The two sides of a doubled card are
// elements of their own.
#define TREE_GRAIN_BLADE 0

// A triangle, scaled about the centre of its blade: better pictures still, at the price of cut cards that
// are seen when one comes near.
#define TREE_GRAIN_TRIANGLE 1

// A leaf with all its blades, where the mesh tells (its surfaces have anchors), otherwise as
// `TREE_GRAIN_BLADE`. Nothing is ever half a leaf.
#define TREE_GRAIN_LEAF 2

// WGSL.
#define TREE_SHADER_WGSL 0

// GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
#define TREE_SHADER_GLSL 1

// HLSL, any shader model.
#define TREE_SHADER_HLSL 2

// Not at all: every tree counts as seen.
#define TREE_SCENE_OCCLUSION_NONE 0

// From depths the engine drew.
#define TREE_SCENE_OCCLUSION_DEPTH 1

// From the models' occluders, drawn by the library; ground and houses hide nothing.
#define TREE_SCENE_OCCLUSION_BUILT_IN 2

// The best for each lambda (Neubert 2012, eq. 7.6).
#define TREE_LOD_SCALE_BEST 0

// 1 / lambda (Cook et al. 2007).
#define TREE_LOD_SCALE_COOK 1

// Always 1: leaves keep their size.
#define TREE_LOD_SCALE_KEPT 2

// That of the field `fixed`.
#define TREE_LOD_SCALE_FIXED 3

// A rectangle as large as the picture. Two triangles; the least memory, the most overdraw.
#define TREE_LEAF_CARD 0

// A polygon of at most `max_vertices` vertices around all of the picture that is not cut away: no visible
// pixel is lost, few invisible ones are drawn. A picture without a mask, or all of it cut away, stays a
// card; the report says so.
#define TREE_LEAF_OUTLINE 1

// A leaf whose margin is modelled: a polygon along the margin of the picture, as much inside as outside,
// drawn without a mask. For close views and for renderers that pay for masks. Leaves are taken to be
// alike left and right. Pictures as above stay cards.
#define TREE_LEAF_MODELLED 2

// A leaf of your own, shared by all leaves of the kind.
#define TREE_LEAF_MESH 3

// Alpha is ignored.
#define TREE_ALPHA_OPAQUE 0

// Pixels with alpha below the material's `alpha_cutoff` are not drawn.
#define TREE_ALPHA_MASK 1

// Kind of the module `[`, in every alphabet: a branch begins.
#define TREE_KIND_PUSH 0

// Kind of the module `]`, in every alphabet: a branch ends.
#define TREE_KIND_POP 1

// As many derivations as the text of the grammar asks for.
#define TREE_STEPS_OF_TEXT 4294967295u

// None: there is no mistake, or it has no place.
#define TREE_GRAMMAR_PLACE_NONE 0

// A line and a column of the text.
#define TREE_GRAMMAR_PLACE_TEXT 1

// A module of the word.
#define TREE_GRAMMAR_PLACE_MODULE 2

// The width is that of a segment's base; it narrows to the thickest segment that follows. The default.
#define TREE_TAPER_SMOOTH 0

// The width is that of a segment's upper end, as words of skeletons have it.
#define TREE_TAPER_ENDS 1

// From the widths of the word where it sets any with `!` or `#`, or else from `radii`. The default.
#define TREE_THICKNESS_AUTO 0

// From the widths of the word.
#define TREE_THICKNESS_WORD 1

// From `radii`, whatever the word says.
#define TREE_THICKNESS_RULE 2

// Straight from node to node.
#define TREE_CURVE_STRAIGHT 0

// A clamped cubic B-spline through the nodes: what was modelled stays where it is.
#define TREE_CURVE_THROUGH 1

// A clamped cubic B-spline with the nodes as control points: passes near inner nodes, and calms what
// jitters, such as scanned skeletons.
#define TREE_CURVE_NEAR 2

// As a length.
#define TREE_BOUND_METRES 0

// As what a camera sees: the nearer it comes, the finer the mesh.
#define TREE_BOUND_PIXELS 1

// A triangle counts as flat when its area is below this share of the squared diagonal of the box around
// the surface: a square with a side of a ten-millionth of the diagonal, and a tenth as high. For a tree of
// 10 m that is 1e-13 m².
#define TREE_FLAT_SHARE 1e-15

// Any module that is no bracket, with the length that it draws.
#define TREE_TOKEN_MODULE 0

// `[`: a branch begins.
#define TREE_TOKEN_PUSH 1

// `]`: it ends.
#define TREE_TOKEN_POP 2

// A module of the plain chain; its value is its place there.
#define TREE_ITEM_MODULE 0

// `SAVE`: the turtle keeps its state under this number.
#define TREE_ITEM_SAVE 1

// `RESTORE`: the turtle goes back to the state of this number, and a level begins.
#define TREE_ITEM_RESTORE 2

// Length of the branch and of all that it bears; what has been put into a path does not count any more. What the paper
// prefers.
#define TREE_METRIC_BRANCHING_LENGTH 0

// As `TREE_METRIC_BRANCHING_LENGTH`, with worths of your own in the place of lengths: areas of wood, numbers of leaves.
#define TREE_METRIC_BRANCHING 1

// Number of children.
#define TREE_METRIC_CHILDREN 2

// Number of descendants.
#define TREE_METRIC_DESCENDANTS 3

// Longest way to a tip, the branch itself included.
#define TREE_METRIC_LONGEST_PATH 4

// As derivations are undone: branches of low order first, siblings in the order of the chain. For comparison.
#define TREE_METRIC_GENERATION 5

// Any branch whose parent is there, by chance. For comparison.
#define TREE_METRIC_RANDOM 6

// Area of a branch and of what it bears, for each branch that has to be drawn for it. The default.
#define TREE_METRIC_DENSITY 7

// As `TREE_METRIC_DENSITY`, with worths of your own in the place of areas.
#define TREE_METRIC_DENSITY_OF 8

// From 0 on a branch to `blend_most` at a distance of `blend_reach` and beyond.
#define TREE_BLEND_LINEAR 0

// `blend_share` at every distance but 0: particles meet branches at a fixed angle.
#define TREE_BLEND_CONSTANT 1

// Straight lines between the points of `blend_table`.
#define TREE_BLEND_TABLE 2

// What `blend_function` says.
#define TREE_BLEND_FUNCTION 3

// Cameras: base, height and scale of each view.
#define TREE_PHOTO_STAGE_VIEWS 0

// Main branches in each view.
#define TREE_PHOTO_STAGE_ATTRACTORS 1

// The density in space, and the way to the base through it.
#define TREE_PHOTO_STAGE_DENSITY 2

// The direction field of each view.
#define TREE_PHOTO_STAGE_FIELDS 3

// The particles' traces.
#define TREE_PHOTO_STAGE_FLOW 4

// Branches.
#define TREE_PHOTO_STAGE_WOOD 5

// Twigs and leaves.
#define TREE_PHOTO_STAGE_CROWN 6

// Livewire from points on the silhouette.
#define TREE_BRANCHES_LIVEWIRE 0

// Livewire from `seeds`.
#define TREE_BRANCHES_SEEDS 1

// `strokes`, as a person drew them.
#define TREE_BRANCHES_STROKES 2

// `graph`.
#define TREE_BRANCHES_GRAPH 3

// None: this view's branches are left to chance.
#define TREE_BRANCHES_NONE 4

// Predecessor of the root, and of nodes that no path leads to.
#define TREE_NO_NODE 4294967295u

// Anywhere in the volume.
#define TREE_PATH_PLACING_VOLUME 0

// Within one separation of the volume's surface.
#define TREE_PATH_PLACING_SURFACE 1

// The part of a ball round the root that lies within an angle of the axis.
#define TREE_PATH_SHAPE_SECTOR 0

// A cone that stands on the root and narrows outwards.
#define TREE_PATH_SHAPE_CONE 1

// A cone with its tip on the root that widens outwards.
#define TREE_PATH_SHAPE_INVERTED_CONE 2

// Any volume.
#define TREE_PATH_SHAPE_CUSTOM 3

// From the root of the graph before through the endpoint.
#define TREE_PATH_AXIS_OUTWARD 0

// Straight down.
#define TREE_PATH_AXIS_DOWN 1

// One direction for all.
#define TREE_PATH_AXIS_FIXED 2

// A random direction for each.
#define TREE_PATH_AXIS_RANDOM 3

// Through all levels.
#define TREE_PATH_LIFESPAN_FULL 0

// At each level a branch ends with the chance `lifespan_stop`; else the number of levels left, L, falls
// by a number drawn from 0 to L. Makes irregular, livelier trees.
#define TREE_PATH_LIFESPAN_RANDOM 1

// Rows for levels in a report: as many as there can be.
#define TREE_PATH_REPORT_LEVELS 17

// The foot is at the picture's bottom: the trunk may go on, and the tree be higher than it seems.
#define TREE_ALIGN_BASE_CROPPED 0

// The crown touches the picture's border: the tree may go on beyond it.
#define TREE_ALIGN_CROWN_CROPPED 1

// No bare trunk shows: the base is the lowest point near the middle.
#define TREE_ALIGN_NO_TRUNK 2

// `parts` parts apart from the tree are left out; `found` is their share of all that is covered.
#define TREE_ALIGN_LEFT_OUT 3

// The tree is in `parts` parts, as a crown in tufts is.
#define TREE_ALIGN_PARTS 4

// In `view` the crown begins at the share `found` of the tree's height, in the middle of all views at
// `usual`.
#define TREE_ALIGN_CROWN_BASE 5

// In `view` the crown is `found` of the tree's height wide, in the middle of all views `usual`.
#define TREE_ALIGN_CROWN_WIDTH 6

// What this version of the interface has no name for.
#define TREE_ALIGN_OTHER 7

// Rows for warnings in a report: more than one view can have.
#define TREE_ALIGN_WARNINGS 8

// A line with round ends.
#define TREE_MARK_LINE 0

// A line with a head at `to`.
#define TREE_MARK_ARROW 1

// A disc round `from`; `to` is not looked at.
#define TREE_MARK_DOT 2

// The pixels whose corners lie from `from` up to `to`; `width` is not looked at.
#define TREE_MARK_FILL 3

// It goes too.
#define TREE_CUT_OFF_DROP 0

// It is joined to the nearest point of the rest by a straight line.
#define TREE_CUT_OFF_RECONNECT 1

// Blue: right for green leaves.
#define TREE_SCREEN_BLUE 0

// Green: for autumn leaves and bare branches.
#define TREE_SCREEN_GREEN 1

// Certainly not the tree.
#define TREE_LEVEL_BACKGROUND 0

// To be found.
#define TREE_LEVEL_UNKNOWN 1

// Certainly the tree.
#define TREE_LEVEL_FOREGROUND 2

// In `tree_adapted_columns.died`: the node's branch lives.
#define TREE_PLASTIC_ALIVE 4294967295u

// A clear sky.
#define TREE_BACKDROP_SKY 0

// Light grey paper under soft white light.
#define TREE_BACKDROP_STUDIO 1

// It chooses its place so that the whole mesh is in the picture.
#define TREE_CAMERA_FRAMED 0

// It stands where it is told to.
#define TREE_CAMERA_PLACED 1

// Far things are smaller.
#define TREE_LENS_PERSPECTIVE 0

// Parallel projection; what lies behind the eye is not drawn.
#define TREE_LENS_ORTHOGRAPHIC 1

// Number of bins in `tree_concentration`.
#define TREE_CONCENTRATION_BINS 12

// A leaf.
#define TREE_LEVEL_OF_LEAF 4294967295u

// An open line: a trunk or a branch, from either end.
#define TREE_DRAWN_KIND_AXIS 0

// The outline of a crown, of a branch's foliage or of a leaf. Its first point is not repeated.
#define TREE_DRAWN_KIND_OUTLINE 1

// Levels of branches that `tree_silhouette_grown` counts, the trunk's included.
#define TREE_SILHOUETTE_LEVELS 16

// `count` points were not finite or absurdly far away, and were left out.
#define TREE_OUTLINE_POINTS_DROPPED 0

// `count` points repeated at once were left out.
#define TREE_OUTLINE_DUPLICATES_DROPPED 1

// Of `count` points `after` were kept.
#define TREE_OUTLINE_THINNED 2

// It was open, with close ends, and was closed straight over `gap` metres.
#define TREE_OUTLINE_CLOSED 3

// It was wide open, by `gap` metres, a `share` of its length, and was closed straight.
#define TREE_OUTLINE_WIDE_GAP_CLOSED 4

// It ran out and straight back at `count` corners, which were left out.
#define TREE_OUTLINE_SPIKES_DROPPED 5

// It crossed or touched itself; what it winds round was kept.
#define TREE_OUTLINE_CROSSING_UNDONE 6

// Of what it winds round only the largest part was kept: `count` others, a `share` of the area, were left out.
#define TREE_OUTLINE_PARTS_DROPPED 7

// It ran with the clock and was turned.
#define TREE_OUTLINE_TURNED 8

// Something else: `tree_outline_repairs_text` says what.
#define TREE_OUTLINE_OTHER 9

// Evenly over length and azimuth, without a pattern. The default.
#define TREE_ARRANGEMENT_SPREAD 0

// One at a node, each turned against the last by `angle`.
#define TREE_ARRANGEMENT_SPIRAL 1

// Two at a node, all pairs in one plane.
#define TREE_ARRANGEMENT_OPPOSITE 2

// Two at a node, each pair across the last.
#define TREE_ARRANGEMENT_DECUSSATE 3

// `per_node` at a node, each whorl turned against the last by `angle`.
#define TREE_ARRANGEMENT_WHORLED 4

// Two at a node, all in the horizontal plane, which lies at the azimuth `angle`.
#define TREE_ARRANGEMENT_HORIZONTAL 5

// Any other: `per_node` at a node, each node turned against the last by `angle`.
#define TREE_ARRANGEMENT_CUSTOM 6

// In place of a branch's id: the trunk, as a parent; none, as the source of a style. No branch has this id.
#define TREE_NO_BRANCH 0

// A bump of the outline.
#define TREE_BRANCH_OF_BUMP 0

// The outline was not covered there.
#define TREE_BRANCH_OF_COVERAGE 1

// A person drew it.
#define TREE_BRANCH_DRAWN 2

// `count` shapes outside all layers, or outside the groups of trees, were left out.
#define TREE_DRAWN_STRAY_SHAPES 0

// `count` open lines beside filled shapes were left out.
#define TREE_DRAWN_LINES_DROPPED 1

// A trunk drawn as an area became its middle line.
#define TREE_DRAWN_TRUNK_THINNED 2

// A shape as large as the drawing was left out as its background.
#define TREE_DRAWN_BACKGROUND_DROPPED 3

// `count` parts near the tree were joined to it.
#define TREE_DRAWN_PARTS_BRIDGED 4

// `count` parts far from the tree, or too small, a `share` of the area, were left out.
#define TREE_DRAWN_PARTS_DROPPED 5

// Holes, a `share` of the area, were filled.
#define TREE_DRAWN_HOLES_FILLED 6

// Gaps in a frayed crown were closed, the widest of `width` in units of the drawing.
#define TREE_DRAWN_GAPS_CLOSED 7

// No trunk was seen: the silhouette is all crown.
#define TREE_DRAWN_NO_TRUNK 8

// A tree of which nothing could be used was left out.
#define TREE_DRAWN_TREE_DROPPED 9

// Something else: `tree_outline_drawing_repairs_text` says what.
#define TREE_DRAWN_OTHER 10

// All siblings that were not drawn themselves.
#define TREE_TRANSFER_SIBLINGS 0

// Those of them on the same side of the axis.
#define TREE_TRANSFER_SIDE 1

// The siblings that are listed, drawn or not.
#define TREE_TRANSFER_ONLY 2

// None.
#define TREE_TRANSFER_NOBODY 3

// The horizon follows from ground points and sizes; trees drawn on about one height stand on one line. The default.
#define TREE_PERSPECTIVE_ESTIMATED 0

// The horizon is given.
#define TREE_PERSPECTIVE_HORIZON 1

// There is none: all trees stand on one line, their sizes are as drawn.
#define TREE_PERSPECTIVE_FLAT 2

// In place of a tree's number: no tree.
#define TREE_NO_TREE 4294967295u

// Parent of the root: no node.
#define TREE_NO_PARENT 4294967295u

// The child with the largest radius, by length to the tip where radii are equal. The default.
#define TREE_CONTINUATION_THICKEST 0

// The child with the longest path to a tip.
#define TREE_CONTINUATION_LONGEST 1

// The child that bends least from the segment below; at the root, the longest.
#define TREE_CONTINUATION_STRAIGHTEST 2

// +Z, as laser scanners and foresters have it: (x, y, z) becomes (x, z, -y). The default.
#define TREE_UP_Z 0

// +Y, as in this library.
#define TREE_UP_Y 1

// They stay 0, for example to be found by `tree_skeleton_with_rule`.
#define TREE_SWC_RADIUS_KEEP 0

// They go from the radius below to the thickest known radius above, in proportion to the path length.
// Where nothing is known above, the radius below is taken; where nothing is known below, the one above;
// where nothing is known at all, 0 stays.
#define TREE_SWC_RADIUS_INTERPOLATE 1

// Not known: name, alpha and shape decide.
#define TREE_HINT_AUTO 0

// Bark.
#define TREE_HINT_WOOD 1

// Leaves, needles, flowers, or cards of whole sprays.
#define TREE_HINT_LEAVES 2

// Neither: ground, pots, labels.
#define TREE_HINT_IGNORE 3

// Leaf widths in a report: those of the first kinds.
#define TREE_SKELETONIZE_LEAF_WIDTHS 256

// Bark.
#define TREE_CLASS_WOOD 0

// A card or a small thin surface: one leaf.
#define TREE_CLASS_LEAF 1

// A closed body of leaves.
#define TREE_CLASS_BLOB 2

// Not looked at.
#define TREE_CLASS_IGNORED 3

// The segment continues its parent's axis.
#define TREE_SKETCH_APICAL 4294967295u

// A straight line joins them, however far they are.
#define TREE_ISOLATED_BRIDGE 0

// Those beyond the reach are left out.
#define TREE_ISOLATED_DROP 1

// Those beyond the reach are an error.
#define TREE_ISOLATED_REFUSE 2

// `count` points that are not finite, or absurdly far away, were left out.
#define TREE_REPAIR_BAD_POINTS 0

// It has no length worth speaking of, and was left out.
#define TREE_REPAIR_EMPTY 1

// It was taken for the ground, and left out.
#define TREE_REPAIR_GROUND 2

// It was taken for a mark on the trunk's bark, and left out.
#define TREE_REPAIR_BARK_MARK 3

// It is a small mark that touches nothing, and was left out.
#define TREE_REPAIR_SPECK 4

// It shows roots below the ground: what is below was left out.
#define TREE_REPAIR_BELOW_GROUND 5

// It runs along the crown's outline, stroke `other`: that part is its ink, and was left out.
#define TREE_REPAIR_CROWN_INK 6

// It was not marked, and was taken to show `role`.
#define TREE_REPAIR_TAKEN_AS 7

// It shows the trunk and the crown in one go, and was cut at the corner between them.
#define TREE_REPAIR_CUT_AT_CORNER 8

// It is one side of the trunk and stroke `other` the other side: the line between them was taken.
#define TREE_REPAIR_MIDDLE_OF_SIDES 9

// It is an outline: its middle line was taken.
#define TREE_REPAIR_MIDDLE_OF_OUTLINE 10

// All of it runs along stroke `other`, and was merged into that.
#define TREE_REPAIR_MERGED 11

// A part of it runs along stroke `other`, and was merged into that.
#define TREE_REPAIR_MERGED_PARTLY 12

// It was drawn towards the base, and was turned round.
#define TREE_REPAIR_TURNED_ROUND 13

// It passes through where it joins, and was split there in two.
#define TREE_REPAIR_SPLIT 14

// It crosses stroke `other` a little: the end beyond it, `share` long, was cut off.
#define TREE_REPAIR_TRIMMED 15

// Its end was joined over a small gap of `share`.
#define TREE_REPAIR_SNAPPED 16

// It was joined by a straight line over a gap of `share`.
#define TREE_REPAIR_BRIDGED 17

// It begins on the ground beside the base, `share` away, and was joined to the base.
#define TREE_REPAIR_SECOND_ROOT 18

// It is `share` away from the rest, and was left out.
#define TREE_REPAIR_ISOLATED 19

// There are no branches: a straight trunk was imagined below this crown.
#define TREE_REPAIR_IMAGINED_TRUNK 20

// Something else: `tree_plan_repairs_text` says what.
#define TREE_REPAIR_OTHER 21

// It shows the flare of a root at the trunk's foot, which was left out.
#define TREE_REPAIR_ROOT_FLARE 22

// No branch reaches into the crown, stroke `other`: this one was drawn on.
#define TREE_REPAIR_DRAWN_ON 23

// Of stroke `stroke`, `count` points were not finite or absurdly far away, and were left out.
#define TREE_CROWN_POINTS_DROPPED 0

// Stroke `stroke` has no length, and was left out.
#define TREE_CROWN_STROKE_DROPPED 1

// Stroke `stroke` is open and lies inside a closed one: it is a detail, and was left out.
#define TREE_CROWN_DETAIL_DROPPED 2

// Stroke `stroke`, or several joined ones of which it is the first, was closed straight over `gap` metres.
#define TREE_CROWN_CLOSED 3

// Strokes were joined at `count` places where their ends were close.
#define TREE_CROWN_JOINED 4

// A wide gap of `gap` metres between ends was closed; `round_branches` says whether round branches in it.
#define TREE_CROWN_GAP_CLOSED 5

// Loop `stroke`, in the order they were closed, crossed itself; what it winds round was kept.
#define TREE_CROWN_CROSSING_UNDONE 6

// `count` loops that overlap were united, and `after` polygons are left of them.
#define TREE_CROWN_UNITED 7

// `count` loops inside others are details, and were left out.
#define TREE_CROWN_NESTED_DROPPED 8

// `count` tiny parts were left out.
#define TREE_CROWN_CRUMBS_DROPPED 9

// A `share` of the branches' points lies outside.
#define TREE_CROWN_BRANCHES_OUTSIDE 10

// No branch touches the crown.
#define TREE_CROWN_NO_BRANCH_INSIDE 11

// Something else: `tree_crown_repairs_text` says what.
#define TREE_CROWN_OTHER 12

// Not said: cleaning is to find out.
#define TREE_ROLE_UNKNOWN 0

// The trunk. It begins the tree.
#define TREE_ROLE_TRUNK 1

// A branch.
#define TREE_ROLE_BRANCH 2

// The crown's outline, or a piece of it.
#define TREE_ROLE_CROWN 3

// The seed of the trees that the built-in templates were measured by.
#define TREE_EXEMPLAR_SEED 1

// Number of distances in a footprint. Direction 0 is +x, then they turn against the clock where y goes up.
#define TREE_FOOTPRINT_DIRECTIONS 64

// Bottom-up inference.
#define TREE_SKETCH_STEP_BOTTOM_UP 0

// Passes of ICM.
#define TREE_SKETCH_STEP_ICM 1

// Branches swung to the other side.
#define TREE_SKETCH_STEP_SWING 2

// Crossing branches were moved apart.
#define TREE_SKETCH_STEP_SEPARATE 3

// Ω was estimated.
#define TREE_SKETCH_STEP_OMEGA 4

// What is wound round. The default, as in SVG.
#define TREE_FILL_NON_ZERO 0

// What is wound round an odd number of times.
#define TREE_FILL_EVEN_ODD 1

// Orders of axes that a `tree_sketch_omega` tells apart.
#define TREE_SKETCH_ORDERS 8

// Strokes joined, the crown closed.
#define TREE_SKETCH_STAGE_CLEAN 0

// Templates compared.
#define TREE_SKETCH_STAGE_SELECT 1

// Depths inferred.
#define TREE_SKETCH_STAGE_INFER 2

// Branches propagated.
#define TREE_SKETCH_STAGE_PROPAGATE 3

// Wood with radii.
#define TREE_SKETCH_STAGE_WOOD 4

// Twigs and leaves.
#define TREE_SKETCH_STAGE_TREE 5

// Number of shares in `directions` of a `tree_template_side`.
#define TREE_DIRECTION_BINS 12

// Version of the ABI that this header describes. A library with the same number has every function and
// struct of this header; additions do not change it.
#define TREE_ABI_VERSION 1

// None of those below: newer than this header.
#define TREE_SOLID_OTHER 0

// A ball.
#define TREE_SOLID_SPHERE 1

// An axis-aligned ellipsoid.
#define TREE_SOLID_ELLIPSOID 2

// A round cylinder.
#define TREE_SOLID_CYLINDER 3

// A cone, whole or truncated.
#define TREE_SOLID_FRUSTUM 4

// All within a distance of a segment.
#define TREE_SOLID_CAPSULE 5

// An axis-aligned box.
#define TREE_SOLID_BOX 6

// All on one side of a plane.
#define TREE_SOLID_HALF_SPACE 7

// The points of a ball within an angle of an axis.
#define TREE_SOLID_SECTOR 8

// What a profile sweeps.
#define TREE_SOLID_REVOLUTION 9

// What a closed mesh bounds.
#define TREE_SOLID_MESH 10

// What lies in any part.
#define TREE_SOLID_UNION 11

// What lies in all parts.
#define TREE_SOLID_INTERSECTION 12

// What lies in part 0 but not in part 1.
#define TREE_SOLID_DIFFERENCE 13

// Part 0, transformed.
#define TREE_SOLID_TRANSFORMED 14

// A tree of a scene as it was when it was asked for, with branchlets and leaves, and what became of the input's nodes.
typedef struct tree_adapted tree_adapted;

// The branches of a chain of modules or of a skeleton, with their modules, lengths and children (the paper's *tree
// abstract data type*). Branch 0 is the root, and parents come before their children.
typedef struct tree_adt tree_adt;

// Cameras for several views of one tree.
typedef struct tree_aligned tree_aligned;

// Places that branches found.
typedef struct tree_arranged tree_arranged;

// Main branches in one picture, as a forest whose roots are at the tree's base.
typedef struct tree_attractor tree_attractor;

// All axes of a skeleton. An axis starts where it leaves another and runs to a tip.
typedef struct tree_axes tree_axes;

// Which pixels a mesh covers: one bit for each. A bit is set where a triangle covers the middle of the pixel
// and the texture's alpha there is drawn. (`tree_mask` tells how much of each pixel is covered; this one is
// for comparing, and fast.)
typedef struct tree_bits tree_bits;

// The bumps of an outline.
typedef struct tree_bumps tree_bumps;

// A file in memory.
typedef struct tree_bytes tree_bytes;

// A switch that cancels the calls it was given to.
typedef struct tree_cancel tree_cancel;

// Collision capsules of a tree.
typedef struct tree_capsules tree_capsules;

// What is drawn of a tree's leaves, and which boxes are open: one for each instance, kept from frame to frame.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it is `TREE_ERROR_ORDER`.
typedef struct tree_card_choice tree_card_choice;

// Six diagonal planes for each box, with pictures of its leaves, in two atlases (Lluch et al. 2010, 4.2.2).
typedef struct tree_cards tree_cards;

// The voxels that a tree may fill, and what they begin with.
typedef struct tree_carved tree_carved;

// A cloud of points, as laser scanners give it.
typedef struct tree_cloud tree_cloud;

// Triangles of a surface that cross each other.
typedef struct tree_crossings tree_crossings;

// A crown: polygons in the plan, and the solid they stand for. At every height each stretch of the inside is swept to
// a circle (or an ellipse, by the depth) about its own middle.
typedef struct tree_crown tree_crown;

// Directions on a grid of cells over a picture.
typedef struct tree_direction_field tree_direction_field;

// A drawing: strokes in the order they were drawn, in any units, y downwards as on screens and in SVG.
typedef struct tree_drawing tree_drawing;

// Drawings of one file.
typedef struct tree_drawings tree_drawings;

// Pairs of nodes that are changed into one another: all others are deleted or inserted.
typedef struct tree_edit_pairs tree_edit_pairs;

// A rooted tree with a weight for every node, to be compared with many others: a skeleton, perhaps with runs or axes
// as one node each, or any tree of your own.
typedef struct tree_edit_tree tree_edit_tree;

// The elements of a mesh: what is dropped and scaled as one, such as a leaf or a card. There is always at
// least one.
typedef struct tree_elements tree_elements;

// The equations A x = b of a density: for each ray the densities x of the voxels on it, times its length in
// them in metres, add up to -ln of the transparency seen. Wanted is the x >= 0 with the least
// |A x - b|^2 + lambda^2 |x / weights|^2.
typedef struct tree_equations tree_equations;

// The factor graph of a sketch (Neubert 2012, section 4.5.1): what any depths and labels are worth. Segments are
// numbered generation by generation, as in a `tree_inferred` of the same plan.
typedef struct tree_factor_graph tree_factor_graph;

// Leaves found in a mesh, and their kinds.
typedef struct tree_found_leaves tree_found_leaves;

// Columns for a glTF file.
typedef struct tree_gltf_attributes tree_gltf_attributes;

// Leaves of a tree, one small mesh for each kind and where its copies stand.
typedef struct tree_gltf_leaves tree_gltf_leaves;

// An L-system's grammar: alphabet, axiom, productions, and rules of decomposition and interpretation.
typedef struct tree_grammar tree_grammar;

// An undirected graph with costs.
typedef struct tree_graph tree_graph;

// Nodes strewn in a volume, ready to be linked.
typedef struct tree_graph_nodes tree_graph_nodes;

// Numbers on a regular grid of cubic voxels. The number of a voxel is that at its centre. Densities are
// optical depth per metre: looking through d metres of density x shows a matte of 1 - exp(-x d).
typedef struct tree_grid tree_grid;

// A grown tree, the ages of its nodes, and what happened in each iteration.
typedef struct tree_grown tree_grown;

// Trees that compete for the same light or space, in the middle of their growth.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work on it,
// from a progress callback too, is `TREE_ERROR_ORDER`. The trees it hands out do not change with it.
typedef struct tree_growth tree_growth;

// A surface around a plant: closed, facing outwards, in several pieces where points are far apart.
typedef struct tree_hull tree_hull;

// A tree for all distances: its wood has levels that are prefixes, its leaves are drawn as they are or by pictures of
// boxes of them.
typedef struct tree_hybrid tree_hybrid;

// What is drawn of an instance of a hybrid model, kept from frame to frame. It keeps the model alive.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it is `TREE_ERROR_ORDER`.
typedef struct tree_hybrid_choice tree_hybrid_choice;

// A sketch in space: what was inferred of it.
typedef struct tree_inferred tree_inferred;

// Boxes along the branches of a tree (Lluch et al. 2010, 4.2.1), that of the whole tree first: which leaves are seen
// as one, and an order of the leaves in which those of each box are one range. Parents come before their children,
// which lie side by side.
typedef struct tree_leaf_boxes tree_leaf_boxes;

// The mesh of one leaf: one sheet, without petiole. For engines that instance leaves themselves, and to
// see how much of its triangles is visible.
typedef struct tree_leaf_model tree_leaf_model;

// A drawn leaf in its own plane: base at the origin, tip at (0, 1), in triangles. Multiplied by the leaf's length it is in
// metres.
typedef struct tree_leaf_outline tree_leaf_outline;

// Lines of text, for people: warnings, mostly. There may be none.
typedef struct tree_lines tree_lines;

// Best scale and quality of a model for each share of geometry: rows with rising lambda, the last of which
// is the full model.
typedef struct tree_lod_table tree_lod_table;

// What a species looks like: a material for the bark, and a leaf look for each leaf kind.
typedef struct tree_look tree_look;

// How much of each pixel a mesh covers.
typedef struct tree_mask tree_mask;

// How much of each pixel of a photograph the tree covers, 0 (nothing) to 1 (all).
typedef struct tree_matte tree_matte;

// Surfaces with their materials, and the branches that move in the wind.
typedef struct tree_mesh tree_mesh;

// A sum of metaballs (Neubert 2012, 7.3.1): every point adds `(1 - (distance / radius)^2)^2` to the places within
// its radius. 1 or more at each point, 0 far from all.
typedef struct tree_metaballs tree_metaballs;

// The middle lines of a filled area.
typedef struct tree_midlines tree_midlines;

// A picture and its smaller levels, for a texture that is alpha-tested.
typedef struct tree_mips tree_mips;

// The modules of a chain, most relevant branches first. Its first levels are a prefix, and each prefix that ends with a
// level is drawn by a turtle that knows `SAVE` and `RESTORE`.
typedef struct tree_multi_chain tree_multi_chain;

// Tubes and leaves in the order of their paths: the mesh of a level is a prefix of each index buffer, and a shader lets
// the path that comes next grow out of its fork.
typedef struct tree_multi_mesh tree_multi_mesh;

// All branches, cut into paths: each begins at the root, or stems from a path before it. The first few show the
// tree's structure best.
typedef struct tree_multi_paths tree_multi_paths;

// A tree with its nodes and leaves sorted path by path: its first levels are its coarser forms, and a level is no more
// than a number. It is as large as the tree, and 8 bytes a level more.
typedef struct tree_multires tree_multires;

// An octahedral impostor: a whole tree as pictures from all sides, with depths (Brucks 2018), for trees far away.
typedef struct tree_octahedral tree_octahedral;

// A closed outline in metres, x to the right, y up: a polygon without crossings, against the clock.
typedef struct tree_outline tree_outline;

// A drawing of outlines: the strokes of one tree or several, each of a level. Nothing is scaled: coordinates are those of
// the drawing or pixels, y downwards.
typedef struct tree_outline_drawing tree_outline_drawing;

// A tree in the plane, level in level: trunk and crown, branches with the outlines of their foliage, their own branches
// where those were drawn, the leaf. In metres, x to the right, y up, the trunk's base near the origin.
typedef struct tree_outline_plan tree_outline_plan;

// A surface in the axes and the layout of an engine.
typedef struct tree_packed tree_packed;

// A photograph: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
typedef struct tree_photo tree_photo;

// A tree in the making: photographs, parameters, and what has been made of them so far.
//
// Every stage can be asked for by itself. What is there is kept, so that a change redoes only what comes
// after it: painting density keeps the branches found in the pictures, another seed keeps density and
// fields. A call that fails or is cancelled leaves the session as it was, with the stages done by then.
//
// It is an object that changes: do not use it from two threads at once. A call that
// comes while another is at work on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands
// out is copied, does not change with it, and outlives it.
typedef struct tree_photo_session tree_photo_session;

// A picture: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
typedef struct tree_picture tree_picture;

// Connected pieces of wood, each followed from its base.
typedef struct tree_pieces tree_pieces;

// A cleaned drawing: its branches as one tree in the plane, the lines of its crown, and what was done to its
// strokes.
typedef struct tree_plan tree_plan;

// A tree, read so that it can react: its main branches with the seasons in which they grew, its leaf clusters in every
// season and the light they had, what its branches would be without tropisms, and on how little light they live. Made
// once, and planted as often as you like.
typedef struct tree_plastic tree_plastic;

// The leaf clusters of a tree at one time: a copy.
typedef struct tree_plastic_clusters tree_plastic_clusters;

// Trees, obstacles and a sky. Edits are checked at once, and leave the scene as it was where they are refused;
// `tree_plastic_scene_update` works out what all edits since the last one mean, and no more than that.
//
// What the trees look like depends on the scene alone, not on how it came about: an obstacle that is moved away leaves
// no trace. Trees and obstacles are named by ids, which are not used again after they are removed.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work on it,
// from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it, and outlives
// it; ids that are viewed stay until the next edit or update.
typedef struct tree_plastic_scene tree_plastic_scene;

// Threads that do the work of the calls it is given to (`tree_control.pool`). What calls make does not
// depend on it. A plug-in that may be unloaded gives every call a pool and frees it before that: the
// threads of calls without a pool never end.
typedef struct tree_pool tree_pool;

// A drawn profile: radius over height, from the ground up.
typedef struct tree_profile tree_profile;

// A mesh whose foliage can be drawn at any level: windows of its index buffers (Neubert 2012, chapter 7).
typedef struct tree_pruned tree_pruned;

// A closed surface round an axis, through outlines in planes through it: how far a branch reaches at any azimuth. Its frame
// has y along the straight span of the axis from its start, and r across.
typedef struct tree_revolved tree_revolved;

// Numbers of rows: for each node of a skeleton that was made of another the node there that it comes from,
// or the tips of a graph; for each row of a tree with levels the row of the tree it was made of.
typedef struct tree_rows tree_rows;

// The trees of a cloud of points.
typedef struct tree_scanned tree_scanned;

// Tree models, and where they stand (Neubert 2012, 7.2.5 and 7.4). Make one `tree_scene_state` for each view of it.
// In each frame `tree_scene_state_select` finds what is drawn and how finely, and `tree_scene_state_draws` or
// `tree_scene_state_batches` write it into your own buffers; neither takes memory.
//
// It is an object that changes, in `tree_scene_set_instances` alone: a call that comes while that one is at
// work, or the other way round, is `TREE_ERROR_ORDER`. Any number of threads may select in it at once, each
// with a state of its own.
typedef struct tree_scene tree_scene;

// Levels of a pruned model, for a `tree_scene_model`.
typedef struct tree_scene_levels tree_scene_levels;

// What one view of a scene (a camera, or a cascade of a shadow map) remembers from frame to frame, and all the
// room that a frame needs.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it is `TREE_ERROR_ORDER`.
typedef struct tree_scene_state tree_scene_state;

// The triangles of a mesh, welded and sorted into connected components, each of which is wood, a leaf, a
// body of leaves or nothing. It holds copies of the parts.
typedef struct tree_separation tree_separation;

// What an edit of a `tree_silhouette_session` changed.
typedef struct tree_silhouette_change tree_silhouette_change;

// A tree being drawn: trunk, crown, outlines of branches, leaf. Strokes are in metres, y up, the trunk's base near
// the origin. The plan in the plane is ready after each edit; the tree in space is made when it is asked for.
//
// Branches are named by ids, which are above 0 and stay for as long as the branch is there. An edit is done whole or not
// at all, and can be undone.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
// and outlives it.
typedef struct tree_silhouette_session tree_silhouette_session;

// Branches as a rooted tree of nodes with radii.
typedef struct tree_skeleton tree_skeleton;

// Branch segments from fork to fork, parents first: those of a sketch, or those with what grew on them
// (`tree_sketch_branches_propagate`).
typedef struct tree_sketch_branches tree_sketch_branches;

// A sketch on its way to a tree: a drawing, parameters, templates, and what has been made of them so far.
//
// Every stage can be asked for by itself and is done when its result, or that of a later one, is first asked for.
// Edits keep what does not depend on them: once depths have been inferred, strokes can be added and erased and
// depths moved, and those of all other branches stay, as do scale, template, Ω and what grew on other branches.
// `tree_sketch_session_infer_anew` forgets all of that. A call that fails or is cancelled leaves the session as it
// was, with the stages done by then.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
// and outlives it.
typedef struct tree_sketch_session tree_sketch_session;

// Trees that grew of one drawing: at least one.
typedef struct tree_stand tree_stand;

// Takes the bytes of a stream as they arrive, and gives the tree that they make so far.
//
// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
// on it is `TREE_ERROR_ORDER`.
typedef struct tree_stream_reader tree_stream_reader;

// Strokes read from a drawing, a session's branches as strokes, or outlines.
typedef struct tree_strokes tree_strokes;

// What an SWC file held: a skeleton, and what a skeleton has no column for.
typedef struct tree_swc tree_swc;

// Kinds of tree to guide a reconstruction by.
typedef struct tree_templates tree_templates;

// A picture, shared by materials and meshes: RGBA, 8 bits, sRGB, straight alpha.
typedef struct tree_texture tree_texture;

// Triangles that elements are drawn with: the full model first, then with fewer and fewer triangles of nearly the
// same outlines. All are of the model's own vertices.
typedef struct tree_tiers tree_tiers;

// What particles left behind: traces that join on their way to the base.
typedef struct tree_traces tree_traces;

// A whole tree: skeleton, leaves and species. Every leaf stands on a node that exists and has a kind
// that exists.
typedef struct tree_tree tree_tree;

// What is known of each pixel of a photograph.
typedef struct tree_trimap tree_trimap;

// What a turtle drew beside the tree: filled polygons; and the symbols that said nothing to it.
typedef struct tree_turtle_trace tree_turtle_trace;

// A tree as a base mesh and a few unique twigs, set down many times: at a tenth of its memory and less.
typedef struct tree_twigs tree_twigs;

// What a layout holds of each vertex, back in our axes, metres and winding.
typedef struct tree_unpacked tree_unpacked;

// A solid, or a combination of solids. Plain solids contain their surface; revolutions and meshes
// contain one side of it, so that solids set side by side share no point there.
typedef struct tree_volume tree_volume;

// The way to the base from everywhere in a density.
typedef struct tree_way tree_way;

// The branches of a skeleton, as the wind sees them.
typedef struct tree_wind_branches tree_wind_branches;

// A string of modules with their parameters, such as `F(1)[+(30)F(0.5)]`, and the alphabet of their kinds.
typedef struct tree_word tree_word;

// What a function says of itself: `TREE_OK`, or one of the `TREE_ERROR_` codes. New codes may be
// added: treat those you do not know as errors.
typedef int32_t tree_status;

// Which rule gives branches their radii: one of the `TREE_RADII_` constants.
typedef uint32_t tree_radius_kind;

// Where the number of strands comes from: one of the `TREE_STRANDS_` constants.
typedef uint32_t tree_strand_count;

// How the radii of a whole skeleton are found. Begin with `tree_radius_rule_init`. No rule makes a
// branch thicker than the one below.
typedef struct tree_radius_rule {
    // `sizeof(tree_radius_rule)`.
    size_t struct_size;
    // `TREE_STRANDS_BY_ANGLE`: strands at the base, from the number of tips to 2⁵³. No default: 0,
    // which is refused.
    uint64_t strand_base;
    // Which rule. Default `TREE_RADII_PIPE`.
    tree_radius_kind kind;
    // Pipe: Δ in r₀^Δ = Σ rᵢ^Δ, 1 to 10. Default 2.49, Murray's; da Vinci's is 2, Mandelbrot's 8/3. A
    // larger one makes the trunk thinner for the same tips.
    float exponent;
    // Pipe: radius of every tip in metres, 1e-6 to 100. Default 0.002. With a `trunk_radius` only its
    // proportion to `taper` matters.
    float tip_radius;
    // Pipe: how much the radius grows per metre towards the base, 0 to 1. Default 0.002: a bare shoot
    // of one metre is twice as thick at its base as at its tip.
    float taper;
    // Pipe: radius of the root node in metres, 1e-6 to 100: all radii, those of tips too, are
    // multiplied by the one factor that makes it so. Default 0: the tips decide.
    float trunk_radius;
    // Tip distance: radius on the trunk one metre from the tip, in metres, 1e-6 to 100. Default 0.05.
    float scale;
    // Tip distance: the power of the distance, 0 to 10. Default 0.3. The larger, the quicker branches
    // taper.
    float zeta;
    // Tip distance: smallest radius of any node in metres, 0 to 100. Default 0.001. With 0 a branch
    // ends in a point.
    float min_radius;
    // Strands: diameter of a branch of one strand in metres, 1e-6 to 100; one of S strands has √S
    // times that. Default 0.004.
    float strand_diameter;
    // Strands: where their number comes from. Default `TREE_STRANDS_PER_TIP`.
    tree_strand_count strand_count;
} tree_radius_rule;

// Told how far a call has come: what is being done (UTF-8, NUL at the end, valid during the call) and
// the share of the whole that is done, 0 to 1. Returns 0 to go on, anything else to cancel. Called from
// whichever thread does the work, one call at a time for each call of the library; must not unwind.
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
    // Modules of a derived L-system word. Default 100 million.
    uint64_t modules;
    // Pairs of nodes kept while two trees are compared. Default 150 million.
    uint64_t pairs;
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

// What an edit costs, finite and 0 or more: changing node `first` of the first tree into node `second` of the second;
// deleting `first` where `second` is `TREE_NO_PARENT`; inserting `second` where `first` is. Called from one thread at
// a time, once for each pair; must not unwind.
typedef double (*tree_edit_cost_fn)(void *user, uint32_t first, uint32_t second);

// What edits cost. Begin with `tree_edit_costs_init`. For a metric, changing costs at most deleting plus inserting, is
// symmetric, and obeys the triangle inequality.
typedef struct tree_edit_costs {
    // `sizeof(tree_edit_costs)`.
    size_t struct_size;
    // Costs of single edits. Default NULL: deleting and inserting cost the weight, changing the difference of the
    // weights.
    tree_edit_cost_fn cost;
    // Handed to `cost`.
    void *user;
} tree_edit_costs;

// Two nodes that are changed into one another.
typedef struct tree_edit_pair {
    // A node of the first tree.
    uint32_t first;
    // A node of the second tree.
    uint32_t second;
} tree_edit_pair;

// What a node weighs, the price of deleting or inserting it: one of the `TREE_EDIT_WEIGHT_` constants.
typedef uint32_t tree_edit_weight;

// What becomes one node before trees are compared: one of the `TREE_EDIT_REDUCTION_` constants.
typedef uint32_t tree_edit_reduction;

// How trees are compared. Begin with `tree_edit_params_init`.
typedef struct tree_edit_params {
    // `sizeof(tree_edit_params)`.
    size_t struct_size;
    // What a node weighs. Default `TREE_EDIT_WEIGHT_RADIUS`.
    tree_edit_weight weight;
    // What becomes one node. Default `TREE_EDIT_REDUCTION_RUNS`.
    tree_edit_reduction reduction;
} tree_edit_params;

// How far apart two trees are.
typedef struct tree_edit_distance {
    // `sizeof(tree_edit_distance)`.
    size_t struct_size;
    // The least cost, in the unit of the weights or of your own costs.
    double value;
    // 2 d / (a + b + d) for the weights a and b of the trees and the cost d, 0 to 1: 0 for equal trees, 1 where nothing
    // of one is left in the other. A metric, too.
    double normalized;
    // What deleting the first tree and what inserting the second costs.
    double weights[2];
    // Nodes compared, after the reduction.
    uint64_t n_nodes[2];
} tree_edit_distance;

// A tree that is compared, in columns: as input, or as a view.
typedef struct tree_edit_columns {
    // `sizeof(tree_edit_columns)`.
    size_t struct_size;
    // Number of nodes, at least 1.
    size_t n_nodes;
    // One for each node: its parent, which comes before it; `TREE_NO_PARENT` for node 0 alone.
    const uint32_t *parents;
    // One for each node: its weight, finite and 0 or more.
    const double *weights;
    // One for each node: the uppermost of the skeleton's nodes that it stands for; of a tree of columns, the node itself.
    // Not looked at as input.
    const uint32_t *nodes;
} tree_edit_columns;

// What follows from a row of the table of branches.
typedef struct tree_branch_motion {
    // `sizeof(tree_branch_motion)`.
    size_t struct_size;
    // Share of the wind's full turn that it makes, 0 to 1.
    float give;
    // Its lowest natural frequency in hertz, as a bare, clamped, uniform rod of green wood; leaves make
    // it slower, taper faster. Infinite for a branch without length.
    float frequency;
    // The direction it swings in: a unit vector square to the axis, another one for each phase.
    float swing[3];
    // 0.
    uint32_t reserved;
} tree_branch_motion;

// Which child continues the axis at a fork: one of the `TREE_CONTINUATION_` constants. Ties go to the
// child with the lower number.
typedef uint32_t tree_continuation;

// A branch as the wind sees it: a rod that turns about its pivot, carried by its parent. Has no
// `struct_size`: it is a row of a table, and never changes.
typedef struct tree_wind_branch {
    // The branch that carries this one; itself for the trunk. Parents come first.
    uint32_t parent;
    // 0 for the trunk, one more than the parent otherwise.
    uint32_t level;
    // Where it is attached: the point it turns about, in metres.
    float pivot[3];
    // Unit vector from pivot to tip.
    float axis[3];
    // Length along its bends in metres.
    float length;
    // Radius at the base in metres.
    float radius;
    // Distance from the pivot, in metres, up to which wood moves with the parent.
    float collar;
    // Where in the swing it starts, 0 to 1: so that branches do not move in step.
    float phase;
    // 1 does not give at all, 0 hangs in the wind: 1 / (1 + (length / radius / 100)³).
    float stiffness;
} tree_wind_branch;

// How capsules are made. Begin with `tree_capsule_params_init`.
typedef struct tree_capsule_params {
    // `sizeof(tree_capsule_params)`.
    size_t struct_size;
    // Most capsules, 1 to 4096. Default 32.
    uint32_t max_count;
    // Wood thinner than this is passed over, in metres, 0 to 10. Default 0.05. When nothing is as
    // thick, half the radius of the thickest wood is taken instead, so that saplings collide as well.
    float min_radius;
    // Share of the volume of the other wood that must lie inside, 0 to 1. Default 0.95.
    float share;
    // Which child goes on at a fork. Default `TREE_CONTINUATION_THICKEST`.
    tree_continuation continuation;
} tree_capsule_params;

// How well capsules fit.
typedef struct tree_capsule_report {
    // `sizeof(tree_capsule_report)`.
    size_t struct_size;
    // Number of capsules.
    uint64_t n_capsules;
    // Volume of the wood above the radius, in cubic metres: the sum of its frusta.
    double volume;
    // Share of that volume that lies in a capsule, 0 to 1, as measured; 1 when there is no wood.
    double held;
    // Volume of the capsules, those that overlap counted twice, over that of the wood they hold; 1 would
    // be perfect. 0 when there is no wood.
    double bulk;
    // The radius above which wood counted, in metres.
    float min_radius;
    // Whether `held` reaches the share asked for.
    uint32_t is_enough;
} tree_capsule_report;

// A cylinder with round ends.
typedef struct tree_capsule {
    // Middle of one end, in metres.
    float a[3];
    // Middle of the other end.
    float b[3];
    // Radius in metres.
    float radius;
} tree_capsule;

// Whose axes: one of the `TREE_CONVENTION_` constants.
//
// | | hands | up | unit | front faces | v | from ours |
// |---|---|---|---|---|---|---|
// | glTF, Bevy, three.js | right | Y | m | counter-clockwise | down | as it is |
// | Godot 4 | right | Y | m | clockwise | down | as it is |
// | Unity | left | Y | m | clockwise | up | (-x, y, z) |
// | Unreal | left | Z | cm | counter-clockwise | down | 100 (x, z, y) |
// | Blender | right | Z | m | counter-clockwise | up | (x, -z, y) |
//
// Clockwise or not is meant as seen on the screen, from outside.
typedef uint32_t tree_convention;

// What a convention says.
typedef struct tree_convention_traits {
    // `sizeof(tree_convention_traits)`.
    size_t struct_size;
    // Length units in one metre.
    float unit;
    // Whether the axes form a left hand.
    uint32_t is_left_handed;
    // Whether front faces run clockwise, so that triangles must be turned.
    uint32_t is_clockwise;
    // Whether texture v runs upwards.
    uint32_t is_v_up;
} tree_convention_traits;

// Which way columns are converted: one of the `TREE_CONVERT_` constants.
typedef uint32_t tree_convert;

// How a surface is packed: one of the `TREE_LAYOUT_` constants. Whatever column a surface lacks is
// filled: tangents square to the normal, no light map, no occlusion.
typedef uint32_t tree_layout;

// A text in UTF-8. As input, `len` may be `TREE_NUL_TERMINATED` and `data` NULL for an empty text. As
// output it is borrowed, and no NUL byte need follow it.
typedef struct tree_str {
    // The first byte.
    const char *data;
    // Number of bytes.
    size_t len;
} tree_str;

// What the numbers of a stream are: one of the `TREE_NUMBER_` constants.
typedef uint32_t tree_number;

// One attribute of all vertices. Rows of an array; the array belongs to a `tree_packed`.
typedef struct tree_stream {
    // The engine's name for it.
    struct tree_str name;
    // `components` numbers for each vertex, tightly packed, in the machine's order of bytes.
    const void *data;
    // Number of bytes.
    size_t n_bytes;
    // Numbers of one vertex, 1 to 4.
    uint32_t components;
    // What the numbers are.
    tree_number number;
} tree_stream;

// A view of a `tree_packed`.
typedef struct tree_packed_columns {
    // `sizeof(tree_packed_columns)`.
    size_t struct_size;
    // The layout.
    tree_layout layout;
    // Whose axes the numbers are in.
    tree_convention convention;
    // Number of vertices.
    size_t n_vertices;
    // Bytes of one vertex, all streams together.
    size_t vertex_bytes;
    // The attributes, each with a row for every vertex. None for `TREE_LAYOUT_VERTEX`.
    const struct tree_stream *streams;
    // Number of streams.
    size_t n_streams;
    // Three for each triangle, wound as the engine has its front faces: `uint16_t` or `uint32_t`.
    const void *indices;
    // Number of indices.
    size_t n_indices;
    // Bytes of one index: 2 for at most 65,535 vertices, so that no index is 0xFFFF, or 4.
    uint32_t index_bytes;
    // `TREE_LAYOUT_SPEEDTREE9`: `_ST_BranchStretchLimits`, the longest free lengths of branches 1 and 2
    // in metres, the same for all surfaces of a mesh. Else 0.
    float stretch_limits[2];
    // 0.
    uint32_t reserved;
} tree_packed_columns;

// The textures of `TREE_LAYOUT_PIVOT_PAINTER`, the same for all surfaces of a mesh. Elements lie in rows
// from the top left, as their branches do in the table; the trunk is its own parent.
typedef struct tree_pivots {
    // `sizeof(tree_pivots)`.
    size_t struct_size;
    // Width in texels, a power of two.
    uint32_t width;
    // Height in texels, a power of two.
    uint32_t height;
    // Four floats for each texel, row by row from the top: the pivot in centimetres, in Unreal's axes,
    // and the parent's number as a float whose half has the bits number + 1024.
    const float *position_and_index;
    // The same as halves; the parents' numbers are exact in them too.
    const uint16_t *position_and_index_half;
    // Four bytes for each texel: (axis + 1) / 2, and extent / 2048 cm.
    const uint8_t *axis_and_extent;
    // One for each branch of the mesh: its element, or that of the branch it became part of.
    const uint32_t *element_of;
    // Number of branches.
    size_t n_branches;
    // Texels in use.
    size_t n_elements;
    // Branches that became part of the one that carries them, since they lie too deep.
    size_t n_merged;
    // Levels of the mesh.
    uint32_t levels;
    // Levels that are left, at most 4: as many as Epic's material functions follow.
    uint32_t kept_levels;
} tree_pivots;

// A texel of the pivot textures, read back as the shader does, in our axes.
typedef struct tree_pivot_element {
    // `sizeof(tree_pivot_element)`.
    size_t struct_size;
    // The element that carries it; itself for the trunk.
    uint32_t parent;
    // Pivot in metres.
    float pivot[3];
    // Axis, a unit vector.
    float axis[3];
    // Length in metres, 0.08 to 20.48.
    float extent;
} tree_pivot_element;

// A view of a `tree_unpacked`. A column is NULL when the layout has no place for it.
typedef struct tree_unpacked_columns {
    // `sizeof(tree_unpacked_columns)`.
    size_t struct_size;
    // Number of vertices.
    size_t n_vertices;
    // Three floats for each vertex: positions in metres.
    const float *positions;
    // Three floats for each vertex: normals.
    const float *normals;
    // Four floats for each vertex: tangents, in the fourth the sign.
    const float *tangents;
    // Two floats for each vertex: texture coordinates.
    const float *uvs;
    // Two floats for each vertex: light-map coordinates.
    const float *uvs2;
    // Three for each triangle.
    const uint32_t *indices;
    // Number of indices.
    size_t n_indices;
    // Ambient occlusion.
    const float *occlusion;
    // The branch, its number in the table; for `TREE_LAYOUT_PIVOT_PAINTER` its element.
    const uint32_t *branches;
    // The branch, or element, that carries it.
    const uint32_t *parents;
    // Level of the branch.
    const uint32_t *levels;
    // Three floats for each vertex: pivot of the branch.
    const float *pivots;
    // Three floats for each vertex: axis of the branch.
    const float *axes;
    // Phase of the branch.
    const float *phases;
    // Stiffness of the branch.
    const float *stiffness;
    // How far along the branch.
    const float *reach;
    // How far along the leaf.
    const float *flutter;
    // Phase of the leaf.
    const float *leaf_phases;
    // Three floats for each vertex: where the leaf is attached.
    const float *anchors;
    // Whether the vertex is part of a leaf: 0 or 1.
    const uint8_t *is_leaf;
    // Two floats for each vertex: bend weights. SpeedTree 8: branch weight, 0; 9: those of branches 1
    // and 2; Tree Creator: primary and secondary bend.
    const float *weights;
    // Two vectors of three floats for each vertex. SpeedTree 8: swing, growth; 9: directions of
    // branches 1 and 2.
    const float *directions;
} tree_unpacked_columns;

// A vertex of `TREE_LAYOUT_VERTEX`, in our axes. Errors are the largest, rounding of floats (1e-7 of the
// largest coordinate) apart. Parent, pivot and axis of a branch stand in the mesh's table of branches,
// to be uploaded as a buffer and read by the number of the branch.
typedef struct tree_packed_vertex {
    // Position: min + (max - min) * position / 65535 of the view's `bounds`. Error: extent / 131,070.
    uint16_t position[3];
    // Angle about the normal in steps of a turn / 32768, and in the highest bit 1 for a negative sign:
    // cos * x + sin * cross(n, x), where n is the normal as it is read back and x is (b, s + n.y * n.y *
    // a, -n.y) with s the sign of n.z (1 or -1), a = -1 / (s + n.z) and b = n.x * n.y * a. Error: 3e-4
    // radians.
    uint16_t tangent;
    // Octahedral normal: x and y / 32767, z = 1 - |x| - |y|; where z is negative, x is (1 - |y|) and y
    // (1 - |x|), each with its old sign; then brought to unit length. Error: 1e-4 radians.
    int16_t normal[2];
    // Texture coordinates over the view's `uv_range`, as positions. Error: range / 131,070.
    uint16_t uv[2];
    // Light-map coordinates / 65535.
    uint16_t uv2[2];
    // Number of the branch.
    uint32_t branch;
    // How far along the branch / 65535.
    uint16_t reach;
    // Ambient occlusion / 255.
    uint8_t occlusion;
    // How far along the leaf / 255.
    uint8_t flutter;
    // Phase of the branch / 255.
    uint8_t phase;
    // Stiffness of the branch / 255.
    uint8_t stiffness;
    // Level of the branch; 255 for more.
    uint8_t level;
    // Phase of the leaf / 255.
    uint8_t leaf_phase;
} tree_packed_vertex;

// The vertices of `TREE_LAYOUT_VERTEX`, and what a shader needs to read them.
typedef struct tree_packed_vertices {
    // `sizeof(tree_packed_vertices)`.
    size_t struct_size;
    // The vertices.
    const struct tree_packed_vertex *vertices;
    // Number of vertices.
    size_t n_vertices;
    // Three floats for each leaf: where it is attached, in metres. The leaf of vertex `i` is
    // `i / (n_vertices / n_anchors)`.
    const float *anchors;
    // Number of leaves; 0 for wood.
    size_t n_anchors;
    // Box of the positions in metres: its lower corner, then its upper one.
    float bounds[6];
    // Smallest, then largest texture coordinates.
    float uv_range[4];
} tree_packed_vertices;

// A vertex in the wind. All but the anchor lie within 0 to 1.
typedef struct tree_vertex_wind {
    // The branch it moves with, in the mesh's table; 0 when the mesh has none.
    uint32_t branch;
    // How far along the branch it lies; leaves as far as the place they are attached.
    float reach;
    // Leaves: how far from the anchor, 0 there and 1 at the leaf's farthest vertex. 0 for wood.
    float flutter;
    // Leaves: where in its flutter the leaf starts. 0 for wood.
    float leaf_phase;
    // Leaves: where the leaf is attached. Wood: the vertex itself.
    float anchor[3];
} tree_vertex_wind;

// A steady wind with gusts. Begin with `tree_wind_init`.
typedef struct tree_wind {
    // `sizeof(tree_wind)`.
    size_t struct_size;
    // Where it blows to; its length does not matter. Each -1e6 to 1e6; default 1, 0, 0.
    float direction[3];
    // Turn of a branch without any stiffness, in radians, -10 to 10. Default 0.5.
    float strength;
    // Share of the turn that swings to and fro, 0 to 1. Default 0.4.
    float gusts;
    // Swings in a second, 0 to 100. Default 0.5.
    float frequency;
    // How far leaves turn to and fro at their anchors, in radians, -10 to 10. Default 0.3.
    float flutter;
    // 0.
    uint32_t reserved;
} tree_wind;

// How leaves or twigs stand along a shoot: one of the `TREE_PHYLLOTAXIS_` constants.
typedef uint32_t tree_phyllotaxis;

// What one leaf consists of: one of the `TREE_LEAVES_` constants. Each leaflet and each needle becomes
// one row of the foliage.
typedef uint32_t tree_leaves_form;

// Where leaves stand and how they are held. Lengths in metres, angles in radians. Begin with
// `tree_leaf_params_init`, or with a species' own from `tree_foliage_preset`.
typedef struct tree_leaf_params {
    // `sizeof(tree_leaf_params)`.
    size_t struct_size;
    // How leaves stand along the shoot. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    tree_phyllotaxis arrangement;
    // Spiral: angle from one leaf to the next, -2π to 2π. Default the golden angle, 2.39996.
    float divergence;
    // Whorled: leaves at a node, 3 to 64. No default: 0, which is refused.
    uint32_t whorl;
    // What one leaf consists of. Default `TREE_LEAVES_SIMPLE`.
    tree_leaves_form form;
    // Pinnate: pairs of leaflets, 1 to 100. Default 4.
    uint32_t pinnate_pairs;
    // Pinnate: whether a leaflet ends the rachis. Default 1.
    uint32_t pinnate_odd;
    // Pinnate: length of the rachis above the petiole in lengths of the largest leaflet, 0 to 1000.
    // Default 2.
    float pinnate_rachis;
    // Pinnate: how far the rachis bends back over its length, -π to π. Default 0.4.
    float pinnate_droop;
    // Pinnate: angle between rachis and leaflets at its base and at its tip, 0 to π. Default 1.2, 0.8.
    float pinnate_angle[2];
    // Pinnate: size of the leaflets at base, middle and tip, 0.01 to 1. Default 0.75, 1, 0.8.
    float pinnate_profile[3];
    // Pinnate: how far leaflets are raised out of the leaf's plane, -π/2 (hanging) to π/2. Default 0.
    float pinnate_fold;
    // Pinnate: length of a leaflet's stalk in lengths of the largest leaflet, 0 to 2. Default 0.03.
    float pinnate_petiolule;
    // Pinnate: pairs of leaflets on each pinna of a leaf that is pinnate twice, up to 50. Default 0:
    // pinnate once.
    uint32_t pinnate_pinna_pairs;
    // Pinnate twice: length of the longest pinna as a share of the rachis, 0.01 to 2. Default 0.5.
    float pinnate_pinna;
    // Palmate: leaflets, 2 to 64. Default 7.
    uint32_t palmate_leaflets;
    // Palmate: angle from the first leaflet to the last, 0 to 2π. Default 4.
    float palmate_spread;
    // Palmate: size of the outermost leaflets against the middle one, 0.01 to 1. Default 0.55.
    float palmate_outer;
    // Palmate: angle by which leaflets hang below the leaf's plane, -π/2 to π/2. Default 0.2.
    float palmate_droop;
    // Fascicle: needles, 1 to 16. Rosette: needles, 1 to 128. No default: 0, which is refused.
    uint32_t needles;
    // Fascicle: angle between a needle and the axis, 0 to π/2. Rosette: angle between the outermost
    // needles and the axis, 0 to π. Default 0.
    float needle_spread;
    // Distance between leaf-bearing nodes along the shoot, 1e-4 to 1e6. Default 0.07.
    float spacing;
    // Shoots bear leaves up to this distance from their tip, 0 to 1e6. Default 0.55.
    float bearing;
    // Length of a blade (of a full leaflet or needle where the leaf has many), 1e-6 to 1e6. Default
    // 0.13.
    float size;
    // Sizes vary by up to this share either way, 0 to 0.9. Default 0.25.
    float size_variation;
    // How much smaller leaves are at the tip than at the lower end of the bearing zone, 0 to 0.9 of
    // their size; a negative number, down to -0.9, makes those at the lower end smaller. Default 0.
    float size_gradient;
    // Length of the petiole in lengths of the blade, 0 to 100; the blade stands off the shoot by as
    // much. Default 0: whatever petiole there is belongs to the picture of the leaf.
    float petiole;
    // Radius of the petiole in lengths of the blade, 0 to 0.5; used where stalks are grown too.
    // Default 0.008.
    float petiole_radius;
    // Angle between shoot and petiole, 0 (along the shoot) to π (back along it). Default 0.9.
    float pitch;
    // Random deviation of all angles, 0 to π. Default 0.35.
    float jitter;
    // How far blades hang: 0 not at all, 1 straight down. The petiole does not hang. Default 0.15.
    float droop;
    // How far upper faces turn to the light by rolling about the midrib: 0 not at all, 1 as far as
    // that brings them. Default 0.6.
    float phototropism;
    // Largest angle between petiole and blade, 0 to π: after the roll, the blade turns towards the
    // light by the share `phototropism` of what is left, but no more than this. Default 0: the midrib
    // goes on as it was.
    float lamina_turn;
    // Where light comes from; any length but 0. Default 0, 1, 0.
    float light[3];
    // Whether each tip bears a leaf that goes on in its direction. Default 1.
    uint32_t terminal;
    // The leaves' kind: an index into the species' leaf kinds, 0 to 65,535. Default 0.
    uint32_t kind;
} tree_leaf_params;

// How densely leaves or twigs stand at `position`, three floats in metres: 0 none, 1 as the parameters
// say, 2 twice as many, up to `TREE_DENSITY_CAP`. Less than 1 is the chance that a place bears; whorls stay whole.
// Negative and not a number count as 0 and are reported. Asked once for each place, from any thread and
// from several at a time; must give the same answer for the same place, and must not unwind.
typedef float (*tree_density_fn)(void *user, const float *position);

// What growing leaves did.
typedef struct tree_leaf_report {
    // `sizeof(tree_leaf_report)`.
    size_t struct_size;
    // Leaf-bearing nodes of the shoots (a whorl is one, a tip's leaf too).
    uint64_t n_bearing;
    // Leaves; a compound leaf and a fascicle is one.
    uint64_t n_leaves;
    // Blades: rows of the foliage.
    uint64_t n_blades;
    // Bearing nodes that the density left out.
    uint64_t n_thinned;
    // Bearing nodes where the density was negative or not a number, and counted as 0.
    uint64_t n_bad_density;
    // Axes without a leaf.
    uint64_t n_barren;
    // Nodes added for petioles and rachises.
    uint64_t n_stalk_nodes;
} tree_leaf_report;

// How a twig goes on: one of the `TREE_BRANCHING_` constants.
typedef uint32_t tree_branching;

// Where twigs stand, how long they are and how they are held. Lengths in metres, angles in radians.
// Begin with `tree_twig_params_init`, or with a species' own from `tree_foliage_preset`.
typedef struct tree_twig_params {
    // `sizeof(tree_twig_params)`.
    size_t struct_size;
    // How each twig goes on. Default `TREE_BRANCHING_MONOPODIAL`.
    tree_branching branching;
    // Sympodial: internodes of a module, 1 to 100. Default 1, as linden has.
    uint32_t module_internodes;
    // Sympodial: angle by which the next module turns off, 0 to π. Default 0.
    float module_turn;
    // Sympodial: angle from the side of one turn to that of the next, -2π to 2π. Default π, a zig-zag;
    // 0 gives a curl, anything between a helix.
    float module_divergence;
    // Sympodial: length of the dead tip that stays where a module ended, in internodes, 0 to 10.
    // Default 0: it is shed.
    float module_stub;
    // How twigs stand along shoots, and laterals along main twigs. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    tree_phyllotaxis arrangement;
    // Spiral: angle from one twig to the next, -2π to 2π. Default the golden angle, 2.39996.
    float divergence;
    // Whorled: twigs at a node, 3 to 64. No default: 0, which is refused.
    uint32_t whorl;
    // Orders of twigs, 1 (no laterals) to 3. Default 2. Each multiplies the number of nodes.
    uint32_t levels;
    // Twig-bearing nodes per metre of shoot, 1e-3 to 1e4. Default 10.
    float per_metre;
    // Shoots bear twigs up to this distance from their tip, 0 to 1e6. Default 0.6.
    float bearing;
    // Most twigs on one node of the skeleton, 1 to 64; more are left out and reported. Default 4.
    uint32_t crowd;
    // Length of the longest twigs, 1e-5 to 1e6. Default 0.25.
    float length;
    // Lengths vary by up to this share either way, 0 to 0.9. Default 0.25.
    float length_variation;
    // How much shorter twigs are at the tip of the bearing shoot than at the lower end of the bearing
    // zone, 0 to 1 of their length; a negative number, down to -1, makes the lower ones shorter. Holds
    // for laterals along their twig too. Default 0.5.
    float taper;
    // Length of the twig that goes on at the tip of a shoot, in lengths of the longest, 0 (none) to 1.
    // Default 0.6.
    float terminal;
    // Length of laterals against the twig that bears them, 0 to 1. Default 0.45.
    float lateral;
    // Length of an internode, 1e-5 to 1e6; a twig of less than half an internode is left out. Default
    // 0.03.
    float internode;
    // Angle between a twig and what bears it, 0 to π. Default 0.85.
    float angle;
    // Random deviation of all angles, 0 to π; a quarter of it from one internode to the next. Default
    // 0.2.
    float jitter;
    // Stiffness of the wood: its modulus of elasticity in gigapascal, 1e-4 to 1e6. Default 4, a green
    // twig; 0.2 hangs like a weeping willow.
    float stiffness;
    // Weight of leaves and fruit in kilograms per metre of twig, 0 to 1000. Default 0.03.
    float load;
    // How strongly growth turns down, per metre, -1000 to 1000: a twig that points sideways turns by so
    // many radians a metre. Negative turns up, as most shoots do. Default 0.
    float gravitropism;
    // How strongly growth turns to the light, per metre, -1000 to 1000. Default 0.5.
    float phototropism;
    // Where light comes from; any length but 0. Default 0, 1, 0.
    float light[3];
    // Radius of every twig's tip, 1e-6 to 100. Default 0.0008.
    float tip_radius;
    // How much the radius grows per metre towards the base, 0 to 1. Default 0.003.
    float radius_taper;
    // Exponent of the pipe model where laterals leave, 1 to 10. Default 2.49.
    float pipe_exponent;
    // Thickest a twig may be at its base, as a share of the radius of what bears it there, 0 to 1; a
    // thicker one is made thinner as a whole. Default 0.75.
    float radius_share;
    // Must be 0.
    uint32_t reserved;
} tree_twig_params;

// What growing twigs did.
typedef struct tree_twig_report {
    // `sizeof(tree_twig_report)`.
    size_t struct_size;
    // Twigs that old nodes bear.
    uint64_t n_twigs;
    // Twigs that twigs bear.
    uint64_t n_laterals;
    // Nodes added.
    uint64_t n_nodes;
    // Axes of the old skeleton without a place for a twig: too short, beyond the bearing zone, or left
    // out by the density.
    uint64_t n_barren;
    // Places that the density left out.
    uint64_t n_thinned;
    // Places where the density was negative or not a number, and counted as 0.
    uint64_t n_bad_density;
    // Twigs and laterals left out, shorter than half an internode.
    uint64_t n_too_short;
    // Twigs left out because their node bears `crowd` already. Many mean that the skeleton has too few
    // nodes; see `tree_skeleton_refine`.
    uint64_t n_crowded;
    // Largest distance in metres from a twig's place on the shoot to the node that bears it.
    double moved;
} tree_twig_report;

// How buds sense their surroundings: one of the `TREE_GROWTH_BY_` constants.
typedef uint32_t tree_growth_environment;

// Where trees grow. Nothing grows below the lowest base. Begin with `tree_growth_world_init`.
typedef struct tree_growth_world {
    // `sizeof(tree_growth_world)`.
    size_t struct_size;
    // By space: where there are markers, the crown. Default NULL: everywhere.
    const struct tree_volume *crown;
    // What no branch may enter, and what hides the sky. Default NULL.
    const struct tree_volume *obstacle;
    // `n_standing` points: metamers that stand there already and shade, or take up space, as those of the plants do:
    // neighbours, or a tree on which the plants are new branches. Default NULL.
    const float *standing;
    // Default 0.
    size_t n_standing;
    // How buds sense. Default `TREE_GROWTH_BY_LIGHT`.
    tree_growth_environment environment;
    // By light: edge of a voxel in metres, 0.001 to 100; about one and a half internodes. Default 0.2.
    float shadow_voxel;
    // By light: shadow in the voxel of the one who casts it, 0 to 4; the open sky gives a light of 1. Default 0.12.
    float shadow_strength;
    // By light: what divides the shadow with each layer down, 1 to 10. Default 1.4.
    float shadow_falloff;
    // By light: layers below its own that a metamer shades, 0 to 32; cost grows with the cube. Default 7.
    uint32_t shadow_depth;
    // By light: how many voxels a bud looks around for the brighter side, 1 to 8; cost grows with the cube. Default 3.
    uint32_t shadow_reach;
    // By space: radius in metres within which a node leaves no marker, 0.001 to 100; about two internodes. Default 0.24.
    float space_occupancy;
    // By space: how far a bud sees in metres, 0.001 to 100; four to six internodes. Default 0.6.
    float space_perception;
    // By space: half the angle of a bud's view in radians, 0.01 to π. Default π/4.
    float space_angle;
    // By space: markers in a cube of the perception radius, 0.1 to 4096. Default 50.
    float space_density;
    // Towards the brightest point of the sky; any length but 0. Default 0, 1, 0.
    float light[3];
    // Light of the open sky, 0 (nothing grows) to 10. Default 1.
    float brightness;
    // Distance to keep from the obstacle in metres, 0 or more. Default 0.
    float clearance;
    // 0.
    uint32_t reserved;
} tree_growth_world;

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

// How vigour is shared out at forks, which decides whether a tree has one trunk or many limbs: one of the
// `TREE_ALLOCATION_` constants.
typedef uint32_t tree_allocation;

// Which way axes turn: weights against the direction in which an axis would go on by itself, which has 1. Each metamer
// turns by them.
typedef struct tree_growth_tropisms {
    // Towards most light or space, -10 to 10. Default 0.25.
    float photo;
    // Upwards, -10 to 10; negative: hanging. Default 0.12.
    float gravi;
    // Towards the horizontal, 0 to 10. Default 0.
    float plagio;
} tree_growth_tropisms;

// The species' part of a growing tree. Lengths in metres, angles in radians, times in iterations (years, usually). Begin
// with `tree_growth_habit_init`, or with a copy of a preset's own. What those point at belongs to the library, lives
// for ever and is not to be written.
typedef struct tree_growth_habit {
    // `sizeof(tree_growth_habit)`.
    size_t struct_size;
    // Leaves; NULL for a bare tree. Default: those of `tree_leaf_params_init`.
    const struct tree_leaf_params *leaves;
    // Name, bark, and the kinds that `leaves->kind` counts; NULL for an oak's. Default: an oak's.
    const struct tree_species *species;
    // Length of an internode at whole vigour, 0.001 to 100; one of vigour v in a shoot of n metamers is v / n times as
    // long. Default 0.12.
    float internode;
    // How axillary buds stand. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    tree_phyllotaxis buds;
    // Spiral: angle from one bud to the next, -2π to 2π. Default the golden angle, 2.39996.
    float divergence;
    // Whorled: buds at a node, 3 to 64. No default: 0, which is refused.
    uint32_t whorl;
    // Only so many of a shoot's topmost metamers bear axillary buds, 1 to 64; 1 with whorled buds makes tiers of branches.
    // Default 64: all.
    uint32_t bud_zone;
    // Iterations after which an axillary bud that has not grown is dead, 0 to 10,000. Default 6.
    uint32_t bud_life;
    // Angle between an internode and the buds at its end, 0 to π. Default 0.8.
    float angle;
    // Standard deviation of branching and divergence angles, 0 to 1. Default 0.12.
    float jitter;
    // Highest order of an axis, 0 (only the trunk) to 255. Default 12.
    uint32_t max_order;
    // Most metamers a bud makes in one iteration, 1 to 64. Default 6.
    uint32_t max_shoot;
    // How vigour is shared out. Default `TREE_ALLOCATION_BORCHERT_HONDA`.
    tree_allocation allocation;
    // Borchert-Honda: λ of a seedling, 0 to 1; above 0.5 the main axis is favoured, below the laterals. 0.46 to 0.54 span
    // shrubs to poplars. Default 0.5.
    float lambda;
    // Borchert-Honda: λ of an old tree, 0 to 1; lower than `lambda` for a crown that opens with age. Default 0.5.
    float lambda_late;
    // Borchert-Honda: iterations in which λ goes from one to the other, 0 to 10,000. Default 0.
    uint32_t lambda_turning;
    // Priority: weight of the first rank, 0 to 1000. Default 0.
    float priority_first;
    // Priority: weight of the last ranks, 0 to 1000. Default 0.
    float priority_last;
    // Priority: share of the ranks over which the weight falls from one to the other, 0 to 1. Default 0.
    float priority_fall;
    // Vigour at the base per light that all buds found, 0 to 100. Default 2.
    float vigour;
    // Which way the trunk turns.
    struct tree_growth_tropisms trunk;
    // Which way all other axes turn.
    struct tree_growth_tropisms branches;
    // A branch with less light per metamer than this is shed, 0 (never) to 100. Default 0.12.
    float shedding;
    // Youngest age at which a branch can be shed, 0 to 10,000. Default 2.
    uint32_t shedding_age;
    // For how long a metamer has leaves and casts shadow, 1 to 10,000. Default 3.
    uint32_t leaf_life;
    // Radii, by the pipe model: Δ in r₀^Δ = Σ rᵢ^Δ, 1 to 10. Default 2.49.
    float radii_exponent;
    // Radii: that of every tip in metres, 1e-6 to 100. Default 0.002.
    float radii_tip;
    // Radii: how much they grow per metre towards the base, 0 to 1. Default 0.002.
    float radii_taper;
    // Radii: that of the root node in metres, 1e-6 to 100. Default 0: the tips decide.
    float radii_trunk;
    // 0.
    uint32_t reserved;
} tree_growth_habit;

// Everything that shapes a tree that grows alone. Begin with `tree_growth_params_init`, or with `tree_growth_preset`.
typedef struct tree_growth_params {
    // `sizeof(tree_growth_params)`.
    size_t struct_size;
    // Where it grows. Default NULL: as `tree_growth_world_init` has it.
    const struct tree_growth_world *world;
    // What kind of tree it is. Default NULL: as `tree_growth_habit_init` has it.
    const struct tree_growth_habit *habit;
    // Where it stands, in metres. Default the origin.
    float base[3];
    // Iterations, usually years, 0 to 10,000; after 0 there is the seedling's one internode. Default 18.
    uint32_t iterations;
} tree_growth_params;

// One iteration of one tree.
typedef struct tree_growth_year {
    // Light that all buds found together.
    float light;
    // Living buds before it grew.
    uint32_t n_buds;
    // Buds that grew.
    uint32_t n_shoots;
    // Shoots cut short by an obstacle or the ground.
    uint32_t n_blocked;
    // Nodes shed.
    uint32_t n_shed;
    // Nodes afterwards.
    uint32_t n_nodes;
} tree_growth_year;

// A view of how a tree grew.
typedef struct tree_grown_columns {
    // `sizeof(tree_grown_columns)`.
    size_t struct_size;
    // Number of nodes of the tree's skeleton.
    size_t n_nodes;
    // One for each node: iterations since its segment grew, 0 for this year's. That of the base is its first
    // internode's.
    const uint32_t *ages;
    // One for each node: the Gravelius order of the axis it grew on, 0 for the trunk.
    const uint8_t *orders;
    // Number of iterations.
    size_t n_years;
    // What happened in each iteration.
    const struct tree_growth_year *years;
} tree_grown_columns;

// A tree to be, and where it stands. Begin with `tree_growth_plant_init`.
typedef struct tree_growth_plant {
    // `sizeof(tree_growth_plant)`.
    size_t struct_size;
    // Its kind. Default NULL: as `tree_growth_habit_init` has it.
    const struct tree_growth_habit *habit;
    // Where it stands, in metres, at most 1,000 km from the origin. Default the origin.
    float base[3];
    // Direction of its first internode; any length but 0. Default 0, 1, 0.
    float direction[3];
} tree_growth_plant;

// How far trees have grown.
typedef struct tree_growth_counts {
    // `sizeof(tree_growth_counts)`.
    size_t struct_size;
    // Iterations done.
    size_t n_iterations;
    // Number of trees.
    size_t n_plants;
    // Nodes of all trees, bases included.
    size_t n_nodes;
} tree_growth_counts;

// How much is drawn.
typedef struct tree_hybrid_choice_report {
    // `sizeof(tree_hybrid_choice_report)`.
    size_t struct_size;
    // Boxes drawn by their planes.
    size_t n_boxes;
    // Ranges of leaves drawn as geometry.
    size_t n_ranges;
    // Leaves in these.
    size_t n_leaves;
    // Triangles of wood, leaves and planes.
    uint64_t n_triangles;
    // Fractional level of the wood, at least 1, for the shader.
    float level;
    // Indices of the wood, surface 0, that are drawn, from the first on.
    uint32_t wood_indices;
} tree_hybrid_choice_report;

// Leaves one after another in the order that `tree_leaf_boxes_order` tells.
typedef struct tree_leaf_range {
    // The first row.
    uint32_t first;
    // Number of rows.
    uint32_t n_leaves;
} tree_leaf_range;

// What becomes of ambient occlusion in a glTF file: one of the `TREE_GLTF_OCCLUSION_` constants.
typedef uint32_t tree_gltf_occlusion;

// How a glTF file is written. Begin with `tree_glb_options_init`.
typedef struct tree_glb_options {
    // `sizeof(tree_glb_options)`.
    size_t struct_size;
    // Name of the node and the mesh, for people and engines. Default (`data` is NULL): `tree`.
    struct tree_str name;
    // Whether vertices are written in 8 and 16 bits (`KHR_mesh_quantization`), which more than halves
    // them. Largest errors: positions the longest side of the bounds / 131,070 on each axis (0.1 mm
    // for a tree of 13 m); normals and tangents 1/254 on each axis before they are brought to unit
    // length (0.4 degrees); texture coordinates the range in use / 131,070; occlusion stays exact.
    // Default 0.
    uint32_t quantize;
    // Whether translucency is written, as `KHR_materials_diffuse_transmission`; programs that do not
    // know it pass over it. Default 0: the Khronos validator accepts it, but remarks that it cannot
    // look into it.
    uint32_t translucency;
    // What becomes of ambient occlusion. Default `TREE_GLTF_OCCLUSION_ATTRIBUTE`.
    tree_gltf_occlusion occlusion;
    // 0.
    uint32_t reserved;
} tree_glb_options;

// What a branch is worth: one of the `TREE_METRIC_` constants.
typedef uint32_t tree_metric;

// How branches are compared. Begin with `tree_metric_params_init`.
typedef struct tree_metric_params {
    // `sizeof(tree_metric_params)`.
    size_t struct_size;
    // For `TREE_METRIC_BRANCHING` and `TREE_METRIC_DENSITY_OF`: one for each branch, as `tree_adt_view` lists them, 0 to
    // 1e30. NULL, the default, for all others.
    const double *worths;
    // Number of worths: the number of branches, or 0 for the default.
    size_t n_worths;
    // What a branch is worth: a `TREE_METRIC_` constant. Default `TREE_METRIC_DENSITY`.
    tree_metric metric;
    // 0.
    uint32_t reserved;
} tree_metric_params;

// The line that is drawn through the nodes of an axis: one of the `TREE_CURVE_` constants.
typedef uint32_t tree_curve_fit;

// How it is said how far a mesh may leave the exact shape: one of the `TREE_BOUND_` constants.
typedef uint32_t tree_bound_kind;

// How a tree becomes triangles. Lengths in metres, angles in radians. Begin with
// `tree_mesh_params_init`.
typedef struct tree_mesh_params {
    // `sizeof(tree_mesh_params)`.
    size_t struct_size;
    // Which child goes on at a fork and which start tubes of their own. Default
    // `TREE_CONTINUATION_THICKEST`.
    tree_continuation continuation;
    // Fewest sides of a tube, 3 to `max_sides`. Default 3.
    uint32_t min_sides;
    // Most sides of a tube, 3 to 128. Default 20. The cost of trunk and boughs grows with it.
    uint32_t max_sides;
    // The line drawn through the nodes of an axis. Default `TREE_CURVE_THROUGH`.
    tree_curve_fit fit;
    // How it is said how far the mesh may leave the round, curved branch, which rules the number of
    // sides between the two bounds above and the number of rings. Default `TREE_BOUND_METRES`.
    tree_bound_kind error_kind;
    // With `TREE_BOUND_METRES`: the error, 0.01 mm to 1 m. Default 3 mm.
    float error;
    // With `TREE_BOUND_PIXELS`: width of the error on the screen, 0.01 to 1000. Default 1.
    float error_pixels;
    // With `TREE_BOUND_PIXELS`: from the eye to the tree in metres, 0.01 to 1e6. Default 10 m.
    float error_distance;
    // With `TREE_BOUND_PIXELS`: vertical field of view, 0.01 to 3. Default 1.
    float error_fov_y;
    // With `TREE_BOUND_PIXELS`: height of the screen in pixels, 1 or more. Default 1080.
    uint32_t error_height;
    // Longest stretch of an axis without a ring, 1 mm to 1 km. Default 1 m: branches need rings to
    // bend in the wind.
    float max_strip;
    // Thinner wood is drawn with this radius, 0.01 mm to 0.1 m. Default 0.5 mm.
    float min_radius;
    // Width of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m. Rounded for each axis so
    // that it goes round a whole number of times.
    float bark_width;
    // Height of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m.
    float bark_length;
    // How much wider the trunk is at the ground, as a share of its radius, 0 to 3; 0 turns the root
    // flare off. Default 0.35.
    float flare;
    // Height of the root flare in radii of the trunk, 0.1 to 20. Default 3.
    float flare_height;
    // Number of buttresses in the flare, 0 to 12. Default 5.
    uint32_t flare_lobes;
    // How deep the flare is cut between buttresses, 0 (round) to 0.9. Default 0.5.
    float flare_lobe_depth;
    // Factor on the length of every leaf, 0.01 to 100. Default 1.
    float leaf_scale;
    // Factor on the width of every leaf, 0.01 to 100. Default 1: as wide as its look says.
    float leaf_width;
    // How far leaf normals turn from the leaf's own towards the outside of the crown, 0 to 1.
    // Default 0.6: soft light over the whole crown.
    float leaf_rounding;
    // Whether vertices get tangents, 16 bytes each: for materials with normal maps. Default no.
    uint32_t tangents;
    // Whether vertices get texture coordinates for a light map, 8 bytes each. Default no.
    uint32_t lightmap;
    // Not used; 0.
    uint32_t reserved;
} tree_mesh_params;

// Which branches get a box. Begin with `tree_leaf_box_params_init`.
typedef struct tree_leaf_box_params {
    // `sizeof(tree_leaf_box_params)`.
    size_t struct_size;
    // A branch gets no box when its volume is less than this share of that of the box it is in, 0 to 1. Less makes more
    // boxes. Default 0.02.
    double least_volume;
    // Nor when it is more than this share: its pictures would hardly be sharper. Its own branches are looked at
    // instead. 0.01 to 1. Default 0.4.
    double most_volume;
    // Levels below the box of the whole tree, 0 to 16. Default 4.
    uint32_t levels;
    // A branch gets no box when it has fewer leaves, 1 to 1,000,000: those are cheap as they are. Default 24.
    uint32_t least_leaves;
    // Most boxes, 1 to 4096; larger ones come first. Default 64.
    uint32_t most_boxes;
    // 0.
    uint32_t reserved;
} tree_leaf_box_params;

// How leaves are projected onto planes. Begin with `tree_card_params_init`.
typedef struct tree_card_params {
    // `sizeof(tree_card_params)`.
    size_t struct_size;
    // Side of a picture in texels, gutters included, 16 to 1024. Default 64.
    uint32_t size;
    // Samples of a texel in each direction, 1 to 8. Default 4.
    uint32_t samples;
    // Texels around each picture that repeat what is at its edge, 1 to 8 and at most a quarter of `size`: so that
    // filters do not mix pictures. Default 1.
    uint32_t gutter;
    // 0.
    uint32_t reserved;
} tree_card_params;

// When boxes are opened. Begin with `tree_card_choose_params_init`.
typedef struct tree_card_choose_params {
    // `sizeof(tree_card_choose_params)`.
    size_t struct_size;
    // Pixels that a texel may cover before its box is opened, 0.01 to 100. Less is sharper and heavier. Default 1.
    float texel_pixels;
    // How much further, relatively, a box must be before it is closed again, 0 to 1: so that a camera that trembles
    // does not make leaves flicker. Default 0.1.
    float hysteresis;
} tree_card_choose_params;

// Parameters of every step to a hybrid model. Begin with `tree_hybrid_params_init`. A part that is NULL, as all are
// then, is its default.
typedef struct tree_hybrid_params {
    // `sizeof(tree_hybrid_params)`.
    size_t struct_size;
    // What branches are worth.
    const struct tree_metric_params *metric;
    // How wood and leaves are drawn.
    const struct tree_mesh_params *mesh;
    // How leaves are put into boxes.
    const struct tree_leaf_box_params *boxes;
    // The pictures of the boxes.
    const struct tree_card_params *cards;
    // When pictures take the place of leaves.
    const struct tree_card_choose_params *choose;
    // For `TREE_METRIC_RANDOM` alone. Default 0.
    uint64_t seed;
    // Side in pixels, 0.01 to 100, of the square that a path must cover, seen from the side, to be drawn. Less shows
    // finer twigs, more saves triangles. Default 0.5.
    float wood_pixels;
    // 0.
    uint32_t reserved;
} tree_hybrid_params;

// How much there is of a hybrid model.
typedef struct tree_hybrid_totals {
    // `sizeof(tree_hybrid_totals)`.
    size_t struct_size;
    // Levels of the wood, at least 1.
    size_t n_levels;
    // Surfaces of its mesh, those without triangles included; surface 0 is the wood.
    size_t n_surfaces;
    // Triangles when all is drawn as it is.
    uint64_t n_triangles;
    // Boxes of leaves; 0 for a tree without leaves.
    size_t n_boxes;
    // Rows of the order of the boxes: leaves that are drawn.
    size_t n_leaves;
} tree_hybrid_totals;

// A part of an index buffer.
typedef struct tree_index_window {
    // The first index.
    uint32_t first_index;
    // Number of indices; may be 0.
    uint32_t index_count;
} tree_index_window;

// What became of the leaves.
typedef struct tree_leaf_boxes_report {
    // `sizeof(tree_leaf_boxes_report)`.
    size_t struct_size;
    // Number of boxes.
    size_t n_boxes;
    // Number of levels, the whole tree being one.
    size_t n_levels;
    // Leaves in all.
    size_t n_leaves;
    // Leaves that are in no box but that of the whole tree.
    size_t n_in_root_only;
    // Branches that got no box because it would have been too small.
    size_t n_dropped;
} tree_leaf_boxes_report;

// The box of a branch with all its leaves.
typedef struct tree_leaf_box {
    // `sizeof(tree_leaf_box)`.
    size_t struct_size;
    // Volume in cubic metres.
    double volume;
    // The box it is in, or `TREE_NO_BOX`.
    uint32_t parent;
    // 0 for the whole tree.
    uint32_t level;
    // The node of the skeleton it begins at.
    uint32_t node;
    // Where its leaves begin in the order.
    uint32_t first_leaf;
    // Number of its leaves, those of its children included.
    uint32_t n_leaves;
    // Number of leaves that are in no child: the first ones of its leaves.
    uint32_t n_own;
    // The first of its children; the others follow it.
    uint32_t first_child;
    // Number of its children.
    uint32_t n_children;
    // Its middle in metres.
    float center[3];
    // Half its sides in metres, along its own axes; none is 0.
    float half[3];
    // Quaternion x, y, z, w that turns its own axes into those of the tree: x to the left of the branch, y along it,
    // z up.
    float turn[4];
} tree_leaf_box;

// A rectangle on which the leaves of a box are projected. The unit vectors are at right angles to each other.
typedef struct tree_card_plane {
    // Its middle, that of the box, in metres.
    float center[3];
    // Unit vector to the right of the picture: along the diagonal of a side of the box.
    float right[3];
    // Unit vector up the picture: along an axis of the box.
    float up[3];
    // Unit normal, to the viewer.
    float normal[3];
    // Half its width and half its height in metres.
    float half[2];
    // Half the depth of the box across the plane, in metres.
    float reach;
} tree_card_plane;

// What was baked.
typedef struct tree_cards_report {
    // `sizeof(tree_cards_report)`.
    size_t struct_size;
    // Number of boxes.
    size_t n_boxes;
    // Number of pictures: six for each box.
    size_t n_images;
    // Texels of all pictures.
    uint64_t n_texels;
    // Bytes of both atlases, as they are in memory.
    size_t bytes;
    // Pictures in which nothing covers half a texel.
    size_t n_empty;
    // Side of a picture in texels, gutters included.
    uint32_t size;
    // 0.
    uint32_t reserved;
} tree_cards_report;

// One of the two pictures of an impostor: one of the `TREE_IMPOSTOR_` constants.
typedef uint32_t tree_impostor_map;

// A view of a picture's pixels.
typedef struct tree_pixels {
    // `sizeof(tree_pixels)`.
    size_t struct_size;
    // Width in pixels.
    uint32_t width;
    // Height in pixels.
    uint32_t height;
    // Four bytes for each pixel (red, green, blue, alpha), rows from top to bottom.
    const uint8_t *pixels;
    // Number of bytes: `4 * width * height`.
    size_t n_bytes;
} tree_pixels;

// How a camera is placed: one of the `TREE_CAMERA_` constants.
typedef uint32_t tree_camera;

// How a camera projects: one of the `TREE_LENS_` constants.
typedef uint32_t tree_lens;

// Size, quality and camera of a picture. Begin with `tree_view_init`.
typedef struct tree_view {
    // `sizeof(tree_view)`.
    size_t struct_size;
    // Width in pixels, 1 to 16,384. Default 1024.
    uint32_t width;
    // Height in pixels, 1 to 16,384. Default 1024.
    uint32_t height;
    // Samples per pixel in each direction, 1 (jagged) to 4. Cost grows with the square; default 2.
    uint32_t samples;
    // How the camera is placed. Default `TREE_CAMERA_FRAMED`.
    tree_camera camera;
    // How the camera projects. Default `TREE_LENS_PERSPECTIVE`.
    tree_lens lens;
    // Perspective: vertical field of view in radians, 0.017 to 2.8. Default 0.6, a portrait lens.
    float fov;
    // Framed: where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a
    // quarter turn on +X. Finite; default 0.6.
    float yaw;
    // Framed: how far the camera looks down, in radians, -pi/2 (from below) to pi/2 (from above).
    // Default 0.09.
    float pitch;
    // Framed: empty share of the picture on each side, 0 to 0.45. Default 0.06.
    float margin;
    // Placed and orthographic: height of the picture in metres, more than 0. Default 0: set it.
    float lens_height;
    // Placed: where the camera stands, in metres. Default 0, 0, 0.
    float eye[3];
    // Placed: what is in the middle of the picture. Default 0, 0, 0: set it.
    float target[3];
    // Placed: which way is up; must not be parallel to the line of sight. Default 0, 1, 0.
    float up[3];
    // 0.
    uint32_t reserved;
} tree_view;

// Language of a shader: one of the `TREE_SHADER_` constants.
typedef uint32_t tree_shader;

// How much is drawn.
typedef struct tree_card_choice_report {
    // `sizeof(tree_card_choice_report)`.
    size_t struct_size;
    // Boxes drawn by their planes.
    size_t n_boxes;
    // Ranges of leaves drawn as geometry.
    size_t n_ranges;
    // Leaves in these.
    size_t n_leaves;
} tree_card_choice_report;

// A view, and how much of it is seen.
typedef struct tree_octahedral_frame {
    // Its column in the pictures.
    uint32_t column;
    // Its row, from the top.
    uint32_t row;
    // Its weight, 0 to 1.
    float weight;
} tree_octahedral_frame;

// How a whole tree is baked. Begin with `tree_octahedral_params_init`.
typedef struct tree_octahedral_params {
    // `sizeof(tree_octahedral_params)`.
    size_t struct_size;
    // Views along each side of the square of directions, 2 to 64. Default 12: 144 views.
    uint32_t grid;
    // Whether only views from the horizon up are baked, which halves the angle between them. Default 1.
    uint32_t hemi;
    // Side of the pictures in texels, 64 to 16,384, at least 16 for each view. Default 2048.
    uint32_t side;
    // Samples of a texel in each direction, 1 to 8. Default 4.
    uint32_t samples;
    // Empty texels around each view, 1 to 8 and at most a quarter of a view: so that filters do not mix views.
    // Default 2.
    uint32_t gutter;
    // Whether the picture of normals and depths has half the side. Memory goes from 33.6 MB to 21 MB at the default
    // side, at some loss of quality. Default 0.
    uint32_t half_detail;
} tree_octahedral_params;

// What was baked.
typedef struct tree_octahedral_report {
    // `sizeof(tree_octahedral_report)`.
    size_t struct_size;
    // Number of views.
    size_t n_views;
    // Triangles drawn in each.
    size_t n_triangles;
    // Texels covered at least by half, of all views.
    uint64_t covered;
    // Bytes of both pictures, as they are in memory.
    size_t bytes;
} tree_octahedral_report;

// Numbers that go with the two pictures of an octahedral impostor: what a shader needs to know. Set `struct_size` first.
typedef struct tree_octahedral_meta {
    // `sizeof(tree_octahedral_meta)`.
    size_t struct_size;
    // Views along each side of the square of directions, 2 to 64.
    uint32_t grid;
    // Whether only the upper hemisphere is there.
    uint32_t hemi;
    // Side of the picture of colours in texels.
    uint32_t side;
    // Side of a view in texels of the picture of colours, gutter included. View (column, row) begins at
    // (column, row) * tile.
    uint32_t tile;
    // Side of the picture of normals and depths: `side`, or half of it.
    uint32_t detail_side;
    // Middle of the tree in metres.
    float center[3];
    // Radius of the ball around it in metres. Depths go from minus this to it, towards the viewer.
    float radius;
    // Radius in metres of the upright cylinder around it, and a gutter more.
    float wide;
    // Half the height in metres of that cylinder, and a gutter more.
    float high;
    // Metres of a texel: the largest of any view. It follows from the others, and is not read.
    float texel;
} tree_octahedral_meta;

// How a tree is divided into twigs. Begin with `tree_instancing_params_init`.
typedef struct tree_instancing_params {
    // `sizeof(tree_instancing_params)`.
    size_t struct_size;
    // Most unique twigs, 1 to 1000. Default 30.
    uint32_t max_twigs;
    // How many times smaller than the flattened tree the result should be, 1 to 1000. Default 11: ten,
    // and some room. The truest way that reaches it is taken. Small trees may not reach it: see `ratio`
    // of `tree_instancing_report`.
    float ratio;
    // Length of twigs in metres along the longest path in them, 0.001 to 1000. Default 0: it is chosen.
    float reach;
    // Not used; 0.
    uint32_t reserved;
} tree_instancing_params;

// What an instanced tree weighs and how near it comes.
typedef struct tree_instancing_report {
    // `sizeof(tree_instancing_report)`.
    size_t struct_size;
    // Unique twigs.
    uint64_t n_twigs;
    // Instances of all twigs.
    uint64_t n_instances;
    // Bytes of the columns of base and twigs, and of the instances.
    uint64_t bytes;
    // Bytes of the columns of the flattened tree.
    uint64_t bytes_flat;
    // Leaves of the tree.
    uint64_t n_leaves;
    // Leaves of the instanced tree.
    uint64_t n_leaves_instanced;
    // `bytes_flat / bytes`.
    float ratio;
    // Length that twigs were limited to, in metres.
    float reach;
    // How far middle and spread of a subtree's leaves are off those of the twig that stands for it, in
    // metres: root mean square over all leaves.
    float deviation;
    // Not used; 0.
    uint32_t reserved;
} tree_instancing_report;

// All places where a twig stands, in columns as glTF's `EXT_mesh_gpu_instancing` has them: as input, or as a
// view.
typedef struct tree_twig_instances {
    // `sizeof(tree_twig_instances)`.
    size_t struct_size;
    // Number of instances.
    size_t n_instances;
    // Three floats for each instance: where its base is, in metres.
    const float *translations;
    // Four floats for each instance: its turn, a unit quaternion x, y, z, w.
    const float *rotations;
    // Three floats for each instance: factor on its size, the same along all axes.
    const float *scales;
    // One for each instance: the branch of the base mesh that bears it.
    const uint32_t *branches;
} tree_twig_instances;

// A file format for clouds of points: one of the `TREE_CLOUD_FORMAT_` constants.
typedef uint32_t tree_cloud_format;

// A view of a cloud of points.
typedef struct tree_cloud_columns {
    // `sizeof(tree_cloud_columns)`.
    size_t struct_size;
    // Number of points.
    size_t n_points;
    // Three doubles for each point, in the file's own axes and unit. They need not be finite.
    const double *positions;
    // Lines of text that are no points: names, counts and comments.
    uint64_t n_other_lines;
} tree_cloud_columns;

// A mesh and where its copies stand: scaled, turned, then moved.
typedef struct tree_gltf_instances {
    // `sizeof(tree_gltf_instances)`.
    size_t struct_size;
    // Name of the node and the mesh.
    struct tree_str name;
    // What is drawn many times, with materials of its own. Copied while the file is written.
    const struct tree_mesh *mesh;
    // Number of copies, at least 1.
    size_t n;
    // Three floats for each copy: where the origin comes to lie, in metres.
    const float *translations;
    // Four floats for each copy: how it is turned, a unit quaternion x, y, z, w.
    const float *rotations;
    // Three floats for each copy: factors along the axes of the mesh.
    const float *scales;
} tree_gltf_instances;

// A column of the caller's own, for one surface of a mesh.
//
// Blender 5.0.1 mixes up attributes of one mesh whose names begin with `_` when they differ in their
// number of components, and then now and then refuses the file: give all the same number there, and
// write occlusion in another way.
typedef struct tree_gltf_attribute {
    // `sizeof(tree_gltf_attribute)`.
    size_t struct_size;
    // Number of the surface in the mesh.
    size_t surface;
    // Name in the file: `_` and then capital letters, digits and `_`, at most 64 in all.
    struct tree_str name;
    // Numbers per vertex, 1 to 4.
    size_t components;
    // `components` finite numbers for each vertex.
    const float *values;
    // Number of values: `components` times the number of vertices of the surface.
    size_t n_values;
} tree_gltf_attribute;

// One level of detail of a glTF file, or all of it.
typedef struct tree_gltf_level {
    // `sizeof(tree_gltf_level)`.
    size_t struct_size;
    // What is drawn once. May be NULL when there are instances.
    const struct tree_mesh *mesh;
    // What is drawn many times.
    const struct tree_gltf_instances *instances;
    // Number of `instances`, 0 to 65,536.
    size_t n_instances;
    // More columns for the surfaces of `mesh`.
    const struct tree_gltf_attribute *attributes;
    // Number of `attributes`, 0 to 65,536.
    size_t n_attributes;
    // Share of the screen's height (0 to 1) from which this level is drawn, the finest first. Not used
    // when there is one level.
    float coverage;
    // 0.
    uint32_t reserved;
} tree_gltf_level;

// How a mesh moves: each vertex with one joint, each joint from frame to frame. Begin with `tree_glb_motion_init`.
typedef struct tree_glb_motion {
    // `sizeof(tree_glb_motion)`.
    size_t struct_size;
    // `n_joints` points: where each joint is in the mesh as it stands, in metres.
    const float *joints;
    // 1 to 65,536.
    size_t n_joints;
    // `n_vertices` numbers: the joint of each vertex, of all surfaces one after the other.
    const uint16_t *vertex_joints;
    // Vertices of all surfaces of the mesh.
    size_t n_vertices;
    // `n_frames` seconds, from 0 on, ascending.
    const float *times;
    // At least 1.
    size_t n_frames;
    // `n_frames` times `n_joints` points: where each joint is then.
    const float *positions;
    // As many unit quaternions x, y, z, w; NULL for none turned.
    const float *rotations;
    // As many factors, 0 or more; NULL for 1.
    const float *scales;
} tree_glb_motion;

// Something a reader left out or changed: one of the `TREE_NOTE_` constants.
typedef uint32_t tree_note;

// How a PLY file is written. Begin with `tree_ply_options_init`.
typedef struct tree_ply_options {
    // `sizeof(tree_ply_options)`.
    size_t struct_size;
    // Whether numbers are written as text instead of little-endian binary: five times the size, for
    // people and old programs. Default 0.
    uint32_t ascii;
    // 0.
    uint32_t reserved;
} tree_ply_options;

// Format of a file with a mesh in it: one of the `TREE_MESH_FORMAT_` constants.
typedef uint32_t tree_mesh_format;

// How files are read. Begin with `tree_import_options_init`.
typedef struct tree_import_options {
    // `sizeof(tree_import_options)`.
    size_t struct_size;
    // Whether files that the file names (buffers, textures, MTL) are read. Only those within its own
    // folder and below are: no absolute path, no `..`, no scheme, no link that leads out. Default 0:
    // textures and materials are left out and noted, missing buffers are an error.
    uint32_t external;
    // The file's format. Default `TREE_MESH_FORMAT_BY_NAME`.
    tree_mesh_format format;
} tree_import_options;

// What a file held, and what was left out or changed.
typedef struct tree_import_report {
    // `sizeof(tree_import_report)`.
    size_t struct_size;
    // Nodes of the scene (glTF), objects and groups (OBJ), 1 for PLY.
    uint64_t n_nodes;
    // Surfaces made.
    uint64_t n_surfaces;
    // Vertices of all surfaces.
    uint64_t n_vertices;
    // Triangles of all surfaces.
    uint64_t n_triangles;
    // Copies that `EXT_mesh_gpu_instancing` asked for.
    uint64_t n_instances;
    // Textures decoded.
    uint64_t n_textures;
    // How often each thing was left out or changed, by `TREE_NOTE_` constants; `tree_note_text` says
    // what they mean.
    uint64_t notes[TREE_N_NOTES];
} tree_import_report;

// Share of geometry for each distance: lambda, 0 to 1 and never rising, at the distances 0, 0.01, ... 0.1, 0.19,
// ... 1 (0 is near and shows the full model, 1 is far), and linear in between.
typedef struct tree_lod_distance {
    // Lambda at each of these 21 distances.
    float lambdas[21];
} tree_lod_distance;

// What one element is: one of the `TREE_GRAIN_` constants.
typedef uint32_t tree_grain;

// A view of elements: a row each, in the order of surfaces and triangles.
typedef struct tree_elements_columns {
    // `sizeof(tree_elements_columns)`.
    size_t struct_size;
    // Number of elements.
    size_t n_elements;
    // Surfaces of the mesh that are pruned, rising; all others are always drawn.
    const uint32_t *surfaces;
    // Number of these surfaces.
    size_t n_surfaces;
    // For each element the surface of the mesh it is on.
    const uint32_t *surface;
    // Where the triangles of each element begin in `triangles`, and their number at the end: `n_elements + 1`
    // rows.
    const uint32_t *starts;
    // Triangles of each element: their numbers in its surface.
    const uint32_t *triangles;
    // Number of rows of `triangles`.
    size_t n_triangles;
    // Three floats for each element: mean of its surface in metres, which it is scaled about.
    const float *centers;
    // Three floats for each element: mean normal; zero where it has none (a closed blade, no area).
    const float *normals;
    // For each element the area of its triangles in square metres.
    const float *areas;
    // For each element the largest distance of a vertex from the mean of its own triangles, in metres.
    const float *radii;
} tree_elements_columns;

// Which surface of a field, and how finely. Begin with `tree_hull_params_init`.
typedef struct tree_hull_params {
    // `sizeof(tree_hull_params)`.
    size_t struct_size;
    // Value of the field on the surface, 0.001 to 0.5. Default 0.05: a lone element gets a ball of 0.88 times
    // the radius of influence.
    float iso;
    // Cells of the grid along the radius of influence, 2 to 16. Default 3. Cost grows with the cube.
    float detail;
} tree_hull_params;

// What orders by density and orientation need to know. Begin with `tree_order_params_init`.
typedef struct tree_order_params {
    // `sizeof(tree_order_params)`.
    size_t struct_size;
    // The hull, for `tree_order_combined` and `tree_hull_of_elements`. NULL, the default: its defaults.
    const struct tree_hull_params *hull;
    // Height of the plant in metres, 0 to 1e9. Default 0: measured, as `tree_elements_plant_height` does it.
    float height;
    // Radius of influence of an element, as a share of the height, 0.001 to 1. Default 0.05.
    float radius;
    // When densities count as uniform and thinning by density ends: at this standard deviation of the
    // densities of what is left, divided by their mean, 0 (never) to 10 (at once). Default 0.15.
    float uniform;
    // Thinning by density ends at this share of the elements at the latest, 0 to 1. Default 0.25.
    float least;
    // How much chance is added to priorities, which lie within 0 to 1; 0 (none) to 1. Default 0.05.
    float randomness;
    // 0.
    uint32_t reserved;
} tree_order_params;

// A view of a hull.
typedef struct tree_hull_columns {
    // `sizeof(tree_hull_columns)`.
    size_t struct_size;
    // Number of vertices.
    size_t n_vertices;
    // Three floats for each vertex: where it is, in metres. Each place is there once.
    const float *positions;
    // Three floats for each vertex: unit normal, outwards.
    const float *normals;
    // Number of indices: three for each triangle.
    size_t n_indices;
    // Vertices of the triangles, counter-clockwise seen from outside.
    const uint32_t *indices;
} tree_hull_columns;

// Size of a mask of bits.
typedef struct tree_bits_size {
    // `sizeof(tree_bits_size)`.
    size_t struct_size;
    // Width in pixels.
    uint32_t width;
    // Height in pixels.
    uint32_t height;
    // Words of all rows: what `tree_bits_words` writes.
    size_t n_words;
    // Pixels of all rows: what `tree_bits_bytes` writes.
    size_t n_pixels;
    // Number of set bits.
    uint64_t count;
} tree_bits_size;

// Pixels of a simplified model against those of the full one: of one view, or added up over many.
typedef struct tree_score {
    // Covered by both.
    uint64_t both;
    // Covered by the simplified model only.
    uint64_t wrong;
    // Covered by the full model only.
    uint64_t missed;
} tree_score;

// Views around a model, each of which frames all of it. Begin with `tree_around_init`.
typedef struct tree_around {
    // `sizeof(tree_around)`.
    size_t struct_size;
    // How far the cameras look down in radians, -pi/2 to pi/2, each with all azimuths: every next ring is
    // turned by a share of the step, so that no two stand above each other. NULL, the default: one ring,
    // level.
    const float *pitches;
    // Number of pitches, at most 64; 0 for the default.
    size_t n_pitches;
    // Directions around the trunk for each pitch, evenly spread, 1 to 360. Default 8.
    uint32_t azimuths;
    // Width and height of the masks in pixels, 8 to 4096. Default 512.
    uint32_t size;
    // Where the first stands, in radians. Default 0. Views for measuring should not be those that an order
    // was made with.
    float turn;
    // Vertical field of view in radians, 0.017 to 2.8, for perspective. 0, the default: parallel projection.
    float fov;
} tree_around;

// How the order by coverage is made. Begin with `tree_coverage_params_init`.
typedef struct tree_coverage_params {
    // `sizeof(tree_coverage_params)`.
    size_t struct_size;
    // Views that are looked at. More hold better for others, at proportional cost. NULL, the default: those of
    // `tree_around_for_order`.
    const struct tree_around *around;
    // Shares of triangles for which the choice is made, falling, more than 0, less than 1. NULL, the default:
    // 0.5, 0.35, 0.2, 0.1, 0.05, 0.02.
    const float *stages;
    // Number of stages, at most 32; 0 for the default.
    size_t n_stages;
    // Whether leaves choose the point they grow about; otherwise it is their centre. Default 1.
    uint32_t pivots;
    // 0.
    uint32_t reserved;
} tree_coverage_params;

// How large a pruned model is.
typedef struct tree_pruned_totals {
    // `sizeof(tree_pruned_totals)`.
    size_t struct_size;
    // Surfaces that are pruned; all others are drawn whole.
    size_t n_parts;
    // Number of tiers.
    size_t n_tiers;
    // Number of elements.
    size_t n_elements;
    // Triangles of the full foliage.
    uint64_t n_triangles;
    // Number of states; neighbours differ in one element.
    uint64_t n_steps;
    // Bytes of the foliage's indices in the mesh that came in.
    uint64_t indices_before;
    // Bytes of the indices of all tiers.
    uint64_t indices_after;
    // Bytes of the foliage's vertices in the mesh that came in.
    uint64_t vertices_before;
    // Bytes of the vertices with copies and centres.
    uint64_t vertices_after;
    // The least lambda that can be kept: of the state with the fewest elements.
    float least_lambda;
    // Lambda of the last state in which all elements are drawn.
    float lambda_of_all;
} tree_pruned_totals;

// A view of a surface that is pruned.
typedef struct tree_pruned_part {
    // `sizeof(tree_pruned_part)`.
    size_t struct_size;
    // Four floats for each vertex of the surface: the point that its element is scaled about, in metres, and the
    // lambda from which on it is drawn (0: always). A vertex of no element has itself as centre.
    const float *centers;
    // Number of vertices.
    size_t n_vertices;
    // Number of the surface in the mesh.
    uint32_t surface;
    // Mean linear colour of what is seen of the full model: texture times base colour.
    float mean[3];
} tree_pruned_part;

// What is drawn of the elements; *ranks* are places in the order, the most important is 0.
typedef struct tree_lod_cut {
    // Triangles that are drawn.
    uint64_t n_triangles;
    // Tier of the ranks below `fine`.
    uint32_t tier;
    // Ranks from here to `end` are drawn with the next tier.
    uint32_t fine;
    // Ranks from here on are not drawn.
    uint32_t end;
    // 0.
    uint32_t reserved;
} tree_lod_cut;

// When levels in a file change. Begin with `tree_lod_screen_init`.
typedef struct tree_lod_screen {
    // `sizeof(tree_lod_screen)`.
    size_t struct_size;
    // Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
    const struct tree_lod_distance *distance;
    // Distance in metres up to which the full model is wanted, in a field of view of 60 degrees, 0 or more.
    // Default 10.
    float near;
    // Distance from which on the least will do, more than `near`, at most 1e9. Default 500.
    float far;
} tree_lod_screen;

// What is drawn for a lambda, and the numbers that the shader needs. Its windows stand in an array of their own.
typedef struct tree_lod_level {
    // Share of the foliage's triangles, more than 0, at most 1. No less than what one element needs.
    float lambda;
    // Factor on the area of each element.
    float scale;
    // Factor on its lengths: the square root of `scale`.
    float growth;
    // Factor on the contrast of colours, more than 0, at most 1.
    float contrast;
    // Width in lambda over which the last elements fade; 0 where all are drawn.
    float fade;
    // 0.
    uint32_t reserved;
    // Triangles of the foliage that are drawn.
    uint64_t n_triangles;
} tree_lod_level;

// A piece of a surface's index buffer.
typedef struct tree_lod_window {
    // Number of the surface.
    uint32_t surface;
    // First index.
    uint32_t first_index;
    // Number of indices; may be 0.
    uint32_t index_count;
} tree_lod_window;

// How a model is pruned. Begin with `tree_prune_params_init`.
typedef struct tree_prune_params {
    // `sizeof(tree_prune_params)`.
    size_t struct_size;
    // Share of lambda over which the last elements fade, 0 to 1. More is smoother in motion, but shows fewer of the
    // triangles that are drawn. 0: they pop. Default 0.1.
    float fade;
    // 0.
    uint32_t reserved;
} tree_prune_params;

// How outlines become simpler. Begin with `tree_tiers_params_init`.
typedef struct tree_tiers_params {
    // `sizeof(tree_tiers_params)`.
    size_t struct_size;
    // Share of its triangles that an element has in each tier after the first, falling, 0 to 1. Every element keeps
    // a triangle, or two where a picture with a mask lies on it. NULL, the default: 1/2, 1/4, 1/8, 1/16.
    const float *shares;
    // Number of shares, at most 16; 0 for the default.
    size_t n_shares;
    // How far lengths of elements may differ, in lengths of a square of the same area, for them to share one answer,
    // 0 to 1. Default 0.08.
    float alike;
    // Largest share of the triangles of the tier before that a tier may have; others are not worth their memory and
    // are left out. 0 to 1. Default 0.9.
    float worth;
} tree_tiers_params;

// Which scale a table is measured with: one of the `TREE_LOD_SCALE_` constants.
typedef uint32_t tree_lod_scale;

// How a table is measured. Begin with `tree_lod_table_params_init`.
typedef struct tree_lod_table_params {
    // `sizeof(tree_lod_table_params)`.
    size_t struct_size;
    // From where to look. NULL, the default: 8 azimuths, level, with 256 pixels; fewer and smaller for a large
    // model, as `tree_around_for_table` says.
    const struct tree_around *around;
    // Rows of the table: rising, more than 0, the last 1. NULL, the default: 17 from 0.01 to 1.
    const float *lambdas;
    // Number of lambdas, at most 256; 0 for the default.
    size_t n_lambdas;
    // Which scale is measured: a `TREE_LOD_SCALE_` constant. Default `TREE_LOD_SCALE_BEST`.
    tree_lod_scale scale;
    // `TREE_LOD_SCALE_FIXED`: the scale, a factor on area, 0.01 to 10,000. Default 1.
    float fixed;
} tree_lod_table_params;

// Every step from a mesh to a pruned model. Begin with `tree_prune_make_params_init`.
typedef struct tree_prune_make_params {
    // `sizeof(tree_prune_make_params)`.
    size_t struct_size;
    // Surfaces that are pruned, each once. NULL, the default: they are found, as `tree_elements_of_mesh` does it.
    const uint32_t *surfaces;
    // Number of these surfaces; 0 for the default.
    size_t n_surfaces;
    // How outlines become simpler. NULL, the default: its defaults.
    const struct tree_tiers_params *outlines;
    // How the order is found. NULL, the default: as is right for so many triangles.
    const struct tree_coverage_params *order;
    // How scales are measured. NULL, the default: as is right for so many triangles.
    const struct tree_lod_table_params *table;
    // How the model is pruned. NULL, the default: its defaults.
    const struct tree_prune_params *prune;
    // What an element is: a `TREE_GRAIN_` constant. Default `TREE_GRAIN_BLADE`.
    tree_grain grain;
    // 0.
    uint32_t reserved;
} tree_prune_make_params;

// What is measured: a model, its elements, in which order they are dropped, and what they are drawn with. Begin with
// `tree_lod_subject_init`.
typedef struct tree_lod_subject {
    // `sizeof(tree_lod_subject)`.
    size_t struct_size;
    // The full model. No default: NULL, which is refused.
    const struct tree_mesh *mesh;
    // Its elements. No default: NULL, which is refused.
    const struct tree_elements *elements;
    // All elements, the most important first, such as `tree_order_coverage` writes them.
    const uint32_t *order;
    // Number of rows of `order`: the number of elements.
    size_t n_order;
    // Three floats for each element (not rank): the point it is scaled about, in metres. NULL, the default: its
    // centre.
    const float *pivots;
    // Number of pivots: the number of elements, or 0 for the default.
    size_t n_pivots;
    // What the elements are drawn with. NULL, the default: the full model alone.
    const struct tree_tiers *tiers;
    // Number of elements with which each tier begins, such as `tree_lod_plan` writes them: of the first all, then
    // never more than before. NULL, the default: each begins with all.
    const uint32_t *kept;
    // Number of rows of `kept`: the number of tiers, or 0 for the default.
    size_t n_kept;
} tree_lod_subject;

// An ellipsoid along the axes of a model that nothing is seen through.
typedef struct tree_scene_occluder {
    // Its centre in metres.
    float center[3];
    // Half its size along each axis, more than 0.
    float radii[3];
} tree_scene_occluder;

// A window of an index buffer.
typedef struct tree_scene_draw {
    // First index.
    uint32_t first_index;
    // Number of indices; 0 for a part that is not drawn.
    uint32_t index_count;
    // Added to each index.
    int32_t base_vertex;
} tree_scene_draw;

// A tree model as a scene draws it. Lengths in metres, in the model's own space. Begin with
// `tree_scene_model_init`. All is copied into the scene.
typedef struct tree_scene_model {
    // `sizeof(tree_scene_model)`.
    size_t struct_size;
    // Points on the crown's surface, evenly spread, three floats each, such as `tree_hull_sample` writes them.
    // NULL, the default: the model is never taken for occluded.
    const float *samples;
    // Number of points, at most 64; 32 do well.
    size_t n_samples;
    // What hides other trees in the built-in occlusion pass: a few ellipsoids that are opaque for certain, such
    // as the inner crown and the trunk. NULL, the default: the model hides nothing there.
    const struct tree_scene_occluder *occluders;
    // Number of occluders, at most 64.
    size_t n_occluders;
    // Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
    const struct tree_lod_distance *distance;
    // For each level the share of the foliage's triangles, rising, more than 0, at most 1. The more levels, the
    // smoother. No default: NULL, which is refused.
    const float *lambdas;
    // For each level the factor on the area of each element, more than 0. NULL, the default: 1.
    const float *scales;
    // For each level the width in lambda over which the last elements fade in, 0 (they pop; nothing fades in the full
    // model) to 1. NULL, the default: 0.
    const float *fades;
    // Number of levels, 1 to 1024.
    size_t n_levels;
    // What is drawn of each part of the model (bark, leaves, fruit): the parts of the first level, then those of
    // the next, `n_levels * n_parts` rows. A part that is always drawn whole has the same draw in every level.
    // No default: NULL, which is refused.
    const struct tree_scene_draw *draws;
    // Number of parts, 1 to 64.
    size_t n_parts;
    // Centre of a sphere around the whole model, at its largest scale. Default 0, 0, 0.
    float center[3];
    // Radius of that sphere, more than 0, at most 100,000. Default 1: set it.
    float radius;
    // Distance up to which the full model is drawn, for an instance of scale 1 in a field of view of 60 degrees
    // from top to bottom; what counts is the size on the screen. 0 or more. Default 10.
    float near;
    // Distance from which on the least is drawn, more than `near`. Default 500.
    float far;
} tree_scene_model;

// A tree of a scene.
typedef struct tree_scene_instance {
    // Which model of the scene it is.
    uint32_t model;
    // Where the model's origin stands, in metres, within 1e7 of the origin.
    float position[3];
    // How it is turned: a unit quaternion, x, y, z, w. 0, 0, 0, 1 is not at all.
    float rotation[4];
    // Factor on its size, 0.001 to 1000.
    float scale;
} tree_scene_instance;

// What is needed to draw a scene.
typedef struct tree_scene_needs {
    // `sizeof(tree_scene_needs)`.
    size_t struct_size;
    // Number of instances: rows of `tree_instance_lod` that always suffice.
    size_t n_instances;
    // Rows of `tree_draw_indexed` that always suffice: the parts of all instances.
    size_t most_draws;
    // Indices of all instances at their finest level: what is drawn without selection.
    uint64_t most_indices;
} tree_scene_needs;

// How an instance was drawn in the last frame.
typedef struct tree_scene_shown {
    // Whether it was in view, 1 or 0; if not, all else is 0.
    uint32_t in_view;
    // Level of its model.
    uint32_t level;
    // Share of the foliage's triangles.
    float lambda;
    // Share of the sample points that are seen, 0 to 1.
    float visible;
} tree_scene_shown;

// How shares of geometry follow what is seen. Begin with `tree_scene_params_init`.
typedef struct tree_scene_params {
    // `sizeof(tree_scene_params)`.
    size_t struct_size;
    // Least factor on lambda of a tree that is hidden, 0.001 to 1. Default 0.1.
    float hidden;
    // Width of the band in which nothing changes, as a share of lambda, 0 to 1. Default 0.05. Wider: calmer, but
    // up to so much more is drawn.
    float band;
    // Seconds in which lambda comes nearer to its aim by two thirds, 0 (at once) to 60. Default 0.2.
    float time;
    // 0.
    uint32_t reserved;
} tree_scene_params;

// How it is found out what stands before a tree: one of the `TREE_SCENE_OCCLUSION_` constants.
typedef uint32_t tree_scene_occlusion;

// One picture that is to be drawn. Begin with `tree_scene_frame_init`.
//
// Matrices have 16 floats, column by column, as engines hand them to shaders. A view turns and moves only; the
// eye looks along -Z of it. A projection is right-handed with depth from 0 to 1: perspective or orthographic, its
// far end finite or infinite, its depth reversed or not, off centre, upside down (Vulkan).
typedef struct tree_scene_frame {
    // `sizeof(tree_scene_frame)`.
    size_t struct_size;
    // From the world to the eye's space. No default: zeros, which are refused.
    float view[16];
    // From the eye's space to clip space. No default: zeros, which are refused.
    float projection[16];
    // Seconds since the last frame, 0 to 1e6. Default 0: no time has passed.
    float seconds;
    // Whether the camera has jumped: all shares are then what they should be at once. Default 0.
    uint32_t cut;
    // What hides trees: a `TREE_SCENE_OCCLUSION_` constant. Default `TREE_SCENE_OCCLUSION_NONE`. All that follows
    // is for `TREE_SCENE_OCCLUSION_DEPTH`.
    tree_scene_occlusion occlusion;
    // Whether the first row of depths lies at clip y = -w, as in Vulkan and OpenGL; otherwise it lies at +w, as in
    // Direct3D, Metal and WebGPU. Default 0.
    uint32_t depth_y_down;
    // Depth of each pixel from 0 to 1, row by row, of the previous frame or some frames ago. They are not copied.
    const float *depths;
    // Number of depths: `depth_width * depth_height`.
    size_t n_depths;
    // Pixels in a row, 1 to 32,768. 256 by 144 do.
    uint32_t depth_width;
    // Rows, 1 to 32,768.
    uint32_t depth_height;
    // The view the depths were drawn with.
    float depth_view[16];
    // The projection the depths were drawn with; it tells whether depth is reversed.
    float depth_projection[16];
} tree_scene_frame;

// What a frame draws.
typedef struct tree_scene_report {
    // `sizeof(tree_scene_report)`.
    size_t struct_size;
    // Instances in view.
    uint64_t n_drawn;
    // Instances out of view.
    uint64_t n_culled;
    // Instances in view of which some sample points are hidden. What is so far that it is drawn as coarsely as can
    // be is not tested, and counts as seen.
    uint64_t n_occluded;
    // Instances in view of which all are.
    uint64_t n_hidden;
    // Indices drawn: what a vertex shader sees at most.
    uint64_t n_indices;
    // Triangles drawn, if all are lists.
    uint64_t n_triangles;
} tree_scene_report;

// Arguments of an indexed indirect draw, laid out as Vulkan, Direct3D 12, WebGPU and Metal take them.
typedef struct tree_draw_indexed {
    // Number of indices.
    uint32_t index_count;
    // Number of instances, never 0.
    uint32_t instance_count;
    // First index.
    uint32_t first_index;
    // Added to each index.
    int32_t base_vertex;
    // Row of the first instance in the buffer of `tree_instance_lod`.
    uint32_t first_instance;
} tree_draw_indexed;

// How an instance is drawn in this frame, 20 bytes: for a storage buffer that vertex shaders read.
typedef struct tree_instance_lod {
    // Number of the instance in the scene.
    uint32_t instance;
    // Factor on the *length* of each element about its centre.
    float scale;
    // Share of the foliage's triangles, 0 to 1. It moves smoothly; the window drawn holds at least as much.
    float lambda;
    // Width in lambda of the end of the order that is fading: an element of rank u (0 first, 1 last) has the size
    // `clamp((lambda - u) / fade, 0, 1)`. 0 where nothing fades: the full model.
    float fade;
    // Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007).
    float contrast;
} tree_instance_lod;

// A share of geometry, its best scale, and how good the model then is.
typedef struct tree_lod_row {
    // Share of the foliage's triangles that is drawn, more than 0, at most 1.
    float lambda;
    // Factor on the area of each element; lengths grow by its square root.
    float scale;
    // Precision over the views that were looked at.
    float precision;
    // Recall over them.
    float recall;
    // Mean of the quality of the views.
    float quality;
} tree_lod_row;

// A view of a tier.
typedef struct tree_tier_columns {
    // `sizeof(tree_tier_columns)`.
    size_t struct_size;
    // Number of elements.
    size_t n_elements;
    // Where the triangles of each element begin, and their number at the end: `n_elements + 1` rows.
    const uint32_t *starts;
    // Three vertices of the element's surface for each triangle, in the winding of the model.
    const uint32_t *triangles;
    // Number of triangles.
    size_t n_triangles;
} tree_tier_columns;

// How a material treats the alpha of its texture: one of the `TREE_ALPHA_` constants.
typedef uint32_t tree_alpha;

// What a surface looks like, in glTF's metallic-roughness terms; nothing on a tree is metal. As input
// (begin with `tree_material_init`), or as a view.
typedef struct tree_material {
    // `sizeof(tree_material)`.
    size_t struct_size;
    // Name for people and files. As input, empty is `material`.
    struct tree_str name;
    // As input: the picture wrapped on the surface, or NULL for none; the material keeps what it needs,
    // so the handle may be freed. In views always NULL: `has_texture` says whether there is one, and
    // `tree_mesh_texture` or `tree_look_texture` give a handle of it.
    const struct tree_texture *texture;
    // Linear colour (0 or more; files hold up to 1) and alpha (0 to 1), multiplied with the texture.
    // Default white.
    float base_color[4];
    // 0 mirror-like to 1 matt. Default 0.9.
    float roughness;
    // How texture alpha is used. Default `TREE_ALPHA_OPAQUE`.
    tree_alpha alpha;
    // With `TREE_ALPHA_MASK`: alpha below which pixels are not drawn, 0 to 1. Default 0.5.
    float alpha_cutoff;
    // Whether back faces are drawn, with their normals turned over. Default no.
    uint32_t double_sided;
    // Share of the light on one face that shines through the other, 0 to 1. Leaves have about 0.4.
    // Default 0.
    float translucency;
    // In views: whether there is a texture. Ignored in input.
    uint32_t has_texture;
} tree_material;

// One leaf as a small mesh in its own frame: base at the origin, midrib along +Y with the apex at a
// height of about 1, upper face towards +Z. Triangles counter-clockwise seen from above. As input, or as
// a view.
typedef struct tree_leaf_mesh {
    // `sizeof(tree_leaf_mesh)`.
    size_t struct_size;
    // Number of vertices, at most 65,536.
    size_t n_vertices;
    // Number of indices, three for each triangle.
    size_t n_indices;
    // Three floats for each vertex: where it is, in lengths of the leaf.
    const float *positions;
    // Three floats for each vertex: its unit normal.
    const float *normals;
    // Two floats for each vertex: texture coordinates, v downwards.
    const float *uvs;
    // Two floats for each vertex, or NULL: where it lies on the leaf's own piece of the light map, 0 to 1
    // both ways. NULL: above its place in the plane of the leaf, right for leaves that do not overlap
    // themselves.
    const float *uvs2;
    // Three for each triangle: its vertices.
    const uint32_t *indices;
} tree_leaf_mesh;

// What a leaf is cut out of: one of the `TREE_LEAF_` constants. Fold, bend and number of sheets go with every form but `TREE_LEAF_MESH`.
typedef uint32_t tree_leaf_form;

// What leaves of one kind look like: as input (begin with `tree_leaf_look_init`), or as a view.
typedef struct tree_leaf_look {
    // `sizeof(tree_leaf_look)`.
    size_t struct_size;
    // Goes on the leaves. Should be double-sided, with an alpha mask where the texture has one. As input,
    // NULL is the default material. In views always NULL: `tree_look_material` views it.
    const struct tree_material *material;
    // With `TREE_LEAF_MESH`: the leaf, which is copied. In views always NULL: `tree_look_leaf_mesh` views
    // it.
    const struct tree_leaf_mesh *mesh;
    // Width of the picture in lengths of the leaf, 0.001 to 1000; 1 is square. Default 1. Unused by
    // `TREE_LEAF_MESH`, which has its own.
    float width;
    // What a leaf is cut out of. Default `TREE_LEAF_CARD`.
    tree_leaf_form form;
    // With `TREE_LEAF_OUTLINE` and `TREE_LEAF_MODELLED`: most vertices of the polygon, 4 to 64. Default
    // 8; a modelled leaf of 12 has up to 20 triangles when folded or bent.
    uint32_t max_vertices;
    // Copies of the leaf turned about its midrib, evenly over half a turn, 1 to 8. Two or three make
    // clusters and needles look full from all sides. Default 1.
    uint32_t sheets;
    // Angle in radians by which each half of a leaf stands up along the midrib, 0 to 1.4. Default 0.
    float fold;
    // Angle in radians by which the midrib bends down from base to apex, evenly, 0 to π. Default 0.
    float bend;
    // Rows of triangles that a bent leaf has at least, 1 to 16. Default 2.
    uint32_t rows;
    // Width of petioles in lengths of the leaf, 0 to 0.2: a prism of three sides from the shoot to the
    // base of the leaf, eight vertices and six triangles a leaf. Default 0, none.
    float petiole;
} tree_leaf_look;

// Spots of another colour on bark. Has no `struct_size`: it is a row of an array, and never changes.
typedef struct tree_bark_patches {
    // sRGB colour.
    uint8_t color[3];
    // Not used.
    uint8_t reserved;
    // Waves of the noise that shapes them, across and along, 1 to 256.
    uint32_t count[2];
    // Share of the bark they cover, roughly, 0 to 1.
    float share;
    // Width of their edges, 0.01 (hard) to 1.
    float softness;
    // How much of the colour below they hide, 0 to 1.
    float opacity;
    // How rough their surface is, 0 to 1: dark cracks along the trunk.
    float roughness;
} tree_bark_patches;

// What bark looks like. One tile of the texture is meant for 0.5 to 1 metre of trunk; counts are per
// tile and 0 switches a layer off, so do strengths of 0. Begin with `tree_bark_style_init`, or with the
// style of a built-in bark by `tree_bark_style_of`.
typedef struct tree_bark_style {
    // `sizeof(tree_bark_style)`.
    size_t struct_size;
    // Where the noise starts: another seed is another piece of the same bark. Default 0.
    uint64_t seed;
    // Spots of another colour, drawn in order (lichen, peeling, old bark). Default none.
    const struct tree_bark_patches *patches;
    // Number of `patches`, at most 16.
    size_t n_patches;
    // How much of `tint` is mixed in at most, 0 to 1. Default 0.3.
    float tinting;
    // Plates across and along, 0 to 256. Default none.
    uint32_t plates[2];
    // Width of the cracks between plates, in widths of a plate, 0 to 1. Default 0.2.
    float crack;
    // How much brightness differs from plate to plate, 0 to 1. Default 0.15.
    float plate_contrast;
    // Waves of the noise whose zero lines are furrows, across and along, 0 to 256. Default 8, 2.
    uint32_t furrows[2];
    // Width of the furrows, as height of that noise, 0 to 1. Default 0.3.
    float furrow_width;
    // Depth of the furrows, 0 to 1. Default 1.
    float furrow_depth;
    // How ragged edges are, 0 to 1. Default 0.4.
    float ragged;
    // How far points are shifted, in tiles, 0 to 0.5. Default 0.03.
    float warp;
    // Strength of the flakes, thin layers with stepped edges, 0 to 1. Default 0.
    float flakes;
    // Waves of the finest layer across and along, 0 to 256. Default 24, 12.
    uint32_t grain[2];
    // Height of the grain, 0 to 1. Default 0.3.
    float grain_height;
    // Rings around the trunk, waves along a tile, 0 to 256. Default 0.
    uint32_t rings;
    // Strength of the rings, 0 to 1. Default 0.3.
    float ring_contrast;
    // Strength of the baked light, 0 to 3. Default 1.
    float relief;
    // Whether there are lenticels, short dark lines across the trunk, as on birch and cherry. Default no.
    uint32_t has_lenticels;
    // With `has_lenticels`: places for one, across and along, 1 to 256. Default 5, 34.
    uint32_t lenticel_count[2];
    // With `has_lenticels`: share of the places taken, 0 to 1. Default 0.45.
    float lenticel_share;
    // With `has_lenticels`: length of the longest, in places, 0.01 to 1. Default 1.
    float lenticel_length;
    // With `has_lenticels`: thickness of the thickest, in places, 0.01 to 1. Default 0.45.
    float lenticel_thickness;
    // With `has_lenticels`: sRGB colour. Default a dark brown.
    uint8_t lenticel_color[3];
    // sRGB colour of the ridges. Default a grey brown.
    uint8_t ridge[3];
    // sRGB colour of the depths of cracks and furrows. Default a dark brown.
    uint8_t furrow[3];
    // sRGB colour that slow noise mixes in. Default a greenish grey.
    uint8_t tint[3];
    // Not used; 0.
    uint32_t reserved;
} tree_bark_style;

// How a leaf's mesh came about.
typedef struct tree_leaf_model_report {
    // `sizeof(tree_leaf_model_report)`.
    size_t struct_size;
    // Whether the picture could not be outlined (no mask, or nothing of it visible) and the leaf is a card
    // instead.
    uint32_t fallback;
    // Whether the margin is modelled, so that no mask is needed.
    uint32_t opaque;
    // Share of the picture's pixels that can be seen; 1 without a mask.
    float visible;
    // Area of the polygon in the picture as share of the picture; 1 for a card.
    float drawn;
    // Area of all triangles together, in squared lengths of the leaf.
    float area;
    // Not used; 0.
    uint32_t reserved;
} tree_leaf_model_report;

// The shape and colours of a leaf, in lengths of its blade (the petiole joins at the origin, the apex is
// at 0, 1), and how leaves stand on a twig. Angles in radians, colours in sRGB. Begin with
// `tree_leaf_shape_init`, or with the shape of a built-in leaf by `tree_leaf_shape_of`.
typedef struct tree_leaf_shape {
    // `sizeof(tree_leaf_shape)`.
    size_t struct_size;
    // Where mottling and the irregularities of a spray start. Default 0.
    uint64_t seed;
    // Right half of the outline from the petiole to the apex, three floats for each point: x (0 to 2), y
    // (-1 to 2) and sharpness (0 rounded, 1 a corner). Default an ovate leaf.
    const float *outline;
    // Number of points of the outline, 2 to 256.
    size_t n_outline;
    // Angles of the main veins of the right half with the midrib, 0 to π. The midrib is always there.
    // Default none.
    const float *rays;
    // Number of `rays`, at most 8.
    size_t n_rays;
    // Pairs of secondary veins per blade length, 0 to 64. Default 8.
    float vein_pairs;
    // Rise of the secondary veins along the main vein per distance from it, 0 to 4. Default 0.8.
    float vein_slope;
    // How much lighter veins are, 0 to 1. Default 0.5.
    float vein_contrast;
    // Teeth on each half of the margin, 0 to 100. Default 0.
    uint32_t n_teeth;
    // How far teeth stand out, in blade lengths, 0 to 0.2. Default 0.
    float tooth_depth;
    // Teeth from 0 for waves to 1 for a saw that points to the apex. Default 0.
    float tooth_sharpness;
    // Whether each tooth bears three smaller ones. Default no.
    uint32_t double_teeth;
    // Length of the petiole, as share of the whole leaf, 0 to 0.8. Default 0.15.
    float petiole;
    // Strength of mottling and shading, 0 to 1. Default 0.5.
    float mottle;
    // Whether leaves stand on a twig, as the fields that begin with `spray` say (lengths in lengths of
    // the twig; along it, angles and sizes go evenly from the first value to the last). Default no.
    uint32_t has_spray;
    // Leaves on the main twig, 1 to 400; one of them ends it. Default 9.
    uint32_t spray_leaves;
    // Whether leaves stand in pairs. Default no.
    uint32_t spray_opposite;
    // Share of the twig below the first leaf, 0 to 0.9. Default 0.2.
    float spray_bare;
    // Angle of the lowest and the topmost leaf with the twig, 0 to π. Default 1.15, 0.5.
    float spray_angle[2];
    // Length of the lowest, a middle and the topmost leaf, 0.01 to 2. Default 0.42, 0.46, 0.4.
    float spray_size[3];
    // How irregular angle, size and brightness are, 0 to 1. Default 0.5.
    float spray_jitter;
    // How far leaves turn towards the tip of the twig on their way, in leaf lengths, -0.5 to 0.5. Default
    // 0.08.
    float spray_bend;
    // Thickness of the twig at its base, 0.001 to 0.2. Default 0.022.
    float spray_twig;
    // Side shoots, 0 to 32; they bear the same leaves, fewer. Default 0.
    uint32_t spray_shoots;
    // Angle of the side shoots, 0 to π. Default 0.8.
    float spray_shoot_angle;
    // Length of the lowest side shoot, 0.05 to 1. Default 0.5.
    float spray_shoot_size;
    // Colour of the blade. Default a mid green.
    uint8_t base[3];
    // Colour of the veins.
    uint8_t vein[3];
    // Colour of the petiole.
    uint8_t stalk[3];
    // What `tree_leaf_shape_autumn` turns the blade to.
    uint8_t autumn[3];
    // Colour of the twig of a spray.
    uint8_t spray_twig_color[3];
    // Not used; 0.
    uint8_t reserved;
} tree_leaf_shape;

// How a picture of a leaf goes on a card.
typedef struct tree_leaf_card {
    // `sizeof(tree_leaf_card)`.
    size_t struct_size;
    // Width of the card per length from base to apex: `width` of `tree_leaf_look`.
    float width;
    // Share of the height, from the base, that is stalk (for a spray: bare twig), 0 to 1.
    float petiole;
} tree_leaf_card;

// A picture's name and pixels: as input, or as a view of a `tree_texture`.
typedef struct tree_texture_pixels {
    // `sizeof(tree_texture_pixels)`.
    size_t struct_size;
    // Name for people and files, without extension.
    struct tree_str name;
    // `4 * width * height` bytes: red, green, blue and alpha in sRGB with straight alpha, rows from top
    // to bottom.
    const uint8_t *pixels;
    // Width in pixels, 1 or more.
    uint32_t width;
    // Height in pixels, 1 or more.
    uint32_t height;
} tree_texture_pixels;

// How a skeleton becomes a word. Begin with `tree_chain_params_init`.
typedef struct tree_chain_params {
    // `sizeof(tree_chain_params)`.
    size_t struct_size;
    // How far a node may be from its place, as a share of the tree's extent, 0 to 0.01: numbers are rounded to
    // as few decimals as this allows. 0 writes all digits. Default 1e-5.
    double tolerance;
    // Which child goes on at a fork; the others are in brackets. Default `TREE_CONTINUATION_THICKEST`.
    tree_continuation continuation;
    // 0.
    uint32_t reserved;
} tree_chain_params;

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

// How the width of segments becomes the radius of nodes: one of the `TREE_TAPER_` constants.
typedef uint32_t tree_taper;

// Where radii come from: one of the `TREE_THICKNESS_` constants.
typedef uint32_t tree_thickness;

// What a word leaves open when a turtle draws it. Lengths and widths are in the word's own units, which `unit`
// or `height` makes metres. Begin with `tree_turtle_params_init`, `tree_grammar_turtle`, `tree_chain_turtle` or
// `tree_lsystem_preset`.
typedef struct tree_turtle_params {
    // `sizeof(tree_turtle_params)`.
    size_t struct_size;
    // Length of an `F`, `f` or `G` without parameter, 0 to 1e6 units. Default 1.
    double step;
    // Diameter of wood before the first `!`, 0 to 1e6 units. Default 0.1.
    double width;
    // Angle of a turn without parameter in degrees, -3600 to 3600. Default 22.5.
    double angle;
    // What a `!` without parameter multiplies the width by, 0.01 to 1; `#` divides by it. Default √½: the
    // cross-section halves.
    double width_ratio;
    // Size of a `~` without parameter, 0 to 1e6 units. Default 1.
    double leaf_size;
    // How readily shoots bend towards `tropism`: after each `F` the heading turns by this times the sine of the
    // angle between them, in radians. -10 to 10, default 0. A module `_(e)` sets it for the rest of its branch.
    double elasticity;
    // Metres in a unit, 1e-6 to 1e6. Default 1.
    double unit;
    // The direction shoots bend to, each number -1000 to 1000. Default straight down.
    float tropism[3];
    // Height of the tree in metres, 0.001 to 1000, in place of `unit`. Default 0: `unit` decides.
    float height;
    // Radius of the base in metres, 1e-6 to 100: all radii are multiplied by the one factor that makes it so.
    // Default 0: widths are in the same unit as lengths.
    float trunk_radius;
    // How widths become radii. Default `TREE_TAPER_SMOOTH`.
    tree_taper taper;
    // Where radii come from. Default `TREE_THICKNESS_AUTO`.
    tree_thickness thickness;
    // Whether polygons that look like leaves become leaves too. Default 1.
    uint32_t polygon_leaves;
    // The rule for radii. Default NULL: that of `tree_radius_rule_init`.
    const struct tree_radius_rule *radii;
    // What the tree is; its leaf kinds are those of `~(size, kind)`. Default NULL: an oak.
    const struct tree_species *species;
} tree_turtle_params;

// What drawing a word took, and what was left out.
typedef struct tree_turtle_report {
    // `sizeof(tree_turtle_report)`.
    size_t struct_size;
    // `tree_lsystem_grow`: steps of the derivation. Else 0.
    uint64_t n_steps;
    // `tree_lsystem_grow`: modules that all steps wrote together. Else 0.
    uint64_t n_produced;
    // Modules read by the turtle.
    uint64_t n_modules;
    // Most brackets open at a time.
    uint64_t depth;
    // Gaps made by `f` before wood was drawn again. The skeleton runs on through them: a tree is connected.
    uint64_t gaps;
    // `F` and `G` of no length, which make no node.
    uint64_t merged;
    // Modules that a `%` cut off.
    uint64_t cut;
    // Polygons with fewer than three corners, left out.
    uint64_t thin_polygons;
    // Polygons that became leaves as well.
    uint64_t polygon_leaves;
    // Symbols that say nothing to the turtle: `tree_turtle_trace_skipped` names them.
    uint64_t n_skipped;
    // Metres in a unit of length.
    double scale;
    // Whether the word set any width: 1 or 0.
    uint32_t widths;
    // 0.
    uint32_t reserved;
} tree_turtle_report;

// What kind of place a mistake has: one of the `TREE_GRAMMAR_PLACE_` constants.
typedef uint32_t tree_grammar_place;

// Where a text or a word is wrong, for an editor that marks the place; what is wrong is in
// `tree_error_text`. Written when the call fails, too.
typedef struct tree_grammar_report {
    // `sizeof(tree_grammar_report)`.
    size_t struct_size;
    // `TREE_GRAMMAR_PLACE_TEXT`: line of the text, from 1; else 0.
    uint64_t line;
    // `TREE_GRAMMAR_PLACE_TEXT`: column in characters, from 1; else 0.
    uint64_t column;
    // `TREE_GRAMMAR_PLACE_MODULE`: index of the module in the word, from 0; else 0.
    uint64_t module;
    // Which of these hold.
    tree_grammar_place place;
    // 0.
    uint32_t reserved;
} tree_grammar_report;

// What a grammar says beside its productions.
typedef struct tree_grammar_info {
    // `sizeof(tree_grammar_info)`.
    size_t struct_size;
    // The text it was read from.
    struct tree_str text;
    // Angle of turns without a parameter in degrees (`angle:`). 90 where the text does not say.
    double angle;
    // Seed that the text proposes (`seed:`). 0 where it does not.
    uint64_t seed;
    // Number of productions, without those of decomposition and interpretation.
    size_t n_productions;
    // Number of named constants: `tree_grammar_constant`.
    size_t n_constants;
    // Number of kinds of modules: `tree_grammar_kind`.
    size_t n_kinds;
    // Number of derivations that the text asks for (`steps:`), 0 to 1,000,000. 0 where it does not.
    uint32_t steps;
    // 0.
    uint32_t reserved;
} tree_grammar_info;

// What is known of a preset. All texts are valid for ever.
typedef struct tree_lsystem_preset_info {
    // `sizeof(tree_lsystem_preset_info)`.
    size_t struct_size;
    // Its name: `oak`, `honda-a`, `abop-1.24f`.
    struct tree_str name;
    // What it looks like, in a few words.
    struct tree_str title;
    // Where it was published; empty for those of this library.
    struct tree_str source;
    // The text of its grammar, before its constants are changed.
    struct tree_str text;
    // Number of constants of the text that it changes: `tree_lsystem_preset_constant`.
    size_t n_constants;
} tree_lsystem_preset_info;

// A view of the polygons that a turtle drew between `{` and `}`, leaf or not, in the order of their ends.
typedef struct tree_turtle_polygons {
    // `sizeof(tree_turtle_polygons)`.
    size_t struct_size;
    // Number of polygons.
    size_t n_polygons;
    // `n_polygons` + 1 places: polygon i has the corners from `starts[i]` to before `starts[i + 1]`, three or
    // more.
    const uint64_t *starts;
    // Number of corners of all polygons.
    size_t n_vertices;
    // Three floats for each corner, in metres, in the order they were drawn.
    const float *vertices;
    // One for each polygon: the colour number when it was closed (`'`).
    const uint32_t *colors;
    // One for each polygon: the skeleton's node it hangs on.
    const uint32_t *nodes;
} tree_turtle_polygons;

// A word in columns: as input, or as a view of a `tree_word`.
typedef struct tree_word_columns {
    // `sizeof(tree_word_columns)`.
    size_t struct_size;
    // Number of modules.
    size_t n_modules;
    // One for each module: its kind, which says its symbol and number of parameters (`tree_word_kind`).
    const uint16_t *kinds;
    // Number of parameters of all modules together.
    size_t n_params;
    // The parameters of all modules, one after another.
    const double *params;
    // Number of kinds in the alphabet. Not used as input.
    size_t n_kinds;
} tree_word_columns;

// What a word came from. Columns that do not apply are NULL.
typedef struct tree_word_history {
    // `sizeof(tree_word_history)`.
    size_t struct_size;
    // Derived words: number of steps, and 1. Else 0.
    size_t n_growth;
    // Number of modules of the axiom, and then of the word after each step.
    const uint64_t *growth;
    // Words of skeletons: number of nodes that the word draws. Else 0.
    size_t n_nodes;
    // For each of these, in the order of the word, the node of the skeleton it stands for.
    const uint32_t *nodes;
    // Words of skeletons: number of leaves that the word draws. Else 0.
    size_t n_leaves;
    // For each of these, in the order of the word, the leaf of the foliage it stands for.
    const uint32_t *leaves;
} tree_word_history;

// The host's allocator. Its functions are called from any thread and must not call the library.
typedef struct tree_allocator {
    // `sizeof(tree_allocator)`.
    size_t struct_size;
    // Handed to the functions.
    void *user;
    // `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
    void *(*allocate)(void *user, size_t size, size_t align);
    // Gives back what `allocate` gave for this size and alignment.
    void (*release)(void *user, void *block, size_t size, size_t align);
} tree_allocator;

// What a mesh was made of and what was left out.
typedef struct tree_mesh_report {
    // `sizeof(tree_mesh_report)`.
    size_t struct_size;
    // Vertices of all surfaces.
    uint64_t n_vertices;
    // Triangles of all surfaces.
    uint64_t n_triangles;
    // Tubes drawn.
    uint64_t n_tubes;
    // Axes of which so little comes out of the parent's wood that they are drawn as a point.
    uint64_t n_stubs;
    // Axes not drawn because all their nodes lie at one place, or inside the parent's wood. What they
    // carry is drawn on the axis below.
    uint64_t n_skipped_axes;
    // Laterals whose base was turned or moved because another one has its place.
    uint64_t n_moved_axes;
    // Nodes passed over because they lie within a tenth of a radius of the one before, or back inside
    // the wood.
    uint64_t n_skipped_nodes;
    // Leaves of size 0, not drawn.
    uint64_t n_skipped_leaves;
    // Number of leaf kinds whose picture could not be outlined as their look asks (it has no mask, or
    // nothing of it is visible): drawn as cards.
    uint64_t n_leaf_fallbacks;
    // Those leaf kinds, or NULL for none. Part of the mesh: valid until it is freed.
    const uint32_t *leaf_fallbacks;
} tree_mesh_report;

// How a surface is subdivided. Begin with `tree_subdivide_params_init`.
typedef struct tree_subdivide_params {
    // `sizeof(tree_subdivide_params)`.
    size_t struct_size;
    // How often each triangle becomes four, 0 to 8. Default 2.
    uint32_t levels;
    // Angle between normals in radians above which an edge is a crease, 0 to π. Default 1.
    float crease;
    // Rounds in which the limit surface is brought to the old points, 0 (Loop's own, which shrinks) to
    // 20. Default 1. More is for coarse meshes: where rings stand much closer than they are wide, as at
    // the joints of a fine mesh, each round overshoots and the surface can fold. Fine meshes shrink
    // little: 0 or 1 is enough.
    uint32_t fit;
    // Not used; 0.
    uint32_t reserved;
} tree_subdivide_params;

// How bark is displaced. Lengths in metres. Begin with `tree_displace_params_init`.
typedef struct tree_displace_params {
    // `sizeof(tree_displace_params)`.
    size_t struct_size;
    // Height of the highest ridges and depth of the deepest furrows, 0 to 10 m; most points move less
    // than half as far. Default 1 cm.
    float amplitude;
    // Wavelength across the branch, 0.1 mm to 100 m. Default 8 cm.
    float scale;
    // How many times longer the relief is along the branch, 1 to 20. Default 3.
    float stretch;
    // Layers of noise, each of half the wavelength and half the height, 1 to 8. Default 3. The cost grows
    // with it.
    uint32_t octaves;
    // Largest share of the local radius by which a point moves, 0 to 0.5. Default 0.15.
    float share;
    // The local radius where the mesh has no branches, 0 to 1000 m. Default 10 cm.
    float radius;
    // Whether points on the ground keep their height, so that the tree stands as it stood. Default yes.
    uint32_t has_ground;
    // With `has_ground`: points at or below this height keep theirs. Default 1 mm.
    float ground;
} tree_displace_params;

// How ambient occlusion is computed. Begin with `tree_occlusion_params_init`.
typedef struct tree_occlusion_params {
    // `sizeof(tree_occlusion_params)`.
    size_t struct_size;
    // Cells along the longest side of the tree, 4 to 512. Default 64. Cost grows with its third power.
    uint32_t cells;
    // Directions that light comes from, 6 to 1024. Default 48. Cost grows with it.
    uint32_t directions;
    // Share of the light that a leaf keeps back, 0 to 1. Default 0.5: leaves let light pass, and their
    // cards are not full.
    float leaf_opacity;
    // Light from below the horizon as a share of that from above, 0.01 (dark ground) to 1. Default 0.5:
    // what looks to the sky counts more than what looks to the ground.
    float ground;
} tree_occlusion_params;

// Triangles of one material, in columns: a view of a mesh's surface, or input. Columns that are absent
// are NULL. Triangles are counter-clockwise seen from outside; texture coordinates have their origin at
// the top left of the picture, v downwards.
typedef struct tree_surface {
    // `sizeof(tree_surface)`.
    size_t struct_size;
    // Number of vertices.
    size_t n_vertices;
    // Number of indices, three for each triangle.
    size_t n_indices;
    // Number of leaves; 0 for bark.
    size_t n_anchors;
    // Vertices of each leaf, `n_vertices / n_anchors`; 0 when the surface is not made of leaves. Ignored
    // in input.
    size_t vertices_per_leaf;
    // Three floats for each vertex: where it is, in metres.
    const float *positions;
    // Three floats for each vertex: its unit normal.
    const float *normals;
    // Two floats for each vertex: texture coordinates. Bark repeats beyond 0 to 1.
    const float *uvs;
    // Four floats for each vertex, or NULL: the unit tangent, the direction in which u grows along the
    // surface, and the sign that makes `sign * cross(normal, tangent)` point against v, up the picture
    // (as glTF).
    const float *tangents;
    // Two floats for each vertex, or NULL: texture coordinates for a light map, within 0 to 1, in which
    // no two places of the whole mesh overlap.
    const float *uvs2;
    // One for each vertex, or NULL: the branch it moves with, an index into the branches that
    // `tree_mesh_branches` views.
    const uint32_t *branches;
    // One for each vertex, or NULL: ambient occlusion, 0 (dark) to 1 (open).
    const float *occlusion;
    // One for each vertex, or NULL when no vertex is a copy: the first vertex that stands at the same
    // point of the closed surface, itself unless it is a copy at a seam of the texture.
    const uint32_t *welds;
    // Three floats for each leaf, or NULL when there are none: where it is attached. All leaves have the
    // same number of vertices and lie one after the other.
    const float *anchors;
    // Three for each triangle: its vertices.
    const uint32_t *indices;
    // The material, an index into the mesh's materials.
    uint32_t material;
    // Not used; 0.
    uint32_t reserved;
} tree_surface;

// What `tree_mesh_examine` found. Vertices that are copies of one point, for a seam of the texture, count
// as one. Lengths in metres.
typedef struct tree_topology {
    // `sizeof(tree_topology)`.
    size_t struct_size;
    // Points that triangles use; copies at seams count once.
    uint64_t n_points;
    // Edges between points.
    uint64_t n_edges;
    // Triangles of three different points.
    uint64_t n_triangles;
    // Triangles with two corners at one point. They have no area and are not counted elsewhere.
    uint64_t collapsed_triangles;
    // Edges of one triangle only: holes.
    uint64_t boundary_edges;
    // Edges of more than two triangles.
    uint64_t non_manifold_edges;
    // Edges of two triangles that run along them in the same direction: one faces inwards.
    uint64_t misoriented_edges;
    // Points whose triangles form more than one fan.
    uint64_t non_manifold_points;
    // Vertices that do not stand exactly where the vertex they are welded to stands: cracks.
    uint64_t cracks;
    // Pieces that share no point.
    uint64_t components;
    // Triangles with less area than `TREE_FLAT_SHARE` allows.
    uint64_t flat_triangles;
    // Euler characteristic, points − edges + triangles: 2 for each closed piece without handles.
    int64_t euler;
    // Enclosed volume in m³; of a closed surface only. Negative when its triangles face inwards.
    double volume;
    // Area in m².
    double area;
    // Area of the smallest triangle in m²; infinite without triangles.
    double smallest_area;
    // Smallest angle of any triangle in radians, up to π/3; infinite without triangles.
    double smallest_angle;
    // Whether this is a closed, consistently oriented 2-manifold, of any number of pieces.
    uint32_t is_closed;
    // Not used; 0.
    uint32_t reserved;
} tree_topology;

// A view of crossings. Pairs are two triangle numbers each, the lower one first, sorted.
typedef struct tree_crossing_pairs {
    // `sizeof(tree_crossing_pairs)`.
    size_t struct_size;
    // Number of `pairs`.
    size_t n_pairs;
    // Number of `pairs_at_points`.
    size_t n_pairs_at_points;
    // Triangles that share no point of the surface and yet have a place in common; NULL for none.
    const uint32_t *pairs;
    // Triangles that share one point of the surface and have another place in common; NULL for none.
    const uint32_t *pairs_at_points;
    // Different triangles in either list.
    uint64_t n_triangles;
} tree_crossing_pairs;

// How much there is of a mesh.
typedef struct tree_mesh_totals {
    // `sizeof(tree_mesh_totals)`.
    size_t struct_size;
    // Number of surfaces.
    uint64_t n_surfaces;
    // Number of materials.
    uint64_t n_materials;
    // Number of branches that move in the wind.
    uint64_t n_branches;
    // Vertices of all surfaces.
    uint64_t n_vertices;
    // Triangles of all surfaces.
    uint64_t n_triangles;
} tree_mesh_totals;

// A box and a ball around vertices, in metres. All 0 when there are no vertices.
typedef struct tree_bounds {
    // `sizeof(tree_bounds)`.
    size_t struct_size;
    // Lower corner of the box.
    float min[3];
    // Upper corner of the box.
    float max[3];
    // Centre of a ball that holds every vertex: the middle of the box.
    float center[3];
    // Its radius, at most √3 times that of the smallest such ball.
    float radius;
} tree_bounds;

// What a module of a bracketed chain is: one of the `TREE_TOKEN_` constants.
typedef uint8_t tree_token;

// A bracketed chain of modules, as far as its branches are concerned.
typedef struct tree_token_columns {
    // `sizeof(tree_token_columns)`.
    size_t struct_size;
    // Number of modules, brackets included.
    size_t n_tokens;
    // One for each: a `TREE_TOKEN_` constant.
    const tree_token *kinds;
    // One for each: the length that it draws, finite and 0 or more; 0 for all that do not advance. Those of brackets
    // are not looked at.
    const double *lengths;
} tree_token_columns;

// Branches in columns.
typedef struct tree_adt_columns {
    // `sizeof(tree_adt_columns)`.
    size_t struct_size;
    // Number of branches, at least 1.
    size_t n_branches;
    // One for each branch: the branch it stems from, or `TREE_NO_PARENT` for branch 0.
    const uint32_t *parents;
    // One for each branch: the length of its own modules together.
    const double *lengths;
    // One for each branch: the area that its own modules show from the side, in m² for skeletons and trees; that of its
    // own leaves is in it for trees. Lengths for chains of modules.
    const double *areas;
} tree_adt_columns;

// What an item of a multi-chain is: one of the `TREE_ITEM_` constants.
typedef uint8_t tree_item;

// A multi-chain in columns.
typedef struct tree_multi_chain_columns {
    // `sizeof(tree_multi_chain_columns)`.
    size_t struct_size;
    // Number of items.
    size_t n_items;
    // One for each item: a `TREE_ITEM_` constant.
    const tree_item *kinds;
    // One for each item: the place of a module in the plain chain, or the number of a state.
    const uint32_t *values;
    // Number of levels, at least 1.
    size_t n_levels;
    // One for each level: the item it ends before. The first `k` levels are the items before `ends[k - 1]`; level `i`
    // alone begins at `ends[i - 1]`, level 0 at 0.
    const uint32_t *ends;
    // Number of states that a turtle has to keep at once.
    uint32_t n_states;
    // 0.
    uint32_t reserved;
} tree_multi_chain_columns;

// A level in a file, and when it is shown.
typedef struct tree_level_share {
    // The level, as in `tree_multi_mesh_mesh_at`.
    float level;
    // Share of the screen's height, 0 to 1, from which on it is shown.
    float share;
} tree_level_share;

// How much there is of a mesh with levels.
typedef struct tree_multi_mesh_totals {
    // `sizeof(tree_multi_mesh_totals)`.
    size_t struct_size;
    // Number of levels, at least 1.
    size_t n_levels;
    // Number of surfaces, those without triangles included.
    size_t n_surfaces;
    // Triangles of all levels together.
    uint64_t n_triangles;
} tree_multi_mesh_totals;

// One more column of a surface, for the shader that lets branches grow in.
typedef struct tree_multi_mesh_column {
    // `sizeof(tree_multi_mesh_column)`.
    size_t struct_size;
    // Four floats for each vertex of the surface: the fork that its path stems from, in metres, and the number of the
    // path, from 0 on.
    const float *branches;
    // Number of vertices.
    size_t n_vertices;
} tree_multi_mesh_column;

// What is drawn of a surface: so many of its indices, from the first on.
typedef struct tree_multi_draw {
    // Number of the surface.
    uint32_t surface;
    // Number of indices; may be 0.
    uint32_t index_count;
} tree_multi_draw;

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

// How much of a stream has arrived.
typedef struct tree_stream_report {
    // `sizeof(tree_stream_report)`.
    size_t struct_size;
    // Levels that are whole and checked.
    size_t n_levels;
    // Levels of the whole stream; 0 while its head is not there.
    size_t n_levels_in_all;
    // Bytes that have been read.
    uint64_t n_bytes;
    // 1 when all has arrived and its check holds, otherwise 0.
    uint32_t is_complete;
    // 0.
    uint32_t reserved;
} tree_stream_report;

// How a stream is written. Begin with `tree_stream_params_init`.
typedef struct tree_stream_params {
    // `sizeof(tree_stream_params)`.
    size_t struct_size;
    // Precision of positions and leaf sizes in metres, 0 or 1e-6 to 1; radii are eight times as precise, leaves are
    // turned by at most 0.2 degrees. Default 0: exact, to the last bit, in two to three times the bytes.
    float precision;
    // 0.
    uint32_t reserved;
} tree_stream_params;

// The camera of one photograph. The tree's base is the world's origin, +Y is up. Begin with
// `tree_particle_camera_init`, or let `tree_align` find it.
typedef struct tree_particle_camera {
    // `sizeof(tree_particle_camera)`.
    size_t struct_size;
    // Where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a quarter turn on
    // +X. -1e6 to 1e6; default 0.
    float yaw;
    // How far the camera looks down, in radians, -1.5 to 1.5. A photograph from the ground looks up:
    // negative. Default 0.
    float pitch;
    // Vertical field of view of the whole picture in radians, 0.017 to 2.8: a phone held upright has about
    // 1.2. 0, the default, is parallel projection, close enough for a photograph from afar.
    float fov;
    // Size of the picture in pixels, 1 to 1e6 each. Default 1, 1: set it.
    float size[2];
    // Where the tree's base is in the picture, in pixels from the top left; may lie outside. Default 0.5, 1:
    // set it.
    float base[2];
    // Metres for a pixel, at the tree's base, 1e-7 to 1e6. Default 1: set it.
    float scale;
} tree_particle_camera;

// One photograph, ready to be used: what it shows of the tree and where it was taken from. Begin with
// `tree_particle_view_init`.
typedef struct tree_particle_view {
    // `sizeof(tree_particle_view)`.
    size_t struct_size;
    // How much of each pixel the tree covers. No default: NULL, which is refused.
    const struct tree_matte *matte;
    // The photograph itself, of the same size; may be NULL.
    const struct tree_photo *photo;
    // Where it was taken from; its `size` is that of the matte. No default: NULL, which is refused.
    const struct tree_particle_camera *camera;
} tree_particle_view;

// What a density depends on. Begin with `tree_density_params_init`.
typedef struct tree_density_params {
    // `sizeof(tree_density_params)`.
    size_t struct_size;
    // Voxels along the tree's height, 4 to 256. Default 48. Memory and time grow with its cube. Trees more
    // than four times as wide as high get larger voxels.
    uint32_t resolution;
    // Voxels are thrown away where a view covers less of them than this, 0 to 1. Default 0.05. Higher
    // values cut off thin foliage.
    float threshold;
    // How far horizontal sections of the crown are rounded, 0 (boxes from two views) to 1 (ellipses of the
    // widths seen). Default 1.
    float rounding;
    // Rays for every side of a voxel, 0.25 to 4, in each view. Default 1. Memory and time grow with its
    // square.
    float rays;
    // Least transparency of a pixel, 1e-4 to 0.5: what is opaque counts as letting so much through.
    // Default 0.02. Lower values make the densest parts denser.
    float least_transparency;
    // Weight of the demand that densities are small and even, 0.01 to 10. Default 0.7. Higher values thin
    // out what is few voxels deep; lower ones leave specks where views differ, and take longer.
    float evenness;
    // Most iterations of the solver, 1 to 100,000. Default 500.
    uint32_t iterations;
    // The solver stops when the densities are surely within this share of the exact ones, 1e-4 to 1.
    // Default 0.02.
    float tolerance;
} tree_density_params;

// How a density came about.
typedef struct tree_density_report {
    // `sizeof(tree_density_report)`.
    size_t struct_size;
    // Rays: equations.
    uint64_t n_rays;
    // Voxels that were left after carving: unknowns.
    uint64_t n_voxels;
    // Voxels thrown away by carving.
    uint64_t n_carved;
    // Voxels that no picture shows.
    uint64_t n_unseen;
    // Entries of the system of equations that are not zero.
    uint64_t n_entries;
    // What looking through the density misses of the mattes, as a share: 0 when it gives them exactly.
    double residual;
    // Iterations of the solver.
    uint32_t n_iterations;
    // 1 when the solver stopped at the most iterations allowed, and the density is not final.
    uint32_t not_converged;
    // Views that contradict the others.
    uint32_t n_contradictions;
    // Views that are covered all over, and say nothing about the tree's outline.
    uint32_t n_opaque;
} tree_density_report;

// How one view fits a density.
typedef struct tree_density_view {
    // What looking through the density misses of the view's matte, as a share: 0 when it gives it exactly.
    double residual;
    // 1 when the view contradicts the others.
    uint32_t contradicts;
    // 1 when the view is covered all over, and says nothing about the tree's outline.
    uint32_t is_opaque;
} tree_density_view;

// A view of what carving left.
typedef struct tree_carved_columns {
    // `sizeof(tree_carved_columns)`.
    size_t struct_size;
    // Number of voxels that are left.
    size_t n_voxels;
    // For each of them its row in the grid, rising.
    const uint32_t *voxels;
    // For each of them how far it lies inside the rounded crown, 0 to 1.
    const float *weights;
    // Voxels that were thrown away although a view shows them.
    uint64_t n_carved;
    // Voxels that no picture shows.
    uint64_t n_unseen;
} tree_carved_columns;

// A view of equations. The entries of ray `i` are rows `starts[i]` up to, but not including,
// `starts[i + 1]`.
typedef struct tree_equations_columns {
    // `sizeof(tree_equations_columns)`.
    size_t struct_size;
    // Number of rays: rows of A.
    size_t n_rays;
    // `n_rays + 1` numbers, 0 first and `n_entries` last.
    const uint64_t *starts;
    // For each ray what is seen along it: b.
    const float *targets;
    // Number of voxels: columns of A, in the order of `tree_carved_view`.
    size_t n_voxels;
    // For each voxel how far it lies inside the rounded crown, above 0 to 1.
    const float *weights;
    // Number of entries of A that are not zero.
    size_t n_entries;
    // For each entry the voxel that the ray meets.
    const uint32_t *voxels;
    // For each entry the ray's length in it, in metres.
    const float *lengths;
    // Weight of the demand that densities are small and even, in metres.
    float lambda;
    // 0.
    uint32_t reserved;
} tree_equations_columns;

// How much more points are wanted at `position`, three floats in metres, than the density says: 1 as much,
// 0 none. Negative and not a number count as 0. Asked once for the centre of each voxel that is not empty,
// from any thread and from several at a time; must give the same answer for the same place, and must not
// unwind.
typedef float (*tree_weight_fn)(void *user, const float *position);

// A stroke over a matte. Begin with `tree_density_stroke_init`.
typedef struct tree_density_stroke {
    // `sizeof(tree_density_stroke)`.
    size_t struct_size;
    // Its course: two floats for each point, in pixels from the top left. One point makes a dot.
    const float *points;
    // Number of points.
    size_t n_points;
    // Width in pixels, above 0. Default 20.
    float width;
    // What the matte becomes in its middle, 0 (erase) to 1 (opaque). Default 1.
    float value;
    // Share of its width over which it fades, 0 (hard) to 1. Default 0.5.
    float softness;
    // 0.
    uint32_t reserved;
} tree_density_stroke;

// A stroke of a ball through a grid. Begin with `tree_density_brush_init`.
typedef struct tree_density_brush {
    // `sizeof(tree_density_brush)`.
    size_t struct_size;
    // Its course: three floats for each point, in metres. One point makes a ball.
    const float *points;
    // Number of points.
    size_t n_points;
    // Radius in metres, above 0. Default 0.5.
    float radius;
    // What the grid becomes in its middle, 0 (erase) to 1e6 per metre. Default 1.
    float value;
    // Share of its radius over which it fades, 0 (hard) to 1. Default 0.5.
    float softness;
    // 0.
    uint32_t reserved;
} tree_density_brush;

// The share of the direction towards the nearest branch, 0 to 1, at a distance as a share of the picture's
// height. Not a number counts as 0. Called from any thread, by several at once; must give the same answer
// for the same distance, and must not unwind.
typedef float (*tree_blend_fn)(void *user, float distance);

// How much a particle is directed towards the branches instead of along them, by its distance: one of the
// `TREE_BLEND_` constants.
typedef uint32_t tree_blend;

// How a direction field is made. Begin with `tree_field_params_init`.
typedef struct tree_field_params {
    // `sizeof(tree_field_params)`.
    size_t struct_size;
    // Table: two floats for each point: a distance as a share of the picture's height, ascending, and a
    // share, 0 to 1. Before the first and after the last it is as there. Default NULL.
    const float *blend_table;
    // Table: number of points, at least 1.
    size_t n_blend_table;
    // Function. Default NULL. Sessions and `tree_from_photos` keep parameters longer than a call and take
    // no functions: give them a table.
    tree_blend_fn blend_function;
    // Handed to `blend_function`.
    void *blend_user;
    // How directions towards and along branches are blended. Default `TREE_BLEND_LINEAR`.
    tree_blend blend;
    // Linear: distance as a share of the picture's height, 0.0001 to 10. Default 0.05.
    float blend_reach;
    // Linear: greatest share, 0 to 1. Default 0.85.
    float blend_most;
    // Constant: share, 0 to 1. Default 0.
    float blend_share;
    // Cells over the height of the picture, 1 to 4096. Default 100. Cost grows with the square.
    uint32_t rows;
    // How far the grid reaches beyond the picture on every side, as a share of its height, 0 to 2. Default
    // 0.1.
    float margin;
} tree_field_params;

// A view of a direction field.
typedef struct tree_direction_field_columns {
    // `sizeof(tree_direction_field_columns)`.
    size_t struct_size;
    // Two floats for each cell, row by row from the top left: x to the right, y up, length 0 to 1. 0, 0
    // where there is no direction.
    const float *vectors;
    // Number of cells: `size[0] * size[1]`.
    size_t n_vectors;
    // Cells across and down.
    uint32_t size[2];
    // Pixels for a cell.
    float cell;
    // 0.
    uint32_t reserved;
} tree_direction_field_columns;

// How traces become a tree. Begin with `tree_finish_params_init`, which makes it an oak, or with
// `tree_finish_params_find`. What it points at then belongs to the library, lives for ever and is not to be
// written: to alter twigs or leaves, copy them to a struct of your own and point at that.
typedef struct tree_finish_params {
    // `sizeof(tree_finish_params)`.
    size_t struct_size;
    // How thick branches are: a rule of the kind `TREE_RADII_PIPE`. Without a `trunk_radius` that seen in
    // the pictures is taken, and where they show no bare trunk, `slenderness`. NULL for the default: an
    // exponent of 2.49.
    const struct tree_radius_rule *radii;
    // Twigs on the ends of the traces; NULL for none. Default those of an oak.
    const struct tree_twig_params *twigs;
    // Leaves; NULL for a bare tree. Default sprays of an oak's leaves.
    const struct tree_leaf_params *leaves;
    // Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
    // name.
    const struct tree_species *species;
    // Passes of smoothing along branches, 0 to 100. Default 4.
    uint32_t smoothing;
    // Nodes nearer to the one below than this share of the tree's height are left out, 0 to 0.1. Default
    // 0.005.
    float spacing;
    // Radius of the trunk as a share of the height where nothing tells it, 1e-4 to 0.2. Default 0.017.
    float slenderness;
    // Area of a blade as a share of its length squared, 1e-3 to 2: how much a leaf covers, and so how many
    // it takes. Default 0.333, an oak's spray; an oak leaf has 0.28, a needle 0.04.
    float blade;
    // Leaves against what the pictures ask for, 0 to 10. Default 1.
    float fullness;
    // Times the leaves are counted in the pictures and their density put right, 0 to 10. Default 3.
    uint32_t corrections;
    // Leaves and twigs where a picture's matte is below this are discarded, 0 (none) to 1. Default 0.5.
    float empty;
    // 0.
    uint32_t reserved;
} tree_finish_params;

// What growing twigs and leaves did.
typedef struct tree_crown_report {
    // `sizeof(tree_crown_report)`.
    size_t struct_size;
    // Nodes of twigs.
    uint64_t n_twig_nodes;
    // Nodes of twigs cut off because they reached where a picture is empty.
    uint64_t n_twig_nodes_cut;
    // Leaves (blades) that stayed.
    uint64_t n_leaves;
    // Leaves discarded because a picture is empty there.
    uint64_t n_leaves_discarded;
    // Leaves the pictures ask for, as far as the last correction knows.
    double leaves_asked;
} tree_crown_report;

// How particles move and join. Lengths are shares of the tree's height, so that the same numbers do for a
// shrub and a giant. Begin with `tree_flow_params_init`.
typedef struct tree_flow_params {
    // `sizeof(tree_flow_params)`.
    size_t struct_size;
    // Particles, 1 to 10 million: 500 to 1000 for trees of medium size, 1000 to 2000 for large ones.
    // Default 1500. Cost grows a little more than linearly.
    uint32_t particles;
    // Steps after which particles still on their way are steered straight to the base, 1 to 100,000.
    // Default 200.
    uint32_t steps;
    // Way of a particle in one step, 1e-4 to 0.1. Default 0.008. Smaller is smoother and slower.
    float step;
    // Particles nearer than this join, 1e-5 to 0.2. Default 0.02. Larger gives fewer, longer branches.
    float join;
    // How far a particle sees its nearest neighbour, 0 to 1. Default 0.1.
    float sight;
    // Pull along the pictures' direction fields, 0 to 10. Default 1. The pulls decide the direction only,
    // so just their proportions matter.
    float image;
    // Pull towards the base, through the densest way, 0 to 10. Default 0.3. Where no field says anything
    // it counts in full.
    float base;
    // Pull of the nearest neighbour when it is close, 0 to 10. Default 0.7. Larger joins twigs sooner.
    float neighbour;
    // Way on which a lone particle turns most of the way into a new direction, 1e-4 to 1. Default 0.012.
    float turn;
    // How much more reluctant joined particles are: the way of turning grows with mass to this power, 0
    // to 1. Default 0.15.
    float inertia;
    // Cost of the way down the stem against that through the crown, 0.05 to 1 (no stem). Default 0.6.
    // Where no picture shows branches, they leave the stem at the angle whose cosine this is.
    float stem;
    // Least distance between nodes of a trace, 1e-4 to 0.2. Default 0.01.
    float spacing;
    // Error of one step that is tolerated, as a share of `join`, 1e-4 to 1; worse steps are halved.
    // Default 0.03.
    float tolerance;
    // 0.
    uint32_t reserved;
} tree_flow_params;

// A view that steers particles. Begin with `tree_flow_view_init`.
typedef struct tree_flow_view {
    // `sizeof(tree_flow_view)`.
    size_t struct_size;
    // Where its photograph was taken from. No default: NULL, which is refused.
    const struct tree_particle_camera *camera;
    // Where particles go in its picture. No default: NULL, which is refused.
    const struct tree_direction_field *field;
} tree_flow_view;

// What became of the particles.
typedef struct tree_flow_report {
    // `sizeof(tree_flow_report)`.
    size_t struct_size;
    // Parts that the integrator cut all steps of all particles into.
    uint64_t n_parts;
    // Particles that started.
    uint32_t n_particles;
    // Joins of two particles.
    uint32_t n_joins;
    // Particles that joined a trace whose particle had gone on.
    uint32_t n_followed;
    // Particles, after joins, that reached the base on traces of their own.
    uint32_t n_arrived;
    // Particles that were still on their way after `steps` and were steered to the base without heed to
    // the pictures.
    uint32_t n_steered;
    // Particles that could not even be steered and were led straight to the nearest trace.
    uint32_t n_led;
    // Steps taken.
    uint32_t n_steps;
    // 0.
    uint32_t reserved;
} tree_flow_report;

// A view of traces. Nodes are in the order in which they were left behind; node 0 is the base.
typedef struct tree_traces_columns {
    // `sizeof(tree_traces_columns)`.
    size_t struct_size;
    // Number of nodes, at least 1.
    size_t n_nodes;
    // Three floats for each node: where it is, in metres.
    const float *positions;
    // For each node the one it leads to, on the way to the base; `TREE_NO_PARENT` at the base.
    const uint32_t *next;
    // For each node the number of particles whose way led through it.
    const uint32_t *masses;
} tree_traces_columns;

// A view of a grid. Voxel (x, y, z) is row `(z * size[1] + y) * size[0] + x`; its centre is
// `corner + voxel * (x + 0.5, y + 0.5, z + 0.5)`.
typedef struct tree_grid_columns {
    // `sizeof(tree_grid_columns)`.
    size_t struct_size;
    // One for each voxel: x runs fastest, then y, then z.
    const float *values;
    // Number of voxels: `size[0] * size[1] * size[2]`.
    size_t n_values;
    // Lowest corner in metres.
    float corner[3];
    // Side of a voxel in metres.
    float voxel;
    // Voxels along x, y and z.
    uint32_t size[3];
    // 0.
    uint32_t reserved;
} tree_grid_columns;

// Where a photograph was taken from: found in the matte, or as the caller knows. Begin with
// `tree_photo_placing_init`.
typedef struct tree_photo_placing {
    // `sizeof(tree_photo_placing)`.
    size_t struct_size;
    // The camera, where it is known; then the other fields do not count. Default NULL: base, height and
    // scale are found in the matte.
    const struct tree_particle_camera *camera;
    // Where the camera stood around the trunk, in radians: 0, the default, on +Z, a quarter turn on +X.
    float yaw;
    // How far it looked down, in radians, -1.5 to 1.5. Default 0.
    float pitch;
    // Vertical field of view of the whole picture in radians, 0.017 to 2.8; 0, the default, is parallel
    // projection.
    float fov;
    // 0.
    uint32_t reserved;
} tree_photo_placing;

// Strokes over a picture, or other lines of the plane. The points of stroke `i` are rows `starts[i]` up to,
// but not including, `starts[i + 1]`. Set `struct_size` first.
typedef struct tree_strokes_columns {
    // `sizeof(tree_strokes_columns)`.
    size_t struct_size;
    // Number of strokes.
    size_t n_strokes;
    // `n_strokes + 1` numbers: 0 first, none below the one before it, `n_points` last. NULL for no strokes.
    const uint64_t *starts;
    // Number of points of all strokes.
    size_t n_points;
    // Two floats for each point, in pixels from the top left of the picture where nothing else is said.
    const float *points;
} tree_strokes_columns;

// Where a photograph's main branches come from: one of the `TREE_BRANCHES_` constants.
typedef uint32_t tree_branches_kind;

// A photograph's main branches. Begin with `tree_photo_branches_init`.
typedef struct tree_photo_branches {
    // `sizeof(tree_photo_branches)`.
    size_t struct_size;
    // Seeds: two floats for each point, in pixels from the top left. Default NULL.
    const float *seeds;
    // Number of seeds.
    size_t n_seeds;
    // Strokes: as `tree_attractor_from_strokes` takes them. Default NULL.
    const struct tree_strokes_columns *strokes;
    // Graph: the graph. Default NULL.
    const struct tree_attractor *graph;
    // Where they come from. Default `TREE_BRANCHES_LIVEWIRE`.
    tree_branches_kind kind;
    // 0.
    uint32_t reserved;
} tree_photo_branches;

// One photograph as it goes in. Begin with `tree_photo_shot_init`.
typedef struct tree_photo_shot {
    // `sizeof(tree_photo_shot)`.
    size_t struct_size;
    // How much of each pixel the tree covers. No default: NULL, which is refused.
    const struct tree_matte *matte;
    // The photograph, of the same size, where livewire looks for branches. Default NULL: it looks at the
    // matte.
    const struct tree_photo *photo;
    // Where it was taken from. Default NULL: from the front.
    const struct tree_photo_placing *placing;
    // Its main branches. Default NULL: livewire from points on the silhouette.
    const struct tree_photo_branches *branches;
} tree_photo_shot;

// Which points of the silhouette may be seeds. Begin with `tree_seed_params_init`.
typedef struct tree_seed_params {
    // `sizeof(tree_seed_params)`.
    size_t struct_size;
    // Distance that seeds keep from the trunk as a share of the tree's height, 0 to 1. Default 0.08.
    float from_trunk;
    // Lowest height of a seed over the base as a share of the tree's height, -1 to 1. Default 0.05: what
    // hangs lower is left out.
    float lowest;
    // How far the silhouette may face down at a seed, 0 (aside) to 1 (straight down). Default 0.8.
    float downwards;
    // 0.
    uint32_t reserved;
} tree_seed_params;

// How paths are found. Begin with `tree_livewire_params_init`.
typedef struct tree_livewire_params {
    // `sizeof(tree_livewire_params)`.
    size_t struct_size;
    // Rows of pixels over the height of the tree at which paths are sought, 16 to 1024. Default 256. Time
    // and memory (120 bytes a pixel at most) grow with the square.
    uint32_t rows;
    // How closely paths follow visible structures, 0 (not at all) to 0.98. Default 0.88: a step along the
    // clearest branch costs 12 % of one through leaves.
    float follow;
    // Cost of a step outside the tree, in steps inside, 1 to 100. Default 12.
    float outside;
    // How much more a step at the silhouette costs than one in the middle, 0 to 10. Default 4.
    float center;
    // How much more a step costs that leads back towards the base and down than one that leads away from
    // it and up, 0 to 10. Default 0.6.
    float outwards;
    // How much less than a step through leaves one costs along a path found before, 0 (paths do not
    // attract each other) to 0.9. Default 0.3.
    float join;
    // Passes of smoothing over paths of working pixels, 0 to 1000. Default 12.
    uint32_t smoothing;
    // Distance between nodes as a share of the tree's height, 0.001 to 0.5. Default 0.02.
    float spacing;
    // Side branches shorter than this share of the tree's height are left out, 0 to 0.5. Default 0.05.
    float stub;
    // 0.
    uint32_t reserved;
} tree_livewire_params;

// How strokes are cleaned and joined. Begin with `tree_stroke_params_init`.
typedef struct tree_stroke_params {
    // `sizeof(tree_stroke_params)`.
    size_t struct_size;
    // Distance between nodes as a share of the drawing's size, 0.001 to 0.5. Default 0.02.
    float spacing;
    // Gaps up to this share of the drawing's size are closed by moving the stroke's end, 0 to 1; wider
    // ones are bridged by a straight line and reported. Default 0.03.
    float snap;
} tree_stroke_params;

// All parameters of the way from photographs to a tree. A part that is NULL, as all are after
// `tree_photo_params_init`, is its default.
typedef struct tree_photo_params {
    // `sizeof(tree_photo_params)`.
    size_t struct_size;
    // What points on the silhouettes are drawn with. They do not change with the tree's seed: what a
    // photograph shows is the same for all trees made of it. Default 0.
    uint64_t attractor_seed;
    // Which points of a silhouette may be seeds.
    const struct tree_seed_params *seeds;
    // How livewire finds branches.
    const struct tree_livewire_params *livewire;
    // How drawn strokes are joined.
    const struct tree_stroke_params *strokes;
    // How the density is found.
    const struct tree_density_params *density;
    // How branches steer particles.
    const struct tree_field_params *field;
    // How particles move.
    const struct tree_flow_params *flow;
    // How traces become a tree.
    const struct tree_finish_params *finish;
    // Height of the tree in metres, 0.01 to 1000. Default 10.
    float height;
    // Points on each silhouette from which livewire seeks branches, 0 to 10,000. Default 40.
    uint32_t branches;
    // Whether a side is imagined where all photographs are from one side (or its back): the first photograph,
    // mirrored, from a quarter turn round. Without it the depth of the crown is filled evenly. Default 1.
    uint32_t imagine;
    // 0.
    uint32_t reserved;
} tree_photo_params;

// A stage of a session: one of the `TREE_PHOTO_STAGE_` constants, in the order in which they are done.
typedef uint32_t tree_photo_stage;

// What was found, repaired and left out on the way from photographs to a tree. The fields that begin with
// `density_`, `flow_` and `crown_` are those of `tree_density_report`, `tree_flow_report` and
// `tree_crown_report`.
typedef struct tree_photo_report {
    // `sizeof(tree_photo_report)`.
    size_t struct_size;
    // Number of views.
    uint64_t n_views;
    // Number of lines that `tree_photo_session_warnings` gives.
    uint64_t n_warnings;
    // Radius of the trunk that the views show, in metres; 0 where they show no bare trunk.
    float trunk_radius;
    // Height in metres below which no view shows more than the trunk.
    float crown_base;
    // Rays: equations.
    uint64_t density_rays;
    // Voxels that were left after carving: unknowns.
    uint64_t density_voxels;
    // Voxels thrown away by carving.
    uint64_t density_carved;
    // Voxels that no picture shows.
    uint64_t density_unseen;
    // Entries of the system of equations that are not zero.
    uint64_t density_entries;
    // What looking through the density misses of the mattes, as a share.
    double density_residual;
    // Iterations of the solver.
    uint32_t density_iterations;
    // 1 when the density is not final.
    uint32_t density_not_converged;
    // Views that contradict the others.
    uint32_t density_contradictions;
    // Views that are covered all over.
    uint32_t density_opaque;
    // Parts that the integrator cut all steps of all particles into.
    uint64_t flow_parts;
    // Particles that started.
    uint32_t flow_particles;
    // Joins of two particles.
    uint32_t flow_joins;
    // Particles that joined a trace whose particle had gone on.
    uint32_t flow_followed;
    // Particles, after joins, that reached the base on traces of their own.
    uint32_t flow_arrived;
    // Particles that were steered to the base after all steps.
    uint32_t flow_steered;
    // Particles that were led straight to the nearest trace.
    uint32_t flow_led;
    // Steps taken.
    uint32_t flow_steps;
    // 0.
    uint32_t reserved;
    // Nodes of twigs.
    uint64_t crown_twig_nodes;
    // Nodes of twigs cut off because they reached where a picture is empty.
    uint64_t crown_twig_nodes_cut;
    // Leaves (blades) that stayed.
    uint64_t crown_leaves;
    // Leaves discarded because a picture is empty there.
    uint64_t crown_leaves_discarded;
    // Leaves the pictures ask for, as far as the last correction knows.
    double crown_leaves_asked;
} tree_photo_report;

// What may be wrong with an alignment: one of the `TREE_ALIGN_` constants.
typedef uint32_t tree_align_problem;

// What may be wrong with an alignment. Fields that the problem does not name are 0.
typedef struct tree_align_warning {
    // Which problem. New ones may be added.
    tree_align_problem problem;
    // Index into the views.
    uint32_t view;
    // Number of parts.
    uint32_t parts;
    // A share, 0 to 1 or more.
    float found;
    // What is found in most views.
    float usual;
} tree_align_warning;

// What one view gave.
typedef struct tree_photo_view_report {
    // `sizeof(tree_photo_view_report)`.
    size_t struct_size;
    // What looking through the density misses of the view's matte, as a share; 0 where the density came
    // from elsewhere.
    double residual;
    // 1 when the view contradicts the others.
    uint32_t contradicts;
    // 1 when the view is covered all over.
    uint32_t is_opaque;
    // What its alignment is doubtful about: rows of `warnings`. 0 where the caller placed the camera.
    uint32_t n_warnings;
    // 1 when the view gives directions: not without branches.
    uint32_t attracts;
    // 1 when livewire sought branches, and the fields from here to `trunk_width` count.
    uint32_t has_livewire;
    // Seeds that were not finite and left out.
    uint32_t n_bad_seeds;
    // Seeds outside the picture, moved to its border.
    uint32_t n_moved_seeds;
    // Side branches left out as stubs.
    uint32_t n_stubs;
    // Tips of the graph.
    uint32_t n_tips;
    // Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
    float outside;
    // How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
    float evidence;
    // Width of the trunk at its foot in pixels; 0 where no trunk is seen.
    float trunk_width;
    // 1 when strokes were joined, and the fields after it count.
    uint32_t has_strokes;
    // Points left out because they were not finite.
    uint32_t n_bad_points;
    // Strokes left out because they had no length.
    uint32_t n_empty;
    // Strokes that were joined over a gap wider than the snapping distance.
    uint32_t n_bridged;
    // Strokes joined by their middle, in two parts.
    uint32_t n_split;
    // Doubts about its alignment, the first `n_warnings` rows.
    struct tree_align_warning warnings[TREE_ALIGN_WARNINGS];
    // 0.
    uint32_t reserved;
} tree_photo_view_report;

// Makes edges dearer or cheaper inside a volume. Begin with `tree_paint_init`.
typedef struct tree_paint {
    // `sizeof(tree_paint)`.
    size_t struct_size;
    // Where: edges whose middle lies inside. No default: NULL, which is refused.
    const struct tree_volume *volume;
    // Their cost is multiplied by this, 0 to 1000. Below 1 attracts branches, above 1 repels them.
    // Default 1, which changes nothing.
    float factor;
    // 0.
    uint32_t reserved;
} tree_paint;

// A cost factor for a point in space, three floats in metres: finite and 0 or more, or the call fails
// with `TREE_ERROR_PARAMETER`. Called from any thread, by several at once; must not unwind. For the same
// tree each time it must give the same answer to the same point.
typedef float (*tree_cost_fn)(void *user, const float *point);

// How nodes are linked and what edges cost. Begin with `tree_link_params_init`.
typedef struct tree_link_params {
    // `sizeof(tree_link_params)`.
    size_t struct_size;
    // Painted edge costs; where several overlap, they multiply. Default NULL.
    const struct tree_paint *paints;
    // Number of paints, at most 65,536.
    size_t n_paints;
    // A cost factor for every point, multiplied with the paints. Default NULL.
    tree_cost_fn cost;
    // Handed to `cost`.
    void *cost_user;
    // What no edge may pass through. Default NULL.
    const struct tree_volume *obstacle;
    // Distance to keep from the obstacle in metres, 0 or more. Default 0.
    float clearance;
    // Linking distance in separations, 1.2 to 4. Default 2. More links make straighter paths and cost
    // time and memory with the third power; under 1.6 graphs fall apart.
    float reach;
    // An edge costs its length times a random weight from `low` to 1; 0.01 to 1. Default 0.25.
    float low;
    // Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Default 1.
    float bias;
} tree_link_params;

// One direction of an edge.
typedef struct tree_graph_arc {
    // The node it leads to.
    uint32_t to;
    // What it costs, 0 or more.
    float cost;
} tree_graph_arc;

// A view of a graph, as compressed rows: the arcs that leave node `i` are `arcs[starts[i]]` up to, but
// not including, `arcs[starts[i + 1]]`.
typedef struct tree_graph_columns {
    // `sizeof(tree_graph_columns)`.
    size_t struct_size;
    // Number of nodes.
    size_t n_nodes;
    // Three floats for each node, in metres.
    const float *positions;
    // `n_nodes + 1` numbers.
    const uint32_t *starts;
    // Number of arcs: two for each edge.
    size_t n_arcs;
    // The arcs, node by node.
    const struct tree_graph_arc *arcs;
} tree_graph_columns;

// Where random endpoints may lie: one of the `TREE_PATH_PLACING_` constants.
typedef uint32_t tree_path_placing;

// Shape of a subgraph, pointing along its axis from its root: one of the `TREE_PATH_SHAPE_` constants.
typedef uint32_t tree_path_shape;

// Which way the subgraphs of a level point, before the turn: one of the `TREE_PATH_AXIS_` constants.
typedef uint32_t tree_path_axis;

// Subgraphs grown round the endpoints of the level before. Begin with `tree_path_level_init`.
typedef struct tree_path_level {
    // `sizeof(tree_path_level)`.
    size_t struct_size;
    // Custom: any volume, drawn for a root at the origin, axis +Y and radius 1. Default NULL.
    const struct tree_volume *custom;
    // Endpoints in each subgraph, 1 to 10,000. Default 4.
    uint32_t branching;
    // Shape of the subgraphs. Default `TREE_PATH_SHAPE_SECTOR`.
    tree_path_shape shape;
    // Sector: angle from the axis in radians, 0.05 to pi (the whole ball). Default 0.3 pi.
    float angle;
    // Cones: base radius as a share of the height, 0.05 to 5. No default: 0, which is refused.
    float width;
    // Nodes of each subgraph, 8 to `tree_limits.graph_nodes`. Default 110.
    uint32_t graph_nodes;
    // Which way subgraphs point. Default `TREE_PATH_AXIS_OUTWARD`.
    tree_path_axis axis;
    // Fixed axis: its direction, of any length but 0. Default 0, 0, 0, which is refused.
    float direction[3];
    // Turn of the axis about the horizontal in radians, -pi to pi: positive bends branches down,
    // negative up. Default 0.
    float turn;
    // Radius of the subgraphs in metres. Default 0: the one that follows from `size` and `shrink` of the
    // `tree_path_params`.
    float size;
    // Where endpoints may lie. Default `TREE_PATH_PLACING_VOLUME`.
    tree_path_placing placing;
    // Whether subgraphs grow round the endpoints of all levels before, not only the last. Default 0.
    uint32_t from_all_levels;
    // 0.
    uint32_t reserved;
} tree_path_level;

// How many levels a branch goes on for: one of the `TREE_PATH_LIFESPAN_` constants.
typedef uint32_t tree_path_lifespan;

// Everything that shapes a tree of least-cost paths. Lengths in metres, angles in radians. Begin with
// `tree_path_params_init`, which makes it an oak, or with `tree_path_preset`. What the structs of presets
// point at belongs to the library, lives for ever and is not to be written: to alter levels, copy them
// to an array of your own and point at that.
typedef struct tree_path_params {
    // `sizeof(tree_path_params)`.
    size_t struct_size;
    // The volume of level 1: trunk and crown, or root ball; bounded. It decides the shape of the tree
    // more than all else. Oak: a trunk of 3 m under a round crown, 10.4 m high.
    const struct tree_volume *volume;
    // Where all paths end; inside `volume` or within linking distance. Oak: the origin.
    float root[3];
    // Nodes of the level 1 graph, 8 to `tree_limits.graph_nodes`; the graph has this many within about a
    // tenth. More make branches finer and cost time in proportion. Oak: 5000.
    uint32_t graph_nodes;
    // Endpoints of level 1 drawn at random, at most 10,000. Oak: 24.
    uint32_t endpoints_random;
    // Where random endpoints may lie. Oak: `TREE_PATH_PLACING_VOLUME`.
    tree_path_placing endpoints_placing;
    // Candidates drawn for each random endpoint, of which the one farthest from all others is taken, 1
    // to 64. More spread the branches evenly and cost time with the square of `endpoints_random`. Oak: 4.
    uint32_t endpoints_candidates;
    // Random endpoints lie above this share of the volume's height, 0 to 0.95; keeps main branches off
    // the trunk. Oak: 0.25.
    float endpoints_above;
    // Endpoints placed by hand, three floats each. Oak: NULL.
    const float *placed;
    // Number of endpoints placed by hand.
    size_t n_placed;
    // Radius of the subgraphs of level 2 in metres, above 0. Oak: 2.2.
    float size;
    // Ratio of the subgraph radii of successive levels, 0.05 to 2. Oak: 0.62.
    float shrink;
    // Levels 2 and on. Oak: three.
    const struct tree_path_level *levels;
    // Number of those levels, at most 16.
    size_t n_levels;
    // How long branches live. Oak: `TREE_PATH_LIFESPAN_FULL`.
    tree_path_lifespan lifespan;
    // Random lifespan: chance to end at each level, 0 to 1; the authors use 0.3. Oak: 0.
    float lifespan_stop;
    // Linking distance in separations, 1.2 to 4. Oak: 2. More links make straighter paths and cost time
    // and memory with the third power; under 1.6 graphs fall apart.
    float linking_reach;
    // An edge costs its length times a random weight from this to 1; 0.01 to 1. Low values make crooked
    // branches that run together, 1 makes straight ones. Oak: 0.2.
    float linking_low;
    // Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Above 1 cheap edges
    // are many, below 1 few. Oak: 1.
    float linking_bias;
    // Smoothing passes over the branches, 0 to 50; each takes away some of the zigzag from node to node.
    // Oak: 3.
    uint32_t smoothing;
    // Painted edge costs; where several overlap, they multiply. Oak: NULL.
    const struct tree_paint *paints;
    // Number of paints, at most 65,536.
    size_t n_paints;
    // A cost factor for every point, multiplied with the paints. Oak: NULL.
    tree_cost_fn cost;
    // Handed to `cost`.
    void *cost_user;
    // What no path may enter. Oak: NULL.
    const struct tree_volume *obstacle;
    // How thick branches are; NULL for the defaults of `tree_radius_rule_init`. Oak: the pipe model,
    // scaled to its trunk.
    const struct tree_radius_rule *radii;
    // Leaves; NULL for none. Oak: clusters of oak leaves.
    const struct tree_leaf_params *leaves;
    // Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
    // name.
    const struct tree_species *species;
    // A root system, grown by the same method from the same root. Its own `root` and `leaves` are
    // ignored; its own `roots` must be NULL. Oak: NULL.
    const struct tree_path_params *roots;
    // Distance to keep from the obstacle in metres, 0 or more. Oak: 0.
    float clearance;
    // 0.
    uint32_t reserved;
} tree_path_params;

// What one level took, and what it left out.
typedef struct tree_path_level_report {
    // Graphs searched.
    uint64_t n_graphs;
    // Nodes in them.
    uint64_t n_graph_nodes;
    // Arcs in them: two for each edge.
    uint64_t n_graph_arcs;
    // Nodes no path led to.
    uint64_t n_stray_nodes;
    // Graphs that fell apart at the linking distance asked for and were linked again with a longer one.
    uint64_t n_widened;
    // Bytes of the largest single graph.
    uint64_t largest_bytes;
    // Endpoints reached.
    uint64_t n_endpoints;
    // Random endpoints asked for that the graphs had no nodes for.
    uint64_t n_missing;
    // Endpoints of the levels before from which nothing grew, because an obstacle left no room or a
    // narrow subgraph did not hang together.
    uint64_t n_stunted;
    // Endpoints of the level before whose lifespan had ended.
    uint64_t n_ended;
} tree_path_level_report;

// What growing a tree took, and what it left out.
typedef struct tree_path_report {
    // `sizeof(tree_path_report)`.
    size_t struct_size;
    // All levels together, roots included.
    struct tree_path_level_report total;
    // Number of levels of the tree.
    uint64_t n_levels;
    // Number of levels of its root system.
    uint64_t n_root_levels;
    // A row for each level of the tree, the first for the base volume.
    struct tree_path_level_report levels[TREE_PATH_REPORT_LEVELS];
    // A row for each level of its root system.
    struct tree_path_level_report root_levels[TREE_PATH_REPORT_LEVELS];
} tree_path_report;

// Which nodes are strewn. Begin with `tree_strew_params_init`.
typedef struct tree_strew_params {
    // `sizeof(tree_strew_params)`.
    size_t struct_size;
    // Where there are no nodes. Default NULL.
    const struct tree_volume *obstacle;
    // Points that become nodes wherever they lie, three floats each. Default NULL.
    const float *forced;
    // Number of those points.
    size_t n_forced;
    // Distance to keep from the obstacle in metres, 0 or more. Default 0.
    float clearance;
    // Nodes wanted, at most `tree_limits.graph_nodes`; there will be this many within about a tenth, and
    // up to 2.8 times as many in a volume thinner than their distance. Default 5000, as for an oak.
    uint32_t n_nodes;
} tree_strew_params;

// A view of strewn nodes.
typedef struct tree_graph_nodes_columns {
    // `sizeof(tree_graph_nodes_columns)`.
    size_t struct_size;
    // Number of nodes.
    size_t n_nodes;
    // Three floats for each node, in metres.
    const float *positions;
    // Number of forced points.
    size_t n_forced;
    // For each forced point its node.
    const uint32_t *forced;
    // No two nodes are closer than this, in metres; forced ones may be.
    float separation;
    // 0.
    uint32_t reserved;
} tree_graph_nodes_columns;

// How a drawing becomes a profile. Begin with `tree_profile_options_init`.
typedef struct tree_profile_options {
    // `sizeof(tree_profile_options)`.
    size_t struct_size;
    // Height of the tree in metres, 0.01 to 10,000. Default 10.
    float height;
    // Factor on all radii, 0.01 to 100. Default 1.
    float widen;
} tree_profile_options;

// A view of a profile.
typedef struct tree_profile_columns {
    // `sizeof(tree_profile_columns)`.
    size_t struct_size;
    // Number of points.
    size_t n_points;
    // Two floats for each point, in metres: radius and height. `tree_volume_revolution` takes them.
    const float *points;
    // Whether it was taken from a closed outline: 1 or 0.
    uint32_t from_outline;
    // 0.
    uint32_t reserved;
} tree_profile_columns;

// What is known about a photograph. Begin with `tree_align_params_init`.
typedef struct tree_align_params {
    // `sizeof(tree_align_params)`.
    size_t struct_size;
    // Height of the tree in metres, 0.01 to 1000. Default 10. `tree_align_all` takes its own.
    float height;
    // See `tree_particle_camera`. Default 0.
    float yaw;
    // See `tree_particle_camera`. Default 0.
    float pitch;
    // See `tree_particle_camera`. Default 0: parallel projection.
    float fov;
} tree_align_params;

// What was found in a matte. Lengths are in pixels from the top left.
typedef struct tree_align_report {
    // `sizeof(tree_align_report)`.
    size_t struct_size;
    // The foot of the trunk.
    float base[2];
    // The highest point of the tree.
    float top[2];
    // Top left corner of the crown.
    float crown_low[2];
    // Bottom right corner of the crown.
    float crown_high[2];
    // The row where the crown begins: between it and the base the trunk is bare. The base's row where no
    // bare trunk shows.
    float crown_base;
    // Width of the bare trunk at about breast height (1.3 m); 0 where none shows.
    float trunk_width;
    // Number of warnings.
    uint32_t n_warnings;
    // What may be wrong; `tree_align_warnings_text` puts it into words.
    struct tree_align_warning warnings[TREE_ALIGN_WARNINGS];
    // 0.
    uint32_t reserved;
} tree_align_report;

// The columns of an attractor graph. Set `struct_size` first.
typedef struct tree_attractor_columns {
    // `sizeof(tree_attractor_columns)`.
    size_t struct_size;
    // Number of nodes.
    size_t n_nodes;
    // Two floats for each node, in pixels from the top left of the picture. Finite.
    const float *positions;
    // For each node the one that it leads to, nearer to the base, which comes before it; `TREE_NO_PARENT`
    // at the base.
    const uint32_t *parents;
} tree_attractor_columns;

// The point of a graph that is nearest to another.
typedef struct tree_attractor_nearest_point {
    // `sizeof(tree_attractor_nearest_point)`.
    size_t struct_size;
    // Whether there is one, 1 or 0: a graph without segments has none, a point that is not finite neither.
    uint32_t found;
    // The node at the upper end of the segment it lies on.
    uint32_t node;
    // Where on the segment: 0 at the parent, 1 at the node.
    float share;
    // The point, in pixels.
    float point[2];
    // How far off it is, in pixels.
    float distance;
} tree_attractor_nearest_point;

// How a matte is found with a trimap. Begin with `tree_natural_params_init`.
typedef struct tree_natural_params {
    // `sizeof(tree_natural_params)`.
    size_t struct_size;
    // Longer side in pixels at which alpha is solved for, 16 to 4096. Default 768. Cost and memory grow
    // with its square.
    uint32_t max_side;
    // How far alpha may depart from a linear function of colour within a window, 1e-9 to 1: a variance of
    // colours 0 to 1. Low keeps fine structure, high is smooth. Default 1e-7.
    float epsilon;
    // Share of the right side's size at which the solution is good enough, 1e-8 to 0.1. Default 2e-4.
    float tolerance;
    // Most iterations at each size, 1 to 100,000. Default 400.
    uint32_t max_iterations;
    // Whether unknown pixels that clearly look like the known ones of one side count as known. Default 1;
    // helps strokes much, full trimaps a little.
    uint32_t mark_clear;
    // 0.
    uint32_t reserved;
} tree_natural_params;

// How a tree against sky is found. Begin with `tree_automatic_params_init`.
typedef struct tree_automatic_params {
    // `sizeof(tree_automatic_params)`.
    size_t struct_size;
    // How the alpha of the pixels left unknown is found. Default NULL: that of `tree_natural_params_init`.
    const struct tree_natural_params *natural;
} tree_automatic_params;

// What was found in a photograph of a tree against sky.
typedef struct tree_automatic_report {
    // `sizeof(tree_automatic_report)`.
    size_t struct_size;
    // Whether the photograph's own alpha was taken, 1 or 0.
    uint32_t has_alpha;
    // Whether the place where the trunk meets the ground was found, 1 or 0.
    uint32_t has_base;
    // That place, in pixels of the photograph from the top left.
    float base[2];
    // How sure the result is, 0 to 1: below 0.5 look at it before you use it.
    float confidence;
    // Width at which alpha was solved for, in pixels; 0 where the photograph has alpha.
    uint32_t width;
    // Height at which alpha was solved for, in pixels.
    uint32_t height;
    // Iterations at that size.
    uint32_t iterations;
    // Pixels that the trimap leaves unknown, at that size.
    uint64_t n_unknown;
    // Of them, pixels marked by their colour.
    uint64_t n_marked;
    // What is left of the right side, as a share.
    float residual;
    // 0.
    uint32_t reserved;
} tree_automatic_report;

// What is drawn: one of the `TREE_MARK_` constants.
typedef uint32_t tree_mark_kind;

// Something drawn onto a photograph. Coordinates are pixels from the top left; what lies outside is cut
// off, and what is not finite is left out.
typedef struct tree_mark {
    // What it is.
    tree_mark_kind kind;
    // Where it begins.
    float from[2];
    // Where it ends.
    float to[2];
    // Width of a line, or a dot's diameter, in pixels.
    float width;
    // Its colour, as `0xRRGGBBAA`: red, green, blue (sRGB) and how much it covers, 0 to 255 each.
    uint32_t color;
} tree_mark;

// What became of strokes.
typedef struct tree_stroke_report {
    // `sizeof(tree_stroke_report)`.
    size_t struct_size;
    // Points left out because they were not finite.
    uint32_t n_bad_points;
    // Strokes left out because they had no length.
    uint32_t n_empty;
    // Strokes that were joined over a gap wider than the snapping distance.
    uint32_t n_bridged;
    // Strokes joined by their middle, in two parts.
    uint32_t n_split;
} tree_stroke_report;

// What happens to what erasing cuts off from the base: one of the `TREE_CUT_OFF_` constants.
typedef uint32_t tree_cut_off;

// What erasing did.
typedef struct tree_erase_report {
    // `sizeof(tree_erase_report)`.
    size_t struct_size;
    // Segments under the eraser.
    uint32_t n_erased;
    // Segments that went because they were cut off.
    uint32_t n_dropped;
    // Parts that were cut off and joined again.
    uint32_t n_reconnected;
    // 0.
    uint32_t reserved;
} tree_erase_report;

// What livewire found.
typedef struct tree_livewire_report {
    // `sizeof(tree_livewire_report)`.
    size_t struct_size;
    // Seeds that were not finite and left out.
    uint32_t n_bad_seeds;
    // Seeds outside the picture, moved to its border.
    uint32_t n_moved_seeds;
    // Side branches left out as stubs.
    uint32_t n_stubs;
    // Tips of the graph.
    uint32_t n_tips;
    // Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
    float outside;
    // How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
    float evidence;
    // Width of the trunk at its foot in pixels; 0 where no trunk is seen.
    float trunk_width;
    // 0.
    uint32_t reserved;
} tree_livewire_report;

// A view of a matte. Pixel 0 is at the top left; its area runs from (0, 0) to (1, 1), so its centre is
// (0.5, 0.5), as everywhere where pixels are counted with fractions.
typedef struct tree_matte_columns {
    // `sizeof(tree_matte_columns)`.
    size_t struct_size;
    // Width in pixels.
    uint32_t width;
    // Height in pixels.
    uint32_t height;
    // One float for each pixel, rows from top to bottom: 0 is empty, 1 is full.
    const float *alpha;
    // Number of pixels: `width * height`.
    size_t n_pixels;
    // Covered area in pixels.
    double area;
} tree_matte_columns;

// What matting with a trimap did.
typedef struct tree_natural_report {
    // `sizeof(tree_natural_report)`.
    size_t struct_size;
    // Pixels that the trimap leaves unknown, at the size at which alpha was solved for.
    uint64_t n_unknown;
    // Of them, pixels marked by their colour.
    uint64_t n_marked;
    // That size: width and height in pixels.
    uint32_t size[2];
    // Iterations at that size; coarser ones cost little.
    uint32_t iterations;
    // What is left of the right side, as a share.
    float residual;
} tree_natural_report;

// Colour of the screen behind a tree: one of the `TREE_SCREEN_` constants.
typedef uint32_t tree_screen_color;

// How a screen is found. Begin with `tree_screen_params_init`.
typedef struct tree_screen_params {
    // `sizeof(tree_screen_params)`.
    size_t struct_size;
    // Colour of the screen. Default `TREE_SCREEN_BLUE`.
    tree_screen_color color;
    // How fast alpha falls with the surplus of the screen's colour, 0 to 100. 1 over the surplus of the bare
    // screen makes that fully transparent. Default 2.
    float gain;
    // How much of the screen's colour a pixel of the tree may hold for each part of the other one (green
    // for blue, blue for green), 0 to 10. Default 1.
    float balance;
    // 0.
    uint32_t reserved;
} tree_screen_params;

// How a tree is told from a picture without it. Begin with `tree_difference_params_init`.
typedef struct tree_difference_params {
    // `sizeof(tree_difference_params)`.
    size_t struct_size;
    // Difference of colours at which a pixel is half tree: distance in the RGB cube of side 1, 0 to 2.
    // Default 0.15.
    float threshold;
    // Width of the soft step around the threshold, 0 (hard) to 2. Default 0.15.
    float softness;
} tree_difference_params;

// A camera as renderers want it: what it shows is what `tree_particle_camera_project` gives.
typedef struct tree_particle_stand {
    // `sizeof(tree_particle_stand)`.
    size_t struct_size;
    // Where it stands, in metres. A parallel one stands far enough off.
    float eye[3];
    // What is in the middle of the picture.
    float target[3];
    // Which way is up.
    float up[3];
    // Vertical field of view in radians; 0 for parallel projection.
    float fov;
    // Height of the picture in metres, at the target.
    float height;
    // 0.
    uint32_t reserved;
} tree_particle_stand;

// A scribble over a photograph. Begin with `tree_trimap_stroke_init`.
typedef struct tree_trimap_stroke {
    // `sizeof(tree_trimap_stroke)`.
    size_t struct_size;
    // Its course: two floats for each point, in pixels from the top left corner. One point makes a dot.
    const float *points;
    // Number of points. Default 0.
    size_t n_points;
    // Its width in pixels, above 0 to 1e6. Default 1.
    float width;
    // Whether it marks the tree; otherwise the background. Default 0.
    uint32_t foreground;
} tree_trimap_stroke;

// Colours picked from a photograph. Begin with `tree_color_samples_init`.
typedef struct tree_color_samples {
    // `sizeof(tree_color_samples)`.
    size_t struct_size;
    // Colours of the tree: three bytes each, red, green and blue (sRGB).
    const uint8_t *foreground;
    // Number of colours of the tree; at least 1.
    size_t n_foreground;
    // Colours of the background.
    const uint8_t *background;
    // Number of colours of the background; at least 1.
    size_t n_background;
    // Pixels within this distance of a sample are known: a distance in the RGB cube of side 255, 0 to 442.
    // Default 24.
    float tolerance;
    // 0.
    uint32_t reserved;
} tree_color_samples;

// A view of a trimap.
typedef struct tree_trimap_columns {
    // `sizeof(tree_trimap_columns)`.
    size_t struct_size;
    // Width in pixels.
    uint32_t width;
    // Height in pixels.
    uint32_t height;
    // A `TREE_LEVEL_` constant for each pixel, rows from top to bottom.
    const uint8_t *levels;
    // Number of pixels: `width * height`.
    size_t n_pixels;
    // Pixels that are certainly not the tree.
    size_t n_background;
    // Pixels to be found.
    size_t n_unknown;
    // Pixels that are certainly the tree.
    size_t n_foreground;
} tree_trimap_columns;

// What happened to a tree.
typedef struct tree_adapted_report {
    // `sizeof(tree_adapted_report)`.
    size_t struct_size;
    // Main nodes that died.
    uint64_t n_pruned;
    // Nodes of branchlets left out, with their branch, in the dark, or in a solid.
    uint64_t n_branchlets_dropped;
    // Nodes of branchlets set once more in the light.
    uint64_t n_branchlets_added;
    // Leaves left out.
    uint64_t n_leaves_dropped;
    // Leaves set once more.
    uint64_t n_leaves_added;
    // Farthest that a living node moved, in metres.
    float farthest;
    // 0.
    uint32_t reserved;
} tree_adapted_report;

// A view of what became of the nodes of the input.
typedef struct tree_adapted_columns {
    // `sizeof(tree_adapted_columns)`.
    size_t struct_size;
    // Number of nodes of the tree.
    size_t n_nodes;
    // One for each node of the tree: the node of the input that it comes from.
    const uint32_t *source;
    // Number of nodes of the input.
    size_t n_input_nodes;
    // One for each node of the input: how far it moved, in metres; for those that are gone, how far they would have.
    const float *moved;
    // One for each node of the input: the season in which its branch died, or `TREE_PLASTIC_ALIVE`.
    const uint32_t *died;
} tree_adapted_columns;

// How a tree is analysed. Begin with `tree_plastic_params_init`.
typedef struct tree_plastic_params {
    // `sizeof(tree_plastic_params)`.
    size_t struct_size;
    // Branches at least this share of the trunk's radius are bent and pruned one by one; thinner ones follow them as
    // branchlets, 0 to 1. Default 0.04. At 0 every node takes part.
    float main;
    // Length of an internode in metres, above 0 to 1e6. Default 0: the commonest distance between forks.
    float internode;
    // Most seasons that are told apart, 1 to 200. Default 40. A tree that has more is told them several at a time.
    uint32_t seasons;
    // Extent of a leaf cluster along the branches, as a share of the longest way from the root to a tip, 0.02 to 1.
    // Default 0.2. Smaller ones follow the light more finely; the cost grows with the square of their number.
    float lobe;
    // Share of the light that one metre of leaf cluster lets through, 0 to 1. Default 0.5.
    float translucency;
    // Strength of phototropism over one internode, 0 to 0.9. Default 0.25.
    float phototropism;
    // Strength of gravitropism over one internode, -0.9 (down) to 0.9 (up). Default 0.12. The two strengths together stay
    // under 0.95.
    float gravitropism;
    // The sky the tree grew under: direction to its brightest point, as in `tree_plastic_sky`. Default 0, 1, 0.
    float sky_light[3];
    // Factor on all its light, 0 to 10. Default 1.
    float sky_brightness;
    // 0.
    uint32_t reserved;
} tree_plastic_params;

// What was found in a tree.
typedef struct tree_plastic_report {
    // `sizeof(tree_plastic_report)`.
    size_t struct_size;
    // Nodes of the main branches.
    uint64_t n_main_nodes;
    // Nodes that follow them.
    uint64_t n_branchlet_nodes;
    // Leaf clusters of the last season.
    uint64_t n_clusters;
    // Seasons the tree lived.
    uint32_t n_seasons;
    // Length of an internode in metres.
    float internode;
    // How far the middle of the crown leans from above the base, in radians.
    float lean;
    // 1 where it leans so far that it cannot have grown alone in the open: a warning. The analysis takes a tree for one
    // that did, and so this one keeps its lean whatever it reacts to. Else 0.
    uint32_t already_bent;
} tree_plastic_report;

// A view of what is known of each node of a tree that can react.
typedef struct tree_plastic_columns {
    // `sizeof(tree_plastic_columns)`.
    size_t struct_size;
    // Number of nodes of the tree's skeleton.
    size_t n_nodes;
    // A byte for each node: 1 for main branches, 0 for branchlets, which follow the main branch below.
    const uint8_t *is_main;
    // One for each node: the season in which it grew, from 0; that of the main branch below for branchlets.
    const uint16_t *seasons;
    // Three floats for each node: the direction in which its segment would have grown without tropisms, of length 1 or
    // more; that of the main branch below for branchlets.
    const float *own_directions;
    // One for each node: the least light per metre on which the branch that starts there is known to live; -1 where no
    // branch starts that could be pruned.
    const float *pruning_factors;
} tree_plastic_columns;

// A leaf cluster: a ball that lets a share of the light through, and the light at its middle.
typedef struct tree_plastic_cluster {
    // Its middle in metres, in the tree's own frame.
    float center[3];
    // In metres.
    float radius;
    // Share of the light that comes through, 0 to 1.
    float translucency;
    // Light at its middle, as a share of the open sky's, 0 to 1 times the brightness.
    float light;
    // Unit vector towards where the light comes from on average; 0 where there is none.
    float towards[3];
    // Tips of main branches that it is made of; 0 in a scene, where that is not told.
    uint32_t n_tips;
} tree_plastic_cluster;

// Where something stands and how it is turned: a point p of its own frame is at rotation · p + position in the world.
typedef struct tree_pose {
    // In metres, at most 1,000 km from the origin along each axis.
    float position[3];
    // A quaternion, x, y, z, w, of any length but 0. 0, 0, 0, 1 is not turned.
    float rotation[4];
} tree_pose;

// How a node of the input stands: what belonged to it at p is at p + moved + (rotation (p - node) - (p - node)), in the tree's
// own frame.
typedef struct tree_plastic_motion {
    // How far it moved, in metres.
    float moved[3];
    // How far its segment turned: a unit quaternion, x, y, z, w.
    float rotation[4];
    // 1 where the branch that carries it lives, else 0.
    uint32_t alive;
} tree_plastic_motion;

// The light of the sky: cos² of the angle to its brightest point, 0 beyond a right angle and below the horizon. Begin
// with `tree_plastic_sky_init` or `tree_plastic_sky_towards`.
typedef struct tree_plastic_sky {
    // `sizeof(tree_plastic_sky)`.
    size_t struct_size;
    // Direction to the brightest point, of any length but 0, not below the horizon. Default 0, 1, 0.
    float light[3];
    // Factor on all light, 0 to 10. Default 1. At 0 every branch starves but the trunk.
    float brightness;
} tree_plastic_sky;

// How much trees react. Begin with `tree_plastic_response_init`.
typedef struct tree_plastic_response {
    // `sizeof(tree_plastic_response)`.
    size_t struct_size;
    // Share of the bending that tropisms ask for, 0 (none) to 1 (all of it). Default 1.
    float bending;
    // Strength of pruning, 0 (none) to 1. Default 0.8: a branch dies when it has less than 0.8 of the light per length on
    // which it is known to have lived.
    float pruning;
    // How strongly the foliage follows the light, 0 (not at all) to 4. Default 1: half the light, half the branchlets.
    float density;
    // 0.
    uint32_t reserved;
} tree_plastic_response;

// How new branches grow. Begin with `tree_plastic_regrowth_init`, or `tree_plastic_regrowth_of` for the measure of a tree.
typedef struct tree_plastic_regrowth {
    // `sizeof(tree_plastic_regrowth)`.
    size_t struct_size;
    // Their kind; NULL for that of `tree_growth_habit_init` with the internode below. Default NULL.
    const struct tree_growth_habit *habit;
    // Without `habit`: length of an internode in metres, 0.001 to 100. Default 0.12.
    float internode;
    // Without `habit`: whether new branches are bare. Default 0: they bear leaves.
    uint32_t bare;
    // Edge of a voxel of shadow in metres, 0.001 to 100. Default 0.2.
    float shadow_voxel;
    // Shadow in the voxel of the one who casts it, 0 to 4. Default 0.12.
    float shadow_strength;
    // What divides the shadow with each layer down, 1 to 10. Default 1.4.
    float shadow_falloff;
    // Layers below its own that a metamer shades, 0 to 32. Default 7.
    uint32_t shadow_depth;
    // How many voxels a bud looks around for the brighter side, 1 to 8. Default 3.
    uint32_t shadow_reach;
    // Iterations they grow for, 0 to 100. Default 6.
    uint32_t years;
    // Least light where the old branch stood, as a share of the open sky's, 0 to 1. Default 0.4.
    float light;
    // Least distance between two new branches in metres, 0 to 1000. Default 0.4.
    float spacing;
    // Most new branches, 0 to 10,000. Default 64.
    uint32_t most;
    // 0.
    uint32_t reserved;
} tree_plastic_regrowth;

// What has grown.
typedef struct tree_plastic_regrown {
    // `sizeof(tree_plastic_regrown)`.
    size_t struct_size;
    // Nodes of the adapted tree, which come first; all others are new.
    uint64_t n_adapted;
    // New branches.
    uint64_t n_branches;
    // Living main nodes that had lost a branch.
    uint64_t n_stumps;
} tree_plastic_regrown;

// What an update did.
typedef struct tree_plastic_update {
    // `sizeof(tree_plastic_update)`.
    size_t struct_size;
    // Trees that are not what they were, or get another light: `tree_plastic_scene_changed` tells which.
    uint64_t n_changed;
    // Trees that were looked at.
    uint64_t n_touched;
    // Seasons of trees whose light was worked out anew.
    uint64_t n_seasons;
} tree_plastic_update;

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
    // 0.
    uint32_t reserved;
    // Bytes of stack of each thread that the library starts. Default 0: the system's.
    size_t stack_size;
    // Gives the pool the host's own threads, for instance long-running jobs of its job system, each for
    // the pool's whole life. Default NULL: the library starts threads.
    tree_spawn_fn spawn;
    // Handed to `spawn`.
    void *user;
} tree_pool_options;

// A view of a mask.
typedef struct tree_mask_columns {
    // `sizeof(tree_mask_columns)`.
    size_t struct_size;
    // Width in pixels.
    uint32_t width;
    // Height in pixels.
    uint32_t height;
    // One byte for each pixel, rows from top to bottom: 0 is empty, 255 is full.
    const uint8_t *coverage;
    // Number of pixels: `width * height`.
    size_t n_pixels;
    // Covered area in pixels.
    double area;
} tree_mask_columns;

// What is behind the mesh, and the light that comes from there: one of the `TREE_BACKDROP_` constants.
typedef uint32_t tree_backdrop;

// Light, ground and backdrop of a picture. Begin with `tree_style_init`, a clear day on grass, or
// `tree_style_studio`.
typedef struct tree_style {
    // `sizeof(tree_style)`.
    size_t struct_size;
    // Where the sun stands around the trunk, in radians, as `yaw` of a view: 0 on +Z, a quarter turn on
    // +X. Finite; default -0.35.
    float sun_yaw;
    // Height of the sun over the horizon in radians, 0.05 to pi/2. Default 0.85.
    float sun_pitch;
    // Strength of the sun, 0 (none) to 100. Default 2.3.
    float sun;
    // Strength of the sky, 0 (none) to 100. Default 1.
    float sky;
    // What the light is multiplied with before the tone curve, 0.01 to 100. Default 1.
    float exposure;
    // Sharpness of the sun's shadows: about this many texels squared, 16 to 8192. Cost grows with the
    // square. Default 2048.
    uint32_t sun_map_px;
    // From how many directions sky light is taken, 0 (unhindered everywhere) to 64. More gives smoother
    // shade at a cost of one pass over all triangles each. Default 12.
    uint32_t sky_directions;
    // Sharpness of the sky's shade: texels squared per direction, 16 to 2048. Default 256.
    uint32_t sky_map_px;
    // What is behind the mesh. Default `TREE_BACKDROP_SKY`.
    tree_backdrop backdrop;
    // Whether there is an endless ground; without, roots stay visible. Default 1.
    uint32_t has_ground;
    // Height of the ground in metres, -1e6 to 1e6. Default 0, the base of the tree.
    float ground;
    // Linear colour of the ground, 0 to 1 each; varied a little over the ground under
    // `TREE_BACKDROP_SKY`. Default 0.075, 0.098, 0.032.
    float ground_color[3];
} tree_style;

// How places are found. Begin with `tree_gibbs_params_init`.
typedef struct tree_gibbs_params {
    // `sizeof(tree_gibbs_params)`.
    size_t struct_size;
    // How quickly branches stop to keep others away, 0 to 1000 for a distance of the whole length. Default 20.
    float reach;
    // Weight of closeness, 0 to 1000. Default 2.
    float closeness;
    // Weight of the pattern, 0 to 1000. Default 1.
    float pattern;
    // Most moves, 0 to 1,000,000. Default 3000.
    uint32_t moves;
    // The process ends when four moves of each branch lower the cost by less than this share, 0 to 1. Default 0.0001.
    // 0 makes all moves.
    float quiet;
    // How far branches of a node stand off from it along the parent, as a share of the average node length, 0 to 0.5.
    // Default 0.06.
    float scatter;
} tree_gibbs_params;

// Where a branch may stand on its parent.
typedef struct tree_domain {
    // Lowest and highest share of the parent's length, 0 to 1. Equal where the place is given.
    float along[2];
    // First and last azimuth in radians, -1000 to 1000, in the sense that azimuth turns: 0 is the right side of the
    // drawing, π the left. The last may be less than the first (the domain then passes 2π); 2π or more apart is all round.
    float azimuth[2];
} tree_domain;

// A pattern of branches round their parent: a `TREE_ARRANGEMENT_` constant.
typedef uint32_t tree_arrangement_kind;

// How branches are arranged round their parent: in the paper's terms n:φ. A part of other structs; zeros are
// `TREE_ARRANGEMENT_SPREAD`. `tree_arrangement_from_text` fills one in by name.
typedef struct tree_arrangement {
    // Which pattern.
    tree_arrangement_kind kind;
    // Branches at a node, 1 to 64; read for whorls and custom patterns.
    uint32_t per_node;
    // In radians, -2π to 2π: the turn from a node to the next of spirals, whorls and custom patterns, the azimuth
    // of horizontal pairs.
    float angle;
} tree_arrangement;

// How places came about.
typedef struct tree_arranged_report {
    // `sizeof(tree_arranged_report)`.
    size_t struct_size;
    // The total cost of the places.
    float cost;
    // Moves tried.
    uint32_t moves;
    // Moves kept.
    uint32_t accepted;
    // 0.
    uint32_t reserved;
} tree_arranged_report;

// Where a branch stands on its parent.
typedef struct tree_site {
    // Share of the parent's length, 0 to 1.
    float along;
    // Azimuth round the parent in radians, 0 to 2π. 0 is the right side of the drawing, π the left.
    float azimuth;
    // The node it stands at, counted from the parent's base; without a pattern its rank along the parent.
    uint32_t node;
} tree_site;

// How closely branches gather at the privileged positions of a pattern.
typedef struct tree_concentration {
    // `sizeof(tree_concentration)`.
    size_t struct_size;
    // Angles tested.
    uint32_t pairs;
    // Mean resultant length, 0 (evenly about) to 1 (all alike).
    float resultant;
    // Where they gather, as an angle from the privileged position in radians.
    float offset;
    // The probability that chance alone gathers them so closely.
    float p_value;
    // Angles by twelfths of the angle between neighbours at a node, the first bin centred on the privileged position.
    uint32_t histogram[TREE_CONCENTRATION_BINS];
    // 1 where there is a pattern to keep to, else 0.
    uint32_t has_pattern;
    // 1 where the test is passed: angles gather significantly (p below 0.001) and the fullest bin is the first; without a
    // pattern, that they do not gather (p at least 0.05). Else 0.
    uint32_t passes;
} tree_concentration;

// The branching angle function: the angle between a parent's direction and that of its branches where they leave,
// along the parent. Between samples it is interpolated, beyond them it is constant. Begin with
// `tree_branching_angles_init`.
typedef struct tree_branching_angles {
    // `sizeof(tree_branching_angles)`.
    size_t struct_size;
    // Number of samples, at most 10,000; 0 for those of `tree_branching_angles_init`.
    size_t n_samples;
    // Two floats for each: place along the parent, 0 at its base to 1 at its tip, in rising order; and angle in
    // radians, 0 (straight on) to π (backwards). Default 1.35 at the base to 0.6 at the tip: low branches are near
    // horizontal, high ones near upright.
    const float *samples;
} tree_branching_angles;

// How branches are inferred. Begin with `tree_branch_infer_params_init`.
typedef struct tree_branch_infer_params {
    // `sizeof(tree_branch_infer_params)`.
    size_t struct_size;
    // Places along the parent that are tried, 2 to 10,000. Default 48.
    uint32_t places;
    // Points of a branch, 2 to 1000. Default 16.
    uint32_t points;
    // Length of the tangents over the distance of base and end, 0 (straight) to 2. Default 0.5.
    float tangents;
    // 0.
    uint32_t reserved;
} tree_branch_infer_params;

// From where to where a branch runs.
typedef struct tree_branch_span {
    // Where it begins.
    float base[2];
    // Where it ends.
    float end[2];
    // Whether it is on its parent's left side: a shape is mirrored between the sides.
    uint32_t left;
} tree_branch_span;

// What the shape of a branch is like, whatever its size.
typedef struct tree_branch_shape_report {
    // `sizeof(tree_branch_shape_report)`.
    size_t struct_size;
    // The angle in radians from the span to the direction the branch leaves in, positive towards the outer side, away
    // from the parent's tip.
    float leaving;
    // How far its outline reaches along the span, in spans; at least 1.
    float reach;
} tree_branch_shape_report;

// How bumps are found. Begin with `tree_bump_params_init`.
typedef struct tree_bump_params {
    // `sizeof(tree_bump_params)`.
    size_t struct_size;
    // How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10.
    // Between clear valleys half of it is enough, without any it takes twice as much. Default 0.2.
    float prominence;
    // Features that stand out less than this share of the outline's size (the longer side of its box) are no
    // bumps, 0.001 to 0.5. Default 0.02.
    float detail;
} tree_bump_params;

// One bump of an outline: the foliage of one major branch.
typedef struct tree_bump {
    // Its central point, where the branch ends: the middle of a round end, and about the tip of a sharp one.
    float center[2];
    // Its outermost point, on the outline.
    float tip[2];
    // Direction of the chordal axis at the centre, outwards, of unit length.
    float tangent[2];
    // Radius of the disc about the centre that fits into the outline, in metres; about 0 at a sharp feature.
    float radius;
    // The part of the outline that is the bump's: from one length along it, in metres against the clock from its
    // first corner, to another, which is greater than the perimeter where it passes that corner.
    float stretch[2];
} tree_bump;

// How the branches on axes of one level stand, and what they are like where nobody drew any. Begin with
// `tree_silhouette_level_init`.
typedef struct tree_silhouette_level {
    // `sizeof(tree_silhouette_level)`.
    size_t struct_size;
    // Angles where no system of the level was drawn: NULL, the default, for 1.1 at the base and 0.6 at the tip. For the
    // trunk it is `angles` of `tree_silhouette_params` that counts.
    const struct tree_branching_angles *angles;
    // How they are arranged round the axis. Default `TREE_ARRANGEMENT_SPREAD`.
    struct tree_arrangement arrangement;
    // Branches added in space for each one in the plane, 0 to 100. Default 2.
    float density;
    // Branches in the plane on an axis where no system of the level was drawn, 0 to 4000. Default 18.
    uint32_t count;
    // How far branches are turned about their span from base to end, in radians, -2π to 2π: a slight spiral.
    // Default 0, planar.
    float spiral;
    // Variation of lengths, as a share, 0 to 0.9; angles vary by half of that in radians. Default 0.12.
    float jitter;
    // 0.
    uint32_t reserved;
} tree_silhouette_level;

// The leaves. NaN stands for what is to be found in the drawing. Begin with `tree_silhouette_leaves_init`.
typedef struct tree_silhouette_leaves {
    // `sizeof(tree_silhouette_leaves)`.
    size_t struct_size;
    // How they are arranged along a branch. Default the spiral of the golden angle.
    struct tree_arrangement arrangement;
    // Length in metres, 1e-5 to 100. NaN, the default, for that of the drawn leaf, or else what suits the branches that
    // bear them.
    float length;
    // Distance of leaves along a branch in leaf lengths, all sides together, 0.001 to 100. NaN, the default, for what was
    // drawn, or 0.3.
    float spacing;
    // Angle to the branch, 0 to π. NaN, the default, for what was drawn, or 1.
    float angle;
    // Share of the branch that is bare, from its base, 0 to 1. NaN, the default, for what was drawn, or 0.1.
    float bare;
    // Petiole in leaf lengths, 0 to 10. Default 0.05.
    float petiole;
    // How far upper faces are turned up, 0 (as they grow) to 1. Default 0.5.
    float facing;
    // Variation of lengths, as a share, 0 to 0.9. Default 0.2.
    float jitter;
} tree_silhouette_leaves;

// How a plan becomes a tree. Begin with `tree_silhouette_grow_params_init`.
typedef struct tree_silhouette_grow_params {
    // `sizeof(tree_silhouette_grow_params)`.
    size_t struct_size;
    // Number of levels of axes that parameters are given for, at most 64. Default 0: all as by default.
    size_t n_levels;
    // Levels of axes that bear branches: the trunk first. Levels beyond are as the last.
    const struct tree_silhouette_level *levels;
    // The leaves. NULL, the default, for `tree_silhouette_leaves_init`.
    const struct tree_silhouette_leaves *leaves;
    // Names of the tree, its bark and its leaf, which is kind 0. NULL, the default, for an oak with clusters of leaves.
    const struct tree_species *species;
    // The search for azimuths. NULL is the default.
    const struct tree_gibbs_params *gibbs;
    // 0 for a bare tree. Default 1.
    uint32_t has_leaves;
    // Levels of branches on the trunk, 1 to 8. 0, the default, for those drawn, but two at least where no leaf tells.
    uint32_t depth;
    // How far a sketched branch may stand off the drawing's plane, in radians, 0 to below π/2. Default π/4.
    float domain;
    // Radius of the trunk in metres, 1e-6 to 100. 0, the default, for `slenderness` times the height.
    float trunk_radius;
    // Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    float slenderness;
    // How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    float exponent;
    // Whether twigs and leaves that would be seen outside the outlines are left out. Default 1.
    uint32_t fence;
    // How full the outlines are made: leaf area in front of every cell of them over the cell's, 0 (what grows) to 10.
    // Default 1.6.
    float fill;
} tree_silhouette_grow_params;

// How a plan became a tree. Set `struct_size` first.
typedef struct tree_silhouette_grown {
    // `sizeof(tree_silhouette_grown)`.
    size_t struct_size;
    // Number of levels of branches, the trunk's included.
    size_t n_levels;
    // Branches of every level, the trunk first; levels beyond the array count with the last.
    uint64_t branches[TREE_SILHOUETTE_LEVELS];
    // Of those on the trunk, how many were sketched. The others were added in space.
    uint64_t n_sketched;
    // Leaves.
    uint64_t n_leaves;
    // Branches without room in the outline of their parent, which were left out.
    uint64_t n_without_room;
    // Branches and leaves left out because they would be seen outside the outlines.
    uint64_t n_fenced;
    // Leaves added where the outlines were empty.
    uint64_t n_filled;
    // Different patterns that were made.
    uint64_t n_patterns;
    // Leaves and branches together: the paper's count of elements.
    uint64_t n_elements;
} tree_silhouette_grown;

// A view of a drawn leaf, in lengths of the leaf.
typedef struct tree_leaf_outline_columns {
    // `sizeof(tree_leaf_outline_columns)`.
    size_t struct_size;
    // Number of corners, at most 64.
    size_t n_points;
    // Number of indices, three for each triangle.
    size_t n_indices;
    // Two floats for each corner: the border, against the clock.
    const float *points;
    // Three for each triangle, against the clock: its corners.
    const uint32_t *indices;
    // Lowest coordinates.
    float low[2];
    // Highest coordinates.
    float high[2];
    // Area for a leaf of length 1.
    float area;
    // 0.
    uint32_t reserved;
} tree_leaf_outline_columns;

// How a drawn stroke becomes an outline. Begin with `tree_outline_close_params_init`.
typedef struct tree_outline_close_params {
    // `sizeof(tree_outline_close_params)`.
    size_t struct_size;
    // Ends closer than this share of the stroke's length count as closed by hand; wider gaps are noted as such, 0 to
    // 1. Default 0.15.
    float gap;
    // Most corners of an outline, 8 to 4096; those that change its shape least are left out. Default 2000.
    uint32_t corners;
} tree_outline_close_params;

// A view of an outline.
typedef struct tree_outline_columns {
    // `sizeof(tree_outline_columns)`.
    size_t struct_size;
    // Number of corners, three at least.
    size_t n_points;
    // Two floats for each corner, against the clock. The last is joined to the first.
    const float *points;
    // Lowest coordinates in metres.
    float low[2];
    // Highest coordinates in metres.
    float high[2];
    // Area in square metres.
    float area;
    // Length round in metres.
    float perimeter;
} tree_outline_columns;

// What was repaired or noticed of a stroke that became an outline: a `TREE_OUTLINE_` constant. New ones may be added.
typedef uint32_t tree_outline_repair_kind;

// One thing that was repaired or noticed of a stroke. Fields that its kind does not name are 0.
typedef struct tree_outline_repair {
    // What it was.
    tree_outline_repair_kind kind;
    // How many there were.
    uint32_t count;
    // How many there are now.
    uint32_t after;
    // A length in metres.
    float gap;
    // A share, 0 to 1.
    float share;
} tree_outline_repair;

// How gaps between branches are filled. Begin with `tree_cover_params_init`.
typedef struct tree_cover_params {
    // `sizeof(tree_cover_params)`.
    size_t struct_size;
    // Places on each side of the axis that are tried, 0 to 10,000. Default 24.
    uint32_t places;
    // Share of a new branch's outline that may overlap its siblings, 0 to 1. Default 0.2, as in the paper.
    float overlap;
    // Longest stretch of the outline that may stay bare, as a share of its length round, 0.005 to 1. Default 0.04.
    float bare;
    // 0.
    uint32_t reserved;
} tree_cover_params;

// How sub-silhouettes are cut out. Begin with `tree_sub_params_init`.
typedef struct tree_sub_params {
    // `sizeof(tree_sub_params)`.
    size_t struct_size;
    // Opening of the cone at a sharp feature, in radians, 0.02 to 3. Default 20°.
    float narrow;
    // Opening where the radius at the end is the branch's span or more, in radians, 0.02 to 3. Default 110°.
    float wide;
} tree_sub_params;

// How the branches of a system are found: an axis with the outline of its foliage. A part that is NULL, as all are
// after `tree_branch_system_params_init`, is its default.
typedef struct tree_branch_system_params {
    // `sizeof(tree_branch_system_params)`.
    size_t struct_size;
    // How bumps are found.
    const struct tree_bump_params *bumps;
    // How branches are inferred.
    const struct tree_branch_infer_params *infer;
    // How sub-silhouettes are made.
    const struct tree_sub_params *sub;
    // How gaps are filled.
    const struct tree_cover_params *cover;
} tree_branch_system_params;

// All parameters from strokes to a tree. A part that is NULL, as all are after `tree_silhouette_params_init`, is its
// default.
typedef struct tree_silhouette_params {
    // `sizeof(tree_silhouette_params)`.
    size_t struct_size;
    // How strokes become outlines.
    const struct tree_outline_close_params *outline;
    // How branches are found in outlines.
    const struct tree_branch_system_params *system;
    // Angles of the branches on the trunk, until branches are redrawn. Default 1.35 at the base, 0.6 at the tip.
    const struct tree_branching_angles *angles;
    // How the plan becomes a tree.
    const struct tree_silhouette_grow_params *grow;
    // A stroke redraws a branch when its ends are on average no farther off than this share of the branch's span, 0
    // to 10; else it adds one. Default 0.35. Messages call it `near`.
    float nearness;
    // Height in metres of the tallest tree of a drawing, 0.001 to 1000. Default 10.
    float height;
} tree_silhouette_params;

// The numbers behind an arrangement.
typedef struct tree_arrangement_numbers {
    // `sizeof(tree_arrangement_numbers)`.
    size_t struct_size;
    // Branches at a node, n. 1 for `TREE_ARRANGEMENT_SPREAD`.
    uint32_t per_node;
    // Turn from a node to the next, φ, in radians.
    float turn;
    // Angle between two neighbours at a node, γ, in radians.
    float spacing;
    // The azimuth that one privileged position of every node has, in radians, where `has_fixed` says so.
    float fixed;
    // 1 where the arrangement fixes an azimuth, else 0.
    uint32_t has_fixed;
    // 1 where branches have privileged positions at all, else 0.
    uint32_t has_pattern;
} tree_arrangement_numbers;

// Why there is a branch: one of the `TREE_BRANCH_` constants.
typedef uint32_t tree_branch_origin;

// All branches of a `tree_outline_plan`, parents first: a view. Set `struct_size` first.
typedef struct tree_outline_plan_columns {
    // `sizeof(tree_outline_plan_columns)`.
    size_t struct_size;
    // Number of rows.
    size_t n_branches;
    // Rows of the tree itself. Those after them are branches of other trees that it may copy the style of.
    size_t n_own;
    // Id of each, above 0.
    const uint32_t *ids;
    // Id of the branch it stands on; `TREE_NO_BRANCH` for those on a trunk.
    const uint32_t *parents;
    // 1 for those on the trunk, 2 for those on these, and so on.
    const uint32_t *levels;
    // Why it is there.
    const tree_branch_origin *origins;
    // Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
    const uint32_t *styles;
    // Where it leaves its parent, as a share of the parent's length.
    const float *places;
    // Radius of its bump in metres, or of what stands for one.
    const float *radii;
    // Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
    const float *azimuths;
    // Two floats each: the part of the parent's outline it may share, as lengths along; NaN for all.
    const float *stretches;
    // 1 where it is on the left side of its parent, looking towards the parent's tip.
    const uint8_t *lefts;
    // 1 where the outline of its foliage was drawn, so that it bears a system.
    const uint8_t *refined;
    // Number of points of all lines.
    size_t n_line_points;
    // Where each line begins in `line_points`, and at last their number: `n_branches + 1` values.
    const uint32_t *line_starts;
    // Two floats for each point, from base to end.
    const float *line_points;
    // Number of points of all outlines.
    size_t n_outline_points;
    // Where each outline begins in `outline_points`, and at last their number: `n_branches + 1` values.
    const uint32_t *outline_starts;
    // Two floats for each point, against the clock, the first not repeated.
    const float *outline_points;
} tree_outline_plan_columns;

// One branch of a plan: a view. Set `struct_size` first.
typedef struct tree_outline_branch {
    // `sizeof(tree_outline_branch)`.
    size_t struct_size;
    // Number of points of its line.
    size_t n_line_points;
    // Two floats for each, from base to end.
    const float *line_points;
    // Number of points of the outline of its foliage.
    size_t n_outline_points;
    // Two floats for each, against the clock, the first not repeated.
    const float *outline_points;
    // Its id.
    uint32_t id;
    // Id of the branch it stands on; `TREE_NO_BRANCH` for the trunk.
    uint32_t parent;
    // 1 for one on the trunk, 2 for one on these, and so on.
    uint32_t level;
    // Why it is there.
    tree_branch_origin origin;
    // Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
    uint32_t style;
    // 1 where it is on the left side of its parent, looking towards the parent's tip.
    uint32_t is_left;
    // 1 where the outline of its foliage was drawn, so that it bears a system.
    uint32_t is_refined;
    // Where it leaves its parent, as a share of the parent's length.
    float place;
    // Radius of its bump in metres, or of what stands for one.
    float radius;
    // Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
    float azimuth;
} tree_outline_branch;

// An axis, the outline of its foliage and the angles at which branches leave it: a view. Set `struct_size` first.
typedef struct tree_outline_system {
    // `sizeof(tree_outline_system)`.
    size_t struct_size;
    // Number of points of the axis: the trunk or branch.
    size_t n_axis_points;
    // Two floats for each, from base to tip.
    const float *axis_points;
    // Number of points of the outline of its foliage: the crown of the trunk.
    size_t n_outline_points;
    // Two floats for each, against the clock, the first not repeated.
    const float *outline_points;
    // Number of samples of the branching angles.
    size_t n_angles;
    // Two floats for each: place along the axis, 0 at its base to 1 at its tip, in rising order; and angle, 0 (straight
    // on) to π (backwards).
    const float *angles;
    // Number of branches on it.
    size_t n_branches;
    // Number of outlines in further planes; see `tree_outline_plan_section`.
    size_t n_sections;
} tree_outline_system;

// What a stroke belongs to: a branching order, 0 for the trunk and the crown, 1 for its branches, and so on; or
// `TREE_LEVEL_OF_LEAF`.
typedef uint32_t tree_drawn_level;

// What a stroke shows: a `TREE_DRAWN_KIND_` constant.
typedef uint32_t tree_drawn_kind;

// A stroke of a drawing of outlines: as input, or as a view of a `tree_outline_drawing`. Zeros are its defaults: an axis of
// level 0 in the plane of the drawing. Set `struct_size` first.
typedef struct tree_drawn_stroke {
    // `sizeof(tree_drawn_stroke)`.
    size_t struct_size;
    // Number of points.
    size_t n_points;
    // Two floats for each point, in units of the drawing, y downwards. All are finite.
    const float *points;
    // Its name in the drawing; empty where it has none.
    struct tree_str name;
    // What it belongs to. Default 0.
    tree_drawn_level level;
    // What it shows. Default `TREE_DRAWN_KIND_AXIS`.
    tree_drawn_kind kind;
    // By how much the plane it is drawn in is turned about the trunk, in radians. Default 0, the plane of the drawing.
    float azimuth;
    // 0.
    uint32_t reserved;
} tree_drawn_stroke;

// A view of one tree of a drawing.
typedef struct tree_drawn_tree {
    // `sizeof(tree_drawn_tree)`.
    size_t struct_size;
    // Its name in the drawing; empty where it has none.
    struct tree_str name;
    // Number of strokes, one at least.
    size_t n_strokes;
    // Width of the trunk in units of the drawing, where it was drawn as an area; else 0.
    float trunk_width;
    // 0.
    uint32_t reserved;
} tree_drawn_tree;

// What was repaired or noticed in a drawing: a `TREE_DRAWN_` constant. New ones may be added.
typedef uint32_t tree_drawn_repair_kind;

// One thing that was repaired or noticed in a drawing. Fields that its kind does not name are 0.
typedef struct tree_drawn_repair {
    // What it was.
    tree_drawn_repair_kind kind;
    // How many there were.
    uint32_t count;
    // A share, 0 to 1.
    float share;
    // A length in units of the drawing.
    float width;
} tree_drawn_repair;

// The frame of a surface.
typedef struct tree_revolved_frame {
    // `sizeof(tree_revolved_frame)`.
    size_t struct_size;
    // Where it begins: the start of the axis, in the drawing.
    float origin[2];
    // The unit vector along the span of the axis, in the drawing.
    float up[2];
} tree_revolved_frame;

// What became of a drawing's strokes. `tree_silhouette_session_repairs` and `tree_silhouette_session_refused` tell more. Set
// `struct_size` first.
typedef struct tree_silhouette_play_report {
    // `sizeof(tree_silhouette_play_report)`.
    size_t struct_size;
    // Repairs of strokes.
    uint64_t n_repairs;
    // Strokes that could not be used.
    uint64_t n_refused;
    // Strokes that were used.
    uint32_t n_strokes;
    // 0.
    uint32_t reserved;
} tree_silhouette_play_report;

// A view of a `tree_silhouette_change`: ids of branches, in rising order. Set `struct_size` first.
typedef struct tree_silhouette_change_columns {
    // `sizeof(tree_silhouette_change_columns)`.
    size_t struct_size;
    // Number of branches that are new.
    size_t n_added;
    // Their ids.
    const uint32_t *added;
    // Number of branches that are gone.
    size_t n_removed;
    // Their ids.
    const uint32_t *removed;
    // Number of branches whose line, outline or place is another.
    size_t n_reshaped;
    // Their ids.
    const uint32_t *reshaped;
    // Number of branches that bear a drawn system which they did not, or another one, or take their style from
    // elsewhere.
    size_t n_restyled;
    // Their ids.
    const uint32_t *restyled;
    // Number of repairs of the stroke.
    size_t n_repairs;
    // What was repaired in the stroke, in sentences.
    const struct tree_str *repairs;
    // 1 where the trunk or the crown is another.
    uint32_t trunk;
    // 1 where the leaf is another.
    uint32_t leaf;
} tree_silhouette_change_columns;

// Who takes the shape and angle of a branch that is drawn over: one of the `TREE_TRANSFER_` constants.
typedef uint32_t tree_transfer;

// How distances are read from a drawing: one of the `TREE_PERSPECTIVE_` constants.
typedef uint32_t tree_perspective;

// How a drawing becomes a stand. Begin with `tree_stand_params_init`.
typedef struct tree_stand_params {
    // `sizeof(tree_stand_params)`.
    size_t struct_size;
    // Of each tree; `height` is that of the tallest. NULL, the default, for `tree_silhouette_params_init`.
    const struct tree_silhouette_params *silhouette;
    // Number of rows of `lendings`. Default 0.
    size_t n_lendings;
    // Who borrows from whom, where that is not to be the detailed tree with the most similar crown: two numbers each,
    // places in the drawing from 0: the tree that borrows, and the one that lends, `TREE_NO_TREE` for nobody. The last row
    // for a tree counts.
    const uint32_t *lendings;
    // How distances are read. Default `TREE_PERSPECTIVE_ESTIMATED`.
    tree_perspective perspective;
    // For `TREE_PERSPECTIVE_HORIZON` the height of the horizon in the drawing: y in its units, downwards, -1e6 to 1e6.
    float horizon;
    // Angle under which the width of all trees is seen in the drawing, in radians, 0.05 to 2.5: what turns sizes into
    // distances. Default 0.9, as in a photograph. Unused without perspective.
    float fov;
    // Without perspective: how far trees stand off their line, as a share of their mean distance, 0 to 10. Default 0.4.
    float jitter;
    // Borrowed branches and leaves are scaled as the crowns are, but at most by this factor up or down, 1 to 100.
    // Default 3.
    float scaling;
    // 0.
    uint32_t reserved;
} tree_stand_params;

// A stand as a whole: a view. Set `struct_size` first.
typedef struct tree_stand_whole {
    // `sizeof(tree_stand_whole)`.
    size_t struct_size;
    // Number of trees.
    size_t n_trees;
    // Leaves and branches of all trees together.
    uint64_t n_elements;
    // 1 where the drawing is in perspective, and the fields below count.
    uint32_t has_view;
    // Distance of the drawing from the eye, in units of the drawing.
    float focal;
    // The point of the drawing that the eye looks at: on the horizon, in units of the drawing.
    float center[2];
    // The eye in metres; it looks level along -Z.
    float eye[3];
    // 0.
    uint32_t reserved;
} tree_stand_whole;

// One tree of a stand: a view. Set `struct_size` first.
typedef struct tree_stand_tree {
    // `sizeof(tree_stand_tree)`.
    size_t struct_size;
    // Its name in the drawing, or `tree 3` for the third where it has none.
    struct tree_str name;
    // Its place among the trees of the drawing, from 0.
    uint32_t number;
    // The tree, by its place in the drawing, whose branches or leaf it borrows; `TREE_NO_TREE` where it borrows nothing.
    uint32_t lender;
    // Where its base stands in the stand, in metres: x as in the drawing, +Z towards the viewer.
    float position[3];
    // Metres for a unit of the drawing, at this tree.
    float scale;
    // By how much what it borrows is scaled; 1 where it borrows nothing.
    float borrowed_scale;
    // 0.
    uint32_t reserved;
} tree_stand_tree;

// How a sub-silhouette hangs together with its parent.
typedef struct tree_sub_report {
    // `sizeof(tree_sub_report)`.
    size_t struct_size;
    // Begin and end of the shared part, in metres along the parent against the clock from its first corner; the second
    // may be greater than the perimeter. Both are one place where nothing could be shared.
    float shared[2];
    // The points where the curves join the shared part: its begin, then its end.
    float join_points[4];
    // Directions of the outline there, against the clock, of unit length.
    float join_tangents[4];
    // The curves from the branch's base to the begin, and from the end to the base. Of each: where it begins, the
    // derivative there, where it ends, the derivative there, two floats each, of a cubic Hermite curve.
    float curves[16];
} tree_sub_report;

// The axes in columns. Parent axes come first; axis 0 is the trunk.
typedef struct tree_axis_columns {
    // `sizeof(tree_axis_columns)`.
    size_t struct_size;
    // Number of axes, at least 1.
    size_t n_axes;
    // Number of nodes of the skeleton.
    size_t n_nodes;
    // One for each axis: its order after Gravelius, 0 for the trunk, one more than the parent axis for
    // a lateral.
    const uint32_t *orders;
    // One more than there are axes: the nodes of axis `i` are `nodes[starts[i]]` up to, but not
    // including, `nodes[starts[i + 1]]`.
    const uint32_t *starts;
    // `n_nodes` numbers: the nodes, axis after axis, each from base to tip. A lateral's first node is
    // the first one above the fork; the fork itself belongs to the parent axis.
    const uint32_t *nodes;
    // One for each node: the axis it lies on.
    const uint32_t *axis_of;
} tree_axis_columns;

// How a skeleton branches.
typedef struct tree_branching_report {
    // `sizeof(tree_branching_report)`.
    size_t struct_size;
    // The Horton-Strahler order of the root, which no other exceeds; at least 1.
    uint32_t n_orders;
    // Unbranched runs, at least 1.
    uint32_t n_runs;
    // How many times more branches there are of an order than of the next higher one: trees have about 3 to 5.
    // 0 where all is of order 1.
    double bifurcation_ratio;
    // How many times longer the branches of an order are than those of the next lower one; 0 where fewer than two
    // orders have a length.
    double length_ratio;
    // The median of what `tree_skeleton_pipe_exponents` gives, of two in the middle the higher: infinite where most
    // forks have none. 0 of a skeleton without forks.
    double pipe_exponent;
} tree_branching_report;

// The branches of a Horton-Strahler order.
typedef struct tree_strahler_order {
    // How many there are; one of the highest order.
    uint64_t n_branches;
    // Their mean length in metres. 0 for the highest order where the root itself is the fork.
    double mean_length;
} tree_strahler_order;

// An unbranched run: what lies between two forks, or a fork and a tip.
typedef struct tree_unbranched_run {
    // The run below; `TREE_NO_PARENT` for run 0.
    uint32_t parent;
    // Its upper end: a fork or a tip.
    uint32_t end;
    // 1 where it ends in a tip.
    uint32_t is_tip;
    // Its segments, the one above the fork included: at least 1, but for a root that is a fork or a tip.
    uint32_t n_segments;
    // Length from the fork below to the end, in metres.
    double length;
    // Mean radius in metres, weighted by length; radii of 0 are left out, as they are not known. 0 where none is. A run
    // without length has the radius of its end.
    double radius;
} tree_unbranched_run;

// How far a lateral turns away from its parent axis.
typedef struct tree_lateral_angle {
    // First node of the lateral, the one above the fork.
    uint32_t node;
    // Between the axis below the fork and the lateral, in radians from 0 to pi.
    float angle;
} tree_lateral_angle;

// Which axis of a file or a cloud points up: one of the `TREE_UP_` constants.
typedef uint32_t tree_up;

// What becomes of radii that an SWC file does not know: one of the `TREE_SWC_RADIUS_` constants.
typedef uint32_t tree_swc_radius;

// How an SWC file relates to this library. Begin with `tree_swc_options_init`.
typedef struct tree_swc_options {
    // `sizeof(tree_swc_options)`.
    size_t struct_size;
    // Metres per unit of the file, for positions and radii; 1e-9 to 1e9. Default 1.
    double scale;
    // The file's upward axis. Default `TREE_UP_Z`.
    tree_up up;
    // Whether reading moves the root to the origin. Default 1. The move is made in double precision, so
    // that coordinates of a map grid lose nothing. Not used in writing.
    uint32_t base_at_origin;
    // What becomes of radii that the file does not know. Default `TREE_SWC_RADIUS_KEEP`. Not used in
    // writing.
    tree_swc_radius unknown_radius;
    // Must be 0.
    uint32_t reserved;
} tree_swc_options;

// What an SWC file held beside the skeleton, and what was noted while reading.
typedef struct tree_swc_contents {
    // `sizeof(tree_swc_contents)`.
    size_t struct_size;
    // Number of nodes.
    size_t n_nodes;
    // One for each node: its type as in the file; 3 continues its parent's axis, 4 starts a lateral.
    const int32_t *types;
    // One for each node: its id as in the file.
    const int64_t *ids;
    // All comments without their `#`, a line each.
    struct tree_str comments;
    // Rows without a known radius.
    uint64_t n_unknown_radii;
    // How many of these `unknown_radius` gave a radius.
    uint64_t n_filled_radii;
    // Rows with more than seven fields; the further ones were passed over.
    uint64_t n_rows_with_more_fields;
    // 1 if rows came before their parents, so that nodes have another order than rows; else 0.
    uint32_t reordered;
    // 0.
    uint32_t reserved;
    // What was added to every position to bring the root to the origin, in metres and this library's
    // axes; zeros if nothing was moved.
    double moved_by[3];
} tree_swc_contents;

// How a mesh of a tree is read. Everything is relative, so the unit of the mesh does not matter. Begin
// with `tree_skeletonize_params_init`.
typedef struct tree_skeletonize_params {
    // `sizeof(tree_skeletonize_params)`.
    size_t struct_size;
    // Vertices nearer than a quarter of this share of the mesh's size are one, 1e-7 to 0.01. Default
    // 1e-5. Larger closes cracks and may melt twigs.
    float weld;
    // Least distance between nodes in bent wood, in halves of the radius, 0.1 to 20. Default 1. Straight
    // wood gets fewer nodes, up to ten radii apart.
    float spacing;
    // How far a node may lie off the measured centre line, in radii, 0 to 0.5. Default 0.08.
    float tolerance;
    // Side shoots that stand out of their parent by less than this share of its radius, and by less than
    // their own radius, are bumps of the bark, 0 to 2. Default 0.25.
    float prune;
    // Widest gap between separate pieces of wood that is bridged, as a share of the mesh's size, 0 to 1.
    // Default 0.05. Wood farther away is left out and reported.
    float bridge;
    // Whether leaves are made. Default 1.
    uint32_t leaves;
} tree_skeletonize_params;

// What a part of a mesh is made of, as far as the caller knows: one of the `TREE_HINT_` constants.
typedef uint32_t tree_hint;

// Triangles of one material. Any unit of length; +Y up. Begin with `tree_mesh_part_init`.
typedef struct tree_mesh_part {
    // `sizeof(tree_mesh_part)`.
    size_t struct_size;
    // Name of the material or object. It names the leaf kind, and may tell wood from leaves.
    struct tree_str name;
    // Three floats for each vertex, finite.
    const float *positions;
    // Two floats for each vertex: texture coordinates, v downwards. NULL for none.
    const float *uvs;
    // Number of vertices.
    size_t n_vertices;
    // Three for each triangle.
    const uint32_t *indices;
    // Number of indices, a multiple of 3.
    size_t n_indices;
    // What it is made of. Default `TREE_HINT_AUTO`.
    tree_hint hint;
    // Whether its texture has holes. Default 0.
    uint32_t alpha_masked;
    // Whether both faces are drawn. Default 0.
    uint32_t double_sided;
    // 0.
    uint32_t reserved;
} tree_mesh_part;

// How a cloud of points is read. Lengths are metres; "spacings" are the median distance of a point to its fourth
// neighbour. Begin with `tree_scan_params_init`.
typedef struct tree_scan_params {
    // `sizeof(tree_scan_params)`.
    size_t struct_size;
    // Metres for a unit of the cloud, 1e-6 to 1e6. Default 1.
    double unit;
    // The axis that points up. Default `TREE_UP_Z`.
    tree_up up;
    // Edge of the voxels that become one point each, 0 to 10 m. Default 0: half a spacing.
    float voxel;
    // Nearest points that each one is joined with, 4 to 32. Default 8. More bridge thin gaps and run branches together.
    uint32_t neighbours;
    // Widest gap that is bridged, as a share of the cloud's size, 0 to 1. Default 0.1. What is farther away is left out
    // and reported.
    float bridge;
    // Distance between nodes in spacings, 1 to 20. Default 2.5.
    float step;
    // Reach within which an axis takes in what runs beside it, in its widths (mean distances of its points from its
    // middle), 1 to 10. Default 2.
    float merge;
    // Length in spacings by which a branch must leave the reach of its parent, 0 to 100. Default 4.
    float prune;
    // Whether the ground is taken away where the scan shows some. Default 1.
    uint32_t ground;
    // Whether every trunk becomes a tree. Default 0: the cloud is one tree, and the report tells how many trunks it may
    // have.
    uint32_t several;
    // Whether branches through foliage, which are guessed, are kept. Default 1.
    uint32_t foliage;
} tree_scan_params;

// What was found in a cloud of points, and what was left out.
typedef struct tree_scan_report {
    // `sizeof(tree_scan_report)`.
    size_t struct_size;
    // Points that came in.
    uint64_t n_points;
    // Points that were no numbers.
    uint64_t n_not_finite;
    // Second points at one place.
    uint64_t n_doubles;
    // Points that became one with others in their voxel.
    uint64_t n_thinned;
    // Points of the ground.
    uint64_t n_ground;
    // Points of pieces that no bridge reached.
    uint64_t n_left_out;
    // Gaps bridged: `tree_scanned_bridge` tells of each.
    uint64_t n_bridges;
    // Places where a tree may stand.
    uint64_t n_bases;
    // Clusters of points that the levels fell into.
    uint64_t n_clusters;
    // Side shoots too short for an axis.
    uint64_t n_short;
    // Nodes of all trees.
    uint64_t n_nodes;
    // Nodes whose radius and centre come from a circle fitted to the points; the radii of all others are guessed from
    // the wood beyond.
    uint64_t n_fitted;
    // Nodes in foliage, kept or not.
    uint64_t n_in_foliage;
    // Median distance to the fourth neighbour in metres.
    float spacing;
    // 0.
    uint32_t reserved;
} tree_scan_report;

// A view of a tree of a cloud.
typedef struct tree_scanned_columns {
    // `sizeof(tree_scanned_columns)`.
    size_t struct_size;
    // Where the tree's base, the origin of its skeleton, is in the cloud, in its axes and unit.
    double base[3];
    // Number of nodes of its skeleton.
    size_t n_nodes;
    // A byte for each node: 1 where it runs through foliage, guessed and not seen; else 0.
    const uint8_t *in_foliage;
} tree_scanned_columns;

// A view of the kinds of leaves that were found.
typedef struct tree_leaf_kinds {
    // `sizeof(tree_leaf_kinds)`.
    size_t struct_size;
    // Number of kinds.
    size_t n_kinds;
    // Names of the kinds: those of the parts they come from.
    const struct tree_str *names;
    // Mean width of each kind as a share of its length.
    const float *widths;
} tree_leaf_kinds;

// What one piece of wood stands for.
typedef struct tree_piece {
    // Area of its surface, in squares of the mesh's own unit.
    float area;
    // Bumps of the bark dropped.
    uint32_t n_bumps;
    // Branches cut where they had grown together.
    uint32_t n_cut;
} tree_piece;

// What a component of a mesh is: one of the `TREE_CLASS_` constants.
typedef uint32_t tree_class;

// A view of a separation. The triangles of component `i` are rows `starts[i]` up to, but not including,
// `starts[i + 1]`.
typedef struct tree_separation_columns {
    // `sizeof(tree_separation_columns)`.
    size_t struct_size;
    // Number of components; each lies within one part.
    size_t n_components;
    // For each component what it is taken for.
    const tree_class *classes;
    // `n_components + 1` numbers.
    const uint64_t *starts;
    // Number of triangles: all that have an area, once.
    size_t n_triangles;
    // Two numbers for each triangle: its part, and which triangle of that part it is.
    const uint32_t *triangles;
} tree_separation_columns;

// What was found in a mesh.
typedef struct tree_skeletonize_report {
    // `sizeof(tree_skeletonize_report)`.
    size_t struct_size;
    // Triangles of all parts.
    uint64_t n_triangles;
    // Triangles without area after welding, and second ones at one place in a part.
    uint64_t n_degenerate;
    // Triangles of wood.
    uint64_t n_wood_triangles;
    // Connected pieces of wood.
    uint64_t n_pieces;
    // Pieces of wood too far from all others, left out.
    uint64_t n_left_out;
    // Bumps of the bark dropped.
    uint64_t n_bumps;
    // Branches cut where they had grown together.
    uint64_t n_cut;
    // Leaves made.
    uint64_t n_leaves;
    // Closed bodies of leaves, for which nothing was made.
    uint64_t n_blobs;
    // Number of leaf kinds.
    uint64_t n_leaf_kinds;
    // Mean width of each leaf kind as a share of its length: of the first
    // `TREE_SKELETONIZE_LEAF_WIDTHS` kinds; `tree_found_leaves_view` has them all.
    float leaf_widths[TREE_SKELETONIZE_LEAF_WIDTHS];
    // Share of the wood's surface that the skeleton stands for, 0 to 1.
    float covered;
    // 0.
    uint32_t reserved;
} tree_skeletonize_report;

// Which part a segment plays where its parent ends: `TREE_SKETCH_APICAL`, or the number of a lateral from 0 to
// 65,535.
typedef uint32_t tree_sketch_label;

// Columns of branches: as input, or as a view of a `tree_sketch_branches`.
typedef struct tree_sketch_branches_columns {
    // `sizeof(tree_sketch_branches_columns)`.
    size_t struct_size;
    // Number of segments, at least 1.
    size_t n_segments;
    // Number of points of all segments.
    size_t n_points;
    // Parent of each segment, which comes before it; `TREE_NO_PARENT` for segment 0.
    const uint32_t *parents;
    // Label of each segment; that of segment 0 is `TREE_SKETCH_APICAL`.
    const tree_sketch_label *labels;
    // Where each segment's points begin in `points`, and at last their number: `n_segments + 1` values.
    const uint32_t *starts;
    // Three floats for each point, in metres: seen along -Z, as the sketch was drawn, z is the depth, positive
    // towards the viewer. A segment's first point is its parent's last; those that propagation adds may begin on
    // the way there.
    const float *points;
    // A name for each segment that stays when others are drawn or erased: streams of randomness go by it. NULL where
    // segments have none. Not read as input.
    const uint64_t *names;
    // The generation of each segment, 0 for the sketched. Not read as input.
    const uint32_t *generations;
    // Where on its parent each segment begins, counted in the parent's points: 2.25 is a quarter of the way from its
    // point 2 to its point 3. Not read as input.
    const float *forks;
    // How many segments are sketched; they come first. Not read as input.
    size_t n_sketched;
    // Whether segment 0 is not drawn: it stands below a base from which several stems rise, and only says that they
    // rise.
    uint32_t imagined_root;
    // 0.
    uint32_t reserved;
} tree_sketch_branches_columns;

// What becomes of strokes that lie far from the rest: a `TREE_ISOLATED_` constant.
typedef uint32_t tree_isolated;

// How a drawing is cleaned and joined. Shares are of the drawing's height (or of a tenth of its width, where
// that is more). Begin with `tree_clean_params_init`.
typedef struct tree_clean_params {
    // `sizeof(tree_clean_params)`.
    size_t struct_size;
    // Height of branches and crown together in metres, 0.01 to 1000. Default 10.
    float height;
    // Distance between nodes, a share, 0.001 to 0.2. Default 0.01. Corners get nodes of their own. Very long
    // drawings are sampled more coarsely.
    float spacing;
    // Gaps up to this share count as drawn to touch, 0 to 0.2. Default 0.03. Ends that stick out beyond the
    // stroke they join by up to this share are cut off.
    float snap;
    // A stroke that runs along another within this share is the same, 0 to 0.1. Default 0.012. 0: nothing is
    // merged.
    float merge;
    // How far a stroke may be from the rest, a share, 0 to 10. Default 0.25.
    float reach;
    // What becomes of strokes beyond the reach. Default `TREE_ISOLATED_BRIDGE`.
    tree_isolated isolated;
    // Whether `root` says where the tree's base is. Default no: it is found.
    uint32_t has_root;
    // Where the tree's base is, in units of the drawing.
    float root[2];
    // Whether strokes without a role may be taken for a crown, the ground, sides of a trunk or marks on its
    // bark. Default yes; no: what is not marked is a branch.
    uint32_t guess;
    // Forks on one branch closer together than this share are one, 0 (off) to 0.1. Default 0.01.
    float gather;
    // 0.
    uint32_t reserved;
} tree_clean_params;

// How a drawn crown is understood. Begin with `tree_crown_params_init`.
typedef struct tree_crown_params {
    // `sizeof(tree_crown_params)`.
    size_t struct_size;
    // A stroke whose ends are closer than this share of its length is a loop of its own, 0 to 1. Default 0.15.
    float gap;
    // Ends of strokes closer than this share of the crown's size are joined, 0 to 1. Default 0.05.
    float join;
    // Depth of the crown, along the view, over its width, 0.05 to 20. Default 1: circles.
    float depth;
    // Whether a crown that no branch touches is an error. Default no: it is kept and reported.
    uint32_t refuse;
} tree_crown_params;

// How large a crown is.
typedef struct tree_crown_measures {
    // `sizeof(tree_crown_measures)`.
    size_t struct_size;
    // Lowest coordinates of the polygons in metres.
    float low[2];
    // Highest coordinates of the polygons in metres.
    float high[2];
    // Area of the polygons in square metres.
    float area;
    // Volume of the solid in cubic metres.
    float volume;
    // Share of the branches' points that lay outside when it was closed, 0 to 1.
    float outside;
    // 0.
    uint32_t reserved;
} tree_crown_measures;

// What was repaired or noticed of a drawn crown: a `TREE_CROWN_` constant. New ones may be added.
typedef uint32_t tree_crown_repair_kind;

// One thing that was repaired or noticed of a drawn crown. Fields that its kind does not name are 0.
typedef struct tree_crown_repair {
    // What it was.
    tree_crown_repair_kind kind;
    // Number of a stroke of the crown, or of a loop.
    uint32_t stroke;
    // How many there were.
    uint32_t count;
    // How many there are now.
    uint32_t after;
    // A length in metres.
    float gap;
    // A share, 0 to 1.
    float share;
    // 1 or 0.
    uint32_t round_branches;
} tree_crown_repair;

// How outlines are drawn. Begin with `tree_sketch_outline_params_init`.
typedef struct tree_sketch_outline_params {
    // `sizeof(tree_sketch_outline_params)`.
    size_t struct_size;
    // Bays narrower than twice this share of the size are drawn across, 0.01 to 0.5. Default 0.06.
    float closing;
    // Most corners of all outlines together, 12 to 10,000. Default 120.
    uint32_t corners;
} tree_sketch_outline_params;

// What a stroke shows: a `TREE_ROLE_` constant.
typedef uint32_t tree_role;

// One line of a drawing: as input, or as a view of a `tree_drawing`. Zeros are its defaults. Set `struct_size`
// first.
typedef struct tree_sketch_stroke {
    // `sizeof(tree_sketch_stroke)`.
    size_t struct_size;
    // Number of points.
    size_t n_points;
    // Two floats for each point, in the drawing's own units, y downwards as on screens. Points that are not
    // finite are taken: cleaning leaves them out and says so.
    const float *points;
    // What messages call it besides its number. Default empty.
    struct tree_str name;
    // What it shows. Default `TREE_ROLE_UNKNOWN`.
    tree_role role;
    // Whether its end is joined to its beginning.
    uint32_t closed;
    // Whether it is the outline of a filled area rather than a line: of a branch so drawn the middle line is
    // meant.
    uint32_t filled;
    // 0.
    uint32_t reserved;
} tree_sketch_stroke;

// Which branches of a tree a person would draw. Begin with `tree_main_branch_params_init`.
typedef struct tree_main_branch_params {
    // `sizeof(tree_main_branch_params)`.
    size_t struct_size;
    // Least length of axes of order 1 as a share of the longest of them, 0 to 1. Default 0.3.
    float least;
    // Least length of axes of order 2 as a share of their parent's, 0 to 1. Default 0.35.
    float least_second;
    // Most axes, 1 to 1000. Default 36.
    uint32_t most;
    // Forks closer than this on an axis, as a share of the tree's extent, are taken for one, 0 to 0.5. Default
    // 0.025.
    float gather;
    // What continues an axis at a fork. Default `TREE_CONTINUATION_THICKEST`.
    tree_continuation continuation;
    // 0.
    uint32_t reserved;
} tree_main_branch_params;

// How branches become a tree. Begin with `tree_sketch_finish_params_init`.
typedef struct tree_sketch_finish_params {
    // `sizeof(tree_sketch_finish_params)`.
    size_t struct_size;
    // Whose twigs and leaves: one of the names that `tree_foliage_preset_name` gives. Default "oak", which an empty text
    // is too.
    struct tree_str species;
    // Whether there are leaves. Default 1.
    uint32_t leaves;
    // Whether there are twigs. Default 1.
    uint32_t twigs;
    // Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    float slenderness;
    // How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    float exponent;
    // Leaves against those of a tree in full leaf, 0 to 10. Default 1.
    float fullness;
    // Length of twigs against the usual of the species, 0.05 to 20. Default 1.
    float twig_length;
} tree_sketch_finish_params;

// What the finish did.
typedef struct tree_sketch_finish_report {
    // `sizeof(tree_sketch_finish_report)`.
    size_t struct_size;
    // Nodes of branches.
    uint64_t n_wood_nodes;
    // Nodes of twigs.
    uint64_t n_twig_nodes;
    // Nodes of twigs cut off because they left the crown or entered the ground.
    uint64_t n_twig_nodes_cut;
    // Blades that stayed: rows of the foliage.
    uint64_t n_leaves;
    // Blades left out because they left the crown or entered the ground.
    uint64_t n_leaves_outside;
    // How much larger leaves are than the species', because there would be too many; a factor.
    float leaves_larger;
    // 0.
    uint32_t reserved;
} tree_sketch_finish_report;

// How depths, labels and Ω are inferred. Begin with `tree_sketch_infer_params_init`.
typedef struct tree_sketch_infer_params {
    // `sizeof(tree_sketch_infer_params)`.
    size_t struct_size;
    // Whether Ω stays the template's (Neubert 2012, section 4.6.1) or fits itself to the sketch (section 4.6.2).
    // Default 0.
    uint32_t keep_omega;
    // Rounds of refining depths and, unless `keep_omega`, of estimating Ω, 0 to 100. Default 6; the thesis needed
    // fewer than 10.
    uint32_t rounds;
    // Passes of ICM over all segments in each round, at most, 1 to 1000. Default 8.
    uint32_t sweeps;
    // ICM ends where the depths of a pass changed by less than this share of the drawing's size altogether, 0 to 1.
    // Default 0.0005.
    float settled;
    // How many half-placed trees bottom-up inference keeps at once, 1 to 4096; 1 is the thesis. Large drawings get
    // fewer, so that time stays linear. Default 64.
    uint32_t beam;
    // How far angles and ratios spread as Ω says, 0 to 1. At 0 each segment aims at the means, as in the thesis, and
    // all branches come out alike; at 1 each aims at a draw from Ω of its own. Default 1.
    float spread;
    // How strongly branches keep out of each other's space (`k_e` of Eq. 4.22), 0 to 1000. Default 0.2.
    float competition;
    // How much likelier, as the logarithm of a ratio, a stroke goes on as the same axis than as a lateral, 0 (the
    // thesis) to 100. Default 3.
    float follow;
    // Standard deviation in radians by which a stroke bends towards or away from the viewer from one segment to the
    // next, 0.01 to 10. Small keeps curvy strokes in their plane. Default 0.3.
    float bending;
    // Ω counts with so many imagined segments of the template when it is estimated, 0.1 to 1e6. Default 8.
    float template_weight;
    // Branches that cross in the drawing keep this multiple of their thickness apart, 0 (off) to 10. Default 1.3.
    float clearance;
    // Radius of the trunk as a share of the height, for the branches' thickness, 1e-4 to 0.2. Default 0.02.
    float slenderness;
} tree_sketch_infer_params;

// A normal distribution.
typedef struct tree_sketch_normal {
    // Its mean μ.
    float mean;
    // Its standard deviation σ, 1e-4 to 10.
    float deviation;
} tree_sketch_normal;

// How axes of one order go on and branch. Angles in radians.
typedef struct tree_sketch_habit {
    // Natural logarithm of the length of the apical segment over that of the segment below. The mean is -10 to 10.
    struct tree_sketch_normal scale;
    // Natural logarithm of the length of a lateral's first segment over that of the segment below. The mean is -10
    // to 10.
    struct tree_sketch_normal lateral_scale;
    // α: the angle between the apical segment and the segment below. The mean is 0 to π.
    struct tree_sketch_normal alpha;
    // β: the angle between a lateral and the segment below. The mean is 0 to π.
    struct tree_sketch_normal beta;
    // γ: the turn about the axis from one lateral to the next. The mean is -2π to 2π.
    struct tree_sketch_normal gamma;
} tree_sketch_habit;

// Ω, the global parameters of a tree: a habit for axes of order 0 (the trunk), 1 and so on. Begin with
// `tree_sketch_omega_init`.
typedef struct tree_sketch_omega {
    // `sizeof(tree_sketch_omega)`.
    size_t struct_size;
    // How many orders have a habit of their own, 1 to `TREE_SKETCH_ORDERS`; the last one holds for all higher
    // orders too. Default 1. Of a template with more of them the first are given.
    uint32_t n_orders;
    // 0.
    uint32_t reserved;
    // The habits; rows from `n_orders` on do not count. Default: a broad-leaved tree's, with nearly straight axes
    // and laterals at half a right angle in a golden spiral.
    struct tree_sketch_habit orders[TREE_SKETCH_ORDERS];
} tree_sketch_omega;

// A depth that is known: of the end of the segment that ends at a node of the plan.
typedef struct tree_sketch_pin {
    // Node of the plan: a tip or a fork.
    uint32_t node;
    // Its depth in metres; positive is towards the viewer.
    float depth;
} tree_sketch_pin;

// A step of inference: one of the `TREE_SKETCH_STEP_` constants.
typedef uint32_t tree_sketch_step;

// The posterior's logarithm, part by part.
typedef struct tree_sketch_posterior {
    // The whole: the sum of the others.
    double total;
    // Sum of the factors between segments and their parents (Eq. 4.17).
    double branches;
    // Competition for space (Eq. 4.22).
    double competition;
    // Branches that cross without room, 0 where none does.
    double crossings;
    // Ω, seen from the template.
    double omega;
} tree_sketch_posterior;

// The posterior after a step.
typedef struct tree_sketch_trace_row {
    // The step.
    tree_sketch_step step;
    // 0.
    uint32_t reserved;
    // The posterior after it.
    struct tree_sketch_posterior posterior;
} tree_sketch_trace_row;

// The factor of one segment, part by part, as logarithms.
typedef struct tree_sketch_factor_row {
    // The segment.
    uint32_t segment;
    // 0.
    uint32_t reserved;
    // ln p(s | Ω).
    double scale;
    // ln p(α | Ω) or ln p(β | Ω).
    double divergence;
    // ln p(γ | Ω); 0 where there is no roll.
    double roll;
    // What the factors along strokes add.
    double stroke;
    // Competition and crossings that change with this segment's depth.
    double shared;
} tree_sketch_factor_row;

// A view of what was inferred.
typedef struct tree_inferred_columns {
    // `sizeof(tree_inferred_columns)`.
    size_t struct_size;
    // Number of segments; `tree_inferred_branches` has their points and labels.
    size_t n_segments;
    // Where the nodes of each segment begin in `nodes`, and at last their number: `n_segments + 1` values.
    const uint32_t *node_starts;
    // The plan's nodes that the points of each segment are, in their order; for an imagined root the base alone.
    const uint32_t *nodes;
    // Number of nodes in `nodes`.
    size_t n_nodes;
    // The posterior after each step. It never falls.
    const struct tree_sketch_trace_row *trace;
    // Number of steps.
    size_t n_trace;
    // The factor of each segment but the root.
    const struct tree_sketch_factor_row *factors;
    // Number of factors.
    size_t n_factors;
    // The posterior.
    struct tree_sketch_posterior posterior;
    // Crossings in the drawing of branches that could not be given room.
    uint32_t n_interpenetrations;
    // 0.
    uint32_t reserved;
} tree_inferred_columns;

// What lies inside where contours cross or nest: a `TREE_FILL_` constant.
typedef uint32_t tree_fill_rule;

// How middle lines are found. Begin with `tree_midline_params_init`.
typedef struct tree_midline_params {
    // `sizeof(tree_midline_params)`.
    size_t struct_size;
    // Side lines shorter than this share of the area's width where they leave are no branches, 0 to 10. Default 1.
    float spur;
    // What lies inside. Default `TREE_FILL_NON_ZERO`.
    tree_fill_rule rule;
} tree_midline_params;

// How a segment lies to its parent.
typedef struct tree_sketch_relation {
    // The segment.
    uint32_t segment;
    // Its label.
    tree_sketch_label label;
    // Gravelius order of its parent's axis: the order whose habit it follows.
    uint32_t order;
    // 1 where `roll` counts: not for apical segments, nor for the first lateral of an axis.
    uint32_t has_roll;
    // Natural logarithm of its length over its parent's.
    double scale;
    // Angle to its parent in radians: α of an apical segment, β of a lateral.
    double divergence;
    // For a lateral, the turn about the axis from the last lateral's side, less what its place in the fork's whorl
    // gives, -π to π. 0 where there is none.
    double roll;
} tree_sketch_relation;

// The columns of a plan: as input, or as a view of a `tree_plan`. Set `struct_size` first.
typedef struct tree_plan_columns {
    // `sizeof(tree_plan_columns)`.
    size_t struct_size;
    // Number of nodes, at least 1. Node 0 is the base.
    size_t n_nodes;
    // Two floats for each node, in metres: x to the right, y up, the base at the origin.
    const float *positions;
    // Parent of each node, which comes before it; `TREE_NO_PARENT` for node 0.
    const uint32_t *parents;
    // The drawing's stroke that each node lies on. Where two meet, the node belongs to the one that bears the
    // other.
    const uint32_t *strokes;
    // Where the base is in the drawing.
    float base[2];
    // Metres for one unit of the drawing, above 0.
    float scale;
    // 0.
    uint32_t reserved;
} tree_plan_columns;

// What was done to a stroke: a `TREE_REPAIR_` constant. New ones may be added.
typedef uint32_t tree_repair_kind;

// One thing that was done to one stroke of a drawing. Fields that its kind does not name are 0.
typedef struct tree_clean_repair {
    // Index of the stroke in the drawing.
    uint32_t stroke;
    // What was done. New ones may be added.
    tree_repair_kind kind;
    // Index of another stroke.
    uint32_t other;
    // A number of points.
    uint32_t count;
    // What it was taken to show.
    tree_role role;
    // A length, as a share of the drawing's height.
    float share;
} tree_clean_repair;

// How a sketch is filled up with branches. Begin with `tree_sketch_propagate_params_init`.
typedef struct tree_sketch_propagate_params {
    // `sizeof(tree_sketch_propagate_params)`.
    size_t struct_size;
    // Generations of new segments where no crown is drawn, 0 (none) to 32. Default 5, as in the thesis.
    uint32_t generations;
    // Most generations where a crown is drawn: its surface mostly ends growth before, 0 to 32. Default 7.
    uint32_t generations_in_crown;
    // A sketched segment longer than this many times its natural length gets new laterals, 1 to 1e6. Default 1.5;
    // 1e6 for none.
    float long_from;
    // Longest natural length of a segment from fork to fork, as a share of the tree's height, 1e-3 to 1. Default
    // 0.045. Smaller gives more laterals along sketched branches.
    float internode;
    // Segments shorter than this share of the tree's height do not grow, 1e-4 to 1. Default 0.009.
    float shortest;
    // Share of a trunk without drawn branches that stays bare where no crown is drawn, 0 to 1. Default 0.25.
    float bare;
    // Whether a trunk with drawn branches gets new laterals below the first of them too. Default 0.
    uint32_t below_first;
    // Highest Gravelius order of new axes, 0 to 32. Default 8. A palm has 1: its fronds do not branch.
    uint32_t orders;
    // Most segments, sketched and new, 1 to 100 million. Default 20,000. The last generation is thinned evenly where
    // there would be more.
    uint32_t max_segments;
    // How far each new segment turns down: so many times straight down is added to its direction, -1 to 1. Negative
    // turns up. Default 0.
    float gravitropism;
    // Random deviation of angles from those of the block, in radians, 0 to π. Default 0.12.
    float jitter;
    // Distance in metres that new segments keep from obstacles, 0 to 1e6. Default 0.1.
    float clearance;
} tree_sketch_propagate_params;

// What propagation did. Numbers count segments unless they say otherwise.
typedef struct tree_sketch_propagate_report {
    // `sizeof(tree_sketch_propagate_report)`.
    size_t struct_size;
    // New ones.
    uint64_t n_new;
    // Sketched ones so long that they got new laterals.
    uint64_t n_long;
    // New forks along those.
    uint64_t n_forks;
    // Open ends and forks of the sketch that lie outside the crown, where nothing grew.
    uint64_t n_ends_outside;
    // Those that end at the crown's surface.
    uint64_t n_touched;
    // Left out because the surface left too little of them.
    uint64_t n_outside;
    // Left out because they would have been shorter than `shortest`.
    uint64_t n_too_short;
    // Turned aside from an obstacle or the ground.
    uint64_t n_turned_aside;
    // Shortened because of an obstacle or the ground.
    uint64_t n_shortened;
    // Left out because of an obstacle or the ground.
    uint64_t n_blocked;
    // Left out because there would have been more than `max_segments`.
    uint64_t n_over_cap;
    // The last generation in which any grew.
    uint32_t generations;
    // Replication blocks taken from the sketch.
    uint32_t n_blocks;
    // Replication blocks drawn from Ω because the sketch has few of their order.
    uint32_t n_blocks_from_omega;
    // 0.
    uint32_t reserved;
} tree_sketch_propagate_report;

// How much the parts of the comparison weigh. Begin with `tree_template_select_params_init`.
typedef struct tree_template_select_params {
    // `sizeof(tree_template_select_params)`.
    size_t struct_size;
    // Weight of the crown's footprint, 0 to 1000. Default 40.
    float crown;
    // Weight of the branches' footprint, 0 to 1000. Default 40.
    float branches;
    // Weight of the branching shape, 0 to 1000. Default 1.
    float shape;
    // Weight of the directions of branches, 0 to 1000. Default 15.
    float directions;
    // Added to every deviation of the branching shape, 0.001 to 10: what the hand adds. Default 0.3.
    float hand;
    // What one of the branching shape's three parts can take away at most, 0 to 1000. Default 2.
    float most;
} tree_template_select_params;

// A template, and how well it suits a drawing.
typedef struct tree_template_choice {
    // Index of the template.
    uint32_t index;
    // Where the eye stands round the template in the view that suits best, in radians, 0 to 2π.
    float yaw;
    // 0 for a perfect match, else below: the sum of the four parts.
    float score;
    // The crown's part, weighted; 0 where no crown is drawn.
    float crown;
    // The part of the branches' footprint, weighted.
    float branches;
    // The branching shape's part, weighted.
    float shape;
    // The directions' part, weighted.
    float directions;
} tree_template_choice;

// All parameters of the way from a drawing to a tree. A part that is NULL, as all are after
// `tree_sketch_params_init`, is its default.
typedef struct tree_sketch_params {
    // `sizeof(tree_sketch_params)`.
    size_t struct_size;
    // Name of the template. Empty, the default: the one that suits the drawing best.
    struct tree_str template_name;
    // Species whose twigs and leaves the tree bears: one of the names that `tree_foliage_preset_name` gives. Empty,
    // the default: the template's.
    struct tree_str species;
    // How strokes are cleaned and joined. Its `height` is not used here.
    const struct tree_clean_params *clean;
    // How the crown is closed.
    const struct tree_crown_params *crown;
    // How templates are compared with the drawing.
    const struct tree_template_select_params *select;
    // How depths are inferred. Its `slenderness` is not used here.
    const struct tree_sketch_infer_params *infer;
    // How branches are propagated.
    const struct tree_sketch_propagate_params *propagate;
    // How branches become a tree. Its `species` is not used here, its `slenderness` counts relative to the default:
    // the template has its own.
    const struct tree_sketch_finish_params *finish;
    // Height of the drawing, branches and crown, in metres, 0.01 to 1000. 0, the default: the template's.
    float height;
    // 0.
    uint32_t reserved;
} tree_sketch_params;

// A stage of a session: one of the `TREE_SKETCH_STAGE_` constants, in the order in which they are done.
typedef uint32_t tree_sketch_stage;

// What became of a drawing on the way to a tree. Numbers of propagation count segments unless they say otherwise.
typedef struct tree_sketch_report {
    // `sizeof(tree_sketch_report)`.
    size_t struct_size;
    // Repairs of strokes.
    uint64_t n_stroke_repairs;
    // Repairs of the crown; 0 where none is drawn.
    uint64_t n_crown_repairs;
    // The posterior's logarithm.
    double posterior;
    // New segments of propagation.
    uint64_t grown_new;
    // Sketched ones so long that they got new laterals.
    uint64_t grown_long;
    // New forks along those.
    uint64_t grown_forks;
    // Open ends and forks of the sketch that lie outside the crown, where nothing grew.
    uint64_t grown_ends_outside;
    // Those that end at the crown's surface.
    uint64_t grown_touched;
    // Left out because the surface left too little of them.
    uint64_t grown_outside;
    // Left out because they would have been too short.
    uint64_t grown_too_short;
    // Turned aside from an obstacle or the ground.
    uint64_t grown_turned_aside;
    // Shortened because of an obstacle or the ground.
    uint64_t grown_shortened;
    // Left out because of an obstacle or the ground.
    uint64_t grown_blocked;
    // Left out because there would have been too many.
    uint64_t grown_over_cap;
    // Nodes of branches.
    uint64_t finish_wood_nodes;
    // Nodes of twigs.
    uint64_t finish_twig_nodes;
    // Nodes of twigs cut off because they left the crown or entered the ground.
    uint64_t finish_twig_nodes_cut;
    // Blades that stayed: rows of the foliage.
    uint64_t finish_leaves;
    // Blades left out because they left the crown or entered the ground.
    uint64_t finish_leaves_outside;
    // How much larger leaves are than the species', because there would be too many; a factor.
    float finish_leaves_larger;
    // How well the template suits the drawing, 0 for a perfect match, else below; 0 where it was taken by name or kept
    // through an edit.
    float score;
    // 1 where `score` counts.
    uint32_t has_score;
    // 1 where a crown is drawn, and the fields of the crown count.
    uint32_t has_crown;
    // Share of branch points outside the drawn crown, 0 to 1.
    float crown_outside;
    // Segments that were drawn, from fork to fork.
    uint32_t n_segments;
    // Crossings of branches in the drawing that could not be given room.
    uint32_t n_interpenetrations;
    // The last generation of propagation in which any grew.
    uint32_t grown_generations;
    // Replication blocks taken from the sketch.
    uint32_t grown_blocks;
    // Replication blocks drawn from Ω because the sketch has few of their order.
    uint32_t grown_blocks_from_omega;
} tree_sketch_report;

// How a template is measured. Begin with `tree_template_params_init`.
typedef struct tree_template_params {
    // `sizeof(tree_template_params)`.
    size_t struct_size;
    // Which branches are main ones; NULL for the default.
    const struct tree_main_branch_params *main;
    // Views over half a turn, 1 to 180. Default 8, so with mirror images one every 22.5°.
    uint32_t views;
    // 0.
    uint32_t reserved;
} tree_template_params;

// A template.
typedef struct tree_template_view {
    // `sizeof(tree_template_view)`.
    size_t struct_size;
    // What it is called.
    struct tree_str name;
    // The species whose leaves it bears, as `tree_finish_params_find` takes it where it is built in.
    struct tree_str species;
    // Height of the exemplar in metres: what a drawing is scaled to unless its height is given.
    float height;
    // Radius of the trunk's base over the height, 0 to 1.
    float slenderness;
    // Number of orders of axes that have parameters of their own.
    size_t n_orders;
    // Number of views; see `tree_templates_side`.
    size_t n_views;
} tree_template_view;

// What a template looks like from one side.
typedef struct tree_template_side {
    // `sizeof(tree_template_side)`.
    size_t struct_size;
    // Where the eye stands round the trunk, in radians, 0 to 2π: 0 on +Z, a quarter turn on +X.
    float yaw;
    // Mean and standard deviation of the natural logarithm of a segment's length over that of the one below. NaN where
    // there are no forks.
    float scale[2];
    // The same of the angle in radians at which the branch that bends least leaves the segment below.
    float alpha[2];
    // The same of all other branches.
    float beta[2];
    // 0.
    uint32_t reserved;
    // `TREE_DIRECTION_BINS` shares of the branches' length: what goes straight up comes first, straight down last.
    const float *directions;
    // Footprint of crown and branches without the root branch: `TREE_FOOTPRINT_DIRECTIONS` distances.
    const float *crown;
    // Footprint of the branches alone, as many.
    const float *branches;
    // Number of points of the silhouette.
    size_t n_silhouette;
    // Outline of the crown, two floats for each point, in metres, y up, the tree's base at the origin of y.
    const float *silhouette;
} tree_template_side;

// What kind of solid a volume is: one of the `TREE_SOLID_` constants.
typedef uint32_t tree_solid_kind;

// A view of what a volume is made of. What its kind does not use is 0 or NULL.
typedef struct tree_solid {
    // `sizeof(tree_solid)`.
    size_t struct_size;
    // Columns of points: a profile's distance and height, two floats each; a mesh's positions, three
    // floats each.
    const float *points;
    // Number of points.
    size_t n_points;
    // Three for each triangle of a mesh.
    const uint32_t *indices;
    // Number of triangles.
    size_t n_triangles;
    // Number of parts of a combination: 2 for a difference, 1 for a transformed volume. See
    // `tree_volume_part`.
    size_t n_parts;
    // Which solid it is.
    tree_solid_kind kind;
    // Centre, base, start, lower corner, point on the plane or apex.
    float a[3];
    // Top, end, upper corner, radii of an ellipsoid, normal, or the axis of a sector or revolution.
    float b[3];
    // Radius; that at the base of a frustum.
    float radius;
    // Radius at the top of a frustum.
    float top_radius;
    // Angle of a sector, in radians.
    float angle;
    // Map of a transformed volume, column by column as for `tree_volume_transformed`.
    float columns[12];
} tree_solid;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Murray's angles, at which a vessel of radius `r0` parts into `r1` and `r2` with the least volume:
// between the branch below and the first branch, then the second, in radians. Radii are above 0, and
// `r0` is from √|r1² - r2²| to √(r1² + r2²): elsewhere no such fork is.
tree_status tree_murray_angles(float r0,
                               float r1,
                               float r2,
                               float (*angles)[2]);

// Murray's angles where the branch below follows the pipe model with `exponent`, 2 to 10; exact for
// twigs however thin. `r1` and `r2` are above 0. Otherwise as `tree_murray_angles`.
tree_status tree_pipe_angles(float exponent, float r1, float r2, float (*angles)[2]);

// Holton's angles: the more strands a branch has, the less it turns. `s1` and `s2` are the strands of
// the two branches, not both 0; `sum` is the angle between them in radians, 0 to 2π. Otherwise as
// `tree_murray_angles`.
tree_status tree_strand_angles(uint64_t s1,
                               uint64_t s2,
                               float sum,
                               float (*angles)[2]);

// The radius of every node by a rule, in metres: `radii` has room for `capacity` floats, at least one
// for each node. `rule` may be NULL for the default. The radii that are there do not matter.
tree_status tree_skeleton_radii(const struct tree_skeleton *skeleton,
                                const struct tree_radius_rule *rule,
                                float *radii,
                                size_t capacity);

// A new skeleton with the radii that a rule gives, see `tree_skeleton_radii`. For radii of your own
// there is `tree_skeleton_with_radii`. Free it with `tree_skeleton_free`.
tree_status tree_skeleton_with_rule(const struct tree_skeleton *skeleton,
                                    const struct tree_radius_rule *rule,
                                    struct tree_skeleton **changed);

// The radius of every node by distance to the tip, in metres, with levels of your own in place of the
// axes' orders: `levels` has `n_levels` numbers, one for each node, 0 for the trunk. Of `rule`, which
// may be NULL for the default, the fields by distance to the tip count, whatever its kind is. `radii`
// has room for `capacity` floats, at least one for each node.
tree_status tree_skeleton_radii_at_levels(const struct tree_skeleton *skeleton,
                                          const uint32_t *levels,
                                          size_t n_levels,
                                          const struct tree_radius_rule *rule,
                                          float *radii,
                                          size_t capacity);

// The number of strands through every node; at every fork the children's numbers add up to the
// parent's. Of `rule`, which may be NULL for the default, the fields of strands count, whatever its kind
// is. `strands` has room for `capacity` numbers, at least one for each node.
tree_status tree_skeleton_strands(const struct tree_skeleton *skeleton,
                                  const struct tree_radius_rule *rule,
                                  uint64_t *strands,
                                  size_t capacity);

// Whether all fields of a rule are in order: `TREE_OK`, or the error that its use would give.
tree_status tree_radius_rule_check(const struct tree_radius_rule *rule);

// Makes `rule`, of `size` bytes, the default.
tree_status tree_radius_rule_init(struct tree_radius_rule *rule, size_t size);

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

// Frees a switch. Calls it was given to may still run.
tree_status tree_cancel_free(struct tree_cancel *cancel);

// Makes `costs`, of `size` bytes, the default.
tree_status tree_edit_costs_init(struct tree_edit_costs *costs, size_t size);

// Views the pairs, rising by the node of the first tree: where they begin and how many there are.
tree_status tree_edit_pairs_view(const struct tree_edit_pairs *pairs,
                                 const struct tree_edit_pair **rows,
                                 size_t *n_pairs);

// Frees pairs of nodes.
tree_status tree_edit_pairs_free(struct tree_edit_pairs *pairs);

// The constrained edit distance between two skeletons (Zhang 1996): the least cost of deleting, inserting and changing
// nodes that turns one tree into the other, where disjoint subtrees go to disjoint subtrees. The order of siblings and
// where nodes are do not matter. `params` and `control` may be NULL; set `distance->struct_size` first.
//
// The time goes with the product of the numbers of nodes and of children after the reduction. `TREE_ERROR_LIMIT` where
// more pairs of nodes would be kept than `tree_limits.pairs`, 16 bytes each: here those of the nodes of the first tree
// that wait for a sibling.
tree_status tree_skeleton_distance(const struct tree_skeleton *first,
                                   const struct tree_skeleton *second,
                                   const struct tree_edit_params *params,
                                   const struct tree_control *control,
                                   struct tree_edit_distance *distance);

// As `tree_skeleton_distance`, and hands out which node of the skeletons is changed into which; of runs and axes their
// uppermost nodes. All pairs of nodes are kept for it. `distance` may be NULL. Free the pairs with
// `tree_edit_pairs_free`.
tree_status tree_skeleton_distance_pairs(const struct tree_skeleton *first,
                                         const struct tree_skeleton *second,
                                         const struct tree_edit_params *params,
                                         const struct tree_control *control,
                                         struct tree_edit_distance *distance,
                                         struct tree_edit_pairs **pairs);

// As `tree_skeleton_distance`, of trees prepared for it: for many comparisons with the same tree, for trees that are no
// skeletons, and for costs of your own. `costs` and `control` may be NULL. `TREE_ERROR_PARAMETER` where `costs` gives
// what is no cost.
tree_status tree_edit_tree_distance(const struct tree_edit_tree *first,
                                    const struct tree_edit_tree *second,
                                    const struct tree_edit_costs *costs,
                                    const struct tree_control *control,
                                    struct tree_edit_distance *distance);

// As `tree_edit_tree_distance`, and hands out which node of the two trees is changed into which, as
// `tree_skeleton_distance_pairs` does.
tree_status tree_edit_tree_distance_pairs(const struct tree_edit_tree *first,
                                          const struct tree_edit_tree *second,
                                          const struct tree_edit_costs *costs,
                                          const struct tree_control *control,
                                          struct tree_edit_distance *distance,
                                          struct tree_edit_pairs **pairs);

// Makes `params`, of `size` bytes, the default.
tree_status tree_edit_params_init(struct tree_edit_params *params, size_t size);

// Reduces and weighs a skeleton, which is not kept. `params` may be NULL. Free the tree with `tree_edit_tree_free`.
tree_status tree_edit_tree_of_skeleton(const struct tree_skeleton *skeleton,
                                       const struct tree_edit_params *params,
                                       struct tree_edit_tree **tree);

// Makes a tree of columns, which are copied. `control` may be NULL; only its limits matter. `TREE_ERROR_INVALID` for a
// second root or parents that do not come first, `TREE_ERROR_PARAMETER` for weights below 0 or not finite. Free the
// tree with `tree_edit_tree_free`.
tree_status tree_edit_tree_from_columns(const struct tree_edit_columns *columns,
                                        const struct tree_control *control,
                                        struct tree_edit_tree **tree);

// Views the tree. Set `columns->struct_size` first.
tree_status tree_edit_tree_view(const struct tree_edit_tree *tree,
                                struct tree_edit_columns *columns);

// Frees a tree that is compared.
tree_status tree_edit_tree_free(struct tree_edit_tree *tree);

// What a branch of a mesh does in the wind. Set `motion->struct_size` first.
tree_status tree_mesh_branch_motion(const struct tree_mesh *mesh,
                                    size_t branch,
                                    struct tree_branch_motion *motion);

// How far along a branch of a mesh a point of three floats lies: 0 up to the collar, 1 at the tip and
// beyond.
tree_status tree_mesh_branch_reach(const struct tree_mesh *mesh,
                                   size_t branch,
                                   const float *point,
                                   float *reach);

// One branch for each axis of a skeleton, in the same order, turning about its fork. Those of a built
// mesh turn about the places where their bark stands. Free them with `tree_wind_branches_free`.
tree_status tree_skeleton_wind_branches(const struct tree_skeleton *skeleton,
                                        tree_continuation continuation,
                                        struct tree_wind_branches **branches);

// Views the branches: where they begin, and how many there are.
tree_status tree_wind_branches_view(const struct tree_wind_branches *branches,
                                    const struct tree_wind_branch **rows,
                                    size_t *n);

// Frees branches.
tree_status tree_wind_branches_free(struct tree_wind_branches *branches);

// Makes `params`, of `size` bytes, the default.
tree_status tree_capsule_params_init(struct tree_capsule_params *params, size_t size);

// Makes capsules of a skeleton's thick wood: few, and with nearly all of it inside. However few are
// allowed, the share asked for holds; what suffers is how tight they are, and the report says how tight.
// `params`, `control` and `report` may be NULL. Free the capsules with `tree_capsules_free`.
tree_status tree_skeleton_capsules(const struct tree_skeleton *skeleton,
                                   const struct tree_capsule_params *params,
                                   const struct tree_control *control,
                                   struct tree_capsule_report *report,
                                   struct tree_capsules **capsules);

// Views the capsules: where they begin, NULL for none, and how many there are.
tree_status tree_capsules_view(const struct tree_capsules *capsules,
                               const struct tree_capsule **rows,
                               size_t *n);

// Whether a point of three floats lies inside a capsule or on its border.
tree_status tree_capsule_contains(const struct tree_capsule *capsule,
                                  const float *point,
                                  uint32_t *inside);

// Volume of a capsule in cubic metres.
tree_status tree_capsule_volume(const struct tree_capsule *capsule, double *volume);

// Frees capsules.
tree_status tree_capsules_free(struct tree_capsules *capsules);

// What a convention says. Set `traits->struct_size` first.
tree_status tree_convention_view(tree_convention convention, struct tree_convention_traits *traits);

// Converts `n` places of three floats each, units included. `to` has room for as many and may be `from`
// itself; otherwise the two must not overlap.
tree_status tree_convert_positions(tree_convention convention,
                                   tree_convert way,
                                   const float *from,
                                   size_t n,
                                   float *to);

// Converts `n` unit vectors (normals, axes) of three floats each. `to` is as in
// `tree_convert_positions`.
tree_status tree_convert_directions(tree_convention convention,
                                    tree_convert way,
                                    const float *from,
                                    size_t n,
                                    float *to);

// Converts `n` tangents of four floats each. Their w is turned so that `w * cross(normal, tangent)`,
// with the arithmetic of their shaders, points the way green runs in their normal maps: up the picture,
// but down in Unreal. `to` is as in `tree_convert_positions`.
tree_status tree_convert_tangents(tree_convention convention,
                                  tree_convert way,
                                  const float *from,
                                  size_t n,
                                  float *to);

// Converts `n` texture coordinates of two floats each, to and back alike. `to` is as in
// `tree_convert_positions`.
tree_status tree_convert_uvs(tree_convention convention, const float *from, size_t n, float *to);

// Turns `n_triangles` triangles of three indices each where front faces run clockwise, to and back
// alike. `to` is as in `tree_convert_positions`.
tree_status tree_convert_triangles(tree_convention convention,
                                   const uint32_t *from,
                                   size_t n_triangles,
                                   uint32_t *to);

// Packs a surface of a mesh, in the axes of the engine the layout is for. `control` may be NULL; only a
// cancellation before the work begins matters. Free the result with `tree_packed_free`.
tree_status tree_mesh_pack(const struct tree_mesh *mesh,
                           size_t surface,
                           tree_layout layout,
                           const struct tree_control *control,
                           struct tree_packed **packed);

// Views streams and indices. Set `columns->struct_size` first.
tree_status tree_packed_view(const struct tree_packed *packed, struct tree_packed_columns *columns);

// Frees a packed surface, and with it all views of it.
tree_status tree_packed_free(struct tree_packed *packed);

// Views the textures of a surface packed with `TREE_LAYOUT_PIVOT_PAINTER`. Set `pivots->struct_size`
// first.
tree_status tree_packed_pivots(const struct tree_packed *packed,
                               struct tree_pivots *pivots);

// Reads an element back, 0 to `n_elements - 1`, to check a shader against. Set `element->struct_size`
// first.
tree_status tree_packed_pivot_element(const struct tree_packed *packed,
                                      uint32_t number,
                                      struct tree_pivot_element *element);

// Reads a packed surface back as an engine would, to check a shader against: it differs from what was
// packed by the quantisation only. `mesh`, which gives the table of branches, is needed for
// `TREE_LAYOUT_VERTEX` and may be NULL else. Free the result with `tree_unpacked_free`.
tree_status tree_packed_unpack(const struct tree_packed *packed,
                               const struct tree_mesh *mesh,
                               struct tree_unpacked **unpacked);

// Views what was read back. Set `columns->struct_size` first.
tree_status tree_unpacked_view(const struct tree_unpacked *unpacked,
                               struct tree_unpacked_columns *columns);

// Frees what was read back.
tree_status tree_unpacked_free(struct tree_unpacked *unpacked);

// Views the vertices of a surface packed with `TREE_LAYOUT_VERTEX`; its indices are in
// `tree_packed_view`. Set `vertices->struct_size` first.
tree_status tree_packed_vertices_view(const struct tree_packed *packed,
                                      struct tree_packed_vertices *vertices);

// Writes a row for each vertex of a surface; `capacity` must be the number of its vertices or more.
tree_status tree_mesh_wind(const struct tree_mesh *mesh,
                           size_t surface,
                           struct tree_vertex_wind *rows,
                           size_t capacity);

// Makes `wind`, of `size` bytes, the default.
tree_status tree_wind_init(struct tree_wind *wind, size_t size);

// Moves a surface by the wind, `seconds` after it began: the reference for a vertex shader. Writes three
// floats for each vertex, in metres; `capacity` is the room in floats, three times the number of
// vertices or more. `wind` may be NULL. A vertex whose branch is unknown stays where it is.
tree_status tree_mesh_bend(const struct tree_mesh *mesh,
                           const struct tree_wind *wind,
                           float seconds,
                           size_t surface,
                           float *positions,
                           size_t capacity);

// Share of its branch's turn that a point at this reach (0 to 1, else brought there) makes: 0 at the
// collar, 1 at the tip, as a clamped beam under an even load.
tree_status tree_wind_sway(float reach,
                           float *sway);

// Where in its flutter a leaf starts, 0 to 1, by its number in the surface.
tree_status tree_wind_leaf_phase(uint32_t leaf, float *phase);

// Grows leaves on a tree: the new tree has the old skeleton and species, and the new leaves in place of
// the old ones. For leaves on a bare skeleton, make a tree of it with `tree_tree_new`.
//
// `params` may be NULL for the default; `kind` must be a leaf kind of the tree's species. `density` may
// be NULL for 1 everywhere, and is handed `user`. With `with_stalks` (a yes or no) petioles and rachises become thin
// branches, for close-ups: old nodes keep number, position, radius and parent, stalks come after them,
// and leaves name the stalk that bears them; without, leaflets name the shoot's node. The same seed
// gives the same leaves. `report` may be NULL. Free the tree with `tree_tree_free`.
tree_status tree_tree_grow_leaves(const struct tree_tree *tree,
                                  const struct tree_leaf_params *params,
                                  tree_density_fn density,
                                  void *user,
                                  uint32_t with_stalks,
                                  uint64_t seed,
                                  const struct tree_control *control,
                                  struct tree_leaf_report *report,
                                  struct tree_tree **grown);

// Grows twigs on the youngest shoots of a tree: the new tree has the old skeleton with twigs, and the
// old leaves and species. Old nodes keep number, position, radius and parent, so leaves stay where they
// are; twigs come after them, each starting at the node nearest to its place. What bears twigs is not
// made thicker: `tree_skeleton_with_rule` does that.
//
// `params` may be NULL for the default. `density` may be NULL for 1 everywhere, and is handed `user`.
// The same seed gives the same twigs. `report` may be NULL. Free the tree with `tree_tree_free`.
tree_status tree_tree_grow_twigs(const struct tree_tree *tree,
                                 const struct tree_twig_params *params,
                                 tree_density_fn density,
                                 void *user,
                                 uint64_t seed,
                                 const struct tree_control *control,
                                 struct tree_twig_report *report,
                                 struct tree_tree **grown);

// Makes `params`, of `size` bytes, the default.
tree_status tree_leaf_params_init(struct tree_leaf_params *params, size_t size);

// Whether all fields are in order for a species with `n_kinds` kinds of leaves: `TREE_OK`, or the error
// that their use would give.
tree_status tree_leaf_params_check(const struct tree_leaf_params *params,
                                   size_t n_kinds);

// Number of species whose leaves and twigs are known by name.
size_t tree_foliage_preset_count(void);

// Name of the species with this number, from 0 up to, but not including, `tree_foliage_preset_count`.
// Valid for ever.
tree_status tree_foliage_preset_name(size_t index,
                                     struct tree_str *name);

// Leaves and twigs of a species by its name, of `len` bytes. Set `struct_size` of `leaves` and `twigs`
// first. `leaf_kind` is the name of the leaf kind that goes with them, valid for ever, for the
// `leaf_kinds` of a `tree_species`; it is kind 0 of the leaves. Each of the three may be NULL.
tree_status tree_foliage_preset(const char *name,
                                size_t len,
                                struct tree_leaf_params *leaves,
                                struct tree_twig_params *twigs,
                                struct tree_str *leaf_kind);

// Views the numbers: where they begin and how many there are.
tree_status tree_rows_view(const struct tree_rows *rows, const uint32_t **first, size_t *n);

// Frees the numbers.
tree_status tree_rows_free(struct tree_rows *rows);

// A new skeleton, the same but with nodes at most `spacing` metres apart (1e-5 to 1e6) on all segments
// that lie within `bearing` metres (0 to 1e6) of a tip, so that twigs find a node near their place. Old
// nodes keep their order but get other numbers; positions and radii between them are linear.
//
// `rows`, which may be NULL, gets for each node the old node at its segment's upper end; free it with
// `tree_rows_free`, and the skeleton with `tree_skeleton_free`.
tree_status tree_skeleton_refine(const struct tree_skeleton *skeleton,
                                 float bearing,
                                 float spacing,
                                 const struct tree_control *control,
                                 struct tree_rows **rows,
                                 struct tree_skeleton **refined);

// Makes `params`, of `size` bytes, the default.
tree_status tree_twig_params_init(struct tree_twig_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_twig_params_check(const struct tree_twig_params *params);

// Grows a tree that stands alone; for several that compete there is `tree_growth_stand`. The same parameters and `seed`
// give the same bits for any number of threads. `params` and `control` may be NULL. Free it with `tree_grown_free`.
// `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` where the base or the first internode is in
// the obstacle; `TREE_ERROR_LIMIT` comes before more nodes, voxels or leaves are made than allowed.
tree_status tree_growth_grow(const struct tree_growth_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             struct tree_grown **grown);

// The tree, not copied. Free it with `tree_tree_free`; it may outlive what it was asked of.
tree_status tree_grown_tree(const struct tree_grown *grown, struct tree_tree **tree);

// Views ages, orders and years. Set `columns->struct_size` first.
tree_status tree_grown_view(const struct tree_grown *grown, struct tree_grown_columns *columns);

// Frees a grown tree. Trees handed out live on.
tree_status tree_grown_free(struct tree_grown *grown);

// Makes `habit`, of `size` bytes, the default.
tree_status tree_growth_habit_init(struct tree_growth_habit *habit, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_growth_params_init(struct tree_growth_params *params, size_t size);

// Whether all fields, those of world and habit too, are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_growth_params_check(const struct tree_growth_params *params);

// Makes `plant`, of `size` bytes, the default.
tree_status tree_growth_plant_init(struct tree_growth_plant *plant, size_t size);

// Number of presets of growing trees.
size_t tree_growth_preset_count(void);

// Name of a preset, such as `oak`; valid for ever. `index` is below `tree_growth_preset_count`.
tree_status tree_growth_preset_name(size_t index, struct tree_str *name);

// Makes `params`, of `size` bytes, the preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). World and habit, and
// what they point at, belong to the library and live for ever: to alter one, copy it and point at the copy. The habit is
// for `tree_growth_plant` too. `TREE_ERROR_UNKNOWN_NAME` lists the names there are.
tree_status tree_growth_preset(const char *name,
                               size_t len,
                               struct tree_growth_params *params,
                               size_t size);

// Plants seedlings: a base and one internode each, 1 to 100,000 of them. `world` and `control` may be NULL. Free it with
// `tree_growth_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` for a seedling in the
// obstacle.
tree_status tree_growth_new(const struct tree_growth_world *world,
                            const struct tree_growth_plant *plants,
                            size_t n_plants,
                            uint64_t seed,
                            const struct tree_control *control,
                            struct tree_growth **growth);

// As `tree_growth_new`, and grows them for `iterations`, 0 to 10,000. `tree_growth_grown` hands out the trees.
tree_status tree_growth_stand(const struct tree_growth_world *world,
                              const struct tree_growth_plant *plants,
                              size_t n_plants,
                              uint32_t iterations,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_growth **growth);

// Goes on for `iterations`: in each, buds sense, vigour is shared out, shoots grow, weak branches are shed. `control` may
// be NULL. After an error all is as it was: the iterations are done on a copy, which takes as much memory again.
// `TREE_ERROR_PARAMETER` beyond 10,000 iterations in all; `TREE_ERROR_LIMIT` comes before more nodes or voxels are made
// than allowed.
tree_status tree_growth_step(struct tree_growth *growth,
                             uint32_t iterations,
                             const struct tree_control *control);

// Counts iterations, trees and nodes. Set `counts->struct_size` first.
tree_status tree_growth_measure(const struct tree_growth *growth,
                                struct tree_growth_counts *counts);

// The light as it is now at `n_points` points, three floats each in metres: 0 to the world's brightness, into `light`,
// which has room for as many. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_growth_light(const struct tree_growth *growth,
                              const float *points,
                              size_t n_points,
                              const struct tree_control *control,
                              float *light);

// A tree as it is now, with radii, leaves and ages. `index` is its place among the plants. `control` may be NULL. Free it
// with `tree_grown_free`.
tree_status tree_growth_grown(const struct tree_growth *growth,
                              size_t index,
                              const struct tree_control *control,
                              struct tree_grown **grown);

// A second one in the state of the first, to try something. Free it too.
tree_status tree_growth_copy(const struct tree_growth *growth, struct tree_growth **copy);

// Frees growing trees. Trees handed out live on. `TREE_ERROR_ORDER` while a call is at work on them.
tree_status tree_growth_free(struct tree_growth *growth);

// Makes `world`, of `size` bytes, the default: open and lit from above.
tree_status tree_growth_world_init(struct tree_growth_world *world, size_t size);

// Makes a choice for one instance of a model, with room for all there can ever be; level 1 and no leaves until it is
// updated. Free it with `tree_hybrid_choice_free`.
tree_status tree_hybrid_choice_new(const struct tree_hybrid *hybrid,
                                   struct tree_hybrid_choice **choice);

// What is drawn where the whole tree is `pixels` high, above 0 and at most 1e5, at the same scale everywhere: for files,
// previews, and levels of engines that have no shaders of ours. Free it with `tree_hybrid_choice_free`.
tree_status tree_hybrid_choice_for_height(const struct tree_hybrid *hybrid,
                                          float pixels,
                                          struct tree_hybrid_choice **choice);

// Chooses for a frame: a level of wood, and of leaves as `tree_card_choice_update` does it. It takes no memory.
//
// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
// above 0, at most 1e9. `report` may be NULL when it is not wanted. `TREE_ERROR_PARAMETER` for numbers out of range; the
// choice is left as it was then.
tree_status tree_hybrid_choice_update(struct tree_hybrid_choice *choice,
                                      const float *eye,
                                      float pixels_per_metre,
                                      struct tree_hybrid_choice_report *report);

// Tells how much is drawn since the last update. Set `report->struct_size` first.
tree_status tree_hybrid_choice_measure(const struct tree_hybrid_choice *choice,
                                       struct tree_hybrid_choice_report *report);

// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
// `n_boxes` of the report; as many as there are boxes are always enough.
tree_status tree_hybrid_choice_boxes(const struct tree_hybrid_choice *choice,
                                     uint32_t *boxes,
                                     size_t capacity);

// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined: `tree_hybrid_leaf_window` tells their
// indices. `ranges` has room for `capacity` of them, at least `n_ranges` of the report; as many as there are boxes are
// always enough.
tree_status tree_hybrid_choice_ranges(const struct tree_hybrid_choice *choice,
                                      struct tree_leaf_range *ranges,
                                      size_t capacity);

// What is chosen as a plain mesh: the wood grown to its level, leaves, and three planes of each box, with light as on a
// crown. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free the mesh with
// `tree_mesh_free`.
tree_status tree_hybrid_choice_mesh(const struct tree_hybrid_choice *choice,
                                    const struct tree_control *control,
                                    struct tree_mesh **mesh);

// Frees a choice.
tree_status tree_hybrid_choice_free(struct tree_hybrid_choice *choice);

// Levels as the `MSFT_lod` of one GLB file, each a mesh of its own, as `tree_hybrid_choice_mesh` makes it: for programs
// without shaders of ours. `heights` are `n_heights` heights of the tree on the screen in pixels, falling, at most 1024:
// each level is made for its height, and shown until the tree is as high as the next one says; the last is shown to the
// end. `screen` is the height of the screen in pixels, 1 to 1e5. `options` and `control` may be NULL, as in
// `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no heights or they do
// not fall.
tree_status tree_hybrid_to_glb_levels(const struct tree_hybrid *hybrid,
                                      const float *heights,
                                      size_t n_heights,
                                      float screen,
                                      const struct tree_glb_options *options,
                                      const struct tree_control *control,
                                      struct tree_bytes **bytes);

// As `tree_hybrid_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_hybrid_write_glb_levels(const struct tree_hybrid *hybrid,
                                         const float *heights,
                                         size_t n_heights,
                                         float screen,
                                         const char *path,
                                         size_t path_len,
                                         const struct tree_glb_options *options,
                                         const struct tree_control *control);

// Makes the model of a tree: sorts its branches (`tree_multires_new`), draws them (`tree_multi_mesh_new`), puts its
// leaves into boxes (`tree_leaf_boxes_along`) and takes their pictures (`tree_cards_bake`), which takes most of the
// time. `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL.
// Free the model with `tree_hybrid_free`. Errors are those of the steps.
tree_status tree_hybrid_make(const struct tree_tree *tree,
                             const struct tree_look *look,
                             const struct tree_hybrid_params *params,
                             const struct tree_control *control,
                             struct tree_hybrid **hybrid);

// Tells how large a model is. Set `totals->struct_size` first.
tree_status tree_hybrid_measure(const struct tree_hybrid *hybrid,
                                struct tree_hybrid_totals *totals);

// The mesh to upload, nothing copied: surface 0 is the wood, of which a level is a prefix; the others are leaves, kind by
// kind, in the order of the boxes, so that each box has one window (`tree_hybrid_leaf_window`). Free it with
// `tree_mesh_free`; it keeps alive what it is of.
tree_status tree_hybrid_mesh(const struct tree_hybrid *hybrid,
                             struct tree_mesh **mesh);

// The sorted tree, nothing copied. Free it with `tree_multires_free`; it keeps alive what it is of.
tree_status tree_hybrid_multires(const struct tree_hybrid *hybrid, struct tree_multires **multires);

// The wood and its levels, with leaves in the order of their paths, nothing copied: `tree_multi_mesh_branches` of surface
// 0 and `tree_multi_mesh_draws` are right for the model's mesh too. Free it with `tree_multi_mesh_free`; it keeps alive
// what it is of.
tree_status tree_hybrid_wood(const struct tree_hybrid *hybrid,
                             struct tree_multi_mesh **wood);

// Boxes and pictures of the leaves, nothing copied. Free them with `tree_cards_free`; they keep alive what they are of.
// `TREE_ERROR_NO_RESULT` when the tree has no leaves.
tree_status tree_hybrid_cards(const struct tree_hybrid *hybrid,
                              struct tree_cards **cards);

// Which indices of surface `number` of the model's mesh draw `n_leaves` leaves from row `first_leaf` on, as
// `tree_hybrid_choice_ranges` gives them. None for the wood, and for rows that are not there. `TREE_ERROR_PARAMETER` when there is no such surface.
tree_status tree_hybrid_leaf_window(const struct tree_hybrid *hybrid,
                                    size_t number,
                                    uint32_t first_leaf,
                                    uint32_t n_leaves,
                                    struct tree_index_window *window);

// The fractional level of the wood where a metre covers so many pixels, 0 to infinity; it changes without a step.
// `TREE_ERROR_PARAMETER` for less than 0, or NaN.
tree_status tree_hybrid_level(const struct tree_hybrid *hybrid,
                              float pixels_per_metre,
                              float *level);

// Frees a model. Its parts that were asked for, and choices, stay.
tree_status tree_hybrid_free(struct tree_hybrid *hybrid);

// Makes `params`, of `size` bytes, the default.
tree_status tree_hybrid_params_init(struct tree_hybrid_params *params, size_t size);

// Checks every field of `params` and of its parts; `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
// fault.
tree_status tree_hybrid_params_check(const struct tree_hybrid_params *params);

// Writes the node of the tree's skeleton that carries each element, leaf by leaf, exactly: for a mesh that was built
// of this tree. `elements` must be whole leaves (`TREE_GRAIN_LEAF`). `bearers` has room for `capacity` numbers, at least
// one for each element. `TREE_ERROR_INVALID` when mesh and tree have different numbers of leaves.
tree_status tree_leaf_bearers_of_tree(const struct tree_tree *tree,
                                      const struct tree_mesh *mesh,
                                      const struct tree_elements *elements,
                                      uint32_t *bearers,
                                      size_t capacity);

// Writes the nearest node of the skeleton to the middle of each element: for meshes whose leaves are not known to a
// tree. `bearers` has room for `capacity` numbers, at least one for each element. `control` may be NULL.
tree_status tree_leaf_bearers_nearest(const struct tree_skeleton *skeleton,
                                      const struct tree_elements *elements,
                                      const struct tree_control *control,
                                      uint32_t *bearers,
                                      size_t capacity);

// Makes `params`, of `size` bytes, the default.
tree_status tree_leaf_box_params_init(struct tree_leaf_box_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_leaf_box_params_check(const struct tree_leaf_box_params *params);

// Finds the boxes of a tree. `elements` are its leaves, `bearers` the node of the skeleton that carries each of the
// `n_bearers` elements, as `tree_leaf_bearers_of_tree` or `tree_leaf_bearers_nearest` finds it. `params` and `control`
// may be NULL, `report` when it is not wanted. Progress is told in the stage `boxes`. Free the boxes with
// `tree_leaf_boxes_free`.
//
// `TREE_ERROR_INVALID` when there is not one bearer for each element, a bearer does not exist, the elements are of
// another mesh, or all leaves are one point.
tree_status tree_leaf_boxes_along(const struct tree_skeleton *skeleton,
                                  const struct tree_mesh *mesh,
                                  const struct tree_elements *elements,
                                  const uint32_t *bearers,
                                  size_t n_bearers,
                                  const struct tree_leaf_box_params *params,
                                  const struct tree_control *control,
                                  struct tree_leaf_boxes_report *report,
                                  struct tree_leaf_boxes **boxes);

// Tells how many boxes there are, and what became of the leaves. Set `report->struct_size` first.
tree_status tree_leaf_boxes_measure(const struct tree_leaf_boxes *boxes,
                                    struct tree_leaf_boxes_report *report);

// Tells what box `number` is; 0 is the whole tree. Set `leaf_box->struct_size` first. `TREE_ERROR_PARAMETER` when there
// is no such box.
tree_status tree_leaf_boxes_get(const struct tree_leaf_boxes *boxes,
                                uint32_t number,
                                struct tree_leaf_box *leaf_box);

// The numbers of all leaves (elements), in the order in which those of every box are one range: `n_leaves` of them,
// from `order` on. They stay for as long as the boxes do.
tree_status tree_leaf_boxes_order(const struct tree_leaf_boxes *boxes,
                                  const uint32_t **order,
                                  size_t *n_leaves);

// Distance in metres from `point`, three floats, to box `number`; 0 inside. `TREE_ERROR_PARAMETER` when there is no
// such box.
tree_status tree_leaf_boxes_distance(const struct tree_leaf_boxes *boxes,
                                     uint32_t number,
                                     const float *point,
                                     float *metres);

// Writes the six planes of box `number`, two for each of its axes, which lies in both: plane 2k holds axis k and the
// diagonal of the next two axes, plane 2k + 1 the other diagonal. `planes` has room for `capacity` of them.
// `TREE_ERROR_PARAMETER` when there is no such box.
tree_status tree_leaf_boxes_planes(const struct tree_leaf_boxes *boxes,
                                   uint32_t number,
                                   struct tree_card_plane *planes,
                                   size_t capacity);

// Frees boxes, and with them all views of their order.
tree_status tree_leaf_boxes_free(struct tree_leaf_boxes *boxes);

// Makes `params`, of `size` bytes, the default.
tree_status tree_card_params_init(struct tree_card_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_card_params_check(const struct tree_card_params *params);

// Projects the leaves of every box onto its planes. `boxes`, which are copied, are those of `elements` of `mesh`.
// `params` and `control` may be NULL, `report` when it is not wanted. Progress is told in the stage `cards`. The same
// input gives the same bytes for any number of threads. Free the cards with `tree_cards_free`.
//
// `TREE_ERROR_PARAMETER` also when the atlas would be wider than 16,384 texels, `TREE_ERROR_INVALID` when boxes,
// elements and mesh do not belong together.
tree_status tree_cards_bake(const struct tree_mesh *mesh,
                            const struct tree_elements *elements,
                            const struct tree_leaf_boxes *boxes,
                            const struct tree_card_params *params,
                            const struct tree_control *control,
                            struct tree_cards_report *report,
                            struct tree_cards **cards);

// Tells what was baked. Set `report->struct_size` first.
tree_status tree_cards_measure(const struct tree_cards *cards, struct tree_cards_report *report);

// The boxes of cards, nothing copied. Free them with `tree_leaf_boxes_free`; they keep the cards alive.
tree_status tree_cards_boxes(const struct tree_cards *cards,
                             struct tree_leaf_boxes **boxes);

// Metres of a texel of the pictures of box `number`: the largest of its planes. `TREE_ERROR_INVALID` when there is no
// such box.
tree_status tree_cards_texel(const struct tree_cards *cards,
                             uint32_t number,
                             float *metres);

// Views the pixels of an atlas, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
// `TREE_IMPOSTOR_DETAIL` goes from minus the `reach` of the plane to it, on the side that its normal points to. Set
// `pixels->struct_size` first.
tree_status tree_cards_pixels(const struct tree_cards *cards,
                              tree_impostor_map map,
                              struct tree_pixels *pixels);

// A copy of an atlas, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`. `map` is a
// `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
tree_status tree_cards_picture(const struct tree_cards *cards,
                               tree_impostor_map map,
                               const struct tree_control *control,
                               struct tree_picture **picture);

// A copy of the atlas of colours with light: the share of the sky that is seen through the leaves around, and softly by the
// normal. `control` may be NULL. Free the picture with `tree_picture_free`.
tree_status tree_cards_lit(const struct tree_cards *cards,
                           const struct tree_control *control,
                           struct tree_picture **picture);

// Frees cards, and with them all views of their pixels. Boxes and meshes made of them stay.
tree_status tree_cards_free(struct tree_cards *cards);

// The planes of `n_boxes` boxes as a mesh, six squares of four vertices each, with the atlas as their texture: alpha is
// tested against one half, both sides are drawn. Without the shader (`tree_cards_shader`) all six planes of a box are
// drawn at once, which covers more than the leaves do. At most 65,536 boxes; `control` may be NULL. Free the mesh with
// `tree_mesh_free`. `TREE_ERROR_INVALID` when there is no such box.
tree_status tree_cards_mesh(const struct tree_cards *cards,
                            const uint32_t *boxes,
                            size_t n_boxes,
                            const struct tree_control *control,
                            struct tree_mesh **mesh);

// The planes of `n_boxes` boxes for programs without the shader: of each box those that together look best from around and a
// little above, both sides as squares of their own, lit (`tree_cards_lit`) and with the normals of a rounded crown. As
// `tree_cards_mesh` in all else.
tree_status tree_cards_plain(const struct tree_cards *cards,
                             const uint32_t *boxes,
                             size_t n_boxes,
                             const struct tree_control *control,
                             struct tree_mesh **mesh);

// As `tree_cards_mesh`, of some planes of each box only: `n_planes` numbers, 0 to 5, as `tree_leaf_boxes_planes` counts
// them, at most six. For programs without the shader: 0, 2 and 4, one for each axis, cover about as much as the leaves
// do. `TREE_ERROR_INVALID` when there is no such box or plane.
tree_status tree_cards_mesh_of_planes(const struct tree_cards *cards,
                                      const uint32_t *boxes,
                                      size_t n_boxes,
                                      const uint32_t *planes,
                                      size_t n_planes,
                                      const struct tree_control *control,
                                      struct tree_mesh **mesh);

// What a camera sees of `n_boxes` boxes, at most 65,536, by one sample for each pixel: sRGB colour without light, alpha
// 0 or 255. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
// (`tree_view_place` helps). `control` may be NULL. Free the picture with `tree_picture_free`.
//
// `TREE_ERROR_INVALID` for a framed camera, a box that does not exist, or an eye in the middle of a box.
tree_status tree_cards_view(const struct tree_cards *cards,
                            const uint32_t *boxes,
                            size_t n_boxes,
                            const struct tree_view *view,
                            const struct tree_control *control,
                            struct tree_picture **picture);

// The planes of `n_boxes` boxes as a GLB file in memory: as `tree_cards_mesh`, and what the shader needs, four floats for
// each vertex: `_TREE_CENTER` (middle of the box in metres, number of the plane), `_TREE_HALF` (half its sides in
// metres, its number) and `_TREE_TURN` (the quaternion that turns its axes into those of the tree). `options` and
// `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
// `quantize`: shaders need positions in metres.
tree_status tree_cards_to_glb(const struct tree_cards *cards,
                              const uint32_t *boxes,
                              size_t n_boxes,
                              const struct tree_glb_options *options,
                              const struct tree_control *control,
                              struct tree_bytes **bytes);

// As `tree_cards_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_cards_write_glb(const struct tree_cards *cards,
                                 const uint32_t *boxes,
                                 size_t n_boxes,
                                 const char *path,
                                 size_t path_len,
                                 const struct tree_glb_options *options,
                                 const struct tree_control *control);

// The functions that weigh planes in a shader, as `tree_card_weights` does it: text to be put into your own. It tells what
// they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
tree_status tree_cards_shader(tree_shader language,
                              struct tree_str *text);

// Makes `params`, of `size` bytes, the default.
tree_status tree_card_choose_params_init(struct tree_card_choose_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_card_choose_params_check(const struct tree_card_choose_params *params);

// Makes a choice for one instance of a tree with these cards, with room for all there can ever be and all boxes
// closed. It does not keep the cards alive. Free it with `tree_card_choice_free`.
tree_status tree_card_choice_new(const struct tree_cards *cards,
                                 struct tree_card_choice **choice);

// Chooses for a frame: from the box of the whole tree down, where a texel would be larger than a pixel, the children are
// drawn instead, and the box's own leaves as geometry. Every leaf is in one box or one range. It takes no memory.
//
// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
// above 0, at most 1e9. `params` may be NULL, `report` when it is not wanted.
//
// `TREE_ERROR_PARAMETER` for numbers out of range, `TREE_ERROR_INVALID` when the choice was made for other cards. The
// choice is left as it was then.
tree_status tree_card_choice_update(struct tree_card_choice *choice,
                                    const struct tree_cards *cards,
                                    const float *eye,
                                    float pixels_per_metre,
                                    const struct tree_card_choose_params *params,
                                    struct tree_card_choice_report *report);

// Tells how much is drawn since the last update. Set `report->struct_size` first.
tree_status tree_card_choice_measure(const struct tree_card_choice *choice,
                                     struct tree_card_choice_report *report);

// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
// `n_boxes` of the report; as many as there are boxes are always enough.
tree_status tree_card_choice_boxes(const struct tree_card_choice *choice,
                                   uint32_t *boxes,
                                   size_t capacity);

// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined. `ranges` has room for `capacity` of
// them, at least `n_ranges` of the report; as many as there are boxes are always enough.
tree_status tree_card_choice_ranges(const struct tree_card_choice *choice,
                                    struct tree_leaf_range *ranges,
                                    size_t capacity);

// Frees a choice.
tree_status tree_card_choice_free(struct tree_card_choice *choice);

// The place on the unit square of `direction`, three floats to the viewer, of any length. With `hemi`, directions below
// the horizon are brought up to it. `TREE_ERROR_PARAMETER` for a direction that is zero or not finite.
tree_status tree_octahedral_encode(const float *direction,
                                   uint32_t hemi,
                                   float (*place)[2]);

// The unit direction of `place`, two floats on the unit square: the inverse of `tree_octahedral_encode`.
// `TREE_ERROR_PARAMETER` for a place outside the square.
tree_status tree_octahedral_decode(const float *place,
                                   uint32_t hemi,
                                   float (*direction)[3]);

// Writes the three views around `direction`, three floats to the viewer, and their weights, which sum to 1 and change
// continuously. `grid` and `hemi` are those of the impostor; `frames` has room for `capacity` views, at least 3.
// `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64, or a direction that is zero or not finite.
tree_status tree_octahedral_frames(const float *direction,
                                   uint32_t grid,
                                   uint32_t hemi,
                                   struct tree_octahedral_frame *frames,
                                   size_t capacity);

// Where a view was taken from: unit vectors to the right of the picture, up it, and to the viewer. Up is as near to +Y
// as it can be; seen from straight above or below, right is +X. `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64,
// or a column or row that it lacks.
tree_status tree_octahedral_axes(uint32_t column,
                                 uint32_t row,
                                 uint32_t grid,
                                 uint32_t hemi,
                                 float (*right)[3],
                                 float (*up)[3],
                                 float (*toward)[3]);

// A picture and its smaller levels, each half as wide and high (rounded down, at least 1): at most `most` in all, and at
// least the picture itself. Colours are means in linear light, weighted by alpha. Alpha is the mean, scaled so
// that the share of texels that pass a test against one half stays as in the first level: leaves do not vanish from
// afar. It is for colours, not for `TREE_IMPOSTOR_DETAIL`. `control` may be NULL; `pixels` of its limits caps twice
// those of the picture. Free the levels with `tree_mips_free`.
tree_status tree_mips_of_picture(const struct tree_picture *picture,
                                 size_t most,
                                 const struct tree_control *control,
                                 struct tree_mips **mips);

// Number of levels.
tree_status tree_mips_count(const struct tree_mips *mips, size_t *n_levels);

// Views the pixels of level `number`; 0 is the picture itself. Set `pixels->struct_size` first.
// `TREE_ERROR_PARAMETER` when there is no such level.
tree_status tree_mips_view(const struct tree_mips *mips, size_t number, struct tree_pixels *pixels);

// Frees levels, and with them all views of them.
tree_status tree_mips_free(struct tree_mips *mips);

// Bakes all of a mesh, leaves and wood. `params` and `control` may be NULL, `report` when it is not wanted. Progress is
// told in the stage `views`. The same input gives the same bytes for any number of threads. Free the impostor with
// `tree_octahedral_free`.
//
// `TREE_ERROR_INVALID` when nothing of the mesh can be seen or all of it is one point.
tree_status tree_octahedral_bake(const struct tree_mesh *mesh,
                                 const struct tree_octahedral_params *params,
                                 const struct tree_control *control,
                                 struct tree_octahedral_report *report,
                                 struct tree_octahedral **octahedral);

// An impostor that was baked before: its numbers and its two pictures, which are copied. `control` may be NULL; `pixels`
// of its limits caps those of both. What `tree_octahedral_measure` tells of it is 0, but for the bytes. Free it with
// `tree_octahedral_free`. `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` when the parts do not fit each other.
tree_status tree_octahedral_from_pictures(const struct tree_octahedral_meta *meta,
                                          const struct tree_picture *color,
                                          const struct tree_picture *detail,
                                          const struct tree_control *control,
                                          struct tree_octahedral **octahedral);

// Tells what was baked. Set `report->struct_size` first.
tree_status tree_octahedral_measure(const struct tree_octahedral *octahedral,
                                    struct tree_octahedral_report *report);

// The numbers that go with the pictures. Set `meta->struct_size` first.
tree_status tree_octahedral_describe(const struct tree_octahedral *octahedral,
                                     struct tree_octahedral_meta *meta);

// The numbers that go with the pictures as JSON, to be stored beside them; they are read as the same bits. Free the
// bytes with `tree_bytes_free`.
tree_status tree_octahedral_to_json(const struct tree_octahedral *octahedral,
                                    struct tree_bytes **bytes);

// Views the pixels of one of the two pictures, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
// `TREE_IMPOSTOR_DETAIL` goes from minus the `radius` to it, towards the viewer. Set `pixels->struct_size` first.
tree_status tree_octahedral_pixels(const struct tree_octahedral *octahedral,
                                   tree_impostor_map map,
                                   struct tree_pixels *pixels);

// A copy of one of the two pictures, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`.
// `map` is a `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
tree_status tree_octahedral_picture(const struct tree_octahedral *octahedral,
                                    tree_impostor_map map,
                                    const struct tree_control *control,
                                    struct tree_picture **picture);

// What a camera sees, by one ray for each pixel: sRGB colour without light, and alpha, to be tested against
// one half. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
// (`tree_view_place` helps); for a framed one `TREE_ERROR_INVALID`. `control` may be NULL. Free the picture with
// `tree_picture_free`.
tree_status tree_octahedral_view(const struct tree_octahedral *octahedral,
                                 const struct tree_view *view,
                                 const struct tree_control *control,
                                 struct tree_picture **picture);

// Alpha alone, as `tree_octahedral_view`. Free the mask with `tree_mask_free`.
tree_status tree_octahedral_mask(const struct tree_octahedral *octahedral,
                                 const struct tree_view *view,
                                 const struct tree_control *control,
                                 struct tree_mask **mask);

// The functions that draw an octahedral impostor in a shader, as `tree_octahedral_view` does it: text to be put into your
// own. It tells what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never
// freed.
tree_status tree_octahedral_shader(tree_shader language,
                                   struct tree_str *text);

// Frees an impostor, and with it all views of its pixels.
tree_status tree_octahedral_free(struct tree_octahedral *octahedral);

// Checks that the numbers fit each other: `TREE_ERROR_PARAMETER` names the first that is out of range,
// `TREE_ERROR_INVALID` says what is wrong with `detail_side`.
tree_status tree_octahedral_meta_check(const struct tree_octahedral_meta *meta);

// Half width and half height in metres of a view whose direction to the viewer, of unit length, has this `y`, and half
// the depth of the tree in it: what the cylinder around it fills.
tree_status tree_octahedral_meta_extent(const struct tree_octahedral_meta *meta,
                                        float y,
                                        float (*half)[2],
                                        float *reach);

// Makes `params`, of `size` bytes, the default.
tree_status tree_octahedral_params_init(struct tree_octahedral_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_octahedral_params_check(const struct tree_octahedral_params *params);

// The weights of the six planes of a box: `half` is three floats, half its sides, `direction` three floats, to the viewer
// along the box's own axes (turned by the inverse of its `turn`), of any length. They sum to 1 and change
// continuously; a plane seen edge-on has none. `TREE_ERROR_INVALID` for a direction that is zero or not finite, or half
// sides that are not all above 0.
tree_status tree_card_weights(const float *half,
                              const float *direction,
                              float (*weights)[6]);

// The part of 0 to 1 that belongs to a plane, 0 to 5, given the six `weights`: as long as its weight, after those of the
// planes before it. A pixel draws the plane in whose interval its `tree_card_noise` lies.
tree_status tree_card_interval(const float *weights,
                               uint32_t plane,
                               float (*interval)[2]);

// A pattern over pixels, 0 to 1, nearly even in each neighbourhood of 3 by 3: `pixel` is two floats, its middle as a
// shader is told it.
tree_status tree_card_noise(const float *pixel,
                            float *share);

// Divides a tree into a base mesh and instances of at most `max_twigs` unique twigs. Light-map
// coordinates are left out, since instances share their vertices. `look` may be NULL: the built-in
// textures that the tree's species names. `mesh_params`, `params` and `report` may be NULL. Free the twigs
// with `tree_twigs_free`.
tree_status tree_twigs_build(const struct tree_tree *tree,
                             const struct tree_look *look,
                             const struct tree_mesh_params *mesh_params,
                             const struct tree_instancing_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             struct tree_instancing_report *report,
                             struct tree_twigs **twigs);

// Number of unique twigs.
tree_status tree_twigs_count(const struct tree_twigs *twigs, size_t *n_twigs);

// What the twigs weigh and how near they come. Set `report->struct_size` first.
tree_status tree_twigs_measure(const struct tree_twigs *twigs,
                               struct tree_instancing_report *report);

// The base mesh: wood and leaves that are not part of a twig, surfaces as `tree_mesh_build` makes them.
// Not copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
tree_status tree_twigs_base(const struct tree_twigs *twigs,
                            struct tree_mesh **base);

// The mesh of twig `number`, its base at the origin; surfaces and materials as in the base mesh. Not
// copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
tree_status tree_twigs_mesh(const struct tree_twigs *twigs,
                            size_t number,
                            struct tree_mesh **mesh);

// Views all places where twig `number` stands. Set `instances->struct_size` first. Valid until the twigs
// are freed.
tree_status tree_twigs_instances(const struct tree_twigs *twigs,
                                 size_t number,
                                 struct tree_twig_instances *instances);

// Makes twigs of parts of your own: a base mesh, and for each of `n_twigs` twigs its mesh, with as many
// surfaces as the base, and where it stands. All is copied but the textures, and checked; scales must be
// the same along all axes. The report has the sizes; `reach` and `deviation` are 0 in it. `control` may
// be NULL; of its limits `triangles` caps those of all meshes together, and `leaves` the instances. Free
// the twigs with `tree_twigs_free`.
tree_status tree_twigs_from_parts(const struct tree_mesh *base,
                                  const struct tree_mesh *const *meshes,
                                  const struct tree_twig_instances *instances,
                                  size_t n_twigs,
                                  const struct tree_control *control,
                                  struct tree_twigs **twigs);

// Makes one plain mesh of base and instances: surfaces as the base has them, with the instances'
// triangles behind. Columns that not all parts have, and light-map coordinates, are left out. Every
// instance gets branches of its own, carried by the branch it stands on. Free the mesh with
// `tree_mesh_free`.
tree_status tree_twigs_flatten(const struct tree_twigs *twigs,
                               const struct tree_control *control,
                               struct tree_mesh **mesh);

// Frees twigs. Meshes that were asked of them live on.
tree_status tree_twigs_free(struct tree_twigs *twigs);

// Makes `params`, of `size` bytes, the default.
tree_status tree_instancing_params_init(struct tree_instancing_params *params, size_t size);

// Views the bytes: where they begin and how many there are.
tree_status tree_bytes_view(const struct tree_bytes *bytes, const uint8_t **data, size_t *len);

// Frees a file in memory.
tree_status tree_bytes_free(struct tree_bytes *bytes);

// Reads a cloud from a file whose extension is `ply`, `xyz`, `txt`, `csv`, `asc` or `pts`, in letters of any case; the
// path is as in `tree_mesh_read`. `TREE_ERROR_FORMAT` for others, and for broken files, with the line or row;
// `TREE_ERROR_LIMIT` for more points than `tree_limits.graph_nodes`. `control` may be NULL. Free the cloud with
// `tree_cloud_free`.
tree_status tree_cloud_read(const char *path,
                            size_t path_len,
                            const struct tree_control *control,
                            struct tree_cloud **cloud);

// As `tree_cloud_read`, from a file in memory, whose `format` must be stated. The bytes are needed during the call only.
tree_status tree_cloud_from_bytes(tree_cloud_format format,
                                  const uint8_t *data,
                                  size_t len,
                                  const struct tree_control *control,
                                  struct tree_cloud **cloud);

// Views a cloud. Set `columns->struct_size` first.
tree_status tree_cloud_view(const struct tree_cloud *cloud, struct tree_cloud_columns *columns);

// Frees a cloud of points.
tree_status tree_cloud_free(struct tree_cloud *cloud);

// Makes `options`, of `size` bytes, the default.
tree_status tree_glb_options_init(struct tree_glb_options *options, size_t size);

// Writes a mesh to a GLB file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends with
// a NUL and `path_len` is `TREE_NUL_TERMINATED`. `options` and `control` may be NULL; of `control`
// only threads and limits matter, and a cancellation before the work begins.
tree_status tree_mesh_write_glb(const struct tree_mesh *mesh,
                                const char *path,
                                size_t path_len,
                                const struct tree_glb_options *options,
                                const struct tree_control *control);

// A mesh as a GLB file in memory, as `tree_mesh_write_glb` writes it. Free it with `tree_bytes_free`.
tree_status tree_mesh_to_glb(const struct tree_mesh *mesh,
                             const struct tree_glb_options *options,
                             const struct tree_control *control,
                             struct tree_bytes **bytes);

// Writes meshes, instances and levels of detail to a GLB file, whole or not at all.
//
// Several levels, the finest first, become the nodes of one `MSFT_lod` with their coverages; programs
// that do not know it draw the finest. Materials that are equal in several levels are written once.
// `options` and `control` may be NULL, as in `tree_mesh_write_glb`; of the limits, `leaves` caps the
// copies and `triangles` those of the meshes that are drawn many times, all rows together.
tree_status tree_gltf_write_glb(const struct tree_gltf_level *levels,
                                size_t n_levels,
                                const char *path,
                                size_t path_len,
                                const struct tree_glb_options *options,
                                const struct tree_control *control);

// As `tree_gltf_write_glb`, in memory. Free the bytes with `tree_bytes_free`.
tree_status tree_gltf_to_glb(const struct tree_gltf_level *levels,
                             size_t n_levels,
                             const struct tree_glb_options *options,
                             const struct tree_control *control,
                             struct tree_bytes **bytes);

// As `tree_gltf_write_glb`, but in several files: the `.gltf` file of this path, and beside it the
// buffer (`STEM.bin`) and the textures (`STEM_NAME.png`), all or none. Blanks and other trouble in the
// stem are replaced by `_` in the names of the files beside.
tree_status tree_gltf_write_files(const struct tree_gltf_level *levels,
                                  size_t n_levels,
                                  const char *path,
                                  size_t path_len,
                                  const struct tree_glb_options *options,
                                  const struct tree_control *control);

// Builds a tree with one mesh for each kind of leaf instead of a copy for each leaf. Normals of
// instanced leaves are those of the leaf itself: the parameters cannot turn them towards the outside of
// the crown. `look`, `params` and `control` are as in `tree_mesh_build`. Free the bark with
// `tree_mesh_free` and the leaves with `tree_gltf_leaves_free`.
tree_status tree_mesh_build_instanced(const struct tree_tree *tree,
                                      const struct tree_look *look,
                                      const struct tree_mesh_params *params,
                                      const struct tree_control *control,
                                      struct tree_mesh **bark,
                                      struct tree_gltf_leaves **leaves);

// Views the leaves, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
// kinds there are. Their meshes belong to the leaves and are freed with them; `tree_mesh_free` of
// one is `TREE_ERROR_ORDER`.
tree_status tree_gltf_leaves_view(const struct tree_gltf_leaves *leaves,
                                  const struct tree_gltf_instances **rows,
                                  size_t *n);

// Frees leaves, and their meshes.
tree_status tree_gltf_leaves_free(struct tree_gltf_leaves *leaves);

// Makes `motion`, of `size` bytes, one without joints and frames.
tree_status tree_glb_motion_init(struct tree_glb_motion *motion, size_t size);

// Writes a mesh that moves to a GLB file, whole or not at all: a skin and one animation, linear between frames; joints that stay
// have no channels. Path, `options` and `control` as in `tree_mesh_write_glb`; positions are not quantised. `TREE_ERROR_INVALID` where
// motion and mesh do not fit together.
tree_status tree_mesh_write_glb_moving(const struct tree_mesh *mesh,
                                       const struct tree_glb_motion *motion,
                                       const char *path,
                                       size_t path_len,
                                       const struct tree_glb_options *options,
                                       const struct tree_control *control);

// A mesh that moves as a GLB file in memory, as `tree_mesh_write_glb_moving` writes it. Free it with `tree_bytes_free`.
tree_status tree_mesh_to_glb_moving(const struct tree_mesh *mesh,
                                    const struct tree_glb_motion *motion,
                                    const struct tree_glb_options *options,
                                    const struct tree_control *control,
                                    struct tree_bytes **bytes);

// The attributes `_WIND*` of all surfaces of a mesh, for a level of a glTF file: the streams of
// `TREE_LAYOUT_GLTF_WIND` that are not glTF's own, four floats each, the missing ones 0, which every
// reader takes. For Blender write occlusion as colour or not at all. `control` may be NULL. Free them
// with `tree_gltf_attributes_free`.
tree_status tree_mesh_gltf_wind(const struct tree_mesh *mesh,
                                const struct tree_control *control,
                                struct tree_gltf_attributes **attributes);

// Views the attributes, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
// there are.
tree_status tree_gltf_attributes_view(const struct tree_gltf_attributes *attributes,
                                      const struct tree_gltf_attribute **rows,
                                      size_t *n);

// Frees attributes.
tree_status tree_gltf_attributes_free(struct tree_gltf_attributes *attributes);

// What a note says, for people; the text is there for ever.
tree_status tree_note_text(tree_note note, struct tree_str *text);

// Writes a mesh to an OBJ file (the path is as in `tree_mesh_write_glb`) and beside it the MTL file (`STEM.mtl`) and the textures
// (`STEM_NAME.png`), all or none. Blanks and other trouble in the stem are replaced by `_` in the names
// of the files beside. Tangents and the other optional columns have no place in OBJ. `control` may be
// NULL; only a cancellation before the work begins matters.
tree_status tree_mesh_write_obj(const struct tree_mesh *mesh,
                                const char *path,
                                size_t path_len,
                                const struct tree_control *control);

// The OBJ and MTL files that `tree_mesh_write_obj` would write to `stem.obj` and `stem.mtl`, in memory.
// Free both with `tree_bytes_free`.
tree_status tree_mesh_to_obj(const struct tree_mesh *mesh,
                             const char *stem,
                             size_t stem_len,
                             const struct tree_control *control,
                             struct tree_bytes **obj,
                             struct tree_bytes **mtl);

// Makes `options`, of `size` bytes, the default.
tree_status tree_ply_options_init(struct tree_ply_options *options, size_t size);

// Writes a mesh to a PLY file (the path is as in `tree_mesh_write_glb`), whole or not at all: all surfaces as one, each vertex with the colour of
// its material times the mean of its texture. `options` and `control` may be NULL; of `control` only a
// cancellation before the work begins matters.
tree_status tree_mesh_write_ply(const struct tree_mesh *mesh,
                                const char *path,
                                size_t path_len,
                                const struct tree_ply_options *options,
                                const struct tree_control *control);

// As `tree_mesh_write_ply`, in memory. Free the bytes with `tree_bytes_free`.
tree_status tree_mesh_to_ply(const struct tree_mesh *mesh,
                             const struct tree_ply_options *options,
                             const struct tree_control *control,
                             struct tree_bytes **bytes);

// Makes `options`, of `size` bytes, the default.
tree_status tree_import_options_init(struct tree_import_options *options, size_t size);

// Reads a mesh from a file; the path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
// `TREE_NUL_TERMINATED`. It is checked before memory is taken for it, and never trusted; what was
// left out or changed is in the report. `options`, `control` and `report` may be NULL. Free the mesh
// with `tree_mesh_free`.
tree_status tree_mesh_read(const char *path,
                           size_t path_len,
                           const struct tree_import_options *options,
                           const struct tree_control *control,
                           struct tree_import_report *report,
                           struct tree_mesh **mesh);

// Reads a mesh from a file in memory; other files are never read. `format` must be stated. `mtl` is
// for OBJ only: the MTL file, or NULL for materials with names only; textures are not read. The bytes
// are needed during the call only. `control` and `report` may be NULL. Free the mesh with
// `tree_mesh_free`.
tree_status tree_mesh_from_bytes(tree_mesh_format format,
                                 const uint8_t *data,
                                 size_t len,
                                 const uint8_t *mtl,
                                 size_t mtl_len,
                                 const struct tree_control *control,
                                 struct tree_import_report *report,
                                 struct tree_mesh **mesh);

// `(1 - d)^2` (Cook et al. 2007).
tree_status tree_lod_distance_cook(struct tree_lod_distance *distance);

// The least lambda of a measured model that is as good as asked for: a quality of `near` at distance 0, falling
// linearly to `far` at distance 1; each 0 to 1, both the same for one that is asked for everywhere.
tree_status tree_lod_distance_for_quality(const struct tree_lod_table *table,
                                          float near,
                                          float far,
                                          struct tree_lod_distance *distance);

// The least lambda at which the model of `table` is as good as the one of `cook` is at `(1 - d)^2`: the same
// pictures with less geometry. `cook` is measured with `tree_order_stochastic` and `TREE_LOD_SCALE_COOK`.
tree_status tree_lod_distance_parity(const struct tree_lod_table *table,
                                     const struct tree_lod_table *cook,
                                     struct tree_lod_distance *distance);

// One of your own samples, at the distances of `tree_lod_distance_places`: `TREE_LOD_DISTANCE_SAMPLES` numbers,
// each 0 to 1. A sample above the one before is lowered to it, for geometry must not grow with distance.
tree_status tree_lod_distance_from_samples(const float *lambdas,
                                           size_t n_lambdas,
                                           struct tree_lod_distance *distance);

// Writes the distances that are sampled, `TREE_LOD_DISTANCE_SAMPLES` of them.
tree_status tree_lod_distance_places(float *places, size_t capacity);

// Lambda at a distance `d`, which is brought into 0 to 1; NaN is far. `TREE_ERROR_PARAMETER` when a sample is not
// within 0 to 1.
tree_status tree_lod_distance_lambda(const struct tree_lod_distance *distance,
                                     float d,
                                     float *lambda);

// Divides the foliage of a mesh into elements. `surfaces` names the `n_surfaces` surfaces that may be pruned,
// each once. Without any (NULL, 0) they are found: those with anchors of leaves, and where there are none, as
// in imported meshes, those whose material is alpha-tested, has two sides or is named after leaves. `grain`
// is a `TREE_GRAIN_` constant; blades are a good choice. `control` may be NULL; `triangles` of its limits caps
// the triangles. Free the elements with `tree_elements_free`.
//
// `TREE_ERROR_INVALID` when there is no foliage, or a surface that was named does not exist or is named
// twice.
tree_status tree_elements_of_mesh(const struct tree_mesh *mesh,
                                  const uint32_t *surfaces,
                                  size_t n_surfaces,
                                  tree_grain grain,
                                  const struct tree_control *control,
                                  struct tree_elements **elements);

// Elements of your own, which are copied: each a row of the columns, as `tree_elements_view` gives them. `mesh` is what
// they are elements of. `control` may be NULL; `triangles` of its limits caps elements and triangles. Free the
// elements with `tree_elements_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
// `n_triangles`, when the mesh lacks a surface or a triangle, or a centre is not finite.
tree_status tree_elements_from_columns(const struct tree_mesh *mesh,
                                       const struct tree_elements_columns *columns,
                                       const struct tree_control *control,
                                       struct tree_elements **elements);

// Views elements. Set `columns->struct_size` first.
tree_status tree_elements_view(const struct tree_elements *elements,
                               struct tree_elements_columns *columns);

// Height in metres of the plant the elements belong to: from the ground at y = 0, where trees are based, to the
// highest centre. Of a model that is not based there (something lies below, or all is higher than two crown
// heights) the height of the crown. `TREE_ERROR_INVALID` when all elements are one point.
tree_status tree_elements_plant_height(const struct tree_elements *elements,
                                       float *metres);

// Frees elements, and with them all views of them.
tree_status tree_elements_free(struct tree_elements *elements);

// Makes `params`, of `size` bytes, the default.
tree_status tree_hull_params_init(struct tree_hull_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_hull_params_check(const struct tree_hull_params *params);

// The surface of a field of metaballs. `params` and `control` may be NULL; `voxels` and `triangles` of its limits
// cap the grid and the surface. Free the hull with `tree_hull_free`. `TREE_ERROR_INVALID` when the points stand so
// far from the origin that the numbers do not resolve the grid.
tree_status tree_hull_of_metaballs(const struct tree_metaballs *metaballs,
                                   const struct tree_hull_params *params,
                                   const struct tree_control *control,
                                   struct tree_hull **hull);

// The hull of a plant, as `tree_order_combined` makes it: `tree_metaballs_of_elements` and `tree_hull_of_metaballs`
// in one, with `height`, `radius` and `hull` of `params`. `params` and `control` may be NULL. Free the hull with
// `tree_hull_free`.
tree_status tree_hull_of_elements(const struct tree_elements *elements,
                                  const struct tree_order_params *params,
                                  const struct tree_control *control,
                                  struct tree_hull **hull);

// Views a hull. Set `columns->struct_size` first.
tree_status tree_hull_view(const struct tree_hull *hull, struct tree_hull_columns *columns);

// A mesh of one surface, for looking at the hull. Free it with `tree_mesh_free`.
tree_status tree_hull_mesh(const struct tree_hull *hull, struct tree_mesh **mesh);

// Chooses `n_samples` places evenly by area: for the visibility of a model in a `tree_scene`, for example.
// `positions` and `normals` (unit, outwards) have room for `capacity` and `normals_capacity` floats, at least
// `3 * n_samples` each. `control` may be NULL; `nodes` of its limits caps the samples.
tree_status tree_hull_sample(const struct tree_hull *hull,
                             size_t n_samples,
                             uint64_t seed,
                             const struct tree_control *control,
                             float *positions,
                             size_t capacity,
                             float *normals,
                             size_t normals_capacity);

// The place of the surface that is nearest to each of `n_points` points, three floats each in metres, or another
// that is at most a hundredth farther from it, and the unit normal there. For a point that is not finite, or too
// far off (1e18 m) to tell, both are zero. `positions` and `normals` have room for `capacity` and
// `normals_capacity` floats, at least `3 * n_points` each. `control` may be NULL; `nodes` of its limits caps the
// points.
tree_status tree_hull_nearest(const struct tree_hull *hull,
                              const float *points,
                              size_t n_points,
                              const struct tree_control *control,
                              float *positions,
                              size_t capacity,
                              float *normals,
                              size_t normals_capacity);

// Frees a hull, and with it all views of it.
tree_status tree_hull_free(struct tree_hull *hull);

// The pixels that a mesh covers. Of `view`, which may be NULL for the default, camera and width count; it must
// be as high as it is wide, 8 to 4096 pixels. `control` may be NULL. Free the mask with `tree_bits_free`.
tree_status tree_bits_of_mesh(const struct tree_mesh *mesh,
                              const struct tree_view *view,
                              const struct tree_control *control,
                              struct tree_bits **bits);

// Tells how large a mask is, and how many of its bits are set. Set `found->struct_size` first.
tree_status tree_bits_measure(const struct tree_bits *bits, struct tree_bits_size *found);

// Writes the words of all rows, from top to bottom, each begun in a word of its own: the pixel at x is bit
// `x % 64` of word `x / 64` of its row. `capacity` is at least `n_words` of `tree_bits_measure`.
tree_status tree_bits_words(const struct tree_bits *bits,
                            uint64_t *words,
                            size_t capacity);

// Writes a byte for each pixel, rows from top to bottom, 255 where it is set. `capacity` is at least
// `n_pixels` of `tree_bits_measure`.
tree_status tree_bits_bytes(const struct tree_bits *bits,
                            uint8_t *bytes,
                            size_t capacity);

// Counts the pixels of `bits`, of a simplified model, against those of the `full` one. Masks of different sizes
// are compared where they overlap from the top left, by whole words.
tree_status tree_bits_score(const struct tree_bits *bits,
                            const struct tree_bits *full,
                            struct tree_score *score);

// Frees a mask.
tree_status tree_bits_free(struct tree_bits *bits);

// The field of `n_points` points, three floats each in metres, with `radius` metres of influence, 1e-9 to
// 1e9. `control` may be NULL; `nodes` of its limits caps the points. Free it with `tree_metaballs_free`.
// `TREE_ERROR_INVALID` when there are no points, `TREE_ERROR_PARAMETER` when a number is out of range.
tree_status tree_metaballs_new(const float *points,
                               size_t n_points,
                               float radius,
                               const struct tree_control *control,
                               struct tree_metaballs **metaballs);

// The field of the centres of all elements that have area. `radius` is a share of `height`, the height of the
// plant in metres; 0 for the height that `tree_elements_plant_height` measures. `control` may be NULL. Free it
// with `tree_metaballs_free`. `TREE_ERROR_INVALID` when no element has area.
tree_status tree_metaballs_of_elements(const struct tree_elements *elements,
                                       float radius,
                                       float height,
                                       const struct tree_control *control,
                                       struct tree_metaballs **metaballs);

// Radius of influence in metres.
tree_status tree_metaballs_radius(const struct tree_metaballs *metaballs, float *radius);

// Number of points.
tree_status tree_metaballs_count(const struct tree_metaballs *metaballs, size_t *n_points);

// The box around the points: its lower corner, then its upper one, in metres.
tree_status tree_metaballs_bounds(const struct tree_metaballs *metaballs, float (*min_max)[6]);

// The field at `n_points` points, three floats each in metres; 0 for a point that is not finite. `values` has
// room for `capacity` numbers, at least `n_points`. `control` may be NULL; `nodes` of its limits caps the
// points.
tree_status tree_metaballs_values(const struct tree_metaballs *metaballs,
                                  const float *points,
                                  size_t n_points,
                                  const struct tree_control *control,
                                  float *values,
                                  size_t capacity);

// Where the field grows fastest, and how fast per metre, three floats for each of the `n_points` points; zero
// outside. `gradients` has room for `capacity` floats, at least `3 * n_points`. Else as `tree_metaballs_values`.
tree_status tree_metaballs_gradients(const struct tree_metaballs *metaballs,
                                     const float *points,
                                     size_t n_points,
                                     const struct tree_control *control,
                                     float *gradients,
                                     size_t capacity);

// Frees a field. Hulls that were made of it stay.
tree_status tree_metaballs_free(struct tree_metaballs *metaballs);

// Makes an order that has nothing to do with place, size, direction or colour: a shuffle (Cook et al. 2007).
// `order` has room for `capacity` numbers, at least one for each element; as of all orders, row k is the k-th
// most important element, and the first rows are drawn.
tree_status tree_order_stochastic(const struct tree_elements *elements,
                                  uint64_t seed,
                                  uint32_t *order,
                                  size_t capacity);

// Makes an order of which every beginning is evenly spread over the ground, by the golden section (Neubert 2012,
// 6.3.2, "drop and resize"). There is no chance in it. `order` as for `tree_order_stochastic`.
tree_status tree_order_golden(const struct tree_elements *elements,
                              uint32_t *order,
                              size_t capacity);

// Makes an order in which elements of dense places go first, until all places are about as dense; the rest is
// stochastic (Neubert 2012, 7.3.2). `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
// `TREE_ERROR_INVALID` when no element has area.
tree_status tree_order_density(const struct tree_elements *elements,
                               const struct tree_order_params *params,
                               uint64_t seed,
                               const struct tree_control *control,
                               uint32_t *order,
                               size_t capacity);

// Makes an order in which elements that do not lie along the hull go first (Neubert 2012, 7.3.3), with
// `params->randomness`. `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
tree_status tree_order_orientation(const struct tree_elements *elements,
                                   const struct tree_hull *hull,
                                   const struct tree_order_params *params,
                                   uint64_t seed,
                                   const struct tree_control *control,
                                   uint32_t *order,
                                   size_t capacity);

// Makes the order by density and orientation together (Neubert 2012, eq. 7.8). It makes field and hull itself.
// `params` and `control` may be NULL; `order` as for `tree_order_stochastic`. `TREE_ERROR_INVALID` when no element
// has area.
tree_status tree_order_combined(const struct tree_elements *elements,
                                const struct tree_order_params *params,
                                uint64_t seed,
                                const struct tree_control *control,
                                uint32_t *order,
                                size_t capacity);

// Makes the order that keeps the pixels covered: elements are drawn from many sides, and those come first that
// together make the best quality. Where leaves have grown, each chooses the point that it grows about. The best
// order of all, and the one that takes longest: some ten drawings of the foliage in every view.
//
// Elements are drawn as in tier `tier` of `tiers`: 0 is the full model, and NULL, with 0, has no other. For leaves of
// many triangles take one of about four triangles each: a quarter of the time, and nearly the same order.
//
// `params` and `control` may be NULL. `order` as for `tree_order_stochastic`; `pivots`, three floats for each
// element (not rank) in metres, has room for `pivots_capacity` floats, at least three for each element.
// `TREE_ERROR_INVALID` when the elements or tiers are not of this mesh, `TREE_ERROR_PARAMETER` when there is no such
// tier.
tree_status tree_order_coverage(const struct tree_mesh *mesh,
                                const struct tree_elements *elements,
                                const struct tree_tiers *tiers,
                                size_t tier,
                                const struct tree_coverage_params *params,
                                const struct tree_control *control,
                                uint32_t *order,
                                size_t capacity,
                                float *pivots,
                                size_t pivots_capacity);

// Checks that an order of `n_order` rows has each of `n_elements` elements once; `TREE_ERROR_INVALID` names the
// first row at fault.
tree_status tree_order_check(const uint32_t *order,
                             size_t n_order,
                             size_t n_elements);

// Makes `params`, of `size` bytes, the default.
tree_status tree_order_params_init(struct tree_order_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_order_params_check(const struct tree_order_params *params);

// Makes `params`, of `size` bytes, the default.
tree_status tree_coverage_params_init(struct tree_coverage_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_coverage_params_check(const struct tree_coverage_params *params);

// Tells how large a model is, and the ends of its lambdas. Set `totals->struct_size` first.
tree_status tree_pruned_measure(const struct tree_pruned *pruned,
                                struct tree_pruned_totals *totals);

// The mesh to upload, nothing copied. Its foliage must be drawn by windows, for its index buffers hold leaves several
// times. Free it with `tree_mesh_free`; it keeps the model alive.
tree_status tree_pruned_mesh(const struct tree_pruned *pruned,
                             struct tree_mesh **mesh);

// Views part `number`, rising with the surfaces. Set `part->struct_size` first. `TREE_ERROR_PARAMETER` when there is
// no such part.
tree_status tree_pruned_part_view(const struct tree_pruned *pruned,
                                  size_t number,
                                  struct tree_pruned_part *part);

// The scale for each lambda, a table of its own. Free it with `tree_lod_table_free`.
tree_status tree_pruned_table(const struct tree_pruned *pruned, struct tree_lod_table **table);

// Writes the number of elements with which each tier begins. `kept` has room for `capacity` numbers, at least one for
// each tier.
tree_status tree_pruned_kept(const struct tree_pruned *pruned,
                             uint32_t *kept,
                             size_t capacity);

// The most elements that fit `lambda`, 0 to 1, of the full foliage's triangles: at least one, even if it has more.
tree_status tree_pruned_cut(const struct tree_pruned *pruned,
                            float lambda,
                            struct tree_lod_cut *cut);

// A state, counted from the full model, 0, down; from `n_steps` on it is the last.
tree_status tree_pruned_step(const struct tree_pruned *pruned,
                             uint64_t step,
                             struct tree_lod_cut *cut);

// The least lambda for which so many triangles may be drawn; 1 for more than there are.
tree_status tree_pruned_lambda_of(const struct tree_pruned *pruned,
                                  uint64_t n_triangles,
                                  float *lambda);

// Lambda from which on an element is drawn: 0 for those that always are, 1 for ranks that do not exist.
tree_status tree_pruned_lambda_of_rank(const struct tree_pruned *pruned,
                                       uint32_t rank,
                                       float *lambda);

// Frees a model, and with it all views of its parts. Meshes made of it stay.
tree_status tree_pruned_free(struct tree_pruned *pruned);

// Makes `screen`, of `size` bytes, the default.
tree_status tree_lod_screen_init(struct tree_lod_screen *screen, size_t size);

// Checks every field of `screen`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_lod_screen_check(const struct tree_lod_screen *screen);

// Share of the screen's height, 0 to 1, that something of `size` metres has where lambda has fallen to `lambda`.
tree_status tree_lod_screen_coverage(const struct tree_lod_screen *screen,
                                     float lambda,
                                     float size,
                                     float *coverage);

// A model as a GLB file in memory, for engines that draw windows: foliage with all tiers in its index buffers, and an
// attribute `_TREE_CENTER` of 4 floats a vertex, as in `tree_pruned_part`. The levels go beside it, as
// `tree_pruned_to_json`. Programs that draw all of it draw leaves several times. `options` and `control` may be NULL,
// as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for `quantize`: shaders
// need positions in metres.
tree_status tree_pruned_to_glb(const struct tree_pruned *pruned,
                               const struct tree_glb_options *options,
                               const struct tree_control *control,
                               struct tree_bytes **bytes);

// As `tree_pruned_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_pruned_write_glb(const struct tree_pruned *pruned,
                                  const char *path,
                                  size_t path_len,
                                  const struct tree_glb_options *options,
                                  const struct tree_control *control);

// Levels for `n_lambdas` falling lambdas, each 0 to 1 and at most 1024 of them, as the `MSFT_lod` of one GLB file,
// each a mesh of its own: for programs without shaders of ours. A level is shown until the lambda of the distance
// has fallen to that of the next one; the last is shown to the end. `screen`, `options` and `control` may be NULL.
// Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no lambdas or they do not fall.
tree_status tree_pruned_to_glb_levels(const struct tree_pruned *pruned,
                                      const float *lambdas,
                                      size_t n_lambdas,
                                      const struct tree_lod_screen *screen,
                                      const struct tree_glb_options *options,
                                      const struct tree_control *control,
                                      struct tree_bytes **bytes);

// As `tree_pruned_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_pruned_write_glb_levels(const struct tree_pruned *pruned,
                                         const float *lambdas,
                                         size_t n_lambdas,
                                         const struct tree_lod_screen *screen,
                                         const char *path,
                                         size_t path_len,
                                         const struct tree_glb_options *options,
                                         const struct tree_control *control);

// What is drawn for `lambda`, 0 to 1: at most so much of the full foliage, but at least one element. `windows` has
// room for `capacity` of them, at least `n_parts` of `tree_pruned_measure`: one for each part, in their order. It is
// quick enough for every frame.
tree_status tree_pruned_level(const struct tree_pruned *pruned,
                              float lambda,
                              struct tree_lod_level *level,
                              struct tree_lod_window *windows,
                              size_t capacity);

// `n` levels, 2 to 1024, with rising lambda: from the first of the table to the full model, in equal ratios. `levels`
// has room for `levels_capacity` of them, at least `n`; `windows` for `windows_capacity`, at least `n` times the
// parts: those of the first level, then those of the next. `n_levels` says how many there are: fewer than `n` where
// the table begins at 1.
tree_status tree_pruned_levels(const struct tree_pruned *pruned,
                               size_t n,
                               struct tree_lod_level *levels,
                               size_t levels_capacity,
                               struct tree_lod_window *windows,
                               size_t windows_capacity,
                               size_t *n_levels);

// The level for `lambda`, 0 to 1, as a plain mesh, wood included: elements scaled as the shader does, what is not
// drawn left out. Nothing fades in it. Free it with `tree_mesh_free`. `control` may be NULL; of it only threads
// matter, and a cancellation before the work begins.
tree_status tree_pruned_mesh_at(const struct tree_pruned *pruned,
                                float lambda,
                                const struct tree_control *control,
                                struct tree_mesh **mesh);

// As `tree_pruned_mesh_at`, for a level with its `n_windows` windows, which may fade. `TREE_ERROR_INVALID` when
// they are of another model.
tree_status tree_pruned_mesh_of(const struct tree_pruned *pruned,
                                const struct tree_lod_level *level,
                                const struct tree_lod_window *windows,
                                size_t n_windows,
                                const struct tree_control *control,
                                struct tree_mesh **mesh);

// Levels as JSON, to be stored beside the mesh: counts, the surface and colour of each part, the table, and for
// each level its numbers and windows. `levels` and `windows` as `tree_pruned_levels` writes them. Free the bytes,
// which are UTF-8, with `tree_bytes_free`. `TREE_ERROR_PARAMETER` when there are not as many windows as levels
// times parts.
tree_status tree_pruned_to_json(const struct tree_pruned *pruned,
                                const struct tree_lod_level *levels,
                                size_t n_levels,
                                const struct tree_lod_window *windows,
                                size_t n_windows,
                                struct tree_bytes **bytes);

// Makes `params`, of `size` bytes, the default.
tree_status tree_prune_params_init(struct tree_prune_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_prune_params_check(const struct tree_prune_params *params);

// Makes `params`, of `size` bytes, the default.
tree_status tree_prune_make_params_init(struct tree_prune_make_params *params, size_t size);

// Makes a pruned model of a mesh, all steps in one call: elements, tiers, order by coverage, plan, table and model.
// Some seconds for half a million triangles. `params` and `control` may be NULL; `triangles` of its limits caps those
// of all tiers together. Free the model with `tree_pruned_free`. `TREE_ERROR_INVALID` when there is no foliage.
tree_status tree_pruned_make(const struct tree_mesh *mesh,
                             const struct tree_prune_make_params *params,
                             const struct tree_control *control,
                             struct tree_pruned **pruned);

// Makes a pruned model of what its steps have made: the subject with its order, pivots, tiers and plan, and `table`
// with the scale for each lambda. Surfaces of foliage keep their vertices and columns, their index buffers hold the
// triangles of all tiers; vertices that several elements share are doubled, and such a surface loses its anchors.
// `params` and `control` may be NULL. Free the model with `tree_pruned_free`.
//
// `TREE_ERROR_INVALID` when the parts of the subject do not belong together, or pivots are not finite;
// `TREE_ERROR_PARAMETER` for foliage further than 1000 km from the origin, or a `kept` that rises.
tree_status tree_pruned_new(const struct tree_lod_subject *subject,
                            const struct tree_lod_table *table,
                            const struct tree_prune_params *params,
                            const struct tree_control *control,
                            struct tree_pruned **pruned);

// The model for a scene, with `n` levels, 2 to 1024, as `tree_pruned_levels` makes them: a draw for every surface,
// wood included, all surfaces one after another in one vertex buffer and one index buffer. `distance` says how lambda
// falls, NULL for that of `tree_lod_distance_cook`. Free the levels with `tree_scene_levels_free`.
//
// `TREE_ERROR_INVALID` when the model has more than 64 surfaces, or one buffer cannot hold them.
tree_status tree_pruned_scene_levels(const struct tree_pruned *pruned,
                                     size_t n,
                                     const struct tree_lod_distance *distance,
                                     struct tree_scene_levels **levels);

// Makes `model` one of these levels, with sphere and distance; points for occlusion, occluders, `near` and `far` are
// left at their defaults, for you to set. Set `model->struct_size` first. It borrows from the levels: make the scene
// before they are freed.
tree_status tree_scene_levels_model(const struct tree_scene_levels *levels,
                                    struct tree_scene_model *model);

// Frees levels; no model may point at them any more.
tree_status tree_scene_levels_free(struct tree_scene_levels *levels);

// The functions `tree_prune_position` and `tree_prune_color` for a shader: text to be put into your own. It tells
// what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
tree_status tree_prune_shader(tree_shader language,
                              struct tree_str *text);

// Where a shader draws a vertex: `vertex`, three floats, moved from the centre of its element by `growth` (a factor on
// length), and towards it where the element fades. `center_rank` is four floats of `tree_pruned_part.centers`, the
// rest is of a level. For shaders of your own, and for checking them.
tree_status tree_prune_position(const float *vertex,
                                const float *center_rank,
                                float growth,
                                float lambda,
                                float fade,
                                float (*drawn)[3]);

// The linear colour that a shader gives a leaf, before light: `rgb`, three floats, with its contrast lowered, so that
// few large leaves look no more mottled than many small ones. `mean` is that of the part.
tree_status tree_prune_color(const float *rgb,
                             const float *mean,
                             float contrast,
                             float (*drawn)[3]);

// Scale after Cook et al. (2007): `1 / lambda`, a factor on area, so that the summed area stays. `lambda` is a
// share of geometry, more than 0; of 0 and less the scale is that of the smallest number.
tree_status tree_lod_cook_scale(float lambda,
                                float *scale);

// Share of geometry after Cook et al. (2007), `(1 - d)^2`, for a distance `d`, which is brought into 0 to 1.
tree_status tree_lod_cook_lambda(float d,
                                 float *lambda);

// Share of geometry by size on the screen (Cook et al. 2007; Neubert 2012, 6.3.2): 1 where the bounding box is
// `full` pixels large or more, a half at `h * full`, and so on. `pixels` is its size now, 0 to 1e9; `full` 0.001 to
// 1e9, `h` 0.001 to 0.999: `TREE_ERROR_PARAMETER` outside.
tree_status tree_lod_size_lambda(float pixels,
                                 float full,
                                 float h,
                                 float *lambda);

// Factor on *length* of `k` elements left of `n` (Deussen and Lintermann 2004; Neubert 2012, eq. 6.4 with the sign
// set right): `w * sqrt(n / k) + (1 - w)`, `w` from 0 (nothing grows) to 1 (area is kept). `TREE_ERROR_PARAMETER`
// for another `w`, or a `k` outside 1 to `n`.
tree_status tree_lod_drop_and_resize(uint32_t n,
                                     uint32_t k,
                                     float w,
                                     float *growth);

// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007) when a share of
// `lambda` of the elements is drawn, each `scale` times as large in area: `1 / (scale * sqrt(lambda))`, at most 1.
tree_status tree_lod_contrast(float lambda,
                              float scale,
                              float *contrast);

// What a score is worth (Neubert 2012, eq. 7.3 to 7.7). `precision` is the share of the simplified model's pixels
// that are right, `recall` the share of the full model's pixels that are there, both 0 to 1, and 1 when there
// are none. `quality` is `1 - sqrt((1 - precision)^2 + (1 - recall)^2)`: 1 is perfect, 0 and less is useless.
tree_status tree_score_quality(const struct tree_score *score,
                               double *precision,
                               double *recall,
                               double *quality);

// Mean of the qualities of several views: what a table says of a model. 0 of none.
tree_status tree_score_mean_quality(const struct tree_score *scores,
                                    size_t n_scores,
                                    double *quality);

// Scores of a simplified mesh against the full one, one for each view; both are framed as the full one is.
// `around`, NULL for the default, says from where to look; `scores` has room for `capacity` scores, at least
// `tree_around_count`. `control` may be NULL; `pixels` of its limits caps those of all views.
tree_status tree_mesh_score(const struct tree_mesh *simplified,
                            const struct tree_mesh *full,
                            const struct tree_around *around,
                            const struct tree_control *control,
                            struct tree_score *scores,
                            size_t capacity);

// Makes a scene of `n_models` models and `n_instances` instances, which are copied and numbered as they come.
// `control` may be NULL; `nodes` of its limits caps the instances. Free the scene with `tree_scene_free`. The text
// of an error names the first model or instance that is not right: `TREE_ERROR_INVALID`.
tree_status tree_scene_new(const struct tree_scene_model *models,
                           size_t n_models,
                           const struct tree_scene_instance *instances,
                           size_t n_instances,
                           const struct tree_control *control,
                           struct tree_scene **scene);

// Moves instances, or gives them other models: those from number `first` on become the `n_instances` given, all of
// them, or on an error none. Between frames: what was selected before holds the old ones. They keep their
// place in the order of drawing; when most move far, a new scene is faster to look through.
tree_status tree_scene_set_instances(struct tree_scene *scene,
                                     size_t first,
                                     const struct tree_scene_instance *instances,
                                     size_t n_instances);

// Tells how large a scene is, and how large the buffers for it must be. Set `needs->struct_size` first.
tree_status tree_scene_measure(const struct tree_scene *scene,
                               struct tree_scene_needs *needs);

// Frees a scene.
tree_status tree_scene_free(struct tree_scene *scene);

// Makes a state for one view of `scene`, or of another scene with as many instances and the same models: 32 bytes for
// each instance, and 144 KiB. `control` may be NULL; `nodes` of its limits caps the instances. It does not keep the
// scene alive. Free it with `tree_scene_state_free`.
tree_status tree_scene_state_new(const struct tree_scene *scene,
                                 const struct tree_control *control,
                                 struct tree_scene_state **state);

// Number of the instances that were in view in the last frame: rows of `tree_instance_lod` that it needs.
tree_status tree_scene_state_count_drawn(const struct tree_scene_state *state,
                                         size_t *n_drawn);

// How an instance of `scene` was drawn in the last frame; not in view when there is no such instance.
tree_status tree_scene_state_shown(const struct tree_scene_state *state,
                                   const struct tree_scene *scene,
                                   size_t instance,
                                   struct tree_scene_shown *shown);

// Frees a state.
tree_status tree_scene_state_free(struct tree_scene_state *state);

// Makes `params`, of `size` bytes, the default.
tree_status tree_scene_params_init(struct tree_scene_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_scene_params_check(const struct tree_scene_params *params);

// Makes `frame`, of `size` bytes, the default: its matrices must be set.
tree_status tree_scene_frame_init(struct tree_scene_frame *frame, size_t size);

// Checks a camera, two matrices as in `tree_scene_frame`, and tells whether near things have the greater depth, 1 or
// 0. `TREE_ERROR_PARAMETER` names the matrix that is none of a camera.
tree_status tree_scene_eye_check(const float *view,
                                 const float *projection,
                                 uint32_t *is_reversed);

// Finds what of `scene` is in view, and how finely it is drawn. `state` keeps it for `tree_scene_state_draws` and
// `tree_scene_state_batches`. `params` may be NULL for the defaults, `report` when it is not wanted. It takes about 100 ns
// for each instance in view, and no memory.
//
// `TREE_ERROR_PARAMETER` for matrices that are no camera and numbers out of range, `TREE_ERROR_INVALID` for a depth
// buffer of the wrong size and for a state of another scene. The state is left as it was then.
tree_status tree_scene_state_select(struct tree_scene_state *state,
                                    const struct tree_scene *scene,
                                    const struct tree_scene_frame *frame,
                                    const struct tree_scene_params *params,
                                    struct tree_scene_report *report);

// Makes `model`, of `size` bytes, the default: a sphere of 1 m without levels, which are to be set.
tree_status tree_scene_model_init(struct tree_scene_model *model, size_t size);

// Checks every number of `model`; the text of an error tells what is at fault and what would be right.
tree_status tree_scene_model_check(const struct tree_scene_model *model);

// Writes a draw for each part of each instance in view, and a row for each instance: for multi-draw indirect. Draws
// of an instance follow one another; parts without indices are left out. `draws` and `rows` have room for
// `draws_capacity` and `rows_capacity` of them; `tree_scene_measure` says how many always suffice. `n_draws` and
// `n_rows` say how many were written. It takes no memory.
//
// `TREE_ERROR_BUFFER` when a buffer is too small; its text says how many are needed, and nothing is written then.
// Buffers may be mapped memory of a graphics processor: they are written once, in order, and not read.
tree_status tree_scene_state_draws(const struct tree_scene_state *state,
                                   const struct tree_scene *scene,
                                   struct tree_draw_indexed *draws,
                                   size_t draws_capacity,
                                   struct tree_instance_lod *rows,
                                   size_t rows_capacity,
                                   size_t *n_draws,
                                   size_t *n_rows);

// As `tree_scene_state_draws`, with one draw for each part of all instances of the same model at the same level: fewer
// draws, of many instances each. Rows are not written in order.
tree_status tree_scene_state_batches(struct tree_scene_state *state,
                                     const struct tree_scene *scene,
                                     struct tree_draw_indexed *draws,
                                     size_t draws_capacity,
                                     struct tree_instance_lod *rows,
                                     size_t rows_capacity,
                                     size_t *n_draws,
                                     size_t *n_rows);

// Makes `subject`, of `size` bytes, the default: its mesh, elements and order must be set.
tree_status tree_lod_subject_init(struct tree_lod_subject *subject, size_t size);

// Scores of a pruned model against the full one, which is drawn once, for each of `n_lambdas` shares one for each view:
// with `lambdas[i]` of the foliage's triangles, 0 to 1, and elements grown to `scales[i]` times their area, 0.01 to
// 10,000 (lengths grow by its square root); `n_scales` is `n_lambdas`. `around` says from where to look, NULL for the
// default; `scores` has room for `capacity` scores, at least `n_lambdas` times `tree_around_count`, those of
// `lambdas[0]` first. `control` may be NULL.
//
// `TREE_ERROR_INVALID` when the parts of the subject do not belong together,
// `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_lod_subject_scores(const struct tree_lod_subject *subject,
                                    const float *lambdas,
                                    size_t n_lambdas,
                                    const float *scales,
                                    size_t n_scales,
                                    const struct tree_around *around,
                                    const struct tree_control *control,
                                    struct tree_score *scores,
                                    size_t capacity);

// Finds when outlines should become simpler, and when elements should go: writes the number of elements with which
// each tier should begin, for `kept` of a subject. Tiers that are better left out begin with one. `kept` has room
// for `capacity` numbers, at least one for each tier of the subject (1 where it has none); what the subject has as
// `kept` is not looked at. It takes about as long as a table for each tier. `control` may be NULL.
//
// `TREE_ERROR_INVALID` when the parts of the subject do not belong together.
tree_status tree_lod_plan(const struct tree_lod_subject *subject,
                          const struct tree_control *control,
                          uint32_t *kept,
                          size_t capacity);

// Makes `params`, of `size` bytes, the default.
tree_status tree_lod_table_params_init(struct tree_lod_table_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range, and lambdas
// that do not rise to 1 are `TREE_ERROR_INVALID`.
tree_status tree_lod_table_params_check(const struct tree_lod_table_params *params);

// A table of `n_rows` rows, which are copied: of a model that was measured before. Free it with
// `tree_lod_table_free`. `TREE_ERROR_INVALID` when there are no rows, when lambda does not rise, leaves 0 to 1
// or does not end at 1, or when a number is not finite or a scale not positive; its text names the row.
tree_status tree_lod_table_from_rows(const struct tree_lod_row *rows,
                                     size_t n_rows,
                                     struct tree_lod_table **table);

// Measures a table: for every lambda the pruned model is drawn into masks from all sides, at several scales,
// and compared with the full one; the scale of best mean quality is kept. It takes about ten drawings of
// lambda times the triangles for each lambda and view. `params` and `control` may be NULL. Free the table
// with `tree_lod_table_free`.
//
// `TREE_ERROR_INVALID` when the parts of the subject do not belong together; see
// `tree_lod_table_params_check` for the rest.
tree_status tree_lod_table_measure(const struct tree_lod_subject *subject,
                                   const struct tree_lod_table_params *params,
                                   const struct tree_control *control,
                                   struct tree_lod_table **table);

// The rows of a table. They stay for as long as the table does.
tree_status tree_lod_table_rows(const struct tree_lod_table *table,
                                const struct tree_lod_row **rows,
                                size_t *n_rows);

// The row for a lambda, interpolated linearly; lambda is brought into the range of the table.
tree_status tree_lod_table_at(const struct tree_lod_table *table,
                              float lambda,
                              struct tree_lod_row *row);

// The least lambda from which on the quality is at least `quality`; 1 when only the full model is so good.
tree_status tree_lod_table_lambda_for(const struct tree_lod_table *table,
                                      float quality,
                                      float *lambda);

// Frees a table, and with it all views of it.
tree_status tree_lod_table_free(struct tree_lod_table *table);

// Makes `params`, of `size` bytes, the default.
tree_status tree_tiers_params_init(struct tree_tiers_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_tiers_params_check(const struct tree_tiers_params *params);

// Makes the tiers of a model: its elements, and the same with fewer and fewer triangles. No element has more
// triangles in a later tier than in an earlier one. It takes 5 to 10 ms for each distinct shape of 16 triangles.
// `params` and `control` may be NULL; `triangles` of its limits caps those of all tiers together. Free the tiers
// with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of this mesh.
tree_status tree_tiers_of_mesh(const struct tree_mesh *mesh,
                               const struct tree_elements *elements,
                               const struct tree_tiers_params *params,
                               const struct tree_control *control,
                               struct tree_tiers **tiers);

// The full model as the only tier. Free it with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of
// this mesh.
tree_status tree_tiers_full(const struct tree_mesh *mesh,
                            const struct tree_elements *elements,
                            struct tree_tiers **tiers);

// Tiers of your own, which are copied: the finest first, each as `tree_tiers_view` gives it. `mesh` and `elements` are
// what they are tiers of. `control` may be NULL; `triangles` of its limits caps the triangles of each. Free the tiers
// with `tree_tiers_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
// `n_triangles`, has no row for each element and one more, or a surface lacks a vertex.
tree_status tree_tiers_from_columns(const struct tree_mesh *mesh,
                                    const struct tree_elements *elements,
                                    const struct tree_tier_columns *columns,
                                    size_t n_columns,
                                    const struct tree_control *control,
                                    struct tree_tiers **tiers);

// Number of tiers, at least 1.
tree_status tree_tiers_count(const struct tree_tiers *tiers, size_t *n_tiers);

// Views tier `tier`; 0 is the full model. Set `columns->struct_size` first. `TREE_ERROR_PARAMETER` when there is no
// such tier.
tree_status tree_tiers_view(const struct tree_tiers *tiers,
                            size_t tier,
                            struct tree_tier_columns *columns);

// Frees tiers, and with them all views of them.
tree_status tree_tiers_free(struct tree_tiers *tiers);

// Makes `around`, of `size` bytes, the default.
tree_status tree_around_init(struct tree_around *around, size_t size);

// Makes `around`, of `size` bytes, the views from which `tree_order_coverage` looks at a model whose foliage has
// so many triangles: 12 azimuths at pitches of 0 and 0.35 with 256 pixels, and fewer and smaller ones for a
// large model. Its pitches are never freed.
tree_status tree_around_for_order(struct tree_around *around,
                                  size_t size,
                                  size_t n_triangles);

// Makes `around`, of `size` bytes, the views from which `tree_lod_table_measure` looks at a model whose foliage
// has so many triangles: 8 azimuths, level, with 256 pixels, and fewer and smaller ones for a large model.
tree_status tree_around_for_table(struct tree_around *around,
                                  size_t size,
                                  size_t n_triangles);

// Checks every number of `around`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_around_check(const struct tree_around *around);

// Number of the views: azimuths times pitches.
tree_status tree_around_count(const struct tree_around *around, size_t *n_views);

// View `number` (0 is the first), for pictures and masks from there: a framed camera, as wide and high as the
// masks. Set `view->struct_size` first. `TREE_ERROR_PARAMETER` when there is no such view.
tree_status tree_around_view(const struct tree_around *around,
                             size_t number,
                             struct tree_view *view);

// Makes a look of the built-in bark and leaf textures that the species names; NULL is an oak.
// `TREE_ERROR_UNKNOWN_NAME` for a name that is not built in: dress such species with `tree_look_plain`
// or textures of your own. Free the look with `tree_look_free`.
tree_status tree_look_built_in(const struct tree_species *species,
                               struct tree_look **look);

// Makes a look of plain colours without textures, for a species; NULL is an oak. For previews, tests and
// engines that bring their own materials. Leaf cards show as whole rectangles. Free the look with
// `tree_look_free`.
tree_status tree_look_plain(const struct tree_species *species,
                            struct tree_look **look);

// As `tree_look_built_in`, for the species of a tree; with `plain` other than 0 as `tree_look_plain`. Free
// the look with `tree_look_free`.
tree_status tree_look_of_tree(const struct tree_tree *tree,
                              uint32_t plain,
                              struct tree_look **look);

// Makes a look of your own: `bark` goes on all wood (NULL is the default material), and `leaves` has one
// row for each of the species' leaf kinds, in that order. All is copied but the textures, which are
// shared. `control` may be NULL; only its limits matter. Free the look with `tree_look_free`.
tree_status tree_look_new(const struct tree_material *bark,
                          const struct tree_leaf_look *leaves,
                          size_t n_leaves,
                          const struct tree_control *control,
                          struct tree_look **look);

// Makes a look that is as another but for the leaves of kind `kind`. Textures are shared; the other look stays as it is.
// `control` may be NULL; only its limits matter. Free the new look with `tree_look_free`.
tree_status tree_look_with_leaf(const struct tree_look *look,
                                size_t kind,
                                const struct tree_leaf_look *leaf,
                                const struct tree_control *control,
                                struct tree_look **changed);

// Number of leaf kinds that a look dresses; it has one material more.
tree_status tree_look_leaf_count(const struct tree_look *look, size_t *n_leaves);

// Views a material of a look, numbered as in the meshes it dresses: 0 is the bark's, 1 + k that of leaf
// kind k. Set `material->struct_size` first. Valid until the look is freed.
tree_status tree_look_material(const struct tree_look *look,
                               size_t number,
                               struct tree_material *material);

// A handle of the texture of a look's material, numbered as for `tree_look_material`; the pixels are
// shared. NULL, and no error, where the material has none. Free it with `tree_texture_free`.
tree_status tree_look_texture(const struct tree_look *look,
                              size_t number,
                              struct tree_texture **texture);

// Views the look of leaf kind `kind`, but for its material and its mesh, which `tree_look_material` and
// `tree_look_leaf_mesh` view. Set `leaf->struct_size` first.
tree_status tree_look_leaf(const struct tree_look *look,
                           size_t kind,
                           struct tree_leaf_look *leaf);

// Checks that a look has one leaf look for each leaf kind of the species (NULL is an oak).
tree_status tree_look_check(const struct tree_look *look, const struct tree_species *species);

// Frees a look. Meshes that were built with it keep their textures.
tree_status tree_look_free(struct tree_look *look);

// Makes `style`, of `size` bytes, the default.
tree_status tree_bark_style_init(struct tree_bark_style *style, size_t size);

// The style of a built-in bark, to be changed; what it points at is valid for ever. Set
// `style->struct_size` first.
tree_status tree_bark_style_of(const char *name, size_t name_len, struct tree_bark_style *style);

// Draws a bark of your own, which tiles without a seam; its name is `bark`. `style` may be NULL; `size` is
// as for `tree_texture_bark`. Free the texture with `tree_texture_free`.
tree_status tree_texture_bark_with(const struct tree_bark_style *style,
                                   uint32_t size,
                                   const struct tree_control *control,
                                   struct tree_texture **texture);

// Makes `look`, of `size` bytes, the default: a square card.
tree_status tree_leaf_look_init(struct tree_leaf_look *look, size_t size);

// Makes the mesh of one leaf of kind `kind`. `report` may be NULL. Free the model with
// `tree_leaf_model_free`.
tree_status tree_look_leaf_model(const struct tree_look *look,
                                 size_t kind,
                                 const struct tree_control *control,
                                 struct tree_leaf_model_report *report,
                                 struct tree_leaf_model **model);

// Views the columns of a leaf's mesh. Set `mesh->struct_size` first. Valid until the model is freed.
tree_status tree_leaf_model_view(const struct tree_leaf_model *model,
                                 struct tree_leaf_mesh *mesh);

// Frees a leaf's mesh.
tree_status tree_leaf_model_free(struct tree_leaf_model *model);

// Views the leaf of your own that kind `kind` of a look has; without vertices where its form is not
// `TREE_LEAF_MESH`. Set `mesh->struct_size` first. Valid until the look is freed.
tree_status tree_look_leaf_mesh(const struct tree_look *look,
                                size_t kind,
                                struct tree_leaf_mesh *mesh);

// Makes `shape`, of `size` bytes, the default.
tree_status tree_leaf_shape_init(struct tree_leaf_shape *shape, size_t size);

// The shape of a built-in leaf, to be changed; what it points at is valid for ever. Set
// `shape->struct_size` first.
tree_status tree_leaf_shape_of(const char *name, size_t name_len, struct tree_leaf_shape *shape);

// Turns the colours of a shape to those of autumn: `progress` 0 is summer and changes nothing, 1 is fully
// turned.
tree_status tree_leaf_shape_autumn(struct tree_leaf_shape *shape,
                                   float progress);

// Draws a leaf of your own, upright with the base at the bottom centre; its name is `leaf`. `shape` and
// `card` may be NULL; `size` and `card` are as for `tree_texture_leaf`. Free the texture with
// `tree_texture_free`.
tree_status tree_texture_leaf_with(const struct tree_leaf_shape *shape,
                                   uint32_t size,
                                   const struct tree_control *control,
                                   struct tree_leaf_card *card,
                                   struct tree_texture **texture);

// Makes `material`, of `size` bytes, the default: white, matt, without texture.
tree_status tree_material_init(struct tree_material *material, size_t size);

// Views the names of the built-in barks: where they begin and how many there are. Valid for ever.
tree_status tree_bark_names(const struct tree_str **names, size_t *n_names);

// Views the names of the built-in leaves (single ones, clusters, needles and fronds): where they begin
// and how many there are. Valid for ever.
tree_status tree_leaf_names(const struct tree_str **names,
                            size_t *n_names);

// Makes a texture of pixels, which are copied. `control` may be NULL; only its limits matter. Free the
// texture with `tree_texture_free`.
tree_status tree_texture_from_pixels(const struct tree_texture_pixels *pixels,
                                     const struct tree_control *control,
                                     struct tree_texture **texture);

// Makes a texture of a PNG or JPEG file in memory, recognised by its content. A photograph is turned
// upright as its camera noted. `TREE_ERROR_LIMIT` when file or picture are larger than the limits
// `input_bytes` and `pixels` allow, before it is decoded. Free the texture with `tree_texture_free`.
tree_status tree_texture_from_bytes(const char *name,
                                    size_t name_len,
                                    const uint8_t *data,
                                    size_t len,
                                    const struct tree_control *control,
                                    struct tree_texture **texture);

// As `tree_texture_from_bytes`, of a file on disk. The texture is named after the file. Free it with
// `tree_texture_free`.
tree_status tree_texture_read(const char *path,
                              size_t path_len,
                              const struct tree_control *control,
                              struct tree_texture **texture);

// Draws a built-in bark, which tiles without a seam; `tree_bark_names` has the names. `size` is width and
// height in pixels, 16 to 4096, or 0 for 512. Free the texture with `tree_texture_free`.
tree_status tree_texture_bark(const char *name,
                              size_t name_len,
                              uint32_t size,
                              const struct tree_control *control,
                              struct tree_texture **texture);

// Draws a built-in leaf, upright with the base at the bottom centre; `tree_leaf_names` has the names.
// Transparent pixels carry the colour of the leaf near them; meant for an alpha cutoff of 0.5. `size` is
// width and height in pixels, 16 to 4096, or 0 for 256, and 512 for clusters, needles and fronds. `card`
// says how to put it on a card; it may be NULL. Free the texture with `tree_texture_free`.
tree_status tree_texture_leaf(const char *name,
                              size_t name_len,
                              uint32_t size,
                              const struct tree_control *control,
                              struct tree_leaf_card *card,
                              struct tree_texture **texture);

// Views a texture's name and pixels. Set `pixels->struct_size` first. Valid until the texture is freed.
tree_status tree_texture_view(const struct tree_texture *texture,
                              struct tree_texture_pixels *pixels);

// Makes a PNG file in memory of a texture. Free it with `tree_bytes_free`.
tree_status tree_texture_to_png(const struct tree_texture *texture, struct tree_bytes **png);

// Writes a texture as a PNG file, whole or not at all.
tree_status tree_texture_write_png(const struct tree_texture *texture,
                                   const char *path,
                                   size_t path_len);

// Frees a texture's handle. Materials and meshes that have the picture keep it.
tree_status tree_texture_free(struct tree_texture *texture);

// Symbol and number of parameters of a kind of module, 0 to `tree_grammar_info.n_kinds` less 1. `F(1)` and
// `F(1,2)` are of two kinds. The name is valid until the grammar is freed.
tree_status tree_grammar_kind(const struct tree_grammar *grammar,
                              uint16_t kind,
                              struct tree_str *name,
                              size_t *n_params);

// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
// `TREE_ERROR_UNKNOWN_NAME` when the grammar has no such module.
tree_status tree_grammar_find_kind(const struct tree_grammar *grammar,
                                   const char *name,
                                   size_t len,
                                   size_t n_params,
                                   uint16_t *kind);

// Symbol and number of parameters of a kind of module, 0 to `tree_word_columns.n_kinds` less 1. The name is
// valid until the word is freed.
tree_status tree_word_kind(const struct tree_word *word,
                           uint16_t kind,
                           struct tree_str *name,
                           size_t *n_params);

// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
// `TREE_ERROR_UNKNOWN_NAME` when the word's alphabet has no such module.
tree_status tree_word_find_kind(const struct tree_word *word,
                                const char *name,
                                size_t len,
                                size_t n_params,
                                uint16_t *kind);

// Makes `params`, of `size` bytes, the default.
tree_status tree_chain_params_init(struct tree_chain_params *params, size_t size);

// Writes a skeleton as a word in metres from its base, with leaves in columns, or NULL for none: an internode is
// turns `+(a)` `&(b)`, a diameter `!(w)` and a length `F(l)`, as far as they change; what leaves the axis at a node
// is in brackets, and so is each leaf, `~(size,kind)`. `tree_word_interpret` with `tree_chain_turtle` draws it.
// `tree_word_past` says which node and leaf is which. `params` and `control` may be NULL. `TREE_ERROR_INVALID`
// for a leaf on a node that is not there, `TREE_ERROR_LIMIT` for a word of many more modules than
// `tree_limits.modules`, which is looked at from time to time. Free the word with `tree_word_free`.
tree_status tree_skeleton_to_word(const struct tree_skeleton *skeleton,
                                  const struct tree_foliage *foliage,
                                  const struct tree_chain_params *params,
                                  const struct tree_control *control,
                                  struct tree_word **word);

// Writes a tree, wood and leaves, as a word. Otherwise as `tree_skeleton_to_word`.
tree_status tree_tree_to_word(const struct tree_tree *tree,
                              const struct tree_chain_params *params,
                              const struct tree_control *control,
                              struct tree_word **word);

// Applies a grammar's productions to all modules at once, `steps` times (0 to 1,000,000), beginning with the
// axiom; `TREE_STEPS_OF_TEXT` takes the number from the text. The same `seed` gives the same word for any number
// of threads. `control` may be NULL. `TREE_ERROR_INVALID` names module and production where an expression has no
// finite value; `TREE_ERROR_LIMIT` comes before the word grows beyond `tree_limits.modules`. `tree_word_past`
// tells how it grew. Free the word with `tree_word_free`.
tree_status tree_grammar_derive(const struct tree_grammar *grammar,
                                uint32_t steps,
                                uint64_t seed,
                                const struct tree_control *control,
                                struct tree_word **word);

// Applies a grammar's productions to a word once: step `step`, counted from 0, of `of` steps, which conditions
// see as `itNum` and `maxIt`. Steps one by one from `tree_grammar_axiom` give the word of `tree_grammar_derive`
// (where the axiom is not random and not decomposed). `control` may be NULL. Errors are those of
// `tree_grammar_derive`, and `TREE_ERROR_INVALID` for a word of another alphabet. Free the new word with
// `tree_word_free`.
tree_status tree_grammar_step(const struct tree_grammar *grammar,
                              const struct tree_word *word,
                              uint32_t step,
                              uint32_t of,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_word **next);

// The word as a turtle is to see it: the grammar's rules of interpretation applied, again to what they give,
// down to their `maximum depth`. Without such rules it is a copy. Otherwise as `tree_grammar_step`.
tree_status tree_grammar_interpretation(const struct tree_grammar *grammar,
                                        const struct tree_word *word,
                                        uint64_t seed,
                                        const struct tree_control *control,
                                        struct tree_word **seen);

// Draws a word as a tree: a turtle reads it from left to right.
//
// * `F(l)` draws wood of length l, `f(l)` moves without drawing, `G(l)` draws as `F` does;
// * `+(a)` `-(a)` turn left and right by a degrees, `&(a)` `^(a)` pitch down and up, `\(a)` `/(a)` roll left and
//   right, `|` turns round, `$` rolls until the turtle's left is horizontal;
// * `!(w)` `#(w)` set the diameter; without w it falls, or rises, by the width ratio; `_(e)` sets the elasticity;
// * `[` `]` are a branch, which saves and restores all this; `%` cuts off the rest of one;
// * `{` `.` `}` are a polygon, a corner where the turtle stands, and its end; in it `F` and `f` set corners;
// * `~(s,k)` is a leaf of size s and kind k; `'(n)` is colour n, `'` the next.
//
// Other symbols do nothing, and are counted. `turtle` may be NULL for the default, `control`, `report` and the
// place `trace` may be NULL. `TREE_ERROR_INVALID` names the module: a bracket or brace without its partner, a
// width or size below 0, a leaf kind that the species lacks. Free the tree with `tree_tree_free`, the trace with
// `tree_turtle_trace_free`.
tree_status tree_word_interpret(const struct tree_word *word,
                                const struct tree_turtle_params *turtle,
                                const struct tree_control *control,
                                struct tree_turtle_report *report,
                                struct tree_turtle_trace **trace,
                                struct tree_tree **tree);

// Draws every `F` and `G` of a word as a line, in its order: six floats, where it begins and where it ends, in
// units times `turtle->unit`. The turtle starts at the origin and looks along +Y; `+` turns it to -X. Gaps stay
// open, braces draw nothing. `lines` has room for `capacity` floats; six for each module are always enough.
// `n_lines` says how many lines there are, also when the room was too small (`TREE_ERROR_BUFFER`, nothing is
// written). `turtle` and `control` may be NULL. Other errors are those of `tree_word_interpret`.
tree_status tree_word_lines(const struct tree_word *word,
                            const struct tree_turtle_params *turtle,
                            const struct tree_control *control,
                            float *lines,
                            size_t capacity,
                            size_t *n_lines);

// Grows a tree of a grammar: derives the word, applies the rules of interpretation, and draws it. `steps` is the
// number of derivations, 0 to 1,000,000, or `TREE_STEPS_OF_TEXT`. `turtle` may be NULL for that of
// `tree_grammar_turtle`. The same grammar, parameters and `seed` give the same bits for any number of threads.
// `control`, `report` and the places `word` and `trace` may be NULL; the word is the one that was drawn, with the
// growth of the derivation as its past. Errors are those of `tree_grammar_derive` and `tree_word_interpret`. Free
// the tree with `tree_tree_free`, the others with `tree_word_free` and `tree_turtle_trace_free`.
tree_status tree_lsystem_grow(const struct tree_grammar *grammar,
                              uint32_t steps,
                              const struct tree_turtle_params *turtle,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_turtle_report *report,
                              struct tree_word **word,
                              struct tree_turtle_trace **trace,
                              struct tree_tree **tree);

// Reads a grammar in the notation of *The Algorithmic Beauty of Plants* and of the programs cpfg and L-studio,
// `text` of `len` bytes or `TREE_NUL_TERMINATED`. One line is a statement:
//
// * `#define r 0.5` or `r = 0.5`: a constant; `#symbols Apex`: symbols of more than one character;
// * `steps: 7`, `angle: 25.7`, `seed: 3`, `#ignore +-F`, `#consider AB`: settings;
// * `axiom: A(1)`: the word to begin with;
// * `A(x) : x > 1 -> F(x)[+A(x*r)]A(x*r)`: a production; `B(y) < A(x) > C` gives it a context,
//   `A -(.3)-> B` or `A -> B : .3` a weight among others;
// * `decomposition`, `interpretation`, `productions`: what follows are rules of that section.
//
// `control` may be NULL; only its limits matter. `report` may be NULL; it says in which line and column a
// mistake is, with `TREE_ERROR_INVALID`. Free the grammar with `tree_grammar_free`.
tree_status tree_grammar_from_text(const char *text,
                                   size_t len,
                                   const struct tree_control *control,
                                   struct tree_grammar_report *report,
                                   struct tree_grammar **grammar);

// Reads a grammar from a file in UTF-8. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and
// `path_len` is `TREE_NUL_TERMINATED`. Otherwise as `tree_grammar_from_text`.
tree_status tree_grammar_read(const char *path,
                              size_t path_len,
                              const struct tree_control *control,
                              struct tree_grammar_report *report,
                              struct tree_grammar **grammar);

// Views what a grammar says. Set `info->struct_size` first.
tree_status tree_grammar_view(const struct tree_grammar *grammar, struct tree_grammar_info *info);

// Name and value of a constant of the text, in the order of their names; `steps` and `angle` are among them
// where the text sets them. `index` is below `tree_grammar_info.n_constants`. The name is valid until the
// grammar is freed.
tree_status tree_grammar_constant(const struct tree_grammar *grammar,
                                  size_t index,
                                  struct tree_str *name,
                                  double *value);

// A copy of the grammar in which a constant of the text has another value; all that depends on it is computed
// anew. `steps` (fractions are cut off) and `angle` can be set as well. `name` has `len` bytes or
// `TREE_NUL_TERMINATED`. `TREE_ERROR_PARAMETER` for a value that is not finite or steps beyond 0 to 1,000,000,
// `TREE_ERROR_INVALID` when the text has no such constant, or an expression of constants has no value then:
// `report`, which may be NULL, says where. Words of the one grammar are words of the other. Free the copy with
// `tree_grammar_free`.
tree_status tree_grammar_with_constant(const struct tree_grammar *grammar,
                                       const char *name,
                                       size_t len,
                                       double value,
                                       struct tree_grammar_report *report,
                                       struct tree_grammar **changed);

// Frees a grammar. Its words live on.
tree_status tree_grammar_free(struct tree_grammar *grammar);

// Number of ready-made L-systems: leafy species of this library first, then those of the books.
size_t tree_lsystem_preset_count(void);

// Tells name, title, source and text of a preset. `index` is below `tree_lsystem_preset_count`. Set
// `info->struct_size` first.
tree_status tree_lsystem_preset_view(size_t index, struct tree_lsystem_preset_info *info);

// Name and value of a constant of the text that a preset changes: presets of one figure share a text. `constant`
// is below `tree_lsystem_preset_info.n_constants`. The name is valid for ever.
tree_status tree_lsystem_preset_constant(size_t index,
                                         size_t constant,
                                         struct tree_str *name,
                                         double *value);

// The preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`): `turtle`, of `size` bytes, becomes how it is
// drawn, what that points at belongs to the library and lives for ever; `grammar` what it derives. Give both to
// `tree_lsystem_grow`. Free the grammar with `tree_grammar_free`. `TREE_ERROR_UNKNOWN_NAME` lists the names there
// are.
tree_status tree_lsystem_preset(const char *name,
                                size_t len,
                                struct tree_turtle_params *turtle,
                                size_t size,
                                struct tree_grammar **grammar);

// Views the polygons. Set `polygons->struct_size` first.
tree_status tree_turtle_trace_view(const struct tree_turtle_trace *trace,
                                   struct tree_turtle_polygons *polygons);

// A symbol that says nothing to the turtle, and how often it was met. `index` is below
// `tree_turtle_report.n_skipped`. The name is valid until the trace is freed.
tree_status tree_turtle_trace_skipped(const struct tree_turtle_trace *trace,
                                      size_t index,
                                      struct tree_str *name,
                                      size_t *n_times);

// All that may surprise, a sentence for each; there may be none. Free the lines with `tree_lines_free`.
tree_status tree_turtle_trace_warnings(const struct tree_turtle_trace *trace,
                                       struct tree_lines **warnings);

// Frees what a turtle drew beside the tree.
tree_status tree_turtle_trace_free(struct tree_turtle_trace *trace);

// Makes `params`, of `size` bytes, the default.
tree_status tree_turtle_params_init(struct tree_turtle_params *params, size_t size);

// Checks that all parameters lie in their ranges, as functions that take them do first. `params` may be NULL for
// the default.
tree_status tree_turtle_params_check(const struct tree_turtle_params *params);

// Makes `params`, of `size` bytes, what a grammar says: its angle, and the constants of its text that have the
// names `step`, `width`, `width_ratio`, `leaf_size`, `elasticity`, `tropism_x`, `tropism_y`, `tropism_z`, `unit`,
// `height` and `trunk_radius`. `TREE_ERROR_PARAMETER` names one that is out of its range.
tree_status tree_grammar_turtle(const struct tree_grammar *grammar,
                                struct tree_turtle_params *params,
                                size_t size);

// Makes `params`, of `size` bytes, the turtle that draws words of `tree_skeleton_to_word`: in metres, widths at
// the upper ends of internodes.
tree_status tree_chain_turtle(struct tree_turtle_params *params,
                              size_t size);

// Reads a word without a grammar: a symbol is one character, its parameters are numbers in parentheses, divided
// by commas. `text` has `len` bytes or `TREE_NUL_TERMINATED`. Brackets need not pair; `tree_word_check` looks.
// `control` may be NULL; only its limits matter. `report` may be NULL; it says which module is wrong, with
// `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
tree_status tree_word_from_text(const char *text,
                                size_t len,
                                const struct tree_control *control,
                                struct tree_grammar_report *report,
                                struct tree_word **word);

// Reads a word of a grammar's modules, such as `F(1)[+F(0.5)]`. `TREE_ERROR_INVALID` also for modules that the
// grammar does not have, and for brackets that do not pair. Otherwise as `tree_word_from_text`.
tree_status tree_grammar_word(const struct tree_grammar *grammar,
                              const char *text,
                              size_t len,
                              const struct tree_control *control,
                              struct tree_grammar_report *report,
                              struct tree_word **word);

// Makes a word of a grammar's modules from columns, which are copied: kinds are those of the grammar, each
// module has as many parameters as its kind says. `control` may be NULL; only its limits matter. `report` may
// be NULL; it says which module is wrong, with `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
tree_status tree_grammar_word_from_columns(const struct tree_grammar *grammar,
                                           const struct tree_word_columns *columns,
                                           const struct tree_control *control,
                                           struct tree_grammar_report *report,
                                           struct tree_word **word);

// The word that the grammar's derivations begin with; random numbers in it come from the seed of the text.
// Free it with `tree_word_free`.
tree_status tree_grammar_axiom(const struct tree_grammar *grammar,
                               struct tree_word **word);

// Views a word. Set `columns->struct_size` first.
tree_status tree_word_view(const struct tree_word *word, struct tree_word_columns *columns);

// Views what a word came from. Set `history->struct_size` first.
tree_status tree_word_past(const struct tree_word *word, struct tree_word_history *history);

// Writes a word as text, which `tree_word_from_text` and `tree_grammar_word` read back to the same bits (the
// former where all symbols are of one character). Free it with `tree_bytes_free`.
tree_status tree_word_to_text(const struct tree_word *word,
                              struct tree_bytes **text);

// Checks that every bracket of a word has its partner. `TREE_ERROR_INVALID` names the module that has none.
tree_status tree_word_check(const struct tree_word *word);

// Frees a word.
tree_status tree_word_free(struct tree_word *word);

// Bytes that the library has allocated and not freed, objects and work in progress together.
uint64_t tree_memory_used(void);

// Most bytes in use at one time since the start, or since `tree_memory_reset_peak`; small blocks may be
// missed by some kilobytes.
uint64_t tree_memory_peak(void);

// Lets the peak begin anew at what is in use now.
void tree_memory_reset_peak(void);

// Sets how many bytes the library may have in use, all calls and objects together; 0 for no budget, as
// at the start. A call that would need more fails with `TREE_ERROR_LIMIT` before it takes the memory,
// or with `TREE_ERROR_MEMORY` while it works; what it had taken is free again then. Several calls at
// once may all be told so. Calls that take no memory, such as looking at a mesh, never are. An eighth of
// the budget is kept for what is taken between two looks at it; a call that went beyond all the same fails
// at its end.
void tree_memory_set_budget(uint64_t bytes);

// The budget in bytes; 0 when there is none.
uint64_t tree_memory_budget(void);

// Lets the library take its memory from the host's allocator. Only before anything else: once the
// library has memory of its own it is `TREE_ERROR_ORDER`. When `allocate` gives NULL the process aborts, as
// Rust does; set a budget below what the allocator has.
tree_status tree_memory_set_allocator(const struct tree_allocator *allocator);

// Frees a mesh, and with it all views of it.
tree_status tree_mesh_free(struct tree_mesh *mesh);

// Views the branches that a mesh's vertices move with, parents first: where they begin, NULL for none,
// and how many there are. Valid until the mesh is freed.
tree_status tree_mesh_branches(const struct tree_mesh *mesh,
                               const struct tree_wind_branch **branches,
                               size_t *n_branches);

// Builds bark and leaves of a tree: surface 0 is the bark, surface 1 + k the leaves of kind k; those
// without triangles are there too. Materials are in the same order.
//
// `look` may be NULL: the built-in textures that the tree's species names, as `tree_look_of_tree` gives
// them; to build many meshes, make a look once. `params` may be NULL. `report` may be NULL. Free the mesh
// with `tree_mesh_free`.
tree_status tree_mesh_build(const struct tree_tree *tree,
                            const struct tree_look *look,
                            const struct tree_mesh_params *params,
                            const struct tree_control *control,
                            struct tree_mesh_report *report,
                            struct tree_mesh **mesh);

// Builds the leaves alone, for those who draw the wood themselves: the mesh of `tree_mesh_build`, where surface 0 is
// empty and vertices have no wind. `look` and `params` are as there.
tree_status tree_mesh_build_leaves(const struct tree_tree *tree,
                                   const struct tree_look *look,
                                   const struct tree_mesh_params *params,
                                   const struct tree_control *control,
                                   struct tree_mesh **mesh);

// Makes `params`, of `size` bytes, the default.
tree_status tree_subdivide_params_init(struct tree_subdivide_params *params, size_t size);

// Makes a mesh whose surface `number` is finer and rounder: Loop subdivision with creases kept. A closed
// surface stays closed. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params`
// may be NULL. Free the mesh with `tree_mesh_free`.
tree_status tree_mesh_subdivide(const struct tree_mesh *mesh,
                                size_t number,
                                const struct tree_subdivide_params *params,
                                const struct tree_control *control,
                                struct tree_mesh **subdivided);

// Makes `params`, of `size` bytes, the default.
tree_status tree_displace_params_init(struct tree_displace_params *params, size_t size);

// Makes a mesh whose surface `number` has relief: points moved in and out by noise, normals and tangents
// tilted with them. A closed surface stays closed. The surface should be finer than `scale`: subdivide it
// first. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params` may be NULL.
// Free the mesh with `tree_mesh_free`.
tree_status tree_mesh_displace(const struct tree_mesh *mesh,
                               size_t number,
                               const struct tree_displace_params *params,
                               uint64_t seed,
                               const struct tree_control *control,
                               struct tree_mesh **displaced);

// Makes `params`, of `size` bytes, the default.
tree_status tree_occlusion_params_init(struct tree_occlusion_params *params, size_t size);

// Makes a copy of a mesh whose surfaces have the column `occlusion`: 1 where all light arrives, 0 where
// none does. The cells count against the limit `voxels`. `params` may be NULL. Free the mesh with
// `tree_mesh_free`.
tree_status tree_mesh_bake_occlusion(const struct tree_mesh *mesh,
                                     const struct tree_occlusion_params *params,
                                     const struct tree_control *control,
                                     struct tree_mesh **baked);

// Makes a mesh whose surface `number` has one vertex for each point: for volumes, printers and other
// programs that take copies at seams for holes. Triangles that have two corners at one point are left
// out, and so are vertices without triangles. Normals are the means of the copies' normals, texture
// coordinates those of the first copy, so textures are torn at seams; tangents are dropped. Everything
// else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `control` may be NULL; only its pool
// matters. Free the mesh with `tree_mesh_free`.
tree_status tree_mesh_weld(const struct tree_mesh *mesh,
                           size_t number,
                           const struct tree_control *control,
                           struct tree_mesh **welded);

// Makes a mesh of your own triangles: `n_surfaces` surfaces whose `material` is an index into the
// `n_materials` materials. `branches` may be NULL when `n_branches` is 0; no surface may name a branch
// then. All is copied but the textures, which are shared, and checked as by `tree_mesh_check`. `control`
// may be NULL; only its limits and its pool matter. Free the mesh with `tree_mesh_free`.
tree_status tree_mesh_from_surfaces(const struct tree_surface *surfaces,
                                    size_t n_surfaces,
                                    const struct tree_material *materials,
                                    size_t n_materials,
                                    const struct tree_wind_branch *branches,
                                    size_t n_branches,
                                    const struct tree_control *control,
                                    struct tree_mesh **mesh);

// Views material `number` of a mesh, from 0 on; `material` of `tree_surface` says which one a surface
// has. Set `material->struct_size` first. Valid until the mesh is freed.
tree_status tree_mesh_material(const struct tree_mesh *mesh,
                               size_t number,
                               struct tree_material *material);

// A handle of the texture of material `number`; the pixels are shared, and outlive the mesh. NULL, and no
// error, where the material has none. Free it with `tree_texture_free`.
tree_status tree_mesh_texture(const struct tree_mesh *mesh,
                              size_t number,
                              struct tree_texture **texture);

// Makes `params`, of `size` bytes, the default.
tree_status tree_mesh_params_init(struct tree_mesh_params *params, size_t size);

// Checks every field against its range: `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
// fault.
tree_status tree_mesh_params_check(const struct tree_mesh_params *params);

// The error that the parameters allow as a length in metres, within 0.01 mm and 1 m: for
// `TREE_BOUND_PIXELS`, how large a pixel is at the tree. `params` may be NULL.
tree_status tree_mesh_params_error(const struct tree_mesh_params *params, float *metres);

// Counts points, edges, holes, pieces and the like of surface `number`. Set `topology->struct_size` first.
// `control` may be NULL; only its pool matters.
tree_status tree_mesh_examine(const struct tree_mesh *mesh,
                              size_t number,
                              const struct tree_control *control,
                              struct tree_topology *topology);

// The points of surface `number`, numbered in the order of their first vertices: by its welds where it
// has them, otherwise vertices at exactly the same place are one point.
//
// `of_vertex`, NULL or with room for `of_vertex_capacity` numbers (one for each vertex), gets the point
// that each vertex stands at. `first`, NULL or with room for `first_capacity` numbers (as many as there are vertices are always
// enough), gets the first vertex of each point. `n_points` gets their number; it may be NULL.
tree_status tree_mesh_points(const struct tree_mesh *mesh,
                             size_t number,
                             uint32_t *of_vertex,
                             size_t of_vertex_capacity,
                             uint32_t *first,
                             size_t first_capacity,
                             size_t *n_points);

// Finds the triangles of surface `number` that cross or touch each other without sharing a point, and
// those that share one point and meet again beyond it. Triangles that share an edge are not tested (they
// cross only when folded flat on each other), nor are those with two corners at one point. Pairs count
// against the limit `triangles`. Free the answer with `tree_crossings_free`.
tree_status tree_mesh_crossings(const struct tree_mesh *mesh,
                                size_t number,
                                const struct tree_control *control,
                                struct tree_crossings **crossings);

// Views crossings. Set `pairs->struct_size` first. Valid until they are freed.
tree_status tree_crossings_view(const struct tree_crossings *crossings,
                                struct tree_crossing_pairs *pairs);

// Frees crossings.
tree_status tree_crossings_free(struct tree_crossings *crossings);

// Counts what a mesh has. Set `totals->struct_size` first.
tree_status tree_mesh_measure(const struct tree_mesh *mesh, struct tree_mesh_totals *totals);

// Number of surfaces of a mesh.
tree_status tree_mesh_surface_count(const struct tree_mesh *mesh, size_t *n_surfaces);

// Views surface `number` of a mesh, from 0 on: nothing is copied. Set `surface->struct_size` first. Valid
// until the mesh is freed.
tree_status tree_mesh_surface(const struct tree_mesh *mesh,
                              size_t number,
                              struct tree_surface *surface);

// The box and a ball around all vertices of surface `number`. Looks at each vertex: keep the answer.
tree_status tree_mesh_surface_bounds(const struct tree_mesh *mesh,
                                     size_t number,
                                     struct tree_bounds *bounds);

// The box and a ball around all vertices of a mesh. Looks at each vertex: keep the answer.
tree_status tree_mesh_bounds(const struct tree_mesh *mesh, struct tree_bounds *bounds);

// Checks that a mesh can be drawn and written: columns of equal length, finite numbers, indices and
// materials that exist, looks within their ranges, textures filled, branches after those that carry them.
// Meshes of this library pass.
tree_status tree_mesh_check(const struct tree_mesh *mesh);

// As `tree_mesh_check`, of the columns of surface `number` only.
tree_status tree_mesh_check_surface(const struct tree_mesh *mesh, size_t number);

// Checks that no colour of a material is brighter than 1, on which file formats rely; drawing does not.
tree_status tree_mesh_check_colors(const struct tree_mesh *mesh);

// Checks that normals have unit length, within half a percent, on which file formats and engines rely;
// drawing does not.
tree_status tree_mesh_check_normals(const struct tree_mesh *mesh);

// Finds the branches of a chain: one for each pair of brackets, and one for what is in none. Modules are named by
// their places in the chain, from 0 on, brackets counted. `control` may be NULL; `modules` of its limits caps the
// chain. Free the branches with `tree_adt_free`. `TREE_ERROR_INVALID` for brackets that do not match and for lengths
// that are negative or not finite, and says at which module.
tree_status tree_adt_of_tokens(const struct tree_token_columns *columns,
                               const struct tree_control *control,
                               struct tree_adt **adt);

// Finds the branches of a skeleton: the runs of nodes between forks. Its modules are its nodes; the length of a node is
// that of the segment to its parent, in metres. `control` may be NULL; of it only a cancellation before the work
// begins matters. Free the branches with `tree_adt_free`.
tree_status tree_adt_of_skeleton(const struct tree_skeleton *skeleton,
                                 const struct tree_control *control,
                                 struct tree_adt **adt);

// As `tree_adt_of_skeleton` for the skeleton of a tree; its leaves count among the areas of the branches that bear
// them, as they do for `tree_multires_new`.
tree_status tree_adt_of_tree(const struct tree_tree *tree,
                             const struct tree_control *control,
                             struct tree_adt **adt);

// Views the branches. Set `columns->struct_size` first.
tree_status tree_adt_view(const struct tree_adt *adt, struct tree_adt_columns *columns);

// Views the modules of a branch, in their order: places in the chain, or nodes of the skeleton. `TREE_ERROR_PARAMETER`
// when there is no such branch.
tree_status tree_adt_modules(const struct tree_adt *adt,
                             uint32_t branch,
                             const uint32_t **modules,
                             size_t *n_modules);

// Views the branches that stem from a branch, in the order of the chain. `TREE_ERROR_PARAMETER` when there is no such
// branch.
tree_status tree_adt_children(const struct tree_adt *adt,
                              uint32_t branch,
                              const uint32_t **children,
                              size_t *n_children);

// Frees the branches. Paths that were made of them stay.
tree_status tree_adt_free(struct tree_adt *adt);

// Writes paths one after another as a chain. States have numbers from 0 on, and only those that are needed are saved.
// `control` may be NULL; of it only a cancellation before the work begins matters. Free the chain with
// `tree_multi_chain_free`.
tree_status tree_multi_chain_new(const struct tree_multi_paths *paths,
                                 const struct tree_control *control,
                                 struct tree_multi_chain **chain);

// Views the items. Set `columns->struct_size` first.
tree_status tree_multi_chain_view(const struct tree_multi_chain *chain,
                                  struct tree_multi_chain_columns *columns);

// The first `n_levels` levels as text, at most all, with `SAVE(0)` and `RESTORE(0)`. `text`, in UTF-8, is the plain
// chain of `text_len` bytes, or ends with a NUL and `text_len` is `TREE_NUL_TERMINATED`; `ends` has for each of its
// `n_ends` modules, brackets counted, the byte before which it ends. `control` may be NULL; `input_bytes` of its
// limits caps the text. Free the bytes, which are UTF-8, with `tree_bytes_free`.
//
// `TREE_ERROR_INVALID` when ends fall, lie within a letter or behind the text, or a module of the chain has none.
tree_status tree_multi_chain_to_text(const struct tree_multi_chain *chain,
                                     size_t n_levels,
                                     const char *text,
                                     size_t text_len,
                                     const uint32_t *ends,
                                     size_t n_ends,
                                     const struct tree_control *control,
                                     struct tree_bytes **bytes);

// Frees a chain.
tree_status tree_multi_chain_free(struct tree_multi_chain *chain);

// A mesh with all its levels as a GLB file in memory, for engines that draw prefixes: an attribute `_TREE_BRANCH` of 4
// floats a vertex, as in `tree_multi_mesh_column`, is what lets branches grow in. Other programs show the whole tree.
// `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`.
// `TREE_ERROR_PARAMETER` for `quantize`: shaders need positions in metres.
tree_status tree_multi_mesh_to_glb(const struct tree_multi_mesh *multi_mesh,
                                   const struct tree_glb_options *options,
                                   const struct tree_control *control,
                                   struct tree_bytes **bytes);

// As `tree_multi_mesh_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_multi_mesh_write_glb(const struct tree_multi_mesh *multi_mesh,
                                      const char *path,
                                      size_t path_len,
                                      const struct tree_glb_options *options,
                                      const struct tree_control *control);

// Levels, at most 1024 of them, as the `MSFT_lod` of one GLB file, each a mesh of its own: for programs without shaders
// of ours. Both levels and shares fall. `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the
// bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no levels, or levels or shares do not fall.
tree_status tree_multi_mesh_to_glb_levels(const struct tree_multi_mesh *multi_mesh,
                                          const struct tree_level_share *levels,
                                          size_t n_levels,
                                          const struct tree_glb_options *options,
                                          const struct tree_control *control,
                                          struct tree_bytes **bytes);

// As `tree_multi_mesh_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_multi_mesh_write_glb_levels(const struct tree_multi_mesh *multi_mesh,
                                             const struct tree_level_share *levels,
                                             size_t n_levels,
                                             const char *path,
                                             size_t path_len,
                                             const struct tree_glb_options *options,
                                             const struct tree_control *control);

// The function `tree_grow_position` for a shader: text to be put into your own. It tells what it takes and where that
// comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
tree_status tree_multi_mesh_shader(tree_shader language,
                                   struct tree_str *text);

// Where a shader draws a vertex at a level: `vertex`, three floats, drawn together about its fork while its path grows
// in. `branch` is four floats of `tree_multi_mesh_column.branches`. For shaders of your own, and for checking them.
tree_status tree_multi_mesh_position(const float *vertex,
                                     const float *branch,
                                     float level,
                                     float (*drawn)[3]);

// Draws a tree: each path is a closed tube of its own, with a cap at either end, and begins inside the wood that bears
// it; it has a ring at each node, and as many sides all along as `params` ask for. Surface 0 is the wood, surface 1 + k
// the leaves of kind k. Of `params` those of curves, flares, tangents and light maps are not used.
//
// `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL. Free
// the mesh with `tree_multi_mesh_free`. `TREE_ERROR_PARAMETER` for more than 16,777,216 levels; otherwise as
// `tree_mesh_build`.
tree_status tree_multi_mesh_new(const struct tree_multires *multires,
                                const struct tree_look *look,
                                const struct tree_mesh_params *params,
                                const struct tree_control *control,
                                struct tree_multi_mesh **multi_mesh);

// Tells how large a mesh is. Set `totals->struct_size` first.
tree_status tree_multi_mesh_measure(const struct tree_multi_mesh *multi_mesh,
                                    struct tree_multi_mesh_totals *totals);

// The mesh to upload, with all levels, nothing copied. Free it with `tree_mesh_free`; it keeps alive what it is of.
tree_status tree_multi_mesh_mesh(const struct tree_multi_mesh *multi_mesh,
                                 struct tree_mesh **mesh);

// Views what shaders need of the vertices of surface `number`. Set `column->struct_size` first. `TREE_ERROR_PARAMETER`
// when there is no such surface.
tree_status tree_multi_mesh_branches(const struct tree_multi_mesh *multi_mesh,
                                     size_t number,
                                     struct tree_multi_mesh_column *column);

// What is drawn at a level: 3.25 draws three paths whole and a quarter of the fourth, drawn together about its fork by
// the shader; levels are clamped to 1 and all. `draws` has room for `capacity` rows, at least one for each surface, in
// their order; `n_triangles` is how many triangles that is. It is quick enough for every frame.
// `TREE_ERROR_PARAMETER` for NaN.
tree_status tree_multi_mesh_draws(const struct tree_multi_mesh *multi_mesh,
                                  float level,
                                  struct tree_multi_draw *draws,
                                  size_t capacity,
                                  uint64_t *n_triangles);

// Number of indices of the wood, surface 0, that are drawn at a level; levels are clamped to 1 and all.
// `TREE_ERROR_PARAMETER` for NaN.
tree_status tree_multi_mesh_wood_indices(const struct tree_multi_mesh *multi_mesh,
                                         float level,
                                         uint32_t *n_indices);

// The greatest whole level with at most `n_triangles` triangles of wood; at least 1.
tree_status tree_multi_mesh_level_of_wood(const struct tree_multi_mesh *multi_mesh,
                                          uint64_t n_triangles,
                                          size_t *n_levels);

// A level, clamped to 1 and all, as a plain mesh: what is not drawn is left out, and the last path has grown as the
// shader lets it. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free
// the mesh with `tree_mesh_free`. `TREE_ERROR_PARAMETER` for NaN.
tree_status tree_multi_mesh_mesh_at(const struct tree_multi_mesh *multi_mesh,
                                    float level,
                                    const struct tree_control *control,
                                    struct tree_mesh **mesh);

// Frees a mesh with levels, and with it all views of its columns. Meshes made of it stay.
tree_status tree_multi_mesh_free(struct tree_multi_mesh *multi_mesh);

// Sorts a tree, which is copied, by a metric, NULL for the default; its branches are those of `tree_adt_of_skeleton`.
// `seed` matters to `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free what is made with `tree_multires_free`.
//
// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
tree_status tree_multires_new(const struct tree_tree *tree,
                              const struct tree_metric_params *params,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_multires **multires);

// Sorts a tree, which is copied, by paths of its own branches, and tells where rows went: `nodes` and `leaves`, each
// of which may be NULL, get for each node and leaf its number in the tree that came in. Free them with
// `tree_rows_free`, and what is made with `tree_multires_free`. `control` may be NULL; of it only a cancellation before
// the work begins matters. `TREE_ERROR_INVALID` when the paths are those of another tree, or of a chain.
tree_status tree_multires_of_paths(const struct tree_tree *tree,
                                   const struct tree_multi_paths *paths,
                                   const struct tree_control *control,
                                   struct tree_rows **nodes,
                                   struct tree_rows **leaves,
                                   struct tree_multires **multires);

// Number of levels: of tips, at least 1.
tree_status tree_multires_count(const struct tree_multires *multires, size_t *n_levels);

// Nodes and leaves of the first `n_levels` levels, at least one level, at most all.
tree_status tree_multires_level_counts(const struct tree_multires *multires,
                                       size_t n_levels,
                                       size_t *n_nodes,
                                       size_t *n_leaves);

// Views the first `n_levels` levels, at least one, at most all: their nodes are a skeleton, and their leaves stand on
// these. Nothing is copied, and all levels begin at the same places. Each of `columns` and `foliage` may be NULL; set
// its `struct_size` first.
tree_status tree_multires_level(const struct tree_multires *multires,
                                size_t n_levels,
                                struct tree_skeleton_columns *columns,
                                struct tree_foliage *foliage);

// A copy of the first `n_levels` levels, at least one, at most all, as a tree of its own, with its species. `control`
// may be NULL; of it only a cancellation before the work begins matters. Free the tree with `tree_tree_free`.
tree_status tree_multires_tree_at(const struct tree_multires *multires,
                                  size_t n_levels,
                                  const struct tree_control *control,
                                  struct tree_tree **tree);

// How many levels have at most `n_nodes` nodes together; one if none has so few.
tree_status tree_multires_level_of_nodes(const struct tree_multires *multires,
                                         size_t n_nodes,
                                         size_t *n_levels);

// Frees a multiresolution tree, and with it all views of its levels.
tree_status tree_multires_free(struct tree_multires *multires);

// Makes `params`, of `size` bytes, the default.
tree_status tree_metric_params_init(struct tree_metric_params *params, size_t size);

// Cuts branches into paths and sorts them, the most relevant first. `params` may be NULL for the default metric. `seed` matters to
// `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free the paths with `tree_multi_paths_free`.
//
// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
tree_status tree_multi_paths_new(const struct tree_adt *adt,
                                 const struct tree_metric_params *params,
                                 uint64_t seed,
                                 const struct tree_control *control,
                                 struct tree_multi_paths **paths);

// Number of paths: of levels of detail, at least 1.
tree_status tree_multi_paths_count(const struct tree_multi_paths *paths, size_t *n_paths);

// Views the branches of all paths one after another; those of the first few paths are a prefix.
tree_status tree_multi_paths_branches(const struct tree_multi_paths *paths,
                                      const uint32_t **branches,
                                      size_t *n_branches);

// Views the branches of one path, from its fork up. `TREE_ERROR_PARAMETER` when there is no such path.
tree_status tree_multi_paths_path(const struct tree_multi_paths *paths,
                                  size_t number,
                                  const uint32_t **branches,
                                  size_t *n_branches);

// Frees the paths.
tree_status tree_multi_paths_free(struct tree_multi_paths *paths);

// Makes a reader that nothing has reached yet. `control` may be NULL; the limits that it has now hold for all bytes to
// come: `nodes` and `leaves`, asked for as the head arrives, and `input_bytes` for all bytes together. Free the reader
// with `tree_stream_reader_free`.
tree_status tree_stream_reader_new(const struct tree_control *control,
                                   struct tree_stream_reader **reader);

// Takes the next bytes, any number of them; they are needed during the call only, and never trusted. `report` may be
// NULL. `TREE_ERROR_FORMAT` for bytes that are no stream, are damaged, or follow its end, and `TREE_ERROR_LIMIT`: the
// levels before stay there, and the same comes again for more bytes.
tree_status tree_stream_reader_push(struct tree_stream_reader *reader,
                                    const uint8_t *data,
                                    size_t len,
                                    struct tree_stream_report *report);

// How much has arrived. Set `report->struct_size` first.
tree_status tree_stream_reader_received(const struct tree_stream_reader *reader,
                                        struct tree_stream_report *report);

// The tree of all levels that have arrived, a copy; the reader goes on. `control` may be NULL; of it only a
// cancellation before the work begins matters. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when
// the first level is not there yet.
tree_status tree_stream_reader_multires(const struct tree_stream_reader *reader,
                                        const struct tree_control *control,
                                        struct tree_multires **multires);

// Frees a reader. Trees that came of it stay.
tree_status tree_stream_reader_free(struct tree_stream_reader *reader);

// Makes `params`, of `size` bytes, the default.
tree_status tree_stream_params_init(struct tree_stream_params *params, size_t size);

// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
tree_status tree_stream_params_check(const struct tree_stream_params *params);

// The first `n_levels` levels of a tree, at least one, at most all, as bytes of which every prefix is a coarser tree:
// the stream of `k` levels begins that of `k + 1`. `params` and `control` may be NULL; of `control` only a
// cancellation before the work begins matters. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
// coordinates beyond 1000 km when there is a precision; `TREE_ERROR_FORMAT` for names of more than 4096 bytes.
tree_status tree_multires_to_stream(const struct tree_multires *multires,
                                    size_t n_levels,
                                    const struct tree_stream_params *params,
                                    const struct tree_control *control,
                                    struct tree_bytes **bytes);

// As `tree_multires_to_stream`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
tree_status tree_multires_write_stream(const struct tree_multires *multires,
                                       size_t n_levels,
                                       const char *path,
                                       size_t path_len,
                                       const struct tree_stream_params *params,
                                       const struct tree_control *control);

// The tree as one chain with brackets, in the same code but without levels, to compare sizes with: nothing reads it.
// Otherwise as `tree_multires_to_stream`.
tree_status tree_multires_to_bracketed(const struct tree_multires *multires,
                                       const struct tree_stream_params *params,
                                       const struct tree_control *control,
                                       struct tree_bytes **bytes);

// Reads a stream, or what there is of it: levels up to the first that is cut off. The bytes are needed during the call
// only, and never trusted. `control` and `report` may be NULL; `nodes`, `leaves` and `input_bytes` of the limits cap
// what is read. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when not even the first level is
// whole, and for bytes that are no stream or are damaged.
tree_status tree_multires_from_stream(const uint8_t *data,
                                      size_t len,
                                      const struct tree_control *control,
                                      struct tree_stream_report *report,
                                      struct tree_multires **multires);

// As `tree_multires_from_stream`, from a file; the path as in `tree_mesh_write_glb`. A file that was cut off is read as
// far as it goes.
tree_status tree_multires_read_stream(const char *path,
                                      size_t path_len,
                                      const struct tree_control *control,
                                      struct tree_stream_report *report,
                                      struct tree_multires **multires);

// The density of a tree from `n_views` views, at least one: optical depth per metre, such that looking
// through the grid gives the mattes. It is `tree_carved_new` and `tree_carved_solve` in one.
//
// `params`, `control` and `report` may be NULL. `rows`, NULL or with room for `capacity` rows (one for each
// view), says how well each view fits. Free the grid with `tree_grid_free`. `TREE_ERROR_NO_RESULT` names a
// view that shows no tree, is not of its camera's size, or leaves nothing of what the others see;
// `TREE_ERROR_PARAMETER` what is out of range; `TREE_ERROR_LIMIT` comes before too many voxels.
tree_status tree_grid_from_views(const struct tree_particle_view *views,
                                 size_t n_views,
                                 const struct tree_density_params *params,
                                 const struct tree_control *control,
                                 struct tree_density_report *report,
                                 struct tree_density_view *rows,
                                 size_t capacity,
                                 struct tree_grid **grid);

// The first stage of `tree_grid_from_views`: lays a grid of cubes around what the views see and throws away
// those that a view shows to be empty. Arguments and errors are as there. Free it with `tree_carved_free`.
tree_status tree_carved_new(const struct tree_particle_view *views,
                            size_t n_views,
                            const struct tree_density_params *params,
                            const struct tree_control *control,
                            struct tree_carved **carved);

// Views what carving left. Set `columns->struct_size` first.
tree_status tree_carved_view(const struct tree_carved *carved, struct tree_carved_columns *columns);

// The grid of carving: in each voxel the least of the average mattes it projects to, 0 to 1; 0 where it was
// thrown away. Free it with `tree_grid_free`.
tree_status tree_carved_alpha(const struct tree_carved *carved,
                              struct tree_grid **grid);

// The second stage of `tree_grid_from_views`: densities in the voxels that were left, for the views and
// params that were carved. Arguments and errors are as there. Free the grid with `tree_grid_free`.
tree_status tree_carved_solve(const struct tree_carved *carved,
                              const struct tree_particle_view *views,
                              size_t n_views,
                              const struct tree_density_params *params,
                              const struct tree_control *control,
                              struct tree_density_report *report,
                              struct tree_density_view *rows,
                              size_t capacity,
                              struct tree_grid **grid);

// Frees what carving left.
tree_status tree_carved_free(struct tree_carved *carved);

// Sets up the equations that `tree_carved_solve` solves, for the views and params that were carved. Arguments
// and errors are as there; `TREE_ERROR_LIMIT` too when there are more entries than the limit on voxels allows.
// Free them with `tree_equations_free`.
tree_status tree_equations_new(const struct tree_carved *carved,
                               const struct tree_particle_view *views,
                               size_t n_views,
                               const struct tree_density_params *params,
                               const struct tree_control *control,
                               struct tree_equations **equations);

// Views equations. Set `columns->struct_size` first.
tree_status tree_equations_view(const struct tree_equations *equations,
                                struct tree_equations_columns *columns);

// Frees equations.
tree_status tree_equations_free(struct tree_equations *equations);

// The matte that a camera sees of a density: 1 - exp(-sum of density times length) along the ray of each
// pixel. `control` may be NULL. Free the matte with `tree_matte_free`.
tree_status tree_grid_look_through(const struct tree_grid *grid,
                                   const struct tree_particle_camera *camera,
                                   const struct tree_control *control,
                                   struct tree_matte **matte);

// Cubic metres of the voxels above `threshold` (per metre).
tree_status tree_grid_crown_volume(const struct tree_grid *grid, float threshold, double *measure);

// How well the voxels above `threshold` agree with those of `other` above `other_threshold`: the shared
// volume over that of both together, 0 to 1. 0 when both are empty.
tree_status tree_grid_overlap(const struct tree_grid *grid,
                              float threshold,
                              const struct tree_grid *other,
                              float other_threshold,
                              double *measure);

// Draws `n_points` points in proportion to the density times `weight`, spread evenly: where particles
// start. `weight` may be NULL for 1 everywhere, and is handed `user`. The same `seed` gives the same points.
// `control` may be NULL; `nodes` of its limits caps the points. `points` has room for `capacity` floats,
// three for each point. `TREE_ERROR_PARAMETER` when the grid is empty.
tree_status tree_grid_draw_points(const struct tree_grid *grid,
                                  uint32_t n_points,
                                  tree_weight_fn weight,
                                  void *user,
                                  uint64_t seed,
                                  const struct tree_control *control,
                                  float *points,
                                  size_t capacity);

// Makes `stroke`, of `size` bytes, the default.
tree_status tree_density_stroke_init(struct tree_density_stroke *stroke, size_t size);

// Makes `brush`, of `size` bytes, the default.
tree_status tree_density_brush_init(struct tree_density_brush *brush, size_t size);

// A matte with strokes over it, one after the other: paints what a photograph does not show, and erases
// what is not of the tree. Parts outside the picture do nothing. The first matte stays as it is. `control`
// may be NULL; `nodes` of its limits caps the points of a stroke. Free the painted one with
// `tree_matte_free`. `TREE_ERROR_PARAMETER` names the stroke that is out of range.
tree_status tree_matte_paint(const struct tree_matte *matte,
                             const struct tree_density_stroke *strokes,
                             size_t n_strokes,
                             const struct tree_control *control,
                             struct tree_matte **painted);

// A grid with balls drawn through it, one after the other. Parts outside the grid do nothing. The first
// grid stays as it is. `control` may be NULL; `nodes` of its limits caps the points of a brush. Free the
// painted one with `tree_grid_free`. `TREE_ERROR_PARAMETER` names the brush that is out of range.
tree_status tree_grid_paint(const struct tree_grid *grid,
                            const struct tree_density_brush *brushes,
                            size_t n_brushes,
                            const struct tree_control *control,
                            struct tree_grid **painted);

// Makes `params`, of `size` bytes, the default.
tree_status tree_density_params_init(struct tree_density_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_density_params_check(const struct tree_density_params *params);

// Makes `params`, of `size` bytes, the default.
tree_status tree_field_params_init(struct tree_field_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_field_params_check(const struct tree_field_params *params);

// The share of the direction towards the branches at a distance, as a share of the picture's height.
tree_status tree_field_params_blend_at(const struct tree_field_params *params,
                                       float distance,
                                       float *measure);

// The direction field of the branches in one picture of `width` by `height` pixels, each 1 to 1e6: near a
// branch along it and towards the tree's base, elsewhere towards the branch. A graph without segments has no
// directions: the field is zero. `base_x` and `base_y` are the base in pixels, where what lies beyond the
// graph's roots is directed. `params` and `control` may be NULL. Free it with `tree_direction_field_free`.
tree_status tree_direction_field_new(const struct tree_attractor *attractor,
                                     float width,
                                     float height,
                                     float base_x,
                                     float base_y,
                                     const struct tree_field_params *params,
                                     const struct tree_control *control,
                                     struct tree_direction_field **field);

// Views a direction field. Set `columns->struct_size` first.
tree_status tree_direction_field_view(const struct tree_direction_field *field,
                                      struct tree_direction_field_columns *columns);

// The directions at `n_spots` points of the picture, two floats each in pixels, between cells by bilinear
// interpolation; outside the grid that of the nearest cell. `directions` has room for `capacity` floats, two
// for each point: x to the right, y up. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_direction_field_sample(const struct tree_direction_field *field,
                                        const float *spots,
                                        size_t n_spots,
                                        const struct tree_control *control,
                                        float *directions,
                                        size_t capacity);

// A picture of the field: one pixel for each cell; red is x and green is y, 128 for none. Free it with
// `tree_photo_free`.
tree_status tree_direction_field_picture(const struct tree_direction_field *field,
                                         struct tree_photo **picture);

// A copy of a photograph, or any other picture of the same size, with the field as arrows over it. `color` is
// `0xRRGGBBAA`. Free it with `tree_photo_free`.
tree_status tree_direction_field_draw_over(const struct tree_direction_field *field,
                                           const struct tree_photo *photo,
                                           uint32_t color,
                                           struct tree_photo **drawn);

// Frees a direction field.
tree_status tree_direction_field_free(struct tree_direction_field *field);

// The tree's branches without twigs: traces thinned, smoothed, and as thick as the pipe model has it.
// `height` is the tree's, `trunk_radius` what the pictures show of the trunk, both in metres; 0 where they
// show none. `params` may be NULL for an oak. Free the skeleton with `tree_skeleton_free`.
tree_status tree_traces_grow_wood(const struct tree_traces *traces,
                                  float height,
                                  float trunk_radius,
                                  const struct tree_finish_params *params,
                                  const struct tree_control *control,
                                  struct tree_skeleton **wood);

// Grows twigs and leaves on branches, as many as the density and `n_views` views ask for and none where
// those are empty. `height` is the tree's in metres. `params` may be NULL for an oak; the same `seed` gives
// the same tree. `control` and `report` may be NULL. Free the tree with `tree_tree_free`.
tree_status tree_skeleton_grow_crown(const struct tree_skeleton *wood,
                                     const struct tree_grid *density,
                                     const struct tree_particle_view *views,
                                     size_t n_views,
                                     float height,
                                     const struct tree_finish_params *params,
                                     uint64_t seed,
                                     const struct tree_control *control,
                                     struct tree_crown_report *report,
                                     struct tree_tree **tree);

// Makes `params`, of `size` bytes, an oak.
tree_status tree_finish_params_init(struct tree_finish_params *params, size_t size);

// Makes `params`, of `size` bytes, those of a species by its name, of `len` bytes or
// `TREE_NUL_TERMINATED`: the defaults with its twigs, and sprays of its leaves or needles. Names are
// those of `tree_foliage_preset_name`; `TREE_ERROR_UNKNOWN_NAME` lists them.
tree_status tree_finish_params_find(const char *name,
                                    size_t len,
                                    struct tree_finish_params *params,
                                    size_t size);

// As `tree_finish_params_find`, with single leaves and needles instead of sprays: far more of them.
tree_status tree_finish_params_of(const char *name,
                                  size_t len,
                                  struct tree_finish_params *params,
                                  size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_finish_params_check(const struct tree_finish_params *params);

// Makes `params`, of `size` bytes, the default.
tree_status tree_flow_params_init(struct tree_flow_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_flow_params_check(const struct tree_flow_params *params);

// Lets particles flow from `n_starts` points, three floats each in metres, to the base, along `way` and the
// fields of `n_views` views (none will do). `height` is the tree's in metres, 1e-3 to 1e5. `params`,
// `control` and `report` may be NULL; `particles` of the params does not count. The same starts give the same
// bits for any number of threads. Free the traces with `tree_traces_free`.
tree_status tree_traces_flow(const struct tree_way *way,
                             const struct tree_flow_view *views,
                             size_t n_views,
                             const float *starts,
                             size_t n_starts,
                             float height,
                             const struct tree_flow_params *params,
                             const struct tree_control *control,
                             struct tree_flow_report *report,
                             struct tree_traces **traces);

// Views traces. Set `columns->struct_size` first.
tree_status tree_traces_view(const struct tree_traces *traces, struct tree_traces_columns *columns);

// Traces as a skeleton, from the base to where the particles started, with radii of 0. Free it with
// `tree_skeleton_free`.
tree_status tree_traces_skeleton(const struct tree_traces *traces,
                                 const struct tree_control *control,
                                 struct tree_skeleton **skeleton);

// Frees traces.
tree_status tree_traces_free(struct tree_traces *traces);

// Finds the cheapest way to the origin from everywhere in `density`: it keeps to dense voxels and prefers
// the stem. `params` may be NULL; `stem` counts. Free it with `tree_way_free`.
tree_status tree_way_new(const struct tree_grid *density,
                         const struct tree_flow_params *params,
                         const struct tree_control *control,
                         struct tree_way **way);

// What the way to the base costs from the centre of each voxel: metres, more where it is not dense. Free
// the grid with `tree_grid_free`.
tree_status tree_way_costs(const struct tree_way *way,
                           struct tree_grid **grid);

// The way on from `n_points` points, three floats each in metres; outside the grid as from its nearest
// point. `directions` has room for `capacity` floats, three for each point: vectors of length 0 to 1, and 0
// for points that are not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_way_sample(const struct tree_way *way,
                            const float *points,
                            size_t n_points,
                            const struct tree_control *control,
                            float *directions,
                            size_t capacity);

// Frees a way.
tree_status tree_way_free(struct tree_way *way);

// Makes `view`, of `size` bytes, the default.
tree_status tree_flow_view_init(struct tree_flow_view *view, size_t size);

// The directions that particles take at `n_points` points, three floats each in metres, where no neighbour
// pulls: by the fields of `n_views` views (none will do) and the way to the base. `params` may be NULL.
// `directions` has room for `capacity` floats, three for each point: unit vectors, and 0 for points that are
// not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_way_directions(const struct tree_way *way,
                                const struct tree_flow_view *views,
                                size_t n_views,
                                const float *points,
                                size_t n_points,
                                const struct tree_flow_params *params,
                                const struct tree_control *control,
                                float *directions,
                                size_t capacity);

// Makes a grid with its lowest corner at `corner`, three floats, of `nx` by `ny` by `nz` voxels (1 to 4096
// each) with sides of `voxel` metres (1e-6 to 1e6). `values` are copied, in the order of
// `tree_grid_columns`; without any (`n_values` 0) all are 0. `control` may be NULL; only its limits matter.
// Free the grid with `tree_grid_free`. `TREE_ERROR_INVALID` when there are not as many values as voxels,
// `TREE_ERROR_PARAMETER` names a value that is not finite.
tree_status tree_grid_new(const float *corner,
                          float voxel,
                          uint32_t nx,
                          uint32_t ny,
                          uint32_t nz,
                          const float *values,
                          size_t n_values,
                          const struct tree_control *control,
                          struct tree_grid **grid);

// Views a grid. Set `columns->struct_size` first.
tree_status tree_grid_view(const struct tree_grid *grid, struct tree_grid_columns *columns);

// The box that the grid fills: its lower corner, then its upper one, in metres.
tree_status tree_grid_bounds(const struct tree_grid *grid, float (*min_max)[6]);

// Row of a voxel among the grid's values; `SIZE_MAX` outside.
tree_status tree_grid_index(const struct tree_grid *grid,
                            int32_t x,
                            int32_t y,
                            int32_t z,
                            size_t *index);

// The voxel that holds a point, three floats in metres; outside the grid it is none of its voxels.
tree_status tree_grid_voxel_at(const struct tree_grid *grid,
                               const float *point,
                               int32_t (*voxel)[3]);

// Looks up the grid at `n_points` points, three floats each in metres: between voxel centres by trilinear
// interpolation, fading to 0 outside. `values` has room for `capacity` numbers, at least `n_points`.
// `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_grid_sample(const struct tree_grid *grid,
                             const float *points,
                             size_t n_points,
                             const struct tree_control *control,
                             float *values,
                             size_t capacity);

// As `tree_grid_sample`, but the value of the voxel that holds each point, and 0 outside.
tree_status tree_grid_nearest(const struct tree_grid *grid,
                              const float *points,
                              size_t n_points,
                              const struct tree_control *control,
                              float *values,
                              size_t capacity);

// Frees a grid.
tree_status tree_grid_free(struct tree_grid *grid);

// Begins with `n_shots` photographs, 1 to 1000, which are copied. `params` may be NULL for the defaults.
// `control` may be NULL; only its limits matter: no work is done yet. Free the session with
// `tree_photo_session_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
// photograph that is not of its matte's size.
tree_status tree_photo_session_new(const struct tree_photo_shot *shots,
                                   size_t n_shots,
                                   const struct tree_photo_params *params,
                                   uint64_t seed,
                                   const struct tree_control *control,
                                   struct tree_photo_session **session);

// A second session in the state of the first, with all that has been made so far: to try something, and
// go back. Free it too.
tree_status tree_photo_session_copy(const struct tree_photo_session *session,
                                    struct tree_photo_session **copy);

// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
// progress callback for instance: it lives on then.
tree_status tree_photo_session_free(struct tree_photo_session *session);

// Another seed: other particles, twigs and leaves in the same density.
tree_status tree_photo_session_set_seed(struct tree_photo_session *session, uint64_t seed);

// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Painted
// density is lost when the density's parameters change. `control` may be NULL; only its limits matter.
tree_status tree_photo_session_set_params(struct tree_photo_session *session,
                                          const struct tree_photo_params *params,
                                          const struct tree_control *control);

// Moves a view's camera; NULL aligns it anew, from the front.
tree_status tree_photo_session_set_placing(struct tree_photo_session *session,
                                           size_t view,
                                           const struct tree_photo_placing *placing);

// Paints and erases density in a view, in pixels. Branches found before stay as they are. `control` may be
// NULL; `nodes` of its limits caps the points of a stroke. `TREE_ERROR_PARAMETER` names the stroke that is
// out of range.
tree_status tree_photo_session_paint(struct tree_photo_session *session,
                                     size_t view,
                                     const struct tree_density_stroke *strokes,
                                     size_t n_strokes,
                                     const struct tree_control *control);

// Replaces a view's matte by one of the same size, for instance after another matting. Camera and branches
// found before stay as they are; `tree_photo_session_redo_from` finds them anew. `TREE_ERROR_NO_RESULT` for
// another size.
tree_status tree_photo_session_set_matte(struct tree_photo_session *session,
                                         size_t view,
                                         const struct tree_matte *matte);

// Paints density in space, after it has been found from the pictures, which is done first where it is not
// there. `TREE_ERROR_PARAMETER` names the brush that is out of range.
tree_status tree_photo_session_paint_volume(struct tree_photo_session *session,
                                            const struct tree_density_brush *brushes,
                                            size_t n_brushes,
                                            const struct tree_control *control);

// Replaces the density, for instance by that of another source; it is copied.
tree_status tree_photo_session_set_density(struct tree_photo_session *session,
                                           const struct tree_grid *density);

// Where a view's branches come from; NULL is livewire from points on the silhouette. All views' branches
// are found anew. `control` may be NULL; only its limits matter.
tree_status tree_photo_session_set_branches(struct tree_photo_session *session,
                                            size_t view,
                                            const struct tree_photo_branches *branches,
                                            const struct tree_control *control);

// Changes a view's branches by hand: ask for them with `tree_photo_session_attractor`, change them with the
// functions of `tree_attractor`, and hand the new graph over here. Other views' branches are not found anew.
tree_status tree_photo_session_edit_attractor(struct tree_photo_session *session,
                                              size_t view,
                                              const struct tree_attractor *attractor,
                                              const struct tree_control *control);

// Forgets the result of a stage and of all that depend on it, so that they are done again.
tree_status tree_photo_session_redo_from(struct tree_photo_session *session,
                                         tree_photo_stage stage);

// Number of photographs.
tree_status tree_photo_session_count(const struct tree_photo_session *session, size_t *n_shots);

// Number of views: the photographs, and where all are from one side, an imagined one that comes last; see
// `imagine` of the `tree_photo_params`. Cameras, branches and fields can be asked for of all of them.
tree_status tree_photo_session_count_views(struct tree_photo_session *session,
                                           const struct tree_control *control,
                                           size_t *n_views);

// The seed.
tree_status tree_photo_session_seed(const struct tree_photo_session *session, uint64_t *seed);

// The parameters, all parts given. What they point at belongs to the session and stays until
// `tree_photo_session_set_params` or `tree_photo_session_free`. Set `params->struct_size` first.
tree_status tree_photo_session_get_params(const struct tree_photo_session *session,
                                          struct tree_photo_params *params);

// How often a stage has been done so far.
tree_status tree_photo_session_runs(const struct tree_photo_session *session,
                                    tree_photo_stage stage,
                                    uint32_t *n_runs);

// A view's matte as it is now, painted or not. Free it with `tree_matte_free`.
tree_status tree_photo_session_matte(const struct tree_photo_session *session,
                                     size_t view,
                                     struct tree_matte **matte);

// A view's photograph. Free it with `tree_photo_free`. `TREE_ERROR_NO_RESULT` for a view without one.
tree_status tree_photo_session_photo(const struct tree_photo_session *session,
                                     size_t view,
                                     struct tree_photo **photo);

// A view's camera, found in its matte or as it was given. Set `camera->struct_size` first.
// `TREE_ERROR_NO_RESULT` names a photograph in which no tree is found.
tree_status tree_photo_session_camera(struct tree_photo_session *session,
                                      size_t view,
                                      const struct tree_control *control,
                                      struct tree_particle_camera *camera);

// A view's main branches; an empty graph where there are none. Free it with `tree_attractor_free`.
tree_status tree_photo_session_attractor(struct tree_photo_session *session,
                                         size_t view,
                                         const struct tree_control *control,
                                         struct tree_attractor **attractor);

// A view's main branches as strokes, one for each segment: what `TREE_BRANCHES_STROKES` takes, to draw on
// where the library left off. Free them with `tree_strokes_free`.
tree_status tree_photo_session_strokes(struct tree_photo_session *session,
                                       size_t view,
                                       const struct tree_control *control,
                                       struct tree_strokes **strokes);

// The density in space, optical depth per metre. Free it with `tree_grid_free`.
tree_status tree_photo_session_density(struct tree_photo_session *session,
                                       const struct tree_control *control,
                                       struct tree_grid **density);

// The direction field of a view. Free it with `tree_direction_field_free`.
tree_status tree_photo_session_field(struct tree_photo_session *session,
                                     size_t view,
                                     const struct tree_control *control,
                                     struct tree_direction_field **field);

// The particles' traces. Free them with `tree_traces_free`.
tree_status tree_photo_session_traces(struct tree_photo_session *session,
                                      const struct tree_control *control,
                                      struct tree_traces **traces);

// Branches without twigs. Free the skeleton with `tree_skeleton_free`.
tree_status tree_photo_session_wood(struct tree_photo_session *session,
                                    const struct tree_control *control,
                                    struct tree_skeleton **wood);

// The tree. The same photographs, parameters and seed give the same bits for any number of threads and in
// whatever order the session was changed. `control` and `report` may be NULL. Free the tree with
// `tree_tree_free`.
tree_status tree_photo_session_tree(struct tree_photo_session *session,
                                    const struct tree_control *control,
                                    struct tree_photo_report *report,
                                    struct tree_tree **tree);

// What one view gave, an imagined one too. The tree is made first where it is not there. Set
// `report->struct_size` first.
tree_status tree_photo_session_view_report(struct tree_photo_session *session,
                                           size_t view,
                                           const struct tree_control *control,
                                           struct tree_photo_view_report *report);

// For each of a view's strokes the gap in pixels that was closed to join it; NaN where it was left out. The
// tree is made first where it is not there. `gaps` has room for `capacity` floats, one for each stroke.
// Nothing is written for a view without strokes.
tree_status tree_photo_session_gaps(struct tree_photo_session *session,
                                    size_t view,
                                    const struct tree_control *control,
                                    float *gaps,
                                    size_t capacity);

// Where the views do not agree with each other: `TREE_ALIGN_CROWN_BASE` and `TREE_ALIGN_CROWN_WIDTH`. Their
// number goes into `n_warnings`, they themselves into `warnings`, which has room for `capacity` rows; with
// NULL they are only counted. The tree is made first where it is not there.
// `tree_align_warnings_text` puts them into words.
tree_status tree_photo_session_disagreements(struct tree_photo_session *session,
                                             const struct tree_control *control,
                                             struct tree_align_warning *warnings,
                                             size_t capacity,
                                             size_t *n_warnings);

// Everything doubtful, a line each, for a person to read; none where all went well. The tree is made first
// where it is not there. Free the lines with `tree_lines_free`.
tree_status tree_photo_session_warnings(struct tree_photo_session *session,
                                        const struct tree_control *control,
                                        struct tree_lines **warnings);

// Makes `params`, of `size` bytes, the default.
tree_status tree_photo_params_init(struct tree_photo_params *params, size_t size);

// Whether all fields and parts are in order: `TREE_OK`, or the error that their use would give. `control`
// may be NULL; only its limits matter.
tree_status tree_photo_params_check(const struct tree_photo_params *params,
                                    const struct tree_control *control);

// A view's matte: white where the tree covers. Free the picture with `tree_photo_free`.
tree_status tree_photo_session_draw_matte(const struct tree_photo_session *session,
                                          size_t view,
                                          struct tree_photo **picture);

// A view's branches over its photograph, the base as a dot. Free the picture with `tree_photo_free`.
tree_status tree_photo_session_draw_attractor(struct tree_photo_session *session,
                                              size_t view,
                                              const struct tree_control *control,
                                              struct tree_photo **picture);

// A view's direction field as arrows over its matte. Free the picture with `tree_photo_free`.
tree_status tree_photo_session_draw_field(struct tree_photo_session *session,
                                          size_t view,
                                          const struct tree_control *control,
                                          struct tree_photo **picture);

// The particles' traces over a view's photograph, thicker where more went. Free the picture with
// `tree_photo_free`.
tree_status tree_photo_session_draw_traces(struct tree_photo_session *session,
                                           size_t view,
                                           const struct tree_control *control,
                                           struct tree_photo **picture);

// Horizontal slices through the density, from the base up: light where it is dense, seen from above with
// the front below. Free the picture with `tree_photo_free`.
tree_status tree_photo_session_draw_density(struct tree_photo_session *session,
                                            const struct tree_control *control,
                                            struct tree_photo **picture);

// Makes `placing`, of `size` bytes, the default: aligned, from the front, from afar.
tree_status tree_photo_placing_init(struct tree_photo_placing *placing, size_t size);

// Makes `branches`, of `size` bytes, the default.
tree_status tree_photo_branches_init(struct tree_photo_branches *branches, size_t size);

// Makes `shot`, of `size` bytes, the default.
tree_status tree_photo_shot_init(struct tree_photo_shot *shot, size_t size);

// Makes a tree of `n_shots` photographs, 1 to 1000: a session (`tree_photo_session`) that is asked for its
// tree, in one call. `params` may be NULL for the defaults, `control` and `report` may be NULL. Free the tree
// with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
// photograph of no use; `TREE_ERROR_LIMIT` comes before the memory is asked for.
tree_status tree_from_photos(const struct tree_photo_shot *shots,
                             size_t n_shots,
                             const struct tree_photo_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             struct tree_photo_report *report,
                             struct tree_tree **tree);

// Makes `view`, of `size` bytes, the default.
tree_status tree_particle_view_init(struct tree_particle_view *view, size_t size);

// Joins nodes that are nearer than a linking distance by edges of random cost. `params` and `control` may
// be NULL. The same `seed` gives the same graph. Free it with `tree_graph_free`.
tree_status tree_graph_link(const struct tree_graph_nodes *nodes,
                            const struct tree_link_params *params,
                            uint64_t seed,
                            const struct tree_control *control,
                            struct tree_graph **graph);

// Makes a graph from elsewhere: `positions` is `n_nodes` times three floats, `edges` is `n_edges` times
// the two nodes that it joins, `costs` a finite cost of 0 or more for each edge. `control` may be NULL;
// only its limits matter. Free the graph with `tree_graph_free`.
tree_status tree_graph_from_edges(const float *positions,
                                  size_t n_nodes,
                                  const uint32_t *edges,
                                  const float *costs,
                                  size_t n_edges,
                                  const struct tree_control *control,
                                  struct tree_graph **graph);

// Views a graph. Set `columns->struct_size` first.
tree_status tree_graph_view(const struct tree_graph *graph, struct tree_graph_columns *columns);

// Finds the least-cost paths from `root` to all nodes. `costs`, NULL or with room for `capacity` floats,
// gets for each node what the path to it costs, infinity where there is none; `predecessors`, NULL or with
// room for `capacity` numbers, gets the node before it on that path, or `TREE_NO_NODE`. `capacity` must
// reach for all nodes. A root that does not exist reaches nothing. `control` may be NULL.
tree_status tree_graph_search(const struct tree_graph *graph,
                              uint32_t root,
                              const struct tree_control *control,
                              float *costs,
                              uint32_t *predecessors,
                              size_t capacity);

// Frees a graph.
tree_status tree_graph_free(struct tree_graph *graph);

// Grows a tree of least-cost paths. The same parameters and `seed` give the same bits for any number of
// threads. `params` may be NULL for an oak, `control` and `report` may be NULL. Free the tree with
// `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` says why
// nothing grows, for instance a root outside the volume; `TREE_ERROR_LIMIT` comes before the level that
// would exceed a limit.
tree_status tree_path_grow(const struct tree_path_params *params,
                           uint64_t seed,
                           const struct tree_control *control,
                           struct tree_path_report *report,
                           struct tree_tree **tree);

// As `tree_path_grow`, and hands out the level at which each node of the skeleton was grown: a byte for
// each node, from 1 for the base volume, 0 for nodes of the root system. Free it with `tree_bytes_free`.
tree_status tree_path_grow_with_levels(const struct tree_path_params *params,
                                       uint64_t seed,
                                       const struct tree_control *control,
                                       struct tree_path_report *report,
                                       struct tree_bytes **node_levels,
                                       struct tree_tree **tree);

// Makes `level`, of `size` bytes, the default.
tree_status tree_path_level_init(struct tree_path_level *level, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_strew_params_init(struct tree_strew_params *params, size_t size);

// Strews nodes evenly in a bounded volume, none closer than a separation that follows from their number.
// `params` and `control` may be NULL. The same `seed` gives the same nodes. Free them with
// `tree_graph_nodes_free`. `TREE_ERROR_NO_RESULT` when the volume has no end or no inside.
tree_status tree_graph_strew(const struct tree_volume *volume,
                             const struct tree_strew_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             struct tree_graph_nodes **nodes);

// Views strewn nodes. Set `columns->struct_size` first.
tree_status tree_graph_nodes_view(const struct tree_graph_nodes *nodes,
                                  struct tree_graph_nodes_columns *columns);

// Frees strewn nodes. Graphs made of them live on.
tree_status tree_graph_nodes_free(struct tree_graph_nodes *nodes);

// Makes `params`, of `size` bytes, an oak: a good tree to begin with.
tree_status tree_path_params_init(struct tree_path_params *params, size_t size);

// Checks that all parameters lie in their ranges, as `tree_path_grow` does first. `params` may be NULL for
// an oak; `control` may be NULL, only its limits matter.
tree_status tree_path_params_check(const struct tree_path_params *params,
                                   const struct tree_control *control);

// Radius in metres of the subgraphs of `params->levels[index]`: its own, or the one that follows from
// `size` and `shrink`. `params` may be NULL for an oak.
tree_status tree_path_level_radius(const struct tree_path_params *params,
                                   size_t index,
                                   float *radius);

// Number of presets: an oak, the twelve trees of Xu and Mould (2012), and two root systems.
size_t tree_path_preset_count(void);

// Name of a preset, such as `oak`, and what the tree looks like, in a few words. `index` is below
// `tree_path_preset_count`; `title` may be NULL. Both texts are valid for ever.
tree_status tree_path_preset_name(size_t index, struct tree_str *name, struct tree_str *title);

// Seconds that the tree took the authors of the method, in 2012; 0 where it is none of theirs. `index` is
// below `tree_path_preset_count`.
tree_status tree_path_preset_paper_seconds(size_t index,
                                           float *seconds);

// Makes `params`, of `size` bytes, the preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). What
// it points at belongs to the library and lives for ever. `TREE_ERROR_UNKNOWN_NAME` lists the names there
// are.
tree_status tree_path_preset(const char *name,
                             size_t len,
                             struct tree_path_params *params,
                             size_t size);

// Makes `options`, of `size` bytes, the default.
tree_status tree_profile_options_init(struct tree_profile_options *options, size_t size);

// Reads a profile from an SVG drawing, `svg` of `len` bytes or `TREE_NUL_TERMINATED`. A closed shape is
// the outline of a tree: at every height half of its width becomes the radius. An open curve is a
// profile: its distance from the axis becomes the radius; the axis is an element whose id is `axis`, or
// else the vertical through the curve's leftmost point. `options` and `control` may be NULL. Free the
// profile with `tree_profile_free`. `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing to use.
tree_status tree_profile_from_svg(const char *svg,
                                  size_t len,
                                  const struct tree_profile_options *options,
                                  const struct tree_control *control,
                                  struct tree_profile **profile);

// Views a profile. Set `columns->struct_size` first.
tree_status tree_profile_view(const struct tree_profile *profile,
                              struct tree_profile_columns *columns);

// The solid of revolution of a profile round a vertical axis through `base`, three floats. Free it with
// `tree_volume_free`.
tree_status tree_profile_volume(const struct tree_profile *profile,
                                const float *base,
                                struct tree_volume **volume);

// Frees a profile.
tree_status tree_profile_free(struct tree_profile *profile);

// As `tree_profile_from_svg` and `tree_profile_volume` in one.
tree_status tree_volume_from_svg(const char *svg,
                                 size_t len,
                                 const struct tree_profile_options *options,
                                 const float *base,
                                 const struct tree_control *control,
                                 struct tree_volume **volume);

// Makes `paint`, of `size` bytes, the default.
tree_status tree_paint_init(struct tree_paint *paint, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_link_params_init(struct tree_link_params *params, size_t size);

// Whether the segment from `a` to `b`, three floats each, stays outside `obstacle` by at least
// `clearance` metres, 0 or more: 1 or 0. Where both are the same it is asked of the one point.
tree_status tree_obstacle_is_free(const struct tree_volume *obstacle,
                                  float clearance,
                                  const float *a,
                                  const float *b,
                                  uint32_t *is_free);

// Makes `params`, of `size` bytes, the default.
tree_status tree_align_params_init(struct tree_align_params *params, size_t size);

// Warnings as lines of text, one for each of `n_warnings`. Free them with `tree_lines_free`.
tree_status tree_align_warnings_text(const struct tree_align_warning *warnings,
                                     size_t n_warnings,
                                     struct tree_lines **lines);

// Finds the tree's base and top in a matte, and so its camera: a first arrangement, which says where it may
// be wrong; a camera written by hand does as well. `params`, `control` and `report` may be NULL; set
// `camera->struct_size` first. `TREE_ERROR_NO_RESULT` when nothing or everything is covered, the tree is
// less than two rows high, or a camera of this pitch and field of view cannot see a tree so.
tree_status tree_align(const struct tree_matte *matte,
                       const struct tree_align_params *params,
                       const struct tree_control *control,
                       struct tree_particle_camera *camera,
                       struct tree_align_report *report);

// Several views of one tree, made consistent: each gets the scale that makes its tree `height` metres high,
// 0.01 to 1000, so that tops and bases coincide. `mattes` and `params` have one for each of `n_views`, 1 to
// 1000; the heights in `params` are not used. `control` may be NULL. Free the result with
// `tree_aligned_free`. Errors as for `tree_align`; the text names the view.
tree_status tree_align_all(const struct tree_matte *const *mattes,
                           const struct tree_align_params *params,
                           size_t n_views,
                           float height,
                           const struct tree_control *control,
                           struct tree_aligned **aligned);

// The number of views.
tree_status tree_aligned_count(const struct tree_aligned *aligned, size_t *n_views);

// The camera of one view, and what was found there. `report` may be NULL; set `camera->struct_size` first.
// `TREE_ERROR_PARAMETER` for an index that names no view.
tree_status tree_aligned_camera(const struct tree_aligned *aligned,
                                size_t index,
                                struct tree_particle_camera *camera,
                                struct tree_align_report *report);

// Views what disagrees between the views: where the warnings begin and how many there are.
// `tree_align_warnings_text` puts them into words.
tree_status tree_aligned_warnings(const struct tree_aligned *aligned,
                                  const struct tree_align_warning **warnings,
                                  size_t *n_warnings);

// Frees cameras of views.
tree_status tree_aligned_free(struct tree_aligned *aligned);

// Makes a graph of columns, which are copied. `control` may be NULL; `nodes` of its limits counts. Free
// the graph with `tree_attractor_free`. `TREE_ERROR_INVALID` where a parent does not come before its node.
tree_status tree_attractor_from_columns(const struct tree_attractor_columns *columns,
                                        const struct tree_control *control,
                                        struct tree_attractor **attractor);

// Views the columns of a graph. Set `columns->struct_size` first.
tree_status tree_attractor_view(const struct tree_attractor *attractor,
                                struct tree_attractor_columns *columns);

// The point of a graph nearest to `at_pixel`, two floats in pixels from the top left. Set
// `nearest->struct_size` first; `nearest->found` says whether there is one.
tree_status tree_attractor_nearest(const struct tree_attractor *attractor,
                                   const float *at_pixel,
                                   struct tree_attractor_nearest_point *nearest);

// Length of all segments together, in pixels.
tree_status tree_attractor_length(const struct tree_attractor *attractor, float *length);

// The nodes that none leads to, roots without children included. Free them with `tree_rows_free`.
tree_status tree_attractor_tips(const struct tree_attractor *attractor, struct tree_rows **tips);

// The graph drawn over a photograph or any other picture of the same size, with lines of `width` pixels
// in a colour `0xRRGGBBAA`. Free the new photograph with `tree_photo_free`.
tree_status tree_attractor_draw(const struct tree_attractor *attractor,
                                const struct tree_photo *photo,
                                float width,
                                uint32_t rgba,
                                struct tree_photo **drawn);

// Frees a graph. What was made of it lives on.
tree_status tree_attractor_free(struct tree_attractor *attractor);

// Makes `params`, of `size` bytes, the default.
tree_status tree_automatic_params_init(struct tree_automatic_params *params, size_t size);

// The matte of a photograph of a tree against sky; of one with alpha, its alpha. `params`, `control` and
// `report` may be NULL. `trimap`, which may be NULL, gets the trimap that was made, at a size of its own: to
// look at, or to draw over and hand to `tree_matte_natural`. It gets NULL where the photograph has alpha.
// `warnings`, which may be NULL, gets lines on what the result may suffer from. Free them with
// `tree_lines_free`, the trimap with `tree_trimap_free` and the matte with `tree_matte_free`.
// `TREE_ERROR_NO_RESULT` when no sky or nothing that could be a tree is found.
tree_status tree_matte_automatic(const struct tree_photo *photo,
                                 const struct tree_automatic_params *params,
                                 const struct tree_control *control,
                                 struct tree_automatic_report *report,
                                 struct tree_trimap **trimap,
                                 struct tree_lines **warnings,
                                 struct tree_matte **matte);

// Makes `camera`, of `size` bytes, the default.
tree_status tree_particle_camera_init(struct tree_particle_camera *camera, size_t size);

// Checks all numbers of a camera: `TREE_ERROR_PARAMETER` names the one out of range.
tree_status tree_particle_camera_check(const struct tree_particle_camera *camera);

// The directions of a camera in the world, as unit vectors: `right` in the picture, always horizontal,
// `up` in it, and `forward` into it.
tree_status tree_particle_camera_frame(const struct tree_particle_camera *camera,
                                       float (*right)[3],
                                       float (*up)[3],
                                       float (*forward)[3]);

// A copy of a photograph with `n_marks` marks drawn over it, in their order. `control` may be NULL;
// `nodes` of its limits caps the marks. Free the new photograph with `tree_photo_free`.
tree_status tree_photo_draw(const struct tree_photo *photo,
                            const struct tree_mark *marks,
                            size_t n_marks,
                            const struct tree_control *control,
                            struct tree_photo **drawn);

// A photograph of one colour all over, `0xRRGGBBAA`, to draw on. `control` may be NULL; only its limits
// matter. Free the photograph with `tree_photo_free`.
tree_status tree_photo_blank(uint32_t width,
                             uint32_t height,
                             uint32_t rgba,
                             const struct tree_control *control,
                             struct tree_photo **photo);

// A matte in grey, white where the tree covers, to draw on. Free the photograph with `tree_photo_free`.
tree_status tree_photo_of_matte(const struct tree_matte *matte,
                                struct tree_photo **photo);

// A new graph with one more stroke of `n_points` points, two floats each in pixels, joined where it is
// nearest. On an empty graph the stroke's lowest point becomes the root. `params`, `control` and `report`
// may be NULL. `gap`, which may be NULL, gets the gap in pixels that was closed; NaN where the stroke was left
// out. Free the new graph with `tree_attractor_free`.
tree_status tree_attractor_add_stroke(const struct tree_attractor *attractor,
                                      const float *stroke,
                                      size_t n_points,
                                      const struct tree_stroke_params *params,
                                      const struct tree_control *control,
                                      struct tree_stroke_report *report,
                                      float *gap,
                                      struct tree_attractor **changed);

// A new graph without the segments that come within `radius` pixels (0 to 1e9) of an eraser's path of
// `n_points` points, two floats each in pixels; one point is a dab. Points that are not finite are left
// out. Roots stay. `cut_off` is a `TREE_CUT_OFF_` constant; `report` may be NULL. Free the new graph with
// `tree_attractor_free`.
tree_status tree_attractor_erase(const struct tree_attractor *attractor,
                                 const float *eraser,
                                 size_t n_points,
                                 float radius,
                                 tree_cut_off cut_off,
                                 struct tree_erase_report *report,
                                 struct tree_attractor **changed);

// A new graph with everything within `radius` pixels (0 to 1e9) of `at_pixel` moved by `by_pixels`, less the
// farther it is; both are two floats. Roots stay where they are. Free the new graph with
// `tree_attractor_free`.
tree_status tree_attractor_move_near(const struct tree_attractor *attractor,
                                     const float *at_pixel,
                                     const float *by_pixels,
                                     float radius,
                                     struct tree_attractor **changed);

// A new graph with left and right exchanged, in a picture `width` pixels wide. Free it with
// `tree_attractor_free`. `TREE_ERROR_PARAMETER` for a width with which nodes would not be finite.
tree_status tree_attractor_mirrored(const struct tree_attractor *attractor,
                                    float width,
                                    struct tree_attractor **changed);

// Views the lines: where they begin and how many there are. Valid until `tree_lines_free`.
tree_status tree_lines_view(const struct tree_lines *lines,
                            const struct tree_str **texts,
                            size_t *n_texts);

// Frees lines of text.
tree_status tree_lines_free(struct tree_lines *lines);

// Makes `params`, of `size` bytes, the default.
tree_status tree_livewire_params_init(struct tree_livewire_params *params, size_t size);

// Finds paths from every seed to the base through what a photograph and its matte show, and joins them:
// main branches as least-cost paths. `photo` may be NULL: then the matte alone is looked at. `base_pixel`
// is two floats, `seeds` two floats each, in pixels from the top left: those of `tree_matte_seeds`, or
// what a person clicked on. The root of the graph is at the base, its tips are at the seeds; without seeds the
// graph is the base alone. `params`, `control` and `report` may be NULL. Free the graph with
// `tree_attractor_free`. `TREE_ERROR_NO_RESULT` where the matte is empty, or the photograph is of another
// size.
tree_status tree_attractor_livewire(const struct tree_matte *matte,
                                    const struct tree_photo *photo,
                                    const float *base_pixel,
                                    const float *seeds,
                                    size_t n_seeds,
                                    const struct tree_livewire_params *params,
                                    const struct tree_control *control,
                                    struct tree_livewire_report *report,
                                    struct tree_attractor **attractor);

// Makes `params`, of `size` bytes, the default.
tree_status tree_seed_params_init(struct tree_seed_params *params, size_t size);

// Up to `most` points (100,000 at most) on the silhouette of the crown, evenly spread, other ones for every
// `seed`: two floats each in pixels into `seeds`, and their number into `n_seeds`. `capacity`, in floats,
// must be twice the number found or more: `2 * most` is enough. `base_pixel`, two floats, is the tree's base.
// `params` and `control` may be NULL. `TREE_ERROR_NO_RESULT` where the matte is empty.
tree_status tree_matte_seeds(const struct tree_matte *matte,
                             const float *base_pixel,
                             uint32_t most,
                             const struct tree_seed_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             float *seeds,
                             size_t capacity,
                             size_t *n_seeds);

// Makes a matte of `width * height` floats, which are copied, rows from top to bottom; clamped to 0 to 1,
// not NaN. `control` may be NULL; only its limits matter. Free the matte with `tree_matte_free`.
tree_status tree_matte_from_alpha(uint32_t width,
                                  uint32_t height,
                                  const float *alpha,
                                  size_t n_pixels,
                                  const struct tree_control *control,
                                  struct tree_matte **matte);

// The alpha of a photograph as a matte. Free it with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where all
// pixels are opaque or all transparent.
tree_status tree_matte_of_photo(const struct tree_photo *photo,
                                struct tree_matte **matte);

// Views a matte. Set `columns->struct_size` first.
tree_status tree_matte_view(const struct tree_matte *matte, struct tree_matte_columns *columns);

// Writes the values at `n_spots` points of a matte, two floats each in pixels from the top left, between
// pixel centres by bilinear interpolation; 0 outside. `capacity` must be `n_spots` or more. `control` may
// be NULL; `nodes` of its limits caps the points.
tree_status tree_matte_sample(const struct tree_matte *matte,
                              const float *spots,
                              size_t n_spots,
                              const struct tree_control *control,
                              float *values,
                              size_t capacity);

// A matte with left and right exchanged. Free it with `tree_matte_free`.
tree_status tree_matte_mirrored(const struct tree_matte *matte, struct tree_matte **mirrored);

// A view mirrored and a quarter turn round: what a tree may look like from its side, where there is one
// photograph only. `photo` may be NULL, and `turned_photo` too, which gets NULL without a photograph. Set
// `turned_camera->struct_size` first. Free what comes out with `tree_photo_free` and `tree_matte_free`.
tree_status tree_matte_turned(const struct tree_matte *matte,
                              const struct tree_photo *photo,
                              const struct tree_particle_camera *camera,
                              struct tree_particle_camera *turned_camera,
                              struct tree_photo **turned_photo,
                              struct tree_matte **turned);

// A matte as a PNG file in memory: grey, black for 0 and white for 1. Free it with `tree_bytes_free`.
tree_status tree_matte_to_png(const struct tree_matte *matte,
                              struct tree_bytes **bytes);

// Writes a matte to a PNG file, as `tree_matte_to_png`, whole or not at all. The path, in UTF-8, has
// `path_len` bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
tree_status tree_matte_write_png(const struct tree_matte *matte,
                                 const char *path,
                                 size_t path_len);

// Frees a matte. What was made of it lives on.
tree_status tree_matte_free(struct tree_matte *matte);

// Makes `params`, of `size` bytes, the default.
tree_status tree_natural_params_init(struct tree_natural_params *params, size_t size);

// The matte of a photograph of which a trimap is known, by closed-form matting. A trimap of another size is
// sampled when its proportions agree within 2 %. Known pixels keep their alpha; an alpha channel of the
// photograph is ignored. `params`, `control` and `report` may be NULL. `warnings`, which may be NULL, gets
// lines on what the result may suffer from; free them with `tree_lines_free`, and the matte with
// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the trimap does not fit, or knows no tree or no background.
tree_status tree_matte_natural(const struct tree_photo *photo,
                               const struct tree_trimap *trimap,
                               const struct tree_natural_params *params,
                               const struct tree_control *control,
                               struct tree_natural_report *report,
                               struct tree_lines **warnings,
                               struct tree_matte **matte);

// Makes `params`, of `size` bytes, the default.
tree_status tree_screen_params_init(struct tree_screen_params *params, size_t size);

// The matte of a photograph taken before a blue or green screen. Its own alpha is ignored. `params` and
// `control` may be NULL. Free the matte with `tree_matte_free`.
tree_status tree_matte_screen(const struct tree_photo *photo,
                              const struct tree_screen_params *params,
                              const struct tree_control *control,
                              struct tree_matte **matte);

// Makes `params`, of `size` bytes, the default.
tree_status tree_difference_params_init(struct tree_difference_params *params, size_t size);

// The matte of a photograph of which `plate` shows the same view without the tree: the tree is where both
// differ. Their own alpha is ignored. `params` and `control` may be NULL. Free the matte with
// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the photographs differ in size.
tree_status tree_matte_difference(const struct tree_photo *photo,
                                  const struct tree_photo *plate,
                                  const struct tree_difference_params *params,
                                  const struct tree_control *control,
                                  struct tree_matte **matte);

// Makes a photograph of `4 * width * height` bytes of a program's own, which are copied: red, green, blue
// and alpha for each pixel, rows from top to bottom. `control` may be NULL; only its limits matter. Free
// the photograph with `tree_photo_free`.
tree_status tree_photo_from_pixels(uint32_t width,
                                   uint32_t height,
                                   const uint8_t *pixels,
                                   size_t n_bytes,
                                   const struct tree_control *control,
                                   struct tree_photo **photo);

// Reads a PNG or JPEG file, recognised by its content. A photograph is turned upright as its camera noted.
// `control` may be NULL; `input_bytes` and `pixels` of its limits are looked at before the picture is
// decoded. Free the photograph with `tree_photo_free`. `TREE_ERROR_FORMAT` for what is no such picture.
tree_status tree_photo_read(const char *path,
                            size_t path_len,
                            const struct tree_control *control,
                            struct tree_photo **photo);

// As `tree_photo_read`, of a file held in memory: `len` bytes from `data` on, which are not kept.
tree_status tree_photo_from_bytes(const uint8_t *data,
                                  size_t len,
                                  const struct tree_control *control,
                                  struct tree_photo **photo);

// Views a photograph's pixels, and says how large it is. Set `pixels->struct_size` first.
tree_status tree_photo_view(const struct tree_photo *photo, struct tree_pixels *pixels);

// Whether any pixel is not fully opaque: 1 or 0.
tree_status tree_photo_has_alpha(const struct tree_photo *photo, uint32_t *is_translucent);

// A photograph with left and right exchanged. Free it with `tree_photo_free`.
tree_status tree_photo_mirrored(const struct tree_photo *photo, struct tree_photo **mirrored);

// A photograph as a PNG file in memory, with alpha. Free it with `tree_bytes_free`.
tree_status tree_photo_to_png(const struct tree_photo *photo, struct tree_bytes **bytes);

// Writes a photograph to a PNG file, with alpha, whole or not at all. The path, in UTF-8, has `path_len`
// bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
tree_status tree_photo_write_png(const struct tree_photo *photo,
                                 const char *path,
                                 size_t path_len);

// Frees a photograph. What was made of it lives on.
tree_status tree_photo_free(struct tree_photo *photo);

// Writes the pixels that `n_points` points of the world fall on, of three floats each in metres: two floats
// for each, in pixels from the top left; NaN behind the camera or beside it. `capacity`, in floats, must be
// `2 * n_points` or more. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_particle_camera_project(const struct tree_particle_camera *camera,
                                         const float *points,
                                         size_t n_points,
                                         const struct tree_control *control,
                                         float *spots,
                                         size_t capacity);

// Writes for each of `n_points` points of the world, three floats each in metres, how many metres a pixel
// is at its depth. `capacity` must be `n_points` or more. `control` as for `tree_particle_camera_project`.
tree_status tree_particle_camera_pixel_sizes(const struct tree_particle_camera *camera,
                                             const float *points,
                                             size_t n_points,
                                             const struct tree_control *control,
                                             float *sizes,
                                             size_t capacity);

// Writes the rays through `n_spots` points of the picture, two floats each in pixels from the top left: six
// floats for each, a point on it in metres and its unit direction. In perspective the point is where the
// camera stands, in parallel projection it lies on the plane through the base. `capacity`, in floats, must
// be `6 * n_spots` or more. `control` as for `tree_particle_camera_project`.
tree_status tree_particle_camera_rays(const struct tree_particle_camera *camera,
                                      const float *spots,
                                      size_t n_spots,
                                      const struct tree_control *control,
                                      float *rays,
                                      size_t capacity);

// The camera for a renderer, to draw the tree as the photograph shows it. Set `stand->struct_size` first.
tree_status tree_particle_camera_stand(const struct tree_particle_camera *camera,
                                       struct tree_particle_stand *stand);

// The same as a view for `tree_render` and `tree_render_mask`: of the photograph's size, with the camera
// placed; everything else is the default. Set `view->struct_size` first.
tree_status tree_particle_camera_view(const struct tree_particle_camera *camera,
                                      struct tree_view *view);

// Makes `params`, of `size` bytes, the default.
tree_status tree_stroke_params_init(struct tree_stroke_params *params, size_t size);

// Makes a graph of strokes that a person drew, whose root is at `base_pixel`, two floats. `params`,
// `control` and `report` may be NULL; `nodes` of the limits caps the points. `gaps`, which may be NULL, gets
// for each stroke the gap in pixels that was closed, NaN where the stroke was left out; `capacity` must be the
// number of strokes or more. Free the graph with `tree_attractor_free`.
tree_status tree_attractor_from_strokes(const struct tree_strokes_columns *columns,
                                        const float *base_pixel,
                                        const struct tree_stroke_params *params,
                                        const struct tree_control *control,
                                        struct tree_stroke_report *report,
                                        float *gaps,
                                        size_t capacity,
                                        struct tree_attractor **attractor);

// Reads the strokes of an SVG drawing made over a picture of `width` x `height` pixels, 1 to 1e6 each: `svg`
// of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line and polyline with its transforms is one, a
// closed shape is a loop. The drawing's view box (or its width and height) is stretched to the picture;
// without either its units are pixels. `control` may be NULL. Free the strokes with `tree_strokes_free`.
// `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing.
tree_status tree_strokes_from_svg(const char *svg,
                                  size_t len,
                                  float width,
                                  float height,
                                  const struct tree_control *control,
                                  struct tree_strokes **strokes);

// Views strokes, as `tree_attractor_from_strokes` takes them. Set `columns->struct_size` first.
tree_status tree_strokes_view(const struct tree_strokes *strokes,
                              struct tree_strokes_columns *columns);

// Frees strokes.
tree_status tree_strokes_free(struct tree_strokes *strokes);

// Makes a trimap of `width * height` bytes, each a `TREE_LEVEL_` constant, rows from top to bottom.
// `control` may be NULL; only its limits matter. Free the trimap with `tree_trimap_free`.
tree_status tree_trimap_from_levels(uint32_t width,
                                    uint32_t height,
                                    const uint8_t *levels,
                                    size_t n_pixels,
                                    const struct tree_control *control,
                                    struct tree_trimap **trimap);

// Reads a drawn trimap: black is background, white the tree, grey (and transparent) unknown. Free the
// trimap with `tree_trimap_free`.
tree_status tree_trimap_of_photo(const struct tree_photo *photo,
                                 struct tree_trimap **trimap);

// Makes `stroke`, of `size` bytes, the default: one without points.
tree_status tree_trimap_stroke_init(struct tree_trimap_stroke *stroke, size_t size);

// Paints `n_strokes` strokes, in their order, over a trimap of `width` x `height` pixels of which nothing is
// known. `control` may be NULL; `pixels` of its limits caps the trimap, `nodes` the points of a stroke. Free
// the trimap with `tree_trimap_free`.
tree_status tree_trimap_from_strokes(uint32_t width,
                                     uint32_t height,
                                     const struct tree_trimap_stroke *strokes,
                                     size_t n_strokes,
                                     const struct tree_control *control,
                                     struct tree_trimap **trimap);

// Makes `samples`, of `size` bytes, the default: no colours.
tree_status tree_color_samples_init(struct tree_color_samples *samples, size_t size);

// Marks the pixels of a photograph that look like one of the sampled colours; where both sides do, the
// nearer sample decides. `control` may be NULL; `nodes` of its limits caps the samples. Free the trimap
// with `tree_trimap_free`. `TREE_ERROR_INVALID` when either side has no sample.
tree_status tree_trimap_from_colors(const struct tree_photo *photo,
                                    const struct tree_color_samples *samples,
                                    const struct tree_control *control,
                                    struct tree_trimap **trimap);

// Views a trimap. Set `columns->struct_size` first.
tree_status tree_trimap_view(const struct tree_trimap *trimap, struct tree_trimap_columns *columns);

// Frees a trimap.
tree_status tree_trimap_free(struct tree_trimap *trimap);

// A tree of a scene as of the last update. In the surroundings that it grew in it is the input, bit for bit. `control` and
// `report` may be NULL. Free it with `tree_adapted_free`. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_adapted(const struct tree_plastic_scene *scene,
                                       uint64_t id,
                                       const struct tree_control *control,
                                       struct tree_adapted_report *report,
                                       struct tree_adapted **adapted);

// The tree, in its own frame, not copied: `tree_plastic_scene_pose` says where it stands. Free it with `tree_tree_free`; it
// may outlive what it was asked of.
tree_status tree_adapted_tree(const struct tree_adapted *adapted,
                              struct tree_tree **tree);

// Views what became of the input's nodes. Set `columns->struct_size` first.
tree_status tree_adapted_view(const struct tree_adapted *adapted,
                              struct tree_adapted_columns *columns);

// Frees an adapted tree. Trees handed out live on.
tree_status tree_adapted_free(struct tree_adapted *adapted);

// Analyses a tree, which should have grown alone in the open, and is copied. `params`, `control` and `report` may be
// NULL; see `already_bent` of the report. A few milliseconds for ten thousand nodes; the time grows with the square of
// the number of leaf clusters. Free it with `tree_plastic_free`.
tree_status tree_plastic_new(const struct tree_tree *tree,
                             const struct tree_plastic_params *params,
                             const struct tree_control *control,
                             struct tree_plastic_report *report,
                             struct tree_plastic **plastic);

// What was found in the tree. Set `report->struct_size` first.
tree_status tree_plastic_measure(const struct tree_plastic *plastic,
                                 struct tree_plastic_report *report);

// How the tree was analysed. Set `params->struct_size` first.
tree_status tree_plastic_get_params(const struct tree_plastic *plastic,
                                    struct tree_plastic_params *params);

// A copy of the tree as it came in. Free it with `tree_tree_free`.
tree_status tree_plastic_tree(const struct tree_plastic *plastic, struct tree_tree **tree);

// Views what is known of each node. Set `columns->struct_size` first.
tree_status tree_plastic_view(const struct tree_plastic *plastic,
                              struct tree_plastic_columns *columns);

// Frees a tree that can react. Scenes in which it is planted go on.
tree_status tree_plastic_free(struct tree_plastic *plastic);

// The leaf clusters that a tree had in a season of its life in the open. `season` is below
// `tree_plastic_report.n_seasons`. Free them with `tree_plastic_clusters_free`.
tree_status tree_plastic_clusters_of_season(const struct tree_plastic *plastic,
                                            uint32_t season,
                                            struct tree_plastic_clusters **clusters);

// The leaf clusters of a tree of a scene today, as of the last update; those that are gone are left out. Free them with
// `tree_plastic_clusters_free`. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_clusters(const struct tree_plastic_scene *scene,
                                        uint64_t id,
                                        struct tree_plastic_clusters **clusters);

// Views clusters: where the rows begin and how many there are.
tree_status tree_plastic_clusters_view(const struct tree_plastic_clusters *clusters,
                                       const struct tree_plastic_cluster **rows,
                                       size_t *n_rows);

// Frees clusters.
tree_status tree_plastic_clusters_free(struct tree_plastic_clusters *clusters);

// Plants a tree; the analysis is shared, not copied. `pose` may be NULL for the origin, not turned. `TREE_ERROR_INVALID`
// for a pose that is not finite, and where its base lies in an obstacle.
tree_status tree_plastic_scene_add_tree(struct tree_plastic_scene *scene,
                                        const struct tree_plastic *plastic,
                                        const struct tree_pose *pose,
                                        uint64_t *id);

// Moves a tree. Errors are those of `tree_plastic_scene_add_tree`, and `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_move_tree(struct tree_plastic_scene *scene,
                                         uint64_t id,
                                         const struct tree_pose *pose);

// Takes a tree away. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_remove_tree(struct tree_plastic_scene *scene, uint64_t id);

// Puts an obstacle into the scene; `volume` may be freed. Spheres, boxes and half-spaces, moved, turned and united, cast
// their exact shadow; any other volume, closed meshes too, that of boxes a sixteenth of its size. It is prepared once:
// moving it is cheap. `pose` may be NULL for the origin, not turned. `TREE_ERROR_INVALID` for a pose that is not finite, a
// volume that has no end and is no half-space (nor a union with them), and where it would hold the base of a tree.
tree_status tree_plastic_scene_add_obstacle(struct tree_plastic_scene *scene,
                                            const struct tree_volume *volume,
                                            const struct tree_pose *pose,
                                            uint64_t *id);

// Moves an obstacle. Errors are those of `tree_plastic_scene_add_obstacle`, and `TREE_ERROR_INVALID` for an id that is not
// there.
tree_status tree_plastic_scene_move_obstacle(struct tree_plastic_scene *scene,
                                             uint64_t id,
                                             const struct tree_pose *pose);

// Takes an obstacle away. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_remove_obstacle(struct tree_plastic_scene *scene, uint64_t id);

// Writes for each node of the input of tree `id` how it stands as of the last update: the skin of a mesh of the input follows it.
// Branchlets follow their main branch. `motions` has room for `capacity` rows, at least one for each node.
// `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_motions(const struct tree_plastic_scene *scene,
                                       uint64_t id,
                                       struct tree_plastic_motion *motions,
                                       size_t capacity);

// Makes `params`, of `size` bytes, the default.
tree_status tree_plastic_params_init(struct tree_plastic_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_plastic_params_check(const struct tree_plastic_params *params);

// The sky. Set `sky->struct_size` first.
tree_status tree_plastic_scene_get_sky(const struct tree_plastic_scene *scene,
                                       struct tree_plastic_sky *sky);

// How much trees react. Set `response->struct_size` first.
tree_status tree_plastic_scene_get_response(const struct tree_plastic_scene *scene,
                                            struct tree_plastic_response *response);

// The trees' ids, in the order they were planted. Valid until the next edit.
tree_status tree_plastic_scene_trees(const struct tree_plastic_scene *scene,
                                     const uint64_t **ids,
                                     size_t *n_ids);

// The obstacles' ids, in the order they were put there. Valid until the next edit.
tree_status tree_plastic_scene_obstacles(const struct tree_plastic_scene *scene,
                                         const uint64_t **ids,
                                         size_t *n_ids);

// Ids of the trees that the last update changed. Valid until the next update.
tree_status tree_plastic_scene_changed(const struct tree_plastic_scene *scene,
                                       const uint64_t **ids,
                                       size_t *n_ids);

// Where a tree stands. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_pose(const struct tree_plastic_scene *scene,
                                    uint64_t id,
                                    struct tree_pose *pose);

// The analysis that a tree was planted from, not copied. Free it with `tree_plastic_free`. `TREE_ERROR_INVALID` for an id
// that is not there.
tree_status tree_plastic_scene_model(const struct tree_plastic_scene *scene,
                                     uint64_t id,
                                     struct tree_plastic **plastic);

// Makes `params`, of `size` bytes, the default.
tree_status tree_plastic_regrowth_init(struct tree_plastic_regrowth *params, size_t size);

// Makes `params`, of `size` bytes, the default to the measure of a tree: internodes, voxels and distances by the length of its
// internodes, and bare where it is.
tree_status tree_plastic_regrowth_of(const struct tree_plastic *plastic,
                                     struct tree_plastic_regrowth *params,
                                     size_t size);

// A tree of a scene as of the last update, and new branches where old ones died and there is light. The scene does not change.
// `params`, `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_plastic_scene_regrown(const struct tree_plastic_scene *scene,
                                       uint64_t id,
                                       const struct tree_plastic_regrowth *params,
                                       uint64_t seed,
                                       const struct tree_control *control,
                                       struct tree_plastic_regrown *report,
                                       struct tree_tree **tree);

// Makes an empty scene. `sky` and `response` may be NULL for the defaults. Free it with `tree_plastic_scene_free`.
// `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_plastic_scene_new(const struct tree_plastic_sky *sky,
                                   const struct tree_plastic_response *response,
                                   struct tree_plastic_scene **scene);

// A second one in the state of the first. Free it too.
tree_status tree_plastic_scene_copy(const struct tree_plastic_scene *scene,
                                    struct tree_plastic_scene **copy);

// Changes the sky. It is as it was where it is refused.
tree_status tree_plastic_scene_set_sky(struct tree_plastic_scene *scene,
                                       const struct tree_plastic_sky *sky);

// Changes how much trees react. It is as it was where it is refused.
tree_status tree_plastic_scene_set_response(struct tree_plastic_scene *scene,
                                            const struct tree_plastic_response *response);

// Works out what the edits since the last update mean. `control` and `update` may be NULL. Where it is cancelled trees
// are half way, and the next update works all of them out anew. For each tree that is touched it takes time in proportion to
// its nodes and seasons, and to the clusters and obstacles around each of its clusters.
tree_status tree_plastic_scene_update(struct tree_plastic_scene *scene,
                                      const struct tree_control *control,
                                      struct tree_plastic_update *update);

// Frees a scene. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it.
tree_status tree_plastic_scene_free(struct tree_plastic_scene *scene);

// Estimates the season in which the segment that ends at each node grew, from 0 at the base, and how many internodes it
// made in a season, at least 1. `internode` is the length of one in metres; 0 takes the commonest distance between
// forks. `most`, 1 to 10,000, is how many seasons are told apart; a tree that has more is told them several at a time.
// `seasons` and `rates` have room for `capacity` numbers, at least one for each node.
tree_status tree_skeleton_ages(const struct tree_skeleton *skeleton,
                               float internode,
                               uint32_t most,
                               uint16_t *seasons,
                               float *rates,
                               size_t capacity,
                               size_t *n_seasons);

// Makes `sky`, of `size` bytes, the default: brightest above.
tree_status tree_plastic_sky_init(struct tree_plastic_sky *sky, size_t size);

// Makes `sky`, of `size` bytes, one that is brightest `elevation` radians above the horizon, 0 to π/2, in the direction
// `azimuth`, in radians from +Z towards +X.
tree_status tree_plastic_sky_towards(struct tree_plastic_sky *sky,
                                     size_t size,
                                     float azimuth,
                                     float elevation);

// Makes `response`, of `size` bytes, the default.
tree_status tree_plastic_response_init(struct tree_plastic_response *response, size_t size);

// Makes `options`, of `size` bytes, the default.
tree_status tree_pool_options_init(struct tree_pool_options *options, size_t size);

// Starts a pool, or asks the host for its threads. `options` may be NULL. Free it with
// `tree_pool_free`. Fails with `TREE_ERROR_NO_RESULT` when a thread cannot be had.
tree_status tree_pool_new(const struct tree_pool_options *options, struct tree_pool **pool);

// Number of threads of a pool.
tree_status tree_pool_threads(const struct tree_pool *pool, uint32_t *n_threads);

// Frees a pool, and returns when its threads have left its work. A host that unloads the library joins
// threads of its own first: what the library keeps for each thread goes when the thread ends. `TREE_ERROR_ORDER`, and the
// pool lives on, while a call is at work on it.
tree_status tree_pool_free(struct tree_pool *pool);

// Views a mask. Set `columns->struct_size` first.
tree_status tree_mask_view(const struct tree_mask *mask, struct tree_mask_columns *columns);

// Writes a byte for each pixel, rows from top to bottom: 1 where at least half of the pixel is covered,
// else 0. `capacity` must be `width * height` or more.
tree_status tree_mask_bits(const struct tree_mask *mask,
                           uint8_t *bits,
                           size_t capacity);

// The mask in black on white. Free the picture with `tree_picture_free`.
tree_status tree_mask_picture(const struct tree_mask *mask, struct tree_picture **picture);

// Frees a mask.
tree_status tree_mask_free(struct tree_mask *mask);

// Makes a picture of `4 * width * height` bytes of a program's own, which are copied. `control` may be
// NULL; only its limits matter. Free the picture with `tree_picture_free`.
tree_status tree_picture_from_pixels(uint32_t width,
                                     uint32_t height,
                                     const uint8_t *pixels,
                                     size_t n_bytes,
                                     const struct tree_control *control,
                                     struct tree_picture **picture);

// Views a picture's pixels. Set `pixels->struct_size` first.
tree_status tree_picture_view(const struct tree_picture *picture, struct tree_pixels *pixels);

// Writes a picture to a PNG file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends
// with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
tree_status tree_picture_write_png(const struct tree_picture *picture,
                                   const char *path,
                                   size_t path_len);

// A picture as a PNG file in memory. Free it with `tree_bytes_free`.
tree_status tree_picture_to_png(const struct tree_picture *picture, struct tree_bytes **bytes);

// Frees a picture.
tree_status tree_picture_free(struct tree_picture *picture);

// Draws a picture of a mesh. `view`, `style` and `control` may be NULL. Back faces are drawn too, with
// their normals turned over; an empty mesh gives the ground alone. Progress is told in the stages
// `textures`, `light` and `picture`. The same mesh and parameters give the same bytes on every platform
// and for any number of threads. Free the picture with `tree_picture_free`.
tree_status tree_render(const struct tree_mesh *mesh,
                        const struct tree_view *view,
                        const struct tree_style *style,
                        const struct tree_control *control,
                        struct tree_picture **picture);

// The share of each pixel that a mesh covers, by samples. There is no ground. `view` and `control` may
// be NULL. Free the mask with `tree_mask_free`.
tree_status tree_render_mask(const struct tree_mesh *mesh,
                             const struct tree_view *view,
                             const struct tree_control *control,
                             struct tree_mask **mask);

// The mask of a mesh in black on white. `view` and `control` may be NULL. Free the picture with
// `tree_picture_free`.
tree_status tree_render_silhouette(const struct tree_mesh *mesh,
                                   const struct tree_view *view,
                                   const struct tree_control *control,
                                   struct tree_picture **picture);

// Makes `style`, of `size` bytes, the default: a clear day on grass.
tree_status tree_style_init(struct tree_style *style, size_t size);

// Makes `style`, of `size` bytes, light grey paper with ground.
tree_status tree_style_studio(struct tree_style *style, size_t size);

// Makes `view`, of `size` bytes, the default.
tree_status tree_view_init(struct tree_view *view, size_t size);

// The same view with the camera placed where it stands for this mesh. `view` may be NULL for the
// default; `placed` may be the same struct. Set `placed->struct_size` first.
tree_status tree_view_place(const struct tree_view *view,
                            const struct tree_mesh *mesh,
                            struct tree_view *placed);

// Makes `params`, of `size` bytes, the default.
tree_status tree_gibbs_params_init(struct tree_gibbs_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_gibbs_params_check(const struct tree_gibbs_params *params);

// Finds a place in each of `n_domains` domains, at most 20,000, by a Gibbs process: branches keep apart, and keep to the
// pattern of `arrangement`. The same seed gives the same places. `params`, `control` and `report` may be NULL. Free the
// places with `tree_arranged_free`.
tree_status tree_arranged_new(const struct tree_domain *domains,
                              size_t n_domains,
                              const struct tree_arrangement *arrangement,
                              const struct tree_gibbs_params *params,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_arranged_report *report,
                              struct tree_arranged **arranged);

// A ready pattern of `n` branches, at most 20,000, that may stand anywhere, sorted along the parent. Other variants are
// other draws of the same seed. It has no trace. `control` may be NULL. Free the places with `tree_arranged_free`.
tree_status tree_arranged_ready(uint32_t n,
                                const struct tree_arrangement *arrangement,
                                uint64_t variant,
                                uint64_t seed,
                                const struct tree_control *control,
                                struct tree_arranged **arranged);

// Views the places, one for each domain in their order: where they begin and how many there are.
tree_status tree_arranged_sites(const struct tree_arranged *arranged,
                                const struct tree_site **sites,
                                size_t *n_sites);

// Views the cost at the start and after each kept move, which never rises: where the numbers begin and how many there are.
tree_status tree_arranged_trace(const struct tree_arranged *arranged,
                                const float **costs,
                                size_t *n_costs);

// Frees places.
tree_status tree_arranged_free(struct tree_arranged *arranged);

// Tests whether `n_sites` branches of one parent keep to an arrangement, by Rayleigh's test of the angles between
// one and the next. `control` may be NULL; `nodes` of its limits caps the places. Set `concentration->struct_size` first.
tree_status tree_sites_privileged(const struct tree_site *sites,
                                  size_t n_sites,
                                  const struct tree_arrangement *arrangement,
                                  const struct tree_control *control,
                                  struct tree_concentration *concentration);

// Makes `angles`, of `size` bytes, the default; its samples are valid for ever.
tree_status tree_branching_angles_init(struct tree_branching_angles *angles, size_t size);

// The angles at `n_places` places along the parent, shares of its length from 0 to 1, into `values`, which has room for
// `capacity`. `angles` and `control` may be NULL; `nodes` of the limits caps the places.
tree_status tree_branching_angles_at(const struct tree_branching_angles *angles,
                                     const float *places,
                                     size_t n_places,
                                     const struct tree_control *control,
                                     float *values,
                                     size_t capacity);

// Takes the angle of a redrawn branch as a sample; it replaces those close to it, but the function keeps its ends. The
// samples go into `samples`, two floats each; `capacity` counts floats: two more samples than there are always have room.
// `n_samples` gets their number. `angles` stays as it is, and may be NULL for the default.
tree_status tree_branching_angles_set(const struct tree_branching_angles *angles,
                                      float place,
                                      float angle,
                                      float *samples,
                                      size_t capacity,
                                      size_t *n_samples);

// Makes `params`, of `size` bytes, the default.
tree_status tree_branch_infer_params_init(struct tree_branch_infer_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_branch_infer_params_check(const struct tree_branch_infer_params *params);

// Infers the branch that ends at `end` along `tangent` (two floats each; a tangent of zeros: from where it comes): the
// shortest curve from the parent, which is left at the branching angle. `parent` has `n_parent` points, two floats each, from
// its base to its tip; the branch may leave it between the shares `from` and `to` of its length, 0 and 1 for anywhere.
// `outline` is that of the foliage, which the branch keeps within where it can; NULL where there is none. The
// branch's line goes into `points`, from base to end, two floats each; `capacity` counts floats, and two for each of `points`
// of the parameters always do. `n_points` gets their number, `share` where it leaves the parent. `angles`, `params` and
// `control` may be NULL; `nodes` of the limits caps the points. `TREE_ERROR_NO_RESULT` where the end lies on the parent.
tree_status tree_branch_infer(const float *parent,
                              size_t n_parent,
                              const struct tree_outline *outline,
                              const struct tree_branching_angles *angles,
                              const float *end,
                              const float *tangent,
                              float from,
                              float to,
                              const struct tree_branch_infer_params *params,
                              const struct tree_control *control,
                              float *points,
                              size_t capacity,
                              size_t *n_points,
                              float *share);

// Where a drawn branch leaves its parent: `share` gets the place nearest to its start as a share of the parent's length,
// `angle` the angle there in radians, 0 to π, and `is_left` whether the branch is on the parent's left side. Both are lines of
// two floats a point, from base to tip. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_branch_base(const float *parent,
                             size_t n_parent,
                             const float *branch,
                             size_t n_branch,
                             const struct tree_control *control,
                             float *share,
                             float *angle,
                             uint32_t *is_left);

// Carries the shape of a branch to another span. `branch` is its line, `n_branch` points from base to end of two floats
// each, `left` says whether it is on its parent's left side, and `outline` is that of its foliage. The same line on `span`
// goes into `points`; `capacity` counts floats, and `2 * n_branch` always do. `n_points` gets their number, `carried` the
// outline there. `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline with
// `tree_outline_free`.
tree_status tree_branch_carry(const float *branch,
                              size_t n_branch,
                              uint32_t left,
                              const struct tree_outline *outline,
                              const struct tree_branch_span *span,
                              const struct tree_control *control,
                              struct tree_branch_shape_report *report,
                              float *points,
                              size_t capacity,
                              size_t *n_points,
                              struct tree_outline **carried);

// Makes `params`, of `size` bytes, the default.
tree_status tree_bump_params_init(struct tree_bump_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_bump_params_check(const struct tree_bump_params *params);

// Finds the bumps of an outline by its chordal axis, in their order against the clock along it: one at least, which is the
// whole of an outline where nothing stands out. The foot of a crown, where the trunk comes in, may be one like every other.
// `params` and `control` may be NULL. Free the bumps with `tree_bumps_free`.
tree_status tree_outline_bumps(const struct tree_outline *outline,
                               const struct tree_bump_params *params,
                               const struct tree_control *control,
                               struct tree_bumps **bumps);

// Views bumps: where they begin and how many there are.
tree_status tree_bumps_view(const struct tree_bumps *bumps,
                            const struct tree_bump **rows,
                            size_t *n_rows);

// Frees bumps.
tree_status tree_bumps_free(struct tree_bumps *bumps);

// Makes `level`, of `size` bytes, the default.
tree_status tree_silhouette_level_init(struct tree_silhouette_level *level, size_t size);

// Makes `leaves`, of `size` bytes, the default.
tree_status tree_silhouette_leaves_init(struct tree_silhouette_leaves *leaves, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_silhouette_grow_params_init(struct tree_silhouette_grow_params *params,
                                             size_t size);

// Grows a tree of a plan: the same plan, parameters and seed give the same bits for any number of threads. `params`,
// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of
// range; `TREE_ERROR_LIMIT` comes before the memory is asked for.
tree_status tree_outline_plan_grow(const struct tree_outline_plan *plan,
                                   const struct tree_silhouette_grow_params *params,
                                   uint64_t seed,
                                   const struct tree_control *control,
                                   struct tree_silhouette_grown *report,
                                   struct tree_tree **tree);

// Makes a leaf of an outline that is attached at `base` and points to `tip`, two floats each. Its border is thinned to at most
// 64 corners. Free the leaf with `tree_leaf_outline_free`. `TREE_ERROR_INVALID` where both are the same point.
tree_status tree_leaf_outline_of(const struct tree_outline *outline,
                                 const float *base,
                                 const float *tip,
                                 struct tree_leaf_outline **leaf);

// As `tree_leaf_outline_of`, with base and tip as `tree_leaf_outline_ends` finds them.
tree_status tree_leaf_outline_guess(const struct tree_outline *outline,
                                    struct tree_leaf_outline **leaf);

// Where a drawn leaf is attached and what it points to, as it looks: `base` gets the end of its stalk where it has one,
// else the lowest point near the middle of an upright leaf and the left end of a lying one; `tip` the point farthest from
// there.
tree_status tree_leaf_outline_ends(const struct tree_outline *outline,
                                   float (*base)[2],
                                   float (*tip)[2]);

// Views a drawn leaf. Set `columns->struct_size` first.
tree_status tree_leaf_outline_view(const struct tree_leaf_outline *leaf,
                                   struct tree_leaf_outline_columns *columns);

// The flat mesh of a drawn leaf; its picture, if it gets one, spans the leaf's bounds. Free the model with
// `tree_leaf_model_free`. `tree_leaf_model_view` views it as `mesh` of a `tree_leaf_look` takes it: with the form
// `TREE_LEAF_MESH` that goes into `tree_look_new` or `tree_look_with_leaf`, and all leaves of the kind are as drawn.
tree_status tree_leaf_outline_model(const struct tree_leaf_outline *leaf,
                                    struct tree_leaf_model **model);

// Frees a drawn leaf.
tree_status tree_leaf_outline_free(struct tree_leaf_outline *leaf);

// Length in metres of a line of `n_line` points, two floats each: points that are not finite, and repeated ones, are left
// out. `control` may be NULL; `nodes` of its limits caps the points. `TREE_ERROR_INVALID` where fewer than two are left.
tree_status tree_line_length(const float *line,
                             size_t n_line,
                             const struct tree_control *control,
                             float *length);

// The points at `n_places` places along a line, shares of its length from 0 to 1, and its directions there, of unit
// length. `points` and `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. The line
// and `control` are as for `tree_line_length`.
tree_status tree_line_at(const float *line,
                         size_t n_line,
                         const float *places,
                         size_t n_places,
                         const struct tree_control *control,
                         float *points,
                         float *tangents,
                         size_t capacity);

// The place along a line that is nearest to each of `n_spots` points, two floats each. `shares` gets where that is as a
// share of the length, and `distances` how far it is from the point; each has room for `capacity`, and one may be NULL.
// The line and `control` are as for `tree_line_length`.
tree_status tree_line_nearest(const float *line,
                              size_t n_line,
                              const float *spots,
                              size_t n_spots,
                              const struct tree_control *control,
                              float *shares,
                              float *distances,
                              size_t capacity);

// A line by points at even distances, from `from` to a greater `to`, shares of its length from 0 to 1: `count` of them,
// 2 at least, or 0 for its own points there. They go into `points`, two floats each; `capacity` counts floats. `n_points`
// gets their number. The line and `control` are as for `tree_line_length`. `TREE_ERROR_NO_RESULT` where nothing is left.
tree_status tree_line_part(const float *line,
                           size_t n_line,
                           float from,
                           float to,
                           uint32_t count,
                           const struct tree_control *control,
                           float *points,
                           size_t capacity,
                           size_t *n_points);

// Says of `n_spots` points, two floats each, whether they lie inside: 1 or 0 into `inside`, which has room for
// `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_outline_contains(const struct tree_outline *outline,
                                  const float *spots,
                                  size_t n_spots,
                                  const struct tree_control *control,
                                  uint8_t *inside,
                                  size_t capacity);

// How far it is along `n_rays` rays to the outline, the first crossing in front: each ray is four floats, its beginning
// and its direction, of unit length. `exits`, which has room for `capacity`, gets metres, infinite where there is no
// crossing; from outside it is the near side. `control` as for `tree_outline_contains`.
tree_status tree_outline_exits(const struct tree_outline *outline,
                               const float *rays,
                               size_t n_rays,
                               const struct tree_control *control,
                               float *exits,
                               size_t capacity);

// The place along the outline that is nearest to each of `n_spots` points, two floats each. `lengths` gets how far that
// is along it, in metres against the clock from the first corner, and `distances` how far it is from the point; each has room
// for `capacity`, and one may be NULL. `control` as for `tree_outline_contains`.
tree_status tree_outline_nearest(const struct tree_outline *outline,
                                 const float *spots,
                                 size_t n_spots,
                                 const struct tree_control *control,
                                 float *lengths,
                                 float *distances,
                                 size_t capacity);

// The points at `n_lengths` lengths along an outline, in metres against the clock from the first corner, below 0 and beyond
// the perimeter on round; and the outline's directions there, of unit length, with the inside to the left. `points` and
// `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. `control` as for
// `tree_outline_contains`.
tree_status tree_outline_along(const struct tree_outline *outline,
                               const float *lengths,
                               size_t n_lengths,
                               const struct tree_control *control,
                               float *points,
                               float *tangents,
                               size_t capacity);

// The corners of the stretch from one length along an outline to another, both ends among them, into `points`, two floats
// each; `capacity` counts floats, and twice the corners plus four always do. `to` may exceed the perimeter where
// the stretch passes the first corner; it ends after once round. `n_points` gets their number: one where `to` is not above
// `from`.
tree_status tree_outline_part(const struct tree_outline *outline,
                              float from,
                              float to,
                              float *points,
                              size_t capacity,
                              size_t *n_points);

// Area that two outlines have in common, in square metres, within about 1 %; and the same over the area they cover
// together, 0 to 1 (the intersection over union).
tree_status tree_outline_overlap(const struct tree_outline *outline,
                                 const struct tree_outline *other,
                                 float *area,
                                 float *iou);

// Which of the `width` by `height` cells between the corners `low` and `high`, two floats each, have their centres
// inside: 1 or 0 into `cells`, row by row from the lowest, each from the left. `cells` has room for `capacity`. `control`
// may be NULL; `pixels` of its limits caps the cells.
tree_status tree_outline_mask(const struct tree_outline *outline,
                              const float *low,
                              const float *high,
                              uint32_t width,
                              uint32_t height,
                              const struct tree_control *control,
                              uint8_t *cells,
                              size_t capacity);

// Makes `params`, of `size` bytes, the default.
tree_status tree_outline_close_params_init(struct tree_outline_close_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_outline_close_params_check(const struct tree_outline_close_params *params);

// Makes an outline of a drawn stroke of `n_points` points, two floats each, in metres, y up: it is closed, made simple and
// turned against the clock. `tree_outline_repairs` tells what was done. `name`, of `name_len` bytes or
// `TREE_NUL_TERMINATED`, is what messages call the stroke; NULL for none. `params` and `control` may be NULL; `nodes` of the
// limits caps the points. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` where fewer than three different
// points are left, or it encloses next to nothing.
tree_status tree_outline_close(const float *stroke,
                               size_t n_points,
                               const char *name,
                               size_t name_len,
                               const struct tree_outline_close_params *params,
                               const struct tree_control *control,
                               struct tree_outline **outline);

// Makes an outline of points that already are one, two floats each: closed (the first is not repeated at the end), against
// the clock, without crossings, in metres, at most 4096. Nothing is repaired. `control` may be NULL; only its limits
// matter. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` says what is wrong and at which point.
tree_status tree_outline_from_points(const float *spots,
                                     size_t n_spots,
                                     const struct tree_control *control,
                                     struct tree_outline **outline);

// Views an outline's corners and tells how large it is. Set `columns->struct_size` first.
tree_status tree_outline_view(const struct tree_outline *outline,
                              struct tree_outline_columns *columns);

// Views what was repaired or noticed by `tree_outline_close`, in that order: where the repairs begin and how many there are.
// None for other outlines.
tree_status tree_outline_repairs(const struct tree_outline *outline,
                                 const struct tree_outline_repair **repairs,
                                 size_t *n_repairs);

// A sentence for each repair. Free the lines with `tree_lines_free`.
tree_status tree_outline_repairs_text(const struct tree_outline *outline,
                                      struct tree_lines **lines);

// The same outline by `n_points` corners at even lengths from the first on, at least 3 and at most 4096. Where so few
// would make it cross itself, or so many are not allowed, it stays as it is. Free it with `tree_outline_free`.
tree_status tree_outline_resampled(const struct tree_outline *outline,
                                   uint32_t n_points,
                                   const struct tree_control *control,
                                   struct tree_outline **resampled);

// The outline with every corner moved by an affine map, turned against the clock where that mirrors it. `affine` is six
// floats, a, b, c, d, e, f, as in SVG's matrices: x becomes a·x + c·y + e, y becomes b·x + d·y + f. Free the outline with
// `tree_outline_free`. `TREE_ERROR_NO_RESULT` where nothing is enclosed then.
tree_status tree_outline_transformed(const struct tree_outline *outline,
                                     const float *affine,
                                     struct tree_outline **transformed);

// Frees an outline. What was made of it lives on.
tree_status tree_outline_free(struct tree_outline *outline);

// Makes `params`, of `size` bytes, the default.
tree_status tree_cover_params_init(struct tree_cover_params *params, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_branch_system_params_init(struct tree_branch_system_params *params, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_silhouette_params_init(struct tree_silhouette_params *params, size_t size);

// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give.
tree_status tree_silhouette_params_check(const struct tree_silhouette_params *params);

// Reads an arrangement by name: `spread`, `spiral` (144°), `golden` (137.5°), `opposite`, `decussate`, `whorl3` (any number),
// `horizontal`, or `2:90` for two at a node and a turn of 90°. An angle in degrees may follow the names that have one:
// `spiral:137.5`, `whorl3:45`, `horizontal:30`. `text` has `len` bytes or is `TREE_NUL_TERMINATED`.
// `TREE_ERROR_UNKNOWN_NAME` for another name, `TREE_ERROR_PARAMETER` for a number out of range.
tree_status tree_arrangement_from_text(const char *text,
                                       size_t len,
                                       struct tree_arrangement *arrangement);

// Writes an arrangement as `tree_arrangement_from_text` reads it, angles in degrees to two places. Free the bytes, which
// are UTF-8, with `tree_bytes_free`.
tree_status tree_arrangement_to_text(const struct tree_arrangement *arrangement,
                                     struct tree_bytes **bytes);

// Tells the numbers behind an arrangement, and checks its ranges on the way. Set `numbers->struct_size` first.
tree_status tree_arrangement_measure(const struct tree_arrangement *arrangement,
                                     struct tree_arrangement_numbers *numbers);

// The domain of a branch that was drawn: at the share `along` of the parent's length, within 45° of the side it was
// drawn on, the left where `left` is not 0.
tree_status tree_domain_drawn(float along,
                              uint32_t left,
                              struct tree_domain *domain);

// Says whether a place lies in a domain.
tree_status tree_domain_contains(const struct tree_domain *domain,
                                 float along,
                                 float azimuth,
                                 uint32_t *inside);

// How far an azimuth lies outside a domain, in radians, 0 to π.
tree_status tree_domain_outside(const struct tree_domain *domain, float azimuth, float *angle);

// Views all branches. Valid until `tree_outline_plan_free`.
tree_status tree_outline_plan_view(const struct tree_outline_plan *plan,
                                   struct tree_outline_plan_columns *columns);

// The row of the branch of this id. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_outline_plan_find(const struct tree_outline_plan *plan, uint32_t id, size_t *row);

// Views the branch of this id. Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_outline_plan_branch(const struct tree_outline_plan *plan,
                                     uint32_t id,
                                     struct tree_outline_branch *branch);

// Views the system on the branch of this id, or with `TREE_NO_BRANCH` that of the trunk, whose outline is the crown.
// Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there, `TREE_ERROR_NO_RESULT` for a
// branch whose outline was not drawn.
tree_status tree_outline_plan_system(const struct tree_outline_plan *plan,
                                     uint32_t id,
                                     struct tree_outline_system *system);

// Of the system on a branch, or on the trunk, the outline in a further plane: how far the plane is turned about the
// axis, in radians from +X towards +Z, goes into `azimuth`. Free the outline with `tree_outline_free`.
// `TREE_ERROR_INVALID` for a section that is not there; else as `tree_outline_plan_system`.
tree_status tree_outline_plan_section(const struct tree_outline_plan *plan,
                                      uint32_t id,
                                      size_t section,
                                      float *azimuth,
                                      struct tree_outline **outline);

// The outline of a branch's foliage, or with `TREE_NO_BRANCH` the crown, as an object of its own. Free it with
// `tree_outline_free`. `TREE_ERROR_INVALID` for an id that is not there.
tree_status tree_outline_plan_outline(const struct tree_outline_plan *plan,
                                      uint32_t id,
                                      struct tree_outline **outline);

// Number of levels of outlines that were drawn: 1 for the crown only, 2 with that of a branch, and so on.
tree_status tree_outline_plan_count_levels(const struct tree_outline_plan *plan,
                                           uint32_t *n_levels);

// The drawn leaf, one long, and its length in metres. Free it with `tree_leaf_outline_free`. `TREE_ERROR_NO_RESULT`
// where none was drawn.
tree_status tree_outline_plan_leaf(const struct tree_outline_plan *plan,
                                   float *length,
                                   struct tree_leaf_outline **leaf);

// Frees a plan.
tree_status tree_outline_plan_free(struct tree_outline_plan *plan);

// Makes a drawing of one tree of strokes, which are copied: one at least, in the order they were drawn. `name`, of
// `name_len` bytes or `TREE_NUL_TERMINATED`, is the tree's, NULL for none; `trunk_width` is the trunk's in units of the drawing,
// 0 where it is not known. `control` may be NULL; `nodes` of its limits caps the points of all strokes. Free the drawing
// with `tree_outline_drawing_free`. `TREE_ERROR_INVALID` names a point that is not finite.
tree_status tree_outline_drawing_new(const struct tree_drawn_stroke *strokes,
                                     size_t n_strokes,
                                     const char *name,
                                     size_t name_len,
                                     float trunk_width,
                                     const struct tree_control *control,
                                     struct tree_outline_drawing **drawing);

// Reads outlines from an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. What is not seen is left out.
//
// Layers are groups, or single shapes, by id, class, layer label or name: `L0`, `L1`, `L2` and so on, and `leaf`. `L0@90` is
// drawn in a plane turned about the trunk by so many degrees. In `L0`, what is named *trunk* or *stem*, and an open line,
// is the trunk; what is closed or filled is the crown. In other layers what is closed or filled is the outline of a
// branch, and an open line a branch redrawn. Groups named `tree`, `tree1`, `tree-oak` hold one tree each.
//
// Without layers what is filled is one silhouette for each tree: its trunk is what is named so, or what is brown where
// something else is green, or the narrow part above the foot; the rest is its crown.
//
// `control` may be NULL; only its limits matter. Free the drawing with `tree_outline_drawing_free`. `TREE_ERROR_FORMAT` when
// the text is no SVG, draws nothing, or nothing of it is a tree.
tree_status tree_outline_drawing_from_svg(const char *svg,
                                          size_t len,
                                          const struct tree_control *control,
                                          struct tree_outline_drawing **drawing);

// Trunk and crown of the tree that a matte shows, in pixels, y downwards. Pixels covered to `threshold` or more belong to
// it, 0.01 to 1; 0.5 is usual. Fine details are smoothed away and the gaps of a frayed crown closed, so that the outline is
// one that can be drawn: at most 400 points. `control` may be NULL. Free the drawing with `tree_outline_drawing_free`.
// `TREE_ERROR_INVALID` where nothing is covered.
tree_status tree_outline_drawing_of_matte(const struct tree_matte *matte,
                                          float threshold,
                                          const struct tree_control *control,
                                          struct tree_outline_drawing **drawing);

// As `tree_outline_drawing_of_matte`, of a photograph that has been cut out, or of a mask in black and white: a half of
// `tree_photo_mask`.
tree_status tree_outline_drawing_of_photo(const struct tree_photo *photo,
                                          const struct tree_control *control,
                                          struct tree_outline_drawing **drawing);

// The matte of a picture of one tree: its alpha where it has one; else how dark it is, for a tree on a light border, or how
// light, for one on a dark border. `control` may be NULL. Free the matte with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where
// the picture is transparent everywhere.
tree_status tree_photo_mask(const struct tree_photo *photo,
                            const struct tree_control *control,
                            struct tree_matte **matte);

// Number of trees, one at least.
tree_status tree_outline_drawing_count(const struct tree_outline_drawing *drawing, size_t *n_trees);

// Views a tree of a drawing. `index` is below `tree_outline_drawing_count`. Set `tree->struct_size` first.
tree_status tree_outline_drawing_tree(const struct tree_outline_drawing *drawing,
                                      size_t index,
                                      struct tree_drawn_tree *tree);

// Views a stroke of tree `number` of a drawing. `index` is below the tree's `n_strokes`. Set `stroke->struct_size` first.
tree_status tree_outline_drawing_stroke(const struct tree_outline_drawing *drawing,
                                        size_t number,
                                        size_t index,
                                        struct tree_drawn_stroke *stroke);

// Views what was repaired or noticed when the drawing was read: where the repairs begin and how many there are.
tree_status tree_outline_drawing_repairs(const struct tree_outline_drawing *drawing,
                                         const struct tree_drawn_repair **repairs,
                                         size_t *n_repairs);

// A sentence for each repair. Free the lines with `tree_lines_free`.
tree_status tree_outline_drawing_repairs_text(const struct tree_outline_drawing *drawing,
                                              struct tree_lines **lines);

// Frees a drawing of outlines. What was made of it lives on.
tree_status tree_outline_drawing_free(struct tree_outline_drawing *drawing);

// Makes the surface through `n_sections` outlines, 1 to 1000, round an axis of `n_axis` points, two floats each, which is drawn in the
// plane of azimuth 0. Outline `i` is what is seen in a plane turned about the vertical to `azimuths[i]` radians: 0 for the
// drawing, π/2 for one seen from its right side; metres, x to that plane's right, y up, the tree's base at the origin.
// Between their halves the surface is blended. `control` may be NULL; `nodes` of the limits caps the points of the axis.
// Free the surface with `tree_revolved_free`.
tree_status tree_revolved_of(const float *axis,
                             size_t n_axis,
                             const struct tree_outline *const *outlines,
                             const float *azimuths,
                             size_t n_sections,
                             const struct tree_control *control,
                             struct tree_revolved **revolved);

// Tells the frame of a surface. Set `frame->struct_size` first.
tree_status tree_revolved_view(const struct tree_revolved *revolved,
                               struct tree_revolved_frame *frame);

// Brings `n_spots` points of the drawing, two floats each, into the frame of the axis: (r, y) each into `places`, which has
// room for `capacity` floats. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_revolved_to_frame(const struct tree_revolved *revolved,
                                   const float *spots,
                                   size_t n_spots,
                                   const struct tree_control *control,
                                   float *places,
                                   size_t capacity);

// The half of the surface at an azimuth: points (r, y) in metres, from top to bottom, two floats each into `points`;
// `capacity` counts floats. `n_points` gets their number; where `capacity` is too small, `TREE_ERROR_BUFFER` says how many floats
// are needed.
tree_status tree_revolved_half(const struct tree_revolved *revolved,
                               float azimuth,
                               float *points,
                               size_t capacity,
                               size_t *n_points);

// The outline of both halves at an azimuth and across from it, in (r, y). Free it with `tree_outline_free`.
// `TREE_ERROR_NO_RESULT` where nothing is left of it.
tree_status tree_revolved_profile(const struct tree_revolved *revolved,
                                  float azimuth,
                                  struct tree_outline **outline);

// How far it is along `n_rays` rays to the surface: each ray is four floats, its beginning (r, y) and its direction, of
// unit length, in the half-plane of the azimuth in `azimuths`. `exits`, which has room for `capacity`, gets metres,
// infinite from outside. A ray may lead across the axis. `control` may be NULL; `nodes` of its limits caps the rays.
tree_status tree_revolved_exits(const struct tree_revolved *revolved,
                                const float *rays,
                                const float *azimuths,
                                size_t n_rays,
                                const struct tree_control *control,
                                float *exits,
                                size_t capacity);

// Says of `n_points` points in the frame of the axis, three floats each (x to the right of the drawing, y along the span, z
// towards azimuth π/2), whether they lie inside: 1 or 0 into `inside`, which has room for `capacity`. `control` may be
// NULL; `nodes` of its limits caps the points.
tree_status tree_revolved_contains(const struct tree_revolved *revolved,
                                   const float *points,
                                   size_t n_points,
                                   const struct tree_control *control,
                                   uint8_t *inside,
                                   size_t capacity);

// Frees a surface.
tree_status tree_revolved_free(struct tree_revolved *revolved);

// Begins with nothing drawn. `params` may be NULL for the defaults. Free it with `tree_silhouette_session_free`.
// `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_silhouette_session_new(const struct tree_silhouette_params *params,
                                        uint64_t seed,
                                        struct tree_silhouette_session **silhouette);

// Draws all strokes of one tree of a drawing, the first being number 0; its height becomes that of the parameters.
// Strokes of finer levels that cannot be used are left out: `report`, `tree_silhouette_session_repairs` and
// `tree_silhouette_session_refused` tell which, and why. What was read cannot be undone. `params`, `control` and `report` may be
// NULL. Free it with `tree_silhouette_session_free`. `TREE_ERROR_INVALID` says why level 0 gives no crown.
tree_status tree_silhouette_session_of_drawing(const struct tree_outline_drawing *drawing,
                                               size_t tree,
                                               const struct tree_silhouette_params *params,
                                               uint64_t seed,
                                               const struct tree_control *control,
                                               struct tree_silhouette_play_report *report,
                                               struct tree_silhouette_session **silhouette);

// A second one in the state of the first, with all that can be undone: to try something, and go back. Free it
// too.
tree_status tree_silhouette_session_copy(const struct tree_silhouette_session *silhouette,
                                         struct tree_silhouette_session **copy);

// Frees it. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a progress callback
// for instance: it lives on then.
tree_status tree_silhouette_session_free(struct tree_silhouette_session *silhouette);

// Views a change. Valid until `tree_silhouette_change_free`.
tree_status tree_silhouette_change_view(const struct tree_silhouette_change *change,
                                        struct tree_silhouette_change_columns *columns);

// Frees a change.
tree_status tree_silhouette_change_free(struct tree_silhouette_change *change);

// Draws the trunk, from the ground up; one drawn downwards is turned. Branches are inferred anew when there is a
// crown. `stroke` has two floats for each of `n_points` points, in metres, y up. `control` may be NULL; `nodes` of its
// limits caps the points. `change` may be NULL where it is not wanted; else free what is put there with
// `tree_silhouette_change_free`. `TREE_ERROR_INVALID` for a line without length or one that stays away from the crown.
tree_status tree_silhouette_session_draw_trunk(struct tree_silhouette_session *silhouette,
                                               const float *stroke,
                                               size_t n_points,
                                               const struct tree_control *control,
                                               struct tree_silhouette_change **change);

// Draws the crown's outline. Branches that were drawn or refined stay where the new crown has a branch near. `stroke`,
// `control` and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or where
// the trunk stays away from it.
tree_status tree_silhouette_session_draw_crown(struct tree_silhouette_session *silhouette,
                                               const float *stroke,
                                               size_t n_points,
                                               const struct tree_control *control,
                                               struct tree_silhouette_change **change);

// Draws the crown as it is seen when the tree is turned by `azimuth` radians, -2π to 2π, from +X towards +Z: another
// drawing plane. An outline in that plane is replaced. `stroke`, `control` and `change` as in
// `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
tree_status tree_silhouette_session_draw_section(struct tree_silhouette_session *silhouette,
                                                 float azimuth,
                                                 const float *stroke,
                                                 size_t n_points,
                                                 const struct tree_control *control,
                                                 struct tree_silhouette_change **change);

// Draws the outline of the foliage of a branch of a level, 1 (branches on the trunk) to 8. The branch is the one with
// the greatest length inside; its own branches are inferred, and its style spreads to its siblings. `stroke`, `control`
// and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area or no part of a
// branch of that level.
tree_status tree_silhouette_session_refine(struct tree_silhouette_session *silhouette,
                                           uint32_t level,
                                           const float *stroke,
                                           size_t n_points,
                                           const struct tree_control *control,
                                           struct tree_silhouette_change **change);

// Draws the outline of the foliage of the branch of this id. `stroke`, `control` and `change` as in
// `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, and an id that is not there.
tree_status tree_silhouette_session_refine_branch(struct tree_silhouette_session *silhouette,
                                                  uint32_t id,
                                                  const float *stroke,
                                                  size_t n_points,
                                                  const struct tree_control *control,
                                                  struct tree_silhouette_change **change);

// Draws a branch of a level, 1 (branches on the trunk) to 8, over: the one whose ends are nearest to the stroke's.
// Where none is near, it is a new one. Its angle becomes a sample of the branching angles, and siblings take angle and
// shape as `transfer` says; `only` lists `n_only` ids for `TREE_TRANSFER_ONLY`, and may be NULL for the others. `stroke`,
// `control` and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for a line without length, or where
// there is no axis of that level.
tree_status tree_silhouette_session_redraw(struct tree_silhouette_session *silhouette,
                                           uint32_t level,
                                           const float *stroke,
                                           size_t n_points,
                                           tree_transfer transfer,
                                           const uint32_t *only,
                                           size_t n_only,
                                           const struct tree_control *control,
                                           struct tree_silhouette_change **change);

// Draws a branch on the trunk as it is seen by a viewer who has gone round the tree by `yaw` radians, -2π to 2π,
// against the clock seen from above (0 is in front, +X to the right), and looks down by `pitch`, within ±1.4. It lies
// in the upright plane through the trunk that faces the viewer. A branch drawn from near there before, with ends near
// the stroke's, is replaced; else it is a new one. The rest as in `tree_silhouette_session_redraw`, which this is from in
// front.
tree_status tree_silhouette_session_redraw_from(struct tree_silhouette_session *silhouette,
                                                float yaw,
                                                float pitch,
                                                const float *stroke,
                                                size_t n_points,
                                                tree_transfer transfer,
                                                const uint32_t *only,
                                                size_t n_only,
                                                const struct tree_control *control,
                                                struct tree_silhouette_change **change);

// Takes a branch away, with all on it. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for an id
// that is not there.
tree_status tree_silhouette_session_remove(struct tree_silhouette_session *silhouette,
                                           uint32_t id,
                                           struct tree_silhouette_change **change);

// Draws the leaf. Its length is as drawn. `stroke`, `control` and `change` as in `tree_silhouette_session_draw_trunk`.
// `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
tree_status tree_silhouette_session_draw_leaf(struct tree_silhouette_session *silhouette,
                                              const float *stroke,
                                              size_t n_points,
                                              const struct tree_control *control,
                                              struct tree_silhouette_change **change);

// Has `n_targets` branches take the style of the branch `source`, whose outline was drawn; 0: of the nearest such branch
// again. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for ids that are not there, and a source
// whose outline was not drawn.
tree_status tree_silhouette_session_copy_style(struct tree_silhouette_session *silhouette,
                                               uint32_t source,
                                               const uint32_t *targets,
                                               size_t n_targets,
                                               struct tree_silhouette_change **change);

// Other parameters, NULL for the defaults. Where those of branches or angles differ, branches are inferred anew.
// `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_silhouette_session_set_params(struct tree_silhouette_session *silhouette,
                                               const struct tree_silhouette_params *params,
                                               struct tree_silhouette_change **change);

// Another seed: only what is drawn by chance differs. This is no edit, and is not undone.
tree_status tree_silhouette_session_set_seed(struct tree_silhouette_session *silhouette,
                                             uint64_t seed);

// Takes back the last edit, changes of parameters included. `change` as in `tree_silhouette_session_draw_trunk`.
// `TREE_ERROR_NO_RESULT` where there is none.
tree_status tree_silhouette_session_undo(struct tree_silhouette_session *silhouette,
                                         struct tree_silhouette_change **change);

// Does again what was taken back last. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_NO_RESULT` where there
// is nothing.
tree_status tree_silhouette_session_redo(struct tree_silhouette_session *silhouette,
                                         struct tree_silhouette_change **change);

// The seed.
tree_status tree_silhouette_session_seed(const struct tree_silhouette_session *silhouette,
                                         uint64_t *seed);

// The parameters, all parts given; a trunk drawn as an area tells its radius there. What they point at belongs to the
// session and stays until `tree_silhouette_session_set_params`, `tree_silhouette_session_undo`, `tree_silhouette_session_redo` or
// `tree_silhouette_session_free`. Set `params->struct_size` first.
tree_status tree_silhouette_session_get_params(const struct tree_silhouette_session *silhouette,
                                               struct tree_silhouette_params *params);

// Numbers of edits that can be undone, and done again.
tree_status tree_silhouette_session_depth(const struct tree_silhouette_session *silhouette,
                                          size_t *n_undo,
                                          size_t *n_redo);

// How well the outlines of branches cover the crown: shares of its area, 0 to 1, in those of branches from bumps, and in
// those of all. 0 before a crown was drawn.
tree_status tree_silhouette_session_coverage(const struct tree_silhouette_session *silhouette,
                                             float *by_bumps,
                                             float *by_all);

// What was repaired in the drawing it began with, a line each, for a person to read. Free the lines with
// `tree_lines_free`.
tree_status tree_silhouette_session_repairs(const struct tree_silhouette_session *silhouette,
                                            struct tree_lines **lines);

// Which strokes of the drawing it began with could not be used, and why, a line each. Free the lines with
// `tree_lines_free`.
tree_status tree_silhouette_session_refused(const struct tree_silhouette_session *silhouette,
                                            struct tree_lines **lines);

// The plan as it is now: a copy, which later edits do not change. Free it with `tree_outline_plan_free`.
// `TREE_ERROR_NO_RESULT` before a crown was drawn.
tree_status tree_silhouette_session_plan(const struct tree_silhouette_session *silhouette,
                                         struct tree_outline_plan **plan);

// The tree in space. The same strokes, parameters and seed give the same bits for any number of threads. `control` and
// `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_INVALID` before a crown was drawn;
// `TREE_ERROR_LIMIT` comes before the memory is asked for.
tree_status tree_silhouette_session_tree(const struct tree_silhouette_session *silhouette,
                                         const struct tree_control *control,
                                         struct tree_silhouette_grown *report,
                                         struct tree_tree **tree);

// Makes `params`, of `size` bytes, the default.
tree_status tree_stand_params_init(struct tree_stand_params *params, size_t size);

// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. Whether the trees of
// `lendings` are there is seen when they are used.
tree_status tree_stand_params_check(const struct tree_stand_params *params);

// Grows all trees of a drawing, one outline for each, in parallel. Trees without details borrow branches and leaf of
// the detailed tree with the most similar crown, or of the one that `params` says. Trees that cannot be used are left
// out, and `tree_stand_notes` says so. `params` and `control` may be NULL. Free the stand with `tree_stand_free`.
//
// `TREE_ERROR_INVALID` when no tree can be used, and for a horizon below all of them; `TREE_ERROR_PARAMETER` names what
// is out of range; `TREE_ERROR_LIMIT` for more nodes or leaves, all trees together, than the limits allow.
tree_status tree_stand_of_drawing(const struct tree_outline_drawing *drawing,
                                  const struct tree_stand_params *params,
                                  uint64_t seed,
                                  const struct tree_control *control,
                                  struct tree_stand **stand);

// Views a stand as a whole.
tree_status tree_stand_view(const struct tree_stand *stand, struct tree_stand_whole *whole);

// What was noticed, a line each, for a person to read. Free the lines with `tree_lines_free`.
tree_status tree_stand_notes(const struct tree_stand *stand, struct tree_lines **lines);

// Views a tree of a stand, the first being number 0, in the order of the drawing. Valid until `tree_stand_free`.
tree_status tree_stand_at(const struct tree_stand *stand,
                          size_t index,
                          struct tree_stand_tree *row);

// What grew as tree `index`, its base at the origin. `report` may be NULL. Free the tree with `tree_tree_free`.
tree_status tree_stand_grown(const struct tree_stand *stand,
                             size_t index,
                             struct tree_silhouette_grown *report,
                             struct tree_tree **tree);

// What was drawn and borrowed of tree `index`, to be looked at or drawn on: a copy, its base at the origin. `report`,
// which may be NULL, tells what became of its strokes. Its
// `tree_silhouette_session_seed` is the stand's, from which its own comes. Free it with `tree_silhouette_session_free`.
tree_status tree_stand_silhouette(const struct tree_stand *stand,
                                  size_t index,
                                  struct tree_silhouette_play_report *report,
                                  struct tree_silhouette_session **silhouette);

// Frees a stand. What it handed out lives on.
tree_status tree_stand_free(struct tree_stand *stand);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sub_params_init(struct tree_sub_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_sub_params_check(const struct tree_sub_params *params);

// Opening in radians of the cone of a branch of span `span` with radius `radius` at its end. `params` may be NULL.
tree_status tree_sub_params_opening(const struct tree_sub_params *params,
                                    float radius,
                                    float span,
                                    float *angle);

// Cuts out the part of a parent's outline that is a branch's. `branch` is its line, `n_branch` points of two floats each from
// base to end, and `radius`, 0 or more, that of the disc at its end, as `tree_bump` has it. With `stretch`, two floats, only
// that part of the parent is shared: from 0 to the perimeter, to as much more again; NULL for whatever the cone reaches.
// `params`, `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline, which is simple
// whatever the branch, with `tree_outline_free`.
tree_status tree_outline_sub(const struct tree_outline *parent,
                             const float *branch,
                             size_t n_branch,
                             float radius,
                             const float *stretch,
                             const struct tree_sub_params *params,
                             const struct tree_control *control,
                             struct tree_sub_report *report,
                             struct tree_outline **sub);

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

// Frees a skeleton.
tree_status tree_skeleton_free(struct tree_skeleton *skeleton);

// Splits a skeleton into axes. Free them with `tree_axes_free`; they do not need the skeleton any more.
tree_status tree_skeleton_axes(const struct tree_skeleton *skeleton,
                               tree_continuation rule,
                               struct tree_axes **axes);

// Views the axes. Set `columns->struct_size` first.
tree_status tree_axes_view(const struct tree_axes *axes, struct tree_axis_columns *columns);

// Frees the axes.
tree_status tree_axes_free(struct tree_axes *axes);

// Measures how a skeleton branches: Horton-Strahler orders, unbranched runs, the exponent of the pipe model read off
// the radii. Set `report->struct_size` first.
tree_status tree_skeleton_branching(const struct tree_skeleton *skeleton,
                                    struct tree_branching_report *report);

// The Horton-Strahler order of each node, from 1 up: that of the segment below it. `orders` has room for `capacity`
// numbers, at least one for each node.
tree_status tree_skeleton_strahler_orders(const struct tree_skeleton *skeleton,
                                          uint32_t *orders,
                                          size_t capacity);

// The branches of order 1, 2 and so on, a row for each order, and the number of orders into `n_rows`. `rows` has room
// for `capacity` rows: 33 are enough, and as many as there are nodes.
tree_status tree_skeleton_strahler_counts(const struct tree_skeleton *skeleton,
                                          struct tree_strahler_order *rows,
                                          size_t capacity,
                                          size_t *n_rows);

// All unbranched runs, those below first, and their number into `n_runs`. Run 0 starts at the root and has no length
// where the root is a fork. `runs` has room for `capacity` rows: as many as there are nodes are enough.
tree_status tree_skeleton_runs(const struct tree_skeleton *skeleton,
                               struct tree_unbranched_run *runs,
                               size_t capacity,
                               size_t *n_runs);

// The run that each node lies on, a number of `tree_skeleton_runs`; a fork lies on the run below it. `run_of` has room
// for `capacity` numbers, at least one for each node.
tree_status tree_skeleton_run_of(const struct tree_skeleton *skeleton,
                                 uint32_t *run_of,
                                 size_t capacity);

// The exponent of the pipe model at each fork that has one, r^e = r1^e + r2^e + ..., as the radii are, in the order of
// the runs below, and their number into `n_exponents`. Infinite where a branch is as thick as the run below it or
// thicker. Forks at which a radius is 0, or a branch is a tip of one segment, are left out. `exponents` has room for
// `capacity` numbers: as many as there are nodes are enough.
tree_status tree_skeleton_pipe_exponents(const struct tree_skeleton *skeleton,
                                         double *exponents,
                                         size_t capacity,
                                         size_t *n_exponents);

// The angle of every lateral, in the order of axes, and their number into `n_laterals`; `rule` says what is axis and
// what lateral. Both directions are chords of `reach` metres, 0 or more: of the axis below the fork, and along the
// lateral. With a reach of 0 they are the segments next to the fork; measured skeletons are rough there and want a
// reach of a few diameters. Laterals at the root, and those without length, are left out. `laterals` has room for
// `capacity` rows: as many as there are nodes are enough.
tree_status tree_skeleton_lateral_angles(const struct tree_skeleton *skeleton,
                                         tree_continuation rule,
                                         float reach,
                                         struct tree_lateral_angle *laterals,
                                         size_t capacity,
                                         size_t *n_laterals);

// A new skeleton with other radii: `radii` has `n` floats, one for each node, in metres, 0 or more. Free
// it with `tree_skeleton_free`.
tree_status tree_skeleton_with_radii(const struct tree_skeleton *skeleton,
                                     const float *radii,
                                     size_t n,
                                     struct tree_skeleton **changed);

// A new skeleton with its nodes elsewhere: `positions` has three floats for each of `n` nodes, in
// metres. Free it with `tree_skeleton_free`.
tree_status tree_skeleton_with_positions(const struct tree_skeleton *skeleton,
                                         const float *positions,
                                         size_t n,
                                         struct tree_skeleton **changed);

// Length of the segment between each node and its parent, in metres; 0 for the root. `lengths` has room
// for `capacity` floats, at least one for each node.
tree_status tree_skeleton_segment_lengths(const struct tree_skeleton *skeleton,
                                          float *lengths,
                                          size_t capacity);

// Length of the path from the root to each node, in metres. `distances` has room for `capacity` floats,
// at least one for each node.
tree_status tree_skeleton_distances_to_root(const struct tree_skeleton *skeleton,
                                            float *distances,
                                            size_t capacity);

// Length of the longest path from each node up to a tip, in metres; 0 at tips. `distances` has room for
// `capacity` floats, at least one for each node.
tree_status tree_skeleton_distances_to_tip(const struct tree_skeleton *skeleton,
                                           float *distances,
                                           size_t capacity);

// Number of nodes from each node up, itself included. `sizes` has room for `capacity` numbers, at least
// one for each node.
tree_status tree_skeleton_subtree_sizes(const struct tree_skeleton *skeleton,
                                        uint32_t *sizes,
                                        size_t capacity);

// Number of tips from each node up; 1 for a tip. `counts` has room for `capacity` numbers, at least one
// for each node.
tree_status tree_skeleton_tip_counts(const struct tree_skeleton *skeleton,
                                     uint32_t *counts,
                                     size_t capacity);

// The children of every node: those of node `i` are `nodes[starts[i]]` up to, but not including,
// `nodes[starts[i + 1]]`, in rising order. `starts` has room for `starts_capacity` numbers, at least one
// more than there are nodes; `nodes` for `nodes_capacity`, at least one less than there are nodes.
tree_status tree_skeleton_children(const struct tree_skeleton *skeleton,
                                   uint32_t *starts,
                                   size_t starts_capacity,
                                   uint32_t *nodes,
                                   size_t nodes_capacity);

// Makes `options`, of `size` bytes, the default.
tree_status tree_swc_options_init(struct tree_swc_options *options, size_t size);

// Reads an SWC file: metres, +Y up. Rows keep their order where parents come first; otherwise nodes come
// breadth-first. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
// `TREE_NUL_TERMINATED`. `options` may be NULL for the defaults, and
// so may `control`, of which only the limits matter. What is wrong with a file is told with its line.
// Free the file with `tree_swc_free`.
tree_status tree_swc_read(const char *path,
                          size_t path_len,
                          const struct tree_swc_options *options,
                          const struct tree_control *control,
                          struct tree_swc **swc);

// Reads the text of an SWC file, of `len` bytes or `TREE_NUL_TERMINATED`. Otherwise as `tree_swc_read`.
tree_status tree_swc_from_text(const char *text,
                               size_t len,
                               const struct tree_swc_options *options,
                               const struct tree_control *control,
                               struct tree_swc **swc);

// The skeleton of an SWC file, not copied. Free it with `tree_skeleton_free`; it may outlive `swc`.
tree_status tree_swc_skeleton(const struct tree_swc *swc, struct tree_skeleton **skeleton);

// Views what an SWC file held beside the skeleton. Set `contents->struct_size` first.
tree_status tree_swc_view(const struct tree_swc *swc, struct tree_swc_contents *contents);

// Frees an SWC file that was read.
tree_status tree_swc_free(struct tree_swc *swc);

// Writes a skeleton as an SWC file, which is whole or absent: written beside its name, then renamed. Ids
// count from 1 in node order; types are 3, which continues the axis, and 4, which starts a lateral. With
// a scale of 1, reading brings back every position and radius exactly, unless it moves the root.
// `options` may be NULL for the defaults.
tree_status tree_skeleton_write_swc(const struct tree_skeleton *skeleton,
                                    const char *path,
                                    size_t path_len,
                                    const struct tree_swc_options *options);

// Writes a skeleton as the text of an SWC file, as `tree_skeleton_write_swc` does. Free it with
// `tree_bytes_free`.
tree_status tree_skeleton_to_swc(const struct tree_skeleton *skeleton,
                                 const struct tree_swc_options *options,
                                 struct tree_bytes **text);

// Makes `params`, of `size` bytes, the default.
tree_status tree_skeletonize_params_init(struct tree_skeletonize_params *params, size_t size);

// Makes `part`, of `size` bytes, the default: nothing.
tree_status tree_mesh_part_init(struct tree_mesh_part *part, size_t size);

// Makes `params`, of `size` bytes, the default.
tree_status tree_scan_params_init(struct tree_scan_params *params, size_t size);

// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
tree_status tree_scan_params_check(const struct tree_scan_params *params);

// Makes skeletons of a laser scan: `points` is three doubles for each of `n_points`, which are not kept; those that are
// not finite are left out. Leaves are not made. `params`, `control` and `report` may be NULL. Free the result with
// `tree_scanned_free`. `TREE_ERROR_INVALID` for fewer than 16 points that differ, or points on one line;
// `TREE_ERROR_NO_RESULT` where no tree stands; `TREE_ERROR_LIMIT` for more than `graph_nodes`, `graph_arcs` or `nodes`.
// It takes some four microseconds a point.
tree_status tree_skeletonize_scan(const double *points,
                                  size_t n_points,
                                  const struct tree_scan_params *params,
                                  const struct tree_control *control,
                                  struct tree_scan_report *report,
                                  struct tree_scanned **scanned);

// As `tree_skeletonize_scan`, of a cloud from a file.
tree_status tree_skeletonize_cloud(const struct tree_cloud *cloud,
                                   const struct tree_scan_params *params,
                                   const struct tree_control *control,
                                   struct tree_scan_report *report,
                                   struct tree_scanned **scanned);

// Number of trees: one, or as many as were found where all were asked for.
tree_status tree_scanned_count(const struct tree_scanned *scanned, size_t *n_trees);

// The skeleton of a tree, in metres, +Y up, its base at the origin; not copied. `index` is below `tree_scanned_count`.
// Free it with `tree_skeleton_free`; it may outlive the scan.
tree_status tree_scanned_skeleton(const struct tree_scanned *scanned,
                                  size_t index,
                                  struct tree_skeleton **skeleton);

// Views a tree: where it stands and what of it was guessed. `index` is below `tree_scanned_count`. Set
// `columns->struct_size` first.
tree_status tree_scanned_view(const struct tree_scanned *scanned,
                              size_t index,
                              struct tree_scanned_columns *columns);

// A gap that was bridged: its length in metres, and the points of the smaller one of the two pieces it joins. `index` is
// below `tree_scan_report.n_bridges`.
tree_status tree_scanned_bridge(const struct tree_scanned *scanned,
                                size_t index,
                                float *length,
                                size_t *n_points);

// Frees the trees of a cloud. Skeletons handed out live on.
tree_status tree_scanned_free(struct tree_scanned *scanned);

// The fourth stage: makes a leaf of each leaf component, on the nearest wood of a skeleton as
// `tree_pieces_link` returns it. Positions and sizes are in the units of the mesh already. `control` may
// be NULL. Free the leaves with `tree_found_leaves_free`.
tree_status tree_separation_leaves(const struct tree_separation *separation,
                                   const struct tree_skeleton *skeleton,
                                   const struct tree_control *control,
                                   struct tree_found_leaves **leaves);

// Views the leaves, in the form that `tree_tree_new` takes. Set `foliage->struct_size` first.
tree_status tree_found_leaves_foliage(const struct tree_found_leaves *leaves,
                                      struct tree_foliage *foliage);

// Views the kinds of leaves. Set `kinds->struct_size` first.
tree_status tree_found_leaves_view(const struct tree_found_leaves *leaves,
                                   struct tree_leaf_kinds *kinds);

// Frees leaves found in a mesh.
tree_status tree_found_leaves_free(struct tree_found_leaves *leaves);

// The second stage: follows every connected piece of wood from its base, in parallel. `params` and
// `control` may be NULL. Free the pieces with `tree_pieces_free`. `TREE_ERROR_NO_RESULT` where there is
// no wood.
tree_status tree_separation_follow(const struct tree_separation *separation,
                                   const struct tree_skeletonize_params *params,
                                   const struct tree_control *control,
                                   struct tree_pieces **pieces);

// Makes pieces of `n_pieces` skeletons, which are copied, and of what they stand for: for pieces that were
// changed, or come from elsewhere. `control` may be NULL; `nodes` of its limits caps those of all
// skeletons together.
tree_status tree_pieces_new(const struct tree_skeleton *const *skeletons,
                            const struct tree_piece *rows,
                            size_t n_pieces,
                            const struct tree_control *control,
                            struct tree_pieces **pieces);

// Number of pieces.
tree_status tree_pieces_count(const struct tree_pieces *pieces, size_t *n_pieces);

// One piece, `index` below their number: its skeleton, copied, in units of the mesh's longest side, and
// what it stands for (NULL if not wanted). Free the skeleton with `tree_skeleton_free`.
tree_status tree_pieces_piece(const struct tree_pieces *pieces,
                              size_t index,
                              struct tree_piece *row,
                              struct tree_skeleton **skeleton);

// The third stage: links pieces over gaps of at most `params.bridge` to one skeleton, seen from its lowest
// thick end. `reached`, NULL or with room for `capacity` bytes (one for each piece), says whether it is part of it. Free
// the skeleton with `tree_skeleton_free`. `TREE_ERROR_NO_RESULT` without pieces.
tree_status tree_pieces_link(const struct tree_pieces *pieces,
                             const struct tree_skeletonize_params *params,
                             const struct tree_control *control,
                             uint8_t *reached,
                             size_t capacity,
                             struct tree_skeleton **skeleton);

// Frees pieces.
tree_status tree_pieces_free(struct tree_pieces *pieces);

// The first stage of `tree_skeletonize` by itself: welds the parts and says of each connected component
// what it is. Arguments and errors are as there; `params.weld` counts. Free it with
// `tree_separation_free`.
//
// The stages, one after the other: `tree_separation_new`, `tree_separation_follow`, `tree_pieces_link`,
// `tree_separation_leaves`, `tree_separation_outward`. Up to the last all is in units of the mesh's
// longest side, about its middle, whatever the mesh's own unit.
tree_status tree_separation_new(const struct tree_mesh_part *parts,
                                size_t n_parts,
                                const struct tree_skeletonize_params *params,
                                const struct tree_control *control,
                                struct tree_separation **separation);

// As `tree_separation_new`, of a mesh: see `tree_skeletonize_mesh`.
tree_status tree_separation_of_mesh(const struct tree_mesh *mesh,
                                    const tree_hint *hints,
                                    size_t n_hints,
                                    const struct tree_skeletonize_params *params,
                                    const struct tree_control *control,
                                    struct tree_separation **separation);

// Views a separation. Set `columns->struct_size` first.
tree_status tree_separation_view(const struct tree_separation *separation,
                                 struct tree_separation_columns *columns);

// The same separation with other classes, one for each component: what a component was taken for need
// not hold. The first one stays as it is. Free the other one too.
tree_status tree_separation_with_classes(const struct tree_separation *separation,
                                         const tree_class *classes,
                                         size_t n_classes,
                                         struct tree_separation **other);

// The last stage: brings a skeleton back to the units of the mesh. Free it with `tree_skeleton_free`.
tree_status tree_separation_outward(const struct tree_separation *separation,
                                    const struct tree_skeleton *skeleton,
                                    struct tree_skeleton **outward);

// Frees a separation.
tree_status tree_separation_free(struct tree_separation *separation);

// Makes a tree of a mesh, in the mesh's unit: closed surfaces, tubes stuck into each other, thousands of
// separate prisms; cards or blobs for leaves. `parts` is `n_parts` structs, which are not kept. Its bark is
// named after the part with most wood, leaf kinds after the parts their leaves come from; no look is built
// in by such names, so give `tree_mesh_build` one of `tree_look_of_tree(tree, 1, &look)`, or of
// `tree_look_new` with the mesh's own textures. `params`,
// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_NO_RESULT` where
// nothing looks like wood; `TREE_ERROR_INVALID` for parts whose columns do not fit together.
tree_status tree_skeletonize(const struct tree_mesh_part *parts,
                             size_t n_parts,
                             const struct tree_skeletonize_params *params,
                             const struct tree_control *control,
                             struct tree_skeletonize_report *report,
                             struct tree_tree **tree);

// As `tree_skeletonize`, of a mesh: each surface is a part, named after its material. `hints` is NULL, or
// has one for each surface.
tree_status tree_skeletonize_mesh(const struct tree_mesh *mesh,
                                  const tree_hint *hints,
                                  size_t n_hints,
                                  const struct tree_skeletonize_params *params,
                                  const struct tree_control *control,
                                  struct tree_skeletonize_report *report,
                                  struct tree_tree **tree);

// Makes branches of columns, which are copied: segments of a sketch, or measured elsewhere, on which nothing grew
// yet. Every segment but the first must begin where its parent ends. `control` may be NULL; `nodes` of its limits
// caps the points. Free them with `tree_sketch_branches_free`. `TREE_ERROR_INVALID` says which columns or which
// segment do not fit.
tree_status tree_sketch_branches_from_columns(const struct tree_sketch_branches_columns *columns,
                                              const struct tree_control *control,
                                              struct tree_sketch_branches **branches);

// Views branches. Set `columns->struct_size` first.
tree_status tree_sketch_branches_view(const struct tree_sketch_branches *branches,
                                      struct tree_sketch_branches_columns *columns);

// Writes the Gravelius order of each segment's axis: 0 for stems, one more than its parent's for a lateral.
// `orders` has room for `capacity` values, at least as many as there are segments.
tree_status tree_sketch_branches_orders(const struct tree_sketch_branches *branches,
                                        uint32_t *orders,
                                        size_t capacity);

// Frees branches. What was made of them lives on.
tree_status tree_sketch_branches_free(struct tree_sketch_branches *branches);

// Makes `params`, of `size` bytes, the default.
tree_status tree_clean_params_init(struct tree_clean_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_clean_params_check(const struct tree_clean_params *params);

// Cleans a drawing and joins its strokes to one tree in the plane: points that are none go, what nobody marked
// is told apart (ground, crown, wood), of wood drawn by its outline the middle line is taken, strokes drawn over
// one another become one, gaps are closed. What was done is told by `tree_plan_repairs`. `params` and `control` may
// be NULL; `nodes` of the limits caps the points. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where no
// stroke has a length, or one is too far from the rest and `TREE_ISOLATED_REFUSE` was asked for: the text names the
// stroke.
tree_status tree_drawing_clean(const struct tree_drawing *drawing,
                               const struct tree_clean_params *params,
                               const struct tree_control *control,
                               struct tree_plan **plan);

// Makes `params`, of `size` bytes, the default.
tree_status tree_crown_params_init(struct tree_crown_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_crown_params_check(const struct tree_crown_params *params);

// Makes a crown of what was drawn: `columns` are lines in metres of the plan (x to the right, y up) such as those of
// `tree_plan_crown`. Ends that lie close are joined, wide gaps closed round the branches in them, and loops that cross
// are united. `spots` are `n_spots` points of the branches, two floats each, best without those below the first fork;
// there may be none. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the crown with
// `tree_crown_free`. `TREE_ERROR_INVALID` where nothing drawn encloses an area, or no branch touches the crown and
// `refuse` says so.
tree_status tree_crown_close(const struct tree_strokes_columns *columns,
                             const float *spots,
                             size_t n_spots,
                             const struct tree_crown_params *params,
                             const struct tree_control *control,
                             struct tree_crown **crown);

// Makes a crown of closed polygons, in metres of the plan. They are made simple and united as drawn ones are; points
// that are not finite are left out. `depth` is the crown's depth over its width, 0.05 to 20, 1 for circles. `control` may
// be NULL; `nodes` of the limits caps the points. Free the crown with `tree_crown_free`. `TREE_ERROR_INVALID` where they
// enclose no area.
tree_status tree_crown_from_polygons(const struct tree_strokes_columns *columns,
                                     float depth,
                                     const struct tree_control *control,
                                     struct tree_crown **crown);

// Views the polygons in metres of the plan: simple, apart from each other, against the clock, the largest first.
// Set `columns->struct_size` first.
tree_status tree_crown_polygons(const struct tree_crown *crown,
                                struct tree_strokes_columns *columns);

// Tells how large a crown is. Set `measures->struct_size` first.
tree_status tree_crown_measure(const struct tree_crown *crown,
                               struct tree_crown_measures *measures);

// Views what was repaired or noticed when the crown was closed, in that order: where the repairs begin and how many
// there are.
tree_status tree_crown_repairs(const struct tree_crown *crown,
                               const struct tree_crown_repair **repairs,
                               size_t *n_repairs);

// A sentence for each repair. Free the lines with `tree_lines_free`.
tree_status tree_crown_repairs_text(const struct tree_crown *crown, struct tree_lines **lines);

// Says of `n_spots` points of the plan, two floats each, whether they lie in the crown: 1 or 0 into `inside`, which
// has room for `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
tree_status tree_crown_contains(const struct tree_crown *crown,
                                const float *spots,
                                size_t n_spots,
                                const struct tree_control *control,
                                uint8_t *inside,
                                size_t capacity);

// Says of `n_points` points, three floats each, how near the solid's surface they are, into `levels`, which has room
// for `capacity`: 0 on the axis of the stretch they lie in, up to 1 inside, above 1 outside; infinite where the crown
// has nothing at that height. The plan lies at z = 0. `control` as for `tree_crown_contains`.
tree_status tree_crown_levels(const struct tree_crown *crown,
                              const float *points,
                              size_t n_points,
                              const struct tree_control *control,
                              float *levels,
                              size_t capacity);

// Where `n_ways` straight ways first leave the solid: each is six floats in `ways`, its beginning and its end. `exits`,
// which has room for `capacity`, gets a share of each way: 0 where it begins outside, infinite where it stays inside.
// `control` as for `tree_crown_contains`.
tree_status tree_crown_exits(const struct tree_crown *crown,
                             const float *ways,
                             size_t n_ways,
                             const struct tree_control *control,
                             float *exits,
                             size_t capacity);

// Frees a crown. What was made of it lives on.
tree_status tree_crown_free(struct tree_crown *crown);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sketch_outline_params_init(struct tree_sketch_outline_params *params, size_t size);

// The outlines of a cloud of `n_spots` points, two floats each, such as a tree's leaves as seen from one side, drawn
// as a person would: gaps between leaves closed, corners rounded. They are against the clock, the largest first; none
// for fewer than three points. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the outlines
// with `tree_strokes_free`.
tree_status tree_strokes_outline(const float *spots,
                                 size_t n_spots,
                                 const struct tree_sketch_outline_params *params,
                                 const struct tree_control *control,
                                 struct tree_strokes **strokes);

// Makes a drawing of strokes, which are copied; there may be none. `control` may be NULL; `nodes` of its
// limits caps the points of all strokes. Free the drawing with `tree_drawing_free`.
tree_status tree_drawing_new(const struct tree_sketch_stroke *strokes,
                             size_t n_strokes,
                             const struct tree_control *control,
                             struct tree_drawing **drawing);

// Makes a drawing with the strokes of another and these after them. The other stays as it is. `control` may
// be NULL; only its limits matter. Free the new drawing with `tree_drawing_free`.
tree_status tree_drawing_with_strokes(const struct tree_drawing *drawing,
                                      const struct tree_sketch_stroke *strokes,
                                      size_t n_strokes,
                                      const struct tree_control *control,
                                      struct tree_drawing **more);

// Reads the strokes of an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line, polyline,
// polygon, rectangle, circle and ellipse that is seen is one, with all transforms, in the drawing's units. A
// whole word in its id, class, layer label or name, or in those of the groups around it, says what it shows:
// `trunk`, `stem`; `branch`, `limb`, `twig`; `crown`, `outline`, `foliage`, `leaves`, `canopy`; and what is green
// is the crown. Its id becomes its name. Style sheets, `<use>` and texts are not read. `control` may be NULL;
// only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` when the text is no SVG or
// draws nothing.
tree_status tree_drawing_from_svg(const char *svg,
                                  size_t len,
                                  const struct tree_control *control,
                                  struct tree_drawing **drawing);

// Reads a drawing from JSON, `json` of `len` bytes or `TREE_NUL_TERMINATED`, at most 32 MiB, in any of these forms,
// y downwards:
//
// * `{"strokes": [{"points": [[x, y], …], "role": "branch", "closed": false, "filled": false, "name": ""}, …]}`,
//   where all but the points may be missing; the role is `trunk`, `branch`, `crown` or `null`;
// * `[[[x, y], …], …]`, bare lines;
// * `{"drawing": [[[x…], [y…]], …]}`, a drawing of Quick, Draw!.
//
// `control` may be NULL; only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` names
// the stroke and the point at fault.
tree_status tree_drawing_from_json(const char *json,
                                   size_t len,
                                   const struct tree_control *control,
                                   struct tree_drawing **drawing);

// Writes a drawing as JSON, in the first form of `tree_drawing_from_json`. Free the bytes, which are UTF-8, with
// `tree_bytes_free`. `TREE_ERROR_INVALID` names a point that is not finite: JSON has no such numbers.
tree_status tree_drawing_to_json(const struct tree_drawing *drawing,
                                 struct tree_bytes **bytes);

// Number of strokes.
tree_status tree_drawing_count(const struct tree_drawing *drawing, size_t *n_strokes);

// Views a stroke. `index` is below `tree_drawing_count`. Set `stroke->struct_size` first.
tree_status tree_drawing_stroke(const struct tree_drawing *drawing,
                                size_t index,
                                struct tree_sketch_stroke *stroke);

// Frees a drawing. What was made of it lives on.
tree_status tree_drawing_free(struct tree_drawing *drawing);

// Reads a drawing from each line that is not blank, in any form of `tree_drawing_from_json`: the files of Quick,
// Draw!. `ndjson` has `len` bytes or is `TREE_NUL_TERMINATED`. `control` may be NULL; only its limits matter. Free the
// drawings with `tree_drawings_free`. `TREE_ERROR_FORMAT` names the line, from 1, the stroke and the point.
tree_status tree_drawings_from_ndjson(const char *ndjson,
                                      size_t len,
                                      const struct tree_control *control,
                                      struct tree_drawings **drawings);

// Number of drawings.
tree_status tree_drawings_count(const struct tree_drawings *drawings, size_t *n_drawings);

// One of the drawings, not copied; it may outlive the others. `index` is below `tree_drawings_count`. Free it with
// `tree_drawing_free`.
tree_status tree_drawings_at(const struct tree_drawings *drawings,
                             size_t index,
                             struct tree_drawing **drawing);

// Frees drawings. Those taken out live on.
tree_status tree_drawings_free(struct tree_drawings *drawings);

// Number of exemplars: trees of clearly different habit, one for each built-in template.
size_t tree_exemplar_count(void);

// Name of an exemplar, such as `oak`, what the tree looks like, in a few words, and the name of the species whose
// leaves suit it. `index` is below `tree_exemplar_count`; `title` and `species` may be NULL. The texts are valid for ever.
tree_status tree_exemplar_name(size_t index,
                               struct tree_str *name,
                               struct tree_str *title,
                               struct tree_str *species);

// Grows one tree of the exemplar called `name` (`len` bytes, or `TREE_NUL_TERMINATED`), with leaves on cards. The same
// seed gives the same bits. `control` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_UNKNOWN_NAME` lists
// the names there are.
tree_status tree_exemplar_grow(const char *name,
                               size_t len,
                               uint64_t seed,
                               const struct tree_control *control,
                               struct tree_tree **tree);

// Makes `params`, of `size` bytes, the default.
tree_status tree_main_branch_params_init(struct tree_main_branch_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_main_branch_params_check(const struct tree_main_branch_params *params);

// The drawing that a person would make of a tree, in metres, y down: a stroke for each main branch, the trunk first, as
// an eye sees them that looks level from afar and stands at `yaw` radians round the trunk (0 on +Z, a quarter turn on
// +X), and `with_crown` the outline of its leaves. `main`, `outline` and `control` may be NULL. Free the drawing with
// `tree_drawing_free`.
tree_status tree_drawing_of_tree(const struct tree_tree *tree,
                                 float yaw,
                                 uint32_t with_crown,
                                 const struct tree_main_branch_params *main,
                                 const struct tree_sketch_outline_params *outline,
                                 const struct tree_control *control,
                                 struct tree_drawing **drawing);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sketch_finish_params_init(struct tree_sketch_finish_params *params, size_t size);

// The branches as a skeleton with radii by the pipe model. Every point stays where it is: seen from the front,
// sketched branches are the strokes. `params` and `control` may be NULL. Free it with `tree_skeleton_free`.
tree_status tree_sketch_branches_wood(const struct tree_sketch_branches *branches,
                                      const struct tree_sketch_finish_params *params,
                                      const struct tree_control *control,
                                      struct tree_skeleton **wood);

// Grows twigs and leaves of a species on wood, as many leaves as cover its crown like those of a tree in full leaf;
// with a `crown`, which may be NULL, both stay in it but for half a leaf. `params`, `control` and `report` may be
// NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range,
// `TREE_ERROR_UNKNOWN_NAME` a species that is none.
tree_status tree_sketch_grow_crown(const struct tree_skeleton *wood,
                                   const struct tree_crown *crown,
                                   const struct tree_sketch_finish_params *params,
                                   uint64_t seed,
                                   const struct tree_control *control,
                                   struct tree_sketch_finish_report *report,
                                   struct tree_tree **tree);

// The footprint of `n_spots` points, two floats each: the distances from the centre of their convex hull to the hull in
// `TREE_FOOTPRINT_DIRECTIONS` directions, as shares of the longer side of its bounding box, into `distances`, which has
// room for `capacity`. Points that are not finite do not count. `control` may be NULL; `nodes` of the limits caps the
// points. `TREE_ERROR_NO_RESULT` where the hull has no area.
tree_status tree_footprint_of(const float *spots,
                              size_t n_spots,
                              const struct tree_control *control,
                              float *distances,
                              size_t capacity);

// How unlike two footprints are, each `TREE_FOOTPRINT_DIRECTIONS` distances: the root of the mean square of their
// differences. 0 for equal shapes, about 0.2 for a circle and a poplar. `TREE_ERROR_INVALID` for other numbers of
// distances, or where one is not above 0 and at most 2.
tree_status tree_footprint_difference(const float *first,
                                      size_t n_first,
                                      const float *second,
                                      size_t n_second,
                                      float *difference);

// The convex hull of `n_spots` points, two floats each, against the clock where y goes up, without corners on straight
// sides, into `corners`, which has room for `capacity` floats: twice `n_spots` always do. `n_corners` gets their number,
// which is below 3 where the points lie on a line. Points that are not finite do not count. `control` may be NULL; `nodes`
// of the limits caps the points.
tree_status tree_convex_hull(const float *spots,
                             size_t n_spots,
                             const struct tree_control *control,
                             float *corners,
                             size_t capacity,
                             size_t *n_corners);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sketch_infer_params_init(struct tree_sketch_infer_params *params, size_t size);

// Makes `params` those of the thesis alone: no beam, no spread, no preference for a stroke's own continuation, no
// bending prior. Set `params->struct_size` first.
tree_status tree_sketch_infer_params_thesis(struct tree_sketch_infer_params *params);

// Infers depths, labels and, unless it is to be kept, Ω, which begins as the template's, by inference in a Markov
// random field (Neubert 2012, sections 4.4 to 4.6): a sketch is seen from the front, x and y of every branch are
// drawn, its depth z is not. Depths that are known go in as `n_pins` `pins`, NULL for none, and stay. Ends that are
// drawn inside `crown`, which may be NULL, stay in its surface of local revolution as far as the factors allow.
//
// `omega`, `params` and `control` may be NULL. Free the result with `tree_inferred_free`. `TREE_ERROR_PARAMETER`
// names what is out of range, `TREE_ERROR_INVALID` a pin that is at no fork or tip of the plan.
tree_status tree_sketch_infer(const struct tree_plan *plan,
                              const struct tree_sketch_omega *omega,
                              const struct tree_sketch_pin *pins,
                              size_t n_pins,
                              const struct tree_crown *crown,
                              const struct tree_sketch_infer_params *params,
                              uint64_t seed,
                              const struct tree_control *control,
                              struct tree_inferred **inferred);

// Views what was inferred. Set `columns->struct_size` first.
tree_status tree_inferred_view(const struct tree_inferred *inferred,
                               struct tree_inferred_columns *columns);

// The segments, with labels and points in space; seen along -Z their points are those of the plan. Free them with
// `tree_sketch_branches_free`.
tree_status tree_inferred_branches(const struct tree_inferred *inferred,
                                   struct tree_sketch_branches **branches);

// Ω of the sketch: the template's, or estimated. Set `omega->struct_size` first.
tree_status tree_inferred_omega(const struct tree_inferred *inferred,
                                struct tree_sketch_omega *omega);

// Frees what was inferred. Branches of it live on.
tree_status tree_inferred_free(struct tree_inferred *inferred);

// Builds the graph that `tree_sketch_infer` with the same arguments and no pins works on. `omega`, `params` and
// `control` may be NULL. Free it with `tree_factor_graph_free`. `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_factor_graph_new(const struct tree_plan *plan,
                                  const struct tree_sketch_omega *omega,
                                  const struct tree_sketch_infer_params *params,
                                  uint64_t seed,
                                  const struct tree_control *control,
                                  struct tree_factor_graph **graph);

// Parent of each segment, `TREE_NO_PARENT` for segment 0: where they begin and how many there are. Valid until
// `tree_factor_graph_free`.
tree_status tree_factor_graph_parents(const struct tree_factor_graph *graph,
                                      const uint32_t **parents,
                                      size_t *n_segments);

// Length of a segment in the plane, from end to end, in metres.
tree_status tree_factor_graph_length(const struct tree_factor_graph *graph,
                                     uint32_t segment,
                                     double *metres);

// The posterior of depths, of the segments' ends in metres, and labels: `n_segments` of each. `omega` and `control`
// may be NULL. `TREE_ERROR_INVALID` where there are not as many as segments, `TREE_ERROR_PARAMETER` for a depth
// that is not finite.
tree_status tree_factor_graph_posterior(const struct tree_factor_graph *graph,
                                        const struct tree_sketch_omega *omega,
                                        const double *depths,
                                        const tree_sketch_label *labels,
                                        size_t n_segments,
                                        const struct tree_control *control,
                                        struct tree_sketch_posterior *posterior);

// Frees a factor graph.
tree_status tree_factor_graph_free(struct tree_factor_graph *graph);

// Makes `params`, of `size` bytes, the default.
tree_status tree_midline_params_init(struct tree_midline_params *params, size_t size);

// Finds the middle lines of a filled area with these closed contours, which may cross: the main line first, then those
// that leave it, the strongest first. A side line begins at a point of the line that bears it. Points that are not finite
// are left out; what has no area has no lines. `params` and `control` may be NULL; `nodes` of the limits caps the
// points. Free the lines with `tree_midlines_free`. `tree_drawing_clean` does this for strokes that are `filled`.
tree_status tree_midlines_of(const struct tree_strokes_columns *columns,
                             const struct tree_midline_params *params,
                             const struct tree_control *control,
                             struct tree_midlines **midlines);

// Views middle lines, in the units of the contours. Set `columns->struct_size` first.
tree_status tree_midlines_view(const struct tree_midlines *midlines,
                               struct tree_strokes_columns *columns);

// Views half the area's width at every point of `tree_midlines_view`: where the numbers begin and how many there are.
tree_status tree_midlines_half_widths(const struct tree_midlines *midlines,
                                      const float **half_widths,
                                      size_t *n_points);

// Frees middle lines.
tree_status tree_midlines_free(struct tree_midlines *midlines);

// Makes `omega`, of `size` bytes, the default.
tree_status tree_sketch_omega_init(struct tree_sketch_omega *omega, size_t size);

// Whether all numbers are in range: `TREE_OK`, or the error that their use would give, which names order and
// field.
tree_status tree_sketch_omega_check(const struct tree_sketch_omega *omega);

// Ω of branches. Orders with few segments borrow from all orders together; what the branches do not show at all
// is the default's. Set `omega->struct_size` first.
tree_status tree_sketch_omega_fit(const struct tree_sketch_branches *branches,
                                  struct tree_sketch_omega *omega);

// Ω of template `index`, which is below `tree_templates_count`: that of its exemplar's main branches. Set
// `omega->struct_size` first.
tree_status tree_templates_omega(const struct tree_templates *templates,
                                 size_t index,
                                 struct tree_sketch_omega *omega);

// Ω of `n_relations` relations, of one tree or of many: those of `tree_sketch_branches_relations`, joined.
// `control` may be NULL; `nodes` of its limits caps the relations. Set `omega->struct_size` first.
// `TREE_ERROR_PARAMETER` names the row with a number that is not finite.
tree_status tree_sketch_omega_of_relations(const struct tree_sketch_relation *relations,
                                           size_t n_relations,
                                           const struct tree_control *control,
                                           struct tree_sketch_omega *omega);

// The same parameters for the whole tree, as in the thesis: those of the orders of `omega`, averaged. `omega` may
// be NULL for the default. Set `whole->struct_size` first.
tree_status tree_sketch_omega_without_orders(const struct tree_sketch_omega *omega,
                                             struct tree_sketch_omega *whole);

// How each segment lies to its parent, in the order of segments; none for segments without length and those of an
// imagined root. Their number goes into `n_relations`, they themselves into `relations`, which has room for
// `capacity` rows; with NULL they are only counted. There are fewer than segments.
tree_status tree_sketch_branches_relations(const struct tree_sketch_branches *branches,
                                           struct tree_sketch_relation *relations,
                                           size_t capacity,
                                           size_t *n_relations);

// Makes a plan of columns, which are copied: without crown and without repairs. `control` may be NULL; `nodes`
// of its limits counts. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where a number is not finite,
// or a parent does not come before its node.
tree_status tree_plan_from_columns(const struct tree_plan_columns *columns,
                                   const struct tree_control *control,
                                   struct tree_plan **plan);

// Views the columns of a plan. Set `columns->struct_size` first.
tree_status tree_plan_view(const struct tree_plan *plan, struct tree_plan_columns *columns);

// Views the lines of the drawn crown in metres of the plan, as drawn and not yet closed; a closed one ends where it
// begins. There may be none. Set `columns->struct_size` first. `tree_crown_close` takes them.
tree_status tree_plan_crown(const struct tree_plan *plan,
                            struct tree_strokes_columns *columns);

// Views the drawing's stroke of each line of the crown: where the numbers begin and how many there are.
tree_status tree_plan_crown_strokes(const struct tree_plan *plan,
                                    const uint32_t **strokes,
                                    size_t *n_strokes);

// Views what cleaning did to the drawing, in that order: where the repairs begin and how many there are.
tree_status tree_plan_repairs(const struct tree_plan *plan,
                              const struct tree_clean_repair **repairs,
                              size_t *n_repairs);

// A sentence for each repair, which names the stroke. Free the lines with `tree_lines_free`.
tree_status tree_plan_repairs_text(const struct tree_plan *plan, struct tree_lines **lines);

// The same plan, its crown with it, `factor` times as large in metres. Free it with `tree_plan_free`.
// `TREE_ERROR_INVALID` where the factor is not above 0 or coordinates become infinite.
tree_status tree_plan_scaled(const struct tree_plan *plan,
                             float factor,
                             struct tree_plan **scaled);

// Where points of the plan lie in the drawing: `spots` are `n_spots` times two floats in metres, `drawn` gets as many
// in units of the drawing; `capacity` is its room in floats. `control` may be NULL; `nodes` of its limits caps the
// points.
tree_status tree_plan_points_to_drawing(const struct tree_plan *plan,
                                        const float *spots,
                                        size_t n_spots,
                                        const struct tree_control *control,
                                        float *drawn,
                                        size_t capacity);

// Where points of the drawing lie in the plan: as `tree_plan_points_to_drawing`, the other way. `planned` gets
// the points.
tree_status tree_plan_points_from_drawing(const struct tree_plan *plan,
                                          const float *spots,
                                          size_t n_spots,
                                          const struct tree_control *control,
                                          float *planned,
                                          size_t capacity);

// Frees a plan. What was made of it lives on.
tree_status tree_plan_free(struct tree_plan *plan);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sketch_propagate_params_init(struct tree_sketch_propagate_params *params,
                                              size_t size);

// Fills a sketch up with branches after the pattern of its own (Neubert 2012, section 4.7): its forks are taken as
// replication blocks, which are attached to its open ends generation by generation, and along branches that are
// long without forks.
//
// With a `crown` growth stays inside it; with NULL it goes on for `generations`. New segments keep `clearance` away
// from `obstacles`, a volume or NULL for none; sketched ones stay as they are. `omega`, `params`, `control` and
// `report` may be NULL. The sketched segments keep their numbers, the new follow. Free them with
// `tree_sketch_branches_free`. `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_INVALID` says so for
// branches that have grown already.
tree_status tree_sketch_branches_propagate(const struct tree_sketch_branches *branches,
                                           const struct tree_sketch_omega *omega,
                                           const struct tree_crown *crown,
                                           const struct tree_volume *obstacles,
                                           const struct tree_sketch_propagate_params *params,
                                           uint64_t seed,
                                           const struct tree_control *control,
                                           struct tree_sketch_propagate_report *report,
                                           struct tree_sketch_branches **grown);

// Makes `params`, of `size` bytes, the default.
tree_status tree_template_select_params_init(struct tree_template_select_params *params,
                                             size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_template_select_params_check(const struct tree_template_select_params *params);

// Compares a plan with templates: one row for each into `choices`, best first; `capacity` is the number of templates or
// more. `crown` may be NULL for that which was drawn with the plan, as it was drawn. `params` and `control` may be NULL.
// `TREE_ERROR_INVALID` where there are no templates.
tree_status tree_templates_select(const struct tree_templates *templates,
                                  const struct tree_plan *plan,
                                  const struct tree_crown *crown,
                                  const struct tree_template_select_params *params,
                                  const struct tree_control *control,
                                  struct tree_template_choice *choices,
                                  size_t capacity);

// Begins with a drawing, which is copied. `params` may be NULL for the defaults. No work is done yet: what is wrong
// with the drawing comes to light with the first stage. Templates and obstacles are set with
// `tree_sketch_session_set_templates` and `tree_sketch_session_set_obstacles`. Free the session with
// `tree_sketch_session_free`. `TREE_ERROR_PARAMETER` names what is out of range.
tree_status tree_sketch_session_new(const struct tree_drawing *drawing,
                                    const struct tree_sketch_params *params,
                                    uint64_t seed,
                                    struct tree_sketch_session **session);

// A second session in the state of the first, with all that has been made so far: to try something, and
// go back. Free it too.
tree_status tree_sketch_session_copy(const struct tree_sketch_session *session,
                                     struct tree_sketch_session **copy);

// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
// progress callback for instance: it lives on then.
tree_status tree_sketch_session_free(struct tree_sketch_session *session);

// Another seed: other depths within Ω, another growth. Depths that edits kept are forgotten.
tree_status tree_sketch_session_set_seed(struct tree_sketch_session *session, uint64_t seed);

// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Where those of
// inference, the template or the height differ, depths that edits kept are forgotten.
tree_status tree_sketch_session_set_params(struct tree_sketch_session *session,
                                           const struct tree_sketch_params *params);

// Templates of one's own, which are copied, instead of those built in; NULL for these again. Depths that edits kept
// are forgotten.
tree_status tree_sketch_session_set_templates(struct tree_sketch_session *session,
                                              const struct tree_templates *templates);

// What new branches are to keep out of: a volume in the tree's metres, its base at the origin, or NULL for nothing.
// Sketched branches stay as they are.
tree_status tree_sketch_session_set_obstacles(struct tree_sketch_session *session,
                                              const struct tree_volume *obstacles);

// Forgets depths, Ω, scale and the choice of template that edits keep, so that all are found anew.
tree_status tree_sketch_session_infer_anew(struct tree_sketch_session *session);

// Forgets the results of a stage and of all later ones, so that they are done again; what edits keep stays.
tree_status tree_sketch_session_redo_from(struct tree_sketch_session *session,
                                          tree_sketch_stage stage);

// Draws one more stroke, which is copied; its number in the drawing goes into `number`. Depths of all other branches
// stay. `control` may be NULL; `nodes` of its limits caps the points. What is wrong with the stroke comes to light
// with the next stage; erase it then.
tree_status tree_sketch_session_add_stroke(struct tree_sketch_session *session,
                                           const struct tree_sketch_stroke *stroke,
                                           const struct tree_control *control,
                                           size_t *number);

// Erases a stroke, and with a branch all that it bears. Depths of all other branches stay, and so do the numbers of
// their strokes. Numbers of those that are gone go into `gone`, which has room for `capacity` of them, at least as
// many as there are strokes (`tree_drawing_count` of `tree_sketch_session_drawing`), and how many they are into
// `n_gone`. Both may be NULL where they are not wanted. `TREE_ERROR_INVALID` for a stroke that is not there or was
// erased before.
tree_status tree_sketch_session_erase_stroke(struct tree_sketch_session *session,
                                             size_t stroke,
                                             const struct tree_control *control,
                                             uint32_t *gone,
                                             size_t capacity,
                                             size_t *n_gone);

// Moves the tip or fork of a stroke that is nearest to `at`, two floats in the drawing's units, to `depth` in metres,
// positive towards the viewer. What it bears is inferred anew; the rest stays. The end of the root segment stays in
// the plane. `TREE_ERROR_INVALID` for a stroke that is not there, was erased, or has no tip or fork to move;
// `TREE_ERROR_PARAMETER` for numbers that are not finite.
tree_status tree_sketch_session_set_depth(struct tree_sketch_session *session,
                                          size_t stroke,
                                          const float *at,
                                          float depth,
                                          const struct tree_control *control);

// The drawing as it is after all edits; erased strokes are there without points. Free it with `tree_drawing_free`.
tree_status tree_sketch_session_drawing(const struct tree_sketch_session *session,
                                        struct tree_drawing **drawing);

// The seed.
tree_status tree_sketch_session_seed(const struct tree_sketch_session *session, uint64_t *seed);

// The parameters, all parts given. What they point at belongs to the session and stays until
// `tree_sketch_session_set_params` or `tree_sketch_session_free`. Set `params->struct_size` first.
tree_status tree_sketch_session_get_params(const struct tree_sketch_session *session,
                                           struct tree_sketch_params *params);

// How often a stage has been done so far.
tree_status tree_sketch_session_runs(const struct tree_sketch_session *session,
                                     tree_sketch_stage stage,
                                     uint32_t *n_runs);

// The strokes as a tree in the plane, in metres, with what was done to them. Free it with `tree_plan_free`.
// `TREE_ERROR_INVALID` says which stroke is of no use, or why the drawing is.
tree_status tree_sketch_session_plan(struct tree_sketch_session *session,
                                     const struct tree_control *control,
                                     struct tree_plan **plan);

// The closed crown. What was repaired of it is among `tree_sketch_session_warnings`. Free it with `tree_crown_free`.
// `TREE_ERROR_NO_RESULT` where none is drawn.
tree_status tree_sketch_session_crown(struct tree_sketch_session *session,
                                      const struct tree_control *control,
                                      struct tree_crown **crown);

// The templates compared with the drawing, best first: indices count in the session's templates, or in those built
// in. Their number goes into `n_choices`, they themselves into `choices`, which has room for `capacity` rows; with
// NULL they are only counted. There are none where the template was taken by name, or kept through an edit.
tree_status tree_sketch_session_choices(struct tree_sketch_session *session,
                                        const struct tree_control *control,
                                        struct tree_template_choice *choices,
                                        size_t capacity,
                                        size_t *n_choices);

// The template taken: templates of one row. Free them with `tree_templates_free`. `TREE_ERROR_UNKNOWN_NAME` lists
// the names there are.
tree_status tree_sketch_session_template_taken(struct tree_sketch_session *session,
                                               const struct tree_control *control,
                                               struct tree_templates **taken);

// Depths, labels and Ω. Free them with `tree_inferred_free`.
tree_status tree_sketch_session_inferred(struct tree_sketch_session *session,
                                         const struct tree_control *control,
                                         struct tree_inferred **inferred);

// The sketched branches with what grew on them. `report` may be NULL. Free them with `tree_sketch_branches_free`.
tree_status tree_sketch_session_branches(struct tree_sketch_session *session,
                                         const struct tree_control *control,
                                         struct tree_sketch_propagate_report *report,
                                         struct tree_sketch_branches **branches);

// The branches as a skeleton with radii. Free it with `tree_skeleton_free`.
tree_status tree_sketch_session_wood(struct tree_sketch_session *session,
                                     const struct tree_control *control,
                                     struct tree_skeleton **wood);

// The tree. The same drawing, parameters and seed give the same bits for any number of threads. `control` and `report`
// may be NULL. Free the tree with `tree_tree_free`.
tree_status tree_sketch_session_tree(struct tree_sketch_session *session,
                                     const struct tree_control *control,
                                     struct tree_sketch_report *report,
                                     struct tree_tree **tree);

// All that was repaired or fell short, a line each, for a person to read; none where all went well. The tree is made
// first where it is not there. Free the lines with `tree_lines_free`.
tree_status tree_sketch_session_warnings(struct tree_sketch_session *session,
                                         const struct tree_control *control,
                                         struct tree_lines **warnings);

// Makes `params`, of `size` bytes, the default.
tree_status tree_sketch_params_init(struct tree_sketch_params *params, size_t size);

// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. The name of the
// template is looked up when it is needed.
tree_status tree_sketch_params_check(const struct tree_sketch_params *params);

// Makes a tree of a drawing: a session (`tree_sketch_session`) that is asked for its tree, in one call. Of
// `templates`, which may be NULL for those built in, the one that suits best guides it, or the one that `params`
// names; new branches keep out of `obstacles`, which may be NULL. `params`, `control` and `report` may be NULL too.
// The tree's species is called by the template's name, unless `params` has a species. Free the tree with
// `tree_tree_free`.
//
// `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_UNKNOWN_NAME` a template or species that there is
// not; `TREE_ERROR_INVALID` says why a drawing, and which stroke of it, is of no use; `TREE_ERROR_LIMIT` comes before
// the memory is asked for.
tree_status tree_from_sketch(const struct tree_drawing *drawing,
                             const struct tree_templates *templates,
                             const struct tree_volume *obstacles,
                             const struct tree_sketch_params *params,
                             uint64_t seed,
                             const struct tree_control *control,
                             struct tree_sketch_report *report,
                             struct tree_tree **tree);

// The templates shipped: twenty trees of different habit. Free them with `tree_templates_free`.
tree_status tree_templates_builtin(struct tree_templates **templates);

// Reads templates from text, `text` of `len` bytes or `TREE_NUL_TERMINATED`, as `tree_templates_to_text` writes it.
// `control` may be NULL; only its limits matter. Free the templates with `tree_templates_free`. `TREE_ERROR_FORMAT`
// names the line and says what is wrong with it.
tree_status tree_templates_from_text(const char *text,
                                     size_t len,
                                     const struct tree_control *control,
                                     struct tree_templates **templates);

// Writes templates as text, some kilobytes for each. Free the bytes, which are UTF-8, with `tree_bytes_free`.
tree_status tree_templates_to_text(const struct tree_templates *templates,
                                   struct tree_bytes **bytes);

// Makes `params`, of `size` bytes, the default.
tree_status tree_template_params_init(struct tree_template_params *params, size_t size);

// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
tree_status tree_template_params_check(const struct tree_template_params *params);

// Measures one template of any tree, which grows along +Y: an exemplar of your own. `name` and `species` are one line of
// text each, of `name_len` and `species_len` bytes or `TREE_NUL_TERMINATED`; the species names its leaves. `params` and
// `control` may be NULL. Free the template with `tree_templates_free`; `tree_templates_join` puts it to others.
// `TREE_ERROR_INVALID` for trees without extent, height or branches.
tree_status tree_templates_of_tree(const char *name,
                                   size_t name_len,
                                   const char *species,
                                   size_t species_len,
                                   const struct tree_tree *tree,
                                   const struct tree_template_params *params,
                                   const struct tree_control *control,
                                   struct tree_templates **templates);

// Templates and others after them, copied. Free them with `tree_templates_free`. `TREE_ERROR_INVALID` where two have one
// name.
tree_status tree_templates_join(const struct tree_templates *templates,
                                const struct tree_templates *others,
                                struct tree_templates **joined);

// Number of templates.
tree_status tree_templates_count(const struct tree_templates *templates, size_t *n_templates);

// Index of the template called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). `TREE_ERROR_UNKNOWN_NAME` lists the names
// there are.
tree_status tree_templates_find(const struct tree_templates *templates,
                                const char *name,
                                size_t len,
                                size_t *index);

// Views a template. `index` is below `tree_templates_count`. Set `view->struct_size` first.
tree_status tree_templates_view(const struct tree_templates *templates,
                                size_t index,
                                struct tree_template_view *view);

// Views what a template looks like from one side. `index` is below `tree_templates_count`, `number` below `n_views` of
// the template. Set `side->struct_size` first.
tree_status tree_templates_side(const struct tree_templates *templates,
                                size_t index,
                                size_t number,
                                struct tree_template_side *side);

// Frees templates. What was made of them lives on.
tree_status tree_templates_free(struct tree_templates *templates);

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

// Frees a tree.
tree_status tree_tree_free(struct tree_tree *tree);

// The library's own `TREE_ABI_VERSION`: hold it against the header's before anything else.
uint32_t tree_abi_version(void);

// The library's version, such as `0.1.0`. Valid for ever.
const char *tree_version(void);

// Number of objects alive, of all kinds: for tests that look for leaks. Presets and their parts, which
// are never freed, do not count.
size_t tree_live_objects(void);

// Frees a volume. What was made of it lives on. `TREE_ERROR_ORDER` for the volumes of presets, which
// belong to the library.
tree_status tree_volume_free(struct tree_volume *volume);

// Makes what lies in any of `n_volumes` volumes, at least 1. As all that combine volumes: the volumes
// may be freed afterwards; combinations nest at most 48 deep (a union of unions is no deeper than one)
// and hold at most 1,048,576 solids.
tree_status tree_volume_union(const struct tree_volume *const *volumes,
                              size_t n_volumes,
                              struct tree_volume **volume);

// Makes what lies in all of `n_volumes` volumes, at least 1. It may turn out empty, which is no error.
tree_status tree_volume_intersection(const struct tree_volume *const *volumes,
                                     size_t n_volumes,
                                     struct tree_volume **volume);

// Makes what lies in `from` but not in `without`.
tree_status tree_volume_difference(const struct tree_volume *from,
                                   const struct tree_volume *without,
                                   struct tree_volume **volume);

// Makes `source` moved, turned, scaled or sheared. `columns` is twelve floats, column by column: where
// the X, Y and Z axes go, three floats each, and then where the origin goes. They must be finite and not
// flatten the volume.
tree_status tree_volume_transformed(const struct tree_volume *source,
                                    const float *columns,
                                    struct tree_volume **volume);

// Says of `n_points` points, three floats each, whether they lie inside: 1 or 0 into `inside`, which has
// room for as many. 0 for points that are not finite. `control` may be NULL; `nodes` of its limits caps
// the points.
tree_status tree_volume_contains(const struct tree_volume *volume,
                                 const float *points,
                                 size_t n_points,
                                 const struct tree_control *control,
                                 uint8_t *inside);

// Writes the signed distance of `n_points` points, three floats each, from the surface into `distances`,
// which has room for as many: metres, negative inside, NaN for points that are not finite. It is exact,
// or never too long and of the right sign; see `tree_volume_distance_is_exact`. `control` as for
// `tree_volume_contains`.
tree_status tree_volume_distance(const struct tree_volume *volume,
                                 const float *points,
                                 size_t n_points,
                                 const struct tree_control *control,
                                 float *distances);

// Whether `tree_volume_distance` is exact everywhere, 1 or 0: 1 for plain solids, turned, moved and
// uniformly scaled or not, 0 for combinations.
tree_status tree_volume_distance_is_exact(const struct tree_volume *volume, uint32_t *is_exact);

// A box around the volume: its lower corner, then its upper one, in metres. The smallest for plain
// solids, else not always. Infinite for half-spaces; lower above upper where it is empty.
tree_status tree_volume_bounds(const struct tree_volume *volume, float (*min_max)[6]);

// Whether the bounds are finite, 1 or 0, so that the volume can be sampled and trees can grow in it.
tree_status tree_volume_is_bounded(const struct tree_volume *volume,
                                   uint32_t *is_bounded);

// Cubic metres inside, where there is a closed form: for all plain solids but half-spaces, and these
// transformed. Otherwise NaN; then there is `tree_volume_estimate_measure`.
tree_status tree_volume_measure(const struct tree_volume *volume,
                                float *measure);

// Cubic metres inside by sampling about `n_samples` points: the same in every run; the error falls a
// little faster than 1 / sqrt(`n_samples`). Infinite when the bounds are, 0 when they are empty. 20,000
// samples take some milliseconds.
tree_status tree_volume_estimate_measure(const struct tree_volume *volume,
                                         uint32_t n_samples,
                                         const struct tree_control *control,
                                         float *measure);

// Writes `n_points` random points, uniform in the volume, three floats each, into `points`. The same
// `seed` gives the same points. For each at most `attempts` points of the bounds are drawn; 64 do for
// any plain solid but very narrow ones. `TREE_ERROR_NO_RESULT`, and nothing is written, when none of them
// lay inside, or the bounds are infinite or empty. `control` as for `tree_volume_contains`.
tree_status tree_volume_sample(const struct tree_volume *volume,
                               size_t n_points,
                               uint32_t attempts,
                               uint64_t seed,
                               const struct tree_control *control,
                               float *points);

// Makes a ball. `center` is three floats; `radius` is above 0. As all that make volumes: metres,
// `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` names what is out of range or not finite, and the
// volume is freed with `tree_volume_free`.
tree_status tree_volume_sphere(const float *center, float radius, struct tree_volume **volume);

// Makes an axis-aligned ellipsoid. `center` and `radii` are three floats each; `radii` are half its
// extents, above 0. Turn it with `tree_volume_transformed`.
tree_status tree_volume_ellipsoid(const float *center,
                                  const float *radii,
                                  struct tree_volume **volume);

// Makes a round cylinder between the middles of its ends, `base` and `top`, three floats each, which
// differ; `radius` is above 0.
tree_status tree_volume_cylinder(const float *base,
                                 const float *top,
                                 float radius,
                                 struct tree_volume **volume);

// Makes a truncated cone between the middles of its ends, `base` and `top`, three floats each, which
// differ. Radii are 0 or more, and one of them above 0.
tree_status tree_volume_frustum(const float *base,
                                const float *top,
                                float base_radius,
                                float top_radius,
                                struct tree_volume **volume);

// Makes the cone between a disc round `base` and a tip, `apex`, three floats each, which differ;
// `base_radius` is above 0.
tree_status tree_volume_cone(const float *base,
                             const float *apex,
                             float base_radius,
                             struct tree_volume **volume);

// Makes all points within `radius`, above 0, of the segment from `start` to `end`, three floats each; a
// ball where both are the same.
tree_status tree_volume_capsule(const float *start,
                                const float *end,
                                float radius,
                                struct tree_volume **volume);

// Makes an axis-aligned box. `min` and `max` are three floats each; `min` lies below `max` on every
// axis.
tree_status tree_volume_box(const float *min, const float *max, struct tree_volume **volume);

// Makes all on the side of a plane through `point` that `normal` points away from; three floats each,
// the normal of any length but 0. It has no end: to sample it, intersect it with a solid that has.
tree_status tree_volume_half_space(const float *point,
                                   const float *normal,
                                   struct tree_volume **volume);

// Makes the points within `radius`, above 0, of `apex` and within `angle` of `axis`: radians above 0, at
// pi the whole ball. `apex` and `axis` are three floats each, the axis of any length but 0.
tree_status tree_volume_sector(const float *apex,
                               const float *axis,
                               float angle,
                               float radius,
                               struct tree_volume **volume);

// Makes what a profile sweeps when it turns about `axis`, which has any length but 0 and along which
// heights are counted from `base`; three floats each. `profile` is `n_points` times two floats: distance
// from the axis, 0 or more and not all 0, and height, not all the same. The line is closed to the axis by
// a level line at both ends; heights may rise and fall. `control` may be NULL; only its limits matter
// (`nodes` caps the points).
tree_status tree_volume_revolution(const float *base,
                                   const float *axis,
                                   const float *profile,
                                   size_t n_points,
                                   const struct tree_control *control,
                                   struct tree_volume **volume);

// Makes what a closed triangle mesh bounds. `positions` is `n_positions` times three floats; corners at
// the same place count as one. `indices` is `n_triangles` times three. Along each edge as many triangles
// run one way as the other; inside is where the winding number is not 0. `TREE_ERROR_PARAMETER` names an
// open edge or an index that is too large. `control` may be NULL; only its limits matter (`triangles`
// caps the triangles and the positions).
tree_status tree_volume_closed_mesh(const float *positions,
                                    size_t n_positions,
                                    const uint32_t *indices,
                                    size_t n_triangles,
                                    const struct tree_control *control,
                                    struct tree_volume **volume);

// Views what a volume is made of. Set `solid->struct_size` first; what it points at is valid until the
// volume is freed. A cone is a frustum; combinations are as the library keeps them, a union of unions as
// one union.
tree_status tree_volume_view(const struct tree_volume *volume,
                             struct tree_solid *solid);

// A part of a combination, `index` below `tree_solid.n_parts`. Free it with `tree_volume_free`; it may
// outlive the combination.
tree_status tree_volume_part(const struct tree_volume *volume,
                             size_t index,
                             struct tree_volume **part);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TREE_H */
