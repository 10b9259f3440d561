//! Ω, the global parameters of a tree (Neubert 2012, section 4.5), for each order of axes its own.
//!
//! Departures. Parameters vary with the order of the axis (section 4.9 names this as future work): a spruce's
//! trunk bears whorls at right angles, its branches flat sprays. Length ratios are normal in their logarithm, since twice
//! as long is as far as half as long, and a ratio is never negative. Laterals have a ratio of their own. Estimates are
//! median and quartiles, which single strange branches do not move.

use super::branches::{Branches, Label};
use super::frame::wrapped;
use super::relation::Relation;
use crate::error::{ModelError, Result};
use std::f64::consts::{PI, TAU};
use tree_core::check_parameter;

/// A normal distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Normal {
    /// Its mean μ.
    pub mean: f32,
    /// Its standard deviation σ, above 0.
    pub deviation: f32,
}

impl Normal {
    /// A distribution of this mean and standard deviation.
    #[must_use]
    pub const fn new(mean: f32, deviation: f32) -> Self {
        Self { mean, deviation }
    }
}

/// How axes of one order go on and branch. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Habit {
    /// Natural logarithm of the length of the apical segment over that of the segment below.
    pub scale: Normal,
    /// Natural logarithm of the length of a lateral's first segment over that of the segment below.
    pub lateral_scale: Normal,
    /// α: the angle between the apical segment and the segment below.
    pub alpha: Normal,
    /// β: the angle between a lateral and the segment below.
    pub beta: Normal,
    /// γ: the turn about the axis from one lateral to the next.
    pub gamma: Normal,
}

impl Default for Habit {
    /// A broad-leaved tree's: nearly straight axes, laterals at half a right angle in a golden spiral.
    fn default() -> Self {
        Self {
            scale: Normal::new(-0.1, 0.5),
            lateral_scale: Normal::new(0.3, 0.6),
            alpha: Normal::new(0.25, 0.15),
            beta: Normal::new(0.85, 0.25),
            gamma: Normal::new(2.4, 0.8),
        }
    }
}

/// Smallest deviations of ln-ratios, divergences and rolls: a normal narrower than a hand can draw only stiffens the
/// search.
const NARROWEST: [f32; 3] = [0.08, 0.035, 0.1];
/// Deviation of a roll that tells nothing: about that of angles spread evenly over a turn.
const ANY_ROLL: f64 = 1.8;
/// Orders told apart when Ω is fitted; higher ones follow the last.
const MOST_ORDERS: u32 = 3;
/// An order counts with so many imagined samples of all orders together, so that few samples decide little.
const BORROWED: f64 = 3.0;
/// Quartiles of the standard normal are this far apart.
const QUARTILES: f64 = 1.349;

/// Ω: a [`Habit`] for axes of order 0 (the trunk), 1 and so on; the last holds for all higher orders too.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Omega {
    /// The habits, at least one.
    pub orders: Vec<Habit>,
}

impl Default for Omega {
    fn default() -> Self {
        Self { orders: vec![Habit::default()] }
    }
}

impl Omega {
    /// The habit of axes of `order`.
    #[must_use]
    pub fn habit(&self, order: u32) -> Habit {
        let last = self.orders.last();
        self.orders.get(order as usize).or(last).copied().unwrap_or_default()
    }

    /// The same parameters for the whole tree, as in the thesis: those of the orders, averaged.
    #[must_use]
    pub fn without_orders(&self) -> Self {
        let n = self.orders.len().max(1) as f32;
        let mean = |of: fn(&Habit) -> Normal| {
            let sum =
                |part: fn(Normal) -> f32| self.orders.iter().map(|h| part(of(h))).sum::<f32>() / n;
            Normal::new(sum(|normal| normal.mean), sum(|normal| normal.deviation))
        };
        let habit = Habit {
            scale: mean(|h| h.scale),
            lateral_scale: mean(|h| h.lateral_scale),
            alpha: mean(|h| h.alpha),
            beta: mean(|h| h.beta),
            gamma: mean(|h| h.gamma),
        };
        Self { orders: vec![habit] }
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] without habits; [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        if self.orders.is_empty() {
            return Err(ModelError::Sketch {
                problem: "Ω has no habit: give at least one".into()
            });
        }
        for (order, habit) in self.orders.iter().enumerate() {
            let rows = [
                ("scale", habit.scale, -10.0, 10.0),
                ("lateral_scale", habit.lateral_scale, -10.0, 10.0),
                ("alpha", habit.alpha, 0.0, PI),
                ("beta", habit.beta, 0.0, PI),
                ("gamma", habit.gamma, -TAU, TAU),
            ];
            for (name, normal, min, max) in rows {
                check_parameter("mean", normal.mean, min, max)
                    .and_then(|()| {
                        check_parameter("deviation", normal.deviation, 1e-4_f32, 10.0_f32)
                    })
                    .map_err(|error| error.within(&format!("omega.orders[{order}].{name}")))?;
            }
        }
        Ok(())
    }

    /// Ω of a tree. Orders with few segments borrow from all orders together; what a tree does not show at all is
    /// [`Habit::default`]'s.
    ///
    /// # Complexity
    /// O(segments · log segments).
    #[must_use]
    pub fn fit(branches: &Branches) -> Self {
        Self::of_relations(&branches.relations())
    }

    /// Ω of relations, of one tree or many.
    #[must_use]
    pub fn of_relations(relations: &[Relation]) -> Self {
        let all = Samples::of(relations.iter());
        let pooled = all.habit(&Habit::default(), 0.0);
        let highest = relations.iter().map(|relation| relation.order).max().unwrap_or(0);
        let habit = |order: u32| {
            let last = order + 1 == MOST_ORDERS;
            let own = relations.iter().filter(|r| r.order == order || (last && r.order > order));
            Samples::of(own).habit(&pooled, BORROWED)
        };
        Self { orders: (0..=highest.min(MOST_ORDERS - 1)).map(habit).collect() }
    }
}

/// The samples of one order.
#[derive(Default)]
struct Samples {
    scale: Vec<f64>,
    lateral_scale: Vec<f64>,
    alpha: Vec<f64>,
    beta: Vec<f64>,
    gamma: Vec<f64>,
}

impl Samples {
    fn of<'a>(relations: impl Iterator<Item = &'a Relation>) -> Self {
        let mut samples = Self::default();
        for relation in relations {
            if relation.label == Label::Apical {
                samples.scale.push(relation.scale);
                samples.alpha.push(relation.divergence);
            } else {
                samples.lateral_scale.push(relation.scale);
                samples.beta.push(relation.divergence);
            }
            samples.gamma.extend(relation.roll);
        }
        samples
    }

    /// Each distribution, with `borrowed` imagined samples of `usual`.
    fn habit(mut self, usual: &Habit, borrowed: f64) -> Habit {
        let [ratio, divergence, turn] = NARROWEST;
        let line = |values: &mut Vec<f64>, usual: Normal, least: f32| {
            let found = quartiles(values).unwrap_or((usual.mean.into(), usual.deviation.into()));
            mixed(found, values.len() as f64, usual, borrowed, least)
        };
        let turns = match circular(&self.gamma) {
            Some((mean, deviation)) => {
                // Towards the usual the shorter way round.
                let usual_mean = mean + wrapped(f64::from(usual.gamma.mean) - mean);
                let usual = Normal::new(usual_mean as f32, usual.gamma.deviation);
                let mut normal =
                    mixed((mean, deviation), self.gamma.len() as f64, usual, borrowed, turn);
                normal.mean = wrapped(normal.mean.into()) as f32;
                normal
            }
            None => usual.gamma,
        };
        Habit {
            scale: line(&mut self.scale, usual.scale, ratio),
            lateral_scale: line(&mut self.lateral_scale, usual.lateral_scale, ratio),
            alpha: line(&mut self.alpha, usual.alpha, divergence),
            beta: line(&mut self.beta, usual.beta, divergence),
            gamma: turns,
        }
    }
}

/// What `n` samples found, with `borrowed` imagined samples of `usual`.
fn mixed(found: (f64, f64), n: f64, usual: Normal, borrowed: f64, least: f32) -> Normal {
    let share = if n > 0.0 { borrowed / (n + borrowed) } else { 1.0 };
    let mix = |own: f64, usual: f32| (own + share * (f64::from(usual) - own)) as f32;
    Normal::new(mix(found.0, usual.mean), mix(found.1, usual.deviation).max(least))
}

/// Median and the deviation that quartiles tell; `None` without samples.
fn quartiles(values: &mut [f64]) -> Option<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let place = share * (values.len() - 1) as f64;
        let (low, rest) = (place.floor() as usize, place.fract());
        let high = (low + 1).min(values.len() - 1);
        values[low] + rest * (values[high] - values[low])
    };
    (!values.is_empty()).then(|| (at(0.5), (at(0.75) - at(0.25)) / QUARTILES))
}

/// Mean direction and circular standard deviation; `None` without samples.
fn circular(angles: &[f64]) -> Option<(f64, f64)> {
    if angles.is_empty() {
        return None;
    }
    let n = angles.len() as f64;
    let sum = |of: fn(f64) -> f64| angles.iter().map(|&angle| of(angle)).sum::<f64>() / n;
    let (x, y) = (sum(libm::cos), sum(libm::sin));
    let resultant = (x * x + y * y).sqrt().clamp(1e-6, 1.0);
    Some((libm::atan2(y, x), (-2.0 * libm::log(resultant)).sqrt().min(ANY_ROLL)))
}
