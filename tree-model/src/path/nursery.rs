//! The subgraphs of one level: where they lie, and how long their branches go on.

use super::draft::Tip;
use super::graph::{LinkParams, Terrain};
use super::params::{Level, LevelAxis, Lifespan, SubShape};
use super::shoot::{Plot, Shoot, Workspace};
use crate::error::Result;
use glam::{Affine3A, Mat3, Quat, Vec3};
use tree_core::seed::{uniform, unit_vector};
use tree_core::{Control, Seed, Volume};

/// What all subgraphs of a level share.
pub(crate) struct Nursery<'a> {
    pub(crate) level: &'a Level,
    pub(crate) size: f32,
    pub(crate) linking: &'a LinkParams,
    pub(crate) terrain: &'a Terrain<'a>,
    pub(crate) control: &'a Control,
}

impl Nursery<'_> {
    /// Grows one subgraph.
    pub(crate) fn grow(&self, tip: &Tip, seed: Seed, workspace: &mut Workspace) -> Result<Shoot> {
        let volume = self.volume(tip, seed)?;
        let plot = Plot {
            volume: &volume,
            root: tip.position,
            graph_nodes: self.level.graph_nodes,
            random: self.level.branching,
            placed: &[],
            placing: self.level.placing,
            candidates: 1,
            above: f32::NEG_INFINITY,
            linking: self.linking,
            terrain: self.terrain,
        };
        plot.grow(seed, workspace, self.control)
    }

    /// The subgraph's volume: the level's shape, pointed along the axis (§3.3.2).
    fn volume(&self, tip: &Tip, seed: Seed) -> Result<Volume> {
        let axis = self.axis(tip, seed);
        let (root, end) = (tip.position, tip.position + axis * self.size);
        Ok(match &self.level.shape {
            SubShape::Sector { angle } => Volume::sector(root, axis, *angle, self.size)?,
            SubShape::Cone { width } => Volume::cone(root, end, width * self.size)?,
            SubShape::InvertedCone { width } => Volume::cone(end, root, width * self.size)?,
            SubShape::Custom(volume) => {
                let turn = Quat::from_rotation_arc(Vec3::Y, axis);
                let scale = Mat3::from_quat(turn) * self.size;
                volume.transformed(Affine3A::from_mat3_translation(scale, root))?
            }
        })
    }

    fn axis(&self, tip: &Tip, seed: Seed) -> Vec3 {
        let random = || unit_vector(&mut seed.stream("axis").rng());
        let axis = match self.level.axis {
            LevelAxis::Outward => (tip.position - tip.origin).try_normalize(),
            LevelAxis::Down => Some(Vec3::NEG_Y),
            LevelAxis::Fixed(axis) => axis.try_normalize(),
            LevelAxis::Random => None,
        }
        .unwrap_or_else(random);
        turned(axis, self.level.turn, random)
    }
}

/// Turns a direction about the horizontal, down for positive angles. A vertical one has no
/// horizontal of its own and takes that of `random`.
fn turned(axis: Vec3, turn: f32, random: impl Fn() -> Vec3) -> Vec3 {
    if turn == 0.0 {
        return axis;
    }
    // Turning from +Y towards an outward direction turns downwards.
    let horizontal = Vec3::Y
        .cross(axis)
        .try_normalize()
        .or_else(|| Vec3::Y.cross(random()).try_normalize())
        .unwrap_or(Vec3::X);
    (Quat::from_axis_angle(horizontal, turn) * axis).normalize()
}

impl Lifespan {
    /// What is left of a lifespan after one level; 0 ends the branch.
    pub(crate) fn after(self, life: u32, seed: Seed) -> u32 {
        match self {
            Self::Full => life.saturating_sub(1),
            Self::Random { stop } => {
                let mut rng = seed.rng();
                if uniform(&mut rng, 0.0, 1.0) < stop {
                    return 0;
                }
                // L − U(0, L), rounded up: a branch that does not stop goes on for a level at least.
                let left = life as f32 - uniform(&mut rng, 0.0, life as f32);
                (left.ceil() as u32).min(life.saturating_sub(1))
            }
        }
    }
}
