//! Looking through a density, measuring one, and drawing points from it.

use crate::border::{call, get, out, out_value, read, tree_status};
use crate::control::{User, limits, run, tree_control};
use crate::particle::grid::{fill_vectors, room_for, tree_grid};
use crate::photo::{tree_matte, tree_particle_camera};
use glam::Vec3;
use std::ffi::c_void;
use tree_model::particle::density::{crown_volume, look_through, overlap, sample_points};
use tree_model::tree_core::{Resource, Seed};

/// How much more points are wanted at `position`, three floats in metres, than the density says: 1 as much,
/// 0 none. Negative and not a number count as 0. Asked once for the centre of each voxel that is not empty,
/// from any thread and from several at a time; must give the same answer for the same place, and must not
/// unwind.
pub type tree_weight_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, position: *const f32) -> f32>;

/// The matte that a camera sees of a density: 1 - exp(-sum of density times length) along the ray of each
/// pixel. `control` may be NULL. Free the matte with `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_look_through(
    grid: *const tree_grid,
    camera: *const tree_particle_camera,
    control: *const tree_control,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        let grid = unsafe { get(grid, "grid") }?.rust();
        let camera = unsafe { read(camera, "camera") }?.rust();
        let body = |control: &_| Ok(look_through(grid, &camera, control)?);
        place.put(tree_matte::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Cubic metres of the voxels above `threshold` (per metre).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_crown_volume(
    grid: *const tree_grid,
    threshold: f32,
    measure: *mut f64,
) -> tree_status {
    call(|| {
        let found = crown_volume(unsafe { get(grid, "grid") }?.rust(), threshold);
        unsafe { out_value(measure, found, "measure") }
    })
}

/// How well the voxels above `threshold` agree with those of `other` above `other_threshold`: the shared
/// volume over that of both together, 0 to 1. 0 when both are empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_overlap(
    grid: *const tree_grid,
    threshold: f32,
    other: *const tree_grid,
    other_threshold: f32,
    measure: *mut f64,
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        let other = unsafe { get(other, "other") }?.rust();
        let found = overlap(grid, threshold, other, other_threshold);
        unsafe { out_value(measure, found, "measure") }
    })
}

/// Draws `n_points` points in proportion to the density times `weight`, spread evenly: where particles
/// start. `weight` may be NULL for 1 everywhere, and is handed `user`. The same `seed` gives the same points.
/// `control` may be NULL; `nodes` of its limits caps the points. `points` has room for `capacity` floats,
/// three for each point. `TREE_ERROR_PARAMETER` when the grid is empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_draw_points(
    grid: *const tree_grid,
    n_points: u32,
    weight: tree_weight_fn,
    user: *mut c_void,
    seed: u64,
    control: *const tree_control,
    points: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        unsafe { limits(control) }?.check(Resource::Nodes, n_points.into())?;
        room_for(3 * n_points as usize, capacity, "points")?;
        let user = User(user);
        let weight = move |point: Vec3| match weight {
            None => 1.0,
            Some(weight) => {
                let point = point.to_array();
                // SAFETY: the caller's function with the caller's pointer, as the header says.
                unsafe { weight(user.get(), point.as_ptr()) }
            }
        };
        let body = |control: &_| Ok(sample_points(grid, n_points, weight, Seed(seed), control)?);
        let drawn = unsafe { run(control, body) }?;
        let drawn: Vec<[f32; 3]> = drawn.iter().map(Vec3::to_array).collect();
        unsafe { fill_vectors(points, capacity, &drawn, "points") }
    })
}
