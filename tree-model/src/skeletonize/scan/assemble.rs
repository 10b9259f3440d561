//! Step 8: skeletons of axes.

use super::ScannedTree;
use super::axes::Axes;
use super::clean::{Clean, outward};
use super::levels::Clusters;
use super::params::ScanParams;
use super::reach::NONE;
use super::wood::Wood;
use crate::error::Result;
use tree_core::Skeleton;

/// The tree on one base, if any axis stands there, and how many of its nodes are in foliage.
pub(super) fn tree(
    axes: &Axes,
    clusters: &Clusters,
    wood: &Wood,
    base: u32,
    clean: &Clean,
    params: &ScanParams,
) -> Result<(Option<ScannedTree>, usize)> {
    let (mut positions, mut radii, mut parents) = (Vec::new(), Vec::new(), Vec::new());
    let mut in_foliage = Vec::new();
    let mut n_in_foliage = 0;
    let mut firsts = vec![NONE; axes.axes.len()];
    for (number, axis) in axes.axes.iter().enumerate() {
        let own = axis.clusters.first().is_some_and(|&c| clusters.base[c as usize] == base);
        if !own {
            continue;
        }
        let n = axis.clusters.len();
        let begin = wood.foliage[number].min(n);
        n_in_foliage += n - begin;
        // The root stays, whatever hangs round it.
        let kept = match (params.foliage, axis.host) {
            (true, _) => n,
            (false, None) => begin.max(1),
            (false, Some(_)) => begin,
        };
        firsts[number] = positions.len() as u32;
        let host = |(axis, place): (u32, u32)| firsts[axis as usize] + place;
        let mut parent = axis.host.map_or(NONE, host);
        for place in 0..kept {
            positions.push(wood.centers[number][place]);
            radii.push(wood.radii[number][place]);
            in_foliage.push(place >= begin);
            parents.push(parent);
            parent = positions.len() as u32 - 1;
        }
    }
    let Some(&root) = positions.first() else { return Ok((None, n_in_foliage)) };
    positions.iter_mut().for_each(|p| *p -= root);
    let skeleton = Skeleton::from_columns(positions, radii, parents)?;
    let base = clean.origin + outward(root.as_dvec3(), params);
    Ok((Some(ScannedTree { skeleton, base, in_foliage }), n_in_foliage))
}
