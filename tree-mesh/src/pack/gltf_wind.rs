//! glTF: attributes `_WIND*`, for engines that read glTF and have wind shaders of their own.
//!
//! glTF 2.0 (section 3.7.2.1) lets applications add attributes whose names begin with an underscore,
//! of any component type but 32-bit integers; numbers of branches are therefore cut in halves of 16
//! bits. Nothing else of the file changes: viewers that know nothing of wind ignore them.
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | metres | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR_0` | 4 × unorm8 | occlusion | occlusion | occlusion | 1 |
//! | `TEXCOORD_0` | 2 × f32 | u | v | | |
//! | `TEXCOORD_1` | 2 × f32 | light map u | light map v | | |
//! | `_WIND_PIVOT` | 3 × f32 | pivot x | y | z | |
//! | `_WIND_AXIS` | 3 × f32 | axis x | y | z | |
//! | `_WIND` | 4 × f32 | reach | phase | stiffness | length in m |
//! | `_WIND_LEAF` | 4 × f32 | flutter | leaf phase | level | 1 for leaves |
//! | `_WIND_ANCHOR` | 3 × f32 | anchor x | y | z | |
//! | `_WIND_BRANCH` | 4 × u16 | branch low | branch high | parent low | parent high |
//!
//! Unpacked: floats exact, occlusion within 1/510.
//!
//! Our own writer takes them as [`attributes`]. Blender (5.0.1) mixes up attributes of one mesh that
//! begin with `_` and differ in their number of components, and refuses some such files: there all are
//! padded to four, and occlusion should go into the file as
//! [`OcclusionAs::Color`](crate::io::gltf::OcclusionAs::Color) or
//! [`OcclusionAs::Omit`](crate::io::gltf::OcclusionAs::Omit), since `_OCCLUSION` is a single number.
//! Whoever writes the streams above with a writer of his own, for Blender too, should pad them likewise.

use super::common::Source;
use super::{Data, Packed, Stream, Unpacked};
use crate::convert::Convention;
use crate::error::Result;
#[cfg(feature = "gltf")]
use crate::io::gltf::Attribute;
use crate::mesh::Mesh;
use glam::Vec4;

/// The attributes that are not glTF's own, in the order in which they are written.
pub const ATTRIBUTES: [&str; 6] =
    ["_WIND_PIVOT", "_WIND_AXIS", "_WIND", "_WIND_LEAF", "_WIND_ANCHOR", "_WIND_BRANCH"];

/// Packs a surface.
///
/// # Errors
/// As [`Mesh::check`], of this surface.
pub fn pack(mesh: &Mesh, surface: usize) -> Result<Packed> {
    let source = Source::new(mesh, surface, Convention::Gltf)?;
    let own = || source.wind.iter().map(|wind| (wind, source.branch(wind.branch)));
    let rows = 0..source.len();
    let shades = rows.clone().map(|vertex| source.occlusion(vertex));
    let leaf = f32::from(u8::from(source.is_leaves()));
    let halves = |number: u32| [number as u16, (number >> 16) as u16];
    let numbers = own()
        .flat_map(|(wind, branch)| halves(wind.branch).into_iter().chain(halves(branch.parent)));
    let numbers = Data::U16(numbers.collect());
    Ok(source.finish(vec![
        Stream::unorm8("COLOR_0", shades.map(|shade| [shade, shade, shade, 1.0])),
        Stream::f32("TEXCOORD_0", rows.clone().map(|vertex| source.uv(vertex).to_array())),
        Stream::f32("TEXCOORD_1", rows.map(|vertex| source.uv2(vertex).to_array())),
        Stream::f32("_WIND_PIVOT", own().map(|(_, branch)| branch.pivot.to_array())),
        Stream::f32("_WIND_AXIS", own().map(|(_, branch)| branch.axis.to_array())),
        Stream::f32(
            "_WIND",
            own().map(|(wind, branch)| [wind.reach, branch.phase, branch.stiffness, branch.length]),
        ),
        Stream::f32(
            "_WIND_LEAF",
            own().map(|(wind, branch)| [wind.flutter, wind.leaf_phase, branch.level as f32, leaf]),
        ),
        Stream::f32("_WIND_ANCHOR", own().map(|(wind, _)| wind.anchor.to_array())),
        Stream { name: "_WIND_BRANCH", components: 4, data: numbers },
    ]))
}

/// The attributes [`ATTRIBUTES`] of a surface for [`Level::attributes`](crate::io::gltf::Level): four
/// floats each, the missing ones 0, which every reader takes.
///
/// ```
/// # use tree_core::{Control, Skeleton, Species, Tree, glam::Vec3};
/// # use tree_mesh::{Look, MeshParams, build};
/// use tree_mesh::io::gltf::{GlbOptions, Level, OcclusionAs, to_glb_levels};
/// use tree_mesh::pack::gltf_wind;
/// # let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
/// # builder.add(0, Vec3::Y * 3.0, 0.1)?;
/// # let tree = Tree::bare(builder.finish(), Species::default());
/// # let look = Look::plain(tree.species());
/// let mesh = build(&tree, &look, &MeshParams::default(), &Control::default())?.mesh;
/// let attributes = gltf_wind::attributes(&mesh, 0)?;
/// assert!(attributes.iter().all(|attribute| attribute.components == 4));
/// let level = Level { attributes: &attributes, ..Level::from(&mesh) };
/// let options = GlbOptions { occlusion: OcclusionAs::Color, ..Default::default() };
/// assert!(to_glb_levels(&[level], &options).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`pack`].
#[cfg(feature = "gltf")]
pub fn attributes(mesh: &Mesh, surface: usize) -> Result<Vec<Attribute>> {
    let packed = pack(mesh, surface)?;
    let own = packed.streams.iter().filter(|stream| ATTRIBUTES.contains(&stream.name));
    let attribute = |stream: &Stream| Attribute {
        surface,
        name: stream.name.into(),
        components: 4,
        values: packed.rows(stream.name).flat_map(|row| row.to_array()).collect(),
    };
    Ok(own.map(attribute).collect())
}

/// Reads back: all columns but weights and directions.
#[must_use]
pub fn unpack(packed: &Packed) -> Unpacked {
    let mut back = packed.unpack_common("TEXCOORD_0", "TEXCOORD_1");
    let whole = |low: f32, high: f32| low as u32 | (high as u32) << 16;
    let numbers = || packed.rows("_WIND_BRANCH");
    back.occlusion = packed.rows("COLOR_0").map(|color| color.x).collect();
    back.pivots = packed.rows("_WIND_PIVOT").map(Vec4::truncate).collect();
    back.axes = packed.rows("_WIND_AXIS").map(Vec4::truncate).collect();
    back.reach = packed.rows("_WIND").map(|wind| wind.x).collect();
    back.phases = packed.rows("_WIND").map(|wind| wind.y).collect();
    back.stiffness = packed.rows("_WIND").map(|wind| wind.z).collect();
    back.flutter = packed.rows("_WIND_LEAF").map(|leaf| leaf.x).collect();
    back.leaf_phases = packed.rows("_WIND_LEAF").map(|leaf| leaf.y).collect();
    back.levels = packed.rows("_WIND_LEAF").map(|leaf| leaf.z as u32).collect();
    back.is_leaf = packed.rows("_WIND_LEAF").map(|leaf| leaf.w > 0.5).collect();
    back.anchors = packed.rows("_WIND_ANCHOR").map(Vec4::truncate).collect();
    back.branches = numbers().map(|n| whole(n.x, n.y)).collect();
    back.parents = numbers().map(|n| whole(n.z, n.w)).collect();
    back
}
