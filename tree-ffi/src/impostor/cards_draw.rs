//! Cards as meshes, files, pictures and shaders.

use super::cards::tree_cards;
use crate::border::{self, Failure, Result, call, get, out, out_value, tree_status, tree_str};
use crate::control::{run, tree_control};
use crate::io::{read_options, tree_bytes, tree_glb_options};
use crate::lod::take::few;
use crate::lod::{TREE_SHADER_GLSL, TREE_SHADER_HLSL, TREE_SHADER_WGSL, tree_shader};
use crate::mesh::tree_mesh;
use crate::preview::{tree_picture, tree_view};
use std::ffi::c_char;
use tree_lod::impostor::cards::{Cards, GLSL, HLSL, PLANES, WGSL};
use tree_model::tree_core::{Control, Resource};

/// More boxes than are sensible in one call.
const BOXES_MAX: usize = 1 << 16;

/// Looks at the control before work that cannot be stopped: two triangles for each plane, and a copy of the atlas.
fn foreseen(cards: &Cards, boxes: &[u32], control: &Control) -> Result<()> {
    control.check()?;
    control.limits.check(Resource::Triangles, 2 * (PLANES * boxes.len()) as u64)?;
    Ok(control.limits.check(Resource::Pixels, cards.color.pixels.len() as u64 / 4)?)
}

/// The planes of `n_boxes` boxes as a mesh, six squares of four vertices each, with the atlas as their texture: alpha is
/// tested against one half, both sides are drawn. Without the shader (`tree_cards_shader`) all six planes of a box are
/// drawn at once, which covers more than the leaves do. At most 65,536 boxes; `control` may be NULL. Free the mesh with
/// `tree_mesh_free`. `TREE_ERROR_INVALID` when there is no such box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_mesh(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let made = unsafe {
            run(control, |control| {
                foreseen(cards, boxes, control)?;
                Ok(cards.mesh(boxes)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// The planes of `n_boxes` boxes for programs without the shader: of each box those that together look best from around and a
/// little above, both sides as squares of their own, lit (`tree_cards_lit`) and with the normals of a rounded crown. As
/// `tree_cards_mesh` in all else.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_plain(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let made = unsafe {
            run(control, |control| {
                foreseen(cards, boxes, control)?;
                Ok(cards.plain(boxes)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// As `tree_cards_mesh`, of some planes of each box only: `n_planes` numbers, 0 to 5, as `tree_leaf_boxes_planes` counts
/// them, at most six. For programs without the shader: 0, 2 and 4, one for each axis, cover about as much as the leaves
/// do. `TREE_ERROR_INVALID` when there is no such box or plane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_mesh_of_planes(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    planes: *const u32,
    n_planes: usize,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let planes = unsafe { few(planes, n_planes, PLANES, "planes") }?;
        let planes: Vec<_> = planes.iter().map(|&plane| plane as usize).collect();
        let made = unsafe {
            run(control, |control| {
                foreseen(cards, boxes, control)?;
                Ok(cards.mesh_of_planes(boxes, &planes)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// What a camera sees of `n_boxes` boxes, at most 65,536, by one sample for each pixel: sRGB colour without light, alpha
/// 0 or 255. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
/// (`tree_view_place` helps). `control` may be NULL. Free the picture with `tree_picture_free`.
///
/// `TREE_ERROR_INVALID` for a framed camera, a box that does not exist, or an eye in the middle of a box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_view(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    view: *const tree_view,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let view = unsafe { tree_view::read(view) }?;
        let size = [view.width, view.height];
        let body = |control: &_| Ok(cards.view(boxes, &view.camera, size, control)?);
        place.put(tree_picture::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The planes of `n_boxes` boxes as a GLB file in memory: as `tree_cards_mesh`, and what the shader needs, four floats for
/// each vertex: `_TREE_CENTER` (middle of the box in metres, number of the plane), `_TREE_HALF` (half its sides in
/// metres, its number) and `_TREE_TURN` (the quaternion that turns its axes into those of the tree). `options` and
/// `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
/// `quantize`: shaders need positions in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_to_glb(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                foreseen(cards, boxes, control)?;
                Ok(cards.to_glb(boxes, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_cards_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_write_glb(
    cards: *const tree_cards,
    boxes: *const u32,
    n_boxes: usize,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let cards = unsafe { get(cards, "cards") }?.rust();
        let boxes = unsafe { few(boxes, n_boxes, BOXES_MAX, "boxes") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                foreseen(cards, boxes, control)?;
                Ok(cards.write_glb(boxes, path, &options)?)
            })
        }
    })
}

/// The functions that weigh planes in a shader, as `tree_card_weights` does it: text to be put into your own. It tells what
/// they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_shader(
    language: tree_shader,
    text: *mut tree_str,
) -> tree_status {
    call(|| {
        let found = match language {
            TREE_SHADER_WGSL => WGSL,
            TREE_SHADER_GLSL => GLSL,
            TREE_SHADER_HLSL => HLSL,
            other => return Err(Failure::not_one_of("language", other, "TREE_SHADER_")),
        };
        unsafe { out_value(text, tree_str::of(found), "text") }
    })
}
