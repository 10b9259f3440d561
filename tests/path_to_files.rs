//! From parameters to files: what the quickstart does, read back by other people's readers.

#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};
use tree_core::swc::{self, SwcOptions};
use tree_core::{Control, Limits, Seed, Tree};
use tree_mesh::io::gltf::{GlbOptions, to_glb, write_glb};
use tree_mesh::io::obj::write_obj;
use tree_mesh::{Look, Mesh, MeshError, MeshParams};
use tree_model::path::{PathParams, Preset};

fn small_tree() -> Tree {
    let params = Preset::find("i").unwrap().params().unwrap();
    params.grow(Seed(5), &Control::default()).unwrap().tree
}

fn mesh_of(tree: &Tree) -> Mesh {
    let look = Look::built_in(tree.species()).unwrap();
    tree_mesh::build(tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("tree-family-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn the_oak_is_an_oak() {
    let tree = PathParams::oak().unwrap().grow(Seed(7), &Control::default()).unwrap().tree;
    let size = tree.skeleton().bounds().size();
    assert!((9.0..15.0).contains(&size.y), "{} m high", size.y);
    assert!(size.x > 7.0 && size.z > 7.0, "broad: {size}");
    assert!(tree.foliage().len() > 8_000, "{} leaf clusters", tree.foliage().len());
    let trunk = tree.skeleton().radii()[0];
    assert!((0.3..0.7).contains(&trunk), "trunk of {trunk} m");
    mesh_of(&tree).check_normals().unwrap();
}

#[test]
fn the_glb_reads_back_equal_with_the_gltf_crate() {
    let mesh = mesh_of(&small_tree());
    let bytes = to_glb(&mesh, &GlbOptions::default()).unwrap();
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    let primitives: Vec<_> =
        file.meshes().flat_map(|m| m.primitives().collect::<Vec<_>>()).collect();
    assert_eq!(primitives.len(), mesh.surfaces.len());
    for (primitive, surface) in primitives.iter().zip(&mesh.surfaces) {
        let reader = primitive.reader(|_| Some(blob));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let ours: Vec<[f32; 3]> = surface.positions.iter().map(|p| p.to_array()).collect();
        assert_eq!(positions, ours);
        let normals: Vec<[f32; 3]> = reader.read_normals().unwrap().collect();
        assert_eq!(normals.len(), surface.normals.len());
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        assert_eq!(indices, surface.indices);
        let material = primitive.material();
        let ours = &mesh.materials[surface.material as usize];
        assert_eq!(material.double_sided(), ours.double_sided);
        assert_eq!(
            material.alpha_mode() == gltf::material::AlphaMode::Mask,
            matches!(ours.alpha, tree_mesh::Alpha::Mask(_))
        );
        assert!(material.pbr_metallic_roughness().base_color_texture().is_some());
    }
}

#[test]
fn the_same_seed_gives_the_same_file_on_one_thread_and_on_two() {
    let file = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| to_glb(&mesh_of(&small_tree()), &GlbOptions::default()).unwrap())
    };
    assert!(file(1) == file(2), "the bytes differ");
}

#[test]
fn a_grown_skeleton_survives_the_way_through_swc() {
    let tree = small_tree();
    let text = swc::write(tree.skeleton(), &SwcOptions::default()).unwrap();
    let back = swc::read(&text, &SwcOptions::default(), &Limits::default()).unwrap();
    assert_eq!(&back.skeleton, tree.skeleton());
}

#[test]
fn a_scanned_tree_can_be_meshed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../shared/data/skeletons/cherry_plantscan3d.swc");
    if !path.exists() {
        println!("skipped: {} is not here", path.display());
        return;
    }
    let scan = swc::read_file(&path, &SwcOptions::default(), &Limits::default()).unwrap();
    assert_eq!(scan.skeleton.len(), 6128);
    let mut tree = Tree::bare(scan.skeleton, tree_core::Species::default()).into_parts();
    tree.species.leaf_kinds.clear();
    let mesh = mesh_of(&tree.try_into().unwrap());
    mesh.check().unwrap();
    assert!(mesh.n_triangles() > 50_000);
}

#[test]
fn files_are_whole_or_absent() {
    let folder = folder("whole");
    let mesh = mesh_of(&small_tree());
    write_glb(&mesh, folder.join("tree.glb"), &GlbOptions::default()).unwrap();
    write_obj(&mesh, folder.join("tree.obj")).unwrap();
    let before = names(&folder);
    assert!(before.iter().all(|name| !name.ends_with(".tmp")), "{before:?}");

    let mut broken = mesh.clone();
    broken.surfaces[0].normals[0] = glam::Vec3::NAN;
    let old = std::fs::read(folder.join("tree.glb")).unwrap();
    let error = write_glb(&broken, folder.join("tree.glb"), &GlbOptions::default()).unwrap_err();
    assert!(matches!(error, MeshError::NotFinite { .. } | MeshError::NotUnit { .. }), "{error}");
    assert!(write_obj(&broken, folder.join("tree.obj")).is_err());
    assert!(write_glb(&mesh, folder.join("no/such/tree.glb"), &GlbOptions::default()).is_err());
    assert_eq!(std::fs::read(folder.join("tree.glb")).unwrap(), old);
    assert_eq!(names(&folder), before);
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn presets_survive_json() {
    for preset in tree_model::path::PRESETS {
        let params = preset.params().unwrap();
        let text = serde_json::to_string(&params).unwrap();
        let back: PathParams = serde_json::from_str(&text).unwrap();
        let grow = |params: &PathParams| params.grow(Seed(1), &Control::default()).unwrap().tree;
        if preset.name() == "i" {
            assert_eq!(grow(&params), grow(&back));
        }
        assert_eq!(serde_json::to_string(&back).unwrap(), text, "{}", preset.name());
    }
}
