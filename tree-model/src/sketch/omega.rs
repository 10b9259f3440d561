//! Ω, the global parameters of a tree (Neubert 2012, section 4.5), for each order of axes its own.

/// A normal distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Normal {
    /// Its mean μ.
    pub mean: f32,
    /// Its standard deviation σ, above 0.
    pub deviation: f32,
}

impl Normal {
    /// A distribution of this mean and standard deviation.
    #[must_use]
    pub const fn new(mean: f32, deviation: f32) -> Self {
        Self { mean, deviation }
    }
}

/// How axes of one order go on and branch. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Habit {
    /// Natural logarithm of the length of the apical segment over that of the segment below.
    pub scale: Normal,
    /// Natural logarithm of the length of a lateral's first segment over that of the segment below.
    pub lateral_scale: Normal,
    /// α: the angle between the apical segment and the segment below.
    pub alpha: Normal,
    /// β: the angle between a lateral and the segment below.
    pub beta: Normal,
    /// γ: the turn about the axis from one lateral to the next.
    pub gamma: Normal,
}

/// Ω: a [`Habit`] for axes of order 0 (the trunk), 1 and so on; the last holds for all higher orders too.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Omega {
    /// The habits, at least one.
    pub orders: Vec<Habit>,
}
