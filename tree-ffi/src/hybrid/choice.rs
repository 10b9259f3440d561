//! What is drawn of a hybrid model.

use super::model::tree_hybrid;
use crate::border::{
    Failure, Handle, Result, Shared, TREE_ERROR_ORDER, Versioned, call, floats, foresee, free, get,
    out, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::impostor::{tree_leaf_range, write_ranges};
use crate::lod::take::fill_some;
use crate::mesh::{ask_for_copies, tree_mesh};
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_lod::hybrid::{Hybrid, HybridChoice};
use tree_lod::impostor::choose::{Choice, Watcher};

/// What is drawn of an instance of a hybrid model, kept from frame to frame. It keeps the model alive.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it is `TREE_ERROR_ORDER`.
pub struct tree_hybrid_choice {
    hybrid: Shared<Hybrid>,
    choice: Mutex<HybridChoice>,
}

impl Handle for tree_hybrid_choice {
    const NAME: &'static str = "tree_hybrid_choice";
}

impl tree_hybrid_choice {
    /// The choice, for this call alone.
    fn held(&self) -> Result<MutexGuard<'_, HybridChoice>> {
        match self.choice.try_lock() {
            Ok(held) => Ok(held),
            Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => {
                let text = "choice is at work in another call: one call at a time";
                Err(Failure::new(TREE_ERROR_ORDER, text))
            }
        }
    }
}

/// How much is drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_hybrid_choice_report {
    /// `sizeof(tree_hybrid_choice_report)`.
    pub struct_size: usize,
    /// Boxes drawn by their planes.
    pub n_boxes: usize,
    /// Ranges of leaves drawn as geometry.
    pub n_ranges: usize,
    /// Leaves in these.
    pub n_leaves: usize,
    /// Triangles of wood, leaves and planes.
    pub n_triangles: u64,
    /// Fractional level of the wood, at least 1, for the shader.
    pub level: f32,
    /// Indices of the wood, surface 0, that are drawn, from the first on.
    pub wood_indices: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_hybrid_choice_report {
    const NAME: &'static str = "tree_hybrid_choice_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_boxes: 0,
            n_ranges: 0,
            n_leaves: 0,
            n_triangles: 0,
            level: 1.0,
            wood_indices: 0,
        }
    }
}

impl tree_hybrid_choice_report {
    fn of(hybrid: &Hybrid, choice: &HybridChoice) -> Self {
        let leaves = choice.leaves.as_ref();
        Self {
            struct_size: size_of::<Self>(),
            n_boxes: leaves.map_or(0, |leaves| leaves.boxes.len()),
            n_ranges: leaves.map_or(0, |leaves| leaves.leaves.len()),
            n_leaves: leaves.map_or(0, Choice::n_leaves),
            n_triangles: hybrid.n_triangles(choice),
            level: choice.level,
            wood_indices: hybrid.wood().wood_indices(choice.level),
        }
    }
}

/// Makes a choice for one instance of a model, with room for all there can ever be; level 1 and no leaves until it is
/// updated. Free it with `tree_hybrid_choice_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_new(
    hybrid: *const tree_hybrid,
    choice: *mut *mut tree_hybrid_choice,
) -> tree_status {
    call(|| {
        let place = unsafe { out(choice, "choice") }?;
        let hybrid = unsafe { get(hybrid, "hybrid") }?.shared();
        let choice = Mutex::new(hybrid.get().choice()?);
        place.put(tree_hybrid_choice { hybrid, choice });
        Ok(())
    })
}

/// What is drawn where the whole tree is `pixels` high, above 0 and at most 1e5, at the same scale everywhere: for files,
/// previews, and levels of engines that have no shaders of ours. Free it with `tree_hybrid_choice_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_for_height(
    hybrid: *const tree_hybrid,
    pixels: f32,
    choice: *mut *mut tree_hybrid_choice,
) -> tree_status {
    call(|| {
        let place = unsafe { out(choice, "choice") }?;
        let hybrid = unsafe { get(hybrid, "hybrid") }?.shared();
        let choice = Mutex::new(hybrid.get().choice_for_height(pixels)?);
        place.put(tree_hybrid_choice { hybrid, choice });
        Ok(())
    })
}

/// Chooses for a frame: a level of wood, and of leaves as `tree_card_choice_update` does it. It takes no memory.
///
/// `eye` is three floats, in metres in the space of the tree, -1e9 to 1e9. `pixels_per_metre` is how many pixels something
/// of a metre covers at a distance of a metre: height in pixels / (2 tan(fov / 2)), times the scale of the instance;
/// above 0, at most 1e9. `report` may be NULL when it is not wanted. `TREE_ERROR_PARAMETER` for numbers out of range; the
/// choice is left as it was then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_update(
    choice: *mut tree_hybrid_choice,
    eye: *const f32,
    pixels_per_metre: f32,
    report: *mut tree_hybrid_choice_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(report.cast_const(), "report") }?;
        let choice = unsafe { get(choice.cast_const(), "choice") }?;
        let (hybrid, mut held) = (choice.hybrid.get(), choice.held()?);
        let eye: [f32; 3] = unsafe { floats(eye, "eye") }?;
        hybrid.update(&mut held, &Watcher { eye: eye.into(), pixels_per_metre })?;
        unsafe { view(report, "report", &tree_hybrid_choice_report::of(hybrid, &held)) }
    })
}

/// Tells how much is drawn since the last update. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_measure(
    choice: *const tree_hybrid_choice,
    report: *mut tree_hybrid_choice_report,
) -> tree_status {
    call(|| {
        let choice = unsafe { get(choice, "choice") }?;
        let found = tree_hybrid_choice_report::of(choice.hybrid.get(), &*choice.held()?);
        unsafe { write(report, "report", &found) }
    })
}

/// Writes the numbers of the boxes that are drawn by their planes. `boxes` has room for `capacity` numbers, at least
/// `n_boxes` of the report; as many as there are boxes are always enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_boxes(
    choice: *const tree_hybrid_choice,
    boxes: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let held = unsafe { get(choice, "choice") }?.held()?;
        let found = held.leaves.as_ref().map_or(&[][..], |leaves| &leaves.boxes);
        unsafe { fill_some(boxes, capacity, found, "boxes") }
    })
}

/// Writes the ranges of leaves that are drawn as geometry, rising, neighbours joined: `tree_hybrid_leaf_window` tells their
/// indices. `ranges` has room for `capacity` of them, at least `n_ranges` of the report; as many as there are boxes are
/// always enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_ranges(
    choice: *const tree_hybrid_choice,
    ranges: *mut tree_leaf_range,
    capacity: usize,
) -> tree_status {
    call(|| {
        let held = unsafe { get(choice, "choice") }?.held()?;
        let found = held.leaves.as_ref().map_or(&[][..], |leaves| &leaves.leaves);
        unsafe { write_ranges(ranges, capacity, found) }
    })
}

/// What is chosen as a plain mesh: the wood grown to its level, leaves, and three planes of each box, with light as on a
/// crown. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free the mesh with
/// `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_mesh(
    choice: *const tree_hybrid_choice,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let choice = unsafe { get(choice, "choice") }?;
        let (hybrid, held) = (choice.hybrid.get(), choice.held()?.clone());
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([hybrid.mesh()], 2)?;
                Ok(hybrid.mesh_of(&held)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// Frees a choice.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_choice_free(choice: *mut tree_hybrid_choice) -> tree_status {
    call(|| unsafe { free(choice, "choice") })
}
