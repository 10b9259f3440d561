//! The branching angle function (section 3.2).

use crate::error::{Result, check};
use std::f32::consts::PI;

/// A redrawn branch takes the place of samples that are nearer than this share of the parent's length.
const SAME_PLACE: f32 = 0.04;

/// The angle between a parent's direction and that of its branches where they leave, along the parent: the branching
/// angle function. Between samples it is interpolated linearly, beyond them it is constant.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct BranchingAngles {
    /// Place along the parent, 0 at its base to 1 at its tip, in rising order; and angle, 0 (straight on) to π
    /// (backwards). At least one.
    pub samples: Vec<[f32; 2]>,
}

impl Default for BranchingAngles {
    /// Branches low on a trunk are near horizontal (plagiotropic), high ones near upright (orthotropic).
    fn default() -> Self {
        Self::between(1.35, 0.6)
    }
}

impl BranchingAngles {
    /// From one angle at the base to another at the tip, in radians.
    #[must_use]
    pub fn between(base: f32, tip: f32) -> Self {
        Self { samples: vec![[0.0, base], [1.0, tip]] }
    }

    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first sample out of range.
    pub fn validate(&self, field: &str) -> Result<()> {
        check(format!("{field}.samples.len"), self.samples.len() as f64, 1.0, 10_000.0)?;
        let mut least = 0.0;
        for (i, &[t, angle]) in self.samples.iter().enumerate() {
            check(format!("{field}.samples[{i}][0]"), t, least, 1.0_f32)?;
            check(format!("{field}.samples[{i}][1]"), angle, 0.0_f32, PI)?;
            least = t;
        }
        Ok(())
    }

    /// The angle at a place along the parent, 0 to 1. O(log samples).
    #[must_use]
    pub fn at(&self, t: f32) -> f32 {
        let after = self.samples.partition_point(|sample| sample[0] <= t);
        match (after.checked_sub(1).and_then(|i| self.samples.get(i)), self.samples.get(after)) {
            (Some(low), Some(high)) => {
                low[1] + (high[1] - low[1]) * (t - low[0]) / (high[0] - low[0])
            }
            (Some(only), None) | (None, Some(only)) => only[1],
            (None, None) => 0.0,
        }
    }

    /// Takes the angle of a redrawn branch as a sample; it replaces those close to it.
    pub fn set(&mut self, t: f32, angle: f32) {
        let (t, angle) = (t.clamp(0.0, 1.0), angle.clamp(0.0, PI));
        self.samples.retain(|sample| (sample[0] - t).abs() > SAME_PLACE);
        let place = self.samples.partition_point(|sample| sample[0] < t);
        self.samples.insert(place, [t, angle]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_interpolated_between_base_and_tip() {
        let angles = BranchingAngles::between(1.4, 0.6);
        assert!((angles.at(0.5) - 1.0).abs() < 1e-6);
        assert_eq!((angles.at(-1.0), angles.at(2.0)), (1.4, 0.6));
    }

    #[test]
    fn a_redrawn_branch_adds_a_sample_or_replaces_one() {
        let mut angles = BranchingAngles::between(1.4, 0.6);
        angles.set(0.5, 0.2);
        angles.set(0.52, 0.3);
        assert_eq!(angles.samples, [[0.0, 1.4], [0.52, 0.3], [1.0, 0.6]]);
        assert!(angles.validate("angles").is_ok());
    }

    #[test]
    fn samples_out_of_order_are_refused() {
        let angles = BranchingAngles { samples: vec![[0.5, 1.0], [0.2, 1.0]] };
        assert!(angles.validate("angles").unwrap_err().to_string().contains("samples[1][0]"));
        assert!(BranchingAngles { samples: vec![] }.validate("angles").is_err());
    }
}
