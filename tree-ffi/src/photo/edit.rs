//! Editing a graph by hand. Each edit makes a new graph; the old one stays for undoing.

use super::attractor::tree_attractor;
use super::strokes::{tree_stroke_params, tree_stroke_report};
use super::vec2;
use crate::border::{
    Failure, TREE_ERROR_PARAMETER, Versioned, call, foresee, get, out, out_value, read_or_default,
    tree_status, vec2s, view,
};
use crate::control::{limits, run, tree_control};
use tree_model::particle::attractor::{CutOff, EraseReport};
use tree_model::tree_core::{Limits, Resource};

/// What happens to what erasing cuts off from the base: one of the `TREE_CUT_OFF_` constants.
pub type tree_cut_off = u32;

/// It goes too.
pub const TREE_CUT_OFF_DROP: u32 = 0;
/// It is joined to the nearest point of the rest by a straight line.
pub const TREE_CUT_OFF_RECONNECT: u32 = 1;

/// What erasing did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_erase_report {
    /// `sizeof(tree_erase_report)`.
    pub struct_size: usize,
    /// Segments under the eraser.
    pub n_erased: u32,
    /// Segments that went because they were cut off.
    pub n_dropped: u32,
    /// Parts that were cut off and joined again.
    pub n_reconnected: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_erase_report {
    const NAME: &'static str = "tree_erase_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&EraseReport::default())
    }
}

impl tree_erase_report {
    fn of(report: &EraseReport) -> Self {
        let EraseReport { n_erased, n_dropped, n_reconnected } = *report;
        Self { struct_size: size_of::<Self>(), n_erased, n_dropped, n_reconnected, reserved: 0 }
    }
}

/// A new graph with one more stroke of `n_points` points, two floats each in pixels, joined where it is
/// nearest. On an empty graph the stroke's lowest point becomes the root. `params`, `control` and `report`
/// may be NULL. `gap`, which may be NULL, gets the gap in pixels that was closed; NaN where the stroke was left
/// out. Free the new graph with `tree_attractor_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_add_stroke(
    attractor: *const tree_attractor,
    stroke: *const f32,
    n_points: usize,
    params: *const tree_stroke_params,
    control: *const tree_control,
    report: *mut tree_stroke_report,
    gap: *mut f32,
    changed: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        unsafe { foresee(report, "report") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let limits = unsafe { limits(control) }?;
        let stroke = unsafe { vec2s(stroke, n_points, &limits, Resource::Nodes, "stroke") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(graph.add_stroke(stroke, &params, control)?);
        let (made, told) = unsafe { run(control, body) }?;
        if !gap.is_null() {
            let closed = told.gaps.first().copied().flatten().unwrap_or(f32::NAN);
            unsafe { out_value(gap, closed, "gap") }?;
        }
        unsafe { view(report, "report", &tree_stroke_report::of(&told)) }?;
        place.put(tree_attractor::new(made));
        Ok(())
    })
}

/// A new graph without the segments that come within `radius` pixels (0 to 1e9) of an eraser's path of
/// `n_points` points, two floats each in pixels; one point is a dab. Points that are not finite are left
/// out. Roots stay. `cut_off` is a `TREE_CUT_OFF_` constant; `report` may be NULL. Free the new graph with
/// `tree_attractor_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_erase(
    attractor: *const tree_attractor,
    eraser: *const f32,
    n_points: usize,
    radius: f32,
    cut_off: tree_cut_off,
    report: *mut tree_erase_report,
    changed: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        unsafe { foresee(report, "report") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let limits = Limits::default();
        let path = unsafe { vec2s(eraser, n_points, &limits, Resource::Nodes, "eraser") }?;
        let cut_off = match cut_off {
            TREE_CUT_OFF_DROP => CutOff::Drop,
            TREE_CUT_OFF_RECONNECT => CutOff::Reconnect,
            other => return Err(Failure::not_one_of("cut_off", other, "TREE_CUT_OFF_")),
        };
        let (made, told) = graph.erase(path, radius, cut_off)?;
        unsafe { view(report, "report", &tree_erase_report::of(&told)) }?;
        place.put(tree_attractor::new(made));
        Ok(())
    })
}

/// A new graph with everything within `radius` pixels (0 to 1e9) of `at_pixel` moved by `by_pixels`, less the
/// farther it is; both are two floats. Roots stay where they are. Free the new graph with
/// `tree_attractor_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_move_near(
    attractor: *const tree_attractor,
    at_pixel: *const f32,
    by_pixels: *const f32,
    radius: f32,
    changed: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let at = unsafe { vec2(at_pixel, "at_pixel") }?;
        let by = unsafe { vec2(by_pixels, "by_pixels") }?;
        place.put(tree_attractor::new(graph.move_near(at, by, radius)?));
        Ok(())
    })
}

/// A new graph with left and right exchanged, in a picture `width` pixels wide. Free it with
/// `tree_attractor_free`. `TREE_ERROR_PARAMETER` for a width with which nodes would not be finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_mirrored(
    attractor: *const tree_attractor,
    width: f32,
    changed: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        // The library takes any width; nodes that are not finite would make a graph of no use.
        let made = graph.mirrored(width);
        if !width.is_finite() || !made.nodes().iter().all(|node| node.is_finite()) {
            let text = format!("width is {width}: the nodes would not be finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        place.put(tree_attractor::new(made));
        Ok(())
    })
}
