//! The M-step: Ω as the average and variance of what depths and labels found show (Eq. 4.25).
//!
//! The template takes part as a number of imagined segments: without, as in the thesis, variances shrink from round to round on
//! sketches of few branches. Outliers count less, by the weights of the heavy-tailed factors. Each parameter is
//! taken where it raises the posterior; where average and variance do not, the mean that suits the aims best may. So no
//! step can lower it.
//!
//! Departure: the largest posterior itself would be at too small a variance, as aims are met more closely than chance would.

use super::aims::Quantity;
use super::densities::Densities;
use super::factors::{robust, weight};
use super::posterior::{Graph, State};
use crate::sketch::frame::wrapped;
use crate::sketch::omega::{Normal, Omega};
use std::f64::consts::PI;

/// Deviations stay within this: below, single branches would decide alone; above, nothing is told.
const DEVIATIONS: (f64, f64) = (0.02, 3.0);

/// Ω as the template has it, and how much that weighs.
pub(super) struct OmegaPrior {
    template: Omega,
    weight: f64,
}

/// A value that a segment shows of one parameter, and its aim in deviations.
type Sample = (f64, f64);

impl OmegaPrior {
    pub(super) fn new(template: &Omega, weight: f64) -> Self {
        Self { template: template.clone(), weight }
    }

    /// ln p(Ω | template), up to a constant: normal in each mean and in the logarithm of each deviation.
    pub(super) fn ln(&self, omega: &Omega) -> f64 {
        let habits = omega.orders.iter().zip(&self.template.orders);
        habits
            .flat_map(|(habit, usual)| Quantity::ALL.map(|q| self.ln_of(q.of(habit), q.of(usual))))
            .sum()
    }

    fn ln_of(&self, now: Normal, usual: Normal) -> f64 {
        let off = f64::from((now.mean - usual.mean) / usual.deviation);
        let wider = libm::log(f64::from(now.deviation / usual.deviation));
        -self.weight * (0.5 * off * off + wider * wider)
    }

    /// The M-step.
    pub(super) fn estimate(&self, graph: &Graph, omega: &Densities, state: &State) -> Omega {
        let last = omega.omega.orders.len().saturating_sub(1);
        let mut samples = vec![[const { Vec::<Sample>::new() }; 5]; omega.omega.orders.len()];
        graph.terms(omega, state, |quantity, order, value, aim| {
            samples[(order as usize).min(last)][quantity as usize].push((value, aim));
        });
        let mut next = omega.omega.clone();
        let habits = next.orders.iter_mut().zip(&self.template.orders).zip(&samples);
        for ((habit, usual), samples) in habits {
            for quantity in Quantity::ALL {
                let samples = &samples[quantity as usize];
                let (now, usual) = (quantity.of(habit), quantity.of(usual));
                *quantity.of_mut(habit) = self.better(quantity, samples, now, usual);
            }
        }
        next
    }

    /// The best of the parameter as it is, average and variance, and the mean that suits the aims.
    fn better(&self, quantity: Quantity, samples: &[Sample], now: Normal, usual: Normal) -> Normal {
        let value = |normal: Normal| {
            let part: f64 = samples.iter().map(|&sample| ln(quantity, normal, sample)).sum();
            part + self.ln_of(normal, usual)
        };
        let limit = |mean: f64, deviation: f64| {
            let mean = match quantity {
                Quantity::Alpha | Quantity::Beta => mean.clamp(0.0, PI),
                Quantity::Gamma => wrapped(mean),
                _ => mean.clamp(-10.0, 10.0),
            };
            Normal::new(mean as f32, deviation.clamp(DEVIATIONS.0, DEVIATIONS.1) as f32)
        };
        let (mut best, mut most) = (now, value(now));
        let moments = self.moments(samples, now, usual);
        let suited = self.suited(samples, now, usual);
        for candidate in [limit(moments.0, moments.1), limit(suited, now.deviation.into())] {
            let found = value(candidate);
            if found > most {
                (best, most) = (candidate, found);
            }
        }
        best
    }

    /// Weighted average and deviation, the template's imagined segments among them.
    fn moments(&self, samples: &[Sample], now: Normal, usual: Normal) -> (f64, f64) {
        let (usual_mean, usual_deviation) = (f64::from(usual.mean), f64::from(usual.deviation));
        let mut w = self.weight;
        let mut sum = w * usual_mean;
        let mut squares = w * (usual_mean * usual_mean + usual_deviation * usual_deviation);
        for &(value, _) in samples {
            let share = weight((value - f64::from(now.mean)) / f64::from(now.deviation));
            w += share;
            sum += share * value;
            squares += share * value * value;
        }
        let mean = sum / w;
        (mean, (squares / w - mean * mean).max(0.0).sqrt())
    }

    /// The mean at which the aims are met best with the deviation as it is.
    fn suited(&self, samples: &[Sample], now: Normal, usual: Normal) -> f64 {
        let (mean, deviation) = (f64::from(now.mean), f64::from(now.deviation));
        let pull =
            self.weight * deviation * deviation / f64::from(usual.deviation * usual.deviation);
        let (mut w, mut sum) = (pull, pull * f64::from(usual.mean));
        for &(value, aim) in samples {
            let share = weight((value - mean) / deviation - aim);
            w += share;
            sum += share * (value - deviation * aim);
        }
        sum / w
    }
}

/// ln of one sample's density.
fn ln(quantity: Quantity, normal: Normal, (value, aim): Sample) -> f64 {
    let (mean, deviation) = (f64::from(normal.mean), f64::from(normal.deviation));
    let mut off = value - mean - deviation * aim;
    if quantity == Quantity::Gamma {
        off = wrapped(off);
    }
    -robust(off / deviation) - libm::log(deviation)
}
