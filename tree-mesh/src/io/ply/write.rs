//! A mesh as PLY.

use super::srgb::{encoded, linear};
use crate::error::{MeshError, Result};
use crate::mesh::{Material, Mesh, Surface};

use std::io::{self, Write};
use std::path::Path;
use tree_core::{CoreError, file};

/// How a PLY file is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlyOptions {
    /// Numbers as text instead of little-endian binary: five times the size, for people and old
    /// programs. Default `false`.
    pub ascii: bool,
}

/// Writes a PLY file, whole or not at all.
///
/// # Errors
/// [`MeshError::NoTriangles`], what [`Mesh::check`] and [`Mesh::check_colors`] find,
/// [`MeshError::TooManyVertices`] beyond the 2³¹ that PLY's signed indices reach, or
/// [`MeshError::Core`] when the file cannot be written.
///
/// # Complexity
/// O(vertices + triangles + pixels), in a fixed buffer.
pub fn write_ply(mesh: &Mesh, path: impl AsRef<Path>, options: &PlyOptions) -> Result<()> {
    let path = path.as_ref();
    check(mesh)?;
    file::write_atomic(path, |out| {
        write(mesh, *options, out).map_err(|error| CoreError::io(path, error).into())
    })
}

/// The bytes that [`write_ply`] would write.
///
/// # Errors
/// As [`write_ply`], files apart.
pub fn to_bytes(mesh: &Mesh, options: &PlyOptions) -> Result<Vec<u8>> {
    check(mesh)?;
    let mut bytes = Vec::new();
    write(mesh, *options, &mut bytes).map_err(|error| CoreError::io("memory", error))?;
    Ok(bytes)
}

fn check(mesh: &Mesh) -> Result<()> {
    mesh.check()?;
    mesh.check_colors()?;
    if mesh.n_triangles() == 0 {
        return Err(MeshError::NoTriangles);
    }
    let (found, max) = (drawn(mesh).map(|s| s.positions.len() as u64).sum(), i32::MAX as u64);
    if found > max {
        return Err(MeshError::TooManyVertices { surface: None, found, max });
    }
    Ok(())
}

fn drawn(mesh: &Mesh) -> impl Iterator<Item = &Surface> {
    mesh.surfaces.iter().filter(|surface| surface.n_triangles() > 0)
}

fn write(mesh: &Mesh, options: PlyOptions, out: &mut dyn Write) -> io::Result<()> {
    let n_vertices: usize = drawn(mesh).map(|surface| surface.positions.len()).sum();
    let format = if options.ascii { "ascii" } else { "binary_little_endian" };
    writeln!(out, "ply\nformat {format} 1.0")?;
    writeln!(out, "comment tree-mesh {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(out, "element vertex {n_vertices}")?;
    for name in ["x", "y", "z", "nx", "ny", "nz", "s", "t"] {
        writeln!(out, "property float {name}")?;
    }
    for name in ["red", "green", "blue"] {
        writeln!(out, "property uchar {name}")?;
    }
    writeln!(out, "element face {}", mesh.n_triangles())?;
    writeln!(out, "property list uchar int vertex_indices\nend_header")?;
    for surface in drawn(mesh) {
        let color = mesh.materials.get(surface.material as usize).map_or([255; 3], color);
        vertices(surface, color, options, out)?;
    }
    let mut first = 0_u32;
    for surface in drawn(mesh) {
        for corners in surface.indices.chunks_exact(3) {
            let [a, b, c] = [corners[0] + first, corners[1] + first, corners[2] + first];
            if options.ascii {
                writeln!(out, "3 {a} {b} {c}")?;
            } else {
                let mut row = [3; 13];
                for (to, corner) in row[1..].chunks_exact_mut(4).zip([a, b, c]) {
                    to.copy_from_slice(&corner.to_le_bytes());
                }
                out.write_all(&row)?;
            }
        }
        first += surface.positions.len() as u32;
    }
    Ok(())
}

fn vertices(
    surface: &Surface,
    [r, g, b]: [u8; 3],
    options: PlyOptions,
    out: &mut dyn Write,
) -> io::Result<()> {
    let columns = surface.positions.iter().zip(&surface.normals).zip(&surface.uvs);
    for ((p, n), uv) in columns {
        let numbers = [p.x, p.y, p.z, n.x, n.y, n.z, uv.x, 1.0 - uv.y];
        if options.ascii {
            for number in numbers {
                write!(out, "{number} ")?;
            }
            writeln!(out, "{r} {g} {b}")?;
        } else {
            let mut row = [0; 35];
            for (to, number) in row.chunks_exact_mut(4).zip(numbers) {
                to.copy_from_slice(&number.to_le_bytes());
            }
            row[32..].copy_from_slice(&[r, g, b]);
            out.write_all(&row)?;
        }
    }
    Ok(())
}

/// The material's colour times the mean of its texture, pixels weighted by their alpha; sRGB.
fn color(material: &Material) -> [u8; 3] {
    let curve: [f32; 256] = std::array::from_fn(|i| linear(i as f32 / 255.0));
    let mean = material.texture.as_ref().map_or([1.0; 3], |texture| {
        let (mut sum, mut weight) = ([0.0_f64; 3], 0.0_f64);
        for pixel in texture.pixels.chunks_exact(4) {
            let alpha = f64::from(pixel[3]);
            weight += alpha;
            for (sum, &value) in sum.iter_mut().zip(pixel) {
                *sum += alpha * f64::from(curve[usize::from(value)]);
            }
        }
        if weight > 0.0 { sum.map(|sum| (sum / weight) as f32) } else { [1.0; 3] }
    });
    std::array::from_fn(|i| {
        let value = encoded(material.base_color[i] * mean[i]);
        (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
    })
}
