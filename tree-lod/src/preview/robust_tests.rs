//! What comes in wrong, empty or cut short, and what must not depend on chance.

use super::tests::{bare, colored, holed, mesh, pixel, quick, sphere, square, surface};
use super::*;
use crate::LodError;
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::sync::Arc;
use tree_core::{CancelFlag, Control, LimitError, Limits};
use tree_mesh::{Material, Mesh, MeshError};

#[test]
fn one_thread_or_many_give_the_same_bits() {
    let mut leaf = square(0.4, 1);
    leaf.uvs = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mesh = mesh(vec![sphere(1.0, Vec3::Y, 40), leaf], vec![colored([0.3, 0.5, 0.1]), holed()]);
    let view = View { width: 150, height: 130, samples: 3, camera: Camera::default() };
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| render(&mesh, &view, &quick(), &Control::default()).unwrap())
    };
    let one = with(1);
    assert_eq!(one, with(2));
    assert_eq!(one, with(5));
}

#[test]
fn an_empty_mesh_shows_the_ground_alone() {
    let (view, control) = (View { width: 40, height: 30, ..View::default() }, Control::default());
    for empty in
        [Mesh::default(), mesh(vec![surface(&[], &[], Vec3::Y, 0)], vec![Material::default()])]
    {
        for style in [quick(), bare(), Style::studio(), Style { ground: None, ..Style::studio() }] {
            let picture = render(&empty, &view, &style, &control).unwrap();
            assert!(picture.pixels.chunks(4).all(|p| p[3] == 255));
        }
        let white = silhouette(&empty, &view, &control).unwrap();
        assert!(white.pixels.iter().all(|&byte| byte == 255));
        assert_eq!(mask(&empty, &view, &control).unwrap().area(), 0.0);
    }
    let picture = render(&Mesh::default(), &view, &quick(), &control).unwrap();
    let ([_, g, b], sky) = (pixel(&picture, 20, 29), pixel(&picture, 20, 0));
    assert!(g > b && sky[2] > sky[1], "grass below, sky above: {g} {b} {sky:?}");
}

#[test]
fn degenerate_triangles_and_single_points_do_no_harm() {
    let point = surface(&[Vec3::ONE; 3], &[0, 1, 2], Vec3::Y, 0);
    let line = surface(&[Vec3::ZERO, Vec3::Y, Vec3::Y * 2.0], &[0, 1, 2], Vec3::ZERO, 0);
    let far = surface(&[Vec3::splat(-1e30), Vec3::splat(1e30), Vec3::Y], &[0, 1, 2], Vec3::Y, 0);
    let mut wild = square(0.0, 1);
    wild.uvs = vec![Vec2::splat(1e30), Vec2::splat(-1e30), Vec2::ZERO, Vec2::splat(f32::MAX)];
    let extreme = Material {
        base_color: [f32::MAX, 0.0, 1e30, 1.0],
        roughness: 0.0,
        translucency: 1.0,
        ..holed()
    };
    for surfaces in [vec![point], vec![line], vec![far], vec![wild]] {
        let mesh = mesh(surfaces, vec![Material::default(), extreme.clone()]);
        let view = View { width: 32, height: 32, ..View::default() };
        render(&mesh, &view, &quick(), &Control::default()).unwrap();
        silhouette(&mesh, &view, &Control::default()).unwrap();
    }
}

#[test]
fn roots_below_the_ground_are_hidden_unless_there_is_none() {
    let mesh = mesh(vec![sphere(1.0, Vec3::Y * -3.0, 16)], vec![colored([1.0, 0.0, 0.0])]);
    let view = View { width: 64, height: 64, ..View::default() };
    let red = |ground| {
        let style = Style { ground, ..quick() };
        let camera = Camera::Framed(Framing { pitch: 0.8, margin: 0.4, ..Framing::default() });
        let picture =
            render(&mesh, &View { camera, ..view.clone() }, &style, &Control::default()).unwrap();
        let [r, g, _] = pixel(&picture, 32, 32);
        r > 2 * g
    };
    assert!(!red(Some(0.0)) && red(Some(-5.0)) && red(None));
}

#[test]
fn pixels_are_counted_before_memory_is_taken() {
    let view = View { width: 16_384, height: 16_384, samples: 4, ..View::default() };
    let mut limits = Limits::default();
    for result in [
        render(&Mesh::default(), &view, &Style::default(), &Control::default()).err(),
        mask(&Mesh::default(), &view, &Control::default()).err(),
    ] {
        assert!(matches!(
            result,
            Some(LodError::Limit(LimitError { requested: 4_294_967_296.., .. }))
        ));
    }
    limits.triangles = 1;
    let mesh = mesh(vec![square(0.0, 0)], vec![Material::default()]);
    let result = mask(&mesh, &View::default(), &Control::default().with_limits(limits));
    assert!(matches!(result, Err(LodError::Limit(LimitError { requested: 2, cap: 1, .. }))));
}

#[test]
fn bad_parameters_are_named() {
    let name = |view: &View, style: &Style| match render(
        &Mesh::default(),
        view,
        style,
        &Control::default(),
    ) {
        Err(LodError::Parameter(error)) => error.field,
        Err(LodError::Camera { field, .. }) => field.into(),
        other => panic!("{other:?}"),
    };
    let (view, style) = (View::default, Style::default);
    assert_eq!(name(&View { width: 0, ..view() }, &style()), "view.width");
    assert_eq!(name(&View { height: 16_385, ..view() }, &style()), "view.height");
    assert_eq!(name(&View { samples: 5, ..view() }, &style()), "view.samples");
    let framed = |framing| View { camera: Camera::Framed(framing), ..view() };
    assert_eq!(
        name(&framed(Framing { yaw: f32::NAN, ..Framing::default() }), &style()),
        "camera.yaw"
    );
    assert_eq!(name(&framed(Framing { fov: 3.0, ..Framing::default() }), &style()), "camera.fov");
    assert_eq!(
        name(&framed(Framing { margin: 0.5, ..Framing::default() }), &style()),
        "camera.margin"
    );
    let lens = Lens::Perspective { fov: 1.0 };
    let placed =
        |eye, target, up| View { camera: Camera::Placed(Pose { eye, target, up, lens }), ..view() };
    assert_eq!(name(&placed(Vec3::X, Vec3::X, Vec3::Y), &style()), "camera.target");
    assert_eq!(name(&placed(Vec3::Y, Vec3::ZERO, Vec3::Y), &style()), "camera.up");
    assert_eq!(name(&placed(Vec3::NAN, Vec3::ZERO, Vec3::Y), &style()), "camera.eye");
    assert_eq!(name(&view(), &Style { sun: -1.0, ..style() }), "style.sun");
    assert_eq!(name(&view(), &Style { ground: Some(f32::INFINITY), ..style() }), "style.ground");
    assert_eq!(name(&view(), &Style { sky_directions: 65, ..style() }), "style.sky_directions");
    let mut broken = mesh(vec![square(0.0, 0)], vec![Material::default()]);
    broken.surfaces[0].positions[1].x = f32::NAN;
    let result = render(&broken, &view(), &style(), &Control::default());
    assert!(matches!(result, Err(LodError::Mesh(MeshError::NotFinite { index: 1, .. }))));
    let glass = Material { roughness: f32::NAN, ..Material::default() };
    let result = render(&mesh(vec![], vec![glass]), &view(), &style(), &Control::default());
    let Err(LodError::Mesh(MeshError::Material { material: 0, field: "roughness", .. })) = result
    else {
        panic!("{result:?}");
    };
}

#[test]
fn cancelling_stops_and_progress_never_falls() {
    let flag = CancelFlag::default();
    flag.cancel();
    let mesh = mesh(vec![square(0.0, 0)], vec![Material::default()]);
    let view = View { width: 64, height: 64, ..View::default() };
    let cancelled = Control::default().with_cancel(flag);
    assert!(matches!(render(&mesh, &view, &quick(), &cancelled), Err(LodError::Cancelled(_))));
    assert!(matches!(mask(&mesh, &view, &cancelled), Err(LodError::Cancelled(_))));
    let seen = Arc::new(std::sync::Mutex::new(Vec::new()));
    let sink = seen.clone();
    let control = Control::default().with_progress(move |p| sink.lock().unwrap().push(p.fraction));
    render(&mesh, &View { width: 256, height: 2048, ..view }, &quick(), &control).unwrap();
    let seen = seen.lock().unwrap();
    assert!(seen.len() > 8 && seen.is_sorted() && seen.last() == Some(&1.0), "{seen:?}");
}

#[cfg(feature = "image")]
#[test]
fn a_png_holds_the_same_pixels() {
    let mesh = mesh(vec![square(0.0, 0)], vec![Material::default()]);
    let view = tests::flat_view(24, 1, 3.0);
    let picture = render(&mesh, &view, &quick(), &Control::default()).unwrap();
    let decoded = image::load_from_memory(&picture.to_png().unwrap()).unwrap().to_rgba8();
    assert_eq!((decoded.width(), decoded.height()), (24, 24));
    assert_eq!(decoded.into_raw(), picture.pixels);
    assert!(matches!(picture.save_png("/no/such/folder/a.png"), Err(LodError::Core(_))));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn neighbours_leave_no_gap_from_any_camera(
        eye in prop::array::uniform3(-3.0_f32..3.0),
        fov in 0.3_f32..2.0,
        near_origin in prop::array::uniform3(-0.3_f32..0.3),
    ) {
        // Inside a closed sphere every sample sees a wall, across whatever the near plane cuts.
        let mesh = mesh(vec![sphere(6.0, Vec3::ZERO, 12)], vec![Material::default()]);
        let eye = Vec3::from_array(eye);
        let target = Vec3::from_array(near_origin) - eye;
        prop_assume!((target - eye).length() > 0.1);
        let up = (target - eye).any_orthonormal_vector();
        let camera = Camera::Placed(Pose { eye, target, up, lens: Lens::Perspective { fov } });
        let view = View { width: 61, height: 47, samples: 2, camera };
        let mask = mask(&mesh, &view, &Control::default()).unwrap();
        prop_assert!(mask.coverage.iter().all(|&c| c == 255));
    }
}
