//! What a branch is worth, and the paths that come of it.

use super::adt::tree_adt;
use super::there;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, free, get, init, out,
    out_value, read_or_default, slice, tree_status,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use std::ptr::null;
use std::sync::Arc;
use tree_lod::multires::{Adt, Metric, Paths, paths};
use tree_model::tree_core::{Limits, Resource, Seed};

/// What a branch is worth: one of the `TREE_METRIC_` constants.
pub type tree_metric = u32;

/// Length of the branch and of all that it bears; what has been put into a path does not count any more. What the paper
/// prefers.
pub const TREE_METRIC_BRANCHING_LENGTH: u32 = 0;
/// As `TREE_METRIC_BRANCHING_LENGTH`, with worths of your own in the place of lengths: areas of wood, numbers of leaves.
pub const TREE_METRIC_BRANCHING: u32 = 1;
/// Number of children.
pub const TREE_METRIC_CHILDREN: u32 = 2;
/// Number of descendants.
pub const TREE_METRIC_DESCENDANTS: u32 = 3;
/// Longest way to a tip, the branch itself included.
pub const TREE_METRIC_LONGEST_PATH: u32 = 4;
/// As derivations are undone: branches of low order first, siblings in the order of the chain. For comparison.
pub const TREE_METRIC_GENERATION: u32 = 5;
/// Any branch whose parent is there, by chance. For comparison.
pub const TREE_METRIC_RANDOM: u32 = 6;
/// Area of a branch and of what it bears, for each branch that has to be drawn for it. The default.
pub const TREE_METRIC_DENSITY: u32 = 7;
/// As `TREE_METRIC_DENSITY`, with worths of your own in the place of areas.
pub const TREE_METRIC_DENSITY_OF: u32 = 8;

/// How branches are compared. Begin with `tree_metric_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_metric_params {
    /// `sizeof(tree_metric_params)`.
    pub struct_size: usize,
    /// For `TREE_METRIC_BRANCHING` and `TREE_METRIC_DENSITY_OF`: one for each branch, as `tree_adt_view` lists them, 0 to
    /// 1e30. NULL, the default, for all others.
    pub worths: *const f64,
    /// Number of worths: the number of branches, or 0 for the default.
    pub n_worths: usize,
    /// What a branch is worth: a `TREE_METRIC_` constant. Default `TREE_METRIC_DENSITY`.
    pub metric: tree_metric,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_metric_params {
    const NAME: &'static str = "tree_metric_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            worths: null(),
            n_worths: 0,
            metric: TREE_METRIC_DENSITY,
            reserved: 0,
        }
    }
}

/// The caller's metric; NULL is the default.
pub(crate) unsafe fn metric(
    params: *const tree_metric_params,
    seed: u64,
    limits: &Limits,
) -> Result<Metric> {
    let given = unsafe { read_or_default(params, "params") }?;
    let (n, rows) = (given.n_worths, Resource::Modules);
    let worths = unsafe { slice(given.worths, n, limits, rows, "params.worths") }?;
    if n > 0 && ![TREE_METRIC_BRANCHING, TREE_METRIC_DENSITY_OF].contains(&given.metric) {
        let text =
            "params.n_worths: worths are for TREE_METRIC_BRANCHING and TREE_METRIC_DENSITY_OF";
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    Ok(match given.metric {
        TREE_METRIC_BRANCHING_LENGTH => Metric::BranchingLength,
        TREE_METRIC_BRANCHING => Metric::Branching(worths.to_vec()),
        TREE_METRIC_CHILDREN => Metric::Children,
        TREE_METRIC_DESCENDANTS => Metric::Descendants,
        TREE_METRIC_LONGEST_PATH => Metric::LongestPath,
        TREE_METRIC_GENERATION => Metric::Generation,
        TREE_METRIC_RANDOM => Metric::Random(Seed(seed)),
        TREE_METRIC_DENSITY => Metric::Density,
        TREE_METRIC_DENSITY_OF => Metric::DensityOf(worths.to_vec()),
        other => return Err(Failure::not_one_of("params.metric", other, "TREE_METRIC_")),
    })
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metric_params_init(
    params: *mut tree_metric_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// All branches, cut into paths: each begins at the root, or stems from a path before it. The first few show the
/// tree's structure best.
pub struct tree_multi_paths {
    adt: Arc<Adt>,
    paths: Paths,
}

impl Handle for tree_multi_paths {
    const NAME: &'static str = "tree_multi_paths";
}

impl tree_multi_paths {
    pub(super) fn rust(&self) -> (&Adt, &Paths) {
        (&self.adt, &self.paths)
    }
}

/// Cuts branches into paths and sorts them, the most relevant first. `params` may be NULL for the default metric. `seed` matters to
/// `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free the paths with `tree_multi_paths_free`.
///
/// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_paths_new(
    adt: *const tree_adt,
    params: *const tree_metric_params,
    seed: u64,
    control: *const tree_control,
    paths: *mut *mut tree_multi_paths,
) -> tree_status {
    call(|| {
        let place = unsafe { out(paths, "paths") }?;
        let adt = unsafe { get(adt, "adt") }?.rust();
        let metric = unsafe { metric(params, seed, &limits(control)?) }?;
        let body = |control: &_| Ok(self::paths(adt, &metric, control)?);
        let paths = unsafe { run(control, body) }?;
        place.put(tree_multi_paths { adt: adt.clone(), paths });
        Ok(())
    })
}

/// Number of paths: of levels of detail, at least 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_paths_count(
    paths: *const tree_multi_paths,
    n_paths: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(paths, "paths") }?.paths.len();
        unsafe { out_value(n_paths, n, "n_paths") }
    })
}

/// Views the branches of all paths one after another; those of the first few paths are a prefix.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_paths_branches(
    paths: *const tree_multi_paths,
    branches: *mut *const u32,
    n_branches: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(paths, "paths") }?.paths.branches();
        unsafe { out_value(branches, column(found), "branches") }?;
        unsafe { out_value(n_branches, found.len(), "n_branches") }
    })
}

/// Views the branches of one path, from its fork up. `TREE_ERROR_PARAMETER` when there is no such path.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_paths_path(
    paths: *const tree_multi_paths,
    number: usize,
    branches: *mut *const u32,
    n_branches: *mut usize,
) -> tree_status {
    call(|| {
        let paths = &unsafe { get(paths, "paths") }?.paths;
        there("number", number, paths.len(), "paths")?;
        let found = paths.path(number);
        unsafe { out_value(branches, column(found), "branches") }?;
        unsafe { out_value(n_branches, found.len(), "n_branches") }
    })
}

/// Frees the paths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_paths_free(paths: *mut tree_multi_paths) -> tree_status {
    call(|| unsafe { free(paths, "paths") })
}
