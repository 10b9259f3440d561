//! A mesh of a tree becomes a skeleton and leaves, a laser scan becomes a skeleton; drawn beside what was
//! made of it.
//!
//! `cargo run --release --example skeletonize -- MESH.glb|MESH.obj|CLOUD.ply|CLOUD.xyz [--out tree.swc]
//! [--glb tree.glb] [--picture tree.png] [--wood-only] [--several] [--y-up]`
//!
//! `--wood-only` leaves out leaves, and in scans the branches that run through foliage; `--several` makes a
//! tree of every trunk in a scan (files are numbered); `--y-up` is for scans whose y axis points up.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tree_core::glam::DVec3;
use tree_core::{Control, Foliage, Skeleton, Species, Tree, UpAxis, swc};
use tree_lod::preview::{self, Picture, Style, View};
use tree_mesh::io::{self, ImportOptions, points};
use tree_mesh::{ErrorBound, Look, Mesh, MeshError, MeshParams};
use tree_model::skeletonize::{ScanParams, SkeletonizeParams, skeletonize, skeletonize_scan};

const USAGE: &str = "skeletonize MESH.glb|MESH.obj|CLOUD.ply|CLOUD.xyz [--out tree.swc] \
                     [--glb tree.glb] [--picture tree.png] [--wood-only] [--several] [--y-up]";

/// What is asked for.
#[derive(Default)]
struct Options {
    input: String,
    out: Option<String>,
    glb: Option<String>,
    picture: Option<String>,
    wood_only: bool,
    several: bool,
    y_up: bool,
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
    let mut arguments = std::env::args().skip(1);
    let mut options = Options::default();
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--out" => options.out = Some(value()?),
            "--glb" => options.glb = Some(value()?),
            "--picture" => options.picture = Some(value()?),
            "--wood-only" => options.wood_only = true,
            "--several" => options.several = true,
            "--y-up" => options.y_up = true,
            _ if options.input.is_empty() && !argument.starts_with("--") => {
                options.input = argument;
            }
            _ => return Err(format!("unknown argument '{argument}'\nusage: {USAGE}").into()),
        }
    }
    if options.input.is_empty() {
        return Err(format!("usage: {USAGE}").into());
    }
    let control = Control::default();
    let extension = Path::new(&options.input).extension().unwrap_or_default().to_string_lossy();
    match extension.to_lowercase().as_str() {
        "xyz" | "txt" | "csv" | "asc" | "pts" => scan(&options, &control),
        // A PLY file without faces is a scan.
        "ply" => match io::read(&options.input, &ImportOptions::default(), &control) {
            Ok(read) => mesh(&options, &read.mesh, &control),
            Err(MeshError::Malformed { .. }) => scan(&options, &control),
            Err(error) => Err(error.into()),
        },
        _ => {
            let read = io::read(&options.input, &ImportOptions { external: true }, &control)?;
            mesh(&options, &read.mesh, &control)
        }
    }
}

fn mesh(options: &Options, mesh: &Mesh, control: &Control) -> Result<(), Box<dyn Error>> {
    let params = SkeletonizeParams { leaves: !options.wood_only, ..Default::default() };
    let start = std::time::Instant::now();
    let made = skeletonize(&mesh.parts(), &params, control)?;
    let skeleton = made.tree.skeleton();
    println!(
        "{}: {:.0} ms, {} nodes, {} tips, {:.3} high, trunk radius {:.4}\n  {:?}",
        options.input,
        1e3 * start.elapsed().as_secs_f64(),
        skeleton.len(),
        skeleton.tip_counts()[0],
        skeleton.bounds().size().y,
        skeleton.radii()[0],
        made.report,
    );
    let tree_mesh = mesh_of(&made.tree, &made.report.leaf_widths, control)?;
    save(options, None, skeleton, &tree_mesh)?;
    if let Some(path) = &options.picture {
        beside(&draw(mesh, control)?, &draw(&tree_mesh, control)?).save_png(path)?;
    }
    Ok(())
}

fn scan(options: &Options, control: &Control) -> Result<(), Box<dyn Error>> {
    let cloud = points::read(&options.input, control)?.positions;
    let params = ScanParams {
        up: if options.y_up { UpAxis::Y } else { UpAxis::Z },
        several: options.several,
        foliage: !options.wood_only,
        ..Default::default()
    };
    let start = std::time::Instant::now();
    let made = skeletonize_scan(&cloud, &params, control)?;
    let report = &made.report;
    println!(
        "{}: {:.0} ms, {} trees of {} points ({} not finite, {} doubles, {} thinned, {} ground, {} left \
         out), {} bridges of {:.2} m in all, {} nodes ({} by circles, {} in foliage)",
        options.input,
        1e3 * start.elapsed().as_secs_f64(),
        made.trees.len(),
        report.n_points,
        report.n_not_finite,
        report.n_doubles,
        report.n_thinned,
        report.n_ground,
        report.n_left_out,
        report.bridges.len(),
        report.bridges.iter().map(|bridge| bridge.length).sum::<f32>(),
        report.n_nodes,
        report.n_fitted,
        report.n_in_foliage,
    );
    let mut all = Mesh::default();
    for (number, tree) in made.trees.iter().enumerate() {
        let skeleton = &tree.skeleton;
        println!(
            "  base at {:.3}: {} nodes, {:.1} m of wood, {:.2} m high, trunk radius {:.3} m",
            tree.base,
            skeleton.len(),
            skeleton.segment_lengths().iter().sum::<f32>(),
            skeleton.bounds().size().y,
            skeleton.radii()[0],
        );
        let bare = Tree::new(skeleton.clone(), Foliage::default(), species())?;
        let mut mesh = mesh_of(&bare, &[], control)?;
        save(options, (made.trees.len() > 1).then_some(number), skeleton, &mesh)?;
        let away = tree.base - made.trees[0].base;
        let up = if options.y_up { away } else { DVec3::new(away.x, away.z, -away.y) };
        for mut surface in mesh.surfaces.drain(..) {
            surface.positions.iter_mut().for_each(|p| *p += up.as_vec3());
            surface.material += all.materials.len() as u32;
            // Wind is a single tree's.
            surface.branches.clear();
            all.surfaces.push(surface);
        }
        all.materials.append(&mut mesh.materials);
    }
    if let Some(path) = &options.picture {
        draw(&all, control)?.save_png(path)?;
    }
    Ok(())
}

/// Of a scan only the wood is known.
fn species() -> Species {
    Species { name: "scan".into(), bark: "bark".into(), leaf_kinds: Vec::new() }
}

/// Writes what was asked for, under a number where there are several trees.
fn save(
    options: &Options,
    number: Option<usize>,
    skeleton: &Skeleton,
    mesh: &Mesh,
) -> Result<(), Box<dyn Error>> {
    let numbered = |path: &String| match number {
        Some(number) => {
            let path = Path::new(path);
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            let extension = path.extension().unwrap_or_default().to_string_lossy();
            path.with_file_name(format!("{stem}_{number}.{extension}"))
        }
        None => PathBuf::from(path),
    };
    if let Some(path) = &options.out {
        swc::write_file(&numbered(path), skeleton, &swc::SwcOptions::default())?;
    }
    if let Some(path) = &options.glb {
        io::gltf::write_glb(mesh, numbered(path), &io::gltf::GlbOptions::default())?;
    }
    Ok(())
}

/// The tree as this library draws it.
fn mesh_of(tree: &Tree, leaf_widths: &[f32], control: &Control) -> Result<Mesh, Box<dyn Error>> {
    // Lengths in the parameters are metres; the mesh may have any unit.
    let size = tree.skeleton().bounds().size().max_element();
    let params = MeshParams {
        flare: 0.0,
        error: ErrorBound::Metres((3e-4 * size).clamp(1e-5, 1.0)),
        min_radius: (5e-5 * size).clamp(1e-5, 0.1),
        ..Default::default()
    };
    let mut look = Look::plain(tree.species());
    for (leaf, &width) in look.leaves.iter_mut().zip(leaf_widths) {
        leaf.width = width.clamp(0.05, 20.0);
    }
    Ok(tree_mesh::build(tree, &look, &params, control)?.mesh)
}

fn draw(mesh: &Mesh, control: &Control) -> Result<Picture, Box<dyn Error>> {
    let view = View { width: 700, height: 900, ..Default::default() };
    Ok(preview::render(mesh, &view, &Style::studio(), control)?)
}

/// Two pictures of one height side by side.
fn beside(left: &Picture, right: &Picture) -> Picture {
    let rows = |p: &Picture| -> Vec<Vec<u8>> {
        p.pixels.chunks_exact(4 * p.width as usize).map(<[u8]>::to_vec).collect()
    };
    let pixels = rows(left).into_iter().zip(rows(right)).flat_map(|(a, b)| [a, b].concat());
    Picture {
        width: left.width + right.width,
        height: left.height.min(right.height),
        pixels: pixels.collect(),
    }
}
