use super::super::*;
use crate::lsystem::LSystem;
use glam::{Quat, Vec3};
use std::sync::Arc;
use tree_core::{Control, Seed, Skeleton, Species, Tree, Volume};

fn model(name: &str) -> Arc<PlasticTree> {
    let control = Control::default();
    let tree = LSystem::preset(name).unwrap().grow(Seed(1), &control).unwrap().tree;
    Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control).unwrap())
}

fn scene() -> Scene {
    Scene::new(Sky::default(), Response::default()).unwrap()
}

fn wall(height: f32) -> Volume {
    Volume::box_solid(Vec3::new(-0.1, 0.0, -8.0), Vec3::new(0.1, height, 8.0)).unwrap()
}

fn update(scene: &mut Scene) -> Update {
    scene.update(&Control::default()).unwrap()
}

fn trees(scene: &Scene) -> Vec<Adapted> {
    scene.trees().map(|id| scene.adapted(id, &Control::default()).unwrap()).collect()
}

/// Says what differs, not all of both.
#[track_caller]
fn assert_same(a: &[Adapted], b: &[Adapted]) {
    assert_eq!(a.len(), b.len());
    for (index, (a, b)) in a.iter().zip(b).enumerate() {
        let differ = |what: &str, at: Option<usize>| {
            assert!(at.is_none(), "tree {index}: {what} differ at {at:?}");
        };
        assert_eq!(a.report, b.report, "tree {index}");
        differ("nodes", a.source.iter().zip(&b.source).position(|(a, b)| a != b));
        differ("deaths", a.died.iter().zip(&b.died).position(|(a, b)| a != b));
        differ("ways", a.moved.iter().zip(&b.moved).position(|(a, b)| a != b));
        assert!(a == b, "tree {index} differs");
    }
}

fn size(model: &PlasticTree) -> Vec3 {
    model.tree().skeleton().bounds().size()
}

#[test]
fn a_tree_alone_in_the_open_is_the_input_bit_for_bit() {
    for name in ["birch", "palm", "oak"] {
        let model = model(name);
        let mut scene = scene();
        let id = scene.add_tree(model.clone(), Pose::at(Vec3::new(3.0, 0.5, -7.0))).unwrap();
        update(&mut scene);
        let adapted = scene.adapted(id, &Control::default()).unwrap();
        assert!(&adapted.tree == model.tree(), "{name}");
        assert_eq!(adapted.report, AdaptedReport::default());
    }
}

#[test]
fn a_wall_bends_the_tree_away_and_prunes_its_side() {
    let model = model("oak");
    let mut scene = scene();
    let id = scene.add_tree(model.clone(), Pose::default()).unwrap();
    let far = 0.25 * size(&model).x;
    scene.add_obstacle(wall(2.0 * size(&model).y), Pose::at(Vec3::X * far)).unwrap();
    let changed = update(&mut scene);
    assert_eq!(changed.changed, [id]);
    let adapted = scene.adapted(id, &Control::default()).unwrap();
    assert!(adapted.report.n_pruned > 0 && adapted.report.farthest > 0.0, "{:?}", adapted.report);
    let middle = |tree: &Tree| {
        let sum: Vec3 = tree.foliage().positions().iter().sum();
        sum / tree.foliage().len() as f32
    };
    assert!(middle(&adapted.tree).x < middle(model.tree()).x - 0.02 * size(&model).x);
    for &at in adapted.tree.foliage().positions() {
        assert!((at.x - far).abs() > 0.1, "a leaf in the wall at {at}");
    }
}

#[test]
fn motions_lead_every_living_main_node_to_where_it_is() {
    let model = model("oak");
    let mut scene = scene();
    let id = scene.add_tree(model.clone(), Pose::default()).unwrap();
    let far = 0.3 * size(&model).x;
    scene.add_obstacle(wall(2.0 * size(&model).y), Pose::at(Vec3::X * far)).unwrap();
    update(&mut scene);
    let (motions, adapted) = (scene.motions(id).unwrap(), trees(&scene).remove(0));
    let old = model.tree().skeleton().positions();
    assert_eq!(motions.len(), old.len());
    let mut n_moved = 0;
    for (&source, &at) in adapted.source.iter().zip(adapted.tree.skeleton().positions()) {
        let node = source as usize;
        assert!(motions[node].alive);
        if model.is_main()[node] {
            assert!((old[node] + motions[node].moved).distance(at) < 1e-4);
            n_moved += u32::from(motions[node].moved.length() > 0.01);
        }
    }
    assert!(n_moved > 10);
    for (motion, died) in motions.iter().zip(&adapted.died) {
        assert_eq!(motion.alive, died.is_none());
    }
}

#[test]
fn an_obstacle_that_goes_away_leaves_no_trace() {
    let model = model("oak");
    let mut scene = scene();
    for x in [0.0, 5.0, 9.0] {
        scene.add_tree(model.clone(), Pose::at(Vec3::X * x)).unwrap();
    }
    update(&mut scene);
    let before = trees(&scene);
    let id = scene.add_obstacle(wall(6.0), Pose::at(Vec3::X * 2.4)).unwrap();
    for step in 0..4 {
        scene.move_obstacle(id, Pose::at(Vec3::X * (2.4 + 0.3 * step as f32))).unwrap();
        update(&mut scene);
    }
    assert!(trees(&scene) != before);
    scene.remove_obstacle(id).unwrap();
    update(&mut scene);
    assert_same(&trees(&scene), &before);
}

#[test]
fn the_order_of_edits_does_not_matter() {
    let (oak, birch) = (model("oak"), model("birch"));
    let at = |x: f32, z: f32| Pose::at(Vec3::new(x, 0.0, z));
    let mut one = scene();
    one.add_tree(oak.clone(), at(0.0, 0.0)).unwrap();
    update(&mut one);
    one.add_tree(birch.clone(), at(3.0, 1.0)).unwrap();
    one.add_obstacle(wall(5.0), at(1.5, 0.0)).unwrap();
    update(&mut one);
    one.add_obstacle(Volume::sphere(Vec3::Y * 3.0, 0.7).unwrap(), at(-2.0, 0.5)).unwrap();
    update(&mut one);

    let mut other = scene();
    let ball =
        other.add_obstacle(Volume::sphere(Vec3::Y * 3.0, 0.7).unwrap(), at(9.0, 0.5)).unwrap();
    let second = other.add_tree(birch, at(-8.0, 1.0)).unwrap();
    update(&mut other);
    let barrier = other.add_obstacle(wall(5.0), at(4.0, 0.0)).unwrap();
    other.add_tree(oak, at(0.0, 0.0)).unwrap();
    update(&mut other);
    other.move_tree(second, at(3.0, 1.0)).unwrap();
    other.move_obstacle(ball, at(-2.0, 0.5)).unwrap();
    update(&mut other);
    other.move_obstacle(barrier, at(1.5, 0.0)).unwrap();
    update(&mut other);

    let (mut first, mut last) = (trees(&one), trees(&other));
    let key = |adapted: &Adapted| adapted.source.len();
    first.sort_by_key(key);
    last.sort_by_key(key);
    assert_same(&first, &last);
}

#[test]
fn small_steps_and_one_large_one_lead_to_the_same() {
    let model = model("birch");
    let plant = || {
        let mut scene = scene();
        for k in 0..9 {
            let at = Vec3::new((k % 3) as f32 * 3.0, 0.0, (k / 3) as f32 * 3.0);
            scene.add_tree(model.clone(), Pose::at(at)).unwrap();
        }
        let id = scene.add_obstacle(wall(4.0), Pose::at(Vec3::X * -20.0)).unwrap();
        update(&mut scene);
        (scene, id)
    };
    let (mut slow, wall_id) = plant();
    for step in 1..=8 {
        slow.move_obstacle(wall_id, Pose::at(Vec3::X * (-20.0 + 2.56 * step as f32))).unwrap();
        update(&mut slow);
    }
    let (mut quick, wall_id) = plant();
    quick.move_obstacle(wall_id, Pose::at(Vec3::X * (-20.0 + 2.56 * 8.0))).unwrap();
    update(&mut quick);
    assert_same(&trees(&slow), &trees(&quick));
}

#[test]
fn only_what_an_edit_touches_is_redone() {
    let model = model("birch");
    let mut scene = scene();
    let mut ids = Vec::new();
    for k in 0..6 {
        ids.push(scene.add_tree(model.clone(), Pose::at(Vec3::X * (80.0 * k as f32))).unwrap());
    }
    update(&mut scene);
    scene.add_obstacle(wall(4.0), Pose::at(Vec3::X * 81.0)).unwrap();
    let done = update(&mut scene);
    assert_eq!(done.changed, [ids[1]]);
    assert!(done.touched <= 2, "{done:?}");
    assert_eq!(update(&mut scene), Update::default());
}

#[test]
fn the_number_of_threads_does_not_show() {
    let (oak, birch) = (model("oak"), model("birch"));
    let grow = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut scene = scene();
            for k in 0..5 {
                let model = if k % 2 == 0 { &oak } else { &birch };
                scene.add_tree(model.clone(), Pose::at(Vec3::X * (2.5 * k as f32))).unwrap();
            }
            scene.add_obstacle(wall(4.0), Pose::at(Vec3::X * 1.2)).unwrap();
            update(&mut scene);
            trees(&scene)
        })
    };
    assert_same(&grow(1), &grow(3));
}

#[test]
fn what_cannot_be_is_refused_and_the_scene_stays() {
    let model = model("birch");
    let mut scene = scene();
    let id = scene.add_tree(model.clone(), Pose::default()).unwrap();
    let ball = scene
        .add_obstacle(Volume::sphere(Vec3::ZERO, 1.0).unwrap(), Pose::at(Vec3::X * 9.0))
        .unwrap();
    update(&mut scene);
    let before = trees(&scene);
    assert!(
        scene
            .move_obstacle(ball, Pose::default())
            .unwrap_err()
            .to_string()
            .contains("base of tree")
    );
    assert!(
        scene.move_tree(id, Pose::at(Vec3::X * 9.0)).unwrap_err().to_string().contains("obstacle")
    );
    assert!(scene.move_tree(id, Pose::at(Vec3::NAN)).is_err());
    let flat = Pose { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), ..Pose::default() };
    assert!(scene.move_tree(id, flat).unwrap_err().to_string().contains("rotation"));
    assert!(
        scene.move_tree(TreeId(77), Pose::default()).unwrap_err().to_string().contains("tree 77")
    );
    let endless = Volume::half_space(Vec3::ZERO, Vec3::Y).unwrap();
    let quarter = endless.intersection(&Volume::half_space(Vec3::ZERO, Vec3::X).unwrap()).unwrap();
    assert!(
        scene
            .add_obstacle(quarter, Pose::at(Vec3::Y * -50.0))
            .unwrap_err()
            .to_string()
            .contains("end")
    );
    assert!(scene.set_sky(Sky { light: Vec3::ZERO, ..Sky::default() }).is_err());
    assert_eq!(update(&mut scene), Update::default());
    assert_same(&trees(&scene), &before);
}

#[test]
fn in_the_dark_only_the_trunk_lives() {
    let model = model("oak");
    let mut scene = scene();
    scene.add_tree(model, Pose::default()).unwrap();
    scene.set_sky(Sky { brightness: 0.0, ..Sky::default() }).unwrap();
    update(&mut scene);
    let adapted = &trees(&scene)[0];
    assert_eq!(adapted.tree.foliage().len(), 0);
    let children = adapted.tree.skeleton().children();
    assert!((0..adapted.source.len()).all(|node| children.of(node as u32).len() <= 1));
}

#[test]
fn the_sun_from_the_side_turns_the_crown() {
    let model = model("oak");
    let mut scene = scene();
    scene.add_tree(model.clone(), Pose::default()).unwrap();
    scene.set_sky(Sky::towards(std::f32::consts::FRAC_PI_2, 0.6)).unwrap();
    update(&mut scene);
    let adapted = &trees(&scene)[0];
    let top = |skeleton: &Skeleton| {
        skeleton.positions().iter().copied().reduce(|a, b| if a.y > b.y { a } else { b })
    };
    assert!(
        top(adapted.tree.skeleton()).unwrap().x > top(model.tree().skeleton()).unwrap().x + 0.1
    );
}

#[test]
fn one_node_and_coinciding_nodes_are_trees_too() {
    let control = Control::default();
    let one = Skeleton::builder(Vec3::ZERO, 0.1).unwrap().finish();
    let mut still = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    still.add(0, Vec3::ZERO, 0.1).unwrap();
    still.add(1, Vec3::ZERO, 0.1).unwrap();
    for skeleton in [one, still.finish()] {
        let tree = Tree::bare(skeleton, Species::default());
        let model =
            Arc::new(PlasticTree::new(tree.clone(), &PlasticParams::default(), &control).unwrap());
        let mut scene = scene();
        scene.add_tree(model, Pose::default()).unwrap();
        scene.add_obstacle(wall(3.0), Pose::at(Vec3::X * 0.4)).unwrap();
        update(&mut scene);
        assert!(trees(&scene)[0].tree == tree);
    }
}

#[test]
fn a_closed_mesh_stands_in_the_way_as_the_box_it_is() {
    let corners: Vec<Vec3> = (0..8)
        .map(|k| Vec3::new([-0.1, 0.1][k & 1], [0.0, 6.0][k >> 1 & 1], [-8.0, 8.0][k >> 2 & 1]))
        .collect();
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
    let mesh = Volume::mesh(corners, triangles).unwrap();
    let model = model("birch");
    let grow = |volume: Volume| {
        let mut scene = scene();
        scene.add_tree(model.clone(), Pose::default()).unwrap();
        scene.add_obstacle(volume, Pose::at(Vec3::X * 0.7)).unwrap();
        update(&mut scene);
        trees(&scene).remove(0)
    };
    let (by_box, by_mesh) = (grow(wall(6.0)), grow(mesh));
    assert!(by_mesh.report.n_pruned > 0);
    let far = by_box.report.n_pruned.abs_diff(by_mesh.report.n_pruned);
    assert!(far <= by_box.report.n_pruned / 10 + 2, "{:?} {:?}", by_box.report, by_mesh.report);
}

#[test]
fn cancelled_work_is_taken_up_again() {
    let model = model("birch");
    let mut scene = scene();
    scene.add_tree(model, Pose::default()).unwrap();
    scene.add_obstacle(wall(4.0), Pose::at(Vec3::X * 0.7)).unwrap();
    let flag = tree_core::CancelFlag::default();
    flag.cancel();
    assert!(scene.update(&Control::default().with_cancel(flag)).is_err());
    update(&mut scene);
    assert!(trees(&scene)[0].report.n_pruned > 0);
}
