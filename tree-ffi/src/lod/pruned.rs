//! A mesh whose foliage can be drawn at any level.

use super::table::tree_lod_table;
use super::take::fill_some;
use crate::border::{
    Failure, Handle, Shared, TREE_ERROR_PARAMETER, Versioned, call, free, get, out, out_value,
    tree_status, write,
};
use crate::mesh::{column, tree_mesh};
use bytemuck::{Pod, Zeroable};
use std::ptr::null;
use tree_lod::prune::{Cut, PrunedModel};

/// A mesh whose foliage can be drawn at any level: windows of its index buffers (Neubert 2012, chapter 7).
pub struct tree_pruned(Shared<PrunedModel>);

impl Handle for tree_pruned {
    const NAME: &'static str = "tree_pruned";
}

impl tree_pruned {
    pub(super) fn new(model: PrunedModel) -> Self {
        Self(Shared::new(model))
    }

    pub(super) fn rust(&self) -> &PrunedModel {
        self.0.get()
    }
}

/// How large a pruned model is.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pruned_totals {
    /// `sizeof(tree_pruned_totals)`.
    pub struct_size: usize,
    /// Surfaces that are pruned; all others are drawn whole.
    pub n_parts: usize,
    /// Number of tiers.
    pub n_tiers: usize,
    /// Number of elements.
    pub n_elements: usize,
    /// Triangles of the full foliage.
    pub n_triangles: u64,
    /// Number of states; neighbours differ in one element.
    pub n_steps: u64,
    /// Bytes of the foliage's indices in the mesh that came in.
    pub indices_before: u64,
    /// Bytes of the indices of all tiers.
    pub indices_after: u64,
    /// Bytes of the foliage's vertices in the mesh that came in.
    pub vertices_before: u64,
    /// Bytes of the vertices with copies and centres.
    pub vertices_after: u64,
    /// The least lambda that can be kept: of the state with the fewest elements.
    pub least_lambda: f32,
    /// Lambda of the last state in which all elements are drawn.
    pub lambda_of_all: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_pruned_totals {
    const NAME: &'static str = "tree_pruned_totals";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_parts: 0,
            n_tiers: 0,
            n_elements: 0,
            n_triangles: 0,
            n_steps: 0,
            indices_before: 0,
            indices_after: 0,
            vertices_before: 0,
            vertices_after: 0,
            least_lambda: 0.0,
            lambda_of_all: 0.0,
        }
    }
}

/// Tells how large a model is, and the ends of its lambdas. Set `totals->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_measure(
    pruned: *const tree_pruned,
    totals: *mut tree_pruned_totals,
) -> tree_status {
    call(|| {
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let (schedule, sizes) = (model.schedule(), model.sizes());
        let found = tree_pruned_totals {
            n_parts: model.parts().len(),
            n_tiers: schedule.n_tiers(),
            n_elements: schedule.n_elements() as usize,
            n_triangles: schedule.n_triangles(),
            n_steps: schedule.n_steps(),
            indices_before: sizes.indices_before,
            indices_after: sizes.indices_after,
            vertices_before: sizes.vertices_before,
            vertices_after: sizes.vertices_after,
            least_lambda: schedule.least_lambda(),
            lambda_of_all: schedule.lambda_of_all(),
            ..tree_pruned_totals::default_value()
        };
        unsafe { write(totals, "totals", &found) }
    })
}

/// The mesh to upload, nothing copied. Its foliage must be drawn by windows, for its index buffers hold leaves several
/// times. Free it with `tree_mesh_free`; it keeps the model alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_mesh(
    pruned: *const tree_pruned,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let model = unsafe { get(pruned, "pruned") }?;
        place.put(tree_mesh::part(model.0.part(PrunedModel::mesh)));
        Ok(())
    })
}

/// A view of a surface that is pruned.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pruned_part {
    /// `sizeof(tree_pruned_part)`.
    pub struct_size: usize,
    /// Four floats for each vertex of the surface: the point that its element is scaled about, in metres, and the
    /// lambda from which on it is drawn (0: always). A vertex of no element has itself as centre.
    pub centers: *const f32,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Number of the surface in the mesh.
    pub surface: u32,
    /// Mean linear colour of what is seen of the full model: texture times base colour.
    pub mean: [f32; 3],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_pruned_part {
    const NAME: &'static str = "tree_pruned_part";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            centers: null(),
            n_vertices: 0,
            surface: 0,
            mean: [0.0; 3],
        }
    }
}

/// Views part `number`, rising with the surfaces. Set `part->struct_size` first. `TREE_ERROR_PARAMETER` when there is
/// no such part.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_part_view(
    pruned: *const tree_pruned,
    number: usize,
    part: *mut tree_pruned_part,
) -> tree_status {
    call(|| {
        let parts = unsafe { get(pruned, "pruned") }?.rust().parts();
        let Some(found) = parts.get(number) else {
            let text = format!("number is {number}, but there are {} parts", parts.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        let found = tree_pruned_part {
            centers: column(&found.centers).cast(),
            n_vertices: found.centers.len(),
            surface: found.surface,
            mean: found.mean.to_array(),
            ..tree_pruned_part::default_value()
        };
        unsafe { write(part, "part", &found) }
    })
}

/// The scale for each lambda, a table of its own. Free it with `tree_lod_table_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_table(
    pruned: *const tree_pruned,
    table: *mut *mut tree_lod_table,
) -> tree_status {
    call(|| {
        let place = unsafe { out(table, "table") }?;
        let found = unsafe { get(pruned, "pruned") }?.rust().table();
        place.put(tree_lod_table::new(found.clone()));
        Ok(())
    })
}

/// Writes the number of elements with which each tier begins. `kept` has room for `capacity` numbers, at least one for
/// each tier.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_kept(
    pruned: *const tree_pruned,
    kept: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(pruned, "pruned") }?.rust().schedule().kept();
        unsafe { fill_some(kept, capacity, found, "kept") }
    })
}

/// What is drawn of the elements; *ranks* are places in the order, the most important is 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_lod_cut {
    /// Triangles that are drawn.
    pub n_triangles: u64,
    /// Tier of the ranks below `fine`.
    pub tier: u32,
    /// Ranks from here to `end` are drawn with the next tier.
    pub fine: u32,
    /// Ranks from here on are not drawn.
    pub end: u32,
    /// 0.
    pub reserved: u32,
}

impl tree_lod_cut {
    fn of(cut: &Cut) -> Self {
        let Cut { tier, fine, end, n_triangles } = *cut;
        Self { n_triangles, tier, fine, end, reserved: 0 }
    }
}

/// The most elements that fit `lambda`, 0 to 1, of the full foliage's triangles: at least one, even if it has more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_cut(
    pruned: *const tree_pruned,
    lambda: f32,
    cut: *mut tree_lod_cut,
) -> tree_status {
    call(|| {
        let found = unsafe { get(pruned, "pruned") }?.rust().schedule().at(lambda)?;
        unsafe { out_value(cut, tree_lod_cut::of(&found), "cut") }
    })
}

/// A state, counted from the full model, 0, down; from `n_steps` on it is the last.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_step(
    pruned: *const tree_pruned,
    step: u64,
    cut: *mut tree_lod_cut,
) -> tree_status {
    call(|| {
        let found = unsafe { get(pruned, "pruned") }?.rust().schedule().cut(step);
        unsafe { out_value(cut, tree_lod_cut::of(&found), "cut") }
    })
}

/// The least lambda for which so many triangles may be drawn; 1 for more than there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_lambda_of(
    pruned: *const tree_pruned,
    n_triangles: u64,
    lambda: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(pruned, "pruned") }?.rust().schedule().lambda_of(n_triangles);
        unsafe { out_value(lambda, found, "lambda") }
    })
}

/// Lambda from which on an element is drawn: 0 for those that always are, 1 for ranks that do not exist.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_lambda_of_rank(
    pruned: *const tree_pruned,
    rank: u32,
    lambda: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(pruned, "pruned") }?.rust().schedule().lambda_of_rank(rank);
        unsafe { out_value(lambda, found, "lambda") }
    })
}

/// Frees a model, and with it all views of its parts. Meshes made of it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_free(pruned: *mut tree_pruned) -> tree_status {
    call(|| unsafe { free(pruned, "pruned") })
}
