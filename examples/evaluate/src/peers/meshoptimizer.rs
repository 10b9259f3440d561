//! meshoptimizer (crate `meshopt` 0.7): levels of a tree's wood and of its leaves, of as many triangles as ours.
//!
//! * Wood, built: ours is made anew from the skeleton with a larger error, theirs is the full mesh simplified to the
//!   same number of triangles. Once as it is textured, where seams are seams to it too, and once welded: in its favour,
//!   since a closed mesh goes in and nothing but shape matters, but the textures are lost.
//! * Wood, by prefix (Lluch et al. 2010): every level is a prefix of one index buffer; tubes of its own for each branch
//!   are open where they begin, in theirs and in ours.
//! * Leaves: ours is one order with all levels in it, made once on all threads; theirs is one simplification a level.
//!
//! Times to make all levels are told without an aim; that a level is not slower and looks no worse are aims. Q is the
//! quality of silhouettes (`tree_lod::quality`) on views that our order was not made with.

use super::ours::{Preset, mesh};
use super::{CASE, Outcome, beside, fastest, memory, wood::Wood};
use crate::measure::peak_bytes;
use crate::prune::simplify::{How, simplify};
use crate::table::{Aim, Table};
use std::hint::black_box;
use tree_core::{Control, Tree};
use tree_lod::cover::{Around, score};
use tree_lod::multires::{Metric, MultiMesh, Multires};
use tree_lod::prune::{MakeParams, PrunedModel};
use tree_lod::quality::{Score, mean_quality};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams, Surface, topology::weld};

/// Errors of the coarser woods in metres; the full one has 3 mm.
const FINE: f32 = 0.01;
const COARSE: f32 = 0.04;
/// Share of the triangles of wood in the prefix.
const PREFIX: f64 = 0.5;
/// Shares of leaf triangles kept.
const SHARES: [f32; 2] = [0.5, 0.1];
/// Whose wood, and whose leaves.
const TREE: Preset = Preset::Path("oak");
/// Cases of memory: the coarsest wood, ours and theirs.
const OURS: &str = "wood built";
const THEIRS: &str = "wood simplified";

/// On one thread.
pub(super) fn wood(table: &mut Table) -> Outcome {
    let tree = TREE.grow(false)?;
    let full = mesh(&tree, &MeshParams::default())?;
    let welded = welded(&full)?;
    for error in [FINE, COARSE] {
        for (how, full) in [("textured", &full), ("welded", &welded)] {
            let case = format!("meshoptimizer, oak wood {} mm, {how}", 1e3 * error);
            built(table, &case, &tree, error, full)?;
        }
    }
    let of = |case: &str| peak_bytes(&format!("{CASE}{case}"));
    let case = format!("meshoptimizer, oak wood {} mm, textured", 1e3 * COARSE);
    memory(table, &case, of(THEIRS).map(|bytes| bytes as f64), of(OURS));
    prefix(table, &tree)
}

/// One vertex for each point; the column says that there are no others.
fn welded(full: &Mesh) -> Outcome<Mesh> {
    let mut surface = weld(full.surfaces.first().ok_or("no bark")?)?;
    surface.welds = (0..surface.positions.len() as u32).collect();
    Ok(Mesh { surfaces: vec![surface], ..full.clone() })
}

fn coarse(tree: &Tree, error: f32) -> Outcome<Mesh> {
    mesh(tree, &MeshParams { error: ErrorBound::Metres(error), ..MeshParams::default() })
}

/// The wood simplified to so many triangles.
fn simplified(full: &Mesh, n_triangles: f64) -> Mesh {
    let share = n_triangles / triangles(full, &[0]).max(1.0);
    simplify(full, &[0], share, How::Simplify).mesh
}

fn triangles(mesh: &Mesh, surfaces: &[u32]) -> f64 {
    let of = |&s: &u32| mesh.surfaces.get(s as usize).map_or(0, Surface::n_triangles);
    surfaces.iter().map(of).sum::<usize>() as f64
}

fn built(table: &mut Table, case: &str, tree: &Tree, error: f32, full: &Mesh) -> Outcome {
    let (own_seconds, own) = fastest(|| coarse(tree, error))?;
    let wanted = triangles(&own, &[0]);
    let (seconds, mut theirs) = fastest(|| Ok(simplified(full, wanted)))?;
    // What was welded stays so: points that only come to lie at one place are not joined.
    if let ([from], [to]) = (&full.surfaces[..], &mut theirs.surfaces[..])
        && from.welds.len() == from.positions.len()
    {
        to.welds = (0..to.positions.len() as u32).collect();
    }
    let mut row = |metric, figures, unit, aim| beside(table, case, metric, figures, unit, aim);
    row("triangles of wood", [&theirs, &own].map(|mesh| triangles(mesh, &[0])), "", Aim::None);
    row("time for the level", [1e3 * seconds, 1e3 * own_seconds], "ms", Aim::AtMost(1e3 * seconds));
    let ([peer, peer_covers], [ours, covers]) = (looks(&theirs, full)?, looks(&own, full)?);
    row("Q against the full wood", [peer, ours], "", Aim::AtLeast(peer));
    row("share of its pixels covered", [peer_covers, covers], "", Aim::None);
    let surface = |mesh: &Mesh| mesh.surfaces.first().ok_or("no bark").map(Wood::of);
    Wood::rows(table, case, &surface(&theirs)??, &surface(&own)??);
    Ok(())
}

fn prefix(table: &mut Table, tree: &Tree) -> Outcome {
    let control = Control::default();
    let (make, prefixes) = fastest(|| {
        let multires = Multires::new(tree, &Metric::default(), &control)?;
        let look = Look::plain(tree.species());
        Ok(MultiMesh::new(&multires, &look, &MeshParams::default(), &control)?)
    })?;
    let full = prefixes.mesh();
    let level = prefixes.level_of_wood((PREFIX * triangles(full, &[0])) as u64) as f32;
    let own = prefixes.mesh_at(level)?;
    let (take, _) = fastest(|| Ok(black_box(prefixes.wood_indices(black_box(level)))))?;
    let (seconds, theirs) = fastest(|| Ok(simplified(full, triangles(&own, &[0]))))?;
    let case = format!("meshoptimizer, oak wood, prefix of {PREFIX}");
    let figures = [looks(&theirs, full)?[0], looks(&own, full)?[0]];
    let counts = [&theirs, &own].map(|mesh| triangles(mesh, &[0]));
    level_rows(table, &case, "triangles of wood", counts, [seconds, make, take], figures);
    Ok(())
}

/// On all threads.
pub(super) fn leaves(table: &mut Table) -> Outcome {
    let (tree, control) = (TREE.grow(true)?, Control::default());
    let full = mesh(&tree, &MeshParams::default())?;
    let foliage: Vec<u32> = (1..full.surfaces.len() as u32).collect();
    let make = || Ok(PrunedModel::make(&full, &MakeParams::default(), &control)?);
    let (make, model) = fastest(make)?;
    for share in SHARES {
        let simple = || Ok(simplify(&full, &foliage, share.into(), How::Simplify).mesh);
        let (seconds, theirs) = fastest(simple)?;
        let (take, _) = fastest(|| Ok(model.level(black_box(share))?))?;
        let own = model.mesh_at(share)?;
        let case = format!("meshoptimizer, oak leaf cards, {share} kept");
        let figures = [looks(&theirs, &full)?[0], looks(&own, &full)?[0]];
        let counts = [&theirs, &own].map(|mesh| triangles(mesh, &foliage));
        level_rows(table, &case, "triangles of leaves", counts, [seconds, make, take], figures);
    }
    Ok(())
}

/// Of levels that are made all at once: seconds of theirs, to make ours, to take a level of ours; and Q.
fn level_rows(
    table: &mut Table,
    case: &str,
    count: &str,
    counts: [f64; 2],
    [seconds, make, take]: [f64; 3],
    quality: [f64; 2],
) {
    let mut row = |metric, figures, unit, aim| beside(table, case, metric, figures, unit, aim);
    row(count, counts, "", Aim::None);
    row("time to make, ours all levels", [1e3 * seconds, 1e3 * make], "ms", Aim::None);
    row("time for a level", [1e6 * seconds, 1e6 * take], "µs", Aim::AtMost(1e6 * seconds));
    row("Q against the full mesh", quality, "", Aim::AtLeast(quality[0]));
}

/// How a level looks from views that neither was made with: Q, and the share of the full mesh's pixels it covers.
fn looks(level: &Mesh, full: &Mesh) -> Outcome<[f64; 2]> {
    let around = Around { turn: 0.3, ..Around::default() };
    let scores = score(level, full, &around.cameras(), around.size, &Control::default())?;
    let covered = scores.iter().map(Score::recall).sum::<f64>() / scores.len().max(1) as f64;
    Ok([mean_quality(&scores), covered])
}

/// Does what a case of [`peak_bytes`] names, if it is one of these.
pub(super) fn build_case(case: &str) -> Outcome<bool> {
    if ![OURS, THEIRS].contains(&case) {
        return Ok(false);
    }
    let tree = TREE.grow(false)?;
    if case == OURS {
        black_box(coarse(&tree, COARSE)?);
    } else {
        let full = mesh(&tree, &MeshParams::default())?;
        // About what ours has at that error.
        black_box(simplified(&full, 0.3 * triangles(&full, &[0])));
    }
    Ok(true)
}
