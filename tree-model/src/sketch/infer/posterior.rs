//! The posterior p(Z, L | X, Y, Ω) as one number (Eq. 4.17 with Eq. 4.22), and what of it changes with one depth.

use super::aims::Quantity;
use super::densities::Densities;
use super::factors::{Factors, room};
use super::near::Near;
use super::omega_step::OmegaPrior;
use super::segments::Segments;
use crate::sketch::branches::Label;

/// Depths and labels: what is inferred.
#[derive(Clone, Debug)]
pub(super) struct State {
    /// Depth of each segment's end in metres; the root's is 0.
    pub(super) depths: Vec<f64>,
    pub(super) labels: Vec<Label>,
}

/// The posterior's logarithm, part by part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Posterior {
    /// Sum of the factors between segments and their parents (Eq. 4.17).
    pub branches: f64,
    /// Competition for space (Eq. 4.22), and what ends outside the drawn crown cost.
    pub competition: f64,
    /// Branches that cross without room, 0 where none does.
    pub crossings: f64,
    /// Ω, seen from the template.
    pub omega: f64,
}

impl Posterior {
    /// The whole: the sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.branches + self.competition + self.crossings + self.omega
    }
}

/// Everything that stays while depths and labels change.
pub(super) struct Graph {
    pub(super) factors: Factors,
    pub(super) near: Near,
    pub(super) prior: OmegaPrior,
    /// Pairs and crossings that change with each segment's depth.
    pairs: Rows,
    crossings: Rows,
    /// Where inference begins.
    pub(super) start: State,
    /// Depths that stay as they are.
    pub(super) pinned: Vec<bool>,
}

/// For each segment a list, in compressed rows.
pub(super) struct Rows {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Rows {
    /// Of (row, item) in any order; repeated ones once.
    pub(super) fn of(n: usize, mut entries: Vec<(u32, u32)>) -> Self {
        entries.sort_unstable();
        entries.dedup();
        let mut starts = vec![0_u32; n + 1];
        for &(row, _) in &entries {
            starts[row as usize + 1] += 1;
        }
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        Self { starts, items: entries.into_iter().map(|(_, item)| item).collect() }
    }

    pub(super) fn get(&self, row: usize) -> &[u32] {
        &self.items[self.starts[row] as usize..self.starts[row + 1] as usize]
    }
}

/// What labels decide: orders, and which factors change with each depth.
pub(super) struct Wiring {
    pub(super) orders: Vec<u32>,
    factors: Rows,
}

impl Graph {
    pub(super) fn new(
        factors: Factors,
        near: Near,
        prior: OmegaPrior,
        start: State,
        pinned: Vec<bool>,
    ) -> Self {
        let segments = &factors.segments;
        let n = segments.len();
        let mut pairs = Vec::with_capacity(3 * near.pairs.len());
        for (item, pair) in near.pairs.iter().enumerate() {
            let parent = segments.parent(pair.other as usize).map(|parent| parent as u32);
            let ends = [Some(pair.end), Some(pair.other), parent];
            pairs.extend(ends.into_iter().flatten().map(|segment| (segment, item as u32)));
        }
        let mut crossings = Vec::new();
        for (item, crossing) in near.crossings.iter().enumerate() {
            for (segment, _) in [crossing.a, crossing.b] {
                let parent = segments.parent(segment as usize).map(|parent| parent as u32);
                crossings.extend(
                    [Some(segment), parent].into_iter().flatten().map(|s| (s, item as u32)),
                );
            }
        }
        let (pairs, crossings) = (Rows::of(n, pairs), Rows::of(n, crossings));
        Self { factors, near, prior, pairs, crossings, start, pinned }
    }

    pub(super) fn segments(&self) -> &Segments {
        &self.factors.segments
    }

    pub(super) fn wiring(&self, labels: &[Label]) -> Wiring {
        let mut entries = Vec::with_capacity(8 * labels.len());
        for i in 0..labels.len() {
            self.factors.depends(labels, i, |segment| entries.push((segment as u32, i as u32)));
        }
        Wiring { orders: self.factors.orders(labels), factors: Rows::of(labels.len(), entries) }
    }

    /// The part of the posterior that changes with the depth of `segment`.
    pub(super) fn around(
        &self,
        omega: &Densities,
        state: &State,
        wiring: &Wiring,
        segment: usize,
    ) -> f64 {
        let State { depths, labels } = state;
        let factor =
            |&i: &u32| self.factors.segment(omega, depths, labels, &wiring.orders, i as usize);
        let factors: f64 = wiring.factors.get(segment).iter().map(factor).sum();
        factors + self.shared(depths, segment)
    }

    /// Competition and crossings that change with the depth of `segment`.
    pub(super) fn shared(&self, depths: &[f64], segment: usize) -> f64 {
        let (segments, near) = (self.segments(), &self.near);
        let pairs = self
            .pairs
            .get(segment)
            .iter()
            .map(|&i| near.pair(segments, depths, &near.pairs[i as usize]));
        pairs.sum::<f64>() + self.crossed(depths, segment) + self.room(depths, segment)
    }

    /// What the crown has to say on the end of `segment`.
    pub(super) fn room(&self, depths: &[f64], segment: usize) -> f64 {
        room(self.segments(), &self.factors.rooms, segment, depths[segment])
    }

    /// Crossings that change with the depth of `segment`.
    pub(super) fn crossed(&self, depths: &[f64], segment: usize) -> f64 {
        let (segments, near) = (self.segments(), &self.near);
        let rows = self.crossings.get(segment).iter();
        rows.map(|&i| near.crossing(segments, depths, &near.crossings[i as usize])).sum()
    }

    /// Crossings of `segment` with segments before it.
    pub(super) fn crossed_before(&self, depths: &[f64], segment: usize) -> f64 {
        let (segments, near) = (self.segments(), &self.near);
        let rows = self.crossings.get(segment).iter().map(|&i| &near.crossings[i as usize]);
        rows.filter(|c| c.b.0 as usize == segment).map(|c| near.crossing(segments, depths, c)).sum()
    }

    /// The whole posterior.
    pub(super) fn posterior(&self, omega: &Densities, state: &State) -> Posterior {
        let (segments, near) = (self.segments(), &self.near);
        let State { depths, labels } = state;
        let orders = self.factors.orders(labels);
        let factor = |i| self.factors.segment(omega, depths, labels, &orders, i);
        Posterior {
            branches: (0..segments.len()).map(factor).sum(),
            competition: near
                .pairs
                .iter()
                .map(|pair| near.pair(segments, depths, pair))
                .sum::<f64>()
                + (0..segments.len()).map(|i| self.room(depths, i)).sum::<f64>(),
            crossings: near.crossings.iter().map(|c| near.crossing(segments, depths, c)).sum(),
            omega: self.prior.ln(&omega.omega),
        }
    }

    pub(super) fn total(&self, omega: &Densities, state: &State) -> f64 {
        self.posterior(omega, state).total()
    }

    /// Every term of Ω in the factors, with the values they see.
    pub(super) fn terms(
        &self,
        omega: &Densities,
        state: &State,
        mut with: impl FnMut(Quantity, u32, f64, f64),
    ) {
        let State { depths, labels } = state;
        let orders = self.factors.orders(labels);
        for i in 1..self.segments().len() {
            let Some(parent) = self.segments().parent(i) else { continue };
            let fork = self.factors.fork(depths, labels, orders[parent], parent);
            let v = self.factors.vector(depths, i);
            let (terms, n) = self.factors.terms(omega, &fork, v, i, labels[i]);
            for term in &terms[..n] {
                if let Some(quantity) = term.quantity {
                    with(quantity, term.order, term.value, term.aim);
                }
            }
        }
    }
}
