use super::*;
use crate::io::ply::{PlyOptions, to_bytes};
use crate::io::samples::{self, Dice};
use proptest::prelude::*;
use tree_core::Limits;

fn load(bytes: &[u8]) -> Imported {
    from_slice(bytes, &Control::default()).unwrap()
}

const TRIANGLE: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n\
    property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n\
    end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

proptest! {
    #[test]
    fn what_is_written_comes_back(seed: u64, ascii: bool) {
        let mesh = samples::mesh(seed);
        let read = load(&to_bytes(&mesh, &PlyOptions { ascii }).unwrap()).mesh;
        let found = &read.surfaces[0];
        let mut first = 0;
        let mut corners = Vec::new();
        for surface in &mesh.surfaces {
            let n = surface.positions.len();
            let rows = first..first + n;
            prop_assert_eq!(&found.positions[rows.clone()], &surface.positions[..]);
            prop_assert_eq!(&found.normals[rows.clone()], &surface.normals[..]);
            for (a, b) in found.uvs[rows].iter().zip(&surface.uvs) {
                prop_assert!(a.distance(*b) <= 2e-6, "{a} {b}: 1 - v and back");
            }
            corners.extend(surface.indices.iter().map(|&corner| corner + first as u32));
            first += n;
        }
        prop_assert_eq!(&found.indices, &corners);
    }
}

#[test]
fn the_colour_of_a_material_comes_back() {
    let mut mesh = samples::mesh(1);
    mesh.surfaces.truncate(1);
    mesh.materials.truncate(1);
    mesh.materials[0].base_color = [0.5, 0.1, 0.0, 1.0];
    mesh.materials[0].texture = None;
    let read = load(&to_bytes(&mesh, &PlyOptions::default()).unwrap());
    for (a, b) in read.mesh.materials[0].base_color.iter().zip([0.5, 0.1, 0.0, 1.0]) {
        assert!((a - b).abs() < 0.005, "{a} {b}");
    }
    assert_eq!(read.report.count(Note::VertexColors), 0);
}

#[test]
fn both_orders_of_bytes_and_all_sorts_of_numbers_are_read() {
    for big in [false, true] {
        let order = if big { "big" } else { "little" };
        let mut file = format!(
            "ply\r\nformat binary_{order}_endian 1.0\r\ncomment caf\u{e9}\r\nelement camera 1\r\n\
             property list ushort double view\r\nelement vertex 4\r\nproperty double x\r\n\
             property char flag\r\nproperty short y\r\nproperty float z\r\nelement face 1\r\n\
             property int id\r\nproperty list uint ushort vertex_index\r\nend_header\r\n"
        )
        .into_bytes();
        let mut put = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            if big {
                bytes.reverse();
            }
            file.extend(bytes);
        };
        put(&2_u16.to_le_bytes());
        put(&1.5_f64.to_le_bytes());
        put(&2.5_f64.to_le_bytes());
        for (x, y) in [(0.0, 0), (2.0, 0), (2.0, 3), (0.0, 3)] {
            put(&f64::to_le_bytes(x));
            put(&[7]);
            put(&i16::to_le_bytes(y));
            put(&0.5_f32.to_le_bytes());
        }
        put(&(-1_i32).to_le_bytes());
        put(&4_u32.to_le_bytes());
        for corner in 0..4_u16 {
            put(&corner.to_le_bytes());
        }
        let read = load(&file);
        let surface = &read.mesh.surfaces[0];
        assert_eq!(surface.positions[2], Vec3::new(2.0, 3.0, 0.5));
        assert_eq!(surface.indices, [0, 1, 2, 0, 2, 3]);
        assert_eq!(surface.normals, [Vec3::Z; 4]);
        assert_eq!(read.report.count(Note::Unknown), 1);
    }
}

#[test]
fn counts_are_held_against_the_bytes_that_are_there() {
    load(TRIANGLE.as_bytes());
    for (from, to) in [
        ("vertex 3", "vertex 4000000000"),
        ("vertex 3", "vertex 18446744073709551615"),
        ("vertex 3", "vertex 18446744073709551616"),
        ("vertex 3", "vertex -3"),
        ("face 1", "face 4000000000"),
        ("3 0 1 2", "4000000000 0 1 2"),
        ("3 0 1 2", "-3 0 1 2"),
        ("3 0 1 2", "3 0 1 3"),
        ("3 0 1 2", "3 0 1 -1"),
        ("3 0 1 2", "3 0 1 0.5"),
        ("3 0 1 2", "3 0 1"),
        ("1 0 0", "1 x 0"),
        ("1 0 0", "1 nan 0"),
        ("property float x\n", ""),
        ("ascii", "utf8"),
        ("end_header", "end"),
        ("list uchar int", "list uchar quad"),
        ("ply\n", "plx\n"),
    ] {
        let text = TRIANGLE.replacen(from, to, 1);
        let error = from_slice(text.as_bytes(), &Control::default()).unwrap_err();
        let typed = matches!(error, MeshError::Malformed { .. } | MeshError::Limit(_));
        assert!(typed, "{from} {to}: {error}");
    }
    let limits = Limits { triangles: 0, ..Default::default() };
    let control = Control::default().with_limits(limits);
    assert!(matches!(from_slice(TRIANGLE.as_bytes(), &control), Err(MeshError::Limit(_))));
}

#[test]
fn damaged_files_never_panic() {
    let limits = Limits { triangles: 10_000, ..Default::default() };
    let control = Control::default().with_limits(limits);
    let mut dice = Dice(1);
    let mut n_read = 0;
    for ascii in [false, true] {
        let file = to_bytes(&samples::mesh(7), &PlyOptions { ascii }).unwrap();
        for end in 0..file.len() - 2 {
            assert!(from_slice(&file[..end], &control).is_err(), "{end}");
        }
        for _ in 0..1500 {
            match from_slice(&samples::damaged(&file, &mut dice), &control) {
                Ok(read) => {
                    read.mesh.check().unwrap();
                    read.mesh.check_normals().unwrap();
                    n_read += 1;
                }
                Err(error) => assert!(samples::is_typed(&error), "{error:?}"),
            }
        }
    }
    assert!(n_read > 100, "{n_read}");
}
