//! Names that are safe in files and as file names.

use std::collections::BTreeSet;

/// Longest name that is kept; file systems end at 255 bytes and extensions come on top.
const LENGTH_MAX: usize = 96;

/// Letters, digits, `-`, `_` and `.` stay, all else becomes `_`; never empty, never a leading dot.
pub(super) fn safe(name: &str, fallback: &str) -> String {
    let kept: String = name
        .chars()
        .take(LENGTH_MAX)
        .map(|c| match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' | '.' => c,
            _ => '_',
        })
        .collect();
    let kept = kept.trim_start_matches('.');
    if kept.is_empty() { fallback.into() } else { kept.into() }
}

/// Hands out names no two of which are the same, not even on systems that ignore case.
#[derive(Debug, Default)]
pub(super) struct Unique(BTreeSet<String>);

impl Unique {
    /// `name`, made safe, with a number behind it if it was taken.
    pub(super) fn name(&mut self, name: &str, fallback: &str) -> String {
        let safe = safe(name, fallback);
        let mut candidate = safe.clone();
        let mut number = 2_u64;
        while !self.0.insert(candidate.to_lowercase()) {
            candidate = format!("{safe}_{number}");
            number += 1;
        }
        candidate
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_out_safe_and_different() {
        let mut unique = Unique::default();
        assert_eq!(unique.name("oak leaf", "x"), "oak_leaf");
        assert_eq!(unique.name("Oak_Leaf", "x"), "Oak_Leaf_2");
        assert_eq!(unique.name("../../etc/passwd", "x"), "_.._etc_passwd");
        assert_eq!(unique.name("", "x"), "x");
        assert_eq!(unique.name("…\nnewmtl", "x"), "__newmtl");
        assert_eq!(safe(&"a".repeat(500), "x").len(), LENGTH_MAX);
    }
}
