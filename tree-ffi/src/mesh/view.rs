//! What an engine uploads: the columns of a mesh, where they lie.

use super::{column, tree_mesh};
use crate::border::{Versioned, call, get, out_value, tree_status, write};
use ::tree_mesh::Surface;
use glam::{Vec2, Vec3, Vec4};
use tree_model::tree_core::Aabb;

// Columns are tightly packed floats: what the header says of them.
const _: () = assert!(size_of::<Vec2>() == 8 && align_of::<Vec2>() == 4);
const _: () = assert!(size_of::<Vec3>() == 12 && align_of::<Vec3>() == 4);
const _: () = assert!(size_of::<Vec4>() == 16 && align_of::<Vec4>() == 4);

/// Triangles of one material, in columns: a view of a mesh's surface, or input. Columns that are absent
/// are NULL. Triangles are counter-clockwise seen from outside; texture coordinates have their origin at
/// the top left of the picture, v downwards.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_surface {
    /// `sizeof(tree_surface)`.
    pub struct_size: usize,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Number of indices, three for each triangle.
    pub n_indices: usize,
    /// Number of leaves; 0 for bark.
    pub n_anchors: usize,
    /// Vertices of each leaf, `n_vertices / n_anchors`; 0 when the surface is not made of leaves. Ignored
    /// in input.
    pub vertices_per_leaf: usize,
    /// Three floats for each vertex: where it is, in metres.
    pub positions: *const f32,
    /// Three floats for each vertex: its unit normal.
    pub normals: *const f32,
    /// Two floats for each vertex: texture coordinates. Bark repeats beyond 0 to 1.
    pub uvs: *const f32,
    /// Four floats for each vertex, or NULL: the unit tangent, the direction in which u grows along the
    /// surface, and the sign that makes `sign * cross(normal, tangent)` point against v, up the picture
    /// (as glTF).
    pub tangents: *const f32,
    /// Two floats for each vertex, or NULL: texture coordinates for a light map, within 0 to 1, in which
    /// no two places of the whole mesh overlap.
    pub uvs2: *const f32,
    /// One for each vertex, or NULL: the branch it moves with, an index into the branches that
    /// `tree_mesh_branches` views.
    pub branches: *const u32,
    /// One for each vertex, or NULL: ambient occlusion, 0 (dark) to 1 (open).
    pub occlusion: *const f32,
    /// One for each vertex, or NULL when no vertex is a copy: the first vertex that stands at the same
    /// point of the closed surface, itself unless it is a copy at a seam of the texture.
    pub welds: *const u32,
    /// Three floats for each leaf, or NULL when there are none: where it is attached. All leaves have the
    /// same number of vertices and lie one after the other.
    pub anchors: *const f32,
    /// Three for each triangle: its vertices.
    pub indices: *const u32,
    /// The material, an index into the mesh's materials.
    pub material: u32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_surface {
    const NAME: &'static str = "tree_surface";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Surface::default())
    }
}

impl tree_surface {
    pub(crate) fn of(surface: &Surface) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_vertices: surface.positions.len(),
            n_indices: surface.indices.len(),
            n_anchors: surface.anchors.len(),
            vertices_per_leaf: surface.vertices_per_leaf().unwrap_or(0),
            positions: column(&surface.positions).cast(),
            normals: column(&surface.normals).cast(),
            uvs: column(&surface.uvs).cast(),
            tangents: column(&surface.tangents).cast(),
            uvs2: column(&surface.uvs2).cast(),
            branches: column(&surface.branches),
            occlusion: column(&surface.occlusion),
            welds: column(&surface.welds),
            anchors: column(&surface.anchors).cast(),
            indices: column(&surface.indices),
            material: surface.material,
            reserved: 0,
        }
    }
}

/// A box and a ball around vertices, in metres. All 0 when there are no vertices.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bounds {
    /// `sizeof(tree_bounds)`.
    pub struct_size: usize,
    /// Lower corner of the box.
    pub min: [f32; 3],
    /// Upper corner of the box.
    pub max: [f32; 3],
    /// Centre of a ball that holds every vertex: the middle of the box.
    pub center: [f32; 3],
    /// Its radius, at most √3 times that of the smallest such ball.
    pub radius: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_bounds {
    const NAME: &'static str = "tree_bounds";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let (min, max, center) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        Self { struct_size: size_of::<Self>(), min, max, center, radius: 0.0 }
    }
}

impl tree_bounds {
    pub(crate) fn of(bounds: Aabb, sphere: Option<(Vec3, f32)>) -> Self {
        match sphere {
            None => Self::default_value(),
            Some((center, radius)) => Self {
                min: bounds.min.to_array(),
                max: bounds.max.to_array(),
                center: center.to_array(),
                radius,
                ..Self::default_value()
            },
        }
    }
}

/// How much there is of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_mesh_totals {
    /// `sizeof(tree_mesh_totals)`.
    pub struct_size: usize,
    /// Number of surfaces.
    pub n_surfaces: u64,
    /// Number of materials.
    pub n_materials: u64,
    /// Number of branches that move in the wind.
    pub n_branches: u64,
    /// Vertices of all surfaces.
    pub n_vertices: u64,
    /// Triangles of all surfaces.
    pub n_triangles: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_mesh_totals {
    const NAME: &'static str = "tree_mesh_totals";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_surfaces: 0,
            n_materials: 0,
            n_branches: 0,
            n_vertices: 0,
            n_triangles: 0,
        }
    }
}

/// Counts what a mesh has. Set `totals->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_measure(
    mesh: *const tree_mesh,
    totals: *mut tree_mesh_totals,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let counted = tree_mesh_totals {
            n_surfaces: mesh.surfaces.len() as u64,
            n_materials: mesh.materials.len() as u64,
            n_branches: mesh.branches.len() as u64,
            n_vertices: mesh.n_vertices() as u64,
            n_triangles: mesh.n_triangles() as u64,
            ..tree_mesh_totals::default_value()
        };
        unsafe { write(totals, "totals", &counted) }
    })
}

/// Number of surfaces of a mesh.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_surface_count(
    mesh: *const tree_mesh,
    n_surfaces: *mut usize,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        unsafe { out_value(n_surfaces, mesh.surfaces.len(), "n_surfaces") }
    })
}

/// Views surface `number` of a mesh, from 0 on: nothing is copied. Set `surface->struct_size` first. Valid
/// until the mesh is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_surface(
    mesh: *const tree_mesh,
    number: usize,
    surface: *mut tree_surface,
) -> tree_status {
    call(|| {
        let rust = unsafe { get(mesh, "mesh") }?.rust().surface(number)?;
        unsafe { write(surface, "surface", &tree_surface::of(rust)) }
    })
}

/// The box and a ball around all vertices of surface `number`. Looks at each vertex: keep the answer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_surface_bounds(
    mesh: *const tree_mesh,
    number: usize,
    bounds: *mut tree_bounds,
) -> tree_status {
    call(|| {
        let surface = unsafe { get(mesh, "mesh") }?.rust().surface(number)?;
        let found = tree_bounds::of(surface.bounds(), surface.bounding_sphere());
        unsafe { write(bounds, "bounds", &found) }
    })
}

/// The box and a ball around all vertices of a mesh. Looks at each vertex: keep the answer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_bounds(
    mesh: *const tree_mesh,
    bounds: *mut tree_bounds,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let found = tree_bounds::of(mesh.bounds(), mesh.bounding_sphere());
        unsafe { write(bounds, "bounds", &found) }
    })
}

/// Checks that a mesh can be drawn and written: columns of equal length, finite numbers, indices and
/// materials that exist, looks within their ranges, textures filled, branches after those that carry them.
/// Meshes of this library pass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_check(mesh: *const tree_mesh) -> tree_status {
    call(|| Ok(unsafe { get(mesh, "mesh") }?.rust().check()?))
}

/// As `tree_mesh_check`, of the columns of surface `number` only.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_check_surface(
    mesh: *const tree_mesh,
    number: usize,
) -> tree_status {
    call(|| Ok(unsafe { get(mesh, "mesh") }?.rust().check_surface(number)?))
}

/// Checks that no colour of a material is brighter than 1, on which file formats rely; drawing does not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_check_colors(mesh: *const tree_mesh) -> tree_status {
    call(|| Ok(unsafe { get(mesh, "mesh") }?.rust().check_colors()?))
}

/// Checks that normals have unit length, within half a percent, on which file formats and engines rely;
/// drawing does not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_check_normals(mesh: *const tree_mesh) -> tree_status {
    call(|| Ok(unsafe { get(mesh, "mesh") }?.rust().check_normals()?))
}
