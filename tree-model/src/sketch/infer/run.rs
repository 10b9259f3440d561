//! The whole of inference.

use super::bottom_up::bottom_up;
use super::climb::Climb;
use super::densities::Densities;
use super::depth::in_space;
use super::graph::build;
use super::icm::{branch, sweep, swing};
use super::near::Crossing;
use super::params::InferParams;
use super::posterior::{Graph, Posterior, State};
use crate::error::Result;
use crate::sketch::branches::{Branches, Label};
use crate::sketch::crown::Crown;
use crate::sketch::omega::Omega;
use crate::sketch::plan::Plan;
use rayon::prelude::*;
use tree_core::{Control, Seed};

/// The beam is so wide that it times the segments stays below this.
const BEAM_BUDGET: usize = 1200;
/// As many of the beam's trees are refined that they times the segments stay below this.
const REFINE_BUDGET: usize = 48;
/// In a sketch of so few segments all of them are.
const FEW_SEGMENTS: usize = 8;
/// Steps of a climb to the top of the posterior, at most. Most need about 15.
const TO_THE_TOP: u32 = 60;
/// Posteriors of small sketches this near to each other are the same.
const SAME: f64 = 1e-6;
/// Swinging branches is left out where segments squared are above this.
const SWING_BUDGET: usize = 90_000;
/// Rounds of separating branches that still cross.
const SEPARATIONS: u32 = 4;

/// What was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Bottom-up inference.
    BottomUp,
    /// Passes of ICM.
    Icm,
    /// Branches swung to the other side.
    Swing,
    /// Crossing branches were moved apart.
    Separate,
    /// Ω was estimated.
    Omega,
}

/// The posterior after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceRow {
    /// The step.
    pub step: Step,
    /// The posterior's logarithm after it.
    pub posterior: Posterior,
}

/// A depth that is known: of the end of the segment that ends at a node of the plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// Node of the plan: a tip or a fork.
    pub node: u32,
    /// Its depth in metres; positive is towards the viewer.
    pub depth: f32,
}

/// The factor of one segment, part by part, as logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorRow {
    /// The segment.
    pub segment: u32,
    /// ln p(s | Ω).
    pub scale: f64,
    /// ln p(α | Ω) or ln p(β | Ω).
    pub divergence: f64,
    /// ln p(γ | Ω); 0 where there is no roll.
    pub roll: f64,
    /// What the factors along strokes add.
    pub stroke: f64,
    /// Competition and crossings that change with this segment's depth.
    pub shared: f64,
}

/// A sketch in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Inferred {
    /// The segments, with labels and points. Seen along −Z their points are those of the plan.
    pub branches: Branches,
    /// Ω of the sketch: the template's, or estimated.
    pub omega: Omega,
    /// The posterior.
    pub posterior: Posterior,
    /// The posterior after each step. It never falls.
    pub trace: Vec<TraceRow>,
    /// The factor of each segment but the root.
    pub factors: Vec<FactorRow>,
    /// Crossings in the drawing of branches that could not be given room.
    pub interpenetrations: u32,
    nodes: Vec<u32>,
}

impl Inferred {
    /// The plan's nodes that the points of a segment are; for an imagined root the base alone, and none where there is no
    /// such segment.
    #[must_use]
    pub fn nodes(&self, segment: usize) -> &[u32] {
        // Rows are as those of the points, which an imagined root has one more of.
        let skip = usize::from(self.branches.imagined_root);
        let ends = self.branches.starts.get(segment).zip(self.branches.starts.get(segment + 1));
        let row = ends.map(|(&from, &to)| {
            let from = if segment == 0 { 0 } else { from as usize - skip };
            from..to as usize - skip
        });
        row.and_then(|row| self.nodes.get(row)).unwrap_or(&[])
    }
}

/// Infers depths, labels and, unless it is to be kept, Ω, which begins as the template's.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for parameters or Ω out of range; [`ModelError::Limit`](crate::ModelError::Limit); [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// See the module.
pub fn infer(
    plan: &Plan,
    template: &Omega,
    params: &InferParams,
    seed: Seed,
    control: &Control,
) -> Result<Inferred> {
    infer_with(plan, template, (&[], None), params, seed, control)
}

/// [`infer`] where some depths are known and stay as they are, and ends drawn inside `crown` stay in its surface of local
/// revolution as far as the factors allow.
///
/// # Errors
/// As [`infer`]; [`ModelError::Sketch`](crate::ModelError::Sketch) for a pin that is not finite or not at a fork or tip of the plan.
pub fn infer_with(
    plan: &Plan,
    template: &Omega,
    (pins, crown): (&[Pin], Option<&Crown>),
    params: &InferParams,
    seed: Seed,
    control: &Control,
) -> Result<Inferred> {
    let graph = build(plan, template, (pins, crown), params, seed, control)?;
    let start = graph.start.clone();
    let mut run = Run {
        graph: &graph,
        params,
        control,
        omega: Densities::of(template.clone()),
        state: start,
        total: f64::NEG_INFINITY,
        trace: Vec::new(),
    };
    run.all()?;
    Ok(run.finish(plan))
}

/// A run of inference.
struct Run<'a> {
    graph: &'a Graph,
    params: &'a InferParams,
    control: &'a Control,
    omega: Densities,
    state: State,
    total: f64,
    trace: Vec<TraceRow>,
}

impl Run<'_> {
    fn all(&mut self) -> Result<()> {
        let n = self.graph.segments().len();
        let width = (BEAM_BUDGET / n)
            .clamp(2, self.params.beam.max(2) as usize)
            .min(self.params.beam as usize);
        self.control.report("branches", 0.0)?;
        let mut found = bottom_up(self.graph, &self.omega, &self.state, width, self.control)?;
        if n > FEW_SEGMENTS {
            found.truncate((REFINE_BUDGET / n).max(1));
        }
        self.begin(found)?;
        for round in 0..self.params.rounds {
            self.control.report("branches", round as f32 / self.params.rounds as f32)?;
            let before = self.total;
            self.refine(round)?;
            if !self.params.keep_omega {
                self.estimate();
            }
            /// A round that raised the posterior by less was the last.
            const SETTLED: f64 = 1e-4;
            if self.total - before < SETTLED {
                break;
            }
        }
        self.separate()?;
        self.control.report("branches", 1.0)?;
        Ok(())
    }

    /// Takes the best of what bottom-up inference found, each refined first where there are few segments.
    fn begin(&mut self, found: Vec<State>) -> Result<()> {
        match <[State; 1]>::try_from(found) {
            Ok([state]) => {
                self.total = self.graph.total(&self.omega, &state);
                self.state = state;
            }
            Err(found) => self.take_best(found)?,
        }
        if self.graph.segments().len() <= FEW_SEGMENTS {
            self.hop()?;
        }
        self.note(Step::BottomUp);
        self.separate()
    }

    /// In small sketches: from the best, each branch is swung to other slopes and each two siblings change labels, with ICM after;
    /// until nothing is better.
    fn hop(&mut self) -> Result<()> {
        /// Tangents of the slopes tried.
        const SLOPES: [f64; 8] = [-1.7, -1.1, -0.6, -0.2, 0.2, 0.6, 1.1, 1.7];
        /// Times all are tried, at most.
        const HOPS: u32 = 4;
        let segments = self.graph.segments();
        for _ in 0..HOPS {
            let before = self.total;
            let mut starts: Vec<State> = Vec::new();
            for i in 1..segments.len() {
                let below = segments.parent(i).map_or(0.0, |parent| self.state.depths[parent]);
                for slope in SLOPES.into_iter().filter(|_| !self.graph.pinned[i]) {
                    let mut state = self.state.clone();
                    let shift = below + slope * segments.chord(i).length() - state.depths[i];
                    for above in branch(segments, i).into_iter().filter(|&j| !self.graph.pinned[j])
                    {
                        state.depths[above] += shift;
                    }
                    starts.push(state);
                }
                for &other in segments.parent(i).map_or(&[][..], |p| segments.children(p)) {
                    let mut state = self.state.clone();
                    state.labels.swap(i, other as usize);
                    starts.push(state);
                }
            }
            self.take_best(starts)?;
            if self.total <= before + SAME {
                break;
            }
        }
        Ok(())
    }

    /// Climbs a little from the states that are best as they are, and to the top from the most promising of them; keeps the best,
    /// if it is better than what there is.
    fn take_best(&mut self, states: Vec<State>) -> Result<()> {
        /// Steps that all states climb which are left, and how many are left after.
        const STAGES: [(u32, usize); 3] = [(0, 32), (8, 6), (TO_THE_TOP, 1)];
        let mut best: Vec<(f64, State)> = states.into_iter().map(|state| (0.0, state)).collect();
        for (steps, kept) in STAGES {
            let climb = |(_, mut state): (f64, State)| Ok((self.climb(&mut state, steps)?, state));
            best = best.into_par_iter().map(climb).collect::<Result<_>>()?;
            best.sort_by(|a, b| b.0.total_cmp(&a.0));
            best.dedup_by(|a, b| (a.0 - b.0).abs() < SAME);
            best.truncate(kept);
        }
        for (total, state) in best {
            if total > self.total {
                (self.state, self.total) = (state, total);
            }
        }
        Ok(())
    }

    /// ICM, and swings of whole branches.
    fn refine(&mut self, round: u32) -> Result<()> {
        let mut state = self.state.clone();
        self.icm(&mut state, if round == 0 { 1.0 } else { 0.25 })?;
        self.accept(state, Step::Icm);
        let n = self.graph.segments().len();
        if n * n <= SWING_BUDGET && round < 2 {
            let mut state = self.state.clone();
            let mut total = self.total;
            if swing(self.graph, &self.omega, &mut state, &mut total) {
                self.accept(state, Step::Swing);
                let mut state = self.state.clone();
                self.icm(&mut state, 0.25)?;
                self.accept(state, Step::Icm);
            }
        }
        Ok(())
    }

    fn climb(&self, state: &mut State, steps: u32) -> Result<f64> {
        let climb = Climb { graph: self.graph, omega: &self.omega, control: self.control };
        climb.climb(state, steps)
    }

    /// Passes of ICM until depths have settled; small sketches then climb to the top, which costs little.
    fn icm(&self, state: &mut State, first: f64) -> Result<()> {
        let wiring = self.graph.wiring(&state.labels);
        let settled = f64::from(self.params.settled) * self.graph.segments().extent;
        let mut share = first;
        for _ in 0..self.params.sweeps {
            self.control.check()?;
            if sweep(self.graph, &self.omega, state, &wiring, share) <= settled {
                break;
            }
            share = (share * 0.6).max(0.02);
        }
        if self.graph.segments().len() <= FEW_SEGMENTS {
            self.climb(state, TO_THE_TOP)?;
        }
        Ok(())
    }

    /// Moves branches that cross without room apart along the z-axis: the higher one swings or moves to either
    /// side, whichever the posterior likes best.
    fn separate(&mut self) -> Result<()> {
        let segments = self.graph.segments();
        for _ in 0..SEPARATIONS {
            let mut any = false;
            for crossing in &self.graph.near.crossings {
                self.control.check()?;
                if crossing.overlap(segments, &self.state.depths) <= 0.0 {
                    continue;
                }
                any |= self.part(crossing);
            }
            if !any {
                break;
            }
            self.note(Step::Separate);
        }
        Ok(())
    }

    /// Gives one crossing room; returns whether that raised the posterior.
    fn part(&mut self, crossing: &Crossing) -> bool {
        let segments = self.graph.segments();
        let before = self.total;
        for segment in [crossing.b.0 as usize, crossing.a.0 as usize] {
            for side in [1.2, -1.2, 2.4, -2.4] {
                let mut state = self.state.clone();
                let shift = side * crossing.clearance;
                let mut stack = vec![segment];
                while let Some(i) = stack.pop() {
                    if i != 0 && !self.graph.pinned[i] {
                        state.depths[i] += shift;
                    }
                    stack.extend(segments.children(i).iter().map(|&child| child as usize));
                }
                let total = self.graph.total(&self.omega, &state);
                if total > self.total {
                    (self.state, self.total) = (state, total);
                }
            }
        }
        self.total > before
    }

    fn estimate(&mut self) {
        let next = Densities::of(self.graph.prior.estimate(self.graph, &self.omega, &self.state));
        let total = self.graph.total(&next, &self.state);
        if total >= self.total {
            (self.omega, self.total) = (next, total);
            self.note(Step::Omega);
        }
    }

    /// Keeps a state that is no worse.
    fn accept(&mut self, state: State, step: Step) {
        let total = self.graph.total(&self.omega, &state);
        if total >= self.total {
            (self.state, self.total) = (state, total);
            self.note(step);
        }
    }

    fn note(&mut self, step: Step) {
        let posterior = self.graph.posterior(&self.omega, &self.state);
        self.trace.push(TraceRow { step, posterior });
    }

    fn finish(self, plan: &Plan) -> Inferred {
        let Self { graph, omega, mut state, trace, .. } = self;
        let segments = graph.segments();
        // A sketch of one stroke has labels nobody asked for.
        for label in &mut state.labels {
            if *label == Label::Lateral(u16::MAX) {
                *label = Label::Apical;
            }
        }
        let overlaps =
            graph.near.crossings.iter().filter(|c| c.overlap(segments, &state.depths) > 0.05);
        let interpenetrations = overlaps.count() as u32;
        Inferred {
            branches: in_space(plan, segments, &state, &graph.near.crossings),
            nodes: segments.all_nodes().to_vec(),
            posterior: graph.posterior(&omega, &state),
            factors: factor_rows(graph, &omega, &state),
            omega: omega.omega,
            trace,
            interpenetrations,
        }
    }
}

fn factor_rows(graph: &Graph, omega: &Densities, state: &State) -> Vec<FactorRow> {
    let factors = &graph.factors;
    let orders = factors.orders(&state.labels);
    let row = |i: usize| {
        let parent = graph.segments().parent(i)?;
        let fork = factors.fork(&state.depths, &state.labels, orders[parent], parent);
        let v = factors.vector(&state.depths, i);
        let (terms, n) = factors.terms(omega, &fork, v, i, state.labels[i]);
        let imagined = graph.segments().imagined_root && parent == 0;
        let ln = |place: usize| terms[..n].get(place).map_or(0.0, |term| term.ln);
        // Stems have no length ratio.
        let (scale, divergence, roll) =
            if imagined { (0.0, ln(0), ln(1)) } else { (ln(0), ln(1), ln(2)) };
        Some(FactorRow {
            segment: i as u32,
            scale,
            divergence,
            roll,
            stroke: factors.along_stroke(&fork, v, i, state.labels[i]),
            shared: graph.shared(&state.depths, i),
        })
    };
    (0..graph.segments().len()).filter_map(row).collect()
}
