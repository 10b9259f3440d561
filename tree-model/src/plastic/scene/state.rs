//! What has become of a tree: how far its nodes moved and turned, and when they died.

use super::super::light::{Ball, DIRECTIONS, Light, Weights};
use super::super::plan::{Cluster, Plan};
use glam::{Quat, Vec3};

/// For nodes that live.
pub(in crate::plastic) const ALIVE: u16 = u16::MAX;

/// Clusters move in steps of this share of their radius: what sways by less casts the same shadow, so that an edit is felt as far as
/// it matters and not through the whole forest.
const STRIDE: f32 = 1.0 / 8.0;

/// Rows as in the plan.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::plastic) struct State {
    /// How far each node moved from where it was in the input, in the tree's own frame.
    pub moved: Vec<Vec3>,
    /// How far the segment below each node turned.
    pub turned: Vec<Quat>,
    /// Season in which each node died, [`ALIVE`] for those that did not.
    pub died: Vec<u16>,
    /// Whether the segment below each node runs into an obstacle.
    pub stopped: Vec<bool>,
    /// Whether any segment of each season does.
    pub stops: Vec<bool>,
    /// Light on each cluster of each season.
    pub lights: Vec<Light>,
    /// What its own and all other clusters let through to it.
    pub through: Vec<Weights>,
}

impl State {
    /// As the input was, with its clusters.
    pub(super) fn of_input(plan: &Plan) -> (Self, Vec<Ball>) {
        let n = plan.len();
        let state = Self {
            moved: vec![Vec3::ZERO; n],
            turned: vec![Quat::IDENTITY; n],
            died: vec![ALIVE; n],
            stopped: vec![false; n],
            stops: vec![false; plan.seasons.len()],
            lights: plan.clusters.iter().map(|cluster| cluster.light).collect(),
            through: vec![[1.0; DIRECTIONS]; plan.clusters.len()],
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

    /// Moves a cluster of season `t` with the branches that carry it: by the mean of how far its tips moved (section 5.2), tips
    /// that are yet to grow as if they stood fast on what is below. One that lost tips lets more light through (Eq. 13).
    pub(super) fn placed(&self, plan: &Plan, t: usize, cluster: &Cluster) -> Ball {
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
            return ball;
        }
        let stride = STRIDE * ball.radius;
        if stride > 0.0 {
            ball.center += (sum / (n as f32 * stride)).round() * stride;
        }
        if (n as usize) < members.len() {
            let share = n as f32 / members.len() as f32;
            ball.translucency = libm::powf(ball.translucency, share);
        }
        ball
    }
}
