use super::*;
use crate::error::LodError;
use crate::impostor::tests::{card, forked, mesh_of};
use crate::preview::{Camera, Lens, Pose, View, mask};
use crate::quality::Score;
use glam::Vec3;
use tree_core::{CancelFlag, Control, Limits};
use tree_mesh::Mesh;

fn params() -> OctahedralParams {
    OctahedralParams { grid: 6, side: 384, samples: 2, ..OctahedralParams::default() }
}

fn bake(mesh: &Mesh, params: &OctahedralParams) -> Octahedral {
    Octahedral::bake(mesh, params, &Control::default()).unwrap()
}

fn from(direction: Vec3, of: &Octahedral, radii: f32) -> Camera {
    let meta = &of.meta;
    Camera::Placed(Pose {
        eye: meta.center + direction.normalize() * (radii * meta.radius),
        target: meta.center,
        up: if direction.y.abs() > 0.99 * direction.length() { Vec3::Z } else { Vec3::Y },
        lens: Lens::Perspective { fov: 2.0 * libm::asinf(1.0 / radii) },
    })
}

fn score(mesh: &Mesh, of: &Octahedral, direction: Vec3) -> Score {
    let camera = from(direction, of, 6.0);
    let seen = of.mask(&camera, 64, 64, &Control::default()).unwrap();
    let view = View { width: 64, height: 64, samples: 3, camera };
    let full = mask(mesh, &view, &Control::default()).unwrap();
    let mut score = Score::default();
    for (a, b) in seen.bits().zip(full.bits()) {
        score.both += u64::from(a && b);
        score.wrong += u64::from(a && !b);
        score.missed += u64::from(!a && b);
    }
    score
}

const DIRECTIONS: [Vec3; 6] = [
    Vec3::new(1.0, 0.2, 0.3),
    Vec3::new(-0.4, 0.5, 0.8),
    Vec3::new(-0.7, 0.1, -0.6),
    Vec3::new(0.2, 0.9, -0.3),
    Vec3::new(0.0, 0.0, 1.0),
    Vec3::Y,
];

#[test]
fn views_between_the_frames_have_the_outline_of_the_tree() {
    let mesh = forked(2000).mesh;
    for hemi in [true, false] {
        let grid = if hemi { 6 } else { 9 };
        let side = 64 * grid;
        let baked = bake(&mesh, &OctahedralParams { hemi, grid, side, ..params() });
        for direction in DIRECTIONS {
            let score = score(&mesh, &baked, direction);
            let (p, r) = (score.precision(), score.recall());
            assert!(p > 0.75 && r > 0.75, "{hemi} {direction}: {p} {r}");
        }
    }
}

#[test]
fn a_full_sphere_is_seen_from_below_as_well() {
    let mesh = forked(2000).mesh;
    let baked = bake(&mesh, &OctahedralParams { hemi: false, grid: 9, side: 576, ..params() });
    for direction in [Vec3::NEG_Y, Vec3::new(0.5, -0.6, 0.3)] {
        let score = score(&mesh, &baked, direction);
        assert!(score.precision() > 0.75 && score.recall() > 0.75, "{score:?}");
    }
}

#[test]
fn colours_have_no_dark_fringe() {
    // White cards: every texel, covered or not, is white.
    let mesh = forked(500).mesh;
    let baked = bake(&mesh, &params());
    let (texels, _) = baked.color.pixels.as_chunks::<4>();
    assert!(texels.iter().all(|texel| texel[0] >= 254));
    let seen =
        baked.view(&from(Vec3::new(1.0, 0.2, 0.3), &baked, 6.0), 64, 64, &Control::default());
    let seen = seen.unwrap();
    let (texels, _) = seen.pixels.as_chunks::<4>();
    assert!(texels.iter().all(|texel| texel[3] == 0 || texel[0] >= 253));
    assert!(texels.iter().any(|texel| texel[3] > 200));
}

#[test]
fn left_is_left_and_up_is_up() {
    // An L seen from +Z: right of the middle only at the bottom.
    let at = [(-1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0)];
    let mesh = mesh_of(at.iter().map(|&(x, y)| card(Vec3::new(x, y, 0.0), 0.45)));
    let baked = bake(&mesh, &params());
    let camera = from(Vec3::new(0.1, 0.1, 1.0), &baked, 6.0);
    let seen = baked.view(&camera, 60, 60, &Control::default()).unwrap();
    let shown = |x: f32, y: f32| {
        let px = |t: f32| (30.0 + 30.0 * t / baked.meta.radius) as u32;
        seen.pixel(px(x), px(-y)).unwrap()[3] > 127
    };
    for (x, y) in at {
        assert!(shown(x, y), "{x} {y}");
    }
    assert!(!shown(1.0, 1.0) && !shown(1.0, 0.0) && !shown(0.0, 1.0));
}

#[test]
fn numbers_are_written_as_json_and_pictures_fit_them() {
    let baked = bake(&forked(90).mesh, &params());
    baked.check().unwrap();
    let json: serde_json::Value = serde_json::from_str(&baked.meta.to_json()).unwrap();
    assert_eq!(json["grid"], 6);
    assert_eq!(json["hemi"], true);
    assert_eq!(json["wide"].as_f64().unwrap() as f32, baked.meta.wide);
    assert_eq!(json["center"][1].as_f64().unwrap() as f32, baked.meta.center.y);
    assert_eq!(baked.report.n_views, 36);
    assert_eq!(baked.report.bytes, 2 * 4 * 384 * 384);
    let half = bake(&forked(90).mesh, &OctahedralParams { half_detail: true, ..params() });
    assert_eq!(half.report.bytes, 5 * 384 * 384);
    half.check().unwrap();
    let mut odd = baked.clone();
    odd.color.pixels.pop();
    assert!(odd.check().is_err());
    let odd = Octahedral { meta: OctahedralMeta { tile: 65, ..baked.meta }, ..baked };
    assert!(matches!(odd.check(), Err(LodError::Parameter(error)) if error.field == "meta.tile"));
}

#[test]
fn bad_input_is_refused_and_cancelling_stops() {
    let mesh = forked(90).mesh;
    let control = Control::default();
    for odd in [
        OctahedralParams { grid: 1, ..params() },
        OctahedralParams { side: 32_768, ..params() },
        OctahedralParams { grid: 30, ..params() },
        OctahedralParams { gutter: 0, ..params() },
        OctahedralParams { grid: 24, gutter: 8, ..params() },
        OctahedralParams { samples: 9, ..params() },
    ] {
        let found = Octahedral::bake(&mesh, &odd, &control);
        assert!(matches!(found, Err(LodError::Parameter(_))), "{odd:?}");
    }
    let small = Control::default().with_limits(Limits { pixels: 1000, ..Limits::default() });
    assert!(matches!(Octahedral::bake(&mesh, &params(), &small), Err(LodError::Limit(_))));
    let flag = CancelFlag::default();
    flag.cancel();
    let stopped = Control::default().with_cancel(flag);
    assert!(matches!(Octahedral::bake(&mesh, &params(), &stopped), Err(LodError::Cancelled(_))));
    let found = Octahedral::bake(&Mesh::default(), &params(), &control);
    assert!(matches!(found, Err(LodError::Impostor(_))));
    let point = mesh_of(std::iter::once(card(Vec3::ONE, 0.0)));
    assert!(matches!(Octahedral::bake(&point, &params(), &control), Err(LodError::Impostor(_))));
    let huge = mesh_of(std::iter::once(card(Vec3::ONE, 1e30)));
    assert!(Octahedral::bake(&huge, &params(), &control).is_err());
    let baked = bake(&mesh, &params());
    let Camera::Placed(pose) = from(Vec3::X, &baked, 6.0) else { unreachable!() };
    let nowhere = Camera::Placed(Pose { eye: Vec3::NAN, ..pose });
    assert!(baked.view(&nowhere, 8, 8, &control).is_err());
    assert!(baked.view(&Camera::default(), 8, 8, &control).is_err());
    assert!(baked.view(&Camera::Placed(pose), 0, 8, &control).is_err());
}
