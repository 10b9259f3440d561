//! Bottom-up inference: depths and labels generation by generation, from the root to the tips (section 4.6.1).
//!
//! At each fork each child's depth is sought under each label; most have two good ones, in front of the parent and behind.
//! Labels are then assigned to children, each once: all ways for up to three children, the best way (an
//! [assignment](super::labels)) for more. Departure: the thesis goes on with the one best solution; here the best few
//! go on together (a beam), so that what is second best at a fork and first best above it is not lost.

use super::densities::Densities;
use super::factors::Fork;
use super::labels::best_assignment;
use super::posterior::{Graph, State};
use super::segments::STEEPEST;
use crate::error::Result;
use crate::sketch::branches::Label;
use tree_core::Control;

/// Places on each side of the plane at which a search begins.
const PLACES: usize = 9;
/// Refinements of each place found.
const REFINEMENTS: usize = 7;
/// Children up to which all ways to label them are tried.
const FEW: usize = 3;
/// Places kept for each child and label.
const MODES: usize = 3;

/// A half-placed tree.
#[derive(Clone)]
struct Hypothesis {
    state: State,
    orders: Vec<u32>,
    ln: f64,
}

/// The best trees found, best first, at most `width`.
pub(super) fn bottom_up(
    graph: &Graph,
    omega: &Densities,
    start: &State,
    width: usize,
    control: &Control,
) -> Result<Vec<State>> {
    let segments = graph.segments();
    let orders = vec![0; segments.len()];
    let mut beam = vec![Hypothesis { state: start.clone(), orders, ln: 0.0 }];
    for parent in 0..segments.len() {
        if segments.children(parent).is_empty() {
            continue;
        }
        control.check()?;
        let mut next: Vec<Hypothesis> = Vec::new();
        for hypothesis in &beam {
            Placing { graph, omega, parent, hypothesis }.extend(width, &mut next);
        }
        next.sort_by(|a, b| b.ln.total_cmp(&a.ln));
        next.truncate(width);
        beam = next;
    }
    Ok(beam.into_iter().map(|hypothesis| hypothesis.state).collect())
}

/// Placing the children of one fork in one half-placed tree.
struct Placing<'a> {
    graph: &'a Graph,
    omega: &'a Densities,
    parent: usize,
    hypothesis: &'a Hypothesis,
}

/// A depth for a child, and how good it is.
type Mode = (f64, f64);

impl Placing<'_> {
    fn extend(&self, width: usize, out: &mut Vec<Hypothesis>) {
        let children = self.graph.segments().children(self.parent);
        let k = children.len();
        let mut labels: Vec<Label> = vec![Label::Apical];
        // Stems of a shrub are laterals, all of them.
        if self.graph.segments().imagined_root && self.parent == 0 {
            labels =
                (0..k).map(|place| Label::Lateral(place.min(u16::MAX as usize) as u16)).collect();
        }
        labels.extend(
            (labels.len()..k)
                .map(|place| Label::Lateral((place - 1).min(u16::MAX as usize) as u16)),
        );
        // A fork's side depends on its parent's side of it alone, so that one fork serves all labels.
        let fork = Fork {
            n_laterals: labels.iter().filter(|&&label| label != Label::Apical).count(),
            ..self.fork()
        };
        let modes: Vec<Vec<Vec<Mode>>> = children
            .iter()
            .map(|&child| {
                labels.iter().map(|&label| self.modes(&fork, child as usize, label)).collect()
            })
            .collect();
        let best =
            |child: usize, label: usize| modes[child][label].first().map_or(-1e9, |mode| mode.1);
        let mut ways: Vec<(f64, Vec<usize>)> = Vec::new();
        if k <= FEW {
            permutations(k, &mut |order| {
                ways.push((
                    order.iter().enumerate().map(|(child, &label)| best(child, label)).sum(),
                    order.to_vec(),
                ));
            });
        } else {
            let order = best_assignment(k, best);
            ways.push((0.0, order));
        }
        ways.sort_by(|a, b| b.0.total_cmp(&a.0));
        ways.truncate(width.clamp(1, 6));
        for (_, way) in ways {
            let choices: Vec<&[Mode]> =
                way.iter().enumerate().map(|(child, &label)| &modes[child][label][..]).collect();
            for depths in combinations(&choices, width) {
                out.push(self.placed(&fork, children, &labels, &way, &depths));
            }
        }
    }

    fn fork(&self) -> Fork {
        let Hypothesis { state, orders, .. } = self.hypothesis;
        self.graph.factors.fork(&state.depths, &state.labels, orders[self.parent], self.parent)
    }

    /// The best depths of a child under a label, best first; none is no child's.
    fn modes(&self, fork: &Fork, child: usize, label: Label) -> Vec<Mode> {
        let Self { graph, omega, .. } = self;
        let base = self.hypothesis.state.depths[self.parent];
        let chord = graph.segments().chord(child);
        let mut depths = self.hypothesis.state.depths.clone();
        let mut value = |depth: f64| {
            depths[child] = depth;
            graph.factors.child(omega, fork, chord.extend(depth - base), child, label)
                + graph.crossed_before(&depths, child)
                + graph.room(&depths, child)
        };
        if graph.pinned[child] {
            let depth = self.hypothesis.state.depths[child];
            return vec![(depth, value(depth))];
        }
        let length = chord.length().max(0.02 * graph.segments().extent);
        let places: Vec<f64> = (0..=2 * PLACES)
            .map(|i| {
                let share = i as f64 / PLACES as f64 - 1.0;
                // Closer together near the plane, where angles change fastest.
                base + length * STEEPEST * share * (0.25 + 0.75 * share * share)
            })
            .collect();
        let values: Vec<f64> = places.iter().map(|&depth| value(depth)).collect();
        let mut modes: Vec<Mode> = Vec::new();
        for i in 0..places.len() {
            let (low, high) = (i.saturating_sub(1), (i + 1).min(places.len() - 1));
            if values[i] >= values[low] && values[i] >= values[high] {
                modes.push(refined((places[low], places[i], places[high]), values[i], &mut value));
            }
        }
        modes.sort_by(|a, b| b.1.total_cmp(&a.1));
        modes.truncate(MODES);
        modes
    }

    /// The half-placed tree with these children placed.
    fn placed(
        &self,
        fork: &Fork,
        children: &[u32],
        labels: &[Label],
        way: &[usize],
        depths: &[f64],
    ) -> Hypothesis {
        let Self { graph, omega, hypothesis, .. } = self;
        let mut next = (*hypothesis).clone();
        for (i, &child) in children.iter().enumerate() {
            let (c, label) = (child as usize, labels[way[i]]);
            next.state.depths[c] = depths[i];
            next.state.labels[c] = label;
            next.orders[c] = graph.factors.order(fork.order, self.parent, label);
        }
        for &child in children {
            let c = child as usize;
            let v = graph.factors.vector(&next.state.depths, c);
            next.ln += graph.factors.child(omega, fork, v, c, next.state.labels[c]);
            next.ln +=
                graph.crossed_before(&next.state.depths, c) + graph.room(&next.state.depths, c);
        }
        next
    }
}

/// Narrows down on a maximum between two places.
fn refined(
    (mut low, mut mid, mut high): (f64, f64, f64),
    mut best: f64,
    value: &mut impl FnMut(f64) -> f64,
) -> Mode {
    for _ in 0..REFINEMENTS {
        for side in [false, true] {
            let between = if side { 0.5 * (mid + high) } else { 0.5 * (low + mid) };
            let found = value(between);
            if found > best {
                if side {
                    low = mid;
                } else {
                    high = mid;
                }
                (mid, best) = (between, found);
            } else if side {
                high = between;
            } else {
                low = between;
            }
        }
    }
    (mid, best)
}

/// Depths for all children: the best of each, then with other modes for some, at most `width`.
fn combinations(choices: &[&[Mode]], width: usize) -> Vec<Vec<f64>> {
    let best = |modes: &&[Mode]| modes.first().map_or(0.0, |mode| mode.0);
    let mut out: Vec<Vec<f64>> = vec![choices.iter().map(best).collect()];
    for (child, modes) in choices.iter().enumerate() {
        let known = out.clone();
        for mode in modes.iter().skip(1) {
            if out.len() + known.len() > width.max(1) {
                return out;
            }
            out.extend(known.iter().map(|depths| {
                let mut other = depths.clone();
                other[child] = mode.0;
                other
            }));
        }
    }
    out
}

/// All orders of 0..n, for small n.
fn permutations(n: usize, with: &mut impl FnMut(&[usize])) {
    fn go(order: &mut Vec<usize>, from: usize, with: &mut impl FnMut(&[usize])) {
        if from == order.len() {
            return with(order);
        }
        for i in from..order.len() {
            order.swap(from, i);
            go(order, from + 1, with);
            order.swap(from, i);
        }
    }
    go(&mut (0..n).collect(), 0, with);
}
