//! One level of subdivision: every triangle becomes four.

use super::normals;
use super::tags::{Tags, drawn_creases};
use crate::error::{MeshError, Result};
use crate::mesh::Surface;
use crate::topology::Points;
use crate::topology::edges::{Edges, before, end, next, start};
use glam::{DVec3, Vec2, Vec3, Vec4};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use tree_core::Control;

/// Most vertices, as in [`build`](crate::build).
const MAX_VERTICES: u64 = u32::MAX as u64 - 1;
/// The share of either opposite point in a new point on a smooth edge.
const OPPOSITE: f64 = 1.0 / 8.0;

/// The surface on its way. New vertices and points follow the old ones.
pub(super) struct Work {
    surface: Surface,
    /// Point of each vertex.
    of_vertex: Vec<u32>,
    /// Position of each point.
    places: Vec<Vec3>,
    /// Three points per triangle.
    triangles: Vec<[u32; 3]>,
    /// Per half-edge, whether its edge is a crease.
    creased: Vec<bool>,
    edges: Edges,
}

impl Work {
    pub(super) fn new(surface: &Surface, points: Points, crease: f32) -> Self {
        let triangles = points.triangles(surface);
        let edges = Edges::new(&triangles, points.len());
        Self {
            creased: drawn_creases(surface, &triangles, &edges, crease),
            places: points.first.iter().map(|&v| surface.positions[v as usize]).collect(),
            surface: surface.clone(),
            of_vertex: points.of_vertex,
            triangles,
            edges,
        }
    }

    /// Moves points so that their limits come to where the points were.
    pub(super) fn fit(&mut self, rounds: u32) {
        let tags = Tags::new(&self.triangles, &self.edges, &self.creased, self.places.len());
        let wanted = self.places.clone();
        for _ in 0..rounds {
            let reached = limits(&tags, &self.places);
            let missed = wanted.par_iter().zip(&reached);
            self.places.par_iter_mut().zip(missed).for_each(|(place, (wanted, reached))| {
                *place += *wanted - *reached;
            });
        }
    }

    /// Makes four triangles of each.
    pub(super) fn refine(&mut self, control: &Control) -> Result<()> {
        let n_points = self.places.len();
        let tags = Tags::new(&self.triangles, &self.edges, &self.creased, n_points);
        let mut places = move_points(&tags, &self.places);
        places.par_extend(
            (0..self.edges.len()).into_par_iter().map(|edge| new_point(&tags, &self.places, edge)),
        );
        let creased: Vec<bool> =
            self.edges.of.par_iter().map(|&edge| tags.sharp[edge as usize]).collect();
        control.check()?;

        let copies = Copies::new(&self.edges, &self.surface.indices, self.of_vertex.len());
        if copies.n_vertices > MAX_VERTICES {
            let found = copies.n_vertices;
            return Err(MeshError::TooManyVertices { surface: None, found, max: MAX_VERTICES });
        }
        add_vertices(&mut self.surface, &copies.ends);
        self.of_vertex.extend(copies.edges.iter().map(|&edge| n_points as u32 + edge));
        let quarters = |half: u32, on: &dyn Fn(u32) -> u32, at: &dyn Fn(u32) -> u32| {
            let (b, c) = (next(half), before(half));
            let middle = [on(half), on(b), on(c)];
            [
                [at(half), middle[0], middle[2]],
                [middle[0], at(b), middle[1]],
                [middle[2], middle[1], at(c)],
                middle,
            ]
        };
        let n_halves = self.surface.indices.len() as u32;
        let first_halves = || (0..n_halves / 3).into_par_iter().map(|t| 3 * t);
        let indices: Vec<u32> = first_halves()
            .flat_map_iter(|half| {
                let on = |half: u32| copies.of_half[half as usize];
                let at = |half: u32| self.surface.indices[half as usize];
                quarters(half, &on, &at).into_iter().flatten()
            })
            .collect();
        let triangles: Vec<[u32; 3]> = first_halves()
            .flat_map_iter(|half| {
                let on = |half: u32| n_points as u32 + self.edges.of[half as usize];
                quarters(half, &on, &|half| start(&self.triangles, half))
            })
            .collect();
        self.creased = first_halves()
            .flat_map_iter(|half| {
                let [ab, bc, ca] = [0, 1, 2].map(|k| creased[half as usize + k]);
                [ab, false, ca, ab, bc, false, false, bc, ca, false, false, false]
            })
            .collect();
        self.surface.indices = indices;
        self.triangles = triangles;
        self.places = places;
        self.edges = Edges::new(&self.triangles, self.places.len());
        control.check()?;
        Ok(())
    }

    /// Positions, normals, tangents and welds of the vertices.
    pub(super) fn finish(mut self) -> Surface {
        let tags = Tags::new(&self.triangles, &self.edges, &self.creased, self.places.len());
        let places = &limits(&tags, &self.places);
        self.surface.positions =
            self.of_vertex.par_iter().map(|&point| places[point as usize]).collect();
        normals::renew(&mut self.surface, &self.of_vertex, places, &tags);
        self.surface.welds.clear();
        if self.of_vertex.len() > self.places.len() {
            let mut first = vec![u32::MAX; self.places.len()];
            for (vertex, &point) in self.of_vertex.iter().enumerate() {
                let first = &mut first[point as usize];
                *first = (*first).min(vertex as u32);
                self.surface.welds.push(*first);
            }
        }
        self.surface
    }
}

/// Loop's share of all neighbours together in a point of `n` edges.
fn share_of_neighbours(n: f64) -> f64 {
    let bend = 0.375 + 0.25 * libm::cos(TAU / n);
    0.625 - bend * bend
}

/// Old points at their new places.
fn move_points(tags: &Tags<'_>, places: &[Vec3]) -> Vec<Vec3> {
    mix(tags, places, 0.25, share_of_neighbours)
}

/// Where points come to lie after endless subdivision.
fn limits(tags: &Tags<'_>, places: &[Vec3]) -> Vec<Vec3> {
    mix(tags, places, 1.0 / 3.0, |n| 1.0 / (0.375 / share_of_neighbours(n) + 1.0))
}

/// Points mixed with their neighbours, which get the share `on_crease` on a crease (along it) and
/// `smooth(valence)` elsewhere.
fn mix(
    tags: &Tags<'_>,
    places: &[Vec3],
    on_crease: f64,
    smooth: impl Fn(f64) -> f64 + Sync,
) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; places.len()];
    for edge in 0..tags.edges.len() {
        let half = tags.edges.halves(edge)[0];
        let (a, b) = (start(tags.triangles, half) as usize, end(tags.triangles, half) as usize);
        for (point, neighbour) in [(a, b), (b, a)] {
            if tags.sharp[edge] || tags.n_sharp[point] < 2 {
                sums[point] += places[neighbour].as_dvec3();
            }
        }
    }
    let mixed = |(point, &place): (usize, &Vec3)| {
        let (share, n) = match (tags.n_sharp[point], f64::from(tags.valence[point])) {
            (_, 0.0) | (3.., _) => return place,
            (2, _) => (on_crease, 2.0),
            (_, n) => (smooth(n), n),
        };
        ((1.0 - share) * place.as_dvec3() + share / n * sums[point]).as_vec3()
    };
    places.par_iter().enumerate().map(mixed).collect()
}

/// The new point on an edge.
fn new_point(tags: &Tags<'_>, places: &[Vec3], edge: usize) -> Vec3 {
    let place = |point: u32| places[point as usize].as_dvec3();
    let halves = tags.edges.halves(edge);
    // Seen from the lower point, so that the sum does not depend on the triangles' order.
    let first = halves[0];
    let (mut a, mut b) = (start(tags.triangles, first), end(tags.triangles, first));
    if a > b {
        (a, b) = (b, a);
    }
    let &[one, other] = halves else {
        return (0.5 * (place(a) + place(b))).as_vec3();
    };
    if tags.sharp[edge] {
        return (0.5 * (place(a) + place(b))).as_vec3();
    }
    let tagged = |point: u32| matches!(tags.n_sharp[point as usize], 1 | 2);
    let leaving = |point: u32| if start(tags.triangles, one) == point { one } else { other };
    let gamma = |point: u32| {
        let theta = match tags.n_sharp[point as usize] {
            1 => TAU / f64::from(tags.valence[point as usize].max(3)),
            _ => PI / f64::from(tags.sector(leaving(point))),
        };
        0.5 - 0.25 * libm::cos(theta)
    };
    let of_a = match (tagged(a), tagged(b)) {
        (true, false) => 0.75 - gamma(a),
        (false, true) => gamma(b),
        _ => 0.375,
    };
    let opposite =
        place(start(tags.triangles, before(one))) + place(start(tags.triangles, before(other)));
    (of_a * place(a) + (0.75 - of_a) * place(b) + OPPOSITE * opposite).as_vec3()
}

/// New vertices: one on each edge, or one for each side where the edge is a seam.
struct Copies {
    /// New vertex on each half-edge.
    of_half: Vec<u32>,
    /// Per new vertex the vertices it stands between.
    ends: Vec<[u32; 2]>,
    /// Per new vertex its edge.
    edges: Vec<u32>,
    n_vertices: u64,
}

impl Copies {
    fn new(edges: &Edges, indices: &[u32], n_old: usize) -> Self {
        let ends = |half: u32| [indices[half as usize], indices[next(half) as usize]];
        let mut copies = Self {
            of_half: vec![0; indices.len()],
            ends: Vec::with_capacity(edges.len()),
            edges: Vec::with_capacity(edges.len()),
            n_vertices: 0,
        };
        for edge in 0..edges.len() {
            let first = copies.ends.len();
            for &half in edges.halves(edge) {
                let [a, b] = ends(half);
                // Only the first is compared: more than two sides are no surface an artist drew.
                let known = copies.ends.get(first).is_some_and(|&e| e == [a, b] || e == [b, a]);
                let vertex = if known { first } else { copies.ends.len() };
                if !known {
                    copies.ends.push([a, b]);
                    copies.edges.push(edge as u32);
                }
                copies.of_half[half as usize] = (n_old + vertex) as u32;
            }
        }
        copies.n_vertices = (n_old + copies.ends.len()) as u64;
        copies
    }
}

/// Carries the columns over to new vertices.
fn add_vertices(surface: &mut Surface, ends: &[[u32; 2]]) {
    fn add<T: Copy + Send + Sync>(
        column: &mut Vec<T>,
        ends: &[[u32; 2]],
        between: impl Fn(T, T) -> T + Sync + Send,
    ) {
        if !column.is_empty() {
            let new: Vec<T> = ends
                .par_iter()
                .map(|&[a, b]| between(column[a as usize], column[b as usize]))
                .collect();
            column.extend(new);
        }
    }
    add(&mut surface.normals, ends, |a: Vec3, b| (a + b).normalize_or(a));
    add(&mut surface.uvs, ends, Vec2::midpoint);
    add(&mut surface.uvs2, ends, Vec2::midpoint);
    add(&mut surface.tangents, ends, |a: Vec4, b| {
        (0.5 * (a + b)).truncate().normalize_or(a.truncate()).extend(a.w)
    });
    // Copies of a point are of one branch; the lower of two is so too, whichever copies are asked.
    add(&mut surface.branches, ends, u32::min);
    add(&mut surface.occlusion, ends, f32::midpoint);
}
