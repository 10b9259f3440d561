//! From levels to the document and the buffer of a file: meshes, nodes and the scene.

use super::container::BYTES_MAX;
use super::container::too_large;
use super::material::{self, Materials};
use super::quantize::{Cube, signed16};
use super::{GlbOptions, Instances, Level};
use crate::error::{MeshError, Result};
use crate::io::names::Unique;
use crate::mesh::{Mesh, Surface};
use glam::Vec3;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use tree_core::check_parameter;

pub(super) const BYTE: u32 = 5120;
pub(super) const UNSIGNED_BYTE: u32 = 5121;
pub(super) const SHORT: u32 = 5122;
pub(super) const UNSIGNED_SHORT: u32 = 5123;
pub(super) const UNSIGNED_INT: u32 = 5125;
pub(super) const FLOAT: u32 = 5126;
/// Targets of buffer views.
pub(super) const VERTICES: u32 = 34_962;
pub(super) const INDICES: u32 = 34_963;

/// What goes into files.
pub(super) struct Pack {
    pub(super) json: Vec<u8>,
    pub(super) binary: Vec<u8>,
    /// Names and contents of PNG files; empty when they are in `binary`.
    pub(super) pictures: Vec<(String, Vec<u8>)>,
}

/// Packs the levels. With a `stem`, buffer and pictures are files of that name; without, the buffer is
/// the second chunk of a GLB.
pub(super) fn pack(levels: &[Level<'_>], options: &GlbOptions, stem: Option<&str>) -> Result<Pack> {
    check(levels)?;
    let mut writer = Writer::new(options);
    let mut roots = Vec::with_capacity(levels.len());
    for (number, level) in levels.iter().enumerate() {
        roots.push(writer.level(number, level)?);
    }
    writer.link_levels(&roots, levels);
    writer.finish(&roots[..roots.len().min(1)], stem)
}

pub(super) fn check(levels: &[Level<'_>]) -> Result<()> {
    let mut coverage = f32::INFINITY;
    for level in levels {
        let instanced = level.instances.iter().map(|instances| &instances.mesh);
        for mesh in std::iter::once(level.mesh).chain(instanced) {
            mesh.check()?;
            mesh.check_normals()?;
            mesh.check_colors()?;
        }
        for instances in level.instances {
            instances.check()?;
            if instances.mesh.n_triangles() == 0 {
                return Err(MeshError::NoTriangles);
            }
        }
        if level.mesh.n_triangles() == 0 && level.instances.is_empty() {
            return Err(MeshError::NoTriangles);
        }
        super::scene::check_attributes(level)?;
        if levels.len() > 1 {
            check_parameter("coverage", level.coverage, 0.0, coverage.min(1.0))?;
            coverage = level.coverage;
        }
    }
    if levels.is_empty() { Err(MeshError::NoTriangles) } else { Ok(()) }
}

/// What an accessor says of its column.
pub(super) struct Column {
    pub(super) n: usize,
    pub(super) component: u32,
    pub(super) shape: &'static str,
    pub(super) normalized: bool,
    /// Bytes from row to row when there is padding.
    pub(super) stride: Option<usize>,
    pub(super) min_max: Option<(Value, Value)>,
}

impl Column {
    /// Rows without padding, as they are.
    pub(super) fn plain(n: usize, component: u32, shape: &'static str) -> Self {
        Self { n, component, shape, normalized: false, stride: None, min_max: None }
    }

    /// Integers that stand for fractions of 1.
    pub(super) fn normalized(n: usize, component: u32, shape: &'static str) -> Self {
        Self { normalized: true, ..Self::plain(n, component, shape) }
    }
}

/// The document and its buffer, as they grow.
pub(super) struct Writer<'a> {
    pub(super) options: &'a GlbOptions,
    pub(super) materials: Materials<'a>,
    pub(super) extensions: BTreeSet<&'static str>,
    /// Extensions without which the file looks wrong.
    pub(super) required: BTreeSet<&'static str>,
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    pub(super) meshes: Vec<Value>,
    pub(super) nodes: Vec<Value>,
    pub(super) skins: Vec<Value>,
    pub(super) animations: Vec<Value>,
    /// Meshes seen so far.
    n_sources: usize,
}

impl<'a> Writer<'a> {
    pub(super) fn new(options: &'a GlbOptions) -> Self {
        Self {
            options,
            materials: Materials::default(),
            extensions: BTreeSet::new(),
            required: BTreeSet::new(),
            binary: Vec::new(),
            views: Vec::new(),
            accessors: Vec::new(),
            meshes: Vec::new(),
            nodes: Vec::new(),
            skins: Vec::new(),
            animations: Vec::new(),
            n_sources: 0,
        }
    }

    /// Adds a level. Returns its node, which has children when there are instances.
    fn level(&mut self, number: usize, level: &Level<'a>) -> Result<usize> {
        let name = match number {
            0 => self.options.name.clone(),
            _ => format!("{} LOD{number}", self.options.name),
        };
        let mut nodes = Vec::new();
        if level.mesh.n_triangles() > 0 {
            let cube = self.options.quantize.then(|| Cube::around(level.mesh.bounds()));
            let mesh = self.mesh(level.mesh, &name, cube, level.attributes)?;
            let mut node = json!({ "name": name, "mesh": mesh });
            if let Some(cube) = cube {
                node["translation"] = json!(cube.corner.to_array());
                node["scale"] = json!([cube.side, cube.side, cube.side]);
            }
            nodes.push(push(&mut self.nodes, node));
        }
        for instances in level.instances {
            nodes.push(self.instances(instances)?);
        }
        match nodes[..] {
            [one] => Ok(one),
            _ => Ok(push(&mut self.nodes, json!({ "name": name, "children": nodes }))),
        }
    }

    pub(super) fn mesh(
        &mut self,
        mesh: &'a Mesh,
        name: &str,
        cube: Option<Cube>,
        attributes: &[super::Attribute],
    ) -> Result<usize> {
        let source = self.n_sources;
        self.n_sources += 1;
        let mut primitives = Vec::with_capacity(mesh.surfaces.len());
        let drawn = |(_, surface): &(usize, &Surface)| surface.n_triangles() > 0;
        for (number, surface) in mesh.surfaces.iter().enumerate().filter(drawn) {
            let own = attributes.iter().filter(|attribute| attribute.surface == number);
            let material = mesh.materials.get(surface.material as usize);
            primitives.push(self.primitive(source, surface, material, cube, own)?);
        }
        Ok(push(&mut self.meshes, json!({ "name": name, "primitives": primitives })))
    }

    /// Adds a node that draws its mesh many times.
    fn instances(&mut self, instances: &'a Instances) -> Result<usize> {
        let name = &instances.name;
        let mesh = self.mesh(&instances.mesh, name, None, &[])?;
        let n = instances.translations.len();
        let floats = |rows: &[Vec3]| {
            let numbers: Vec<f32> = rows.iter().flat_map(|row| row.to_array()).collect();
            move |bytes: &mut Vec<u8>| push_floats(bytes, numbers)
        };
        let translation =
            self.column(Column::plain(n, FLOAT, "VEC3"), None, floats(&instances.translations))?;
        let rotations = instances.rotations.iter().flat_map(|q| q.to_array());
        let rotation = if self.options.quantize {
            self.column(Column::normalized(n, SHORT, "VEC4"), None, |bytes| {
                for value in rotations {
                    bytes.extend_from_slice(&signed16(value).to_le_bytes());
                }
            })?
        } else {
            self.column(Column::plain(n, FLOAT, "VEC4"), None, |bytes| {
                push_floats(bytes, rotations);
            })?
        };
        let scale =
            self.column(Column::plain(n, FLOAT, "VEC3"), None, floats(&instances.scales))?;
        const NAME: &str = "EXT_mesh_gpu_instancing";
        self.extensions.insert(NAME);
        self.required.insert(NAME);
        let attributes =
            json!({ "TRANSLATION": translation, "ROTATION": rotation, "SCALE": scale });
        let node = json!({
            "name": name, "mesh": mesh, "extensions": { NAME: { "attributes": attributes } },
        });
        Ok(push(&mut self.nodes, node))
    }

    fn link_levels(&mut self, roots: &[usize], levels: &[Level<'_>]) {
        let [first, coarser @ ..] = roots else { return };
        if let Some(node) = self.nodes.get_mut(*first).filter(|_| !coarser.is_empty()) {
            let coverages: Vec<f32> = levels.iter().map(|level| level.coverage).collect();
            node["extensions"]["MSFT_lod"] = json!({ "ids": coarser });
            node["extras"] = json!({ "MSFT_screencoverage": coverages });
            self.extensions.insert("MSFT_lod");
        }
    }

    /// Adds a column of `n` rows.
    pub(super) fn column(
        &mut self,
        column: Column,
        target: Option<u32>,
        write: impl FnOnce(&mut Vec<u8>),
    ) -> Result<usize> {
        let view = self.view(target, column.stride, write)?;
        let mut accessor = json!({
            "bufferView": view,
            "componentType": column.component,
            "count": column.n,
            "type": column.shape,
        });
        if column.normalized {
            accessor["normalized"] = true.into();
        }
        if let Some((min, max)) = column.min_max {
            accessor["min"] = min;
            accessor["max"] = max;
        }
        Ok(push(&mut self.accessors, accessor))
    }

    /// Adds a view of the bytes that are written, padded to four behind.
    fn view(
        &mut self,
        target: Option<u32>,
        stride: Option<usize>,
        write: impl FnOnce(&mut Vec<u8>),
    ) -> Result<usize> {
        let start = self.binary.len();
        write(&mut self.binary);
        let length = self.binary.len() - start;
        if self.binary.len() > BYTES_MAX {
            return Err(too_large());
        }
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": length });
        if let Some(stride) = stride {
            view["byteStride"] = stride.into();
        }
        if let Some(target) = target {
            view["target"] = target.into();
        }
        Ok(push(&mut self.views, view))
    }

    pub(super) fn finish(mut self, roots: &[usize], stem: Option<&str>) -> Result<Pack> {
        let textures = self.materials.textures();
        let mut names = Unique::default();
        let mut pictures = Vec::new();
        let mut images = Vec::with_capacity(textures.len());
        for (texture, png) in textures.iter().zip(material::pictures(&textures)?) {
            let name = &texture.name;
            images.push(match stem {
                Some(stem) => {
                    let file = format!("{stem}_{}.png", names.name(name, "texture"));
                    let image = json!({ "name": name, "uri": file });
                    pictures.push((file, png));
                    image
                }
                None => {
                    let view = self.view(None, None, |bytes| bytes.extend_from_slice(&png))?;
                    json!({ "name": name, "bufferView": view, "mimeType": "image/png" })
                }
            });
        }
        let texture = |(i, texture): (usize, &&std::sync::Arc<crate::mesh::Texture>)| json!({ "name": texture.name, "sampler": 0, "source": i });
        let described: Vec<Value> = textures.iter().enumerate().map(texture).collect();
        let samplers = if images.is_empty() { vec![] } else { vec![material::sampler()] };
        let (materials, extensions) = self.materials.json(self.options);
        self.extensions.extend(&extensions);
        if extensions.contains(&"KHR_texture_transform") {
            self.required.insert("KHR_texture_transform");
        }
        let mut buffer = json!({ "byteLength": self.binary.len() });
        if let Some(stem) = stem {
            buffer["uri"] = format!("{stem}.bin").into();
        }
        let mut json = Map::new();
        let generator = concat!("tree-mesh ", env!("CARGO_PKG_VERSION"));
        json.insert("asset".into(), json!({ "version": "2.0", "generator": generator }));
        json.insert("scene".into(), 0.into());
        json.insert("scenes".into(), json!([{ "nodes": roots }]));
        let strings = |set: &BTreeSet<&str>| set.iter().map(|&name| name.into()).collect();
        for (key, list) in [
            ("extensionsUsed", strings(&self.extensions)),
            ("extensionsRequired", strings(&self.required)),
            ("nodes", self.nodes),
            ("meshes", self.meshes),
            ("skins", self.skins),
            ("animations", self.animations),
            ("materials", materials),
            ("textures", described),
            ("images", images),
            ("samplers", samplers),
            ("accessors", self.accessors),
            ("bufferViews", self.views),
            ("buffers", vec![buffer]),
        ] {
            // Empty lists are not allowed.
            if !list.is_empty() {
                json.insert(key.into(), Value::Array(list));
            }
        }
        let json = serde_json::to_vec(&json).map_err(|error| MeshError::Gltf(error.to_string()))?;
        Ok(Pack { json, binary: self.binary, pictures })
    }
}

/// Adds to a list and returns the place.
pub(super) fn push(list: &mut Vec<Value>, value: Value) -> usize {
    list.push(value);
    list.len() - 1
}

pub(super) fn push_floats(bytes: &mut Vec<u8>, values: impl IntoIterator<Item = f32>) {
    for value in values {
        bytes.extend_from_slice(&value.to_le_bytes());
    }
}
