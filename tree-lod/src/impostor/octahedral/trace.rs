//! A ray through the depths of three views.

use super::Octahedral;
use super::map::axes;
use crate::preview::Srgb;
use glam::{Vec2, Vec3, Vec4};

/// Steps along a ray through the tree. More find thin leaves at flat angles, at the cost of as many
/// texels of each of three views.
pub const STEPS: u32 = 32;

/// How deep the layer is that a texel stands for, as a share of the ball's radius: a point further behind it is hidden
/// from that view. More thickens the tree, less makes holes.
pub const THICKNESS: f32 = 0.05;

/// How far before the depth of a texel a point still counts as seen, as a share of the ball's radius: more than half
/// a step of the bytes that depths are kept in.
pub const SLACK: f32 = 0.005;

/// What a view counts that cannot tell, since something of its own hides the point. Less than a half: what is hidden from
/// all views is not there.
pub const HIDDEN: f32 = 0.49;

/// Alpha at which a ray ends.
const FULL: f32 = 0.995;

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

/// A ray as one view sees it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Line {
    frame: [u32; 2],
    weight: f32,
    /// On the picture, -1 to 1 right and up: at the origin, and for each metre.
    start: Vec2,
    along: Vec2,
    /// Towards the viewer: at the origin, and lost for each metre.
    height: f32,
    sink: f32,
    /// Half the depth of the tree, seen from here.
    deep: f32,
}

/// A point of the ray in one view.
#[derive(Clone, Copy, Debug, Default)]
struct Look {
    /// Where the ray crosses the depth that is there: on the picture, and along the ray.
    place: Vec2,
    crossing: f32,
    /// Weight and alpha; less than 0 where the point is hidden, 0 where the view sees through it.
    share: f32,
}

impl Octahedral {
    /// `origin` is relative to the centre. A view too far aside weighs nothing.
    pub(super) fn line(
        &self,
        (frame, weight): ([u32; 2], f32),
        origin: Vec3,
        direction: Vec3,
    ) -> Line {
        let meta = &self.meta;
        let [right, up, toward] = axes(frame, meta.grid, meta.hemi);
        let sink = -toward.dot(direction);
        let flat = |v: Vec3| Vec2::new(right.dot(v), up.dot(v)) / meta.half(toward.y);
        Line {
            frame,
            weight: if sink < COSINE_MIN { 0.0 } else { weight },
            start: flat(origin),
            along: flat(direction),
            height: toward.dot(origin),
            sink: sink.max(COSINE_MIN),
            deep: meta.depth(toward.y),
        }
    }

    /// Follows a ray that is inside the ball between `ends` through three views at once. A point is there as far as the
    /// views see it; one that has it hidden counts for half, one that sees through it against it. What is nearer hides what
    /// comes after as far as it is there.
    pub(super) fn trace(&self, lines: &[Line; 3], ends: [f32; 2], srgb: &Srgb) -> Met {
        let used = || lines.iter().filter(|line| line.weight > 0.0);
        // Only where the tree can be, seen from all of them.
        let near = used().map(|l| (l.height - l.deep) / l.sink).fold(ends[0], f32::max);
        let far = used().map(|l| (l.height + l.deep) / l.sink).fold(ends[1], f32::min);
        let total: f32 = used().map(|line| line.weight).sum();
        let mut sum = Met::default();
        if near >= far || total <= 0.0 {
            return sum;
        }
        let stride = (far - near) / STEPS as f32;
        let mut s = near + 0.5 * stride;
        for _ in 0..STEPS {
            let looks = lines.map(|line| self.look(&line, s, stride));
            let seen: f32 = looks.iter().map(|look| look.share.max(0.0)).sum();
            let hidden: f32 = looks.iter().map(|look| (-look.share).max(0.0)).sum();
            let alpha = (seen + HIDDEN * hidden) / total;
            if seen > 0.0 && alpha > sum.alpha {
                let by = (alpha - sum.alpha) / seen;
                self.add(&mut sum, &looks, by, srgb);
                sum.alpha = alpha;
                if alpha >= FULL {
                    break;
                }
            }
            s += stride;
        }
        if sum.alpha > 0.0 {
            let by = 1.0 / sum.alpha;
            sum.color *= by;
            sum.normal = sum.normal.normalize_or(Vec3::Y);
            sum.distance *= by;
        }
        sum
    }

    /// What a view knows of the point at `s`.
    fn look(&self, line: &Line, s: f32, stride: f32) -> Look {
        if line.weight <= 0.0 {
            return Look::default();
        }
        let place = |s: f32| self.place(line.frame, line.start + line.along * s);
        let (here, radius) = (place(s), self.meta.radius);
        let above = line.height - line.sink * s - self.detail(here).w * radius;
        let slab = 0.5 * stride * line.sink;
        if above > slab + SLACK * radius {
            return Look::default();
        }
        let share = line.weight * self.alpha(here);
        if above < -slab - THICKNESS * radius {
            return Look { share: -share, ..Look::default() };
        }
        let crossing = s + above / line.sink;
        Look { place: place(crossing), crossing, share }
    }

    /// Adds what the views see, as much as `by` says.
    fn add(&self, sum: &mut Met, looks: &[Look; 3], by: f32, srgb: &Srgb) {
        for look in looks.iter().filter(|look| look.share > 0.0) {
            let share = by * look.share;
            sum.color += share * self.color(look.place, srgb);
            sum.normal += share * self.detail(look.place).truncate();
            sum.distance += share * look.crossing;
        }
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

    /// Linear colour between four texels.
    fn color(&self, place: Vec2, srgb: &Srgb) -> Vec3 {
        let rows = self.four(place).into_iter();
        rows.map(|(texel, weight)| weight * srgb.decode(texel)).sum()
    }

    /// Alpha between four texels.
    fn alpha(&self, place: Vec2) -> f32 {
        let rows = self.four(place).into_iter();
        rows.map(|(texel, weight)| weight * f32::from(texel[3]) / 255.0).sum()
    }

    /// The four texels of the picture of colours around a place, and their weights.
    fn four(&self, place: Vec2) -> [([u8; 4], f32); 4] {
        let side = self.meta.side as usize;
        let low = (place - 0.5).floor().max(Vec2::ZERO);
        let f = place - 0.5 - low;
        let (texels, _) = self.color.pixels.as_chunks::<4>();
        let first = low.y as usize * side + low.x as usize;
        let texel = |step: usize| texels.get(first + step).copied().unwrap_or_default();
        [
            (texel(0), (1.0 - f.x) * (1.0 - f.y)),
            (texel(1), f.x * (1.0 - f.y)),
            (texel(side), (1.0 - f.x) * f.y),
            (texel(side + 1), f.x * f.y),
        ]
    }
}
