//! Colour (§7.5): the share of the covered pixels in which a salient leaf is nearest, full against pruned.
//!
//! Five percent of the leaves are red: at random, or those nearest to some point of the crown. Both are drawn
//! many times over one buffer of nearest leaves. The mean over all draws tells whether an order prefers some
//! leaves; how far single draws are off tells what one tree looks like. No order that does not know colours
//! can keep few random leaves: with m leaves left, chance alone is off by √(19 / m).

use super::nearest::{Seen, nearest};
use super::pruned::Pruned;
use super::{Outcome, Prepared, SEED, information, mean};
use crate::table::{Aim, Row, Table};
use std::f32::consts::TAU;
use tree_core::seed::Rng;
use tree_lod::Elements;

const LAMBDAS: [f32; 4] = [0.5, 0.2, 0.1, 0.05];
/// Share of the leaves that is red.
const RED: f64 = 0.05;
/// Draws of red leaves.
const DRAWS: u64 = 400;
/// Views.
const VIEWS: u16 = 6;
/// Pixels along the sides of the pictures.
const SIZE: u32 = 320;
/// How far the share may be from the full model's, in percent of it.
const OFF: f64 = 10.0;

pub(super) fn evaluate(table: &mut Table, models: &[&Prepared<'_>]) -> Outcome {
    for prepared in models {
        for (order, pruned) in [("stochastic", &prepared.random), ("ours", &prepared.ours)] {
            let case = format!("{}, {order}", prepared.model.name);
            of_order(table, &case, &prepared.model.elements, pruned, order == "ours")?;
        }
    }
    Ok(())
}

fn of_order(
    table: &mut Table,
    case: &str,
    leaves: &Elements,
    pruned: &Pruned<'_>,
    aimed: bool,
) -> Outcome {
    let leaf_of = leaf_of(leaves, &pruned.elements);
    let full = shares(pruned, &leaf_of, leaves.len(), 1.0)?;
    for lambda in LAMBDAS {
        let shown = shares(pruned, &leaf_of, leaves.len(), lambda)?;
        for (kind, reds) in [("random", random(leaves)), ("clustered", clustered(leaves))] {
            let sum = |shares: &[f64], red: &[u32]| -> f64 {
                red.iter().map(|&leaf| shares[leaf as usize]).sum()
            };
            // Clusters that are hidden in the full model have no share to compare.
            let pairs: Vec<[f64; 2]> = reds
                .iter()
                .map(|red| [sum(&full, red), sum(&shown, red)])
                .filter(|[full, _]| *full > 0.2 * RED)
                .collect();
            let both = |at: usize| mean(&pairs.iter().map(|p| p[at]).collect::<Vec<_>>());
            let ours = 100.0 * (both(1) / both(0) - 1.0).abs();
            let off = |p: &[f64; 2]| (p[1] / p[0] - 1.0) * (p[1] / p[0] - 1.0);
            let single = 100.0 * mean(&pairs.iter().map(off).collect::<Vec<_>>()).sqrt();
            table.row(&Row {
                case,
                metric: &format!("{kind} red, λ {lambda}, off on average"),
                paper: None,
                peer: None,
                ours,
                unit: "%",
                aim: if aimed { Aim::AtMost(OFF) } else { Aim::None },
            });
            let metric = format!("{kind} red, λ {lambda}, rms of one draw");
            information(table, case, &metric, single, "%");
        }
    }
    Ok(())
}

/// The leaf that each element of a finer division is of: both list triangles of the same surfaces.
fn leaf_of(leaves: &Elements, elements: &Elements) -> Vec<u32> {
    let mut of = std::collections::BTreeMap::new();
    for leaf in 0..leaves.len() {
        for &triangle in leaves.triangles_of(leaf) {
            of.insert((leaves.surface[leaf], triangle), leaf as u32);
        }
    }
    let leaf = |element: usize| {
        let triangle = elements.triangles_of(element).first().copied().unwrap_or_default();
        of.get(&(elements.surface[element], triangle)).copied().unwrap_or_default()
    };
    (0..elements.len()).map(leaf).collect()
}

/// Share of the covered pixels of each leaf.
fn shares(pruned: &Pruned<'_>, leaf_of: &[u32], n: usize, lambda: f32) -> Outcome<Vec<f64>> {
    let (mesh, owners) = pruned.mesh_at(lambda)?;
    let ball = pruned.mesh.bounding_sphere().ok_or("an empty mesh")?;
    let azimuths: Vec<f32> =
        (0..VIEWS).map(|i| 0.3 + TAU * f32::from(i) / f32::from(VIEWS)).collect();
    let seen: Seen = nearest(&mesh, &owners, leaf_of.len(), ball, &azimuths, SIZE);
    let covered = seen.covered().max(1) as f64;
    let mut shares = vec![0.0; n];
    for (&leaf, &pixels) in leaf_of.iter().zip(&seen.elements) {
        shares[leaf as usize] += pixels as f64 / covered;
    }
    Ok(shares)
}

fn number(leaves: &Elements) -> usize {
    ((RED * leaves.len() as f64) as usize).max(1)
}

fn random(leaves: &Elements) -> Vec<Vec<u32>> {
    let draw = |i| {
        let seed = SEED.stream("red at random").child(i);
        let mut rows: Vec<u32> = (0..leaves.len() as u32).collect();
        rows.sort_unstable_by_key(|&row| seed.child(row.into()).0);
        rows.truncate(number(leaves));
        rows
    };
    (0..DRAWS).map(draw).collect()
}

fn clustered(leaves: &Elements) -> Vec<Vec<u32>> {
    let mut rng: Rng = SEED.stream("red in a cluster").rng();
    let mut draw = |_| {
        let middle = tree_core::seed::uniform(&mut rng, 0.0, leaves.len() as f32) as usize;
        let center = leaves.centers[middle.min(leaves.len() - 1)];
        let mut rows: Vec<u32> = (0..leaves.len() as u32).collect();
        let far = |&row: &u32| leaves.centers[row as usize].distance_squared(center);
        rows.sort_by(|a, b| far(a).total_cmp(&far(b)));
        rows.truncate(number(leaves));
        rows
    };
    (0..DRAWS / 4).map(&mut draw).collect()
}
