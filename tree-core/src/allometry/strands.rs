//! Holton's strands: a tree is a bundle of fibres that run from the base to the tips and part at
//! forks, but never end or begin on the way (Holton 1994; Neubert 2012, section 5.1).
//!
//! 1. Count the strands through every node: one for each tip above it, or a given number at the
//!    base, shared out at every fork by α₁ = A · S₂/S₀, solved for the strands.
//! 2. A branch of S strands has the diameter t √S.
//!
//! Departures: the rule is written for two children, S₁ : S₂ = α₂ : α₁. We read it as Sₖ ∝ 1/αₖ,
//! which is the same for two and holds for any number. Strands are whole, and every tip needs one;
//! so a child never gets fewer strands than it has tips above.

use super::{MAX_RADIUS, MIN_RADIUS, direction, narrow};
use crate::error::Result;
use crate::parameter::{ParameterError, check_parameter};
use crate::skeleton::{Children, Skeleton};
use glam::Vec3;

/// Most strands at the base: beyond 2⁵³ an f64 does not hold every whole number.
const MAX_STRANDS: u64 = 1 << 53;

/// Angle in radians under which a child counts as straight on. Without it a child at angle 0
/// would take every strand, and two such children could not share.
const STRAIGHT: f32 = 0.01;

/// Where the number of strands comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StrandCount {
    /// One strand for each tip.
    #[default]
    PerTip,
    /// A number at the base, shared out at forks by the branching angles: the less a child turns
    /// away, the more it gets.
    ByAngle {
        /// Strands at the base, from the number of tips to 2⁵³.
        base: u64,
    },
}

/// Radii by counting strands.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct StrandModel {
    /// t in d = t √S: the diameter of a branch of one strand in metres, from 1e-6 to 100. Default
    /// 0.004.
    pub strand_diameter: f32,
    /// Where the number of strands comes from. Default one for each tip, which makes the rule da
    /// Vinci's.
    pub count: StrandCount,
}

impl Default for StrandModel {
    fn default() -> Self {
        Self { strand_diameter: 0.004, count: StrandCount::PerTip }
    }
}

impl StrandModel {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`CoreError::Parameter`](crate::CoreError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_parameter("strand_diameter", self.strand_diameter, MIN_RADIUS, MAX_RADIUS)?;
        match self.count {
            StrandCount::PerTip => Ok(()),
            StrandCount::ByAngle { base } => check_base(base, 1),
        }
    }

    /// The number of strands through every node. At every fork the children's numbers add up to
    /// the parent's; the way up, no strand is lost.
    ///
    /// The angle of a child is that between its segment and the segment below the fork (the
    /// nearest one that has a length; straight up below the root). A child whose segment has no
    /// length gets the mean share.
    ///
    /// # Errors
    /// As [`StrandModel::validate`]; [`CoreError::Parameter`](crate::CoreError::Parameter) when `base` is less than the number
    /// of tips.
    ///
    /// # Complexity
    /// O(nodes), plus O(k log k) for a fork of k children when sharing out by angle.
    pub fn strands(&self, skeleton: &Skeleton) -> Result<Vec<u64>> {
        self.validate()?;
        let tips: Vec<u64> = skeleton.tip_counts().into_iter().map(u64::from).collect();
        match self.count {
            StrandCount::PerTip => Ok(tips),
            StrandCount::ByAngle { base } => {
                check_base(base, tips[0])?;
                Ok(share_by_angle(skeleton, &tips, base))
            }
        }
    }

    /// The radius of every node in metres; never larger than the radius of its parent.
    ///
    /// # Errors
    /// As [`StrandModel::strands`].
    ///
    /// # Complexity
    /// As [`StrandModel::strands`].
    pub fn radii(&self, skeleton: &Skeleton) -> Result<Vec<f32>> {
        let unit = f64::from(self.strand_diameter) / 2.0;
        let strands = self.strands(skeleton)?;
        narrow(strands.iter().map(|&count| unit * (count as f64).sqrt()))
    }

    /// Replaces all radii of `skeleton`.
    ///
    /// # Errors
    /// As [`StrandModel::radii`]; the skeleton is unchanged then.
    pub fn apply(&self, skeleton: &mut Skeleton) -> Result<()> {
        skeleton.set_radii(self.radii(skeleton)?)
    }
}

fn check_base(base: u64, min: u64) -> Result<()> {
    if (min..=MAX_STRANDS).contains(&base) {
        return Ok(());
    }
    let (found, min, max) = (base as f64, min as f64, MAX_STRANDS as f64);
    Err(ParameterError { field: "count.base".into(), found, min, max }.into())
}

/// One child at a fork.
#[derive(Clone, Copy, Debug)]
struct Heir {
    node: u32,
    /// Strands it needs at least.
    tips: u64,
    /// 1/α; not finite while unknown.
    weight: f64,
}

fn share_by_angle(skeleton: &Skeleton, tips: &[u64], base: u64) -> Vec<u64> {
    let positions = skeleton.positions();
    let children = skeleton.children();
    let directions = directions(skeleton);
    let mut strands = tips.to_vec();
    strands[0] = base;
    let mut heirs = Vec::new();
    for node in 0..skeleton.len() {
        heirs.clear();
        gather(positions, &children, directions[node], tips, node, &mut heirs);
        share(&mut heirs, strands[node], &mut strands);
    }
    strands
}

/// The direction in which the tree arrives at each node: that of its segment, or of the nearest
/// segment below that has a length; up at the root.
fn directions(skeleton: &Skeleton) -> Vec<Vec3> {
    let positions = skeleton.positions();
    let mut directions = vec![Vec3::Y; skeleton.len()];
    for (parent, node) in skeleton.segments() {
        let (parent, node) = (parent as usize, node as usize);
        directions[node] =
            direction(positions[parent], positions[node]).unwrap_or(directions[parent]);
    }
    directions
}

fn gather(
    positions: &[Vec3],
    children: &Children,
    below: Vec3,
    tips: &[u64],
    fork: usize,
    heirs: &mut Vec<Heir>,
) {
    let (mut total, mut n_known) = (0.0, 0_u32);
    for &node in children.of(fork as u32) {
        let weight = match direction(positions[fork], positions[node as usize]) {
            Some(above) => {
                let angle = libm::atan2f(below.cross(above).length(), below.dot(above));
                let weight = 1.0 / f64::from(angle.max(STRAIGHT));
                total += weight;
                n_known += 1;
                weight
            }
            None => f64::INFINITY,
        };
        heirs.push(Heir { node, tips: tips[node as usize], weight });
    }
    let mean = if n_known > 0 { total / f64::from(n_known) } else { 1.0 };
    for heir in heirs.iter_mut().filter(|heir| heir.weight.is_infinite()) {
        heir.weight = mean;
    }
}

/// Gives each heir its share of what is left, those first that need most for their weight: they
/// get what they need where their share is less, and the others part what remains.
fn share(heirs: &mut [Heir], strands_below: u64, strands: &mut [u64]) {
    let need = |heir: &Heir| heir.tips as f64 / heir.weight;
    heirs.sort_by(|a, b| need(b).total_cmp(&need(a)).then(a.node.cmp(&b.node)));
    let mut left = strands_below;
    let mut weight_left: f64 = heirs.iter().map(|heir| heir.weight).sum();
    let mut tips_left: u64 = heirs.iter().map(|heir| heir.tips).sum();
    let n_heirs = heirs.len();
    for (i, heir) in heirs.iter().enumerate() {
        tips_left -= heir.tips;
        let most = left.saturating_sub(tips_left);
        let share = (left as f64 * (heir.weight / weight_left) + 0.5) as u64;
        let given = if i + 1 == n_heirs { left } else { share.max(heir.tips).min(most) };
        strands[heir.node as usize] = given;
        left -= given;
        weight_left -= heir.weight;
    }
}
