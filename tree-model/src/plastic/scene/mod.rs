//! Trees, obstacles and a sky that can be moved, and what the trees make of it (Pirk et al. 2012, section 5).
//!
//! What the trees look like is a function of the scene alone, not of how it came about: an obstacle that is moved away leaves
//! no trace, and the order of edits does not matter. [`Scene::update`] redoes only what an edit touches: the light on a cluster where
//! something in its sky has changed, a segment where its light has or what it stands on.
//!
//! Steps of a season, for all trees at a time:
//! 1. Clusters move with the branches that carry them, and thin out with those that died.
//! 2. Every cluster gets the light that other clusters, trees and obstacles leave it.
//! 3. Segments of the season bend; those that meet a solid end there.
//! 4. Branches that starve die.

mod edit;
mod neighbours;
mod state;
mod step;
mod update;
mod work;

#[cfg(test)]
mod tests;

pub(super) use edit::Planted;
pub use edit::{ObstacleId, Scene, TreeId};
pub(super) use state::ALIVE;
pub use update::Update;
