//! Unity's SpeedTree 8 layout.
//!
//! As read by Unity's built-in `SpeedTree8Common.cginc` and `SpeedTreeWind.cginc` (2018 and later;
//! those of URP and HDRP read the same):
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | metres, Unity's axes | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR` | 4 × unorm8 | occlusion | occlusion | occlusion | blend, 1 |
//! | `UV0` | 4 × f32 | u | v | branch weight | branch direction |
//! | `UV1` | 4 × f32 | light map u | light map v | anchor x | anchor y |
//! | `UV2` | 4 × f32 | x of the next level of detail | y | z | anchor z |
//! | `UV3` | 4 × f32 | leaf scale | leaf growth | leaf ripple | kind |
//!
//! * Branch weight: how far the branch wind moves the vertex; reach × the branch's give. The trunk has
//!   0: Unity's global wind moves it by height.
//! * Branch direction: the direction it swings in, [`Branch::swing`](crate::wind::Branch::swing), by
//!   [`direction::speedtree8`]. The shader takes the same number for the phase.
//! * The next level of detail is the vertex itself: with only one mesh nothing morphs. A builder of
//!   levels writes its positions there.
//! * Leaf scale: the flutter. Growth: from the anchor through the leaf's middle. Ripple: the normal.
//! * Kind: 0 for wood, 2 for leaves.
//!
//! Unpacked: all floats within a rounding, occlusion within 1/510, directions within 0.18 radians.

use super::common::Source;
use super::{Packed, Stream, Unpacked, direction};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;
use glam::{Vec2, Vec3};

/// `GEOM_TYPE_LEAF`; `GEOM_TYPE_BRANCH` is 0.
const LEAF: f32 = 2.0;

/// Packs a surface.
///
/// # Errors
/// As [`Mesh::check`], of this surface.
pub fn pack(mesh: &Mesh, surface: usize) -> Result<Packed> {
    let source = Source::new(mesh, surface, Convention::Unity)?;
    let space = source.space;
    let growth = source.leaf_directions();
    let (mut colors, mut uv0, mut uv1) = (Vec::new(), Vec::new(), Vec::new());
    let (mut uv2, mut uv3) = (Vec::new(), Vec::new());
    for (vertex, (wind, position)) in source.wind.iter().zip(source.positions()).enumerate() {
        let branch = source.branch(wind.branch);
        let weight = if branch.level == 0 { 0.0 } else { wind.reach * branch.give() };
        let swing = direction::speedtree8(space.direction(branch.swing()));
        let (uv, map) = (source.uv(vertex), source.uv2(vertex));
        let anchor = space.position(wind.anchor);
        let shade = source.occlusion(vertex);
        colors.push([shade, shade, shade, 1.0]);
        uv0.push([uv.x, uv.y, weight, swing]);
        uv1.push([map.x, map.y, anchor.x, anchor.y]);
        uv2.push([position.x, position.y, position.z, anchor.z]);
        uv3.push(growth.as_ref().and_then(|growth| growth.get(vertex)).map_or(
            [0.0; 4],
            |&along| {
                let normal = source.surface.normals.get(vertex).copied().unwrap_or(Vec3::Y);
                let [along, normal] =
                    [along, normal].map(|v| direction::speedtree8(space.direction(v)));
                [wind.flutter, along, normal, LEAF]
            },
        ));
    }
    Ok(source.finish(vec![
        Stream::unorm8("COLOR", colors.into_iter()),
        Stream::f32("UV0", uv0.into_iter()),
        Stream::f32("UV1", uv1.into_iter()),
        Stream::f32("UV2", uv2.into_iter()),
        Stream::f32("UV3", uv3.into_iter()),
    ]))
}

/// Reads back: beside the common columns occlusion, `weights.x` (branch weight), `directions` (swing,
/// growth), flutter, anchors and kinds.
#[must_use]
pub fn unpack(packed: &Packed) -> Unpacked {
    let space = packed.space;
    let mut back = packed.unpack_common("UV0", "UV1");
    back.occlusion = packed.rows("COLOR").map(|color| color.x).collect();
    back.weights = packed.rows("UV0").map(|uv| Vec2::new(uv.z, 0.0)).collect();
    let decode = |value: f32| space.direction_back(direction::from_speedtree8(value));
    back.directions = packed
        .rows("UV0")
        .zip(packed.rows("UV3"))
        .map(|(uv0, uv3)| [decode(uv0.w), decode(uv3.y)])
        .collect();
    back.flutter = packed.rows("UV3").map(|uv| uv.x).collect();
    back.is_leaf = packed.rows("UV3").map(|uv| uv.w > 1.5).collect();
    back.anchors = packed
        .rows("UV1")
        .zip(packed.rows("UV2"))
        .map(|(uv1, uv2)| space.position_back(Vec3::new(uv1.z, uv1.w, uv2.w)))
        .collect();
    back
}
