//! The matting Laplacian of Levin, Lischinski and Weiss (2008), equation 12.
//!
//! In every window of 3 × 3 pixels, alpha is assumed to be a linear function of colour, up to a small
//! `epsilon`. What alphas depart from that, summed over all windows, is `αᵀ L α`; L has 25 entries a row.
//! L is symmetric, so that 13 are kept: for each pixel, its own and those towards later pixels.
//!
//! Cost: O(pixels), 52 bytes each. A product reads each entry twice, row by row, without indices.

use super::colors::Colors;
use rayon::prelude::*;

/// Columns and rows of zeros around a grid, so that no product needs to ask whether a neighbour exists.
pub(super) const MARGIN: usize = 2;
/// Later neighbours of a pixel within two windows' reach, itself first: (columns, rows).
const OFFSETS: [(isize, usize); 13] = [
    (0, 0),
    (1, 0),
    (2, 0),
    (-2, 1),
    (-1, 1),
    (0, 1),
    (1, 1),
    (2, 1),
    (-2, 2),
    (-1, 2),
    (0, 2),
    (1, 2),
    (2, 2),
];
/// Entries kept for a pixel.
const KEPT: usize = OFFSETS.len();

/// Values on a grid with a margin, row by row.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Layout {
    /// From one row to the next.
    pub(super) fn stride(self) -> usize {
        self.width + 2 * MARGIN
    }

    /// Values, margin included.
    pub(super) fn len(self) -> usize {
        self.stride() * (self.height + 2 * MARGIN)
    }

    /// Where a pixel is.
    pub(super) fn index(self, x: usize, y: usize) -> usize {
        (y + MARGIN) * self.stride() + x + MARGIN
    }
}

/// The matting Laplacian of a picture.
pub(super) struct Laplacian {
    pub(super) layout: Layout,
    /// For each row, margin included, the rows of all kept entries one after the other.
    entries: Vec<f32>,
}

impl Laplacian {
    /// The Laplacian over all windows that hold a pixel for which `unknown` (on the grid with margin) is
    /// above 0; others do not matter.
    pub(super) fn new(colors: &Colors, unknown: &[f32], epsilon: f32) -> Self {
        let layout = Layout { width: colors.width, height: colors.height };
        let row = KEPT * layout.stride();
        let mut entries = vec![0.0_f32; row * (layout.height + 2 * MARGIN)];
        if layout.width >= 3 && layout.height >= 3 {
            // A window writes to its three rows. Windows three rows apart share none: three rounds.
            for round in 0..3 {
                let start = (MARGIN + round) * row;
                entries[start..].par_chunks_exact_mut(3 * row).enumerate().for_each(|(i, rows)| {
                    let center = 3 * i + round + 1;
                    if center + 1 < layout.height {
                        add_windows(rows, colors, unknown, epsilon, center, layout);
                    }
                });
            }
        }
        Self { layout, entries }
    }

    /// Row `y` (margin included) of the entries towards neighbour `k`.
    #[inline]
    fn line(&self, y: usize, k: usize) -> &[f32] {
        let stride = self.layout.stride();
        &self.entries[(y * KEPT + k) * stride..][..stride]
    }

    /// One row of the product with `v`. `y` counts pixels; `out` is the row without its margin.
    pub(super) fn product(&self, v: &[f32], y: usize, out: &mut [f32]) {
        let (stride, width) = (self.layout.stride(), self.layout.width);
        let y = y + MARGIN;
        let row = |y: usize, shift: isize| {
            let start = (y * stride + MARGIN).wrapping_add_signed(shift);
            &v[start..][..width]
        };
        let own = &self.line(y, 0)[MARGIN..][..width];
        for ((o, &e), &v) in out.iter_mut().zip(own).zip(row(y, 0)) {
            *o = e * v;
        }
        for (k, &(dx, dy)) in OFFSETS.iter().enumerate().skip(1) {
            let later = &self.line(y, k)[MARGIN..][..width];
            let earlier = &self.line(y - dy, k)[MARGIN.wrapping_add_signed(-dx)..][..width];
            let sides = row(y + dy, dx).iter().zip(row(y - dy, -dx));
            for (((o, &a), &b), (&va, &vb)) in out.iter_mut().zip(later).zip(earlier).zip(sides) {
                *o += a * va + b * vb;
            }
        }
    }

    /// The diagonal entry of a pixel.
    pub(super) fn diagonal(&self, x: usize, y: usize) -> f32 {
        self.line(y + MARGIN, 0)[x + MARGIN]
    }
}

/// Adds the windows of one row of centres to the entries of its three rows.
fn add_windows(
    rows: &mut [f32],
    colors: &Colors,
    unknown: &[f32],
    epsilon: f32,
    center: usize,
    layout: Layout,
) {
    let stride = layout.stride();
    for x in 1..layout.width - 1 {
        let needed = (0..3).any(|dy| {
            let start = layout.index(x - 1, center + dy - 1);
            unknown[start..start + 3].iter().any(|&u| u > 0.0)
        });
        if !needed {
            continue;
        }
        let mut window = [[0.0_f32; 3]; 9];
        for (j, color) in window.iter_mut().enumerate() {
            *color = colors.rgb[(center + j / 3 - 1) * colors.width + x + j % 3 - 1];
        }
        let window = whitened(&window, epsilon);
        for i in 0..9 {
            for j in i..9 {
                let (a, b) = (window[i], window[j]);
                let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let own = if i == j { 1.0 } else { 0.0 };
                let (dx, dy) = ((j % 3) as isize - (i % 3) as isize, j / 3 - i / 3);
                let k = neighbour(dx, dy);
                let column = x + MARGIN + i % 3 - 1;
                rows[(i / 3 * KEPT + k) * stride + column] += own - (1.0 + dot) / 9.0;
            }
        }
    }
}

/// Where (`dx`, `dy`) is in [`OFFSETS`].
#[inline]
fn neighbour(dx: isize, dy: usize) -> usize {
    if dy == 0 { dx as usize } else { (5 * dy).wrapping_add_signed(dx) }
}

/// Each colour less the window's mean, whitened: divided by the Cholesky factor of the regularised
/// covariance, so that the product of two is that with its inverse. Entries stay below 3, and L stays
/// positive in f32 however small epsilon is.
fn whitened(window: &[[f32; 3]; 9], epsilon: f32) -> [[f32; 3]; 9] {
    let mut mean = [0.0_f64; 3];
    for color in window {
        for (m, &c) in mean.iter_mut().zip(color) {
            *m += f64::from(c) / 9.0;
        }
    }
    let from_mean = window.map(|c| [0, 1, 2].map(|i| f64::from(c[i]) - mean[i]));
    let floor = f64::from(epsilon) / 9.0;
    let [mut xx, mut xy, mut xz, mut yy, mut yz, mut zz] = [floor, 0.0, 0.0, floor, 0.0, floor];
    for [x, y, z] in &from_mean {
        xx += x * x / 9.0;
        xy += x * y / 9.0;
        xz += x * z / 9.0;
        yy += y * y / 9.0;
        yz += y * z / 9.0;
        zz += z * z / 9.0;
    }
    let a = 1.0 / xx.sqrt();
    let (b, c) = (xy * a, xz * a);
    let d = 1.0 / (yy - b * b).max(floor).sqrt();
    let e = (yz - b * c) * d;
    let f = 1.0 / (zz - c * c - e * e).max(floor).sqrt();
    from_mean.map(|[x, y, z]| {
        let x = x * a;
        let y = (y - b * x) * d;
        let z = (z - c * x - e * y) * f;
        [x as f32, y as f32, z as f32]
    })
}

/// Inverse of a symmetric positive 3 × 3 matrix given as xx, xy, xz, yy, yz, zz.
pub(super) fn inverse(m: &[f64; 6]) -> [f64; 6] {
    let [xx, xy, xz, yy, yz, zz] = *m;
    let a = yy * zz - yz * yz;
    let b = xz * yz - xy * zz;
    let c = xy * yz - xz * yy;
    let scale = 1.0 / (xx * a + xy * b + xz * c);
    let d = xx * zz - xz * xz;
    let e = xy * xz - xx * yz;
    let f = xx * yy - xy * xy;
    [a * scale, b * scale, c * scale, d * scale, e * scale, f * scale]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn colors(width: usize, height: usize) -> Colors {
        let value = |i: usize, k: usize| ((i * (7 + 5 * k) + i * i * 3) % 11) as f32 / 11.0;
        let rgb = (0..width * height).map(|i| [value(i, 0), value(i, 1), value(i, 2)]).collect();
        Colors { width, height, rgb }
    }

    fn product(laplacian: &Laplacian, alpha: impl Fn(usize, usize) -> f32) -> Vec<f32> {
        let layout = laplacian.layout;
        let mut v = vec![0.0; layout.len()];
        for y in 0..layout.height {
            for x in 0..layout.width {
                v[layout.index(x, y)] = alpha(x, y);
            }
        }
        let mut out = vec![0.0; layout.width * layout.height];
        for (y, row) in out.chunks_mut(layout.width).enumerate() {
            laplacian.product(&v, y, row);
        }
        out
    }

    #[test]
    fn alphas_linear_in_colour_cost_nothing() {
        let colors = colors(8, 6);
        let unknown = vec![1.0; Layout { width: 8, height: 6 }.len()];
        let laplacian = Laplacian::new(&colors, &unknown, 1e-7);
        let linear = |x: usize, y: usize| {
            let c = colors.rgb[y * 8 + x];
            0.2 + 0.5 * c[0] - 0.3 * c[1] + 0.1 * c[2]
        };
        for value in product(&laplacian, linear) {
            assert!(value.abs() < 1e-4, "{value}");
        }
    }

    #[test]
    fn the_product_is_that_of_the_definition() {
        let (w, h) = (6_usize, 5_usize);
        let colors = colors(w, h);
        let laplacian =
            Laplacian::new(&colors, &vec![1.0; Layout { width: w, height: h }.len()], 1e-3);
        let alpha = |x: usize, y: usize| ((x * 3 + y * 5) % 7) as f32 / 7.0;
        // Window by window: alpha less its ridge regression on colour.
        let mut expected = vec![0.0_f32; w * h];
        for cy in 1..h - 1 {
            for cx in 1..w - 1 {
                let at: Vec<_> = (0..9).map(|j| (cx + j % 3 - 1, cy + j / 3 - 1)).collect();
                let window: [[f32; 3]; 9] =
                    std::array::from_fn(|j| colors.rgb[at[j].1 * w + at[j].0]);
                let d = whitened(&window, 1e-3);
                for i in 0..9 {
                    for j in 0..9 {
                        let dot: f32 = (0..3).map(|k| d[i][k] * d[j][k]).sum();
                        let own = if i == j { 1.0 } else { 0.0 };
                        let entry = own - (1.0 + dot) / 9.0;
                        expected[at[i].1 * w + at[i].0] += entry * alpha(at[j].0, at[j].1);
                    }
                }
            }
        }
        for (found, expected) in product(&laplacian, alpha).iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-4, "{found} {expected}");
        }
    }
}
