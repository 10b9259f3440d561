//! Multiresolution meshes in glTF 2.0.

use super::mesh::MultiMesh;
use crate::error::{LodError, Result, check_range};
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
        check_range("quantize", u8::from(options.quantize).into(), 0.0, 0.0)?;
        let attribute = |(surface, values): (usize, &Vec<[f32; 4]>)| Attribute {
            surface,
            name: "_TREE_BRANCH".into(),
            components: 4,
            values: values.as_flattened().to_vec(),
        };
        let attributes: Vec<_> = self.branches().iter().enumerate().map(attribute).collect();
        let level = gltf::Level { attributes: &attributes, ..self.mesh().into() };
        Ok(gltf::to_glb_levels(&[level], options)?)
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
        let falls = |pair: &[(f32, f32)]| pair[0].0 > pair[1].0 && pair[0].1 > pair[1].1;
        if levels.is_empty() || !levels.windows(2).all(falls) {
            let problem = "levels and shares of the screen must be there, and fall";
            return Err(LodError::Order { row: 0, problem });
        }
        let meshes =
            levels.iter().map(|&(level, _)| self.mesh_at(level)).collect::<Result<Vec<_>>>()?;
        let level = |(mesh, &(_, coverage))| gltf::Level { coverage, ..gltf::Level::from(mesh) };
        let levels: Vec<_> = meshes.iter().zip(levels).map(level).collect();
        Ok(gltf::to_glb_levels(&levels, options)?)
    }
}
