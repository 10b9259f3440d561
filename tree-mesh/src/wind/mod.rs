//! Wind: the branches that vertices move with, in a hierarchy.
//!
//! Every vertex names one [`Branch`] (column `branches` of a surface); everything else an engine
//! packs into its vertices follows from the table, the position and, for leaves, the anchor:
//!
//! * [`Branch::reach`], how far along its branch a point is: 0 at the collar, 1 at the tip;
//! * [`sway`], the share of the branch's turn that a point at this reach makes;
//! * [`VertexWind`], all of it for each vertex of a surface, leaves with flutter and phase.
//!
//! [`bend`] is the reference: what a vertex shader does with these, on the CPU. A branch turns about
//! its pivot, more and more towards its tip, as a clamped beam under an even load does. First its own
//! turn is made, then that of the branch that carries it at the place where it is attached, and so on
//! down to the trunk. Wood within the collar makes no turn of its own: it moves with the parent, and
//! copies of a vertex at a seam, which have position and branch in common, move together bit by bit.

mod bend;
mod stand;
mod weights;

pub use bend::{Wind, bend, bend_surface};
pub(crate) use stand::stand;
pub use weights::{VertexWind, leaf_phase, sway, vertices};

use glam::Vec3;
use tree_core::{Axes, Skeleton};

/// Slenderness (length over radius) at which a branch gives way half as far as one without stiffness.
const SLENDERNESS: f32 = 100.0;
/// The trunk stands still up to this many of its radii above the ground: the root flare.
const FLARE_RADII: f32 = 3.0;
/// Largest share of a branch within its collar: short branches on thick wood still bend.
const COLLAR_MAX: f32 = 0.5;
/// Speed of sound in green wood along the grain, m/s: √(E/ρ) with 8·10⁹ Pa and 900 kg/m³.
const WAVE_SPEED: f32 = 2981.0;

/// A branch as the wind sees it: a rod that turns about its pivot, carried by its parent. 52 bytes, laid
/// out as C does.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Branch {
    /// The branch that carries this one; itself for the trunk. Parents come first.
    pub parent: u32,
    /// 0 for the trunk, one more than the parent otherwise.
    pub level: u32,
    /// Where it is attached: the point it turns about, in metres.
    pub pivot: Vec3,
    /// Unit vector from pivot to tip.
    pub axis: Vec3,
    /// Length along its bends in metres.
    pub length: f32,
    /// Radius at the base in metres.
    pub radius: f32,
    /// Distance from the pivot, in metres, up to which wood moves with the parent.
    pub collar: f32,
    /// Where in the swing it starts, 0 to 1: so that branches do not move in step.
    pub phase: f32,
    /// 1 does not give at all, 0 hangs in the wind.
    ///
    /// The wind turns a branch by the moment on it over its stiffness, `EI / length`. The moment
    /// grows with the area it meets, 2 · radius · length, and the lever, half the length; `I` grows
    /// with radius⁴. So the turn grows with slenderness³, and stiffness is
    /// 1 / (1 + (length / radius / 100)³).
    pub stiffness: f32,
}

impl Branch {
    /// How far along the branch a point lies: 0 up to the collar, 1 at the tip and beyond.
    #[must_use]
    pub fn reach(&self, point: Vec3) -> f32 {
        let free = self.length - self.collar;
        if free > 0.0 {
            ((point.distance(self.pivot) - self.collar) / free).clamp(0.0, 1.0)
        } else {
            0.0
        }
    }

    /// Share of the wind's full turn that this branch makes, 0 to 1.
    #[must_use]
    pub fn give(&self) -> f32 {
        1.0 - self.stiffness
    }

    /// The direction it swings in: a unit vector square to the axis, another one for each phase.
    #[must_use]
    pub fn swing(&self) -> Vec3 {
        let across = self.axis.try_normalize().unwrap_or(Vec3::Y).any_orthonormal_vector();
        let (sin, cos) = libm::sincosf(self.phase * std::f32::consts::TAU);
        (across * cos + self.axis.cross(across) * sin).normalize_or(across)
    }

    /// Its lowest natural frequency in hertz, as a bare, clamped, uniform rod of green wood:
    /// 0.28 √(E/ρ) radius / length² (Euler and Bernoulli's beam). Leaves make it slower, taper faster.
    #[must_use]
    pub fn frequency(&self) -> f32 {
        if self.length > 0.0 {
            0.28 * WAVE_SPEED * self.radius / (self.length * self.length)
        } else {
            f32::INFINITY
        }
    }
}

/// One branch for each axis of the skeleton, in the same order, turning about its fork. Those of a
/// built mesh turn about the places where their bark stands.
///
/// # Complexity
/// O(nodes).
#[must_use]
pub fn branches(skeleton: &Skeleton, axes: &Axes) -> Vec<Branch> {
    branches_of_lines(skeleton, axes.iter().map(|axis| axis.nodes))
}

/// As [`branches`], for any lines that the nodes are cut into: each goes from child to child, and comes after the
/// line that bears it. Nodes that do not exist are passed over; what is on no line counts as the first one's.
///
/// # Complexity
/// O(nodes).
#[must_use]
pub fn branches_of_lines<'a>(
    skeleton: &Skeleton,
    lines: impl IntoIterator<Item = &'a [u32]>,
) -> Vec<Branch> {
    let mut line_of = vec![0; skeleton.len()];
    let mut branches: Vec<Branch> = Vec::new();
    for (number, nodes) in (0..).zip(lines) {
        for &node in nodes {
            if let Some(place) = line_of.get_mut(node as usize) {
                *place = number;
            }
        }
        let first = nodes.first().copied().unwrap_or(0);
        let fork = skeleton.parent(first).unwrap_or(first);
        let parent = if number == 0 { 0 } else { line_of.get(fork as usize).copied().unwrap_or(0) };
        let level = branches.get(parent as usize).map_or(0, |below| below.level + 1);
        branches.push(Branch { parent, level, ..branch(skeleton, number, nodes, fork) });
    }
    branches
}

/// What a line is by itself, without what carries it.
fn branch(skeleton: &Skeleton, number: u32, nodes: &[u32], fork: u32) -> Branch {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let thick = |node: u32| radii.get(node as usize).copied().unwrap_or_default();
    let pivot = positions.get(fork as usize).copied().unwrap_or_default();
    let (mut last, mut length) = (pivot, 0.0);
    for &at in nodes.iter().filter_map(|&node| positions.get(node as usize)) {
        length += at.distance(last);
        last = at;
    }
    let radius = thick(nodes.first().copied().unwrap_or(fork));
    // A ring of the branch's radius, where its axis leaves a ball as thick as the parent.
    let collar = if number == 0 {
        FLARE_RADII * radius
    } else {
        glam::Vec2::new(thick(fork), radius).length()
    };
    Branch {
        parent: 0,
        level: 0,
        pivot,
        axis: (last - pivot).normalize_or(Vec3::Y),
        length,
        radius,
        collar: collar.min(COLLAR_MAX * length),
        phase: phase(number),
        stiffness: stiffness(length, radius),
    }
}

fn stiffness(length: f32, radius: f32) -> f32 {
    let limp = length / (SLENDERNESS * radius.max(f32::MIN_POSITIVE));
    1.0 / (1.0 + limp * limp * limp)
}

/// The golden ratio's multiples spread evenly over 0 to 1, whatever their number.
fn phase(index: u32) -> f32 {
    // The top 24 bits fill an f32 exactly, so that 1 itself is never reached.
    (index.wrapping_mul(0x9E37_79B9) >> 8) as f32 / 16_777_216.0
}

#[cfg(test)]
mod tests;
