//! A tree in pieces, one for each branch, so that any set of branches can be drawn.

use super::Outcome;
use std::ops::Range;
use tree_core::{Control, Tree};
use tree_lod::cover::{Around, Bits, Stage};
use tree_lod::multires::{Adt, Draw, Metric, MultiMesh, Multires, paths};
use tree_lod::preview::Camera;
use tree_lod::quality::{Score, mean_quality};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams, Surface};

/// Wood of a tree as a silhouette needs it.
const PARAMS: MeshParams = MeshParams {
    continuation: tree_core::Continuation::Thickest,
    sides_min: 3,
    sides_max: 8,
    error: ErrorBound::Metres(0.003),
    fit: tree_mesh::CurveFit::Straight,
    strip_max: 1.0,
    radius_min: 0.0005,
    bark_width: 0.5,
    bark_length: 0.5,
    flare: 0.0,
    flare_height: 3.0,
    flare_lobes: 0,
    flare_lobe_depth: 0.0,
    leaf_scale: 1.0,
    leaf_width: 1.0,
    leaf_rounding: 0.6,
    tangents: false,
    lightmap: false,
};

/// A mesh whose triangles are known by branch. Branches are the runs between forks.
pub(super) struct Parts {
    pub(super) mesh: Mesh,
    /// For each surface, for each branch: its indices.
    ranges: Vec<Vec<Range<usize>>>,
}

impl Parts {
    /// Wood alone.
    pub(super) fn wood(tree: &Tree, adt: &Adt) -> Outcome<Self> {
        let bare = Tree::bare(tree.skeleton().clone(), tree.species().clone());
        Self::new(&bare, adt, &Look::plain(tree.species()))
    }

    /// All of it: a path for each branch gives a prefix for each, and their differences are the pieces.
    pub(super) fn new(tree: &Tree, adt: &Adt, look: &Look) -> Outcome<Self> {
        let control = Control::default();
        let paths = paths(adt, &Metric::Generation, &control)?;
        let (multires, _) = Multires::of_paths(tree, adt, &paths)?;
        let mesh = MultiMesh::new(&multires, look, &PARAMS, &control)?;
        let n_surfaces = mesh.mesh().surfaces.len();
        let mut ranges = vec![vec![0..0; adt.len()]; n_surfaces];
        let mut draws = vec![Draw::default(); n_surfaces];
        let mut before = vec![0; n_surfaces];
        for (path, &branch) in paths.branches().iter().enumerate() {
            mesh.draws((path + 1) as f32, &mut draws)?;
            for ((ranges, before), draw) in ranges.iter_mut().zip(&mut before).zip(&draws) {
                let end = draw.index_count as usize;
                ranges[branch as usize] = *before..end;
                *before = end;
            }
        }
        Ok(Self { mesh: mesh.mesh().clone(), ranges })
    }

    /// The mesh of some branches; vertices are those of the whole.
    pub(super) fn of(&self, branches: &[u32]) -> Mesh {
        let mut mesh = self.mesh.clone();
        for ((surface, full), ranges) in
            mesh.surfaces.iter_mut().zip(&self.mesh.surfaces).zip(&self.ranges)
        {
            surface.indices.clear();
            for &branch in branches {
                surface.indices.extend(&full.indices[ranges[branch as usize].clone()]);
            }
        }
        mesh
    }

    /// The wood of one branch as a mesh of its own; none when it is too short to be drawn.
    pub(super) fn one(&self, branch: u32) -> Option<Mesh> {
        let full = self.mesh.surfaces.first()?;
        let indices = &full.indices[self.ranges[0][branch as usize].clone()];
        let (first, last) = (*indices.iter().min()?, *indices.iter().max()?);
        let rows = first as usize..last as usize + 1;
        let surface = Surface {
            positions: full.positions[rows.clone()].to_vec(),
            normals: full.normals[rows.clone()].to_vec(),
            uvs: full.uvs[rows].to_vec(),
            indices: indices.iter().map(|i| i - first).collect(),
            ..Surface::default()
        };
        let materials = self.mesh.materials[..1].to_vec();
        Some(Mesh { surfaces: vec![surface], materials, ..Mesh::default() })
    }
}

/// Masks of a whole tree from all around.
pub(super) struct Masks {
    cameras: Vec<Camera>,
    size: u32,
    full: Vec<Bits>,
}

impl Masks {
    pub(super) fn new(mesh: &Mesh, around: &Around) -> Outcome<Self> {
        let placed = around.cameras().into_iter().map(|camera| camera.pose(mesh, 1.0));
        let cameras = placed.map(|pose| pose.map(Camera::Placed)).collect::<Result<Vec<_>, _>>()?;
        let stage = Stage::new(mesh, &cameras, around.size, &[], &Control::default())?;
        let full = (0..stage.n_views()).filter_map(|view| stage.full(view).cloned()).collect();
        Ok(Self { cameras, size: around.size, full })
    }

    /// What is covered in each view.
    pub(super) fn of(&self, mesh: &Mesh) -> Outcome<Vec<Bits>> {
        let stage = Stage::new(mesh, &self.cameras, self.size, &[], &Control::default())?;
        Ok((0..stage.n_views()).filter_map(|view| stage.full(view).cloned()).collect())
    }

    /// Mean quality of a mesh against the whole.
    pub(super) fn quality(&self, mesh: &Mesh) -> Outcome<f64> {
        let masks = self.of(mesh)?;
        let scores: Vec<Score> = masks.iter().zip(&self.full).map(|(a, b)| a.score(b)).collect();
        Ok(mean_quality(&scores))
    }
}
