//! How a cloud is read.

use crate::error::{Result, check};
use tree_core::UpAxis;

/// How a cloud is read. Lengths are metres; "spacings" are the median distance of a point to its
/// fourth neighbour.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct ScanParams {
    /// The axis that points up. Default [`UpAxis::Z`].
    pub up: UpAxis,
    /// Metres for a unit of the cloud, 1e-6 to 1e6. Default 1.
    pub unit: f64,
    /// Edge of the voxels that become one point each, 0 to 10 m. Default 0: half a spacing.
    pub voxel: f32,
    /// Nearest points that each one is joined with, 4 to 32. Default 8. More bridge thin gaps and run
    /// branches together.
    pub neighbours: u32,
    /// Widest gap that is bridged, as a share of the cloud's size, 0 to 1. Default 0.1. What is farther
    /// away is left out and reported.
    pub bridge: f32,
    /// Whether the ground is taken away where the scan shows some. Default true.
    pub ground: bool,
    /// Distance between nodes in spacings, 1 to 20. Default 2.5.
    pub step: f32,
    /// Reach within which an axis takes in what runs beside it, in its widths (mean distances of its
    /// points from its middle), 1 to 10. Default 2.
    pub merge: f32,
    /// Length in spacings by which a branch must leave the reach of its parent, 0 to 100. Default 4.
    pub prune: f32,
    /// Whether every trunk becomes a tree. Default false: the cloud is one tree, and the report tells
    /// how many trunks it may have.
    pub several: bool,
    /// Whether branches through foliage, which are guessed (see
    /// [`ScannedTree::in_foliage`](super::ScannedTree::in_foliage)), are kept. Default true.
    pub foliage: bool,
}

impl Default for ScanParams {
    fn default() -> Self {
        Self {
            up: UpAxis::Z,
            unit: 1.0,
            voxel: 0.0,
            neighbours: 8,
            bridge: 0.1,
            ground: true,
            step: 2.5,
            merge: 2.0,
            prune: 4.0,
            several: false,
            foliage: true,
        }
    }
}

impl ScanParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("scan.unit", self.unit, 1e-6, 1e6)?;
        check("scan.voxel", self.voxel, 0.0, 10.0)?;
        check("scan.neighbours", self.neighbours, 4.0, 32.0)?;
        check("scan.bridge", self.bridge, 0.0, 1.0)?;
        check("scan.step", self.step, 1.0, 20.0)?;
        check("scan.merge", self.merge, 1.0, 10.0)?;
        check("scan.prune", self.prune, 0.0, 100.0)
    }
}
