//! Footprints: how far a crown reaches in every direction (Neubert 2012, section 4.8, after Lamdan, Schwartz & Wolfson
//! 1988).
//!
//! The convex hull is scaled so that the longer side of its bounding box is 1. From its centre C the distance to the
//! hull is taken in Kᶠ directions. The thesis does not say which centre; here C is the centroid of the hull's area,
//! which lies inside and hardly moves when one twig sticks out. Direction 0 is +x, then they turn against the clock
//! in a plan (y up), so a footprint is not the same for a drawing whose y goes down.
//!
//! The hull takes O(n log n), the distances O(Kᶠ · corners of the hull): some microseconds.

use crate::error::ModelError;
use glam::{DVec2, Vec2};

/// Kᶠ: the number of directions.
pub const DIRECTIONS: usize = 64;

/// Distances from the centre of a convex hull to the hull, in [`DIRECTIONS`] directions.
///
/// It does not depend on where the hull lies nor on how large it is. Each distance is above 0 and below √2.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Vec<f32>", into = "Vec<f32>"))]
pub struct Footprint(Vec<f32>);

impl Footprint {
    /// The footprint of the convex hull of `points`. `None` where they have no hull with an area. Points that are not
    /// finite do not count.
    #[must_use]
    pub fn of(points: &[Vec2]) -> Option<Self> {
        let hull: Vec<DVec2> = convex_hull(points).iter().map(|p| p.as_dvec2()).collect();
        let &origin = hull.first()?;
        let (mut low, mut high) = (origin, origin);
        for &corner in &hull {
            (low, high) = (low.min(corner), high.max(corner));
        }
        let size = (high - low).max_element();
        let hull: Vec<DVec2> = hull.iter().map(|&p| (p - origin) / size).collect();
        let center = centroid(&hull)?;
        let distances = (0..DIRECTIONS).map(|k| reach(&hull, center, direction(k)) as f32);
        Self::try_from(distances.collect::<Vec<f32>>()).ok()
    }

    /// The distances, [`DIRECTIONS`] of them, as shares of the longer side of the bounding box.
    #[must_use]
    pub fn distances(&self) -> &[f32] {
        &self.0
    }

    /// ‖f − g‖ of equation 4.26, as the root of the mean square, so that it does not depend on Kᶠ. 0 for equal
    /// shapes; about 0.05 for a circle and an octagon's likes, 0.2 for a circle and a poplar.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f32 {
        let squares = self.0.iter().zip(&other.0).map(|(f, g)| (f - g) * (f - g));
        (squares.sum::<f32>() / DIRECTIONS as f32).sqrt()
    }
}

impl TryFrom<Vec<f32>> for Footprint {
    type Error = ModelError;

    /// # Errors
    /// [`ModelError::Template`] for another number of distances, or where one is not above 0 and at most 2.
    fn try_from(distances: Vec<f32>) -> Result<Self, ModelError> {
        let n = distances.len();
        if n != DIRECTIONS {
            let problem = format!("a footprint has {DIRECTIONS} distances, this one has {n}");
            return Err(ModelError::Template { problem });
        }
        if let Some(row) = distances.iter().position(|&d| !(d > 0.0 && d <= 2.0)) {
            let found = distances[row];
            let problem = format!("footprint[{row}] is {found}, allowed is above 0 to 2");
            return Err(ModelError::Template { problem });
        }
        Ok(Self(distances))
    }
}

impl From<Footprint> for Vec<f32> {
    fn from(footprint: Footprint) -> Self {
        footprint.0
    }
}

fn direction(k: usize) -> DVec2 {
    let angle = std::f64::consts::TAU * k as f64 / DIRECTIONS as f64;
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// Centroid of a convex polygon's area; `None` where it has next to none.
fn centroid(hull: &[DVec2]) -> Option<DVec2> {
    let &origin = hull.first()?;
    let (mut sum, mut area) = (DVec2::ZERO, 0.0);
    for pair in hull.windows(2) {
        let (a, b) = (pair[0] - origin, pair[1] - origin);
        let part = a.perp_dot(b);
        sum += part * (a + b) / 3.0;
        area += part;
    }
    // A needle: its distances would be 0 within f32.
    (area > 1e-9).then(|| origin + sum / area)
}

/// Distance from a point inside a convex polygon to it.
fn reach(hull: &[DVec2], from: DVec2, direction: DVec2) -> f64 {
    let mut nearest = f64::INFINITY;
    for (&a, &b) in hull.iter().zip(hull.iter().cycle().skip(1)) {
        let side = b - a;
        let outwards = direction.perp_dot(side);
        if outwards > 0.0 {
            nearest = nearest.min((a - from).perp_dot(side) / outwards);
        }
    }
    nearest
}

/// Corners of the convex hull against the clock (y up), without those on straight sides, from the leftmost (lowest) one:
/// Andrew's monotone chain (1979). Fewer than three where the points lie on a line. Points that are not finite do not
/// count. O(n log n).
#[must_use]
pub fn convex_hull(points: &[Vec2]) -> Vec<Vec2> {
    // Adding 0 makes 0 of −0, which would be sorted before it.
    let finite = points.iter().filter(|p| p.is_finite());
    let mut sorted: Vec<Vec2> = finite.map(|&p| p + Vec2::ZERO).collect();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let mut hull = Vec::new();
    chain(sorted.iter().copied(), &mut hull);
    chain(sorted.iter().rev().copied(), &mut hull);
    hull
}

/// Adds half a hull, without its last corner, which begins the other half.
fn chain(points: impl Iterator<Item = Vec2>, hull: &mut Vec<Vec2>) {
    let begin = hull.len();
    for point in points {
        while let &[.., a, b] = &hull[begin..]
            && (b.as_dvec2() - a.as_dvec2()).perp_dot(point.as_dvec2() - b.as_dvec2()) <= 0.0
        {
            hull.pop();
        }
        hull.push(point);
    }
    hull.pop();
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points(list: &[(f32, f32)]) -> Vec<Vec2> {
        list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
    }

    fn ellipse(width: f32, height: f32) -> Vec<Vec2> {
        let at = |i: usize| {
            let angle = std::f32::consts::TAU * i as f32 / 90.0;
            0.5 * Vec2::new(width * libm::cosf(angle), height * libm::sinf(angle))
        };
        (0..90).map(at).collect()
    }

    #[test]
    fn a_circle_reaches_half_its_width_everywhere() {
        let circle = Footprint::of(&ellipse(3.0, 3.0)).unwrap();
        assert!(circle.distances().iter().all(|d| (d - 0.5).abs() < 2e-3));
    }

    #[test]
    fn directions_begin_at_the_right_and_turn_against_the_clock() {
        // The centroid of the right-angled triangle is a third from its right angle.
        let distances: Vec<f32> =
            Footprint::of(&points(&[(0.0, 0.0), (3.0, 0.0), (0.0, 6.0)])).unwrap().into();
        let quarter = DIRECTIONS / 4;
        let expected = [1.0 / 6.0, 2.0 / 6.0, 1.0 / 6.0, 2.0 / 6.0];
        for (k, expected) in expected.into_iter().enumerate() {
            assert!((distances[k * quarter] - expected).abs() < 1e-6, "{k}: {distances:?}");
        }
    }

    #[test]
    fn a_poplar_is_farther_from_an_apple_tree_than_a_lime() {
        let [apple, lime, poplar] = [(1.0, 1.0), (0.8, 1.0), (0.25, 1.0)]
            .map(|(width, height)| Footprint::of(&ellipse(width, height)).unwrap());
        assert!(apple.distance(&lime) < 0.3 * apple.distance(&poplar));
        assert_eq!(apple.distance(&apple), 0.0);
    }

    #[test]
    fn what_has_no_area_has_no_footprint() {
        let nan = Vec2::NAN;
        for list in [
            vec![],
            vec![Vec2::ONE],
            vec![Vec2::ONE; 5],
            vec![Vec2::ZERO, Vec2::ONE, 2.0 * Vec2::ONE],
            vec![nan, Vec2::ZERO, Vec2::X, Vec2::INFINITY],
        ] {
            assert_eq!(Footprint::of(&list), None, "{list:?}");
        }
    }

    #[test]
    fn lists_of_another_length_or_with_bad_distances_are_refused() {
        let error = Footprint::try_from(vec![0.5; 3]).unwrap_err().to_string();
        assert!(error.contains("64") && error.contains('3'), "{error}");
        let mut bad = vec![0.5; DIRECTIONS];
        bad[7] = f32::NAN;
        let error = Footprint::try_from(bad).unwrap_err().to_string();
        assert!(error.contains("footprint[7]"), "{error}");
    }

    #[cfg(feature = "json")]
    #[test]
    fn a_footprint_is_stored_as_a_plain_list() {
        let circle = Footprint::of(&ellipse(1.0, 1.0)).unwrap();
        let text = serde_json::to_string(&circle).unwrap();
        assert!(text.starts_with("[0.5"), "{text}");
        assert_eq!(serde_json::from_str::<Footprint>(&text).unwrap(), circle);
        assert!(serde_json::from_str::<Footprint>("[0.5,0.5]").is_err());
    }

    fn cloud() -> impl Strategy<Value = Vec<Vec2>> {
        // A coarse grid, so that points repeat and lie on lines.
        prop::collection::vec((-8_i32..8, -8_i32..8), 0..40)
            .prop_map(|list| list.iter().map(|&(x, y)| Vec2::new(x as f32, y as f32)).collect())
    }

    #[test]
    fn minus_zero_is_zero() {
        let list = [(-0.0, 5.0), (0.0, 3.0), (0.0, 9.0), (1.0, 5.0)];
        assert_eq!(convex_hull(&list.map(Vec2::from)).len(), 3);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        #[test]
        fn the_hull_has_exactly_the_points_outside_of_no_triangle_of_others(cloud in cloud()) {
            let mut unique = cloud.clone();
            unique.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
            unique.dedup();
            let hull = convex_hull(&cloud);
            if hull.len() < 3 {
                return Ok(());
            }
            // Corners are the points with a line through them that leaves all others strictly on one side:
            // brute force over the gaps between directions to the others.
            for &point in &unique {
                let mut angles: Vec<f64> = unique.iter().filter(|&&q| q != point).map(|&q| {
                    let d = (q - point).as_dvec2();
                    libm::atan2(d.y, d.x)
                }).collect();
                angles.sort_by(f64::total_cmp);
                let first = angles[0] + std::f64::consts::TAU;
                let gap = angles.windows(2).map(|w| w[1] - w[0])
                    .chain([first - angles[angles.len() - 1]]).fold(0.0, f64::max);
                prop_assert_eq!(gap > std::f64::consts::PI + 1e-9, hull.contains(&point));
            }
        }

        #[test]
        fn scale_and_place_do_not_matter(
            cloud in cloud(), scale in 0.01_f32..100.0, x in -50.0_f32..50.0, y in -50.0_f32..50.0,
        ) {
            let Some(footprint) = Footprint::of(&cloud) else { return Ok(()) };
            let moved: Vec<Vec2> = cloud.iter().map(|&p| scale * (p + Vec2::new(x, y))).collect();
            let moved = Footprint::of(&moved).unwrap();
            prop_assert!(footprint.distance(&moved) < 1e-4);
        }
    }
}
