//! Depths carried from one inference to the next: those of branches that an edit leaves alone.

use crate::sketch::infer::{Inferred, Pin};
use crate::sketch::plan::Plan;
use glam::Vec2;
use std::collections::BTreeMap;

/// A point of the new plan takes the depth of an old stroke that passes within this share of the old plan's size.
const NEAR: f32 = 0.012;

/// Depths along the strokes of an inferred sketch, in the drawing's units.
#[derive(Clone, Debug, Default)]
pub(super) struct Depths {
    strokes: BTreeMap<u32, Vec<[Known; 2]>>,
    near: f32,
}

/// A point of the drawing and its depth.
#[derive(Clone, Copy, Debug)]
struct Known {
    at: Vec2,
    depth: f32,
}

impl Depths {
    pub(super) fn of(plan: &Plan, inferred: &Inferred) -> Self {
        let mut depths = vec![0.0; plan.len()];
        let mut strokes: BTreeMap<u32, Vec<[Known; 2]>> = BTreeMap::new();
        // Every node but the base lies on one segment beyond its first point.
        for segment in 0..inferred.branches.len() {
            for (&node, point) in
                inferred.nodes(segment).iter().zip(inferred.branches.points(segment))
            {
                depths[node as usize] = point.z;
            }
        }
        let known = |node: usize| Known {
            at: plan.to_drawing(plan.positions()[node]),
            depth: depths[node] / plan.scale,
        };
        for node in 1..plan.len() {
            let parent = plan.parents()[node] as usize;
            strokes.entry(plan.strokes()[node]).or_default().push([known(parent), known(node)]);
        }
        let size = plan
            .positions()
            .iter()
            .fold(0.0_f32, |most, point| most.max(point.abs().max_element()));
        Self { strokes, near: NEAR * size / plan.scale }
    }

    /// Forgets a stroke, or the depths on it.
    pub(super) fn forget(&mut self, stroke: u32) {
        self.strokes.remove(&stroke);
    }

    /// Depths known of ends of the new plan's segments.
    pub(super) fn pins(&self, plan: &Plan) -> Vec<Pin> {
        let ends = ends(plan);
        let pin = |&node: &u32| {
            let at = plan.to_drawing(plan.positions()[node as usize]);
            let lines = self.strokes.get(&plan.strokes()[node as usize])?;
            let (distance, depth) =
                lines.iter().map(|line| nearest(line, at)).min_by(|a, b| a.0.total_cmp(&b.0))?;
            (distance <= self.near).then_some(Pin { node, depth: depth * plan.scale })
        };
        ends.iter().filter_map(pin).collect()
    }
}

/// Nodes where segments end: tips and forks, but for that of the root segment.
fn ends(plan: &Plan) -> Vec<u32> {
    let mut fan = vec![0_u32; plan.len()];
    for &parent in &plan.parents()[1..] {
        fan[parent as usize] += 1;
    }
    let mut first = 0;
    while fan[first] == 1 {
        // The only child; nodes come after their parents.
        match plan.parents().iter().position(|&parent| parent as usize == first) {
            Some(next) => first = next,
            None => break,
        }
    }
    (1..plan.len())
        .filter(|&node| fan[node] != 1 && node != first)
        .map(|node| node as u32)
        .collect()
}

/// Distance to a line, and the depth there.
fn nearest([from, to]: &[Known; 2], at: Vec2) -> (f32, f32) {
    let along = to.at - from.at;
    let share = ((at - from.at).dot(along) / along.length_squared().max(1e-20)).clamp(0.0, 1.0);
    (at.distance(from.at + share * along), from.depth + share * (to.depth - from.depth))
}
