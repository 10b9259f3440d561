//! Ranges of the parameters; each error names the field.

use super::bark::BarkStyle;
use super::leaf::LeafShape;
use crate::error::Result;
use std::f32::consts::PI;
use tree_core::check_parameter;

fn range(field: &'static str, found: f32, min: f32, max: f32) -> Result<()> {
    Ok(check_parameter(field, found, min, max)?)
}

fn count(field: &'static str, found: u32, min: u32, max: u32) -> Result<()> {
    Ok(check_parameter(field, found, min, max)?)
}

pub(super) fn size(size_px: u32) -> Result<()> {
    count("size_px", size_px, 16, 4096)
}

impl BarkStyle {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        range("tinting", self.tinting, 0.0, 1.0)?;
        range("crack", self.crack, 0.0, 1.0)?;
        range("plate_contrast", self.plate_contrast, 0.0, 1.0)?;
        range("furrow_width", self.furrow_width, 0.0, 1.0)?;
        range("furrow_depth", self.furrow_depth, 0.0, 1.0)?;
        range("ragged", self.ragged, 0.0, 1.0)?;
        range("warp", self.warp, 0.0, 0.5)?;
        range("flakes", self.flakes, 0.0, 1.0)?;
        range("grain_height", self.grain_height, 0.0, 1.0)?;
        range("ring_contrast", self.ring_contrast, 0.0, 1.0)?;
        range("relief", self.relief, 0.0, 3.0)?;
        count("rings", self.rings, 0, 256)?;
        for (field, value) in
            [("plates", self.plates), ("furrows", self.furrows), ("grain", self.grain)]
        {
            count(field, value[0].max(value[1]), 0, 256)?;
        }
        count("patches", u32::try_from(self.patches.len()).unwrap_or(u32::MAX), 0, 16)?;
        for patches in self.patches.iter() {
            range("patches.share", patches.share, 0.0, 1.0)?;
            range("patches.softness", patches.softness, 0.01, 1.0)?;
            range("patches.opacity", patches.opacity, 0.0, 1.0)?;
            range("patches.roughness", patches.roughness, 0.0, 1.0)?;
            for n in patches.count {
                count("patches.count", n, 1, 256)?;
            }
        }
        if let Some(lenticels) = &self.lenticels {
            range("lenticels.share", lenticels.share, 0.0, 1.0)?;
            range("lenticels.length", lenticels.length, 0.01, 1.0)?;
            range("lenticels.thickness", lenticels.thickness, 0.01, 1.0)?;
            for n in lenticels.count {
                count("lenticels.count", n, 1, 256)?;
            }
        }
        Ok(())
    }
}

impl LeafShape {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        let n_points = u32::try_from(self.outline.len()).unwrap_or(u32::MAX);
        count("outline", n_points, 2, 256)?;
        for &[x, y, sharpness] in self.outline.iter() {
            range("outline x", x, 0.0, 2.0)?;
            range("outline y", y, -1.0, 2.0)?;
            range("outline sharpness", sharpness, 0.0, 1.0)?;
        }
        count("teeth.count", self.teeth.count, 0, 100)?;
        range("teeth.depth", self.teeth.depth, 0.0, 0.2)?;
        range("teeth.sharpness", self.teeth.sharpness, 0.0, 1.0)?;
        range("petiole", self.petiole, 0.0, 0.8)?;
        count("veins.rays", u32::try_from(self.veins.rays.len()).unwrap_or(u32::MAX), 0, 8)?;
        for &angle in self.veins.rays.iter() {
            range("veins.rays", angle, 0.0, PI)?;
        }
        range("veins.pairs", self.veins.pairs, 0.0, 64.0)?;
        range("veins.slope", self.veins.slope, 0.0, 4.0)?;
        range("veins.contrast", self.veins.contrast, 0.0, 1.0)?;
        range("style.mottle", self.style.mottle, 0.0, 1.0)?;
        let Some(spray) = &self.spray else {
            return Ok(());
        };
        count("spray.leaves", spray.leaves, 1, 400)?;
        count("spray.shoots", spray.shoots, 0, 32)?;
        range("spray.bare", spray.bare, 0.0, 0.9)?;
        range("spray.jitter", spray.jitter, 0.0, 1.0)?;
        range("spray.bend", spray.bend, -0.5, 0.5)?;
        range("spray.twig", spray.twig, 0.001, 0.2)?;
        range("spray.shoot_angle", spray.shoot_angle, 0.0, PI)?;
        range("spray.shoot_size", spray.shoot_size, 0.05, 1.0)?;
        for angle in spray.angle {
            range("spray.angle", angle, 0.0, PI)?;
        }
        for size in spray.size {
            range("spray.size", size, 0.01, 2.0)?;
        }
        Ok(())
    }
}
