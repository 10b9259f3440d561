//! Multiresolution meshes in glTF 2.0.

use super::mesh::MultiMesh;
use crate::error::{LodError, Result, check_range};
use std::path::Path;
use tree_mesh::io::gltf::{self, Attribute, GlbOptions};

impl MultiMesh {
    /// The mesh with all its levels as a GLB file, for engines that draw prefixes: `_TREE_BRANCH`, 4 floats a
    /// vertex ([`branches`](Self::branches)), is what lets branches grow in. Other programs show the whole
    /// tree.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for [`GlbOptions::quantize`]: the shader needs positions in metres;
    /// [`LodError::Mesh`] from the writer.
    ///
    /// # Complexity
    /// O(vertices + indices + pixels).
    pub fn to_glb(&self, options: &GlbOptions) -> Result<Vec<u8>> {
        self.with_branches(options, |levels| Ok(gltf::to_glb_levels(levels, options)?))
    }

    /// [`to_glb`](Self::to_glb) into a file, whole or not at all.
    ///
    /// # Errors
    /// The same, and those of the file system.
    ///
    /// # Complexity
    /// The same.
    pub fn write_glb(&self, path: &Path, options: &GlbOptions) -> Result<()> {
        self.with_branches(options, |levels| Ok(gltf::write_glb_levels(levels, path, options)?))
    }

    fn with_branches<R>(
        &self,
        options: &GlbOptions,
        write: impl FnOnce(&[gltf::Level<'_>]) -> Result<R>,
    ) -> Result<R> {
        check_range("quantize", u8::from(options.quantize).into(), 0.0, 0.0)?;
        let attribute = |(surface, values): (usize, &Vec<[f32; 4]>)| Attribute {
            surface,
            name: "_TREE_BRANCH".into(),
            components: 4,
            values: values.as_flattened().to_vec(),
        };
        let attributes: Vec<_> = self.branches().iter().enumerate().map(attribute).collect();
        let level = gltf::Level { attributes: &attributes, ..self.mesh().into() };
        write(&[level])
    }

    /// Levels as the `MSFT_lod` of one GLB file, each a mesh of its own: for programs without shaders of ours.
    /// `levels` are falling fractional levels, each with the share of the screen's height, 0 to 1, from which on
    /// it is shown.
    ///
    /// # Errors
    /// [`LodError::Order`] when there are no levels, or levels or shares do not fall; [`LodError::Mesh`]
    /// from the writer.
    ///
    /// # Complexity
    /// That of as many meshes.
    pub fn to_glb_levels(&self, levels: &[(f32, f32)], options: &GlbOptions) -> Result<Vec<u8>> {
        self.parts(levels, |levels| Ok(gltf::to_glb_levels(levels, options)?))
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
        levels: &[(f32, f32)],
        path: &Path,
        options: &GlbOptions,
    ) -> Result<()> {
        self.parts(levels, |levels| Ok(gltf::write_glb_levels(levels, path, options)?))
    }

    fn parts<R>(
        &self,
        levels: &[(f32, f32)],
        write: impl FnOnce(&[gltf::Level<'_>]) -> Result<R>,
    ) -> Result<R> {
        let falls = |pair: &[(f32, f32)]| pair[0].0 > pair[1].0 && pair[0].1 > pair[1].1;
        if levels.is_empty() || !levels.windows(2).all(falls) {
            let problem = "levels and shares of the screen must be there, and fall";
            return Err(LodError::Order { row: 0, problem });
        }
        let meshes =
            levels.iter().map(|&(level, _)| self.mesh_at(level)).collect::<Result<Vec<_>>>()?;
        let level = |(mesh, &(_, coverage))| gltf::Level { coverage, ..gltf::Level::from(mesh) };
        let levels: Vec<_> = meshes.iter().zip(levels).map(level).collect();
        write(&levels)
    }
}
