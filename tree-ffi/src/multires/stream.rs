//! Trees as bytes of which every prefix is a coarser tree.

use super::model::{ask_for_trees, tree_multires};
use crate::border::{
    self, Result, Versioned, bytes, call, foresee, get, init, out, read, read_or_default,
    tree_status, view,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::memory::ask;
use std::ffi::c_char;
use tree_core::file::{read_bytes, write_atomic};
use tree_lod::LodError;
use tree_lod::multires::Multires;
use tree_lod::multires::stream::{Received, StreamParams, decode, encode, encode_chain};

/// About how many bytes a tree has in memory for each byte of its stream.
pub(super) const GROWTH: u64 = 16;

/// How a stream is written. Begin with `tree_stream_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stream_params {
    /// `sizeof(tree_stream_params)`.
    pub struct_size: usize,
    /// Precision of positions and leaf sizes in metres, 0 or 1e-6 to 1; radii are eight times as precise, leaves are
    /// turned by at most 0.2 degrees. Default 0: exact, to the last bit, in two to three times the bytes.
    pub precision: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_stream_params {
    const NAME: &'static str = "tree_stream_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let StreamParams { precision } = StreamParams::default();
        Self { struct_size: size_of::<Self>(), precision, reserved: 0 }
    }
}

impl tree_stream_params {
    fn rust(&self) -> StreamParams {
        StreamParams { precision: self.precision }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_params_init(
    params: *mut tree_stream_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stream_params_check(
    params: *const tree_stream_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// How much of a stream has arrived.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stream_report {
    /// `sizeof(tree_stream_report)`.
    pub struct_size: usize,
    /// Levels that are whole and checked.
    pub n_levels: usize,
    /// Levels of the whole stream; 0 while its head is not there.
    pub n_levels_in_all: usize,
    /// Bytes that have been read.
    pub n_bytes: u64,
    /// 1 when all has arrived and its check holds, otherwise 0.
    pub is_complete: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_stream_report {
    const NAME: &'static str = "tree_stream_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Received::default())
    }
}

impl tree_stream_report {
    pub(super) fn of(received: &Received) -> Self {
        let Received { n_levels, of, is_complete, n_bytes } = *received;
        Self {
            struct_size: size_of::<Self>(),
            n_levels,
            n_levels_in_all: of,
            n_bytes,
            is_complete: is_complete.into(),
            reserved: 0,
        }
    }
}

/// What is written, when the memory for it is there.
unsafe fn written(
    multires: *const tree_multires,
    params: *const tree_stream_params,
    control: *const tree_control,
    write: impl FnOnce(&Multires, &StreamParams) -> std::result::Result<Vec<u8>, LodError> + Send,
) -> Result<Vec<u8>> {
    let multires = unsafe { get(multires, "multires") }?.rust();
    let params = unsafe { read_or_default(params, "params") }?.rust();
    unsafe {
        run(control, |control| {
            control.check()?;
            ask_for_trees(multires.tree(), 1)?;
            Ok(write(multires, &params)?)
        })
    }
}

/// The first `n_levels` levels of a tree, at least one, at most all, as bytes of which every prefix is a coarser tree:
/// the stream of `k` levels begins that of `k + 1`. `params` and `control` may be NULL; of `control` only a
/// cancellation before the work begins matters. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for
/// coordinates beyond 1000 km when there is a precision; `TREE_ERROR_FORMAT` for names of more than 4096 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_to_stream(
    multires: *const tree_multires,
    n_levels: usize,
    params: *const tree_stream_params,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let write = |multires: &_, params: &_| encode(multires, n_levels, params);
        place.put(tree_bytes::new(unsafe { written(multires, params, control, write) }?));
        Ok(())
    })
}

/// As `tree_multires_to_stream`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_write_stream(
    multires: *const tree_multires,
    n_levels: usize,
    path: *const c_char,
    path_len: usize,
    params: *const tree_stream_params,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let path = unsafe { border::path(path, path_len, "path") }?;
        let write = |multires: &_, params: &_| encode(multires, n_levels, params);
        save(path, &unsafe { written(multires, params, control, write) }?)
    })
}

/// The tree as one chain with brackets, in the same code but without levels, to compare sizes with: nothing reads it.
/// Otherwise as `tree_multires_to_stream`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_to_bracketed(
    multires: *const tree_multires,
    params: *const tree_stream_params,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let made = unsafe { written(multires, params, control, encode_chain) }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// Reads a stream, or what there is of it: levels up to the first that is cut off. The bytes are needed during the call
/// only, and never trusted. `control` and `report` may be NULL; `nodes`, `leaves` and `input_bytes` of the limits cap
/// what is read. Free what is made with `tree_multires_free`. `TREE_ERROR_FORMAT` when not even the first level is
/// whole, and for bytes that are no stream or are damaged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_from_stream(
    data: *const u8,
    len: usize,
    control: *const tree_control,
    report: *mut tree_stream_report,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multires, "multires") }?;
        unsafe { foresee(report.cast_const(), "report") }?;
        let limits = unsafe { limits(control) }?;
        let data = unsafe { bytes(data, len, &limits, "data") }?;
        let made = unsafe { decoded(data, control, report) }?;
        place.put(made);
        Ok(())
    })
}

/// As `tree_multires_from_stream`, from a file; the path as in `tree_mesh_write_glb`. A file that was cut off is read as
/// far as it goes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_read_stream(
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
    report: *mut tree_stream_report,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multires, "multires") }?;
        unsafe { foresee(report.cast_const(), "report") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let data = read_bytes(path, &unsafe { limits(control) }?)?;
        let made = unsafe { decoded(&data, control, report) }?;
        place.put(made);
        Ok(())
    })
}

unsafe fn decoded(
    data: &[u8],
    control: *const tree_control,
    report: *mut tree_stream_report,
) -> Result<tree_multires> {
    let (made, received) = unsafe {
        run(control, |control| {
            control.check()?;
            ask(GROWTH.saturating_mul(data.len() as u64))?;
            Ok(decode(data, &control.limits)?)
        })
    }?;
    unsafe { view(report, "report", &tree_stream_report::of(&received)) }?;
    Ok(tree_multires::new(made))
}

/// A file, whole or not at all.
pub(super) fn save(path: &std::path::Path, bytes: &[u8]) -> Result<()> {
    Ok(write_atomic(path, |out| {
        out.write_all(bytes).map_err(|error| tree_core::CoreError::io(path, error))
    })?)
}
