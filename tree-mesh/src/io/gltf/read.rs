//! From a document to a mesh: the default scene, with the transforms of its nodes applied.

use super::accessor::Columns;
use super::buffer::Buffers;
use super::container::{malformed, split};
use super::document::{Document, Instancing, Node};
use super::look::Looks;
use super::primitive::Reader;
use crate::error::{MeshError, Result};
use crate::io::import::{Beside, Budget, ImportOptions, ImportReport, Imported, Note, read_bytes};
use crate::mesh::Mesh;
use glam::{Affine3A, Mat4, Quat, Vec3};
use std::path::Path;
use tree_core::{Control, Resource};

/// Extensions that a file may require and that are understood, or do not change the triangles.
const KNOWN: [&str; 6] = [
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",
    "KHR_texture_basisu",
    "KHR_lights_punctual",
];
/// The same for families of extensions.
const KNOWN_PREFIXES: [&str; 2] = ["KHR_materials_", "MSFT_"];
/// Length of a quaternion below which it gives no direction.
const QUATERNION_MIN: f32 = 1e-6;

/// Reads a GLB or glTF file, recognised by its content.
///
/// Every triangle of the default scene (the first where none is marked, all nodes where there is no
/// scene) is read, one surface per primitive and node:
///
/// * triangles, strips and fans, indexed or not, sparse and quantised;
/// * transforms of nodes applied, triangles turned over where they mirror;
/// * copies of `EXT_mesh_gpu_instancing` written out, into one surface;
/// * base colour, its texture (PNG or JPEG), `KHR_texture_transform` applied to the coordinates, alpha
///   mask, roughness, two-sidedness, `KHR_materials_diffuse_transmission` as translucency;
/// * tangents, second texture coordinates (where the first are those of the base colour) and
///   `_OCCLUSION`.
///
/// Missing normals become smooth over triangles that share vertices. All else is left out, and what
/// of that matters is noted in the report. Of several levels of detail the finest is read.
///
/// # Errors
/// [`MeshError::Malformed`] with the place in the document, [`MeshError::Unsupported`] for compressed
/// meshes and required extensions that are not known, [`MeshError::External`], [`MeshError::Limit`]
/// (before the memory is taken; a third of the vertices counts as [`Limits::triangles`] does, and
/// [`Limits::input_bytes`] and [`Limits::pixels`] hold for all files and pictures together),
/// [`MeshError::Core`] when a file cannot be read, [`MeshError::Cancelled`].
///
/// [`Limits::triangles`]: tree_core::Limits::triangles
/// [`Limits::input_bytes`]: tree_core::Limits::input_bytes
/// [`Limits::pixels`]: tree_core::Limits::pixels
///
/// # Complexity
/// O(bytes + nodes + vertices + triangles + pixels).
pub fn read(
    path: impl AsRef<Path>,
    options: &ImportOptions,
    control: &Control,
) -> Result<Imported> {
    let path = path.as_ref();
    let bytes = read_bytes(path, control)?;
    from_parts(&bytes, Beside::new("glTF", Some(path), options, control), control)
}

/// Reads a GLB or glTF file in memory. Other files are never read.
///
/// # Errors
/// As [`read`].
pub fn from_slice(bytes: &[u8], control: &Control) -> Result<Imported> {
    control.limits.check(Resource::InputBytes, bytes.len() as u64)?;
    from_parts(bytes, Beside::new("glTF", None, &ImportOptions::default(), control), control)
}

fn from_parts(bytes: &[u8], mut beside: Beside<'_>, control: &Control) -> Result<Imported> {
    let (json, binary) = split(bytes)?;
    let document: Document =
        serde_json::from_slice(json).map_err(|error| malformed("JSON", error.to_string()))?;
    for name in document.extensions_required.iter() {
        let known = KNOWN.contains(&name.as_str())
            || KNOWN_PREFIXES.iter().any(|prefix| name.starts_with(prefix));
        if !known {
            let name: String = name.chars().take(64).collect();
            return Err(MeshError::Unsupported { format: "glTF", what: name });
        }
    }
    let buffers = Buffers::load(&document, binary, &mut beside)?;
    let columns = Columns { document: &document, buffers: &buffers, n_bytes: bytes.len() as u64 };
    let mut report = ImportReport::default();
    let looks = Looks::new(columns, &mut report);
    let mut reader = Reader {
        columns,
        looks,
        beside,
        budget: Budget::default(),
        mesh: Mesh::default(),
        report,
        control,
    };
    reader.scene()?;
    let Reader { looks, mut mesh, mut report, .. } = reader;
    mesh.materials = looks.materials;
    if mesh.n_triangles() == 0 {
        return Err(malformed("scene", "no node of it has a triangle"));
    }
    mesh.check()?;
    report.finish(&mesh);
    Ok(Imported { mesh, report })
}

impl Reader<'_> {
    /// Reads all nodes of the default scene, parents before children.
    fn scene(&mut self) -> Result<()> {
        let document = self.columns.document;
        let mut is_child = vec![false; document.nodes.len()];
        for (number, node) in document.nodes.iter().enumerate() {
            for &child in node.children.iter() {
                let known = is_child.get_mut(child).ok_or_else(|| {
                    malformed(format!("node {number}"), format!("child {child} does not exist"))
                })?;
                if std::mem::replace(known, true) {
                    let place = format!("node {number}");
                    return Err(malformed(place, format!("child {child} has another parent")));
                }
            }
        }
        let roots: Vec<usize> = match document.scenes.get(document.scene.unwrap_or(0)) {
            Some(scene) => scene.nodes.to_vec(),
            None if document.scene.is_some() => {
                return Err(malformed("scene", "the default scene does not exist"));
            }
            None => (0..is_child.len()).filter(|&node| !is_child[node]).collect(),
        };
        // Nodes that are roots go first: one that is also listed although it is the child of another
        // is then drawn once, where its parent puts it.
        let mut visited = vec![false; document.nodes.len()];
        for wanted in [false, true] {
            for &root in &roots {
                let Some(&child) = is_child.get(root) else {
                    return Err(malformed("scene", format!("node {root} does not exist")));
                };
                if child == wanted {
                    if child {
                        self.report.note(Note::ListedTwice);
                    }
                    self.walk(root, &mut visited)?;
                }
            }
        }
        Ok(())
    }

    fn walk(&mut self, root: usize, visited: &mut [bool]) -> Result<()> {
        let document = self.columns.document;
        let mut stack = vec![(root, Affine3A::IDENTITY)];
        while let Some((number, parent)) = stack.pop() {
            let (Some(node), Some(visited)) = (document.nodes.get(number), visited.get_mut(number))
            else {
                continue;
            };
            // Listed as a root as well, or on a cycle.
            if std::mem::replace(visited, true) {
                continue;
            }
            self.control.check()?;
            self.report.n_nodes += 1;
            let transform = parent * local(node);
            self.node(number, node, transform)?;
            stack.extend(node.children.iter().rev().map(|&child| (child, transform)));
        }
        Ok(())
    }

    fn node(&mut self, number: usize, node: &Node, transform: Affine3A) -> Result<()> {
        let Some(mesh) = node.mesh else { return Ok(()) };
        if !transform.is_finite() {
            return Err(malformed(format!("node {number}"), "its transform is not finite"));
        }
        if node.skin.is_some() {
            self.report.note(Note::Deformations);
        }
        let instancing = node.extensions.as_ref().and_then(|all| all.instancing.as_ref());
        let copies = match instancing {
            Some(instancing) => {
                let copies = self.copies(number, instancing, transform)?;
                self.report.n_instances += copies.len();
                copies
            }
            None => vec![transform],
        };
        if copies.is_empty() { Ok(()) } else { self.mesh(mesh, &copies) }
    }

    /// Where the copies of an instanced mesh stand.
    fn copies(
        &mut self,
        number: usize,
        instancing: &Instancing,
        transform: Affine3A,
    ) -> Result<Vec<Affine3A>> {
        let column = |name: &str| {
            let accessor = instancing.attributes.get(name);
            accessor.map(|&accessor| self.columns.get(accessor)).transpose()
        };
        let (translations, rotations, scales) =
            (column("TRANSLATION")?, column("ROTATION")?, column("SCALE")?);
        let given =
            [&translations, &rotations, &scales].map(|column| column.as_ref().map(|c| c.len()));
        let n = given.into_iter().flatten().next().unwrap_or(0);
        if given.into_iter().flatten().any(|length| length != n) {
            return Err(malformed(
                format!("node {number}"),
                "EXT_mesh_gpu_instancing has columns of different lengths",
            ));
        }
        self.budget.take(0, n as u64, &self.control.limits)?;
        let all = |column: Option<super::accessor::Column<'_>>, default: f32| match column {
            Some(column) => column.vectors::<3>(),
            None => Ok(vec![[default; 3]; n]),
        };
        let (translations, scales) = (all(translations, 0.0)?, all(scales, 1.0)?);
        let rotations = match rotations {
            Some(column) => column.vectors::<4>()?,
            None => vec![[0.0, 0.0, 0.0, 1.0]; n],
        };
        let rows = translations.into_iter().zip(rotations).zip(scales);
        let copies: Vec<Affine3A> = rows.map(|((t, r), s)| transform * placed(t, r, s)).collect();
        match copies.iter().position(|copy| !copy.is_finite()) {
            Some(row) => {
                Err(malformed(format!("node {number}"), format!("instance {row} is not finite")))
            }
            None => Ok(copies),
        }
    }
}

/// The transform of a node itself.
fn local(node: &Node) -> Affine3A {
    match &node.matrix {
        Some(matrix) => Affine3A::from_mat4(Mat4::from_cols_array(matrix)),
        None => placed(
            node.translation.unwrap_or_default(),
            node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]),
            node.scale.unwrap_or([1.0; 3]),
        ),
    }
}

fn placed(translation: [f32; 3], rotation: [f32; 4], scale: [f32; 3]) -> Affine3A {
    let rotation = Quat::from_array(rotation);
    let length = rotation.length();
    // NaN and infinity go through, and are refused with the transform they make.
    let rotation = if length < QUATERNION_MIN { Quat::IDENTITY } else { rotation * (1.0 / length) };
    Affine3A::from_scale_rotation_translation(Vec3::from(scale), rotation, Vec3::from(translation))
}
