//! Leaf shapes and the look of a blade.

use super::noise::{Noise, mix, smoothstep};
use super::raster::{Paint, Rgb, blend, rgb};
use super::spray::Spray;
use std::borrow::Cow;
use tree_core::Seed;
use tree_core::glam::Vec2;

/// The shape of a leaf, in lengths of its blade: the petiole joins at the origin, the apex is at (0, 1).
///
/// ```
/// use tree_mesh::texture::{LeafShape, leaf_with};
/// // A narrow leaf out of four points of its right half.
/// let narrow = LeafShape {
///     outline: vec![[0.0, 0.0, 1.0], [0.1, 0.3, 0.0], [0.08, 0.7, 0.0], [0.0, 1.0, 1.0]].into(),
///     ..Default::default()
/// };
/// assert!(leaf_with(&narrow, 64).unwrap().width < 0.4);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LeafShape {
    /// Right half of the outline from the petiole to the apex: x (0 to 2), y (-1 to 2) and sharpness
    /// (0 rounded, 1 a corner) of 2 to 256 points. Default an ovate leaf.
    pub outline: Cow<'static, [[f32; 3]]>,
    /// Teeth on the margin. Default none.
    pub teeth: Teeth,
    /// Length of the petiole, as share of the whole leaf, 0 to 0.8. Default 0.15.
    pub petiole: f32,
    /// Veins. Default eight pairs.
    pub veins: Veins,
    /// Colours.
    pub style: LeafStyle,
    /// How leaves stand on a twig; `None` for a single leaf. Default none.
    pub spray: Option<Spray>,
    /// Where mottling and the irregularities of a spray start.
    pub seed: Seed,
}

/// Teeth on the margin of a leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Teeth {
    /// Number on each half, 0 to 100.
    pub count: u32,
    /// How far they stand out, in blade lengths, 0 to 0.2.
    pub depth: f32,
    /// 0 for waves to 1 for a saw that points to the apex.
    pub sharpness: f32,
    /// Whether each tooth bears three smaller ones.
    pub double: bool,
}

impl Teeth {
    /// An entire margin.
    pub const NONE: Self = Self { count: 0, depth: 0.0, sharpness: 0.0, double: false };
}

/// Main veins run straight from the petiole, secondary veins leave each main vein in pairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Veins {
    /// Angles of the main veins of the right half with the midrib, in radians. The midrib is always
    /// there. At most 8. Default none.
    pub rays: Cow<'static, [f32]>,
    /// Pairs of secondary veins per blade length, 0 to 64.
    pub pairs: f32,
    /// Rise of the secondary veins along the main vein per distance from it, 0 to 4.
    pub slope: f32,
    /// How much lighter veins are, 0 to 1.
    pub contrast: f32,
}

/// Colours of a leaf, sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeafStyle {
    /// The blade. Default a mid green.
    pub base: [u8; 3],
    /// The veins.
    pub vein: [u8; 3],
    /// The petiole.
    pub stalk: [u8; 3],
    /// What [`autumn`](Self::autumn) turns the blade to.
    pub autumn: [u8; 3],
    /// Strength of mottling and shading, 0 to 1. Default 0.5.
    pub mottle: f32,
}

impl LeafStyle {
    pub(super) const DEFAULT: Self = Self {
        base: [88, 116, 48],
        vein: [142, 160, 92],
        stalk: [118, 118, 66],
        autumn: [196, 142, 46],
        mottle: 0.5,
    };

    /// The colours in autumn: `progress` 0 is summer, 1 is fully turned.
    ///
    /// ```
    /// use tree_mesh::texture::{leaf_shape, leaf_with};
    /// let mut maple = leaf_shape("maple").unwrap();
    /// maple.style = maple.style.autumn(1.0);
    /// assert!(leaf_with(&maple, 128).is_ok());
    /// ```
    #[must_use]
    pub fn autumn(self, progress: f32) -> Self {
        let t = if progress.is_finite() { progress.clamp(0.0, 1.0) } else { 0.0 };
        let turn = |from: [u8; 3], share: f32| {
            super::raster::to_bytes(blend(rgb(from), rgb(self.autumn), t * share))
        };
        Self {
            base: turn(self.base, 1.0),
            vein: turn(self.vein, 0.55),
            stalk: turn(self.stalk, 0.5),
            mottle: (self.mottle * (1.0 + t)).min(1.0),
            ..self
        }
    }
}

impl Default for LeafStyle {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl LeafShape {
    pub(super) const DEFAULT: Self = Self {
        outline: Cow::Borrowed(&[
            [0.0, 0.0, 0.5],
            [0.13, 0.07, 0.0],
            [0.26, 0.25, 0.0],
            [0.31, 0.45, 0.0],
            [0.27, 0.68, 0.0],
            [0.15, 0.88, 0.0],
            [0.0, 1.0, 1.0],
        ]),
        teeth: Teeth::NONE,
        petiole: 0.15,
        veins: Veins { rays: Cow::Borrowed(&[]), pairs: 8.0, slope: 0.8, contrast: 0.5 },
        style: LeafStyle::DEFAULT,
        spray: None,
        seed: Seed(0),
    };
}

impl Default for LeafShape {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Where a blade or a piece of stem lies: its own x to the right and y along its axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) origin: Vec2,
    /// From y = 0 to y = 1.
    pub(super) axis: Vec2,
    /// Foreshortening across, 0 to 1.
    pub(super) squash: f32,
    /// Sideways shift at y = 1.
    pub(super) bend: f32,
}

impl Frame {
    pub(super) fn place(&self, p: Vec2) -> Vec2 {
        let x = (p.x + self.bend * p.y * p.y) * self.squash;
        self.origin + self.axis * p.y + self.axis.perp() * -x
    }

    fn find(&self, q: Vec2) -> Vec2 {
        let d = (q - self.origin) / self.axis.length_squared().max(1e-12);
        let y = d.dot(self.axis);
        Vec2::new(d.dot(-self.axis.perp()) / self.squash - self.bend * y * y, y)
    }
}

/// From pixels to the plant's own units (y up, base at the bottom centre).
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) center: f32,
    pub(super) bottom: f32,
    /// Plant units per pixel, across and up.
    pub(super) step: Vec2,
    /// The plant's y at the bottom of the image.
    pub(super) low: f32,
}

impl View {
    fn plant(&self, pixel: Vec2) -> Vec2 {
        Vec2::new(
            (pixel.x - self.center) * self.step.x,
            self.low + (self.bottom - pixel.y) * self.step.y,
        )
    }

    pub(super) fn pixel(&self, plant: Vec2) -> Vec2 {
        Vec2::new(
            self.center + plant.x / self.step.x,
            self.bottom - (plant.y - self.low) / self.step.y,
        )
    }
}

/// The paint of one part.
pub(super) enum Brush<'a> {
    Blade(Blade<'a>),
    Stem { view: View, frame: Frame, color: Rgb, width: f32 },
    Shadow(f32),
}

/// What the colour of a blade depends on.
pub(super) struct Blade<'a> {
    pub(super) shape: &'a LeafShape,
    /// Directions of the main veins, the midrib first.
    pub(super) rays: &'a [Vec2],
    pub(super) noise: Noise,
    pub(super) view: View,
    pub(super) frame: Frame,
    /// Brightness, 1 for the plain colour.
    pub(super) shade: f32,
    /// Moves the mottling, so that no two leaves have the same.
    pub(super) offset: f32,
}

/// Directions of the main veins, the midrib first.
pub(super) fn rays(veins: &Veins) -> Vec<Vec2> {
    let turned = veins.rays.iter().map(|&a| Vec2::new(libm::sinf(a), libm::cosf(a)));
    std::iter::once(Vec2::Y).chain(turned).collect()
}

/// Half width of the midrib at the petiole, and of secondary veins, in blade lengths.
const VEIN_WIDTH: (f32, f32) = (0.014, 0.0055);

impl Paint for Brush<'_> {
    fn color(&self, at: Vec2) -> Rgb {
        match self {
            Brush::Blade(blade) => blade.color(at),
            Brush::Stem { view, frame, color, width } => {
                let x = (frame.find(view.plant(at)).x / width.max(1e-6)).clamp(-0.5, 0.5);
                // A round rod lit from the upper left.
                color.map(|c| c * (1.08 - 0.35 * x - 0.9 * x * x))
            }
            Brush::Shadow(_) => [0.0; 3],
        }
    }

    fn shadow(&self) -> Option<f32> {
        match self {
            Brush::Shadow(dark) => Some(*dark),
            _ => None,
        }
    }
}

impl Blade<'_> {
    fn color(&self, at: Vec2) -> Rgb {
        let p = self.frame.find(self.view.plant(at));
        let (veins, style) = (&self.shape.veins, &self.shape.style);
        let pixel = self.view.step.max_element() / self.frame.axis.length().max(1e-6);
        let side = Vec2::new(p.x.abs(), p.y);

        // The main vein whose direction is nearest owns the point.
        let (mut along, mut across, mut best) = (p.y, side.x, f32::MIN);
        for ray in self.rays {
            let a = side.dot(*ray);
            let cosine = a / side.length().max(1e-6);
            if cosine > best {
                (best, along, across) = (cosine, a, side.perp_dot(*ray).abs());
            }
        }
        let taper = (1.0 - 0.8 * along).clamp(0.15, 1.0);
        let line = |half: f32, d: f32| {
            let soft = pixel.max(0.5 * half);
            smoothstep(half + soft, half - soft, d) * (half / soft).min(1.0)
        };
        let main = line(VEIN_WIDTH.0 * taper, across);
        let (mut second, mut quilt) = (0.0, 0.0);
        if veins.pairs > 0.0 {
            let stagger = if p.x < 0.0 { 0.35 } else { 0.0 };
            let rise = along - across * veins.slope - 0.6 * across * across;
            let f = rise * veins.pairs + stagger + 8.0;
            let t = f - f as u32 as f32;
            let d = t.min(1.0 - t) / veins.pairs;
            second = line(VEIN_WIDTH.1 * taper, d);
            quilt = 0.5 - t;
        }
        let vein = veins.contrast * main.max(0.7 * second);

        let scale = 0.08;
        let (nu, nv) = (p.x * scale + self.offset, p.y * scale + 0.7 * self.offset);
        let mottle = self.noise.fbm(nu, nv, [64, 64], 3);
        let fine = self.noise.gradient(nu, nv, [512, 512]);
        let half = if p.x < 0.0 { -0.035 } else { 0.035 };
        let near = smoothstep(0.12, 0.0, across);
        let light =
            half + 0.10 * quilt + 0.10 * (p.y - 0.5) + 0.16 * mottle + 0.05 * fine - 0.08 * near;
        let light = self.shade * (1.0 + 2.0 * style.mottle * light);
        // Old tissue is yellower, in patches.
        let base = rgb(style.base);
        let warm = style.mottle * 0.22 * smoothstep(-0.1, 0.8, mottle);
        let red = base[0].max(mix(base[0], base[1], warm));
        let base = [red, base[1], base[2] * (1.0 - warm)];
        blend(base, rgb(style.vein), vein).map(|c| c * light)
    }
}
