//! What a tree from photographs came of.

use crate::border::Versioned;
use crate::particle::density::rows;
use crate::particle::{tree_crown_report, tree_density_report, tree_flow_report};
use crate::photo::{TREE_ALIGN_WARNINGS, tree_align_warning};
use tree_model::particle::session::PhotoReport;

/// What was found, repaired and left out on the way from photographs to a tree. The fields that begin with
/// `density_`, `flow_` and `crown_` are those of `tree_density_report`, `tree_flow_report` and
/// `tree_crown_report`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_report {
    /// `sizeof(tree_photo_report)`.
    pub struct_size: usize,
    /// Number of views.
    pub n_views: u64,
    /// Number of lines that `tree_photo_session_warnings` gives.
    pub n_warnings: u64,
    /// Radius of the trunk that the views show, in metres; 0 where they show no bare trunk.
    pub trunk_radius: f32,
    /// Height in metres below which no view shows more than the trunk.
    pub crown_base: f32,
    /// Rays: equations.
    pub density_rays: u64,
    /// Voxels that were left after carving: unknowns.
    pub density_voxels: u64,
    /// Voxels thrown away by carving.
    pub density_carved: u64,
    /// Voxels that no picture shows.
    pub density_unseen: u64,
    /// Entries of the system of equations that are not zero.
    pub density_entries: u64,
    /// What looking through the density misses of the mattes, as a share.
    pub density_residual: f64,
    /// Iterations of the solver.
    pub density_iterations: u32,
    /// 1 when the density is not final.
    pub density_not_converged: u32,
    /// Views that contradict the others.
    pub density_contradictions: u32,
    /// Views that are covered all over.
    pub density_opaque: u32,
    /// Parts that the integrator cut all steps of all particles into.
    pub flow_parts: u64,
    /// Particles that started.
    pub flow_particles: u32,
    /// Joins of two particles.
    pub flow_joins: u32,
    /// Particles that joined a trace whose particle had gone on.
    pub flow_followed: u32,
    /// Particles, after joins, that reached the base on traces of their own.
    pub flow_arrived: u32,
    /// Particles that were steered to the base after all steps.
    pub flow_steered: u32,
    /// Particles that were led straight to the nearest trace.
    pub flow_led: u32,
    /// Steps taken.
    pub flow_steps: u32,
    /// 0.
    pub reserved: u32,
    /// Nodes of twigs.
    pub crown_twig_nodes: u64,
    /// Nodes of twigs cut off because they reached where a picture is empty.
    pub crown_twig_nodes_cut: u64,
    /// Leaves (blades) that stayed.
    pub crown_leaves: u64,
    /// Leaves discarded because a picture is empty there.
    pub crown_leaves_discarded: u64,
    /// Leaves the pictures ask for, as far as the last correction knows.
    pub crown_leaves_asked: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_photo_report {
    const NAME: &'static str = "tree_photo_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PhotoReport::default())
    }
}

impl tree_photo_report {
    pub(super) fn of(report: &PhotoReport) -> Self {
        let density = tree_density_report::of(&report.density);
        let flow = tree_flow_report::of(&report.flow);
        let crown = tree_crown_report::of(&report.crown);
        Self {
            struct_size: size_of::<Self>(),
            n_views: report.views.len() as u64,
            n_warnings: report.warnings().len() as u64,
            trunk_radius: report.trunk_radius.unwrap_or(0.0),
            crown_base: report.crown_base,
            density_rays: density.n_rays,
            density_voxels: density.n_voxels,
            density_carved: density.n_carved,
            density_unseen: density.n_unseen,
            density_entries: density.n_entries,
            density_residual: density.residual,
            density_iterations: density.n_iterations,
            density_not_converged: density.not_converged,
            density_contradictions: density.n_contradictions,
            density_opaque: density.n_opaque,
            flow_parts: flow.n_parts,
            flow_particles: flow.n_particles,
            flow_joins: flow.n_joins,
            flow_followed: flow.n_followed,
            flow_arrived: flow.n_arrived,
            flow_steered: flow.n_steered,
            flow_led: flow.n_led,
            flow_steps: flow.n_steps,
            reserved: 0,
            crown_twig_nodes: crown.n_twig_nodes,
            crown_twig_nodes_cut: crown.n_twig_nodes_cut,
            crown_leaves: crown.n_leaves,
            crown_leaves_discarded: crown.n_leaves_discarded,
            crown_leaves_asked: crown.leaves_asked,
        }
    }
}

/// What one view gave.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_view_report {
    /// `sizeof(tree_photo_view_report)`.
    pub struct_size: usize,
    /// What looking through the density misses of the view's matte, as a share; 0 where the density came
    /// from elsewhere.
    pub residual: f64,
    /// 1 when the view contradicts the others.
    pub contradicts: u32,
    /// 1 when the view is covered all over.
    pub is_opaque: u32,
    /// What its alignment is doubtful about: rows of `warnings`. 0 where the caller placed the camera.
    pub n_warnings: u32,
    /// 1 when the view gives directions: not without branches.
    pub attracts: u32,
    /// 1 when livewire sought branches, and the fields from here to `trunk_width` count.
    pub has_livewire: u32,
    /// Seeds that were not finite and left out.
    pub n_bad_seeds: u32,
    /// Seeds outside the picture, moved to its border.
    pub n_moved_seeds: u32,
    /// Side branches left out as stubs.
    pub n_stubs: u32,
    /// Tips of the graph.
    pub n_tips: u32,
    /// Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
    pub outside: f32,
    /// How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
    pub evidence: f32,
    /// Width of the trunk at its foot in pixels; 0 where no trunk is seen.
    pub trunk_width: f32,
    /// 1 when strokes were joined, and the fields after it count.
    pub has_strokes: u32,
    /// Points left out because they were not finite.
    pub n_bad_points: u32,
    /// Strokes left out because they had no length.
    pub n_empty: u32,
    /// Strokes that were joined over a gap wider than the snapping distance.
    pub n_bridged: u32,
    /// Strokes joined by their middle, in two parts.
    pub n_split: u32,
    /// Doubts about its alignment, the first `n_warnings` rows.
    pub warnings: [tree_align_warning; TREE_ALIGN_WARNINGS],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_photo_view_report {
    const NAME: &'static str = "tree_photo_view_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PhotoReport::default(), 0)
    }
}

impl tree_photo_view_report {
    pub(super) fn of(report: &PhotoReport, view: usize) -> Self {
        let own = report.views.get(view).cloned().unwrap_or_default();
        let fit = rows(&report.density).get(view).copied();
        let wire = own.livewire.unwrap_or_default();
        let strokes = own.strokes.clone().unwrap_or_default();
        let mut warnings = [tree_align_warning::default(); TREE_ALIGN_WARNINGS];
        for (row, warning) in warnings.iter_mut().zip(&own.warnings) {
            *row = tree_align_warning::of(warning);
        }
        Self {
            struct_size: size_of::<Self>(),
            residual: fit.map_or(0.0, |fit| fit.residual),
            contradicts: fit.map_or(0, |fit| fit.contradicts),
            is_opaque: fit.map_or(0, |fit| fit.is_opaque),
            n_warnings: own.warnings.len().min(TREE_ALIGN_WARNINGS) as u32,
            attracts: own.attracts.into(),
            has_livewire: own.livewire.is_some().into(),
            n_bad_seeds: wire.n_bad_seeds,
            n_moved_seeds: wire.n_moved_seeds,
            n_stubs: wire.n_stubs,
            n_tips: wire.n_tips,
            outside: wire.outside,
            evidence: wire.evidence,
            trunk_width: wire.trunk_width,
            has_strokes: own.strokes.is_some().into(),
            n_bad_points: strokes.n_bad_points,
            n_empty: strokes.n_empty,
            n_bridged: strokes.n_bridged,
            n_split: strokes.n_split,
            warnings,
            reserved: 0,
        }
    }
}
