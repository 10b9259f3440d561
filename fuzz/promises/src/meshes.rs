//! Polygon meshes.

use crate::control;
use tree_mesh::io::{Imported, gltf, obj, ply};
use tree_mesh::{Mesh, MeshError};

/// glTF and GLB: what was read is a mesh that can be written, or there is a typed error.
pub fn gltf(data: &[u8]) {
    check(gltf::from_slice(data, &control()));
}

/// The OBJ and, behind a zero byte, its MTL.
pub fn obj(data: &[u8]) {
    let mut parts = data.splitn(2, |&byte| byte == 0);
    let (obj, mtl) = (parts.next().unwrap_or_default(), parts.next());
    let control = control();
    check(match mtl {
        Some(mtl) => obj::from_slices(obj, mtl, &control),
        None => obj::from_slice(obj, &control),
    });
}

/// PLY, in text or binary.
pub fn ply(data: &[u8]) {
    check(ply::from_slice(data, &control()));
}

/// What a reader promises of what it returns.
fn check(result: Result<Imported, MeshError>) {
    let Ok(Imported { mesh, report }) = result else { return };
    promise(&mesh);
    assert_eq!(report.n_triangles, mesh.n_triangles());
    assert!(mesh.n_triangles() > 0 && mesh.n_triangles() <= 20_000);
    // What was read can be written.
    gltf::to_glb(&mesh, &Default::default()).expect("a mesh that was read");
}

fn promise(mesh: &Mesh) {
    mesh.check().expect("columns, indices and looks");
    mesh.check_normals().expect("unit normals");
    mesh.check_colors().expect("colours up to 1");
}
