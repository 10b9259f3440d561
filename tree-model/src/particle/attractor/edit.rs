//! Editing a graph by hand: moving a part of it, erasing under a path.

use super::AttractorGraph;
use super::builder::Builder;
use super::graph::nearest_on;
use crate::error::{ModelError, Result, check};
use glam::Vec2;
use tree_core::NO_PARENT;

/// What happens to what erasing cuts off from the base.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CutOff {
    /// It goes too.
    #[default]
    Drop,
    /// It is joined to the nearest point of the rest by a straight line.
    Reconnect,
}

/// What erasing did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EraseReport {
    /// Segments under the eraser.
    pub n_erased: u32,
    /// Segments that went because they were cut off.
    pub n_dropped: u32,
    /// Parts that were cut off and joined again.
    pub n_reconnected: u32,
}

impl AttractorGraph {
    /// This graph with everything within `radius` of `at` moved by `by`, less the farther it is. Roots
    /// stay where they are.
    ///
    /// # Errors
    /// [`ModelError::NotFinite`] for a vector, [`ModelError::Parameter`] for a radius below 0 or over 1e9.
    pub fn move_near(&self, at: Vec2, by: Vec2, radius: f32) -> Result<Self> {
        check_point("at", at)?;
        check_point("by", by)?;
        check("radius", radius, 0.0_f32, 1e9_f32)?;
        let moved = |(&node, &parent): (&Vec2, &u32)| {
            let share = node.distance(at) / radius.max(1e-9);
            if parent == NO_PARENT || share >= 1.0 {
                return node;
            }
            // Falls off to nothing with a flat foot, so that no kink is left.
            let fall = 1.0 - share * share;
            node + fall * fall * by
        };
        let nodes = self.nodes().iter().zip(self.parents()).map(moved).collect();
        Self::new(nodes, self.parents().to_vec())
    }

    /// This graph without the segments that come within `radius` of the polyline `path` (a single point
    /// is a dab). Points of it that are not finite are left out. Roots stay.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for a radius below 0 or over 1e9.
    pub fn erase(
        &self,
        path: &[Vec2],
        radius: f32,
        cut_off: CutOff,
    ) -> Result<(Self, EraseReport)> {
        check("radius", radius, 0.0_f32, 1e9_f32)?;
        let path: Vec<Vec2> = path.iter().copied().filter(|point| point.is_finite()).collect();
        let under = |a: Vec2, b: Vec2| {
            let dab = path.len() == 1 && nearest_on(a, b, path[0]).1.distance(path[0]) <= radius;
            dab || path.windows(2).any(|pair| apart(a, b, pair[0], pair[1]) <= radius)
        };
        let mut report = EraseReport::default();
        let n = self.nodes().len();
        let mut builder = Builder::from_graph(self);
        // For each node: 0 leads to a root; otherwise the part it belongs to, which is cut off.
        let mut part = vec![0_u32; n];
        let mut heads = Vec::new();
        for node in 0..n {
            let parent = self.parents()[node];
            if parent == NO_PARENT {
                continue;
            }
            if under(self.nodes()[parent as usize], self.nodes()[node]) {
                report.n_erased += 1;
                heads.push(node);
                part[node] = heads.len() as u32;
                builder.parents[node] = NO_PARENT;
            } else {
                part[node] = part[parent as usize];
            }
        }
        let mut bears = vec![false; n];
        for node in 0..n {
            if builder.parents[node] != NO_PARENT {
                bears[builder.parents[node] as usize] = true;
            }
        }
        // Parts of a single node have nothing left.
        let mut gone: Vec<bool> = vec![true; heads.len() + 1];
        gone[0] = false;
        if cut_off == CutOff::Reconnect {
            for (i, &head) in heads.iter().enumerate() {
                let may = |node: usize| {
                    let part = part.get(node).copied().unwrap_or(0);
                    !gone[part as usize]
                };
                if !bears[head] {
                    continue;
                }
                if let Some(place) = builder.nearest(builder.nodes[head], may) {
                    let link = builder.split(place);
                    builder.parents[head] = link;
                    gone[i + 1] = false;
                    report.n_reconnected += 1;
                }
            }
        }
        for node in 0..n {
            if gone[part[node] as usize] {
                report.n_dropped += u32::from(builder.parents[node] != NO_PARENT);
                // A node that leads to itself leads to no root, and is left out with all above it.
                builder.parents[node] = node as u32;
            }
        }
        Ok((builder.finish()?, report))
    }
}

fn check_point(field: &str, point: Vec2) -> Result<()> {
    if point.is_finite() { Ok(()) } else { Err(ModelError::NotFinite { field: field.to_string() }) }
}

/// Distance between two segments; 0 where they cross.
fn apart(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> f32 {
    let side = |p: Vec2, q: Vec2, r: Vec2| (q - p).perp_dot(r - p);
    let cross = side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
    if cross {
        return 0.0;
    }
    let to = |p: Vec2, q: Vec2, r: Vec2| nearest_on(p, q, r).1.distance(r);
    to(a, b, c).min(to(a, b, d)).min(to(c, d, a)).min(to(c, d, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trunk in steps of 10 from y = 100 up to y = 0, a branch from its middle.
    fn graph() -> AttractorGraph {
        let mut nodes: Vec<Vec2> =
            (0..=10).map(|i| Vec2::new(50.0, 100.0 - 10.0 * i as f32)).collect();
        let mut parents: Vec<u32> = vec![NO_PARENT];
        parents.extend(0..10);
        nodes.extend([Vec2::new(60.0, 45.0), Vec2::new(70.0, 40.0)]);
        parents.extend([5, 11]);
        AttractorGraph::new(nodes, parents).unwrap()
    }

    #[test]
    fn erasing_across_the_trunk_drops_what_is_above() {
        let path = [Vec2::new(40.0, 25.0), Vec2::new(60.0, 25.0)];
        let (rest, report) = graph().erase(&path, 1.0, CutOff::Drop).unwrap();
        assert_eq!((report.n_erased, report.n_dropped), (1, 2));
        assert_eq!(rest.length(), graph().length() - 30.0);
    }

    #[test]
    fn what_is_cut_off_can_be_reconnected() {
        let dab = [Vec2::new(50.0, 25.0)];
        let (rest, report) = graph().erase(&dab, 1.0, CutOff::Reconnect).unwrap();
        assert_eq!((report.n_erased, report.n_dropped, report.n_reconnected), (1, 0, 1));
        assert_eq!(rest.tips().count(), 2);
        assert_eq!(rest.parents().iter().filter(|&&p| p == NO_PARENT).count(), 1);
    }

    #[test]
    fn erasing_everything_leaves_the_root() {
        let (rest, _) = graph().erase(&[Vec2::ZERO], 1e6, CutOff::Reconnect).unwrap();
        assert!(rest.is_empty());
        assert_eq!(rest.nodes(), [Vec2::new(50.0, 100.0)]);
        let (same, report) = graph().erase(&[Vec2::NAN], 1e6, CutOff::Drop).unwrap();
        assert_eq!((same.length(), report), (graph().length(), EraseReport::default()));
    }

    #[test]
    fn moving_takes_along_what_is_near_and_leaves_the_root() {
        let by = Vec2::new(5.0, 0.0);
        let moved = graph().move_near(Vec2::new(50.0, 0.0), by, 35.0).unwrap();
        assert_eq!(moved.nodes()[10], Vec2::new(55.0, 0.0));
        assert_eq!(moved.nodes()[6], graph().nodes()[6]);
        let all = graph().move_near(Vec2::new(50.0, 100.0), by, 1e6).unwrap();
        assert_eq!(all.nodes()[0], graph().nodes()[0]);
        assert!(graph().move_near(Vec2::NAN, by, 1.0).is_err());
        assert!(graph().move_near(by, by, f32::NAN).is_err());
    }
}
