//! Where a particle wants to go: the images' direction fields, the way to the base, its neighbour.

use super::super::camera::{Camera, Projector};
use super::super::field::DirectionField;
use super::params::FlowParams;
use super::way::Way;
use glam::{Mat3, Vec3};

/// What the views' directions say about a direction no view sees: this much of nothing, so that the
/// equations have a solution.
const UNSEEN: f32 = 1e-3;
/// A horizontal direction is unseen where all views together see less than this share of one view.
const SEEN_LEAST: f32 = 0.05;

/// One image's field and how to look it up from space.
#[derive(Clone, Debug)]
struct Eye<'a> {
    projector: Projector,
    field: &'a DirectionField,
}

/// Everything that steers particles.
#[derive(Clone, Debug)]
pub struct Forces<'a> {
    eyes: Vec<Eye<'a>>,
    way: &'a Way,
    /// Solves for the direction in space whose projections are nearest to the views' directions.
    solve: Mat3,
    /// The horizontal direction that no field sees, if there is one.
    unseen: Option<Vec3>,
    image: f32,
    base: f32,
    neighbour: f32,
}

impl<'a> Forces<'a> {
    /// Combines the views' fields with the way to the base. A field without a direction anywhere counts
    /// as no field.
    #[must_use]
    pub fn new(views: &[(Camera, &'a DirectionField)], way: &'a Way, params: &FlowParams) -> Self {
        let eyes: Vec<Eye<'_>> = views
            .iter()
            .filter(|(_, field)| field.vectors().iter().any(|v| v.length_squared() > 0.0))
            .map(|&(camera, field)| Eye { projector: camera.projector(), field })
            .collect();
        let outer = |v: Vec3| Mat3::from_cols(v * v.x, v * v.y, v * v.z);
        let seen = eyes.iter().fold(Mat3::from_diagonal(Vec3::splat(UNSEEN)), |sum, eye| {
            sum + outer(eye.projector.frame.right) + outer(eye.projector.frame.up)
        });
        // A quarter turn of a view's right vector is what that view does not see of the ground plane; the
        // least seen of those is the one that counts.
        let unseen = eyes
            .iter()
            .map(|eye| Vec3::Y.cross(eye.projector.frame.right))
            .map(|across| (across, across.dot(seen * across)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|&(_, sight)| sight < SEEN_LEAST)
            .map(|(across, _)| across);
        Self {
            eyes,
            way,
            solve: seen.inverse(),
            unseen,
            image: params.image,
            base: params.base,
            neighbour: params.neighbour,
        }
    }

    /// The direction a particle at `point` takes, a unit vector; `near` is the vector to its neighbour and
    /// the share of the neighbour's pull that it feels.
    #[must_use]
    #[inline]
    pub fn direction(&self, point: Vec3, near: Option<(Vec3, f32)>) -> Vec3 {
        if self.way.is_last(point) {
            return self.homewards(point);
        }
        let image = self.image_direction(point);
        let way = self.way.sample(point);
        let told = image.length();
        // Where the images say nothing, or contradict each other, the way to the base steps in.
        let mut sum = self.image * image + (self.base + self.image * (1.0 - told).max(0.0)) * way;
        if let Some(unseen) = self.unseen {
            sum += self.image * told * unseen * unseen.dot(way);
        }
        if let Some((towards, share)) = near {
            sum += (self.neighbour * share) * towards.normalize_or_zero();
        }
        sum.normalize_or(way)
    }

    /// Only the way to the base, for particles that are brought home.
    #[must_use]
    #[inline]
    pub fn homewards(&self, point: Vec3) -> Vec3 {
        self.way.sample(point).normalize_or((-point).normalize_or(Vec3::NEG_Y))
    }

    /// The direction in space that is nearest, in all images, to what their fields say; length 0 to 1.
    ///
    /// The thesis averages the views' vectors. That halves the horizontal part, which only one of two
    /// views sees, against the vertical one; least squares does not.
    #[inline]
    fn image_direction(&self, point: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for eye in &self.eyes {
            if let Some(pixel) = eye.projector.project(point) {
                let told = eye.field.sample(pixel);
                let frame = &eye.projector.frame;
                sum += told.x * frame.right + told.y * frame.up;
            }
        }
        (self.solve * sum).clamp_length_max(1.0)
    }
}
