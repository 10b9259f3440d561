//! Pruned models, made.

use super::elements::{SURFACES_MAX, grain_of, tree_grain};
use super::order_params::tree_coverage_params;
use super::pruned::tree_pruned;
use super::subject::tree_lod_subject;
use super::table::{tree_lod_table, tree_lod_table_params};
use super::take::few;
use super::tiers::tree_tiers_params;
use crate::border::{Result, Versioned, call, get, init, out, read, read_or_default, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::tree_mesh;
use std::ptr::null;
use tree_lod::LeafSurfaces;
use tree_lod::prune::{MakeParams, PruneParams, PrunedModel};

/// How a model is pruned. Begin with `tree_prune_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_prune_params {
    /// `sizeof(tree_prune_params)`.
    pub struct_size: usize,
    /// Share of lambda over which the last elements fade, 0 to 1. More is smoother in motion, but shows fewer of the
    /// triangles that are drawn. 0: they pop. Default 0.1.
    pub fade: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_prune_params {
    const NAME: &'static str = "tree_prune_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let PruneParams { fade } = PruneParams::default();
        Self { struct_size: size_of::<Self>(), fade, reserved: 0 }
    }
}

impl tree_prune_params {
    fn rust(&self) -> PruneParams {
        PruneParams { fade: self.fade }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_params_init(
    params: *mut tree_prune_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_params_check(params: *const tree_prune_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// Every step from a mesh to a pruned model. Begin with `tree_prune_make_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_prune_make_params {
    /// `sizeof(tree_prune_make_params)`.
    pub struct_size: usize,
    /// Surfaces that are pruned, each once. NULL, the default: they are found, as `tree_elements_of_mesh` does it.
    pub surfaces: *const u32,
    /// Number of these surfaces; 0 for the default.
    pub n_surfaces: usize,
    /// How outlines become simpler. NULL, the default: its defaults.
    pub outlines: *const tree_tiers_params,
    /// How the order is found. NULL, the default: as is right for so many triangles.
    pub order: *const tree_coverage_params,
    /// How scales are measured. NULL, the default: as is right for so many triangles.
    pub table: *const tree_lod_table_params,
    /// How the model is pruned. NULL, the default: its defaults.
    pub prune: *const tree_prune_params,
    /// What an element is: a `TREE_GRAIN_` constant. Default `TREE_GRAIN_BLADE`.
    pub grain: tree_grain,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_prune_make_params {
    const NAME: &'static str = "tree_prune_make_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            surfaces: null(),
            n_surfaces: 0,
            outlines: null(),
            order: null(),
            table: null(),
            prune: null(),
            grain: super::elements::TREE_GRAIN_BLADE,
            reserved: 0,
        }
    }
}

impl tree_prune_make_params {
    /// For a mesh of so many triangles.
    unsafe fn rust(&self, n_triangles: usize) -> Result<MakeParams> {
        let named = (self.surfaces, self.n_surfaces);
        let named = unsafe { few(named.0, named.1, SURFACES_MAX, "params.surfaces") }?;
        let order = match self.order.is_null() {
            true => None,
            false => Some(unsafe { tree_coverage_params::read(self.order, n_triangles) }?),
        };
        let table = match self.table.is_null() {
            true => None,
            false => Some(unsafe { read(self.table, "params.table")?.rust(n_triangles) }?),
        };
        Ok(MakeParams {
            foliage: match named.is_empty() {
                true => LeafSurfaces::Found,
                false => LeafSurfaces::Surfaces(named.to_vec()),
            },
            grain: grain_of(self.grain)?,
            outlines: unsafe { tree_tiers_params::read(self.outlines, "params.outlines") }?,
            order,
            table,
            prune: unsafe { read_or_default(self.prune, "params.prune") }?.rust(),
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_make_params_init(
    params: *mut tree_prune_make_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes a pruned model of a mesh, all steps in one call: elements, tiers, order by coverage, plan, table and model.
/// Some seconds for half a million triangles. `params` and `control` may be NULL; `triangles` of its limits caps those
/// of all tiers together. Free the model with `tree_pruned_free`. `TREE_ERROR_INVALID` when there is no foliage.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_make(
    mesh: *const tree_mesh,
    params: *const tree_prune_make_params,
    control: *const tree_control,
    pruned: *mut *mut tree_pruned,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pruned, "pruned") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust(mesh.n_triangles()) }?;
        let body = |control: &_| Ok(PrunedModel::make(mesh, &params, control)?);
        place.put(tree_pruned::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Makes a pruned model of what its steps have made: the subject with its order, pivots, tiers and plan, and `table`
/// with the scale for each lambda. Surfaces of foliage keep their vertices and columns, their index buffers hold the
/// triangles of all tiers; vertices that several elements share are doubled, and such a surface loses its anchors.
/// `params` and `control` may be NULL. Free the model with `tree_pruned_free`.
///
/// `TREE_ERROR_INVALID` when the parts of the subject do not belong together, or pivots are not finite;
/// `TREE_ERROR_PARAMETER` for foliage further than 1000 km from the origin, or a `kept` that rises.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_new(
    subject: *const tree_lod_subject,
    table: *const tree_lod_table,
    params: *const tree_prune_params,
    control: *const tree_control,
    pruned: *mut *mut tree_pruned,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pruned, "pruned") }?;
        let held = unsafe { tree_lod_subject::read(subject, control) }?;
        let table = unsafe { get(table, "table") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| {
            let subject = held.rust();
            subject.elements.check(subject.mesh)?;
            Ok(PrunedModel::new(&subject, table.clone(), &params, control)?)
        };
        place.put(tree_pruned::new(unsafe { run(control, body) }?));
        Ok(())
    })
}
