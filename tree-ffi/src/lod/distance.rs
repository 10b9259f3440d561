//! Share of geometry for each distance.

use super::table::tree_lod_table;
use super::take::{few, fill_some};
use crate::border::{Failure, Result, TREE_ERROR_INVALID, call, get, out_value, tree_status};
use bytemuck::{Pod, Zeroable};
use tree_lod::quality::{Distance, MinimumQuality};

/// Samples of a `tree_lod_distance`.
pub const TREE_LOD_DISTANCE_SAMPLES: usize = 21;

/// Share of geometry for each distance: lambda, 0 to 1 and never rising, at the distances 0, 0.01, ... 0.1, 0.19,
/// ... 1 (0 is near and shows the full model, 1 is far), and linear in between.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct tree_lod_distance {
    /// Lambda at each of these 21 distances.
    pub lambdas: [f32; 21],
}

impl tree_lod_distance {
    pub(super) fn of(distance: &Distance) -> Self {
        Self { lambdas: *distance.samples() }
    }

    pub(super) fn rust(&self) -> Result<Distance> {
        Ok(Distance::from_samples(&self.lambdas)?)
    }

    /// One that a caller points at.
    pub(super) unsafe fn read(distance: *const Self, argument: &str) -> Result<Distance> {
        match unsafe { few(distance, 1, 1, argument) }? {
            [distance] => distance.rust(),
            _ => Err(Failure::null(argument)),
        }
    }
}

/// `(1 - d)^2` (Cook et al. 2007).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_cook(distance: *mut tree_lod_distance) -> tree_status {
    call(|| unsafe { out_value(distance, tree_lod_distance::of(&Distance::cook()), "distance") })
}

/// The least lambda of a measured model that is as good as asked for: a quality of `near` at distance 0, falling
/// linearly to `far` at distance 1; each 0 to 1, both the same for one that is asked for everywhere.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_for_quality(
    table: *const tree_lod_table,
    near: f32,
    far: f32,
    distance: *mut tree_lod_distance,
) -> tree_status {
    call(|| {
        let table = unsafe { get(table, "table") }?.rust();
        let found = Distance::for_quality(table, MinimumQuality::Falling(near, far))?;
        unsafe { out_value(distance, tree_lod_distance::of(&found), "distance") }
    })
}

/// The least lambda at which the model of `table` is as good as the one of `cook` is at `(1 - d)^2`: the same
/// pictures with less geometry. `cook` is measured with `tree_order_stochastic` and `TREE_LOD_SCALE_COOK`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_parity(
    table: *const tree_lod_table,
    cook: *const tree_lod_table,
    distance: *mut tree_lod_distance,
) -> tree_status {
    call(|| {
        let table = unsafe { get(table, "table") }?.rust();
        let cook = unsafe { get(cook, "cook") }?.rust();
        let found = Distance::parity(table, cook);
        unsafe { out_value(distance, tree_lod_distance::of(&found), "distance") }
    })
}

/// One of your own samples, at the distances of `tree_lod_distance_places`: `TREE_LOD_DISTANCE_SAMPLES` numbers,
/// each 0 to 1. A sample above the one before is lowered to it, for geometry must not grow with distance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_from_samples(
    lambdas: *const f32,
    n_lambdas: usize,
    distance: *mut tree_lod_distance,
) -> tree_status {
    call(|| {
        let lambdas = unsafe { few(lambdas, n_lambdas, TREE_LOD_DISTANCE_SAMPLES, "lambdas") }?;
        let Ok(lambdas) = lambdas.try_into() else {
            let text =
                format!("n_lambdas is {n_lambdas}, {TREE_LOD_DISTANCE_SAMPLES} samples are needed");
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        };
        let found = Distance::from_samples(lambdas)?;
        unsafe { out_value(distance, tree_lod_distance::of(&found), "distance") }
    })
}

/// Writes the distances that are sampled, `TREE_LOD_DISTANCE_SAMPLES` of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_places(
    places: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| unsafe { fill_some(places, capacity, &Distance::places(), "places") })
}

/// Lambda at a distance `d`, which is brought into 0 to 1; NaN is far. `TREE_ERROR_PARAMETER` when a sample is not
/// within 0 to 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_distance_lambda(
    distance: *const tree_lod_distance,
    d: f32,
    lambda: *mut f32,
) -> tree_status {
    call(|| {
        let distance = unsafe { tree_lod_distance::read(distance, "distance") }?;
        unsafe { out_value(lambda, distance.lambda(d), "lambda") }
    })
}
