//! From a growing tree to one that can be drawn: radii, leaves, ages.

use super::simulation::Growing;
use crate::error::Result;
use crate::foliage;
use tree_core::{Control, Foliage, Skeleton, Tree};

/// A grown tree and how it came about.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Grown {
    /// The tree.
    pub tree: Tree,
    /// Iterations since each node's segment grew: 0 for this year's. That of the base is its first
    /// internode's.
    pub ages: Vec<u32>,
    /// Gravelius order of the axis that each node grew on: 0 for the trunk.
    pub orders: Vec<u8>,
    /// What happened in each iteration.
    pub report: GrowthReport,
}

/// What happened while a tree grew.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct GrowthReport {
    /// One entry an iteration.
    pub years: Vec<YearReport>,
}

/// One iteration of one tree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct YearReport {
    /// Light that all buds found together.
    pub light: f32,
    /// Living buds before it grew.
    pub n_buds: u32,
    /// Buds that grew.
    pub n_shoots: u32,
    /// Shoots cut short by an obstacle or the ground.
    pub n_blocked: u32,
    /// Nodes shed.
    pub n_shed: u32,
    /// Nodes afterwards.
    pub n_nodes: u32,
}

impl Growing {
    pub(super) fn finish(&self, control: &Control) -> Result<Grown> {
        let stem = &self.stem;
        let radii = vec![0.0; stem.len()];
        let mut skeleton =
            Skeleton::from_columns(stem.positions.clone(), radii, stem.parents.clone())?;
        self.habit.radii.apply(&mut skeleton)?;
        let leaves = match &self.habit.leaves {
            Some(leaves) => {
                foliage::grow_leaves(&skeleton, leaves, self.seed.stream("leaves"), control)?
            }
            None => Foliage::default(),
        };
        let tree = Tree::new(skeleton, leaves, self.habit.species.clone())?;
        let ages = stem.born.iter().map(|&born| self.age().saturating_sub(born)).collect();
        let report = GrowthReport { years: self.years.clone() };
        Ok(Grown { tree, ages, orders: stem.orders.clone(), report })
    }
}
