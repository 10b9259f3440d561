//! Skeletons with one column replaced.

use super::tree_skeleton;
use crate::border::{Failure, Result, call, get, out, slice, tree_status};
use bytemuck::AnyBitPattern;
use glam::Vec3;
use tree_model::tree_core::{CoreError, Limits, Resource, Skeleton};

/// A caller's column with one row for each node of `skeleton`. The count is held against the skeleton
/// before anything is read, so there is no limit to ask for.
///
/// # Safety
/// As [`slice`].
pub(crate) unsafe fn column<'a, T: AnyBitPattern>(
    first: *const T,
    n: usize,
    skeleton: &Skeleton,
    field: &'static str,
) -> Result<&'a [T]> {
    if n != skeleton.len() {
        return Err(Failure::from(CoreError::Length { field, found: n, expected: skeleton.len() }));
    }
    let limits = Limits { nodes: u64::MAX, ..Limits::default() };
    unsafe { slice(first, n, &limits, Resource::Nodes, field) }
}

/// A new skeleton with other radii: `radii` has `n` floats, one for each node, in metres, 0 or more. Free
/// it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_with_radii(
    skeleton: *const tree_skeleton,
    radii: *const f32,
    n: usize,
    changed: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let radii = unsafe { column(radii, n, skeleton, "radii") }?.to_vec();
        let mut skeleton = skeleton.clone();
        skeleton.set_radii(radii)?;
        place.put(tree_skeleton::own(skeleton));
        Ok(())
    })
}

/// A new skeleton with its nodes elsewhere: `positions` has three floats for each of `n` nodes, in
/// metres. Free it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_with_positions(
    skeleton: *const tree_skeleton,
    positions: *const f32,
    n: usize,
    changed: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let positions: &[Vec3] = unsafe { column(positions.cast(), n, skeleton, "positions") }?;
        let mut skeleton = skeleton.clone();
        skeleton.set_positions(positions.to_vec())?;
        place.put(tree_skeleton::own(skeleton));
        Ok(())
    })
}
