//! Silhouette quality by number of branches drawn: metrics side by side, on the trees that the default was chosen with
//! and on others.

use super::drawn::Drawn;
use super::orders::{self, Order};
use super::parts::Parts;
use super::trees::{self, Case};
use super::{Outcome, information, mean};
use crate::table::{Aim, Row, Table};
use tree_core::Tree;
use tree_lod::cover::Around;
use tree_lod::multires::Adt;
use tree_mesh::Look;

/// Shares of branches that are drawn.
const SHARES: [f64; 5] = [0.05, 0.1, 0.2, 0.4, 0.7];

/// Views that no order has seen, but the one that is a bound.
fn views() -> Around {
    Around { azimuths: 8, turn: 0.3, size: 512, ..Around::default() }
}

/// Quality of an order at each share, the mean of these, and the mean over all numbers of branches.
#[derive(Clone, Copy)]
struct Quality {
    at: [f64; SHARES.len()],
    of_shares: f64,
    of_all: f64,
}

impl Quality {
    fn new(drawn: &Drawn, order: &Order) -> Self {
        let all = drawn.qualities(&order.branches);
        let at =
            SHARES.map(|share| all[((share * all.len() as f64) as usize).clamp(1, all.len()) - 1]);
        Self { at, of_shares: mean(&at), of_all: mean(&all) }
    }
}

/// For each tree, for each order.
type Qualities = Vec<Vec<Quality>>;

pub(super) fn evaluate(table: &mut Table, ten: &[Case]) -> Outcome {
    rows_of(table, "ten trees", ten)?;
    rows_of(table, "held-out trees", &trees::held_out()?)
}

fn rows_of(table: &mut Table, set: &str, trees: &[Case]) -> Outcome {
    let (mut wood, mut all) = (Qualities::new(), Qualities::new());
    let mut levels = Vec::new();
    for Case { name, tree } in trees {
        let bare = Tree::bare(tree.skeleton().clone(), tree.species().clone());
        let (adt, found) = qualities(&bare, &Look::plain(tree.species()))?;
        information(table, &format!("branches of {name}"), "number", adt.len() as f64, "");
        levels.push(orders::levels(&adt)?);
        wood.push(found);
        if !tree.foliage().is_empty() {
            all.push(qualities(tree, &Look::built_in(tree.species())?)?.1);
        }
    }
    for (at, name) in orders::NAMES.iter().enumerate().take(levels.first().map_or(0, Vec::len)) {
        let of_order: Vec<f64> = levels.iter().map(|tree| tree[at]).collect();
        information(table, &format!("levels, {set}: {name}"), "of a branch", mean(&of_order), "");
    }
    rows(table, &format!("wood of {set}"), &wood);
    rows(table, &format!("wood and leaves of {set}"), &all);
    Ok(())
}

fn qualities(tree: &Tree, look: &Look) -> Outcome<(Adt, Vec<Quality>)> {
    let adt = Adt::of_tree(tree);
    let parts = Parts::new(tree, &adt, look)?;
    let drawn = Drawn::new(&parts, &views())?;
    let orders = orders::all(&adt, Some(&drawn))?;
    let found = orders.iter().map(|order| Quality::new(&drawn, order)).collect();
    Ok((adt, found))
}

/// Means over the trees.
fn rows(table: &mut Table, what: &str, trees: &Qualities) {
    let over = |order: usize, value: fn(&Quality) -> f64| {
        mean(&trees.iter().map(|tree| value(&tree[order])).collect::<Vec<_>>())
    };
    for (order, name) in orders::NAMES.iter().enumerate() {
        let case = format!("Q of {what} ({}): {name}", trees.len());
        for (share, percent) in SHARES.iter().enumerate() {
            let metric = format!("at {} % of branches", 100.0 * percent);
            let of_trees: Vec<f64> = trees.iter().map(|tree| tree[order].at[share]).collect();
            information(table, &case, &metric, mean(&of_trees), "");
        }
        // The default is held against the best of the others.
        let mut row = |metric: &str, value: fn(&Quality) -> f64| {
            let others = 1..orders::N_METRICS;
            let best = others.map(|other| over(other, value)).fold(f64::MIN, f64::max);
            let aim = if order == 0 { Aim::AtLeast(best) } else { Aim::None };
            let (paper, peer, ours) = (None, Some(best), over(order, value));
            table.row(&Row { case: &case, metric, paper, peer, ours, unit: "", aim });
        };
        row("mean over shares", |quality| quality.of_shares);
        row("mean over all numbers", |quality| quality.of_all);
    }
}
