//! A whole stand of one drawing: one outline for each tree (Wither et al. 2009, figure 10).
//!
//! `cargo run --release --example stand -- DRAWING.svg [--height METRES] [--species NAME] [--arrangement NAME]
//! [--density X] [--seed N] [--horizon Y | --flat] [--pictures] [--out FOLDER]`
//!
//! Each tree is a group `tree1`, `tree2`, …; see `examples/outlines/README.md`. Trees without details borrow them. `--height` is that of
//! the tallest tree. `--horizon` gives the horizon's y in the drawing; without it, it is estimated. `--flat` is for drawings without perspective.
//! `--arrangement` and `--density` are how branches stand round the trunk, and how many are added in space for each one in the plane; given
//! again, on the branches, and so on. For flat fronds: `--arrangement spiral --density 1 --arrangement opposite --density 0`.
//!
//! Writes `NAME_stand.glb`, all trees where they stand, and pictures: `NAME_stand_front.png` as drawn, `NAME_stand_above.png` from above.
//! The file is large, for every leaf is cut out as it was drawn; `--pictures` leaves it out.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Instant;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, file};
use tree_lod::preview::{self, Camera, Framing, Lens, Picture, Pose, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{LeafForm, LeafMesh, Look, Mesh, MeshParams};
use tree_model::particle::finish::FinishParams;
use tree_model::silhouette::grow::LevelParams;
use tree_model::silhouette::place::Arrangement;
use tree_model::silhouette::read::{self, OutlineDrawing};
use tree_model::silhouette::stand::{Perspective, Stand, StandParams, StandTree, StandView};

const USAGE: &str = "stand DRAWING.svg [--height METRES] [--species NAME] [--arrangement NAME] [--density X] \
                     [--seed N] [--horizon Y | --flat] [--pictures] [--out FOLDER]";

/// Width of the pictures in pixels.
const WIDTH: u32 = 1400;

/// What was asked for on the command line.
struct Request {
    drawing: PathBuf,
    params: StandParams,
    seed: u64,
    pictures: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            drawing: PathBuf::new(),
            params: StandParams::default(),
            seed: 1,
            pictures: false,
            out: "out".into(),
        };
        let (mut arrangements, mut densities) = (Vec::new(), Vec::new());
        let silhouette = &mut request.params.silhouette;
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--height" => silhouette.height = number(&name, &value()?)?,
                "--species" => silhouette.grow.species = FinishParams::find(&value()?)?.species,
                "--arrangement" => arrangements.push(value()?.parse::<Arrangement>()?),
                "--density" => densities.push(number(&name, &value()?)?),
                "--pictures" => request.pictures = true,
                "--seed" => request.seed = number(&name, &value()?)?,
                "--horizon" => {
                    request.params.perspective = Perspective::Horizon(number(&name, &value()?)?);
                }
                "--flat" => request.params.perspective = Perspective::Flat,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ if request.drawing.as_os_str().is_empty() => request.drawing = name.into(),
                _ => return Err("give one drawing".into()),
            }
        }
        for i in 0..arrangements.len().max(densities.len()) {
            let level = LevelParams::default();
            let arrangement = arrangements.get(i).copied().unwrap_or_default();
            let density = densities.get(i).copied().unwrap_or(level.density);
            silhouette.grow.levels.push(LevelParams { arrangement, density, ..level });
        }
        if request.drawing.as_os_str().is_empty() {
            return Err("give a drawing".into());
        }
        Ok(request)
    }
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let request = Request::parse(std::env::args().skip(1))
        .map_err(|error| format!("{error}\nusage: {USAGE}"))?;
    let control = Control::default();
    let drawing = read::from_svg(&file::read_text(&request.drawing, &control.limits)?)?;
    drawing.repairs.iter().for_each(|repair| eprintln!("warning: {repair}"));
    let name = request.drawing.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |tail: &str| request.out.join(format!("{name}_stand{tail}"));
    let started = Instant::now();
    let stand = Stand::of_drawing(&drawing, &request.params, Seed(request.seed), &control)?;
    let elapsed = started.elapsed();
    table(&stand);
    println!("{} elements in {elapsed:.0?}", stand.elements());
    let mesh = merged(&stand, &control)?;
    let front = match &stand.view {
        Some(view) => as_drawn(&mesh, view, &drawing, &control)?,
        None => framed(&mesh, 0.0, 0.04, &control)?,
    };
    front.save_png(path("_front.png"))?;
    framed(&mesh, 0.4, 0.5, &control)?.save_png(path("_above.png"))?;
    if !request.pictures {
        write_glb(&mesh, path(".glb"), &GlbOptions::default())?;
    }
    println!("{}: {} triangles", path("").display(), mesh.n_triangles());
    Ok(())
}

/// What grew, tree by tree.
fn table(stand: &Stand) {
    println!("tree       strokes  branches    leaves       x       z  height  details of");
    for tree in &stand.trees {
        let report = &tree.grown.report;
        let height = tree.grown.tree.skeleton().bounds().max.y;
        let lender = stand.trees.iter().find(|other| Some(other.index) == tree.lender);
        let details = lender.map_or_else(
            || "its own".into(),
            |lender| format!("{} × {:.2}", lender.name, tree.borrowed_scale),
        );
        println!(
            "{:10} {:7} {:9} {:9} {:7.2} {:7.2} {:7.2}  {details}",
            tree.name,
            tree.strokes.strokes,
            report.branches.iter().sum::<u64>(),
            report.n_leaves,
            tree.position.x,
            tree.position.z,
            height,
        );
        let lines = tree.strokes.repairs.iter().chain(&tree.strokes.refused);
        lines.for_each(|line| eprintln!("warning: {}: {line}", tree.name));
    }
    stand.notes.iter().for_each(|note| eprintln!("warning: {note}"));
    if let Some(view) = &stand.view {
        println!("horizon at y = {:.0}, the eye {:.2} m up", view.center.y, view.eye.y);
    }
}

/// All trees where they stand, as one mesh.
fn merged(stand: &Stand, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    let mut all = Mesh::default();
    for tree in &stand.trees {
        let mesh =
            tree_mesh::build(&tree.grown.tree, &look(tree)?, &MeshParams::default(), control)?.mesh;
        let first = all.materials.len() as u32;
        all.materials.extend(mesh.materials);
        for mut surface in mesh.surfaces {
            surface.positions.iter_mut().for_each(|point| *point += tree.position);
            surface.anchors.iter_mut().for_each(|point| *point += tree.position);
            surface.material += first;
            // Wind and light maps are a single tree's.
            surface.branches.clear();
            surface.uvs2.clear();
            all.surfaces.push(surface);
        }
    }
    Ok(all)
}

/// The species' look; a drawn leaf is cut out as it was drawn.
fn look(tree: &StandTree) -> Result<Look, Box<dyn Error>> {
    let species = tree.grown.tree.species();
    let mut look = Look::built_in(species)?;
    let Some(leaf) = tree.plan().and_then(|plan| plan.leaf.as_ref()) else { return Ok(look) };
    look.leaves = Look::plain(species).leaves;
    for kind in &mut look.leaves {
        let mesh = LeafMesh::flat(&leaf.outline.points, &leaf.outline.triangles);
        kind.form = LeafForm::Mesh(Arc::new(mesh));
    }
    Ok(look)
}

fn framed(mesh: &Mesh, yaw: f32, pitch: f32, control: &Control) -> Result<Picture, Box<dyn Error>> {
    let camera = Camera::Framed(Framing { yaw, pitch, ..Framing::default() });
    let view = View { width: WIDTH, height: WIDTH * 6 / 10, samples: 2, camera };
    Ok(preview::render(mesh, &view, &Style::default(), control)?)
}

/// The stand from where it was drawn.
///
/// The eye looks level at the horizon, which may lie outside the drawing: the picture holds both, and is cut to the drawing.
fn as_drawn(
    mesh: &Mesh,
    view: &StandView,
    drawing: &OutlineDrawing,
    control: &Control,
) -> Result<Picture, Box<dyn Error>> {
    let points = || drawing.trees.iter().flat_map(|tree| &tree.strokes).flat_map(|s| &s.points);
    let low = points().fold(view.center, |low, point| low.min(*point));
    let high = points().fold(view.center, |high, point| high.max(*point));
    let margin = 0.03 * (high - low).max_element();
    let half = (high - view.center).max(view.center - low) + margin;
    let pixels = WIDTH as f32 / (2.0 * half.x);
    let lens = Lens::Perspective { fov: 2.0 * libm::atanf(half.y / view.focal) };
    let pose = Pose { eye: view.eye, target: view.eye - Vec3::Z, up: Vec3::Y, lens };
    let height = (2.0 * half.y * pixels).ceil() as u32;
    let view_of = View { width: WIDTH, height, samples: 2, camera: Camera::Placed(pose) };
    let mut picture = preview::render(mesh, &view_of, &Style::default(), control)?;
    // The point looked at is always within the bounds; one side of it is as long as the other.
    let seen = points().fold(f32::INFINITY, |top, point| top.min(point.y)) - margin;
    let first = ((seen - view.center.y + half.y) * pixels).max(0.0) as u32;
    let last = (((high.y + margin - view.center.y + half.y) * pixels) as u32).min(height);
    let row = 4 * WIDTH as usize;
    picture.pixels = picture.pixels[first as usize * row..last as usize * row].to_vec();
    picture.height = last - first;
    Ok(picture)
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
