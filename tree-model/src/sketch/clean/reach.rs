//! Wood that ends below a crown, or just inside it, is drawn on: who draws a stem and a cloud on it means that the stem
//! bears the cloud.

use super::join::Nodes;
use super::report::{CleanReport, RepairKind};
use super::tidy::{Extent, Ink};
use glam::Vec2;

/// Wood that reaches this share of the way up through the crown bears it.
const REACHED: f32 = 0.4;

/// What is drawn on ends at this share of the crown's height in its middle, ...
const TOP: f32 = 0.7;

/// ... and lower by this share beside it.
const LOWER: f32 = 0.2;

/// Tips are spread over this share of the crown's width to either side of its middle, ...
const SPREAD: f32 = 0.22;

/// ... and by at most so many times their own distance.
const MOST_SPREAD: f32 = 3.0;

/// Tips that are higher than this share of the wood are drawn on, ...
const UPPER: f32 = 0.6;

/// ... at most so many, ...
const MOST_TIPS: usize = 5;

/// ... and at least this share of the crown's width apart.
const APART: f32 = 0.12;

/// For this share of the way a tip keeps its direction.
const ONWARD: f32 = 0.4;

/// Draws tips on into the crown where no wood reaches far into it.
pub(super) fn draw_on(
    nodes: &mut Nodes,
    crowns: &[Ink],
    [unit, spacing]: [f32; 2],
    report: &mut CleanReport,
) {
    let extent = Extent::all(crowns);
    let size = extent.size();
    let Some(crown) = crowns.first().filter(|_| size.x > 0.1 * unit && size.y > 0.1 * unit) else {
        return;
    };
    let tips = tips(nodes, APART * size.x);
    let Some(&highest) = tips.first() else { return };
    let top = nodes.0[highest];
    let (roof, floor) = column(crowns, top.x).unwrap_or((extent.low.y, extent.high.y));
    if floor - top.y > REACHED * (floor - roof) {
        return;
    }
    let middle = tips.iter().map(|&tip| nodes.0[tip].x).sum::<f32>() / tips.len() as f32;
    let off = |tip: usize| nodes.0[tip].x - middle;
    let widest = tips.iter().map(|&tip| off(tip).abs()).fold(1e-6 * unit, f32::max);
    let spread = (SPREAD * size.x / widest).min(MOST_SPREAD);
    let targets: Vec<(usize, Vec2)> = tips
        .iter()
        .map(|&tip| {
            let share = if tips.len() > 1 { TOP - LOWER * off(tip).abs() / widest } else { TOP };
            let x = extent.center().x + if tips.len() > 1 { spread * off(tip) } else { 0.0 };
            let (roof, floor) = column(crowns, x).unwrap_or((extent.low.y, extent.high.y));
            (tip, Vec2::new(x, floor - share * (floor - roof)))
        })
        .collect();
    let mut told = Vec::new();
    for (tip, target) in targets {
        if target.y < nodes.0[tip].y - spacing {
            let stroke = nodes.2[tip];
            if !told.contains(&stroke) {
                told.push(stroke);
                report.add(stroke, RepairKind::DrawnOn(crown.stroke));
            }
            curve(nodes, tip, target, spacing);
        }
    }
}

/// Tips in the upper part of the wood, the highest first, none too near to one before.
fn tips(nodes: &Nodes, apart: f32) -> Vec<usize> {
    let (positions, parents, _) = nodes;
    let mut is_tip = vec![true; positions.len()];
    parents.iter().skip(1).for_each(|&parent| is_tip[parent as usize] = false);
    let extent = Extent::of(positions);
    let level = extent.high.y - UPPER * extent.size().y;
    let mut tips: Vec<usize> =
        (0..positions.len()).filter(|&i| is_tip[i] && positions[i].y <= level).collect();
    tips.sort_by(|&a, &b| positions[a].y.total_cmp(&positions[b].y).then(a.cmp(&b)));
    let mut out: Vec<usize> = Vec::new();
    for tip in tips {
        if out.len() < MOST_TIPS
            && out.iter().all(|&other| positions[other].distance(positions[tip]) > apart)
        {
            out.push(tip);
        }
    }
    out
}

/// The highest and the lowest level at which lines of the crown pass a place.
fn column(crowns: &[Ink], x: f32) -> Option<(f32, f32)> {
    let mut range: Option<(f32, f32)> = None;
    for pair in crowns.iter().flat_map(|ink| ink.points.windows(2)) {
        let (a, b) = (pair[0], pair[1]);
        if (a.x > x) != (b.x > x) {
            let y = a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
            range = Some(range.map_or((y, y), |(roof, floor)| (roof.min(y), floor.max(y))));
        }
    }
    // Of an open line above there is no floor.
    range.filter(|(roof, floor)| floor > roof)
}

/// Adds nodes from a tip to a target, first in the tip's own direction (a quadratic Bézier curve).
fn curve(nodes: &mut Nodes, tip: usize, target: Vec2, spacing: f32) {
    let (from, mut below) = (nodes.0[tip], tip);
    // The direction over a few nodes: the last may be a hook.
    for _ in 0..4 {
        below = nodes.1.get(below).map_or(tip, |&parent| parent as usize);
        if below >= nodes.0.len() {
            below = 0;
            break;
        }
    }
    let way = (from - nodes.0[below]).normalize_or(Vec2::NEG_Y);
    let distance = from.distance(target);
    let bend = from + ONWARD * distance * way;
    let n = (distance / spacing).ceil().clamp(1.0, 1000.0) as u32;
    let (mut last, stroke) = (tip as u32, nodes.2[tip]);
    for i in 1..=n {
        let t = i as f32 / n as f32;
        nodes.0.push(from.lerp(bend, t).lerp(bend.lerp(target, t), t));
        nodes.1.push(last);
        nodes.2.push(stroke);
        last = nodes.0.len() as u32 - 1;
    }
}
