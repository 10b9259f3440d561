//! Polygons to pixels with antialiased edges, and colour bled into what stays transparent.
//!
//! Coverage is exact across a pixel and sampled on [`SUB_ROWS`] lines down it. Every row of pixels
//! is drawn by itself, so rows run in parallel and give the same bits for any number of threads.

use super::noise::mix;
use rayon::prelude::*;
use tree_core::glam::Vec2;

/// An sRGB colour, 0 to 1 per channel.
pub(super) type Rgb = [f32; 3];

pub(super) fn rgb(bytes: [u8; 3]) -> Rgb {
    bytes.map(|byte| f32::from(byte) * (1.0 / 255.0))
}

pub(super) fn to_bytes(color: Rgb) -> [u8; 3] {
    color.map(byte)
}

fn byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

pub(super) fn blend(a: Rgb, b: Rgb, t: f32) -> Rgb {
    [mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)]
}

/// Gives a polygon its colours.
pub(super) trait Paint: Sync {
    /// The colour at a point of the image, in pixels.
    fn color(&self, at: Vec2) -> Rgb;
    /// How much the polygon darkens what lies below; then it is a shadow and has no colour.
    fn shadow(&self) -> Option<f32>;
}

/// A closed polygon (non-zero winding) in pixels, and its paint.
pub(super) struct Item<P> {
    pub(super) outline: Vec<Vec2>,
    pub(super) paint: P,
}

/// Lines a row of pixels is sampled on.
const SUB_ROWS: usize = 4;

/// Draws the items, back to front, on a transparent square image and bleeds the colours. RGBA bytes.
pub(super) fn draw<P: Paint>(items: &[Item<P>], size: u32) -> Vec<u8> {
    let n = size as usize;
    let extents: Vec<(f32, f32)> = items
        .iter()
        .map(|item| {
            item.outline
                .iter()
                .fold((f32::MAX, f32::MIN), |(low, high), p| (low.min(p.y), high.max(p.y)))
        })
        .collect();
    let mut image = vec![[0.0_f32; 4]; n * n];
    image.par_chunks_mut(n).enumerate().for_each_init(
        || (vec![0.0_f32; n], vec![Vec::new(); SUB_ROWS]),
        |(cover, crossings), (y, row)| {
            for (item, &(low, high)) in items.iter().zip(&extents) {
                if high > y as f32 && low < (y + 1) as f32 {
                    draw_row(item, y as f32, row, cover, crossings);
                }
            }
        },
    );
    bleed(image, n)
}

/// One item on one row of pixels.
fn draw_row<P: Paint>(
    item: &Item<P>,
    y: f32,
    row: &mut [[f32; 4]],
    cover: &mut [f32],
    crossings: &mut [Vec<(f32, i32)>],
) {
    let next = item.outline.iter().cycle().skip(1);
    for (&a, &b) in item.outline.iter().zip(next) {
        if a.y.max(b.y) < y || a.y.min(b.y) > y + 1.0 {
            continue;
        }
        for (sub, line) in crossings.iter_mut().enumerate() {
            let at = y + (sub as f32 + 0.5) / SUB_ROWS as f32;
            if (a.y <= at) != (b.y <= at) {
                let x = a.x + (b.x - a.x) * ((at - a.y) / (b.y - a.y));
                line.push((x, if a.y <= at { 1 } else { -1 }));
            }
        }
    }
    let limit = row.len() as f32;
    let (mut first, mut last) = (row.len(), 0);
    for line in crossings {
        line.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let (mut winding, mut start) = (0, 0.0);
        for (x, turn) in line.drain(..) {
            let x = x.clamp(0.0, limit);
            if winding == 0 {
                start = x;
            }
            winding += turn;
            if winding == 0 && x > start {
                let (from, to) = (start as usize, (x as usize + 1).min(row.len()));
                (first, last) = (first.min(from), last.max(to));
                for (column, cover) in (from..to).zip(&mut cover[from..to]) {
                    let left = start.max(column as f32);
                    let right = x.min((column + 1) as f32);
                    *cover += (right - left).max(0.0) / SUB_ROWS as f32;
                }
            }
        }
    }
    for x in first..last {
        let share = std::mem::take(&mut cover[x]).min(1.0);
        if share <= 0.0 {
            continue;
        }
        let pixel = &mut row[x];
        if let Some(dark) = item.paint.shadow() {
            for channel in &mut pixel[..3] {
                *channel *= 1.0 - dark * share;
            }
            continue;
        }
        let color = item.paint.color(Vec2::new(x as f32 + 0.5, y + 0.5));
        let source = [color[0], color[1], color[2], 1.0];
        for (channel, source) in pixel.iter_mut().zip(source) {
            *channel = *channel * (1.0 - share) + source * share;
        }
    }
}

/// Straight-alpha bytes of a premultiplied image. A transparent pixel takes the mean colour of the
/// smallest block around it that is not empty (a pyramid of halves), so that filtering and
/// mip-maps mix in leaf colour and not black. `O(pixels)`.
fn bleed(image: Vec<[f32; 4]>, n: usize) -> Vec<u8> {
    let mut levels = vec![(image, n)];
    while let Some((fine, n)) = levels.last().filter(|(_, n)| *n > 1) {
        let half = n.div_ceil(2);
        let mut coarse = vec![[0.0_f32; 4]; half * half];
        for (y, row) in fine.chunks_exact(*n).enumerate() {
            for (x, pixel) in row.iter().enumerate() {
                let sum = &mut coarse[y / 2 * half + x / 2];
                for (sum, value) in sum.iter_mut().zip(pixel) {
                    *sum += value;
                }
            }
        }
        levels.push((coarse, half));
    }
    let mut bytes = vec![0; 4 * n * n];
    bytes.par_chunks_mut(4 * n).enumerate().for_each(|(y, row)| {
        for (x, out) in row.chunks_exact_mut(4).enumerate() {
            let pixel = levels
                .iter()
                .enumerate()
                .map(|(k, (level, n))| level[(y >> k) * n + (x >> k)])
                .find(|pixel| pixel[3] > EMPTY)
                .unwrap_or_default();
            let alpha = levels.first().map_or(0.0, |(level, n)| level[y * n + x][3]);
            let scale = 1.0 / pixel[3].max(EMPTY);
            let color = to_bytes([pixel[0] * scale, pixel[1] * scale, pixel[2] * scale]);
            out[..3].copy_from_slice(&color);
            out[3] = byte(alpha);
        }
    });
    bytes
}

/// Coverage below which a pixel counts as empty.
const EMPTY: f32 = 1.0 / 512.0;
