//! Depths, labels and Ω of a sketch.

use super::branches::tree_sketch_branches;
use super::omega::{omega, tree_sketch_omega};
use super::{tree_crown, tree_plan};
use crate::border::{
    Handle, Versioned, call, free, get, get_opt, init, out, read_or_default, slice, tree_status,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use std::ptr::null;
use tree_model::sketch::infer::{
    FactorRow, InferParams, Inferred, Pin, Posterior, Step, TraceRow, infer_with,
};
use tree_model::sketch::propagate::Propagated;
use tree_model::tree_core::{Control, Resource, Seed};

/// How depths, labels and Ω are inferred. Begin with `tree_sketch_infer_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_infer_params {
    /// `sizeof(tree_sketch_infer_params)`.
    pub struct_size: usize,
    /// Whether Ω stays the template's (Neubert 2012, section 4.6.1) or fits itself to the sketch (section 4.6.2).
    /// Default 0.
    pub keep_omega: u32,
    /// Rounds of refining depths and, unless `keep_omega`, of estimating Ω, 0 to 100. Default 6; the thesis needed
    /// fewer than 10.
    pub rounds: u32,
    /// Passes of ICM over all segments in each round, at most, 1 to 1000. Default 8.
    pub sweeps: u32,
    /// ICM ends where the depths of a pass changed by less than this share of the drawing's size altogether, 0 to 1.
    /// Default 0.0005.
    pub settled: f32,
    /// How many half-placed trees bottom-up inference keeps at once, 1 to 4096; 1 is the thesis. Large drawings get
    /// fewer, so that time stays linear. Default 64.
    pub beam: u32,
    /// How far angles and ratios spread as Ω says, 0 to 1. At 0 each segment aims at the means, as in the thesis, and
    /// all branches come out alike; at 1 each aims at a draw from Ω of its own. Default 1.
    pub spread: f32,
    /// How strongly branches keep out of each other's space (`k_e` of Eq. 4.22), 0 to 1000. Default 0.2.
    pub competition: f32,
    /// How much likelier, as the logarithm of a ratio, a stroke goes on as the same axis than as a lateral, 0 (the
    /// thesis) to 100. Default 3.
    pub follow: f32,
    /// Standard deviation in radians by which a stroke bends towards or away from the viewer from one segment to the
    /// next, 0.01 to 10. Small keeps curvy strokes in their plane. Default 0.3.
    pub bending: f32,
    /// Ω counts with so many imagined segments of the template when it is estimated, 0.1 to 1e6. Default 8.
    pub template_weight: f32,
    /// Branches that cross in the drawing keep this multiple of their thickness apart, 0 (off) to 10. Default 1.3.
    pub clearance: f32,
    /// Radius of the trunk as a share of the height, for the branches' thickness, 1e-4 to 0.2. Default 0.02.
    pub slenderness: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_infer_params {
    const NAME: &'static str = "tree_sketch_infer_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&InferParams::default())
    }
}

impl tree_sketch_infer_params {
    pub(super) fn of(params: &InferParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            keep_omega: params.keep_omega.into(),
            rounds: params.rounds,
            sweeps: params.sweeps,
            settled: params.settled,
            beam: params.beam,
            spread: params.spread,
            competition: params.competition,
            follow: params.follow,
            bending: params.bending,
            template_weight: params.template_weight,
            clearance: params.clearance,
            slenderness: params.slenderness,
        }
    }

    pub(super) fn rust(&self) -> InferParams {
        InferParams {
            keep_omega: self.keep_omega != 0,
            rounds: self.rounds,
            sweeps: self.sweeps,
            settled: self.settled,
            beam: self.beam,
            spread: self.spread,
            competition: self.competition,
            follow: self.follow,
            bending: self.bending,
            template_weight: self.template_weight,
            clearance: self.clearance,
            slenderness: self.slenderness,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_infer_params_init(
    params: *mut tree_sketch_infer_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes `params` those of the thesis alone: no beam, no spread, no preference for a stroke's own continuation, no
/// bending prior. Set `params->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_infer_params_thesis(
    params: *mut tree_sketch_infer_params,
) -> tree_status {
    call(|| {
        let thesis = tree_sketch_infer_params::of(&InferParams::thesis());
        unsafe { write(params, "params", &thesis) }
    })
}

/// A depth that is known: of the end of the segment that ends at a node of the plan.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, bytemuck::AnyBitPattern)]
pub struct tree_sketch_pin {
    /// Node of the plan: a tip or a fork.
    pub node: u32,
    /// Its depth in metres; positive is towards the viewer.
    pub depth: f32,
}

/// The posterior's logarithm, part by part.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_sketch_posterior {
    /// The whole: the sum of the others.
    pub total: f64,
    /// Sum of the factors between segments and their parents (Eq. 4.17).
    pub branches: f64,
    /// Competition for space (Eq. 4.22).
    pub competition: f64,
    /// Branches that cross without room, 0 where none does.
    pub crossings: f64,
    /// Ω, seen from the template.
    pub omega: f64,
}

impl tree_sketch_posterior {
    pub(super) fn of(posterior: &Posterior) -> Self {
        let Posterior { branches, competition, crossings, omega } = *posterior;
        Self { total: posterior.total(), branches, competition, crossings, omega }
    }
}

/// A step of inference: one of the `TREE_SKETCH_STEP_` constants.
pub type tree_sketch_step = u32;
/// Bottom-up inference.
pub const TREE_SKETCH_STEP_BOTTOM_UP: u32 = 0;
/// Passes of ICM.
pub const TREE_SKETCH_STEP_ICM: u32 = 1;
/// Branches swung to the other side.
pub const TREE_SKETCH_STEP_SWING: u32 = 2;
/// Crossing branches were moved apart.
pub const TREE_SKETCH_STEP_SEPARATE: u32 = 3;
/// Ω was estimated.
pub const TREE_SKETCH_STEP_OMEGA: u32 = 4;

/// The posterior after a step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_trace_row {
    /// The step.
    pub step: tree_sketch_step,
    /// 0.
    pub reserved: u32,
    /// The posterior after it.
    pub posterior: tree_sketch_posterior,
}

impl tree_sketch_trace_row {
    fn of(row: &TraceRow) -> Self {
        let step = match row.step {
            Step::BottomUp => TREE_SKETCH_STEP_BOTTOM_UP,
            Step::Icm => TREE_SKETCH_STEP_ICM,
            Step::Swing => TREE_SKETCH_STEP_SWING,
            Step::Separate => TREE_SKETCH_STEP_SEPARATE,
            Step::Omega => TREE_SKETCH_STEP_OMEGA,
        };
        Self { step, reserved: 0, posterior: tree_sketch_posterior::of(&row.posterior) }
    }
}

/// The factor of one segment, part by part, as logarithms.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_factor_row {
    /// The segment.
    pub segment: u32,
    /// 0.
    pub reserved: u32,
    /// ln p(s | Ω).
    pub scale: f64,
    /// ln p(α | Ω) or ln p(β | Ω).
    pub divergence: f64,
    /// ln p(γ | Ω); 0 where there is no roll.
    pub roll: f64,
    /// What the factors along strokes add.
    pub stroke: f64,
    /// Competition and crossings that change with this segment's depth.
    pub shared: f64,
}

impl tree_sketch_factor_row {
    fn of(row: &FactorRow) -> Self {
        let FactorRow { segment, scale, divergence, roll, stroke, shared } = *row;
        Self { segment, reserved: 0, scale, divergence, roll, stroke, shared }
    }
}

/// A sketch in space: what was inferred of it.
pub struct tree_inferred {
    inferred: Inferred,
    trace: Vec<tree_sketch_trace_row>,
    factors: Vec<tree_sketch_factor_row>,
    node_starts: Vec<u32>,
    nodes: Vec<u32>,
}

impl Handle for tree_inferred {
    const NAME: &'static str = "tree_inferred";
}

impl tree_inferred {
    pub(super) fn new(inferred: Inferred) -> Self {
        let mut node_starts = vec![0];
        let mut nodes = Vec::new();
        for segment in 0..inferred.branches.len() {
            nodes.extend(inferred.nodes(segment));
            node_starts.push(nodes.len() as u32);
        }
        Self {
            trace: inferred.trace.iter().map(tree_sketch_trace_row::of).collect(),
            factors: inferred.factors.iter().map(tree_sketch_factor_row::of).collect(),
            node_starts,
            nodes,
            inferred,
        }
    }
}

/// A view of what was inferred.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_inferred_columns {
    /// `sizeof(tree_inferred_columns)`.
    pub struct_size: usize,
    /// Number of segments; `tree_inferred_branches` has their points and labels.
    pub n_segments: usize,
    /// Where the nodes of each segment begin in `nodes`, and at last their number: `n_segments + 1` values.
    pub node_starts: *const u32,
    /// The plan's nodes that the points of each segment are, in their order; for an imagined root the base alone.
    pub nodes: *const u32,
    /// Number of nodes in `nodes`.
    pub n_nodes: usize,
    /// The posterior after each step. It never falls.
    pub trace: *const tree_sketch_trace_row,
    /// Number of steps.
    pub n_trace: usize,
    /// The factor of each segment but the root.
    pub factors: *const tree_sketch_factor_row,
    /// Number of factors.
    pub n_factors: usize,
    /// The posterior.
    pub posterior: tree_sketch_posterior,
    /// Crossings in the drawing of branches that could not be given room.
    pub n_interpenetrations: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_inferred_columns {
    const NAME: &'static str = "tree_inferred_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_segments: 0,
            node_starts: null(),
            nodes: null(),
            n_nodes: 0,
            trace: null(),
            n_trace: 0,
            factors: null(),
            n_factors: 0,
            posterior: tree_sketch_posterior::default(),
            n_interpenetrations: 0,
            reserved: 0,
        }
    }
}

/// Infers depths, labels and, unless it is to be kept, Ω, which begins as the template's, by inference in a Markov
/// random field (Neubert 2012, sections 4.4 to 4.6): a sketch is seen from the front, x and y of every branch are
/// drawn, its depth z is not. Depths that are known go in as `n_pins` `pins`, NULL for none, and stay. Ends that are
/// drawn inside `crown`, which may be NULL, stay in its surface of local revolution as far as the factors allow.
///
/// `omega`, `params` and `control` may be NULL. Free the result with `tree_inferred_free`. `TREE_ERROR_PARAMETER`
/// names what is out of range, `TREE_ERROR_INVALID` a pin that is at no fork or tip of the plan.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_infer(
    plan: *const tree_plan,
    omega: *const tree_sketch_omega,
    pins: *const tree_sketch_pin,
    n_pins: usize,
    crown: *const tree_crown,
    params: *const tree_sketch_infer_params,
    seed: u64,
    control: *const tree_control,
    inferred: *mut *mut tree_inferred,
) -> tree_status {
    call(|| {
        let place = unsafe { out(inferred, "inferred") }?;
        let plan = unsafe { get(plan, "plan") }?.rust();
        let omega = unsafe { self::omega(omega) }?;
        let limits = unsafe { limits(control) }?;
        let pins = unsafe { slice(pins, n_pins, &limits, Resource::Nodes, "pins") }?;
        let pins: Vec<_> =
            pins.iter().map(|pin| Pin { node: pin.node, depth: pin.depth }).collect();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let crown = unsafe { get_opt(crown, "crown") }?.map(tree_crown::rust);
        let known = (&pins[..], crown);
        let body =
            |control: &Control| Ok(infer_with(plan, &omega, known, &params, Seed(seed), control)?);
        place.put(tree_inferred::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Views what was inferred. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_inferred_view(
    inferred: *const tree_inferred,
    columns: *mut tree_inferred_columns,
) -> tree_status {
    call(|| {
        let held = unsafe { get(inferred, "inferred") }?;
        let found = tree_inferred_columns {
            n_segments: held.inferred.branches.len(),
            node_starts: column(&held.node_starts),
            nodes: column(&held.nodes),
            n_nodes: held.nodes.len(),
            trace: column(&held.trace),
            n_trace: held.trace.len(),
            factors: column(&held.factors),
            n_factors: held.factors.len(),
            posterior: tree_sketch_posterior::of(&held.inferred.posterior),
            n_interpenetrations: held.inferred.interpenetrations,
            ..tree_inferred_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// The segments, with labels and points in space; seen along -Z their points are those of the plan. Free them with
/// `tree_sketch_branches_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_inferred_branches(
    inferred: *const tree_inferred,
    branches: *mut *mut tree_sketch_branches,
) -> tree_status {
    call(|| {
        let place = unsafe { out(branches, "branches") }?;
        let found = unsafe { get(inferred, "inferred") }?.inferred.branches.clone();
        place.put(tree_sketch_branches::new(Propagated::bare(found)));
        Ok(())
    })
}

/// Ω of the sketch: the template's, or estimated. Set `omega->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_inferred_omega(
    inferred: *const tree_inferred,
    omega: *mut tree_sketch_omega,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(inferred, "inferred") }?.inferred.omega;
        unsafe { write(omega, "omega", &tree_sketch_omega::of(found)) }
    })
}

/// Frees what was inferred. Branches of it live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_inferred_free(inferred: *mut tree_inferred) -> tree_status {
    call(|| unsafe { free(inferred, "inferred") })
}
