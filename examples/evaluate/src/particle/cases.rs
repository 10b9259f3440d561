//! One case: photographs of a tree, and five trees of them.

use super::score::{Score, dressed, score, seen};
use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_core::{Control, Seed, Tree};
use tree_mesh::Look;
use tree_model::glam::Vec2;
use tree_model::particle::attractor::AttractorGraph;
use tree_model::particle::session::{PhotoParams, Session, Shot};
use tree_model::particle::{Camera, Matte, View};

/// Seeds of the trees made in each case.
pub(super) const SEEDS: [u64; 5] = [1, 2, 3, 4, 5];
/// A branch is thick when its radius is at least this share of the trunk's.
const THICK: f32 = 0.25;

/// A case that has been grown: everything that is measured.
pub(super) struct Grown {
    pub(super) trees: Vec<Tree>,
    /// What each tree covers in a further view, if there is one.
    pub(super) between: Vec<Matte>,
    /// Scores of each view, of each tree.
    pub(super) scores: Vec<Vec<Score>>,
    /// Mean distance of thick branches to the attractors in all views, in heights; the worst tree.
    pub(super) distance: f64,
    /// How many of the trees differ from all before.
    pub(super) different: usize,
}

/// Grows five trees of the shots and measures them, from `between` as well.
pub(super) fn grow(
    shots: Vec<Shot>,
    params: &PhotoParams,
    between: Option<&Camera>,
) -> Result<Grown, Box<dyn Error>> {
    let control = Control::default();
    let mut session = Session::new(shots, params.clone(), Seed(SEEDS[0]))?;
    let views = session.views(&control)?.to_vec();
    let graphs = session.attractors(&control)?.to_vec();
    let (mut trees, mut unseen, mut distance) = (Vec::<Tree>::new(), Vec::new(), 0.0_f64);
    let mut scores = vec![Vec::new(); views.len()];
    let mut different = 0;
    let look = Look::built_in(session.tree(&control)?.tree.species())?;
    for seed in SEEDS {
        session.set_seed(Seed(seed));
        let tree = session.tree(&control)?.tree.clone();
        let mesh = dressed(&tree, &look, &control)?;
        for (view, scores) in views.iter().zip(&mut scores) {
            scores.push(score(&seen(&mesh, &view.camera, &control)?, &view.matte));
        }
        distance = distance.max(branch_distance(&tree, &views, &graphs));
        let new = trees.iter().all(|other| {
            let leaves = |tree: &Tree| tree.foliage().positions().to_vec();
            other.skeleton().positions() != tree.skeleton().positions()
                && (tree.foliage().is_empty() || leaves(other) != leaves(&tree))
        });
        different += usize::from(new);
        trees.push(tree);
        if let Some(camera) = between {
            unseen.push(seen(&mesh, camera, &control)?);
        }
    }
    Ok(Grown { trees, between: unseen, scores, distance, different })
}

impl Grown {
    /// The rows that photographs and synthetic pairs have in common.
    pub(super) fn rows(&self, table: &mut Table, case: &str, names: &[String], f1: f64) {
        for (scores, name) in self.scores.iter().zip(names) {
            let case = format!("{case}, {name}");
            // The worst of the five trees stands for them.
            let worst = scores.iter().copied().min_by(|a, b| a.f1().total_cmp(&b.f1()));
            let worst = worst.unwrap_or_default();
            for (metric, ours, aim) in [
                ("precision", worst.precision, Aim::None),
                ("recall", worst.recall, Aim::None),
                ("F1, worst of 5 seeds", worst.f1(), Aim::AtLeast(f1)),
            ] {
                let (paper, peer, unit) = (None, None, "");
                table.row(&Row { case: &case, metric, paper, peer, ours, unit, aim });
            }
        }
        for (metric, ours, unit, aim) in [
            ("thick branches to attractor", 100.0 * self.distance, "% height", Aim::AtMost(2.0)),
            ("different trees", self.different as f64, "of 5", Aim::AtLeast(5.0)),
        ] {
            let (paper, peer) = (None, None);
            table.row(&Row { case, metric, paper, peer, ours, unit, aim });
        }
    }
}

/// Mean distance of the nodes of thick branches to the attractor graphs, as a share of the tree's height.
fn branch_distance(tree: &Tree, views: &[View], graphs: &[AttractorGraph]) -> f64 {
    let skeleton = tree.skeleton();
    let thick = THICK * skeleton.radii()[0];
    let height = skeleton.bounds().max.y;
    let (mut sum, mut n) = (0.0_f64, 0_u32);
    for (view, graph) in views.iter().zip(graphs).filter(|(_, graph)| !graph.is_empty()) {
        let projector = view.camera.projector();
        for (&point, &radius) in skeleton.positions().iter().zip(skeleton.radii()) {
            if radius < thick {
                continue;
            }
            if let Some(pixel) = projector.project(point) {
                let distance = graph
                    .segments()
                    .map(|(a, b)| to_segment(pixel, a, b))
                    .fold(f32::INFINITY, f32::min);
                sum += f64::from(distance * view.camera.scale / height);
                n += 1;
            }
        }
    }
    sum / f64::from(n.max(1))
}

fn to_segment(point: Vec2, a: Vec2, b: Vec2) -> f32 {
    let along = b - a;
    let share = (point - a).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    point.distance(a + share.clamp(0.0, 1.0) * along)
}
