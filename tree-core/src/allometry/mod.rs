//! Allometry: how thick branches are and at which angles they part.
//!
//! The rules are those of Neubert (2012), section 5.1, and of Xu & Mould (2012), section 3.2:
//!
//! * [`PipeModel`]: r₀^Δ = Σ rᵢ^Δ at every fork (da Vinci, Murray, Mandelbrot).
//! * [`TipDistance`]: w = d′^ζ / (level + 1) (Xu & Mould).
//! * [`StrandModel`]: d = t √S for a branch of S strands (Holton 1994).
//! * [`murray_angles`], [`pipe_angles`] and [`strand_angles`]: the angles at which two branches part.
//!
//! [`RadiusRule`] holds any of the three, for parameters that leave the choice open. All rules
//! work in f64 inside and read positions and topology only, never the radii that are there.

mod angles;
mod pipe;
mod strands;
mod tip_distance;

pub use angles::{ForkAngles, murray_angles, pipe_angles, strand_angles};
pub use pipe::PipeModel;
pub use strands::{StrandCount, StrandModel};
pub use tip_distance::TipDistance;

use crate::error::{CoreError, Result};
use crate::skeleton::Skeleton;
use glam::Vec3;

/// Smallest radius or strand diameter a parameter may ask for, in metres: a micrometre, a tenth
/// of a plant cell.
const MIN_RADIUS: f32 = 1e-6;

/// Largest radius a parameter may ask for, in metres: ten times the thickest trunk on record.
const MAX_RADIUS: f32 = 100.0;

/// How the radii of a whole skeleton are found.
///
/// ```
/// use tree_core::{Skeleton, allometry::{PipeModel, RadiusRule}, glam::Vec3};
/// let mut builder = Skeleton::builder(Vec3::ZERO, 0.0)?;
/// let fork = builder.add(0, Vec3::Y, 0.0)?;
/// builder.add(fork, Vec3::new(0.5, 2.0, 0.0), 0.0)?;
/// builder.add(fork, Vec3::new(-0.5, 2.0, 0.0), 0.0)?;
/// let mut skeleton = builder.finish();
/// let rule = RadiusRule::Pipe(PipeModel { trunk_radius: Some(0.2), ..Default::default() });
/// rule.apply(&mut skeleton)?;
/// assert_eq!(skeleton.radii()[0], 0.2);
/// # Ok::<(), tree_core::CoreError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum RadiusRule {
    /// The pipe model, the rule for most trees.
    Pipe(PipeModel),
    /// By distance to the tip, as Xu & Mould do; levels are Gravelius orders.
    TipDistance(TipDistance),
    /// By counting strands, as Holton does.
    Strands(StrandModel),
}

impl Default for RadiusRule {
    fn default() -> Self {
        Self::Pipe(PipeModel::default())
    }
}

impl RadiusRule {
    /// Checks the parameters of the rule inside.
    ///
    /// # Errors
    /// [`CoreError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        match self {
            Self::Pipe(rule) => rule.validate(),
            Self::TipDistance(rule) => rule.validate(),
            Self::Strands(rule) => rule.validate(),
        }
    }

    /// The radius of every node in metres.
    ///
    /// # Errors
    /// As the rule inside: [`PipeModel::radii`], [`TipDistance::radii`], [`StrandModel::radii`].
    pub fn radii(&self, skeleton: &Skeleton) -> Result<Vec<f32>> {
        match self {
            Self::Pipe(rule) => rule.radii(skeleton),
            Self::TipDistance(rule) => rule.radii(skeleton),
            Self::Strands(rule) => rule.radii(skeleton),
        }
    }

    /// Replaces all radii of `skeleton`.
    ///
    /// # Errors
    /// As [`RadiusRule::radii`]; the skeleton is unchanged then.
    pub fn apply(&self, skeleton: &mut Skeleton) -> Result<()> {
        skeleton.set_radii(self.radii(skeleton)?)
    }
}

/// Length of the segment below `node` in metres, 0 for the root. In f64, so that it is finite for
/// any two finite positions.
fn segment_length(skeleton: &Skeleton, node: usize) -> f64 {
    let positions = skeleton.positions();
    match skeleton.parent(node as u32) {
        Some(parent) => distance(positions[parent as usize], positions[node]),
        None => 0.0,
    }
}

fn distance(from: Vec3, to: Vec3) -> f64 {
    let along = |from: f32, to: f32| f64::from(to) - f64::from(from);
    let (x, y, z) = (along(from.x, to.x), along(from.y, to.y), along(from.z, to.z));
    (x * x + y * y + z * z).sqrt()
}

/// The unit vector between two points; `None` where they are one.
fn direction(from: Vec3, to: Vec3) -> Option<Vec3> {
    let length = distance(from, to);
    // In f64 for the same reason as the length; a unit vector fits an f32.
    let along = |from: f32, to: f32| ((f64::from(to) - f64::from(from)) / length) as f32;
    (length > 0.0).then(|| Vec3::new(along(from.x, to.x), along(from.y, to.y), along(from.z, to.z)))
}

/// Radii in the precision that skeletons store.
///
/// # Errors
/// [`CoreError::OutOfRange`] that names the first node whose radius does not fit.
fn narrow(radii: impl Iterator<Item = f64>) -> Result<Vec<f32>> {
    radii
        .enumerate()
        .map(|(index, found)| {
            let radius = found as f32;
            if radius.is_finite() {
                Ok(radius)
            } else {
                Err(CoreError::OutOfRange {
                    field: "radii",
                    index,
                    found,
                    min: 0.0,
                    max: f64::from(f32::MAX),
                })
            }
        })
        .collect()
}

#[cfg(test)]
mod angles_tests;
#[cfg(test)]
mod tests;
