//! Laser scans: skeletons of the clouds in shared data against the reference skeletons there, and the time
//! of 200,000 points.
//!
//! The references are what others' programs made of the same scans (`aRchi`, `TreeQSM`, `PlantScan3D`). Thick
//! axes are those of more than 2 cm of diameter. The reference of `itsme_tree2` has the wood only, of a tree
//! in leaf; so for all three the branches that run through foliage are left out. The trunk's radius is
//! compared 1.3 m above the reference's base, at the lowest place of the scan where that is higher
//! (`puu1_crown` has no lower trunk).

use super::Outcome;
use crate::measure::fastest;
use crate::references;
use crate::table::{Aim, Row, Table};
use std::path::{Path, PathBuf};
use tree_core::glam::DVec3;
use tree_core::{Control, Skeleton};
use tree_mesh::io::points;
use tree_model::skeletonize::{ScanParams, ScannedTree, skeletonize_scan};

/// Diameter in metres from which on axes count as thick.
const THICK: f64 = 0.02;
/// Breast height in metres.
const BREAST: f64 = 1.3;
/// Axes are compared at points this far apart, metres.
const GRAIN: f64 = 0.02;
/// Points of the scan that is timed.
const N_POINTS: usize = 200_000;
const RUNS: u32 = 3;

/// A piece of an axis, and its radius.
type Piece = (DVec3, DVec3, f64);

/// All rows; says so and gives none where there is no shared data.
pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let data = references::data();
    if !data.join("pointclouds").is_dir() {
        eprintln!("no shared data: scans left out");
        return Ok(());
    }
    let control = Control::default();
    let params = ScanParams { foliage: false, ..ScanParams::default() };
    for (cloud, reference) in [
        ("archi_tree1", references::archi(&data)?),
        ("itsme_tree2", references::itsme(&data)?),
        ("puu1_crown", references::puu(&data)?),
    ] {
        let points = points::read(cloud_path(&data, cloud), &control)?.positions;
        let made = skeletonize_scan(&points, &params, &control)?;
        let tree = made.trees.first().ok_or("no tree")?;
        let reference: Vec<Piece> = reference.iter().map(|c| (c.start, c.end, c.radius)).collect();
        compare(table, cloud, &reference, &pieces(tree));
    }
    time(table, &data)
}

fn cloud_path(data: &Path, name: &str) -> PathBuf {
    data.join("pointclouds").join(name).with_extension("ply")
}

fn compare(table: &mut Table, case: &str, reference: &[Piece], ours: &[Piece]) {
    let ours_dense = dense(ours);
    let thick: Vec<Piece> = reference.iter().copied().filter(|p| 2.0 * p.2 > THICK).collect();
    let mut distances: Vec<f64> =
        dense(&thick).iter().map(|&(at, _)| nearest(&ours_dense, at).0).collect();
    distances.sort_by(f64::total_cmp);
    let median = distances.get(distances.len() / 2).copied().unwrap_or(f64::INFINITY);
    let mut row = |metric: &str, peer: Option<f64>, ours: f64, unit: &str, aim: Aim| {
        table.row(&Row { case, metric, paper: None, peer, ours, unit, aim });
    };
    row("thick axes, median distance", None, 100.0 * median, "cm", Aim::AtMost(5.0));
    let length = |pieces: &[Piece]| pieces.iter().map(|p| p.0.distance(p.1)).sum::<f64>();
    let (theirs, own) = (length(reference), length(ours));
    row("total length", Some(theirs), own, "m", Aim::None);
    row("total length, off by", None, 100.0 * (own / theirs - 1.0).abs(), "%", Aim::AtMost(25.0));
    let (theirs, own) = trunks(reference, &ours_dense);
    row("trunk radius", Some(100.0 * theirs), 100.0 * own, "cm", Aim::None);
    row("trunk radius, off by", None, 100.0 * (own / theirs - 1.0).abs(), "%", Aim::AtMost(15.0));
}

/// Radii of the trunk at breast height: the reference's and ours.
fn trunks(reference: &[Piece], ours: &[(DVec3, f64)]) -> (f64, f64) {
    let dense = dense(reference);
    let low = dense.iter().map(|(at, _)| at.z).fold(f64::INFINITY, f64::min);
    let lowest = ours.iter().map(|(at, _)| at.z).fold(f64::INFINITY, f64::min);
    let height = (low + BREAST).max(lowest);
    let thickest = dense.iter().map(|(_, radius)| *radius).fold(0.0, f64::max);
    // Of all that is as high, the trunk is what is thick.
    let of_trunk = dense.iter().filter(|(_, radius)| *radius > 0.5 * thickest);
    let at = of_trunk.min_by(|a, b| (a.0.z - height).abs().total_cmp(&(b.0.z - height).abs()));
    let Some(&(at, theirs)) = at else { return (f64::NAN, f64::NAN) };
    (theirs, nearest(ours, at).1)
}

/// Distance to the nearest place and the radius there.
fn nearest(places: &[(DVec3, f64)], at: DVec3) -> (f64, f64) {
    places.iter().fold((f64::INFINITY, f64::NAN), |best, &(place, radius)| {
        let distance = place.distance(at);
        if distance < best.0 { (distance, radius) } else { best }
    })
}

/// Places along pieces, and their radii.
fn dense(pieces: &[Piece]) -> Vec<(DVec3, f64)> {
    let mut places = Vec::new();
    for &(a, b, radius) in pieces {
        let n = (a.distance(b) / GRAIN).ceil().max(1.0) as u32;
        let at = |i: u32| a.lerp(b, (f64::from(i) + 0.5) / f64::from(n));
        places.extend((0..n).map(|i| (at(i), radius)));
    }
    places
}

/// Our axes in the axes of the cloud, z up.
fn pieces(tree: &ScannedTree) -> Vec<Piece> {
    of_skeleton(&tree.skeleton, |p| tree.base + DVec3::new(p.x, -p.z, p.y))
}

fn of_skeleton(skeleton: &Skeleton, place: impl Fn(DVec3) -> DVec3) -> Vec<Piece> {
    let at = |node: u32| place(skeleton.positions()[node as usize].as_dvec3());
    let radius = |node: u32| f64::from(skeleton.radii()[node as usize]);
    skeleton.segments().map(|(a, b)| (at(a), at(b), radius(b))).collect()
}

/// The crown of puu1, the densest scan there is, with as many points again in between as are missing.
fn time(table: &mut Table, data: &Path) -> Outcome {
    let control = Control::default();
    let mut cloud = points::read(cloud_path(data, "puu1_crown"), &control)?.positions;
    let n = cloud.len();
    for i in 0..N_POINTS.saturating_sub(n) {
        // Neighbours in the file are neighbours on the tree.
        let (a, b) = (cloud[2 * i % n], cloud[(2 * i + 1) % n]);
        cloud.push(if a.distance(b) < 0.02 { 0.5 * (a + b) } else { a + DVec3::splat(0.001) });
    }
    let (seconds, _) =
        fastest(RUNS, || skeletonize_scan(&cloud, &ScanParams::default(), &control))?;
    table.row(&Row {
        case: "200,000 points",
        metric: "time",
        paper: None,
        peer: None,
        ours: seconds,
        unit: "s",
        aim: Aim::AtMost(2.0),
    });
    Ok(())
}
