//! Lines out of a pruned axis: at forks the straightest pair goes on.

use super::Midline;
use super::forks;
use crate::plane::axis::Axis;
use crate::plane::fill::Frame;
use glam::DVec2;
use std::collections::VecDeque;

/// Passes of smoothing; the middles of chords zigzag a little.
const PASSES: usize = 3;

/// Points closer to the one before than this share of the half-width there are left out.
const CLOSE: f64 = 0.3;

/// All lines of a forest, main lines first. Consumes the axis: it is smoothed.
pub(super) fn lines(mut axis: Axis, frame: &Frame) -> Vec<Midline> {
    axis.weigh();
    let through = forks::through(&axis);
    let mut mains = main_lines(&axis, &through);
    mains.sort_by(|a, b| strength(&axis, b).total_cmp(&strength(&axis, a)));
    let mut all = Vec::new();
    for main in mains {
        branch_out(&axis, &through, main, &mut all);
    }
    smooth(&mut axis, &all);
    all.iter().map(|line| finish(&axis, line, frame)).collect()
}

/// Length times half-width, summed along.
fn strength(axis: &Axis, line: &[u32]) -> f64 {
    let part =
        |a: u32, b: u32| axis.length(a, b) * (axis.radii[a as usize] + axis.radii[b as usize]);
    line.windows(2).map(|pair| part(pair[0], pair[1])).sum()
}

/// The strongest line of each tree when every fork lets its straightest pair go on, from its thicker end.
fn main_lines(axis: &Axis, through: &[Option<(u32, u32)>]) -> Vec<Vec<u32>> {
    let n = axis.at.len();
    let mut trees: Vec<Option<Vec<u32>>> = Vec::new();
    let mut tree_of = vec![u32::MAX; n];
    for node in 0..n as u32 {
        if tree_of[node as usize] == u32::MAX && axis.degree(node) > 0 {
            mark(axis, node, trees.len() as u32, &mut tree_of);
            trees.push(None);
        }
    }
    for node in 0..n as u32 {
        for &next in &axis.joined[node as usize] {
            // A line begins at a tip, and at a fork where it is not one of the pair.
            if forks::other(through[node as usize], next).is_some() {
                continue;
            }
            let line =
                follow(axis, node, next, |at, before| forks::other(through[at as usize], before));
            let best = &mut trees[tree_of[node as usize] as usize];
            if best.as_ref().is_none_or(|best| strength(axis, &line) > strength(axis, best)) {
                *best = Some(line);
            }
        }
    }
    let on = |mut line: Vec<u32>| {
        // From both ends: where it met a fork whose pair are others, it goes on too.
        for _ in 0..2 {
            go_on(axis, through, &mut line);
            line.reverse();
        }
        thick_end_first(axis, line)
    };
    trees.into_iter().flatten().map(on).collect()
}

/// Writes `tree` to all nodes that hang together with `node`.
fn mark(axis: &Axis, node: u32, tree: u32, tree_of: &mut [u32]) {
    let mut open = vec![node];
    while let Some(node) = open.pop() {
        if tree_of[node as usize] == u32::MAX {
            tree_of[node as usize] = tree;
            open.extend(&axis.joined[node as usize]);
        }
    }
}

fn thick_end_first(axis: &Axis, mut line: Vec<u32>) -> Vec<u32> {
    let half = line.len() / 2;
    let (front, back) = (line.get(..=half), line.get(half..));
    let mean = |part: Option<&[u32]>| {
        let part = part.unwrap_or(&line);
        let length: f64 = part.windows(2).map(|pair| axis.length(pair[0], pair[1])).sum();
        strength(axis, part) / length.max(f64::MIN_POSITIVE)
    };
    if mean(back) > mean(front) {
        line.reverse();
    }
    line
}

/// The nodes from `from` by way of `next`, on for as long as `onward(node, node before)` says.
fn follow(axis: &Axis, from: u32, next: u32, onward: impl Fn(u32, u32) -> Option<u32>) -> Vec<u32> {
    let mut line = vec![from];
    let (mut before, mut at) = (from, next);
    loop {
        line.push(at);
        let on = match axis.joined[at as usize][..] {
            [a, b] => Some(if a == before { b } else { a }),
            [] | [_] => None,
            _ => onward(at, before),
        };
        let Some(on) = on else { return line };
        (before, at) = (at, on);
    }
}

/// Lengthens a line to the next tip.
fn go_on(axis: &Axis, through: &[Option<(u32, u32)>], line: &mut Vec<u32>) {
    let &[.., before, end] = line.as_slice() else { return };
    line.pop();
    line.extend(
        follow(axis, before, end, |at, before| onward(axis, through, at, before)).drain(1..),
    );
}

/// Where a line goes on at a fork: to its pair, or else straightest.
fn onward(axis: &Axis, through: &[Option<(u32, u32)>], at: u32, before: u32) -> Option<u32> {
    forks::other(through[at as usize], before).or_else(|| forks::straightest(axis, at, before))
}

/// Adds a line and all that leave it: at each fork of a side line the straightest way goes on.
fn branch_out(
    axis: &Axis,
    through: &[Option<(u32, u32)>],
    main: Vec<u32>,
    all: &mut Vec<Vec<u32>>,
) {
    let mut waiting = VecDeque::from([main]);
    while let Some(line) = waiting.pop_front() {
        let mut leaving: Vec<Vec<u32>> = Vec::new();
        for triple in line.windows(3) {
            for &next in &axis.joined[triple[1] as usize] {
                if next != triple[0] && next != triple[2] {
                    let on = |at, before| onward(axis, through, at, before);
                    leaving.push(follow(axis, triple[1], next, on));
                }
            }
        }
        leaving.sort_by(|a, b| strength(axis, b).total_cmp(&strength(axis, a)));
        waiting.extend(leaving);
        all.push(line);
    }
}

/// Lays forks on the line that passes them and smooths each line between its ends.
fn smooth(axis: &mut Axis, all: &[Vec<u32>]) {
    for line in all {
        for triple in line.windows(3) {
            if axis.degree(triple[1]) > 2 {
                let sum = axis.at[triple[0] as usize] + axis.at[triple[2] as usize];
                axis.at[triple[1] as usize] = 0.5 * sum;
            }
        }
        for _ in 0..PASSES {
            let before: Vec<DVec2> = line.iter().map(|&node| axis.at[node as usize]).collect();
            for (&node, around) in line.iter().skip(1).zip(before.windows(3)) {
                axis.at[node as usize] = 0.25 * (around[0] + 2.0 * around[1] + around[2]);
            }
        }
    }
}

/// Points and half-widths of a line in the drawing's units. All forks are kept, for side lines begin there, and of the
/// other points those that are not close together.
fn finish(axis: &Axis, line: &[u32], frame: &Frame) -> Midline {
    let at = |i: usize| axis.at[line[i] as usize];
    let last = line.len() - 1;
    let mut widths: Vec<f64> = (0..line.len())
        .map(|i| {
            let chord = axis.chords[line[i] as usize];
            let along = (at((i + 1).min(last)) - at(i.saturating_sub(1))).normalize_or_zero();
            if chord == DVec2::ZERO { f64::NAN } else { 0.5 * chord.perp_dot(along).abs() }
        })
        .collect();
    fill_gaps(&mut widths, axis.degree(line[last]) == 1 && axis.radii[line[last] as usize] == 0.0);
    let mut out = Midline::default();
    let mut before: Option<DVec2> = None;
    for i in 0..line.len() {
        let is_fork = axis.degree(line[i]) > 2;
        let is_far = before.is_none_or(|b| b.distance(at(i)) >= CLOSE * widths[i]);
        if is_far || is_fork || i == 0 || i == last {
            before = Some(at(i));
            out.points.push(frame.to_drawing(at(i)));
            out.half_widths.push(frame.length(widths[i]));
        }
    }
    out
}

/// Gives forks and ends the width of their neighbours on the line; pointed tips have none.
fn fill_gaps(widths: &mut [f64], pointed: bool) {
    if pointed && let Some(last) = widths.last_mut() {
        *last = 0.0;
    }
    let known = |w: &f64| !w.is_nan();
    for i in 0..widths.len() {
        if widths[i].is_nan() {
            let after = widths[i + 1..].iter().copied().find(known);
            let before = widths[..i].iter().rev().copied().find(known);
            widths[i] = match (before, after) {
                (Some(a), Some(b)) => 0.5 * (a + b),
                (a, b) => a.or(b).unwrap_or(0.0),
            };
        }
    }
}
