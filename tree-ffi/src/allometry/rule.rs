//! Which rule gives branches their radii.

use crate::border::{Failure, Result, Versioned, call, init, tree_status};
use tree_model::tree_core::allometry::{
    PipeModel, RadiusRule, StrandCount, StrandModel, TipDistance,
};

/// Which rule gives branches their radii: one of the `TREE_RADII_` constants.
pub type tree_radius_kind = u32;
/// The pipe model, for most trees: at every fork the powers of the radii above add up to that below
/// (da Vinci, Murray, Mandelbrot).
pub const TREE_RADII_PIPE: u32 = 0;
/// The further from the tip, the thicker; the higher the order of the axis, the thinner (Xu & Mould).
pub const TREE_RADII_TIP_DISTANCE: u32 = 1;
/// By counting strands that run from the base to the tips (Holton).
pub const TREE_RADII_STRANDS: u32 = 2;

/// Where the number of strands comes from: one of the `TREE_STRANDS_` constants.
pub type tree_strand_count = u32;
/// One strand for each tip, which makes the rule da Vinci's.
pub const TREE_STRANDS_PER_TIP: u32 = 0;
/// A number at the base, shared out at forks: the less a branch turns away, the more it gets.
pub const TREE_STRANDS_BY_ANGLE: u32 = 1;

/// How the radii of a whole skeleton are found. Begin with `tree_radius_rule_init`. No rule makes a
/// branch thicker than the one below.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_radius_rule {
    /// `sizeof(tree_radius_rule)`.
    pub struct_size: usize,
    /// `TREE_STRANDS_BY_ANGLE`: strands at the base, from the number of tips to 2⁵³. No default: 0,
    /// which is refused.
    pub strand_base: u64,
    /// Which rule. Default `TREE_RADII_PIPE`.
    pub kind: tree_radius_kind,
    /// Pipe: Δ in r₀^Δ = Σ rᵢ^Δ, 1 to 10. Default 2.49, Murray's; da Vinci's is 2, Mandelbrot's 8/3. A
    /// larger one makes the trunk thinner for the same tips.
    pub exponent: f32,
    /// Pipe: radius of every tip in metres, 1e-6 to 100. Default 0.002. With a `trunk_radius` only its
    /// proportion to `taper` matters.
    pub tip_radius: f32,
    /// Pipe: how much the radius grows per metre towards the base, 0 to 1. Default 0.002: a bare shoot
    /// of one metre is twice as thick at its base as at its tip.
    pub taper: f32,
    /// Pipe: radius of the root node in metres, 1e-6 to 100: all radii, those of tips too, are
    /// multiplied by the one factor that makes it so. Default 0: the tips decide.
    pub trunk_radius: f32,
    /// Tip distance: radius on the trunk one metre from the tip, in metres, 1e-6 to 100. Default 0.05.
    pub scale: f32,
    /// Tip distance: the power of the distance, 0 to 10. Default 0.3. The larger, the quicker branches
    /// taper.
    pub zeta: f32,
    /// Tip distance: smallest radius of any node in metres, 0 to 100. Default 0.001. With 0 a branch
    /// ends in a point.
    pub min_radius: f32,
    /// Strands: diameter of a branch of one strand in metres, 1e-6 to 100; one of S strands has √S
    /// times that. Default 0.004.
    pub strand_diameter: f32,
    /// Strands: where their number comes from. Default `TREE_STRANDS_PER_TIP`.
    pub strand_count: tree_strand_count,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_radius_rule {
    const NAME: &'static str = "tree_radius_rule";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&RadiusRule::default())
    }
}

impl tree_radius_rule {
    /// The rule in C's form; fields of other rules have their defaults.
    pub(crate) fn of(rule: &RadiusRule) -> Self {
        let (mut kind, mut pipe) = (TREE_RADII_PIPE, PipeModel::default());
        let (mut tip, mut strands) = (TipDistance::default(), StrandModel::default());
        match *rule {
            RadiusRule::TipDistance(rule) => (kind, tip) = (TREE_RADII_TIP_DISTANCE, rule),
            RadiusRule::Strands(rule) => (kind, strands) = (TREE_RADII_STRANDS, rule),
            RadiusRule::Pipe(rule) => pipe = rule,
            // The enum may grow; a rule without a constant cannot come out of this library's presets.
            _ => {}
        }
        let (strand_count, strand_base) = match strands.count {
            StrandCount::PerTip => (TREE_STRANDS_PER_TIP, 0),
            StrandCount::ByAngle { base } => (TREE_STRANDS_BY_ANGLE, base),
        };
        Self {
            struct_size: size_of::<Self>(),
            strand_base,
            kind,
            exponent: pipe.exponent,
            tip_radius: pipe.tip_radius,
            taper: pipe.taper,
            trunk_radius: pipe.trunk_radius.unwrap_or(0.0),
            scale: tip.scale,
            zeta: tip.zeta,
            min_radius: tip.min_radius,
            strand_diameter: strands.strand_diameter,
            strand_count,
        }
    }

    /// The rule in Rust's form, not yet checked against its ranges.
    pub(crate) fn rust(&self) -> Result<RadiusRule> {
        match self.kind {
            TREE_RADII_PIPE => Ok(RadiusRule::Pipe(PipeModel {
                exponent: self.exponent,
                tip_radius: self.tip_radius,
                taper: self.taper,
                trunk_radius: (self.trunk_radius != 0.0).then_some(self.trunk_radius),
            })),
            TREE_RADII_TIP_DISTANCE => Ok(RadiusRule::TipDistance(self.tip_distance())),
            TREE_RADII_STRANDS => Ok(RadiusRule::Strands(self.strands()?)),
            other => Err(Failure::not_one_of("rule.kind", other, "TREE_RADII_")),
        }
    }

    /// The fields of the rule by distance to the tip, whatever the kind.
    pub(super) fn tip_distance(&self) -> TipDistance {
        TipDistance { scale: self.scale, zeta: self.zeta, min_radius: self.min_radius }
    }

    /// The fields of the rule by strands, whatever the kind.
    pub(super) fn strands(&self) -> Result<StrandModel> {
        let count = match self.strand_count {
            TREE_STRANDS_PER_TIP => StrandCount::PerTip,
            TREE_STRANDS_BY_ANGLE => StrandCount::ByAngle { base: self.strand_base },
            other => return Err(Failure::not_one_of("rule.strand_count", other, "TREE_STRANDS_")),
        };
        Ok(StrandModel { strand_diameter: self.strand_diameter, count })
    }
}

/// Makes `rule`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_radius_rule_init(
    rule: *mut tree_radius_rule,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(rule, size) })
}
