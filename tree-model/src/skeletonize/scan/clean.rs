//! Step 1: points that are numbers, each place once, in metres, y up, round an origin of their own.

use super::kd::{Kd, spacing};
use super::params::ScanParams;
use super::report::ScanReport;
use crate::error::{ModelError, Result};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// The spacing of a cloud is the distance to this neighbour, in the median.
pub(super) const SPACING_NEIGHBOUR: usize = 4;
/// The spacing is measured at this many points.
const SAMPLES: usize = 4096;
/// Edge of the voxels, where none is given, in spacings: melts what was scanned twice, no more.
const VOXEL: f32 = 0.5;
/// Fewer points are no tree.
pub(super) const POINTS_MIN: usize = 16;
/// Cells along an edge of the cloud at most: three of them fit 63 bits.
const CELLS_MAX: f32 = 2_097_151.0;
/// A cloud narrower than this share of its length is a line.
const LINE: f32 = 1e-4;

/// What is left of a cloud.
#[derive(Debug)]
pub(super) struct Clean {
    pub(super) kd: Kd,
    /// Where the origin of the points is in the cloud, in its axes and unit.
    pub(super) origin: DVec3,
    /// Median distance to the fourth neighbour, metres.
    pub(super) spacing: f32,
}

/// Metres and y up from the axes and unit of the cloud.
pub(super) fn inward(point: DVec3, params: &ScanParams) -> DVec3 {
    params.up.to_y_up((point * params.unit).to_array()).into()
}

/// The other way round.
pub(super) fn outward(point: DVec3, params: &ScanParams) -> DVec3 {
    params.up.from_y_up((point / params.unit).to_array()).into()
}

/// Cleans a cloud.
pub(super) fn clean(
    points: &[DVec3],
    params: &ScanParams,
    report: &mut ScanReport,
    control: &Control,
) -> Result<Clean> {
    control.limits.check(Resource::GraphNodes, points.len() as u64)?;
    let finite: Vec<DVec3> =
        points.iter().filter(|p| p.is_finite()).map(|&p| inward(p, params)).collect();
    report.n_not_finite = points.len() - finite.len();
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for point in &finite {
        (low, high) = (low.min(*point), high.max(*point));
    }
    if finite.len() < POINTS_MIN {
        return Err(few(finite.len(), "finite points"));
    }
    let size = (high - low).max_element();
    if size <= 0.0 {
        return Err(ModelError::Cloud { problem: "all points lie at one place".into() });
    }
    if size > SIZE_MAX {
        let problem = format!(
            "it is {size:.3e} m across, at most {SIZE_MAX:.0e} m is read: `scan.unit` is metres for a \
             unit of the cloud"
        );
        return Err(ModelError::Cloud { problem });
    }
    let near: Vec<Vec3> = finite.iter().map(|&p| (p - low).as_vec3()).collect();
    let near = once(near, size as f32 / CELLS_MAX);
    report.n_doubles = finite.len() - near.len();
    if near.len() < POINTS_MIN {
        return Err(few(near.len(), "different points"));
    }
    control.check()?;
    let kd = Kd::new(&near);
    let dense = spacing(&kd, SPACING_NEIGHBOUR, SAMPLES).unwrap_or(0.0);
    let edge = if params.voxel > 0.0 { params.voxel } else { VOXEL * dense };
    let n_before = near.len();
    let thin = once(near, edge.max(size as f32 / CELLS_MAX));
    report.n_thinned = n_before - thin.len();
    if thin.len() < POINTS_MIN {
        return Err(few(thin.len(), "points in different voxels"));
    }
    let kd = if thin.len() < n_before { Kd::new(&thin) } else { kd };
    check_shape(kd.points())?;
    let spacing = spacing(&kd, SPACING_NEIGHBOUR, SAMPLES).unwrap_or(edge).max(f32::MIN_POSITIVE);
    report.spacing = spacing;
    Ok(Clean { kd, origin: outward(low, params), spacing })
}

/// Widest cloud in metres.
const SIZE_MAX: f64 = 1e5;

fn few(n: usize, what: &str) -> ModelError {
    ModelError::Cloud { problem: format!("it has {n} {what}, a tree needs at least {POINTS_MIN}") }
}

/// Refuses clouds on one line.
fn check_shape(points: &[Vec3]) -> Result<()> {
    let first = points.first().copied().unwrap_or_default();
    let far = |from: Vec3| {
        points.iter().copied().fold((0.0, from), |best: (f32, Vec3), p| {
            let d = p.distance(from);
            if d > best.0 { (d, p) } else { best }
        })
    };
    let (_, a) = far(first);
    let (length, b) = far(a);
    let along = (b - a) / length;
    let off = points.iter().map(|&p| (p - a).reject_from_normalized(along).length());
    if off.fold(0.0, f32::max) <= LINE * length {
        return Err(ModelError::Cloud { problem: "all points lie on one line".into() });
    }
    Ok(())
}

/// One point for each cell of a grid: the mean of those in it.
fn once(points: Vec<Vec3>, edge: f32) -> Vec<Vec3> {
    let key = |p: &Vec3| {
        let [x, y, z] = (*p / edge).to_array().map(|c| c.clamp(0.0, CELLS_MAX) as u64);
        (x << 42) | (y << 21) | z
    };
    let mut keys: Vec<(u64, u32)> =
        points.par_iter().zip(0..points.len() as u32).map(|(p, i)| (key(p), i)).collect();
    keys.par_sort_unstable();
    if keys.windows(2).all(|two| two[0].0 != two[1].0) {
        return points;
    }
    keys.chunk_by(|a, b| a.0 == b.0)
        .map(|cell| {
            let sum: Vec3 = cell.iter().map(|&(_, i)| points[i as usize]).sum();
            sum / cell.len() as f32
        })
        .collect()
}
