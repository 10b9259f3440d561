//! Half an outline in a few points to the whole blade as a polygon.
//!
//! 1. A cubic (Hermite) curve through the points; a point's tangent is parallel to the line between
//!    its neighbours and as long as the piece, times one minus the point's sharpness.
//! 2. Teeth push the curve out along its normal and towards the apex.
//! 3. The half is mirrored.

use super::leaf::{LeafShape, Teeth};
use super::noise::smoothstep;
use tree_core::glam::Vec2;

/// Curve samples per pair of points of the outline.
const STEPS: usize = 10;
/// Samples per tooth, enough for a small tooth on a large one.
const STEPS_PER_TOOTH: usize = 9;

/// The blade as a closed polygon: petiole at the origin, apex at (0, 1).
pub(super) fn polygon(shape: &LeafShape) -> Vec<Vec2> {
    let half = serrate(&curve(&shape.outline), &shape.teeth);
    let mut all = half.clone();
    let mirrored = half.iter().rev().skip(1).map(|p| Vec2::new(-p.x, p.y));
    all.extend(mirrored.filter(|p| p.x < 0.0));
    all
}

fn curve(points: &[[f32; 3]]) -> Vec<Vec2> {
    let at = |i: usize| points.get(i).map(|p| Vec2::new(p[0], p[1]));
    let mirror = |p: Option<Vec2>| p.map(|p| Vec2::new(-p.x, p.y));
    // Beyond the ends the outline goes on in the mirror, so that a smooth end is round.
    let direction = |i: usize| {
        let before = if i == 0 { mirror(at(1)) } else { at(i - 1) };
        let after = at(i + 1).or_else(|| mirror(at(i.saturating_sub(1))));
        let sharp = points.get(i).map_or(1.0, |p| p[2]);
        match (before, after) {
            (Some(a), Some(b)) => (b - a).normalize_or_zero() * (1.0 - sharp),
            _ => Vec2::ZERO,
        }
    };
    let mut out = Vec::with_capacity(points.len() * STEPS + 1);
    for i in 0..points.len() {
        let (Some(a), Some(b)) = (at(i), at(i + 1)) else {
            out.extend(at(i));
            continue;
        };
        let length = a.distance(b);
        let (ta, tb) = (direction(i) * length, direction(i + 1) * length);
        for step in 0..STEPS {
            let t = step as f32 / STEPS as f32;
            let (t2, t3) = (t * t, t * t * t);
            let p = a * (2.0 * t3 - 3.0 * t2 + 1.0)
                + ta * (t3 - 2.0 * t2 + t)
                + b * (3.0 * t2 - 2.0 * t3)
                + tb * (t3 - t2);
            out.push(Vec2::new(p.x.max(0.0), p.y));
        }
    }
    out
}

/// The curve sampled evenly by length and pushed out into teeth.
fn serrate(curve: &[Vec2], teeth: &Teeth) -> Vec<Vec2> {
    if teeth.count == 0 || teeth.depth <= 0.0 {
        return curve.to_vec();
    }
    let length: f32 = curve.windows(2).map(|w| w[0].distance(w[1])).sum();
    let n = teeth.count as usize * STEPS_PER_TOOTH;
    let mut out = Vec::with_capacity(n + 2);
    let mut walked = 0.0;
    let mut next = 0;
    for w in curve.windows(2) {
        let piece = w[0].distance(w[1]);
        let along = (w[1] - w[0]).normalize_or_zero();
        let outward = Vec2::new(along.y, -along.x);
        while next < n && next as f32 * length <= (walked + piece) * n as f32 && piece > 0.0 {
            let s = next as f32 / n as f32;
            let p = w[0].lerp(w[1], ((s * length - walked) / piece).clamp(0.0, 1.0));
            let push = tooth(s * teeth.count as f32, teeth) * teeth.depth;
            let fade = smoothstep(0.0, 0.12, s) * smoothstep(1.0, 0.9, s);
            out.push(p + (outward + along * teeth.sharpness) * (push * fade));
            next += 1;
        }
        walked += piece;
    }
    out.extend(curve.last());
    out.into_iter().map(|p| Vec2::new(p.x.max(0.0), p.y)).collect()
}

/// Height of the teeth, 0 to 1: a round wave when blunt, a saw that leans to the apex when sharp.
fn tooth(s: f32, teeth: &Teeth) -> f32 {
    let one = |s: f32| {
        let t = s - s as u32 as f32;
        let wave = 4.0 * t * (1.0 - t);
        let saw = if t < SAW_TOP { t / SAW_TOP } else { (1.0 - t) / (1.0 - SAW_TOP) };
        wave + (saw - wave) * teeth.sharpness
    };
    one(s) + if teeth.double { 0.35 * one(3.0 * s) } else { 0.0 }
}

/// Where a sharp tooth has its point, as share of its length.
const SAW_TOP: f32 = 0.78;
