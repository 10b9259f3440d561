//! Planes of numbers and what livewire asks of them: Gaussian blurs and shares of values.

/// One number for each working pixel, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) values: Vec<f32>,
}

/// Radius of a Gaussian kernel in standard deviations: beyond it the weight is under 2 %.
const KERNEL_REACH: f32 = 2.8;

impl Plane {
    pub(super) fn new(width: usize, height: usize) -> Self {
        Self { width, height, values: vec![0.0; width * height] }
    }

    /// A plane of the same size with another value for each.
    pub(super) fn map(&self, change: impl Fn(f32) -> f32) -> Self {
        let values = self.values.iter().map(|&value| change(value)).collect();
        Self { width: self.width, height: self.height, values }
    }

    /// A plane of what `join` makes of the values of two.
    pub(super) fn zip(&self, other: &Self, join: impl Fn(f32, f32) -> f32) -> Self {
        let values = self.values.iter().zip(&other.values).map(|(&a, &b)| join(a, b)).collect();
        Self { width: self.width, height: self.height, values }
    }

    /// Blurred with a Gaussian of `sigma` pixels. Outside, the border goes on.
    ///
    /// O(pixels · sigma).
    pub(super) fn blur(&self, sigma: f32) -> Self {
        let reach = (KERNEL_REACH * sigma).ceil().max(1.0) as usize;
        let mut kernel: Vec<f32> = (0..=2 * reach)
            .map(|i| {
                let t = (i as f32 - reach as f32) / sigma.max(1e-3);
                libm::expf(-0.5 * t * t)
            })
            .collect();
        let sum: f32 = kernel.iter().sum();
        kernel.iter_mut().for_each(|weight| *weight /= sum);
        self.blur_rows(&kernel, reach).blur_columns(&kernel, reach)
    }

    fn blur_rows(&self, kernel: &[f32], reach: usize) -> Self {
        let mut out = Self::new(self.width, self.height);
        let mut padded = vec![0.0; self.width + 2 * reach];
        let rows = self.values.chunks_exact(self.width);
        for (row, into) in rows.zip(out.values.chunks_exact_mut(self.width)) {
            for (i, value) in padded.iter_mut().enumerate() {
                *value = row[i.saturating_sub(reach).min(self.width - 1)];
            }
            for (shift, &weight) in kernel.iter().enumerate() {
                for (value, &from) in into.iter_mut().zip(&padded[shift..]) {
                    *value += weight * from;
                }
            }
        }
        out
    }

    fn blur_columns(&self, kernel: &[f32], reach: usize) -> Self {
        let mut out = Self::new(self.width, self.height);
        for (y, into) in out.values.chunks_exact_mut(self.width).enumerate() {
            for (shift, &weight) in kernel.iter().enumerate() {
                let from = (y + shift).saturating_sub(reach).min(self.height - 1);
                let row = &self.values[from * self.width..][..self.width];
                for (value, &from) in into.iter_mut().zip(row) {
                    *value += weight * from;
                }
            }
        }
        out
    }

    /// The value below which `share` of those lie whose `weight` is over one half; 0 without any.
    pub(super) fn percentile(&self, weight: &Self, share: f32) -> f32 {
        let mut values: Vec<f32> = self
            .values
            .iter()
            .zip(&weight.values)
            .filter(|&(_, &weight)| weight > 0.5)
            .map(|(&value, _)| value)
            .collect();
        if values.is_empty() {
            return 0.0;
        }
        let rank = (share * (values.len() - 1) as f32) as usize;
        *values.select_nth_unstable_by(rank, f32::total_cmp).1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blur_keeps_the_sum_and_the_middle() {
        let mut plane = Plane::new(31, 31);
        plane.values[15 * 31 + 15] = 1.0;
        let blurred = plane.blur(2.0);
        let sum: f32 = blurred.values.iter().sum();
        assert!((sum - 1.0).abs() < 1e-4, "{sum}");
        let top = blurred.values.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        assert_eq!(top.0, 15 * 31 + 15);
        // The peak of a Gaussian in two dimensions.
        assert!((top.1 - 1.0 / (2.0 * std::f32::consts::PI * 4.0)).abs() < 2e-3);
    }

    #[test]
    fn planes_of_one_pixel_can_be_blurred() {
        let mut plane = Plane::new(1, 1);
        plane.values[0] = 0.5;
        assert!((plane.blur(9.0).values[0] - 0.5).abs() < 1e-5);
        assert_eq!(plane.percentile(&plane, 0.5), 0.0);
    }
}
