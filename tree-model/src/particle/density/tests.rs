//! The way from mattes to a density, as a whole.

use super::*;
use crate::ModelError;
use crate::particle::{Camera, Grid, Matte, Projection, View};
use glam::{UVec3, Vec2, Vec3};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use tree_core::{Control, Limits, Seed};

/// Lawson, Hanson 1974: dense least squares without negative values.
fn lawson_hanson(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    let n = a.ncols();
    let mut x = DVector::zeros(n);
    let mut free = vec![false; n];
    let (gram, moments) = (a.transpose() * a, a.transpose() * b);
    for _ in 0..3 * n {
        let w = &moments - &gram * &x;
        let next = (0..n).filter(|&j| !free[j]).max_by(|&i, &j| w[i].total_cmp(&w[j]));
        let Some(next) = next.filter(|&j| w[j] > 1e-9) else { break };
        free[next] = true;
        loop {
            let set: Vec<usize> = (0..n).filter(|&j| free[j]).collect();
            let normal = gram.select_columns(&set).select_rows(&set);
            let s = normal.cholesky().unwrap().solve(&moments.select_rows(&set));
            if s.iter().all(|&value| value > 0.0) {
                x.fill(0.0);
                set.iter().zip(s.iter()).for_each(|(&j, &value)| x[j] = value);
                break;
            }
            let blocked = set.iter().zip(s.iter()).filter(|(_, s)| **s <= 0.0);
            let step = blocked.map(|(&j, s)| x[j] / (x[j] - s)).fold(1.0, f64::min);
            for (&j, &value) in set.iter().zip(s.iter()) {
                x[j] += step * (value - x[j]);
                free[j] = x[j] > 1e-12;
            }
        }
    }
    x
}

/// The system with its Tikhonov rows, as a dense one.
fn dense(system: &Equations) -> (DMatrix<f64>, DVector<f64>) {
    let (m, n) = (system.n_rays(), system.n_voxels());
    let mut a = DMatrix::zeros(m + n, n);
    let mut b = DVector::zeros(m + n);
    for ray in 0..m {
        let (columns, lengths) = system.row(ray);
        columns.iter().zip(lengths).for_each(|(&j, &l)| a[(ray, j as usize)] += f64::from(l));
        b[ray] = f64::from(system.targets()[ray]);
    }
    for (j, &weight) in system.weights().iter().enumerate() {
        a[(m + j, j)] = f64::from(system.lambda()) / f64::from(weight);
    }
    (a, b)
}

fn camera(yaw: f32, size: Vec2, scale: f32) -> Camera {
    let base = Vec2::new(0.5 * size.x, size.y);
    Camera { yaw, pitch: 0.0, projection: Projection::Orthographic, size, base, scale }
}

/// A view of a matte that is `alpha` at points in metres: to the right of and above the base.
fn view(yaw: f32, n: u32, metres: f32, alpha: impl Fn(f32, f32) -> f32) -> View {
    let size = Vec2::splat(n as f32);
    let scale = metres / n as f32;
    let values = (0..n * n).map(|i| {
        let x = ((i % n) as f32 + 0.5 - 0.5 * n as f32) * scale;
        alpha(x, (n as f32 - (i / n) as f32 - 0.5) * scale)
    });
    let matte = Matte::new(n, n, values.collect()).unwrap();
    View { matte, photo: None, camera: camera(yaw, size, scale) }
}

fn noisy(yaw: f32, seed: u64) -> View {
    let noise = Seed(seed);
    view(yaw, 12, 6.0, |x, y| noise.unit(((x + 9.0) * 7.0) as u64 + 1000 * (y * 3.0) as u64))
}

fn ball(yaw: f32) -> View {
    view(yaw, 96, 6.0, |x, y| f32::from(u8::from(x * x + (y - 3.0) * (y - 3.0) < 4.0)))
}

#[test]
fn the_density_is_that_of_dense_least_squares_without_negative_values() {
    for (views, evenness, rounding) in [
        (vec![noisy(0.0, 1), noisy(FRAC_PI_2, 2)], 0.1, 0.0),
        (vec![noisy(0.0, 3), noisy(FRAC_PI_2, 4), noisy(FRAC_PI_4, 5)], 0.1, 1.0),
        (vec![noisy(0.3, 6), noisy(2.0, 7)], 0.03, 0.5),
    ] {
        let params =
            DensityParams { resolution: 6, evenness, rounding, ..DensityParams::default() };
        let control = Control::default();
        let carved = carve(&views, &params, &control).unwrap();
        let (grid, report) = solve(&carved, &views, &params, &control).unwrap();
        let system = Equations::new(&carved, &views, &params, &control).unwrap();
        let (a, b) = dense(&system);
        let wanted = lawson_hanson(&a, &b);
        let found = carved.voxels().iter().map(|&i| f64::from(grid.values()[i as usize]));
        let found = DVector::from_iterator(system.n_voxels(), found);
        let off = (&found - &wanted).norm() / wanted.norm();
        assert!(wanted.iter().any(|&x| x == 0.0), "the bound matters");
        assert!(off < 0.01, "{off} {report:?}");
    }
}

#[test]
fn a_box_in_two_views_is_found_with_its_density() {
    let deep = 1.0 - libm::expf(-1.0);
    let square = |yaw| {
        view(yaw, 64, 4.0, |x, y| if x.abs() < 1.0 && (1.0..3.0).contains(&y) { deep } else { 0.0 })
    };
    let views = [square(0.0), square(FRAC_PI_2)];
    let params =
        DensityParams { resolution: 8, rounding: 0.0, evenness: 0.03, ..DensityParams::default() };
    let control = Control::default();
    let carved = carve(&views, &params, &control).unwrap();
    let (grid, report) = solve(&carved, &views, &params, &control).unwrap();
    assert!(report.residual < 0.01, "{report:?}");
    let middle = grid.sample(Vec3::new(0.0, 2.0, 0.0));
    assert!((middle - 0.5).abs() < 0.05, "{middle}");
    let volume = crown_volume(&grid, 0.1);
    assert!((volume - 8.0).abs() < 1.0, "{volume}");
}

#[test]
fn a_ball_seen_from_one_or_two_sides_is_round() {
    for views in [vec![ball(0.7)], vec![ball(0.0), ball(FRAC_PI_2)], vec![ball(0.0), ball(PI)]] {
        let params = DensityParams { resolution: 32, ..DensityParams::default() };
        let control = Control::default();
        let carved = carve(&views, &params, &control).unwrap();
        let (grid, report) = solve(&carved, &views, &params, &control).unwrap();
        let volume = crown_volume(&grid, 0.2);
        assert!((28.0..37.0).contains(&volume), "{volume}, a ball has 33.5; {report:?}");
        let camera = camera(FRAC_PI_4, Vec2::splat(64.0), 6.0 / 64.0);
        let area = look_through(&grid, &camera, &control).unwrap().area();
        let wanted = std::f64::consts::PI * 4.0 * (64.0 / 6.0) * (64.0 / 6.0);
        assert!((0.85..1.1).contains(&(area / wanted)), "{}", area / wanted);
    }
}

#[test]
fn a_cropped_view_does_not_carve_away_what_it_does_not_show() {
    let mut cropped = ball(FRAC_PI_2);
    let rows = cropped.matte.alpha()[96 * 48..].to_vec();
    cropped.matte = Matte::new(96, 48, rows).unwrap();
    cropped.camera.size.y = 48.0;
    cropped.camera.base.y -= 48.0;
    let params = DensityParams { resolution: 24, ..DensityParams::default() };
    let carved = carve(&[ball(0.0), cropped], &params, &Control::default()).unwrap();
    let top = carved.alpha().sample(Vec3::new(0.0, 4.6, 0.0));
    assert!(top > 0.9, "{top}");
}

#[test]
fn perspective_and_pitch_find_the_same_ball() {
    let control = Control::default();
    let params = DensityParams { resolution: 24, ..DensityParams::default() };
    let views = [ball(0.0), ball(FRAC_PI_2)];
    let carved = carve(&views, &params, &control).unwrap();
    let (grid, _) = solve(&carved, &views, &params, &control).unwrap();
    for (pitch, projection) in
        [(0.0, Projection::Perspective { fov: 0.6 }), (-0.3, Projection::Orthographic)]
    {
        let seen: Vec<View> = views
            .iter()
            .map(|view| {
                let camera = Camera { pitch, projection, ..view.camera };
                let matte = look_through(&grid, &camera, &control).unwrap();
                View { matte, photo: None, camera }
            })
            .collect();
        let carved = carve(&seen, &params, &control).unwrap();
        let (again, report) = solve(&carved, &seen, &params, &control).unwrap();
        let shared = overlap(&again, 0.2, &grid, 0.2);
        assert!(shared > 0.75, "{shared} {report:?}");
    }
}

#[test]
fn a_view_that_carves_everything_away_is_named() {
    let high = view(FRAC_PI_2, 96, 6.0, |_, y| f32::from(u8::from(y > 5.5)));
    let views = [ball(0.0), high];
    let error = carve(&views, &DensityParams::default(), &Control::default()).unwrap_err();
    assert!(matches!(error, ModelError::View { .. }), "{error}");
    let wide =
        [ball(0.0), ball(1.0), view(FRAC_PI_2, 96, 6.0, |x, _| f32::from(u8::from(x > 2.5)))];
    let error = carve(&wide, &DensityParams::default(), &Control::default()).unwrap_err();
    assert!(matches!(error, ModelError::View { view: 2, .. }), "{error}");
}

#[test]
fn bad_views_and_parameters_are_named() {
    let control = Control::default();
    let params = DensityParams::default();
    let of = |views: &[View], params: &DensityParams| {
        carve(views, params, &control).unwrap_err().to_string()
    };
    assert!(of(&[], &params).contains("views.len()"));
    let empty = view(0.0, 8, 6.0, |_, _| 0.0);
    assert!(of(&[ball(0.0), empty], &params).contains("views[1]"));
    let mut other = ball(0.0);
    other.camera.size.x = 95.0;
    assert!(of(&[other], &params).contains("95"));
    let mut nan = ball(0.0);
    nan.camera.yaw = f32::NAN;
    assert!(of(&[nan], &params).contains("views[0].camera.yaw"));
    let bad = DensityParams { evenness: f32::NAN, ..params.clone() };
    assert!(of(&[ball(0.0)], &bad).contains("density.evenness"));
    let bad = DensityParams { resolution: 3, ..params };
    assert!(of(&[ball(0.0)], &bad).contains("density.resolution"));
}

#[test]
fn too_many_voxels_or_entries_are_refused() {
    let views = [ball(0.0), ball(FRAC_PI_2)];
    let params = DensityParams { resolution: 16, ..DensityParams::default() };
    let with = |voxels| Control::default().with_limits(Limits { voxels, ..Limits::default() });
    let error = carve(&views, &params, &with(1000)).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
    let carved = carve(&views, &params, &with(10_000)).unwrap();
    let error = Equations::new(&carved, &views, &params, &with(3000)).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
}

#[test]
fn one_opaque_pixel_is_a_tree_with_a_warning() {
    let views = [view(0.0, 1, 6.0, |_, _| 1.0)];
    let (params, control) = (DensityParams::default(), Control::default());
    let carved = carve(&views, &params, &control).unwrap();
    let (grid, report) = solve(&carved, &views, &params, &control).unwrap();
    assert!(crown_volume(&grid, 0.0) > 0.0);
    assert!(report.warnings.contains(&DensityWarning::Opaque { view: 0 }), "{report:?}");
}

#[test]
fn one_thread_and_two_give_the_same_bits() {
    let views = [noisy(0.0, 8), ball(FRAC_PI_2)];
    let params = DensityParams { resolution: 24, ..DensityParams::default() };
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let control = Control::default();
            let carved = carve(&views, &params, &control).unwrap();
            solve(&carved, &views, &params, &control).unwrap()
        })
    };
    assert_eq!(run(1), run(2));
}

#[test]
fn overlap_counts_what_lies_outside_the_other_grid() {
    let limits = Limits::default();
    let full = |corner, n| {
        let mut grid = Grid::new(corner, 1.0, UVec3::splat(n), &limits).unwrap();
        grid.values_mut().fill(1.0);
        grid
    };
    let (small, large) = (full(Vec3::ZERO, 1), full(Vec3::ZERO, 2));
    assert_eq!(overlap(&small, 0.5, &large, 0.5), 1.0 / 8.0);
    assert_eq!(overlap(&large, 0.5, &small, 0.5), 1.0 / 8.0);
    assert_eq!(overlap(&large, 2.0, &small, 2.0), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_cameras_give_densities_or_a_typed_error(
        yaws in prop::collection::vec(-7.0_f32..7.0, 1..4),
        pitch in -1.5_f32..1.5,
        fov in 0.02_f32..2.8,
        base in -40.0_f32..60.0,
        rounding in 0.0_f32..1.0,
    ) {
        let views: Vec<View> = yaws.iter().enumerate().map(|(i, &yaw)| {
            let mut view = noisy(yaw, i as u64);
            view.camera.pitch = pitch;
            view.camera.base.y = base;
            if i % 2 == 1 {
                view.camera.projection = Projection::Perspective { fov };
            }
            view
        }).collect();
        let params = DensityParams { resolution: 6, rounding, ..DensityParams::default() };
        let control = Control::default();
        match carve(&views, &params, &control) {
            Ok(carved) => {
                let (grid, report) = solve(&carved, &views, &params, &control).unwrap();
                prop_assert!(grid.values().iter().all(|x| x.is_finite() && *x >= 0.0));
                prop_assert!(report.residual.is_finite());
            }
            Err(error) => prop_assert!(matches!(error, ModelError::View { .. }), "{error}"),
        }
    }
}
