//! All parameters of the way from photographs to a tree.

use crate::error::{Result, check};
use crate::particle::attractor::{LivewireParams, SeedParams, StrokeParams};
use crate::particle::density::DensityParams;
use crate::particle::field::FieldParams;
use crate::particle::finish::FinishParams;
use crate::particle::flow::FlowParams;
use tree_core::Seed;

/// All parameters of the way from photographs to a tree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct PhotoParams {
    /// Height of the tree in metres, 0.01 to 1000. Default 10.
    pub height: f32,
    /// Whether a side is imagined where all photographs are from one side (or its back): the first photograph,
    /// mirrored, from a quarter turn round. Without it the depth of the crown is filled evenly,
    /// as it is where the imagined side leaves nothing of the tree. Default true.
    pub imagine: bool,
    /// Points on each silhouette from which livewire seeks branches, 0 to 10,000. Default 40.
    pub branches: u32,
    /// Where those points are drawn from. They do not change with the tree's seed: what a photograph shows is
    /// the same for all trees made of it. Default 0.
    pub attractor_seed: Seed,
    /// Which points of the silhouette may be seeds.
    pub seeds: SeedParams,
    /// How livewire finds branches.
    pub livewire: LivewireParams,
    /// How drawn strokes are joined.
    pub strokes: StrokeParams,
    /// How the density is found.
    pub density: DensityParams,
    /// How branches steer particles.
    pub field: FieldParams,
    /// How particles move.
    pub flow: FlowParams,
    /// How traces become a tree.
    pub finish: FinishParams,
}

impl Default for PhotoParams {
    fn default() -> Self {
        Self {
            height: 10.0,
            imagine: true,
            branches: 40,
            attractor_seed: Seed(0),
            seeds: SeedParams::default(),
            livewire: LivewireParams::default(),
            strokes: StrokeParams::default(),
            density: DensityParams::default(),
            field: FieldParams::default(),
            flow: FlowParams::default(),
            finish: FinishParams::default(),
        }
    }
}

impl PhotoParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field, or as the parts do.
    pub fn validate(&self) -> Result<()> {
        check("height", self.height, 0.01_f32, 1000.0_f32)?;
        check("branches", self.branches, 0, 10_000)?;
        self.seeds.validate()?;
        self.livewire.validate()?;
        self.strokes.validate()?;
        self.density.validate()?;
        self.field.validate()?;
        self.flow.validate()?;
        self.finish.validate()
    }
}
