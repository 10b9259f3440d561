//! Every preset in one picture, for the gallery page: `docs/pictures/presets.jpg`, the black
//! silhouettes as the paper's Fig. 12 and 14 show them, `docs/pictures/silhouettes.png`, and the presets of grammars,
//! `docs/pictures/lsystems.jpg`.
//!
//! `cargo run --release --example gallery -- [FOLDER] [SEED] [TILE_PX]`; with `lsystems` as the first argument the
//! last one alone.

use image::{DynamicImage, ImageFormat, RgbaImage, imageops};
use std::error::Error;
use std::path::{Path, PathBuf};
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::{Look, MeshParams};
use tree_model::lsystem;
use tree_model::path::PRESETS;

/// Pictures in a row.
const COLUMNS: u32 = 5;
/// Presets of grammars are many: so many in a row, and each of them smaller by this share.
const GRAMMAR_COLUMNS: u32 = 8;
const GRAMMAR_SIZE: f32 = 0.55;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).peekable();
    let grammars_alone = arguments.next_if(|first| first == "lsystems").is_some();
    let folder = arguments.next().map_or_else(|| PathBuf::from("docs/pictures"), PathBuf::from);
    let seed = Seed(arguments.next().map_or(Ok(3), |text| text.parse())?);
    let tile = arguments.next().map_or(Ok(360), |text| text.parse())?;
    std::fs::create_dir_all(&folder)?;
    let control = Control::default();
    grammars(&folder, tile, &control)?;
    if grammars_alone {
        return Ok(());
    }
    let mut pictures = Vec::new();
    let mut silhouettes = Vec::new();
    for preset in PRESETS {
        let params = preset.params()?;
        let tree = params.grow(seed, &control)?.tree;
        let look = Look::built_in(tree.species())?;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
        let framing = Framing { pitch: 0.05, margin: 0.04, ..Framing::default() };
        let view = View { width: tile, height: tile, samples: 3, camera: Camera::Framed(framing) };
        let style = match params.roots {
            // Soil would hide the roots.
            Some(_) => Style { ground: None, ..Style::studio() },
            None => Style::default(),
        };
        pictures.push(preview::render(&mesh, &view, &style, &control)?);

        let mut bare = params;
        bare.leaves = None;
        let tree = bare.grow(seed, &control)?.tree;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
        silhouettes.push(preview::silhouette(&mesh, &view, &control)?);
        println!("{}: {}", preset.name(), preset.title());
    }
    save(&sheet(&pictures, tile, COLUMNS)?, &folder.join("presets.jpg"), ImageFormat::Jpeg)?;
    save(&sheet(&silhouettes, tile, COLUMNS)?, &folder.join("silhouettes.png"), ImageFormat::Png)
}

/// Presets of grammars, each with its own seed.
fn grammars(folder: &Path, tile: u32, control: &Control) -> Result<(), Box<dyn Error>> {
    let tile = (tile as f32 * GRAMMAR_SIZE) as u32;
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
    let sheet = sheet(&pictures, tile, GRAMMAR_COLUMNS)?;
    save(&sheet, &folder.join("lsystems.jpg"), ImageFormat::Jpeg)
}

/// Pictures side by side.
fn sheet(pictures: &[Picture], tile: u32, columns: u32) -> Result<DynamicImage, Box<dyn Error>> {
    let rows = (pictures.len() as u32).div_ceil(columns);
    let white = image::Rgba([255; 4]);
    let mut sheet = RgbaImage::from_pixel(columns * tile, rows * tile, white);
    for (i, picture) in (0_u32..).zip(pictures) {
        let image = RgbaImage::from_raw(picture.width, picture.height, picture.pixels.clone())
            .ok_or("a picture with too few pixels")?;
        let (x, y) = (i % columns * tile, i / columns * tile);
        imageops::replace(&mut sheet, &image, i64::from(x), i64::from(y));
    }
    Ok(DynamicImage::ImageRgba8(sheet))
}

fn save(sheet: &DynamicImage, path: &Path, format: ImageFormat) -> Result<(), Box<dyn Error>> {
    match format {
        // JPEG has no alpha; a grey picture is a third of the size.
        ImageFormat::Jpeg => sheet.to_rgb8().save_with_format(path, format)?,
        _ => sheet.to_luma8().save_with_format(path, format)?,
    }
    println!("{}", path.display());
    Ok(())
}
