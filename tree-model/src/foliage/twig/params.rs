//! Parameters of twigs.

use crate::error::{Result, check};
use crate::foliage::Phyllotaxis;
use crate::foliage::params::check_light;
use glam::Vec3;
use std::f32::consts::PI;

/// How a twig goes on (Neubert 2012, Fig. 5.8).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Branching {
    /// One main axis, with laterals. Spruce, oak.
    #[default]
    Monopodial,
    /// A chain of modules (monochasium): each ends, and its topmost lateral takes over. Linden, elm,
    /// beech.
    Sympodial {
        /// Internodes of a module, 1 to 100. Linden has 1.
        internodes: u32,
        /// Angle by which the next module turns off, 0 to π.
        turn: f32,
        /// Angle from the side of one turn to that of the next, -2π to 2π: π gives a zig-zag
        /// (scorpioid), 0 a curl (helicoid), anything between a helix.
        divergence: f32,
        /// Length of the dead tip that stays where a module ended, in internodes, 0 (shed) to 10.
        stub: f32,
    },
}

impl Branching {
    /// The zig-zag twig of linden, elm and beech: every internode turns the other way.
    #[must_use]
    pub const fn zigzag(turn: f32) -> Self {
        Self::Sympodial { internodes: 1, turn, divergence: PI, stub: 0.0 }
    }

    /// A helicoid twig: every module turns to the same side.
    #[must_use]
    pub const fn helicoid(internodes: u32, turn: f32) -> Self {
        Self::Sympodial { internodes, turn, divergence: 0.0, stub: 0.0 }
    }
}

/// Where twigs stand, how long they are and how they are held. Lengths in metres, angles in radians.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct TwigParams {
    /// How each twig goes on. Default monopodial.
    pub branching: Branching,
    /// Arrangement of twigs along shoots, and of lateral along main twigs. Default a spiral at the
    /// golden angle.
    pub arrangement: Phyllotaxis,
    /// Orders of twigs, 1 (no laterals) to 3. Default 2. Each multiplies the number of nodes.
    pub levels: u32,
    /// Twig-bearing nodes per metre of shoot, 1e-3 to 1e4. Default 10.
    pub per_metre: f32,
    /// Shoots bear twigs up to this distance from their tip, 0 to 1e6. Default 0.6.
    pub bearing: f32,
    /// Most twigs on one node of the skeleton, 1 to 64; more are left out and reported. Default 4.
    pub crowd: u32,
    /// Length of the longest twigs, 1e-5 to 1e6. Default 0.25.
    pub length: f32,
    /// Lengths vary by up to this share either way, 0 to 0.9. Default 0.25.
    pub length_variation: f32,
    /// How much shorter twigs are at the tip of the bearing shoot than at the lower end of the bearing
    /// zone, 0 to 1 of their length; a negative number, down to -1, makes the lower ones shorter
    /// (acrotony). Holds for laterals along their twig too. Default 0.5.
    pub taper: f32,
    /// Length of the twig that goes on at the tip of a shoot, in lengths of the longest, 0 (none) to 1.
    /// Default 0.6.
    pub terminal: f32,
    /// Length of laterals against the twig that bears them, 0 to 1. Default 0.45.
    pub lateral: f32,
    /// Length of an internode, 1e-5 to 1e6; a twig of less than half an internode is left out.
    /// Default 0.03.
    pub internode: f32,
    /// Angle between a twig and what bears it, 0 to π. Default 0.85.
    pub angle: f32,
    /// Random deviation of all angles, 0 to π; a quarter of it from one internode to the next.
    /// Default 0.2.
    pub jitter: f32,
    /// Stiffness of the wood: its modulus of elasticity in gigapascal, 1e-4 to 1e6. Default 4, a green
    /// twig; 0.2 hangs like a weeping willow.
    pub stiffness: f32,
    /// Weight of leaves and fruit in kilograms per metre of twig, 0 to 1000. Default 0.03.
    pub load: f32,
    /// How strongly growth turns down, per metre, -1000 to 1000: a twig that points sideways turns by
    /// so many radians a metre. Negative turns up, as most shoots do. Default 0.
    pub gravitropism: f32,
    /// How strongly growth turns to the light, per metre, -1000 to 1000. Default 0.5.
    pub phototropism: f32,
    /// Where light comes from; any length but 0. Default +Y.
    pub light: Vec3,
    /// Radius of every twig's tip, 1e-6 to 100. Default 0.0008.
    pub tip_radius: f32,
    /// How much the radius grows per metre towards the base, 0 to 1. Default 0.003.
    pub radius_taper: f32,
    /// Δ of the pipe model r₀^Δ = Σ rᵢ^Δ where laterals leave, 1 to 10. Default 2.49.
    pub pipe_exponent: f32,
    /// Thickest a twig may be at its base, as a share of the host's radius there, 0 to 1; a thicker one
    /// is made thinner as a whole. Default 0.75.
    pub radius_share: f32,
}

impl Default for TwigParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl TwigParams {
    /// The default of every field, for constants.
    pub const DEFAULT: Self = Self {
        branching: Branching::Monopodial,
        arrangement: Phyllotaxis::GOLDEN,
        levels: 2,
        per_metre: 10.0,
        bearing: 0.6,
        crowd: 4,
        length: 0.25,
        length_variation: 0.25,
        taper: 0.5,
        terminal: 0.6,
        lateral: 0.45,
        internode: 0.03,
        angle: 0.85,
        jitter: 0.2,
        stiffness: 4.0,
        load: 0.03,
        gravitropism: 0.0,
        phototropism: 0.5,
        light: Vec3::Y,
        tip_radius: 0.0008,
        radius_taper: 0.003,
        pipe_exponent: 2.49,
        radius_share: 0.75,
    };

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) or
    /// [`ModelError::NotFinite`](crate::ModelError::NotFinite), naming the field.
    pub fn validate(&self) -> Result<()> {
        if let Branching::Sympodial { internodes, turn, divergence, stub } = self.branching {
            check("twigs.branching.internodes", internodes, 1, 100)?;
            check("twigs.branching.turn", turn, 0.0, PI)?;
            check("twigs.branching.divergence", divergence, -2.0 * PI, 2.0 * PI)?;
            check("twigs.branching.stub", stub, 0.0, 10.0)?;
        }
        self.arrangement.validate("twigs.arrangement")?;
        check("twigs.levels", self.levels, 1, 3)?;
        check("twigs.per_metre", self.per_metre, 1e-3_f32, 1e4)?;
        check("twigs.bearing", self.bearing, 0.0, 1e6)?;
        check("twigs.crowd", self.crowd, 1, 64)?;
        check("twigs.length", self.length, 1e-5_f32, 1e6)?;
        check("twigs.length_variation", self.length_variation, 0.0, 0.9_f32)?;
        check("twigs.taper", self.taper, -1.0, 1.0)?;
        check("twigs.terminal", self.terminal, 0.0, 1.0)?;
        check("twigs.lateral", self.lateral, 0.0, 1.0)?;
        check("twigs.internode", self.internode, 1e-5_f32, 1e6)?;
        check("twigs.angle", self.angle, 0.0, PI)?;
        check("twigs.jitter", self.jitter, 0.0, PI)?;
        check("twigs.stiffness", self.stiffness, 1e-4_f32, 1e6)?;
        check("twigs.load", self.load, 0.0, 1000.0)?;
        check("twigs.gravitropism", self.gravitropism, -1000.0, 1000.0)?;
        check("twigs.phototropism", self.phototropism, -1000.0, 1000.0)?;
        check_light("twigs.light", self.light)?;
        check("twigs.tip_radius", self.tip_radius, 1e-6_f32, 100.0)?;
        check("twigs.radius_taper", self.radius_taper, 0.0, 1.0)?;
        check("twigs.pipe_exponent", self.pipe_exponent, 1.0, 10.0)?;
        check("twigs.radius_share", self.radius_share, 0.0, 1.0)
    }
}
