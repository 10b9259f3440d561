//! Blades that are bent or folded discs: their margin, seen along their mean normal.

use super::fold::Folds;
use super::shape::Blade;
use glam::{Vec2, Vec3};

/// Smallest area of a disc seen along its mean normal, as a share of its true area. What folds over
/// itself more is no disc.
const FLAT_MIN: f32 = 0.35;
/// Largest share of the seen area that holes, or parts turned away, may make up.
const STRAY_MAX: f32 = 0.03;
/// Most vertices of a margin; of longer ones those that matter least are left out first.
pub(super) const RING_MAX: usize = 64;

/// A disc, seen so that its triangles go against the clock.
pub(super) struct Disc {
    /// Mean normal: from where it is seen.
    pub(super) normal: Vec3,
    /// Points of the margin, against the clock.
    pub(super) ring: Vec<u32>,
    /// The same in the plane.
    pub(super) flat: Vec<Vec2>,
    /// How far chords of the margin are from the surface.
    pub(super) folds: Folds,
}

impl Disc {
    /// The disc that a blade is; none when it is none.
    pub(super) fn of(blade: &Blade) -> Option<Self> {
        let sum: Vec3 = blade.triangles.iter().map(|&t| blade.cross(t)).sum();
        let seen = sum.length();
        if seen < FLAT_MIN {
            return None;
        }
        let normal = sum / seen;
        let away: f32 = blade.triangles.iter().map(|&t| blade.cross(t).dot(normal).min(0.0)).sum();
        if -away > STRAY_MAX * seen {
            return None;
        }
        let x = normal.any_orthonormal_vector();
        let y = normal.cross(x);
        let plane: Vec<Vec2> = blade.points.iter().map(|p| Vec2::new(p.dot(x), p.dot(y))).collect();
        let area = |ring: &Vec<u32>| ring_area(&plane, ring);
        let rings = rings(&blade.triangles)?;
        let mut ring = rings.into_iter().max_by(|a, b| area(a).total_cmp(&area(b)))?;
        if (area(&ring) - seen).abs() > STRAY_MAX * seen {
            return None;
        }
        thin(&plane, &mut ring, RING_MAX);
        let flat: Vec<Vec2> = ring.iter().map(|&p| plane[p as usize]).collect();
        let heights: Vec<f32> = blade.points.iter().map(|p| p.dot(normal)).collect();
        let folds = Folds::of(blade, &plane, &heights, &ring);
        Some(Self { normal, ring, flat, folds })
    }
}

/// Loops of edges that only one triangle has; none where they branch.
fn rings(triangles: &[[u32; 3]]) -> Option<Vec<Vec<u32>>> {
    let mut edges: Vec<(u32, u32)> =
        triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
    edges.sort_unstable();
    if edges.windows(2).any(|pair| pair[0] == pair[1]) {
        return None;
    }
    let open: Vec<(u32, u32)> =
        edges.iter().copied().filter(|&(a, b)| edges.binary_search(&(b, a)).is_err()).collect();
    if open.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return None;
    }
    let mut used = vec![false; open.len()];
    let mut rings = Vec::new();
    for start in 0..open.len() {
        let (mut ring, mut at) = (Vec::new(), start);
        while !used[at] {
            used[at] = true;
            ring.push(open[at].0);
            at = open.binary_search_by_key(&open[at].1, |edge| edge.0).ok()?;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    Some(rings)
}

fn ring_area(plane: &[Vec2], ring: &[u32]) -> f32 {
    let at = |i: usize| plane[ring[i % ring.len()] as usize];
    (0..ring.len()).map(|i| 0.5 * at(i).perp_dot(at(i + 1))).sum()
}

/// Leaves out points, always the one that spans the least area with its neighbours (Visvalingam and
/// Whyatt 1993), until at most `n` are left.
pub(super) fn thin(plane: &[Vec2], ring: &mut Vec<u32>, n: usize) {
    while ring.len() > n {
        let len = ring.len();
        let at = |i: usize| plane[ring[i % len] as usize];
        let span = |i: usize| (at(i + 1) - at(i)).perp_dot(at(i + 2) - at(i)).abs();
        let least = (0..len).min_by(|&a, &b| span(a).total_cmp(&span(b)));
        let Some(least) = least else { return };
        ring.remove((least + 1) % len);
    }
}
