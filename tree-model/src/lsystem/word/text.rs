//! Words as text: `F(1)[+(30)F(0.5)]`.

use super::{Symbols, Word};
use crate::error::{ModelError, Result};
use std::fmt::Write;

impl Word {
    /// Reads a word of numbers: a symbol is one character, or a name that the symbols know; its
    /// parameters follow in parentheses, divided by commas. White space between modules is skipped.
    ///
    /// # Errors
    /// [`ModelError::Word`], naming the module and what was expected.
    ///
    /// # Complexity
    /// O(text).
    pub fn parse(text: &str, symbols: &mut Symbols) -> Result<Self> {
        let mut word = Self::default();
        let mut params = Vec::new();
        let mut rest = text.trim_start();
        while let Some(name) = symbols.first_name(rest) {
            let fail = |problem: String| ModelError::Word { module: word.len(), problem };
            if name == "(" || name == ")" || name == "," {
                return Err(fail(format!("'{name}' where a symbol was expected")));
            }
            rest = &rest[name.len()..];
            params.clear();
            if let Some(list) = rest.strip_prefix('(') {
                let end = list.find(')').ok_or_else(|| fail("'(' is never closed".into()))?;
                for number in list[..end].split(',') {
                    let number = number.trim();
                    let value =
                        number.parse().map_err(|_| fail(format!("'{number}' is not a number")))?;
                    params.push(value);
                }
                rest = &list[end + 1..];
            }
            let kind = symbols.intern(name, params.len())?;
            word.push(symbols, kind, &params)?;
            rest = rest.trim_start();
        }
        Ok(word)
    }

    /// The word as text that [`parse`](Self::parse) reads back to the same bits.
    #[must_use]
    pub fn text(&self, symbols: &Symbols) -> String {
        let mut text = String::with_capacity(4 * self.len());
        for module in self.modules(symbols) {
            text.push_str(symbols.get(module.kind).map_or("?", |(name, _)| name));
            for (i, value) in module.params.iter().enumerate() {
                text.push(if i == 0 { '(' } else { ',' });
                // Writing to a string cannot fail.
                let _ = write!(text, "{value}");
            }
            if !module.params.is_empty() {
                text.push(')');
            }
        }
        text
    }
}
