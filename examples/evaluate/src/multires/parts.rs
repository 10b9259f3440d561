//! A tree in pieces, one for each branch, so that any set of branches can be drawn.

use super::Outcome;
use std::ops::Range;
use tree_core::{Control, Tree};
use tree_lod::multires::{Adt, Draw, Metric, MultiMesh, Multires, paths};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams};

/// Wood of a tree as a silhouette needs it.
const PARAMS: MeshParams = MeshParams {
    continuation: tree_core::Continuation::Thickest,
    min_sides: 3,
    max_sides: 8,
    error: ErrorBound::Metres(0.003),
    fit: tree_mesh::CurveFit::Straight,
    max_strip: 1.0,
    min_radius: 0.0005,
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

    pub(super) fn n_branches(&self) -> usize {
        self.ranges.first().map_or(0, Vec::len)
    }

    /// The triangles of a branch: surface, and which of its triangles.
    pub(super) fn triangles(&self, branch: u32) -> impl Iterator<Item = (usize, Range<usize>)> {
        self.ranges.iter().enumerate().map(move |(surface, ranges)| {
            let Range { start, end } = ranges[branch as usize];
            (surface, start / 3..end / 3)
        })
    }
}
