//! Bark: a height and a colour from layers of periodic noise, then light baked from the height.
//!
//! 1. The point is shifted by low noise, so that nothing runs straight (domain warping).
//! 2. Height: plates are cells with cracks between them; furrows follow the zero lines of noise
//!    stretched along the trunk, which meander and join as fissures do; flakes are terraces of noise;
//!    grain is fine noise.
//! 3. Colour: furrow to ridge by height, tinted by slow noise and by plate; rings, patches and
//!    lenticels lie on top.
//! 4. Light: a point below the mean height of its surroundings is darker (cavity), a slope that
//!    looks up the trunk is lighter. Light from the side is left out: it would be wrong on
//!    the other side of the trunk.

use super::noise::{Count, Noise, fraction, mix, smoothstep, split, unit};
use super::raster::{Rgb, blend, rgb, to_bytes};
use crate::Texture;
use rayon::prelude::*;
use std::borrow::Cow;
use tree_core::Seed;

/// What bark looks like. One tile of the texture is meant for 0.5 to 1 metre of trunk; counts are
/// per tile and 0 switches a layer off, so do strengths of 0.
///
/// ```
/// use tree_mesh::texture::{BarkStyle, bark_with};
/// let red = BarkStyle { ridge: [150, 90, 70], furrows: [9, 2], ..Default::default() };
/// assert_eq!(bark_with(&red, 64).unwrap().width, 64);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BarkStyle {
    /// Where the noise starts: another seed is another piece of the same bark.
    pub seed: Seed,
    /// sRGB colour of the ridges. Default a grey brown.
    pub ridge: [u8; 3],
    /// sRGB colour of the depths of cracks and furrows. Default a dark brown.
    pub furrow: [u8; 3],
    /// sRGB colour that slow noise mixes in.
    pub tint: [u8; 3],
    /// How much of [`tint`](Self::tint) is mixed in at most, 0 to 1. Default 0.3.
    pub tinting: f32,
    /// Plates across and along, 0 to 256. Default none.
    pub plates: [u32; 2],
    /// Width of the cracks between plates, in widths of a plate, 0 to 1. Default 0.2.
    pub crack: f32,
    /// How much brightness differs from plate to plate, 0 to 1. Default 0.15.
    pub plate_contrast: f32,
    /// Waves of the noise whose zero lines are furrows, across and along, 0 to 256. Default 8, 2.
    pub furrows: [u32; 2],
    /// Width of the furrows, as height of that noise, 0 to 1. Default 0.3.
    pub furrow_width: f32,
    /// Depth of the furrows, 0 to 1. Default 1.
    pub furrow_depth: f32,
    /// How ragged edges are, 0 to 1. Default 0.4.
    pub ragged: f32,
    /// How far points are shifted, in tiles, 0 to 0.5. Default 0.03.
    pub warp: f32,
    /// Strength of the flakes, thin layers with stepped edges, 0 to 1. Default 0.
    pub flakes: f32,
    /// Waves of the finest layer across and along, 0 to 256. Default 24, 12.
    pub grain: [u32; 2],
    /// Height of the grain, 0 to 1. Default 0.3.
    pub grain_height: f32,
    /// Rings around the trunk, waves along a tile, 0 to 256. Default 0.
    pub rings: u32,
    /// Strength of the rings, 0 to 1. Default 0.3.
    pub ring_contrast: f32,
    /// Spots of another colour, drawn in order (lichen, peeling, old bark). At most 16. Default none.
    pub patches: Cow<'static, [Patches]>,
    /// Short dark lines across the trunk, as on birch and cherry. Default none.
    pub lenticels: Option<Lenticels>,
    /// Strength of the baked light, 0 to 3. Default 1.
    pub relief: f32,
}

/// Spots of another colour on bark. Laid out as C does.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patches {
    /// sRGB colour.
    pub color: [u8; 3],
    /// Waves of the noise that shapes them, across and along, 1 to 256.
    pub count: [u32; 2],
    /// Share of the bark they cover, roughly, 0 to 1.
    pub share: f32,
    /// Width of their edges, 0.01 (hard) to 1.
    pub softness: f32,
    /// How much of the colour below they hide, 0 to 1.
    pub opacity: f32,
    /// How rough their surface is, 0 to 1: dark cracks along the trunk.
    pub roughness: f32,
}

/// Short lines across the trunk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lenticels {
    /// sRGB colour.
    pub color: [u8; 3],
    /// Places for one, across and along, 1 to 256.
    pub count: [u32; 2],
    /// Share of the places taken, 0 to 1.
    pub share: f32,
    /// Length of the longest, in places, 0 to 1.
    pub length: f32,
    /// Thickness of the thickest, in places, 0 to 1.
    pub thickness: f32,
}

impl BarkStyle {
    pub(super) const DEFAULT: Self = Self {
        seed: Seed(0),
        ridge: [134, 122, 106],
        furrow: [48, 39, 32],
        tint: [112, 110, 88],
        tinting: 0.3,
        plates: [0, 0],
        crack: 0.2,
        plate_contrast: 0.15,
        furrows: [8, 2],
        furrow_width: 0.3,
        furrow_depth: 1.0,
        ragged: 0.4,
        warp: 0.03,
        flakes: 0.0,
        grain: [24, 12],
        grain_height: 0.3,
        rings: 0,
        ring_contrast: 0.3,
        patches: Cow::Borrowed(&[]),
        lenticels: None,
        relief: 1.0,
    };
}

impl Default for BarkStyle {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Height 0 to about 1 and colour of one pixel before light.
#[derive(Clone, Copy, Default)]
struct Sample {
    height: f32,
    color: Rgb,
}

/// The noises and colours of one style, ready to be sampled.
struct Layers<'a> {
    style: &'a BarkStyle,
    warp: Noise,
    plates: Noise,
    furrows: Noise,
    grain: Noise,
    tint: Noise,
    spots: Noise,
    marks: Noise,
}

/// Draws a style whose ranges were checked.
pub(super) fn draw(style: &BarkStyle, name: &str, size: u32) -> Texture {
    let noise = |layer| Noise::new(style.seed, layer);
    let layers = Layers {
        style,
        warp: noise("warp"),
        plates: noise("plates"),
        furrows: noise("furrows"),
        grain: noise("grain"),
        tint: noise("tint"),
        spots: noise("patches"),
        marks: noise("lenticels"),
    };
    let n = size as usize;
    let slow = layers.slow_grid();
    let mut samples = vec![Sample::default(); n * n];
    samples.par_chunks_mut(n).enumerate().for_each(|(y, row)| {
        for (x, sample) in row.iter_mut().enumerate() {
            let at = |i: usize| (i as f32 + 0.5) / size as f32;
            *sample = layers.sample(at(x), at(y), slow_at(&slow, at(x), at(y)));
        }
    });
    let mean = blurred_heights(&samples, n);
    let mut pixels = vec![255; 4 * n * n];
    pixels.par_chunks_mut(4 * n).enumerate().for_each(|(y, row)| {
        let (above, below) = ((y + n - 1) % n * n, (y + 1) % n * n);
        for (x, pixel) in row.chunks_exact_mut(4).enumerate() {
            let sample = samples[y * n + x];
            let cavity = (sample.height - mean[y * n + x]) * CAVITY;
            let slope = (samples[below + x].height - samples[above + x].height) * size as f32;
            let light = style.relief * (cavity.clamp(-0.6, 0.35) + slope_light(slope));
            let bytes = to_bytes(sample.color.map(|c| c * (1.0 + light).max(0.2)));
            pixel[..3].copy_from_slice(&bytes);
        }
    });
    Texture { name: name.to_owned(), width: size, height: size, pixels }
}

/// How dark a cavity of full depth is.
const CAVITY: f32 = 0.75;
/// Radius of the surroundings a cavity is measured against, in tiles.
const CAVITY_RADIUS: f32 = 0.012;
/// Shift of the most ragged edges, in tiles.
const RAGGED: f32 = 0.025;
/// Light gained per unit of slope (height per tile), and its bounds.
const SLOPE: (f32, f32) = (0.004, 0.16);

/// Shift across and along, in tiles, and a noise of few waves in about -1 to 1.
type Slow = [f32; 3];

/// Edge of the grid that slow noises are computed on; they have at most 30 waves.
const GRID: usize = 128;

/// The slow noises between the points of their grid (bilinear).
fn slow_at(grid: &[Slow], u: f32, v: f32) -> Slow {
    let (x, fx) = split(u, GRID as u32);
    let (y, fy) = split(v, GRID as u32);
    let row = |y: u32| y as usize % GRID * GRID;
    let (x0, x1) = (x as usize, (x as usize + 1) % GRID);
    let (top, low) = (row(y), row(y + 1));
    let (a, b, c, d) = (grid[top + x0], grid[top + x1], grid[low + x0], grid[low + x1]);
    [0, 1, 2].map(|k| mix(mix(a[k], b[k], fx), mix(c[k], d[k], fx), fy))
}

/// Positive where the surface looks up: there the height falls towards the top of the image.
fn slope_light(slope: f32) -> f32 {
    (SLOPE.0 * slope).clamp(-SLOPE.1, SLOPE.1)
}

/// Heights averaged over a box, wrapped around: two running sums, `O(pixels)`.
fn blurred_heights(samples: &[Sample], n: usize) -> Vec<f32> {
    let radius = ((n as f32 * CAVITY_RADIUS) as usize).clamp(1, n / 2 - 1);
    let weight = 1.0 / (2 * radius + 1) as f32;
    let mut across = vec![0.0_f32; n * n];
    across.par_chunks_mut(n).zip(samples.par_chunks(n)).for_each(|(out, row)| {
        let at = |i: usize| row[i % n].height;
        let mut sum: f32 = (0..=2 * radius).map(|i| at(n - radius + i)).sum();
        for (x, out) in out.iter_mut().enumerate() {
            *out = sum * weight;
            sum += at(x + radius + 1) - at(x + n - radius);
        }
    });
    let mut both = vec![0.0_f32; n * n];
    both.par_chunks_mut(n).enumerate().for_each(|(y, out)| {
        for i in 0..=2 * radius {
            let row = (y + n - radius + i) % n * n;
            for (out, value) in out.iter_mut().zip(&across[row..row + n]) {
                *out += value * weight;
            }
        }
    });
    both
}

impl Layers<'_> {
    fn sample(&self, u: f32, v: f32, [du, dv, slow]: Slow) -> Sample {
        let style = self.style;
        let (wu, wv) = (u + du, v + dv);
        let grain = if on(style.grain) { self.grain.fbm(wu, wv, style.grain, 3) } else { 0.0 };

        let (mut height, mut shade, mut hue) = (1.0_f32, 1.0, 0.0);
        if on(style.plates) {
            let cell = self.plates.cell(wu, wv, style.plates, 0.85);
            // Cracks open and close along their way.
            let width = style.crack * (1.0 + 0.5 * slow) * (1.0 + 0.5 * grain);
            let inside = smoothstep(0.0, width.max(1e-3), cell.edge);
            height *= inside * (0.75 + 0.5 * cell.edge.min(0.5));
            shade += style.plate_contrast * (2.0 * unit(cell.id, 0) - 1.0);
            hue = unit(cell.id, 8) - 0.5;
        }
        if on(style.furrows) {
            let width = style.furrow_width.max(1e-3) * (1.0 + 0.5 * slow);
            let line = self.furrows.fbm(wu, wv, style.furrows, 2).abs();
            let inside = smoothstep(0.0, width, line + 0.35 * width * grain);
            height *= 1.0 - style.furrow_depth * (1.0 - inside);
        }
        if style.flakes > 0.0 {
            let layer = 4.0 * self.furrows.fbm(wu + 0.5, wv, [7, 5], 3) + 16.0;
            let step = fraction(layer);
            // The edge of a flake is a dark line; behind it the next one starts to rise.
            let edge = smoothstep(0.0, 0.1, step) * (1.0 - 0.4 * step);
            height *= 1.0 - style.flakes * (1.0 - edge);
            let own = unit(self.furrows.hash(layer as u32, 7), 0) - 0.5;
            shade += 0.3 * style.flakes * own;
            hue += style.flakes * own;
        }
        height *= 1.0 + style.grain_height * (grain - 0.2);

        let tint = style.tinting * smoothstep(-0.5, 0.6, slow + hue);
        let ridge = blend(rgb(style.ridge), rgb(style.tint), tint);
        let depth = smoothstep(0.0, 0.75, height);
        shade *= 1.0 + 0.22 * style.grain_height * grain;
        let mut color = blend(rgb(style.furrow), ridge, depth).map(|c| c * shade);
        if style.rings > 0 {
            let phase = fraction(v * style.rings as f32 + 0.6 * slow + 0.5);
            let scar = (phase - 0.5) * smoothstep(1.0, 0.9, phase)
                - 1.5 * smoothstep(0.12, 0.0, (phase - 0.1).abs());
            let patchy = 0.6 + self.tint.gradient(u, v, [4, style.rings]);
            let mark = style.ring_contrast * scar * patchy.max(0.0);
            color = color.map(|c| c * (1.0 + 0.4 * mark));
            height += 0.3 * mark;
        }
        for (number, patches) in (0..).zip(style.patches.iter()) {
            self.patch(patches, number, [u, v, wu, wv], grain, &mut height, &mut color);
        }
        if let Some(lenticels) = &style.lenticels {
            let mark = self.lenticel(lenticels, u, v);
            color = blend(color, rgb(lenticels.color), 0.9 * mark);
            height -= 0.3 * mark;
        }
        Sample { height, color }
    }

    /// Step 1, on a grid: slow bends, small ones that make edges ragged, and a slow noise.
    fn slow_grid(&self) -> Vec<Slow> {
        let style = self.style;
        let at = |i: usize| i as f32 / GRID as f32;
        let (warp, ragged) = (style.warp, RAGGED * style.ragged);
        let cell = |i: usize| {
            let (u, v) = (at(i % GRID), at(i / GRID));
            let bend = |u| self.warp.gradient(u, v, [4, 4]);
            let tear = |v| self.warp.fbm(u, v, [15, 11], 2);
            [
                warp * bend(u) + ragged * tear(v + 0.31),
                2.0 * warp * bend(u + 0.37) + ragged * tear(v + 0.77),
                self.tint.fbm(u, v, [3, 2], 3),
            ]
        };
        (0..GRID * GRID).into_par_iter().map(cell).collect()
    }

    fn patch(
        &self,
        patches: &Patches,
        number: u32,
        [u, v, wu, wv]: [f32; 4],
        grain: f32,
        height: &mut f32,
        color: &mut Rgb,
    ) {
        // Shifted, so that patches of different rows do not coincide.
        let shift = 0.317 * number as f32;
        let noise = self.spots.fbm(wu + shift, wv + shift, patches.count, 3);
        let threshold = 1.1 * (0.5 - patches.share);
        let soft = 0.5 * patches.softness.max(0.01);
        let mask = patches.opacity * smoothstep(threshold - soft, threshold + soft, noise);
        if mask <= 0.0 {
            return;
        }
        let cracks = self.spots.fbm(u, v, [18, 7], 3).abs();
        let crack = patches.roughness * (1.0 - smoothstep(0.0, 0.25, cracks));
        let shade = 1.0 + patches.roughness * (0.6 * grain - 0.5 * crack);
        *color = blend(*color, rgb(patches.color).map(|c| c * shade), mask);
        *height += mask * patches.roughness * (0.35 * grain - 0.5 * crack);
    }

    /// How much of a lenticel covers the point, 0 to 1. Each may reach over its neighbours' places.
    fn lenticel(&self, lenticels: &Lenticels, u: f32, v: f32) -> f32 {
        let [across, along] = lenticels.count;
        let wave = 0.15 * self.warp.gradient(u, v, [4, 4]);
        let (x, fx) = split(u, across);
        let (y, fy) = split(v + wave / along as f32, along);
        let mut most = 0.0_f32;
        for i in 0..3 {
            let h = self.marks.hash((x + across - 1 + i) % across, y);
            if unit(h, 0) >= lenticels.share {
                continue;
            }
            // Most are short: the square of a random number.
            let size = unit(h, 8) * unit(h, 8);
            let half = 0.5 * lenticels.length * mix(0.25, 1.0, size);
            let thick = 0.5 * lenticels.thickness * mix(0.45, 1.0, unit(h, 16));
            let dx = (i as f32 - 0.5 + 0.6 * (unit(h, 20) - 0.5) - fx).abs() / half;
            let dy = (0.5 + 0.6 * (unit(h, 24) - 0.5) - fy).abs() / thick;
            // A spindle: thickness falls to a third at the ends.
            let profile = 1.0 - 0.65 * dx * dx;
            most =
                most.max(smoothstep(1.0, 0.85, dx) * smoothstep(1.0, 0.6, dy / profile.max(0.1)));
        }
        most
    }
}

fn on(count: Count) -> bool {
    count[0] > 0 && count[1] > 0
}
