//! Conifers. A cheap way up the middle gives them one straight trunk, and placed endpoints a top.

use super::row::{GROUND, LEAVES, LEVEL, Leader, LeafRow, LevelRow, Part, ROW, Row, Shape};

/// Radius of the thin cylinder through the whole height that gives every conifer nodes up to its
/// top, where the cone itself is too thin for them.
const STEM: f32 = 0.08;

pub(super) const E: Row = Row {
    name: "e",
    title: "conifer with upswept branches",
    paper_seconds: Some(3.3),
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, 10.9, 0.0], radius: STEM },
        Part::Cone { base: [0.0, -0.01, 0.0], top: [0.0, 11.0, 0.0], radius: 2.2 },
    ],
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
};

pub(super) const G: Row = Row {
    name: "g",
    title: "tall conifer with drooping branches",
    paper_seconds: Some(3.0),
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, 14.9, 0.0], radius: STEM },
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
};

pub(super) const J: Row = Row {
    name: "j",
    title: "larch: a cone of cones",
    paper_seconds: Some(3.2),
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, 10.4, 0.0], radius: STEM },
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
};

pub(super) const L: Row = Row {
    name: "l",
    title: "cypress: a slim cone, branches hugging the stem",
    paper_seconds: Some(1.3),
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, 7.9, 0.0], radius: STEM },
        Part::Cone { base: [0.0, -0.01, 0.0], top: [0.0, 8.0, 0.0], radius: 0.9 },
    ],
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
};
