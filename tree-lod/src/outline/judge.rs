//! How well fewer triangles stand for a blade.

use super::shape::Blade;
use glam::{Vec2, Vec3};

/// Pixels along each side of a view: the bits of a row.
const SIZE: usize = 64;
/// Empty pixels at each side, room for what has grown.
const MARGIN: f32 = 9.0;
/// Sine and cosine of the angles by which the rings of views are tilted: 45° and 75.5°. With the view
/// from above all directions count about alike. Fewer grazing views, and a search finds folds that are
/// wrong between them.
const TILTS: [(f32, f32); 2] = [(0.707_106_77, 0.707_106_77), (0.968_245_86, 0.25)];
/// Cosine and sine of the angles around the inner ring: along and across the blade.
const INNER: [(f32, f32); 4] = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
/// The same around the outer ring, from 22.5° in steps of 45°.
const OUTER: [(f32, f32); 8] = [
    (COS, SIN),
    (-COS, -SIN),
    (-SIN, COS),
    (SIN, -COS),
    (SIN, COS),
    (-SIN, -COS),
    (COS, -SIN),
    (-COS, SIN),
];
const COS: f32 = 0.923_879_5;
const SIN: f32 = 0.382_683_43;

/// Weights of the first view and of the views of both rings: their shares of all directions.
const WEIGHTS: [f32; 3] = [1.74, 1.29, 0.76];
/// Cosine and sine of 11.25°, by which a second judge's views are turned against the first's.
const TURN: (f32, f32) = (0.980_785_3, 0.195_090_32);

type Rows = [u64; SIZE];

/// Views of a blade.
pub(super) struct Judge<'a> {
    blade: &'a Blade,
    views: Vec<View>,
    /// Area of the blade in all views.
    total: f32,
}

struct View {
    /// A pixel along x and along y, and where the blade's centre lies.
    x: Vec3,
    y: Vec3,
    origin: Vec2,
    /// Area of a pixel times the weight of the view.
    pixel: f32,
    rows: Rows,
}

impl<'a> Judge<'a> {
    /// Two judges look from different directions when one is `turned`.
    pub(super) fn new(blade: &'a Blade, turned: bool) -> Self {
        let sum: Vec3 = blade.triangles.iter().map(|&t| blade.cross(t)).sum();
        let normal = sum.normalize_or(Vec3::Y);
        // Along the blade, so that long blades fill the pixels.
        let far = blade.points.iter().copied().fold(Vec3::ZERO, |far, p| {
            if p.length_squared() > far.length_squared() { p } else { far }
        });
        let along = normal.cross(far).try_normalize();
        let x = along.unwrap_or_else(|| normal.any_orthonormal_vector());
        let y = normal.cross(x);
        let (x, y) =
            if turned { (x * TURN.0 + y * TURN.1, y * TURN.0 - x * TURN.1) } else { (x, y) };
        let mut views = vec![View::new(blade, x, y, WEIGHTS[0])];
        for (ring, turns) in [&INNER[..], &OUTER[..]].into_iter().enumerate() {
            let (sine, cosine) = TILTS[ring];
            for &(c, s) in turns {
                let down = (x * c + y * s) * cosine - normal * sine;
                views.push(View::new(blade, y * c - x * s, down, WEIGHTS[ring + 1]));
            }
        }
        let mut judge = Self { blade, views, total: 0.0 };
        for view in &mut judge.views {
            view.rows = view.drawn(blade, &blade.triangles, 1.0).0;
            judge.total += view.pixel * count(&view.rows) as f32;
        }
        judge
    }

    /// Area seen in only one of both, as a share of the blade's, when `triangles` have grown about
    /// the blade's centre to its area. Infinite for triangles without area, and once it is `most`: what
    /// is no better need not be known.
    pub(super) fn error(&self, triangles: &[[u32; 3]], most: f32) -> f32 {
        let growth = (1.0 / self.blade.area_of(triangles)).sqrt();
        if !growth.is_finite() {
            return f32::INFINITY;
        }
        let all = self.total.max(f32::MIN_POSITIVE);
        let mut error = 0.0;
        for view in &self.views {
            let (rows, outside) = view.drawn(self.blade, triangles, growth);
            let n: u32 = rows.iter().zip(&view.rows).map(|(a, b)| (a ^ b).count_ones()).sum();
            error += (n + outside) as f32 * view.pixel / all;
            if error >= most {
                return f32::INFINITY;
            }
        }
        error
    }
}

fn count(rows: &Rows) -> u32 {
    rows.iter().map(|row| row.count_ones()).sum()
}

impl View {
    /// The blade's box fills the picture up to the margin, each side by its own scale.
    fn new(blade: &Blade, x: Vec3, y: Vec3, weight: f32) -> Self {
        let flat = || blade.points.iter().map(|p| Vec2::new(p.dot(x), p.dot(y)));
        let low = flat().fold(Vec2::INFINITY, Vec2::min);
        let high = flat().fold(Vec2::NEG_INFINITY, Vec2::max);
        let room = SIZE as f32 - 2.0 * MARGIN;
        // Seen from the edge there is nothing to see, and no pixel has an area.
        let size = (high - low).max(Vec2::splat(1e-6));
        let scale = room / size;
        Self {
            x: x * scale.x,
            y: y * scale.y,
            origin: Vec2::splat(MARGIN) - low * scale,
            pixel: (size / room).element_product() * weight,
            rows: [0; SIZE],
        }
    }

    /// Pixels that are covered, and the number of those outside the picture.
    fn drawn(&self, blade: &Blade, triangles: &[[u32; 3]], growth: f32) -> (Rows, u32) {
        let (mut rows, mut outside) = ([0; SIZE], 0);
        let (x, y) = (self.x * growth, self.y * growth);
        for &triangle in triangles {
            let corners = blade.corners(triangle);
            outside +=
                fill(&mut rows, corners.map(|p| self.origin + Vec2::new(p.dot(x), p.dot(y))));
        }
        (rows, outside)
    }
}

/// Sets the bits of pixels whose middles a triangle covers; returns how many are outside the picture,
/// up to a picture's size away.
fn fill(rows: &mut Rows, corners: [Vec2; 3]) -> u32 {
    let [a, b, c] = corners;
    let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| (p, q.y, (q.x - p.x) / (q.y - p.y)));
    let side = SIZE as i32;
    let pixel = |at: f32| ((at - 0.5).ceil() as i32).clamp(-side, 2 * side);
    let mut outside = 0;
    for row in pixel(a.y.min(b.y).min(c.y))..pixel(a.y.max(b.y).max(c.y)) {
        let y = row as f32 + 0.5;
        let (mut left, mut right) = (f32::INFINITY, f32::NEG_INFINITY);
        for &(p, to, slope) in &edges {
            if (p.y <= y) != (to <= y) {
                let x = p.x + (y - p.y) * slope;
                left = left.min(x);
                right = right.max(x);
            }
        }
        if left >= right {
            continue;
        }
        let (first, end) = (pixel(left), pixel(right));
        let bits = usize::try_from(row).ok().and_then(|row| rows.get_mut(row));
        let inside = bits.map_or(0, |bits| {
            let (first, end) = (first.clamp(0, side), end.clamp(0, side));
            *bits |= below(end) & !below(first);
            end - first
        });
        outside += end - first - inside;
    }
    outside.unsigned_abs()
}

/// The lowest bits.
fn below(n: i32) -> u64 {
    if n >= SIZE as i32 { u64::MAX } else { (1 << n) - 1 }
}
