//! Unreal's Pivot Painter 2: two textures with a texel for each element, and a UV set that names it.
//!
//! | stream | numbers | x | y | z | w |
//! |---|---|---|---|---|---|
//! | `POSITION` | 3 × f32 | centimetres, Unreal's axes | | | |
//! | `NORMAL` | 3 × f32 | | | | |
//! | `TANGENT` | 4 × f32 | | | | sign |
//! | `COLOR` | 4 × unorm8 | occlusion | flutter | leaf phase | 1 |
//! | `UV0` | 2 × f32 | u | v | | |
//! | `UV1` | 2 × f32 | light map u | light map v | | |
//! | `UV2` | 2 × f32 | the element's texel u | v | | |
//!
//! | texture | texel | r, g, b | a |
//! |---|---|---|---|
//! | position and index | 4 × f32, or half | pivot, centimetres | parent's number, by [`index_bits`] |
//! | axis and extent | 4 × unorm8 | (axis + 1) / 2 | extent / 2048 cm |
//!
//! Elements lie in rows from the top left, as their branches do in the table. The trunk is its own
//! parent. The encodings are those of Epic's `PivotPainter2.ms` and of its ports to Blender: the
//! parent's number + 1024 as the bits of a half, so that it survives textures of 16 bits; extents in
//! steps of 8 cm, from 8 to 2048.
//!
//! Epic's material functions follow at most 4 levels, and a half names at most 30,720 elements. Deeper
//! branches become part of the one that carries them, level by level; the [`PivotReport`] says how many.
//!
//! Unpacked: numbers exact; pivots within a rounding (2⁻¹¹ of them as halves); axes within 0.008
//! radians; extents within 4.1 cm between 8 and 2048 cm; occlusion, flutter and phase within 1/510.

use super::common::Source;
use super::{Packed, Stream, Unpacked, half};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;
use crate::wind::Branch;
use glam::{Vec2, Vec3};

/// Levels that Epic's material functions follow.
pub const MAX_LEVELS: u32 = 4;
/// Elements that the bits of a finite half, less the 1024 of subnormal numbers, can name.
pub const MAX_ELEMENTS: usize = 0x7C00 - 1024;
/// Longest extent in centimetres.
const EXTENT_MAX: f32 = 2048.0;
/// Steps of the extent.
const EXTENT_STEPS: f32 = 256.0;

/// What did not fit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PivotReport {
    /// Levels of the mesh.
    pub levels: u32,
    /// Levels that are left, at most 4.
    pub kept_levels: u32,
    /// Texels in use.
    pub elements: usize,
    /// Branches that became part of the one that carries them.
    pub merged: usize,
}

/// The textures, shared by all surfaces of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Textures {
    /// Width in texels, a power of two.
    pub width: u32,
    /// Height in texels, a power of two.
    pub height: u32,
    /// Pivot and parent, row by row from the top.
    pub position_and_index: Vec<[f32; 4]>,
    /// Axis and extent, row by row from the top.
    pub axis_and_extent: Vec<[u8; 4]>,
    /// What did not fit.
    pub report: PivotReport,
    /// The element of each branch of the table.
    element_of: Vec<u32>,
}

/// A texture's texel, read back in our axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// The element that carries it; itself for the trunk.
    pub parent: u32,
    /// Pivot in metres.
    pub pivot: Vec3,
    /// Axis, a unit vector.
    pub axis: Vec3,
    /// Length in metres, 0.08 to 20.48.
    pub extent: f32,
}

/// An element's number as a float whose half has the bits `number + 1024`; above 30,719 not finite.
#[must_use]
pub fn index_bits(number: u32) -> f32 {
    half::to_f32(u16::try_from(number.saturating_add(1024)).unwrap_or(u16::MAX))
}

/// The number of [`index_bits`], read as the shader does: the bits of the half, less 1024.
#[must_use]
pub fn from_index_bits(value: f32) -> u32 {
    u32::from(half::from_f32(value)).saturating_sub(1024)
}

impl Textures {
    /// Makes the textures of a mesh.
    ///
    /// # Errors
    /// As [`Mesh::check_branches`].
    ///
    /// # Complexity
    /// O(branches).
    pub fn new(mesh: &Mesh) -> Result<Self> {
        mesh.check_branches()?;
        let branches = &mesh.branches;
        let levels = branches
            .iter()
            .map(|branch| branch.level)
            .max()
            .map_or(0, |level| level.saturating_add(1));
        let fits = |kept: u32| {
            branches.iter().filter(|branch| branch.level < kept).count() <= MAX_ELEMENTS
        };
        let kept_levels = (1..=levels.min(MAX_LEVELS)).rev().find(|&kept| fits(kept)).unwrap_or(0);
        let mut element_of: Vec<u32> = Vec::with_capacity(branches.len());
        let mut elements: Vec<&Branch> = Vec::new();
        for branch in branches {
            // Parents come first, so only the first branch finds none.
            let below = element_of.get(branch.parent as usize).copied();
            element_of.push(match below {
                Some(below) if branch.level >= kept_levels => below,
                _ => {
                    elements.push(branch);
                    elements.len() as u32 - 1
                }
            });
        }
        let side = (elements.len().max(1) as f32).sqrt().ceil() as usize;
        let width = side.next_power_of_two();
        let height = elements.len().div_ceil(width).max(1).next_power_of_two();
        let space = Convention::Unreal;
        let mut position_and_index = vec![[0.0; 4]; width * height];
        let mut axis_and_extent = vec![[0; 4]; width * height];
        let texels = position_and_index.iter_mut().zip(&mut axis_and_extent);
        for (branch, (pivot, axis)) in elements.iter().zip(texels) {
            let parent = element_of.get(branch.parent as usize).copied().unwrap_or(0);
            *pivot = space.position(branch.pivot).extend(index_bits(parent)).to_array();
            let extent = (branch.length * space.unit() / EXTENT_MAX).clamp(1.0 / EXTENT_STEPS, 1.0);
            let turned = space.direction(branch.axis) * 0.5 + 0.5;
            *axis = turned.extend(extent).to_array().map(half::byte);
        }
        let report = PivotReport {
            levels,
            kept_levels,
            elements: elements.len(),
            merged: branches.len() - elements.len(),
        };
        let (width, height) = (width as u32, height as u32);
        Ok(Self { width, height, position_and_index, axis_and_extent, report, element_of })
    }

    /// The first texture with 16 bits a number. The parents' numbers are exact in it too.
    #[must_use]
    pub fn position_and_index_half(&self) -> Vec<[u16; 4]> {
        self.position_and_index.iter().map(|texel| texel.map(half::from_f32)).collect()
    }

    /// The middle of an element's texel.
    fn uv(&self, element: u32) -> Vec2 {
        let (column, row) = (element % self.width.max(1), element / self.width.max(1));
        Vec2::new(
            (column as f32 + 0.5) / self.width.max(1) as f32,
            (row as f32 + 0.5) / self.height.max(1) as f32,
        )
    }

    /// The element whose texel lies at these coordinates, as a shader without filtering reads it.
    #[must_use]
    pub fn element_at(&self, uv: Vec2) -> Option<u32> {
        let (column, row) = (uv.x * self.width as f32, uv.y * self.height as f32);
        let inside = column < self.width as f32 && row < self.height as f32;
        if !(column >= 0.0 && row >= 0.0 && inside) {
            return None;
        }
        let element = row as u32 * self.width + column as u32;
        ((element as usize) < self.report.elements).then_some(element)
    }

    /// An element, read back.
    #[must_use]
    pub fn element(&self, number: u32) -> Option<Element> {
        let &[x, y, z, index] = self.position_and_index.get(number as usize)?;
        let [r, g, b, a] = self.axis_and_extent.get(number as usize)?.map(half::from_byte);
        let space = Convention::Unreal;
        Some(Element {
            parent: from_index_bits(index),
            pivot: space.position_back(Vec3::new(x, y, z)),
            axis: space.direction_back(Vec3::new(r, g, b) * 2.0 - 1.0).normalize_or(Vec3::Y),
            extent: a * EXTENT_MAX / space.unit(),
        })
    }

    /// The element of a branch of the table: its own, or that of the branch it became part of.
    #[must_use]
    pub fn element_of(&self, branch: u32) -> Option<u32> {
        self.element_of.get(branch as usize).copied()
    }
}

/// Packs a surface to go with the textures of its mesh.
///
/// # Errors
/// As [`Mesh::check`], of this surface.
pub fn pack(mesh: &Mesh, surface: usize, textures: &Textures) -> Result<Packed> {
    let source = Source::new(mesh, surface, Convention::Unreal)?;
    let rows = 0..source.len();
    let colors = source
        .wind
        .iter()
        .enumerate()
        .map(|(vertex, wind)| [source.occlusion(vertex), wind.flutter, wind.leaf_phase, 1.0]);
    let texels = source
        .wind
        .iter()
        .map(|wind| textures.uv(textures.element_of(wind.branch).unwrap_or(0)).to_array());
    Ok(source.finish(vec![
        Stream::unorm8("COLOR", colors),
        Stream::f32("UV0", rows.clone().map(|vertex| source.uv(vertex).to_array())),
        Stream::f32("UV1", rows.map(|vertex| source.uv2(vertex).to_array())),
        Stream::f32("UV2", texels),
    ]))
}

/// Reads back: beside the common columns occlusion, flutter, leaf phases, and of the elements (in
/// `branches` their numbers) parents, pivots and axes.
#[must_use]
pub fn unpack(packed: &Packed, textures: &Textures) -> Unpacked {
    let mut back = packed.unpack_common("UV0", "UV1");
    back.occlusion = packed.rows("COLOR").map(|color| color.x).collect();
    back.flutter = packed.rows("COLOR").map(|color| color.y).collect();
    back.leaf_phases = packed.rows("COLOR").map(|color| color.z).collect();
    for uv in packed.rows("UV2") {
        let number = textures.element_at(Vec2::new(uv.x, uv.y));
        if let Some((number, element)) = number.and_then(|n| Some((n, textures.element(n)?))) {
            back.branches.push(number);
            back.parents.push(element.parent);
            back.pivots.push(element.pivot);
            back.axes.push(element.axis);
        }
    }
    back
}
