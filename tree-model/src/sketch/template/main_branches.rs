//! What a person would draw of a tree: its trunk, and its longest branches of the first two orders.
//!
//! 1. The skeleton is split into [axes](tree_core::Axes). Axes of order 1 and 2 that are long enough are kept,
//!    those of order 1 first, the longest first, up to a number.
//! 2. Where kept axes leave others there are forks. Forks that lie close together on an axis are taken for one, as in
//!    whorls: a hand would draw them as one, and lengths between them would say nothing.
//! 3. Axes are cut at forks into segments. Where several stems leave the base, a root below it is imagined.
//!
//! O(nodes) time.

use crate::error::{ModelError, Result, check};
use crate::sketch::frame::{across, roll};
use crate::sketch::{Branches, Label};
use glam::{DVec3, Vec3};
use tree_core::{Axes, Axis, Continuation, NO_PARENT, Skeleton};

/// Length of an imagined root as a share of the tree's extent.
const IMAGINED_ROOT: f32 = 0.05;

/// Which branches are main ones.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct MainBranchParams {
    /// Least length of axes of order 1 as a share of the longest of them, 0 to 1. Default 0.3.
    pub least: f32,
    /// Least length of axes of order 2 as a share of their parent's, 0 to 1. Default 0.35.
    pub least_second: f32,
    /// Most axes, 1 to 1000. Default 36.
    pub most: u32,
    /// Forks closer than this on an axis, as a share of the tree's extent, are taken for one, 0 to 0.5. Default 0.025.
    pub gather: f32,
    /// What continues an axis at a fork. Default the thickest child.
    pub continuation: Continuation,
}

impl Default for MainBranchParams {
    fn default() -> Self {
        Self {
            least: 0.3,
            least_second: 0.35,
            most: 36,
            gather: 0.025,
            continuation: Continuation::Thickest,
        }
    }
}

impl MainBranchParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("main.least", self.least, 0.0, 1.0)?;
        check("main.least_second", self.least_second, 0.0, 1.0)?;
        check("main.most", self.most, 1, 1000)?;
        check("main.gather", self.gather, 0.0, 0.5)
    }
}

/// The main branches of a skeleton.
///
/// # Errors
/// [`ModelError::Parameter`] naming a field of `params`, [`ModelError::Template`] for a skeleton without extent.
pub fn main_branches(skeleton: &Skeleton, params: &MainBranchParams) -> Result<Branches> {
    params.validate()?;
    let extent = skeleton.bounds().size().max_element();
    if !(extent > 0.0 && extent.is_finite()) {
        let problem = "the tree has no extent: two different points at least make a trunk".into();
        return Err(ModelError::Template { problem });
    }
    let axes = skeleton.axes(params.continuation);
    let kept = kept(skeleton, &axes, params);
    let joints = Joints::find(skeleton, &axes, &kept, params.gather * extent);
    let kept: Vec<Axis<'_>> = kept.iter().filter_map(|&axis| axes.get(axis)).collect();
    let mut draft = Draft::new(skeleton.len());
    let several_stems = kept.iter().skip(1).any(|&axis| joints.begin(skeleton, axis) == 0);
    if several_stems {
        let base = skeleton.positions()[0];
        draft.ends[0] =
            draft.push(NO_PARENT, true, &[base - IMAGINED_ROOT * extent * Vec3::Y, base]);
    }
    for axis in kept {
        draft.add(skeleton, &joints, axis);
    }
    draft.finish(several_stems)
}

/// The axes kept, in their order, parents first.
fn kept(skeleton: &Skeleton, axes: &Axes, params: &MainBranchParams) -> Vec<u32> {
    let lengths: Vec<f32> = axes.iter().map(|axis| length(skeleton, axis)).collect();
    let of_order = |order| axes.iter().filter(move |axis| axis.order == order);
    let longest = of_order(1).map(|axis| lengths[axis.index as usize]).fold(0.0, f32::max);
    let mut is_kept = vec![false; axes.len()];
    is_kept[0] = true;
    let mut left = params.most - 1;
    for order in [1, 2] {
        let is_long = |&axis: &Axis<'_>| {
            let Some(parent) = parent_axis(skeleton, axes, axis) else { return false };
            let least = match order {
                1 => params.least * longest,
                _ => params.least_second * lengths[parent as usize],
            };
            let length = lengths[axis.index as usize];
            is_kept[parent as usize] && length >= least && length > 0.0
        };
        let mut long: Vec<u32> = of_order(order).filter(is_long).map(|axis| axis.index).collect();
        long.sort_by(|&a, &b| lengths[b as usize].total_cmp(&lengths[a as usize]).then(a.cmp(&b)));
        for axis in long.into_iter().take(left as usize) {
            is_kept[axis as usize] = true;
            left -= 1;
        }
    }
    (0..axes.len() as u32).filter(|&axis| is_kept[axis as usize]).collect()
}

/// The node at which an axis leaves its parent.
fn start_of(skeleton: &Skeleton, axis: Axis<'_>) -> Option<u32> {
    axis.nodes.first().and_then(|&node| skeleton.parent(node))
}

fn parent_axis(skeleton: &Skeleton, axes: &Axes, axis: Axis<'_>) -> Option<u32> {
    start_of(skeleton, axis).map(|node| axes.axis_of()[node as usize])
}

fn length(skeleton: &Skeleton, axis: Axis<'_>) -> f32 {
    let positions = skeleton.positions();
    let step = |&node: &u32| {
        let below = skeleton.parent(node)?;
        Some(positions[node as usize].distance(positions[below as usize]))
    };
    axis.nodes.iter().filter_map(step).sum()
}

/// Where axes are cut.
struct Joints {
    /// For each node the node at which what leaves it is taken to leave: the lowest fork within `gather` along its axis.
    of: Vec<u32>,
    /// Whether something is taken to leave a node.
    is_cut: Vec<bool>,
}

impl Joints {
    fn find(skeleton: &Skeleton, axes: &Axes, kept: &[u32], gather: f32) -> Self {
        let mut is_fork = vec![false; skeleton.len()];
        for axis in kept.iter().filter_map(|&axis| axes.get(axis)) {
            if let Some(node) = start_of(skeleton, axis) {
                is_fork[node as usize] = true;
            }
        }
        let mut joints =
            Self { of: (0..skeleton.len() as u32).collect(), is_cut: vec![false; skeleton.len()] };
        let positions = skeleton.positions();
        for axis in kept.iter().filter_map(|&axis| axes.get(axis)) {
            let mut joint = joints.begin(skeleton, axis);
            let mut way = 0.0;
            for &node in axis.nodes {
                if let Some(below) = skeleton.parent(node) {
                    way += positions[node as usize].distance(positions[below as usize]);
                }
                if !is_fork[node as usize] {
                    continue;
                }
                if way > gather {
                    (joint, way) = (node, 0.0);
                    joints.is_cut[node as usize] = true;
                }
                joints.of[node as usize] = joint;
            }
        }
        joints
    }

    /// Where an axis begins: at a joint of its parent's, or the trunk at the base.
    fn begin(&self, skeleton: &Skeleton, axis: Axis<'_>) -> u32 {
        start_of(skeleton, axis).map_or(0, |node| self.of[node as usize])
    }
}

/// Branches while they are put together.
struct Draft {
    /// The segment that ends at each joint.
    ends: Vec<u32>,
    parents: Vec<u32>,
    is_apical: Vec<bool>,
    starts: Vec<u32>,
    points: Vec<Vec3>,
}

impl Draft {
    fn new(n_nodes: usize) -> Self {
        Self {
            ends: vec![NO_PARENT; n_nodes],
            parents: Vec::new(),
            is_apical: Vec::new(),
            starts: vec![0],
            points: Vec::new(),
        }
    }

    fn push(&mut self, parent: u32, is_apical: bool, line: &[Vec3]) -> u32 {
        let segment = self.parents.len() as u32;
        self.parents.push(parent);
        self.is_apical.push(is_apical);
        self.points.extend_from_slice(line);
        self.starts.push(self.points.len() as u32);
        segment
    }

    /// Cuts an axis at its joints.
    fn add(&mut self, skeleton: &Skeleton, joints: &Joints, axis: Axis<'_>) {
        let positions = skeleton.positions();
        let begin = joints.begin(skeleton, axis) as usize;
        let mut parent = self.ends[begin];
        let mut is_apical = axis.index == 0;
        let mut line = vec![positions[begin]];
        for &node in axis.nodes {
            let point = positions[node as usize];
            if line.last() != Some(&point) {
                line.push(point);
            }
            if joints.is_cut[node as usize] {
                if line.len() > 1 {
                    parent = self.push(parent, is_apical, &line);
                    is_apical = true;
                    line = vec![point];
                }
                self.ends[node as usize] = parent;
            }
        }
        if line.len() > 1 {
            self.push(parent, is_apical, &line);
        }
    }

    fn finish(self, imagined_root: bool) -> Result<Branches> {
        let sound = |(segment, &parent): (usize, &u32)| (segment == 0) == (parent == NO_PARENT);
        if self.parents.is_empty() || !self.parents.iter().enumerate().all(sound) {
            let problem = "the trunk has no length: its branches would begin at nothing".into();
            return Err(ModelError::Template { problem });
        }
        let Self { parents, is_apical, starts, points, .. } = self;
        let labels = is_apical
            .iter()
            .map(|&is_apical| if is_apical { Label::Apical } else { Label::Lateral(0) })
            .collect();
        let mut branches =
            Branches { parents, labels, starts, points, imagined_root, names: Vec::new() };
        number_laterals(&mut branches);
        Ok(branches)
    }
}

/// Numbers the laterals of each fork round its axis, from the first on.
fn number_laterals(branches: &mut Branches) {
    let mut laterals: Vec<Vec<u32>> = vec![Vec::new(); branches.len()];
    for segment in 1..branches.len() {
        if branches.labels[segment] != Label::Apical {
            laterals[branches.parents[segment] as usize].push(segment as u32);
        }
    }
    for (parent, laterals) in laterals.iter().enumerate().filter(|(_, list)| list.len() > 1) {
        let axis = branches.vector(parent).as_dvec3().normalize_or(DVec3::Y);
        let vector = |segment: u32| branches.vector(segment as usize).as_dvec3();
        let Some(side) = laterals.iter().find_map(|&lateral| across(vector(lateral), axis)) else {
            continue;
        };
        let turn = |lateral: u32| {
            let turn = roll(axis, side, vector(lateral));
            // The first itself may come out a hair below 0.
            if turn < -1e-6 { turn + std::f64::consts::TAU } else { turn }
        };
        let mut order: Vec<(f64, u32)> = laterals.iter().map(|&l| (turn(l), l)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (number, (_, lateral)) in order.into_iter().enumerate() {
            branches.labels[lateral as usize] = Label::Lateral(number as u16);
        }
    }
}
