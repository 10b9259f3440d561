//! Comments, continued lines and statements.

use super::arrow;
use crate::error::{ModelError, Result};
use std::ops::Range;

/// The text of a grammar, and the same with comments and joined line ends blanked: both have the same
/// bytes at the same places otherwise.
pub(crate) struct Source<'a> {
    text: &'a str,
    clean: String,
}

impl<'a> Source<'a> {
    /// Blanks the comments.
    pub(crate) fn new(text: &'a str) -> Result<Self> {
        let mut source = Self { text, clean: String::with_capacity(text.len()) };
        let mut at = 0;
        // A mark for the order of bytes at the beginning of a file is no part of the text.
        if text.starts_with('\u{feff}') {
            at = source.blank(at, '\u{feff}'.len_utf8());
        }
        while let Some(c) = text[at..].chars().next() {
            let rest = &text[at..];
            if rest.starts_with("/*") {
                let Some(n) = rest.find("*/") else {
                    return Err(source.error(at, "the comment is never closed", "write '*/' after it"));
                };
                at = source.blank(at, n + 2);
            } else if rest.starts_with("//") && source.begins_comment(at) {
                at = source.blank(at, rest.find('\n').unwrap_or(rest.len()));
            } else if let Some(n) = joined(rest) {
                at = source.blank(at, n);
            } else {
                source.clean.push(c);
                at += c.len_utf8();
            }
        }
        Ok(source)
    }

    /// Whether `//` here is a comment and not two rolls of the turtle: it begins a line, or follows white
    /// space and no third stroke follows.
    fn begins_comment(&self, at: usize) -> bool {
        let line = self.clean.rsplit('\n').next().unwrap_or_default();
        line.trim().is_empty()
            || (line.ends_with(char::is_whitespace) && !self.text[at + 2..].starts_with('/'))
    }

    fn blank(&mut self, at: usize, n: usize) -> usize {
        self.clean.extend(std::iter::repeat_n(' ', n));
        at + n
    }

    /// The text without comments.
    pub(crate) fn clean(&self) -> &str {
        &self.clean
    }

    /// Line and column of a byte, both from 1.
    pub(crate) fn place(&self, at: usize) -> (usize, usize) {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.rsplit('\n').next().unwrap_or_default();
        (1 + before.matches('\n').count(), 1 + line.chars().filter(|&c| c != '\u{feff}').count())
    }

    /// An error at a byte.
    pub(crate) fn error(
        &self,
        at: usize,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> ModelError {
        let (line, column) = self.place(at);
        ModelError::Grammar { line, column, problem: problem.into(), hint: hint.into() }
    }

    /// The statements: one a line, and lines joined where a bracket is open or an arrow stands at the end
    /// of one or the beginning of the next.
    pub(crate) fn statements(&self) -> Result<Vec<Range<usize>>> {
        let mut statements: Vec<Range<usize>> = Vec::new();
        let (mut open, mut at, mut joins) = (Vec::new(), 0, false);
        for line in self.clean.split_inclusive('\n') {
            let (begin, text) = (at, line.trim());
            at += line.len();
            if text.is_empty() {
                continue;
            }
            let start = begin + line.len() - line.trim_start().len();
            let end = start + text.len();
            let continues = joins || (arrow(text).is_some() && !statements.is_empty());
            match statements.last_mut() {
                Some(last) if continues => last.end = end,
                _ => statements.push(start..end),
            }
            if continues || !is_list_of_symbols(text) {
                self.pair(start, text, &mut open)?;
            }
            joins = !open.is_empty() || super::ARROWS.iter().any(|arrow| text.ends_with(arrow));
        }
        match open.first() {
            None => Ok(statements),
            Some(&(at, bracket)) => {
                let closing = if bracket == '(' { ')' } else { ']' };
                let problem = format!("'{bracket}' is never closed");
                Err(self.error(at, problem, format!("write '{closing}' where it ends")))
            }
        }
    }

    /// Pairs the brackets of a line with those still open.
    fn pair(&self, start: usize, text: &str, open: &mut Vec<(usize, char)>) -> Result<()> {
        for (i, c) in text.char_indices() {
            let wanted = match c {
                '(' | '[' => {
                    open.push((start + i, c));
                    continue;
                }
                ')' => '(',
                ']' => '[',
                _ => continue,
            };
            match open.pop() {
                Some((_, bracket)) if bracket == wanted => {}
                Some((at, bracket)) => {
                    let (line, column) = self.place(at);
                    let hint = format!("'{bracket}' of line {line}, column {column} is still open");
                    return Err(self.error(start + i, format!("'{c}' does not fit"), hint));
                }
                None => {
                    let problem = format!("'{c}' without a '{wanted}' before it");
                    return Err(self.error(start + i, problem, ""));
                }
            }
        }
        Ok(())
    }
}

/// Bytes of a backslash that joins its line to the next, both counted.
fn joined(rest: &str) -> Option<usize> {
    let after = rest.strip_prefix('\\')?;
    let line_end = after.find('\n')?;
    after[..line_end].trim().is_empty().then_some(line_end + 2)
}

/// Whether the line lists symbols, which need not be paired when they are brackets.
fn is_list_of_symbols(line: &str) -> bool {
    let word = line.trim_start_matches('#').split(|c: char| !c.is_alphabetic()).next();
    word.is_some_and(|word| ["ignore", "consider"].iter().any(|key| word.eq_ignore_ascii_case(key)))
}
