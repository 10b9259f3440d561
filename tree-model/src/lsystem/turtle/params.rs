//! What a word leaves open: sizes, angles, tropism, thickness.

use crate::error::{Result, check, check_finite};
use crate::glam::Vec3;
use tree_core::allometry::RadiusRule;

/// How a word becomes a tree. Lengths and widths are in the word's own units, made metres by
/// [`unit`](Self::unit) or [`height`](Self::height).
#[derive(Clone, Debug, PartialEq)]
pub struct TurtleParams {
    /// Length of an `F`, `f` or `G` without parameter, 0 to 1e6 units. Default 1.
    pub step: f64,
    /// Diameter of wood before the first `!`, 0 to 1e6 units. Default 0.1.
    pub width: f64,
    /// Angle of a rotation without parameter in degrees, −3600 to 3600. Default 22.5.
    pub angle: f64,
    /// What a `!` without parameter multiplies the width by, 0.01 to 1; `#` divides by it. Default √½: the
    /// cross-section halves.
    pub width_ratio: f64,
    /// Size of a `~` without parameter, 0 to 1e6 units. Default 1.
    pub leaf_size: f64,
    /// T, the direction shoots bend to, each component −1e3 to 1e3. Default straight down.
    pub tropism: Vec3,
    /// e, how readily they bend: after each `F` the heading turns by e |H × T| radians. −10 to 10, default 0.
    /// A module `_(e)` sets it for the rest of its branch.
    pub elasticity: f64,
    /// How widths become radii of nodes. Default [`Taper::Smooth`].
    pub taper: Taper,
    /// Whose radii are used. Default [`Thickness::Auto`] with the pipe model.
    pub thickness: Thickness,
    /// Metres a unit, 1e-6 to 1e6. Default 1.
    pub unit: f64,
    /// Height of the tree in metres, 0.001 to 1000: replaces `unit`. Default `None`. A word that never rises
    /// above its base is scaled by its greatest extent.
    pub height: Option<f32>,
    /// Radius of the base in metres, 1e-6 to 100: all radii are multiplied by the one factor that makes it so.
    /// Default `None`: widths are in the same unit as lengths.
    pub trunk_radius: Option<f32>,
    /// Whether polygons that look like leaves become leaves too. Default true.
    pub polygon_leaves: bool,
}

/// How the width of segments becomes the radius of nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Taper {
    /// The width is that of a segment's base; it narrows to the thickest segment that follows.
    #[default]
    Smooth,
    /// The width is that of a segment's upper end, as chains made of skeletons have it. The base of the tree
    /// has the first width that is set before wood is drawn.
    Ends,
}

/// Where radii come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness {
    /// From the widths of the word where it sets any with `!` or `#`, or else from this rule.
    Auto(RadiusRule),
    /// From the widths of the word.
    Word,
    /// From a rule, whatever the word says.
    Rule(RadiusRule),
}

impl Default for TurtleParams {
    fn default() -> Self {
        Self {
            step: 1.0,
            width: 0.1,
            angle: 22.5,
            width_ratio: std::f64::consts::FRAC_1_SQRT_2,
            leaf_size: 1.0,
            tropism: Vec3::NEG_Y,
            elasticity: 0.0,
            taper: Taper::Smooth,
            thickness: Thickness::Auto(RadiusRule::default()),
            unit: 1.0,
            height: None,
            trunk_radius: None,
            polygon_leaves: true,
        }
    }
}

impl TurtleParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter),
    /// [`ModelError::NotFinite`](crate::ModelError::NotFinite) or an error of the radius rule, naming the field.
    pub fn validate(&self) -> Result<()> {
        check("turtle.step", self.step, 0.0, 1e6)?;
        check("turtle.width", self.width, 0.0, 1e6)?;
        check("turtle.angle", self.angle, -3600.0, 3600.0)?;
        check("turtle.width_ratio", self.width_ratio, 0.01, 1.0)?;
        check("turtle.leaf_size", self.leaf_size, 0.0, 1e6)?;
        check_finite("turtle.tropism", self.tropism)?;
        check("turtle.tropism", self.tropism.abs().max_element(), 0.0, 1e3)?;
        check("turtle.elasticity", self.elasticity, -10.0, 10.0)?;
        check("turtle.unit", self.unit, 1e-6, 1e6)?;
        if let Some(height) = self.height {
            check("turtle.height", height, 0.001, 1000.0)?;
        }
        if let Some(radius) = self.trunk_radius {
            check("turtle.trunk_radius", radius, 1e-6, 100.0)?;
        }
        if let Thickness::Auto(rule) | Thickness::Rule(rule) = &self.thickness {
            rule.validate()?;
        }
        Ok(())
    }
}
