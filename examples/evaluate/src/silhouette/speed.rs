//! Times.

use super::cases::{Case, KINDS, Kind};
use super::lobes;
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use std::time::Instant;
use tree_model::silhouette::plan::{CoverParams, Lateral, Origin, System, SystemParams};
use tree_model::silhouette::session::Transfer;
use tree_model::silhouette::{Line, Outline};
use tree_model::tree_core::Control;
use tree_model::tree_core::glam::Vec2;

/// Points of an outline of which branches are timed.
const POINTS: usize = 500;
/// Runs of which the fastest counts.
const RUNS: u32 = 7;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    outlines(table)?;
    trees(table)?;
    redraws(table)
}

/// Bumps, branches and sub-silhouettes of an outline, without and with coverage.
fn outlines(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let lift = Vec2::new(0.0, 1.6);
    let lobed = lobes::rose(8, 0.2).into_iter().map(|p| p + lift).collect();
    let trunk = Line::new(vec![Vec2::ZERO, lift + Vec2::new(0.0, 0.7)]).ok_or("no trunk")?;
    let mut crowns = vec![("8 lobes", trunk, Outline::from_points(lobed)?)];
    for kind in &KINDS[..6] {
        let sessions = kind.case()?.sessions()?;
        let plan = sessions.first().and_then(|(session, ..)| session.plan()).ok_or("no plan")?;
        crowns.push((kind.name, plan.system.axis.clone(), plan.system.outline.clone()));
    }
    let bare = SystemParams {
        cover: CoverParams { places: 0, bare: 1.0, ..CoverParams::default() },
        ..SystemParams::default()
    };
    let mut worst: [(f64, &str); 2] = [(0.0, ""); 2];
    for (name, axis, outline) in &crowns {
        let outline = outline.resampled(POINTS);
        for (slot, params) in worst.iter_mut().zip([&bare, &SystemParams::default()]) {
            let (seconds, _) = fastest(RUNS, || -> Result<System, Box<dyn Error>> {
                let mut system = System::new(axis.clone(), outline.clone(), Default::default());
                system.grow(params, &mut 0);
                Ok(system)
            })?;
            if seconds > slot.0 {
                *slot = (seconds, name);
            }
        }
    }
    let metrics = ["bumps, branches, sub-outlines", "the same and coverage"];
    for ((seconds, name), metric) in worst.into_iter().zip(metrics) {
        let case = format!("outlines of {POINTS} points, slowest ({name})");
        time(table, &case, metric, seconds, Aim::AtMost(5.0));
    }
    Ok(())
}

/// From strokes to trees, as dense as the paper's.
fn trees(table: &mut Table) -> Result<(), Box<dyn Error>> {
    for (i, most) in [(0, 100.0), (5, 1500.0)] {
        let kind = &KINDS[i];
        let (case, density) = dense(kind)?;
        let (seconds, (strokes, elements)) = fastest(5, || whole(&case))?;
        let name = format!("{} of {strokes} strokes", kind.name);
        let mut row = |metric: &str, paper, ours: f64, unit: &str, aim| {
            table.row(&Row { case: &name, metric, paper, peer: None, ours, unit, aim });
        };
        let least = Aim::AtLeast(kind.elements);
        row("elements", Some(kind.elements), elements as f64, "", least);
        row("density over the usual", None, density.into(), "times", Aim::None);
        row("strokes to tree", None, 1e3 * seconds, "ms", Aim::AtMost(most));
        row("time per element", None, 1e9 * seconds / elements as f64, "ns", Aim::None);
    }
    Ok(())
}

/// The kind's case, its branches denser until there are as many elements as the paper's, and how much denser.
fn dense(kind: &Kind) -> Result<(Case, f32), Box<dyn Error>> {
    /// How much denser from trial to trial.
    const STEP: f32 = 1.1;
    /// Trials.
    const MOST: u32 = 40;
    let mut factor = 1.0;
    for _ in 0..MOST {
        let mut case = kind.case()?;
        let levels = &mut case.params.grow.levels;
        levels.iter_mut().for_each(|level| level.density *= factor);
        if whole(&case)?.1 as f64 >= kind.elements {
            return Ok((case, factor));
        }
        factor *= STEP;
    }
    Ok((kind.case()?, 1.0))
}

/// Strokes and elements of a case's tree, all anew.
fn whole(case: &Case) -> Result<(u32, u64), Box<dyn Error>> {
    let sessions = case.sessions()?;
    let (session, report, _) = sessions.first().ok_or("no tree")?;
    Ok((report.strokes, session.tree(&Control::default())?.report.elements()))
}

/// A branch drawn over, its shape and angle given to its siblings.
fn redraws(table: &mut Table) -> Result<(), Box<dyn Error>> {
    for i in [0, 4] {
        let case = KINDS[i].case()?;
        let mut sessions = case.sessions()?;
        let (session, ..) = sessions.first_mut().ok_or("no tree")?;
        let laterals = &session.plan().ok_or("no plan")?.system.laterals;
        let of_bump = |lateral: &&Lateral| lateral.origin == Origin::Bump;
        let source = laterals.iter().find(of_bump).ok_or("no branch of a bump")?;
        let stroke = bowed(&source.line);
        let n = laterals.len();
        let (mut plan, mut tree, mut reshaped) = (f64::INFINITY, f64::INFINITY, 0);
        for _ in 0..RUNS {
            let start = Instant::now();
            let change = session.redraw(1, &stroke, &Transfer::Siblings)?;
            plan = plan.min(start.elapsed().as_secs_f64());
            session.tree(&Control::default())?;
            tree = tree.min(start.elapsed().as_secs_f64());
            reshaped = change.reshaped.len();
            session.undo().ok_or("nothing to take back")?;
        }
        let name = format!("{}, one of {n} redrawn, {reshaped} change", case.name);
        time(table, &name, "plan, with transfer", plan, Aim::AtMost(10.0));
        time(table, &name, "and the tree anew", tree, Aim::None);
    }
    Ok(())
}

/// A branch with more of a bow.
fn bowed(line: &Line) -> Vec<Vec2> {
    let across = line.span().perp();
    let bow = |t: f32| 0.4 * t * (1.0 - t);
    (0..=40).map(|i| i as f32 / 40.0).map(|t| line.at(t) + bow(t) * across).collect()
}

fn time(table: &mut Table, case: &str, metric: &str, seconds: f64, aim: Aim) {
    table.row(&Row { case, metric, paper: None, peer: None, ours: 1e3 * seconds, unit: "ms", aim });
}
