//! Skeletons, point clouds and grammars.

use crate::{control, limits};
use tree_core::{Control, Limits, Seed, swc};
use tree_mesh::io::points as clouds;
use tree_model::lsystem::Grammar;
use tree_model::skeletonize::{ScanParams, skeletonize_scan};

/// SWC: what was read can be written.
pub fn swc(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let options = swc::SwcOptions::default();
    if let Ok(import) = swc::read(&text, &options, &limits()) {
        let again = swc::write(&import.skeleton, &options).expect("a skeleton that was read");
        let _ = swc::read(&again, &options, &limits());
    }
}

/// The first byte picks the reader. A cloud that was read becomes trees or a typed error.
pub fn points(data: &[u8]) {
    let Some((&reader, bytes)) = data.split_first() else { return };
    let control = control();
    let read = match reader % 2 {
        0 => clouds::from_ply(bytes, &control),
        _ => clouds::from_text(bytes, &control),
    };
    let Ok(cloud) = read else { return };
    if let Ok(made) = skeletonize_scan(&cloud.positions, &ScanParams::default(), &control) {
        assert!(!made.trees.is_empty());
        for tree in &made.trees {
            tree.skeleton.check().expect("a skeleton");
        }
    }
}

/// Grammars: words that are derived are whole, and the same twice.
pub fn lsystem(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let limits = Limits { modules: 5_000, ..limits() };
    let control = Control::default().with_limits(limits);
    let Ok(grammar) = Grammar::parse(&text, &limits) else { return };
    // Words that do not grow could be derived for ever.
    let steps = grammar.steps().clamp(3, 8);
    let Ok(derived) = grammar.derive(Some(steps), grammar.seed(), &control) else { return };
    let word = derived.word;
    word.check(grammar.symbols()).expect("pairs of brackets and known kinds");
    assert!(word.params().iter().all(|x| x.is_finite()));
    if let Ok(seen) = grammar.interpretation(&word, Seed(1), &control) {
        seen.check(grammar.symbols()).expect("pairs of brackets and known kinds");
    }
    let again = Grammar::parse(grammar.text(), &limits).expect("what was read");
    assert_eq!(again.derive(Some(steps), grammar.seed(), &control).expect("the same").word, word);
}
