//! Pruned models as glTF, read back by another crate.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests
#![cfg(feature = "gltf")]

use gltf::Semantic;
use tree_lod::glam::{Vec2, Vec3};
use tree_lod::order::Ranking;
use tree_lod::outline::Tier;
use tree_lod::prune::{PruneParams, PrunedModel, Screen};
use tree_lod::quality::{Row, Subject, Table};
use tree_lod::tree_core::Control;
use tree_lod::tree_mesh::io::gltf::GlbOptions;
use tree_lod::tree_mesh::{Material, Mesh, Surface};
use tree_lod::{Elements, Grain, LeafSurfaces, LodError};

/// Forty cards along x, above a triangle of wood.
fn model() -> PrunedModel {
    let mut leaves = Surface { material: 1, ..Surface::default() };
    for i in 0..40 {
        let first = leaves.positions.len() as u32;
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            leaves.positions.push(Vec3::new(x + 2.0 * i as f32, y + 3.0, 0.0));
            leaves.normals.push(Vec3::Z);
            leaves.uvs.push(Vec2::new(x, y));
        }
        leaves.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
    }
    let wood = Surface {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
        normals: vec![Vec3::Z; 3],
        uvs: vec![Vec2::ZERO; 3],
        indices: vec![0, 1, 2],
        ..Surface::default()
    };
    let materials = vec![Material::default(); 2];
    let mesh = Mesh { surfaces: vec![wood, leaves], materials, ..Mesh::default() };
    let control = Control::default();
    let foliage = LeafSurfaces::Surfaces(vec![1]);
    let elements = Elements::of_mesh(&mesh, &foliage, Grain::Blade, &control).unwrap();
    let full = Tier::full(&mesh, &elements);
    let half = Tier {
        starts: (0..=40).collect(),
        triangles: (0..40).map(|element| full.of(element)[0]).collect(),
    };
    let ranking = Ranking { order: (0..40).rev().collect(), pivots: elements.centers.clone() };
    let row = |lambda: f32| Row { lambda, scale: 1.0 / lambda, ..Row::default() };
    let table = Table::new(vec![row(0.05), row(0.5), row(1.0)]).unwrap();
    let tiers = [full, half];
    let subject =
        Subject { mesh: &mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
    PrunedModel::new(&subject, table, &PruneParams::default(), &control).unwrap()
}

#[test]
fn the_model_carries_its_centres_and_all_tiers() {
    let model = model();
    let glb = model.to_glb(&GlbOptions::default()).unwrap();
    let file = gltf::Gltf::from_slice(&glb).unwrap();
    let foliage = file.meshes().next().unwrap().primitives().nth(1).unwrap();
    assert_eq!(foliage.indices().unwrap().count(), 3 * (80 + 40));
    let centers = foliage
        .attributes()
        .find(|(semantic, _)| *semantic == Semantic::Extras("TREE_CENTER".into()))
        .map(|(_, accessor)| accessor)
        .unwrap();
    assert_eq!((centers.count(), centers.dimensions()), (160, gltf::accessor::Dimensions::Vec4));
    let blob = file.blob.as_deref();
    let values: Vec<[f32; 4]> = gltf::accessor::Iter::new(centers, |_| blob).unwrap().collect();
    assert_eq!(values, model.parts()[0].centers);
}

#[test]
fn levels_are_read_back_finest_first_with_falling_coverage() {
    let model = model();
    let lambdas = [1.0, 0.5, 0.1];
    let screen = Screen { near: 20.0, far: 2000.0, ..Screen::default() };
    let glb = model.to_glb_levels(&lambdas, &screen, &GlbOptions::default()).unwrap();
    let file = gltf::Gltf::from_slice(&glb).unwrap();
    let counts: Vec<usize> = file
        .meshes()
        .map(|mesh| mesh.primitives().map(|p| p.indices().unwrap().count() / 3).sum())
        .collect();
    assert_eq!(counts, [81, 41, 9]);
    let root = file.scenes().next().unwrap().nodes().next().unwrap();
    let lod = root.extension_value("MSFT_lod").unwrap();
    assert_eq!(lod["ids"].as_array().unwrap().len(), 2);
    let json = file.document.as_json();
    let extras = json.nodes[root.index()].extras.as_ref().unwrap();
    let extras: serde_json::Value = serde_json::from_str(extras.get()).unwrap();
    let coverage = extras["MSFT_screencoverage"].as_array().unwrap();
    let coverage: Vec<f64> = coverage.iter().map(|c| c.as_f64().unwrap()).collect();
    assert!(coverage[0] > coverage[1] && coverage[1] > coverage[2] && coverage[2] == 0.0);
    // Cook's (1 - d)² is 0.5 at d = 0.293: 600 m.
    let size = 2.0 * f64::from(model.mesh().bounding_sphere().unwrap().1);
    let wanted = size / (2.0 * 0.57735 * (20.0 + 0.2929 * 1980.0));
    assert!((coverage[0] / wanted - 1.0).abs() < 0.02, "{} {wanted}", coverage[0]);
}

#[test]
fn what_cannot_be_written_is_refused() {
    let (model, options, screen) = (model(), GlbOptions::default(), Screen::default());
    for lambdas in [&[][..], &[0.5, 0.5], &[0.1, 1.0]] {
        let found = model.to_glb_levels(lambdas, &screen, &options);
        assert!(matches!(found, Err(LodError::Foliage(_))));
    }
    assert!(model.to_glb_levels(&[1.0, f32::NAN], &screen, &options).is_err());
    for screen in [
        Screen { near: f32::NAN, ..screen },
        Screen { near: 600.0, ..screen },
        Screen { far: f32::INFINITY, ..screen },
    ] {
        let found = model.to_glb_levels(&[1.0], &screen, &options);
        assert!(matches!(found, Err(LodError::Parameter(_))));
    }
    let quantized = GlbOptions { quantize: true, ..options };
    assert!(
        matches!(model.to_glb(&quantized), Err(LodError::Parameter(error)) if error.field == "quantize")
    );
}
