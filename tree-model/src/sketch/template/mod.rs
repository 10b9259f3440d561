//! Templates: what is known of trees before one is sketched (Neubert 2012, section 4.8).
//!
//! A template has the parameters Ω of an exemplar tree and, for views all round it, what a drawing of it would look
//! like: 2D statistics of its branching, footprints of crown and branches, and a silhouette. A drawing is compared with
//! all of them, and the best one guides the reconstruction.
//!
//! * [`exemplars`](Exemplar): twenty trees of different habit, made with the path modeler.
//! * [`main_branches`]: what a person would draw of a tree; [`project`]: the drawing.
//! * [`Template::of_tree`]: a template measured from any tree.
//! * [`Template::builtin`]: the templates shipped; [`parse`] and [`to_text`] for one's own.
//! * [`select`]: which template suits a drawing.

mod exemplars;
mod main_branches;
mod measure;
mod project;
mod select;
mod shape;
mod text;

pub use exemplars::{EXEMPLAR_SEED, EXEMPLARS, Exemplar};
pub use main_branches::{MainBranchParams, main_branches};
pub use measure::{DrawnShape, TemplateParams, crown_points};
pub use project::{project, seen_from};
pub use select::{Choice, SelectParams, select};
pub use shape::{BranchShape, DIRECTION_BINS, Directions};
pub use text::{parse, to_text};

use super::{Footprint, Omega};
use crate::error::{ModelError, Result, check};
use glam::Vec2;
use std::f32::consts::PI;
use std::sync::OnceLock;

/// A kind of tree to guide a reconstruction by.
#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// What it is called; one line.
    pub name: String,
    /// The species whose leaves it bears, a name in [`SPECIES`](crate::foliage::SPECIES) where it is built in; one line.
    pub species: String,
    /// Height of the exemplar in metres, above 0 to 1000: what a drawing is scaled to unless its height is given.
    pub height: f32,
    /// Radius of the trunk's base over the height, 0 to 1.
    pub slenderness: f32,
    /// Ω of its main branches.
    pub omega: Omega,
    /// What it looks like from round about, at least one view.
    pub views: Vec<TemplateView>,
}

/// What a template looks like from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct TemplateView {
    /// Where the eye stands round the trunk, in radians, 0 to 2π: 0 on +Z, a quarter turn on +X.
    pub yaw: f32,
    /// Statistics of the branching as seen.
    pub shape: BranchShape,
    /// Which way the branches go.
    pub directions: Directions,
    /// Footprint of crown and branches without the root branch.
    pub crown: Footprint,
    /// Footprint of the branches alone.
    pub branches: Footprint,
    /// Outline of the crown in metres, y up, the tree's base at the origin of y.
    pub silhouette: Vec<Vec2>,
}

static BUILTIN: OnceLock<Result<Vec<Template>, String>> = OnceLock::new();

impl Template {
    /// The templates shipped, of all [`EXEMPLARS`]. They are read on the first call.
    ///
    /// # Errors
    /// [`ModelError::Template`] if the data were damaged.
    pub fn builtin() -> Result<&'static [Self]> {
        let read = || parse(include_str!("templates.txt")).map_err(|error| error.to_string());
        match BUILTIN.get_or_init(read) {
            Ok(templates) => Ok(templates),
            Err(problem) => Err(ModelError::Template { problem: problem.clone() }),
        }
    }

    /// The built-in template of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<&'static Self> {
        let all = Self::builtin()?;
        all.iter().find(|template| template.name == name).ok_or_else(|| {
            let known: Vec<_> = all.iter().map(|template| template.name.as_str()).collect();
            ModelError::UnknownPreset { name: name.into(), known: known.join(", ") }
        })
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Template`] for names that are empty or have line breaks, and without views;
    /// [`ModelError::Parameter`] and [`ModelError::NotFinite`] naming the field.
    pub fn validate(&self) -> Result<()> {
        for (field, name) in [("name", &self.name), ("species", &self.species)] {
            if name.trim() != name || name.is_empty() || name.contains(char::is_control) {
                let problem =
                    format!("{field} {name:?} must be one line of text, without space round it");
                return Err(ModelError::Template { problem });
            }
        }
        check("height", self.height, 1e-3_f32, 1000.0)?;
        check("slenderness", self.slenderness, 0.0, 1.0)?;
        self.omega.validate()?;
        if self.views.is_empty() {
            return Err(ModelError::Template {
                problem: "there is no view: give at least one".into(),
            });
        }
        self.views.iter().enumerate().try_for_each(|(number, view)| view.validate(number))
    }
}

impl TemplateView {
    fn validate(&self, number: usize) -> Result<()> {
        check(format!("views[{number}].yaw"), self.yaw, 0.0, 2.0 * PI)?;
        let shape = &self.shape;
        for (name, normal) in [("scale", shape.scale), ("alpha", shape.alpha), ("beta", shape.beta)]
        {
            let Some(normal) = normal else { continue };
            let field = format!("views[{number}].shape.{name}");
            check(format!("{field}.mean"), normal.mean, -20.0, 20.0)?;
            check(format!("{field}.deviation"), normal.deviation, 0.0, 20.0)?;
        }
        for (bin, &share) in self.directions.0.iter().enumerate() {
            check(format!("views[{number}].directions[{bin}]"), share, 0.0, 1.0)?;
        }
        match self.silhouette.iter().position(|p| !p.is_finite()) {
            Some(at) => {
                Err(ModelError::NotFinite { field: format!("views[{number}].silhouette[{at}]") })
            }
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests;
