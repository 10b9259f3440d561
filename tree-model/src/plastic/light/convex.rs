//! Solids in the light's way: boxes and half-spaces.

use super::sky::{Bins, DIRECTIONS, Weights};
use super::veil::{Ball, influence, veil};
use glam::{Quat, Vec3};

/// A box turned anyhow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::plastic) struct Block {
    pub center: Vec3,
    pub half: Vec3,
    pub rotation: Quat,
}

/// All points behind a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::plastic) struct Plane {
    pub point: Vec3,
    /// Out of the solid, unit.
    pub normal: Vec3,
}

/// Something solid and convex that lets no light through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::plastic) enum Convex {
    Ball(Ball),
    Block(Block),
    Plane(Plane),
}

/// The faces of a box are numbered -x, +x, -y, +y, -z, +z. An edge runs along one axis between a face of each of
/// the other two.
const AXES: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

impl Convex {
    /// The same seen from another frame: turned, then moved.
    pub(in crate::plastic) fn moved(self, rotation: Quat, offset: Vec3) -> Self {
        let place = |point: Vec3| rotation * point + offset;
        match self {
            Self::Ball(ball) => Self::Ball(Ball { center: place(ball.center), ..ball }),
            Self::Block(block) => Self::Block(Block {
                center: place(block.center),
                rotation: rotation * block.rotation,
                ..block
            }),
            Self::Plane(plane) => {
                Self::Plane(Plane { point: place(plane.point), normal: rotation * plane.normal })
            }
        }
    }

    /// A ball around it; none for half-spaces.
    pub(in crate::plastic) fn ball(&self) -> Option<Ball> {
        match *self {
            Self::Ball(ball) => Some(ball),
            Self::Block(block) => {
                let radius = block.half.length();
                Some(Ball { center: block.center, radius, translucency: 0.0 })
            }
            Self::Plane(_) => None,
        }
    }

    /// At most this share of the sky's light is kept from `point`.
    pub(in crate::plastic) fn influence(&self, point: Vec3, bins: &Bins) -> f32 {
        match self {
            Self::Ball(ball) => influence(ball, ball.center - point, bins),
            Self::Block(block) => block.influence(point, bins),
            Self::Plane(_) => 1.0,
        }
    }

    /// Draws it before the sky as seen from `point`.
    pub(in crate::plastic) fn veil(&self, point: Vec3, bins: &Bins, through: &mut Weights) {
        match self {
            Self::Ball(ball) => veil(ball, ball.center - point, bins, through),
            Self::Block(block) => block.veil(point, bins, through),
            Self::Plane(plane) => {
                if (point - plane.point).dot(plane.normal) <= 0.0 {
                    *through = [0.0; DIRECTIONS];
                } else {
                    cut(&[-plane.normal], bins, through);
                }
            }
        }
    }

    /// Whether the segment touches it.
    pub(in crate::plastic) fn meets(&self, a: Vec3, b: Vec3) -> bool {
        match self {
            Self::Ball(ball) => {
                let way = b - a;
                let along =
                    (ball.center - a).dot(way) / way.length_squared().max(f32::MIN_POSITIVE);
                let nearest = a + way * along.clamp(0.0, 1.0);
                nearest.distance_squared(ball.center) <= ball.radius * ball.radius
            }
            Self::Block(block) => block.meets(a, b),
            Self::Plane(plane) => {
                (a - plane.point).dot(plane.normal) <= 0.0
                    || (b - plane.point).dot(plane.normal) <= 0.0
            }
        }
    }
}

/// The light of the open sky, in units of its brightest point: cos² over a hemisphere.
const LOBE: f32 = 2.0 / 3.0 * std::f32::consts::PI;

impl Block {
    /// The solid angle it is seen under, at most, times the light of its brightest point, at most.
    fn influence(&self, point: Vec3, bins: &Bins) -> f32 {
        let turn = self.rotation.conjugate();
        let eye = turn * (point - self.center);
        let gap = (eye.abs() - self.half).max(Vec3::ZERO).length();
        if gap <= 0.25 * self.half.max_element() {
            return 1.0;
        }
        let extent = |way: Vec3| (turn * way).abs().dot(self.half);
        let top = (self.center - point).dot(bins.up) + extent(bins.up);
        if top <= -Bins::reach() * gap {
            return 0.0;
        }
        let bright = (self.center - point).dot(bins.brightest) + extent(bins.brightest);
        // A direction's share of the sky reaches a little beyond it.
        let bright = (bright / gap + Bins::reach()).clamp(0.0, 1.0);
        let seen = self.seen(eye);
        (seen / (gap * gap) * bright * bright / LOBE).min(1.0)
    }

    /// Area it is seen with from far away.
    fn seen(&self, eye: Vec3) -> f32 {
        let way = eye.abs() / eye.length();
        4.0 * (way.x * self.half.y * self.half.z
            + way.y * self.half.z * self.half.x
            + way.z * self.half.x * self.half.y)
    }

    fn veil(&self, point: Vec3, bins: &Bins, through: &mut Weights) {
        let eye = self.rotation.conjugate() * (point - self.center);
        let outside = eye.abs().cmpgt(self.half);
        if !outside.any() {
            *through = [0.0; DIRECTIONS];
            return;
        }
        let distance = eye.length();
        let size = self.half.length();
        if size < 1.5 * Bins::reach() * distance {
            // A few directions wide at most: a ball that covers as much.
            let radius = (self.seen(eye) / std::f32::consts::PI).sqrt();
            let ball = Ball { center: self.center, radius, translucency: 0.0 };
            veil(&ball, self.center - point, bins, through);
            return;
        }
        let mut planes = [Vec3::ZERO; 12];
        let n_planes = self.rims(eye, &mut planes);
        cut(&planes[..n_planes], bins, through);
    }

    /// Planes through the eye and the edges between faces that it sees and faces that it does not, facing inwards.
    fn rims(&self, eye: Vec3, planes: &mut [Vec3; 12]) -> usize {
        let mut n_planes = 0;
        let seen = |axis: usize, high: bool| {
            if high { eye[axis] > self.half[axis] } else { eye[axis] < -self.half[axis] }
        };
        for [along, u, v] in AXES {
            for (high_u, high_v) in [(false, false), (false, true), (true, false), (true, true)] {
                if seen(u, high_u) == seen(v, high_v) {
                    continue;
                }
                let mut corner = Vec3::ZERO;
                corner[u] = if high_u { self.half[u] } else { -self.half[u] };
                corner[v] = if high_v { self.half[v] } else { -self.half[v] };
                let mut edge = Vec3::ZERO;
                edge[along] = 1.0;
                let mut normal = edge.cross(corner - eye).normalize_or_zero();
                if normal.dot(eye) > 0.0 {
                    normal = -normal;
                }
                planes[n_planes] = self.rotation * normal;
                n_planes += 1;
            }
        }
        n_planes
    }

    fn meets(&self, a: Vec3, b: Vec3) -> bool {
        let turn = self.rotation.conjugate();
        let (a, b) = (turn * (a - self.center), turn * (b - self.center));
        if a.min(b).cmpgt(self.half).any() || a.max(b).cmplt(-self.half).any() {
            return false;
        }
        let way = b - a;
        let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
        for axis in 0..3 {
            let (from, step, half) = (a[axis], way[axis], self.half[axis]);
            if step.abs() < 1e-12 {
                if from.abs() > half {
                    return false;
                }
                continue;
            }
            let (t0, t1) = ((-half - from) / step, (half - from) / step);
            enter = enter.max(t0.min(t1));
            leave = leave.min(t0.max(t1));
        }
        enter <= leave
    }
}

/// Darkens what lies on the inner side of all planes through the eye.
fn cut(planes: &[Vec3], bins: &Bins, through: &mut Weights) {
    let steep = 1.0 / (2.0 * Bins::reach());
    let mut cover = [1.0_f32; DIRECTIONS];
    for plane in planes {
        let n = *plane * steep;
        for (k, cover) in cover.iter_mut().enumerate() {
            // What each rim takes away is subtracted, so that a thin strip covers as little as it is thin.
            let inside = 0.5 + n.x * bins.x[k] + n.y * bins.y[k] + n.z * bins.z[k];
            *cover -= 1.0 - inside.clamp(0.0, 1.0);
        }
    }
    for (through, cover) in through.iter_mut().zip(cover) {
        *through *= 1.0 - cover.max(0.0);
    }
}
