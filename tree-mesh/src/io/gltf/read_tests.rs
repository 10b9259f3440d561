use super::read as read_file;
use super::write_tests::tree;
use super::*;
use crate::io::samples::{self, Dice};
use crate::io::{ImportOptions, Note};
use crate::mesh::{Alpha, Material, Surface};
use crate::{MeshParams, build};
use glam::{Vec2, Vec3, Vec4};
use proptest::prelude::*;
use serde_json::{Value, json};
use tree_core::{Aabb, Control, Limits, Resource};

fn back(bytes: &[u8]) -> Mesh {
    from_slice(bytes, &Control::default()).unwrap().mesh
}

/// Everything that can be written.
fn all() -> GlbOptions {
    GlbOptions { translucency: true, ..Default::default() }
}

/// What files do not hold.
fn plain(mut mesh: Mesh) -> Mesh {
    mesh.branches.clear();
    mesh.surfaces.retain(|surface| surface.n_triangles() > 0);
    for surface in &mut mesh.surfaces {
        surface.branches.clear();
        surface.welds.clear();
        surface.anchors.clear();
    }
    mesh
}

proptest! {
    #[test]
    fn what_is_written_comes_back_bit_for_bit(seed: u64) {
        let mesh = samples::mesh(seed);
        let bytes = to_glb(&mesh, &all()).unwrap();
        prop_assert_eq!(back(&bytes), mesh);
    }

    #[test]
    fn quantised_numbers_come_back_within_the_stated_error(seed: u64) {
        let mesh = samples::mesh(seed);
        let options = GlbOptions { quantize: true, ..all() };
        let read = back(&to_glb(&mesh, &options).unwrap());
        prop_assert_eq!(read.surfaces.len(), mesh.surfaces.len());
        let side = mesh.bounds().size().max_element();
        // The step itself, and the rounding of 32-bit numbers far from the origin.
        let far = mesh.bounds().min.abs().max(mesh.bounds().max.abs()).max_element();
        let near = |a: f32, b: f32, step: f32, far: f32| {
            (a - b).abs() <= step * 1.001 + 4.0 * f32::EPSILON * far
        };
        for (a, b) in mesh.surfaces.iter().zip(&read.surfaces) {
            prop_assert_eq!(&a.indices, &b.indices);
            let all = a.positions.iter().flat_map(|v| v.to_array());
            for (a, b) in all.zip(b.positions.iter().flat_map(|v| v.to_array())) {
                prop_assert!(near(a, b, side / 131_070.0, far), "{a} {b} {side}");
            }
            for (a, b) in a.normals.iter().zip(&b.normals) {
                prop_assert!(a.distance(*b) < 0.0075, "{a} {b}");
            }
            prop_assert_eq!(a.tangents.len(), b.tangents.len());
            for (a, b) in a.tangents.iter().zip(&b.tangents) {
                prop_assert!(a.truncate().distance(b.truncate()) < 0.0075 && a.w == b.w);
            }
            for (a, b) in [(&a.uvs, &b.uvs), (&a.uvs2, &b.uvs2)] {
                prop_assert_eq!(a.len(), b.len());
                let range = |pick: fn(&Vec2) -> f32| {
                    let (min, max) = a.iter().map(pick).fold(
                        (0.0_f32, 1.0_f32), |(min, max), x| (min.min(x), max.max(x)));
                    max - min
                };
                for (a, b) in a.iter().zip(b) {
                    prop_assert!(near(a.x, b.x, range(|uv| uv.x) / 131_070.0, 10.0), "{a} {b}");
                    prop_assert!(near(a.y, b.y, range(|uv| uv.y) / 131_070.0, 10.0), "{a} {b}");
                }
            }
            prop_assert_eq!(&a.occlusion, &b.occlusion);
        }
        for (surface, wanted) in read.surfaces.iter().zip(&mesh.surfaces) {
            let material = |mesh: &Mesh, s: &Surface| mesh.materials[s.material as usize].clone();
            prop_assert_eq!(material(&read, surface), material(&mesh, wanted));
        }
    }
}

#[test]
fn a_gltf_comes_back_when_other_files_are_asked_for() {
    let folder = std::env::temp_dir().join(format!("tree-mesh-beside-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("t.gltf");
    let mesh = (0..).map(samples::mesh).find(|m| m.materials[0].texture.is_some()).unwrap();
    write_gltf(&[Level::from(&mesh)], &path, &all()).unwrap();
    let control = Control::default();
    let asked = ImportOptions { external: true };
    let mut read = read_file(&path, &asked, &control).unwrap().mesh;
    // Names of textures are those of their images.
    assert_eq!(read, mesh);
    let error = read_file(&path, &ImportOptions::default(), &control).unwrap_err();
    assert!(matches!(error, MeshError::External { .. }), "{error}");
    // Without the picture the mesh still comes, and the report says what is missing.
    std::fs::remove_file(folder.join("t_some_leaf.png")).unwrap();
    let imported = read_file(&path, &asked, &control).unwrap();
    assert_eq!(imported.report.count(Note::ExternalMissing), 1);
    read = imported.mesh;
    assert!(read.materials.iter().all(|material| material.texture.is_none()));
    // Both files count.
    let sizes = ["t.gltf", "t.bin"].map(|name| folder.join(name).metadata().unwrap().len());
    let limits = Limits { input_bytes: sizes[0].max(sizes[1]) - 1, ..Limits::default() };
    let error = read_file(&path, &asked, &control.clone().with_limits(limits)).unwrap_err();
    assert!(matches!(error, MeshError::Limit(limit) if limit.resource == Resource::InputBytes));
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn instances_come_back_as_the_leaves_they_stand_for() {
    let (tree, look) = tree();
    let params = MeshParams { leaf_rounding: 0.0, ..Default::default() };
    let control = Control::default();
    let written_out = plain(build(&tree, &look, &params, &control).unwrap().mesh);
    let parts = instanced(&tree, &look, &params, &control).unwrap();
    for (quantize, near) in [(false, 1e-5), (true, 1e-3)] {
        let level = Level { instances: &parts.leaves, ..Level::from(&parts.mesh) };
        let options = GlbOptions { quantize, ..Default::default() };
        let bytes = to_glb_levels(&[level], &options).unwrap();
        let imported = from_slice(&bytes, &control).unwrap();
        assert_eq!(imported.report.n_instances, tree.foliage().len());
        let read = imported.mesh;
        assert_eq!(read.surfaces.len(), written_out.surfaces.len());
        for (a, b) in read.surfaces.iter().zip(&written_out.surfaces) {
            assert_eq!(a.indices, b.indices);
            let distance = |(a, b): (&Vec3, &Vec3)| a.distance(*b);
            let moved = a.positions.iter().zip(&b.positions).map(distance).fold(0.0, f32::max);
            assert!(moved < near, "{moved}");
            let turned = a.normals.iter().zip(&b.normals).map(distance).fold(0.0, f32::max);
            assert!(turned < 0.01, "{turned}");
        }
    }
}

#[test]
fn the_finest_of_several_levels_is_read() {
    let (fine, coarse) = (samples::mesh(1), samples::mesh(2));
    let level = |mesh, coverage| Level { coverage, ..Level::from(mesh) };
    let levels = [level(&fine, 0.5), level(&coarse, 0.1)];
    let read = back(&to_glb_levels(&levels, &GlbOptions::default()).unwrap());
    assert_eq!(read.surfaces, fine.surfaces);
}

/// A document with one buffer, in base64.
fn document(mut json: Value, buffer: &[u8]) -> Vec<u8> {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::from("data:application/octet-stream;base64,");
    for group in buffer.chunks(3) {
        let bits = (0..3).fold(0_u32, |bits, i| bits << 8 | u32::from(*group.get(i).unwrap_or(&0)));
        for i in 0..=group.len() {
            text.push(DIGITS[(bits >> (18 - 6 * i) & 63) as usize] as char);
        }
    }
    json["asset"] = json!({ "version": "2.0" });
    json["buffers"] = json!([{ "byteLength": buffer.len(), "uri": text }]);
    serde_json::to_vec(&json).unwrap()
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// Four corners of a square, not indexed, as `mode`; under a node.
fn square(mode: u32, node: &Value) -> Vec<u8> {
    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0_f32];
    let json = json!({
        "scenes": [{ "nodes": [0] }], "nodes": [node],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "mode": mode }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 48 }],
    });
    document(json, &floats(&corners))
}

#[test]
fn strips_and_fans_turn_one_way() {
    let strip = back(&square(5, &json!({ "mesh": 0 })));
    assert_eq!(strip.surfaces[0].indices, [0, 1, 2, 1, 3, 2]);
    assert_eq!(strip.surfaces[0].normals, [Vec3::Z; 4]);
    let fan = back(&square(6, &json!({ "mesh": 0 })));
    assert_eq!(fan.surfaces[0].indices, [1, 2, 0, 2, 3, 0]);
    let control = Control::default();
    let triangles = from_slice(&square(4, &json!({ "mesh": 0 })), &control).unwrap();
    assert_eq!(triangles.mesh.n_triangles(), 1);
    assert_eq!(triangles.report.count(Note::PartialFaces), 1);
    assert_eq!(triangles.report.count(Note::NormalsComputed), 1);
    assert_eq!(triangles.report.count(Note::UvsMissing), 1);
    let lines = from_slice(&square(1, &json!({ "mesh": 0 })), &control).unwrap_err();
    assert!(matches!(lines, MeshError::Malformed { .. }), "a scene of lines has no triangle");
}

#[test]
fn mirrored_nodes_keep_their_front_in_front() {
    let mirrored = back(&square(5, &json!({ "mesh": 0, "scale": [-2.0, 1.0, 1.0] })));
    let surface = &mirrored.surfaces[0];
    assert_eq!(Aabb::of_points(&surface.positions).min, Vec3::new(-2.0, 0.0, 0.0));
    let [a, b, c] = [0, 1, 2].map(|i| surface.positions[surface.indices[i] as usize]);
    let face = (b - a).cross(c - a).normalize();
    assert_eq!(face, Vec3::Z, "seen from the front it is still counter-clockwise");
    assert_eq!(surface.normals, [Vec3::Z; 4]);
}

#[test]
fn matrices_and_turns_say_the_same() {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turned = json!({
        "mesh": 0, "translation": [1.0, 2.0, 3.0], "rotation": [0.0, 0.0, half, half],
        "scale": [1.0, 3.0, 1.0],
    });
    let matrix = json!({ "mesh": 0, "matrix": [
        0.0, 1.0, 0.0, 0.0, -3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 3.0, 1.0,
    ]});
    let (a, b) = (back(&square(5, &turned)), back(&square(5, &matrix)));
    for (a, b) in a.surfaces[0].positions.iter().zip(&b.surfaces[0].positions) {
        assert!(a.distance(*b) < 1e-5, "{a} {b}");
    }
    assert!(b.surfaces[0].positions[3].distance(Vec3::new(-2.0, 3.0, 3.0)) < 1e-5);
}

#[test]
fn sparse_rows_and_wide_strides_are_read() {
    // Rows of five floats of which three are the position; row 2 replaced.
    let mut buffer = floats(&[0.0, 0.0, 0.0, 9.0, 9.0, 1.0, 0.0, 0.0, 9.0, 9.0, 7.0, 7.0, 7.0]);
    let values = buffer.len();
    buffer.extend(floats(&[0.0, 1.0, 0.0]));
    buffer.push(2);
    let json = json!({
        "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
        "accessors": [{
            "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "sparse": {
                "count": 1, "indices": { "bufferView": 2, "componentType": 5121 },
                "values": { "bufferView": 1 },
            },
        }],
        "bufferViews": [
            { "buffer": 0, "byteLength": values, "byteStride": 20 },
            { "buffer": 0, "byteOffset": values, "byteLength": 12 },
            { "buffer": 0, "byteOffset": values + 12, "byteLength": 1 },
        ],
    });
    let mesh = back(&document(json, &buffer));
    assert_eq!(mesh.surfaces[0].positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
}

#[test]
fn materials_are_converted_and_the_report_says_how() {
    let mut json: Value = serde_json::from_slice(&square(5, &json!({ "mesh": 0 }))).unwrap();
    json["meshes"][0]["primitives"][0]["material"] = 0.into();
    json["materials"] = json!([{
        "name": "leaf", "alphaMode": "BLEND", "doubleSided": true,
        "normalTexture": { "index": 7 },
        "pbrMetallicRoughness": { "baseColorFactor": [0.5, 2.0, 0.0, 1.0], "roughnessFactor": 0.25 },
        "extensions": { "KHR_materials_diffuse_transmission": { "diffuseTransmissionFactor": 0.5 } },
    }]);
    let imported = from_slice(&serde_json::to_vec(&json).unwrap(), &Control::default()).unwrap();
    assert_eq!(
        imported.mesh.materials,
        [Material {
            name: "leaf".into(),
            base_color: [0.5, 1.0, 0.0, 1.0],
            texture: None,
            roughness: 0.25,
            alpha: Alpha::Mask(0.5),
            double_sided: true,
            translucency: 0.5,
        }]
    );
    for note in [Note::BlendAsMask, Note::Clamped, Note::OtherTextures] {
        assert_eq!(imported.report.count(note), 1, "{note}");
    }
}

#[test]
fn texture_transforms_turn_as_their_text_says() {
    // A quarter turn counter-clockwise on the picture, whose v runs down: right becomes up.
    let mut dice = Dice(3);
    let offset = [dice.unit(), dice.unit()];
    let mut json: Value = serde_json::from_slice(&square(5, &json!({ "mesh": 0 }))).unwrap();
    let pairs = json!({ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2" });
    json["accessors"] = json!([json["accessors"][0], pairs]);
    json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 1.into();
    json["meshes"][0]["primitives"][0]["material"] = 0.into();
    json["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorTexture": {
        "index": 0, "extensions": { "KHR_texture_transform": {
            "offset": offset, "rotation": std::f32::consts::FRAC_PI_2, "scale": [2.0, 1.0],
        }},
    }}}]);
    let mesh = back(&serde_json::to_vec(&json).unwrap());
    // The positions read as pairs: the first is (0, 0), the second (0, 1).
    let uv = |i: usize| mesh.surfaces[0].uvs[i] - Vec2::from(offset);
    assert!(uv(1).distance(Vec2::new(1.0, 0.0)) < 1e-6, "down becomes right: {}", uv(1));
    assert!(uv(0).length() < 1e-6);
}

#[test]
fn a_child_that_is_listed_as_a_root_is_drawn_once() {
    let mut json: Value = serde_json::from_slice(&square(5, &json!({}))).unwrap();
    let parent = json!({ "children": [1], "translation": [5.0, 0.0, 0.0] });
    json["nodes"] = json!([parent, { "mesh": 0 }]);
    for (listed, x) in [(json!([1, 0]), 5.0), (json!([0]), 5.0), (json!([1]), 0.0)] {
        json["scenes"][0]["nodes"] = listed;
        let mesh = back(&serde_json::to_vec(&json).unwrap());
        assert_eq!(mesh.n_triangles(), 2);
        assert_eq!(mesh.bounds().min.x, x);
    }
}

#[test]
fn occlusion_can_be_a_colour_or_left_out() {
    let mut mesh = samples::mesh(5);
    for surface in &mut mesh.surfaces {
        surface.occlusion = vec![0.5; surface.positions.len()];
    }
    let write = |occlusion| {
        let options = GlbOptions { occlusion, ..all() };
        from_slice(&to_glb(&mesh, &options).unwrap(), &Control::default()).unwrap()
    };
    let colored = write(OcclusionAs::Color);
    assert_eq!(colored.report.count(Note::VertexColors), mesh.surfaces.len() as u64);
    assert!(colored.mesh.surfaces.iter().all(|surface| surface.occlusion.is_empty()));
    assert_eq!(write(OcclusionAs::Omit).report.count(Note::VertexColors), 0);
    assert_eq!(write(OcclusionAs::Attribute).mesh, mesh);
}

#[test]
fn tangents_follow_their_node() {
    let mut mesh = samples::mesh(6);
    mesh.surfaces.truncate(1);
    mesh.materials.truncate(1);
    let n = mesh.surfaces[0].positions.len();
    mesh.surfaces[0].normals = vec![Vec3::Z; n];
    mesh.surfaces[0].tangents = vec![Vec4::new(1.0, 0.0, 0.0, 1.0); n];
    let pack = write::pack(&[Level::from(&mesh)], &GlbOptions::default(), None).unwrap();
    let mut json: Value = serde_json::from_slice(&pack.json).unwrap();
    json["nodes"][0]["scale"] = json!([-1.0, 1.0, 1.0]);
    let bytes = container::join(&serde_json::to_vec(&json).unwrap(), &pack.binary).unwrap();
    let read = back(&bytes);
    assert_eq!(read.surfaces[0].tangents, vec![Vec4::new(-1.0, 0.0, 0.0, -1.0); n]);
    read.check_normals().unwrap();
}
