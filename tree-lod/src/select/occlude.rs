//! The built-in occlusion pass, for when there is no depth buffer: occluders of the models, drawn into a small
//! one on the processor.
//!
//! An ellipsoid is drawn as the ellipse it projects to, at the depth of its centre: what lies behind the
//! centre is hidden, what lies before it is not. Tiles come front to back, so that when the pass has
//! drawn as many pixels as it may, the farthest trees are those that hide nothing.
//!
//! Cost: about a nanosecond for four pixels, and 30 for an ellipsoid.

use super::eye::Lens;
use super::scene::{Kept, Row};
use super::visible::{Screen, pixel_rows};
use glam::{Vec2, Vec3, Vec4};

/// Size of the buffer in pixels.
const SIZE: [u32; 2] = [256, 144];
/// Pixels that may be drawn in a frame: each pixel of the buffer so many times.
const OVERDRAW: usize = 12;
/// Ellipses with a smaller half axis, in pixels, are left out.
const SMALLEST: f32 = 1.0;
/// An ellipsoid must be so many times its largest radius ahead of the eye: nearer, it is no ellipse.
const AHEAD: f32 = 1.1;

/// The buffer; greater is nearer.
#[derive(Clone, Debug)]
pub(super) struct Occluders {
    depths: Vec<f32>,
    left: usize,
}

impl Occluders {
    pub(super) fn new() -> Self {
        Self { depths: vec![0.0; (SIZE[0] * SIZE[1]) as usize], left: 0 }
    }

    /// A pass begins.
    pub(super) fn clear(&mut self) -> bool {
        self.depths.fill(f32::NEG_INFINITY);
        self.left = OVERDRAW * self.depths.len();
        true
    }

    /// The finished buffer.
    pub(super) fn screen(&self, lens: Lens) -> Screen<'_> {
        Screen::new(lens, nearness(&lens), true, &self.depths, SIZE, false)
    }

    /// Where positions relative to the eye fall.
    pub(super) fn rows(lens: &Lens) -> [Vec4; 4] {
        pixel_rows(lens, nearness(lens), SIZE.map(|side| side as f32), false)
    }

    /// Draws what an instance hides others with.
    pub(super) fn draw(&mut self, model: &Kept, row: &Row, eye: Vec3, rows: &[Vec4; 4]) {
        if !large(model, row, eye, rows) {
            return;
        }
        for occluder in &model.occluders {
            if self.left == 0 {
                return;
            }
            let center = row.position - eye + row.linear * occluder.center;
            let axes = [
                row.linear.x_axis * occluder.radii.x,
                row.linear.y_axis * occluder.radii.y,
                row.linear.z_axis * occluder.radii.z,
            ];
            let ellipse = Ellipse::of(center, axes, rows);
            if let Some(ellipse) = ellipse.filter(|ellipse| !self.hides(ellipse)) {
                self.fill(&ellipse);
            }
        }
    }

    /// Whether centre and ends of an ellipse are behind what is drawn already: most are, in a forest, and
    /// would add next to nothing.
    fn hides(&self, ellipse: &Ellipse) -> bool {
        let (right, up) = (Vec2::X * ellipse.xx.sqrt(), Vec2::Y * ellipse.yy.sqrt());
        let last = Vec2::new(SIZE[0] as f32 - 1.0, SIZE[1] as f32 - 1.0);
        [Vec2::ZERO, right, -right, up, -up].into_iter().all(|end| {
            let pixel = (ellipse.center + 0.9 * end).clamp(Vec2::ZERO, last);
            let at = pixel.y as usize * SIZE[0] as usize + pixel.x as usize;
            self.depths.get(at).is_some_and(|&depth| depth > ellipse.near)
        })
    }

    fn fill(&mut self, ellipse: &Ellipse) {
        let [width, height] = SIZE.map(|side| side as f32);
        let Ellipse { center, xx, xy, yy, near } = *ellipse;
        let half = yy.sqrt();
        // Pixels count when their centres are inside. Casts bring what is negative to 0.
        let first = (center.y - half + 0.5) as usize;
        let end = (center.y + half + 0.5).min(height) as usize;
        let (slope, across) = (xy / yy, xx - xy * xy / yy);
        for y in first..end {
            let up = y as f32 + 0.5 - center.y;
            let middle = center.x + slope * up;
            let reach = (across * (1.0 - up * up / yy)).max(0.0).sqrt();
            let from = (middle - reach + 0.5).min(width) as usize;
            let to = (middle + reach + 0.5).min(width) as usize;
            let start = y * SIZE[0] as usize;
            let Some(span) = self.depths.get_mut(start + from..start + to.max(from)) else {
                return;
            };
            for depth in span.iter_mut() {
                *depth = if near > *depth { near } else { *depth };
            }
            self.left = self.left.saturating_sub(to.saturating_sub(from) + 1);
        }
    }
}

/// Whether any occluder of an instance may be large enough: the radius of a sphere around them all, in pixels.
#[inline]
fn large(model: &Kept, row: &Row, eye: Vec3, rows: &[Vec4; 4]) -> bool {
    let w = rows[3].dot((row.crown - eye).extend(1.0));
    let across = rows[1].truncate().length_squared();
    let size = model.widest / row.per_scale;
    // Twice, for the occluders are not where the crown's centre is, and the rows slant.
    4.0 * size * size * across >= SMALLEST * SMALLEST * w * w
}

/// Depth · w that is greater for nearer things: 1 / distance in perspective, −distance otherwise.
fn nearness(lens: &Lens) -> Vec4 {
    if lens.perspective { Vec4::W } else { (-lens.forward).extend(0.0) }
}

/// Pixels p with (p − center)ᵀ C⁻¹ (p − center) ≤ 1, C = [xx xy; xy yy].
struct Ellipse {
    center: Vec2,
    xx: f32,
    xy: f32,
    yy: f32,
    near: f32,
}

impl Ellipse {
    /// To first order, which is a little smaller than what an ellipsoid covers in perspective. None for one
    /// that is too near, too small or not in the picture.
    fn of(center: Vec3, axes: [Vec3; 3], rows: &[Vec4; 4]) -> Option<Self> {
        let at = center.extend(1.0);
        let [x, y, z, w] = rows.map(|row| row.dot(at));
        let radius = axes.iter().map(|axis| axis.length_squared()).fold(0.0, f32::max).sqrt();
        let per_metre = rows[3].truncate().length();
        let ahead = w > AHEAD * radius * per_metre;
        if !ahead {
            return None;
        }
        let center = Vec2::new(x, y) / w;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for axis in axes {
            let [ax, ay, _, aw] = rows.map(|row| row.truncate().dot(axis));
            let step = (Vec2::new(ax, ay) - center * aw) / w;
            (xx, xy, yy) = (xx + step.x * step.x, xy + step.x * step.y, yy + step.y * step.y);
        }
        let least = SMALLEST * SMALLEST;
        let large = xx >= least && yy >= least && xx * yy - xy * xy >= least * least;
        (large && xx.max(yy) < 1e12 && center.is_finite()).then_some(Self {
            center,
            xx,
            xy,
            yy,
            near: z / w,
        })
    }
}
