use super::*;
use glam::{Vec2, Vec3};

fn mesh() -> Mesh {
    let surface = |material| Surface {
        positions: vec![Vec3::ZERO, Vec3::X * 1.5, Vec3::new(0.0, -0.000_000_4, 1e-6)],
        normals: vec![Vec3::Z, Vec3::Y, Vec3::new(0.6, -0.8, 0.0)],
        uvs: vec![Vec2::ZERO, Vec2::X, Vec2::new(0.25, -1.5)],
        indices: vec![0, 1, 2],
        material,
        ..Default::default()
    };
    let texture = Arc::new(Texture {
        name: "oak leaf".into(),
        width: 1,
        height: 1,
        pixels: vec![1, 2, 3, 4],
    });
    let material = |alpha| Material {
        name: "oak leaf".into(),
        texture: Some(Arc::clone(&texture)),
        alpha,
        ..Default::default()
    };
    Mesh {
        surfaces: vec![surface(0), Surface { material: 1, ..Default::default() }, surface(1)],
        materials: vec![material(Alpha::Opaque), material(Alpha::Mask(0.5))],
        ..Default::default()
    }
}

#[test]
fn the_text_is_what_obj_readers_expect() {
    let (obj, mtl) = to_strings(&mesh(), "my tree").unwrap();
    let lines: Vec<_> = obj.lines().skip(1).collect();
    assert_eq!(
        lines[..13],
        [
            "mtllib my_tree.mtl",
            "o oak_leaf",
            "v 0 0 0",
            "v 1.5 0 0",
            "v 0 0 0.000001",
            "vt 0 1",
            "vt 1 1",
            "vt 0.25 2.5",
            "vn 0 0 1",
            "vn 0 1 0",
            "vn 0.6 -0.8 0",
            "usemtl oak_leaf",
            "f 1/1/1 2/2/2 3/3/3",
        ]
    );
    assert_eq!(lines[13], "o oak_leaf_2");
    assert_eq!(lines[24], "f 4/4/4 5/5/5 6/6/6", "indices run on over the whole file");
    assert_eq!(mtl.matches("newmtl ").count(), 2);
    let pictured = cfg!(feature = "image");
    assert_eq!(mtl.contains("\nmap_Kd my_tree_oak_leaf.png\n"), pictured);
    assert_eq!(mtl.matches("map_d ").count(), usize::from(pictured));
}

#[test]
fn numbers_are_rounded_and_short() {
    for (value, decimals, expected) in [
        (0.0, 6, "0"),
        (-0.0, 6, "0"),
        (-0.000_000_4, 6, "0"),
        (0.1, 6, "0.1"),
        (-12.345_678, 4, "-12.3457"),
        (0.999_999_9, 4, "1"),
        (1e6, 6, "1000000"),
        (-3e9, 6, "-3000000000"),
        (0.050_5, 3, "0.051"),
        (7.0, 0, "7"),
    ] {
        let mut bytes = Vec::new();
        push_number(&mut bytes, value, decimals);
        assert_eq!(String::from_utf8(bytes).unwrap(), expected, "{value}");
    }
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("tree-mesh-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn files_lie_side_by_side() {
    let folder = folder("obj");
    write_obj(&mesh(), folder.join("my tree.obj")).unwrap();
    let mut expected = vec!["my tree.obj", "my_tree.mtl"];
    if cfg!(feature = "image") {
        expected.push("my_tree_oak_leaf.png");
    }
    assert_eq!(names(&folder), expected);
    let obj = std::fs::read_to_string(folder.join("my tree.obj")).unwrap();
    assert!(obj.contains("\nmtllib my_tree.mtl\n"));
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn failures_leave_no_file() {
    let folder = folder("obj-fail");
    let target = folder.join("t.obj");
    assert!(matches!(write_obj(&Mesh::default(), &target), Err(MeshError::NoTriangles)));
    let mut broken = mesh();
    broken.surfaces[2].indices[0] = 9;
    assert!(matches!(write_obj(&broken, &target), Err(MeshError::Dangling { .. })));
    for color in [f32::NAN, 1.5] {
        let mut broken = mesh();
        broken.materials[1].base_color[0] = color;
        let error = write_obj(&broken, &target).unwrap_err();
        assert!(matches!(error, MeshError::Material { material: 1, field: "base_color", .. }));
    }
    for path in [folder.join("none/t.obj"), folder.join("t.mtl"), folder.join(".."), PathBuf::new()]
    {
        assert!(
            matches!(write_obj(&mesh(), &path), Err(MeshError::Core(CoreError::Io { .. }))),
            "{path:?}"
        );
    }
    assert_eq!(names(&folder), Vec::<String>::new());
    std::fs::remove_dir_all(&folder).unwrap();
}
