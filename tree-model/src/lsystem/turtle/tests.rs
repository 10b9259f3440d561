use super::*;
use crate::error::ModelError;
use crate::glam::{Quat, Vec3};
use tree_core::Limits;
use tree_core::allometry::RadiusRule;

fn draw_with(text: &str, params: &TurtleParams) -> Result<Interpretation> {
    let mut symbols = Symbols::default();
    let word = Word::parse(text, &mut symbols)?;
    interpret(&word, &symbols, &Species::default(), params, &Control::default())
}

fn draw(text: &str) -> Interpretation {
    draw_with(text, &TurtleParams::default()).unwrap()
}

fn near(found: Vec3, wanted: [f32; 3]) {
    assert!(found.distance(wanted.into()) < 1e-5, "{found} instead of {wanted:?}");
}

/// Where a turtle that rotates and then draws ends.
fn end(text: &str) -> Vec3 {
    *draw(text).tree.skeleton().positions().last().unwrap()
}

/// The module an error names.
fn at(text: &str) -> (usize, String) {
    match draw_with(text, &TurtleParams::default()) {
        Err(ModelError::Word { module, problem }) => (module, problem),
        other => panic!("{other:?}"),
    }
}

/// Rewrites every `from` of a plain string.
fn rewrite(axiom: &str, rules: &[(char, &str)], steps: usize) -> String {
    (0..steps).fold(axiom.to_owned(), |text, _| {
        let rule = |c: char| rules.iter().find(|rule| rule.0 == c).map(|rule| rule.1);
        text.chars().map(|c| rule(c).map_or(c.to_string(), str::to_owned)).collect()
    })
}

fn string_lines(text: &str, angle: f64) -> Vec<[Vec3; 2]> {
    let mut symbols = Symbols::default();
    let word = Word::parse(text, &mut symbols).unwrap();
    let params = TurtleParams { angle, ..TurtleParams::default() };
    lines(&word, &symbols, &params, &Control::default()).unwrap()
}

#[test]
fn rotations_turn_the_way_their_names_say() {
    // The turtle looks up, its left is -X and its back looks to the viewer on +Z.
    near(end("+(90)F"), [-1.0, 0.0, 0.0]);
    near(end("-(90)F"), [1.0, 0.0, 0.0]);
    near(end("&(90)F"), [0.0, 0.0, -1.0]);
    near(end("^(90)F"), [0.0, 0.0, 1.0]);
    near(end("\\(90)+(90)F"), [0.0, 0.0, 1.0]);
    near(end("/(90)+(90)F"), [0.0, 0.0, -1.0]);
    near(end("|F"), [0.0, -1.0, 0.0]);
    near(end("+(30)F(2)"), [-1.0, 3.0_f32.sqrt(), 0.0]);
}

#[test]
fn levelling_lays_the_left_side_horizontal() {
    // Pitched by 90 and rolled, then levelled: `^` lifts the heading to the vertical again.
    near(end("&(90)/(37)$^(90)F"), [0.0, 1.0, 0.0]);
    // A vertical heading has no level side; nothing happens.
    near(end("/(90)$+(90)F"), [0.0, 0.0, -1.0]);
}

#[test]
fn the_koch_island_closes_and_has_its_lines() {
    // ABOP, Fig. 1.6: quadratic Koch island.
    let text = rewrite("F-F-F-F", &[('F', "F-F+F+FF-F-F+F")], 2);
    let lines = string_lines(&text, 90.0);
    assert_eq!(lines.len(), 4 * 8 * 8);
    near(lines[lines.len() - 1][1], [0.0, 0.0, 0.0]);
    // Every corner lies on the grid, exactly.
    assert!(lines.iter().flatten().all(|p| *p == p.round()));
}

#[test]
fn the_hilbert_curve_visits_every_cell_of_its_square_once() {
    let rules = [('A', "-BF+AFA+FB-"), ('B', "+AF-BFB-FA+")];
    let lines = string_lines(&rewrite("A", &rules, 4), 90.0);
    assert_eq!(lines.len(), 255);
    let mut cells: Vec<[i32; 2]> =
        lines.iter().map(|line| [line[1].x as i32, line[1].y as i32]).collect();
    cells.push([0, 0]);
    cells.sort_unstable();
    cells.dedup();
    assert_eq!(cells.len(), 256);
    let wide = |axis: usize| {
        let values = || cells.iter().map(|cell| cell[axis]);
        values().max().unwrap() - values().min().unwrap()
    };
    assert_eq!((wide(0), wide(1)), (15, 15));
}

#[test]
fn the_hilbert_curve_in_space_fills_its_cube() {
    // ABOP, Fig. 1.19.
    let rules = [
        ('A', "B-F+CFC+F-D&F^D-F+&&CFC+F+B//"),
        ('B', "A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//"),
        ('C', "|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//"),
        ('D', "|CFB-F+B|FA&F^A&&FB-F+B|FC//"),
    ];
    let lines = string_lines(&rewrite("A", &rules, 2), 90.0);
    assert_eq!(lines.len(), 63);
    let mut cells: Vec<[i32; 3]> =
        lines.iter().map(|l| l[1].round().as_ivec3().to_array()).collect();
    cells.push([0, 0, 0]);
    cells.sort_unstable();
    cells.dedup();
    assert_eq!(cells.len(), 64);
}

#[test]
fn laterals_hang_on_the_node_where_their_bracket_opens() {
    let tree = draw("F[+F][-FF]F").tree;
    assert_eq!(tree.skeleton().parents()[1..], [0, 1, 1, 3, 1]);
    assert_eq!(tree.skeleton().positions()[5], Vec3::new(0.0, 2.0, 0.0));
}

#[test]
fn steps_of_no_length_make_no_node() {
    let drawn = draw("F(0)F[F(0)+F]");
    assert_eq!(drawn.tree.skeleton().len(), 3);
    assert_eq!(drawn.report.merged, 2);
}

#[test]
fn gaps_are_bridged_and_counted_but_not_drawn_as_lines() {
    let drawn = draw("F(1)f(1)F(1)[f(3)]");
    assert_eq!(drawn.report.gaps, 1);
    assert_eq!(drawn.tree.skeleton().parents()[1..], [0, 1, 2]);
    near(drawn.tree.skeleton().positions()[3], [0.0, 3.0, 0.0]);
    assert_eq!(string_lines("F(1)f(1)F(1)[f(3)]", 90.0).len(), 2);
}

#[test]
fn a_cut_drops_the_rest_of_its_branch_only() {
    let drawn = draw("F[+F%F[F]F]F");
    assert_eq!(drawn.tree.skeleton().parents()[1..], [0, 1, 1]);
    assert_eq!(drawn.report.cut, 6);
}

#[test]
fn shoots_bend_by_the_elasticity_times_the_torque() {
    // ABOP, p. 58: a horizontal shoot of elasticity e turns by e radians, a vertical one not at all.
    let params = TurtleParams { elasticity: 0.22, ..TurtleParams::default() };
    let tree = draw_with("+(90)FF", &params).unwrap().tree;
    let [b, c] = [1, 2].map(|i| tree.skeleton().positions()[i]);
    let bend = libm::acosf((c - b).dot(Vec3::NEG_X));
    assert!((bend - 0.22).abs() < 1e-5 && c.y < b.y, "{bend}");
    let upright = draw_with("FFF", &params).unwrap().tree;
    near(upright.skeleton().positions()[3], [0.0, 3.0, 0.0]);
    // A module sets the elasticity for its branch.
    let branch = draw("[_(0.22)+(90)FF]+(90)FF").tree;
    near(branch.skeleton().positions()[2], c.to_array());
    near(branch.skeleton().positions()[4], [-2.0, 0.0, 0.0]);
}

#[test]
fn widths_taper_to_the_thickest_that_follows() {
    let tree = draw("!(1)F[!(0.4)F]!(0.6)F").tree;
    assert_eq!(tree.skeleton().radii(), [0.5, 0.3, 0.1, 0.15]);
    let ends = TurtleParams { taper: Taper::Ends, ..TurtleParams::default() };
    let tree = draw_with("!(2)!(1)F[!(0.4)F]!(0.6)F", &ends).unwrap().tree;
    assert_eq!(tree.skeleton().radii(), [1.0, 0.5, 0.2, 0.3]);
}

#[test]
fn a_bare_width_mark_takes_the_ratio_and_a_word_without_any_the_rule() {
    let params = TurtleParams { width: 1.0, width_ratio: 0.5, ..TurtleParams::default() };
    let tree = draw_with("F!F", &params).unwrap().tree;
    assert_eq!(tree.skeleton().radii(), [0.5, 0.25, 0.125]);
    let mut ruled = draw("F[+F]F").tree.skeleton().clone();
    let before = ruled.radii().to_vec();
    RadiusRule::default().apply(&mut ruled).unwrap();
    assert_eq!(ruled.radii(), before);
}

#[test]
fn a_height_and_a_trunk_radius_rescale_everything() {
    let params =
        TurtleParams { height: Some(8.0), trunk_radius: Some(0.2), ..TurtleParams::default() };
    let tree = draw_with("!(10)F(100)[!(5)+(90)F(50)~(10)]F(60)", &params).unwrap().tree;
    let top = tree.skeleton().bounds().max.y;
    assert!((top - 8.0).abs() < 1e-5, "{top}");
    assert!((tree.skeleton().radii()[0] - 0.2).abs() < 1e-6);
    assert!((tree.foliage().sizes()[0] - 0.5).abs() < 1e-6);
}

#[test]
fn leaves_look_along_the_turtle() {
    let drawn = draw("F(2)+(90)~(0.1)");
    let leaf = drawn.tree.foliage().get(0).unwrap();
    assert_eq!((leaf.node, leaf.kind, leaf.size), (1, 0, 0.1));
    near(leaf.position, [0.0, 2.0, 0.0]);
    near(leaf.rotation * Vec3::Y, [-1.0, 0.0, 0.0]);
    near(leaf.rotation * Vec3::Z, [0.0, 0.0, 1.0]);
}

#[test]
fn polygons_become_leaves_from_their_base_to_their_farthest_corner() {
    // The leaf of ABOP, Fig. 1.25.
    let drawn = draw("F[''{-f+f+f-|-f+f+f}]");
    assert_eq!(drawn.polygons.len(), 1);
    let polygon = &drawn.polygons[0];
    assert_eq!((polygon.vertices.len(), polygon.color, polygon.node), (6, 2, 1));
    let leaf = drawn.tree.foliage().get(0).unwrap();
    near(leaf.position, [0.0, 1.0, 0.0]);
    near(leaf.rotation * Vec3::Y, [0.0, 1.0, 0.0]);
    near(leaf.rotation * Vec3::Z, [0.0, 0.0, 1.0]);
    let length = 1.0 + 2.0 * libm::cosf(22.5_f32.to_radians());
    assert!((leaf.size - length).abs() < 1e-5, "{}", leaf.size);
    assert!(leaf.rotation.angle_between(Quat::IDENTITY) < 1e-3);
}

#[test]
fn polygons_nest_and_thin_ones_are_left_out() {
    let drawn = draw("{.f(1)[+(90)f(1){.f+(90)f+(90)f}]+(90)f(1)+(90)f(1)}{f}");
    assert_eq!(drawn.polygons.iter().map(|p| p.vertices.len()).collect::<Vec<_>>(), [4, 5]);
    assert_eq!(drawn.report.thin_polygons, 1);
}

#[test]
fn symbols_without_a_meaning_are_listed() {
    let drawn = draw("A(1)FAB(2,3)FB(1)");
    assert_eq!(drawn.report.skipped, [("A".to_owned(), 2), ("B".to_owned(), 2)]);
    assert_eq!(drawn.report.modules, 6);
}

#[test]
fn open_brackets_and_braces_are_named() {
    assert_eq!(at("F[+F[F]").0, 1);
    assert_eq!(at("F]F").0, 1);
    assert_eq!(at("F{fff").0, 1);
    assert_eq!(at("F}").0, 1);
    assert_eq!(at("F.").0, 1);
    assert_eq!(at("F[%F").0, 1);
}

#[test]
fn lengths_widths_and_kinds_out_of_range_are_named() {
    assert_eq!(at("FF(1e300)").0, 1);
    assert_eq!(at("F(1e308)F(1e308)").0, 0);
    assert_eq!(at("!(-1)F").0, 0);
    assert_eq!(at("~(-1)").0, 0);
    assert!(at("F~(1,3)").1.contains("leaf kind 3"));
    assert_eq!(at("_(1e9)").0, 0);
    // Within the turtle's reach, but no tree.
    let far = draw_with("F(1e11)", &TurtleParams::default());
    assert!(matches!(far, Err(ModelError::Parameter(_))), "{far:?}");
    // A number that is none does not even make a word.
    let mut symbols = Symbols::default();
    assert!(Word::parse("F(NaN)", &mut symbols).is_err());
    for params in [
        TurtleParams { angle: f64::NAN, ..TurtleParams::default() },
        TurtleParams { unit: 0.0, ..TurtleParams::default() },
        TurtleParams { tropism: Vec3::NAN, ..TurtleParams::default() },
        TurtleParams { height: Some(-1.0), ..TurtleParams::default() },
    ] {
        assert!(draw_with("F", &params).is_err(), "{params:?}");
    }
}

#[test]
fn a_million_brackets_deep_is_no_stack_overflow() {
    let deep = 1_000_000;
    let text = format!("{}F{}", "[+".repeat(deep), "]".repeat(deep));
    let drawn = draw(&text);
    assert_eq!((drawn.report.depth, drawn.tree.skeleton().len()), (deep, 2));
}

#[test]
fn limits_on_nodes_and_leaves_hold() {
    let mut symbols = Symbols::default();
    let word = Word::parse("FFFF~~~", &mut symbols).unwrap();
    for (limits, ok) in [
        (Limits { nodes: 5, leaves: 3, ..Limits::default() }, true),
        (Limits { nodes: 4, ..Limits::default() }, false),
        (Limits { leaves: 2, ..Limits::default() }, false),
    ] {
        let control = Control::default().with_limits(limits);
        let params = TurtleParams::default();
        let drawn = interpret(&word, &symbols, &Species::default(), &params, &control);
        assert_eq!(drawn.is_ok(), ok, "{limits:?}");
    }
}

#[test]
fn an_empty_word_is_a_stump() {
    let drawn = draw("");
    assert_eq!(drawn.tree.skeleton().len(), 1);
}
