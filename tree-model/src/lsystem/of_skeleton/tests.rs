use super::*;
use crate::glam::{Quat, Vec3};
use crate::lsystem::turtle::interpret;
use proptest::prelude::*;
use tree_core::{Leaf, Limits, Species, Tree};

fn write(skeleton: &Skeleton, foliage: &Foliage, tolerance: f64) -> Chain {
    let params = ChainParams { tolerance, ..ChainParams::default() };
    chain(skeleton, foliage, &params, &Control::default()).unwrap()
}

fn draw(written: &Chain) -> Tree {
    // Through text, as other programs would get it.
    let text = written.word.text(&written.symbols);
    let mut symbols = Symbols::default();
    let word = Word::parse(&text, &mut symbols).unwrap();
    let drawn =
        interpret(&word, &symbols, &Species::default(), &chain_turtle(), &Control::default());
    drawn.unwrap().tree
}

/// Largest distance of a node from its place, and of a radius from its value, in extents.
fn off(skeleton: &Skeleton, written: &Chain, tree: &Tree) -> (f32, f32) {
    let bounds = skeleton.bounds();
    let extent = (bounds.max - bounds.min).max_element();
    let base = skeleton.positions()[0];
    let mut worst = (0.0_f32, 0.0_f32);
    for (i, &node) in written.nodes.iter().enumerate() {
        let node = node as usize;
        let apart = tree.skeleton().positions()[i].distance(skeleton.positions()[node] - base);
        let thick = (tree.skeleton().radii()[i] - skeleton.radii()[node]).abs();
        worst = (worst.0.max(apart / extent), worst.1.max(thick / extent));
    }
    worst
}

/// A random skeleton: each node hangs on one of the few before it.
fn skeletons() -> impl Strategy<Value = Skeleton> {
    let row = (0_u32..4, prop::array::uniform3(-1.0_f32..1.0), 0.0_f32..0.3);
    prop::collection::vec(row, 1..80).prop_map(|rows| {
        let mut builder = Skeleton::builder(Vec3::new(1.0, 2.0, 3.0), 0.2).unwrap();
        let mut places = vec![Vec3::new(1.0, 2.0, 3.0)];
        for (back, way, radius) in rows {
            let parent = (builder.len() as u32 - 1).saturating_sub(back);
            let place = places[parent as usize] + Vec3::from(way);
            builder.add(parent, place, radius).unwrap();
            places.push(place);
        }
        builder.finish()
    })
}

proptest! {
    #[test]
    fn a_skeleton_comes_back_from_its_chain(skeleton in skeletons(), exact in any::<bool>()) {
        let written = write(&skeleton, &Foliage::default(), if exact { 0.0 } else { 1e-5 });
        let tree = draw(&written);
        prop_assert_eq!(tree.skeleton().len(), skeleton.len());
        let (apart, thick) = off(&skeleton, &written, &tree);
        let most = if exact { 1e-6 } else { 2e-5 };
        prop_assert!(apart < most && thick < most, "{} {}", apart, thick);
        for (parent, node) in tree.skeleton().segments() {
            let original = written.nodes[node as usize];
            prop_assert_eq!(skeleton.parent(original), Some(written.nodes[parent as usize]));
        }
    }

    #[test]
    fn leaves_come_back_where_they_were(
        away in prop::array::uniform3(-0.3_f32..0.3),
        turn in prop::array::uniform4(-1.0_f32..1.0),
        size in 0.01_f32..0.3,
    ) {
        let turn = Quat::from_array(turn);
        prop_assume!(turn.length() > 0.1);
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
        builder.add(0, Vec3::new(0.3, 1.0, 0.2), 0.05).unwrap();
        let skeleton = builder.finish();
        let position = Vec3::new(0.3, 1.0, 0.2) + Vec3::from(away);
        let leaf = Leaf { node: 1, position, rotation: turn.normalize(), size, kind: 0 };
        let foliage = Foliage::try_from(vec![leaf]).unwrap();
        let found = draw(&write(&skeleton, &foliage, 1e-5)).foliage().get(0).unwrap();
        prop_assert_eq!((found.node, found.kind), (1, 0));
        prop_assert!(found.position.distance(position) < 1e-4);
        prop_assert!((found.size - size).abs() < 1e-4);
        for axis in Vec3::AXES {
            let apart = (found.rotation * axis).distance(leaf.rotation * axis);
            prop_assert!(apart < 0.01, "{}", apart);
        }
    }
}

#[test]
fn what_was_rounded_off_does_not_add_up_along_an_axis() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    for i in 1..20_000_u32 {
        let t = i as f32 * 0.003;
        let place = Vec3::new(2.0 * libm::sinf(t), 0.05 * t, libm::cosf(1.7 * t) - 1.0);
        builder.add(i - 1, place, 0.1).unwrap();
    }
    let skeleton = builder.finish();
    let written = write(&skeleton, &Foliage::default(), 1e-5);
    let (apart, _) = off(&skeleton, &written, &draw(&written));
    assert!(apart < 2e-5, "{apart}");
}

#[test]
fn a_comb_of_many_laterals_and_nodes_at_one_place_are_written() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    let mut tip = 0;
    for i in 1..2000 {
        tip = builder.add(tip, Vec3::new(0.0, i as f32 * 0.01, 0.0), 0.1).unwrap();
        builder.add(tip, Vec3::new(0.5, i as f32 * 0.01, 0.0), 0.01).unwrap();
    }
    let same = builder.add(tip, Vec3::new(0.0, 19.99, 0.0), 0.1).unwrap();
    builder.add(same, Vec3::new(0.0, 21.0, 0.0), 0.1).unwrap();
    let skeleton = builder.finish();
    let written = write(&skeleton, &Foliage::default(), 1e-5);
    let tree = draw(&written);
    assert_eq!(tree.skeleton().len(), skeleton.len() - 1);
    assert!(off(&skeleton, &written, &tree).0 < 2e-5);
}

#[test]
fn bad_tolerances_and_dangling_leaves_are_refused() {
    let skeleton = Skeleton::builder(Vec3::ZERO, 0.1).unwrap().finish();
    let leaf = Leaf { node: 5, position: Vec3::ZERO, rotation: Quat::IDENTITY, size: 1.0, kind: 0 };
    let foliage = Foliage::try_from(vec![leaf]).unwrap();
    let params = ChainParams::default();
    assert!(chain(&skeleton, &foliage, &params, &Control::default()).is_err());
    let nan = ChainParams { tolerance: f64::NAN, ..params };
    assert!(chain(&skeleton, &Foliage::default(), &nan, &Control::default()).is_err());
}

#[test]
fn a_limit_on_modules_holds() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    for i in 1..20_000_u32 {
        builder.add(i - 1, Vec3::new(0.0, i as f32, 0.0), 0.1).unwrap();
    }
    let skeleton = builder.finish();
    let limits = Limits { modules: 100, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    let written = chain(&skeleton, &Foliage::default(), &ChainParams::default(), &control);
    assert!(written.is_err());
}
