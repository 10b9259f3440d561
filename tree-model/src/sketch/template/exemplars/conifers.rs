//! Conifers, and the palm, which like most of them has one straight trunk.

use super::row::{ARMS, Arms, LATERALS, LEAVES, Laterals, ROW, Row, SPIRAL, TWIGS, Toward, Twigs};
use crate::foliage::{LeafParams, Phyllotaxis};

const NEEDLES: LeafParams =
    LeafParams { size: 0.4, spacing: 0.08, bearing: 1.0, pitch: 0.6, droop: 0.1, ..LEAVES };

pub(super) const SPRUCE: Row = Row {
    name: "spruce",
    title: "a spruce: whorls of drooping branches, a broad cone to the ground",
    species: "spruce",
    bark: "spruce",
    height: 18.0,
    trunk_radius: 0.3,
    leader: 0.99,
    sway: 0.0,
    arms: &[Arms {
        count: 44,
        whorl: 4,
        turn: 50.0,
        height: [0.06, 0.94],
        angle: [100.0, 58.0],
        length: [0.3, 0.18, 0.04],
        bend: -6.0,
        bare: 0.15,
    }],
    laterals: Some(Laterals {
        count: 4,
        angle: 48.0,
        length: 0.34,
        bend: -12.0,
        turn: 180.0,
        from_length: 0.11,
    }),
    twigs: Some(Twigs {
        spacing: 0.024,
        size: 0.04,
        branching: 3,
        angle: 65.0,
        on_trunk: true,
        ..TWIGS
    }),
    low: 0.6,
    smoothing: 5,
    leaves: Some(("spruce-needles", LeafParams { size: 0.5, ..NEEDLES })),
    ..ROW
};

pub(super) const LARCH: Row = Row {
    name: "larch",
    title: "a larch: a slim open cone, level branches with upturned ends",
    species: "larch",
    bark: "pine",
    height: 17.0,
    trunk_radius: 0.26,
    leader: 0.99,
    sway: 0.008,
    arms: &[Arms {
        count: 28,
        whorl: 1,
        turn: SPIRAL,
        height: [0.2, 0.93],
        angle: [98.0, 66.0],
        length: [0.19, 0.15, 0.04],
        bend: 34.0,
        bare: 0.2,
    }],
    laterals: None,
    twigs: Some(Twigs { spacing: 0.026, size: 0.045, branching: 3, angle: 60.0, ..TWIGS }),
    low: 0.5,
    smoothing: 5,
    leaves: Some(("spruce-needles", LeafParams { size: 0.3, ..NEEDLES })),
    ..ROW
};

pub(super) const UMBRELLA_PINE: Row = Row {
    name: "umbrella pine",
    title: "a stone pine: a tall bare trunk, a shallow dome on ascending limbs",
    species: "pine",
    bark: "pine",
    height: 16.0,
    trunk_radius: 0.36,
    leader: 0.7,
    sway: 0.02,
    arms: &[Arms {
        count: 15,
        height: [0.6, 0.7],
        angle: [58.0, 12.0],
        length: [0.46, 0.36, 0.24],
        bend: -12.0,
        bare: 0.45,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 5,
        angle: 42.0,
        length: 0.4,
        bend: 16.0,
        turn: 160.0,
        ..LATERALS
    }),
    twigs: Some(Twigs { spacing: 0.035, size: 0.055, branching: 4, toward: Toward::Up, ..TWIGS }),
    leaves: Some(("pine-needles", LeafParams { size: 0.44, droop: 0.0, ..NEEDLES })),
    ..ROW
};

pub(super) const CEDAR: Row = Row {
    name: "cedar",
    title: "a cedar: level tiers of boughs, far apart",
    species: "larch",
    bark: "pine",
    height: 17.0,
    trunk_radius: 0.5,
    leader: 0.92,
    sway: 0.01,
    arms: &[Arms {
        count: 15,
        whorl: 3,
        turn: 40.0,
        height: [0.2, 0.86],
        angle: [76.0, 74.0],
        length: [0.42, 0.37, 0.2],
        bend: -14.0,
        bare: 0.3,
    }],
    laterals: Some(Laterals {
        count: 6,
        angle: 46.0,
        length: 0.4,
        bend: 0.0,
        turn: 180.0,
        ..LATERALS
    }),
    twigs: Some(Twigs {
        spacing: 0.03,
        size: 0.04,
        branching: 4,
        angle: 80.0,
        toward: Toward::Up,
        ..TWIGS
    }),
    low: 0.4,
    leaves: Some(("spruce-needles", LeafParams { size: 0.42, ..NEEDLES })),
    ..ROW
};

pub(super) const CYPRESS: Row = Row {
    name: "cypress",
    title: "an Italian cypress: a spindle, short branches pressed to the trunk",
    species: "spruce",
    bark: "smooth",
    height: 13.0,
    trunk_radius: 0.2,
    leader: 0.98,
    sway: 0.0,
    arms: &[Arms {
        count: 40,
        height: [0.03, 0.9],
        angle: [26.0, 16.0],
        length: [0.08, 0.13, 0.05],
        bend: 14.0,
        bare: 0.2,
        ..ARMS
    }],
    laterals: None,
    twigs: Some(Twigs {
        spacing: 0.026,
        size: 0.03,
        angle: 50.0,
        toward: Toward::Up,
        on_trunk: true,
        ..TWIGS
    }),
    low: 0.6,
    leaves: Some(("spruce-needles", LeafParams { size: 0.36, pitch: 0.35, droop: 0.0, ..NEEDLES })),
    ..ROW
};

pub(super) const ARAUCARIA: Row = Row {
    name: "araucaria",
    title: "a monkey puzzle: a tall trunk, a parasol of rope-like branches in whorls, turned up at their ends",
    species: "spruce",
    bark: "pine",
    height: 18.0,
    trunk_radius: 0.36,
    pipe_exponent: 2.0,
    leader: 0.94,
    sway: 0.0,
    arms: &[Arms {
        count: 25,
        whorl: 5,
        turn: 36.0,
        height: [0.56, 0.93],
        angle: [105.0, 62.0],
        length: [0.34, 0.29, 0.12],
        bend: 46.0,
        bare: 0.35,
    }],
    laterals: None,
    twigs: Some(Twigs { spacing: 0.02, size: 0.022, branching: 2, angle: 80.0, ..TWIGS }),
    low: 0.6,
    smoothing: 6,
    leaves: Some(("spruce-needles", LeafParams { size: 0.55, spacing: 0.05, ..NEEDLES })),
};

pub(super) const PALM: Row = Row {
    name: "palm",
    title: "a palm: a bare trunk, a head of arching fronds",
    species: "palm",
    bark: "palm",
    height: 9.0,
    trunk_radius: 0.17,
    pipe_exponent: 2.6,
    leader: 0.8,
    sway: 0.03,
    arms: &[Arms {
        count: 22,
        height: [0.76, 0.8],
        angle: [100.0, 12.0],
        length: [0.3, 0.34, 0.28],
        bend: -72.0,
        bare: 0.15,
        ..ARMS
    }],
    laterals: None,
    twigs: None,
    low: 0.7,
    smoothing: 5,
    leaves: Some((
        "palm-leaflet",
        LeafParams {
            arrangement: Phyllotaxis::Distichous,
            spacing: 0.045,
            bearing: 2.5,
            size: 0.6,
            pitch: 0.9,
            droop: 0.35,
            phototropism: 0.1,
            jitter: 0.12,
            ..LeafParams::DEFAULT
        },
    )),
};
