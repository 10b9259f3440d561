//! Names of species, bark and leaves.

use crate::border::{Failure, Result, TREE_ERROR_NULL, TREE_ERROR_PARAMETER, Versioned, tree_str};
use crate::mesh::column;
use tree_model::tree_core::Species;

/// Most leaf kinds of a species: what an index of 16 bits reaches.
const KINDS_MAX: usize = 1 << 16;

/// What kind of tree it is. Built-in looks go by these names; see `tree_bark_names` and
/// `tree_leaf_names`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_species {
    /// `sizeof(tree_species)`.
    pub struct_size: usize,
    /// Name for people and files.
    pub name: tree_str,
    /// Name of the bark.
    pub bark: tree_str,
    /// Names of the leaf kinds.
    pub leaf_kinds: *const tree_str,
    /// Number of leaf kinds.
    pub n_leaf_kinds: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_species {
    const NAME: &'static str = "tree_species";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            bark: tree_str::EMPTY,
            leaf_kinds: std::ptr::null(),
            n_leaf_kinds: 0,
        }
    }
}

impl tree_species {
    /// A copy; `argument` is what it is called by.
    pub(crate) unsafe fn rust(&self, argument: &str) -> Result<Species> {
        let part = |name: &str| format!("{argument}.{name}");
        if self.n_leaf_kinds > KINDS_MAX {
            let n = self.n_leaf_kinds;
            let text = format!("{argument}.n_leaf_kinds is {n}, allowed is 0 to {KINDS_MAX}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        if self.n_leaf_kinds > 0 && self.leaf_kinds.is_null() {
            return Err(Failure::new(TREE_ERROR_NULL, part("leaf_kinds is NULL")));
        }
        let leaf_kinds = (0..self.n_leaf_kinds)
            .map(|i| {
                // SAFETY: within the caller's array.
                let kind = unsafe { self.leaf_kinds.add(i).read_unaligned() };
                Ok(unsafe { kind.get(&part(&format!("leaf_kinds[{i}]"))) }?.to_owned())
            })
            .collect::<Result<_>>()?;
        Ok(Species {
            name: unsafe { self.name.get(&part("name")) }?.to_owned(),
            bark: unsafe { self.bark.get(&part("bark")) }?.to_owned(),
            leaf_kinds,
        })
    }
}

/// Views of the names of leaf kinds, which a `tree_species` points at.
pub(crate) struct SpeciesNames(Vec<tree_str>);

// SAFETY: points into a species that the same object holds and nothing changes.
unsafe impl Send for SpeciesNames {}
// SAFETY: as above.
unsafe impl Sync for SpeciesNames {}

impl SpeciesNames {
    /// Views into `species`, which must stay where it is.
    pub(crate) fn of(species: &Species) -> Self {
        Self(species.leaf_kinds.iter().map(|kind| tree_str::of(kind)).collect())
    }

    pub(crate) fn view(&self, species: &Species) -> tree_species {
        tree_species {
            name: tree_str::of(&species.name),
            bark: tree_str::of(&species.bark),
            leaf_kinds: column(&self.0),
            n_leaf_kinds: self.0.len(),
            ..tree_species::default_value()
        }
    }
}
