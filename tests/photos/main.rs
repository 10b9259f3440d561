//! From photographs to a tree with what people really bring along: each gives a sound tree or a typed error that
//! says what to do, and never a panic.

#![allow(clippy::unwrap_used, clippy::panic)]

mod numbers;
mod pictures;
mod sessions;

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use tree_core::glam::Vec2;
use tree_core::{CancelFlag, Control, Limits, NO_PARENT, Seed, Tree};
use tree_model::ModelError;
use tree_model::particle::attractor::AttractorGraph;
use tree_model::particle::density::{DensityBrush, DensityStroke};
use tree_model::particle::session::{
    Attractor, PhotoParams, PhotoTree, Placing, Session, Shot, Stage,
};
use tree_model::particle::{Camera, Matte, Photo, Projection};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 96;

/// A matte that covers the pixels whose centres `covered` tells.
fn matte_of(width: u32, height: u32, covered: impl Fn(f32, f32) -> bool) -> Matte {
    let pixel = |i: u32| covered((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
    let alpha = (0..width * height).map(|i| if pixel(i) { 1.0 } else { 0.0 });
    Matte::new(width, height, alpha.collect()).unwrap()
}

fn in_crown(x: f32, y: f32) -> bool {
    let (dx, dy) = ((x - 32.0) / 24.0, (y - 36.0) / 30.0);
    dx * dx + dy * dy < 1.0
}

fn in_trunk(x: f32, y: f32) -> bool {
    (x - 32.0).abs() < 3.0 && (36.0..92.0).contains(&y)
}

/// A round crown on a trunk.
fn lollipop() -> Matte {
    matte_of(WIDTH, HEIGHT, |x, y| in_crown(x, y) || in_trunk(x, y))
}

fn shot(matte: Matte) -> Shot {
    Shot::new(matte, None, 0.0)
}

/// So few particles and voxels that a tree takes a moment.
fn params() -> PhotoParams {
    let mut params = PhotoParams { branches: 8, ..PhotoParams::default() };
    params.flow.particles = 60;
    params.density.resolution = 16;
    params.field.rows = 30;
    params.livewire.rows = 64;
    params
}

fn session(shots: Vec<Shot>) -> Result<Session, ModelError> {
    Session::new(shots, params(), Seed(1))
}

fn tree(shots: Vec<Shot>) -> Result<PhotoTree, ModelError> {
    session(shots)?.tree(&Control::default()).cloned()
}

/// A tree that any consumer can take.
fn assert_sound(made: &PhotoTree) {
    let skeleton = made.tree.skeleton();
    skeleton.check().unwrap();
    assert!(skeleton.len() > 1, "a tree of one node");
    assert!(skeleton.positions().iter().all(|p| p.is_finite()));
    assert!(skeleton.radii().iter().all(|&r| r.is_finite() && r > 0.0));
    let height = skeleton.bounds().size().y;
    assert!((0.5..40.0).contains(&height), "{height} m high");
    for leaf in made.tree.foliage().iter() {
        let sizes = leaf.size.is_finite() && leaf.size > 0.0;
        assert!(leaf.position.is_finite() && leaf.rotation.is_finite() && sizes, "{leaf:?}");
    }
    let doubts = made.report.warnings();
    assert!(doubts.iter().all(|line| !line.contains("NaN") && !line.contains("inf")), "{doubts:?}");
    // A report that holds a NaN is unequal to itself.
    assert_eq!(made.report, made.report.clone());
}

fn sound(shots: Vec<Shot>) -> PhotoTree {
    let made = tree(shots).unwrap();
    assert_sound(&made);
    made
}

/// The text of an error that must come.
fn error(shots: Vec<Shot>) -> String {
    tree(shots).map(|made| made.report).unwrap_err().to_string()
}

fn warns(made: &PhotoTree, of: &str) {
    let doubts = made.report.warnings();
    assert!(doubts.iter().any(|line| line.contains(of)), "none of {doubts:?} tells of '{of}'");
}
