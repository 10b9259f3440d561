//! What comes in: borrowed triangles, part by part.

use crate::error::{ModelError, Result};
use glam::{Vec2, Vec3};

/// What a part of a mesh is made of, as far as the caller knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hint {
    /// Not known: name, alpha and shape decide.
    #[default]
    Auto,
    /// Bark.
    Wood,
    /// Leaves, needles, flowers, or cards of whole sprays.
    Leaves,
    /// Neither: ground, pots, labels.
    Ignore,
}

/// Triangles of one material. Any unit of length; +Y up.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part<'a> {
    /// Vertex positions, finite.
    pub positions: &'a [Vec3],
    /// Texture coordinates, one per vertex, v downwards; may be empty.
    pub uvs: &'a [Vec2],
    /// Three indices per triangle.
    pub indices: &'a [u32],
    /// Name of the material or object. It names the leaf kind, and may tell wood from leaves.
    pub name: &'a str,
    /// What it is made of.
    pub hint: Hint,
    /// Whether its texture has holes.
    pub alpha_masked: bool,
    /// Whether both faces are drawn.
    pub double_sided: bool,
}

impl Part<'_> {
    /// Checks columns and indices; `number` names the part in errors.
    pub(super) fn check(&self, number: usize) -> Result<()> {
        let bad = |problem: String| Err(ModelError::BadPart { part: number, problem });
        if let Some(row) = self.positions.iter().position(|p| !p.is_finite()) {
            return Err(ModelError::NotFinite {
                field: format!("parts[{number}].positions[{row}]"),
            });
        }
        if let Some(row) = self.uvs.iter().position(|uv| !uv.is_finite()) {
            return Err(ModelError::NotFinite { field: format!("parts[{number}].uvs[{row}]") });
        }
        if !self.uvs.is_empty() && self.uvs.len() != self.positions.len() {
            let (uvs, vertices) = (self.uvs.len(), self.positions.len());
            return bad(format!("{uvs} uvs for {vertices} vertices; one for each, or none"));
        }
        if !self.indices.len().is_multiple_of(3) {
            return bad(format!("{} indices, which is no multiple of 3", self.indices.len()));
        }
        match self.indices.iter().find(|&&i| i as usize >= self.positions.len()) {
            Some(i) => bad(format!("index {i}, but there are {} vertices", self.positions.len())),
            None => Ok(()),
        }
    }
}
