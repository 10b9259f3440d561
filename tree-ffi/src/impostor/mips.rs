//! Smaller levels of a picture that is alpha-tested.

use super::map::show;
use crate::border::{
    Failure, Handle, TREE_ERROR_PARAMETER, call, free, get, out, out_value, tree_status,
};
use crate::control::{run, tree_control};
use crate::preview::{tree_picture, tree_pixels};
use tree_lod::impostor::texel::mips;
use tree_lod::preview::Picture;
use tree_model::tree_core::Resource;

/// A picture and its smaller levels, for a texture that is alpha-tested.
pub struct tree_mips(Vec<Picture>);

impl Handle for tree_mips {
    const NAME: &'static str = "tree_mips";
}

/// A picture and its smaller levels, each half as wide and high (rounded down, at least 1): at most `most` in all, and at
/// least the picture itself. Colours are means in linear light, weighted by alpha. Alpha is the mean, scaled so
/// that the share of texels that pass a test against one half stays as in the first level: leaves do not vanish from
/// afar. It is for colours, not for `TREE_IMPOSTOR_DETAIL`. `control` may be NULL; `pixels` of its limits caps twice
/// those of the picture. Free the levels with `tree_mips_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mips_of_picture(
    picture: *const tree_picture,
    most: usize,
    control: *const tree_control,
    mips: *mut *mut tree_mips,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mips, "mips") }?;
        let picture = unsafe { get(picture, "picture") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                let pixels = picture.pixels.len() as u64 / 4;
                control.limits.check(Resource::Pixels, 2 * pixels)?;
                Ok(self::mips(picture, most)?)
            })
        }?;
        place.put(tree_mips(made));
        Ok(())
    })
}

/// Number of levels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mips_count(
    mips: *const tree_mips,
    n_levels: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(mips, "mips") }?.0.len();
        unsafe { out_value(n_levels, found, "n_levels") }
    })
}

/// Views the pixels of level `number`; 0 is the picture itself. Set `pixels->struct_size` first.
/// `TREE_ERROR_PARAMETER` when there is no such level.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mips_view(
    mips: *const tree_mips,
    number: usize,
    pixels: *mut tree_pixels,
) -> tree_status {
    call(|| {
        let levels = &unsafe { get(mips, "mips") }?.0;
        let Some(found) = levels.get(number) else {
            let text = format!("number is {number}, but there are {} levels", levels.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { show(found, pixels) }
    })
}

/// Frees levels, and with them all views of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mips_free(mips: *mut tree_mips) -> tree_status {
    call(|| unsafe { free(mips, "mips") })
}
