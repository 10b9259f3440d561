//! Which edges are creases, and what that makes of points.

use crate::mesh::Surface;
use crate::topology::edges::{Edges, NONE, before, end, next, start};

/// Steps of a walk about a point after which its sector counts as endless.
const WALK_MAX: u32 = 64;

/// Per half-edge of the surface, whether its edge was drawn as a crease: the normals of the triangles
/// on its sides differ by more than `angle` at both ends.
pub(super) fn drawn_creases(
    surface: &Surface,
    triangles: &[[u32; 3]],
    edges: &Edges,
    angle: f32,
) -> Vec<bool> {
    let cosine = libm::cosf(angle);
    let normal = |half: u32| surface.normals[surface.indices[half as usize] as usize];
    let split = |a: u32, b: u32| normal(a).dot(normal(b)) < cosine;
    (0..surface.indices.len() as u32)
        .map(|half| {
            let twin = edges.twin(half, triangles);
            twin != NONE && split(half, next(twin)) && split(next(half), twin)
        })
        .collect()
}

/// Creases of one level.
pub(super) struct Tags<'a> {
    pub(super) triangles: &'a [[u32; 3]],
    pub(super) edges: &'a Edges,
    /// Per edge.
    pub(super) sharp: Vec<bool>,
    /// Creased edges of each point, counted up to 3: a corner.
    pub(super) n_sharp: Vec<u8>,
    /// Edges of each point.
    pub(super) valence: Vec<u32>,
}

impl<'a> Tags<'a> {
    /// `drawn` tells of every half-edge whether its edge was drawn as a crease.
    pub(super) fn new(
        triangles: &'a [[u32; 3]],
        edges: &'a Edges,
        drawn: &[bool],
        n_points: usize,
    ) -> Self {
        let mut tags = Self {
            triangles,
            edges,
            sharp: Vec::with_capacity(edges.len()),
            n_sharp: vec![0; n_points],
            valence: vec![0; n_points],
        };
        for edge in 0..edges.len() {
            let halves = edges.halves(edge);
            let half = halves[0];
            let sharp =
                edges.twin(half, triangles) == NONE || halves.iter().any(|&h| drawn[h as usize]);
            tags.sharp.push(sharp);
            for point in [start(triangles, half), end(triangles, half)] {
                tags.valence[point as usize] += 1;
                if sharp {
                    let n = &mut tags.n_sharp[point as usize];
                    *n = (*n + 1).min(3);
                }
            }
        }
        tags
    }

    fn is_sharp(&self, half: u32) -> bool {
        self.sharp[self.edges.of[half as usize] as usize]
    }

    /// From a half-edge that leaves a point, the next one counter-clockwise; `None` over a crease.
    pub(super) fn turn_left(&self, half: u32) -> Option<u32> {
        let coming = before(half);
        (!self.is_sharp(coming)).then(|| self.edges.twin(coming, self.triangles))
    }

    /// From a half-edge that leaves a point, the next one clockwise; `None` over a crease.
    pub(super) fn turn_right(&self, half: u32) -> Option<u32> {
        (!self.is_sharp(half)).then(|| next(self.edges.twin(half, self.triangles)))
    }

    /// Triangles between creases about the point that a smooth half-edge leaves, up to 2·64.
    pub(super) fn sector(&self, half: u32) -> u32 {
        let (mut n, mut at) = (1, half);
        while let Some(left) = self.turn_left(at)
            && n < WALK_MAX
        {
            (at, n) = (left, n + 1);
        }
        let (mut m, mut at) = (0, half);
        while let Some(right) = self.turn_right(at)
            && m < WALK_MAX
        {
            (at, m) = (right, m + 1);
        }
        n + m
    }
}
