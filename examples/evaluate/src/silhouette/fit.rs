//! Does the tree fill its outline? Intersection over union of the drawn outline and the leafy tree's silhouette, from the
//! drawing direction and from the side.
//!
//! 64 cells along the longer side of crown and trunk, and eight more all round, so that what of the tree sticks out
//! counts against it. A cell is the tree's where half of its sixteen samples hit wood or leaves; it is the outline's where its middle lies
//! inside. Cells of the trunk below the crown (within 1.6 of its radius, for it flares, and a cell of its line, outside the outline) count neither
//! for nor against: the person drew the crown and the trunk apart. From the side the outline is the interpolated
//! profile at 90°, or the one that was drawn there.
//!
//! Of a drawing of several trees, each is compared by itself and the worst must hold.

use super::cases::{self, Case, KINDS, OUT};
use super::paint::{beside, difference, save};
use super::view::{CELLS, MARGIN, Seen, Side, seen};
use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use std::fs;
use tree_mesh::Mesh;
use tree_model::silhouette::session::Session;

/// Overlap asked for from in front and from the side.
const AIMS: [f64; 2] = [0.85, 0.80];
/// Names of the rows.
const METRICS: [&str; 2] = ["IoU from in front", "IoU from the side"];
/// Pixels along the side of a picture.
const PICTURE: usize = 400;

/// Overlaps over all cases.
#[derive(Default)]
struct Sum {
    values: [Vec<f64>; 2],
}

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(OUT)?;
    let mut all = Sum::default();
    let mut cases = KINDS.iter().map(cases::Kind::case).collect::<Result<Vec<_>, _>>()?;
    cases.extend(cases::shared()?);
    for (case, found) in cases.iter().zip(of_each(&cases, measured)?) {
        all.take(case, found, table);
    }
    for (values, metric) in all.values.iter().zip(METRICS) {
        let least = values.iter().copied().fold(1.0, f64::min);
        let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
        let case = format!("{} drawings", values.len());
        let mut row = |what: &str, ours| {
            let metric = format!("{metric}, {what}");
            info(table, &case, &metric, ours, Aim::None);
        };
        row("least", least);
        row("mean", mean);
    }
    Ok(())
}

fn info(table: &mut Table, case: &str, metric: &str, ours: f64, aim: Aim) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit: "", aim });
}

/// Overlaps of each tree of a drawing, and a picture of the worst.
fn measured(case: &Case) -> Result<[Vec<f64>; 2], Box<dyn Error>> {
    let (mut found, mut worst) = ([const { Vec::new() }; 2], f64::INFINITY);
    for (session, ..) in &case.sessions()? {
        let (_, mesh) = cases::mesh(session)?;
        let parts = sides(session, &mesh, CELLS + 2 * MARGIN)?;
        for (values, part) in found.iter_mut().zip(&parts) {
            values.push(part.as_ref().map_or(0.0, Seen::iou));
        }
        let front = found[0].last().copied().unwrap_or(0.0);
        if front < worst {
            worst = front;
            picture(&case.name, session, &mesh)?;
        }
    }
    Ok(found)
}

impl Sum {
    fn take(&mut self, case: &Case, found: [Vec<f64>; 2], table: &mut Table) {
        let several = case.trees.len() > 1;
        for (i, values) in found.into_iter().enumerate() {
            let least = values.iter().copied().fold(1.0, f64::min);
            let n = values.len();
            let name =
                if several { format!("{}, worst of {n}", case.name) } else { case.name.clone() };
            info(table, &name, METRICS[i], least, Aim::AtLeast(AIMS[i]));
            if several {
                let mean = values.iter().sum::<f64>() / n as f64;
                info(table, &format!("{}, mean of {n}", case.name), METRICS[i], mean, Aim::None);
            }
            self.values[i].push(least);
        }
    }
}

fn sides(session: &Session, mesh: &Mesh, n: usize) -> Result<[Option<Seen>; 2], Box<dyn Error>> {
    let plan = session.plan().ok_or("no crown")?;
    let grow = &session.params().grow;
    let half_width = grow.trunk_radius.unwrap_or(grow.slenderness * session.params().height);
    let side = |side| seen(side, plan, mesh, half_width, n);
    Ok([side(Side::Front)?, side(Side::Side)?])
}

/// Front and side, coloured by where outline and tree differ.
fn picture(name: &str, session: &Session, mesh: &Mesh) -> Result<(), Box<dyn Error>> {
    let parts = sides(session, mesh, PICTURE)?;
    let pictures: Vec<_> = parts.iter().flatten().map(difference).collect();
    save(&beside(&pictures), &format!("fit_{name}"))
}
