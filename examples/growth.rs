//! Self-organising trees (Palubicki et al. 2009): every preset, year by year, beside a wall, with a neighbour.
//!
//! `cargo run --release --example growth -- [--preset NAME] [--seed N] [--iterations N] [--wall X]
//! [--neighbour X] [--light X,Y,Z] [--space] [--bare] [--years N | --all] [--out FOLDER]`
//!
//! Writes `NAME.glb` and `NAME.png`. `--wall` puts a wall across the x axis, `--neighbour` a second tree on it,
//! `--light` moves the brightest point of the sky, `--space` lets buds compete for space instead of light.
//! `--years` draws the tree every so many iterations into one picture, `--all` all presets; these write no mesh.

mod common;

use common::sheet;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;
use tree_core::glam::Vec3;
use tree_core::{Aabb, Control, Seed, Volume};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{Look, Material, Mesh, MeshParams, Surface};
use tree_model::growth::{
    Environment, Grown, GrowthParams, PRESETS, Plant, Preset, Simulation, Space,
};
use tree_model::path::Obstacle;

const USAGE: &str = "growth [--preset NAME] [--seed N] [--iterations N] [--wall X] [--neighbour X] \
                     [--light X,Y,Z] [--space] [--bare] [--years N | --all] [--out FOLDER]";

/// Side of one picture of a sheet in pixels.
const TILE: u32 = 640;
/// Half width and height of the wall in metres.
const WALL: [f32; 2] = [3.0, 5.0];

/// What was asked for on the command line.
struct Request {
    preset: String,
    seed: u64,
    iterations: Option<u32>,
    wall: Option<f32>,
    neighbour: Option<f32>,
    light: Vec3,
    space: bool,
    bare: bool,
    years: Option<u32>,
    all: bool,
    out: PathBuf,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            preset: "oak".into(),
            seed: 1,
            iterations: None,
            wall: None,
            neighbour: None,
            light: Vec3::Y,
            space: false,
            bare: false,
            years: None,
            all: false,
            out: "out".into(),
        };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--preset" => request.preset = value()?,
                "--seed" => request.seed = number(&name, &value()?)?,
                "--iterations" => request.iterations = Some(number(&name, &value()?)?),
                "--wall" => request.wall = Some(number(&name, &value()?)?),
                "--neighbour" => request.neighbour = Some(number(&name, &value()?)?),
                "--light" => request.light = vector(&name, &value()?)?,
                "--space" => request.space = true,
                "--bare" => request.bare = true,
                "--years" => request.years = Some(number::<u32>(&name, &value()?)?.max(1)),
                "--all" => request.all = true,
                "--out" => request.out = value()?.into(),
                _ => return Err(format!("unknown argument '{name}'").into()),
            }
        }
        Ok(request)
    }

    /// A preset's parameters, changed by what was asked for.
    fn params(&self, preset: Preset) -> Result<GrowthParams, Box<dyn Error>> {
        let mut params = preset.params();
        params.iterations = self.iterations.unwrap_or(params.iterations);
        params.world.light = self.light;
        params.world.obstacle = match self.wall {
            Some(x) => Some(Obstacle { volume: wall(x)?, clearance: 0.05 }),
            None => None,
        };
        if self.space {
            let internode = params.habit.internode;
            let (occupancy, perception) = (2.0 * internode, 5.0 * internode);
            let space = Space { occupancy, perception, ..Space::default() };
            params.world.environment = Environment::Space(space);
        }
        if self.bare {
            params.habit.leaves = None;
        }
        Ok(params)
    }

    fn plants(&self, params: &GrowthParams) -> Vec<Plant> {
        let at = |x: f32| Plant { base: Vec3::new(x, 0.0, 0.0), ..params.planting() };
        std::iter::once(at(0.0)).chain(self.neighbour.map(at)).collect()
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
    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let path = |name: &str| request.out.join(name);
    if request.all {
        let mut pictures = Vec::new();
        for preset in PRESETS {
            let stand = grow(&request, preset, |_| Ok(()))?;
            pictures.push(picture(&merged(&stand, request.wall, &control)?, TILE, &control)?);
        }
        sheet(&pictures, 3, TILE)?.save(path("presets.png"))?;
        return Ok(());
    }
    let preset = Preset::find(&request.preset)?;
    let mut pictures = Vec::new();
    let stand = grow(&request, preset, |simulation| {
        let Some(years) = request.years else { return Ok(()) };
        if simulation.iteration().is_multiple_of(years) {
            let stand = finished(simulation, &control)?;
            pictures.push(picture(&merged(&stand, request.wall, &control)?, TILE, &control)?);
        }
        Ok(())
    })?;
    if !pictures.is_empty() {
        sheet(&pictures, pictures.len().min(4) as u32, TILE)?.save(path("years.png"))?;
        return Ok(());
    }
    let mesh = merged(&stand, request.wall, &control)?;
    write_glb(&mesh, path(&format!("{}.glb", preset.name())), &GlbOptions::default())?;
    let name = format!("{}.png", preset.name());
    picture(&mesh, View::default().width, &control)?.save_png(path(&name))?;
    for grown in &stand {
        let shed: u32 = grown.report.years.iter().map(|year| year.n_shed).sum();
        println!(
            "{}: {} skeleton nodes, {shed} shed, {} leaves",
            path(&name).display(),
            grown.tree.skeleton().len(),
            grown.tree.foliage().len(),
        );
    }
    Ok(())
}

/// Grows the stand and shows it after each iteration.
fn grow(
    request: &Request,
    preset: Preset,
    mut show: impl FnMut(&Simulation) -> Result<(), Box<dyn Error>>,
) -> Result<Vec<Grown>, Box<dyn Error>> {
    let control = Control::default();
    let params = request.params(preset)?;
    let plants = request.plants(&params);
    let mut simulation = Simulation::new(&params.world, &plants, Seed(request.seed), &control)?;
    for _ in 0..params.iterations {
        simulation.step(&control)?;
        show(&simulation)?;
    }
    finished(&simulation, &control)
}

fn finished(simulation: &Simulation, control: &Control) -> Result<Vec<Grown>, Box<dyn Error>> {
    let grown = (0..simulation.n_plants()).map(|index| Ok(simulation.grown(index, control)?));
    grown.collect()
}

/// All trees and the wall as one mesh.
fn merged(
    stand: &[Grown],
    wall_at: Option<f32>,
    control: &Control,
) -> Result<Mesh, Box<dyn Error>> {
    let mut all = Mesh::default();
    for grown in stand {
        let look = Look::built_in(grown.tree.species())?;
        let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), control)?.mesh;
        let first = all.materials.len() as u32;
        all.materials.extend(mesh.materials);
        for mut surface in mesh.surfaces {
            surface.material += first;
            // Wind and light maps are a single tree's.
            surface.branches.clear();
            surface.uvs2.clear();
            all.surfaces.push(surface);
        }
    }
    if let Some(x) = wall_at {
        let mut surface = boxed(wall(x)?.bounds());
        surface.material = all.materials.len() as u32;
        let base_color = [0.5, 0.45, 0.42, 1.0];
        all.materials.push(Material { name: "wall".into(), base_color, ..Material::default() });
        all.surfaces.push(surface);
    }
    Ok(all)
}

fn wall(x: f32) -> Result<Volume, Box<dyn Error>> {
    let [half, height] = WALL;
    let thickness = 0.3_f32.copysign(x);
    let corners = [Vec3::new(x, -0.5, -half), Vec3::new(x + thickness, height, half)];
    Ok(Volume::box_solid(corners[0].min(corners[1]), corners[0].max(corners[1]))?)
}

/// The six sides of a box.
fn boxed(bounds: Aabb) -> Surface {
    let mut surface = Surface::default();
    let (center, half) = (bounds.center(), 0.5 * bounds.size());
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let normal = sign * Vec3::AXES[axis];
            let (u, v) = (Vec3::AXES[(axis + 1) % 3], sign * Vec3::AXES[(axis + 2) % 3]);
            let first = surface.positions.len() as u32;
            for (a, b) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                surface.positions.push(center + half * (normal + a * u + b * v));
                surface.normals.push(normal);
            }
            surface.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
        }
    }
    surface
}

fn picture(mesh: &Mesh, side: u32, control: &Control) -> Result<Picture, Box<dyn Error>> {
    let camera = Camera::Framed(Framing { yaw: 0.0, ..Framing::default() });
    let view = View { width: side, height: side, camera, ..View::default() };
    Ok(preview::render(mesh, &view, &Style::default(), control)?)
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}

fn vector(name: &str, text: &str) -> Result<Vec3, String> {
    let numbers =
        text.split(',').map(|part| number(name, part)).collect::<Result<Vec<f32>, _>>()?;
    match numbers.as_slice() {
        &[x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err(format!("{name} needs three numbers with commas, not '{text}'")),
    }
}
