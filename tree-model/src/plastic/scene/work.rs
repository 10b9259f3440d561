//! What goes with a tree during one update.

use super::super::analysis::PlasticTree;
use super::super::light::{Ball, Convex, may_shade};
use super::super::obstacle::Placed;
use super::super::plan::Plan;
use super::super::pose::Pose;
use super::super::shade::{Casters, LEAST};
use super::edit::Planted;
use super::step::{Changes, Scratch};
use glam::{Quat, Vec3};

/// What goes with a tree during one update, all of it in the tree's own frame.
#[derive(Default)]
pub(super) struct Work<'a> {
    /// Trees whose clusters may shade it.
    pub near: &'a [u32],
    pub changes: Changes,
    /// Clusters of the season it stands in that are not what they were, as they were and as they are now.
    pub stirred: Vec<Ball>,
    /// Whether each of the season's clusters is among them.
    pub own: Vec<bool>,
    /// What was shaded by trees that are gone or stood elsewhere.
    pub left: Vec<Ball>,
    /// Obstacles that moved, as they were and as they are now.
    pub shifted: Vec<Convex>,
    /// Those of them that it may touch or have touched, in the world.
    pub nudging: Vec<&'a Placed>,
    pub solids: Option<Solids<'a>>,
    /// Whether what other clusters let through to each of the season's is to be worked out.
    pub relit: Vec<bool>,
    pub casters: Casters,
    pub scratch: Scratch,
    /// Whether anything about it is not what it was.
    pub changed: bool,
    pub n_seasons: u32,
}

/// Obstacles around a tree.
pub(super) struct Solids<'a> {
    /// Those that may shade it, in its own frame.
    pub shading: Vec<Convex>,
    /// Those it may touch, in the world.
    pub touching: Vec<&'a Placed>,
}

impl<'a> Work<'a> {
    /// What edits since the last update mean for one tree.
    pub(super) fn new(
        tree: &Planted,
        near: &'a [u32],
        anew: bool,
        moved: &'a [Placed],
        left: &[Ball],
    ) -> Self {
        let (turn, offset) = into(tree.pose);
        let anew = anew || tree.anew;
        let mut work = Self { near, ..Self::default() };
        work.changes.anew = anew;
        if !anew {
            let place = |ball: &Ball| Ball { center: turn * ball.center + offset, ..*ball };
            work.left = left.iter().map(place).filter(|ball| felt(tree, ball)).collect();
            work.shifted = shading(tree, moved.iter());
            work.nudging = moved.iter().filter(|wall| touches(tree, wall)).collect();
        }
        work
    }

    /// Whether an edit concerns the tree itself.
    pub(super) fn disturbed(&self) -> bool {
        self.changes.anew
            || !self.nudging.is_empty()
            || !self.shifted.is_empty()
            || !self.left.is_empty()
    }

    /// Makes room for what changes, the first time anything does.
    pub(super) fn prepare(&mut self, tree: &Planted, walls: &[&'a Placed]) {
        if self.solids.is_none() {
            self.changes.rows.resize(tree.model.plan.len(), false);
            let touching = walls.iter().copied().filter(|wall| touches(tree, wall)).collect();
            let shading = shading(tree, walls.iter().copied());
            self.solids = Some(Solids { shading, touching });
        }
    }

    /// Moves the clusters of season `t` with the tree, and notes which of them are not what they were.
    pub(super) fn stir(&mut self, tree: &Planted, t: usize, balls: &mut [Ball]) {
        let plan: &Plan = &tree.model.plan;
        let clusters = plan.seasons[t].clusters.clone();
        self.stirred.clear();
        self.own.clear();
        self.own.resize(clusters.len(), false);
        if !self.changes.anew && !self.changes.any_row {
            return;
        }
        for (place, index) in clusters.enumerate() {
            let cluster = &plan.clusters[index];
            let members = &plan.members[cluster.members.clone()];
            let rows = &self.changes.rows;
            let concerned = |carrier: u32| rows.get(carrier as usize).is_some_and(|&row| row);
            let moved = self.changes.anew || members.iter().any(|member| concerned(member.carrier));
            let before = balls[index];
            let now = if moved { tree.state.placed(plan, t, cluster) } else { before };
            balls[index] = now;
            self.own[place] = now != before;
            // A tree that is worked out anew may be new in its place.
            if now != before || self.changes.anew {
                self.stirred.extend([before, now].into_iter().filter(|ball| ball.radius > 0.0));
            }
        }
    }
}

/// Turn and offset that take the world into the frame of what stands so.
pub(super) fn into(pose: Pose) -> (Quat, Vec3) {
    let turn = pose.rotation.conjugate();
    (turn, -(turn * pose.position))
}

/// Whether a ball, in the tree's frame, may shade any of its clusters.
pub(super) fn felt(tree: &Planted, ball: &Ball) -> bool {
    let model: &PlasticTree = &tree.model;
    may_shade(ball, &model.crown, tree.bins.brightest, LEAST)
}

/// The pieces of obstacles that may shade the tree, in its frame.
fn shading<'a>(tree: &Planted, placed: impl Iterator<Item = &'a Placed>) -> Vec<Convex> {
    let (turn, offset) = into(tree.pose);
    placed
        .flat_map(|placed| &placed.pieces)
        .map(|piece| piece.moved(turn, offset))
        .filter(|piece| piece.ball().is_none_or(|ball| felt(tree, &ball)))
        .collect()
}

/// Whether the tree may touch the obstacle, however it bends.
fn touches(tree: &Planted, placed: &Placed) -> bool {
    let around = tree.model.around;
    placed.near(tree.pose.to_world(around.center), around.radius)
}
