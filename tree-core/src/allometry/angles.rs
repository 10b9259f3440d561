//! Angles at which two branches leave a third, from radii or from strands.

use crate::error::Result;
use crate::parameter::{ParameterError, check_parameter};

/// Share by which r₀ may miss its range before a fork is called impossible: radii that were
/// rounded to f32 must not fail where exact ones stand on the limit, as da Vinci's always do.
const SLACK: f64 = 1e-6;

/// How far two branches turn away from the branch below, each to its own side, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ForkAngles {
    /// Between the branch below and the first branch.
    pub alpha1: f32,
    /// Between the branch below and the second branch.
    pub alpha2: f32,
}

impl ForkAngles {
    /// The angle between the two branches, α₁ + α₂.
    #[must_use]
    pub fn sum(&self) -> f32 {
        self.alpha1 + self.alpha2
    }
}

/// Murray's angles: those at which a vessel of radius `r0` parts into `r1` and `r2` with the least
/// volume (Murray 1926; Neubert 2012, Eq. 5.4 to 5.6).
///
/// cos α₁ = (r₀⁴ + r₁⁴ − r₂⁴) / (2 r₀² r₁²), and likewise α₂. That is the law of cosines in the
/// triangle with the sides r₀², r₁², r₂², of which α₁ + α₂ is an outer angle; so Eq. 5.6 follows.
///
/// Of a twig much thinner than r₀ (a thousandth), an f32 r₀ holds no trace, and the twig's angle is
/// lost to rounding: [`pipe_angles`] needs no r₀ and is exact to the last digits for any twig.
///
/// # Errors
/// There is no such triangle, hence no angle, unless √|r₁² − r₂²| ≤ r₀ ≤ √(r₁² + r₂²):
/// [`CoreError::Parameter`](crate::CoreError::Parameter) for `r0` states that range. Limits missed by no more than rounding
/// (one part in a million) count as met. Radii that are not finite and above 0 are refused by
/// name. Angles are not clamped silently; a caller who wants that clamps `r0` to the range.
pub fn murray_angles(r0: f32, r1: f32, r2: f32) -> Result<ForkAngles> {
    for (field, radius) in [("r0", r0), ("r1", r1), ("r2", r2)] {
        check_parameter(field, radius, f32::MIN_POSITIVE, f32::MAX)?;
    }
    // Fourth powers of f32 radii neither vanish nor overflow in f64.
    let square = |radius: f32| f64::from(radius) * f64::from(radius);
    let (s0, s1, s2) = (square(r0), square(r1), square(r2));
    let (min, max) = ((s1 - s2).abs().sqrt(), (s1 + s2).sqrt());
    let found = f64::from(r0);
    if found < min * (1.0 - SLACK) || found > max * (1.0 + SLACK) {
        return Err(ParameterError { field: "r0".into(), found, min, max }.into());
    }
    let angle = |own: f64, other: f64| {
        // a² − b² as a product: no digits are lost where the branches are nearly equal.
        let cosine = (s0 * s0 + (own - other) * (own + other)) / (2.0 * s0 * own);
        libm::acos(cosine.clamp(-1.0, 1.0)) as f32
    };
    Ok(ForkAngles { alpha1: angle(s1, s2), alpha2: angle(s2, s1) })
}

/// Murray's angles where the branch below follows the pipe model, r₀^Δ = r₁^Δ + r₂^Δ.
///
/// With da Vinci's exponent of 2 both angles are 0 and with 3 equal branches part at 74.9°. The
/// thinner branch turns further; a vanishing twig turns by 90° for any exponent above 2.
///
/// # Errors
/// [`CoreError::Parameter`](crate::CoreError::Parameter) for `exponent` unless it is from 2 to 10
/// (below 2, r₀ is too thick for any angle), and for `r1` and `r2` unless they are above 0.
pub fn pipe_angles(exponent: f32, r1: f32, r2: f32) -> Result<ForkAngles> {
    check_parameter("exponent", exponent, 2.0, 10.0)?;
    check_parameter("r1", r1, f32::MIN_POSITIVE, f32::MAX)?;
    check_parameter("r2", r2, f32::MIN_POSITIVE, f32::MAX)?;
    // In units of the thicker branch, so that t, t² and t⁴ are all that is left of the radii.
    let t = f64::from(r1.min(r2)) / f64::from(r1.max(r2));
    let (t2, exponent) = (t * t, f64::from(exponent));
    // r₀² − 1 and not r₀²: the little that a twig adds is all that its angle depends on.
    let added = libm::expm1(2.0 / exponent * libm::log1p(libm::pow(t, exponent)));
    let s0 = 1.0 + added;
    let acos = |cosine: f64| libm::acos(cosine.clamp(-1.0, 1.0)) as f32;
    let thin = acos((added * (s0 + 1.0) / t2 + t2) / (2.0 * s0));
    let thick = acos((s0 * s0 + (1.0 - t2) * (1.0 + t2)) / (2.0 * s0));
    let (alpha1, alpha2) = if r1 < r2 { (thin, thick) } else { (thick, thin) };
    Ok(ForkAngles { alpha1, alpha2 })
}

/// Holton's angles: α₁ = A · S₂/S₀ and α₂ = A − α₁, with S₀ = S₁ + S₂ strands in the branch below
/// (Holton 1994; Neubert 2012, section 5.1). The more strands, the less a branch turns.
///
/// `sum` is A, the angle between the two branches in radians, from 0 to 2π.
///
/// # Errors
/// [`CoreError::Parameter`](crate::CoreError::Parameter) for `sum`, or for `s1` when neither
/// branch has a strand.
pub fn strand_angles(s1: u64, s2: u64, sum: f32) -> Result<ForkAngles> {
    check_parameter("sum", sum, 0.0, std::f32::consts::TAU)?;
    if s1 == 0 && s2 == 0 {
        check_parameter("s1", 0.0, 1.0, u64::MAX as f64)?;
    }
    let (s1, s2, sum) = (s1 as f64, s2 as f64, f64::from(sum));
    let alpha1 = sum * (s2 / (s1 + s2));
    Ok(ForkAngles { alpha1: alpha1 as f32, alpha2: (sum - alpha1) as f32 })
}
