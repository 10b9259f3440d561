//! How particles move and join.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_model::particle::flow::{FlowParams, FlowReport};

/// How particles move and join. Lengths are shares of the tree's height, so that the same numbers do for a
/// shrub and a giant. Begin with `tree_flow_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_flow_params {
    /// `sizeof(tree_flow_params)`.
    pub struct_size: usize,
    /// Particles, 1 to 10 million: 500 to 1000 for trees of medium size, 1000 to 2000 for large ones.
    /// Default 1500. Cost grows a little more than linearly.
    pub particles: u32,
    /// Steps after which particles still on their way are steered straight to the base, 1 to 100,000.
    /// Default 200.
    pub steps: u32,
    /// Way of a particle in one step, 1e-4 to 0.1. Default 0.008. Smaller is smoother and slower.
    pub step: f32,
    /// Particles nearer than this join, 1e-5 to 0.2. Default 0.02. Larger gives fewer, longer branches.
    pub join: f32,
    /// How far a particle sees its nearest neighbour, 0 to 1. Default 0.1.
    pub sight: f32,
    /// Pull along the pictures' direction fields, 0 to 10. Default 1. The pulls decide the direction only,
    /// so just their proportions matter.
    pub image: f32,
    /// Pull towards the base, through the densest way, 0 to 10. Default 0.3. Where no field says anything
    /// it counts in full.
    pub base: f32,
    /// Pull of the nearest neighbour when it is close, 0 to 10. Default 0.7. Larger joins twigs sooner.
    pub neighbour: f32,
    /// Way on which a lone particle turns most of the way into a new direction, 1e-4 to 1. Default 0.012.
    pub turn: f32,
    /// How much more reluctant joined particles are: the way of turning grows with mass to this power, 0
    /// to 1. Default 0.15.
    pub inertia: f32,
    /// Cost of the way down the stem against that through the crown, 0.05 to 1 (no stem). Default 0.6.
    /// Where no picture shows branches, they leave the stem at the angle whose cosine this is.
    pub stem: f32,
    /// Least distance between nodes of a trace, 1e-4 to 0.2. Default 0.01.
    pub spacing: f32,
    /// Error of one step that is tolerated, as a share of `join`, 1e-4 to 1; worse steps are halved.
    /// Default 0.03.
    pub tolerance: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_flow_params {
    const NAME: &'static str = "tree_flow_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&FlowParams::default())
    }
}

impl tree_flow_params {
    /// The parameters in C's form.
    pub(crate) fn of(params: &FlowParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            particles: params.particles,
            steps: params.steps,
            step: params.step,
            join: params.join,
            sight: params.sight,
            image: params.image,
            base: params.base,
            neighbour: params.neighbour,
            turn: params.turn,
            inertia: params.inertia,
            stem: params.stem,
            spacing: params.spacing,
            tolerance: params.tolerance,
            reserved: 0,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(crate) fn rust(&self) -> FlowParams {
        FlowParams {
            particles: self.particles,
            steps: self.steps,
            step: self.step,
            join: self.join,
            sight: self.sight,
            image: self.image,
            base: self.base,
            neighbour: self.neighbour,
            turn: self.turn,
            inertia: self.inertia,
            stem: self.stem,
            spacing: self.spacing,
            tolerance: self.tolerance,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_flow_params_init(
    params: *mut tree_flow_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_flow_params_check(params: *const tree_flow_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What became of the particles.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_flow_report {
    /// `sizeof(tree_flow_report)`.
    pub struct_size: usize,
    /// Parts that the integrator cut all steps of all particles into.
    pub n_parts: u64,
    /// Particles that started.
    pub n_particles: u32,
    /// Joins of two particles.
    pub n_joins: u32,
    /// Particles that joined a trace whose particle had gone on.
    pub n_followed: u32,
    /// Particles, after joins, that reached the base on traces of their own.
    pub n_arrived: u32,
    /// Particles that were still on their way after `steps` and were steered to the base without heed to
    /// the pictures.
    pub n_steered: u32,
    /// Particles that could not even be steered and were led straight to the nearest trace.
    pub n_led: u32,
    /// Steps taken.
    pub n_steps: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_flow_report {
    const NAME: &'static str = "tree_flow_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&FlowReport::default())
    }
}

impl tree_flow_report {
    pub(crate) fn of(report: &FlowReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_parts: report.n_parts,
            n_particles: report.n_particles,
            n_joins: report.n_joins,
            n_followed: report.n_followed,
            n_arrived: report.n_arrived,
            n_steered: report.n_steered,
            n_led: report.n_led,
            n_steps: report.n_steps,
            reserved: 0,
        }
    }
}
