//! Lines in the plane, measured along.

use glam::Vec2;

/// A line in the plane: at least two points, finite, none repeated. Metres, y up.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Vec<Vec2>", into = "Vec<Vec2>")
)]
pub struct Line {
    points: Vec<Vec2>,
    /// Length from the start to each point.
    along: Vec<f32>,
}

impl Line {
    /// A line through points. Points that are not finite, and repeated ones, are left out; `None` where fewer than
    /// two are left.
    #[must_use]
    pub fn new(points: Vec<Vec2>) -> Option<Self> {
        let mut kept: Vec<Vec2> = Vec::with_capacity(points.len());
        let mut along = Vec::with_capacity(points.len());
        let mut length = 0.0;
        for point in points {
            let next = length + kept.last().map_or(0.0, |last: &Vec2| last.distance(point));
            // A step too small for the length so far would be none.
            if point.is_finite() && next.is_finite() && (kept.is_empty() || next > length) {
                length = next;
                kept.push(point);
                along.push(length);
            }
        }
        (kept.len() > 1 && length > 0.0 && length.is_finite())
            .then_some(Self { points: kept, along })
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> &[Vec2] {
        &self.points
    }

    /// Its length in metres.
    #[must_use]
    pub fn length(&self) -> f32 {
        self.along.last().copied().unwrap_or(0.0)
    }

    /// Its first point.
    #[must_use]
    pub fn start(&self) -> Vec2 {
        self.points[0]
    }

    /// Its last point.
    #[must_use]
    pub fn end(&self) -> Vec2 {
        self.points[self.points.len() - 1]
    }

    /// From its first to its last point.
    #[must_use]
    pub fn span(&self) -> Vec2 {
        self.end() - self.start()
    }

    /// The point at a share of its length, 0 to 1. O(log points).
    #[must_use]
    pub fn at(&self, t: f32) -> Vec2 {
        let (i, part) = self.place(t);
        self.points[i].lerp(self.points[i + 1], part)
    }

    /// The direction at a share of its length, of unit length; smooth between the middles of its stretches. O(log points).
    #[must_use]
    pub fn tangent(&self, t: f32) -> Vec2 {
        let (i, part) = self.place(t);
        let here = self.stretch(i);
        let other =
            if part < 0.5 { self.stretch(i.saturating_sub(1)) } else { self.stretch(i + 1) };
        let share = (part - 0.5).abs();
        here.lerp(other, share).try_normalize().unwrap_or(here)
    }

    /// The direction it starts in, of unit length: that of the cubic through its first four points, taken for evenly spaced.
    /// The chord of the first stretch of a curve would be several degrees off.
    #[must_use]
    pub fn foot(&self) -> Vec2 {
        let way = match self.points.as_slice() {
            &[a, b, c, d, ..] => 18.0 * (b - a) - 9.0 * (c - a) + 2.0 * (d - a),
            _ => self.stretch(0),
        };
        way.try_normalize().unwrap_or_else(|| self.stretch(0))
    }

    /// Where along it the point nearest to `point` is, as a share of its length, and how far that is. O(points).
    #[must_use]
    pub fn nearest(&self, point: Vec2) -> (f32, f32) {
        let mut best = (0.0, f32::INFINITY);
        for (i, pair) in self.points.windows(2).enumerate() {
            let (from, way) = (pair[0], pair[1] - pair[0]);
            let part = ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let distance = point.distance(from + part * way);
            if distance < best.1 {
                best = (self.along[i] + part * (self.along[i + 1] - self.along[i]), distance);
            }
        }
        (best.0 / self.length(), best.1)
    }

    /// The same line by `n` points at even distances, 2 at least.
    #[must_use]
    pub fn resampled(&self, n: usize) -> Self {
        let n = n.max(2);
        let points = (0..n).map(|i| self.at(i as f32 / (n - 1) as f32)).collect();
        Self::new(points).unwrap_or_else(|| self.clone())
    }

    /// The part from one share of its length to a greater one; `None` where nothing is left of it.
    #[must_use]
    pub fn part(&self, from: f32, to: f32) -> Option<Self> {
        let (low, high) = (from * self.length(), to * self.length());
        let within = self.points.iter().zip(&self.along).filter(|&(_, &a)| a > low && a < high);
        let mut points = vec![self.at(from)];
        points.extend(within.map(|(&point, _)| point));
        points.push(self.at(to));
        if to > from { Self::new(points) } else { None }
    }

    /// The stretch a share of the length lies on, and how far along it, 0 to 1.
    fn place(&self, t: f32) -> (usize, f32) {
        let target = t.clamp(0.0, 1.0) * self.length();
        let i = self.along.partition_point(|&a| a <= target).clamp(1, self.along.len() - 1) - 1;
        (i, (target - self.along[i]) / (self.along[i + 1] - self.along[i]))
    }

    /// Direction of stretch `i`, or of the last one.
    fn stretch(&self, i: usize) -> Vec2 {
        let i = i.min(self.points.len() - 2);
        (self.points[i + 1] - self.points[i]).normalize_or_zero()
    }
}

impl TryFrom<Vec<Vec2>> for Line {
    type Error = &'static str;

    fn try_from(points: Vec<Vec2>) -> Result<Self, Self::Error> {
        Self::new(points).ok_or("a line needs two different finite points")
    }
}

impl From<Line> for Vec<Vec2> {
    fn from(line: Line) -> Self {
        line.points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner() -> Line {
        Line::new(vec![Vec2::ZERO, Vec2::Y, Vec2::Y, Vec2::NAN, Vec2::new(3.0, 1.0)]).unwrap()
    }

    #[test]
    fn it_is_measured_along_its_length() {
        let line = corner();
        assert_eq!((line.points().len(), line.length()), (3, 4.0));
        assert_eq!(line.at(0.5), Vec2::new(1.0, 1.0));
        assert_eq!((line.at(-1.0), line.at(2.0)), (Vec2::ZERO, Vec2::new(3.0, 1.0)));
        assert_eq!(line.nearest(Vec2::new(2.0, 5.0)), (0.75, 4.0));
        assert_eq!(line.part(0.5, 1.0).unwrap().length(), 2.0);
    }

    #[test]
    fn its_direction_turns_gradually() {
        let line = corner();
        assert_eq!(line.tangent(0.0), Vec2::Y);
        assert_eq!(line.tangent(1.0), Vec2::X);
        assert!(line.tangent(0.25).dot(Vec2::ONE.normalize()) > 0.99);
    }

    #[test]
    fn it_starts_in_the_direction_of_its_curve() {
        let parabola = (0..9).map(|i| i as f32 / 8.0).map(|x| Vec2::new(x, x - 0.5 * x * x));
        let foot = Line::new(parabola.collect()).unwrap().foot();
        assert!(foot.dot(Vec2::ONE.normalize()) > 0.9999, "{foot}");
        assert_eq!(corner().part(0.0, 0.2).unwrap().foot(), Vec2::Y);
    }

    #[test]
    fn what_is_no_line_is_refused() {
        for points in
            [vec![], vec![Vec2::ONE; 3], vec![Vec2::NAN, Vec2::ONE], vec![-Vec2::MAX, Vec2::MAX]]
        {
            assert!(Line::new(points).is_none());
        }
    }
}
