//! What of a leaf's picture is visible: its extent in bands from the base to the apex.
//!
//! Leaves stand upright in their pictures, so one span a band describes them well, and a polygon
//! between a left and a right chain does not cross itself.

use crate::error::Result;
use crate::mesh::{Alpha, Material, Texture};
use glam::Vec2;

/// Most bands: finer than any polygon of 64 vertices needs.
const BANDS_MAX: u32 = 256;

/// Visible extent in bands, in a unit square with the base of the leaf at the bottom.
#[derive(Clone, Debug)]
pub(crate) struct Cover {
    /// Left and right end of each band, from the lowest visible one to the highest.
    spans: Vec<(f32, f32)>,
    /// Lower end of the first band.
    low: f32,
    /// Height of a band.
    step: f32,
    /// Width of a pixel.
    pixel: f32,
    /// Share of the pixels that can be seen.
    pub(crate) visible: f32,
}

impl Cover {
    /// `None` when the material has no mask, or its mask cuts all away.
    ///
    /// # Errors
    /// [`MeshError::Texture`](crate::MeshError::Texture) when the pixels do not fill the picture.
    pub(crate) fn of(material: &Material) -> Result<Option<Self>> {
        let (Some(texture), Alpha::Mask(cutoff)) = (&material.texture, material.alpha) else {
            return Ok(None);
        };
        texture.check()?;
        let limit = 255.0 * cutoff / material.base_color[3].max(1e-6);
        Ok(Self::of_pixels(texture, limit))
    }

    fn of_pixels(texture: &Texture, limit: f32) -> Option<Self> {
        let n_bands = texture.height.min(BANDS_MAX);
        let row_bytes = 4 * texture.width as usize;
        let mut bands: Vec<Option<(usize, usize)>> = vec![None; n_bands as usize];
        let mut n_visible = 0_usize;
        for (row, pixels) in texture.pixels.chunks_exact(row_bytes).rev().enumerate() {
            let seen = |p: &[u8]| f32::from(p[3]) >= limit;
            let count = pixels.chunks_exact(4).filter(|p| seen(p)).count();
            n_visible += count;
            let first = pixels.chunks_exact(4).position(seen);
            let last = pixels.chunks_exact(4).rposition(seen);
            let number = row as u64 * u64::from(n_bands) / u64::from(texture.height);
            if let (Some(a), Some(b), Some(band)) = (first, last, bands.get_mut(number as usize)) {
                *band = Some(band.map_or((a, b), |(left, right)| (left.min(a), right.max(b))));
            }
        }
        let first = bands.iter().position(Option::is_some)?;
        let last = bands.iter().rposition(Option::is_some)?;
        let pixel = 1.0 / texture.width as f32;
        let mut spans: Vec<(f32, f32)> = Vec::with_capacity(last - first + 1);
        for band in &bands[first..=last] {
            // An empty band between others asks for nothing: it takes what the one below has.
            let span = match band {
                Some((a, b)) => (*a as f32 * pixel, (*b + 1) as f32 * pixel),
                None => spans.last().copied().unwrap_or((0.5, 0.5)),
            };
            spans.push(span);
        }
        let step = 1.0 / n_bands as f32;
        let n_pixels = f64::from(texture.width) * f64::from(texture.height);
        let visible = (n_visible as f64 / n_pixels) as f32;
        Some(Self { spans, low: first as f32 * step, step, pixel, visible })
    }

    /// How far the visible part reaches from the middle of the picture.
    pub(crate) fn reach(&self) -> Reach {
        let n = self.spans.len();
        let mut reach = Reach::default();
        for k in 0..=n {
            // Two bands to each side: one for the line between boundaries, one for the pixel around.
            let near = [k.saturating_sub(2), k.saturating_sub(1), k, k + 1];
            let near = near.map(|i| self.spans.get(i.min(n - 1)).copied().unwrap_or((0.5, 0.5)));
            let left = near.iter().fold(0.5_f32, |least, span| least.min(span.0));
            let right = near.iter().fold(0.5_f32, |most, span| most.max(span.1));
            let bands = match k {
                0 => -1.0,
                _ if k == n => (k + 1) as f32,
                _ => k as f32,
            };
            reach.heights.push((self.low + bands * self.step).clamp(0.0, 1.0));
            reach.left.push((0.5 - left + self.pixel).min(0.5));
            reach.right.push((right - 0.5 + self.pixel).min(0.5));
        }
        reach
    }

    /// The right side of the margin itself, from the middle: the mean of both sides, neither wider nor
    /// narrower.
    pub(crate) fn margin(&self) -> Vec<Vec2> {
        let width = |span: &(f32, f32)| (0.5 * (span.1 - span.0)).clamp(0.0, 0.5);
        let n = self.spans.len();
        let middles = (0..n).map(|k| (k, k as f32 + 0.5));
        let places =
            std::iter::once((0, 0.0)).chain(middles).chain([(n.saturating_sub(1), n as f32)]);
        let chain = places.map(|(band, height)| {
            let width = self.spans.get(band).map_or(0.0, width);
            Vec2::new(width, self.low + height * self.step)
        });
        chain.collect()
    }
}

/// Distances from the middle of the picture, at the boundaries of bands from low to high: so wide
/// that straight lines between them hold all that is visible and a pixel around it (filtered textures
/// reach that far).
#[derive(Clone, Debug, Default)]
pub(crate) struct Reach {
    pub(crate) heights: Vec<f32>,
    pub(crate) left: Vec<f32>,
    pub(crate) right: Vec<f32>,
}

/// Joins both ends of a chain to the midrib.
pub(crate) fn close(chain: Vec<Vec2>) -> Vec<Vec2> {
    let foot = |p: Option<&Vec2>| Vec2::new(0.0, p.map_or(0.0, |p| p.y));
    let (first, last) = (foot(chain.first()), foot(chain.last()));
    std::iter::once(first).chain(chain).chain(std::iter::once(last)).collect()
}
