//! Orders of branches.

use super::drawn::Drawn;
use super::{Outcome, mean};
use tree_core::{Control, Seed};
use tree_lod::multires::{Adt, Metric, paths};

/// The default, the paper's metrics and those it is compared with, and what looks at the pixels that it is judged by.
pub(super) const NAMES: [&str; 9] = [
    "density (ours)",
    "branching length",
    "children",
    "descendants",
    "longest path",
    "undone derivations",
    "random",
    "branching area",
    "bound: sees the pixels",
];
/// How many of these are held against each other: all but a variant of ours and the bound.
pub(super) const N_METRICS: usize = 7;
/// Times that the bound is improved.
const ROUNDS: usize = 8;

/// What a prefix of it draws.
pub(super) struct Order {
    pub(super) branches: Vec<u32>,
}

/// All orders in the order of [`NAMES`]; the bound only where it is known what branches draw.
pub(super) fn all(adt: &Adt, drawn: Option<&Drawn>) -> Outcome<Vec<Order>> {
    let mut orders = Vec::new();
    for metric in metrics(adt) {
        let branches = paths(adt, &metric, &Control::default())?.branches().to_vec();
        orders.push(Order { branches });
    }
    if let Some(drawn) = drawn {
        orders.push(Order { branches: bound(adt, drawn)? });
    }
    Ok(orders)
}

/// Levels of each metric for each branch.
pub(super) fn levels(adt: &Adt) -> Outcome<Vec<f64>> {
    let of = |metric| Ok(paths(adt, &metric, &Control::default())?.len() as f64 / adt.len() as f64);
    metrics(adt).map(of).into_iter().collect()
}

fn metrics(adt: &Adt) -> [Metric; 8] {
    [
        Metric::default(),
        Metric::BranchingLength,
        Metric::Children,
        Metric::Descendants,
        Metric::LongestPath,
        Metric::Generation,
        Metric::Random(Seed(5)),
        Metric::Branching(adt.areas().to_vec()),
    ]
}

/// As the default, but the worth of a branch is the number of pixels that it adds to those before it: first each pixel
/// is shared by all that cover it, then what is added in the order found is taken into the worths, again and again. The best
/// order of all rounds. No metric knows these pixels.
fn bound(adt: &Adt, drawn: &Drawn) -> Outcome<Vec<u32>> {
    let mut worth = drawn.shares();
    let mut best = (f64::MIN, Vec::new());
    for _ in 0..ROUNDS {
        let order = paths(adt, &Metric::DensityOf(worth.clone()), &Control::default())?;
        let order = order.branches().to_vec();
        let added = drawn.added(&order);
        worth.iter_mut().zip(&added).for_each(|(worth, added)| *worth = 0.5 * (*worth + added));
        let quality = mean(&drawn.qualities(&order));
        if quality > best.0 {
            best = (quality, order);
        }
    }
    Ok(best.1)
}
