//! From the depths of segment ends to those of all points between them.
//!
//! Along an axis depths run through the ends as a monotone cubic (Fritsch & Carlson 1980): smooth where segments
//! meet, and never beyond the depths at their ends. Segments that would come too near others that way run straight.

use super::near::Crossing;
use super::posterior::State;
use super::segments::Segments;
use crate::sketch::branches::{Branches, Label};
use crate::sketch::plan::Plan;
use tree_core::NO_PARENT;

/// The segments in space.
pub(super) fn in_space(
    plan: &Plan,
    segments: &Segments,
    state: &State,
    crossings: &[Crossing],
) -> Branches {
    let lengths: Vec<f64> = (0..segments.len()).map(|i| length(plan, segments.nodes(i))).collect();
    let rises: Vec<f64> = (0..segments.len())
        .map(|i| {
            let below = segments.parent(i).map_or(0.0, |parent| state.depths[parent]);
            (state.depths[i] - below) / lengths[i].max(1e-9)
        })
        .collect();
    let mut straight = vec![false; segments.len()];
    for crossing in crossings {
        straight[crossing.a.0 as usize] = true;
        straight[crossing.b.0 as usize] = true;
    }
    let mut out = Branches {
        parents: segments.parents.clone(),
        labels: state.labels.clone(),
        starts: vec![0],
        points: Vec::with_capacity(plan.len() + segments.len()),
        imagined_root: segments.imagined_root,
        names: segments.keys.iter().map(|&[stroke, place]| (stroke << 32) ^ place).collect(),
    };
    for (i, &length) in lengths.iter().enumerate() {
        if i == 0 && segments.imagined_root {
            let end = segments.ends[0].as_vec2().extend(0.0);
            out.points.extend([segments.base.as_vec2().extend(0.0), end]);
        } else {
            let slopes = slopes(segments, state, &rises, &straight, i);
            points(plan, segments, state, length, slopes, i, &mut out);
        }
        out.starts.push(out.points.len() as u32);
    }
    out
}

/// Rise at the beginning and the end of a segment.
fn slopes(
    segments: &Segments,
    state: &State,
    rises: &[f64],
    straight: &[bool],
    i: usize,
) -> (f64, f64) {
    if straight[i] {
        return (rises[i], rises[i]);
    }
    let goes_on = segments
        .children(i)
        .iter()
        .map(|&c| c as usize)
        .find(|&c| state.labels[c] == Label::Apical);
    let below = segments
        .parent(i)
        .filter(|&p| state.labels[i] == Label::Apical && !(p == 0 && segments.imagined_root));
    let between = |a: usize, b: usize| {
        if straight[a] || straight[b] {
            return rises[i];
        }
        // The harmonic mean keeps the cubic monotone.
        let (x, y) = (rises[a], rises[b]);
        if x * y > 0.0 { 2.0 * x * y / (x + y) } else { 0.0 }
    };
    (below.map_or(rises[i], |p| between(p, i)), goes_on.map_or(rises[i], |c| between(i, c)))
}

/// Adds the points of segment `i`.
fn points(
    plan: &Plan,
    segments: &Segments,
    state: &State,
    length: f64,
    slopes: (f64, f64),
    i: usize,
    out: &mut Branches,
) {
    let from = segments.parent(i).map_or(0.0, |parent| state.depths[parent]);
    let to = state.depths[i];
    let nodes = segments.nodes(i);
    let mut walked = 0.0;
    for (k, &node) in nodes.iter().enumerate() {
        let at = plan.positions()[node as usize];
        if k > 0 {
            walked += f64::from(at.distance(plan.positions()[nodes[k - 1] as usize]));
        }
        let t = if k + 1 == nodes.len() { 1.0 } else { walked / length.max(1e-9) };
        let (t2, t3) = (t * t, t * t * t);
        let depth = (2.0 * t3 - 3.0 * t2 + 1.0) * from
            + (t3 - 2.0 * t2 + t) * length * slopes.0
            + (3.0 * t2 - 2.0 * t3) * to
            + (t3 - t2) * length * slopes.1;
        out.points.push(at.extend(depth as f32));
    }
}

/// Length of a polyline of the plan.
fn length(plan: &Plan, nodes: &[u32]) -> f64 {
    let at = |node: u32| plan.positions()[node as usize].as_dvec2();
    nodes.windows(2).map(|pair| at(pair[0]).distance(at(pair[1]))).sum()
}

/// Labels of a tree nothing is known of: all apical.
pub(super) fn unknown(segments: &Segments) -> State {
    let labels = segments
        .parents
        .iter()
        .map(|&parent| if parent == NO_PARENT { Label::Apical } else { Label::Lateral(u16::MAX) });
    State { depths: vec![0.0; segments.len()], labels: labels.collect() }
}
