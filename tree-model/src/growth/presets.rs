//! Ready-made habits: what the growth model makes of a few well-known trees.
//!
//! Bark, and how leaves stand, are those of [`SPECIES`](crate::foliage::SPECIES); each leaf is a sprig, so that a crown closes with
//! as many as an engine draws. The numbers of growth were found by looking at pictures.

use super::{Allocation, GrowthParams, Habit, Shadow, Tropisms, World};
use crate::error::{ModelError, Result};
use crate::foliage::{LeafParams, Phyllotaxis, SpeciesPreset};
use crate::growth::Environment;
use tree_core::Species;
use tree_core::allometry::PipeModel;

/// A named set of parameters.
///
/// ```
/// use tree_model::growth::Preset;
/// let poplar = Preset::find("poplar")?.params();
/// assert!(poplar.habit.angle < 0.7);
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    name: &'static str,
    /// Row of the species, for leaves and bark.
    species: &'static str,
    iterations: u32,
    /// Edge of a voxel in internodes.
    voxel: f32,
    shadow: [f32; 2],
    /// Tip radius and exponent.
    pipe: [f32; 2],
    /// Kind, size and spacing of the sprigs, the latter in metres.
    sprigs: (&'static str, f32, f32),
    habit: Row,
}

/// How sprigs stand on shoots.
const SPRIGS: LeafParams =
    LeafParams { bearing: 0.5, pitch: 0.8, droop: 0.1, phototropism: 0.55, ..LeafParams::DEFAULT };

/// The numbers of a habit.
#[derive(Clone, Copy, Debug)]
struct Row {
    internode: f32,
    buds: Phyllotaxis,
    bud_zone: u32,
    bud_life: u32,
    angle: f32,
    jitter: f32,
    max_order: u32,
    max_shoot: u32,
    allocation: Allocation,
    vigour: f32,
    trunk: Tropisms,
    branches: Tropisms,
    shedding: f32,
    leaf_life: u32,
}

const fn turns(photo: f32, gravi: f32, plagio: f32) -> Tropisms {
    Tropisms { photo, gravi, plagio }
}

const fn honda(lambda: f32, late: f32, turning: u32) -> Allocation {
    Allocation::BorchertHonda { lambda, late, turning }
}

/// All presets.
pub const PRESETS: [Preset; 6] = [
    Preset {
        name: "oak",
        species: "oak",
        iterations: 20,
        voxel: 1.5,
        shadow: [0.1, 1.8],
        pipe: [0.003, 2.3],
        sprigs: ("oak-cluster", 0.34, 0.1),
        habit: Row {
            internode: 0.16,
            buds: Phyllotaxis::GOLDEN,
            bud_zone: 64,
            bud_life: 4,
            angle: 0.95,
            jitter: 0.18,
            max_order: 8,
            max_shoot: 4,
            allocation: honda(0.53, 0.5, 15),
            vigour: 2.2,
            trunk: turns(0.1, 0.2, 0.0),
            branches: turns(0.06, -0.01, 0.0),
            shedding: 0.02,
            leaf_life: 3,
        },
    },
    Preset {
        name: "poplar",
        species: "poplar",
        iterations: 18,
        voxel: 1.5,
        shadow: [0.05, 1.6],
        pipe: [0.003, 2.4],
        sprigs: ("poplar-cluster", 0.34, 0.1),
        habit: Row {
            internode: 0.2,
            buds: Phyllotaxis::GOLDEN,
            bud_zone: 64,
            bud_life: 5,
            angle: 0.55,
            jitter: 0.26,
            max_order: 5,
            max_shoot: 7,
            allocation: honda(0.53, 0.52, 10),
            vigour: 2.2,
            trunk: turns(0.1, 0.4, 0.0),
            branches: turns(0.12, 0.25, 0.0),
            shedding: 0.01,
            leaf_life: 2,
        },
    },
    Preset {
        name: "birch",
        species: "birch",
        iterations: 18,
        voxel: 1.5,
        shadow: [0.08, 1.6],
        pipe: [0.002, 2.4],
        sprigs: ("birch-cluster", 0.3, 0.09),
        habit: Row {
            internode: 0.18,
            buds: Phyllotaxis::GOLDEN,
            bud_zone: 64,
            bud_life: 4,
            angle: 0.7,
            jitter: 0.3,
            max_order: 6,
            max_shoot: 7,
            allocation: honda(0.535, 0.52, 12),
            vigour: 2.3,
            trunk: turns(0.15, 0.35, 0.0),
            branches: turns(0.06, -0.08, 0.0),
            shedding: 0.02,
            leaf_life: 3,
        },
    },
    Preset {
        name: "pine",
        species: "pine",
        iterations: 18,
        voxel: 1.5,
        shadow: [0.08, 2.0],
        pipe: [0.003, 2.4],
        sprigs: ("pine-needles", 0.28, 0.08),
        habit: Row {
            internode: 0.18,
            buds: Phyllotaxis::Whorled { count: 5 },
            bud_zone: 1,
            bud_life: 3,
            angle: 1.2,
            jitter: 0.26,
            max_order: 2,
            max_shoot: 4,
            allocation: honda(0.53, 0.52, 12),
            vigour: 2.5,
            trunk: turns(0.0, 0.6, 0.0),
            branches: turns(0.08, 0.06, 0.15),
            shedding: 0.01,
            leaf_life: 4,
        },
    },
    Preset {
        name: "shrub",
        species: "linden",
        iterations: 10,
        voxel: 1.5,
        shadow: [0.08, 1.6],
        pipe: [0.002, 2.6],
        sprigs: ("linden-cluster", 0.26, 0.09),
        habit: Row {
            internode: 0.1,
            buds: Phyllotaxis::Decussate,
            bud_zone: 64,
            bud_life: 5,
            angle: 0.7,
            jitter: 0.15,
            max_order: 8,
            max_shoot: 5,
            allocation: honda(0.4, 0.42, 8),
            vigour: 1.8,
            trunk: turns(0.15, 0.1, 0.0),
            branches: turns(0.12, 0.05, 0.0),
            shedding: 0.01,
            leaf_life: 3,
        },
    },
    Preset {
        name: "maple",
        species: "maple",
        iterations: 18,
        voxel: 1.5,
        shadow: [0.08, 1.8],
        pipe: [0.003, 2.3],
        sprigs: ("maple-cluster", 0.36, 0.11),
        habit: Row {
            internode: 0.18,
            buds: Phyllotaxis::Decussate,
            bud_zone: 64,
            bud_life: 5,
            angle: 0.75,
            jitter: 0.2,
            max_order: 7,
            max_shoot: 4,
            allocation: Allocation::Priority { first: 1.0, last: 0.5, fall: 1.0 },
            vigour: 2.0,
            trunk: turns(0.2, 0.3, 0.0),
            branches: turns(0.1, 0.05, 0.0),
            shedding: 0.01,
            leaf_life: 3,
        },
    },
];

impl Preset {
    /// The preset of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        PRESETS.into_iter().find(|preset| preset.name == name).ok_or_else(|| {
            let known = PRESETS.map(|preset| preset.name).join(", ");
            ModelError::UnknownPreset { name: name.into(), known }
        })
    }

    /// Its name.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The parameters of a solitary tree.
    #[must_use]
    pub fn params(&self) -> GrowthParams {
        let row = &self.habit;
        let [strength, falloff] = self.shadow;
        let voxel = self.voxel * row.internode;
        let shadow = Shadow { voxel, strength, falloff, ..Shadow::default() };
        GrowthParams {
            iterations: self.iterations,
            world: World { environment: Environment::Shadow(shadow), ..World::default() },
            habit: self.habit(),
            ..GrowthParams::default()
        }
    }

    /// The habit alone, for stands.
    #[must_use]
    pub fn habit(&self) -> Habit {
        let row = &self.habit;
        let [tip_radius, exponent] = self.pipe;
        let (kind, size, spacing) = self.sprigs;
        let species = SpeciesPreset::find(self.species).ok();
        Habit {
            internode: row.internode,
            buds: row.buds,
            bud_zone: row.bud_zone,
            bud_life: row.bud_life,
            angle: row.angle,
            jitter: row.jitter,
            max_order: row.max_order,
            max_shoot: row.max_shoot,
            allocation: row.allocation,
            vigour: row.vigour,
            trunk: row.trunk,
            branches: row.branches,
            shedding: row.shedding,
            shedding_age: 2,
            leaf_life: row.leaf_life,
            radii: PipeModel { tip_radius, exponent, ..PipeModel::default() },
            leaves: Some(LeafParams {
                arrangement: species
                    .map_or(Phyllotaxis::GOLDEN, |species| species.leaves.arrangement),
                size,
                spacing,
                ..SPRIGS
            }),
            species: Species {
                name: self.name.into(),
                bark: species.map_or("oak", |species| species.bark).into(),
                leaf_kinds: vec![kind.into()],
            },
        }
    }
}
