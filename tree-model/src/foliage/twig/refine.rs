//! Nodes for long segments, so that twigs find one near their place.

use crate::error::{Result, check};
use tree_core::{Control, NO_PARENT, Reordered, Resource, Skeleton, SkeletonColumns};

/// The same skeleton with nodes at most `spacing` metres apart on all segments that lie within
/// `bearing` metres of a tip. Nodes keep their order; [`Reordered::rows`] has for each node the old
/// node at its segment's upper end. Positions and radii between old nodes are linear.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for a spacing outside 1e-5 to 1e6 or a
/// bearing outside 0 to 1e6; [`ModelError::Limit`](crate::ModelError::Limit) before memory is taken;
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(old and new nodes).
pub fn refine(
    skeleton: &Skeleton,
    bearing: f32,
    spacing: f32,
    control: &Control,
) -> Result<Reordered> {
    check("spacing", spacing, 1e-5_f32, 1e6)?;
    check("bearing", bearing, 0.0, 1e6)?;
    let to_tip = skeleton.distances_to_tip();
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let pieces = |parent: u32, node: u32| {
        if to_tip[node as usize] >= bearing {
            return 1;
        }
        let [a, b] = [parent, node].map(|end| positions[end as usize].as_dvec3());
        // A cast from float saturates.
        ((a.distance(b) / f64::from(spacing)).ceil() as u64).max(1)
    };
    let n_nodes = skeleton.segments().fold(1_u64, |n, (a, b)| n.saturating_add(pieces(a, b)));
    control.limits.check(Resource::Nodes, n_nodes)?;
    let mut columns = SkeletonColumns {
        positions: vec![positions[0]],
        radii: vec![radii[0]],
        parents: vec![NO_PARENT],
    };
    let mut rows = vec![0];
    let mut new_of_old = vec![0_u32; skeleton.len()];
    for (parent, node) in skeleton.segments() {
        control.check()?;
        let (a, b) = (parent as usize, node as usize);
        let n = pieces(parent, node);
        let mut below = new_of_old[a];
        for i in 1..=n {
            let last = i == n;
            let share = i as f32 / n as f32;
            let between = radii[a] * (1.0 - share) + radii[b] * share;
            // Halves do not overflow where the difference of two positions would.
            let point = positions[a] * (1.0 - share) + positions[b] * share;
            columns.positions.push(if last { positions[b] } else { point });
            columns.radii.push(if last { radii[b] } else { between });
            columns.parents.push(below);
            rows.push(node);
            below = rows.len() as u32 - 1;
        }
        new_of_old[b] = below;
    }
    Ok(Reordered { skeleton: Skeleton::try_from(columns)?, rows })
}
