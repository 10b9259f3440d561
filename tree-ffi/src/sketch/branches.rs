//! Branch segments in space: of a sketch, and with what grew on them.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ENUM, TREE_ERROR_INVALID, Versioned, call, fill, free, get,
    out, read, slice, tree_status, vec3s, write,
};
use crate::control::{limits, tree_control};
use crate::mesh::column;
use glam::Vec3;
use std::ptr::null;
use tree_model::sketch::propagate::Propagated;
use tree_model::sketch::{Branches, Label};
use tree_model::tree_core::Resource;

/// Which part a segment plays where its parent ends: `TREE_SKETCH_APICAL`, or the number of a lateral from 0 to
/// 65,535.
pub type tree_sketch_label = u32;
/// The segment continues its parent's axis.
pub const TREE_SKETCH_APICAL: u32 = 0xffff_ffff;

/// In C's form.
pub(super) fn label_number(label: Label) -> tree_sketch_label {
    match label {
        Label::Apical => TREE_SKETCH_APICAL,
        Label::Lateral(number) => number.into(),
    }
}

/// In Rust's form.
pub(super) fn label(found: tree_sketch_label, name: &str) -> Result<Label> {
    match (found, u16::try_from(found)) {
        (TREE_SKETCH_APICAL, _) => Ok(Label::Apical),
        (_, Ok(number)) => Ok(Label::Lateral(number)),
        _ => {
            let text = format!(
                "{name} is {found}, which is neither TREE_SKETCH_APICAL nor a lateral's number, 0 to 65535"
            );
            Err(Failure::new(TREE_ERROR_ENUM, text))
        }
    }
}

/// Branch segments from fork to fork, parents first: those of a sketch, or those with what grew on them
/// (`tree_sketch_branches_propagate`).
pub struct tree_sketch_branches {
    grown: Propagated,
    labels: Vec<tree_sketch_label>,
    starts: Vec<u32>,
    points: Vec<Vec3>,
}

impl Handle for tree_sketch_branches {
    const NAME: &'static str = "tree_sketch_branches";
}

impl tree_sketch_branches {
    pub(super) fn new(grown: Propagated) -> Self {
        let branches = &grown.branches;
        let labels = branches.labels().iter().copied().map(label_number).collect();
        let mut starts = vec![0];
        let mut points = Vec::new();
        for segment in 0..branches.len() {
            points.extend(branches.points(segment));
            starts.push(points.len() as u32);
        }
        Self { labels, starts, points, grown }
    }

    pub(super) fn rust(&self) -> &Propagated {
        &self.grown
    }

    /// Branches on which nothing grew yet.
    pub(super) fn sketched(&self) -> Result<&Branches> {
        if self.grown.n_sketched == self.grown.branches.len() {
            return Ok(&self.grown.branches);
        }
        let text = "branches have new ones on them already: take those before propagation";
        Err(Failure::new(TREE_ERROR_INVALID, text))
    }
}

/// Columns of branches: as input, or as a view of a `tree_sketch_branches`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_branches_columns {
    /// `sizeof(tree_sketch_branches_columns)`.
    pub struct_size: usize,
    /// Number of segments, at least 1.
    pub n_segments: usize,
    /// Number of points of all segments.
    pub n_points: usize,
    /// Parent of each segment, which comes before it; `TREE_NO_PARENT` for segment 0.
    pub parents: *const u32,
    /// Label of each segment; that of segment 0 is `TREE_SKETCH_APICAL`.
    pub labels: *const tree_sketch_label,
    /// Where each segment's points begin in `points`, and at last their number: `n_segments + 1` values.
    pub starts: *const u32,
    /// Three floats for each point, in metres: seen along -Z, as the sketch was drawn, z is the depth, positive
    /// towards the viewer. A segment's first point is its parent's last; those that propagation adds may begin on
    /// the way there.
    pub points: *const f32,
    /// A name for each segment that stays when others are drawn or erased: streams of randomness go by it. NULL where
    /// segments have none. Not read as input.
    pub names: *const u64,
    /// The generation of each segment, 0 for the sketched. Not read as input.
    pub generations: *const u32,
    /// Where on its parent each segment begins, counted in the parent's points: 2.25 is a quarter of the way from its
    /// point 2 to its point 3. Not read as input.
    pub forks: *const f32,
    /// How many segments are sketched; they come first. Not read as input.
    pub n_sketched: usize,
    /// Whether segment 0 is not drawn: it stands below a base from which several stems rise, and only says that they
    /// rise.
    pub imagined_root: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_sketch_branches_columns {
    const NAME: &'static str = "tree_sketch_branches_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_segments: 0,
            n_points: 0,
            parents: null(),
            labels: null(),
            starts: null(),
            points: null(),
            names: null(),
            generations: null(),
            forks: null(),
            n_sketched: 0,
            imagined_root: 0,
            reserved: 0,
        }
    }
}

/// Makes branches of columns, which are copied: segments of a sketch, or measured elsewhere, on which nothing grew
/// yet. Every segment but the first must begin where its parent ends. `control` may be NULL; `nodes` of its limits
/// caps the points. Free them with `tree_sketch_branches_free`. `TREE_ERROR_INVALID` says which columns or which
/// segment do not fit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_from_columns(
    columns: *const tree_sketch_branches_columns,
    control: *const tree_control,
    branches: *mut *mut tree_sketch_branches,
) -> tree_status {
    call(|| {
        let place = unsafe { out(branches, "branches") }?;
        let given = unsafe { read(columns, "columns") }?;
        let (limits, nodes) = (unsafe { limits(control) }?, Resource::Nodes);
        let (n, n_points) = (given.n_segments, given.n_points);
        let parents = unsafe { slice(given.parents, n, &limits, nodes, "columns.parents") }?;
        let labels = unsafe { slice(given.labels, n, &limits, nodes, "columns.labels") }?;
        let n_starts = n.saturating_add(1);
        let starts = unsafe { slice(given.starts, n_starts, &limits, nodes, "columns.starts") }?;
        let points = unsafe { vec3s(given.points, n_points, &limits, nodes, "columns.points") }?;
        let label = |(i, &found): (usize, &u32)| label(found, &format!("columns.labels[{i}]"));
        let labels = labels.iter().enumerate().map(label).collect::<Result<Vec<_>>>()?;
        let made = Branches::from_columns(
            parents.to_vec(),
            labels,
            starts.to_vec(),
            points.to_vec(),
            given.imagined_root != 0,
        )?;
        place.put(tree_sketch_branches::new(Propagated::bare(made)));
        Ok(())
    })
}

/// Views branches. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_view(
    branches: *const tree_sketch_branches,
    columns: *mut tree_sketch_branches_columns,
) -> tree_status {
    call(|| {
        let held = unsafe { get(branches, "branches") }?;
        let grown = &held.grown;
        let found = tree_sketch_branches_columns {
            n_segments: grown.branches.len(),
            n_points: held.points.len(),
            parents: column(grown.branches.parents()),
            labels: column(&held.labels),
            starts: column(&held.starts),
            points: column(&held.points).cast(),
            names: column(grown.branches.names()),
            generations: column(&grown.generations),
            forks: column(&grown.forks),
            n_sketched: grown.n_sketched,
            imagined_root: grown.branches.has_imagined_root().into(),
            ..tree_sketch_branches_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Writes the Gravelius order of each segment's axis: 0 for stems, one more than its parent's for a lateral.
/// `orders` has room for `capacity` values, at least as many as there are segments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_orders(
    branches: *const tree_sketch_branches,
    orders: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(branches, "branches") }?.grown.branches.orders();
        unsafe { fill(orders, capacity, &found, "orders") }
    })
}

/// Frees branches. What was made of them lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_free(
    branches: *mut tree_sketch_branches,
) -> tree_status {
    call(|| unsafe { free(branches, "branches") })
}
