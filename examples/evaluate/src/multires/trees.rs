//! The trees of the evaluation.

use super::{Outcome, SEED};
use std::path::Path;
use tree_core::{Control, Limits, Species, Tree, swc};
use tree_model::lsystem::LSystem;
use tree_model::path;

/// A named tree.
pub(super) struct Case {
    pub(super) name: String,
    pub(super) tree: Tree,
}

/// Presets of L-systems: leafy species of ours, and bare ones of the books.
const SYSTEMS: [&str; 7] =
    ["oak", "birch", "spruce", "willow", "honda-a", "aono-kunii-a", "ternary-a"];
/// Presets of least-cost paths.
const PATHS: [&str; 3] = ["oak", "c", "g"];
/// A scanned tree takes the place of the last where it is there.
const SCANNED: &str = "cherry_plantscan3d.swc";

/// Ten trees: seven of L-systems, two or three of another modeler, a scanned one.
pub(super) fn ten() -> Outcome<Vec<Case>> {
    let mut cases = Vec::new();
    for name in SYSTEMS {
        let tree = LSystem::preset(name)?.grow(SEED, &Control::default())?.tree;
        cases.push(Case { name: name.into(), tree });
    }
    for name in PATHS {
        let grown = path::Preset::find(name)?.params()?.grow(SEED, &Control::default())?;
        cases.push(Case { name: format!("path {name}"), tree: grown.tree });
    }
    let scans = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/skeletons");
    let file = scans.join(SCANNED);
    if file.exists() {
        let read = swc::read_file(&file, &swc::SwcOptions::default(), &Limits::default())?;
        let tree = Tree::bare(read.skeleton, Species::default());
        cases.pop();
        cases.push(Case { name: "cherry, scanned".into(), tree });
    } else {
        eprintln!("{SCANNED}: not there, left out");
    }
    Ok(cases)
}
