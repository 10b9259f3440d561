//! What can go wrong in this crate.

use glam::Vec3;
use std::borrow::Cow;
use tree_core::{Cancelled, CoreError, LimitError, ParameterError, check_parameter};

/// Shorthand for results of this crate.
pub(crate) type Result<T, E = ModelError> = std::result::Result<T, E>;

/// Every error of tree-model. Each says what was wrong, where, and what would be right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A parameter lies outside its range or is not finite.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A coordinate is NaN or infinite.
    #[error("{field} is not finite")]
    NotFinite {
        /// Path of the field, for example `endpoints.placed[3]`.
        field: String,
    },
    /// A volume to grow in holds no point, or has no end.
    #[error("{field} holds no room for a search graph: {problem}")]
    EmptyVolume {
        /// Path of the field.
        field: String,
        /// Why nothing fits.
        problem: &'static str,
    },
    /// The root lies outside the volume the tree is to fill.
    #[error(
        "the root {root} lies outside the volume; the nearest graph node is {nearest} m away, \
             at most {reach} m is bridged"
    )]
    RootOutside {
        /// The root asked for.
        root: Vec3,
        /// Distance to the nearest graph node in metres.
        nearest: f32,
        /// Linking distance in metres.
        reach: f32,
    },
    /// The root lies inside the obstacle, or within the clearance of it.
    #[error("the root {root} lies inside the obstacle or its clearance")]
    RootBlocked {
        /// The root asked for.
        root: Vec3,
    },
    /// Nothing to grow towards.
    #[error("no endpoints: give `endpoints.random` above 0 or at least one placed endpoint")]
    NoEndpoints,
    /// No node of the graph may be an endpoint.
    #[error(
        "none of the graph's nodes qualifies as one of {wanted} random endpoints: lower \
             `endpoints.above`, place them in the volume instead of at its surface, or raise \
             `graph_nodes`"
    )]
    NoCandidates {
        /// Random endpoints asked for.
        wanted: u32,
    },
    /// No path leads to a placed endpoint.
    #[error(
        "endpoint {index} at {position} cannot be reached from the root: it lies too far \
             outside the volume, or an obstacle shuts it off"
    )]
    EndpointUnreachable {
        /// Index into the placed endpoints.
        index: usize,
        /// Where it was placed.
        position: Vec3,
    },
    /// Nothing grew at one level.
    #[error("levels[{index}]: {source}")]
    Level {
        /// Index into the levels.
        index: usize,
        /// Why its first branch did not grow.
        #[source]
        source: Box<ModelError>,
    },
    /// A cost field answered with something that is no cost.
    #[error("the cost field gives {found} at {position}, allowed is 0 or more and finite")]
    Cost {
        /// Where it was asked.
        position: Vec3,
        /// Its answer.
        found: f32,
    },
    /// A part of a mesh cannot be read.
    #[error("parts[{part}]: {problem}")]
    BadPart {
        /// Index into the parts.
        part: usize,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A mesh has no wood to follow.
    #[error("no wood found: {problem}")]
    NoWood {
        /// Why.
        problem: &'static str,
    },
    /// A cloud of points cannot become a tree.
    #[error("cloud: {problem}")]
    Cloud {
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A cloud of points shows no place where a tree stands.
    #[error("no base found: {problem}")]
    NoBase {
        /// Why, and what would help.
        problem: &'static str,
    },
    /// A picture cannot be used.
    #[error("picture: {problem}")]
    Picture {
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A view of a tree cannot be used.
    #[error("views[{view}]: {problem}")]
    View {
        /// Index into the views.
        view: usize,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// An attractor graph cannot be used.
    #[error("attractor: {problem}")]
    Attractor {
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A drawing cannot become a tree.
    #[error("sketch: {problem}")]
    Sketch {
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A stroke of a drawing cannot be used.
    #[error("{stroke}: {problem}")]
    Stroke {
        /// Which one: its number in the drawing, and its name where it has one.
        stroke: String,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A template of trees cannot be used.
    #[error("template: {problem}")]
    Template {
        /// What is wrong with it, where, and what would be right.
        problem: String,
    },
    /// A drawn outline, or a stroke drawn into one, cannot be used.
    #[error("{what}: {problem}")]
    Silhouette {
        /// What was drawn: "crown", "trunk", "branch 3", "leaf", "L1 stroke 2 'left'".
        what: String,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// The text of an L-system has a mistake.
    #[error("line {line}, column {column}: {problem}{}{hint}", if hint.is_empty() { "" } else { "; " })]
    Grammar {
        /// Line of the text, from 1.
        line: usize,
        /// Column in characters, from 1.
        column: usize,
        /// What is wrong.
        problem: String,
        /// What would be right; may be empty.
        hint: String,
    },
    /// A word of modules cannot be derived or drawn.
    #[error("module {module}: {problem}")]
    Word {
        /// Index of the module in the word.
        module: usize,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// Something in a scene of trees cannot be.
    #[error("{what}: {problem}")]
    Scene {
        /// What was asked for: "tree 3", "obstacle".
        what: String,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// There is no preset of this name.
    #[error("no preset named '{name}'; there are {known}")]
    UnknownPreset {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// An SVG drawing cannot be used.
    #[cfg(feature = "svg")]
    #[error("SVG: {0}")]
    Svg(String),
    /// Something from the layer below.
    #[error(transparent)]
    Core(#[from] CoreError),
    /// More was asked for than the limits allow.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// The caller cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl ModelError {
    /// Names the view in errors that speak of a picture or an attractor.
    pub(crate) fn in_view(self, view: usize) -> Self {
        match self {
            Self::Picture { problem } | Self::Attractor { problem } => Self::View { view, problem },
            other => other,
        }
    }
}

/// Checks that a parameter is a number within `min..=max`.
pub(crate) fn check(
    field: impl Into<Cow<'static, str>>,
    found: impl Into<f64>,
    min: impl Into<f64>,
    max: impl Into<f64>,
) -> Result<()> {
    Ok(check_parameter(field, found, min, max)?)
}

/// Checks that a vector is finite.
pub(crate) fn check_finite(field: impl Into<String>, value: Vec3) -> Result<()> {
    if value.is_finite() { Ok(()) } else { Err(ModelError::NotFinite { field: field.into() }) }
}
