//! Vertices on the picture, and clipping of the triangles that do not fit on it.
//!
//! 1. Every vertex is projected once per view, to fixed-point coordinates ([`SUBSAMPLES`] steps per
//!    sample), in parallel.
//! 2. A triangle with a vertex behind the near plane or outside the guard band is clipped as a
//!    polygon in view space (Sutherland, Hodgman 1974). New corners are computed from the inner end
//!    of an edge to the outer one, whichever way the triangle runs, so that neighbours still meet.

use super::camera::Projector;
use super::scene::Scene;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Fixed-point steps per sample.
pub(super) const SUBSAMPLES: i32 = 256;
/// How far outside the picture fixed-point coordinates reach, in samples. With 8 fractional bits,
/// edge functions stay below 2⁶², far from overflow.
const GUARD: f32 = 2_097_152.0;
/// Marks a vertex that is behind the near plane or beyond the guard band.
const OUTSIDE: i32 = i32::MIN;
/// Vertices per parallel piece.
const PIECE: usize = 16_384;

/// A vertex on the picture.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spot {
    /// In 1 / [`SUBSAMPLES`] of a sample, from the top left corner.
    pub(super) x: i32,
    pub(super) y: i32,
    /// See [`Projector`].
    pub(super) depth: f32,
}

impl Spot {
    #[inline]
    pub(super) fn is_outside(&self) -> bool {
        self.x == OUTSIDE
    }
}

/// A corner of a clipped polygon.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Corner {
    pub(super) spot: Spot,
    pub(super) uv: Vec2,
}

/// Projects all vertices, reusing `spots`.
pub(super) fn project_all(scene: &Scene<'_>, projector: &Projector, spots: &mut Vec<Spot>) {
    spots.clear();
    spots.resize(scene.n_vertices(), Spot::default());
    let mut rest = spots.as_mut_slice();
    let mut pieces = Vec::new();
    for surface in &scene.mesh.surfaces {
        let (mine, others) = rest.split_at_mut(surface.positions.len());
        rest = others;
        pieces.extend(mine.chunks_mut(PIECE).zip(surface.positions.chunks(PIECE)));
    }
    pieces.into_par_iter().for_each(|(spots, positions)| {
        for (spot, &p) in spots.iter_mut().zip(positions) {
            *spot = projector.spot(projector.view(p));
        }
    });
}

impl Projector {
    /// A point in view coordinates on the picture.
    #[inline]
    pub(crate) fn spot(&self, v: Vec3) -> Spot {
        let (x, y, depth) = self.place(v);
        // Written so that NaN (0 / 0 at the eye) counts as outside.
        let inside = v.z >= self.near && x.abs() <= GUARD && y.abs() <= GUARD;
        Spot { x: if inside { fixed(x) } else { OUTSIDE }, y: fixed(y), depth }
    }
}

impl Projector {
    /// Whether a point in view coordinates is in front of the near plane and within the guard band.
    #[inline]
    pub(crate) fn shows(&self, v: Vec3) -> bool {
        let at = self.on_picture(v);
        v.z >= self.near && at.x.abs() <= GUARD && at.y.abs() <= GUARD
    }

    /// A point in view coordinates in samples from the top left.
    #[inline]
    pub(crate) fn on_picture(&self, v: Vec3) -> Vec2 {
        let (x, y, _) = self.place(v);
        Vec2::new(x, y)
    }

    #[inline]
    fn place(&self, v: Vec3) -> (f32, f32, f32) {
        let (scale, depth) =
            if self.perspective { (self.scale / v.z, 1.0 / v.z) } else { (self.scale, -v.z) };
        (self.center.x + v.x * scale, self.center.y - v.y * scale, depth)
    }

    /// As [`spot`](Self::spot), for a corner that was cut off: the rounding of a cut through a long
    /// edge may leave it a little outside, from where it is brought back.
    fn spot_within(&self, v: Vec3) -> Spot {
        let (x, y, depth) = self.place(Vec3::new(v.x, v.y, v.z.max(self.near)));
        let within = |t: f32| t.clamp(-GUARD, GUARD);
        Spot { x: fixed(within(x)), y: fixed(within(y)), depth }
    }
}

/// Rounds to fixed point.
#[inline]
fn fixed(samples: f32) -> i32 {
    let steps = samples * SUBSAMPLES as f32;
    (steps + 0.5_f32.copysign(steps)) as i32
}

/// Corners of a triangle after five cuts: three and one more for each.
pub(super) const MOST_CORNERS: usize = 8;

#[derive(Clone, Copy, Default)]
struct Loose {
    view: Vec3,
    uv: Vec2,
}

/// What is left of a triangle in front of the near plane and inside the guard band; a convex
/// polygon, as corners and their number (0 if nothing is left).
pub(super) fn clip(
    positions: [Vec3; 3],
    uvs: [Vec2; 3],
    projector: &Projector,
) -> ([Corner; MOST_CORNERS], usize) {
    let mut polygon = [Loose::default(); MOST_CORNERS];
    for i in 0..3 {
        polygon[i] = Loose { view: projector.view(positions[i]), uv: uvs[i] };
    }
    let mut count = 3;
    // Half the guard band, measured from the optical axis, is far beyond any picture.
    let reach = 0.5 * GUARD / projector.scale;
    let side = |v: Vec3| {
        if projector.perspective { reach * v.z } else { reach }
    };
    let near = projector.near;
    let distances: [&dyn Fn(Vec3) -> f32; 5] =
        [&|v| v.z - near, &|v| side(v) - v.x, &|v| side(v) + v.x, &|v| side(v) - v.y, &|v| {
            side(v) + v.y
        }];
    for distance in distances {
        (polygon, count) = cut(&polygon, count, distance);
    }
    let mut corners = [Corner::default(); MOST_CORNERS];
    for (corner, loose) in corners.iter_mut().zip(&polygon[..count]) {
        *corner = Corner { spot: projector.spot_within(loose.view), uv: loose.uv };
    }
    (corners, count)
}

/// As [`clip`], in samples and with the distance along the line of sight.
pub(crate) fn clip_loose(
    positions: [Vec3; 3],
    uvs: [Vec2; 3],
    projector: &Projector,
) -> ([(Vec2, f32, Vec2); MOST_CORNERS], usize) {
    let (corners, n) = clip(positions, uvs, projector);
    let loose = corners.map(|Corner { spot, uv }| {
        let at = Vec2::new(spot.x as f32, spot.y as f32) / SUBSAMPLES as f32;
        let z = if projector.perspective { 1.0 / spot.depth } else { -spot.depth };
        (at, z, uv)
    });
    (loose, n)
}

/// Keeps the part where `distance` is not negative.
fn cut(
    polygon: &[Loose; MOST_CORNERS],
    count: usize,
    distance: &dyn Fn(Vec3) -> f32,
) -> ([Loose; MOST_CORNERS], usize) {
    let (mut kept, mut n) = ([Loose::default(); MOST_CORNERS], 0);
    let mut push = |loose: Loose| {
        if n < MOST_CORNERS {
            kept[n] = loose;
            n += 1;
        }
    };
    for i in 0..count {
        let (a, b) = (polygon[i], polygon[(i + 1) % count]);
        let (da, db) = (distance(a.view), distance(b.view));
        if da >= 0.0 {
            push(a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            let (inner, outer, di, do_) = if da >= 0.0 { (a, b, da, db) } else { (b, a, db, da) };
            let t = di / (di - do_);
            push(Loose {
                view: inner.view + (outer.view - inner.view) * t,
                uv: inner.uv + (outer.uv - inner.uv) * t,
            });
        }
    }
    (kept, n)
}
