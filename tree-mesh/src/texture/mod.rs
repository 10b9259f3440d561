//! Built-in textures, generated: no file has to be downloaded.
//!
//! Bark tiles in both directions without a seam. Leaves are pictures for a flat card: the base of the
//! petiole at the bottom centre, the apex at the top, the midrib upright, nothing else at the border.
//! A *cluster* is a whole twig on one card, which fills a crown with far fewer triangles.
//!
//! Kinds are rows of tables ([`BarkStyle`], [`LeafShape`]); take a row with [`bark_style`] or
//! [`leaf_shape`], change it and draw your own with [`bark_with`] or [`leaf_with`]. The same row gives
//! the same bytes on every platform and for any number of threads.
//!
//! ```
//! use tree_mesh::texture;
//! let bark = texture::bark("oak")?;
//! let leaf = texture::leaf("oak")?;
//! assert_eq!((bark.width, leaf.texture.width), (512, 256));
//! # Ok::<(), tree_mesh::MeshError>(())
//! ```

mod bark;
mod bark_presets;
mod check;
mod leaf;
mod leaf_presets;
mod noise;
mod outline;
mod picture;
mod raster;
mod spray;
#[cfg(test)]
mod tests;

pub use bark::{BarkStyle, Lenticels, Patches};
pub use leaf::{LeafShape, LeafStyle, Teeth, Veins};
pub use spray::Spray;

use crate::error::{MeshError, Result};
use crate::mesh::Texture;

/// Edge of a built-in bark, in pixels.
pub const BARK_SIZE: u32 = 512;
/// Edge of a built-in single leaf, in pixels.
pub const LEAF_SIZE: u32 = 256;
/// Edge of a built-in spray of leaves (a cluster, a frond, needles), in pixels.
pub const SPRAY_SIZE: u32 = 512;

/// A picture of a leaf, or of a twig with leaves, and how to put it on a card.
#[derive(Clone, Debug, PartialEq)]
pub struct LeafTexture {
    /// The picture. Transparent pixels carry the colour of the leaf near them; meant for an alpha
    /// cutoff of 0.5.
    pub texture: Texture,
    /// Width of the card per length from base to apex.
    pub width: f32,
    /// Share of the height, from the base, that is stalk (for a spray: bare twig), 0 to 1.
    pub petiole: f32,
}

/// Draws a built-in bark at [`BARK_SIZE`].
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such bark.
pub fn bark(name: &str) -> Result<Texture> {
    bark_sized(name, BARK_SIZE)
}

/// Draws a built-in bark `size_px` pixels wide and high, 16 to 4096.
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such bark, [`MeshError::Parameter`] for a bad size.
///
/// # Complexity
/// Linear in the pixels, 20 bytes of scratch each; about 0.1 µs of one core per pixel.
pub fn bark_sized(name: &str, size_px: u32) -> Result<Texture> {
    check::size(size_px)?;
    let (name, style) = find("bark", bark_presets::TABLE, name)?;
    Ok(bark::draw(style, name, size_px))
}

/// Draws a bark of your own, `size_px` pixels wide and high, 16 to 4096; its name is `bark`.
///
/// # Errors
/// [`MeshError::Parameter`], naming the field that is out of its range.
///
/// # Complexity
/// As [`bark_sized`]; each patch layer adds about a fifth.
pub fn bark_with(style: &BarkStyle, size_px: u32) -> Result<Texture> {
    check::size(size_px)?;
    style.validate()?;
    Ok(bark::draw(style, "bark", size_px))
}

/// The row of a built-in bark, to be changed and given to [`bark_with`].
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such bark.
pub fn bark_style(name: &str) -> Result<BarkStyle> {
    find("bark", bark_presets::TABLE, name).map(|(_, style)| style.clone())
}

/// Names of the built-in barks.
#[must_use]
pub const fn bark_names() -> &'static [&'static str] {
    const NAMES: [&str; bark_presets::TABLE.len()] = names(bark_presets::TABLE);
    &NAMES
}

/// Draws a built-in leaf at [`LEAF_SIZE`], a spray at [`SPRAY_SIZE`].
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such leaf.
pub fn leaf(name: &str) -> Result<LeafTexture> {
    let (name, shape) = find("leaf kind", leaf_presets::TABLE, name)?;
    let size_px = if shape.spray.is_some() { SPRAY_SIZE } else { LEAF_SIZE };
    Ok(picture::draw_leaf(shape, name, size_px))
}

/// Draws a built-in leaf on a picture `size_px` pixels wide and high, 16 to 4096.
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such leaf, [`MeshError::Parameter`] for a bad size.
///
/// # Complexity
/// Rows of pixels times edges of the outlines on them, plus the pixels of all leaves; 24 bytes of
/// scratch per pixel.
pub fn leaf_sized(name: &str, size_px: u32) -> Result<LeafTexture> {
    check::size(size_px)?;
    let (name, shape) = find("leaf kind", leaf_presets::TABLE, name)?;
    Ok(picture::draw_leaf(shape, name, size_px))
}

/// Draws a leaf of your own, `size_px` pixels wide and high, 16 to 4096; its name is `leaf`.
///
/// # Errors
/// [`MeshError::Parameter`], naming the field that is out of its range.
///
/// # Complexity
/// As [`leaf_sized`].
pub fn leaf_with(shape: &LeafShape, size_px: u32) -> Result<LeafTexture> {
    check::size(size_px)?;
    shape.validate()?;
    Ok(picture::draw_leaf(shape, "leaf", size_px))
}

/// The row of a built-in leaf, to be changed and given to [`leaf_with`].
///
/// # Errors
/// [`MeshError::Unknown`] when there is no such leaf.
pub fn leaf_shape(name: &str) -> Result<LeafShape> {
    find("leaf kind", leaf_presets::TABLE, name).map(|(_, shape)| shape.clone())
}

/// Names of the built-in leaves: single ones, clusters, needles and fronds.
#[must_use]
pub const fn leaf_names() -> &'static [&'static str] {
    const NAMES: [&str; leaf_presets::TABLE.len()] = names(leaf_presets::TABLE);
    &NAMES
}

fn find<'a, T>(
    what: &'static str,
    table: &'a [(&'static str, T)],
    name: &str,
) -> Result<(&'static str, &'a T)> {
    match table.iter().find(|(known, _)| *known == name) {
        Some((name, row)) => Ok((name, row)),
        None => Err(MeshError::Unknown {
            what,
            name: name.to_owned(),
            known: table.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", "),
        }),
    }
}

const fn names<T, const N: usize>(table: &[(&'static str, T)]) -> [&'static str; N] {
    let mut all = [""; N];
    let mut i = 0;
    while i < N {
        all[i] = table[i].0;
        i += 1;
    }
    all
}
