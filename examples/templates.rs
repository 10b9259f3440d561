//! The templates that sketches are guided by: lists them, rebuilds the shipped data, adds one's own trees.
//!
//! `cargo run --release --example templates -- list [FILE]`
//! `… build OUT.txt` measures all exemplars and writes them; the shipped file is
//! `tree-model/src/sketch/template/templates.txt`.
//! `… add TREE.swc|TREE.glb|TREE.obj --name NAME [--species SPECIES] OUT.txt` measures a tree and adds it to a file of
//! templates, in the place of one of the same name; the file is made if there is none.
//! `… sheet FOLDER` draws every exemplar beside its sketch: `FOLDER/templates.jpg`.

use image::{DynamicImage, ImageFormat, Rgba, RgbaImage, imageops};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use tree_core::glam::Vec2;
use tree_core::{Control, CoreError, Foliage, Seed, Species, Tree, file, swc};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{Look, MeshParams};
use tree_model::skeletonize::{SkeletonizeParams, skeletonize};
use tree_model::sketch::Drawing;
use tree_model::sketch::template::{
    self, EXEMPLARS, Exemplar, MainBranchParams, Template, TemplateParams, main_branches, project,
};

const USAGE: &str = "templates list [FILE] | build OUT.txt | sheet FOLDER | \
                     add TREE.swc|TREE.glb|TREE.obj --name NAME [--species SPECIES] OUT.txt";

/// The seed of the shipped exemplars.
const SEED: Seed = template::EXEMPLAR_SEED;
/// Exemplars in a row of the sheet, and pixels along each side of a picture.
const COLUMNS: u32 = 4;
const TILE: u32 = 240;
/// Where the eye stands in the sheet, in radians.
const YAW: f32 = 0.6;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["list"] => {
            list(Template::builtin()?);
            Ok(())
        }
        ["list", path] => {
            list(&read(Path::new(path))?);
            Ok(())
        }
        ["build", out] => build(Path::new(out)),
        ["add", rest @ ..] => add(rest),
        ["sheet", folder] => sheet(Path::new(folder)),
        _ => Err(format!("usage: {USAGE}").into()),
    }
}

fn list(templates: &[Template]) {
    for template in templates {
        let title = Exemplar::find(&template.name).map_or("", |exemplar| exemplar.title());
        println!(
            "{:14} leaves of {:15} {:5.1} m high, {} views  {title}",
            template.name,
            template.species,
            template.height,
            template.views.len(),
        );
    }
}

fn read(path: &Path) -> Outcome<Vec<Template>> {
    let text = file::read_text(path, &Control::default().limits)?;
    Ok(template::parse(&text).map_err(|error| format!("{}: {error}", path.display()))?)
}

fn write(path: &Path, templates: &[Template]) -> Outcome {
    let text = template::to_text(templates);
    file::write_atomic(path, |out| {
        out.write_all(text.as_bytes()).map_err(|error| CoreError::io(path, error))
    })?;
    println!("{}: {} templates, {} bytes", path.display(), templates.len(), text.len());
    Ok(())
}

fn build(out: &Path) -> Outcome {
    let control = Control::default();
    let params = TemplateParams::default();
    let measured = EXEMPLARS.into_iter().map(|exemplar| {
        let tree = exemplar.tree(SEED, &control)?;
        Template::of_tree(exemplar.name(), exemplar.species(), &tree, &params, &control)
    });
    write(out, &measured.collect::<Result<Vec<_>, _>>()?)
}

fn add(arguments: &[&str]) -> Outcome {
    let (mut name, mut species, mut paths) = (None, None, Vec::new());
    let mut arguments = arguments.iter();
    while let Some(&argument) = arguments.next() {
        let mut value = || arguments.next().copied().ok_or(format!("{argument} needs a value"));
        match argument {
            "--name" => name = Some(value()?),
            "--species" => species = Some(value()?),
            _ if argument.starts_with("--") => {
                return Err(format!("unknown argument '{argument}'\nusage: {USAGE}").into());
            }
            _ => paths.push(argument),
        }
    }
    let (&[input, out], Some(name)) = (paths.as_slice(), name) else {
        return Err(format!("usage: {USAGE}").into());
    };
    let out = Path::new(out);
    let mut templates = if out.exists() { read(out)? } else { Vec::new() };
    let control = Control::default();
    let tree = tree(Path::new(input), &control)?;
    let species = species.unwrap_or("oak");
    let template = Template::of_tree(name, species, &tree, &TemplateParams::default(), &control)?;
    templates.retain(|other| other.name != name);
    templates.push(template);
    write(out, &templates)
}

/// Reads a tree: a skeleton as SWC, or a mesh that is turned into one.
fn tree(path: &Path, control: &Control) -> Outcome<Tree> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    if extension == "swc" {
        let read = swc::read_file(path, &swc::SwcOptions::default(), &control.limits)?;
        return Ok(Tree::new(read.skeleton, Foliage::default(), Species::default())?);
    }
    let mesh = io::read(path, &ImportOptions { external: true }, control)?.mesh;
    Ok(skeletonize(&mesh.parts(), &SkeletonizeParams::default(), control)?.tree)
}

/// Every exemplar beside its sketch.
fn sheet(folder: &Path) -> Outcome {
    std::fs::create_dir_all(folder)?;
    let control = Control::default();
    let mut tiles = Vec::new();
    for exemplar in EXEMPLARS {
        let tree = exemplar.tree(SEED, &control)?;
        let look = Look::built_in(tree.species())?;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
        let framing = Framing { yaw: YAW, pitch: 0.03, margin: 0.05, ..Framing::default() };
        let camera = Camera::Framed(framing);
        let view = View { width: TILE, height: TILE, samples: 3, camera };
        let picture = preview::render(&mesh, &view, &Style::default(), &control)?;
        let branches = main_branches(tree.skeleton(), &MainBranchParams::default())?;
        tiles.push(beside(picture, &drawn(&project(&branches, YAW, &[])))?);
        println!("{}: {}", exemplar.name(), exemplar.title());
    }
    let mut sheet =
        RgbaImage::new(2 * TILE * COLUMNS, TILE * (tiles.len() as u32).div_ceil(COLUMNS));
    for (number, tile) in (0_u32..).zip(&tiles) {
        let (x, y) = (number % COLUMNS * 2 * TILE, number / COLUMNS * TILE);
        imageops::replace(&mut sheet, tile, i64::from(x), i64::from(y));
    }
    let path = folder.join("templates.jpg");
    DynamicImage::ImageRgba8(sheet).to_rgb8().save_with_format(&path, ImageFormat::Jpeg)?;
    println!("{}", path.display());
    Ok(())
}

fn beside(picture: Picture, sketch: &RgbaImage) -> Outcome<RgbaImage> {
    let left = RgbaImage::from_raw(picture.width, picture.height, picture.pixels)
        .ok_or("a picture with too few pixels")?;
    let mut both = RgbaImage::new(2 * TILE, TILE);
    imageops::replace(&mut both, &left, 0, 0);
    imageops::replace(&mut both, sketch, i64::from(TILE), 0);
    Ok(both)
}

/// A drawing in ink on paper, the trunk a little thicker.
fn drawn(drawing: &Drawing) -> RgbaImage {
    const MARGIN: f32 = 0.06;
    let points = || drawing.strokes.iter().flat_map(|stroke| &stroke.points);
    let low = points().fold(Vec2::INFINITY, |low, &p| low.min(p));
    let high = points().fold(Vec2::NEG_INFINITY, |high, &p| high.max(p));
    let size = TILE as f32;
    let scale = (1.0 - 2.0 * MARGIN) * size / (high - low).max_element().max(1e-6);
    let to_pixels = |p: Vec2| (p - 0.5 * (low + high)) * scale + Vec2::splat(0.5 * size);
    let mut paper = RgbaImage::from_pixel(TILE, TILE, Rgba([250, 247, 240, 255]));
    for (number, stroke) in drawing.strokes.iter().enumerate() {
        let radius = if number == 0 { 1.6 } else { 0.9 };
        for pair in stroke.points.windows(2) {
            ink(&mut paper, to_pixels(pair[0]), to_pixels(pair[1]), radius);
        }
    }
    paper
}

/// Draws a line with soft edges.
fn ink(paper: &mut RgbaImage, a: Vec2, b: Vec2, radius: f32) {
    let (low, high) = (a.min(b) - radius - 1.0, a.max(b) + radius + 1.0);
    let along = (b - a) / (b - a).length_squared().max(1e-9);
    for y in low.y.max(0.0) as u32..(high.y.max(0.0) as u32 + 1).min(paper.height()) {
        for x in low.x.max(0.0) as u32..(high.x.max(0.0) as u32 + 1).min(paper.width()) {
            let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let t = (p - a).dot(along).clamp(0.0, 1.0);
            let light = (p.distance(a + t * (b - a)) - radius + 0.5).clamp(0.0, 1.0);
            let pixel = paper.get_pixel_mut(x, y);
            for channel in &mut pixel.0[..3] {
                *channel = (*channel).min((45.0 + 210.0 * light) as u8);
            }
        }
    }
}
