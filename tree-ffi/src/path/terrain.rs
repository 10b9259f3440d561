//! What makes edges cost more or less, and where none may pass.

use crate::border::{
    Result, Versioned, call, get, get_opt, init, out_value, read_rows, tree_status,
};
use crate::control::User;
use crate::volume::{tree_volume, vec3};
use glam::Vec3;
use std::ffi::c_void;
use std::sync::Arc;
use tree_model::path::{CostField, LinkParams, Obstacle, Paint};

/// Most paints of one tree.
const PAINTS_MAX: usize = 1 << 16;

/// Makes edges dearer or cheaper inside a volume. Begin with `tree_paint_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_paint {
    /// `sizeof(tree_paint)`.
    pub struct_size: usize,
    /// Where: edges whose middle lies inside. No default: NULL, which is refused.
    pub volume: *const tree_volume,
    /// Their cost is multiplied by this, 0 to 1000. Below 1 attracts branches, above 1 repels them.
    /// Default 1, which changes nothing.
    pub factor: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_paint {
    const NAME: &'static str = "tree_paint";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), volume: std::ptr::null(), factor: 1.0, reserved: 0 }
    }
}

/// Makes `paint`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_paint_init(paint: *mut tree_paint, size: usize) -> tree_status {
    call(|| unsafe { init(paint, size) })
}

/// A cost factor for a point in space, three floats in metres: finite and 0 or more, or the call fails
/// with `TREE_ERROR_PARAMETER`. Called from any thread, by several at once; must not unwind. For the same
/// tree each time it must give the same answer to the same point.
pub type tree_cost_fn = Option<unsafe extern "C" fn(user: *mut c_void, point: *const f32) -> f32>;

/// The caller's function as a field.
pub(super) fn cost_field(cost: tree_cost_fn, user: *mut c_void) -> Option<CostField> {
    let cost = cost?;
    let user = User(user);
    Some(Arc::new(move |point: Vec3| {
        let point = point.to_array();
        // SAFETY: the caller's function with the caller's pointer, as the header says.
        unsafe { cost(user.get(), point.as_ptr()) }
    }))
}

/// The paints of an array; `name` is what it is called by.
pub(super) unsafe fn paints(first: *const tree_paint, n: usize, name: &str) -> Result<Vec<Paint>> {
    unsafe { read_rows(first, n, PAINTS_MAX, name) }?
        .iter()
        .enumerate()
        .map(|(i, paint)| {
            let volume = unsafe { get(paint.volume, &format!("{name}[{i}].volume")) }?;
            Ok(Paint { volume: volume.rust().clone(), factor: paint.factor })
        })
        .collect()
}

/// NULL is none.
pub(crate) unsafe fn obstacle(
    volume: *const tree_volume,
    clearance: f32,
    name: &str,
) -> Result<Option<Obstacle>> {
    let volume = unsafe { get_opt(volume, name) }?;
    Ok(volume.map(|volume| Obstacle { volume: volume.rust().clone(), clearance }))
}

/// How nodes are linked and what edges cost. Begin with `tree_link_params_init`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_link_params {
    /// `sizeof(tree_link_params)`.
    pub struct_size: usize,
    /// Painted edge costs; where several overlap, they multiply. Default NULL.
    pub paints: *const tree_paint,
    /// Number of paints, at most 65,536.
    pub n_paints: usize,
    /// A cost factor for every point, multiplied with the paints. Default NULL.
    pub cost: tree_cost_fn,
    /// Handed to `cost`.
    pub cost_user: *mut c_void,
    /// What no edge may pass through. Default NULL.
    pub obstacle: *const tree_volume,
    /// Distance to keep from the obstacle in metres, 0 or more. Default 0.
    pub clearance: f32,
    /// Linking distance in separations, 1.2 to 4. Default 2. More links make straighter paths and cost
    /// time and memory with the third power; under 1.6 graphs fall apart.
    pub reach: f32,
    /// An edge costs its length times a random weight from `low` to 1; 0.01 to 1. Default 0.25.
    pub low: f32,
    /// Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Default 1.
    pub bias: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_link_params {
    const NAME: &'static str = "tree_link_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let LinkParams { reach, low, bias } = LinkParams::default();
        Self {
            struct_size: size_of::<Self>(),
            paints: std::ptr::null(),
            n_paints: 0,
            cost: None,
            cost_user: std::ptr::null_mut(),
            obstacle: std::ptr::null(),
            clearance: 0.0,
            reach,
            low,
            bias,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_link_params_init(
    params: *mut tree_link_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether the segment from `a` to `b`, three floats each, stays outside `obstacle` by at least
/// `clearance` metres, 0 or more: 1 or 0. Where both are the same it is asked of the one point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_obstacle_is_free(
    obstacle: *const tree_volume,
    clearance: f32,
    a: *const f32,
    b: *const f32,
    is_free: *mut u32,
) -> tree_status {
    call(|| {
        let volume = unsafe { get(obstacle, "obstacle") }?.rust().clone();
        let obstacle = Obstacle { volume, clearance };
        obstacle.validate()?;
        let answer = unsafe { obstacle.is_free(vec3(a, "a")?, vec3(b, "b")?) };
        unsafe { out_value(is_free, answer.into(), "is_free") }
    })
}
