//! The twelve presets of Table 2 must be tellable apart, and look like trees, in silhouette.

#![allow(clippy::unwrap_used)]

use std::sync::LazyLock;
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Camera, Framing, Mask, View};
use tree_mesh::{Look, MeshParams};
use tree_model::path::PRESETS;

const SIZE: u32 = 96;

/// Name and silhouette, with leaves, of every tree of Table 2, drawn to the same scale.
static SILHOUETTES: LazyLock<Vec<(&str, Mask)>> = LazyLock::new(|| {
    let table_2 = PRESETS.into_iter().filter(|preset| preset.paper_seconds().is_some());
    table_2
        .map(|preset| {
            let control = Control::default();
            let tree = preset.params().unwrap().grow(Seed(3), &control).unwrap().tree;
            let look = Look::built_in(tree.species()).unwrap();
            let params = MeshParams::default();
            let mesh = tree_mesh::build(&tree, &look, &params, &control).unwrap().mesh;
            let framing = Framing { orthographic: true, pitch: 0.0, ..Framing::default() };
            let camera = Camera::Framed(framing);
            let view = View { width: SIZE, height: SIZE, samples: 2, camera };
            (preset.name(), preview::mask(&mesh, &view, &control).unwrap())
        })
        .collect()
});

fn bits(mask: &Mask) -> Vec<bool> {
    mask.bits().collect()
}

/// Intersection over union of two masks.
fn overlap(a: &Mask, b: &Mask) -> f64 {
    let (mut both, mut either) = (0, 0);
    for (a, b) in bits(a).into_iter().zip(bits(b)) {
        both += usize::from(a && b);
        either += usize::from(a || b);
    }
    f64::from(both as u32) / f64::from(either.max(1) as u32)
}

#[test]
fn no_two_silhouettes_are_alike() {
    for (i, (name, mask)) in SILHOUETTES.iter().enumerate() {
        for (other, other_mask) in &SILHOUETTES[..i] {
            let overlap = overlap(mask, other_mask);
            assert!(overlap < 0.75, "{name} and {other} overlap by {overlap:.2}");
        }
    }
}

#[test]
fn crowns_are_full_but_have_gaps() {
    for (name, mask) in SILHOUETTES.iter() {
        let bits = bits(mask);
        let rows: Vec<&[bool]> = bits.chunks(SIZE as usize).collect();
        // The crown: rows that are wider than a trunk.
        let spans: Vec<(usize, usize)> = rows
            .iter()
            .filter_map(|row| {
                let first = row.iter().position(|&bit| bit)?;
                let last = row.iter().rposition(|&bit| bit)?;
                let filled = row.iter().filter(|&&bit| bit).count();
                (last - first > 6).then_some((filled, last - first + 1))
            })
            .collect();
        let filled: usize = spans.iter().map(|&(filled, _)| filled).sum();
        let span: usize = spans.iter().map(|&(_, span)| span).sum();
        let share = filled as f64 / span.max(1) as f64;
        assert!((0.35..0.98).contains(&share), "{name}: {share:.2} of the crown's span is filled");
    }
}
