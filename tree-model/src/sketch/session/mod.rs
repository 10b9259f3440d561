//! The whole way from a drawing to a tree, stage by stage, with edits in between (Neubert 2012, section 4.3; edits are
//! its future work, section 4.9).
//!
//! A [`Session`] holds a [`Drawing`], parameters, templates, a seed, and what has been made of them. Each [`Stage`] is done
//! when its result, or that of a later one, is first asked for:
//!
//! 1. [`Session::cleaned`]: the strokes as a tree in the plane, and [`Session::crown`].
//! 2. [`Session::choices`]: the templates, best first, and [`Session::template`], the one taken.
//! 3. [`Session::inferred`]: depths, labels and Ω.
//! 4. [`Session::propagated`]: what the sketch leaves out.
//! 5. [`Session::wood`] and [`Session::tree`].
//!
//! Edits keep what does not depend on them. Once depths have been inferred, [`Session::add_stroke`] and
//! [`Session::erase_stroke`] leave those of all other branches, the scale, the template and Ω as they are; [`Session::set_depth`] moves a
//! tip or fork, and only what it bears is inferred anew. What grew on other branches stays too: each open end
//! has its own stream of randomness, named by its stroke. [`Session::infer_anew`] forgets all of that.
//!
//! [`SketchModel`] is the same without edits.

mod carry;
mod edit;
mod params;
mod report;
mod stages;
#[cfg(test)]
mod tests;

pub use params::SketchParams;
pub use report::{SketchReport, SketchTree};
pub use stages::{Session, Stage};

use super::Drawing;
use super::template::Template;
use crate::{ModelError, Modeler};
use tree_core::{Control, Seed, Tree, Volume};

/// A drawing and parameters, for [`Modeler`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SketchModel {
    /// The drawing.
    pub drawing: Drawing,
    /// All parameters.
    pub params: SketchParams,
    /// What is chosen from. Default `None`: the built-in templates.
    pub templates: Option<Vec<Template>>,
    /// What branches keep out of. Default `None`.
    pub obstacles: Option<Volume>,
}

impl Modeler for SketchModel {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        let mut session = Session::new(self.drawing.clone(), self.params.clone(), seed)?;
        if let Some(templates) = &self.templates {
            session.set_templates(templates.clone());
        }
        session.set_obstacles(self.obstacles.clone());
        Ok(session.tree(control)?.tree.clone())
    }
}
