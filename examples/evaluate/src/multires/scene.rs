//! From grammars to everything that is drawn of a scene of 1024 trees.

use super::model::{self, Model, paper_species};
use super::{Outcome, SEED, information};
use crate::measure::{fastest, of_each};
use crate::table::{Aim, Row, Table};
use tree_core::glam::{Mat4, Vec3};
use tree_core::{Control, Seed};
use tree_mesh::Look;
use tree_model::lsystem::{LSystem, Preset};

/// Trees of the scene, on a square.
const SIDE: u32 = 32;
/// Models that they are placed from.
const PRESETS: [&str; 8] =
    ["oak", "birch", "spruce", "willow", "palm", "honda-a", "aono-kunii-a", "ternary-a"];
/// Seconds that the paper takes for "more than a thousand trees" (section 5), and what we want of it.
const PAPER_SECONDS: f64 = 8.0;
const SPEEDUP: f64 = 20.0;
/// Trees that are all different.
const DIFFERENT: u32 = 128;
/// Metres between trees.
const SPACING: f32 = 6.0;
/// Runs, of which the fastest counts.
const RUNS: u32 = 3;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let n = SIDE * SIDE;
    let looks: Vec<Look> = PRESETS.iter().map(|name| look(name)).collect::<Outcome<_>>()?;
    let paper_look = without_bark(Look::built_in(&paper_species())?);
    let (seconds, _) = fastest(RUNS, || -> Outcome<_> {
        let seeds: Vec<u64> = (0..PRESETS.len() as u64).collect();
        let models = of_each(&seeds, |&i| Model::new(&of_paper(i)?, &paper_look))?;
        Ok((models, placed(n)))
    })?;
    let case = format!("scene, {n} trees of 8 with the paper's counts");
    built(table, &case, seconds);
    let (seconds, _) = fastest(RUNS, || -> Outcome<_> {
        let rows: Vec<_> = PRESETS.iter().zip(&looks).collect();
        let models = of_each(&rows, |(name, look)| Model::new(&of_preset(name, 0)?, look))?;
        Ok((models, placed(n)))
    })?;
    let case = format!("scene, {n} trees of 8 presets");
    built(table, &case, seconds);
    parts(table, &paper_look)?;
    // Each tree another seed; pictures of leaves are shared.
    let numbers: Vec<u64> = (0..u64::from(DIFFERENT)).collect();
    let (seconds, _) = fastest(1, || {
        of_each(&numbers, |&i| Ok(Model::bare(&of_paper(i)?, &paper_look)?.multires.n_levels()))
    })?;
    let case = format!("scene of {DIFFERENT} different trees");
    let a_tree = |seconds: f64| 1e3 * seconds / f64::from(DIFFERENT);
    information(table, &case, "each, with the paper's counts", a_tree(seconds), "ms");
    let (seconds, _) = fastest(1, || {
        of_each(&numbers, |&i| {
            let preset = i as usize % PRESETS.len();
            let model = Model::bare(&of_preset(PRESETS[preset], i)?, &looks[preset])?;
            Ok(model.multires.n_levels())
        })
    })?;
    information(table, &case, "each, of 8 presets", a_tree(seconds), "ms");
    Ok(())
}

/// What the time of one tree with the paper's counts is made of.
fn parts(table: &mut Table, look: &Look) -> Outcome {
    let case = "one tree with the paper's counts";
    let mut row =
        |metric: &str, seconds: f64| information(table, case, metric, 1e3 * seconds, "ms");
    let (seconds, tree) = fastest(RUNS, || of_paper(0))?;
    row("text, derivation, turtle", seconds);
    let (seconds, model) = fastest(RUNS, || Model::bare(&tree, look))?;
    row("levels and mesh", seconds);
    let (seconds, _) = fastest(RUNS, || model.multires_again(&tree))?;
    row("levels", seconds);
    let (seconds, _) = fastest(RUNS, || model.boxes(model::BOXES))?;
    row("boxes", seconds);
    let (seconds, _) = fastest(RUNS, || model.baked(model::BOXES))?;
    row("boxes and pictures", seconds);
    Ok(())
}

fn built(table: &mut Table, case: &str, seconds: f64) {
    table.row(&Row {
        case,
        metric: "text to drawable",
        paper: Some(PAPER_SECONDS),
        peer: None,
        ours: seconds,
        unit: "s",
        aim: Aim::AtMost(PAPER_SECONDS / SPEEDUP),
    });
}

fn of_paper(number: u64) -> Outcome<tree_core::Tree> {
    model::of_paper(seed(number))
}

fn of_preset(name: &str, number: u64) -> Outcome<tree_core::Tree> {
    Ok(LSystem::preset(name)?.grow(seed(number), &Control::default())?.tree)
}

fn seed(number: u64) -> Seed {
    SEED.stream("scene").child(number)
}

/// Textures come from files in a real scene: they are not timed.
fn look(name: &str) -> Outcome<Look> {
    Ok(without_bark(Look::built_in(&Preset::find(name)?.system()?.species)?))
}

/// The picture of the bark is the engine's; pictures of leaves need not read it.
fn without_bark(mut look: Look) -> Look {
    look.bark.texture = None;
    look
}

/// Where the trees of a scene stand: a grid, shaken; turned and scaled at random. With the model of each.
pub(super) fn placed(n: u32) -> Vec<(u32, Mat4)> {
    let side = (n as f32).sqrt().ceil() as u32;
    let seed = SEED.stream("places");
    let place = |i: u32| {
        let any = |k: u64| seed.child(u64::from(i)).unit(k);
        let cell = Vec3::new((i % side) as f32, 0.0, (i / side) as f32) - 0.5 * (side - 1) as f32;
        let shaken = cell + 0.6 * Vec3::new(any(0) - 0.5, 0.0, any(1) - 0.5);
        let turn = Mat4::from_rotation_y(std::f32::consts::TAU * any(2));
        let scale = Mat4::from_scale(Vec3::splat(0.8 + 0.4 * any(3)));
        let foot = Mat4::from_translation((SPACING * shaken).with_y(0.0));
        ((PRESETS.len() as f32 * any(4)) as u32, foot * turn * scale)
    };
    (0..n).map(place).collect()
}
