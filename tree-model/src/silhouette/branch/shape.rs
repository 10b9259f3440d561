//! The form of a branch in the frame of its span (section 3.3).

use crate::silhouette::{Line, Outline};
use glam::Vec2;

/// A span: from a base to an end. Its frame has the base at the origin and the end at (0, 1); x points to the
/// outer side, away from the parent's tip, so that a branch on the left has the same form as one on the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    base: Vec2,
    /// The way along: from base to end.
    along: Vec2,
    /// The way across, as long.
    across: Vec2,
}

impl Span {
    /// The span of a branch; `left` where it is on its parent's left side. `None` without length.
    #[must_use]
    pub fn new(base: Vec2, end: Vec2, left: bool) -> Option<Self> {
        let along = end - base;
        let across = if left { along.perp() } else { -along.perp() };
        (along.length_squared() > 0.0 && along.is_finite()).then_some(Self { base, along, across })
    }

    /// Its length.
    #[must_use]
    pub fn length(&self) -> f32 {
        self.along.length()
    }

    /// A point in the frame.
    #[must_use]
    pub fn to_frame(&self, point: Vec2) -> Vec2 {
        let from_base = point - self.base;
        Vec2::new(from_base.dot(self.across), from_base.dot(self.along))
            / self.along.length_squared()
    }

    /// A point of the frame in the plane.
    #[must_use]
    pub fn from_frame(&self, point: Vec2) -> Vec2 {
        self.base + point.x * self.across + point.y * self.along
    }
}

/// A branch and its outline in the frame of the branch's span.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// From (0, 0) to (0, 1).
    pub line: Line,
    /// The outline of its foliage.
    pub outline: Outline,
}

impl Shape {
    /// The shape of a branch. `None` where base and end are the same.
    #[must_use]
    pub fn of(line: &Line, outline: &Outline, left: bool) -> Option<Self> {
        let span = Span::new(line.start(), line.end(), left)?;
        let in_frame = line.points().iter().map(|&point| span.to_frame(point)).collect();
        Some(Self {
            line: Line::new(in_frame)?,
            outline: outline.transformed(|point| span.to_frame(point))?,
        })
    }

    /// The angle from the span to the direction the branch leaves in, positive towards the outer side.
    #[must_use]
    pub fn leaving(&self) -> f32 {
        let foot = self.line.foot();
        libm::atan2f(foot.x, foot.y)
    }

    /// How far its outline reaches along the span, in spans; at least 1.
    #[must_use]
    pub fn reach(&self) -> f32 {
        self.outline.bounds().1.y.max(1.0)
    }

    /// The branch's line on another span.
    #[must_use]
    pub fn line_on(&self, span: &Span) -> Option<Line> {
        Line::new(self.line.points().iter().map(|&point| span.from_frame(point)).collect())
    }
}
