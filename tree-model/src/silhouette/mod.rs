//! Drawn outlines become a tree, from coarse to fine: structure from silhouettes (Wither, Boudon, Cani & Godin 2009).
//!
//! A person draws the outline of the crown, then of one branch's foliage, then of a leaf. Branches are inferred, what is
//! drawn once spreads to the siblings, and the tree in space fits the outlines.
//!
//! 1. [`read`]: strokes of an SVG drawing in layers; whole silhouettes, masks and mattes become a trunk and a crown. [`outline`]: any stroke
//!    becomes a closed [`Outline`].
//! 2. [`bump`]: bumps by the chordal axis (section 3.1). [`branch`]: a branch to each, by the branching angle function (3.2); shapes
//!    that can be carried over (3.3). [`sub`]: sub-silhouettes by the cone rule (4.1).
//! 3. [`plan`]: systems of axis, outline and branches, level in level, with coverage (4.1).
//! 4. [`place`]: where branches stand in space: arrangements, the Gibbs process, the pseudo-surface of revolution (5).
//! 5. [`grow`]: styles are copied (4.2), patterns set down, gaps filled.
//!
//! [`session`] takes strokes one by one, or a whole drawing; [`stand`] takes a drawing of many trees. ARCHITECTURE.md lists where we leave the
//! paper; docs/SILHOUETTES.md says how to draw, and what this cannot do.
//!
//! ```
//! use tree_model::glam::Vec2;
//! use tree_model::silhouette::session::{Session, SilhouetteParams};
//! use tree_model::tree_core::{Control, Seed};
//!
//! let crown: Vec<Vec2> = (0..64)
//!     .map(|i| Vec2::Y * 6.0 + 3.0 * Vec2::from_angle(i as f32 / 64.0 * std::f32::consts::TAU))
//!     .collect();
//! let mut session = Session::new(SilhouetteParams::default(), Seed(1))?;
//! session.draw_trunk(&[Vec2::ZERO, Vec2::Y * 3.0, Vec2::Y * 6.0])?;
//! session.draw_crown(&crown)?;
//! let tree = session.tree(&Control::default())?.tree;
//! assert!(tree.foliage().len() > 100);
//! session.undo(); // the crown is gone
//! # Ok::<(), tree_model::ModelError>(())
//! ```
//!
//! A tree of fifty thousand elements takes some fifty milliseconds, a million half a second.

pub mod branch;
pub mod bump;
pub mod grow;
mod line;
pub mod outline;
pub mod place;
pub mod plan;
pub mod read;
pub mod session;
pub mod stand;
pub mod sub;

pub use line::Line;
pub use outline::{LeafOutline, Outline, OutlineParams, OutlineRepair};
