//! A tree from drawn outlines (Wither et al. 2009).
//!
//! `cargo run --release --example silhouette -- OUTLINE.svg|.png|.jpg [--height METRES] [--species NAME] [--arrangement NAME]
//! [--density X] [--levels N] [--bare] [--seed N] [--stages] [--out FOLDER]`
//!
//! An SVG drawing has layers `L0` (trunk and crown), `L1` (the outline of one branch, branches drawn over), `L2`, … and
//! `leaf`; see `examples/outlines/README.md`. One that has none, and a picture, are taken for a whole silhouette: what is filled, or not transparent.
//! `--arrangement` is how branches stand round the trunk: spread, spiral, opposite, decussate, whorl3, horizontal, or
//! branches at a node and degrees to the next as in 2:90; given twice, the second is for the branches on branches, and so on.
//!
//! Writes `NAME.glb`, `NAME_front.png` and `NAME_side.png`; with `--stages` also the plan: outlines, inferred branches and their sub-silhouettes.

#[path = "common/paper.rs"]
#[allow(dead_code)]
mod paper;

use paper::{Frame, Paper, Side};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;
use std::sync::Arc;
use tree_core::glam::Vec2;
use tree_core::{Control, Limits, Seed, file};
use tree_lod::preview::{self, Picture, Style};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{LeafForm, LeafMesh, Look, Mesh, MeshParams};
use tree_model::particle::Photo;
use tree_model::particle::finish::FinishParams;
use tree_model::silhouette::grow::LevelParams;
use tree_model::silhouette::place::Arrangement;
use tree_model::silhouette::plan::{Plan, System};
use tree_model::silhouette::read::{self, OutlineDrawing};
use tree_model::silhouette::session::{Session, SilhouetteParams};

const USAGE: &str = "silhouette OUTLINE.svg|.png|.jpg [--height METRES] [--species NAME] \
                     [--arrangement NAME] [--density X] [--levels N] [--bare] [--seed N] [--stages] [--out FOLDER]";

/// Pixels along the longer side of pictures.
const SIZE: u32 = 900;

/// What was asked for on the command line.
struct Request {
    outline: PathBuf,
    params: SilhouetteParams,
    species: Option<String>,
    seed: u64,
    stages: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            outline: PathBuf::new(),
            params: SilhouetteParams::default(),
            species: None,
            seed: 1,
            stages: false,
            out: "out".into(),
        };
        let (mut arrangements, mut density) = (Vec::new(), None);
        let grow = &mut request.params.grow;
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--height" => request.params.height = number(&name, &value()?)?,
                "--species" => request.species = Some(value()?),
                "--arrangement" => arrangements.push(value()?.parse::<Arrangement>()?),
                "--density" => density = Some(number(&name, &value()?)?),
                "--levels" => grow.depth = Some(number(&name, &value()?)?),
                "--bare" => grow.leaves = None,
                "--seed" => request.seed = number(&name, &value()?)?,
                "--stages" => request.stages = true,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ if request.outline.as_os_str().is_empty() => request.outline = name.into(),
                _ => return Err("give one drawing".into()),
            }
        }
        if request.outline.as_os_str().is_empty() {
            return Err("give a drawing".into());
        }
        for i in 0..arrangements.len().max(usize::from(density.is_some())) {
            let level = LevelParams::default();
            let arrangement = arrangements.get(i).copied().unwrap_or_default();
            let density = density.unwrap_or(level.density);
            grow.levels.push(LevelParams { arrangement, density, ..level });
        }
        if let Some(species) = &request.species {
            let finish = FinishParams::find(species)?;
            grow.species = finish.species;
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
    let drawing = read_drawing(&request.outline, &control.limits)?;
    drawing.repairs.iter().for_each(|repair| eprintln!("warning: {repair}"));
    let name = request.outline.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |tail: &str| request.out.join(format!("{name}{tail}"));
    let tree = drawing.trees.first().ok_or("the drawing shows no tree")?;
    let started = std::time::Instant::now();
    let (session, report) = Session::of_drawing(tree, request.params.clone(), Seed(request.seed))?;
    let drawn = started.elapsed();
    report.repairs.iter().chain(&report.refused).for_each(|line| eprintln!("warning: {line}"));
    let plan = session.plan().ok_or("the drawing has no crown")?;
    let grown = session.tree(&control)?;
    println!("plan {drawn:?}, all {:?}", started.elapsed());
    let mesh =
        tree_mesh::build(&grown.tree, &look(plan, &grown.tree)?, &MeshParams::default(), &control)?
            .mesh;
    for (side, tail) in [(Side::Front, "_front.png"), (Side::Right, "_side.png")] {
        let frame = frame(side, plan, &mesh);
        let style = Style { ground: None, ..Style::studio() };
        preview::render(&mesh, &frame.view(), &style, &control)?.save_png(path(tail))?;
        if request.stages && side == Side::Front {
            stages(frame, plan).save_png(path("_plan.png"))?;
        }
    }
    write_glb(&mesh, path(".glb"), &GlbOptions::default())?;
    println!(
        "{}: {} strokes, {:?} branches, {} leaves ({} elements), {} triangles, {:?}, no room {}",
        path(".glb").display(),
        report.strokes,
        grown.report.branches,
        grown.report.n_leaves,
        grown.report.elements(),
        mesh.n_triangles(),
        session.coverage(),
        grown.report.n_without_room,
    );
    Ok(())
}

fn read_drawing(path: &Path, limits: &Limits) -> Result<OutlineDrawing, Box<dyn Error>> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    Ok(match extension.as_deref() {
        Some("svg") => read::from_svg(&file::read_text(path, limits)?)?,
        Some("png" | "jpg" | "jpeg") => read::from_photo(&Photo::open(path, limits)?)?,
        _ => return Err(format!("{}: .svg, .png or .jpg is wanted", path.display()).into()),
    })
}

/// The species' look; a drawn leaf is cut out as it was drawn.
fn look(plan: &Plan, tree: &tree_core::Tree) -> Result<Look, Box<dyn Error>> {
    let Some(leaf) = &plan.leaf else { return Ok(Look::built_in(tree.species())?) };
    let mut look = Look::built_in(tree.species())?;
    look.leaves = Look::plain(tree.species()).leaves;
    for kind in &mut look.leaves {
        let mesh = LeafMesh::flat(&leaf.outline.points, &leaf.outline.triangles);
        kind.form = LeafForm::Mesh(Arc::new(mesh));
    }
    Ok(look)
}

/// A frame round the tree and the drawing.
fn frame(side: Side, plan: &Plan, mesh: &Mesh) -> Frame {
    let (mut low, mut high) = plan.system.outline.bounds();
    if side == Side::Right {
        (low.x, high.x) = (0.0, 0.0);
    }
    let bounds = mesh.bounds();
    for corner in [bounds.min, bounds.max] {
        low = low.min(side.seen(corner));
        high = high.max(side.seen(corner));
    }
    Frame::of(side, low.min(Vec2::ZERO), high.max(Vec2::ZERO), SIZE)
}

/// The plan: outlines and branches, level by level.
fn stages(frame: Frame, plan: &Plan) -> Picture {
    let mut paper = Paper::new(frame);
    draw(&mut paper, &plan.system, 0);
    paper.picture()
}

fn draw(paper: &mut Paper, system: &System, level: usize) {
    const INKS: [[u8; 3]; 4] = [[30, 34, 60], [60, 150, 70], [205, 120, 40], [60, 130, 190]];
    let ink = |level: usize| INKS[level.min(INKS.len() - 1)];
    let closed = |points: &[Vec2]| points.iter().chain(points.first()).copied().collect::<Vec<_>>();
    let wide = if level == 0 { 3.0 } else { 2.0 };
    for lateral in &system.laterals {
        paper.line(&closed(lateral.outline.points()), 1.0, ink(level + 1));
        paper.line(lateral.line.points(), 1.5, ink(level + 1));
        if let Some(inner) = &lateral.system {
            draw(paper, inner, level + 1);
        }
    }
    paper.line(&closed(system.outline.points()), wide, ink(level));
    paper.line(system.axis.points(), wide, ink(level));
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
