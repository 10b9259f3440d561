//! One season of one tree: light, bending, pruning.

use super::super::light::{Ball, Bins, Convex, Light};
use super::super::obstacle::Placed;
use super::super::params::Response;
use super::super::plan::Plan;
use super::super::pose::Pose;
use super::super::prune::Balance;
use super::super::shade::{Casters, light_at};
use super::super::tropism::bend;
use super::state::{ALIVE, State};
use glam::{Quat, Vec3};

/// What a tree meets.
pub(super) struct Surroundings<'a> {
    pub bins: &'a Bins,
    pub pose: Pose,
    pub response: &'a Response,
    /// Obstacles in the tree's own frame.
    pub solids: &'a [Convex],
    /// Obstacles that the tree may touch.
    pub walls: &'a [&'a Placed],
}

/// Scratch that is used again.
#[derive(Default)]
pub(super) struct Scratch {
    balance: Balance,
    died: Vec<u16>,
}

/// Works out the light on the clusters of season `t`. Returns whether any is not what it was.
pub(super) fn shine(
    plan: &Plan,
    t: usize,
    state: &mut State,
    own: &[Ball],
    foreign: &[Ball],
    around: &Surroundings<'_>,
) -> bool {
    let clusters = plan.seasons[t].clusters.clone();
    let casters = Casters { own: &own[clusters.clone()], foreign, solids: around.solids };
    let mut changed = false;
    for (place, index) in clusters.enumerate() {
        let light = if casters.own[place].radius > 0.0 {
            light_at(place, &casters, around.bins)
        } else {
            Light::default()
        };
        changed |= light != state.lights[index];
        state.lights[index] = light;
    }
    changed
}

/// Grows the segments of season `t` and prunes what starves. Returns whether the tree is not what it was.
pub(super) fn grow(
    plan: &Plan,
    t: usize,
    state: &mut State,
    balls: &[Ball],
    around: &Surroundings<'_>,
    scratch: &mut Scratch,
) -> bool {
    let end = plan.seasons[t].nodes.end;
    scratch.died.clear();
    scratch.died.extend_from_slice(&state.died[..end]);
    for died in &mut state.died[..end] {
        if usize::from(*died) == t {
            *died = ALIVE;
        }
    }
    let mut changed = bend_season(plan, t, state, around);
    starve(plan, t, state, balls, around.response.pruning, &mut scratch.balance);
    changed |= state.died[..end] != scratch.died[..];
    changed
}

fn bend_season(plan: &Plan, t: usize, state: &mut State, around: &Surroundings<'_>) -> bool {
    let up = around.bins.up;
    let season = t as u16;
    let mut changed = false;
    for row in plan.seasons[t].nodes.clone() {
        if row == 0 {
            continue;
        }
        let below = plan.parent[row] as usize;
        let dead = !state.outlived(below, t);
        let turned = if dead {
            state.turned[below]
        } else {
            turn(
                plan,
                row,
                state.turned[below],
                state.lights[plan.lit_by[row] as usize],
                up,
                around.response.bending,
            )
        };
        let segment = plan.segment[row];
        let moved = state.moved[below] + (turned * segment - segment);
        changed |= moved != state.moved[row] || turned != state.turned[row];
        state.moved[row] = moved;
        state.turned[row] = turned;
        let blocked = || {
            let from = around.pose.to_world(plan.position[below] + state.moved[below]);
            let to = around.pose.to_world(plan.position[row] + moved);
            around.walls.iter().any(|wall| wall.meets(from, to))
        };
        state.died[row] = if dead || (!around.walls.is_empty() && blocked()) {
            season
        } else {
            // A death in a later season stands until that season is looked at again.
            if state.outlived(row, t) { state.died[row] } else { ALIVE }
        };
    }
    changed
}

/// How far the segment below `row` turns, all in all, where what is below it turned by `below` (section 5.1).
fn turn(plan: &Plan, row: usize, below: Quat, light: Light, up: Vec3, bending: f32) -> Quat {
    let as_it_was = light.direction == plan.clusters[plan.lit_by[row] as usize].light.direction
        && up == Vec3::Y;
    if (as_it_was && below == Quat::IDENTITY) || bending == 0.0 {
        return below;
    }
    let rigid = below * plan.direction[row];
    let tropism = plan.tropisms.combined(light.direction, up);
    let Some(bent) = bend(below * plan.own[row], plan.weight[row], tropism).try_normalize() else {
        return below;
    };
    let Some(to) = rigid.lerp(bent, bending).try_normalize() else { return below };
    (Quat::from_rotation_arc(rigid, to) * below).normalize()
}

/// Prunes the branches that starve in season `t`, tips first, and all they carry.
fn starve(
    plan: &Plan,
    t: usize,
    state: &mut State,
    balls: &[Ball],
    pruning: f32,
    balance: &mut Balance,
) {
    let season = t as u16;
    let end = plan.seasons[t].nodes.end;
    if pruning > 0.0 {
        let first = plan.seasons[t].clusters.start;
        balance.start(
            plan,
            t,
            |place| (balls[first + place], state.lights[first + place].amount),
            |row| state.outlived(row, t),
        );
        for row in (1..end).rev() {
            if !state.outlived(row, t) {
                continue;
            }
            let (gathered, length) = (balance.gathered[row], balance.length[row]);
            if gathered < pruning * plan.starved[row] * length {
                state.died[row] = season;
                continue;
            }
            let below = plan.parent[row] as usize;
            balance.gathered[below] += gathered;
            balance.length[below] += length;
        }
    }
    for row in 1..end {
        if !state.outlived(plan.parent[row] as usize, t) && state.outlived(row, t) {
            state.died[row] = season;
        }
    }
}
