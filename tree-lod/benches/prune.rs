//! Masks, orders and tables of a crown of cards.
#![allow(clippy::unwrap_used)] // a bench has nobody to tell

mod synthetic;

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::{Control, Seed};
use tree_lod::cover::{Around, mask};
use tree_lod::order::{CoverageParams, Ranking, combined, coverage, stochastic};
use tree_lod::outline::Tier;
use tree_lod::prune::{MakeParams, PruneParams, PrunedModel};
use tree_lod::quality::{Subject, Table, TableParams};
use tree_lod::{Elements, Grain, LeafSurfaces};

fn bench(criterion: &mut Criterion) {
    let control = Control::default();
    let mesh = synthetic::tree(20_000);
    let foliage = LeafSurfaces::Surfaces(vec![1]);
    let elements = Elements::of_mesh(&mesh, &foliage, Grain::Blade, &control).unwrap();
    let tier = Tier::full(&mesh, &elements);
    let camera = Around::default().cameras().remove(0);
    let params = CoverageParams::for_triangles(elements.n_triangles());
    let mut group = criterion.benchmark_group("prune");
    group.sample_size(10);
    group.bench_function("mask of 512 pixels", |b| {
        b.iter(|| black_box(mask(&mesh, &camera, 512, &control)));
    });
    group.bench_function("order by coverage", |b| {
        b.iter(|| black_box(coverage(&mesh, &elements, &tier, &params, &control)));
    });
    group.bench_function("combined order", |b| {
        b.iter(|| black_box(combined(&elements, &Default::default(), Seed(1), &control)));
    });
    let ranking =
        Ranking { order: stochastic(&elements, Seed(1)), pivots: elements.centers.clone() };
    let tiers = [tier.clone()];
    let subject =
        Subject { mesh: &mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
    group.bench_function("table", |b| {
        b.iter(|| black_box(Table::measure(&subject, &TableParams::default(), &control)));
    });
    let make = MakeParams { foliage, order: Some(params.clone()), ..MakeParams::default() };
    group.bench_function("whole model", |b| {
        b.iter(|| black_box(PrunedModel::make(&mesh, &make, &control)));
    });
    let table = Table::measure(&subject, &TableParams::default(), &control).unwrap();
    let model = PrunedModel::new(&subject, table, &PruneParams::default(), &control).unwrap();
    group.bench_function("level", |b| b.iter(|| black_box(model.level(black_box(0.3)))));
    group.bench_function("level as a mesh", |b| b.iter(|| black_box(model.mesh_at(0.3))));
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
