//! What comes in: triangles, part by part.

use crate::border::{
    Failure, Result, TREE_ERROR_INVALID, Versioned, call, get, init, read_rows, slice, tree_status,
    tree_str, vec2s, vec3s,
};
use crate::mesh::tree_mesh;
use ::tree_mesh::Mesh;
use tree_model::skeletonize::{Hint, Part};
use tree_model::tree_core::{Limits, Resource};

/// Most parts of a mesh.
const MAX_PARTS: usize = 1 << 20;

/// What a part of a mesh is made of, as far as the caller knows: one of the `TREE_HINT_` constants.
pub type tree_hint = u32;
/// Not known: name, alpha and shape decide.
pub const TREE_HINT_AUTO: u32 = 0;
/// Bark.
pub const TREE_HINT_WOOD: u32 = 1;
/// Leaves, needles, flowers, or cards of whole sprays.
pub const TREE_HINT_LEAVES: u32 = 2;
/// Neither: ground, pots, labels.
pub const TREE_HINT_IGNORE: u32 = 3;

/// Triangles of one material. Any unit of length; +Y up. Begin with `tree_mesh_part_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_mesh_part {
    /// `sizeof(tree_mesh_part)`.
    pub struct_size: usize,
    /// Name of the material or object. It names the leaf kind, and may tell wood from leaves.
    pub name: tree_str,
    /// Three floats for each vertex, finite.
    pub positions: *const f32,
    /// Two floats for each vertex: texture coordinates, v downwards. NULL for none.
    pub uvs: *const f32,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Three for each triangle.
    pub indices: *const u32,
    /// Number of indices, a multiple of 3.
    pub n_indices: usize,
    /// What it is made of. Default `TREE_HINT_AUTO`.
    pub hint: tree_hint,
    /// Whether its texture has holes. Default 0.
    pub alpha_masked: u32,
    /// Whether both faces are drawn. Default 0.
    pub double_sided: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_mesh_part {
    const NAME: &'static str = "tree_mesh_part";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            positions: std::ptr::null(),
            uvs: std::ptr::null(),
            n_vertices: 0,
            indices: std::ptr::null(),
            n_indices: 0,
            hint: TREE_HINT_AUTO,
            alpha_masked: 0,
            double_sided: 0,
            reserved: 0,
        }
    }
}

/// Makes `part`, of `size` bytes, the default: nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_part_init(
    part: *mut tree_mesh_part,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(part, size) })
}

impl tree_mesh_part {
    /// Borrows the caller's columns; `name` is what the part is called by.
    unsafe fn rust<'a>(&self, limits: &Limits, name: &str) -> Result<Part<'a>> {
        let field = |field: &str| format!("{name}.{field}");
        let (n, resource) = (self.n_vertices, Resource::Triangles);
        limits.check(resource, (self.n_indices / 3) as u64)?;
        // The caps are for triangles: three times as many indices.
        let indices = Limits { triangles: limits.triangles.saturating_mul(3), ..*limits };
        let uvs = if self.uvs.is_null() {
            &[]
        } else {
            unsafe { vec2s(self.uvs, n, &indices, resource, &field("uvs")) }?
        };
        Ok(Part {
            positions: unsafe {
                vec3s(self.positions, n, &indices, resource, &field("positions"))
            }?,
            uvs,
            indices: unsafe {
                slice(self.indices, self.n_indices, &indices, resource, &field("indices"))
            }?,
            name: unsafe { self.name.get(&field("name")) }?,
            hint: hint(self.hint, &field("hint"))?,
            alpha_masked: self.alpha_masked != 0,
            double_sided: self.double_sided != 0,
        })
    }
}

fn hint(found: tree_hint, name: &str) -> Result<Hint> {
    match found {
        TREE_HINT_AUTO => Ok(Hint::Auto),
        TREE_HINT_WOOD => Ok(Hint::Wood),
        TREE_HINT_LEAVES => Ok(Hint::Leaves),
        TREE_HINT_IGNORE => Ok(Hint::Ignore),
        other => Err(Failure::not_one_of(name, other, "TREE_HINT_")),
    }
}

/// The caller's parts.
pub(super) unsafe fn read_parts<'a>(
    first: *const tree_mesh_part,
    n: usize,
    limits: &Limits,
) -> Result<Vec<Part<'a>>> {
    unsafe { read_rows(first, n, MAX_PARTS, "parts") }?
        .iter()
        .enumerate()
        .map(|(i, part)| unsafe { part.rust(limits, &format!("parts[{i}]")) })
        .collect()
}

/// The surfaces of a mesh as parts. `hints` is NULL or has one for each surface.
pub(super) unsafe fn parts_of_mesh<'a>(
    mesh: *const tree_mesh,
    hints: *const tree_hint,
    n_hints: usize,
    limits: &Limits,
) -> Result<Vec<Part<'a>>> {
    let mesh: &'a Mesh = unsafe { get(mesh, "mesh") }?.rust();
    let n = mesh.surfaces.len();
    let hints = if hints.is_null() {
        vec![TREE_HINT_AUTO; n]
    } else {
        unsafe { slice(hints, n_hints, limits, Resource::Triangles, "hints") }?.to_vec()
    };
    if hints.len() != n {
        let text = format!("{} hints for {n} surfaces; one for each, or NULL", hints.len());
        return Err(Failure::new(TREE_ERROR_INVALID, text));
    }
    let mut parts = mesh.parts();
    for (i, (part, found)) in parts.iter_mut().zip(hints).enumerate() {
        part.hint = hint(found, &format!("hints[{i}]"))?;
    }
    Ok(parts)
}
