//! Levels in glTF 2.0.

use super::model::PrunedModel;
use crate::error::{LodError, Result, check_range};
use crate::quality::Distance;
use tree_mesh::Mesh;
use tree_mesh::io::gltf::{self, Attribute, GlbOptions};

/// Half the field of view from top to bottom that distances are meant for, 30°: its tangent.
const TAN_HALF_FOV: f32 = 0.577_350_26;
/// Steps of the search for the distance of a λ: finer than a float's share.
const HALVINGS: usize = 24;

/// When levels in a file change, as programs with `MSFT_screencoverage` show them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// λ for each distance, 0 at `near` and 1 at `far`. Default Cook's.
    pub distance: Distance,
    /// Distance in metres up to which the full model is wanted, in a field of view of 60°, 0 or more.
    /// Default 10.
    pub near: f32,
    /// Distance from which on the least will do, more than `near`, at most 10⁹. Default 500.
    pub far: f32,
}

impl Default for Screen {
    fn default() -> Self {
        Self { distance: Distance::cook(), near: 10.0, far: 500.0 }
    }
}

impl Screen {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("near", self.near.into(), 0.0, 1e9)?;
        check_range("far", self.far.into(), f64::from(self.near).next_up(), 1e9)
    }

    /// Share of the screen's height that something of this size in metres has, 0 to 1, where λ has fallen
    /// to `lambda`.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    pub fn coverage(&self, lambda: f32, size: f32) -> Result<f32> {
        self.validate()?;
        let (mut above, mut below) = (0.0_f32, 1.0_f32);
        for _ in 0..HALVINGS {
            let d = 0.5 * (above + below);
            if self.distance.lambda(d) > lambda { above = d } else { below = d }
        }
        let metres = self.near + below * (self.far - self.near);
        let coverage = size / (2.0 * TAN_HALF_FOV * metres);
        // NaN where both are nothing.
        Ok(if coverage < 1.0 { coverage.max(0.0) } else { 1.0 })
    }
}

impl PrunedModel {
    /// Levels for falling λ as the `MSFT_lod` of one GLB file, each a mesh of its own: for programs without
    /// shaders of ours. For separate files, write each [`mesh_at`](Self::mesh_at).
    ///
    /// A level is shown until the λ of the distance has fallen to that of the next one, so that it is never
    /// coarser than asked for; the last is shown to the end.
    ///
    /// # Errors
    /// [`LodError::Foliage`] when there are no λ or they do not fall; [`LodError::Parameter`] for
    /// a λ outside 0 to 1 or a bad `screen`; [`LodError::Mesh`] from the writer.
    ///
    /// # Complexity
    /// That of as many meshes.
    pub fn to_glb_levels(
        &self,
        lambdas: &[f32],
        screen: &Screen,
        options: &GlbOptions,
    ) -> Result<Vec<u8>> {
        screen.validate()?;
        if lambdas.is_empty() || lambdas.windows(2).any(|pair| pair[0] <= pair[1]) {
            return Err(LodError::Foliage("levels must be there, the finest first: λ falls"));
        }
        let meshes = lambdas.iter().map(|&l| self.mesh_at(l)).collect::<Result<Vec<Mesh>>>()?;
        let size = 2.0 * self.mesh.bounding_sphere().map_or(0.0, |(_, radius)| radius);
        let mut levels = Vec::with_capacity(meshes.len());
        for (i, mesh) in meshes.iter().enumerate() {
            let coverage = match lambdas.get(i + 1) {
                Some(&next) => screen.coverage(next, size)?,
                None => 0.0,
            };
            levels.push(gltf::Level { coverage, ..mesh.into() });
        }
        Ok(gltf::to_glb_levels(&levels, options)?)
    }

    /// The model itself as a GLB file, for engines that draw windows: foliage with all tiers in its index
    /// buffers and `_TREE_CENTER`, 4 floats a vertex ([`Part::centers`](super::Part::centers)). The levels
    /// go beside it, as [`to_json`](Self::to_json). Programs that draw all of it draw leaves several times.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for [`GlbOptions::quantize`]: the shader needs positions in metres;
    /// [`LodError::Mesh`] from the writer.
    ///
    /// # Complexity
    /// O(vertices + indices + pixels).
    pub fn to_glb(&self, options: &GlbOptions) -> Result<Vec<u8>> {
        check_range("quantize", u8::from(options.quantize).into(), 0.0, 0.0)?;
        let attributes: Vec<_> = self
            .parts
            .iter()
            .map(|part| Attribute {
                surface: part.surface as usize,
                name: "_TREE_CENTER".into(),
                components: 4,
                values: part.centers.as_flattened().to_vec(),
            })
            .collect();
        let level = gltf::Level { attributes: &attributes, ..(&self.mesh).into() };
        Ok(gltf::to_glb_levels(&[level], options)?)
    }
}
