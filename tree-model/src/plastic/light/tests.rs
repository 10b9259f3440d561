use super::veil::influence;
use super::*;
use crate::plastic::shade::{Casters, veil_solids};
use glam::Quat;
use tree_core::Seed;
use tree_core::seed::{in_unit_ball, uniform};

/// Eq. 3 by rays, spread evenly over the hemisphere.
fn by_rays(at: Vec3, balls: &[Ball], solids: &[Convex], brightest: Vec3) -> (f32, Vec3) {
    let n = 20_000;
    let (mut open, mut seen, mut towards) = (0.0_f64, 0.0_f64, glam::DVec3::ZERO);
    for k in 0..n {
        let y = (k as f32 + 0.5) / n as f32;
        let flat = (1.0 - y * y).sqrt();
        let turn = 2.399_963 * k as f32;
        let way = Vec3::new(flat * libm::cosf(turn), y, flat * libm::sinf(turn));
        let bright = f64::from(way.dot(brightest).max(0.0));
        let bright = bright * bright;
        let mut through = 1.0_f64;
        for ball in balls {
            let offset = ball.center - at;
            let along = offset.dot(way);
            let gap = offset.length_squared() - along * along;
            if along > 0.0 && gap < ball.radius * ball.radius {
                through *= f64::from(ball.translucency);
            }
        }
        if solids.iter().any(|solid| solid.meets(at, at + way * 1000.0)) {
            through = 0.0;
        }
        open += bright;
        seen += bright * through;
        towards += (way.as_dvec3()) * bright * through;
    }
    ((seen / open) as f32, towards.as_vec3().normalize_or_zero())
}

fn ours(at: Vec3, balls: &[Ball], solids: &[Convex], brightest: Vec3) -> Light {
    let bins = Bins::new(brightest, Vec3::Y, 1.0);
    let mut casters = Casters::default();
    casters.push(&Ball { center: at, radius: 0.5, translucency: 0.5 });
    balls.iter().for_each(|ball| casters.push(ball));
    let mut through = casters.through(at, 0, &bins);
    veil_solids(solids, at, &bins, &mut through);
    Light::gather(&bins, &through)
}

fn crown(seed: u64, n: usize) -> Vec<Ball> {
    let mut rng = Seed(seed).rng();
    (0..n)
        .map(|_| {
            let radius = uniform(&mut rng, 0.3, 1.2);
            let way = in_unit_ball(&mut rng) * 4.0;
            // Not around the point itself: Eq. 3 says nothing of the inside.
            let center = way.normalize_or(Vec3::Y) * (way.length() + radius + 0.1);
            let translucency = libm::powf(0.5, radius);
            Ball { center, radius, translucency }
        })
        .collect()
}

fn check(balls: &[Ball], solids: &[Convex], brightest: Vec3, case: &str) {
    let light = ours(Vec3::ZERO, balls, solids, brightest);
    let (amount, towards) = by_rays(Vec3::ZERO, balls, solids, brightest);
    assert!(
        (light.amount - amount).abs() < 0.02,
        "{case}: {} of the sky, by rays {amount}",
        light.amount
    );
    if amount > 0.05 {
        let angle = light.direction.dot(towards);
        assert!(angle > 0.99, "{case}: from {}, by rays {towards}", light.direction);
    }
}

#[test]
fn the_open_sky_gives_all_light_from_above() {
    let light = ours(Vec3::ZERO, &[], &[], Vec3::Y);
    assert!((light.amount - 1.0).abs() < 1e-3 && light.direction.y > 0.999, "{light:?}");
}

#[test]
fn crowns_let_through_what_rays_find() {
    for seed in 0..12 {
        check(&crown(seed, 30), &[], Vec3::Y, &format!("crown {seed}"));
    }
}

#[test]
fn a_low_sun_is_shaded_as_rays_find() {
    let low = Vec3::new(0.8, 0.6, 0.0);
    for seed in 0..8 {
        check(&crown(seed, 20), &[], low, &format!("crown {seed}"));
    }
}

#[test]
fn walls_cut_off_what_rays_find() {
    for k in 0..24 {
        let turn = Quat::from_rotation_y(0.3 * k as f32) * Quat::from_rotation_x(0.1 * k as f32);
        let wall = Convex::Block(Block {
            center: turn * Vec3::new(0.0, 0.3, 2.0 + 0.1 * k as f32) + Vec3::Y,
            half: Vec3::new(2.5, 1.5 + 0.1 * k as f32, 0.1),
            rotation: turn,
        });
        check(&[], &[wall], Vec3::Y, &format!("wall {k}"));
    }
}

#[test]
fn half_spaces_cut_off_what_rays_find() {
    for k in 0..16 {
        let normal = Quat::from_rotation_z(0.2 * k as f32) * Vec3::Y;
        let plane = Convex::Plane(Plane { point: -normal * 3.0, normal });
        check(&[], &[plane], Vec3::Y, &format!("plane {k}"));
    }
}

#[test]
fn inside_a_solid_it_is_dark() {
    let block = Block { center: Vec3::ZERO, half: Vec3::ONE, rotation: Quat::IDENTITY };
    assert_eq!(ours(Vec3::ZERO, &[], &[Convex::Block(block)], Vec3::Y), Light::default());
}

#[test]
fn nothing_jumps_where_a_point_enters_a_cluster() {
    let ball = |y: f32| Ball { center: Vec3::Y * y, radius: 1.0, translucency: 0.3 };
    let mut last = ours(Vec3::ZERO, &[ball(1.5)], &[], Vec3::Y).amount;
    for k in 1..=150 {
        let now = ours(Vec3::ZERO, &[ball(1.5 - 0.01 * k as f32)], &[], Vec3::Y).amount;
        assert!((now - last).abs() < 0.04, "at {k}: {last} to {now}");
        last = now;
    }
}

#[test]
fn what_is_said_to_matter_little_does() {
    let bins = Bins::new(Vec3::Y, Vec3::Y, 1.0);
    for ball in crown(5, 200) {
        let kept = 1.0 - ours(Vec3::ZERO, &[ball], &[], Vec3::Y).amount;
        let most = influence(&ball, ball.center, &bins);
        assert!(kept <= most + 0.02, "{ball:?} keeps {kept}, said to keep {most} at most");
    }
}
