//! How long a frame of scene selection takes, the camera walking.
#![allow(clippy::expect_used)]

mod forest;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_lod::select::{
    DepthBuffer, DrawIndexed, Frame, InstanceLod, Occlusion, SceneParams, State,
};
use tree_lod::tree_core::Control;

/// Pixels of the engine's depth buffer.
const SIZE: (u32, u32) = (640, 360);

fn select(c: &mut Criterion) {
    let mut group = c.benchmark_group("select");
    let depths = forest::depths(SIZE.0, SIZE.1);
    let params = SceneParams::default();
    for n in [5_000, 100_000] {
        let scene = forest::forest(n);
        let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
        let mut rows = vec![InstanceLod::default(); scene.len()];
        for (name, kind) in [("no_occlusion", 0), ("built_in", 1), ("depth_buffer", 2)] {
            let mut state = State::new(&scene, &Control::default()).expect("a state");
            let mut i = 0;
            group.bench_function(BenchmarkId::new(name, n), |b| {
                b.iter(|| {
                    // The depths are those of the frame before.
                    let before = forest::eye(n, i);
                    i += 1;
                    let occlusion = match kind {
                        0 => Occlusion::None,
                        1 => Occlusion::BuiltIn,
                        _ => Occlusion::Depth(DepthBuffer {
                            depths: &depths,
                            width: SIZE.0,
                            height: SIZE.1,
                            eye: before,
                            y_down: false,
                        }),
                    };
                    let eye = forest::eye(n, i);
                    let frame = Frame { eye, occlusion, seconds: 0.016, cut: false };
                    black_box(scene.select(&frame, &params, &mut state))
                });
            });
            group.bench_function(BenchmarkId::new(format!("{name}_batches"), n), |b| {
                b.iter(|| black_box(scene.batches(&mut state, &mut draws, &mut rows)));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, select);
criterion_main!(benches);
