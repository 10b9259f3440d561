//! Trees drawn with a few shapes.

use super::*;

const N: u32 = 200;

/// A tree with its foot at (90, 180) and its top at row 20: trunk 10 wide, crown above row 130.
fn tree(also: impl Fn(f32, f32) -> bool) -> Matte {
    matte(|x, y| {
        let crown = ((x - 100.0) / 60.0, (y - 75.0) / 55.0);
        let in_crown = crown.0 * crown.0 + crown.1 * crown.1 < 1.0;
        let in_trunk = (x - 90.0).abs() < 5.0 && (75.0..180.0).contains(&y);
        in_crown || in_trunk || also(x, y)
    })
}

fn matte(covered: impl Fn(f32, f32) -> bool) -> Matte {
    let alpha = (0..N * N)
        .map(|i| f32::from(u8::from(covered((i % N) as f32 + 0.5, (i / N) as f32 + 0.5))));
    Matte::new(N, N, alpha.collect()).unwrap()
}

fn aligned(matte: &Matte) -> (Camera, Alignment) {
    align(matte, &AlignParams::default()).unwrap()
}

fn stands(found: &Alignment) {
    assert!(found.base.distance(Vec2::new(90.0, 180.0)) < 3.0, "{found:?}");
    assert!((found.top.y - 20.0).abs() < 2.0, "{found:?}");
}

#[test]
fn a_tree_stands_on_its_trunk() {
    let (camera, found) = aligned(&tree(|_, _| false));
    stands(&found);
    assert!((camera.scale - 10.0 / 160.0).abs() < 1e-3, "{camera:?}");
    assert!((found.crown_base - 128.0).abs() < 5.0, "{found:?}");
    assert!((found.trunk_width.unwrap() - 10.0).abs() < 0.5, "{found:?}");
    assert!((found.crown.1.x - found.crown.0.x - 120.0).abs() < 3.0, "{found:?}");
    assert!(found.warnings.is_empty(), "{found:?}");
}

#[test]
fn specks_flare_and_grass_do_not_move_the_base() {
    let (_, found) = aligned(&tree(|x, y| {
        let speck = (x - 15.0).abs() < 4.0 && (y - 195.0).abs() < 4.0;
        let flare = y > 175.0 && y < 180.0 && (x - 90.0).abs() < y - 168.0;
        let grass = (178.0..180.0).contains(&y) && (60.0..180.0).contains(&x);
        speck || flare || grass
    }));
    stands(&found);
    assert!((found.trunk_width.unwrap() - 10.0).abs() < 1.0, "{found:?}");
}

#[test]
fn a_branch_hanging_below_the_foot_is_no_foot() {
    let (_, found) = aligned(&tree(|x, y| (x - 155.0).abs() < 6.0 && (75.0..188.0).contains(&y)));
    stands(&found);
    assert!(found.warnings.contains(&AlignWarning::NoTrunk) || found.trunk_width.is_some());
}

#[test]
fn a_cropped_trunk_and_crown_are_reported() {
    let whole = tree(|_, _| false);
    let part = Matte::new(N, 150, whole.alpha()[..(N * 150) as usize].to_vec()).unwrap();
    let (_, found) = aligned(&part);
    assert_eq!(found.base.y, 150.0);
    assert!(found.warnings.contains(&AlignWarning::BaseCropped), "{found:?}");
    let part = Matte::new(N, 160, whole.alpha()[(N * 40) as usize..].to_vec()).unwrap();
    assert!(aligned(&part).1.warnings.contains(&AlignWarning::CrownCropped));
}

#[test]
fn a_crown_down_to_the_ground_has_no_trunk() {
    let cone = matte(|x, y| (20.0..180.0).contains(&y) && (x - 100.0).abs() < 0.3 * (y - 20.0));
    let (_, found) = aligned(&cone);
    assert_eq!(found.trunk_width, None);
    assert!(found.warnings.contains(&AlignWarning::NoTrunk));
    assert!(found.base.distance(Vec2::new(100.0, 180.0)) < 3.0, "{found:?}");
    assert_eq!(found.crown_base, 180.0);
}

#[test]
fn tufts_are_one_tree_and_far_parts_are_left_out() {
    let tufts = matte(|x, y| {
        let tuft = |a: f32, b: f32| (x - a) * (x - a) + (y - b) * (y - b) < 400.0;
        tuft(100.0, 40.0)
            || tuft(60.0, 80.0)
            || tuft(150.0, 85.0)
            || ((x - 100.0).abs() < 4.0 && (60.0..190.0).contains(&y))
            || ((x - 10.0).abs() < 4.0 && (y - 20.0).abs() < 4.0)
    });
    let (_, found) = aligned(&tufts);
    assert!(found.warnings.contains(&AlignWarning::Parts(3)), "{found:?}");
    assert!(found.warnings.iter().any(|w| matches!(w, AlignWarning::LeftOut { parts: 1, .. })));
    assert!(found.base.distance(Vec2::new(100.0, 190.0)) < 2.0, "{found:?}");
    assert_eq!(found.top.y, 20.0);
}

#[test]
fn empty_full_and_flat_mattes_are_refused() {
    for value in [0.0, 1.0] {
        let error = align(&Matte::new(4, 4, vec![value; 16]).unwrap(), &AlignParams::default());
        assert!(matches!(error, Err(ModelError::Picture { .. })), "{error:?}");
    }
    let flat = Matte::new(3, 1, vec![0.0, 1.0, 0.0]).unwrap();
    assert!(align(&flat, &AlignParams::default()).is_err());
}

#[test]
fn pitch_and_perspective_put_the_top_on_its_row() {
    for (pitch, projection) in [
        (0.3, Projection::Orthographic),
        (-0.25, Projection::Perspective { fov: 1.0 }),
        (0.2, Projection::Perspective { fov: 0.5 }),
    ] {
        let params = AlignParams { pitch, projection, height: 12.0, ..AlignParams::default() };
        let (camera, found) = align(&tree(|_, _| false), &params).unwrap();
        let top = camera.projector().project(Vec3::new(0.0, 12.0, 0.0)).unwrap();
        assert!((top.y - found.top.y).abs() < 0.01, "{top} {found:?}");
    }
    let steep = AlignParams {
        pitch: -1.45,
        projection: Projection::Perspective { fov: 2.5 },
        ..AlignParams::default()
    };
    assert!(align(&tree(|_, _| false), &steep).is_err());
}

#[test]
fn views_that_disagree_are_named() {
    let usual = tree(|_, _| false);
    let other = matte(|x, y| (20.0..180.0).contains(&y) && (x - 100.0).abs() < 0.1 * (y - 20.0));
    let params = [AlignParams::default(); 3];
    let found = align_all(&[&usual, &usual, &other], &params, 5.0).unwrap();
    assert_eq!((found.cameras.len(), found.alignments.len()), (3, 3));
    assert!((found.cameras[0].scale - 5.0 / 160.0).abs() < 1e-3);
    assert!(found.warnings.iter().any(|w| matches!(w, AlignWarning::CrownBase { view: 2, .. })));
    assert!(align_all(&[&usual, &usual], &params[..2], 5.0).unwrap().warnings.is_empty());
    let empty = Matte::new(1, 1, vec![0.0]).unwrap();
    let error = align_all(&[&usual, &empty], &params[..2], 5.0).unwrap_err();
    assert!(matches!(error, ModelError::View { view: 1, .. }), "{error}");
    assert!(align_all(&[&usual], &params, 5.0).is_err());
}

#[test]
fn large_pictures_align_as_small_ones() {
    let small = tree(|_, _| false);
    let n = 8 * N;
    let alpha = (0..n * n).map(|i| small.at(i64::from(i % n / 8), i64::from(i / n / 8)));
    let large = Matte::new(n, n, alpha.collect()).unwrap();
    let (_, a) = aligned(&small);
    let (_, b) = aligned(&large);
    assert!((b.base / 8.0).distance(a.base) < 1.0, "{a:?} {b:?}");
    assert!((b.trunk_width.unwrap() / 8.0 - a.trunk_width.unwrap()).abs() < 0.5, "{b:?}");
}
