//! What is drawn for a λ.

use super::model::PrunedModel;
use crate::error::{LodError, Result, check_range};
use crate::quality::contrast;

/// Most levels of a list.
const MAX_LEVELS: f64 = 1024.0;

/// What is drawn for a λ, and the numbers that the shader needs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Share of the foliage's triangles, more than 0, at most 1. No less than what one element needs.
    pub lambda: f32,
    /// Factor on the area of each element.
    pub scale: f32,
    /// Factor on its lengths: √scale.
    pub growth: f32,
    /// Factor on the contrast of colours, more than 0, at most 1.
    pub contrast: f32,
    /// Width in λ over which the last elements fade; 0 where all are drawn.
    pub fade: f32,
    /// What is drawn of each part, in the order of the parts.
    pub windows: Vec<Window>,
    /// Triangles of the foliage that are drawn.
    pub n_triangles: u64,
}

/// A piece of a surface's index buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Window {
    /// Number of the surface.
    pub surface: u32,
    /// First index.
    pub first_index: u32,
    /// Number of indices; may be 0.
    pub index_count: u32,
}

impl PrunedModel {
    /// What is drawn for a λ: at most floor(λ · triangles of the full foliage), but at least one element.
    ///
    /// # Errors
    /// [`LodError::Parameter`] when λ is not within 0 to 1.
    ///
    /// # Complexity
    /// O(parts · log elements).
    pub fn level(&self, lambda: f32) -> Result<Level> {
        let cut = self.schedule.at(lambda)?;
        // Below this, the shader would take elements for not yet drawn.
        let lambda = lambda.max(self.schedule.least_lambda());
        let scale = self.table.at(lambda).scale;
        let window = |part: &super::Part| {
            let triangles = part.layout.window(&cut);
            Window {
                surface: part.surface,
                first_index: 3 * triangles.start,
                index_count: 3 * (triangles.end - triangles.start),
            }
        };
        Ok(Level {
            lambda,
            scale,
            growth: scale.sqrt(),
            contrast: contrast(lambda, scale),
            fade: self.fade_at(lambda),
            windows: self.parts.iter().map(window).collect(),
            n_triangles: cut.n_triangles,
        })
    }

    /// `n` levels, 2 to 1024, with rising λ: from the first of the table to the full model, in equal ratios.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for another `n`. Fewer levels come back where the table begins at 1.
    ///
    /// # Complexity
    /// O(n · parts · log elements).
    pub fn levels(&self, n: usize) -> Result<Vec<Level>> {
        check_range("levels", n as f64, 2.0, MAX_LEVELS)?;
        let first = self.table.rows().first().map_or(1.0, |row| row.lambda);
        let first = first.max(self.schedule.least_lambda());
        let ratio = libm::logf(first) / (n - 1) as f32;
        let mut levels = Vec::with_capacity(n);
        for i in (0..n).rev() {
            // The ends exactly.
            let lambda = if i + 1 == n { first } else { libm::expf(i as f32 * ratio) };
            levels.push(self.level(lambda.clamp(first, 1.0))?);
        }
        levels.dedup_by(|later, earlier| later.lambda <= earlier.lambda);
        Ok(levels)
    }

    /// A share of λ, but nothing where all elements are drawn: the last must have grown up there.
    fn fade_at(&self, lambda: f32) -> f32 {
        (self.fade * lambda).min(self.schedule.lambda_of_all() - lambda).max(0.0)
    }

    /// Checks that a level is one of this model's.
    pub(super) fn check_level(&self, level: &Level) -> Result<()> {
        let fits = level.windows.len() == self.parts.len()
            && level.windows.iter().zip(&self.parts).all(|(window, part)| {
                let end = window.first_index.checked_add(window.index_count);
                window.surface == part.surface
                    && window.first_index.is_multiple_of(3)
                    && window.index_count.is_multiple_of(3)
                    && end.is_some_and(|end| end <= 3 * part.layout.n_triangles())
            });
        if !fits {
            return Err(LodError::Foliage("the level is one of another model"));
        }
        check_range("growth", level.growth.into(), 0.0, 1e3)?;
        check_range("lambda", level.lambda.into(), 0.0, 1.0)?;
        check_range("fade", level.fade.into(), 0.0, 1.0)
    }
}
