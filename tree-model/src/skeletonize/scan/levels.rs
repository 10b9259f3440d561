//! Step 5: levels of equal distance from the base fall into clusters, one for each branch they cut.
//!
//! A. Verroust and F. Lazarus, *Extracting skeletal curves from 3D scattered data* (2000); H. Xu, N.
//! Gossett and B. Chen, *Knowledge and heuristic-based modeling of laser-scanned trees* (2007), section 4.
//! A cluster's parent is the one that most ways of its points lead to.

use super::super::rows::{Rows, Sets};
use super::graph::Graph;
use super::reach::{NONE, Ways};
use glam::Vec3;

/// Clusters, each after its parent.
#[derive(Debug)]
pub(super) struct Clusters {
    /// Cluster of each point; `NONE` for points without a way.
    pub(super) of_point: Vec<u32>,
    pub(super) points: Rows,
    pub(super) centers: Vec<Vec3>,
    /// Mean distance from the base.
    pub(super) lengths: Vec<f32>,
    /// Root mean square distance of the points from the line to the parent: the radius of a tube
    /// seen from all sides, two thirds of it when seen from one.
    pub(super) widths: Vec<f32>,
    pub(super) parents: Vec<u32>,
    pub(super) base: Vec<u32>,
}

/// Cuts the cloud into levels `step` apart, and clusters wider than `widest` into cubes of twice that.
pub(super) fn clusters(
    graph: &Graph,
    points: &[Vec3],
    ways: &Ways,
    step: f32,
    widest: f32,
) -> Clusters {
    let level = |i: u32| (ways.length[i as usize] / step) as u32;
    let mut sets = Sets::new(points.len());
    for &i in &ways.order {
        for &j in graph.arcs.of(i) {
            let both = ways.base[i as usize] == ways.base[j as usize];
            if both && j < i && level(i) == level(j) {
                sets.join(i, j);
            }
        }
    }
    let (labels, n) = sets.labels();
    let (labels, n) = split(labels, n, points, ways, widest);
    // Numbered by distance, so that parents come first.
    let mut sums = vec![(Vec3::ZERO, 0.0_f64, 0_u32); n];
    for &i in &ways.order {
        let sum = &mut sums[labels[i as usize] as usize];
        *sum = (sum.0 + points[i as usize], sum.1 + f64::from(ways.length[i as usize]), sum.2 + 1);
    }
    let mut order: Vec<u32> = (0..n as u32).filter(|&c| sums[c as usize].2 > 0).collect();
    let first = {
        let mut first = vec![u32::MAX; n];
        for &i in &ways.order {
            let first = &mut first[labels[i as usize] as usize];
            *first = (*first).min(level(i));
        }
        first
    };
    order.sort_by_key(|&c| (first[c as usize], c));
    let mut rank = vec![NONE; n];
    order.iter().zip(0..).for_each(|(&c, at)| rank[c as usize] = at);
    let mut of_point = vec![NONE; points.len()];
    for &i in &ways.order {
        of_point[i as usize] = rank[labels[i as usize] as usize];
    }
    let pairs = ways.order.iter().map(|&i| (of_point[i as usize], i));
    let rows = Rows::of_pairs(pairs, order.len());
    let mean = |c: &u32| {
        let (place, length, n) = sums[*c as usize];
        (place / n as f32, (length / f64::from(n)) as f32)
    };
    let (centers, lengths): (Vec<_>, Vec<_>) = order.iter().map(mean).unzip();
    let mut clusters = Clusters {
        of_point,
        points: rows,
        widths: vec![0.0; centers.len()],
        parents: vec![NONE; centers.len()],
        base: vec![0; centers.len()],
        centers,
        lengths,
    };
    let below = below(ways, level);
    for c in 0..clusters.centers.len() as u32 {
        clusters.base[c as usize] = ways.base[clusters.points.of(c)[0] as usize];
        clusters.parents[c as usize] = parent(&clusters, &below, c);
    }
    join_roots(&mut clusters);
    for c in 0..clusters.centers.len() {
        clusters.widths[c] = width(&clusters, points, c);
    }
    clusters
}

/// The levels of a dense crown are shells from side to side, with their mean in the middle of
/// nowhere. So clusters that are too wide for wood fall into cubes.
fn split(
    mut labels: Vec<u32>,
    n: usize,
    points: &[Vec3],
    ways: &Ways,
    widest: f32,
) -> (Vec<u32>, usize) {
    let mut boxes = vec![(Vec3::INFINITY, Vec3::NEG_INFINITY); n];
    for &i in &ways.order {
        let (low, high) = &mut boxes[labels[i as usize] as usize];
        (*low, *high) = (low.min(points[i as usize]), high.max(points[i as usize]));
    }
    let wide: Vec<bool> =
        boxes.iter().map(|(low, high)| (*high - *low).max_element() > 3.0 * widest).collect();
    let mut keys: Vec<(u32, [i32; 3], u32)> = ways
        .order
        .iter()
        .filter(|&&i| wide[labels[i as usize] as usize])
        .map(|&i| {
            let cube = (points[i as usize] / (2.0 * widest)).floor().as_ivec3().to_array();
            (labels[i as usize], cube, i)
        })
        .collect();
    keys.sort_unstable();
    let mut next = n as u32;
    for cube in keys.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        cube.iter().for_each(|&(.., i)| labels[i as usize] = next);
        next += 1;
    }
    (labels, next as usize)
}

/// All points of a base start at their height, and several clusters with them: each but the first of
/// a base goes on from the nearest one before it.
fn join_roots(clusters: &mut Clusters) {
    let n = clusters.centers.len() as u32;
    let roots: Vec<u32> = (0..n).filter(|&c| clusters.parents[c as usize] == NONE).collect();
    for (i, &c) in roots.iter().enumerate() {
        let center = clusters.centers[c as usize];
        let same = |&&other: &&u32| clusters.base[other as usize] == clusters.base[c as usize];
        let near = roots[..i].iter().filter(same).min_by(|&&a, &&b| {
            let d = |c: u32| clusters.centers[c as usize].distance_squared(center);
            d(a).total_cmp(&d(b))
        });
        clusters.parents[c as usize] = near.copied().unwrap_or(NONE);
    }
}

/// For each point the first one on its way that is of a lower level; `NONE` at the base.
fn below(ways: &Ways, level: impl Fn(u32) -> u32) -> Vec<u32> {
    let mut below = vec![NONE; ways.next.len()];
    for &i in &ways.order {
        let next = ways.next[i as usize];
        below[i as usize] = match next {
            _ if next == i => NONE,
            _ if level(next) < level(i) => next,
            _ => below[next as usize],
        };
    }
    below
}

/// The cluster that most ways out of this one lead to.
fn parent(clusters: &Clusters, below: &[u32], c: u32) -> u32 {
    let mut votes: Vec<u32> = clusters
        .points
        .of(c)
        .iter()
        .filter_map(|&i| clusters.of_point.get(below[i as usize] as usize).copied())
        .collect();
    votes.sort_unstable();
    let most = votes.chunk_by(|a, b| a == b).max_by_key(|v| (v.len(), std::cmp::Reverse(v[0])));
    most.map_or(NONE, |votes| votes[0])
}

fn width(clusters: &Clusters, points: &[Vec3], c: usize) -> f32 {
    let (center, own) = (clusters.centers[c], clusters.points.of(c as u32));
    let below = clusters.centers.get(clusters.parents[c] as usize).copied();
    let along = below.and_then(|below| (center - below).try_normalize()).unwrap_or(Vec3::Y);
    let off =
        |&i: &u32| (points[i as usize] - center).reject_from_normalized(along).length_squared();
    (own.iter().map(off).sum::<f32>() / own.len() as f32).sqrt()
}
