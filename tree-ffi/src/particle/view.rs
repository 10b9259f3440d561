//! Views: mattes with cameras, as arrays of structs.

use crate::border::{Result, Versioned, call, get, get_opt, init, read, read_rows, tree_status};
use crate::photo::{tree_matte, tree_particle_camera, tree_photo};
use tree_model::particle::View;

/// Most views of one tree.
pub(super) const VIEWS_MAX: usize = 1000;

/// One photograph, ready to be used: what it shows of the tree and where it was taken from. Begin with
/// `tree_particle_view_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_particle_view {
    /// `sizeof(tree_particle_view)`.
    pub struct_size: usize,
    /// How much of each pixel the tree covers. No default: NULL, which is refused.
    pub matte: *const tree_matte,
    /// The photograph itself, of the same size; may be NULL.
    pub photo: *const tree_photo,
    /// Where it was taken from; its `size` is that of the matte. No default: NULL, which is refused.
    pub camera: *const tree_particle_camera,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_particle_view {
    const NAME: &'static str = "tree_particle_view";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            matte: std::ptr::null(),
            photo: std::ptr::null(),
            camera: std::ptr::null(),
        }
    }
}

/// Makes `view`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_view_init(
    view: *mut tree_particle_view,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(view, size) })
}

/// Copies of the views of an array.
pub(super) unsafe fn views(first: *const tree_particle_view, n: usize) -> Result<Vec<View>> {
    let rows = unsafe { read_rows(first, n, VIEWS_MAX, "views") }?;
    let view = |(i, row): (usize, &tree_particle_view)| {
        let part = |field: &str| format!("views[{i}].{field}");
        let photo = unsafe { get_opt(row.photo, &part("photo")) }?;
        let camera = unsafe { read(row.camera, &part("camera")) }?.rust();
        camera.validate(&part("camera"))?;
        Ok(View {
            matte: unsafe { get(row.matte, &part("matte")) }?.rust().clone(),
            photo: photo.map(|photo| photo.rust().clone()),
            camera,
        })
    };
    rows.iter().enumerate().map(view).collect()
}
