//! Where growth begins: open ends of the sketch, and new forks along branches that are disproportionately long.

use super::block::Pools;
use super::drawn::{Drawn, chain, habit, usual_ratio};
use super::grow::{Grower, Open};
use std::f32::consts::TAU;
use tree_core::seed::uniform;

/// Share of a long branch at its base that bears no new laterals: it lies in the shade.
const SHADE: f32 = 0.12;
/// Without a crown, what grows at the end of a stroke refers to this share of its natural length: the drawing already
/// says how far the branch goes.
const TIP: f32 = 0.6;
/// Smallest and largest reach of a new lateral, in lengths of its axis beyond the fork.
const REACH: [f32; 2] = [0.3, 0.55];
/// The first number of the streams of new forks, which keeps them apart from children's.
const FORKS: u64 = 1 << 32;

/// What was found.
#[derive(Default)]
pub(super) struct Found {
    pub(super) opens: Vec<Open>,
    /// New forks along long branches, and the branches.
    pub(super) forks: u64,
    pub(super) long: u64,
    /// Open ends and forks outside the crown.
    pub(super) outside: u64,
}

/// Finds all places on the sketch where blocks may be attached.
pub(super) fn find(drawn: &Drawn<'_>, pools: &Pools, grower: &Grower<'_>) -> Found {
    let mut found = Found::default();
    for segment in 0..drawn.orders.len() {
        let order = drawn.orders[segment];
        let frond = !pools.branches(order + 1) && drawn.is_in_rosette(segment);
        if drawn.is_imagined(segment) || !pools.branches(order) || frond {
            continue;
        }
        along(drawn, grower, segment, &mut found);
        if drawn.children(segment).is_empty() {
            end(drawn, grower, segment, &mut found);
        }
    }
    found
}

/// Forks at even distances along a segment much longer than natural.
fn along(drawn: &Drawn<'_>, grower: &Grower<'_>, segment: usize, found: &mut Found) {
    let (length, natural) = (drawn.courses[segment].length(), drawn.natural[segment]);
    let (order, in_crown) = (drawn.orders[segment], grower.bounds.crown.is_some());
    let params = grower.params;
    let stem = drawn.is_stem(segment);
    let forked = !drawn.children(segment).is_empty();
    if length <= params.long * natural
        || order >= params.orders
        || (stem && forked && !params.below_first)
    {
        return;
    }
    let bare = match (stem, in_crown) {
        (true, true) => 0.0,
        (true, false) => params.bare,
        (false, _) => SHADE,
    };
    // What will grow at the axis's tip counts too.
    let ratio = usual_ratio(habit(grower.omega, order));
    let beyond = drawn.beyond[segment] + TIP * natural * chain(ratio, grower.generations.max(1));
    found.long += 1;
    let key = drawn.keys[segment].child(FORKS);
    let rng = &mut key.rng();
    let mut turn = uniform(rng, 0.0, TAU);
    let n = (length / natural).round().max(2.0) as u32;
    // The sketch's own laterals at the end have the first numbers.
    let mut number = drawn.children(segment).len() as u16;
    for i in 1..n {
        let way = length * i as f32 / n as f32;
        turn = grower.turned(turn, order, rng);
        if way < bare * length {
            continue;
        }
        let point = drawn.courses[segment].at(way);
        if !grower.bounds.inside(point) {
            found.outside += 1;
            continue;
        }
        found.forks += 1;
        found.opens.push(Open {
            segment: segment as u32,
            fork: drawn.courses[segment].place(way),
            point,
            frame: drawn.frame_at(segment, way),
            turn,
            length: lateral_length(grower, order, length - way + beyond),
            order,
            key: key.child(u64::from(i)),
            laterals: Some(number),
            generation: 0,
        });
        // No block has more laterals.
        number = number.saturating_add(16);
    }
}

/// Length of a new lateral's first segment, so that with what grows on it, it reaches as far as Ω's scale says of what
/// its axis has left: so branches keep the outline of a tip.
fn lateral_length(grower: &Grower<'_>, order: u32, rest: f32) -> f32 {
    let scale = habit(grower.omega, order).lateral_scale.mean;
    let reach = libm::expf(scale).clamp(REACH[0], REACH[1]) * rest;
    let ratio = usual_ratio(habit(grower.omega, order + 1));
    reach / chain(ratio, grower.generations.max(1))
}

fn end(drawn: &Drawn<'_>, grower: &Grower<'_>, segment: usize, found: &mut Found) {
    let points = drawn.branches.points(segment);
    let point = drawn.branches.end(segment);
    if !grower.bounds.inside(point) {
        found.outside += 1;
        return;
    }
    let key = drawn.keys[segment];
    let tip = if grower.bounds.crown.is_some() { 1.0 } else { TIP };
    found.opens.push(Open {
        segment: segment as u32,
        fork: points.len().saturating_sub(1) as f32,
        point,
        frame: drawn.ends[segment],
        turn: uniform(&mut key.rng(), 0.0, TAU),
        length: tip * drawn.natural[segment],
        order: drawn.orders[segment],
        key,
        laterals: None,
        generation: 0,
    });
}
