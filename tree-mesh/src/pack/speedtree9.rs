//! Unity's SpeedTree 9 layout.
//!
//! As written by Unity's `SpeedTree9Importer` (`CalculateMeshGeometry`) and read by its
//! `SpeedTree9Wind.hlsl`:
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | metres, Unity's axes | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR` | 4 × unorm8 | occlusion | occlusion | occlusion | blend, 1 |
//! | `UV0` | 4 × f32 | u | v | branch 1 noise | branch 1 direction |
//! | `UV1` | 4 × f32 | light map u | light map v | branch 1 weight | ripple weight |
//! | `UV2` | 4 × f32 | branch 2 noise | branch 2 direction | branch 2 weight | 0 |
//! | `UV3` | 4 × f32 | anchor x | anchor y | anchor z | faces the camera, 0 |
//!
//! * Branch 1 is the bough a vertex hangs on, branch 2 the branch on that bough (levels 1 and 2); wood
//!   of higher levels and leaves move with these two. The trunk moves by height, by the shader.
//! * The shader turns a vertex about `position − direction × weight × stretch limit`. So the weight is
//!   [`reach`](crate::wind::Branch::reach) × length over the limit of the tree, [`StretchLimits`], which belongs
//!   into `_ST_BranchStretchLimits`, and the direction points from the pivot to the vertex.
//! * Noise: the direction the branch swings in, as a place in the noise: other branches, other places.
//! * Ripple weight: the flutter of leaves.
//!
//! Unpacked: all floats within a rounding, occlusion within 1/510, directions within 0.03 radians.

use super::common::Source;
use super::{Packed, Stream, Unpacked, direction};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;
use crate::wind::VertexWind;
use glam::{Vec2, Vec3};

/// `_ST_BranchStretchLimits`: the longest free lengths of branches 1 and 2, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StretchLimits {
    /// Of branches at level 1.
    pub branch1: f32,
    /// Of branches at level 2.
    pub branch2: f32,
}

impl StretchLimits {
    /// The limits of a mesh; the same for all its surfaces.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let longest = |level: u32| {
            let there = mesh.branches.iter().filter(|branch| branch.level == level);
            there.fold(0.0_f32, |longest, branch| longest.max(branch.length - branch.collar))
        };
        Self { branch1: longest(1), branch2: longest(2) }
    }
}

/// The branches of a level, for each branch the one that carries it.
struct Level {
    carriers: Vec<Option<u32>>,
    /// The longest free length of the level, in metres.
    limit: f32,
}

impl Level {
    /// Noise, direction and weight of the branch that carries a vertex.
    fn of(&self, source: &Source<'_>, wind: &VertexWind) -> [f32; 3] {
        let Some(number) = self.carriers.get(wind.branch as usize).copied().flatten() else {
            return [direction::speedtree9(Vec3::Y), direction::speedtree9(Vec3::Y), 0.0];
        };
        let branch = source.branch(number);
        let weight = if self.limit > 0.0 {
            branch.reach(wind.anchor) * (branch.length - branch.collar) / self.limit
        } else {
            0.0
        };
        let along = (wind.anchor - branch.pivot).normalize_or(branch.axis);
        let [noise, along] = [branch.swing(), along].map(|v| source.space.direction(v));
        [direction::speedtree9(noise), direction::speedtree9(along), weight]
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
    let limits = StretchLimits::of(mesh);
    let level = |level, limit| Level { carriers: source.ancestors(level), limit };
    let [first, second] = [level(1, limits.branch1), level(2, limits.branch2)];
    let (mut colors, mut uv0, mut uv1) = (Vec::new(), Vec::new(), Vec::new());
    let (mut uv2, mut uv3) = (Vec::new(), Vec::new());
    for (vertex, wind) in source.wind.iter().enumerate() {
        let [noise1, along1, weight1] = first.of(&source, wind);
        let [noise2, along2, weight2] = second.of(&source, wind);
        let (uv, map) = (source.uv(vertex), source.uv2(vertex));
        let anchor = source.space.position(wind.anchor);
        let shade = source.occlusion(vertex);
        colors.push([shade, shade, shade, 1.0]);
        uv0.push([uv.x, uv.y, noise1, along1]);
        uv1.push([map.x, map.y, weight1, wind.flutter]);
        uv2.push([noise2, along2, weight2, 0.0]);
        uv3.push([anchor.x, anchor.y, anchor.z, 0.0]);
    }
    Ok(source.finish(vec![
        Stream::unorm8("COLOR", colors.into_iter()),
        Stream::f32("UV0", uv0.into_iter()),
        Stream::f32("UV1", uv1.into_iter()),
        Stream::f32("UV2", uv2.into_iter()),
        Stream::f32("UV3", uv3.into_iter()),
    ]))
}

/// Reads back: beside the common columns occlusion, `weights` (of branches 1 and 2), `directions`
/// (likewise), flutter and anchors.
#[must_use]
pub fn unpack(packed: &Packed) -> Unpacked {
    let space = packed.space;
    let mut back = packed.unpack_common("UV0", "UV1");
    let decode = |value: f32| space.direction_back(direction::from_speedtree9(value));
    back.occlusion = packed.rows("COLOR").map(|color| color.x).collect();
    back.flutter = packed.rows("UV1").map(|uv| uv.w).collect();
    let weights = packed.rows("UV1").zip(packed.rows("UV2"));
    back.weights = weights.map(|(one, two)| Vec2::new(one.z, two.z)).collect();
    let along = packed.rows("UV0").zip(packed.rows("UV2"));
    back.directions = along.map(|(one, two)| [decode(one.w), decode(two.y)]).collect();
    back.anchors =
        packed.rows("UV3").map(|anchor| space.position_back(anchor.truncate())).collect();
    back
}
