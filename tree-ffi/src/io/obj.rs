//! OBJ files, written.

use super::tree_bytes;
use crate::border::{self, call, get, out2, text, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::{ask_for_copies, tree_mesh};
use ::tree_mesh::io::obj;
use std::ffi::c_char;

/// Writes a mesh to an OBJ file (the path is as in `tree_mesh_write_glb`) and beside it the MTL file (`STEM.mtl`) and the textures
/// (`STEM_NAME.png`), all or none. Blanks and other trouble in the stem are replaced by `_` in the names
/// of the files beside. Tangents and the other optional columns have no place in OBJ. `control` may be
/// NULL; only a cancellation before the work begins matters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_write_obj(
    mesh: *const tree_mesh,
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let path = unsafe { border::path(path, path_len, "path") }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 5)?;
                Ok(obj::write_obj(mesh, path)?)
            })
        }
    })
}

/// The OBJ and MTL files that `tree_mesh_write_obj` would write to `stem.obj` and `stem.mtl`, in memory.
/// Free both with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_to_obj(
    mesh: *const tree_mesh,
    stem: *const c_char,
    stem_len: usize,
    control: *const tree_control,
    obj: *mut *mut tree_bytes,
    mtl: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let (obj_place, mtl_place) = unsafe { out2((obj, "obj"), (mtl, "mtl")) }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let stem = unsafe { text(stem, stem_len, "stem") }?;
        let (obj, mtl) = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 5)?;
                Ok(obj::to_strings(mesh, stem)?)
            })
        }?;
        obj_place.put(tree_bytes::new(obj.into_bytes()));
        mtl_place.put(tree_bytes::new(mtl.into_bytes()));
        Ok(())
    })
}
