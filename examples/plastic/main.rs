//! Trees that react (Pirk et al. 2012): a wall approaches, two trees meet, the sun turns.
//!
//! `cargo run --release --example plastic -- [PRESET|FILE.swc|FILE.glb] [--scene wall|pair|sun] [--frames N] [--distance METRES]
//! [--species NAME] [--colors] [--regrow] [--out FOLDER]`
//!
//! Writes a picture a frame, `NAME_SCENE_000.png` and so on, the trees of the last frame as `NAME_SCENE.glb`, and with more than one
//! frame the whole act as `NAME_SCENE_moving.glb`, which every viewer of glTF plays. With `--colors` the main branches are drawn
//! instead of the tree: red as they bend, blue what is pruned (the paper's Fig. 6). With `--regrow` the first tree of the last
//! frame grows new branches where it lost old ones and there is light: `NAME_SCENE_regrown.png` and `.glb`.

mod arguments;
mod draw;
mod film;

use arguments::{Act, Request};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Volume};
use tree_lod::preview::{self, Style};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_model::plastic::{
    ObstacleId, PlasticParams, PlasticTree, Pose, Regrowth, Response, Scene, Sky, TreeId,
};

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
        .map_err(|error| format!("{error}\nusage: {}", arguments::USAGE))?;
    let control = Control::default();
    let (tree, name) = request.tree(&control)?;
    let started = Instant::now();
    let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control)?);
    let report = model.report();
    println!(
        "{name}: {} main nodes, {} that follow, {} seasons of internodes {:.2} m long, {} leaf clusters; read in {:.1} ms",
        report.n_main_nodes,
        report.n_branchlet_nodes,
        report.n_seasons,
        report.internode,
        report.n_clusters,
        1e3 * started.elapsed().as_secs_f64()
    );
    if report.already_bent {
        println!(
            "warning: the crown leans by {:.0} degrees: a tree that was bent before it came keeps its lean",
            report.lean.to_degrees()
        );
    }
    let mut stage = Stage::new(model, &request)?;
    std::fs::create_dir_all(&request.out)
        .map_err(|error| format!("cannot make folder {}: {error}", request.out.display()))?;
    let act = request.act.name();
    let mut film = film::Film::new(&stage.scene, &stage.trees, stage.wall, &control)?;
    for frame in 0..request.frames {
        let progress =
            if request.frames > 1 { frame as f32 / (request.frames - 1) as f32 } else { 1.0 };
        stage.set(progress)?;
        let started = Instant::now();
        stage.scene.update(&control)?;
        let took = 1e3 * started.elapsed().as_secs_f64();
        film.take(&stage.scene, stage.at)?;
        let mesh = draw::frame(&stage.scene, &stage.trees, stage.wall(), request.colors, &control)?;
        let path = request.out.join(format!("{name}_{act}_{frame:03}.png"));
        preview::render(&mesh, &stage.view, &Style::default(), &control)?.save_png(&path)?;
        let adapted = stage.scene.adapted(stage.trees[0], &control)?.report;
        println!(
            "{}: updated in {took:.2} ms; {} nodes pruned, farthest moved {:.2} m",
            path.display(),
            adapted.n_pruned,
            adapted.farthest
        );
        if frame + 1 == request.frames {
            write_glb(
                &mesh,
                request.out.join(format!("{name}_{act}.glb")),
                &GlbOptions::default(),
            )?;
        }
    }
    if request.frames > 1 {
        let path = request.out.join(format!("{name}_{act}_moving.glb"));
        film.write(&path)?;
        println!("{}: {} frames", path.display(), request.frames);
    }
    if request.regrow {
        regrow(&stage, &request.out.join(format!("{name}_{act}_regrown")), &control)?;
    }
    Ok(())
}

/// Lets the first tree grow new branches, and draws it.
fn regrow(stage: &Stage, path: &Path, control: &Control) -> Result<(), Box<dyn Error>> {
    let id = stage.trees[0];
    let params = Regrowth::of(stage.scene.model(id)?);
    let new = stage.scene.regrown(id, &params, Seed(1), control)?;
    let mut mesh = draw::leafy(&new.tree, control)?;
    if let Some((low, high)) = stage.wall() {
        draw::append(&mut mesh, draw::block(low, high), |point| point);
    }
    let picture = path.with_extension("png");
    preview::render(&mesh, &stage.view, &Style::default(), control)?.save_png(&picture)?;
    write_glb(&mesh, path.with_extension("glb"), &GlbOptions::default())?;
    println!(
        "{}: {} new branches with {} nodes; {} of {} stumps have light and room",
        picture.display(),
        new.branches.len(),
        new.tree.skeleton().len() - new.n_adapted as usize,
        new.n_open,
        new.n_stumps
    );
    Ok(())
}

/// The scene, and what moves in it.
struct Stage {
    scene: Scene,
    trees: Vec<TreeId>,
    moving: Option<ObstacleId>,
    act: Act,
    /// Size of the tree, in metres.
    size: Vec3,
    /// Where what approaches ends.
    near: f32,
    wall: Option<(Vec3, Vec3)>,
    at: f32,
    view: preview::View,
}

impl Stage {
    fn new(model: Arc<PlasticTree>, request: &Request) -> Result<Self, Box<dyn Error>> {
        let mut scene = Scene::new(Sky::default(), Response::default())?;
        let size = model.tree().skeleton().bounds().size();
        let reach = 0.5 * size.x.max(size.z);
        let mut trees = vec![scene.add_tree(model.clone(), Pose::default())?];
        let (mut moving, mut wall) = (None, None);
        match request.act {
            Act::Wall => {
                let half = Vec3::new(0.1, 0.6 * size.y, 1.4 * reach.max(0.3 * size.y));
                let low = Vec3::new(-half.x, 0.0, -half.z);
                let high = Vec3::new(half.x, 2.0 * half.y, half.z);
                let volume = Volume::box_solid(low, high)?;
                moving = Some(scene.add_obstacle(volume, Pose::at(Vec3::X * 100.0 * reach))?);
                wall = Some((low, high));
            }
            Act::Pair => {
                trees.push(scene.add_tree(model, Pose::at(Vec3::X * 100.0 * reach))?);
            }
            Act::Sun => {}
        }
        let near = request.distance.unwrap_or(match request.act {
            Act::Pair => 0.7 * reach,
            _ => 0.25 * reach,
        });
        let view = draw::view(size, request.act == Act::Pair);
        Ok(Self { scene, trees, moving, act: request.act, size, near, wall, at: 0.0, view })
    }

    /// Sets the scene for `progress` 0 to 1.
    fn set(&mut self, progress: f32) -> Result<(), Box<dyn Error>> {
        let reach = 0.5 * self.size.x.max(self.size.z);
        let far = 2.2 * reach;
        self.at = far + (self.near - far) * progress;
        let pose = Pose::at(Vec3::X * self.at);
        match (self.act, self.moving) {
            (Act::Wall, Some(wall)) => self.scene.move_obstacle(wall, pose)?,
            (Act::Pair, _) => self.scene.move_tree(self.trees[1], pose)?,
            _ => {
                let elevation = std::f32::consts::FRAC_PI_2 * (1.0 - 0.8 * progress);
                self.scene.set_sky(Sky::towards(std::f32::consts::FRAC_PI_2, elevation))?;
            }
        }
        Ok(())
    }

    /// The wall where it stands now.
    fn wall(&self) -> Option<(Vec3, Vec3)> {
        self.wall.map(|(low, high)| (low + Vec3::X * self.at, high + Vec3::X * self.at))
    }
}
