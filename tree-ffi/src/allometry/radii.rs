//! Radii of a whole skeleton by a rule.

use super::rule::tree_radius_rule;
use crate::border::{call, fill, get, out, read, read_or_default, tree_status};
use crate::skeleton::{column, tree_skeleton};

/// The radius of every node by a rule, in metres: `radii` has room for `capacity` floats, at least one
/// for each node. `rule` may be NULL for the default. The radii that are there do not matter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_radii(
    skeleton: *const tree_skeleton,
    rule: *const tree_radius_rule,
    radii: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let rule = unsafe { read_or_default(rule, "rule") }?.rust()?;
        unsafe { fill(radii, capacity, &rule.radii(skeleton)?, "radii") }
    })
}

/// A new skeleton with the radii that a rule gives, see `tree_skeleton_radii`. For radii of your own
/// there is `tree_skeleton_with_radii`. Free it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_with_rule(
    skeleton: *const tree_skeleton,
    rule: *const tree_radius_rule,
    changed: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let mut skeleton = unsafe { get(skeleton, "skeleton") }?.rust().clone();
        unsafe { read_or_default(rule, "rule") }?.rust()?.apply(&mut skeleton)?;
        place.put(tree_skeleton::own(skeleton));
        Ok(())
    })
}

/// The radius of every node by distance to the tip, in metres, with levels of your own in place of the
/// axes' orders: `levels` has `n_levels` numbers, one for each node, 0 for the trunk. Of `rule`, which
/// may be NULL for the default, the fields by distance to the tip count, whatever its kind is. `radii`
/// has room for `capacity` floats, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_radii_at_levels(
    skeleton: *const tree_skeleton,
    levels: *const u32,
    n_levels: usize,
    rule: *const tree_radius_rule,
    radii: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let levels = unsafe { column(levels, n_levels, skeleton, "levels") }?;
        let rule = unsafe { read_or_default(rule, "rule") }?.tip_distance();
        unsafe { fill(radii, capacity, &rule.radii_at_levels(skeleton, levels)?, "radii") }
    })
}

/// The number of strands through every node; at every fork the children's numbers add up to the
/// parent's. Of `rule`, which may be NULL for the default, the fields of strands count, whatever its kind
/// is. `strands` has room for `capacity` numbers, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_strands(
    skeleton: *const tree_skeleton,
    rule: *const tree_radius_rule,
    strands: *mut u64,
    capacity: usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let rule = unsafe { read_or_default(rule, "rule") }?.strands()?;
        unsafe { fill(strands, capacity, &rule.strands(skeleton)?, "strands") }
    })
}

/// Whether all fields of a rule are in order: `TREE_OK`, or the error that its use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_radius_rule_check(rule: *const tree_radius_rule) -> tree_status {
    call(|| Ok(unsafe { read(rule, "rule") }?.rust()?.validate()?))
}
