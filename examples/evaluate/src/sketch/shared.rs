//! The drawings of the shared data: a tree of each, and a picture of the sketch, the front and the side.

use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use tree_lod::preview::{self, Camera, Framing, Style, View};
use tree_mesh::{Look, MeshParams};
use tree_model::particle::Photo;
use tree_model::particle::draw::Canvas;
use tree_model::sketch::session::{Session, SketchParams};
use tree_model::sketch::{Drawing, Role, read};
use tree_model::tree_core::glam::Vec2;
use tree_model::tree_core::{Control, Limits, Seed, file};

/// Pixels along the side of each of the three pictures.
const SIDE: u32 = 320;
/// Radius of a pen stroke in pixels.
const PEN: f32 = 1.5;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/sketches");
    if !folder.is_dir() {
        eprintln!("no drawings: {} is not there", folder.display());
        return Ok(());
    }
    let out = PathBuf::from("out/sketches");
    fs::create_dir_all(&out)?;
    let drawings = drawings(&folder)?;
    let (mut made, mut through) = (0, 0);
    let pictures =
        of_each(&drawings, |(_, drawing)| Ok(picture(drawing).map_err(|error| error.to_string())))?;
    for ((name, _), picture) in drawings.iter().zip(pictures) {
        match picture {
            Ok((picture, crossings)) => {
                picture.save_png(out.join(format!("{name}.png")))?;
                through += crossings;
                made += 1;
            }
            Err(error) => eprintln!("{name}: {error}"),
        }
    }
    let case = format!("{} drawings, pictures in {}", drawings.len(), out.display());
    let mut row = |metric: &str, ours: f64, aim| {
        table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit: "", aim });
    };
    row("trees made", f64::from(made), Aim::AtLeast(drawings.len() as f64));
    row("crossings without room", f64::from(through), Aim::None);
    Ok(())
}

/// All drawings of a folder by name, in the order of names.
fn drawings(folder: &Path) -> Result<Vec<(String, Drawing)>, Box<dyn Error>> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    paths.sort();
    let mut out = Vec::new();
    for path in paths {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = || file::read_text(&path, &Limits::default());
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("svg") => out.push((name, read::from_svg(&text()?)?)),
            Some("ndjson") => {
                let lines = read::from_ndjson(&text()?)?;
                out.extend(
                    lines
                        .into_iter()
                        .enumerate()
                        .map(|(line, drawing)| (format!("{name}_{}", line + 1), drawing)),
                );
            }
            _ => {}
        }
    }
    Ok(out)
}

/// The sketch, the front and the side, beside each other; and how many crossings were left without room.
fn picture(drawing: &Drawing) -> Result<(Photo, u32), Box<dyn Error>> {
    let control = Control::default();
    let mut session = Session::new(drawing.clone(), SketchParams::default(), Seed(1))?;
    let made = session.tree(&control)?.clone();
    let look = Look::built_in(made.tree.species())?;
    let mesh = tree_mesh::build(&made.tree, &look, &MeshParams::default(), &control)?.mesh;
    let seen = |yaw: f32| {
        let camera =
            Camera::Framed(Framing { yaw, pitch: 0.0, orthographic: true, ..Framing::default() });
        let view = View { width: SIDE, height: SIDE, samples: 2, camera };
        preview::render(&mesh, &view, &Style::studio(), &control)
    };
    let parts = [pen(drawing)?, seen(0.0)?.pixels, seen(std::f32::consts::FRAC_PI_2)?.pixels];
    let mut out = Vec::with_capacity((3 * SIDE * SIDE * 4) as usize);
    for y in 0..SIDE as usize {
        for part in &parts {
            let row = 4 * SIDE as usize;
            out.extend_from_slice(&part[y * row..(y + 1) * row]);
        }
    }
    let pixels = out.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect();
    Ok((Photo::new(3 * SIDE, SIDE, pixels)?, made.report.interpenetrations))
}

/// The drawing in black, crowns in green.
fn pen(drawing: &Drawing) -> Result<Vec<u8>, Box<dyn Error>> {
    const MARGIN: f32 = 0.06;
    let good = |point: &&Vec2| point.is_finite();
    let points = || drawing.strokes.iter().flat_map(|stroke| stroke.points.iter().filter(good));
    let low = points().fold(Vec2::INFINITY, |low, &point| low.min(point));
    let high = points().fold(Vec2::NEG_INFINITY, |high, &point| high.max(point));
    let scale = SIDE as f32 * (1.0 - 2.0 * MARGIN) / (high - low).max_element().max(1e-6);
    let shift = 0.5 * (SIDE as f32 - scale * (low + high));
    let mut canvas = Canvas::blank(SIDE, SIDE, [255; 4], &Limits::default())?;
    for stroke in &drawing.strokes {
        let mut line: Vec<Vec2> =
            stroke.points.iter().filter(good).map(|&point| point * scale + shift).collect();
        if let (true, Some(&first)) = (stroke.closed, line.first()) {
            line.push(first);
        }
        let color =
            if stroke.role == Some(Role::Crown) { [60, 140, 60, 255] } else { [40, 30, 20, 255] };
        for pair in line.windows(2) {
            canvas.line(pair[0], pair[1], PEN, color);
        }
    }
    Ok(canvas.finish()?.pixels().concat())
}
