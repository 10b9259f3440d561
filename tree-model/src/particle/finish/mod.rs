//! From traces to a tree: smoothing, radii, twigs and leaves (Neubert 2012, sections 3.6 and 5.4).
//!
//! 1. [`grow_wood`]: traces are thinned and smoothed, and get radii by the pipe model, with the trunk as thick
//!    as the images show it.
//! 2. [`grow_crown`]: twigs and leaves in proportion to the density; what falls on empty parts of an image
//!    is discarded. There are as many twigs as leaves need places, and on a bare tree as many as the images
//!    show, within what [`FinishParams::twigs`] allows.
//!
//! [`FinishParams::find`] has the twigs and leaves of a species, as sprays: one card for what would take many
//! leaves. [`FinishParams::of`] has single leaves.
//!
//! Departure: the thesis places leaves by density alone. Here they are then counted in the images and the
//! density is put right where they cover more or less than the matte asks for; see [`FinishParams::corrections`].
//!
//! Cost: O((nodes + leaves + voxels) × corrections).

mod crown;
mod demand;
mod params;
mod preset;
mod sight;
mod wood;

pub use crown::{CrownReport, grow_crown};
pub use params::FinishParams;
pub use wood::grow_wood;
