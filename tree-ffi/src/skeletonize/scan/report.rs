//! What became of a cloud.

use crate::border::Versioned;
use tree_model::skeletonize::ScanReport;

/// What was found in a cloud of points, and what was left out.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scan_report {
    /// `sizeof(tree_scan_report)`.
    pub struct_size: usize,
    /// Points that came in.
    pub n_points: u64,
    /// Points that were no numbers.
    pub n_not_finite: u64,
    /// Second points at one place.
    pub n_doubles: u64,
    /// Points that became one with others in their voxel.
    pub n_thinned: u64,
    /// Points of the ground.
    pub n_ground: u64,
    /// Points of pieces that no bridge reached.
    pub n_left_out: u64,
    /// Gaps bridged: `tree_scanned_bridge` tells of each.
    pub n_bridges: u64,
    /// Places where a tree may stand.
    pub n_bases: u64,
    /// Clusters of points that the levels fell into.
    pub n_clusters: u64,
    /// Side shoots too short for an axis.
    pub n_short: u64,
    /// Nodes of all trees.
    pub n_nodes: u64,
    /// Nodes whose radius and centre come from a circle fitted to the points; the radii of all others are guessed from
    /// the wood beyond.
    pub n_fitted: u64,
    /// Nodes in foliage, kept or not.
    pub n_in_foliage: u64,
    /// Median distance to the fourth neighbour in metres.
    pub spacing: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_scan_report {
    const NAME: &'static str = "tree_scan_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&ScanReport::default())
    }
}

impl tree_scan_report {
    pub(super) fn of(report: &ScanReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: report.n_points as u64,
            n_not_finite: report.n_not_finite as u64,
            n_doubles: report.n_doubles as u64,
            n_thinned: report.n_thinned as u64,
            n_ground: report.n_ground as u64,
            n_left_out: report.n_left_out as u64,
            n_bridges: report.bridges.len() as u64,
            n_bases: report.n_bases as u64,
            n_clusters: report.n_clusters as u64,
            n_short: report.n_short as u64,
            n_nodes: report.n_nodes as u64,
            n_fitted: report.n_fitted as u64,
            n_in_foliage: report.n_in_foliage as u64,
            spacing: report.spacing,
            reserved: 0,
        }
    }
}
