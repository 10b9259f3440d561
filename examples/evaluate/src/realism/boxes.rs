//! The fractal dimension of the wood by counting boxes.
//!
//! The axes are cut into points much closer than the smallest box; boxes of edges from a quarter of the tree's
//! largest extent to a 64th, halved from one to the next, are counted that hold a point, in four grids moved against each other. The
//! dimension is the slope of the logarithms over those five scales, by least squares.

use tree_core::Skeleton;
use tree_core::glam::{DVec3, IVec3};

/// The largest box is an extent over 2 to this power, the smallest over 2 to the other.
const POWERS: std::ops::RangeInclusive<i32> = 2..=6;
/// Points to a side of the smallest box.
const POINTS: f64 = 4.0;
/// How far the grids are moved, in boxes.
const SHIFTS: [[f64; 3]; 4] =
    [[0.0, 0.0, 0.0], [0.5, 0.25, 0.75], [0.25, 0.75, 0.5], [0.75, 0.5, 0.25]];

/// `None` of a tree without extent.
pub(super) fn dimension(skeleton: &Skeleton) -> Option<f64> {
    let bounds = skeleton.bounds();
    let extent = f64::from(bounds.size().max_element());
    if extent <= 0.0 {
        return None;
    }
    let step = extent / (POINTS * f64::from(1 << POWERS.end()));
    let mut points = Vec::new();
    let at = |node: u32| (skeleton.positions()[node as usize] - bounds.min).as_dvec3() / extent;
    for (parent, node) in skeleton.segments() {
        let (a, b) = (at(parent), at(node));
        let n = (extent * a.distance(b) / step).ceil().max(1.0) as u32;
        points.extend((0..=n).map(|i| a.lerp(b, f64::from(i) / f64::from(n))));
    }
    let places: Vec<(f64, f64)> = POWERS
        .map(|power| {
            let edge = 1.0 / f64::from(1 << power);
            (f64::from(power) * std::f64::consts::LN_2, libm::log(count(&points, edge)))
        })
        .collect();
    Some(slope(&places))
}

/// Boxes of an edge that hold points, the mean over the grids.
fn count(points: &[DVec3], edge: f64) -> f64 {
    let boxes = |shift: [f64; 3]| {
        let place = |point: &DVec3| {
            let IVec3 { x, y, z } = (*point / edge + DVec3::from(shift)).floor().as_ivec3();
            (x, y, z)
        };
        let mut boxes: Vec<(i32, i32, i32)> = points.iter().map(place).collect();
        boxes.sort_unstable();
        boxes.dedup();
        boxes.len() as f64
    };
    SHIFTS.iter().map(|&shift| boxes(shift)).sum::<f64>() / SHIFTS.len() as f64
}

/// Of the straight line through points, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let (mean_x, mean_y) =
        points.iter().fold((0.0, 0.0), |(sx, sy), (x, y)| (sx + x / n, sy + y / n));
    let (common, spread) = points.iter().fold((0.0, 0.0), |(common, spread), (x, y)| {
        (common + (x - mean_x) * (y - mean_y), spread + (x - mean_x) * (x - mean_x))
    });
    common / spread
}
