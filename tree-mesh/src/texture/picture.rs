//! From a leaf shape to its picture.
//!
//! 1. The whole is fitted into the image: top and sides touch the margin, the base stands at the
//!    bottom centre.
//! 2. Parts are drawn from the deepest to the nearest; a leaf throws a shadow on those below.

use super::leaf::{Blade, Brush, Frame, LeafShape, View, rays};
use super::noise::Noise;
use super::raster::{Item, draw, rgb};
use super::spray::{Layered, Part, parts};
use super::{LeafTexture, outline};
use crate::Texture;
use tree_core::glam::Vec2;

/// Draws a shape whose ranges were checked.
pub(super) fn draw_leaf(shape: &LeafShape, name: &str, size: u32) -> LeafTexture {
    let (mut parts, petiole) = parts(shape);
    parts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let polygon = outline::polygon(shape);
    let (view, width) = fit(&mut parts, &polygon, shape, size);
    let rays = rays(&shape.veins);
    let noise = Noise::new(shape.seed, "mottle");
    let shadows = shape.spray.as_ref().is_some_and(|spray| spray.leaves <= SHADOWS);
    let mut items = Vec::with_capacity(3 * parts.len());
    for (_, part) in &parts {
        match *part {
            Part::Stem { from, to, widths, color } => {
                let frame = Frame { origin: from, axis: to - from, squash: 1.0, bend: 0.0 };
                let right = -(to - from).normalize_or_zero().perp();
                let corners = [
                    from - right * (0.5 * widths[0]),
                    from + right * (0.5 * widths[0]),
                    to + right * (0.5 * widths[1]),
                    to - right * (0.5 * widths[1]),
                ];
                let width = 0.5 * (widths[0] + widths[1]) / frame.axis.length().max(1e-6);
                items.push(Item {
                    outline: corners.map(|p| view.pixel(p)).to_vec(),
                    paint: Brush::Stem { view, frame, color, width },
                });
            }
            Part::Blade { frame, shade, offset } => {
                let place = |grow: f32, drop: f32| -> Vec<Vec2> {
                    let middle = Vec2::new(0.0, 0.5);
                    let down = Vec2::new(0.0, -drop * frame.axis.length());
                    polygon
                        .iter()
                        .map(|&p| view.pixel(frame.place(middle + (p - middle) * grow) + down))
                        .collect()
                };
                if shadows {
                    for (grow, drop) in SHADOW_RINGS {
                        let paint = Brush::Shadow(SHADOW);
                        items.push(Item { outline: place(grow, drop), paint });
                    }
                }
                let blade = Blade { shape, rays: &rays, noise, view, frame, shade, offset };
                items.push(Item { outline: place(1.0, 0.0), paint: Brush::Blade(blade) });
            }
        }
    }
    let texture =
        Texture { name: name.to_owned(), width: size, height: size, pixels: draw(&items, size) };
    LeafTexture { texture, width, petiole }
}

/// Sprays of more leaves than this throw no shadows: needles would only get dirty.
const SHADOWS: u32 = 40;
/// How much one ring of shadow darkens, and the rings' growth and drop (in leaf lengths).
const SHADOW: f32 = 0.13;
const SHADOW_RINGS: [(f32, f32); 3] = [(1.14, 0.04), (1.07, 0.03), (1.02, 0.02)];

/// Transparent pixels left at the top and the sides of an image.
fn margin(size: u32) -> f32 {
    (size as f32 / 128.0).max(2.0) + 0.01
}

/// The view that fits all parts into the image and the width of the card. Lengthens the stem
/// downwards where a leaf hangs below its base.
fn fit(parts: &mut Vec<Layered>, polygon: &[Vec2], shape: &LeafShape, size: u32) -> (View, f32) {
    let (mut side, mut top, mut low) = (1e-3_f32, 1e-3_f32, 0.0_f32);
    let mut base_width = 0.0_f32;
    for (_, part) in parts.iter() {
        match *part {
            Part::Blade { frame, .. } => {
                for &p in polygon {
                    let q = frame.place(p);
                    (side, top, low) = (side.max(q.x.abs()), top.max(q.y), low.min(q.y));
                }
            }
            Part::Stem { from, to, widths, .. } => {
                for (q, w) in [(from, widths[0]), (to, widths[1])] {
                    side = side.max(q.x.abs() + 0.5 * w);
                    top = top.max(q.y);
                    if q.y == 0.0 {
                        base_width = base_width.max(w);
                    }
                }
            }
        }
    }
    let margin = margin(size);
    let pixels = size as f32;
    if low < 0.0 {
        low -= (top - low) * margin / pixels;
        let color = match &shape.spray {
            Some(spray) => rgb(spray.twig_color),
            None => rgb(shape.style.stalk),
        };
        let (from, to) = (Vec2::new(0.0, low), Vec2::new(0.0, 1e-3));
        parts.insert(0, (0.0, Part::Stem { from, to, widths: [base_width; 2], color }));
    }
    let step = Vec2::new(2.0 * side / (pixels - 2.0 * margin), (top - low) / (pixels - margin));
    let view = View { center: 0.5 * pixels, bottom: pixels, step, low };
    (view, step.x / step.y)
}
