//! Parameters of growth.

use crate::error::{Result, check};
use crate::silhouette::branch::BranchingAngles;
use crate::silhouette::place::{Arrangement, GibbsParams};
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
use tree_core::Species;
use tree_core::allometry::PipeModel;

/// How the branches on axes of one level stand, and what they are like where nobody drew any.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct LevelParams {
    /// How they are arranged round the axis. Default [`Arrangement::Spread`].
    pub arrangement: Arrangement,
    /// Branches added in space for each one in the plane, 0 to 100. Default 2.
    pub density: f32,
    /// Branches in the plane on an axis where no system of the level was drawn, 0 to 4000, which is also the most in space. Default 18.
    pub count: u32,
    /// Angles of branches on axes of this level until they are redrawn. For the trunk's the session has its own.
    pub angles: BranchingAngles,
    /// How far branches are turned about their span from base to end, in radians, -2π to 2π: a slight spiral. Default 0, planar.
    pub spiral: f32,
    /// Variation of lengths, as a share, 0 to 0.9; angles vary by half of that in radians. Default 0.12.
    pub jitter: f32,
}

impl Default for LevelParams {
    fn default() -> Self {
        Self {
            arrangement: Arrangement::Spread,
            density: 2.0,
            count: 18,
            angles: BranchingAngles::between(1.1, 0.6),
            spiral: 0.0,
            jitter: 0.12,
        }
    }
}

/// The leaves.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Leaves {
    /// Length in metres, 1e-5 to 100; `None` for that of the drawn leaf, or else what suits the branches that bear them.
    pub length: Option<f32>,
    /// Distance of leaves along a branch in leaf lengths, all sides together, 0.001 to 100; `None` for what was drawn, or 0.25.
    pub spacing: Option<f32>,
    /// How they are arranged. Default the golden angle.
    pub arrangement: Arrangement,
    /// Angle to the branch, 0 to π; `None` for what was drawn, or 1.
    pub angle: Option<f32>,
    /// Share of the branch that is bare, from its base, 0 to 1; `None` for what was drawn, or 0.1.
    pub bare: Option<f32>,
    /// Petiole in leaf lengths, 0 to 10. Default 0.05.
    pub petiole: f32,
    /// How far upper faces are turned up, 0 (as they grow) to 1. Default 0.5.
    pub facing: f32,
    /// Variation of lengths, as a share, 0 to 0.9. Default 0.2.
    pub jitter: f32,
}

impl Default for Leaves {
    fn default() -> Self {
        Self {
            length: None,
            spacing: None,
            arrangement: Arrangement::golden(),
            angle: None,
            bare: None,
            petiole: 0.05,
            facing: 0.5,
            jitter: 0.2,
        }
    }
}

/// How a plan becomes a tree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct GrowParams {
    /// Levels of axes that bear branches: the trunk first. Levels beyond are as the last. Empty: all as by default.
    pub levels: Vec<LevelParams>,
    /// Levels of branches on the trunk, 1 to 8; `None` for those drawn, but two at least where no leaf tells.
    pub depth: Option<u32>,
    /// The leaves; `None` for a bare tree.
    pub leaves: Option<Leaves>,
    /// Names of the tree, its bark and its leaf, which is kind 0. Default an oak with clusters of leaves.
    pub species: Species,
    /// How far a sketched branch may stand off the drawing's plane, in radians, 0 to below π/2. Default π/4.
    pub domain: f32,
    /// The search for azimuths.
    pub gibbs: GibbsParams,
    /// Whether twigs and leaves that would be seen outside the outlines are left out. Default true.
    pub fence: bool,
    /// How full the outlines are made: leaf area in front of every cell of them over the cell's, 0 (what grows) to 10. Default 1.6.
    pub fill: f32,
    /// Radius of the trunk in metres, 1e-6 to 100; `None` for `slenderness` × height.
    pub trunk_radius: Option<f32>,
    /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    pub slenderness: f32,
    /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    pub exponent: f32,
}

impl Default for GrowParams {
    fn default() -> Self {
        Self {
            levels: Vec::new(),
            depth: None,
            leaves: Some(Leaves::default()),
            species: Species { leaf_kinds: vec!["oak-cluster".into()], ..Species::default() },
            domain: FRAC_PI_4,
            gibbs: GibbsParams::default(),
            fence: true,
            fill: 1.6,
            trunk_radius: None,
            slenderness: 0.018,
            exponent: PipeModel::MURRAY,
        }
    }
}

impl GrowParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        for (i, level) in self.levels.iter().enumerate() {
            let field = |name: &str| format!("grow.levels[{i}].{name}");
            level.arrangement.validate()?;
            check(field("density"), level.density, 0.0_f32, 100.0_f32)?;
            check(field("count"), level.count, 0, 4000)?;
            level.angles.validate(&field("angles"))?;
            check(field("spiral"), level.spiral, -TAU, TAU)?;
            check(field("jitter"), level.jitter, 0.0_f32, 0.9_f32)?;
        }
        check("grow.depth", self.depth.unwrap_or(1), 1, 8)?;
        if let Some(leaves) = &self.leaves {
            leaves.arrangement.validate()?;
            check("grow.leaves.length", leaves.length.unwrap_or(1.0), 1e-5_f32, 100.0_f32)?;
            check("grow.leaves.spacing", leaves.spacing.unwrap_or(1.0), 0.001_f32, 100.0_f32)?;
            check("grow.leaves.angle", leaves.angle.unwrap_or(1.0), 0.0_f32, PI)?;
            check("grow.leaves.bare", leaves.bare.unwrap_or(0.0), 0.0_f32, 1.0_f32)?;
            check("grow.leaves.petiole", leaves.petiole, 0.0_f32, 10.0_f32)?;
            check("grow.leaves.facing", leaves.facing, 0.0_f32, 1.0_f32)?;
            check("grow.leaves.jitter", leaves.jitter, 0.0_f32, 0.9_f32)?;
        }
        check("grow.domain", self.domain, 0.0_f32, FRAC_PI_2 - 0.05)?;
        self.gibbs.validate()?;
        check("grow.fill", self.fill, 0.0_f32, 10.0_f32)?;
        check("grow.trunk_radius", self.trunk_radius.unwrap_or(1.0), 1e-6_f32, 100.0_f32)?;
        check("grow.slenderness", self.slenderness, 1e-4_f32, 0.2_f32)?;
        check("grow.exponent", self.exponent, 1.0_f32, 10.0_f32)
    }

    /// The parameters of axes of a level.
    pub(in crate::silhouette) fn level(&self, level: u32) -> LevelParams {
        let last = self.levels.len().saturating_sub(1);
        self.levels.get((level as usize).min(last)).cloned().unwrap_or_default()
    }
}
