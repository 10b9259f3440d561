//! What a species brings along: how it branches, shares, turns and sheds.

use super::allocation::Allocation;
use crate::error::{Result, check};
use crate::foliage::{LeafParams, Phyllotaxis};
use std::f32::consts::PI;
use tree_core::Species;
use tree_core::allometry::PipeModel;

/// Most metamers of one shoot.
pub(super) const MAX_SHOOT: u32 = 64;

/// The species' part of a growing tree. Lengths in metres, angles in radians, times in iterations.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Habit {
    /// Length of an internode at whole vigour, 0.001 to 100; one of vigour v in a shoot of n metamers is
    /// v / n times as long. Default 0.12.
    pub internode: f32,
    /// Axillary buds: how many a node and how they are turned. Default a golden spiral.
    pub buds: Phyllotaxis,
    /// Only so many of a shoot's topmost metamers bear axillary buds, 1 to 64; 1 with whorled buds makes
    /// tiers of branches. Default 64: all.
    pub bud_zone: u32,
    /// Iterations after which an axillary bud that has not grown is dead, 0 to 10,000. Default 6.
    pub bud_life: u32,
    /// Angle between an internode and the buds at its end, 0 to π. Default 0.8 (46°).
    pub angle: f32,
    /// Standard deviation of branching and divergence angles, 0 to 1. Default 0.12.
    pub jitter: f32,
    /// Highest order of an axis, 0 (only the trunk) to 255. Default 12.
    pub max_order: u32,
    /// Most metamers a bud makes in one iteration, 1 to 64. Default 6.
    pub max_shoot: u32,
    /// How vigour is shared out.
    pub allocation: Allocation,
    /// Vigour at the base per light that all buds found (α), 0 to 100. Default 2.
    pub vigour: f32,
    /// Which way the trunk turns.
    pub trunk: Tropisms,
    /// Which way all other axes turn.
    pub branches: Tropisms,
    /// A branch with less light per metamer than this is shed, 0 (never) to 100. Default 0.12.
    pub shedding: f32,
    /// Youngest age at which a branch can be shed, 0 to 10,000. Default 2.
    pub shedding_age: u32,
    /// For how long a metamer has leaves and casts shadow, 1 to 10,000. Default 3.
    pub leaf_life: u32,
    /// Radii. Default the pipe model's.
    pub radii: PipeModel,
    /// Leaves; `None` for a bare tree. Default `Some`.
    pub leaves: Option<LeafParams>,
    /// Name, bark, and the kinds that `leaves.kind` counts.
    pub species: Species,
}

/// Weights against the direction in which an axis would go on by itself, which has 1. Each metamer turns by
/// them, so long shoots turn more.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Tropisms {
    /// Towards most light or space (ξ), -10 to 10. Default 0.25.
    pub photo: f32,
    /// Upwards (η), -10 to 10; negative: hanging. Default 0.12.
    pub gravi: f32,
    /// Towards the horizontal, 0 to 10. Default 0.
    pub plagio: f32,
}

impl Default for Tropisms {
    fn default() -> Self {
        Self { photo: 0.25, gravi: 0.12, plagio: 0.0 }
    }
}

impl Default for Habit {
    fn default() -> Self {
        Self {
            internode: 0.12,
            buds: Phyllotaxis::GOLDEN,
            bud_zone: MAX_SHOOT,
            bud_life: 6,
            angle: 0.8,
            jitter: 0.12,
            max_order: 12,
            max_shoot: 6,
            allocation: Allocation::default(),
            vigour: 2.0,
            trunk: Tropisms::default(),
            branches: Tropisms::default(),
            shedding: 0.12,
            shedding_age: 2,
            leaf_life: 3,
            radii: PipeModel::default(),
            leaves: Some(LeafParams::default()),
            species: Species::default(),
        }
    }
}

impl Tropisms {
    fn validate(&self, field: &str) -> Result<()> {
        check(format!("{field}.photo"), self.photo, -10, 10)?;
        check(format!("{field}.gravi"), self.gravi, -10, 10)?;
        check(format!("{field}.plagio"), self.plagio, 0, 10)
    }
}

impl Habit {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) or
    /// [`ModelError::NotFinite`](crate::ModelError::NotFinite), naming the field.
    pub fn validate(&self) -> Result<()> {
        check("habit.internode", self.internode, 0.001_f32, 100)?;
        self.buds.validate("habit.buds")?;
        check("habit.bud_zone", self.bud_zone, 1, MAX_SHOOT)?;
        check("habit.bud_life", self.bud_life, 0, 10_000)?;
        check("habit.angle", self.angle, 0, PI)?;
        check("habit.jitter", self.jitter, 0, 1)?;
        check("habit.max_order", self.max_order, 0, 255)?;
        check("habit.max_shoot", self.max_shoot, 1, MAX_SHOOT)?;
        self.allocation.validate()?;
        check("habit.vigour", self.vigour, 0, 100)?;
        self.trunk.validate("habit.trunk")?;
        self.branches.validate("habit.branches")?;
        check("habit.shedding", self.shedding, 0, 100)?;
        check("habit.shedding_age", self.shedding_age, 0, 10_000)?;
        check("habit.leaf_life", self.leaf_life, 1, 10_000)?;
        self.radii.validate()?;
        if let Some(leaves) = &self.leaves {
            let n_kinds = self.species.leaf_kinds.len();
            check("habit.species.leaf_kinds.len()", n_kinds as f64, 1, u16::MAX)?;
            leaves.validate(n_kinds)?;
        }
        Ok(())
    }

    /// The turns of an axis of this order.
    pub(super) fn tropisms(&self, order: u8) -> &Tropisms {
        if order == 0 { &self.trunk } else { &self.branches }
    }
}
