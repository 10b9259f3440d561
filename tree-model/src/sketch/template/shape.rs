//! The branching shape of a tree in the plane: length ratios and angles of segments and their parents (Neubert 2012,
//! section 4.8).
//!
//! 1. Branches are cut into segments from fork to fork.
//! 2. At each fork the child that bends least is taken for apical, all others for lateral, as in the thesis.
//! 3. Length ratios (their logarithms, since twice as long is as far as half as long), apical and lateral angles become
//!    normal distributions. Departure: pairs weigh as much as the shorter of both segments is long, since the
//!    direction of a short line is mostly the hand's trembling.
//!
//! O(nodes) time.

use crate::sketch::{Normal, Plan};
use glam::Vec2;
use tree_core::NO_PARENT;

/// Smallest deviation of a distribution: what hands differ by, in radians or logarithms.
const LEAST_DEVIATION: f32 = 0.05;

/// Distributions of length ratio and angles over the forks of a drawing; `None` where it has no such pair.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BranchShape {
    /// Natural logarithm of a segment's length over its parent's.
    pub scale: Option<Normal>,
    /// Angle in radians between the child that bends least and its parent.
    pub alpha: Option<Normal>,
    /// Angle in radians between the other children and their parent.
    pub beta: Option<Normal>,
}

/// Bins of [`Directions`].
pub const DIRECTION_BINS: usize = 12;

/// Which way the branches of a drawing go: the shares of their length that go straight up (the first bin), level, straight
/// down (the last) and between, to either side.
///
/// It tells willows from elms and cedars from oaks, and does not care how lines are joined or how many there are.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Directions(pub [f32; DIRECTION_BINS]);

impl Directions {
    pub(super) fn of(flat: &Flat) -> Self {
        let mut bins = [0.0_f64; DIRECTION_BINS];
        for (node, &parent) in flat.parents.iter().enumerate() {
            let Some(below) = flat.positions.get(parent as usize) else { continue };
            let step = (flat.positions[node] - *below).as_dvec2();
            let angle = libm::atan2(step.x.abs(), step.y) / std::f64::consts::PI;
            // Between the middles of two bins both have their share.
            let place =
                (angle * DIRECTION_BINS as f64 - 0.5).clamp(0.0, (DIRECTION_BINS - 1) as f64);
            let (low, rest) = (place.floor() as usize, place.fract());
            let high = (low + 1).min(DIRECTION_BINS - 1);
            bins[low] += (1.0 - rest) * step.length();
            bins[high] += rest * step.length();
        }
        let sum = bins.iter().sum::<f64>();
        Self(bins.map(|bin| if sum > 0.0 { (bin / sum) as f32 } else { 0.0 }))
    }

    /// The least turning that makes one of the other, as a share of half a turn (the earth mover's distance), 0 to 1.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f32 {
        let mut ahead = 0.0;
        let mut moved = 0.0;
        for (a, b) in self.0.iter().zip(&other.0) {
            ahead += a - b;
            moved += f32::abs(ahead);
        }
        moved / DIRECTION_BINS as f32
    }
}

/// Branches in the plane: nodes and their parents, parents first, y up.
#[derive(Clone, Debug, Default)]
pub(super) struct Flat {
    pub(super) positions: Vec<Vec2>,
    pub(super) parents: Vec<u32>,
}

impl Flat {
    pub(super) fn of_plan(plan: &Plan) -> Self {
        Self { positions: plan.positions().to_vec(), parents: plan.parents().to_vec() }
    }

    fn child_counts(&self) -> Vec<u32> {
        let mut counts = vec![0; self.positions.len()];
        for &parent in self.parents.iter().filter(|&&parent| parent != NO_PARENT) {
            counts[parent as usize] += 1;
        }
        counts
    }

    /// The nodes above the first fork: all but the root branch. All where there is no fork.
    pub(super) fn above_root_branch(&self) -> Vec<Vec2> {
        let counts = self.child_counts();
        let first_fork = counts.iter().position(|&count| count > 1).unwrap_or(0);
        // Until the first fork there is one node after the other.
        self.positions.get(first_fork..).unwrap_or(&[]).to_vec()
    }
}

/// A segment of the plane.
struct Segment {
    vector: Vec2,
    /// The segment whose end it begins at.
    parent: Option<usize>,
}

impl BranchShape {
    /// The branching shape of branches in the plane.
    pub(super) fn of(flat: &Flat) -> Self {
        let segments = segments(flat);
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); segments.len()];
        for (number, segment) in segments.iter().enumerate() {
            if let Some(parent) = segment.parent {
                children[parent].push(number);
            }
        }
        let (mut scale, mut alpha, mut beta) = Default::default();
        for (parent, children) in segments.iter().zip(&children) {
            let angle = |&child: &usize| parent.vector.angle_to(segments[child].vector).abs();
            let apical = children.iter().copied().min_by(|a, b| angle(a).total_cmp(&angle(b)));
            for &child in children {
                let lengths = [parent.vector.length(), segments[child].vector.length()];
                let weight = lengths[0].min(lengths[1]);
                if weight <= 0.0 {
                    continue;
                }
                add(&mut scale, libm::logf(lengths[1] / lengths[0]), weight);
                let list = if Some(child) == apical { &mut alpha } else { &mut beta };
                add(list, angle(&child), weight);
            }
        }
        Self { scale: normal(&scale), alpha: normal(&alpha), beta: normal(&beta) }
    }
}

fn add(list: &mut Vec<(f32, f32)>, value: f32, weight: f32) {
    if value.is_finite() {
        list.push((value, weight));
    }
}

/// Mean and deviation of (value, weight) pairs.
fn normal(list: &[(f32, f32)]) -> Option<Normal> {
    let sum = |of: &dyn Fn(f64) -> f64| -> f64 {
        list.iter().map(|&(value, weight)| of(value.into()) * f64::from(weight)).sum()
    };
    let weight = sum(&|_| 1.0);
    if weight <= 0.0 {
        return None;
    }
    let mean = sum(&|value| value) / weight;
    let variance = sum(&|value| (value - mean) * (value - mean)) / weight;
    Some(Normal::new(mean as f32, (variance.sqrt() as f32).max(LEAST_DEVIATION)))
}

/// Segments from fork to fork, parents first.
fn segments(flat: &Flat) -> Vec<Segment> {
    let counts = flat.child_counts();
    // For each node the segment that ends at it, and where the segment that runs through it began.
    let mut ending: Vec<Option<usize>> = vec![None; flat.positions.len()];
    let mut begin: Vec<(Option<usize>, usize)> = vec![(None, 0); flat.positions.len()];
    let mut segments = Vec::new();
    for (node, &parent) in flat.parents.iter().enumerate() {
        let Some(&parent_count) = counts.get(parent as usize) else { continue };
        let below = parent as usize;
        let is_new = below == 0 || parent_count != 1;
        begin[node] = if is_new { (ending[below], below) } else { begin[below] };
        if counts[node] != 1 {
            let (parent, from) = begin[node];
            ending[node] = Some(segments.len());
            segments.push(Segment { vector: flat.positions[node] - flat.positions[from], parent });
        }
    }
    segments
}
