//! Whole flows.

use super::super::grid::Grid;
use super::*;
use crate::ModelError;
use glam::{UVec3, Vec3};
use proptest::prelude::*;
use tree_core::{Control, Limits, NO_PARENT, Seed, seed};

/// A ball of a crown on a thin trunk.
fn lollipop() -> Grid {
    let corner = Vec3::new(-4.0, 0.0, -4.0);
    let mut grid = Grid::new(corner, 0.25, UVec3::new(32, 40, 32), &Limits::default()).unwrap();
    for i in 0..grid.values().len() {
        let p = grid.center(grid.voxel_of(i));
        let crown = p.distance(Vec3::new(0.0, 6.5, 0.0)) < 3.2;
        let trunk = p.y < 4.0 && Vec3::new(p.x, 0.0, p.z).length() < 0.3;
        grid.values_mut()[i] = f32::from(u8::from(crown || trunk));
    }
    grid
}

fn starts(n: u32, seed: u64) -> Vec<Vec3> {
    let mut rng = Seed(seed).rng();
    (0..n).map(|_| 3.0 * seed::in_unit_ball(&mut rng) + 6.5 * Vec3::Y).collect()
}

fn flow(starts: &[Vec3], params: &FlowParams) -> Flow {
    let density = lollipop();
    let control = Control::default();
    let way = Way::new(&density, params, &control).unwrap();
    run(starts, 10.0, &Forces::new(&[], &way, params), params, &control).unwrap()
}

#[test]
fn all_particles_reach_the_base_and_join_on_their_way() {
    let flow = flow(&starts(500, 1), &FlowParams::default());
    let FlowReport { n_particles, n_joins, n_followed, n_arrived, n_steered, n_led, .. } =
        flow.report;
    assert_eq!(
        (n_particles, n_arrived + n_joins + n_followed, n_led),
        (500, 500, 0),
        "{:?}",
        flow.report
    );
    assert!(n_steered == 0 && n_arrived < 4, "{:?}", flow.report);
    assert_eq!(flow.traces.masses()[0], 500);
    // Node 0 is the base, and everything leads there.
    let next = flow.traces.next();
    for mut node in 0..next.len() as u32 {
        let mut hops = 0;
        while next[node as usize] != NO_PARENT {
            node = next[node as usize];
            hops += 1;
            assert!(hops <= next.len());
        }
        assert_eq!(node, 0);
    }
}

#[test]
fn below_the_crown_everything_runs_in_the_trunk() {
    let flow = flow(&starts(300, 2), &FlowParams::default());
    for p in flow.traces.positions().iter().filter(|p| p.y < 2.5) {
        assert!(Vec3::new(p.x, 0.0, p.z).length() < 0.6, "{p}");
    }
}

#[test]
fn a_cheaper_stem_makes_wider_branching_angles() {
    let mean_slope = |stem: f32| {
        let params = FlowParams { stem, neighbour: 0.0, ..FlowParams::default() };
        let skeleton = flow(&starts(200, 3), &params).traces.skeleton(&Control::default()).unwrap();
        let p = skeleton.positions();
        // Slopes of what is high in the crown and off the stem.
        let outer = skeleton.segments().filter(|&(_, b)| {
            let b = p[b as usize];
            Vec3::new(b.x, 0.0, b.z).length() > 1.0
        });
        let slopes: Vec<f32> =
            outer.map(|(a, b)| (p[b as usize] - p[a as usize]).normalize_or_zero().y).collect();
        slopes.iter().sum::<f32>() / slopes.len() as f32
    };
    assert!(mean_slope(0.3) < mean_slope(1.0) - 0.1);
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let starts = starts(400, 4);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| flow(&starts, &FlowParams::default()))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn particles_far_outside_and_out_of_time_are_brought_home() {
    let mut starts = starts(20, 5);
    starts.push(Vec3::new(300.0, -50.0, 20.0));
    let params = FlowParams { steps: 20, ..FlowParams::default() };
    let flow = flow(&starts, &params);
    assert!(flow.report.n_steered > 0 && flow.report.n_led > 0, "{:?}", flow.report);
    assert_eq!(
        flow.report.n_arrived + flow.report.n_led + flow.report.n_joins + flow.report.n_followed,
        21
    );
    let skeleton = flow.traces.skeleton(&Control::default()).unwrap();
    assert_eq!(skeleton.len(), flow.traces.positions().len());
}

#[test]
fn limits_and_bad_numbers_are_errors() {
    let density = lollipop();
    let params = FlowParams::default();
    let control = Control::default().with_limits(Limits { nodes: 100, ..Limits::default() });
    let way = Way::new(&density, &params, &control).unwrap();
    let forces = Forces::new(&[], &way, &params);
    let error = run(&starts(90, 6), 10.0, &forces, &params, &control).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
    let error = run(&[Vec3::NAN], 10.0, &forces, &params, &control).unwrap_err();
    assert!(matches!(error, ModelError::NotFinite { .. }), "{error}");
    let bad = FlowParams { turn: f32::NAN, ..params.clone() };
    let error = run(&[], 10.0, &forces, &bad, &control).unwrap_err();
    assert!(error.to_string().contains("flow.turn"), "{error}");
    let empty = run(&[], 10.0, &forces, &params, &control).unwrap();
    assert_eq!(empty.traces.skeleton(&control).unwrap().len(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn any_parameters_give_one_tree(
        particles in prop::collection::vec((-5.0_f32..5.0, -1.0_f32..11.0, -5.0_f32..5.0), 0..60),
        (step, join, sight) in (0.002_f32..0.1, 1e-4_f32..0.1, 0.0_f32..0.5),
        (turn, neighbour, steps) in (1e-3_f32..0.3, 0.0_f32..3.0, 1_u32..60),
    ) {
        let starts: Vec<Vec3> = particles.into_iter().map(Vec3::from).collect();
        let params = FlowParams { step, join, sight, turn, neighbour, steps, ..Default::default() };
        let flow = flow(&starts, &params);
        let FlowReport { n_joins, n_followed, n_arrived, n_led, .. } = flow.report;
        prop_assert_eq!(n_joins + n_followed + n_arrived + n_led, starts.len() as u32);
        let skeleton = flow.traces.skeleton(&Control::default()).unwrap();
        prop_assert_eq!(skeleton.len(), flow.traces.positions().len());
    }
}
