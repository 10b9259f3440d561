//! What was found in a mesh.

use crate::border::Versioned;
use tree_model::skeletonize::SkeletonizeReport;

/// Leaf widths in a report: those of the first kinds.
pub const TREE_SKELETONIZE_LEAF_WIDTHS: usize = 256;

/// What was found in a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_skeletonize_report {
    /// `sizeof(tree_skeletonize_report)`.
    pub struct_size: usize,
    /// Triangles of all parts.
    pub n_triangles: u64,
    /// Triangles without area after welding, and second ones at one place in a part.
    pub n_degenerate: u64,
    /// Triangles of wood.
    pub n_wood_triangles: u64,
    /// Connected pieces of wood.
    pub n_pieces: u64,
    /// Pieces of wood too far from all others, left out.
    pub n_left_out: u64,
    /// Bumps of the bark dropped.
    pub n_bumps: u64,
    /// Branches cut where they had grown together.
    pub n_cut: u64,
    /// Leaves made.
    pub n_leaves: u64,
    /// Closed bodies of leaves, for which nothing was made.
    pub n_blobs: u64,
    /// Number of leaf kinds.
    pub n_leaf_kinds: u64,
    /// Mean width of each leaf kind as a share of its length: of the first
    /// `TREE_SKELETONIZE_LEAF_WIDTHS` kinds; `tree_found_leaves_view` has them all.
    pub leaf_widths: [f32; TREE_SKELETONIZE_LEAF_WIDTHS],
    /// Share of the wood's surface that the skeleton stands for, 0 to 1.
    pub covered: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_skeletonize_report {
    const NAME: &'static str = "tree_skeletonize_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SkeletonizeReport::default())
    }
}

impl tree_skeletonize_report {
    pub(super) fn of(report: &SkeletonizeReport) -> Self {
        let mut leaf_widths = [0.0; TREE_SKELETONIZE_LEAF_WIDTHS];
        for (place, &width) in leaf_widths.iter_mut().zip(&report.leaf_widths) {
            *place = width;
        }
        Self {
            struct_size: size_of::<Self>(),
            n_triangles: report.n_triangles as u64,
            n_degenerate: report.n_degenerate as u64,
            n_wood_triangles: report.n_wood_triangles as u64,
            n_pieces: report.n_pieces as u64,
            n_left_out: report.n_left_out as u64,
            n_bumps: report.n_bumps as u64,
            n_cut: report.n_cut as u64,
            n_leaves: report.n_leaves as u64,
            n_blobs: report.n_blobs as u64,
            n_leaf_kinds: report.leaf_widths.len() as u64,
            leaf_widths,
            covered: report.covered,
            reserved: 0,
        }
    }
}
