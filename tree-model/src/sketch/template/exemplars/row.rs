//! An exemplar as a row of a table, and what most rows share.
//!
//! Lengths are shares of the tree's height where nothing else is said, and angles are degrees from straight up for
//! arms, from the axis that bears them for laterals.

use crate::foliage::{GOLDEN_ANGLE, LeafParams, Phyllotaxis};

/// One exemplar.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    /// Name in [`SPECIES`](crate::foliage::SPECIES), whose leaves a sketched tree gets.
    pub(super) species: &'static str,
    pub(super) bark: &'static str,
    /// Height in metres, about.
    pub(super) height: f32,
    /// Radius of the trunk's base in metres.
    pub(super) trunk_radius: f32,
    /// Exponent of the pipe model: the higher, the thicker what is above the forks.
    pub(super) pipe_exponent: f32,
    /// Up to where the trunk goes; above, arms alone go on.
    pub(super) leader: f32,
    /// How far the trunk strays from the vertical.
    pub(super) sway: f32,
    /// The main branches, set by set.
    pub(super) arms: &'static [Arms],
    /// Laterals of the main branches.
    pub(super) laterals: Option<Laterals>,
    pub(super) twigs: Option<Twigs>,
    /// Lowest edge weight of the search graph: the lower, the more crooked.
    pub(super) low: f32,
    pub(super) smoothing: u32,
    /// Kind of leaf picture, and how leaves stand; none for dead trees.
    pub(super) leaves: Option<(&'static str, LeafParams)>,
}

/// Main branches that leave the trunk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arms {
    pub(super) count: u32,
    /// How many leave at one height.
    pub(super) whorl: u32,
    /// Turn about the trunk from one whorl (or branch) to the next.
    pub(super) turn: f32,
    /// Heights of the lowest and the highest.
    pub(super) height: [f32; 2],
    /// Angles of the lowest and the highest.
    pub(super) angle: [f32; 2],
    /// Lengths of the lowest, the middle and the highest.
    pub(super) length: [f32; 3],
    /// By how much they bend from base to tip; up where positive.
    pub(super) bend: f32,
    /// From which share of their length on they bear laterals and twigs; 1 for none.
    pub(super) bare: f32,
}

/// Laterals of the arms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Laterals {
    /// For each arm.
    pub(super) count: u32,
    pub(super) angle: f32,
    /// Share of their arm's length.
    pub(super) length: f32,
    /// By how much they bend from base to tip; up where positive.
    pub(super) bend: f32,
    /// Turn about the arm from one lateral to the next.
    pub(super) turn: f32,
    /// Least share of the height that an arm is long that bears any.
    pub(super) from_length: f32,
}

/// Twigs: subgraphs at even distances along arms and laterals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twigs {
    /// From one to the next.
    pub(super) spacing: f32,
    /// How far they reach.
    pub(super) size: f32,
    pub(super) branching: u32,
    /// Half the opening angle.
    pub(super) angle: f32,
    pub(super) toward: Toward,
    /// How many levels, each 0.6 as large as the one below.
    pub(super) levels: u32,
    /// Whether the trunk has them too.
    pub(super) on_trunk: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Toward {
    Outward,
    Down,
    Up,
}

pub(super) const SPIRAL: f32 = 137.508;

pub(super) const ARMS: Arms = Arms {
    count: 9,
    whorl: 1,
    turn: SPIRAL,
    height: [0.3, 0.6],
    angle: [65.0, 30.0],
    length: [0.45, 0.45, 0.35],
    bend: 10.0,
    bare: 0.3,
};

pub(super) const LATERALS: Laterals =
    Laterals { count: 4, angle: 45.0, length: 0.45, bend: 5.0, turn: 180.0, from_length: 0.1 };

pub(super) const TWIGS: Twigs = Twigs {
    spacing: 0.06,
    size: 0.1,
    branching: 4,
    angle: 75.0,
    toward: Toward::Outward,
    levels: 1,
    on_trunk: false,
};

/// Cards that show a short shoot with several leaves.
pub(super) const LEAVES: LeafParams = LeafParams {
    arrangement: Phyllotaxis::Spiral { divergence: GOLDEN_ANGLE },
    spacing: 0.11,
    bearing: 0.6,
    size: 0.42,
    pitch: 0.8,
    droop: 0.1,
    phototropism: 0.55,
    ..LeafParams::DEFAULT
};

pub(super) const ROW: Row = Row {
    name: "",
    title: "",
    species: "oak",
    bark: "oak",
    height: 10.0,
    trunk_radius: 0.3,
    pipe_exponent: 2.4,
    leader: 0.95,
    sway: 0.01,
    arms: &[ARMS],
    laterals: Some(LATERALS),
    twigs: Some(TWIGS),
    low: 0.4,
    smoothing: 3,
    leaves: Some(("oak-cluster", LEAVES)),
};
