//! Scale and quality for each share of geometry.

use crate::error::{LodError, Result, check_range};

/// A share of geometry, its best scale, and how good the model then is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// Share of the foliage's triangles that is drawn, more than 0, at most 1.
    pub lambda: f32,
    /// Factor on the area of each element.
    pub scale: f32,
    /// Precision over the views that were looked at.
    pub precision: f32,
    /// Recall over them.
    pub recall: f32,
    /// Mean of the quality of the views.
    pub quality: f32,
}

/// Rows with rising λ, the last of which is the full model; in between, values are interpolated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    rows: Vec<Row>,
}

impl Table {
    /// A table of these rows.
    ///
    /// # Errors
    /// [`LodError::Table`] when there are none, when λ does not rise, leaves 0 to 1 or does not
    /// end at 1, or when a number is not finite or a scale not positive.
    pub fn new(rows: Vec<Row>) -> Result<Self> {
        let problem = |row, problem| Err(LodError::Table { row, problem });
        let mut last = 0.0;
        for (i, row) in rows.iter().enumerate() {
            if !(row.lambda > last && row.lambda <= 1.0) {
                return problem(i, "λ must rise from above 0 to 1");
            }
            let numbers = [row.precision, row.recall, row.quality];
            let sound = row.scale > 0.0 && row.scale < 1e6;
            if !(sound && numbers.iter().all(|n| n.is_finite())) {
                return problem(i, "numbers must be finite and the scale positive");
            }
            last = row.lambda;
        }
        if last != 1.0 {
            return problem(rows.len().saturating_sub(1), "the last λ must be 1");
        }
        Ok(Self { rows })
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The row for a λ, interpolated linearly as in §7.2.2; λ is brought into the range of the
    /// table.
    ///
    /// # Complexity
    /// O(log rows).
    #[must_use]
    pub fn at(&self, lambda: f32) -> Row {
        let above = self.rows.partition_point(|row| row.lambda < lambda);
        let (Some(b), Some(last)) = (self.rows.get(above), self.rows.last()) else {
            return self.rows.last().copied().unwrap_or_default();
        };
        let Some(a) = above.checked_sub(1).and_then(|below| self.rows.get(below)) else {
            return *b;
        };
        if lambda >= last.lambda {
            return *last;
        }
        let t = (lambda - a.lambda) / (b.lambda - a.lambda);
        let mix = |from: f32, to: f32| from + t * (to - from);
        Row {
            lambda,
            scale: mix(a.scale, b.scale),
            precision: mix(a.precision, b.precision),
            recall: mix(a.recall, b.recall),
            quality: mix(a.quality, b.quality),
        }
    }

    /// The least λ from which on the quality is at least `quality`; 1 when only the full model is.
    ///
    /// # Complexity
    /// O(rows).
    #[must_use]
    pub fn lambda_for(&self, quality: f32) -> f32 {
        let Some(above) = self.rows.iter().rposition(|row| row.quality < quality) else {
            return self.rows.first().map_or(1.0, |row| row.lambda);
        };
        let (Some(a), Some(b)) = (self.rows.get(above), self.rows.get(above + 1)) else {
            return 1.0;
        };
        let t = (quality - a.quality) / (b.quality - a.quality);
        a.lambda + t * (b.lambda - a.lambda)
    }
}

/// Scale after Cook et al. (2007): 1 / λ, so that the summed area stays. For a λ of 0 or less, or none at
/// all, the scale is as large as a number can be.
#[must_use]
pub fn cook_scale(lambda: f32) -> f32 {
    (1.0 / lambda.max(f32::MIN_POSITIVE)).min(f32::MAX)
}

/// Share of geometry after Cook et al. (2007), (1 − d)², for a distance d of 0 to 1.
#[must_use]
pub fn cook_lambda(d: f32) -> f32 {
    let near = 1.0 - d.clamp(0.0, 1.0);
    near * near
}

/// Share of geometry by size on the screen (Cook et al. 2007; §6.3.2): `b^(log_h ½)` with b = B / B₀,
/// where B is the size in pixels of the bounding box, `B₀` that at which pruning begins, and h·B₀ that at
/// which half is left.
///
/// # Errors
/// [`LodError::Parameter`] for sizes outside 0 to 10⁹ pixels or an h outside 0.001 to 0.999.
pub fn size_lambda(size: f32, full: f32, h: f32) -> Result<f32> {
    check_range("size", size.into(), 0.0, 1e9)?;
    check_range("full", full.into(), 1e-3, 1e9)?;
    check_range("h", h.into(), 0.001, 0.999)?;
    let b = (size / full).min(1.0);
    Ok(if b <= 0.0 { 0.0 } else { libm::powf(b, libm::logf(0.5) / libm::logf(h)) })
}

/// Factor on *length* of `k` elements left of `n` (Deussen and Lintermann 2004; eq. 6.4 with the
/// sign set right): w √(n / k) + (1 − w), w from 0 (nothing grows) to 1 (area is kept).
///
/// # Errors
/// [`LodError::Parameter`] for a `w` outside 0 to 1, or `k` outside 1 to `n`.
pub fn drop_and_resize(n: u32, k: u32, w: f32) -> Result<f32> {
    check_range("w", w.into(), 0.0, 1.0)?;
    check_range("k", k.into(), 1.0, n.into())?;
    Ok(w * (n as f32 / k as f32).sqrt() + (1.0 - w))
}

/// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007, "contrast
/// preservation"): a pixel's colour is a mean of elements weighted by area, its variance grows as
/// λ s² when fewer and larger ones are drawn. 1 / (s √λ), at most 1; √λ for s = 1 / λ.
#[must_use]
pub fn contrast(lambda: f32, scale: f32) -> f32 {
    let spread = scale.max(0.0) * lambda.clamp(0.0, 1.0).sqrt();
    if spread > 1.0 { 1.0 / spread } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(lambda: f32, scale: f32, quality: f32) -> Row {
        Row { lambda, scale, precision: quality, recall: quality, quality }
    }

    #[test]
    fn values_between_rows_are_interpolated_and_beyond_them_kept() {
        let table = Table::new(vec![row(0.1, 4.0, 0.6), row(0.5, 2.0, 0.8), row(1.0, 1.0, 1.0)]);
        let table = table.unwrap();
        assert!((table.at(0.3).scale - 3.0).abs() < 1e-6);
        assert_eq!(table.at(0.01), row(0.1, 4.0, 0.6));
        assert_eq!(table.at(2.0), row(1.0, 1.0, 1.0));
    }

    #[test]
    fn the_least_share_of_a_quality_ignores_a_dip_before_it() {
        let rows =
            vec![row(0.1, 4.0, 0.7), row(0.2, 3.0, 0.6), row(0.6, 2.0, 0.8), row(1.0, 1.0, 1.0)];
        let table = Table::new(rows).unwrap();
        assert!((table.lambda_for(0.7) - 0.4).abs() < 1e-6);
        assert_eq!(table.lambda_for(0.0), 0.1);
        assert_eq!(table.lambda_for(1.1), 1.0);
    }

    #[test]
    fn tables_that_do_not_rise_to_the_full_model_are_refused() {
        for rows in [
            vec![],
            vec![row(0.5, 1.0, 1.0)],
            vec![row(0.5, 1.0, 1.0), row(0.5, 1.0, 1.0), row(1.0, 1.0, 1.0)],
            vec![row(0.0, 1.0, 1.0), row(1.0, 1.0, 1.0)],
            vec![row(f32::NAN, 1.0, 1.0), row(1.0, 1.0, 1.0)],
            vec![row(0.5, 0.0, 1.0), row(1.0, 1.0, 1.0)],
            vec![row(0.5, 1.0, f32::NAN), row(1.0, 1.0, 1.0)],
        ] {
            assert!(matches!(Table::new(rows), Err(LodError::Table { .. })));
        }
    }

    #[test]
    fn the_rules_of_the_literature_hold_at_their_ends() {
        assert_eq!((cook_lambda(0.0), cook_lambda(0.5), cook_lambda(7.0)), (1.0, 0.25, 0.0));
        assert_eq!(cook_scale(0.25), 4.0);
        assert_eq!(drop_and_resize(8, 8, 0.3).unwrap(), 1.0);
        assert_eq!(drop_and_resize(8, 2, 1.0).unwrap(), 2.0);
        assert!(drop_and_resize(8, 0, 1.0).is_err());
        assert!((size_lambda(50.0, 200.0, 0.25).unwrap() - 0.5).abs() < 1e-6);
        assert_eq!(size_lambda(900.0, 200.0, 0.25).unwrap(), 1.0);
        assert!((contrast(0.25, 4.0) - 0.5).abs() < 1e-6);
        assert_eq!(contrast(0.5, 1.0), 1.0);
    }
}
