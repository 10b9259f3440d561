//! Which branches starve (Pirk et al. 2012, section 4.4).
//!
//! A branch lives on the light its leaf clusters gather, 2 π r² i each (Eq. 10), and must keep up its length. On
//! how little it can live, nobody knows; but it lived through its own past, and so did the others (Eq. 11).
//!
//! Departures: a cluster that spans several branches is shared out evenly over its tips. Branches are judged from the tips
//! down, and what dies is a burden no more to what carries it. The trunk is never pruned.

use super::light::Ball;
use super::plan::Plan;
use std::f32::consts::TAU;

/// What each row gathers and keeps up in one season; scratch that is used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Balance {
    pub gathered: Vec<f32>,
    pub length: Vec<f32>,
}

impl Balance {
    /// Gives the tips of season `t` their share of the light. `ball_and_amount` tells of each cluster of the season, by its place
    /// in it; `alive` of each row.
    pub(super) fn start(
        &mut self,
        plan: &Plan,
        t: usize,
        ball_and_amount: impl Fn(usize) -> (Ball, f32),
        alive: impl Fn(usize) -> bool,
    ) {
        let end = plan.seasons[t].nodes.end;
        self.gathered.clear();
        self.gathered.resize(end, 0.0);
        self.length.clear();
        self.length.extend_from_slice(&plan.length[..end]);
        for (place, cluster) in plan.clusters[plan.seasons[t].clusters.clone()].iter().enumerate() {
            let (ball, amount) = ball_and_amount(place);
            let members = &plan.members[cluster.members.clone()];
            let share = TAU * ball.radius * ball.radius * amount / members.len() as f32;
            for member in members {
                if alive(member.tip as usize) {
                    self.gathered[member.tip as usize] = share;
                }
            }
        }
    }
}

/// Finds for every branch on how little light per length it lived in the worst season, or the fifth percentile of all branches
/// and seasons where that is less. `on_trunk` tells of each main node. O(nodes · seasons).
pub(super) fn estimate(plan: &mut Plan, on_trunk: impl Fn(u32) -> bool) {
    let n = plan.len();
    let mut n_children = vec![0_u32; n];
    for row in 1..n {
        n_children[plan.parent[row] as usize] += 1;
    }
    let starts: Vec<bool> = (0..n)
        .map(|row| {
            row > 0 && n_children[plan.parent[row] as usize] > 1 && !on_trunk(plan.main[row])
        })
        .collect();
    let mut least = vec![f32::INFINITY; n];
    let mut all = Vec::new();
    let mut balance = Balance::default();
    for t in 0..plan.seasons.len() {
        let clusters = &plan.clusters[plan.seasons[t].clusters.clone()];
        balance.start(
            plan,
            t,
            |place| (clusters[place].ball, clusters[place].light.amount),
            |_| true,
        );
        for row in (1..plan.seasons[t].nodes.end).rev() {
            let (gathered, length) = (balance.gathered[row], balance.length[row]);
            let below = plan.parent[row] as usize;
            balance.gathered[below] += gathered;
            balance.length[below] += length;
            if starts[row] && length > 0.0 {
                let factor = gathered / length;
                least[row] = least[row].min(factor);
                all.push(factor);
            }
        }
    }
    all.sort_by(f32::total_cmp);
    let reference = all.get(all.len() / 20).copied().unwrap_or(0.0);
    plan.starved =
        (0..n).map(|row| if starts[row] { least[row].min(reference) } else { -1.0 }).collect();
}
