//! From a polygon in the picture to a leaf: flat, or folded along the midrib and bent down.
//!
//! A folded or bent leaf is a ladder of rungs across the midrib. The midrib is an arc of a circle that
//! leaves the base along +Y and turns by `bend` up to the apex; each half is turned up by `fold`.

use super::form::LeafMesh;
use super::ring;
use glam::{Vec2, Vec3};

/// Rungs nearer than this share of the leaf are one.
const RUNG_MIN: f32 = 1e-5;

/// How a leaf is shaped out of its plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curve {
    /// Angle by which each half stands up from flat.
    pub(crate) fold: f32,
    /// Turn of the midrib from base to apex.
    pub(crate) bend: f32,
    /// Pieces a bent midrib has at least.
    pub(crate) rows: u32,
}

impl Curve {
    pub(crate) fn is_flat(&self) -> bool {
        self.fold == 0.0 && self.bend == 0.0
    }

    /// Where the midrib is at height `y` (up and out of the plane), and its normal there.
    fn midrib(&self, y: f32) -> (Vec2, Vec2) {
        let (sin, cos) = libm::sincosf(self.bend * y);
        let at = if self.bend > 1e-3 {
            Vec2::new(sin, cos - 1.0) / self.bend
        } else {
            Vec2::new(y, -0.5 * self.bend * y * y)
        };
        (at, Vec2::new(sin, cos))
    }
}

/// A flat polygon in the unit square of the picture, `width` leaf lengths wide.
pub(crate) fn flat(polygon: &[Vec2], width: f32) -> LeafMesh {
    let uvs: Vec<Vec2> = polygon.iter().map(|p| Vec2::new(p.x, 1.0 - p.y)).collect();
    LeafMesh {
        positions: polygon.iter().map(|p| Vec3::new((p.x - 0.5) * width, p.y, 0.0)).collect(),
        normals: vec![Vec3::Z; polygon.len()],
        uvs2: uvs.clone(),
        uvs,
        indices: ring::triangulate(polygon),
    }
}

/// The leaf between a half polygon (x from the midrib) and its mirror image.
pub(crate) fn ladder(half: &[Vec2], width: f32, curve: Curve) -> LeafMesh {
    let mut mesh = LeafMesh::default();
    let (sin, cos) = libm::sincosf(curve.fold);
    let mut last: Option<[u32; 3]> = None;
    for y in rungs(half, curve) {
        let reach = half_width(half, y);
        let (at, normal) = curve.midrib(y);
        let mut put = |side: f32| {
            let (out, up) = (side * reach * width * cos, reach * width * sin * side.abs());
            let normal3 = |n: Vec2, x: f32| Vec3::new(x, n.x, n.y).normalize_or(Vec3::Z);
            let lift = normal * up;
            mesh.positions.push(Vec3::new(out, at.x + lift.x, at.y + lift.y));
            let turned =
                if side == 0.0 { normal3(normal, 0.0) } else { normal3(normal * cos, -side * sin) };
            mesh.normals.push(turned);
            mesh.uvs.push(Vec2::new(0.5 + side * reach, 1.0 - y));
            mesh.positions.len() as u32 - 1
        };
        let rung = if reach <= RUNG_MIN {
            [put(0.0); 3]
        } else if curve.fold == 0.0 {
            // Without a fold nothing is at the midrib; its place is taken by the left end.
            let left = put(-1.0);
            [left, left, put(1.0)]
        } else {
            [put(-1.0), put(0.0), put(1.0)]
        };
        if let Some(below) = last {
            quad(&mut mesh.indices, [below[0], below[1], rung[1], rung[0]]);
            quad(&mut mesh.indices, [below[1], below[2], rung[2], rung[1]]);
        }
        last = Some(rung);
    }
    mesh.uvs2 = mesh.uvs.clone();
    mesh
}

/// Two triangles, or one where two corners are the same, or none.
fn quad(indices: &mut Vec<u32>, [a, b, c, d]: [u32; 4]) {
    for t in [[a, b, c], [a, c, d]] {
        if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
            indices.extend(t);
        }
    }
}

/// Heights of the rungs: at all vertices, and as many between as the bend asks for.
fn rungs(half: &[Vec2], curve: Curve) -> Vec<f32> {
    let mut heights: Vec<f32> = half.iter().map(|p| p.y).collect();
    heights.sort_by(f32::total_cmp);
    heights.dedup_by(|b, a| *b - *a < RUNG_MIN);
    if curve.bend > 0.0 {
        let gap = 1.0 / curve.rows as f32;
        let pairs: Vec<(f32, f32)> = heights.windows(2).map(|w| (w[0], w[1])).collect();
        for (low, high) in pairs {
            let n = libm::ceilf((high - low) / gap - 0.01).max(1.0) as u32;
            heights.extend((1..n).map(|k| low + (high - low) * k as f32 / n as f32));
        }
        heights.sort_by(f32::total_cmp);
    }
    heights
}

/// Distance of the margin from the midrib at height `y`.
fn half_width(half: &[Vec2], y: f32) -> f32 {
    let mut widest = 0.0_f32;
    for pair in half.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let (low, high) = (a.y.min(b.y) - RUNG_MIN, a.y.max(b.y) + RUNG_MIN);
        if low <= y && y <= high {
            let rise = b.y - a.y;
            let x = if rise.abs() < RUNG_MIN {
                a.x.max(b.x)
            } else {
                a.x + (b.x - a.x) * ((y - a.y) / rise).clamp(0.0, 1.0)
            };
            widest = widest.max(x);
        }
    }
    widest
}
