//! What is drawn for a viewer.

use super::make::Hybrid;
use crate::error::{LodError, Result, check_range};
use crate::impostor::cards::PLANES;
use crate::impostor::choose::{Choice, Watcher};

/// What is drawn of one instance, and what must be remembered from frame to frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HybridChoice {
    /// Fractional level of the wood, from 1.
    pub level: f32,
    /// Boxes and ranges of leaves; none when the tree has no leaves.
    pub leaves: Option<Choice>,
}

impl Hybrid {
    /// The state of an instance that has not been drawn yet.
    ///
    /// # Errors
    /// None that is known.
    pub fn choice(&self) -> Result<HybridChoice> {
        let leaves = self.cards.as_ref().map(Choice::new).transpose()?;
        Ok(HybridChoice { level: 1.0, leaves })
    }

    /// Chooses for a frame.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for a viewer out of range; [`LodError::Impostor`] or [`LodError::Length`] for a
    /// choice of another model. Nothing is changed then.
    ///
    /// # Complexity
    /// O(log levels + boxes reached); nothing is allocated.
    pub fn update(&self, choice: &mut HybridChoice, watcher: &Watcher) -> Result<()> {
        let outside = watcher.eye - watcher.eye.clamp(self.bounds.min, self.bounds.max);
        let level = self.level(watcher.pixels_per_metre / outside.length())?;
        match (&self.cards, &mut choice.leaves) {
            (Some(cards), Some(leaves)) => leaves.update(cards.boxes(), watcher, &self.choose)?,
            (None, None) => {}
            _ => return Err(LodError::Impostor("the choice is that of another model")),
        }
        choice.level = level;
        Ok(())
    }

    /// The fractional level of the wood where a metre covers so many pixels, 0 to infinity. It changes without
    /// a step.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for NaN or less than 0.
    ///
    /// # Complexity
    /// O(log levels).
    pub fn level(&self, pixels_per_metre: f32) -> Result<f32> {
        check_range("pixels_per_metre", pixels_per_metre.into(), 0.0, f64::INFINITY)?;
        let least = self.wood_pixels / pixels_per_metre;
        let whole = self.sizes.partition_point(|&size| size > least);
        let (Some(&above), Some(&below)) =
            (whole.checked_sub(1).and_then(|last| self.sizes.get(last)), self.sizes.get(whole))
        else {
            return Ok(whole.max(1) as f32);
        };
        // The next path is whole where it covers enough itself, and nothing where the last one just does.
        let part = if above > below { (above - least) / (above - below) } else { 0.0 };
        Ok(whole as f32 + part.clamp(0.0, 1.0))
    }

    /// Triangles that are drawn: wood, leaves, and two for each plane of a box.
    ///
    /// # Complexity
    /// O(ranges · surfaces).
    #[must_use]
    pub fn n_triangles(&self, choice: &HybridChoice) -> u64 {
        let wood = u64::from(self.wood.wood_indices(choice.level)) / 3;
        let Some(leaves) = &choice.leaves else { return wood };
        let of = |rows: &std::ops::Range<u32>| -> u64 {
            (0..self.starts.len()).map(|s| u64::from(self.leaf_window(s, rows.clone()).1) / 3).sum()
        };
        let planes = (2 * PLANES * leaves.boxes.len()) as u64;
        wood + planes + leaves.leaves.iter().map(of).sum::<u64>()
    }
}
