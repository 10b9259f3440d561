//! glTF 2.0, written as the Khronos validator accepts it without error or warning, and read back.
//!
//! **Written**: one primitive per surface with triangles, each column a buffer view of its own, indices
//! as 16 bits where they suffice; textures as PNG, each once, however many materials share it.
//! Materials no primitive uses are left out. Tangents become `TANGENT`, the second texture coordinates
//! `TEXCOORD_1`, occlusion what [`OcclusionAs`] says; a caller's own columns go in as [`Attribute`]s.
//! Branches, welds and anchors are not written. Options: smaller files ([`GlbOptions::quantize`]),
//! leaves as [`Instances`], several [`Level`]s of detail, `.gltf` with files beside it
//! ([`write_gltf`]), a mesh that moves ([`Motion`]).
//!
//! **Read**: [`read`] and [`from_slice`] take what other programs write as well; see there.
//!
//! Sources: Khronos Group, *glTF 2.0 Specification*, 2021; the extensions `KHR_mesh_quantization`,
//! `KHR_texture_transform`, `KHR_materials_diffuse_transmission`, `EXT_mesh_gpu_instancing` and
//! `MSFT_lod` as registered with it.

mod accessor;
mod buffer;
mod container;
mod document;
mod image;
mod instance;
mod look;
mod material;
mod motion;
mod primitive;
mod quantize;
mod read;
mod scene;
mod write;

pub use instance::{Instanced, Instances, instanced};
pub use motion::{JointPose, Motion, to_glb_moving, write_glb_moving};
pub use read::{from_slice, read};

use crate::error::{MeshError, Result};
use crate::io::names::safe;
use crate::mesh::Mesh;
use std::path::{Path, PathBuf};
use tree_core::{CoreError, file};

/// What goes into a glTF file besides the mesh, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GlbOptions {
    /// Name of the node and the mesh, for people and engines. Default `tree`.
    pub name: String,
    /// Whether vertices are written in 8 and 16 bits (`KHR_mesh_quantization`), which more than halves
    /// them. Largest errors: positions the longest side of the bounds / 131,070 on each axis (0.1 mm
    /// for a tree of 13 m); normals and tangents 1/254 on each axis before they are brought to unit
    /// length (0.4°); texture coordinates the range in use / 131,070; occlusion stays exact. Texture
    /// coordinates beyond 0 to 1 need `KHR_texture_transform` and a material of their own; a surface
    /// without a texture keeps them as they are. Default `false`.
    pub quantize: bool,
    /// Whether translucency is written, as `KHR_materials_diffuse_transmission`; programs that do not
    /// know it pass over it. Default `false`: the Khronos validator (2.0.0-dev.3.10) accepts it, but
    /// remarks that it cannot look into it.
    pub translucency: bool,
    /// What becomes of ambient occlusion. Default [`OcclusionAs::Attribute`].
    pub occlusion: OcclusionAs,
}

impl Default for GlbOptions {
    fn default() -> Self {
        Self {
            name: "tree".into(),
            quantize: false,
            translucency: false,
            occlusion: OcclusionAs::default(),
        }
    }
}

/// How ambient occlusion per vertex is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OcclusionAs {
    /// As the attribute `_OCCLUSION`, which only shaders that know it use.
    #[default]
    Attribute,
    /// As grey vertex colours (`COLOR_0`, 8 bits), which every program multiplies with the base
    /// colour: visible everywhere, but direct light is darkened too.
    Color,
    /// Not at all.
    Omit,
}

/// A column of the caller's own, for one surface of a mesh.
///
/// Blender 5.0.1 mixes up attributes of one mesh whose names begin with `_` when they differ in their
/// number of components, and then now and then refuses the file: give all the same number there, and
/// write occlusion in another way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attribute {
    /// Number of the surface in [`Mesh::surfaces`].
    pub surface: usize,
    /// Name in the file: `_` and then capital letters, digits and `_`, at most 64 in all.
    pub name: String,
    /// Numbers per vertex, 1 to 4.
    pub components: usize,
    /// `components` finite numbers for each vertex.
    pub values: Vec<f32>,
}

/// One level of detail of a file, or all of it.
#[derive(Clone, Copy, Debug)]
pub struct Level<'a> {
    /// What is drawn once. May be empty when there are instances.
    pub mesh: &'a Mesh,
    /// What is drawn many times.
    pub instances: &'a [Instances],
    /// More columns for the surfaces of `mesh`.
    pub attributes: &'a [Attribute],
    /// Share of the screen's height (0 to 1) from which this level is drawn, the finest first. Not
    /// used when there is one level.
    pub coverage: f32,
}

impl<'a> From<&'a Mesh> for Level<'a> {
    fn from(mesh: &'a Mesh) -> Self {
        Self { mesh, instances: &[], attributes: &[], coverage: 0.0 }
    }
}

/// Writes a mesh to a GLB file, whole or not at all.
///
/// # Errors
/// As [`to_glb`], and [`MeshError::Core`] when the file cannot be written.
pub fn write_glb(mesh: &Mesh, path: impl AsRef<Path>, options: &GlbOptions) -> Result<()> {
    write_glb_levels(&[mesh.into()], path, options)
}

/// A mesh as the bytes of a GLB file.
///
/// # Errors
/// As [`to_glb_levels`].
pub fn to_glb(mesh: &Mesh, options: &GlbOptions) -> Result<Vec<u8>> {
    to_glb_levels(&[mesh.into()], options)
}

/// Writes meshes, instances and levels of detail to a GLB file, whole or not at all.
///
/// # Errors
/// As [`to_glb_levels`], and [`MeshError::Core`] when the file cannot be written.
pub fn write_glb_levels(
    levels: &[Level<'_>],
    path: impl AsRef<Path>,
    options: &GlbOptions,
) -> Result<()> {
    let (path, bytes) = (path.as_ref(), to_glb_levels(levels, options)?);
    file::write_atomic(path, |out| {
        out.write_all(&bytes).map_err(|error| CoreError::io(path, error).into())
    })
}

/// Meshes, instances and levels of detail as the bytes of a GLB file.
///
/// Several levels become the nodes of one `MSFT_lod`, finest first, with the coverages in
/// `MSFT_screencoverage`; programs that do not know it draw the finest. Materials that are equal in
/// several levels are written once.
///
/// # Errors
/// [`MeshError::NoTriangles`] for a level without any, what [`Mesh::check`], [`Mesh::check_normals`]
/// and [`Mesh::check_colors`] find, [`MeshError::Attribute`], [`MeshError::Instances`],
/// [`MeshError::Image`] when a texture cannot be encoded, [`MeshError::Gltf`] when the file would be
/// larger than 4 GiB.
///
/// # Complexity
/// O(vertices + triangles + pixels); textures are encoded in parallel.
pub fn to_glb_levels(levels: &[Level<'_>], options: &GlbOptions) -> Result<Vec<u8>> {
    let pack = write::pack(levels, options, None)?;
    container::join(&pack.json, &pack.binary)
}

/// Writes meshes, instances and levels of detail to a `.gltf` file and beside it the buffer
/// (`STEM.bin`) and the textures (`STEM_NAME.png`), all or none. Blanks and other trouble in the stem
/// are replaced by `_` in the names of the files beside.
///
/// # Errors
/// As [`to_glb_levels`], and [`MeshError::Core`] with the path that could not be written; no file is
/// left behind or changed then.
pub fn write_gltf(
    levels: &[Level<'_>],
    path: impl AsRef<Path>,
    options: &GlbOptions,
) -> Result<()> {
    let path = path.as_ref();
    let Some(stem) = path.file_stem() else {
        let error = std::io::Error::new(std::io::ErrorKind::InvalidInput, "not the name of a file");
        return Err(CoreError::io(path, error).into());
    };
    let stem = safe(&stem.to_string_lossy(), "tree");
    let pack = write::pack(levels, options, Some(&stem))?;
    let mut files: Vec<(PathBuf, &[u8])> = Vec::new();
    for (name, png) in &pack.pictures {
        files.push((path.with_file_name(name), png));
    }
    files.push((path.with_file_name(format!("{stem}.bin")), &pack.binary));
    files.push((path.to_path_buf(), &pack.json));
    let mut parts: Vec<file::Part<'_, MeshError>> = Vec::new();
    for (path, bytes) in &files {
        parts.push((
            path,
            Some(Box::new(move |out| {
                out.write_all(bytes).map_err(|error| CoreError::io(path, error).into())
            })),
        ));
    }
    file::write_all_atomic(&mut parts)
}

#[cfg(test)]
#[path = "write_tests.rs"]
mod write_tests;

#[cfg(test)]
#[path = "read_tests.rs"]
mod read_tests;

#[cfg(test)]
#[path = "hostile_tests.rs"]
mod hostile_tests;
