//! Smoothing: takes the zigzag from node to node out of branches, and leaves their course.
//!
//! The paper has no such step; its branches show the graph they were planned in.

use super::obstacle::Obstacle;
use crate::error::Result;
use glam::Vec3;
use tree_core::{Children, Control, Skeleton};

/// How far a node moves in one pass towards the middle between its neighbours.
const STEP: f32 = 0.5;

/// Moves every node but the root and the tips towards the middle between its parent and its
/// children, `passes` times. Children count by the size of their subtrees, so that a limb is not
/// drawn aside by its twigs. A move into the obstacle is not made.
pub(crate) fn smooth(
    skeleton: &mut Skeleton,
    passes: u32,
    obstacle: Option<&Obstacle>,
    control: &Control,
) -> Result<()> {
    let sizes = skeleton.subtree_sizes();
    let children = skeleton.children();
    let mut positions = skeleton.positions().to_vec();
    let mut next = positions.clone();
    for _ in 0..passes {
        control.check()?;
        for node in 1..positions.len() {
            let above = children.of(node as u32);
            if above.is_empty() {
                continue;
            }
            let mut sum = Vec3::ZERO;
            let mut weight = 0.0;
            for &child in above {
                // Squared, so that the leading child decides.
                let size = sizes[child as usize] as f32;
                sum += size * size * positions[child as usize];
                weight += size * size;
            }
            let below = positions[skeleton.parents()[node] as usize];
            let middle = 0.5 * (below + sum / weight);
            next[node] = positions[node].lerp(middle, STEP);
        }
        if let Some(obstacle) = obstacle {
            take_back(&mut next, &positions, skeleton, &children, obstacle);
        }
        positions.copy_from_slice(&next);
    }
    Ok(skeleton.set_positions(positions)?)
}

/// Takes back the moves of both ends of every segment that would pass through the obstacle, and
/// then looks again at the segments of the nodes moved back, until none does. It ends, because before
/// the pass none did, and is linear, because a node is moved back once.
fn take_back(
    next: &mut [Vec3],
    before: &[Vec3],
    skeleton: &Skeleton,
    children: &Children,
    obstacle: &Obstacle,
) {
    // Segments to look at, by the node at their upper end.
    let mut open: Vec<u32> = (1..skeleton.len() as u32).collect();
    while let Some(node) = open.pop() {
        let Some(parent) = skeleton.parent(node) else { continue };
        let ends = [parent, node].map(|end| end as usize);
        let moved = ends.iter().any(|&end| next[end] != before[end]);
        if !moved || obstacle.is_free(next[ends[0]], next[ends[1]]) {
            continue;
        }
        for end in ends {
            if next[end] != before[end] {
                next[end] = before[end];
                open.push(end as u32);
                open.extend_from_slice(children.of(end as u32));
            }
        }
    }
}
