//! A tree from one to a few loose photographs (Neubert 2012, chapter 3).
//!
//! `cargo run --release --example photo -- FRONT [SIDE …] [--trimap PICTURE …] [--strokes DRAWING.svg …]
//! [--yaw DEGREES …] [--height METRES] [--species NAME] [--bare] [--particles N] [--seed N] [--stages]
//! [--out FOLDER]`
//!
//! Photographs with an alpha channel are taken as they are; the others are separated from what is behind
//! them with a trimap (black background, white tree, grey unknown) or, without one, as a tree against the sky.
//! Views are a quarter turn apart unless `--yaw` says otherwise. The n-th `--trimap`, `--strokes` and
//! `--yaw` belong to the n-th photograph; `-` leaves one out.
//!
//! Writes `NAME.glb` and `NAME.png`, and with `--stages` pictures of alpha, branches, density, directions and
//! traces.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::{Control, Seed, file, glam::Vec2};
use tree_lod::preview::{self, Lens, Pose, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{Look, MeshParams};
use tree_model::particle::finish::FinishParams;
use tree_model::particle::matting::{self, AutomaticParams, NaturalParams, Trimap};
use tree_model::particle::session::{Attractor, PhotoParams, Session, Shot};
use tree_model::particle::{Camera, Matte, Photo, attractor};

const USAGE: &str = "photo FRONT [SIDE …] [--trimap PICTURE …] [--strokes DRAWING.svg …] [--yaw DEGREES …] \
                     [--height METRES] [--species NAME] [--bare] [--particles N] [--seed N] [--stages] \
                     [--out FOLDER]";

/// What was asked for on the command line.
struct Request {
    photos: Vec<PathBuf>,
    trimaps: Vec<String>,
    strokes: Vec<String>,
    yaws: Vec<String>,
    height: f32,
    species: String,
    bare: bool,
    particles: Option<u32>,
    seed: u64,
    stages: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            photos: Vec::new(),
            trimaps: Vec::new(),
            strokes: Vec::new(),
            yaws: Vec::new(),
            height: 10.0,
            species: "oak".into(),
            bare: false,
            particles: None,
            seed: 1,
            stages: false,
            out: "out".into(),
        };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--trimap" => request.trimaps.push(value()?),
                "--strokes" => request.strokes.push(value()?),
                "--yaw" => request.yaws.push(value()?),
                "--height" => request.height = number(&name, &value()?)?,
                "--species" => request.species = value()?,
                "--bare" => request.bare = true,
                "--particles" => request.particles = Some(number(&name, &value()?)?),
                "--seed" => request.seed = number(&name, &value()?)?,
                "--stages" => request.stages = true,
                "--out" => request.out = value()?.into(),
                _ if name.starts_with("--") => {
                    return Err(format!("unknown argument '{name}'").into());
                }
                _ => request.photos.push(name.into()),
            }
        }
        if request.photos.is_empty() {
            return Err("give at least one photograph".into());
        }
        Ok(request)
    }

    fn params(&self) -> Result<PhotoParams, Box<dyn Error>> {
        let mut params = PhotoParams {
            height: self.height,
            finish: FinishParams::find(&self.species)?,
            ..PhotoParams::default()
        };
        if self.bare {
            params.finish.leaves = None;
        }
        if let Some(particles) = self.particles {
            params.flow.particles = particles;
        }
        Ok(params)
    }

    fn shot(&self, index: usize, control: &Control) -> Result<Shot, Box<dyn Error>> {
        let path = &self.photos[index];
        let photo = Photo::open(path, &control.limits)?;
        let given = |list: &[String]| list.get(index).filter(|text| *text != "-").cloned();
        let matte = matte(&photo, given(&self.trimaps).as_deref(), control)
            .map_err(|error| format!("{}: {error}", path.display()))?;
        let yaw = match given(&self.yaws) {
            Some(degrees) => number::<f32>("--yaw", &degrees)?,
            None => 90.0 * index as f32,
        };
        let size = Vec2::new(photo.width() as f32, photo.height() as f32);
        let mut shot = Shot::new(matte, Some(photo), yaw.to_radians());
        if let Some(drawing) = given(&self.strokes) {
            let text = file::read_text(Path::new(&drawing), &control.limits)?;
            shot.attractor = Attractor::Strokes(attractor::strokes_from_svg(&text, size)?);
        }
        Ok(shot)
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
    let shots: Result<Vec<_>, _> =
        (0..request.photos.len()).map(|index| request.shot(index, &control)).collect();
    let mut session = Session::new(shots?, request.params()?, Seed(request.seed))?;
    let grown = session.tree(&control)?.clone();

    let look = Look::built_in(grown.tree.species())?;
    let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), &control)?.mesh;
    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let name = request.photos[0].file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let path = |tail: &str| request.out.join(format!("{name}{tail}"));
    write_glb(&mesh, path(".glb"), &GlbOptions::default())?;
    preview::render(&mesh, &View::default(), &Style::default(), &control)?
        .save_png(path(".png"))?;
    if request.stages {
        for view in 0..request.photos.len() {
            let to = |stage: &str| path(&format!("_{view}_{stage}.png"));
            session.picture_of_matte(view)?.save_png(to("alpha"))?;
            session.picture_of_attractor(view, &control)?.save_png(to("branches"))?;
            session.picture_of_field(view, &control)?.save_png(to("directions"))?;
            session.picture_of_traces(view, &control)?.save_png(to("traces"))?;
            let camera = session.views(&control)?[view].camera;
            preview::render(&mesh, &as_photographed(&camera), &Style::studio(), &control)?
                .save_png(to("model"))?;
        }
        session.picture_of_density(&control)?.save_png(path("_density.png"))?;
    }
    for warning in grown.report.warnings() {
        eprintln!("warning: {warning}");
    }
    println!(
        "{}: {} particles, {} skeleton nodes, {} leaves ({} discarded), {} triangles",
        path(".glb").display(),
        grown.report.flow.n_particles,
        grown.tree.skeleton().len(),
        grown.tree.foliage().len(),
        grown.report.crown.n_leaves_discarded,
        mesh.n_triangles(),
    );
    Ok(())
}

/// The picture of a model from where a photograph was taken.
fn as_photographed(camera: &Camera) -> View {
    let stand = camera.stand();
    let lens = match stand.fov {
        Some(fov) => Lens::Perspective { fov },
        None => Lens::Orthographic { height: stand.height },
    };
    let pose = Pose { eye: stand.eye, target: stand.target, up: stand.up, lens };
    let (width, height) = (camera.size.x as u32, camera.size.y as u32);
    View { width, height, samples: 2, camera: preview::Camera::Placed(pose) }
}

/// How much of each pixel the tree covers: by the trimap, by the photograph's alpha, or against the sky.
fn matte(photo: &Photo, trimap: Option<&str>, control: &Control) -> Result<Matte, Box<dyn Error>> {
    if let Some(path) = trimap {
        let trimap = Trimap::from_photo(&Photo::open(path, &control.limits)?);
        return Ok(matting::natural(photo, &trimap, &NaturalParams::default(), control)?.0);
    }
    let (matte, report) = matting::automatic(photo, &AutomaticParams::default(), control)?;
    for warning in &report.warnings {
        eprintln!("warning: {warning}");
    }
    Ok(matte)
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
