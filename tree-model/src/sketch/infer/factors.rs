//! The factors `f(v_c, v_p, l | Ω)` between a segment and its parent (Eq. 4.16), as logarithms.
//!
//! Each is a normal density of length ratio, divergence or roll about what the segment [aims](super::aims) at. Departures: its
//! tails are heavier (redescending; Geman 1985), so that a branch no template explains does not wrench its depth; to the factors of the
//! thesis come two for strokes: they rather go on as the same axis, and do not bend to and fro in depth.

use super::aims::{Aims, Quantity};
use super::densities::{Densities, Density, HALF_LN_TAU};
use super::params::InferParams;
use super::segments::Segments;
use crate::sketch::branches::Label;
use crate::sketch::frame::{across, angle, carried, roll, wrapped};
use crate::sketch::omega::{Normal, Omega};
use glam::DVec3;
use std::f64::consts::TAU;
use tree_core::Seed;

/// Residuals beyond so many standard deviations hardly count any more.
const OUTLIER: f64 = 3.0;
/// Segments are at least this share of the drawing's size long: a stroke that ends where it began has no direction.
const SHORTEST: f64 = 1e-4;
/// How stems that rise from one base diverge from the vertical, and how evenly they spread about it: a shrub's.
const STEMS: Normal = Normal::new(0.4, 0.25);
const STEM_ROLL: Normal = Normal::new(0.0, 0.6);
/// An axis is followed down over so many forks without laterals to find the last one's side.
const FARTHEST_SIDE: usize = 4;

/// One normal term of a factor. Turns are unwound to be nearest to what is aimed at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// `None` for constants of ours that Ω does not contain.
    pub(super) quantity: Option<Quantity>,
    pub(super) order: u32,
    pub(super) value: f64,
    pub(super) aim: f64,
    pub(super) ln: f64,
}

/// The fork at the end of a segment, as its children see it.
#[derive(Clone, Copy)]
pub(super) struct Fork {
    pub(super) parent: usize,
    pub(super) order: u32,
    pub(super) n_laterals: usize,
    /// Segment before the fork, and its direction.
    pub(super) along: DVec3,
    pub(super) axis: DVec3,
    /// Where the axis' last lateral left, carried to here.
    pub(super) side: Option<DVec3>,
}

/// Weight of a residual in a weighted least-squares step that cannot lower the sum of [`robust`].
pub(super) fn weight(residual: f64) -> f64 {
    let share = 1.0 + residual * residual / (OUTLIER * OUTLIER);
    1.0 / (share * share)
}

/// ln of the factor that keeps an end in the crown: 0 inside.
pub(super) fn room(segments: &Segments, rooms: &[f64], i: usize, depth: f64) -> f64 {
    /// An end outside by this share of the drawing's size is a standard deviation off.
    const SOFTNESS: f64 = 0.003;
    let out = (depth.abs() - rooms[i]).max(0.0) / (SOFTNESS * segments.extent);
    -0.5 * out * out
}

/// ½ r² for small r, levelling off.
pub(super) fn robust(residual: f64) -> f64 {
    let square = residual * residual;
    0.5 * square / (1.0 + square / (OUTLIER * OUTLIER))
}

/// All that factors need and that does not change while depths and labels are sought.
pub(super) struct Factors {
    /// How deep the crown is at each segment's end; no end where none is drawn.
    pub(super) rooms: Vec<f64>,
    pub(super) segments: Segments,
    pub(super) aims: Aims,
    pub(super) follow: f64,
    bending: f64,
    shortest: f64,
    phase: f64,
}

impl Factors {
    pub(super) fn new(
        segments: Segments,
        rooms: Vec<f64>,
        template: &Omega,
        params: &InferParams,
        seed: Seed,
    ) -> Self {
        let shortest = SHORTEST * segments.extent;
        let how = (params.spread.into(), params.bending.into(), shortest);
        let aims = Aims::draw(&segments, &rooms, template, how, seed);
        Self {
            rooms,
            aims,
            follow: params.follow.into(),
            bending: params.bending.into(),
            shortest,
            phase: Aims::phase(seed),
            segments,
        }
    }

    /// vᵢ in space.
    pub(super) fn vector(&self, depths: &[f64], i: usize) -> DVec3 {
        let below = self.segments.parent(i).map_or(0.0, |parent| depths[parent]);
        self.segments.chord(i).extend(depths[i] - below)
    }

    fn is_imagined(&self, segment: usize) -> bool {
        segment == 0 && self.segments.imagined_root
    }

    /// The fork at the end of `parent`, whose axis has this order.
    pub(super) fn fork(&self, depths: &[f64], labels: &[Label], order: u32, parent: usize) -> Fork {
        let along = self.vector(depths, parent);
        let axis = along.normalize_or(DVec3::Y);
        let children = self.segments.children(parent);
        let n_laterals = children.iter().filter(|&&c| labels[c as usize] != Label::Apical).count();
        let side = if self.is_imagined(parent) {
            Some(DVec3::X)
        } else {
            self.side(depths, labels, parent, 0)
        };
        Fork { parent, order, n_laterals, along, axis, side }
    }

    /// Where the last lateral left, below the end of `segment`, carried along the axis to that end.
    fn side(
        &self,
        depths: &[f64],
        labels: &[Label],
        segment: usize,
        steps: usize,
    ) -> Option<DVec3> {
        let below = self.segments.parent(segment)?;
        if labels[segment] != Label::Apical || steps == FARTHEST_SIDE || self.is_imagined(below) {
            return None;
        }
        let from = self.vector(depths, below).normalize_or(DVec3::Y);
        let to = self.vector(depths, segment).normalize_or(from);
        let lateral = self.lateral_at(labels, below);
        let side = match lateral {
            Some(lateral) => across(self.vector(depths, lateral), from),
            None => self.side(depths, labels, below, steps + 1),
        };
        Some(carried(side?, from, to))
    }

    /// The first lateral at the end of a segment.
    fn lateral_at(&self, labels: &[Label], segment: usize) -> Option<usize> {
        let mut children = self.segments.children(segment).iter().map(|&child| child as usize);
        children.find(|&child| labels[child] == Label::Lateral(0))
    }

    /// Calls `with` for every segment whose end the factor of `i` depends on.
    pub(super) fn depends(&self, labels: &[Label], i: usize, mut with: impl FnMut(usize)) {
        let both = |segment: usize, with: &mut dyn FnMut(usize)| {
            with(segment);
            if let Some(parent) = self.segments.parent(segment) {
                with(parent);
            }
        };
        let Some(parent) = self.segments.parent(i) else { return with(i) };
        with(i);
        both(parent, &mut with);
        if labels[i] == Label::Apical {
            return;
        }
        let mut segment = parent;
        for _ in 0..FARTHEST_SIDE {
            let Some(below) = self.segments.parent(segment) else { return };
            if labels[segment] != Label::Apical || self.is_imagined(below) {
                return;
            }
            both(below, &mut with);
            if let Some(lateral) = self.lateral_at(labels, below) {
                return with(lateral);
            }
            segment = below;
        }
    }

    /// The terms of a child at a fork; returns how many there are.
    pub(super) fn terms(
        &self,
        omega: &Densities,
        fork: &Fork,
        v: DVec3,
        i: usize,
        label: Label,
    ) -> ([Term; 3], usize) {
        let mut list = Terms { rows: [EMPTY; 3], n: 0, order: fork.order };
        if self.is_imagined(fork.parent) {
            list.put(
                None,
                Density::of(STEMS),
                angle(fork.along, v),
                self.aims.of(i, Quantity::Beta),
            );
            if let Label::Lateral(place) = label {
                let turn = TAU * (self.phase + f64::from(place) / fork.n_laterals as f64);
                list.put_turn(
                    None,
                    Density::of(STEM_ROLL),
                    roll(DVec3::Y, DVec3::X, v) - turn,
                    0.0,
                );
            }
            return (list.rows, list.n);
        }
        let density = |quantity| omega.get(fork.order, quantity);
        let (scale, divergence) = Quantity::under(label);
        let aim = |quantity| self.aims.of(i, quantity);
        let length = v.length().max(self.shortest) / fork.along.length().max(self.shortest);
        list.put(Some(scale), density(scale), libm::log(length), aim(scale));
        list.put(Some(divergence), density(divergence), angle(fork.along, v), aim(divergence));
        if let (Label::Lateral(place), Some(side)) = (label, fork.side) {
            let share = f64::from(place) / fork.n_laterals as f64;
            let turn = roll(fork.axis, side, v) - TAU * share;
            list.put_turn(
                Some(Quantity::Gamma),
                density(Quantity::Gamma),
                turn,
                aim(Quantity::Gamma),
            );
        }
        (list.rows, list.n)
    }

    /// What the factors for strokes add.
    pub(super) fn along_stroke(&self, fork: &Fork, v: DVec3, i: usize, label: Label) -> f64 {
        if label != Label::Apical || !self.segments.through[i] {
            return 0.0;
        }
        let rise = |v: DVec3| libm::atan2(v.z, v.truncate().length());
        let bend = (rise(v) - rise(fork.along)) / self.bending;
        self.follow - robust(bend) - libm::log(self.bending) - HALF_LN_TAU
    }

    /// ln f of a child at a fork.
    pub(super) fn child(
        &self,
        omega: &Densities,
        fork: &Fork,
        v: DVec3,
        i: usize,
        label: Label,
    ) -> f64 {
        let (terms, n) = self.terms(omega, fork, v, i, label);
        terms[..n].iter().map(|term| term.ln).sum::<f64>() + self.along_stroke(fork, v, i, label)
    }

    /// ln f of segment `i`; 0 for the root.
    pub(super) fn segment(
        &self,
        omega: &Densities,
        depths: &[f64],
        labels: &[Label],
        orders: &[u32],
        i: usize,
    ) -> f64 {
        let Some(parent) = self.segments.parent(i) else { return 0.0 };
        let fork = self.fork(depths, labels, orders[parent], parent);
        self.child(omega, &fork, self.vector(depths, i), i, labels[i])
    }

    /// Gravelius order of a child: stems of a shrub are of order 0, all of them.
    pub(super) fn order(&self, below: u32, parent: usize, label: Label) -> u32 {
        below + u32::from(label != Label::Apical && !self.is_imagined(parent))
    }

    /// Gravelius orders by the labels.
    pub(super) fn orders(&self, labels: &[Label]) -> Vec<u32> {
        let mut orders = vec![0_u32; labels.len()];
        for i in 0..labels.len() {
            if let Some(parent) = self.segments.parent(i) {
                orders[i] = self.order(orders[parent], parent, labels[i]);
            }
        }
        orders
    }
}

const EMPTY: Term = Term { quantity: None, order: 0, value: 0.0, aim: 0.0, ln: 0.0 };

struct Terms {
    rows: [Term; 3],
    n: usize,
    order: u32,
}

impl Terms {
    fn put(&mut self, quantity: Option<Quantity>, density: Density, value: f64, aim: f64) {
        let residual = (value - density.mean) * density.narrowness - aim;
        let ln = density.top - robust(residual);
        self.rows[self.n] = Term { quantity, order: self.order, value, aim, ln };
        self.n += 1;
    }

    /// A turn: whole ones make no difference.
    fn put_turn(&mut self, quantity: Option<Quantity>, density: Density, turn: f64, aim: f64) {
        let aimed = density.mean + density.deviation * aim;
        self.put(quantity, density, aimed + wrapped(turn - aimed), aim);
    }
}
