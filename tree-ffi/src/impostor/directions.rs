//! Directions to places on the square of an octahedral impostor and back, and the views around a direction.

use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, call, fill, floats, out_value, tree_status,
};
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};
use tree_lod::impostor::octahedral::{axes, decode, encode, frames};

/// Views along a side of the square: the least and the most.
const GRID: std::ops::RangeInclusive<u32> = 2..=64;

fn check_grid(grid: u32) -> Result<()> {
    if GRID.contains(&grid) {
        return Ok(());
    }
    let text = format!("grid is {grid}, it should be {} to {}", GRID.start(), GRID.end());
    Err(Failure::new(TREE_ERROR_PARAMETER, text))
}

/// Three floats that are a direction.
unsafe fn towards(direction: *const f32) -> Result<Vec3> {
    let found = Vec3::from_array(unsafe { floats(direction, "direction") }?);
    if found.is_finite() && found != Vec3::ZERO {
        return Ok(found);
    }
    let text = "direction should be finite and not zero";
    Err(Failure::new(TREE_ERROR_PARAMETER, text))
}

/// The place on the unit square of `direction`, three floats to the viewer, of any length. With `hemi`, directions below
/// the horizon are brought up to it. `TREE_ERROR_PARAMETER` for a direction that is zero or not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_encode(
    direction: *const f32,
    hemi: u32,
    place: *mut [f32; 2],
) -> tree_status {
    call(|| {
        let direction = unsafe { towards(direction) }?;
        unsafe { out_value(place, encode(direction, hemi != 0).to_array(), "place") }
    })
}

/// The unit direction of `place`, two floats on the unit square: the inverse of `tree_octahedral_encode`.
/// `TREE_ERROR_PARAMETER` for a place outside the square.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_decode(
    place: *const f32,
    hemi: u32,
    direction: *mut [f32; 3],
) -> tree_status {
    call(|| {
        let place = Vec2::from_array(unsafe { floats(place, "place") }?);
        if !place.to_array().iter().all(|v| (0.0..=1.0).contains(v)) {
            let text = format!("place is {place}, it should be 0 to 1");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        unsafe { out_value(direction, decode(place, hemi != 0).to_array(), "direction") }
    })
}

/// A view, and how much of it is seen.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct tree_octahedral_frame {
    /// Its column in the pictures.
    pub column: u32,
    /// Its row, from the top.
    pub row: u32,
    /// Its weight, 0 to 1.
    pub weight: f32,
}

/// Writes the three views around `direction`, three floats to the viewer, and their weights, which sum to 1 and change
/// continuously. `grid` and `hemi` are those of the impostor; `frames` has room for `capacity` views, at least 3.
/// `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64, or a direction that is zero or not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_frames(
    direction: *const f32,
    grid: u32,
    hemi: u32,
    frames: *mut tree_octahedral_frame,
    capacity: usize,
) -> tree_status {
    call(|| {
        check_grid(grid)?;
        let direction = unsafe { towards(direction) }?;
        let found = self::frames(direction, grid, hemi != 0)
            .map(|([column, row], weight)| tree_octahedral_frame { column, row, weight });
        unsafe { fill(frames, capacity, &found, "frames") }
    })
}

/// Where a view was taken from: unit vectors to the right of the picture, up it, and to the viewer. Up is as near to +Y
/// as it can be; seen from straight above or below, right is +X. `TREE_ERROR_PARAMETER` for a grid that is not 2 to 64,
/// or a column or row that it lacks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_axes(
    column: u32,
    row: u32,
    grid: u32,
    hemi: u32,
    right: *mut [f32; 3],
    up: *mut [f32; 3],
    toward: *mut [f32; 3],
) -> tree_status {
    call(|| {
        check_grid(grid)?;
        if column >= grid || row >= grid {
            let text = format!("there is no view ({column}, {row}) in a grid of {grid}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found = axes([column, row], grid, hemi != 0);
        unsafe { out_value(right, found[0].to_array(), "right") }?;
        unsafe { out_value(up, found[1].to_array(), "up") }?;
        unsafe { out_value(toward, found[2].to_array(), "toward") }
    })
}
