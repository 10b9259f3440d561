//! What the segments of a tree show of Ω: one row for each segment and its parent.

use super::branches::{Branches, Label};
use super::frame::{across, angle, carried, roll, wrapped};
use glam::DVec3;
use std::f64::consts::TAU;
use tree_core::NO_PARENT;

/// How a segment lies to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relation {
    /// The segment.
    pub segment: u32,
    /// Its label.
    pub label: Label,
    /// Gravelius order of its parent's axis: the order whose [`Habit`](super::Habit) it follows.
    pub order: u32,
    /// Natural logarithm of its length over its parent's.
    pub scale: f64,
    /// Angle to its parent in radians: α of an apical segment, β of a lateral.
    pub divergence: f64,
    /// For a lateral, the turn about the axis from the last lateral's side, less what its place in the fork's whorl
    /// gives, −π..π; `None` for apical segments and for the first lateral of an axis.
    pub roll: Option<f64>,
}

impl Branches {
    /// All relations, in the order of segments. Segments without length, and those of an imagined root, have none.
    ///
    /// # Complexity
    /// O(segments).
    #[must_use]
    pub fn relations(&self) -> Vec<Relation> {
        let orders = self.orders();
        let vector = |segment: usize| self.vector(segment).as_dvec3();
        let mut sides: Vec<Option<DVec3>> = vec![None; self.len()];
        let mut out = Vec::with_capacity(self.len());
        for (parent, children) in self.forks() {
            let along = vector(parent);
            let length = along.length();
            if length <= 0.0 {
                continue;
            }
            let axis = along / length;
            let n_laterals =
                children.iter().filter(|&&c| self.labels[c as usize] != Label::Apical).count();
            let first = children.iter().find(|&&c| self.labels[c as usize] == Label::Lateral(0));
            let fork_side = first.and_then(|&c| across(vector(c as usize), axis));
            for &child in &children {
                let (c, label) = (child as usize, self.labels[child as usize]);
                let v = vector(c);
                if let (Label::Apical, Some(side)) = (label, fork_side.or(sides[parent])) {
                    sides[c] = Some(carried(side, axis, v.normalize_or(axis)));
                }
                if v.length() <= 0.0 || (self.imagined_root && parent == 0) {
                    continue;
                }
                let turned = match (label, sides[parent]) {
                    (Label::Lateral(place), Some(side)) => {
                        let share = f64::from(place) / n_laterals as f64;
                        Some(wrapped(roll(axis, side, v) - TAU * share))
                    }
                    _ => None,
                };
                out.push(Relation {
                    segment: child,
                    label,
                    order: orders[parent],
                    scale: libm::log(v.length() / length),
                    divergence: angle(along, v),
                    roll: turned,
                });
            }
        }
        out.sort_by_key(|relation| relation.segment);
        out
    }

    /// Every segment that has children, with them, parents first.
    pub(super) fn forks(&self) -> Vec<(usize, Vec<u32>)> {
        let mut children: Vec<Vec<u32>> = vec![Vec::new(); self.len()];
        for (segment, &parent) in self.parents.iter().enumerate() {
            if parent != NO_PARENT {
                children[parent as usize].push(segment as u32);
            }
        }
        children.into_iter().enumerate().filter(|(_, list)| !list.is_empty()).collect()
    }
}
