//! Clouds of points from files.

use crate::border::{
    self, Failure, Handle, Versioned, bytes, call, free, get, out, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use ::tree_mesh::io::points::{self, Points};
use std::ffi::c_char;

/// A file format for clouds of points: one of the `TREE_CLOUD_FORMAT_` constants.
pub type tree_cloud_format = u32;
/// PLY, text or binary, of either order of bytes: the vertices; other properties and elements are passed over.
pub const TREE_CLOUD_FORMAT_PLY: u32 = 1;
/// XYZ, TXT, CSV, ASC, PTS: a point on each line, columns parted by blanks, commas, semicolons or tabs. A line of names
/// may say which columns are x, y and z; else they are the first three. Lines behind `#`, `//` and `;` are comments.
pub const TREE_CLOUD_FORMAT_TEXT: u32 = 2;

/// A cloud of points, as laser scanners give it.
pub struct tree_cloud(Points);

impl Handle for tree_cloud {
    const NAME: &'static str = "tree_cloud";
}

impl tree_cloud {
    pub(crate) fn rust(&self) -> &Points {
        &self.0
    }
}

/// A view of a cloud of points.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_cloud_columns {
    /// `sizeof(tree_cloud_columns)`.
    pub struct_size: usize,
    /// Number of points.
    pub n_points: usize,
    /// Three doubles for each point, in the file's own axes and unit. They need not be finite.
    pub positions: *const f64,
    /// Lines of text that are no points: names, counts and comments.
    pub n_other_lines: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_cloud_columns {
    const NAME: &'static str = "tree_cloud_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            positions: std::ptr::null(),
            n_other_lines: 0,
        }
    }
}

/// Reads a cloud from a file whose extension is `ply`, `xyz`, `txt`, `csv`, `asc` or `pts`, in letters of any case; the
/// path is as in `tree_mesh_read`. `TREE_ERROR_FORMAT` for others, and for broken files, with the line or row;
/// `TREE_ERROR_LIMIT` for more points than `tree_limits.graph_nodes`. `control` may be NULL. Free the cloud with
/// `tree_cloud_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cloud_read(
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
    cloud: *mut *mut tree_cloud,
) -> tree_status {
    call(|| {
        let place = unsafe { out(cloud, "cloud") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let read = unsafe { run(control, |control| Ok(points::read(path, control)?)) }?;
        place.put(tree_cloud(read));
        Ok(())
    })
}

/// As `tree_cloud_read`, from a file in memory, whose `format` must be stated. The bytes are needed during the call only.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cloud_from_bytes(
    format: tree_cloud_format,
    data: *const u8,
    len: usize,
    control: *const tree_control,
    cloud: *mut *mut tree_cloud,
) -> tree_status {
    call(|| {
        let place = unsafe { out(cloud, "cloud") }?;
        let data = unsafe { bytes(data, len, &limits(control)?, "data") }?;
        let read = unsafe {
            run(control, |control| {
                Ok(match format {
                    TREE_CLOUD_FORMAT_PLY => points::from_ply(data, control),
                    TREE_CLOUD_FORMAT_TEXT => points::from_text(data, control),
                    other => {
                        return Err(Failure::not_one_of("format", other, "TREE_CLOUD_FORMAT_"));
                    }
                }?)
            })
        }?;
        place.put(tree_cloud(read));
        Ok(())
    })
}

/// Views a cloud. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cloud_view(
    cloud: *const tree_cloud,
    columns: *mut tree_cloud_columns,
) -> tree_status {
    call(|| {
        let cloud = unsafe { get(cloud, "cloud") }?.rust();
        let value = tree_cloud_columns {
            n_points: cloud.positions.len(),
            positions: column(&cloud.positions).cast(),
            n_other_lines: cloud.n_other_lines as u64,
            ..tree_cloud_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees a cloud of points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cloud_free(cloud: *mut tree_cloud) -> tree_status {
    call(|| unsafe { free(cloud, "cloud") })
}
