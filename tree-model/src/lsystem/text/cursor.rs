//! A place in the text that moves on as symbols, names and numbers are read.

use super::Source;
use crate::error::{ModelError, Result};
use crate::lsystem::Symbols;
use std::ops::Range;

/// Reads a part of a source.
#[derive(Clone)]
pub(crate) struct Cursor<'a> {
    source: &'a Source<'a>,
    at: usize,
    end: usize,
}

impl<'a> Cursor<'a> {
    /// At the beginning of a part.
    pub(crate) fn new(source: &'a Source<'a>, part: Range<usize>) -> Self {
        Self { source, at: part.start, end: part.end }
    }

    /// The same text up to `end`, a byte of the source.
    pub(crate) fn until(&self, end: usize) -> Self {
        Self { end: end.clamp(self.at, self.end), ..self.clone() }
    }

    /// Byte of the source.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Goes to a byte of the source.
    pub(crate) fn go(&mut self, at: usize) {
        self.at = at.min(self.end);
    }

    /// The rest of the part.
    pub(crate) fn rest(&self) -> &'a str {
        self.source.clean().get(self.at..self.end).unwrap_or_default()
    }

    /// Skips white space, then tells the next character.
    pub(crate) fn peek(&mut self) -> Option<char> {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
        self.rest().chars().next()
    }

    /// Whether only white space is left.
    pub(crate) fn is_done(&mut self) -> bool {
        self.peek().is_none()
    }

    /// Skips white space, then `text` if it is next.
    pub(crate) fn eat(&mut self, text: &str) -> bool {
        self.peek();
        let found = self.rest().starts_with(text);
        self.at += if found { text.len() } else { 0 };
        found
    }

    /// A name of letters, digits and `_` that begins with no digit.
    pub(crate) fn name(&mut self) -> Option<&'a str> {
        self.peek()?;
        let rest = self.rest();
        if rest.starts_with(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let n = rest.find(|c: char| !is_name_char(c)).unwrap_or(rest.len());
        self.at += n;
        rest.get(..n).filter(|name| !name.is_empty())
    }

    /// A number without a sign.
    pub(crate) fn number(&mut self) -> Result<Option<f64>> {
        self.peek();
        let (rest, at) = (self.rest(), self.at);
        let digits = |from: usize| rest[from..].bytes().take_while(u8::is_ascii_digit).count();
        let mut n = digits(0);
        if rest[n..].starts_with('.') {
            n += 1 + digits(n + 1);
        }
        if !rest[..n].contains(|c: char| c.is_ascii_digit()) {
            return Ok(None);
        }
        if rest[n..].starts_with(['e', 'E']) {
            let sign = usize::from(rest[n + 1..].starts_with(['+', '-']));
            let exponent = digits(n + 1 + sign);
            n += if exponent > 0 { 1 + sign + exponent } else { 0 };
        }
        self.at += n;
        match rest[..n].parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Some(value)),
            _ => Err(self.source.error(at, format!("the number {} is too large", &rest[..n]), "")),
        }
    }

    /// The name of a module: the longest declared one, or one character.
    pub(crate) fn symbol(&mut self, symbols: &Symbols) -> Result<Option<&'a str>> {
        if self.peek().is_none() {
            return Ok(None);
        }
        let Some(name) = symbols.first_name(self.rest()) else { return Ok(None) };
        let c = name.chars().next().unwrap_or_default();
        if name.len() == c.len_utf8() && !is_symbol_char(c) {
            return Err(self.unexpected("a symbol"));
        }
        self.at += name.len();
        Ok(Some(plain(name)))
    }

    /// Reads past `text`, or says that it was expected.
    pub(crate) fn expect(&mut self, text: &str) -> Result<()> {
        if self.eat(text) { Ok(()) } else { Err(self.unexpected(&format!("'{text}'"))) }
    }

    /// Says that nothing more may follow, if something does.
    pub(crate) fn finish(&mut self) -> Result<()> {
        if self.is_done() { Ok(()) } else { Err(self.unexpected("the end of the statement")) }
    }

    /// "X where Y was expected", here.
    pub(crate) fn unexpected(&mut self, wanted: &str) -> ModelError {
        let problem = match self.peek() {
            Some(c) => format!("'{}' where {wanted} was expected", c.escape_debug()),
            None => format!("the statement ends where {wanted} was expected"),
        };
        let hint = match self.peek() {
            Some('{') => "blocks of C are not read",
            Some('*') => "'*' stands for an empty context or condition only",
            _ => "",
        };
        self.error(problem, hint)
    }

    /// An error here.
    pub(crate) fn error(&self, problem: impl Into<String>, hint: impl Into<String>) -> ModelError {
        self.source.error(self.at, problem, hint)
    }

    /// An error at another byte.
    pub(crate) fn error_at(
        &self,
        at: usize,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> ModelError {
        self.source.error(at, problem, hint)
    }

    /// Line of a byte.
    pub(crate) fn line(&self, at: usize) -> usize {
        self.source.line(at)
    }
}

fn is_name_char(c: char) -> bool {
    c == '_' || (c.is_alphanumeric() && c != 'ε')
}

/// Whether a character can be a symbol: all that the notation does not need itself.
pub(crate) fn is_symbol_char(c: char) -> bool {
    !c.is_control() && !c.is_whitespace() && !"(),:<>=*;ε→⟶".contains(c)
}

/// Signs of typeset books as those of a keyboard.
fn plain(name: &str) -> &str {
    match name {
        "−" | "–" => "-",
        "∧" => "^",
        "’" | "′" => "'",
        "∣" => "|",
        _ => name,
    }
}
