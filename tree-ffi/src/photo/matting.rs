//! Separating a tree from what is behind it.

use super::lines::tree_lines;
use super::matte::tree_matte;
use super::picture::tree_photo;
use super::trimap::tree_trimap;
use crate::border::{
    Failure, Result, Versioned, call, foresee, get, init, out, out_opt, read_or_default,
    tree_status, view,
};
use crate::control::{run, tree_control};
use tree_model::particle::matting::{
    self, DifferenceParams, NaturalParams, NaturalReport, ScreenColor, ScreenParams,
};

/// How a matte is found with a trimap. Begin with `tree_natural_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_natural_params {
    /// `sizeof(tree_natural_params)`.
    pub struct_size: usize,
    /// Longer side in pixels at which alpha is solved for, 16 to 4096. Default 768. Cost and memory grow
    /// with its square.
    pub max_side: u32,
    /// How far alpha may depart from a linear function of colour within a window, 1e-9 to 1: a variance of
    /// colours 0 to 1. Low keeps fine structure, high is smooth. Default 1e-7.
    pub epsilon: f32,
    /// Share of the right side's size at which the solution is good enough, 1e-8 to 0.1. Default 2e-4.
    pub tolerance: f32,
    /// Most iterations at each size, 1 to 100,000. Default 400.
    pub max_iterations: u32,
    /// Whether unknown pixels that clearly look like the known ones of one side count as known. Default 1;
    /// helps strokes much, full trimaps a little.
    pub mark_clear: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_natural_params {
    const NAME: &'static str = "tree_natural_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let NaturalParams { max_side, epsilon, tolerance, max_iterations, mark_clear } =
            NaturalParams::default();
        Self {
            struct_size: size_of::<Self>(),
            max_side,
            epsilon,
            tolerance,
            max_iterations,
            mark_clear: mark_clear.into(),
            reserved: 0,
        }
    }
}

impl tree_natural_params {
    pub(crate) fn rust(&self) -> NaturalParams {
        NaturalParams {
            max_side: self.max_side,
            epsilon: self.epsilon,
            tolerance: self.tolerance,
            max_iterations: self.max_iterations,
            mark_clear: self.mark_clear != 0,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_natural_params_init(
    params: *mut tree_natural_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What matting with a trimap did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_natural_report {
    /// `sizeof(tree_natural_report)`.
    pub struct_size: usize,
    /// Pixels that the trimap leaves unknown, at the size at which alpha was solved for.
    pub n_unknown: u64,
    /// Of them, pixels marked by their colour.
    pub n_marked: u64,
    /// That size: width and height in pixels.
    pub size: [u32; 2],
    /// Iterations at that size; coarser ones cost little.
    pub iterations: u32,
    /// What is left of the right side, as a share.
    pub residual: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_natural_report {
    const NAME: &'static str = "tree_natural_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&NaturalReport::default())
    }
}

impl tree_natural_report {
    pub(crate) fn of(report: &NaturalReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_unknown: report.n_unknown,
            n_marked: report.n_marked,
            size: report.size,
            iterations: report.iterations,
            residual: report.residual,
        }
    }
}

/// The matte of a photograph of which a trimap is known, by closed-form matting. A trimap of another size is
/// sampled when its proportions agree within 2 %. Known pixels keep their alpha; an alpha channel of the
/// photograph is ignored. `params`, `control` and `report` may be NULL. `warnings`, which may be NULL, gets
/// lines on what the result may suffer from; free them with `tree_lines_free`, and the matte with
/// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the trimap does not fit, or knows no tree or no background.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_natural(
    photo: *const tree_photo,
    trimap: *const tree_trimap,
    params: *const tree_natural_params,
    control: *const tree_control,
    report: *mut tree_natural_report,
    warnings: *mut *mut tree_lines,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let (warnings, place) = unsafe { (out_opt(warnings, "warnings"), out(matte, "matte")) };
        let (warnings, place) = (warnings?, place?);
        unsafe { foresee(report, "report") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let trimap = unsafe { get(trimap, "trimap") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(matting::natural(photo, trimap, &params, control)?);
        let (made, told) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_natural_report::of(&told)) }?;
        if let Some(warnings) = warnings {
            warnings.put(tree_lines::new(told.warnings));
        }
        place.put(tree_matte::new(made));
        Ok(())
    })
}

/// Colour of the screen behind a tree: one of the `TREE_SCREEN_` constants.
pub type tree_screen_color = u32;

/// Blue: right for green leaves.
pub const TREE_SCREEN_BLUE: u32 = 0;
/// Green: for autumn leaves and bare branches.
pub const TREE_SCREEN_GREEN: u32 = 1;

/// How a screen is found. Begin with `tree_screen_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_screen_params {
    /// `sizeof(tree_screen_params)`.
    pub struct_size: usize,
    /// Colour of the screen. Default `TREE_SCREEN_BLUE`.
    pub color: tree_screen_color,
    /// How fast alpha falls with the surplus of the screen's colour, 0 to 100. 1 over the surplus of the bare
    /// screen makes that fully transparent. Default 2.
    pub gain: f32,
    /// How much of the screen's colour a pixel of the tree may hold for each part of the other one (green
    /// for blue, blue for green), 0 to 10. Default 1.
    pub balance: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_screen_params {
    const NAME: &'static str = "tree_screen_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let ScreenParams { color, gain, balance } = ScreenParams::default();
        let color = match color {
            ScreenColor::Blue => TREE_SCREEN_BLUE,
            ScreenColor::Green => TREE_SCREEN_GREEN,
        };
        Self { struct_size: size_of::<Self>(), color, gain, balance, reserved: 0 }
    }
}

impl tree_screen_params {
    fn rust(&self) -> Result<ScreenParams> {
        let color = match self.color {
            TREE_SCREEN_BLUE => ScreenColor::Blue,
            TREE_SCREEN_GREEN => ScreenColor::Green,
            other => return Err(Failure::not_one_of("params.color", other, "TREE_SCREEN_")),
        };
        Ok(ScreenParams { color, gain: self.gain, balance: self.balance })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_screen_params_init(
    params: *mut tree_screen_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// The matte of a photograph taken before a blue or green screen. Its own alpha is ignored. `params` and
/// `control` may be NULL. Free the matte with `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_screen(
    photo: *const tree_photo,
    params: *const tree_screen_params,
    control: *const tree_control,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        let body = |control: &_| Ok(matting::screen(photo, &params, control)?);
        place.put(tree_matte::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// How a tree is told from a picture without it. Begin with `tree_difference_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_difference_params {
    /// `sizeof(tree_difference_params)`.
    pub struct_size: usize,
    /// Difference of colours at which a pixel is half tree: distance in the RGB cube of side 1, 0 to 2.
    /// Default 0.15.
    pub threshold: f32,
    /// Width of the soft step around the threshold, 0 (hard) to 2. Default 0.15.
    pub softness: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_difference_params {
    const NAME: &'static str = "tree_difference_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let DifferenceParams { threshold, softness } = DifferenceParams::default();
        Self { struct_size: size_of::<Self>(), threshold, softness }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_difference_params_init(
    params: *mut tree_difference_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// The matte of a photograph of which `plate` shows the same view without the tree: the tree is where both
/// differ. Their own alpha is ignored. `params` and `control` may be NULL. Free the matte with
/// `tree_matte_free`. `TREE_ERROR_NO_RESULT` when the photographs differ in size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_difference(
    photo: *const tree_photo,
    plate: *const tree_photo,
    params: *const tree_difference_params,
    control: *const tree_control,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let plate = unsafe { get(plate, "plate") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let params = DifferenceParams { threshold: params.threshold, softness: params.softness };
        let body = |control: &_| Ok(matting::difference(photo, plate, &params, control)?);
        place.put(tree_matte::new(unsafe { run(control, body) }?));
        Ok(())
    })
}
