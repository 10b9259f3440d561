//! A tree from a freehand drawing (Neubert 2012, chapter 4).
//!
//! `cargo run --release --example sketch -- DRAWING.svg|.json|.ndjson [--line N] [--template NAME] [--keep-omega]
//! [--height METRES] [--species NAME] [--bare] [--seed N] [--stages] [--out FOLDER]`
//!
//! `--line` says which drawing of an NDJSON file is meant, from 1. Without `--template` the one that suits the drawing best
//! guides the reconstruction; `--keep-omega` keeps its parameters as they are instead of adapting them to the drawing.
//!
//! Writes `NAME.glb`, `NAME_front.png`, which lines up with the drawing, and `NAME_side.png`; with `--stages` also
//! the cleaned strokes over the drawing, the inferred branches and those that grew on them, both from the front and from the side. All
//! that was repaired is printed in sentences.

#[path = "common/paper.rs"]
mod paper;

use paper::{Frame, Paper, Side};
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::{Control, Seed, file};
use tree_lod::preview::{self, Picture, Style};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::sketch::Drawing;
use tree_model::sketch::session::{Session, SketchParams};

const USAGE: &str = "sketch DRAWING.svg|.json|.ndjson [--line N] [--template NAME] [--keep-omega] \
                     [--height METRES] [--species NAME] [--bare] [--seed N] [--stages] [--out FOLDER]";

/// Pixels along the longer side of pictures.
const SIZE: u32 = 900;

/// What was asked for on the command line.
struct Request {
    drawing: PathBuf,
    line: Option<usize>,
    params: SketchParams,
    seed: u64,
    stages: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            drawing: PathBuf::new(),
            line: None,
            params: SketchParams::default(),
            seed: 1,
            stages: false,
            out: "out".into(),
        };
        let params = &mut request.params;
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--line" => request.line = Some(number(&name, &value()?)?),
                "--template" => params.template = Some(value()?),
                "--keep-omega" => params.infer.keep_omega = true,
                "--height" => params.height = Some(number(&name, &value()?)?),
                "--species" => params.species = Some(value()?),
                "--bare" => params.finish.leaves = false,
                "--seed" => request.seed = number(&name, &value()?)?,
                "--stages" => request.stages = true,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ if request.drawing.as_os_str().is_empty() => request.drawing = name.into(),
                _ => return Err("give one drawing".into()),
            }
        }
        if request.drawing.as_os_str().is_empty() {
            return Err("give a drawing".into());
        }
        Ok(request)
    }

    /// The drawing, and what to call files made of it.
    fn drawing(&self, control: &Control) -> Result<(Drawing, String), Box<dyn Error>> {
        let text = file::read_text(&self.drawing, &control.limits)?;
        let mut drawings = paper::read_drawings(&self.drawing, &text)?;
        let name = self.drawing.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let n = drawings.len();
        let line = self.line.unwrap_or(1);
        if line == 0 || line > n {
            return Err(format!("--line {line}: there are {n} drawings").into());
        }
        let name = if n > 1 { format!("{name}_{line}") } else { name };
        Ok((drawings.swap_remove(line - 1), name))
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
    let (drawing, name) = request.drawing(&control)?;
    let mut session = Session::new(drawing, request.params, Seed(request.seed))?;
    let grown = session.tree(&control)?.clone();
    let look = Look::built_in(grown.tree.species())?;
    let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), &control)?.mesh;
    let pictures = pictures(&mut session, &mesh, request.stages, &control)?;

    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |tail: &str| request.out.join(format!("{name}{tail}"));
    write_glb(&mesh, path(".glb"), &GlbOptions::default())?;
    for (what, picture) in pictures {
        picture.save_png(path(&format!("_{what}.png")))?;
    }
    for warning in grown.report.warnings() {
        eprintln!("warning: {warning}");
    }
    let templates = session.templates()?.to_vec();
    let choices: Vec<String> = session
        .choices(&control)?
        .iter()
        .take(3)
        .filter_map(|choice| Some((templates.get(choice.template)?, choice)))
        .map(|(template, choice)| format!("{} ({:.2})", template.name, choice.score))
        .collect();
    match choices.split_first() {
        Some((best, next)) => println!("template {best}; next {}", next.join(", ")),
        None => println!("template {}", grown.report.template),
    }
    println!(
        "{}: {} segments drawn, {} skeleton nodes, {} leaves, {} triangles",
        path(".glb").display(),
        grown.report.segments,
        grown.tree.skeleton().len(),
        grown.tree.foliage().len(),
        mesh.n_triangles(),
    );
    Ok(())
}

/// All pictures asked for, and what they show.
fn pictures(
    session: &mut Session,
    mesh: &Mesh,
    stages: bool,
    control: &Control,
) -> Result<Vec<(&'static str, Picture)>, Box<dyn Error>> {
    let drawing = session.drawing().clone();
    let cleaned = session.cleaned(control)?.clone();
    let crown = session.crown(control)?.cloned();
    let inferred = session.inferred(control)?.branches.clone();
    let grown = &session.propagated(control)?.branches;
    let style = Style { ground: None, ..Style::studio() };
    let mut pictures = Vec::new();
    for (side, names) in [
        (Side::Front, ["front", "inferred_front", "propagated_front"]),
        (Side::Right, ["side", "inferred_side", "propagated_side"]),
    ] {
        let frame = Frame::around(side, &cleaned, &drawing, mesh, SIZE);
        pictures.push((names[0], preview::render(mesh, &frame.view(), &style, control)?));
        if stages {
            for (name, branches) in [(names[1], &inferred), (names[2], grown)] {
                let mut paper = Paper::new(frame);
                paper.branches(branches, inferred.len());
                pictures.push((name, paper.picture()));
            }
        }
        if stages && side == Side::Front {
            let mut paper = Paper::new(frame);
            paper.cleaned(&drawing, &cleaned, crown.as_ref());
            pictures.push(("cleaned", paper.picture()));
        }
    }
    Ok(pictures)
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
