//! How much of an instance is seen: its sample points against a depth buffer (§7.4).
//!
//! The paper tests the points of the iso-surface against the depth buffer of the previous frame. We do the
//! same, and depart in three things:
//!
//! * A tree would hide the back of its own crown, and half of it would always count as hidden. Points on the
//!   back are mirrored to the front, where they cover the same pixel, and all are drawn a little towards the
//!   eye: only what stands before the crown can hide it.
//! * Four points of each instance are tested in a frame, in turn; the last answers of all are kept as bits.
//!   An instance that comes into view has all tested at once, one that is small on the screen four in
//!   every other frame.
//! * An eye within or near the crown sees all of it.
//!
//! Cost: about 30 ns for four points.

use super::eye::{Eye, Lens};
use super::scene::{Kept, LANES, Row};
use crate::error::{LodError, Result};
use glam::{Vec3, Vec4};
use std::ops::Range;

/// Points are drawn towards the eye by this share of the crown's radius, for leaves stand out of the
/// iso-surface and crowns are not quite symmetric.
const SLACK: f32 = 0.25;
/// An eye nearer to the crown's centre than this many of its radii sees all of it.
const CLOSE: f32 = 2.0;
/// Widest and highest depth buffer.
const SIZE_MAX: u32 = 1 << 15;

/// Depths of an engine, of the previous frame or some frames ago, at any resolution: 256 × 144 do.
#[derive(Clone, Copy, Debug)]
pub struct DepthBuffer<'a> {
    /// Depth of each pixel from 0 to 1, row by row.
    pub depths: &'a [f32],
    /// Pixels in a row, 1 to 32,768.
    pub width: u32,
    /// Rows, 1 to 32,768.
    pub height: u32,
    /// The camera the depths were drawn with; it tells whether depth is reversed.
    pub eye: Eye,
    /// Whether the first row lies at clip y = −w, as in Vulkan and OpenGL; otherwise it lies at +w, as in
    /// Direct3D, Metal and WebGPU.
    pub y_down: bool,
}

impl DepthBuffer<'_> {
    /// Checks size and camera.
    ///
    /// # Errors
    /// [`LodError::Scene`] for depths that do not fill the size, [`LodError::Camera`].
    pub fn validate(&self) -> Result<()> {
        self.screen().map(|_| ())
    }

    pub(super) fn screen(&self) -> Result<Screen<'_>> {
        let sides = 1..=SIZE_MAX;
        if !sides.contains(&self.width) || !sides.contains(&self.height) {
            let problem = "width and height must be 1 to 32,768";
            return Err(LodError::Scene { what: "depth buffer", row: 0, problem });
        }
        if self.depths.len() as u64 != u64::from(self.width) * u64::from(self.height) {
            let (row, problem) = (self.depths.len(), "so many depths do not fill width × height");
            return Err(LodError::Scene { what: "depth buffer", row, problem });
        }
        let lens = self.eye.lens()?;
        let (z, greater) = (lens.rows[2], lens.reversed);
        Ok(Screen::new(lens, z, greater, self.depths, [self.width, self.height], self.y_down))
    }
}

/// Depths, and how points get onto them.
#[derive(Debug)]
pub(super) struct Screen<'a> {
    pub(super) lens: Lens,
    /// Pixel x · w, pixel y · w, depth · w and w of a position relative to the eye.
    pub(super) rows: [Vec4; 4],
    /// 1 where greater depths are nearer, −1 where they are farther.
    sign: f32,
    depths: &'a [f32],
    width: f32,
    height: f32,
}

impl<'a> Screen<'a> {
    /// `z` is depth · w of a position relative to the eye.
    pub(super) fn new(
        lens: Lens,
        z: Vec4,
        greater_is_nearer: bool,
        depths: &'a [f32],
        size: [u32; 2],
        y_down: bool,
    ) -> Self {
        let [width, height] = size.map(|side| side as f32);
        let rows = pixel_rows(&lens, z, [width, height], y_down);
        let sign = if greater_is_nearer { 1.0 } else { -1.0 };
        Self { lens, rows, sign, depths, width, height }
    }

    /// Answers for an instance: bits of the points that are seen. Those of `groups` of four are tested, the
    /// others kept from `before`.
    #[inline]
    pub(super) fn test(&self, model: &Kept, row: &Row, before: u64, groups: Range<usize>) -> u64 {
        let relative = row.crown - self.lens.position;
        let distance = relative.length();
        if self.lens.perspective && distance < CLOSE * row.crown_radius {
            return u64::MAX;
        }
        let towards = self.lens.towards(relative, distance);
        let mut seen = before;
        for group in groups {
            let Some(points) = model.points.get(group) else { break };
            let bits = self.test_four(points, row, relative, towards);
            let shift = group * LANES;
            seen = seen & !(0xf << shift) | bits << shift;
        }
        seen
    }

    /// Bits of four points, relative to the crown's centre in the model's space.
    #[inline]
    fn test_four(&self, points: &[[f32; LANES]; 3], row: &Row, at: Vec3, towards: Vec3) -> u64 {
        let [x, y, z] = turned(points, row, at, towards);
        let clip = self.rows.map(|r| four(|i| r.x * x[i] + r.y * y[i] + r.z * z[i] + r.w));
        let per_w = four(|i| 1.0 / clip[3][i]);
        let [px, py, pz] = [clip[0], clip[1], clip[2]].map(|c| four(|i| c[i] * per_w[i]));
        let hidden = |i: usize| u64::from(!self.hides(px[i], py[i], pz[i], clip[3][i])) << i;
        (0..LANES).map(hidden).sum()
    }

    /// Whether the pixel is nearer than this depth. What is outside or behind is seen, and so is what
    /// a NaN hides.
    #[inline]
    fn hides(&self, x: f32, y: f32, z: f32, w: f32) -> bool {
        let inside = x >= 0.0 && x < self.width && y >= 0.0 && y < self.height && w > 0.0;
        if !inside {
            return false;
        }
        let at = y as usize * self.width as usize + x as usize;
        self.depths.get(at).is_some_and(|&depth| (depth - z) * self.sign > 0.0)
    }
}

/// Four points relative to the eye, on the crown's front and a little before it.
#[inline]
fn turned(points: &[[f32; LANES]; 3], row: &Row, at: Vec3, towards: Vec3) -> [[f32; LANES]; 3] {
    let [a, b, c] = [row.linear.x_axis, row.linear.y_axis, row.linear.z_axis];
    let [u, v, w] = points;
    let x = four(|i| a.x * u[i] + b.x * v[i] + c.x * w[i]);
    let y = four(|i| a.y * u[i] + b.y * v[i] + c.y * w[i]);
    let z = four(|i| a.z * u[i] + b.z * v[i] + c.z * w[i]);
    let ahead = four(|i| x[i] * towards.x + y[i] * towards.y + z[i] * towards.z);
    let slack = SLACK * row.crown_radius;
    let pull = four(|i| ahead[i].abs() - ahead[i] + slack);
    [
        four(|i| at.x + x[i] + towards.x * pull[i]),
        four(|i| at.y + y[i] + towards.y * pull[i]),
        four(|i| at.z + z[i] + towards.z * pull[i]),
    ]
}

/// The same for each of four.
#[inline]
fn four(value: impl Fn(usize) -> f32) -> [f32; LANES] {
    [value(0), value(1), value(2), value(3)]
}

/// Clip rows with the viewport in them.
pub(super) fn pixel_rows(lens: &Lens, z: Vec4, size: [f32; 2], y_down: bool) -> [Vec4; 4] {
    let [x, y, _, w] = lens.rows;
    let up = if y_down { 0.5 } else { -0.5 };
    [(0.5 * x + 0.5 * w) * size[0], (up * y + 0.5 * w) * size[1], z, w]
}
