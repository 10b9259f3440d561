use super::*;
use crate::sketch::{Label, Omega, Plan};
use glam::Vec2;
use proptest::prelude::*;
use tree_core::{Control, NO_PARENT, Seed};

/// A plan of straight strokes: a trunk to the top, and for each lateral where it leaves (0 to 1) and its tip.
fn plan(laterals: &[(f32, Vec2)]) -> Plan {
    let mut places: Vec<(f32, Vec2)> = laterals.to_vec();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut positions, mut parents, mut strokes) = (vec![Vec2::ZERO], vec![NO_PARENT], vec![0]);
    let mut trunk = 0_u32;
    let mut add = |position: Vec2, parent: u32, stroke: u32| {
        positions.push(position);
        parents.push(parent);
        strokes.push(stroke);
        positions.len() as u32 - 1
    };
    for (number, &(place, tip)) in places.iter().enumerate() {
        let fork = Vec2::new(0.0, 8.0 * place);
        trunk = add(fork, trunk, 0);
        let half = add(0.5 * (fork + tip), trunk, number as u32 + 1);
        add(tip, half, number as u32 + 1);
    }
    add(Vec2::new(0.0, 8.0), trunk, 0);
    Plan::from_columns(positions, parents, strokes, Vec2::ZERO, 1.0).unwrap()
}

fn usual() -> Plan {
    plan(&[
        (0.3, Vec2::new(2.5, 4.0)),
        (0.45, Vec2::new(-2.0, 5.5)),
        (0.6, Vec2::new(1.8, 6.5)),
        (0.75, Vec2::new(-1.2, 7.5)),
    ])
}

fn inferred(plan: &Plan, params: &InferParams, seed: u64) -> Inferred {
    infer(plan, &Omega::default(), params, Seed(seed), &Control::default()).unwrap()
}

#[test]
fn branches_project_onto_the_plan_to_the_bit() {
    let plan = usual();
    let found = inferred(&plan, &InferParams::default(), 1);
    for segment in 0..found.branches.len() {
        for (&node, point) in found.nodes(segment).iter().zip(found.branches.points(segment)) {
            assert_eq!(point.truncate(), plan.positions()[node as usize]);
        }
    }
}

#[test]
fn a_known_depth_stays() {
    let plan = usual();
    let node = plan.len() as u32 - 2;
    let pins = [Pin { node, depth: 1.25 }];
    let (omega, params) = (Omega::default(), InferParams::default());
    let known = (&pins[..], None);
    let found = infer_with(&plan, &omega, known, &params, Seed(1), &Control::default()).unwrap();
    let segment = (0..found.branches.len()).find(|&i| found.nodes(i).last() == Some(&node));
    assert_eq!(found.branches.end(segment.unwrap()).z, 1.25);
}

#[test]
fn a_stroke_that_goes_on_is_the_axis() {
    let found = inferred(&usual(), &InferParams::default(), 3);
    let plan = usual();
    for segment in 1..found.branches.len() {
        let node = found.nodes(segment)[1];
        let on_trunk = plan.strokes()[node as usize] == 0;
        assert_eq!(on_trunk, found.branches.labels()[segment] == Label::Apical);
    }
}

#[test]
fn branches_that_cross_get_room() {
    // From the right to the left over one from the left to the right.
    let plan = plan(&[(0.3, Vec2::new(-3.0, 6.0)), (0.6, Vec2::new(-3.0, 3.0))]);
    for seed in 0..10 {
        assert_eq!(inferred(&plan, &InferParams::default(), seed).interpenetrations, 0);
    }
}

#[test]
fn omega_stays_when_it_is_to_be_kept() {
    let params = InferParams { keep_omega: true, ..InferParams::default() };
    assert_eq!(inferred(&usual(), &params, 1).omega, Omega::default());
}

#[test]
fn another_seed_gives_other_depths() {
    let depth = |seed| inferred(&usual(), &InferParams::default(), seed).branches.end(2).z;
    assert_ne!(depth(1), depth(2));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn no_step_lowers_the_posterior_and_threads_do_not_matter(
        laterals in prop::collection::vec(
            (0.1_f32..0.9, (-3.0_f32..3.0, 0.5_f32..8.0).prop_map(|(x, y)| Vec2::new(x, y))), 0..7),
        seed in 0_u64..100, thesis in any::<bool>(),
    ) {
        let plan = plan(&laterals);
        let params = if thesis { InferParams::thesis() } else { InferParams::default() };
        let found = inferred(&plan, &params, seed);
        for pair in found.trace.windows(2) {
            let (before, after) = (pair[0].posterior.total(), pair[1].posterior.total());
            prop_assert!(after >= before - 1e-9 * before.abs().max(1.0), "{before} {after}");
        }
        let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        prop_assert_eq!(one.install(|| inferred(&plan, &params, seed)), found);
    }
}
