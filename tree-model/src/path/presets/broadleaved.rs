//! Broad-leaved trees: the oak, and those of the paper that are no conifers.

use super::row::{GROUND, LEAVES, LEVEL, Leader, LeafRow, LevelRow, Part, ROW, Row, Shape};
use crate::foliage::Phyllotaxis;

pub(super) const OAK: Row = Row {
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
};

pub(super) const A: Row = Row {
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
    trunk_radius: 0.235,
    species: "ash",
    leaves: Some(LeafRow { kind: "beech-cluster", arrangement: Phyllotaxis::Decussate, ..LEAVES }),
    ..ROW
};

pub(super) const B: Row = Row {
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
};

pub(super) const C: Row = Row {
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
    trunk_radius: 0.2,
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
};

pub(super) const D: Row = Row {
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
        LevelRow { repeat: 2, branching: 6, shape: Shape::Sector(0.4), graph_nodes: 420, ..LEVEL },
    ],
    trunk_radius: 0.24,
    species: "maple",
    bark: "smooth",
    leaves: Some(LeafRow { kind: "maple-cluster", arrangement: Phyllotaxis::Decussate, ..LEAVES }),
    ..ROW
};

pub(super) const F: Row = Row {
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
        LevelRow { branching: 4, shape: Shape::Sector(0.5), graph_nodes: 380, down: true, ..LEVEL },
        LevelRow { branching: 4, shape: Shape::Sector(0.5), graph_nodes: 380, ..LEVEL },
        LevelRow { branching: 6, shape: Shape::Sector(0.3), graph_nodes: 380, ..LEVEL },
    ],
    smoothing: 6,
    leader: Some(Leader { top: [0.0, 2.8, 0.0], radius: 0.4, factor: 0.15 }),
    trunk_radius: 0.14,
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
};

pub(super) const H: Row = Row {
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
    trunk_radius: 0.21,
    species: "hawthorn",
    bark: "oak",
    leaves: Some(LeafRow { kind: "oak-cluster", size: 0.36, ..LEAVES }),
    ..ROW
};

pub(super) const I: Row = Row {
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
    trunk_radius: 0.152,
    species: "apple",
    bark: "oak",
    leaves: Some(LeafRow { kind: "beech-cluster", size: 0.34, ..LEAVES }),
    ..ROW
};

pub(super) const K: Row = Row {
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
        LevelRow { repeat: 3, branching: 2, shape: Shape::Sector(0.2), graph_nodes: 220, ..LEVEL },
        LevelRow { branching: 4, shape: Shape::Sector(0.3), graph_nodes: 220, ..LEVEL },
    ],
    trunk_radius: 0.16,
    species: "hazel",
    bark: "smooth",
    leaves: Some(LeafRow { kind: "linden-cluster", size: 0.34, ..LEAVES }),
    ..ROW
};
