//! How words are drawn.

use super::tree_grammar;
use crate::allometry::tree_radius_rule;
use crate::border::{
    Failure, Result, Versioned, call, get, init, read, read_or_default, tree_status, write,
};
use crate::tree::tree_species;
use glam::Vec3;
use tree_model::lsystem::{LSystem, Taper, Thickness, TurtleParams, of_skeleton};
use tree_model::tree_core::Species;

/// How the width of segments becomes the radius of nodes: one of the `TREE_TAPER_` constants.
pub type tree_taper = u32;
/// The width is that of a segment's base; it narrows to the thickest segment that follows. The default.
pub const TREE_TAPER_SMOOTH: u32 = 0;
/// The width is that of a segment's upper end, as words of skeletons have it.
pub const TREE_TAPER_ENDS: u32 = 1;

/// Where radii come from: one of the `TREE_THICKNESS_` constants.
pub type tree_thickness = u32;
/// From the widths of the word where it sets any with `!` or `#`, or else from `radii`. The default.
pub const TREE_THICKNESS_AUTO: u32 = 0;
/// From the widths of the word.
pub const TREE_THICKNESS_WORD: u32 = 1;
/// From `radii`, whatever the word says.
pub const TREE_THICKNESS_RULE: u32 = 2;

/// What a word leaves open when a turtle draws it. Lengths and widths are in the word's own units, which `unit`
/// or `height` makes metres. Begin with `tree_turtle_params_init`, `tree_grammar_turtle`, `tree_chain_turtle` or
/// `tree_lsystem_preset`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_turtle_params {
    /// `sizeof(tree_turtle_params)`.
    pub struct_size: usize,
    /// Length of an `F`, `f` or `G` without parameter, 0 to 1e6 units. Default 1.
    pub step: f64,
    /// Diameter of wood before the first `!`, 0 to 1e6 units. Default 0.1.
    pub width: f64,
    /// Angle of a turn without parameter in degrees, -3600 to 3600. Default 22.5.
    pub angle: f64,
    /// What a `!` without parameter multiplies the width by, 0.01 to 1; `#` divides by it. Default √½: the
    /// cross-section halves.
    pub width_ratio: f64,
    /// Size of a `~` without parameter, 0 to 1e6 units. Default 1.
    pub leaf_size: f64,
    /// How readily shoots bend towards `tropism`: after each `F` the heading turns by this times the sine of the
    /// angle between them, in radians. -10 to 10, default 0. A module `_(e)` sets it for the rest of its branch.
    pub elasticity: f64,
    /// Metres in a unit, 1e-6 to 1e6. Default 1.
    pub unit: f64,
    /// The direction shoots bend to, each number -1000 to 1000. Default straight down.
    pub tropism: [f32; 3],
    /// Height of the tree in metres, 0.001 to 1000, in place of `unit`. Default 0: `unit` decides.
    pub height: f32,
    /// Radius of the base in metres, 1e-6 to 100: all radii are multiplied by the one factor that makes it so.
    /// Default 0: widths are in the same unit as lengths.
    pub trunk_radius: f32,
    /// How widths become radii. Default `TREE_TAPER_SMOOTH`.
    pub taper: tree_taper,
    /// Where radii come from. Default `TREE_THICKNESS_AUTO`.
    pub thickness: tree_thickness,
    /// Whether polygons that look like leaves become leaves too. Default 1.
    pub polygon_leaves: u32,
    /// The rule for radii. Default NULL: that of `tree_radius_rule_init`.
    pub radii: *const tree_radius_rule,
    /// What the tree is; its leaf kinds are those of `~(size, kind)`. Default NULL: an oak.
    pub species: *const tree_species,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_turtle_params {
    const NAME: &'static str = "tree_turtle_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&TurtleParams::default())
    }
}

impl tree_turtle_params {
    /// The parameters in C's form, but for the rule of radii, which the caller points at.
    pub(super) fn of(params: &TurtleParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            step: params.step,
            width: params.width,
            angle: params.angle,
            width_ratio: params.width_ratio,
            leaf_size: params.leaf_size,
            elasticity: params.elasticity,
            unit: params.unit,
            tropism: params.tropism.to_array(),
            height: params.height.unwrap_or(0.0),
            trunk_radius: params.trunk_radius.unwrap_or(0.0),
            taper: match params.taper {
                Taper::Smooth => TREE_TAPER_SMOOTH,
                Taper::Ends => TREE_TAPER_ENDS,
            },
            thickness: match params.thickness {
                Thickness::Auto(_) => TREE_THICKNESS_AUTO,
                Thickness::Word => TREE_THICKNESS_WORD,
                Thickness::Rule(_) => TREE_THICKNESS_RULE,
            },
            polygon_leaves: params.polygon_leaves.into(),
            radii: std::ptr::null(),
            species: std::ptr::null(),
        }
    }

    /// Parameters in Rust's form, not yet checked against their ranges.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<TurtleParams> {
        let part = |field: &str| format!("{name}.{field}");
        let radii = unsafe { read_or_default(self.radii, &part("radii")) }?.rust()?;
        Ok(TurtleParams {
            step: self.step,
            width: self.width,
            angle: self.angle,
            width_ratio: self.width_ratio,
            leaf_size: self.leaf_size,
            tropism: Vec3::from(self.tropism),
            elasticity: self.elasticity,
            taper: match self.taper {
                TREE_TAPER_SMOOTH => Taper::Smooth,
                TREE_TAPER_ENDS => Taper::Ends,
                other => return Err(Failure::not_one_of(&part("taper"), other, "TREE_TAPER_")),
            },
            thickness: match self.thickness {
                TREE_THICKNESS_AUTO => Thickness::Auto(radii),
                TREE_THICKNESS_WORD => Thickness::Word,
                TREE_THICKNESS_RULE => Thickness::Rule(radii),
                other => {
                    return Err(Failure::not_one_of(&part("thickness"), other, "TREE_THICKNESS_"));
                }
            },
            unit: self.unit,
            height: (self.height != 0.0).then_some(self.height),
            trunk_radius: (self.trunk_radius != 0.0).then_some(self.trunk_radius),
            polygon_leaves: self.polygon_leaves != 0,
        })
    }

    /// The species that is grown.
    pub(super) unsafe fn species(&self, name: &str) -> Result<Species> {
        if self.species.is_null() {
            return Ok(Species::default());
        }
        let name = format!("{name}.species");
        unsafe { read(self.species, &name)?.rust(&name) }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_params_init(
    params: *mut tree_turtle_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks that all parameters lie in their ranges, as functions that take them do first. `params` may be NULL for
/// the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_turtle_params_check(
    params: *const tree_turtle_params,
) -> tree_status {
    call(|| {
        let params = unsafe { read_or_default(params, "params") }?;
        unsafe { params.species("params") }?;
        Ok(unsafe { params.rust("params") }?.validate()?)
    })
}

/// Makes `params`, of `size` bytes, what a grammar says: its angle, and the constants of its text that have the
/// names `step`, `width`, `width_ratio`, `leaf_size`, `elasticity`, `tropism_x`, `tropism_y`, `tropism_z`, `unit`,
/// `height` and `trunk_radius`. `TREE_ERROR_PARAMETER` names one that is out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_turtle(
    grammar: *const tree_grammar,
    params: *mut tree_turtle_params,
    size: usize,
) -> tree_status {
    call(|| {
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let turtle = LSystem::new((**grammar).clone())?.turtle;
        unsafe { init(params, size) }?;
        unsafe { write(params, "params", &tree_turtle_params::of(&turtle)) }
    })
}

/// Makes `params`, of `size` bytes, the turtle that draws words of `tree_skeleton_to_word`: in metres, widths at
/// the upper ends of internodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_chain_turtle(
    params: *mut tree_turtle_params,
    size: usize,
) -> tree_status {
    call(|| {
        unsafe { init(params, size) }?;
        let turtle = tree_turtle_params::of(&of_skeleton::chain_turtle());
        unsafe { write(params, "params", &turtle) }
    })
}
