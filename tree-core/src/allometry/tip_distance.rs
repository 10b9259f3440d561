//! Xu & Mould's rule: the further from the tip, the thicker; the higher the level, the thinner.
//!
//! w = s · d′^ζ / (level + 1) (Xu & Mould 2012, section 3.2), with d′ the longest path to a tip.
//!
//! Departures: w is taken as the radius and given a unit by the factor s (the paper draws in its
//! own units), and a floor keeps tips, where d′ is 0, from having no thickness at all.

use super::{MAX_RADIUS, MIN_RADIUS, narrow, segment_length};
use crate::error::{CoreError, Result};
use crate::parameter::check_parameter;
use crate::skeleton::{Continuation, Skeleton};

/// Radii by distance to the tip and level.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct TipDistance {
    /// Radius at level 0, one metre from the tip, in metres; from 1e-6 to 100. Default 0.05: the
    /// trunk of a tree of ten metres has 10 cm.
    pub scale: f32,
    /// ζ, from 0 to 10. Default 0.3. The larger, the quicker branches taper.
    pub zeta: f32,
    /// Smallest radius of any node in metres, from 0 to 100. Default 0.001. With 0 a branch ends
    /// in a point, as in the paper.
    pub min_radius: f32,
}

impl Default for TipDistance {
    fn default() -> Self {
        Self { scale: 0.05, zeta: 0.3, min_radius: 0.001 }
    }
}

impl TipDistance {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`CoreError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_parameter("scale", self.scale, MIN_RADIUS, MAX_RADIUS)?;
        check_parameter("zeta", self.zeta, 0.0, 10.0)?;
        Ok(check_parameter("min_radius", self.min_radius, 0.0, MAX_RADIUS)?)
    }

    /// The radius of every node in metres, with Gravelius orders as levels: 0 for the trunk.
    ///
    /// At a fork the child with the longest way to a tip continues the axis, so that the result
    /// does not depend on the radii that are there. No radius is larger than its parent's.
    ///
    /// # Errors
    /// As [`TipDistance::validate`]; [`CoreError::OutOfRange`] for `radii` when a skeleton is so
    /// huge that a radius does not fit an f32.
    ///
    /// # Complexity
    /// O(nodes).
    pub fn radii(&self, skeleton: &Skeleton) -> Result<Vec<f32>> {
        self.validate()?;
        let axes = skeleton.axes(Continuation::Longest);
        let orders = axes.orders();
        let levels = axes.axis_of().iter().map(|&axis| orders[axis as usize]);
        self.radii_of(skeleton, levels)
    }

    /// The radius of every node in metres; `levels` holds the level of each node, which a modeler
    /// that works level by level knows better than the Gravelius order tells.
    ///
    /// # Errors
    /// As [`TipDistance::radii`]; [`CoreError::Length`] when `levels` has not one row a node.
    ///
    /// # Complexity
    /// O(nodes), two passes, 8 bytes a node.
    pub fn radii_at_levels(&self, skeleton: &Skeleton, levels: &[u32]) -> Result<Vec<f32>> {
        self.validate()?;
        if levels.len() != skeleton.len() {
            return Err(CoreError::Length {
                field: "levels",
                found: levels.len(),
                expected: skeleton.len(),
            });
        }
        self.radii_of(skeleton, levels.iter().copied())
    }

    /// Replaces all radii of `skeleton`, with Gravelius orders as levels.
    ///
    /// # Errors
    /// As [`TipDistance::radii`]; the skeleton is unchanged then.
    pub fn apply(&self, skeleton: &mut Skeleton) -> Result<()> {
        skeleton.set_radii(self.radii(skeleton)?)
    }

    /// Replaces all radii of `skeleton`, with the level of each node given.
    ///
    /// # Errors
    /// As [`TipDistance::radii_at_levels`]; the skeleton is unchanged then.
    pub fn apply_at_levels(&self, skeleton: &mut Skeleton, levels: &[u32]) -> Result<()> {
        skeleton.set_radii(self.radii_at_levels(skeleton, levels)?)
    }

    fn radii_of(&self, skeleton: &Skeleton, levels: impl Iterator<Item = u32>) -> Result<Vec<f32>> {
        let scale = f64::from(self.scale);
        let zeta = f64::from(self.zeta);
        let floor = f64::from(self.min_radius);
        let mut to_tip = vec![0.0_f64; skeleton.len()];
        for node in (1..skeleton.len()).rev() {
            if let Some(parent) = skeleton.parent(node as u32) {
                let through_node = to_tip[node] + segment_length(skeleton, node);
                let slot = &mut to_tip[parent as usize];
                *slot = slot.max(through_node);
            }
        }
        narrow(to_tip.iter().zip(levels).map(|(&distance, level)| {
            let radius = scale * libm::pow(distance, zeta) / (f64::from(level) + 1.0);
            radius.max(floor)
        }))
    }
}
