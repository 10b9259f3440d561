//! The skeleton while it grows: shoots are appended level by level.

use super::shoot::Shoot;
use crate::error::Result;
use glam::Vec3;
use tree_core::{NO_PARENT, Skeleton};

/// An endpoint from which the next level may grow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tip {
    pub(crate) node: u32,
    pub(crate) position: Vec3,
    /// Root of the graph it is an endpoint of.
    pub(crate) origin: Vec3,
    /// Levels it still has.
    pub(crate) life: u32,
}

/// The skeleton while it grows.
#[derive(Default)]
pub(crate) struct Draft {
    pub(crate) positions: Vec<Vec3>,
    parents: Vec<u32>,
    levels: Vec<u8>,
    /// Endpoints of the last level and of all before.
    last_tips: Vec<Tip>,
    earlier_tips: Vec<Tip>,
}

impl Draft {
    pub(crate) fn start(&mut self, shoot: &Shoot, life: u32) {
        self.positions.push(shoot.positions[0]);
        self.parents.push(NO_PARENT);
        self.levels.push(1);
        let root = Tip { node: 0, position: shoot.positions[0], origin: shoot.positions[0], life };
        let mut tips = Vec::new();
        self.append(shoot, &root, 1, &mut tips, |_| life);
        self.last_tips = tips;
    }

    /// Adds a shoot above `tip`, and its endpoints to `tips`.
    pub(crate) fn append(
        &mut self,
        shoot: &Shoot,
        tip: &Tip,
        level: u8,
        tips: &mut Vec<Tip>,
        life: impl Fn(u32) -> u32,
    ) {
        // The shoot's root is the tip's node, all others follow what is there already.
        let offset = self.positions.len() as u32;
        let global = |local: u32| {
            if local == 0 { tip.node } else { offset + local - 1 }
        };
        self.positions.extend_from_slice(&shoot.positions[1..]);
        self.parents.extend(shoot.parents[1..].iter().map(|&parent| global(parent)));
        self.levels.resize(self.positions.len(), level);
        tips.extend(shoot.tips.iter().enumerate().map(|(n, &local)| Tip {
            node: global(local),
            position: shoot.positions[local as usize],
            origin: tip.position,
            life: life(n as u32),
        }));
    }

    /// The endpoints to grow from that are alive, and how many are not.
    pub(crate) fn living_tips(&self, all_levels: bool) -> (Vec<Tip>, u64) {
        let earlier = if all_levels { self.earlier_tips.as_slice() } else { &[] };
        let alive: Vec<Tip> =
            earlier.iter().chain(&self.last_tips).copied().filter(|tip| tip.life > 0).collect();
        let ended = (earlier.len() + self.last_tips.len() - alive.len()) as u64;
        (alive, ended)
    }

    pub(crate) fn close_level(&mut self, tips: Vec<Tip>) {
        self.earlier_tips.append(&mut self.last_tips);
        self.last_tips = tips;
    }

    /// The skeleton, without radii yet, and the level of each node.
    pub(crate) fn finish(self) -> Result<(Skeleton, Vec<u8>)> {
        let radii = vec![0.0; self.positions.len()];
        Ok((Skeleton::from_columns(self.positions, radii, self.parents)?, self.levels))
    }
}

/// Puts a root system under a tree: both share node 0. The roots' radii are scaled so that they
/// leave the trunk's base with its radius.
pub(crate) fn join_roots(above: &Skeleton, below: &Skeleton) -> Result<Skeleton> {
    let offset = above.len() as u32;
    let base = below.radii()[0];
    let scale = if base > 0.0 { above.radii()[0] / base } else { 1.0 };
    let mut positions = above.positions().to_vec();
    let mut radii = above.radii().to_vec();
    let mut parents = above.parents().to_vec();
    positions.extend_from_slice(&below.positions()[1..]);
    radii.extend(below.radii()[1..].iter().map(|radius| radius * scale));
    parents.extend(
        below.segments().map(|(parent, _)| if parent == 0 { 0 } else { offset + parent - 1 }),
    );
    Ok(Skeleton::from_columns(positions, radii, parents)?)
}
