//! How a direction field is made.

use crate::error::{ModelError, Result, check};

/// Most rows of a field.
const MAX_ROWS: u32 = 4096;

/// How much a particle is directed towards the attractor instead of along it, by its distance: the
/// blending function h(d) of Eq. 3.7 (Neubert 2012).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Blend {
    /// From 0 on the attractor to `most` at a distance of `reach` and beyond (the thesis's linear
    /// blending): near it particles follow it, far from it they head for it.
    Linear {
        /// Distance as a share of the picture's height, 0.0001 to 10.
        reach: f32,
        /// Greatest share, 0 to 1.
        most: f32,
    },
    /// The same at every distance but 0 (constant blending): particles meet the attractor at a fixed
    /// angle, tan = share / (1 − share).
    Constant {
        /// Share, 0 to 1.
        share: f32,
    },
    /// Straight lines between points (distance as a share of the picture's height, share 0 to 1) of
    /// ascending distance; before the first and after the last as they. At least one.
    Custom(Vec<(f32, f32)>),
}

impl Default for Blend {
    /// Linear with a reach of 0.05 and at most 0.85: particles from anywhere are on the attractor within a
    /// tenth of the picture's height of further way, and even far away they move a little down with the
    /// branch.
    fn default() -> Self {
        Self::Linear { reach: 0.05, most: 0.85 }
    }
}

impl Blend {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        match self {
            Self::Linear { reach, most } => {
                check("field.blend.reach", *reach, 1e-4_f32, 10.0_f32)?;
                check("field.blend.most", *most, 0.0_f32, 1.0_f32)
            }
            Self::Constant { share } => check("field.blend.share", *share, 0.0_f32, 1.0_f32),
            Self::Custom(points) => {
                if points.is_empty() {
                    let problem = "the table of a custom blend is empty".to_string();
                    return Err(ModelError::Attractor { problem });
                }
                let mut before = 0.0;
                for (i, &(distance, share)) in points.iter().enumerate() {
                    check(format!("field.blend[{i}].distance"), distance, before, 1e6_f32)?;
                    check(format!("field.blend[{i}].share"), share, 0.0_f32, 1.0_f32)?;
                    before = distance;
                }
                Ok(())
            }
        }
    }

    /// The share at a distance (as a share of the picture's height).
    #[must_use]
    pub fn at(&self, distance: f32) -> f32 {
        match self {
            Self::Linear { reach, most } => most * (distance / reach.max(1e-9)).min(1.0),
            Self::Constant { share } => {
                if distance > 0.0 {
                    *share
                } else {
                    0.0
                }
            }
            Self::Custom(points) => {
                let after = points.partition_point(|point| point.0 < distance);
                match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
                    (Some(a), Some(b)) => {
                        a.1 + (b.1 - a.1) * (distance - a.0) / (b.0 - a.0).max(1e-12)
                    }
                    (Some(only), None) | (None, Some(only)) => only.1,
                    (None, None) => 0.0,
                }
            }
        }
    }
}

/// How a direction field is made.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct FieldParams {
    /// Cells over the height of the picture, 1 to 4096. Default 100, as in the thesis. Cost grows with the
    /// square.
    pub rows: u32,
    /// How far the grid reaches beyond the picture on every side, as a share of its height, 0 to 2.
    /// Default 0.1.
    pub margin: f32,
    /// How directions towards and along the attractor are blended.
    pub blend: Blend,
}

impl Default for FieldParams {
    fn default() -> Self {
        Self { rows: 100, margin: 0.1, blend: Blend::default() }
    }
}

impl FieldParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range, [`ModelError::Attractor`] for an empty
    /// table.
    pub fn validate(&self) -> Result<()> {
        check("field.rows", self.rows, 1, MAX_ROWS)?;
        check("field.margin", self.margin, 0.0_f32, 2.0_f32)?;
        self.blend.validate()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blends_are_as_told() {
        let linear = Blend::Linear { reach: 0.2, most: 0.8 };
        assert_eq!([0.0, 0.1, 0.2, 9.0].map(|d| linear.at(d)), [0.0, 0.4, 0.8, 0.8]);
        let constant = Blend::Constant { share: 0.3 };
        assert_eq!([0.0, 0.1, 9.0].map(|d| constant.at(d)), [0.0, 0.3, 0.3]);
        let custom = Blend::Custom(vec![(0.1, 0.0), (0.2, 1.0), (0.2, 0.5)]);
        let found = [0.0, 0.1, 0.15, 0.5].map(|d| custom.at(d));
        assert!((found[2] - 0.5).abs() < 1e-6);
        assert_eq!((found[0], found[1], found[3]), (0.0, 0.0, 0.5));
    }

    #[test]
    fn bad_parameters_are_named() {
        let with = |blend| FieldParams { blend, ..Default::default() }.validate();
        let text = |result: Result<()>| result.unwrap_err().to_string();
        assert!(text(with(Blend::Constant { share: f32::NAN })).contains("field.blend.share"));
        assert!(text(with(Blend::Linear { reach: 0.0, most: 1.0 })).contains("field.blend.reach"));
        assert!(text(with(Blend::Custom(vec![]))).contains("empty"));
        let falling = Blend::Custom(vec![(0.5, 0.1), (0.1, 0.1)]);
        assert!(text(with(falling)).contains("field.blend[1].distance"));
        assert!(FieldParams { rows: 0, ..Default::default() }.validate().is_err());
        assert!(FieldParams { margin: -1.0, ..Default::default() }.validate().is_err());
    }
}
