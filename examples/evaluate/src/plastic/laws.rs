//! What must hold of every adaptation: undone bending, the open, obstacles that go away, and ages.

use super::Outcome;
use crate::table::{Aim, Row, Table};
use std::sync::Arc;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Tree, Volume};
use tree_model::growth::Preset;
use tree_model::lsystem::LSystem;
use tree_model::path;
use tree_model::plastic::{
    PlasticParams, PlasticTree, Pose, Response, Scene, Sky, Tropisms, bend, unbend,
};

/// The rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    tropisms(table);
    for (name, tree) in inputs()? {
        laws(table, name, tree)?;
    }
    ages(table)
}

fn row(table: &mut Table, case: &str, metric: &str, ours: f64, unit: &str, aim: Aim) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
}

/// Eq. 8 and 9, then Eq. 6.
fn tropisms(table: &mut Table) {
    let mut rng = Seed(9).rng();
    let mut way = || tree_core::seed::unit_vector(&mut rng);
    let mut worst = 0.0_f32;
    for k in 0..100_000 {
        let tropisms =
            Tropisms { photo: 0.01 * (k % 60) as f32, gravi: 0.01 * (k % 30) as f32 - 0.1 };
        let (seen, light) = (way(), way());
        let weight = tropisms.own_weight(0.02 * (k % 200) as f32, 1.0);
        let tropism = tropisms.combined(light, Vec3::Y);
        let back = bend(unbend(seen, weight, tropism), weight, tropism).normalize();
        worst = worst.max(back.distance(seen));
    }
    row(
        table,
        "100,000 segments unbent and bent again",
        "largest difference",
        worst.into(),
        "",
        Aim::AtMost(1e-4),
    );
}

/// Trees of every kind.
fn inputs() -> Outcome<Vec<(&'static str, Tree)>> {
    let control = Control::default();
    Ok(vec![
        ("an oak of paths", path::Preset::find("oak")?.params()?.grow(Seed(1), &control)?.tree),
        ("a birch of a grammar", LSystem::preset("birch")?.grow(Seed(1), &control)?.tree),
        ("a palm of a grammar", LSystem::preset("palm")?.grow(Seed(1), &control)?.tree),
        ("a grown pine", Preset::find("pine")?.params().grow(Seed(1), &control)?.tree),
    ])
}

/// Nodes that differ between a tree in the scene and another.
fn different(a: &Tree, b: &Tree) -> f64 {
    let (a, b) = (a.skeleton(), b.skeleton());
    let same = a.positions().iter().zip(b.positions()).filter(|(a, b)| a == b).count();
    (a.len().max(b.len()) - same) as f64
}

fn laws(table: &mut Table, name: &str, tree: Tree) -> Outcome {
    let control = Control::default();
    let size = tree.skeleton().bounds().size();
    let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control)?);
    let mut scene = Scene::new(Sky::default(), Response::default())?;
    let id = scene.add_tree(model.clone(), Pose::default())?;
    scene.update(&control)?;
    let alone = scene.adapted(id, &control)?.tree;
    row(
        table,
        name,
        "alone: nodes that differ",
        different(&alone, model.tree()),
        "nodes",
        Aim::AtMost(0.0),
    );
    let wall =
        Volume::box_solid(Vec3::new(-0.1, 0.0, -size.z), Vec3::new(0.1, 1.2 * size.y, size.z))?;
    let wall = scene.add_obstacle(wall, Pose::at(Vec3::X * (0.3 * size.x)))?;
    scene.update(&control)?;
    let beside = scene.adapted(id, &control)?;
    row(
        table,
        name,
        "beside a wall: main nodes pruned",
        beside.report.n_pruned.into(),
        "nodes",
        Aim::AtLeast(1.0),
    );
    row(table, name, "farthest moved", beside.report.farthest.into(), "m", Aim::None);
    scene.move_obstacle(wall, Pose::at(Vec3::X * 1e4))?;
    scene.update(&control)?;
    let back = scene.adapted(id, &control)?.tree;
    row(
        table,
        name,
        "wall gone: nodes that differ",
        different(&back, model.tree()),
        "nodes",
        Aim::AtMost(0.0),
    );
    Ok(())
}

/// Estimated seasons against the years in which a grown tree's segments were made: rank correlation.
fn ages(table: &mut Table) -> Outcome {
    let control = Control::default();
    for name in ["oak", "birch", "pine"] {
        let mut params = Preset::find(name)?.params();
        params.habit.leaves = None;
        let grown = params.grow(Seed(1), &control)?;
        // Ages count back from today.
        let made: Vec<f64> = grown.ages.iter().map(|&age| -f64::from(age)).collect();
        let plastic = PlasticParams { main: 0.0, ..PlasticParams::default() };
        let model = PlasticTree::new(grown.tree, &plastic, &control)?;
        let found: Vec<f64> = model.seasons().iter().map(|&season| f64::from(season)).collect();
        let case = format!("seasons of a grown {name}");
        row(
            table,
            &case,
            "rank correlation with the years",
            correlation(&ranks(&made), &ranks(&found)),
            "",
            Aim::None,
        );
    }
    Ok(())
}

/// Ranks, ties sharing their mean.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    for group in order.chunk_by(|&a, &b| values[a] == values[b]) {
        let mean = start as f64 + (group.len() - 1) as f64 / 2.0;
        group.iter().for_each(|&index| ranks[index] = mean);
        start += group.len();
    }
    ranks
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len() as f64;
    let mean = |v: &[f64]| v.iter().sum::<f64>() / n;
    let (ma, mb) = (mean(a), mean(b));
    let sum = |f: &dyn Fn(f64, f64) -> f64| {
        a.iter().zip(b).map(|(&x, &y)| f(x - ma, y - mb)).sum::<f64>()
    };
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}
