//! Impostors of a crown of cards: baking, choosing, and pictures from them.
#![allow(clippy::unwrap_used)] // a bench has nobody to tell

mod synthetic;

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::{Control, Skeleton};
use tree_lod::glam::Vec3;
use tree_lod::impostor::boxes::{Bearers, BoxParams, Boxes};
use tree_lod::impostor::cards::{CardParams, Cards};
use tree_lod::impostor::choose::{Choice, ChooseParams, Watcher};
use tree_lod::impostor::octahedral::{Octahedral, OctahedralParams};
use tree_lod::impostor::texel::mips;
use tree_lod::preview::{Camera, Lens, Pose};
use tree_lod::{Elements, Grain, LeafSurfaces};

/// Limbs in all directions, and branches on each.
fn skeleton() -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.5, 0.25).unwrap();
    for i in 0..64 {
        let y = 1.0 - (2 * i + 1) as f32 / 64.0;
        let (sin, cos) = libm::sincosf(2.399_963 * i as f32);
        let ring = (1.0 - y * y).sqrt();
        let out = Vec3::new(5.0 * ring * cos, 4.0 * y, 5.0 * ring * sin);
        let limb = builder.add(fork, Vec3::Y * 6.0 + 0.4 * out, 0.1).unwrap();
        for k in 0..4 {
            let tip = Vec3::Y * 6.0 + out * (0.6 + 0.1 * k as f32);
            builder.add(limb, tip, 0.05).unwrap();
        }
    }
    builder.finish()
}

fn bench(criterion: &mut Criterion) {
    let control = Control::default();
    let mesh = synthetic::tree(50_000);
    let foliage = LeafSurfaces::Surfaces(vec![1]);
    let elements = Elements::of_mesh(&mesh, &foliage, Grain::Blade, &control).unwrap();
    let skeleton = skeleton();
    let mut group = criterion.benchmark_group("impostor");
    group.sample_size(10);
    group.bench_function("nearest bearers", |b| {
        b.iter(|| black_box(Bearers::nearest(&skeleton, &elements)));
    });
    let bearers = Bearers::nearest(&skeleton, &elements);
    let params = BoxParams { least_volume: 0.001, ..BoxParams::default() };
    let grow = || Boxes::along(&skeleton, &mesh, &elements, &bearers, &params, &control).unwrap();
    group.bench_function("boxes", |b| b.iter(|| black_box(grow())));
    let boxes = grow();
    let bake = |size| {
        let params = CardParams { size, ..CardParams::default() };
        Cards::bake(&mesh, &elements, &boxes, &params, &control).unwrap()
    };
    group.bench_function("cards of 64 texels", |b| b.iter(|| black_box(bake(64))));
    let cards = bake(64);
    let mut choice = Choice::new(&cards).unwrap();
    let watcher = Watcher { eye: Vec3::new(30.0, 2.0, 0.0), pixels_per_metre: 900.0 };
    group.bench_function("choose", |b| {
        b.iter(|| choice.update(cards.boxes(), black_box(&watcher), &ChooseParams::default()));
    });
    group.bench_function("144 views of 50,000 triangles", |b| {
        b.iter(|| black_box(Octahedral::bake(&mesh, &OctahedralParams::default(), &control)));
    });
    let octahedral = Octahedral::bake(&mesh, &OctahedralParams::default(), &control).unwrap();
    let camera = Camera::Placed(Pose {
        eye: Vec3::new(40.0, 6.0, 20.0),
        target: octahedral.meta.center,
        up: Vec3::Y,
        lens: Lens::Perspective { fov: 0.3 },
    });
    group.bench_function("a view of 176 pixels", |b| {
        b.iter(|| black_box(octahedral.view(&camera, 176, 176, &control)));
    });
    group.bench_function("mips of 2048 texels", |b| {
        b.iter(|| black_box(mips(&octahedral.color, 6)));
    });
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
