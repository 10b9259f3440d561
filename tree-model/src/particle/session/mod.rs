//! The whole way from photographs to a tree, stage by stage, with changes in between (Neubert 2012,
//! chapter 3; painting as in Fig. 3.12).
//!
//! A [`Session`] holds [`Shot`]s, parameters, a seed, and what has been made of them. Each [`Stage`] is done
//! when its result, or that of a later one, is first asked for:
//!
//! 1. [`Session::views`]: cameras, and an imagined side where all photographs are from one.
//! 2. [`Session::attractors`]: main branches, by livewire or as given.
//! 3. [`Session::density`], from the views alone.
//! 4. [`Session::fields`], from the attractors.
//! 5. [`Session::traces`], from density and fields.
//! 6. [`Session::wood`] and [`Session::tree`].
//!
//! A change ([`Session::paint`], [`Session::edit_attractor`], [`Session::set_params`] and others) forgets the
//! results that depend on it and no others; [`Session::runs`] tells what was done again. Matting is not a
//! stage: shots come with their mattes, and [`Session::set_matte`] brings a new one. [`PhotoModel`] is the same
//! without changes in between.
//!
//! Departure: where all photographs are from one side, the first, mirrored, is also taken as a view from a quarter
//! turn round, see [`PhotoParams::imagine`]. One silhouette says nothing about depth, and a crown filled evenly
//! from front to back looks solid from the side.
//!
//! The only module of the family with state between calls. Memory: the photographs, mattes and one result for each
//! stage; twice the first two, as the views have copies.

mod edit;
mod params;
mod pictures;
mod report;
mod shot;
mod stages;

pub use params::PhotoParams;
pub use report::{PhotoReport, PhotoTree, ViewReport};
pub use shot::{Attractor, Placing, Shot};
pub use stages::{Session, Stage};

use crate::{ModelError, Modeler};
use tree_core::{Control, Seed, Tree};

/// Photographs and parameters, for [`Modeler`].
#[derive(Clone, Debug, PartialEq)]
pub struct PhotoModel {
    /// The photographs, at least one.
    pub shots: Vec<Shot>,
    /// All parameters.
    pub params: PhotoParams,
}

impl Modeler for PhotoModel {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        let mut session = Session::new(self.shots.clone(), self.params.clone(), seed)?;
        Ok(session.tree(control)?.tree.clone())
    }
}
