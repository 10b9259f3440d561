//! Presets: `presets.jpg`, the black silhouettes as the paper's Fig. 12 and 14 show them, `silhouettes.png`, and the presets of
//! grammars, `lsystems.jpg`.

use crate::{Outcome, sheet};
use image::{DynamicImage, RgbaImage};
use std::path::Path;
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::{Look, MeshParams};
use tree_model::lsystem;
use tree_model::path::PRESETS;

pub(crate) const PARTS: [&str; 2] = ["presets", "lsystems"];

/// Pictures in a row, and their side in pixels.
const COLUMNS: usize = 5;
const TILE: u32 = 360;
const SEED: Seed = Seed(3);
/// Presets of grammars are many: so many in a row, and each of them smaller.
const GRAMMAR_COLUMNS: usize = 8;
const GRAMMAR_TILE: u32 = 198;

pub(crate) fn draw(part: &str, folder: &Path) -> Outcome {
    let control = Control::default();
    if part == "presets" { paths(folder, &control) } else { grammars(folder, &control) }
}

/// Presets of least-cost paths, with leaves and bare.
fn paths(folder: &Path, control: &Control) -> Outcome {
    let mut pictures = Vec::new();
    let mut silhouettes = Vec::new();
    for preset in PRESETS {
        let params = preset.params()?;
        let tree = params.grow(SEED, control)?.tree;
        let look = Look::built_in(tree.species())?;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), control)?.mesh;
        let framing = Framing { pitch: 0.05, margin: 0.04, ..Framing::default() };
        let view = View { width: TILE, height: TILE, samples: 3, camera: Camera::Framed(framing) };
        let style = match params.roots {
            // Soil would hide the roots.
            Some(_) => Style { ground: None, ..Style::studio() },
            None => Style::default(),
        };
        pictures.push(preview::render(&mesh, &view, &style, control)?);

        let mut bare = params;
        bare.leaves = None;
        let tree = bare.grow(SEED, control)?.tree;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), control)?.mesh;
        silhouettes.push(preview::silhouette(&mesh, &view, control)?);
        println!("{}: {}", preset.name(), preset.title());
    }
    sheet::save(&tiled(&pictures, COLUMNS)?, &folder.join("presets.jpg"))?;
    sheet::save(&tiled(&silhouettes, COLUMNS)?, &folder.join("silhouettes.png"))
}

/// Presets of grammars, each with its own seed.
fn grammars(folder: &Path, control: &Control) -> Outcome {
    let tile = GRAMMAR_TILE;
    let mut pictures = Vec::new();
    for preset in lsystem::presets() {
        let tree = preset.system()?.grow(Seed(1), control)?.tree;
        let look = Look::built_in(tree.species())?;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), control)?.mesh;
        let framing = Framing { pitch: 0.05, margin: 0.04, ..Framing::default() };
        let view = View { width: tile, height: tile, samples: 3, camera: Camera::Framed(framing) };
        pictures.push(preview::render(&mesh, &view, &Style::default(), control)?);
        println!("{}: {}", preset.name(), preset.title());
    }
    sheet::save(&tiled(&pictures, GRAMMAR_COLUMNS)?, &folder.join("lsystems.jpg"))
}

fn tiled(pictures: &[Picture], columns: usize) -> Outcome<DynamicImage> {
    let image = |picture: &Picture| {
        RgbaImage::from_raw(picture.width, picture.height, picture.pixels.clone())
            .map(DynamicImage::ImageRgba8)
            .ok_or("a picture with too few pixels")
    };
    let images = pictures.iter().map(image).collect::<Result<Vec<_>, _>>()?;
    Ok(sheet::tiles(&images, columns))
}
