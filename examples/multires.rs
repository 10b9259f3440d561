//! A tree at any level of detail: branches by prefix, leaves by geometry or images (Lluch et al. 2010).
//!
//! `cargo run --release --example multires -- [PRESET|FILE.l] [--seed N] [--precision METRES] [--out FOLDER]`
//!
//! Grows an L-system, makes it a hybrid model, and writes `NAME_hybrid.glb` (levels as `MSFT_lod`),
//! `NAME_wood.glb` (all branches in one prefix-ordered buffer), `NAME.trem` (the tree as a progressive stream),
//! `NAME_cards.png` (pictures of the leaves) and `NAME_distances.png`: full above, hybrid below, at four
//! distances, each in the pixels it is meant for and then enlarged.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::{Control, Seed, Tree, file};
use tree_lod::hybrid::{Hybrid, HybridParams};
use tree_lod::multires::stream::{self, StreamParams};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::io::gltf::GlbOptions;
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::lsystem::LSystem;

const USAGE: &str = "multires [PRESET|FILE.l] [--seed N] [--precision METRES] [--out FOLDER]";
/// Height of the screen in pixels that levels in the file are meant for.
const SCREEN: f32 = 1080.0;
/// Heights of the tree on the screen in pixels.
const HEIGHTS: [f32; 4] = [1000.0, 250.0, 100.0, 40.0];
/// Side of a shown picture in pixels.
const SHOWN: u32 = 512;

struct Request {
    system: String,
    seed: u64,
    stream: StreamParams,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let stream = StreamParams { precision: 0.001 };
        let mut request = Self { system: String::new(), seed: 1, stream, out: "out".into() };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--seed" => request.seed = number(&name, &value()?)?,
                "--precision" => request.stream.precision = number(&name, &value()?)?,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ if request.system.is_empty() => request.system = name,
                _ => return Err("give one grammar".into()),
            }
        }
        request.stream.validate()?;
        if request.system.is_empty() {
            request.system = "oak".into();
        }
        Ok(request)
    }

    fn tree(&self, control: &Control) -> Result<(Tree, String), Box<dyn Error>> {
        let path = Path::new(&self.system);
        if path.extension().is_some_and(|end| end == "l") {
            let text = file::read_text(path, &control.limits)?;
            let system = LSystem::parse(&text, &control.limits)
                .map_err(|error| format!("{}: {error}", path.display()))?;
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            return Ok((system.grow(Seed(self.seed), control)?.tree, name));
        }
        let system = LSystem::preset(&self.system)?;
        Ok((system.grow(Seed(self.seed), control)?.tree, self.system.clone()))
    }
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name}: '{text}' is not a number that fits"))
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
    let (tree, name) = request.tree(&control)?;
    let look = Look::built_in(tree.species())?;
    let hybrid = Hybrid::make(&tree, &look, &HybridParams::default(), &control)?;
    let full = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;

    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |tail: &str| request.out.join(format!("{name}{tail}"));
    let options = GlbOptions::default();
    hybrid.write_glb_levels(&HEIGHTS, SCREEN, &path("_hybrid.glb"), &options)?;
    hybrid.wood().write_glb(&path("_wood.glb"), &options)?;
    stream::write_file(hybrid.multires(), usize::MAX, &request.stream, &path(".trem"))?;
    if let Some(cards) = hybrid.cards() {
        cards.color.save_png(path("_cards.png"))?;
    }
    println!(
        "{name}: {} nodes, {} leaves, {} levels, {} bytes of stream",
        tree.skeleton().len(),
        tree.foliage().len(),
        hybrid.multires().n_levels(),
        std::fs::metadata(path(".trem"))?.len(),
    );
    let mut shown = Vec::new();
    for height in HEIGHTS {
        let choice = hybrid.choice_for_height(height)?;
        let (boxes, leaves) =
            choice.leaves.as_ref().map_or((0, 0), |leaves| (leaves.boxes.len(), leaves.n_leaves()));
        println!(
            "{height:>6} px high: level {:.1}, {leaves} leaves, {boxes} boxes, {} of {} triangles",
            choice.level,
            hybrid.n_triangles(&choice),
            full.n_triangles(),
        );
        let reduced = hybrid.mesh_of(&choice)?;
        shown.push([
            show(&full, &full, height, &control)?,
            show(&reduced, &full, height, &control)?,
        ]);
    }
    sheet(&shown).save_png(path("_distances.png"))?;
    Ok(())
}

/// A mesh, framed as the full one is, drawn with the tree so many pixels high, and enlarged or cut to the
/// size that is shown.
fn show(
    mesh: &Mesh,
    full: &Mesh,
    height: f32,
    control: &Control,
) -> Result<Picture, Box<dyn Error>> {
    let side = (height.min(SHOWN as f32) as u32).max(8);
    let camera = Camera::Placed(Camera::Framed(Framing::default()).pose(full, 1.0)?);
    let view = View { width: side, height: side, camera, ..View::default() };
    let picture = preview::render(mesh, &view, &Style::default(), control)?;
    let mut shown = Picture { width: SHOWN, height: SHOWN, pixels: Vec::new() };
    for y in 0..SHOWN {
        for x in 0..SHOWN {
            let at = |i: u32| (i * side / SHOWN).min(side - 1);
            shown.pixels.extend(picture.pixel(at(x), at(y)).unwrap_or_default());
        }
    }
    Ok(shown)
}

/// Pairs side by side, the first of each above.
fn sheet(shown: &[[Picture; 2]]) -> Picture {
    let (width, height) = (SHOWN * shown.len() as u32, 2 * SHOWN);
    let mut pixels = Vec::with_capacity(4 * (width * height) as usize);
    for row in 0..height {
        for pair in shown {
            let picture = &pair[(row / SHOWN) as usize];
            let start = 4 * (row % SHOWN * SHOWN) as usize;
            pixels.extend_from_slice(&picture.pixels[start..start + 4 * SHOWN as usize]);
        }
    }
    Picture { width, height, pixels }
}
