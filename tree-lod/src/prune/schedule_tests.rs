use super::*;
use proptest::prelude::*;

/// A tier whose elements have these numbers of triangles.
pub(crate) fn tier(costs: &[u32]) -> Tier {
    let mut tier = Tier { starts: vec![0], triangles: Vec::new() };
    for &cost in costs {
        tier.triangles.extend((0..cost).map(|_| [0, 1, 2]));
        tier.starts.push(tier.triangles.len() as u32);
    }
    tier
}

fn cut(tier: u32, fine: u32, end: u32, n_triangles: u64) -> Cut {
    Cut { tier, fine, end, n_triangles }
}

fn steps(schedule: &Schedule) -> Vec<Cut> {
    (0..schedule.n_steps()).map(|step| schedule.cut(step)).collect()
}

#[test]
fn outlines_are_made_simpler_before_elements_are_dropped() {
    let schedule = Schedule::new(&[tier(&[4, 4]), tier(&[2, 2])], &[1, 0], &[]).unwrap();
    assert_eq!(
        steps(&schedule),
        [cut(0, 2, 2, 8), cut(0, 1, 2, 6), cut(1, 2, 2, 4), cut(1, 1, 1, 2)]
    );
    assert_eq!(schedule.at(0.99).unwrap(), cut(0, 1, 2, 6));
    assert_eq!(schedule.at(0.5).unwrap(), cut(1, 2, 2, 4));
}

#[test]
fn elements_are_dropped_within_a_tier_down_to_those_kept() {
    let tiers = [tier(&[4, 4, 4]), tier(&[2, 2, 2])];
    let schedule = Schedule::new(&tiers, &[0, 1, 2], &[3, 2]).unwrap();
    let expected =
        [cut(0, 3, 3, 12), cut(0, 2, 2, 8), cut(0, 1, 2, 6), cut(1, 2, 2, 4), cut(1, 1, 1, 2)];
    assert_eq!(steps(&schedule), expected);
    assert_eq!(schedule.lambda_of_rank(2), 1.0);
    assert!((schedule.lambda_of_rank(1) - 4.0 / 12.0).abs() < 1e-6);
}

#[test]
fn numbers_of_kept_elements_fall_from_all() {
    let tiers = [tier(&[4, 4, 4]), tier(&[2, 2, 2])];
    for kept in [vec![3], vec![2, 2], vec![3, 4], vec![3, 0]] {
        assert!(Schedule::new(&tiers, &[0, 1, 2], &kept).is_err(), "{kept:?}");
    }
}

#[test]
fn one_element_is_drawn_even_over_the_budget() {
    let schedule = Schedule::new(&[tier(&[4, 0, 4])], &[1, 2, 0], &[]).unwrap();
    assert_eq!(schedule.at(0.0).unwrap(), cut(0, 2, 2, 4));
    assert_eq!((schedule.lambda_of_rank(1), schedule.lambda_of_rank(2)), (0.0, 1.0));
}

#[test]
fn a_share_outside_its_range_is_refused() {
    let schedule = Schedule::new(&[tier(&[1])], &[0], &[]).unwrap();
    for lambda in [-0.1, 1.1, f32::NAN, f32::INFINITY] {
        let found = schedule.at(lambda);
        assert!(matches!(found, Err(LodError::Parameter(error)) if error.field == "lambda"));
    }
}

#[test]
fn orders_that_are_no_permutation_are_refused_with_the_row() {
    for (order, at) in [(vec![0, 0], 1), (vec![0, 2], 1), (vec![0], 1), (vec![0, 1, 1], 2)] {
        let found = Schedule::new(&[tier(&[1, 1])], &order, &[]);
        assert!(matches!(found, Err(LodError::Order { row, .. }) if row == at), "{order:?}");
    }
}

#[test]
fn tiers_that_do_not_fit_are_refused() {
    let ragged = Tier { starts: vec![0, 2, 1], triangles: vec![[0; 3]; 1] };
    let short = Tier { starts: vec![0, 1, 2], triangles: vec![[0; 3]; 1] };
    for tiers in [
        vec![],
        vec![Tier::default()],
        vec![tier(&[])],
        vec![tier(&[0, 0])],
        vec![tier(&[1, 1]), tier(&[1])],
        vec![tier(&[2, 1]), tier(&[1, 2])],
        vec![tier(&[2, 1]), tier(&[0, 0])],
        vec![ragged],
        vec![short],
    ] {
        assert!(
            matches!(Schedule::new(&tiers, &[0, 1], &[]), Err(LodError::Foliage(_))),
            "{tiers:?}"
        );
    }
}

/// Tiers with falling costs, an order, and what is kept.
fn cases() -> impl Strategy<Value = (Vec<Tier>, Vec<u32>, Vec<u32>)> {
    let costs = prop::collection::vec((0_u32..6, 0_u32..6, 0_u32..6), 1..40);
    (costs, 1_usize..4)
        .prop_flat_map(|(costs, n_tiers)| {
            let tiers: Vec<_> = (0..n_tiers)
                .map(|t| {
                    let falling = |&(a, b, c): &(u32, u32, u32)| [a + b + c, a + b, a][t];
                    // One element keeps a triangle.
                    let costs: Vec<_> = costs.iter().map(falling).chain([1]).collect();
                    tier(&costs)
                })
                .collect();
            let n = costs.len() as u32 + 1;
            let order: Vec<_> = (0..n).collect();
            let kept = prop::collection::vec(0.0_f32..1.0, n_tiers - 1);
            (Just(tiers), Just(order).prop_shuffle(), kept)
        })
        .prop_map(|(tiers, order, shares)| {
            let n = order.len() as u32;
            // Ranks without triangles in the last tier must be kept.
            let least =
                order.iter().position(|&element| tiers[tiers.len() - 1].cost(element as usize) > 0);
            let (mut kept, mut most) = (vec![n], n);
            for share in shares {
                most = ((most as f32 * share) as u32).max(least.unwrap_or(0) as u32 + 1);
                kept.push(most);
            }
            (tiers, order, kept)
        })
}

proptest! {
    #[test]
    fn neighbouring_states_differ_in_one_element((tiers, order, kept) in cases()) {
        let schedule = Schedule::new(&tiers, &order, &kept).unwrap();
        let tier_of = |cut: &Cut, rank: u32| match rank {
            _ if rank >= cut.end => None,
            _ => Some(cut.tier + u32::from(rank >= cut.fine)),
        };
        for step in 1..schedule.n_steps() {
            let (a, b) = (schedule.cut(step - 1), schedule.cut(step));
            let changed = (0..schedule.n_elements()).filter(|&r| tier_of(&a, r) != tier_of(&b, r));
            prop_assert_eq!(changed.count(), 1);
            prop_assert!(a.n_triangles >= b.n_triangles);
        }
    }

    #[test]
    fn the_most_that_fits_the_budget_is_drawn((tiers, order, kept) in cases(), lambda in 0.0_f32..=1.0) {
        let schedule = Schedule::new(&tiers, &order, &kept).unwrap();
        let budget = (f64::from(lambda) * schedule.n_triangles() as f64).floor() as u64;
        let steps = steps(&schedule);
        let fits = steps.iter().find(|cut| cut.n_triangles <= budget).copied();
        prop_assert_eq!(schedule.at(lambda).unwrap(), fits.or(steps.into_iter().last()).unwrap());
        prop_assert!(schedule.at(lambda).unwrap().n_triangles > 0);
    }

    #[test]
    fn every_number_of_triangles_is_found_by_its_share((tiers, order, kept) in cases()) {
        let schedule = Schedule::new(&tiers, &order, &kept).unwrap();
        for step in 0..schedule.n_steps() {
            let n = schedule.cut(step).n_triangles;
            prop_assert_eq!(schedule.at(schedule.lambda_of(n)).unwrap().n_triangles, n);
        }
    }
}
