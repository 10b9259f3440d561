//! What a path-planned tree is made of: plain structs, all with defaults that make a good oak.

use super::graph::{CostField, LinkParams, Paint, Terrain};
use super::obstacle::Obstacle;
use crate::error::{ModelError, Result, check, check_finite};
use crate::foliage::LeafParams;
use glam::Vec3;
use std::f32::consts::PI;
use tree_core::allometry::RadiusRule;
use tree_core::{CoreError, Species, Volume};

/// Most levels: 2 to the 16th subgraphs at the smallest branching would be a forest.
pub const MAX_LEVELS: usize = 16;

/// Most endpoints drawn at random in one graph.
pub const MAX_ENDPOINTS: u32 = 10_000;

/// Narrowest sector, in radians (3°): a thinner one is hit by too few darts to hold a graph.
pub const MIN_ANGLE: f32 = 0.05;

/// Everything that shapes a tree by Xu & Mould's method. Lengths in metres, angles in radians.
///
/// There is no `Default`, because volumes are checked when they are made; begin with
/// [`PathParams::oak`] or another preset, and change what should differ:
///
/// ```
/// use tree_model::path::PathParams;
/// let params = PathParams { graph_nodes: 9000, ..PathParams::oak()? };
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathParams {
    /// The volume of level 1: trunk and crown, or root ball. It decides the shape of the tree more
    /// than all else. Bounded. Oak: a trunk of 3 m under a round crown, 10.4 m high.
    pub volume: Volume,
    /// Where all paths end; inside `volume` or within linking distance. Oak: the origin.
    pub root: Vec3,
    /// Nodes of the level 1 graph (K), 8 to `Limits::graph_nodes`; the graph has this many within
    /// about a tenth. More make branches finer and cost time in proportion. Oak: 5000.
    pub graph_nodes: u32,
    /// Where the branches of level 1 end.
    pub endpoints: Endpoints,
    /// Radius of the subgraphs of level 2 in metres, above 0. Oak: 2.2.
    pub size: f32,
    /// Ratio (a) of the subgraph radii of successive levels, 0.05 to 2. Oak: 0.62.
    pub shrink: f32,
    /// Levels 2 and on, at most [`MAX_LEVELS`]. Oak: three.
    pub levels: Vec<Level>,
    /// How long branches live.
    #[cfg_attr(feature = "serde", serde(default))]
    pub lifespan: Lifespan,
    /// How nodes are linked and what edges cost.
    #[cfg_attr(feature = "serde", serde(default))]
    pub linking: LinkParams,
    /// Painted edge costs (the paper's §5); where several overlap, they multiply.
    #[cfg_attr(feature = "serde", serde(default))]
    pub paint: Vec<Paint>,
    /// A cost factor for every point, multiplied with `paint`.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub cost: Option<CostField>,
    /// What no path may enter. Oak: none.
    #[cfg_attr(feature = "serde", serde(default))]
    pub obstacle: Option<Obstacle>,
    /// Smoothing passes over the branches, 0 to 50. Each takes away some of the zigzag from node to
    /// node. Oak: 3; the paper has none.
    #[cfg_attr(feature = "serde", serde(default))]
    pub smoothing: u32,
    /// How thick branches are. Oak: the pipe model, scaled to a trunk of 0.48 m radius.
    #[cfg_attr(feature = "serde", serde(default))]
    pub radii: RadiusRule,
    /// Leaves; none when `None`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub leaves: Option<LeafParams>,
    /// Names of species, bark and leaves.
    #[cfg_attr(feature = "serde", serde(default))]
    pub species: Species,
    /// A root system, grown by the same method from the same root. Its own root, leaves and roots are
    /// ignored. Oak: none.
    #[cfg_attr(feature = "serde", serde(default))]
    pub roots: Option<Box<PathParams>>,
}

/// Where the branches of a level 1 graph end.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Endpoints {
    /// Endpoints drawn at random (b), at most [`MAX_ENDPOINTS`]. Default 14.
    pub random: u32,
    /// Where random endpoints may lie.
    pub placing: Placing,
    /// Candidates drawn for each random endpoint, of which the one farthest from all others is
    /// taken (Mitchell 1991), 1 to 64. 1 is the paper's plain draw; more spread the branches
    /// evenly and cost time with the square of `random`. Default 4.
    pub candidates: u32,
    /// Random endpoints lie above this share of the volume's height, 0 to 0.95; keeps main branches
    /// off the trunk. Default 0.
    pub above: f32,
    /// Endpoints placed by hand, in metres.
    pub placed: Vec<Vec3>,
}

impl Default for Endpoints {
    fn default() -> Self {
        Self { random: 14, placing: Placing::Volume, candidates: 4, above: 0.0, placed: Vec::new() }
    }
}

/// Where random endpoints may lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Placing {
    /// Anywhere in the volume.
    #[default]
    Volume,
    /// Within one separation of the volume's surface.
    Surface,
}

/// Subgraphs grown round the endpoints of the level before.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Level {
    /// Endpoints in each subgraph (b), 1 to [`MAX_ENDPOINTS`]. Default 4.
    pub branching: u32,
    /// Shape of the subgraphs.
    pub shape: SubShape,
    /// Nodes of each subgraph (k), 8 to `Limits::graph_nodes`. Default 110.
    pub graph_nodes: u32,
    /// Which way subgraphs point.
    pub axis: LevelAxis,
    /// Turn (γ) of the axis about the horizontal in radians, −π to π: positive bends branches
    /// down, negative up. Default 0.
    pub turn: f32,
    /// Radius in metres, above 0, in place of the one that follows from `size` and `shrink`.
    pub size: Option<f32>,
    /// Where endpoints may lie.
    pub placing: Placing,
    /// Grow subgraphs round the endpoints of *all* levels before, not only the last.
    pub from_all_levels: bool,
}

impl Default for Level {
    fn default() -> Self {
        Self {
            branching: 4,
            shape: SubShape::Sector { angle: 0.3 * PI },
            graph_nodes: 110,
            axis: LevelAxis::Outward,
            turn: 0.0,
            size: None,
            placing: Placing::Volume,
            from_all_levels: false,
        }
    }
}

/// Shape of a subgraph, pointing along its axis from its root.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SubShape {
    /// The part of a ball round the root that lies within `angle` (α) of the axis; radians,
    /// [`MIN_ANGLE`] to π (the whole ball). The paper's default (§3.3.2).
    Sector {
        /// Angle α.
        angle: f32,
    },
    /// A cone that stands on the root and narrows outwards; `width` is its base radius as a share
    /// of its height, 0.05 to 5.
    Cone {
        /// Base radius over height.
        width: f32,
    },
    /// A cone with its tip on the root that widens outwards.
    InvertedCone {
        /// Base radius over height.
        width: f32,
    },
    /// Any volume, drawn for a root at the origin, axis +Y and radius 1.
    Custom(Volume),
}

/// Which way the subgraphs of a level point, before the turn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LevelAxis {
    /// From the root of the graph before through the endpoint.
    #[default]
    Outward,
    /// Straight down.
    Down,
    /// One direction for all; need not have unit length.
    Fixed(Vec3),
    /// A random direction for each.
    Random,
}

/// How many levels a branch goes on for (§3.3.3).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Lifespan {
    /// Through all levels: L falls by 1 at each.
    #[default]
    Full,
    /// At each level a branch ends with chance `stop`, else L falls by a number drawn from 0 to L.
    /// Makes irregular, livelier trees.
    Random {
        /// Chance to end, 0 to 1; the paper uses 0.3.
        stop: f32,
    },
}

impl PathParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`], [`ModelError::NotFinite`] or [`ModelError::NoEndpoints`], naming
    /// the field.
    pub fn validate(&self) -> Result<()> {
        check_finite("root", self.root)?;
        check("graph_nodes", self.graph_nodes, 8, u32::MAX)?;
        self.endpoints.validate()?;
        check("size", self.size, 1e-6, 1e6)?;
        check("shrink", self.shrink, 0.05, 2.0)?;
        check("levels.len()", self.levels.len() as f64, 0, MAX_LEVELS as f64)?;
        for (i, level) in self.levels.iter().enumerate() {
            level.validate(i)?;
        }
        if let Lifespan::Random { stop } = self.lifespan {
            check("lifespan.stop", stop, 0, 1)?;
        }
        self.linking.validate()?;
        self.terrain().validate()?;
        check("smoothing", self.smoothing, 0, 50)?;
        self.radii.validate().map_err(|error| within("radii", error.into()))?;
        if let Some(leaves) = &self.leaves {
            let n_kinds = self.species.leaf_kinds.len();
            check("species.leaf_kinds.len()", n_kinds as f64, 1, u16::MAX)?;
            leaves.validate(n_kinds)?;
        }
        match &self.roots {
            Some(roots) => self.root_params(roots).validate().map_err(|e| within("roots", e)),
            None => Ok(()),
        }
    }

    /// What makes edges cost more or less.
    pub(super) fn terrain(&self) -> Terrain<'_> {
        Terrain { paint: &self.paint, cost: self.cost.as_ref(), obstacle: self.obstacle.as_ref() }
    }

    /// The root system's parameters, without what is ignored.
    pub(crate) fn root_params(&self, roots: &Self) -> Self {
        Self { root: self.root, roots: None, leaves: None, ..roots.clone() }
    }

    /// Radius of the subgraphs of `levels[i]` in metres.
    #[must_use]
    pub fn level_size(&self, i: usize) -> f32 {
        let from_shrink = (0..i).fold(self.size, |size, _| size * self.shrink);
        self.levels.get(i).and_then(|level| level.size).unwrap_or(from_shrink)
    }
}

/// The same error, its field named as part of `outer`.
fn within(outer: &str, error: ModelError) -> ModelError {
    match error {
        ModelError::Parameter(error) | ModelError::Core(CoreError::Parameter(error)) => {
            error.within(outer).into()
        }
        ModelError::NotFinite { field } => {
            ModelError::NotFinite { field: format!("{outer}.{field}") }
        }
        ModelError::Core(CoreError::NotFinite { field, .. }) => {
            ModelError::NotFinite { field: format!("{outer}.{field}") }
        }
        other => other,
    }
}

impl Endpoints {
    fn validate(&self) -> Result<()> {
        if self.random == 0 && self.placed.is_empty() {
            return Err(ModelError::NoEndpoints);
        }
        check("endpoints.random", self.random, 0, MAX_ENDPOINTS)?;
        check("endpoints.candidates", self.candidates, 1, 64)?;
        check("endpoints.above", self.above, 0.0, 0.95)?;
        self.placed
            .iter()
            .enumerate()
            .try_for_each(|(i, &p)| check_finite(format!("endpoints.placed[{i}]"), p))
    }
}

impl Level {
    fn validate(&self, i: usize) -> Result<()> {
        let field = |name: &str| format!("levels[{i}].{name}");
        check(field("branching"), self.branching, 1, MAX_ENDPOINTS)?;
        check(field("graph_nodes"), self.graph_nodes, 8, u32::MAX)?;
        check(field("turn"), self.turn, -PI, PI)?;
        if let Some(size) = self.size {
            check(field("size"), size, 1e-6, 1e6)?;
        }
        if let LevelAxis::Fixed(axis) = self.axis {
            check_finite(field("axis"), axis)?;
            check(field("axis.length()"), axis.length(), 1e-6, f32::MAX)?;
        }
        match &self.shape {
            SubShape::Sector { angle } => check(field("shape.angle"), *angle, MIN_ANGLE, PI),
            SubShape::Cone { width } | SubShape::InvertedCone { width } => {
                check(field("shape.width"), *width, 0.05, 5.0)
            }
            SubShape::Custom(_) => Ok(()),
        }
    }
}
