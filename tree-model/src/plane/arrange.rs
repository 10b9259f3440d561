//! Sides of contours that cross are cut where they meet, so that they have nothing but corners in common.
//!
//! The coordinates are whole numbers within ±[`HALF`](super::fill::HALF) = 2²² and stay so: a cut is rounded to the
//! nearest one. Then which side of a line a point lies on is exact in `f64` (products below 2⁴⁸). A rounded cut moves
//! the two halves by less than a unit; that may make them cross others, so it is done again until nothing crosses
//! (iterated snap rounding, Halperin & Packer 2002).
//!
//! 1. All pairs of sides that meet: sides in the order of their left ends, each tried with those that begin before it
//!    ends.
//! 2. Where an end lies within half a unit of another side, that is cut there; where two cross, both are cut at the rounded crossing.
//!
//! O(rounds · (n log n + pairs beside each other in x)). Two or three rounds are usual.

use super::fill::{sides, tidy};
use glam::DVec2;

/// Rounds of cutting. What still crosses after the last is left out of the triangulation.
const ROUNDS: usize = 12;

/// A side is cut at a corner when it runs through the square round it of twice this size. Thus what nearly touches is
/// made to, and rounding has nothing left to cross.
const HALF_UNIT: f64 = 0.5;

/// A side of a contour.
struct Side {
    a: DVec2,
    b: DVec2,
    low: DVec2,
    high: DVec2,
    /// The contour, the number in it, and how many there are.
    place: (usize, usize, usize),
}

impl Side {
    /// Above 0 where the point lies to the left, 0 where it lies on the line.
    fn left(&self, point: DVec2) -> f64 {
        (self.b - self.a).perp_dot(point - self.a)
    }

    /// Whether it runs through the unit square round a point, between its ends.
    fn bears(&self, point: DVec2) -> bool {
        let way = self.b - self.a;
        let along = way.dot(point - self.a);
        let between = along > 0.0 && along < way.length_squared();
        between && self.left(point).abs() < HALF_UNIT * (way.x.abs() + way.y.abs())
    }

    /// Whether the next or the last side of the same contour.
    fn follows(&self, other: &Self) -> bool {
        let ((contour, i, n), (with, j, _)) = (self.place, other.place);
        contour == with && ((i + 1) % n == j || (j + 1) % n == i)
    }

    /// Whether two sides have a point in common.
    fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all()
            && other.low.cmple(self.high).all()
            && self.left(other.a) * self.left(other.b) <= 0.0
            && other.left(self.a) * other.left(self.b) <= 0.0
    }

    /// Whether two sides with a common end lie on one another.
    fn folds_back(&self, next: &Self) -> bool {
        let (common, one, other) =
            if self.b == next.a { (self.b, self.a, next.b) } else { (self.a, self.b, next.a) };
        let (u, v) = (one - common, other - common);
        u.perp_dot(v) == 0.0 && u.dot(v) > 0.0
    }

    /// The whole number nearest to where two sides cross that both have their ends apart from the other's line.
    fn crossing(&self, other: &Self) -> Option<DVec2> {
        let (c, d) = (self.left(other.a), self.left(other.b));
        let (a, b) = (other.left(self.a), other.left(self.b));
        let apart = c * d < 0.0 && a * b < 0.0;
        apart.then(|| other.a.lerp(other.b, c / (c - d)).round())
    }
}

/// Every two sides that come within a unit of each other, and some more, until `visit` says that it is enough.
fn pairs(contours: &[Vec<DVec2>], mut visit: impl FnMut(&Side, &Side) -> bool) {
    let mut all: Vec<Side> = Vec::new();
    for (which, contour) in contours.iter().enumerate() {
        all.extend(sides(contour).enumerate().map(|(i, (a, b))| {
            let place = (which, i, contour.len());
            Side { a, b, low: a.min(b), high: a.max(b), place }
        }));
    }
    all.sort_by(|s, t| s.low.x.total_cmp(&t.low.x));
    for (i, s) in all.iter().enumerate() {
        for t in all[i + 1..].iter().take_while(|t| t.low.x <= s.high.x + 1.0) {
            if t.low.y <= s.high.y + 1.0 && t.high.y + 1.0 >= s.low.y && visit(s, t) {
                return;
            }
        }
    }
}

/// Number of pairs of sides that have a point in common although they do not follow each other, or lie on one another
/// although they do; counted to `most`.
pub(crate) fn crossings(contours: &[Vec<DVec2>], most: usize) -> usize {
    let mut count = 0;
    pairs(contours, |s, t| {
        count += usize::from(if s.follows(t) { s.folds_back(t) } else { s.meets(t) });
        count >= most
    });
    count
}

/// The contours with corners wherever their sides meet. They wind round what they wound round before, within a unit.
pub(crate) fn arrange(contours: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    let mut contours = contours.to_vec();
    for _ in 0..ROUNDS {
        let cuts = cuts(&contours);
        if cuts.is_empty() {
            break;
        }
        let mut cuts = cuts.into_iter().peekable();
        for (which, contour) in contours.iter_mut().enumerate() {
            let mut out = Vec::with_capacity(2 * contour.len());
            for (i, &corner) in contour.iter().enumerate() {
                out.push(corner);
                while let Some(cut) = cuts.next_if(|cut| cut.place == (which, i)) {
                    out.push(cut.at);
                }
            }
            tidy(&mut out);
            *contour = out;
        }
    }
    contours.retain(|contour| contour.len() > 2);
    contours
}

struct Cut {
    /// The contour and the side of it.
    place: (usize, usize),
    /// Square of the distance from the side's begin.
    along: f64,
    at: DVec2,
}

/// Where sides are to be cut, in order.
fn cuts(contours: &[Vec<DVec2>]) -> Vec<Cut> {
    let mut cuts = Vec::new();
    let mut cut = |side: &Side, at: DVec2| {
        if at != side.a && at != side.b {
            let place = (side.place.0, side.place.1);
            cuts.push(Cut { place, along: at.distance_squared(side.a), at });
        }
    };
    pairs(contours, |s, t| {
        let mut apart = true;
        for (side, other) in [(s, t), (t, s)] {
            for end in [other.a, other.b] {
                if side.bears(end) {
                    cut(side, end);
                    apart = false;
                }
            }
        }
        if let Some(at) = s.crossing(t)
            && apart
        {
            cut(s, at);
            cut(t, at);
        }
        false
    });
    cuts.sort_by(|c, d| c.place.cmp(&d.place).then(c.along.total_cmp(&d.along)));
    cuts
}

#[cfg(test)]
mod tests {
    use super::super::fill::HALF;
    use super::*;
    use proptest::prelude::*;

    /// Pairs of sides that have more than ends in common.
    fn conflicts(contours: &[Vec<DVec2>]) -> usize {
        cuts(contours).len()
    }

    #[test]
    fn a_figure_of_eight_is_cut_at_its_crossing() {
        let p = DVec2::new;
        let eight = vec![p(0.0, 0.0), p(20.0, 20.0), p(20.0, 0.0), p(0.0, 20.0)];
        let cut = arrange(&[eight]);
        assert_eq!(cut[0].iter().filter(|&&corner| corner == p(10.0, 10.0)).count(), 2);
    }

    #[test]
    fn ends_on_other_sides_and_sides_on_one_another_are_cut() {
        let p = DVec2::new;
        let below = vec![p(0.0, 0.0), p(9.0, 0.0), p(9.0, 4.0), p(0.0, 4.0)];
        let above = vec![p(3.0, 4.0), p(5.0, 8.0), p(6.0, 4.0)];
        let cut = arrange(&[below, above]);
        assert_eq!((cut[0].len(), cut[1].len()), (6, 3));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        #[test]
        fn nothing_crosses_any_more(
            list in prop::collection::vec((-HALF..HALF, -HALF..HALF), 3..60),
        ) {
            let contour = list.iter().map(|&(x, y)| DVec2::new(x, y).round()).collect();
            prop_assert_eq!(conflicts(&arrange(&[contour])), 0);
        }

        #[test]
        fn nothing_crosses_any_more_where_the_grid_is_coarse(
            list in prop::collection::vec((-9_i32..9, -9_i32..9), 3..60),
        ) {
            let contour = list.iter().map(|&(x, y)| DVec2::new(x.into(), y.into())).collect();
            prop_assert_eq!(conflicts(&arrange(&[contour])), 0);
        }

        #[test]
        fn what_nearly_lies_on_one_another_comes_apart_too(
            list in prop::collection::vec((-4_i32..=4, -4_i32..=4, -3_i32..=3, -3_i32..=3), 3..40),
        ) {
            let near = |place: i32, off: i32| HALF / 4.0 * f64::from(place) + f64::from(off);
            let contour = list.iter().map(|&(x, y, u, v)| DVec2::new(near(x, u), near(y, v)));
            prop_assert_eq!(conflicts(&arrange(&[contour.collect()])), 0);
        }
    }
}
