//! Silhouette quality by number of branches drawn: metrics side by side.

use super::orders::{self, Order};
use super::parts::{Masks, Parts};
use super::trees::Case;
use super::{Outcome, information, mean};
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use tree_lod::cover::Around;
use tree_lod::multires::Adt;
use tree_mesh::Look;

/// Shares of branches that are drawn.
const SHARES: [f64; 5] = [0.05, 0.1, 0.2, 0.4, 0.7];

/// Views that no order has seen.
fn held_out() -> Around {
    Around { azimuths: 8, turn: 0.3, size: 512, ..Around::default() }
}

/// The first of the orders are the paper's metrics, undone derivations and chance; the best metric of ours.
const PEERS: usize = 6;
const OURS: &str = "densest, area";

/// Quality of an order at each share.
type Qualities = [f64; SHARES.len()];

pub(super) fn evaluate(table: &mut Table, trees: &[Case]) -> Outcome {
    let mut names = Vec::new();
    let (mut of_wood, mut of_all) = (Vec::new(), Vec::new());
    let mut runs = Vec::new();
    for case in trees {
        let adt = Adt::of_skeleton(case.tree.skeleton());
        let wood = Parts::wood(&case.tree, &adt)?;
        let orders = orders::all(&case.tree, &adt, &wood)?;
        names = orders.iter().map(|order| order.name).collect();
        for order in &orders {
            runs.push(orders::n_runs(&adt, &order.branches) as f64 / adt.len() as f64);
        }
        of_wood.push(qualities(&wood, &orders)?);
        information(table, &format!("branches of {}", case.name), "number", adt.len() as f64, "");
        if !case.tree.foliage().is_empty() {
            let look = Look::built_in(case.tree.species())?;
            of_all.push(qualities(&Parts::new(&case.tree, &adt, &look)?, &orders)?);
        }
    }
    for (order, name) in names.iter().enumerate() {
        let of_order: Vec<f64> = runs.iter().copied().skip(order).step_by(names.len()).collect();
        information(table, &format!("levels: {name}"), "of a branch", mean(&of_order), "");
    }
    rows(table, "wood", &names, &of_wood);
    rows(table, "wood and leaves", &names, &of_all);
    Ok(())
}

fn qualities(parts: &Parts, orders: &[Order]) -> Outcome<Vec<Qualities>> {
    let masks = Masks::new(&parts.mesh, &held_out())?;
    let of = |order: &Order| -> Result<Qualities, String> {
        let mut found = [0.0; SHARES.len()];
        for (found, share) in found.iter_mut().zip(SHARES) {
            let n = ((share * order.branches.len() as f64) as usize).max(1);
            let mesh = parts.of(&order.branches[..n]);
            *found = masks.quality(&mesh).map_err(|error| error.to_string())?;
        }
        Ok(found)
    };
    let found: Result<Vec<_>, String> = orders.par_iter().map(of).collect();
    Ok(found?)
}

/// Means over the trees, and over the shares.
fn rows(table: &mut Table, what: &str, names: &[&str], of_trees: &[Vec<Qualities>]) {
    let at = |order: usize, share: usize| {
        mean(&of_trees.iter().map(|tree| tree[order][share]).collect::<Vec<_>>())
    };
    let all =
        |order: usize| mean(&(0..SHARES.len()).map(|share| at(order, share)).collect::<Vec<_>>());
    for (order, name) in names.iter().enumerate() {
        let case = format!("Q of {what}, {} trees: {name}", of_trees.len());
        for (share, percent) in SHARES.iter().enumerate() {
            let metric = format!("at {} % of branches", 100.0 * percent);
            information(table, &case, &metric, at(order, share), "");
        }
        // The metric of ours is held against the best of the others.
        let best = (0..PEERS).map(all).fold(f64::MIN, f64::max);
        let aim = if *name == OURS { Aim::AtLeast(best) } else { Aim::None };
        let metric = "mean over shares";
        let peer = Some(best);
        table.row(&Row { case: &case, metric, paper: None, peer, ours: all(order), unit: "", aim });
    }
}
