//! Bridges: the wall between a hole in the host and the first ring of a lateral.
//!
//! The rim of a hole is the lower side of its columns from left to right, then the upper side from
//! right to left: counter-clockwise seen from outside, as is the ring. Both are zipped by their angle
//! about the lateral's axis. Whatever the angles, the zip uses each edge of rim and ring once, so the
//! surface stays closed. Where a hole is much wider than its lateral, or the lateral is thick, a ring of
//! feet stands on the wall round the lateral: outside of it the wall goes on as if there were no hole,
//! inside the bark rises to the lateral.
//!
//! A bridge wears the host's bark; inside the feet, texture coordinates run towards the middle as far
//! as the way is long. The lateral's own bark starts at its first ring.

use super::plan::Kind;
use super::rings::Ring;
use super::skin::{Skin, across};
use crate::columns::{Columns, Vertex};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// How near to the middle of the hole the host's bark may be drawn together.
const GATHER: f32 = 0.9;
/// Smallest cosine between lateral and wall that a ring is projected back onto the wall with.
const COSINE_MIN: f32 = 0.2;
/// Feet stand on the wall at this many radii from the lateral's axis.
const FOOT: f32 = 1.3;
/// Feet nearer to each other than this share of the radius lie in one place.
const MERGED: f32 = 1e-3;
/// The middle of a lateral stays off the rim by this share of the hole: on it, feet and rim would lie on one line.
const MARGIN: f32 = 0.2;
/// Where the rim is nearer than that, they stand at this share of the way to it.
const CROWDED: f32 = 0.85;

/// A vertex of a rim.
#[derive(Clone, Copy, Debug)]
struct Rim {
    position: Vec3,
    normal: Vec3,
    uv: Vec2,
    vertex: u32,
    /// About the lateral's axis, never falling along the rim.
    angle: f32,
}

/// Rims, reused from lateral to lateral.
#[derive(Debug, Default)]
pub(crate) struct Rims {
    rims: Vec<Rim>,
    /// The rim at the angle of each corner of the ring, then the feet there.
    feet: Vec<Spot>,
}

/// Writes the bridge of `lateral` to its host, or the point of a stub.
pub(crate) fn fill(lateral: &Skin<'_>, host: &Skin<'_>, rims: &mut Rims, out: &mut Columns<'_>) {
    let plan = &lateral.plan.axes[lateral.axis as usize];
    rim(lateral, host, rims, out);
    let middle = mean(&rims.rims);
    if plan.kind == Kind::Stub {
        point(lateral, &middle, rims, out);
        return;
    }
    let Some(ring) = lateral.rings.first() else { return };
    turn(ring, rims);
    find_feet(ring, rims);
    let Some(wall) = Wall::of(host, plan.hole_ring as usize, &middle) else { return };
    let center = wall.spot(ring.station.position, ring.frame.tangent);
    let center = wall.within(center, &rims.rims);
    let bridge = Bridge { lateral, ring, wall, center };
    let n = ring.n;
    let with_feet = lateral.plan.has_feet(lateral.axis);
    if with_feet {
        bridge.place_feet(&mut rims.feet);
    }
    let collar = out.next();
    for (k, foot) in rims.feet.iter().enumerate() {
        out.vertex(bridge.collar(k as u32, foot, out.global(ring.first + k as u32)));
    }
    let mut inner = collar;
    if with_feet {
        inner = out.next();
        for (k, foot) in rims.feet.iter().enumerate() {
            let weld = out.global(inner + k as u32);
            out.vertex(bridge.vertex(foot.position, foot.normal, foot.uv, weld));
        }
        for k in 0..n {
            let (a, b, next) = (inner + k, collar + k, (k + 1) % n);
            out.triangle([a, inner + next, collar + next]);
            out.triangle([a, collar + next, b]);
        }
    }
    zip(&rims.rims, out.global(inner), n, out);
}

/// Finds the rim; draws those of its vertices again that lie beyond the seam.
fn rim(lateral: &Skin<'_>, host: &Skin<'_>, rims: &mut Rims, out: &mut Columns<'_>) {
    let plan = &lateral.plan.axes[lateral.axis as usize];
    let first_vertex = host.plan.axes[host.axis as usize].first_vertex;
    rims.rims.clear();
    for side in 0..2 {
        let number = plan.hole_ring as usize + side;
        let Some(ring) = host.rings.get(number) else { return };
        for step in 0..=plan.hole.width {
            let step = if side == 0 { step } else { plan.hole.width - step };
            let column = plan.hole.column + step;
            let (normal, tangent) = host.shading(number, column);
            let (position, uv) = (host.corner(ring, column), host.uv(ring, column));
            let mut vertex = first_vertex + ring.first + column;
            if column > ring.n {
                let weld = first_vertex + ring.first + column % ring.n;
                vertex = out.global(out.next());
                out.vertex(Vertex { position, normal, tangent, uv, branch: host.axis, weld });
            }
            rims.rims.push(Rim { position, normal, uv, vertex, angle: 0.0 });
        }
    }
}

fn mean(rims: &[Rim]) -> Rim {
    let share = 1.0 / rims.len().max(1) as f32;
    let nothing =
        Rim { position: Vec3::ZERO, normal: Vec3::ZERO, uv: Vec2::ZERO, vertex: 0, angle: 0.0 };
    rims.iter().fold(nothing, |sum, rim| Rim {
        position: sum.position + rim.position * share,
        normal: sum.normal + rim.normal * share,
        uv: sum.uv + rim.uv * share,
        ..sum
    })
}

/// A fan from the rim to the tip.
fn point(lateral: &Skin<'_>, middle: &Rim, rims: &Rims, out: &mut Columns<'_>) {
    let Some(curve) = lateral.plan.curves.get(lateral.axis) else { return };
    let end = curve.at(curve.length());
    let normal = end.tangent;
    let apex = out.next();
    out.vertex(Vertex {
        position: end.station.position,
        normal,
        tangent: normal.any_orthonormal_vector(),
        uv: middle.uv,
        branch: lateral.axis,
        weld: out.global(apex),
    });
    for i in 0..rims.rims.len() {
        let next = (i + 1) % rims.rims.len();
        out.global_triangle([rims.rims[i].vertex, rims.rims[next].vertex, out.global(apex)]);
    }
}

/// Finds the angles of the rim about the ring's axis, and starts it where the ring starts.
fn turn(ring: &Ring, rims: &mut Rims) {
    let binormal = ring.frame.binormal();
    for rim in &mut rims.rims {
        let arm = rim.position - ring.station.position;
        rim.angle = libm::atan2f(arm.dot(binormal), arm.dot(ring.frame.normal));
    }
    let nearest =
        |a: &(usize, &Rim), b: &(usize, &Rim)| a.1.angle.abs().total_cmp(&b.1.angle.abs());
    let start = rims.rims.iter().enumerate().min_by(nearest).map_or(0, |(start, _)| start);
    rims.rims.rotate_left(start);
    let from = rims.rims.first().map_or(0.0, |rim| rim.angle);
    let (mut last, mut at, mut turned) = (from, from, 0.0);
    for rim in &mut rims.rims {
        let step = wrapped(rim.angle - last);
        (last, turned) = (rim.angle, turned + step);
        // Where the rim turns back, its angle waits.
        at = (at + step).clamp(at, from + TAU);
        rim.angle = at;
    }
    if turned + wrapped(from - last) < PI {
        by_length(&mut rims.rims, from);
    }
}

/// An angle between -π and π.
fn wrapped(angle: f32) -> f32 {
    if angle > PI {
        angle - TAU
    } else if angle < -PI {
        angle + TAU
    } else {
        angle
    }
}

/// A rim that does not go round the lateral, because the lateral had to be moved, is shared out by
/// its length.
fn by_length(rims: &mut [Rim], from: f32) {
    let n = rims.len();
    let step = |i: usize| rims[i].position.distance(rims[(i + 1) % n].position);
    let steps: f32 = (0..n).map(step).sum();
    let mut at = from;
    for i in 0..n {
        let share = rims[i].position.distance(rims[(i + 1) % n].position) / steps;
        rims[i].angle = at;
        at += if share.is_finite() { TAU * share } else { TAU / n as f32 };
    }
}

/// The rim at the angle of each corner of the ring.
fn find_feet(ring: &Ring, rims: &mut Rims) {
    let Rims { rims, feet } = rims;
    feet.clear();
    let n = rims.len();
    let Some(from) = rims.first().map(|first| first.angle) else { return };
    let mut i = 0;
    for k in 0..ring.n {
        let mut angle = TAU * k as f32 / ring.n as f32;
        // Into the turn that the rim makes. The search starts anew where that is passed.
        if angle < from {
            (angle, i) = (angle + TAU, 0);
        } else if angle > from + TAU {
            (angle, i) = (angle - TAU, 0);
        }
        let end = |i: usize| if i + 1 < n { rims[i + 1].angle } else { from + TAU };
        while i + 1 < n && end(i) <= angle {
            i += 1;
        }
        let (a, b) = (rims[i], rims[(i + 1) % n]);
        let rest = end(i) - a.angle;
        let t = if rest > 0.0 { ((angle - a.angle) / rest).clamp(0.0, 1.0) } else { 0.0 };
        feet.push(Spot {
            position: a.position.lerp(b.position, t),
            normal: a.normal.lerp(b.normal, t).normalize_or(a.normal),
            uv: a.uv.lerp(b.uv, t),
        });
        if angle >= TAU {
            i = 0;
        }
    }
}

/// What the vertices of one bridge share.
struct Bridge<'a> {
    lateral: &'a Skin<'a>,
    ring: &'a Ring,
    wall: Wall,
    /// Where the lateral's axis meets the wall.
    center: Spot,
}

/// The host's wall round a hole: a cone.
struct Wall {
    /// On its axis, at the height of the hole's middle.
    axis: Vec3,
    up: Vec3,
    /// From the axis to the hole's middle, and round the host from there.
    out: Vec3,
    side: Vec3,
    /// At that height, and how fast it grows above.
    radius: f32,
    slope: f32,
    /// The smaller of the radii below and above the hole.
    least: f32,
    /// Heights of the rings below and above the hole.
    low: f32,
    high: f32,
    /// Texture coordinates in the middle, and how fast they grow by angle and by height.
    uv: Vec2,
    rate: Vec2,
}

/// A place on the wall.
#[derive(Clone, Copy, Debug)]
struct Spot {
    position: Vec3,
    normal: Vec3,
    uv: Vec2,
}

impl Wall {
    fn of(host: &Skin<'_>, hole_ring: usize, middle: &Rim) -> Option<Self> {
        let (low, high) = (host.rings.get(hole_ring)?, host.rings.get(hole_ring + 1)?);
        let chord = high.station.position - low.station.position;
        let up = chord.try_normalize().unwrap_or(low.frame.tangent);
        let wide = |ring: &Ring| {
            let reach = host.plan.circles.reach(ring.n);
            reach * ring.station.radius * host.flare.widest(ring.station.along)
        };
        let rise = (high.station.along - low.station.along).max(f32::MIN_POSITIVE);
        let slope = (wide(high) - wide(low)) / rise;
        let least = wide(high).min(wide(low));
        let foot = low.station.position;
        let axis = foot + up * (middle.position - foot).dot(up);
        let out = across(middle.position - axis, up).unwrap_or(middle.normal);
        let uv_of = |ring: &Ring, k| host.uv(ring, k);
        let radius = wide(low) + slope * (axis - foot).dot(up);
        let rate = Vec2::new(
            (uv_of(low, low.n).x - uv_of(low, 0).x) / TAU,
            (uv_of(high, 0).y - uv_of(low, 0).y) / rise,
        );
        let (low, high) = ((foot - axis).dot(up), (high.station.position - axis).dot(up));
        Some(Self {
            axis,
            up,
            out,
            side: up.cross(out),
            radius,
            slope,
            least,
            low,
            high,
            uv: middle.uv,
            rate,
        })
    }

    /// Where a line from `position` back along `direction` meets the wall, or comes nearest to it.
    fn spot(&self, position: Vec3, direction: Vec3) -> Spot {
        let flat = |v: Vec3| v - self.up * v.dot(self.up);
        let (arm, way) = (flat(position - self.axis), flat(direction));
        let squared = way.length_squared().max(COSINE_MIN * COSINE_MIN);
        let nearest = arm.dot(way) / squared;
        let off = (arm - way * nearest).length_squared();
        let (mut hit, mut radius) = (self.axis, self.radius);
        for _ in 0..2 {
            let back = nearest - ((radius * radius - off).max(0.0) / squared).sqrt();
            hit = position - direction * back.max(0.0);
            // A line that runs along the wall meets it far away: no farther than the hole reaches.
            let height = (hit - self.axis).dot(self.up);
            hit += self.up * (height.clamp(self.low, self.high.max(self.low)) - height);
            radius = (self.radius + self.slope * (hit - self.axis).dot(self.up)).max(self.least);
        }
        self.upon(hit)
    }

    /// The place on the wall nearest to `spot` that lies inside the rim, for laterals that the hole had to be moved from.
    fn within(&self, spot: Spot, rims: &[Rim]) -> Spot {
        let (mut low, mut high) = (Vec2::MAX, Vec2::MIN);
        for rim in rims {
            let (angle, height, _) = self.around(rim.position);
            (low, high) = (low.min(Vec2::new(angle, height)), high.max(Vec2::new(angle, height)));
        }
        let (angle, height, _) = self.around(spot.position);
        let at = Vec2::new(angle, height);
        let margin = (high - low) * MARGIN;
        let inside = at.max(low + margin).min(high - margin);
        if inside == at { spot } else { self.at(inside.x, inside.y, self.radial(inside.x)) }
    }

    fn radial(&self, angle: f32) -> Vec3 {
        let (sin, cos) = libm::sincosf(angle);
        self.out * cos + self.side * sin
    }

    /// The place on the wall straight out from the axis, at the height of `position`.
    fn upon(&self, position: Vec3) -> Spot {
        let (angle, height, radial) = self.around(position);
        self.at(angle, height, radial)
    }

    /// Angle from the hole's middle, height, and the direction out from the axis.
    fn around(&self, position: Vec3) -> (f32, f32, Vec3) {
        let height = (position - self.axis).dot(self.up);
        let middle = self.axis + self.up * height;
        let radial = (position - middle).try_normalize().unwrap_or(self.out);
        (libm::atan2f(radial.dot(self.side), radial.dot(self.out)), height, radial)
    }

    fn at(&self, angle: f32, height: f32, radial: Vec3) -> Spot {
        let middle = self.axis + self.up * height;
        let radius = (self.radius + self.slope * height).max(self.least);
        Spot {
            position: middle + radial * radius,
            normal: radial,
            uv: self.uv + self.rate * Vec2::new(angle, height),
        }
    }
}

impl Bridge<'_> {
    fn vertex(&self, position: Vec3, normal: Vec3, uv: Vec2, weld: u32) -> Vertex {
        let side = self.wall.side;
        Vertex {
            position,
            normal,
            tangent: across(side, normal).unwrap_or(normal.any_orthonormal_vector()),
            uv,
            branch: self.lateral.axis,
            weld,
        }
    }

    /// The lateral's first ring once more, in the host's bark, which is drawn together towards the
    /// middle as far as the way from the `foot` is long.
    fn collar(&self, k: u32, foot: &Spot, weld: u32) -> Vertex {
        let position = self.lateral.corner(self.ring, k);
        let whole = foot.position.distance(self.center.position).max(f32::MIN_POSITIVE);
        let share = (position.distance(foot.position) / whole).min(GATHER);
        let uv = foot.uv.lerp(self.center.uv, share);
        self.vertex(position, self.lateral.shading(0, k).0, uv, weld)
    }

    /// Moves the rim's places at the corners of the ring to the lateral's feet.
    fn place_feet(&self, feet: &mut [Spot]) {
        let apart = MERGED * self.ring.station.radius;
        let n = feet.len();
        let near = |i: usize| {
            let (a, b) = (self.foot(&feet[i]), self.foot(&feet[(i + 1) % n]));
            a.position.distance(b.position) < apart
        };
        // Where the wall is thinner than the lateral, its cone folds: half way up instead.
        let folded = (0..n).any(near);
        for (k, foot) in feet.iter_mut().enumerate() {
            let corner = self.lateral.corner(self.ring, k as u32);
            let half_way = Spot { position: foot.position.lerp(corner, 0.5), ..*foot };
            *foot = if folded { half_way } else { self.foot(foot) };
        }
    }

    /// On the wall, a little outside of the lateral's ring, on the way from its middle to the rim.
    fn foot(&self, rim: &Spot) -> Spot {
        let direction = self.ring.frame.tangent;
        let to_rim = rim.position - self.center.position;
        let reach = (to_rim - direction * to_rim.dot(direction)).length();
        let share = self.ring.station.radius / reach.max(f32::MIN_POSITIVE);
        let share = if share < CROWDED { (FOOT * share).min(0.5 * (1.0 + share)) } else { CROWDED };
        self.wall.upon(self.center.position.lerp(rim.position, share))
    }
}

/// Joins a rim to a ring of `n` vertices from `first` on, by a strip of as many triangles as both have
/// vertices. The edge whose middle comes first is taken first.
fn zip(rims: &[Rim], first: u32, n: u32, out: &mut Columns<'_>) {
    let n_rims = rims.len();
    let angle = |i: usize| rims[i % n_rims].angle + if i < n_rims { 0.0 } else { TAU };
    let (mut i, mut j) = (0, 0);
    while i < n_rims || j < n {
        let (a, b) = (rims[i % n_rims].vertex, first + j % n);
        let rim_middle = angle(i) + angle(i + 1);
        let ring_middle = TAU * (2 * j + 1) as f32 / n as f32;
        // Neither may come full circle before the other has started: the first edge would be used twice.
        let rim_first = (i == 0 && j + 1 == n) || rim_middle < ring_middle;
        let ring_first = j == 0 && i + 1 == n_rims;
        if i < n_rims && (j == n || (rim_first && !ring_first)) {
            out.global_triangle([a, rims[(i + 1) % n_rims].vertex, b]);
            i += 1;
        } else {
            out.global_triangle([a, first + (j + 1) % n, b]);
            j += 1;
        }
    }
}
