//! Base, height and scale of loosely taken photographs.

use super::camera::{fov, projection, tree_particle_camera};
use super::lines::tree_lines;
use super::matte::tree_matte;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_LIMIT, TREE_ERROR_PARAMETER, Versioned, call, foresee,
    free, get, init, out, out_value, read_or_default, read_rows, slice, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use bytemuck::AnyBitPattern;
use tree_model::particle::{
    self, AlignParams, AlignWarning, AlignedViews, Alignment, Camera, Matte,
};
use tree_model::tree_core::{Limits, Resource};

/// Most views of one tree.
const VIEWS_MAX: usize = 1000;

/// What is known about a photograph. Begin with `tree_align_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_align_params {
    /// `sizeof(tree_align_params)`.
    pub struct_size: usize,
    /// Height of the tree in metres, 0.01 to 1000. Default 10. `tree_align_all` takes its own.
    pub height: f32,
    /// See `tree_particle_camera`. Default 0.
    pub yaw: f32,
    /// See `tree_particle_camera`. Default 0.
    pub pitch: f32,
    /// See `tree_particle_camera`. Default 0: parallel projection.
    pub fov: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_align_params {
    const NAME: &'static str = "tree_align_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let AlignParams { height, yaw, pitch, projection } = AlignParams::default();
        Self { struct_size: size_of::<Self>(), height, yaw, pitch, fov: fov(projection) }
    }
}

impl tree_align_params {
    pub(crate) fn rust(&self) -> AlignParams {
        let Self { height, yaw, pitch, .. } = *self;
        AlignParams { height, yaw, pitch, projection: projection(self.fov) }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_align_params_init(
    params: *mut tree_align_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What may be wrong with an alignment: one of the `TREE_ALIGN_` constants.
pub type tree_align_problem = u32;

/// The foot is at the picture's bottom: the trunk may go on, and the tree be higher than it seems.
pub const TREE_ALIGN_BASE_CROPPED: u32 = 0;
/// The crown touches the picture's border: the tree may go on beyond it.
pub const TREE_ALIGN_CROWN_CROPPED: u32 = 1;
/// No bare trunk shows: the base is the lowest point near the middle.
pub const TREE_ALIGN_NO_TRUNK: u32 = 2;
/// `parts` parts apart from the tree are left out; `found` is their share of all that is covered.
pub const TREE_ALIGN_LEFT_OUT: u32 = 3;
/// The tree is in `parts` parts, as a crown in tufts is.
pub const TREE_ALIGN_PARTS: u32 = 4;
/// In `view` the crown begins at the share `found` of the tree's height, in the middle of all views at
/// `usual`.
pub const TREE_ALIGN_CROWN_BASE: u32 = 5;
/// In `view` the crown is `found` of the tree's height wide, in the middle of all views `usual`.
pub const TREE_ALIGN_CROWN_WIDTH: u32 = 6;
/// What this version of the interface has no name for.
pub const TREE_ALIGN_OTHER: u32 = 7;

/// What may be wrong with an alignment. Fields that the problem does not name are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, AnyBitPattern)]
pub struct tree_align_warning {
    /// Which problem. New ones may be added.
    pub problem: tree_align_problem,
    /// Index into the views.
    pub view: u32,
    /// Number of parts.
    pub parts: u32,
    /// A share, 0 to 1 or more.
    pub found: f32,
    /// What is found in most views.
    pub usual: f32,
}

impl tree_align_warning {
    pub(crate) fn of(warning: &AlignWarning) -> Self {
        let plain = |problem| Self { problem, ..Self::default() };
        let of_view = |problem, view: usize, found, usual| Self {
            problem,
            view: view as u32,
            parts: 0,
            found,
            usual,
        };
        match *warning {
            AlignWarning::BaseCropped => plain(TREE_ALIGN_BASE_CROPPED),
            AlignWarning::CrownCropped => plain(TREE_ALIGN_CROWN_CROPPED),
            AlignWarning::NoTrunk => plain(TREE_ALIGN_NO_TRUNK),
            AlignWarning::LeftOut { parts, share } => {
                Self { parts: parts as u32, found: share, ..plain(TREE_ALIGN_LEFT_OUT) }
            }
            AlignWarning::Parts(parts) => Self { parts: parts as u32, ..plain(TREE_ALIGN_PARTS) },
            AlignWarning::CrownBase { view, found, usual } => {
                of_view(TREE_ALIGN_CROWN_BASE, view, found, usual)
            }
            AlignWarning::CrownWidth { view, found, usual } => {
                of_view(TREE_ALIGN_CROWN_WIDTH, view, found, usual)
            }
            _ => plain(TREE_ALIGN_OTHER),
        }
    }

    fn text(&self, index: usize) -> Result<String> {
        let Self { found, usual, .. } = *self;
        let (view, parts) = (self.view as usize, self.parts as usize);
        let warning = match self.problem {
            TREE_ALIGN_BASE_CROPPED => AlignWarning::BaseCropped,
            TREE_ALIGN_CROWN_CROPPED => AlignWarning::CrownCropped,
            TREE_ALIGN_NO_TRUNK => AlignWarning::NoTrunk,
            TREE_ALIGN_LEFT_OUT => AlignWarning::LeftOut { parts, share: found },
            TREE_ALIGN_PARTS => AlignWarning::Parts(parts),
            TREE_ALIGN_CROWN_BASE => AlignWarning::CrownBase { view, found, usual },
            TREE_ALIGN_CROWN_WIDTH => AlignWarning::CrownWidth { view, found, usual },
            TREE_ALIGN_OTHER => return Ok("a problem that has no name here".to_owned()),
            other => {
                let name = format!("warnings[{index}].problem");
                return Err(Failure::not_one_of(&name, other, "TREE_ALIGN_"));
            }
        };
        Ok(warning.to_string())
    }
}

/// Warnings as lines of text, one for each of `n_warnings`. Free them with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_align_warnings_text(
    warnings: *const tree_align_warning,
    n_warnings: usize,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let limits = Limits::default();
        let rows = unsafe { slice(warnings, n_warnings, &limits, Resource::Nodes, "warnings") }?;
        let texts = rows.iter().enumerate().map(|(i, row)| row.text(i));
        place.put(tree_lines::new(texts.collect::<Result<_>>()?));
        Ok(())
    })
}

/// Rows for warnings in a report: more than one view can have.
pub const TREE_ALIGN_WARNINGS: usize = 8;

/// What was found in a matte. Lengths are in pixels from the top left.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_align_report {
    /// `sizeof(tree_align_report)`.
    pub struct_size: usize,
    /// The foot of the trunk.
    pub base: [f32; 2],
    /// The highest point of the tree.
    pub top: [f32; 2],
    /// Top left corner of the crown.
    pub crown_low: [f32; 2],
    /// Bottom right corner of the crown.
    pub crown_high: [f32; 2],
    /// The row where the crown begins: between it and the base the trunk is bare. The base's row where no
    /// bare trunk shows.
    pub crown_base: f32,
    /// Width of the bare trunk at about breast height (1.3 m); 0 where none shows.
    pub trunk_width: f32,
    /// Number of warnings.
    pub n_warnings: u32,
    /// What may be wrong; `tree_align_warnings_text` puts it into words.
    pub warnings: [tree_align_warning; TREE_ALIGN_WARNINGS],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_align_report {
    const NAME: &'static str = "tree_align_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            base: [0.0; 2],
            top: [0.0; 2],
            crown_low: [0.0; 2],
            crown_high: [0.0; 2],
            crown_base: 0.0,
            trunk_width: 0.0,
            n_warnings: 0,
            warnings: [Default::default(); TREE_ALIGN_WARNINGS],
            reserved: 0,
        }
    }
}

impl tree_align_report {
    pub(crate) fn of(found: &Alignment) -> Self {
        let mut report = Self {
            base: found.base.to_array(),
            top: found.top.to_array(),
            crown_low: found.crown.0.to_array(),
            crown_high: found.crown.1.to_array(),
            crown_base: found.crown_base,
            trunk_width: found.trunk_width.unwrap_or(0.0),
            n_warnings: found.warnings.len().min(TREE_ALIGN_WARNINGS) as u32,
            ..Self::default_value()
        };
        for (row, warning) in report.warnings.iter_mut().zip(&found.warnings) {
            *row = tree_align_warning::of(warning);
        }
        report
    }
}

/// Writes a camera, and a report where one is wanted.
unsafe fn tell(
    found: &(Camera, Alignment),
    camera: *mut tree_particle_camera,
    report: *mut tree_align_report,
) -> Result<()> {
    unsafe { foresee(report, "report") }?;
    unsafe { write(camera, "camera", &tree_particle_camera::of(&found.0)) }?;
    unsafe { view(report, "report", &tree_align_report::of(&found.1)) }
}

/// Finds the tree's base and top in a matte, and so its camera: a first arrangement, which says where it may
/// be wrong; a camera written by hand does as well. `params`, `control` and `report` may be NULL; set
/// `camera->struct_size` first. `TREE_ERROR_NO_RESULT` when nothing or everything is covered, the tree is
/// less than two rows high, or a camera of this pitch and field of view cannot see a tree so.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_align(
    matte: *const tree_matte,
    params: *const tree_align_params,
    control: *const tree_control,
    camera: *mut tree_particle_camera,
    report: *mut tree_align_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(camera, "camera") }?;
        unsafe { foresee(report, "report") }?;
        let matte = unsafe { get(matte, "matte") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let found = unsafe { run(control, |_| Ok(particle::align(matte, &params)?)) }?;
        unsafe { tell(&found, camera, report) }
    })
}

/// Cameras for several views of one tree.
pub struct tree_aligned {
    views: Vec<(Camera, Alignment)>,
    warnings: Vec<tree_align_warning>,
}

impl Handle for tree_aligned {
    const NAME: &'static str = "tree_aligned";
}

impl tree_aligned {
    fn new(found: AlignedViews) -> Self {
        let views = found.cameras.into_iter().zip(found.alignments).collect();
        Self { views, warnings: found.warnings.iter().map(tree_align_warning::of).collect() }
    }
}

/// Several views of one tree, made consistent: each gets the scale that makes its tree `height` metres high,
/// 0.01 to 1000, so that tops and bases coincide. `mattes` and `params` have one for each of `n_views`, 1 to
/// 1000; the heights in `params` are not used. `control` may be NULL. Free the result with
/// `tree_aligned_free`. Errors as for `tree_align`; the text names the view.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_align_all(
    mattes: *const *const tree_matte,
    params: *const tree_align_params,
    n_views: usize,
    height: f32,
    control: *const tree_control,
    aligned: *mut *mut tree_aligned,
) -> tree_status {
    call(|| {
        let place = unsafe { out(aligned, "aligned") }?;
        let mattes = unsafe { read_mattes(mattes, n_views) }?;
        let params: Vec<AlignParams> = unsafe { read_rows(params, n_views, VIEWS_MAX, "params") }?
            .iter()
            .map(tree_align_params::rust)
            .collect();
        let body = |_: &_| Ok(particle::align_all(&mattes, &params, height)?);
        place.put(tree_aligned::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

unsafe fn read_mattes<'a>(first: *const *const tree_matte, n: usize) -> Result<Vec<&'a Matte>> {
    if n > VIEWS_MAX {
        let text = format!("{n} views are given, at most {VIEWS_MAX} are allowed");
        return Err(Failure::new(TREE_ERROR_LIMIT, text));
    }
    if first.is_null() && n > 0 {
        return Err(Failure::null("mattes"));
    }
    (0..n)
        .map(|i| {
            // SAFETY: within the caller's array.
            let matte = unsafe { first.add(i).read_unaligned() };
            unsafe { get(matte, &format!("mattes[{i}]")) }.map(tree_matte::rust)
        })
        .collect()
}

/// The number of views.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_aligned_count(
    aligned: *const tree_aligned,
    n_views: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(aligned, "aligned") }?.views.len();
        unsafe { out_value(n_views, n, "n_views") }
    })
}

/// The camera of one view, and what was found there. `report` may be NULL; set `camera->struct_size` first.
/// `TREE_ERROR_PARAMETER` for an index that names no view.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_aligned_camera(
    aligned: *const tree_aligned,
    index: usize,
    camera: *mut tree_particle_camera,
    report: *mut tree_align_report,
) -> tree_status {
    call(|| {
        let views = &unsafe { get(aligned, "aligned") }?.views;
        let Some(found) = views.get(index) else {
            let text = format!("index is {index}, but there are {} views", views.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { tell(found, camera, report) }
    })
}

/// Views what disagrees between the views: where the warnings begin and how many there are.
/// `tree_align_warnings_text` puts them into words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_aligned_warnings(
    aligned: *const tree_aligned,
    warnings: *mut *const tree_align_warning,
    n_warnings: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(aligned, "aligned") }?.warnings;
        unsafe { out_value(warnings, column(found), "warnings") }?;
        unsafe { out_value(n_warnings, found.len(), "n_warnings") }
    })
}

/// Frees cameras of views.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_aligned_free(aligned: *mut tree_aligned) -> tree_status {
    call(|| unsafe { free(aligned, "aligned") })
}
