//! Branches on an axis.

use super::System;
use crate::silhouette::branch::{Shape, Span};
use crate::silhouette::{Line, Outline};
use glam::Vec2;

/// Why there is a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Origin {
    /// A bump of the outline.
    Bump,
    /// The outline was not covered there.
    Coverage,
    /// A person drew it.
    Drawn,
}

/// A branch in the plane, on the axis of a [`System`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Lateral {
    /// Names the branch for as long as it is there. No two branches of a plan have the same.
    pub id: u32,
    /// Why it is there.
    pub origin: Origin,
    /// Where it leaves the axis, as a share of the axis' length.
    pub t: f32,
    /// Whether it is on the left side of the axis, looking towards its tip.
    pub left: bool,
    /// Its points. For a branch drawn from another viewpoint: as it would be seen when turned into the plane.
    pub line: Line,
    /// The outline of its foliage: inferred, or as drawn.
    pub outline: Outline,
    /// Radius of its bump in metres, or of what stands for one.
    pub radius: f32,
    /// The part of the parent's outline it may share, as lengths along; `None` for all.
    pub stretch: Option<[f32; 2]>,
    /// Where round the axis it was drawn, in radians from the right side of the plane; `None` where that is to be found.
    pub azimuth: Option<f32>,
    /// Whose style it has: the branch of this id. `None` for the nearest one whose outline was drawn.
    pub style: Option<u32>,
    /// Its own branches, where its outline was drawn.
    pub system: Option<Box<System>>,
}

impl Lateral {
    /// Its span; `None` where base and end are the same.
    #[must_use]
    pub fn span(&self) -> Option<Span> {
        Span::new(self.line.start(), self.line.end(), self.left)
    }

    /// Its form and outline in the frame of its span.
    #[must_use]
    pub fn shape(&self) -> Option<Shape> {
        Shape::of(&self.line, &self.outline, self.left)
    }

    /// Gives it another line, perhaps on the other side, and carries its system along: the axis is the new line, what stands on
    /// it moves with its place there. The outline stays.
    pub(crate) fn reshape(&mut self, line: Line, left: bool) {
        let spans = self.span().zip(Span::new(line.start(), line.end(), left));
        if let (Some((old, new)), Some(system)) = (spans, &mut self.system) {
            system.carry(&|point: Vec2| new.from_frame(old.to_frame(point)));
            system.axis = line.clone();
            for inner in &mut system.laterals {
                let off = line.at(inner.t) - inner.line.start();
                let points = inner.line.points().iter().map(|&point| point + off).collect();
                let outline = inner.outline.transformed(|point| point + off);
                if let (Some(moved), Some(outline)) = (Line::new(points), outline) {
                    inner.reshape(moved, inner.left);
                    inner.outline = outline;
                }
            }
        }
        (self.line, self.left) = (line, left);
    }
}
