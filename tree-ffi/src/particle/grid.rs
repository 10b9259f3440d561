//! Grids of numbers.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_BUFFER, TREE_ERROR_INVALID, Versioned, call, fill, free,
    get, out, out_value, slice, tree_status, vec3s, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::volume::vec3;
use glam::{IVec3, UVec3, Vec3};
use std::sync::Arc;
use tree_model::particle::Grid;
use tree_model::tree_core::{Control, Resource};

/// Points that are looked up between looks at the control.
const CHUNK: usize = 1 << 14;

/// Numbers on a regular grid of cubic voxels. The number of a voxel is that at its centre. Densities are
/// optical depth per metre: looking through d metres of density x shows a matte of 1 - exp(-x d).
pub struct tree_grid(Arc<Grid>);

impl Handle for tree_grid {
    const NAME: &'static str = "tree_grid";
}

impl tree_grid {
    pub(super) fn new(grid: Grid) -> Self {
        Self(Arc::new(grid))
    }

    pub(super) fn rust(&self) -> &Grid {
        &self.0
    }
}

/// A view of a grid. Voxel (x, y, z) is row `(z * size[1] + y) * size[0] + x`; its centre is
/// `corner + voxel * (x + 0.5, y + 0.5, z + 0.5)`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_grid_columns {
    /// `sizeof(tree_grid_columns)`.
    pub struct_size: usize,
    /// One for each voxel: x runs fastest, then y, then z.
    pub values: *const f32,
    /// Number of voxels: `size[0] * size[1] * size[2]`.
    pub n_values: usize,
    /// Lowest corner in metres.
    pub corner: [f32; 3],
    /// Side of a voxel in metres.
    pub voxel: f32,
    /// Voxels along x, y and z.
    pub size: [u32; 3],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_grid_columns {
    const NAME: &'static str = "tree_grid_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            values: std::ptr::null(),
            n_values: 0,
            corner: [0.0; 3],
            voxel: 0.0,
            size: [0; 3],
            reserved: 0,
        }
    }
}

/// Makes a grid with its lowest corner at `corner`, three floats, of `nx` by `ny` by `nz` voxels (1 to 4096
/// each) with sides of `voxel` metres (1e-6 to 1e6). `values` are copied, in the order of
/// `tree_grid_columns`; without any (`n_values` 0) all are 0. `control` may be NULL; only its limits matter.
/// Free the grid with `tree_grid_free`. `TREE_ERROR_INVALID` when there are not as many values as voxels,
/// `TREE_ERROR_PARAMETER` names a value that is not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_new(
    corner: *const f32,
    voxel: f32,
    nx: u32,
    ny: u32,
    nz: u32,
    values: *const f32,
    n_values: usize,
    control: *const tree_control,
    grid: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grid, "grid") }?;
        let limits = unsafe { limits(control) }?;
        let corner = unsafe { vec3(corner, "corner") }?;
        let values = unsafe { slice(values, n_values, &limits, Resource::Voxels, "values") }?;
        let mut grid = Grid::new(corner, voxel, UVec3::new(nx, ny, nz), &limits)?;
        if !values.is_empty() {
            copy_values(&mut grid, values)?;
        }
        place.put(tree_grid::new(grid));
        Ok(())
    })
}

fn copy_values(grid: &mut Grid, values: &[f32]) -> Result<()> {
    let (found, needed) = (values.len(), grid.values().len());
    if found != needed {
        let text = format!("n_values is {found}, but the grid has {needed} voxels");
        return Err(Failure::new(TREE_ERROR_INVALID, text));
    }
    if let Some(at) = values.iter().position(|value| !value.is_finite()) {
        let text = format!("values[{at}] is not finite");
        return Err(Failure::new(crate::border::TREE_ERROR_PARAMETER, text));
    }
    grid.values_mut().copy_from_slice(values);
    Ok(())
}

/// Views a grid. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_view(
    grid: *const tree_grid,
    columns: *mut tree_grid_columns,
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        let value = tree_grid_columns {
            values: column(grid.values()),
            n_values: grid.values().len(),
            corner: grid.corner().to_array(),
            voxel: grid.voxel(),
            size: grid.size().to_array(),
            ..tree_grid_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// The box that the grid fills: its lower corner, then its upper one, in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_bounds(
    grid: *const tree_grid,
    min_max: *mut [f32; 6],
) -> tree_status {
    call(|| {
        let bounds = unsafe { get(grid, "grid") }?.rust().bounds();
        let [a, b] = [bounds.min, bounds.max];
        unsafe { out_value(min_max, [a.x, a.y, a.z, b.x, b.y, b.z], "min_max") }
    })
}

/// Row of a voxel among the grid's values; `SIZE_MAX` outside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_index(
    grid: *const tree_grid,
    x: i32,
    y: i32,
    z: i32,
    index: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(grid, "grid") }?.rust().index(IVec3::new(x, y, z));
        unsafe { out_value(index, found.unwrap_or(usize::MAX), "index") }
    })
}

/// The voxel that holds a point, three floats in metres; outside the grid it is none of its voxels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_voxel_at(
    grid: *const tree_grid,
    point: *const f32,
    voxel: *mut [i32; 3],
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        let found = grid.voxel_at(unsafe { vec3(point, "point") }?);
        unsafe { out_value(voxel, found.to_array(), "voxel") }
    })
}

/// Looks up the grid at `n_points` points, three floats each in metres: between voxel centres by trilinear
/// interpolation, fading to 0 outside. `values` has room for `capacity` numbers, at least `n_points`.
/// `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_sample(
    grid: *const tree_grid,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    values: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        let found = unsafe { ask(points, n_points, control, |point| grid.sample(point)) }?;
        unsafe { fill_some(values, capacity, &found, "values") }
    })
}

/// As `tree_grid_sample`, but the value of the voxel that holds each point, and 0 outside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_nearest(
    grid: *const tree_grid,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    values: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let grid = unsafe { get(grid, "grid") }?.rust();
        let nearest = |point: Vec3| if point.is_finite() { grid.nearest(point) } else { 0.0 };
        let found = unsafe { ask(points, n_points, control, nearest) }?;
        unsafe { fill_some(values, capacity, &found, "values") }
    })
}

/// Frees a grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_free(grid: *mut tree_grid) -> tree_status {
    call(|| unsafe { free(grid, "grid") })
}

/// What `answer` says of each point, three floats.
pub(super) unsafe fn ask<R: Send>(
    points: *const f32,
    n: usize,
    control: *const tree_control,
    answer: impl Fn(Vec3) -> R + Send,
) -> Result<Vec<R>> {
    let limits = unsafe { limits(control) }?;
    let points = unsafe { vec3s(points, n, &limits, Resource::Nodes, "points") }?;
    let body = move |control: &Control| {
        let mut answers = Vec::with_capacity(points.len());
        for chunk in points.chunks(CHUNK) {
            control.check()?;
            answers.extend(chunk.iter().map(|&point| answer(point)));
        }
        Ok(answers)
    };
    unsafe { run(control, body) }
}

/// Looks at a buffer before the work whose result goes there, so that no work is done in vain.
pub(super) fn room_for(needed: usize, capacity: usize, argument: &str) -> Result<()> {
    if needed <= capacity {
        return Ok(());
    }
    let text = format!("{argument} has room for {capacity} values, {needed} are needed");
    Err(Failure::new(TREE_ERROR_BUFFER, text))
}

/// As [`fill`]; for no values there need be no buffer.
pub(super) unsafe fn fill_some<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if values.is_empty() {
        return Ok(());
    }
    unsafe { fill(first, capacity, values, argument) }
}

/// Vectors, as many floats each as they have axes: a buffer of floats whose capacity counts floats.
pub(super) unsafe fn fill_vectors<const N: usize>(
    first: *mut f32,
    capacity: usize,
    values: &[[f32; N]],
    argument: &str,
) -> Result<()> {
    unsafe { fill_some(first, capacity, values.as_flattened(), argument) }
}
