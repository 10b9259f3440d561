//! Leafy species of ours: in metres, with radii by the pipe model, different for every seed.

use super::row::{ROW, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        name: "oak",
        title: "a broad oak",
        text: include_str!("text/oak.l"),
        species: "oak",
        bark: "oak",
        leaf_kind: Some("oak-cluster"),
        trunk_radius: 0.28,
        exponent: 2.3,
        ..ROW
    },
    Row {
        name: "birch",
        title: "a birch with hanging twigs",
        text: include_str!("text/birch.l"),
        species: "birch",
        bark: "birch",
        leaf_kind: Some("birch-cluster"),
        trunk_radius: 0.14,
        exponent: 2.3,
        ..ROW
    },
    Row {
        name: "spruce",
        title: "a spruce with whorls of flat sprays",
        text: include_str!("text/spruce.l"),
        species: "spruce",
        bark: "spruce",
        leaf_kind: Some("spruce-needles"),
        trunk_radius: 0.15,
        exponent: 2.3,
        ..ROW
    },
    Row {
        name: "willow",
        title: "a weeping willow",
        text: include_str!("text/willow.l"),
        species: "willow",
        bark: "oak",
        leaf_kind: Some("willow-cluster"),
        trunk_radius: 0.28,
        exponent: 2.3,
        ..ROW
    },
    Row {
        name: "palm",
        title: "a palm with pinnate fronds",
        text: include_str!("text/palm.l"),
        species: "palm",
        bark: "palm",
        leaf_kind: Some("palm-leaflet"),
        trunk_radius: 0.16,
        exponent: 2.0,
        tip_radius: 0.004,
        ..ROW
    },
    Row {
        name: "fern",
        title: "a fern, twice pinnate",
        text: include_str!("text/fern.l"),
        species: "fern",
        bark: "smooth",
        leaf_kind: Some("mimosa-leaflet"),
        trunk_radius: 0.007,
        exponent: 2.5,
        tip_radius: 0.0003,
        ..ROW
    },
];
