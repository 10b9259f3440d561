//! Extraction of any level.

use super::trees::Case;
use super::{Outcome, information};
use crate::table::{Aim, Row, Table};
use std::hint::black_box;
use std::time::Instant;
use tree_core::Control;
use tree_lod::multires::{Draw, Metric, MultiMesh, Multires};
use tree_mesh::{Look, MeshParams};

/// Microseconds that the issue allows.
const ALLOWED: f64 = 10.0;
/// Times that each level is taken; the fastest counts, since others share the machine.
const RUNS: u32 = 5;

pub(super) fn evaluate(table: &mut Table, trees: &[Case]) -> Outcome {
    let mut all = Vec::new();
    for Case { tree, .. } in trees {
        let control = Control::default();
        let multires = Multires::new(tree, &Metric::default(), &control)?;
        let look = Look::plain(tree.species());
        let mesh = MultiMesh::new(&multires, &look, &MeshParams::default(), &control)?;
        let mut draws = vec![Draw::default(); mesh.mesh().surfaces.len()];
        for level in 1..=multires.n_levels() {
            let mut best = f64::INFINITY;
            for _ in 0..RUNS {
                let start = Instant::now();
                black_box(multires.level(black_box(level)));
                black_box(mesh.draws(black_box(level as f32), &mut draws)?);
                best = best.min(start.elapsed().as_secs_f64());
            }
            all.push(1e6 * best);
        }
    }
    all.sort_by(f64::total_cmp);
    let case = format!("extraction, {} levels of {} trees", all.len(), trees.len());
    let median = all.get(all.len() / 2).copied().unwrap_or_default();
    information(table, &case, "median", median, "µs");
    table.row(&Row {
        case: &case,
        metric: "worst level",
        paper: None,
        peer: None,
        ours: all.last().copied().unwrap_or_default(),
        unit: "µs",
        aim: Aim::AtMost(ALLOWED),
    });
    Ok(())
}
