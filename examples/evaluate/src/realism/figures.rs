//! What is measured of one tree.

use super::boxes;
use crate::statistics::{median, quantile};
use tree_core::branching::{Runs, Strahler, lateral_angles, pipe_exponents};
use tree_core::{Continuation, Skeleton};

/// Chords of angles and the height of the trunk's diameter, as shares of the tree's height.
const REACH: f32 = 0.02;
const BREAST: f32 = 0.1;
/// Fewer forks than this are no statistics.
const N_FORKS: usize = 20;

/// The figures of one tree. Those of forks are none where there are fewer than 20.
#[derive(Clone, Debug)]
pub(super) struct Figures {
    pub(super) bifurcation: Option<f64>,
    pub(super) length_ratio: Option<f64>,
    /// Median over forks.
    pub(super) pipe: Option<f64>,
    /// Of laterals, degrees.
    pub(super) angles: Vec<f64>,
    /// Lengths of unbranched runs, in heights of the tree.
    pub(super) internodes: Vec<f64>,
    /// Slope of the counts of boxes that hold wood.
    pub(super) dimension: Option<f64>,
    /// Height to diameter a tenth of the height above the base.
    pub(super) slenderness: Option<f64>,
}

impl Figures {
    pub(super) fn of(skeleton: &Skeleton) -> Self {
        let height = skeleton.bounds().max.y - skeleton.positions()[0].y;
        let strahler = Strahler::of(skeleton);
        let exponents = pipe_exponents(skeleton);
        let runs = Runs::of(skeleton);
        let n_forks = runs.as_slice().iter().filter(|run| !run.is_tip).count();
        let enough = n_forks >= N_FORKS;
        let angles = lateral_angles(skeleton, Continuation::Longest, REACH * height);
        let lengths = runs.as_slice().iter().map(|run| run.length / f64::from(height));
        Self {
            bifurcation: strahler.bifurcation_ratio().filter(|_| enough),
            length_ratio: strahler.length_ratio().filter(|_| enough),
            pipe: (exponents.len() >= N_FORKS).then(|| median(&exponents)),
            angles: if enough {
                angles.iter().map(|lateral| f64::from(lateral.angle).to_degrees()).collect()
            } else {
                Vec::new()
            },
            internodes: if enough {
                lengths.filter(|length| *length > 0.0).collect()
            } else {
                Vec::new()
            },
            dimension: boxes::dimension(skeleton).filter(|_| enough),
            slenderness: slenderness(skeleton, height),
        }
    }

    pub(super) fn angle(&self) -> Option<f64> {
        (!self.angles.is_empty()).then(|| median(&self.angles))
    }

    /// Upper less lower quartile of the angles.
    pub(super) fn angle_spread(&self) -> Option<f64> {
        (!self.angles.is_empty())
            .then(|| quantile(&self.angles, 0.75) - quantile(&self.angles, 0.25))
    }

    /// Median internode, % of the height.
    pub(super) fn internode(&self) -> Option<f64> {
        (!self.internodes.is_empty()).then(|| 100.0 * median(&self.internodes))
    }

    /// Upper quartile of the internodes over the lower.
    pub(super) fn internode_spread(&self) -> Option<f64> {
        let quartile = |share| quantile(&self.internodes, share);
        (!self.internodes.is_empty()).then(|| quartile(0.75) / quartile(0.25))
    }

    /// Internodes over their median: how they are distributed, whatever their size.
    pub(super) fn shape(&self) -> Vec<f64> {
        let middle = median(&self.internodes);
        self.internodes.iter().map(|length| length / middle).collect()
    }
}

/// Height over the diameter of the trunk, at the first node that is a tenth of the height up.
fn slenderness(skeleton: &Skeleton, height: f32) -> Option<f64> {
    let axes = skeleton.axes(Continuation::Longest);
    let breast = skeleton.positions()[0].y + BREAST * height;
    let trunk = axes.get(0)?.nodes;
    let at = trunk.iter().find(|&&node| skeleton.positions()[node as usize].y >= breast)?;
    let radius = skeleton.radii()[*at as usize];
    (radius > 0.0).then(|| f64::from(height / (2.0 * radius)))
}
