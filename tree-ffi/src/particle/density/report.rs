//! How a density came about.

use crate::border::Versioned;
use tree_model::particle::density::{DensityReport, DensityWarning};

/// How a density came about.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_density_report {
    /// `sizeof(tree_density_report)`.
    pub struct_size: usize,
    /// Rays: equations.
    pub n_rays: u64,
    /// Voxels that were left after carving: unknowns.
    pub n_voxels: u64,
    /// Voxels thrown away by carving.
    pub n_carved: u64,
    /// Voxels that no picture shows.
    pub n_unseen: u64,
    /// Entries of the system of equations that are not zero.
    pub n_entries: u64,
    /// What looking through the density misses of the mattes, as a share: 0 when it gives them exactly.
    pub residual: f64,
    /// Iterations of the solver.
    pub n_iterations: u32,
    /// 1 when the solver stopped at the most iterations allowed, and the density is not final.
    pub not_converged: u32,
    /// Views that contradict the others.
    pub n_contradictions: u32,
    /// Views that are covered all over, and say nothing about the tree's outline.
    pub n_opaque: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_density_report {
    const NAME: &'static str = "tree_density_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&DensityReport::default())
    }
}

/// How one view fits a density.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_density_view {
    /// What looking through the density misses of the view's matte, as a share: 0 when it gives it exactly.
    pub residual: f64,
    /// 1 when the view contradicts the others.
    pub contradicts: u32,
    /// 1 when the view is covered all over, and says nothing about the tree's outline.
    pub is_opaque: u32,
}

impl tree_density_report {
    pub(crate) fn of(report: &DensityReport) -> Self {
        let rows = rows(report);
        let count = |of: fn(&tree_density_view) -> u32| rows.iter().map(of).sum();
        Self {
            struct_size: size_of::<Self>(),
            n_rays: report.n_rays,
            n_voxels: report.n_voxels,
            n_carved: report.n_carved,
            n_unseen: report.n_unseen,
            n_entries: report.n_entries,
            residual: report.residual,
            n_iterations: report.n_iterations,
            not_converged: report.warnings.contains(&DensityWarning::NotConverged).into(),
            n_contradictions: count(|row| row.contradicts),
            n_opaque: count(|row| row.is_opaque),
        }
    }
}

/// A row for each view.
pub(crate) fn rows(report: &DensityReport) -> Vec<tree_density_view> {
    let row = |&residual: &f64| tree_density_view { residual, contradicts: 0, is_opaque: 0 };
    let mut rows: Vec<tree_density_view> = report.view_residuals.iter().map(row).collect();
    for warning in &report.warnings {
        match *warning {
            DensityWarning::Contradiction { view, .. } => {
                if let Some(row) = rows.get_mut(view) {
                    row.contradicts = 1;
                }
            }
            DensityWarning::Opaque { view } => {
                if let Some(row) = rows.get_mut(view) {
                    row.is_opaque = 1;
                }
            }
            // Of the whole, or too new to have a field.
            _ => {}
        }
    }
    rows
}
