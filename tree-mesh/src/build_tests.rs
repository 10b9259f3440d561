use super::*;
use crate::CurveFit;
use glam::Vec2;
use tree_core::glam::Quat;
use tree_core::{CancelFlag, Foliage, Leaf, Limits, Skeleton, Species};

/// No flare, no rounding: shapes whose measures are known.
fn plain() -> MeshParams {
    MeshParams { flare: 0.0, fit: CurveFit::Straight, ..Default::default() }
}

fn bare(skeleton: Skeleton) -> Tree {
    Tree::bare(skeleton, Species::default())
}

fn mesh_of(tree: &Tree, params: &MeshParams) -> Built {
    let look = Look::plain(tree.species());
    let built = build(tree, &look, params, &Control::default()).unwrap();
    check(&built);
    built
}

/// What must hold of every mesh.
fn check(built: &Built) {
    let mesh = &built.mesh;
    mesh.check().unwrap();
    for surface in &mesh.surfaces {
        for normal in &surface.normals {
            assert!((normal.length() - 1.0).abs() < 1e-3, "{normal}");
        }
    }
    assert_eq!(built.report.n_vertices, mesh.n_vertices());
    assert_eq!(built.report.n_triangles, mesh.n_triangles());
}

fn chain(points: &[(Vec3, f32)]) -> Skeleton {
    let mut builder = Skeleton::builder(points[0].0, points[0].1).unwrap();
    for (i, &(position, radius)) in points.iter().enumerate().skip(1) {
        builder.add(i as u32 - 1, position, radius).unwrap();
    }
    builder.finish()
}

fn leaf(position: Vec3, rotation: Quat, size: f32, kind: u16) -> Leaf {
    Leaf { node: 0, position, rotation, size, kind }
}

fn leafy(leaves: Vec<Leaf>, n_kinds: usize) -> Tree {
    let species = Species {
        leaf_kinds: (0..n_kinds).map(|k| format!("kind {k}")).collect(),
        ..Default::default()
    };
    Tree::new(
        Skeleton::builder(Vec3::ZERO, 0.1).unwrap().finish(),
        Foliage::try_from(leaves).unwrap(),
        species,
    )
    .unwrap()
}

#[test]
fn a_card_stands_on_its_base_with_the_top_of_the_texture_at_the_apex() {
    let tree = leafy(vec![leaf(Vec3::X, Quat::IDENTITY, 0.2, 0)], 1);
    let card = mesh_of(&tree, &plain()).mesh.surfaces[1].clone();
    assert_eq!(card.positions[0], Vec3::new(0.9, 0.0, 0.0));
    assert_eq!(card.positions[3], Vec3::new(1.1, 0.2, 0.0));
    assert_eq!((card.uvs[0], card.uvs[3]), (Vec2::new(0.0, 1.0), Vec2::new(1.0, 0.0)));
    let [a, b, c] = [0, 1, 2].map(|k| card.positions[card.indices[k] as usize]);
    assert!((b - a).cross(c - a).z > 0.0, "the upper face is the front");
}

#[test]
fn leaves_are_grouped_by_kind_and_those_without_size_are_left_out() {
    let at = |x: f32, size: f32, kind: u16| leaf(Vec3::X * x, Quat::IDENTITY, size, kind);
    let tree = leafy(vec![at(1.0, 0.1, 2), at(2.0, 0.1, 0), at(3.0, 0.0, 0), at(4.0, 0.1, 2)], 3);
    let built = mesh_of(&tree, &plain());
    assert_eq!(built.report.surfaces, [(0, 0), (4, 2), (0, 0), (8, 4)]);
    assert_eq!(built.report.n_skipped_leaves, 1);
    assert_eq!(built.mesh.surfaces[3].material, 3);
    assert_eq!(built.mesh.surfaces[3].positions[4].x, 3.95);
    let mut look = Look::plain(tree.species());
    look.leaves[2].bend = 0.5;
    let built = build(&tree, &look, &plain(), &Control::default()).unwrap();
    check(&built);
    assert_eq!(built.report.surfaces[3], (12, 8));
    assert!(built.mesh.surfaces[3].positions[4].z < -0.02, "bent down");
}

#[test]
fn cards_take_the_width_of_their_look() {
    let tree = leafy(vec![leaf(Vec3::ZERO, Quat::IDENTITY, 1.0, 0)], 1);
    let mut look = Look::plain(tree.species());
    look.leaves[0].width = 0.5;
    let built = build(&tree, &look, &plain(), &Control::default()).unwrap();
    assert_eq!(built.mesh.bounds().size(), Vec3::new(0.5, 1.0, 0.0));
    look.leaves[0].width = f32::NAN;
    let error = build(&tree, &look, &plain(), &Control::default()).unwrap_err();
    assert!(matches!(error, MeshError::Parameter(error) if error.field == "look.leaves.width"));
}

#[test]
fn built_in_looks_know_their_names_and_refuse_others() {
    let species = Species::default();
    let look = Look::built_in(&species).unwrap();
    look.check(&species).unwrap();
    assert!(look.leaves[0].material.texture.is_some());
    let odd = Species { bark: "marble".into(), ..species };
    let error = Look::built_in(&odd).unwrap_err();
    assert!(error.to_string().contains("no bark named 'marble'"), "{error}");
}

#[test]
fn soft_normals_lean_outwards_on_the_cards_own_side() {
    let turn = |i: u32| Quat::from_euler(glam::EulerRot::XYZ, i as f32, 2.3 * i as f32, 0.7);
    let leaves: Vec<_> = (0..200)
        .map(|i| {
            let position = turn(i) * Vec3::Z * 3.0 + Vec3::Y * 5.0;
            leaf(position, turn(7 * i + 1), 0.1, 0)
        })
        .collect();
    let cards = |leaf_rounding| {
        let params = MeshParams { leaf_rounding, ..plain() };
        mesh_of(&leafy(leaves.clone(), 1), &params).mesh.surfaces[1].clone()
    };
    let (flat, soft) = (cards(0.0), cards(0.6));
    for i in 0..flat.positions.len() {
        let outward = (flat.positions[i] - Vec3::Y * 5.0).normalize();
        let (before, after) = (flat.normals[i].dot(outward), soft.normals[i].dot(outward));
        assert!(after.abs() > before.abs() - 0.05, "{before} {after}");
        assert!(flat.normals[i].dot(soft.normals[i]) > 0.0);
    }
}

#[test]
fn limits_are_asked_before_the_memory() {
    // The cap itself is allowed; one less is refused with the exact number.
    let tree = leafy(vec![leaf(Vec3::ZERO, Quat::IDENTITY, 1.0, 0); 10], 1);
    let look = Look::plain(tree.species());
    let with = |triangles| {
        let limits = Limits { triangles, ..Limits::default() };
        let control = Control::default().with_limits(limits);
        build(&tree, &look, &plain(), &control)
    };
    assert_eq!(with(20).unwrap().report.n_triangles, 20);
    match with(19).unwrap_err() {
        MeshError::Limit(error) => assert_eq!((error.requested, error.cap), (20, 19)),
        error => panic!("{error}"),
    }
}

#[test]
fn what_cannot_be_meshed_is_named() {
    let far = bare(chain(&[(Vec3::ZERO, 0.1), (Vec3::Y * 1e30, 0.1)]));
    let look = Look::plain(far.species());
    let control = Control::default();
    let error = build(&far, &look, &plain(), &control).unwrap_err();
    assert!(matches!(error, MeshError::TooLarge { what: "positions", index: 1, .. }));
    let wide = bare(chain(&[(Vec3::ZERO, f32::MAX), (Vec3::Y, 0.1)]));
    let error = build(&wide, &look, &plain(), &control).unwrap_err();
    assert!(matches!(error, MeshError::TooLarge { what: "radii", index: 0, .. }));

    let tree = bare(chain(&[(Vec3::ZERO, 0.1), (Vec3::Y, 0.1)]));
    let naked = Look { leaves: vec![], ..look.clone() };
    let error = build(&tree, &naked, &plain(), &control).unwrap_err();
    assert!(matches!(error, MeshError::LeafMaterials { found: 0, expected: 1 }));
    let flat = MeshParams { max_sides: 2, ..plain() };
    assert!(matches!(
        build(&tree, &look, &flat, &control),
        Err(MeshError::Parameter(error)) if error.field == "max_sides"
    ));
    let stop = CancelFlag::default();
    stop.cancel();
    let cancelled = build(&tree, &look, &plain(), &control.with_cancel(stop));
    assert!(matches!(cancelled, Err(MeshError::Cancelled(_))));
}

/// A tree large enough for many parts of work.
fn large() -> Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.4).unwrap();
    let mut leaves = Vec::new();
    for i in 0..3000_u32 {
        let turn = Quat::from_euler(glam::EulerRot::XYZ, i as f32, 1.7 * i as f32, 0.3);
        let side = turn * Vec3::X;
        let trunk = Vec3::Y * (0.01 * i as f32);
        let radius = 0.4 - 0.0001 * i as f32;
        let node = builder.add(if i == 0 { 0 } else { 3 * i - 2 }, trunk + side * 0.01, radius);
        let twig = builder.add(node.unwrap(), trunk + side, 0.02).unwrap();
        builder.add(twig, trunk + side * 2.0 + Vec3::Y, 0.001).unwrap();
        leaves.extend((0..3).map(|k| leaf(trunk + side * (1.0 + k as f32), turn, 0.1, k % 2)));
    }
    let species = Species { leaf_kinds: vec!["a".into(), "b".into()], ..Default::default() };
    Tree::new(builder.finish(), Foliage::try_from(leaves).unwrap(), species).unwrap()
}

#[test]
fn leaves_alone_are_those_of_the_whole_mesh() {
    let tree = large();
    let whole = mesh_of(&tree, &MeshParams::default()).mesh;
    let look = Look::plain(tree.species());
    let alone = build_leaves(&tree, &look, &MeshParams::default(), &Control::default()).unwrap();
    assert_eq!(alone.materials, whole.materials);
    assert_eq!(alone.surfaces[0], Surface::default());
    for (alone, whole) in alone.surfaces.iter().zip(&whole.surfaces).skip(1) {
        assert_eq!(*alone, Surface { branches: Vec::new(), ..whole.clone() });
    }
    let limits = Limits { triangles: 17_999, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    let error = build_leaves(&tree, &look, &MeshParams::default(), &control).unwrap_err();
    assert!(matches!(error, MeshError::Limit(error) if error.requested == 18_000), "{error}");
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let tree = large();
    let with = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
        pool.install(|| mesh_of(&tree, &MeshParams::default()))
    };
    let one = with(1);
    assert!(one.report.n_triangles > 10 * 4096);
    assert_eq!(one, with(2));
    assert_eq!(one, with(5));
}
