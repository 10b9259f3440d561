//! Ready-made L-systems: those of the books and papers, and leafy species of ours.
//!
//! Presets are rows of a table; their grammars are text files in `text/`, to be read, copied and changed. Rows of
//! one figure share a file and differ in its constants, as the tables of ABOP do. Productions and constants of
//! published ones are exact. Sizes in metres, barks and leaves are ours, since the books name none.

mod published;
mod row;
mod species;
#[cfg(test)]
mod tests;

use super::model::LSystem;
use super::turtle::Thickness;
use crate::error::{ModelError, Result};
use row::Row;
use tree_core::allometry::{PipeModel, RadiusRule};
use tree_core::{Limits, Species};

/// A named L-system.
///
/// ```
/// use tree_model::lsystem::Preset;
/// let birch = Preset::find("birch")?.system()?;
/// assert_eq!(birch.species.bark, "birch");
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    row: &'static Row,
}

/// All presets: species of ours first, then those of the books.
pub fn presets() -> impl Iterator<Item = Preset> {
    species::ROWS.iter().chain(published::ROWS).map(|row| Preset { row })
}

impl Preset {
    /// The preset of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        presets().find(|preset| preset.name() == name).ok_or_else(|| {
            let names: Vec<_> = presets().map(|preset| preset.name()).collect();
            ModelError::UnknownPreset { name: name.into(), known: names.join(", ") }
        })
    }

    /// Its name: `oak`, `honda-a`, `abop-1.24f`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.row.name
    }

    /// What it looks like, in a few words.
    #[must_use]
    pub const fn title(&self) -> &'static str {
        self.row.title
    }

    /// Where it was published; empty for ours.
    #[must_use]
    pub const fn source(&self) -> &'static str {
        self.row.source
    }

    /// The text of its grammar, before [`constants`](Self::constants) are replaced.
    #[must_use]
    pub const fn text(&self) -> &'static str {
        self.row.text
    }

    /// Constants of the text that this preset changes.
    #[must_use]
    pub const fn constants(&self) -> &'static [(&'static str, f64)] {
        self.row.constants
    }

    /// The L-system, to grow or to change.
    ///
    /// # Errors
    /// None for the presets there are; their rows are tested.
    pub fn system(&self) -> Result<LSystem> {
        let row = self.row;
        let mut grammar = super::Grammar::parse(row.text, &Limits::default())?;
        for &(name, value) in row.constants {
            grammar.set_constant(name, value)?;
        }
        let mut system = LSystem::new(grammar)?;
        let turtle = &mut system.turtle;
        turtle.height = row.height;
        turtle.trunk_radius = Some(row.trunk_radius);
        turtle.thickness = Thickness::Auto(RadiusRule::Pipe(PipeModel {
            exponent: row.exponent,
            tip_radius: row.tip_radius,
            ..PipeModel::default()
        }));
        system.species = Species {
            name: row.species.into(),
            bark: row.bark.into(),
            leaf_kinds: row.leaf_kind.map(str::to_owned).into_iter().collect(),
        };
        Ok(system)
    }
}
