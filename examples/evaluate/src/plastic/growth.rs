//! Table 2: how long a tree takes to grow, and how long two such trees take to compare.
//!
//! As in the paper, twenty trees of each age are grown and the times averaged, skeletons only. Trees may not be
//! smaller than the paper's.

use super::Outcome;
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use tree_core::distance::{EditParams, Reduction, distance};
use tree_core::{Control, Seed, Skeleton};
use tree_model::growth::{Environment, GrowthParams, Preset};

/// How many times faster than printed the issue asks for.
const SPEEDUP: f64 = 50.0;
/// Trees of each age.
const N_TREES: u64 = 20;

/// A row of Table 2.
struct Aged {
    years: u32,
    nodes: f64,
    milliseconds: f64,
}

const TABLE_2: [Aged; 3] = [
    Aged { years: 10, nodes: 530.0, milliseconds: 216.3 },
    Aged { years: 20, nodes: 2541.0, milliseconds: 8855.6 },
    Aged { years: 30, nodes: 9134.0, milliseconds: 61_843.9 },
];

/// The tree that the times are of: an oak that has about as many nodes at these ages as the paper's trees, and no fewer; without
/// leaves.
pub(super) fn params(years: u32) -> Outcome<GrowthParams> {
    let mut params = Preset::find("oak")?.params();
    params.iterations = years;
    params.habit.leaves = None;
    params.habit.vigour = match years {
        0..=10 => 2.15,
        11..=20 => 2.0,
        _ => 1.95,
    };
    if let Environment::Shadow(shadow) = &mut params.world.environment {
        (shadow.strength, shadow.falloff) = (0.15, 1.7);
    }
    Ok(params)
}

/// One tree for each seed.
pub(super) fn trees(years: u32, n_trees: u64) -> Outcome<Vec<Skeleton>> {
    let (params, control) = (params(years)?, Control::default());
    let grow = |seed| Ok(params.grow(Seed(seed), &control)?.tree.skeleton().clone());
    (0..n_trees).map(grow).collect()
}

/// Growth of twenty trees at each age.
pub(crate) fn times(table: &mut Table) -> Outcome {
    for Aged { years, nodes, milliseconds } in TABLE_2 {
        let case = format!("Table 2: {years} years");
        let (seconds, grown) = fastest(3, || trees(years, N_TREES))?;
        let total: usize = grown.iter().map(Skeleton::len).sum();
        let row = |metric, paper, ours, unit, aim| Row {
            case: &case,
            metric,
            paper: Some(paper),
            peer: None,
            ours,
            unit,
            aim,
        };
        let mean = total as f64 / N_TREES as f64;
        table.row(&row("nodes", nodes, mean, "nodes", Aim::AtLeast(nodes)));
        let each = 1e3 * seconds / N_TREES as f64;
        let aim = Aim::AtMost(milliseconds / SPEEDUP);
        table.row(&row("growth time", milliseconds, each, "ms", aim));
    }
    Ok(())
}

/// Edit distances of pairs of such trees, with and without joining unbranched runs.
pub(crate) fn distances(table: &mut Table) -> Outcome {
    for Aged { years, .. } in &TABLE_2[..2] {
        let pair = trees(*years, 2)?;
        let [a, b] = pair.as_slice() else { continue };
        let case = format!("two trees of {years} years: {} and {} nodes", a.len(), b.len());
        for (metric, reduction) in
            [("distance by runs", Reduction::Runs), ("distance by nodes", Reduction::None)]
        {
            let params = EditParams { reduction, ..EditParams::default() };
            let (seconds, _) = fastest(3, || distance(a, b, &params, &Control::default()))?;
            // Trees of 2500 nodes are to compare in about a second.
            let aim = Aim::AtMost(1e3);
            let ours = 1e3 * seconds;
            let (paper, peer, unit) = (None, None, "ms");
            table.row(&Row { case: &case, metric, paper, peer, ours, unit, aim });
        }
    }
    Ok(())
}
