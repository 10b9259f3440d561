//! Levels of detail of a tree by measured pruning (Neubert 2012, chapter 7).
//!
//! `cargo run --release --example prune -- [MESH.glb|.obj|.ply] [--grain blade|triangle|leaf] [--foliage N,N] [--levels λ,λ,…]
//! [--views N] [--out FOLDER]`
//!
//! Without a mesh, an oak with modelled leaves is grown. The leaves of an imported mesh are found by their materials;
//! `--foliage` names their surfaces by number where they are not. Prints a table of scale and quality, and writes
//!
//! * `NAME_levels.glb`: the levels as `MSFT_lod`, for programs without shaders of ours (default 1, 0.5, 0.2, 0.05);
//! * `NAME_pruned.glb` and `NAME_pruned.json`: the model with all tiers in one index buffer, and its windows;
//! * `NAME_levels.png`: each level close by, and at the size it is meant for.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tree_core::{Control, Seed, file};
use tree_lod::order::CoverageParams;
use tree_lod::preview::{self, Backdrop, Camera, Framing, Picture, Style, View};
use tree_lod::prune::{MakeParams, PrunedModel, Screen};
use tree_lod::{Grain, LeafSurfaces};
use tree_mesh::io::gltf::GlbOptions;
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{LeafForm, Look, Mesh, MeshParams};
use tree_model::path::PathParams;

const USAGE: &str = "prune [MESH.glb|.obj|.ply] [--grain blade|triangle|leaf] [--foliage N,N] \
                     [--levels λ,λ,…] [--views N] [--out FOLDER]";

/// Pixels of a level close by.
const SIZE: u32 = 480;
/// Least size in pixels of a level as far away as it is meant for.
const SMALLEST: u32 = 24;

/// What was asked for on the command line.
struct Request {
    mesh: Option<PathBuf>,
    params: MakeParams,
    views: Option<u32>,
    lambdas: Vec<f32>,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            mesh: None,
            params: MakeParams::default(),
            views: None,
            lambdas: vec![1.0, 0.5, 0.2, 0.05],
            out: "out".into(),
        };
        while let Some(argument) = arguments.next() {
            let mut value =
                || arguments.next().ok_or_else(|| format!("{argument} needs a value: {USAGE}"));
            match argument.as_str() {
                "--grain" => request.params.grain = grain(&value()?)?,
                "--foliage" => request.params.foliage = LeafSurfaces::Surfaces(list(&value()?)?),
                "--levels" => request.lambdas = list(&value()?)?,
                "--views" => request.views = Some(value()?.parse()?),
                "--out" => request.out = value()?.into(),
                other if !other.starts_with('-') && request.mesh.is_none() => {
                    request.mesh = Some(other.into());
                }
                other => return Err(format!("{other} is not known: {USAGE}").into()),
            }
        }
        Ok(request)
    }

    fn name(&self) -> String {
        let stem = self.mesh.as_deref().and_then(Path::file_stem);
        stem.map_or("oak".into(), |stem| stem.to_string_lossy().into_owned())
    }
}

fn grain(name: &str) -> Result<Grain, String> {
    match name {
        "blade" => Ok(Grain::Blade),
        "triangle" => Ok(Grain::Triangle),
        "leaf" => Ok(Grain::Leaf),
        other => Err(format!("{other} is no grain: blade, triangle or leaf")),
    }
}

fn list<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, String> {
    let parse = |part: &str| part.trim().parse().map_err(|_| format!("{part} is no number"));
    text.split(',').map(parse).collect()
}

fn main() -> ExitCode {
    match Request::parse(std::env::args().skip(1)).and_then(|request| run(&request)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(request: &Request) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let mesh = match &request.mesh {
        Some(path) => read(path, &control)?,
        None => oak(&control)?,
    };
    let mut params = request.params.clone();
    if let Some(views) = request.views {
        let mut order = CoverageParams::default();
        order.around.azimuths = views;
        params.order = Some(order);
    }
    let model = PrunedModel::make(&mesh, &params, &control)?;
    report(&model)?;
    std::fs::create_dir_all(&request.out)?;
    let path = |end: &str| request.out.join(format!("{}_{end}", request.name()));
    let options = GlbOptions::default();
    let glb = model.to_glb_levels(&request.lambdas, &Screen::default(), &options)?;
    write(&path("levels.glb"), &glb)?;
    write(&path("pruned.glb"), &model.to_glb(&options)?)?;
    write(&path("pruned.json"), model.to_json(&model.levels(64)?).as_bytes())?;
    picture(&model, &request.lambdas, &control)?.save_png(path("levels.png"))?;
    for end in ["levels.glb", "pruned.glb", "pruned.json", "levels.png"] {
        println!("{}", path(end).display());
    }
    Ok(())
}

fn report(model: &PrunedModel) -> Result<(), Box<dyn Error>> {
    println!("     λ  triangles  scale  precision  recall  quality");
    for row in model.table().rows() {
        let level = model.level(row.lambda)?;
        println!(
            "{:6.3} {:10} {:6.2} {:10.3} {:7.3} {:8.3}",
            row.lambda, level.n_triangles, row.scale, row.precision, row.recall, row.quality
        );
    }
    Ok(())
}

fn read(path: &Path, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    let options = ImportOptions::default();
    let end = path.extension().map(|end| end.to_string_lossy().to_lowercase());
    let imported = match end.as_deref() {
        Some("glb" | "gltf") => io::gltf::read(path, &options, control)?,
        Some("obj") => io::obj::read(path, &options, control)?,
        Some("ply") => io::ply::read(path, control)?,
        _ => return Err(format!("{}: neither .glb, .obj nor .ply", path.display()).into()),
    };
    Ok(imported.mesh)
}

/// The path modeler's oak, every leaf with its own outline.
fn oak(control: &Control) -> Result<Mesh, Box<dyn Error>> {
    let tree = PathParams::oak()?.grow(Seed(7), control)?.tree;
    let mut look = Look::built_in(tree.species())?;
    for leaf in &mut look.leaves {
        leaf.form = LeafForm::Modelled { max_vertices: 12 };
    }
    Ok(tree_mesh::build(&tree, &look, &MeshParams::default(), control)?.mesh)
}

/// Each level close by, and below it as large as it is meant for.
fn picture(
    model: &PrunedModel,
    lambdas: &[f32],
    control: &Control,
) -> Result<Picture, Box<dyn Error>> {
    let style = Style { ground: None, backdrop: Backdrop::Studio, ..Style::default() };
    // All levels are framed as the full model is.
    let full = model.mesh_at(1.0)?;
    let pose = Camera::Framed(Framing { pitch: 0.05, ..Framing::default() }).pose(&full, 1.0)?;
    let width = SIZE * lambdas.len() as u32;
    let blank = [224_u8, 224, 224, 255];
    let height = SIZE + SIZE / 2;
    let mut sheet =
        Picture { width, height, pixels: blank.repeat(width as usize * height as usize) };
    for (column, &lambda) in lambdas.iter().enumerate() {
        let mesh = model.mesh_at(lambda)?;
        // Cook's rule, λ = (1 − d)², read for the size on the screen.
        let small = ((SIZE / 2) as f32 * lambda.sqrt()) as u32;
        for (size, top) in [(SIZE, 0), (small.max(SMALLEST), SIZE)] {
            let camera = Camera::Placed(pose);
            let view = View { width: size, height: size, samples: 3, camera };
            let shot = preview::render(&mesh, &view, &style, control)?;
            let left = column as u32 * SIZE + (SIZE - size) / 2;
            paste(&mut sheet, &shot, left, top);
        }
    }
    Ok(sheet)
}

fn paste(sheet: &mut Picture, shot: &Picture, left: u32, top: u32) {
    for row in 0..shot.height {
        let to = 4 * ((top + row) as usize * sheet.width as usize + left as usize);
        let from = 4 * row as usize * shot.width as usize;
        let n = 4 * shot.width as usize;
        sheet.pixels[to..to + n].copy_from_slice(&shot.pixels[from..from + n]);
    }
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    file::write_atomic(path, |out| {
        out.write_all(bytes).map_err(|error| tree_core::CoreError::io(path, error).into())
    })
}
