use super::*;

fn triangle() -> Mesh {
    let surface = Surface {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
        normals: vec![Vec3::Z; 3],
        uvs: vec![Vec2::ZERO; 3],
        indices: vec![0, 1, 2],
        ..Default::default()
    };
    Mesh { surfaces: vec![surface], materials: vec![Material::default()], ..Default::default() }
}

#[test]
fn a_triangle_passes_and_is_counted() {
    let mesh = triangle();
    mesh.check().unwrap();
    assert_eq!((mesh.n_vertices(), mesh.n_triangles()), (3, 1));
    assert_eq!(mesh.bounds().max, Vec3::new(1.0, 1.0, 0.0));
}

#[test]
fn each_flaw_has_its_own_error() {
    let spoil = |change: fn(&mut Mesh)| {
        let mut mesh = triangle();
        change(&mut mesh);
        mesh.check().unwrap_err()
    };
    let error = spoil(|m| m.surfaces[0].uvs.truncate(2));
    assert!(matches!(error, MeshError::Length { field: "uvs", found: 2, expected: 3, .. }));
    let error = spoil(|m| m.surfaces[0].normals[1] = Vec3::NAN);
    assert!(matches!(error, MeshError::NotFinite { field: "normals", index: 1, .. }));
    let error = spoil(|m| m.surfaces[0].indices[2] = 3);
    assert!(matches!(error, MeshError::Dangling { what: "vertex", found: 3, count: 3, .. }));
    let error = spoil(|m| m.surfaces[0].material = 1);
    assert!(matches!(error, MeshError::Dangling { what: "material", found: 1, .. }));
    let error = spoil(|m| m.surfaces[0].indices.push(0));
    assert!(matches!(error, MeshError::PartialTriangle { found: 4, .. }));
    let error = spoil(|m| {
        let texture = Texture { name: "t".into(), width: 2, height: 2, pixels: vec![0; 15] };
        m.materials[0].texture = Some(Arc::new(texture));
    });
    assert!(matches!(error, MeshError::Texture { found: 15, expected: 16, .. }));
}

#[test]
fn branches_come_after_those_that_carry_them() {
    let table = |parents: &[u32]| {
        let branches = parents.iter().map(|&parent| Branch { parent, ..Branch::default() });
        Mesh { branches: branches.collect(), ..triangle() }.check()
    };
    table(&[0, 0, 1, 0, 2]).unwrap();
    for (parents, row) in [(&[1, 0][..], 0), (&[0, 1], 1), (&[0, 2, 0], 1), (&[0, 0, 9], 2)] {
        match table(parents) {
            Err(MeshError::BranchOrder { branch, parent }) => {
                assert_eq!((branch, parent), (row, parents[row]));
            }
            other => panic!("{parents:?}: {other:?}"),
        }
    }
}

#[test]
fn branches_are_finite() {
    let limp = Branch { stiffness: f32::NAN, ..Branch::default() };
    let mesh = Mesh { branches: vec![Branch::default(), limp], ..triangle() };
    assert!(matches!(mesh.check(), Err(MeshError::BranchNotFinite { branch: 1 })));
}

#[test]
fn errors_name_the_surface_only_where_it_has_a_number() {
    let mut mesh = triangle();
    let error = mesh.check_surface(99).unwrap_err();
    assert_eq!(error.to_string(), "there is no surface 99, only 1");
    mesh.surfaces[0].indices[2] = 3;
    let error = mesh.check().unwrap_err();
    assert_eq!(error.to_string(), "surface 0: vertex 3 does not exist, there are only 3");
    let error = crate::topology::welded(&mesh.surfaces[0]).unwrap_err();
    assert_eq!(error.to_string(), "the surface: vertex 3 does not exist, there are only 3");
}

#[test]
fn a_look_outside_its_range_is_named_by_material_and_field() {
    type Change = (&'static str, fn(&mut Material));
    let changes: [Change; 8] = [
        ("base_color", |m| m.base_color[0] = f32::NAN),
        ("base_color", |m| m.base_color[1] = f32::INFINITY),
        ("base_color", |m| m.base_color[2] = -0.1),
        ("base_color", |m| m.base_color[3] = 1.1),
        ("roughness", |m| m.roughness = 1.5),
        ("alpha", |m| m.alpha = Alpha::Mask(f32::NAN)),
        ("translucency", |m| m.translucency = -1.0),
        ("translucency", |m| m.translucency = f32::INFINITY),
    ];
    for (wanted, change) in changes {
        let mut mesh = triangle();
        mesh.materials.push(Material::default());
        change(&mut mesh.materials[1]);
        match mesh.check() {
            Err(MeshError::Material { material: 1, field, .. }) => assert_eq!(field, wanted),
            other => panic!("{wanted}: {other:?}"),
        }
    }
    let mut bright = triangle();
    bright.materials[0].base_color[0] = 2.0;
    bright.check().unwrap();
    let error = bright.check_colors().unwrap_err();
    assert!(matches!(error, MeshError::Material { material: 0, found: 2.0, max: 1.0, .. }));
}

#[test]
fn sides_whose_product_overflows_are_refused() {
    for (width, height) in [(u32::MAX, u32::MAX), (1 << 31, 1 << 31), (0, 1)] {
        let texture = Texture { name: "t".into(), width, height, pixels: Vec::new() };
        assert!(matches!(texture.check(), Err(MeshError::Texture { found: 0, .. })));
    }
}

#[test]
fn bounds_and_balls_hold_every_vertex() {
    let mut mesh = triangle();
    mesh.surfaces.push(mesh.surfaces[0].clone());
    mesh.surfaces[1].positions.iter_mut().for_each(|p| *p = *p * 3.0 + Vec3::new(5.0, -1.0, 2.0));
    let (center, radius) = mesh.bounding_sphere().unwrap();
    for surface in &mesh.surfaces {
        let (own, reach) = surface.bounding_sphere().unwrap();
        for &p in &surface.positions {
            assert!(surface.bounds().contains(p) && mesh.bounds().contains(p));
            assert!(p.distance(own) <= reach * 1.0001 && p.distance(center) <= radius * 1.0001);
        }
        assert!(reach <= radius && surface.bounds().size().length() * 0.5001 >= reach);
    }
    assert_eq!(Mesh::default().bounding_sphere(), None);
    assert!(Surface::default().bounds().is_empty());
}
