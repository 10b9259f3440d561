//! The factor graph of a sketch (section 4.5.1): built, and open to be read.

use super::densities::Densities;
use super::depth::unknown;
use super::factors::Factors;
use super::near::{Near, crossings, radii};
use super::omega_step::OmegaPrior;
use super::params::InferParams;
use super::posterior::{Graph, Posterior, State};
use super::run::Pin;
use super::segments::Segments;
use crate::error::{ModelError, Result};
use crate::sketch::branches::Label;
use crate::sketch::crown::Crown;
use crate::sketch::omega::Omega;
use crate::sketch::plan::Plan;
use glam::DVec2;
use tree_core::{Control, Resource, Seed};

/// The factor graph of a sketch: what any depths and labels are worth.
///
/// Segments are numbered generation by generation, as in [`Inferred::branches`](super::Inferred::branches).
pub struct FactorGraph {
    graph: Graph,
}

impl FactorGraph {
    /// Builds the graph that [`infer`](super::infer) with the same arguments works on.
    ///
    /// # Errors
    /// As [`infer`](super::infer).
    pub fn new(
        plan: &Plan,
        template: &Omega,
        params: &InferParams,
        seed: Seed,
        control: &Control,
    ) -> Result<Self> {
        Ok(Self { graph: build(plan, template, (&[], None), params, seed, control)? })
    }

    /// Parent of each segment; [`NO_PARENT`](tree_core::NO_PARENT) for segment 0.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.graph.segments().parents
    }

    /// Length of a segment in the plane, from end to end, in metres; 0 for a segment that is not there.
    #[must_use]
    pub fn length(&self, segment: usize) -> f64 {
        if segment < self.parents().len() {
            self.graph.segments().chord(segment).length()
        } else {
            0.0
        }
    }

    /// The posterior of depths (of segment ends, in metres) and labels.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where there are not as many as segments; as [`Omega::validate`].
    pub fn posterior(&self, omega: &Omega, depths: &[f64], labels: &[Label]) -> Result<Posterior> {
        omega.validate()?;
        let n = self.parents().len();
        if depths.len() != n || labels.len() != n {
            let problem =
                format!("{} depths and {} labels for {n} segments", depths.len(), labels.len());
            return Err(ModelError::Sketch { problem });
        }
        let state = State { depths: depths.to_vec(), labels: labels.to_vec() };
        Ok(self.graph.posterior(&Densities::of(omega.clone()), &state))
    }
}

/// Checks everything and builds the graph.
pub(super) fn build(
    plan: &Plan,
    template: &Omega,
    (pins, crown): (&[Pin], Option<&Crown>),
    params: &InferParams,
    seed: Seed,
    control: &Control,
) -> Result<Graph> {
    params.validate()?;
    template.validate()?;
    control.limits.check(Resource::Nodes, plan.len() as u64)?;
    let segments = Segments::of(plan);
    let crossings = if params.clearance > 0.0 {
        let radii = radii(&segments, params.slenderness.into());
        crossings(&segments, plan.positions(), &radii, params.clearance.into())
    } else {
        Vec::new()
    };
    let (start, pinned) = pinned(&segments, pins)?;
    let near = Near::new(&segments, crossings, params.competition.into());
    let prior = OmegaPrior::new(template, params.template_weight.into());
    /// Ends are kept this share of the way from the plane to the crown's surface.
    const ROOM: f64 = 0.9;
    let room = |end: &DVec2| {
        let deep = crown.and_then(|crown| crown.half_depth(end.as_vec2()));
        deep.map_or(f64::INFINITY, |deep| ROOM * f64::from(deep))
    };
    let rooms = segments.ends.iter().map(room).collect();
    let factors = Factors::new(segments, rooms, template, params, seed);
    Ok(Graph::new(factors, near, prior, start, pinned))
}

/// Where depths begin, and which stay.
fn pinned(segments: &Segments, pins: &[Pin]) -> Result<(State, Vec<bool>)> {
    let mut state = unknown(segments);
    let mut pinned = vec![false; segments.len()];
    let mut ends: Vec<(u32, usize)> = (1..segments.len())
        .filter_map(|i| segments.nodes(i).last().map(|&node| (node, i)))
        .collect();
    ends.sort_unstable();
    for (row, pin) in pins.iter().enumerate() {
        if !pin.depth.is_finite() {
            return Err(ModelError::Sketch {
                problem: format!("pins[{row}]: the depth {} is not finite", pin.depth),
            });
        }
        let Ok(found) = ends.binary_search_by_key(&pin.node, |&(node, _)| node) else {
            let problem =
                format!("pins[{row}]: node {} is no fork or tip above the root segment", pin.node);
            return Err(ModelError::Sketch { problem });
        };
        let segment = ends[found].1;
        state.depths[segment] = pin.depth.into();
        pinned[segment] = true;
    }
    Ok((state, pinned))
}
