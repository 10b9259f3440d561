//! Step 6: axes, the longest first.
//!
//! M. Sato, I. Bitter, M. Bender, A. Kaufman and M. Nakajima, *TEASAR: tree-structure extraction
//! algorithm for accurate and robust skeletons* (2000): the way from the farthest cluster down to what is
//! already there is an axis; it takes in all clusters round it, within its thickness; repeat. Clusters that
//! a scan tore in two, and those of thick wood seen from one side, run beside an axis and vanish in
//! it; branches begin where they leave their parent's reach.
//!
//! Departures: the ways are those of the levels' clusters instead of voxels, and the thickness is that of
//! the clusters instead of the distance to the border of a volume.

use super::kd::Kd;
use super::levels::Clusters;
use super::reach::NONE;
use glam::Vec3;

/// Half as many neighbours along an axis give its thickness there, as their median.
const WINDOW: usize = 3;
/// Clusters are taken in by axes whose distance from the base differs by at most this many reaches.
const LEVELS_APART: f32 = 2.0;

/// How axes take clusters in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taking {
    /// Reach of an axis in widths...
    pub(super) widths: f32,
    /// ...and beyond it in metres.
    pub(super) beyond: f32,
    /// Least length of an axis beyond the reach of its parent.
    pub(super) length: f32,
    /// Distance between levels.
    pub(super) step: f32,
}

/// Axes as lists of clusters.
#[derive(Debug, Default)]
pub(super) struct Axes {
    pub(super) axes: Vec<Axis>,
    /// For each cluster the axis and the place on it that took it in.
    pub(super) taken: Vec<(u32, u32)>,
    /// Axes that were too short, and melted into their parents.
    pub(super) n_short: usize,
}

/// One axis from base to tip.
#[derive(Debug)]
pub(super) struct Axis {
    /// Axis and place that it starts from; `None` for a trunk.
    pub(super) host: Option<(u32, u32)>,
    pub(super) clusters: Vec<u32>,
    /// Thickness at each cluster: the median of the widths round it.
    pub(super) widths: Vec<f32>,
}

/// Finds axes.
pub(super) fn axes(clusters: &Clusters, taking: Taking) -> Axes {
    let n = clusters.centers.len();
    let kd = Kd::new(&clusters.centers);
    let mut axes = Axes { taken: vec![(NONE, NONE); n], ..Axes::default() };
    // Tips, the farthest first.
    let mut is_tip = vec![true; n];
    for &parent in clusters.parents.iter().filter(|&&parent| parent != NONE) {
        is_tip[parent as usize] = false;
    }
    let mut tips: Vec<u32> = (0..n as u32).filter(|&c| is_tip[c as usize]).collect();
    let length = |c: &u32| clusters.lengths[*c as usize];
    tips.sort_by(|a, b| length(b).total_cmp(&length(a)).then(a.cmp(b)));
    for tip in tips {
        let (mut way, mut at) = (Vec::new(), tip);
        while at != NONE && axes.taken[at as usize].0 == NONE {
            way.push(at);
            at = clusters.parents[at as usize];
        }
        if way.is_empty() {
            continue;
        }
        way.reverse();
        let host = (at != NONE).then(|| axes.taken[at as usize]);
        if let Some((axis, place)) = host {
            let start =
                clusters.centers[axes.axes[axis as usize].clusters[place as usize] as usize];
            let reach =
                taking.widths * axes.axes[axis as usize].widths[place as usize] + taking.beyond;
            if out_of(clusters, &way, start) < reach + taking.length {
                axes.n_short += 1;
                way.iter().for_each(|&c| axes.taken[c as usize] = (axis, place));
                continue;
            }
        }
        let widths = thickness(clusters, &way);
        let number = axes.axes.len() as u32;
        way.iter().zip(0..).for_each(|(&c, place)| axes.taken[c as usize] = (number, place));
        axes.axes.push(Axis { host, clusters: way, widths });
        take_in(clusters, &kd, &mut axes, number, taking);
    }
    axes
}

/// How far a way gets from where it starts.
fn out_of(clusters: &Clusters, way: &[u32], start: Vec3) -> f32 {
    way.iter().map(|&c| clusters.centers[c as usize].distance(start)).fold(0.0, f32::max)
}

fn thickness(clusters: &Clusters, way: &[u32]) -> Vec<f32> {
    let mut near = Vec::with_capacity(2 * WINDOW + 1);
    (0..way.len())
        .map(|i| {
            near.clear();
            let round = i.saturating_sub(WINDOW)..(i + WINDOW + 1).min(way.len());
            near.extend(way[round].iter().map(|&c| clusters.widths[c as usize]));
            let middle = near.len() / 2;
            *near.select_nth_unstable_by(middle, f32::total_cmp).1
        })
        .collect()
}

/// Takes in free clusters round an axis, each at the nearest place.
fn take_in(clusters: &Clusters, kd: &Kd, axes: &mut Axes, number: u32, taking: Taking) {
    let axis = &axes.axes[number as usize];
    let mut found: Vec<(u32, f32, u32)> = Vec::new();
    for ((&c, &width), place) in axis.clusters.iter().zip(&axis.widths).zip(0..) {
        let (center, length) = (clusters.centers[c as usize], clusters.lengths[c as usize]);
        let reach = taking.widths * width + taking.beyond;
        kd.within(center, reach, &mut |d2, i| {
            let other = kd.order()[i as usize];
            let apart = (clusters.lengths[other as usize] - length).abs();
            let free = axes.taken[other as usize].0 == NONE;
            let same = clusters.base[other as usize] == clusters.base[c as usize];
            if free && same && apart <= LEVELS_APART * reach + taking.step {
                found.push((other, d2, place));
            }
        });
    }
    found.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    for (other, _, place) in found {
        let taken = &mut axes.taken[other as usize];
        if taken.0 == NONE {
            *taken = (number, place);
        }
    }
}
