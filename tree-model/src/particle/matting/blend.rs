//! Alpha at full size from alpha at working size.
//!
//! In a small window alpha is a linear function of colour, `α = a · C + b` (Levin et al. 2008, section 5;
//! the fast guided filter of He and Sun 2015). `a` and `b` are fitted at working size, averaged over the
//! windows a pixel lies in, brought to full size between pixel centres, and applied to the full-size
//! colours, a row at a time.

use super::super::Photo;
use super::colors::Colors;
use super::laplacian::inverse;
use super::trimap::{Level, Trimap};
use rayon::prelude::*;

/// Pixels to each side of a window's centre.
const RADIUS: usize = 1;
/// Keeps `a` small where a window holds hardly any colours: variance of colour, of 1.
const EPSILON: f64 = 1e-4;

/// Alpha of each pixel of `photo`; where `trimap` knows it, that.
pub(super) fn to_full_size(
    photo: &Photo,
    trimap: &Trimap,
    colors: &Colors,
    alpha: &[f32],
) -> Vec<f32> {
    let (width, height) = (photo.width() as usize, photo.height() as usize);
    let models = (width != colors.width || height != colors.height).then(|| {
        let fitted = fit(colors, alpha);
        averaged(&fitted, colors.width, colors.height)
    });
    let mut out = vec![0.0; width * height];
    out.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
        let line = &photo.pixels()[y * width..][..width];
        let rows = models.as_ref().map(|models| Rows::at(models, colors, y, height));
        for (x, (out, color)) in out.iter_mut().zip(line).enumerate() {
            *out = match (trimap.under(x, y, width, height), &rows) {
                (Level::Background, _) => 0.0,
                (Level::Foreground, _) => 1.0,
                (Level::Unknown, None) => alpha[y * width + x],
                (Level::Unknown, Some(rows)) => rows.alpha(x, width, color),
            }
            .clamp(0.0, 1.0);
        }
    });
    out
}

/// `a` and `b` of a pixel.
type Model = [f32; 4];

/// The models fitted in the window around each pixel.
fn fit(colors: &Colors, alpha: &[f32]) -> Vec<Model> {
    let (width, height) = (colors.width, colors.height);
    let mut models = vec![[0.0; 4]; width * height];
    models.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
        for (x, model) in row.iter_mut().enumerate() {
            *model = fit_one(colors, alpha, x, y);
        }
    });
    models
}

/// Rows and columns of a window, cut at the border.
fn window(at: usize, size: usize) -> std::ops::Range<usize> {
    at.saturating_sub(RADIUS)..(at + RADIUS + 1).min(size)
}

fn fit_one(colors: &Colors, alpha: &[f32], x: usize, y: usize) -> Model {
    let (mut n, mut mean_alpha, mut mean) = (0.0_f32, 0.0_f32, [0.0_f32; 3]);
    for row in window(y, colors.height) {
        for i in window(x, colors.width).map(|column| row * colors.width + column) {
            n += 1.0;
            mean_alpha += alpha[i];
            for (m, c) in mean.iter_mut().zip(colors.rgb[i]) {
                *m += c;
            }
        }
    }
    mean_alpha /= n;
    let mean = mean.map(|m| m / n);
    let (mut covariance, mut with_alpha) = ([0.0_f32; 6], [0.0_f32; 3]);
    for row in window(y, colors.height) {
        for i in window(x, colors.width).map(|column| row * colors.width + column) {
            let c = colors.rgb[i];
            let [r, g, b] = [c[0] - mean[0], c[1] - mean[1], c[2] - mean[2]];
            for (s, v) in covariance.iter_mut().zip([r * r, r * g, r * b, g * g, g * b, b * b]) {
                *s += v / n;
            }
            for (s, v) in with_alpha.iter_mut().zip([r, g, b]) {
                *s += v * (alpha[i] - mean_alpha) / n;
            }
        }
    }
    let mut covariance = covariance.map(f64::from);
    for i in [0, 3, 5] {
        covariance[i] += EPSILON;
    }
    let [rr, rg, rb, gg, gb, bb] = inverse(&covariance).map(|v| v as f32);
    let [r, g, b] = with_alpha;
    let a = [rr * r + rg * g + rb * b, rg * r + gg * g + gb * b, rb * r + gb * g + bb * b];
    [a[0], a[1], a[2], mean_alpha - a[0] * mean[0] - a[1] * mean[1] - a[2] * mean[2]]
}

/// The mean of the models in the window around each pixel.
fn averaged(models: &[Model], width: usize, height: usize) -> Vec<Model> {
    let mut out = vec![[0.0; 4]; models.len()];
    out.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
        for (x, out) in row.iter_mut().enumerate() {
            let mut n = 0.0;
            for row in window(y, height) {
                for model in &models[row * width..][window(x, width)] {
                    n += 1.0;
                    for (o, m) in out.iter_mut().zip(model) {
                        *o += m;
                    }
                }
            }
            *out = out.map(|o| o / n);
        }
    });
    out
}

/// The models of one full-size row: between two rows at working size.
struct Rows {
    models: Vec<Model>,
}

impl Rows {
    fn at(models: &[Model], colors: &Colors, y: usize, height: usize) -> Self {
        let (low, high, share) = between(y, height, colors.height);
        let row = |y: usize| &models[y * colors.width..][..colors.width];
        let models = row(low).iter().zip(row(high)).map(|(a, b)| mix(a, b, share)).collect();
        Self { models }
    }

    fn alpha(&self, x: usize, width: usize, color: &[u8; 4]) -> f32 {
        let (low, high, share) = between(x, width, self.models.len());
        let model = mix(&self.models[low], &self.models[high], share);
        let [r, g, b] = [color[0], color[1], color[2]].map(|v| f32::from(v) / 255.0);
        model[0] * r + model[1] * g + model[2] * b + model[3]
    }
}

fn mix(a: &Model, b: &Model, share: f32) -> Model {
    std::array::from_fn(|k| a[k] + share * (b[k] - a[k]))
}

/// The two of `to` pixels between whose centres pixel `at` of `from` lies, and how near to the second.
pub(super) fn between(at: usize, from: usize, to: usize) -> (usize, usize, f32) {
    let place = (at as f32 + 0.5) * to as f32 / from as f32 - 0.5;
    let low = place.max(0.0) as usize;
    let low = low.min(to - 1);
    (low, (low + 1).min(to - 1), (place - low as f32).clamp(0.0, 1.0))
}
