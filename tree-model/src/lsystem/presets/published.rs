//! The L-systems of the books and papers. Constants are those of ABOP's tables 2.1 to 2.3.

use super::row::{ROW, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        name: "thesis-a",
        title: "a weed",
        source: "Neubert 2012, Fig. 2.1 a",
        text: include_str!("text/thesis-a.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "thesis-b",
        title: "a shoot with opposite branches",
        source: "Neubert 2012, Fig. 2.1 b",
        text: include_str!("text/thesis-b.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "thesis-c",
        title: "a tuft",
        source: "Neubert 2012, Fig. 2.1 c",
        text: include_str!("text/thesis-c.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24a",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 a",
        text: include_str!("text/abop-1.24a.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24b",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 b",
        text: include_str!("text/abop-1.24b.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24c",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 c",
        text: include_str!("text/abop-1.24c.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24d",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 d",
        text: include_str!("text/abop-1.24d.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24e",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 e",
        text: include_str!("text/abop-1.24e.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.24f",
        title: "a plane plant",
        source: "ABOP, Fig. 1.24 f",
        text: include_str!("text/abop-1.24f.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.25",
        title: "a bush",
        source: "ABOP, Fig. 1.25",
        text: include_str!("text/abop-1.25.l"),
        leaf_kind: Some("beech"),
        height: Some(1.5),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "abop-1.26",
        title: "a plant with flowers",
        source: "ABOP, Fig. 1.26",
        text: include_str!("text/abop-1.26.l"),
        leaf_kind: Some("beech"),
        height: Some(0.6),
        trunk_radius: 0.006,
        ..ROW
    },
    Row {
        name: "abop-1.27",
        title: "a stochastic weed",
        source: "ABOP, Fig. 1.27",
        text: include_str!("text/abop-1.27.l"),
        height: Some(2.0),
        trunk_radius: 0.02,
        ..ROW
    },
    Row {
        name: "honda-a",
        title: "a monopodial tree",
        source: "ABOP, Fig. 2.6 a; Honda 1971",
        text: include_str!("text/abop-2.6.l"),
        constants: &[("r1", 0.9), ("r2", 0.6), ("a0", 45.0), ("a2", 45.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "honda-b",
        title: "a monopodial tree",
        source: "ABOP, Fig. 2.6 b; Honda 1971",
        text: include_str!("text/abop-2.6.l"),
        constants: &[("r1", 0.9), ("r2", 0.9), ("a0", 45.0), ("a2", 45.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "honda-c",
        title: "a monopodial tree",
        source: "ABOP, Fig. 2.6 c; Honda 1971",
        text: include_str!("text/abop-2.6.l"),
        constants: &[("r1", 0.9), ("r2", 0.8), ("a0", 45.0), ("a2", 45.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "honda-d",
        title: "a monopodial tree",
        source: "ABOP, Fig. 2.6 d; Honda 1971",
        text: include_str!("text/abop-2.6.l"),
        constants: &[("r1", 0.9), ("r2", 0.7), ("a0", 30.0), ("a2", -30.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "aono-kunii-a",
        title: "a sympodial tree",
        source: "ABOP, Fig. 2.7 a; Aono & Kunii 1984",
        text: include_str!("text/abop-2.7.l"),
        constants: &[("r1", 0.9), ("r2", 0.7), ("a1", 5.0), ("a2", 65.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "aono-kunii-b",
        title: "a sympodial tree",
        source: "ABOP, Fig. 2.7 b; Aono & Kunii 1984",
        text: include_str!("text/abop-2.7.l"),
        constants: &[("r1", 0.9), ("r2", 0.7), ("a1", 10.0), ("a2", 60.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "aono-kunii-c",
        title: "a sympodial tree",
        source: "ABOP, Fig. 2.7 c; Aono & Kunii 1984",
        text: include_str!("text/abop-2.7.l"),
        constants: &[("r1", 0.9), ("r2", 0.8), ("a1", 20.0), ("a2", 50.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "aono-kunii-d",
        title: "a sympodial tree",
        source: "ABOP, Fig. 2.7 d; Aono & Kunii 1984",
        text: include_str!("text/abop-2.7.l"),
        constants: &[("r1", 0.9), ("r2", 0.8), ("a1", 35.0), ("a2", 35.0)],
        height: Some(5.0),
        trunk_radius: 0.12,
        ..ROW
    },
    Row {
        name: "ternary-a",
        title: "a ternary tree with tropism",
        source: "ABOP, Fig. 2.8 a",
        text: include_str!("text/abop-2.8.l"),
        constants: &[
            ("d1", 94.74),
            ("d2", 132.63),
            ("a", 18.95),
            ("lr", 1.109),
            ("elasticity", 0.22),
            ("tropism_x", 0.0),
            ("tropism_y", -1.0),
            ("tropism_z", 0.0),
            ("steps", 6.0),
        ],
        height: Some(6.0),
        trunk_radius: 0.15,
        ..ROW
    },
    Row {
        name: "ternary-b",
        title: "a ternary tree with tropism",
        source: "ABOP, Fig. 2.8 b",
        text: include_str!("text/abop-2.8.l"),
        constants: &[
            ("d1", 137.5),
            ("d2", 137.5),
            ("a", 18.95),
            ("lr", 1.109),
            ("elasticity", 0.14),
            ("tropism_x", 0.0),
            ("tropism_y", -1.0),
            ("tropism_z", 0.0),
            ("steps", 8.0),
        ],
        height: Some(6.0),
        trunk_radius: 0.15,
        ..ROW
    },
    Row {
        name: "ternary-c",
        title: "a ternary tree with tropism",
        source: "ABOP, Fig. 2.8 c",
        text: include_str!("text/abop-2.8.l"),
        constants: &[
            ("d1", 112.5),
            ("d2", 157.5),
            ("a", 22.5),
            ("lr", 1.79),
            ("elasticity", 0.27),
            ("tropism_x", -0.02),
            ("tropism_y", -1.0),
            ("tropism_z", 0.0),
            ("steps", 8.0),
        ],
        height: Some(6.0),
        trunk_radius: 0.15,
        ..ROW
    },
    Row {
        name: "ternary-d",
        title: "a ternary tree with tropism",
        source: "ABOP, Fig. 2.8 d",
        text: include_str!("text/abop-2.8.l"),
        constants: &[
            ("d1", 180.0),
            ("d2", 252.0),
            ("a", 36.0),
            ("lr", 1.07),
            ("elasticity", 0.4),
            ("tropism_x", -0.61),
            ("tropism_y", 0.77),
            ("tropism_z", -0.19),
            ("steps", 6.0),
        ],
        height: Some(6.0),
        trunk_radius: 0.15,
        ..ROW
    },
];
