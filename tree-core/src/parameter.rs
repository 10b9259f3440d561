//! Parameters out of range: one error and one check for all crates of the family.

use std::borrow::Cow;

/// A parameter that lies outside its range, or is not a number.
///
/// ```
/// use tree_core::check_parameter;
///
/// let error = check_parameter("leaves.droop", 1.5, 0.0, 1.0).unwrap_err();
/// assert_eq!(error.to_string(), "leaves.droop is 1.5, allowed is 0 to 1");
/// assert_eq!(error.within("crown").field, "crown.leaves.droop");
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{field} is {found}, allowed is {min} to {max}")]
pub struct ParameterError {
    /// Path of the field, for example `levels[2].turn`.
    pub field: Cow<'static, str>,
    /// The value that came in.
    pub found: f64,
    /// Smallest allowed value.
    pub min: f64,
    /// Largest allowed value.
    pub max: f64,
}

impl ParameterError {
    /// The same error, its field named as part of `outer`.
    #[must_use]
    pub fn within(self, outer: &str) -> Self {
        Self { field: format!("{outer}.{}", self.field).into(), ..self }
    }
}

/// Checks that a parameter lies within `min..=max`. NaN lies in no range.
///
/// # Errors
/// [`ParameterError`], naming `field`.
pub fn check_parameter(
    field: impl Into<Cow<'static, str>>,
    found: impl Into<f64>,
    min: impl Into<f64>,
    max: impl Into<f64>,
) -> Result<(), ParameterError> {
    let (found, min, max) = (found.into(), min.into(), max.into());
    if (min..=max).contains(&found) {
        return Ok(());
    }
    Err(ParameterError { field: field.into(), found, min, max })
}
