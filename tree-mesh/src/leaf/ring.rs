//! Polygons: fewer vertices, area, triangles.

use glam::Vec2;

/// Leaves out the vertices that matter least until at most `n_max` are left; the first and the last
/// stay.
pub(crate) fn thin(mut chain: Vec<Vec2>, n_max: usize) -> Vec<Vec2> {
    chain.dedup();
    while chain.len() > n_max.max(2) {
        let area = |w: &[Vec2]| (w[1] - w[0]).perp_dot(w[2] - w[1]).abs();
        let least = chain.windows(3).enumerate().min_by(|a, b| area(a.1).total_cmp(&area(b.1)));
        let Some((i, _)) = least else { break };
        chain.remove(i + 1);
    }
    chain
}

/// Area inside a counter-clockwise polygon.
pub(crate) fn area(ring: &[Vec2]) -> f32 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(a, b)| 0.5 * a.perp_dot(*b)).sum()
}

/// Triangles that fill a simple, counter-clockwise polygon: `n - 2` (ears cut one after the other,
/// the best shaped first).
pub(crate) fn triangulate(ring: &[Vec2]) -> Vec<u32> {
    let mut left: Vec<u32> = (0..ring.len() as u32).collect();
    let mut triangles = Vec::with_capacity(3 * ring.len());
    while left.len() >= 3 {
        let n = left.len();
        let corners = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let quality = |i: usize| ear(ring, &left, corners(i));
        let Some(best) = (0..n).max_by(|&a, &b| quality(a).total_cmp(&quality(b))) else { break };
        triangles.extend(corners(best));
        left.remove(best);
    }
    triangles
}

/// How well shaped an ear is: area over squared girth; negative when it is none.
fn ear(ring: &[Vec2], left: &[u32], corners: [u32; 3]) -> f32 {
    let [a, b, c] = corners.map(|i| ring[i as usize]);
    let double = (b - a).perp_dot(c - b);
    let holds = |p: Vec2| {
        (b - a).perp_dot(p - a) >= 0.0
            && (c - b).perp_dot(p - b) >= 0.0
            && (a - c).perp_dot(p - c) >= 0.0
    };
    let blocked = left.iter().any(|i| !corners.contains(i) && holds(ring[*i as usize]));
    let girth = a.distance(b) + b.distance(c) + c.distance(a);
    if blocked || double <= 0.0 { double.min(0.0) - 1.0 } else { double / (girth * girth) }
}
