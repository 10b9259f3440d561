//! Half-edge collapses: a vertex is moved onto a neighbour, so that only own vertices are used.
//!
//! Garland and Heckbert 1997 with vertices that stay where they are. Planes count by the area of their
//! triangles; edges of the margin add a plane across the surface, which keeps the outline. A collapse is
//! refused when it would turn a triangle over or pinch the surface (link condition).

use super::quadric::Quadric;
use super::shape::Blade;
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Weight of the margin's planes against those of triangles: the outline is what is seen.
const MARGIN_WEIGHT: f64 = 4.0;
/// Cost of the length of a collapse, squared, against squared distances: among equals, short ones.
const LENGTH_COST: f64 = 1e-6;
/// Least cosine between a triangle's own normal and the one that it has after collapses.
const TURN_MIN: f64 = 0.2;

/// A collapse that was weighed: cost, from, to, and how often both had changed by then.
type Weighed = Reverse<(u64, u32, u32, u32, u32)>;

struct Surface {
    points: Vec<DVec3>,
    quadrics: Vec<Quadric>,
    /// Triangles around each vertex, also some that are gone.
    around: Vec<Vec<u32>>,
    triangles: Vec<Option<[u32; 3]>>,
    /// Vector areas of the blade's own triangles, which the collapsed ones may not turn away from.
    crosses: Vec<DVec3>,
    n: usize,
    changes: Vec<u32>,
    waiting: BinaryHeap<Weighed>,
}

/// The blade collapsed to each target, or as far as it goes. Targets fall.
///
/// # Complexity
/// O(n log n) for vertices with few neighbours.
pub(super) fn collapsed(blade: &Blade, targets: &[usize]) -> Vec<Vec<[u32; 3]>> {
    let mut surface = Surface::of(blade);
    targets
        .iter()
        .map(|&target| {
            surface.shrink(target.max(1));
            surface.triangles.iter().flatten().copied().collect()
        })
        .collect()
}

impl Surface {
    fn of(blade: &Blade) -> Self {
        let n = blade.points.len();
        let mut surface = Self {
            points: blade.points.iter().map(|p| p.as_dvec3()).collect(),
            quadrics: vec![Quadric::default(); n],
            around: vec![Vec::new(); n],
            triangles: blade.triangles.iter().copied().map(Some).collect(),
            crosses: Vec::new(),
            n: blade.triangles.len(),
            changes: vec![0; n],
            waiting: BinaryHeap::new(),
        };
        surface.crosses = blade.triangles.iter().map(|&t| surface.cross(t)).collect();
        for (row, &triangle) in blade.triangles.iter().enumerate() {
            for v in triangle {
                surface.around[v as usize].push(row as u32);
            }
        }
        for &triangle in &blade.triangles {
            surface.add_planes(triangle);
        }
        for v in 0..n as u32 {
            surface.weigh_around(v);
        }
        surface
    }

    fn point(&self, v: u32) -> DVec3 {
        self.points[v as usize]
    }

    fn cross(&self, [a, b, c]: [u32; 3]) -> DVec3 {
        0.5 * (self.point(b) - self.point(a)).cross(self.point(c) - self.point(a))
    }

    fn add_planes(&mut self, triangle: [u32; 3]) {
        let cross = self.cross(triangle);
        let normal = cross.normalize_or_zero();
        let plane = Quadric::plane(normal, self.point(triangle[0]), cross.length());
        for i in 0..3 {
            let (a, b) = (triangle[i], triangle[(i + 1) % 3]);
            self.quadrics[a as usize] = self.quadrics[a as usize] + plane;
            if self.n_shared(a, b) == 1 {
                let along = self.point(b) - self.point(a);
                let across = along.cross(normal).normalize_or_zero();
                let weight = MARGIN_WEIGHT * along.length_squared();
                let margin = Quadric::plane(across, self.point(a), weight);
                for v in [a, b] {
                    self.quadrics[v as usize] = self.quadrics[v as usize] + margin;
                }
            }
        }
    }

    /// Rows and corners of the triangles around a vertex.
    fn fan(&self, v: u32) -> impl Iterator<Item = (u32, [u32; 3])> + '_ {
        let rows = self.around[v as usize].iter();
        rows.filter_map(|&row| Some((row, self.triangles[row as usize]?)))
    }

    fn n_shared(&self, a: u32, b: u32) -> usize {
        self.fan(a).filter(|(_, t)| t.contains(&b)).count()
    }

    fn neighbours(&self, v: u32) -> Vec<u32> {
        let mut all: Vec<u32> = self.fan(v).flat_map(|(_, t)| t).filter(|&w| w != v).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn on_margin(&self, v: u32) -> bool {
        self.neighbours(v).iter().any(|&w| self.n_shared(v, w) == 1)
    }

    fn weigh_around(&mut self, v: u32) {
        for w in self.neighbours(v) {
            self.weigh(v, w);
            self.weigh(w, v);
        }
    }

    fn weigh(&mut self, from: u32, to: u32) {
        let (p, q) = (self.point(from), self.point(to));
        let sum = self.quadrics[from as usize] + self.quadrics[to as usize];
        let cost = sum.at(q) + LENGTH_COST * p.distance_squared(q);
        let changes = [from, to].map(|v| self.changes[v as usize]);
        // Costs are not negative, so that their bits order as they do.
        self.waiting.push(Reverse((cost.to_bits(), from, to, changes[0], changes[1])));
    }

    fn shrink(&mut self, target: usize) {
        while self.n > target {
            let Some(Reverse((_, from, to, a, b))) = self.waiting.pop() else { return };
            let current = [from, to].map(|v| self.changes[v as usize]) == [a, b];
            if current && self.may(from, to) {
                self.collapse(from, to);
            }
        }
    }

    fn may(&self, from: u32, to: u32) -> bool {
        let shared = self.n_shared(from, to);
        let others = self.neighbours(to);
        let common =
            self.neighbours(from).iter().filter(|v| others.binary_search(v).is_ok()).count();
        if shared == 0 || common != shared {
            return false;
        }
        if shared > 1 && self.on_margin(from) && self.on_margin(to) {
            return false;
        }
        self.fan(from).filter(|(_, t)| !t.contains(&to)).all(|(row, t)| {
            let (old, new) =
                (self.crosses[row as usize], self.cross(t.map(|v| if v == from { to } else { v })));
            new.length_squared() > 0.0 && old.dot(new) > TURN_MIN * old.length() * new.length()
        })
    }

    fn collapse(&mut self, from: u32, to: u32) {
        let rows = std::mem::take(&mut self.around[from as usize]);
        for row in rows {
            let Some(t) = self.triangles[row as usize] else { continue };
            if t.contains(&to) {
                self.triangles[row as usize] = None;
                self.n -= 1;
            } else {
                self.triangles[row as usize] = Some(t.map(|v| if v == from { to } else { v }));
                self.around[to as usize].push(row);
            }
        }
        self.quadrics[to as usize] = self.quadrics[to as usize] + self.quadrics[from as usize];
        self.changes[from as usize] += 1;
        self.changes[to as usize] += 1;
        let triangles = &self.triangles;
        self.around[to as usize].retain(|&row| triangles[row as usize].is_some());
        self.weigh_around(to);
    }
}
