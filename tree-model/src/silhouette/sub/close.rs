//! The curves that close a sub-silhouette.

use super::shared::{Round, Section};
use super::{CURVE_STEPS, Hermite, Join, SubOutline};
use crate::silhouette::{Line, Outline};
use glam::{DVec2, Vec2};

/// Lengths of the tangents tried, as shares of the distance of the curve's ends. The first is that of the paper's branches.
const TENSION: [f32; 4] = [0.5, 0.3, 0.15, 0.05];

/// How much less is shared from one try to the next.
const LESS: f32 = 0.5;

/// Tries with less shared.
const TRIES: usize = 7;

/// The curves open at the base by this more than the branch bends, in radians.
const MARGIN: f32 = 0.15;

/// And by at most this, in radians.
const WIDEST: f32 = 1.4;

/// Places on each curve that are to be inside the parent.
const PROBES: usize = 6;

/// They may lie outside by this share of the branch's span: the outline's own corners.
const OUTSIDE: f32 = 0.01;

/// A spindle about a branch that shares nothing is this wide, as a share of its span.
const SPINDLE: f32 = 0.2;

/// How good an outline is: simple and about something, with the branch in it, and inside its parent.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Rank {
    Simple,
    Holding,
    Inside,
}

/// The sub-silhouette with a section of its parent. O(n) for each try; the first usually is good.
pub(super) fn close(
    round: &Round<'_>,
    branch: &Line,
    half: f32,
    mut section: Section,
) -> SubOutline {
    let opens = opens(branch, half);
    let mut best: Option<(Rank, SubOutline)> = None;
    for _ in 0..TRIES {
        for tension in TENSION {
            let Some(found) = with(round, branch, opens, section, tension) else { continue };
            let rank = rank(round, branch, &found);
            if rank == Rank::Inside {
                return found;
            }
            if best.as_ref().is_none_or(|best| rank > best.0) {
                best = Some((rank, found));
            }
        }
        section.reach = section.reach.map(|reach| LESS * reach);
    }
    best.map_or_else(|| spindle(round, branch, section.anchor), |best| best.1)
}

/// Angles between the branch's span and the curves at its base, to the right and to the left.
fn opens(branch: &Line, half: f32) -> [f32; 2] {
    let (base, span) = (branch.start(), branch.span());
    let mut most = [0.0_f32; 2];
    for i in 1..8 {
        let way = branch.at(i as f32 / 8.0) - base;
        let turn = span.angle_to(way);
        if turn.is_finite() {
            let side = usize::from(turn > 0.0);
            most[side] = most[side].max(turn.abs());
        }
    }
    most.map(|most| half.max(most + MARGIN).min(WIDEST))
}

/// The sub-silhouette with tangents of one length; `None` where it crosses itself or runs the wrong way round.
fn with(
    round: &Round<'_>,
    branch: &Line,
    opens: [f32; 2],
    section: Section,
    tension: f32,
) -> Option<SubOutline> {
    let base = branch.start();
    let direction = branch.span().try_normalize().unwrap_or_else(|| branch.tangent(0.0));
    let turned = |angle: f32| Vec2::new(libm::cosf(angle), libm::sinf(angle)).rotate(direction);
    let from = round.reduced(section.anchor - section.reach[0]);
    let shared = [from, from + section.reach[0] + section.reach[1]];
    let joins = [round.join(shared[0], false), round.join(shared[1], true)];
    let [begin, end] = joins.map(|join| tension * join.point.distance(base));
    let curves = [
        Hermite {
            from: base,
            leaves: begin * turned(-opens[0]),
            to: joins[0].point,
            arrives: begin * joins[0].tangent,
        },
        Hermite {
            from: joins[1].point,
            leaves: end * joins[1].tangent,
            to: base,
            arrives: -end * turned(opens[1]),
        },
    ];
    let mut points = vec![base];
    sample(&curves[0], &mut points);
    points.push(joins[0].point);
    let n_before = points.len();
    points.extend(round.corners(shared[0], shared[1]));
    let n_shared = points.len() - n_before;
    points.push(joins[1].point);
    sample(&curves[1], &mut points);
    let least = f32::EPSILON * (base.abs().max_element() + round.length);
    let apart = |pair: &[Vec2]| pair[0].distance(pair[1]) > least;
    let closed = points.last().is_some_and(|last| last.distance(base) > least);
    if !(points.windows(2).all(apart) && closed) {
        // Corners of the parent that fall on a join.
        return with_tidied(points, least, round, shared, joins, curves);
    }
    let own = n_before..n_before + n_shared;
    is_simple(&points, own).then(|| SubOutline {
        outline: Outline::of_simple(points),
        shared,
        joins,
        curves,
    })
}

/// The same where points coincide: every side is tried against every other.
fn with_tidied(
    mut points: Vec<Vec2>,
    least: f32,
    round: &Round<'_>,
    shared: [f32; 2],
    joins: [Join; 2],
    curves: [Hermite; 2],
) -> Option<SubOutline> {
    let least = least.max(f32::EPSILON * round.length);
    points.dedup_by(|a, b| a.distance(*b) <= least);
    while points.len() > 1 && points[0].distance(points[points.len() - 1]) <= least {
        points.pop();
    }
    (points.len() > 2 && is_simple(&points, 0..0)).then(|| SubOutline {
        outline: Outline::of_simple(points),
        shared,
        joins,
        curves,
    })
}

fn sample(curve: &Hermite, points: &mut Vec<Vec2>) {
    points.extend((1..CURVE_STEPS).map(|i| curve.at(i as f32 / CURVE_STEPS as f32)));
}

/// Whether a polygon runs against the clock and no two sides meet, of which `own` are known not to meet each other (from
/// the point before the range to the one after it). O((n − own) · n).
fn is_simple(points: &[Vec2], own: std::ops::Range<usize>) -> bool {
    let n = points.len();
    let at = |i: usize| points[i % n].as_dvec2();
    let origin = at(0);
    let area: f64 = (0..n).map(|i| (at(i) - origin).perp_dot(at(i + 1) - origin)).sum();
    if !(area > 0.0 && area.is_finite()) {
        return false;
    }
    // Sides from the point before `own` on are the parent's.
    let is_own = |i: usize| !own.is_empty() && i + 1 >= own.start && i < own.end;
    for i in (0..n).filter(|&i| !is_own(i)) {
        let (a, b) = (at(i), at(i + 1));
        let (low, high) = (a.min(b), a.max(b));
        for j in 0..n {
            // Each pair once; a side of the parent comes after or before.
            if j == i || (j < i && !is_own(j)) {
                continue;
            }
            let (c, d) = (at(j), at(j + 1));
            if c.max(d).cmplt(low).any() || c.min(d).cmpgt(high).any() {
                continue;
            }
            let meet = if (i + 1) % n == j {
                folds(a, b, d)
            } else if (j + 1) % n == i {
                folds(c, a, b)
            } else {
                meets(a, b, c, d)
            };
            if meet {
                return false;
            }
        }
    }
    true
}

/// Whether a way goes back on itself at its middle point.
fn folds(a: DVec2, b: DVec2, c: DVec2) -> bool {
    (b - a).perp_dot(c - b) == 0.0 && (b - a).dot(c - b) <= 0.0
}

fn meets(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    let (one, other) = (b - a, d - c);
    one.perp_dot(c - a) * one.perp_dot(d - a) <= 0.0
        && other.perp_dot(a - c) * other.perp_dot(b - c) <= 0.0
}

fn rank(round: &Round<'_>, branch: &Line, found: &SubOutline) -> Rank {
    if !found.outline.contains(branch.at(0.5)) {
        return Rank::Simple;
    }
    let may = OUTSIDE * branch.span().length();
    let is_inside = |point: Vec2| {
        round.outline.contains(point)
            || round.outline.sides().any(|(a, b)| {
                let side = b - a;
                let part = ((point - a).dot(side) / side.length_squared()).clamp(0.0, 1.0);
                point.distance_squared(a + part * side) <= may * may
            })
    };
    let mut probes = found
        .curves
        .iter()
        .flat_map(|curve| (1..=PROBES).map(move |i| curve.at(i as f32 / (PROBES + 1) as f32)));
    if probes.all(is_inside) { Rank::Inside } else { Rank::Holding }
}

/// An outline about a branch that shares nothing with its parent.
fn spindle(round: &Round<'_>, branch: &Line, anchor: f32) -> SubOutline {
    let (base, end) = (branch.start(), branch.end());
    let span = end - base;
    // A branch that ends where it begins.
    let span = if span.length() > 0.0 { span } else { branch.length() * branch.tangent(0.0) };
    let end = base + span;
    let [right, left] = [-1.0, 1.0].map(|side| span + side * SPINDLE * 4.0 * span.perp());
    let curves = [
        Hermite { from: base, leaves: 0.5 * right, to: end, arrives: 0.5 * left },
        Hermite { from: end, leaves: -0.5 * right, to: base, arrives: -0.5 * left },
    ];
    let mut points = vec![base];
    sample(&curves[0], &mut points);
    points.push(end);
    sample(&curves[1], &mut points);
    let join = |curve: &Hermite| Join {
        point: end,
        tangent: curve.derivative(if curve.to == end { 1.0 } else { 0.0 }).normalize_or(Vec2::X),
    };
    SubOutline {
        outline: Outline::of_simple(points),
        shared: [round.reduced(anchor); 2],
        joins: [join(&curves[0]), join(&curves[1])],
        curves,
    }
}
