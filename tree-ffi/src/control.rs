//! Progress, cancellation and limits of a call.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_CANCELLED, TREE_ERROR_MEMORY, Versioned, call, free, get,
    get_opt, init, out, read, tree_status,
};
use crate::memory;
use crate::pool::tree_pool;
use std::ffi::{CString, c_char, c_void};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use tree_model::tree_core::{CancelFlag, Control, Limits};

/// Told how far a call has come: what is being done (UTF-8, NUL at the end, valid during the call) and
/// the share of the whole that is done, 0 to 1. Returns 0 to go on, anything else to cancel. Called from
/// whichever thread does the work, one call at a time for each call of the library; must not unwind.
pub type tree_progress_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, stage: *const c_char, fraction: f32) -> i32>;

/// How a call is done. Begin with `tree_control_init`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_control {
    /// `sizeof(tree_control)`.
    pub struct_size: usize,
    /// Told of progress. Default NULL.
    pub progress: tree_progress_fn,
    /// Handed to `progress`.
    pub user: *mut c_void,
    /// Cancels the call from any thread. Default NULL.
    pub cancel: *const tree_cancel,
    /// Caps on what the call may use. Default NULL: those of `tree_limits_init`.
    pub limits: *const tree_limits,
    /// Threads that do the work. Default NULL: one for each core, shared by all calls.
    pub pool: *const tree_pool,
}

// SAFETY: repr(C), begins with its size, and holds pointers only.
unsafe impl Versioned for tree_control {
    const NAME: &'static str = "tree_control";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            progress: None,
            user: std::ptr::null_mut(),
            cancel: std::ptr::null(),
            limits: std::ptr::null(),
            pool: std::ptr::null(),
        }
    }
}

/// Makes `control`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_control_init(control: *mut tree_control, size: usize) -> tree_status {
    call(|| unsafe { init(control, size) })
}

/// Caps for one call: over the cap is `TREE_ERROR_LIMIT`, before the memory is asked for. Begin with
/// `tree_limits_init` or `tree_limits_for_memory`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_limits {
    /// `sizeof(tree_limits)`.
    pub struct_size: usize,
    /// Nodes of a skeleton. Default 20 million.
    pub nodes: u64,
    /// Nodes of all search graphs of one model together. Default 20 million.
    pub graph_nodes: u64,
    /// Arcs of one search graph. Default 300 million.
    pub graph_arcs: u64,
    /// Leaves of one tree. Default 20 million.
    pub leaves: u64,
    /// Cells of a three-dimensional grid. Default 512³.
    pub voxels: u64,
    /// Pixels of a picture, supersamples included. Default 16,384².
    pub pixels: u64,
    /// Triangles of one mesh. Default 100 million.
    pub triangles: u64,
    /// Bytes of an input file. Default 1 GiB.
    pub input_bytes: u64,
    /// Modules of a derived L-system word. Default 100 million.
    pub modules: u64,
    /// Pairs of nodes kept while two trees are compared. Default 150 million.
    pub pairs: u64,
}

impl tree_limits {
    fn of(limits: &Limits) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            nodes: limits.nodes,
            graph_nodes: limits.graph_nodes,
            graph_arcs: limits.graph_arcs,
            leaves: limits.leaves,
            voxels: limits.voxels,
            pixels: limits.pixels,
            triangles: limits.triangles,
            input_bytes: limits.input_bytes,
            modules: limits.modules,
            pairs: limits.pairs,
        }
    }

    fn limits(&self) -> Limits {
        Limits {
            nodes: self.nodes,
            graph_nodes: self.graph_nodes,
            graph_arcs: self.graph_arcs,
            leaves: self.leaves,
            voxels: self.voxels,
            pixels: self.pixels,
            triangles: self.triangles,
            input_bytes: self.input_bytes,
            modules: self.modules,
            pairs: self.pairs,
        }
    }
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_limits {
    const NAME: &'static str = "tree_limits";
    const FIRST: usize = std::mem::offset_of!(Self, modules);
    fn default_value() -> Self {
        Self::of(&Limits::default())
    }
}

/// Makes `limits`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_limits_init(limits: *mut tree_limits, size: usize) -> tree_status {
    call(|| unsafe { init(limits, size) })
}

/// Makes `limits`, of `size` bytes, such that one call takes about `bytes` of memory at most; never more
/// than the default. `tree_memory_set_budget` does so for all calls together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_limits_for_memory(
    limits: *mut tree_limits,
    size: usize,
    bytes: u64,
) -> tree_status {
    call(|| {
        unsafe { init(limits, size) }?;
        unsafe {
            crate::border::write(limits, "limits", &tree_limits::of(&Limits::for_memory(bytes)))
        }
    })
}

/// A switch that cancels the calls it was given to.
pub struct tree_cancel(CancelFlag);

impl Handle for tree_cancel {
    const NAME: &'static str = "tree_cancel";
}

/// Makes a switch, not set. Free it with `tree_cancel_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cancel_new(cancel: *mut *mut tree_cancel) -> tree_status {
    call(|| {
        unsafe { out(cancel, "cancel") }?.put(tree_cancel(CancelFlag::default()));
        Ok(())
    })
}

/// Sets the switch, from any thread: calls it was given to end with `TREE_ERROR_CANCELLED`, mostly within
/// milliseconds. It stays set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cancel_set(cancel: *const tree_cancel) -> tree_status {
    call(|| {
        unsafe { get(cancel, "cancel") }?.0.cancel();
        Ok(())
    })
}

/// Frees a switch. Calls it was given to may still run.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cancel_free(cancel: *mut tree_cancel) -> tree_status {
    call(|| unsafe { free(cancel, "cancel") })
}

/// A pointer of the caller's that goes with a callback to other threads, as the header says.
#[derive(Clone, Copy)]
pub(crate) struct User(pub(crate) *mut c_void);
// SAFETY: never looked into here; that callbacks come from any thread is part of their contract.
unsafe impl Send for User {}
// SAFETY: as above.
unsafe impl Sync for User {}

impl User {
    /// The pointer. A method, so that closures capture the whole and not the bare pointer.
    pub(crate) fn get(self) -> *mut c_void {
        self.0
    }
}

/// The limits that a call works under, for what it reads before it runs.
pub(crate) unsafe fn limits(control: *const tree_control) -> Result<Limits> {
    if control.is_null() {
        return Ok(memory::limits(&Limits::default()));
    }
    let control = unsafe { read(control, "control") }?;
    let own = if control.limits.is_null() {
        Limits::default()
    } else {
        unsafe { read(control.limits, "control.limits") }?.limits()
    };
    Ok(memory::limits(&own))
}

/// Runs `body` as `control` says.
///
/// # Safety
/// `control` is NULL or as the header says.
pub(crate) unsafe fn run<R: Send>(
    control: *const tree_control,
    body: impl FnOnce(&Control) -> Result<R> + Send,
) -> Result<R> {
    let limits = unsafe { limits(control) }?;
    let given = unsafe { crate::border::read_or_default(control, "control") }?;
    // Bytes in use when the budget stopped the call; 0 when it did not.
    let over = Arc::new(AtomicU64::new(0));
    let refused = CancelFlag::default();
    let (seen, asked) = (over.clone(), refused.clone());
    let mut rust = Control::default().with_limits(limits).with_stop(move || {
        if let Some(used) = memory::over_budget() {
            seen.store(used, Ordering::Relaxed);
            return true;
        }
        asked.is_cancelled()
    });
    if let Some(cancel) = unsafe { get_opt(given.cancel, "control.cancel") }? {
        rust = rust.with_cancel(cancel.0.clone());
    }
    if given.progress.is_some() {
        rust = with_progress(rust, &given, refused);
    }
    let pool = unsafe { get_opt(given.pool, "control.pool") }?;
    let result = match pool {
        Some(pool) => pool.install(|| body(&rust)),
        None => body(&rust),
    };
    let beyond = |used: u64| {
        let budget = memory::budget();
        let text = format!("{used} bytes are in use, the memory budget is {budget}");
        Err(Failure::new(TREE_ERROR_MEMORY, text))
    };
    match (result, over.load(Ordering::Relaxed)) {
        (Err(failure), used) if used > 0 && failure.status == TREE_ERROR_CANCELLED => beyond(used),
        (Ok(made), _) => match memory::exceeded() {
            Some(used) => {
                drop(made);
                beyond(used)
            }
            None => Ok(made),
        },
        (failed, _) => failed,
    }
}

/// `refused` is set when the callback says so. The caller's own flag stays as it is: it may be for other
/// calls too.
fn with_progress(rust: Control, given: &tree_control, refused: CancelFlag) -> Control {
    let Some(progress) = given.progress else { return rust };
    let user = User(given.user);
    // Not a lock to wait for: a callback that calls the library may find its thread busy with another
    // part of this same call.
    let told = Mutex::new(());
    rust.with_progress(move |at| {
        let Ok(_one_at_a_time) = told.try_lock() else { return };
        let stage = CString::new(at.stage).unwrap_or_default();
        // SAFETY: the caller's function with the caller's pointer, as the header says.
        if unsafe { progress(user.get(), stage.as_ptr(), at.fraction) } != 0 {
            refused.cancel();
        }
    })
}
