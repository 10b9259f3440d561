//! Derivation of L-systems, in modules written per second.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::{Control, Limits, Seed};
use tree_model::lsystem::Grammar;

/// Name, text and steps: a ternary tree (442,861 modules), a monopodial tree of ABOP Fig. 2.6, a stochastic one,
/// and one with contexts.
const GRAMMARS: [(&str, &str, u32); 4] = [
    (
        "ternary",
        "axiom: A(1,1)\nA(l,w) -> !(w)F(l)[&(45)A(l*.7,w*.6)]/(120)[&(45)A(l*.7,w*.6)]/(120)[&(45)A(l*.7,w*.6)]",
        10,
    ),
    (
        "monopodial",
        "axiom: A(1,10)\n\
         A(l,w) -> !(w)F(l)[&(45)B(l*.6,w*.707)]/(137.5)A(l*.9,w*.707)\n\
         B(l,w) -> !(w)F(l)[-(45)$C(l*.6,w*.707)]C(l*.9,w*.707)\n\
         C(l,w) -> !(w)F(l)[+(45)$B(l*.6,w*.707)]B(l*.9,w*.707)",
        16,
    ),
    (
        "stochastic",
        "axiom: A(1)\nA(l) -> F(l)[+(30)A(l*.7)][-(30)A(l*.7)] : 1\nA(l) -> F(l)[+(30)A(l*.7)]A(l*.8) : 2",
        17,
    ),
    ("context", "axiom: A(1)\nA(l) -> F(l)[+(30)A(l*.7)][-(30)A(l*.7)]\nF(a) < F(b) -> F(a+b)", 17),
];

fn derive(c: &mut Criterion) {
    let mut group = c.benchmark_group("lsystem, last step");
    let control = Control::default();
    for (name, text, steps) in GRAMMARS {
        let Ok(grammar) = Grammar::parse(text, &Limits::default()) else { continue };
        let Ok(before) = grammar.derive(Some(steps - 1), Seed(1), &control) else { continue };
        let step = || grammar.step(black_box(&before.word), steps - 1, steps, Seed(1), &control);
        let Ok(after) = step() else { continue };
        group.throughput(Throughput::Elements(after.len() as u64));
        group.bench_function(name, |b| b.iter_batched(|| (), |()| step(), BatchSize::LargeInput));
    }
    group.finish();
}

criterion_group!(benches, derive);
criterion_main!(benches);
