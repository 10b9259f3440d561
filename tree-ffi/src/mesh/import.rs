//! A mesh of an engine's own triangles.

use super::{tree_mesh, tree_surface, tree_wind_branch};
use crate::border::{Result, call, out, read_rows, slice, tree_status, vec2s, vec3s};
use crate::control::{limits, run, tree_control};
use crate::look::tree_material;
use ::tree_mesh::wind::Branch;
use ::tree_mesh::{Mesh, Surface};
use glam::Vec4;
use tree_model::tree_core::{Limits, Resource};

/// Most surfaces, and most materials, of a caller's mesh.
const ROWS_MAX: usize = 1 << 16;

impl tree_surface {
    /// A copy, which is checked with the mesh it is part of; `argument` is what it is called by.
    unsafe fn rust(&self, limits: &Limits, argument: &str) -> Result<Surface> {
        let part = |name: &str| format!("{argument}.{name}");
        // A triangle has three indices, and vertices of its own if it likes.
        let limits = Limits { triangles: limits.triangles.saturating_mul(3), ..*limits };
        let (limits, rows, n) = (&limits, Resource::Triangles, self.n_vertices);
        let optional = |absent: bool| if absent { 0 } else { n };
        let n_tangents = optional(self.tangents.is_null());
        let n_uvs2 = optional(self.uvs2.is_null());
        let n_branches = optional(self.branches.is_null());
        let n_occlusion = optional(self.occlusion.is_null());
        let n_welds = optional(self.welds.is_null());
        let tangents: &[Vec4] =
            unsafe { slice(self.tangents.cast(), n_tangents, limits, rows, &part("tangents")) }?;
        let branches =
            unsafe { slice(self.branches, n_branches, limits, rows, &part("branches")) }?;
        let occlusion =
            unsafe { slice(self.occlusion, n_occlusion, limits, rows, &part("occlusion")) }?;
        let welds = unsafe { slice(self.welds, n_welds, limits, rows, &part("welds")) }?;
        let anchors = Resource::Leaves;
        let anchors =
            unsafe { vec3s(self.anchors, self.n_anchors, limits, anchors, &part("anchors")) }?;
        let indices =
            unsafe { slice(self.indices, self.n_indices, limits, rows, &part("indices")) }?;
        let positions = unsafe { vec3s(self.positions, n, limits, rows, &part("positions")) }?;
        let normals = unsafe { vec3s(self.normals, n, limits, rows, &part("normals")) }?;
        let uvs = unsafe { vec2s(self.uvs, n, limits, rows, &part("uvs")) }?;
        let uvs2 = unsafe { vec2s(self.uvs2, n_uvs2, limits, rows, &part("uvs2")) }?;
        Ok(Surface {
            positions: positions.to_vec(),
            normals: normals.to_vec(),
            uvs: uvs.to_vec(),
            tangents: tangents.to_vec(),
            uvs2: uvs2.to_vec(),
            branches: branches.to_vec(),
            occlusion: occlusion.to_vec(),
            welds: welds.to_vec(),
            anchors: anchors.to_vec(),
            indices: indices.to_vec(),
            material: self.material,
        })
    }
}

/// The caller's branches, in the layout of ours.
unsafe fn branches(
    first: *const tree_wind_branch,
    n: usize,
    limits: &Limits,
) -> Result<Vec<Branch>> {
    let rows = unsafe { slice(first, n, limits, Resource::Nodes, "branches") }?;
    Ok(bytemuck::cast_slice::<tree_wind_branch, Branch>(rows).to_vec())
}

/// Makes a mesh of your own triangles: `n_surfaces` surfaces whose `material` is an index into the
/// `n_materials` materials. `branches` may be NULL when `n_branches` is 0; no surface may name a branch
/// then. All is copied but the textures, which are shared, and checked as by `tree_mesh_check`. `control`
/// may be NULL; only its limits and its pool matter. Free the mesh with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_from_surfaces(
    surfaces: *const tree_surface,
    n_surfaces: usize,
    materials: *const tree_material,
    n_materials: usize,
    branches: *const tree_wind_branch,
    n_branches: usize,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { read_rows(surfaces, n_surfaces, ROWS_MAX, "surfaces") }?;
        let triangles = rows.iter().map(|row| (row.n_indices / 3) as u64);
        limits.check(Resource::Triangles, triangles.fold(0, u64::saturating_add))?;
        let surfaces = rows
            .iter()
            .enumerate()
            .map(|(i, row)| unsafe { row.rust(&limits, &format!("surfaces[{i}]")) })
            .collect::<Result<_>>()?;
        let rows = unsafe { read_rows(materials, n_materials, ROWS_MAX, "materials") }?;
        let materials = rows
            .iter()
            .enumerate()
            .map(|(i, row)| unsafe { row.rust(&format!("materials[{i}]")) })
            .collect::<Result<_>>()?;
        let branches = unsafe { self::branches(branches, n_branches, &limits) }?;
        let made = Mesh { surfaces, materials, branches };
        unsafe { run(control, |_| Ok(made.check()?)) }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}
