//! Which template suits a drawing.

use super::crown::tree_crown;
use super::fill_some;
use super::plan::tree_plan;
use super::template::tree_templates;
use crate::border::{Versioned, call, get, get_opt, init, read, read_or_default, tree_status};
use crate::control::{run, tree_control};
use tree_model::sketch::crown::Crown;
use tree_model::sketch::template::{Choice, DrawnShape, SelectParams, select};

/// How much the parts of the comparison weigh. Begin with `tree_template_select_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_template_select_params {
    /// `sizeof(tree_template_select_params)`.
    pub struct_size: usize,
    /// Weight of the crown's footprint, 0 to 1000. Default 40.
    pub crown: f32,
    /// Weight of the branches' footprint, 0 to 1000. Default 40.
    pub branches: f32,
    /// Weight of the branching shape, 0 to 1000. Default 1.
    pub shape: f32,
    /// Weight of the directions of branches, 0 to 1000. Default 15.
    pub directions: f32,
    /// Added to every deviation of the branching shape, 0.001 to 10: what the hand adds. Default 0.3.
    pub hand: f32,
    /// What one of the branching shape's three parts can take away at most, 0 to 1000. Default 2.
    pub most: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_template_select_params {
    const NAME: &'static str = "tree_template_select_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SelectParams::default())
    }
}

impl tree_template_select_params {
    pub(crate) fn of(params: &SelectParams) -> Self {
        let SelectParams { crown, branches, shape, directions, hand, most } = *params;
        Self { struct_size: size_of::<Self>(), crown, branches, shape, directions, hand, most }
    }

    pub(crate) fn rust(&self) -> SelectParams {
        SelectParams {
            crown: self.crown,
            branches: self.branches,
            shape: self.shape,
            directions: self.directions,
            hand: self.hand,
            most: self.most,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_template_select_params_init(
    params: *mut tree_template_select_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_template_select_params_check(
    params: *const tree_template_select_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// A template, and how well it suits a drawing.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_template_choice {
    /// Index of the template.
    pub index: u32,
    /// Where the eye stands round the template in the view that suits best, in radians, 0 to 2π.
    pub yaw: f32,
    /// 0 for a perfect match, else below: the sum of the four parts.
    pub score: f32,
    /// The crown's part, weighted; 0 where no crown is drawn.
    pub crown: f32,
    /// The part of the branches' footprint, weighted.
    pub branches: f32,
    /// The branching shape's part, weighted.
    pub shape: f32,
    /// The directions' part, weighted.
    pub directions: f32,
}

impl tree_template_choice {
    pub(crate) fn of(choice: &Choice) -> Self {
        let Choice { template, yaw, score, crown, branches, shape, directions } = *choice;
        Self { index: template as u32, yaw, score, crown, branches, shape, directions }
    }
}

/// Compares a plan with templates: one row for each into `choices`, best first; `capacity` is the number of templates or
/// more. `crown` may be NULL for that which was drawn with the plan, as it was drawn. `params` and `control` may be NULL.
/// `TREE_ERROR_INVALID` where there are no templates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_select(
    templates: *const tree_templates,
    plan: *const tree_plan,
    crown: *const tree_crown,
    params: *const tree_template_select_params,
    control: *const tree_control,
    choices: *mut tree_template_choice,
    capacity: usize,
) -> tree_status {
    call(|| {
        let templates = unsafe { get(templates, "templates") }?.rust();
        let plan = unsafe { get(plan, "plan") }?;
        let crown = unsafe { get_opt(crown, "crown") }?.map(tree_crown::rust);
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |_: &_| {
            let corners = crown.map_or_else(|| plan.crown().concat(), Crown::corners);
            let drawn = DrawnShape::measure(plan.rust(), &corners);
            Ok(select(&drawn, templates, &params)?)
        };
        let found = unsafe { run(control, body) }?;
        let rows: Vec<_> = found.iter().map(tree_template_choice::of).collect();
        unsafe { fill_some(choices, capacity, &rows, "choices") }
    })
}
