//! A frame of scene selection allocates nothing.

mod counting;
#[allow(dead_code)]
#[path = "../benches/forest/mod.rs"]
mod forest;

use counting::allocations;
use tree_lod::select::{
    DepthBuffer, DrawIndexed, Frame, InstanceLod, Occlusion, SceneParams, State,
};
use tree_lod::tree_core::Control;

#[test]
fn a_frame_allocates_nothing() {
    let n = 3000;
    let scene = forest::forest(n);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
    let mut rows = vec![InstanceLod::default(); scene.len()];
    let depths = forest::depths(160, 90);
    let params = SceneParams::default();
    let before = allocations();
    let mut drawn = 0;
    for i in 0..30 {
        let eye = forest::eye(n, 20 * i);
        let buffer = DepthBuffer { depths: &depths, width: 160, height: 90, eye, y_down: false };
        let occlusion = match i % 3 {
            0 => Occlusion::None,
            1 => Occlusion::BuiltIn,
            _ => Occlusion::Depth(buffer),
        };
        let frame = Frame { eye, occlusion, seconds: 0.016, cut: i == 10 };
        drawn += scene.select(&frame, &params, &mut state).unwrap().n_drawn;
        scene.draws(&state, &mut draws, &mut rows).unwrap();
        scene.batches(&mut state, &mut draws, &mut rows).unwrap();
    }
    assert_eq!(allocations() - before, 0);
    assert!(drawn > 10_000, "{drawn}");
}
