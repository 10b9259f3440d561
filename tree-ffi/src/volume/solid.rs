//! A function for each plain solid.

use super::{hand_out, tree_volume, vec3};
use crate::border::{tree_status, vec2s, vec3s};
use crate::control::{limits, tree_control};
use tree_model::tree_core::{Resource, Volume};

/// Makes a ball. `center` is three floats; `radius` is above 0. As all that make volumes: metres,
/// `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` names what is out of range or not finite, and the
/// volume is freed with `tree_volume_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_sphere(
    center: *const f32,
    radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe { hand_out(volume, || Ok(Volume::sphere(vec3(center, "center")?, radius)?)) }
}

/// Makes an axis-aligned ellipsoid. `center` and `radii` are three floats each; `radii` are half its
/// extents, above 0. Turn it with `tree_volume_transformed`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_ellipsoid(
    center: *const f32,
    radii: *const f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || Ok(Volume::ellipsoid(vec3(center, "center")?, vec3(radii, "radii")?)?))
    }
}

/// Makes a round cylinder between the middles of its ends, `base` and `top`, three floats each, which
/// differ; `radius` is above 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_cylinder(
    base: *const f32,
    top: *const f32,
    radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || Ok(Volume::cylinder(vec3(base, "base")?, vec3(top, "top")?, radius)?))
    }
}

/// Makes a truncated cone between the middles of its ends, `base` and `top`, three floats each, which
/// differ. Radii are 0 or more, and one of them above 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_frustum(
    base: *const f32,
    top: *const f32,
    base_radius: f32,
    top_radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            let (base, top) = (vec3(base, "base")?, vec3(top, "top")?);
            Ok(Volume::frustum(base, top, base_radius, top_radius)?)
        })
    }
}

/// Makes the cone between a disc round `base` and a tip, `apex`, three floats each, which differ;
/// `base_radius` is above 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_cone(
    base: *const f32,
    apex: *const f32,
    base_radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            Ok(Volume::cone(vec3(base, "base")?, vec3(apex, "apex")?, base_radius)?)
        })
    }
}

/// Makes all points within `radius`, above 0, of the segment from `start` to `end`, three floats each; a
/// ball where both are the same.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_capsule(
    start: *const f32,
    end: *const f32,
    radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || Ok(Volume::capsule(vec3(start, "start")?, vec3(end, "end")?, radius)?))
    }
}

/// Makes an axis-aligned box. `min` and `max` are three floats each; `min` lies below `max` on every
/// axis.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_box(
    min: *const f32,
    max: *const f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe { hand_out(volume, || Ok(Volume::box_solid(vec3(min, "min")?, vec3(max, "max")?)?)) }
}

/// Makes all on the side of a plane through `point` that `normal` points away from; three floats each,
/// the normal of any length but 0. It has no end: to sample it, intersect it with a solid that has.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_half_space(
    point: *const f32,
    normal: *const f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || Ok(Volume::half_space(vec3(point, "point")?, vec3(normal, "normal")?)?))
    }
}

/// Makes the points within `radius`, above 0, of `apex` and within `angle` of `axis`: radians above 0, at
/// pi the whole ball. `apex` and `axis` are three floats each, the axis of any length but 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_sector(
    apex: *const f32,
    axis: *const f32,
    angle: f32,
    radius: f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            Ok(Volume::sector(vec3(apex, "apex")?, vec3(axis, "axis")?, angle, radius)?)
        })
    }
}

/// Makes what a profile sweeps when it turns about `axis`, which has any length but 0 and along which
/// heights are counted from `base`; three floats each. `profile` is `n_points` times two floats: distance
/// from the axis, 0 or more and not all 0, and height, not all the same. The line is closed to the axis by
/// a level line at both ends; heights may rise and fall. `control` may be NULL; only its limits matter
/// (`nodes` caps the points).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_revolution(
    base: *const f32,
    axis: *const f32,
    profile: *const f32,
    n_points: usize,
    control: *const tree_control,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            let (base, axis) = (vec3(base, "base")?, vec3(axis, "axis")?);
            let limits = limits(control)?;
            let profile = vec2s(profile, n_points, &limits, Resource::Nodes, "profile")?;
            Ok(Volume::revolution(base, axis, profile.to_vec())?)
        })
    }
}

/// Makes what a closed triangle mesh bounds. `positions` is `n_positions` times three floats; corners at
/// the same place count as one. `indices` is `n_triangles` times three. Along each edge as many triangles
/// run one way as the other; inside is where the winding number is not 0. `TREE_ERROR_PARAMETER` names an
/// open edge or an index that is too large. `control` may be NULL; only its limits matter (`triangles`
/// caps the triangles and the positions).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_closed_mesh(
    positions: *const f32,
    n_positions: usize,
    indices: *const u32,
    n_triangles: usize,
    control: *const tree_control,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            let limits = limits(control)?;
            let positions =
                vec3s(positions, n_positions, &limits, Resource::Triangles, "positions")?;
            let triangles: &[[u32; 3]] = crate::border::slice(
                indices.cast(),
                n_triangles,
                &limits,
                Resource::Triangles,
                "indices",
            )?;
            Ok(Volume::mesh(positions.to_vec(), triangles.to_vec())?)
        })
    }
}
