//! An axis with an outline and branches.

use super::cover::{self, CoverParams, Coverage};
use super::raster::Raster;
use super::{Lateral, Origin, crown};
use crate::error::Result;
use crate::silhouette::branch::{BranchingAngles, InferParams, infer};
use crate::silhouette::bump::{Bump, BumpParams, bumps};
use crate::silhouette::sub::{SubParams, sub_outline};
use crate::silhouette::{Line, Outline};
use glam::Vec2;

/// Spans of branches to bumps are at least this many radii of the bump.
const ROUND: f32 = 1.0;

/// How the branches of a system are found.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SystemParams {
    /// How bumps are found.
    pub bumps: BumpParams,
    /// How branches are inferred.
    pub infer: InferParams,
    /// How sub-silhouettes are made.
    pub sub: SubParams,
    /// How gaps are filled.
    pub cover: CoverParams,
}

impl SystemParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        self.bumps.validate()?;
        self.infer.validate()?;
        self.sub.validate()?;
        self.cover.validate()
    }
}

/// An outline drawn in another plane through the axis.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Section {
    /// How far the plane is turned about the axis, in radians from +X towards +Z.
    pub azimuth: f32,
    /// The outline as seen with that plane in front.
    pub outline: Outline,
}

/// An axis, the outline of its foliage and its branches, in the plane.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct System {
    /// The trunk or branch.
    pub axis: Line,
    /// The outline of its foliage.
    pub outline: Outline,
    /// Outlines in further planes.
    pub sections: Vec<Section>,
    /// The angles at which branches leave.
    pub angles: BranchingAngles,
    /// The branches.
    pub laterals: Vec<Lateral>,
}

impl System {
    /// A system without branches yet.
    #[must_use]
    pub fn new(axis: Line, outline: Outline, angles: BranchingAngles) -> Self {
        Self { axis, outline, sections: Vec::new(), angles, laterals: Vec::new() }
    }

    /// Infers branches: those of bumps, then those that gaps need. Branches that were there and are not of bumps or
    /// coverage stay. `next_id` gives names. Returns what was covered.
    ///
    /// # Complexity
    /// O(n log n) for n points of the outline, and some microseconds for each branch.
    pub fn grow(&mut self, params: &SystemParams, next_id: &mut u32) -> Coverage {
        self.grow_from(&bumps(&self.outline, &params.bumps), params, next_id)
    }

    /// The same for bumps that were found already.
    pub(crate) fn grow_from(
        &mut self,
        bumps: &[Bump],
        params: &SystemParams,
        next_id: &mut u32,
    ) -> Coverage {
        self.laterals.retain(|lateral| lateral.origin == Origin::Drawn);
        let within = crown::foliage_part(&self.axis, &self.outline);
        let mut raster = Raster::of(&self.outline);
        let mut name = || {
            *next_id += 1;
            *next_id
        };
        for bump in bumps {
            if crown::is_foot(&self.axis, within, bump) || self.has_one_at(bump) {
                continue;
            }
            let found = infer(
                &self.axis,
                &self.angles,
                (bump.center, bump.tangent),
                within,
                &|point| raster.is_inside(point),
                &params.infer,
            );
            // A bump rounder than its branch is long is the whole crown, and coverage's.
            let found = found.filter(|found| found.line.span().length() >= ROUND * bump.radius);
            if let Some(found) = found {
                let (radius, stretch) = (bump.radius, Some(bump.stretch));
                let lateral = self.lateral(
                    name(),
                    Origin::Bump,
                    found.t,
                    found.line,
                    (radius, stretch),
                    params,
                );
                self.laterals.push(lateral);
            }
        }
        cover::cover(self, within, params, &mut raster, &mut name)
    }

    /// A branch of this system with its sub-silhouette.
    pub(crate) fn lateral(
        &self,
        id: u32,
        origin: Origin,
        t: f32,
        line: Line,
        (radius, stretch): (f32, Option<[f32; 2]>),
        params: &SystemParams,
    ) -> Lateral {
        let outline = sub_outline(&self.outline, &line, radius, stretch, &params.sub).outline;
        let left = self.axis.tangent(t).perp_dot(line.span()) > 0.0;
        Lateral {
            id,
            origin,
            t,
            left,
            line,
            outline,
            radius,
            stretch,
            azimuth: None,
            style: None,
            system: None,
        }
    }

    /// Whether a drawn branch ends in a bump.
    fn has_one_at(&self, bump: &Bump) -> bool {
        let near = bump.radius.max(0.5 * bump.center.distance(bump.tip));
        let in_plane = self.laterals.iter().filter(|lateral| lateral.azimuth.is_none());
        in_plane.into_iter().any(|lateral| lateral.line.end().distance(bump.center) <= near)
    }

    /// The line to a branch's end as it is inferred from the angles.
    pub(crate) fn line_to(&self, lateral: &Lateral, params: &SystemParams) -> Option<(f32, Line)> {
        let within = crown::foliage_part(&self.axis, &self.outline);
        let end = (lateral.line.end(), lateral.line.tangent(1.0));
        let raster = Raster::of(&self.outline);
        let is_inside = |point: Vec2| raster.is_inside(point);
        let found = infer(&self.axis, &self.angles, end, within, &is_inside, &params.infer)?;
        Some((found.t, found.line))
    }

    /// Moves everything by a map of the plane that keeps lines straight.
    pub(crate) fn carry(&mut self, map: &impl Fn(Vec2) -> Vec2) {
        let line = |line: &Line| Line::new(line.points().iter().map(|&point| map(point)).collect());
        self.axis = line(&self.axis).unwrap_or_else(|| self.axis.clone());
        let outline = |outline: &mut Outline| {
            if let Some(moved) = outline.transformed(map) {
                *outline = moved;
            }
        };
        outline(&mut self.outline);
        self.sections.iter_mut().for_each(|section| outline(&mut section.outline));
        for lateral in &mut self.laterals {
            lateral.line = line(&lateral.line).unwrap_or_else(|| lateral.line.clone());
            outline(&mut lateral.outline);
            lateral.left = self.axis.tangent(lateral.t).perp_dot(lateral.line.span()) > 0.0;
            if let Some(system) = &mut lateral.system {
                let map: &dyn Fn(Vec2) -> Vec2 = map;
                system.carry(&map);
            }
        }
    }
}

/// Where a branch with a given end leaves the axis at the branching angle, when its span stands off by `leaving` from the
/// direction it leaves in: of such places the one with the shortest span. `None` where there is no such place.
pub(crate) fn turned_base(system: &System, end: Vec2, left: bool, leaving: f32) -> Option<f32> {
    /// Places tried.
    const PLACES: usize = 64;
    /// Halvings between two places.
    const HALVINGS: usize = 20;
    let [low, high] = crown::foliage_part(&system.axis, &system.outline);
    let off = |t: f32| {
        let way = end - system.axis.at(t);
        let along = system.axis.tangent(t);
        let angle = libm::atan2f(along.perp_dot(way), along.dot(way));
        (if left { angle } else { -angle }) - (system.angles.at(t) - leaving)
    };
    let place = |i: usize| low + (high - low) * i as f32 / (PLACES - 1) as f32;
    let mut best: Option<(f32, f32)> = None;
    for i in 1..PLACES {
        let (mut a, mut b) = (place(i - 1), place(i));
        // Behind the end the angle jumps from π to -π: no crossing.
        if off(a) * off(b) > 0.0 || (off(a) - off(b)).abs() > 3.0 {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (a + b);
            if off(a) * off(middle) <= 0.0 { b = middle } else { a = middle }
        }
        let span = end.distance(system.axis.at(a));
        if best.is_none_or(|(shortest, _)| span < shortest) {
            best = Some((span, a));
        }
    }
    best.map(|(_, t)| t)
}
