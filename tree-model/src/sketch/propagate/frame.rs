//! Frames and points along branches.

use glam::{Vec2, Vec3};

/// Points between the ends of a new segment, and of a block's child.
pub(super) const BETWEEN: usize = 3;

/// A direction and one across it, carried along without twist: turning from one direction to the next, the
/// vector across only loses what is not across any more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) along: Vec3,
    pub(super) normal: Vec3,
}

impl Frame {
    /// Straight up, as seen by who drew: the vector across points right.
    pub(super) const UP: Self = Self { along: Vec3::Y, normal: Vec3::X };

    /// The frame further up, where the branch heads for `along`, a unit vector.
    pub(super) fn carried(self, along: Vec3) -> Self {
        let normal = self.normal - along * self.normal.dot(along);
        Self {
            along,
            normal: normal.try_normalize().unwrap_or_else(|| along.any_orthonormal_vector()),
        }
    }

    /// Unit vector across, at `azimuth` about the direction.
    pub(super) fn across(self, azimuth: f32) -> Vec3 {
        let (sin, cos) = libm::sincosf(azimuth);
        cos * self.normal + sin * self.along.cross(self.normal)
    }

    /// The axes of a child that leaves at `angle` and `azimuth`: its direction, and two across it by which its bend is
    /// told. They depend on the child's place alone.
    pub(super) fn child(self, angle: f32, azimuth: f32) -> [Vec3; 3] {
        let (sin, cos) = libm::sincosf(angle);
        let out = self.across(azimuth);
        let along = cos * self.along + sin * out;
        let bow = cos * out - sin * self.along;
        [along, bow, along.cross(bow)]
    }

    /// Angle and azimuth of a unit vector.
    pub(super) fn angles(self, child: Vec3) -> [f32; 2] {
        let side = self.along.cross(self.normal);
        let (x, y) = (child.dot(self.normal), child.dot(side));
        [libm::atan2f((x * x + y * y).sqrt(), child.dot(self.along)), libm::atan2f(y, x)]
    }
}

/// A line of points with the way to each.
pub(super) struct Course<'a> {
    points: &'a [Vec3],
    ways: Vec<f32>,
}

impl<'a> Course<'a> {
    pub(super) fn new(points: &'a [Vec3]) -> Self {
        let mut way = 0.0;
        let mut ways = vec![0.0];
        ways.extend(points.windows(2).map(|pair| {
            way += pair[0].distance(pair[1]);
            way
        }));
        Self { points, ways }
    }

    /// Length of the line.
    pub(super) fn length(&self) -> f32 {
        self.ways.last().copied().unwrap_or(0.0)
    }

    /// Where `way` metres from the beginning are, counted in points: 2.25 is a quarter of the way from point 2 to 3.
    pub(super) fn place(&self, way: f32) -> f32 {
        let after = self.ways.partition_point(|&w| w <= way).clamp(1, self.ways.len().max(2) - 1);
        let [from, to] = [after - 1, after].map(|i| self.ways.get(i).copied().unwrap_or(0.0));
        let share = if to > from { (way - from) / (to - from) } else { 0.0 };
        (after - 1) as f32 + share.clamp(0.0, 1.0)
    }

    /// The point `way` metres from the beginning.
    pub(super) fn at(&self, way: f32) -> Vec3 {
        point_at(self.points, self.place(way))
    }

    /// Unit vector from `from` metres to `to` metres; `fallback` where that is no way.
    pub(super) fn heading(&self, from: f32, to: f32, fallback: Vec3) -> Vec3 {
        (self.at(to) - self.at(from)).normalize_or(fallback)
    }

    /// How the first `way` metres bend: the offset of points between from the straight line, along two axes across it,
    /// in lengths of that line.
    pub(super) fn bend(&self, way: f32, axes: [Vec3; 3]) -> [Vec2; BETWEEN] {
        let (start, end) = (self.at(0.0), self.at(way));
        let length = start.distance(end);
        std::array::from_fn(|i| {
            let share = (i + 1) as f32 / (BETWEEN + 1) as f32;
            let off = self.at(share * way) - start.lerp(end, share);
            if length > 0.0 {
                Vec2::new(off.dot(axes[1]), off.dot(axes[2])) / length
            } else {
                Vec2::ZERO
            }
        })
    }
}

/// The point at a place counted in points.
pub(in crate::sketch) fn point_at(points: &[Vec3], place: f32) -> Vec3 {
    let below = place.floor().max(0.0) as usize;
    let from = points.get(below).or(points.last()).copied().unwrap_or_default();
    let to = points.get(below + 1).copied().unwrap_or(from);
    from.lerp(to, place - place.floor())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_child_is_found_again_at_its_angles() {
        let frame = Frame::UP.carried(Vec3::new(1.0, 2.0, 0.5).normalize());
        let [along, ..] = frame.child(0.7, -1.2);
        let [angle, azimuth] = frame.angles(along);
        assert!((angle - 0.7).abs() < 1e-5 && (azimuth + 1.2).abs() < 1e-5, "{angle} {azimuth}");
    }

    #[test]
    fn places_count_in_points() {
        let points = [Vec3::ZERO, Vec3::Y, 3.0 * Vec3::Y];
        let course = Course::new(&points);
        assert_eq!(
            [0.0, 0.5, 1.0, 2.0, 3.0, 9.0].map(|w| course.place(w)),
            [0.0, 0.5, 1.0, 1.5, 2.0, 2.0]
        );
        assert_eq!(course.at(2.5), 2.5 * Vec3::Y);
    }

    #[test]
    fn a_line_of_one_place_has_no_way() {
        let points = [Vec3::X; 3];
        let course = Course::new(&points);
        assert_eq!((course.length(), course.at(1.0)), (0.0, Vec3::X));
        assert_eq!(course.heading(0.0, 1.0, Vec3::Y), Vec3::Y);
    }
}
