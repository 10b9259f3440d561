//! Table 1: strokes and elements of the eight kinds of tree, and a picture of each: the drawing, the front and the side.

use super::cases::{self, Case, KINDS, OUT};
use super::paint::{beside, save};
use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use std::fs;
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::Mesh;
use tree_model::particle::draw::Canvas;
use tree_model::silhouette::read::{Kind, Level};
use tree_model::tree_core::glam::{Vec2, Vec3};
use tree_model::tree_core::{Control, Limits};

/// Pixels of a picture from top to bottom.
const HEIGHT: u32 = 520;
/// How far one looks down on several plants, in radians.
const PITCH: f32 = 0.25;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(OUT)?;
    let made = of_each(&KINDS, Made::of)?;
    for (kind, Made { strokes, refused, elements }) in KINDS.iter().zip(made) {
        let mut row = |metric: &str, paper: Option<f64>, ours: f64, aim: Aim| {
            table.row(&Row { case: kind.name, metric, paper, peer: None, ours, unit: "", aim });
        };
        row("strokes", Some(kind.strokes), f64::from(strokes), Aim::AtMost(kind.strokes));
        row("strokes refused", None, refused as f64, Aim::AtMost(0.0));
        row("elements", Some(kind.elements), elements as f64, Aim::None);
    }
    let case = format!("pictures in {OUT}");
    let metric = "kinds of Table 1";
    let (paper, ours, aim) = (Some(8.0), KINDS.len() as f64, Aim::AtLeast(8.0));
    table.row(&Row { case: &case, metric, paper, peer: None, ours, unit: "", aim });
    Ok(())
}

/// What became of the drawing of a kind.
#[derive(Default)]
struct Made {
    strokes: u32,
    refused: usize,
    elements: u64,
}

impl Made {
    /// Makes its trees, and a picture of them.
    fn of(kind: &cases::Kind) -> Result<Self, Box<dyn Error>> {
        let case = kind.case()?;
        let mut made = Self::default();
        let mut scene = Mesh::default();
        for (session, report, at) in &case.sessions()? {
            let (grown, mesh) = cases::mesh(session)?;
            made.strokes += report.strokes;
            made.refused += report.refused.len();
            report.refused.iter().for_each(|why| eprintln!("{}: {why}", kind.name));
            made.elements += grown.report.elements();
            // Up the page is away from the viewer, as one sees it who looks down a little.
            let away = at.y / libm::sinf(PITCH);
            add(&mut scene, mesh, Vec3::new(at.x, 0.0, -away));
        }
        save(&picture(&case, &scene)?, kind.name)?;
        Ok(made)
    }
}

/// Adds a mesh to others, at a place.
fn add(scene: &mut Mesh, mesh: Mesh, at: Vec3) {
    let n_materials = scene.materials.len() as u32;
    scene.materials.extend(mesh.materials);
    for mut surface in mesh.surfaces {
        surface.material += n_materials;
        surface.branches.clear();
        surface.positions.iter_mut().for_each(|position| *position += at);
        surface.anchors.iter_mut().for_each(|anchor| *anchor += at);
        scene.surfaces.push(surface);
    }
}

fn picture(case: &Case, scene: &Mesh) -> Result<Picture, Box<dyn Error>> {
    let points = || case.trees.iter().flat_map(|tree| &tree.strokes).flat_map(|s| &s.points);
    let low = points().fold(Vec2::INFINITY, |low, &p| low.min(p));
    let high = points().fold(Vec2::NEG_INFINITY, |high, &p| high.max(p));
    let size = high - low;
    let width = (HEIGHT as f32 * (size.x / size.y).clamp(0.8, 2.2)) as u32;
    let pitch = if case.trees.len() > 1 { PITCH } else { 0.0 };
    let seen = |yaw: f32| {
        let framing = Framing { yaw, pitch, orthographic: true, ..Framing::default() };
        let view = View { width, height: HEIGHT, samples: 2, camera: Camera::Framed(framing) };
        preview::render(scene, &view, &Style::studio(), &Control::default())
    };
    let drawing = pen(case, (low, high), width)?;
    Ok(beside(&[drawing, seen(0.0)?, seen(std::f32::consts::FRAC_PI_2)?]))
}

/// The drawing: each level in its own ink.
fn pen(case: &Case, (low, high): (Vec2, Vec2), width: u32) -> Result<Picture, Box<dyn Error>> {
    const INKS: [[u8; 4]; 5] = [
        [30, 34, 60, 255],
        [60, 150, 70, 255],
        [205, 120, 40, 255],
        [60, 130, 190, 255],
        [170, 60, 150, 255],
    ];
    const MARGIN: f32 = 0.06;
    /// Radius of the pen in pixels.
    const PEN: f32 = 0.8;
    let paper = Vec2::new(width as f32, HEIGHT as f32);
    let scale = ((1.0 - 2.0 * MARGIN) * paper / (high - low)).min_element();
    let shift = 0.5 * (paper - scale * (low + high));
    let mut canvas = Canvas::blank(width, HEIGHT, [255; 4], &Limits::default())?;
    for stroke in case.trees.iter().flat_map(|tree| &tree.strokes) {
        let level = match stroke.level {
            Level::Number(level) => (level as usize).min(INKS.len() - 2),
            Level::Leaf => INKS.len() - 1,
        };
        let mut line: Vec<Vec2> = stroke.points.iter().map(|&p| scale * p + shift).collect();
        if let (Kind::Outline, Some(&first)) = (stroke.kind, line.first()) {
            line.push(first);
        }
        for pair in line.windows(2) {
            canvas.line(pair[0], pair[1], PEN, INKS[level]);
        }
    }
    let pixels = canvas.finish()?.pixels().concat();
    Ok(Picture { width, height: HEIGHT, pixels })
}
