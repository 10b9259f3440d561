//! Trees that react: light, obstacles and neighbours bend, prune and fill them (Pirk et al. 2012).
//!
//! A tree that grew alone is read once ([`PlasticTree`]): the seasons of its branches, its leaf clusters in every season, the light
//! they had, what its branches would be without tropisms, and on how little light they live. In a [`Scene`] trees,
//! obstacles and the sky can be moved; [`Scene::update`] lets all trees live their seasons again, together, and
//! [`Scene::adapted`] gives the tree with its branchlets and leaves.
//!
//! ```
//! use std::sync::Arc;
//! use tree_model::lsystem::LSystem;
//! use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};
//! use tree_model::tree_core::{Control, Seed, Volume};
//! use tree_model::glam::Vec3;
//!
//! let control = Control::default();
//! let tree = LSystem::preset("oak")?.grow(Seed(1), &control)?.tree;
//! let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control)?);
//! let mut scene = Scene::new(Sky::default(), Response::default())?;
//! let id = scene.add_tree(model.clone(), Pose::default())?;
//! let wall = Volume::box_solid(Vec3::new(-0.1, 0.0, -8.0), Vec3::new(0.1, 9.0, 8.0))?;
//! let wall = scene.add_obstacle(wall, Pose::at(Vec3::X))?;
//! scene.update(&control)?;
//! let beside = scene.adapted(id, &control)?.tree;
//!
//! scene.remove_obstacle(wall)?;
//! scene.update(&control)?;
//! assert_eq!(&scene.adapted(id, &control)?.tree, model.tree()); // the input again, bit for bit
//! assert_ne!(&beside, model.tree());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Departures from the paper
//! * Eq. 2 divides by the growth rate ([`ages`]); as printed, fast branches would need more seasons for a metre than slow ones.
//! * Eq. 5: one factor for the relative distance, the volumes of the tips weighted by it, not a product over children that tends
//!   to 0 as they become many. Season after season the factors telescope, so each node's volume is one sum.
//! * The light on a branch is that on the cluster at its tips, not at each segment: inside its own cluster a segment has no
//!   light of its own. Inside a foreign cluster the cap it covers grows from half the sky to all of it.
//! * Intensity is cos² up to a right angle from the brightest point; printed, the far side of a low sun would shine again.
//! * Light comes in steps of 1/256, what keeps less than 1/250 of it is passed over, and clusters shade from places an eighth of
//!   their radius apart, so that an edit is felt where it matters.
//! * A branch is judged from its tips down, and what dies is a burden no more to what carries it. The trunk is never pruned.
//! * Branchlets of the input, not patches of a library, fill the clusters; in the environment of the input all stay where they
//!   are, and the adapted tree is the input, bit for bit.
//! * Beyond the paper: where branches died, others can grow into what light there is ([`Scene::regrown`]).
//!
//! # Accuracy
//! [`Light`] is a sum over 64 directions; against 10⁵ rays it errs by less than 2 % of the open sky (`evaluate -- plastic`).

mod adapted;
mod age;
mod analysis;
mod light;
mod lobe;
mod main_branches;
mod obstacle;
mod params;
mod plan;
mod pose;
mod prune;
mod regrowth;
pub mod scene;
mod shade;
mod tropism;

pub use adapted::{Adapted, AdaptedReport, NodeMotion};
pub use age::{Ages, ages};
pub use analysis::{LeafCluster, PlasticReport, PlasticTree};
pub use light::{Ball, Light, Sky};
pub use params::{PlasticParams, Response};
pub use pose::Pose;
pub use regrowth::{Regrown, Regrowth};
pub use scene::{ObstacleId, Scene, TreeId, Update};
pub use tropism::{Tropisms, bend, unbend};
