//! Are the bumps found that were put there? Constructed outlines of 1 to 12 lobes, turned, by few and many points,
//! drawn by a steady hand and by an unsteady one.

use super::lobes::{Noise, families};
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use std::error::Error;
use tree_model::silhouette::bump::{BumpParams, bumps};
use tree_model::tree_core::Seed;

/// Why not all are.
const MISSED: &str = "conifers of ten and eleven bumps drawn by few points or an unsteady hand: small bumps and noise are of one size";

/// Points of an outline.
const POINTS: [usize; 6] = [60, 120, 250, 500, 1000, 2000];
/// Rotations.
const TURNS: u64 = 6;
/// Hands.
const HANDS: [(&str, Noise); 6] = [
    ("no noise", Noise { size: 0.0, calm: 0 }),
    ("jitter of 0.5 %", Noise { size: 0.005, calm: 0 }),
    ("jitter of 1 %", Noise { size: 0.01, calm: 0 }),
    ("tremor of 1 %", Noise { size: 0.01, calm: 3 }),
    ("slow waves of 0.5 %", Noise { size: 0.005, calm: 20 }),
    ("slow waves of 1 %", Noise { size: 0.01, calm: 20 }),
];

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let families = families();
    let seed = Seed(1).stream("lobes");
    let (mut all, mut all_right) = (0_u32, 0_u32);
    let mut missed = vec![0_u32; families.len()];
    for (hand, noise) in HANDS {
        let outlines: Vec<(usize, usize, u64)> = (0..families.len())
            .flat_map(|i| POINTS.map(|n| (0..TURNS).map(move |turn| (i, n, turn))))
            .flatten()
            .collect();
        let right = |&(i, n, turn): &(usize, usize, u64)| -> Result<bool, &'static str> {
            let seed = seed.child(i as u64).child(turn);
            // Turns that are no share of a whole one.
            let outline = families[i].drawn(n, 0.7 * turn as f32, noise, seed);
            let outline = outline.ok_or("a constructed outline was refused")?;
            Ok(bumps(&outline, &BumpParams::default()).len() == families[i].bumps)
        };
        let right = outlines.par_iter().map(right).collect::<Result<Vec<bool>, _>>()?;
        for (&(i, ..), right) in outlines.iter().zip(&right) {
            missed[i] += u32::from(!right);
        }
        let n_tried = outlines.len() as u32;
        let n_right = right.iter().filter(|right| **right).count() as u32;
        (all, all_right) = (all + n_tried, all_right + n_right);
        row(table, hand, n_right, n_tried);
    }
    let tried = all / families.len() as u32;
    let worst = (0..families.len()).max_by_key(|&i| missed[i]).unwrap_or(0);
    row(table, &format!("worst: {}", families[worst].name), tried - missed[worst], tried);
    row(table, &format!("all {all}"), all_right, all);
    Ok(())
}

fn row(table: &mut Table, case: &str, n_right: u32, n_tried: u32) {
    let row = Row {
        case: &format!("bumps of 1 to 12 lobes, {case}"),
        metric: "number as constructed",
        paper: None,
        peer: None,
        ours: 100.0 * f64::from(n_right) / f64::from(n_tried.max(1)),
        unit: "%",
        aim: Aim::AtLeast(100.0),
    };
    table.row_because(&row, MISSED);
}
