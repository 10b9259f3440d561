//! Which of the two pictures of an impostor is meant, and how it is handed out.

use crate::border::{Failure, Result, write};
use crate::control::{run, tree_control};
use crate::preview::{tree_picture, tree_pixels};
use tree_lod::preview::Picture;
use tree_model::tree_core::Resource;

/// One of the two pictures of an impostor: one of the `TREE_IMPOSTOR_` constants.
pub type tree_impostor_map = u32;

/// sRGB colour of the surface without light, and alpha: the covered share of each texel.
pub const TREE_IMPOSTOR_COLOR: u32 = 0;
/// Normal in the space of the tree, -1 to 1 as 0 to 255, and in alpha the depth. These are numbers, not colours: upload
/// them without sRGB.
pub const TREE_IMPOSTOR_DETAIL: u32 = 1;

/// One of the two.
pub(super) fn chosen<'a>(
    map: tree_impostor_map,
    color: &'a Picture,
    detail: &'a Picture,
) -> Result<&'a Picture> {
    match map {
        TREE_IMPOSTOR_COLOR => Ok(color),
        TREE_IMPOSTOR_DETAIL => Ok(detail),
        other => Err(Failure::not_one_of("map", other, "TREE_IMPOSTOR_")),
    }
}

/// A view of a picture's pixels.
///
/// # Safety
/// As [`write`].
pub(super) unsafe fn show(picture: &Picture, pixels: *mut tree_pixels) -> Result<()> {
    unsafe { write(pixels, "pixels", &tree_pixels::of(picture)) }
}

/// A copy of a picture, as an object.
///
/// # Safety
/// As [`run`].
pub(super) unsafe fn copied(
    picture: &Picture,
    control: *const tree_control,
) -> Result<tree_picture> {
    unsafe {
        run(control, |control| {
            control.check()?;
            control.limits.check(Resource::Pixels, picture.pixels.len() as u64 / 4)?;
            Ok(tree_picture::new(picture.clone()))
        })
    }
}
