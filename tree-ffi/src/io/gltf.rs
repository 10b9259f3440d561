//! glTF files, written.

use super::{GltfLevels, tree_bytes, tree_gltf_level};
use crate::border::{
    self, Failure, Result, Versioned, call, get, init, out, read_or_default, tree_status, tree_str,
};
use crate::control::{run, tree_control};
use crate::mesh::{ask_for_copies, tree_mesh};
use ::tree_mesh::io::gltf::{self, GlbOptions, OcclusionAs};
use std::ffi::c_char;

/// What becomes of ambient occlusion in a glTF file: one of the `TREE_GLTF_OCCLUSION_` constants.
pub type tree_gltf_occlusion = u32;

/// As the attribute `_OCCLUSION`, which only shaders that know it use.
pub const TREE_GLTF_OCCLUSION_ATTRIBUTE: u32 = 0;
/// As grey vertex colours (`COLOR_0`, 8 bits), which every program multiplies with the base colour:
/// visible everywhere, but direct light is darkened too.
pub const TREE_GLTF_OCCLUSION_COLOR: u32 = 1;
/// Not at all.
pub const TREE_GLTF_OCCLUSION_OMIT: u32 = 2;

fn occlusion(found: tree_gltf_occlusion, name: &str) -> Result<OcclusionAs> {
    match found {
        TREE_GLTF_OCCLUSION_ATTRIBUTE => Ok(OcclusionAs::Attribute),
        TREE_GLTF_OCCLUSION_COLOR => Ok(OcclusionAs::Color),
        TREE_GLTF_OCCLUSION_OMIT => Ok(OcclusionAs::Omit),
        other => Err(Failure::not_one_of(name, other, "TREE_GLTF_OCCLUSION_")),
    }
}

fn occlusion_number(occlusion: OcclusionAs) -> tree_gltf_occlusion {
    match occlusion {
        OcclusionAs::Attribute => TREE_GLTF_OCCLUSION_ATTRIBUTE,
        OcclusionAs::Color => TREE_GLTF_OCCLUSION_COLOR,
        OcclusionAs::Omit => TREE_GLTF_OCCLUSION_OMIT,
    }
}

/// How a glTF file is written. Begin with `tree_glb_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_glb_options {
    /// `sizeof(tree_glb_options)`.
    pub struct_size: usize,
    /// Name of the node and the mesh, for people and engines. Default (`data` is NULL): `tree`.
    pub name: tree_str,
    /// Whether vertices are written in 8 and 16 bits (`KHR_mesh_quantization`), which more than halves
    /// them. Largest errors: positions the longest side of the bounds / 131,070 on each axis (0.1 mm
    /// for a tree of 13 m); normals and tangents 1/254 on each axis before they are brought to unit
    /// length (0.4 degrees); texture coordinates the range in use / 131,070; occlusion stays exact.
    /// Default 0.
    pub quantize: u32,
    /// Whether translucency is written, as `KHR_materials_diffuse_transmission`; programs that do not
    /// know it pass over it. Default 0: the Khronos validator accepts it, but remarks that it cannot
    /// look into it.
    pub translucency: u32,
    /// What becomes of ambient occlusion. Default `TREE_GLTF_OCCLUSION_ATTRIBUTE`.
    pub occlusion: tree_gltf_occlusion,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_glb_options {
    const NAME: &'static str = "tree_glb_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = GlbOptions::default();
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            quantize: default.quantize.into(),
            translucency: default.translucency.into(),
            occlusion: occlusion_number(default.occlusion),
            reserved: 0,
        }
    }
}

impl tree_glb_options {
    pub(crate) unsafe fn rust(&self) -> Result<GlbOptions> {
        let default = GlbOptions::default();
        let name = unsafe { self.name.get("options.name") }?;
        Ok(GlbOptions {
            name: if self.name.data.is_null() { default.name } else { name.to_owned() },
            quantize: self.quantize != 0,
            translucency: self.translucency != 0,
            occlusion: occlusion(self.occlusion, "options.occlusion")?,
        })
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_glb_options_init(
    options: *mut tree_glb_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

pub(crate) unsafe fn read_options(options: *const tree_glb_options) -> Result<GlbOptions> {
    unsafe { read_or_default(options, "options")?.rust() }
}

/// Writes a mesh to a GLB file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends with
/// a NUL and `path_len` is `TREE_NUL_TERMINATED`. `options` and `control` may be NULL; of `control`
/// only threads and limits matter, and a cancellation before the work begins.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_write_glb(
    mesh: *const tree_mesh,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 3)?;
                Ok(gltf::write_glb(mesh, path, &options)?)
            })
        }
    })
}

/// A mesh as a GLB file in memory, as `tree_mesh_write_glb` writes it. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_to_glb(
    mesh: *const tree_mesh,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 3)?;
                Ok(gltf::to_glb(mesh, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// Writes meshes, instances and levels of detail to a GLB file, whole or not at all.
///
/// Several levels, the finest first, become the nodes of one `MSFT_lod` with their coverages; programs
/// that do not know it draw the finest. Materials that are equal in several levels are written once.
/// `options` and `control` may be NULL, as in `tree_mesh_write_glb`; of the limits, `leaves` caps the
/// copies and `triangles` those of the meshes that are drawn many times, all rows together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_write_glb(
    levels: *const tree_gltf_level,
    n_levels: usize,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let levels = unsafe { GltfLevels::read(levels, n_levels, control) }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                levels.with(control, |levels| Ok(gltf::write_glb_levels(levels, path, &options)?))
            })
        }
    })
}

/// As `tree_gltf_write_glb`, in memory. Free the bytes with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_to_glb(
    levels: *const tree_gltf_level,
    n_levels: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let levels = unsafe { GltfLevels::read(levels, n_levels, control) }?;
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                levels.with(control, |levels| Ok(gltf::to_glb_levels(levels, &options)?))
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_gltf_write_glb`, but in several files: the `.gltf` file of this path, and beside it the
/// buffer (`STEM.bin`) and the textures (`STEM_NAME.png`), all or none. Blanks and other trouble in the
/// stem are replaced by `_` in the names of the files beside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_write_files(
    levels: *const tree_gltf_level,
    n_levels: usize,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let levels = unsafe { GltfLevels::read(levels, n_levels, control) }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                levels.with(control, |levels| Ok(gltf::write_gltf(levels, path, &options)?))
            })
        }
    })
}
