//! Godot 4: `ARRAY_CUSTOM0` to `ARRAY_CUSTOM3`.
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | metres | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR` | 4 × unorm8 | occlusion | occlusion | occlusion | 1 |
//! | `UV` | 2 × f32 | u | v | | |
//! | `UV2` | 2 × f32 | light map u | light map v | | |
//! | `CUSTOM0` | 4 × float or half | pivot x | pivot y | pivot z | reach |
//! | `CUSTOM1` | 4 × float or half | axis x | axis y | axis z | phase |
//! | `CUSTOM2` | 4 × float or half | stiffness | level | flutter | leaf phase |
//! | `CUSTOM3` | 4 × float or half | parent's pivot x | y | z | reach of the pivot on the parent |
//!
//! Formats `ARRAY_CUSTOM_RGBA_FLOAT` or `ARRAY_CUSTOM_RGBA_HALF`. A shader turns a vertex about its
//! pivot by `sway(reach) * (1 - stiffness)` and then about the parent's pivot by `sway` of the fourth
//! number of `CUSTOM3`: two levels, which is what is seen. Winding is clockwise, as Godot's front faces.
//!
//! Unpacked: floats exact; halves within 2⁻¹¹ of the number (2⁻²⁵ near 0), which is 4 mm at 8 m;
//! occlusion within 1/510.

use super::common::Source;
use super::{Packed, Stream, Unpacked};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;

/// How wide the numbers of `CUSTOM0` to `CUSTOM3` are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// 32 bits: 64 bytes a vertex.
    #[default]
    Float,
    /// 16 bits: 32 bytes a vertex. Pivots are rounded to 4 mm at 8 m, 8 mm at 16 m.
    Half,
}

/// Packs a surface.
///
/// # Errors
/// As [`Mesh::check`], of this surface.
pub fn pack(mesh: &Mesh, surface: usize, precision: Precision) -> Result<Packed> {
    let source = Source::new(mesh, surface, Convention::Godot)?;
    let space = source.space;
    let mut custom: [Vec<[f32; 4]>; 4] = Default::default();
    for wind in &source.wind {
        let branch = source.branch(wind.branch);
        let parent = source.branch(branch.parent);
        let carried = if branch.level == 0 { 0.0 } else { parent.reach(branch.pivot) };
        let [c0, c1, c2, c3] = &mut custom;
        c0.push(space.position(branch.pivot).extend(wind.reach).to_array());
        c1.push(space.direction(branch.axis).extend(branch.phase).to_array());
        c2.push([branch.stiffness, branch.level as f32, wind.flutter, wind.leaf_phase]);
        c3.push(space.position(parent.pivot).extend(carried).to_array());
    }
    let shades = (0..source.len()).map(|vertex| source.occlusion(vertex));
    let mut streams = vec![
        Stream::unorm8("COLOR", shades.map(|shade| [shade, shade, shade, 1.0])),
        Stream::f32("UV", (0..source.len()).map(|vertex| source.uv(vertex).to_array())),
        Stream::f32("UV2", (0..source.len()).map(|vertex| source.uv2(vertex).to_array())),
    ];
    for (name, rows) in ["CUSTOM0", "CUSTOM1", "CUSTOM2", "CUSTOM3"].into_iter().zip(custom) {
        streams.push(match precision {
            Precision::Float => Stream::f32(name, rows.into_iter()),
            Precision::Half => Stream::f16(name, rows.into_iter()),
        });
    }
    Ok(source.finish(streams))
}

/// Reads back: beside the common columns occlusion, pivots, axes, reach, phases, stiffness, levels,
/// flutter and leaf phases.
#[must_use]
pub fn unpack(packed: &Packed) -> Unpacked {
    let space = packed.space;
    let mut back = packed.unpack_common("UV", "UV2");
    back.occlusion = packed.rows("COLOR").map(|color| color.x).collect();
    back.pivots = packed.rows("CUSTOM0").map(|c| space.position_back(c.truncate())).collect();
    back.reach = packed.rows("CUSTOM0").map(|c| c.w).collect();
    back.axes = packed.rows("CUSTOM1").map(|c| space.direction_back(c.truncate())).collect();
    back.phases = packed.rows("CUSTOM1").map(|c| c.w).collect();
    back.stiffness = packed.rows("CUSTOM2").map(|c| c.x).collect();
    back.levels = packed.rows("CUSTOM2").map(|c| c.y as u32).collect();
    back.flutter = packed.rows("CUSTOM2").map(|c| c.z).collect();
    back.leaf_phases = packed.rows("CUSTOM2").map(|c| c.w).collect();
    back
}
