//! Unity's Tree Creator layout, which most vegetation shaders for Unity read as well.
//!
//! As written by Unity's `TreeVertex.SetAnimationProperties` and `SetAmbientOcclusion`, and read by
//! `AnimateVertex` of its `TerrainEngine.cginc`:
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | metres, Unity's axes | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR` | 4 × unorm8 | branch phase | edge flutter | 0 | occlusion |
//! | `UV0` | 2 × f32 | u | v | | |
//! | `UV1` | 2 × f32 | primary bend | secondary bend | | |
//!
//! * Branch phase: of the branch at level 1, so that what hangs on a bough stays together.
//! * Edge flutter: [`flutter`](crate::wind::VertexWind::flutter) of leaves.
//! * Primary bend, 0 to 1: deflection of the trunk where the vertex is carried by it.
//! * Secondary bend, 0 to 1: deflection of the bough, 0 on the trunk.
//!
//! Both are reach × [`sway`] of the branch, 1 at its tip; how far a tree gives way as a whole is set in
//! the engine. Unpacked: positions, normals, uvs and bends within a rounding, the colours within 1/510.

use super::common::Source;
use super::{Packed, Stream, Unpacked};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;
use crate::wind::{VertexWind, sway};
use glam::Vec2;

/// Phase, primary and secondary bend of a vertex, given the trunk and the bough that carry it.
fn bends(source: &Source<'_>, wind: &VertexWind, [trunk, bough]: [Option<u32>; 2]) -> (f32, Vec2) {
    let bend = |reach: f32| reach * sway(reach);
    match bough {
        Some(number) => {
            let bough = source.branch(number);
            let carried = trunk.map_or(0.0, |trunk| source.branch(trunk).reach(bough.pivot));
            (bough.phase, Vec2::new(bend(carried), bend(bough.reach(wind.anchor))))
        }
        None => {
            let along = trunk.map_or(0.0, |trunk| source.branch(trunk).reach(wind.anchor));
            (0.0, Vec2::new(bend(along), 0.0))
        }
    }
}

/// Packs a surface.
///
/// # Errors
/// As [`Mesh::check_surface`] and [`Mesh::check_branches`].
///
/// # Complexity
/// O(branches + vertices), whatever the depth of the hierarchy.
pub fn pack(mesh: &Mesh, surface: usize) -> Result<Packed> {
    let source = Source::new(mesh, surface, Convention::Unity)?;
    let levels = [source.ancestors(0), source.ancestors(1)];
    let (mut colors, mut uv1) = (Vec::new(), Vec::new());
    for (vertex, wind) in source.wind.iter().enumerate() {
        let carriers = levels.each_ref().map(|of| of.get(wind.branch as usize).copied().flatten());
        let (phase, bend) = bends(&source, wind, carriers);
        colors.push([phase, wind.flutter, 0.0, source.occlusion(vertex)]);
        uv1.push(bend.to_array());
    }
    let uv0 = (0..source.len()).map(|vertex| source.uv(vertex).to_array());
    Ok(source.finish(vec![
        Stream::unorm8("COLOR", colors.into_iter()),
        Stream::f32("UV0", uv0),
        Stream::f32("UV1", uv1.into_iter()),
    ]))
}

/// Reads back: beside the common columns phases, flutter, occlusion and `weights` (primary and
/// secondary bend). There is no light map.
#[must_use]
pub fn unpack(packed: &Packed) -> Unpacked {
    let mut back = packed.unpack_common("UV0", "");
    back.phases = packed.rows("COLOR").map(|color| color.x).collect();
    back.flutter = packed.rows("COLOR").map(|color| color.y).collect();
    back.occlusion = packed.rows("COLOR").map(|color| color.w).collect();
    back.weights = packed.rows("UV1").map(|uv| Vec2::new(uv.x, uv.y)).collect();
    back
}
