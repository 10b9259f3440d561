//! A forest and a walk through it, for benchmarks and tests of scene selection.
#![allow(clippy::expect_used)]

use tree_lod::glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_to_mat4};
use tree_lod::glam::{Quat, Vec3};
use tree_lod::quality::Distance;
use tree_lod::select::{Draw, Eye, Instance, Level, Model, Occluder, Scene};
use tree_lod::tree_core::{Control, Seed, seed};

/// Ground of a tree in m².
const GROUND: f32 = 80.0;

/// A tree of this height: 64 levels, bark and leaves, 32 points on an ellipsoid.
pub(crate) fn model(height: f32, triangles: u32) -> Model {
    let center = Vec3::Y * 0.6 * height;
    let radii = Vec3::new(0.22, 0.4, 0.22) * height;
    let golden = 2.399_963_2;
    let sample = |i: usize| {
        let y = 1.0 - (2 * i + 1) as f32 / 32.0;
        let (sin, cos) = libm::sincosf(golden * i as f32);
        let ring = (1.0 - y * y).sqrt();
        center + radii * Vec3::new(ring * cos, y, ring * sin)
    };
    let level = |i: usize| {
        let lambda = (i + 1) as f32 / 64.0;
        let wood = Draw { index_count: 9000, ..Draw::default() };
        let leaves = (lambda * triangles as f32) as u32 * 3;
        let leaves = Draw { first_index: 9000, index_count: leaves, base_vertex: 3000 };
        Level { lambda, scale: 1.0 / lambda.sqrt(), fade: 0.1 * lambda, draws: vec![wood, leaves] }
    };
    Model {
        center: Vec3::Y * 0.5 * height,
        radius: 0.55 * height,
        samples: (0..32).map(sample).collect(),
        occluders: vec![
            Occluder { center, radii: 0.7 * radii },
            Occluder { center: Vec3::Y * 0.3 * height, radii: Vec3::new(0.02, 0.3, 0.02) * height },
        ],
        distance: Distance::cook(),
        near: 10.0,
        far: 600.0,
        levels: (0..64).map(level).collect(),
    }
}

/// Six models, `n` trees on a square.
pub(crate) fn forest(n: usize) -> Scene {
    let models: Vec<Model> =
        (0..6).map(|i| model(8.0 + 3.0 * i as f32, 60_000 + 20_000 * i)).collect();
    let side = side(n);
    let mut rng = Seed(7).stream("forest").rng();
    let mut next = || seed::uniform(&mut rng, 0.0, 1.0);
    let instances: Vec<Instance> = (0..n)
        .map(|i| Instance {
            model: (i % 6) as u32,
            position: Vec3::new(side * (next() - 0.5), 0.0, side * (next() - 0.5)),
            rotation: Quat::from_rotation_y(std::f32::consts::TAU * next()),
            scale: 0.8 + 0.4 * next(),
        })
        .collect();
    Scene::new(&models, &instances, &Control::default()).expect("a forest")
}

/// Side of the square in metres.
pub(crate) fn side(n: usize) -> f32 {
    (n as f32 * GROUND).sqrt()
}

/// The camera of a frame: it walks from the edge through the middle and looks about.
pub(crate) fn eye(n: usize, frame: usize) -> Eye {
    // 200 m, and again.
    let t = (frame % 4000) as f32;
    let position =
        Vec3::new(0.0, 1.7 + 6.0 * (1.0 + libm::sinf(0.01 * t)), 0.5 * side(n) - 0.05 * t);
    let (x, z) = libm::sincosf(0.4 * libm::sinf(0.007 * t));
    Eye {
        view: look_to_mat4(position, Vec3::new(x, 0.05, -z).normalize(), Vec3::Y),
        projection: perspective_infinite_reverse(1.0, 16.0 / 9.0, 0.1),
    }
}

/// Depths of ground and of trunks and boulders at 5 to 100 m, as an engine would have drawn them.
pub(crate) fn depths(width: u32, height: u32) -> Vec<f32> {
    let mut rng = Seed(9).stream("depths").rng();
    let horizon = height as f32 * 0.55;
    let ground = |row: u32| 0.1 * ((row as f32 - horizon) / height as f32).max(1e-4);
    let mut depths: Vec<f32> = (0..width * height).map(|i| ground(i / width)).collect();
    for _ in 0..200 {
        let distance = seed::uniform(&mut rng, 5.0, 100.0);
        let wide = (0.4 * height as f32 / distance) as u32 + 1;
        let left = seed::uniform(&mut rng, 0.0, (width - wide) as f32) as u32;
        for row in height / 4..height * 3 / 4 {
            for column in left..left + wide {
                let depth = &mut depths[(row * width + column) as usize];
                *depth = depth.max(0.1 / distance);
            }
        }
    }
    depths
}
