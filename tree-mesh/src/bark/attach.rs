//! Where a lateral leaves the wood of its parent.
//!
//! Neubert (2012, §5.3) cuts both branches of a fork at the smallest sphere outside of which their
//! tubes do not meet (Eq. 5.25). Here only the lateral is cut, where its ring has come clear of the
//! parent's wall; the parent goes on and its wall is opened. For straight branches it is the same
//! cut; this one also holds for bent and tapered branches, and for a thin lateral on a thick trunk,
//! where the sphere would cut away half of the trunk.
//!
//! The lateral's line is walked outwards from the fork. At each step its point is projected onto the
//! parent's line; a ring of radius r₂ across the direction t, off the parent's line by the vector d,
//! is clear of radius r₁ when |d| − r₂·√(1 − (t·d/|d|)²) > r₁.

use super::circle::Circles;
use super::curve::{Curve, Place};
use super::flare::Flare;
use glam::Vec3;

/// How far off the wall a collar stands, in radii of the lateral.
const STANDOFF: f32 = 0.15;
/// First step of the walk as a share of both radii, and its growth.
const STEP: f32 = 0.45;
const GROWTH: f32 = 1.2;
/// A lateral is walked in at most about this many steps.
const STEPS_MAX: f32 = 4096.0;
/// Longest step as a share of both radii.
const STEP_MAX: f32 = 1.4;
/// Steps of the search for the place in between.
const NARROWINGS: u32 = 3;
/// Steps of the projection onto the parent's line.
const PROJECTIONS: u32 = 2;
/// A lateral needs this much length outside, in its radii, to get a ring of its own.
const OUTSIDE_MIN: f32 = 0.25;
/// Wider than the lateral: the hole it leaves the wall through;
const COLLAR: f32 = 1.35;
/// but not where the lateral leans over the wall, and would cover the rim.
const LEE: f32 = 1.1;
/// A lateral that comes back into the wall within this many radii of both has not left it yet.
const RETURN: f32 = 3.0;
/// Smallest sine of the angle between branches that a hole is stretched by.
const SINE_MIN: f32 = 0.25;

/// Where and how a lateral leaves its parent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exit {
    /// Along the lateral: where its first ring stands.
    pub(crate) start: f32,
    /// Along the parent: the middle of the hole in its wall.
    pub(crate) center: f32,
    /// How far the hole reaches below and above its middle, along the parent.
    pub(crate) reach: [f32; 2],
    /// Half its width, across.
    pub(crate) half_width: f32,
    /// From the parent's line towards the hole.
    pub(crate) out: Vec3,
    /// Direction of the parent there.
    pub(crate) up: Vec3,
    /// So little of the lateral is outside that it gets no ring, only a point.
    pub(crate) stub: bool,
}

/// A point of the lateral against the parent.
#[derive(Clone, Copy)]
struct Gap {
    /// Above 0: the lateral's ring is clear of the wall.
    clear: f32,
    /// Above 0: its middle is.
    outside: f32,
    along: f32,
    offset: Vec3,
    up: Vec3,
}

/// The parent's wood.
pub(crate) struct Host<'a> {
    pub(crate) curve: Curve<'a>,
    pub(crate) flare: Flare,
    pub(crate) circles: &'a Circles,
}

impl Host<'_> {
    fn gap(&self, place: &Place, along: f32) -> Gap {
        let mut along = along.clamp(0.0, self.curve.length());
        let mut nearest = self.curve.at(along);
        for _ in 0..PROJECTIONS {
            let offset = place.station.position - nearest.station.position;
            let next = (along + offset.dot(nearest.tangent)).clamp(0.0, self.curve.length());
            let moved = (next - along).abs();
            along = next;
            nearest = self.curve.at(along);
            if moved < 0.05 * nearest.station.radius {
                break;
            }
        }
        let offset = place.station.position - nearest.station.position;
        let distance = offset.length();
        let wall = self.circles.widest(nearest.station.radius * self.flare.widest(along));
        let radius = self.circles.widest(place.station.radius);
        let cosine = place.tangent.dot(offset) / distance.max(f32::MIN_POSITIVE);
        let lean = (1.0 - cosine * cosine).max(0.0).sqrt();
        Gap {
            clear: distance - wall - radius * (lean + STANDOFF),
            outside: distance - wall,
            along,
            offset,
            up: nearest.tangent,
        }
    }

    /// How far the middle of another axis lies outside of this wood, near `along`.
    pub(crate) fn distance(&self, place: &Place, along: f32) -> f32 {
        self.gap(place, along).outside
    }

    /// Walks along `lateral` from its fork, which lies at `fork` on this parent. `None` when all of it
    /// lies inside the parent's wood.
    pub(crate) fn exit(&self, fork: f32, lateral: &Curve<'_>) -> Option<Exit> {
        let length = lateral.length();
        let widest = self.curve.at(fork).station.radius + lateral.at(0.0).station.radius;
        // However thin: no step may vanish in the length, and their number is bounded.
        let widest = widest.max(length / STEPS_MAX);
        let mut step = STEP * widest;
        let (mut at, mut along) = (0.0, fork);
        let mut from = lateral.at(at).station.position;
        let mut inside = self.gap(&lateral.at(at), along);
        let mut wall: Option<(f32, Gap)> = None;
        let mut clear: Option<f32> = None;
        while at < length && clear.is_none_or(|clear| at < clear + RETURN * widest) {
            let next = (at + step).min(length);
            let place = lateral.at(next);
            // From where the parent is likely nearest, one step of projection is enough mostly.
            let way = place.station.position - from;
            let gap = self.gap(&place, along + way.dot(inside.up));
            if gap.outside <= 0.0 {
                (wall, clear) = (None, None);
            } else if wall.is_none() {
                wall = Some(self.narrow(lateral, (at, &inside), (next, gap), |gap| gap.outside));
            }
            if gap.clear > 0.0 && clear.is_none() {
                clear = Some(self.narrow(lateral, (at, &inside), (next, gap), |gap| gap.clear).0);
            } else if gap.clear < -0.5 * STANDOFF * place.station.radius {
                clear = None;
            }
            (at, along, inside, from) = (next, gap.along, gap, place.station.position);
            step = (GROWTH * step).min(STEP_MAX * widest);
        }
        let (crossing, gap) = wall?;
        let place = lateral.at(crossing);
        let cosine = place.tangent.dot(gap.up);
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt().max(SINE_MIN);
        let radius = self.circles.widest(place.station.radius);
        let half_width = COLLAR * radius;
        // Out through the base or past the tip the parent has no wall to slant through.
        let at_end = gap.along <= 0.0 || gap.along >= self.curve.length();
        let sine = if at_end { 1.0 } else { sine };
        let start = clear.unwrap_or(length);
        let room = length - start;
        Some(Exit {
            start,
            center: gap.along,
            reach: [cosine, -cosine].map(|lean| {
                let wide = COLLAR + (LEE - COLLAR) * (-3.0 * lean).clamp(0.0, 1.0);
                wide * radius / sine
            }),
            half_width,
            out: gap.offset,
            up: gap.up,
            stub: room < OUTSIDE_MIN * lateral.at(start).station.radius,
        })
    }

    /// Where between two places `measure` rises above 0, nearly: by false position, which ends on the
    /// outside.
    fn narrow(
        &self,
        lateral: &Curve<'_>,
        (mut low, inside): (f32, &Gap),
        (mut high, mut outside): (f32, Gap),
        measure: impl Fn(&Gap) -> f32,
    ) -> (f32, Gap) {
        let mut below = measure(inside).min(0.0);
        for _ in 0..NARROWINGS {
            let above = measure(&outside);
            // A little beyond, so that the outer end comes nearer too.
            let share = (1.1 * below / (below - above)).clamp(0.05, 0.95);
            let at = low + (high - low) * share;
            let gap = self.gap(&lateral.at(at), outside.along);
            let found = measure(&gap);
            if found > 0.0 { (high, outside) = (at, gap) } else { (low, below) = (at, found) }
        }
        (high, outside)
    }
}
