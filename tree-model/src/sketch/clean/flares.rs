//! Flares of roots: where a drawn trunk parts at its foot, the tree begins below the fork, not at the tip of a flare.

use super::join::Nodes;
use super::report::{CleanReport, RepairKind};
use glam::Vec2;
use tree_core::NO_PARENT;

/// The fork is at most this share of the height above the lowest flare's tip.
const HIGHEST: f32 = 0.25;

/// No flare rises above its fork by more than this share of the height ...
const RISE: f32 = 0.02;

/// ... and it goes down by at least this share.
const FALL: f32 = 0.01;

/// Forks at which flares part, at most.
const FORKS: u32 = 4;

/// Leaves out flares: branches of the trunk's lowest fork that lead down, as the trunk's own beginning there does. In
/// place of that a straight trunk stands below the fork. Strokes that are `marked` stay.
pub(super) fn leave_out(
    nodes: &mut Nodes,
    marked: &dyn Fn(u32) -> bool,
    [unit, spacing]: [f32; 2],
    report: &mut CleanReport,
) {
    for _ in 0..FORKS {
        if !leave_out_lowest(nodes, marked, unit, spacing, report) {
            return;
        }
    }
}

/// The same at the lowest fork; whether there were any.
fn leave_out_lowest(
    nodes: &mut Nodes,
    marked: &dyn Fn(u32) -> bool,
    unit: f32,
    spacing: f32,
    report: &mut CleanReport,
) -> bool {
    let (positions, parents, strokes) = &*nodes;
    let n = positions.len();
    // The highest and lowest level of what each node bears.
    let (mut high, mut low): (Vec<f32>, Vec<f32>) = positions.iter().map(|p| (p.y, p.y)).unzip();
    let mut fan = vec![0_u32; n];
    for node in (1..n).rev() {
        let parent = parents[node] as usize;
        high[parent] = high[parent].min(high[node]);
        low[parent] = low[parent].max(low[node]);
        fan[parent] += 1;
    }
    let Some(fork) = (0..n).find(|&node| fan[node] != 1).filter(|&fork| fan[fork] > 1 && fork > 0)
    else {
        return false;
    };
    let level = positions[fork].y;
    let children: Vec<usize> = (1..n).filter(|&node| parents[node] as usize == fork).collect();
    let is_flare =
        |&node: &usize| high[node] > level - RISE * unit && low[node] > level + FALL * unit;
    let (flares, others): (Vec<usize>, Vec<usize>) = children.into_iter().partition(is_flare);
    let foot = flares.iter().map(|&flare| low[flare]).fold(positions[0].y, f32::max);
    let kept = |node: usize| marked(strokes[node]);
    if flares.is_empty()
        || others.is_empty()
        || foot - level > HIGHEST * unit
        || kept(0)
        || flares.iter().any(|&flare| kept(flare))
    {
        return false;
    }
    report.add(strokes[flares[0]], RepairKind::RootFlare);
    let mut gone = vec![false; n];
    flares.iter().for_each(|&flare| gone[flare] = true);
    let mut below = fork;
    while parents[below] != NO_PARENT {
        below = parents[below] as usize;
        gone[below] = true;
    }
    let mut out: Nodes = (Vec::with_capacity(n), Vec::with_capacity(n), Vec::with_capacity(n));
    let steps = ((foot - level) / spacing).ceil().max(1.0) as u32;
    for i in 0..steps {
        let y = foot + (level - foot) * i as f32 / steps as f32;
        out.0.push(Vec2::new(positions[fork].x, y));
        out.1.push(i.checked_sub(1).unwrap_or(NO_PARENT));
        out.2.push(strokes[fork]);
    }
    let mut rows = vec![steps - 1; n];
    for node in 0..n {
        let parent = parents[node];
        if node != fork && !gone[node] && parent != NO_PARENT {
            // What the trunk's beginning bears is a flare, but for the fork.
            gone[node] = gone[parent as usize];
        }
        if gone[node] {
            continue;
        }
        let row = out.0.len() as u32;
        out.0.push(positions[node]);
        out.1.push(if node == fork { steps - 1 } else { rows[parent as usize] });
        out.2.push(strokes[node]);
        rows[node] = row;
    }
    *nodes = out;
    true
}
