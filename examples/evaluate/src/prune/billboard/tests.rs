use super::super::modelled;
use super::*;
use tree_core::{Control, Seed};
use tree_lod::cover::{self, Around};
use tree_lod::{Grain, LeafSurfaces};
use tree_mesh::Surface;

/// Leaves in a ball of 2 m about a height of 3 m; or all in the plane z = 0.
fn leaves(n: u32, flat: bool) -> (Mesh, Elements) {
    let leaf = modelled::leaf(0.6);
    let mut surface = Surface::default();
    let mut rng = Seed(5).rng();
    for _ in 0..n {
        let first = surface.positions.len() as u32;
        let mut at = 2.0 * tree_core::seed::in_unit_ball(&mut rng);
        if flat {
            at.z = 0.0;
        }
        let at = at + 3.0 * Vec3::Y;
        surface.positions.extend(leaf.positions.iter().map(|&p| at + 0.3 * p));
        surface.normals.extend(&leaf.normals);
        surface.uvs.extend(&leaf.uvs);
        surface.indices.extend(leaf.indices.iter().map(|i| first + i));
        surface.anchors.push(at);
    }
    let materials = vec![modelled::material()];
    let mesh = Mesh { surfaces: vec![surface], materials, branches: Vec::new() };
    let elements =
        Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Blade, &Control::default()).unwrap();
    (mesh, elements)
}

#[test]
fn every_element_is_on_one_plane_and_the_budget_is_kept() {
    let (mesh, elements) = leaves(200, false);
    let billboards = decoret(&mesh, &elements, 20);
    assert!((5..=20).contains(&billboards.len()), "{}", billboards.len());
    let mut all: Vec<u32> = billboards.iter().flat_map(|b| b.elements.clone()).collect();
    all.sort_unstable();
    assert!(all.iter().copied().eq(0..200));
}

#[test]
fn leaves_in_a_plane_become_one_billboard_that_looks_the_same() {
    let (mesh, elements) = leaves(60, true);
    let billboards = decoret(&mesh, &elements, 1);
    assert_eq!(billboards.len(), 1);
    let baked = bake(&mesh, &elements, &billboards, 512).unwrap();
    baked.check().unwrap();
    // The first view looks along -Z.
    let cameras = Around { azimuths: 1, ..Around::default() }.cameras();
    let scores = cover::score(&baked, &mesh, &cameras, 512, &Control::default()).unwrap();
    let quality = scores[0].quality();
    assert!(quality > 0.95, "{quality}");
}

#[test]
fn boxes_decide_how_many_billboards_a_cluster_takes() {
    for (sides, n) in [
        ([1.0, 1.0, 1.0], 3),
        ([0.3, 1.0, 1.0], 3),
        ([0.1, 0.9, 1.0], 1),
        ([0.1, 0.2, 1.0], 2),
        ([0.0, 0.0, 1.0], 2),
    ] {
        assert_eq!(kmeans::count(sides), n, "{sides:?}");
    }
}

#[test]
fn clusters_hold_every_element_once() {
    let (mesh, elements) = leaves(300, false);
    let clusters = kmeans::clusters(&elements.centers, 12, Seed(1));
    let mut all: Vec<u32> = clusters.concat();
    all.sort_unstable();
    assert!(all.iter().copied().eq(0..300));
    let billboards = behrendt(&mesh, &elements, 30, Seed(1));
    assert!((10..=30).contains(&billboards.len()), "{}", billboards.len());
}
