//! Memory: how much is in use, a budget for all calls together, and the host's own allocator.
//!
//! With the feature `allocator` (on by default) every allocation of the library passes through here and
//! is counted. The budget acts twice: before a call begins, its limits are lowered to what the rest of
//! the budget holds; while it runs, each check for cancellation looks whether the budget is exceeded. An
//! allocation itself never fails because of the budget: Rust would abort.

use crate::border::{
    Failure, Result, TREE_ERROR_MEMORY, TREE_ERROR_NULL, TREE_ERROR_ORDER, Versioned, call, read,
    tree_status,
};
#[cfg(feature = "allocator")]
use std::alloc::{GlobalAlloc, Layout, System};
use std::ffi::c_void;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use tree_model::tree_core::Limits;

static USED: [Share; SHARES] = [const { Share(AtomicU64::new(0)) }; SHARES];
static PEAK: AtomicU64 = AtomicU64::new(0);
static BUDGET: AtomicU64 = AtomicU64::new(NO_BUDGET);
static HOST: OnceLock<tree_allocator> = OnceLock::new();

const NO_BUDGET: u64 = u64::MAX;
/// Counters that the threads share among them: with one for all, threads waited for each other.
const SHARES: usize = 16;
#[cfg(feature = "allocator")]
/// Blocks from this size on move the peak at once; smaller ones with the next such block, or when it is
/// asked for.
const LARGE: usize = 4096;
/// Work of so many bytes is not refused beforehand, however little of the budget is left.
const SMALL: u64 = 1 << 20;
/// Part of the budget that is kept for what is taken between two checks: one in so many.
const RESERVE: u64 = 8;

/// Bytes taken less bytes given back by some of the threads, modulo 2^64, on a cache line of its own.
#[repr(align(64))]
struct Share(AtomicU64);

fn used() -> u64 {
    USED.iter().fold(0_u64, |sum, share| sum.wrapping_add(share.0.load(Ordering::Relaxed)))
}

/// A counter that is mostly this thread's: by the place of its stack, which costs nothing to find. (A
/// thread-local is a call in a shared library, and allocations are many.)
#[cfg(feature = "allocator")]
fn share() -> &'static AtomicU64 {
    let on_the_stack = 0_u8;
    // Stacks lie megabytes apart; the product spreads their distances over the upper bits.
    let stack = std::ptr::from_ref(&on_the_stack).addr() as u64 >> 20;
    let mine = stack.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 60;
    &USED[mine as usize % SHARES].0
}

/// Bytes that the library has allocated and not freed, objects and work in progress together.
#[unsafe(no_mangle)]
pub extern "C" fn tree_memory_used() -> u64 {
    used()
}

/// Most bytes in use at one time since the start, or since `tree_memory_reset_peak`; small blocks may be
/// missed by some kilobytes.
#[unsafe(no_mangle)]
pub extern "C" fn tree_memory_peak() -> u64 {
    let used = used();
    PEAK.fetch_max(used, Ordering::Relaxed).max(used)
}

/// Lets the peak begin anew at what is in use now.
#[unsafe(no_mangle)]
pub extern "C" fn tree_memory_reset_peak() {
    PEAK.store(used(), Ordering::Relaxed);
}

/// Sets how many bytes the library may have in use, all calls and objects together; 0 for no budget, as
/// at the start. A call that would need more fails with `TREE_ERROR_LIMIT` before it takes the memory,
/// or with `TREE_ERROR_MEMORY` while it works; what it had taken is free again then. Several calls at
/// once may all be told so. Calls that take no memory, such as looking at a mesh, never are. An eighth of
/// the budget is kept for what is taken between two looks at it; a call that went beyond all the same fails
/// at its end.
#[unsafe(no_mangle)]
pub extern "C" fn tree_memory_set_budget(bytes: u64) {
    BUDGET.store(if bytes == 0 { NO_BUDGET } else { bytes }, Ordering::Relaxed);
}

/// The budget in bytes; 0 when there is none.
#[unsafe(no_mangle)]
pub extern "C" fn tree_memory_budget() -> u64 {
    match budget() {
        NO_BUDGET => 0,
        bytes => bytes,
    }
}

/// The host's allocator. Its functions are called from any thread and must not call the library.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_allocator {
    /// `sizeof(tree_allocator)`.
    pub struct_size: usize,
    /// Handed to the functions.
    pub user: *mut c_void,
    /// `size` bytes (never 0) at a multiple of `align` (a power of two), or NULL.
    pub allocate:
        Option<unsafe extern "C" fn(user: *mut c_void, size: usize, align: usize) -> *mut c_void>,
    /// Gives back what `allocate` gave for this size and alignment.
    pub release: Option<
        unsafe extern "C" fn(user: *mut c_void, block: *mut c_void, size: usize, align: usize),
    >,
}

// SAFETY: the functions are called from any thread, which is part of their contract.
unsafe impl Send for tree_allocator {}
// SAFETY: as above.
unsafe impl Sync for tree_allocator {}

// SAFETY: repr(C), begins with its size, and holds pointers only.
unsafe impl Versioned for tree_allocator {
    const NAME: &'static str = "tree_allocator";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            user: std::ptr::null_mut(),
            allocate: None,
            release: None,
        }
    }
}

/// Lets the library take its memory from the host's allocator. Only before anything else: once the
/// library has memory of its own it is `TREE_ERROR_ORDER`. When `allocate` gives NULL the process aborts, as
/// Rust does; set a budget below what the allocator has.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_memory_set_allocator(
    allocator: *const tree_allocator,
) -> tree_status {
    let used = tree_memory_used();
    call(|| {
        let allocator = unsafe { read(allocator, "allocator") }?;
        if allocator.allocate.is_none() || allocator.release.is_none() {
            return Err(Failure::new(
                TREE_ERROR_NULL,
                "allocator.allocate or allocator.release is NULL",
            ));
        }
        if !cfg!(feature = "allocator") {
            let text = "this library was built without the feature `allocator`";
            return Err(Failure::new(TREE_ERROR_ORDER, text));
        }
        if used > 0 || HOST.set(allocator).is_err() {
            let text = format!(
                "{used} bytes are in use: set the allocator first, and once (an error text counts, until \
                 tree_error_clear)"
            );
            return Err(Failure::new(TREE_ERROR_ORDER, text));
        }
        Ok(())
    })
}

/// The budget in bytes; the largest number when there is none.
pub(crate) fn budget() -> u64 {
    BUDGET.load(Ordering::Relaxed)
}

/// Bytes in use, if a call has to stop because of the budget.
pub(crate) fn over_budget() -> Option<u64> {
    let budget = budget();
    if budget == NO_BUDGET {
        return None;
    }
    let used = used();
    (used > budget - budget / RESERVE).then_some(used)
}

/// Whether work that is done has gone beyond the budget.
pub(crate) fn exceeded() -> Option<u64> {
    let used = used();
    (used > budget()).then_some(used)
}

/// Asks for about `bytes` for work that cannot be stopped on the way.
pub(crate) fn ask(bytes: u64) -> Result<()> {
    let (budget, used) = (budget(), used());
    if budget == NO_BUDGET || used.saturating_add(bytes) <= budget {
        return Ok(());
    }
    let text = format!(
        "about {bytes} bytes are needed, {used} are in use, and the memory budget is {budget}"
    );
    Err(Failure::new(TREE_ERROR_MEMORY, text))
}

/// The limits `own`, and no more than the rest of the budget holds.
pub(crate) fn limits(own: &Limits) -> Limits {
    match budget() {
        NO_BUDGET => *own,
        bytes => own.min(&Limits::for_memory(bytes.saturating_sub(used()).max(SMALL))),
    }
}

#[cfg(feature = "allocator")]
#[global_allocator]
static COUNTING: Counting = Counting;

/// The system's allocator or the host's, counted.
#[cfg(feature = "allocator")]
struct Counting;

#[cfg(feature = "allocator")]
impl Counting {
    fn took(bytes: usize) {
        share().fetch_add(bytes as u64, Ordering::Relaxed);
        if bytes >= LARGE {
            let used = used();
            if used > PEAK.load(Ordering::Relaxed) {
                PEAK.fetch_max(used, Ordering::Relaxed);
            }
        }
    }

    fn gave(bytes: usize) {
        share().fetch_sub(bytes as u64, Ordering::Relaxed);
    }
}

#[cfg(feature = "allocator")]
/// A block of the host's.
///
/// # Safety
/// As [`GlobalAlloc::alloc`].
unsafe fn host_alloc(host: &tree_allocator, layout: Layout) -> *mut u8 {
    match host.allocate {
        // SAFETY: the host's function with the host's pointer.
        Some(alloc) => unsafe { alloc(host.user, layout.size(), layout.align()) }.cast(),
        None => std::ptr::null_mut(),
    }
}

#[cfg(feature = "allocator")]
/// Gives a block of the host's back.
///
/// # Safety
/// As [`GlobalAlloc::dealloc`].
unsafe fn host_free(host: &tree_allocator, block: *mut u8, layout: Layout) {
    if let Some(free) = host.release {
        // SAFETY: the host's function with a block of the host's.
        unsafe { free(host.user, block.cast(), layout.size(), layout.align()) };
    }
}

#[cfg(feature = "allocator")]
// SAFETY: hands every request on to one allocator, which never changes while a block is out.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let block = match HOST.get() {
            None => unsafe { System.alloc(layout) },
            Some(host) => unsafe { host_alloc(host, layout) },
        };
        if !block.is_null() {
            Self::took(layout.size());
        }
        block
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        let block = match HOST.get() {
            None => unsafe { System.alloc_zeroed(layout) },
            Some(host) => {
                let block = unsafe { host_alloc(host, layout) };
                if !block.is_null() {
                    // SAFETY: a block of this size.
                    unsafe { block.write_bytes(0, layout.size()) };
                }
                block
            }
        };
        if !block.is_null() {
            Self::took(layout.size());
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        match HOST.get() {
            None => unsafe { System.dealloc(block, layout) },
            Some(host) => unsafe { host_free(host, block, layout) },
        }
        Self::gave(layout.size());
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let new = match HOST.get() {
            None => unsafe { System.realloc(block, layout, size) },
            Some(host) => {
                // SAFETY: the caller's contract says that size and alignment make a layout.
                let grown = unsafe { Layout::from_size_align_unchecked(size, layout.align()) };
                let new = unsafe { host_alloc(host, grown) };
                if !new.is_null() {
                    // SAFETY: both blocks have at least so many bytes.
                    unsafe { new.copy_from_nonoverlapping(block, layout.size().min(size)) };
                    unsafe { host_free(host, block, layout) };
                }
                new
            }
        };
        if !new.is_null() {
            Self::took(size);
            Self::gave(layout.size());
        }
        new
    }
}
