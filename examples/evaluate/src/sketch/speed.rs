//! Times: propagation alone, and the whole way from strokes to leaves.

use super::fidelity::grow;
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_model::sketch::propagate::PropagateParams;
use tree_model::sketch::session::{Session, SketchParams};
use tree_model::sketch::template::{
    EXEMPLAR_SEED, Exemplar, MainBranchParams, main_branches, project,
};
use tree_model::sketch::{Drawing, Role};
use tree_model::tree_core::{Control, Seed};

/// "about 50 seconds to produce 4,291 branch segments" (4.9).
const PAPER_SEGMENTS: f64 = 4291.0;
const PAPER_MILLISECONDS: f64 = 50_000.0;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let mut row = |case: &str, metric: &str, paper, ours: f64, unit: &str, aim| {
        table.row(&Row { case, metric, paper, peer: None, ours, unit, aim });
    };
    let oak = drawing("oak", 36, true)?;
    let mut session = Session::new(oak, SketchParams::default(), Seed(1))?;
    session.inferred(&control)?;
    let params = PropagateParams { generations: 9, ..PropagateParams::default() };
    let (seconds, n) = fastest(5, || grow(&mut session, &params, &control))?;
    row(
        "propagation",
        "segments",
        Some(PAPER_SEGMENTS),
        n as f64,
        "",
        Aim::AtLeast(PAPER_SEGMENTS),
    );
    row("propagation", "time", Some(PAPER_MILLISECONDS), 1e3 * seconds, "ms", Aim::AtMost(50.0));
    for (n_strokes, crown, most) in
        [(8, true, 100.0), (8, false, 100.0), (100, true, 500.0), (100, false, 500.0)]
    {
        let drawing = drawing("oak", n_strokes, crown)?;
        let whole = || -> Result<usize, Box<dyn Error>> {
            let mut session = Session::new(drawing.clone(), SketchParams::default(), Seed(1))?;
            Ok(session.tree(&control)?.tree.foliage().len())
        };
        let (seconds, leaves) = fastest(5, whole)?;
        let case = format!(
            "{} strokes{}",
            branch_strokes(&drawing),
            if crown { " and a crown" } else { "" }
        );
        row(&case, "to a leafy tree", None, 1e3 * seconds, "ms", Aim::AtMost(most));
        row(&case, "leaves", None, leaves as f64, "", Aim::None);
    }
    Ok(())
}

/// A drawing of an exemplar's `most` main branches.
fn drawing(name: &str, most: u32, crown: bool) -> Result<Drawing, Box<dyn Error>> {
    let tree = Exemplar::find(name)?.tree(EXEMPLAR_SEED, &Control::default())?;
    let params =
        MainBranchParams { most, least: 0.05, least_second: 0.05, ..MainBranchParams::default() };
    let branches = main_branches(tree.skeleton(), &params)?;
    let crown = if crown { super::crown_of(&tree, 0.2) } else { Vec::new() };
    Ok(project(&branches, 0.2, &crown))
}

fn branch_strokes(drawing: &Drawing) -> usize {
    drawing.strokes.iter().filter(|stroke| stroke.role != Some(Role::Crown)).count()
}
