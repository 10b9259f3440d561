//! Parameters of the simulation.

use crate::error::{Result, check};

/// Most particles.
const MAX_PARTICLES: u32 = 10_000_000;

/// How particles move and join. Lengths are shares of the tree's height, so that the same numbers do for
/// a shrub and a giant.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct FlowParams {
    /// Particles, 1 to 10 million. The thesis takes 500 to 1000 for trees of medium size, 1000 to 2000 for large
    /// ones. Default 1500. Cost grows a little more than linearly.
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
    /// Pull along the images' direction fields, 0 to 10. Default 1. The pulls decide the direction only,
    /// so just their proportions matter.
    pub image: f32,
    /// Pull towards the base, through the densest way, 0 to 10. Default 0.3. Where no field says
    /// anything it counts in full.
    pub base: f32,
    /// Pull of the nearest neighbour when it is close, 0 to 10. Default 0.7. Larger joins twigs sooner.
    pub neighbour: f32,
    /// Way on which a lone particle turns most of the way into a new direction, 1e-4 to 1. Default 0.012.
    pub turn: f32,
    /// How much more reluctant joined particles are: the way of turning grows with mass to this power,
    /// 0 to 1. Default 0.15.
    pub inertia: f32,
    /// Cost of the way down the stem against that through the crown, 0.05 to 1 (no stem). Default 0.6.
    /// Where no image shows branches, they leave the stem at the angle whose cosine this is, by Snell's law.
    pub stem: f32,
    /// Least distance between nodes of a trace, 1e-4 to 0.2. Default 0.01.
    pub spacing: f32,
    /// Error of one step that is tolerated, as a share of `join`, 1e-4 to 1; worse steps are halved. Default 0.03.
    pub tolerance: f32,
}

impl Default for FlowParams {
    fn default() -> Self {
        Self {
            particles: 1500,
            steps: 200,
            step: 0.008,
            join: 0.02,
            sight: 0.1,
            image: 1.0,
            base: 0.3,
            neighbour: 0.7,
            turn: 0.012,
            inertia: 0.15,
            stem: 0.6,
            spacing: 0.01,
            tolerance: 0.03,
        }
    }
}

impl FlowParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check("flow.particles", self.particles, 1, MAX_PARTICLES)?;
        check("flow.steps", self.steps, 1, 100_000)?;
        check("flow.step", self.step, 1e-4_f32, 0.1_f32)?;
        check("flow.join", self.join, 1e-5_f32, 0.2_f32)?;
        check("flow.sight", self.sight, 0.0, 1.0)?;
        check("flow.image", self.image, 0.0, 10.0)?;
        check("flow.base", self.base, 0.0, 10.0)?;
        check("flow.neighbour", self.neighbour, 0.0, 10.0)?;
        check("flow.turn", self.turn, 1e-4_f32, 1.0)?;
        check("flow.inertia", self.inertia, 0.0, 1.0)?;
        check("flow.stem", self.stem, 0.05_f32, 1.0)?;
        check("flow.spacing", self.spacing, 1e-4_f32, 0.2_f32)?;
        check("flow.tolerance", self.tolerance, 1e-4_f32, 1.0)
    }
}
