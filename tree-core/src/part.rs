//! Borrowed triangles: what a mesh and a modeler that reads one know of each other.

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
