//! Meshes of which every level is a prefix of the index buffers.

use super::model::tree_multires;
use super::there;
use crate::border::{
    Failure, Handle, Shared, TREE_ERROR_BUFFER, TREE_ERROR_PARAMETER, Versioned, call, fill, free,
    get, get_opt, out, out_value, tree_status, write,
};
use crate::control::{run, tree_control};
use crate::look::{or_built_in, tree_look};
use crate::mesh::{ask_for_copies, column, mesh_params, tree_mesh, tree_mesh_params};
use bytemuck::{Pod, Zeroable};
use std::ptr::null;
use tree_lod::multires::{Draw, MultiMesh};

/// Surfaces for which draws take no memory: most trees have two.
const FEW: usize = 32;

/// Tubes and leaves in the order of their paths: the mesh of a level is a prefix of each index buffer, and a shader lets
/// the path that comes next grow out of its fork.
pub struct tree_multi_mesh(Shared<MultiMesh>);

impl Handle for tree_multi_mesh {
    const NAME: &'static str = "tree_multi_mesh";
}

impl tree_multi_mesh {
    /// A mesh with levels that is part of something.
    pub(crate) fn part(held: Shared<MultiMesh>) -> Self {
        Self(held)
    }

    pub(super) fn rust(&self) -> &MultiMesh {
        self.0.get()
    }
}

/// Draws a tree: each path is a closed tube of its own, with a cap at either end, and begins inside the wood that bears
/// it; it has a ring at each node, and as many sides all along as `params` ask for. Surface 0 is the wood, surface 1 + k
/// the leaves of kind k. Of `params` those of curves, flares, tangents and light maps are not used.
///
/// `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL. Free
/// the mesh with `tree_multi_mesh_free`. `TREE_ERROR_PARAMETER` for more than 16,777,216 levels; otherwise as
/// `tree_mesh_build`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_new(
    multires: *const tree_multires,
    look: *const tree_look,
    params: *const tree_mesh_params,
    control: *const tree_control,
    multi_mesh: *mut *mut tree_multi_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multi_mesh, "multi_mesh") }?;
        let multires = unsafe { get(multires, "multires") }?.rust();
        let params = unsafe { mesh_params(params) }?;
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let made = unsafe {
            run(control, |control| {
                let look = or_built_in(look, multires.tree().species())?;
                Ok(MultiMesh::new(multires, &look, &params, control)?)
            })
        }?;
        place.put(tree_multi_mesh(Shared::new(made)));
        Ok(())
    })
}

/// How much there is of a mesh with levels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_multi_mesh_totals {
    /// `sizeof(tree_multi_mesh_totals)`.
    pub struct_size: usize,
    /// Number of levels, at least 1.
    pub n_levels: usize,
    /// Number of surfaces, those without triangles included.
    pub n_surfaces: usize,
    /// Triangles of all levels together.
    pub n_triangles: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_multi_mesh_totals {
    const NAME: &'static str = "tree_multi_mesh_totals";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), n_levels: 0, n_surfaces: 0, n_triangles: 0 }
    }
}

/// Tells how large a mesh is. Set `totals->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_measure(
    multi_mesh: *const tree_multi_mesh,
    totals: *mut tree_multi_mesh_totals,
) -> tree_status {
    call(|| {
        let multi = unsafe { get(multi_mesh, "multi_mesh") }?.rust();
        let found = tree_multi_mesh_totals {
            n_levels: multi.n_levels(),
            n_surfaces: multi.branches().len(),
            n_triangles: multi.mesh().n_triangles() as u64,
            ..tree_multi_mesh_totals::default_value()
        };
        unsafe { write(totals, "totals", &found) }
    })
}

/// The mesh to upload, with all levels, nothing copied. Free it with `tree_mesh_free`; it keeps alive what it is of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_mesh(
    multi_mesh: *const tree_multi_mesh,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let multi = unsafe { get(multi_mesh, "multi_mesh") }?;
        place.put(tree_mesh::part(multi.0.part(MultiMesh::mesh)));
        Ok(())
    })
}

/// One more column of a surface, for the shader that lets branches grow in.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_multi_mesh_column {
    /// `sizeof(tree_multi_mesh_column)`.
    pub struct_size: usize,
    /// Four floats for each vertex of the surface: the fork that its path stems from, in metres, and the number of the
    /// path, from 0 on.
    pub branches: *const f32,
    /// Number of vertices.
    pub n_vertices: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_multi_mesh_column {
    const NAME: &'static str = "tree_multi_mesh_column";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), branches: null(), n_vertices: 0 }
    }
}

/// Views what shaders need of the vertices of surface `number`. Set `column->struct_size` first. `TREE_ERROR_PARAMETER`
/// when there is no such surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_branches(
    multi_mesh: *const tree_multi_mesh,
    number: usize,
    column: *mut tree_multi_mesh_column,
) -> tree_status {
    call(|| {
        let surfaces = unsafe { get(multi_mesh, "multi_mesh") }?.rust().branches();
        there("number", number, surfaces.len(), "surfaces")?;
        let branches = surfaces.get(number).map_or(&[][..], |found| found);
        let found = tree_multi_mesh_column {
            branches: self::column(branches).cast(),
            n_vertices: branches.len(),
            ..tree_multi_mesh_column::default_value()
        };
        unsafe { write(column, "column", &found) }
    })
}

/// What is drawn of a surface: so many of its indices, from the first on.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_multi_draw {
    /// Number of the surface.
    pub surface: u32,
    /// Number of indices; may be 0.
    pub index_count: u32,
}

impl tree_multi_draw {
    fn of(draw: &Draw) -> Self {
        Self { surface: draw.surface, index_count: draw.index_count }
    }
}

/// What is drawn at a level: 3.25 draws three paths whole and a quarter of the fourth, drawn together about its fork by
/// the shader; levels are clamped to 1 and all. `draws` has room for `capacity` rows, at least one for each surface, in
/// their order; `n_triangles` is how many triangles that is. It is quick enough for every frame.
/// `TREE_ERROR_PARAMETER` for NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_draws(
    multi_mesh: *const tree_multi_mesh,
    level: f32,
    draws: *mut tree_multi_draw,
    capacity: usize,
    n_triangles: *mut u64,
) -> tree_status {
    call(|| {
        let multi = unsafe { get(multi_mesh, "multi_mesh") }?.rust();
        let n = multi.branches().len();
        if capacity < n {
            let text = format!("draws has room for {capacity} values, {n} are needed");
            return Err(Failure::new(TREE_ERROR_BUFFER, text));
        }
        let (mut few, mut many) = ([Draw::default(); FEW], Vec::new());
        let rows = match few.get_mut(..n) {
            Some(rows) => rows,
            None => {
                many.resize(n, Draw::default());
                &mut many[..]
            }
        };
        let counted = multi.draws(level, rows)?;
        let mut written = [tree_multi_draw::default(); FEW];
        for (i, chunk) in rows.chunks(FEW).enumerate() {
            let written = &mut written[..chunk.len()];
            written.iter_mut().zip(chunk).for_each(|(to, draw)| *to = tree_multi_draw::of(draw));
            let (to, left) = (draws.wrapping_add(i * FEW), capacity - i * FEW);
            unsafe { fill(to, left, written, "draws") }?;
        }
        unsafe { out_value(n_triangles, counted, "n_triangles") }
    })
}

/// Number of indices of the wood, surface 0, that are drawn at a level; levels are clamped to 1 and all.
/// `TREE_ERROR_PARAMETER` for NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_wood_indices(
    multi_mesh: *const tree_multi_mesh,
    level: f32,
    n_indices: *mut u32,
) -> tree_status {
    call(|| {
        let multi = unsafe { get(multi_mesh, "multi_mesh") }?.rust();
        if level.is_nan() {
            return Err(Failure::new(TREE_ERROR_PARAMETER, "level is not a number"));
        }
        unsafe { out_value(n_indices, multi.wood_indices(level), "n_indices") }
    })
}

/// The greatest whole level with at most `n_triangles` triangles of wood; at least 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_level_of_wood(
    multi_mesh: *const tree_multi_mesh,
    n_triangles: u64,
    n_levels: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(multi_mesh, "multi_mesh") }?.rust().level_of_wood(n_triangles);
        unsafe { out_value(n_levels, n, "n_levels") }
    })
}

/// A level, clamped to 1 and all, as a plain mesh: what is not drawn is left out, and the last path has grown as the
/// shader lets it. `control` may be NULL; of it only threads matter, and a cancellation before the work begins. Free
/// the mesh with `tree_mesh_free`. `TREE_ERROR_PARAMETER` for NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_mesh_at(
    multi_mesh: *const tree_multi_mesh,
    level: f32,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let multi = unsafe { get(multi_mesh, "multi_mesh") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([multi.mesh()], 1)?;
                Ok(multi.mesh_at(level)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// Frees a mesh with levels, and with it all views of its columns. Meshes made of it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_free(multi_mesh: *mut tree_multi_mesh) -> tree_status {
    call(|| unsafe { free(multi_mesh, "multi_mesh") })
}
