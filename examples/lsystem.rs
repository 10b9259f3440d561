//! A tree from a grammar (Prusinkiewicz & Lindenmayer 1990).
//!
//! `cargo run --release --example lsystem -- FILE.l|PRESET|--list [--steps N] [--seed N] [--height METRES] [--bare]
//! [--stages] [--out FOLDER]`
//!
//! Writes `NAME.glb` and `NAME.png`; with `--stages` also the derived word as `NAME.txt` and its lines, seen from
//! the front, as `NAME_lines.png`. `--list` names the presets. Mistakes in a grammar are told with line and column.

#[path = "common/paper.rs"]
#[expect(dead_code, reason = "shared with the examples of sketches")]
mod paper;

use paper::{Frame, INK, Paper, Side};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::{Control, Seed, file, glam::Vec2};
use tree_lod::preview::{self, Picture, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{Look, MeshParams};
use tree_model::lsystem::{Grown, LSystem, presets, turtle};

const USAGE: &str = "lsystem FILE.l|PRESET|--list [--steps N] [--seed N] [--height METRES] [--bare] [--stages] \
                     [--out FOLDER]";

/// Pixels along the longer side of the picture of lines.
const SIZE: u32 = 900;

/// What was asked for on the command line.
struct Request {
    system: String,
    list: bool,
    steps: Option<u32>,
    seed: u64,
    height: Option<f32>,
    bare: bool,
    stages: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            system: String::new(),
            list: false,
            steps: None,
            seed: 1,
            height: None,
            bare: false,
            stages: false,
            out: "out".into(),
        };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--list" => request.list = true,
                "--steps" => request.steps = Some(number(&name, &value()?)?),
                "--seed" => request.seed = number(&name, &value()?)?,
                "--height" => request.height = Some(number(&name, &value()?)?),
                "--bare" => request.bare = true,
                "--stages" => request.stages = true,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ if request.system.is_empty() => request.system = name,
                _ => return Err("give one grammar".into()),
            }
        }
        if request.system.is_empty() && !request.list {
            return Err("give a grammar".into());
        }
        Ok(request)
    }

    /// The L-system, and what to call files made of it.
    fn system(&self, control: &Control) -> Result<(LSystem, String), Box<dyn Error>> {
        let path = Path::new(&self.system);
        let (mut system, name) = if path.extension().is_some_and(|end| end == "l") {
            let text = file::read_text(path, &control.limits)?;
            let system = LSystem::parse(&text, &control.limits)
                .map_err(|error| format!("{}: {error}", path.display()))?;
            (system, path.file_stem().unwrap_or_default().to_string_lossy().into_owned())
        } else {
            (LSystem::preset(&self.system)?, self.system.clone())
        };
        system.steps = self.steps.or(system.steps);
        system.turtle.height = self.height.or(system.turtle.height);
        if self.bare {
            system.species.leaf_kinds.clear();
        }
        Ok((system, name))
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
    if request.list {
        for preset in presets() {
            println!("{:<14} {:<36} {}", preset.name(), preset.title(), preset.source());
        }
        return Ok(());
    }
    let control = Control::default();
    let (system, name) = request.system(&control)?;
    let grown = system.grow(Seed(request.seed), &control)?;
    let tree = &grown.tree;
    let look = Look::built_in(tree.species())?;
    let mesh = tree_mesh::build(tree, &look, &MeshParams::default(), &control)?.mesh;

    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |tail: &str| request.out.join(format!("{name}{tail}"));
    write_glb(&mesh, path(".glb"), &GlbOptions::default())?;
    preview::render(&mesh, &View::default(), &Style::default(), &control)?
        .save_png(path(".png"))?;
    if request.stages {
        std::fs::write(path(".txt"), grown.word.text(system.grammar.symbols()))
            .map_err(|error| format!("cannot write {}: {error}", path(".txt").display()))?;
        lines(&system, &grown, &control)?.save_png(path("_lines.png"))?;
    }
    for warning in grown.report.turtle.warnings() {
        eprintln!("warning: {warning}");
    }
    println!(
        "{}: {} modules, {} skeleton nodes, {} leaves, {} polygons, {} triangles",
        path(".glb").display(),
        grown.word.len(),
        tree.skeleton().len(),
        tree.foliage().len(),
        grown.polygons.len(),
        mesh.n_triangles(),
    );
    Ok(())
}

/// The word as lines, from the front.
fn lines(system: &LSystem, grown: &Grown, control: &Control) -> Result<Picture, Box<dyn Error>> {
    let lines = turtle::lines(&grown.word, system.grammar.symbols(), &system.turtle, control)?;
    let seen: Vec<[Vec2; 2]> =
        lines.iter().map(|line| line.map(|end| Side::Front.seen(end))).collect();
    let (mut low, mut high) = (Vec2::ZERO, Vec2::splat(1e-6));
    for end in seen.iter().flatten() {
        (low, high) = (low.min(*end), high.max(*end));
    }
    let mut paper = Paper::new(Frame::of(Side::Front, low, high, SIZE));
    for line in &seen {
        paper.line(line, 1.2, INK);
    }
    Ok(paper.picture())
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
