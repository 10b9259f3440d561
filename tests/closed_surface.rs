//! Bark is one closed surface, whatever skeleton it is built on.

#![allow(clippy::unwrap_used)]

mod common;

use common::skeletons;
use tree_core::glam::{Vec3, Vec4};
use tree_core::{Control, Seed, Skeleton, Species, Tree};
use tree_mesh::topology::{Topology, examine};
use tree_mesh::{Look, MeshParams, Surface, build};
use tree_model::path::PRESETS;

const CASES: u64 = 10_000;
/// Every so many cases one is tame.
const TAME_EVERY: u64 = 5;
/// How far the volume of tame trees may be from that of their frusta.
const VOLUME_SLACK: f64 = 0.1;

fn bark(tree: &Tree, params: &MeshParams) -> Result<(Surface, Topology), String> {
    let look = Look::plain(tree.species());
    let built = build(tree, &look, params, &Control::default()).map_err(|e| e.to_string())?;
    built.mesh.check().map_err(|e| e.to_string())?;
    built.mesh.check_normals().map_err(|e| e.to_string())?;
    let surface = built.mesh.surfaces.into_iter().next().ok_or("no bark")?;
    let found = examine(&surface).map_err(|e| e.to_string())?;
    Ok((surface, found))
}

/// What must hold of every bark. Tame ones enclose a positive volume; wood that runs back through itself,
/// thicker than long, may have more inside than outside.
fn flaw(surface: &Surface, found: &Topology, tame: bool) -> Option<String> {
    let wrong = |what: &str| Some(format!("{what}: {found:?}"));
    if !found.is_closed() {
        return wrong("not a closed manifold");
    }
    if found.euler() != 2 || found.components != 1 {
        return wrong("not one piece without handles");
    }
    if tame && found.volume <= 0.0 {
        return wrong("turned inside out");
    }
    if found.flat_triangles > 0 || found.collapsed_triangles > 0 {
        return wrong("triangles without area");
    }
    let skew = |(t, n): (&Vec4, &Vec3)| {
        let t = t.truncate();
        (t.length() - 1.0).abs() > 0.01 || t.dot(*n).abs() > 0.01
    };
    if surface.tangents.iter().zip(&surface.normals).any(skew) {
        return wrong("a tangent is not unit or not across its normal");
    }
    None
}

fn with_tangents() -> MeshParams {
    MeshParams { tangents: true, ..MeshParams::default() }
}

fn is_one_point(skeleton: &Skeleton) -> bool {
    let first = skeleton.positions().first().copied().unwrap_or_default();
    skeleton.positions().iter().all(|&p| p == first)
}

#[test]
fn every_skeleton_gets_one_closed_surface() {
    for case in 0..CASES {
        let seed = Seed(case);
        let tame = case % TAME_EVERY == 0;
        let skeleton = if tame { skeletons::tame(seed) } else { skeletons::nasty(seed) };
        if is_one_point(&skeleton) {
            continue;
        }
        let tree = Tree::bare(skeleton, Species::default());
        let outcome = bark(&tree, &with_tangents());
        let flaw = match &outcome {
            Ok((surface, found)) => flaw(surface, found, tame),
            Err(error) => Some(error.clone()),
        };
        if let Some(flaw) = flaw {
            panic!("seed {case} ({}): {flaw}", if tame { "tame" } else { "nasty" });
        }
    }
}

#[test]
fn tame_trees_have_the_volume_of_their_frusta() {
    // Many sides: a polygon of 32 has 99.4 % of its circle's area.
    let params = MeshParams { min_sides: 32, max_sides: 32, flare: 0.0, ..MeshParams::default() };
    for case in (0..CASES).step_by(10) {
        let skeleton = skeletons::tame(Seed(case));
        let expected = skeletons::frusta_volume(&skeleton, params.min_radius);
        let tree = Tree::bare(skeleton, Species::default());
        let (_, found) = bark(&tree, &params).unwrap();
        let share = found.volume / expected;
        assert!((share - 1.0).abs() < VOLUME_SLACK, "seed {case}: {share} of the frusta");
    }
}

#[test]
fn every_preset_gets_one_closed_surface() {
    for preset in PRESETS {
        let grown = preset.params().unwrap().grow(Seed(3), &Control::default()).unwrap();
        let (surface, found) = bark(&grown.tree, &with_tangents()).unwrap();
        if let Some(flaw) = flaw(&surface, &found, true) {
            panic!("preset {}: {flaw}", preset.name());
        }
    }
}

/// Runs today: the generators must make what they promise.
#[test]
fn the_skeletons_are_as_ugly_as_they_should_be() {
    let (mut no_length, mut thick, mut crowded, mut growing, mut down) = (0, 0, 0, 0, 0);
    for case in 0..500 {
        let skeleton = skeletons::nasty(Seed(case));
        skeleton.check().unwrap();
        let (positions, radii) = (skeleton.positions(), skeleton.radii());
        let children = skeleton.children();
        for (parent, child) in skeleton.segments() {
            let (p, c) = (parent as usize, child as usize);
            let length = positions[p].distance(positions[c]);
            no_length += u32::from(length == 0.0);
            thick += u32::from(length < radii[c]);
            growing += u32::from(radii[c] > radii[p]);
            down += u32::from(positions[c].y < positions[p].y);
        }
        crowded += u32::from((0..skeleton.len() as u32).any(|n| children.of(n).len() >= 10));
        assert_eq!(skeleton, skeletons::nasty(Seed(case)));
        skeletons::tame(Seed(case)).check().unwrap();
    }
    for n in [no_length, thick, crowded, growing, down] {
        assert!(n > 50, "{:?}", [no_length, thick, crowded, growing, down]);
    }
    for skeleton in [skeletons::ladder(20), skeletons::whorls(5, 5, 3), skeletons::pine(4)] {
        assert!(skeletons::frusta_volume(&skeleton, 0.0) > 0.0);
    }
}
