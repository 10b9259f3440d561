//! What all edits since the last update mean.

use super::super::analysis::PlasticTree;
use super::super::light::{Ball, Light};
use super::super::obstacle::Placed;
use super::super::params::Response;
use super::super::pose::Pose;
use super::super::shade::{LEAST, reaches, veil_solids};
use super::edit::{Planted, Scene, TreeId};
use super::neighbours::neighbours;
use super::step::{Surroundings, grow};
use super::work::{Work, felt};
use crate::error::Result;
use glam::{Mat3, Vec3};
use rayon::prelude::*;
use std::sync::Arc;
use tree_core::Control;

/// What an update did.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Update {
    /// Trees that are not what they were, or get another light.
    pub changed: Vec<TreeId>,
    /// Trees that were looked at.
    pub touched: u32,
    /// Seasons of trees whose light was worked out anew.
    pub seasons: u32,
}

impl Scene {
    /// Works out what the edits since the last update mean, on as many threads as rayon has.
    ///
    /// # Errors
    /// Cancellation; trees are then half way, and the next update works all of them out anew.
    ///
    /// # Complexity
    /// For each tree that an edit reaches: O(nodes + clusters · obstacles near) in each season, and O(clusters of its own and of
    /// neighbours) for each cluster that one of them, or its own place, has changed for. O(1) for all others.
    pub fn update(&mut self, control: &Control) -> Result<Update> {
        control.check()?;
        let all = std::mem::replace(&mut self.all, true);
        let mut walls: Vec<&Placed> =
            self.obstacles.iter().map(|standing| &standing.placed).collect();
        walls.sort_by_key(|placed| placed.key());
        let towards = self.sky.light.normalize_or(Vec3::Y);
        let near = self.near.get_or_insert_with(|| neighbours(&self.trees, towards));
        let mut works: Vec<Work<'_>> = self
            .trees
            .iter()
            .zip(near.iter())
            .map(|(tree, near)| Work::new(tree, near, all, &self.moved, &self.left))
            .collect();
        let mut balls: Vec<Vec<Ball>> =
            self.trees.iter_mut().map(|tree| std::mem::take(&mut tree.balls)).collect();
        let (trees, response) = (&mut self.trees, &self.response);
        let outcome = if trees.len() > 1 {
            // Once into the pool, not in every season.
            rayon::scope(|_| run(trees, &mut balls, &mut works, &walls, response, control))
        } else {
            run(trees, &mut balls, &mut works, &walls, response, control)
        };
        let mut update = Update::default();
        for (tree, work) in self.trees.iter().zip(&works) {
            update.touched += u32::from(work.n_seasons > 0);
            update.seasons += work.n_seasons;
            if work.changed {
                update.changed.push(tree.id);
            }
        }
        for (tree, balls) in self.trees.iter_mut().zip(balls) {
            tree.balls = balls;
            tree.anew &= outcome.is_err();
        }
        outcome?;
        self.all = false;
        self.moved.clear();
        self.left.clear();
        Ok(update)
    }
}

/// Season after season: first clusters move with their trees, then all trees look at them.
fn run<'a>(
    trees: &mut [Planted],
    balls: &mut [Vec<Ball>],
    works: &mut [Work<'a>],
    walls: &[&'a Placed],
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
                work.stir(tree, clock.t, own);
            }
        }
        let stirred: Vec<Vec<Ball>> =
            works.iter_mut().map(|work| std::mem::take(&mut work.stirred)).collect();
        let crowd = Crowd { stands: &stands, balls, stirred: &stirred, step, n_steps };
        let live = |tree: &Planted, work: &Work<'_>| {
            Clock::new(&tree.model, step, n_steps).last
                && (work.disturbed()
                    || work.changes.any_row
                    || work.near.iter().any(|&other| !stirred[other as usize].is_empty()))
        };
        let mut busy: Vec<(usize, &mut Planted, &mut Work<'a>)> = trees
            .iter_mut()
            .zip(works.iter_mut())
            .enumerate()
            .filter(|(_, (tree, work))| live(tree, work))
            .map(|(index, (tree, work))| (index, tree, work))
            .collect();
        let look = |(index, tree, work): &mut (usize, &mut Planted, &mut Work<'a>)| {
            work.prepare(tree, walls);
            look(*index, tree, work, &crowd, response);
        };
        if busy.len() > 1 {
            busy.par_iter_mut().for_each(look);
        } else {
            busy.iter_mut().for_each(look);
        }
        for (work, stirred) in works.iter_mut().zip(stirred) {
            work.stirred = stirred;
        }
    }
    Ok(())
}

/// All trees at a step, as each sees the others.
struct Crowd<'a> {
    stands: &'a [(Arc<PlasticTree>, Pose)],
    balls: &'a [Vec<Ball>],
    /// Of each tree, in its own frame, the clusters that are not what they were.
    stirred: &'a [Vec<Ball>],
    step: usize,
    n_steps: usize,
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

/// A tree's season: light, and what it does to the tree.
fn look(
    index: usize,
    tree: &mut Planted,
    work: &mut Work<'_>,
    crowd: &Crowd<'_>,
    response: &Response,
) {
    let model = tree.model.clone();
    let t = Clock::new(&model, crowd.step, crowd.n_steps).t;
    let balls = &crowd.balls[index];
    let lit = shine(index, tree, work, crowd, t);
    work.changed |= lit;
    if lit || work.changes.anew || work.changes.any_row || !work.nudging.is_empty() {
        let touching = work.solids.as_ref().map_or(&[][..], |solids| &solids.touching);
        let around = Surroundings {
            bins: &tree.bins,
            pose: tree.pose,
            response,
            walls: touching,
            shifted: &work.nudging,
        };
        let (changes, scratch) = (&mut work.changes, &mut work.scratch);
        grow(&model.plan, t, &mut tree.state, balls, &around, changes, scratch);
        work.changed |= work.changes.any_row;
    }
}

/// Works out the light on those clusters of season `t` for which anything has changed. Returns whether any is not what it was.
fn shine(
    index: usize,
    tree: &mut Planted,
    work: &mut Work<'_>,
    crowd: &Crowd<'_>,
    t: usize,
) -> bool {
    let clusters = tree.model.plan.seasons[t].clusters.clone();
    let own = &crowd.balls[index][clusters.clone()];
    work.n_seasons += 1;
    work.find_relit(index, tree, own, crowd);
    if work.relit.contains(&true) {
        work.casters.clear();
        own.iter().for_each(|ball| work.casters.push(ball));
        for &other in work.near {
            let casters = &mut work.casters;
            crowd.each(crowd.clusters(other), other, tree, |ball| casters.push(&ball));
        }
    }
    let shading = work.solids.as_ref().map_or(&[][..], |solids| &solids.shading);
    work.changes.amounts = false;
    work.changes.lit.clear();
    work.changes.lit.resize(clusters.len(), false);
    let (bins, state) = (&tree.bins, &mut tree.state);
    for (place, cluster) in clusters.enumerate() {
        let Ball { center: at, radius, .. } = own[place];
        let relit = work.relit[place];
        if !relit && !work.shifted.iter().any(|solid| solid.influence(at, bins) > LEAST) {
            continue;
        }
        let mut light = Light::default();
        if radius > 0.0 {
            if relit {
                state.through[cluster] = work.casters.through(at, place, bins);
            }
            let mut through = state.through[cluster];
            veil_solids(shading, at, bins, &mut through);
            light = Light::gather(bins, &through);
        }
        let before = std::mem::replace(&mut state.lights[cluster], light);
        work.changes.lit[place] = light != before;
        work.changes.amounts |= light.amount != before.amount;
    }
    work.changes.lit.contains(&true)
}

impl Work<'_> {
    /// Marks the clusters to which something else than before lets light through.
    fn find_relit(&mut self, index: usize, tree: &Planted, own: &[Ball], crowd: &Crowd<'_>) {
        self.relit.clear();
        self.relit.resize(own.len(), self.changes.anew);
        if self.changes.anew {
            return;
        }
        let mut stirred = self.left.clone();
        stirred.extend_from_slice(&crowd.stirred[index]);
        for &other in self.near {
            crowd.each(&crowd.stirred[other as usize], other, tree, |ball| {
                if felt(tree, &ball) {
                    stirred.push(ball);
                }
            });
        }
        let towards = tree.bins.brightest;
        for ((relit, ball), &moved) in self.relit.iter_mut().zip(own).zip(&self.own) {
            *relit = moved || stirred.iter().any(|other| reaches(other, ball.center, towards));
        }
    }
}

impl Crowd<'_> {
    /// The clusters of a tree in the season it stands in, in its own frame.
    fn clusters(&self, tree: u32) -> &[Ball] {
        let (model, _) = &self.stands[tree as usize];
        let season = Clock::new(model, self.step, self.n_steps).t;
        &self.balls[tree as usize][model.plan.seasons[season].clusters.clone()]
    }

    /// Hands on balls of tree `other` in the frame of `tree`.
    fn each(&self, balls: &[Ball], other: u32, tree: &Planted, mut take: impl FnMut(Ball)) {
        let pose = self.stands[other as usize].1;
        let turn = Mat3::from_quat(tree.pose.rotation.conjugate() * pose.rotation);
        let offset = tree.pose.to_local(pose.position);
        for ball in balls {
            take(Ball { center: turn * ball.center + offset, ..*ball });
        }
    }
}
