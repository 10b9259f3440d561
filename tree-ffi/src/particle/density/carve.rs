//! From views to densities, in one go or stage by stage.

use super::params::{density_params, tree_density_params};
use super::report::{rows, tree_density_report, tree_density_view};
use crate::border::{
    Handle, Result, Versioned, call, fill, foresee, free, get, out, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::particle::grid::tree_grid;
use crate::particle::view::{tree_particle_view, views};
use tree_model::particle::density::{Carved, DensityReport, carve, solve};

/// The voxels that a tree may fill, and what they begin with.
pub struct tree_carved(Carved);

impl Handle for tree_carved {
    const NAME: &'static str = "tree_carved";
}

impl tree_carved {
    pub(super) fn rust(&self) -> &Carved {
        &self.0
    }
}

/// A view of what carving left.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_carved_columns {
    /// `sizeof(tree_carved_columns)`.
    pub struct_size: usize,
    /// Number of voxels that are left.
    pub n_voxels: usize,
    /// For each of them its row in the grid, rising.
    pub voxels: *const u32,
    /// For each of them how far it lies inside the rounded crown, 0 to 1.
    pub weights: *const f32,
    /// Voxels that were thrown away although a view shows them.
    pub n_carved: u64,
    /// Voxels that no picture shows.
    pub n_unseen: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_carved_columns {
    const NAME: &'static str = "tree_carved_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_voxels: 0,
            voxels: std::ptr::null(),
            weights: std::ptr::null(),
            n_carved: 0,
            n_unseen: 0,
        }
    }
}

/// The density of a tree from `n_views` views, at least one: optical depth per metre, such that looking
/// through the grid gives the mattes. It is `tree_carved_new` and `tree_carved_solve` in one.
///
/// `params`, `control` and `report` may be NULL. `rows`, NULL or with room for `capacity` rows (one for each
/// view), says how well each view fits. Free the grid with `tree_grid_free`. `TREE_ERROR_NO_RESULT` names a
/// view that shows no tree, is not of its camera's size, or leaves nothing of what the others see;
/// `TREE_ERROR_PARAMETER` what is out of range; `TREE_ERROR_LIMIT` comes before too many voxels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_from_views(
    views: *const tree_particle_view,
    n_views: usize,
    params: *const tree_density_params,
    control: *const tree_control,
    report: *mut tree_density_report,
    rows: *mut tree_density_view,
    capacity: usize,
    grid: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grid, "grid") }?;
        unsafe { foresee(report, "report") }?;
        let views = unsafe { self::views(views, n_views) }?;
        let params = unsafe { density_params(params) }?;
        let (grid, told) = unsafe {
            run(control, |control| {
                let carved = carve(&views, &params, control)?;
                Ok(solve(&carved, &views, &params, control)?)
            })
        }?;
        unsafe { tell(&told, report, rows, capacity) }?;
        place.put(tree_grid::new(grid));
        Ok(())
    })
}

unsafe fn tell(
    told: &DensityReport,
    report: *mut tree_density_report,
    rows: *mut tree_density_view,
    capacity: usize,
) -> Result<()> {
    if !rows.is_null() {
        unsafe { fill(rows, capacity, &self::rows(told), "rows") }?;
    }
    unsafe { view(report, "report", &tree_density_report::of(told)) }
}

/// The first stage of `tree_grid_from_views`: lays a grid of cubes around what the views see and throws away
/// those that a view shows to be empty. Arguments and errors are as there. Free it with `tree_carved_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_carved_new(
    views: *const tree_particle_view,
    n_views: usize,
    params: *const tree_density_params,
    control: *const tree_control,
    carved: *mut *mut tree_carved,
) -> tree_status {
    call(|| {
        let place = unsafe { out(carved, "carved") }?;
        let views = unsafe { self::views(views, n_views) }?;
        let params = unsafe { density_params(params) }?;
        let body = |control: &_| Ok(carve(&views, &params, control)?);
        place.put(tree_carved(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Views what carving left. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_carved_view(
    carved: *const tree_carved,
    columns: *mut tree_carved_columns,
) -> tree_status {
    call(|| {
        let carved = &unsafe { get(carved, "carved") }?.0;
        let value = tree_carved_columns {
            n_voxels: carved.voxels().len(),
            voxels: column(carved.voxels()),
            weights: column(carved.weights()),
            n_carved: carved.n_carved(),
            n_unseen: carved.n_unseen(),
            ..tree_carved_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// The grid of carving: in each voxel the least of the average mattes it projects to, 0 to 1; 0 where it was
/// thrown away. Free it with `tree_grid_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_carved_alpha(
    carved: *const tree_carved,
    grid: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grid, "grid") }?;
        let carved = &unsafe { get(carved, "carved") }?.0;
        place.put(tree_grid::new(carved.alpha().clone()));
        Ok(())
    })
}

/// The second stage of `tree_grid_from_views`: densities in the voxels that were left, for the views and
/// params that were carved. Arguments and errors are as there. Free the grid with `tree_grid_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_carved_solve(
    carved: *const tree_carved,
    views: *const tree_particle_view,
    n_views: usize,
    params: *const tree_density_params,
    control: *const tree_control,
    report: *mut tree_density_report,
    rows: *mut tree_density_view,
    capacity: usize,
    grid: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grid, "grid") }?;
        unsafe { foresee(report, "report") }?;
        let carved = &unsafe { get(carved, "carved") }?.0;
        let views = unsafe { self::views(views, n_views) }?;
        let params = unsafe { density_params(params) }?;
        let body = |control: &_| Ok(solve(carved, &views, &params, control)?);
        let (grid, told) = unsafe { run(control, body) }?;
        unsafe { tell(&told, report, rows, capacity) }?;
        place.put(tree_grid::new(grid));
        Ok(())
    })
}

/// Frees what carving left.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_carved_free(carved: *mut tree_carved) -> tree_status {
    call(|| unsafe { free(carved, "carved") })
}
