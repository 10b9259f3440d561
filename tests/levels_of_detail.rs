//! Trees of the family, and one nobody here made, as levels of detail: budgets, pixels, scenes and files.

#![allow(clippy::unwrap_used)]

use std::sync::LazyLock;
use tree_core::glam::camera::rh::proj::directx::perspective_infinite_reverse;
use tree_core::glam::{Mat4, Vec3};
use tree_core::{Control, Seed};
use tree_lod::cover::{Around, score};
use tree_lod::order::CoverageParams;
use tree_lod::prune::{MakeParams, PrunedModel, Screen};
use tree_lod::quality::{Distance, mean_quality};
use tree_lod::select::{self, DrawIndexed, Eye, Frame, Instance, InstanceLod, Occlusion, State};
use tree_mesh::io::gltf::{self, GlbOptions};
use tree_mesh::{LeafForm, Look, Mesh, MeshParams};
use tree_model::path::Preset;

/// A preset with leaves drawn in this form.
fn grown(preset: &str, form: &LeafForm) -> Mesh {
    let params = Preset::find(preset).unwrap().params().unwrap();
    let tree = params.grow(Seed(3), &Control::default()).unwrap().tree;
    let mut look = Look::built_in(tree.species()).unwrap();
    look.leaves.iter_mut().for_each(|leaf| leaf.form = form.clone());
    tree_mesh::build(&tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
}

/// Few views: these tests are about whether it works, `evaluate -- prune` about how well.
fn pruned(mesh: &Mesh) -> PrunedModel {
    let around = Around { azimuths: 4, size: 64, ..Around::default() };
    let order = CoverageParams { around, ..CoverageParams::default() };
    let params = MakeParams { order: Some(order), ..MakeParams::default() };
    PrunedModel::make(mesh, &params, &Control::default()).unwrap()
}

/// An oak of cards, whole and pruned.
static OAK: LazyLock<(Mesh, PrunedModel)> = LazyLock::new(|| {
    let mesh = grown("oak", &LeafForm::Card);
    let model = pruned(&mesh);
    (mesh, model)
});

/// Quality of a level's own mesh, from sides that were not looked at before.
fn quality(model: &PrunedModel, full: &Mesh, lambda: f32) -> f64 {
    let held = Around { azimuths: 3, turn: 0.4, size: 256, ..Around::default() };
    let level = model.mesh_at(lambda).unwrap();
    mean_quality(&score(&level, full, &held.cameras(), held.size, &Control::default()).unwrap())
}

#[test]
fn a_tree_of_cards_keeps_its_pixels_and_its_budgets() {
    let (mesh, model) = &*OAK;
    let all = model.schedule().n_triangles() as f64;
    let mut last = 1.01;
    for lambda in [1.0_f32, 0.5, 0.2, 0.05] {
        let drawn = model.level(lambda).unwrap().n_triangles as f64;
        assert!(drawn <= f64::from(lambda) * all + 0.5 && drawn >= 0.98 * f64::from(lambda) * all);
        let found = quality(model, mesh, lambda);
        assert!(found > 0.75 && found <= last + 1e-3, "{lambda}: {found} after {last}");
        last = found;
    }
}

#[test]
fn modelled_leaves_lose_outline_before_they_are_dropped() {
    let mesh = grown("oak", &LeafForm::Modelled { max_vertices: 12 });
    let model = pruned(&mesh);
    assert!(model.schedule().n_tiers() > 2);
    assert!(quality(&model, &mesh, 0.2) > 0.95);
}

#[test]
fn a_scene_of_pruned_models_draws_windows_within_their_buffers() {
    let (_, model) = &*OAK;
    let n_indices: usize = model.mesh().surfaces.iter().map(|s| s.indices.len()).sum();
    let scene_model = model.to_select_model(32, Distance::cook()).unwrap();
    let tree = |i: i32| Instance {
        position: Vec3::new(0.0, 0.0, -25.0 * i as f32),
        ..Instance::default()
    };
    let instances: Vec<Instance> = (1..20).map(tree).collect();
    let control = Control::default();
    let scene = select::Scene::new(&[scene_model], &instances, &control).unwrap();
    let mut state = State::new(&scene, &control).unwrap();
    let eye = Eye {
        view: Mat4::from_translation(Vec3::NEG_Y * 2.0),
        projection: perspective_infinite_reverse(1.0, 1.5, 0.1),
    };
    let frame = Frame { eye, occlusion: Occlusion::None, seconds: 0.02, cut: true };
    let selected = scene.select(&frame, &select::SceneParams::default(), &mut state).unwrap();
    assert_eq!(selected.n_drawn, 19);
    let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
    let mut rows = vec![InstanceLod::default(); scene.len()];
    let written = scene.draws(&state, &mut draws, &mut rows).unwrap();
    for draw in &draws[..written.draws] {
        assert!((draw.first_index + draw.index_count) as usize <= n_indices);
    }
    let shares: Vec<f32> = rows[..written.instances].iter().map(|row| row.lambda).collect();
    assert!(shares.iter().any(|&l| l > 0.8) && shares.iter().any(|&l| l < 0.2), "{shares:?}");
}

#[test]
fn levels_of_an_imported_tree_are_a_file_that_reads_back() {
    let path = "../shared/data/meshes/eztree_aspen_medium.glb";
    let Ok(bytes) = std::fs::read(path) else {
        println!("skipped: {path} is not there");
        return;
    };
    let control = Control::default();
    let mesh = gltf::from_slice(&bytes, &control).unwrap().mesh;
    let model = pruned(&mesh);
    let options = GlbOptions::default();
    let levels = model.to_glb_levels(&[1.0, 0.3, 0.1], &Screen::default(), &options).unwrap();
    // Programs that do not know MSFT_lod draw the finest.
    let back = gltf::from_slice(&levels, &control).unwrap().mesh;
    assert!(back.n_triangles() >= mesh.n_triangles());
    let whole = gltf::from_slice(&model.to_glb(&options).unwrap(), &control).unwrap().mesh;
    assert_eq!(whole.n_triangles(), model.mesh().n_triangles());
}
