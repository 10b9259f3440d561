//! Drawings: strokes, sketches and outlines.

use crate::control;
use tree_core::glam::{Vec2, Vec3};
use tree_core::{Control, Seed};
use tree_model::particle::attractor::{StrokeParams, from_strokes, strokes_from_svg};
use tree_model::path::{Profile, ProfileOptions};
use tree_model::silhouette::session::{Session, SilhouetteParams};
use tree_model::sketch::clean::{CleanParams, clean};
use tree_model::sketch::{Drawing, read};

/// Profiles of volumes, and strokes that attract.
pub fn svg(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    if let Ok(profile) = Profile::from_svg(&text, &ProfileOptions::default()) {
        let _ = profile.volume(Vec3::ZERO);
    }
    let picture = Vec2::new(64.0, 48.0);
    if let Ok(strokes) = strokes_from_svg(&text, picture) {
        assert!(!strokes.is_empty(), "a drawing without strokes is an error");
        // Joining compares all strokes with each other; a drawing has tens.
        if strokes.len() <= 50 && strokes.iter().map(Vec::len).sum::<usize>() <= 1000 {
            let base = Vec2::new(32.0, 48.0);
            let _ = from_strokes(&strokes, base, &StrokeParams::default(), &Control::default());
        }
    }
}

/// Sketches as SVG, JSON and NDJSON: what was read can be written and cleaned.
pub fn sketch(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let mut drawings: Vec<Drawing> = read::from_svg(&text).into_iter().collect();
    drawings.extend(read::from_json(&text));
    drawings.extend(read::from_ndjson(&text).unwrap_or_default());
    for drawing in drawings.iter().take(4) {
        if let Ok(written) = read::to_json(drawing) {
            assert_eq!(&read::from_json(&written).expect("what was written"), drawing);
        }
        // Strokes are compared with each other; a drawing has tens.
        if drawing.strokes.len() > 50 {
            continue;
        }
        if let Ok(cleaned) = clean(drawing, &CleanParams::default(), &control()) {
            assert!(cleaned.plan.positions().iter().all(|p| p.is_finite()));
            assert!(cleaned.crown.iter().flatten().all(|p| p.is_finite()));
        }
    }
}

/// Outlines: trees grow in what was read.
pub fn silhouette(data: &[u8]) {
    let Ok(drawing) = tree_model::silhouette::read::from_svg(&String::from_utf8_lossy(data)) else {
        return;
    };
    for tree in drawing.trees.iter().take(2) {
        // A drawing has tens of strokes.
        if tree.strokes.len() > 50 {
            continue;
        }
        let Ok((session, _)) = Session::of_drawing(tree, SilhouetteParams::default(), Seed(1))
        else {
            continue;
        };
        if let Ok(grown) = session.tree(&control()) {
            assert_eq!(grown.report.n_leaves as usize, grown.tree.foliage().len());
        }
    }
}
