//! The edit distance of random trees, by size; the second half without a reduction.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::distance::{EditParams, Reduction, distance};
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Skeleton, seed};

/// Shoots of a few nodes that leave earlier shoots anywhere.
fn tree(n_nodes: u32, seed: u64) -> tree_core::error::Result<Skeleton> {
    let mut rng = Seed(seed).rng();
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3)?;
    while builder.len() < n_nodes as usize {
        let mut node = seed::uniform(&mut rng, 0.0, builder.len() as f32) as u32;
        for _ in 0..6 {
            let position = Vec3::splat(node as f32) + seed::unit_vector(&mut rng);
            node = builder.add(node, position, seed::uniform(&mut rng, 0.01, 0.1))?;
        }
    }
    Ok(builder.finish())
}

fn distances(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("distance");
    group.sample_size(10);
    for n_nodes in [250, 1000, 2500] {
        let (Ok(a), Ok(b)) = (tree(n_nodes, 1), tree(n_nodes, 2)) else { continue };
        for (name, reduction) in [("runs", Reduction::Runs), ("nodes", Reduction::None)] {
            let params = EditParams { reduction, ..EditParams::default() };
            group.bench_with_input(BenchmarkId::new(name, n_nodes), &params, |bencher, params| {
                bencher.iter(|| distance(black_box(&a), &b, params, &Control::default()));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, distances);
criterion_main!(benches);
