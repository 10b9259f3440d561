//! Skeletons made to measure: tame ones as a careful modeler makes them, and nasty ones.
//!
//! Also compiled into `examples/evaluate`. Each is made of a [`Seed`] or of counts alone.
#![allow(dead_code, reason = "each user takes what it needs")]

use std::f64::consts::PI;
use tree_core::glam::{Quat, Vec3};
use tree_core::seed::{in_unit_ball, uniform, unit_vector};
use tree_core::{Continuation, Rng, Seed, Skeleton, SkeletonBuilder};

/// Adds a node; a skeleton that cannot take it stays as it is.
fn add(builder: &mut SkeletonBuilder, parent: u32, at: Vec3, radius: f32) -> u32 {
    builder.add(parent, at, radius).unwrap_or(parent)
}

fn start(radius: f32) -> SkeletonBuilder {
    // Zero and a radius within bounds are always valid.
    match Skeleton::builder(Vec3::ZERO, radius) {
        Ok(builder) => builder,
        Err(error) => unreachable!("{error}"),
    }
}

/// A trunk of `n` segments with a lateral at every second node, alternating: no junction is near
/// another one.
pub(crate) fn ladder(n: u32) -> Skeleton {
    let mut builder = start(0.1);
    let mut node = 0;
    for i in 1..=n {
        let share = i as f32 / (n + 1) as f32;
        let radius = 0.1 * (1.0 - 0.8 * share);
        let at = Vec3::new(0.02 * (i % 3) as f32, 0.4 * i as f32, 0.0);
        node = add(&mut builder, node, at, radius);
        if i % 2 == 0 && i < n {
            let turn = Quat::from_rotation_y(2.4 * i as f32);
            let mut lateral = node;
            for k in 1..=4 {
                let k = k as f32;
                let out = turn * Vec3::new(0.3 * k, 0.12 * k + 0.01 * k * k, 0.0);
                lateral = add(&mut builder, lateral, at + out, 0.4 * radius * (1.1 - 0.2 * k));
            }
        }
    }
    builder.finish()
}

/// A trunk with `n` whorls of `per_whorl` boughs; each bough bears `n_twigs` twigs, left and right.
pub(crate) fn whorls(n: u32, per_whorl: u32, n_twigs: u32) -> Skeleton {
    let height = 0.35 * (n + 1) as f32;
    let mut builder = start(0.012 * height);
    let mut trunk = 0;
    for whorl in 1..=n {
        let share = whorl as f32 / (n + 1) as f32;
        let radius = 0.012 * height * (1.0 - 0.95 * share);
        let at = Vec3::Y * (0.35 * whorl as f32);
        trunk = add(&mut builder, trunk, at, radius);
        for bough in 0..per_whorl {
            let angle =
                std::f32::consts::TAU * bough as f32 / per_whorl as f32 + 2.4 * whorl as f32;
            let turn = Quat::from_rotation_y(angle);
            let reach = 0.3 * height * (1.0 - share) + 0.15;
            let mut node = trunk;
            for k in 1..=n_twigs + 1 {
                let s = k as f32 / (n_twigs + 1) as f32;
                let out = at + turn * Vec3::new(reach * s, 0.1 * reach * s * s, 0.0);
                let thin = (0.35 * radius * (1.1 - s)).max(0.002);
                node = add(&mut builder, node, out, thin);
                if k <= n_twigs {
                    let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                    let length = 0.35 * reach * (1.1 - s);
                    let tip = out + turn * Vec3::new(0.7, 0.1, side) * length;
                    let middle = 0.5 * (out + tip) + 0.03 * length * Vec3::Y;
                    let twig = add(&mut builder, node, middle, 0.6 * thin);
                    add(&mut builder, twig, tip, 0.4 * thin);
                }
            }
        }
    }
    builder.finish()
}

/// A dense conifer: whorls of many boughs with many twigs, radii of twigs near those of boughs.
pub(crate) fn pine(n: u32) -> Skeleton {
    whorls(n, 9, 14)
}

/// A crooked trunk with laterals of laterals: thinner than a half of what bears them, at 35 to 75
/// degrees, with segments longer than three radii and no two at one node.
pub(crate) fn tame(seed: Seed) -> Skeleton {
    let mut rng = seed.stream("tame").rng();
    let scale = libm::powf(10.0, uniform(&mut rng, -0.5, 0.5));
    let radius = scale * uniform(&mut rng, 0.05, 0.12);
    let mut builder = start(radius);
    let levels = 1 + (uniform(&mut rng, 0.0, 3.0) as u32);
    shoot(&mut builder, 0, Vec3::ZERO, Vec3::Y, radius, levels, &mut rng);
    builder.finish()
}

fn shoot(
    builder: &mut SkeletonBuilder,
    base: u32,
    foot: Vec3,
    direction: Vec3,
    radius: f32,
    levels: u32,
    rng: &mut Rng,
) {
    let n = 3 + uniform(rng, 0.0, 4.0) as u32;
    let (mut node, mut at, mut direction) = (base, foot, direction);
    for i in 1..=n {
        let thin = radius * (1.0 - 0.6 * i as f32 / n as f32);
        direction = (direction + 0.15 * in_unit_ball(rng)).normalize_or(Vec3::Y);
        at += direction * (radius * uniform(rng, 8.0, 12.0));
        node = add(builder, node, at, thin);
        if levels > 1 && i < n && uniform(rng, 0.0, 1.0) < 0.6 {
            let across = direction.cross(unit_vector(rng)).normalize_or(Vec3::X);
            let angle = uniform(rng, 0.6, 1.3);
            let away = direction * libm::cosf(angle) + across * libm::sinf(angle);
            let own = thin * uniform(rng, 0.25, 0.5);
            // A first node well outside of the parent's wood.
            let first = at + away * (thin + 6.0 * own);
            let lateral = add(builder, node, first, own);
            shoot(builder, lateral, first, away, own, levels - 1, rng);
        }
    }
}

/// Anything that is valid: up to 40 nodes, and one of the ways in which imported skeletons are ugly in
/// most of them.
pub(crate) fn nasty(seed: Seed) -> Skeleton {
    let mut rng = seed.stream("nasty").rng();
    let n = 1 + uniform(&mut rng, 1.0, 40.0) as u32;
    // From millimetres to kilometres.
    let scale = libm::powf(10.0, uniform(&mut rng, -2.5, 2.5));
    let thick = libm::powf(10.0, uniform(&mut rng, -3.0, 0.5));
    let bushy = uniform(&mut rng, 0.0, 1.0);
    let mut nodes = vec![(Vec3::ZERO, scale * thick, Vec3::Y)];
    let mut builder = start(scale * thick);
    while (nodes.len() as u32) < n {
        let last = nodes.len() as u32 - 1;
        let any = uniform(&mut rng, 0.0, 1.0) < bushy;
        let parent = if any { (uniform(&mut rng, 0.0, 1.0) * last as f32) as u32 } else { last };
        let (at, radius, direction) = nodes[parent as usize];
        let ahead = (direction + 0.5 * in_unit_ball(&mut rng)).normalize_or(Vec3::Y);
        let usual = at + ahead * scale * uniform(&mut rng, 0.05, 1.0);
        let thinner = radius * uniform(&mut rng, 0.3, 1.0);
        let mut children = vec![(usual, thinner)];
        match uniform(&mut rng, 0.0, 12.0) as u32 {
            // No length; very little length; coincident twins.
            0 => children = vec![(at, radius)],
            1 => children = vec![(at + ahead * radius * 1e-3, radius)],
            2 => children = vec![(usual, thinner); 2],
            // Thicker than long; thicker towards the tip.
            3 => children = vec![(at + ahead * 0.2 * radius, 1.5 * radius)],
            4 => children = vec![(usual, radius * uniform(&mut rng, 1.0, 2.5))],
            // Ten children on one node.
            5 => {
                let around = |_| (at + unit_vector(&mut rng) * scale * 0.5, 0.7 * radius);
                children = (0..10).map(around).collect();
            }
            // Near parallel; back on the same way; down.
            6 => children = vec![(usual, thinner), (usual + 1e-3 * scale * Vec3::X, thinner)],
            7 => children = vec![(at - direction * scale * 0.7, thinner)],
            8 => children = vec![(at - Vec3::Y * scale * 0.4, thinner)],
            // A thread; a radius of zero.
            9 => children = vec![(usual, radius * 1e-3)],
            10 => children = vec![(usual, 0.0)],
            _ => {}
        }
        for (to, radius) in children {
            add(&mut builder, parent, to, radius);
            nodes.push((to, radius, (to - at).normalize_or(direction)));
        }
    }
    builder.finish()
}

/// Volume in m³ of a frustum for each segment. A lateral starts on the line of its parent axis, as thick
/// as it is at its own first node; what lies within the parent's cylinder there is left out, so wood
/// at junctions counts once. Radii under `min_radius` are raised to it.
///
/// Honest for tame skeletons: the saddle where a lateral leaves its parent is taken for a flat cut at
/// the distance at which its middle line leaves the wood, and bends count as sharp.
pub(crate) fn frusta_volume(skeleton: &Skeleton, min_radius: f32) -> f64 {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let radius = |node: u32| f64::from(radii[node as usize].max(min_radius));
    let mut sum = 0.0;
    for axis in skeleton.axes(Continuation::Thickest).iter() {
        let Some(&first) = axis.nodes.first() else { continue };
        if let Some(fork) = skeleton.parent(first) {
            let arm = (positions[first as usize] - positions[fork as usize]).as_dvec3();
            // The parent axis goes on from the fork as it came, give or take a bend.
            let below = skeleton.parent(fork).unwrap_or(fork);
            let along = (positions[fork as usize] - positions[below as usize]).as_dvec3();
            let sine = arm.normalize_or_zero().cross(along.normalize_or_zero()).length();
            let inside = radius(fork) / sine.max(0.1);
            let r = radius(first);
            sum += PI * (arm.length() - inside).max(0.0) * r * r;
        }
        for pair in axis.nodes.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let length = f64::from(positions[a as usize].distance(positions[b as usize]));
            let (ra, rb) = (radius(a), radius(b));
            sum += PI / 3.0 * length * (ra * ra + ra * rb + rb * rb);
        }
    }
    sum
}
