#![allow(clippy::unwrap_used)]

use super::super::surface::tests::tube;
use super::*;
use glam::Vec3;

fn two_tubes() -> [(Vec<Vec3>, Vec<u32>); 2] {
    let trunk = tube(&[(Vec3::ZERO, 0.2), (2.0 * Vec3::Y, 0.2), (4.0 * Vec3::Y, 0.15)], 8);
    let at = Vec3::new(0.0, 3.0, 0.1);
    [trunk, tube(&[(at, 0.05), (at + Vec3::Z, 0.04)], 6)]
}

fn parts(tubes: &[(Vec<Vec3>, Vec<u32>)]) -> Vec<Part<'_>> {
    let part = |(positions, indices)| Part { positions, indices, name: "bark", ..Part::default() };
    tubes.iter().map(|(positions, indices)| part((positions, indices))).collect()
}

#[test]
fn stages_make_what_skeletonize_makes() {
    let tubes = two_tubes();
    let (parts, params, control) =
        (parts(&tubes), SkeletonizeParams::default(), Control::default());
    let separation = Separation::new(&parts, &params, &control).unwrap();
    assert_eq!(separation.classes, [Class::Wood, Class::Wood]);
    assert!(separation.triangles(1).eq((0..12).map(|triangle| (1, triangle))));
    assert_eq!(separation.triangles(2).count(), 0);
    let pieces = separation.follow(&params, &control).unwrap();
    assert_eq!(pieces.len(), 2);
    let linked = link(&pieces, &params, &control).unwrap();
    assert_eq!(linked.reached, [true, true]);
    let skeleton = separation.outward(linked.skeleton).unwrap();
    let whole = super::super::skeletonize(&parts, &params, &control).unwrap();
    assert_eq!(&skeleton, whole.tree.skeleton());
}

#[test]
fn what_is_changed_between_stages_holds() {
    let tubes = two_tubes();
    let (parts, params, control) =
        (parts(&tubes), SkeletonizeParams::default(), Control::default());
    let mut separation = Separation::new(&parts, &params, &control).unwrap();
    separation.classes[1] = Class::Leaf;
    let pieces = separation.follow(&params, &control).unwrap();
    assert_eq!(pieces.len(), 1);
    let linked = link(&pieces, &params, &control).unwrap();
    let leaves = separation.leaves(&linked.skeleton, &control).unwrap();
    assert_eq!((leaves.foliage.len(), leaves.kinds), (1, vec!["bark".to_owned()]));
    // Components without a class are not looked at.
    separation.classes.truncate(1);
    assert_eq!(separation.leaves(&linked.skeleton, &control).unwrap(), Leaves::default());
    separation.classes.clear();
    let refused = separation.follow(&params, &control);
    assert!(matches!(refused, Err(ModelError::NoWood { .. })), "{refused:?}");
}

#[test]
fn pieces_that_cannot_be_linked_are_refused() {
    let (params, control) = (SkeletonizeParams::default(), Control::default());
    let refused = link(&[], &params, &control);
    assert!(matches!(refused, Err(ModelError::NoWood { .. })), "{refused:?}");
    for far in [Vec3::X * 1e30, Vec3::Y * -2e6] {
        let skeleton = Skeleton::builder(far, 0.1).unwrap().finish();
        let piece = Piece { skeleton, area: 1.0, n_bumps: 0, n_cut: 0 };
        let refused = link(&[piece], &params, &control);
        assert!(matches!(refused, Err(ModelError::Parameter(_))), "{refused:?}");
    }
    let lone = |x: f32| Piece {
        skeleton: Skeleton::builder(Vec3::X * x, 0.0).unwrap().finish(),
        area: 0.0,
        n_bumps: 0,
        n_cut: 0,
    };
    let linked = link(&[lone(0.0), lone(0.01), lone(1e6)], &params, &control).unwrap();
    assert_eq!(linked.reached, [true, true, false]);
}
