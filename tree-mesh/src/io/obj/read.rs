//! OBJ to a mesh.

use super::face::{Corner, Lists, NONE, corner, weld};
use super::mtl::{self, Textures};
use crate::error::{MeshError, Result};
use crate::io::import::{
    Beside, ImportOptions, ImportReport, Imported, Note, is_missing, read_bytes,
};
use crate::io::{normals, polygon};
use crate::mesh::{Material, Mesh, Surface};
use glam::{Vec2, Vec3};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;
use tree_core::{Control, Resource};

/// Lines between two looks at whether the caller has cancelled.
const LINES_PER_CHECK: usize = 1 << 14;

/// Reads an OBJ file, and with [`ImportOptions::external`] the MTL and textures it names.
///
/// One surface per material, in the order of first use. Polygons are cut into triangles, concave ones
/// too; corners that agree in position, texture coordinate and normal become one vertex; corners
/// without normal get the mean of the faces around their position. Points, lines, free-form surfaces,
/// smoothing groups and vertex colours are left out.
///
/// # Errors
/// [`MeshError::Malformed`] with the line, [`MeshError::External`], [`MeshError::Limit`] (before the
/// memory is taken; [`Limits::input_bytes`] and [`Limits::pixels`] hold for all files together),
/// [`MeshError::Core`] when a file cannot be read, [`MeshError::Cancelled`].
///
/// [`Limits::input_bytes`]: tree_core::Limits::input_bytes
/// [`Limits::pixels`]: tree_core::Limits::pixels
///
/// # Complexity
/// O(bytes + corners · log corners + pixels).
pub fn read(
    path: impl AsRef<Path>,
    options: &ImportOptions,
    control: &Control,
) -> Result<Imported> {
    let path = path.as_ref();
    let bytes = read_bytes(path, control)?;
    from_parts(&bytes, None, Beside::new("OBJ", Some(path), options, control), control)
}

/// Reads an OBJ file in memory. Other files are never read: materials have names only.
///
/// # Errors
/// As [`read`].
pub fn from_slice(obj: &[u8], control: &Control) -> Result<Imported> {
    from_memory(obj, None, control)
}

/// Reads an OBJ file and its MTL in memory; `mtllib` statements are passed over. Textures, which lie
/// in files, are never read.
///
/// # Errors
/// As [`read`].
pub fn from_slices(obj: &[u8], mtl: &[u8], control: &Control) -> Result<Imported> {
    from_memory(obj, Some(mtl), control)
}

fn from_memory(obj: &[u8], mtl: Option<&[u8]>, control: &Control) -> Result<Imported> {
    let n_bytes = obj.len() as u64 + mtl.map_or(0, |mtl| mtl.len() as u64);
    control.limits.check(Resource::InputBytes, n_bytes)?;
    from_parts(obj, mtl, Beside::new("OBJ", None, &ImportOptions::default(), control), control)
}

fn from_parts(
    obj: &[u8],
    mtl: Option<&[u8]>,
    beside: Beside<'_>,
    control: &Control,
) -> Result<Imported> {
    let mut reader = Reader {
        lists: Lists::default(),
        groups: Vec::new(),
        names: BTreeMap::new(),
        current: None,
        n_triangles: 0,
        materials: BTreeMap::new(),
        textures: Textures::default(),
        mtl_given: mtl.is_some(),
        beside,
        report: ImportReport::default(),
        control,
        corners: Vec::new(),
        points: Vec::new(),
    };
    if let Some(mtl) = mtl {
        reader.mtl(mtl)?;
    }
    let mut lines = Lines { rest: obj, number: 0 };
    while let Some((number, line)) = lines.next() {
        if number % LINES_PER_CHECK == 0 {
            control.check()?;
        }
        reader.line(&line).map_err(|problem| match problem {
            Problem::Line(problem) => {
                MeshError::Malformed { format: "OBJ", place: format!("line {number}"), problem }
            }
            Problem::Other(error) => error,
        })?;
    }
    reader.finish()
}

/// What is wrong with a line, or elsewhere.
enum Problem {
    Line(String),
    Other(MeshError),
}

impl From<String> for Problem {
    fn from(problem: String) -> Self {
        Self::Line(problem)
    }
}

impl From<MeshError> for Problem {
    fn from(error: MeshError) -> Self {
        Self::Other(error)
    }
}

/// Lines and their numbers from 1, those joined that end in a backslash.
struct Lines<'a> {
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<(usize, Cow<'a, str>)> {
        let mut line = String::from_utf8_lossy(self.one()?);
        let number = self.number;
        while line.ends_with('\\') {
            let mut joined = line.into_owned();
            joined.pop();
            joined.push(' ');
            let Some(more) = self.one() else { return Some((number, joined.into())) };
            joined.push_str(&String::from_utf8_lossy(more));
            line = joined.into();
        }
        Some((number, line))
    }

    fn one(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|&byte| byte == b'\n');
        let (line, rest) = match end {
            Some(end) => (self.rest.get(..end)?, self.rest.get(end + 1..)?),
            None => (self.rest, &[][..]),
        };
        self.rest = rest;
        self.number += 1;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }
}

/// Corners of all triangles of one material.
struct Group {
    material: String,
    corners: Vec<Corner>,
}

struct Reader<'a> {
    lists: Lists,
    groups: Vec<Group>,
    /// Place in `groups` of each material.
    names: BTreeMap<String, usize>,
    current: Option<usize>,
    n_triangles: u64,
    materials: BTreeMap<String, Material>,
    textures: Textures,
    mtl_given: bool,
    beside: Beside<'a>,
    report: ImportReport,
    control: &'a Control,
    /// Corners of the face at hand, and where they are.
    corners: Vec<Corner>,
    points: Vec<Vec3>,
}

impl Reader<'_> {
    fn line(&mut self, line: &str) -> std::result::Result<(), Problem> {
        // Names may hold the sign, comments begin with it.
        let line = if line.starts_with('#') { "" } else { line.split(" #").next().unwrap_or("") };
        let line = line.trim();
        let (keyword, rest) =
            line.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((line, ""));
        match keyword {
            "v" => self.lists.positions.push(Vec3::from(numbers(keyword, rest)?)),
            "vn" => self.lists.normals.push(Vec3::from(numbers(keyword, rest)?)),
            "vt" => {
                let [u, v] = numbers::<2>(keyword, rest)?;
                self.lists.uvs.push(Vec2::new(u, 1.0 - v));
            }
            "f" => self.face(rest)?,
            "usemtl" => self.use_material(rest.trim()),
            "mtllib" => self.library(rest.trim())?,
            "o" | "g" => self.report.n_nodes += 1,
            "p" | "l" => self.report.note(Note::PointsOrLines),
            "" | "s" | "vp" => {}
            _ => self.report.note(Note::Unknown),
        }
        Ok(())
    }

    fn use_material(&mut self, name: &str) {
        let next = self.groups.len();
        let place = *self.names.entry(name.to_owned()).or_insert(next);
        if place == next {
            self.groups.push(Group { material: name.to_owned(), corners: Vec::new() });
        }
        self.current = Some(place);
    }

    fn face(&mut self, rest: &str) -> std::result::Result<(), Problem> {
        self.corners.clear();
        self.points.clear();
        let counts = self.lists.counts();
        for word in rest.split_ascii_whitespace() {
            let corner = corner(word, counts)?;
            self.points.push(self.lists.positions[corner.position as usize]);
            self.corners.push(corner);
        }
        if self.corners.len() < 3 {
            self.report.note(Note::PartialFaces);
            return Ok(());
        }
        self.n_triangles += self.corners.len() as u64 - 2;
        self.control
            .limits
            .check(Resource::Triangles, self.n_triangles)
            .map_err(MeshError::from)?;
        if self.current.is_none() {
            self.use_material("");
        }
        if let Some(group) = self.current.and_then(|current| self.groups.get_mut(current)) {
            let corners = &self.corners;
            polygon::triangulate(&self.points, |triangle| {
                group.corners.extend(triangle.map(|i| corners[i]));
            });
        }
        Ok(())
    }

    fn library(&mut self, names: &str) -> Result<()> {
        if self.mtl_given {
            return Ok(());
        }
        if !self.beside.allowed() {
            self.report.note(Note::ExternalRefused);
            return Ok(());
        }
        // One name that may hold blanks, as nearly all programs write it; several, as the format has it.
        match self.beside.read(names) {
            Ok(bytes) => return self.mtl(&bytes),
            Err(error) if !is_missing(&error) => return Err(error),
            Err(_) => {}
        }
        for name in names.split_ascii_whitespace() {
            match self.beside.read(name) {
                Ok(bytes) => self.mtl(&bytes)?,
                Err(error) if is_missing(&error) => self.report.note(Note::ExternalMissing),
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    fn mtl(&mut self, bytes: &[u8]) -> Result<()> {
        mtl::read(
            bytes,
            &mut self.materials,
            &mut self.textures,
            &mut self.beside,
            &mut self.report,
            self.control,
        )
    }

    fn finish(mut self) -> Result<Imported> {
        let smooth = self.smooth_normals();
        let mut mesh = Mesh::default();
        for group in std::mem::take(&mut self.groups) {
            if group.corners.is_empty() {
                continue;
            }
            self.control.check()?;
            let material = self.material(&group.material);
            let mut surface = self.surface(&group.corners, &smooth, mesh.surfaces.len())?;
            surface.material = mesh.materials.len() as u32;
            self.report.note_times(Note::NormalsRepaired, normals::repair(&mut surface));
            mesh.surfaces.push(surface);
            mesh.materials.push(material);
        }
        if mesh.surfaces.is_empty() {
            return Err(MeshError::Malformed {
                format: "OBJ",
                place: "file".into(),
                problem: "no face with three corners".into(),
            });
        }
        mesh.check()?;
        self.report.finish(&mesh);
        Ok(Imported { mesh, report: self.report })
    }

    fn material(&mut self, name: &str) -> Material {
        if let Some(material) = self.materials.get(name) {
            return material.clone();
        }
        if name.is_empty() {
            return Material::default();
        }
        self.report.note(Note::MaterialUnknown);
        Material { name: name.to_owned(), ..Default::default() }
    }

    /// For each position the mean normal of its faces without normals; empty when all have some.
    fn smooth_normals(&self) -> Vec<Vec3> {
        let mut sums = Vec::new();
        for group in &self.groups {
            for triangle in group.corners.chunks_exact(3) {
                if triangle.iter().any(|corner| corner.normal == NONE) {
                    sums.resize(self.lists.positions.len(), Vec3::ZERO);
                    let rows: [u32; 3] = std::array::from_fn(|i| triangle[i].position);
                    normals::add_faces(&self.lists.positions, &rows, &mut sums);
                }
            }
        }
        sums
    }

    fn surface(&mut self, corners: &[Corner], smooth: &[Vec3], number: usize) -> Result<Surface> {
        if corners.len() as u64 >= u64::from(u32::MAX) {
            return Err(MeshError::TooManyVertices {
                surface: Some(number),
                found: corners.len() as u64,
                max: u64::from(u32::MAX) - 1,
            });
        }
        let (vertices, indices) = weld(corners);
        let lists = &self.lists;
        let mut missing = (0, 0);
        let mut surface = Surface { indices, ..Default::default() };
        surface.positions.reserve_exact(vertices.len());
        surface.normals.reserve_exact(vertices.len());
        surface.uvs.reserve_exact(vertices.len());
        for vertex in &vertices {
            let row = vertex.position as usize;
            surface.positions.push(lists.positions.get(row).copied().unwrap_or_default());
            surface.uvs.push(lists.uvs.get(vertex.uv as usize).copied().unwrap_or_else(|| {
                missing.0 += 1;
                Vec2::ZERO
            }));
            surface.normals.push(
                lists.normals.get(vertex.normal as usize).copied().unwrap_or_else(|| {
                    missing.1 += 1;
                    normals::direction(smooth.get(row).copied().unwrap_or_default())
                }),
            );
        }
        self.report.note_times(Note::UvsMissing, missing.0);
        self.report.note_times(Note::NormalsComputed, missing.1);
        Ok(surface)
    }
}

/// `N` finite numbers; more may follow.
fn numbers<const N: usize>(keyword: &str, rest: &str) -> std::result::Result<[f32; N], String> {
    let mut numbers = [0.0; N];
    let mut words = rest.split_ascii_whitespace();
    for (i, number) in numbers.iter_mut().enumerate() {
        let word = match words.next() {
            Some(word) => word,
            // A texture coordinate may have u alone.
            None if keyword == "vt" && i == 1 => "0",
            None => return Err(format!("{keyword} with {i} numbers, {N} are needed")),
        };
        *number = word.parse().ok().filter(|value: &f32| value.is_finite()).ok_or_else(|| {
            let word: String = word.chars().take(20).collect();
            format!("'{word}' is no finite number")
        })?;
    }
    Ok(numbers)
}

#[cfg(test)]
#[path = "read_tests.rs"]
mod tests;
