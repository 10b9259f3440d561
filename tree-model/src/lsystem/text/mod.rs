//! The text of a grammar: comments, statements, and a cursor that knows lines and columns.
//!
//! 1. Comments and joined line ends become spaces, so that every place keeps its byte (`source`).
//! 2. The text is cut into statements; brackets are paired on the way.
//! 3. A [`Cursor`] reads symbols, names and numbers of one statement, and makes errors with places.
//!
//! All of it is linear in the text, and nothing recurses.

mod cursor;
mod hint;
mod source;

pub(super) use cursor::{Cursor, is_symbol_char};
pub(super) use hint::did_you_mean;
pub(super) use source::Source;

/// Arrows between predecessor and successor, longest first.
pub(super) const ARROWS: [&str; 4] = ["-->", "->", "→", "⟶"];

/// The arrow that this text begins with.
pub(super) fn arrow(text: &str) -> Option<&'static str> {
    ARROWS.into_iter().find(|arrow| text.starts_with(arrow))
}

/// The first arrow outside parentheses: its byte and its length.
pub(super) fn find_arrow(text: &str) -> Option<(usize, usize)> {
    let mut depth = 0_usize;
    for (i, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            '-' | '→' | '⟶' if depth == 0 => {
                if let Some(arrow) = arrow(&text[i..]) {
                    return Some((i, arrow.len()));
                }
            }
            _ => {}
        }
    }
    None
}
