//! One leaf as a small mesh.

use super::tree_look;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, Versioned, call, foresee, free, get, out, slice,
    tree_status, vec2s, vec3s, view, write,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use ::tree_mesh::{LeafForm, LeafLook, LeafMesh, LeafModel};
use tree_model::tree_core::{Limits, Resource};

/// One leaf as a small mesh in its own frame: base at the origin, midrib along +Y with the apex at a
/// height of about 1, upper face towards +Z. Triangles counter-clockwise seen from above. As input, or as
/// a view.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_mesh {
    /// `sizeof(tree_leaf_mesh)`.
    pub struct_size: usize,
    /// Number of vertices, at most 65,536.
    pub n_vertices: usize,
    /// Number of indices, three for each triangle.
    pub n_indices: usize,
    /// Three floats for each vertex: where it is, in lengths of the leaf.
    pub positions: *const f32,
    /// Three floats for each vertex: its unit normal.
    pub normals: *const f32,
    /// Two floats for each vertex: texture coordinates, v downwards.
    pub uvs: *const f32,
    /// Two floats for each vertex, or NULL: where it lies on the leaf's own piece of the light map, 0 to 1
    /// both ways. NULL: above its place in the plane of the leaf, right for leaves that do not overlap
    /// themselves.
    pub uvs2: *const f32,
    /// Three for each triangle: its vertices.
    pub indices: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_leaf_mesh {
    const NAME: &'static str = "tree_leaf_mesh";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LeafMesh::default())
    }
}

impl tree_leaf_mesh {
    /// A view.
    fn of(mesh: &LeafMesh) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_vertices: mesh.positions.len(),
            n_indices: mesh.indices.len(),
            positions: column(&mesh.positions).cast(),
            normals: column(&mesh.normals).cast(),
            uvs: column(&mesh.uvs).cast(),
            uvs2: column(&mesh.uvs2).cast(),
            indices: column(&mesh.indices),
        }
    }

    /// A copy, which is checked with the look it is for; `argument` is what it is called by.
    pub(super) unsafe fn rust(&self, limits: &Limits, argument: &str) -> Result<LeafMesh> {
        let part = |name: &str| format!("{argument}.{name}");
        limits.check(Resource::Triangles, (self.n_indices / 3) as u64)?;
        // A triangle has three indices, and vertices of its own if it likes.
        let limits = Limits { triangles: limits.triangles.saturating_mul(3), ..*limits };
        let (n, rows) = (self.n_vertices, Resource::Triangles);
        let positions = unsafe { vec3s(self.positions, n, &limits, rows, &part("positions")) }?;
        let normals = unsafe { vec3s(self.normals, n, &limits, rows, &part("normals")) }?;
        let uvs = unsafe { vec2s(self.uvs, n, &limits, rows, &part("uvs")) }?;
        let n_uvs2 = if self.uvs2.is_null() { 0 } else { n };
        let uvs2 = unsafe { vec2s(self.uvs2, n_uvs2, &limits, rows, &part("uvs2")) }?;
        let indices =
            unsafe { slice(self.indices, self.n_indices, &limits, rows, &part("indices")) }?;
        Ok(LeafMesh {
            positions: positions.to_vec(),
            normals: normals.to_vec(),
            uvs: uvs.to_vec(),
            uvs2: uvs2.to_vec(),
            indices: indices.to_vec(),
        })
    }
}

/// The mesh of one leaf: one sheet, without petiole. For engines that instance leaves themselves, and to
/// see how much of its triangles is visible.
pub struct tree_leaf_model(LeafModel);

impl Handle for tree_leaf_model {
    const NAME: &'static str = "tree_leaf_model";
}

impl tree_leaf_model {
    pub(crate) fn new(model: LeafModel) -> Self {
        Self(model)
    }
}

/// How a leaf's mesh came about.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_model_report {
    /// `sizeof(tree_leaf_model_report)`.
    pub struct_size: usize,
    /// Whether the picture could not be outlined (no mask, or nothing of it visible) and the leaf is a card
    /// instead.
    pub fallback: u32,
    /// Whether the margin is modelled, so that no mask is needed.
    pub opaque: u32,
    /// Share of the picture's pixels that can be seen; 1 without a mask.
    pub visible: f32,
    /// Area of the polygon in the picture as share of the picture; 1 for a card.
    pub drawn: f32,
    /// Area of all triangles together, in squared lengths of the leaf.
    pub area: f32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_model_report {
    const NAME: &'static str = "tree_leaf_model_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            fallback: 0,
            opaque: 0,
            visible: 0.0,
            drawn: 0.0,
            area: 0.0,
            reserved: 0,
        }
    }
}

impl tree_leaf_model_report {
    fn of(model: &LeafModel) -> Self {
        Self {
            fallback: model.fallback.into(),
            opaque: model.opaque.into(),
            visible: model.visible,
            drawn: model.drawn,
            area: model.mesh.area(),
            ..Self::default_value()
        }
    }
}

/// The look of leaf kind `kind`.
pub(super) fn leaf_of(look: &tree_look, kind: usize) -> Result<&LeafLook> {
    let leaves = &look.rust().leaves;
    leaves.get(kind).ok_or_else(|| {
        let n = leaves.len();
        Failure::new(TREE_ERROR_INVALID, format!("kind is {kind}, the look has {n} leaf kinds"))
    })
}

/// Makes the mesh of one leaf of kind `kind`. `report` may be NULL. Free the model with
/// `tree_leaf_model_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_leaf_model(
    look: *const tree_look,
    kind: usize,
    control: *const tree_control,
    report: *mut tree_leaf_model_report,
    model: *mut *mut tree_leaf_model,
) -> tree_status {
    call(|| {
        let place = unsafe { out(model, "model") }?;
        unsafe { foresee(report, "report") }?;
        let leaf = leaf_of(unsafe { get(look, "look") }?, kind)?;
        let made = unsafe { run(control, |_| Ok(leaf.model()?)) }?;
        unsafe { view(report, "report", &tree_leaf_model_report::of(&made)) }?;
        place.put(tree_leaf_model(made));
        Ok(())
    })
}

/// Views the columns of a leaf's mesh. Set `mesh->struct_size` first. Valid until the model is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_model_view(
    model: *const tree_leaf_model,
    mesh: *mut tree_leaf_mesh,
) -> tree_status {
    call(|| {
        let model = unsafe { get(model, "model") }?;
        unsafe { write(mesh, "mesh", &tree_leaf_mesh::of(&model.0.mesh)) }
    })
}

/// Frees a leaf's mesh.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_model_free(model: *mut tree_leaf_model) -> tree_status {
    call(|| unsafe { free(model, "model") })
}

/// Views the leaf of your own that kind `kind` of a look has; without vertices where its form is not
/// `TREE_LEAF_MESH`. Set `mesh->struct_size` first. Valid until the look is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_leaf_mesh(
    look: *const tree_look,
    kind: usize,
    mesh: *mut tree_leaf_mesh,
) -> tree_status {
    call(|| {
        let viewed = match &leaf_of(unsafe { get(look, "look") }?, kind)?.form {
            LeafForm::Mesh(own) => tree_leaf_mesh::of(own),
            _ => tree_leaf_mesh::default_value(),
        };
        unsafe { write(mesh, "mesh", &viewed) }
    })
}
