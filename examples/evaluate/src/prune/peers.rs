//! The table at the top of PEERS.md: quality on views that were not used in the optimisation, ours against
//! random pruning and meshoptimizer.

use super::models::Leaves;
use super::pruned::held_out;
use super::simplify::{How, restore_area, simplify};
use super::{Outcome, Prepared, mean};
use crate::table::{Aim, Row, Table};
use tree_core::Control;
use tree_lod::cover;
use tree_lod::quality::{cook_scale, mean_quality};
use tree_mesh::Mesh;

/// Shares of leaf triangles kept.
const SHARES: [f32; 4] = [0.5, 0.2, 0.1, 0.05];
/// Pixels along the sides of the masks.
const SIZE: u32 = 512;
/// How far below its budget a level may be, as a share of it.
const UNUSED: f64 = 0.02;

/// A method of the table, with the figures printed in PEERS.md for cards and modelled leaves (of ours: of
/// the greedy order there).
struct Method {
    name: &'static str,
    printed: [[f64; 4]; 2],
}

const METHODS: [Method; 7] = [
    Method { name: "ours", printed: [[0.909, 0.852, 0.812, 0.778], [0.927, 0.888, 0.862, 0.840]] },
    Method {
        name: "random, no scale",
        printed: [[0.787, 0.517, 0.360, 0.248], [0.890, 0.683, 0.504, 0.342]],
    },
    Method {
        name: "random, Cook's scale",
        printed: [[0.806, 0.734, 0.693, 0.650], [0.896, 0.815, 0.754, 0.696]],
    },
    Method {
        name: "random, best scale",
        printed: [[0.807, 0.735, 0.695, 0.652], [0.917, 0.853, 0.814, 0.771]],
    },
    Method {
        name: "meshoptimizer simplify",
        printed: [[0.928, 0.712, 0.513, 0.346], [0.999, 0.976, 0.937, 0.853]],
    },
    Method {
        name: "meshoptimizer sloppy",
        printed: [[0.575, 0.437, 0.331, 0.252], [0.950, 0.851, 0.770, 0.691]],
    },
    Method {
        name: "simplify, area restored",
        printed: [[0.869, 0.769, 0.710, 0.651], [0.999, 0.982, 0.939, 0.882]],
    },
];

/// Quality of each method at each share.
type Found = [[f64; 4]; METHODS.len()];

const AIMS: [[f64; 4]; 2] = [[0.93, 0.87, 0.83, 0.80], [0.999, 0.985, 0.96, 0.91]];

pub(super) fn evaluate<'a: 'b, 'b>(
    table: &mut Table,
    all: impl Iterator<Item = &'b Prepared<'a>> + Clone,
) -> Outcome {
    let mut found: Vec<(&Prepared<'_>, Found)> = Vec::new();
    for prepared in all.clone() {
        let qualities = of_model(prepared)?;
        for (at, share) in SHARES.into_iter().enumerate() {
            let peer = qualities[4..].iter().map(|q| q[at]).fold(f64::MIN, f64::max);
            table.row(&Row {
                case: &prepared.model.name,
                metric: &format!("Q at {share}, ours / meshoptimizer"),
                paper: None,
                peer: Some(peer),
                ours: qualities[0][at],
                unit: "",
                aim: Aim::None,
            });
        }
        found.push((prepared, qualities));
    }
    for (kind, leaves) in [Leaves::Cards, Leaves::Modelled].into_iter().enumerate() {
        // The table is of the ez-tree models and trees of ours.
        let counts = |p: &Prepared<'_>| p.model.of_peers || !p.model.imported;
        let of_kind: Vec<_> =
            found.iter().filter(|(p, _)| p.model.leaves == leaves && counts(p)).collect();
        let of_peers: Vec<&Found> =
            of_kind.iter().filter(|(p, _)| p.model.of_peers).map(|(_, f)| f).collect();
        let of_all: Vec<&Found> = of_kind.iter().map(|(_, f)| f).collect();
        means(table, kind, &format!("{} of ez-tree", of_peers.len()), &of_peers, false);
        means(table, kind, &format!("all {}", of_all.len()), &of_all, true);
    }
    budgets(table, all)
}

fn means(table: &mut Table, kind: usize, which: &str, found: &[&Found], aimed: bool) {
    let kind_name = ["cards", "modelled leaves"][kind];
    for (number, method) in METHODS.iter().enumerate() {
        let case = format!("{kind_name}, {which}: {}", method.name);
        for (at, share) in SHARES.into_iter().enumerate() {
            let of = |number: usize| mean(&found.iter().map(|f| f[number][at]).collect::<Vec<_>>());
            let peers = (4..METHODS.len()).map(of).fold(f64::MIN, f64::max);
            table.row(&Row {
                case: &case,
                metric: &format!("mean Q at {share}"),
                paper: Some(method.printed[kind][at]),
                peer: (number == 0).then_some(peers),
                ours: of(number),
                unit: "",
                aim: if aimed && number == 0 { Aim::AtLeast(AIMS[kind][at]) } else { Aim::None },
            });
        }
    }
}

fn of_model(prepared: &Prepared<'_>) -> Outcome<Found> {
    let Prepared { model, random, .. } = prepared;
    let around = held_out(SIZE);
    let mut found = Found::default();
    let cameras = around.cameras();
    let ours = prepared.ours.qualities(&SHARES, &around)?;
    let scales = |lambda: f32| [1.0, cook_scale(lambda), random.table.at(lambda).scale];
    let at: Vec<(f32, f32)> =
        SHARES.into_iter().flat_map(|lambda| scales(lambda).map(|scale| (lambda, scale))).collect();
    let scaled = random.scores_at(&at, &around)?;
    for (at, lambda) in SHARES.into_iter().enumerate() {
        found[0][at] = ours[at];
        for (method, scores) in scaled[3 * at..][..3].iter().enumerate() {
            found[1 + method][at] = mean_quality(scores);
        }
        let foliage = &model.elements.surfaces;
        let quality = |mesh: &Mesh| -> Outcome<f64> {
            let scores = cover::score(mesh, &model.mesh, &cameras, SIZE, &Control::default())?;
            Ok(mean_quality(&scores))
        };
        let simple = |how| simplify(&model.mesh, foliage, lambda.into(), how).mesh;
        let plain = simple(How::Simplify);
        found[4][at] = quality(&plain)?;
        found[5][at] = quality(&simple(How::Sloppy))?;
        found[6][at] = quality(&restore_area(&plain, &model.mesh, foliage))?;
    }
    Ok(found)
}

/// How well levels fill their budget, and that there is always a leaf.
fn budgets<'a: 'b, 'b>(table: &mut Table, all: impl Iterator<Item = &'b Prepared<'a>>) -> Outcome {
    let (mut over, mut under, mut fewest) = (f64::MIN, f64::MIN, u64::MAX);
    for prepared in all {
        let schedule = prepared.ours.schedule()?;
        let full = schedule.n_triangles() as f64;
        for lambda in [0.0, 1e-6, 1e-3, 0.01] {
            fewest = fewest.min(schedule.at(lambda)?.n_triangles);
        }
        for lambda in SHARES {
            let off = schedule.at(lambda)?.n_triangles as f64 / (f64::from(lambda) * full) - 1.0;
            (over, under) = (over.max(100.0 * off), under.max(-100.0 * off));
        }
    }
    let mut row = |metric, ours, unit, aim| {
        let case = "budget of all models";
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    row("most over it", over, "%", Aim::AtMost(0.0));
    row("most under it", under, "%", Aim::AtMost(100.0 * UNUSED));
    row("fewest triangles, λ from 0", fewest as f64, "triangles", Aim::AtLeast(1.0));
    Ok(())
}
