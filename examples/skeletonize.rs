//! A mesh of a tree becomes a skeleton and leaves, and is drawn beside what was made of it.
//!
//! `cargo run --release --example skeletonize -- MESH.glb|MESH.obj [--out tree.swc]
//! [--picture tree.png] [--wood-only]`

use std::error::Error;
use std::process::ExitCode;
use tree_core::{Control, swc};
use tree_lod::preview::{self, Picture, Style, View};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{Alpha, ErrorBound, Look, Mesh, MeshParams};
use tree_model::skeletonize::{Hint, Part, SkeletonizeParams, Skeletonized, skeletonize};

const USAGE: &str = "skeletonize MESH.glb|MESH.obj [--out tree.swc] [--picture tree.png] \
                     [--wood-only]";

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
    let (mut input, mut out, mut picture, mut leaves) = (None, None, None, true);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--out" => out = Some(value()?),
            "--picture" => picture = Some(value()?),
            "--wood-only" => leaves = false,
            _ if input.is_none() && !argument.starts_with("--") => input = Some(argument),
            _ => return Err(format!("unknown argument '{argument}'\nusage: {USAGE}").into()),
        }
    }
    let input = input.ok_or(format!("usage: {USAGE}"))?;
    let control = Control::default();
    let mesh = io::read(&input, &ImportOptions { external: true }, &control)?.mesh;

    let params = SkeletonizeParams { leaves, ..Default::default() };
    let start = std::time::Instant::now();
    let made = skeletonize(&parts(&mesh), &params, &control)?;
    let skeleton = made.tree.skeleton();
    println!(
        "{input}: {:.0} ms, {} nodes, {} tips, {:.3} high, trunk radius {:.4}\n  {:?}",
        1e3 * start.elapsed().as_secs_f64(),
        skeleton.len(),
        skeleton.tip_counts()[0],
        skeleton.bounds().size().y,
        skeleton.radii()[0],
        made.report,
    );
    if let Some(path) = out {
        swc::write_file(path.as_ref(), skeleton, &swc::SwcOptions::default())?;
    }
    if let Some(path) = picture {
        beside(&draw(&mesh, &control)?, &draw(&mesh_of(&made, &control)?, &control)?)
            .save_png(&path)?;
    }
    Ok(())
}

/// What the modeler asks for, borrowed from a mesh.
fn parts(mesh: &Mesh) -> Vec<Part<'_>> {
    mesh.surfaces
        .iter()
        .map(|surface| {
            let material = mesh.materials.get(surface.material as usize);
            Part {
                positions: &surface.positions,
                uvs: &surface.uvs,
                indices: &surface.indices,
                name: material.map_or("", |material| &material.name),
                hint: Hint::Auto,
                alpha_masked: material.is_some_and(|m| matches!(m.alpha, Alpha::Mask(_))),
                double_sided: material.is_some_and(|m| m.double_sided),
            }
        })
        .collect()
}

/// The tree as this library draws it.
fn mesh_of(made: &Skeletonized, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    let tree = &made.tree;
    // Lengths in the parameters are metres; the mesh may have any unit.
    let size = tree.skeleton().bounds().size().max_element();
    let params = MeshParams {
        flare: 0.0,
        error: ErrorBound::Metres((3e-4 * size).clamp(1e-5, 1.0)),
        radius_min: (5e-5 * size).clamp(1e-5, 0.1),
        ..Default::default()
    };
    let mut look = Look::plain(tree.species());
    for (leaf, &width) in look.leaves.iter_mut().zip(&made.report.leaf_widths) {
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
