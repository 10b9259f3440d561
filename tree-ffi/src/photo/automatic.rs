//! A tree against sky, in one call.

use super::lines::tree_lines;
use super::matte::tree_matte;
use super::matting::tree_natural_params;
use super::picture::tree_photo;
use super::trimap::tree_trimap;
use crate::border::{
    Result, Versioned, call, foresee, get, init, out, out_opt, read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use tree_model::particle::matting::{AutomaticParams, AutomaticReport, automatic};

/// How a tree against sky is found. Begin with `tree_automatic_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_automatic_params {
    /// `sizeof(tree_automatic_params)`.
    pub struct_size: usize,
    /// How the alpha of the pixels left unknown is found. Default NULL: that of `tree_natural_params_init`.
    pub natural: *const tree_natural_params,
}

// SAFETY: repr(C), begins with its size, and holds pointers only.
unsafe impl Versioned for tree_automatic_params {
    const NAME: &'static str = "tree_automatic_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), natural: std::ptr::null() }
    }
}

impl tree_automatic_params {
    /// # Safety
    /// As [`read_or_default`], for the inner struct too.
    pub(crate) unsafe fn rust(&self) -> Result<AutomaticParams> {
        let natural = unsafe { read_or_default(self.natural, "params.natural") }?.rust();
        Ok(AutomaticParams { natural })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_automatic_params_init(
    params: *mut tree_automatic_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What was found in a photograph of a tree against sky.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_automatic_report {
    /// `sizeof(tree_automatic_report)`.
    pub struct_size: usize,
    /// Whether the photograph's own alpha was taken, 1 or 0.
    pub has_alpha: u32,
    /// Whether the place where the trunk meets the ground was found, 1 or 0.
    pub has_base: u32,
    /// That place, in pixels of the photograph from the top left.
    pub base: [f32; 2],
    /// How sure the result is, 0 to 1: below 0.5 look at it before you use it.
    pub confidence: f32,
    /// Width at which alpha was solved for, in pixels; 0 where the photograph has alpha.
    pub width: u32,
    /// Height at which alpha was solved for, in pixels.
    pub height: u32,
    /// Iterations at that size.
    pub iterations: u32,
    /// Pixels that the trimap leaves unknown, at that size.
    pub n_unknown: u64,
    /// Of them, pixels marked by their colour.
    pub n_marked: u64,
    /// What is left of the right side, as a share.
    pub residual: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_automatic_report {
    const NAME: &'static str = "tree_automatic_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&AutomaticReport::default())
    }
}

impl tree_automatic_report {
    pub(crate) fn of(report: &AutomaticReport) -> Self {
        let natural = &report.natural;
        Self {
            struct_size: size_of::<Self>(),
            has_alpha: report.has_alpha.into(),
            has_base: report.base.is_some().into(),
            base: report.base.map_or([0.0; 2], |base| base.to_array()),
            confidence: report.confidence,
            width: natural.size[0],
            height: natural.size[1],
            iterations: natural.iterations,
            n_unknown: natural.n_unknown,
            n_marked: natural.n_marked,
            residual: natural.residual,
            reserved: 0,
        }
    }
}

/// The matte of a photograph of a tree against sky; of one with alpha, its alpha. `params`, `control` and
/// `report` may be NULL. `trimap`, which may be NULL, gets the trimap that was made, at a size of its own: to
/// look at, or to draw over and hand to `tree_matte_natural`. It gets NULL where the photograph has alpha.
/// `warnings`, which may be NULL, gets lines on what the result may suffer from. Free them with
/// `tree_lines_free`, the trimap with `tree_trimap_free` and the matte with `tree_matte_free`.
/// `TREE_ERROR_NO_RESULT` when no sky or nothing that could be a tree is found.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_automatic(
    photo: *const tree_photo,
    params: *const tree_automatic_params,
    control: *const tree_control,
    report: *mut tree_automatic_report,
    trimap: *mut *mut tree_trimap,
    warnings: *mut *mut tree_lines,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let places = unsafe {
            (out_opt(trimap, "trimap"), out_opt(warnings, "warnings"), out(matte, "matte"))
        };
        let (trimap, warnings, place) = (places.0?, places.1?, places.2?);
        unsafe { foresee(report, "report") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust() }?;
        let body = |control: &_| Ok(automatic(photo, &params, control)?);
        let (made, told) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_automatic_report::of(&told)) }?;
        if let (Some(place), Some(found)) = (trimap, told.trimap) {
            place.put(tree_trimap::new(found));
        }
        if let Some(place) = warnings {
            place.put(tree_lines::new(told.warnings));
        }
        place.put(tree_matte::new(made));
        Ok(())
    })
}
