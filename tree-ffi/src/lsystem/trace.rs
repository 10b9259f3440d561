//! What a turtle drew beside the tree, and what it met.

use crate::border::{
    Failure, Handle, TREE_ERROR_PARAMETER, Versioned, call, free, get, out, out_value, tree_status,
    tree_str, write,
};
use crate::mesh::column;
use crate::photo::tree_lines;
use glam::Vec3;
use tree_model::lsystem::{Polygon, TurtleReport};

/// What a turtle drew beside the tree: filled polygons; and the symbols that said nothing to it.
pub struct tree_turtle_trace {
    starts: Vec<u64>,
    vertices: Vec<Vec3>,
    colors: Vec<u32>,
    nodes: Vec<u32>,
    report: TurtleReport,
}

impl Handle for tree_turtle_trace {
    const NAME: &'static str = "tree_turtle_trace";
}

impl tree_turtle_trace {
    pub(super) fn new(polygons: &[Polygon], report: TurtleReport) -> Self {
        let mut starts = vec![0];
        let mut vertices = Vec::with_capacity(polygons.iter().map(|one| one.vertices.len()).sum());
        for polygon in polygons {
            vertices.extend_from_slice(&polygon.vertices);
            starts.push(vertices.len() as u64);
        }
        Self {
            starts,
            vertices,
            colors: polygons.iter().map(|polygon| polygon.color).collect(),
            nodes: polygons.iter().map(|polygon| polygon.node).collect(),
            report,
        }
    }
}

/// What drawing a word took, and what was left out.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_turtle_report {
    /// `sizeof(tree_turtle_report)`.
    pub struct_size: usize,
    /// `tree_lsystem_grow`: steps of the derivation. Else 0.
    pub n_steps: u64,
    /// `tree_lsystem_grow`: modules that all steps wrote together. Else 0.
    pub n_produced: u64,
    /// Modules read by the turtle.
    pub n_modules: u64,
    /// Most brackets open at a time.
    pub depth: u64,
    /// Gaps made by `f` before wood was drawn again. The skeleton runs on through them: a tree is connected.
    pub gaps: u64,
    /// `F` and `G` of no length, which make no node.
    pub merged: u64,
    /// Modules that a `%` cut off.
    pub cut: u64,
    /// Polygons with fewer than three corners, left out.
    pub thin_polygons: u64,
    /// Polygons that became leaves as well.
    pub polygon_leaves: u64,
    /// Symbols that say nothing to the turtle: `tree_turtle_trace_skipped` names them.
    pub n_skipped: u64,
    /// Metres in a unit of length.
    pub scale: f64,
    /// Whether the word set any width: 1 or 0.
    pub widths: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_turtle_report {
    const NAME: &'static str = "tree_turtle_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&TurtleReport::default())
    }
}

impl tree_turtle_report {
    pub(super) fn of(report: &TurtleReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_steps: 0,
            n_produced: 0,
            n_modules: report.modules as u64,
            depth: report.depth as u64,
            gaps: report.gaps as u64,
            merged: report.merged as u64,
            cut: report.cut as u64,
            thin_polygons: report.thin_polygons as u64,
            polygon_leaves: report.polygon_leaves as u64,
            n_skipped: report.skipped.len() as u64,
            scale: report.scale,
            widths: report.widths.into(),
            reserved: 0,
        }
    }
}

/// A view of the polygons that a turtle drew between `{` and `}`, leaf or not, in the order of their ends.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_turtle_polygons {
    /// `sizeof(tree_turtle_polygons)`.
    pub struct_size: usize,
    /// Number of polygons.
    pub n_polygons: usize,
    /// `n_polygons` + 1 places: polygon i has the corners from `starts[i]` to before `starts[i + 1]`, three or
    /// more.
    pub starts: *const u64,
    /// Number of corners of all polygons.
    pub n_vertices: usize,
    /// Three floats for each corner, in metres, in the order they were drawn.
    pub vertices: *const f32,
    /// One for each polygon: the colour number when it was closed (`'`).
    pub colors: *const u32,
    /// One for each polygon: the skeleton's node it hangs on.
    pub nodes: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_turtle_polygons {
    const NAME: &'static str = "tree_turtle_polygons";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_polygons: 0,
            starts: std::ptr::null(),
            n_vertices: 0,
            vertices: std::ptr::null(),
            colors: std::ptr::null(),
            nodes: std::ptr::null(),
        }
    }
}

/// Views the polygons. Set `polygons->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_trace_view(
    trace: *const tree_turtle_trace,
    polygons: *mut tree_turtle_polygons,
) -> tree_status {
    call(|| {
        let trace = unsafe { get(trace, "trace") }?;
        let value = tree_turtle_polygons {
            n_polygons: trace.nodes.len(),
            starts: column(&trace.starts),
            n_vertices: trace.vertices.len(),
            vertices: column(&trace.vertices).cast(),
            colors: column(&trace.colors),
            nodes: column(&trace.nodes),
            ..tree_turtle_polygons::default_value()
        };
        unsafe { write(polygons, "polygons", &value) }
    })
}

/// A symbol that says nothing to the turtle, and how often it was met. `index` is below
/// `tree_turtle_report.n_skipped`. The name is valid until the trace is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_trace_skipped(
    trace: *const tree_turtle_trace,
    index: usize,
    name: *mut tree_str,
    n_times: *mut usize,
) -> tree_status {
    call(|| {
        let skipped = &unsafe { get(trace, "trace") }?.report.skipped;
        let Some((found, n)) = skipped.get(index) else {
            let text = format!("index is {index}, but {} symbols were skipped", skipped.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { out_value(name, tree_str::of(found), "name") }?;
        unsafe { out_value(n_times, *n, "n_times") }
    })
}

/// All that may surprise, a sentence for each; there may be none. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_trace_warnings(
    trace: *const tree_turtle_trace,
    warnings: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(warnings, "warnings") }?;
        place.put(tree_lines::new(unsafe { get(trace, "trace") }?.report.warnings()));
        Ok(())
    })
}

/// Frees what a turtle drew beside the tree.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_trace_free(trace: *mut tree_turtle_trace) -> tree_status {
    call(|| unsafe { free(trace, "trace") })
}
