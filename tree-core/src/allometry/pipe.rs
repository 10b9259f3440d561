//! The pipe model: what a branch carries, the branch below carries too.
//!
//! At every fork r₀^Δ = Σ rᵢ^Δ (Neubert 2012, Eq. 5.1 and section 5.1; Shinozaki et al. 1964).
//!
//! 1. Tips have the tip radius.
//! 2. A segment is thicker at its lower end than at its upper by taper × length.
//! 3. At a fork the lower ends of all children are joined by the equation above.
//! 4. All radii are scaled by one factor if a trunk radius is asked for.
//!
//! Departure: step 2. The equation alone leaves an unbranched shoot a cylinder, which no shoot is.
//! A taper of 0 gives the equation alone.

use super::{MAX_RADIUS, MIN_RADIUS, narrow, segment_length};
use crate::error::Result;
use crate::parameter::check_parameter;
use crate::skeleton::Skeleton;

/// Radii by the pipe model, with taper along unbranched shoots.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct PipeModel {
    /// Δ in r₀^Δ = Σ rᵢ^Δ, from 1 to 10. Default [`PipeModel::MURRAY`]. A larger exponent makes
    /// the trunk thinner for the same tips.
    pub exponent: f32,
    /// Radius of every tip in metres, from 1e-6 to 100. Default 0.002. Only its proportion to
    /// `taper` matters when there is a `trunk_radius`.
    pub tip_radius: f32,
    /// How much the radius grows per metre towards the base, from 0 to 1. Default 0.002: a bare
    /// shoot of one metre is twice as thick at its base as at its tip.
    pub taper: f32,
    /// Radius of the root node in metres, from 1e-6 to 100: all radii are multiplied by the one
    /// factor that makes it so, tips too. Default `None`: the tips decide.
    pub trunk_radius: Option<f32>,
}

impl Default for PipeModel {
    fn default() -> Self {
        Self { exponent: Self::MURRAY, tip_radius: 0.002, taper: 0.002, trunk_radius: None }
    }
}

impl PipeModel {
    /// Leonardo da Vinci: the cross-sections above a fork together are the cross-section below.
    pub const DA_VINCI: f32 = 2.0;
    /// Murray (1927): measured circumferences against the weight they carry.
    pub const MURRAY: f32 = 2.49;
    /// Mandelbrot (1983): 2 + Δ/D, with Δ = 2 for the leaf surface and D = 3 for the crown that it
    /// fills.
    pub const MANDELBROT: f32 = 2.0 + 2.0 / 3.0;

    /// The default with another exponent, for example [`PipeModel::DA_VINCI`].
    #[must_use]
    pub fn with_exponent(exponent: f32) -> Self {
        Self { exponent, ..Self::default() }
    }

    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`CoreError::Parameter`](crate::CoreError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_parameter("exponent", self.exponent, 1.0, 10.0)?;
        check_parameter("tip_radius", self.tip_radius, MIN_RADIUS, MAX_RADIUS)?;
        check_parameter("taper", self.taper, 0.0, 1.0)?;
        if let Some(radius) = self.trunk_radius {
            check_parameter("trunk_radius", radius, MIN_RADIUS, MAX_RADIUS)?;
        }
        Ok(())
    }

    /// The radius of every node in metres; never larger than the radius of its parent.
    ///
    /// # Errors
    /// As [`PipeModel::validate`]; [`CoreError::OutOfRange`](crate::CoreError::OutOfRange) for
    /// `radii` when a skeleton is so huge that a radius does not fit an f32.
    ///
    /// # Complexity
    /// O(nodes), one pass backwards, 32 bytes a node.
    pub fn radii(&self, skeleton: &Skeleton) -> Result<Vec<f32>> {
        self.validate()?;
        // In units of the tip radius: powers of numbers from 1 up cannot vanish.
        let tip_radius = f64::from(self.tip_radius);
        let taper = f64::from(self.taper) / tip_radius;
        let exponent = f64::from(self.exponent);
        let mut joints = vec![Joint::default(); skeleton.len()];
        let mut radii = vec![0.0_f64; skeleton.len()];
        for node in (0..skeleton.len()).rev() {
            radii[node] = joints[node].radius(exponent);
            if let Some(parent) = skeleton.parent(node as u32) {
                let lower_end = radii[node] + taper * segment_length(skeleton, node);
                joints[parent as usize].add(lower_end, exponent);
            }
        }
        let unit = match self.trunk_radius {
            Some(radius) => f64::from(radius) / radii[0],
            None => tip_radius,
        };
        narrow(radii.iter().map(|radius| radius * unit))
    }

    /// Replaces all radii of `skeleton`.
    ///
    /// # Errors
    /// As [`PipeModel::radii`]; the skeleton is unchanged then.
    pub fn apply(&self, skeleton: &mut Skeleton) -> Result<()> {
        skeleton.set_radii(self.radii(skeleton)?)
    }
}

/// What meets at a node from above.
#[derive(Clone, Copy, Debug, Default)]
struct Joint {
    n_children: u32,
    thickest: f64,
    /// Sum of the children's radii to the exponent; not kept up for a single child.
    sum: f64,
}

impl Joint {
    fn add(&mut self, radius: f64, exponent: f64) {
        // A chain of nodes costs no power this way, and gathers none of their rounding errors.
        self.sum = match self.n_children {
            0 => 0.0,
            1 => libm::pow(self.thickest, exponent) + libm::pow(radius, exponent),
            _ => self.sum + libm::pow(radius, exponent),
        };
        self.thickest = self.thickest.max(radius);
        self.n_children += 1;
    }

    fn radius(&self, exponent: f64) -> f64 {
        match self.n_children {
            0 => 1.0,
            1 => self.thickest,
            // A twig on a trunk may add less than the power and the root round away.
            _ => libm::pow(self.sum, 1.0 / exponent).max(self.thickest),
        }
    }
}
