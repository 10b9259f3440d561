//! Step 7: centres and radii.
//!
//! A node's points, seen along its axis, lie on a circle; scanned from one side only, on a part
//! of one, and their mean lies off its centre. So a circle is fitted where it is seen well enough
//! ([`circle`]). Elsewhere the pipe model speaks, calibrated on the circles: the radius grows with
//! a power of the length of all wood beyond. Along an axis radii never grow (isotonic regression), and
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
const WIDE: f32 = 3.0;
/// ...and no thinner than this many spacings.
const THIN: f32 = 0.5;
/// What points scatter by, in spacings.
const NOISE: f32 = 0.15;
/// A circle this many times larger or smaller than those round it is none.
const ODD: f32 = 1.4;
/// That many circles on either side are asked.
const ODD_WINDOW: usize = 4;
/// Exponent of the pipe model where circles are too few to tell, and its range.
const POWER: f32 = 0.5;
const POWERS: [f32; 2] = [0.35, 0.8];
/// Circles needed to tell.
const CIRCLES_MIN: usize = 12;
/// What a radius by the pipe model weighs beside one by a circle.
const MODEL_WEIGHT: f32 = 0.05;
/// Rounds of smoothing of centres.
const SMOOTH: usize = 2;
/// Thinnest wood in metres.
const RADIUS_MIN: f32 = 5e-4;

/// Nodes of all axes, place by place.
#[derive(Debug)]
pub(super) struct Wood {
    pub(super) centres: Vec<Vec<Vec3>>,
    pub(super) radii: Vec<Vec<f32>>,
    pub(super) n_fitted: usize,
}

/// Finds centres and radii.
pub(super) fn wood(axes: &Axes, clusters: &Clusters, points: &[Vec3], spacing: f32) -> Wood {
    let places = Places::new(axes, clusters);
    let mut fitted: Vec<Vec<Option<Circle3>>> = axes
        .axes
        .par_iter()
        .zip(0..axes.axes.len() as u32)
        .map(|(axis, number)| {
            let mut found: Vec<_> = (0..axis.clusters.len())
                .map(|place| fit(axis, number, place, &places, clusters, points, spacing))
                .collect();
            drop_odd(&mut found);
            found
        })
        .collect();
    let centres: Vec<Vec<Vec3>> = axes
        .axes
        .iter()
        .zip(&fitted)
        .map(|(axis, fitted)| {
            let raw: Vec<Vec3> =
                axis.clusters.iter().map(|&c| clusters.centres[c as usize]).collect();
            smooth(&raw, fitted)
        })
        .collect();
    let beyond = beyond(axes, &centres);
    let radii = radii(axes, &mut fitted, &beyond);
    let n_fitted = fitted.iter().flatten().flatten().count();
    Wood { centres, radii, n_fitted }
}

/// A circle in space.
#[derive(Clone, Copy, Debug)]
struct Circle3 {
    centre: Vec3,
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
        let pairs = (0..clusters.centres.len() as u32).filter_map(|c| {
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
    let centre_of = |place: usize| clusters.centres[axis.clusters[place] as usize];
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
    let centre = origin + circle.centre.x * x + circle.centre.y * y;
    let weight = circle.seen * circle.near;
    Some(Circle3 { centre, circle, weight })
}

/// Drops circles that are much larger or smaller than the others round them.
fn drop_odd(found: &mut [Option<Circle3>]) {
    let radii: Vec<(usize, f32)> = found
        .iter()
        .enumerate()
        .filter_map(|(place, circle)| circle.map(|c| (place, c.circle.radius)))
        .collect();
    let mut near = Vec::new();
    for (i, &(place, radius)) in radii.iter().enumerate() {
        near.clear();
        let round = i.saturating_sub(ODD_WINDOW)..(i + ODD_WINDOW + 1).min(radii.len());
        near.extend(radii[round].iter().map(|&(_, radius)| radius));
        let middle = near.len() / 2;
        let median = *near.select_nth_unstable_by(middle, f32::total_cmp).1;
        if radius > ODD * median || radius * ODD < median {
            found[place] = None;
        }
    }
}

/// Centres of circles where there are some, means elsewhere, both smoothed along the axis.
fn smooth(raw: &[Vec3], fitted: &[Option<Circle3>]) -> Vec<Vec3> {
    let mut centres: Vec<Vec3> =
        raw.iter().zip(fitted).map(|(raw, circle)| circle.map_or(*raw, |c| c.centre)).collect();
    for _ in 0..SMOOTH {
        let old = centres.clone();
        for i in 1..centres.len().saturating_sub(1) {
            centres[i] = 0.5 * old[i] + 0.25 * (old[i - 1] + old[i + 1]);
        }
    }
    centres
}

/// Length of all wood beyond each place.
fn beyond(axes: &Axes, centres: &[Vec<Vec3>]) -> Vec<Vec<f32>> {
    let mut beyond: Vec<Vec<f32>> = centres.iter().map(|axis| vec![0.0; axis.len()]).collect();
    for number in (0..centres.len()).rev() {
        let own = &centres[number];
        for i in (1..own.len()).rev() {
            let length = own[i].distance(own[i - 1]);
            beyond[number][i - 1] += beyond[number][i] + length;
        }
        if let Some((axis, place)) = axes.axes[number].host {
            let (axis, place) = (axis as usize, place as usize);
            let length = own[0].distance(centres[axis][place]);
            let all = beyond[number][0] + length;
            beyond[axis][place] += all;
        }
    }
    beyond
}

/// Circles, and between them the pipe model.
fn radii(axes: &Axes, fitted: &mut [Vec<Option<Circle3>>], beyond: &[Vec<f32>]) -> Vec<Vec<f32>> {
    let (factor, power) = pipe(fitted, beyond);
    let model = |length: f32| factor * libm::powf(length.max(1e-3), power);
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

/// Factor and exponent of r = f · lᵖ by least squares through the circles, on logarithms.
fn pipe(fitted: &[Vec<Option<Circle3>>], beyond: &[Vec<f32>]) -> (f32, f32) {
    let (mut n, mut sum, mut sums) = (0_usize, [0.0_f64; 3], [0.0_f64; 2]);
    for (circle, &length) in fitted.iter().flatten().zip(beyond.iter().flatten()) {
        if let Some(circle) = circle
            && length > 0.0
        {
            let (x, y) = (libm::log(f64::from(length)), libm::log(f64::from(circle.circle.radius)));
            let w = f64::from(circle.weight);
            n += 1;
            sum = [sum[0] + w, sum[1] + w * x, sum[2] + w * y];
            sums = [sums[0] + w * x * x, sums[1] + w * x * y];
        }
    }
    if n == 0 {
        // A tree of ten metres of wood on a trunk of three centimetres.
        return (0.01, POWER);
    }
    let (x, y) = (sum[1] / sum[0], sum[2] / sum[0]);
    let (xx, xy) = (sums[0] / sum[0] - x * x, sums[1] / sum[0] - x * y);
    let slope = xy / xx;
    let power = if n >= CIRCLES_MIN && slope.is_finite() {
        (slope as f32).clamp(POWERS[0], POWERS[1])
    } else {
        POWER
    };
    (libm::exp(y - f64::from(power) * x) as f32, power)
}

/// The falling sequence nearest to weighted values (pool adjacent violators, Barlow et al. 1972).
fn falling(rows: &[(f32, f32)]) -> Vec<f32> {
    let mut pools: Vec<(f32, f32, usize)> = Vec::with_capacity(rows.len());
    for &(value, weight) in rows {
        let mut pool = (value, weight.max(1e-6), 1);
        while let Some(&(before, w, n)) = pools.last() {
            if before >= pool.0 {
                break;
            }
            pools.pop();
            let all = w + pool.1;
            pool = ((before * w + pool.0 * pool.1) / all, all, n + pool.2);
        }
        pools.push(pool);
    }
    pools.iter().flat_map(|&(value, _, n)| std::iter::repeat_n(value, n)).collect()
}
