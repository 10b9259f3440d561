//! Sets a planned twig on the tree: radii, then bending and growth from the base up.
//!
//! 1. From the tips down: radii by the pipe model, r₀^Δ = Σ rᵢ^Δ with taper between forks; then made
//!    thinner as a whole if the host asks for that.
//! 2. From the tips down: mass of wood and leaves beyond each internode, and its moment.
//! 3. From the base up: an internode of length L under the moment M sin θ bends by M L sin θ / (E I),
//!    with I = π r⁴ / 4 of a round rod and θ its angle from straight down (Euler and Bernoulli).
//!    Growth turns it by tropism × L × sin θ. Both are turns towards a direction at a rate of sin θ and
//!    are solved exactly, so that nothing bends beyond straight down however limp it is.
//!
//! Departure: levers are lengths along the twig, not their horizontal parts beyond the bend, so one
//! pass suffices. A twig that hangs already bends as if what it carries still stood out straight.

use super::params::TwigParams;
use super::plan::{Internode, level};
use crate::foliage::vector::{arc, turn_toward};
use glam::{Quat, Vec3};
use std::f64::consts::PI;

/// Green wood, in kilograms per cubic metre.
const WOOD_DENSITY: f64 = 900.0;
/// Gravity in metres per second squared.
const GRAVITY: f64 = 9.81;
/// Largest host radius that a twig's first internode is made longer by, to come out of the wood.
const THICKEST_HOST: f32 = 100.0;

/// One internode while it is set.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    /// Radius at its upper node, from the pipe model alone.
    radius: f64,
    /// Sum of the lower ends' radii above it to the exponent, the thickest, and how many.
    sum: f64,
    thickest: f64,
    n_above: u32,
    /// Mass above its upper node, and its moment about that node at a unit of gravity.
    mass: f64,
    moment: f64,
    rotation: Quat,
    position: Vec3,
}

/// Sets twigs, and keeps the memory for the next.
#[derive(Default)]
pub(super) struct Setter {
    states: Vec<State>,
}

impl Setter {
    /// Calls `emit` with position and radius of the upper node of each internode in order.
    pub(super) fn set(
        &mut self,
        params: &TwigParams,
        internodes: &[Internode],
        host: Vec3,
        host_radius: f32,
        mut emit: impl FnMut(Vec3, f32),
    ) {
        self.states.clear();
        self.states.resize(internodes.len(), State::default());
        let base = self.radii(params, internodes);
        let allowed = f64::from(host_radius) * f64::from(params.radius_share);
        let scale = if base > allowed { allowed / base } else { 1.0 };
        self.loads(params, internodes, scale);
        self.directions(params, internodes, scale, host, host_radius);
        for state in &self.states {
            // Rounding to f32 may go up.
            emit(state.position, ((state.radius * scale) as f32).min(host_radius));
        }
    }

    /// Step 1. Returns the radius of the lowest end.
    fn radii(&mut self, params: &TwigParams, internodes: &[Internode]) -> f64 {
        let exponent = f64::from(params.pipe_exponent);
        // In units of the tip radius: powers of numbers from 1 up cannot vanish.
        let unit = f64::from(params.tip_radius);
        let taper = f64::from(params.radius_taper) / unit;
        let mut base = 0.0_f64;
        for (i, internode) in internodes.iter().enumerate().rev() {
            let state = &mut self.states[i];
            state.radius = match state.n_above {
                0 => 1.0,
                1 => state.thickest,
                _ => libm::pow(state.sum, 1.0 / exponent).max(state.thickest),
            };
            let lower = state.radius + taper * f64::from(internode.length);
            match internode.below {
                Some(below) => self.states[below as usize].join(lower, exponent),
                None => base = base.max(lower * unit),
            }
        }
        for state in &mut self.states {
            state.radius *= unit;
        }
        base
    }

    /// Step 2.
    fn loads(&mut self, params: &TwigParams, internodes: &[Internode], scale: f64) {
        for (i, internode) in internodes.iter().enumerate().rev() {
            let state = self.states[i];
            let length = f64::from(internode.length);
            let area = PI * (scale * state.radius) * (scale * state.radius);
            let mass = length * (WOOD_DENSITY * area + f64::from(params.load));
            if let Some(below) = internode.below {
                let below = &mut self.states[below as usize];
                below.moment += state.moment + state.mass * length + 0.5 * mass * length;
                below.mass += state.mass + mass;
            }
        }
    }

    /// Step 3.
    fn directions(
        &mut self,
        params: &TwigParams,
        internodes: &[Internode],
        scale: f64,
        host: Vec3,
        host_radius: f32,
    ) {
        let light = params.light.normalize_or(Vec3::Y);
        let modulus = 1e9 * f64::from(params.stiffness);
        for (i, internode) in internodes.iter().enumerate() {
            let (below, from) = match internode.below {
                Some(below) => {
                    let below = self.states[below as usize];
                    (below.rotation, below.position)
                }
                None => (Quat::IDENTITY, host),
            };
            let state = &mut self.states[i];
            let mut rotation = (below * internode.turn).normalize();
            if internode.starts {
                rotation = level(rotation);
            }
            rotation *= internode.swing;
            let length = f64::from(internode.length);
            let radius = scale * (state.radius + 0.5 * f64::from(params.radius_taper) * length);
            let own = length * (WOOD_DENSITY * PI * radius * radius + f64::from(params.load));
            // The moment in the middle of the internode stands for all of it.
            let moment = state.moment + 0.5 * state.mass * length + 0.125 * own * length;
            let stiffness = modulus * 0.25 * PI * radius * radius * radius * radius;
            let bend = if moment > 0.0 { GRAVITY * moment * length / stiffness } else { 0.0 };
            let down = bend as f32 + params.gravitropism * internode.length;
            let straight = rotation * Vec3::Y;
            let turned = turn_toward(straight, Vec3::NEG_Y, down);
            let turned = turn_toward(turned, light, params.phototropism * internode.length);
            rotation = (arc(straight, turned) * rotation).normalize();
            // A first internode starts on the host's axis and must come out of its wood.
            let inside =
                if internode.below.is_none() { host_radius.min(THICKEST_HOST) } else { 0.0 };
            state.rotation = rotation;
            state.position = from + turned * (internode.length + inside);
        }
    }
}

impl State {
    fn join(&mut self, lower: f64, exponent: f64) {
        // A chain of nodes costs no power this way, and gathers none of their rounding errors.
        self.sum = match self.n_above {
            0 => 0.0,
            1 => libm::pow(self.thickest, exponent) + libm::pow(lower, exponent),
            _ => self.sum + libm::pow(lower, exponent),
        };
        self.thickest = self.thickest.max(lower);
        self.n_above += 1;
    }
}
