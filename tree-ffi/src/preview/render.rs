//! Pictures, masks and silhouettes, drawn.

use super::{tree_mask, tree_picture, tree_style, tree_view};
use crate::border::{call, get, out, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::tree_mesh;
use tree_lod::preview;

/// Draws a picture of a mesh. `view`, `style` and `control` may be NULL. Back faces are drawn too, with
/// their normals turned over; an empty mesh gives the ground alone. Progress is told in the stages
/// `textures`, `light` and `picture`. The same mesh and parameters give the same bytes on every platform
/// and for any number of threads. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_render(
    mesh: *const tree_mesh,
    view: *const tree_view,
    style: *const tree_style,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let view = unsafe { tree_view::read(view) }?;
        let style = unsafe { tree_style::read(style) }?;
        let made =
            unsafe { run(control, |control| Ok(preview::render(mesh, &view, &style, control)?)) }?;
        place.put(tree_picture::new(made));
        Ok(())
    })
}

/// The share of each pixel that a mesh covers, by samples. There is no ground. `view` and `control` may
/// be NULL. Free the mask with `tree_mask_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_render_mask(
    mesh: *const tree_mesh,
    view: *const tree_view,
    control: *const tree_control,
    mask: *mut *mut tree_mask,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mask, "mask") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let view = unsafe { tree_view::read(view) }?;
        let made = unsafe { run(control, |control| Ok(preview::mask(mesh, &view, control)?)) }?;
        place.put(tree_mask::new(made));
        Ok(())
    })
}

/// The mask of a mesh in black on white. `view` and `control` may be NULL. Free the picture with
/// `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_render_silhouette(
    mesh: *const tree_mesh,
    view: *const tree_view,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let view = unsafe { tree_view::read(view) }?;
        let made =
            unsafe { run(control, |control| Ok(preview::silhouette(mesh, &view, control)?)) }?;
        place.put(tree_picture::new(made));
        Ok(())
    })
}
