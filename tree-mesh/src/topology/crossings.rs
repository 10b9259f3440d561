//! Triangles of one surface that cross.

use super::bvh::Bvh;
use super::triangles::{meet, meet_beyond_corner};
use super::weld::welded;
use crate::error::{MeshError, Result};
use crate::mesh::Surface;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// Groups of triangles in one piece of work.
const GROUPS_PER_PART: usize = 256;
/// Pairs of boxes between two looks at the control.
const PAIRS_PER_CHECK: u32 = 1 << 14;

/// Pairs of triangles that cross, of [`self_intersections`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Crossings {
    /// Triangles that share no point of the surface and yet have a place in common, lower number
    /// first, sorted.
    pub pairs: Vec<[u32; 2]>,
    /// Triangles that share one point of the surface and have another place in common, likewise.
    pub pairs_at_points: Vec<[u32; 2]>,
    /// Different triangles in either list.
    pub n_triangles: u64,
}

/// Finds the triangles that cross or touch each other without sharing a point, and those that share
/// one point and meet again beyond it. Triangles that share an edge are not tested (they cross only
/// when folded flat on each other), nor are those with two corners at one point.
///
/// # Errors
/// As [`welded`]; [`MeshError::Limit`] when the pairs are more than
/// [`Limits::triangles`](tree_core::Limits::triangles), [`MeshError::Cancelled`].
///
/// # Complexity
/// O(n log n + pairs of overlapping boxes); 40 bytes a triangle. Parallel.
pub fn self_intersections(surface: &Surface, control: &Control) -> Result<Crossings> {
    let points = welded(surface)?;
    control.limits.check(Resource::Triangles, surface.n_triangles() as u64)?;
    let triangles = points.triangles(surface);
    let place = |point: u32| surface.positions[points.first[point as usize] as usize];
    let bvh = Bvh::new(&triangles, place);
    control.check()?;
    let n_parts = bvh.n_groups().div_ceil(GROUPS_PER_PART);
    let search = Search { triangles: &triangles, place, bvh: &bvh, control };
    let mut found = Crossings::default();
    // Batches of parts, so that the limit is looked at before the lists grow far beyond it.
    let batch = 16 * rayon::current_num_threads().max(1);
    for first in (0..n_parts).step_by(batch) {
        let parts: Vec<Crossings> = (first..(first + batch).min(n_parts))
            .into_par_iter()
            .map_init(Vec::new, |stack, part| search.part(part, stack))
            .collect::<Result<_>>()?;
        for part in parts {
            found.pairs.extend(part.pairs);
            found.pairs_at_points.extend(part.pairs_at_points);
        }
        search.check_count(found.pairs.len() + found.pairs_at_points.len())?;
    }
    found.pairs.par_sort_unstable();
    found.pairs_at_points.par_sort_unstable();
    let mut all: Vec<u32> =
        found.pairs.iter().chain(&found.pairs_at_points).flatten().copied().collect();
    all.par_sort_unstable();
    all.dedup();
    found.n_triangles = all.len() as u64;
    Ok(found)
}

struct Search<'a, F> {
    triangles: &'a [[u32; 3]],
    place: F,
    bvh: &'a Bvh,
    control: &'a Control,
}

impl<F: Fn(u32) -> Vec3 + Sync> Search<'_, F> {
    fn check_count(&self, n_pairs: usize) -> Result<()> {
        Ok(self.control.limits.check(Resource::Triangles, n_pairs as u64)?)
    }

    fn part(&self, part: usize, stack: &mut Vec<usize>) -> Result<Crossings> {
        let mut found = Crossings::default();
        let mut n_tested = 0_u32;
        let last = ((part + 1) * GROUPS_PER_PART).min(self.bvh.n_groups());
        for group in part * GROUPS_PER_PART..last {
            self.bvh.pairs(group, stack, |a, b| {
                n_tested = n_tested.wrapping_add(1);
                if n_tested.is_multiple_of(PAIRS_PER_CHECK) {
                    self.control.check()?;
                    self.check_count(found.pairs.len() + found.pairs_at_points.len())?;
                }
                self.test(a.min(b), a.max(b), &mut found);
                Ok::<(), MeshError>(())
            })?;
            self.control.check()?;
        }
        Ok(found)
    }

    fn test(&self, a: u32, b: u32, found: &mut Crossings) {
        let (corners_a, corners_b) = (self.triangles[a as usize], self.triangles[b as usize]);
        let collapsed = |[a, b, c]: [u32; 3]| a == b || b == c || c == a;
        if collapsed(corners_a) || collapsed(corners_b) {
            return;
        }
        let mut shared = None;
        let mut n_shared = 0;
        for (i, p) in corners_a.iter().enumerate() {
            if let Some(j) = corners_b.iter().position(|q| p == q) {
                shared = Some((i, j));
                n_shared += 1;
            }
        }
        let places = |corners: [u32; 3], first: usize| -> [DVec3; 3] {
            let at = |k: usize| (self.place)(corners[(first + k) % 3]).as_dvec3();
            [at(0), at(1), at(2)]
        };
        let crossed = match (n_shared, shared) {
            (0, _) => meet(places(corners_a, 0), places(corners_b, 0)),
            (1, Some((i, j))) => meet_beyond_corner(places(corners_a, i), places(corners_b, j)),
            _ => false,
        };
        match (crossed, n_shared) {
            (true, 0) => found.pairs.push([a, b]),
            (true, _) => found.pairs_at_points.push([a, b]),
            _ => {}
        }
    }
}
