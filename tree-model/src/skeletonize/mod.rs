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
//! Sources are named in the steps. Curve skeletons by level sets of a geodesic distance go back to
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
mod separate;
mod shape;
mod slices;
mod surface;
mod trace;
mod weld;

pub use params::SkeletonizeParams;
pub use part::{Hint, Part};
pub use separate::Class;

use crate::error::Result;
use rayon::prelude::*;
use separate::Separated;
use tree_core::{Control, Foliage, Species, Tree};
use weld::Soup;

/// Levels that cross an edge on average.
const DENSITY: f32 = 8.0;
/// A piece stands on the ground when its lowest vertex is within this share of the mesh's size of
/// the lowest wood.
const GROUND: f32 = 0.02;

/// A tree and what became of the mesh on the way.
#[derive(Clone, Debug, PartialEq)]
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
    params.validate()?;
    control.report("weld", 0.0)?;
    let soup = weld::weld(parts, params.weld, control)?;
    control.report("separate", 0.2)?;
    let separated = separate::separate(&soup, parts)?;
    control.report("follow", 0.3)?;
    let (pieces, areas) = follow(&soup, &separated.wood, params, control)?;
    control.report("link", 0.8)?;
    let forest = link::link(&pieces, params.bridge, control)?;
    let skeleton = assemble::assemble(&forest, control)?;
    control.report("leaves", 0.9)?;
    let (foliage, leaf_kinds, leaf_widths) = if params.leaves {
        leaves::leaves(&soup, &separated, parts, &skeleton, control)?
    } else {
        (Foliage::default(), Vec::new(), Vec::new())
    };
    let covered: f32 =
        areas.iter().zip(&forest.reached).filter(|(_, reached)| **reached).map(|(a, _)| a).sum();
    let report = SkeletonizeReport {
        n_triangles: parts.iter().map(|part| part.indices.len() / 3).sum(),
        n_degenerate: soup.n_degenerate,
        n_wood_triangles: separated.wood.len(),
        n_pieces: pieces.len(),
        n_left_out: forest.reached.iter().filter(|&&reached| !reached).count(),
        covered: (covered / areas.iter().sum::<f32>()).min(1.0),
        n_bumps: pieces.iter().map(|piece| piece.n_bumps).sum(),
        n_cut: pieces.iter().map(|piece| piece.n_cut).sum(),
        n_leaves: foliage.len(),
        leaf_widths,
        n_blobs: separated.classes.iter().filter(|&&class| class == Class::Blob).count(),
    };
    let species = Species { name: "mesh".into(), bark: bark(&soup, &separated, parts), leaf_kinds };
    let tree = Tree::new(assemble::outward(skeleton, &soup)?, foliage, species)?;
    control.report("done", 1.0)?;
    Ok(Skeletonized { tree, report })
}

/// Follows every piece of wood; with each, the area it stands for.
fn follow(
    soup: &Soup,
    wood: &[u32],
    params: &SkeletonizeParams,
    control: &Control,
) -> Result<(Vec<trace::Piece>, Vec<f32>)> {
    let groups = surface::connect(soup, wood);
    let height = |&triangle: &u32| {
        soup.corners(triangle).iter().fold(f32::INFINITY, |low, corner| low.min(corner.y))
    };
    let ground = wood.iter().map(height).fold(f32::INFINITY, f32::min) + GROUND;
    let found = (0..groups.len() as u32)
        .into_par_iter()
        .map(|group| {
            control.check()?;
            let triangles = groups.of(group);
            let corners = triangles.iter().map(|&triangle| soup.triangles[triangle as usize]);
            let surface = surface::Surface::new(&soup.positions, corners);
            let fans = surface.fans();
            let grounded = triangles.iter().any(|triangle| height(triangle) < ground);
            let distances = ends::from_base(&surface, &fans, grounded);
            control.check()?;
            let slices = slices::Slices::new(&surface, &distances, DENSITY);
            let pieces = trace::trace(&slices, params);
            let area = shape::Shape::of(triangles.iter().map(|&t| soup.corners(t))).area;
            Ok((pieces, area))
        })
        .collect::<Result<Vec<_>>>()?;
    let n_nodes: usize = found.iter().flat_map(|(p, _)| p).map(|piece| piece.parents.len()).sum();
    control.limits.check(tree_core::Resource::Nodes, n_nodes as u64)?;
    let (mut pieces, mut areas) = (Vec::new(), Vec::new());
    for (of_group, area) in found {
        let share = area / of_group.len().max(1) as f32;
        areas.extend(of_group.iter().map(|_| share));
        pieces.extend(of_group);
    }
    Ok((pieces, areas))
}

/// The name of the part with most wood.
fn bark(soup: &Soup, separated: &Separated, parts: &[Part<'_>]) -> String {
    let mut areas = vec![0.0; parts.len()];
    for (component, (class, shape)) in (0..).zip(separated.classes.iter().zip(&separated.shapes)) {
        if let (Class::Wood, Some(&first)) = (class, separated.triangles.of(component).first()) {
            areas[soup.sources[first as usize].0 as usize] += shape.area;
        }
    }
    let most = (0..parts.len()).reduce(|a, b| if areas[b] > areas[a] { b } else { a });
    most.and_then(|part| parts.get(part)).map_or("bark", |part| part.name).to_owned()
}

#[cfg(test)]
mod tests;
