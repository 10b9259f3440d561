//! Other people's meshes, read by ours and by the gltf crate.

#![cfg(feature = "gltf")]
#![allow(clippy::unwrap_used)]

use std::path::PathBuf;
use tree_core::Control;
use tree_mesh::io::{self, ImportOptions, Note};

fn meshes() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/meshes");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: {} is not here", folder.display());
    None
}

/// Triangles of all nodes under the default scene, as the gltf crate sees them.
fn triangles(path: &std::path::Path) -> usize {
    let file = gltf::Gltf::from_slice_without_validation(&std::fs::read(path).unwrap()).unwrap();
    let mut stack: Vec<_> = file.default_scene().unwrap().nodes().collect();
    let mut n = 0;
    while let Some(node) = stack.pop() {
        stack.extend(node.children());
        for primitive in node.mesh().iter().flat_map(|mesh| mesh.primitives()) {
            let positions = primitive.get(&gltf::Semantic::Positions).unwrap().count();
            n += primitive.indices().map_or(positions, |indices| indices.count()) / 3;
        }
    }
    n
}

#[test]
fn every_shared_glb_has_the_triangles_the_gltf_crate_counts() {
    let Some(folder) = meshes() else { return };
    let mut n_files = 0;
    for entry in folder.read_dir().unwrap().chain(folder.join("waterways").read_dir().unwrap()) {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "glb") {
            continue;
        }
        let options = ImportOptions { external: true };
        let read = io::read(&path, &options, &Control::default()).unwrap();
        println!("{}: {:?}", path.display(), read.report);
        assert_eq!(read.report.n_triangles, triangles(&path), "{}", path.display());
        read.mesh.check_normals().unwrap();
        n_files += 1;
    }
    assert!(n_files >= 13, "{n_files}");
}

#[test]
fn shared_meshes_hold_what_their_sources_say() {
    let Some(folder) = meshes() else { return };
    let options = ImportOptions { external: true };
    let read = |name: &str| io::read(folder.join(name), &options, &Control::default()).unwrap();
    // Branches and leaf cards, or wood and leaves, as listed in SOURCES.md.
    for (name, counts) in [
        ("eztree_oak_medium.glb", vec![3166, 10_640]),
        ("eztree_pine_small.glb", vec![11_112, 7644]),
        ("eztree_aspen_medium.glb", vec![5088, 2112]),
        ("fuji43_wood.glb", vec![56_196]),
        ("walnut_wood.glb", vec![77_112]),
        ("appletree_amap.glb", vec![29_930, 15_540]),
    ] {
        let mesh = read(name).mesh;
        let mut found = vec![0; mesh.materials.len()];
        for surface in &mesh.surfaces {
            found[surface.material as usize] += surface.n_triangles();
        }
        found.retain(|&n| n > 0);
        assert_eq!(found, counts, "{name}");
    }
    // Faces that SOURCES.md counts; some are quads, so there are at least as many triangles.
    for (name, faces) in [
        ("quaternius/Tree_3.obj", 1002),
        ("quaternius/Birch_8.obj", 1208),
        ("quaternius/Pine_1.obj", 329),
        ("quaternius/DeadTree_3.obj", 654),
    ] {
        let read = read(name);
        println!("{name}: {:?}", read.report);
        assert!(read.report.n_triangles >= faces, "{name}: {}", read.report.n_triangles);
        assert!(read.report.n_textures > 0, "{name}");
        assert_eq!(read.report.count(Note::ExternalMissing), 0, "{name}");
    }
    // A scene that lists a node that is no root.
    assert_eq!(read("kenney_tree_default_fall.glb").report.count(Note::ListedTwice), 1);
}
