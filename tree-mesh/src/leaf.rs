//! Leaf cards: a rectangle for every leaf, or two joined at a bend.
//!
//! A leaf's own frame has its base at the origin, its midrib along +Y and its upper face towards +Z.
//! The card's lower edge is centred on the base. Normals are turned from the card's own towards the
//! outside of the ellipsoid that fills the bounds of the leaves (its gradient), as games do to light
//! foliage softly. They stay on the card's own side, so that the back face, with its normal turned
//! over, is lit from outside as well.
//!
//! Cost: O(leaves), in parallel over fixed parts; 4 vertices and 2 triangles a leaf (6 and 4 bent).

use crate::error::Result;
use crate::mesh::Surface;
use crate::params::MeshParams;
use glam::{Mat3, Vec2, Vec3};
use rayon::prelude::*;
use tree_core::{Aabb, Control, Foliage};

/// Leaves of one part of the work.
const LEAVES_PER_PART: usize = 2048;
/// Thinnest half axis of the crown's ellipsoid as a share of the thickest: flat crowns stay solid.
const CROWN_THINNEST: f32 = 0.1;

/// Shape of the cards of one kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Card {
    /// Width in lengths of the leaf, all factors counted in.
    width: f32,
    length: f32,
    rows: usize,
    /// Sine and cosine of the bend.
    bend: (f32, f32),
}

impl Card {
    /// A card for leaves that are `width` times as wide as long.
    pub(crate) fn new(params: &MeshParams, width: f32) -> Self {
        let bent = params.leaf_bend > 0.0;
        Self {
            width: width * params.leaf_width * params.leaf_scale,
            length: params.leaf_scale,
            rows: if bent { 3 } else { 2 },
            bend: (libm::sinf(params.leaf_bend), libm::cosf(params.leaf_bend)),
        }
    }

    pub(crate) fn n_vertices(&self) -> usize {
        2 * self.rows
    }

    pub(crate) fn n_indices(&self) -> usize {
        6 * (self.rows - 1)
    }

    /// Height along the midrib, depth and (normal) of each row, for a leaf of length 1.
    fn row(&self, row: usize) -> (Vec2, Vec2) {
        let (sin, cos) = self.bend;
        let half = 0.5 * self.length;
        match (self.rows, row) {
            (_, 0) => (Vec2::ZERO, Vec2::Y),
            (2, _) => (Vec2::new(self.length, 0.0), Vec2::Y),
            // At the bend the normal is half way between those of the two halves.
            (_, 1) => (Vec2::new(half, 0.0), Vec2::new(sin, 1.0 + cos).normalize_or(Vec2::Y)),
            _ => (Vec2::new(half + half * cos, -half * sin), Vec2::new(sin, cos)),
        }
    }
}

/// The ellipsoid that soft normals point out of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crown {
    center: Vec3,
    /// 1 over the squared half axes, scaled so that the largest is 1.
    weights: Vec3,
}

impl Crown {
    /// The crown of these leaves. One pass.
    pub(crate) fn of(foliage: &Foliage) -> Self {
        let bounds = Aabb::of_points(foliage.positions());
        let half = 0.5 * bounds.size();
        let thinnest = (CROWN_THINNEST * half.max_element()).max(1e-3);
        let half = half.max(Vec3::splat(thinnest));
        let ratio = half.min_element() / half;
        Self {
            center: if bounds.is_empty() { Vec3::ZERO } else { bounds.center() },
            weights: ratio * ratio,
        }
    }

    fn outward(&self, position: Vec3) -> Option<Vec3> {
        ((position - self.center) * self.weights).try_normalize()
    }
}

/// Writes the cards of `leaves` (rows of the foliage) into a surface of the right size.
///
/// # Errors
/// [`Cancelled`](tree_core::Cancelled).
pub(crate) fn fill(
    foliage: &Foliage,
    leaves: &[u32],
    card: Card,
    crown: Crown,
    rounding: f32,
    out: &mut Surface,
    control: &Control,
) -> Result<()> {
    let (nv, ni) = (card.n_vertices(), card.n_indices());
    (
        leaves.par_chunks(LEAVES_PER_PART),
        out.positions.par_chunks_mut(LEAVES_PER_PART * nv),
        out.normals.par_chunks_mut(LEAVES_PER_PART * nv),
        out.uvs.par_chunks_mut(LEAVES_PER_PART * nv),
        out.indices.par_chunks_mut(LEAVES_PER_PART * ni),
    )
        .into_par_iter()
        .enumerate()
        .try_for_each(|(part, (leaves, positions, normals, uvs, indices))| {
            control.check()?;
            let mut first = (part * LEAVES_PER_PART * nv) as u32;
            let columns = positions
                .chunks_exact_mut(nv)
                .zip(normals.chunks_exact_mut(nv))
                .zip(uvs.chunks_exact_mut(nv))
                .zip(indices.chunks_exact_mut(ni));
            for (&leaf, (((positions, normals), uvs), indices)) in leaves.iter().zip(columns) {
                let i = leaf as usize;
                let turn = Mat3::from_quat(foliage.rotations()[i]);
                let (base, size) = (foliage.positions()[i], foliage.sizes()[i]);
                let side = turn.x_axis * (0.5 * card.width * size);
                let mean = turn.z_axis;
                let middle = base + turn.y_axis * (0.5 * card.length * size);
                let towards = match crown.outward(middle) {
                    Some(outward) if outward.dot(mean) < 0.0 => -rounding,
                    Some(_) => rounding,
                    None => 0.0,
                };
                for row in 0..card.rows {
                    let (at, face) = card.row(row);
                    let centre = base + turn.y_axis * (at.x * size) + turn.z_axis * (at.y * size);
                    let face = (turn.y_axis * face.x + turn.z_axis * face.y).normalize_or(Vec3::Y);
                    let v = 1.0 - row as f32 / (card.rows - 1) as f32;
                    for (column, u) in [0.0, 1.0].into_iter().enumerate() {
                        let k = 2 * row + column;
                        positions[k] = centre + side * (2.0 * u - 1.0);
                        normals[k] = round(face, crown.outward(positions[k]), towards);
                        uvs[k] = Vec2::new(u, v);
                    }
                }
                for (quad, corners) in indices.chunks_exact_mut(6).enumerate() {
                    let a = first + 2 * quad as u32;
                    corners.copy_from_slice(&[a, a + 1, a + 3, a, a + 3, a + 2]);
                }
                first += nv as u32;
            }
            Ok(())
        })
}

/// A unit normal between the card's own and the crown's, the latter on the card's side.
fn round(face: Vec3, outward: Option<Vec3>, towards: f32) -> Vec3 {
    let Some(outward) = outward else { return face };
    (face * (1.0 - towards.abs()) + outward * towards).try_normalize().unwrap_or(face)
}
