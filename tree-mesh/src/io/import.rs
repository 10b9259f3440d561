//! What all readers share: options, the report, files beside the one that is read.

use crate::error::{MeshError, Result};
use crate::mesh::Mesh;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use tree_core::{Control, CoreError, Limits, Resource, file};

/// Longest name of a file that an error repeats.
const URI_SHOWN: usize = 200;

/// How files are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImportOptions {
    /// Whether files that the file names (buffers, textures, MTL) are read. Only those within its own
    /// folder and below are: no absolute path, no `..`, no scheme, no link that leads out. Default
    /// `false`: textures and materials are left out and noted, missing buffers are an error.
    pub external: bool,
}

/// A mesh and what became of the file on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// What was read; passes [`Mesh::check`], [`Mesh::check_normals`] and [`Mesh::check_colors`].
    pub mesh: Mesh,
    /// Counts and what was left out.
    pub report: ImportReport,
}

/// What a file held, and what was left out or changed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImportReport {
    /// Nodes of the scene (glTF), objects and groups (OBJ), 1 for PLY.
    pub n_nodes: usize,
    /// Surfaces made.
    pub n_surfaces: usize,
    /// Vertices of all surfaces.
    pub n_vertices: usize,
    /// Triangles of all surfaces.
    pub n_triangles: usize,
    /// Copies that `EXT_mesh_gpu_instancing` asked for.
    pub n_instances: usize,
    /// Textures decoded.
    pub n_textures: usize,
    /// What was left out or changed, and how often.
    pub notes: BTreeMap<Note, u64>,
}

impl ImportReport {
    /// How often this happened.
    #[must_use]
    pub fn count(&self, note: Note) -> u64 {
        self.notes.get(&note).copied().unwrap_or(0)
    }

    pub(super) fn note(&mut self, note: Note) {
        self.note_times(note, 1);
    }

    pub(super) fn note_times(&mut self, note: Note, times: u64) {
        if times > 0 {
            let count = self.notes.entry(note).or_default();
            *count = count.saturating_add(times);
        }
    }

    /// Fills in the counts of the mesh.
    pub(super) fn finish(&mut self, mesh: &Mesh) {
        self.n_surfaces = mesh.surfaces.len();
        self.n_vertices = mesh.n_vertices();
        self.n_triangles = mesh.n_triangles();
    }
}

/// Something a reader left out or changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Note {
    /// Primitives, elements or lines that are points or lines, left out.
    PointsOrLines,
    /// Primitives without positions, left out.
    NoPositions,
    /// Corners left over behind the last whole triangle, or faces with fewer than three.
    PartialFaces,
    /// Surfaces (OBJ: corners) whose normals were computed because there were none.
    NormalsComputed,
    /// Single normals of no length, computed from the triangles around.
    NormalsRepaired,
    /// Surfaces (OBJ: corners) without texture coordinates, which became 0.
    UvsMissing,
    /// Vertex colours, which a surface has no column for. PLY: their mean became the material's.
    VertexColors,
    /// Skins and morph targets; the mesh is as it rests.
    Deformations,
    /// Nodes a scene lists as roots although they are not.
    ListedTwice,
    /// Materials that blend by alpha, cut at one half instead.
    BlendAsMask,
    /// Normal, roughness, occlusion and emission maps, left out.
    OtherTextures,
    /// Colours and factors outside their range, brought back into it.
    Clamped,
    /// Textures and materials in other files, which were not asked for.
    ExternalRefused,
    /// Textures and materials in files that are not there.
    ExternalMissing,
    /// Textures that could not be decoded.
    TextureUnreadable,
    /// Textures without a picture in a known format.
    TextureUnsupported,
    /// Materials that faces name and no file defines.
    MaterialUnknown,
    /// Statements or elements that are not understood, passed over.
    Unknown,
}

impl Note {
    /// Every note.
    pub const ALL: [Self; 18] = [
        Self::PointsOrLines,
        Self::NoPositions,
        Self::PartialFaces,
        Self::NormalsComputed,
        Self::NormalsRepaired,
        Self::UvsMissing,
        Self::VertexColors,
        Self::Deformations,
        Self::ListedTwice,
        Self::BlendAsMask,
        Self::OtherTextures,
        Self::Clamped,
        Self::ExternalRefused,
        Self::ExternalMissing,
        Self::TextureUnreadable,
        Self::TextureUnsupported,
        Self::MaterialUnknown,
        Self::Unknown,
    ];

    /// What it says, for people.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::PointsOrLines => "points or lines left out",
            Self::NoPositions => "primitives without positions left out",
            Self::PartialFaces => "incomplete faces left out",
            Self::NormalsComputed => "normals computed",
            Self::NormalsRepaired => "normals of no length repaired",
            Self::UvsMissing => "texture coordinates missing",
            Self::VertexColors => "vertex colours not kept",
            Self::Deformations => "skins or morph targets not kept",
            Self::ListedTwice => "scene roots that are not roots",
            Self::BlendAsMask => "blended materials cut at one half",
            Self::OtherTextures => "normal, roughness or other maps not kept",
            Self::Clamped => "colours or factors brought into range",
            Self::ExternalRefused => "other files not read, because not asked for",
            Self::ExternalMissing => "other files not found",
            Self::TextureUnreadable => "textures that could not be decoded",
            Self::TextureUnsupported => "textures of an unsupported sort",
            Self::MaterialUnknown => "materials that are not defined",
            Self::Unknown => "statements passed over",
        }
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

/// Files beside the one that is read, and what may still be read of them.
#[derive(Debug)]
pub(super) struct Beside<'a> {
    format: &'static str,
    /// `None` when other files may not be read.
    folder: Option<PathBuf>,
    limits: &'a Limits,
    /// Bytes read so far: [`Limits::input_bytes`] holds for all files together.
    n_bytes: u64,
}

impl<'a> Beside<'a> {
    /// Files beside `path`, if the options allow them.
    pub(super) fn new(
        format: &'static str,
        path: Option<&Path>,
        options: &ImportOptions,
        control: &'a Control,
    ) -> Self {
        let folder = path.filter(|_| options.external).map(|path| match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
            _ => PathBuf::from("."),
        });
        Self { format, folder, limits: &control.limits, n_bytes: 0 }
    }

    /// Whether other files may be read at all.
    pub(super) fn allowed(&self) -> bool {
        self.folder.is_some()
    }

    /// Reads a file that the file names.
    ///
    /// # Errors
    /// [`MeshError::External`] when it was not asked for or lies elsewhere, [`MeshError::Core`] when
    /// it cannot be read, [`MeshError::Limit`].
    pub(super) fn read(&mut self, name: &str) -> Result<Vec<u8>> {
        let refuse = |problem| {
            let uri = name.chars().take(URI_SHOWN).collect();
            Err(MeshError::External { format: self.format, uri, problem })
        };
        let Some(folder) = &self.folder else {
            return refuse(
                "other files are read only when the import option `external` asks for them",
            );
        };
        let name = name.replace('\\', "/");
        let inside = !name.is_empty()
            && !name.contains([':', '\0'])
            && name.split('/').all(|part| part != "..")
            && !name.starts_with('/');
        if !inside {
            return refuse("only relative paths within the file's own folder are followed");
        }
        let path = folder.join(&name);
        let io = |error| CoreError::io(&path, error);
        let real = path.canonicalize().map_err(io)?;
        if !real.starts_with(folder.canonicalize().map_err(io)?) {
            return refuse("a link leads out of the file's own folder");
        }
        let left = self.limits.input_bytes.saturating_sub(self.n_bytes);
        let limits = Limits { input_bytes: left, ..*self.limits };
        let bytes = file::read_bytes(&real, &limits).map_err(|error| match error {
            CoreError::Limit(limit) => MeshError::Limit(tree_core::LimitError {
                requested: limit.requested.saturating_add(self.n_bytes),
                cap: self.limits.input_bytes,
                ..limit
            }),
            other => other.into(),
        })?;
        self.n_bytes += bytes.len() as u64;
        Ok(bytes)
    }
}

/// Reads the file itself.
pub(super) fn read_bytes(path: &Path, control: &Control) -> Result<Vec<u8>> {
    file::read_bytes(path, &control.limits).map_err(|error| match error {
        CoreError::Limit(limit) => MeshError::Limit(limit),
        other => other.into(),
    })
}

/// Whether the error only says that a file is not there.
pub(super) fn is_missing(error: &MeshError) -> bool {
    matches!(error, MeshError::Core(CoreError::Io { source, .. })
        if matches!(source.kind(), std::io::ErrorKind::NotFound | std::io::ErrorKind::IsADirectory))
}

/// What a mesh may still grow by: [`Limits::triangles`] for all surfaces together. Vertices count a
/// third of a triangle each, every surface at least one, so that a small file cannot ask for much
/// memory or time without triangles.
#[derive(Debug, Default)]
pub(super) struct Budget {
    triangles: u64,
    vertices: u64,
}

impl Budget {
    /// Asks before the memory is taken.
    pub(super) fn take(&mut self, triangles: u64, vertices: u64, limits: &Limits) -> Result<()> {
        self.triangles = self.triangles.saturating_add(triangles.max(1));
        self.vertices = self.vertices.saturating_add(vertices);
        limits.check(Resource::Triangles, self.triangles.max(self.vertices.div_ceil(3)))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Note;

    #[test]
    fn all_notes_are_listed_once_and_in_order() {
        assert!(Note::ALL.windows(2).all(|two| two[0] < two[1] && two[0].text() != two[1].text()));
        assert_eq!(Note::ALL[0], Note::PointsOrLines);
        assert_eq!(Note::ALL[17], Note::Unknown);
        assert_eq!(Note::Clamped.to_string(), Note::Clamped.text());
    }
}
