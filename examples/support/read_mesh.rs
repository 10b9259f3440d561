//! A plain reader of GLB and OBJ for this example: positions, texture coordinates, indices, names.
//! To be replaced by the readers of `tree_mesh::io`.

use std::error::Error;
use std::path::Path;
use tree_core::glam::{Mat4, Vec2, Vec3};
use tree_mesh::{Alpha, Material, Mesh, Surface};

/// Reads a mesh by its extension.
pub(crate) fn read(path: &Path) -> Result<Mesh, Box<dyn Error>> {
    let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut mesh = match path.extension().and_then(|extension| extension.to_str()) {
        Some("glb") => glb(&bytes)?,
        Some("obj") => obj(&String::from_utf8_lossy(&bytes))?,
        _ => return Err(format!("{}: neither .glb nor .obj", path.display()).into()),
    };
    mesh.surfaces.iter_mut().for_each(flat_normals);
    Ok(mesh)
}

fn glb(bytes: &[u8]) -> Result<Mesh, Box<dyn Error>> {
    let file = gltf::Gltf::from_slice_without_validation(bytes)?;
    let blob = file.blob.as_deref().ok_or("no binary chunk")?;
    let mut mesh = Mesh::default();
    let mut is_child = vec![false; file.nodes().len()];
    for child in file.nodes().flat_map(|node| node.children().collect::<Vec<_>>()) {
        is_child[child.index()] = true;
    }
    let roots = file.nodes().filter(|node| !is_child[node.index()]);
    let mut open: Vec<_> = roots.map(|node| (node, Mat4::IDENTITY)).collect();
    while let Some((node, above)) = open.pop() {
        let place = above * Mat4::from_cols_array_2d(&node.transform().matrix());
        open.extend(node.children().map(|child| (child, place)));
        for primitive in node.mesh().into_iter().flat_map(|m| m.primitives().collect::<Vec<_>>()) {
            let reader = primitive.reader(|_| Some(blob));
            let positions: Vec<Vec3> = reader
                .read_positions()
                .ok_or("a primitive without positions")?
                .map(|p| place.transform_point3(p.into()))
                .collect();
            let uvs: Vec<Vec2> = match reader.read_tex_coords(0) {
                Some(uvs) => uvs.into_f32().map(Vec2::from).collect(),
                None => Vec::new(),
            };
            let indices = match reader.read_indices() {
                Some(indices) => indices.into_u32().collect(),
                None => (0..positions.len() as u32).collect(),
            };
            let material = primitive.material();
            let base_color = material.pbr_metallic_roughness().base_color_factor();
            mesh.materials.push(Material {
                name: material.name().unwrap_or_default().into(),
                base_color,
                alpha: match material.alpha_mode() {
                    gltf::material::AlphaMode::Mask => Alpha::Mask(0.5),
                    _ => Alpha::Opaque,
                },
                double_sided: true,
                ..Default::default()
            });
            let material = mesh.materials.len() as u32 - 1;
            let surface = Surface { positions, uvs, indices, material, ..Default::default() };
            mesh.surfaces.push(surface);
        }
    }
    Ok(mesh)
}

fn obj(text: &str) -> Result<Mesh, Box<dyn Error>> {
    let (mut points, mut texture) = (Vec::new(), Vec::new());
    let mut mesh = Mesh::default();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next().unwrap_or_default();
        let words: Vec<&str> = words.collect();
        let number = |i: usize| -> Result<f32, Box<dyn Error>> {
            Ok(words.get(i).ok_or("short line")?.parse()?)
        };
        match kind {
            "v" => points.push(Vec3::new(number(0)?, number(1)?, number(2)?)),
            "vt" => texture.push(Vec2::new(number(0)?, 1.0 - number(1)?)),
            "usemtl" => {
                let name: String = words.join(" ");
                let leafy = name.to_lowercase().contains("leaves");
                mesh.materials.push(Material {
                    base_color: if leafy { [0.2, 0.4, 0.1, 1.0] } else { [0.4, 0.3, 0.2, 1.0] },
                    name,
                    double_sided: true,
                    ..Default::default()
                });
                let material = mesh.materials.len() as u32 - 1;
                mesh.surfaces.push(Surface { material, ..Default::default() });
            }
            "f" => {
                let surface = mesh.surfaces.last_mut().ok_or("a face before usemtl")?;
                let first = surface.positions.len() as u32;
                for word in &words {
                    let mut numbers = word.split('/').map(str::parse::<usize>);
                    let v = numbers.next().ok_or("no vertex")??;
                    surface.positions.push(*points.get(v - 1).ok_or("no such vertex")?);
                    let vt = numbers.next().and_then(Result::ok).unwrap_or(0);
                    let uv = texture.get(vt.wrapping_sub(1)).copied().unwrap_or_default();
                    surface.uvs.push(uv);
                }
                for i in 2..words.len() as u32 {
                    surface.indices.extend([first, first + i - 1, first + i]);
                }
            }
            _ => {}
        }
    }
    Ok(mesh)
}

/// The preview wants normals; corners with several faces get their mean.
fn flat_normals(surface: &mut Surface) {
    surface.normals = vec![Vec3::ZERO; surface.positions.len()];
    if surface.uvs.is_empty() {
        surface.uvs = vec![Vec2::ZERO; surface.positions.len()];
    }
    for corners in surface.indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|i| surface.positions[corners[i] as usize]);
        for &corner in corners {
            surface.normals[corner as usize] += (b - a).cross(c - a);
        }
    }
    for normal in &mut surface.normals {
        *normal = normal.normalize_or(Vec3::Y);
    }
}
