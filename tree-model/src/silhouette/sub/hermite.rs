//! Cubic Hermite curves in the plane.

use glam::Vec2;

/// A curve by its ends and its derivatives there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hermite {
    /// Where it begins.
    pub from: Vec2,
    /// Derivative at its begin.
    pub leaves: Vec2,
    /// Where it ends.
    pub to: Vec2,
    /// Derivative at its end.
    pub arrives: Vec2,
}

impl Hermite {
    /// The point at `t`, 0 to 1.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec2 {
        let (square, cube) = (t * t, t * t * t);
        (2.0 * cube - 3.0 * square + 1.0) * self.from
            + (cube - 2.0 * square + t) * self.leaves
            + (3.0 * square - 2.0 * cube) * self.to
            + (cube - square) * self.arrives
    }

    /// The derivative at `t`, 0 to 1.
    #[must_use]
    pub fn derivative(&self, t: f32) -> Vec2 {
        let square = t * t;
        (6.0 * square - 6.0 * t) * (self.from - self.to)
            + (3.0 * square - 4.0 * t + 1.0) * self.leaves
            + (3.0 * square - 2.0 * t) * self.arrives
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_has_the_ends_and_derivatives_given() {
        let curve = Hermite {
            from: Vec2::X,
            leaves: Vec2::new(0.5, 2.0),
            to: Vec2::new(3.0, -1.0),
            arrives: -Vec2::Y,
        };
        assert_eq!((curve.at(0.0), curve.at(1.0)), (curve.from, curve.to));
        assert_eq!((curve.derivative(0.0), curve.derivative(1.0)), (curve.leaves, curve.arrives));
        let slope = (curve.at(0.501) - curve.at(0.499)) / 0.002;
        assert!(slope.distance(curve.derivative(0.5)) < 1e-2);
    }
}
