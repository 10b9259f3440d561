//! Planes by greedy choice (Décoret, Durand, Sillion, Dorsey 2003, "Billboard clouds for extreme model
//! simplification").
//!
//! 1. The dual space of planes is discretised: directions evenly over half a sphere, offsets in steps
//!    of half the error ε.
//! 2. A plane is valid for an element if all its vertices lie within ε of it. The density of a plane is
//!    the projected area of the elements it is valid for.
//! 3. The densest plane becomes a billboard, its elements are taken out of the density, and so on.
//!
//! Departures: elements (cards, leaves) instead of triangles, so that no leaf is cut in two; the
//! candidates are the planes at the middles of the cells, so cells need not be refined, but a plane moves to
//! the one nearest to its elements' vertices (least squares) where that is valid and shows no less of them; no penalty for planes
//! that just miss elements. ε follows, by halving, from the number of billboards asked for. Elements for which
//! no direction is valid get a billboard of their own.
//!
//! O(elements × directions) time and 12 bytes of memory each, times halvings for the time.

use super::{Billboard, corners, principal_axes};
use rayon::prelude::*;
use std::f32::consts::TAU;
use tree_core::glam::Vec3;
use tree_lod::Elements;
use tree_mesh::Mesh;

/// Directions over half a sphere, 9° apart.
const DIRECTIONS: usize = 256;
/// Halvings of the interval of ε.
const HALVINGS: u32 = 14;

/// How an element lies along a direction.
#[derive(Clone, Copy)]
struct Lie {
    low: f32,
    high: f32,
    /// Area projected along the direction, both sides of a blade counted once.
    area: f32,
}

/// At most `n` billboards for all elements; fewer than `n` elements get as many as there are.
pub(in super::super) fn decoret(mesh: &Mesh, elements: &Elements, n: usize) -> Vec<Billboard> {
    let directions = directions();
    let lies = lies(mesh, elements, &directions);
    let (_, radius) = mesh.bounding_sphere().unwrap_or((Vec3::ZERO, 1.0));
    let (mut low, mut high) = (1e-3 * radius, radius);
    let mut best = greedy(&lies, high, n.max(1));
    for _ in 0..HALVINGS {
        // The number falls as some power of ε.
        let middle = (low * high).sqrt();
        match greedy(&lies, middle, n) {
            Some(planes) => (best, high) = (Some(planes), middle),
            None => low = middle,
        }
    }
    best.unwrap_or_default()
        .into_par_iter()
        .map(|(plane, of)| {
            let (normal, point) = match plane {
                Some((direction, offset)) => {
                    fitted(mesh, elements, &of, (directions[direction], offset), high)
                }
                None => own(elements, of[0] as usize),
            };
            Billboard::around(mesh, elements, of, normal, point)
        })
        .collect()
}

/// Normal and a point of the plane nearest to the vertices of some elements, or of the one they have.
fn fitted(
    mesh: &Mesh,
    elements: &Elements,
    of: &[u32],
    (normal, offset): (Vec3, f32),
    epsilon: f32,
) -> (Vec3, Vec3) {
    let points: Vec<Vec3> = of.iter().flat_map(|&e| corners(mesh, elements, e as usize)).collect();
    let mean = points.iter().sum::<Vec3>() / points.len().max(1) as f32;
    let [flattest, ..] = principal_axes(&points);
    let shown = |n: Vec3| -> f32 {
        let (triangles, _) = points.as_chunks::<3>();
        triangles.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a).dot(n).abs()).sum()
    };
    let valid = points.iter().all(|p| (*p - mean).dot(flattest).abs() <= epsilon);
    if valid && shown(flattest) >= shown(normal) {
        (flattest, mean)
    } else {
        (normal, normal * offset)
    }
}

/// The plane of a single element.
fn own(elements: &Elements, element: usize) -> (Vec3, Vec3) {
    (elements.normals[element].try_normalize().unwrap_or(Vec3::Z), elements.centers[element])
}

/// Evenly over the upper half of the sphere (a Fibonacci lattice).
fn directions() -> Vec<Vec3> {
    const GOLDEN: f32 = 0.618_034;
    (0..DIRECTIONS)
        .map(|i| {
            let y = (i as f32 + 0.5) / DIRECTIONS as f32;
            let (sin, cos) = libm::sincosf(TAU * (i as f32 * GOLDEN).fract());
            let r = (1.0 - y * y).sqrt();
            Vec3::new(r * cos, y, r * sin)
        })
        .collect()
}

/// Row by row for elements, a column for each direction.
fn lies(mesh: &Mesh, elements: &Elements, directions: &[Vec3]) -> Vec<Vec<Lie>> {
    let of = |element| {
        let points: Vec<Vec3> = corners(mesh, elements, element).collect();
        let lie = |n: &Vec3| {
            let mut lie = Lie { low: f32::INFINITY, high: f32::NEG_INFINITY, area: 0.0 };
            for [a, b, c] in points.as_chunks::<3>().0 {
                for p in [a, b, c] {
                    let d = n.dot(*p);
                    (lie.low, lie.high) = (lie.low.min(d), lie.high.max(d));
                }
                lie.area += 0.5 * (b - a).cross(c - a).dot(*n).abs();
            }
            lie
        };
        directions.iter().map(lie).collect()
    };
    (0..elements.len()).into_par_iter().map(of).collect()
}

/// A plane (direction, offset), or `None` for that of the only element, and its elements.
type Taken = (Option<(usize, f32)>, Vec<u32>);

/// Planes for all elements with an error of `epsilon`; `None` when it takes more than `most`.
fn greedy(lies: &[Vec<Lie>], epsilon: f32, most: usize) -> Option<Vec<Taken>> {
    let mut dual = Dual::new(lies, epsilon);
    let mut left: Vec<u32> = (0..lies.len() as u32).collect();
    let mut taken = Vec::new();
    while !left.is_empty() {
        let Some(cell) = dual.densest() else { break };
        let (direction, offset) = dual.plane(cell);
        let valid = |&e: &u32| {
            let lie = lies[e as usize][direction];
            lie.high - epsilon <= offset && offset <= lie.low + epsilon
        };
        let (mine, rest): (Vec<u32>, Vec<u32>) = left.iter().partition(|e| valid(e));
        // Only rounding was left of this cell.
        dual.density[cell] = 0.0;
        if mine.is_empty() {
            continue;
        }
        mine.iter().for_each(|&e| dual.add(&lies[e as usize], -1.0));
        left = rest;
        taken.push((Some((direction, offset)), mine));
        if taken.len() > most {
            return None;
        }
    }
    taken.extend(left.into_iter().map(|element| (None, vec![element])));
    (taken.len() <= most).then_some(taken)
}

/// Density of each plane.
struct Dual {
    low: f32,
    step: f32,
    epsilon: f32,
    n_offsets: usize,
    density: Vec<f32>,
}

impl Dual {
    fn new(lies: &[Vec<Lie>], epsilon: f32) -> Self {
        let all = || lies.iter().flatten();
        let low = all().fold(f32::INFINITY, |low, lie| low.min(lie.low)) - epsilon;
        let high = all().fold(f32::NEG_INFINITY, |high, lie| high.max(lie.high)) + epsilon;
        let step = 0.5 * epsilon;
        let n_offsets = ((high - low).max(0.0) / step) as usize + 2;
        let density = vec![0.0; DIRECTIONS * n_offsets];
        let mut dual = Self { low, step, epsilon, n_offsets, density };
        lies.iter().for_each(|lie| dual.add(lie, 1.0));
        dual
    }

    /// Adds an element's areas to the planes that are valid for it, times `sign`.
    fn add(&mut self, lies: &[Lie], sign: f32) {
        for (direction, lie) in lies.iter().enumerate() {
            let from = libm::ceilf((lie.high - self.epsilon - self.low) / self.step).max(0.0);
            let to = libm::floorf((lie.low + self.epsilon - self.low) / self.step);
            if from <= to {
                let row = &mut self.density[direction * self.n_offsets..][..self.n_offsets];
                let last = (to as usize + 1).min(self.n_offsets);
                row[(from as usize).min(last)..last]
                    .iter_mut()
                    .for_each(|density| *density += sign * lie.area);
            }
        }
    }

    /// The first of the densest cells that hold anything.
    fn densest(&self) -> Option<usize> {
        let mut best = None;
        let mut most = 0.0;
        for (cell, &density) in self.density.iter().enumerate() {
            if density > most {
                (best, most) = (Some(cell), density);
            }
        }
        best
    }

    fn plane(&self, cell: usize) -> (usize, f32) {
        (cell / self.n_offsets, self.low + (cell % self.n_offsets) as f32 * self.step)
    }
}
