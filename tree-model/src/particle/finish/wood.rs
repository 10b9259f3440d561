//! Traces become branches: thinned, smoothed, and as thick as the pipe model has it.

use super::params::FinishParams;
use crate::error::Result;
use crate::particle::flow::Traces;
use crate::path::smooth::smooth;
use glam::Vec3;
use tree_core::{Control, NO_PARENT, Skeleton, SkeletonColumns};

/// The tree's branches without twigs. `height` is the tree's, `trunk_radius` what the images show of the trunk,
/// both in metres.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter), [`ModelError::Core`](crate::ModelError::Core),
/// [`ModelError::Limit`](crate::ModelError::Limit), [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(nodes × smoothing).
pub fn grow_wood(
    traces: &Traces,
    height: f32,
    trunk_radius: Option<f32>,
    params: &FinishParams,
    control: &Control,
) -> Result<Skeleton> {
    params.validate()?;
    let mut skeleton = thin(&traces.skeleton(control)?, params.spacing * height)?;
    smooth(&mut skeleton, params.smoothing, None, control)?;
    let mut radii = params.radii;
    let trunk = trunk_radius.unwrap_or(params.slenderness * height);
    radii.trunk_radius = radii.trunk_radius.or(Some(trunk));
    radii.apply(&mut skeleton)?;
    Ok(skeleton)
}

/// Leaves out nodes that are nearer than `spacing` to the node below: every join leaves one, and where many
/// join they crowd. Tips stay.
fn thin(skeleton: &Skeleton, spacing: f32) -> Result<Skeleton> {
    let children = skeleton.children();
    let old = skeleton.positions();
    let mut kept = vec![0_u32; skeleton.len()];
    let (mut positions, mut parents): (Vec<Vec3>, _) = (vec![old[0]], vec![NO_PARENT]);
    for (parent, node) in skeleton.segments() {
        let below = kept[parent as usize];
        let near = old[node as usize].distance(positions[below as usize]) < spacing;
        kept[node as usize] = if near && !children.is_tip(node) {
            below
        } else {
            positions.push(old[node as usize]);
            parents.push(below);
            positions.len() as u32 - 1
        };
    }
    let radii = vec![0.0; positions.len()];
    Ok(Skeleton::try_from(SkeletonColumns { positions, radii, parents })?)
}
