//! What is known of a tree in the plane: branching systems within branching systems.
//!
//! A [`System`] is an axis, the outline of its foliage and the laterals on it. A [`Lateral`] whose outline was drawn bears a system
//! itself. All lines and outlines of all levels are in the plane of the drawing, in metres, as a person sees them
//! when zooming in. [`System::grow`] is the first step of every level: bumps, branches, sub-silhouettes, coverage.

mod cover;
mod crown;
mod document;
mod lateral;
mod raster;
mod system;

pub use cover::{CoverParams, Coverage};
pub(super) use cover::{END, ROUND};
pub(super) use crown::axis_of;
pub use document::{DrawnLeaf, Plan};
pub use lateral::{Lateral, Origin};
pub(super) use system::turned_base;
pub use system::{Section, System, SystemParams};
