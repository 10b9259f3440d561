//! How long a 1024² picture takes, by number of triangles.

mod synthetic;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_lod::preview::{Style, View, mask, render};
use tree_lod::tree_core::Control;

fn preview(c: &mut Criterion) {
    let (view, style, control) = (View::default(), Style::default(), Control::default());
    let mut group = c.benchmark_group("preview_1024");
    group.sample_size(10);
    for n in [5_000, 50_000, 500_000] {
        let mesh = synthetic::tree(n);
        group.bench_with_input(BenchmarkId::new("render", n), &mesh, |b, mesh| {
            b.iter(|| black_box(render(mesh, &view, &style, &control)));
        });
        group.bench_with_input(BenchmarkId::new("mask", n), &mesh, |b, mesh| {
            b.iter(|| black_box(mask(mesh, &view, &control)));
        });
    }
    group.finish();
}

criterion_group!(benches, preview);
criterion_main!(benches);
