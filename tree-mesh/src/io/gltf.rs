//! GLB: glTF 2.0 in one binary file, as the Khronos validator accepts it without error or warning.
//!
//! One node, one mesh, one primitive per surface with triangles. Positions, normals and texture
//! coordinates as 32-bit floats, indices as 16 bits where they suffice; each column is a buffer view
//! of its own. Textures are embedded as PNG, each once, however many materials share it. Materials no
//! primitive uses are left out. Translucency has no place in core glTF and is not written.
//!
//! Source: Khronos Group, *glTF 2.0 Specification*, 2021.

use crate::error::{MeshError, Result};
use crate::mesh::{Alpha, Material, Mesh, Surface, Texture};
use ::gltf::binary::{Glb, Header};
use ::gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use ::gltf::json::buffer::Target;
use ::gltf::json::material::{AlphaCutoff, AlphaMode, PbrBaseColorFactor, StrengthFactor};
use ::gltf::json::mesh::{Mode, Semantic};
use ::gltf::json::texture::{MagFilter, MinFilter, Sampler, WrappingMode};
use ::gltf::json::validation::{Checked, USize64};
use ::gltf::json::{self, Index, Root, Value};
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use tree_core::{Aabb, CoreError, file};

/// Most vertices that 16-bit indices can name: 0xFFFF restarts primitives.
const SHORT_VERTICES_MAX: usize = 0xFFFF;
/// As much for 32-bit indices.
const VERTICES_MAX: usize = 0xFFFF_FFFF;
/// A GLB states its length in 32 bits.
const BYTES_MAX: usize = u32::MAX as usize;

/// What goes into a GLB besides the mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GlbOptions {
    /// Name of the node and the mesh, for people and engines. Default `tree`.
    pub name: String,
}

impl Default for GlbOptions {
    fn default() -> Self {
        Self { name: "tree".into() }
    }
}

/// Writes a GLB file, whole or not at all.
///
/// # Errors
/// As [`to_glb`], and [`MeshError::Core`] when the file cannot be written.
pub fn write_glb(mesh: &Mesh, path: impl AsRef<Path>, options: &GlbOptions) -> Result<()> {
    let (path, bytes) = (path.as_ref(), to_glb(mesh, options)?);
    file::write_atomic(path, |out| {
        out.write_all(&bytes).map_err(|error| CoreError::io(path, error).into())
    })
}

/// A mesh as the bytes of a GLB file.
///
/// # Errors
/// [`MeshError::NoTriangles`], what [`Mesh::check`], [`Mesh::check_normals`] and
/// [`Mesh::check_colors`] find, [`MeshError::Image`] when a texture cannot be encoded,
/// [`MeshError::Gltf`] when the file would be larger than 4 GiB.
///
/// # Complexity
/// O(vertices + triangles + pixels); textures are encoded in parallel.
pub fn to_glb(mesh: &Mesh, options: &GlbOptions) -> Result<Vec<u8>> {
    mesh.check()?;
    mesh.check_normals()?;
    mesh.check_colors()?;
    let drawn: Vec<&Surface> =
        mesh.surfaces.iter().filter(|surface| surface.n_triangles() > 0).collect();
    if drawn.is_empty() {
        return Err(MeshError::NoTriangles);
    }
    let mut writer = Writer::default();
    let materials = writer.materials(mesh, &drawn)?;
    let mut primitives = Vec::with_capacity(drawn.len());
    for surface in drawn {
        primitives.push(writer.primitive(surface, &materials)?);
    }
    writer.finish(primitives, &options.name)
}

/// The document and its binary chunk, as they grow.
#[derive(Default)]
struct Writer {
    root: Root,
    bytes: Vec<u8>,
}

impl Writer {
    /// Adds the materials in use and their textures. Returns the place of each of the mesh's.
    fn materials(
        &mut self,
        mesh: &Mesh,
        drawn: &[&Surface],
    ) -> Result<BTreeMap<u32, Index<json::Material>>> {
        let mut used: Vec<u32> = drawn.iter().map(|surface| surface.material).collect();
        used.sort_unstable();
        used.dedup();
        let used: Vec<(u32, &Material)> = used
            .into_iter()
            .filter_map(|number| Some((number, mesh.materials.get(number as usize)?)))
            .collect();
        let mut textures: Vec<&Arc<Texture>> = Vec::new();
        for texture in used.iter().filter_map(|(_, m)| m.texture.as_ref()) {
            if !textures.iter().any(|known| Arc::ptr_eq(known, texture)) {
                textures.push(texture);
            }
        }
        let pictures: Vec<Vec<u8>> =
            textures.par_iter().map(|texture| texture.to_png()).collect::<Result<_>>()?;
        if !textures.is_empty() {
            self.root.push(Sampler {
                mag_filter: Some(Checked::Valid(MagFilter::Linear)),
                min_filter: Some(Checked::Valid(MinFilter::LinearMipmapLinear)),
                wrap_s: Checked::Valid(WrappingMode::Repeat),
                wrap_t: Checked::Valid(WrappingMode::Repeat),
                ..Default::default()
            });
        }
        for (texture, picture) in textures.iter().zip(pictures) {
            self.texture(texture, &picture)?;
        }
        let mut places = BTreeMap::new();
        for (number, material) in used {
            let texture = material
                .texture
                .as_ref()
                .and_then(|wanted| textures.iter().position(|known| Arc::ptr_eq(known, wanted)));
            places.insert(number, self.material(material, texture));
        }
        Ok(places)
    }

    fn texture(&mut self, texture: &Texture, picture: &[u8]) -> Result<()> {
        let view = self.view(picture.len(), None, |bytes| {
            bytes.extend_from_slice(picture);
        })?;
        let source = self.root.push(json::Image {
            buffer_view: Some(view),
            mime_type: Some(json::image::MimeType("image/png".into())),
            name: Some(texture.name.clone()),
            uri: None,
            extensions: None,
            extras: Default::default(),
        });
        self.root.push(json::Texture {
            name: Some(texture.name.clone()),
            sampler: Some(Index::new(0)),
            source,
            extensions: None,
            extras: Default::default(),
        });
        Ok(())
    }

    fn material(&mut self, material: &Material, texture: Option<usize>) -> Index<json::Material> {
        let (alpha_mode, alpha_cutoff) = match material.alpha {
            Alpha::Opaque => (AlphaMode::Opaque, None),
            Alpha::Mask(cutoff) => (AlphaMode::Mask, Some(AlphaCutoff(cutoff))),
        };
        let info = texture.map(|number| json::texture::Info {
            index: Index::new(number as u32),
            tex_coord: 0,
            extensions: None,
            extras: Default::default(),
        });
        self.root.push(json::Material {
            name: Some(material.name.clone()),
            alpha_mode: Checked::Valid(alpha_mode),
            alpha_cutoff,
            double_sided: material.double_sided,
            pbr_metallic_roughness: json::material::PbrMetallicRoughness {
                base_color_factor: PbrBaseColorFactor(material.base_color),
                base_color_texture: info,
                metallic_factor: StrengthFactor(0.0),
                roughness_factor: StrengthFactor(material.roughness),
                ..Default::default()
            },
            ..Default::default()
        })
    }

    fn primitive(
        &mut self,
        surface: &Surface,
        materials: &BTreeMap<u32, Index<json::Material>>,
    ) -> Result<json::mesh::Primitive> {
        let n = surface.positions.len();
        if n > VERTICES_MAX {
            return Err(MeshError::Gltf(format!(
                "{n} vertices in one primitive, 32-bit indices reach {VERTICES_MAX}"
            )));
        }
        let bounds = Aabb::of_points(&surface.positions);
        let corner = |corner: glam::Vec3| Value::from(corner.to_array().to_vec());
        let positions = self.column(
            12 * n,
            Target::ArrayBuffer,
            Column {
                n,
                component: ComponentType::F32,
                shape: Type::Vec3,
                min: Some(corner(bounds.min)),
                max: Some(corner(bounds.max)),
            },
            |bytes| push_all(bytes, surface.positions.iter().flat_map(|v| v.to_array())),
        )?;
        let floats =
            |shape| Column { n, component: ComponentType::F32, shape, min: None, max: None };
        let normals = self.column(12 * n, Target::ArrayBuffer, floats(Type::Vec3), |bytes| {
            push_all(bytes, surface.normals.iter().flat_map(|v| v.to_array()));
        })?;
        let uvs = self.column(8 * n, Target::ArrayBuffer, floats(Type::Vec2), |bytes| {
            push_all(bytes, surface.uvs.iter().flat_map(|v| v.to_array()));
        })?;
        let short = n <= SHORT_VERTICES_MAX;
        let n_indices = surface.indices.len();
        let (width, component) =
            if short { (2, ComponentType::U16) } else { (4, ComponentType::U32) };
        let column = Column { n: n_indices, component, shape: Type::Scalar, min: None, max: None };
        let indices =
            self.column(width * n_indices, Target::ElementArrayBuffer, column, |bytes| {
                for index in &surface.indices {
                    // Short indices lie in the two low bytes.
                    bytes.extend_from_slice(&index.to_le_bytes()[..width]);
                }
            })?;
        Ok(json::mesh::Primitive {
            attributes: BTreeMap::from([
                (Checked::Valid(Semantic::Positions), positions),
                (Checked::Valid(Semantic::Normals), normals),
                (Checked::Valid(Semantic::TexCoords(0)), uvs),
            ]),
            indices: Some(indices),
            material: materials.get(&surface.material).copied(),
            mode: Checked::Valid(Mode::Triangles),
            targets: None,
            extensions: None,
            extras: Default::default(),
        })
    }

    /// Adds a buffer view of exactly `length` bytes, padded to four.
    fn view(
        &mut self,
        length: usize,
        target: Option<Target>,
        write: impl FnOnce(&mut Vec<u8>),
    ) -> Result<Index<json::buffer::View>> {
        let start = self.bytes.len();
        if length > BYTES_MAX.saturating_sub(start) {
            return Err(too_large());
        }
        self.bytes.reserve(length + 3);
        write(&mut self.bytes);
        debug_assert_eq!(self.bytes.len(), start + length);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        Ok(self.root.push(json::buffer::View {
            buffer: Index::new(0),
            byte_length: USize64::from(length),
            byte_offset: Some(USize64::from(start)),
            byte_stride: None,
            name: None,
            target: target.map(Checked::Valid),
            extensions: None,
            extras: Default::default(),
        }))
    }

    fn column(
        &mut self,
        length: usize,
        target: Target,
        column: Column,
        write: impl FnOnce(&mut Vec<u8>),
    ) -> Result<Index<json::Accessor>> {
        let view = self.view(length, Some(target), write)?;
        Ok(self.root.push(json::Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: USize64::from(column.n),
            component_type: Checked::Valid(GenericComponentType(column.component)),
            type_: Checked::Valid(column.shape),
            min: column.min,
            max: column.max,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: Default::default(),
        }))
    }

    fn finish(mut self, primitives: Vec<json::mesh::Primitive>, name: &str) -> Result<Vec<u8>> {
        self.root.push(json::Buffer {
            byte_length: USize64::from(self.bytes.len()),
            name: None,
            uri: None,
            extensions: None,
            extras: Default::default(),
        });
        let mesh = self.root.push(json::Mesh {
            name: Some(name.into()),
            primitives,
            weights: None,
            extensions: None,
            extras: Default::default(),
        });
        let node = self.root.push(json::Node {
            name: Some(name.into()),
            mesh: Some(mesh),
            ..Default::default()
        });
        let scene = self.root.push(json::Scene {
            name: None,
            nodes: vec![node],
            extensions: None,
            extras: Default::default(),
        });
        self.root.scene = Some(scene);
        self.root.asset.generator = Some(concat!("tree-mesh ", env!("CARGO_PKG_VERSION")).into());
        let mut text = self.root.to_vec().map_err(|error| MeshError::Gltf(error.to_string()))?;
        text.resize(text.len().next_multiple_of(4), b' ');
        // 12 bytes of header and 8 before each of the two chunks.
        let length = text.len() + self.bytes.len() + 28;
        if length > BYTES_MAX {
            return Err(too_large());
        }
        let glb = Glb {
            header: Header { magic: *b"glTF", version: 2, length: length as u32 },
            json: Cow::Owned(text),
            bin: Some(Cow::Owned(self.bytes)),
        };
        let mut file = Vec::with_capacity(length);
        glb.to_writer(&mut file).map_err(|error| MeshError::Gltf(error.to_string()))?;
        Ok(file)
    }
}

/// What an accessor says of its column.
struct Column {
    n: usize,
    component: ComponentType,
    shape: Type,
    min: Option<Value>,
    max: Option<Value>,
}

fn push_all(bytes: &mut Vec<u8>, values: impl Iterator<Item = f32>) {
    for value in values {
        bytes.extend_from_slice(&value.to_le_bytes());
    }
}

fn too_large() -> MeshError {
    MeshError::Gltf(format!(
        "the file would be larger than {BYTES_MAX} bytes, which GLB cannot state"
    ))
}

#[cfg(test)]
#[path = "gltf_tests.rs"]
mod tests;
