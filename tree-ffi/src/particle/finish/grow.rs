//! From traces to a tree.

use super::params::tree_finish_params;
use crate::border::{
    Result, Versioned, call, foresee, get, out, read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::particle::flow::tree_traces;
use crate::particle::grid::tree_grid;
use crate::particle::view::{tree_particle_view, views};
use crate::skeleton::tree_skeleton;
use crate::tree::tree_tree;
use tree_model::particle::finish::{CrownReport, FinishParams, grow_crown, grow_wood};
use tree_model::tree_core::Seed;

/// What growing twigs and leaves did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_crown_report {
    /// `sizeof(tree_crown_report)`.
    pub struct_size: usize,
    /// Nodes of twigs.
    pub n_twig_nodes: u64,
    /// Nodes of twigs cut off because they reached where a picture is empty.
    pub n_twig_nodes_cut: u64,
    /// Leaves (blades) that stayed.
    pub n_leaves: u64,
    /// Leaves discarded because a picture is empty there.
    pub n_leaves_discarded: u64,
    /// Leaves the pictures ask for, as far as the last correction knows.
    pub leaves_asked: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_crown_report {
    const NAME: &'static str = "tree_crown_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&CrownReport::default())
    }
}

impl tree_crown_report {
    pub(in crate::particle) fn of(report: &CrownReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_twig_nodes: report.n_twig_nodes,
            n_twig_nodes_cut: report.n_twig_nodes_cut,
            n_leaves: report.n_leaves,
            n_leaves_discarded: report.n_leaves_discarded,
            leaves_asked: report.leaves_asked,
        }
    }
}

unsafe fn finish_params(params: *const tree_finish_params) -> Result<FinishParams> {
    let params = unsafe { read_or_default(params, "params")?.rust("params") }?;
    params.validate()?;
    Ok(params)
}

/// The tree's branches without twigs: traces thinned, smoothed, and as thick as the pipe model has it.
/// `height` is the tree's, `trunk_radius` what the pictures show of the trunk, both in metres; 0 where they
/// show none. `params` may be NULL for an oak. Free the skeleton with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_traces_grow_wood(
    traces: *const tree_traces,
    height: f32,
    trunk_radius: f32,
    params: *const tree_finish_params,
    control: *const tree_control,
    wood: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(wood, "wood") }?;
        let traces = unsafe { get(traces, "traces") }?.rust();
        let params = unsafe { finish_params(params) }?;
        let trunk = (trunk_radius != 0.0).then_some(trunk_radius);
        let body = |control: &_| Ok(grow_wood(traces, height, trunk, &params, control)?);
        place.put(tree_skeleton::own(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Grows twigs and leaves on branches, as many as the density and `n_views` views ask for and none where
/// those are empty. `height` is the tree's in metres. `params` may be NULL for an oak; the same `seed` gives
/// the same tree. `control` and `report` may be NULL. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_grow_crown(
    wood: *const tree_skeleton,
    density: *const tree_grid,
    views: *const tree_particle_view,
    n_views: usize,
    height: f32,
    params: *const tree_finish_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_crown_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let wood = unsafe { get(wood, "wood") }?.rust();
        let density = unsafe { get(density, "density") }?.rust();
        let views = unsafe { self::views(views, n_views) }?;
        let params = unsafe { finish_params(params) }?;
        let body = |control: &_| {
            Ok(grow_crown(wood, density, &views, height, &params, Seed(seed), control)?)
        };
        let (tree, told) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_crown_report::of(&told)) }?;
        place.put(tree_tree::new(tree));
        Ok(())
    })
}
