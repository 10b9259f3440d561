//! What all edits since the last update mean.

use super::super::analysis::PlasticTree;
use super::super::light::{Ball, Convex, may_shade};
use super::super::obstacle::Placed;
use super::super::params::Response;
use super::super::pose::Pose;
use super::super::shade::LEAST;
use super::edit::{Planted, Scene, TreeId};
use super::neighbours::neighbours;
use super::step::{Scratch, Surroundings, grow, shine};
use crate::error::Result;
use glam::{Quat, Vec3};
use rayon::prelude::*;
use std::sync::Arc;
use tree_core::Control;

/// What an update did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Update {
    /// Trees that are not what they were, or get another light.
    pub changed: Vec<TreeId>,
    /// Trees that were looked at.
    pub touched: u32,
    /// Seasons of trees whose light was worked out anew.
    pub seasons: u32,
}

/// What goes with a tree during one update.
struct Work {
    /// Trees whose clusters may shade it.
    near: Vec<u32>,
    /// Obstacles that may shade it, in its own frame.
    solids: Vec<Convex>,
    /// Clusters of other trees in this step, in its own frame.
    foreign: Vec<Ball>,
    scratch: Scratch,
    /// Whether its light must be worked out in every season.
    anew: bool,
    /// Whether its branches are not what they were in a season before this one.
    dirty: bool,
    /// Whether its clusters of this season are not what they were.
    stirred: bool,
    changed: bool,
    n_seasons: u32,
}

impl Scene {
    /// Works out what the edits since the last update mean, on as many threads as rayon has.
    ///
    /// # Errors
    /// Cancellation; trees are then half way, and the next update works all of them out anew.
    ///
    /// # Complexity
    /// For each tree that is touched: O(nodes · seasons), and for each cluster of each season O(clusters of its own and of
    /// neighbours, obstacles near). For all others O(clusters) for each obstacle that moved.
    pub fn update(&mut self, control: &Control) -> Result<Update> {
        control.check()?;
        let all = std::mem::replace(&mut self.all, true);
        let mut walls: Vec<&Placed> =
            self.obstacles.iter().map(|standing| &standing.placed).collect();
        walls.sort_by_key(|placed| placed.key());
        let (moved, left) = (&self.moved, &self.left);
        let mut works: Vec<Work> = self
            .trees
            .par_iter()
            .zip(neighbours(&self.trees, self.sky.brightest.normalize_or(Vec3::Y)))
            .map(|(tree, near)| {
                let anew = all || tree.anew || disturbed(tree, moved, left);
                Work::new(tree, near, &walls, anew)
            })
            .collect();
        // What a tree casts that is new in its place, its neighbours have never seen.
        let arrived: Vec<bool> = self.trees.iter().map(|tree| tree.anew).collect();
        for work in &mut works {
            work.anew |= work.near.iter().any(|&other| arrived[other as usize]);
        }
        let mut balls: Vec<Vec<Ball>> =
            self.trees.iter_mut().map(|tree| std::mem::take(&mut tree.balls)).collect();
        let outcome = run(&mut self.trees, &mut balls, &mut works, &walls, &self.response, control);
        for (tree, balls) in self.trees.iter_mut().zip(balls) {
            tree.balls = balls;
        }
        outcome?;
        self.all = false;
        self.moved.clear();
        self.left.clear();
        let mut update = Update::default();
        for (tree, work) in self.trees.iter_mut().zip(&works) {
            tree.anew = false;
            update.touched += u32::from(work.n_seasons > 0);
            update.seasons += work.n_seasons;
            if work.changed {
                update.changed.push(tree.id);
            }
        }
        Ok(update)
    }
}

/// Season after season: first clusters move with their trees, then all trees look at them.
fn run(
    trees: &mut [Planted],
    balls: &mut [Vec<Ball>],
    works: &mut [Work],
    walls: &[&Placed],
    response: &Response,
    control: &Control,
) -> Result<()> {
    let stands: Vec<(Arc<PlasticTree>, Pose)> =
        trees.iter().map(|tree| (tree.model.clone(), tree.pose)).collect();
    let n_steps = stands.iter().map(|(model, _)| model.plan.seasons.len()).max().unwrap_or(0);
    for step in 0..n_steps {
        control.report("seasons", step as f32 / n_steps as f32)?;
        for ((tree, own), work) in trees.iter().zip(balls.iter_mut()).zip(works.iter_mut()) {
            let clock = Clock::new(&tree.model, step, n_steps);
            if clock.first {
                work.stirred =
                    work.dirty && tree.state.move_clusters(&tree.model.plan, clock.t, own);
            }
        }
        let stirred: Vec<bool> = works.iter().map(|work| work.stirred).collect();
        let balls = &*balls;
        let stands = &stands;
        let live = |tree: &Planted, work: &Work| {
            Clock::new(&tree.model, step, n_steps).last
                && (work.anew
                    || work.dirty
                    || work.near.iter().any(|&other| stirred[other as usize]))
        };
        let mut busy: Vec<(usize, &mut Planted, &mut Work)> = trees
            .iter_mut()
            .zip(works.iter_mut())
            .enumerate()
            .filter(|(_, (tree, work))| live(tree, work))
            .map(|(index, (tree, work))| (index, tree, work))
            .collect();
        busy.par_iter_mut().for_each(|(index, tree, work)| {
            look(*index, tree, work, stands, balls, walls, response, step, n_steps);
        });
    }
    Ok(())
}

/// Where a tree stands in its life at a step, so that all end together (section 5.3).
struct Clock {
    t: usize,
    /// Whether its season begins with this step.
    first: bool,
    /// Whether its season ends with it.
    last: bool,
}

impl Clock {
    fn new(model: &PlasticTree, step: usize, n_steps: usize) -> Self {
        let n = model.plan.seasons.len();
        let season = |step: usize| step * n / n_steps;
        let t = season(step);
        Self { t, first: step == 0 || season(step - 1) != t, last: season(step + 1) != t }
    }
}

#[expect(clippy::too_many_arguments, reason = "one tree, and all there is around it")]
fn look(
    index: usize,
    tree: &mut Planted,
    work: &mut Work,
    stands: &[(Arc<PlasticTree>, Pose)],
    balls: &[Vec<Ball>],
    walls: &[&Placed],
    response: &Response,
    step: usize,
    n_steps: usize,
) {
    let model = tree.model.clone();
    let t = Clock::new(&model, step, n_steps).t;
    work.foreign.clear();
    for &other in &work.near {
        let (theirs, pose) = &stands[other as usize];
        let season = Clock::new(theirs, step, n_steps).t;
        for ball in &balls[other as usize][theirs.plan.seasons[season].clusters.clone()] {
            let ball = Ball { center: tree.pose.to_local(pose.to_world(ball.center)), ..*ball };
            if may_shade(&ball, &model.around, tree.bins.brightest, LEAST) {
                work.foreign.push(ball);
            }
        }
    }
    let center = tree.pose.to_world(model.around.center);
    let touching: Vec<&Placed> =
        walls.iter().copied().filter(|wall| wall.near(center, model.around.radius)).collect();
    let around = Surroundings {
        bins: &tree.bins,
        pose: tree.pose,
        response,
        solids: &work.solids,
        walls: &touching,
    };
    work.n_seasons += 1;
    let lit = shine(&model.plan, t, &mut tree.state, &balls[index], &work.foreign, &around);
    work.changed |= lit;
    if lit || work.anew || work.dirty {
        let grown =
            grow(&model.plan, t, &mut tree.state, &balls[index], &around, &mut work.scratch);
        work.dirty |= grown;
        work.dirty |= grown;
        work.changed |= grown;
    }
}

/// Whether a change of obstacles, or trees that left, may be felt by any cluster of the tree, or by its wood.
fn disturbed(tree: &Planted, moved: &[Placed], left: &[Ball]) -> bool {
    let around = tree.model.around;
    let felt = |solid: Convex| {
        solid.ball().is_none_or(|ball| may_shade(&ball, &around, tree.bins.brightest, LEAST))
            && tree
                .balls
                .iter()
                .any(|own| own.radius > 0.0 && solid.influence(own.center, &tree.bins) > LEAST)
    };
    let (turn, offset) = into(tree.pose);
    let reached = |placed: &Placed| {
        placed.near(tree.pose.to_world(around.center), around.radius)
            || placed.pieces.iter().any(|piece| felt(piece.moved(turn, offset)))
    };
    moved.iter().any(reached)
        || left.iter().any(|ball| felt(Convex::Ball(*ball).moved(turn, offset)))
}

/// Turn and offset that take the world into the frame of what stands so.
fn into(pose: Pose) -> (Quat, Vec3) {
    let turn = pose.rotation.conjugate();
    (turn, -(turn * pose.position))
}

impl Work {
    fn new(tree: &Planted, near: Vec<u32>, walls: &[&Placed], anew: bool) -> Self {
        let (turn, offset) = into(tree.pose);
        let around = tree.model.around;
        let solids = walls
            .iter()
            .flat_map(|wall| &wall.pieces)
            .map(|piece| piece.moved(turn, offset))
            .filter(|piece| {
                piece
                    .ball()
                    .is_none_or(|ball| may_shade(&ball, &around, tree.bins.brightest, LEAST))
            })
            .collect();
        Self {
            near,
            solids,
            foreign: Vec::new(),
            scratch: Scratch::default(),
            anew,
            dirty: false,
            stirred: false,
            changed: false,
            n_seasons: 0,
        }
    }
}
