//! What is drawn of a hybrid model is chosen without allocating.

mod counting;

use counting::allocations;
use tree_lod::glam::{Quat, Vec3};
use tree_lod::hybrid::{Hybrid, HybridParams};
use tree_lod::impostor::boxes::BoxParams;
use tree_lod::impostor::cards::CardParams;
use tree_lod::impostor::choose::Watcher;
use tree_lod::tree_core::{Control, CoreError, Foliage, Leaf, Skeleton, Species, Tree};
use tree_lod::tree_mesh::Look;

/// Sixteen boughs on a trunk, leaves all along each.
fn tree() -> Result<Tree, CoreError> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
    let mut foliage = Foliage::default();
    let mut trunk = 0;
    for i in 1..=16_u32 {
        let foot = Vec3::Y * 0.5 * i as f32;
        trunk = builder.add(trunk, foot, 0.1)?;
        let mut node = trunk;
        for k in 1..=20 {
            let around = Quat::from_rotation_y(2.4 * i as f32 + 0.02 * k as f32);
            let position = foot + around * Vec3::new(0.1 * k as f32, 0.05 * k as f32, 0.0);
            node = builder.add(node, position, 0.01)?;
            for l in 0..4 {
                let rotation = around * Quat::from_rotation_x(l as f32);
                foliage.push(Leaf { node, position, rotation, size: 0.1, kind: 0 })?;
            }
        }
    }
    Tree::new(builder.finish(), foliage, Species::default())
}

#[test]
fn a_frame_allocates_nothing() {
    let tree = tree().unwrap();
    let boxes = BoxParams { least_volume: 0.001, ..BoxParams::default() };
    let cards = CardParams { size: 32, samples: 1, ..CardParams::default() };
    let params = HybridParams { boxes, cards, ..HybridParams::default() };
    let look = Look::plain(tree.species());
    let hybrid = Hybrid::make(&tree, &look, &params, &Control::default()).unwrap();
    let mut choices: Vec<_> = (0..50).map(|_| hybrid.choice().unwrap()).collect();
    let before = allocations();
    let (mut triangles, mut fewest, mut most) = (0, u64::MAX, 0);
    for frame in 0..60 {
        for (i, choice) in choices.iter_mut().enumerate() {
            // From far off to among the leaves, and back.
            let away = 0.3 * ((frame - 30) * (frame - 30)) as f32 + 3.0 * i as f32;
            let eye = Vec3::new(away, 2.0, 0.1);
            hybrid.update(choice, &Watcher { eye, pixels_per_metre: 900.0 }).unwrap();
            let n = hybrid.n_triangles(choice);
            (triangles, fewest, most) = (triangles + n, fewest.min(n), most.max(n));
        }
    }
    assert_eq!(allocations(), before);
    assert!(triangles > 0 && fewest * 2 < most, "near and far differ: {fewest} {most}");
}
