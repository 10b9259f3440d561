//! A polygon tree becomes a skeleton and leaves: the way from a mesh back to a [`Tree`].
//!
//! Meshes of trees come as closed surfaces, as tubes stuck into each other, as thousands of
//! separate prisms, with cards or blobs for leaves, in any unit. All are read the same way:
//!
//! 1. `weld`: vertices at one place become one; everything is brought to unit size.
//! 2. `separate`: wood or leaves, by hint, name, alpha, or the shape of each connected component.
//! 3. `field`, `ends`, `slices`: over each connected piece of wood runs a distance field from its
//!    base, and its level lines, cut through the triangles, are the nodes (a Reeb graph).
//! 4. `trace`: radii, cleaned of bumps and of the bulges below forks; laterals start on the axis of
//!    their parent.
//! 5. `link`: pieces become one tree over the cheapest links from their ends.
//! 6. `assemble`: seen from the root, the lowest thick end.
//! 7. `leaves`: each leaf component becomes a leaf on the nearest wood. Closed bodies of leaves are
//!    counted, not turned into leaves.
//!
//! [`stages`] gives them one by one. Sources are named in the steps. Curve skeletons by level sets of a geodesic distance go back to
//! Verroust and Lazarus (2000); that a slicing plane need not stand across the axis is made up for
//! by measuring radii across it.
//!
//! # Complexity
//! O(n log n) in triangles; pieces run in parallel. The result is the same for any number of threads.

mod assemble;
mod ends;
mod field;
mod leaves;
mod link;
mod near;
mod params;
mod part;
mod rows;
mod scan;
mod separate;
mod shape;
mod slices;
pub mod stages;
mod surface;
mod trace;
mod weld;

pub use params::SkeletonizeParams;
pub use scan::{Bridge, ScanParams, ScanReport, Scanned, ScannedTree, skeletonize_scan};
pub use separate::Class;
pub use tree_core::{Hint, Part};

use crate::error::Result;
use stages::{Leaves, Separation};
use tree_core::{Control, Species, Tree};

/// A tree and what became of the mesh on the way.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Skeletonized {
    /// The tree, in the units of the mesh. Its bark is named after the part with most wood, leaf
    /// kinds after the parts their leaves come from.
    pub tree: Tree,
    /// Counts.
    pub report: SkeletonizeReport,
}

/// What was found in a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SkeletonizeReport {
    /// Triangles of all parts.
    pub n_triangles: usize,
    /// Triangles without area after welding, and second ones at one place in a part.
    pub n_degenerate: usize,
    /// Triangles of wood.
    pub n_wood_triangles: usize,
    /// Connected pieces of wood.
    pub n_pieces: usize,
    /// Pieces of wood too far from all others, left out.
    pub n_left_out: usize,
    /// Share of the wood's surface that the skeleton stands for, 0 to 1.
    pub covered: f32,
    /// Bumps of the bark dropped.
    pub n_bumps: usize,
    /// Branches cut where they had grown together.
    pub n_cut: usize,
    /// Leaves made.
    pub n_leaves: usize,
    /// Mean width of each leaf kind as a share of its length.
    pub leaf_widths: Vec<f32>,
    /// Closed bodies of leaves, for which nothing was made.
    pub n_blobs: usize,
}

/// Makes a tree of a mesh.
///
/// ```
/// use tree_model::glam::Vec3;
/// use tree_model::skeletonize::{Part, SkeletonizeParams, skeletonize};
/// use tree_model::tree_core::Control;
///
/// # fn main() -> Result<(), tree_model::ModelError> {
/// // A square post, ten times as high as wide: four sides, no caps.
/// let corner = |i: u32| {
///     Vec3::new((i % 4 / 2) as f32, 10.0 * (i / 4) as f32, ((i + 1) % 4 / 2) as f32)
/// };
/// let positions: Vec<Vec3> = (0..8).map(corner).collect();
/// let side = |i: u32| [i, (i + 1) % 4, i + 4, (i + 1) % 4, (i + 1) % 4 + 4, i + 4];
/// let indices: Vec<u32> = (0..4).flat_map(side).collect();
/// let post =
///     Part { positions: &positions, indices: &indices, name: "bark", ..Default::default() };
///
/// let made = skeletonize(&[post], &SkeletonizeParams::default(), &Control::default())?;
/// let skeleton = made.tree.skeleton();
/// assert!((skeleton.bounds().size().y - 10.0).abs() < 0.1);
/// // The circle round the corners: half the diagonal of the square.
/// assert!((skeleton.radii()[0] - 0.5_f32.sqrt()).abs() < 0.05);
/// assert_eq!(made.report.n_pieces, 1);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Parameter`](crate::ModelError::Parameter); [`BadPart`](crate::ModelError::BadPart) and
/// [`NotFinite`](crate::ModelError::NotFinite) for broken parts;
/// [`NoWood`](crate::ModelError::NoWood) where nothing looks like wood;
/// [`Limit`](crate::ModelError::Limit) for triangles, nodes or leaves;
/// [`Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(n log n) in triangles, about a microsecond a triangle and thread.
pub fn skeletonize(
    parts: &[Part<'_>],
    params: &SkeletonizeParams,
    control: &Control,
) -> Result<Skeletonized> {
    control.report("separate", 0.0)?;
    let separation = Separation::new(parts, params, control)?;
    control.report("follow", 0.3)?;
    let wood = separation.wood()?;
    let pieces = separation.follow_wood(&wood, params, control)?;
    control.report("link", 0.8)?;
    let linked = stages::link(&pieces, params, control)?;
    control.report("leaves", 0.9)?;
    let leaves = if params.leaves {
        separation.leaves(&linked.skeleton, control)?
    } else {
        Leaves::default()
    };
    let area = |reached: bool| -> f32 {
        let counts = pieces.iter().zip(&linked.reached);
        counts.filter(|(_, own)| **own || !reached).map(|(piece, _)| piece.area).sum()
    };
    let report = SkeletonizeReport {
        n_triangles: parts.iter().map(|part| part.indices.len() / 3).sum(),
        n_degenerate: separation.soup.n_degenerate,
        n_wood_triangles: wood.len(),
        n_pieces: pieces.len(),
        n_left_out: linked.reached.iter().filter(|&&reached| !reached).count(),
        covered: (area(true) / area(false)).min(1.0),
        n_bumps: pieces.iter().map(|piece| piece.n_bumps).sum(),
        n_cut: pieces.iter().map(|piece| piece.n_cut).sum(),
        n_leaves: leaves.foliage.len(),
        leaf_widths: leaves.widths,
        n_blobs: separation.are(Class::Blob).count(),
    };
    let bark = separation.bark().to_owned();
    let species = Species { name: "mesh".into(), bark, leaf_kinds: leaves.kinds };
    let tree = Tree::new(separation.outward(linked.skeleton)?, leaves.foliage, species)?;
    control.report("done", 1.0)?;
    Ok(Skeletonized { tree, report })
}

#[cfg(test)]
mod tests;
