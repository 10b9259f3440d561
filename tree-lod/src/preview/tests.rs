//! The whole renderer on small hand-made scenes.

use super::*;
use crate::LodError;
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::f32::consts::{PI, TAU};
use std::sync::Arc;
use tree_core::{CancelFlag, Control, LimitError, Limits};
use tree_mesh::{Alpha, Material, Mesh, MeshError, Surface, Texture};

fn colored(color: [f32; 3]) -> Material {
    let [r, g, b] = color;
    Material { base_color: [r, g, b, 1.0], ..Material::default() }
}

fn surface(positions: &[Vec3], indices: &[u32], normal: Vec3, material: u32) -> Surface {
    Surface {
        normals: vec![normal; positions.len()],
        uvs: positions.iter().map(|p| Vec2::new(p.x, p.y)).collect(),
        positions: positions.to_vec(),
        indices: indices.to_vec(),
        material,
    }
}

/// A square of side 2 in the xy plane, centred on the z axis.
fn square(z: f32, material: u32) -> Surface {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    surface(&corners.map(|(x, y)| Vec3::new(x, y, z)), &[0, 1, 2, 0, 2, 3], Vec3::Z, material)
}

fn mesh(surfaces: Vec<Surface>, materials: Vec<Material>) -> Mesh {
    Mesh { surfaces, materials }
}

fn sphere(radius: f32, center: Vec3, n: u32) -> Surface {
    let mut sphere = Surface::default();
    for row in 0..=n {
        let (sin, cos) = libm::sincosf(PI * row as f32 / n as f32);
        for column in 0..=2 * n {
            let (s, c) = libm::sincosf(TAU * column as f32 / (2 * n) as f32);
            let normal = Vec3::new(sin * c, cos, -sin * s);
            sphere.positions.push(center + normal * radius);
            sphere.normals.push(normal);
            sphere.uvs.push(Vec2::new(column as f32, row as f32) / n as f32);
        }
    }
    for row in 0..n {
        for column in 0..2 * n {
            let a = row * (2 * n + 1) + column;
            let b = a + 2 * n + 1;
            sphere.indices.extend([a, b, a + 1, a + 1, b, b + 1]);
        }
    }
    sphere
}

/// Looks along -Z at a picture `height` metres high around the origin.
fn flat_view(size: u32, samples: u32, height: f32) -> View {
    let (eye, target) = (Vec3::Z * 10.0, Vec3::ZERO);
    let lens = Lens::Orthographic { height };
    let camera = Camera::Placed(Pose { eye, target, up: Vec3::Y, lens });
    View { width: size, height: size, samples, camera }
}

fn quick() -> Style {
    Style { sun_map_px: 256, sky_map_px: 64, sky_directions: 6, ..Style::default() }
}

fn bare() -> Style {
    Style { ground: None, ..quick() }
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [i32; 3] {
    let [r, g, b, _] = picture.pixel(x, y).unwrap().map(i32::from);
    [r, g, b]
}

#[test]
fn a_triangle_covers_as_many_pixels_as_its_area() {
    let corners = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(-1.0, 1.0, 0.0)];
    let mesh = mesh(vec![surface(&corners, &[0, 1, 2], Vec3::Z, 0)], vec![Material::default()]);
    for samples in 1..=4 {
        let mask = mask(&mesh, &flat_view(64, samples, 4.0), &Control::default()).unwrap();
        // 32 × 32 / 2, and half of the samples on the diagonal.
        let diagonal = 32.0 / samples as f64;
        assert!((mask.area() - 512.0).abs() <= 0.5 * diagonal + 0.5, "{}", mask.area());
    }
}

#[test]
fn the_nearer_triangle_wins_in_either_order() {
    let materials = vec![colored([0.8, 0.0, 0.0]), colored([0.0, 0.0, 0.8])];
    for order in [[0, 1], [1, 0]] {
        let surfaces = order.map(|near| square(if near == 1 { 0.5 } else { -0.5 }, near));
        let mesh = mesh(surfaces.to_vec(), materials.clone());
        for camera in [flat_view(32, 2, 4.0).camera, Camera::Framed(Framing { yaw: 0.0, ..Framing::default() })] {
            let view = View { camera, ..flat_view(32, 2, 4.0) };
            let picture = render(&mesh, &view, &bare(), &Control::default()).unwrap();
            let [r, _, b] = pixel(&picture, 16, 16);
            assert!(b > 2 * r, "{r} {b}");
        }
    }
}

/// Opaque left and right, a hole in the middle third.
fn holed() -> Material {
    let pixels = (0..48 * 48).flat_map(|i| {
        let hole = (16..32).contains(&(i % 48));
        [255, 255, 255, if hole { 0 } else { 255 }]
    });
    let texture = Texture { name: "hole".into(), width: 48, height: 48, pixels: pixels.collect() };
    Material { texture: Some(Arc::new(texture)), alpha: Alpha::Mask(0.5), ..Material::default() }
}

#[test]
fn holes_of_the_alpha_mask_show_what_is_behind() {
    let mut front = square(0.5, 0);
    front.uvs = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let materials = vec![holed(), colored([0.8, 0.0, 0.0])];
    let both = mesh(vec![front.clone(), square(-0.5, 1)], materials.clone());
    let picture = render(&both, &flat_view(48, 1, 2.0), &bare(), &Control::default()).unwrap();
    let redness = |x| {
        let [r, g, _] = pixel(&picture, x, 24);
        r - g
    };
    assert!(redness(24) > 60 && redness(4).abs() < 40 && redness(44).abs() < 40);
    let alone = mesh(vec![front], materials);
    // At every size, magnified and minified, two thirds are covered.
    for size in [6, 12, 48, 192] {
        let mask = mask(&alone, &flat_view(size, 4, 2.0), &Control::default()).unwrap();
        let share = mask.area() / f64::from(size * size);
        assert!((share - 2.0 / 3.0).abs() < 0.02, "{size} px: {share}");
    }
}

#[test]
fn far_leaves_do_not_vanish() {
    // Thin stripes: one texel in eight.
    let pixels = (0..256 * 256).flat_map(|i| [0, 255, 0, if i % 8 == 0 { 255 } else { 0 }]);
    let texture = Texture { name: "needles".into(), width: 256, height: 256, pixels: pixels.collect() };
    let material = Material { texture: Some(Arc::new(texture)), alpha: Alpha::Mask(0.5), ..Material::default() };
    let mut card = square(0.0, 0);
    card.uvs = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mesh = mesh(vec![card], vec![material]);
    for size in [512, 64, 16] {
        let mask = mask(&mesh, &flat_view(size, 2, 2.0), &Control::default()).unwrap();
        assert!(mask.area() > 0.08 * f64::from(size * size), "{size} px: {}", mask.area());
    }
}

#[test]
fn the_shadow_falls_where_geometry_says() {
    // A level square, 4 m above the ground; the sun stands at 45° over +Z, so its shadow is moved by
    // 4 m towards -Z.
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, z)| Vec3::new(x, 4.0, z));
    let mesh = mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Y, 0)], vec![Material::default()]);
    let style = Style { sun_yaw: 0.0, sun_pitch: PI / 4.0, sky: 0.2, ..quick() };
    // From straight above, at 16 pixels per metre, z = -4 in the middle.
    let (eye, target) = (Vec3::new(0.0, 30.0, -4.0), Vec3::new(0.0, 0.0, -4.0));
    let lens = Lens::Orthographic { height: 8.0 };
    let camera = Camera::Placed(Pose { eye, target, up: Vec3::NEG_Z, lens });
    let view = View { width: 128, height: 128, samples: 2, camera };
    let picture = render(&mesh, &view, &style, &Control::default()).unwrap();
    let green = |x: f32, z: f32| {
        pixel(&picture, (64.0 + 16.0 * x) as u32, (64.0 + 16.0 * (z + 4.0)) as u32)[1]
    };
    let lit = green(3.0, -4.0);
    for (x, z) in [(0.0, -4.0), (0.8, -4.8), (-0.8, -3.2), (0.8, -3.2)] {
        assert!(green(x, z) < lit / 2, "({x}, {z}) should be dark: {} of {lit}", green(x, z));
    }
    for (x, z) in [(1.3, -4.0), (-1.3, -4.0), (0.0, -5.3), (0.0, -2.7)] {
        assert!(green(x, z) > lit * 3 / 4, "({x}, {z}) should be lit: {} of {lit}", green(x, z));
    }
}

#[test]
fn the_shadow_touches_what_casts_it_and_lit_faces_have_no_acne() {
    // A wall on the ground, seen from its sunny side and from behind.
    let corners = [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
    let mesh = mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Z, 0)], vec![colored([0.5; 3])]);
    let style = Style { sun_yaw: 0.3, sun_pitch: 0.7, sky: 0.3, sky_directions: 0, sun_map_px: 512, ..quick() };
    let seen_from = |z: f32| {
        let lens = Lens::Orthographic { height: 4.0 };
        let camera = Camera::Placed(Pose { eye: Vec3::new(0.0, 5.0, z), target: Vec3::ZERO, up: Vec3::Y, lens });
        let view = View { width: 128, height: 128, samples: 2, camera };
        render(&mesh, &view, &style, &Control::default()).unwrap()
    };
    let front = seen_from(10.0);
    let shades: Vec<i32> = (20..60).flat_map(|y| (40..90).map(move |x| (x, y))).map(|(x, y)| pixel(&front, x, y)[1]).collect();
    let (darkest, brightest) = (shades.iter().min().unwrap(), shades.iter().max().unwrap());
    assert!(brightest - darkest < 12, "acne: {darkest} to {brightest}");
    // Just behind the wall's foot the ground lies in shadow; far to the side it does not.
    let back = seen_from(-10.0);
    let ground = |x: u32, y: u32| pixel(&back, x, y)[1];
    for x in [50, 64, 78] {
        assert!(ground(x, 66) < ground(5, 66) * 2 / 3, "{x}: {} {}", ground(x, 66), ground(5, 66));
    }
}

#[test]
fn the_silhouette_of_a_sphere_is_a_disc() {
    let mesh = mesh(vec![sphere(1.0, Vec3::new(3.0, -2.0, 1.0), 48)], vec![Material::default()]);
    let framing = Framing { yaw: 1.0, pitch: -0.4, margin: 0.0, orthographic: true, ..Framing::default() };
    let view = View { width: 200, height: 150, samples: 3, camera: Camera::Framed(framing) };
    let mask = mask(&mesh, &view, &Control::default()).unwrap();
    let expected = f64::from(PI) * 75.0 * 75.0;
    assert!((mask.area() / expected - 1.0).abs() < 0.005, "{} {expected}", mask.area());
    let picture = silhouette(&mesh, &view, &Control::default()).unwrap();
    assert_eq!((pixel(&picture, 100, 75), pixel(&picture, 0, 0)), ([0; 3], [255; 3]));
}

#[test]
fn framing_fills_the_picture_up_to_the_margin() {
    let mesh = mesh(vec![sphere(1.0, Vec3::Y, 32)], vec![Material::default()]);
    for (orthographic, fov, aspect) in [(true, 0.6, 1.0), (false, 0.6, 1.0), (false, 1.5, 0.4), (false, 0.1, 3.0)] {
        let framing = Framing { yaw: 0.5, pitch: 0.7, fov, margin: 0.1, orthographic };
        let height = 200;
        let width = (height as f32 * aspect) as u32;
        let view = View { width, height, samples: 1, camera: Camera::Framed(framing) };
        let mask = mask(&mesh, &view, &Control::default()).unwrap();
        let on: Vec<_> = (0..width * height).filter(|&i| mask.coverage[i as usize] > 0).collect();
        let (left, right) = (on.iter().map(|i| i % width).min().unwrap(), on.iter().map(|i| i % width).max().unwrap());
        let (top, bottom) = (on[0] / width, on[on.len() - 1] / width);
        let tight_x = (right - left + 1) as f32 / width as f32;
        let tight_y = (bottom - top + 1) as f32 / height as f32;
        assert!((tight_x.max(tight_y) - 0.8).abs() < 0.03, "{framing:?}: {tight_x} {tight_y}");
        assert!((left + right).abs_diff(width) < 5 && (top + bottom).abs_diff(height) < 5, "centred");
    }
}

#[test]
fn a_triangle_through_the_camera_is_clipped_not_lost() {
    // The ground as two triangles, reaching far behind the eye.
    let corners = [(-500.0, 500.0), (500.0, 500.0), (500.0, -500.0), (-500.0, -500.0)].map(|(x, z)| Vec3::new(x, 0.0, z));
    let mesh = mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Y, 0)], vec![Material::default()]);
    let lens = Lens::Perspective { fov: 1.0 };
    let camera = Camera::Placed(Pose { eye: Vec3::new(0.0, 2.0, 0.0), target: Vec3::new(1.0, 2.0, 0.3), up: Vec3::Y, lens });
    let view = View { width: 64, height: 64, samples: 2, camera };
    let mask = mask(&mesh, &view, &Control::default()).unwrap();
    for (i, &c) in mask.coverage.iter().enumerate() {
        match i / 64 {
            0..31 => assert_eq!(c, 0, "sky at {i}"),
            33.. => assert_eq!(c, 255, "ground at {i}"),
            _ => {}
        }
    }
}

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
    for empty in [Mesh::default(), mesh(vec![surface(&[], &[], Vec3::Y, 0)], vec![Material::default()])] {
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
    let nonsense = Material {
        base_color: [f32::NAN, -1.0, f32::INFINITY, 1.0],
        roughness: f32::NAN,
        translucency: f32::INFINITY,
        ..holed()
    };
    for surfaces in [vec![point], vec![line], vec![far], vec![wild]] {
        let mesh = mesh(surfaces, vec![Material::default(), nonsense.clone()]);
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
        let picture = render(&mesh, &View { camera, ..view.clone() }, &style, &Control::default()).unwrap();
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
        assert!(matches!(result, Some(LodError::Limit(LimitError { requested: 4_294_967_296.., .. }))));
    }
    limits.triangles = 1;
    let mesh = mesh(vec![square(0.0, 0)], vec![Material::default()]);
    let result = mask(&mesh, &View::default(), &Control::default().with_limits(limits));
    assert!(matches!(result, Err(LodError::Limit(LimitError { requested: 2, cap: 1, .. }))));
}

#[test]
fn bad_parameters_are_named() {
    let name = |view: &View, style: &Style| match render(&Mesh::default(), view, style, &Control::default()) {
        Err(LodError::Parameter { field, .. } | LodError::Camera { field, .. }) => field,
        other => panic!("{other:?}"),
    };
    let (view, style) = (View::default, Style::default);
    assert_eq!(name(&View { width: 0, ..view() }, &style()), "view.width");
    assert_eq!(name(&View { height: 16_385, ..view() }, &style()), "view.height");
    assert_eq!(name(&View { samples: 5, ..view() }, &style()), "view.samples");
    let framed = |framing| View { camera: Camera::Framed(framing), ..view() };
    assert_eq!(name(&framed(Framing { yaw: f32::NAN, ..Framing::default() }), &style()), "camera.yaw");
    assert_eq!(name(&framed(Framing { fov: 3.0, ..Framing::default() }), &style()), "camera.fov");
    assert_eq!(name(&framed(Framing { margin: 0.5, ..Framing::default() }), &style()), "camera.margin");
    let lens = Lens::Perspective { fov: 1.0 };
    let placed = |eye, target, up| View { camera: Camera::Placed(Pose { eye, target, up, lens }), ..view() };
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
    let picture = render(&mesh, &flat_view(24, 1, 3.0), &quick(), &Control::default()).unwrap();
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
