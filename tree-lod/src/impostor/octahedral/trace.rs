//! A ray through the depths of one view.

use super::Octahedral;
use super::map::axes;
use glam::{Vec2, Vec3};

/// Steps along a ray through the ball. More find thin leaves at flat angles, at the cost of as many
/// texels.
pub const STEPS: u32 = 24;

/// How deep the layer is that a texel stands for, as a share of the ball's radius: a ray that passes
/// further behind it goes on. More thickens the tree, less makes holes.
pub const THICKNESS: f32 = 0.04;

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

pub(super) fn tune(i: usize) -> f32 {
    use std::sync::OnceLock;
    static T: OnceLock<Vec<f32>> = OnceLock::new();
    T.get_or_init(|| {
        std::env::var("TUNE")
            .unwrap_or("0.04,0.25,24,1,0,1".into())
            .split(',')
            .map(|v| v.parse().unwrap())
            .collect()
    })[i]
}

impl Octahedral {
    /// `origin` is relative to the centre; the ray is inside the ball from `near` to `far`.
    pub(super) fn trace(
        &self,
        frame: [u32; 2],
        origin: Vec3,
        direction: Vec3,
        [near, far]: [f32; 2],
    ) -> Met {
        let meta = &self.meta;
        let [right, up, toward] = axes(frame, meta.grid, meta.hemi);
        let flat = |v: Vec3| Vec2::new(right.dot(v), up.dot(v));
        let sink = -toward.dot(direction);
        if sink < COSINE_MIN {
            return Met::default();
        }
        let (from, along, height) = (flat(origin), flat(direction), toward.dot(origin));
        let step = (far - near) / tune(2);
        let reach = 0.5 * step * sink;
        let mut s = near + 0.5 * step;
        for _ in 0..tune(2) as u32 {
            let place = self.place(frame, from + along * s);
            let depth = self.depth(place);
            let above = height - sink * s - depth;
            if above <= reach
                && above >= -reach - tune(0) * meta.radius
                && self.alpha(place) >= tune(1)
            {
                // To where the ray crosses the depth that was found.
                let crossing = (s + above / sink).clamp(near, far);
                let there = self.met(self.place(frame, from + along * crossing), crossing);
                let here = self.met(place, s);
                return if tune(5) > 0.5 && here.alpha > there.alpha { here } else { there };
            }
            s += step;
        }
        Met::default()
    }

    /// Texel coordinates of a point of a view, in metres right and up of its middle.
    fn place(&self, frame: [u32; 2], at: Vec2) -> Vec2 {
        let tile = self.meta.tile as f32;
        let inside = Vec2::new(0.5, 0.5) + Vec2::new(at.x, -at.y) / (2.0 * self.meta.reach);
        let inside = (inside * tile).clamp(Vec2::splat(0.5), Vec2::splat(tile - 0.5));
        Vec2::new(frame[0] as f32, frame[1] as f32) * tile + inside
    }

    fn depth(&self, place: Vec2) -> f32 {
        let by = self.meta.detail_side as f32 / self.meta.side as f32;
        let texel = nearest(&self.detail.pixels, self.meta.detail_side, place * by);
        (f32::from(texel[3]) / 127.5 - 1.0) * self.meta.reach
    }

    fn alpha(&self, place: Vec2) -> f32 {
        f32::from(nearest(&self.color.pixels, self.meta.side, place)[3]) / 255.0
    }

    fn met(&self, place: Vec2, distance: f32) -> Met {
        let side = self.meta.side as usize;
        let at = place - 0.5;
        let low = at.floor();
        let f = at - low;
        let weights = [(1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y];
        let (texels, _) = self.color.pixels.as_chunks::<4>();
        let first = low.y.max(0.0) as usize * side + low.x.max(0.0) as usize;
        let (mut color, mut alpha) = (Vec3::ZERO, 0.0);
        for (step, weight) in [0, 1, side, side + 1].into_iter().zip(weights) {
            let texel = texels.get(first + step).copied().unwrap_or_default();
            color += weight * super::view::linear(texel);
            alpha += weight * f32::from(texel[3]) / 255.0;
        }
        let by = self.meta.detail_side as f32 / self.meta.side as f32;
        let [x, y, z, _] = nearest(&self.detail.pixels, self.meta.detail_side, place * by);
        let normal = Vec3::new(x.into(), y.into(), z.into()) / 127.5 - 1.0;
        Met { alpha, color, normal, distance }
    }
}

/// The texel at a place.
#[inline]
fn nearest(pixels: &[u8], side: u32, place: Vec2) -> [u8; 4] {
    let (x, y) = ((place.x as u32).min(side - 1) as usize, (place.y as u32).min(side - 1) as usize);
    pixels.as_chunks::<4>().0.get(y * side as usize + x).copied().unwrap_or_default()
}
