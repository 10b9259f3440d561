//! What the fuzz targets share.

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
