//! Sub-silhouettes: the part of an outline that is one branch's.

use super::line::line_of;
use super::tree_outline;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, floats, foresee, get, init, out,
    out_value, read, read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use glam::Vec2;
use tree_model::silhouette::sub::{SubOutline, SubParams, sub_outline};

/// How sub-silhouettes are cut out. Begin with `tree_sub_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sub_params {
    /// `sizeof(tree_sub_params)`.
    pub struct_size: usize,
    /// Opening of the cone at a sharp feature, in radians, 0.02 to 3. Default 20°.
    pub narrow: f32,
    /// Opening where the radius at the end is the branch's span or more, in radians, 0.02 to 3. Default 110°.
    pub wide: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sub_params {
    const NAME: &'static str = "tree_sub_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SubParams::default())
    }
}

impl tree_sub_params {
    pub(crate) fn of(params: &SubParams) -> Self {
        let SubParams { narrow, wide } = *params;
        Self { struct_size: size_of::<Self>(), narrow, wide }
    }

    pub(crate) fn rust(&self) -> SubParams {
        SubParams { narrow: self.narrow, wide: self.wide }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sub_params_init(
    params: *mut tree_sub_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sub_params_check(params: *const tree_sub_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// Opening in radians of the cone of a branch of span `span` with radius `radius` at its end. `params` may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sub_params_opening(
    params: *const tree_sub_params,
    radius: f32,
    span: f32,
    angle: *mut f32,
) -> tree_status {
    call(|| {
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        unsafe { out_value(angle, params.opening(radius, span), "angle") }
    })
}

/// How a sub-silhouette hangs together with its parent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sub_report {
    /// `sizeof(tree_sub_report)`.
    pub struct_size: usize,
    /// Begin and end of the shared part, in metres along the parent against the clock from its first corner; the second
    /// may be greater than the perimeter. Both are one place where nothing could be shared.
    pub shared: [f32; 2],
    /// The points where the curves join the shared part: its begin, then its end.
    pub join_points: [f32; 4],
    /// Directions of the outline there, against the clock, of unit length.
    pub join_tangents: [f32; 4],
    /// The curves from the branch's base to the begin, and from the end to the base. Of each: where it begins, the
    /// derivative there, where it ends, the derivative there, two floats each, of a cubic Hermite curve.
    pub curves: [f32; 16],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sub_report {
    const NAME: &'static str = "tree_sub_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            shared: [0.0; 2],
            join_points: [0.0; 4],
            join_tangents: [0.0; 4],
            curves: [0.0; 16],
        }
    }
}

impl tree_sub_report {
    fn of(sub: &SubOutline) -> Self {
        let four = |a: Vec2, b: Vec2| [a.x, a.y, b.x, b.y];
        let [begin, end] = sub.joins;
        let parts = sub.curves.map(|c| [four(c.from, c.leaves), four(c.to, c.arrives)]);
        let mut curves = [0.0; 16];
        curves.copy_from_slice(parts.as_flattened().as_flattened());
        Self {
            struct_size: size_of::<Self>(),
            shared: sub.shared,
            join_points: four(begin.point, end.point),
            join_tangents: four(begin.tangent, end.tangent),
            curves,
        }
    }
}

/// Cuts out the part of a parent's outline that is a branch's. `branch` is its line, `n_branch` points of two floats each from
/// base to end, and `radius`, 0 or more, that of the disc at its end, as `tree_bump` has it. With `stretch`, two floats, only
/// that part of the parent is shared: from 0 to the perimeter, to as much more again; NULL for whatever the cone reaches.
/// `params`, `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline, which is simple
/// whatever the branch, with `tree_outline_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_sub(
    parent: *const tree_outline,
    branch: *const f32,
    n_branch: usize,
    radius: f32,
    stretch: *const f32,
    params: *const tree_sub_params,
    control: *const tree_control,
    report: *mut tree_sub_report,
    sub: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(sub, "sub") }?;
        unsafe { foresee(report, "report") }?;
        let parent = unsafe { get(parent, "parent") }?.rust();
        let branch = unsafe { line_of(branch, n_branch, control, "branch") }?;
        if !(radius >= 0.0 && radius.is_finite()) {
            let text = format!("radius is {radius}, allowed is 0 or more and finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let stretch = unsafe { stretch_of(stretch, parent.perimeter()) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let body = |_: &_| Ok(sub_outline(parent, &branch, radius, stretch, &params));
        let made = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_sub_report::of(&made)) }?;
        place.put(tree_outline::new(made.outline));
        Ok(())
    })
}

/// A part of an outline, or none.
unsafe fn stretch_of(stretch: *const f32, perimeter: f32) -> Result<Option<[f32; 2]>> {
    if stretch.is_null() {
        return Ok(None);
    }
    let [from, to] = unsafe { floats(stretch, "stretch") }?;
    if (0.0..=perimeter).contains(&from) && (from..=from + perimeter).contains(&to) {
        return Ok(Some([from, to]));
    }
    let text = format!(
        "stretch is {from} to {to}; it must begin between 0 and the perimeter, {perimeter}, and be no longer"
    );
    Err(Failure::new(TREE_ERROR_PARAMETER, text))
}
