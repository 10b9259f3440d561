//! Bark: a closed, tapered tube along every axis.
//!
//! 1. Stations along the axis ([`crate::spine`]), and at each a ring whose number of sides follows
//!    from its radius: the chord of a regular n-gon lies r·(1 − cos(π/n)) inside the circle, which
//!    must stay within [`MeshParams::side_error`].
//! 2. Rings are turned by twist-free frames ([`crate::frame`]) and joined in strips. Rings of
//!    different counts are zipped: whichever ring's next vertex comes first, by an exact comparison
//!    of integers, is joined next. So a tube has no crack wherever its count changes.
//! 3. The base is closed by a fan: with vertices of its own below the trunk, with those of the ring
//!    for a lateral, whose base lies inside its parent's wood. The tip is closed by a point.
//! 4. Normals are those of the surface of revolution, slope and root flare counted in. The first
//!    vertex of each ring is doubled, with the same bits, for the texture's seam.
//!
//! Counting and filling walk the same stations, so the counts are exact and the memory is asked for
//! once. Laterals run through their parent's surface; nothing is joined there.
//!
//! Cost: O(vertices), no allocation per axis.

use crate::columns::Columns;
use crate::error::Result;
use crate::flare::Flare;
use crate::frame::Frame;
use crate::params::MeshParams;
use crate::spine::{Spine, Station};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};
use tree_core::{Axis, Control, Skeleton};

/// Height of the cap on a blunt tip in radii of the tip.
const CAP_HEIGHT: f32 = 0.5;
/// Cancellation is looked for every so many rings.
const RINGS_PER_CHECK: usize = 1024;

/// Directions to the corners of regular polygons, so that rings need no sines.
#[derive(Debug)]
pub(crate) struct Circles {
    params: MeshParams,
    /// The polygon of n sides starts at `starts[n]`.
    starts: Vec<usize>,
    corners: Vec<Vec2>,
}

impl Circles {
    pub(crate) fn new(params: &MeshParams) -> Self {
        let mut circles = Self { params: *params, starts: Vec::new(), corners: Vec::new() };
        for n in 0..=params.sides_max {
            circles.starts.push(circles.corners.len());
            if n >= params.sides_min {
                circles.corners.extend((0..n).map(|k| {
                    let angle = TAU * k as f32 / n as f32;
                    Vec2::new(libm::cosf(angle), libm::sinf(angle))
                }));
            }
        }
        circles
    }

    /// Corners of the polygon of `n` sides, between the bounds of the parameters.
    fn corners(&self, n: u32) -> &[Vec2] {
        let start = self.starts[n as usize];
        &self.corners[start..start + n as usize]
    }

    /// How many sides a ring gets. Rounded up to steps that grow with the count, so that most strips
    /// join equal rings.
    fn n_sides(&self, station: Station, flare: &Flare) -> u32 {
        let radius = station.radius * flare.widest(station.along);
        let cosine = 1.0 - (self.params.side_error / radius).min(0.999);
        let wanted = (PI / libm::acosf(cosine)).ceil() as u32;
        let wanted = wanted.max(flare.sides_min(station.along)).min(self.params.sides_max);
        let stepped = match wanted {
            0..=6 => wanted,
            7..=12 => wanted.next_multiple_of(2),
            13..=32 => wanted.next_multiple_of(4),
            _ => wanted.next_multiple_of(8),
        };
        stepped.clamp(self.params.sides_min, self.params.sides_max)
    }

    fn flare(&self, spine: &Spine) -> Flare {
        if spine.flared { Flare::new(&self.params, spine.base().radius) } else { Flare::NONE }
    }
}

/// How much one axis takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) vertices: u64,
    pub(crate) triangles: u64,
    pub(crate) dropped_nodes: u64,
    pub(crate) dropped_axes: u64,
}

/// Counts what [`fill`] will write for this axis.
pub(crate) fn count(
    spine: &mut Spine,
    circles: &Circles,
    skeleton: &Skeleton,
    axis: Axis<'_>,
) -> Count {
    let mut count = Count::default();
    if !spine.load(skeleton, axis, &circles.params) {
        count.dropped_axes = 1;
        count.dropped_nodes = u64::from(spine.n_dropped);
        return count;
    }
    count.dropped_nodes = u64::from(spine.n_dropped);
    let flare = circles.flare(spine);
    let mut last: Option<u64> = None;
    for station in spine.rings() {
        let n = u64::from(circles.n_sides(station, &flare));
        count.vertices += n + 1;
        count.triangles += match last {
            Some(before) => before + n,
            None if spine.trunk => n,
            None => n - 2,
        };
        if last.is_none() && spine.trunk {
            count.vertices += n + 1;
        }
        last = Some(n);
    }
    let n = last.unwrap_or(0);
    count.vertices += n;
    count.triangles += n;
    count
}

/// Space that [`fill`] reuses from axis to axis.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    pub(crate) spine: Spine,
    stations: Vec<Station>,
}

/// One ring that was written.
#[derive(Clone, Copy)]
struct Ring {
    first: u32,
    n: u32,
}

/// Writes the tube of one axis: exactly what [`count`] counted.
///
/// # Errors
/// [`Cancelled`](tree_core::Cancelled).
pub(crate) fn fill(
    scratch: &mut Scratch,
    circles: &Circles,
    skeleton: &Skeleton,
    axis: Axis<'_>,
    out: &mut Columns<'_>,
    control: &Control,
) -> Result<()> {
    let Scratch { spine, stations } = scratch;
    if !spine.load(skeleton, axis, &circles.params) {
        return Ok(());
    }
    let flare = circles.flare(spine);
    stations.clear();
    stations.extend(spine.rings());
    let n_rings = stations.len();
    if spine.pointed {
        stations.push(Station { radius: 0.0, ..spine.tip() });
    }
    let around = TAU * spine.base().radius / circles.params.bark_width;
    let skin = Skin {
        circles,
        flare,
        repeats: around.round().max(1.0),
        v_per_metre: -1.0 / circles.params.bark_length,
    };

    let mut direction = (1..stations.len())
        .find_map(|i| (stations[i].position - stations[0].position).try_normalize())
        .unwrap_or(Vec3::Y);
    // The seam of a lateral lies below it, where it is seen least.
    let hint = if spine.trunk { Vec3::X } else { Vec3::NEG_Y };
    let mut frame = Frame::new(direction, hint);
    let mut last: Option<Ring> = None;
    for i in 0..n_rings {
        if i % RINGS_PER_CHECK == 0 {
            control.check()?;
        }
        let ahead = match stations.get(i + 1) {
            Some(next) => {
                (next.position - stations[i].position).try_normalize().unwrap_or(direction)
            }
            None => direction,
        };
        if i > 0 {
            let tangent = if (direction + ahead).length_squared() > 1e-6 {
                (direction + ahead).normalize()
            } else {
                direction
            };
            frame = frame.advance(stations[i].position - stations[i - 1].position, tangent);
        }
        direction = ahead;
        let stance = skin.flare.stance(stations[i].along, &frame);
        let ring = skin.ring(stations, i, &frame, &stance, out);
        match last {
            Some(below) => zip(below, ring, out),
            None => skin.close_base(ring, stations[0].position, &stance, spine.trunk, out),
        }
        last = Some(ring);
    }
    if let (Some(ring), Some(&end)) = (last, stations.last()) {
        let apex = if spine.pointed {
            end.position
        } else {
            end.position + direction * (CAP_HEIGHT * end.radius)
        };
        skin.close_tip(ring, apex, end.along, direction, spine.pointed, out);
    }
    Ok(())
}

/// How one axis is clad.
struct Skin<'a> {
    circles: &'a Circles,
    flare: Flare,
    /// How often the texture goes round.
    repeats: f32,
    v_per_metre: f32,
}

impl Skin<'_> {
    /// One ring in the plane of `stance`; its normals belong to a branch along `frame`.
    fn ring(
        &self,
        stations: &[Station],
        i: usize,
        frame: &Frame,
        stance: &Frame,
        out: &mut Columns<'_>,
    ) -> Ring {
        let station = stations[i];
        let (below, above) =
            (stations[i.saturating_sub(1)], stations[(i + 1).min(stations.len() - 1)]);
        let rise = above.along - below.along;
        let slope = if rise > 0.0 { (above.radius - below.radius) / rise } else { 0.0 };
        let n = self.circles.n_sides(station, &self.flare);
        let (binormal, across) = (frame.binormal(), stance.binormal());
        let flared = self.flare.acts(station.along);
        let v = station.along * self.v_per_metre;
        let first = out.next();
        for (k, corner) in self.circles.corners(n).iter().enumerate() {
            let outward = frame.normal * corner.x + binormal * corner.y;
            let mut radius = station.radius;
            let mut normal = outward - frame.tangent * slope;
            if flared {
                // Gradient of the distance to the surface r(h, θ)·outward.
                let angle = TAU * k as f32 / n as f32;
                let wide = self.flare.at(station.along, angle);
                radius *= wide.factor;
                let steep = slope * wide.factor + station.radius * wide.by_height;
                let sideways = binormal * corner.x - frame.normal * corner.y;
                normal = outward - frame.tangent * steep - sideways * (wide.by_angle / wide.factor);
            }
            let u = self.repeats * k as f32 / n as f32;
            out.vertex(
                station.position + (stance.normal * corner.x + across * corner.y) * radius,
                normal.try_normalize().unwrap_or(outward),
                Vec2::new(u, v),
            );
        }
        let seam = first as usize;
        out.vertex(out.positions[seam], out.normals[seam], Vec2::new(self.repeats, v));
        Ring { first, n }
    }

    fn close_base(
        &self,
        ring: Ring,
        centre: Vec3,
        frame: &Frame,
        seen: bool,
        out: &mut Columns<'_>,
    ) {
        if !seen {
            for k in 1..ring.n - 1 {
                out.triangle([ring.first, ring.first + k + 1, ring.first + k]);
            }
            return;
        }
        // From the middle: between buttresses the outline is not convex.
        let middle = out.next();
        out.vertex(centre, -frame.tangent, Vec2::ZERO);
        for k in 0..ring.n {
            let position = out.positions[(ring.first + k) as usize];
            let arm = position - centre;
            let flat = Vec2::new(arm.dot(frame.normal), -arm.dot(frame.binormal()));
            out.vertex(position, -frame.tangent, flat / self.circles.params.bark_width);
            let next = (k + 1) % ring.n;
            out.triangle([middle, middle + 1 + next, middle + 1 + k]);
        }
    }

    fn close_tip(
        &self,
        ring: Ring,
        apex: Vec3,
        along: f32,
        direction: Vec3,
        pointed: bool,
        out: &mut Columns<'_>,
    ) {
        let rise = out.positions[ring.first as usize].distance(apex);
        let v = if pointed { along * self.v_per_metre } else { (along + rise) * self.v_per_metre };
        for k in 0..ring.n {
            let (a, b) = ((ring.first + k) as usize, (ring.first + k + 1) as usize);
            let normal = if pointed {
                (out.normals[a] + out.normals[b]).try_normalize().unwrap_or(direction)
            } else {
                direction
            };
            let u = self.repeats * (k as f32 + 0.5) / ring.n as f32;
            let top = out.next();
            out.vertex(apex, normal, Vec2::new(u, v));
            out.triangle([ring.first + k, ring.first + k + 1, top]);
        }
    }
}

/// Joins two rings by a strip of `below.n + above.n` triangles.
fn zip(below: Ring, above: Ring, out: &mut Columns<'_>) {
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
