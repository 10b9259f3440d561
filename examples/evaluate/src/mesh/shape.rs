//! Whether bark is closed, and how often it crosses itself.

use super::{Outcome, skeletons};
use crate::table::{Aim, Row, Table};
use std::path::Path;
use tree_core::swc::{self, SwcOptions, UnknownRadius};
use tree_core::{Control, Limits, Seed, Skeleton, Species, Tree};
use tree_mesh::topology::{Crossings, examine, self_intersections};
use tree_mesh::wind::Branch;
use tree_mesh::{Look, Mesh, MeshParams, build};
use tree_model::path::PRESETS;

/// Random skeletons of each kind.
const RANDOM: u64 = 1000;
/// What the issue allows on dense input, per cent of faces.
const CROSSING_FACES: f64 = 2.0;
/// PEERS.md: modular-tree's pine, its best in this column of all that were measured, and its holes.
const PEER_CROSSING_FACES: f64 = 5.3;
const PEER_OPEN_EDGES: f64 = 15_794.0 + 488.0;
/// Presets that are conifers.
const CONIFERS: [&str; 4] = ["e", "g", "j", "l"];

/// What is expected of an input.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// No crossing at junctions.
    Tame,
    /// Few crossing faces.
    Dense,
    /// Closed, and nothing else.
    Nasty,
}

/// Sums over the trees of a case.
#[derive(Default)]
struct Sum {
    trees: u64,
    closed: u64,
    open_edges: u64,
    triangles: u64,
    flat: u64,
    branches: u64,
    at_junctions: u64,
    elsewhere: u64,
    crossing: u64,
}

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    for preset in PRESETS {
        let grown = preset.params()?.grow(Seed(3), &Control::default())?;
        let dense = CONIFERS.contains(&preset.name());
        let case = format!("preset {}", preset.name());
        let kind = if dense { Kind::Dense } else { Kind::Tame };
        rows(table, &case, kind, &Sum::of([grown.tree.skeleton().clone()])?);
    }
    let all = |make: fn(Seed) -> Skeleton| Sum::of((0..RANDOM).map(|seed| make(Seed(seed))));
    rows(table, "fork ladder", Kind::Tame, &Sum::of([skeletons::ladder(200)])?);
    rows(table, "whorls of 5", Kind::Tame, &Sum::of([skeletons::whorls(30, 5, 6)])?);
    rows(table, "1000 random tame skeletons", Kind::Tame, &all(skeletons::tame)?);
    rows(table, "1000 random nasty skeletons", Kind::Nasty, &all(skeletons::nasty)?);
    rows(table, "dense pine, whorls of 9", Kind::Dense, &Sum::of([skeletons::pine(40)])?);
    for name in ["cherry_plantscan3d.swc", "puu1_reference.swc"] {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/skeletons").join(name);
        if !path.exists() {
            eprintln!("{name}: not there, left out");
            continue;
        }
        let unknown_radius = UnknownRadius::Interpolate;
        let options = SwcOptions { unknown_radius, ..SwcOptions::default() };
        let import = swc::read_file(&path, &options, &Limits::default())?;
        rows(table, name, Kind::Dense, &Sum::of([import.skeleton])?);
    }
    Ok(())
}

impl Sum {
    fn of(skeletons: impl IntoIterator<Item = Skeleton>) -> Outcome<Self> {
        let mut sum = Self::default();
        let control = Control::default();
        for skeleton in skeletons {
            let tree = Tree::bare(skeleton, Species::default());
            let look = Look::plain(tree.species());
            let mesh = build(&tree, &look, &MeshParams::default(), &control)?.mesh;
            let Some(surface) = mesh.surfaces.first() else { continue };
            let found = examine(surface)?;
            let one = found.is_closed() && found.euler() == 2 && found.components == 1;
            let crossings = self_intersections(surface, &control)?;
            sum.trees += 1;
            sum.closed += u64::from(one || found.n_triangles == 0);
            sum.open_edges +=
                found.boundary_edges + found.non_manifold_edges + found.misoriented_edges;
            sum.triangles += found.n_triangles;
            sum.flat += found.flat_triangles;
            sum.branches += mesh.branches.len() as u64;
            sum.crossing += crossings.n_triangles;
            let (near, far) = sort(&mesh, &crossings);
            sum.at_junctions += near;
            sum.elsewhere += far;
        }
        Ok(sum)
    }
}

/// Crossing pairs of one branch, of a branch and its parent, or of two at one fork; and all others:
/// branches that meet somewhere in the crown. All count as the first where branches are unknown.
fn sort(mesh: &Mesh, crossings: &Crossings) -> (u64, u64) {
    let pairs = || crossings.pairs.iter().chain(&crossings.pairs_at_points);
    let Some(surface) = mesh.surfaces.first().filter(|surface| !surface.branches.is_empty()) else {
        return (pairs().count() as u64, 0);
    };
    let related = |a: u32, b: u32| {
        let at = |i: u32| mesh.branches.get(i as usize);
        match (at(a), at(b)) {
            (Some(one), Some(other)) => {
                a == b || one.parent == b || other.parent == a || siblings(one, other)
            }
            _ => true,
        }
    };
    let corners = |t: u32| {
        let first = 3 * t as usize;
        surface.indices[first..first + 3].iter().map(|&v| surface.branches[v as usize])
    };
    let near = pairs()
        .filter(|&&[a, b]| corners(a).any(|one| corners(b).any(|other| related(one, other))))
        .count();
    (near as u64, (pairs().count() - near) as u64)
}

fn siblings(one: &Branch, other: &Branch) -> bool {
    one.parent == other.parent && one.pivot == other.pivot
}

fn rows(table: &mut Table, case: &str, kind: Kind, sum: &Sum) {
    let mut figure = |metric, peer, ours, unit, aim| {
        table.row(&Row { case, metric, paper: None, peer, ours, unit, aim });
    };
    let closed = 100.0 * sum.closed as f64 / sum.trees.max(1) as f64;
    figure("closed, in one piece", None, closed, "% of trees", Aim::AtLeast(100.0));
    let peer = (kind == Kind::Dense).then_some(PEER_OPEN_EDGES);
    figure("open and non-manifold edges", peer, sum.open_edges as f64, "edges", Aim::AtMost(0.0));
    figure("triangles without area", None, sum.flat as f64, "triangles", Aim::AtMost(0.0));
    let per_1000 = |pairs: u64| 1000.0 * pairs as f64 / sum.branches.max(1) as f64;
    let aim = if kind == Kind::Tame { Aim::AtMost(0.0) } else { Aim::None };
    figure("crossing pairs at junctions", None, per_1000(sum.at_junctions), "/1000 br.", aim);
    figure("crossing pairs elsewhere", None, per_1000(sum.elsewhere), "/1000 br.", Aim::None);
    let (peer, aim) = match kind {
        Kind::Dense => (Some(PEER_CROSSING_FACES), Aim::AtMost(CROSSING_FACES)),
        _ => (None, Aim::None),
    };
    let share = 100.0 * sum.crossing as f64 / sum.triangles.max(1) as f64;
    figure("self-intersecting faces", peer, share, "%", aim);
}
