//! Even sampling that keeps the shape.

use super::tidy::THIN;
use glam::Vec2;

/// Most nodes that even sampling makes of a drawing: beyond, it is coarser. Corners come on top.
const MOST: f32 = 200_000.0;

/// The spacing in drawing units for strokes of this length in all.
pub(super) fn spacing(share: f32, unit: f32, total: f32) -> f32 {
    (share * unit).max(total / MOST)
}

/// Points at even distances of about `spacing` along a polyline, its ends kept, and in between as many as it takes
/// to stay within `tolerance` of every point of it. O(points · log points) for points that are not much closer than
/// the tolerance.
pub(super) fn resample(points: &[Vec2], spacing: f32, tolerance: f32) -> Vec<Vec2> {
    let total: f32 = super::tidy::length(points);
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Vec::new() };
    let n = (total / spacing).round().max(1.0);
    let step = total / n;
    let mut out = vec![first];
    // Points of the polyline since the last even one.
    let mut since = vec![first];
    let (mut walked, mut next) = (0.0_f32, 1.0_f32);
    for pair in points.windows(2) {
        let along = pair[0].distance(pair[1]);
        while next < n && walked + along >= step * next && along > 0.0 {
            let share = (step * next - walked) / along;
            let even = pair[0].lerp(pair[1], share.clamp(0.0, 1.0));
            since.push(even);
            corners(&since, tolerance, &mut out);
            out.push(even);
            since.clear();
            since.push(even);
            next += 1.0;
        }
        since.push(pair[1]);
        walked += along;
    }
    corners(&since, tolerance, &mut out);
    out.push(last);
    out.dedup();
    out
}

/// Adds those of the inner points that lie farther from the line than the tolerance (Ramer 1972; Douglas & Peucker
/// 1973).
fn corners(points: &[Vec2], tolerance: f32, out: &mut Vec<Vec2>) {
    let mut open = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = open.pop() {
        let far = (from + 1..to)
            .map(|i| (i, closest(points[i], points[from], points[to]).1))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        match far {
            Some((at, distance)) if distance > tolerance => {
                open.push((at, to));
                open.push((from, at));
            }
            _ if to + 1 < points.len() => out.push(points[to]),
            _ => {}
        }
    }
}

/// How far along from `a` to `b` (0 to 1) the point nearest to `p` is, and its distance.
pub(super) fn closest(p: Vec2, a: Vec2, b: Vec2) -> (f32, f32) {
    let along = b - a;
    let share = (p - a).dot(along) / along.length_squared();
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    (share, p.distance(a + share * along))
}

/// How far sampling may be from what was drawn, a share of the height. With thinning together below 0.2 %.
pub(super) const TOLERANCE: f32 = 0.001 - 0.1 * THIN;
