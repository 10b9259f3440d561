//! The density that gives the mattes when looked through (Neubert 2012, 3.3).

use super::super::grid::Grid;
use super::super::view::View;
use super::carve::Carved;
use super::minimize::minimize;
use super::params::DensityParams;
use super::system::Equations;
use crate::error::Result;
use rayon::prelude::*;
use tree_core::Control;

/// A view whose rays are missed by more than this contradicts the others.
const CONTRADICTION: f64 = 0.5;

/// How a density came about.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DensityReport {
    /// Rays: equations.
    pub n_rays: u64,
    /// Voxels that were left after carving: unknowns.
    pub n_voxels: u64,
    /// Voxels thrown away by carving.
    pub n_carved: u64,
    /// Voxels that no picture shows.
    pub n_unseen: u64,
    /// Entries of A that are not zero.
    pub n_entries: u64,
    /// Iterations of the solver.
    pub n_iterations: u32,
    /// ‖A x − b‖ / ‖b‖: 0 when looking through the density gives the mattes.
    pub residual: f64,
    /// The same for the rays of each view.
    pub view_residuals: Vec<f64>,
    /// What may be wrong.
    pub warnings: Vec<DensityWarning>,
}

/// What may be wrong with a density.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DensityWarning {
    /// Looking through the density is far from giving this view's matte: the views contradict each other.
    Contradiction {
        /// Index into the views.
        view: usize,
        /// ‖A x − b‖ / ‖b‖ over its rays.
        residual: f64,
    },
    /// Every pixel of this view is covered: its matte says nothing about the tree's outline.
    Opaque {
        /// Index into the views.
        view: usize,
    },
    /// The solver stopped at the most iterations allowed.
    NotConverged,
}

impl std::fmt::Display for DensityWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Contradiction { view, residual } => write!(
                f,
                "views[{view}] contradicts the others: its matte is missed by {:.0} %",
                100.0 * residual
            ),
            Self::Opaque { view } => write!(f, "views[{view}] is covered all over"),
            Self::NotConverged => {
                write!(f, "the density is not final: allow more `density.iterations`")
            }
        }
    }
}

/// Optical density per metre in the voxels that were left: the x ≥ 0 with the least
/// ‖A x − b‖² + λ² ‖W⁻¹ x‖² (see [`Equations`]).
///
/// # Errors
/// As [`Equations::new`].
///
/// # Complexity
/// O(iterations × entries of A).
pub fn solve(
    carved: &Carved,
    views: &[View],
    params: &DensityParams,
    control: &Control,
) -> Result<(Grid, DensityReport)> {
    let system = Equations::new(carved, views, params, control)?;
    let found = minimize(&system, params.iterations, params.tolerance, control)?;
    let mut report = DensityReport {
        n_rays: system.n_rays() as u64,
        n_voxels: system.n_voxels() as u64,
        n_carved: carved.n_carved(),
        n_unseen: carved.n_unseen(),
        n_entries: system.n_entries() as u64,
        n_iterations: found.n_iterations,
        ..DensityReport::default()
    };
    measure(&system, &found.x, &mut report);
    for (view, shown) in views.iter().enumerate() {
        if shown.matte.alpha().iter().all(|&alpha| alpha >= 1.0) {
            report.warnings.push(DensityWarning::Opaque { view });
        }
    }
    if !found.converged {
        report.warnings.push(DensityWarning::NotConverged);
    }
    let shape = carved.alpha();
    let mut grid = Grid::new(shape.corner(), shape.voxel(), shape.size(), &control.limits)?;
    for (&voxel, &density) in carved.voxels().iter().zip(&found.x) {
        grid.values_mut()[voxel as usize] = density;
    }
    Ok((grid, report))
}

/// Residuals, and warnings where they are large.
fn measure(system: &Equations, x: &[f32], report: &mut DensityReport) {
    let missed: Vec<f64> = (0..system.n_rays())
        .into_par_iter()
        .map(|ray| {
            let (columns, lengths) = system.row(ray);
            let sum: f32 = columns.iter().zip(lengths).map(|(&c, l)| l * x[c as usize]).sum();
            f64::from(sum - system.targets()[ray])
        })
        .collect();
    let squares = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
    let (mut all_missed, mut all) = (0.0, 0.0);
    for (view, range) in system.view_starts.windows(2).enumerate() {
        let (rays, lost) = (range[0]..range[1], system.unexplained[view]);
        let wanted = system.targets()[rays.clone()].iter().map(|&b| f64::from(b));
        let wanted = squares(&mut wanted.into_iter()) + lost;
        let missed = squares(&mut missed[rays].iter().copied()) + lost;
        let residual = if wanted > 0.0 { (missed / wanted).sqrt() } else { 0.0 };
        report.view_residuals.push(residual);
        if residual > CONTRADICTION {
            report.warnings.push(DensityWarning::Contradiction { view, residual });
        }
        (all_missed, all) = (all_missed + missed, all + wanted);
    }
    report.residual = if all > 0.0 { (all_missed / all).sqrt() } else { 0.0 };
}
