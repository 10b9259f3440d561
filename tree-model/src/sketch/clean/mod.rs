//! A drawing as it comes becomes a tree in the plane and the lines of a crown.
//!
//! The thesis takes clean strokes for granted ("the strokes in the sketch are first split into a set of
//! inter-connected branch segments", Neubert 2012, section 4.4). Drawings are not like that. The steps:
//!
//! 1. points and strokes that are none are left out (`tidy`);
//! 2. what nobody marked is told apart: ground, crown, wood (`roles`);
//! 3. of wood that is drawn by its outline the middle line is taken (`outlines`);
//! 4. lines are sampled evenly, corners kept (`sample`): no drawn point is farther than 0.2 % of the height from them;
//! 5. of strokes drawn over one another one stays (`merge`);
//! 6. the root is found (`root`) and the strokes are joined, the nearest first (`join`);
//! 7. flares of roots at the foot become a trunk (`flares`), and wood that ends below a crown is drawn on into it
//!    (`reach`).
//!
//! Whatever is done to a stroke is in the report. A drawing with a crown and nothing else gets an imagined
//! trunk. O(points · log points + strokes²): 100,000 points in 2,000 strokes take a fraction of a second.

mod flares;
mod join;
mod line;
mod merge;
mod outlines;
mod params;
mod reach;
mod report;
mod roles;
mod root;
mod sample;
mod shape;
mod tidy;

pub use params::{CleanParams, Isolated};
pub use report::{CleanReport, Repair, RepairKind};

use super::{Drawing, Plan, Role};
use crate::error::{ModelError, Result};
use glam::Vec2;
use line::Line;
use sample::resample;
use tidy::{Extent, Ink};
use tree_core::{Control, NO_PARENT, Resource};

/// An imagined trunk ends at this share of the crown's height.
const IMAGINED: f32 = 2.0 / 3.0;

/// Wood reaches below the top of the ground by up to this share of the height.
const BELOW: f32 = 0.01;

/// Middle lines within this share of the height of a crown's line are its ink.
const INK: f32 = 0.03;

/// Strokes join at a node that is nearer than this share of the spacing to where they meet.
const SAME: f32 = 0.25;

/// A cleaned drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Cleaned {
    /// The branches as one tree in metres.
    pub plan: Plan,
    /// The lines of the crown in metres of the plan, as drawn and not yet closed; a closed one ends where it begins.
    pub crown: Vec<Vec<Vec2>>,
    /// The stroke of each line of the crown.
    pub crown_strokes: Vec<u32>,
    /// What was done.
    pub report: CleanReport,
}

/// Cleans and joins the strokes of a drawing. See the module.
///
/// # Errors
/// [`ModelError::Parameter`] and [`ModelError::NotFinite`] for parameters out of range; [`ModelError::Limit`] for more
/// points than [`Resource::Nodes`] allows; [`ModelError::Sketch`] where there are no strokes or none has a length;
/// [`ModelError::Stroke`] for a stroke too far from the rest if `params` refuse such; [`ModelError::Cancelled`].
///
/// # Complexity
/// See the module.
pub fn clean(drawing: &Drawing, params: &CleanParams, control: &Control) -> Result<Cleaned> {
    params.validate()?;
    let n_points: u64 = drawing.strokes.iter().map(|stroke| stroke.points.len() as u64).sum();
    control.limits.check(Resource::Nodes, n_points.max(drawing.strokes.len() as u64))?;
    let mut report = CleanReport::default();
    let cleaned = steps(drawing, params, &mut report, control);
    let named = |error| match error {
        // Inside, strokes have numbers only.
        ModelError::Stroke { stroke, problem } => {
            let number = stroke.trim_start_matches("strokes[").trim_end_matches(']').parse();
            ModelError::Stroke {
                stroke: number.map_or(stroke, |n: usize| drawing.name_of(n)),
                problem,
            }
        }
        other => other,
    };
    let (plan, crowns) = cleaned.map_err(named)?;
    for repair in &mut report.repairs {
        repair.name = drawing.name_of(repair.stroke as usize);
    }
    let crown_strokes = crowns.iter().map(|ink| ink.stroke).collect();
    let metres = |ink: &Ink| ink.points.iter().map(|&p| plan.from_drawing(p)).collect();
    Ok(Cleaned { crown: crowns.iter().map(metres).collect(), crown_strokes, plan, report })
}

/// The plan, and the strokes of the crown in units of the drawing.
fn steps(
    drawing: &Drawing,
    params: &CleanParams,
    report: &mut CleanReport,
    control: &Control,
) -> Result<(Plan, Vec<Ink>)> {
    control.report("strokes", 0.0)?;
    let mut inks = tidy::tidy(drawing, report)?;
    control.check()?;
    let mut ground = None;
    if params.guess {
        ground = roles::decide(&mut inks, report);
        control.report("roles", 0.1)?;
        outlines::trunks(&mut inks, report);
    }
    outlines::branches(drawing, &mut inks, report);
    control.report("outlines", 0.3)?;
    let unit = Extent::all(&inks).unit();
    let total: f32 = inks.iter().map(|ink| tidy::length(&ink.points)).sum();
    let spacing = sample::spacing(params.spacing, unit, total);
    for ink in &mut inks {
        ink.points = resample(&ink.points, spacing, sample::TOLERANCE * unit);
    }
    inks.retain(|ink| ink.points.len() > 1);
    let n_points: u64 = inks.iter().map(|ink| ink.points.len() as u64).sum();
    control.limits.check(Resource::Nodes, n_points)?;
    let (crowns, wood): (Vec<Ink>, Vec<Ink>) =
        inks.into_iter().partition(|ink| ink.role == Some(Role::Crown));
    control.report("merging", 0.4)?;
    let wood = above(wood, ground.map(|y| y + BELOW * unit), report);
    let wood = merge::leave_out_ink(wood, &crowns, [INK * unit, 1.5 * spacing, unit], report);
    let wood = merge::merge(wood, [params.merge * unit, 1.5 * spacing, unit], report, control)?;
    let wood = if wood.is_empty() { vec![imagined(&crowns, spacing, report)?] } else { wood };
    control.report("joining", 0.5)?;
    let lines: Vec<Line> = wood.iter().map(|ink| Line::new(ink.points.clone())).collect();
    let root = root::find(&wood, &lines, params.root, unit);
    if let Some(ink) = wood.get(root.stroke).filter(|ink| ink.role.is_none()) {
        report.add(ink.stroke, RepairKind::TakenAs(Role::Trunk));
    }
    let work = join::Join { inks: &wood, lines: &lines, params, unit };
    let joints = work.run(&root, report, control)?;
    let distances = [SAME * spacing, params.gather * unit];
    let mut nodes = join::nodes(&wood, &lines, &joints, distances);
    if params.guess {
        let marked = |stroke: u32| wood.iter().any(|ink| ink.stroke == stroke && ink.marked);
        if params.root.is_none() {
            flares::leave_out(&mut nodes, &marked, [unit, spacing], report);
        }
        reach::draw_on(&mut nodes, &crowns, [unit, spacing], report);
    }
    let plan = plan(nodes, &crowns, params.height)?;
    control.report("joined", 1.0)?;
    Ok((plan, crowns))
}

/// What of wood is above the ground, where there is one.
fn above(wood: Vec<Ink>, ground: Option<f32>, report: &mut CleanReport) -> Vec<Ink> {
    let Some(level) = ground else { return wood };
    let mut out = Vec::with_capacity(wood.len());
    for ink in wood {
        let runs = ink.points.split(|p| p.y > level).filter(|run| run.len() > 1);
        let pieces: Vec<Ink> =
            runs.map(|run| Ink { points: run.to_vec(), ..ink.clone() }).collect();
        if pieces.iter().map(|piece| piece.points.len()).sum::<usize>() < ink.points.len() {
            report.add(ink.stroke, RepairKind::BelowGround);
        }
        out.extend(pieces);
    }
    out
}

/// A straight trunk for a drawing with nothing but a crown: from its lowest level, below its middle, up to two thirds
/// of it.
fn imagined(crowns: &[Ink], spacing: f32, report: &mut CleanReport) -> Result<Ink> {
    let largest = crowns.iter().map(|ink| (tidy::length(&ink.points), ink));
    let largest = largest.reduce(|a, b| if b.0 > a.0 { b } else { a });
    let Some((_, ink)) = largest else {
        return Err(ModelError::Sketch {
            problem: "there is no stroke that shows a branch".into(),
        });
    };
    report.add(ink.stroke, RepairKind::ImaginedTrunk);
    let extent = Extent::all(crowns);
    let foot = Vec2::new(extent.center().x, extent.high.y);
    // A flat line has no inside: as high as it takes.
    let top = foot - Vec2::Y * (IMAGINED * extent.unit()).max(spacing);
    let points = resample(&[foot, top], spacing, spacing);
    Ok(Ink {
        role: Some(Role::Trunk),
        marked: false,
        closed: false,
        filled: false,
        points,
        ..ink.clone()
    })
}

/// Nodes in units of the drawing as a plan in metres.
fn plan(nodes: join::Nodes, crowns: &[Ink], height: f32) -> Result<Plan> {
    let (positions, parents, strokes) = nodes;
    let crown = crowns.iter().flat_map(|ink| &ink.points);
    let extent = Extent::of(positions.iter().chain(crown));
    let scale = height / extent.unit();
    let base = positions.first().copied().unwrap_or_default();
    let metres = |p: Vec2| Vec2::new(p.x - base.x, base.y - p.y) * scale;
    let positions = positions.into_iter().map(metres).collect();
    debug_assert_eq!(parents.first(), Some(&NO_PARENT));
    Plan::from_columns(positions, parents, strokes, base, scale)
}

#[cfg(test)]
mod tests;
