//! OBJ and MTL as text.

use crate::error::{MeshError, Result};
use crate::io::names::{Unique, safe};
use crate::mesh::{Alpha, Material, Mesh, Surface, Texture};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tree_core::{CoreError, file};

/// Lines are handed on when the buffer holds this many bytes.
const BUFFER: usize = 1 << 16;
/// Magnitude from which numbers are written by the standard library: no 64-bit integer is left for
/// their decimals, nor does f32 have any.
const WHOLE_FROM: f32 = 1e9;

/// Writes `path` and beside it the MTL file and the textures, all or none.
///
/// The MTL file is called as `path` with the extension `mtl`, blanks and other trouble replaced by
/// `_`; textures are called `STEM_NAME.png`. Without the feature `image` no textures are written and
/// none are named.
///
/// # Errors
/// [`MeshError::NoTriangles`], what [`Mesh::check`] and [`Mesh::check_colors`] find,
/// `MeshError::Image` (feature `image`), or [`MeshError::Core`] with the path that could not be
/// written; no file is left behind or changed then.
///
/// # Complexity
/// O(vertices + triangles + pixels).
pub fn write_obj(mesh: &Mesh, path: impl AsRef<Path>) -> Result<()> {
    let path = path.as_ref();
    let plan = Plan::new(mesh, path)?;
    let io_at = |path: &Path, error| MeshError::from(CoreError::io(path, error));
    let mtl_path = path.with_file_name(&plan.mtl_name);
    let pictures: Vec<(PathBuf, Vec<u8>)> = plan
        .textures
        .iter()
        .map(|(texture, name)| Ok((path.with_file_name(name), png(texture)?)))
        .collect::<Result<_>>()?;
    let mut parts: Vec<file::Part<'_, MeshError>> = Vec::new();
    for (path, bytes) in &pictures {
        parts.push((
            path,
            Some(Box::new(move |out| out.write_all(bytes).map_err(|error| io_at(path, error)))),
        ));
    }
    parts.push((
        &mtl_path,
        Some(Box::new(|out| plan.mtl(out).map_err(|error| io_at(&mtl_path, error)))),
    ));
    parts.push((path, Some(Box::new(|out| plan.obj(out).map_err(|error| io_at(path, error))))));
    file::write_all_atomic(&mut parts)
}

/// The OBJ and MTL texts that [`write_obj`] would write to `stem.obj` and `stem.mtl`.
///
/// # Errors
/// As [`write_obj`], files apart.
pub fn to_strings(mesh: &Mesh, stem: &str) -> Result<(String, String)> {
    let plan = Plan::new(mesh, Path::new(&format!("{}.obj", safe(stem, "tree"))))?;
    let text = |fill: &dyn Fn(&mut dyn Write) -> io::Result<()>| {
        let mut bytes = Vec::new();
        fill(&mut bytes).map_err(|error| CoreError::io(stem, error))?;
        Ok::<_, MeshError>(String::from_utf8_lossy(&bytes).into_owned())
    };
    Ok((text(&|out| plan.obj(out))?, text(&|out| plan.mtl(out))?))
}

#[cfg(feature = "image")]
fn png(texture: &Texture) -> Result<Vec<u8>> {
    texture.to_png()
}

#[cfg(not(feature = "image"))]
fn png(_: &Texture) -> Result<Vec<u8>> {
    Ok(Vec::new())
}

/// Names of everything, decided before the first byte is written.
struct Plan<'a> {
    mesh: &'a Mesh,
    mtl_name: String,
    materials: Vec<String>,
    /// Each texture once, with its file name.
    textures: Vec<(Arc<Texture>, String)>,
}

impl<'a> Plan<'a> {
    fn new(mesh: &'a Mesh, path: &Path) -> Result<Self> {
        mesh.check()?;
        mesh.check_colors()?;
        if mesh.n_triangles() == 0 {
            return Err(MeshError::NoTriangles);
        }
        let unusable = |problem: &'static str| {
            CoreError::io(path, io::Error::new(io::ErrorKind::InvalidInput, problem))
        };
        let stem = match (path.file_name(), path.file_stem()) {
            (Some(_), Some(stem)) => safe(&stem.to_string_lossy(), "tree"),
            _ => return Err(unusable("the path does not end in a file name").into()),
        };
        let mtl_name = format!("{stem}.mtl");
        if path.file_name().is_some_and(|name| name.eq_ignore_ascii_case(&mtl_name)) {
            return Err(unusable("an OBJ file must not be called .mtl").into());
        }
        let mut names = Unique::default();
        let materials =
            mesh.materials.iter().map(|material| names.name(&material.name, "material")).collect();
        let mut textures: Vec<(Arc<Texture>, String)> = Vec::new();
        if cfg!(feature = "image") {
            let mut names = Unique::default();
            for texture in mesh.materials.iter().filter_map(|m| m.texture.as_ref()) {
                if !textures.iter().any(|(known, _)| Arc::ptr_eq(known, texture)) {
                    let name = names.name(&texture.name, "texture");
                    textures.push((Arc::clone(texture), format!("{stem}_{name}.png")));
                }
            }
        }
        Ok(Self { mesh, mtl_name, materials, textures })
    }

    fn texture_of(&self, material: &Material) -> Option<&str> {
        let wanted = material.texture.as_ref()?;
        let found = self.textures.iter().find(|(texture, _)| Arc::ptr_eq(texture, wanted))?;
        Some(&found.1)
    }

    fn mtl(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "# tree-mesh {}", env!("CARGO_PKG_VERSION"))?;
        for (material, name) in self.mesh.materials.iter().zip(&self.materials) {
            let [r, g, b, a] = material.base_color;
            writeln!(
                out,
                "\nnewmtl {name}\nKd {r} {g} {b}\nKs 0 0 0\nillum 1\nd {a}\nPr {}",
                material.roughness
            )?;
            if let Some(texture) = self.texture_of(material) {
                writeln!(out, "map_Kd {texture}")?;
                if matches!(material.alpha, Alpha::Mask(_)) {
                    writeln!(out, "map_d {texture}")?;
                }
            }
        }
        Ok(())
    }

    fn obj(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "# tree-mesh {}", env!("CARGO_PKG_VERSION"))?;
        writeln!(out, "mtllib {}", self.mtl_name)?;
        let mut objects = Unique::default();
        // Indices count from 1 over the whole file.
        let mut first = 1_u64;
        for surface in self.mesh.surfaces.iter().filter(|s| s.n_triangles() > 0) {
            let material =
                self.materials.get(surface.material as usize).map_or("material", String::as_str);
            writeln!(out, "o {}", objects.name(material, "surface"))?;
            write_surface(surface, material, first, out)?;
            first += surface.positions.len() as u64;
        }
        Ok(())
    }
}

fn write_surface(
    surface: &Surface,
    material: &str,
    first: u64,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut lines = Lines { out, bytes: Vec::with_capacity(BUFFER + 256) };
    for p in &surface.positions {
        lines.numbers(b"v", &p.to_array(), 6)?;
    }
    for uv in &surface.uvs {
        lines.numbers(b"vt", &[uv.x, 1.0 - uv.y], 6)?;
    }
    for n in &surface.normals {
        lines.numbers(b"vn", &n.to_array(), 4)?;
    }
    lines.bytes.extend_from_slice(b"usemtl ");
    lines.bytes.extend_from_slice(material.as_bytes());
    lines.bytes.push(b'\n');
    for triangle in surface.indices.chunks_exact(3) {
        lines.bytes.push(b'f');
        for &corner in triangle {
            let index = first + u64::from(corner);
            for before in *b" //" {
                lines.bytes.push(before);
                push_integer(&mut lines.bytes, index, 1);
            }
        }
        lines.end()?;
    }
    lines.flush()
}

/// A buffer of lines.
struct Lines<'a> {
    out: &'a mut dyn Write,
    bytes: Vec<u8>,
}

impl Lines<'_> {
    fn numbers(&mut self, keyword: &[u8], values: &[f32], decimals: usize) -> io::Result<()> {
        self.bytes.extend_from_slice(keyword);
        for &value in values {
            self.bytes.push(b' ');
            push_number(&mut self.bytes, value, decimals);
        }
        self.end()
    }

    fn end(&mut self) -> io::Result<()> {
        self.bytes.push(b'\n');
        if self.bytes.len() >= BUFFER {
            self.flush()?;
        }
        Ok(())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(())
    }
}

/// `value` rounded to so many decimals (at most 6), without trailing zeros.
fn push_number(bytes: &mut Vec<u8>, value: f32, decimals: usize) {
    if value.abs() >= WHOLE_FROM {
        bytes.extend_from_slice(format!("{value}").as_bytes());
        return;
    }
    let scale = [1_u64, 10, 100, 1000, 10_000, 100_000, 1_000_000][decimals.min(6)];
    let scaled = (f64::from(value.abs()) * scale as f64 + 0.5) as u64;
    if value < 0.0 && scaled > 0 {
        bytes.push(b'-');
    }
    push_integer(bytes, scaled / scale, 1);
    let fraction = scaled % scale;
    if fraction > 0 {
        bytes.push(b'.');
        push_integer(bytes, fraction, decimals.min(6));
        while bytes.last() == Some(&b'0') {
            bytes.pop();
        }
    }
}

/// An integer with at least `width` digits.
fn push_integer(bytes: &mut Vec<u8>, mut value: u64, width: usize) {
    let mut digits = [b'0'; 20];
    let mut start = digits.len();
    while value > 0 {
        start -= 1;
        digits[start] = b'0' + (value % 10) as u8;
        value /= 10;
    }
    start = start.min(digits.len() - width);
    bytes.extend_from_slice(&digits[start..]);
}

#[cfg(test)]
#[path = "write_tests.rs"]
mod tests;
