//! What a file held.

use super::TREE_N_NOTES;
use crate::border::Versioned;
use ::tree_mesh::io::{ImportReport, Note};

/// What a file held, and what was left out or changed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_import_report {
    /// `sizeof(tree_import_report)`.
    pub struct_size: usize,
    /// Nodes of the scene (glTF), objects and groups (OBJ), 1 for PLY.
    pub n_nodes: u64,
    /// Surfaces made.
    pub n_surfaces: u64,
    /// Vertices of all surfaces.
    pub n_vertices: u64,
    /// Triangles of all surfaces.
    pub n_triangles: u64,
    /// Copies that `EXT_mesh_gpu_instancing` asked for.
    pub n_instances: u64,
    /// Textures decoded.
    pub n_textures: u64,
    /// How often each thing was left out or changed, by `TREE_NOTE_` constants; `tree_note_text` says
    /// what they mean.
    pub notes: [u64; TREE_N_NOTES],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_import_report {
    const NAME: &'static str = "tree_import_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&ImportReport::default())
    }
}

impl tree_import_report {
    pub(super) fn of(report: &ImportReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: report.n_nodes as u64,
            n_surfaces: report.n_surfaces as u64,
            n_vertices: report.n_vertices as u64,
            n_triangles: report.n_triangles as u64,
            n_instances: report.n_instances as u64,
            n_textures: report.n_textures as u64,
            notes: Note::ALL.map(|note| report.count(note)),
        }
    }
}
