//! Surfaces in the axes and layouts of engines.

use super::packed::tree_packed;
use super::pivots::Pivots;
use crate::border::{Failure, Result, call, get, out, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::{ask_for_copies, tree_mesh};
use ::tree_mesh::Mesh;
use ::tree_mesh::pack::{
    gltf_wind, godot, pivot_painter, speedtree8, speedtree9, tree_creator, vertex,
};

/// How a surface is packed: one of the `TREE_LAYOUT_` constants. Whatever column a surface lacks is
/// filled: tangents square to the normal, no light map, no occlusion.
pub type tree_layout = u32;

/// Unity's SpeedTree 8 shader: one branch, and leaves.
///
/// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
/// times, blend (1); UV0 4 f32: u, v, branch weight, branch direction; UV1 4 f32: light map u, v, anchor
/// x, y; UV2 4 f32: the vertex's place in the next level of detail (itself), anchor z; UV3 4 f32: leaf
/// scale, growth, ripple, kind (0 wood, 2 leaf).
pub const TREE_LAYOUT_SPEEDTREE8: u32 = 0;
/// Unity's SpeedTree 9 shader: two branches, and leaves. `stretch_limits` of the view belong into
/// `_ST_BranchStretchLimits`.
///
/// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three
/// times, blend (1); UV0 4 f32: u, v, noise and direction of branch 1; UV1 4 f32: light map u, v, weight
/// of branch 1, ripple weight; UV2 4 f32: noise, direction and weight of branch 2, 0; UV3 4 f32: anchor
/// x, y, z, 0.
pub const TREE_LAYOUT_SPEEDTREE9: u32 = 1;
/// Unity's Tree Creator shaders, and most vegetation shaders: bend weights and a phase.
///
/// POSITION 3 f32, metres in Unity's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: branch phase,
/// edge flutter, 0, occlusion; UV0 2 f32: u, v; UV1 2 f32: primary and secondary bend.
pub const TREE_LAYOUT_TREE_CREATOR: u32 = 2;
/// Unreal's Pivot Painter 2: the hierarchy, at most 4 levels, in two textures that
/// `tree_packed_pivots` views.
///
/// POSITION 3 f32, centimetres in Unreal's axes; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion,
/// flutter, leaf phase, 1; UV0 2 f32: u, v; UV1 2 f32: light map u, v; UV2 2 f32: texel of the element.
pub const TREE_LAYOUT_PIVOT_PAINTER: u32 = 3;
/// Godot 4, `CUSTOM0` to `CUSTOM3` as floats: the own branch in full, and the parent's part.
///
/// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; COLOR 4 unorm8: occlusion three times, 1; UV 2
/// f32: u, v; UV2 2 f32: light map u, v; CUSTOM0 4: pivot x, y, z, reach; CUSTOM1 4: axis x, y, z, phase;
/// CUSTOM2 4: stiffness, level, flutter, leaf phase; CUSTOM3 4: parent's pivot x, y, z, reach of the
/// pivot on the parent.
pub const TREE_LAYOUT_GODOT: u32 = 4;
/// As `TREE_LAYOUT_GODOT`, with `CUSTOM0` to `CUSTOM3` as halves: 32 bytes a vertex instead of 64. Pivots
/// are rounded to 4 mm at 8 m, 8 mm at 16 m.
pub const TREE_LAYOUT_GODOT_HALF: u32 = 5;
/// glTF attributes `_WIND*`: all of it. `tree_mesh_gltf_wind` gives them for files.
///
/// POSITION 3 f32, metres; NORMAL 3 f32; TANGENT 4 f32; `COLOR_0` 4 unorm8: occlusion three times, 1;
/// `TEXCOORD_0` 2 f32; `TEXCOORD_1` 2 f32; `_WIND_PIVOT` 3 f32; `_WIND_AXIS` 3 f32; `_WIND` 4 f32:
/// reach, phase, stiffness, length in metres; `_WIND_LEAF` 4 f32: flutter, leaf phase, level, 1 for
/// leaves; `_WIND_ANCHOR` 3 f32; `_WIND_BRANCH` 4 u16: branch low, high, parent low, high.
pub const TREE_LAYOUT_GLTF_WIND: u32 = 6;
/// Own renderers: 32 bytes a vertex, quantised, in our axes; `tree_packed_vertices` views them. There are
/// no streams.
pub const TREE_LAYOUT_VERTEX: u32 = 7;

fn pack(mesh: &Mesh, surface: usize, layout: tree_layout) -> Result<tree_packed> {
    let streams = match layout {
        TREE_LAYOUT_SPEEDTREE8 => speedtree8::pack(mesh, surface),
        TREE_LAYOUT_SPEEDTREE9 => {
            let packed = speedtree9::pack(mesh, surface)?;
            let limits = speedtree9::StretchLimits::of(mesh);
            return Ok(tree_packed::streams(layout, packed)?.with_limits(limits));
        }
        TREE_LAYOUT_TREE_CREATOR => tree_creator::pack(mesh, surface),
        TREE_LAYOUT_PIVOT_PAINTER => {
            let textures = pivot_painter::Textures::new(mesh)?;
            let packed = pivot_painter::pack(mesh, surface, &textures)?;
            let pivots = Pivots::new(textures, mesh.branches.len());
            return Ok(tree_packed::streams(layout, packed)?.with_pivots(pivots));
        }
        TREE_LAYOUT_GODOT => godot::pack(mesh, surface, godot::Precision::Float),
        TREE_LAYOUT_GODOT_HALF => godot::pack(mesh, surface, godot::Precision::Half),
        TREE_LAYOUT_GLTF_WIND => gltf_wind::pack(mesh, surface),
        TREE_LAYOUT_VERTEX => return Ok(tree_packed::vertices(vertex::pack(mesh, surface)?)),
        other => return Err(Failure::not_one_of("layout", other, "TREE_LAYOUT_")),
    }?;
    tree_packed::streams(layout, streams)
}

/// Packs a surface of a mesh, in the axes of the engine the layout is for. `control` may be NULL; only a
/// cancellation before the work begins matters. Free the result with `tree_packed_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_pack(
    mesh: *const tree_mesh,
    surface: usize,
    layout: tree_layout,
    control: *const tree_control,
    packed: *mut *mut tree_packed,
) -> tree_status {
    call(|| {
        let place = unsafe { out(packed, "packed") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 2)?;
                pack(mesh, surface, layout)
            })
        }?;
        place.put(made);
        Ok(())
    })
}
