//! Vertices and triangles of the planned bark.

use super::bridge;
use super::flare::Flare;
use super::plan::{AxisPlan, Kind, Plan};
use super::rings::Ring;
use crate::columns::{Columns, Vertex};
use crate::params::MeshParams;
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// Height of the cap on a blunt tip in radii of the tip.
const CAP_HEIGHT: f32 = 0.5;

/// How one axis is clad.
pub(crate) struct Skin<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) axis: u32,
    pub(crate) rings: &'a [Ring],
    pub(crate) flare: Flare,
    repeats: f32,
    v_per_metre: f32,
    bark_width: f32,
}

impl<'a> Skin<'a> {
    pub(crate) fn new(plan: &'a Plan, axis: u32, params: &MeshParams) -> Self {
        Self {
            plan,
            axis,
            rings: plan.rings(axis),
            flare: plan.flare(axis),
            repeats: plan.axes[axis as usize].repeats,
            v_per_metre: -1.0 / params.bark_length,
            bark_width: params.bark_width,
        }
    }

    fn planned(&self) -> &AxisPlan {
        &self.plan.axes[self.axis as usize]
    }

    /// Writes the axis: exactly what was counted.
    pub(crate) fn fill(
        &self,
        params: &MeshParams,
        scratch: &mut bridge::Rims,
        out: &mut Columns<'_>,
    ) {
        let kind = self.planned().kind;
        if kind == Kind::Skipped {
            return;
        }
        for i in 0..self.rings.len() {
            self.ring(i, out);
        }
        for pair in self.rings.windows(2) {
            strip(&pair[0], &pair[1], out);
        }
        if let Some(last) = self.rings.last() {
            self.close_tip(last, out);
        }
        match (kind, self.rings.first()) {
            (Kind::Trunk, Some(first)) => self.close_base(first, out),
            (Kind::Lateral | Kind::Stub, _) => {
                let host = Skin::new(self.plan, self.planned().host, params);
                bridge::fill(self, &host, scratch, out);
            }
            _ => {}
        }
    }

    /// Where corner `k` of a ring stands, `k` up to the number of sides.
    pub(crate) fn corner(&self, ring: &Ring, k: u32) -> Vec3 {
        let k = k % ring.n;
        let corner = self.plan.circles.corners(ring.n)[k as usize];
        let along = ring.station.along;
        if !self.flare.acts(along) {
            return self.round(ring, 0.0).position(corner);
        }
        let stance = self.flare.stance(along, &ring.frame);
        let angle = TAU * k as f32 / ring.n as f32;
        let reach = self.plan.circles.reach(ring.n);
        let radius = reach * ring.station.radius * self.flare.at(along, angle).factor;
        ring.station.position + (stance.normal * corner.x + stance.binormal() * corner.y) * radius
    }

    fn round(&self, ring: &Ring, slope: f32) -> Round {
        Round {
            center: ring.station.position,
            radius: ring.station.radius * self.plan.circles.reach(ring.n),
            normal: ring.frame.normal,
            binormal: ring.frame.binormal(),
            tilt: ring.frame.tangent * slope,
            unit: 1.0 / (1.0 + slope * slope).sqrt(),
        }
    }

    /// Texture coordinates of corner `k`, which may go on past the seam.
    pub(crate) fn uv(&self, ring: &Ring, k: u32) -> Vec2 {
        Vec2::new(self.repeats * k as f32 / ring.n as f32, ring.station.along * self.v_per_metre)
    }

    /// How fast the radius grows along the axis at ring `i`.
    fn slope(&self, i: usize) -> f32 {
        let below = self.rings[i.saturating_sub(1)].station;
        let at = self.rings[i].station;
        let above = match self.rings.get(i + 1) {
            Some(ring) => ring.station,
            None if self.planned().pointed => self.tip(),
            None => at,
        };
        let rise = above.along - below.along;
        if rise > 0.0 { (above.radius - below.radius) / rise } else { 0.0 }
    }

    /// The end of the line; of radius 0.
    fn tip(&self) -> super::curve::Station {
        let end = self.plan.curves.get(self.axis).and_then(|curve| curve.nodes.last().copied());
        super::curve::Station { radius: 0.0, ..end.unwrap_or_default() }
    }

    /// Normal and tangent at corner `k` of ring `i`.
    pub(crate) fn shading(&self, i: usize, k: u32) -> (Vec3, Vec3) {
        let (ring, slope) = (&self.rings[i], self.slope(i));
        let corner = self.plan.circles.corners(ring.n)[(k % ring.n) as usize];
        let round = self.round(ring, slope);
        let along = ring.station.along;
        let sideways = round.tangent(corner);
        if !self.flare.acts(along) {
            return (round.normal(corner), sideways);
        }
        // Gradient of the distance to the surface r(h, θ)·outward.
        let outward = ring.frame.normal * corner.x + round.binormal * corner.y;
        let wide = self.flare.at(along, TAU * (k % ring.n) as f32 / ring.n as f32);
        let steep = slope * wide.factor + ring.station.radius * wide.by_height;
        let normal =
            outward - ring.frame.tangent * steep - sideways * (wide.by_angle / wide.factor);
        let normal = normal.try_normalize().unwrap_or(outward);
        let tangent = sideways + outward * (wide.by_angle / wide.factor);
        (normal, across(tangent, normal).unwrap_or(sideways))
    }

    fn ring(&self, i: usize, out: &mut Columns<'_>) {
        let ring = &self.rings[i];
        if self.flare.acts(ring.station.along) {
            self.flared_ring(i, out);
            return;
        }
        let slope = self.slope(i);
        let n = ring.n as usize;
        let first = out.global(out.next());
        let round = self.round(ring, slope);
        let uv = self.uv(ring, 0);
        let u_step = self.repeats / ring.n as f32;
        let rows = out.rows(n + 1);
        rows.branches.fill(self.axis);
        for (k, &corner) in self.plan.circles.corners(ring.n).iter().enumerate() {
            rows.positions[k] = round.position(corner);
            rows.normals[k] = round.normal(corner);
            rows.uvs[k] = Vec2::new(u_step * k as f32, uv.y);
            rows.welds[k] = first + k as u32;
        }
        rows.positions[n] = rows.positions[0];
        rows.normals[n] = rows.normals[0];
        rows.uvs[n] = Vec2::new(self.repeats, uv.y);
        rows.welds[n] = first;
        if let Some((seam, tangents)) = rows.tangents.split_last_mut() {
            let corners = self.plan.circles.corners(ring.n);
            for (tangent, &corner) in tangents.iter_mut().zip(corners) {
                *tangent = round.tangent(corner).extend(1.0);
            }
            *seam = tangents.first().copied().unwrap_or(*seam);
        }
    }

    fn flared_ring(&self, i: usize, out: &mut Columns<'_>) {
        let ring = &self.rings[i];
        let first = out.next();
        for k in 0..=ring.n {
            let (normal, tangent) = self.shading(i, k);
            out.vertex(Vertex {
                position: self.corner(ring, k),
                normal,
                tangent,
                uv: self.uv(ring, k),
                branch: self.axis,
                weld: out.global(first + k % ring.n),
            });
        }
    }

    fn close_tip(&self, ring: &Ring, out: &mut Columns<'_>) {
        let tip = self.tip();
        let pointed = self.planned().pointed;
        let direction = ring.frame.tangent;
        let (apex, v) = if pointed {
            (tip.position, tip.along * self.v_per_metre)
        } else {
            let rise = CAP_HEIGHT * ring.station.radius;
            let along = ring.station.along + libm::hypotf(rise, ring.station.radius);
            (ring.station.position + direction * rise, along * self.v_per_metre)
        };
        let first = out.next();
        for k in 0..ring.n {
            let (a, b) = ((ring.first + k) as usize, (ring.first + k + 1) as usize);
            let between = out.normals[a] + out.normals[b];
            let normal = if pointed { between.try_normalize() } else { None }.unwrap_or(direction);
            let side = out.positions[b] - out.positions[a];
            out.vertex(Vertex {
                position: apex,
                normal,
                tangent: across(side, normal).unwrap_or(normal.any_orthonormal_vector()),
                uv: Vec2::new(self.repeats * (k as f32 + 0.5) / ring.n as f32, v),
                branch: self.axis,
                weld: out.global(first),
            });
            out.triangle([ring.first + k, ring.first + k + 1, first + k]);
        }
    }

    /// From the middle: between buttresses the outline is not convex.
    fn close_base(&self, ring: &Ring, out: &mut Columns<'_>) {
        let frame = self.flare.stance(ring.station.along, &ring.frame);
        let flat = |position: Vec3| {
            let arm = position - ring.station.position;
            -Vec2::new(arm.dot(frame.normal), arm.dot(frame.binormal())) / self.bark_width
        };
        let middle = out.next();
        let vertex = |position, weld| Vertex {
            position,
            normal: -frame.tangent,
            tangent: -frame.normal,
            uv: flat(position),
            branch: self.axis,
            weld,
        };
        let (center, weld) = (ring.station.position, out.global(middle));
        out.vertex(vertex(center, weld));
        for k in 0..ring.n {
            let (position, weld) =
                (out.positions[(ring.first + k) as usize], out.global(ring.first + k));
            out.vertex(vertex(position, weld));
            out.triangle([middle, middle + 1 + (k + 1) % ring.n, middle + 1 + k]);
        }
    }
}

/// A ring without flare. Bridges ask for the same corners as the ring itself and must get the same bits.
struct Round {
    center: Vec3,
    /// Of its corners.
    radius: f32,
    normal: Vec3,
    binormal: Vec3,
    /// Along the axis, with a length that tilts normals by the slope, and what then makes them unit.
    tilt: Vec3,
    unit: f32,
}

impl Round {
    fn position(&self, corner: Vec2) -> Vec3 {
        self.center + (self.normal * corner.x + self.binormal * corner.y) * self.radius
    }

    fn normal(&self, corner: Vec2) -> Vec3 {
        (self.normal * corner.x + self.binormal * corner.y - self.tilt) * self.unit
    }

    fn tangent(&self, corner: Vec2) -> Vec3 {
        self.binormal * corner.x - self.normal * corner.y
    }
}

/// The unit part of `v` across `normal`; `None` where they are so near to parallel that rounding would
/// choose it.
pub(crate) fn across(v: Vec3, normal: Vec3) -> Option<Vec3> {
    let part = v - normal * v.dot(normal);
    if part.length_squared() > 1e-4 * v.length_squared() { part.try_normalize() } else { None }
}

/// Joins two rings by a strip of `below.n + above.n` triangles, less two for each hole's column.
fn strip(below: &Ring, above: &Ring, out: &mut Columns<'_>) {
    if below.n == above.n {
        let (from, to) = (out.global(below.first), out.global(above.first));
        let free = (0..below.n).filter(|k| below.mask >> k & 1 == 0);
        let n_free = below.n - below.mask.count_ones();
        let corners = out.triangles(2 * n_free as usize).chunks_exact_mut(6);
        for (k, corners) in free.zip(corners) {
            let (a, b) = (from + k, to + k);
            corners.copy_from_slice(&[a, a + 1, b + 1, a, b + 1, b]);
        }
        return;
    }
    let (mut i, mut j) = (0, 0);
    while i < below.n || j < above.n {
        let (a, b) = (below.first + i, above.first + j);
        // The next corner of the lower ring stands at (i+1)/n, of the upper one at (j+1)/m.
        if i < below.n && (i + 1) * above.n <= (j + 1) * below.n {
            out.triangle([a, a + 1, b]);
            i += 1;
        } else {
            out.triangle([a, b + 1, b]);
            j += 1;
        }
    }
}
