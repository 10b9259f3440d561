//! Boxes along the branches.

use super::box_params::{tree_leaf_box_params, tree_leaf_boxes_report};
use crate::border::{
    Failure, Handle, Result, Shared, TREE_ERROR_PARAMETER, Versioned, call, fill, floats, foresee,
    free, get, out, out_value, read_or_default, slice, tree_status, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::lod::tree_elements;
use crate::mesh::{column, tree_mesh};
use crate::skeleton::tree_skeleton;
use bytemuck::{Pod, Zeroable};
use tree_lod::impostor::boxes::{Bearers, Boxes, LeafBox};
use tree_lod::impostor::cards::{self, Cards, Plane};
use tree_model::tree_core::Resource;

/// Parent of the box of the whole tree: no box.
pub const TREE_NO_BOX: u32 = 0xFFFF_FFFF;

/// Boxes along the branches of a tree (Lluch et al. 2010, 4.2.1), that of the whole tree first: which leaves are seen
/// as one, and an order of the leaves in which those of each box are one range. Parents come before their children,
/// which lie side by side.
pub struct tree_leaf_boxes(Shared<Boxes>);

impl Handle for tree_leaf_boxes {
    const NAME: &'static str = "tree_leaf_boxes";
}

impl tree_leaf_boxes {
    pub(super) fn of(cards: &Shared<Cards>) -> Self {
        Self(cards.part(Cards::boxes))
    }

    pub(super) fn rust(&self) -> &Boxes {
        self.0.get()
    }
}

/// The box of a branch with all its leaves.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_box {
    /// `sizeof(tree_leaf_box)`.
    pub struct_size: usize,
    /// Volume in cubic metres.
    pub volume: f64,
    /// The box it is in, or `TREE_NO_BOX`.
    pub parent: u32,
    /// 0 for the whole tree.
    pub level: u32,
    /// The node of the skeleton it begins at.
    pub node: u32,
    /// Where its leaves begin in the order.
    pub first_leaf: u32,
    /// Number of its leaves, those of its children included.
    pub n_leaves: u32,
    /// Number of leaves that are in no child: the first ones of its leaves.
    pub n_own: u32,
    /// The first of its children; the others follow it.
    pub first_child: u32,
    /// Number of its children.
    pub n_children: u32,
    /// Its middle in metres.
    pub center: [f32; 3],
    /// Half its sides in metres, along its own axes; none is 0.
    pub half: [f32; 3],
    /// Quaternion x, y, z, w that turns its own axes into those of the tree: x to the left of the branch, y along it,
    /// z up.
    pub turn: [f32; 4],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_box {
    const NAME: &'static str = "tree_leaf_box";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            volume: 0.0,
            parent: TREE_NO_BOX,
            level: 0,
            node: 0,
            first_leaf: 0,
            n_leaves: 0,
            n_own: 0,
            first_child: 0,
            n_children: 0,
            center: [0.0; 3],
            half: [0.0; 3],
            turn: [0.0, 0.0, 0.0, 1.0],
        }
    }
}

impl tree_leaf_box {
    fn of(found: &LeafBox) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            volume: found.volume(),
            parent: found.parent,
            level: found.level,
            node: found.node,
            first_leaf: found.leaves.start,
            n_leaves: found.leaves.len() as u32,
            n_own: found.own.len() as u32,
            first_child: found.children.start,
            n_children: found.children.len() as u32,
            center: found.center.to_array(),
            half: found.half.to_array(),
            turn: found.turn.to_array(),
        }
    }
}

/// Finds the boxes of a tree. `elements` are its leaves, `bearers` the node of the skeleton that carries each of the
/// `n_bearers` elements, as `tree_leaf_bearers_of_tree` or `tree_leaf_bearers_nearest` finds it. `params` and `control`
/// may be NULL, `report` when it is not wanted. Progress is told in the stage `boxes`. Free the boxes with
/// `tree_leaf_boxes_free`.
///
/// `TREE_ERROR_INVALID` when there is not one bearer for each element, a bearer does not exist, the elements are of
/// another mesh, or all leaves are one point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_along(
    skeleton: *const tree_skeleton,
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    bearers: *const u32,
    n_bearers: usize,
    params: *const tree_leaf_box_params,
    control: *const tree_control,
    report: *mut tree_leaf_boxes_report,
    boxes: *mut *mut tree_leaf_boxes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(boxes, "boxes") }?;
        unsafe { foresee(report.cast_const(), "report") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        let limits = unsafe { limits(control) }?;
        let bearers = unsafe { slice(bearers, n_bearers, &limits, Resource::Leaves, "bearers") }?;
        let bearers = Bearers(bearers.to_vec());
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body =
            |control: &_| Ok(Boxes::along(skeleton, mesh, elements, &bearers, &params, control)?);
        let made = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_leaf_boxes_report::of(&made.report())) }?;
        place.put(tree_leaf_boxes(Shared::new(made)));
        Ok(())
    })
}

/// Tells how many boxes there are, and what became of the leaves. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_measure(
    boxes: *const tree_leaf_boxes,
    report: *mut tree_leaf_boxes_report,
) -> tree_status {
    call(|| {
        let found = unsafe { get(boxes, "boxes") }?.rust().report();
        unsafe { write(report, "report", &tree_leaf_boxes_report::of(&found)) }
    })
}

/// Tells what box `number` is; 0 is the whole tree. Set `leaf_box->struct_size` first. `TREE_ERROR_PARAMETER` when there
/// is no such box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_get(
    boxes: *const tree_leaf_boxes,
    number: u32,
    leaf_box: *mut tree_leaf_box,
) -> tree_status {
    call(|| {
        let found = unsafe { numbered(boxes, number) }?;
        unsafe { write(leaf_box, "leaf_box", &tree_leaf_box::of(found)) }
    })
}

unsafe fn numbered<'a>(boxes: *const tree_leaf_boxes, number: u32) -> Result<&'a LeafBox> {
    let all = unsafe { get(boxes, "boxes") }?.rust().boxes();
    all.get(number as usize).ok_or_else(|| {
        let text = format!("number is {number}, but there are {} boxes", all.len());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// The numbers of all leaves (elements), in the order in which those of every box are one range: `n_leaves` of them,
/// from `order` on. They stay for as long as the boxes do.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_order(
    boxes: *const tree_leaf_boxes,
    order: *mut *const u32,
    n_leaves: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(boxes, "boxes") }?.rust().order();
        unsafe { out_value(order, column(found), "order") }?;
        unsafe { out_value(n_leaves, found.len(), "n_leaves") }
    })
}

/// Distance in metres from `point`, three floats, to box `number`; 0 inside. `TREE_ERROR_PARAMETER` when there is no
/// such box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_distance(
    boxes: *const tree_leaf_boxes,
    number: u32,
    point: *const f32,
    metres: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { numbered(boxes, number) }?;
        let point: [f32; 3] = unsafe { floats(point, "point") }?;
        unsafe { out_value(metres, found.distance(point.into()), "metres") }
    })
}

/// A rectangle on which the leaves of a box are projected. The unit vectors are at right angles to each other.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_card_plane {
    /// Its middle, that of the box, in metres.
    pub center: [f32; 3],
    /// Unit vector to the right of the picture: along the diagonal of a side of the box.
    pub right: [f32; 3],
    /// Unit vector up the picture: along an axis of the box.
    pub up: [f32; 3],
    /// Unit normal, to the viewer.
    pub normal: [f32; 3],
    /// Half its width and half its height in metres.
    pub half: [f32; 2],
    /// Half the depth of the box across the plane, in metres.
    pub reach: f32,
}

impl tree_card_plane {
    fn of(plane: &Plane) -> Self {
        Self {
            center: plane.center.to_array(),
            right: plane.right.to_array(),
            up: plane.up.to_array(),
            normal: plane.normal.to_array(),
            half: plane.half.to_array(),
            reach: plane.reach,
        }
    }
}

/// Writes the six planes of box `number`, two for each of its axes, which lies in both: plane 2k holds axis k and the
/// diagonal of the next two axes, plane 2k + 1 the other diagonal. `planes` has room for `capacity` of them.
/// `TREE_ERROR_PARAMETER` when there is no such box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_planes(
    boxes: *const tree_leaf_boxes,
    number: u32,
    planes: *mut tree_card_plane,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = unsafe { numbered(boxes, number) }?;
        let found = cards::planes(found).map(|plane| tree_card_plane::of(&plane));
        unsafe { fill(planes, capacity, &found, "planes") }
    })
}

/// Frees boxes, and with them all views of their order.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_boxes_free(boxes: *mut tree_leaf_boxes) -> tree_status {
    call(|| unsafe { free(boxes, "boxes") })
}
