use super::*;
use crate::LodError;
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{Limits, Seed};
use tree_mesh::topology::{Topology, examine};

fn cloud(n: u64, size: f32, seed: u64) -> Vec<Vec3> {
    let unit = |i, axis| Seed(seed).child(i).unit(axis);
    (0..n).map(|i| size * Vec3::new(unit(i, 0), unit(i, 1), unit(i, 2))).collect()
}

fn hull(points: &[Vec3], radius: f32, params: HullParams) -> Hull {
    surface(&Metaballs::new(points, radius).unwrap(), &params, &Control::default()).unwrap()
}

fn topology(hull: &Hull) -> Topology {
    hull.to_mesh().check().unwrap();
    examine(&hull.to_mesh().surfaces[0]).unwrap()
}

fn brute(points: &[Vec3], radius: f32, place: Vec3) -> f32 {
    let share = |p: &Vec3| (1.0 - p.distance_squared(place) / (radius * radius)).max(0.0);
    points.iter().map(|p| share(p) * share(p)).sum()
}

#[test]
fn a_lone_point_makes_a_ball() {
    let hull = hull(&[Vec3::X], 2.0, HullParams { detail: 8.0, ..HullParams::default() });
    let radius = 2.0 * (1.0 - 0.05_f32.sqrt()).sqrt();
    for (position, normal) in hull.positions().iter().zip(hull.normals()) {
        let out = *position - Vec3::X;
        assert!((out.length() - radius).abs() < 0.03, "{} {radius}", out.length());
        assert!(normal.dot(out.normalize()) > 0.999_9);
    }
    let found = topology(&hull);
    let ball = 4.0 / 3.0 * std::f64::consts::PI * f64::from(radius * radius * radius);
    assert!(found.is_closed() && found.euler() == 2, "{found:?}");
    assert!((found.volume / ball - 1.0).abs() < 0.02, "{} {ball}", found.volume);
}

#[test]
fn the_gradient_is_the_slope_of_the_value() {
    let field = Metaballs::new(&cloud(50, 1.0, 1), 0.4).unwrap();
    for place in cloud(50, 1.0, 2) {
        let slope = Vec3::from_array(Vec3::AXES.map(|axis| {
            (field.value(place + 1e-3 * axis) - field.value(place - 1e-3 * axis)) / 2e-3
        }));
        let gradient = field.gradient(place);
        assert!((slope - gradient).length() < 0.02 * (1.0 + slope.length()), "{slope} {gradient}");
    }
}

#[test]
fn hollows_within_the_plant_have_no_wall() {
    let shell: Vec<Vec3> = cloud(3000, 2.0, 3).iter().map(|&p| (p - 1.0).normalize()).collect();
    let found = topology(&hull(&shell, 0.4, HullParams::default()));
    assert!(found.is_closed() && found.components == 1 && found.volume > 4.0, "{found:?}");
}

#[test]
fn the_hull_is_the_same_for_any_number_of_threads() {
    let points = cloud(2000, 10.0, 4);
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    let make = || hull(&points, 0.7, HullParams::default());
    let (one, four) = (pool(1).install(make), pool(4).install(make));
    assert_eq!(one.positions(), four.positions());
    assert_eq!((one.normals(), one.indices()), (four.normals(), four.indices()));
    assert_eq!(one.sample(100, Seed(1)), four.sample(100, Seed(1)));
}

#[test]
fn samples_are_even_by_area() {
    let hull = hull(&[Vec3::ZERO], 1.0, HullParams::default());
    let samples = hull.sample(800, Seed(1));
    assert_eq!(samples.len(), 800);
    let mut octants = [0; 8];
    for sample in &samples {
        octants[sample.position.cmpgt(Vec3::ZERO).bitmask() as usize] += 1;
    }
    assert!(octants.iter().all(|n| (85..=115).contains(n)), "{octants:?}");
    assert!(hull.sample(0, Seed(1)).is_empty());
}

#[test]
fn the_nearest_place_is_within_one_percent_of_the_nearest_of_all_triangles() {
    let hull = hull(&cloud(200, 3.0, 5), 0.5, HullParams::default());
    let (triangles, _) = hull.indices().as_chunks::<3>();
    for point in cloud(40, 3.0, 6) {
        let all = triangles.iter().map(|t| {
            let corners = t.map(|v| hull.positions()[v as usize]);
            let [a, b, c] = nearest::closest(corners, point);
            (a * corners[0] + b * corners[1] + c * corners[2]).distance(point)
        });
        let best = all.fold(f32::INFINITY, f32::min);
        let found = hull.nearest(point).unwrap().position.distance(point);
        assert!(found > best - 1e-5 && found < 1.01 * best + 1e-5, "{found} {best}");
    }
    assert_eq!(hull.nearest_normal(Vec3::NAN), Vec3::ZERO);
}

#[test]
fn points_that_are_no_field_are_refused() {
    let refused = |points: &[Vec3], radius| Metaballs::new(points, radius).unwrap_err().to_string();
    assert!(refused(&[], 1.0).contains("no elements"));
    assert!(refused(&[Vec3::NAN], 1.0).contains("elements.centers is NaN"));
    assert!(refused(&[Vec3::splat(1e30)], 1.0).contains("elements.centers"));
    assert!(refused(&[Vec3::ZERO], 0.0).contains("field.radius is 0"));
    assert!(refused(&[Vec3::ZERO], f32::INFINITY).contains("field.radius is inf"));
}

#[test]
fn a_grid_over_the_limit_is_refused() {
    let field = Metaballs::new(&[Vec3::ZERO, Vec3::splat(1e3)], 5.0).unwrap();
    let control = Control::default().with_limits(Limits { voxels: 1000, ..Limits::default() });
    let error = surface(&field, &HullParams::default(), &control).unwrap_err();
    assert!(matches!(error, LodError::Limit(_)), "{error}");
}

#[test]
fn a_radius_that_numbers_do_not_resolve_is_refused() {
    let field = Metaballs::new(&[Vec3::splat(1e6)], 0.01).unwrap();
    let error = surface(&field, &HullParams::default(), &Control::default()).unwrap_err();
    assert!(error.to_string().contains("move them to the origin"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn every_hull_is_closed_and_faces_outwards(
        n in 1_u64..120,
        radius in 0.1_f32..2.0,
        detail in 2.0_f32..4.0,
        iso in 0.001_f32..0.5,
        seed in any::<u64>(),
    ) {
        let hull = hull(&cloud(n, 2.0, seed), radius, HullParams { iso, detail });
        let found = topology(&hull);
        prop_assert!(found.is_closed() && found.collapsed_triangles == 0, "{:?}", found);
        prop_assert!(found.volume > 0.0);
    }

    #[test]
    fn the_field_is_the_sum_over_all_points(
        n in 1_u64..80,
        radius in 0.01_f32..3.0,
        at in prop::array::uniform3(-1.0_f32..2.0),
        seed in any::<u64>(),
    ) {
        let points = cloud(n, 1.0, seed);
        let (place, field) = (Vec3::from_array(at), Metaballs::new(&points, radius).unwrap());
        let (found, all) = (field.value(place), brute(&points, radius, place));
        prop_assert!((found - all).abs() < 1e-4 * (1.0 + all), "{} {}", found, all);
        prop_assert!(points.iter().all(|&p| field.value(p) > 0.999));
    }
}
