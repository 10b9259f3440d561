#![no_main]

use tree_core::Seed;
use tree_model::silhouette::read;
use tree_model::silhouette::session::{Session, SilhouetteParams};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let Ok(drawing) = read::from_svg(&String::from_utf8_lossy(data)) else { return };
    for tree in drawing.trees.iter().take(2) {
        // A drawing has tens of strokes.
        if tree.strokes.len() > 50 {
            continue;
        }
        let Ok((session, _)) = Session::of_drawing(tree, SilhouetteParams::default(), Seed(1))
        else {
            continue;
        };
        if let Ok(grown) = session.tree(&tree_fuzz::control()) {
            assert_eq!(grown.report.n_leaves as usize, grown.tree.foliage().len());
        }
    }
});
