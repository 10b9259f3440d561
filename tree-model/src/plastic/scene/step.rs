//! One season of one tree: light, bending, pruning.

use super::super::light::{Ball, Bins, Light};
use super::super::obstacle::Placed;
use super::super::params::Response;
use super::super::plan::Plan;
use super::super::pose::Pose;
use super::super::prune::Balance;
use super::super::tropism::bend;
use super::state::{ALIVE, State};
use glam::{Mat3, Quat, Vec3};
use tree_core::Aabb;

/// What a tree meets.
pub(super) struct Surroundings<'a> {
    pub bins: &'a Bins,
    pub pose: Pose,
    pub response: &'a Response,
    /// Obstacles that the tree may touch.
    pub walls: &'a [&'a Placed],
    /// Those of them that have moved, as they were and as they are now.
    pub shifted: &'a [&'a Placed],
}

/// What is not as it was before the update.
#[derive(Default)]
pub(super) struct Changes {
    /// All of the tree must be worked out anew.
    pub anew: bool,
    /// Whether each node's place or life has changed, in any season so far.
    pub rows: Vec<bool>,
    /// Whether any has.
    pub any_row: bool,
    /// Whether any node's life has.
    pub any_death: bool,
    /// Whether the light of each cluster of this season has changed.
    pub lit: Vec<bool>,
    /// Whether any of them gets more or less.
    pub amounts: bool,
}

/// Scratch that is used again.
#[derive(Default)]
pub(super) struct Scratch {
    balance: Balance,
    died: Vec<u16>,
}

/// Grows the segments of season `t` and prunes what starves.
pub(super) fn grow(
    plan: &Plan,
    t: usize,
    state: &mut State,
    balls: &[Ball],
    around: &Surroundings<'_>,
    changes: &mut Changes,
    scratch: &mut Scratch,
) {
    let end = plan.seasons[t].nodes.end;
    let meeting = meeting(plan, t, state, around);
    // Who lives is asked again only where something has changed for life and death.
    let judged = changes.anew || changes.any_death || changes.amounts || meeting.is_some();
    let meeting = meeting.unwrap_or_default();
    if !judged {
        if changes.any_row || changes.lit.contains(&true) {
            bend_season(plan, t, state, around, changes, None);
        }
        return;
    }
    scratch.died.clear();
    scratch.died.extend_from_slice(&state.died[..end]);
    for died in &mut state.died[..end] {
        if usize::from(*died) == t {
            *died = ALIVE;
        }
    }
    bend_season(plan, t, state, around, changes, Some(&meeting));
    state.stops[t] = plan.seasons[t].nodes.clone().any(|row| state.stopped[row]);
    starve(plan, t, state, balls, around.response.pruning, &mut scratch.balance);
    let deaths = state.died[..end].iter().zip(&scratch.died);
    for ((now, before), changed) in deaths.zip(&mut changes.rows[..end]) {
        *changed |= now != before;
        changes.any_death |= now != before;
    }
    changes.any_row |= changes.any_death;
}

/// What the season's segments may meet.
#[derive(Default)]
struct Meeting<'a> {
    walls: Vec<&'a Placed>,
    /// Whether any of them has moved.
    shifted: bool,
}

/// Obstacles within reach of the season's segments, however they bend; none where none is, was, or stops any.
fn meeting<'a>(
    plan: &Plan,
    t: usize,
    state: &State,
    around: &Surroundings<'a>,
) -> Option<Meeting<'a>> {
    if around.walls.is_empty() && around.shifted.is_empty() && !state.stops[t] {
        return None;
    }
    let season = &plan.seasons[t];
    let mut bounds = Aabb::EMPTY;
    for row in season.nodes.clone() {
        let below = plan.parent[row] as usize;
        if below < season.nodes.start || row == 0 {
            bounds = bounds.including(plan.position[below] + state.moved[below]);
        }
    }
    // A little more, for rounding.
    let bounds = bounds.grown(1.001 * season.stretch + 1e-4);
    let turn = Mat3::from_quat(around.pose.rotation);
    let half = bounds.size() * 0.5;
    let half = turn.x_axis.abs() * half.x + turn.y_axis.abs() * half.y + turn.z_axis.abs() * half.z;
    let center = around.pose.to_world(bounds.center());
    let bounds = Aabb::new(center - half, center + half);
    let within = |wall: &&Placed| wall.reaches_into(&bounds);
    let walls: Vec<&Placed> = around.walls.iter().copied().filter(within).collect();
    let shifted = around.shifted.iter().any(within);
    (shifted || !walls.is_empty() || state.stops[t]).then_some(Meeting { walls, shifted })
}

/// Bends the segments of season `t`. Where life and death are judged anew, deaths of this season have been taken back before,
/// and `meeting` is given.
fn bend_season(
    plan: &Plan,
    t: usize,
    state: &mut State,
    around: &Surroundings<'_>,
    changes: &mut Changes,
    meeting: Option<&Meeting<'_>>,
) {
    let up = around.bins.up;
    let season = t as u16;
    let first_cluster = plan.seasons[t].clusters.start;
    for row in plan.seasons[t].nodes.clone() {
        if row == 0 {
            continue;
        }
        let below = plan.parent[row] as usize;
        let dead = match meeting {
            Some(_) => !state.outlived(below, t),
            None => !state.lived(below, t),
        };
        let lit_by = plan.lit_by[row] as usize;
        if changes.anew || changes.rows[below] || changes.lit[lit_by - first_cluster] {
            let turned = if dead {
                state.turned[below]
            } else {
                let light = state.lights[lit_by];
                turn(plan, row, state.turned[below], light, up, around.response.bending)
            };
            let segment = plan.segment[row];
            let moved = state.moved[below] + (turned * segment - segment);
            changes.rows[row] = moved != state.moved[row] || turned != state.turned[row];
            state.moved[row] = moved;
            state.turned[row] = turned;
        }
        changes.any_row |= changes.rows[row];
        let Some(Meeting { walls, shifted }) = meeting else { continue };
        if changes.anew || *shifted || changes.rows[row] || changes.rows[below] {
            let stopped = !walls.is_empty() && meets(plan, row, state, around.pose, walls);
            changes.rows[row] |= stopped != state.stopped[row];
            state.stopped[row] = stopped;
        }
        // A death in a later season stands until that season is looked at again.
        if dead || state.stopped[row] {
            state.died[row] = season;
        } else if !state.outlived(row, t) {
            state.died[row] = ALIVE;
        }
        changes.any_row |= changes.rows[row];
    }
}

/// Whether the segment below the node runs into an obstacle.
fn meets(plan: &Plan, row: usize, state: &State, pose: Pose, walls: &[&Placed]) -> bool {
    let at = |row: usize| pose.to_world(plan.position[row] + state.moved[row]);
    let (from, to) = (at(plan.parent[row] as usize), at(row));
    walls.iter().any(|wall| wall.meets(from, to))
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
