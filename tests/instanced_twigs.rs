//! A grown tree as a base and instances of at most 30 twigs: a tenth of the memory, the same outline.

#![allow(clippy::unwrap_used)]

use tree_core::{Control, Seed, Tree};
use tree_lod::preview::{self, Camera, Framing, View};
use tree_mesh::instance::{InstancedTree, InstancingParams, twigs};
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::path::Preset;

/// Views round the tree.
const VIEWS: u32 = 4;

/// The preset with leaves eight times as near to each other: a hundred thousand single ones.
fn grow(preset: &str) -> Tree {
    let mut params = Preset::find(preset).unwrap().params().unwrap();
    let leaves = params.leaves.as_mut().unwrap();
    (leaves.spacing, leaves.size) = (leaves.spacing / 8.0, leaves.size / 3.0);
    params.grow(Seed(3), &Control::default()).unwrap().tree
}

fn instanced(tree: &Tree) -> (InstancedTree, Mesh) {
    let look = Look::built_in(tree.species()).unwrap();
    let (params, control) = (MeshParams::default(), Control::default());
    let made = twigs(tree, &look, &params, &InstancingParams::default(), &control).unwrap();
    let plain = tree_mesh::build(tree, &look, &params, &control).unwrap().mesh;
    (made, plain)
}

/// Share of the pixels covered by either mesh that are covered by both, seen by the first's camera.
fn agreement(a: &Mesh, b: &Mesh) -> f64 {
    let (mut both, mut either) = (0.0, 0.0);
    for i in 0..VIEWS {
        let yaw = std::f32::consts::TAU * i as f32 / VIEWS as f32;
        let framing = Framing { yaw, orthographic: true, ..Default::default() };
        let pose = Camera::Framed(framing).pose(a, 1.0).unwrap();
        let view = View { width: 160, height: 160, camera: Camera::Placed(pose), samples: 2 };
        let mask = |mesh| preview::mask(mesh, &view, &Control::default()).unwrap().coverage;
        for (a, b) in mask(a).into_iter().zip(mask(b)) {
            both += f64::from(a.min(b));
            either += f64::from(a.max(b));
        }
    }
    both / either
}

/// Bytes of the columns of a mesh.
fn bytes(mesh: &Mesh) -> u64 {
    let surface = |s: &tree_mesh::Surface| {
        12 * (s.positions.len() + s.normals.len() + s.anchors.len())
            + 8 * (s.uvs.len() + s.uvs2.len())
            + 16 * s.tangents.len()
            + 4 * (s.branches.len() + s.occlusion.len() + s.welds.len() + s.indices.len())
    };
    mesh.surfaces.iter().map(|s| surface(s) as u64).sum()
}

#[test]
fn a_leafy_tree_of_thirty_twigs_is_ten_times_smaller_and_keeps_its_outline() {
    let tree = grow("oak");
    let (made, plain) = instanced(&tree);
    let report = made.report;
    let flat = made.flatten(&Control::default()).unwrap();
    let outline = agreement(&plain, &flat);
    let (leaves, drawn) = report.n_leaves;
    assert!(leaves > 90_000, "{leaves}");
    println!("{report:?}, {} bytes plain, silhouettes agree to {outline:.3}", bytes(&plain));
    assert!(report.n_twigs <= 30);
    assert!(report.ratio >= 10.0 && bytes(&plain) >= 10 * report.bytes);
    assert!((drawn as f64 / leaves as f64 - 1.0).abs() < 0.1, "{drawn} leaves of {leaves}");
    // Small gaps between twigs lie elsewhere; the outline as a whole is that of the tree.
    assert!(outline > 0.62, "{outline}");
    let size = (plain.bounds().size() - flat.bounds().size()).abs().max_element();
    assert!(size < 0.6, "extents differ by {size} m");
}
