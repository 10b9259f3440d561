//! The posterior: that no step lowers it, and how near the result is to the best there is.

use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use std::error::Error;
use tree_model::sketch::infer::{FactorGraph, InferParams, Inferred, STEEPEST, infer};
use tree_model::sketch::template::{
    EXEMPLAR_SEED, EXEMPLARS, MainBranchParams, Template, main_branches,
};
use tree_model::sketch::{Label, Omega, Plan};
use tree_model::tree_core::glam::Vec2;
use tree_model::tree_core::{Control, NO_PARENT, Seed, seed};

/// Small sketches of each template, and segments of each.
const SMALL: u64 = 1;
const SEGMENTS: usize = 6;
/// Slopes at which each segment is tried; the best combinations are then refined.
const SLOPES: [f64; 9] = [-1.73, -1.2, -0.75, -0.35, 0.0, 0.35, 0.75, 1.2, 1.73];
const REFINED: usize = 40;
/// Rounding of a sum of hundreds of logarithms.
const ROUNDING: f64 = 1e-9;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    falls(table)?;
    for (case, params) in [
        ("six segments, as by default", InferParams::default()),
        ("six segments, the thesis' factors", InferParams { beam: 64, ..InferParams::thesis() }),
    ] {
        let params = InferParams { keep_omega: true, ..params };
        let mut cases = Vec::new();
        for (number, template) in Template::builtin()?.iter().enumerate() {
            cases.extend((0..SMALL).map(|small| (template, Seed(1000 * number as u64 + small))));
        }
        let short = |(template, seed): (&Template, Seed)| {
            let short =
                small_plan(seed).and_then(|plan| shortfall(&plan, &template.omega, &params, seed));
            short.map_err(|error| error.to_string())
        };
        let short: Vec<f64> = cases.into_par_iter().map(short).collect::<Result<_, _>>()?;
        let worst = short.into_iter().fold(0.0, f64::max);
        let metric = "posterior below the best";
        table.row(&Row {
            case,
            metric,
            paper: None,
            peer: None,
            ours: 100.0 * worst,
            unit: "%, worst",
            aim: Aim::AtMost(1.0),
        });
    }
    Ok(())
}

/// How often the posterior falls over all steps, on drawings of all exemplars.
fn falls(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let of_all = of_each(&EXEMPLARS, |exemplar| {
        let (mut n_falls, mut n_steps) = (0, 0);
        let tree = exemplar.tree(EXEMPLAR_SEED, &control)?;
        let branches = main_branches(tree.skeleton(), &MainBranchParams::default())?;
        let template = Template::find(exemplar.name())?;
        for (view, params) in
            [InferParams::default(), InferParams::thesis()].into_iter().enumerate()
        {
            let plan = super::round_trip::plan_of(&branches, 0.4 + view as f32)?;
            let inferred: Inferred = infer(&plan, &template.omega, &params, Seed(7), &control)?;
            let totals: Vec<f64> = inferred.trace.iter().map(|row| row.posterior.total()).collect();
            n_falls += totals
                .windows(2)
                .filter(|pair| pair[1] < pair[0] - ROUNDING * pair[0].abs())
                .count();
            n_steps += totals.len();
        }
        Ok((n_falls, n_steps))
    })?;
    let (n_falls, n_steps) =
        of_all.into_iter().fold((0, 0), |sum, found| (sum.0 + found.0, sum.1 + found.1));
    let case = format!("{n_steps} steps of ICM and EM on all exemplars");
    let metric = "falls of the posterior";
    table.row(&Row {
        case: &case,
        metric,
        paper: None,
        peer: None,
        ours: n_falls as f64,
        unit: "",
        aim: Aim::AtMost(0.0),
    });
    Ok(())
}

/// A sketch of six segments: a root branch, a fork of two or three, and another.
fn small_plan(seed: Seed) -> Result<Plan, Box<dyn Error>> {
    let mut rng = seed.stream("small").rng();
    let mut positions = vec![Vec2::ZERO, Vec2::Y];
    let (mut parents, mut strokes) = (vec![NO_PARENT, 0], vec![0, 0]);
    let mut tips = vec![1_u32];
    while positions.len() <= SEGMENTS {
        let tip = tips.remove(0) as usize;
        let left = SEGMENTS + 1 - positions.len();
        let children = if left == 3 { 3 } else { 2.min(left) };
        let along = positions[tip] - positions[parents[tip] as usize];
        for child in 0..children {
            let turn = if child == 0 {
                seed::uniform(&mut rng, -0.3, 0.3)
            } else {
                seed::uniform(&mut rng, 0.3, 1.2)
            };
            let side = if child == 2 { -1.0 } else { 1.0 };
            let length = seed::uniform(&mut rng, 0.4, 1.1);
            positions.push(positions[tip] + length * Vec2::from_angle(side * turn).rotate(along));
            parents.push(tip as u32);
            strokes.push(if child == 0 { strokes[tip] } else { positions.len() as u32 });
            tips.push(positions.len() as u32 - 1);
        }
    }
    Ok(Plan::from_columns(positions, parents, strokes, Vec2::ZERO, 1.0)?)
}

/// How much less likely what is inferred is than the best found by trying everything, as a share.
fn shortfall(
    plan: &Plan,
    omega: &Omega,
    params: &InferParams,
    seed: Seed,
) -> Result<f64, Box<dyn Error>> {
    let control = Control::default();
    let ours = infer(plan, omega, params, seed, &control)?.posterior.total();
    let graph = FactorGraph::new(plan, omega, params, seed, &control)?;
    let search = Search { graph: &graph, omega };
    let best = search.best()?;
    Ok(1.0 - libm::exp((ours - best).min(0.0)))
}

/// A search over all depths, in steps and then refined, and all labels.
struct Search<'a> {
    graph: &'a FactorGraph,
    omega: &'a Omega,
}

impl Search<'_> {
    /// The posterior; none for depths that inference does not take.
    fn value(&self, depths: &[f64], labels: &[Label]) -> Result<f64, Box<dyn Error>> {
        let steep = |i: usize| {
            let rise = depths[i] - depths[self.graph.parents()[i] as usize];
            rise.abs() > STEEPEST * self.graph.length(i) * (1.0 + 1e-9)
        };
        if (1..depths.len()).any(steep) {
            return Ok(f64::NEG_INFINITY);
        }
        Ok(self.graph.posterior(self.omega, depths, labels)?.total())
    }

    fn best(&self) -> Result<f64, Box<dyn Error>> {
        let n = self.graph.parents().len();
        let mut top: Vec<(f64, Vec<f64>, Vec<Label>)> = Vec::new();
        for labels in self.ways_to_label() {
            let (mut places, mut depths) = (vec![0; n], vec![0.0; n]);
            loop {
                for i in 1..n {
                    let below = depths[self.graph.parents()[i] as usize];
                    depths[i] = below + SLOPES[places[i]] * self.graph.length(i);
                }
                let value = self.value(&depths, &labels)?;
                let at = top.partition_point(|known| known.0 > value);
                if at < REFINED {
                    top.insert(at, (value, depths.clone(), labels.clone()));
                    top.truncate(REFINED);
                }
                let Some(next) = (1..n).find(|&i| places[i] + 1 < SLOPES.len()) else { break };
                places[1..next].fill(0);
                places[next] += 1;
            }
        }
        let mut best = f64::NEG_INFINITY;
        for (_, depths, labels) in top {
            best = best.max(self.refined(depths, &labels)?);
        }
        Ok(best)
    }

    /// Every way to give the children of each fork different labels.
    fn ways_to_label(&self) -> Vec<Vec<Label>> {
        let parents = self.graph.parents();
        let mut ways = vec![vec![Label::Apical; parents.len()]];
        for parent in 0..parents.len() as u32 {
            let children: Vec<usize> =
                (0..parents.len()).filter(|&i| parents[i] == parent).collect();
            ways = ways.iter().flat_map(|way| orders(&children, way)).collect();
        }
        ways
    }

    /// Raises the posterior one depth after the other, by steps that end at a millionth.
    fn refined(&self, mut depths: Vec<f64>, labels: &[Label]) -> Result<f64, Box<dyn Error>> {
        let mut best = self.value(&depths, labels)?;
        let mut step = 0.2;
        while step > 1e-6 {
            let before = best;
            for i in 1..depths.len() {
                for way in [step, -step] {
                    depths[i] += way;
                    let value = self.value(&depths, labels)?;
                    if value > best {
                        best = value;
                        break;
                    }
                    depths[i] -= way;
                }
            }
            if best <= before {
                step *= 0.5;
            }
        }
        Ok(best)
    }
}

/// The labellings that differ from `way` in who of `children` has which label.
fn orders(children: &[usize], way: &[Label]) -> Vec<Vec<Label>> {
    let label =
        |place: usize| if place == 0 { Label::Apical } else { Label::Lateral(place as u16 - 1) };
    let mut out = vec![way.to_vec()];
    let mut taken: Vec<Vec<usize>> = vec![Vec::new()];
    for &child in children {
        let (mut next, mut used) = (Vec::new(), Vec::new());
        for (way, taken) in out.iter().zip(&taken) {
            for place in (0..children.len()).filter(|place| !taken.contains(place)) {
                let mut way = way.clone();
                way[child] = label(place);
                next.push(way);
                used.push([taken.as_slice(), &[place]].concat());
            }
        }
        (out, taken) = (next, used);
    }
    out
}
