//! Bumps on constructed outlines.

use super::*;
use crate::plane::fill::{Fill, FillRule, Frame};
use libm::{cosf, sinf};
use std::f32::consts::{PI, TAU};
use tree_core::Seed;

/// A closed curve in polar coordinates, by `n` points.
fn polar(n: usize, radius: impl Fn(f32) -> f32) -> Vec<Vec2> {
    let angle = |i: usize| TAU * i as f32 / n as f32;
    (0..n).map(|i| radius(angle(i)) * Vec2::new(cosf(angle(i)), sinf(angle(i)))).collect()
}

fn outline(points: Vec<Vec2>) -> Outline {
    Outline::of_simple(points)
}

fn count(points: &[Vec2]) -> usize {
    bumps(&outline(points.to_vec()), &BumpParams::default()).len()
}

/// Lobes: a curve whose radius waves.
fn rose(lobes: usize, height: f32) -> Vec<Vec2> {
    polar(720, |a| 1.0 + height * cosf(lobes as f32 * a))
}

/// Discs on a ring and one in the middle that fills it.
fn discs(lobes: usize, radius: f32) -> Vec<Vec2> {
    let middle = |i: usize| {
        let angle = TAU * i as f32 / lobes as f32;
        (Vec2::new(cosf(angle), sinf(angle)), radius)
    };
    let all: Vec<(Vec2, f32)> = (0..lobes).map(middle).chain([(Vec2::ZERO, 1.0)]).collect();
    polar(720, |angle| {
        let way = Vec2::new(cosf(angle), sinf(angle));
        let reach = |&(middle, radius): &(Vec2, f32)| {
            let (along, off) = (middle.dot(way), middle.perp_dot(way));
            let left = radius * radius - off * off;
            if left > 0.0 { along + left.sqrt() } else { 0.0 }
        };
        all.iter().map(reach).fold(0.0, f32::max)
    })
}

/// A star of straight sides.
fn star(spikes: usize, inner: f32) -> Vec<Vec2> {
    let corner = |i: usize| {
        let angle = PI * i as f32 / spikes as f32;
        let radius = if i.is_multiple_of(2) { 1.0 } else { inner };
        radius * Vec2::new(cosf(angle), sinf(angle))
    };
    (0..2 * spikes).map(corner).collect()
}

/// Steps on both sides, and a top: `2 · tiers + 1` bumps.
fn conifer(tiers: usize) -> Vec<Vec2> {
    let mut right = vec![];
    for tier in 0..tiers {
        let share = |t: f32| 1.0 - t / (tiers as f32 + 1.0);
        let low = tier as f32 / tiers as f32 * 2.4;
        right.push(Vec2::new(0.9 * share(tier as f32), low));
        let next = if tier + 1 == tiers { 0.0 } else { 0.5 * share(tier as f32 + 1.0) };
        right.push(Vec2::new(next, low + 2.4 / tiers as f32 + 0.1));
    }
    let left: Vec<Vec2> = right.iter().rev().skip(1).map(|p| Vec2::new(-p.x, p.y)).collect();
    right.into_iter().chain(left).collect()
}

/// One lobe: round with one sharp end.
fn drop() -> Vec<Vec2> {
    polar(400, |_| 1.0)
        .into_iter()
        .map(|p| {
            let t = (p.y + 1.0) * 0.5;
            Vec2::new(
                p.x * (1.0 - t * t * t * 0.8).max(0.05),
                if p.y > 0.0 { 2.2 * p.y } else { p.y },
            )
        })
        .collect()
}

/// The same outline by `n` points, turned, with each point moved by up to `noise` of the size; where that makes it cross
/// itself the largest part inside.
fn drawn(points: &[Vec2], n: usize, turn: f32, noise: f32, calm: usize, seed: u64) -> Vec<Vec2> {
    let shape = outline(points.to_vec());
    let (low, high) = shape.bounds();
    let size = (high - low).max_element();
    let closed: Vec<Vec2> = points.iter().copied().chain([points[0]]).collect();
    let line = crate::silhouette::Line::new(closed).unwrap();
    let seed = Seed(seed).stream("bumps.tests");
    let mut moves: Vec<Vec2> = (0..n)
        .map(|i| {
            let seed = seed.child(i as u64);
            let part = |name: &str| 2.0 * seed.stream(name).unit(0) - 1.0;
            noise * size * Vec2::new(part("x"), part("y"))
        })
        .collect();
    for _ in 0..calm {
        let before = moves.clone();
        for (i, step) in moves.iter_mut().enumerate() {
            *step = 0.5 * *step + 0.25 * (before[(i + n - 1) % n] + before[(i + 1) % n]);
        }
    }
    let most = moves.iter().map(|m| m.abs().max_element()).fold(1e-9, f32::max);
    let scale = if calm > 0 { noise * size / most } else { 1.0 };
    let way = Vec2::new(cosf(turn), sinf(turn));
    let moved: Vec<Vec2> =
        (0..n).map(|i| way.rotate(line.at(i as f32 / n as f32) + scale * moves[i])).collect();
    simple(moved)
}

/// The outer border of the largest part.
fn simple(points: Vec<Vec2>) -> Vec<Vec2> {
    let (frame, contours) = Frame::of(&[points]).unwrap();
    let border = Fill::of(&contours, FillRule::NonZero).unwrap().border();
    let area = |c: &Vec<glam::DVec2>| crate::plane::fill::area(c);
    let best = border.into_iter().max_by(|a, b| area(a).total_cmp(&area(b))).unwrap();
    best.into_iter().map(|p| frame.to_drawing(p)).collect()
}

fn families() -> Vec<(String, Vec<Vec2>, usize)> {
    let mut all = vec![("drop".to_owned(), drop(), 1), ("egg".to_owned(), rose(1, 0.25), 1)];
    all.push(("circle".to_owned(), rose(5, 0.0), 1));
    for n in 2..=12 {
        for height in [0.15, 0.2, 0.3] {
            let low = [0.0, 0.0, 0.3, 0.25, 0.2, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15];
            if height >= low[n] {
                all.push((format!("rose {n} {height}"), rose(n, height), n));
            }
        }
        for (k, share) in [(0, 0.6), (1, 0.9)] {
            let radius = (share * sinf(PI / n as f32)).min(0.8 - 0.2 * k as f32);
            all.push((format!("discs {n} {radius}"), discs(n, radius), n));
        }
        if n > 2 {
            all.push((format!("star {n}"), star(n, if n < 5 { 0.3 } else { 0.55 }), n));
            let sharp = outline(star(n, if n < 5 { 0.3 } else { 0.55 }));
            let rounded = drawn(sharp.points(), 300, 0.0, 0.0, 0, 0);
            let round =
                |i: usize| (0..13).map(|k| rounded[(i + k) % rounded.len()]).sum::<Vec2>() / 13.0;
            let points = (0..rounded.len()).map(round).collect();
            all.push((format!("round star {n}"), points, n));
        }
    }
    for tiers in 1..=5 {
        all.push((format!("conifer {tiers}"), conifer(tiers), 2 * tiers + 1));
    }
    all
}

/// `evaluate -- silhouette` prints the shares, of more points and turns too; fewer than these 99 of 100 would be a step back.
#[test]
fn outlines_of_lobes_have_as_many_bumps_however_they_are_drawn() {
    let (mut hits, mut all) = (0, 0);
    for (_, points, expected) in families() {
        for n in [60, 120, 250, 500] {
            let moved = [(0.0, 0), (0.005, 0), (0.01, 0), (0.005, 20), (0.01, 20), (0.01, 3)];
            for (turn, (noise, calm)) in (0..).zip(moved) {
                let line = drawn(&points, n, 0.7 * turn as f32, noise, calm, turn);
                hits += u32::from(count(&line) == expected);
                all += 1;
            }
        }
    }
    assert!(100 * hits >= 99 * all, "{hits} of {all}");
}
