//! Crowns: what was drawn as a crown becomes closed polygons and a solid (Neubert 2012, sections 4.7 and 4.8).
//!
//! 1. `close`: strokes become closed loops. Ends that lie close are joined; what stays open is ordered
//!    round the crown, and each gap is closed by what the convex hull of the stroke ends and the branches gives there
//!    (figure 4.15). The drawn curve stays where it is.
//! 2. `unite`: loops that cross themselves or each other become simple polygons; loops inside others
//!    are details and go.
//! 3. `solid`: the surface of local revolution (Okabe, Owada & Igarashi 2005): at every height each stretch
//!    of the crown's inside is swept to a circle about its own middle.
//!
//! The thesis takes the hull of everything for the crown. That would lose concave crowns, so here it only fills gaps;
//! for the [`Footprint`](super::Footprint) the hull of the polygons' corners is taken as in the thesis.
//!
//! [`outline_of`] goes the other way: the outline of a leafy tree as a person would draw it round.
//!
//! O(n log n + crossings) for n points. Under 1 ms for a drawn crown.

mod close;
mod outline;
mod report;
mod solid;
mod unite;

use crate::error::{ModelError, Result, check};
use crate::plane::{arrange, fill};
use glam::{Vec2, Vec3};
use solid::Solid;
use tree_core::{Control, Resource};

pub use outline::{OutlineParams, outline_of};
pub use report::{CrownRepair, CrownReport};

/// Coordinates beyond this many metres are no points of a plan.
const LARGEST: f32 = 1e6;

/// How a drawn crown is understood.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct CrownParams {
    /// A stroke whose ends are closer than this share of its length is a loop of its own, 0 to 1. Default 0.15.
    pub gap: f32,
    /// Ends of strokes closer than this share of the crown's size are joined, 0 to 1. Default 0.05.
    pub join: f32,
    /// Depth of the crown, along the view, over its width, 0.05 to 20. Default 1: circles.
    pub depth: f32,
    /// Whether a crown that no branch touches is an error. Default no: it is kept and reported.
    pub refuse: bool,
}

impl Default for CrownParams {
    fn default() -> Self {
        Self { gap: 0.15, join: 0.05, depth: 1.0, refuse: false }
    }
}

impl CrownParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("crown.gap", self.gap, 0.0_f32, 1.0_f32)?;
        check("crown.join", self.join, 0.0_f32, 1.0_f32)?;
        check("crown.depth", self.depth, 0.05_f32, 20.0_f32)
    }
}

/// A crown: polygons in the plan and the solid they stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct Crown {
    polygons: Vec<Vec<Vec2>>,
    solid: Solid,
}

impl Crown {
    /// Makes a crown of what was drawn, in plan metres (x to the right, y up). `branches` are points of the branch
    /// strokes, without the root branch.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where nothing drawn encloses an area, or where no branch touches the crown and
    /// `params.refuse` says so; [`ModelError::Parameter`]; [`ModelError::Limit`] for more points than
    /// [`Resource::Nodes`] allows; [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// See the module.
    pub fn close(
        strokes: &[Vec<Vec2>],
        branches: &[Vec2],
        params: &CrownParams,
        control: &Control,
    ) -> Result<(Self, CrownReport)> {
        params.validate()?;
        let n: usize = strokes.iter().map(Vec::len).sum::<usize>() + branches.len();
        control.limits.check(Resource::Nodes, n as u64)?;
        control.check()?;
        let mut report = CrownReport::default();
        let branches: Vec<Vec2> = branches.iter().copied().filter(is_good).collect();
        let loops = close::loops(strokes, &branches, params, &mut report);
        let polygons = unite::unite(loops, &mut report);
        control.check()?;
        if polygons.is_empty() {
            let problem = format!(
                "the crown's {} strokes enclose no area: draw its outline, closed or in pieces",
                strokes.len()
            );
            return Err(ModelError::Sketch { problem });
        }
        let crown = Self::new(polygons, params.depth);
        crown.check_branches(&branches, params, &mut report)?;
        Ok((crown, report))
    }

    /// A crown of closed polygons. They are made simple and united as drawn ones are.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where they enclose no area; [`ModelError::Parameter`] for `depth` outside 0.05 to 20.
    pub fn from_polygons(polygons: &[Vec<Vec2>], depth: f32) -> Result<Self> {
        CrownParams { depth, ..CrownParams::default() }.validate()?;
        let good = |polygon: &Vec<Vec2>| polygon.iter().copied().filter(is_good).collect();
        let loops: Vec<Vec<Vec2>> = polygons.iter().map(good).collect();
        let polygons = unite::unite(loops, &mut CrownReport::default());
        if polygons.is_empty() {
            let problem = "the crown's polygons enclose no area".into();
            return Err(ModelError::Sketch { problem });
        }
        Ok(Self::new(polygons, depth))
    }

    fn new(polygons: Vec<Vec<Vec2>>, depth: f32) -> Self {
        let solid = Solid::of(&polygons, depth);
        Self { polygons, solid }
    }

    /// Reports the share of branch points outside.
    fn check_branches(
        &self,
        branches: &[Vec2],
        params: &CrownParams,
        report: &mut CrownReport,
    ) -> Result<()> {
        let outside = branches.iter().filter(|&&point| !self.contains(point)).count();
        if outside == 0 {
            return Ok(());
        }
        report.outside = outside as f32 / branches.len() as f32;
        if outside < branches.len() {
            report.repairs.push(CrownRepair::BranchesOutside { share: report.outside });
        } else if params.refuse {
            let problem = "no branch touches the crown: draw it round the branches".into();
            return Err(ModelError::Sketch { problem });
        } else {
            report.repairs.push(CrownRepair::NoBranchInside);
        }
        Ok(())
    }

    /// The polygons: simple, apart from each other, against the clock, the largest first. Their corners are the points
    /// for a [`Footprint`](super::Footprint).
    #[must_use]
    pub fn polygons(&self) -> &[Vec<Vec2>] {
        &self.polygons
    }

    /// All corners of all polygons: for the footprint.
    #[must_use]
    pub fn corners(&self) -> Vec<Vec2> {
        self.polygons.concat()
    }

    /// The lowest and highest coordinates.
    #[must_use]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        let all = || self.polygons.iter().flatten().copied();
        (all().fold(Vec2::INFINITY, Vec2::min), all().fold(Vec2::NEG_INFINITY, Vec2::max))
    }

    /// Area of the polygons in square metres.
    #[must_use]
    pub fn area(&self) -> f32 {
        self.polygons.iter().map(|polygon| unite::area(polygon)).sum::<f64>() as f32
    }

    /// Volume of the solid in cubic metres.
    #[must_use]
    pub fn volume(&self) -> f32 {
        self.solid.volume() as f32
    }

    /// Whether a point of the plan lies in the crown. O(stretches at that height): some nanoseconds.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        self.solid.level(point.extend(0.0)).is_some()
    }

    /// Whether a point lies in the solid. With z = 0 this is [`contains`](Self::contains). As fast.
    #[must_use]
    pub fn contains_3d(&self, point: Vec3) -> bool {
        self.solid.level(point).is_some_and(|level| level <= 1.0)
    }

    /// Where the way `from` → `to` first leaves the solid, as a share of the way, 0 to 1: 0 where it begins outside;
    /// `None` where it stays inside. O(corners passed in height).
    #[must_use]
    pub fn exit(&self, from: Vec3, to: Vec3) -> Option<f32> {
        self.solid.exit(from, to)
    }

    /// How near the surface a point is: 0 on the axis of the stretch it lies in, 1 at the surface, above 1 outside;
    /// infinite where the crown has nothing at that height or on that stretch.
    #[must_use]
    pub fn level(&self, point: Vec3) -> f32 {
        self.solid.level(point).unwrap_or(f32::INFINITY)
    }

    /// How far the crown reaches towards the viewer, and away, behind a point of the plan, in metres; `None` for a point
    /// outside.
    #[must_use]
    pub fn half_depth(&self, point: Vec2) -> Option<f32> {
        self.solid.half_depth(point)
    }
}

/// Whether a point can be one of a plan.
fn is_good(point: &Vec2) -> bool {
    // A NaN is in no range.
    point.x.abs() <= LARGEST && point.y.abs() <= LARGEST
}

#[cfg(test)]
mod tests;
