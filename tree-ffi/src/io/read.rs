//! Meshes, read.

use super::tree_import_report;
use crate::border::{
    self, Failure, Result, TREE_ERROR_PARAMETER, Versioned, bytes, call, foresee, init, out,
    read_or_default, tree_status, view,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::tree_mesh;
use ::tree_mesh::io::{self, ImportOptions, Imported};
use std::ffi::c_char;
use tree_model::tree_core::Control;

/// Format of a file with a mesh in it: one of the `TREE_MESH_FORMAT_` constants.
pub type tree_mesh_format = u32;

/// As the file's extension says: `glb`, `gltf`, `obj` or `ply`, in letters of any case.
pub const TREE_MESH_FORMAT_BY_NAME: u32 = 0;
/// glTF 2.0, as one file (GLB) or as JSON.
pub const TREE_MESH_FORMAT_GLTF: u32 = 1;
/// OBJ.
pub const TREE_MESH_FORMAT_OBJ: u32 = 2;
/// PLY, text or binary.
pub const TREE_MESH_FORMAT_PLY: u32 = 3;

const FORMATS: &str = "TREE_MESH_FORMAT_";

/// How files are read. Begin with `tree_import_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_import_options {
    /// `sizeof(tree_import_options)`.
    pub struct_size: usize,
    /// Whether files that the file names (buffers, textures, MTL) are read. Only those within its own
    /// folder and below are: no absolute path, no `..`, no scheme, no link that leads out. Default 0:
    /// textures and materials are left out and noted, missing buffers are an error.
    pub external: u32,
    /// The file's format. Default `TREE_MESH_FORMAT_BY_NAME`.
    pub format: tree_mesh_format,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_import_options {
    const NAME: &'static str = "tree_import_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            external: ImportOptions::default().external.into(),
            format: TREE_MESH_FORMAT_BY_NAME,
        }
    }
}

impl tree_import_options {
    fn rust(&self) -> ImportOptions {
        ImportOptions { external: self.external != 0 }
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_import_options_init(
    options: *mut tree_import_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

/// Reads a mesh from a file; the path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
/// `TREE_NUL_TERMINATED`. It is checked before memory is taken for it, and never trusted; what was
/// left out or changed is in the report. `options`, `control` and `report` may be NULL. Free the mesh
/// with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_read(
    path: *const c_char,
    path_len: usize,
    options: *const tree_import_options,
    control: *const tree_control,
    report: *mut tree_import_report,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        unsafe { foresee(report, "report") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let given = unsafe { read_or_default(options, "options") }?;
        let options = given.rust();
        let imported = unsafe {
            run(control, |control| {
                Ok(match given.format {
                    TREE_MESH_FORMAT_BY_NAME => io::read(path, &options, control),
                    TREE_MESH_FORMAT_GLTF => io::gltf::read(path, &options, control),
                    TREE_MESH_FORMAT_OBJ => io::obj::read(path, &options, control),
                    TREE_MESH_FORMAT_PLY => io::ply::read(path, control),
                    other => return Err(Failure::not_one_of("options.format", other, FORMATS)),
                }?)
            })
        }?;
        unsafe { view(report, "report", &tree_import_report::of(&imported.report)) }?;
        place.put(tree_mesh::new(imported.mesh));
        Ok(())
    })
}

/// Reads a mesh from a file in memory; other files are never read. `format` must be stated. `mtl` is
/// for OBJ only: the MTL file, or NULL for materials with names only; textures are not read. The bytes
/// are needed during the call only. `control` and `report` may be NULL. Free the mesh with
/// `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_from_bytes(
    format: tree_mesh_format,
    data: *const u8,
    len: usize,
    mtl: *const u8,
    mtl_len: usize,
    control: *const tree_control,
    report: *mut tree_import_report,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        unsafe { foresee(report, "report") }?;
        let limits = unsafe { limits(control) }?;
        let data = unsafe { bytes(data, len, &limits, "data") }?;
        let mtl = if mtl.is_null() {
            None
        } else {
            Some(unsafe { bytes(mtl, mtl_len, &limits, "mtl") }?)
        };
        let imported = unsafe { run(control, |control| parse(format, data, mtl, control)) }?;
        unsafe { view(report, "report", &tree_import_report::of(&imported.report)) }?;
        place.put(tree_mesh::new(imported.mesh));
        Ok(())
    })
}

fn parse(
    format: tree_mesh_format,
    data: &[u8],
    mtl: Option<&[u8]>,
    control: &Control,
) -> Result<Imported> {
    if mtl.is_some() && matches!(format, TREE_MESH_FORMAT_GLTF | TREE_MESH_FORMAT_PLY) {
        let text = "mtl is for OBJ files only: NULL is needed";
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    Ok(match (format, mtl) {
        (TREE_MESH_FORMAT_GLTF, _) => io::gltf::from_slice(data, control),
        (TREE_MESH_FORMAT_OBJ, None) => io::obj::from_slice(data, control),
        (TREE_MESH_FORMAT_OBJ, Some(mtl)) => io::obj::from_slices(data, mtl, control),
        (TREE_MESH_FORMAT_PLY, _) => io::ply::from_slice(data, control),
        (other, _) => return Err(Failure::not_one_of("format", other, FORMATS)),
    }?)
}
