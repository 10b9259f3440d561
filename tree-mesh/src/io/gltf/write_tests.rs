use super::*;
use crate::mesh::{Alpha, Material, Surface, Texture};
use crate::{Look, MeshParams, build};
use glam::{Quat, Vec2, Vec3};
use std::sync::Arc;
use tree_core::{Aabb, Control, Foliage, Leaf, Skeleton, Species, Tree};

/// A little tree with two leaf kinds that share one texture.
pub(super) fn tree() -> (Tree, Look) {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.0, 0.2).unwrap();
    builder.add(fork, Vec3::new(0.3, 4.0, 0.0), 0.01).unwrap();
    builder.add(fork, Vec3::new(1.0, 3.0, 1.0), 0.05).unwrap();
    let leaf = |i: u16| Leaf {
        node: fork,
        position: Vec3::new(f32::from(i) / 7.0, 3.0 + f32::from(i) / 3.0, 0.0),
        rotation: Quat::from_rotation_z(f32::from(i)),
        size: 0.3,
        kind: i % 2,
    };
    let species = Species { leaf_kinds: vec!["a".into(), "b".into()], ..Default::default() };
    let foliage = Foliage::try_from((0..9).map(leaf).collect::<Vec<_>>()).unwrap();
    let tree = Tree::new(builder.finish(), foliage, species).unwrap();
    let mut look = Look::plain(tree.species());
    let texture = Arc::new(Texture {
        name: "leaf".into(),
        width: 4,
        height: 4,
        pixels: (0..64).map(|i| 3 * i).collect(),
    });
    for leaf in &mut look.leaves {
        leaf.material.texture = Some(Arc::clone(&texture));
        leaf.material.alpha = Alpha::Mask(0.4);
    }
    (tree, look)
}

fn mesh() -> Mesh {
    let (tree, look) = tree();
    build(&tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
}

#[test]
fn a_reader_finds_what_was_written() {
    let mesh = mesh();
    let bytes = to_glb(&mesh, &GlbOptions { name: "oak 1".into(), ..Default::default() }).unwrap();
    let file = ::gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    assert_eq!(file.default_scene().unwrap().nodes().count(), 1);
    assert_eq!(file.nodes().next().unwrap().name(), Some("oak 1"));
    assert_eq!(file.images().count(), 1, "shared textures are embedded once");
    let read = file.meshes().next().unwrap();
    assert_eq!(read.primitives().count(), mesh.surfaces.len());
    for (primitive, surface) in read.primitives().zip(&mesh.surfaces) {
        let bounds = Aabb::of_points(&surface.positions);
        let found = primitive.bounding_box();
        assert_eq!(Vec3::from(found.min), bounds.min);
        assert_eq!(Vec3::from(found.max), bounds.max);
        let reader = primitive.reader(|_| Some(blob));
        let positions: Vec<Vec3> = reader.read_positions().unwrap().map(Vec3::from).collect();
        assert_eq!(positions, surface.positions);
        let normals: Vec<Vec3> = reader.read_normals().unwrap().map(Vec3::from).collect();
        assert_eq!(normals, surface.normals);
        let uvs = reader.read_tex_coords(0).unwrap().into_f32();
        assert_eq!(uvs.map(Vec2::from).collect::<Vec<_>>(), surface.uvs);
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        assert_eq!(indices, surface.indices);
        let wanted = &mesh.materials[surface.material as usize];
        let material = primitive.material();
        assert_eq!(material.name(), Some(wanted.name.as_str()));
        assert_eq!(material.double_sided(), wanted.double_sided);
        let pbr = material.pbr_metallic_roughness();
        assert_eq!(pbr.base_color_factor(), wanted.base_color);
        assert_eq!((pbr.metallic_factor(), pbr.roughness_factor()), (0.0, wanted.roughness));
        match wanted.alpha {
            Alpha::Opaque => assert_eq!(material.alpha_mode(), ::gltf::material::AlphaMode::Opaque),
            Alpha::Mask(cutoff) => {
                assert_eq!(material.alpha_mode(), ::gltf::material::AlphaMode::Mask);
                assert_eq!(material.alpha_cutoff(), Some(cutoff));
            }
        }
        let texture = pbr.base_color_texture().map(|info| info.texture().source().source());
        assert_eq!(texture.is_some(), wanted.texture.is_some());
        if let (Some(::gltf::image::Source::View { view, mime_type }), Some(original)) =
            (texture, &wanted.texture)
        {
            assert_eq!(mime_type, "image/png");
            let png = &blob[view.offset()..view.offset() + view.length()];
            let read = Texture::decode("leaf", png, &Default::default()).unwrap();
            assert_eq!(read, **original);
        }
    }
}

/// One triangle on `n` vertices, the last of which it uses.
fn sized(n: usize) -> Mesh {
    let surface = Surface {
        positions: (0..n).map(|i| Vec3::new(i as f32, (i % 7) as f32, 0.0)).collect(),
        normals: vec![Vec3::Z; n],
        uvs: vec![Vec2::ZERO; n],
        indices: vec![0, 1, n as u32 - 1],
        ..Default::default()
    };
    Mesh {
        surfaces: vec![surface],
        materials: vec![Material::default(), Material::default()],
        ..Default::default()
    }
}

#[test]
fn indices_are_short_where_they_can_be() {
    for (n, expected) in [
        (3, ::gltf::accessor::DataType::U16),
        (65_535, ::gltf::accessor::DataType::U16),
        (65_536, ::gltf::accessor::DataType::U32),
    ] {
        let bytes = to_glb(&sized(n), &GlbOptions::default()).unwrap();
        let file = ::gltf::Gltf::from_slice(&bytes).unwrap();
        assert_eq!(file.materials().count(), 1, "unused ones are left out");
        let primitive = file.meshes().next().unwrap().primitives().next().unwrap();
        assert_eq!(primitive.indices().unwrap().data_type(), expected);
        let reader = primitive.reader(|_| file.blob.as_deref());
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        assert_eq!(indices, [0, 1, n as u32 - 1]);
    }
}

#[test]
fn flaws_are_named_and_leave_no_file() {
    let folder = std::env::temp_dir().join(format!("tree-mesh-glb-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("t.glb");
    let error = |change: fn(&mut Mesh)| {
        let mut mesh = sized(3);
        change(&mut mesh);
        let error = write_glb(&mesh, folder.join("t.glb"), &GlbOptions::default()).unwrap_err();
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
        error
    };
    assert!(matches!(error(|m| m.surfaces.clear()), MeshError::NoTriangles));
    assert!(matches!(error(|m| m.surfaces[0].indices.clear()), MeshError::NoTriangles));
    assert!(matches!(
        error(|m| m.surfaces[0].normals[1] = Vec3::ZERO),
        MeshError::NotUnit { index: 1, .. }
    ));
    assert!(matches!(
        error(|m| m.materials[0].base_color[1] = f32::NAN),
        MeshError::Material { material: 0, field: "base_color", .. }
    ));
    assert!(matches!(
        error(|m| m.materials[0].base_color[1] = 1.5),
        MeshError::Material { material: 0, field: "base_color", .. }
    ));
    assert!(matches!(
        error(|m| m.surfaces[0].positions[0].x = f32::NAN),
        MeshError::NotFinite { .. }
    ));
    let nowhere = folder.join("none/t.glb");
    assert!(matches!(
        write_glb(&sized(3), nowhere, &GlbOptions::default()),
        Err(MeshError::Core(CoreError::Io { .. }))
    ));
    write_glb(&sized(3), &path, &GlbOptions::default()).unwrap();
    assert!(path.is_file());
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn extra_attributes_are_checked_and_written() {
    let mesh = sized(3);
    let good = Attribute {
        surface: 0,
        name: "_WIND".into(),
        components: 4,
        values: (0..12).map(|i| i as f32).collect(),
    };
    let write = |attributes: &[Attribute]| {
        to_glb_levels(&[Level { attributes, ..Level::from(&mesh) }], &GlbOptions::default())
    };
    let bytes = write(std::slice::from_ref(&good)).unwrap();
    let file = ::gltf::Gltf::from_slice_without_validation(&bytes).unwrap();
    let primitive = file.meshes().next().unwrap().primitives().next().unwrap();
    let (_, accessor) = primitive
        .attributes()
        .find(|(name, _)| *name == ::gltf::Semantic::Extras("WIND".into()))
        .unwrap();
    let view = accessor.view().unwrap();
    let found = &file.blob.as_ref().unwrap()[view.offset()..view.offset() + view.length()];
    assert_eq!(found, bytemuck::cast_slice::<f32, u8>(&good.values));
    for bad in [
        Attribute { name: "WIND".into(), ..good.clone() },
        Attribute { name: "_wind".into(), ..good.clone() },
        Attribute { name: "_".into(), ..good.clone() },
        Attribute { name: "_OCCLUSION".into(), ..good.clone() },
        Attribute { surface: 1, ..good.clone() },
        Attribute { components: 3, ..good.clone() },
        Attribute { components: 0, values: vec![], ..good.clone() },
        Attribute { values: vec![f32::NAN; 12], ..good.clone() },
    ] {
        let error = write(std::slice::from_ref(&bad)).unwrap_err();
        assert!(matches!(error, MeshError::Attribute { .. }), "{bad:?}: {error}");
    }
    assert!(matches!(write(&[good.clone(), good]), Err(MeshError::Attribute { .. })));
}

#[test]
fn levels_share_materials_and_are_linked() {
    let (fine, mut coarse) = (mesh(), mesh());
    coarse.surfaces.truncate(1);
    let level = |mesh, coverage| Level { coverage, ..Level::from(mesh) };
    let levels = [level(&fine, 0.5), level(&coarse, 0.1)];
    let bytes = to_glb_levels(&levels, &GlbOptions::default()).unwrap();
    let file = ::gltf::Gltf::from_slice_without_validation(&bytes).unwrap();
    assert_eq!(file.meshes().count(), 2);
    assert_eq!(file.materials().count(), fine.surfaces.len(), "equal materials are shared");
    let roots: Vec<_> = file.default_scene().unwrap().nodes().collect();
    assert_eq!(roots.len(), 1);
    let lod = roots[0].extension_value("MSFT_lod").unwrap();
    assert_eq!(lod["ids"], serde_json::json!([1]));
    let wrong = [level(&fine, 0.1), level(&coarse, 0.5)];
    assert!(matches!(
        to_glb_levels(&wrong, &GlbOptions::default()),
        Err(MeshError::Parameter(error)) if error.field == "coverage"
    ));
    assert!(matches!(to_glb_levels(&[], &GlbOptions::default()), Err(MeshError::NoTriangles)));
}

#[test]
fn quantised_vertices_take_less_than_half() {
    let (mesh, options) = (sized(5000), GlbOptions::default());
    let plain = to_glb(&mesh, &options).unwrap();
    let small = to_glb(&mesh, &GlbOptions { quantize: true, ..options }).unwrap();
    assert!(small.len() * 100 < plain.len() * 52, "{} of {}", small.len(), plain.len());
}

#[test]
fn instances_that_do_not_fit_are_refused() {
    let (tree, look) = tree();
    let whole = instanced(&tree, &look, &MeshParams::default(), &Control::default()).unwrap();
    assert_eq!(whole.leaves.len(), 2);
    let error = |change: fn(&mut Instances)| {
        let mut leaves = whole.leaves.clone();
        change(&mut leaves[1]);
        let level = Level { instances: &leaves, ..Level::from(&whole.mesh) };
        to_glb_levels(&[level], &GlbOptions::default()).unwrap_err()
    };
    for error in [
        error(|leaves| leaves.scales.clear()),
        error(|leaves| leaves.translations[0].x = f32::NAN),
        error(|leaves| leaves.rotations[0] = Quat::from_xyzw(0.0, 0.0, 0.0, 2.0)),
        error(|leaves| {
            leaves.translations.clear();
            leaves.rotations.clear();
            leaves.scales.clear();
        }),
    ] {
        assert!(matches!(error, MeshError::Instances { .. }), "{error}");
    }
    let no_leaf = error(|leaves| leaves.mesh.surfaces.clear());
    assert!(matches!(no_leaf, MeshError::NoTriangles));
}

#[test]
fn a_gltf_names_the_files_beside_it() {
    let folder = std::env::temp_dir().join(format!("tree-mesh-gltf-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("my tree.gltf");
    write_gltf(&[Level::from(&mesh())], &path, &GlbOptions::default()).unwrap();
    let mut names: Vec<_> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["my tree.gltf", "my_tree.bin", "my_tree_leaf.png"]);
    let file = ::gltf::Gltf::open(&path).unwrap();
    let buffer = file.buffers().next().unwrap();
    assert!(matches!(buffer.source(), ::gltf::buffer::Source::Uri("my_tree.bin")));
    assert_eq!(buffer.length() as u64, folder.join("my_tree.bin").metadata().unwrap().len());
    std::fs::remove_dir_all(&folder).unwrap();
}
