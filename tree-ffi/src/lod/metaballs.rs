//! The field that a hull is the surface of.

use super::elements::tree_elements;
use super::take::{ask, fill_points, fill_some, room_for};
use crate::border::{Handle, call, free, get, out, out_value, tree_status, vec3s};
use crate::control::{limits, run, tree_control};
use tree_lod::implicit::Metaballs;
use tree_model::tree_core::Resource;

/// A sum of metaballs (Neubert 2012, 7.3.1): every point adds `(1 - (distance / radius)^2)^2` to the places within
/// its radius. 1 or more at each point, 0 far from all.
pub struct tree_metaballs(Metaballs);

impl Handle for tree_metaballs {
    const NAME: &'static str = "tree_metaballs";
}

impl tree_metaballs {
    pub(super) fn rust(&self) -> &Metaballs {
        &self.0
    }
}

/// The field of `n_points` points, three floats each in metres, with `radius` metres of influence, 1e-9 to
/// 1e9. `control` may be NULL; `nodes` of its limits caps the points. Free it with `tree_metaballs_free`.
/// `TREE_ERROR_INVALID` when there are no points, `TREE_ERROR_PARAMETER` when a number is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_new(
    points: *const f32,
    n_points: usize,
    radius: f32,
    control: *const tree_control,
    metaballs: *mut *mut tree_metaballs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(metaballs, "metaballs") }?;
        let limits = unsafe { limits(control) }?;
        let points = unsafe { vec3s(points, n_points, &limits, Resource::Nodes, "points") }?;
        let made = unsafe { run(control, |_| Ok(Metaballs::new(points, radius)?)) }?;
        place.put(tree_metaballs(made));
        Ok(())
    })
}

/// The field of the centres of all elements that have area. `radius` is a share of `height`, the height of the
/// plant in metres; 0 for the height that `tree_elements_plant_height` measures. `control` may be NULL. Free it
/// with `tree_metaballs_free`. `TREE_ERROR_INVALID` when no element has area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_of_elements(
    elements: *const tree_elements,
    radius: f32,
    height: f32,
    control: *const tree_control,
    metaballs: *mut *mut tree_metaballs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(metaballs, "metaballs") }?;
        let elements = unsafe { get(elements, "elements") }?.rust();
        let body = |_: &_| Ok(Metaballs::of_elements(elements, radius, height)?);
        place.put(tree_metaballs(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Radius of influence in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_radius(
    metaballs: *const tree_metaballs,
    radius: *mut f32,
) -> tree_status {
    call(|| {
        let field = unsafe { get(metaballs, "metaballs") }?.rust();
        unsafe { out_value(radius, field.radius(), "radius") }
    })
}

/// Number of points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_count(
    metaballs: *const tree_metaballs,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let field = unsafe { get(metaballs, "metaballs") }?.rust();
        unsafe { out_value(n_points, field.len(), "n_points") }
    })
}

/// The box around the points: its lower corner, then its upper one, in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_bounds(
    metaballs: *const tree_metaballs,
    min_max: *mut [f32; 6],
) -> tree_status {
    call(|| {
        let bounds = unsafe { get(metaballs, "metaballs") }?.rust().bounds();
        let [a, b] = [bounds.min, bounds.max];
        unsafe { out_value(min_max, [a.x, a.y, a.z, b.x, b.y, b.z], "min_max") }
    })
}

/// The field at `n_points` points, three floats each in metres; 0 for a point that is not finite. `values` has
/// room for `capacity` numbers, at least `n_points`. `control` may be NULL; `nodes` of its limits caps the
/// points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_values(
    metaballs: *const tree_metaballs,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    values: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let field = unsafe { get(metaballs, "metaballs") }?.rust();
        room_for(n_points, capacity, "values")?;
        let found = unsafe { ask(points, n_points, control, |point| field.value(point)) }?;
        unsafe { fill_some(values, capacity, &found, "values") }
    })
}

/// Where the field grows fastest, and how fast per metre, three floats for each of the `n_points` points; zero
/// outside. `gradients` has room for `capacity` floats, at least `3 * n_points`. Else as `tree_metaballs_values`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_gradients(
    metaballs: *const tree_metaballs,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    gradients: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let field = unsafe { get(metaballs, "metaballs") }?.rust();
        room_for(n_points.saturating_mul(3), capacity, "gradients")?;
        let found = unsafe { ask(points, n_points, control, |point| field.gradient(point)) }?;
        unsafe { fill_points(gradients, capacity, &found, "gradients") }
    })
}

/// Frees a field. Hulls that were made of it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_metaballs_free(metaballs: *mut tree_metaballs) -> tree_status {
    call(|| unsafe { free(metaballs, "metaballs") })
}
