//! Known trees: rendered from two sides, found again, compared from a third and in space.

use super::cases::{Grown, grow};
use super::score::{mesh, score, seen};
use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use std::collections::BTreeSet;
use std::error::Error;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};
use tree_core::seed::unit_vector;
use tree_core::{Aabb, Control, Seed, Tree};
use tree_mesh::Mesh;
use tree_model::glam::{IVec3, Vec2, Vec3};
use tree_model::particle::finish::FinishParams;
use tree_model::particle::session::{PhotoParams, Shot};
use tree_model::particle::{Camera, Projection};
use tree_model::path::Preset;

/// Trees that others' methods would not know either: broad, narrow, sparse, with and without a leader.
const TREES: [(&str, &str); 8] = [
    ("oak", "oak"),
    ("a", "birch"),
    ("b", "oak"),
    ("c", "oak"),
    ("e", "pine"),
    ("g", "pine"),
    ("i", "oak"),
    ("k", "oak"),
];
/// Side of the pictures in pixels.
const PIXELS: f32 = 512.0;
/// Voxels along the height in which crowns are compared.
const VOXELS: f32 = 40.0;
/// Directions in which a convex hull is known.
const DIRECTIONS: usize = 300;
/// A leaf makes so much space around it part of the crown, in heights.
const REACH: f32 = 0.05;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let known = of_each(&TREES, |(name, species)| found_again(name, species))?;
    for ((name, _), Known { truth, shape, grown }) in TREES.iter().zip(&known) {
        let case = format!("synthetic {name}");
        grown.rows(table, &case, &["front".into(), "side".into()], 0.88);
        own_rows(table, &case, truth, shape, grown)?;
    }
    Ok(())
}

/// A known tree, and what was found of it.
struct Known {
    truth: Tree,
    shape: Mesh,
    grown: Grown,
}

fn found_again(name: &str, species: &str) -> Result<Known, Box<dyn Error>> {
    let control = Control::default();
    let mut preset = Preset::find(name)?.params()?;
    preset.roots = None;
    let truth = preset.grow(Seed(11), &control)?.tree;
    let shape = mesh(&truth, &control)?;
    let height = shape.bounds().max.y;
    let shots = [0.0, FRAC_PI_2]
        .into_iter()
        .map(|yaw| Ok(Shot::new(seen(&shape, &camera(&shape, yaw), &control)?, None, yaw)))
        .collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    let params =
        PhotoParams { height, finish: FinishParams::find(species)?, ..PhotoParams::default() };
    let grown = grow(shots, &params, Some(&camera(&shape, FRAC_PI_4)))?;
    Ok(Known { truth, shape, grown })
}

/// The view from between the two that were given, and the crown in space.
fn own_rows(
    table: &mut Table,
    case: &str,
    truth: &Tree,
    shape: &Mesh,
    grown: &Grown,
) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let between = camera(shape, FRAC_PI_4);
    let asked = seen(shape, &between, &control)?;
    let (mut f1, mut overlap, mut hull) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    for (tree, found) in grown.trees.iter().zip(&grown.between) {
        f1 = f1.min(score(found, &asked).f1());
        overlap = overlap.min(near_overlap(tree, truth));
        hull = hull.min(hull_overlap(tree, truth));
    }
    for (metric, ours, aim) in [
        ("F1 unseen, 45°", f1, Aim::AtLeast(0.75)),
        ("crown volume overlap", hull, Aim::AtLeast(0.6)),
        ("overlap within 5 % of leaves", overlap, Aim::None),
    ] {
        let (paper, peer, unit) = (None, None, "");
        table.row(&Row { case, metric, paper, peer, ours, unit, aim });
    }
    Ok(())
}

/// A square picture of the whole tree, from so far round it.
fn camera(mesh: &Mesh, yaw: f32) -> Camera {
    let bounds = mesh.bounds();
    let around = bounds.min.abs().max(bounds.max.abs());
    let extent = bounds.max.y.max(2.0 * around.x.max(around.z) * std::f32::consts::SQRT_2);
    let scale = 1.1 * extent / PIXELS;
    Camera {
        yaw,
        pitch: 0.0,
        projection: Projection::Orthographic,
        size: Vec2::splat(PIXELS),
        base: Vec2::new(0.5 * PIXELS, 0.97 * PIXELS),
        scale,
    }
}

/// The points that make a crown: leaves, or nodes where the truth is bare.
fn crown_points<'a>(tree: &'a Tree, truth: &Tree) -> &'a [Vec3] {
    if truth.foliage().is_empty() {
        tree.skeleton().positions()
    } else {
        tree.foliage().positions()
    }
}

/// Intersection over union of the crowns' convex hulls, which is what forestry calls a crown's volume. A hull is
/// known by how far it reaches in many directions.
fn hull_overlap(tree: &Tree, truth: &Tree) -> f64 {
    let mut rng = Seed(0).rng();
    let directions: Vec<Vec3> = (0..DIRECTIONS).map(|_| unit_vector(&mut rng)).collect();
    let reaches = |points: &[Vec3]| -> Vec<f32> {
        let reach = |d: &Vec3| points.iter().map(|p| p.dot(*d)).fold(f32::NEG_INFINITY, f32::max);
        directions.iter().map(reach).collect()
    };
    let (a, b) = (crown_points(tree, truth), crown_points(truth, truth));
    let (reach_a, reach_b) = (reaches(a), reaches(b));
    let inside = |p: Vec3, reaches: &[f32]| {
        directions.iter().zip(reaches).all(|(d, &reach)| d.dot(p) <= reach)
    };
    let bounds = Aabb::of_points(a).union(Aabb::of_points(b));
    let step = bounds.size() / VOXELS;
    let (mut both, mut either) = (0_u32, 0_u32);
    for i in 0..(VOXELS as i32).pow(3) {
        let n = VOXELS as i32;
        let at = IVec3::new(i % n, i / n % n, i / (n * n)).as_vec3() + 0.5;
        let p = bounds.min + step * at;
        let (a, b) = (inside(p, &reach_a), inside(p, &reach_b));
        both += u32::from(a && b);
        either += u32::from(a || b);
    }
    f64::from(both) / f64::from(either.max(1))
}

/// Intersection over union of the space within [`REACH`] of a leaf: for sparse crowns a far stricter measure, since
/// two silhouettes do not tell where between its limbs a crown is hollow.
fn near_overlap(tree: &Tree, truth: &Tree) -> f64 {
    let height = truth.skeleton().bounds().max.y;
    let voxel = height / VOXELS;
    let reach = (REACH * VOXELS).ceil() as i32;
    let ball: Vec<IVec3> = (0..(2 * reach + 1).pow(3))
        .map(|i| {
            let side = 2 * reach + 1;
            IVec3::new(i % side, i / side % side, i / (side * side)) - reach
        })
        .filter(|step| step.as_vec3().length() <= REACH * VOXELS)
        .collect();
    let crown = |tree: &Tree| -> BTreeSet<[i32; 3]> {
        let filled: BTreeSet<[i32; 3]> = crown_points(tree, truth)
            .iter()
            .map(|&p| (p / voxel).floor().as_ivec3().to_array())
            .collect();
        filled
            .iter()
            .flat_map(|&at| ball.iter().map(move |&step| (IVec3::from_array(at) + step).to_array()))
            .collect()
    };
    let (a, b) = (crown(tree), crown(truth));
    let both = a.intersection(&b).count();
    both as f64 / (a.len() + b.len() - both).max(1) as f64
}
