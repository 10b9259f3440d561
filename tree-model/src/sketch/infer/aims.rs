//! What each segment aims at within Ω.
//!
//! The likeliest depths give every branch the mean angle wherever the drawing allows it: an average tree, which no tree
//! is. So each segment gets an aim of its own, in standard deviations from the mean, and the posterior is largest where all
//! are met (perturb and maximise, Papandreou & Yuille 2011). Another seed gives another tree of the same habit.
//!
//! Aims must suit the drawing: a segment drawn long cannot be a short one. They are those of one tree that is drawn from the
//! posterior segment by segment from the root (ancestral sampling, section 4.6.1), as yet without competition and
//! crossings: the depth of each end is drawn from the density that Ω gives to its length ratio,
//! divergence, roll and bend. In x, y, z that density is p(ln s) p(α) p(γ) / (s³ sin α); the divisor makes laws of
//! angles and lengths come out as they are in Ω, where the product of Eq. 4.16 alone would favour depth.

use super::densities::{Densities, Density};
use super::factors::room;
use super::segments::{STEEPEST, Segments};
use crate::sketch::branches::Label;
use crate::sketch::frame::{across, angle, carried, roll, wrapped};
use crate::sketch::omega::{Habit, Normal, Omega};
use glam::DVec3;
use tree_core::Seed;

/// The quantities that Ω speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Scale,
    LateralScale,
    Alpha,
    Beta,
    Gamma,
}

impl Quantity {
    pub(super) const ALL: [Self; 5] =
        [Self::Scale, Self::LateralScale, Self::Alpha, Self::Beta, Self::Gamma];

    pub(super) fn of(self, habit: &Habit) -> Normal {
        match self {
            Self::Scale => habit.scale,
            Self::LateralScale => habit.lateral_scale,
            Self::Alpha => habit.alpha,
            Self::Beta => habit.beta,
            Self::Gamma => habit.gamma,
        }
    }

    pub(super) fn of_mut(self, habit: &mut Habit) -> &mut Normal {
        match self {
            Self::Scale => &mut habit.scale,
            Self::LateralScale => &mut habit.lateral_scale,
            Self::Alpha => &mut habit.alpha,
            Self::Beta => &mut habit.beta,
            Self::Gamma => &mut habit.gamma,
        }
    }

    /// Those of a segment under a label: length ratio and divergence.
    pub(super) fn under(label: Label) -> (Self, Self) {
        match label {
            Label::Apical => (Self::Scale, Self::Alpha),
            Label::Lateral(_) => (Self::LateralScale, Self::Beta),
        }
    }
}

/// No aim is farther from the mean than this many standard deviations.
const FARTHEST: f64 = 3.0;
/// Depths are drawn from so many slopes on each side of the plane.
const SLOPES: i32 = 40;
/// Angles are taken for at least this, in radians: at none the density in space has no bound.
const LEAST_ANGLE: f64 = 0.02;

/// Aims in standard deviations, five for each segment.
pub(super) struct Aims {
    rows: Vec<[f64; 5]>,
}

impl Aims {
    /// `bending` as in [`InferParams`](super::InferParams), `shortest` the least length of a segment.
    pub(super) fn draw(
        segments: &Segments,
        rooms: &[f64],
        template: &Omega,
        (spread, bending, shortest): (f64, f64, f64),
        seed: Seed,
    ) -> Self {
        let seed = seed.stream("aims");
        let row = |key: &[u64; 2]| {
            let mut rng = seed.child(key[0]).child(key[1]).rng();
            [0; 5].map(|_| f64::from(tree_core::seed::normal(&mut rng)))
        };
        let rows = segments.keys.iter().map(row).collect();
        let n = segments.len();
        let mut draft = Draft {
            segments,
            rooms,
            omega: Densities::of(template.clone()),
            seed,
            bending,
            shortest,
            rows,
            depths: vec![0.0; n],
            orders: vec![0; n],
            sides: vec![None; n],
        };
        (0..n).for_each(|parent| draft.fork(parent));
        let limited = |aim: f64| spread * aim.clamp(-FARTHEST, FARTHEST);
        Self { rows: draft.rows.into_iter().map(|row| row.map(limited)).collect() }
    }

    /// What segment `i` aims at.
    pub(super) fn of(&self, i: usize, quantity: Quantity) -> f64 {
        self.rows[i][quantity as usize]
    }

    /// A number from 0 to 1 that belongs to the whole sketch.
    pub(super) fn phase(seed: Seed) -> f64 {
        f64::from(seed.stream("stems").unit(0))
    }
}

/// One tree drawn from the posterior.
struct Draft<'a> {
    segments: &'a Segments,
    rooms: &'a [f64],
    omega: Densities,
    seed: Seed,
    bending: f64,
    shortest: f64,
    rows: Vec<[f64; 5]>,
    depths: Vec<f64>,
    orders: Vec<u32>,
    sides: Vec<Option<DVec3>>,
}

/// What a depth gives a segment: the quantities, and ln of the density.
struct Given {
    scale: f64,
    divergence: f64,
    roll: Option<f64>,
    ln: f64,
}

impl Draft<'_> {
    fn vector(&self, i: usize) -> DVec3 {
        let below = self.segments.parent(i).map_or(0.0, |parent| self.depths[parent]);
        self.segments.chord(i).extend(self.depths[i] - below)
    }

    /// Draws the children of a fork.
    fn fork(&mut self, parent: usize) {
        let children = self.segments.children(parent);
        let imagined = self.segments.imagined_root && parent == 0;
        if children.is_empty() || imagined {
            return;
        }
        let heir = self.heir(parent);
        let n_laterals = children.len() - usize::from(heir.is_some());
        let axis = self.vector(parent).normalize_or(DVec3::Y);
        let mut side = self.sides[parent];
        for &child in children {
            let c = child as usize;
            let label = if heir == Some(child) { Label::Apical } else { Label::Lateral(0) };
            let order = self.orders[parent];
            self.orders[c] = order + u32::from(label != Label::Apical);
            // In a whorl it is not known which lateral is which.
            let known = self.sides[parent].filter(|_| n_laterals == 1);
            self.place(c, label, order, known);
            if label != Label::Apical {
                side = across(self.vector(c), axis).or(side);
            }
        }
        if let (Some(heir), Some(side)) = (heir, side) {
            let along = self.vector(heir as usize).normalize_or(axis);
            self.sides[heir as usize] = Some(carried(side, axis, along));
        }
    }

    /// The child that continues the axis: that on the same stroke, else the one that bends least in the plane
    /// (section 4.8).
    fn heir(&self, parent: usize) -> Option<u32> {
        let children = self.segments.children(parent);
        let on_stroke =
            children.iter().copied().find(|&child| self.segments.through[child as usize]);
        let along = self.segments.chord(parent);
        let bend = |child: u32| self.segments.chord(child as usize).angle_to(along).abs();
        on_stroke.or_else(|| children.iter().copied().min_by(|&a, &b| bend(a).total_cmp(&bend(b))))
    }

    /// Draws the depth of a segment, and notes what it aims at.
    fn place(&mut self, i: usize, label: Label, order: u32, side: Option<DVec3>) {
        let base = self.segments.parent(i).map_or(0.0, |parent| self.depths[parent]);
        let length = self.segments.chord(i).length().max(self.shortest);
        let slope = |k: i32| {
            let share = f64::from(k) / f64::from(SLOPES);
            STEEPEST * share * (0.1 + 0.9 * share * share)
        };
        let mut total = 0.0;
        let mut sums = [0.0; 2 * SLOPES as usize + 1];
        for (sum, k) in sums.iter_mut().zip(-SLOPES..=SLOPES) {
            let width = slope(k + 1) - slope(k - 1);
            let ln = self.given(i, label, order, side, base + length * slope(k)).ln;
            // Around 1: densities are compared with each other only.
            total += width * libm::exp(ln.clamp(-300.0, 300.0));
            *sum = total;
        }
        let key = self.segments.keys[i];
        let unit = f64::from(self.seed.stream("depth").child(key[0]).unit(key[1]));
        let place = sums.partition_point(|&sum| sum < unit * total).min(sums.len() - 1);
        let depth = base + length * slope(place as i32 - SLOPES);
        self.depths[i] = depth;
        let given = self.given(i, label, order, side, depth);
        let (scale, divergence) = Quantity::under(label);
        let aim = |density: Density, value: f64| (value - density.mean) * density.narrowness;
        self.rows[i][scale as usize] = aim(self.omega.get(order, scale), given.scale);
        self.rows[i][divergence as usize] =
            aim(self.omega.get(order, divergence), given.divergence);
        if let Some(roll) = given.roll {
            let density = self.omega.get(order, Quantity::Gamma);
            self.rows[i][Quantity::Gamma as usize] =
                wrapped(roll - density.mean) * density.narrowness;
        }
    }

    fn given(&self, i: usize, label: Label, order: u32, side: Option<DVec3>, depth: f64) -> Given {
        let parent = self.segments.parent(i).unwrap_or(0);
        let along = self.vector(parent);
        let v = self.segments.chord(i).extend(depth - self.depths[parent]);
        let ratio = v.length().max(self.shortest) / along.length().max(self.shortest);
        let (scale, divergence) = (libm::log(ratio), angle(along, v));
        let (of_scale, of_divergence) = Quantity::under(label);
        let mut ln = self.omega.get(order, of_scale).ln(scale)
            + self.omega.get(order, of_divergence).ln(divergence);
        ln -= 3.0 * scale + libm::log(libm::sin(divergence).max(LEAST_ANGLE));
        let mut turn = None;
        if let (Label::Lateral(_), Some(side)) = (label, side) {
            let density = self.omega.get(order, Quantity::Gamma);
            let found = roll(along.normalize_or(DVec3::Y), side, v);
            ln += density.ln(density.mean + wrapped(found - density.mean));
            turn = Some(found);
        }
        if label == Label::Apical && self.segments.through[i] {
            let rise = |v: DVec3| libm::atan2(v.z, v.truncate().length());
            let bend = (rise(v) - rise(along)) / self.bending;
            ln -= 0.5 * bend * bend;
        }
        ln += room(self.segments, self.rooms, i, depth);
        Given { scale, divergence, roll: turn, ln }
    }
}
