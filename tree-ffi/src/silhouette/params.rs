//! All parameters from strokes to a tree.

use super::{
    tree_branch_infer_params, tree_branching_angles, tree_bump_params, tree_outline_close_params,
    tree_silhouette_grow_params, tree_sub_params,
};
use crate::border::{Result, Versioned, call, init, read, read_or_default, tree_status};
use crate::particle::Kept;
use std::ptr::null;
use tree_model::silhouette::branch::BranchingAngles;
use tree_model::silhouette::plan::{CoverParams, SystemParams};
use tree_model::silhouette::session::SilhouetteParams;

/// How gaps between branches are filled. Begin with `tree_cover_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_cover_params {
    /// `sizeof(tree_cover_params)`.
    pub struct_size: usize,
    /// Places on each side of the axis that are tried, 0 to 10,000. Default 24.
    pub places: u32,
    /// Share of a new branch's outline that may overlap its siblings, 0 to 1. Default 0.2, as in the paper.
    pub overlap: f32,
    /// Longest stretch of the outline that may stay bare, as a share of its length round, 0.005 to 1. Default 0.04.
    pub bare: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_cover_params {
    const NAME: &'static str = "tree_cover_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&CoverParams::default())
    }
}

impl tree_cover_params {
    fn of(params: &CoverParams) -> Self {
        let CoverParams { places, overlap, bare } = *params;
        Self { struct_size: size_of::<Self>(), places, overlap, bare, reserved: 0 }
    }

    fn rust(&self) -> CoverParams {
        CoverParams { places: self.places, overlap: self.overlap, bare: self.bare }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cover_params_init(
    params: *mut tree_cover_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// How the branches of a system are found: an axis with the outline of its foliage. A part that is NULL, as all are
/// after `tree_branch_system_params_init`, is its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branch_system_params {
    /// `sizeof(tree_branch_system_params)`.
    pub struct_size: usize,
    /// How bumps are found.
    pub bumps: *const tree_bump_params,
    /// How branches are inferred.
    pub infer: *const tree_branch_infer_params,
    /// How sub-silhouettes are made.
    pub sub: *const tree_sub_params,
    /// How gaps are filled.
    pub cover: *const tree_cover_params,
}

// SAFETY: repr(C), begins with its size, and holds pointers only.
unsafe impl Versioned for tree_branch_system_params {
    const NAME: &'static str = "tree_branch_system_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let struct_size = size_of::<Self>();
        Self { struct_size, bumps: null(), infer: null(), sub: null(), cover: null() }
    }
}

impl tree_branch_system_params {
    /// In C's form; what it points at is kept in `kept`.
    fn of(params: &SystemParams, kept: &mut Kept) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            bumps: kept.one(tree_bump_params::of(&params.bumps)),
            infer: kept.one(tree_branch_infer_params::of(&params.infer)),
            sub: kept.one(tree_sub_params::of(&params.sub)),
            cover: kept.one(tree_cover_params::of(&params.cover)),
        }
    }

    /// In Rust's form, not yet checked.
    unsafe fn rust(&self, name: &str) -> Result<SystemParams> {
        let part = |field: &str| format!("{name}.{field}");
        Ok(SystemParams {
            bumps: unsafe { read_or_default(self.bumps, &part("bumps")) }?.rust(),
            infer: unsafe { read_or_default(self.infer, &part("infer")) }?.rust(),
            sub: unsafe { read_or_default(self.sub, &part("sub")) }?.rust(),
            cover: unsafe { read_or_default(self.cover, &part("cover")) }?.rust(),
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_branch_system_params_init(
    params: *mut tree_branch_system_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// All parameters from strokes to a tree. A part that is NULL, as all are after `tree_silhouette_params_init`, is its
/// default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_params {
    /// `sizeof(tree_silhouette_params)`.
    pub struct_size: usize,
    /// How strokes become outlines.
    pub outline: *const tree_outline_close_params,
    /// How branches are found in outlines.
    pub system: *const tree_branch_system_params,
    /// Angles of the branches on the trunk, until branches are redrawn. Default 1.35 at the base, 0.6 at the tip.
    pub angles: *const tree_branching_angles,
    /// How the plan becomes a tree.
    pub grow: *const tree_silhouette_grow_params,
    /// A stroke redraws a branch when its ends are on average no farther off than this share of the branch's span, 0
    /// to 10; else it adds one. Default 0.35. Messages call it `near`.
    pub nearness: f32,
    /// Height in metres of the tallest tree of a drawing, 0.001 to 1000. Default 10.
    pub height: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_silhouette_params {
    const NAME: &'static str = "tree_silhouette_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = SilhouetteParams::default();
        Self {
            struct_size: size_of::<Self>(),
            outline: null(),
            system: null(),
            angles: null(),
            grow: null(),
            nearness: default.near,
            height: default.height,
        }
    }
}

impl tree_silhouette_params {
    /// The parameters in C's form; what they point at is kept in `kept`.
    fn of(params: &SilhouetteParams, kept: &mut Kept) -> Self {
        let system = tree_branch_system_params::of(&params.system, kept);
        let angles = keep_angles(&params.angles, kept);
        let grow = tree_silhouette_grow_params::of(&params.grow, kept);
        Self {
            struct_size: size_of::<Self>(),
            outline: kept.one(tree_outline_close_params::of(&params.outline)),
            system: kept.one(system),
            angles,
            grow: kept.one(grow),
            nearness: params.near,
            height: params.height,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges; `name` is what they are called by.
    unsafe fn rust(&self, name: &str) -> Result<SilhouetteParams> {
        let part = |field: &str| format!("{name}.{field}");
        let (system, grow) = (part("system"), part("grow"));
        let angles = unsafe { angles_of(self.angles, &part("angles")) }?;
        Ok(SilhouetteParams {
            outline: unsafe { read_or_default(self.outline, &part("outline")) }?.rust(),
            system: unsafe { read_or_default(self.system, &system)?.rust(&system) }?,
            angles: angles.unwrap_or_default(),
            grow: unsafe { read_or_default(self.grow, &grow)?.rust(&grow) }?,
            near: self.nearness,
            height: self.height,
        })
    }
}

/// Angles in C's form, kept in `kept`.
pub(super) fn keep_angles(
    angles: &BranchingAngles,
    kept: &mut Kept,
) -> *const tree_branching_angles {
    let samples = kept.all(angles.samples.clone()).cast();
    kept.one(tree_branching_angles { samples, ..tree_branching_angles::of(angles) })
}

/// Angles in Rust's form, not yet checked; none for NULL.
pub(super) unsafe fn angles_of(
    angles: *const tree_branching_angles,
    name: &str,
) -> Result<Option<BranchingAngles>> {
    if angles.is_null() {
        return Ok(None);
    }
    unsafe { read(angles, name)?.rust(name) }.map(Some)
}

/// A session's parameters in C's form.
pub(super) fn keep(params: &SilhouetteParams) -> (tree_silhouette_params, Kept) {
    let mut kept = Kept::default();
    (tree_silhouette_params::of(params, &mut kept), kept)
}

/// NULL is the default. Not yet checked.
pub(super) unsafe fn silhouette_of(
    params: *const tree_silhouette_params,
    name: &str,
) -> Result<SilhouetteParams> {
    unsafe { read_or_default(params, name)?.rust(name) }
}

/// NULL is the default. Checked.
pub(super) unsafe fn silhouette_params(
    params: *const tree_silhouette_params,
) -> Result<SilhouetteParams> {
    let params = unsafe { silhouette_of(params, "params") }?;
    params.validate()?;
    Ok(params)
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_params_init(
    params: *mut tree_silhouette_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_params_check(
    params: *const tree_silhouette_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust("params") }?.validate()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_model::silhouette::grow::{Leaves, LevelParams};
    use tree_model::silhouette::place::Arrangement;

    #[test]
    fn parameters_come_back_from_c_as_they_went() {
        let null = tree_silhouette_params::default_value();
        assert_eq!(unsafe { null.rust("params") }.unwrap(), SilhouetteParams::default());
        let mut params = SilhouetteParams { near: 0.5, height: 7.0, ..Default::default() };
        params.system.bumps.detail = 0.1;
        params.system.infer.points = 9;
        params.system.sub.wide = 1.0;
        params.system.cover.overlap = 0.5;
        params.angles = BranchingAngles { samples: vec![[0.0, 1.0], [0.25, 0.5], [1.0, 0.1]] };
        let level = LevelParams::default();
        params.grow.levels = vec![
            LevelParams { arrangement: Arrangement::whorl(3), ..level.clone() },
            LevelParams { angles: BranchingAngles::between(0.2, 0.1), count: 3, ..level },
        ];
        params.grow.depth = Some(3);
        params.grow.trunk_radius = Some(0.2);
        params.grow.gibbs.moves = 17;
        params.grow.fence = false;
        params.grow.fill = 0.5;
        params.grow.species.name = "birch".into();
        for leaves in
            [None, Some(Leaves { length: Some(0.1), bare: Some(0.0), ..Leaves::default() })]
        {
            params.grow.leaves = leaves;
            let mut kept = Kept::default();
            let there = tree_silhouette_params::of(&params, &mut kept);
            assert_eq!(unsafe { there.rust("params") }.unwrap(), params);
        }
    }
}
