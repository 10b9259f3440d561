//! Do branches leave at the branching angle and end on their bump's centre, and do sub-silhouettes go on smoothly? Over
//! all systems of all drawings, and constructed crowns; the worst counts.
//!
//! A branch is a cubic curve by even steps of its parameter, so that its direction where it leaves follows exactly from its
//! first four points. Siblings of a branch that was drawn over have its shape instead, and leave as their first stretch does.

use super::cases::{self, KINDS, Kind};
use super::lobes;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_model::silhouette::bump::bumps;
use tree_model::silhouette::plan::{Lateral, Origin, System, SystemParams};
use tree_model::silhouette::sub::sub_outline;
use tree_model::silhouette::{Line, Outline};
use tree_model::tree_core::glam::Vec2;

/// The worst of branches of one origin.
#[derive(Default)]
struct Worst {
    n: u32,
    /// Branches within a degree.
    n_good: u32,
    /// Degrees between the direction a branch leaves in and what the branching angle function says.
    angle: f64,
    /// Metres between its base and its place on the parent, over the parent's length.
    base: f64,
}

#[derive(Default)]
struct All {
    of_bumps: Worst,
    of_coverage: Worst,
    redrawn: Worst,
    /// Distance of ends and bumps' centres over the outline's size.
    end: f64,
    /// Degrees between outline and curve where they join.
    join: f64,
    n_joins: u32,
}

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let mut all = All::default();
    let kinds = KINDS.iter().map(Kind::case).collect::<Result<Vec<_>, _>>()?;
    for case in kinds.iter().chain(&cases::shared()?) {
        for (session, ..) in &case.sessions()? {
            let plan = session.plan().ok_or("no crown")?;
            all.take(&plan.system, &session.params().system);
        }
    }
    for n in 2..=12 {
        all.take(&constructed(n)?, &SystemParams::default());
    }
    let mut row = |case: &str, metric: &str, ours: f64, unit: &str, aim: Aim| {
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    let origins = [
        ("of bumps", &all.of_bumps),
        ("of coverage", &all.of_coverage),
        ("beside a redrawn one", &all.redrawn),
    ];
    for (name, worst) in origins {
        let case = format!("{} branches {name}, worst", worst.n);
        row(&case, "off the branching angle", worst.angle, "degrees", Aim::AtMost(1.0));
        let good = 100.0 * f64::from(worst.n_good) / f64::from(worst.n.max(1));
        row(&case, "within 1 degree of it", good, "%", Aim::None);
        row(&case, "base off the parent", 100.0 * worst.base, "% length", Aim::AtMost(0.1));
    }
    let case = format!("{} branches of bumps, worst", all.of_bumps.n + all.redrawn.n);
    row(&case, "end off the bump's centre", 100.0 * all.end, "% size", Aim::AtMost(0.1));
    let case = format!("{} joins of sub-silhouettes, worst", all.n_joins);
    row(&case, "kink (G1)", all.join, "degrees", Aim::AtMost(0.1));
    Ok(())
}

/// A crown of waves on a trunk.
fn constructed(lobes: usize) -> Result<System, Box<dyn Error>> {
    let lift = Vec2::new(0.0, 1.6);
    let crown = lobes::rose(lobes, 0.2).into_iter().map(|p| p + lift).collect();
    let trunk = Line::new(vec![Vec2::ZERO, lift, lift + Vec2::new(0.1, 0.7)]).ok_or("no trunk")?;
    let mut system = System::new(trunk, Outline::from_points(crown)?, Default::default());
    system.grow(&SystemParams::default(), &mut 0);
    Ok(system)
}

impl All {
    fn take(&mut self, system: &System, params: &SystemParams) {
        let (low, high) = system.outline.bounds();
        let size = (high - low).max_element();
        let centers: Vec<Vec2> =
            bumps(&system.outline, &params.bumps).iter().map(|bump| bump.center).collect();
        let is_redrawn = system.laterals.iter().any(|l| l.origin == Origin::Drawn);
        for lateral in &system.laterals {
            if let Some(inner) = &lateral.system {
                self.take(inner, params);
            }
            let worst = match lateral.origin {
                Origin::Drawn => continue,
                _ if is_redrawn => &mut self.redrawn,
                Origin::Bump => &mut self.of_bumps,
                Origin::Coverage => &mut self.of_coverage,
            };
            worst.take(system, lateral, lateral.line.foot());
            if lateral.origin == Origin::Bump {
                let off = |center: &Vec2| center.distance(lateral.line.end()) / size;
                let nearest = centers.iter().map(off).fold(f32::INFINITY, f32::min);
                self.end = self.end.max(f64::from(nearest));
            }
            self.joins(system, lateral, params);
        }
    }

    fn joins(&mut self, system: &System, lateral: &Lateral, params: &SystemParams) {
        let (radius, stretch) = (lateral.radius, lateral.stretch);
        let found = sub_outline(&system.outline, &lateral.line, radius, stretch, &params.sub);
        if found.shared[1] <= found.shared[0] {
            return;
        }
        let directions = [found.curves[0].derivative(1.0), found.curves[1].derivative(0.0)];
        for (join, direction) in found.joins.iter().zip(directions) {
            let kink = join.tangent.angle_to(direction).abs().to_degrees();
            self.join = self.join.max(f64::from(kink));
            self.n_joins += 1;
        }
    }
}

impl Worst {
    fn take(&mut self, system: &System, lateral: &Lateral, foot: Vec2) {
        let along = system.axis.tangent(lateral.t);
        let wanted = system.angles.at(lateral.t);
        let angle = along.angle_to(foot).abs();
        self.n += 1;
        let off = f64::from((angle - wanted).abs().to_degrees());
        self.angle = self.angle.max(off);
        self.n_good += u32::from(off <= 1.0);
        let off = lateral.line.start().distance(system.axis.at(lateral.t));
        self.base = self.base.max(f64::from(off / system.axis.length()));
    }
}
