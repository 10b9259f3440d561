//! Positions and reach of branches.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::{Control, Seed};
use tree_model::silhouette::place::{Arrangement, Domain, GibbsParams, arrange};

fn gibbs(c: &mut Criterion) {
    let mut group = c.benchmark_group("gibbs, 3000 moves");
    let params = GibbsParams { quiet: 0.0, ..GibbsParams::default() };
    for arrangement in [Arrangement::Spread, Arrangement::Decussate] {
        for n in [50, 300] {
            let drawn = (0..n / 3).map(|i| Domain::drawn(Seed(1).unit(i), i % 2 == 0));
            let free = (n / 3..n).map(|_| Domain::default());
            let domains: Vec<Domain> = drawn.chain(free).collect();
            let id = BenchmarkId::new(arrangement.to_string(), n);
            group.bench_with_input(id, &domains, |b, domains| {
                let control = Control::default();
                b.iter(|| arrange(black_box(domains), &arrangement, &params, Seed(2), &control));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, gibbs);
criterion_main!(benches);
