//! A tree of a scene as it is today.

use super::scene::{lock, tree_plastic_scene};
use crate::border::{Handle, Versioned, call, foresee, free, get, out, tree_status, view, write};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::tree::tree_tree;
use std::sync::Arc;
use tree_model::plastic::{Adapted, AdaptedReport, TreeId};
use tree_model::tree_core::Tree;

/// In `tree_adapted_columns.died`: the node's branch lives.
pub const TREE_PLASTIC_ALIVE: u32 = 0xFFFF_FFFF;

/// A tree of a scene as it was when it was asked for, with branchlets and leaves, and what became of the input's nodes.
pub struct tree_adapted {
    tree: Arc<Tree>,
    source: Vec<u32>,
    moved: Vec<f32>,
    died: Vec<u32>,
}

impl Handle for tree_adapted {
    const NAME: &'static str = "tree_adapted";
}

impl tree_adapted {
    fn new(adapted: Adapted) -> Self {
        let died = adapted.died.iter().map(|died| died.map_or(TREE_PLASTIC_ALIVE, u32::from));
        Self {
            died: died.collect(),
            tree: Arc::new(adapted.tree),
            source: adapted.source,
            moved: adapted.moved,
        }
    }
}

/// What happened to a tree.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_adapted_report {
    /// `sizeof(tree_adapted_report)`.
    pub struct_size: usize,
    /// Main nodes that died.
    pub n_pruned: u64,
    /// Nodes of branchlets left out, with their branch, in the dark, or in a solid.
    pub n_branchlets_dropped: u64,
    /// Nodes of branchlets set once more in the light.
    pub n_branchlets_added: u64,
    /// Leaves left out.
    pub n_leaves_dropped: u64,
    /// Leaves set once more.
    pub n_leaves_added: u64,
    /// Farthest that a living node moved, in metres.
    pub farthest: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_adapted_report {
    const NAME: &'static str = "tree_adapted_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&AdaptedReport::default())
    }
}

impl tree_adapted_report {
    fn of(report: &AdaptedReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_pruned: report.n_pruned.into(),
            n_branchlets_dropped: report.n_branchlets_dropped.into(),
            n_branchlets_added: report.n_branchlets_added.into(),
            n_leaves_dropped: report.n_leaves_dropped.into(),
            n_leaves_added: report.n_leaves_added.into(),
            farthest: report.farthest,
            reserved: 0,
        }
    }
}

/// A view of what became of the nodes of the input.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_adapted_columns {
    /// `sizeof(tree_adapted_columns)`.
    pub struct_size: usize,
    /// Number of nodes of the tree.
    pub n_nodes: usize,
    /// One for each node of the tree: the node of the input that it comes from.
    pub source: *const u32,
    /// Number of nodes of the input.
    pub n_input_nodes: usize,
    /// One for each node of the input: how far it moved, in metres; for those that are gone, how far they would have.
    pub moved: *const f32,
    /// One for each node of the input: the season in which its branch died, or `TREE_PLASTIC_ALIVE`.
    pub died: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_adapted_columns {
    const NAME: &'static str = "tree_adapted_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            source: std::ptr::null(),
            n_input_nodes: 0,
            moved: std::ptr::null(),
            died: std::ptr::null(),
        }
    }
}

/// A tree of a scene as of the last update. In the surroundings that it grew in it is the input, bit for bit. `control` and
/// `report` may be NULL. Free it with `tree_adapted_free`. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_adapted(
    scene: *const tree_plastic_scene,
    id: u64,
    control: *const tree_control,
    report: *mut tree_adapted_report,
    adapted: *mut *mut tree_adapted,
) -> tree_status {
    call(|| {
        let place = unsafe { out(adapted, "adapted") }?;
        unsafe { foresee(report, "report") }?;
        let held = unsafe { lock(scene) }?;
        let scene = &held.scene;
        let found = unsafe { run(control, |control| Ok(scene.adapted(TreeId(id), control)?)) }?;
        unsafe { view(report, "report", &tree_adapted_report::of(&found.report)) }?;
        place.put(tree_adapted::new(found));
        Ok(())
    })
}

/// The tree, in its own frame, not copied: `tree_plastic_scene_pose` says where it stands. Free it with `tree_tree_free`; it
/// may outlive what it was asked of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adapted_tree(
    adapted: *const tree_adapted,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        place.put(tree_tree::shared(unsafe { get(adapted, "adapted") }?.tree.clone()));
        Ok(())
    })
}

/// Views what became of the input's nodes. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adapted_view(
    adapted: *const tree_adapted,
    columns: *mut tree_adapted_columns,
) -> tree_status {
    call(|| {
        let adapted = unsafe { get(adapted, "adapted") }?;
        let value = tree_adapted_columns {
            n_nodes: adapted.source.len(),
            source: column(&adapted.source),
            n_input_nodes: adapted.moved.len(),
            moved: column(&adapted.moved),
            died: column(&adapted.died),
            ..tree_adapted_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees an adapted tree. Trees handed out live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adapted_free(adapted: *mut tree_adapted) -> tree_status {
    call(|| unsafe { free(adapted, "adapted") })
}
