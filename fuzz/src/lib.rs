//! What the fuzz targets share.

pub mod script;

use tree_core::{Control, Limits};
use tree_mesh::io::Imported;
use tree_mesh::{Mesh, MeshError};

/// Limits small enough that an input within them is quick.
pub fn control() -> Control {
    Control::default().with_limits(limits())
}

/// See [`control`].
pub fn limits() -> Limits {
    Limits {
        nodes: 10_000,
        triangles: 20_000,
        pixels: 1 << 16,
        input_bytes: 1 << 20,
        ..Limits::default()
    }
}

/// What a reader promises of what it returns.
pub fn check(result: Result<Imported, MeshError>) {
    let Ok(Imported { mesh, report }) = result else { return };
    promise(&mesh);
    assert_eq!(report.n_triangles, mesh.n_triangles());
    assert!(mesh.n_triangles() > 0 && mesh.n_triangles() <= 20_000);
    // What was read can be written.
    tree_mesh::io::gltf::to_glb(&mesh, &Default::default()).expect("a mesh that was read");
}

/// What is promised of skeletons of scans, whatever the points.
pub fn scan(points: &[tree_core::glam::DVec3], control: &Control) {
    let params = tree_model::skeletonize::ScanParams::default();
    if let Ok(made) = tree_model::skeletonize::skeletonize_scan(points, &params, control) {
        assert!(!made.trees.is_empty());
        for tree in &made.trees {
            tree.skeleton.check().expect("a skeleton");
        }
    }
}

fn promise(mesh: &Mesh) {
    mesh.check().expect("columns, indices and looks");
    mesh.check_normals().expect("unit normals");
    mesh.check_colors().expect("colours up to 1");
}

/// A stream of a tree with levels whose checksums hold. `data` is the head without its beginning and its check, then
/// the levels without their lengths and checks; before each of them stands how many bytes it has, in two bytes, the
/// lower one first.
pub fn sealed(data: &[u8]) -> Vec<u8> {
    let mut bytes = b"TREM\x01".to_vec();
    let mut rest = data;
    let head = part(&mut rest);
    bytes.extend_from_slice(head);
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    while !rest.is_empty() {
        let level = part(&mut rest);
        let mut length = level.len();
        while length >= 0x80 {
            bytes.push(length as u8 | 0x80);
            length >>= 7;
        }
        bytes.push(length as u8);
        bytes.extend_from_slice(level);
        bytes.extend((crc32fast::hash(&bytes) as u16).to_le_bytes());
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

fn part<'a>(rest: &mut &'a [u8]) -> &'a [u8] {
    let (length, behind) = rest.split_at(rest.len().min(2));
    let length = length.iter().rev().fold(0, |length, &byte| 256 * length + usize::from(byte));
    let (part, behind) = behind.split_at(length.min(behind.len()));
    *rest = behind;
    part
}
