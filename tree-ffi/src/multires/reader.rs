//! Streams, as they arrive.

use super::model::tree_multires;
use super::stream::{GROWTH, tree_stream_report};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ORDER, bytes, call, foresee, free, get, out, tree_status,
    view, write,
};
use crate::control::{limits, run, tree_control};
use crate::memory::ask;
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_lod::multires::stream::Reader;
use tree_model::tree_core::{Limits, Resource};

/// Takes the bytes of a stream as they arrive, and gives the tree that they make so far.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it is `TREE_ERROR_ORDER`.
pub struct tree_stream_reader(Mutex<Held>);

struct Held {
    reader: Reader,
    limits: Limits,
    /// Bytes that were handed over, also those that wait for the rest of their level.
    taken: u64,
}

impl Handle for tree_stream_reader {
    const NAME: &'static str = "tree_stream_reader";
}

/// What a handle holds, for this call alone.
unsafe fn held<'a>(reader: *const tree_stream_reader) -> Result<MutexGuard<'a, Held>> {
    match unsafe { get(reader, "reader") }?.0.try_lock() {
        Ok(held) => Ok(held),
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = "reader is at work in another call: one call at a time";
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}

/// Makes a reader that nothing has reached yet. `control` may be NULL; the limits that it has now hold for all bytes to
/// come: `nodes` and `leaves`, asked for as the head arrives, and `input_bytes` for all bytes together. Free the reader
/// with `tree_stream_reader_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_reader_new(
    control: *const tree_control,
    reader: *mut *mut tree_stream_reader,
) -> tree_status {
    call(|| {
        let place = unsafe { out(reader, "reader") }?;
        let limits = unsafe { limits(control) }?;
        let held = Held { reader: Reader::new(&limits), limits, taken: 0 };
        place.put(tree_stream_reader(Mutex::new(held)));
        Ok(())
    })
}

/// Takes the next bytes, any number of them; they are needed during the call only, and never trusted. `report` may be
/// NULL. `TREE_ERROR_FORMAT` for bytes that are no stream, are damaged, or follow its end, and `TREE_ERROR_LIMIT`: the
/// levels before stay there, and the same comes again for more bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_reader_push(
    reader: *mut tree_stream_reader,
    data: *const u8,
    len: usize,
    report: *mut tree_stream_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(report.cast_const(), "report") }?;
        let mut held = unsafe { held(reader) }?;
        let data = unsafe { bytes(data, len, &held.limits, "data") }?;
        let taken = held.taken.saturating_add(data.len() as u64);
        held.limits.check(Resource::InputBytes, taken)?;
        let reader = &mut held.reader;
        let push = |_: &_| {
            ask(GROWTH.saturating_mul(data.len() as u64))?;
            Ok(reader.push(data)?)
        };
        let received = unsafe { run(std::ptr::null(), push) };
        held.taken = taken;
        unsafe { view(report, "report", &tree_stream_report::of(&received?)) }
    })
}

/// How much has arrived. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_reader_received(
    reader: *const tree_stream_reader,
    report: *mut tree_stream_report,
) -> tree_status {
    call(|| {
        let received = unsafe { held(reader) }?.reader.received();
        unsafe { write(report, "report", &tree_stream_report::of(&received)) }
    })
}

/// The tree of all levels that have arrived, a copy; the reader goes on. `control` may be NULL; of it only a
/// cancellation before the work begins matters. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when
/// the first level is not there yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_reader_multires(
    reader: *const tree_stream_reader,
    control: *const tree_control,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multires, "multires") }?;
        let held = unsafe { held(reader) }?;
        let reader = &held.reader;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask(GROWTH.saturating_mul(reader.received().n_bytes))?;
                Ok(reader.multires()?)
            })
        }?;
        place.put(tree_multires::new(made));
        Ok(())
    })
}

/// Frees a reader. Trees that came of it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_reader_free(reader: *mut tree_stream_reader) -> tree_status {
    call(|| unsafe { free(reader, "reader") })
}
