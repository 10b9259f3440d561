//! The equations behind a density, for solvers of a program's own.

use super::carve::tree_carved;
use super::params::{density_params, tree_density_params};
use crate::border::{Handle, Versioned, call, free, get, out, tree_status, write};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::particle::view::{tree_particle_view, views};
use tree_model::particle::density::Equations;

/// The equations A x = b of a density: for each ray the densities x of the voxels on it, times its length in
/// them in metres, add up to -ln of the transparency seen. Wanted is the x >= 0 with the least
/// |A x - b|^2 + lambda^2 |x / weights|^2.
pub struct tree_equations {
    starts: Vec<u64>,
    voxels: Vec<u32>,
    lengths: Vec<f32>,
    targets: Vec<f32>,
    weights: Vec<f32>,
    lambda: f32,
}

impl tree_equations {
    fn new(system: &Equations) -> Self {
        let n = system.n_entries();
        let (mut voxels, mut lengths) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let mut starts = vec![0];
        for ray in 0..system.n_rays() {
            let (met, long) = system.row(ray);
            voxels.extend_from_slice(met);
            lengths.extend_from_slice(long);
            starts.push(voxels.len() as u64);
        }
        let (targets, weights) = (system.targets().to_vec(), system.weights().to_vec());
        Self { starts, voxels, lengths, targets, weights, lambda: system.lambda() }
    }
}

impl Handle for tree_equations {
    const NAME: &'static str = "tree_equations";
}

/// A view of equations. The entries of ray `i` are rows `starts[i]` up to, but not including,
/// `starts[i + 1]`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_equations_columns {
    /// `sizeof(tree_equations_columns)`.
    pub struct_size: usize,
    /// Number of rays: rows of A.
    pub n_rays: usize,
    /// `n_rays + 1` numbers, 0 first and `n_entries` last.
    pub starts: *const u64,
    /// For each ray what is seen along it: b.
    pub targets: *const f32,
    /// Number of voxels: columns of A, in the order of `tree_carved_view`.
    pub n_voxels: usize,
    /// For each voxel how far it lies inside the rounded crown, above 0 to 1.
    pub weights: *const f32,
    /// Number of entries of A that are not zero.
    pub n_entries: usize,
    /// For each entry the voxel that the ray meets.
    pub voxels: *const u32,
    /// For each entry the ray's length in it, in metres.
    pub lengths: *const f32,
    /// Weight of the demand that densities are small and even, in metres.
    pub lambda: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_equations_columns {
    const NAME: &'static str = "tree_equations_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_rays: 0,
            starts: std::ptr::null(),
            targets: std::ptr::null(),
            n_voxels: 0,
            weights: std::ptr::null(),
            n_entries: 0,
            voxels: std::ptr::null(),
            lengths: std::ptr::null(),
            lambda: 0.0,
            reserved: 0,
        }
    }
}

/// Sets up the equations that `tree_carved_solve` solves, for the views and params that were carved. Arguments
/// and errors are as there; `TREE_ERROR_LIMIT` too when there are more entries than the limit on voxels allows.
/// Free them with `tree_equations_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_equations_new(
    carved: *const tree_carved,
    views: *const tree_particle_view,
    n_views: usize,
    params: *const tree_density_params,
    control: *const tree_control,
    equations: *mut *mut tree_equations,
) -> tree_status {
    call(|| {
        let place = unsafe { out(equations, "equations") }?;
        let carved = unsafe { get(carved, "carved") }?.rust();
        let views = unsafe { self::views(views, n_views) }?;
        let params = unsafe { density_params(params) }?;
        let body = |control: &_| {
            Ok(tree_equations::new(&Equations::new(carved, &views, &params, control)?))
        };
        place.put(unsafe { run(control, body) }?);
        Ok(())
    })
}

/// Views equations. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_equations_view(
    equations: *const tree_equations,
    columns: *mut tree_equations_columns,
) -> tree_status {
    call(|| {
        let found = unsafe { get(equations, "equations") }?;
        let value = tree_equations_columns {
            n_rays: found.targets.len(),
            starts: column(&found.starts),
            targets: column(&found.targets),
            n_voxels: found.weights.len(),
            weights: column(&found.weights),
            n_entries: found.voxels.len(),
            voxels: column(&found.voxels),
            lengths: column(&found.lengths),
            lambda: found.lambda,
            ..tree_equations_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees equations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_equations_free(equations: *mut tree_equations) -> tree_status {
    call(|| unsafe { free(equations, "equations") })
}
