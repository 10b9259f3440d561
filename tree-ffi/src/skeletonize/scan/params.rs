//! How a cloud of points is read.

use crate::border::{Failure, Result, Versioned, call, init, read, tree_status};
use crate::skeleton::{TREE_UP_Y, TREE_UP_Z, tree_up};
use tree_model::skeletonize::ScanParams;
use tree_model::tree_core::UpAxis;

/// How a cloud of points is read. Lengths are metres; "spacings" are the median distance of a point to its fourth
/// neighbour. Begin with `tree_scan_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scan_params {
    /// `sizeof(tree_scan_params)`.
    pub struct_size: usize,
    /// Metres for a unit of the cloud, 1e-6 to 1e6. Default 1.
    pub unit: f64,
    /// The axis that points up. Default `TREE_UP_Z`.
    pub up: tree_up,
    /// Edge of the voxels that become one point each, 0 to 10 m. Default 0: half a spacing.
    pub voxel: f32,
    /// Nearest points that each one is joined with, 4 to 32. Default 8. More bridge thin gaps and run branches together.
    pub neighbours: u32,
    /// Widest gap that is bridged, as a share of the cloud's size, 0 to 1. Default 0.1. What is farther away is left out
    /// and reported.
    pub bridge: f32,
    /// Distance between nodes in spacings, 1 to 20. Default 2.5.
    pub step: f32,
    /// Reach within which an axis takes in what runs beside it, in its widths (mean distances of its points from its
    /// middle), 1 to 10. Default 2.
    pub merge: f32,
    /// Length in spacings by which a branch must leave the reach of its parent, 0 to 100. Default 4.
    pub prune: f32,
    /// Whether the ground is taken away where the scan shows some. Default 1.
    pub ground: u32,
    /// Whether every trunk becomes a tree. Default 0: the cloud is one tree, and the report tells how many trunks it may
    /// have.
    pub several: u32,
    /// Whether branches through foliage, which are guessed, are kept. Default 1.
    pub foliage: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_scan_params {
    const NAME: &'static str = "tree_scan_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let ScanParams {
            up,
            unit,
            voxel,
            neighbours,
            bridge,
            ground,
            step,
            merge,
            prune,
            several,
            foliage,
        } = ScanParams::default();
        Self {
            struct_size: size_of::<Self>(),
            unit,
            up: match up {
                UpAxis::Z => TREE_UP_Z,
                UpAxis::Y => TREE_UP_Y,
            },
            voxel,
            neighbours,
            bridge,
            step,
            merge,
            prune,
            ground: ground.into(),
            several: several.into(),
            foliage: foliage.into(),
        }
    }
}

impl tree_scan_params {
    pub(super) fn rust(&self) -> Result<ScanParams> {
        Ok(ScanParams {
            up: match self.up {
                TREE_UP_Z => UpAxis::Z,
                TREE_UP_Y => UpAxis::Y,
                other => return Err(Failure::not_one_of("params.up", other, "TREE_UP_")),
            },
            unit: self.unit,
            voxel: self.voxel,
            neighbours: self.neighbours,
            bridge: self.bridge,
            ground: self.ground != 0,
            step: self.step,
            merge: self.merge,
            prune: self.prune,
            several: self.several != 0,
            foliage: self.foliage != 0,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scan_params_init(
    params: *mut tree_scan_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scan_params_check(params: *const tree_scan_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust()?.validate()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_come_back_from_c_as_they_went() {
        let back = tree_scan_params::default_value().rust().unwrap();
        assert_eq!(back, ScanParams::default());
    }
}
