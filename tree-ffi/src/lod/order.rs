//! In which order elements are dropped.

use super::elements::tree_elements;
use super::hull::tree_hull;
use super::order_params::{tree_coverage_params, tree_order_params};
use super::take::{fill_points, fill_some, room_for};
use super::tiers::tree_tiers;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, call, get, get_opt, slice, tree_status,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::tree_mesh;
use std::borrow::Cow;
use std::ptr::null;
use tree_lod::Elements;
use tree_lod::order::{self, OrderParams};
use tree_lod::outline::Tier;
use tree_model::tree_core::{Control, Resource, Seed};

/// Makes an order in a caller's buffer.
unsafe fn make(
    elements: *const tree_elements,
    control: *const tree_control,
    (order, capacity): (*mut u32, usize),
    made: impl FnOnce(&Elements, &Control) -> Result<Vec<u32>> + Send,
) -> Result<()> {
    let elements = unsafe { get(elements, "elements") }?.rust();
    room_for(elements.len(), capacity, "order")?;
    let found = unsafe { run(control, |control| made(elements, control)) }?;
    unsafe { fill_some(order, capacity, &found, "order") }
}

/// Makes an order that has nothing to do with place, size, direction or colour: a shuffle (Cook et al. 2007).
/// `order` has room for `capacity` numbers, at least one for each element; as of all orders, row k is the k-th
/// most important element, and the first rows are drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_stochastic(
    elements: *const tree_elements,
    seed: u64,
    order: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe {
        make(elements, null(), (order, capacity), |elements, _| {
            Ok(order::stochastic(elements, Seed(seed)))
        })
    })
}

/// Makes an order of which every beginning is evenly spread over the ground, by the golden section (Neubert 2012,
/// 6.3.2, "drop and resize"). There is no chance in it. `order` as for `tree_order_stochastic`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_golden(
    elements: *const tree_elements,
    order: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe {
        make(elements, null(), (order, capacity), |elements, _| Ok(order::golden(elements)?))
    })
}

/// Makes an order in which elements of dense places go first, until all places are about as dense; the rest is
/// stochastic (Neubert 2012, 7.3.2). `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
/// `TREE_ERROR_INVALID` when no element has area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_density(
    elements: *const tree_elements,
    params: *const tree_order_params,
    seed: u64,
    control: *const tree_control,
    order: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe {
        by(elements, params, control, (order, capacity), |elements, params, control| {
            Ok(order::density(elements, params, Seed(seed), control)?)
        })
    })
}

/// Makes an order in which elements that do not lie along the hull go first (Neubert 2012, 7.3.3), with
/// `params->randomness`. `params` and `control` may be NULL; `order` as for `tree_order_stochastic`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_orientation(
    elements: *const tree_elements,
    hull: *const tree_hull,
    params: *const tree_order_params,
    seed: u64,
    control: *const tree_control,
    order: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe {
        let hull = get(hull, "hull")?.rust();
        by(elements, params, control, (order, capacity), |elements, params, control| {
            Ok(order::orientation(elements, hull, params, Seed(seed), control)?)
        })
    })
}

/// Makes the order by density and orientation together (Neubert 2012, eq. 7.8). It makes field and hull itself.
/// `params` and `control` may be NULL; `order` as for `tree_order_stochastic`. `TREE_ERROR_INVALID` when no element
/// has area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_combined(
    elements: *const tree_elements,
    params: *const tree_order_params,
    seed: u64,
    control: *const tree_control,
    order: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe {
        by(elements, params, control, (order, capacity), |elements, params, control| {
            Ok(order::combined(elements, params, Seed(seed), control)?)
        })
    })
}

unsafe fn by(
    elements: *const tree_elements,
    params: *const tree_order_params,
    control: *const tree_control,
    buffer: (*mut u32, usize),
    made: impl FnOnce(&Elements, &OrderParams, &Control) -> Result<Vec<u32>> + Send,
) -> Result<()> {
    let params = unsafe { tree_order_params::read(params) }?;
    unsafe { make(elements, control, buffer, |elements, control| made(elements, &params, control)) }
}

/// Makes the order that keeps the pixels covered: elements are drawn from many sides, and those come first that
/// together make the best quality. Where leaves have grown, each chooses the point that it grows about. The best
/// order of all, and the one that takes longest: some ten drawings of the foliage in every view.
///
/// Elements are drawn as in tier `tier` of `tiers`: 0 is the full model, and NULL, with 0, has no other. For leaves of
/// many triangles take one of about four triangles each: a quarter of the time, and nearly the same order.
///
/// `params` and `control` may be NULL. `order` as for `tree_order_stochastic`; `pivots`, three floats for each
/// element (not rank) in metres, has room for `pivots_capacity` floats, at least three for each element.
/// `TREE_ERROR_INVALID` when the elements or tiers are not of this mesh, `TREE_ERROR_PARAMETER` when there is no such
/// tier.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_coverage(
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    tiers: *const tree_tiers,
    tier: usize,
    params: *const tree_coverage_params,
    control: *const tree_control,
    order: *mut u32,
    capacity: usize,
    pivots: *mut f32,
    pivots_capacity: usize,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        let params = unsafe { tree_coverage_params::read(params, elements.n_triangles()) }?;
        room_for(elements.len(), capacity, "order")?;
        room_for(3 * elements.len(), pivots_capacity, "pivots")?;
        let shape = match unsafe { get_opt(tiers, "tiers") }? {
            Some(tiers) => Cow::Borrowed(tiers.row(tier)?),
            None if tier == 0 => Cow::Owned(Tier::full(mesh, elements)),
            None => {
                let text = format!("tier is {tier}, but without tiers there is only 0");
                return Err(Failure::new(TREE_ERROR_PARAMETER, text));
            }
        };
        let body = |control: &_| Ok(order::coverage(mesh, elements, &shape, &params, control)?);
        let found = unsafe { run(control, body) }?;
        unsafe { fill_some(order, capacity, &found.order, "order") }?;
        unsafe { fill_points(pivots, pivots_capacity, &found.pivots, "pivots") }
    })
}

/// Checks that an order of `n_order` rows has each of `n_elements` elements once; `TREE_ERROR_INVALID` names the
/// first row at fault.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_check(
    order: *const u32,
    n_order: usize,
    n_elements: usize,
) -> tree_status {
    call(|| {
        let limits = unsafe { limits(null()) }?;
        limits.check(Resource::Triangles, n_elements as u64)?;
        let rows = unsafe { slice(order, n_order, &limits, Resource::Triangles, "order") }?;
        Ok(order::check(rows, n_elements)?)
    })
}
