//! Volumes made of volumes.

use super::{hand_out, tree_volume};
use crate::border::{Failure, Result, TREE_ERROR_LIMIT, floats, get, tree_status};
use glam::Affine3A;
use tree_model::tree_core::Volume;
use tree_model::tree_core::volume::MAX_SOLIDS;

/// The volumes of an array of handles.
unsafe fn read_all(volumes: *const *const tree_volume, n: usize) -> Result<Vec<Volume>> {
    if n > MAX_SOLIDS as usize {
        let text = format!("volumes: {n} are given, at most {MAX_SOLIDS} are allowed");
        return Err(Failure::new(TREE_ERROR_LIMIT, text));
    }
    if n > 0 && volumes.is_null() {
        return Err(Failure::null("volumes"));
    }
    (0..n)
        .map(|i| {
            // SAFETY: within the caller's array.
            let volume = unsafe { volumes.add(i).read_unaligned() };
            Ok(unsafe { get(volume, &format!("volumes[{i}]")) }?.rust().clone())
        })
        .collect()
}

/// Makes what lies in any of `n_volumes` volumes, at least 1. As all that combine volumes: the volumes
/// may be freed afterwards; combinations nest at most 48 deep (a union of unions is no deeper than one)
/// and hold at most 1,048,576 solids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_union(
    volumes: *const *const tree_volume,
    n_volumes: usize,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe { hand_out(volume, || Ok(Volume::union_all(read_all(volumes, n_volumes)?)?)) }
}

/// Makes what lies in all of `n_volumes` volumes, at least 1. It may turn out empty, which is no error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_intersection(
    volumes: *const *const tree_volume,
    n_volumes: usize,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe { hand_out(volume, || Ok(Volume::intersection_all(read_all(volumes, n_volumes)?)?)) }
}

/// Makes what lies in `from` but not in `without`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_difference(
    from: *const tree_volume,
    without: *const tree_volume,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            Ok(get(from, "from")?.rust().difference(get(without, "without")?.rust())?)
        })
    }
}

/// Makes `source` moved, turned, scaled or sheared. `columns` is twelve floats, column by column: where
/// the X, Y and Z axes go, three floats each, and then where the origin goes. They must be finite and not
/// flatten the volume.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_transformed(
    source: *const tree_volume,
    columns: *const f32,
    volume: *mut *mut tree_volume,
) -> tree_status {
    unsafe {
        hand_out(volume, || {
            let map = Affine3A::from_cols_array(&floats(columns, "columns")?);
            Ok(get(source, "source")?.rust().transformed(map)?)
        })
    }
}
