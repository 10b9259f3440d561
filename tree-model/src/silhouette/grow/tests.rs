use super::*;
use crate::silhouette::place::Arrangement;
use crate::silhouette::session::{Session, SilhouetteParams};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;
use tree_core::{CancelFlag, Control, Limits, Seed, Tree};

fn session(params: SilhouetteParams) -> Session {
    let crown: Vec<Vec2> = (0..120)
        .map(|i| {
            let angle = i as f32 / 120.0 * TAU;
            let radius = 3.0 + 0.4 * libm::cosf(6.0 * angle);
            let (sin, cos) = libm::sincosf(angle);
            Vec2::new(radius * cos, 6.0 + 1.2 * radius * sin)
        })
        .collect();
    let mut session = Session::new(params, Seed(3)).unwrap();
    session.draw_trunk(&[Vec2::ZERO, Vec2::new(0.1, 4.0), Vec2::new(0.0, 8.0)]).unwrap();
    session.draw_crown(&crown).unwrap();
    session
}

fn tree(params: GrowParams) -> (Tree, GrowReport) {
    let session = session(SilhouetteParams { grow: params, ..SilhouetteParams::default() });
    let grown = session.tree(&Control::default()).unwrap();
    (grown.tree, grown.report)
}

/// Share of the leaves' middles inside what `is_inside` tells.
fn share(tree: &Tree, is_inside: impl Fn(Vec3) -> bool) -> f32 {
    let leaves = tree.foliage();
    let middle = |i: usize| {
        leaves.positions()[i] + 0.5 * leaves.sizes()[i] * (leaves.rotations()[i] * Vec3::Y)
    };
    let inside = (0..leaves.len()).filter(|&i| is_inside(middle(i))).count();
    inside as f32 / leaves.len() as f32
}

#[test]
fn leaves_are_inside_the_outline_and_all_over_it() {
    let session = session(SilhouetteParams::default());
    let grown = session.tree(&Control::default()).unwrap();
    let outline = &session.plan().unwrap().system.outline;
    let inside = share(&grown.tree, |p| outline.contains(p.truncate()));
    assert!(inside > 0.97, "{inside}");
    let (low, high) = outline.bounds();
    let wanted = outline.mask(low, high, 24, 24);
    let mut seen = vec![false; wanted.len()];
    for &position in grown.tree.foliage().positions() {
        let cell = ((position.truncate() - low) / (high - low) * 24.0)
            .clamp(Vec2::ZERO, Vec2::splat(23.0));
        seen[cell.y as usize * 24 + cell.x as usize] = true;
    }
    let bare = wanted.iter().zip(&seen).filter(|&(&wanted, &seen)| wanted && !seen).count();
    assert!(bare < wanted.len() / 20, "{bare} cells are bare");
}

#[test]
fn the_same_seed_gives_the_same_bits_for_any_number_of_threads() {
    let session = session(SilhouetteParams::default());
    let grow = || session.tree(&Control::default()).unwrap().tree;
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    assert_eq!(pool(1).install(grow), pool(3).install(grow));
}

#[test]
fn counts_agree_with_the_tree() {
    let (tree, report) = tree(GrowParams::default());
    assert_eq!(report.n_leaves as usize, tree.foliage().len());
    assert_eq!(report.branches[0], 1);
    assert!(report.branches[1] >= report.n_sketched);
    assert_eq!(report.elements(), report.n_leaves + report.branches.iter().sum::<u64>());
}

#[test]
fn density_adds_branches_in_space() {
    let with = |density: f32| {
        let level = LevelParams { density, ..LevelParams::default() };
        tree(GrowParams { levels: vec![level], ..GrowParams::default() }).1.branches[1]
    };
    assert!(with(0.0) < with(1.0) && with(1.0) < with(3.0));
}

#[test]
fn opposite_branches_stay_near_the_plane_of_the_drawing() {
    let level = LevelParams { arrangement: Arrangement::Opposite, ..LevelParams::default() };
    let params = GrowParams { levels: vec![level], leaves: None, ..GrowParams::default() };
    let (tree, _) = tree(params);
    let children = tree.skeleton().children();
    assert!(!children.of(0).is_empty());
    assert!(tree.foliage().is_empty());
}

#[test]
fn limits_and_cancelling_are_heeded() {
    let session = session(SilhouetteParams::default());
    let few = Control::default().with_limits(Limits { leaves: 10, ..Limits::default() });
    assert!(matches!(session.tree(&few), Err(crate::ModelError::Limit(_))));
    let flag = CancelFlag::default();
    flag.cancel();
    let cancelled = Control::default().with_cancel(flag);
    assert!(matches!(session.tree(&cancelled), Err(crate::ModelError::Cancelled(_))));
}

#[test]
fn a_spiral_bends_branches_out_of_their_plane_and_leaves_their_ends() {
    let line =
        crate::silhouette::Line::new(vec![Vec2::ZERO, Vec2::new(0.3, 0.5), Vec2::Y]).unwrap();
    let nodes = pattern::Nodes::of(&line, &[]);
    let (flat, spiral) = (nodes.points(0.0), nodes.points(2.0));
    assert_eq!(flat[2], spiral[2]);
    assert!(flat.iter().all(|point| point.z == 0.0));
    let more = pattern::Nodes::of(&line, &[0.2, 0.8]).points(2.0);
    assert!(more.iter().any(|point| point.z.abs() > 0.01));
}
