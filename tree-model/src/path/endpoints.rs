//! Step 2 of Xu & Mould's algorithm: where branches end.
//!
//! Departure: random endpoints are drawn among the graph's nodes that a path leads to, instead of
//! being added to the graph. Nodes fill the volume evenly, so the distribution is the same, no edge
//! has to be added, and no endpoint can be out of reach.

use super::params::Placing;
use super::search::Routes;
use glam::Vec3;
use rand::RngExt;
use tree_core::{Rng, Volume};

/// Directions in which a node looks for the surface when the volume knows no distances.
const FEELERS: [Vec3; 14] = {
    const D: f32 = 0.577_350_26;
    [
        Vec3::X,
        Vec3::Y,
        Vec3::Z,
        Vec3::NEG_X,
        Vec3::NEG_Y,
        Vec3::NEG_Z,
        Vec3::new(D, D, D),
        Vec3::new(D, D, -D),
        Vec3::new(D, -D, D),
        Vec3::new(D, -D, -D),
        Vec3::new(-D, D, D),
        Vec3::new(-D, D, -D),
        Vec3::new(-D, -D, D),
        Vec3::new(-D, -D, -D),
    ]
};

/// Draws for each endpoint that may fall on a node that does not qualify, before all qualifying
/// nodes are listed. Most nodes qualify, and listing them costs more than a few draws.
const TRIES: u32 = 16;

/// Which nodes may be endpoints.
pub(crate) struct Choice<'a> {
    pub(crate) positions: &'a [Vec3],
    pub(crate) routes: &'a Routes,
    pub(crate) root: u32,
    pub(crate) volume: &'a Volume,
    pub(crate) separation: f32,
    pub(crate) placing: Placing,
    /// Least height in metres.
    pub(crate) above: f32,
    /// Candidates per endpoint.
    pub(crate) candidates: u32,
}

impl Choice<'_> {
    /// Draws `wanted` different nodes, none of them in `taken`, and appends them to it. Fewer when
    /// there are not so many.
    ///
    /// # Complexity
    /// O(wanted² · candidates) distances where candidates are above 1, else O(wanted²) at worst.
    pub(crate) fn draw(&self, wanted: u32, taken: &mut Vec<u32>, rng: &mut Rng) {
        let mut listed: Option<Vec<u32>> = None;
        for _ in 0..wanted {
            let mut best: Option<(f32, u32)> = None;
            for _ in 0..self.candidates {
                let Some(node) = self.candidate(taken, &mut listed, rng) else {
                    break;
                };
                let room = if self.candidates == 1 { 0.0 } else { self.room(node, taken) };
                if best.is_none_or(|(most, _)| room > most) {
                    best = Some((room, node));
                }
            }
            let Some((_, node)) = best else { return };
            taken.push(node);
            if let Some(list) = &mut listed {
                list.retain(|&n| n != node);
            }
        }
    }

    fn candidate(
        &self,
        taken: &[u32],
        listed: &mut Option<Vec<u32>>,
        rng: &mut Rng,
    ) -> Option<u32> {
        if listed.is_none() {
            for _ in 0..TRIES {
                let node = rng.random_range(0..self.positions.len() as u32);
                if self.qualifies(node) && !taken.contains(&node) {
                    return Some(node);
                }
            }
        }
        let list = listed.get_or_insert_with(|| {
            (0..self.positions.len() as u32)
                .filter(|node| self.qualifies(*node) && !taken.contains(node))
                .collect()
        });
        if list.is_empty() { None } else { Some(list[rng.random_range(0..list.len())]) }
    }

    fn qualifies(&self, node: u32) -> bool {
        let position = self.positions[node as usize];
        node != self.root
            && self.routes.reached(node)
            && position.y >= self.above
            && (self.placing == Placing::Volume || self.is_near_surface(position))
    }

    fn is_near_surface(&self, position: Vec3) -> bool {
        match self.volume.distance(position) {
            Some(distance) => distance > -self.separation,
            None => FEELERS
                .iter()
                .any(|&feeler| !self.volume.contains(position + feeler * self.separation)),
        }
    }

    /// Squared distance to the nearest endpoint there is.
    fn room(&self, node: u32, taken: &[u32]) -> f32 {
        let here = self.positions[node as usize];
        taken
            .iter()
            .map(|&other| here.distance_squared(self.positions[other as usize]))
            .fold(f32::INFINITY, f32::min)
    }
}
