//! Twigs and leaves on the oak of the path modeler.

#![allow(clippy::expect_used)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::{Control, Seed, Skeleton};
use tree_model::foliage::{LeafParams, TwigParams, grow_leaves, grow_leaves_in, grow_twigs};
use tree_model::path::PathParams;

fn oak() -> Skeleton {
    let params = PathParams::oak().expect("the oak");
    let params = PathParams { leaves: None, ..params };
    let grown = params.grow(Seed(1), &Control::default()).expect("an oak");
    grown.tree.skeleton().clone()
}

fn foliage(c: &mut Criterion) {
    let (skeleton, control) = (oak(), Control::default());
    let mut group = c.benchmark_group("foliage");
    group.sample_size(10);
    let twigs = TwigParams { per_metre: 30.0, ..TwigParams::DEFAULT };
    let grown = grow_twigs(&skeleton, &twigs, Seed(2), &control).expect("twigs");
    group.throughput(Throughput::Elements(grown.report.n_nodes));
    group.bench_function("twigs", |b| {
        b.iter(|| grow_twigs(black_box(&skeleton), &twigs, Seed(2), &control));
    });
    let count = |leaves: &LeafParams| {
        grow_leaves(&grown.skeleton, leaves, Seed(3), &control).expect("leaves").len()
    };
    // As many leaves as the eucalyptus of Wither et al. (2009) has.
    let mut leaves = LeafParams::DEFAULT;
    leaves.spacing *= count(&leaves) as f32 / 1.3e6;
    let n_leaves = count(&leaves);
    group.throughput(Throughput::Elements(n_leaves as u64));
    group.bench_function(format!("{n_leaves} leaves"), |b| {
        b.iter(|| grow_leaves(black_box(&grown.skeleton), &leaves, Seed(3), &control));
    });
    group.bench_function("leaves in a field", |b| {
        b.iter(|| grow_leaves_in(black_box(&grown.skeleton), &leaves, &|_| 1.0, Seed(3), &control));
    });
    group.finish();
}

criterion_group!(benches, foliage);
criterion_main!(benches);
