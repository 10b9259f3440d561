//! A tree's main branches as a drawing, seen from anywhere round it.

use super::shape::Flat;
use crate::sketch::{Branches, Drawing, Label, Role, Stroke};
use glam::{Vec2, Vec3};
use tree_core::NO_PARENT;

/// Where a point of a tree shows in a picture, in metres, y up, for an eye that looks level from afar and stands at
/// `yaw` radians round the trunk: 0 on +Z, a quarter turn on +X.
#[must_use]
pub fn seen_from(yaw: f32, point: Vec3) -> Vec2 {
    let (sin, cos) = libm::sincosf(yaw);
    Vec2::new(point.x * cos - point.z * sin, point.y)
}

/// A drawing of branches as seen from `yaw`: a stroke for each axis, the trunk first, and one of [`Role::Crown`] for
/// each line of `crown` (in metres, y up, as seen; closed). An imagined root is not drawn. Units are metres, y down.
///
/// # Complexity
/// O(points).
#[must_use]
pub fn project(branches: &Branches, yaw: f32, crown: &[Vec<Vec2>]) -> Drawing {
    let first = usize::from(branches.has_imagined_root());
    let mut stroke_of = vec![0_usize; branches.len()];
    let mut lines: Vec<Vec<Vec2>> = Vec::new();
    for segment in first..branches.len() {
        let parent = branches.parents()[segment];
        let goes_on =
            segment > first && branches.labels()[segment] == Label::Apical && parent != NO_PARENT;
        let points = branches.points(segment).iter().map(|&point| seen_from(yaw, point));
        if goes_on {
            let stroke = stroke_of[parent as usize];
            stroke_of[segment] = stroke;
            lines[stroke].extend(points.skip(1));
        } else {
            stroke_of[segment] = lines.len();
            lines.push(points.collect());
        }
    }
    let down = |line: &[Vec2]| line.iter().map(|p| Vec2::new(p.x, -p.y)).collect::<Vec<_>>();
    let roles = std::iter::once(Role::Trunk).chain(std::iter::repeat(Role::Branch));
    let mut strokes: Vec<Stroke> =
        lines.iter().zip(roles).map(|(line, role)| Stroke::of(role, down(line))).collect();
    strokes.extend(
        crown.iter().map(|line| Stroke { closed: true, ..Stroke::of(Role::Crown, down(line)) }),
    );
    Drawing { strokes }
}

/// Branches as seen from `yaw`, as nodes and parents.
pub(super) fn flat(branches: &Branches, yaw: f32) -> Flat {
    let first = usize::from(branches.has_imagined_root());
    let start = seen_from(yaw, branches.start(first));
    let mut flat = Flat { positions: vec![start], parents: vec![NO_PARENT] };
    // The node at each segment's end.
    let mut ends = vec![0_u32; branches.len()];
    for segment in first..branches.len() {
        let parent = branches.parents()[segment];
        let mut below = ends.get(parent as usize).copied().unwrap_or(0);
        for &point in branches.points(segment).iter().skip(1) {
            flat.positions.push(seen_from(yaw, point));
            flat.parents.push(below);
            below = flat.positions.len() as u32 - 1;
        }
        ends[segment] = below;
    }
    flat
}
