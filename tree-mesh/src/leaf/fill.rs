//! Sets prototypes down: a part of the leaves at a time, a column at a time.

use super::crown::Crown;
use super::prototype::{Frame, PETIOLE_SIDES, PETIOLE_VERTICES, Prototype};
use crate::error::Result;
use crate::lightmap::LeafCells;
use crate::mesh::Surface;
use glam::{Mat3, Vec2, Vec3, Vec4};
use rayon::prelude::*;
use std::f32::consts::TAU;
use tree_core::{Control, Foliage, Skeleton};

/// Leaves of one part of the work.
const LEAVES_PER_PART: usize = 1024;
/// Shortest petiole drawn in radii of itself: one of no length still has triangles.
const PETIOLE_MIN: f32 = 2.0;

/// What all leaves share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<'a> {
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) foliage: &'a Foliage,
    /// The branch that each node belongs to.
    pub(crate) axis_of: &'a [u32],
    pub(crate) crown: &'a Crown,
    /// How far normals turn towards the outside of the crown.
    pub(crate) rounding: f32,
    pub(crate) cells: LeafCells,
}

/// Some leaves and their rows of the columns.
struct Part<'a> {
    leaves: &'a [u32],
    /// Number of the first leaf in its kind.
    first: usize,
    positions: &'a mut [Vec3],
    normals: &'a mut [Vec3],
    uvs: &'a mut [Vec2],
    tangents: &'a mut [Vec4],
    uvs2: &'a mut [Vec2],
    branches: &'a mut [u32],
    anchors: &'a mut [Vec3],
    indices: &'a mut [u32],
}

/// Writes `leaves` (rows of the foliage) into a surface of the right size; `first_cell` is the number
/// of the first one's light-map cell.
///
/// # Errors
/// [`Cancelled`](tree_core::Cancelled).
pub(crate) fn fill(
    scene: Scene<'_>,
    prototype: &Prototype,
    leaves: &[u32],
    first_cell: u64,
    out: &mut Surface,
    control: &Control,
) -> Result<()> {
    let parts = parts(leaves, prototype, out);
    parts.into_par_iter().try_for_each(|mut part| {
        control.check()?;
        anchors(scene, &mut part);
        shapes(scene, prototype, &mut part);
        let n = prototype.n_vertices();
        for uvs in part.uvs.chunks_exact_mut(n) {
            uvs.copy_from_slice(&prototype.uvs);
        }
        for (&leaf, out) in part.leaves.iter().zip(part.branches.chunks_exact_mut(n)) {
            let node = scene.foliage.nodes()[leaf as usize];
            out.fill(scene.axis_of.get(node as usize).copied().unwrap_or(0));
        }
        let size = scene.cells.size();
        for (i, out) in part.uvs2.chunks_exact_mut(n).enumerate() {
            let corner = scene.cells.corner(first_cell + (part.first + i) as u64);
            for (out, &cell) in out.iter_mut().zip(&prototype.cells) {
                *out = corner + cell * size;
            }
        }
        let mut first = (part.first * n) as u32;
        for out in part.indices.chunks_exact_mut(prototype.n_indices()) {
            for (out, &index) in out.iter_mut().zip(&prototype.indices) {
                *out = first + index;
            }
            first = first.wrapping_add(n as u32);
        }
        Ok(())
    })
}

/// Cuts the columns. Columns that were not asked for are empty in every part.
fn parts<'a>(leaves: &'a [u32], prototype: &Prototype, out: &'a mut Surface) -> Vec<Part<'a>> {
    let n = LEAVES_PER_PART * prototype.n_vertices();
    let mut positions = out.positions.chunks_mut(n);
    let mut normals = out.normals.chunks_mut(n);
    let mut uvs = out.uvs.chunks_mut(n);
    let mut tangents = out.tangents.chunks_mut(n);
    let mut uvs2 = out.uvs2.chunks_mut(n);
    let mut branches = out.branches.chunks_mut(n);
    let mut anchors = out.anchors.chunks_mut(LEAVES_PER_PART);
    let mut indices = out.indices.chunks_mut(LEAVES_PER_PART * prototype.n_indices());
    let part = |(number, leaves)| Part {
        leaves,
        first: number * LEAVES_PER_PART,
        positions: positions.next().unwrap_or_default(),
        normals: normals.next().unwrap_or_default(),
        uvs: uvs.next().unwrap_or_default(),
        tangents: tangents.next().unwrap_or_default(),
        uvs2: uvs2.next().unwrap_or_default(),
        branches: branches.next().unwrap_or_default(),
        anchors: anchors.next().unwrap_or_default(),
        indices: indices.next().unwrap_or_default(),
    };
    leaves.chunks(LEAVES_PER_PART).enumerate().map(part).collect()
}

/// The nearest point of the segment that bears each leaf.
fn anchors(scene: Scene<'_>, part: &mut Part<'_>) {
    let positions = scene.skeleton.positions();
    for (&leaf, out) in part.leaves.iter().zip(part.anchors.iter_mut()) {
        let (node, base) =
            (scene.foliage.nodes()[leaf as usize], scene.foliage.positions()[leaf as usize]);
        *out = match scene.skeleton.parent(node) {
            Some(below) => nearest(positions[below as usize], positions[node as usize], base),
            None => base,
        };
    }
}

fn nearest(a: Vec3, b: Vec3, p: Vec3) -> Vec3 {
    let along = b - a;
    let squared = along.length_squared();
    if squared <= 0.0 { a } else { a + along * ((p - a).dot(along) / squared).clamp(0.0, 1.0) }
}

/// Positions, normals and tangents.
fn shapes(scene: Scene<'_>, prototype: &Prototype, part: &mut Part<'_>) {
    let n = prototype.n_vertices();
    let n_lamina = prototype.positions.len();
    let ring = ring();
    let with_tangents = !part.tangents.is_empty();
    let mut frames = vec![(Vec3::ZERO, Vec4::ZERO); prototype.frames.len()];
    let mut tangents = part.tangents.chunks_exact_mut(n);
    let rows = part.leaves.iter().zip(part.anchors.iter());
    let columns = part.positions.chunks_exact_mut(n).zip(part.normals.chunks_exact_mut(n));
    for ((&leaf, &anchor), (positions, normals)) in rows.zip(columns) {
        let i = leaf as usize;
        let turn = Mat3::from_quat(scene.foliage.rotations()[i]);
        let (base, size) = (scene.foliage.positions()[i], scene.foliage.sizes()[i]);
        let grow = turn * size;
        let outward = if scene.rounding > 0.0 {
            scene.crown.outward(base + grow * prototype.middle) * scene.rounding
        } else {
            Vec3::ZERO
        };
        for (out, frame) in frames.iter_mut().zip(&prototype.frames) {
            out.0 = soften(turn * frame.normal, turn * frame.side, outward, scene.rounding);
            if with_tangents {
                out.1 = tangent(turn, frame, out.0);
            }
        }
        for (out, &p) in positions.iter_mut().zip(&prototype.positions) {
            *out = base + grow * p;
        }
        for (out, &frame) in normals.iter_mut().zip(&prototype.frame_of) {
            *out = frames[frame as usize].0;
        }
        let tangents = tangents.next().unwrap_or_default();
        for (out, &frame) in tangents.iter_mut().zip(&prototype.frame_of) {
            *out = frames[frame as usize].1;
        }
        if prototype.petiole > 0.0 {
            let stalk = Stalk { from: anchor, to: base, radius: prototype.petiole * size };
            let stalk = stalk.no_shorter(turn.y_axis);
            stalk.write(&ring, &mut positions[n_lamina..], &mut normals[n_lamina..]);
            if let Some(tangents) = tangents.get_mut(n_lamina..) {
                stalk.write_tangents(&ring, tangents);
            }
        }
    }
}

/// A unit normal between the leaf's own and the crown's (at most of length `rounding`), the latter on
/// the side of its sheet.
#[inline]
fn soften(own: Vec3, side: Vec3, outward: Vec3, rounding: f32) -> Vec3 {
    if outward == Vec3::ZERO {
        return own;
    }
    let outward = if outward.dot(side) < 0.0 { -outward } else { outward };
    (own * (1.0 - rounding) + outward).try_normalize().unwrap_or(own)
}

#[inline]
fn tangent(turn: Mat3, frame: &Frame, normal: Vec3) -> Vec4 {
    let along = turn * frame.tangent;
    let across = along - normal * normal.dot(along);
    across.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector()).extend(frame.sign)
}

/// Cosine and sine of the corners of a petiole.
fn ring() -> [Vec2; PETIOLE_SIDES + 1] {
    std::array::from_fn(|side| {
        let (sin, cos) = libm::sincosf(TAU * (side % PETIOLE_SIDES) as f32 / PETIOLE_SIDES as f32);
        Vec2::new(cos, sin)
    })
}

/// A petiole: a prism of three sides from the shoot to the lamina.
struct Stalk {
    from: Vec3,
    to: Vec3,
    radius: f32,
}

impl Stalk {
    /// Drawn out backwards, into the shoot, where the lamina sits on it.
    fn no_shorter(self, midrib: Vec3) -> Self {
        let least = PETIOLE_MIN * self.radius;
        if self.from.distance_squared(self.to) >= least * least {
            return self;
        }
        Self { from: self.to - midrib * least, ..self }
    }

    /// Two directions across, so that the corners run counter-clockwise seen from the lamina.
    fn across(&self) -> (Vec3, Vec3) {
        let along = (self.to - self.from).normalize_or(Vec3::Y);
        let x = along.any_orthonormal_vector();
        (x, along.cross(x))
    }

    fn write(&self, ring: &[Vec2], positions: &mut [Vec3], normals: &mut [Vec3]) {
        let (x, y) = self.across();
        let corners = [self.from, self.to]
            .into_iter()
            .flat_map(|end| ring.iter().map(move |corner| (end, x * corner.x + y * corner.y)));
        debug_assert_eq!(positions.len(), PETIOLE_VERTICES);
        for ((position, normal), (end, out)) in positions.iter_mut().zip(normals).zip(corners) {
            *position = end + out * self.radius;
            *normal = out;
        }
    }

    fn write_tangents(&self, ring: &[Vec2], tangents: &mut [Vec4]) {
        let (x, y) = self.across();
        for (out, corner) in tangents.iter_mut().zip(ring.iter().cycle()) {
            *out = (y * corner.x - x * corner.y).extend(1.0);
        }
    }
}
