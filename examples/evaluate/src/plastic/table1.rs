//! Table 1: trees grown beside a wall (G) and trees grown in the open (O) that were transformed (T), by edit distance.
//!
//! Fifty pairs of each group, no tree twice in one; seeds 0, 1, 2, …, none left out. A group does not differ from another
//! where a two-tailed t-test (Welch) says so.

use super::{Outcome, growth};
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use std::sync::Arc;
use tree_core::distance::{EditParams, EditTree, distance_of};
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Skeleton, Volume};
use tree_model::growth::{GrowthParams, Tropisms, World};
use tree_model::path::Obstacle;
use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};

/// Pairs of a group.
const PAIRS: u64 = 50;

/// A kind of tree: weights of its tropisms, its age, printed means of the groups T-G, G-G, T-O, T-T.
struct Kind {
    name: &'static str,
    photo: f32,
    gravi: f32,
    years: u32,
    shedding: f32,
    printed: [f64; 4],
}

const KINDS: [Kind; 3] = [
    Kind {
        name: "type 1",
        photo: 0.25,
        gravi: 0.12,
        years: 12,
        shedding: 1.0,
        printed: [236.29, 229.65, 347.19, 225.38],
    },
    Kind {
        name: "type 2",
        photo: 0.45,
        gravi: 0.44,
        years: 18,
        shedding: 0.6,
        printed: [431.73, 396.81, 471.63, 413.64],
    },
    Kind {
        name: "type 3",
        photo: 0.03,
        gravi: 0.23,
        years: 16,
        shedding: 0.6,
        printed: [756.27, 841.79, 927.64, 550.63],
    },
];

/// The rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    KINDS.iter().try_for_each(|kind| compare(table, kind))
}

impl Kind {
    fn params(&self) -> Outcome<GrowthParams> {
        let mut params = growth::params(self.years)?;
        params.habit.vigour = 2.15;
        let tropisms = Tropisms { photo: self.photo, gravi: self.gravi, ..params.habit.branches };
        params.habit.branches = tropisms;
        params.habit.trunk = Tropisms { plagio: 0.0, ..tropisms };
        params.habit.shedding *= self.shedding;
        Ok(params)
    }

    /// Grown in the open, or beside the wall.
    fn grow(&self, seed: u64, wall: Option<&Volume>) -> Outcome<Skeleton> {
        let mut params = self.params()?;
        if let Some(wall) = wall {
            params.world = World {
                obstacle: Some(Obstacle { volume: wall.clone(), clearance: 0.0 }),
                ..params.world
            };
        }
        Ok(params.grow(Seed(seed), &Control::default())?.tree.skeleton().clone())
    }

    /// Transformed by the wall.
    fn transform(&self, open: &Skeleton, wall: &Volume) -> Outcome<Skeleton> {
        let control = Control::default();
        let tree = tree_core::Tree::bare(open.clone(), tree_core::Species::default());
        let params = PlasticParams {
            main: 0.0,
            phototropism: self.photo,
            gravitropism: self.gravi,
            ..PlasticParams::default()
        };
        let mut scene = Scene::new(Sky::default(), Response::default())?;
        let model = Arc::new(PlasticTree::new(tree, &params, &control)?);
        let id = scene.add_tree(model, Pose::default())?;
        scene.add_obstacle(wall.clone(), Pose::default())?;
        scene.update(&control)?;
        Ok(scene.adapted(id, &control)?.tree.skeleton().clone())
    }
}

fn compare(table: &mut Table, kind: &Kind) -> Outcome {
    let size = kind.grow(u64::MAX, None)?.bounds().size();
    let reach = 0.5 * size.x.max(size.z);
    let near = 0.35 * reach;
    let wall = Volume::box_solid(
        Vec3::new(near, 0.0, -4.0 * reach),
        Vec3::new(near + 0.3, 1.5 * size.y, 4.0 * reach),
    )?;
    let n = 2 * PAIRS;
    let failed = |error: Box<dyn std::error::Error>| error.to_string();
    // G and O from their own seeds; T from O's that are not compared with themselves.
    let grow = |first: u64, wall: Option<&Volume>| -> Result<Vec<Skeleton>, String> {
        (first..first + n)
            .into_par_iter()
            .map(|seed| kind.grow(seed, wall).map_err(failed))
            .collect()
    };
    let open = grow(0, None)?;
    let beside = grow(n, Some(&wall))?;
    let others = grow(2 * n, None)?;
    let transformed: Vec<Skeleton> = others
        .par_iter()
        .map(|tree| kind.transform(tree, &wall).map_err(failed))
        .collect::<Result<_, String>>()?;
    let edit = |trees: &[Skeleton]| -> Vec<EditTree> {
        trees.iter().map(|tree| EditTree::of(tree, &EditParams::default())).collect()
    };
    let (o, g, t) = (edit(&open), edit(&beside), edit(&transformed));
    let group = |pairs: Vec<(&EditTree, &EditTree)>| -> Result<Vec<f64>, String> {
        pairs
            .into_par_iter()
            .map(|(a, b)| {
                distance_of(a, b, false, &Control::default())
                    .map(|d| d.value)
                    .map_err(|e| e.to_string())
            })
            .collect()
    };
    let half = PAIRS as usize;
    let t_g = group(t[..half].iter().zip(&g[..half]).collect())?;
    let g_g = group(g[..half].iter().zip(&g[half..]).collect())?;
    let t_o = group(t[..half].iter().zip(&o[..half]).collect())?;
    let t_t = group(t[..half].iter().zip(&t[half..]).collect())?;
    let o_o = group(o[..half].iter().zip(&o[half..]).collect())?;
    let mut row = |metric: &str, paper, ours, unit: &str, aim| {
        table.row(&Row { case: kind.name, metric, paper, peer: None, ours, unit, aim });
    };
    let nodes = |trees: &[Skeleton]| {
        trees.iter().map(Skeleton::len).sum::<usize>() as f64 / trees.len() as f64
    };
    row("nodes, open", None, nodes(&open), "nodes", Aim::None);
    row("nodes, grown beside the wall", None, nodes(&beside), "nodes", Aim::None);
    row("nodes, transformed", None, nodes(&transformed), "nodes", Aim::None);
    for (metric, values, printed) in [
        ("T-G", &t_g, Some(0)),
        ("G-G", &g_g, Some(1)),
        ("T-O", &t_o, Some(2)),
        ("T-T", &t_t, Some(3)),
        ("O-O", &o_o, None),
    ] {
        row(
            &format!("{metric}, mean"),
            printed.map(|k: usize| kind.printed[k]),
            mean(values),
            "",
            Aim::None,
        );
    }
    row("p, T-G against G-G", None, welch(&t_g, &g_g), "", Aim::AtLeast(0.05));
    row("p, T-O against T-T", None, welch(&t_o, &t_t), "", Aim::AtMost(0.001));
    Ok(())
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Two-tailed p-value of Welch's t-test.
fn welch(a: &[f64], b: &[f64]) -> f64 {
    let spread = |values: &[f64]| {
        let m = mean(values);
        let n = values.len() as f64;
        values.iter().map(|v| (v - m) * (v - m)).sum::<f64>() / (n - 1.0) / n
    };
    let (va, vb) = (spread(a), spread(b));
    let t = (mean(a) - mean(b)) / (va + vb).sqrt();
    let (na, nb) = (a.len() as f64 - 1.0, b.len() as f64 - 1.0);
    let freedom = (va + vb) * (va + vb) / (va * va / na + vb * vb / nb);
    // Both tails of Student's distribution: an incomplete beta function.
    beta(freedom / (freedom + t * t), 0.5 * freedom, 0.5)
}

/// Regularised incomplete beta function by its integral, in steps of equal angle: smooth, so a few thousand are exact to 1e-9.
fn beta(x: f64, a: f64, b: f64) -> f64 {
    // With s = sin² u the integrand is 2 sin^(2a-1) cos^(2b-1), which has no poles for a, b of at least one half.
    let power = |u: f64| {
        2.0 * libm::pow(libm::sin(u), 2.0 * a - 1.0) * libm::pow(libm::cos(u), 2.0 * b - 1.0)
    };
    let integral = |to: f64| {
        let steps = 4000;
        let h = to / f64::from(steps);
        (0..steps).map(|k| power((f64::from(k) + 0.5) * h)).sum::<f64>() * h
    };
    integral(libm::asin(x.clamp(0.0, 1.0).sqrt())) / integral(std::f64::consts::FRAC_PI_2)
}
