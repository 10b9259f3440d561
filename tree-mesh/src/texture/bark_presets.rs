//! The built-in barks, a row each.

use super::bark::{BarkStyle, Lenticels, Patches};
use std::borrow::Cow;
use tree_core::Seed;

const fn lichen(color: [u8; 3], share: f32) -> Patches {
    Patches { color, count: [5, 5], share, softness: 0.3, opacity: 0.6, roughness: 0.2 }
}

const BASE: BarkStyle = BarkStyle::DEFAULT;

pub(super) const TABLE: &[(&str, BarkStyle)] = &[
    (
        "oak",
        BarkStyle {
            seed: Seed(1),
            ridge: [156, 141, 122],
            furrow: [52, 43, 36],
            tint: [120, 112, 94],
            tinting: 0.5,
            plates: [10, 2],
            crack: 0.26,
            plate_contrast: 0.12,
            furrows: [16, 5],
            furrow_width: 0.22,
            warp: 0.03,
            grain: [48, 14],
            grain_height: 0.6,
            patches: Cow::Borrowed(&[lichen([136, 142, 116], 0.15)]),
            furrow_depth: 0.55,
            ragged: 0.65,
            relief: 0.9,
            ..BASE
        },
    ),
    (
        "birch",
        BarkStyle {
            seed: Seed(2),
            ridge: [228, 224, 215],
            furrow: [176, 166, 152],
            tint: [206, 192, 172],
            tinting: 0.5,
            plates: [0, 0],
            furrows: [0, 0],
            warp: 0.04,
            grain: [4, 80],
            grain_height: 0.1,
            rings: 14,
            ring_contrast: 0.12,
            patches: Cow::Borrowed(&[
                Patches {
                    color: [203, 170, 140],
                    count: [3, 9],
                    share: 0.13,
                    softness: 0.25,
                    opacity: 0.45,
                    roughness: 0.1,
                },
                Patches {
                    color: [56, 50, 45],
                    count: [2, 5],
                    share: 0.16,
                    softness: 0.14,
                    opacity: 0.95,
                    roughness: 0.9,
                },
            ]),
            lenticels: Some(Lenticels {
                color: [62, 54, 48],
                count: [5, 34],
                share: 0.45,
                length: 1.0,
                thickness: 0.45,
            }),
            relief: 0.6,
            ragged: 0.5,
            ..BASE
        },
    ),
    (
        "pine",
        BarkStyle {
            seed: Seed(3),
            ridge: [158, 108, 80],
            furrow: [46, 33, 28],
            tint: [128, 108, 96],
            tinting: 0.7,
            plates: [6, 3],
            crack: 0.2,
            plate_contrast: 0.16,
            furrows: [0, 0],
            warp: 0.05,
            flakes: 0.6,
            grain: [26, 16],
            grain_height: 0.3,
            ragged: 0.8,
            ..BASE
        },
    ),
    (
        "smooth",
        BarkStyle {
            seed: Seed(4),
            ridge: [150, 147, 140],
            furrow: [98, 94, 86],
            tint: [130, 129, 120],
            tinting: 0.6,
            plates: [0, 0],
            furrows: [0, 0],
            warp: 0.03,
            grain: [18, 26],
            grain_height: 0.14,
            rings: 9,
            ring_contrast: 0.14,
            patches: Cow::Borrowed(&[lichen([182, 183, 170], 0.3), lichen([112, 116, 100], 0.2)]),
            relief: 0.7,
            ragged: 0.7,
            ..BASE
        },
    ),
    (
        "spruce",
        BarkStyle {
            seed: Seed(5),
            ridge: [134, 112, 98],
            furrow: [58, 46, 40],
            tint: [138, 126, 114],
            tinting: 0.8,
            plates: [11, 9],
            crack: 0.14,
            plate_contrast: 0.2,
            furrows: [0, 0],
            warp: 0.04,
            flakes: 0.8,
            grain: [30, 24],
            grain_height: 0.3,
            ragged: 1.0,
            relief: 0.8,
            ..BASE
        },
    ),
    (
        "cherry",
        BarkStyle {
            seed: Seed(6),
            ridge: [112, 78, 68],
            furrow: [62, 44, 40],
            tint: [132, 104, 92],
            tinting: 0.6,
            plates: [0, 0],
            furrows: [0, 0],
            warp: 0.02,
            grain: [3, 36],
            grain_height: 0.15,
            rings: 7,
            ring_contrast: 0.2,
            lenticels: Some(Lenticels {
                color: [176, 138, 110],
                count: [4, 24],
                share: 0.6,
                length: 1.0,
                thickness: 0.8,
            }),
            relief: 0.6,
            ..BASE
        },
    ),
    (
        "palm",
        BarkStyle {
            seed: Seed(7),
            ridge: [142, 126, 106],
            furrow: [84, 70, 56],
            tint: [118, 108, 94],
            tinting: 0.5,
            plates: [0, 0],
            furrows: [26, 2],
            furrow_width: 0.12,
            warp: 0.01,
            grain: [36, 8],
            grain_height: 0.3,
            rings: 7,
            ring_contrast: 0.7,
            ..BASE
        },
    ),
];
