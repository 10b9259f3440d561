//! Which boxes stand for the leaves at a distance, and which leaves are drawn as they are.

use super::cards::tree_cards;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ORDER, Versioned, call, floats, foresee, free, get, init,
    out, read, read_or_default, tree_status, view, write,
};
use crate::lod::take::{buffer, fill_some, room_for};
use bytemuck::{Pod, Zeroable};
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_lod::impostor::choose::{Choice, ChooseParams, Watcher};

/// When boxes are opened. Begin with `tree_card_choose_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_card_choose_params {
    /// `sizeof(tree_card_choose_params)`.
    pub struct_size: usize,
    /// Pixels that a texel may cover before its box is opened, 0.01 to 100. Less is sharper and heavier. Default 1.
    pub texel_pixels: f32,
    /// How much further, relatively, a box must be before it is closed again, 0 to 1: so that a camera that trembles
    /// does not make leaves flicker. Default 0.1.
    pub hysteresis: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_card_choose_params {
    const NAME: &'static str = "tree_card_choose_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let ChooseParams { texel_pixels, hysteresis } = ChooseParams::default();
        Self { struct_size: size_of::<Self>(), texel_pixels, hysteresis }
    }
}

impl tree_card_choose_params {
    pub(crate) fn rust(&self) -> ChooseParams {
        ChooseParams { texel_pixels: self.texel_pixels, hysteresis: self.hysteresis }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choose_params_init(
    params: *mut tree_card_choose_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choose_params_check(
    params: *const tree_card_choose_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What is drawn of a tree's leaves, and which boxes are open: one for each instance, kept from frame to frame.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it is `TREE_ERROR_ORDER`.
pub struct tree_card_choice(Mutex<Choice>);

impl Handle for tree_card_choice {
    const NAME: &'static str = "tree_card_choice";
}

/// The choice of a handle, for this call alone.
unsafe fn held<'a>(choice: *const tree_card_choice) -> Result<MutexGuard<'a, Choice>> {
    match unsafe { get(choice, "choice") }?.0.try_lock() {
        Ok(held) => Ok(held),
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = "choice is at work in another call: one call at a time";
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}

/// How much is drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_card_choice_report {
    /// `sizeof(tree_card_choice_report)`.
    pub struct_size: usize,
    /// Boxes drawn by their planes.
    pub n_boxes: usize,
    /// Ranges of leaves drawn as geometry.
    pub n_ranges: usize,
    /// Leaves in these.
    pub n_leaves: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_card_choice_report {
    const NAME: &'static str = "tree_card_choice_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Choice::default())
    }
}

impl tree_card_choice_report {
    fn of(choice: &Choice) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_boxes: choice.boxes.len(),
            n_ranges: choice.leaves.len(),
            n_leaves: choice.n_leaves(),
        }
    }
}

/// Makes a choice for one instance of a tree with these cards, with room for all there can ever be and all boxes
/// closed. It does not keep the cards alive. Free it with `tree_card_choice_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_new(
    cards: *const tree_cards,
    choice: *mut *mut tree_card_choice,
) -> tree_status {
    call(|| {
        let place = unsafe { out(choice, "choice") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        place.put(tree_card_choice(Mutex::new(Choice::new(cards)?)));
        Ok(())
    })
}

/// Chooses for a frame: from the box of the whole tree down, where a texel would be larger than a pixel, the children are
/// drawn instead, and the box's own leaves as geometry. Every leaf is in one box or one range. It takes no memory.
///
/// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
/// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
/// above 0, at most 1e9. `params` may be NULL, `report` when it is not wanted.
///
/// `TREE_ERROR_PARAMETER` for numbers out of range, `TREE_ERROR_INVALID` when the choice was made for other cards. The
/// choice is left as it was then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_update(
    choice: *mut tree_card_choice,
    cards: *const tree_cards,
    eye: *const f32,
    pixels_per_metre: f32,
    params: *const tree_card_choose_params,
    report: *mut tree_card_choice_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(report.cast_const(), "report") }?;
        let mut choice = unsafe { held(choice.cast_const()) }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let eye: [f32; 3] = unsafe { floats(eye, "eye") }?;
        let watcher = Watcher { eye: eye.into(), pixels_per_metre };
        let params = unsafe { read_or_default(params, "params") }?.rust();
        choice.update(cards.boxes(), &watcher, &params)?;
        unsafe { view(report, "report", &tree_card_choice_report::of(&choice)) }
    })
}

/// Tells how much is drawn since the last update. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_measure(
    choice: *const tree_card_choice,
    report: *mut tree_card_choice_report,
) -> tree_status {
    call(|| {
        let choice = unsafe { held(choice) }?;
        unsafe { write(report, "report", &tree_card_choice_report::of(&choice)) }
    })
}

/// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
/// `n_boxes` of the report; as many as there are boxes are always enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_boxes(
    choice: *const tree_card_choice,
    boxes: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let choice = unsafe { held(choice) }?;
        unsafe { fill_some(boxes, capacity, &choice.boxes, "boxes") }
    })
}

/// Leaves one after another in the order that `tree_leaf_boxes_order` tells.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_leaf_range {
    /// The first row.
    pub first: u32,
    /// Number of rows.
    pub n_leaves: u32,
}

/// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined. `ranges` has room for `capacity` of
/// them, at least `n_ranges` of the report; as many as there are boxes are always enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_ranges(
    choice: *const tree_card_choice,
    ranges: *mut tree_leaf_range,
    capacity: usize,
) -> tree_status {
    call(|| {
        let choice = unsafe { held(choice) }?;
        unsafe { write_ranges(ranges, capacity, &choice.leaves) }
    })
}

/// Writes ranges of rows to a caller's buffer.
///
/// # Safety
/// As [`buffer`].
pub(crate) unsafe fn write_ranges(
    ranges: *mut tree_leaf_range,
    capacity: usize,
    found: &[Range<u32>],
) -> Result<()> {
    room_for(found.len(), capacity, "ranges")?;
    let places = unsafe { buffer(ranges, found.len(), "ranges") }?;
    for (place, rows) in places.iter_mut().zip(found) {
        *place = tree_leaf_range { first: rows.start, n_leaves: rows.len() as u32 };
    }
    Ok(())
}

/// Frees a choice.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_choice_free(choice: *mut tree_card_choice) -> tree_status {
    call(|| unsafe { free(choice, "choice") })
}
