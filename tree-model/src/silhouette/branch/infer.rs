//! A branch for an end point and its tangent: the shortest Hermite curve from the parent (section 3.2).
//!
//! Along the parent, places are tried in turn: from each a cubic Hermite curve leads to the end, it leaves the
//! parent at the branching angle, on the side the end lies on, and arrives along the tangent; both tangent vectors are half as long
//! as the distance. The shortest curve is taken. As in the paper, but the best place is sought further between the places tried,
//! and what of a curve lies outside the foliage counts more: across a bay the shortest branch would hang in the air.

use super::BranchingAngles;
use crate::error::{Result, check};
use crate::silhouette::Line;
use glam::Vec2;

/// Points that measure a curve while places are compared.
const ROUGH: usize = 8;
/// What of a curve lies outside counts so many times more.
const OUTSIDE: f32 = 4.0;
/// Steps of the search between two places.
const STEPS: usize = 12;

/// How branches are inferred.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct InferParams {
    /// Places along the parent that are tried, 2 to 10,000. Default 48.
    pub places: u32,
    /// Points of a branch, 2 to 1000. Default 16.
    pub points: u32,
    /// Length of the tangents over the distance of base and end, 0 (straight) to 2. Default 0.5, as in the paper.
    pub tangents: f32,
}

impl Default for InferParams {
    fn default() -> Self {
        Self { places: 48, points: 16, tangents: 0.5 }
    }
}

impl InferParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("infer.places", self.places, 2, 10_000)?;
        check("infer.points", self.points, 2, 1000)?;
        check("infer.tangents", self.tangents, 0.0_f32, 2.0_f32)
    }
}

/// A branch in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Inferred {
    /// Where it leaves its parent, as a share of the parent's length.
    pub t: f32,
    /// Its points, from the base to the end.
    pub line: Line,
}

/// A cubic Hermite curve.
struct Curve {
    from: Vec2,
    to: Vec2,
    leave: Vec2,
    arrive: Vec2,
}

impl Curve {
    fn at(&self, s: f32) -> Vec2 {
        let (s2, s3) = (s * s, s * s * s);
        (2.0 * s3 - 3.0 * s2 + 1.0) * self.from
            + (s3 - 2.0 * s2 + s) * self.leave
            + (3.0 * s2 - 2.0 * s3) * self.to
            + (s3 - s2) * self.arrive
    }

    /// Its length; stretches that end outside count more.
    fn cost(&self, is_inside: &impl Fn(Vec2) -> bool) -> f32 {
        let (mut cost, mut before) = (0.0, self.from);
        for i in 1..=ROUGH {
            let point = self.at(i as f32 / ROUGH as f32);
            let weight = if i == ROUGH || is_inside(point) { 1.0 } else { 1.0 + OUTSIDE };
            cost += weight * before.distance(point);
            before = point;
        }
        cost
    }
}

/// The branch to `end`, where it arrives along `tangent` (any length; zero: from where it comes). `within` is the part
/// of the parent it may leave from, as shares of the length; `is_inside` tells where foliage is. `None` where the end
/// lies on the parent.
///
/// # Complexity
/// O(places + points).
#[must_use]
pub fn infer(
    parent: &Line,
    angles: &BranchingAngles,
    (end, tangent): (Vec2, Vec2),
    within: [f32; 2],
    is_inside: &impl Fn(Vec2) -> bool,
    params: &InferParams,
) -> Option<Inferred> {
    let curve = |t: f32| curve(parent, angles, (end, tangent), t, params);
    let cost = |t: f32| curve(t).map_or(f32::INFINITY, |curve| curve.cost(is_inside));
    let places = params.places.max(2);
    let step = (within[1] - within[0]) / (places - 1) as f32;
    let place = |i: u32| within[0] + step * i as f32;
    let mut best = (f32::INFINITY, within[0]);
    for i in 0..places {
        let length = cost(place(i));
        if length < best.0 {
            best = (length, place(i));
        }
    }
    let (mut low, mut high) = ((best.1 - step).max(within[0]), (best.1 + step).min(within[1]));
    for _ in 0..STEPS {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if cost(a) <= cost(b) { high = b } else { low = a }
    }
    let fine = 0.5 * (low + high);
    let t = if cost(fine) < best.0 { fine } else { best.1 };
    let curve = curve(t)?;
    let last = (params.points.max(2) - 1) as f32;
    let points = (0..params.points.max(2)).map(|i| curve.at(i as f32 / last)).collect();
    Some(Inferred { t, line: Line::new(points)? })
}

fn curve(
    parent: &Line,
    angles: &BranchingAngles,
    (end, tangent): (Vec2, Vec2),
    t: f32,
    params: &InferParams,
) -> Option<Curve> {
    let from = parent.at(t);
    let way = end - from;
    let reach = params.tangents * way.length();
    let along = parent.tangent(t);
    let side = if along.perp_dot(way) < 0.0 { -1.0 } else { 1.0 };
    let (sin, cos) = libm::sincosf(side * angles.at(t));
    let leave = Vec2::new(cos, sin).rotate(along);
    let straight = way.try_normalize()?;
    let arrive = tangent.try_normalize().unwrap_or(straight);
    Some(Curve { from, to: end, leave: reach * leave, arrive: reach * arrive })
}

/// Where a drawn branch leaves its parent: the place nearest to its start, the angle there, and whether it is on the left.
#[must_use]
pub fn base_of(parent: &Line, branch: &Line) -> (f32, f32, bool) {
    let (t, _) = parent.nearest(branch.start());
    let along = parent.tangent(t);
    let foot = branch.foot();
    let angle = libm::atan2f(along.perp_dot(foot), along.dot(foot));
    let left = along.perp_dot(branch.span()) > 0.0;
    (t, angle.abs(), left)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trunk() -> Line {
        Line::new(vec![Vec2::ZERO, Vec2::new(0.0, 10.0)]).unwrap()
    }

    fn reach(end: Vec2, tangent: Vec2) -> Inferred {
        let angles = BranchingAngles::default();
        infer(&trunk(), &angles, (end, tangent), [0.0, 1.0], &|_| true, &InferParams::default())
            .unwrap()
    }

    #[test]
    fn it_leaves_at_the_branching_angle_on_the_side_of_its_end() {
        for end in [Vec2::new(4.0, 7.0), Vec2::new(-3.0, 5.0), Vec2::new(0.5, 9.9)] {
            let branch = reach(end, end - Vec2::new(0.0, 5.0));
            let foot = branch.line.foot();
            let angle = libm::atan2f(-foot.x.abs(), foot.y).abs();
            let wanted = BranchingAngles::default().at(branch.t);
            assert!((angle - wanted).abs() < 0.01, "{end}: {angle} {wanted}");
            assert!(foot.x * end.x > 0.0);
            assert!(branch.line.end().distance(end) < 1e-5);
        }
    }

    #[test]
    fn no_other_place_gives_a_shorter_branch() {
        let (end, tangent) = (Vec2::new(4.0, 7.0), Vec2::X);
        let best = reach(end, tangent);
        for i in 0..100 {
            let t = i as f32 / 100.0;
            let only = infer(
                &trunk(),
                &BranchingAngles::default(),
                (end, tangent),
                [t, t],
                &|_| true,
                &InferParams::default(),
            );
            assert!(only.unwrap().line.length() > best.line.length() - 1e-3);
        }
    }

    #[test]
    fn an_end_on_the_parent_gives_none_or_a_branch() {
        let angles = BranchingAngles::default();
        let on = (Vec2::ZERO, Vec2::ZERO);
        assert!(
            infer(&trunk(), &angles, on, [0.0, 0.0], &|_| true, &InferParams::default()).is_none()
        );
    }

    #[test]
    fn a_drawn_branch_tells_place_angle_and_side() {
        let branch = Line::new(vec![Vec2::new(-0.1, 5.0), Vec2::new(-3.1, 5.0)]).unwrap();
        let (t, angle, left) = base_of(&trunk(), &branch);
        assert!(
            (t - 0.5).abs() < 1e-6 && (angle - std::f32::consts::FRAC_PI_2).abs() < 1e-3 && left
        );
    }
}
