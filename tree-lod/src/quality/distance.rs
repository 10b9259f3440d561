//! Share of geometry for each distance.

use super::table::{Table, cook_lambda};
use crate::error::Result;

/// Samples of λ(d) at the near end, d from 0 to 0.1, and over the rest (§7.2.5).
const SAMPLES: usize = 10;

/// Quality that is asked of a model at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MinimumQuality {
    /// The same at every distance, 0 to 1.
    Constant(f32),
    /// This at the near end, falling linearly to that at the far end; each 0 to 1.
    Falling(f32, f32),
}

/// λ as a function of distance: d from 0 (near, the full model) to 1 (far), λ from 0 to 1, falling.
///
/// Ten equidistant samples from 0 to 0.1 and ten from there to 1, interpolated linearly (§7.2.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    lambdas: [f32; 2 * SAMPLES + 1],
}

impl Default for Distance {
    /// As [`Distance::cook`].
    fn default() -> Self {
        Self::cook()
    }
}

impl Distance {
    /// (1 − d)² (Cook et al. 2007).
    #[must_use]
    pub fn cook() -> Self {
        Self::of(cook_lambda)
    }

    /// The least λ of a model that is as good as asked for.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) for a quality outside 0 to 1.
    pub fn for_quality(table: &Table, quality: MinimumQuality) -> Result<Self> {
        let (near, far) = match quality {
            MinimumQuality::Constant(q) => (q, q),
            MinimumQuality::Falling(near, far) => (near, far),
        };
        crate::error::check_range("quality", near.into(), 0.0, 1.0)?;
        crate::error::check_range("quality", far.into(), 0.0, 1.0)?;
        Ok(Self::of(|d| table.lambda_for(near + d * (far - near))))
    }

    /// The least λ at which the model of `table` is as good as the one of `cook` is at (1 − d)²:
    /// the same pictures with less geometry (§7.2.5). `cook` is measured with stochastic order and scale 1 / λ.
    #[must_use]
    pub fn parity(table: &Table, cook: &Table) -> Self {
        Self::of(|d| {
            let lambda = cook_lambda(d);
            // Never more than Cook draws, where the tables are too coarse to tell.
            table.lambda_for(cook.at(lambda).quality).min(lambda.max(first(table)))
        })
    }

    /// Samples of a function, at [`Distance::places`].
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) when a sample is not within 0 to 1.
    pub fn from_samples(lambdas: &[f32; 2 * SAMPLES + 1]) -> Result<Self> {
        for &lambda in lambdas {
            crate::error::check_range("lambda", lambda.into(), 0.0, 1.0)?;
        }
        Ok(Self::of_samples(*lambdas))
    }

    /// The distances that are sampled: 0, 0.01 … 0.1, 0.19 … 1.
    #[must_use]
    pub fn places() -> [f32; 2 * SAMPLES + 1] {
        std::array::from_fn(|i| {
            if i <= SAMPLES { 0.01 * i as f32 } else { 0.1 + 0.09 * (i - SAMPLES) as f32 }
        })
    }

    /// λ at each of the [`places`](Self::places).
    #[must_use]
    pub fn samples(&self) -> &[f32; 2 * SAMPLES + 1] {
        &self.lambdas
    }

    /// λ at a distance, which is brought into 0 to 1; NaN is far.
    #[must_use]
    #[inline]
    pub fn lambda(&self, d: f32) -> f32 {
        // Written so that NaN is 1.
        let d = if d < 1.0 { d.max(0.0) } else { 1.0 };
        let at = if d < 0.1 { d * 100.0 } else { SAMPLES as f32 + (d - 0.1) / 0.09 };
        let below = (at as usize).min(2 * SAMPLES - 1);
        let t = (at - below as f32).clamp(0.0, 1.0);
        self.lambdas[below] + t * (self.lambdas[below + 1] - self.lambdas[below])
    }

    fn of(lambda: impl Fn(f32) -> f32) -> Self {
        Self::of_samples(Self::places().map(lambda))
    }

    /// Quality measured on few views is not quite monotonic; geometry must not grow with distance.
    fn of_samples(mut lambdas: [f32; 2 * SAMPLES + 1]) -> Self {
        let mut least = 1.0_f32;
        for lambda in &mut lambdas {
            least = least.min(*lambda);
            *lambda = least;
        }
        Self { lambdas }
    }
}

fn first(table: &Table) -> f32 {
    table.rows().first().map_or(0.0, |row| row.lambda)
}

/// Quality asked for is checked by [`Distance::for_quality`].
impl From<f32> for MinimumQuality {
    fn from(quality: f32) -> Self {
        Self::Constant(quality)
    }
}

#[cfg(test)]
mod tests {
    use super::super::table::{Row, cook_scale};
    use super::*;
    use crate::LodError;
    use proptest::prelude::*;

    fn table(quality: impl Fn(f32) -> f32) -> Table {
        let rows = (1..=20).map(|i| {
            let lambda = i as f32 / 20.0;
            let quality = quality(lambda);
            Row { lambda, scale: cook_scale(lambda), precision: quality, recall: quality, quality }
        });
        Table::new(rows.collect()).unwrap()
    }

    #[test]
    fn cooks_rule_is_kept_at_its_samples() {
        let cook = Distance::cook();
        for d in Distance::places() {
            assert!((cook.lambda(d) - (1.0 - d) * (1.0 - d)).abs() < 1e-5, "{d}");
        }
        assert_eq!((cook.lambda(f32::NAN), cook.lambda(-3.0)), (0.0, 1.0));
    }

    #[test]
    fn a_better_model_needs_less_for_the_same_quality() {
        let (ours, cook) = (table(|l| l.sqrt()), table(|l| l));
        let parity = Distance::parity(&ours, &cook);
        for d in [0.0, 0.2, 0.4, 0.6] {
            let lambda = parity.lambda(d);
            assert!(lambda <= (1.0 - d) * (1.0 - d) + 1e-5);
            assert!(ours.at(lambda).quality >= cook.at((1.0 - d) * (1.0 - d)).quality - 0.02);
        }
    }

    #[test]
    fn a_quality_outside_its_range_is_refused() {
        for q in [-0.1, 1.1, f32::NAN] {
            let found = Distance::for_quality(&table(|l| l), q.into());
            assert!(matches!(found, Err(LodError::Parameter(error)) if error.field == "quality"));
        }
    }

    proptest! {
        #[test]
        fn geometry_never_grows_with_distance(samples in prop::array::uniform21(0.0_f32..=1.0), a in 0.0_f32..1.0, b in 0.0_f32..1.0) {
            let distance = Distance::from_samples(&samples).unwrap();
            prop_assert!(distance.lambda(a.min(b)) >= distance.lambda(a.max(b)));
        }
    }
}
