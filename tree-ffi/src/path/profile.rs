//! Volumes of revolution from drawings.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_TEXT, Versioned, bytes, call, free, get, init, out,
    read_or_default, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::volume::{tree_volume, vec3};
use std::ffi::c_char;
use tree_model::path::{Profile, ProfileOptions};

/// How a drawing becomes a profile. Begin with `tree_profile_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_profile_options {
    /// `sizeof(tree_profile_options)`.
    pub struct_size: usize,
    /// Height of the tree in metres, 0.01 to 10,000. Default 10.
    pub height: f32,
    /// Factor on all radii, 0.01 to 100. Default 1.
    pub widen: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_profile_options {
    const NAME: &'static str = "tree_profile_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let ProfileOptions { height, widen } = ProfileOptions::default();
        Self { struct_size: size_of::<Self>(), height, widen }
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_profile_options_init(
    options: *mut tree_profile_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

/// A drawn profile: radius over height, from the ground up.
pub struct tree_profile(Profile);

impl Handle for tree_profile {
    const NAME: &'static str = "tree_profile";
}

/// A view of a profile.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_profile_columns {
    /// `sizeof(tree_profile_columns)`.
    pub struct_size: usize,
    /// Number of points.
    pub n_points: usize,
    /// Two floats for each point, in metres: radius and height. `tree_volume_revolution` takes them.
    pub points: *const f32,
    /// Whether it was taken from a closed outline: 1 or 0.
    pub from_outline: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_profile_columns {
    const NAME: &'static str = "tree_profile_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            points: std::ptr::null(),
            from_outline: 0,
            reserved: 0,
        }
    }
}

unsafe fn read(
    svg: *const c_char,
    len: usize,
    options: *const tree_profile_options,
    control: *const tree_control,
) -> Result<Profile> {
    let limits = unsafe { limits(control) }?;
    let bytes = unsafe { bytes(svg.cast(), len, &limits, "svg") }?;
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        Failure::new(TREE_ERROR_TEXT, format!("svg is not UTF-8 from byte {at} on"))
    })?;
    let options = unsafe { read_or_default(options, "options") }?;
    let options = ProfileOptions { height: options.height, widen: options.widen };
    unsafe { run(control, |_| Ok(Profile::from_svg(text, &options)?)) }
}

/// Reads a profile from an SVG drawing, `svg` of `len` bytes or `TREE_NUL_TERMINATED`. A closed shape is
/// the outline of a tree: at every height half of its width becomes the radius. An open curve is a
/// profile: its distance from the axis becomes the radius; the axis is an element whose id is `axis`, or
/// else the vertical through the curve's leftmost point. `options` and `control` may be NULL. Free the
/// profile with `tree_profile_free`. `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing to use.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_profile_from_svg(
    svg: *const c_char,
    len: usize,
    options: *const tree_profile_options,
    control: *const tree_control,
    profile: *mut *mut tree_profile,
) -> tree_status {
    call(|| {
        let place = unsafe { out(profile, "profile") }?;
        place.put(tree_profile(unsafe { read(svg, len, options, control) }?));
        Ok(())
    })
}

/// Views a profile. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_profile_view(
    profile: *const tree_profile,
    columns: *mut tree_profile_columns,
) -> tree_status {
    call(|| {
        let profile = &unsafe { get(profile, "profile") }?.0;
        let value = tree_profile_columns {
            n_points: profile.points.len(),
            points: column(&profile.points).cast(),
            from_outline: profile.from_outline.into(),
            ..tree_profile_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// The solid of revolution of a profile round a vertical axis through `base`, three floats. Free it with
/// `tree_volume_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_profile_volume(
    profile: *const tree_profile,
    base: *const f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    call(|| {
        let place = unsafe { out(volume, "volume") }?;
        let profile = &unsafe { get(profile, "profile") }?.0;
        place.put(tree_volume::new(profile.volume(unsafe { vec3(base, "base") }?)?));
        Ok(())
    })
}

/// Frees a profile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_profile_free(profile: *mut tree_profile) -> tree_status {
    call(|| unsafe { free(profile, "profile") })
}

/// As `tree_profile_from_svg` and `tree_profile_volume` in one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_from_svg(
    svg: *const c_char,
    len: usize,
    options: *const tree_profile_options,
    base: *const f32,
    control: *const tree_control,
    volume: *mut *mut tree_volume,
) -> tree_status {
    call(|| {
        let place = unsafe { out(volume, "volume") }?;
        let base = unsafe { vec3(base, "base") }?;
        let profile = unsafe { read(svg, len, options, control) }?;
        place.put(tree_volume::new(profile.volume(base)?));
        Ok(())
    })
}
