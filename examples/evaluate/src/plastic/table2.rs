//! Table 2: how long a transformation takes beside growing the tree anew, and a wall that moves through a forest.

use super::{Outcome, growth};
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use std::sync::Arc;
use std::time::Instant;
use tree_core::glam::Vec3;
use tree_core::{Control, Skeleton, Species, Tree, Volume};
use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};

/// Age, nodes, growth and transforms in milliseconds, as printed.
const PRINTED: [(u32, f64, f64, f64); 3] =
    [(10, 530.0, 216.3, 3.82), (20, 2541.0, 8855.6, 50.5), (30, 9134.0, 61_843.9, 222.8)];

/// Trees of each age.
const N_TREES: u64 = 20;

/// Places of the wall.
const PLACES: u32 = 8;

/// The rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    for (years, nodes, grown, printed) in PRINTED {
        let case = format!("Table 2: {years} years");
        let (growth_s, trees) = fastest(1, || growth::trees(years, N_TREES))?;
        let growth_ms = 1e3 * growth_s / N_TREES as f64;
        let mean = trees.iter().map(Skeleton::len).sum::<usize>() as f64 / N_TREES as f64;
        let times = trees.iter().map(|tree| transform(tree, years)).collect::<Outcome<Vec<_>>>()?;
        let ours = times.iter().sum::<f64>() / times.len() as f64;
        let row = |metric, paper, ours, unit, aim| Row {
            case: &case,
            metric,
            paper: Some(paper),
            peer: None,
            ours,
            unit,
            aim,
        };
        table.row(&row("nodes, all in the graph", nodes, mean, "nodes", Aim::AtLeast(nodes)));
        table.row(&row(
            "transformation, a wall moved",
            printed,
            ours,
            "ms",
            Aim::AtMost(printed / 50.0),
        ));
        table.row(&row(
            "growth / transformation",
            grown / printed,
            growth_ms / ours,
            "times",
            Aim::None,
        ));
    }
    forest(table)
}

fn model(skeleton: &Skeleton, years: u32) -> Outcome<Arc<PlasticTree>> {
    let tree = Tree::bare(skeleton.clone(), Species::default());
    let params = PlasticParams { main: 0.0, seasons: years, ..PlasticParams::default() };
    Ok(Arc::new(PlasticTree::new(tree, &params, &Control::default())?))
}

fn wall(size: Vec3) -> Outcome<Volume> {
    let reach = 0.5 * size.x.max(size.z);
    Ok(Volume::box_solid(
        Vec3::new(-0.1, 0.0, -2.0 * reach),
        Vec3::new(0.1, 1.2 * size.y, 2.0 * reach),
    )?)
}

/// Milliseconds for one place of the wall: the mean over a walk towards the trunk, the best of three walks.
fn transform(skeleton: &Skeleton, years: u32) -> Outcome<f64> {
    let control = Control::default();
    let size = skeleton.bounds().size();
    let reach = 0.5 * size.x.max(size.z);
    let mut scene = Scene::new(Sky::default(), Response::default())?;
    scene.add_tree(model(skeleton, years)?, Pose::default())?;
    let id = scene.add_obstacle(wall(size)?, Pose::at(Vec3::X * (3.0 * reach)))?;
    scene.update(&control)?;
    let mut best = f64::INFINITY;
    for _ in 0..3 {
        let mut total = 0.0;
        for place in 0..PLACES {
            let at = reach * (1.5 - 1.2 * place as f32 / PLACES as f32);
            scene.move_obstacle(id, Pose::at(Vec3::X * at))?;
            let start = Instant::now();
            scene.update(&control)?;
            total += start.elapsed().as_secs_f64();
        }
        best = best.min(1e3 * total / f64::from(PLACES));
    }
    Ok(best)
}

/// A wall that moves among 100 trees of 2500 nodes.
fn forest(table: &mut Table) -> Outcome {
    let control = Control::default();
    let trees = growth::trees(20, 8)?;
    let models = trees.iter().map(|tree| model(tree, 20)).collect::<Outcome<Vec<_>>>()?;
    let size = trees[0].bounds().size();
    let reach = 0.5 * size.x.max(size.z);
    for (case, spacing) in
        [("100 trees, crowns apart", 2.6 * reach), ("100 trees, crowns touch", 1.7 * reach)]
    {
        let mut scene = Scene::new(Sky::default(), Response::default())?;
        for k in 0..100 {
            let at = Vec3::new((k % 10) as f32, 0.0, (k / 10) as f32) * spacing;
            scene.add_tree(models[k % models.len()].clone(), Pose::at(at))?;
        }
        let nodes = (0..100).map(|k| trees[k % trees.len()].len()).sum::<usize>() as f64 / 100.0;
        let home = |k: u32| Vec3::new(4.3 + 0.05 * k as f32, 0.0, 4.5) * spacing;
        let id = scene.add_obstacle(wall(size)?, Pose::at(home(0)))?;
        let start = Instant::now();
        scene.update(&control)?;
        let first = 1e3 * start.elapsed().as_secs_f64();
        let (mut times, mut touched) = (Vec::new(), 0.0);
        for k in 1..=8 {
            scene.move_obstacle(id, Pose::at(home(k)))?;
            let start = Instant::now();
            touched += f64::from(scene.update(&control)?.touched) / 8.0;
            times.push(1e3 * start.elapsed().as_secs_f64());
        }
        times.sort_by(f64::total_cmp);
        let row = |metric, ours, unit, aim| Row {
            case,
            metric,
            paper: None,
            peer: None,
            ours,
            unit,
            aim,
        };
        table.row(&row("nodes of a tree", nodes, "nodes", Aim::AtLeast(2500.0)));
        table.row(&row("all trees, first time", first, "ms", Aim::None));
        table.row(&row("trees looked at when it moves", touched, "trees", Aim::None));
        table.row(&row(
            "update when it moves, median",
            times[times.len() / 2],
            "ms",
            Aim::AtMost(16.0),
        ));
    }
    Ok(())
}
