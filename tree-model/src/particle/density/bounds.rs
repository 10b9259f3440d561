//! The box that a grid has to fill: what the views see, from all sides.

use super::super::camera::{Camera, Projector};
use super::coverage::Coverage;
use super::rounding::{Strip, fit};
use glam::{Vec2, Vec3};

/// Trees wider than so many times their height get larger voxels.
const WIDEST: f32 = 4.0;
/// Heights and widths beyond so many times the least one seen come from rays that hardly meet the tree's
/// axis.
const FARTHEST: f32 = 16.0;

/// Where the grid lies: lowest and highest corner, and the side of its voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) low: Vec3,
    pub(super) high: Vec3,
    pub(super) voxel: f32,
}

/// The tree in one view, on the upright plane through its axis that faces the camera.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Lowest and highest point.
    low: f32,
    high: f32,
    strip: Strip,
}

/// The extent of what the views see, in voxels `resolution` of which make its height. `None` when no ray
/// meets the tree's axis plane.
pub(super) fn extent(
    cameras: &[(&Camera, Projector)],
    coverages: &[Coverage],
    resolution: u32,
) -> Option<Extent> {
    let faces: Vec<Face> = cameras
        .iter()
        .zip(coverages)
        .filter_map(|((camera, projector), coverage)| face(camera, projector, coverage))
        .collect();
    let least = faces.iter().map(|face| face.high - face.low).fold(f32::MAX, f32::min);
    let low = faces.iter().map(|face| face.low).fold(f32::MAX, f32::min);
    let high = faces.iter().map(|face| face.high).fold(f32::MIN, f32::max);
    let strips: Vec<Strip> = faces.iter().map(|face| face.strip).collect();
    let (across_low, across_high) = across(&strips)?;
    let height = (high - low).min(FARTHEST * least);
    let width = (across_high - across_low).max_element();
    let voxel = height.max(width / WIDEST) / resolution as f32;
    if !(voxel > 0.0 && voxel.is_finite()) {
        return None;
    }
    Some(Extent {
        low: Vec3::new(across_low.x, low, across_low.y),
        high: Vec3::new(across_high.x, low + height, across_high.y),
        voxel,
    })
}

fn face(camera: &Camera, projector: &Projector, coverage: &Coverage) -> Option<Face> {
    let (low, high) = coverage.bounds()?;
    let right = projector.frame.right;
    let normal = Vec3::Y.cross(right);
    let corners = [low, high, Vec2::new(low.x, high.y), Vec2::new(high.x, low.y)];
    let (mut least, mut most) = (Vec2::MAX, Vec2::MIN);
    for corner in corners {
        let (on, along) = projector.ray(corner);
        let t = -on.dot(normal) / along.dot(normal);
        if !t.is_finite() || (camera.eye().is_some() && t <= 0.0) {
            continue;
        }
        let point = on + t * along;
        let point = Vec2::new(point.dot(right), point.y);
        (least, most) = (least.min(point), most.max(point));
    }
    if !least.cmplt(most).all() {
        return None;
    }
    let open = low.x <= 0.0 || high.x >= coverage.size().x;
    let strip = Strip::new(camera, least.x, most.x, open);
    Some(Face { low: least.y, high: most.y, strip })
}

/// The box in x and z around where all strips cross. Depth that no view shows is taken as the width.
fn across(strips: &[Strip]) -> Option<(Vec2, Vec2)> {
    let widest = strips.iter().copied().reduce(|a, b| if b.half > a.half { b } else { a })?;
    let center = fit(strips, 0.0)?.center();
    let depth = widest.along.perp();
    let middle = widest.along * widest.middle + depth * depth.dot(center);
    let (a, b) = (widest.along * widest.half, depth * widest.half);
    let square = vec![middle - a - b, middle + a - b, middle + a + b, middle - a + b];
    let mut crossing = square.clone();
    for strip in strips.iter().filter(|strip| !strip.open) {
        crossing = below(&crossing, strip.along, strip.middle + strip.half);
        crossing = below(&crossing, -strip.along, strip.half - strip.middle);
    }
    // Views that contradict each other may leave nothing.
    let corners = if crossing.len() < 3 { &square } else { &crossing };
    let low = corners.iter().copied().reduce(Vec2::min)?;
    Some((low, corners.iter().copied().reduce(Vec2::max)?))
}

/// The part of a convex polygon where `along` · p ≤ `limit` (Sutherland, Hodgman 1974).
fn below(polygon: &[Vec2], along: Vec2, limit: f32) -> Vec<Vec2> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &here) in polygon.iter().enumerate() {
        let next = polygon[(i + 1) % polygon.len()];
        let (a, b) = (along.dot(here) - limit, along.dot(next) - limit);
        if a <= 0.0 {
            kept.push(here);
        }
        if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
            kept.push(here.lerp(next, a / (a - b)));
        }
    }
    kept
}
