use super::*;
use crate::preview::{Camera, View};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::sync::Arc;
use tree_core::Control;
use tree_mesh::{Alpha, Material, Mesh, Surface, Texture};

fn soup(triangles: &[[Vec3; 3]]) -> Mesh {
    let mut surface = Surface::default();
    for (i, corner) in triangles.iter().flatten().enumerate() {
        surface.positions.push(*corner);
        surface.normals.push(Vec3::Z);
        surface.uvs.push([Vec2::ZERO, Vec2::X, Vec2::Y][i % 3]);
        surface.indices.push(i as u32);
    }
    Mesh { surfaces: vec![surface], materials: vec![Material::default()], ..Mesh::default() }
}

fn checkered(mut mesh: Mesh) -> Mesh {
    let pixel =
        |i: u32| [90, 90, 90, if (i % 64 / 8 + i / 64 / 8).is_multiple_of(2) { 255 } else { 0 }];
    let pixels = (0..64 * 64).flat_map(pixel).collect();
    mesh.materials[0] = Material {
        alpha: Alpha::Mask(0.5),
        texture: Some(Arc::new(Texture { name: "checker".into(), width: 64, height: 64, pixels })),
        ..Material::default()
    };
    mesh
}

fn corner() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-1.0_f32..1.0).prop_map(Vec3::from_array)
}

/// Pixels in which the mask and the preview's differ; both test the middles of pixels, but the
/// preview rounds corners to 1/256 pixel.
fn differing(mesh: &Mesh, camera: Camera) -> (u64, u64) {
    let control = Control::default();
    let bits = mask(mesh, &camera, 96, &control).unwrap();
    let view = View { width: 96, height: 96, samples: 1, camera };
    let other = crate::preview::mask(mesh, &view, &control).unwrap();
    let n = bits.to_bytes().iter().zip(&other.coverage).filter(|(a, b)| a != b).count();
    (n as u64, bits.count())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn masks_are_those_of_the_preview(triangles in prop::collection::vec(prop::array::uniform3(corner()), 1..40), perspective: bool, textured: bool) {
        let mesh = soup(&triangles);
        let mesh = if textured { checkered(mesh) } else { mesh };
        let around = Around { azimuths: 3, pitches: vec![0.3], fov: perspective.then_some(0.8), ..Around::default() };
        for camera in around.cameras() {
            let (differing, covered) = differing(&mesh, camera);
            prop_assert!(differing <= 4 + covered / 100, "{differing} of {covered}");
        }
    }

    #[test]
    fn triangles_that_share_an_edge_cover_each_pixel_once(corners in prop::array::uniform3(corner())) {
        let [a, b, c] = corners;
        let mesh = soup(&[[a, b, c]]);
        let cameras = Around { azimuths: 1, ..Around::default() }.cameras();
        let inside = (a + b + c) / 3.0;
        let parts = soup(&[[a, b, inside], [b, c, inside], [c, a, inside]]);
        let scores = score(&parts, &mesh, &cameras, 64, &Control::default()).unwrap();
        prop_assert!(scores[0].wrong + scores[0].missed <= 2, "{:?}", scores[0]);
    }
}

#[test]
fn a_camera_within_the_tree_sees_what_the_preview_sees() {
    let near =
        |z: f32| [Vec3::new(-3.0, -1.0, z), Vec3::new(3.0, -1.0, -z), Vec3::new(0.0, 2.0, -1.0)];
    let mesh = checkered(soup(&[near(0.5), near(2.0), near(-0.3)]));
    let lens = crate::preview::Lens::Perspective { fov: 1.0 };
    let pose = crate::preview::Pose { eye: Vec3::ZERO, target: Vec3::NEG_Z, up: Vec3::Y, lens };
    let (differing, covered) = differing(&mesh, Camera::Placed(pose));
    assert!(covered > 500 && differing < covered / 30, "{differing} of {covered}");
}

#[test]
fn spans_set_and_count_across_words() {
    let mut bits = Bits::new(200, 2);
    bits.set_span(1, 60, 130);
    assert_eq!(
        (bits.count(), bits.get(59, 1), bits.get(60, 1), bits.get(130, 1)),
        (70, false, true, false)
    );
    let mut full = Bits::new(200, 2);
    full.set_span(1, 0, 100);
    assert_eq!(bits.score(&full), crate::quality::Score { both: 40, wrong: 30, missed: 60 });
}

#[test]
fn sizes_and_views_outside_their_range_are_refused() {
    let mesh = soup(&[[Vec3::ZERO, Vec3::X, Vec3::Y]]);
    let control = Control::default();
    assert!(mask(&mesh, &Camera::default(), 4, &control).is_err());
    assert!(Stage::new(&mesh, &[], 64, &[], &control).is_err());
    assert!(Around { azimuths: 0, ..Around::default() }.validate().is_err());
    assert!(Around { pitches: vec![f32::NAN], ..Around::default() }.validate().is_err());
}
