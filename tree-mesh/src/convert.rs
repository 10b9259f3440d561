//! Our axes to an engine's: handedness, up, unit, winding and texture v, in this one place.
//!
//! | | hands | up | unit | front faces | v | from ours |
//! |---|---|---|---|---|---|---|
//! | glTF, Bevy, three.js | right | Y | m | counter-clockwise | down | as it is |
//! | Godot 4 | right | Y | m | clockwise | down | as it is |
//! | Unity | left | Y | m | clockwise | up | (−x, y, z) |
//! | Unreal | left | Z | cm | counter-clockwise | down | 100 (x, z, y) |
//! | Blender | right | Z | m | counter-clockwise | up | (x, −z, y) |
//!
//! Clockwise or not is meant as seen on the screen, from outside. Relabelling axes does not change
//! what is seen, so only what an engine takes for the front decides whether triangles are turned.
//!
//! Sources: glTF 2.0 section 3.4 (axes, units, winding); Godot's `SurfaceTool` ("clockwise winding
//! order for front faces"); Unreal's `EFaceWindingOrder` (the renderer takes faces whose cross product,
//! by its left-handed axes, opposes the normal: counter-clockwise on the screen); Unity's glTF
//! importers, which negate x and the tangent's w; Unreal's, which exchanges y and z.

use glam::{Vec2, Vec3, Vec4};

/// Whose axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Convention {
    /// Ours: glTF, also Bevy and three.js.
    #[default]
    Gltf,
    /// Godot 4.
    Godot,
    /// Unity.
    Unity,
    /// Unreal Engine.
    Unreal,
    /// Blender.
    Blender,
}

impl Convention {
    /// Every convention.
    pub const ALL: [Self; 5] = [Self::Gltf, Self::Godot, Self::Unity, Self::Unreal, Self::Blender];

    /// Their length units in one of our metres.
    #[must_use]
    pub const fn unit(self) -> f32 {
        match self {
            Self::Unreal => 100.0,
            _ => 1.0,
        }
    }

    /// Whether their axes form a left hand.
    #[must_use]
    pub const fn is_left_handed(self) -> bool {
        matches!(self, Self::Unity | Self::Unreal)
    }

    /// Whether their front faces run clockwise, so that triangles must be turned.
    #[must_use]
    pub const fn is_clockwise(self) -> bool {
        matches!(self, Self::Unity | Self::Godot)
    }

    /// Whether their texture v runs upwards.
    #[must_use]
    pub const fn is_v_up(self) -> bool {
        matches!(self, Self::Unity | Self::Blender)
    }

    /// A unit vector (normal, axis) of ours in their axes.
    #[must_use]
    pub const fn direction(self, v: Vec3) -> Vec3 {
        match self {
            Self::Gltf | Self::Godot => v,
            Self::Unity => Vec3::new(-v.x, v.y, v.z),
            Self::Unreal => Vec3::new(v.x, v.z, v.y),
            Self::Blender => Vec3::new(v.x, -v.z, v.y),
        }
    }

    /// A unit vector of theirs in our axes; the inverse of [`direction`](Self::direction), exactly.
    #[must_use]
    pub const fn direction_back(self, v: Vec3) -> Vec3 {
        match self {
            Self::Blender => Vec3::new(v.x, v.z, -v.y),
            _ => self.direction(v),
        }
    }

    /// A place of ours, in their axes and unit.
    #[must_use]
    pub fn position(self, p: Vec3) -> Vec3 {
        self.direction(p) * self.unit()
    }

    /// A place of theirs, in ours.
    #[must_use]
    pub fn position_back(self, p: Vec3) -> Vec3 {
        self.direction_back(p) / self.unit()
    }

    /// A tangent. Its w is turned so that `w * normal.cross(tangent)`, with the arithmetic of their
    /// shaders, points the way green runs in their normal maps: up the picture, but down in Unreal
    /// (whose normal maps have green turned over, as DirectX).
    #[must_use]
    pub fn tangent(self, t: Vec4) -> Vec4 {
        self.direction(t.truncate()).extend(t.w * self.tangent_sign())
    }

    /// The inverse of [`tangent`](Self::tangent).
    #[must_use]
    pub fn tangent_back(self, t: Vec4) -> Vec4 {
        self.direction_back(t.truncate()).extend(t.w * self.tangent_sign())
    }

    /// A mirror turns a cross product over, and so does green that runs downwards.
    const fn tangent_sign(self) -> f32 {
        match self {
            Self::Unity => -1.0,
            _ => 1.0,
        }
    }

    /// Texture coordinates; its own inverse (within a rounding where v is turned over).
    #[must_use]
    pub fn uv(self, uv: Vec2) -> Vec2 {
        if self.is_v_up() { Vec2::new(uv.x, 1.0 - uv.y) } else { uv }
    }

    /// The corners of a triangle, turned where their front faces run clockwise; its own inverse.
    #[must_use]
    pub const fn triangle(self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        if self.is_clockwise() { [a, c, b] } else { [a, b, c] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: Vec3 = Vec3::new(1.0, 2.0, 3.0);

    #[test]
    fn up_and_hands_are_what_the_engine_says() {
        for space in Convention::ALL {
            let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| space.direction(axis));
            let up = match space {
                Convention::Unreal | Convention::Blender => Vec3::Z,
                _ => Vec3::Y,
            };
            assert_eq!(y, up, "{space:?}");
            let hand = if space.is_left_handed() { -1.0 } else { 1.0 };
            assert_eq!(x.cross(y).dot(z), hand, "{space:?}");
        }
        assert_eq!(Convention::Unreal.position(P), Vec3::new(100.0, 300.0, 200.0));
    }

    #[test]
    fn there_and_back_is_the_same() {
        let tangent = Vec4::new(0.6, 0.0, 0.8, -1.0);
        for space in Convention::ALL {
            assert!(space.position_back(space.position(P)).abs_diff_eq(P, 1e-6), "{space:?}");
            assert_eq!(space.direction_back(space.direction(P)), P, "{space:?}");
            assert_eq!(space.tangent_back(space.tangent(tangent)), tangent, "{space:?}");
            assert_eq!(space.uv(space.uv(Vec2::new(0.25, 0.75))), Vec2::new(0.25, 0.75));
            assert_eq!(space.triangle(space.triangle([1, 2, 3])), [1, 2, 3]);
        }
    }

    #[test]
    fn cross_products_of_front_faces_are_those_the_engines_document() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for space in Convention::ALL {
            let [a, b, c] = space.triangle([0, 1, 2]).map(|i| space.position(corners[i as usize]));
            let along = (b - a).cross(c - a).dot(space.direction(Vec3::Z)) > 0.0;
            let opposes = matches!(space, Convention::Unreal | Convention::Godot);
            assert_eq!(along, !opposes, "{space:?}");
        }
    }

    #[test]
    fn the_bitangent_runs_as_green_does() {
        let (normal, tangent) = (Vec3::Z, Vec4::new(1.0, 0.0, 0.0, 1.0));
        let up = tangent.w * normal.cross(tangent.truncate());
        for space in Convention::ALL {
            let (n, t) = (space.direction(normal), space.tangent(tangent));
            let found = t.w * n.cross(t.truncate());
            let down = space == Convention::Unreal;
            let wanted = space.direction(if down { -up } else { up });
            assert!(found.abs_diff_eq(wanted, 1e-6), "{space:?}: {found}");
        }
    }
}
