//! The distance against every constrained mapping there is, and as a metric.

use super::*;
use crate::error::CoreError;
use crate::limits::Limits;
use crate::skeleton::NO_PARENT;
use proptest::prelude::*;

/// Ancestry of a small tree.
struct Kin {
    parents: Vec<u32>,
}

impl Kin {
    fn is_above(&self, above: usize, below: usize) -> bool {
        let mut node = below;
        while self.parents[node] != NO_PARENT {
            node = self.parents[node] as usize;
            if node == above {
                return true;
            }
        }
        false
    }

    /// The lowest node that both are or descend from.
    fn join(&self, a: usize, b: usize) -> usize {
        let mut node = a;
        while node != b && !self.is_above(node, b) {
            node = self.parents[node] as usize;
        }
        node
    }
}

/// Whether a mapping keeps ancestors and sends disjoint subtrees to disjoint subtrees (Zhang 1996,
/// definition 2).
fn is_constrained(a: &Kin, b: &Kin, mapping: &[(usize, usize)]) -> bool {
    mapping.iter().all(|&(i1, j1)| {
        mapping.iter().all(|&(i2, j2)| {
            a.is_above(i1, i2) == b.is_above(j1, j2)
                && mapping.iter().all(|&(i3, j3)| {
                    a.is_above(a.join(i1, i2), i3) == b.is_above(b.join(j1, j2), j3)
                })
        })
    })
}

fn cost_of(a: &EditTree, b: &EditTree, mapping: &[(usize, usize)]) -> f64 {
    let kept: f64 = mapping.iter().map(|&(i, j)| a.weights()[i] + b.weights()[j]).sum();
    let changed: f64 = mapping.iter().map(|&(i, j)| (a.weights()[i] - b.weights()[j]).abs()).sum();
    a.weights().iter().sum::<f64>() + b.weights().iter().sum::<f64>() - kept + changed
}

/// The least cost over all constrained mappings that agree with `mapping` on the nodes below `next`.
fn exhaustive(
    (a, a_kin): (&EditTree, &Kin),
    (b, b_kin): (&EditTree, &Kin),
    next: usize,
    mapping: &mut Vec<(usize, usize)>,
) -> f64 {
    if !is_constrained(a_kin, b_kin, mapping) {
        return f64::INFINITY;
    }
    if next == a.len() {
        return cost_of(a, b, mapping);
    }
    let mut best = exhaustive((a, a_kin), (b, b_kin), next + 1, mapping);
    for j in 0..b.len() {
        if mapping.iter().all(|&(_, other)| other != j) {
            mapping.push((next, j));
            best = best.min(exhaustive((a, a_kin), (b, b_kin), next + 1, mapping));
            mapping.pop();
        }
    }
    best
}

fn tree(parents: &[u32], weights: &[f64]) -> EditTree {
    EditTree::new(parents.to_vec(), weights.to_vec()).unwrap()
}

fn kin(tree: &EditTree) -> Kin {
    Kin { parents: tree.parents().to_vec() }
}

fn between(a: &EditTree, b: &EditTree) -> EditDistance {
    distance_of(a, b, true, &Control::default()).unwrap()
}

/// All ways to give `n` nodes parents that come before them.
fn all_shapes(n: usize) -> Vec<Vec<u32>> {
    let mut shapes = vec![vec![NO_PARENT]];
    for node in 1..n as u32 {
        let longer = |shape: &Vec<u32>| {
            let shape = shape.clone();
            (0..node).map(move |parent| [shape.as_slice(), &[parent]].concat())
        };
        shapes = shapes.iter().flat_map(longer).collect();
    }
    shapes
}

/// Weights that make every node a little different.
fn weights(n: usize, step: f64) -> Vec<f64> {
    (0..n).map(|i| 1.0 + step * ((7 * i + 3) % 5) as f64).collect()
}

#[test]
fn all_small_trees_agree_with_every_constrained_mapping() {
    for n in 1..=4 {
        for m in 1..=4 {
            for (a, b) in all_shapes(n)
                .iter()
                .flat_map(|a| all_shapes(m).into_iter().map(move |b| (a.clone(), b)))
            {
                for (x, y) in [(0.0, 0.0), (0.3, 0.17)] {
                    let (a, b) = (tree(&a, &weights(n, x)), tree(&b, &weights(m, y)));
                    let best = exhaustive((&a, &kin(&a)), (&b, &kin(&b)), 0, &mut Vec::new());
                    let found = between(&a, &b).value;
                    assert!((found - best).abs() < 1e-9, "{a:?} {b:?}: {found}, {best}");
                }
            }
        }
    }
}

fn any_tree(most: usize) -> impl Strategy<Value = EditTree> {
    (1..=most)
        .prop_flat_map(|n| {
            let parents = (1..n as u32).map(|node| 0..node).collect::<Vec<_>>();
            (parents, prop::collection::vec(0.0_f64..4.0, n))
        })
        .prop_map(|(parents, weights)| {
            let parents = [NO_PARENT].into_iter().chain(parents).collect();
            EditTree::new(parents, weights).unwrap()
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn small_trees_agree_with_every_constrained_mapping(a in any_tree(6), b in any_tree(5)) {
        let best = exhaustive((&a, &kin(&a)), (&b, &kin(&b)), 0, &mut Vec::new());
        prop_assert!((between(&a, &b).value - best).abs() < 1e-9);
    }

    #[test]
    fn the_mapping_is_constrained_and_costs_what_is_said(a in any_tree(24), b in any_tree(24)) {
        let found = between(&a, &b);
        let mapping: Vec<(usize, usize)> =
            found.mapping.iter().map(|&[i, j]| (i as usize, j as usize)).collect();
        prop_assert!(is_constrained(&kin(&a), &kin(&b), &mapping));
        prop_assert!((cost_of(&a, &b, &mapping) - found.value).abs() < 1e-9);
    }

    #[test]
    fn it_is_a_metric(a in any_tree(20), b in any_tree(20), c in any_tree(20)) {
        let [ab, bc, ac] = [between(&a, &b), between(&b, &c), between(&a, &c)];
        prop_assert!(ab.value >= 0.0 && (0.0..=1.0).contains(&ab.normalized));
        prop_assert!((ab.value - between(&b, &a).value).abs() < 1e-9);
        prop_assert!(between(&a, &a).value.abs() < 1e-9);
        prop_assert!(ac.value <= ab.value + bc.value + 1e-9);
        prop_assert!(ac.normalized <= ab.normalized + bc.normalized + 1e-9);
    }

    #[test]
    fn the_order_of_siblings_does_not_matter(a in any_tree(24), key in any::<u64>()) {
        // A random order with parents first.
        let mut order = vec![0_u32];
        let mut open: Vec<u32> = Vec::new();
        let mut place = vec![0_u32; a.len()];
        for step in 0..a.len() {
            let node = order[step];
            place[node as usize] = step as u32;
            open.extend((0..a.len() as u32).filter(|&n| a.parents()[n as usize] == node));
            if !open.is_empty() {
                let pick = crate::Seed(key).child(step as u64).0 as usize % open.len();
                order.push(open.swap_remove(pick));
            }
        }
        let parents = order.iter().map(|&n| match a.parents()[n as usize] {
            NO_PARENT => NO_PARENT,
            parent => place[parent as usize],
        });
        let weights = order.iter().map(|&n| a.weights()[n as usize]);
        let shuffled = EditTree::new(parents.collect(), weights.collect()).unwrap();
        prop_assert!(between(&a, &shuffled).value.abs() < 1e-9);
    }

    #[test]
    fn few_rows_give_the_same_as_all(a in any_tree(40), b in any_tree(40)) {
        let few = distance_of(&a, &b, false, &Control::default()).unwrap();
        prop_assert_eq!(few.value, between(&a, &b).value);
    }
}

#[test]
fn a_deleted_branch_costs_what_it_weighs() {
    let a = tree(&[NO_PARENT, 0, 0, 2], &[3.0, 1.0, 2.0, 0.5]);
    let b = tree(&[NO_PARENT, 0], &[3.0, 1.0]);
    let found = between(&a, &b);
    assert_eq!(found.value, 2.5);
    assert_eq!(found.weights, [6.5, 4.0]);
    assert_eq!(found.mapping, [[0, 0], [1, 1]]);
}

#[test]
fn subtrees_that_are_apart_stay_apart() {
    // Zhang's constraint: without it, e and f could become the children of one node for the price of c.
    let a = tree(&[NO_PARENT, 0, 0, 1, 1], &[1.0, 1.0, 4.0, 4.0, 4.0]);
    let b = tree(&[NO_PARENT, 0, 0, 0], &[1.0, 4.0, 4.0, 4.0]);
    // One of the two below the fork is lost with it and inserted anew.
    assert_eq!(between(&a, &b).value, 1.0 + 4.0 + 4.0);
}

fn fork() -> Skeleton {
    let mut builder = Skeleton::builder(glam::Vec3::ZERO, 0.4).unwrap();
    let mid = builder.add(0, glam::Vec3::Y, 0.3).unwrap();
    let top = builder.add(mid, 2.0 * glam::Vec3::Y, 0.2).unwrap();
    builder.add(top, glam::Vec3::new(1.0, 2.0, 0.0), 0.1).unwrap();
    let side = builder.add(top, glam::Vec3::new(-1.0, 2.0, 0.0), 0.1).unwrap();
    builder.add(side, glam::Vec3::new(-2.0, 2.0, 0.0), 0.05).unwrap();
    builder.finish()
}

#[test]
fn reductions_join_runs_and_axes() {
    let of = |reduction, weight| {
        EditTree::of(&fork(), &EditParams { reduction, weight, ..Default::default() })
    };
    let runs = of(Reduction::Runs, Weight::Radius);
    assert_eq!(runs.parents(), [NO_PARENT, 0, 0]);
    assert_eq!(runs.nodes(), [2, 3, 5]);
    let close = |found: &[f64], wanted: &[f64]| {
        found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-6)
    };
    assert!(close(runs.weights(), &[0.25, 0.1, 0.075]), "{:?}", runs.weights());
    assert_eq!(of(Reduction::Axes, Weight::Unit).parents(), [NO_PARENT, 0]);
    let all = of(Reduction::None, Weight::RadiusTimesLength);
    assert!(close(all.weights(), &[0.0, 0.3, 0.2, 0.1, 0.1, 0.05]));
    assert!(close(
        of(Reduction::Runs, Weight::RadiusSquaredTimesLength).weights(),
        &[0.13, 0.01, 0.0125]
    ));
}

#[test]
fn dividing_a_shoot_changes_nothing_between_runs() {
    let mut columns = crate::skeleton::SkeletonColumns::from(fork());
    // One more node half way up the first segment.
    columns.positions.insert(1, 0.5 * glam::Vec3::Y);
    columns.radii.insert(1, 0.3);
    columns.parents = vec![NO_PARENT, 0, 1, 2, 3, 3, 5];
    let finer = Skeleton::try_from(columns).unwrap();
    let found = distance(&fork(), &finer, &EditParams::default(), &Control::default()).unwrap();
    assert!(found.value < 1e-6);
    let plain = EditParams { reduction: Reduction::None, ..Default::default() };
    let found = distance(&fork(), &finer, &plain, &Control::default()).unwrap();
    assert!((found.value - 0.3).abs() < 1e-6);
}

#[test]
fn the_mapping_names_nodes_of_the_skeletons() {
    let params = EditParams { mapping: true, ..Default::default() };
    let found = distance(&fork(), &fork(), &params, &Control::default()).unwrap();
    assert_eq!(found.mapping, [[2, 2], [3, 3], [5, 5]]);
}

#[test]
fn pairs_over_the_limit_are_an_error() {
    let limits = Limits { pairs: 8, ..Default::default() };
    let control = Control::default().with_limits(limits);
    let plain = EditParams { reduction: Reduction::None, mapping: true, ..Default::default() };
    let error = distance(&fork(), &fork(), &plain, &control).unwrap_err();
    assert!(matches!(error, CoreError::Limit(e) if e.requested == 36 && e.cap == 8), "{error}");
}

#[test]
fn cancelling_ends_it() {
    let control = Control::default().with_stop(|| true);
    let error = distance(&fork(), &fork(), &EditParams::default(), &control).unwrap_err();
    assert!(matches!(error, CoreError::Cancelled(_)));
}

#[test]
fn trees_out_of_shape_are_refused() {
    let bad = |parents: &[u32], weights: &[f64]| {
        EditTree::new(parents.to_vec(), weights.to_vec()).unwrap_err()
    };
    assert!(matches!(bad(&[], &[]), CoreError::Empty { .. }));
    assert!(matches!(bad(&[NO_PARENT], &[]), CoreError::Length { field: "weights", .. }));
    assert!(matches!(bad(&[NO_PARENT], &[f64::NAN]), CoreError::NotFinite { .. }));
    assert!(matches!(bad(&[NO_PARENT], &[-1.0]), CoreError::OutOfRange { .. }));
    assert!(matches!(bad(&[NO_PARENT, 1], &[1.0; 2]), CoreError::ParentOrder { .. }));
}

#[test]
fn own_costs_come_in() {
    struct Free;
    impl EditCosts for Free {
        fn delete(&self, _: u32) -> f64 {
            1.0
        }
        fn insert(&self, _: u32) -> f64 {
            2.0
        }
        fn change(&self, _: u32, _: u32) -> f64 {
            0.0
        }
    }
    let a = tree(&[NO_PARENT, 0, 1], &[5.0; 3]);
    let b = tree(&[NO_PARENT, 0, 0], &[5.0; 3]);
    let found = distance_with(&a, &b, &Free, false, &Control::default()).unwrap();
    // The chain's tip goes, a second child comes.
    assert_eq!(found.value, 3.0);
}

#[test]
fn a_thousand_siblings_are_compared() {
    let star = |n: usize, step: f64| {
        let parents = (0..n).map(|i| if i == 0 { NO_PARENT } else { 0 }).collect();
        EditTree::new(parents, weights(n, step)).unwrap()
    };
    let (a, b) = (star(301, 0.1), star(251, 0.1));
    let found = between(&a, &b);
    assert_eq!(found.mapping.len(), 251);
    assert!(found.value >= 50.0);
}
