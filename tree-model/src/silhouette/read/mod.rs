//! Drawings of outlines from files and pictures: what a person brings.
//!
//! * [`from_svg`] (feature `svg`): layers `L0`, `L1`, … and `leaf`, several planes, several trees; or whole filled
//!   silhouettes, as clip art has them.
//! * [`from_mask`] and [`from_photo`]: the alpha of a photograph, or a mask in black and white.
//!
//! The paper's strokes are drawn in its own program (section 3). Whole silhouettes are beyond it; they become a trunk and a crown:
//!
//! 1. What is filled becomes cells, 400 along its longer side (`raster`).
//! 2. Parts near each other are bridged, others left out; holes are filled (`cells`).
//! 3. The trunk is followed upwards from the foot for as long as it is narrow (`trunk`).
//! 4. The rest is the crown: its border, between the cells by how far they are covered (`border`), in at most 400
//!    corners. What a photograph frays is smoothed by closing gaps first (`whole`).
//!
//! Nothing is scaled: coordinates stay those of the drawing or pixels, y **down**.
//!
//! O(points + cells) for a silhouette: some tens of milliseconds.

mod alpha;
mod border;
mod cells;
#[cfg(feature = "svg")]
mod raster;
#[cfg(feature = "svg")]
mod svg;
mod trunk;
mod whole;

pub use alpha::{from_mask, from_photo, matte_of};
#[cfg(feature = "svg")]
pub use svg::from_svg;

use glam::Vec2;
use std::fmt;

/// What a stroke belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A branching order: 0 for the trunk and the crown, 1 for its branches, and so on.
    Number(u32),
    /// A leaf.
    Leaf,
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(level) => write!(f, "L{level}"),
            Self::Leaf => f.write_str("leaf"),
        }
    }
}

/// What a stroke shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An open line: a trunk or a branch, from either end.
    Axis,
    /// The outline of a crown, of a branch's foliage or of a leaf. Its first point is not repeated.
    Outline,
}

/// A stroke as it was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelStroke {
    /// What it belongs to.
    pub level: Level,
    /// What it shows.
    pub kind: Kind,
    /// By how much the plane it is drawn in is turned about the trunk, in radians; 0 for the plane of the drawing.
    pub azimuth: f32,
    /// Its points, in units of the drawing, y down. All are finite, none is repeated at once.
    pub points: Vec<Vec2>,
    /// Its name in the drawing; empty where it has none.
    pub name: String,
}

/// The strokes of one tree, in the order they were drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeStrokes {
    /// Its name in the drawing; empty where it has none.
    pub name: String,
    /// The strokes.
    pub strokes: Vec<LevelStroke>,
    /// Width of the trunk in units of the drawing, where it was drawn as an area.
    pub trunk_width: Option<f32>,
}

/// A drawing of one tree or several.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OutlineDrawing {
    /// The trees, in the order they were drawn. At least one, each with at least one stroke.
    pub trees: Vec<TreeStrokes>,
    /// What was repaired or noticed.
    pub repairs: Vec<ReadRepair>,
}

/// One thing that was repaired or noticed in a drawing. As text, a sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ReadRepair {
    /// Shapes outside all layers, or outside the groups of trees, were left out.
    StrayShapes {
        /// How many.
        count: usize,
    },
    /// Open lines beside filled shapes were left out.
    LinesDropped {
        /// How many.
        count: usize,
    },
    /// A trunk drawn as an area became its middle line.
    TrunkThinned {
        /// The tree; empty where it has no name.
        tree: String,
    },
    /// A shape as large as the drawing was taken for its background and left out.
    BackgroundDropped,
    /// Parts apart from the tree, but near it, were joined to it.
    PartsBridged {
        /// How many.
        count: usize,
    },
    /// Parts far from the tree, or too small, were left out.
    PartsDropped {
        /// How many.
        count: usize,
        /// Their share of the area, 0 to 1.
        share: f32,
    },
    /// Holes in the silhouette were filled.
    HolesFilled {
        /// Their share of the area, 0 to 1.
        share: f32,
    },
    /// Gaps in a frayed crown, or between its parts, were closed.
    GapsClosed {
        /// The widest gap closed, in units of the drawing.
        width: f32,
    },
    /// No trunk was seen: the silhouette is all crown.
    NoTrunk,
    /// A tree of which nothing could be used was left out.
    TreeDropped {
        /// Its name.
        tree: String,
    },
}

impl fmt::Display for ReadRepair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |share: &f32| 100.0 * share;
        match self {
            Self::StrayShapes { count } => {
                write!(f, "{count} shapes outside layers and trees were left out")
            }
            Self::LinesDropped { count } => {
                write!(f, "{count} open lines beside the filled shapes were left out")
            }
            Self::TrunkThinned { tree } if tree.is_empty() => {
                f.write_str("the trunk is drawn as an area; its middle line was taken")
            }
            Self::TrunkThinned { tree } => {
                write!(f, "the trunk of '{tree}' is drawn as an area; its middle line was taken")
            }
            Self::BackgroundDropped => {
                f.write_str("a shape as large as the drawing was left out as its background")
            }
            Self::PartsBridged { count } => {
                write!(f, "{count} parts near the tree were joined to it")
            }
            Self::PartsDropped { count, share } => write!(
                f,
                "{count} parts apart from the tree, {:.1} % of the area, were left out",
                percent(share)
            ),
            Self::HolesFilled { share } => {
                write!(f, "holes of {:.1} % of the area were filled", percent(share))
            }
            Self::GapsClosed { width } => {
                write!(f, "gaps of up to {width:.3} units in the crown were closed")
            }
            Self::NoTrunk => f.write_str("no trunk was seen; the silhouette is all crown"),
            Self::TreeDropped { tree } => {
                write!(f, "nothing of the tree '{tree}' could be used")
            }
        }
    }
}

#[cfg(test)]
mod tests;
