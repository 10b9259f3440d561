use super::*;
use crate::glam::Vec3;
use crate::lsystem::turtle::lines;
use tree_core::{Continuation, Control, Seed};

fn tree(name: &str, seed: u64) -> tree_core::Tree {
    let system = Preset::find(name).unwrap().system().unwrap();
    system.grow(Seed(seed), &Control::default()).unwrap().tree
}

/// Positions of the first nodes of a preset in its own units.
fn raw(name: &str, steps: u32) -> Vec<[Vec3; 2]> {
    let system = Preset::find(name).unwrap().system().unwrap();
    let control = Control::default();
    let derived = system.grammar.derive(Some(steps), Seed(1), &control).unwrap();
    let turtle = crate::lsystem::TurtleParams { elasticity: 0.0, ..system.turtle };
    lines(&derived.word, system.grammar.symbols(), &turtle, &control).unwrap()
}

#[test]
fn every_preset_grows_a_tree_of_its_height() {
    for preset in presets() {
        let mut system = preset.system().unwrap();
        // Small ones are enough where published systems grow without end.
        system.steps =
            Some(system.grammar.steps().min(if preset.source().is_empty() { 80 } else { 4 }));
        let grown = system.grow(Seed(1), &Control::default()).unwrap();
        assert!(grown.tree.skeleton().len() > 3, "{}", preset.name());
        if let Some(height) = system.turtle.height {
            let top = grown.tree.skeleton().bounds().max.y;
            assert!((top - height).abs() < 1e-3, "{} {top}", preset.name());
        }
    }
}

#[test]
fn names_are_unique_and_unknown_ones_are_listed() {
    let mut names: Vec<_> = presets().map(|preset| preset.name()).collect();
    names.sort_unstable();
    let n = names.len();
    names.dedup();
    assert_eq!(names.len(), n);
    let error = Preset::find("baobab").unwrap_err().to_string();
    assert!(error.contains("honda-a"), "{error}");
}

#[test]
fn leafy_species_have_hundreds_of_branches_and_differ_by_seed() {
    for name in ["oak", "birch", "spruce", "willow"] {
        let (a, b) = (tree(name, 1), tree(name, 2));
        let axes = a.skeleton().axes(Continuation::Thickest).len();
        assert!(axes > 300 && a.foliage().len() > 2000, "{name}: {axes} {}", a.foliage().len());
        assert_ne!(a, b, "{name}");
        assert_eq!(a, tree(name, 1), "{name}");
    }
}

#[test]
fn node_counts_of_the_books_plants_are_those_of_their_productions() {
    // F -> F[+F]F[-F]F makes five of one.
    assert_eq!(raw("abop-1.24a", 5).len(), 5_usize.pow(5));
    assert_eq!(raw("thesis-a", 5).len(), 5_usize.pow(5));
    // F -> F[+F]F[-F][F] makes five of one; FF-[-F+F+F]+[+F-F-F] eight.
    assert_eq!(raw("abop-1.24b", 3).len(), 125);
    assert_eq!(raw("abop-1.24c", 4).len(), 8_usize.pow(4));
    // X -> F[+X][-X]FX: a(n) = 3 a(n - 1) + 2^n.
    let count = (1..=5).fold(0, |n, k| 3 * n + 2_usize.pow(k));
    assert_eq!(raw("thesis-b", 5).len(), count);
}

#[test]
fn hondas_lengths_and_angles_are_those_of_the_table() {
    // A(1) = F(1)[&(45)B(0.6)]/(137.5)A(0.9).
    let all = raw("honda-a", 2);
    let along = |i: usize| all[i][1] - all[i][0];
    let lengths: Vec<f32> = (0..3).map(|i| along(i).length()).collect();
    assert!((lengths[0] - 1.0).abs() < 1e-6);
    assert!((lengths[1] - 0.6).abs() < 1e-6 && (lengths[2] - 0.9).abs() < 1e-6, "{lengths:?}");
    let angle = along(0).angle_between(along(1)).to_degrees();
    assert!((angle - 45.0).abs() < 1e-3, "{angle}");
}

#[test]
fn sympodial_forks_have_the_angles_of_the_table() {
    // A(1) = F(1)[&(5)B(0.9)]/(180)[&(65)B(0.7)]: 70 degrees between both.
    let all = raw("aono-kunii-a", 2);
    let along = |i: usize| all[i][1] - all[i][0];
    let angle = along(1).angle_between(along(2)).to_degrees();
    assert!((angle - 70.0).abs() < 1e-3, "{angle}");
}
