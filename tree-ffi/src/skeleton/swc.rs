//! Skeletons from and to SWC files, the plain-text exchange format of tree scanning and neuron tracing.

use super::tree_skeleton;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, bytes, call, free, get, init, out,
    path, read_or_default, tree_status, tree_str, write,
};
use crate::control::{limits, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::tree_core::swc::{self, SwcImport, SwcOptions, SwcReport, UnknownRadius};
use tree_model::tree_core::{Skeleton, UpAxis};

/// Which axis of a file or a cloud points up: one of the `TREE_UP_` constants.
pub type tree_up = u32;
/// +Z, as laser scanners and foresters have it: (x, y, z) becomes (x, z, -y). The default.
pub const TREE_UP_Z: u32 = 0;
/// +Y, as in this library.
pub const TREE_UP_Y: u32 = 1;

/// What becomes of radii that an SWC file does not know: one of the `TREE_SWC_RADIUS_` constants.
pub type tree_swc_radius = u32;
/// They stay 0, for example to be found by `tree_skeleton_with_rule`.
pub const TREE_SWC_RADIUS_KEEP: u32 = 0;
/// They go from the radius below to the thickest known radius above, in proportion to the path length.
/// Where nothing is known above, the radius below is taken; where nothing is known below, the one above;
/// where nothing is known at all, 0 stays.
pub const TREE_SWC_RADIUS_INTERPOLATE: u32 = 1;

/// How an SWC file relates to this library. Begin with `tree_swc_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_swc_options {
    /// `sizeof(tree_swc_options)`.
    pub struct_size: usize,
    /// Metres per unit of the file, for positions and radii; 1e-9 to 1e9. Default 1.
    pub scale: f64,
    /// The file's upward axis. Default `TREE_UP_Z`.
    pub up: tree_up,
    /// Whether reading moves the root to the origin. Default 1. The move is made in double precision, so
    /// that coordinates of a map grid lose nothing. Not used in writing.
    pub base_at_origin: u32,
    /// What becomes of radii that the file does not know. Default `TREE_SWC_RADIUS_KEEP`. Not used in
    /// writing.
    pub unknown_radius: tree_swc_radius,
    /// Must be 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_swc_options {
    const NAME: &'static str = "tree_swc_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = SwcOptions::default();
        Self {
            struct_size: size_of::<Self>(),
            scale: default.scale,
            up: match default.up {
                UpAxis::Y => TREE_UP_Y,
                UpAxis::Z => TREE_UP_Z,
            },
            base_at_origin: default.base_at_origin.into(),
            unknown_radius: match default.unknown_radius {
                UnknownRadius::Interpolate => TREE_SWC_RADIUS_INTERPOLATE,
                _ => TREE_SWC_RADIUS_KEEP,
            },
            reserved: 0,
        }
    }
}

impl tree_swc_options {
    fn rust(&self) -> Result<SwcOptions> {
        if self.reserved != 0 {
            return Err(Failure::new(TREE_ERROR_PARAMETER, "options.reserved must be 0"));
        }
        Ok(SwcOptions {
            scale: self.scale,
            up: match self.up {
                TREE_UP_Y => UpAxis::Y,
                TREE_UP_Z => UpAxis::Z,
                other => return Err(Failure::not_one_of("options.up", other, "TREE_UP_")),
            },
            base_at_origin: self.base_at_origin != 0,
            unknown_radius: match self.unknown_radius {
                TREE_SWC_RADIUS_KEEP => UnknownRadius::Keep,
                TREE_SWC_RADIUS_INTERPOLATE => UnknownRadius::Interpolate,
                other => {
                    let name = "options.unknown_radius";
                    return Err(Failure::not_one_of(name, other, "TREE_SWC_RADIUS_"));
                }
            },
        })
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_options_init(
    options: *mut tree_swc_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

/// What an SWC file held: a skeleton, and what a skeleton has no column for.
pub struct tree_swc {
    skeleton: Arc<Skeleton>,
    types: Vec<i32>,
    ids: Vec<i64>,
    report: SwcReport,
}

impl Handle for tree_swc {
    const NAME: &'static str = "tree_swc";
}

impl tree_swc {
    fn of(import: SwcImport) -> Self {
        let SwcImport { skeleton, types, ids, report } = import;
        Self { skeleton: Arc::new(skeleton), types, ids, report }
    }
}

/// What an SWC file held beside the skeleton, and what was noted while reading.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_swc_contents {
    /// `sizeof(tree_swc_contents)`.
    pub struct_size: usize,
    /// Number of nodes.
    pub n_nodes: usize,
    /// One for each node: its type as in the file; 3 continues its parent's axis, 4 starts a lateral.
    pub types: *const i32,
    /// One for each node: its id as in the file.
    pub ids: *const i64,
    /// All comments without their `#`, a line each.
    pub comments: tree_str,
    /// Rows without a known radius.
    pub n_unknown_radii: u64,
    /// How many of these `unknown_radius` gave a radius.
    pub n_filled_radii: u64,
    /// Rows with more than seven fields; the further ones were passed over.
    pub n_rows_with_more_fields: u64,
    /// 1 if rows came before their parents, so that nodes have another order than rows; else 0.
    pub reordered: u32,
    /// 0.
    pub reserved: u32,
    /// What was added to every position to bring the root to the origin, in metres and this library's
    /// axes; zeros if nothing was moved.
    pub moved_by: [f64; 3],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_swc_contents {
    const NAME: &'static str = "tree_swc_contents";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            types: std::ptr::null(),
            ids: std::ptr::null(),
            comments: tree_str::EMPTY,
            n_unknown_radii: 0,
            n_filled_radii: 0,
            n_rows_with_more_fields: 0,
            reordered: 0,
            reserved: 0,
            moved_by: [0.0; 3],
        }
    }
}

impl tree_swc_contents {
    fn of(swc: &tree_swc) -> Self {
        let report = &swc.report;
        Self {
            n_nodes: swc.ids.len(),
            types: column(&swc.types),
            ids: column(&swc.ids),
            comments: tree_str::of(&report.comments),
            n_unknown_radii: report.n_unknown_radii as u64,
            n_filled_radii: report.n_filled_radii as u64,
            n_rows_with_more_fields: report.n_rows_with_more_fields as u64,
            reordered: report.reordered.into(),
            moved_by: report.moved_by,
            ..Self::default_value()
        }
    }
}

/// Reads an SWC file: metres, +Y up. Rows keep their order where parents come first; otherwise nodes come
/// breadth-first. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and `path_len` is
/// `TREE_NUL_TERMINATED`. `options` may be NULL for the defaults, and
/// so may `control`, of which only the limits matter. What is wrong with a file is told with its line.
/// Free the file with `tree_swc_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_read(
    path: *const c_char,
    path_len: usize,
    options: *const tree_swc_options,
    control: *const tree_control,
    swc: *mut *mut tree_swc,
) -> tree_status {
    call(|| {
        let place = unsafe { out(swc, "swc") }?;
        let path = unsafe { self::path(path, path_len, "path") }?;
        let options = unsafe { read_or_default(options, "options") }?.rust()?;
        place.put(tree_swc::of(swc::read_file(path, &options, &unsafe { limits(control) }?)?));
        Ok(())
    })
}

/// Reads the text of an SWC file, of `len` bytes or `TREE_NUL_TERMINATED`. Otherwise as `tree_swc_read`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_from_text(
    text: *const c_char,
    len: usize,
    options: *const tree_swc_options,
    control: *const tree_control,
    swc: *mut *mut tree_swc,
) -> tree_status {
    call(|| {
        let place = unsafe { out(swc, "swc") }?;
        let options = unsafe { read_or_default(options, "options") }?.rust()?;
        let limits = unsafe { limits(control) }?;
        // As for files: a comment in another encoding is no reason to refuse one.
        let text = String::from_utf8_lossy(unsafe { bytes(text.cast(), len, &limits, "text") }?);
        place.put(tree_swc::of(swc::read(&text, &options, &limits)?));
        Ok(())
    })
}

/// The skeleton of an SWC file, not copied. Free it with `tree_skeleton_free`; it may outlive `swc`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_skeleton(
    swc: *const tree_swc,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        place.put(tree_skeleton::shared(unsafe { get(swc, "swc") }?.skeleton.clone()));
        Ok(())
    })
}

/// Views what an SWC file held beside the skeleton. Set `contents->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_view(
    swc: *const tree_swc,
    contents: *mut tree_swc_contents,
) -> tree_status {
    call(|| {
        let swc = unsafe { get(swc, "swc") }?;
        unsafe { write(contents, "contents", &tree_swc_contents::of(swc)) }
    })
}

/// Frees an SWC file that was read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_swc_free(swc: *mut tree_swc) -> tree_status {
    call(|| unsafe { free(swc, "swc") })
}

/// Writes a skeleton as an SWC file, which is whole or absent: written beside its name, then renamed. Ids
/// count from 1 in node order; types are 3, which continues the axis, and 4, which starts a lateral. With
/// a scale of 1, reading brings back every position and radius exactly, unless it moves the root.
/// `options` may be NULL for the defaults.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_write_swc(
    skeleton: *const tree_skeleton,
    path: *const c_char,
    path_len: usize,
    options: *const tree_swc_options,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let path = unsafe { self::path(path, path_len, "path") }?;
        let options = unsafe { read_or_default(options, "options") }?.rust()?;
        Ok(swc::write_file(path, skeleton, &options)?)
    })
}

/// Writes a skeleton as the text of an SWC file, as `tree_skeleton_write_swc` does. Free it with
/// `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_to_swc(
    skeleton: *const tree_skeleton,
    options: *const tree_swc_options,
    text: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(text, "text") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let options = unsafe { read_or_default(options, "options") }?.rust()?;
        place.put(tree_bytes::new(swc::write(skeleton, &options)?.into_bytes()));
        Ok(())
    })
}
