//! The columns of one surface as a primitive.

use super::quantize::{Cube, UvRange, signed8, unsigned8};
use super::write::{
    BYTE, Column, FLOAT, INDICES, UNSIGNED_BYTE, UNSIGNED_INT, UNSIGNED_SHORT, VERTICES, Writer,
    push_floats,
};
use super::{Attribute, Level, OcclusionAs};
use crate::error::{MeshError, Result};
use crate::mesh::{Material, Surface};
use glam::Vec2;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use tree_core::Aabb;

/// Most vertices that 16-bit indices can name: 0xFFFF restarts primitives.
const SHORT_VERTICES_MAX: usize = 0xFFFF;
/// As much for 32-bit indices.
const MAX_VERTICES: usize = 0xFFFF_FFFF;
/// Longest name of an attribute.
const NAME_MAX: usize = 64;
/// Bytes of a row of three 16-bit or of up to four 8-bit numbers: multiples of four.
const STRIDE_SHORTS: usize = 8;
const STRIDE_BYTES: usize = 4;

/// Checks the caller's own columns.
pub(super) fn check_attributes(level: &Level<'_>) -> Result<()> {
    let mut names = BTreeSet::new();
    for attribute in level.attributes {
        let fail =
            |problem: String| Err(MeshError::Attribute { name: attribute.name.clone(), problem });
        let body = attribute.name.strip_prefix('_').unwrap_or("");
        let plain = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
        if body.is_empty() || body.len() >= NAME_MAX || !body.chars().all(plain) {
            return fail("a name is '_' and then capital letters, digits and '_'".into());
        }
        if attribute.name == "_OCCLUSION" || !names.insert((attribute.surface, body)) {
            return fail("the name is taken".into());
        }
        let Some(surface) = level.mesh.surfaces.get(attribute.surface) else {
            let n = level.mesh.surfaces.len();
            return fail(format!("surface {} does not exist, there are {n}", attribute.surface));
        };
        if !(1..=4).contains(&attribute.components) {
            return fail(format!("{} components, 1 to 4 can be written", attribute.components));
        }
        let (found, expected) =
            (attribute.values.len(), attribute.components * surface.positions.len());
        if found != expected {
            return fail(format!("{found} values, {expected} are needed"));
        }
        if let Some(row) = attribute.values.iter().position(|value| !value.is_finite()) {
            return fail(format!("value {row} is not finite"));
        }
    }
    Ok(())
}

impl<'a> Writer<'a> {
    /// A surface of mesh `source` as a primitive; quantised when there is a `cube`.
    pub(super) fn primitive<'b>(
        &mut self,
        source: usize,
        surface: &Surface,
        material: Option<&'a Material>,
        cube: Option<Cube>,
        attributes: impl Iterator<Item = &'b Attribute>,
    ) -> Result<Value> {
        let n = surface.positions.len();
        if n > MAX_VERTICES {
            return Err(MeshError::Gltf(format!(
                "{n} vertices in one primitive, 32-bit indices reach {MAX_VERTICES}"
            )));
        }
        let mut columns = Map::new();
        let range = match cube {
            Some(cube) => self.quantized(surface, material, cube, &mut columns)?,
            None => self.floats(surface, &mut columns)?,
        };
        self.occlusion(surface, &mut columns)?;
        for attribute in attributes {
            let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"][(attribute.components - 1).min(3)];
            let column = self.column(Column::plain(n, FLOAT, shape), Some(VERTICES), |bytes| {
                push_floats(bytes, attribute.values.iter().copied());
            })?;
            columns.insert(attribute.name.clone(), column.into());
        }
        let mut primitive = json!({ "attributes": columns, "indices": self.indices(surface)? });
        if let Some(material) = material {
            primitive["material"] = self.materials.place(source, material, range).into();
        }
        Ok(primitive)
    }

    fn indices(&mut self, surface: &Surface) -> Result<usize> {
        let short = surface.positions.len() <= SHORT_VERTICES_MAX;
        let (width, component) = if short { (2, UNSIGNED_SHORT) } else { (4, UNSIGNED_INT) };
        let column = Column::plain(surface.indices.len(), component, "SCALAR");
        self.column(column, Some(INDICES), |bytes| {
            bytes.reserve(width * surface.indices.len() + 4);
            for index in &surface.indices {
                // Short indices lie in the two low bytes.
                bytes.extend_from_slice(&index.to_le_bytes()[..width]);
            }
        })
    }

    fn floats(
        &mut self,
        surface: &Surface,
        columns: &mut Map<String, Value>,
    ) -> Result<Option<UvRange>> {
        let n = surface.positions.len();
        let bounds = Aabb::of_points(&surface.positions);
        let corner = |corner: glam::Vec3| json!(corner.to_array());
        let positions = Column {
            min_max: Some((corner(bounds.min), corner(bounds.max))),
            ..Column::plain(n, FLOAT, "VEC3")
        };
        let mut add = |name: &str, column, write: &dyn Fn(&mut Vec<u8>)| {
            let place = self.column(column, Some(VERTICES), write)?;
            columns.insert(name.into(), place.into());
            Ok::<_, MeshError>(())
        };
        add("POSITION", positions, &|bytes| {
            push_floats(bytes, surface.positions.iter().flat_map(|v| v.to_array()));
        })?;
        add("NORMAL", Column::plain(n, FLOAT, "VEC3"), &|bytes| {
            push_floats(bytes, surface.normals.iter().flat_map(|v| v.to_array()));
        })?;
        if !surface.tangents.is_empty() {
            add("TANGENT", Column::plain(n, FLOAT, "VEC4"), &|bytes| {
                push_floats(bytes, surface.tangents.iter().flat_map(|v| v.to_array()));
            })?;
        }
        for (name, uvs) in [("TEXCOORD_0", &surface.uvs), ("TEXCOORD_1", &surface.uvs2)] {
            if !uvs.is_empty() {
                add(name, Column::plain(n, FLOAT, "VEC2"), &|bytes| {
                    push_floats(bytes, uvs.iter().flat_map(|v| v.to_array()));
                })?;
            }
        }
        Ok(None)
    }

    fn quantized(
        &mut self,
        surface: &Surface,
        material: Option<&Material>,
        cube: Cube,
        columns: &mut Map<String, Value>,
    ) -> Result<Option<UvRange>> {
        self.extensions.insert("KHR_mesh_quantization");
        self.required.insert("KHR_mesh_quantization");
        let n = surface.positions.len();
        let fractions: Vec<[u16; 3]> =
            surface.positions.iter().map(|&position| cube.fraction(position)).collect();
        let extreme = |pick: fn(u16, u16) -> u16, start: u16| {
            let fold =
                |all: [u16; 3], &row: &[u16; 3]| std::array::from_fn(|i| pick(all[i], row[i]));
            json!(fractions.iter().fold([start; 3], fold))
        };
        let positions = Column {
            stride: Some(STRIDE_SHORTS),
            min_max: Some((extreme(u16::min, u16::MAX), extreme(u16::max, 0))),
            ..Column::normalized(n, UNSIGNED_SHORT, "VEC3")
        };
        let mut add = |name: &str, column, write: &dyn Fn(&mut Vec<u8>)| {
            let place = self.column(column, Some(VERTICES), write)?;
            columns.insert(name.into(), place.into());
            Ok::<_, MeshError>(())
        };
        add("POSITION", positions, &|bytes| {
            for &[x, y, z] in &fractions {
                [x, y, z, 0].iter().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
            }
        })?;
        let normals = Column { stride: Some(STRIDE_BYTES), ..Column::normalized(n, BYTE, "VEC3") };
        add("NORMAL", normals, &|bytes| {
            for v in &surface.normals {
                bytes.extend([v.x, v.y, v.z, 0.0].map(|value| signed8(value) as u8));
            }
        })?;
        if !surface.tangents.is_empty() {
            add("TANGENT", Column::normalized(n, BYTE, "VEC4"), &|bytes| {
                for v in &surface.tangents {
                    bytes.extend(v.to_array().map(|value| signed8(value) as u8));
                }
            })?;
        }
        let textured = material.is_some_and(|material| material.texture.is_some());
        let range = UvRange::around(&surface.uvs);
        for (name, uvs, range) in [
            ("TEXCOORD_0", &surface.uvs, range),
            ("TEXCOORD_1", &surface.uvs2, UvRange::around(&surface.uvs2)),
        ] {
            if uvs.is_empty() {
                continue;
            }
            // What stretches coordinates belongs to a texture: without one there is no place for it.
            if range.is_unit() || (name == "TEXCOORD_0" && textured) {
                let column = Column::normalized(n, UNSIGNED_SHORT, "VEC2");
                add(name, column, &|bytes| push_fractions(bytes, uvs, range))?;
            } else {
                add(name, Column::plain(n, FLOAT, "VEC2"), &|bytes| {
                    push_floats(bytes, uvs.iter().flat_map(|v| v.to_array()));
                })?;
            }
        }
        Ok(Some(range).filter(|range| textured && !range.is_unit()))
    }

    fn occlusion(&mut self, surface: &Surface, columns: &mut Map<String, Value>) -> Result<()> {
        let (n, shades) = (surface.positions.len(), &surface.occlusion);
        let (name, column) = match self.options.occlusion {
            _ if shades.is_empty() => return Ok(()),
            OcclusionAs::Omit => return Ok(()),
            OcclusionAs::Color => ("COLOR_0", Column::normalized(n, UNSIGNED_BYTE, "VEC4")),
            // Not in 8 bits, even quantised: padded to four bytes nothing is saved, and Blender 5.0
            // refuses files with bytes in attributes of the caller's own.
            OcclusionAs::Attribute => ("_OCCLUSION", Column::plain(n, FLOAT, "SCALAR")),
        };
        let place = self.column(column, Some(VERTICES), |bytes| match name {
            "COLOR_0" => bytes.extend(shades.iter().flat_map(|&shade| {
                let grey = unsigned8(shade.clamp(0.0, 1.0));
                [grey, grey, grey, 255]
            })),
            _ => push_floats(bytes, shades.iter().copied()),
        })?;
        columns.insert(name.into(), place.into());
        Ok(())
    }
}

fn push_fractions(bytes: &mut Vec<u8>, uvs: &[Vec2], range: UvRange) {
    for &uv in uvs {
        range.fraction(uv).iter().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
    }
}
