//! New main branches where old ones died and there is light.

use super::analysis::tree_plastic;
use super::scene::{lock, tree_plastic_scene};
use crate::border::{
    Result, Versioned, call, foresee, get, init, out, read, read_or_default, tree_status, view,
    write,
};
use crate::control::{run, tree_control};
use crate::growth::tree_growth_habit;
use crate::tree::tree_tree;
use tree_model::growth::Shadow;
use tree_model::plastic::{Regrowth, TreeId};
use tree_model::tree_core::Seed;

/// How new branches grow. Begin with `tree_plastic_regrowth_init`, or `tree_plastic_regrowth_of` for the measure of a tree.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_regrowth {
    /// `sizeof(tree_plastic_regrowth)`.
    pub struct_size: usize,
    /// Their kind; NULL for that of `tree_growth_habit_init` with the internode below. Default NULL.
    pub habit: *const tree_growth_habit,
    /// Without `habit`: length of an internode in metres, 0.001 to 100. Default 0.12.
    pub internode: f32,
    /// Without `habit`: whether new branches are bare. Default 0: they bear leaves.
    pub bare: u32,
    /// Edge of a voxel of shadow in metres, 0.001 to 100. Default 0.2.
    pub shadow_voxel: f32,
    /// Shadow in the voxel of the one who casts it, 0 to 4. Default 0.12.
    pub shadow_strength: f32,
    /// What divides the shadow with each layer down, 1 to 10. Default 1.4.
    pub shadow_falloff: f32,
    /// Layers below its own that a metamer shades, 0 to 32. Default 7.
    pub shadow_depth: u32,
    /// How many voxels a bud looks around for the brighter side, 1 to 8. Default 3.
    pub shadow_reach: u32,
    /// Iterations they grow for, 0 to 100. Default 6.
    pub years: u32,
    /// Least light where the old branch stood, as a share of the open sky's, 0 to 1. Default 0.4.
    pub light: f32,
    /// Least distance between two new branches in metres, 0 to 1000. Default 0.4.
    pub spacing: f32,
    /// Most new branches, 0 to 10,000. Default 64.
    pub most: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_plastic_regrowth {
    const NAME: &'static str = "tree_plastic_regrowth";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Regrowth::default())
    }
}

impl tree_plastic_regrowth {
    fn of(params: &Regrowth) -> Self {
        let Shadow { voxel, strength, falloff, depth, reach } = params.shadow;
        Self {
            struct_size: size_of::<Self>(),
            habit: std::ptr::null(),
            internode: params.habit.internode,
            bare: params.habit.leaves.is_none().into(),
            shadow_voxel: voxel,
            shadow_strength: strength,
            shadow_falloff: falloff,
            shadow_depth: depth,
            shadow_reach: reach,
            years: params.years,
            light: params.light,
            spacing: params.spacing,
            most: params.most,
            reserved: 0,
        }
    }

    unsafe fn rust(&self) -> Result<Regrowth> {
        let mut params = Regrowth {
            shadow: Shadow {
                voxel: self.shadow_voxel,
                strength: self.shadow_strength,
                falloff: self.shadow_falloff,
                depth: self.shadow_depth,
                reach: self.shadow_reach,
            },
            years: self.years,
            light: self.light,
            spacing: self.spacing,
            most: self.most,
            ..Regrowth::default()
        };
        if self.habit.is_null() {
            params.habit.internode = self.internode;
            if self.bare != 0 {
                params.habit.leaves = None;
            }
        } else {
            let habit = unsafe { read(self.habit, "params.habit") }?;
            params.habit = unsafe { habit.rust("params.habit") }?;
        }
        Ok(params)
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_regrowth_init(
    params: *mut tree_plastic_regrowth,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes `params`, of `size` bytes, the default to the measure of a tree: internodes, voxels and distances by the length of its
/// internodes, and bare where it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_regrowth_of(
    plastic: *const tree_plastic,
    params: *mut tree_plastic_regrowth,
    size: usize,
) -> tree_status {
    call(|| {
        let found = Regrowth::of(unsafe { get(plastic, "plastic") }?.rust());
        unsafe { init(params, size) }?;
        unsafe { write(params, "params", &tree_plastic_regrowth::of(&found)) }
    })
}

/// What has grown.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_regrown {
    /// `sizeof(tree_plastic_regrown)`.
    pub struct_size: usize,
    /// Nodes of the adapted tree, which come first; all others are new.
    pub n_adapted: u64,
    /// New branches.
    pub n_branches: u64,
    /// Living main nodes that had lost a branch.
    pub n_stumps: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_regrown {
    const NAME: &'static str = "tree_plastic_regrown";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), n_adapted: 0, n_branches: 0, n_stumps: 0 }
    }
}

/// A tree of a scene as of the last update, and new branches where old ones died and there is light. The scene does not change.
/// `params`, `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_regrown(
    scene: *const tree_plastic_scene,
    id: u64,
    params: *const tree_plastic_regrowth,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_plastic_regrown,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let params = unsafe { read_or_default(params, "params")?.rust() }?;
        let held = unsafe { lock(scene) }?;
        let body =
            |control: &_| Ok(held.scene.regrown(TreeId(id), &params, Seed(seed), control)?);
        let found = unsafe { run(control, body) }?;
        let said = tree_plastic_regrown {
            n_adapted: found.n_adapted.into(),
            n_branches: found.branches.len() as u64,
            n_stumps: found.n_stumps.into(),
            ..tree_plastic_regrown::default_value()
        };
        unsafe { view(report, "report", &said) }?;
        place.put(tree_tree::shared(std::sync::Arc::new(found.tree)));
        Ok(())
    })
}
