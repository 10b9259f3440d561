//! Leaves on the youngest shoots of any skeleton, in the order that phyllotaxis gives them.
//!
//! 1. The skeleton is split into axes; of each, the part within [`LeafParams::bearing`] of a tip
//!    bears leaves.
//! 2. Along it, leaves stand at even distances; a frame without twist is carried along, and each
//!    node's leaves are turned about the axis by the divergence angle of the [`Phyllotaxis`].
//! 3. Each leaf leaves the shoot at the pitch angle, hangs by its droop, and turns its upper face to
//!    the sky by its phototropism (Neubert 2012, §5.4.1).
//!
//! Axes draw from streams of their own and run in parallel.

mod arrangement;
mod params;
mod shoot;

pub(crate) use arrangement::GOLDEN_ANGLE;
pub use arrangement::Phyllotaxis;
pub use params::LeafParams;

use crate::error::Result;
use rayon::prelude::*;
use tree_core::{Continuation, Control, Foliage, Resource, Seed, Skeleton};

/// Axes handled by one task: long enough to be worth a task, short enough to cancel soon.
const CHUNK: usize = 256;

/// Grows leaves on `skeleton`.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for parameters out of range, where a
/// kind counts as valid whatever it is (the tree knows its kinds, see
/// [`Tree::new`](tree_core::Tree::new)); [`ModelError::Limit`](crate::ModelError::Limit) before
/// memory is taken; [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(nodes + leaves).
pub fn grow_leaves(
    skeleton: &Skeleton,
    params: &LeafParams,
    seed: Seed,
    control: &Control,
) -> Result<Foliage> {
    params.validate(usize::from(u16::MAX) + 1)?;
    let axes = skeleton.axes(Continuation::Thickest);
    let to_tip = skeleton.distances_to_tip();
    control.limits.check(Resource::Leaves, most_leaves(skeleton, params, &to_tip, axes.len()))?;
    let bearer = shoot::Bearer { skeleton, params, to_tip: &to_tip };
    let numbers: Vec<u32> = (0..axes.len() as u32).collect();
    let leaves = numbers
        .par_chunks(CHUNK)
        .map(|chunk| {
            control.check()?;
            let mut leaves = Vec::new();
            for axis in chunk.iter().filter_map(|&number| axes.get(number)) {
                bearer.bear(axis, &mut seed.child(u64::from(axis.index)).rng(), &mut leaves);
            }
            Ok(leaves)
        })
        .collect::<Result<Vec<_>>>()?;
    let mut foliage = Foliage::with_capacity(leaves.iter().map(Vec::len).sum());
    for leaf in leaves.into_iter().flatten() {
        foliage.push(leaf)?;
    }
    Ok(foliage)
}

/// An upper bound on the number of leaves.
fn most_leaves(skeleton: &Skeleton, params: &LeafParams, to_tip: &[f32], n_axes: usize) -> u64 {
    let positions = skeleton.positions();
    let along: f64 = skeleton
        .segments()
        .filter(|&(_, node)| to_tip[node as usize] < params.bearing)
        .map(|(a, b)| {
            let [a, b] = [a, b].map(|node| positions[node as usize].as_dvec3());
            // One more for each segment makes up for rounding.
            a.distance(b) / f64::from(params.spacing) + 1.0
        })
        .sum();
    let per_node = u64::from(params.arrangement.per_node());
    // A cast from float saturates.
    (along as u64).saturating_mul(per_node).saturating_add(n_axes as u64)
}

#[cfg(test)]
mod tests;
