use super::*;
use crate::skeleton::tests::any_skeleton;
use glam::Vec3;
use proptest::prelude::*;

const EXPONENTS: [f32; 5] =
    [1.0, PipeModel::DA_VINCI, PipeModel::MURRAY, PipeModel::MANDELBROT, 10.0];

fn single() -> Skeleton {
    Skeleton::builder(Vec3::ZERO, 0.0).unwrap().finish()
}

fn whorl(n_children: u32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    let fork = builder.add(0, Vec3::Y, 0.0).unwrap();
    for i in 0..n_children {
        let turn = i as f32 * 0.1;
        let offset = Vec3::new(libm::cosf(turn), 0.5, libm::sinf(turn));
        builder.add(fork, Vec3::Y + offset, 0.0).unwrap();
    }
    builder.finish()
}

fn chain(n_nodes: u32, step: f32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    for i in 1..n_nodes {
        builder.add(i - 1, Vec3::Y * (i as f32 * step), 0.0).unwrap();
    }
    builder.finish()
}

/// Two children at the given angles to the vertical, the first with a tip more than the second.
fn fork(angles: [f32; 2]) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    builder.add(0, Vec3::Y, 0.0).unwrap();
    for (angle, side) in angles.into_iter().zip([1.0, -1.0]) {
        let offset = Vec3::new(side * libm::sinf(angle), libm::cosf(angle), 0.0);
        builder.add(1, Vec3::Y + offset, 0.0).unwrap();
    }
    builder.finish()
}

fn all_rules() -> Vec<RadiusRule> {
    let by_angle =
        StrandModel { count: StrandCount::ByAngle { base: 100_000 }, ..Default::default() };
    let mut rules = vec![
        RadiusRule::TipDistance(TipDistance::default()),
        RadiusRule::TipDistance(TipDistance { min_radius: 0.0, ..Default::default() }),
        RadiusRule::Strands(StrandModel::default()),
        RadiusRule::Strands(by_angle),
    ];
    rules.extend(EXPONENTS.map(|e| RadiusRule::Pipe(PipeModel::with_exponent(e))));
    rules.push(RadiusRule::Pipe(PipeModel { trunk_radius: Some(0.5), ..Default::default() }));
    rules
}

fn assert_never_thicker_than_below(skeleton: &Skeleton, radii: &[f32]) {
    for (parent, node) in skeleton.segments() {
        let (below, above) = (radii[parent as usize], radii[node as usize]);
        assert!(above <= below, "node {node}: {above} on {below}");
    }
}

fn assert_pipe_equation(skeleton: &Skeleton, exponent: f32, radii: &[f32]) {
    let children = skeleton.children();
    let power = |node: u32| libm::pow(f64::from(radii[node as usize]), f64::from(exponent));
    for node in 0..skeleton.len() as u32 {
        if !children.is_tip(node) {
            let above: f64 = children.of(node).iter().map(|&child| power(child)).sum();
            let error = (power(node) / above - 1.0).abs();
            assert!(error < 1e-4, "node {node}, exponent {exponent}: {error}");
        }
    }
}

#[test]
fn every_rule_takes_the_smallest_and_the_oddest_trees() {
    let twins =
        Skeleton::from_columns(vec![Vec3::ONE; 4], vec![0.0; 4], vec![crate::NO_PARENT, 0, 1, 1])
            .unwrap();
    for skeleton in [single(), chain(2, 0.0), chain(1000, 0.1), twins, whorl(10_000)] {
        for rule in all_rules() {
            let mut tree = skeleton.clone();
            rule.apply(&mut tree).unwrap();
            tree.check().unwrap();
            assert_never_thicker_than_below(&tree, tree.radii());
        }
    }
}

#[test]
fn ten_thousand_children_add_up() {
    for exponent in EXPONENTS {
        let rule = PipeModel { exponent, taper: 0.0, ..Default::default() };
        let radii = rule.radii(&whorl(10_000)).unwrap();
        let expected = 0.002 * libm::powf(10_000.0, 1.0 / exponent);
        assert!((radii[1] / expected - 1.0).abs() < 1e-5, "{exponent}: {}", radii[1]);
    }
}

#[test]
fn taper_thickens_a_bare_shoot_by_its_length() {
    let rule = PipeModel { tip_radius: 0.01, taper: 0.005, ..Default::default() };
    let radii = rule.radii(&chain(5, 0.5)).unwrap();
    for (radius, expected) in radii.iter().zip([0.02, 0.0175, 0.015, 0.0125, 0.01]) {
        assert!((radius - expected).abs() < 1e-7, "{radii:?}");
    }
}

#[test]
fn the_trunk_gets_the_radius_asked_for_and_the_rest_keeps_its_proportion() {
    let free = PipeModel::default().radii(&whorl(7)).unwrap();
    let rule = PipeModel { trunk_radius: Some(0.3), ..Default::default() };
    let scaled = rule.radii(&whorl(7)).unwrap();
    assert_eq!(scaled[0], 0.3);
    for (a, b) in free.iter().zip(&scaled) {
        assert!((a / free[0] - b / 0.3).abs() < 1e-6);
    }
}

#[test]
fn xu_and_moulds_rule_by_hand() {
    let rule = TipDistance { scale: 0.1, zeta: 0.5, min_radius: 0.0 };
    // Trunk of 4 m and a lateral of 1 m that starts at 1 m: Gravelius makes it level 1.
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    for (parent, position) in [
        (0, Vec3::Y),
        (1, Vec3::Y * 4.0),
        (1, Vec3::new(0.5, 1.0, 0.0)),
        (3, Vec3::new(1.0, 1.0, 0.0)),
    ] {
        builder.add(parent, position, 0.0).unwrap();
    }
    let skeleton = builder.finish();
    let close = |found: &[f32], expected: [f64; 5]| {
        for (a, b) in found.iter().zip(expected) {
            assert!((f64::from(*a) - b).abs() < 1e-7, "{found:?}");
        }
    };
    let lateral = 0.1 * 0.5_f64.sqrt() / 2.0;
    close(&rule.radii(&skeleton).unwrap(), [0.2, 0.1 * 3.0_f64.sqrt(), 0.0, lateral, 0.0]);
    close(
        &rule.radii_at_levels(&skeleton, &[1, 1, 1, 4, u32::MAX]).unwrap(),
        [0.1, 0.05 * 3.0_f64.sqrt(), 0.0, 0.4 * lateral, 0.0],
    );
    assert!(matches!(
        rule.radii_at_levels(&skeleton, &[0]),
        Err(CoreError::Length { field: "levels", found: 1, expected: 5 })
    ));
}

#[test]
fn strands_part_by_angle_as_holton_has_it() {
    let (a1, a2) = (0.2_f32, 0.6_f32);
    let model = StrandModel { count: StrandCount::ByAngle { base: 1000 }, ..Default::default() };
    let strands = model.strands(&fork([a1, a2])).unwrap();
    // S2 = S0 α1 / A.
    assert_eq!(strands, [1000, 1000, 750, 250]);
    let back = strand_angles(strands[2], strands[3], a1 + a2).unwrap();
    assert!((back.alpha1 - a1).abs() < 1e-6 && (back.alpha2 - a2).abs() < 1e-6);
    let radii = model.radii(&fork([a1, a2])).unwrap();
    assert!((radii[2] - 0.002 * 750.0_f32.sqrt()).abs() < 1e-7);
}

#[test]
fn fewer_strands_than_tips_are_refused_and_as_many_are_one_each() {
    let model = |base| StrandModel { count: StrandCount::ByAngle { base }, ..Default::default() };
    assert!(matches!(
        model(9_999).strands(&whorl(10_000)),
        Err(CoreError::Parameter(error)) if error.field == "count.base" && error.min == 10_000.0
    ));
    let strands = model(10_000).strands(&whorl(10_000)).unwrap();
    assert!(strands[2..].iter().all(|&count| count == 1));
    assert!(matches!(
        model(u64::MAX).validate(),
        Err(CoreError::Parameter(error)) if error.field == "count.base"
    ));
}

#[test]
fn a_leader_straight_on_leaves_a_strand_to_every_tip_beside_it() {
    let model = StrandModel { count: StrandCount::ByAngle { base: 3 }, ..Default::default() };
    let strands = model.strands(&fork([0.0, 1.0])).unwrap();
    assert_eq!(strands, [3, 3, 2, 1]);
}

#[test]
fn fork_with_zero_length_child_shares_its_strands() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    for x in [0.0, 1.0, -1.0] {
        builder.add(0, Vec3::new(x, x.abs(), 0.0), 0.0).unwrap();
    }
    let model = StrandModel { count: StrandCount::ByAngle { base: 300 }, ..Default::default() };
    assert_eq!(model.strands(&builder.finish()).unwrap(), [300, 100, 100, 100]);
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let field = |result: Result<()>| match result.unwrap_err() {
        CoreError::Parameter(error) => error.field,
        other => panic!("{other}"),
    };
    let pipe = PipeModel::default;
    let bad = [
        (PipeModel { exponent: 0.5, ..pipe() }, "exponent"),
        (PipeModel { tip_radius: 0.0, ..pipe() }, "tip_radius"),
        (PipeModel { taper: f32::NAN, ..pipe() }, "taper"),
        (PipeModel { trunk_radius: Some(-1.0), ..pipe() }, "trunk_radius"),
    ];
    for (rule, name) in bad {
        assert_eq!(field(rule.validate()), name);
        assert_eq!(field(RadiusRule::Pipe(rule).apply(&mut whorl(2))), name);
    }
    let tip = TipDistance::default;
    let bad = [
        (TipDistance { scale: f32::INFINITY, ..tip() }, "scale"),
        (TipDistance { zeta: -0.1, ..tip() }, "zeta"),
        (TipDistance { min_radius: -1.0, ..tip() }, "min_radius"),
    ];
    for (rule, name) in bad {
        assert_eq!(field(rule.validate()), name);
        assert_eq!(field(rule.radii_at_levels(&single(), &[0]).map(drop)), name);
    }
    let rule = StrandModel { strand_diameter: 0.0, ..Default::default() };
    assert_eq!(field(rule.validate()), "strand_diameter");
}

#[test]
fn a_radius_too_large_for_the_skeleton_is_an_error_at_its_node() {
    // The way up and down the whole range of f32, often enough that the sum passes it.
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0).unwrap();
    for i in 0..20 {
        builder.add(i, Vec3::Y * if i % 2 == 0 { f32::MAX } else { f32::MIN }, 0.0).unwrap();
    }
    let skeleton = builder.finish();
    let rule = PipeModel { taper: 1.0, ..Default::default() };
    assert!(matches!(
        rule.radii(&skeleton),
        Err(CoreError::OutOfRange { field: "radii", index: 0, .. })
    ));
    assert!(TipDistance::default().radii(&skeleton).is_ok());
}

#[cfg(feature = "serde")]
#[test]
fn presets_may_leave_fields_out() {
    let rule: RadiusRule = serde_json::from_str(r#"{"Pipe":{"exponent":2.0}}"#).unwrap();
    assert_eq!(rule, RadiusRule::Pipe(PipeModel::with_exponent(2.0)));
    for rule in all_rules() {
        let text = serde_json::to_string(&rule).unwrap();
        assert_eq!(serde_json::from_str::<RadiusRule>(&text).unwrap(), rule);
    }
}

proptest! {
    #[test]
    fn no_rule_lets_radii_grow_towards_the_tip(skeleton in any_skeleton(200)) {
        for rule in all_rules() {
            let radii = rule.radii(&skeleton).unwrap();
            assert_never_thicker_than_below(&skeleton, &radii);
        }
    }

    #[test]
    fn the_pipe_equation_holds_at_every_fork(
        skeleton in any_skeleton(200),
        exponent in 1.0_f32..10.0,
        trunk in proptest::option::of(0.01_f32..3.0),
    ) {
        let rule = PipeModel { exponent, taper: 0.0, trunk_radius: trunk, ..Default::default() };
        let radii = rule.radii(&skeleton).unwrap();
        assert_pipe_equation(&skeleton, exponent, &radii);
    }

    #[test]
    fn no_strand_is_lost_or_made(skeleton in any_skeleton(200), spare in 0_u64..100_000) {
        let children = skeleton.children();
        let tips = skeleton.tip_counts();
        let base = u64::from(tips[0]) + spare;
        for count in [StrandCount::PerTip, StrandCount::ByAngle { base }] {
            let model = StrandModel { count, ..Default::default() };
            let strands = model.strands(&skeleton).unwrap();
            for node in 0..skeleton.len() as u32 {
                prop_assert!(strands[node as usize] >= u64::from(tips[node as usize]));
                if !children.is_tip(node) {
                    let above: u64 = children.of(node).iter().map(|&c| strands[c as usize]).sum();
                    prop_assert_eq!(above, strands[node as usize]);
                }
            }
        }
    }
}
