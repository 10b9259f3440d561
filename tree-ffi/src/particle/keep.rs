//! Parameters that the library hands out: what their structs point at has to live somewhere.

use crate::border::{Versioned, tree_str};
use crate::tree::tree_species;
use std::any::Any;
use std::ptr::null;
use tree_model::tree_core::Species;

/// Owns what structs of parameters point at. Nothing in it moves or changes.
#[derive(Default)]
pub(crate) struct Kept(Vec<Box<dyn Any>>);

// SAFETY: holds parameters in C's form, whose pointers lead to others in here or in presets, and which are
// only read.
unsafe impl Send for Kept {}
// SAFETY: as above.
unsafe impl Sync for Kept {}

impl Kept {
    /// Keeps a value.
    pub(crate) fn one<T: 'static>(&mut self, value: T) -> *const T {
        self.all(vec![value])
    }

    /// Keeps some values; NULL for none.
    pub(crate) fn all<T: 'static>(&mut self, values: Vec<T>) -> *const T {
        if values.is_empty() {
            return null();
        }
        let values: Box<[T]> = values.into_boxed_slice();
        let first = values.as_ptr();
        self.0.push(Box::new(values));
        first
    }

    /// Keeps a text.
    pub(crate) fn text(&mut self, text: &str) -> tree_str {
        let data = self.all(text.as_bytes().to_vec()).cast();
        tree_str { data, len: text.len() }
    }

    /// Keeps a species with its names.
    pub(crate) fn species(&mut self, species: &Species) -> *const tree_species {
        let kinds: Vec<tree_str> = species.leaf_kinds.iter().map(|kind| self.text(kind)).collect();
        let value = tree_species {
            name: self.text(&species.name),
            bark: self.text(&species.bark),
            leaf_kinds: self.all(kinds),
            n_leaf_kinds: species.leaf_kinds.len(),
            ..tree_species::default_value()
        };
        self.one(value)
    }
}
