//! Columns in other axes.

use super::convention::{convention, tree_convention};
use crate::border::{Failure, Result, call, tree_status};
use crate::io::per_vertex;
use bytemuck::Pod;
use glam::{Vec2, Vec3, Vec4};
use tree_model::tree_core::{Limits, Resource};

/// Which way columns are converted: one of the `TREE_CONVERT_` constants.
pub type tree_convert = u32;

/// From our axes to theirs.
pub const TREE_CONVERT_TO: u32 = 0;
/// From their axes back to ours.
pub const TREE_CONVERT_BACK: u32 = 1;

fn is_back(way: tree_convert) -> Result<bool> {
    match way {
        TREE_CONVERT_TO => Ok(false),
        TREE_CONVERT_BACK => Ok(true),
        other => Err(Failure::not_one_of("way", other, "TREE_CONVERT_")),
    }
}

/// Converts row by row. By single reads and writes, since both arrays may be one.
///
/// # Safety
/// `from` and `to` are NULL or have `n` rows, and are the same or do not overlap.
unsafe fn rows<const N: usize, T: Pod>(
    from: *const T,
    n: usize,
    to: *mut T,
    convert: impl Fn([T; N]) -> [T; N],
) -> Result<()> {
    // No memory is taken: what is left of a budget does not matter.
    let limits = per_vertex(&Limits::default(), 1);
    limits.check(Resource::Triangles, n as u64)?;
    if n > 0 && from.is_null() {
        return Err(Failure::null("from"));
    }
    if n > 0 && to.is_null() {
        return Err(Failure::null("to"));
    }
    let (from, to) = (from.cast::<[T; N]>(), to.cast::<[T; N]>());
    for i in 0..n {
        // SAFETY: within both arrays, by contract.
        unsafe { to.add(i).write_unaligned(convert(from.add(i).read_unaligned())) };
    }
    Ok(())
}

/// Converts `n` places of three floats each, units included. `to` has room for as many and may be `from`
/// itself; otherwise the two must not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convert_positions(
    convention: tree_convention,
    way: tree_convert,
    from: *const f32,
    n: usize,
    to: *mut f32,
) -> tree_status {
    call(|| {
        let space = self::convention(convention, "convention")?;
        let back = is_back(way)?;
        let convert = |p| {
            let p = Vec3::from_array(p);
            if back { space.position_back(p) } else { space.position(p) }.to_array()
        };
        unsafe { rows(from, n, to, convert) }
    })
}

/// Converts `n` unit vectors (normals, axes) of three floats each. `to` is as in
/// `tree_convert_positions`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convert_directions(
    convention: tree_convention,
    way: tree_convert,
    from: *const f32,
    n: usize,
    to: *mut f32,
) -> tree_status {
    call(|| {
        let space = self::convention(convention, "convention")?;
        let back = is_back(way)?;
        let convert = |v| {
            let v = Vec3::from_array(v);
            if back { space.direction_back(v) } else { space.direction(v) }.to_array()
        };
        unsafe { rows(from, n, to, convert) }
    })
}

/// Converts `n` tangents of four floats each. Their w is turned so that `w * cross(normal, tangent)`,
/// with the arithmetic of their shaders, points the way green runs in their normal maps: up the picture,
/// but down in Unreal. `to` is as in `tree_convert_positions`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convert_tangents(
    convention: tree_convention,
    way: tree_convert,
    from: *const f32,
    n: usize,
    to: *mut f32,
) -> tree_status {
    call(|| {
        let space = self::convention(convention, "convention")?;
        let back = is_back(way)?;
        let convert = |t| {
            let t = Vec4::from_array(t);
            if back { space.tangent_back(t) } else { space.tangent(t) }.to_array()
        };
        unsafe { rows(from, n, to, convert) }
    })
}

/// Converts `n` texture coordinates of two floats each, to and back alike. `to` is as in
/// `tree_convert_positions`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convert_uvs(
    convention: tree_convention,
    from: *const f32,
    n: usize,
    to: *mut f32,
) -> tree_status {
    call(|| {
        let space = self::convention(convention, "convention")?;
        unsafe { rows(from, n, to, |uv| space.uv(Vec2::from_array(uv)).to_array()) }
    })
}

/// Turns `n_triangles` triangles of three indices each where front faces run clockwise, to and back
/// alike. `to` is as in `tree_convert_positions`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convert_triangles(
    convention: tree_convention,
    from: *const u32,
    n_triangles: usize,
    to: *mut u32,
) -> tree_status {
    call(|| {
        let space = self::convention(convention, "convention")?;
        unsafe { rows(from, n_triangles, to, |corners| space.triangle(corners)) }
    })
}
