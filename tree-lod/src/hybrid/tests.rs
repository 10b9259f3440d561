//! Hybrid models of a small tree, near and far.

use super::*;
use crate::LodError;
use crate::impostor::cards::CardParams;
use crate::impostor::choose::Watcher;
use glam::{Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree};
use tree_mesh::Look;

/// Eight branches on a trunk, each with leaves all along.
fn tree(with_leaves: bool) -> Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    let mut foliage = Foliage::default();
    let mut trunk = 0;
    for i in 1..=8_u32 {
        let y = 0.6 * i as f32;
        trunk = builder.add(trunk, Vec3::new(0.0, y, 0.0), 0.2 / (1.0 + y)).unwrap();
        let around = Quat::from_rotation_y(2.4 * i as f32);
        let mut node = trunk;
        for k in 1..=6 {
            let p =
                Vec3::new(0.0, y, 0.0) + around * Vec3::new(0.3 * k as f32, 0.1 * k as f32, 0.0);
            node = builder.add(node, p, 0.03 / k as f32).unwrap();
            for l in 0..6 {
                let rotation = around * Quat::from_rotation_x(l as f32);
                foliage.push(Leaf { node, position: p, rotation, size: 0.15, kind: 0 }).unwrap();
            }
        }
    }
    let foliage = if with_leaves { foliage } else { Foliage::default() };
    Tree::new(builder.finish(), foliage, Species::default()).unwrap()
}

fn made(with_leaves: bool) -> Hybrid {
    let tree = tree(with_leaves);
    let cards = CardParams { size: 32, ..CardParams::default() };
    let params = HybridParams { cards, ..HybridParams::default() };
    let look = Look::built_in(tree.species()).unwrap();
    Hybrid::make(&tree, &look, &params, &Control::default()).unwrap()
}

#[test]
fn near_all_is_geometry_and_far_all_is_one_box() {
    let hybrid = made(true);
    let near = hybrid.choice_for_height(100_000.0).unwrap();
    assert_eq!(near.level as usize, hybrid.wood().n_levels());
    let leaves = near.leaves.as_ref().unwrap();
    assert!(leaves.boxes.is_empty());
    assert_eq!(leaves.n_leaves(), 8 * 6 * 6);
    let mesh = hybrid.mesh_of(&near).unwrap();
    assert_eq!(mesh.n_triangles(), hybrid.mesh().n_triangles());
    assert_eq!(mesh.n_triangles() as u64, hybrid.n_triangles(&near));
    let far = hybrid.choice_for_height(8.0).unwrap();
    let leaves = far.leaves.as_ref().unwrap();
    assert_eq!((leaves.boxes.as_slice(), leaves.n_leaves()), (&[0][..], 0));
    assert!(far.level < near.level && hybrid.n_triangles(&far) < hybrid.n_triangles(&near));
    hybrid.mesh_of(&far).unwrap().check().unwrap();
}

#[test]
fn fewer_pixels_never_show_more_wood() {
    let hybrid = made(false);
    let level = |pixels: f32| hybrid.level(pixels).unwrap();
    let mut last = level(0.01);
    assert_eq!(last, 1.0);
    let mut pixels = 0.01_f32;
    while pixels < 1e4 {
        pixels *= 1.002;
        let next = level(pixels);
        assert!(next >= last, "{pixels}: {next} after {last}");
        last = next;
    }
    assert_eq!(last as usize, hybrid.wood().n_levels());
    assert_eq!(level(f32::INFINITY) as usize, hybrid.wood().n_levels());
    assert!(matches!(hybrid.level(f32::NAN), Err(LodError::Parameter(_))));
    assert!(matches!(hybrid.level(-1.0), Err(LodError::Parameter(_))));
}

#[test]
fn a_bare_tree_has_wood_only() {
    let hybrid = made(false);
    assert!(hybrid.cards().is_none());
    let mut choice = hybrid.choice().unwrap();
    let watcher = Watcher { eye: Vec3::new(0.0, 2.0, 30.0), pixels_per_metre: 1000.0 };
    hybrid.update(&mut choice, &watcher).unwrap();
    assert!(choice.level >= 1.0 && choice.leaves.is_none());
    let mut other = made(true).choice().unwrap();
    assert!(matches!(hybrid.update(&mut other, &watcher), Err(LodError::Impostor(_))));
}

#[test]
fn an_eye_inside_the_tree_sees_all_and_one_that_is_nowhere_is_an_error() {
    let hybrid = made(true);
    let mut choice = hybrid.choice().unwrap();
    let eye = Vec3::new(0.1, 2.0, 0.1);
    hybrid.update(&mut choice, &Watcher { eye, pixels_per_metre: 1000.0 }).unwrap();
    assert_eq!(choice.level as usize, hybrid.wood().n_levels());
    for (eye, pixels_per_metre) in [(Vec3::NAN, 1.0), (eye, 0.0), (eye, f32::NAN)] {
        let before = choice.clone();
        let result = hybrid.update(&mut choice, &Watcher { eye, pixels_per_metre });
        assert!(matches!(result, Err(LodError::Parameter(_))));
        assert_eq!(choice, before);
    }
}

#[test]
fn windows_of_ranges_hold_their_leaves_and_no_others() {
    let hybrid = made(true);
    let n = hybrid.cards().unwrap().boxes().order().len() as u32;
    let (first, count) = hybrid.leaf_window(1, 0..n);
    assert_eq!((first, count as usize), (0, hybrid.mesh().surfaces[1].indices.len()));
    let parts: u32 = (0..n).map(|row| hybrid.leaf_window(1, row..row + 1).1).sum();
    assert_eq!(parts, count);
    assert_eq!(hybrid.leaf_window(0, 0..n), (0, 0));
    assert_eq!(hybrid.leaf_window(1, 0..n + 1), (0, 0));
}
