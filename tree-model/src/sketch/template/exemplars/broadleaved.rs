//! Broad-leaved trees.

use super::row::{ARMS, Arms, LATERALS, LEAVES, Laterals, ROW, Row, SPIRAL, TWIGS, Toward, Twigs};
use crate::foliage::{LeafParams, Phyllotaxis};

pub(super) const OAK: Row = Row {
    name: "oak",
    title: "an oak in a meadow, round",
    height: 12.0,
    trunk_radius: 0.5,
    leader: 0.62,
    sway: 0.02,
    arms: &[Arms {
        count: 14,
        height: [0.22, 0.6],
        angle: [82.0, 24.0],
        length: [0.4, 0.42, 0.36],
        bend: 14.0,
        ..ARMS
    }],
    laterals: Some(Laterals { count: 5, angle: 52.0, length: 0.42, turn: 150.0, ..LATERALS }),
    low: 0.2,
    ..ROW
};

pub(super) const BEECH: Row = Row {
    name: "beech",
    title: "a broad beech, boughs sweeping from low down to a high dome",
    species: "beech",
    bark: "smooth",
    height: 18.0,
    trunk_radius: 0.55,
    leader: 0.8,
    arms: &[Arms {
        count: 24,
        height: [0.13, 0.78],
        angle: [66.0, 30.0],
        length: [0.42, 0.42, 0.2],
        bend: 12.0,
        ..ARMS
    }],
    laterals: Some(Laterals { count: 4, angle: 48.0, length: 0.35, turn: 180.0, ..LATERALS }),
    twigs: Some(Twigs { spacing: 0.05, size: 0.07, ..TWIGS }),
    leaves: Some(("beech-cluster", LeafParams { size: 0.5, spacing: 0.13, ..LEAVES })),
    ..ROW
};

pub(super) const ELM: Row = Row {
    name: "elm",
    title: "a vase: limbs that rise steeply from one point and arch outwards",
    species: "linden",
    height: 16.0,
    trunk_radius: 0.42,
    leader: 0.27,
    arms: &[Arms {
        count: 9,
        height: [0.2, 0.27],
        angle: [29.0, 7.0],
        length: [0.74, 0.74, 0.72],
        bend: -30.0,
        bare: 0.4,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 5,
        angle: 34.0,
        length: 0.32,
        bend: -20.0,
        turn: 170.0,
        ..LATERALS
    }),
    twigs: Some(Twigs { size: 0.075, ..TWIGS }),
    leaves: Some(("linden-cluster", LeafParams { size: 0.46, ..LEAVES })),
    ..ROW
};

pub(super) const POPLAR: Row = Row {
    name: "poplar",
    title: "a Lombardy poplar: a column, branches close along the trunk",
    species: "poplar",
    height: 20.0,
    trunk_radius: 0.34,
    leader: 0.97,
    arms: &[Arms {
        count: 34,
        height: [0.06, 0.84],
        angle: [24.0, 18.0],
        length: [0.2, 0.24, 0.09],
        bend: 10.0,
        bare: 0.2,
        ..ARMS
    }],
    laterals: None,
    twigs: Some(Twigs {
        spacing: 0.035,
        size: 0.05,
        angle: 50.0,
        toward: Toward::Up,
        on_trunk: true,
        ..TWIGS
    }),
    leaves: Some(("poplar-cluster", LeafParams { size: 0.45, ..LEAVES })),
    ..ROW
};

pub(super) const BIRCH: Row = Row {
    name: "birch",
    title: "a birch: a slender leader, ascending branches, hanging twigs",
    species: "birch",
    bark: "birch",
    height: 14.0,
    trunk_radius: 0.2,
    leader: 0.95,
    sway: 0.02,
    arms: &[Arms {
        count: 18,
        height: [0.27, 0.88],
        angle: [44.0, 30.0],
        length: [0.3, 0.26, 0.12],
        bend: -30.0,
        ..ARMS
    }],
    laterals: Some(Laterals { count: 3, angle: 38.0, length: 0.4, bend: -45.0, ..LATERALS }),
    twigs: Some(Twigs {
        spacing: 0.045,
        size: 0.09,
        branching: 3,
        angle: 40.0,
        toward: Toward::Down,
        ..TWIGS
    }),
    leaves: Some(("birch-cluster", LeafParams { size: 0.34, spacing: 0.1, droop: 0.5, ..LEAVES })),
    ..ROW
};

pub(super) const WILLOW: Row = Row {
    name: "willow",
    title: "a weeping willow: limbs arch over, branches hang to the ground",
    species: "willow",
    height: 12.0,
    trunk_radius: 0.5,
    leader: 0.36,
    sway: 0.02,
    arms: &[Arms {
        count: 8,
        height: [0.28, 0.36],
        angle: [40.0, 6.0],
        length: [0.82, 0.86, 0.9],
        bend: -105.0,
        bare: 0.3,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 6,
        angle: 50.0,
        length: 0.62,
        bend: -130.0,
        turn: 180.0,
        from_length: 0.1,
    }),
    twigs: Some(Twigs {
        spacing: 0.035,
        size: 0.2,
        branching: 2,
        angle: 12.0,
        toward: Toward::Down,
        ..TWIGS
    }),
    leaves: Some((
        "willow-cluster",
        LeafParams {
            spacing: 0.09,
            bearing: 2.4,
            size: 0.42,
            pitch: 0.5,
            droop: 0.75,
            phototropism: 0.2,
            ..LEAVES
        },
    )),
    ..ROW
};

pub(super) const ACACIA: Row = Row {
    name: "acacia",
    title: "an umbrella thorn: limbs fan out under a flat top",
    species: "mimosa",
    height: 7.5,
    trunk_radius: 0.24,
    leader: 0.4,
    sway: 0.03,
    arms: &[
        Arms {
            count: 8,
            height: [0.31, 0.4],
            angle: [46.0, 38.0],
            length: [0.82, 0.76, 0.7],
            bend: -22.0,
            bare: 0.45,
            ..ARMS
        },
        Arms {
            count: 3,
            height: [0.4, 0.4],
            angle: [16.0, 20.0],
            length: [0.5, 0.5, 0.5],
            bend: -24.0,
            bare: 0.45,
            ..ARMS
        },
    ],
    laterals: Some(Laterals {
        count: 5,
        angle: 38.0,
        length: 0.36,
        bend: -6.0,
        turn: 180.0,
        ..LATERALS
    }),
    twigs: Some(Twigs {
        spacing: 0.05,
        size: 0.085,
        branching: 4,
        angle: 80.0,
        toward: Toward::Up,
        ..TWIGS
    }),
    leaves: Some((
        "beech-cluster",
        LeafParams { size: 0.22, spacing: 0.07, bearing: 0.5, ..LEAVES },
    )),
    ..ROW
};

pub(super) const HAZEL: Row = Row {
    name: "hazel",
    title: "a shrub: many stems from the ground",
    species: "linden",
    bark: "smooth",
    height: 4.5,
    trunk_radius: 0.15,
    leader: 0.0,
    arms: &[Arms {
        count: 12,
        height: [0.02, 0.02],
        angle: [34.0, 5.0],
        length: [0.85, 0.95, 0.95],
        bend: -16.0,
        bare: 0.35,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 4,
        angle: 38.0,
        length: 0.28,
        bend: 6.0,
        turn: 180.0,
        ..LATERALS
    }),
    twigs: Some(Twigs { spacing: 0.07, size: 0.085, branching: 3, ..TWIGS }),
    leaves: Some((
        "linden-cluster",
        LeafParams { size: 0.24, spacing: 0.09, bearing: 0.4, ..LEAVES },
    )),
    ..ROW
};

pub(super) const APPLE: Row = Row {
    name: "apple",
    title: "an old apple tree: low, wide, open",
    species: "beech",
    height: 5.0,
    trunk_radius: 0.2,
    leader: 0.34,
    sway: 0.03,
    arms: &[Arms {
        count: 6,
        height: [0.27, 0.34],
        angle: [70.0, 38.0],
        length: [0.72, 0.7, 0.62],
        bend: 22.0,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 5,
        angle: 56.0,
        length: 0.42,
        bend: 25.0,
        turn: 140.0,
        ..LATERALS
    }),
    twigs: Some(Twigs { spacing: 0.08, size: 0.1, branching: 4, ..TWIGS }),
    low: 0.15,
    leaves: Some((
        "beech-cluster",
        LeafParams { size: 0.24, spacing: 0.075, bearing: 0.4, ..LEAVES },
    )),
    ..ROW
};

pub(super) const MAPLE: Row = Row {
    name: "maple",
    title: "a maple that forks into two stems under an egg-shaped crown",
    species: "maple",
    bark: "smooth",
    height: 14.0,
    trunk_radius: 0.36,
    leader: 0.2,
    arms: &[Arms {
        count: 2,
        whorl: 2,
        height: [0.2, 0.2],
        angle: [17.0, 17.0],
        length: [0.74, 0.74, 0.74],
        bend: 12.0,
        bare: 0.2,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 11,
        angle: 44.0,
        length: 0.46,
        bend: 18.0,
        turn: SPIRAL,
        ..LATERALS
    }),
    twigs: Some(Twigs { spacing: 0.045, size: 0.1, ..TWIGS }),
    leaves: Some((
        "maple-cluster",
        LeafParams { arrangement: Phyllotaxis::Decussate, size: 0.48, spacing: 0.14, ..LEAVES },
    )),
    ..ROW
};

pub(super) const BAOBAB: Row = Row {
    name: "baobab",
    title: "a baobab: a huge trunk, a crown of short stout limbs at its top",
    species: "horse-chestnut",
    bark: "smooth",
    height: 13.0,
    trunk_radius: 1.5,
    pipe_exponent: 1.9,
    leader: 0.62,
    sway: 0.008,
    arms: &[Arms {
        count: 12,
        height: [0.55, 0.62],
        angle: [82.0, 22.0],
        length: [0.5, 0.46, 0.36],
        bend: 14.0,
        bare: 0.4,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 4,
        angle: 55.0,
        length: 0.38,
        bend: 15.0,
        turn: 150.0,
        ..LATERALS
    }),
    twigs: Some(Twigs { spacing: 0.06, size: 0.045, branching: 3, ..TWIGS }),
    low: 0.2,
    leaves: Some((
        "linden-cluster",
        LeafParams { size: 0.26, spacing: 0.14, bearing: 0.4, ..LEAVES },
    )),
    ..ROW
};

pub(super) const SNAG: Row = Row {
    name: "snag",
    title: "a dead tree: a broken top and a few stubs of limbs",
    bark: "oak",
    height: 9.0,
    trunk_radius: 0.38,
    pipe_exponent: 2.1,
    leader: 1.0,
    sway: 0.035,
    arms: &[Arms {
        count: 8,
        height: [0.3, 0.9],
        angle: [72.0, 52.0],
        length: [0.3, 0.22, 0.13],
        bend: 18.0,
        bare: 0.35,
        ..ARMS
    }],
    laterals: Some(Laterals {
        count: 2,
        angle: 58.0,
        length: 0.36,
        bend: 0.0,
        turn: 160.0,
        ..LATERALS
    }),
    twigs: None,
    low: 0.12,
    smoothing: 2,
    leaves: None,
    ..ROW
};

pub(super) const SAPLING: Row = Row {
    name: "sapling",
    title: "a sapling: a thin stem, a few thin branches",
    species: "ash",
    bark: "smooth",
    height: 3.0,
    trunk_radius: 0.03,
    leader: 0.96,
    sway: 0.02,
    arms: &[Arms {
        count: 8,
        whorl: 2,
        turn: 90.0,
        height: [0.42, 0.82],
        angle: [48.0, 36.0],
        length: [0.3, 0.26, 0.16],
        bend: 14.0,
        bare: 0.3,
    }],
    laterals: None,
    twigs: Some(Twigs { spacing: 0.09, size: 0.06, branching: 2, ..TWIGS }),
    leaves: Some((
        "beech-cluster",
        LeafParams {
            arrangement: Phyllotaxis::Decussate,
            size: 0.2,
            spacing: 0.09,
            bearing: 0.25,
            ..LEAVES
        },
    )),
    ..ROW
};
