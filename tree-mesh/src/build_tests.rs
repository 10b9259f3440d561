use super::*;
use glam::Vec2;
use proptest::prelude::*;
use std::collections::BTreeMap;
use tree_core::glam::Quat;
use tree_core::{CancelFlag, Foliage, Leaf, Limits, Skeleton, Species};

/// No flare, no rounding: shapes whose measures are known.
fn plain() -> MeshParams {
    MeshParams { flare: 0.0, smooth: false, ..Default::default() }
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

/// A number for each place, the same for vertices with the same bits.
fn weld(surface: &Surface) -> Vec<u32> {
    let mut places = BTreeMap::new();
    surface
        .positions
        .iter()
        .map(|p| {
            let next = places.len() as u32;
            *places.entry(p.to_array().map(|x| (x + 0.0).to_bits())).or_insert(next)
        })
        .collect()
}

/// How often each edge is used, forwards and backwards.
fn edges(surface: &Surface) -> BTreeMap<(u32, u32), (u32, u32)> {
    let places = weld(surface);
    let mut edges = BTreeMap::new();
    for triangle in surface.indices.chunks_exact(3) {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (places[triangle[from] as usize], places[triangle[to] as usize]);
            let entry: &mut (u32, u32) = edges.entry((a.min(b), a.max(b))).or_default();
            match a.cmp(&b) {
                std::cmp::Ordering::Less => entry.0 += 1,
                std::cmp::Ordering::Greater => entry.1 += 1,
                std::cmp::Ordering::Equal => {}
            }
        }
    }
    edges
}

fn volume(surface: &Surface) -> f32 {
    let corner = |i: u32| surface.positions[i as usize];
    surface
        .indices
        .chunks_exact(3)
        .map(|t| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0)
        .sum()
}

fn chain(points: &[(Vec3, f32)]) -> Skeleton {
    let mut builder = Skeleton::builder(points[0].0, points[0].1).unwrap();
    for (i, &(position, radius)) in points.iter().enumerate().skip(1) {
        builder.add(i as u32 - 1, position, radius).unwrap();
    }
    builder.finish()
}

#[test]
fn a_straight_trunk_is_a_closed_frustum_with_a_cap() {
    let (r0, r1, h) = (0.3, 0.2, 4.0);
    let skeleton = chain(&[(Vec3::ZERO, r0), (Vec3::Y * h, r1)]);
    for sides in [3, 4, 7, 24, 128] {
        let params = MeshParams { sides_min: sides, sides_max: sides, ..plain() };
        let built = mesh_of(&bare(skeleton.clone()), &params);
        let n = sides as usize;
        // Two rings with a doubled seam, a bottom with a middle, a point for each side.
        assert_eq!(built.report.surfaces[0], (3 * (n + 1) + n, 4 * n));
        let bark = &built.mesh.surfaces[0];
        assert!(edges(bark).values().all(|&uses| uses == (1, 1)));
        let angle = std::f32::consts::TAU / sides as f32;
        let polygon = 0.5 * sides as f32 * libm::sinf(angle);
        let frustum = polygon * h / 3.0 * (r0 * r0 + r0 * r1 + r1 * r1);
        let cap = polygon * r1 * r1 * (0.5 * r1) / 3.0;
        // The two triangles of a side fold inwards where rings shrink, by less than a hundredth.
        let share = volume(bark) / (frustum + cap);
        assert!((share - 1.0).abs() < 0.02, "{sides} sides: {share}");
        assert_eq!(built.report.surfaces[1], (0, 0));
    }
}

#[test]
fn normals_and_triangles_look_outwards() {
    let skeleton = chain(&[
        (Vec3::ZERO, 0.4),
        (Vec3::new(0.2, 2.0, 0.1), 0.3),
        (Vec3::new(0.9, 4.0, 0.0), 0.02),
    ]);
    let bark = mesh_of(&bare(skeleton), &MeshParams::default()).mesh.surfaces[0].clone();
    assert!(volume(&bark) > 0.0);
    for triangle in bark.indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|k| bark.positions[triangle[k] as usize]);
        let face = (b - a).cross(c - a).normalize_or_zero();
        for &corner in triangle {
            let normal = bark.normals[corner as usize];
            assert!(face.dot(normal) > 0.3, "{a} {b} {c}: {face} {normal}");
        }
    }
}

#[test]
fn the_seam_repeats_a_whole_number_of_times_and_v_runs_in_metres() {
    let skeleton = chain(&[(Vec3::ZERO, 0.4), (Vec3::Y * 2.0, 0.3)]);
    let bark = mesh_of(&bare(skeleton), &plain()).mesh.surfaces[0].clone();
    let most = |pick: fn(&Vec2) -> f32| bark.uvs.iter().map(pick).fold(0.0, f32::max);
    assert_eq!(most(|uv| uv.x), 5.0, "a girth of 2.51 m, tiles of 0.5 m");
    assert!((most(|uv| -uv.y) - 4.67).abs() < 0.01, "2 m and a cap");
}

#[test]
fn laterals_start_on_the_parent_axis_as_thin_as_they_are() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.0, 0.25).unwrap();
    builder.add(fork, Vec3::Y * 4.0, 0.2).unwrap();
    builder.add(fork, Vec3::new(1.0, 2.5, 0.0), 0.05).unwrap();
    let built = mesh_of(&bare(builder.finish()), &plain());
    assert_eq!(built.report.n_tubes, 2);
    let bark = &built.mesh.surfaces[0];
    let near = bark.positions.iter().filter(|p| p.distance(Vec3::Y * 2.0) < 0.06).count();
    assert!(near >= 8, "{near} vertices of a ring with radius 0.05 round the fork");
}

#[test]
fn thick_axes_that_end_thin_change_their_count_and_stay_closed() {
    let points: Vec<_> =
        (0..20).map(|i| (Vec3::Y * i as f32 * 0.5, 0.4 * (1.0 - i as f32 / 20.0))).collect();
    let built = mesh_of(&bare(chain(&points)), &plain());
    let bark = &built.mesh.surfaces[0];
    assert!(edges(bark).values().all(|&uses| uses == (1, 1)));
    assert!(built.report.n_triangles < 20 * 2 * 24);
}

#[test]
fn nothing_but_a_point_has_no_bark() {
    let built =
        mesh_of(&bare(Skeleton::builder(Vec3::Y, 0.5).unwrap().finish()), &MeshParams::default());
    assert_eq!(built.report.n_triangles, 0);
    assert_eq!((built.report.n_tubes, built.report.skipped_axes), (0, 1));
}

#[test]
fn the_flare_widens_the_foot_and_nothing_above() {
    let skeleton = chain(&[(Vec3::ZERO, 0.3), (Vec3::Y * 3.0, 0.3), (Vec3::Y * 6.0, 0.2)]);
    let bark = mesh_of(&bare(skeleton), &MeshParams::default()).mesh.surfaces[0].clone();
    assert!(edges(&bark).values().all(|&uses| uses == (1, 1)));
    let radius = |low: f32, high: f32| {
        let at = bark.positions.iter().filter(|p| p.y >= low && p.y <= high);
        at.map(|p| libm::hypotf(p.x, p.z)).fold(0.0, f32::max)
    };
    assert!((radius(0.0, 0.0) - 0.3 * (1.0 + 0.35 * 1.5)).abs() < 1e-4);
    assert!((radius(2.9, 3.1) - 0.3).abs() < 1e-4);
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
    assert_eq!(built.report.skipped_leaves, 1);
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
    assert!(matches!(error, MeshError::Parameter { field: "look.leaves.width", .. }));
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
fn a_leaning_trunk_stands_level_on_the_ground() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.5).unwrap();
    builder.add(0, Vec3::new(2.0, 3.0, 0.0), 0.4).unwrap();
    let tree = Tree::bare(builder.finish(), Species::default());
    let params = MeshParams { flare: 0.35, ..plain() };
    let bark = mesh_of(&tree, &params).mesh.surfaces[0].clone();
    let foot = bark.positions.iter().filter(|p| p.y.abs() < 1e-5).count();
    assert!(foot > 12, "only {foot} vertices on the ground");
    assert!(bark.positions.iter().all(|p| p.y > -1e-5), "below the ground");
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
    let flat = MeshParams { sides_max: 2, ..plain() };
    assert!(matches!(
        build(&tree, &look, &flat, &control),
        Err(MeshError::Parameter { field: "sides_max", .. })
    ));
    let stop = CancelFlag::default();
    stop.cancel();
    let cancelled = build(&tree, &look, &plain(), &control.with_cancel(stop));
    assert!(matches!(cancelled, Err(MeshError::Cancelled(_))));
}

/// A step from one node to the next: mostly ordinary, often not.
fn nasty_step() -> impl Strategy<Value = Vec3> {
    let direction = prop::array::uniform3(-1.0_f32..1.0).prop_map(Vec3::from_array);
    prop_oneof![
        4 => direction.clone(),
        1 => Just(Vec3::ZERO),
        1 => Just(Vec3::Y),
        1 => Just(Vec3::NEG_Y),
        1 => Just(Vec3::Y * 1e-7),
        1 => direction.clone().prop_map(|d| d * 1e-4),
        1 => direction.prop_map(|d| d * 100.0),
    ]
}

fn nasty_radius() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => 0.001_f32..0.3,
        1 => Just(0.0),
        1 => Just(1e-30),
        1 => 1.0_f32..20.0,
    ]
}

fn nasty_skeleton() -> impl Strategy<Value = Skeleton> {
    let node = (nasty_step(), nasty_radius(), any::<prop::sample::Index>(), 0..4_u8);
    prop::collection::vec(node, 0..40).prop_map(|nodes| {
        let mut builder = Skeleton::builder(Vec3::new(0.5, 0.0, -3.0), 0.3).unwrap();
        let mut positions = vec![Vec3::new(0.5, 0.0, -3.0)];
        for (step, radius, parent, far) in nodes {
            let parent = if far == 0 { parent.index(positions.len()) } else { positions.len() - 1 };
            let position = positions[parent] + step;
            builder.add(parent as u32, position, radius).unwrap();
            positions.push(position);
        }
        builder.finish()
    })
}

fn any_params() -> impl Strategy<Value = MeshParams> {
    (any::<bool>(), 0..3_u8, 3..20_u32, 0.0_f32..1.0).prop_map(|(smooth, flare, sides, lobes)| {
        MeshParams {
            smooth,
            flare: f32::from(flare),
            sides_max: sides,
            flare_lobe_depth: 0.9 * lobes,
            ..Default::default()
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn nasty_skeletons_give_closed_tubes(skeleton in nasty_skeleton(), params in any_params()) {
        let built = mesh_of(&bare(skeleton), &params);
        // Exact turns back may lay two rings of one tube on each other; every edge still has as
        // many uses in one direction as in the other.
        for (edge, uses) in edges(&built.mesh.surfaces[0]) {
            prop_assert_eq!(uses.0, uses.1, "edge {:?}", edge);
        }
    }

    #[test]
    fn ordinary_tubes_use_each_edge_twice(
        steps in prop::collection::vec((prop::array::uniform3(0.05_f32..1.0), 0.001_f32..0.2), 1..30),
        params in any_params(),
    ) {
        let mut at = Vec3::ZERO;
        let points: Vec<_> = steps
            .into_iter()
            .map(|(step, radius)| {
                at += Vec3::from_array(step);
                (at, radius)
            })
            .collect();
        let built = mesh_of(&bare(chain(&points)), &params);
        for (edge, uses) in edges(&built.mesh.surfaces[0]) {
            prop_assert_eq!(uses, (1, 1), "edge {:?}", edge);
        }
    }
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
fn the_same_bytes_for_any_number_of_threads() {
    let tree = large();
    let with = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
        pool.install(|| mesh_of(&tree, &MeshParams::default()))
    };
    let one = with(1);
    assert!(one.report.n_triangles > 10 * TRIANGLES_PER_FILL as usize / 4);
    assert_eq!(one, with(2));
    assert_eq!(one, with(5));
}
