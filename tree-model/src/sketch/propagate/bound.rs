//! Where new segments may be: inside the crown, outside of obstacles.

use crate::path::Obstacle;
use crate::sketch::crown::Crown;
use glam::Vec3;

/// A branch that reaches the surface ends this share of its last piece before it: rounding must not carry it out.
const BACK: f32 = 1e-3;

/// All that growth heeds.
#[derive(Clone, Copy)]
pub(super) struct Bounds<'a> {
    pub(super) crown: Option<&'a Crown>,
    pub(super) obstacle: Option<&'a Obstacle>,
    /// Height that nothing grows below.
    pub(super) ground: f32,
}

/// How much of a line of points the crown leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cut {
    /// All of it.
    Whole,
    /// So many points, the last of them moved to here: the line touches the surface.
    At(usize, Vec3),
}

impl Bounds<'_> {
    /// Whether a point lies in the crown, where there is one.
    pub(super) fn inside(&self, point: Vec3) -> bool {
        self.crown.is_none_or(|crown| crown.contains_3d(point))
    }

    /// Scales a line of points that begins inside back to the surface.
    pub(super) fn cut(&self, points: &[Vec3]) -> Cut {
        let Some(crown) = self.crown else { return Cut::Whole };
        for (i, pair) in points.windows(2).enumerate() {
            if crown.contains_3d(pair[1]) {
                continue;
            }
            let share = crown.exit(pair[0], pair[1]).unwrap_or(1.0) - BACK;
            let touch = pair[0].lerp(pair[1], share.clamp(0.0, 1.0));
            // Where exit and inside do not agree by a rounding error, the point before is safe.
            return Cut::At(i + 2, if crown.contains_3d(touch) { touch } else { pair[0] });
        }
        Cut::Whole
    }

    /// How far it is along a unit vector to the surface; `None` without a crown or where it is farther than `most`.
    pub(super) fn room(&self, from: Vec3, along: Vec3, most: f32) -> Option<f32> {
        self.crown?.exit(from, from + most * along).map(|share| share * most)
    }

    /// Whether a line of points keeps clear of the obstacle and the ground; where it begins deeper, it need not rise.
    pub(super) fn is_free(&self, points: &[Vec3]) -> bool {
        let ground = points.first().map_or(self.ground, |start| self.ground.min(start.y));
        points.iter().all(|point| point.y >= ground)
            && self.obstacle.is_none_or(|obstacle| {
                points.windows(2).all(|pair| obstacle.is_free(pair[0], pair[1]))
            })
    }
}
