//! Comments, continued lines and statements.

use super::{arrow, find_arrow};
use crate::error::{ModelError, Result};
use std::ops::Range;

/// The text of a grammar, and the same with comments and joined line ends blanked: both have the same
/// bytes at the same places otherwise.
pub(crate) struct Source<'a> {
    text: &'a str,
    clean: String,
    /// Where lines begin, but the first.
    line_starts: Vec<usize>,
}

/// What editors put before a text to tell the order of its bytes.
const ORDER_MARK: char = '\u{feff}';

impl<'a> Source<'a> {
    /// Blanks the comments.
    pub(crate) fn new(text: &'a str) -> Result<Self> {
        let line_starts = text.match_indices('\n').map(|(i, _)| i + 1).collect();
        let mut source = Self { text, clean: String::with_capacity(text.len()), line_starts };
        let mut at = 0;
        // A mark for the order of bytes at the beginning of a file is no part of the text.
        if text.starts_with(ORDER_MARK) {
            at = source.blank(at, ORDER_MARK.len_utf8());
        }
        let (mut line_is_empty, mut last) = (true, ' ');
        while let Some(c) = text[at..].chars().next() {
            let rest = &text[at..];
            if rest.starts_with("/*") {
                let Some(n) = rest.find("*/") else {
                    let hint = "write '*/' after it";
                    return Err(source.error(at, "the comment is never closed", hint));
                };
                at = source.blank(at, n + 2);
                last = ' ';
            } else if rest.starts_with("//")
                && (line_is_empty || (last.is_whitespace() && !rest.starts_with("///")))
            {
                at = source.blank(at, rest.find('\n').unwrap_or(rest.len()));
            } else if let Some(n) = joined(rest) {
                at = source.blank(at, n);
                last = ' ';
            } else {
                source.clean.push(c);
                at += c.len_utf8();
                line_is_empty = c == '\n' || (line_is_empty && c.is_whitespace());
                last = c;
            }
        }
        Ok(source)
    }

    fn blank(&mut self, at: usize, n: usize) -> usize {
        self.clean.extend(std::iter::repeat_n(' ', n));
        at + n
    }

    /// The text without comments.
    pub(crate) fn clean(&self) -> &str {
        &self.clean
    }

    /// Line of a byte, from 1.
    pub(crate) fn line(&self, at: usize) -> usize {
        1 + self.line_starts.partition_point(|&start| start <= at)
    }

    /// Line and column of a byte, both from 1.
    pub(crate) fn place(&self, at: usize) -> (usize, usize) {
        let line = self.line(at);
        let start = line.checked_sub(2).and_then(|i| self.line_starts.get(i)).copied();
        let before = self.text.get(start.unwrap_or(0)..at).unwrap_or_default();
        (line, 1 + before.chars().filter(|&c| c != ORDER_MARK).count())
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

    /// The statements: one a line, and lines joined where a bracket is open, a line begins with an arrow, or an
    /// indented line without an arrow follows one that ends with it.
    pub(crate) fn statements(&self) -> Result<Vec<Range<usize>>> {
        let mut statements: Vec<Range<usize>> = Vec::new();
        let (mut open, mut at, mut hangs) = (Vec::new(), 0, false);
        for line in self.clean.split_inclusive('\n') {
            let (begin, text) = (at, line.trim());
            at += line.len();
            if text.is_empty() {
                continue;
            }
            let start = begin + line.len() - line.trim_start().len();
            let end = start + text.len();
            // A successor may be empty: behind a hanging arrow it goes on only where a line is indented.
            let successor = hangs && start > begin && find_arrow(text).is_none();
            let continues =
                !open.is_empty() || successor || (arrow(text).is_some() && !statements.is_empty());
            match statements.last_mut() {
                Some(last) if continues => last.end = end,
                _ => statements.push(start..end),
            }
            if continues || !is_list_of_symbols(text) {
                self.pair(start, text, &mut open)?;
            }
            hangs = super::ARROWS.iter().any(|arrow| text.ends_with(arrow));
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
    let after = rest.strip_prefix('\\')?.trim_start_matches([' ', '\t', '\r']);
    after.starts_with('\n').then_some(rest.len() - after.len() + 1)
}

/// Whether the line lists symbols, which need not be paired when they are brackets.
fn is_list_of_symbols(line: &str) -> bool {
    let word = line.trim_start_matches('#').split(|c: char| !c.is_alphabetic()).next();
    word.is_some_and(|word| {
        ["ignore", "consider", "symbols"].iter().any(|key| word.eq_ignore_ascii_case(key))
    })
}
