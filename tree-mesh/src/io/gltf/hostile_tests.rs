//! Broken and hostile files: typed errors, no panic, no memory beyond the limits.

use super::read as read_file;
use super::*;
use crate::io::samples::{self, Dice};
use serde_json::{Value, json};
use tree_core::{Control, Limits, Resource};

/// A small file with everything the reader knows: levels, instances, all columns, textures.
fn valid(quantize: bool) -> Vec<u8> {
    let (mesh, leaf) = (samples::mesh(7), samples::mesh(8));
    let instances = Instances {
        name: "leaf".into(),
        mesh: leaf,
        translations: vec![glam::Vec3::ONE; 3],
        rotations: vec![glam::Quat::IDENTITY; 3],
        scales: vec![glam::Vec3::ONE; 3],
    };
    let level = Level { instances: &[instances], ..Level::from(&mesh) };
    to_glb_levels(&[level], &GlbOptions { quantize, ..Default::default() }).unwrap()
}

fn control() -> Control {
    let limits = Limits { triangles: 10_000, pixels: 10_000, ..Limits::default() };
    Control::default().with_limits(limits)
}

/// Reads what may be broken; what comes out must hold what is promised.
fn survive(bytes: &[u8]) -> bool {
    match from_slice(bytes, &control()) {
        Ok(imported) => {
            imported.mesh.check().unwrap();
            imported.mesh.check_normals().unwrap();
            imported.mesh.check_colors().unwrap();
            assert!(imported.mesh.n_triangles() <= 10_000);
            true
        }
        Err(error) => {
            assert!(samples::is_typed(&error), "{error:?}");
            false
        }
    }
}

#[test]
fn a_file_cut_off_anywhere_is_an_error() {
    let file = valid(false);
    assert!(survive(&file));
    for end in (0..file.len()).step_by(7).chain(file.len() - 40..file.len()) {
        assert!(!survive(&file[..end]), "{end}");
    }
}

#[test]
fn damaged_files_never_panic() {
    let mut dice = Dice(1);
    let mut n_read = 0;
    for quantize in [false, true] {
        let file = valid(quantize);
        for _ in 0..1500 {
            n_read += usize::from(survive(&samples::damaged(&file, &mut dice)));
        }
    }
    assert!(n_read > 100, "{n_read}: most damage should get past the header");
}

#[test]
fn damaged_documents_never_panic() {
    let pack = write::pack(
        &[Level::from(&samples::mesh(7))],
        &GlbOptions { quantize: true, ..Default::default() },
        None,
    )
    .unwrap();
    let mut dice = Dice(2);
    for _ in 0..3000 {
        let json = samples::damaged(&pack.json, &mut dice);
        survive(&container::join(&json, &pack.binary).unwrap());
    }
}

/// The document of a small file after a change, with its buffer.
fn changed(change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let pack =
        write::pack(&[Level::from(&samples::mesh(3))], &GlbOptions::default(), None).unwrap();
    let mut json: Value = serde_json::from_slice(&pack.json).unwrap();
    change(&mut json);
    container::join(&serde_json::to_vec(&json).unwrap(), &pack.binary).unwrap()
}

fn error(change: impl FnOnce(&mut Value)) -> MeshError {
    from_slice(&changed(change), &control()).unwrap_err()
}

#[test]
fn counts_are_held_against_the_bytes_that_are_there() {
    for count in [1_000_000_u64, u64::from(u32::MAX), u64::MAX / 12, u64::MAX] {
        let all = |json: &mut Value| {
            for accessor in json["accessors"].as_array_mut().unwrap() {
                accessor["count"] = count.into();
            }
        };
        assert!(matches!(error(all), MeshError::Malformed { .. } | MeshError::Limit(_)));
        // Rows that need no bytes are bounded by the size of the file.
        let bare = |json: &mut Value| {
            for accessor in json["accessors"].as_array_mut().unwrap() {
                accessor["count"] = count.into();
                accessor.as_object_mut().unwrap().remove("bufferView");
            }
        };
        assert!(matches!(error(bare), MeshError::Malformed { .. }));
    }
    for (key, value) in [
        ("byteOffset", json!(u64::MAX)),
        ("byteLength", json!(u64::MAX)),
        ("byteStride", json!(2)),
        ("byteStride", json!(u64::MAX)),
        ("buffer", json!(9)),
    ] {
        let error = error(|json| json["bufferViews"][0][key] = value.clone());
        assert!(matches!(error, MeshError::Malformed { .. }), "{key} {value}: {error}");
    }
    let error = error(|json| json["buffers"][0]["byteLength"] = json!(u64::MAX));
    assert!(error.to_string().contains("buffer 0"), "{error}");
}

#[test]
fn references_to_nothing_are_errors_and_cycles_end() {
    for (pointer, value) in [
        ("/scenes/0/nodes/0", json!(99)),
        ("/nodes/0/mesh", json!(99)),
        ("/meshes/0/primitives/0/indices", json!(99)),
        ("/meshes/0/primitives/0/attributes/POSITION", json!(99)),
        ("/meshes/0/primitives/0/attributes/NORMAL", json!(3)),
        ("/accessors/0/bufferView", json!(99)),
        ("/accessors/0/componentType", json!(1)),
        ("/accessors/0/type", json!("MAT4")),
        ("/scene", json!(5)),
    ] {
        let error = error(|json| *json.pointer_mut(pointer).unwrap() = value.clone());
        assert!(matches!(error, MeshError::Malformed { .. }), "{pointer} {value}: {error}");
    }
    let twice = error(|json| {
        json["nodes"] = json!([{ "children": [1, 2] }, { "children": [2] }, { "mesh": 0 }]);
    });
    assert!(twice.to_string().contains("another parent"), "{twice}");
    let cycle = changed(|json| {
        json["nodes"] = json!([{ "children": [1], "mesh": 0 }, { "children": [0] }]);
    });
    assert!(survive(&cycle));
    let endless = error(|json| {
        json["nodes"] = json!([{ "mesh": 0, "scale": [1e38, 1e38, 1e38], "children": [] }]);
        json["nodes"][0]["translation"] = json!([1e39, 0.0, 0.0]);
    });
    assert!(endless.to_string().contains("not finite"), "{endless}");
}

#[test]
fn many_nodes_of_one_mesh_end_at_the_limit() {
    let error = error(|json| {
        json["nodes"] = vec![json!({ "mesh": 0 }); 20_000].into();
        json["scenes"][0]["nodes"] = (0..20_000).collect();
    });
    assert!(matches!(error, MeshError::Limit(limit) if limit.resource == Resource::Triangles));
}

#[test]
fn lists_end_before_they_fill_the_memory() {
    let list = |n: usize| {
        let mut json = String::from(r#"{"asset":{"version":"2.0"},"nodes":["#);
        json.push_str(&"{},".repeat(n - 1));
        json.push_str("{}]}");
        from_slice(json.as_bytes(), &control()).unwrap_err().to_string()
    };
    assert!(list((1 << 20) + 1).contains("more than 1048576 items"));
    assert!(list(1 << 20).contains("no node of it has a triangle"));
    let deep = "[".repeat(1 << 20);
    assert!(matches!(from_slice(deep.as_bytes(), &control()), Err(MeshError::Malformed { .. })));
}

#[test]
fn pictures_together_keep_to_the_limit() {
    let mut mesh = (0..)
        .map(samples::mesh)
        .find(|mesh| {
            mesh.materials.len() == 2 && mesh.materials.iter().all(|m| m.texture.is_some())
        })
        .unwrap();
    for (i, material) in mesh.materials.iter_mut().enumerate() {
        let texture = crate::Texture {
            name: format!("t{i}"),
            width: 80,
            height: 80,
            pixels: vec![i as u8; 4 * 6400],
        };
        material.texture = Some(texture.into());
    }
    let bytes = to_glb(&mesh, &GlbOptions::default()).unwrap();
    let error = from_slice(&bytes, &control()).unwrap_err();
    assert!(matches!(error, MeshError::Limit(limit) if limit.resource == Resource::Pixels));
    assert_eq!(from_slice(&bytes, &Control::default()).unwrap().report.n_textures, 2);
}

#[test]
fn files_elsewhere_are_not_touched() {
    let folder = std::env::temp_dir().join(format!("tree-mesh-elsewhere-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("inside")).unwrap();
    let pack =
        write::pack(&[Level::from(&samples::mesh(3))], &GlbOptions::default(), Some("t")).unwrap();
    std::fs::write(folder.join("t.bin"), &pack.binary).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(folder.join("t.bin"), folder.join("inside/link.bin")).unwrap();
    let path = folder.join("inside/t.gltf");
    let absolute = folder.join("t.bin").display().to_string();
    let mut uris = vec![
        "../t.bin",
        "%2e%2e/t.bin",
        "a/../../t.bin",
        "..\\t.bin",
        "file:///etc/passwd",
        "http://localhost/t.bin",
        "C:t.bin",
        "",
        &absolute,
    ];
    if cfg!(unix) {
        uris.push("link.bin");
    }
    for uri in uris {
        let mut json: Value = serde_json::from_slice(&pack.json).unwrap();
        json["buffers"][0]["uri"] = uri.into();
        std::fs::write(&path, serde_json::to_vec(&json).unwrap()).unwrap();
        let options = crate::io::ImportOptions { external: true };
        let error = read_file(&path, &options, &Control::default()).unwrap_err();
        assert!(matches!(error, MeshError::External { .. }), "{uri}: {error}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn what_is_needed_and_not_known_is_refused() {
    let required = error(|json| json["extensionsRequired"] = json!(["EXT_meshopt_compression"]));
    assert!(matches!(required, MeshError::Unsupported { .. }), "{required}");
    let draco = error(|json| {
        json["meshes"][0]["primitives"][0]["extensions"] =
            json!({ "KHR_draco_mesh_compression": { "bufferView": 0 } });
    });
    assert!(matches!(draco, MeshError::Unsupported { .. }), "{draco}");
}
