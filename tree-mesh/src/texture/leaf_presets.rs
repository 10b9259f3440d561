//! The built-in leaves, a row each.

use super::leaf::{LeafShape, LeafStyle, Teeth, Veins};
use super::spray::Spray;
use std::borrow::Cow;
use tree_core::Seed;

const fn teeth(count: u32, depth: f32, sharpness: f32) -> Teeth {
    Teeth { count, depth, sharpness, double: false }
}

const fn style(base: [u8; 3], autumn: [u8; 3]) -> LeafStyle {
    LeafStyle { base, autumn, ..LeafStyle::DEFAULT }
}

/// Secondary veins on the midrib alone.
const PINNATE: Veins = LeafShape::DEFAULT.veins;

const OAK: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.6],
        [0.05, 0.025, 0.0],
        [0.055, 0.09, 0.0],
        [0.135, 0.16, 0.0],
        [0.15, 0.225, 0.0],
        [0.085, 0.27, 0.0],
        [0.205, 0.365, 0.0],
        [0.215, 0.435, 0.0],
        [0.11, 0.47, 0.0],
        [0.275, 0.57, 0.0],
        [0.285, 0.645, 0.0],
        [0.155, 0.675, 0.0],
        [0.25, 0.775, 0.0],
        [0.235, 0.85, 0.0],
        [0.13, 0.855, 0.0],
        [0.14, 0.93, 0.0],
        [0.095, 0.985, 0.0],
        [0.0, 1.0, 0.0],
    ]),
    petiole: 0.07,
    veins: Veins { pairs: 5.0, slope: 0.72, contrast: 0.55, ..PINNATE },
    style: style([84, 110, 46], [150, 96, 44]),
    ..LeafShape::DEFAULT
};

const MAPLE: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.3],
        [0.09, -0.05, 0.0],
        [0.2, -0.075, 0.2],
        [0.37, -0.05, 1.0],
        [0.30, 0.06, 0.6],
        [0.44, 0.12, 1.0],
        [0.43, 0.225, 0.6],
        [0.60, 0.29, 1.0],
        [0.545, 0.345, 0.7],
        [0.60, 0.47, 1.0],
        [0.46, 0.445, 0.6],
        [0.42, 0.54, 1.0],
        [0.31, 0.475, 0.3],
        [0.19, 0.43, 0.0],
        [0.185, 0.56, 0.2],
        [0.285, 0.69, 1.0],
        [0.175, 0.70, 0.6],
        [0.165, 0.81, 1.0],
        [0.09, 0.81, 0.6],
        [0.0, 1.0, 1.0],
    ]),
    petiole: 0.3,
    veins: Veins { rays: Cow::Borrowed(&[0.9, 1.72]), pairs: 8.0, slope: 0.9, contrast: 0.55 },
    style: LeafStyle {
        base: [92, 122, 48],
        stalk: [150, 96, 66],
        autumn: [200, 84, 36],
        ..LeafStyle::DEFAULT
    },
    ..LeafShape::DEFAULT
};

const BIRCH: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.16, 0.02, 0.2],
        [0.30, 0.13, 0.0],
        [0.34, 0.25, 0.0],
        [0.285, 0.42, 0.0],
        [0.19, 0.61, 0.0],
        [0.09, 0.79, 0.0],
        [0.03, 0.92, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: Teeth { count: 11, depth: 0.036, sharpness: 1.0, double: true },
    petiole: 0.25,
    veins: Veins { pairs: 8.0, slope: 0.95, contrast: 0.5, ..PINNATE },
    style: style([98, 126, 52], [214, 176, 56]),
    ..LeafShape::DEFAULT
};

const BEECH: LeafShape = LeafShape {
    teeth: teeth(9, 0.016, 0.0),
    petiole: 0.1,
    veins: Veins { pairs: 9.0, slope: 0.85, contrast: 0.6, ..PINNATE },
    style: style([82, 112, 44], [186, 112, 46]),
    ..LeafShape::DEFAULT
};

const WILLOW: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.045, 0.08, 0.0],
        [0.078, 0.25, 0.0],
        [0.085, 0.42, 0.0],
        [0.07, 0.63, 0.0],
        [0.038, 0.83, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: teeth(26, 0.006, 1.0),
    petiole: 0.07,
    veins: Veins { pairs: 14.0, slope: 1.6, contrast: 0.5, ..PINNATE },
    style: style([104, 126, 62], [204, 182, 76]),
    ..LeafShape::DEFAULT
};

const POPLAR: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.6],
        [0.2, 0.0, 0.0],
        [0.36, 0.07, 0.0],
        [0.41, 0.18, 0.0],
        [0.36, 0.34, 0.0],
        [0.24, 0.55, 0.0],
        [0.12, 0.77, 0.0],
        [0.045, 0.91, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: teeth(17, 0.02, 0.35),
    petiole: 0.38,
    veins: Veins { pairs: 6.0, slope: 0.8, contrast: 0.55, ..PINNATE },
    style: style([90, 122, 54], [222, 178, 54]),
    ..LeafShape::DEFAULT
};

const LINDEN: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.8],
        [0.06, -0.065, 0.0],
        [0.2, -0.09, 0.0],
        [0.37, -0.01, 0.0],
        [0.46, 0.2, 0.0],
        [0.43, 0.42, 0.0],
        [0.31, 0.65, 0.0],
        [0.14, 0.83, 0.0],
        [0.05, 0.91, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: teeth(22, 0.024, 0.9),
    petiole: 0.28,
    veins: Veins { rays: Cow::Borrowed(&[0.75]), pairs: 7.0, slope: 0.8, contrast: 0.5 },
    style: style([86, 118, 50], [208, 176, 62]),
    ..LeafShape::DEFAULT
};

/// Leaflet of ash and its like.
const ASH: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.08, 0.1, 0.0],
        [0.15, 0.35, 0.0],
        [0.14, 0.58, 0.0],
        [0.08, 0.82, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: teeth(14, 0.012, 0.9),
    petiole: 0.03,
    veins: Veins { pairs: 10.0, slope: 0.9, contrast: 0.5, ..PINNATE },
    style: style([80, 114, 48], [196, 178, 70]),
    ..LeafShape::DEFAULT
};

/// Leaflet of walnut: broad, with an entire margin.
const WALNUT: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.0],
        [0.07, 0.035, 0.0],
        [0.17, 0.18, 0.0],
        [0.215, 0.42, 0.0],
        [0.19, 0.66, 0.0],
        [0.105, 0.87, 0.0],
        [0.035, 0.96, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    petiole: 0.0,
    veins: Veins { pairs: 12.0, slope: 0.7, contrast: 0.55, ..PINNATE },
    style: style([90, 118, 50], [190, 156, 62]),
    ..LeafShape::DEFAULT
};

/// Leaflet of horse chestnut: a wedge, widest near its short point.
const HORSE_CHESTNUT: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 0.0],
        [0.02, 0.015, 0.0],
        [0.055, 0.2, 0.0],
        [0.12, 0.45, 0.0],
        [0.185, 0.68, 0.0],
        [0.175, 0.83, 0.0],
        [0.1, 0.93, 0.0],
        [0.03, 0.965, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    teeth: Teeth { count: 18, depth: 0.018, sharpness: 0.9, double: true },
    petiole: 0.0,
    veins: Veins { pairs: 17.0, slope: 0.85, contrast: 0.6, ..PINNATE },
    style: style([78, 108, 44], [176, 112, 46]),
    ..LeafShape::DEFAULT
};

/// Leaflet of silk tree and mimosa, a finger's breadth long: a blunt strap.
const MIMOSA: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.05, 0.04, 0.0],
        [0.11, 0.15, 0.0],
        [0.135, 0.45, 0.0],
        [0.12, 0.75, 0.0],
        [0.065, 0.93, 0.0],
        [0.0, 1.0, 0.7],
    ]),
    petiole: 0.0,
    veins: Veins { pairs: 6.0, slope: 1.6, contrast: 0.35, ..PINNATE },
    style: style([92, 124, 56], [196, 172, 72]),
    ..LeafShape::DEFAULT
};

/// Leaflet of a palm.
const BLADE: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.03, 0.06, 0.0],
        [0.038, 0.35, 0.0],
        [0.03, 0.7, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    petiole: 0.0,
    veins: Veins { pairs: 0.0, slope: 0.0, contrast: 0.5, ..PINNATE },
    style: style([86, 118, 52], [172, 150, 84]),
    ..LeafShape::DEFAULT
};

const NEEDLE: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.015, 0.1, 0.0],
        [0.017, 0.7, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    petiole: 0.0,
    veins: Veins { pairs: 0.0, slope: 0.0, contrast: 0.25, ..PINNATE },
    style: style([78, 108, 62], [150, 140, 70]),
    ..LeafShape::DEFAULT
};

const SHORT_NEEDLE: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.05, 0.12, 0.0],
        [0.055, 0.7, 0.0],
        [0.0, 1.0, 0.6],
    ]),
    style: style([66, 98, 58], [120, 120, 62]),
    ..NEEDLE
};

/// Wider than nature grows it by half, so that it is not lost in a picture.
const SINGLE_NEEDLE: LeafShape = LeafShape {
    outline: Cow::Borrowed(&[
        [0.0, 0.0, 1.0],
        [0.015, 0.05, 0.0],
        [0.023, 0.16, 0.0],
        [0.025, 0.55, 0.0],
        [0.016, 0.86, 0.0],
        [0.0, 1.0, 1.0],
    ]),
    ..NEEDLE
};

const SPRAY: Spray = Spray { bare: 0.12, size: [0.46, 0.52, 0.44], shoots: 2, ..Spray::DEFAULT };

pub(super) const TABLE: &[(&str, LeafShape)] = &[
    ("oak", OAK),
    ("maple", MAPLE),
    ("birch", BIRCH),
    ("beech", BEECH),
    ("willow", WILLOW),
    ("poplar", POPLAR),
    ("linden", LINDEN),
    (
        "ash",
        LeafShape {
            seed: Seed(8),
            spray: Some(Spray {
                leaves: 11,
                opposite: true,
                bare: 0.2,
                angle: [1.05, 0.8],
                size: [0.34, 0.42, 0.4],
                jitter: 0.15,
                twig: 0.016,
                twig_color: [110, 120, 66],
                ..Spray::DEFAULT
            }),
            ..ASH
        },
    ),
    (
        "oak-cluster",
        LeafShape {
            seed: Seed(11),
            spray: Some(Spray { leaves: 9, size: [0.5, 0.56, 0.5], ..SPRAY }),
            ..OAK
        },
    ),
    (
        "maple-cluster",
        LeafShape {
            seed: Seed(12),
            spray: Some(Spray { leaves: 7, opposite: true, size: [0.58, 0.62, 0.52], ..SPRAY }),
            ..MAPLE
        },
    ),
    (
        "birch-cluster",
        LeafShape { seed: Seed(13), spray: Some(Spray { leaves: 11, ..SPRAY }), ..BIRCH },
    ),
    (
        "beech-cluster",
        LeafShape { seed: Seed(14), spray: Some(Spray { leaves: 10, ..SPRAY }), ..BEECH },
    ),
    (
        "willow-cluster",
        LeafShape {
            seed: Seed(15),
            spray: Some(Spray {
                leaves: 14,
                angle: [0.75, 0.3],
                size: [0.42, 0.46, 0.4],
                bend: 0.12,
                shoots: 2,
                shoot_angle: 0.5,
                ..SPRAY
            }),
            ..WILLOW
        },
    ),
    (
        "poplar-cluster",
        LeafShape {
            seed: Seed(16),
            spray: Some(Spray { leaves: 10, size: [0.6, 0.64, 0.54], ..SPRAY }),
            ..POPLAR
        },
    ),
    (
        "linden-cluster",
        LeafShape { seed: Seed(17), spray: Some(Spray { leaves: 8, ..SPRAY }), ..LINDEN },
    ),
    (
        "pine-needles",
        LeafShape {
            seed: Seed(21),
            spray: Some(Spray {
                leaves: 130,
                bare: 0.2,
                angle: [1.2, 0.25],
                size: [0.46, 0.52, 0.46],
                jitter: 0.7,
                bend: 0.06,
                twig: 0.024,
                twig_color: [122, 92, 62],
                ..Spray::DEFAULT
            }),
            ..NEEDLE
        },
    ),
    (
        "spruce-needles",
        LeafShape {
            seed: Seed(22),
            spray: Some(Spray {
                leaves: 110,
                bare: 0.05,
                angle: [1.1, 0.35],
                size: [0.13, 0.14, 0.11],
                jitter: 0.5,
                bend: 0.08,
                twig: 0.02,
                twig_color: [120, 88, 58],
                shoots: 6,
                shoot_angle: 0.9,
                shoot_size: 0.62,
                ..SPRAY
            }),
            ..SHORT_NEEDLE
        },
    ),
    (
        "palm-frond",
        LeafShape {
            seed: Seed(23),
            spray: Some(Spray {
                leaves: 71,
                opposite: true,
                bare: 0.15,
                angle: [1.4, 0.45],
                size: [0.36, 0.5, 0.24],
                jitter: 0.2,
                bend: 0.05,
                twig: 0.022,
                twig_color: [134, 134, 76],
                ..Spray::DEFAULT
            }),
            ..BLADE
        },
    ),
    ("ash-leaflet", LeafShape { petiole: 0.0, ..ASH }),
    ("walnut-leaflet", WALNUT),
    ("horse-chestnut-leaflet", HORSE_CHESTNUT),
    ("mimosa-leaflet", MIMOSA),
    ("palm-leaflet", BLADE),
    ("needle", SINGLE_NEEDLE),
];
