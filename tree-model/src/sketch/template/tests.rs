use super::*;
use crate::foliage::SPECIES;
use crate::sketch::{Drawing, Label, Plan, Role};
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{Control, NO_PARENT, Seed, Skeleton, Tree};

/// Exemplars that grow fast.
const QUICK: [&str; 3] = ["palm", "snag", "sapling"];

fn skeleton(rows: &[([f32; 3], u32)]) -> Skeleton {
    let positions = rows.iter().map(|row| Vec3::from(row.0)).collect();
    let parents = rows.iter().map(|row| row.1).collect();
    let mut skeleton = Skeleton::from_columns(positions, vec![0.0; rows.len()], parents).unwrap();
    let radii = tree_core::allometry::PipeModel::default().radii(&skeleton).unwrap();
    skeleton.set_radii(radii).unwrap();
    skeleton
}

/// A trunk with two branches to the right, far apart, and a twig.
fn simple() -> Skeleton {
    skeleton(&[
        ([0.0, 0.0, 0.0], NO_PARENT),
        ([0.0, 4.0, 0.0], 0),
        ([0.0, 7.0, 0.0], 1),
        ([0.0, 14.0, 0.0], 2),
        ([3.0, 6.0, 0.0], 1),
        ([3.0, 9.0, 1.0], 2),
        ([0.5, 7.5, 0.1], 2),
    ])
}

fn template_of(name: &str) -> Template {
    let exemplar = Exemplar::find(name).unwrap();
    let control = Control::default();
    let tree = exemplar.tree(EXEMPLAR_SEED, &control).unwrap();
    let params = TemplateParams::default();
    Template::of_tree(name, exemplar.species(), &tree, &params, &control).unwrap()
}

fn assert_shipped(names: &[&str]) {
    let made: Vec<Template> = names.iter().map(|name| template_of(name)).collect();
    let shipped: Vec<Template> =
        names.iter().map(|name| Template::find(name).unwrap().clone()).collect();
    assert_eq!(to_text(&made), to_text(&shipped));
}

/// Share of views, between those stored, from which exemplars are chosen first and among the first three.
fn chosen(names: &[&str], with_crown: bool) -> [f32; 2] {
    let (control, templates) = (Control::default(), Template::builtin().unwrap());
    let (mut n, mut first, mut third) = (0.0, 0.0, 0.0);
    for name in names {
        let tree = Exemplar::find(name).unwrap().tree(EXEMPLAR_SEED, &control).unwrap();
        let branches = main_branches(tree.skeleton(), &MainBranchParams::default()).unwrap();
        for view in 0..8 {
            let yaw = (view as f32 + 0.37) * std::f32::consts::FRAC_PI_4;
            let crown = if with_crown { crown_points(&tree, yaw) } else { Vec::new() };
            let drawn = DrawnShape::of_branches(&branches, yaw, &crown);
            let choices = select(&drawn, templates, &SelectParams::default()).unwrap();
            let rank = choices.iter().position(|c| templates[c.template].name == *name).unwrap();
            n += 1.0;
            first += f32::from(rank == 0);
            third += f32::from(rank < 3);
        }
    }
    [first / n, third / n]
}

#[test]
fn twenty_templates_are_built_in_one_for_each_exemplar() {
    let templates = Template::builtin().unwrap();
    let names: Vec<&str> = templates.iter().map(|template| template.name.as_str()).collect();
    assert_eq!(names, EXEMPLARS.map(|exemplar| exemplar.name()));
    assert_eq!(names.len(), 20);
    for template in templates {
        assert!(SPECIES.iter().any(|species| species.name == template.species), "{template:?}");
    }
}

#[test]
fn shipped_data_is_what_the_exemplars_measure() {
    assert_shipped(&QUICK);
}

#[test]
#[ignore = "some seconds: all twenty"]
fn all_shipped_data_is_what_the_exemplars_measure() {
    assert_shipped(&EXEMPLARS.map(|exemplar| exemplar.name()));
}

#[test]
fn exemplars_select_themselves_from_views_between_those_stored() {
    assert_eq!(chosen(&QUICK, true), [1.0, 1.0], "with a crown");
    assert_eq!(chosen(&QUICK, false), [1.0, 1.0], "without");
}

#[test]
#[ignore = "some seconds: all twenty"]
fn all_exemplars_select_themselves() {
    for with_crown in [true, false] {
        let [first, third] = chosen(&EXEMPLARS.map(|exemplar| exemplar.name()), with_crown);
        assert!(first >= 0.9 && third >= 1.0, "{with_crown}: {first} {third}");
    }
}

#[test]
fn what_is_written_is_read_again() {
    let templates = Template::builtin().unwrap();
    let text = to_text(templates);
    assert!(text.len() < 150_000, "{} bytes", text.len());
    assert_eq!(parse(&text).unwrap(), templates);
}

#[test]
fn other_seeds_make_other_trees_of_the_kind() {
    let exemplar = Exemplar::find("sapling").unwrap();
    let tree = |seed| exemplar.tree(Seed(seed), &Control::default()).unwrap();
    assert_eq!(tree(3), tree(3));
    assert_ne!(tree(3), tree(4));
}

#[test]
fn bad_text_is_refused_with_its_line() {
    let good = to_text(&[Template::find("palm").unwrap().clone()]);
    let line = |n: usize| good.lines().nth(n - 1).unwrap();
    let (view, crown) = (
        good.lines().position(|l| l.starts_with("view")).unwrap() + 1,
        good.lines().position(|l| l.starts_with("crown")).unwrap() + 1,
    );
    let cases = [
        (String::new(), "line 0"),
        ("templates 9".into(), "line 1"),
        ("templates 1\nheight 3".into(), "line 2"),
        (good.replacen("height", "hight", 1), "line 5: 'hight'"),
        (good.replacen("height ", "height x", 1), "line 5"),
        (good.replacen("height ", "height 1e30 #", 1), "line 5"),
        (good.replacen("species palm", "species", 1), "species"),
        (good.replacen(line(view), "view NaN", 1), "line"),
        (good.replacen(line(crown), "crown 1 2 3", 1), "64 distances"),
        (good.replacen(line(crown), "", 1), "'crown …' must stand here"),
        (format!("{good}\n{}", good.replacen("templates 1", "", 1)), "already"),
    ];
    for (text, says) in cases {
        let error = parse(&text).unwrap_err();
        assert!(matches!(error, ModelError::Template { .. }), "{error}");
        assert!(error.to_string().contains(says), "'{error}' should say '{says}'");
    }
}

#[test]
fn a_trunk_and_its_branches_become_segments_from_fork_to_fork() {
    let branches = main_branches(&simple(), &MainBranchParams::default()).unwrap();
    assert_eq!(branches.parents(), [NO_PARENT, 0, 1, 0, 1]);
    let labels = branches.labels();
    assert_eq!(labels[..3], [Label::Apical; 3]);
    assert_eq!(labels[3..], [Label::Lateral(0); 2]);
    assert_eq!(branches.end(3), Vec3::new(3.0, 6.0, 0.0));
    assert!(!branches.has_imagined_root());
}

#[test]
fn forks_close_together_are_one() {
    let wide = MainBranchParams { gather: 0.25, ..MainBranchParams::default() };
    let branches = main_branches(&simple(), &wide).unwrap();
    assert_eq!(branches.parents(), [NO_PARENT, 0, 0, 0]);
    // The upper branch now leaves where the lower one does.
    assert_eq!(branches.start(3), Vec3::new(0.0, 4.0, 0.0));
}

#[test]
fn several_stems_stand_on_an_imagined_root() {
    let bush = skeleton(&[
        ([0.0, 0.0, 0.0], NO_PARENT),
        ([1.0, 4.0, 0.0], 0),
        ([-1.0, 4.0, 0.0], 0),
        ([0.0, 4.0, 1.0], 0),
    ]);
    let branches = main_branches(&bush, &MainBranchParams::default()).unwrap();
    assert!(branches.has_imagined_root());
    assert_eq!(branches.parents(), [NO_PARENT, 0, 0, 0]);
    assert_eq!(project(&branches, 0.0, &[]).strokes.len(), 3);
}

#[test]
fn laterals_of_a_whorl_are_numbered_round_the_axis() {
    let whorl = skeleton(&[
        ([0.0, 0.0, 0.0], NO_PARENT),
        ([0.0, 4.0, 0.0], 0),
        ([0.0, 9.0, 0.0], 1),
        ([2.0, 4.0, 0.0], 1),
        ([-2.0, 4.0, 0.0], 1),
        ([0.0, 4.0, 2.0], 1),
        ([0.0, 4.0, -2.0], 1),
    ]);
    let branches = main_branches(&whorl, &MainBranchParams::default()).unwrap();
    let mut laterals: Vec<(u16, Vec3)> = (0..branches.len())
        .filter_map(|segment| match branches.labels()[segment] {
            Label::Lateral(number) => Some((number, branches.vector(segment))),
            Label::Apical => None,
        })
        .collect();
    laterals.sort_by_key(|&(number, _)| number);
    for (i, pair) in laterals.windows(2).enumerate() {
        assert_eq!(usize::from(pair[1].0), i + 1);
        assert!(pair[0].1.dot(pair[1].1).abs() < 1e-3, "neighbours stand at right angles");
    }
}

#[test]
fn trees_that_show_nothing_are_refused() {
    let point = skeleton(&[([0.0; 3], NO_PARENT), ([0.0; 3], 0)]);
    let pole = skeleton(&[([0.0; 3], NO_PARENT), ([0.0, 3.0, 0.0], 0)]);
    let hanging = skeleton(&[([0.0; 3], NO_PARENT), ([0.0, -3.0, 0.0], 0), ([1.0, -3.0, 0.0], 0)]);
    for skeleton in [point, pole, hanging] {
        let tree = Tree::bare(skeleton, tree_core::Species::default());
        let (params, control) = (TemplateParams::default(), Control::default());
        let error = Template::of_tree("x", "oak", &tree, &params, &control).unwrap_err();
        assert!(matches!(error, ModelError::Template { .. }), "{error}");
    }
}

#[test]
fn parameters_out_of_range_are_named() {
    let main = MainBranchParams { most: 0, ..MainBranchParams::default() };
    let error = main_branches(&simple(), &main).unwrap_err().to_string();
    assert!(error.contains("main.most"), "{error}");
    let select_params = SelectParams { crown: f32::NAN, ..SelectParams::default() };
    let error = select_params.validate().unwrap_err().to_string();
    assert!(error.contains("select.crown"), "{error}");
    let params = TemplateParams { views: 0, ..TemplateParams::default() };
    assert!(params.validate().unwrap_err().to_string().contains("template.views"));
}

#[test]
fn a_drawing_has_its_trunk_first_and_y_down() {
    let branches = main_branches(&simple(), &MainBranchParams::default()).unwrap();
    let crown = vec![vec![Vec2::new(1.0, 2.0), Vec2::new(2.0, 3.0), Vec2::new(0.0, 3.0)]];
    let Drawing { strokes } = project(&branches, 0.0, &crown);
    assert_eq!(strokes[0].role, Some(Role::Trunk));
    assert_eq!(strokes[0].points.last(), Some(&Vec2::new(0.0, -14.0)));
    assert_eq!(strokes[1].points.last(), Some(&Vec2::new(3.0, -6.0)));
    assert!(strokes[3].closed && strokes[3].role == Some(Role::Crown));
}

#[test]
fn the_eye_goes_round_the_trunk_from_z_to_x() {
    let quarter = std::f32::consts::FRAC_PI_2;
    // Seen from +X, what lies towards −Z is at the right.
    assert!(seen_from(quarter, Vec3::NEG_Z).distance(Vec2::X) < 1e-6);
    assert!(seen_from(0.0, Vec3::X).distance(Vec2::X) < 1e-6);
}

#[test]
fn a_drawing_from_behind_is_found_as_a_mirror_image() {
    let palm = Template::find("palm").unwrap();
    let view = &palm.views[2];
    let n = view.crown.distances().len();
    let mirrored = |footprint: &Footprint| {
        let turned = (0..n).map(|k| footprint.distances()[(n / 2 + n - k) % n]);
        Footprint::try_from(turned.collect::<Vec<f32>>()).unwrap()
    };
    let drawn = DrawnShape {
        shape: view.shape,
        directions: view.directions,
        crown: Some(mirrored(&view.crown)),
        branches: Some(mirrored(&view.branches)),
    };
    let templates = std::slice::from_ref(palm);
    let choice = select(&drawn, templates, &SelectParams::default()).unwrap()[0];
    assert!(choice.score.abs() < 1e-6, "{choice:?}");
    assert_eq!(choice.yaw, view.yaw + PI);
}

#[test]
fn a_single_straight_stroke_still_gets_templates() {
    let positions = vec![Vec2::ZERO, Vec2::new(0.0, 5.0)];
    let plan = Plan::from_columns(positions, vec![NO_PARENT, 0], vec![0, 0], Vec2::ZERO, 1.0);
    let drawn = DrawnShape::measure(&plan.unwrap(), &[]);
    assert_eq!(drawn.branches, None);
    let templates = Template::builtin().unwrap();
    let choices = select(&drawn, templates, &SelectParams::default()).unwrap();
    assert_eq!(choices.len(), templates.len());
    assert!(choices.iter().all(|choice| choice.score.is_finite()));
    assert!(select(&drawn, &[], &SelectParams::default()).is_err());
}

#[test]
fn the_shape_of_a_fork_is_its_angles_and_length_ratios() {
    // Two long, then one of the same length straight on and one half as long to the side.
    let positions = vec![Vec2::ZERO, Vec2::new(0.0, 2.0), Vec2::new(0.0, 4.0), Vec2::new(1.0, 2.0)];
    let parents = vec![NO_PARENT, 0, 1, 1];
    let plan = Plan::from_columns(positions, parents, vec![0, 0, 0, 1], Vec2::ZERO, 1.0).unwrap();
    let shape = DrawnShape::measure(&plan, &[]).shape;
    assert!(shape.alpha.unwrap().mean.abs() < 1e-5);
    assert!((shape.beta.unwrap().mean - std::f32::consts::FRAC_PI_2).abs() < 1e-5);
    // ln 1 weighs 2, ln ½ weighs 1.
    assert!((shape.scale.unwrap().mean + libm::logf(2.0) / 3.0).abs() < 1e-5);
}

#[test]
fn straight_up_and_straight_down_are_as_different_as_can_be() {
    let line = |y: f32| {
        let positions = vec![Vec2::ZERO, Vec2::new(0.0, y)];
        let plan = Plan::from_columns(positions, vec![NO_PARENT, 0], vec![0; 2], Vec2::ZERO, 1.0);
        DrawnShape::measure(&plan.unwrap(), &[]).directions
    };
    assert_eq!(line(1.0).distance(&line(3.0)), 0.0);
    assert!(line(1.0).distance(&line(-1.0)) > 0.9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn damaged_text_gives_templates_or_a_template_error(
        at in 0.0_f64..1.0, length in 0_usize..60, put in "[ -~\n]{0,12}",
    ) {
        let text = to_text(&[Template::find("sapling").unwrap().clone()]);
        let mut bytes = text.into_bytes();
        let from = (at * bytes.len() as f64) as usize;
        let to = (from + length).min(bytes.len());
        bytes.splice(from..to, put.bytes());
        if let Err(error) = parse(&String::from_utf8(bytes).unwrap()) {
            prop_assert!(matches!(error, ModelError::Template { .. }), "{}", error);
            prop_assert!(error.to_string().contains("line "), "{}", error);
        }
    }

    #[test]
    fn any_skeleton_gives_sound_branches_or_an_error(
        rows in prop::collection::vec((prop::array::uniform3(-2_i8..3), 0.0_f64..1.0), 1..40),
        gather in 0.0_f32..0.5,
    ) {
        let rows: Vec<([f32; 3], u32)> = rows.iter().enumerate().map(|(n, (p, share))| {
            let parent = if n == 0 { NO_PARENT } else { (share * n as f64) as u32 };
            (p.map(f32::from), parent)
        }).collect();
        let params = MainBranchParams { gather, least: 0.0, least_second: 0.0, ..Default::default() };
        let Ok(branches) = main_branches(&skeleton(&rows), &params) else { return Ok(()) };
        prop_assert_eq!(branches.parents()[0], NO_PARENT);
        for segment in 1..branches.len() {
            let parent = branches.parents()[segment] as usize;
            prop_assert!(parent < segment);
            prop_assert!(branches.points(segment).len() > 1);
            prop_assert_eq!(branches.start(segment), branches.end(parent));
        }
        let apical = |p: u32| (0..branches.len())
            .filter(|&s| branches.parents()[s] == p && branches.labels()[s] == Label::Apical).count();
        prop_assert!((0..branches.len() as u32).all(|p| apical(p) <= 1));
    }
}
