//! Colours of both sides: marks unknown pixels that clearly look like one side.
//!
//! Closed-form matting spreads what is known along smooth colour. A few strokes in a crown of leaves do
//! not spread far, but their colours come back everywhere. The known pixels of each side are gathered in
//! clusters, split along their longest axis (Orchard and Bouman 1991, as Ruzon and Tomasi use them; each
//! cluster is a Gaussian). An unknown pixel is marked where one side's likelihood exceeds the other's
//! by more than it does for nearly all known pixels of that other side, and where it looks like most known
//! pixels of its own, in a whole neighbourhood.
//! Palettes that overlap therefore mark little, and no threshold needs setting.
//!
//! Cost: O(pixels · clusters).

use super::colors::Colors;
use super::laplacian::inverse;
use super::trimap::Level;
use rayon::prelude::*;

/// Clusters of each side.
const CLUSTERS: usize = 6;
/// Known pixels of a side that are looked at: enough for six clusters.
const SAMPLES: usize = 6000;
/// Variance added to each cluster: noise of the camera and of compression, (4 / 255)².
const NOISE: f64 = 2.5e-4;
/// Share of the known pixels of one side that may look like the other.
const ERROR_SHARE: f64 = 0.005;
/// Share of a side's known pixels that are odd: pixels as unlike it as they are not marked. Mixed colours
/// lie far from both sides, and are no nearer to the tree for being no sky.
const ODD_SHARE: f64 = 0.1;
/// Log likelihood ratio that is asked for in any case: e³, or 20 to 1.
const LEAST_MARGIN: f32 = 3.0;

/// A Gaussian of colours.
struct Cluster {
    mean: [f32; 3],
    /// Inverse covariance: xx, xy, xz, yy, yz, zz.
    inverse: [f32; 6],
    /// Log of weight over root of the determinant.
    log_scale: f32,
}

/// The colours of one side.
pub(super) struct Palette {
    clusters: Vec<Cluster>,
}

impl Palette {
    /// The palette of some colours; without any, nothing is like it.
    pub(super) fn new(colors: &[[f32; 3]]) -> Self {
        let mut groups = vec![colors.to_vec()];
        while groups.len() < CLUSTERS {
            let spreads = groups.iter().map(|group| spread(group));
            let widest = spreads.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((widest, spread)) = widest else { break };
            if spread <= 2.0 * NOISE {
                break;
            }
            let (low, high) = split(&groups.swap_remove(widest));
            groups.extend([low, high]);
        }
        let n = colors.len() as f64;
        let groups = groups.iter().filter(|group| !group.is_empty());
        Self { clusters: groups.map(|group| Cluster::new(group, group.len() as f64 / n)).collect() }
    }

    /// Log likelihood of a colour.
    pub(super) fn log_likelihood(&self, color: [f32; 3]) -> f32 {
        self.clusters.iter().map(|cluster| cluster.log_likelihood(color)).fold(-1e9, f32::max)
    }
}

impl Cluster {
    fn new(colors: &[[f32; 3]], weight: f64) -> Self {
        let (mean, mut covariance) = moments(colors);
        for i in [0, 3, 5] {
            covariance[i] += NOISE;
        }
        let [xx, xy, xz, yy, yz, zz] = covariance;
        let determinant =
            xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        Self {
            mean: mean.map(|m| m as f32),
            inverse: inverse(&covariance).map(|v| v as f32),
            log_scale: (libm::log(weight) - 0.5 * libm::log(determinant)) as f32,
        }
    }

    fn log_likelihood(&self, color: [f32; 3]) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|i| color[i] - self.mean[i]);
        let [xx, xy, xz, yy, yz, zz] = self.inverse;
        let square =
            xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z);
        self.log_scale - 0.5 * square
    }
}

/// Mean and covariance (xx, xy, xz, yy, yz, zz).
fn moments(colors: &[[f32; 3]]) -> ([f64; 3], [f64; 6]) {
    let n = colors.len().max(1) as f64;
    let mut mean = [0.0; 3];
    for color in colors {
        for (m, &c) in mean.iter_mut().zip(color) {
            *m += f64::from(c) / n;
        }
    }
    let mut covariance = [0.0; 6];
    for color in colors {
        let [x, y, z] = [0, 1, 2].map(|i| f64::from(color[i]) - mean[i]);
        for (s, v) in covariance.iter_mut().zip([x * x, x * y, x * z, y * y, y * z, z * z]) {
            *s += v / n;
        }
    }
    (mean, covariance)
}

/// How far a group spreads, counting how many it holds.
fn spread(colors: &[[f32; 3]]) -> f64 {
    let (_, c) = moments(colors);
    (c[0] + c[3] + c[5]) * libm::sqrt(colors.len() as f64)
}

/// Halves a group at its mean, across its longest axis.
fn split(colors: &[[f32; 3]]) -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
    /// Rounds of power iteration: the axis need not be exact.
    const ROUNDS: usize = 16;
    let (mean, [xx, xy, xz, yy, yz, zz]) = moments(colors);
    // The start is no axis of symmetry, so that it is not at right angles to the answer.
    let mut axis = [1.0, 0.9, 0.8];
    for _ in 0..ROUNDS {
        let [x, y, z] = axis;
        let next = [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z];
        let length = libm::sqrt(next.iter().map(|v| v * v).sum());
        if length > 0.0 {
            axis = next.map(|v| v / length);
        }
    }
    let side =
        |color: &[f32; 3]| (0..3).map(|i| axis[i] * (f64::from(color[i]) - mean[i])).sum::<f64>();
    colors.iter().partition(|color| side(color) < 0.0)
}

/// Log likelihoods of each pixel.
pub(super) fn likelihoods(colors: &Colors, palette: &Palette) -> Vec<f32> {
    colors.rgb.par_iter().map(|&color| palette.log_likelihood(color)).collect()
}

/// Colours of the pixels that `wanted` chooses, at most [`SAMPLES`] of them, evenly taken.
pub(super) fn samples(colors: &Colors, wanted: impl Fn(usize) -> bool) -> Vec<[f32; 3]> {
    let all: Vec<usize> = (0..colors.rgb.len()).filter(|&i| wanted(i)).collect();
    let step = all.len().div_ceil(SAMPLES).max(1);
    all.iter().step_by(step).map(|&i| colors.rgb[i]).collect()
}

/// Marks unknown pixels that clearly look like one side. Gives back how many.
pub(super) fn mark_clear(colors: &Colors, levels: &mut [Level]) -> usize {
    let sides = [Level::Foreground, Level::Background];
    let likelihoods = sides.map(|level| {
        let palette = Palette::new(&samples(colors, |i| levels[i] == level));
        likelihoods(colors, &palette)
    });
    let of_level = |level: Level, values: &dyn Fn(usize) -> f32| -> Vec<f32> {
        (0..levels.len()).filter(|&i| levels[i] == level).map(values).collect()
    };
    let clear = [0, 1].map(|side| {
        let (own, other) = (&likelihoods[side], &likelihoods[1 - side]);
        let margin = quantile(of_level(sides[1 - side], &|i| own[i] - other[i]), 1.0 - ERROR_SHARE);
        let margin = margin.max(LEAST_MARGIN);
        let least = quantile(of_level(sides[side], &|i| own[i]), ODD_SHARE);
        let clear = |i: usize| own[i] - other[i] > margin && own[i] >= least;
        (0..levels.len()).map(clear).collect::<Vec<bool>>()
    });
    let (width, height) = (colors.width, colors.height);
    let mut marked = 0;
    for (i, level) in levels.iter_mut().enumerate().filter(|(_, l)| **l == Level::Unknown) {
        let (x, y) = (i % width, i / width);
        let around = |clear: &[bool]| {
            (y.saturating_sub(1)..(y + 2).min(height)).all(|row| {
                clear[row * width..][x.saturating_sub(1)..(x + 2).min(width)].iter().all(|&c| c)
            })
        };
        if let Some(side) = clear.iter().position(|clear| around(clear)) {
            *level = sides[side];
            marked += 1;
        }
    }
    marked
}

/// The value that a share of all lies below; without values, minus infinity.
fn quantile(mut values: Vec<f32>, share: f64) -> f32 {
    let Some(last) = values.len().checked_sub(1) else { return f32::NEG_INFINITY };
    let at = (share * last as f64) as usize;
    *values.select_nth_unstable_by(at, f32::total_cmp).1
}
