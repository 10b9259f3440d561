//! What a surface is, apart from its shape: points, edges, holes, pieces, crossings.

use super::{column, tree_mesh};
use crate::border::{Handle, Versioned, call, fill, free, get, out, out_value, tree_status, write};
use crate::control::{run, tree_control};
use ::tree_mesh::topology::{Crossings, FLAT_SHARE, Topology, examine, self_intersections, welded};

/// A triangle counts as flat when its area is below this share of the squared diagonal of the box around
/// the surface: a square with a side of a ten-millionth of the diagonal, and a tenth as high. For a tree of
/// 10 m that is 1e-13 m².
pub const TREE_FLAT_SHARE: f64 = 1e-15;
const _: () = assert!(TREE_FLAT_SHARE == FLAT_SHARE);

/// What `tree_mesh_examine` found. Vertices that are copies of one point, for a seam of the texture, count
/// as one. Lengths in metres.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_topology {
    /// `sizeof(tree_topology)`.
    pub struct_size: usize,
    /// Points that triangles use; copies at seams count once.
    pub n_points: u64,
    /// Edges between points.
    pub n_edges: u64,
    /// Triangles of three different points.
    pub n_triangles: u64,
    /// Triangles with two corners at one point. They have no area and are not counted elsewhere.
    pub collapsed_triangles: u64,
    /// Edges of one triangle only: holes.
    pub boundary_edges: u64,
    /// Edges of more than two triangles.
    pub non_manifold_edges: u64,
    /// Edges of two triangles that run along them in the same direction: one faces inwards.
    pub misoriented_edges: u64,
    /// Points whose triangles form more than one fan.
    pub non_manifold_points: u64,
    /// Vertices that do not stand exactly where the vertex they are welded to stands: cracks.
    pub cracks: u64,
    /// Pieces that share no point.
    pub components: u64,
    /// Triangles with less area than `TREE_FLAT_SHARE` allows.
    pub flat_triangles: u64,
    /// Euler characteristic, points − edges + triangles: 2 for each closed piece without handles.
    pub euler: i64,
    /// Enclosed volume in m³; of a closed surface only. Negative when its triangles face inwards.
    pub volume: f64,
    /// Area in m².
    pub area: f64,
    /// Area of the smallest triangle in m²; infinite without triangles.
    pub smallest_area: f64,
    /// Smallest angle of any triangle in radians, up to π/3; infinite without triangles.
    pub smallest_angle: f64,
    /// Whether this is a closed, consistently oriented 2-manifold, of any number of pieces.
    pub is_closed: u32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_topology {
    const NAME: &'static str = "tree_topology";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Topology::default())
    }
}

impl tree_topology {
    fn of(found: &Topology) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: found.n_points,
            n_edges: found.n_edges,
            n_triangles: found.n_triangles,
            collapsed_triangles: found.collapsed_triangles,
            boundary_edges: found.boundary_edges,
            non_manifold_edges: found.non_manifold_edges,
            misoriented_edges: found.misoriented_edges,
            non_manifold_points: found.non_manifold_points,
            cracks: found.cracks,
            components: found.components,
            flat_triangles: found.flat_triangles,
            euler: found.euler(),
            volume: found.volume,
            area: found.area,
            smallest_area: found.smallest_area,
            smallest_angle: found.smallest_angle,
            is_closed: found.is_closed().into(),
            reserved: 0,
        }
    }
}

/// Counts points, edges, holes, pieces and the like of surface `number`. Set `topology->struct_size` first.
/// `control` may be NULL; only its pool matters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_examine(
    mesh: *const tree_mesh,
    number: usize,
    control: *const tree_control,
    topology: *mut tree_topology,
) -> tree_status {
    call(|| {
        let surface = unsafe { get(mesh, "mesh") }?.rust().surface(number)?;
        let found = unsafe { run(control, |_| Ok(examine(surface)?)) }?;
        unsafe { write(topology, "topology", &tree_topology::of(&found)) }
    })
}

/// The points of surface `number`, numbered in the order of their first vertices: by its welds where it
/// has them, otherwise vertices at exactly the same place are one point.
///
/// `of_vertex`, NULL or with room for `of_vertex_capacity` numbers (one for each vertex), gets the point
/// that each vertex stands at. `first`, NULL or with room for `first_capacity` numbers (as many as there are vertices are always
/// enough), gets the first vertex of each point. `n_points` gets their number; it may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_points(
    mesh: *const tree_mesh,
    number: usize,
    of_vertex: *mut u32,
    of_vertex_capacity: usize,
    first: *mut u32,
    first_capacity: usize,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let surface = unsafe { get(mesh, "mesh") }?.rust().surface(number)?;
        let points = welded(surface)?;
        if !n_points.is_null() {
            unsafe { out_value(n_points, points.len(), "n_points") }?;
        }
        if !first.is_null() {
            unsafe { fill(first, first_capacity, &points.first, "first") }?;
        }
        if !of_vertex.is_null() {
            unsafe { fill(of_vertex, of_vertex_capacity, &points.of_vertex, "of_vertex") }?;
        }
        Ok(())
    })
}

/// Triangles of a surface that cross each other.
pub struct tree_crossings(Crossings);

impl Handle for tree_crossings {
    const NAME: &'static str = "tree_crossings";
}

/// A view of crossings. Pairs are two triangle numbers each, the lower one first, sorted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_crossing_pairs {
    /// `sizeof(tree_crossing_pairs)`.
    pub struct_size: usize,
    /// Number of `pairs`.
    pub n_pairs: usize,
    /// Number of `pairs_at_points`.
    pub n_pairs_at_points: usize,
    /// Triangles that share no point of the surface and yet have a place in common; NULL for none.
    pub pairs: *const u32,
    /// Triangles that share one point of the surface and have another place in common; NULL for none.
    pub pairs_at_points: *const u32,
    /// Different triangles in either list.
    pub n_triangles: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_crossing_pairs {
    const NAME: &'static str = "tree_crossing_pairs";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Crossings::default())
    }
}

impl tree_crossing_pairs {
    fn of(found: &Crossings) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_pairs: found.pairs.len(),
            n_pairs_at_points: found.pairs_at_points.len(),
            pairs: column(&found.pairs).cast(),
            pairs_at_points: column(&found.pairs_at_points).cast(),
            n_triangles: found.n_triangles,
        }
    }
}

/// Finds the triangles of surface `number` that cross or touch each other without sharing a point, and
/// those that share one point and meet again beyond it. Triangles that share an edge are not tested (they
/// cross only when folded flat on each other), nor are those with two corners at one point. Pairs count
/// against the limit `triangles`. Free the answer with `tree_crossings_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_crossings(
    mesh: *const tree_mesh,
    number: usize,
    control: *const tree_control,
    crossings: *mut *mut tree_crossings,
) -> tree_status {
    call(|| {
        let place = unsafe { out(crossings, "crossings") }?;
        let surface = unsafe { get(mesh, "mesh") }?.rust().surface(number)?;
        let found = unsafe { run(control, |control| Ok(self_intersections(surface, control)?)) }?;
        place.put(tree_crossings(found));
        Ok(())
    })
}

/// Views crossings. Set `pairs->struct_size` first. Valid until they are freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crossings_view(
    crossings: *const tree_crossings,
    pairs: *mut tree_crossing_pairs,
) -> tree_status {
    call(|| {
        let found = unsafe { get(crossings, "crossings") }?;
        unsafe { write(pairs, "pairs", &tree_crossing_pairs::of(&found.0)) }
    })
}

/// Frees crossings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crossings_free(crossings: *mut tree_crossings) -> tree_status {
    call(|| unsafe { free(crossings, "crossings") })
}
