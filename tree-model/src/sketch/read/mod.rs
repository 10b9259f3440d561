//! Drawings from files: SVG (feature `svg`), JSON and Quick, Draw! lines (feature `json`).
//!
//! A file says what lines there are, and at best what some of them show. The rest is found out by
//! [`clean`](super::clean).

#[cfg(feature = "json")]
mod json;
#[cfg(feature = "svg")]
mod svg;

#[cfg(feature = "json")]
pub use json::{from_json, from_ndjson, to_json};
#[cfg(feature = "svg")]
pub use svg::from_svg;

#[cfg(feature = "svg")]
use super::Role;

/// What a name such as `left branch-2` says that a line shows: the first of its words, letters only and in any
/// case, that is known; `None` where none is.
#[cfg(feature = "svg")]
pub(crate) fn role_named(name: &str) -> Option<Role> {
    const TRUNK: [&str; 4] = ["trunk", "trunks", "stem", "stems"];
    const BRANCH: [&str; 6] = ["branch", "branches", "limb", "limbs", "twig", "twigs"];
    const CROWN: [&str; 8] =
        ["crown", "crowns", "outline", "outlines", "foliage", "leaves", "canopy", "canopies"];
    let known = |word: &str| {
        let any = |words: &[&str]| words.iter().any(|known| known.eq_ignore_ascii_case(word));
        match () {
            () if any(&TRUNK) => Some(Role::Trunk),
            () if any(&BRANCH) => Some(Role::Branch),
            () if any(&CROWN) => Some(Role::Crown),
            () => None,
        }
    };
    name.split(|c: char| !c.is_alphabetic()).find_map(known)
}
