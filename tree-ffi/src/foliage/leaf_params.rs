//! Parameters of leaf placement.

use super::arrangement::{Arrangement, tree_phyllotaxis};
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, read, tree_status,
};
use glam::Vec3;
use tree_model::foliage::{LeafForm, LeafParams, Palmate, Pinnate};

/// What one leaf consists of: one of the `TREE_LEAVES_` constants. Each leaflet and each needle becomes
/// one row of the foliage.
pub type tree_leaves_form = u32;
/// One blade. Oak, beech, linden.
pub const TREE_LEAVES_SIMPLE: u32 = 0;
/// Leaflets along a rachis. Ash, walnut, rowan; palms with feathers.
pub const TREE_LEAVES_PINNATE: u32 = 1;
/// Leaflets from one point, like fingers. Horse chestnut; palms with fans.
pub const TREE_LEAVES_PALMATE: u32 = 2;
/// A few needles from one sheath, evenly round its axis. Pines.
pub const TREE_LEAVES_FASCICLE: u32 = 3;
/// Many needles on a short shoot, from its axis to all sides. Larch, cedar.
pub const TREE_LEAVES_ROSETTE: u32 = 4;

/// Where leaves stand and how they are held. Lengths in metres, angles in radians. Begin with
/// `tree_leaf_params_init`, or with a species' own from `tree_foliage_preset`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_params {
    /// `sizeof(tree_leaf_params)`.
    pub struct_size: usize,
    /// How leaves stand along the shoot. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    pub arrangement: tree_phyllotaxis,
    /// Spiral: angle from one leaf to the next, -2π to 2π. Default the golden angle, 2.39996.
    pub divergence: f32,
    /// Whorled: leaves at a node, 3 to 64. No default: 0, which is refused.
    pub whorl: u32,
    /// What one leaf consists of. Default `TREE_LEAVES_SIMPLE`.
    pub form: tree_leaves_form,
    /// Pinnate: pairs of leaflets, 1 to 100. Default 4.
    pub pinnate_pairs: u32,
    /// Pinnate: whether a leaflet ends the rachis. Default 1.
    pub pinnate_odd: u32,
    /// Pinnate: length of the rachis above the petiole in lengths of the largest leaflet, 0 to 1000.
    /// Default 2.
    pub pinnate_rachis: f32,
    /// Pinnate: how far the rachis bends back over its length, -π to π. Default 0.4.
    pub pinnate_droop: f32,
    /// Pinnate: angle between rachis and leaflets at its base and at its tip, 0 to π. Default 1.2, 0.8.
    pub pinnate_angle: [f32; 2],
    /// Pinnate: size of the leaflets at base, middle and tip, 0.01 to 1. Default 0.75, 1, 0.8.
    pub pinnate_profile: [f32; 3],
    /// Pinnate: how far leaflets are raised out of the leaf's plane, -π/2 (hanging) to π/2. Default 0.
    pub pinnate_fold: f32,
    /// Pinnate: length of a leaflet's stalk in lengths of the largest leaflet, 0 to 2. Default 0.03.
    pub pinnate_petiolule: f32,
    /// Pinnate: pairs of leaflets on each pinna of a leaf that is pinnate twice, up to 50. Default 0:
    /// pinnate once.
    pub pinnate_pinna_pairs: u32,
    /// Pinnate twice: length of the longest pinna as a share of the rachis, 0.01 to 2. Default 0.5.
    pub pinnate_pinna: f32,
    /// Palmate: leaflets, 2 to 64. Default 7.
    pub palmate_leaflets: u32,
    /// Palmate: angle from the first leaflet to the last, 0 to 2π. Default 4.
    pub palmate_spread: f32,
    /// Palmate: size of the outermost leaflets against the middle one, 0.01 to 1. Default 0.55.
    pub palmate_outer: f32,
    /// Palmate: angle by which leaflets hang below the leaf's plane, -π/2 to π/2. Default 0.2.
    pub palmate_droop: f32,
    /// Fascicle: needles, 1 to 16. Rosette: needles, 1 to 128. No default: 0, which is refused.
    pub needles: u32,
    /// Fascicle: angle between a needle and the axis, 0 to π/2. Rosette: angle between the outermost
    /// needles and the axis, 0 to π. Default 0.
    pub needle_spread: f32,
    /// Distance between leaf-bearing nodes along the shoot, 1e-4 to 1e6. Default 0.07.
    pub spacing: f32,
    /// Shoots bear leaves up to this distance from their tip, 0 to 1e6. Default 0.55.
    pub bearing: f32,
    /// Length of a blade (of a full leaflet or needle where the leaf has many), 1e-6 to 1e6. Default
    /// 0.13.
    pub size: f32,
    /// Sizes vary by up to this share either way, 0 to 0.9. Default 0.25.
    pub size_variation: f32,
    /// How much smaller leaves are at the tip than at the lower end of the bearing zone, 0 to 0.9 of
    /// their size; a negative number, down to -0.9, makes those at the lower end smaller. Default 0.
    pub size_gradient: f32,
    /// Length of the petiole in lengths of the blade, 0 to 100; the blade stands off the shoot by as
    /// much. Default 0: whatever petiole there is belongs to the picture of the leaf.
    pub petiole: f32,
    /// Radius of the petiole in lengths of the blade, 0 to 0.5; used where stalks are grown too.
    /// Default 0.008.
    pub petiole_radius: f32,
    /// Angle between shoot and petiole, 0 (along the shoot) to π (back along it). Default 0.9.
    pub pitch: f32,
    /// Random deviation of all angles, 0 to π. Default 0.35.
    pub jitter: f32,
    /// How far blades hang: 0 not at all, 1 straight down. The petiole does not hang. Default 0.15.
    pub droop: f32,
    /// How far upper faces turn to the light by rolling about the midrib: 0 not at all, 1 as far as
    /// that brings them. Default 0.6.
    pub phototropism: f32,
    /// Largest angle between petiole and blade, 0 to π: after the roll, the blade turns towards the
    /// light by the share `phototropism` of what is left, but no more than this. Default 0: the midrib
    /// goes on as it was.
    pub lamina_turn: f32,
    /// Where light comes from; any length but 0. Default 0, 1, 0.
    pub light: [f32; 3],
    /// Whether each tip bears a leaf that goes on in its direction. Default 1.
    pub terminal: u32,
    /// The leaves' kind: an index into the species' leaf kinds, 0 to 65,535. Default 0.
    pub kind: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_params {
    const NAME: &'static str = "tree_leaf_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LeafParams::default())
    }
}

impl tree_leaf_params {
    /// The parameters in C's form; fields of other forms and arrangements have their defaults.
    pub(crate) fn of(params: &LeafParams) -> Self {
        let Arrangement { kind: arrangement, divergence, whorl } =
            Arrangement::of(params.arrangement);
        let (mut pinnate, mut palmate) = (Pinnate::default(), Palmate::default());
        let (mut needles, mut needle_spread) = (0, 0.0);
        let form = match params.form {
            LeafForm::Simple => TREE_LEAVES_SIMPLE,
            LeafForm::Pinnate(leaf) => {
                pinnate = leaf;
                TREE_LEAVES_PINNATE
            }
            LeafForm::Palmate(leaf) => {
                palmate = leaf;
                TREE_LEAVES_PALMATE
            }
            LeafForm::Fascicle { needles: n, spread } => {
                (needles, needle_spread) = (n, spread);
                TREE_LEAVES_FASCICLE
            }
            LeafForm::Rosette { needles: n, spread } => {
                (needles, needle_spread) = (n, spread);
                TREE_LEAVES_ROSETTE
            }
        };
        Self {
            struct_size: size_of::<Self>(),
            arrangement,
            divergence,
            whorl,
            form,
            pinnate_pairs: pinnate.pairs,
            pinnate_odd: pinnate.odd.into(),
            pinnate_rachis: pinnate.rachis,
            pinnate_droop: pinnate.droop,
            pinnate_angle: pinnate.angle,
            pinnate_profile: pinnate.profile,
            pinnate_fold: pinnate.fold,
            pinnate_petiolule: pinnate.petiolule,
            pinnate_pinna_pairs: pinnate.pinna_pairs,
            pinnate_pinna: pinnate.pinna,
            palmate_leaflets: palmate.leaflets,
            palmate_spread: palmate.spread,
            palmate_outer: palmate.outer,
            palmate_droop: palmate.droop,
            needles,
            needle_spread,
            spacing: params.spacing,
            bearing: params.bearing,
            size: params.size,
            size_variation: params.size_variation,
            size_gradient: params.size_gradient,
            petiole: params.petiole,
            petiole_radius: params.petiole_radius,
            pitch: params.pitch,
            jitter: params.jitter,
            droop: params.droop,
            phototropism: params.phototropism,
            lamina_turn: params.lamina_turn,
            light: params.light.to_array(),
            terminal: params.terminal.into(),
            kind: params.kind.into(),
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(crate) fn rust(&self) -> Result<LeafParams> {
        let arrangement =
            Arrangement { kind: self.arrangement, divergence: self.divergence, whorl: self.whorl };
        let kind = u16::try_from(self.kind).map_err(|_| {
            let text = format!("leaves.kind is {}, allowed is 0 to {}", self.kind, u16::MAX);
            Failure::new(TREE_ERROR_PARAMETER, text)
        })?;
        Ok(LeafParams {
            arrangement: arrangement.rust("leaves.arrangement")?,
            form: self.leaf_form()?,
            spacing: self.spacing,
            bearing: self.bearing,
            size: self.size,
            size_variation: self.size_variation,
            size_gradient: self.size_gradient,
            petiole: self.petiole,
            petiole_radius: self.petiole_radius,
            pitch: self.pitch,
            jitter: self.jitter,
            droop: self.droop,
            phototropism: self.phototropism,
            lamina_turn: self.lamina_turn,
            light: Vec3::from_array(self.light),
            terminal: self.terminal != 0,
            kind,
        })
    }

    fn leaf_form(&self) -> Result<LeafForm> {
        let (needles, spread) = (self.needles, self.needle_spread);
        match self.form {
            TREE_LEAVES_SIMPLE => Ok(LeafForm::Simple),
            TREE_LEAVES_PINNATE => Ok(LeafForm::Pinnate(Pinnate {
                pairs: self.pinnate_pairs,
                odd: self.pinnate_odd != 0,
                rachis: self.pinnate_rachis,
                droop: self.pinnate_droop,
                angle: self.pinnate_angle,
                profile: self.pinnate_profile,
                fold: self.pinnate_fold,
                petiolule: self.pinnate_petiolule,
                pinna_pairs: self.pinnate_pinna_pairs,
                pinna: self.pinnate_pinna,
            })),
            TREE_LEAVES_PALMATE => Ok(LeafForm::Palmate(Palmate {
                leaflets: self.palmate_leaflets,
                spread: self.palmate_spread,
                outer: self.palmate_outer,
                droop: self.palmate_droop,
            })),
            TREE_LEAVES_FASCICLE => Ok(LeafForm::Fascicle { needles, spread }),
            TREE_LEAVES_ROSETTE => Ok(LeafForm::Rosette { needles, spread }),
            other => Err(Failure::not_one_of("leaves.form", other, "TREE_LEAVES_")),
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_params_init(
    params: *mut tree_leaf_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order for a species with `n_kinds` kinds of leaves: `TREE_OK`, or the error
/// that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_params_check(
    params: *const tree_leaf_params,
    n_kinds: usize,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust()?.validate(n_kinds)?))
}
