//! Simple drawing onto photographs, for pictures of what a stage did.

use super::matte::tree_matte;
use super::picture::tree_photo;
use crate::border::{Failure, Result, call, get, out, slice, tree_status};
use crate::control::{limits, run, tree_control};
use bytemuck::AnyBitPattern;
use glam::Vec2;
use tree_model::particle::draw::Canvas;
use tree_model::tree_core::Resource;

/// What is drawn: one of the `TREE_MARK_` constants.
pub type tree_mark_kind = u32;

/// A line with round ends.
pub const TREE_MARK_LINE: u32 = 0;
/// A line with a head at `to`.
pub const TREE_MARK_ARROW: u32 = 1;
/// A disc round `from`; `to` is not looked at.
pub const TREE_MARK_DOT: u32 = 2;
/// The pixels whose corners lie from `from` up to `to`; `width` is not looked at.
pub const TREE_MARK_FILL: u32 = 3;

/// Something drawn onto a photograph. Coordinates are pixels from the top left; what lies outside is cut
/// off, and what is not finite is left out.
#[repr(C)]
#[derive(Clone, Copy, Debug, AnyBitPattern)]
pub struct tree_mark {
    /// What it is.
    pub kind: tree_mark_kind,
    /// Where it begins.
    pub from: [f32; 2],
    /// Where it ends.
    pub to: [f32; 2],
    /// Width of a line, or a dot's diameter, in pixels.
    pub width: f32,
    /// Its colour, as `0xRRGGBBAA`: red, green, blue (sRGB) and how much it covers, 0 to 255 each.
    pub color: u32,
}

pub(super) fn color(packed: u32) -> [u8; 4] {
    packed.to_be_bytes()
}

fn draw(canvas: &mut Canvas, mark: &tree_mark, index: usize) -> Result<()> {
    let (from, to) = (Vec2::from_array(mark.from), Vec2::from_array(mark.to));
    let color = color(mark.color);
    match mark.kind {
        TREE_MARK_LINE => canvas.line(from, to, mark.width, color),
        TREE_MARK_ARROW => canvas.arrow(from, to, mark.width, color),
        TREE_MARK_DOT => canvas.dot(from, 0.5 * mark.width, color),
        TREE_MARK_FILL => canvas.fill(from, to, color),
        other => {
            return Err(Failure::not_one_of(&format!("marks[{index}].kind"), other, "TREE_MARK_"));
        }
    }
    Ok(())
}

/// A copy of a photograph with `n_marks` marks drawn over it, in their order. `control` may be NULL;
/// `nodes` of its limits caps the marks. Free the new photograph with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_draw(
    photo: *const tree_photo,
    marks: *const tree_mark,
    n_marks: usize,
    control: *const tree_control,
    drawn: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawn, "drawn") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let limits = unsafe { limits(control) }?;
        let marks = unsafe { slice(marks, n_marks, &limits, Resource::Nodes, "marks") }?;
        let made = unsafe {
            run(control, |control| {
                let mut canvas = Canvas::over(photo);
                for (i, mark) in marks.iter().enumerate() {
                    control.check()?;
                    draw(&mut canvas, mark, i)?;
                }
                Ok(canvas.finish()?)
            })
        }?;
        place.put(tree_photo::new(made));
        Ok(())
    })
}

/// A photograph of one colour all over, `0xRRGGBBAA`, to draw on. `control` may be NULL; only its limits
/// matter. Free the photograph with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_blank(
    width: u32,
    height: u32,
    rgba: u32,
    control: *const tree_control,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let limits = unsafe { limits(control) }?;
        let canvas = Canvas::blank(width, height, color(rgba), &limits)
            .map_err(super::blamed(crate::border::TREE_ERROR_INVALID))?;
        place.put(tree_photo::new(canvas.finish()?));
        Ok(())
    })
}

/// A matte in grey, white where the tree covers, to draw on. Free the photograph with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_of_matte(
    matte: *const tree_matte,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let canvas = Canvas::of_matte(unsafe { get(matte, "matte") }?.rust());
        place.put(tree_photo::new(canvas.finish()?));
        Ok(())
    })
}
