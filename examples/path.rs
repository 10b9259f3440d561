//! Trees of least-cost paths (Xu & Mould 2012): every preset, any seed, a drawn profile.
//!
//! `cargo run --release --example path -- [--preset oak|a..l|taproot|heartroot] [--seed N]
//! [--profile curve.svg] [--height METRES] [--bare] [--swc] [--obj] [--out FOLDER]`
//!
//! Writes `NAME.glb` and `NAME.png`, with `--swc` and `--obj` also `NAME.swc` and `NAME.obj`.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::{Control, Seed, Volume, file, glam::Vec3, swc};
use tree_lod::preview::{self, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::io::obj::write_obj;
use tree_mesh::{Look, MeshParams};
use tree_model::path::{PathParams, Preset, Profile, ProfileOptions};

const USAGE: &str = "path [--preset oak|a..l|taproot|heartroot] [--seed N] [--profile curve.svg] \
                     [--height METRES] [--bare] [--swc] [--obj] [--out FOLDER]";

/// Radius of level 2 as a share of the height: small enough that the crown keeps the drawn outline.
const SIZE_SHARE: f32 = 0.13;
/// Enough main branches to fill any outline.
const MIN_ENDPOINTS: u32 = 40;

/// What was asked for on the command line.
struct Request {
    preset: String,
    seed: u64,
    profile: Option<PathBuf>,
    height: f32,
    bare: bool,
    swc: bool,
    obj: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            preset: "oak".into(),
            seed: 1,
            profile: None,
            height: 10.0,
            bare: false,
            swc: false,
            obj: false,
            out: "out".into(),
        };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--preset" => request.preset = value()?,
                "--seed" => request.seed = number(&name, &value()?)?,
                "--profile" => request.profile = Some(value()?.into()),
                "--height" => request.height = number(&name, &value()?)?,
                "--bare" => request.bare = true,
                "--swc" => request.swc = true,
                "--obj" => request.obj = true,
                "--out" => request.out = value()?.into(),
                _ => return Err(format!("unknown argument '{name}'").into()),
            }
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
    let mut params = Preset::find(&request.preset)?.params()?;
    let mut name = request.preset.clone();
    if let Some(drawing) = &request.profile {
        let text = file::read_text(drawing, &control.limits)?;
        let options = ProfileOptions { height: request.height, ..Default::default() };
        params = with_profile(params, &Profile::from_svg(&text, &options)?, request.height)?;
        name = drawing.file_stem().map_or(name, |stem| stem.to_string_lossy().into_owned());
    }
    if request.bare {
        params.leaves = None;
    }
    let grown = params.grow(Seed(request.seed), &control)?;
    let tree = &grown.tree;
    let look = Look::built_in(tree.species())?;
    let mesh = tree_mesh::build(tree, &look, &MeshParams::default(), &control)?.mesh;

    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |extension: &str| request.out.join(format!("{name}.{extension}"));
    write_glb(&mesh, path("glb"), &GlbOptions::default())?;
    if request.obj {
        write_obj(&mesh, path("obj"))?;
    }
    if request.swc {
        swc::write_file(&path("swc"), tree.skeleton(), &swc::SwcOptions::default())?;
    }
    let style = match params.roots {
        // Soil would hide the roots.
        Some(_) => Style { ground: None, ..Style::studio() },
        None => Style::default(),
    };
    preview::render(&mesh, &View::default(), &style, &control)?.save_png(path("png"))?;

    let graphs = grown.report.graphs();
    println!(
        "{}: {} graph nodes in {} graphs, {} endpoints, {} skeleton nodes, {} leaves, {} triangles",
        path("glb").display(),
        graphs.n_nodes,
        graphs.n_graphs,
        grown.report.endpoints(),
        tree.skeleton().len(),
        tree.foliage().len(),
        mesh.n_triangles(),
    );
    Ok(())
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}

/// Puts the drawn volume in the place of the preset's, and scales what grows in it along.
fn with_profile(
    params: PathParams,
    profile: &Profile,
    height: f32,
) -> Result<PathParams, Box<dyn Error>> {
    let mut params = params;
    let scale = SIZE_SHARE * height / params.size;
    // A short stem makes sure that the root is inside, whatever was drawn.
    let stem = Volume::cylinder(Vec3::ZERO, 0.1 * height * Vec3::Y, 0.03 * height)?;
    params.volume = profile.volume(Vec3::ZERO)?.union(&stem)?;
    params.size *= scale;
    for level in &mut params.levels {
        level.size = level.size.map(|size| size * scale);
    }
    params.endpoints.random = params.endpoints.random.max(MIN_ENDPOINTS);
    params.paint.clear();
    Ok(params)
}
