//! Hybrid models as levels of glTF 2.0.

use super::make::Hybrid;
use crate::error::{LodError, Result, check_range};
use std::path::Path;
use tree_mesh::Mesh;
use tree_mesh::io::gltf::{self, GlbOptions};

impl Hybrid {
    /// Levels as the `MSFT_lod` of one GLB file, each a mesh of its own. `heights` are heights of the tree on the
    /// screen in pixels, falling: each level is made for its height, and shown until the tree is as high as the
    /// next one says; the last is shown to the end. `screen` is the height of the screen, 1 to 10⁵.
    ///
    /// # Errors
    /// [`LodError::Order`] when there are no heights or they do not fall; [`LodError::Parameter`] for numbers out
    /// of range; [`LodError::Mesh`] from the writer.
    ///
    /// # Complexity
    /// That of as many meshes.
    pub fn to_glb_levels(
        &self,
        heights: &[f32],
        screen: f32,
        options: &GlbOptions,
    ) -> Result<Vec<u8>> {
        self.levels(heights, screen, |levels| Ok(gltf::to_glb_levels(levels, options)?))
    }

    /// [`to_glb_levels`](Self::to_glb_levels) into a file, whole or not at all.
    ///
    /// # Errors
    /// The same, and those of the file system.
    ///
    /// # Complexity
    /// The same.
    pub fn write_glb_levels(
        &self,
        heights: &[f32],
        screen: f32,
        path: &Path,
        options: &GlbOptions,
    ) -> Result<()> {
        let write = |levels: &[gltf::Level<'_>]| Ok(gltf::write_glb_levels(levels, path, options)?);
        self.levels(heights, screen, write)
    }

    fn levels<R>(
        &self,
        heights: &[f32],
        screen: f32,
        write: impl FnOnce(&[gltf::Level<'_>]) -> Result<R>,
    ) -> Result<R> {
        check_range("screen", screen.into(), 1.0, 1e5)?;
        if heights.is_empty() || !heights.windows(2).all(|pair| pair[0] > pair[1]) {
            return Err(LodError::Order { row: 0, problem: "heights must be there, and fall" });
        }
        let mesh = |&height: &f32| self.mesh_of(&self.choice_for_height(height)?);
        let meshes = heights.iter().map(mesh).collect::<Result<Vec<Mesh>>>()?;
        let level = |(i, mesh)| {
            let coverage = heights.get(i + 1).map_or(0.0, |next: &f32| (next / screen).min(1.0));
            gltf::Level { coverage, ..gltf::Level::from(mesh) }
        };
        let levels: Vec<_> = meshes.iter().enumerate().map(level).collect();
        write(&levels)
    }
}
