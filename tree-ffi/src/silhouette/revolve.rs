//! The surface between outlines, turned round an axis.

use super::line::line_of;
use super::measure::rays;
use super::tree_outline;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_NO_RESULT, TREE_ERROR_PARAMETER, Versioned, call, fill,
    free, get, out, out_value, slice, tree_status, vec3s, write,
};
use crate::control::{limits, run, tree_control};
use crate::sketch::{answers, fill_some, spots};
use glam::Vec2;
use tree_model::silhouette::place::revolve::{Revolved, Section};
use tree_model::tree_core::{Limits, Resource};

/// Most sections of one surface.
const SECTIONS_MAX: u64 = 1000;

/// A closed surface round an axis, through outlines in planes through it: how far a branch reaches at any azimuth. Its frame
/// has y along the straight span of the axis from its start, and r across.
pub struct tree_revolved(Revolved);

impl Handle for tree_revolved {
    const NAME: &'static str = "tree_revolved";
}

/// Makes the surface through `n_sections` outlines, 1 to 1000, round an axis of `n_axis` points, two floats each, which is drawn in the
/// plane of azimuth 0. Outline `i` is what is seen in a plane turned about the vertical to `azimuths[i]` radians: 0 for the
/// drawing, π/2 for one seen from its right side; metres, x to that plane's right, y up, the tree's base at the origin.
/// Between their halves the surface is blended. `control` may be NULL; `nodes` of the limits caps the points of the axis.
/// Free the surface with `tree_revolved_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_of(
    axis: *const f32,
    n_axis: usize,
    outlines: *const *const tree_outline,
    azimuths: *const f32,
    n_sections: usize,
    control: *const tree_control,
    revolved: *mut *mut tree_revolved,
) -> tree_status {
    call(|| {
        let place = unsafe { out(revolved, "revolved") }?;
        let axis = unsafe { line_of(axis, n_axis, control, "axis") }?;
        let limits = Limits { nodes: SECTIONS_MAX, ..Limits::default() };
        let (n, nodes) = (n_sections, Resource::Nodes);
        let azimuths: &[f32] = unsafe { slice(azimuths, n, &limits, nodes, "azimuths") }?;
        if outlines.is_null() {
            return Err(Failure::null("outlines"));
        }
        let section = |(i, &azimuth): (usize, &f32)| {
            // SAFETY: within the caller's array.
            let outline = unsafe { outlines.add(i).read_unaligned() };
            let outline = unsafe { get(outline, &format!("outlines[{i}]")) }?.rust();
            check_azimuth(azimuth, &format!("azimuths[{i}]"))?;
            Ok(Section { azimuth, outline })
        };
        let sections: Vec<Section<'_>> =
            azimuths.iter().enumerate().map(section).collect::<Result<_>>()?;
        if sections.is_empty() {
            let text = "n_sections is 0: a surface needs one outline at least";
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let body = |_: &_| Ok(Revolved::of(&axis, &sections));
        place.put(tree_revolved(unsafe { run(control, body) }?));
        Ok(())
    })
}

fn check_azimuth(azimuth: f32, argument: &str) -> Result<()> {
    if azimuth.is_finite() {
        return Ok(());
    }
    Err(Failure::new(TREE_ERROR_PARAMETER, format!("{argument} is {azimuth}, which is not finite")))
}

/// The frame of a surface.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_revolved_frame {
    /// `sizeof(tree_revolved_frame)`.
    pub struct_size: usize,
    /// Where it begins: the start of the axis, in the drawing.
    pub origin: [f32; 2],
    /// The unit vector along the span of the axis, in the drawing.
    pub up: [f32; 2],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_revolved_frame {
    const NAME: &'static str = "tree_revolved_frame";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), origin: [0.0; 2], up: [0.0; 2] }
    }
}

/// Tells the frame of a surface. Set `frame->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_view(
    revolved: *const tree_revolved,
    frame: *mut tree_revolved_frame,
) -> tree_status {
    call(|| {
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        let (origin, up) = (surface.origin().to_array(), surface.up().to_array());
        let found = tree_revolved_frame { origin, up, ..Versioned::default_value() };
        unsafe { write(frame, "frame", &found) }
    })
}

/// Brings `n_spots` points of the drawing, two floats each, into the frame of the axis: (r, y) each into `places`, which has
/// room for `capacity` floats. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_to_frame(
    revolved: *const tree_revolved,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    places: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| surface.to_frame(spot)) }?;
        unsafe { fill_some(places, capacity, bytemuck::cast_slice(&found), "places") }
    })
}

/// The half of the surface at an azimuth: points (r, y) in metres, from top to bottom, two floats each into `points`;
/// `capacity` counts floats. `n_points` gets their number; where `capacity` is too small, `TREE_ERROR_BUFFER` says how many floats
/// are needed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_half(
    revolved: *const tree_revolved,
    azimuth: f32,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        check_azimuth(azimuth, "azimuth")?;
        let found = surface.half(azimuth);
        unsafe { fill(points, capacity, bytemuck::cast_slice(&found), "points") }?;
        unsafe { out_value(n_points, found.len(), "n_points") }
    })
}

/// The outline of both halves at an azimuth and across from it, in (r, y). Free it with `tree_outline_free`.
/// `TREE_ERROR_NO_RESULT` where nothing is left of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_profile(
    revolved: *const tree_revolved,
    azimuth: f32,
    outline: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outline, "outline") }?;
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        check_azimuth(azimuth, "azimuth")?;
        let Some(found) = surface.profile(azimuth) else {
            let text = format!("the surface encloses nothing at the azimuth {azimuth}");
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        place.put(tree_outline::new(found));
        Ok(())
    })
}

/// How far it is along `n_rays` rays to the surface: each ray is four floats, its beginning (r, y) and its direction, of
/// unit length, in the half-plane of the azimuth in `azimuths`. `exits`, which has room for `capacity`, gets metres,
/// infinite from outside. A ray may lead across the axis. `control` may be NULL; `nodes` of its limits caps the rays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_exits(
    revolved: *const tree_revolved,
    rays: *const f32,
    azimuths: *const f32,
    n_rays: usize,
    control: *const tree_control,
    exits: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        let rays = unsafe { self::rays(rays, n_rays, control) }?;
        let nodes = Resource::Nodes;
        let azimuths: &[f32] =
            unsafe { slice(azimuths, n_rays, &limits(control)?, nodes, "azimuths") }?;
        let rows: Vec<([Vec2; 2], f32)> =
            rays.iter().copied().zip(azimuths.iter().copied()).collect();
        let exit = |&([from, way], azimuth): &([Vec2; 2], f32)| {
            surface.exit(from, way, azimuth).unwrap_or(f32::INFINITY)
        };
        let found = unsafe { answers(&rows, control, exit) }?;
        unsafe { fill_some(exits, capacity, &found, "exits") }
    })
}

/// Says of `n_points` points in the frame of the axis, three floats each (x to the right of the drawing, y along the span, z
/// towards azimuth π/2), whether they lie inside: 1 or 0 into `inside`, which has room for `capacity`. `control` may be
/// NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_contains(
    revolved: *const tree_revolved,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    inside: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let surface = &unsafe { get(revolved, "revolved") }?.0;
        let nodes = Resource::Nodes;
        let points = unsafe { vec3s(points, n_points, &limits(control)?, nodes, "points") }?;
        let found =
            unsafe { answers(points, control, |&point| u8::from(surface.contains(point))) }?;
        unsafe { fill_some(inside, capacity, &found, "inside") }
    })
}

/// Frees a surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_free(revolved: *mut tree_revolved) -> tree_status {
    call(|| unsafe { free(revolved, "revolved") })
}
