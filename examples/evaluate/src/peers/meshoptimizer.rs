//! meshoptimizer (crate `meshopt` 0.7): levels of a tree's wood, and of its leaves, of as many triangles as ours.
//!
//! * Wood: ours is built anew from the skeleton with a larger error, theirs is the full mesh simplified to the same
//!   number of triangles. Seams of the texture are seams to it too, so that both results can be textured.
//! * Leaves: ours is one order with all levels in it, made once; theirs is one simplification a level. So times to make
//!   are told without an aim; the aims are that a level taken from ours is not slower, and looks no worse.
//!
//! Q is the quality of silhouettes (`tree_lod::quality`) on views that our order was not made with.

use super::ours::{Preset, mesh};
use super::{CASE, Outcome, beside, memory, wood::Wood};
use crate::measure::{fastest, peak_bytes};
use crate::prune::simplify::{How, simplify};
use crate::table::{Aim, Table};
use std::hint::black_box;
use tree_core::{Control, Tree};
use tree_lod::cover::{Around, score};
use tree_lod::prune::{MakeParams, PrunedModel};
use tree_lod::quality::mean_quality;
use tree_mesh::{ErrorBound, Mesh, MeshParams};

/// Errors of the coarser woods in metres; the full one has 3 mm.
const ERRORS: [f32; 2] = [0.01, 0.04];
/// Shares of leaf triangles kept.
const SHARES: [f32; 2] = [0.5, 0.1];
const RUNS: u32 = 5;
/// A level of ours is a few look-ups.
const LEVEL_RUNS: u32 = 1000;
/// Whose wood, and whose leaves.
const TREE: Preset = Preset::Path("oak");
/// Cases of memory: the coarsest wood, ours and theirs.
const OURS: &str = "wood built";
const THEIRS: &str = "wood simplified";

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let bare = TREE.grow(false)?;
    for error in ERRORS {
        wood(table, &bare, error)?;
    }
    if let [.., coarsest] = ERRORS {
        let of = |case: &str| peak_bytes(&format!("{CASE}{case}"));
        let case = wood_case(coarsest);
        memory(table, &case, of(THEIRS).map(|bytes| bytes as f64), of(OURS));
    }
    leaves(table, &TREE.grow(true)?)
}

fn wood_case(error: f32) -> String {
    format!("meshoptimizer, wood of {} at {} mm", TREE.name(), 1e3 * error)
}

fn coarse(tree: &Tree, error: f32) -> Outcome<Mesh> {
    mesh(tree, &MeshParams { error: ErrorBound::Metres(error), ..MeshParams::default() })
}

/// The full wood simplified to so many triangles.
fn simplified(full: &Mesh, n_triangles: f64) -> Mesh {
    let all = full.surfaces.first().map_or(0, |bark| bark.n_triangles()).max(1);
    simplify(full, &[0], n_triangles / all as f64, How::Simplify).mesh
}

fn triangles(mesh: &Mesh, surface: usize) -> f64 {
    mesh.surfaces.get(surface).map_or(0, |surface| surface.n_triangles()) as f64
}

fn wood(table: &mut Table, tree: &Tree, error: f32) -> Outcome {
    let full = mesh(tree, &MeshParams::default())?;
    let (own_seconds, own) = fastest(RUNS, || coarse(tree, error))?;
    let wanted = triangles(&own, 0);
    let (seconds, theirs) = fastest(RUNS, || Outcome::Ok(simplified(&full, wanted)))?;
    let case = wood_case(error);
    let mut row = |metric, figures, unit, aim| beside(table, &case, metric, figures, unit, aim);
    let [peer, ours] = [&theirs, &own].map(|mesh| triangles(mesh, 0));
    row("triangles of wood", [peer, ours], "", Aim::None);
    row("time for the level", [1e3 * seconds, 1e3 * own_seconds], "ms", Aim::AtMost(1e3 * seconds));
    let figures = [quality(&theirs, &full)?, quality(&own, &full)?];
    row("Q against the full wood", figures, "", Aim::AtLeast(figures[0]));
    let surface = |mesh: &Mesh| mesh.surfaces.first().ok_or("no bark").map(Wood::of);
    Wood::rows(table, &case, &surface(&theirs)??, &surface(&own)??);
    Ok(())
}

/// Mean over views that neither was made with.
fn quality(level: &Mesh, full: &Mesh) -> Outcome<f64> {
    let around = Around { turn: 0.3, ..Around::default() };
    let scores = score(level, full, &around.cameras(), around.size, &Control::default())?;
    Ok(mean_quality(&scores))
}

fn leaves(table: &mut Table, tree: &Tree) -> Outcome {
    let control = Control::default();
    let full = mesh(tree, &MeshParams::default())?;
    let foliage: Vec<u32> = (1..full.surfaces.len() as u32).collect();
    let (make, model) = fastest(1, || PrunedModel::make(&full, &MakeParams::default(), &control))?;
    for share in SHARES {
        let (seconds, theirs) = fastest(RUNS, || {
            Outcome::Ok(simplify(&full, &foliage, share.into(), How::Simplify).mesh)
        })?;
        let (level, _) = fastest(LEVEL_RUNS, || model.level(black_box(share)))?;
        let own = model.mesh_at(share)?;
        let n = |mesh: &Mesh| foliage.iter().map(|&s| triangles(mesh, s as usize)).sum::<f64>();
        let case = format!("meshoptimizer, {} leaf cards, {share} kept", TREE.name());
        let mut row = |metric, figures, unit, aim| beside(table, &case, metric, figures, unit, aim);
        row("triangles of leaves", [n(&theirs), n(&own)], "", Aim::None);
        row("time to make (ours: all levels)", [1e3 * seconds, 1e3 * make], "ms", Aim::None);
        row("time to take a level", [1e6 * seconds, 1e6 * level], "µs", Aim::AtMost(1e6 * seconds));
        let figures = [quality(&theirs, &full)?, quality(&own, &full)?];
        row("Q against the full tree", figures, "", Aim::AtLeast(figures[0]));
    }
    Ok(())
}

/// Does what a case of [`peak_bytes`] names, if it is one of these.
pub(super) fn build_case(case: &str) -> Outcome<bool> {
    let (Some(&error), OURS | THEIRS) = (ERRORS.last(), case) else {
        return Ok(false);
    };
    let tree = TREE.grow(false)?;
    if case == OURS {
        black_box(coarse(&tree, error)?);
    } else {
        let full = mesh(&tree, &MeshParams::default())?;
        // About what ours has at that error.
        black_box(simplified(&full, 0.2 * triangles(&full, 0)));
    }
    Ok(true)
}
