//! From a cloud to skeletons in one call.

use super::params::tree_scan_params;
use super::report::tree_scan_report;
use crate::border::{
    Failure, Handle, Result, Shared, TREE_ERROR_PARAMETER, Versioned, call, foresee, free, get,
    out, out_value, read_or_default, slice, tree_status, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_cloud;
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use glam::DVec3;
use std::sync::Arc;
use tree_model::skeletonize::{Scanned, ScannedTree, skeletonize_scan};
use tree_model::tree_core::Resource;

/// The trees of a cloud of points.
pub struct tree_scanned(Arc<Scanned>);

impl Handle for tree_scanned {
    const NAME: &'static str = "tree_scanned";
}

impl tree_scanned {
    fn tree(&self, index: usize) -> Result<&ScannedTree> {
        let trees = &self.0.trees;
        trees.get(index).ok_or_else(|| beyond(index, trees.len(), "trees"))
    }
}

fn beyond(index: usize, n: usize, what: &str) -> Failure {
    let text = format!("index is {index}, but there are {n} {what}");
    Failure::new(TREE_ERROR_PARAMETER, text)
}

/// A view of a tree of a cloud.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scanned_columns {
    /// `sizeof(tree_scanned_columns)`.
    pub struct_size: usize,
    /// Where the tree's base, the origin of its skeleton, is in the cloud, in its axes and unit.
    pub base: [f64; 3],
    /// Number of nodes of its skeleton.
    pub n_nodes: usize,
    /// A byte for each node: 1 where it runs through foliage, guessed and not seen; else 0.
    pub in_foliage: *const u8,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_scanned_columns {
    const NAME: &'static str = "tree_scanned_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            base: [0.0; 3],
            n_nodes: 0,
            in_foliage: std::ptr::null(),
        }
    }
}

unsafe fn make(
    points: &[DVec3],
    params: *const tree_scan_params,
    control: *const tree_control,
    report: *mut tree_scan_report,
) -> Result<tree_scanned> {
    unsafe { foresee(report, "report") }?;
    let params = unsafe { read_or_default(params, "params") }?.rust()?;
    let body = |control: &_| Ok(skeletonize_scan(points, &params, control)?);
    let made = unsafe { run(control, body) }?;
    unsafe { view(report, "report", &tree_scan_report::of(&made.report)) }?;
    Ok(tree_scanned(Arc::new(made)))
}

/// Makes skeletons of a laser scan: `points` is three doubles for each of `n_points`, which are not kept; those that are
/// not finite are left out. Leaves are not made. `params`, `control` and `report` may be NULL. Free the result with
/// `tree_scanned_free`. `TREE_ERROR_INVALID` for fewer than 16 points that differ, or points on one line;
/// `TREE_ERROR_NO_RESULT` where no tree stands; `TREE_ERROR_LIMIT` for more than `graph_nodes`, `graph_arcs` or `nodes`.
/// It takes some four microseconds a point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeletonize_scan(
    points: *const f64,
    n_points: usize,
    params: *const tree_scan_params,
    control: *const tree_control,
    report: *mut tree_scan_report,
    scanned: *mut *mut tree_scanned,
) -> tree_status {
    call(|| {
        let place = unsafe { out(scanned, "scanned") }?;
        let limits = unsafe { limits(control) }?;
        let (first, nodes) = (points.cast(), Resource::GraphNodes);
        let points = unsafe { slice(first, n_points, &limits, nodes, "points") }?;
        place.put(unsafe { make(points, params, control, report) }?);
        Ok(())
    })
}

/// As `tree_skeletonize_scan`, of a cloud from a file.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeletonize_cloud(
    cloud: *const tree_cloud,
    params: *const tree_scan_params,
    control: *const tree_control,
    report: *mut tree_scan_report,
    scanned: *mut *mut tree_scanned,
) -> tree_status {
    call(|| {
        let place = unsafe { out(scanned, "scanned") }?;
        let points = &unsafe { get(cloud, "cloud") }?.rust().positions;
        place.put(unsafe { make(points, params, control, report) }?);
        Ok(())
    })
}

/// Number of trees: one, or as many as were found where all were asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scanned_count(
    scanned: *const tree_scanned,
    n_trees: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(scanned, "scanned") }?.0.trees.len();
        unsafe { out_value(n_trees, n, "n_trees") }
    })
}

/// The skeleton of a tree, in metres, +Y up, its base at the origin; not copied. `index` is below `tree_scanned_count`.
/// Free it with `tree_skeleton_free`; it may outlive the scan.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scanned_skeleton(
    scanned: *const tree_scanned,
    index: usize,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let scanned = unsafe { get(scanned, "scanned") }?;
        let n = scanned.0.trees.len();
        let part = Shared::of(scanned.0.clone())
            .part_if(|scanned| scanned.trees.get(index).map(|tree| &tree.skeleton));
        place.put(tree_skeleton::part(part.ok_or_else(|| beyond(index, n, "trees"))?));
        Ok(())
    })
}

/// Views a tree: where it stands and what of it was guessed. `index` is below `tree_scanned_count`. Set
/// `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scanned_view(
    scanned: *const tree_scanned,
    index: usize,
    columns: *mut tree_scanned_columns,
) -> tree_status {
    call(|| {
        let tree = unsafe { get(scanned, "scanned") }?.tree(index)?;
        let value = tree_scanned_columns {
            base: tree.base.to_array(),
            n_nodes: tree.in_foliage.len(),
            // A bool is a byte, 0 or 1.
            in_foliage: column(&tree.in_foliage).cast(),
            ..tree_scanned_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// A gap that was bridged: its length in metres, and the points of the smaller one of the two pieces it joins. `index` is
/// below `tree_scan_report.n_bridges`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scanned_bridge(
    scanned: *const tree_scanned,
    index: usize,
    length: *mut f32,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let bridges = &unsafe { get(scanned, "scanned") }?.0.report.bridges;
        let bridge = bridges.get(index).ok_or_else(|| beyond(index, bridges.len(), "bridges"))?;
        unsafe { out_value(length, bridge.length, "length") }?;
        unsafe { out_value(n_points, bridge.n_points, "n_points") }
    })
}

/// Frees the trees of a cloud. Skeletons handed out live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scanned_free(scanned: *mut tree_scanned) -> tree_status {
    call(|| unsafe { free(scanned, "scanned") })
}
