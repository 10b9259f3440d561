//! Pictures to look at: full against pruned, as large and at the distance they are meant for; masks; a forest.

use super::scene::{FOV, Forest};
use super::{Outcome, Prepared, SEED, SPACING, information};
use crate::table::Table;
use std::path::Path;
use tree_core::Control;
use tree_core::glam::{Mat4, Vec3};
use tree_lod::preview::{
    Backdrop, Camera, Framing, Lens, Picture, Pose, Style, View, mask, render,
};
use tree_lod::quality::{Distance, Table as Measured, cook_lambda};
use tree_mesh::{Mesh, Surface};
use tree_model::particle::Photo;

/// Where pictures go.
const OUT: &str = "out/prune";
/// Shares that are shown, the full model first.
const LAMBDAS: [f32; 4] = [1.0, 0.6, 0.2, 0.05];
/// Pixels along the sides of a tree's picture at λ = 1.
const SIZE: u32 = 420;
/// Trees of the forest that is drawn.
const TREES: u32 = 60;
/// Pixels of its picture.
const WIDE: [u32; 2] = [1280, 640];

pub(super) fn evaluate(table: &mut Table, models: &[Prepared<'_>], cook: &[Measured]) -> Outcome {
    std::fs::create_dir_all(OUT)?;
    for prepared in models {
        let meshes = LAMBDAS
            .iter()
            .map(|&l| Ok(prepared.ours.mesh_at(l)?.0))
            .collect::<Outcome<Vec<_>>>()?;
        let name = prepared.model.name.replace([',', ' '], "_");
        let near: Vec<Picture> =
            meshes.iter().map(|m| tree(m, prepared, SIZE)).collect::<Outcome<_>>()?;
        save(&beside(&near), &format!("{name}_near"))?;
        let masks = meshes.iter().map(|m| masked(m, prepared)).collect::<Outcome<Vec<_>>>()?;
        save(&beside(&masks), &format!("{name}_masks"))?;
        // Pairs of full and pruned at the size on the screen at which Cook's rule asks for λ.
        let mut far = Vec::new();
        for (mesh, &lambda) in meshes.iter().zip(&LAMBDAS).skip(1) {
            let size = size_for(lambda);
            far.push(tree(&meshes[0], prepared, size)?);
            far.push(tree(mesh, prepared, size)?);
        }
        save(&beside(&far), &format!("{name}_far"))?;
    }
    forest(table, models, cook)?;
    information(table, &format!("pictures in {OUT}"), "models", models.len() as f64, "");
    Ok(())
}

/// Size on the screen at which a tree is drawn with λ, when it is [`SIZE`] at λ = 0.8: by Cook's rule the
/// distance goes from 0 to 1 as λ goes from 1 to 0.
fn size_for(lambda: f32) -> u32 {
    let distance = |lambda: f32| {
        let (mut low, mut high) = (0.0_f32, 1.0_f32);
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if cook_lambda(middle) > lambda { low = middle } else { high = middle }
        }
        low
    };
    ((SIZE as f32 * distance(0.8) / distance(lambda)) as u32).max(16)
}

fn framed(prepared: &Prepared<'_>) -> Outcome<Camera> {
    let camera = Camera::Framed(Framing { yaw: 0.5, pitch: 0.1, ..Framing::default() });
    // The frame of the full model, for all.
    Ok(Camera::Placed(camera.pose(&prepared.model.mesh, 1.0)?))
}

fn style() -> Style {
    Style { ground: None, backdrop: Backdrop::Studio, ..Style::default() }
}

fn tree(mesh: &Mesh, prepared: &Prepared<'_>, size: u32) -> Outcome<Picture> {
    let view = View { width: size, height: size, samples: 2, camera: framed(prepared)? };
    Ok(render(mesh, &view, &style(), &Control::default())?)
}

/// What is covered: black by both, red where the pruned model is too large, blue where it lacks.
fn masked(mesh: &Mesh, prepared: &Prepared<'_>) -> Outcome<Picture> {
    let view = View { width: SIZE, height: SIZE, samples: 1, camera: framed(prepared)? };
    let control = Control::default();
    let full = mask(&prepared.model.mesh, &view, &control)?;
    let other = mask(mesh, &view, &control)?;
    let ink = |(full, other)| match (full, other) {
        (true, true) => [50, 50, 50, 255],
        (false, true) => [220, 50, 40, 255],
        (true, false) => [60, 110, 230, 255],
        (false, false) => [255, 255, 255, 255_u8],
    };
    let pixels = full.bits().zip(other.bits()).flat_map(ink).collect();
    Ok(Picture { width: SIZE, height: SIZE, pixels })
}

/// A forest: all trees full, then at the λ at which they are as good as Cook's.
fn forest(table: &mut Table, models: &[Prepared<'_>], cook: &[Measured]) -> Outcome {
    let forest = Forest::new(TREES, models.len() as u32, SPACING, SEED)?;
    let eye = Vec3::new(0.0, 14.0, 1.2 * forest.side);
    let far = 2.5 * forest.side;
    let lens = Lens::Perspective { fov: 0.5 * FOV };
    let camera = Camera::Placed(Pose { eye, target: Vec3::new(0.0, 4.0, 0.0), up: Vec3::Y, lens });
    let view = View { width: WIDE[0], height: WIDE[1], samples: 2, camera };
    let mut triangles = [0; 2];
    for (at, name) in ["forest_full", "forest_pruned"].into_iter().enumerate() {
        let mut all = Mesh::default();
        for (number, (prepared, cook)) in models.iter().zip(cook).enumerate() {
            let first = all.surfaces.len();
            let of_model = &prepared.model.mesh;
            for surface in &of_model.surfaces {
                let material = surface.material + all.materials.len() as u32;
                all.surfaces.push(Surface { material, ..Surface::default() });
            }
            all.materials.extend(of_model.materials.iter().cloned());
            let parity = Distance::parity(&prepared.ours.table, cook);
            for tree in forest.instances.iter().filter(|tree| tree.model as usize == number) {
                let d = tree.position.distance(eye) / tree.scale / far;
                if at == 0 {
                    add(&mut all.surfaces[first..], of_model, &tree.matrix());
                } else {
                    let (pruned, _) = prepared.ours.mesh_at(parity.lambda(d))?;
                    add(&mut all.surfaces[first..], &pruned, &tree.matrix());
                }
            }
        }
        triangles[at] = all.n_triangles();
        save(&render(&all, &view, &Style::default(), &Control::default())?, name)?;
    }
    let case = format!("pictures in {OUT}: forest of {TREES} trees");
    information(table, &case, "triangles, wood included", triangles[1] as f64, "triangles");
    information(table, &case, "triangles of full trees", triangles[0] as f64, "triangles");
    Ok(())
}

/// Adds a tree to surfaces that hold others of its model.
fn add(surfaces: &mut [Surface], tree: &Mesh, matrix: &Mat4) {
    for (to, from) in surfaces.iter_mut().zip(&tree.surfaces) {
        let first = to.positions.len() as u32;
        to.positions.extend(from.positions.iter().map(|&p| matrix.transform_point3(p)));
        let turned = |&n: &Vec3| matrix.transform_vector3(n).normalize_or(Vec3::Y);
        to.normals.extend(from.normals.iter().map(turned));
        to.uvs.extend(&from.uvs);
        to.indices.extend(from.indices.iter().map(|i| first + i));
    }
}

/// Pictures in a row, smaller ones in the middle.
fn beside(pictures: &[Picture]) -> Picture {
    let width = pictures.iter().map(|p| p.width).sum();
    let height = pictures.iter().map(|p| p.height).max().unwrap_or(1);
    let mut out = Picture { width, height, pixels: vec![255; 4 * (width * height) as usize] };
    let mut left = 0;
    for picture in pictures {
        let top = (height - picture.height) / 2;
        for (y, row) in picture.pixels.chunks(4 * picture.width as usize).enumerate() {
            let at = 4 * ((top + y as u32) * width + left) as usize;
            out.pixels[at..at + row.len()].copy_from_slice(row);
        }
        left += picture.width;
    }
    out
}

fn save(picture: &Picture, name: &str) -> Outcome {
    let pixels = picture.pixels.as_chunks().0.to_vec();
    let photo = Photo::new(picture.width, picture.height, pixels)?;
    Ok(photo.save_png(Path::new(OUT).join(format!("{name}.png")))?)
}
