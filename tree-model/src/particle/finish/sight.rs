//! What the images say about a point in space.

use crate::particle::camera::Projector;
use crate::particle::matte::Matte;
use crate::particle::view::View;
use glam::{Quat, Vec2, Vec3};
use tree_core::Leaf;

/// Rows of the coarse maps in which twigs and leaves are counted: a pixel is about as large as a leaf.
const ROWS: f32 = 96.0;
/// Opaque pixels ask for this much of the light to be left: more leaves behind leaves do not show.
const LEAST_LIGHT: f32 = 0.03;
/// Where a leaf looks at the image: across and along the midrib, in shares of its length.
const LOOKS: [(f32, f32); 5] = [(0.0, 0.15), (0.0, 0.5), (0.0, 0.85), (-0.25, 0.55), (0.25, 0.55)];

/// One image, ready to be asked.
pub(super) struct Sight<'a> {
    matte: &'a Matte,
    projector: Projector,
    /// Pixels of the image for one of the coarse maps.
    coarse: f32,
    size: [usize; 2],
    /// Mean of the matte in each coarse pixel.
    means: Vec<f32>,
}

impl<'a> Sight<'a> {
    pub(super) fn new(view: &'a View, height: f32) -> Self {
        let matte = &view.matte;
        let projector = view.camera.projector();
        let rows = height / projector.pixel_size(Vec3::ZERO).max(f32::MIN_POSITIVE);
        let coarse = (rows / ROWS).max(1.0);
        let size = [matte.width(), matte.height()].map(|n| (n as f32 / coarse) as usize + 1);
        let mut sums = vec![(0.0_f32, 0_u32); size[0] * size[1]];
        for (row, line) in matte.alpha().chunks(matte.width() as usize).enumerate() {
            let start = (row as f32 / coarse) as usize * size[0];
            for (column, &alpha) in line.iter().enumerate() {
                let sum = &mut sums[start + (column as f32 / coarse) as usize];
                sum.0 += alpha;
                sum.1 += 1;
            }
        }
        let means = sums.iter().map(|&(sum, n)| sum / n.max(1) as f32).collect();
        Self { matte, projector, coarse, size, means }
    }

    /// The coarse pixel a point falls on; `None` outside the image.
    fn coarse_at(&self, point: Vec3) -> Option<usize> {
        let at = self.projector.project(point)? / self.coarse;
        if !(at.x >= 0.0 && at.y >= 0.0) {
            return None;
        }
        let (x, y) = (at.x as usize, at.y as usize);
        // Not reckoned with far outside: the product could overflow.
        (x < self.size[0] && y < self.size[1]).then(|| y * self.size[0] + x)
    }

    /// Mean of the matte about a point; `None` outside the image, where it says nothing.
    pub(super) fn around(&self, point: Vec3) -> Option<f32> {
        self.coarse_at(point).map(|i| self.means[i])
    }

    /// Mean of the matte under a leaf; `None` outside the image.
    pub(super) fn under(&self, leaf: &Leaf) -> Option<f32> {
        let along = leaf.rotation * Vec3::Y * leaf.size;
        let across = leaf.rotation * Vec3::X * leaf.size;
        let mut sum = 0.0;
        for (right, up) in LOOKS {
            let at = leaf.position + right * across + up * along;
            let pixel = self.projector.project(at)?;
            let inside = pixel.cmpge(Vec2::ZERO).all()
                && pixel.x <= self.matte.width() as f32
                && pixel.y <= self.matte.height() as f32;
            if !inside {
                return None;
            }
            sum += self.matte.sample(pixel);
        }
        Some(sum / LOOKS.len() as f32)
    }

    /// Optical depth that each coarse pixel asks for.
    pub(super) fn asked(&self) -> Vec<f32> {
        self.means.iter().map(|&alpha| -libm::logf((1.0 - alpha).max(LEAST_LIGHT))).collect()
    }

    /// Optical depth of leaves in each coarse pixel, where a blade covers `blade` times its length squared when seen
    /// from the front.
    pub(super) fn covered(&self, leaves: impl Iterator<Item = Leaf>, blade: f32) -> Vec<f32> {
        let mut depths = vec![0.0; self.means.len()];
        let forward = self.projector.frame.forward;
        for leaf in leaves {
            let middle = leaf.position + leaf.rotation * Vec3::Y * (0.5 * leaf.size);
            if let Some(i) = self.coarse_at(middle) {
                let pixel = self.coarse * self.projector.pixel_size(middle);
                let area = blade * leaf.size * leaf.size * facing(leaf.rotation, forward);
                depths[i] += area / (pixel * pixel);
            }
        }
        depths
    }

    /// The value of a coarse map at a point.
    pub(super) fn look_up(&self, map: &[f32], point: Vec3) -> Option<f32> {
        self.coarse_at(point).map(|i| map[i])
    }
}

/// Share of a leaf's face that is seen along `forward`.
fn facing(rotation: Quat, forward: Vec3) -> f32 {
    (rotation * Vec3::Z).dot(forward).abs()
}
