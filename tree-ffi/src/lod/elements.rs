//! What is dropped and scaled as one.

use super::take::few;
use crate::border::{
    Failure, Handle, Result, Versioned, call, free, get, out, read, slice, tree_status, vec3s,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::{column, tree_mesh};
use tree_lod::{Elements, Grain, LeafSurfaces};
use tree_model::tree_core::{Limits, Resource};

/// What one element is: one of the `TREE_GRAIN_` constants.
pub type tree_grain = u32;

/// A connected piece: a card, a leaflet of a compound leaf, a single leaf. The two sides of a doubled card are
/// elements of their own.
pub const TREE_GRAIN_BLADE: u32 = 0;
/// A triangle, scaled about the centre of its blade: better pictures still, at the price of cut cards that
/// are seen when one comes near.
pub const TREE_GRAIN_TRIANGLE: u32 = 1;
/// A leaf with all its blades, where the mesh tells (its surfaces have anchors), otherwise as
/// `TREE_GRAIN_BLADE`. Nothing is ever half a leaf.
pub const TREE_GRAIN_LEAF: u32 = 2;

/// Most surfaces that can be named.
pub(super) const SURFACES_MAX: usize = 1 << 16;

/// The elements of a mesh: what is dropped and scaled as one, such as a leaf or a card. There is always at
/// least one.
pub struct tree_elements(Elements);

impl Handle for tree_elements {
    const NAME: &'static str = "tree_elements";
}

impl tree_elements {
    pub(crate) fn rust(&self) -> &Elements {
        &self.0
    }
}

/// A view of elements: a row each, in the order of surfaces and triangles.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_elements_columns {
    /// `sizeof(tree_elements_columns)`.
    pub struct_size: usize,
    /// Number of elements.
    pub n_elements: usize,
    /// Surfaces of the mesh that are pruned, rising; all others are always drawn.
    pub surfaces: *const u32,
    /// Number of these surfaces.
    pub n_surfaces: usize,
    /// For each element the surface of the mesh it is on.
    pub surface: *const u32,
    /// Where the triangles of each element begin in `triangles`, and their number at the end: `n_elements + 1`
    /// rows.
    pub starts: *const u32,
    /// Triangles of each element: their numbers in its surface.
    pub triangles: *const u32,
    /// Number of rows of `triangles`.
    pub n_triangles: usize,
    /// Three floats for each element: mean of its surface in metres, which it is scaled about.
    pub centers: *const f32,
    /// Three floats for each element: mean normal; zero where it has none (a closed blade, no area).
    pub normals: *const f32,
    /// For each element the area of its triangles in square metres.
    pub areas: *const f32,
    /// For each element the largest distance of a vertex from the mean of its own triangles, in metres.
    pub radii: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_elements_columns {
    const NAME: &'static str = "tree_elements_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_elements: 0,
            surfaces: std::ptr::null(),
            n_surfaces: 0,
            surface: std::ptr::null(),
            starts: std::ptr::null(),
            triangles: std::ptr::null(),
            n_triangles: 0,
            centers: std::ptr::null(),
            normals: std::ptr::null(),
            areas: std::ptr::null(),
            radii: std::ptr::null(),
        }
    }
}

pub(super) fn grain_of(grain: tree_grain) -> Result<Grain> {
    match grain {
        TREE_GRAIN_BLADE => Ok(Grain::Blade),
        TREE_GRAIN_TRIANGLE => Ok(Grain::Triangle),
        TREE_GRAIN_LEAF => Ok(Grain::Leaf),
        other => Err(Failure::not_one_of("grain", other, "TREE_GRAIN_")),
    }
}

/// Divides the foliage of a mesh into elements. `surfaces` names the `n_surfaces` surfaces that may be pruned,
/// each once. Without any (NULL, 0) they are found: those with anchors of leaves, and where there are none, as
/// in imported meshes, those whose material is alpha-tested, has two sides or is named after leaves. `grain`
/// is a `TREE_GRAIN_` constant; blades are a good choice. `control` may be NULL; `triangles` of its limits caps
/// the triangles. Free the elements with `tree_elements_free`.
///
/// `TREE_ERROR_INVALID` when there is no foliage, or a surface that was named does not exist or is named
/// twice.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_elements_of_mesh(
    mesh: *const tree_mesh,
    surfaces: *const u32,
    n_surfaces: usize,
    grain: tree_grain,
    control: *const tree_control,
    elements: *mut *mut tree_elements,
) -> tree_status {
    call(|| {
        let place = unsafe { out(elements, "elements") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let named = unsafe { few(surfaces, n_surfaces, SURFACES_MAX, "surfaces") }?;
        let foliage = if named.is_empty() {
            LeafSurfaces::Found
        } else {
            LeafSurfaces::Surfaces(named.to_vec())
        };
        let grain = grain_of(grain)?;
        let body = |control: &_| Ok(Elements::of_mesh(mesh, &foliage, grain, control)?);
        place.put(tree_elements(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Elements of your own, which are copied: each a row of the columns, as `tree_elements_view` gives them. `mesh` is what
/// they are elements of. `control` may be NULL; `triangles` of its limits caps elements and triangles. Free the
/// elements with `tree_elements_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
/// `n_triangles`, when the mesh lacks a surface or a triangle, or a centre is not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_elements_from_columns(
    mesh: *const tree_mesh,
    columns: *const tree_elements_columns,
    control: *const tree_control,
    elements: *mut *mut tree_elements,
) -> tree_status {
    call(|| {
        let place = unsafe { out(elements, "elements") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let limits = unsafe { limits(control) }?;
        let columns = unsafe { read(columns, "columns") }?;
        let made = unsafe { columns.rust(&limits) }?;
        made.check(mesh)?;
        place.put(tree_elements(made));
        Ok(())
    })
}

impl tree_elements_columns {
    unsafe fn rust(&self, limits: &Limits) -> Result<Elements> {
        let (n, rows) = (self.n_elements, Resource::Triangles);
        let points = |first, name| unsafe { vec3s(first, n, limits, rows, name) };
        let numbers = |first, name| unsafe { slice(first, n, limits, rows, name) };
        let whole = |first, n, name| unsafe { slice(first, n, limits, rows, name) };
        Ok(Elements {
            surfaces: whole(self.surfaces, self.n_surfaces, "columns.surfaces")?.to_vec(),
            surface: whole(self.surface, n, "columns.surface")?.to_vec(),
            starts: whole(self.starts, n.saturating_add(1), "columns.starts")?.to_vec(),
            triangles: whole(self.triangles, self.n_triangles, "columns.triangles")?.to_vec(),
            centers: points(self.centers, "columns.centers")?.to_vec(),
            normals: points(self.normals, "columns.normals")?.to_vec(),
            areas: numbers(self.areas, "columns.areas")?.to_vec(),
            radii: numbers(self.radii, "columns.radii")?.to_vec(),
        })
    }
}

/// Views elements. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_elements_view(
    elements: *const tree_elements,
    columns: *mut tree_elements_columns,
) -> tree_status {
    call(|| {
        let elements = unsafe { get(elements, "elements") }?.rust();
        let found = tree_elements_columns {
            n_elements: elements.len(),
            surfaces: column(&elements.surfaces),
            n_surfaces: elements.surfaces.len(),
            surface: column(&elements.surface),
            starts: column(&elements.starts),
            triangles: column(&elements.triangles),
            n_triangles: elements.n_triangles(),
            centers: column(&elements.centers).cast(),
            normals: column(&elements.normals).cast(),
            areas: column(&elements.areas),
            radii: column(&elements.radii),
            ..tree_elements_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Height in metres of the plant the elements belong to: from the ground at y = 0, where trees are based, to the
/// highest centre. Of a model that is not based there (something lies below, or all is higher than two crown
/// heights) the height of the crown. `TREE_ERROR_INVALID` when all elements are one point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_elements_plant_height(
    elements: *const tree_elements,
    metres: *mut f32,
) -> tree_status {
    call(|| {
        let elements = unsafe { get(elements, "elements") }?.rust();
        let height = tree_lod::implicit::plant_height(elements)?;
        unsafe { crate::border::out_value(metres, height, "metres") }
    })
}

/// Frees elements, and with them all views of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_elements_free(elements: *mut tree_elements) -> tree_status {
    call(|| unsafe { free(elements, "elements") })
}
