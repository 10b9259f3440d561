//! The alphabet: symbols by name and number of parameters.

use crate::error::Result;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;

/// A symbol with its number of parameters: a row of [`Symbols`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Kind(pub u16);

/// The most parameters of a module.
pub(crate) const MOST_PARAMS: usize = 64;

/// The kinds of a grammar, in the order in which they were met. The brackets are always there.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbols {
    names: Vec<String>,
    arities: Vec<u8>,
    kinds: BTreeMap<(String, u8), Kind>,
    /// Names of more than one character.
    long: BTreeSet<String>,
    /// Their lengths in bytes, longest first, each once: few, so that a name is found quickly.
    lengths: Vec<usize>,
}

impl Default for Symbols {
    fn default() -> Self {
        let kinds = [(("[".into(), 0), Self::PUSH), (("]".into(), 0), Self::POP)];
        Self {
            names: vec!["[".into(), "]".into()],
            arities: vec![0, 0],
            kinds: kinds.into(),
            long: BTreeSet::new(),
            lengths: Vec::new(),
        }
    }
}

impl Symbols {
    /// `[`: a branch begins.
    pub const PUSH: Kind = Kind(0);
    /// `]`: a branch ends.
    pub const POP: Kind = Kind(1);

    /// The kind of this name with so many parameters; it is made when it is not there.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) for more than 64 parameters or more than 65,536 kinds.
    pub fn intern(&mut self, name: &str, n_params: usize) -> Result<Kind> {
        crate::error::check("parameters of a module", n_params as f64, 0.0, MOST_PARAMS as f64)?;
        let key = (name.to_owned(), n_params as u8);
        if let Some(&kind) = self.kinds.get(&key) {
            return Ok(kind);
        }
        crate::error::check("kinds of modules", self.names.len() as f64, 0.0, f64::from(u16::MAX))?;
        let kind = Kind(self.names.len() as u16);
        self.declare(name);
        self.names.push(key.0.clone());
        self.arities.push(key.1);
        self.kinds.insert(key, kind);
        Ok(kind)
    }

    /// Makes a name of several characters known to readers of words, with any number of parameters.
    pub fn declare(&mut self, name: &str) {
        if name.chars().nth(1).is_some() && self.long.insert(name.to_owned()) {
            let place = self.lengths.partition_point(|&n| n > name.len());
            if self.lengths.get(place) != Some(&name.len()) {
                self.lengths.insert(place, name.len());
            }
        }
    }

    /// The kind of this name and number of parameters, if it is there.
    #[must_use]
    pub fn find(&self, name: &str, n_params: usize) -> Option<Kind> {
        self.kinds.get(&(name.to_owned(), u8::try_from(n_params).ok()?)).copied()
    }

    /// Name and number of parameters of a kind.
    #[must_use]
    pub fn get(&self, kind: Kind) -> Option<(&str, usize)> {
        let name = self.names.get(usize::from(kind.0))?;
        Some((name, self.arity(kind)))
    }

    /// Number of parameters of a kind; 0 for one that is not there.
    #[must_use]
    #[inline]
    pub fn arity(&self, kind: Kind) -> usize {
        self.arities.get(usize::from(kind.0)).map_or(0, |&n| usize::from(n))
    }

    /// Number of kinds.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the brackets are always there")]
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether a declared name begins with this one and the first character of the next.
    pub(super) fn could_be_longer(&self, name: &str, next: &str) -> bool {
        if self.long.is_empty() || name.is_empty() {
            return false;
        }
        let both: String = name.chars().chain(next.chars().take(1)).collect();
        let from = (Bound::Included(both.as_str()), Bound::Unbounded);
        self.long.range::<str, _>(from).next().is_some_and(|long| long.starts_with(&both))
    }

    /// The name that this text begins with: the longest declared one, or else its first character.
    #[must_use]
    pub fn first_name<'a>(&self, text: &'a str) -> Option<&'a str> {
        let long = self.lengths.iter().find_map(|&n| {
            let name = text.get(..n)?;
            self.long.contains(name).then_some(name)
        });
        long.or_else(|| text.get(..text.chars().next()?.len_utf8()))
    }
}
