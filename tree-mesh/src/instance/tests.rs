use super::*;
use crate::MeshError;
use crate::build;
use glam::{EulerRot, Vec2};
use proptest::prelude::*;
use tree_core::{Aabb, CancelFlag, Foliage, Leaf, Limits, Skeleton, Species};

/// A trunk with `n` boughs of ten twigs with twenty-four leaves each, all twigs alike but for their size.
fn bush(n: u32) -> Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    let mut foliage = Foliage::default();
    let mut trunk = 0;
    for bough in 0..n {
        trunk = builder.add(trunk, Vec3::Y * 0.2 * (bough + 1) as f32, 0.2).unwrap();
        let turn = Quat::from_rotation_y(2.4 * bough as f32);
        let mut node = trunk;
        for step in 1..=10_u32 {
            let at = Vec3::Y * 0.2 * (bough + 1) as f32 + turn * Vec3::X * 0.3 * step as f32;
            node = builder.add(node, at, 0.02).unwrap();
            let size = 0.2 + 0.01 * (step % 3) as f32;
            let out = turn * Vec3::new(0.3, 0.5, if step % 2 == 0 { 0.8 } else { -0.8 }) * size;
            let twig = builder.add(node, at + 0.5 * out, 0.004).unwrap();
            let tip = builder.add(twig, at + out, 0.002).unwrap();
            for leaf in 0..24 {
                let rotation = turn * Quat::from_euler(EulerRot::YXZ, 1.57 * leaf as f32, 0.9, 0.0);
                let position = at + out * (0.3 + 0.03 * leaf as f32);
                foliage.push(Leaf { node: tip, position, rotation, size: 0.1, kind: 0 }).unwrap();
            }
        }
    }
    Tree::new(builder.finish(), foliage, Species::default()).unwrap()
}

fn instanced(tree: &Tree, twig_params: &InstancingParams) -> InstancedTree {
    let look = Look::plain(tree.species());
    twigs(tree, &look, &MeshParams::default(), twig_params, &Control::default()).unwrap()
}

fn flat(tree: &Tree) -> Mesh {
    let look = Look::plain(tree.species());
    build(tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
}

#[test]
fn each_occurrence_stands_in_for_its_own_when_every_one_is_unique() {
    let tree = bush(3);
    let params = InstancingParams { max_twigs: 1000, reach: Some(0.3), ..Default::default() };
    let made = instanced(&tree, &params);
    assert!(made.report.n_instances > 25, "{:?}", made.report);
    assert!(made.report.deviation < 1e-3, "{:?}", made.report);
    let (again, plain) = (made.flatten(&Control::default()).unwrap(), flat(&tree));
    let sorted = |mesh: &Mesh| {
        let mut anchors = mesh.surfaces[1].anchors.clone();
        anchors.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap());
        anchors
    };
    let middle = |mesh: &Mesh| {
        let p = &mesh.surfaces[1].positions;
        p.iter().sum::<Vec3>() / p.len() as f32
    };
    assert_eq!(sorted(&again).len(), sorted(&plain).len());
    assert!(middle(&again).distance(middle(&plain)) < 1e-3);
    let (a, b) = (again.bounds(), plain.bounds());
    assert!(a.min.distance(b.min) < 0.02 && a.max.distance(b.max) < 0.02, "{a:?} {b:?}");
}

#[test]
fn a_tree_of_many_alike_twigs_gets_ten_times_smaller() {
    let tree = bush(60);
    let made = instanced(&tree, &InstancingParams::default());
    let report = made.report;
    println!("{report:?}");
    assert!(report.n_twigs <= 30 && report.ratio >= 10.0, "{report:?}");
    let plain = bytes(&flat(&tree));
    assert!(plain >= 10 * report.bytes, "{plain} and {report:?}");
    let (leaves, drawn) = report.n_leaves;
    assert!((drawn as f64 / leaves as f64 - 1.0).abs() < 0.05, "{report:?}");
    for twig in &made.twigs {
        let n = twig.translations.len();
        assert!(n > 0 && twig.rotations.len() == n && twig.scales.len() == n);
        assert!(twig.branches.iter().all(|&b| (b as usize) < made.base.branches.len()));
        assert!(twig.rotations.iter().all(|q| q.is_normalized()));
        assert!(twig.scales.iter().all(|s| s.min_element() > 0.0 && s.x == s.y));
    }
    let again = made.flatten(&Control::default()).unwrap();
    again.check_normals().unwrap();
    assert_eq!(bytes(&again), report.bytes_flat);
    // Parents first, also among the branches of instances.
    for (i, branch) in again.branches.iter().enumerate() {
        assert!(branch.parent as usize <= i);
    }
}

#[test]
fn the_same_bits_for_any_number_of_threads() {
    let tree = bush(12);
    let with = |n| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
        pool.install(|| instanced(&tree, &InstancingParams { max_twigs: 5, ..Default::default() }))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn bad_parameters_limits_and_cancelling_are_answered() {
    let tree = bush(4);
    let look = Look::plain(tree.species());
    let run = |params: &InstancingParams, control: &Control| {
        twigs(&tree, &look, &MeshParams::default(), params, control)
    };
    let none = InstancingParams { max_twigs: 0, ..Default::default() };
    let error = run(&none, &Control::default()).unwrap_err().to_string();
    assert!(error.starts_with("max_twigs is 0"), "{error}");
    let odd = InstancingParams { reach: Some(f32::NAN), ..Default::default() };
    assert!(run(&odd, &Control::default()).is_err());
    let made = run(&InstancingParams::default(), &Control::default()).unwrap();
    let limits = Limits { triangles: 10, ..Limits::default() };
    let tight = Control::default().with_limits(limits);
    assert!(matches!(made.flatten(&tight), Err(MeshError::Limit(_))));
    let stop = CancelFlag::default();
    stop.cancel();
    let cancelled = run(&InstancingParams::default(), &Control::default().with_cancel(stop));
    assert!(matches!(cancelled, Err(MeshError::Cancelled(_))));
}

#[test]
fn bare_points_and_broken_parts_do_no_harm() {
    let point = Tree::bare(Skeleton::builder(Vec3::ONE, 0.0).unwrap().finish(), Species::default());
    let made = instanced(&point, &InstancingParams::default());
    assert_eq!((made.report.n_instances, made.flatten(&Control::default()).is_ok()), (0, true));
    let mut made = instanced(&bush(4), &InstancingParams::default());
    made.twigs[0].mesh.surfaces[0].indices[0] = u32::MAX;
    assert!(matches!(made.flatten(&Control::default()), Err(MeshError::Dangling { .. })));
}

fn any_tree() -> impl Strategy<Value = Tree> {
    let step = prop_oneof![
        4 => prop::array::uniform3(-1.0_f32..1.0).prop_map(Vec3::from_array),
        1 => Just(Vec3::ZERO),
        1 => Just(Vec3::Y * 1e-7),
    ];
    let node = (step, 0.0_f32..0.2, any::<prop::sample::Index>(), any::<bool>());
    prop::collection::vec(node, 1..60).prop_map(|nodes| {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
        let mut positions = vec![Vec3::ZERO];
        let mut foliage = Foliage::default();
        for (step, radius, parent, leafy) in nodes {
            let parent = parent.index(positions.len());
            let position = positions[parent] + step;
            let node = builder.add(parent as u32, position, radius).unwrap();
            positions.push(position);
            if leafy {
                let rotation = Quat::from_rotation_x(step.x);
                foliage.push(Leaf { node, position, rotation, size: 0.1, kind: 0 }).unwrap();
            }
        }
        Tree::new(builder.finish(), foliage, Species::default()).unwrap()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_tree_can_be_instanced_and_flattened(
        tree in any_tree(),
        max_twigs in 1_u32..8,
        reach in 0.01_f32..3.0,
    ) {
        let params = InstancingParams { max_twigs, reach: Some(reach), ..Default::default() };
        let made = instanced(&tree, &params);
        prop_assert!(made.twigs.len() <= max_twigs as usize);
        let mesh = made.flatten(&Control::default()).unwrap();
        mesh.check_normals().unwrap();
        prop_assert!(mesh.bounds() == Aabb::EMPTY || mesh.bounds().is_finite());
        prop_assert!(mesh.surfaces.iter().all(|s| s.uvs.iter().all(|uv: &Vec2| uv.is_finite())));
    }
}
