//! Collision capsules: few, and with nearly all of the thick wood inside.
//!
//! 1. Segments whose wood is thicker than a radius are gathered as frusta, with the axis they lie on
//!    (`wood`). Runs of them along an axis are cut into links, short where an axis bends.
//! 2. Links that touch (along an axis, or at a fork) are merged two at a time, always those whose common
//!    capsule adds least volume, for as long as it is tight (`merge`). A capsule is fitted so that all
//!    its wood lies inside (`fit`).
//! 3. The capsules with least wood are left out, for as long as the share asked for remains, and the
//!    others merged down to the number allowed. So however few are allowed, the share holds; what
//!    suffers is how tight they are, and the report says how tight: thinner wood needs more of them.
//! 4. The share is then measured, by points spread through the wood (`measure`).
//!
//! Cost: O(segments + links · (log links + forks)) time, at most 512 links; measuring: segments ×
//! capsules.

mod fit;
mod measure;
mod merge;
mod wood;

use crate::error::Result;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use tree_core::{Continuation, Control, Skeleton, check_parameter};

/// A cylinder with round ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Capsule {
    /// Middle of one end, in metres.
    pub a: Vec3,
    /// Middle of the other end.
    pub b: Vec3,
    /// Radius in metres.
    pub radius: f32,
}

impl Capsule {
    /// Whether a point lies inside or on the border.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        self.distance_to_core(point) <= self.radius
    }

    /// Volume in cubic metres.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let (r, l) = (f64::from(self.radius), f64::from(self.a.distance(self.b)));
        std::f64::consts::PI * r * r * (l + 4.0 / 3.0 * r)
    }

    /// Distance of a point from the segment between the middles of the ends.
    fn distance_to_core(&self, point: Vec3) -> f32 {
        let along = self.b - self.a;
        let square = along.length_squared();
        let t =
            if square > 0.0 { ((point - self.a).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (self.a + along * t).distance(point)
    }
}

/// How capsules are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CapsuleParams {
    /// Most capsules, 1 to 4096. Default 32.
    pub max_count: u32,
    /// Wood thinner than this is passed over, in metres, 0 to 10. Default 0.05. Of the path presets 32
    /// capsules have 1.4 to 3.4 times the volume of the wood above 5 cm (the broad oak 6.5), but up to
    /// 47 times that above 3 cm: boughs by the dozen must share them. When nothing is as thick, half the radius of the thickest wood is taken instead, so that saplings collide as well.
    pub min_radius: f32,
    /// Share of the volume of the other wood that must lie inside, 0 to 1. Default 0.95.
    pub share: f32,
    /// Which child goes on at a fork; as in [`MeshParams`](crate::MeshParams).
    pub continuation: Continuation,
}

impl Default for CapsuleParams {
    fn default() -> Self {
        Self { max_count: 32, min_radius: 0.05, share: 0.95, continuation: Continuation::default() }
    }
}

impl CapsuleParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the first field at fault and its range.
    pub fn validate(&self) -> Result<()> {
        for (field, found, min, max) in [
            ("max_count", f64::from(self.max_count), 1.0, 4096.0),
            ("min_radius", f64::from(self.min_radius), 0.0, 10.0),
            ("share", f64::from(self.share), 0.0, 1.0),
        ] {
            check_parameter(field, found, min, max)?;
        }
        Ok(())
    }
}

/// Capsules and how well they fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Capsules {
    /// The capsules; empty for a tree without any wood.
    pub capsules: Vec<Capsule>,
    /// How well they fit.
    pub report: CapsuleReport,
}

/// How well capsules fit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CapsuleReport {
    /// Volume of the wood above the radius, in cubic metres: the sum of its frusta.
    pub volume: f64,
    /// The radius above which wood counted, in metres.
    pub min_radius: f32,
    /// Share of that volume that lies in a capsule, 0 to 1, as measured; 1 when there is no wood.
    pub held: f64,
    /// Volume of the capsules, those that overlap counted twice, over that of the wood they hold; 1
    /// would be perfect. 0 when there is no wood.
    pub bulk: f64,
    /// Whether `held` reaches the share asked for.
    pub is_enough: bool,
}

/// Makes capsules of a tree's thick wood.
///
/// # Errors
/// [`MeshError::Parameter`](crate::MeshError::Parameter) or [`MeshError::Cancelled`](crate::MeshError::Cancelled).
///
/// # Complexity
/// About linear in the number of thick segments; see the [module](self).
pub fn capsules(
    skeleton: &Skeleton,
    params: &CapsuleParams,
    control: &Control,
) -> Result<Capsules> {
    params.validate()?;
    control.report("wood", 0.0)?;
    let (wood, min_radius) = wood::gather(skeleton, params);
    if wood.frusta.is_empty() {
        let report = CapsuleReport { min_radius, held: 1.0, is_enough: true, ..Default::default() };
        return Ok(Capsules { capsules: Vec::new(), report });
    }
    control.report("capsules", 0.1)?;
    let (links, budget) = (wood.links(), wood.budget(params.share));
    let capsules = merge::down_to(&wood, &links, params.max_count as usize, budget, control)?;
    control.report("measure", 0.8)?;
    let held = measure::held(&wood.frusta, &capsules, control)?;
    let volume = wood.volume();
    let bulk =
        capsules.iter().map(Capsule::volume).sum::<f64>() / (volume * held).max(f64::MIN_POSITIVE);
    let is_enough = held >= f64::from(params.share);
    let report = CapsuleReport { volume, min_radius, held, bulk, is_enough };
    Ok(Capsules { capsules, report })
}

#[cfg(test)]
mod tests;
