//! The whole way from photographs to a tree, stage by stage, with changes in between.

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
