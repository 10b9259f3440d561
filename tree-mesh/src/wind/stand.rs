//! Branches stand where the bark has them stand.
//!
//! By the skeleton a lateral turns about its fork. Its bark may leave the wall far from there: where it
//! runs beside its host at first, where it stands on a sibling, or was moved because its place was
//! taken. Turned about the fork it would tear off the rim of its hole. So it turns about the middle of
//! its host at the hole, and all up to its first ring moves with the host.

use super::{Branch, COLLAR_MAX, stiffness};
use crate::bark::{Kind, Plan};

/// Moves pivots and collars to where the plan has laterals leave their hosts.
///
/// # Complexity
/// O(branches).
pub(crate) fn stand(branches: &mut [Branch], plan: &Plan) {
    for number in 1..branches.len() {
        let Some(axis) = plan.axes.get(number) else { continue };
        let host = plan.rings(axis.host);
        let low = axis.hole_ring as usize;
        let (Some(below), Some(above), Some(first), Some(last)) = (
            host.get(low),
            host.get(low + 1),
            plan.rings(number as u32).first(),
            plan.rings(number as u32).last(),
        ) else {
            continue;
        };
        // Parents come first, in every engine: one that comes later carries nothing.
        if axis.kind != Kind::Lateral || axis.host as usize >= number {
            continue;
        }
        let branch = &mut branches[number];
        let pivot = below.station.position.midpoint(above.station.position);
        let out = first.station.position.distance(pivot);
        branch.length = out + last.station.along - first.station.along;
        branch.collar = (out + first.station.radius).min(COLLAR_MAX * branch.length);
        branch.axis = (last.station.position - pivot).normalize_or(branch.axis);
        branch.stiffness = stiffness(branch.length, branch.radius);
        (branch.parent, branch.pivot) = (axis.host, pivot);
    }
    // Whoever stands on another host now, and all it carries, has another level.
    for number in 1..branches.len() {
        let parent = branches[number].parent as usize;
        if parent < number {
            branches[number].level = branches[parent].level + 1;
        }
    }
}
