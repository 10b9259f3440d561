//! Bark tubes, leaves and writers, in triangles a second, over sizes.

#![allow(clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::glam::{EulerRot, Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree};
use tree_mesh::{Built, Look, MeshParams, build, io};

/// A trunk with whorls of boughs, boughs with twigs: `n` whorls of 5 boughs of 10 twigs.
fn tree(n: u32, n_leaves: u32) -> Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.4).expect("a finite root");
    let mut trunk = 0;
    for whorl in 0..n {
        let share = whorl as f32 / n as f32;
        let wave = Vec3::new(0.1 * (whorl % 3) as f32, 0.0, 0.1 * (whorl % 2) as f32);
        let foot = Vec3::Y * (1.0 + 0.3 * whorl as f32) + wave;
        trunk = add(&mut builder, trunk, foot, 0.4 * (1.0 - share) + 0.02);
        for bough in 0..5 {
            let turn = Quat::from_rotation_y(1.256 * bough as f32 + whorl as f32);
            let mut node = trunk;
            for step in 1..=10_u32 {
                let s = step as f32;
                let out = turn * Vec3::new(0.3 * s, 0.02 * s * s, 0.05 * (step % 2) as f32);
                node = add(&mut builder, node, foot + out, 0.02 * (1.1 - 0.1 * s));
                let mut tip = foot + out;
                let mut twig = node;
                for _ in 0..3 {
                    tip += turn * Vec3::new(0.05, 0.02, if step % 2 == 0 { 0.1 } else { -0.1 });
                    twig = add(&mut builder, twig, tip, 0.003);
                }
            }
        }
    }
    let leaf = |i: u32| Leaf {
        node: 0,
        position: Vec3::new((i % 97) as f32, (i % 89) as f32, (i % 83) as f32) * 0.1,
        rotation: Quat::from_euler(EulerRot::XYZ, i as f32, 0.7 * i as f32, 0.0),
        size: 0.08,
        kind: 0,
    };
    let mut foliage = Foliage::with_capacity(n_leaves as usize);
    for i in 0..n_leaves {
        // Every leaf above is finite and sits on the root.
        let _ = foliage.push(leaf(i));
    }
    let skeleton = builder.finish();
    Tree::new(skeleton.clone(), foliage, Species::default())
        .unwrap_or_else(|_| Tree::bare(skeleton, Species::default()))
}

fn add(builder: &mut tree_core::SkeletonBuilder, parent: u32, at: Vec3, radius: f32) -> u32 {
    builder.add(parent, at, radius).unwrap_or(parent)
}

fn built(tree: &Tree) -> Built {
    let look = Look::plain(tree.species());
    build(tree, &look, &MeshParams::default(), &Control::default())
        .unwrap_or_else(|_| Built { mesh: Default::default(), report: Default::default() })
}

fn tubes(c: &mut Criterion) {
    let mut group = c.benchmark_group("tubes");
    group.sample_size(20);
    for n in [1, 10, 100, 1000] {
        let tree = tree(n, 0);
        let n_triangles = built(&tree).report.n_triangles as u64;
        group.throughput(Throughput::Elements(n_triangles));
        group.bench_with_input(BenchmarkId::from_parameter(n_triangles), &tree, |b, tree| {
            b.iter(|| built(black_box(tree)));
        });
    }
    group.finish();
}

fn cards(c: &mut Criterion) {
    let mut group = c.benchmark_group("cards");
    group.sample_size(20);
    for n in [1000, 100_000, 1_300_000] {
        let tree = tree(0, n);
        group.throughput(Throughput::Elements(2 * u64::from(n)));
        group.bench_with_input(BenchmarkId::from_parameter(2 * n), &tree, |b, tree| {
            b.iter(|| built(black_box(tree)));
        });
    }
    group.finish();
}

/// One thread, and the columns and shapes that cost more or less.
fn leaves(c: &mut Criterion) {
    let tree = tree(0, 1_300_000);
    let look = Look::plain(tree.species());
    let mut group = c.benchmark_group("leaves");
    group.sample_size(10);
    let full = MeshParams { tangents: true, lightmap: true, ..Default::default() };
    let lean = MeshParams { leaf_rounding: 0.0, ..Default::default() };
    for (name, n_threads, params) in [
        ("default", 1, MeshParams::default()),
        ("default", 2, MeshParams::default()),
        ("all columns", 1, full),
        ("lean", 1, lean),
    ] {
        let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build() else {
            continue;
        };
        group.bench_function(BenchmarkId::new(name, n_threads), |b| {
            b.iter(|| pool.install(|| build(&tree, &look, &params, &Control::default())));
        });
    }
    group.finish();
}

fn writers(c: &mut Criterion) {
    let mesh = built(&tree(0, 250_000)).mesh;
    let mut group = c.benchmark_group("write");
    group.sample_size(10);
    group.throughput(Throughput::Elements(500_000));
    let path = std::env::temp_dir().join(format!("tree-mesh-bench-{}.obj", std::process::id()));
    group.bench_function("obj", |b| b.iter(|| io::obj::write_obj(&mesh, &path)));
    for made in [path.clone(), path.with_extension("mtl")] {
        let _ = std::fs::remove_file(made);
    }
    #[cfg(feature = "gltf")]
    group.bench_function("glb", |b| {
        b.iter(|| io::gltf::to_glb(black_box(&mesh), &Default::default()));
    });
    group.finish();
}

criterion_group!(benches, tubes, cards, leaves, writers);
criterion_main!(benches);
