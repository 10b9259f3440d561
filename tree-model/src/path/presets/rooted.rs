//! Trees with root systems (Fig. 15).

use super::row::{GROUND, LEAVES, LEVEL, Leader, LeafRow, LevelRow, Part, ROW, Row, Shape};

pub(super) const TAPROOT: Row = Row {
    name: "taproot",
    title: "a taproot with laterals",
    roots: Some(&TAPROOT_BELOW),
    ..ROOTED
};

pub(super) const HEARTROOT: Row = Row {
    name: "heartroot",
    title: "wide, shallow roots",
    roots: Some(&HEARTROOT_BELOW),
    ..ROOTED
};

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
const TAPROOT_BELOW: Row = Row {
    name: "taproot",
    title: "roots",
    base: &[
        Part::Cylinder { base: GROUND, top: [0.0, -2.6, 0.0], radius: 0.08 },
        Part::Ellipsoid { center: [0.0, -1.3, 0.0], radii: [1.5, 1.35, 1.5] },
    ],
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

const HEARTROOT_BELOW: Row = Row {
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
