use super::*;
use crate::error::LodError;
use crate::impostor::boxes::{BoxParams, Boxes};
use crate::impostor::tests::{Forked, forked};
use crate::preview::{Camera, Lens, Pose};
use glam::Vec3;
use tree_core::{CancelFlag, Control, Limits};

fn params() -> CardParams {
    CardParams { size: 32, samples: 2, gutter: 1 }
}

fn cards(n_leaves: usize) -> (Forked, Cards) {
    let tree = forked(n_leaves);
    let cards =
        Cards::bake(&tree.mesh, &tree.elements, &tree.boxes, &params(), &Control::default());
    (tree, cards.unwrap())
}

fn from(direction: Vec3, of: &Cards) -> Camera {
    let center = of.boxes().boxes()[0].center;
    let lens = Lens::Orthographic { height: 9.0 };
    Camera::Placed(Pose { eye: center + 50.0 * direction, target: center, up: Vec3::Y, lens })
}

#[test]
fn planes_go_through_opposite_edges() {
    let (tree, _) = cards(90);
    for leaf_box in tree.boxes.boxes() {
        let faces = planes(leaf_box);
        for (number, face) in faces.iter().enumerate() {
            assert!(face.right.cross(face.up).distance(face.normal) < 1e-5);
            for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let corner = face.right * face.half.x * x + face.up * face.half.y * y;
                let local = leaf_box.turn.inverse() * corner;
                assert!(
                    (local.abs() - leaf_box.half).abs().max_element() < 1e-3,
                    "{number} {local}"
                );
            }
            assert!(
                faces[..number].iter().all(|other| other.normal.dot(face.normal).abs() < 0.999)
            );
        }
    }
}

#[test]
fn seen_along_a_normal_the_picture_is_that_of_the_leaves() {
    let tree = forked(900);
    let sharp = CardParams { size: 128, ..params() };
    let cards = Cards::bake(&tree.mesh, &tree.elements, &tree.boxes, &sharp, &Control::default());
    let cards = cards.unwrap();
    for plane in planes(&tree.boxes.boxes()[0]) {
        let up = if plane.normal.y.abs() > 0.9 { Vec3::X } else { Vec3::Y };
        let Camera::Placed(pose) = from(plane.normal, &cards) else { unreachable!() };
        let camera = Camera::Placed(Pose { up, ..pose });
        let control = Control::default();
        let seen = cards.view(&[0], &camera, [160, 160], &control).unwrap();
        let full = crate::cover::mask(&tree.mesh, &camera, 160, &control).unwrap();
        let (mut both, mut either) = (0, 0);
        for i in 0..160 * 160 {
            let (a, b) = (seen.pixel(i % 160, i / 160).unwrap()[3] > 0, full.get(i % 160, i / 160));
            both += u32::from(a && b);
            either += u32::from(a || b);
        }
        // Mirrored or turned pictures have about a third.
        assert!(f64::from(both) > 0.5 * f64::from(either), "{both} of {either}");
    }
}

#[test]
fn more_planes_do_not_cover_more() {
    let (tree, cards) = cards(900);
    let control = Control::default();
    for direction in [Vec3::X, Vec3::Z, Vec3::new(1.0, 0.3, 1.0).normalize()] {
        let camera = from(direction, &cards);
        let seen = cards.view(&[0], &camera, [64, 64], &control).unwrap();
        let (texels, _) = seen.pixels.as_chunks::<4>();
        let covered = texels.iter().filter(|texel| texel[3] > 0).count() as f64;
        let full = crate::cover::mask(&tree.mesh, &camera, 64, &control).unwrap().count() as f64;
        assert!((0.6..1.4).contains(&(covered / full)), "{direction}: {covered} {full}");
    }
}

#[test]
fn the_mesh_of_cards_is_sound_and_within_its_tiles() {
    let (tree, cards) = cards(400);
    let all: Vec<u32> = (0..tree.boxes.boxes().len() as u32).collect();
    let mesh = cards.mesh(&all).unwrap();
    mesh.check().unwrap();
    assert_eq!(mesh.n_triangles(), 12 * all.len());
    assert!(mesh.surfaces[0].uvs.iter().all(|uv| uv.min_element() > 0.0 && uv.max_element() < 1.0));
    let report = cards.report();
    assert_eq!((report.n_boxes, report.n_images), (all.len(), 6 * all.len()));
    assert!(matches!(cards.mesh(&[1000]), Err(LodError::Impostor(_))));
    assert!(cards.texel(0).unwrap() > cards.texel(all.len() as u32 - 1).unwrap());
}

#[test]
fn bad_parameters_and_limits_are_refused_and_cancelling_stops() {
    let Forked { mesh, elements, boxes, skeleton, bearers } = forked(90);
    let bake = |params: &CardParams, control: &Control| {
        Cards::bake(&mesh, &elements, &boxes, params, control).unwrap_err()
    };
    let control = Control::default();
    for odd in [
        CardParams { size: 15, ..params() },
        CardParams { size: 2000, ..params() },
        CardParams { samples: 0, ..params() },
        CardParams { gutter: 9, ..params() },
    ] {
        assert!(matches!(bake(&odd, &control), LodError::Parameter(_)));
    }
    let small = Control::default().with_limits(Limits { pixels: 1000, ..Limits::default() });
    assert!(matches!(bake(&params(), &small), LodError::Limit(_)));
    let flag = CancelFlag::default();
    flag.cancel();
    let stopped = Control::default().with_cancel(flag);
    assert!(matches!(bake(&params(), &stopped), LodError::Cancelled(_)));
    let other = forked(120);
    let found = Cards::bake(&other.mesh, &other.elements, &boxes, &params(), &control);
    assert!(matches!(found, Err(LodError::Impostor(_))));
    let one = BoxParams { most_boxes: 1, ..BoxParams::default() };
    let one = Boxes::along(&skeleton, &mesh, &elements, &bearers, &one, &control).unwrap();
    assert_eq!(
        Cards::bake(&mesh, &elements, &one, &params(), &control).unwrap().report().n_images,
        6
    );
}

#[test]
fn an_eye_that_is_nowhere_is_refused() {
    let (_, cards) = cards(90);
    let control = Control::default();
    let Camera::Placed(pose) = from(Vec3::X, &cards) else { unreachable!() };
    let nowhere = Camera::Placed(Pose { eye: Vec3::NAN, ..pose });
    assert!(cards.view(&[0], &nowhere, [8, 8], &control).is_err());
    assert!(cards.view(&[99], &Camera::Placed(pose), [8, 8], &control).is_err());
    assert!(cards.view(&[0], &Camera::default(), [8, 8], &control).is_err());
}

#[cfg(feature = "gltf")]
#[test]
fn a_file_carries_what_the_shader_needs() {
    use tree_mesh::io::gltf::GlbOptions;
    let (tree, cards) = cards(400);
    let glb = cards.to_glb(&[0, 2], &GlbOptions::default()).unwrap();
    let file = ::gltf::Gltf::from_slice(&glb).unwrap();
    let primitive = file.meshes().next().unwrap().primitives().next().unwrap();
    assert_eq!(primitive.indices().unwrap().count(), 2 * 36);
    let values = |name: &str| -> Vec<[f32; 4]> {
        let semantic = ::gltf::Semantic::Extras(name.into());
        let accessor = primitive.get(&semantic).unwrap();
        ::gltf::accessor::Iter::new(accessor, |_| file.blob.as_deref()).unwrap().collect()
    };
    let boxes = tree.boxes.boxes();
    assert_eq!(values("TREE_CENTER")[4 * 7], boxes[2].center.extend(1.0).to_array());
    assert_eq!(values("TREE_HALF")[24], boxes[2].half.extend(2.0).to_array());
    assert_eq!(values("TREE_TURN")[0], boxes[0].turn.to_array());
    let material = primitive.material();
    assert!(material.double_sided() && material.alpha_mode() == ::gltf::material::AlphaMode::Mask);
    let quantized = GlbOptions { quantize: true, ..GlbOptions::default() };
    assert!(matches!(cards.to_glb(&[0], &quantized), Err(LodError::Parameter(_))));
}
