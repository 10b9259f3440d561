//! Words of modules in columns: the kind of each module, and the parameters of all one after another.
//!
//! A *kind* is a symbol together with its number of parameters, so `F(1)` and `F(1, 2)` are of two
//! kinds: productions match kinds, and the parameters of a module are found without a table of offsets.

mod symbols;
mod text;

pub use symbols::{Kind, Symbols};

use crate::error::{ModelError, Result};

/// A string of modules with their parameters: 2 bytes a module and 8 a parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Word {
    kinds: Vec<Kind>,
    params: Vec<f64>,
}

/// One module of a [`Word`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Module<'a> {
    /// Its symbol and number of parameters.
    pub kind: Kind,
    /// Its parameters.
    pub params: &'a [f64],
}

impl Word {
    /// Adds a module at the end.
    ///
    /// # Errors
    /// [`ModelError::Word`] when the kind is unknown, has another number of parameters, or a parameter
    /// is not finite.
    pub fn push(&mut self, symbols: &Symbols, kind: Kind, params: &[f64]) -> Result<()> {
        let fail = |problem| Err(ModelError::Word { module: self.kinds.len(), problem });
        match symbols.get(kind) {
            None => return fail(format!("there is no kind {}", kind.0)),
            Some((name, arity)) if arity != params.len() => {
                return fail(format!("'{name}' takes {arity} parameters, not {}", params.len()));
            }
            Some(_) => {}
        }
        if let Some(found) = params.iter().find(|x| !x.is_finite()) {
            return fail(format!("a parameter is {found}, it must be finite"));
        }
        self.kinds.push(kind);
        self.params.extend_from_slice(params);
        Ok(())
    }

    /// Number of modules.
    #[must_use]
    pub fn len(&self) -> usize {
        self.kinds.len()
    }

    /// Whether there is no module.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// Kind of each module.
    #[must_use]
    pub fn kinds(&self) -> &[Kind] {
        &self.kinds
    }

    /// Parameters of all modules, one after another.
    #[must_use]
    pub fn params(&self) -> &[f64] {
        &self.params
    }

    /// The modules in order. Kinds that the symbols lack have no parameters.
    pub fn modules<'a>(&'a self, symbols: &'a Symbols) -> impl Iterator<Item = Module<'a>> + 'a {
        let mut at = 0;
        self.kinds.iter().map(move |&kind| {
            let end = at + symbols.arity(kind);
            let params = self.params.get(at..end).unwrap_or_default();
            at = end;
            Module { kind, params }
        })
    }

    /// Checks that every bracket is closed and every kind is known.
    ///
    /// # Errors
    /// [`ModelError::Word`], naming the module.
    pub fn check(&self, symbols: &Symbols) -> Result<()> {
        let mut open = Vec::new();
        for (module, &kind) in self.kinds.iter().enumerate() {
            let fail = |problem: &str| Err(ModelError::Word { module, problem: problem.into() });
            match kind {
                Symbols::PUSH => open.push(module),
                Symbols::POP if open.pop().is_none() => return fail("']' without a '[' before it"),
                _ if symbols.get(kind).is_none() => return fail("its kind is unknown"),
                _ => {}
            }
        }
        let n_params: usize = self.kinds.iter().map(|&kind| symbols.arity(kind)).sum();
        if n_params != self.params.len() {
            let problem = format!("{} parameters, {n_params} are needed", self.params.len());
            return Err(ModelError::Word { module: self.kinds.len(), problem });
        }
        match open.pop() {
            None => Ok(()),
            Some(module) => {
                Err(ModelError::Word { module, problem: "'[' without a ']' after it".into() })
            }
        }
    }

    /// The columns, for the derivation that fills them.
    pub(super) fn columns_mut(&mut self) -> (&mut Vec<Kind>, &mut Vec<f64>) {
        (&mut self.kinds, &mut self.params)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_comes_back_from_text_as_it_went() {
        let mut symbols = Symbols::default();
        let text = "B(1)[+(30)B(0.5)[B(0.25)B(0.25)]-B(0.5)]";
        let word = Word::parse(text, &mut symbols).unwrap();
        assert_eq!(word.text(&symbols), text);
        assert_eq!(word.len(), 11);
        word.check(&symbols).unwrap();
    }

    #[test]
    fn names_of_several_characters_must_be_declared() {
        let mut symbols = Symbols::default();
        symbols.intern("Apex", 1).unwrap();
        let word = Word::parse("Apex(2)Ap", &mut symbols).unwrap();
        assert_eq!(word.len(), 3);
        assert_eq!(word.text(&symbols), "Apex(2)Ap");
    }

    #[test]
    fn open_brackets_are_named() {
        let mut symbols = Symbols::default();
        let at = |text: &str, symbols: &mut Symbols| match Word::parse(text, symbols)
            .and_then(|word| word.check(symbols))
        {
            Err(ModelError::Word { module, .. }) => module,
            other => panic!("{other:?}"),
        };
        assert_eq!(at("F[+F[F]", &mut symbols), 1);
        assert_eq!(at("F]F", &mut symbols), 1);
    }
}
