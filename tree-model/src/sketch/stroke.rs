//! Strokes as they come in.

use glam::Vec2;

/// What a stroke shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Role {
    /// The trunk. It begins the tree.
    Trunk,
    /// A branch.
    Branch,
    /// The crown's outline, or a piece of it.
    Crown,
}

/// One line of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Stroke {
    /// Its points in the drawing's own units, y downwards.
    pub points: Vec<Vec2>,
    /// What it shows; `None` where clean-up is to find out.
    pub role: Option<Role>,
    /// Whether its end is joined to its beginning.
    pub closed: bool,
    /// Whether it is the outline of a filled area rather than a line: of a branch so drawn the middle line is meant.
    pub filled: bool,
    /// What messages call it, for example an SVG id. Empty: it is called by its number.
    pub name: String,
}

impl Stroke {
    /// An open line of which clean-up finds out what it shows.
    #[must_use]
    pub fn new(points: Vec<Vec2>) -> Self {
        Self { points, ..Self::default() }
    }

    /// A line that shows `role`.
    #[must_use]
    pub fn of(role: Role, points: Vec<Vec2>) -> Self {
        Self { points, role: Some(role), ..Self::default() }
    }
}

/// A drawing: strokes in the order they were drawn, in any units, y downwards as on screens and in SVG.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Drawing {
    /// The strokes.
    pub strokes: Vec<Stroke>,
}

impl Drawing {
    /// What messages call stroke `index`: its name, or its number.
    #[must_use]
    pub fn name_of(&self, index: usize) -> String {
        match self.strokes.get(index) {
            Some(stroke) if !stroke.name.is_empty() => {
                format!("strokes[{index}] '{}'", stroke.name)
            }
            _ => format!("strokes[{index}]"),
        }
    }
}
