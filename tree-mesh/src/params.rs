//! How fine the mesh is, and how bark and leaves are laid on.

use crate::error::Result;
use tree_core::{Continuation, ParameterError};

/// How a tree becomes triangles. Lengths in metres, angles in radians.
///
/// ```
/// use tree_mesh::MeshParams;
/// let coarse = MeshParams { max_sides: 6, error: tree_mesh::ErrorBound::Metres(0.02), ..Default::default() };
/// assert!(coarse.validate().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshParams {
    /// Which child goes on at a fork and which start tubes of their own. Default the thickest.
    pub continuation: Continuation,
    /// Fewest sides of a tube, 3 to `max_sides`. Default 3.
    pub min_sides: u32,
    /// Most sides of a tube, 3 to 128. Default 20. The cost of trunk and boughs grows with it.
    pub max_sides: u32,
    /// How far the mesh may leave the round, curved branch. Default 3 mm. Rules the number of sides
    /// between the two bounds above, and the number of rings.
    pub error: ErrorBound,
    /// The line drawn through the nodes of an axis. Default [`CurveFit::Through`].
    pub fit: CurveFit,
    /// Longest stretch of an axis without a ring, 1 mm to 1 km. Default 1 m: branches need rings to
    /// bend in the wind.
    pub max_strip: f32,
    /// Thinner wood is drawn with this radius, 0.01 mm to 0.1 m. Default 0.5 mm.
    pub min_radius: f32,
    /// Width of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m. Rounded for each axis so
    /// that it goes round a whole number of times.
    pub bark_width: f32,
    /// Height of the bark texture on the tree, 1 mm to 1 km. Default 0.5 m.
    pub bark_length: f32,
    /// How much wider the trunk is at the ground, as a share of its radius, 0 to 3; 0 turns the
    /// root flare off. Default 0.35.
    pub flare: f32,
    /// Height of the root flare in radii of the trunk, 0.1 to 20. Default 3.
    pub flare_height: f32,
    /// Number of buttresses in the flare, 0 to 12. Default 5.
    pub flare_lobes: u32,
    /// How deep the flare is cut between buttresses, 0 (round) to 0.9. Default 0.5.
    pub flare_lobe_depth: f32,
    /// Factor on the length of every leaf, 0.01 to 100. Default 1.
    pub leaf_scale: f32,
    /// Factor on the width of every leaf, 0.01 to 100. Default 1: as wide as its
    /// [`LeafLook`](crate::LeafLook) says.
    pub leaf_width: f32,
    /// How far leaf normals turn from the leaf's own towards the outside of the crown, 0 to 1.
    /// Default 0.6: soft light over the whole crown.
    pub leaf_rounding: f32,
    /// Whether vertices get tangents, 16 bytes each: for materials with normal maps. Default false:
    /// built-in materials have none, and with tangents ten million triangles of leaf cards would take
    /// more than a gigabyte.
    pub tangents: bool,
    /// Whether vertices get texture coordinates for a light map, 8 bytes each. Default false.
    pub lightmap: bool,
}

/// The line that is drawn through the nodes of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CurveFit {
    /// Straight from node to node.
    Straight,
    /// A clamped cubic B-spline through the nodes: what was modelled stays where it is.
    #[default]
    Through,
    /// A clamped cubic B-spline with the nodes as control points: passes near inner nodes, and calms
    /// what jitters, such as scanned skeletons (Neubert 2012, Eq. 5.14).
    Near,
}

/// How far a mesh may leave the exact shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ErrorBound {
    /// A length, 0.01 mm to 1 m.
    Metres(f32),
    /// What a camera sees as so many pixels: the nearer it comes, the finer the mesh.
    Pixels {
        /// Width of the error on the screen in pixels, 0.01 to 1000.
        pixels: f32,
        /// From the eye to the tree in metres, 0.01 to 1e6.
        distance: f32,
        /// Vertical field of view in radians, 0.01 to 3.
        fov_y: f32,
        /// Height of the screen in pixels, 1 or more.
        height: u32,
    },
}

impl Default for ErrorBound {
    fn default() -> Self {
        Self::Metres(0.003)
    }
}

impl ErrorBound {
    const MIN: f32 = 1e-5;
    const MAX: f32 = 1.0;

    /// The error as a length, between 0.01 mm and 1 m.
    #[must_use]
    pub fn metres(self) -> f32 {
        let metres = match self {
            Self::Metres(metres) => metres,
            Self::Pixels { pixels, distance, fov_y, height } => {
                pixels * 2.0 * distance * libm::tanf(0.5 * fov_y) / height.max(1) as f32
            }
        };
        metres.clamp(Self::MIN, Self::MAX)
    }

    fn validate(self) -> Result<()> {
        match self {
            Self::Metres(metres) => within("error", metres.into(), 1e-5, 1.0),
            Self::Pixels { pixels, distance, fov_y, height } => {
                within("error.pixels", pixels.into(), 0.01, 1000.0)?;
                within("error.distance", distance.into(), 0.01, 1e6)?;
                within("error.fov_y", fov_y.into(), 0.01, 3.0)?;
                within("error.height", height.into(), 1.0, u32::MAX.into())
            }
        }
    }
}

impl Default for MeshParams {
    fn default() -> Self {
        Self {
            continuation: Continuation::Thickest,
            min_sides: 3,
            max_sides: 20,
            error: ErrorBound::default(),
            fit: CurveFit::default(),
            max_strip: 1.0,
            min_radius: 0.0005,
            bark_width: 0.5,
            bark_length: 0.5,
            flare: 0.35,
            flare_height: 3.0,
            flare_lobes: 5,
            flare_lobe_depth: 0.5,
            leaf_scale: 1.0,
            leaf_width: 1.0,
            leaf_rounding: 0.6,
            tangents: false,
            lightmap: false,
        }
    }
}

impl MeshParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the first field at fault and its range.
    pub fn validate(&self) -> Result<()> {
        self.error.validate()?;
        let max_sides = f64::from(self.max_sides);
        for (field, found, min, max) in [
            ("max_sides", max_sides, 3.0, 128.0),
            ("min_sides", f64::from(self.min_sides), 3.0, max_sides),
            ("max_strip", f64::from(self.max_strip), 0.001, 1000.0),
            ("min_radius", f64::from(self.min_radius), 1e-5, 0.1),
            ("bark_width", f64::from(self.bark_width), 0.001, 1000.0),
            ("bark_length", f64::from(self.bark_length), 0.001, 1000.0),
            ("flare", f64::from(self.flare), 0.0, 3.0),
            ("flare_height", f64::from(self.flare_height), 0.1, 20.0),
            ("flare_lobes", f64::from(self.flare_lobes), 0.0, 12.0),
            ("flare_lobe_depth", f64::from(self.flare_lobe_depth), 0.0, 0.9),
            ("leaf_scale", f64::from(self.leaf_scale), 0.01, 100.0),
            ("leaf_width", f64::from(self.leaf_width), 0.01, 100.0),
            ("leaf_rounding", f64::from(self.leaf_rounding), 0.0, 1.0),
        ] {
            within(field, found, min, max)?;
        }
        Ok(())
    }
}

fn within(field: &'static str, found: f64, min: f64, max: f64) -> Result<()> {
    // The bounds are decimals; a field given the same decimal as f32 may lie half a step outside.
    let slack = f64::from(f32::EPSILON);
    if (min * (1.0 - slack)..=max * (1.0 + slack)).contains(&found) {
        return Ok(());
    }
    Err(ParameterError { field: field.into(), found, min, max }.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_and_the_ends_of_ranges_pass() {
        MeshParams::default().validate().unwrap();
        let ends = MeshParams {
            min_sides: 3,
            max_sides: 3,
            error: ErrorBound::Metres(1e-5),
            min_radius: 0.1,
            leaf_rounding: 1.0,
            flare_lobe_depth: 0.9,
            ..Default::default()
        };
        ends.validate().unwrap();
    }

    #[test]
    fn the_field_at_fault_is_named() {
        let error = |change: fn(&mut MeshParams)| {
            let mut params = MeshParams::default();
            change(&mut params);
            params.validate().unwrap_err().to_string()
        };
        assert!(error(|p| p.min_sides = 25).starts_with("min_sides is 25, allowed is 3 to 20"));
        assert!(error(|p| p.max_sides = 2).starts_with("max_sides"));
        assert!(error(|p| p.error = ErrorBound::Metres(f32::NAN)).starts_with("error"));
        let far = ErrorBound::Pixels { pixels: 1.0, distance: -1.0, fov_y: 1.0, height: 1080 };
        assert!(
            format!("{:?}", MeshParams { error: far, ..Default::default() }.validate())
                .contains("error.distance")
        );
        assert!(error(|p| p.min_radius = 0.0).starts_with("min_radius"));
        assert!(error(|p| p.leaf_rounding = -0.1).starts_with("leaf_rounding"));
    }
}
