//! Branches in the plane: the angles they leave at, their lines, and their shape on other spans.

use super::line::{check_within, fill_line, line_of};
use super::measure::spot;
use super::tree_outline;
use crate::border::{
    Failure, Result, TREE_ERROR_INVALID, TREE_ERROR_NO_RESULT, TREE_ERROR_PARAMETER, Versioned,
    call, foresee, get, get_opt, init, out, out_value, read, read_or_default, slice, tree_status,
    view,
};
use crate::control::{limits, run, tree_control};
use crate::sketch::{answers, fill_some};
use glam::Vec2;
use tree_model::silhouette::Outline;
use tree_model::silhouette::branch::{
    self, BranchingAngles, InferParams, Shape, Span, base_of, infer,
};
use tree_model::tree_core::{Limits, Resource};

/// Most samples of a branching angle function.
const MAX_SAMPLES: u64 = 10_000;

/// The branching angle function: the angle between a parent's direction and that of its branches where they leave,
/// along the parent. Between samples it is interpolated, beyond them it is constant. Begin with
/// `tree_branching_angles_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branching_angles {
    /// `sizeof(tree_branching_angles)`.
    pub struct_size: usize,
    /// Number of samples, at most 10,000; 0 for those of `tree_branching_angles_init`.
    pub n_samples: usize,
    /// Two floats for each: place along the parent, 0 at its base to 1 at its tip, in rising order; and angle in
    /// radians, 0 (straight on) to π (backwards). Default 1.35 at the base to 0.6 at the tip: low branches are near
    /// horizontal, high ones near upright.
    pub samples: *const f32,
}

/// The default: a test keeps it equal to that of Rust.
static DEFAULT_ANGLES: [[f32; 2]; 2] = [[0.0, 1.35], [1.0, 0.6]];

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_branching_angles {
    const NAME: &'static str = "tree_branching_angles";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_samples: DEFAULT_ANGLES.len(),
            samples: DEFAULT_ANGLES.as_ptr().cast(),
        }
    }
}

impl tree_branching_angles {
    /// A view.
    pub(crate) fn of(angles: &BranchingAngles) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_samples: angles.samples.len(),
            samples: crate::mesh::column(&angles.samples).cast(),
        }
    }

    /// A copy, not yet checked against its ranges; `argument` is what it is called by.
    ///
    /// # Safety
    /// What it points at is as long as it says.
    pub(crate) unsafe fn rust(&self, argument: &str) -> Result<BranchingAngles> {
        if self.n_samples == 0 {
            return Ok(BranchingAngles::default());
        }
        let limits = Limits { nodes: MAX_SAMPLES, ..Limits::default() };
        let (name, nodes) = (format!("{argument}.samples"), Resource::Nodes);
        let samples: &[[f32; 2]] =
            unsafe { slice(self.samples.cast(), self.n_samples, &limits, nodes, &name) }?;
        Ok(BranchingAngles { samples: samples.to_vec() })
    }
}

/// Checked; NULL is the default.
unsafe fn angles_of(angles: *const tree_branching_angles) -> Result<BranchingAngles> {
    let angles = unsafe { read_or_default(angles, "angles")?.rust("angles") }?;
    angles.validate("angles")?;
    Ok(angles)
}

/// Makes `angles`, of `size` bytes, the default; its samples are valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branching_angles_init(
    angles: *mut tree_branching_angles,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(angles, size) })
}

/// The angles at `n_places` places along the parent, shares of its length from 0 to 1, into `values`, which has room for
/// `capacity`. `angles` and `control` may be NULL; `nodes` of the limits caps the places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branching_angles_at(
    angles: *const tree_branching_angles,
    places: *const f32,
    n_places: usize,
    control: *const tree_control,
    values: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let angles = unsafe { angles_of(angles) }?;
        let nodes = Resource::Nodes;
        let places = unsafe { slice(places, n_places, &limits(control)?, nodes, "places") }?;
        let found = unsafe { answers(places, control, |&place| angles.at(place)) }?;
        unsafe { fill_some(values, capacity, &found, "values") }
    })
}

/// Takes the angle of a redrawn branch as a sample; it replaces those close to it, but the function keeps its ends. The
/// samples go into `samples`, two floats each; `capacity` counts floats: two more samples than there are always have room.
/// `n_samples` gets their number. `angles` stays as it is, and may be NULL for the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branching_angles_set(
    angles: *const tree_branching_angles,
    place: f32,
    angle: f32,
    samples: *mut f32,
    capacity: usize,
    n_samples: *mut usize,
) -> tree_status {
    call(|| {
        let mut angles = unsafe { angles_of(angles) }?;
        if !(place.is_finite() && angle.is_finite()) {
            let text = format!("place is {place} and angle is {angle}: both must be finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        angles.set(place, angle);
        let flat = angles.samples.as_flattened();
        unsafe { fill_some(samples, capacity, flat, "samples") }?;
        unsafe { out_value(n_samples, angles.samples.len(), "n_samples") }
    })
}

/// How branches are inferred. Begin with `tree_branch_infer_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branch_infer_params {
    /// `sizeof(tree_branch_infer_params)`.
    pub struct_size: usize,
    /// Places along the parent that are tried, 2 to 10,000. Default 48.
    pub places: u32,
    /// Points of a branch, 2 to 1000. Default 16.
    pub points: u32,
    /// Length of the tangents over the distance of base and end, 0 (straight) to 2. Default 0.5.
    pub tangents: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_branch_infer_params {
    const NAME: &'static str = "tree_branch_infer_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&InferParams::default())
    }
}

impl tree_branch_infer_params {
    pub(crate) fn of(params: &InferParams) -> Self {
        let InferParams { places, points, tangents } = *params;
        Self { struct_size: size_of::<Self>(), places, points, tangents, reserved: 0 }
    }

    pub(crate) fn rust(&self) -> InferParams {
        InferParams { places: self.places, points: self.points, tangents: self.tangents }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_infer_params_init(
    params: *mut tree_branch_infer_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_infer_params_check(
    params: *const tree_branch_infer_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// Infers the branch that ends at `end` along `tangent` (two floats each; a tangent of zeros: from where it comes): the
/// shortest curve from the parent, which is left at the branching angle. `parent` has `n_parent` points, two floats each, from
/// its base to its tip; the branch may leave it between the shares `from` and `to` of its length, 0 and 1 for anywhere.
/// `outline` is that of the foliage, which the branch keeps within where it can; NULL where there is none. The
/// branch's line goes into `points`, from base to end, two floats each; `capacity` counts floats, and two for each of `points`
/// of the parameters always do. `n_points` gets their number, `share` where it leaves the parent. `angles`, `params` and
/// `control` may be NULL; `nodes` of the limits caps the points. `TREE_ERROR_NO_RESULT` where the end lies on the parent.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_infer(
    parent: *const f32,
    n_parent: usize,
    outline: *const tree_outline,
    angles: *const tree_branching_angles,
    end: *const f32,
    tangent: *const f32,
    from: f32,
    to: f32,
    params: *const tree_branch_infer_params,
    control: *const tree_control,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
    share: *mut f32,
) -> tree_status {
    call(|| {
        let parent = unsafe { line_of(parent, n_parent, control, "parent") }?;
        let angles = unsafe { angles_of(angles) }?;
        let goal = unsafe { (spot(end, "end")?, spot(tangent, "tangent")?) };
        check_within(from, to)?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let outline = unsafe { get_opt(outline, "outline") }?.map(tree_outline::rust);
        let is_inside = |at: Vec2| outline.is_none_or(|outline| outline.contains(at));
        let body = |_: &_| Ok(infer(&parent, &angles, goal, [from, to], &is_inside, &params));
        let Some(branch::Inferred { t, line }) = unsafe { run(control, body) }? else {
            let text = "end lies on the parent: no branch leads there";
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        unsafe { out_value(share, t, "share") }?;
        unsafe { fill_line(&line, points, capacity, n_points) }
    })
}

/// Where a drawn branch leaves its parent: `share` gets the place nearest to its start as a share of the parent's length,
/// `angle` the angle there in radians, 0 to π, and `is_left` whether the branch is on the parent's left side. Both are lines of
/// two floats a point, from base to tip. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_base(
    parent: *const f32,
    n_parent: usize,
    branch: *const f32,
    n_branch: usize,
    control: *const tree_control,
    share: *mut f32,
    angle: *mut f32,
    is_left: *mut u32,
) -> tree_status {
    call(|| {
        let parent = unsafe { line_of(parent, n_parent, control, "parent") }?;
        let branch = unsafe { line_of(branch, n_branch, control, "branch") }?;
        let (t, leaves, left) = base_of(&parent, &branch);
        unsafe { out_value(share, t, "share") }?;
        unsafe { out_value(angle, leaves, "angle") }?;
        unsafe { out_value(is_left, left.into(), "is_left") }
    })
}

/// From where to where a branch runs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branch_span {
    /// Where it begins.
    pub base: [f32; 2],
    /// Where it ends.
    pub end: [f32; 2],
    /// Whether it is on its parent's left side: a shape is mirrored between the sides.
    pub left: u32,
}

impl tree_branch_span {
    fn rust(&self, argument: &str) -> Result<Span> {
        let (base, end) = (Vec2::from_array(self.base), Vec2::from_array(self.end));
        Span::new(base, end, self.left != 0).ok_or_else(|| {
            let text = format!("{argument} must lead from one finite point to another");
            Failure::new(TREE_ERROR_INVALID, text)
        })
    }
}

/// What the shape of a branch is like, whatever its size.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branch_shape_report {
    /// `sizeof(tree_branch_shape_report)`.
    pub struct_size: usize,
    /// The angle in radians from the span to the direction the branch leaves in, positive towards the outer side, away
    /// from the parent's tip.
    pub leaving: f32,
    /// How far its outline reaches along the span, in spans; at least 1.
    pub reach: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_branch_shape_report {
    const NAME: &'static str = "tree_branch_shape_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), leaving: 0.0, reach: 0.0 }
    }
}

/// Carries the shape of a branch to another span. `branch` is its line, `n_branch` points from base to end of two floats
/// each, `left` says whether it is on its parent's left side, and `outline` is that of its foliage. The same line on `span`
/// goes into `points`; `capacity` counts floats, and `2 * n_branch` always do. `n_points` gets their number, `carried` the
/// outline there. `control` and `report` may be NULL; `nodes` of the limits caps the points. Free the outline with
/// `tree_outline_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_carry(
    branch: *const f32,
    n_branch: usize,
    left: u32,
    outline: *const tree_outline,
    span: *const tree_branch_span,
    control: *const tree_control,
    report: *mut tree_branch_shape_report,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
    carried: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(carried, "carried") }?;
        unsafe { foresee(report, "report") }?;
        let branch = unsafe { line_of(branch, n_branch, control, "branch") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        if span.is_null() {
            return Err(Failure::null("span"));
        }
        // SAFETY: not NULL, and there by contract.
        let span = unsafe { span.read_unaligned() }.rust("span")?;
        let Some(shape) = Shape::of(&branch, outline, left != 0) else {
            let text = "branch ends where it begins, or is too small: it has no shape";
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        };
        let on = |outline: &Outline| outline.transformed(|point| span.from_frame(point));
        let (Some(line), Some(made)) = (shape.line_on(&span), on(&shape.outline)) else {
            let text = "span is too short, or too far away: nothing is left of the branch there";
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        unsafe { fill_line(&line, points, capacity, n_points) }?;
        let (leaving, reach) = (shape.leaving(), shape.reach());
        let told = tree_branch_shape_report { leaving, reach, ..Versioned::default_value() };
        unsafe { view(report, "report", &told) }?;
        place.put(tree_outline::new(made));
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_angles_are_those_of_rust() {
        assert_eq!(BranchingAngles::default().samples, DEFAULT_ANGLES);
    }
}
