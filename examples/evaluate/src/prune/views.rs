//! Cameras around a model, and what a simplified model covers of the full one from there. The one place
//! that takes masks.

use super::Outcome;
use std::f32::consts::TAU;
use tree_core::Control;
use tree_core::glam::Vec3;
use tree_lod::preview::{Camera, Lens, Pose, View, mask};
use tree_lod::quality::Score;
use tree_mesh::Mesh;

/// Vertical field of view in radians: a portrait lens.
const FOV: f32 = 0.6;
/// Room around the bounding sphere, in radii.
const ROOM: f32 = 1.02;

/// `n` views all around a model, the first at azimuth `first` of a step, looking down by `pitch` radians.
pub(super) fn around(mesh: &Mesh, n: u32, first: f32, pitch: f32, pixels: u32) -> Vec<View> {
    let (center, radius) = mesh.bounding_sphere().unwrap_or((Vec3::ZERO, 1.0));
    let distance = ROOM * radius / libm::sinf(0.5 * FOV);
    (0..n)
        .map(|i| {
            let (sin_yaw, cos_yaw) = libm::sincosf(TAU * (i as f32 + first) / n as f32);
            let (sin_pitch, cos_pitch) = libm::sincosf(pitch);
            let toward = Vec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
            let eye = center + distance * toward;
            let lens = Lens::Perspective { fov: FOV };
            let camera = Camera::Placed(Pose { eye, target: center, up: Vec3::Y, lens });
            View { width: pixels, height: pixels, samples: 1, camera }
        })
        .collect()
}

/// A full model's pixels from some views.
pub(super) struct Reference {
    views: Vec<View>,
    masks: Vec<Vec<bool>>,
}

impl Reference {
    pub(super) fn new(full: &Mesh, views: Vec<View>) -> Outcome<Self> {
        let masks = views.iter().map(|view| covered(full, view)).collect::<Outcome<_>>()?;
        Ok(Self { views, masks })
    }

    /// The score of a model in each view.
    pub(super) fn scores(&self, mesh: &Mesh) -> Outcome<Vec<Score>> {
        self.views
            .iter()
            .zip(&self.masks)
            .map(|(view, full)| Ok(score(full, &covered(mesh, view)?)))
            .collect()
    }

    /// Mean quality over the views.
    pub(super) fn quality(&self, mesh: &Mesh) -> Outcome<f64> {
        Ok(mean(&self.scores(mesh)?.iter().map(Score::quality).collect::<Vec<_>>()))
    }
}

fn covered(mesh: &Mesh, view: &View) -> Outcome<Vec<bool>> {
    Ok(mask(mesh, view, &Control::default())?.bits().collect())
}

fn score(full: &[bool], other: &[bool]) -> Score {
    full.iter().zip(other).fold(Score::default(), |mut score, (&full, &other)| {
        score.both += u64::from(full && other);
        score.wrong += u64::from(other && !full);
        score.missed += u64::from(full && !other);
        score
    })
}

pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Standard deviation.
pub(super) fn spread(values: &[f64]) -> f64 {
    let middle = mean(values);
    mean(&values.iter().map(|x| (x - middle) * (x - middle)).collect::<Vec<_>>()).sqrt()
}
