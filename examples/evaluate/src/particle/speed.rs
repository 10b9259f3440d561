//! Times: particles, density, and the whole way from photographs to leaves.

use super::pictures::{Behind, compose, known_matte, known_tree, paint, trimap};
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use std::f32::consts::FRAC_PI_2;
use tree_core::{Control, Seed};
use tree_mesh::Mesh;
use tree_model::ModelError;
use tree_model::particle::density::{DensityParams, carve, solve};
use tree_model::particle::flow::{FlowParams, FlowReport};
use tree_model::particle::matting::{NaturalParams, Trimap, natural};
use tree_model::particle::session::{PhotoParams, Session, Shot, Stage};
use tree_model::particle::{Matte, Photo};

/// What the issue asks for.
const FLOW_MILLISECONDS: f64 = 50.0;
const FLOW_STEPS: u32 = 200;
const TENFOLD: f64 = 15.0;
const DENSITY_SECONDS: f64 = 0.5;
const WHOLE_SECONDS: f64 = 4.0;
/// "5–10 seconds for 1000–2000 particles" (3.6).
const PAPER_MILLISECONDS: f64 = 5000.0;
/// Voxels along the height, and sides of the pictures, in which the density is asked for.
const DENSITY_VOXELS: u32 = 64;
const DENSITY_PIXELS: f32 = 1024.0;
/// Side of a picture of a megapixel.
const MEGAPIXEL: f32 = 1000.0;
/// A join distance at which particles mostly stay apart, and a step with which they need a few more than
/// [`FLOW_STEPS`].
const APART: f32 = 5e-4;
const SHORT_STEP: f32 = 0.0072;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let mesh = known_tree()?;
    flow(table, &mesh)?;
    density(table, &mesh)?;
    whole(table, &mesh)
}

fn flow(table: &mut Table, mesh: &Mesh) -> Result<(), Box<dyn Error>> {
    let default = FlowParams { steps: FLOW_STEPS, ..FlowParams::default() };
    // The tolerance is a share of the join distance; so it stays as it is.
    let tolerance = (default.tolerance * default.join / APART).min(1.0);
    let apart = FlowParams { join: APART, step: SHORT_STEP, tolerance, ..default.clone() };
    let shots = shots(mesh, 512.0)?;
    for (name, params) in [("as by default", default), ("that stay apart", apart)] {
        let mut times = Vec::new();
        for particles in [2000, 20_000] {
            let (seconds, report) = flow_time(&shots, &FlowParams { particles, ..params.clone() })?;
            let case = format!("{particles} particles {name}");
            let mut row = |metric, paper, ours, unit, aim| {
                table.row(&Row { case: &case, metric, paper, peer: None, ours, unit, aim });
            };
            let first = times.is_empty();
            let aim = if first { Aim::AtMost(FLOW_MILLISECONDS) } else { Aim::None };
            let paper = first.then_some(PAPER_MILLISECONDS);
            row("simulation", paper, 1e3 * seconds, "ms", aim);
            let all = first && params.join == APART;
            let aim = if all { Aim::AtLeast(f64::from(FLOW_STEPS)) } else { Aim::None };
            row("steps taken", None, f64::from(report.n_steps), "", aim);
            row("Runge-Kutta parts", None, report.n_parts as f64, "", Aim::None);
            let joined = f64::from(report.n_joins + report.n_followed) / f64::from(particles);
            row("joined before the base", None, 100.0 * joined, "%", Aim::None);
            times.push(seconds);
        }
        if let [small, large] = times[..] {
            let case = format!("20000 to 2000 particles {name}");
            let (metric, ours, aim) = ("time, ratio", large / small, Aim::AtMost(TENFOLD));
            let unit = "×";
            table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit, aim });
        }
    }
    Ok(())
}

/// Seconds for the simulation alone, density and fields being there.
fn flow_time(shots: &[Shot], flow: &FlowParams) -> Result<(f64, FlowReport), Box<dyn Error>> {
    let control = Control::default();
    let params = PhotoParams { flow: flow.clone(), ..PhotoParams::default() };
    let mut session = Session::new(shots.to_vec(), params, Seed(1))?;
    session.traces(&control)?;
    let (seconds, ()) = fastest(5, || {
        session.redo_from(Stage::Flow);
        session.traces(&control).map(drop)
    })?;
    Ok((seconds, session.tree(&control)?.report.flow))
}

fn density(table: &mut Table, mesh: &Mesh) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let shots = shots(mesh, DENSITY_PIXELS)?;
    let mut session = Session::new(shots, PhotoParams::default(), Seed(1))?;
    let views = session.views(&control)?;
    let params = DensityParams { resolution: DENSITY_VOXELS, ..DensityParams::default() };
    let (ours, _) = fastest(3, || {
        let carved = carve(views, &params, &control)?;
        solve(&carved, views, &params, &control)
    })?;
    let case = "density of 64 voxels' height from two 1024²";
    let (metric, unit, aim) = ("carve and solve", "s", Aim::AtMost(DENSITY_SECONDS));
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    Ok(())
}

/// A known tree from two sides.
fn mattes(mesh: &Mesh, pixels: f32) -> Result<[Matte; 2], Box<dyn Error>> {
    Ok([known_matte(mesh, 0.0, pixels)?, known_matte(mesh, FRAC_PI_2, pixels)?])
}

fn shots(mesh: &Mesh, pixels: f32) -> Result<Vec<Shot>, Box<dyn Error>> {
    let [front, side] = mattes(mesh, pixels)?;
    Ok(vec![Shot::new(front, None, 0.0), Shot::new(side, None, FRAC_PI_2)])
}

fn whole(table: &mut Table, mesh: &Mesh) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let [front, side] = mattes(mesh, MEGAPIXEL)?;
    let front = (compose(&paint(&front)?, Behind::Sky)?, trimap(&front)?);
    let side = (compose(&paint(&side)?, Behind::Hedge)?, trimap(&side)?);
    let cut_out = |(photo, trimap): &(Photo, Trimap)| {
        natural(photo, trimap, &NaturalParams::default(), &control).map(|(matte, _)| matte)
    };
    let run = || {
        let (a, b) = rayon::join(|| cut_out(&front), || cut_out(&side));
        let shots = vec![
            Shot::new(a?, Some(front.0.clone()), 0.0),
            Shot::new(b?, Some(side.0.clone()), FRAC_PI_2),
        ];
        let mut session = Session::new(shots, PhotoParams::default(), Seed(1))?;
        let tree = &session.tree(&control)?.tree;
        Ok::<_, ModelError>((tree.skeleton().len(), tree.foliage().len()))
    };
    let (seconds, (nodes, leaves)) = fastest(3, run)?;
    let case = "two photographs of 1 megapixel, trimaps";
    for (metric, ours, unit, aim) in [
        ("all the way to leaves", seconds, "s", Aim::AtMost(WHOLE_SECONDS)),
        ("nodes", nodes as f64, "", Aim::None),
        ("leaves", leaves as f64, "", Aim::AtLeast(1.0)),
    ] {
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    }
    Ok(())
}
