//! Clusters of leaves (Behrendt, Colditz, Franzke, Kopf, Deussen 2005; §6.2).
//!
//! 1. The leaves' centres are divided into k clusters by k-means (k-means++ to begin with).
//! 2. A cluster's box, along the principal axes of its points, has sides a ≤ b ≤ c. With
//!    √(a b) > c / 2 all are about equal: three billboards at right angles. Otherwise two long sides give
//!    one billboard along them, and one long side two that cross in it.
//! 3. k follows, by halving, from the number of billboards asked for.
//!
//! The text does not say when there are two long sides; here b is long when it is nearer, as a ratio, to c
//! than to a. O(k × elements × rounds) for each k tried.

use super::{Billboard, corners, principal_axes};
use rayon::prelude::*;
use tree_core::Seed;
use tree_core::glam::Vec3;
use tree_core::seed::uniform;
use tree_lod::Elements;
use tree_mesh::Mesh;

/// Rounds of k-means; it has settled by then but for single leaves.
const ROUNDS: u32 = 12;
/// The factor f of the heuristic √(a b) > f c.
const EQUAL: f32 = 0.5;

/// At most `n` billboards for all elements.
pub(in super::super) fn behrendt(
    mesh: &Mesh,
    elements: &Elements,
    n: usize,
    seed: Seed,
) -> Vec<Billboard> {
    let with = |k: usize| -> Vec<Billboard> {
        let clusters = clusters(&elements.centers, k, seed);
        clusters.into_par_iter().flat_map_iter(|of| of_cluster(mesh, elements, &of)).collect()
    };
    // Between n / 3 clusters of three billboards each and n of one.
    let (mut low, mut high) = ((n / 3).max(1), n.max(1));
    let mut best = with(low);
    while low < high {
        let middle = (low + high).div_ceil(2);
        let made = with(middle);
        if made.len() <= n {
            (best, low) = (made, middle);
        } else {
            high = middle - 1;
        }
    }
    best
}

/// Elements of each of at most `k` clusters, none of them empty.
pub(super) fn clusters(points: &[Vec3], k: usize, seed: Seed) -> Vec<Vec<u32>> {
    let mut centers = first_centers(points, k.min(points.len()), seed);
    let mut of = vec![Vec::new(); centers.len()];
    for _ in 0..ROUNDS {
        let nearest: Vec<u32> = points.par_iter().map(|&p| nearest(&centers, p)).collect();
        of.iter_mut().for_each(Vec::clear);
        for (point, cluster) in nearest.into_iter().enumerate() {
            of[cluster as usize].push(point as u32);
        }
        for (center, of) in centers.iter_mut().zip(&of).filter(|(_, of)| !of.is_empty()) {
            *center = mean(points, of);
        }
    }
    of.retain(|cluster| !cluster.is_empty());
    of
}

fn mean(points: &[Vec3], of: &[u32]) -> Vec3 {
    of.iter().map(|&p| points[p as usize]).sum::<Vec3>() / of.len().max(1) as f32
}

fn nearest(centers: &[Vec3], p: Vec3) -> u32 {
    let mut best = (0, f32::INFINITY);
    for (i, center) in centers.iter().enumerate() {
        let distance = center.distance_squared(p);
        if distance < best.1 {
            best = (i as u32, distance);
        }
    }
    best.0
}

/// k-means++ (Arthur, Vassilvitskii 2007): each with a probability that grows as the square of its distance
/// from those before.
fn first_centers(points: &[Vec3], k: usize, seed: Seed) -> Vec<Vec3> {
    let mut rng = seed.stream("clusters").rng();
    let mut centers: Vec<Vec3> = points.first().copied().into_iter().collect();
    let mut distances = vec![f32::INFINITY; points.len()];
    while centers.len() < k {
        let Some(&last) = centers.last() else { break };
        for (distance, p) in distances.iter_mut().zip(points) {
            *distance = distance.min(p.distance_squared(last));
        }
        let mut rest = uniform(&mut rng, 0.0, distances.iter().sum());
        let chosen = distances.iter().position(|&distance| {
            rest -= distance;
            rest < 0.0
        });
        centers.push(points[chosen.unwrap_or(points.len() - 1)]);
    }
    centers
}

/// One to three billboards of a cluster.
fn of_cluster(mesh: &Mesh, all: &Elements, of: &[u32]) -> Vec<Billboard> {
    let points: Vec<Vec3> = of.iter().flat_map(|&e| corners(mesh, all, e as usize)).collect();
    let center = points.iter().sum::<Vec3>() / points.len().max(1) as f32;
    let mut axes = principal_axes(&points);
    let side = |axis: Vec3| {
        let along = points.iter().map(|p| axis.dot(*p));
        let low = along.clone().fold(f32::INFINITY, f32::min);
        along.fold(f32::NEG_INFINITY, f32::max) - low
    };
    axes.sort_by(|x, y| side(*x).total_cmp(&side(*y)));
    let sides = axes.map(side);
    let normals = &axes[..count(sides)];
    normals.iter().map(|&n| Billboard::around(mesh, all, of.to_vec(), n, center)).collect()
}

/// How many billboards a box of sides a ≤ b ≤ c takes; their normals are along the shortest sides.
pub(super) fn count([a, b, c]: [f32; 3]) -> usize {
    if (a * b).sqrt() > EQUAL * c {
        3
    } else if b * b > a * c {
        1
    } else {
        2
    }
}
