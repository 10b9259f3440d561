//! A ray through the depths of one view.

use super::Octahedral;
use super::map::axes;
use crate::preview::Srgb;
use glam::{Vec2, Vec3, Vec4};

/// Steps along a ray through the tree. More find thin leaves at flat angles, at the cost of as many
/// texels.
pub const STEPS: u32 = 32;

/// How deep the layer is that a texel stands for, as a share of the ball's radius: a ray that passes
/// further behind it goes on. More thickens the tree, less makes holes.
pub const THICKNESS: f32 = 0.17;

/// Smallest alpha that stops a ray.
const ALPHA_MIN: f32 = 0.25;

/// Smallest cosine between a ray and a view's line of sight at which it is followed.
const COSINE_MIN: f32 = 0.1;

/// What a ray meets.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Met {
    pub(super) alpha: f32,
    /// Linear.
    pub(super) color: Vec3,
    pub(super) normal: Vec3,
    /// Along the ray.
    pub(super) distance: f32,
}

impl Octahedral {
    /// `origin` is relative to the centre; the ray is inside the ball between `ends`.
    pub(super) fn trace(
        &self,
        frame: [u32; 2],
        origin: Vec3,
        direction: Vec3,
        ends: [f32; 2],
        srgb: &Srgb,
    ) -> Met {
        let meta = &self.meta;
        let [right, up, toward] = axes(frame, meta.grid, meta.hemi);
        let sink = -toward.dot(direction);
        if sink < COSINE_MIN {
            return Met::default();
        }
        let flat = |v: Vec3| Vec2::new(right.dot(v), up.dot(v)) / meta.half(toward.y);
        let (start, along, height) = (flat(origin), flat(direction), toward.dot(origin));
        // Only where the tree can be, seen from here.
        let deep = meta.depth(toward.y);
        let near = ends[0].max((height - deep) / sink);
        let far = ends[1].min((height + deep) / sink);
        if near >= far {
            return Met::default();
        }
        let step = (far - near) / STEPS as f32;
        let slab = 0.5 * step * sink;
        let mut s = near + 0.5 * step;
        for _ in 0..STEPS {
            let here = self.place(frame, start + along * s);
            let above = height - sink * s - self.detail(here).w * meta.radius;
            let near_enough = above <= slab && above >= -slab - THICKNESS * meta.radius;
            if near_enough && self.met(here, s, srgb).alpha >= ALPHA_MIN {
                // To where the ray crosses the depth that was found.
                let crossing = (s + above / sink).clamp(near, far);
                return self.met(self.place(frame, start + along * crossing), crossing, srgb);
            }
            s += step;
        }
        Met::default()
    }

    /// Texel coordinates of a point of a view, −1 to 1 right and up.
    fn place(&self, frame: [u32; 2], at: Vec2) -> Vec2 {
        let tile = self.meta.tile as f32;
        let inside = Vec2::new(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * tile;
        Vec2::new(frame[0] as f32, frame[1] as f32) * tile
            + inside.clamp(Vec2::splat(0.5), Vec2::splat(tile - 0.5))
    }

    /// The nearest normal and depth, −1 to 1 each.
    fn detail(&self, place: Vec2) -> Vec4 {
        let side = self.meta.detail_side;
        let at = place * (side as f32 / self.meta.side as f32);
        let [x, y] = [at.x, at.y].map(|t| (t as u32).min(side - 1) as usize);
        let (texels, _) = self.detail.pixels.as_chunks::<4>();
        let texel = texels.get(y * side as usize + x).copied().unwrap_or_default();
        Vec4::from(texel.map(f32::from)) / 127.5 - 1.0
    }

    /// Colour and alpha between four texels.
    fn met(&self, place: Vec2, distance: f32, srgb: &Srgb) -> Met {
        let side = self.meta.side as usize;
        let low = (place - 0.5).floor().max(Vec2::ZERO);
        let f = place - 0.5 - low;
        let weights = [(1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y];
        let (texels, _) = self.color.pixels.as_chunks::<4>();
        let first = low.y as usize * side + low.x as usize;
        let (mut color, mut alpha) = (Vec3::ZERO, 0.0);
        for (step, weight) in [0, 1, side, side + 1].into_iter().zip(weights) {
            let texel = texels.get(first + step).copied().unwrap_or_default();
            color += weight * srgb.decode(texel);
            alpha += weight * f32::from(texel[3]) / 255.0;
        }
        Met { alpha, color, normal: self.detail(place).truncate(), distance }
    }
}
