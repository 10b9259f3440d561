//! Tests of stands.

use super::*;
use crate::error::ModelError;
use crate::silhouette::read::{Kind, Level, LevelStroke, OutlineDrawing, TreeStrokes};
use crate::silhouette::session::SilhouetteParams;
use glam::Vec2;
use tree_core::{CancelFlag, Control, Seed};

/// A line or outline of a level.
fn stroke(level: Level, kind: Kind, points: Vec<Vec2>) -> LevelStroke {
    LevelStroke { level, kind, azimuth: 0.0, points, name: String::new() }
}

fn lobes(center: Vec2, radii: Vec2, n: f32) -> Vec<Vec2> {
    let at = |i: usize| {
        let angle = std::f32::consts::TAU * i as f32 / 60.0;
        let (sin, cos) = libm::sincosf(angle);
        center + (1.0 + 0.2 * libm::cosf(n * angle)) * radii * Vec2::new(cos, sin)
    };
    (0..60).map(at).collect()
}

/// A tree of a trunk and a crown, its foot at a place, y down.
fn plain(foot: Vec2, size: f32) -> TreeStrokes {
    let up = |share: f32| foot - Vec2::new(0.0, share * size);
    let crown = lobes(up(0.6), Vec2::new(0.28, 0.34) * size, 5.0);
    let strokes = vec![
        stroke(Level::Number(0), Kind::Axis, vec![foot, up(0.4), up(0.8)]),
        stroke(Level::Number(0), Kind::Outline, crown),
    ];
    TreeStrokes { name: String::new(), strokes, trunk_width: None }
}

/// The same with the outline of a branch and a leaf.
fn detailed(foot: Vec2, size: f32) -> TreeStrokes {
    let mut tree = plain(foot, size);
    let branch = foot + Vec2::new(0.2, -0.6) * size;
    let foliage = lobes(branch, Vec2::new(0.14, 0.09) * size, 6.0);
    tree.strokes.push(stroke(Level::Number(1), Kind::Outline, foliage));
    let leaf = lobes(foot, Vec2::new(0.02, 0.05) * size, 1.0);
    tree.strokes.push(stroke(Level::Leaf, Kind::Outline, leaf));
    tree
}

/// Three small trees from left to right, the first with details.
fn three() -> OutlineDrawing {
    let trees = vec![
        detailed(Vec2::new(100.0, 300.0), 100.0),
        plain(Vec2::new(220.0, 303.0), 80.0),
        plain(Vec2::new(330.0, 298.0), 90.0),
    ];
    OutlineDrawing { trees, repairs: Vec::new() }
}

/// Five plain trees of one height, seen from an eye 250 units above the nearest ground point; horizon at 50.
fn in_perspective() -> OutlineDrawing {
    let tree = |(i, below): (usize, f32)| {
        plain(Vec2::new(100.0 + 90.0 * i as f32, 50.0 + below), 0.8 * below)
    };
    let belows = [250.0, 180.0, 130.0, 210.0, 100.0];
    OutlineDrawing {
        trees: belows.into_iter().enumerate().map(tree).collect(),
        repairs: Vec::new(),
    }
}

fn params() -> StandParams {
    let silhouette = SilhouetteParams { height: 2.0, ..SilhouetteParams::default() };
    StandParams { silhouette, ..StandParams::default() }
}

fn grow(drawing: &OutlineDrawing, params: &StandParams) -> crate::error::Result<Stand> {
    Stand::of_drawing(drawing, params, Seed(3), &Control::default())
}

fn foliage_height(tree: &StandTree) -> f32 {
    tree.plan().map_or(0.0, |plan| plan.system.outline.bounds().1.y)
}

#[test]
fn every_outline_becomes_a_tree_with_leaves() {
    let stand = grow(&three(), &params()).unwrap();
    assert_eq!(stand.trees.len(), 3, "{:?}", stand.notes);
    assert!(stand.trees.iter().all(|tree| tree.grown.report.n_leaves > 0));
    assert!(stand.notes.is_empty(), "{:?}", stand.notes);
}

#[test]
fn trees_keep_their_order_from_left_to_right() {
    let stand = grow(&three(), &params()).unwrap();
    assert!(stand.trees.windows(2).all(|pair| pair[0].position.x < pair[1].position.x));
    assert!(stand.view.is_none(), "the ground points are on one line");
}

#[test]
fn the_tallest_tree_has_the_height_asked_for() {
    let stand = grow(&three(), &params()).unwrap();
    let scales: Vec<f32> = stand.trees.iter().map(|tree| tree.scale).collect();
    assert!(scales.iter().all(|&scale| scale == scales[0]));
    let tallest = stand.trees.iter().map(foliage_height).fold(0.0, f32::max);
    assert!((1.9..2.1).contains(&tallest), "{tallest}");
}

#[test]
fn trees_without_details_have_the_levels_and_the_leaf_of_their_lender() {
    let stand = grow(&three(), &params()).unwrap();
    let plans: Vec<_> = stand.trees.iter().filter_map(StandTree::plan).collect();
    assert_eq!(plans[0].n_levels(), 2, "{:?}", stand.trees[0].strokes);
    assert!(plans[0].lenders.is_empty());
    for (tree, plan) in stand.trees.iter().zip(&plans).skip(1) {
        assert_eq!(tree.lender, Some(0));
        assert_eq!(plan.n_levels(), 2);
        let lent = plan.leaf.as_ref().unwrap().length;
        let own = plans[0].leaf.as_ref().unwrap().length;
        assert!((lent - tree.borrowed_scale * own).abs() < 1e-6);
    }
    let levels = |tree: &StandTree| tree.grown.report.branches.len();
    assert!(stand.trees.iter().all(|tree| levels(tree) == levels(&stand.trees[0])));
}

#[test]
fn borrowed_branches_are_scaled_and_have_names_of_their_own() {
    let stand = grow(&three(), &params()).unwrap();
    let (lender, tree) = (stand.trees[0].plan().unwrap(), &stand.trees[1]);
    let plan = tree.plan().unwrap();
    let theirs = lender.system.laterals.iter().find(|lateral| lateral.system.is_some()).unwrap();
    let lent = &plan.lenders[0];
    let ratio = lent.line.length() / theirs.line.length();
    assert!((ratio - tree.borrowed_scale).abs() < 1e-3 && tree.borrowed_scale < 1.0);
    let inner = |lateral: &crate::silhouette::plan::Lateral| {
        lateral.system.as_ref().map_or(0.0, |system| system.outline.area())
    };
    assert!((inner(lent) / inner(theirs) - ratio * ratio).abs() < 1e-2);
    assert!(plan.system.laterals.iter().all(|own| own.id != lent.id));
}

#[test]
fn a_chosen_lender_lends() {
    let mut drawing = three();
    drawing.trees.push(detailed(Vec2::new(450.0, 300.0), 60.0));
    let mut params = params();
    params.lenders = vec![Lending { tree: 1, from: Some(3) }, Lending { tree: 2, from: None }];
    let stand = grow(&drawing, &params).unwrap();
    let lenders: Vec<_> = stand.trees.iter().map(|tree| tree.lender).collect();
    assert_eq!(lenders, [None, Some(3), None, None]);
}

#[test]
fn who_has_nothing_to_lend_is_noted() {
    let params = StandParams { lenders: vec![Lending { tree: 0, from: Some(1) }], ..params() };
    let stand = grow(&three(), &params).unwrap();
    let note = stand.notes.iter().map(ToString::to_string).collect::<String>();
    assert!(note.contains("tree 2 has no details that tree 1 lacks"), "{note}");
}

#[test]
fn far_trees_are_real_trees_farther_off() {
    let drawing = in_perspective();
    let stand =
        grow(&drawing, &StandParams { perspective: Perspective::Horizon(50.0), ..params() });
    let stand = stand.unwrap();
    for tree in &stand.trees {
        assert!((foliage_height(tree) - foliage_height(&stand.trees[0])).abs() < 0.02);
    }
    let depths: Vec<f32> = stand.trees.iter().map(|tree| tree.position.z).collect();
    assert!(depths[0].abs() < 1e-4 && depths[4] < depths[2] && depths[2] < depths[3]);
}

#[test]
fn the_horizon_follows_from_ground_points_and_sizes() {
    let stand = grow(&in_perspective(), &params()).unwrap();
    let view = stand.view.unwrap();
    assert!((view.center.y - 50.0).abs() < 1.0, "{view:?}");
}

#[test]
fn the_view_sees_every_ground_point_where_it_was_drawn() {
    let drawing = in_perspective();
    let stand = grow(&drawing, &params()).unwrap();
    let view = stand.view.unwrap();
    for (tree, drawn) in stand.trees.iter().zip(&drawing.trees) {
        let seen = tree.position - view.eye;
        let at = view.center + view.focal * Vec2::new(seen.x, -seen.y) / -seen.z;
        let foot = drawn.strokes[0].points[0];
        assert!(at.distance(foot) < 0.1, "{at} {foot}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let grown = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let stand = pool.install(|| grow(&three(), &params()).unwrap());
        stand.trees.into_iter().map(|tree| (tree.grown, tree.position)).collect::<Vec<_>>()
    };
    assert!(grown(1) == grown(3));
}

#[test]
fn trees_that_cannot_be_used_are_left_out_and_named() {
    let mut drawing = three();
    drawing.trees[1].name = "oak".into();
    drawing.trees[1].strokes.truncate(1);
    for bad in [Vec2::NAN, Vec2::INFINITY, Vec2::new(0.0, 1e30), Vec2::ZERO] {
        let mut tree = plain(Vec2::ZERO, 1.0);
        for point in tree.strokes.iter_mut().flat_map(|stroke| &mut stroke.points) {
            *point *= bad;
        }
        drawing.trees.push(tree);
    }
    drawing.trees.push(plain(Vec2::new(1e20, 1e20), 100.0));
    drawing.trees.push(TreeStrokes::default());
    let stand = grow(&drawing, &params()).unwrap();
    assert_eq!(stand.trees.iter().map(|tree| tree.index).collect::<Vec<_>>(), [0, 2]);
    let notes: Vec<String> = stand.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes.len(), 7, "{notes:#?}");
    assert!(notes.iter().any(|note| note.starts_with("oak was left out: ")), "{notes:#?}");
}

#[test]
fn a_drawing_without_a_tree_is_refused() {
    for trees in [Vec::new(), vec![TreeStrokes::default(); 3]] {
        let drawing = OutlineDrawing { trees, repairs: Vec::new() };
        let error = grow(&drawing, &params()).unwrap_err();
        assert!(matches!(error, ModelError::Silhouette { .. }), "{error}");
    }
}

#[test]
fn a_horizon_below_all_trees_is_refused() {
    let params = StandParams { perspective: Perspective::Horizon(900.0), ..params() };
    let error = grow(&three(), &params).unwrap_err().to_string();
    assert!(error.contains("horizon"), "{error}");
}

#[test]
fn parameters_out_of_range_are_named() {
    let bad = |change: fn(&mut StandParams)| {
        let mut params = params();
        change(&mut params);
        grow(&three(), &params).unwrap_err().to_string()
    };
    assert!(bad(|p| p.fov = f32::NAN).contains("stand.fov"));
    assert!(bad(|p| p.scaling = 0.0).contains("stand.scaling"));
    assert!(bad(|p| p.silhouette.height = -1.0).contains("height"));
    assert!(bad(|p| p.perspective = Perspective::Horizon(f32::NAN)).contains("stand.horizon"));
    let lend = bad(|p| p.lenders = vec![Lending { tree: 7, from: None }]);
    assert!(lend.contains("stand.lenders[0].tree"), "{lend}");
}

#[test]
fn a_tree_alone_stands_at_the_origin() {
    let drawing =
        OutlineDrawing { trees: vec![plain(Vec2::new(5.0, 9.0), 4.0)], repairs: Vec::new() };
    let stand = grow(&drawing, &params()).unwrap();
    assert_eq!(stand.trees[0].position.x, 0.0);
}

#[test]
fn limits_hold_for_all_trees_together() {
    let alone = grow(&three(), &params()).unwrap();
    let leaves = |tree: &StandTree| tree.grown.tree.foliage().len() as u64;
    let mut control = Control::default();
    control.limits.leaves = alone.trees.iter().map(leaves).max().unwrap() + 1;
    let error = Stand::of_drawing(&three(), &params(), Seed(3), &control).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
}

#[test]
fn it_can_be_cancelled() {
    let flag = CancelFlag::default();
    flag.cancel();
    let control = Control::default().with_cancel(flag);
    let error = Stand::of_drawing(&three(), &params(), Seed(3), &control).unwrap_err();
    assert!(matches!(error, ModelError::Cancelled(_)));
}
