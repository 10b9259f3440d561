//! Writing the modules, with a turtle led along.

use super::aim::{Aim, roll, round};
use super::{Chain, ChainParams};
use crate::error::{ModelError, Result};
use crate::glam::{DVec3, Vec3};
use crate::lsystem::turtle::frame::{Frame, Turn};
use crate::lsystem::{Kind, Symbols, Word};
use tree_core::{Axes, Children, Control, Foliage, Leaf, Resource, Skeleton};

/// Modules between two looks at the cancel flag and the limit.
const CHECK_EVERY: usize = 1 << 12;
/// Share of the tolerance that rounding a length, or one of two angles, may take.
const SHARE: f64 = 0.5;
/// Coarsest step of a leaf's angles in degrees when numbers are rounded: no eye sees it.
const LEAF_STEP: f64 = 0.1;
/// Share of the tolerance that rounding a width may take: the eye sees thickness before place.
const WIDTH_SHARE: f64 = 0.1;

/// The kinds that chains are written with.
struct Kinds {
    advance: Kind,
    jump: Kind,
    yaw: Kind,
    pitch: Kind,
    roll: Kind,
    width: Kind,
    leaf: Kind,
}

/// The turtle that is led along.
#[derive(Clone, Copy)]
struct Place {
    position: DVec3,
    frame: Frame,
    width: f64,
}

/// What is left to write, last first.
enum Task {
    /// The internode below a node, then all that the node bears.
    Node(u32),
    /// A lateral axis, in brackets, that starts with this node.
    Lateral(u32),
    /// The end of a lateral: the turtle goes back to where it began.
    End(Place),
}

pub(super) struct Writer<'a> {
    skeleton: &'a Skeleton,
    foliage: &'a Foliage,
    control: &'a Control,
    axes: Axes,
    children: Children,
    /// Leaves of node i: `leaf_order[leaf_starts[i]..leaf_starts[i + 1]]`.
    leaf_starts: Vec<usize>,
    leaf_order: Vec<u32>,
    kinds: Kinds,
    /// Metres a node may be off; 0 for all digits.
    tolerance: f64,
    place: Place,
    out: Chain,
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        skeleton: &'a Skeleton,
        foliage: &'a Foliage,
        params: &ChainParams,
        control: &'a Control,
    ) -> Result<Self> {
        let mut symbols = Symbols::default();
        let kinds = Kinds {
            advance: symbols.intern("F", 1)?,
            jump: symbols.intern("f", 1)?,
            yaw: symbols.intern("+", 1)?,
            pitch: symbols.intern("&", 1)?,
            roll: symbols.intern("\\", 1)?,
            width: symbols.intern("!", 1)?,
            leaf: symbols.intern("~", 2)?,
        };
        let (leaf_starts, leaf_order) = leaves_of_nodes(skeleton.len(), foliage)?;
        let bounds = skeleton.bounds();
        let extent = (bounds.max.as_dvec3() - bounds.min.as_dvec3()).max_element();
        let place = Place { position: DVec3::ZERO, frame: Frame::START, width: f64::NAN };
        let out = Chain { word: Word::default(), symbols, nodes: Vec::new(), leaves: Vec::new() };
        Ok(Self {
            skeleton,
            foliage,
            control,
            axes: skeleton.axes(params.continuation),
            children: skeleton.children(),
            leaf_starts,
            leaf_order,
            kinds,
            tolerance: params.tolerance * extent,
            place,
            out,
        })
    }

    pub(super) fn write(mut self) -> Result<Chain> {
        let mut tasks = vec![Task::Node(0)];
        let mut next_check = 0;
        while let Some(task) = tasks.pop() {
            if self.out.word.len() >= next_check {
                self.control.check()?;
                self.control.limits.check(Resource::Modules, self.out.word.len() as u64)?;
                next_check = self.out.word.len() + CHECK_EVERY;
            }
            match task {
                Task::Node(node) => {
                    self.internode(node)?;
                    self.leaves(node)?;
                    self.later(node, &mut tasks);
                }
                Task::Lateral(node) => {
                    self.put(Symbols::PUSH, &[])?;
                    tasks.push(Task::End(self.place));
                    tasks.push(Task::Node(node));
                }
                Task::End(place) => {
                    self.put(Symbols::POP, &[])?;
                    self.place = place;
                }
            }
        }
        Ok(self.out)
    }

    /// Lays the children aside: laterals first, what goes on last.
    fn later(&self, node: u32, tasks: &mut Vec<Task>) {
        let axis_of = self.axes.axis_of();
        let goes_on = |child: u32| axis_of.get(child as usize) == axis_of.get(node as usize);
        let children = self.children.of(node);
        tasks.extend(children.iter().filter(|&&child| goes_on(child)).map(|&c| Task::Node(c)));
        let laterals = children.iter().rev().filter(|&&child| !goes_on(child));
        tasks.extend(laterals.map(|&child| Task::Lateral(child)));
    }

    fn put(&mut self, kind: Kind, params: &[f64]) -> Result<()> {
        self.out.word.push(&self.out.symbols, kind, params)
    }

    /// A point of the tree as seen from its base.
    fn target(&self, point: Vec3) -> DVec3 {
        let base = self.skeleton.positions().first().copied().unwrap_or_default();
        point.as_dvec3() - base.as_dvec3()
    }

    fn internode(&mut self, node: u32) -> Result<()> {
        let index = node as usize;
        let (Some(&position), Some(&radius)) =
            (self.skeleton.positions().get(index), self.skeleton.radii().get(index))
        else {
            return Ok(());
        };
        let width = round(2.0 * f64::from(radius), WIDTH_SHARE * self.tolerance);
        if node == 0 {
            self.out.nodes.push(0);
            return self.width(width);
        }
        let way = self.target(position) - self.place.position;
        if self.is_same_place(node) {
            return Ok(());
        }
        let length = self.aim(way, 0.0)?;
        self.width(width)?;
        self.put(self.kinds.advance, &[length])?;
        self.place.position += length * self.place.frame.heading;
        self.out.nodes.push(node);
        Ok(())
    }

    /// Whether a node stands exactly where its parent does.
    fn is_same_place(&self, node: u32) -> bool {
        let position = |node: u32| self.skeleton.positions().get(node as usize);
        self.skeleton.parent(node).is_some_and(|parent| position(parent) == position(node))
    }

    fn width(&mut self, width: f64) -> Result<()> {
        if width == self.place.width {
            return Ok(());
        }
        self.place.width = width;
        self.put(self.kinds.width, &[width])
    }

    /// Turns the turtle along `way` and returns how far it has to go. Angles are rounded to what the
    /// tolerance allows at that length, or to `coarsest` degrees where that is less.
    fn aim(&mut self, way: DVec3, coarsest: f64) -> Result<f64> {
        let length = way.length();
        if length == 0.0 {
            return Ok(0.0);
        }
        let slack = SHARE * self.tolerance;
        let mut step = (slack / length).to_degrees().min(1.0);
        if coarsest > 0.0 {
            step = step.min(coarsest);
        }
        let aim = Aim::at(&self.place.frame, way / length).rounded(step);
        aim.turn(&mut self.place.frame);
        for (kind, angle) in [(self.kinds.yaw, aim.yaw), (self.kinds.pitch, aim.pitch)] {
            if angle != 0.0 {
                self.put(kind, &[angle])?;
            }
        }
        // A short internode must not vanish.
        Ok(round(length, slack.min(0.01 * length)))
    }

    fn leaves(&mut self, node: u32) -> Result<()> {
        let range = |i: usize| self.leaf_starts.get(i).copied().unwrap_or_default();
        for at in range(node as usize)..range(node as usize + 1) {
            let index = self.leaf_order.get(at).copied().unwrap_or_default();
            if let Some(leaf) = self.foliage.get(index as usize) {
                self.leaf(&leaf)?;
                self.out.leaves.push(index);
            }
        }
        Ok(())
    }

    fn leaf(&mut self, leaf: &Leaf) -> Result<()> {
        let place = self.place;
        self.put(Symbols::PUSH, &[])?;
        let stalk = self.target(leaf.position) - place.position;
        if stalk.length() > self.tolerance {
            let length = self.aim(stalk, LEAF_STEP)?;
            self.put(self.kinds.jump, &[length])?;
        }
        let rotation = leaf.rotation.as_dquat().normalize();
        let step = if self.tolerance > 0.0 { LEAF_STEP } else { 0.0 };
        let aim = Aim::at(&self.place.frame, rotation * DVec3::Y).rounded(step);
        aim.turn(&mut self.place.frame);
        let turn = round(roll(&self.place.frame, rotation * DVec3::Z), step);
        self.place.frame.roll(Turn::degrees(turn));
        let turns =
            [(self.kinds.yaw, aim.yaw), (self.kinds.pitch, aim.pitch), (self.kinds.roll, turn)];
        for (kind, angle) in turns {
            if angle != 0.0 {
                self.put(kind, &[angle])?;
            }
        }
        let size = round(leaf.size.into(), self.tolerance);
        self.put(self.kinds.leaf, &[size, leaf.kind.into()])?;
        self.put(Symbols::POP, &[])?;
        self.place = place;
        Ok(())
    }
}

/// The leaves of each node, as starts into a list: counting sort.
fn leaves_of_nodes(n_nodes: usize, foliage: &Foliage) -> Result<(Vec<usize>, Vec<u32>)> {
    let mut starts = vec![0; n_nodes + 1];
    for (leaf, &node) in foliage.nodes().iter().enumerate() {
        let slot = starts.get_mut(node as usize + 1).ok_or_else(|| ModelError::Word {
            module: 0,
            problem: format!("leaf {leaf} sits on node {node}, there are {n_nodes}"),
        })?;
        *slot += 1;
    }
    for i in 0..n_nodes {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut order = vec![0; foliage.len()];
    for (leaf, &node) in (0_u32..).zip(foliage.nodes()) {
        let slot = &mut next[node as usize];
        order[*slot] = leaf;
        *slot += 1;
    }
    Ok((starts, order))
}
