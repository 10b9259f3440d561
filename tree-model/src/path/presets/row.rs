//! A preset as a row of a table, and what most rows share.

use crate::foliage::Phyllotaxis;

/// One preset.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    pub(super) paper_seconds: Option<f32>,
    pub(super) base: &'static [Part],
    /// Endpoints of level 1: how many are drawn, above which share of the height, whether only at the
    /// surface, and which are placed by hand.
    pub(super) branching: u32,
    pub(super) above: f32,
    pub(super) surface: bool,
    pub(super) placed: &'static [[f32; 3]],
    pub(super) graph_nodes: u32,
    /// Radius of level 2's subgraphs, and its ratio from level to level.
    pub(super) size: f32,
    pub(super) shrink: f32,
    pub(super) levels: &'static [LevelRow],
    pub(super) lifespan_stop: Option<f32>,
    /// Lowest edge weight: the lower, the more crooked.
    pub(super) low: f32,
    pub(super) smoothing: u32,
    /// A cheap way up the middle, so that conifers have one trunk. Not in the paper.
    pub(super) leader: Option<Leader>,
    pub(super) trunk_radius: f32,
    pub(super) pipe_exponent: f32,
    pub(super) species: &'static str,
    pub(super) bark: &'static str,
    pub(super) leaves: Option<LeafRow>,
    pub(super) roots: Option<&'static Row>,
}

/// A primitive of the base volume; a row's parts are united.
#[derive(Clone, Copy, Debug)]
pub(super) enum Part {
    Cylinder {
        base: [f32; 3],
        top: [f32; 3],
        radius: f32,
    },
    Cone {
        base: [f32; 3],
        top: [f32; 3],
        radius: f32,
    },
    /// A portion of a sphere: within `angle` (share of π) of straight up (`up` 1) or down (−1).
    Sector {
        apex: [f32; 3],
        angle: f32,
        radius: f32,
        up: f32,
    },
    Ellipsoid {
        center: [f32; 3],
        radii: [f32; 3],
    },
}

/// Levels that share their settings.
#[derive(Clone, Copy, Debug)]
pub(super) struct LevelRow {
    pub(super) repeat: usize,
    pub(super) branching: u32,
    pub(super) shape: Shape,
    pub(super) graph_nodes: u32,
    pub(super) turn: f32,
    pub(super) down: bool,
    pub(super) from_all: bool,
    pub(super) size: Option<f32>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    Sector(f32),
    Cone(f32),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Leader {
    pub(super) top: [f32; 3],
    pub(super) radius: f32,
    pub(super) factor: f32,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct LeafRow {
    pub(super) kind: &'static str,
    pub(super) arrangement: Phyllotaxis,
    pub(super) spacing: f32,
    pub(super) bearing: f32,
    pub(super) size: f32,
    pub(super) pitch: f32,
    pub(super) droop: f32,
    pub(super) phototropism: f32,
}

pub(super) const SPIRAL: Phyllotaxis =
    Phyllotaxis::Spiral { divergence: crate::foliage::GOLDEN_ANGLE };

/// What most levels share.
pub(super) const LEVEL: LevelRow = LevelRow {
    repeat: 1,
    branching: 4,
    shape: Shape::Sector(0.3),
    graph_nodes: 110,
    turn: 0.0,
    down: false,
    from_all: false,
    size: None,
};

/// What most broad-leaved trees share: cards that show a short shoot with several leaves.
pub(super) const LEAVES: LeafRow = LeafRow {
    kind: "oak-cluster",
    arrangement: SPIRAL,
    spacing: 0.11,
    bearing: 0.6,
    size: 0.42,
    pitch: 0.8,
    droop: 0.1,
    phototropism: 0.55,
};

pub(super) const ROW: Row = Row {
    name: "",
    title: "",
    paper_seconds: None,
    base: &[],
    branching: 12,
    above: 0.0,
    surface: false,
    placed: &[],
    graph_nodes: 2500,
    size: 1.5,
    shrink: 0.65,
    levels: &[],
    lifespan_stop: None,
    low: 0.25,
    smoothing: 3,
    leader: None,
    trunk_radius: 0.3,
    pipe_exponent: 2.3,
    species: "oak",
    bark: "oak",
    leaves: Some(LEAVES),
    roots: None,
};

pub(super) const GROUND: [f32; 3] = [0.0; 3];
