//! A tree, read so that it can react.

use super::params::tree_plastic_params;
use crate::border::{
    Handle, Versioned, call, foresee, free, get, out, read_or_default, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::tree::tree_tree;
use glam::Vec3;
use std::sync::{Arc, OnceLock};
use tree_model::plastic::{PlasticReport, PlasticTree};

/// A tree, read so that it can react: its main branches with the seasons in which they grew, its leaf clusters in every
/// season and the light they had, what its branches would be without tropisms, and on how little light they live. Made
/// once, and planted as often as you like.
pub struct tree_plastic {
    model: Arc<PlasticTree>,
    /// Made when they are first looked at.
    columns: OnceLock<Columns>,
}

struct Columns {
    seasons: Vec<u16>,
    directions: Vec<Vec3>,
    factors: Vec<f32>,
}

impl Handle for tree_plastic {
    const NAME: &'static str = "tree_plastic";
}

impl tree_plastic {
    pub(super) fn new(model: Arc<PlasticTree>) -> Self {
        Self { model, columns: OnceLock::new() }
    }

    pub(super) fn rust(&self) -> &Arc<PlasticTree> {
        &self.model
    }

    fn columns(&self) -> &Columns {
        self.columns.get_or_init(|| Columns {
            seasons: self.model.seasons(),
            directions: self.model.own_directions(),
            factors: self
                .model
                .pruning_factors()
                .into_iter()
                .map(|factor| factor.unwrap_or(-1.0))
                .collect(),
        })
    }
}

/// What was found in a tree.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_report {
    /// `sizeof(tree_plastic_report)`.
    pub struct_size: usize,
    /// Nodes of the main branches.
    pub n_main_nodes: u64,
    /// Nodes that follow them.
    pub n_branchlet_nodes: u64,
    /// Leaf clusters of the last season.
    pub n_clusters: u64,
    /// Seasons the tree lived.
    pub n_seasons: u32,
    /// Length of an internode in metres.
    pub internode: f32,
    /// How far the middle of the crown leans from above the base, in radians.
    pub lean: f32,
    /// 1 where it leans so far that it cannot have grown alone in the open: a warning. The analysis takes a tree for one
    /// that did, and so this one keeps its lean whatever it reacts to. Else 0.
    pub already_bent: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_report {
    const NAME: &'static str = "tree_plastic_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PlasticReport::default())
    }
}

impl tree_plastic_report {
    fn of(report: &PlasticReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_main_nodes: report.n_main_nodes.into(),
            n_branchlet_nodes: report.n_branchlet_nodes.into(),
            n_clusters: report.n_clusters.into(),
            n_seasons: report.n_seasons,
            internode: report.internode,
            lean: report.lean,
            already_bent: report.already_bent.into(),
        }
    }
}

/// A view of what is known of each node of a tree that can react.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_columns {
    /// `sizeof(tree_plastic_columns)`.
    pub struct_size: usize,
    /// Number of nodes of the tree's skeleton.
    pub n_nodes: usize,
    /// A byte for each node: 1 for main branches, 0 for branchlets, which follow the main branch below.
    pub is_main: *const u8,
    /// One for each node: the season in which it grew, from 0; that of the main branch below for branchlets.
    pub seasons: *const u16,
    /// Three floats for each node: the direction in which its segment would have grown without tropisms, of length 1 or
    /// more; that of the main branch below for branchlets.
    pub own_directions: *const f32,
    /// One for each node: the least light per metre on which the branch that starts there is known to live; -1 where no
    /// branch starts that could be pruned.
    pub pruning_factors: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_plastic_columns {
    const NAME: &'static str = "tree_plastic_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            is_main: std::ptr::null(),
            seasons: std::ptr::null(),
            own_directions: std::ptr::null(),
            pruning_factors: std::ptr::null(),
        }
    }
}

/// Analyses a tree, which should have grown alone in the open, and is copied. `params`, `control` and `report` may be
/// NULL; see `already_bent` of the report. A few milliseconds for ten thousand nodes; the time grows with the square of
/// the number of leaf clusters. Free it with `tree_plastic_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_new(
    tree: *const tree_tree,
    params: *const tree_plastic_params,
    control: *const tree_control,
    report: *mut tree_plastic_report,
    plastic: *mut *mut tree_plastic,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plastic, "plastic") }?;
        unsafe { foresee(report, "report") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(PlasticTree::new(tree.clone(), &params, control)?);
        let model = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_plastic_report::of(model.report())) }?;
        place.put(tree_plastic::new(Arc::new(model)));
        Ok(())
    })
}

/// What was found in the tree. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_measure(
    plastic: *const tree_plastic,
    report: *mut tree_plastic_report,
) -> tree_status {
    call(|| {
        let model = unsafe { get(plastic, "plastic") }?.rust();
        unsafe { write(report, "report", &tree_plastic_report::of(model.report())) }
    })
}

/// How the tree was analysed. Set `params->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_get_params(
    plastic: *const tree_plastic,
    params: *mut tree_plastic_params,
) -> tree_status {
    call(|| {
        let model = unsafe { get(plastic, "plastic") }?.rust();
        unsafe { write(params, "params", &tree_plastic_params::of(model.params())) }
    })
}

/// A copy of the tree as it came in. Free it with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_tree(
    plastic: *const tree_plastic,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let model = unsafe { get(plastic, "plastic") }?.rust();
        place.put(tree_tree::new(model.tree().clone()));
        Ok(())
    })
}

/// Views what is known of each node. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_view(
    plastic: *const tree_plastic,
    columns: *mut tree_plastic_columns,
) -> tree_status {
    call(|| {
        let plastic = unsafe { get(plastic, "plastic") }?;
        let found = plastic.columns();
        let is_main = plastic.model.is_main();
        let value = tree_plastic_columns {
            n_nodes: is_main.len(),
            // A bool is a byte, 0 or 1.
            is_main: column(is_main).cast(),
            seasons: column(&found.seasons),
            own_directions: column(&found.directions).cast(),
            pruning_factors: column(&found.factors),
            ..tree_plastic_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees a tree that can react. Scenes in which it is planted go on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_free(plastic: *mut tree_plastic) -> tree_status {
    call(|| unsafe { free(plastic, "plastic") })
}
