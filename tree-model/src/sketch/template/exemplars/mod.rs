//! Trees of clearly different habit, made with the [path modeler](crate::path), to measure templates by.
//!
//! Each is a row of a table: a trunk, main branches and their laterals, each set with the heights, angles, lengths and
//! bends of its species. They are drawn as thin tubes in which the path modeler then finds its paths; its subgraphs
//! make twigs. So main branches are as regular as in nature and as lively as paths are.

mod broadleaved;
mod conifers;
mod row;
mod scaffold;

use crate::error::{ModelError, Result};
use crate::path::PathParams;
use row::Row;
use tree_core::{Control, Seed, Tree};

/// A tree to measure a template by.
///
/// ```
/// use tree_core::{Control, Seed};
/// use tree_model::sketch::template::Exemplar;
/// let palm = Exemplar::find("palm")?;
/// let tree = palm.tree(Seed(1), &Control::default())?;
/// assert_eq!(palm.species(), "palm");
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Exemplar {
    row: &'static Row,
}

/// The seed of the trees that the [built-in templates](super::Template::builtin) were measured by.
pub const EXEMPLAR_SEED: Seed = Seed(1);

const ROWS: [&Row; 20] = [
    &broadleaved::OAK,
    &broadleaved::BEECH,
    &broadleaved::ELM,
    &broadleaved::MAPLE,
    &broadleaved::BIRCH,
    &broadleaved::POPLAR,
    &broadleaved::WILLOW,
    &broadleaved::APPLE,
    &broadleaved::HAZEL,
    &broadleaved::ACACIA,
    &broadleaved::BAOBAB,
    &broadleaved::SAPLING,
    &broadleaved::SNAG,
    &conifers::SPRUCE,
    &conifers::LARCH,
    &conifers::CEDAR,
    &conifers::UMBRELLA_PINE,
    &conifers::CYPRESS,
    &conifers::ARAUCARIA,
    &conifers::PALM,
];

/// All exemplars.
pub const EXEMPLARS: [Exemplar; ROWS.len()] = {
    let mut exemplars = [Exemplar { row: ROWS[0] }; ROWS.len()];
    let mut i = 0;
    while i < ROWS.len() {
        exemplars[i].row = ROWS[i];
        i += 1;
    }
    exemplars
};

impl Exemplar {
    /// The exemplar of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        EXEMPLARS.into_iter().find(|exemplar| exemplar.name() == name).ok_or_else(|| {
            let known = EXEMPLARS.map(|exemplar| exemplar.name()).join(", ");
            ModelError::UnknownPreset { name: name.into(), known }
        })
    }

    /// Its name.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.row.name
    }

    /// What the tree looks like, in a few words.
    #[must_use]
    pub const fn title(&self) -> &'static str {
        self.row.title
    }

    /// The name of the [species](crate::foliage::SpeciesPreset) whose leaves suit it.
    #[must_use]
    pub const fn species(&self) -> &'static str {
        self.row.species
    }

    /// The path modeler's parameters for one tree of this kind.
    ///
    /// # Errors
    /// None; all rows are tested.
    pub fn params(&self, seed: Seed) -> Result<PathParams> {
        scaffold::params(self.row, seed)
    }

    /// Grows one tree of this kind, with leaves on cards.
    ///
    /// # Errors
    /// [`ModelError::Limit`] and [`ModelError::Cancelled`].
    pub fn tree(&self, seed: Seed, control: &Control) -> Result<Tree> {
        Ok(self.params(seed)?.grow(seed.stream("path"), control)?.tree)
    }
}
