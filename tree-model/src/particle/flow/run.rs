//! The simulation (Neubert 2012, Algorithm 1): move, then join what is close, until all are at the base.

use super::force::Forces;
use super::integrate::{State, advance};
use super::near::Cells;
use super::params::FlowParams;
use super::trace::{Growing, Traces};
use crate::error::{Result, check, check_finite};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// Particles moved by one task.
const CHUNK: usize = 128;
/// Steps between two looks for the neighbour that pulls: it rarely changes in so short a time.
const LOOK_EVERY: u32 = 6;
/// After [`FlowParams::steps`], particles are steered home for as many times as many steps, and no more.
const EXTRA: u32 = 3;
/// Within so many join distances of the base a particle has arrived.
const ARRIVAL: f32 = 1.5;
/// The way of turning is at most this share of the distance to the base.
const TURN_SHARE: f32 = 0.5;
/// A node is also left behind where the course has turned so far since the last: cosine of the angle.
const TURN_COS: f32 = 0.94;

/// Traces and what became of the particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Flow {
    /// The traces.
    pub traces: Traces,
    /// What happened.
    pub report: FlowReport,
}

/// What happened to the particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct FlowReport {
    /// Particles that started.
    pub n_particles: u32,
    /// Joins of two particles.
    pub n_joins: u32,
    /// Particles that joined a trace whose particle had gone on.
    pub n_followed: u32,
    /// Particles, after joins, that reached the base on traces of their own.
    pub n_arrived: u32,
    /// Particles that were still on their way after [`FlowParams::steps`] and were steered to the base without
    /// heed to the images.
    pub n_steered: u32,
    /// Particles that could not even be steered and were led straight to the nearest trace.
    pub n_led: u32,
    /// Steps taken.
    pub n_steps: u32,
    /// Parts that the Runge-Kutta method cut all steps of all particles into.
    pub n_parts: u64,
}

#[derive(Clone, Copy, Debug)]
struct Particle {
    number: u32,
    state: State,
    mass: f32,
    /// Last node left behind, and the direction there.
    last: u32,
    heading: Vec3,
    /// Way since then.
    way: f32,
    /// What pulls: where it was when last seen, its velocity, and the share of the pull.
    near: Option<(Vec3, Vec3, f32)>,
}

/// Lets particles flow from `starts` to the origin and returns their traces; `height` is the tree's in metres.
///
/// The same starts give the same bits for any number of threads.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter), [`ModelError::NotFinite`](crate::ModelError::NotFinite),
/// [`ModelError::Limit`](crate::ModelError::Limit) when the traces have more nodes than allowed,
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(steps × particles still apart); they join as they go, so that twice as many cost less than twice as much
/// once they are dense.
pub fn run(
    starts: &[Vec3],
    height: f32,
    forces: &Forces<'_>,
    params: &FlowParams,
    control: &Control,
) -> Result<Flow> {
    params.validate()?;
    check("height", height, 1e-3_f32, 1e5_f32)?;
    for (i, &start) in starts.iter().enumerate() {
        check_finite(format!("starts[{i}]"), start)?;
    }
    control.limits.check(Resource::Nodes, starts.len() as u64 + 1)?;
    let mut simulation = Simulation::new(starts, height, forces, params);
    for step in 0..params.steps.saturating_mul(1 + EXTRA) {
        if simulation.particles.is_empty() {
            break;
        }
        if step == params.steps {
            simulation.report.n_steered = simulation.particles.len() as u32;
        }
        control.report("particles", (step as f32 / params.steps as f32).min(1.0))?;
        simulation.step(step, step >= params.steps);
        control.limits.check(Resource::Nodes, simulation.traces.len() as u64)?;
    }
    simulation.lead_the_rest();
    Ok(Flow { traces: simulation.traces.finish(), report: simulation.report })
}

struct Simulation<'a> {
    particles: Vec<Particle>,
    traces: Growing,
    report: FlowReport,
    cells: Cells,
    forces: &'a Forces<'a>,
    params: &'a FlowParams,
    height: f32,
}

impl<'a> Simulation<'a> {
    fn new(starts: &[Vec3], height: f32, forces: &'a Forces<'a>, params: &'a FlowParams) -> Self {
        let traces = Growing::new(starts, params.join * height);
        let particles = (0_u32..).zip(starts).map(|(number, &position)| {
            let velocity = forces.direction(position, None);
            Particle {
                number,
                state: State { position, velocity },
                mass: 1.0,
                // Node 0 is the base.
                last: number + 1,
                heading: velocity,
                way: 0.0,
                near: None,
            }
        });
        Self {
            particles: particles.collect(),
            traces,
            report: FlowReport { n_particles: starts.len() as u32, ..Default::default() },
            cells: Cells::default(),
            forces,
            params,
            height,
        }
    }

    fn step(&mut self, number: u32, homewards: bool) {
        if number.is_multiple_of(LOOK_EVERY) && !homewards && self.params.neighbour > 0.0 {
            self.look();
        }
        self.advance(homewards);
        self.join();
        self.follow();
        self.leave_nodes();
        self.report.n_steps = number + 1;
    }

    fn positions(&self) -> impl ExactSizeIterator<Item = Vec3> + Clone + '_ {
        self.particles.iter().map(|particle| particle.state.position)
    }

    /// Finds what pulls each particle.
    fn look(&mut self) {
        let sight = self.params.sight * self.height;
        let mut cells = std::mem::take(&mut self.cells);
        cells.fill(self.positions(), self.params.join * self.height);
        let found: Vec<_> = self
            .particles
            .par_iter()
            .with_min_len(CHUNK)
            .enumerate()
            .map(|(i, particle)| {
                let (other, square) = cells.nearest(i as u32, particle.state.position, sight)?;
                let other = &self.particles[other as usize].state;
                let share = 1.0 - square.sqrt() / sight.max(f32::MIN_POSITIVE);
                Some((other.position, other.velocity, share))
            })
            .collect();
        for (particle, near) in self.particles.iter_mut().zip(found) {
            particle.near = near;
        }
        self.cells = cells;
    }

    fn advance(&mut self, homewards: bool) {
        let (params, forces, height) = (self.params, self.forces, self.height);
        let step = params.step * height;
        let tolerance = params.tolerance * params.join * height;
        let move_one = |particle: &mut Particle| {
            // At the base a heavy particle would circle round it for want of a turn.
            let near_base = TURN_SHARE * particle.state.position.length();
            let turning = (params.turn * height * libm::powf(particle.mass, params.inertia))
                .min(near_base.max(TURN_SHARE * step));
            let (state, parts) =
                advance(particle.state, step, turning, tolerance, |point, time| {
                    if homewards {
                        return forces.homewards(point);
                    }
                    let near = particle
                        .near
                        .map(|(at, velocity, share)| (at + velocity * time - point, share));
                    forces.direction(point, near)
                });
            particle.way += state.position.distance(particle.state.position);
            particle.state = state;
            if let Some((at, velocity, _)) = &mut particle.near {
                *at += *velocity * step;
            }
            u64::from(parts)
        };
        self.report.n_parts += self
            .particles
            .par_chunks_mut(CHUNK)
            .map(|chunk| chunk.iter_mut().map(move_one).sum::<u64>())
            .sum::<u64>();
    }

    /// Joins pairs that are close, the closest first, each particle at most once a step.
    fn join(&mut self) {
        let reach = self.params.join * self.height;
        let mut cells = std::mem::take(&mut self.cells);
        cells.fill(self.positions(), reach);
        let mut pairs: Vec<(f32, u32, u32)> = self
            .particles
            .par_iter()
            .with_min_len(CHUNK)
            .enumerate()
            .filter_map(|(i, particle)| {
                let (other, square) = cells.nearest(i as u32, particle.state.position, reach)?;
                Some((square, (i as u32).min(other), (i as u32).max(other)))
            })
            .collect();
        self.cells = cells;
        pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut taken = vec![false; self.particles.len()];
        let mut gone = vec![false; self.particles.len()];
        for (_, a, b) in pairs {
            let (a, b) = (a as usize, b as usize);
            if taken[a] || taken[b] {
                continue;
            }
            (taken[a], taken[b]) = (true, true);
            let lighter = if self.particles[a].mass < self.particles[b].mass { a } else { b };
            self.join_pair(a + b - lighter, lighter);
            gone[lighter] = true;
        }
        let mut gone = gone.into_iter();
        self.particles.retain(|_| !gone.next().unwrap_or(false));
    }

    /// Masses and momenta add up (NOTES: a join merges masses).
    fn join_pair(&mut self, heavier: usize, lighter: usize) {
        let light = self.particles[lighter];
        let heavy = &mut self.particles[heavier];
        let mass = heavy.mass + light.mass;
        let share = light.mass / mass;
        heavy.state = State {
            position: heavy.state.position.lerp(light.state.position, share),
            velocity: heavy.state.velocity.lerp(light.state.velocity, share),
        };
        heavy.mass = mass;
        heavy.near = None;
        let node = self.traces.go_on(heavy.last, heavy.state.position, heavy.number);
        self.traces.lead(light.number, light.last, node);
        heavy.last = node;
        heavy.heading = heavy.state.velocity.normalize_or(heavy.heading);
        heavy.way = 0.0;
        self.report.n_joins += 1;
    }

    /// Joins particles to traces of others that have gone on: what flows in one bed at different times is
    /// one branch.
    fn follow(&mut self) {
        let Self { particles, traces, report, .. } = self;
        let reach = self.params.join * self.height;
        let found: Vec<Option<u32>> = particles
            .par_iter()
            .with_min_len(CHUNK)
            .map(|particle| {
                let State { position, velocity } = particle.state;
                traces.nearest(particle.number, position, velocity, reach)
            })
            .collect();
        let mut carried = Vec::new();
        let mut found = found.into_iter();
        particles.retain(|particle| {
            let Some(node) = found.next().flatten() else { return true };
            // Another of this step may have led that trace here meanwhile.
            let Some(leader) = traces.follow(particle.number, particle.last, node) else {
                return true;
            };
            report.n_followed += 1;
            carried.push((leader, particle.mass));
            false
        });
        for (leader, mass) in carried {
            // Particles stay in the order of their numbers.
            if let Ok(i) = particles.binary_search_by_key(&leader, |particle| particle.number) {
                particles[i].mass += mass;
            }
        }
    }

    /// Lets go of those that arrived, and marks the way of the others.
    fn leave_nodes(&mut self) {
        let Self { particles, traces, report, .. } = self;
        let (join, spacing) = (self.params.join * self.height, self.params.spacing * self.height);
        particles.retain_mut(|particle| {
            if particle.state.position.length() < ARRIVAL * join {
                traces.lead(particle.number, particle.last, 0);
                report.n_arrived += 1;
                return false;
            }
            let heading = particle.state.velocity.normalize_or(particle.heading);
            let turned = heading.dot(particle.heading) < TURN_COS;
            if particle.way >= spacing || (turned && particle.way >= 0.5 * spacing) {
                particle.last =
                    traces.go_on(particle.last, particle.state.position, particle.number);
                particle.heading = heading;
                particle.way = 0.0;
            }
            true
        });
    }

    /// No particle is dropped: what is still on its way is led to the nearest trace that is nearer to the base.
    fn lead_the_rest(&mut self) {
        let rest = std::mem::take(&mut self.particles);
        // Only nodes from which the base is reached already: a lost trace may not lead into another.
        let home = if rest.is_empty() { Vec::new() } else { self.traces.at_home() };
        for particle in rest {
            let at = particle.state.position;
            let positions = self.traces.positions();
            let nearest = (0..home.len())
                .filter(|&node| home[node] && positions[node].length() <= at.length())
                .min_by(|&a, &b| {
                    let square = |i: usize| positions[i].distance_squared(at);
                    square(a).total_cmp(&square(b))
                });
            self.traces.lead(particle.number, particle.last, nearest.unwrap_or(0) as u32);
            self.report.n_led += 1;
        }
    }
}
