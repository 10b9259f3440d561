//! Which boxes stand for the leaves at a distance, and which leaves are drawn as they are (Lluch et al. 2010,
//! §4.2.4).
//!
//! From the box of the whole tree down: where a texel of a box's pictures is larger than a pixel, its
//! children are drawn instead, and its own leaves as geometry. A box without children gives all its
//! leaves as geometry then, unless they are hardly larger than pixels: those look no better than their picture.
//!
//! Departures: a box changes back only when its texels have become somewhat smaller than a pixel again
//! ([`ChooseParams::hysteresis`]), so that a camera that trembles does not make leaves flicker. The distance is
//! that of the nearest point of the box.
//!
//! Cost: O(boxes reached); nothing is allocated after the first call.

use super::boxes::Boxes;
use super::cards::Cards;
use crate::error::{LodError, Result, check_range};
use glam::Vec3;
use std::ops::Range;

/// Side in pixels from which on leaves are drawn as they are, where a texel may cover one.
const LEAF_PIXELS: f32 = 2.0;

/// When boxes are opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChooseParams {
    /// Pixels that a texel may cover before its box is opened, 0.01 to 100. Less is sharper and heavier.
    /// Default 1 (§4.2.4).
    pub texel_pixels: f32,
    /// How much further, relatively, a box must be before it is closed again, 0 to 1. Default 0.1.
    pub hysteresis: f32,
}

impl Default for ChooseParams {
    fn default() -> Self {
        Self { texel_pixels: 1.0, hysteresis: 0.1 }
    }
}

impl ChooseParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("choose.texel_pixels", self.texel_pixels.into(), 0.01, 100.0)?;
        check_range("choose.hysteresis", self.hysteresis.into(), 0.0, 1.0)
    }
}

/// Who looks, from where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watcher {
    /// The eye in the space of the tree, in metres.
    pub eye: Vec3,
    /// Pixels that something of a metre covers at a distance of a metre:
    /// height in pixels / (2 tan(fov / 2)), times the scale of the instance. Above 0, at most 10⁹.
    pub pixels_per_metre: f32,
}

/// What is drawn of a tree's leaves, and which boxes are open. One for each instance, kept from frame to
/// frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choice {
    /// Boxes drawn by their planes.
    pub boxes: Vec<u32>,
    /// Rows of [`Boxes::order`] drawn as geometry, rising, neighbours joined.
    pub leaves: Vec<Range<u32>>,
    open: Vec<bool>,
    texels: Vec<f32>,
    stack: Vec<u32>,
}

impl Choice {
    /// With room for all there can ever be, and all boxes closed.
    ///
    /// # Errors
    /// None that a baked `cards` gives.
    pub fn new(cards: &Cards) -> Result<Self> {
        let n = cards.boxes().boxes().len();
        let finest = |number: u32| {
            let texel = cards.texel(number)?;
            let last = cards.boxes().get(number)?.children.is_empty();
            Ok(if last { texel.min(cards.leaf_size(number) / LEAF_PIXELS) } else { texel })
        };
        let texels = (0..n as u32).map(finest).collect::<Result<_>>()?;
        Ok(Self {
            boxes: Vec::with_capacity(n),
            leaves: Vec::with_capacity(n),
            open: vec![false; n],
            texels,
            stack: Vec::with_capacity(n),
        })
    }

    /// Chooses for a frame. Every leaf is in one box or one range.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for parameters or a watcher out of range; [`LodError::Length`] when this was
    /// made for other cards; nothing is changed then.
    ///
    /// # Complexity
    /// O(boxes reached).
    pub fn update(
        &mut self,
        boxes: &Boxes,
        watcher: &Watcher,
        params: &ChooseParams,
    ) -> Result<()> {
        params.validate()?;
        for v in watcher.eye.to_array() {
            check_range("watcher.eye", v.into(), -1e9, 1e9)?;
        }
        let scale = watcher.pixels_per_metre;
        check_range("watcher.pixels_per_metre", scale.into(), f64::MIN_POSITIVE, 1e9)?;
        let (found, expected) = (self.open.len(), boxes.boxes().len());
        if found != expected {
            return Err(LodError::Length { what: "choice", found, expected });
        }
        self.boxes.clear();
        self.leaves.clear();
        self.stack.clear();
        self.stack.push(0);
        while let Some(number) = self.stack.pop() {
            let row = number as usize;
            let (Some(leaf_box), Some(open)) = (boxes.boxes().get(row), self.open.get_mut(row))
            else {
                continue;
            };
            let most = params.texel_pixels * if *open { 1.0 - params.hysteresis } else { 1.0 };
            // Compared without a division: inside a box the distance is 0.
            *open = self.texels[row] * scale > most * leaf_box.distance(watcher.eye);
            if !*open {
                self.boxes.push(number);
                continue;
            }
            add(&mut self.leaves, leaf_box.own.clone());
            // The first child is taken first, so rows rise.
            self.stack.extend(leaf_box.children.clone().rev());
        }
        Ok(())
    }

    /// Leaves drawn as geometry.
    #[must_use]
    pub fn n_leaves(&self) -> usize {
        self.leaves.iter().map(|rows| rows.len()).sum()
    }
}

fn add(ranges: &mut Vec<Range<u32>>, rows: Range<u32>) {
    match ranges.last_mut() {
        _ if rows.is_empty() => {}
        Some(last) if last.end == rows.start => last.end = rows.end,
        _ => ranges.push(rows),
    }
}

#[cfg(test)]
mod tests;
