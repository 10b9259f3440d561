//! Speed of what works on surfaces: examination, crossings, subdivision, displacement.

use super::{Outcome, speed};
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use tree_core::Control;
use tree_mesh::displace::{DisplaceParams, displace};
use tree_mesh::subdivide::{SubdivideParams, subdivide};
use tree_mesh::topology::{examine, self_intersections};

/// Whorls of the tree: about a million triangles by default.
const WHORLS: u32 = 280;
/// Whorls of the tree that is subdivided twice.
const COARSE: u32 = 18;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let control = Control::default();
    let built = speed::bark(&speed::tree(WHORLS, 0)?)?;
    let bark = built.mesh.surfaces.first().ok_or("no bark")?;
    let n = bark.n_triangles() as f64;
    let mut figure = |what: &str, triangles: f64, seconds: f64| {
        let case = format!("{what}, {triangles} triangles");
        let (metric, unit) = ("triangles per second", "1/s");
        let ours = triangles / seconds;
        table.row(&Row {
            case: &case,
            metric,
            paper: None,
            peer: None,
            ours,
            unit,
            aim: Aim::None,
        });
    };
    figure("examine", n, fastest(3, || examine(bark))?.0);
    figure("self-intersections", n, fastest(3, || self_intersections(bark, &control))?.0);
    let coarse = speed::bark(&speed::tree(COARSE, 0)?)?;
    let coarse_bark = coarse.mesh.surfaces.first().ok_or("no bark")?;
    let params = SubdivideParams::default();
    let (seconds, mut fine) = fastest(3, || subdivide(coarse_bark, &params, &control))?;
    let n = fine.n_triangles() as f64;
    figure("subdivide twice to", n, seconds);
    let (branches, relief) = (&coarse.mesh.branches, DisplaceParams::default());
    figure("displace", n, fastest(3, || displace(&mut fine, branches, &relief, &control))?.0);
    Ok(())
}
