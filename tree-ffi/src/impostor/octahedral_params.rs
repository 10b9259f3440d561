//! How a whole tree is baked, and what was baked.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_lod::impostor::octahedral::{OctahedralParams, OctahedralReport};

/// How a whole tree is baked. Begin with `tree_octahedral_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_octahedral_params {
    /// `sizeof(tree_octahedral_params)`.
    pub struct_size: usize,
    /// Views along each side of the square of directions, 2 to 64. Default 12: 144 views.
    pub grid: u32,
    /// Whether only views from the horizon up are baked, which halves the angle between them. Default 1.
    pub hemi: u32,
    /// Side of the pictures in texels, 64 to 16,384, at least 16 for each view. Default 2048.
    pub side: u32,
    /// Samples of a texel in each direction, 1 to 8. Default 4.
    pub samples: u32,
    /// Empty texels around each view, 1 to 8 and at most a quarter of a view: so that filters do not mix views.
    /// Default 2.
    pub gutter: u32,
    /// Whether the picture of normals and depths has half the side. Memory goes from 33.6 MB to 21 MB at the default
    /// side, at some loss of quality. Default 0.
    pub half_detail: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_octahedral_params {
    const NAME: &'static str = "tree_octahedral_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = OctahedralParams::default();
        Self {
            struct_size: size_of::<Self>(),
            grid: default.grid,
            hemi: default.hemi.into(),
            side: default.side,
            samples: default.samples,
            gutter: default.gutter,
            half_detail: default.half_detail.into(),
        }
    }
}

impl tree_octahedral_params {
    pub(super) fn rust(&self) -> OctahedralParams {
        OctahedralParams {
            grid: self.grid,
            hemi: self.hemi != 0,
            side: self.side,
            samples: self.samples,
            gutter: self.gutter,
            half_detail: self.half_detail != 0,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_params_init(
    params: *mut tree_octahedral_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_params_check(
    params: *const tree_octahedral_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What was baked.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_octahedral_report {
    /// `sizeof(tree_octahedral_report)`.
    pub struct_size: usize,
    /// Number of views.
    pub n_views: usize,
    /// Triangles drawn in each.
    pub n_triangles: usize,
    /// Texels covered at least by half, of all views.
    pub covered: u64,
    /// Bytes of both pictures, as they are in memory.
    pub bytes: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_octahedral_report {
    const NAME: &'static str = "tree_octahedral_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&OctahedralReport::default())
    }
}

impl tree_octahedral_report {
    pub(super) fn of(report: &OctahedralReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_views: report.n_views,
            n_triangles: report.n_triangles,
            covered: report.covered,
            bytes: report.bytes,
        }
    }
}
