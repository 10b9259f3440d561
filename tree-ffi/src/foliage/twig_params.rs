//! Parameters of twigs.

use super::arrangement::{Arrangement, tree_phyllotaxis};
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, read, tree_status,
};
use glam::Vec3;
use tree_model::foliage::{Branching, TwigParams};

/// How a twig goes on: one of the `TREE_BRANCHING_` constants.
pub type tree_branching = u32;
/// One main axis, with laterals. Spruce, oak.
pub const TREE_BRANCHING_MONOPODIAL: u32 = 0;
/// A chain of modules: each ends, and its topmost lateral takes over. Linden, elm, beech.
pub const TREE_BRANCHING_SYMPODIAL: u32 = 1;

/// Where twigs stand, how long they are and how they are held. Lengths in metres, angles in radians.
/// Begin with `tree_twig_params_init`, or with a species' own from `tree_foliage_preset`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_twig_params {
    /// `sizeof(tree_twig_params)`.
    pub struct_size: usize,
    /// How each twig goes on. Default `TREE_BRANCHING_MONOPODIAL`.
    pub branching: tree_branching,
    /// Sympodial: internodes of a module, 1 to 100. Default 1, as linden has.
    pub module_internodes: u32,
    /// Sympodial: angle by which the next module turns off, 0 to π. Default 0.
    pub module_turn: f32,
    /// Sympodial: angle from the side of one turn to that of the next, -2π to 2π. Default π, a zig-zag;
    /// 0 gives a curl, anything between a helix.
    pub module_divergence: f32,
    /// Sympodial: length of the dead tip that stays where a module ended, in internodes, 0 to 10.
    /// Default 0: it is shed.
    pub module_stub: f32,
    /// How twigs stand along shoots, and laterals along main twigs. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    pub arrangement: tree_phyllotaxis,
    /// Spiral: angle from one twig to the next, -2π to 2π. Default the golden angle, 2.39996.
    pub divergence: f32,
    /// Whorled: twigs at a node, 3 to 64. No default: 0, which is refused.
    pub whorl: u32,
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
    /// zone, 0 to 1 of their length; a negative number, down to -1, makes the lower ones shorter. Holds
    /// for laterals along their twig too. Default 0.5.
    pub taper: f32,
    /// Length of the twig that goes on at the tip of a shoot, in lengths of the longest, 0 (none) to 1.
    /// Default 0.6.
    pub terminal: f32,
    /// Length of laterals against the twig that bears them, 0 to 1. Default 0.45.
    pub lateral: f32,
    /// Length of an internode, 1e-5 to 1e6; a twig of less than half an internode is left out. Default
    /// 0.03.
    pub internode: f32,
    /// Angle between a twig and what bears it, 0 to π. Default 0.85.
    pub angle: f32,
    /// Random deviation of all angles, 0 to π; a quarter of it from one internode to the next. Default
    /// 0.2.
    pub jitter: f32,
    /// Stiffness of the wood: its modulus of elasticity in gigapascal, 1e-4 to 1e6. Default 4, a green
    /// twig; 0.2 hangs like a weeping willow.
    pub stiffness: f32,
    /// Weight of leaves and fruit in kilograms per metre of twig, 0 to 1000. Default 0.03.
    pub load: f32,
    /// How strongly growth turns down, per metre, -1000 to 1000: a twig that points sideways turns by so
    /// many radians a metre. Negative turns up, as most shoots do. Default 0.
    pub gravitropism: f32,
    /// How strongly growth turns to the light, per metre, -1000 to 1000. Default 0.5.
    pub phototropism: f32,
    /// Where light comes from; any length but 0. Default 0, 1, 0.
    pub light: [f32; 3],
    /// Radius of every twig's tip, 1e-6 to 100. Default 0.0008.
    pub tip_radius: f32,
    /// How much the radius grows per metre towards the base, 0 to 1. Default 0.003.
    pub radius_taper: f32,
    /// Exponent of the pipe model where laterals leave, 1 to 10. Default 2.49.
    pub pipe_exponent: f32,
    /// Thickest a twig may be at its base, as a share of the radius of what bears it there, 0 to 1; a
    /// thicker one is made thinner as a whole. Default 0.75.
    pub radius_share: f32,
    /// Must be 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_twig_params {
    const NAME: &'static str = "tree_twig_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&TwigParams::default())
    }
}

/// A [`Branching`] as fields of a struct.
struct Modules {
    kind: tree_branching,
    internodes: u32,
    turn: f32,
    divergence: f32,
    stub: f32,
}

impl Modules {
    /// As fields; a monopodial twig has those of a zig-zag that does not turn.
    fn of(branching: Branching) -> Self {
        let kind = match branching {
            Branching::Monopodial => TREE_BRANCHING_MONOPODIAL,
            Branching::Sympodial { .. } => TREE_BRANCHING_SYMPODIAL,
        };
        match (branching, Branching::zigzag(0.0)) {
            (Branching::Sympodial { internodes, turn, divergence, stub }, _)
            | (_, Branching::Sympodial { internodes, turn, divergence, stub }) => {
                Self { kind, internodes, turn, divergence, stub }
            }
            _ => Self { kind, internodes: 0, turn: 0.0, divergence: 0.0, stub: 0.0 },
        }
    }
}

impl tree_twig_params {
    /// The parameters in C's form; fields of other arrangements have their defaults.
    pub(crate) fn of(params: &TwigParams) -> Self {
        let modules = Modules::of(params.branching);
        let Arrangement { kind: arrangement, divergence, whorl } =
            Arrangement::of(params.arrangement);
        Self {
            struct_size: size_of::<Self>(),
            branching: modules.kind,
            module_internodes: modules.internodes,
            module_turn: modules.turn,
            module_divergence: modules.divergence,
            module_stub: modules.stub,
            arrangement,
            divergence,
            whorl,
            levels: params.levels,
            per_metre: params.per_metre,
            bearing: params.bearing,
            crowd: params.crowd,
            length: params.length,
            length_variation: params.length_variation,
            taper: params.taper,
            terminal: params.terminal,
            lateral: params.lateral,
            internode: params.internode,
            angle: params.angle,
            jitter: params.jitter,
            stiffness: params.stiffness,
            load: params.load,
            gravitropism: params.gravitropism,
            phototropism: params.phototropism,
            light: params.light.to_array(),
            tip_radius: params.tip_radius,
            radius_taper: params.radius_taper,
            pipe_exponent: params.pipe_exponent,
            radius_share: params.radius_share,
            reserved: 0,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(crate) fn rust(&self) -> Result<TwigParams> {
        if self.reserved != 0 {
            return Err(Failure::new(TREE_ERROR_PARAMETER, "twigs.reserved must be 0"));
        }
        let arrangement =
            Arrangement { kind: self.arrangement, divergence: self.divergence, whorl: self.whorl };
        Ok(TwigParams {
            branching: self.rust_branching()?,
            arrangement: arrangement.rust("twigs.arrangement")?,
            levels: self.levels,
            per_metre: self.per_metre,
            bearing: self.bearing,
            crowd: self.crowd,
            length: self.length,
            length_variation: self.length_variation,
            taper: self.taper,
            terminal: self.terminal,
            lateral: self.lateral,
            internode: self.internode,
            angle: self.angle,
            jitter: self.jitter,
            stiffness: self.stiffness,
            load: self.load,
            gravitropism: self.gravitropism,
            phototropism: self.phototropism,
            light: Vec3::from_array(self.light),
            tip_radius: self.tip_radius,
            radius_taper: self.radius_taper,
            pipe_exponent: self.pipe_exponent,
            radius_share: self.radius_share,
        })
    }

    fn rust_branching(&self) -> Result<Branching> {
        match self.branching {
            TREE_BRANCHING_MONOPODIAL => Ok(Branching::Monopodial),
            TREE_BRANCHING_SYMPODIAL => Ok(Branching::Sympodial {
                internodes: self.module_internodes,
                turn: self.module_turn,
                divergence: self.module_divergence,
                stub: self.module_stub,
            }),
            other => Err(Failure::not_one_of("twigs.branching", other, "TREE_BRANCHING_")),
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twig_params_init(
    params: *mut tree_twig_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twig_params_check(params: *const tree_twig_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust()?.validate()?))
}
