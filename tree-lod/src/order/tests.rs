use super::*;
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{Control, Seed};

/// Elements of these centres and normals, of one area.
fn elements(centers: Vec<Vec3>, normals: Vec<Vec3>) -> Elements {
    let n = centers.len();
    Elements {
        surfaces: vec![0],
        surface: vec![0; n],
        starts: (0..=n as u32).collect(),
        triangles: (0..n as u32).collect(),
        centers,
        normals,
        areas: vec![0.01; n],
        radii: vec![0.1; n],
    }
}

/// Leaves in a ball of 2 m, 4 m over the ground, of random directions.
fn ball(n: u64, seed: u64) -> Elements {
    let mut rng = Seed(seed).rng();
    let center = |_| 4.0 * Vec3::Y + 2.0 * tree_core::seed::in_unit_ball(&mut rng);
    let centers = (0..n).map(center).collect();
    let mut rng = Seed(seed).child(1).rng();
    elements(centers, (0..n).map(|_| tree_core::seed::unit_vector(&mut rng)).collect())
}

type Orders = [(&'static str, Vec<u32>); 5];

fn all(elements: &Elements, seed: u64) -> Orders {
    let (params, seed, control) = (OrderParams::default(), Seed(seed), Control::default());
    let field = params.field(elements).unwrap();
    let hull = crate::implicit::surface(&field, &params.hull, &control).unwrap();
    [
        ("stochastic", stochastic(elements, seed)),
        ("golden", golden(elements).unwrap()),
        ("density", density(elements, &params, seed, &control).unwrap()),
        ("orientation", orientation(elements, &hull, &params, seed, &control).unwrap()),
        ("combined", combined(elements, &params, seed, &control).unwrap()),
    ]
}

/// Largest difference between the share of a prefix and of all elements in any quadrant about a place.
fn discrepancy(elements: &Elements, prefix: &[u32]) -> f64 {
    let share = |rows: &mut dyn Iterator<Item = u32>, [x, z]: [f32; 2]| {
        let (mut n, mut within) = (0.0, 0.0);
        for center in rows.map(|row| elements.centers[row as usize]) {
            n += 1.0;
            within += f64::from(u8::from(center.x < x && center.z < z));
        }
        within / n
    };
    let steps = || (0..8).map(|i| -2.0 + 0.5 * i as f32);
    let corners = steps().flat_map(|x| steps().map(move |z| [x, z]));
    let differences = corners.map(|corner| {
        let all = share(&mut (0..elements.len() as u32), corner);
        (share(&mut prefix.iter().copied(), corner) - all).abs()
    });
    differences.fold(0.0, f64::max)
}

#[test]
fn every_beginning_of_the_golden_order_is_spread_more_evenly_than_a_random_one() {
    let elements = ball(3000, 1);
    let golden = golden(&elements).unwrap();
    for n in [50, 100, 200, 400, 800, 1500] {
        let random =
            (0..9).map(|seed| discrepancy(&elements, &stochastic(&elements, Seed(seed))[..n]));
        let mean = random.sum::<f64>() / 9.0;
        let found = discrepancy(&elements, &golden[..n]);
        assert!(found < 0.7 * mean, "{n}: {found} {mean}");
    }
}

#[test]
fn the_denser_half_is_thinned_first() {
    let mut elements = ball(2000, 2);
    for center in &mut elements.centers[..1600] {
        center.x = center.x.abs();
    }
    for center in &mut elements.centers[1600..] {
        center.x = -center.x.abs();
    }
    let params = OrderParams { uniform: 0.0, least: 0.4, radius: 0.12, ..OrderParams::default() };
    let order = density(&elements, &params, Seed(1), &Control::default()).unwrap();
    let sparse = |rows: &[u32]| rows.iter().filter(|&&row| row >= 1600).count();
    assert!(sparse(&order[1700..]) < 15, "{}", sparse(&order[1700..]));
    // A fifth at first; at borders densities are low, so what is left is not quite a half.
    let half = sparse(&order[..800]) as f32 / 800.0;
    assert!((0.36..0.55).contains(&half), "{half}");
}

#[test]
fn of_coincident_pairs_one_goes_before_any_pair_goes() {
    let mut elements = ball(200, 3);
    elements = elements_twice(&elements);
    let params = OrderParams { uniform: 0.0, least: 0.5, radius: 0.005, ..OrderParams::default() };
    let order = density(&elements, &params, Seed(1), &Control::default()).unwrap();
    let mut kept: Vec<u32> = order[..200].iter().map(|row| row % 200).collect();
    kept.sort_unstable();
    kept.dedup();
    assert!(kept.len() > 195, "{}", kept.len());
}

fn elements_twice(once: &Elements) -> Elements {
    elements(once.centers.repeat(2), once.normals.repeat(2))
}

#[test]
fn elements_along_the_hull_stay() {
    let mut elements = ball(400, 4);
    for (row, normal) in elements.normals.iter_mut().enumerate() {
        let out = (elements.centers[row] - 4.0 * Vec3::Y).normalize();
        *normal = match row % 4 {
            0 => out,
            1 => -out,
            _ => out.any_orthonormal_vector(),
        };
    }
    // One smooth ball around all.
    let field = Metaballs::new(&elements.centers, 1.5).unwrap();
    let (params, control) = (OrderParams::default(), Control::default());
    let hull = crate::implicit::surface(&field, &params.hull, &control).unwrap();
    let order = orientation(&elements, &hull, &params, Seed(1), &control).unwrap();
    let along = order[..200].iter().filter(|&row| row % 4 < 2).count();
    assert!(along > 190, "{along}");
}

#[test]
fn elements_without_area_come_last() {
    let mut elements = ball(300, 5);
    for row in [7, 100] {
        elements.areas[row] = 0.0;
        elements.normals[row] = Vec3::ZERO;
    }
    for (name, order) in &all(&elements, 1)[2..] {
        assert_eq!(order[298..], [7, 100], "{name}");
    }
}

#[test]
fn orders_are_the_same_for_any_number_of_threads() {
    let elements = ball(1500, 6);
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    assert_eq!(pool(1).install(|| all(&elements, 1)), pool(4).install(|| all(&elements, 1)));
}

#[test]
fn an_order_that_is_none_is_refused_at_its_row() {
    let row = |order: &[u32]| match check(order, 3) {
        Err(LodError::Order { row, .. }) => Some(row),
        _ => None,
    };
    assert_eq!(row(&[2, 0, 1]), None);
    assert_eq!(row(&[2, 3, 1]), Some(1));
    assert_eq!(row(&[2, 0, 2]), Some(2));
    assert_eq!(row(&[2, 0]), Some(2));
    assert_eq!(row(&[2, 0, 1, 1]), Some(3));
}

#[test]
fn foliage_without_area_or_with_short_columns_is_refused() {
    let mut elements = ball(10, 7);
    elements.areas.fill(0.0);
    let error = density(&elements, &OrderParams::default(), Seed(1), &Control::default());
    assert!(error.unwrap_err().to_string().contains("no element has area"));
    elements.areas.pop();
    let error = density(&elements, &OrderParams::default(), Seed(1), &Control::default());
    assert!(error.unwrap_err().to_string().contains("as many as elements"));
    assert!(golden(&Elements::default()).unwrap_err().to_string().contains("no elements"));
}

#[test]
fn numbers_out_of_range_are_refused_by_name() {
    let wrong = [
        (OrderParams { radius: f32::NAN, ..OrderParams::default() }, "order.radius"),
        (OrderParams { height: -1.0, ..OrderParams::default() }, "order.height"),
        (OrderParams { randomness: 2.0, ..OrderParams::default() }, "order.randomness"),
        (OrderParams { least: -0.1, ..OrderParams::default() }, "order.least"),
        (OrderParams { uniform: -0.1, ..OrderParams::default() }, "order.uniform"),
    ];
    for (params, name) in wrong {
        let error = combined(&ball(5, 1), &params, Seed(1), &Control::default()).unwrap_err();
        assert!(error.to_string().starts_with(name), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn every_order_is_a_permutation(n in 1_u64..150, seed in any::<u64>()) {
        let elements = ball(n, seed);
        for (name, order) in all(&elements, seed) {
            prop_assert!(check(&order, elements.len()).is_ok(), "{}", name);
        }
    }
}
