//! The stages of trees from photographs that take the time: livewire, density, flow.

#![allow(clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::f32::consts::FRAC_PI_2;
use std::hint::black_box;
use tree_core::glam::Vec2;
use tree_core::{Control, Seed};
use tree_model::particle::attractor::{LivewireParams, SeedParams, livewire, silhouette_seeds};
use tree_model::particle::density::{DensityParams, carve, sample_points, solve};
use tree_model::particle::field::{DirectionField, FieldParams, direction_field};
use tree_model::particle::flow::{FlowParams, Forces, Way, run};
use tree_model::particle::{Camera, Matte, Projection, View};

/// Side of the mattes in pixels, and the tree's height in metres.
const SIDE: u32 = 512;
const HEIGHT: f32 = 10.0;
/// Points on the silhouette from which livewire goes.
const SEEDS: u32 = 40;

/// Where the trunk meets the ground, in pixels.
fn base() -> Vec2 {
    Vec2::new(0.5, 0.95) * SIDE as f32
}

/// A disc on a trunk.
fn matte() -> Matte {
    let side = SIDE as f32;
    let center = Vec2::new(0.5, 0.37) * side;
    let pixels = (0..SIDE * SIDE).map(|i| {
        let at = Vec2::new((i % SIDE) as f32, (i / SIDE) as f32) + 0.5;
        let crown = at.distance(center) < 0.33 * side;
        let trunk = (at.x - center.x).abs() < 0.02 * side && at.y > center.y && at.y < base().y;
        f32::from(u8::from(crown || trunk))
    });
    Matte::new(SIDE, SIDE, pixels.collect()).expect("a matte")
}

/// The tree from the front and from the side.
fn views() -> Vec<View> {
    let view = |yaw| View {
        matte: matte(),
        photo: None,
        camera: Camera {
            yaw,
            pitch: 0.0,
            projection: Projection::Orthographic,
            size: Vec2::splat(SIDE as f32),
            base: base(),
            scale: HEIGHT / (0.91 * SIDE as f32),
        },
    };
    vec![view(0.0), view(FRAC_PI_2)]
}

fn attractors(c: &mut Criterion) {
    let (matte, control) = (matte(), Control::default());
    let seeds = silhouette_seeds(&matte, base(), SEEDS, &SeedParams::default(), Seed(1), &control)
        .expect("seeds");
    let mut group = c.benchmark_group("particle");
    group.sample_size(10);
    group.bench_function(format!("livewire, {SIDE}² pixels"), |b| {
        let params = LivewireParams::default();
        b.iter(|| livewire(black_box(&matte), None, base(), &seeds, &params, &control));
    });
    group.finish();
}

fn density(c: &mut Criterion) {
    let (views, control) = (views(), Control::default());
    let params = DensityParams { resolution: 64, ..DensityParams::default() };
    let carved = carve(&views, &params, &control).expect("a crown");
    let mut group = c.benchmark_group("particle");
    group.sample_size(10);
    group.bench_function("carve, 64 rows", |b| {
        b.iter(|| carve(black_box(&views), &params, &control));
    });
    group.bench_function("solve, 64 rows", |b| {
        b.iter(|| solve(black_box(&carved), &views, &params, &control));
    });
    group.finish();
}

fn flow(c: &mut Criterion) {
    let (views, control) = (views(), Control::default());
    let density = DensityParams::default();
    let carved = carve(&views, &density, &control).expect("a crown");
    let (density, _) = solve(&carved, &views, &density, &control).expect("a density");
    let fields: Vec<(Camera, DirectionField)> = views.iter().map(field).collect();
    let fields: Vec<(Camera, &DirectionField)> =
        fields.iter().map(|(camera, field)| (*camera, field)).collect();
    let way = Way::new(&density, &FlowParams::default(), &control).expect("a way");
    let mut group = c.benchmark_group("particle");
    group.sample_size(10);
    for particles in [2000, 20_000] {
        let params = FlowParams { particles, ..FlowParams::default() };
        let forces = Forces::new(&fields, &way, &params);
        let starts =
            sample_points(&density, particles, |_| 1.0, Seed(1), &control).expect("starts");
        group.throughput(Throughput::Elements(u64::from(particles)));
        group.bench_with_input(BenchmarkId::new("flow", particles), &starts, |b, starts| {
            b.iter(|| run(black_box(starts), HEIGHT, &forces, &params, &control));
        });
    }
    group.finish();
}

/// The direction field of what livewire finds in a view.
fn field(view: &View) -> (Camera, DirectionField) {
    let (camera, control) = (view.camera, Control::default());
    let seeds = silhouette_seeds(
        &view.matte,
        camera.base,
        SEEDS,
        &SeedParams::default(),
        Seed(1),
        &control,
    )
    .expect("seeds");
    let (graph, _) =
        livewire(&view.matte, None, camera.base, &seeds, &LivewireParams::default(), &control)
            .expect("a graph");
    let params = FieldParams::default();
    let field = direction_field(&graph, camera.size, camera.base, &params, &control);
    (camera, field.expect("a field"))
}

criterion_group!(benches, attractors, density, flow);
criterion_main!(benches);
