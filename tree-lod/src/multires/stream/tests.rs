//! What goes in comes out, at every length, and damage is found.

use super::super::{Metric, Multires};
use super::*;
use crate::LodError;
use glam::{Quat, Vec3};
use proptest::prelude::*;
use tree_core::{Control, Foliage, Leaf, Limits, Skeleton, Species, Tree};

/// A tree of these forks and numbers.
fn tree_of(rows: &[(u8, [f32; 4])]) -> Tree {
    let mut builder = Skeleton::builder(Vec3::new(0.1, -0.2, 0.3), 0.5).unwrap();
    let mut foliage = Foliage::default();
    for (i, &(back, [x, y, z, r])) in rows.iter().enumerate() {
        let parent = (i as u32).saturating_sub(u32::from(back) / 32);
        let p = Vec3::new(x, y, z) * i as f32 * 0.1;
        let node = builder.add(parent, p, r.abs()).unwrap();
        if back % 3 == 0 {
            let rotation = Quat::from_xyzw(x, y, z, r + 1.5).normalize();
            let leaf = Leaf { node, position: p + Vec3::X * r, rotation, size: r.abs(), kind: 0 };
            foliage.push(leaf).unwrap();
        }
    }
    Tree::new(builder.finish(), foliage, Species::default()).unwrap()
}

fn multires(tree: &Tree) -> Multires {
    Multires::new(tree, &Metric::default(), &Control::default()).unwrap()
}

fn some_tree() -> Multires {
    let row = |i: u32| (((i * 37) % 251) as u8, [0.3, 1.0, -0.2, 0.1 / (i + 1) as f32]);
    multires(&tree_of(&(0..60).map(row).collect::<Vec<_>>()))
}

fn rows() -> impl Strategy<Value = Vec<(u8, [f32; 4])>> {
    proptest::collection::vec((any::<u8>(), proptest::array::uniform4(-1.0_f32..1.0)), 0..80)
}

proptest! {
    #[test]
    fn an_exact_stream_gives_every_level_back_to_the_bit(rows in rows()) {
        let multires = multires(&tree_of(&rows));
        let whole = encode(&multires, usize::MAX, &StreamParams::default()).unwrap();
        let (back, received) = decode(&whole, &Limits::default()).unwrap();
        prop_assert_eq!(&back, &multires);
        prop_assert!(received.is_complete);
        for n in 1..=multires.n_levels() {
            let part = encode(&multires, n, &StreamParams::default()).unwrap();
            prop_assert!(whole.starts_with(&part));
            let (back, received) = decode(&part, &Limits::default()).unwrap();
            prop_assert_eq!(received.n_levels, n);
            prop_assert_eq!(back.tree(), &multires.tree_at(n).unwrap());
        }
    }

    #[test]
    fn a_stream_of_a_precision_keeps_it(rows in rows()) {
        let multires = multires(&tree_of(&rows));
        let precision = 1e-3;
        let bytes = encode(&multires, usize::MAX, &StreamParams { precision }).unwrap();
        let (back, _) = decode(&bytes, &Limits::default()).unwrap();
        let near = |a: &Vec3, b: &Vec3| (*a - *b).abs().max_element() <= 0.51 * precision;
        let (a, b) = (multires.tree(), back.tree());
        prop_assert_eq!(a.skeleton().parents(), b.skeleton().parents());
        let pairs = |a: &[Vec3], b: &[Vec3]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b));
        prop_assert!(pairs(a.skeleton().positions(), b.skeleton().positions()));
        prop_assert!(pairs(a.foliage().positions(), b.foliage().positions()));
        for (a, b) in a.foliage().rotations().iter().zip(b.foliage().rotations()) {
            prop_assert!(a.dot(*b).abs() > 0.999_99, "{} {}", a, b);
        }
    }

    #[test]
    fn any_bytes_are_a_tree_or_an_error(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let mut begun = encode(&some_tree(), 3, &StreamParams::default()).unwrap();
        prop_assert!(decode(&bytes, &Limits::default()).is_err());
        begun.extend_from_slice(&bytes);
        if let Ok((tree, _)) = decode(&begun, &Limits::default()) {
            prop_assert!(tree.tree().skeleton().check().is_ok());
        }
    }
}

#[test]
fn every_prefix_of_the_bytes_is_a_coarser_tree() {
    let multires = some_tree();
    let whole = encode(&multires, usize::MAX, &StreamParams::default()).unwrap();
    let mut reader = Reader::new(&Limits::default());
    let mut last = 0;
    for (n, byte) in whole.iter().enumerate() {
        let received = reader.push(std::slice::from_ref(byte)).unwrap();
        assert!(received.n_levels >= last && received.is_complete == (n + 1 == whole.len()));
        if received.n_levels > last {
            last = received.n_levels;
            let tree = reader.multires().unwrap();
            assert_eq!(tree.tree(), &multires.tree_at(last).unwrap());
        }
    }
    assert_eq!(last, multires.n_levels());
    assert!(matches!(reader.push(&[0]), Err(LodError::Stream { .. })));
}

#[test]
fn each_damaged_byte_is_found() {
    let whole = encode(&some_tree(), usize::MAX, &StreamParams::default()).unwrap();
    for at in 0..whole.len() {
        let mut damaged = whole.clone();
        damaged[at] ^= 0x55;
        let result = decode(&damaged, &Limits::default());
        // A length that has grown looks as if more were to come.
        let found = result.is_err() || result.is_ok_and(|(_, received)| !received.is_complete);
        assert!(found, "byte {at} of {}", whole.len());
    }
}

#[test]
fn a_head_alone_is_no_tree_and_limits_hold() {
    let multires = some_tree();
    let whole = encode(&multires, usize::MAX, &StreamParams::default()).unwrap();
    assert!(matches!(decode(&whole[..20], &Limits::default()), Err(LodError::Stream { .. })));
    assert!(matches!(decode(&[], &Limits::default()), Err(LodError::Stream { .. })));
    let limits = Limits { nodes: 10, ..Limits::default() };
    assert!(matches!(decode(&whole, &limits), Err(LodError::Limit(_))));
    for precision in [-1.0, 2.0, f32::NAN, 1e-9] {
        let result = encode(&multires, 1, &StreamParams { precision });
        assert!(matches!(result, Err(LodError::Parameter(_))), "{precision}");
    }
}

#[test]
fn levels_cost_little() {
    let multires = some_tree();
    for precision in [0.0, 1e-3] {
        let params = StreamParams { precision };
        let levels = encode(&multires, usize::MAX, &params).unwrap().len() as f64;
        let chain = encode_chain(&multires, &params).unwrap().len() as f64;
        assert!(levels <= 1.1 * chain, "{levels} against {chain}");
    }
}
