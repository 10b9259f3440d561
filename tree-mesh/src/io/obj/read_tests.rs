use super::*;
use crate::io::obj::to_strings;
use crate::io::samples::{self, Dice};
#[cfg(feature = "image")]
use crate::{io::obj::write_obj, mesh::Alpha};
use proptest::prelude::*;
use tree_core::Limits;

fn load(text: &str) -> Imported {
    from_slice(text.as_bytes(), &Control::default()).unwrap()
}

fn refused(text: &str) -> String {
    from_slice(text.as_bytes(), &Control::default()).unwrap_err().to_string()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

proptest! {
    #[test]
    fn what_is_written_comes_back_as_rounded(seed: u64) {
        let mesh = samples::mesh(seed);
        let (obj, mtl) = to_strings(&mesh, "t").unwrap();
        let read = from_slices(obj.as_bytes(), mtl.as_bytes(), &Control::default()).unwrap().mesh;
        prop_assert_eq!(read.surfaces.len(), mesh.surfaces.len());
        for (a, b) in mesh.surfaces.iter().zip(&read.surfaces) {
            // Vertices come in the order triangles name them, which here is that of the mesh.
            prop_assert_eq!(&a.indices, &b.indices);
            for (a, b) in a.positions.iter().zip(&b.positions) {
                prop_assert!(a.distance(*b) < 1e-6 + 1e-6 * a.length(), "{a} {b}");
            }
            for (a, b) in a.normals.iter().zip(&b.normals) {
                prop_assert!(a.distance(*b) < 2e-4, "{a} {b}");
            }
            for (a, b) in a.uvs.iter().zip(&b.uvs) {
                prop_assert!(a.distance(*b) < 3e-6, "{a} {b}");
            }
            let (a, b) = (&mesh.materials[a.material as usize], &read.materials[b.material as usize]);
            prop_assert_eq!(a.name.replace(' ', "_"), b.name.clone());
            prop_assert_eq!(a.base_color, b.base_color);
            prop_assert_eq!(a.roughness, b.roughness);
        }
    }
}

#[cfg(feature = "image")]
#[test]
fn textures_and_masks_come_back_when_asked_for() {
    let folder = std::env::temp_dir().join(format!("tree-mesh-obj-read-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("my tree.obj");
    let mut mesh = (0..).map(samples::mesh).find(|m| m.materials[0].texture.is_some()).unwrap();
    mesh.materials[0].alpha = Alpha::Mask(0.5);
    write_obj(&mesh, &path).unwrap();
    let read = read(&path, &ImportOptions { external: true }, &Control::default()).unwrap();
    let (found, wanted) = (&read.mesh.materials[0], &mesh.materials[0]);
    assert_eq!(found.texture.as_ref().unwrap().pixels, wanted.texture.as_ref().unwrap().pixels);
    assert_eq!((found.alpha, found.double_sided), (Alpha::Mask(0.5), true));
    let without = super::read(&path, &ImportOptions::default(), &Control::default()).unwrap();
    assert_eq!(without.report.count(Note::ExternalRefused), 1);
    assert_eq!(without.report.count(Note::MaterialUnknown), mesh.materials.len() as u64);
    assert!(without.mesh.materials[0].texture.is_none());
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn faces_are_read_in_all_their_spellings() {
    for face in
        ["f 1 2 3 4", "f -4 -3 -2 -1", "f 1// 2// 3// 4//", "f 1 2 \\\n 3 4", "f\t1 2\t3 4\r"]
    {
        let read = load(&format!("{SQUARE}{face}\n"));
        let surface = &read.mesh.surfaces[0];
        assert_eq!(surface.indices, [0, 1, 2, 0, 2, 3], "{face}");
        assert_eq!(surface.normals, [Vec3::Z; 4], "{face}");
        assert_eq!(read.report.count(Note::NormalsComputed), 4);
    }
    let read = load(&format!("{SQUARE}vt 0.25 0.25\nvn 0 2 0\nf 1/1/1 2/1/1 3/1/1 # end"));
    assert_eq!(read.mesh.surfaces[0].uvs, [Vec2::new(0.25, 0.75); 3]);
    assert_eq!(read.mesh.surfaces[0].normals, [Vec3::Y; 3], "brought to unit length");
}

#[test]
fn materials_gather_their_faces_and_corners_are_shared() {
    let text = format!("{SQUARE}usemtl a\nf 1 2 3\nusemtl b b\nf 1 3 4\nusemtl a\nf 1 3 4\n");
    let mesh = load(&text).mesh;
    let names: Vec<_> = mesh.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["a", "b b"]);
    assert_eq!(mesh.surfaces[0].indices, [0, 1, 2, 0, 2, 3]);
    assert_eq!(mesh.surfaces[1].indices, [0, 1, 2]);
}

#[test]
fn mtl_statements_become_looks() {
    let obj = format!("{SQUARE}usemtl m\nf 1 2 3\n");
    let mtl = "newmtl m\nKd 0.5 0.25 2\nTr 0.25\nNs 98\nmap_Kd -s 1 1 -bm 2 my leaf.png\n";
    let read = from_slices(obj.as_bytes(), mtl.as_bytes(), &Control::default()).unwrap();
    let material = &read.mesh.materials[0];
    assert_eq!(material.base_color, [0.5, 0.25, 1.0, 0.75]);
    assert!((material.roughness - 0.1414).abs() < 1e-4);
    assert_eq!(read.report.count(Note::Clamped), 1);
    assert_eq!(read.report.count(Note::ExternalRefused), 1);
    let error = from_slices(obj.as_bytes(), b"newmtl m\nKd 1 x 1", &Control::default());
    assert_eq!(error.unwrap_err().to_string(), "MTL, line 2: Kd needs numbers");
}

#[test]
fn flaws_are_named_with_their_line() {
    assert!(refused("v 0 0\n").starts_with("OBJ, line 1: v with 2 numbers"));
    assert!(refused("\nv 0 nan 0\n").starts_with("OBJ, line 2: 'nan' is no finite number"));
    for face in [
        "f 1 2 5",
        "f 1 2 0",
        "f 1 2 -5",
        "f 1 2 3/1",
        "f 1 2 x",
        "f 1 2 3/4/5/6",
        "f 1 2 99999999999999999999",
    ] {
        let error = refused(&format!("{SQUARE}{face}"));
        assert!(error.starts_with("OBJ, line 5: "), "{face}: {error}");
    }
    assert!(refused("").contains("no face"));
    assert!(refused(&format!("{SQUARE}f 1 2\nl 1 2\n")).contains("no face"));
    let limits = Limits { triangles: 1, ..Default::default() };
    let control = Control::default().with_limits(limits);
    let error = from_slice(format!("{SQUARE}f 1 2 3 4").as_bytes(), &control).unwrap_err();
    assert!(matches!(error, MeshError::Limit(_)));
}

#[test]
fn damaged_files_never_panic() {
    let (obj, mtl) = to_strings(&samples::mesh(7), "t").unwrap();
    let limits = Limits { triangles: 10_000, ..Default::default() };
    let control = Control::default().with_limits(limits);
    let mut dice = Dice(1);
    let mut n_read = 0;
    for _ in 0..2000 {
        let (obj, mtl) = (
            samples::damaged(obj.as_bytes(), &mut dice),
            samples::damaged(mtl.as_bytes(), &mut dice),
        );
        match from_slices(&obj, &mtl, &control) {
            Ok(read) => {
                read.mesh.check().unwrap();
                read.mesh.check_normals().unwrap();
                read.mesh.check_colors().unwrap();
                n_read += 1;
            }
            Err(error) => assert!(samples::is_typed(&error), "{error:?}"),
        }
    }
    assert!(n_read > 100, "{n_read}");
}

#[test]
fn many_corners_at_one_position_take_no_square_of_time() {
    let n = 60_000;
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for i in 0..n {
        text.push_str(&format!("vt {i} 0\nf 1/{0} 2/{0} 3/{0}\n", i + 1));
    }
    assert_eq!(load(&text).mesh.n_vertices(), 3 * n);
}
