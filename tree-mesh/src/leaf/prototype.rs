//! One leaf of a kind, made ready to be set down a million times.
//!
//! Vertices that share normal and tangent share a *frame*, so that a card turns and softens one
//! normal instead of four.

use super::cover::{self, Cover};
use super::form::{LeafForm, LeafMesh, LeafModel};
use super::sheet::{self, Curve};
use super::{chain, ring};
use crate::error::Result;
use crate::look::LeafLook;
use crate::mesh::{Material, Texture};
use crate::params::MeshParams;
use glam::{Mat3, Vec2, Vec3};

/// Sides of a petiole.
pub(crate) const PETIOLE_SIDES: usize = 3;
/// Vertices of a petiole: a ring at each end, doubled at the seam.
pub(crate) const PETIOLE_VERTICES: usize = 2 * (PETIOLE_SIDES + 1);
/// Share of a leaf's light-map cell that a petiole takes, at the right.
const PETIOLE_CELL: f32 = 0.1;

/// Normal and tangent of some vertices of the prototype.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) normal: Vec3,
    pub(crate) tangent: Vec3,
    /// Sign of the bitangent.
    pub(crate) sign: f32,
    /// The side the sheet faces: soft normals stay on it.
    pub(crate) side: Vec3,
}

/// A leaf kind in its own frame, all factors counted in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prototype {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) frames: Vec<Frame>,
    /// Frame of each vertex.
    pub(crate) frame_of: Vec<u32>,
    /// Texture coordinates; those of the petiole come last.
    pub(crate) uvs: Vec<Vec2>,
    /// Place in the leaf's cell of the light map, 0 to 1.
    pub(crate) cells: Vec<Vec2>,
    pub(crate) indices: Vec<u32>,
    /// Radius of the petiole in lengths of the leaf; 0 for none.
    pub(crate) petiole: f32,
    /// Middle of the leaf.
    pub(crate) middle: Vec3,
    /// Whether the picture could not be outlined.
    pub(crate) fallback: bool,
    pub(crate) opaque: bool,
}

impl Prototype {
    /// The leaf of a checked look.
    pub(crate) fn new(look: &LeafLook, params: &MeshParams) -> Result<Self> {
        let made = model(look)?;
        let (length, width) = (params.leaf_scale, params.leaf_scale * params.leaf_width);
        let scale = Vec3::new(width, length, length);
        let mesh = &made.mesh;
        let own = matches!(look.form, LeafForm::Mesh(_));
        let tangents = tangents(mesh, scale);
        let petiole = 0.5 * look.petiole * length;
        let across = if petiole > 0.0 { 1.0 - PETIOLE_CELL } else { 1.0 };
        let plane = plane_cells(mesh);
        let mut out =
            Self { petiole, fallback: made.fallback, opaque: made.opaque, ..Default::default() };
        let n_sheets = look.sheets.max(1);
        for sheet in 0..n_sheets {
            let turn = Mat3::from_rotation_y(std::f32::consts::PI * sheet as f32 / n_sheets as f32);
            let first = out.positions.len() as u32;
            for (i, &position) in mesh.positions.iter().enumerate() {
                out.positions.push(turn * (position * scale));
                let normal = (mesh.normals[i] / scale).normalize_or(Vec3::Z);
                let (tangent, sign) = tangents[i];
                let side = turn * if own { normal } else { Vec3::Z };
                out.push_frame(Frame {
                    normal: turn * normal,
                    tangent: turn * tangent,
                    sign,
                    side,
                });
                let cell = mesh.uvs2.get(i).or(plane.get(i)).copied().unwrap_or_default();
                let x = across * (sheet as f32 + 0.96 * cell.x) / n_sheets as f32;
                out.cells.push(Vec2::new(x, cell.y));
            }
            out.uvs.extend(&mesh.uvs);
            out.indices.extend(mesh.indices.iter().map(|i| first + i));
        }
        out.middle = 0.5 * (min(&out.positions) + max(&out.positions));
        if petiole > 0.0 {
            out.push_petiole(&look.material);
        }
        Ok(out)
    }

    pub(crate) fn n_vertices(&self) -> usize {
        self.uvs.len()
    }

    pub(crate) fn n_indices(&self) -> usize {
        self.indices.len()
    }

    fn push_frame(&mut self, frame: Frame) {
        let found = self.frames.iter().position(|&other| other == frame);
        let number = found.unwrap_or_else(|| {
            self.frames.push(frame);
            self.frames.len() - 1
        });
        self.frame_of.push(number as u32);
    }

    /// Texture and triangles of the petiole: base ring first, then the one at the lamina.
    fn push_petiole(&mut self, material: &Material) {
        let first = self.positions.len() as u32;
        let (u, v) = stalk(material.texture.as_deref());
        let n = PETIOLE_SIDES as u32;
        for end in 0..2 {
            for side in 0..=n {
                self.uvs.push(Vec2::new(u, v));
                let x = 1.0 - PETIOLE_CELL * (0.8 - 0.8 * side as f32 / n as f32);
                self.cells.push(Vec2::new(x, 1.0 - end as f32));
            }
        }
        for side in 0..n {
            let (a, b) = (first + side, first + side + n + 1);
            self.indices.extend([a, a + 1, b + 1, a, b + 1, b]);
        }
    }
}

/// The mesh of one leaf of this look, without petiole and with one sheet.
pub(crate) fn model(look: &LeafLook) -> Result<LeafModel> {
    let curve = Curve { fold: look.fold, bend: look.bend, rows: look.rows };
    let card = |fallback, visible| LeafModel {
        mesh: sheet::ladder(&CARD, look.width, curve),
        fallback,
        opaque: false,
        visible,
        drawn: 1.0,
    };
    let (max_vertices, modelled) = match &look.form {
        LeafForm::Card => {
            let visible = Cover::of(&look.material)?.map_or(1.0, |cover| cover.visible);
            return Ok(card(false, visible));
        }
        LeafForm::Mesh(mesh) => {
            let mesh = LeafMesh::clone(mesh);
            return Ok(LeafModel {
                mesh,
                fallback: false,
                opaque: false,
                visible: 1.0,
                drawn: 1.0,
            });
        }
        LeafForm::Outline { max_vertices } => (*max_vertices as usize, false),
        LeafForm::Modelled { max_vertices } => (*max_vertices as usize, true),
    };
    let Some(cover) = Cover::of(&look.material)? else { return Ok(card(true, 1.0)) };
    let reach = cover.reach();
    let side = |reach_of: &[f32]| chain::around(&reach.heights, reach_of, max_vertices / 2, 0.5);
    let (drawn, mesh) = if modelled {
        let half = cover::close(ring::thin(cover.margin(), max_vertices / 2));
        (2.0 * ring::area(&half), sheet::ladder(&half, look.width, curve))
    } else if curve.is_flat() {
        let left = side(&reach.left).into_iter().rev().map(|p| Vec2::new(0.5 - p.x, p.y));
        let right = side(&reach.right).into_iter().map(|p| Vec2::new(0.5 + p.x, p.y));
        let polygon: Vec<Vec2> = right.chain(left).collect();
        (ring::area(&polygon), sheet::flat(&polygon, look.width))
    } else {
        let both: Vec<f32> = reach.left.iter().zip(&reach.right).map(|(a, b)| a.max(*b)).collect();
        let half = cover::close(side(&both));
        (2.0 * ring::area(&half), sheet::ladder(&half, look.width, curve))
    };
    let opaque = modelled;
    Ok(LeafModel { mesh, fallback: false, opaque, visible: cover.visible, drawn })
}

/// Right half of a card.
const CARD: [Vec2; 4] = [Vec2::ZERO, Vec2::new(0.5, 0.0), Vec2::new(0.5, 1.0), Vec2::new(0.0, 1.0)];

/// For each vertex the direction in which u grows, along the surface, and the bitangent's sign. The
/// mean over the triangles around it, exact where they are in one plane.
fn tangents(mesh: &LeafMesh, scale: Vec3) -> Vec<(Vec3, f32)> {
    let mut sums = vec![(Vec3::ZERO, Vec3::ZERO); mesh.positions.len()];
    for t in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| i as usize);
        let (p, q) = (mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        let (p, q) = (p * scale, q * scale);
        let (s, t) = (mesh.uvs[b] - mesh.uvs[a], mesh.uvs[c] - mesh.uvs[a]);
        let turn = if s.perp_dot(t) < 0.0 { -1.0 } else { 1.0 };
        let (along_u, along_v) = ((p * t.y - q * s.y) * turn, (q * s.x - p * t.x) * turn);
        for i in [a, b, c] {
            sums[i].0 += along_u;
            sums[i].1 += along_v;
        }
    }
    let finish = |(&normal, (u, v)): (&Vec3, (Vec3, Vec3))| {
        let normal = (normal / scale).normalize_or(Vec3::Z);
        let tangent = (u - normal * normal.dot(u))
            .try_normalize()
            .unwrap_or_else(|| normal.any_orthonormal_vector());
        // The bitangent points against v, up the picture.
        let sign = if normal.cross(tangent).dot(v) > 0.0 { -1.0 } else { 1.0 };
        (tangent, sign)
    };
    mesh.normals.iter().zip(sums).map(finish).collect()
}

/// Places above the leaf's plane, scaled to fill a cell.
fn plane_cells(mesh: &LeafMesh) -> Vec<Vec2> {
    let (low, high) = (min(&mesh.positions).truncate(), max(&mesh.positions).truncate());
    let size = (high - low).max(Vec2::splat(1e-6));
    let place = |p: &Vec3| {
        let share = (p.truncate() - low) / size;
        Vec2::new(share.x, 1.0 - share.y).clamp(Vec2::ZERO, Vec2::ONE)
    };
    mesh.positions.iter().map(place).collect()
}

fn min(points: &[Vec3]) -> Vec3 {
    points.iter().copied().reduce(Vec3::min).unwrap_or_default()
}

fn max(points: &[Vec3]) -> Vec3 {
    points.iter().copied().reduce(Vec3::max).unwrap_or_default()
}

/// Where the picture shows the stalk: the middle of the lowest row of which half can be seen at all.
fn stalk(texture: Option<&Texture>) -> (f32, f32) {
    let Some(texture) = texture.filter(|texture| texture.check().is_ok()) else {
        return (0.5, 0.5);
    };
    let solid = |pixel: &[u8]| pixel[3] >= 128;
    for (row, pixels) in texture.pixels.chunks_exact(4 * texture.width as usize).enumerate().rev() {
        let first = pixels.chunks_exact(4).position(solid);
        let last = pixels.chunks_exact(4).rposition(solid);
        if let (Some(first), Some(last)) = (first, last) {
            let middle = first + (last - first) / 2;
            let share = |at: usize, of: u32| (at as f32 + 0.5) / of as f32;
            return (share(middle, texture.width), share(row, texture.height));
        }
    }
    (0.5, 0.5)
}
