//! Main branches found in a photograph: seeds on the silhouette, and paths from there to the base.

use super::attractor::tree_attractor;
use super::matte::tree_matte;
use super::picture::tree_photo;
use super::{fill_some, vec2};
use crate::border::{
    Versioned, call, foresee, get, get_opt, init, out, out_value, read_or_default, tree_status,
    vec2s, view,
};
use crate::control::{limits, run, tree_control};
use tree_model::particle::attractor::{
    LivewireParams, LivewireReport, SeedParams, livewire, silhouette_seeds,
};
use tree_model::tree_core::{Resource, Seed};

/// How paths are found. Begin with `tree_livewire_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_livewire_params {
    /// `sizeof(tree_livewire_params)`.
    pub struct_size: usize,
    /// Rows of pixels over the height of the tree at which paths are sought, 16 to 1024. Default 256. Time
    /// and memory (120 bytes a pixel at most) grow with the square.
    pub rows: u32,
    /// How closely paths follow visible structures, 0 (not at all) to 0.98. Default 0.88: a step along the
    /// clearest branch costs 12 % of one through leaves.
    pub follow: f32,
    /// Cost of a step outside the tree, in steps inside, 1 to 100. Default 12.
    pub outside: f32,
    /// How much more a step at the silhouette costs than one in the middle, 0 to 10. Default 4.
    pub center: f32,
    /// How much more a step costs that leads back towards the base and down than one that leads away from
    /// it and up, 0 to 10. Default 0.6.
    pub outwards: f32,
    /// How much less than a step through leaves one costs along a path found before, 0 (paths do not
    /// attract each other) to 0.9. Default 0.3.
    pub join: f32,
    /// Passes of smoothing over paths of working pixels, 0 to 1000. Default 12.
    pub smoothing: u32,
    /// Distance between nodes as a share of the tree's height, 0.001 to 0.5. Default 0.02.
    pub spacing: f32,
    /// Side branches shorter than this share of the tree's height are left out, 0 to 0.5. Default 0.05.
    pub stub: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_livewire_params {
    const NAME: &'static str = "tree_livewire_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LivewireParams::default())
    }
}

impl tree_livewire_params {
    pub(crate) fn of(params: &LivewireParams) -> Self {
        let LivewireParams {
            rows,
            follow,
            outside,
            center,
            outwards,
            join,
            smoothing,
            spacing,
            stub,
        } = *params;
        Self {
            struct_size: size_of::<Self>(),
            rows,
            follow,
            outside,
            center,
            outwards,
            join,
            smoothing,
            spacing,
            stub,
            reserved: 0,
        }
    }

    pub(crate) fn rust(&self) -> LivewireParams {
        LivewireParams {
            rows: self.rows,
            follow: self.follow,
            outside: self.outside,
            center: self.center,
            outwards: self.outwards,
            join: self.join,
            smoothing: self.smoothing,
            spacing: self.spacing,
            stub: self.stub,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_livewire_params_init(
    params: *mut tree_livewire_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What livewire found.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_livewire_report {
    /// `sizeof(tree_livewire_report)`.
    pub struct_size: usize,
    /// Seeds that were not finite and left out.
    pub n_bad_seeds: u32,
    /// Seeds outside the picture, moved to its border.
    pub n_moved_seeds: u32,
    /// Side branches left out as stubs.
    pub n_stubs: u32,
    /// Tips of the graph.
    pub n_tips: u32,
    /// Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
    pub outside: f32,
    /// How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
    pub evidence: f32,
    /// Width of the trunk at its foot in pixels; 0 where no trunk is seen.
    pub trunk_width: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_livewire_report {
    const NAME: &'static str = "tree_livewire_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LivewireReport::default())
    }
}

impl tree_livewire_report {
    pub(crate) fn of(report: &LivewireReport) -> Self {
        let LivewireReport {
            n_bad_seeds,
            n_moved_seeds,
            n_stubs,
            n_tips,
            outside,
            evidence,
            trunk_width,
        } = *report;
        Self {
            struct_size: size_of::<Self>(),
            n_bad_seeds,
            n_moved_seeds,
            n_stubs,
            n_tips,
            outside,
            evidence,
            trunk_width,
            reserved: 0,
        }
    }
}

/// Finds paths from every seed to the base through what a photograph and its matte show, and joins them:
/// main branches as least-cost paths. `photo` may be NULL: then the matte alone is looked at. `base_pixel`
/// is two floats, `seeds` two floats each, in pixels from the top left: those of `tree_matte_seeds`, or
/// what a person clicked on. The root of the graph is at the base, its tips are at the seeds; without seeds the
/// graph is the base alone. `params`, `control` and `report` may be NULL. Free the graph with
/// `tree_attractor_free`. `TREE_ERROR_NO_RESULT` where the matte is empty, or the photograph is of another
/// size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_livewire(
    matte: *const tree_matte,
    photo: *const tree_photo,
    base_pixel: *const f32,
    seeds: *const f32,
    n_seeds: usize,
    params: *const tree_livewire_params,
    control: *const tree_control,
    report: *mut tree_livewire_report,
    attractor: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(attractor, "attractor") }?;
        unsafe { foresee(report, "report") }?;
        let matte = unsafe { get(matte, "matte") }?.rust();
        let photo = unsafe { get_opt(photo, "photo") }?.map(tree_photo::rust);
        let base = unsafe { vec2(base_pixel, "base_pixel") }?;
        let limits = unsafe { limits(control) }?;
        let seeds = unsafe { vec2s(seeds, n_seeds, &limits, Resource::Nodes, "seeds") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(livewire(matte, photo, base, seeds, &params, control)?);
        let (made, told) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_livewire_report::of(&told)) }?;
        place.put(tree_attractor::new(made));
        Ok(())
    })
}

/// Which points of the silhouette may be seeds. Begin with `tree_seed_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_seed_params {
    /// `sizeof(tree_seed_params)`.
    pub struct_size: usize,
    /// Distance that seeds keep from the trunk as a share of the tree's height, 0 to 1. Default 0.08.
    pub from_trunk: f32,
    /// Lowest height of a seed over the base as a share of the tree's height, -1 to 1. Default 0.05: what
    /// hangs lower is left out.
    pub lowest: f32,
    /// How far the silhouette may face down at a seed, 0 (aside) to 1 (straight down). Default 0.8.
    pub downwards: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_seed_params {
    const NAME: &'static str = "tree_seed_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SeedParams::default())
    }
}

impl tree_seed_params {
    pub(crate) fn of(params: &SeedParams) -> Self {
        let SeedParams { from_trunk, lowest, downwards } = *params;
        Self { struct_size: size_of::<Self>(), from_trunk, lowest, downwards, reserved: 0 }
    }

    pub(crate) fn rust(&self) -> SeedParams {
        let Self { from_trunk, lowest, downwards, .. } = *self;
        SeedParams { from_trunk, lowest, downwards }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_seed_params_init(
    params: *mut tree_seed_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Up to `most` points (100,000 at most) on the silhouette of the crown, evenly spread, other ones for every
/// `seed`: two floats each in pixels into `seeds`, and their number into `n_seeds`. `capacity`, in floats,
/// must be twice the number found or more: `2 * most` is enough. `base_pixel`, two floats, is the tree's base.
/// `params` and `control` may be NULL. `TREE_ERROR_NO_RESULT` where the matte is empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_seeds(
    matte: *const tree_matte,
    base_pixel: *const f32,
    most: u32,
    params: *const tree_seed_params,
    seed: u64,
    control: *const tree_control,
    seeds: *mut f32,
    capacity: usize,
    n_seeds: *mut usize,
) -> tree_status {
    call(|| {
        let matte = unsafe { get(matte, "matte") }?.rust();
        let base = unsafe { vec2(base_pixel, "base_pixel") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body =
            |control: &_| Ok(silhouette_seeds(matte, base, most, &params, Seed(seed), control)?);
        let found = unsafe { run(control, body) }?;
        unsafe { fill_some(seeds, capacity, bytemuck::cast_slice(&found), "seeds") }?;
        unsafe { out_value(n_seeds, found.len(), "n_seeds") }
    })
}
