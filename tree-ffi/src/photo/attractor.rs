//! Attractor graphs: the main branches in one picture.

use super::draw::color;
use super::picture::tree_photo;
use super::{blamed, vec2};
use crate::border::{
    Handle, TREE_ERROR_INVALID, Versioned, call, free, get, out, out_value, read, slice,
    tree_status, vec2s, write,
};
use crate::control::{limits, tree_control};
use crate::foliage::tree_rows;
use crate::mesh::column;
use tree_model::particle::attractor::AttractorGraph;
use tree_model::tree_core::Resource;

/// Main branches in one picture, as a forest whose roots are at the tree's base.
pub struct tree_attractor(AttractorGraph);

impl Handle for tree_attractor {
    const NAME: &'static str = "tree_attractor";
}

impl tree_attractor {
    pub(crate) fn new(graph: AttractorGraph) -> Self {
        Self(graph)
    }

    pub(crate) fn rust(&self) -> &AttractorGraph {
        &self.0
    }
}

/// The columns of an attractor graph. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_attractor_columns {
    /// `sizeof(tree_attractor_columns)`.
    pub struct_size: usize,
    /// Number of nodes.
    pub n_nodes: usize,
    /// Two floats for each node, in pixels from the top left of the picture. Finite.
    pub positions: *const f32,
    /// For each node the one that it leads to, nearer to the base, which comes before it; `TREE_NO_PARENT`
    /// at the base.
    pub parents: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_attractor_columns {
    const NAME: &'static str = "tree_attractor_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            parents: std::ptr::null(),
        }
    }
}

/// Makes a graph of columns, which are copied. `control` may be NULL; `nodes` of its limits counts. Free
/// the graph with `tree_attractor_free`. `TREE_ERROR_INVALID` where a parent does not come before its node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_from_columns(
    columns: *const tree_attractor_columns,
    control: *const tree_control,
    attractor: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(attractor, "attractor") }?;
        let columns = unsafe { read(columns, "columns") }?;
        let limits = unsafe { limits(control) }?;
        let (n, nodes) = (columns.n_nodes, Resource::Nodes);
        let positions =
            unsafe { vec2s(columns.positions, n, &limits, nodes, "columns.positions") }?.to_vec();
        let parents =
            unsafe { slice(columns.parents, n, &limits, nodes, "columns.parents") }?.to_vec();
        let made = AttractorGraph::new(positions, parents);
        place.put(tree_attractor(made.map_err(blamed(TREE_ERROR_INVALID))?));
        Ok(())
    })
}

/// Views the columns of a graph. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_view(
    attractor: *const tree_attractor,
    columns: *mut tree_attractor_columns,
) -> tree_status {
    call(|| {
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let found = tree_attractor_columns {
            n_nodes: graph.nodes().len(),
            positions: column(graph.nodes()).cast(),
            parents: column(graph.parents()),
            ..tree_attractor_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// The point of a graph that is nearest to another.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_attractor_nearest_point {
    /// `sizeof(tree_attractor_nearest_point)`.
    pub struct_size: usize,
    /// Whether there is one, 1 or 0: a graph without segments has none, a point that is not finite neither.
    pub found: u32,
    /// The node at the upper end of the segment it lies on.
    pub node: u32,
    /// Where on the segment: 0 at the parent, 1 at the node.
    pub share: f32,
    /// The point, in pixels.
    pub point: [f32; 2],
    /// How far off it is, in pixels.
    pub distance: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_attractor_nearest_point {
    const NAME: &'static str = "tree_attractor_nearest_point";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            found: 0,
            node: 0,
            share: 0.0,
            point: [0.0; 2],
            distance: 0.0,
        }
    }
}

/// The point of a graph nearest to `at_pixel`, two floats in pixels from the top left. Set
/// `nearest->struct_size` first; `nearest->found` says whether there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_nearest(
    attractor: *const tree_attractor,
    at_pixel: *const f32,
    nearest: *mut tree_attractor_nearest_point,
) -> tree_status {
    call(|| {
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let found = graph.nearest(unsafe { vec2(at_pixel, "at_pixel") }?);
        let none = tree_attractor_nearest_point::default_value();
        let value = found.map_or(none, |found| tree_attractor_nearest_point {
            found: 1,
            node: found.node,
            share: found.share,
            point: found.point.to_array(),
            distance: found.distance,
            ..none
        });
        unsafe { write(nearest, "nearest", &value) }
    })
}

/// Length of all segments together, in pixels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_length(
    attractor: *const tree_attractor,
    length: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(attractor, "attractor") }?.rust().length();
        unsafe { out_value(length, found, "length") }
    })
}

/// The nodes that none leads to, roots without children included. Free them with `tree_rows_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_tips(
    attractor: *const tree_attractor,
    tips: *mut *mut tree_rows,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tips, "tips") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        place.put(tree_rows::new(graph.tips().collect()));
        Ok(())
    })
}

/// The graph drawn over a photograph or any other picture of the same size, with lines of `width` pixels
/// in a colour `0xRRGGBBAA`. Free the new photograph with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_draw(
    attractor: *const tree_attractor,
    photo: *const tree_photo,
    width: f32,
    rgba: u32,
    drawn: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawn, "drawn") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let photo = unsafe { get(photo, "photo") }?.rust();
        place.put(tree_photo::new(graph.draw_over(photo, width, color(rgba))?));
        Ok(())
    })
}

/// Frees a graph. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_free(attractor: *mut tree_attractor) -> tree_status {
    call(|| unsafe { free(attractor, "attractor") })
}
