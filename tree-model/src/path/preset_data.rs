//! The presets as rows of a table. Shapes, branchings, angles and turns of `a` to `l` are those of
//! Xu & Mould's Table 2; sizes in metres, node counts, bark and leaves are ours, since the paper
//! names none. Angles are shares of π. Node counts follow from the paper's times: at the 10,860 nodes
//! a second of its Table 1, tree `a` with 6.4 s had about 70,000 nodes in 157 graphs, and so on.

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

const SPIRAL: Phyllotaxis = Phyllotaxis::Spiral { divergence: crate::foliage::GOLDEN_ANGLE };

/// What most levels share.
const LEVEL: LevelRow = LevelRow {
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
const LEAVES: LeafRow = LeafRow {
    kind: "oak-cluster",
    arrangement: SPIRAL,
    spacing: 0.11,
    bearing: 0.6,
    size: 0.42,
    pitch: 0.8,
    droop: 0.1,
    phototropism: 0.55,
};

const ROW: Row = Row {
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

const GROUND: [f32; 3] = [0.0; 3];

pub(super) const ROWS: [Row; 15] = [
    Row {
        name: "oak",
        title: "an oak in a meadow, broad and round",
        base: &[
            Part::Cylinder { base: GROUND, top: [0.1, 3.0, 0.0], radius: 0.2 },
            Part::Ellipsoid { center: [0.0, 6.4, 0.0], radii: [5.2, 4.0, 5.0] },
        ],
        branching: 24,
        above: 0.25,
        graph_nodes: 5000,
        size: 2.2,
        shrink: 0.62,
        levels: &[
            LevelRow { branching: 5, shape: Shape::Sector(0.4), ..LEVEL },
            LevelRow { branching: 5, shape: Shape::Sector(0.35), ..LEVEL },
            LevelRow { branching: 3, shape: Shape::Sector(0.3), graph_nodes: 60, ..LEVEL },
        ],
        low: 0.2,
        trunk_radius: 0.48,
        pipe_exponent: 2.4,
        leaves: Some(LeafRow { spacing: 0.085, bearing: 0.8, ..LEAVES }),
        ..ROW
    },
    Row {
        name: "a",
        title: "vase-shaped crown on a short trunk",
        paper_seconds: Some(6.4),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 2.4, 0.0], radius: 0.18 },
            Part::Sector { apex: [0.0, 2.0, 0.0], angle: 0.3, radius: 5.0, up: 1.0 },
        ],
        branching: 12,
        above: 0.35,
        graph_nodes: 3000,
        size: 2.0,
        shrink: 0.66,
        levels: &[
            LevelRow { repeat: 2, branching: 3, graph_nodes: 430, ..LEVEL },
            LevelRow { branching: 6, graph_nodes: 430, ..LEVEL },
        ],
        species: "ash",
        leaves: Some(LeafRow {
            kind: "beech-cluster",
            arrangement: Phyllotaxis::Decussate,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "b",
        title: "slender and upright, dense twigs",
        paper_seconds: Some(7.0),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 4.2, 0.0], radius: 0.18 },
            Part::Sector { apex: [0.0, 3.4, 0.0], angle: 0.25, radius: 6.4, up: 1.0 },
        ],
        branching: 10,
        above: 0.3,
        graph_nodes: 4000,
        size: 2.1,
        shrink: 0.55,
        levels: &[
            LevelRow { branching: 5, shape: Shape::Sector(0.25), graph_nodes: 1200, ..LEVEL },
            LevelRow { branching: 10, shape: Shape::Sector(0.25), graph_nodes: 1200, ..LEVEL },
        ],
        trunk_radius: 0.26,
        species: "birch",
        bark: "birch",
        leaves: Some(LeafRow {
            kind: "birch-cluster",
            droop: 0.3,
            size: 0.4,
            spacing: 0.08,
            bearing: 1.0,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "c",
        title: "weeping willow, branches bending to the ground",
        paper_seconds: Some(13.4),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 2.6, 0.0], radius: 0.2 },
            Part::Sector { apex: [0.0, 2.4, 0.0], angle: 0.5, radius: 3.6, up: 1.0 },
        ],
        branching: 30,
        above: 0.5,
        graph_nodes: 3000,
        size: 1.0,
        shrink: 0.94,
        levels: &[
            LevelRow {
                branching: 2,
                shape: Shape::Sector(0.25),
                graph_nodes: 250,
                turn: 0.12,
                ..LEVEL
            },
            LevelRow {
                repeat: 2,
                branching: 1,
                shape: Shape::Sector(0.25),
                graph_nodes: 250,
                turn: 0.12,
                ..LEVEL
            },
            LevelRow {
                branching: 2,
                shape: Shape::Sector(0.25),
                graph_nodes: 250,
                turn: 0.12,
                ..LEVEL
            },
            LevelRow {
                repeat: 3,
                branching: 1,
                shape: Shape::Sector(0.25),
                graph_nodes: 250,
                turn: 0.12,
                ..LEVEL
            },
        ],
        smoothing: 10,
        trunk_radius: 0.4,
        species: "weeping willow",
        bark: "oak",
        leaves: Some(LeafRow {
            kind: "willow-cluster",
            spacing: 0.06,
            bearing: 3.2,
            size: 0.5,
            pitch: 0.5,
            droop: 0.75,
            phototropism: 0.2,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "d",
        title: "two stems under a round crown",
        paper_seconds: Some(5.6),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 2.6, 0.0], radius: 0.2 },
            Part::Sector { apex: [0.0, 4.0, 0.0], angle: 1.0, radius: 2.0, up: 1.0 },
        ],
        branching: 2,
        above: 0.5,
        graph_nodes: 1500,
        size: 2.9,
        shrink: 0.62,
        levels: &[
            LevelRow { branching: 10, shape: Shape::Sector(0.4), graph_nodes: 420, ..LEVEL },
            LevelRow {
                repeat: 2,
                branching: 6,
                shape: Shape::Sector(0.4),
                graph_nodes: 420,
                ..LEVEL
            },
        ],
        trunk_radius: 0.34,
        species: "maple",
        bark: "smooth",
        leaves: Some(LeafRow {
            kind: "maple-cluster",
            arrangement: Phyllotaxis::Decussate,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "e",
        title: "conifer with upswept branches",
        paper_seconds: Some(3.3),
        base: &[Part::Cone { base: [0.0, -0.01, 0.0], top: [0.0, 11.0, 0.0], radius: 2.2 }],
        branching: 40,
        surface: true,
        placed: &[[0.0, 10.7, 0.0], [0.2, 10.0, 0.1], [-0.2, 9.5, 0.15], [0.1, 9.0, -0.3]],
        above: 0.08,
        graph_nodes: 2400,
        size: 0.75,
        shrink: 0.85,
        levels: &[
            LevelRow {
                repeat: 3,
                branching: 1,
                shape: Shape::Sector(0.25),
                graph_nodes: 110,
                turn: -0.05,
                ..LEVEL
            },
            LevelRow {
                branching: 3,
                shape: Shape::Sector(0.25),
                graph_nodes: 110,
                from_all: true,
                ..LEVEL
            },
        ],
        low: 0.5,
        smoothing: 8,
        leader: Some(Leader { top: [0.0, 10.8, 0.0], radius: 0.35, factor: 0.12 }),
        trunk_radius: 0.2,
        species: "pine",
        bark: "pine",
        leaves: Some(LeafRow {
            kind: "pine-needles",
            size: 0.46,
            spacing: 0.05,
            bearing: 1.3,
            pitch: 0.6,
            droop: 0.0,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "f",
        title: "umbrella with hanging branches",
        paper_seconds: Some(7.5),
        base: &[Part::Sector { apex: GROUND, angle: 0.5, radius: 5.2, up: 1.0 }],
        branching: 10,
        above: 0.62,
        graph_nodes: 2500,
        size: 2.0,
        shrink: 0.6,
        levels: &[
            LevelRow {
                branching: 4,
                shape: Shape::Sector(0.5),
                graph_nodes: 380,
                down: true,
                ..LEVEL
            },
            LevelRow { branching: 4, shape: Shape::Sector(0.5), graph_nodes: 380, ..LEVEL },
            LevelRow { branching: 6, shape: Shape::Sector(0.3), graph_nodes: 380, ..LEVEL },
        ],
        smoothing: 6,
        leader: Some(Leader { top: [0.0, 2.8, 0.0], radius: 0.4, factor: 0.15 }),
        trunk_radius: 0.26,
        species: "weeping birch",
        bark: "birch",
        leaves: Some(LeafRow {
            kind: "birch-cluster",
            droop: 0.6,
            size: 0.4,
            spacing: 0.06,
            bearing: 0.9,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "g",
        title: "tall conifer with drooping branches",
        paper_seconds: Some(3.0),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 2.5, 0.0], radius: 0.2 },
            Part::Cone { base: [0.0, 2.0, 0.0], top: [0.0, 15.0, 0.0], radius: 2.0 },
        ],
        branching: 32,
        surface: true,
        placed: &[[0.0, 14.7, 0.0], [0.15, 14.0, 0.1], [-0.2, 13.4, 0.1], [0.1, 12.8, -0.3]],
        above: 0.15,
        graph_nodes: 2400,
        size: 0.6,
        shrink: 0.85,
        levels: &[
            LevelRow {
                repeat: 6,
                branching: 1,
                shape: Shape::Sector(0.25),
                graph_nodes: 75,
                turn: 0.03,
                ..LEVEL
            },
            LevelRow {
                branching: 8,
                shape: Shape::Sector(0.25),
                graph_nodes: 75,
                from_all: true,
                size: Some(0.6),
                ..LEVEL
            },
        ],
        low: 0.5,
        smoothing: 8,
        leader: Some(Leader { top: [0.0, 14.8, 0.0], radius: 0.35, factor: 0.12 }),
        trunk_radius: 0.24,
        species: "spruce",
        bark: "pine",
        leaves: Some(LeafRow {
            kind: "spruce-needles",
            size: 0.42,
            spacing: 0.07,
            bearing: 0.9,
            pitch: 0.6,
            droop: 0.2,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "h",
        title: "tilted trunk, crown swept by the wind",
        paper_seconds: Some(2.1),
        base: &[
            Part::Cylinder { base: GROUND, top: [1.9, 3.2, 0.0], radius: 0.2 },
            Part::Sector { apex: [1.7, 2.9, 0.0], angle: 0.5, radius: 3.4, up: 1.0 },
        ],
        branching: 8,
        above: 0.5,
        graph_nodes: 2200,
        size: 1.8,
        shrink: 0.55,
        levels: &[
            LevelRow { branching: 6, shape: Shape::Sector(0.5), graph_nodes: 380, ..LEVEL },
            LevelRow { branching: 12, shape: Shape::Sector(0.5), graph_nodes: 380, ..LEVEL },
        ],
        trunk_radius: 0.33,
        species: "hawthorn",
        bark: "oak",
        leaves: Some(LeafRow { kind: "oak-cluster", size: 0.36, ..LEAVES }),
        ..ROW
    },
    Row {
        name: "i",
        title: "low and wide, as an old apple tree",
        paper_seconds: Some(0.78),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 1.8, 0.0], radius: 0.18 },
            Part::Sector { apex: [0.0, 1.9, 0.0], angle: 0.7, radius: 2.6, up: 1.0 },
        ],
        branching: 11,
        above: 0.3,
        graph_nodes: 900,
        size: 1.4,
        shrink: 0.6,
        levels: &[LevelRow {
            repeat: 2,
            branching: 6,
            shape: Shape::Sector(0.45),
            graph_nodes: 100,
            ..LEVEL
        }],
        low: 0.12,
        trunk_radius: 0.24,
        species: "apple",
        bark: "oak",
        leaves: Some(LeafRow { kind: "beech-cluster", size: 0.34, ..LEAVES }),
        ..ROW
    },
    Row {
        name: "j",
        title: "larch: a cone of cones",
        paper_seconds: Some(3.2),
        base: &[
            Part::Cylinder { base: GROUND, top: [0.0, 2.0, 0.0], radius: 0.2 },
            Part::Cone { base: [0.0, 1.5, 0.0], top: [0.0, 10.5, 0.0], radius: 2.6 },
        ],
        branching: 16,
        placed: &[[0.0, 10.2, 0.0], [0.2, 9.6, 0.1], [-0.25, 9.0, 0.15]],
        above: 0.2,
        graph_nodes: 2400,
        size: 1.9,
        shrink: 0.5,
        levels: &[LevelRow {
            repeat: 2,
            branching: 8,
            shape: Shape::Cone(0.55),
            graph_nodes: 230,
            ..LEVEL
        }],
        low: 0.5,
        smoothing: 8,
        leader: Some(Leader { top: [0.0, 10.0, 0.0], radius: 0.35, factor: 0.15 }),
        trunk_radius: 0.24,
        species: "larch",
        bark: "pine",
        leaves: Some(LeafRow {
            kind: "spruce-needles",
            size: 0.3,
            spacing: 0.09,
            bearing: 0.7,
            pitch: 0.7,
            droop: 0.1,
            ..LEAVES
        }),
        ..ROW
    },
    Row {
        name: "k",
        title: "a fan of stems from the ground",
        paper_seconds: Some(4.2),
        base: &[Part::Sector { apex: GROUND, angle: 0.3, radius: 3.4, up: 1.0 }],
        branching: 13,
        above: 0.5,
        graph_nodes: 2400,
        size: 1.2,
        shrink: 0.8,
        levels: &[
            LevelRow {
                repeat: 3,
                branching: 2,
                shape: Shape::Sector(0.2),
                graph_nodes: 220,
                ..LEVEL
            },
            LevelRow { branching: 4, shape: Shape::Sector(0.3), graph_nodes: 220, ..LEVEL },
        ],
        trunk_radius: 0.16,
        species: "hazel",
        bark: "smooth",
        leaves: Some(LeafRow { kind: "linden-cluster", size: 0.34, ..LEAVES }),
        ..ROW
    },
    Row {
        name: "l",
        title: "cypress: a slim cone, branches hugging the stem",
        paper_seconds: Some(1.3),
        base: &[Part::Cone { base: [0.0, -0.01, 0.0], top: [0.0, 8.0, 0.0], radius: 0.9 }],
        branching: 16,
        surface: true,
        placed: &[[0.0, 7.7, 0.0], [0.1, 7.2, 0.05], [-0.12, 6.7, 0.1], [0.1, 6.2, -0.15]],
        above: 0.1,
        graph_nodes: 1400,
        size: 1.0,
        shrink: 0.9,
        levels: &[
            LevelRow {
                branching: 1,
                shape: Shape::Sector(0.25),
                graph_nodes: 380,
                turn: -0.03,
                ..LEVEL
            },
            LevelRow { branching: 10, shape: Shape::Cone(0.4), graph_nodes: 380, ..LEVEL },
        ],
        low: 0.5,
        smoothing: 8,
        leader: Some(Leader { top: [0.0, 7.6, 0.0], radius: 0.25, factor: 0.15 }),
        trunk_radius: 0.12,
        species: "cypress",
        bark: "smooth",
        leaves: Some(LeafRow {
            kind: "spruce-needles",
            size: 0.36,
            spacing: 0.035,
            bearing: 1.8,
            pitch: 0.35,
            droop: 0.0,
            ..LEAVES
        }),
        ..ROW
    },
    Row { name: "taproot", title: "a taproot with laterals", roots: Some(&TAPROOT), ..ROOTED },
    Row { name: "heartroot", title: "wide, shallow roots", roots: Some(&HEARTROOT), ..ROOTED },
];

/// The tree above both root systems.
const ROOTED: Row = Row {
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, 1.6, 0.0], radius: 0.15 },
        Part::Sector { apex: [0.0, 1.5, 0.0], angle: 0.5, radius: 2.6, up: 1.0 },
    ],
    branching: 10,
    above: 0.4,
    graph_nodes: 1500,
    size: 1.3,
    shrink: 0.6,
    levels: &[LevelRow { branching: 4, ..LEVEL }, LevelRow { branching: 5, ..LEVEL }],
    trunk_radius: 0.2,
    species: "young oak",
    leaves: Some(LeafRow { size: 0.36, spacing: 0.08, ..LEAVES }),
    ..ROW
};

/// Fig. 15: one endpoint straight below makes the taproot, random ones in a half ball make laterals
/// that leave it on their way, because its own way is cheap.
const TAPROOT: Row = Row {
    name: "taproot",
    title: "roots",
    base: &[Part::Ellipsoid { center: [0.0, -1.3, 0.0], radii: [1.5, 1.35, 1.5] }],
    branching: 16,
    placed: &[[0.0, -2.6, 0.0]],
    graph_nodes: 1800,
    size: 0.7,
    shrink: 0.6,
    levels: &[
        LevelRow { branching: 4, shape: Shape::Sector(0.4), ..LEVEL },
        LevelRow { branching: 4, shape: Shape::Sector(0.4), ..LEVEL },
    ],
    low: 0.15,
    leader: Some(Leader { top: [0.0, -2.5, 0.0], radius: 0.2, factor: 0.3 }),
    leaves: None,
    ..ROW
};

const HEARTROOT: Row = Row {
    name: "heartroot",
    title: "roots",
    base: &[Part::Sector { apex: [0.0, 0.0, 0.0], angle: 0.5, radius: 2.6, up: -1.0 }],
    branching: 18,
    placed: &[],
    graph_nodes: 2200,
    size: 1.0,
    shrink: 0.6,
    levels: &[
        LevelRow { branching: 4, shape: Shape::Sector(0.35), ..LEVEL },
        LevelRow { branching: 4, shape: Shape::Sector(0.35), ..LEVEL },
    ],
    low: 0.12,
    leaves: None,
    ..ROW
};
