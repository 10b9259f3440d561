//! Branches drawn over, and what their siblings take of it (section 3.3).

use super::edit::DEEPEST;
use super::state::{Drawn, line_of};
use super::target::{distance, systems};
use super::{Change, Session, Viewpoint};
use crate::error::{ModelError, Result, check};
use crate::silhouette::Line;
use crate::silhouette::branch::{Shape, Span, base_of};
use crate::silhouette::plan::{Lateral, Origin, System, SystemParams, turned_base};
use glam::Vec2;
use std::f32::consts::{FRAC_PI_4, TAU};

/// Radius that stands for a bump's, as a share of the branch's length.
const ROUND: f32 = 0.4;

/// Who takes the shape and angle of a branch drawn over.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Transfer {
    /// All siblings that were not drawn themselves.
    #[default]
    Siblings,
    /// Those of them on the same side.
    Side,
    /// These branches, drawn or not.
    Only(Vec<u32>),
    /// None.
    Nobody,
}

impl Transfer {
    fn takes(&self, lateral: &Lateral, source: &Lateral) -> bool {
        let is_drawn = lateral.origin == Origin::Drawn;
        lateral.id != source.id
            && match self {
                Self::Siblings => !is_drawn,
                Self::Side => !is_drawn && lateral.left == source.left,
                Self::Only(ids) => ids.contains(&lateral.id),
                Self::Nobody => false,
            }
    }
}

impl Session {
    /// Draws a branch of a level over, 1 for those on the trunk: the one whose ends are nearest to the stroke's. Where none is
    /// near, it is a new one. Its angle becomes a sample of the branching angles, and siblings take angle and shape.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for a line without length, or where there is no axis of that level; [`ModelError::Parameter`].
    ///
    /// # Complexity
    /// Some 50 µs for each sibling.
    pub fn redraw(&mut self, level: u32, stroke: &[Vec2], transfer: &Transfer) -> Result<Change> {
        check("level", level, 1, DEEPEST)?;
        self.edit(|drawn, repairs| {
            let line = line_of(stroke, "branch", repairs)?;
            let (plane, target) = drawn.branch_at(level, &line)?;
            drawn.redraw((level, plane), target, line, None, transfer)
        })
    }

    /// Draws a branch on the trunk from another viewpoint; it lies in the upright plane through the trunk that faces the viewer.
    /// A branch drawn from near there before, with ends near the stroke's, is replaced; else it is a new one. From in front this is
    /// [`redraw`](Self::redraw).
    ///
    /// # Errors
    /// As [`redraw`](Self::redraw).
    pub fn redraw_from(
        &mut self,
        view: Viewpoint,
        stroke: &[Vec2],
        transfer: &Transfer,
    ) -> Result<Change> {
        view.validate()?;
        if view.is_front() {
            return self.redraw(1, stroke, transfer);
        }
        self.edit(|drawn, repairs| {
            let seen = line_of(stroke, "branch", repairs)?;
            let plan = drawn.plan_mut("branch")?;
            let plane = seen.points().iter().map(|&point| {
                // The trunk as it is seen from there stands where its own plane has it.
                let point = view.to_plane(point);
                let (t, _) =
                    plan.system.axis.nearest(Vec2::new(plan.system.axis.start().x, point.y));
                let trunk = plan.system.axis.at(t).x;
                Vec2::new(trunk + point.x - trunk * libm::cosf(view.yaw), point.y)
            });
            let line = Line::new(plane.collect()).unwrap_or(seen);
            let line = from_axis(&plan.system.axis, line);
            let (t, _, left) = base_of(&plan.system.axis, &line);
            let azimuth = view.azimuth(left);
            let near = |lateral: &&Lateral| {
                let off = (lateral.azimuth.unwrap_or(f32::NAN) - azimuth).rem_euclid(TAU);
                off.min(TAU - off) < FRAC_PI_4 && (lateral.t - t).abs() < 0.5
            };
            let candidates = plan.system.laterals.iter().filter(near);
            let best = candidates.min_by(|a, b| distance(a, &line).total_cmp(&distance(b, &line)));
            let target = best.map(|lateral| (lateral.id, distance(lateral, &line)));
            let target = target.filter(|&(_, d)| d <= drawn.params.near).map(|(id, _)| id);
            drawn.redraw((1, 0), target, line, Some(azimuth), transfer)
        })
    }
}

impl Drawn {
    /// The axis of a level a line stands on, by its number among those of the level, and the branch that it is drawn over.
    fn branch_at(&mut self, level: u32, line: &Line) -> Result<(usize, Option<u32>)> {
        let near = self.params.near;
        let plan = self.plan_mut("branch")?;
        let bearers = systems(&mut plan.system, level - 1);
        let over = bearers
            .iter()
            .enumerate()
            .flat_map(|(i, system)| system.laterals.iter().map(move |lateral| (i, lateral)))
            .filter(|(_, lateral)| lateral.azimuth.is_none())
            .map(|(i, lateral)| {
                // Whichever way it was drawn.
                let d = distance(lateral, line).min(distance(lateral, &reversed(line)));
                (d, i, lateral.id)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, i, id)) = over.filter(|&(d, ..)| d <= near) {
            return Ok((i, Some(id)));
        }
        let off = |system: &System| {
            let foot = |point| system.axis.nearest(point).1;
            foot(line.start()).min(foot(line.end()))
        };
        let nearest =
            (0..bearers.len()).min_by(|&a, &b| off(bearers[a]).total_cmp(&off(bearers[b])));
        nearest.map(|i| (i, None)).ok_or_else(|| {
            let problem = format!("no branch of level {} has an outline yet", level - 1);
            ModelError::Silhouette { what: format!("branch of level {level}"), problem }
        })
    }

    fn redraw(
        &mut self,
        (level, plane): (u32, usize),
        target: Option<u32>,
        line: Line,
        azimuth: Option<f32>,
        transfer: &Transfer,
    ) -> Result<()> {
        let params = self.params.system.clone();
        let new_id = self.last_id + 1;
        let plan = self.plan_mut("branch")?;
        let Some(system) = systems(&mut plan.system, level - 1).into_iter().nth(plane) else {
            return Ok(());
        };
        let line = from_axis(&system.axis, line);
        // Its foot is on the axis; a stroke that begins a little off is drawn on to it.
        let foot = system.axis.at(base_of(&system.axis, &line).0);
        let n = line.points().len();
        let points = std::iter::once(foot).chain(line.points().iter().copied()).collect();
        let line = Line::new(points).map_or(line, |line| line.resampled(n));
        let (t, angle, left) = base_of(&system.axis, &line);
        system.angles.set(t, angle);
        let index = target.and_then(|id| system.laterals.iter().position(|l| l.id == id));
        let radius = (ROUND * line.span().length(), None);
        match index {
            Some(index) => {
                let (radius, stretch) =
                    (system.laterals[index].radius, system.laterals[index].stretch);
                let made =
                    system.lateral(0, Origin::Drawn, t, line.clone(), (radius, stretch), &params);
                let lateral = &mut system.laterals[index];
                (lateral.origin, lateral.t) = (Origin::Drawn, t);
                lateral.azimuth = azimuth.or(lateral.azimuth);
                lateral.reshape(line, left);
                lateral.outline =
                    lateral.system.as_ref().map_or(made.outline, |system| system.outline.clone());
            }
            None => {
                let made = system.lateral(new_id, Origin::Drawn, t, line, radius, &params);
                system.laterals.push(Lateral { azimuth, left, ..made });
            }
        }
        let source = index.unwrap_or(system.laterals.len() - 1);
        transfer_shape(system, source, transfer, &params);
        self.last_id = new_id;
        Ok(())
    }
}

/// A line from the end that is nearer to an axis, whichever way it was drawn.
fn from_axis(axis: &Line, line: Line) -> Line {
    let backwards = axis.nearest(line.end()).1 < axis.nearest(line.start()).1;
    if backwards { reversed(&line) } else { line }
}

fn reversed(line: &Line) -> Line {
    Line::new(line.points().iter().rev().copied().collect()).unwrap_or_else(|| line.clone())
}

/// Gives siblings the shape of a branch: they end where they ended, and leave at the branching angle.
fn transfer_shape(system: &mut System, source: usize, transfer: &Transfer, params: &SystemParams) {
    let source = system.laterals[source].clone();
    let Some(shape) = source.shape() else { return };
    for i in 0..system.laterals.len() {
        if !transfer.takes(&system.laterals[i], &source) {
            continue;
        }
        // Where the shape does not go with the angles the branch is inferred from them, with its own shape.
        let sibling = &system.laterals[i];
        let placed = placed(system, sibling, &shape);
        let Some((t, line)) = placed.or_else(|| system.line_to(sibling, params)) else { continue };
        let lateral = &system.laterals[i];
        let bump = (lateral.radius, lateral.stretch);
        let made = system.lateral(0, lateral.origin, t, line.clone(), bump, params);
        let lateral = &mut system.laterals[i];
        lateral.t = t;
        lateral.reshape(line, made.left);
        lateral.outline =
            lateral.system.as_ref().map_or(made.outline, |system| system.outline.clone());
    }
}

/// A shape from the axis to a branch's end.
fn placed(system: &System, lateral: &Lateral, shape: &Shape) -> Option<(f32, Line)> {
    let end = lateral.line.end();
    let t = turned_base(system, end, lateral.left, shape.leaving())?;
    let span = Span::new(system.axis.at(t), end, lateral.left)?;
    Some((t, shape.line_on(&span)?))
}
