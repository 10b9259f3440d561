//! Branches stand where the bark has them stand.
//!
//! By the skeleton a lateral turns about its fork. Its bark may leave the wall far from there: where it
//! runs beside its host at first, where it stands on a sibling, or was moved because its place was
//! taken. Turned about the fork it would tear off the rim of its hole. So it turns about the middle of
//! its host at the hole, and all up to its first ring moves with the host.

use super::{Branch, COLLAR_MAX, stiffness};
use crate::bark::{Kind, Plan};
use crate::mesh::Surface;

/// Moves pivots and collars to where the plan has laterals leave their hosts. Where a host has a higher
/// number than what stands on it, branches are numbered anew, in the surfaces too: parents come first.
/// Returns the branch of each axis.
///
/// # Complexity
/// O(branches), and one pass over the vertices when numbers change.
pub(crate) fn stand(branches: &mut Vec<Branch>, surfaces: &mut [Surface], plan: &Plan) -> Vec<u32> {
    for (number, (branch, axis)) in branches.iter_mut().zip(&plan.axes).enumerate().skip(1) {
        let host = plan.rings(axis.host);
        let low = axis.hole_ring as usize;
        let (Kind::Lateral | Kind::Stub, Some(below), Some(above)) =
            (axis.kind, host.get(low), host.get(low + 1))
        else {
            continue;
        };
        let pivot = below.station.position.midpoint(above.station.position);
        (branch.parent, branch.pivot) = (axis.host, pivot);
        let Some(line) = plan.curves.get(number as u32) else { continue };
        let tip = line.at(line.length()).station;
        // A stub has no ring: all of it that shows is its tip.
        let first = plan.rings(number as u32).first().map_or(tip, |ring| ring.station);
        let out = first.position.distance(pivot);
        branch.length = out + tip.along - first.along;
        branch.collar = (out + first.radius).min(COLLAR_MAX * branch.length);
        branch.axis = (tip.position - pivot).normalize_or(branch.axis);
        branch.stiffness = stiffness(branch.length, branch.radius);
    }
    let late = |(number, branch): (usize, &Branch)| branch.parent as usize > number;
    let branch_of = if branches.iter().enumerate().any(late) {
        number_anew(branches, surfaces)
    } else {
        (0..branches.len() as u32).collect()
    };
    for number in 1..branches.len() {
        let parent = branches[number].parent as usize;
        branches[number].level = branches[parent].level + 1;
    }
    branch_of
}

/// Sorts branches so that parents come first, and else as they were.
fn number_anew(branches: &mut Vec<Branch>, surfaces: &mut [Surface]) -> Vec<u32> {
    let mut number_of = vec![u32::MAX; branches.len()];
    let mut order: Vec<u32> = Vec::with_capacity(branches.len());
    let mut open = Vec::new();
    for branch in 0..branches.len() as u32 {
        open.push(branch);
        while let Some(&last) = open.last() {
            let parent = branches[last as usize].parent;
            let ready = parent == last || number_of[parent as usize] != u32::MAX;
            // A ring of hosts cannot be; if it were, it is cut where it was entered.
            if !ready && open.len() <= branches.len() {
                open.push(parent);
                continue;
            }
            if number_of[last as usize] == u32::MAX {
                number_of[last as usize] = order.len() as u32;
                order.push(last);
            }
            open.pop();
        }
    }
    *branches = order
        .iter()
        .map(|&old| {
            let branch = branches[old as usize];
            Branch { parent: number_of[branch.parent as usize], ..branch }
        })
        .collect();
    for branch in surfaces.iter_mut().flat_map(|surface| &mut surface.branches) {
        *branch = number_of[*branch as usize];
    }
    number_of
}
