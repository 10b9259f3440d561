//! How fine a mesh is, and how bark and leaves are laid on.

use crate::border::{
    Failure, Result, Versioned, call, init, out_value, read_or_default, tree_status,
};
use crate::skeleton::{continuation, continuation_of, tree_continuation};
use ::tree_mesh::{CurveFit, ErrorBound, MeshParams};

/// The line that is drawn through the nodes of an axis: one of the `TREE_CURVE_` constants.
pub type tree_curve_fit = u32;
/// Straight from node to node.
pub const TREE_CURVE_STRAIGHT: u32 = 0;
/// A clamped cubic B-spline through the nodes: what was modelled stays where it is.
pub const TREE_CURVE_THROUGH: u32 = 1;
/// A clamped cubic B-spline with the nodes as control points: passes near inner nodes, and calms what
/// jitters, such as scanned skeletons.
pub const TREE_CURVE_NEAR: u32 = 2;

/// How it is said how far a mesh may leave the exact shape: one of the `TREE_BOUND_` constants.
pub type tree_bound_kind = u32;
/// As a length.
pub const TREE_BOUND_METRES: u32 = 0;
/// As what a camera sees: the nearer it comes, the finer the mesh.
pub const TREE_BOUND_PIXELS: u32 = 1;

/// How a tree becomes triangles. Lengths in metres, angles in radians. Begin with
/// `tree_mesh_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_mesh_params {
    /// `sizeof(tree_mesh_params)`.
    pub struct_size: usize,
    /// Which child goes on at a fork and which start tubes of their own. Default
    /// `TREE_CONTINUATION_THICKEST`.
    pub continuation: tree_continuation,
    /// Fewest sides of a tube, 3 to `max_sides`. Default 3.
    pub min_sides: u32,
    /// Most sides of a tube, 3 to 128. Default 20. The cost of trunk and boughs grows with it.
    pub max_sides: u32,
    /// The line drawn through the nodes of an axis. Default `TREE_CURVE_THROUGH`.
    pub fit: tree_curve_fit,
    /// How it is said how far the mesh may leave the round, curved branch, which rules the number of
    /// sides between the two bounds above and the number of rings. Default `TREE_BOUND_METRES`.
    pub error_kind: tree_bound_kind,
    /// With `TREE_BOUND_METRES`: the error, 0.01 mm to 1 m. Default 3 mm.
    pub error: f32,
    /// With `TREE_BOUND_PIXELS`: width of the error on the screen, 0.01 to 1000. Default 1.
    pub error_pixels: f32,
    /// With `TREE_BOUND_PIXELS`: from the eye to the tree in metres, 0.01 to 1e6. Default 10 m.
    pub error_distance: f32,
    /// With `TREE_BOUND_PIXELS`: vertical field of view, 0.01 to 3. Default 1.
    pub error_fov_y: f32,
    /// With `TREE_BOUND_PIXELS`: height of the screen in pixels, 1 or more. Default 1080.
    pub error_height: u32,
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
    /// How much wider the trunk is at the ground, as a share of its radius, 0 to 3; 0 turns the root
    /// flare off. Default 0.35.
    pub flare: f32,
    /// Height of the root flare in radii of the trunk, 0.1 to 20. Default 3.
    pub flare_height: f32,
    /// Number of buttresses in the flare, 0 to 12. Default 5.
    pub flare_lobes: u32,
    /// How deep the flare is cut between buttresses, 0 (round) to 0.9. Default 0.5.
    pub flare_lobe_depth: f32,
    /// Factor on the length of every leaf, 0.01 to 100. Default 1.
    pub leaf_scale: f32,
    /// Factor on the width of every leaf, 0.01 to 100. Default 1: as wide as its look says.
    pub leaf_width: f32,
    /// How far leaf normals turn from the leaf's own towards the outside of the crown, 0 to 1.
    /// Default 0.6: soft light over the whole crown.
    pub leaf_rounding: f32,
    /// Whether vertices get tangents, 16 bytes each: for materials with normal maps. Default no.
    pub tangents: u32,
    /// Whether vertices get texture coordinates for a light map, 8 bytes each. Default no.
    pub lightmap: u32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_mesh_params {
    const NAME: &'static str = "tree_mesh_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = MeshParams::default();
        let bound = Bound::of(default.error);
        Self {
            struct_size: size_of::<Self>(),
            continuation: continuation_of(default.continuation),
            min_sides: default.min_sides,
            max_sides: default.max_sides,
            fit: match default.fit {
                CurveFit::Straight => TREE_CURVE_STRAIGHT,
                CurveFit::Through => TREE_CURVE_THROUGH,
                CurveFit::Near => TREE_CURVE_NEAR,
            },
            error_kind: bound.kind,
            error: bound.metres,
            error_pixels: bound.pixels,
            error_distance: bound.distance,
            error_fov_y: bound.fov_y,
            error_height: bound.height,
            max_strip: default.max_strip,
            min_radius: default.min_radius,
            bark_width: default.bark_width,
            bark_length: default.bark_length,
            flare: default.flare,
            flare_height: default.flare_height,
            flare_lobes: default.flare_lobes,
            flare_lobe_depth: default.flare_lobe_depth,
            leaf_scale: default.leaf_scale,
            leaf_width: default.leaf_width,
            leaf_rounding: default.leaf_rounding,
            tangents: default.tangents.into(),
            lightmap: default.lightmap.into(),
            reserved: 0,
        }
    }
}

/// An error bound with the fields of all kinds.
struct Bound {
    kind: tree_bound_kind,
    metres: f32,
    pixels: f32,
    distance: f32,
    fov_y: f32,
    height: u32,
}

impl Bound {
    fn of(bound: ErrorBound) -> Self {
        // What the kind does not use: a full-HD screen ten metres away.
        let unused = Self {
            kind: TREE_BOUND_METRES,
            metres: bound.metres(),
            pixels: 1.0,
            distance: 10.0,
            fov_y: 1.0,
            height: 1080,
        };
        match bound {
            ErrorBound::Metres(metres) => Self { metres, ..unused },
            ErrorBound::Pixels { pixels, distance, fov_y, height } => {
                Self { kind: TREE_BOUND_PIXELS, pixels, distance, fov_y, height, ..unused }
            }
        }
    }
}

impl tree_mesh_params {
    fn bound(&self) -> Result<ErrorBound> {
        match self.error_kind {
            TREE_BOUND_METRES => Ok(ErrorBound::Metres(self.error)),
            TREE_BOUND_PIXELS => Ok(ErrorBound::Pixels {
                pixels: self.error_pixels,
                distance: self.error_distance,
                fov_y: self.error_fov_y,
                height: self.error_height,
            }),
            other => Err(Failure::not_one_of("params.error_kind", other, "TREE_BOUND_")),
        }
    }

    /// The Rust parameters; ranges are checked by whoever uses them.
    pub(crate) fn rust(&self) -> Result<MeshParams> {
        Ok(MeshParams {
            continuation: continuation(self.continuation, "params.continuation")?,
            min_sides: self.min_sides,
            max_sides: self.max_sides,
            error: self.bound()?,
            fit: match self.fit {
                TREE_CURVE_STRAIGHT => CurveFit::Straight,
                TREE_CURVE_THROUGH => CurveFit::Through,
                TREE_CURVE_NEAR => CurveFit::Near,
                other => return Err(Failure::not_one_of("params.fit", other, "TREE_CURVE_")),
            },
            max_strip: self.max_strip,
            min_radius: self.min_radius,
            bark_width: self.bark_width,
            bark_length: self.bark_length,
            flare: self.flare,
            flare_height: self.flare_height,
            flare_lobes: self.flare_lobes,
            flare_lobe_depth: self.flare_lobe_depth,
            leaf_scale: self.leaf_scale,
            leaf_width: self.leaf_width,
            leaf_rounding: self.leaf_rounding,
            tangents: self.tangents != 0,
            lightmap: self.lightmap != 0,
        })
    }
}

/// The caller's parameters; NULL is the default.
pub(crate) unsafe fn mesh_params(params: *const tree_mesh_params) -> Result<MeshParams> {
    unsafe { read_or_default(params, "params") }?.rust()
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_params_init(
    params: *mut tree_mesh_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field against its range: `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
/// fault.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_params_check(params: *const tree_mesh_params) -> tree_status {
    call(|| Ok(unsafe { mesh_params(params) }?.validate()?))
}

/// The error that the parameters allow as a length in metres, within 0.01 mm and 1 m: for
/// `TREE_BOUND_PIXELS`, how large a pixel is at the tree. `params` may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_params_error(
    params: *const tree_mesh_params,
    metres: *mut f32,
) -> tree_status {
    call(|| {
        let params = unsafe { mesh_params(params) }?;
        params.validate()?;
        unsafe { out_value(metres, params.error.metres(), "metres") }
    })
}
