//! Bumps of an outline.

use super::tree_outline;
use crate::border::{
    Handle, Versioned, call, free, get, init, out, out_value, read, read_or_default, tree_status,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use tree_model::silhouette::bump::{self, Bump, BumpParams};

/// How bumps are found. Begin with `tree_bump_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bump_params {
    /// `sizeof(tree_bump_params)`.
    pub struct_size: usize,
    /// How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10.
    /// Between clear valleys half of it is enough, without any it takes twice as much. Default 0.2.
    pub prominence: f32,
    /// Features that stand out less than this share of the outline's size (the longer side of its box) are no
    /// bumps, 0.001 to 0.5. Default 0.02.
    pub detail: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_bump_params {
    const NAME: &'static str = "tree_bump_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&BumpParams::default())
    }
}

impl tree_bump_params {
    pub(crate) fn of(params: &BumpParams) -> Self {
        let BumpParams { prominence, detail } = *params;
        Self { struct_size: size_of::<Self>(), prominence, detail }
    }

    pub(crate) fn rust(&self) -> BumpParams {
        BumpParams { prominence: self.prominence, detail: self.detail }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bump_params_init(
    params: *mut tree_bump_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bump_params_check(params: *const tree_bump_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// One bump of an outline: the foliage of one major branch.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bump {
    /// Its central point, where the branch ends: the middle of a round end, and about the tip of a sharp one.
    pub center: [f32; 2],
    /// Its outermost point, on the outline.
    pub tip: [f32; 2],
    /// Direction of the chordal axis at the centre, outwards, of unit length.
    pub tangent: [f32; 2],
    /// Radius of the disc about the centre that fits into the outline, in metres; about 0 at a sharp feature.
    pub radius: f32,
    /// The part of the outline that is the bump's: from one length along it, in metres against the clock from its
    /// first corner, to another, which is greater than the perimeter where it passes that corner.
    pub stretch: [f32; 2],
}

impl tree_bump {
    fn of(bump: &Bump) -> Self {
        let Bump { center, tip, tangent, radius, stretch } = *bump;
        let (center, tip, tangent) = (center.to_array(), tip.to_array(), tangent.to_array());
        Self { center, tip, tangent, radius, stretch }
    }
}

/// The bumps of an outline.
pub struct tree_bumps(Vec<tree_bump>);

impl Handle for tree_bumps {
    const NAME: &'static str = "tree_bumps";
}

/// Finds the bumps of an outline by its chordal axis, in their order against the clock along it: one at least, which is the
/// whole of an outline where nothing stands out. The foot of a crown, where the trunk comes in, may be one like every other.
/// `params` and `control` may be NULL. Free the bumps with `tree_bumps_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_bumps(
    outline: *const tree_outline,
    params: *const tree_bump_params,
    control: *const tree_control,
    bumps: *mut *mut tree_bumps,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bumps, "bumps") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let found = unsafe { run(control, |_| Ok(bump::bumps(outline, &params))) }?;
        place.put(tree_bumps(found.iter().map(tree_bump::of).collect()));
        Ok(())
    })
}

/// Views bumps: where they begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bumps_view(
    bumps: *const tree_bumps,
    rows: *mut *const tree_bump,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(bumps, "bumps") }?.0;
        unsafe { out_value(rows, column(found), "rows") }?;
        unsafe { out_value(n_rows, found.len(), "n_rows") }
    })
}

/// Frees bumps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bumps_free(bumps: *mut tree_bumps) -> tree_status {
    call(|| unsafe { free(bumps, "bumps") })
}
