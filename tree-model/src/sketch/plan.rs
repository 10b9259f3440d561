//! The branches of a cleaned drawing: a tree in the plane.

use crate::error::{ModelError, Result};
use glam::Vec2;
use tree_core::NO_PARENT;

/// Branches in the plane as a tree of nodes in columns, in metres: x to the right, y up, the base at the origin.
///
/// Node 0 is the base and the only root; parents come before their children. The nodes lie on the strokes; each knows
/// its stroke, and where two strokes meet the node belongs to the one that bears the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    positions: Vec<Vec2>,
    parents: Vec<u32>,
    strokes: Vec<u32>,
    /// Where the base is in the drawing.
    pub base: Vec2,
    /// Metres for one unit of the drawing.
    pub scale: f32,
}

impl Plan {
    /// Checks and keeps columns. `strokes` has the index of each node's stroke in the drawing.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where columns differ in length, are empty, hold numbers that are not finite, or
    /// parents do not come first.
    pub fn from_columns(
        positions: Vec<Vec2>,
        parents: Vec<u32>,
        strokes: Vec<u32>,
        base: Vec2,
        scale: f32,
    ) -> Result<Self> {
        let n = positions.len();
        let fail = |problem: String| Err(ModelError::Sketch { problem });
        if n == 0 || parents.len() != n || strokes.len() != n {
            let (p, s) = (parents.len(), strokes.len());
            return fail(format!(
                "{n} positions, {p} parents and {s} strokes: all must be as many, and at least one"
            ));
        }
        if let Some(node) = positions.iter().position(|p| !p.is_finite()) {
            return fail(format!("positions[{node}] is not finite"));
        }
        if !(base.is_finite() && scale > 0.0 && scale.is_finite()) {
            return fail(format!(
                "base {base} and scale {scale} must be finite, the scale above 0"
            ));
        }
        for (node, &parent) in parents.iter().enumerate() {
            let sound = if node == 0 { parent == NO_PARENT } else { (parent as usize) < node };
            if !sound {
                return fail(format!(
                    "parents[{node}] is {parent}: parents come before their children, node 0 has none"
                ));
            }
        }
        Ok(Self { positions, parents, strokes, base, scale })
    }

    /// Number of nodes, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the base is always there")]
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Node positions in metres.
    #[must_use]
    pub fn positions(&self) -> &[Vec2] {
        &self.positions
    }

    /// Parent of each node; [`NO_PARENT`] for node 0.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// The drawing's stroke that each node lies on.
    #[must_use]
    pub fn strokes(&self) -> &[u32] {
        &self.strokes
    }

    /// The same plan, `factor` times as large in metres.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where that is not above 0, or a coordinate grows beyond what an f32 holds.
    pub fn scaled(self, factor: f32) -> Result<Self> {
        let positions = self.positions.iter().map(|&position| position * factor).collect();
        Self::from_columns(positions, self.parents, self.strokes, self.base, self.scale * factor)
    }

    /// A point of the plan, in the drawing's units.
    #[must_use]
    pub fn to_drawing(&self, point: Vec2) -> Vec2 {
        self.base + Vec2::new(point.x, -point.y) / self.scale
    }

    /// A point of the drawing, in metres of the plan.
    #[must_use]
    pub fn from_drawing(&self, point: Vec2) -> Vec2 {
        let out = (point - self.base) * self.scale;
        Vec2::new(out.x, -out.y)
    }
}
