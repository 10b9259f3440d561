//! The surface around a plant.

use super::elements::tree_elements;
use super::metaballs::tree_metaballs;
use super::order_params::tree_order_params;
use super::take::{ask, fill_points, room_for};
use crate::border::{
    Handle, Result, Versioned, call, free, get, init, out, read, read_or_default, tree_status,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::{column, tree_mesh};
use glam::Vec3;
use tree_lod::implicit::{Hull, HullParams, Sample, surface};
use tree_model::tree_core::{Resource, Seed};

/// Which surface of a field, and how finely. Begin with `tree_hull_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_hull_params {
    /// `sizeof(tree_hull_params)`.
    pub struct_size: usize,
    /// Value of the field on the surface, 0.001 to 0.5. Default 0.05: a lone element gets a ball of 0.88 times
    /// the radius of influence.
    pub iso: f32,
    /// Cells of the grid along the radius of influence, 2 to 16. Default 3. Cost grows with the cube.
    pub detail: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_hull_params {
    const NAME: &'static str = "tree_hull_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let HullParams { iso, detail } = HullParams::default();
        Self { struct_size: size_of::<Self>(), iso, detail }
    }
}

impl tree_hull_params {
    pub(super) fn rust(&self) -> HullParams {
        HullParams { iso: self.iso, detail: self.detail }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_params_init(
    params: *mut tree_hull_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_params_check(params: *const tree_hull_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// A surface around a plant: closed, facing outwards, in several pieces where points are far apart.
pub struct tree_hull(Hull);

impl Handle for tree_hull {
    const NAME: &'static str = "tree_hull";
}

impl tree_hull {
    pub(super) fn rust(&self) -> &Hull {
        &self.0
    }
}

/// A view of a hull.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_hull_columns {
    /// `sizeof(tree_hull_columns)`.
    pub struct_size: usize,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Three floats for each vertex: where it is, in metres. Each place is there once.
    pub positions: *const f32,
    /// Three floats for each vertex: unit normal, outwards.
    pub normals: *const f32,
    /// Number of indices: three for each triangle.
    pub n_indices: usize,
    /// Vertices of the triangles, counter-clockwise seen from outside.
    pub indices: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_hull_columns {
    const NAME: &'static str = "tree_hull_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_vertices: 0,
            positions: std::ptr::null(),
            normals: std::ptr::null(),
            n_indices: 0,
            indices: std::ptr::null(),
        }
    }
}

/// The surface of a field of metaballs. `params` and `control` may be NULL; `voxels` and `triangles` of its limits
/// cap the grid and the surface. Free the hull with `tree_hull_free`. `TREE_ERROR_INVALID` when the points stand so
/// far from the origin that the numbers do not resolve the grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_of_metaballs(
    metaballs: *const tree_metaballs,
    params: *const tree_hull_params,
    control: *const tree_control,
    hull: *mut *mut tree_hull,
) -> tree_status {
    call(|| {
        let place = unsafe { out(hull, "hull") }?;
        let field = unsafe { get(metaballs, "metaballs") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(surface(field, &params, control)?);
        place.put(tree_hull(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The hull of a plant, as `tree_order_combined` makes it: `tree_metaballs_of_elements` and `tree_hull_of_metaballs`
/// in one, with `height`, `radius` and `hull` of `params`. `params` and `control` may be NULL. Free the hull with
/// `tree_hull_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_of_elements(
    elements: *const tree_elements,
    params: *const tree_order_params,
    control: *const tree_control,
    hull: *mut *mut tree_hull,
) -> tree_status {
    call(|| {
        let place = unsafe { out(hull, "hull") }?;
        let elements = unsafe { get(elements, "elements") }?.rust();
        let params = unsafe { tree_order_params::read(params) }?;
        let body = |control: &_| Ok(surface(&params.field(elements)?, &params.hull, control)?);
        place.put(tree_hull(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Views a hull. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_view(
    hull: *const tree_hull,
    columns: *mut tree_hull_columns,
) -> tree_status {
    call(|| {
        let hull = unsafe { get(hull, "hull") }?.rust();
        let found = tree_hull_columns {
            n_vertices: hull.positions().len(),
            positions: column(hull.positions()).cast(),
            normals: column(hull.normals()).cast(),
            n_indices: hull.indices().len(),
            indices: column(hull.indices()),
            ..tree_hull_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// A mesh of one surface, for looking at the hull. Free it with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_mesh(
    hull: *const tree_hull,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let hull = unsafe { get(hull, "hull") }?.rust();
        place.put(tree_mesh::new(hull.to_mesh()));
        Ok(())
    })
}

/// Chooses `n_samples` places evenly by area: for the visibility of a model in a `tree_scene`, for example.
/// `positions` and `normals` (unit, outwards) have room for `capacity` and `normals_capacity` floats, at least
/// `3 * n_samples` each. `control` may be NULL; `nodes` of its limits caps the samples.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_sample(
    hull: *const tree_hull,
    n_samples: usize,
    seed: u64,
    control: *const tree_control,
    positions: *mut f32,
    capacity: usize,
    normals: *mut f32,
    normals_capacity: usize,
) -> tree_status {
    call(|| {
        let hull = unsafe { get(hull, "hull") }?.rust();
        unsafe { limits(control) }?.check(Resource::Nodes, n_samples as u64)?;
        let room = (capacity, normals_capacity);
        room_for(3 * n_samples, room.0, "positions")?;
        room_for(3 * n_samples, room.1, "normals")?;
        let found = unsafe { run(control, |_| Ok(hull.sample(n_samples, Seed(seed)))) }?;
        unsafe { fill_samples((positions, normals), room, &found) }
    })
}

/// The place of the surface that is nearest to each of `n_points` points, three floats each in metres, or another
/// that is at most a hundredth farther from it, and the unit normal there. For a point that is not finite, or too
/// far off (1e18 m) to tell, both are zero. `positions` and `normals` have room for `capacity` and
/// `normals_capacity` floats, at least `3 * n_points` each. `control` may be NULL; `nodes` of its limits caps the
/// points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_nearest(
    hull: *const tree_hull,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    positions: *mut f32,
    capacity: usize,
    normals: *mut f32,
    normals_capacity: usize,
) -> tree_status {
    call(|| {
        let hull = unsafe { get(hull, "hull") }?.rust();
        let room = (capacity, normals_capacity);
        room_for(n_points.saturating_mul(3), room.0, "positions")?;
        room_for(n_points.saturating_mul(3), room.1, "normals")?;
        let none = Sample { position: Vec3::ZERO, normal: Vec3::ZERO };
        let answer = |point| hull.nearest(point).unwrap_or(none);
        let found = unsafe { ask(points, n_points, control, answer) }?;
        unsafe { fill_samples((positions, normals), room, &found) }
    })
}

unsafe fn fill_samples(
    places: (*mut f32, *mut f32),
    room: (usize, usize),
    found: &[Sample],
) -> Result<()> {
    let positions: Vec<Vec3> = found.iter().map(|sample| sample.position).collect();
    let normals: Vec<Vec3> = found.iter().map(|sample| sample.normal).collect();
    unsafe { fill_points(places.0, room.0, &positions, "positions") }?;
    unsafe { fill_points(places.1, room.1, &normals, "normals") }
}

/// Frees a hull, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hull_free(hull: *mut tree_hull) -> tree_status {
    call(|| unsafe { free(hull, "hull") })
}
