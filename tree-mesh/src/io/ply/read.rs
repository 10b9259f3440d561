//! PLY to a mesh.

use super::body::{Body, at};
use super::header::{Element, Kind, parse};
use super::malformed;
use super::srgb::linear;
use crate::error::{MeshError, Result};
use crate::io::import::{Budget, ImportReport, Imported, Note, read_bytes};
use crate::io::{normals, polygon};
use crate::mesh::{Material, Mesh, Surface};
use glam::{Vec2, Vec3};
use std::path::Path;
use tree_core::{Control, Resource};

/// Rows between two looks at whether the caller has cancelled.
const ROWS_PER_CHECK: u64 = 1 << 14;

/// What the properties of a vertex are called, in the order of the columns below.
const NAMES: [&[&str]; 11] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx", "normal_x"],
    &["ny", "normal_y"],
    &["nz", "normal_z"],
    &["s", "u", "texture_u", "texture_s"],
    &["t", "v", "texture_v", "texture_t"],
    &["red", "r", "diffuse_red"],
    &["green", "g", "diffuse_green"],
    &["blue", "b", "diffuse_blue"],
];

/// Reads a PLY file: text, or binary of either order of bytes. One surface, one material.
///
/// Positions, normals (computed where there are none), texture coordinates (`s t`, `u v` or
/// `texture_u texture_v`, v upwards), triangles and polygons, which are cut into triangles. The mean
/// of the vertex colours becomes the colour of the material. Other properties and elements are passed
/// over.
///
/// # Errors
/// [`MeshError::Malformed`] with the line of the header or the row, [`MeshError::Limit`] (before the
/// memory is taken; a third of the vertices counts as triangles do), [`MeshError::Core`] when the
/// file cannot be read, [`MeshError::Cancelled`].
///
/// # Complexity
/// O(bytes).
pub fn read(path: impl AsRef<Path>, control: &Control) -> Result<Imported> {
    from_slice(&read_bytes(path.as_ref(), control)?, control)
}

/// Reads a PLY file in memory.
///
/// # Errors
/// As [`read`].
pub fn from_slice(bytes: &[u8], control: &Control) -> Result<Imported> {
    control.limits.check(Resource::InputBytes, bytes.len() as u64)?;
    let (header, rest) = parse(bytes)?;
    let mut body = Body::new(rest, header.format);
    let mut reader = Reader {
        control,
        budget: Budget::default(),
        surface: Surface::default(),
        color: None,
        report: ImportReport { n_nodes: 1, ..Default::default() },
    };
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => reader.vertices(element, &mut body)?,
            "face" => reader.faces(element, &mut body)?,
            other => {
                body.skip(element)?;
                let lines = other == "edge";
                reader.report.note(if lines { Note::PointsOrLines } else { Note::Unknown });
            }
        }
    }
    reader.finish()
}

struct Reader<'a> {
    control: &'a Control,
    budget: Budget,
    surface: Surface,
    color: Option<[f32; 3]>,
    report: ImportReport,
}

impl Reader<'_> {
    fn vertices(&mut self, element: &Element, body: &mut Body<'_>) -> Result<()> {
        body.check(element)?;
        self.budget.take(0, element.n_rows, &self.control.limits)?;
        if element.n_rows >= u64::from(u32::MAX) {
            return Err(MeshError::TooManyVertices {
                surface: None,
                found: element.n_rows,
                max: u64::from(u32::MAX) - 1,
            });
        }
        if !self.surface.positions.is_empty() {
            return Err(malformed("header", "two elements of vertices"));
        }
        let role = |name: &str| NAMES.iter().position(|names| names.contains(&name));
        let roles: Vec<Option<usize>> = element
            .properties
            .iter()
            .map(|property| role(&property.name).filter(|_| property.count.is_none()))
            .collect();
        let has = |column: usize| roles.contains(&Some(column));
        if !(0..3).all(has) {
            return Err(malformed("element vertex", "x, y and z are needed"));
        }
        let (has_normals, has_uvs, has_colors) =
            ((3..6).all(has), (6..8).all(has), (8..11).all(has));
        let full = |column: usize| {
            let place = roles.iter().position(|&role| role == Some(column));
            match place.and_then(|place| element.properties.get(place)).map(|p| p.kind) {
                Some(Kind::F32 | Kind::F64) => 1.0,
                Some(Kind::U16) => 65_535.0,
                _ => 255.0,
            }
        };
        let scales = [full(8), full(9), full(10)];
        let n = element.n_rows as usize;
        self.surface.positions.reserve_exact(n);
        self.surface.normals.reserve_exact(if has_normals { n } else { 0 });
        self.surface.uvs.reserve_exact(n);
        let mut sum = [0.0_f64; 3];
        let mut first = None;
        let mut varied = false;
        for row in 0..element.n_rows {
            if row % ROWS_PER_CHECK == 0 {
                self.control.check()?;
            }
            let mut values = [0.0_f64; NAMES.len()];
            for (property, role) in element.properties.iter().zip(&roles) {
                let value = match role {
                    Some(role) => body.number(property.kind).map(|value| values[*role] = value),
                    None => body.skip_property(property),
                };
                value.ok_or_else(|| at(element, row))?;
            }
            let [x, y, z, nx, ny, nz, s, t, r, g, b] = values;
            let position = Vec3::new(x as f32, y as f32, z as f32);
            let uv = Vec2::new(s as f32, 1.0 - t as f32);
            if !position.is_finite() || !uv.is_finite() {
                return Err(malformed(format!("element vertex, row {row}"), "is not finite"));
            }
            self.surface.positions.push(position);
            self.surface.uvs.push(if has_uvs { uv } else { Vec2::ZERO });
            if has_normals {
                self.surface.normals.push(Vec3::new(nx as f32, ny as f32, nz as f32));
            }
            if has_colors {
                varied |= *first.get_or_insert([r, g, b]) != [r, g, b];
                for ((sum, value), full) in sum.iter_mut().zip([r, g, b]).zip(scales) {
                    let value = (value / full).clamp(0.0, 1.0);
                    *sum += if value.is_nan() { 0.0 } else { value };
                }
            }
        }
        self.report.note_times(Note::UvsMissing, u64::from(!has_uvs));
        if has_colors && n > 0 {
            self.color = Some(sum.map(|sum| linear((sum / n as f64) as f32).clamp(0.0, 1.0)));
            self.report.note_times(Note::VertexColors, u64::from(varied));
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, body: &mut Body<'_>) -> Result<()> {
        body.check(element)?;
        let list = |name: &str| name == "vertex_indices" || name == "vertex_index";
        let place = element.properties.iter().position(|property| list(&property.name));
        let place = place.and_then(|place| Some((place, element.properties[place].count?)));
        let Some((place, count)) = place else {
            return Err(malformed("element face", "a list vertex_indices is needed"));
        };
        let mut corners: Vec<u32> = Vec::new();
        let mut points: Vec<Vec3> = Vec::new();
        for row in 0..element.n_rows {
            if row % ROWS_PER_CHECK == 0 {
                self.control.check()?;
            }
            corners.clear();
            points.clear();
            for (number, property) in element.properties.iter().enumerate() {
                if number != place {
                    body.skip_property(property).ok_or_else(|| at(element, row))?;
                    continue;
                }
                let n = body.count(count, property.kind).ok_or_else(|| at(element, row))?;
                for _ in 0..n {
                    let index = body.number(property.kind).ok_or_else(|| at(element, row))?;
                    let point = self.surface.positions.get(index as usize);
                    let Some(&point) = point.filter(|_| index >= 0.0 && index.fract() == 0.0)
                    else {
                        let n = self.surface.positions.len();
                        return Err(malformed(
                            format!("element face, row {row}"),
                            format!("corner {index}, there are {n} vertices before"),
                        ));
                    };
                    corners.push(index as u32);
                    points.push(point);
                }
            }
            if corners.len() < 3 {
                self.report.note(Note::PartialFaces);
                continue;
            }
            self.budget.take(corners.len() as u64 - 2, 0, &self.control.limits)?;
            let indices = &mut self.surface.indices;
            polygon::triangulate(&points, |triangle| indices.extend(triangle.map(|i| corners[i])));
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Imported> {
        if self.surface.indices.is_empty() {
            return Err(malformed("file", "no face with three corners"));
        }
        if self.surface.normals.is_empty() {
            self.report.note(Note::NormalsComputed);
            normals::compute(&mut self.surface);
        } else {
            self.report.note_times(Note::NormalsRepaired, normals::repair(&mut self.surface));
        }
        let mut material = Material::default();
        if let Some([r, g, b]) = self.color {
            material.base_color = [r, g, b, 1.0];
        }
        let mesh =
            Mesh { surfaces: vec![self.surface], materials: vec![material], branches: Vec::new() };
        mesh.check()?;
        self.report.finish(&mesh);
        Ok(Imported { mesh, report: self.report })
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
