//! A laser scan becomes a skeleton: from a cloud of points to axes with radii.

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

pub use params::{ScanParams, Up};
pub use report::{Bridge, ScanReport};

use crate::error::Result;
use glam::{DVec3, Vec3};
use tree_core::{Control, Resource, Skeleton};

/// A tree of a cloud.
#[derive(Clone, Debug, PartialEq)]
pub struct ScannedTree {
    /// Its skeleton in metres, y up, the base at the origin.
    pub skeleton: Skeleton,
    /// Where that base is in the cloud, in its axes and unit.
    pub base: DVec3,
}

/// Trees and what became of the cloud on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Scanned {
    /// One tree, or with [`ScanParams::several`] all of them.
    pub trees: Vec<ScannedTree>,
    /// Counts.
    pub report: ScanReport,
}

/// Makes skeletons of a cloud of points.
///
/// # Errors
/// TODO
pub fn skeletonize_scan(
    points: &[DVec3],
    params: &ScanParams,
    control: &Control,
) -> Result<Scanned> {
    params.validate()?;
    let t=std::time::Instant::now();
    control.report("clean", 0.0)?;
    let mut report = ScanReport { n_points: points.len(), ..ScanReport::default() };
    let mut clean = clean::clean(points, params, &mut report, control)?;
    eprintln!("clean {:?}", t.elapsed());
    control.report("ground", 0.1)?;
    let mut heights: Vec<f32> = clean.kd.points().iter().map(|p| p.y).collect();
    if params.ground
        && let Some(ground) = ground::Ground::find(clean.kd.points(), clean.spacing)
    {
        let above: Vec<Vec3> =
            clean.kd.points().iter().copied().filter(|&p| !ground.holds(p)).collect();
        report.n_ground = heights.len() - above.len();
        clean.kd = kd::Kd::new(&above);
        heights = clean.kd.points().iter().map(|&p| p.y - ground.height(p)).collect();
    }
    let points = clean.kd.points();
    control.report("graph", 0.2)?;
    let mut graph = graph::near(&clean.kd, clean.spacing, params, control)?;
    eprintln!("graph {:?}", t.elapsed());
    graph::bridge(&mut graph, &clean.kd, clean.spacing, params, &mut report, control)?;
    eprintln!("bridge {:?}", t.elapsed());
    control.report("ways", 0.5)?;
    let cloud =
        base::Cloud { graph: &graph, points, heights: &heights, spacing: clean.spacing };
    let (bases, ways, n_bases) = if params.several { cloud.several()? } else { cloud.one()? };
    eprintln!("ways {:?}", t.elapsed());
    report.n_bases = n_bases;
    report.n_left_out = points.len() - ways.order.len();
    control.report("axes", 0.7)?;
    let step = params.step * clean.spacing;
    let clusters = levels::clusters(&graph, points, &ways, step);
    eprintln!("levels {:?}", t.elapsed());
    report.n_clusters = clusters.centres.len();
    let taking = axes::Taking {
        widths: params.merge,
        beyond: clean.spacing,
        length: params.prune * clean.spacing,
        step,
    };
    let axes = axes::axes(&clusters, taking);
    eprintln!("axes {:?}", t.elapsed());
    report.n_short = axes.n_short;
    report.n_nodes = axes.axes.iter().map(|axis| axis.clusters.len()).sum();
    control.limits.check(Resource::Nodes, report.n_nodes as u64)?;
    let wood = wood::wood(&axes, &clusters, points, clean.spacing);
    eprintln!("wood {:?}", t.elapsed());
    report.n_fitted = wood.n_fitted;
    let mut trees = Vec::new();
    for base in 0..bases.len() as u32 {
        if let Some(tree) = assemble(&axes, &clusters, &wood, base, &clean, params)? {
            trees.push(tree);
        }
    }
    control.report("done", 1.0)?;
    Ok(Scanned { trees, report })
}

fn assemble(
    axes: &axes::Axes,
    clusters: &levels::Clusters,
    wood: &wood::Wood,
    base: u32,
    clean: &clean::Clean,
    params: &ScanParams,
) -> Result<Option<ScannedTree>> {
    let (mut positions, mut radii, mut parents) = (Vec::new(), Vec::new(), Vec::new());
    let mut firsts = vec![reach::NONE; axes.axes.len()];
    for (number, axis) in axes.axes.iter().enumerate() {
        if clusters.base[axis.clusters[0] as usize] != base {
            continue;
        }
        firsts[number] = positions.len() as u32;
        let mut parent = axis.host.map_or(reach::NONE, |(axis, place)| firsts[axis as usize] + place);
        for (&centre, &radius) in wood.centres[number].iter().zip(&wood.radii[number]) {
            positions.push(centre);
            radii.push(radius);
            parents.push(parent);
            parent = positions.len() as u32 - 1;
        }
    }
    let Some(&root) = positions.first() else { return Ok(None) };
    positions.iter_mut().for_each(|p| *p -= root);
    let skeleton = Skeleton::from_columns(positions, radii, parents)?;
    let base = clean.origin + clean::outward(root.as_dvec3(), params);
    Ok(Some(ScannedTree { skeleton, base }))
}
