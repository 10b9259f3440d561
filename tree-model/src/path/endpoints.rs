//! Step 2 of Xu & Mould's algorithm: where branches end.
//!
//! Departure: random endpoints are drawn among the graph's nodes that a path leads to, instead of
//! being added to the graph. Nodes fill the volume evenly, so the distribution is the same, no edge
//! has to be added, and no endpoint can be out of reach.

use super::params::Placing;
use super::search::Routes;
use glam::Vec3;
use rand::RngExt;
use tree_core::{Cancelled, Control, Rng, Volume};

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
    /// # Errors
    /// [`Cancelled`].
    ///
    /// # Complexity
    /// O(nodes + wanted) with one candidate each; O(wanted² · candidates) distances with more.
    pub(crate) fn draw(
        &self,
        wanted: u32,
        taken: &mut Vec<u32>,
        rng: &mut Rng,
        control: &Control,
    ) -> Result<(), Cancelled> {
        let mut pool = Pool { is_taken: vec![false; self.positions.len()], listed: None };
        for &node in taken.iter() {
            pool.is_taken[node as usize] = true;
        }
        for _ in 0..wanted {
            control.check()?;
            let mut best: Option<(f32, u32)> = None;
            for _ in 0..self.candidates {
                let Some(node) = self.candidate(&mut pool, rng) else { break };
                let room = if self.candidates == 1 { 0.0 } else { self.room(node, taken) };
                if best.is_none_or(|(most, _)| room > most) {
                    best = Some((room, node));
                }
            }
            let Some((_, node)) = best else { break };
            taken.push(node);
            pool.is_taken[node as usize] = true;
        }
        Ok(())
    }

    fn candidate(&self, pool: &mut Pool, rng: &mut Rng) -> Option<u32> {
        if pool.listed.is_none() {
            for _ in 0..TRIES {
                let node = rng.random_range(0..self.positions.len() as u32);
                if self.qualifies(node) && !pool.is_taken[node as usize] {
                    return Some(node);
                }
            }
        }
        let Pool { is_taken, listed } = pool;
        let list = listed.get_or_insert_with(|| {
            (0..self.positions.len() as u32).filter(|&node| self.qualifies(node)).collect()
        });
        // Nodes taken since the list was made are dropped when they are drawn.
        while !list.is_empty() {
            let at = rng.random_range(0..list.len());
            if !is_taken[list[at] as usize] {
                return Some(list[at]);
            }
            list.swap_remove(at);
        }
        None
    }

    fn qualifies(&self, node: u32) -> bool {
        let position = self.positions[node as usize];
        node != self.root
            && self.routes.reached(node)
            && position.y >= self.above
            && (self.placing == Placing::Volume || self.is_near_surface(position))
    }

    fn is_near_surface(&self, position: Vec3) -> bool {
        self.volume.distance(position).is_some_and(|distance| distance > -self.separation)
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

/// What can still be drawn.
struct Pool {
    is_taken: Vec<bool>,
    /// All nodes that qualify, once plain draws have failed too often.
    listed: Option<Vec<u32>>,
}
