//! Step 7: centres and radii.
//!
//! A node's points, seen along its axis, lie on a circle; scanned from one side only, on a part
//! of one, and their mean lies off its centre. So a circle is fitted where it is seen well enough
//! ([`circle`]). Elsewhere the pipe model speaks, calibrated on the circles: the radius grows with
//! the square root of the length of all wood beyond. Along an axis radii never grow (isotonic regression), and
//! a branch is never thicker than what it stands on.

use super::super::rows::Rows;
use super::axes::{Axes, Axis};
use super::circle::{self, Circle};
use super::levels::Clusters;
use super::reach::NONE;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Nodes on either side whose points are fitted together.
const WINDOW: usize = 1;
/// Circles are sought between these shares of the axis' width...
const NARROW: f32 = 0.5;
const WIDE: f32 = 1.7;
/// ...and no thinner than this many spacings.
const THIN: f32 = 0.5;
/// What points scatter by, in spacings.
const NOISE: f32 = 0.15;
/// Circles of radii within this factor agree.
const ODD: f32 = 1.3;
/// That many nodes on either side are asked...
const ODD_WINDOW: usize = 4;
/// ...and this share of all of them must agree.
const AGREE: f32 = 0.45;
/// Factor of the pipe model where no circle was seen: ten metres of wood on three centimetres.
const FACTOR: f32 = 0.01;
/// What a radius by the pipe model weighs beside one by a circle.
const MODEL_WEIGHT: f32 = 0.05;
/// Wood without circles is thinner than this many spacings.
const LEAFLESS: f32 = 1.0;
/// Foliage begins where fewer than this share of so many nodes, and of all farther ones, are wood.
const FOLIAGE_SHARE: f32 = 0.5;
const FOLIAGE_WINDOW: usize = 8;
/// Rounds of smoothing of centres.
const SMOOTH: usize = 4;
/// Thinnest wood in metres.
const RADIUS_MIN: f32 = 5e-4;

/// Nodes of all axes, place by place.
#[derive(Debug)]
pub(super) struct Wood {
    pub(super) centers: Vec<Vec<Vec3>>,
    pub(super) radii: Vec<Vec<f32>>,
    /// For each axis the place from which on it runs through foliage.
    pub(super) foliage: Vec<usize>,
    pub(super) n_fitted: usize,
}

/// Finds centres and radii.
pub(super) fn wood(axes: &Axes, clusters: &Clusters, points: &[Vec3], spacing: f32) -> Wood {
    let places = Places::new(axes, clusters);
    let (mut fitted, hollow): (Vec<Vec<Option<Circle3>>>, Vec<Vec<bool>>) = axes
        .axes
        .par_iter()
        .zip(0..axes.axes.len() as u32)
        .map(|(axis, number)| {
            let mut found: Vec<_> = (0..axis.clusters.len())
                .map(|place| fit(axis, number, place, &places, clusters, points, spacing))
                .collect();
            let hollow: Vec<bool> = found.iter().map(Option::is_some).collect();
            drop_odd(&mut found);
            (found, hollow)
        })
        .unzip();
    let centers: Vec<Vec<Vec3>> = axes
        .axes
        .iter()
        .zip(&fitted)
        .map(|(axis, fitted)| {
            let raw: Vec<Vec3> =
                axis.clusters.iter().map(|&c| clusters.centers[c as usize]).collect();
            smooth(&raw, fitted)
        })
        .collect();
    let beyond = beyond(axes, &centers);
    let radii = radii(axes, &mut fitted, &beyond);
    let n_fitted = fitted.iter().flatten().flatten().count();
    let foliage = foliage(axes, &hollow, spacing);
    Wood { centers, radii, foliage, n_fitted }
}

/// A circle in space.
#[derive(Clone, Copy, Debug)]
struct Circle3 {
    center: Vec3,
    circle: Circle,
    weight: f32,
}

/// Which clusters each place of each axis took in.
struct Places {
    starts: Vec<u32>,
    clusters: Rows,
}

impl Places {
    fn new(axes: &Axes, clusters: &Clusters) -> Self {
        let mut starts = vec![0_u32];
        for axis in &axes.axes {
            starts.push(starts[starts.len() - 1] + axis.clusters.len() as u32);
        }
        let n = starts[axes.axes.len()] as usize;
        let pairs = (0..clusters.centers.len() as u32).filter_map(|c| {
            let (axis, place) = axes.taken[c as usize];
            (axis != NONE).then(|| (starts[axis as usize] + place, c))
        });
        let clusters = Rows::of_pairs(pairs, n);
        Self { starts, clusters }
    }

    fn of(&self, axis: u32, place: usize) -> &[u32] {
        self.clusters.of(self.starts[axis as usize] + place as u32)
    }
}

fn fit(
    axis: &Axis,
    number: u32,
    place: usize,
    places: &Places,
    clusters: &Clusters,
    points: &[Vec3],
    spacing: f32,
) -> Option<Circle3> {
    let last = axis.clusters.len() - 1;
    let round = place.saturating_sub(WINDOW)..=(place + WINDOW).min(last);
    let wide = place.saturating_sub(2 * WINDOW)..=(place + 2 * WINDOW).min(last);
    let centre_of = |place: usize| clusters.centers[axis.clusters[place] as usize];
    let along = (centre_of(*wide.end()) - centre_of(*wide.start())).try_normalize()?;
    let origin = centre_of(place);
    let (x, y) = along.any_orthonormal_pair();
    let mut flat: Vec<Vec2> = Vec::new();
    for near in round {
        for &c in places.of(number, near) {
            flat.extend(clusters.points.of(c).iter().map(|&i| {
                let away = points[i as usize] - origin;
                Vec2::new(away.dot(x), away.dot(y))
            }));
        }
    }
    let width = axis.widths[place];
    let range = [(NARROW * width).max(THIN * spacing), WIDE * width];
    let seed = (u64::from(number) << 32) | place as u64;
    let circle = circle::fit(&flat, range, NOISE * spacing, seed)?;
    let center = origin + circle.center.x * x + circle.center.y * y;
    let rough = circle.error / circle.radius;
    let weight = circle.seen * circle.near * (1.0 - 4.0 * rough).max(0.1);
    Some(Circle3 { center, circle, weight })
}

/// Drops circles that too few of those round them agree with.
fn drop_odd(found: &mut [Option<Circle3>]) {
    let radii: Vec<Option<f32>> = found.iter().map(|c| c.map(|c| c.circle.radius)).collect();
    for (i, radius) in radii.iter().enumerate() {
        let Some(radius) = radius else { continue };
        let round = i.saturating_sub(ODD_WINDOW)..(i + ODD_WINDOW + 1).min(radii.len());
        let n = round.len();
        let alike = |other: &f32| *other <= ODD * radius && *radius <= ODD * other;
        let n_alike = radii[round].iter().flatten().filter(|r| alike(r)).count();
        if (n_alike as f32) < AGREE * n as f32 {
            found[i] = None;
        }
    }
}

/// Centres of circles where there are some, means elsewhere, both smoothed along the axis.
fn smooth(raw: &[Vec3], fitted: &[Option<Circle3>]) -> Vec<Vec3> {
    let mut centers: Vec<Vec3> =
        raw.iter().zip(fitted).map(|(raw, circle)| circle.map_or(*raw, |c| c.center)).collect();
    for _ in 0..SMOOTH {
        let old = centers.clone();
        for i in 1..centers.len().saturating_sub(1) {
            centers[i] = 0.5 * old[i] + 0.25 * (old[i - 1] + old[i + 1]);
        }
    }
    centers
}

/// Length of all wood beyond each place.
fn beyond(axes: &Axes, centers: &[Vec<Vec3>]) -> Vec<Vec<f32>> {
    let mut beyond: Vec<Vec<f32>> = centers.iter().map(|axis| vec![0.0; axis.len()]).collect();
    for number in (0..centers.len()).rev() {
        let own = &centers[number];
        for i in (1..own.len()).rev() {
            let length = own[i].distance(own[i - 1]);
            beyond[number][i - 1] += beyond[number][i] + length;
        }
        if let Some((axis, place)) = axes.axes[number].host {
            let (axis, place) = (axis as usize, place as usize);
            let length = own[0].distance(centers[axis][place]);
            let all = beyond[number][0] + length;
            beyond[axis][place] += all;
        }
    }
    beyond
}

/// Circles, and between them the pipe model.
fn radii(axes: &Axes, fitted: &mut [Vec<Option<Circle3>>], beyond: &[Vec<f32>]) -> Vec<Vec<f32>> {
    let factor = pipe(fitted, beyond);
    let model = |length: f32| factor * length.max(1e-3).sqrt();
    let mut radii: Vec<Vec<f32>> = Vec::with_capacity(beyond.len());
    for (number, axis) in axes.axes.iter().enumerate() {
        let (circles, lengths) = (&mut fitted[number], &beyond[number]);
        let host = axis.host.map(|(axis, place)| {
            let (axis, place) = (axis as usize, place as usize);
            (radii[axis][place], beyond[axis][place])
        });
        if let Some((radius, _)) = host {
            // Thicker than the parent: those circles took in its points.
            circles.iter_mut().for_each(|circle| {
                *circle = circle.filter(|c| c.circle.radius <= ODD * radius);
            });
        }
        // Where no circle was seen the model holds, brought to meet the last circle below.
        let mut scale = 1.0;
        if let Some((radius, length)) = host {
            scale = (radius / model(length)).min(1.0);
        }
        if let Some(first) = circles.iter().position(Option::is_some)
            && let Some(circle) = circles[first]
        {
            scale = circle.circle.radius / model(lengths[first]);
        }
        let mut rows: Vec<(f32, f32)> = Vec::with_capacity(lengths.len());
        for (circle, &length) in circles.iter().zip(lengths) {
            rows.push(match circle {
                Some(circle) => {
                    scale = circle.circle.radius / model(length);
                    (circle.circle.radius, circle.weight)
                }
                None => (scale * model(length), MODEL_WEIGHT),
            });
        }
        let most = host.map_or(f32::INFINITY, |(radius, _)| radius);
        let own = falling(&rows).into_iter().map(|r| r.min(most).max(RADIUS_MIN)).collect();
        radii.push(own);
    }
    radii
}

/// Factor of r = f · √l: the median over all circles.
fn pipe(fitted: &[Vec<Option<Circle3>>], beyond: &[Vec<f32>]) -> f32 {
    let pairs = fitted.iter().flatten().zip(beyond.iter().flatten());
    let mut factors: Vec<f32> = pairs
        .filter(|(_, length)| **length > 0.0)
        .filter_map(|(circle, length)| circle.map(|c| c.circle.radius / length.sqrt()))
        .collect();
    if factors.is_empty() {
        return FACTOR;
    }
    let middle = factors.len() / 2;
    *factors.select_nth_unstable_by(middle, f32::total_cmp).1
}

/// The falling sequence nearest to weighted values in the sum of absolute differences: pools of
/// adjacent violators take their weighted median (Robertson and Wright 1980), so that a few circles
/// round forks do not lift a trunk.
fn falling(rows: &[(f32, f32)]) -> Vec<f32> {
    let mut pools: Vec<(f32, Vec<(f32, f32)>)> = Vec::with_capacity(rows.len());
    for &row in rows {
        let mut pool = (row.0, vec![row]);
        while let Some(before) = pools.pop_if(|before| before.0 < pool.0) {
            let mut all = before.1;
            all.extend(pool.1);
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            pool = (median(&all), all);
        }
        pools.push(pool);
    }
    pools.iter().flat_map(|(value, own)| std::iter::repeat_n(*value, own.len())).collect()
}

/// Weighted median of sorted values.
fn median(rows: &[(f32, f32)]) -> f32 {
    let half = 0.5 * rows.iter().map(|row| row.1).sum::<f32>();
    let mut sum = 0.0;
    for &(value, weight) in rows {
        sum += weight;
        if sum >= half {
            return value;
        }
    }
    rows.last().map_or(0.0, |row| row.0)
}

/// Where foliage begins on each axis. Wood is thin as scans see it, or hollow; leaves are neither.
fn foliage(axes: &Axes, hollow: &[Vec<bool>], spacing: f32) -> Vec<usize> {
    let mut begins: Vec<usize> = Vec::with_capacity(axes.axes.len());
    for (axis, hollow) in axes.axes.iter().zip(hollow) {
        let n = hollow.len();
        let begin = match axis.host {
            Some((axis, place)) if place as usize >= begins[axis as usize] => 0,
            _ => {
                let wood: Vec<u32> = hollow
                    .iter()
                    .zip(&axis.widths)
                    .map(|(&hollow, &width)| u32::from(hollow || width <= LEAFLESS * spacing))
                    .collect();
                let share = |range: std::ops::Range<usize>| {
                    wood[range.clone()].iter().sum::<u32>() as f32 / range.len().max(1) as f32
                };
                (0..n)
                    .find(|&i| {
                        let near = i..(i + FOLIAGE_WINDOW).min(n);
                        wood[i] == 0 && share(near) < FOLIAGE_SHARE && share(i..n) < FOLIAGE_SHARE
                    })
                    .unwrap_or(n)
            }
        };
        begins.push(begin);
    }
    begins
}
