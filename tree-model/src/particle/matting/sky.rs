//! The sky of a photograph: smooth, and connected to the top border.
//!
//! 1. Pixels with hardly any contrast around them are flooded from the top border, in small steps of
//!    colour, so that gradients and soft clouds are followed.
//! 2. The flooded colours are spread over the rest by averaging from coarse to fine (push and pull,
//!    Gortler et al. 1996): the sky that a pixel would show.
//! 3. What differs little from it is sky too: gaps in the crown, edges of clouds.

use super::colors::Colors;

/// Contrast (largest difference of a channel to a neighbour two pixels off) up to which a pixel is smooth.
const SMOOTH: f32 = 0.07;
/// Difference of colour up to which a pixel, connected or not, is sky.
const LIKE: f32 = 0.07;
/// Difference of colour up to which the flood goes on through edges of clouds.
const FOLLOW: f32 = 0.13;
/// How often it goes on from what it has reached.
const FOLLOW_ROUNDS: usize = 6;
/// Pixels that the flood leaps over: the edge of a cloud.
const LEAP: usize = 5;
/// Difference of colour up to which it leaps.
const CLOUD: f32 = 0.35;
/// The same for what is brighter than the sky near it, as trees seldom are.
const BRIGHT_CLOUD: f32 = 0.7;
/// Brightness, as a share of the sky's, down to which it leaps: trees are darker.
const CLOUD_SHADE: f32 = 0.7;
/// Difference of colour above which it certainly is not.
const UNLIKE: f32 = 0.17;
/// Share of the pixels that must be sky for there to be one.
pub(super) const LEAST_SHARE: f32 = 0.02;

/// What is known about the sky in each pixel.
pub(super) struct Sky {
    /// Flooded from the top.
    pub(super) flooded: Vec<bool>,
    /// The sky's colour there, behind whatever hides it.
    behind: Vec<[f32; 3]>,
    /// Difference of the pixel's colour to the sky there: 0 to 1.7.
    pub(super) difference: Vec<f32>,
    /// Share of the picture that was flooded.
    pub(super) share: f32,
}

impl Sky {
    pub(super) fn find(colors: &Colors) -> Self {
        let n = colors.rgb.len();
        let mut sky = Self {
            flooded: vec![false; n],
            behind: Vec::new(),
            difference: vec![f32::INFINITY; n],
            share: 0.0,
        };
        for round in 0..=FOLLOW_ROUNDS {
            sky.flood(colors, round > 0);
            sky.behind = spread(colors, &sky.flooded);
            let pairs = colors.rgb.iter().zip(&sky.behind);
            sky.difference = pairs.map(|(&a, &b)| distance(a, b)).collect();
        }
        sky.share = sky.flooded.iter().filter(|&&f| f).count() as f32 / n as f32;
        sky
    }

    /// Floods smooth pixels from the top; if it `follows` what it knows, also those of more contrast
    /// that differ little from the sky near them.
    fn flood(&mut self, colors: &Colors, follows: bool) {
        let (w, h) = (colors.width, colors.height);
        let smooth = |i: usize| {
            let (x, y) = (i % w, i / w);
            let at = |x: usize, y: usize| colors.rgb[y.min(h - 1) * w + x.min(w - 1)];
            let around = [
                at(x + 2, y),
                at(x.saturating_sub(2), y),
                at(x, y + 2),
                at(x, y.saturating_sub(2)),
            ];
            let contrast =
                around.map(|c| distance(c, colors.rgb[i])).into_iter().fold(0.0, f32::max);
            contrast < SMOOTH || (follows && contrast < 2.0 * SMOOTH && self.difference[i] < FOLLOW)
        };
        let smooth: Vec<bool> = (0..w * h).map(smooth).collect();
        let clouds = if follows { self.clouds(colors, &smooth) } else { vec![false; w * h] };
        let mut open: Vec<usize> =
            (0..w * h).filter(|&i| self.flooded[i] || (i < w && smooth[i])).collect();
        for &i in &open {
            self.flooded[i] = true;
        }
        while let Some(i) = open.pop() {
            let (x, y) = (i % w, i / w);
            let next = [
                (x > 0).then(|| i - 1),
                (x + 1 < w).then(|| i + 1),
                (y > 0).then(|| i - w),
                (y + 1 < h).then(|| i + w),
            ];
            for j in next.into_iter().flatten() {
                if !self.flooded[j] && smooth[j] {
                    self.flooded[j] = true;
                    open.push(j);
                }
            }
            let far = [
                (x >= LEAP).then(|| i - LEAP),
                (x + LEAP < w).then(|| i + LEAP),
                (y + LEAP < h).then(|| i + LEAP * w),
            ];
            for j in far.into_iter().flatten() {
                if !self.flooded[j] && clouds[j] {
                    self.flooded[j] = true;
                    open.push(j);
                }
            }
        }
    }

    /// Pixels in the middle of something smooth that may be a cloud, or the sky beyond one: not much
    /// unlike the sky near them, nor much darker.
    fn clouds(&self, colors: &Colors, smooth: &[bool]) -> Vec<bool> {
        let (w, h) = (colors.width, colors.height);
        let brightness = |[r, g, b]: [f32; 3]| r + g + b;
        (0..w * h)
            .map(|i| {
                let (x, y) = (i % w, i / w);
                let lighter = brightness(colors.rgb[i]) / brightness(self.behind[i]).max(1e-3);
                self.difference[i] < if lighter > 1.0 { BRIGHT_CLOUD } else { CLOUD }
                    && lighter > CLOUD_SHADE
                    && (y.saturating_sub(2)..(y + 3).min(h)).all(|row| {
                        smooth[row * w..][x.saturating_sub(2)..(x + 3).min(w)].iter().all(|&s| s)
                    })
            })
            .collect()
    }

    /// Whether a pixel is sky rather than not.
    pub(super) fn is_sky(&self, i: usize) -> bool {
        self.flooded[i] || self.difference[i] < LIKE
    }

    /// Whether a pixel is certainly something else.
    pub(super) fn is_not(&self, i: usize) -> bool {
        !self.flooded[i] && self.difference[i] > UNLIKE
    }
}

/// Distance of two colours.
pub(super) fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let [x, y, z] = [0, 1, 2].map(|i| a[i] - b[i]);
    (x * x + y * y + z * z).sqrt()
}

/// The colours of the chosen pixels, spread over all.
fn spread(colors: &Colors, chosen: &[bool]) -> Vec<[f32; 3]> {
    let sums = colors.rgb.iter().zip(chosen);
    let sums = sums.map(|(&[r, g, b], &c)| if c { [r, g, b, 1.0] } else { [0.0; 4] }).collect();
    let filled = push_pull(sums, colors.width, colors.height);
    filled.into_iter().map(|[r, g, b, _]| [r, g, b]).collect()
}

/// Fills pixels of little weight from the mean of larger and larger blocks. Out comes weight 1.
fn push_pull(sums: Vec<[f32; 4]>, width: usize, height: usize) -> Vec<[f32; 4]> {
    let normalized = |[r, g, b, n]: [f32; 4]| {
        if n > 0.0 { [r / n, g / n, b / n, 1.0] } else { [0.0; 4] }
    };
    if width * height == 1 {
        return sums.into_iter().map(normalized).collect();
    }
    let (w, h) = (width.div_ceil(2), height.div_ceil(2));
    let mut blocks = vec![[0.0_f32; 4]; w * h];
    for (i, sum) in sums.iter().enumerate() {
        let block = &mut blocks[i / width / 2 * w + i % width / 2];
        for (b, s) in block.iter_mut().zip(sum) {
            *b += s;
        }
    }
    // A block counts as one pixel at most, so that near ones outweigh many far ones.
    for block in &mut blocks {
        if block[3] > 1.0 {
            *block = normalized(*block);
        }
    }
    let filled = push_pull(blocks, w, h);
    let mut out = sums;
    for (i, sum) in out.iter_mut().enumerate() {
        let (x, y) = (i % width, i / width);
        let (left, right, across) = super::blend::between(x, width, w);
        let (top, bottom, down) = super::blend::between(y, height, h);
        let rest = 1.0 - sum[3];
        for (k, s) in sum.iter_mut().enumerate() {
            let row = |y: usize| {
                filled[y * w + left][k]
                    + across * (filled[y * w + right][k] - filled[y * w + left][k])
            };
            *s += rest * (row(top) + down * (row(bottom) - row(top)));
        }
    }
    out
}
