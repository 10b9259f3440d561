//! The whole renderer on small hand-made scenes.

use super::*;
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};
use std::sync::Arc;
use tree_core::Control;
use tree_mesh::{Alpha, Material, Mesh, Surface, Texture};

pub(super) fn colored(color: [f32; 3]) -> Material {
    let [r, g, b] = color;
    Material { base_color: [r, g, b, 1.0], ..Material::default() }
}

pub(super) fn surface(positions: &[Vec3], indices: &[u32], normal: Vec3, material: u32) -> Surface {
    Surface {
        normals: vec![normal; positions.len()],
        uvs: positions.iter().map(|p| Vec2::new(p.x, p.y)).collect(),
        positions: positions.to_vec(),
        indices: indices.to_vec(),
        material,
        ..Default::default()
    }
}

/// A square of side 2 in the xy plane, centred on the z axis.
pub(super) fn square(z: f32, material: u32) -> Surface {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    surface(&corners.map(|(x, y)| Vec3::new(x, y, z)), &[0, 1, 2, 0, 2, 3], Vec3::Z, material)
}

pub(super) fn mesh(surfaces: Vec<Surface>, materials: Vec<Material>) -> Mesh {
    Mesh { surfaces, materials, ..Default::default() }
}

pub(super) fn sphere(radius: f32, center: Vec3, n: u32) -> Surface {
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
pub(super) fn flat_view(size: u32, samples: u32, height: f32) -> View {
    let (eye, target) = (Vec3::Z * 10.0, Vec3::ZERO);
    let lens = Lens::Orthographic { height };
    let camera = Camera::Placed(Pose { eye, target, up: Vec3::Y, lens });
    View { width: size, height: size, samples, camera }
}

pub(super) fn quick() -> Style {
    Style { sun_map_px: 256, sky_map_px: 64, sky_directions: 6, ..Style::default() }
}

pub(super) fn bare() -> Style {
    Style { ground: None, ..quick() }
}

pub(super) fn pixel(picture: &Picture, x: u32, y: u32) -> [i32; 3] {
    let [r, g, b, _] = picture.pixel(x, y).unwrap().map(i32::from);
    [r, g, b]
}

#[test]
fn a_triangle_covers_as_many_pixels_as_its_area() {
    let corners =
        [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(-1.0, 1.0, 0.0)];
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
        for camera in [
            flat_view(32, 2, 4.0).camera,
            Camera::Framed(Framing { yaw: 0.0, ..Framing::default() }),
        ] {
            let view = View { camera, ..flat_view(32, 2, 4.0) };
            let picture = render(&mesh, &view, &bare(), &Control::default()).unwrap();
            let [r, _, b] = pixel(&picture, 16, 16);
            assert!(b > 2 * r, "{r} {b}");
        }
    }
}

/// Opaque left and right, a hole in the middle third.
pub(super) fn holed() -> Material {
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
    let texture =
        Texture { name: "needles".into(), width: 256, height: 256, pixels: pixels.collect() };
    let material = Material {
        texture: Some(Arc::new(texture)),
        alpha: Alpha::Mask(0.5),
        ..Material::default()
    };
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
    let corners =
        [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, z)| Vec3::new(x, 4.0, z));
    let mesh =
        mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Y, 0)], vec![Material::default()]);
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
    let corners =
        [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
    let mesh =
        mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Z, 0)], vec![colored([0.5; 3])]);
    let style = Style {
        sun_yaw: 0.3,
        sun_pitch: 0.7,
        sky: 0.3,
        sky_directions: 0,
        sun_map_px: 512,
        ..quick()
    };
    let seen_from = |z: f32| {
        let lens = Lens::Orthographic { height: 4.0 };
        let camera = Camera::Placed(Pose {
            eye: Vec3::new(0.0, 5.0, z),
            target: Vec3::ZERO,
            up: Vec3::Y,
            lens,
        });
        let view = View { width: 128, height: 128, samples: 2, camera };
        render(&mesh, &view, &style, &Control::default()).unwrap()
    };
    let front = seen_from(10.0);
    let shades: Vec<i32> = (20..60)
        .flat_map(|y| (40..90).map(move |x| (x, y)))
        .map(|(x, y)| pixel(&front, x, y)[1])
        .collect();
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
    let framing =
        Framing { yaw: 1.0, pitch: -0.4, margin: 0.0, orthographic: true, ..Framing::default() };
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
    for (orthographic, fov, aspect) in
        [(true, 0.6, 1.0), (false, 0.6, 1.0), (false, 1.5, 0.4), (false, 0.1, 3.0)]
    {
        let framing = Framing { yaw: 0.5, pitch: 0.7, fov, margin: 0.1, orthographic };
        let height = 200;
        let width = (height as f32 * aspect) as u32;
        let view = View { width, height, samples: 1, camera: Camera::Framed(framing) };
        let mask = mask(&mesh, &view, &Control::default()).unwrap();
        let on: Vec<_> = (0..width * height).filter(|&i| mask.coverage[i as usize] > 0).collect();
        let (left, right) = (
            on.iter().map(|i| i % width).min().unwrap(),
            on.iter().map(|i| i % width).max().unwrap(),
        );
        let (top, bottom) = (on[0] / width, on[on.len() - 1] / width);
        let tight_x = (right - left + 1) as f32 / width as f32;
        let tight_y = (bottom - top + 1) as f32 / height as f32;
        assert!((tight_x.max(tight_y) - 0.8).abs() < 0.03, "{framing:?}: {tight_x} {tight_y}");
        assert!(
            (left + right).abs_diff(width) < 5 && (top + bottom).abs_diff(height) < 5,
            "centred"
        );
    }
}

#[test]
fn a_triangle_through_the_camera_is_clipped_not_lost() {
    // The ground as two triangles, reaching far behind the eye.
    let corners = [(-500.0, 500.0), (500.0, 500.0), (500.0, -500.0), (-500.0, -500.0)]
        .map(|(x, z)| Vec3::new(x, 0.0, z));
    let mesh =
        mesh(vec![surface(&corners, &[0, 1, 2, 0, 2, 3], Vec3::Y, 0)], vec![Material::default()]);
    let lens = Lens::Perspective { fov: 1.0 };
    let camera = Camera::Placed(Pose {
        eye: Vec3::new(0.0, 2.0, 0.0),
        target: Vec3::new(1.0, 2.0, 0.3),
        up: Vec3::Y,
        lens,
    });
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
