//! How far chords of the margin are from the surface.
//!
//! A folded leaf keeps its fold when its triangles meet along the midrib. Chords that run in the
//! surface are cheap, chords that span the fold are dear.

use super::shape::Blade;
use glam::Vec2;

/// Places on each chord where it is compared with the surface.
const PLACES: [f32; 3] = [0.25, 0.5, 0.75];
/// Cost of a chord's length in deviations: among equals, short chords are better.
const LENGTH_COST: f32 = 1e-3;

/// Costs of all chords, rows after rows.
pub(super) struct Folds {
    n: usize,
    costs: Vec<f32>,
}

impl Folds {
    /// Chords between the points of `ring` of a blade, whose points lie at `plane` and `heights`.
    ///
    /// # Complexity
    /// O(ring² × triangles).
    pub(super) fn of(blade: &Blade, plane: &[Vec2], heights: &[f32], ring: &[u32]) -> Self {
        let n = ring.len();
        let mut costs = vec![0.0; n * n];
        for i in 0..n {
            for j in i + 1..n {
                let (p, q) = (ring[i] as usize, ring[j] as usize);
                let off = |&place: &f32| {
                    let at = plane[p].lerp(plane[q], place);
                    let height = heights[p] + (heights[q] - heights[p]) * place;
                    surface_height(blade, plane, heights, at).map_or(0.0, |h| (h - height).abs())
                };
                let mean = PLACES.iter().map(off).sum::<f32>() / PLACES.len() as f32;
                let cost = plane[p].distance(plane[q]) * (mean + LENGTH_COST);
                costs[i * n + j] = cost;
                costs[j * n + i] = cost;
            }
        }
        Self { n, costs }
    }

    pub(super) fn cost(&self, i: usize, j: usize) -> f32 {
        self.costs[i * self.n + j]
    }
}

/// Height of the surface above a place in the plane; none outside.
fn surface_height(blade: &Blade, plane: &[Vec2], heights: &[f32], at: Vec2) -> Option<f32> {
    blade.triangles.iter().find_map(|t| {
        let [a, b, c] = t.map(|p| plane[p as usize]);
        let whole = (b - a).perp_dot(c - a);
        let parts = [(b, c), (c, a), (a, b)].map(|(p, q)| (p - at).perp_dot(q - at));
        let inside = whole > 0.0 && parts.iter().all(|&part| part >= -1e-6);
        let sum = || (0..3).map(|i| parts[i] * heights[t[i] as usize]).sum::<f32>();
        inside.then(|| sum() / whole)
    })
}
