//! A laser scan becomes a skeleton: from a cloud of points to axes with radii.
//!
//! 1. `clean`: finite points, each place once, metres, y up.
//! 2. `ground`: the ground, where the scan shows some, is taken away.
//! 3. `graph`: arcs to the nearest points; pieces that shadows tore off are joined by bridges.
//! 4. `base`, `reach`: where the tree stands, or all trees, and the shortest ways there.
//! 5. `levels`: clusters of points at equal distances from the base (Verroust and Lazarus 2000; Xu,
//!    Gossett and Chen 2007).
//! 6. `axes`: the longest way is the first axis, and takes in what runs beside it (Sato et al. 2000).
//! 7. `wood`, `circle`: centres and radii by robust circles, elsewhere by the pipe model; where foliage begins.
//! 8. `assemble`: skeletons.
//!
//! Others build one minimum spanning tree of all points (Livny et al. 2010; Du et al. 2019, `AdTree`) or
//! cylinders in cover sets (Raumonen et al. 2013, `TreeQSM`). Levels put nodes at the middle of thick
//! wood at once, where spanning trees run along its surface.
//!
//! Leaves are not made: what hangs in foliage is told from wood by its clusters, which are wide, but
//! not hollow. Branches there follow the ways through the leaves, as in the papers above, and are marked
//! ([`ScannedTree::in_foliage`]).
//!
//! # Complexity
//! O(n log n) in points. The result is the same for any number of threads.

mod assemble;
mod axes;
mod base;
mod circle;
mod clean;
mod graph;
mod ground;
mod kd;
mod levels;
mod params;
mod reach;
mod report;
mod wood;

pub use params::ScanParams;
pub use report::{Bridge, ScanReport};

use crate::error::{ModelError, Result};
use glam::{DVec3, Vec3};
use tree_core::{Control, Resource, Skeleton};

/// No wood is wider than this share of a tree's height, in mean distance from its axis.
const WIDEST: f32 = 0.04;

/// A tree of a cloud.
#[derive(Clone, Debug, PartialEq)]
pub struct ScannedTree {
    /// Its skeleton in metres, y up, the base at the origin.
    pub skeleton: Skeleton,
    /// Where that base is in the cloud, in its axes and unit.
    pub base: DVec3,
    /// Nodes that run through foliage: guessed, not seen.
    pub in_foliage: Vec<bool>,
}

/// Trees and what became of the cloud on the way.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Scanned {
    /// One tree, or with [`ScanParams::several`] all of them.
    pub trees: Vec<ScannedTree>,
    /// Counts.
    pub report: ScanReport,
}

/// Makes skeletons of a cloud of points.
///
/// ```
/// use tree_model::glam::DVec3;
/// use tree_model::skeletonize::{ScanParams, skeletonize_scan};
/// use tree_model::tree_core::Control;
///
/// # fn main() -> Result<(), tree_model::ModelError> {
/// // A post, two metres high and ten centimetres thick; clouds are z up unless said otherwise.
/// let place = |i: u32| {
///     let (sin, cos) = (f64::from(i) * 0.7).sin_cos();
///     DVec3::new(430_000.0 + 0.05 * cos, 0.05 * sin, 0.002 * f64::from(i))
/// };
/// let points: Vec<DVec3> = (0..1000).map(place).collect();
///
/// let made = skeletonize_scan(&points, &ScanParams::default(), &Control::default())?;
/// let tree = &made.trees[0];
/// assert!((tree.skeleton.bounds().size().y - 2.0).abs() < 0.1);
/// assert!((tree.skeleton.radii()[0] - 0.05).abs() < 0.005);
/// assert!((tree.base.x - 430_000.0).abs() < 0.01);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Parameter`](crate::ModelError::Parameter); [`Cloud`](crate::ModelError::Cloud) for fewer than 16
/// points that are numbers and differ, or all at one place or on one line, or too far apart;
/// [`NoBase`](crate::ModelError::NoBase) where no tree stands; [`Limit`](crate::ModelError::Limit) for
/// graph nodes, arcs or nodes; [`Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(n log n) in points, some four microseconds a point.
pub fn skeletonize_scan(
    points: &[DVec3],
    params: &ScanParams,
    control: &Control,
) -> Result<Scanned> {
    params.validate()?;
    control.report("clean", 0.0)?;
    let mut report = ScanReport { n_points: points.len(), ..ScanReport::default() };
    let clean = clean::clean(points, params, &mut report, control)?;
    control.report("ground", 0.2)?;
    let (clean, heights) = above_ground(clean, params, &mut report)?;
    let (points, spacing) = (clean.kd.points(), clean.spacing);
    let size = size(points);
    control.report("graph", 0.25)?;
    let mut graph = graph::near(&clean.kd, spacing, params, control)?;
    let widest = params.bridge * size.max_element();
    graph::bridge(&mut graph, &clean.kd, spacing, widest, &mut report, control)?;
    control.report("ways", 0.6)?;
    let cloud = base::Cloud { graph: &graph, points, heights: &heights, spacing };
    let (bases, ways, n_bases) = if params.several { cloud.several()? } else { cloud.one()? };
    report.n_bases = n_bases;
    report.n_left_out = points.len() - ways.order.len();
    control.report("axes", 0.75)?;
    let step = params.step * spacing;
    let clusters = levels::clusters(&graph, points, &ways, step, WIDEST * size.y);
    report.n_clusters = clusters.centers.len();
    let length = params.prune * spacing;
    let taking = axes::Taking { widths: params.merge, beyond: spacing, length, step };
    let axes = axes::axes(&clusters, taking);
    report.n_short = axes.n_short;
    report.n_nodes = axes.axes.iter().map(|axis| axis.clusters.len()).sum();
    control.limits.check(Resource::Nodes, report.n_nodes as u64)?;
    control.report("wood", 0.8)?;
    let wood = wood::wood(&axes, &clusters, points, spacing);
    report.n_fitted = wood.n_fitted;
    let mut trees = Vec::new();
    for base in 0..bases.len() as u32 {
        let (tree, n_in_foliage) = assemble::tree(&axes, &clusters, &wood, base, &clean, params)?;
        report.n_in_foliage += n_in_foliage;
        trees.extend(tree);
    }
    control.report("done", 1.0)?;
    Ok(Scanned { trees, report })
}

/// Takes the ground away; the heights of points are those above it.
fn above_ground(
    mut clean: clean::Clean,
    params: &ScanParams,
    report: &mut ScanReport,
) -> Result<(clean::Clean, Vec<f32>)> {
    let points = clean.kd.points();
    let ground = params.ground.then(|| ground::Ground::find(points, clean.spacing)).flatten();
    let Some(ground) = ground else {
        let heights = points.iter().map(|p| p.y).collect();
        return Ok((clean, heights));
    };
    let above: Vec<Vec3> = points.iter().copied().filter(|&p| !ground.holds(p)).collect();
    report.n_ground = points.len() - above.len();
    if above.len() < clean::POINTS_MIN {
        return Err(ModelError::NoBase { problem: "all points belong to the ground" });
    }
    clean.kd = kd::Kd::new(&above);
    let heights = clean.kd.points().iter().map(|&p| p.y - ground.height(p)).collect();
    Ok((clean, heights))
}

/// Extent of some points.
fn size(points: &[Vec3]) -> Vec3 {
    let ends = points
        .iter()
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    (ends.1 - ends.0).max(Vec3::ZERO)
}

#[cfg(test)]
mod tests;
