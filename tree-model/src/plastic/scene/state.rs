//! What has become of a tree: how far its nodes moved and turned, and when they died.

use super::super::light::{Ball, Light};
use super::super::plan::Plan;
use glam::{Quat, Vec3};

/// For nodes that live.
pub(in crate::plastic) const ALIVE: u16 = u16::MAX;

/// Rows as in the plan.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::plastic) struct State {
    /// How far each node moved from where it was in the input, in the tree's own frame.
    pub moved: Vec<Vec3>,
    /// How far the segment below each node turned.
    pub turned: Vec<Quat>,
    /// Season in which each node died, [`ALIVE`] for those that did not.
    pub died: Vec<u16>,
    /// Light on each cluster of each season.
    pub lights: Vec<Light>,
}

impl State {
    /// As the input was, with its clusters.
    pub(super) fn of_input(plan: &Plan) -> (Self, Vec<Ball>) {
        let n = plan.len();
        let state = Self {
            moved: vec![Vec3::ZERO; n],
            turned: vec![Quat::IDENTITY; n],
            died: vec![ALIVE; n],
            lights: plan.clusters.iter().map(|cluster| cluster.light).collect(),
        };
        (state, plan.clusters.iter().map(|cluster| cluster.ball).collect())
    }

    /// Whether the node lived when season `t` began.
    pub(super) fn lived(&self, row: usize, t: usize) -> bool {
        usize::from(self.died[row]) >= t
    }

    /// Whether the node outlived season `t`.
    pub(super) fn outlived(&self, row: usize, t: usize) -> bool {
        usize::from(self.died[row]) > t
    }

    /// Moves the clusters of season `t` with the branches that carry them: by the mean of how far its tips moved (section 5.2), tips
    /// that are yet to grow as if they stood fast on what is below. Those that lost tips let more light through (Eq. 13).
    /// Returns whether any cluster is not what it was.
    pub(super) fn move_clusters(&self, plan: &Plan, t: usize, balls: &mut [Ball]) -> bool {
        let mut changed = false;
        for index in plan.seasons[t].clusters.clone() {
            let cluster = &plan.clusters[index];
            let members = &plan.members[cluster.members.clone()];
            let (mut sum, mut n) = (Vec3::ZERO, 0_u32);
            for member in members {
                let carrier = member.carrier as usize;
                if self.lived(carrier, t) {
                    let offset = member.offset;
                    sum += self.moved[carrier] + (self.turned[carrier] * offset - offset);
                    n += 1;
                }
            }
            let mut ball = cluster.ball;
            if n == 0 {
                ball.radius = 0.0;
            } else {
                ball.center += sum / n as f32;
                if (n as usize) < members.len() {
                    let share = n as f32 / members.len() as f32;
                    ball.translucency = libm::powf(ball.translucency, share);
                }
            }
            changed |= ball != balls[index];
            balls[index] = ball;
        }
        changed
    }
}
