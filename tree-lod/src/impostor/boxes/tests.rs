use super::*;
use crate::element::Elements;
use crate::impostor::tests::{Forked, forked, leaves};
use proptest::prelude::*;
use tree_core::{Control, Skeleton};

fn along(tree: &Forked, params: &BoxParams) -> Result<Boxes> {
    let Forked { skeleton, mesh, elements, bearers, .. } = tree;
    Boxes::along(skeleton, mesh, elements, bearers, params, &Control::default())
}

/// Every leaf is in `own` of exactly one box, and ranges nest.
fn check(boxes: &Boxes, n: usize) {
    let mut seen = vec![0; n];
    for (number, leaf_box) in boxes.boxes().iter().enumerate() {
        boxes.leaves(leaf_box.own.clone()).iter().for_each(|&leaf| seen[leaf as usize] += 1);
        let mut end = leaf_box.own.end;
        for child in leaf_box.children.clone() {
            let child = boxes.get(child).unwrap();
            assert_eq!((child.parent, child.level), (number as u32, leaf_box.level + 1));
            assert_eq!(child.leaves.start, end);
            end = child.leaves.end;
        }
        assert_eq!(end, leaf_box.leaves.end);
        assert_eq!(leaf_box.own.start, leaf_box.leaves.start);
    }
    assert!(seen.iter().all(|&times| times == 1));
    assert_eq!(boxes.boxes()[0].leaves, 0..n as u32);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn every_leaf_is_in_one_range_whatever_the_parameters(
        n in 1_usize..300, levels in 0_u32..6, least in 0.0_f64..0.3, most in 0.05_f64..1.0,
        least_leaves in 1_u32..30, most_boxes in 1_u32..20,
    ) {
        let tree = forked(n.max(9));
        let params = BoxParams { levels, least_volume: least, most_volume: most, least_leaves, most_boxes };
        let boxes = along(&tree, &params).unwrap();
        check(&boxes, n.max(9));
        prop_assert!(boxes.boxes().len() <= most_boxes as usize);
        prop_assert!(boxes.report().n_levels <= levels as usize + 1);
    }
}

#[test]
fn boxes_hold_their_leaves() {
    let tree = forked(300);
    for leaf_box in tree.boxes.boxes() {
        for &leaf in tree.boxes.leaves(leaf_box.leaves.clone()) {
            for p in &tree.mesh.surfaces[0].positions[4 * leaf as usize..][..4] {
                assert!(leaf_box.distance(*p) < 1e-4);
            }
        }
    }
}

#[test]
fn limbs_and_their_branches_become_boxes() {
    let boxes = forked(900).boxes;
    let report = boxes.report();
    assert_eq!((report.n_boxes, report.n_levels), (1 + 3 + 9, 3), "{report:?}");
    assert_eq!((report.n_in_root_only, report.n_dropped), (0, 0));
}

#[test]
fn small_boxes_stay_with_their_parent() {
    let tree = forked(900);
    let boxes =
        along(&tree, &BoxParams { least_volume: 0.9, most_volume: 1.0, ..BoxParams::default() });
    let boxes = boxes.unwrap();
    assert_eq!((boxes.boxes().len(), boxes.report().n_in_root_only), (1, 900));
    assert!(boxes.report().n_dropped > 0);
}

#[test]
fn a_flat_crown_still_has_volume() {
    let mut tree = forked(90);
    for p in &mut tree.mesh.surfaces[0].positions {
        p.z = 0.0;
    }
    let boxes = along(&tree, &BoxParams::default()).unwrap();
    assert!(boxes.boxes().iter().all(|b| b.half.min_element() > 0.0 && b.volume() > 0.0));
}

#[test]
fn bad_input_is_refused() {
    let mut tree = forked(90);
    let params = BoxParams::default();
    let odd = BoxParams { most_volume: f64::NAN, ..params };
    assert!(matches!(along(&tree, &odd), Err(LodError::Parameter(_))));
    tree.bearers.0[3] = 1000;
    assert!(matches!(along(&tree, &params), Err(LodError::Impostor(_))));
    tree.bearers.0.pop();
    assert!(matches!(along(&tree, &params), Err(LodError::Length { .. })));
    let mut point = forked(90);
    point.mesh.surfaces[0].positions.fill(Vec3::ONE);
    assert!(matches!(along(&point, &params), Err(LodError::Impostor(_))));
    let none = Forked { elements: Elements::default(), bearers: Bearers(Vec::new()), ..forked(9) };
    assert!(along(&none, &params).is_err());
}

#[test]
fn the_nearest_node_is_found() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    let mut rng = tree_core::Seed(1).rng();
    for i in 0..300 {
        let p = tree_core::seed::in_unit_ball(&mut rng) * Vec3::new(3.0, 1.0, 0.1);
        builder.add(i / 2, p, 0.01).unwrap();
    }
    let skeleton = builder.finish();
    let at: Vec<Vec3> = (0..200).map(|_| 2.0 * tree_core::seed::in_unit_ball(&mut rng)).collect();
    let mesh = leaves(&at, 0.01);
    let grain = crate::Grain::Leaf;
    let elements =
        Elements::of_mesh(&mesh, &crate::LeafSurfaces::Found, grain, &Control::default()).unwrap();
    let found = Bearers::nearest(&skeleton, &elements);
    for (center, &node) in elements.centers.iter().zip(&found.0) {
        let far = |p: &Vec3| p.distance(*center);
        let best = skeleton.positions().iter().map(far).fold(f32::MAX, f32::min);
        assert!(far(&skeleton.positions()[node as usize]) <= best + 1e-5);
    }
}

/// Leaves of two kinds in turn along a trunk, a metre apart; every fifth has no size.
fn two_kinds() -> tree_core::Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    let mut foliage = tree_core::Foliage::default();
    for i in 0..20_u32 {
        let p = Vec3::Y * (i + 1) as f32;
        let node = builder.add(i, p, 0.05).unwrap();
        let size = if i % 5 == 4 { 0.0 } else { 0.1 };
        let (rotation, kind) = (Quat::IDENTITY, (i % 2) as u16);
        foliage.push(tree_core::Leaf { node, position: p, rotation, size, kind }).unwrap();
    }
    let kinds = ["birch", "oak"].map(String::from).to_vec();
    let species = tree_core::Species { leaf_kinds: kinds, ..tree_core::Species::default() };
    tree_core::Tree::new(builder.finish(), foliage, species).unwrap()
}

#[test]
fn leaves_of_a_tree_know_the_node_that_bears_them() {
    let (tree, control) = (two_kinds(), Control::default());
    let look = tree_mesh::Look::plain(tree.species());
    let params = tree_mesh::MeshParams::default();
    let mesh = tree_mesh::build(&tree, &look, &params, &control).unwrap().mesh;
    let foliage = crate::LeafSurfaces::Surfaces(vec![1, 2]);
    let elements = Elements::of_mesh(&mesh, &foliage, crate::Grain::Leaf, &control).unwrap();
    let bearers = Bearers::of_tree(&tree, &mesh, &elements).unwrap();
    assert_eq!(bearers.0.len(), 16);
    for (center, &node) in elements.centers.iter().zip(&bearers.0) {
        let at = tree.skeleton().positions()[node as usize];
        assert!(center.distance(at) < 0.2, "{center} is not at {at}");
    }
    let one = crate::LeafSurfaces::Surfaces(vec![1]);
    let few = Elements::of_mesh(&mesh, &one, crate::Grain::Leaf, &control).unwrap();
    assert_eq!(Bearers::of_tree(&tree, &mesh, &few).unwrap().0.len(), 8);
    let fewer = tree_core::Tree::bare(tree.skeleton().clone(), tree.species().clone());
    let found = Bearers::of_tree(&fewer, &mesh, &elements);
    assert!(matches!(found, Err(LodError::Impostor(_))));
}

#[test]
fn leaves_on_branches_too_small_for_boxes_are_put_together_by_place() {
    // A long trunk with many short twigs of four leaves each.
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    let (mut at, mut nodes, mut trunk) = (Vec::new(), Vec::new(), 0);
    for i in 0..200 {
        let y = 0.1 * i as f32;
        trunk = builder.add(trunk, Vec3::Y * y, 0.1).unwrap();
        let (sin, cos) = libm::sincosf(2.4 * i as f32);
        let tip = Vec3::new(sin, y, cos);
        let node = builder.add(trunk, tip, 0.01).unwrap();
        for k in 0..4 {
            at.push(tip + 0.1 * Vec3::new(0.0, k as f32, 1.0));
            nodes.push(node);
        }
    }
    let mesh = leaves(&at, 0.05);
    let control = Control::default();
    let elements =
        Elements::of_mesh(&mesh, &crate::LeafSurfaces::Found, crate::Grain::Leaf, &control)
            .unwrap();
    let (skeleton, bearers) = (builder.finish(), Bearers(nodes));
    let params = BoxParams::default();
    let boxes = Boxes::along(&skeleton, &mesh, &elements, &bearers, &params, &control).unwrap();
    check(&boxes, at.len());
    assert!(boxes.boxes().len() > 8 && boxes.report().n_in_root_only < 40, "{:?}", boxes.report());
}
