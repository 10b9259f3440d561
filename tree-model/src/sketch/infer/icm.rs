//! Refinement: iterated conditional modes (Besag 1986; section 4.6.1, Eq. 4.23 and 4.24).
//!
//! Departures: a step is a search along one depth that is taken only where it raises the posterior, not the gradient as it
//! comes, which can overshoot. The roll γ takes part: with the frames of this module it depends on a few
//! segments only. Whole branches may swing from front to back.

use super::densities::Densities;
use super::posterior::{Graph, State, Wiring};
use super::segments::STEEPEST;

/// First step of a search, as a share of the segment's length in the plane.
const FIRST_STEP: f64 = 0.2;
/// A search along one depth ends at steps of this share of the first.
const LAST_STEP: f64 = 1.0 / 512.0;
/// Steps of one search at most.
const MOST_STEPS: u32 = 40;

/// One search for each depth in turn; returns by how much depths changed altogether.
pub(super) fn sweep(
    graph: &Graph,
    omega: &Densities,
    state: &mut State,
    wiring: &Wiring,
    share: f64,
) -> f64 {
    let mut change = 0.0;
    for segment in 1..graph.segments().len() {
        if !graph.pinned[segment] {
            let before = state.depths[segment];
            search(graph, omega, state, wiring, segment, share);
            change += (state.depths[segment] - before).abs();
        }
    }
    change
}

/// Raises the posterior along the depth of one segment by steps that double and halve. `share` shortens the first one.
fn search(
    graph: &Graph,
    omega: &Densities,
    state: &mut State,
    wiring: &Wiring,
    segment: usize,
    share: f64,
) {
    let first =
        FIRST_STEP * graph.segments().chord(segment).length().max(0.01 * graph.segments().extent);
    let mut best = graph.around(omega, state, wiring, segment);
    let mut step = first * share;
    // A known depth may have made it steeper.
    let limit = steepness(graph, state, segment).max(STEEPEST);
    for _ in 0..MOST_STEPS {
        let here = state.depths[segment];
        let mut found = None;
        for depth in [here + step, here - step] {
            state.depths[segment] = depth;
            if steepness(graph, state, segment) > limit {
                continue;
            }
            let value = graph.around(omega, state, wiring, segment);
            if value > best {
                (best, found) = (value, Some(depth));
                break;
            }
        }
        match found {
            // On, the same way, a little farther.
            Some(depth) => {
                step = 1.5 * (depth - here);
                state.depths[segment] = depth;
            }
            None => {
                state.depths[segment] = here;
                step *= 0.4;
            }
        }
        if step.abs() < first * LAST_STEP * share.min(1.0) {
            break;
        }
    }
}

/// The tangent against the plane of a segment or the steepest that it bears.
fn steepness(graph: &Graph, state: &State, segment: usize) -> f64 {
    let segments = graph.segments();
    let least = 0.01 * segments.extent;
    let tangent = |i: usize| {
        let below = segments.parent(i).map_or(0.0, |parent| state.depths[parent]);
        (state.depths[i] - below).abs() / segments.chord(i).length().max(least)
    };
    let children = segments.children(segment).iter().map(|&child| tangent(child as usize));
    children.fold(tangent(segment), f64::max)
}

/// Swings each branch to the other side of the plane through its base, where that raises the posterior; returns whether any did.
/// O(segments · size of their branches).
pub(super) fn swing(graph: &Graph, omega: &Densities, state: &mut State, total: &mut f64) -> bool {
    let segments = graph.segments();
    let mut any = false;
    for segment in 1..segments.len() {
        let Some(parent) = segments.parent(segment) else { continue };
        let branch = branch(segments, segment);
        if branch.iter().any(|&i| graph.pinned[i]) {
            continue;
        }
        let level = 2.0 * state.depths[parent];
        let mirror = |state: &mut State| {
            for &i in &branch {
                state.depths[i] = level - state.depths[i];
            }
        };
        mirror(state);
        let value = graph.total(omega, state);
        if value > *total {
            (*total, any) = (value, true);
        } else {
            mirror(state);
        }
    }
    any
}

/// A segment and all it bears.
pub(super) fn branch(segments: &super::segments::Segments, segment: usize) -> Vec<usize> {
    let mut branch = vec![segment];
    let mut done = 0;
    while done < branch.len() {
        let here = branch[done];
        done += 1;
        branch.extend(segments.children(here).iter().map(|&child| child as usize));
    }
    branch
}
