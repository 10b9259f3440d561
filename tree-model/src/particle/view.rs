//! One photograph, ready to be used: what it shows of the tree and where it was taken from.

use super::camera::Camera;
use super::matte::Matte;
use super::photo::Photo;
use glam::Vec2;
use std::f32::consts::FRAC_PI_2;

/// One photograph, ready to be used.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// How much of each pixel the tree covers.
    pub matte: Matte,
    /// The photograph itself, of the same size, where livewire may look for branches. Without it, it
    /// looks at the matte.
    pub photo: Option<Photo>,
    /// Where it was taken from.
    pub camera: Camera,
}

/// Views whose lines of sight are at least this far from parallel show a tree's width from two sides: sine of 30°.
const TWO_SIDES: f32 = 0.5;

impl View {
    /// The view mirrored and a quarter turn round: what a tree may look like from its side.
    #[must_use]
    pub fn turned(&self) -> Self {
        let Camera { yaw, size, base, .. } = self.camera;
        let camera = Camera {
            yaw: yaw + FRAC_PI_2,
            base: Vec2::new(size.x - base.x, base.y),
            ..self.camera
        };
        let photo = self.photo.as_ref().map(Photo::mirrored);
        Self { matte: self.matte.mirrored(), photo, camera }
    }
}

/// Whether all views look along nearly the same line, so that none shows the depth of the tree.
pub(super) fn are_of_one_side(views: &[View]) -> bool {
    let right = |view: &View| view.camera.frame().right;
    views.first().is_some_and(|first| {
        views.iter().all(|view| right(view).cross(right(first)).length() < TWO_SIDES)
    })
}
