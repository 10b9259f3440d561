//! The best polygon of a disc's own margin.
//!
//! 1. Start from the margin thinned to the wanted number of vertices, and from vertices spread
//!    evenly, turned by several steps.
//! 2. Triangulate: of all triangulations without turned triangles the one whose chords are nearest to
//!    the surface (dynamic programming, Klincsek 1980). No such triangulation: no simple polygon.
//! 3. Exchange a kept vertex for another while that makes the judge's error smaller.

use super::disc::{Disc, thin};
use super::judge::Judge;

/// Even spreads that a search starts from.
const SPREADS: usize = 2;
/// Rounds of exchanges at most; two or three are usual.
const ROUNDS_MAX: usize = 8;
/// Most exchanges of any vertex for any other in a round; with more, vertices only move between their
/// neighbours.
const EXCHANGES_MAX: usize = 200;
/// Smallest doubled area of a triangle, of a blade of area 1: others are as good as degenerate.
const SPAN_MIN: f32 = 1e-5;

/// A polygon with its triangles and its error.
struct Found {
    /// Rows of the ring, rising.
    kept: Vec<usize>,
    triangles: Vec<[u32; 3]>,
    error: f32,
}

impl Disc {
    /// At most `target` triangles; none when there are more than the margin is kept for, or no simple
    /// polygon is found.
    pub(super) fn polygon(
        &self,
        target: usize,
        judge: Option<&Judge<'_>>,
    ) -> Option<Vec<[u32; 3]>> {
        let n = self.ring.len();
        let m = (target + 2).min(n);
        if m < 3 || target + 2 > super::disc::RING_MAX {
            return None;
        }
        let mut thinned: Vec<u32> = (0..n as u32).collect();
        thin(&self.flat, &mut thinned, m);
        let thinned: Vec<usize> = thinned.iter().map(|&i| i as usize).collect();
        let Some(judge) = judge.filter(|_| m < n) else {
            return self.triangulated(&thinned);
        };
        let step = (n / m).max(1);
        let spread = |k: usize| {
            let mut kept: Vec<usize> =
                (0..m).map(|i| (i * n / m + k * step / SPREADS) % n).collect();
            kept.sort_unstable();
            kept
        };
        let starts = std::iter::once(thinned).chain((0..SPREADS).map(spread));
        let found = starts.filter_map(|kept| {
            Some(self.improved(self.judged(kept, judge, f32::INFINITY)?, judge))
        });
        let best = found.reduce(|a, b| if b.error < a.error { b } else { a });
        best.map(|found| found.triangles)
    }

    fn judged(&self, kept: Vec<usize>, judge: &Judge<'_>, most: f32) -> Option<Found> {
        let triangles = self.triangulated(&kept)?;
        let error = judge.error(&triangles, most);
        Some(Found { kept, triangles, error })
    }

    fn improved(&self, mut best: Found, judge: &Judge<'_>) -> Found {
        for _ in 0..ROUNDS_MAX {
            let before = best.error;
            for i in 0..best.kept.len() {
                for other in self.others(&best.kept, i) {
                    let mut kept = best.kept.clone();
                    kept[i] = other;
                    kept.sort_unstable();
                    if let Some(found) = self.judged(kept, judge, best.error)
                        && found.error < best.error
                    {
                        best = found;
                    }
                }
            }
            if best.error >= before {
                break;
            }
        }
        best
    }

    /// Rows of the ring that kept vertex `i` may be exchanged for.
    fn others(&self, kept: &[usize], i: usize) -> Vec<usize> {
        let (n, m) = (self.ring.len(), kept.len());
        if m * (n - m) <= EXCHANGES_MAX {
            return (0..n).filter(|row| kept.binary_search(row).is_err()).collect();
        }
        let (before, after) = (kept[(i + m - 1) % m], kept[(i + 1) % m]);
        let gap = (after + n - before) % n;
        (1..gap).map(|k| (before + k) % n).filter(|row| kept.binary_search(row).is_err()).collect()
    }

    /// Triangles of a polygon, all against the clock, whose chords are nearest to the surface; none
    /// when it has no such triangles.
    fn triangulated(&self, kept: &[usize]) -> Option<Vec<[u32; 3]>> {
        let m = kept.len();
        let at = |i: usize| self.flat[kept[i]];
        let chord = |i: usize, j: usize| {
            if j == i + 1 || (i == 0 && j + 1 == m) {
                0.0
            } else {
                self.folds.cost(kept[i], kept[j])
            }
        };
        // The best cost of the part between two vertices, and the corner of its first triangle.
        let mut best = vec![(0.0_f32, 0_usize); m * m];
        for gap in 2..m {
            for i in 0..m - gap {
                let j = i + gap;
                let mut least = (f32::INFINITY, 0);
                for k in i + 1..j {
                    let parts = best[i * m + k].0 + best[k * m + j].0;
                    if parts < least.0 && (at(k) - at(i)).perp_dot(at(j) - at(i)) > SPAN_MIN {
                        least = (parts, k);
                    }
                }
                best[i * m + j] = (least.0 + chord(i, j), least.1);
            }
        }
        if !best[m - 1].0.is_finite() {
            return None;
        }
        let mut triangles = Vec::with_capacity(m - 2);
        let mut parts = vec![(0, m - 1)];
        while let Some((i, j)) = parts.pop() {
            if j > i + 1 {
                let k = best[i * m + j].1;
                triangles.push([i, k, j].map(|corner| self.ring[kept[corner]]));
                parts.extend([(i, k), (k, j)]);
            }
        }
        Some(triangles)
    }
}
