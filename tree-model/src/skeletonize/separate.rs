//! Step 2: wood or leaves, by what the caller says, by name, by alpha, and else by shape.
//!
//! Shape decides for each connected component. A card is open: its area vectors do not cancel out,
//! while those of a tube do, even without caps. A blob of leaves is closed like a tree, but fills its
//! box, which a branched surface does not.

use super::rows::Rows;
use super::shape::Shape;
use super::weld::{Soup, sorted};
use crate::error::{ModelError, Result};
use rayon::prelude::*;
use tree_core::{Hint, Part};

/// What a component is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Bark.
    Wood,
    /// A card or a small thin surface: one leaf.
    Leaf,
    /// A closed body of leaves.
    Blob,
    /// Not looked at.
    Ignored,
}

/// Area vectors that cancel out less than this make a card.
const CARD_OPEN: f32 = 0.5;
/// A surface is flat when its least width is below this share of the middle one.
const FLAT: f32 = 0.03;
/// A closed surface that fills at least this share of its box …
const BLOB_SOLID: f32 = 0.15;
/// … and is at most so slender is a blob.
const BLOB_SLENDER: f32 = 2.5;
/// A leaf of a leaf part is a blob when its least width is above this share of its length.
const BLOB_THICK: f32 = 0.3;
/// Fewer triangles are a leaf, however thick.
const BLOB_TRIANGLES: usize = 16;
/// Share of a leaf-like component's vertices on wood from which it is a patch of bark.
const PATCH_SHARE: f32 = 0.75;

const LEAF_WORDS: [&str; 14] = [
    "leaf", "leav", "foliage", "needle", "frond", "crown", "canopy", "flower", "blossom", "fruit",
    "petal", "green", "feuill", "blatt",
];
const WOOD_WORDS: [&str; 9] =
    ["bark", "wood", "trunk", "stem", "branch", "twig", "log", "limb", "root"];
const OTHER_WORDS: [&str; 4] = ["ground", "grass", "collision", "shadow"];

/// The components of the soup.
#[derive(Debug)]
pub(super) struct Separated {
    /// Triangles of each component.
    pub(super) triangles: Rows,
    pub(super) shapes: Vec<Shape>,
}

/// Says of each component what it is.
pub(super) fn separate(soup: &Soup, parts: &[Part<'_>]) -> (Separated, Vec<Class>) {
    let triangles = Rows::new(&soup.components, soup.n_components);
    let shapes: Vec<Shape> = (0..soup.n_components as u32)
        .into_par_iter()
        .map(|component| {
            Shape::of(triangles.of(component).iter().map(|&triangle| soup.corners(triangle)))
        })
        .collect();
    let part_of = |component: usize| {
        let first = triangles.of(component as u32).first();
        first.map_or(0, |&triangle| soup.sources[triangle as usize].0 as usize)
    };
    let told: Vec<Option<Hint>> = parts.iter().map(told).collect();
    let mut classes: Vec<Class> = shapes
        .iter()
        .enumerate()
        .map(|(component, shape)| match told[part_of(component)] {
            Some(Hint::Wood) => Class::Wood,
            Some(Hint::Ignore) => Class::Ignored,
            Some(Hint::Leaves) => leaf_or_blob(shape),
            Some(Hint::Auto) | None => by_shape(shape),
        })
        .collect();
    let guessed: Vec<bool> = (0..shapes.len()).map(|c| told[part_of(c)].is_none()).collect();
    return_patches(soup, &triangles, &guessed, &mut classes);
    if !classes.contains(&Class::Wood) {
        // A stout trunk looks like a blob. Better the blobs than nothing.
        for (class, _) in classes.iter_mut().zip(&guessed).filter(|(_, guessed)| **guessed) {
            if *class == Class::Blob {
                *class = Class::Wood;
            }
        }
    }
    (Separated { triangles, shapes }, classes)
}

/// Triangles of wood, rising, without those that are there a second time as leaves, which files made
/// by hand have by mistake.
pub(super) fn wood(soup: &Soup, classes: &[Class]) -> Result<Vec<u32>> {
    if !classes.contains(&Class::Wood) {
        let problem =
            "all of it looks like leaves; give the hint `wood` to the parts that are bark";
        return Err(ModelError::NoWood { problem });
    }
    let class = |triangle: u32| {
        let component = soup.components[triangle as usize] as usize;
        classes.get(component).copied().unwrap_or(Class::Ignored)
    };
    let all = 0..soup.triangles.len() as u32;
    let key = |triangle: u32| sorted(soup.triangles[triangle as usize]);
    let leafy = all.clone().filter(|&t| matches!(class(t), Class::Leaf | Class::Blob));
    let mut covered: Vec<[u32; 3]> = leafy.map(key).collect();
    covered.sort_unstable();
    let is_wood = |&t: &u32| class(t) == Class::Wood && covered.binary_search(&key(t)).is_err();
    let wood: Vec<u32> = all.filter(is_wood).collect();
    if wood.is_empty() {
        let problem = "all bark lies under leaves; give the hint `ignore` to one of them";
        return Err(ModelError::NoWood { problem });
    }
    Ok(wood)
}

/// What is known of a part before its shape is looked at.
fn told(part: &Part<'_>) -> Option<Hint> {
    if part.hint != Hint::Auto {
        return Some(part.hint);
    }
    // Bark has no holes, whatever the name: `branch` is often a card with a picture of one.
    if part.alpha_masked {
        return Some(Hint::Leaves);
    }
    let name = part.name.to_lowercase();
    let says = |words: &[&str]| words.iter().any(|word| name.contains(word));
    if says(&OTHER_WORDS) {
        Some(Hint::Ignore)
    } else if says(&LEAF_WORDS) {
        Some(Hint::Leaves)
    } else if says(&WOOD_WORDS) {
        Some(Hint::Wood)
    } else {
        None
    }
}

fn leaf_or_blob(shape: &Shape) -> Class {
    let thick = shape.widths[2] > BLOB_THICK * shape.widths[0];
    if shape.n_triangles > BLOB_TRIANGLES && thick && shape.open < CARD_OPEN {
        Class::Blob
    } else {
        Class::Leaf
    }
}

fn by_shape(shape: &Shape) -> Class {
    let flat = shape.widths[2] < FLAT * shape.widths[1];
    if shape.open > CARD_OPEN || flat {
        Class::Leaf
    } else if shape.solid > BLOB_SOLID && shape.slenderness() < BLOB_SLENDER {
        Class::Blob
    } else {
        Class::Wood
    }
}

/// Cards whose vertices lie on wood are patches of bark in another colour.
fn return_patches(soup: &Soup, triangles: &Rows, guessed: &[bool], classes: &mut [Class]) {
    let mut on_wood = vec![false; soup.positions.len()];
    let corners = |component: usize| {
        triangles.of(component as u32).iter().flat_map(|&t| soup.triangles[t as usize])
    };
    for component in (0..classes.len()).filter(|&c| classes[c] == Class::Wood) {
        corners(component).for_each(|vertex| on_wood[vertex as usize] = true);
    }
    for component in 0..classes.len() {
        if !guessed[component] || classes[component] != Class::Leaf {
            continue;
        }
        let all = corners(component).count();
        let shared = corners(component).filter(|&vertex| on_wood[vertex as usize]).count();
        if shared as f32 >= PATCH_SHARE * all as f32 {
            classes[component] = Class::Wood;
        }
    }
}
