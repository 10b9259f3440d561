mod bad_input;

use super::graph::Graph;
use super::search::{NO_NODE, search};
use super::*;
use crate::ModelError;
use glam::Vec3;
use petgraph::algo::dijkstra;
use petgraph::graph::{NodeIndex, UnGraph};
use proptest::prelude::*;
use tree_core::{CancelFlag, Limits, Skeleton, Volume};

const SEED: Seed = Seed(11);

fn control() -> Control {
    Control::default()
}

/// A small tree that grows in a millisecond.
fn shrub() -> PathParams {
    let trunk = Volume::cylinder(Vec3::ZERO, 1.2 * Vec3::Y, 0.3).unwrap();
    let crown = Volume::sphere(2.0 * Vec3::Y, 1.2).unwrap();
    let level = Level { branching: 3, graph_nodes: 60, ..Level::default() };
    PathParams {
        volume: trunk.union(&crown).unwrap(),
        graph_nodes: 500,
        endpoints: Endpoints { random: 6, ..Endpoints::default() },
        size: 0.7,
        levels: vec![level.clone(), level],
        ..PathParams::oak().unwrap()
    }
}

fn skeleton(params: &PathParams) -> Skeleton {
    params.grow(SEED, &control()).unwrap().tree.skeleton().clone()
}

fn n_tips(skeleton: &Skeleton) -> usize {
    let children = skeleton.children();
    (0..skeleton.len() as u32).filter(|&node| children.is_tip(node)).count()
}

#[test]
fn every_preset_grows_a_valid_tree() {
    for preset in PRESETS {
        let grown = preset.params().unwrap().grow(SEED, &control()).unwrap();
        grown.tree.skeleton().check().unwrap();
        assert_eq!(grown.levels.len(), grown.tree.skeleton().len(), "{}", preset.name());
        assert!(grown.tree.foliage().len() > 300, "{}", preset.name());
        let report = grown.report;
        let base = report.levels[0].graphs;
        assert!(base.n_stray_nodes * 20 < base.n_nodes, "{}: {report:?}", preset.name());
        assert_eq!(report.levels.iter().map(|level| level.n_stunted).sum::<u64>(), 0);
    }
}

#[test]
fn presets_hang_together_for_any_seed() {
    for preset in PRESETS {
        let params = PathParams { levels: Vec::new(), leaves: None, ..preset.params().unwrap() };
        for seed in 0..40 {
            let grown = params.grow(Seed(seed), &control()).unwrap();
            let base = grown.report.levels[0].graphs;
            assert!(base.n_stray_nodes * 50 < base.n_nodes, "{} {seed}: {base:?}", preset.name());
        }
    }
}

#[test]
fn a_preset_is_found_by_name_and_a_wrong_name_lists_those_there_are() {
    assert_eq!(Preset::find("c").unwrap().name(), "c");
    let error = Preset::find("z").unwrap_err();
    assert!(error.to_string().contains("oak, a, b"), "{error}");
}

#[test]
fn branching_multiplies_from_level_to_level() {
    let grown = shrub().grow(SEED, &control()).unwrap();
    let endpoints: Vec<u64> = grown.report.levels.iter().map(|level| level.n_endpoints).collect();
    assert_eq!(endpoints, [6, 18, 54]);
}

#[test]
fn the_last_level_grows_round_the_endpoints_of_all_levels_where_asked() {
    let mut params = shrub();
    params.levels[1].from_all_levels = true;
    let grown = params.grow(SEED, &control()).unwrap();
    assert_eq!(grown.report.levels[2].n_endpoints, 3 * (6 + 18));
}

#[test]
fn placed_endpoints_are_tips_where_they_were_put() {
    let placed = vec![Vec3::new(0.5, 2.5, 0.0), Vec3::new(-0.6, 1.9, 0.3)];
    let params = PathParams {
        endpoints: Endpoints { random: 0, placed: placed.clone(), ..Endpoints::default() },
        levels: Vec::new(),
        ..shrub()
    };
    let skeleton = skeleton(&params);
    assert_eq!(n_tips(&skeleton), 2);
    for point in placed {
        assert!(skeleton.positions().contains(&point), "{point}");
    }
}

#[test]
fn surface_endpoints_lie_near_the_surface() {
    let crown = Volume::sphere(2.0 * Vec3::Y, 2.0).unwrap();
    let params = PathParams {
        volume: crown.clone(),
        endpoints: Endpoints {
            random: 40,
            placing: Placing::Surface,
            candidates: 1,
            ..Endpoints::default()
        },
        graph_nodes: 4000,
        levels: Vec::new(),
        ..shrub()
    };
    let skeleton = skeleton(&params);
    let children = skeleton.children();
    for node in (0..skeleton.len() as u32).filter(|&node| children.is_tip(node)) {
        let depth = -crown.distance(skeleton.positions()[node as usize]).unwrap();
        assert!(depth < 0.2, "a tip {depth} m below the surface");
    }
}

#[test]
fn no_branch_enters_an_obstacle() {
    let wall = Volume::box_solid(Vec3::new(0.25, 0.0, -3.0), Vec3::new(0.3, 6.0, 3.0)).unwrap();
    let obstacle = Some(Obstacle { volume: wall.clone(), clearance: 0.02 });
    let params = PathParams { obstacle, smoothing: 10, ..shrub() };
    let grown = params.grow(SEED, &control()).unwrap();
    let skeleton = grown.tree.skeleton();
    for (parent, node) in skeleton.segments() {
        let (a, b) = (skeleton.positions()[parent as usize], skeleton.positions()[node as usize]);
        for i in 0..=100 {
            assert!(!wall.contains(a.lerp(b, i as f32 / 100.0)), "{a} to {b}");
        }
    }
    assert!(skeleton.positions().iter().all(|p| p.x < 0.25), "the wall is not walked round");
    assert!(skeleton.len() > 100);
}

#[test]
fn paint_and_cost_fields_draw_branches_aside() {
    let right_side = Volume::half_space(Vec3::ZERO, Vec3::NEG_X).unwrap();
    let mean_x = |params: &PathParams| {
        let skeleton = skeleton(params);
        skeleton.positions().iter().map(|p| p.x).sum::<f32>() / skeleton.len() as f32
    };
    let sphere = Volume::sphere(Vec3::Y, 1.0).unwrap();
    let endpoints = Endpoints { random: 0, placed: vec![1.9 * Vec3::Y], ..Endpoints::default() };
    let plain =
        PathParams { volume: sphere, graph_nodes: 3000, endpoints, levels: Vec::new(), ..shrub() };
    let painted =
        PathParams { paint: vec![Paint { volume: right_side, factor: 0.2 }], ..plain.clone() };
    let field = PathParams {
        cost: Some(std::sync::Arc::new(|p: Vec3| if p.x > 0.0 { 0.2 } else { 1.0 })),
        ..plain.clone()
    };
    assert!(mean_x(&painted) > mean_x(&plain) + 0.05);
    assert!(mean_x(&field) > mean_x(&plain) + 0.05);
}

#[test]
fn turns_bend_down_when_positive_and_up_when_negative() {
    let mean_height = |turn: f32| {
        let mut params = shrub();
        for level in &mut params.levels {
            level.turn = turn;
        }
        let skeleton = skeleton(&params);
        skeleton.positions().iter().map(|p| p.y).sum::<f32>() / skeleton.len() as f32
    };
    let (down, straight, up) = (mean_height(0.9), mean_height(0.0), mean_height(-0.9));
    assert!(down < straight && straight < up, "{down} {straight} {up}");
}

#[test]
fn a_random_lifespan_ends_some_branches_early() {
    let params = PathParams { lifespan: Lifespan::Random { stop: 0.3 }, ..shrub() };
    let grown = params.grow(SEED, &control()).unwrap();
    let last = grown.report.levels[2];
    assert!(last.n_ended > 0 && last.n_endpoints > 0, "{last:?}");
}

#[test]
fn roots_grow_below_and_meet_the_trunk_with_its_radius() {
    let grown = Preset::find("taproot").unwrap().params().unwrap().grow(SEED, &control()).unwrap();
    let skeleton = grown.tree.skeleton();
    let first_root = grown.levels.iter().position(|&level| level == 0).unwrap();
    assert!(skeleton.bounds().min.y < -2.0);
    assert_eq!(skeleton.parents()[first_root], 0);
    assert!(grown.tree.foliage().nodes().iter().all(|&node| (node as usize) < first_root));
    let children = skeleton.children();
    let roots: Vec<u32> =
        children.of(0).iter().copied().filter(|&c| c as usize >= first_root).collect();
    let thickest = roots.iter().map(|&c| skeleton.radii()[c as usize]).fold(0.0, f32::max);
    assert!(thickest <= skeleton.radii()[0] && thickest > 0.3 * skeleton.radii()[0]);
}

#[test]
fn the_same_seed_gives_the_same_bits_on_one_thread_and_on_two() {
    let params = Preset::find("i").unwrap().params().unwrap();
    let big = PathParams { graph_nodes: 30_000, ..params };
    let grow = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| big.grow(SEED, &control()).unwrap())
    };
    let (one, two) = (grow(1), grow(2));
    assert_eq!(one.tree, two.tree);
    assert_eq!(one.report, two.report);
    assert_ne!(one.tree, big.grow(Seed(12), &control()).unwrap().tree);
}

#[test]
fn progress_never_falls_and_ends_at_one() {
    let seen = std::sync::Arc::new(std::sync::Mutex::new(Vec::new()));
    let sink = seen.clone();
    let control = control().with_progress(move |p| sink.lock().unwrap().push(p.fraction));
    Preset::find("taproot").unwrap().params().unwrap().grow(SEED, &control).unwrap();
    let seen = seen.lock().unwrap();
    assert!(seen.windows(2).all(|pair| pair[0] <= pair[1]), "{seen:?}");
    assert_eq!(seen.last(), Some(&1.0));
}

#[test]
fn costs_that_differ_by_powers_of_ten_do_not_slow_the_search() {
    // Cheap below, dear above: all cheap arcs fall into one bucket.
    let volume = Volume::sphere(Vec3::ZERO, 3.0).unwrap();
    let strewn = nodes::strew(&volume, None, 20_000, &[Vec3::ZERO], SEED, &control()).unwrap();
    let cost: CostField = std::sync::Arc::new(|p: Vec3| if p.y > 0.0 { 1e5 } else { 1.0 });
    let terrain = graph::Terrain { cost: Some(&cost), ..Default::default() };
    let graph = Graph::link(&strewn, &LinkParams::default(), &terrain, SEED, &control()).unwrap();
    let routes = search(&graph, strewn.forced[0], &control()).unwrap();
    assert_eq!(routes.n_reached(), graph.len());
    let mut theirs = UnGraph::<(), f32>::default();
    for _ in 0..graph.len() {
        theirs.add_node(());
    }
    for node in 0..graph.len() as u32 {
        for arc in graph.arcs(node).iter().filter(|arc| arc.to > node) {
            theirs.add_edge(
                NodeIndex::new(node as usize),
                NodeIndex::new(arc.to as usize),
                arc.cost,
            );
        }
    }
    let root = NodeIndex::new(strewn.forced[0] as usize);
    for (node, cost) in dijkstra(&theirs, root, None, |edge| *edge.weight()) {
        assert_eq!(routes.cost(node.index() as u32), cost);
    }
}

#[test]
fn a_wall_thinner_than_a_step_holds() {
    let thin = Vec3::new(3.0, 0.0001, 3.0);
    let wall = Volume::box_solid(1.5 * Vec3::Y - thin, 1.5 * Vec3::Y + thin).unwrap();
    let mut params = shrub();
    params.obstacle = Some(Obstacle { volume: wall, clearance: 0.0 });
    params.endpoints.placed = vec![2.5 * Vec3::Y];
    let found = params.grow(SEED, &control()).unwrap_err();
    assert!(matches!(found, ModelError::EndpointUnreachable { .. }), "{found}");
}

#[test]
fn roots_grow_from_the_trees_root_whatever_their_own_says() {
    let mut params = Preset::find("taproot").unwrap().params().unwrap();
    if let Some(roots) = &mut params.roots {
        roots.root = Vec3::new(40.0, 0.0, 0.0);
    }
    let skeleton = skeleton(&params);
    assert!(skeleton.segment_lengths().iter().all(|&length| length < 2.0));
}

#[test]
fn cancelled_work_stops() {
    let flag = CancelFlag::default();
    flag.cancel();
    let error = shrub().grow(SEED, &control().with_cancel(flag)).unwrap_err();
    assert!(matches!(error, ModelError::Cancelled(_)));
}

#[test]
fn a_thin_slanted_volume_neither_hangs_nor_eats_memory() {
    let volume = Volume::capsule(Vec3::ZERO, Vec3::splat(30.0), 0.02).unwrap();
    let endpoints =
        Endpoints { random: 0, placed: vec![Vec3::splat(29.0)], ..Endpoints::default() };
    let params = PathParams { volume, endpoints, levels: Vec::new(), ..shrub() };
    match params.grow(SEED, &control()) {
        Ok(grown) => grown.tree.skeleton().check().unwrap(),
        Err(ModelError::EmptyVolume { .. } | ModelError::EndpointUnreachable { .. }) => {}
        Err(ModelError::RootOutside { .. }) => {}
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn a_needle_along_one_axis_takes_no_more_memory_than_its_nodes() {
    let volume = Volume::cylinder(Vec3::ZERO, 1000.0 * Vec3::Z, 1e-6).unwrap();
    let strewn = nodes::strew(&volume, None, 20_000, &[], SEED, &control()).unwrap();
    assert!(strewn.grid.n_cells() < 40 * 20_000, "{} cells", strewn.grid.n_cells());
}

#[test]
fn strewn_nodes_keep_their_separation_and_their_number() {
    let volume = Volume::sphere(Vec3::ZERO, 3.0).unwrap();
    for wanted in [100, 1000, 20_000] {
        let strewn = nodes::strew(&volume, None, wanted, &[Vec3::ZERO], SEED, &control()).unwrap();
        let found = strewn.positions.len() as f32 / wanted as f32;
        assert!((0.85..1.25).contains(&found), "{found} of {wanted}");
        if wanted <= 1000 {
            for (i, a) in strewn.positions.iter().enumerate() {
                for b in &strewn.positions[..i] {
                    assert!(a.distance(*b) >= strewn.separation);
                }
            }
        }
        assert_eq!(strewn.positions[strewn.forced[0] as usize], Vec3::ZERO);
    }
}

#[test]
fn darts_thrown_straight_into_a_sector_fill_it_evenly() {
    let sector = Volume::sector(Vec3::X, Vec3::new(1.0, 2.0, 0.5), 0.9, 2.0).unwrap();
    let (mut inside, mut far, mut total) = (0, 0, 0);
    for i in 0..40 {
        let strewn = nodes::strew(&sector, None, 200, &[], SEED.child(i), &control()).unwrap();
        total += strewn.positions.len();
        for p in &strewn.positions {
            inside += usize::from(sector.distance(*p).unwrap() < 1e-5);
            far += usize::from(p.distance(Vec3::X) > 2.0 * 0.7937);
        }
    }
    assert_eq!(inside, total);
    assert!((7200..9600).contains(&total), "{total} of 8000");
    // Half of the volume lies beyond the cube root of one half; surfaces hold a little more.
    let share = far as f32 / total as f32;
    assert!((0.48..0.62).contains(&share), "{share}");
}

#[test]
fn branches_go_on_through_narrow_sectors() {
    for angle in [0.05, 0.1, 0.3, 0.6] {
        let mut params = shrub();
        for level in &mut params.levels {
            level.shape = SubShape::Sector { angle };
        }
        let grown = params.grow(SEED, &control()).unwrap();
        let stunted: u64 = grown.report.levels.iter().map(|level| level.n_stunted).sum();
        assert!(stunted <= 1, "{angle}: {stunted} of 24 branches end early");
    }
}

#[test]
fn links_are_all_pairs_within_reach() {
    let volume = Volume::sphere(Vec3::ZERO, 3.0).unwrap();
    let strewn = nodes::strew(&volume, None, 600, &[], SEED, &control()).unwrap();
    let linking = LinkParams::default();
    let graph =
        Graph::link(&strewn, &linking, &graph::Terrain::default(), SEED, &control()).unwrap();
    let reach = linking.reach * strewn.separation;
    for (a, here) in strewn.positions.iter().enumerate() {
        let mut linked: Vec<u32> = graph.arcs(a as u32).iter().map(|arc| arc.to).collect();
        linked.sort_unstable();
        let near: Vec<u32> = (0..strewn.positions.len())
            .filter(|&b| b != a && here.distance_squared(strewn.positions[b]) < reach * reach)
            .map(|b| b as u32)
            .collect();
        assert_eq!(linked, near);
    }
}

/// Random graphs, leaning to the nasty: no edges, parallel edges, loops, zero and huge costs.
fn any_graph() -> impl Strategy<Value = (u32, Vec<(u32, u32, f32)>)> {
    (1_u32..60).prop_flat_map(|n| {
        let cost =
            prop_oneof![Just(0.0_f32), Just(1.0), 0.0_f32..1.0, 1e-30_f32..1e-28, 1e6_f32..1e9];
        (Just(n), proptest::collection::vec((0..n, 0..n, cost), 0..200))
    })
}

proptest! {
    #[test]
    fn path_costs_equal_petgraphs((n, edges) in any_graph()) {
        let graph = Graph::from_edges(vec![Vec3::ZERO; n as usize], &edges).unwrap();
        let mut theirs = UnGraph::<(), f32>::default();
        for _ in 0..n {
            theirs.add_node(());
        }
        for &(a, b, cost) in &edges {
            theirs.add_edge(NodeIndex::new(a as usize), NodeIndex::new(b as usize), cost);
        }
        let costs = dijkstra(&theirs, NodeIndex::new(0), None, |edge| *edge.weight());
        let routes = search(&graph, 0, &control()).unwrap();
        for node in 0..n {
            let oracle = costs.get(&NodeIndex::new(node as usize)).copied();
            prop_assert_eq!(oracle.unwrap_or(f32::INFINITY), routes.cost(node));
            prop_assert_eq!(routes.reached(node), oracle.is_some());
            // Walking back to the root ends, and costs what it says.
            let (mut at, mut steps) = (node, 0);
            while routes.from(at) != NO_NODE {
                let from = routes.from(at);
                let legs = graph.arcs(from).iter().filter(|arc| arc.to == at);
                prop_assert!(
                    legs.map(|arc| routes.cost(from) + arc.cost).any(|c| c == routes.cost(at))
                );
                at = from;
                steps += 1;
                prop_assert!(steps <= n, "a cycle");
            }
            prop_assert!(at == 0 || !routes.reached(node));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn any_parameters_give_a_valid_tree_or_an_error(
        seed in 0_u64..1000,
        branching in 1_u32..9,
        nodes in 8_u32..400,
        angle in 0.001_f32..3.2,
        turn in -3.2_f32..3.2,
        shrink in 0.01_f32..2.1,
        reach in 1.0_f32..4.5,
        low in 0.0_f32..1.1,
        smoothing in 0_u32..6,
        random_life in any::<bool>(),
    ) {
        let level = Level {
            branching,
            graph_nodes: nodes,
            shape: SubShape::Sector { angle },
            turn,
            axis: if seed % 3 == 0 { LevelAxis::Random } else { LevelAxis::Outward },
            ..Level::default()
        };
        let params = PathParams {
            levels: vec![level.clone(), level],
            shrink,
            linking: LinkParams { reach, low, ..LinkParams::default() },
            smoothing,
            lifespan: if random_life { Lifespan::Random { stop: 0.3 } } else { Lifespan::Full },
            ..shrub()
        };
        match params.grow(Seed(seed), &control()) {
            Ok(grown) => grown.tree.skeleton().check().unwrap(),
            Err(ModelError::Parameter(_)) => prop_assert!(params.validate().is_err()),
            // Eight nodes in a needle, or links too short to hang together.
            Err(
                ModelError::RootOutside { .. }
                | ModelError::EmptyVolume { .. }
                | ModelError::NoCandidates { .. }
                | ModelError::Level { .. },
            ) => prop_assert!(reach < 1.8 || nodes < 60, "reach {reach}, {nodes} nodes"),
            Err(other) => prop_assert!(false, "{}", other),
        }
    }
}
