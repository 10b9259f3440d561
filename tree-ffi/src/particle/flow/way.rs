//! The way to the base, and what else steers particles.

use super::params::tree_flow_params;
use crate::border::{
    Handle, Result, Versioned, call, free, get, init, out, read, read_or_default, read_rows,
    tree_status,
};
use crate::control::{run, tree_control};
use crate::particle::field::tree_direction_field;
use crate::particle::grid::{ask, fill_vectors, tree_grid};
use crate::particle::view::VIEWS_MAX;
use crate::photo::tree_particle_camera;
use glam::Vec3;
use tree_model::particle::Camera;
use tree_model::particle::field::DirectionField;
use tree_model::particle::flow::{Forces, Way};

/// The way to the base from everywhere in a density.
pub struct tree_way(Way);

impl Handle for tree_way {
    const NAME: &'static str = "tree_way";
}

impl tree_way {
    pub(super) fn rust(&self) -> &Way {
        &self.0
    }
}

/// Finds the cheapest way to the origin from everywhere in `density`: it keeps to dense voxels and prefers
/// the stem. `params` may be NULL; `stem` counts. Free it with `tree_way_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_way_new(
    density: *const tree_grid,
    params: *const tree_flow_params,
    control: *const tree_control,
    way: *mut *mut tree_way,
) -> tree_status {
    call(|| {
        let place = unsafe { out(way, "way") }?;
        let density = unsafe { get(density, "density") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let body = |control: &_| Ok(Way::new(density, &params, control)?);
        place.put(tree_way(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// What the way to the base costs from the centre of each voxel: metres, more where it is not dense. Free
/// the grid with `tree_grid_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_way_costs(
    way: *const tree_way,
    grid: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grid, "grid") }?;
        place.put(tree_grid::new(unsafe { get(way, "way") }?.rust().costs().clone()));
        Ok(())
    })
}

/// The way on from `n_points` points, three floats each in metres; outside the grid as from its nearest
/// point. `directions` has room for `capacity` floats, three for each point: vectors of length 0 to 1, and 0
/// for points that are not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_way_sample(
    way: *const tree_way,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    directions: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let way = unsafe { get(way, "way") }?.rust();
        let found = unsafe { ask(points, n_points, control, |p| finite(p, |p| way.sample(p))) }?;
        unsafe { fill_vectors(directions, capacity, &found, "directions") }
    })
}

/// What `answer` says of a finite point; 0 where that is so far off that there is no number for it.
fn finite(point: Vec3, answer: impl Fn(Vec3) -> Vec3) -> [f32; 3] {
    let found = if point.is_finite() { answer(point) } else { Vec3::ZERO };
    if found.is_finite() { found.to_array() } else { [0.0; 3] }
}

/// Frees a way.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_way_free(way: *mut tree_way) -> tree_status {
    call(|| unsafe { free(way, "way") })
}

/// A view that steers particles. Begin with `tree_flow_view_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_flow_view {
    /// `sizeof(tree_flow_view)`.
    pub struct_size: usize,
    /// Where its photograph was taken from. No default: NULL, which is refused.
    pub camera: *const tree_particle_camera,
    /// Where particles go in its picture. No default: NULL, which is refused.
    pub field: *const tree_direction_field,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_flow_view {
    const NAME: &'static str = "tree_flow_view";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), camera: std::ptr::null(), field: std::ptr::null() }
    }
}

/// Makes `view`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_flow_view_init(
    view: *mut tree_flow_view,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(view, size) })
}

/// The cameras and fields of an array.
pub(super) unsafe fn flow_views<'a>(
    first: *const tree_flow_view,
    n: usize,
) -> Result<Vec<(Camera, &'a DirectionField)>> {
    let rows = unsafe { read_rows(first, n, VIEWS_MAX, "views") }?;
    let view = |(i, row): (usize, &tree_flow_view)| {
        let camera = unsafe { read(row.camera, &format!("views[{i}].camera")) }?.rust();
        camera.validate(&format!("views[{i}].camera"))?;
        Ok((camera, unsafe { get(row.field, &format!("views[{i}].field")) }?.rust()))
    };
    rows.iter().enumerate().map(view).collect()
}

/// The directions that particles take at `n_points` points, three floats each in metres, where no neighbour
/// pulls: by the fields of `n_views` views (none will do) and the way to the base. `params` may be NULL.
/// `directions` has room for `capacity` floats, three for each point: unit vectors, and 0 for points that are
/// not finite or too far off. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_way_directions(
    way: *const tree_way,
    views: *const tree_flow_view,
    n_views: usize,
    points: *const f32,
    n_points: usize,
    params: *const tree_flow_params,
    control: *const tree_control,
    directions: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let way = unsafe { get(way, "way") }?.rust();
        let views = unsafe { flow_views(views, n_views) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let forces = Forces::new(&views, way, &params);
        let answer = |point| finite(point, |point| forces.direction(point, None));
        let found = unsafe { ask(points, n_points, control, answer) }?;
        unsafe { fill_vectors(directions, capacity, &found, "directions") }
    })
}
