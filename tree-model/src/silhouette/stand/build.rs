//! A drawing of many trees, grown.

use super::ground::{self, Place, StandView};
use super::lend;
use super::params::StandParams;
use super::report::StandNote;
use crate::error::{ModelError, Result};
use crate::silhouette::grow::Grown;
use crate::silhouette::plan::Plan;
use crate::silhouette::read::{OutlineDrawing, TreeStrokes};
use crate::silhouette::session::{PlayReport, Session};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Resource, Seed};

/// Trees that grow before what they came to together is held against the limits.
const BATCH: usize = 16;

/// A tree of a stand.
#[derive(Clone, Debug)]
pub struct StandTree {
    /// Its name in the drawing, or `tree 3` for the third where it has none.
    pub name: String,
    /// Its place among the trees of the drawing, from 0.
    pub index: usize,
    /// What was drawn and borrowed: to be looked at, or drawn on. The tree's base is at the origin.
    pub session: Session,
    /// What grew, its base at the origin.
    pub grown: Grown,
    /// Where its base stands in the stand, in metres: x as in the drawing, +Z towards the viewer.
    pub position: Vec3,
    /// Metres for a unit of the drawing, at this tree.
    pub scale: f32,
    /// The tree, by its place in the drawing, whose branches or leaf it borrows.
    pub lender: Option<usize>,
    /// By how much what it borrows is scaled; 1 where it borrows nothing.
    pub borrowed_scale: f32,
    /// What became of its strokes.
    pub strokes: PlayReport,
}

impl StandTree {
    /// Its plan in the plane.
    #[must_use]
    pub fn plan(&self) -> Option<&Plan> {
        self.session.plan()
    }
}

/// Trees that grew of one drawing.
#[derive(Clone, Debug)]
pub struct Stand {
    /// The trees, in the order of the drawing. At least one.
    pub trees: Vec<StandTree>,
    /// From where the drawing was seen; `None` without perspective.
    pub view: Option<StandView>,
    /// What was noticed.
    pub notes: Vec<StandNote>,
}

impl Stand {
    /// Grows all trees of a drawing. Trees that cannot be used are left out and noted.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] when no tree can be used, and for a horizon below all of them; [`ModelError::Parameter`];
    /// [`ModelError::Limit`] for more nodes or leaves, all trees together, than the limits allow; [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// What the trees cost, shared among threads; and O(n²) comparisons of crowns for n trees.
    pub fn of_drawing(
        drawing: &OutlineDrawing,
        params: &StandParams,
        seed: Seed,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        params.check_lenders(drawing.trees.len())?;
        control.report("ground", 0.0)?;
        let names: Vec<String> = drawing.trees.iter().enumerate().map(name).collect();
        let mut notes = Vec::new();
        let stances = ground::stances(&drawing.trees, &names, &mut notes);
        if stances.is_empty() {
            return Err(none_left(&notes));
        }
        let (places, view) = ground::places(&stances, &names, params, seed, &mut notes)?;
        let placed: Vec<(usize, Place)> =
            stances.iter().map(|stance| stance.index).zip(places).collect();
        control.report("outlines", 0.05)?;
        let mut drawn = draw(&drawing.trees, &names, &placed, params, seed, &mut notes)?;
        control.report("styles", 0.2)?;
        lend_all(&mut drawn, &names, params, &mut notes);
        let trees = grow_all(drawn, &mut notes, control)?;
        if trees.is_empty() {
            return Err(none_left(&notes));
        }
        Ok(Self { trees, view, notes })
    }

    /// Leaves and branches of all trees together.
    #[must_use]
    pub fn elements(&self) -> u64 {
        self.trees.iter().map(|tree| tree.grown.report.elements()).sum()
    }
}

/// A tree that is yet to grow.
struct Drawn {
    name: String,
    index: usize,
    place: Place,
    session: Session,
    strokes: PlayReport,
    lender: Option<usize>,
    scale: f32,
}

/// The plans of all trees.
fn draw(
    trees: &[TreeStrokes],
    names: &[String],
    placed: &[(usize, Place)],
    params: &StandParams,
    seed: Seed,
    notes: &mut Vec<StandNote>,
) -> Result<Vec<Drawn>> {
    let seed = seed.stream("stand");
    let sessions: Vec<Result<(Session, PlayReport)>> = placed
        .par_iter()
        .map(|&(index, place)| {
            let seed = seed.child(index as u64);
            Session::of_ground(&trees[index], place.ground, params.silhouette.clone(), seed)
        })
        .collect();
    let mut drawn = Vec::with_capacity(sessions.len());
    for (&(index, place), session) in placed.iter().zip(sessions) {
        let name = names[index].clone();
        let Some((session, strokes)) = or_note(session, &name, notes)? else { continue };
        drawn.push(Drawn { name, index, place, session, strokes, lender: None, scale: 1.0 });
    }
    Ok(drawn)
}

/// Gives trees what they lack and others have. Everyone lends only what is its own.
fn lend_all(
    drawn: &mut [Drawn],
    names: &[String],
    params: &StandParams,
    notes: &mut Vec<StandNote>,
) {
    let mut plans: Vec<Option<&Plan>> = vec![None; names.len()];
    drawn.iter().for_each(|tree| plans[tree.index] = tree.session.plan());
    let loans: Vec<_> = drawn
        .iter()
        .map(|tree| {
            let plan = tree.session.plan()?;
            let chosen = params.lenders.iter().rev().find(|lending| lending.tree == tree.index);
            let lender =
                chosen.map_or_else(|| lend::nearest(&plans, plan), |chosen| chosen.from)?;
            let Some(from) = plans[lender].filter(|from| lend::has_more(from, plan)) else {
                let (tree, from) = (tree.name.clone(), names[lender].clone());
                notes.push(StandNote::NothingToLend { tree, from });
                return None;
            };
            let scale = lend::scale(from, plan, params.scaling);
            Some((lender, scale, lend::loan(from, plan, scale)))
        })
        .collect();
    for (tree, loan) in drawn.iter_mut().zip(loans) {
        let Some((lender, scale, (branches, leaf))) = loan else { continue };
        tree.session.lend(branches, leaf);
        (tree.lender, tree.scale) = (Some(lender), scale);
    }
}

/// Grows batch after batch, the trees of a batch at once.
fn grow_all(
    drawn: Vec<Drawn>,
    notes: &mut Vec<StandNote>,
    control: &Control,
) -> Result<Vec<StandTree>> {
    // Trees that grow at once would report progress in any order.
    let asked = control.clone();
    let quiet = Control::default()
        .with_limits(control.limits.clone())
        .with_stop(move || asked.check().is_err());
    let (mut nodes, mut leaves) = (0, 0);
    let n_trees = drawn.len();
    let mut grown = Vec::with_capacity(n_trees);
    for batch in drawn.chunks(BATCH) {
        control.report("trees", 0.25 + 0.75 * grown.len() as f32 / n_trees as f32)?;
        let trees: Vec<Result<Grown>> =
            batch.par_iter().map(|tree| tree.session.tree(&quiet)).collect();
        for (tree, result) in batch.iter().zip(trees) {
            let result = or_note(result, &tree.name, notes)?;
            if let Some(grown) = &result {
                nodes += grown.tree.skeleton().len() as u64;
                leaves += grown.tree.foliage().len() as u64;
            }
            grown.push(result);
        }
        control.limits.check(Resource::Nodes, nodes)?;
        control.limits.check(Resource::Leaves, leaves)?;
    }
    let finish = |(tree, grown): (Drawn, Option<Grown>)| {
        Some(StandTree {
            name: tree.name,
            index: tree.index,
            session: tree.session,
            grown: grown?,
            position: tree.place.position,
            scale: tree.place.ground.scale,
            lender: tree.lender,
            borrowed_scale: tree.scale,
            strokes: tree.strokes,
        })
    };
    Ok(drawn.into_iter().zip(grown).filter_map(finish).collect())
}

/// What is wrong with one tree only becomes a note.
fn or_note<T>(result: Result<T>, name: &str, notes: &mut Vec<StandNote>) -> Result<Option<T>> {
    match result {
        Ok(value) => Ok(Some(value)),
        Err(
            error @ (ModelError::Silhouette { .. }
            | ModelError::NotFinite { .. }
            | ModelError::Core(_)),
        ) => {
            notes.push(StandNote::LeftOut { tree: name.into(), why: error.to_string() });
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

fn none_left(notes: &[StandNote]) -> ModelError {
    let first = notes.first().map_or_else(|| "there is none".into(), ToString::to_string);
    let problem = format!("none of its trees can be used: {first}");
    ModelError::Silhouette { what: "drawing".into(), problem }
}

fn name((index, tree): (usize, &TreeStrokes)) -> String {
    if tree.name.is_empty() { format!("tree {}", index + 1) } else { tree.name.clone() }
}
