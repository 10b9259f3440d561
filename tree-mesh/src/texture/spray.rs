//! A leaf shape, alone or on a twig, as parts to draw.
//!
//! Leaves are set along a twig, alternate or opposite, with one at its end; side shoots repeat it at a
//! smaller size. Each leaf gets a random depth, and the deeper the darker.

use super::leaf::{Frame, LeafShape};
use super::noise::mix;
use super::raster::{Rgb, rgb};
use tree_core::glam::Vec2;
use tree_core::seed::{Rng, uniform};

/// How leaves stand on a twig. Lengths are in twig lengths, angles in radians from the twig's
/// direction; along the twig they go evenly from the first value to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spray {
    /// Leaves on the main twig, 1 to 400; one of them ends it.
    pub leaves: u32,
    /// Whether leaves stand in pairs.
    pub opposite: bool,
    /// Share of the twig below the first leaf, 0 to 0.9.
    pub bare: f32,
    /// Angle of the lowest and the topmost leaf, 0 to π.
    pub angle: [f32; 2],
    /// Length of the lowest, a middle and the topmost leaf, 0.01 to 2.
    pub size: [f32; 3],
    /// How irregular angle, size and brightness are, 0 to 1.
    pub jitter: f32,
    /// How far leaves turn towards the tip of the twig on their way, in leaf lengths, -0.5 to 0.5.
    pub bend: f32,
    /// Thickness of the twig at its base, 0.001 to 0.2.
    pub twig: f32,
    /// sRGB colour of the twig.
    pub twig_color: [u8; 3],
    /// Side shoots, 0 to 32; they bear the same leaves, fewer.
    pub shoots: u32,
    /// Angle of the side shoots, 0 to π.
    pub shoot_angle: f32,
    /// Length of the lowest side shoot, 0.05 to 1.
    pub shoot_size: f32,
}

impl Spray {
    pub(super) const DEFAULT: Self = Self {
        leaves: 9,
        opposite: false,
        bare: 0.2,
        angle: [1.15, 0.5],
        size: [0.42, 0.46, 0.4],
        jitter: 0.5,
        bend: 0.08,
        twig: 0.022,
        twig_color: [98, 78, 58],
        shoots: 0,
        shoot_angle: 0.8,
        shoot_size: 0.5,
    };
}

impl Default for Spray {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Something to draw, in the plant's units.
pub(super) enum Part {
    Blade { frame: Frame, shade: f32, offset: f32 },
    Stem { from: Vec2, to: Vec2, widths: [f32; 2], color: Rgb },
}

/// A part and how near it is: 0 behind to 1 in front.
pub(super) type Layered = (f32, Part);

/// All parts of a shape, and the share of its length that is bare stalk.
pub(super) fn parts(shape: &LeafShape) -> (Vec<Layered>, f32) {
    let mut parts = Vec::new();
    let petiole = match &shape.spray {
        None => {
            let stalk = Stalk { from: Vec2::ZERO, toward: Vec2::Y, depth: 0.5 };
            leaf(&mut parts, shape, stalk, [1.0, 0.0], 0.0, 1.0);
            shape.petiole
        }
        Some(spray) => {
            let mut rng = shape.seed.stream("spray").rng();
            let twig = Twig { from: Vec2::ZERO, to: Vec2::Y, scale: 1.0, depth: 0.5 };
            shoot(&mut parts, shape, spray, twig, &mut rng);
            spray.bare
        }
    };
    (parts, petiole)
}

/// Where a leaf stands, the way it points (its length is the leaf's) and how near it is.
#[derive(Clone, Copy)]
struct Stalk {
    from: Vec2,
    toward: Vec2,
    depth: f32,
}

/// Thickness of a petiole at its base and below the blade, in leaf lengths.
const PETIOLE: [f32; 2] = [0.026, 0.016];

/// One leaf with its petiole.
fn leaf(
    parts: &mut Vec<Layered>,
    shape: &LeafShape,
    Stalk { from, toward, depth }: Stalk,
    [squash, bend]: [f32; 2],
    offset: f32,
    shade: f32,
) {
    let length = toward.length();
    let base = from + toward * shape.petiole;
    let axis = toward * (1.0 - shape.petiole);
    if shape.petiole > 0.0 {
        let color = rgb(shape.style.stalk).map(|c| c * shade);
        // Into the blade a little, so that no gap shows.
        let to = base + axis * 0.03;
        let widths = PETIOLE.map(|w| w * length);
        parts.push((depth, Part::Stem { from, to, widths, color }));
    }
    let frame = Frame { origin: base, axis, squash, bend };
    parts.push((depth, Part::Blade { frame, shade, offset }));
}

#[derive(Clone, Copy)]
struct Twig {
    from: Vec2,
    to: Vec2,
    /// Length of the leaves against those of the main twig.
    scale: f32,
    depth: f32,
}

/// Pieces a twig is drawn in.
const PIECES: usize = 8;
/// How far a twig swings sideways, in its lengths.
const SWAY: f32 = 0.08;

/// A twig with its leaves and, on the main twig, its side shoots.
fn shoot(parts: &mut Vec<Layered>, shape: &LeafShape, spray: &Spray, twig: Twig, rng: &mut Rng) {
    let main = twig.scale == 1.0;
    let along = twig.to - twig.from;
    let sway = SWAY * spray.jitter * if main { 1.0 } else { 2.0 };
    let point = |t: f32| {
        let swing = t * (1.0 - t) * if main { 1.0 - 1.6 * t } else { 1.0 };
        twig.from + along * t + along.perp() * (sway * swing)
    };
    let thick = |t: f32| spray.twig * twig.scale * (1.0 - 0.7 * t);
    for piece in 0..PIECES {
        let (t0, t1) = (piece as f32 / PIECES as f32, (piece + 1) as f32 / PIECES as f32);
        let widths = [thick(t0), thick(t1)];
        let color = rgb(spray.twig_color).map(|c| c * mix(0.85, 1.0, twig.depth));
        let (from, to) = (point(t0), point(t1).lerp(point(t1 + 0.03), 0.3));
        parts.push((twig.depth, Part::Stem { from, to, widths, color }));
    }
    if main {
        for number in 0..spray.shoots {
            let t = mix(spray.bare * 0.7, 0.75, (number as f32 + 0.3) / spray.shoots as f32);
            let side = if number % 2 == 0 { 1.0 } else { -1.0 };
            let angle =
                side * spray.shoot_angle * (1.0 + 0.25 * spray.jitter * uniform(rng, -1.0, 1.0));
            let scale = spray.shoot_size * mix(1.0, 0.6, t);
            let toward = turned(along, angle) * scale;
            let from = point(t);
            let twig = Twig {
                from,
                to: from + toward,
                scale: scale.min(0.99),
                depth: 0.5 + 0.2 * uniform(rng, -1.0, 1.0),
            };
            shoot(parts, shape, spray, twig, rng);
        }
    }

    let count =
        if main { spray.leaves } else { ((spray.leaves as f32 * twig.scale) as u32).max(3) };
    let places = if spray.opposite { (count / 2).max(1) } else { count.saturating_sub(1).max(1) };
    // Leaves keep most of their size on side shoots, as in nature.
    let leaf_scale = if main { 1.0 } else { libm::powf(twig.scale, 0.35) };
    for number in 0..count {
        let last = number + 1 == count;
        let place = if spray.opposite { number / 2 } else { number };
        let s = if last { 1.0 } else { (place as f32 + 0.4) / places as f32 };
        let t = if last { 1.0 } else { mix(spray.bare, 1.0, s).min(0.995) };
        let side = if last {
            uniform(rng, -0.15, 0.15)
        } else if number % 2 == 0 {
            1.0
        } else {
            -1.0
        };
        let wobble =
            |rng: &mut Rng, share: f32| 1.0 + share * spray.jitter * uniform(rng, -1.0, 1.0);
        let angle = side * mix(spray.angle[0], spray.angle[1], s) * wobble(rng, 0.35);
        let size = spray.size_at(s) * leaf_scale * wobble(rng, 0.3);
        let depth = (twig.depth + 0.9 * uniform(rng, -0.5, 0.5)).clamp(0.0, 1.0);
        let squash = 1.0 - 0.4 * spray.jitter * uniform(rng, 0.0, 1.0);
        let bend = -side * spray.bend * wobble(rng, 1.0);
        let shade = mix(0.74, 1.06, depth) * wobble(rng, 0.12);
        let toward = turned(along.normalize_or_zero() * size, angle);
        let stalk = Stalk { from: point(t), toward, depth };
        let offset = uniform(rng, 0.0, 1.0);
        leaf(parts, shape, stalk, [squash, bend], offset, shade);
    }
}

/// A vector turned to the right.
fn turned(v: Vec2, angle: f32) -> Vec2 {
    Vec2::new(libm::cosf(angle), -libm::sinf(angle)).rotate(v)
}

impl Spray {
    /// Length of the leaf at a share of the leafy part of the twig.
    fn size_at(&self, s: f32) -> f32 {
        let [low, middle, top] = self.size;
        if s < 0.5 { mix(low, middle, 2.0 * s) } else { mix(middle, top, 2.0 * s - 1.0) }
    }
}
