//! The picture of a camera: what the shaders do, pixel by pixel.

use super::Octahedral;
use super::map::frames;
use super::trace::Met;
use crate::error::{LodError, Result};
use crate::preview::{Camera, Mask, Picture, Projector, Srgb};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::Mesh;

impl Octahedral {
    /// What a placed camera sees: sRGB colour without light, and alpha, to be tested against one half:
    /// that gives the outline. Where views disagree it lies between, so that trees that are blended by it are
    /// paler inside. This is the reference for the shaders.
    ///
    /// # Errors
    /// [`LodError::Parameter`] or [`LodError::Camera`] for a bad camera or a side outside 1 to 16,384;
    /// [`LodError::Impostor`] for a framed camera or pictures that do not fit [`OctahedralMeta`](super::OctahedralMeta);
    /// [`LodError::Limit`] over the limit of pixels.
    ///
    /// # Complexity
    /// O(pixels of the tree × 3 × [`STEPS`](super::STEPS)), in parallel over rows.
    pub fn view(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        control: &Control,
    ) -> Result<Picture> {
        let mut picture = Picture { width, height, pixels: Vec::new() };
        let pixel = |met: Met, srgb: &Srgb| {
            let [r, g, b] = met.color.to_array().map(|v| srgb.encode(v.clamp(0.0, 1.0)));
            [r, g, b, (met.alpha.clamp(0.0, 1.0) * 255.0 + 0.5) as u8]
        };
        picture.pixels =
            self.pixels(camera, width, height, control, pixel)?.as_flattened().to_vec();
        Ok(picture)
    }

    /// Alpha alone, as [`view`](Self::view).
    ///
    /// # Errors
    /// As [`view`](Self::view).
    pub fn mask(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        control: &Control,
    ) -> Result<Mask> {
        let alpha = |met: Met, _: &Srgb| (met.alpha.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let coverage = self.pixels(camera, width, height, control, alpha)?;
        Ok(Mask { width, height, coverage })
    }

    fn pixels<T: Copy + Default + Send>(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        control: &Control,
        pixel: impl Fn(Met, &Srgb) -> T + Sync,
    ) -> Result<Vec<T>> {
        self.check()?;
        let view = crate::preview::View { width, height, samples: 1, camera: *camera };
        view.validate()?;
        let Camera::Placed(_) = camera else {
            return Err(LodError::Impostor("the camera must be placed: there is no mesh to frame"));
        };
        control.limits.check(Resource::Pixels, u64::from(width) * u64::from(height))?;
        let pose = camera.pose(&Mesh::default(), 1.0)?;
        let projector = Projector::new(&pose, width, height, 2.0 * self.meta.radius);
        let srgb = Srgb::shared();
        let mut pixels = vec![T::default(); width as usize * height as usize];
        pixels.par_chunks_mut(width as usize).enumerate().try_for_each(|(y, row)| {
            control.check()?;
            for (x, out) in row.iter_mut().enumerate() {
                let (origin, direction) = projector.ray(x as f32 + 0.5, y as f32 + 0.5);
                *out = pixel(self.ray(origin, direction.normalize(), srgb), srgb);
            }
            Ok::<_, LodError>(())
        })?;
        Ok(pixels)
    }

    /// What a ray with unit direction sees.
    fn ray(&self, origin: Vec3, direction: Vec3, srgb: &Srgb) -> Met {
        let from = origin - self.meta.center;
        // The part of the ray within the ball, in front of the eye.
        let middle = -from.dot(direction);
        let inside =
            self.meta.radius * self.meta.radius - (from + direction * middle).length_squared();
        if inside <= 0.0 || middle + inside.sqrt() <= 0.0 {
            return Met::default();
        }
        let ends = [(middle - inside.sqrt()).max(0.0), middle + inside.sqrt()];
        let frames = frames(-direction, self.meta.grid, self.meta.hemi);
        self.trace(&frames.map(|frame| self.line(frame, from, direction)), ends, srgb)
    }

    /// Checks that pictures and numbers fit, as they do after baking.
    ///
    /// # Errors
    /// [`LodError::Parameter`], [`LodError::Picture`] or [`LodError::Impostor`].
    pub fn check(&self) -> Result<()> {
        self.meta.validate()?;
        for (picture, side) in
            [(&self.color, self.meta.side), (&self.detail, self.meta.detail_side)]
        {
            picture.check()?;
            if (picture.width, picture.height) != (side, side) {
                return Err(LodError::Impostor("a picture has another size than the numbers say"));
            }
        }
        Ok(())
    }
}
