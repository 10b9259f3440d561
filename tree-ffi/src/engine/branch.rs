//! What a branch does in the wind.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, floats, free, get, out,
    out_value, tree_status, write,
};
use crate::mesh::{column, tree_mesh, tree_wind_branch};
use crate::skeleton::tree_skeleton;
use crate::skeleton::{continuation, tree_continuation};
use ::tree_mesh::wind::{self, Branch};

/// What follows from a row of the table of branches.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branch_motion {
    /// `sizeof(tree_branch_motion)`.
    pub struct_size: usize,
    /// Share of the wind's full turn that it makes, 0 to 1.
    pub give: f32,
    /// Its lowest natural frequency in hertz, as a bare, clamped, uniform rod of green wood; leaves make
    /// it slower, taper faster. Infinite for a branch without length.
    pub frequency: f32,
    /// The direction it swings in: a unit vector square to the axis, another one for each phase.
    pub swing: [f32; 3],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_branch_motion {
    const NAME: &'static str = "tree_branch_motion";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Branch::default())
    }
}

impl tree_branch_motion {
    fn of(branch: &Branch) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            give: branch.give(),
            frequency: branch.frequency(),
            swing: branch.swing().to_array(),
            reserved: 0,
        }
    }
}

unsafe fn branch<'a>(mesh: *const tree_mesh, number: usize) -> Result<&'a Branch> {
    let branches = &unsafe { get(mesh, "mesh") }?.rust().branches;
    branches.get(number).ok_or_else(|| {
        let text = format!("branch is {number}, the mesh has {}", branches.len());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// What a branch of a mesh does in the wind. Set `motion->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_branch_motion(
    mesh: *const tree_mesh,
    branch: usize,
    motion: *mut tree_branch_motion,
) -> tree_status {
    call(|| {
        let found = unsafe { self::branch(mesh, branch) }?;
        unsafe { write(motion, "motion", &tree_branch_motion::of(found)) }
    })
}

/// How far along a branch of a mesh a point of three floats lies: 0 up to the collar, 1 at the tip and
/// beyond.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_branch_reach(
    mesh: *const tree_mesh,
    branch: usize,
    point: *const f32,
    reach: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { self::branch(mesh, branch) }?;
        let point = unsafe { floats::<3>(point, "point") }?;
        unsafe { out_value(reach, found.reach(point.into()), "reach") }
    })
}

/// The branches of a skeleton, as the wind sees them.
pub struct tree_wind_branches(Vec<Branch>);

impl Handle for tree_wind_branches {
    const NAME: &'static str = "tree_wind_branches";
}

/// One branch for each axis of a skeleton, in the same order, turning about its fork. Those of a built
/// mesh turn about the places where their bark stands. Free them with `tree_wind_branches_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_wind_branches(
    skeleton: *const tree_skeleton,
    continuation: tree_continuation,
    branches: *mut *mut tree_wind_branches,
) -> tree_status {
    call(|| {
        let place = unsafe { out(branches, "branches") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let axes = skeleton.axes(self::continuation(continuation, "continuation")?);
        place.put(tree_wind_branches(wind::branches(skeleton, &axes)));
        Ok(())
    })
}

/// Views the branches: where they begin, and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_wind_branches_view(
    branches: *const tree_wind_branches,
    rows: *mut *const tree_wind_branch,
    n: *mut usize,
) -> tree_status {
    call(|| {
        let branches = &unsafe { get(branches, "branches") }?.0;
        unsafe { out_value(rows, column(branches).cast(), "rows") }?;
        unsafe { out_value(n, branches.len(), "n") }
    })
}

/// Frees branches.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_wind_branches_free(branches: *mut tree_wind_branches) -> tree_status {
    call(|| unsafe { free(branches, "branches") })
}
