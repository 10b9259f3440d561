//! Step 3b: where trees stand.
//!
//! One tree: of the pieces that the cloud falls into near its lowest point, the one that most points
//! have their shortest way to. Several trees: pieces of the lowest quarter of the height that rise like
//! trunks, narrow and from below.

use super::super::rows::{Rows, Sets};
use super::graph::Graph;
use super::reach::{Ways, reach};
use crate::error::{ModelError, Result};
use glam::Vec3;

/// A base reaches this share of the height up...
const SLAB: f32 = 0.02;
/// ...and at least this many spacings.
const SLAB_SPACINGS: f32 = 4.0;
/// Trunks of several trees are looked for in this share of the height.
const TRUNKS: f32 = 0.25;
/// They fill this share of that height...
const RISE: f32 = 0.5;
/// ...and are this many times as high as wide.
const NARROW: f32 = 2.0;
/// A trunk begins within this share of that height above its ground.
const DEEP: f32 = 0.45;

/// A base wider than this share of the height is not one of a trunk: branches hang down to the ground.
const WIDE: f32 = 0.03;
/// Then it is sought in the middle of the points in this share of the height...
const MIDDLE: f32 = 0.3;
/// ...and this share of the height round it.
const ROUND: f32 = 0.015;

/// Where a tree stands.
pub(super) struct Base {
    pub(super) points: Vec<u32>,
    pub(super) low: f32,
}

/// A cloud as the search for bases sees it: heights are above the ground.
pub(super) struct Cloud<'a> {
    pub(super) graph: &'a Graph,
    pub(super) points: &'a [Vec3],
    pub(super) heights: &'a [f32],
    pub(super) spacing: f32,
}

impl Cloud<'_> {
    /// Lowest and highest of all.
    fn range(&self) -> (f32, f32) {
        self.heights
            .iter()
            .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), &h| (low.min(h), high.max(h)))
    }

    /// Connected pieces of the points lower than `top`.
    fn below(&self, top: f32) -> Vec<Vec<u32>> {
        let mut sets = Sets::new(self.points.len());
        let low = |i: u32| self.heights[i as usize] <= top;
        for i in (0..self.points.len() as u32).filter(|&i| low(i)) {
            for &j in self.graph.arcs.of(i) {
                if low(j) {
                    sets.join(i, j);
                }
            }
        }
        let (labels, n) = sets.labels();
        let own = labels.iter().zip(0..).filter(|(_, i)| low(*i)).map(|(&l, i)| (l, i));
        let rows = Rows::of_pairs(own, n);
        (0..n as u32).map(|l| rows.of(l).to_vec()).filter(|row| !row.is_empty()).collect()
    }

    fn slab(&self, (low, high): (f32, f32)) -> f32 {
        (SLAB * (high - low)).max(SLAB_SPACINGS * self.spacing)
    }

    fn base(&self, piece: &[u32], slab: f32) -> Base {
        let height = |i: &u32| self.heights[*i as usize];
        let low = piece.iter().map(height).fold(f32::INFINITY, f32::min);
        let points = piece.iter().copied().filter(|i| height(i) <= low + slab).collect();
        Base { points, low }
    }

    fn reach(&self, bases: &[Base]) -> Ways {
        let mut starts = Vec::new();
        for (base, number) in bases.iter().zip(0..) {
            let start = |&i: &u32| (i, number, self.heights[i as usize] - base.low);
            starts.extend(base.points.iter().map(start));
        }
        reach(self.graph, self.points, self.spacing, &starts)
    }

    /// The one base that most ways lead to, and all ways to it; and how many there were to choose of.
    pub(super) fn one(&self) -> Result<(Vec<Base>, Ways, usize)> {
        let range = self.range();
        let slab = self.slab(range);
        let bases: Vec<Base> =
            self.below(range.0 + slab).iter().map(|piece| self.base(piece, slab)).collect();
        let n = bases.len();
        let mut ways = self.reach(&bases);
        let mut bases = bases;
        if n > 1 {
            let mut claims = vec![0_usize; n];
            for &base in ways.base.iter().filter(|&&base| base != u32::MAX) {
                claims[base as usize] += 1;
            }
            let most = (0..n).max_by_key(|&i| (claims[i], std::cmp::Reverse(i))).unwrap_or(0);
            bases = vec![bases.swap_remove(most)];
            ways = self.reach(&bases);
        }
        if let Some(narrow) = bases.first().and_then(|base| self.narrow(base, range)) {
            bases = vec![narrow];
            ways = self.reach(&bases);
        }
        Ok((bases, ways, n))
    }

    /// The middle of a base that is too wide for a trunk.
    fn narrow(&self, base: &Base, (low, high): (f32, f32)) -> Option<Base> {
        let flat = |i: u32| self.points[i as usize] * Vec3::new(1.0, 0.0, 1.0);
        let middle = |of: &[u32]| {
            let mut sides = [0, 2].map(|axis| -> Vec<f32> {
                of.iter().map(|&i| self.points[i as usize][axis]).collect()
            });
            let half = of.len() / 2;
            let [x, z] = sides.each_mut().map(|side| match side.get(half) {
                Some(_) => *side.select_nth_unstable_by(half, f32::total_cmp).1,
                None => 0.0,
            });
            Vec3::new(x, 0.0, z)
        };
        let center = middle(&base.points);
        let spread = base.points.iter().map(|&i| flat(i).distance_squared(center)).sum::<f32>();
        let width = (spread / base.points.len().max(1) as f32).sqrt();
        if width <= WIDE * (high - low) {
            return None;
        }
        let all: Vec<u32> = (0..self.points.len() as u32)
            .filter(|&i| self.heights[i as usize] <= low + MIDDLE * (high - low))
            .collect();
        let stem = middle(&all);
        let away = |i: &u32| flat(*i).distance(stem);
        let least = base.points.iter().map(away).fold(f32::INFINITY, f32::min);
        let reach = least + (ROUND * (high - low)).max(SLAB_SPACINGS * self.spacing);
        let points = base.points.iter().copied().filter(|i| away(i) <= reach).collect();
        Some(Base { points, low: base.low })
    }

    /// All bases that look like trunks, and the ways to the next one.
    pub(super) fn several(&self) -> Result<(Vec<Base>, Ways, usize)> {
        let range = self.range();
        let rise = TRUNKS * (range.1 - range.0);
        let mut found: Vec<(Base, Vec3, f32)> = Vec::new();
        for piece in self.below(range.0 + rise) {
            let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let mut bottom = f32::INFINITY;
            for &i in &piece {
                let point = self.points[i as usize];
                (low, high) = (low.min(point), high.max(point));
                bottom = bottom.min(self.heights[i as usize]);
            }
            let (size, middle) = (high - low, 0.5 * (low + high));
            let wide = size.x.max(size.z);
            let is_trunk =
                size.y >= RISE * rise && size.y >= NARROW * wide && bottom <= range.0 + DEEP * rise;
            if is_trunk {
                let slab = self.slab((0.0, range.1 - range.0));
                found.push((self.base(&piece, slab), middle, wide));
            }
        }
        // The same trunk, seen in two pieces one above the other.
        let bases: Vec<usize> = (0..found.len())
            .filter(|&i| {
                let (base, middle, wide) = &found[i];
                !found.iter().any(|(other, there, _)| {
                    let apart = (*middle - *there) * Vec3::new(1.0, 0.0, 1.0);
                    other.low < base.low && apart.length() < *wide
                })
            })
            .collect();
        let mut number = 0;
        found.retain(|_| {
            number += 1;
            bases.contains(&(number - 1))
        });
        let bases: Vec<Base> = found.into_iter().map(|(base, ..)| base).collect();
        if bases.is_empty() {
            let problem = "no trunk rises from below; with `scan.several` off the cloud is taken for \
                           one tree";
            return Err(ModelError::NoBase { problem });
        }
        let (ways, n) = (self.reach(&bases), bases.len());
        Ok((bases, ways, n))
    }
}
