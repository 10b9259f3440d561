//! Tests of the growth model as a whole.

use super::*;
use crate::foliage::Phyllotaxis;
use crate::path::Obstacle;
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{Limits, Volume};

fn bare(params: GrowthParams) -> GrowthParams {
    GrowthParams { habit: Habit { leaves: None, ..params.habit }, ..params }
}

fn young(name: &str, iterations: u32) -> GrowthParams {
    bare(GrowthParams { iterations, ..Preset::find(name).unwrap().params() })
}

fn grow(params: &GrowthParams, seed: u64) -> Grown {
    params.grow(Seed(seed), &Control::default()).unwrap()
}

/// Mean of all nodes.
fn center(grown: &Grown) -> Vec3 {
    let positions = grown.tree.skeleton().positions();
    positions.iter().sum::<Vec3>() / positions.len() as f32
}

/// A wall that fills all beyond x = `x`.
fn wall(x: f32) -> Obstacle {
    let volume = Volume::half_space(Vec3::new(x, 0.0, 0.0), Vec3::NEG_X).unwrap();
    Obstacle { volume, clearance: 0.05 }
}

fn check_whole(grown: &Grown, iterations: u32) {
    let skeleton = grown.tree.skeleton();
    skeleton.check().unwrap();
    let n = skeleton.len();
    assert_eq!([grown.ages.len(), grown.orders.len()], [n; 2]);
    assert_eq!(grown.report.years.len(), iterations as usize);
    assert!(n >= 2);
    for (parent, node) in skeleton.segments() {
        let (parent, node) = (parent as usize, node as usize);
        assert!(grown.ages[parent] >= grown.ages[node], "a branch is younger than what bears it");
        assert!(grown.orders[parent] <= grown.orders[node]);
        assert!(skeleton.radii()[parent] >= skeleton.radii()[node]);
        assert!(grown.ages[node] <= iterations);
        assert!(skeleton.positions()[node].y >= skeleton.positions()[0].y);
    }
    if let Some(last) = grown.report.years.last() {
        assert_eq!(last.n_nodes as usize, n);
    }
}

#[test]
fn every_preset_grows_and_has_leaves() {
    for preset in PRESETS {
        let params = GrowthParams { iterations: 7, ..preset.params() };
        params.validate().unwrap();
        let grown = grow(&params, 1);
        check_whole(&grown, 7);
        assert!(grown.tree.skeleton().len() > 20, "{}", preset.name());
        assert!(!grown.tree.foliage().is_empty(), "{}", preset.name());
    }
    assert!(matches!(Preset::find("x"), Err(ModelError::UnknownPreset { .. })));
}

#[test]
fn no_iteration_leaves_the_seedling() {
    let grown = grow(&young("oak", 0), 1);
    check_whole(&grown, 0);
    assert_eq!(grown.tree.skeleton().len(), 2);
    assert_eq!(grown.ages, [0, 0]);
}

#[test]
fn without_light_nothing_grows() {
    let mut params = young("oak", 6);
    params.world.brightness = 0.0;
    let grown = grow(&params, 1);
    check_whole(&grown, 6);
    assert_eq!(grown.tree.skeleton().len(), 2);
}

#[test]
fn more_apical_control_makes_a_taller_tree() {
    let height = |lambda| {
        let mut params = young("oak", 9);
        params.habit.allocation = Allocation::BorchertHonda { lambda, late: lambda, turning: 0 };
        let grown = grow(&params, 3);
        grown.tree.skeleton().bounds().size().y / grown.tree.skeleton().len() as f32
    };
    assert!(height(0.6) > 1.2 * height(0.42));
}

#[test]
fn a_tree_beside_a_wall_grows_away_and_never_into_it() {
    for environment in [Environment::default(), Environment::Space(Space::default())] {
        let mut params = young("oak", 10);
        params.world.environment = environment;
        params.habit.internode = 0.12;
        let free = center(&grow(&params, 5));
        params.world.obstacle = Some(wall(0.6));
        let beside = grow(&params, 5);
        check_whole(&beside, 10);
        assert!(center(&beside).x < free.x - 0.05, "{} {}", center(&beside), free);
        assert!(beside.tree.skeleton().positions().iter().all(|p| p.x < 0.6));
    }
}

#[test]
fn light_from_the_side_draws_the_crown() {
    let mut params = young("oak", 10);
    params.world.light = Vec3::new(1.0, 1.0, 0.0);
    let drawn = center(&grow(&params, 2)).x;
    params.world.light = Vec3::new(-1.0, 1.0, 0.0);
    assert!(drawn > center(&grow(&params, 2)).x + 0.2);
}

#[test]
fn neighbours_grow_apart() {
    let params = young("oak", 10);
    let at = |x| Plant { base: Vec3::new(x, 0.0, 0.0), ..params.planting() };
    let stand = |plants: &[Plant]| {
        grow_stand(&params.world, plants, 10, Seed(4), &Control::default()).unwrap()
    };
    let pair = stand(&[at(-0.4), at(0.4)]);
    let gap = center(&pair[1]).x - center(&pair[0]).x;
    assert!(gap > 1.0, "{gap}");
    let far = stand(&[at(-50.0), at(50.0)]);
    let n = |grown: &[Grown]| grown.iter().map(|g| g.tree.skeleton().len()).sum::<usize>();
    assert!(n(&pair) < n(&far), "competition costs growth");
}

#[test]
fn shaded_branches_are_shed() {
    let mut params = young("oak", 12);
    params.habit.shedding = 0.0;
    let all = grow(&params, 1);
    assert!(all.report.years.iter().all(|year| year.n_shed == 0));
    params.habit.shedding = 0.2;
    let some = grow(&params, 1);
    assert!(some.report.years.iter().any(|year| year.n_shed > 0));
}

#[test]
fn priorities_and_space_grow_trees_too() {
    let mut params = young("maple", 8);
    check_whole(&grow(&params, 1), 8);
    params.world.environment = Environment::Space(Space {
        crown: Some(Volume::sphere(Vec3::new(0.0, 1.0, 0.0), 1.0).unwrap()),
        ..Space::default()
    });
    let grown = grow(&params, 1);
    check_whole(&grown, 8);
    assert!(grown.tree.skeleton().len() > 20, "{} nodes", grown.tree.skeleton().len());
    let outside = |p: &&Vec3| p.distance(Vec3::Y) > 1.9 && p.y > 0.5;
    assert_eq!(grown.tree.skeleton().positions().iter().filter(outside).count(), 0);
}

#[test]
fn shadows_of_all_that_went_are_gone() {
    let mut params = young("oak", 9);
    params.habit.shedding = 0.25;
    let control = Control::default();
    let mut simulation =
        Simulation::new(&params.world, &[params.planting()], Seed(1), &control).unwrap();
    for _ in 0..9 {
        simulation.step(&control).unwrap();
    }
    // What is left in the grid is the shadow of the leaves there are.
    let grown = simulation.grown(0, &control).unwrap();
    let Environment::Shadow(shadow) = &params.world.environment else { panic!("shadows") };
    let mut grid = light::ShadowGrid::new(shadow, Vec3::Y).unwrap();
    let positions = grown.tree.skeleton().positions();
    let leafy: Vec<Vec3> = (1..positions.len())
        .filter(|&node| grown.ages[node] < params.habit.leaf_life)
        .map(|node| positions[node])
        .collect();
    grid.cast(&leafy, &Limits::default()).unwrap();
    for &point in positions {
        assert_eq!(simulation.light(point), (1.0 - grid.at(point)).max(0.0));
    }
}

#[test]
fn obstacles_on_the_base_are_refused() {
    let mut params = young("oak", 3);
    params.world.obstacle = Some(wall(-0.5));
    let error = params.grow(Seed(1), &Control::default()).unwrap_err();
    assert!(matches!(error, ModelError::RootBlocked { .. }), "{error}");
}

#[test]
fn a_slab_overhead_stops_growth() {
    let mut params = young("oak", 8);
    let volume = Volume::box_solid(Vec3::new(-9.0, 0.4, -9.0), Vec3::new(9.0, 0.5, 9.0)).unwrap();
    params.world.obstacle = Some(Obstacle { volume, clearance: 0.0 });
    let grown = grow(&params, 1);
    assert!(grown.tree.skeleton().bounds().max.y < 0.4);
}

#[test]
fn limits_and_cancelling_end_growth() {
    let params = young("oak", 12);
    let with = |limits| params.grow(Seed(1), &Control::default().with_limits(limits)).unwrap_err();
    let nodes = with(Limits { nodes: 50, ..Default::default() });
    assert!(matches!(nodes, ModelError::Limit(e) if e.cap == 50), "{nodes}");
    let voxels = with(Limits { voxels: 5000, ..Default::default() });
    assert!(matches!(voxels, ModelError::Limit(e) if e.cap == 5000), "{voxels}");
    let control = Control::default().with_stop(|| true);
    assert!(matches!(params.grow(Seed(1), &control), Err(ModelError::Cancelled(_))));
}

#[test]
fn bad_parameters_are_named() {
    let refused = |change: fn(&mut GrowthParams)| {
        let mut params = young("oak", 3);
        change(&mut params);
        params.grow(Seed(1), &Control::default()).unwrap_err().to_string()
    };
    type Change = fn(&mut GrowthParams);
    let cases: [(Change, &str); 12] = [
        (|p| p.iterations = MAX_ITERATIONS + 1, "iterations"),
        (|p| p.base.x = f32::NAN, "base"),
        (|p| p.base.x = 1e9, "base.length()"),
        (|p| p.world.light = Vec3::ZERO, "world.light.length()"),
        (|p| p.world.light.y = f32::NAN, "world.light"),
        (|p| p.world.brightness = -1.0, "world.brightness"),
        (|p| p.habit.internode = f32::NAN, "habit.internode"),
        (|p| p.habit.vigour = f32::INFINITY, "habit.vigour"),
        (|p| p.habit.trunk.photo = f32::NAN, "habit.trunk.photo"),
        (|p| p.habit.max_shoot = 0, "habit.max_shoot"),
        (|p| p.habit.buds = Phyllotaxis::Whorled { count: 1 }, "habit.buds.count"),
        (
            |p| {
                p.world.environment =
                    Environment::Shadow(Shadow { voxel: 0.0, ..Shadow::default() });
            },
            "shadow.voxel",
        ),
    ];
    for (change, field) in cases {
        let message = refused(change);
        assert!(message.contains(field), "{message}");
    }
    let none = grow_stand(&World::default(), &[], 1, Seed(1), &Control::default()).unwrap_err();
    assert!(none.to_string().contains("plants.len()"));
    let control = Control::default();
    let simulation =
        Simulation::new(&World::default(), &[Plant::default()], Seed(1), &control).unwrap();
    assert!(simulation.grown(1, &control).is_err());
}

fn pool(n_threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn trees_are_valid_and_the_same_for_any_number_of_threads(
        seed in any::<u64>(),
        preset in 0..PRESETS.len(),
        iterations in 0_u32..8,
        space in any::<bool>(),
        photo in -1.0_f32..2.0,
        gravi in -1.0_f32..1.0,
        x in 0.3_f32..2.0,
    ) {
        let mut params = bare(PRESETS[preset].params());
        params.iterations = iterations;
        params.habit.branches = Tropisms { photo, gravi, plagio: 0.1 };
        params.world.obstacle = Some(wall(x));
        if space {
            params.world.environment = Environment::Space(Space::default());
        }
        let at = |z| Plant { base: Vec3::new(0.0, 0.0, z), ..params.planting() };
        let plants = [at(0.0), at(0.7)];
        let run = || grow_stand(&params.world, &plants, iterations, Seed(seed), &Control::default());
        let one = pool(1).install(run).unwrap();
        let three = pool(3).install(run).unwrap();
        for (a, b) in one.iter().zip(&three) {
            check_whole(a, iterations);
            prop_assert_eq!(&a.tree, &b.tree);
            prop_assert_eq!(&a.ages, &b.ages);
        }
    }
}
