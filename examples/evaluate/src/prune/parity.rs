//! Table 7.4: geometry saved against Cook at equal quality, along a camera path through a forest, without
//! culling; and the quality of each order at some shares (§7.3).

use super::pruned::{Pruned, few_params, held_out};
use super::scene::{Forest, STANDARD};
use super::{Outcome, Prepared, SEED, SPACING, information, mean};
use crate::table::{Aim, Row, Table};
use tree_core::Control;
use tree_lod::implicit;
use tree_lod::order::{OrderParams, combined, density, golden, orientation, stochastic};
use tree_lod::quality::{Distance, Scale, Table as Measured, TableParams};

/// Frames of the path.
const FRAMES: u32 = 120;
/// Shares at which orders are compared.
const SHARES: [f32; 4] = [0.8, 0.5, 0.2, 0.05];
/// Pixels along the sides of these masks.
const SIZE: u32 = 512;

/// Columns: name, the paper's average, least and most, and what the issue asks of the average.
struct Column {
    name: &'static str,
    printed: Option<[f64; 3]>,
    aim: Option<f64>,
}

const fn column(name: &'static str, printed: Option<[f64; 3]>, aim: Option<f64>) -> Column {
    Column { name, printed, aim }
}

/// Stochastic order is that of [`Prepared::random`], the last that of [`Prepared::ours`].
const COLUMNS: [Column; 6] = [
    column("stochastic, best scale", Some([0.101, 0.043, 0.437]), Some(0.101)),
    column("golden, best scale", None, None),
    column("density, best scale", Some([0.174, 0.022, 0.236]), Some(0.174)),
    column("orientation, best scale", Some([0.407, 0.308, 0.693]), None),
    column("combined, best scale", Some([0.301, 0.014, 0.392]), Some(0.301)),
    column("best: ours", Some([0.407, 0.308, 0.693]), Some(0.407)),
];

/// Measured at [`SHARES`] only: Table 7.4 does not have it.
const GOLDEN: usize = 1;

/// Orders of a model but for the stochastic one and ours.
pub(super) fn orders<'a>(
    prepared: &Prepared<'a>,
    params: &OrderParams,
) -> Outcome<Vec<Pruned<'a>>> {
    let (elements, control) = (&prepared.model.elements, Control::default());
    let field = params.field(elements)?;
    let hull = implicit::surface(&field, &params.hull, &control)?;
    let few = TableParams {
        lambdas: SHARES.iter().rev().copied().chain([1.0]).collect(),
        ..few_params(Scale::Best)
    };
    let elements_of = || prepared.model.elements.clone();
    let golden = Pruned::ordered_with(prepared.model, elements_of(), golden(elements)?, &few)?;
    let orders = [
        density(elements, params, SEED, &control)?,
        orientation(elements, &hull, params, SEED, &control)?,
        combined(elements, params, SEED, &control)?,
    ];
    let measure = |order| Pruned::ordered(prepared.model, order, Scale::Best);
    std::iter::once(Ok(golden)).chain(orders.into_iter().map(measure)).collect()
}

/// Gives back Cook's tables of the models.
pub(super) fn evaluate(table: &mut Table, models: &[Prepared<'_>]) -> Outcome<Vec<Measured>> {
    let others =
        models.iter().map(|p| orders(p, &OrderParams::default())).collect::<Outcome<Vec<_>>>()?;
    let columns: Vec<Vec<&Pruned<'_>>> = models
        .iter()
        .zip(&others)
        .map(|(p, others)| {
            std::iter::once(&p.random).chain(others).chain(std::iter::once(&p.ours)).collect()
        })
        .collect();
    heuristics(table, &columns)?;
    let forest = Forest::new(STANDARD, models.len() as u32, SPACING, SEED)?;
    let imported = models.iter().filter(|p| p.model.imported).count();
    let case = format!("{STANDARD} trees of {} models", models.len());
    information(table, &case, "imported models", imported as f64, "");
    let cook = cooks(models)?;
    for (number, column) in COLUMNS.iter().enumerate().filter(|(number, _)| *number != GOLDEN) {
        let distances: Vec<Distance> = columns
            .iter()
            .zip(&cook)
            .map(|(of_model, cook)| Distance::parity(&of_model[number].table, cook))
            .collect();
        rows(table, column, &saved(&forest, models, &distances));
    }
    let halves = models
        .iter()
        .map(|p| Ok(Distance::parity(&p.ours.table, &cook_of_triangles(p)?.table)))
        .collect::<Outcome<Vec<_>>>()?;
    let against = column("best: ours against Cook with our elements", None, None);
    rows(table, &against, &saved(&forest, models, &halves));
    Ok(cook)
}

/// Cook's table of each model: random whole leaves with scale 1 / λ.
fn cooks(models: &[Prepared<'_>]) -> Outcome<Vec<Measured>> {
    let one = |p: &Prepared<'_>| {
        let order = p.random.ranking.order.clone();
        Ok(Pruned::ordered(p.model, order, Scale::Cook)?.table)
    };
    models.iter().map(one).collect()
}

/// The same with elements as we take them: cards by halves.
fn cook_of_triangles<'a>(p: &Prepared<'a>) -> Outcome<Pruned<'a>> {
    let elements = p.ours.elements.clone();
    let order = stochastic(&elements, SEED);
    Pruned::ordered_with(p.model, elements, order, &few_params(Scale::Cook))
}

/// Share of the geometry that Cook draws which is saved, in every frame.
fn saved(forest: &Forest, models: &[Prepared<'_>], distances: &[Distance]) -> Vec<f64> {
    let far = forest.far();
    let cook = Distance::cook();
    let triangles: Vec<f64> =
        models.iter().map(|p| p.model.elements.n_triangles() as f64).collect();
    let frame = |pose: tree_lod::preview::Pose| {
        let (mut ours, mut theirs) = (0.0, 0.0);
        for tree in &forest.instances {
            let model = tree.model as usize;
            // A larger tree counts as nearer, as it is by its size on the screen.
            let d = pose.eye.distance(tree.position) / tree.scale / far;
            ours += triangles[model] * f64::from(distances[model].lambda(d));
            theirs += triangles[model] * f64::from(cook.lambda(d));
        }
        1.0 - ours / theirs
    };
    forest.path(FRAMES).into_iter().map(frame).collect()
}

fn rows(table: &mut Table, column: &Column, saved: &[f64]) {
    let figures = [
        ("saved, average", mean(saved)),
        ("saved, least", saved.iter().copied().fold(f64::MAX, f64::min)),
        ("saved, most", saved.iter().copied().fold(f64::MIN, f64::max)),
    ];
    for (at, (metric, ours)) in figures.into_iter().enumerate() {
        let aim = match column.aim {
            Some(aim) if at == 0 => Aim::AtLeast(100.0 * aim),
            _ => Aim::None,
        };
        table.row(&Row {
            case: &format!("Table 7.4: {}", column.name),
            metric,
            paper: column.printed.map(|printed| 100.0 * printed[at]),
            peer: None,
            ours: 100.0 * ours,
            unit: "%",
            aim,
        });
    }
}

/// Mean quality over all models of each order.
fn heuristics(table: &mut Table, columns: &[Vec<&Pruned<'_>>]) -> Outcome {
    let of_order = |pruned: &&Pruned<'_>| pruned.qualities(&SHARES, &held_out(SIZE));
    let found = columns
        .iter()
        .map(|of_model| of_model.iter().map(of_order).collect())
        .collect::<Outcome<Vec<Vec<Vec<f64>>>>>()?;
    for (at, lambda) in SHARES.into_iter().enumerate() {
        let mut peer = None;
        for (number, column) in COLUMNS.iter().enumerate() {
            let ours = mean(&found.iter().map(|of| of[number][at]).collect::<Vec<_>>());
            let case = format!("orders: {}", column.name);
            let metric = format!("mean Q at {lambda}");
            let aim = Aim::None;
            table.row(&Row {
                case: &case,
                metric: &metric,
                paper: None,
                peer,
                ours,
                unit: "",
                aim,
            });
            // The others are held against the stochastic order.
            peer = peer.or(Some(ours));
        }
    }
    Ok(())
}
