//! The scene of 5000 trees (Fig. 7.18): vertices drawn at the quality of Cook, and what a frame of selection
//! and a large model's tables take.

use super::models::{self, Model};
use super::pruned::{Pruned, fine_enough};
use super::scene::{FOV, Forest, LARGE, LARGE_VERTICES};
use super::{Outcome, SEED, SPACING, information};
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use std::f32::consts::TAU;
use std::time::Instant;
use tree_core::Control;
use tree_core::glam::camera::rh::{
    proj::directx::perspective_infinite_reverse, view::look_at_mat4,
};
use tree_core::glam::{Quat, Vec3};
use tree_lod::implicit;
use tree_lod::order::{CoverageParams, OrderParams, coverage, stochastic};
use tree_lod::outline::{OutlineParams, tiers};
use tree_lod::preview::Pose;
use tree_lod::prune::{PruneParams, PrunedModel, plan};
use tree_lod::quality::{Distance, Scale, Subject, Table as Measured, TableParams};
use tree_lod::select::{
    DrawIndexed, Eye, Frame, Instance, InstanceLod, Model as Selectable, Occluder, Occlusion,
    Scene, SceneParams, Selected, State,
};
use tree_lod::{Elements, Grain, LeafSurfaces};

/// Vertices drawn per frame that the issue allows.
const DRAWN_MAX: f64 = 26e6;
/// Triangles of the model whose tables are timed.
const TRIANGLES: f64 = 500_000.0;
/// Rows of the tables below the library's own: far trees of the scene are good enough with less.
const LEAST: [f32; 4] = [0.001, 0.002, 0.0035, 0.006];
/// Times that a frame is selected again, from the same state: the fastest counts, for it is the least disturbed.
const AGAIN: u32 = 3;
/// Levels of a model.
const LEVELS: usize = 64;
/// Sample points of a model.
const SAMPLES: usize = 32;
/// Width to height of the picture, as in 1600 × 1200.
const ASPECT: f32 = 4.0 / 3.0;
/// Views of the whole scene.
const OVERVIEWS: u32 = 24;

/// Instances, the milliseconds that the issue allows for a frame of selection, and frames of the path.
const SCENES: [(u32, f64, u32); 2] = [(LARGE, 0.5, 600), (100_000, 8.0, 200)];

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    tables(table)?;
    let models = models::large()?;
    let pruned = models.iter().map(prune).collect::<Outcome<Vec<_>>>()?;
    vertices(table, &models, &pruned)?;
    for (n, limit, frames) in SCENES {
        selection(table, &pruned, n, limit, frames)?;
    }
    Ok(())
}

/// Views and rows of the tables of large models.
fn params(model: &Model) -> (CoverageParams, TableParams) {
    let n = model.elements.n_triangles();
    (CoverageParams::for_triangles(n), TableParams::for_triangles(n))
}

struct Large<'a> {
    ours: Pruned<'a>,
    cook: Measured,
    hull: Vec<Vec3>,
}

fn prune(model: &Model) -> Outcome<Large<'_>> {
    let (order, mut rows) = params(model);
    rows.lambdas.splice(..0, LEAST);
    let ours = Pruned::ours_with(model, &order, &rows)?;
    let order = stochastic(&model.elements, SEED);
    let cook = TableParams { scale: Scale::Cook, ..rows };
    let cook = Pruned::ordered_with(model, model.elements.clone(), order, &cook)?.table;
    let params = OrderParams::default();
    let field = params.field(&model.elements)?;
    let hull = implicit::surface(&field, &params.hull, &Control::default())?;
    let hull = hull.sample(SAMPLES, SEED).iter().map(|sample| sample.position).collect();
    Ok(Large { ours, cook, hull })
}

/// Time of everything that a model of half a million triangles needs.
fn tables(table: &mut Table) -> Outcome {
    let model = models::half_million()?;
    let (mesh, control) = (&model.mesh, Control::default());
    let n = model.elements.n_triangles();
    let case = "a model of half a million triangles";
    table.row(&Row {
        case,
        metric: "leaf triangles",
        paper: None,
        peer: None,
        ours: n as f64,
        unit: "triangles",
        aim: Aim::AtLeast(TRIANGLES),
    });
    let (order_params, table_params) = params(&model);
    let before = processor_seconds();
    let (t_elements, elements) =
        fastest(1, || Elements::of_mesh(mesh, &LeafSurfaces::Found, Grain::Blade, &control))?;
    let (t_tiers, tiers) =
        fastest(1, || tiers(mesh, &elements, &OutlineParams::default(), &control))?;
    let fine = fine_enough(&tiers, elements.len());
    let (t_order, ranking) =
        fastest(1, || coverage(mesh, &elements, fine, &order_params, &control))?;
    let subject =
        Subject { mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
    let (t_plan, kept) = fastest(1, || plan(&subject, &control))?;
    let subject = Subject { kept: &kept, ..subject };
    let (t_table, _) = fastest(1, || Measured::measure(&subject, &table_params, &control))?;
    let after = processor_seconds();
    let mut row = |metric, ours, aim| {
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit: "s", aim });
    };
    row("time of elements", t_elements, Aim::None);
    row("time of outlines", t_tiers, Aim::None);
    row("time of the order", t_order, Aim::None);
    row("time of the plan", t_plan, Aim::None);
    row("time of the table", t_table, Aim::None);
    let others = t_elements + t_tiers + t_plan + t_table;
    row("time without the order", others, Aim::None);
    row("time of all", others + t_order, Aim::AtMost(5.0));
    if let (Some(before), Some(after)) = (before, after) {
        row("processor time of all", after - before, Aim::None);
    }
    Ok(())
}

/// Seconds of all threads of this process, where Linux tells: they do not depend on what else the machine does.
fn processor_seconds() -> Option<f64> {
    /// Ticks a second.
    const TICKS: f64 = 100.0;
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program may hold spaces; user and system time are fields 14 and 15.
    let mut fields = stat.rsplit(')').next()?.split_whitespace().skip(11);
    let mut field = || fields.next()?.parse::<f64>().ok();
    Some((field()? + field()?) / TICKS)
}

/// The model as a scene sees it.
fn selectable(large: &Large<'_>, distance: Distance, far: f32) -> Outcome<Selectable> {
    let Pruned { elements, table, .. } = &large.ours;
    let (params, control) = (PruneParams::default(), Control::default());
    let pruned = PrunedModel::new(&large.ours.subject(), table.clone(), &params, &control)?;
    let model = pruned.to_select_model(LEVELS, distance)?;
    Ok(Selectable {
        samples: large.hull.clone(),
        occluders: occluders(elements),
        near: 0.0,
        far,
        ..model
    })
}

/// The distance at which Cook's rule draws nothing any more, as in Table 7.4: a scene multiplies distances by
/// how narrow the view is, against 60°.
fn far(forest: &Forest) -> f32 {
    forest.far() * libm::tanf(0.5 * FOV) / libm::tanf(TAU / 12.0)
}

/// The inner crown: one standard deviation of the leaves along each axis, less than half its size.
fn occluders(elements: &Elements) -> Vec<Occluder> {
    let n = elements.len() as f32;
    let center = elements.centers.iter().sum::<Vec3>() / n;
    let squares = elements.centers.iter().map(|&p| (p - center) * (p - center)).sum::<Vec3>() / n;
    let radii = squares.to_array().map(f32::sqrt).into();
    vec![Occluder { center, radii }]
}

fn scene(forest: &Forest, models: &[Selectable]) -> Outcome<Scene> {
    let instance = |tree: &super::scene::Instance| Instance {
        model: tree.model,
        position: tree.position,
        rotation: Quat::from_rotation_y(tree.yaw),
        scale: tree.scale,
    };
    let instances: Vec<Instance> = forest.instances.iter().map(instance).collect();
    Ok(Scene::new(models, &instances, &Control::default())?)
}

fn eye(pose: &Pose) -> Eye {
    Eye {
        view: look_at_mat4(pose.eye, pose.target, pose.up),
        projection: perspective_infinite_reverse(FOV, ASPECT, 0.1),
    }
}

/// Vertices of the leaves that are drawn in views of the whole scene, ours against Cook.
fn vertices(table: &mut Table, models: &[Model], pruned: &[Large<'_>]) -> Outcome {
    let forest = Forest::new(LARGE, models.len() as u32, SPACING, SEED)?;
    let full: u64 =
        forest.instances.iter().map(|i| models[i.model as usize].mesh.n_vertices() as u64).sum();
    let case = "scene of 5000 trees";
    table.row(&Row {
        case,
        metric: "vertices of full models",
        paper: Some(LARGE_VERTICES as f64),
        peer: None,
        ours: full as f64,
        unit: "vertices",
        aim: Aim::AtLeast(LARGE_VERTICES as f64),
    });
    let counts = pruned.iter().map(Counts::new).collect::<Outcome<Vec<_>>>()?;
    let leaves: f64 = forest.instances.iter().map(|i| counts[i.model as usize].full).sum();
    information(table, case, "leaf vertices of full models", leaves, "vertices");
    let parity = |large: &Large<'_>| Distance::parity(&large.ours.table, &large.cook);
    let drawn =
        |distance: &dyn Fn(&Large<'_>) -> Distance, cook: bool, occlusion: Occlusion<'_>| {
            drawn(&forest, pruned, &counts, distance, cook, occlusion)
        };
    let cook = drawn(&|_| Distance::cook(), true, Occlusion::None)?;
    let open = drawn(&parity, false, Occlusion::None)?;
    let hidden = drawn(&parity, false, Occlusion::BuiltIn)?;
    let mut row = |metric, paper, peer, ours, aim| {
        table.row(&Row { case, metric, paper, peer, ours, unit: "vertices", aim });
    };
    row("leaf vertices a frame, no occlusion", None, Some(cook.leaves), open.leaves, Aim::None);
    row(
        "leaf vertices a frame",
        Some(26e6),
        Some(cook.leaves),
        hidden.leaves,
        Aim::AtMost(DRAWN_MAX),
    );
    row("leaf indices a frame", None, Some(cook.indices), hidden.indices, Aim::None);
    row("vertices of wood, always whole", None, None, hidden.wood, Aim::None);
    information(table, case, "mean λ of ours", hidden.lambda, "");
    information(table, case, "mean λ of Cook", cook.lambda, "");
    Ok(())
}

/// Vertices of one model.
struct Counts {
    wood: f64,
    /// Vertices of the leaves drawn at each level.
    leaves: Vec<f64>,
    /// Vertices of all leaves.
    full: f64,
}

impl Counts {
    fn new(large: &Large<'_>) -> Outcome<Self> {
        let Pruned { mesh, elements, tiers, ranking, .. } = &large.ours;
        let schedule = large.ours.schedule()?;
        let full: usize =
            elements.surfaces.iter().map(|&s| mesh.surfaces[s as usize].positions.len()).sum();
        let distinct = |tier: usize, element: u32| {
            let mut rows: Vec<u32> = tiers[tier].of(element as usize).as_flattened().to_vec();
            rows.sort_unstable();
            rows.dedup();
            rows.len() as f64
        };
        let of_lambda = |lambda: f32| -> Outcome<f64> {
            let cut = schedule.at(lambda)?;
            let (fine, coarse) = (cut.tier as usize, (cut.tier as usize + 1).min(tiers.len() - 1));
            let (first, rest) = ranking.order[..cut.end as usize].split_at(cut.fine as usize);
            let sum = |tier, elements: &[u32]| -> f64 {
                elements.iter().map(|&e| distinct(tier, e)).sum()
            };
            Ok(sum(fine, first) + sum(coarse, rest))
        };
        let model = selectable(large, Distance::cook(), 1.0)?;
        let levels = model.levels.iter().map(|level| of_lambda(level.lambda));
        let leaves = levels.collect::<Outcome<_>>()?;
        Ok(Self { wood: (mesh.n_vertices() - full) as f64, leaves, full: full as f64 })
    }

    fn at(&self, level: usize) -> f64 {
        self.leaves.get(level).copied().unwrap_or_default()
    }
}

/// Means over the frames.
#[derive(Default)]
struct Drawn {
    leaves: f64,
    wood: f64,
    indices: f64,
    lambda: f64,
}

fn drawn(
    forest: &Forest,
    pruned: &[Large<'_>],
    counts: &[Counts],
    distance: &dyn Fn(&Large<'_>) -> Distance,
    cook: bool,
    occlusion: Occlusion<'_>,
) -> Outcome<Drawn> {
    let models = pruned
        .iter()
        .map(|large| selectable(large, distance(large), far(forest)))
        .collect::<Outcome<Vec<_>>>()?;
    let scene = scene(forest, &models)?;
    let mut state = State::new(&scene, &Control::default())?;
    let poses = forest.overviews(OVERVIEWS);
    let mut sum = Drawn::default();
    for pose in &poses {
        let frame = Frame { eye: eye(pose), occlusion, seconds: 0.0, cut: true };
        let found = scene.select(&frame, &SceneParams::default(), &mut state)?;
        for (i, tree) in forest.instances.iter().enumerate() {
            let Some(shown) = state.shown(&scene, i) else { continue };
            let counts = &counts[tree.model as usize];
            // Cook draws whole leaves: as many vertices as there are for the share.
            let leaves =
                if cook { counts.full * f64::from(shown.lambda) } else { counts.at(shown.level) };
            sum.leaves += leaves;
            sum.wood += counts.wood;
            sum.lambda += f64::from(shown.lambda) / found.n_drawn as f64;
        }
        sum.indices += leaf_indices(&found, forest, &state, &scene, pruned);
    }
    let n = poses.len() as f64;
    let Drawn { leaves, wood, indices, lambda } = sum;
    Ok(Drawn { leaves: leaves / n, wood: wood / n, indices: indices / n, lambda: lambda / n })
}

/// Indices without those of the wood.
fn leaf_indices(
    found: &Selected,
    forest: &Forest,
    state: &State,
    scene: &Scene,
    pruned: &[Large<'_>],
) -> f64 {
    let in_view = |&i: &usize| state.shown(scene, i).is_some();
    let large_wood: Vec<u64> = pruned.iter().map(wood_indices).collect();
    let wood = |i: usize| large_wood[forest.instances[i].model as usize];
    let wood: u64 = (0..forest.instances.len()).filter(in_view).map(wood).sum();
    (found.n_indices - wood) as f64
}

/// Indices of what is not pruned.
fn wood_indices(large: &Large<'_>) -> u64 {
    let Pruned { mesh, elements, .. } = &large.ours;
    3 * (mesh.n_triangles() - elements.n_triangles()) as u64
}

/// Time of a frame along the path, the built-in occlusion included.
fn selection(table: &mut Table, pruned: &[Large<'_>], n: u32, limit: f64, frames: u32) -> Outcome {
    let forest = Forest::new(n, pruned.len() as u32, SPACING, SEED)?;
    // What is drawn follows from the size on the screen, not from that of the forest.
    let far = far(&Forest::new(LARGE, pruned.len() as u32, SPACING, SEED)?);
    let parity = |large: &Large<'_>| Distance::parity(&large.ours.table, &large.cook);
    let models = pruned
        .iter()
        .map(|large| selectable(large, parity(large), far))
        .collect::<Outcome<Vec<_>>>()?;
    let scene = scene(&forest, &models)?;
    let mut state = State::new(&scene, &Control::default())?;
    let mut next = state.clone();
    let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
    let mut rows = vec![InstanceLod::default(); scene.len()];
    let params = SceneParams::default();
    let (mut times, mut writes) = (Vec::new(), Vec::new());
    let walk = forest.path(3 * frames);
    // The middle third of the path: through the forest.
    let walk = &walk[frames as usize..2 * frames as usize];
    let overviews = forest.overviews(frames);
    for (which, poses) in [("walking through", walk), ("all in view", overviews.as_slice())] {
        times.clear();
        writes.clear();
        for pose in poses {
            let frame =
                Frame { eye: eye(pose), occlusion: Occlusion::BuiltIn, seconds: 0.016, cut: false };
            let mut best = f64::INFINITY;
            for _ in 0..AGAIN {
                next.clone_from(&state);
                let start = Instant::now();
                scene.select(&frame, &params, &mut next)?;
                best = best.min(1e3 * start.elapsed().as_secs_f64());
            }
            std::mem::swap(&mut state, &mut next);
            times.push(best);
            let start = Instant::now();
            scene.batches(&mut state, &mut draws, &mut rows)?;
            writes.push(1e3 * start.elapsed().as_secs_f64());
        }
        let case = format!("{n} instances, {which}");
        let mut row = |metric, ours, aim| {
            table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit: "ms", aim });
        };
        row("selection with occlusion, best", quantile(&mut times, 0.0), Aim::None);
        row("selection with occlusion, median", quantile(&mut times, 0.5), Aim::AtMost(limit));
        row("selection with occlusion, 95 %", quantile(&mut times, 0.95), Aim::None);
        row("draw arguments, median", quantile(&mut writes, 0.5), Aim::None);
    }
    Ok(())
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let at = (share * values.len().saturating_sub(1) as f64) as usize;
    values.get(at).copied().unwrap_or_default()
}
