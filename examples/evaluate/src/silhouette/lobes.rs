//! Outlines whose bumps are known: roses, discs on a ring, stars, conifers and drops.

use libm::{cosf, sinf};
use std::f32::consts::{PI, TAU};
use tree_model::silhouette::{Line, Outline, OutlineParams};
use tree_model::tree_core::Seed;
use tree_model::tree_core::glam::Vec2;

/// An outline and how many bumps it has.
pub(super) struct Lobed {
    pub(super) name: String,
    pub(super) points: Vec<Vec2>,
    pub(super) bumps: usize,
}

/// The unsteadiness of a hand.
#[derive(Clone, Copy)]
pub(super) struct Noise {
    /// How far points move at most, as a share of the outline's size.
    pub(super) size: f32,
    /// How often the moves are averaged along the outline: 0 is jitter of every point by itself.
    pub(super) calm: u32,
}

/// All outlines.
pub(super) fn families() -> Vec<Lobed> {
    /// From so many lobes on, waves of this height are told from an oval or a smooth form.
    const LOW: [f32; 6] = [0.0, 0.0, 0.3, 0.25, 0.2, 0.15];
    let lobed = |name: String, points, bumps| Lobed { name, points, bumps };
    let mut all = vec![
        lobed("egg".into(), rose(1, 0.25), 1),
        lobed("circle".into(), rose(5, 0.0), 1),
        lobed("drop".into(), drop(), 1),
    ];
    for n in 2..=12 {
        let least = LOW.get(n).copied().unwrap_or(0.15);
        let heights = [0.15, 0.2, 0.3].into_iter().filter(|&height| height >= least);
        all.extend(heights.map(|h| lobed(format!("rose of {n}, {h}"), rose(n, h), n)));
        let radius = |share: f32, most: f32| (share * sinf(PI / n as f32)).min(most);
        let discs = |r| lobed(format!("discs of {n}, {r:.2}"), discs(n, r), n);
        all.extend([radius(0.6, 0.8), radius(0.9, 0.6)].map(discs));
        if n > 2 {
            all.push(lobed(format!("star of {n}"), star(n), n));
        }
    }
    all.extend((1..=5).map(|n| lobed(format!("conifer of {n}"), conifer(n), 2 * n + 1)));
    all
}

/// A closed curve in polar coordinates.
fn polar(radius: impl Fn(f32) -> f32) -> Vec<Vec2> {
    /// Points round.
    const POINTS: usize = 720;
    let angle = |i: usize| TAU * i as f32 / POINTS as f32;
    (0..POINTS).map(|i| radius(angle(i)) * towards(angle(i))).collect()
}

fn towards(angle: f32) -> Vec2 {
    Vec2::new(cosf(angle), sinf(angle))
}

/// A curve whose radius waves.
pub(super) fn rose(lobes: usize, height: f32) -> Vec<Vec2> {
    polar(|a| 1.0 + height * cosf(lobes as f32 * a))
}

/// Discs on a ring, and one in the middle that fills it.
fn discs(lobes: usize, radius: f32) -> Vec<Vec2> {
    let on_ring = |i: usize| (towards(TAU * i as f32 / lobes as f32), radius);
    let all: Vec<(Vec2, f32)> = (0..lobes).map(on_ring).chain([(Vec2::ZERO, 1.0)]).collect();
    polar(|angle| {
        let way = towards(angle);
        let reach = |&(middle, radius): &(Vec2, f32)| {
            let left = radius * radius - middle.perp_dot(way) * middle.perp_dot(way);
            if left > 0.0 { middle.dot(way) + left.sqrt() } else { 0.0 }
        };
        all.iter().map(reach).fold(0.0, f32::max)
    })
}

/// A star of straight sides.
fn star(spikes: usize) -> Vec<Vec2> {
    let inner = if spikes < 5 { 0.3 } else { 0.55 };
    let radius = |i: usize| if i.is_multiple_of(2) { 1.0 } else { inner };
    (0..2 * spikes).map(|i| radius(i) * towards(PI * i as f32 / spikes as f32)).collect()
}

/// Steps on both sides, and a top.
fn conifer(tiers: usize) -> Vec<Vec2> {
    let n = tiers as f32;
    let share = |t: usize| 1.0 - t as f32 / (n + 1.0);
    let mut right = Vec::new();
    for tier in 0..tiers {
        let low = 2.4 * tier as f32 / n;
        let inner = if tier + 1 == tiers { 0.0 } else { 0.5 * share(tier + 1) };
        right.extend([Vec2::new(0.9 * share(tier), low), Vec2::new(inner, low + 2.4 / n + 0.1)]);
    }
    let left: Vec<Vec2> = right.iter().rev().skip(1).map(|p| Vec2::new(-p.x, p.y)).collect();
    right.into_iter().chain(left).collect()
}

/// Round, with one sharp end.
fn drop() -> Vec<Vec2> {
    let pull = |p: Vec2| {
        let t = 0.5 * (p.y + 1.0);
        let x = p.x * (1.0 - 0.8 * t * t * t).max(0.05);
        Vec2::new(x, if p.y > 0.0 { 2.2 * p.y } else { p.y })
    };
    polar(|_| 1.0).into_iter().map(pull).collect()
}

impl Lobed {
    /// The outline as somebody draws it: by `n` points, turned, unsteady. Where that makes it cross itself, as closing
    /// repairs it.
    pub(super) fn drawn(&self, n: usize, turn: f32, noise: Noise, seed: Seed) -> Option<Outline> {
        let closed = self.points.iter().chain(self.points.first()).copied().collect();
        let line = Line::new(closed)?;
        let all = || self.points.iter().copied();
        let extent =
            all().fold(Vec2::NEG_INFINITY, Vec2::max) - all().fold(Vec2::INFINITY, Vec2::min);
        let moves = moves(n, noise, extent.max_element(), seed);
        let at = |i: usize| towards(turn).rotate(line.at(i as f32 / n as f32) + moves[i]);
        let stroke: Vec<Vec2> = (0..n).map(at).collect();
        Some(Outline::close(&stroke, "lobes", &OutlineParams::default()).ok()?.0)
    }
}

/// How far each point moves.
fn moves(n: usize, noise: Noise, extent: f32, seed: Seed) -> Vec<Vec2> {
    let either = |name: &str, i: usize| 2.0 * seed.stream(name).unit(i as u64) - 1.0;
    let mut moves: Vec<Vec2> = (0..n).map(|i| Vec2::new(either("x", i), either("y", i))).collect();
    for _ in 0..noise.calm {
        let before = moves.clone();
        for (i, step) in moves.iter_mut().enumerate() {
            *step = 0.5 * *step + 0.25 * (before[(i + n - 1) % n] + before[(i + 1) % n]);
        }
    }
    // However calm, the largest is as great as asked for.
    let most = moves.iter().map(|step| step.abs().max_element()).fold(1e-9, f32::max);
    let scale = noise.size * extent / if noise.calm > 0 { most } else { 1.0 };
    moves.into_iter().map(|step| scale * step).collect()
}
