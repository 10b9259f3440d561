//! The stages of path planning over graph sizes, so that growth shows.

#![allow(clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Volume};
use tree_model::path::graph::{Graph, Terrain};
use tree_model::path::nodes::{Nodes, strew};
use tree_model::path::search::{Routes, Scratch, search_with};
use tree_model::path::{LinkParams, PRESETS};

const SIZES: [u32; 3] = [100, 10_000, 300_000];

fn crown() -> Volume {
    Volume::sector(Vec3::ZERO, Vec3::Y, 0.942, 4.0).expect("a sector")
}

fn nodes(wanted: u32, seed: Seed) -> Nodes {
    strew(&crown(), None, wanted, &[Vec3::ZERO], seed, &Control::default()).expect("nodes")
}

fn graph(nodes: &Nodes) -> Graph {
    let (linking, terrain) = (LinkParams::default(), Terrain::default());
    Graph::link(nodes, &linking, &terrain, Seed(2), &Control::default()).expect("a graph")
}

fn stages(c: &mut Criterion) {
    let mut group = c.benchmark_group("path");
    group.sample_size(10);
    for size in SIZES {
        group.throughput(Throughput::Elements(u64::from(size)));
        group.bench_with_input(BenchmarkId::new("strew", size), &size, |b, &size| {
            b.iter(|| nodes(black_box(size), Seed(1)));
        });
        let strewn = nodes(size, Seed(1));
        group.bench_with_input(BenchmarkId::new("link", size), &strewn, |b, strewn| {
            b.iter(|| graph(black_box(strewn)));
        });
        // Different graphs in turn, or the processor learns one small graph by heart.
        let n_graphs = if size < 1000 { 64 } else { 1 };
        let graphs: Vec<(Graph, u32)> = (0..n_graphs)
            .map(|i| {
                let strewn = nodes(size, Seed(i));
                (graph(&strewn), strewn.forced[0])
            })
            .collect();
        let (mut routes, mut scratch) = (Routes::default(), Scratch::default());
        let control = Control::default();
        group.throughput(Throughput::Elements(n_graphs * u64::from(size)));
        group.bench_with_input(BenchmarkId::new("search", size), &graphs, |b, graphs| {
            b.iter(|| {
                for (graph, root) in graphs {
                    search_with(black_box(graph), *root, &mut routes, &mut scratch, &control)
                        .expect("not cancelled");
                }
            });
        });
    }
    group.finish();
}

fn presets(c: &mut Criterion) {
    let mut group = c.benchmark_group("preset");
    group.sample_size(10);
    for preset in PRESETS {
        let params = preset.params().expect("a preset");
        group.bench_function(preset.name(), |b| {
            b.iter(|| params.grow(Seed(1), &Control::default()).expect("a tree"));
        });
    }
    group.finish();
}

criterion_group!(benches, stages, presets);
criterion_main!(benches);
