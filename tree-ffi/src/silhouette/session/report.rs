//! What became of a drawing.

use crate::border::Versioned;
use tree_model::silhouette::session::PlayReport;

/// What became of a drawing's strokes. `tree_silhouette_session_repairs` and `tree_silhouette_session_refused` tell more. Set
/// `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_play_report {
    /// `sizeof(tree_silhouette_play_report)`.
    pub struct_size: usize,
    /// Repairs of strokes.
    pub n_repairs: u64,
    /// Strokes that could not be used.
    pub n_refused: u64,
    /// Strokes that were used.
    pub n_strokes: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_silhouette_play_report {
    const NAME: &'static str = "tree_silhouette_play_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PlayReport::default())
    }
}

impl tree_silhouette_play_report {
    pub(in crate::silhouette) fn of(report: &PlayReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_repairs: report.repairs.len() as u64,
            n_refused: report.refused.len() as u64,
            n_strokes: report.strokes,
            reserved: 0,
        }
    }
}
