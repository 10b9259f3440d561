//! Draws elements onto their billboards.

use super::super::Outcome;
use super::{Billboard, corners};
use std::sync::Arc;
use tree_core::Control;
use tree_core::glam::Vec2;
use tree_lod::Elements;
use tree_lod::preview::{Camera, Lens, Pose, View, mask};
use tree_mesh::{Alpha, Material, Mesh, Surface, Texture};

/// Colour of what is covered: the mask is what counts here.
const LEAF: [u8; 3] = [86, 124, 56];

/// The mesh with billboards instead of its foliage: a surface and a masked texture each, at most `texels`
/// along its longer side. The elements are drawn orthographically, with their own masks.
pub(in super::super) fn bake(
    mesh: &Mesh,
    elements: &Elements,
    billboards: &[Billboard],
    texels: u32,
) -> Outcome<Mesh> {
    let mut out = mesh.clone();
    for &number in &elements.surfaces {
        let material = out.surfaces[number as usize].material;
        out.surfaces[number as usize] = Surface { material, ..Surface::default() };
    }
    for (i, billboard) in billboards.iter().enumerate() {
        let (half, [width, height]) = raster(billboard.half, texels);
        let part = part(mesh, elements, &billboard.elements);
        let normal = billboard.normal();
        let behind = |&e: &u32| {
            let of = |p: tree_core::glam::Vec3| (p - billboard.center).dot(normal).abs();
            corners(mesh, elements, e as usize).map(of).fold(0.0, f32::max)
        };
        let away = 1.0 + billboard.elements.iter().map(behind).fold(0.0, f32::max);
        let camera = Camera::Placed(Pose {
            eye: billboard.center + away * normal,
            target: billboard.center,
            up: billboard.up,
            lens: Lens::Orthographic { height: 2.0 * half.y },
        });
        let view = View { width, height, samples: 1, camera };
        let covered = mask(&part, &view, &Control::default())?;
        let texture = texture(i, width, height, covered.bits());
        out.surfaces.push(quad(billboard, half, out.materials.len() as u32));
        out.materials.push(Material {
            name: format!("billboard {i}"),
            texture: Some(Arc::new(texture)),
            alpha: Alpha::Mask(0.5),
            double_sided: true,
            ..Material::default()
        });
    }
    Ok(out)
}

/// Half the size with a texel of margin all around, so that nothing repeats over the edge, and the texels.
fn raster(half: Vec2, texels: u32) -> (Vec2, [u32; 2]) {
    let texel = 2.0 * half.max_element().max(1e-4) / (texels.max(4) - 2) as f32;
    let n = (2.0 * half / texel).map(|n| libm::ceilf(n - 1e-3).max(1.0) + 2.0);
    (0.5 * texel * n, [n.x as u32, n.y as u32])
}

/// A mesh of some elements only.
fn part(mesh: &Mesh, all: &Elements, elements: &[u32]) -> Mesh {
    let mut surfaces: Vec<Surface> = mesh
        .surfaces
        .iter()
        .map(|surface| Surface { material: surface.material, ..Surface::default() })
        .collect();
    for &element in elements {
        let number = all.surface[element as usize] as usize;
        let (from, to) = (&mesh.surfaces[number], &mut surfaces[number]);
        for &t in all.triangles_of(element as usize) {
            for k in 0..3 {
                let vertex = from.indices[3 * t as usize + k] as usize;
                to.indices.push(to.positions.len() as u32);
                to.positions.push(from.positions[vertex]);
                to.normals.push(from.normals[vertex]);
                to.uvs.push(from.uvs[vertex]);
            }
        }
    }
    Mesh { surfaces, materials: mesh.materials.clone(), branches: Vec::new() }
}

fn texture(i: usize, width: u32, height: u32, covered: impl Iterator<Item = bool>) -> Texture {
    let [r, g, b] = LEAF;
    let pixels = covered.flat_map(|on| [r, g, b, if on { 255 } else { 0 }]).collect();
    Texture { name: format!("billboard{i}"), width, height, pixels }
}

fn quad(billboard: &Billboard, half: Vec2, material: u32) -> Surface {
    let (x, y) = (billboard.right * half.x, billboard.up * half.y);
    let c = billboard.center;
    Surface {
        positions: vec![c - x + y, c - x - y, c + x - y, c + x + y],
        normals: vec![billboard.normal(); 4],
        uvs: vec![Vec2::ZERO, Vec2::Y, Vec2::ONE, Vec2::X],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Surface::default()
    }
}
