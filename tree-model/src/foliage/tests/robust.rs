//! Any skeleton, any parameters, any number of threads.

use super::shoot;
use crate::ModelError;
use crate::foliage::*;
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{CancelFlag, Control, Foliage, Limits, Seed, Skeleton, Species, Tree};

/// Skeletons that lean to the nasty: doubles, no lengths, no radii, far away.
fn any_skeleton() -> impl Strategy<Value = Skeleton> {
    let node = (0.0_f32..1.0, prop_oneof![Just(0.0_f32), -1.0_f32..1.0], 0.0_f32..0.05, 0_u8..5);
    let scale = prop_oneof![6 => Just(1.0_f32), 1 => Just(1e-20), 1 => Just(1e4), 1 => Just(1e30)];
    (proptest::collection::vec(node, 0..40), scale).prop_map(|(rows, scale)| {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.05).unwrap();
        for (pick, shift, radius, habit) in rows {
            let last = builder.len() as u32 - 1;
            let parent = match habit {
                0 | 1 => last,
                2 => 0,
                _ => ((pick * (last + 1) as f32) as u32).min(last),
            };
            let position = scale * Vec3::new(shift, pick, shift * pick);
            builder.add(parent, position, if habit == 3 { 0.0 } else { radius }).unwrap();
        }
        builder.finish()
    })
}

/// A number in its range mostly, at its ends, and now and then none at all.
fn number(min: f32, max: f32) -> impl Strategy<Value = f32> {
    let bad = prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(-1e30_f32)];
    prop_oneof![60 => min..max, 4 => Just(min), 4 => Just(max), 1 => bad]
}

fn any_arrangement() -> impl Strategy<Value = Phyllotaxis> {
    prop_oneof![
        number(-6.0, 6.0).prop_map(|divergence| Phyllotaxis::Spiral { divergence }),
        Just(Phyllotaxis::Distichous),
        Just(Phyllotaxis::Opposite),
        Just(Phyllotaxis::Decussate),
        (2_u32..9).prop_map(|count| Phyllotaxis::Whorled { count }),
    ]
}

fn any_form() -> impl Strategy<Value = LeafForm> {
    let pinnate = (0_u32..6, any::<bool>(), number(0.0, 9.0), number(-3.0, 3.0), 0_u32..3)
        .prop_map(|(pairs, odd, rachis, droop, pinna_pairs)| {
            LeafForm::Pinnate(Pinnate {
                pairs,
                odd,
                rachis,
                droop,
                pinna_pairs,
                ..Pinnate::DEFAULT
            })
        });
    prop_oneof![
        3 => Just(LeafForm::Simple),
        2 => pinnate,
        1 => (1_u32..9, number(0.0, 6.0)).prop_map(|(leaflets, spread)| {
            LeafForm::Palmate(Palmate { leaflets, spread, ..Palmate::DEFAULT })
        }),
        1 => (0_u32..6, number(0.0, 1.5))
            .prop_map(|(needles, spread)| LeafForm::Fascicle { needles, spread }),
        1 => (0_u32..40, number(0.0, 3.0))
            .prop_map(|(needles, spread)| LeafForm::Rosette { needles, spread }),
    ]
}

prop_compose! {
    fn any_leaves()(
        arrangement in any_arrangement(),
        form in any_form(),
        spacing in number(0.02, 0.5),
        bearing in number(0.0, 2.0),
        size in number(1e-6, 1e6),
        size_gradient in number(-0.9, 0.9),
        petiole in number(0.0, 100.0),
        angles in (number(0.0, 3.1), number(0.0, 3.1), number(0.0, 3.1)),
        shares in (number(0.0, 1.0), number(0.0, 1.0)),
        light in (number(-1.0, 1.0), Just(0.0_f32), number(-1.0, 1.0)),
        terminal in any::<bool>(),
    ) -> LeafParams {
        LeafParams {
            arrangement, form, spacing, bearing, size, size_gradient, petiole, terminal,
            pitch: angles.0, jitter: angles.1, lamina_turn: angles.2,
            droop: shares.0, phototropism: shares.1, light: light.into(),
            ..LeafParams::DEFAULT
        }
    }
}

prop_compose! {
    fn any_twigs()(
        arrangement in any_arrangement(),
        sympodial in proptest::option::of((0_u32..4, number(0.0, 3.1), number(-6.0, 6.0), number(0.0, 1.0))),
        levels in 0_u32..4,
        per_metre in number(0.01, 40.0),
        bearing in number(0.0, 2.0),
        lengths in (number(1e-5, 1.0), number(0.02, 1.0)),
        taper in number(-1.0, 1.0),
        shares in (number(0.0, 1.0), number(0.0, 0.8), number(0.0, 1.0)),
        angles in (number(0.0, 3.1), number(0.0, 3.1)),
        stiffness in prop_oneof![Just(1e-4_f32), Just(1e6_f32), number(0.01, 10.0)],
        load in number(0.0, 1000.0),
        tropisms in (number(-1000.0, 1000.0), number(-1000.0, 1000.0)),
        radii in (number(1e-6, 100.0), number(0.0, 1.0), number(1.0, 10.0)),
    ) -> TwigParams {
        let branching = sympodial.map_or(Branching::Monopodial, |(internodes, turn, divergence, stub)| {
            Branching::Sympodial { internodes, turn, divergence, stub }
        });
        TwigParams {
            branching, arrangement, levels, per_metre, bearing, taper, stiffness, load,
            length: lengths.0, internode: lengths.1,
            terminal: shares.0, lateral: shares.1, radius_share: shares.2,
            angle: angles.0, jitter: angles.1,
            gravitropism: tropisms.0, phototropism: tropisms.1,
            tip_radius: radii.0, radius_taper: radii.1, pipe_exponent: radii.2,
            ..TwigParams::DEFAULT
        }
    }
}

fn small() -> Control {
    let limits = Limits { nodes: 20_000, leaves: 20_000, ..Limits::default() };
    Control::default().with_limits(limits)
}

fn expected(error: &ModelError) -> bool {
    use ModelError as E;
    matches!(error, E::Parameter(_) | E::NotFinite { .. } | E::Limit(_))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn leaves_are_valid_or_refused(
        skeleton in any_skeleton(),
        params in any_leaves(),
        density in proptest::option::of(prop_oneof![number(0.0, 5.0), Just(1.0_f32)]),
    ) {
        let field = |at: Vec3| density.unwrap_or(1.0) * (1.0 + 0.5 * at.x);
        let field: Option<&DensityField<'_>> = density.is_some().then_some(&field as _);
        match grow_leaves_with_stalks(&skeleton, &params, field, Seed(1), &small()) {
            Ok(leafy) => {
                prop_assert!(params.validate(65536).is_ok());
                leafy.skeleton.check().unwrap();
                prop_assert_eq!(&leafy.skeleton.positions()[..skeleton.len()], skeleton.positions());
                prop_assert_eq!(leafy.report.n_blades as usize, leafy.foliage.len());
                let species = Species { leaf_kinds: vec!["oak".into()], ..Species::default() };
                Tree::new(leafy.skeleton, leafy.foliage, species).unwrap();
            }
            Err(error) => prop_assert!(expected(&error), "{}", error),
        }
    }

    #[test]
    fn twigs_are_valid_or_refused(skeleton in any_skeleton(), params in any_twigs()) {
        match grow_twigs(&skeleton, &params, Seed(1), &small()) {
            Ok(twigs) => {
                prop_assert!(params.validate().is_ok());
                twigs.skeleton.check().unwrap();
                let n = skeleton.len();
                prop_assert_eq!(&twigs.skeleton.positions()[..n], skeleton.positions());
                prop_assert_eq!(&twigs.skeleton.radii()[..n], skeleton.radii());
                prop_assert_eq!(&twigs.skeleton.parents()[..n], skeleton.parents());
                prop_assert_eq!(twigs.skeleton.len() as u64, n as u64 + twigs.report.n_nodes);
                let radii = twigs.skeleton.radii();
                for (parent, node) in twigs.skeleton.segments().skip(n - 1) {
                    prop_assert!(radii[node as usize] <= radii[parent as usize]);
                }
            }
            Err(error) => prop_assert!(expected(&error), "{}", error),
        }
    }
}

/// A bush of a thousand axes.
fn bush() -> Skeleton {
    let twigs = TwigParams { levels: 3, length: 0.6, per_metre: 20.0, ..TwigParams::DEFAULT };
    grow_twigs(&shoot(2.0), &twigs, Seed(9), &Control::default()).unwrap().skeleton
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let bush = bush();
    let field = |at: Vec3| at.y;
    let control = Control::default();
    let all = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
        pool.install(|| {
            let twigs =
                grow_twigs_in(&bush, &TwigParams::DEFAULT, &field, Seed(5), &control).unwrap();
            let leaves = SpeciesPreset::find("ash").unwrap().leaves.clone();
            let some =
                grow_leaves_with_stalks(&bush, &leaves, Some(&field), Seed(5), &control).unwrap();
            (twigs, some)
        })
    };
    let one = all(1);
    assert!(one.0.report.n_twigs > 500 && one.1.report.n_leaves > 500);
    assert_eq!(one, all(2));
    assert_eq!(one, all(5));
}

#[test]
fn another_seed_gives_other_twigs_and_leaves() {
    let control = Control::default();
    let twigs = |seed| grow_twigs(&bush(), &TwigParams::DEFAULT, Seed(seed), &control).unwrap();
    assert_ne!(twigs(1), twigs(2));
    let leaves = |seed| grow_leaves(&bush(), &LeafParams::DEFAULT, Seed(seed), &control).unwrap();
    assert_ne!(leaves(1), leaves(2));
}

#[test]
fn hosts_without_length_or_alone_bear_no_twigs_but_a_tip() {
    let control = Control::default();
    let lone = Skeleton::builder(Vec3::ONE, 0.1).unwrap().finish();
    let twigs = grow_twigs(&lone, &TwigParams::DEFAULT, Seed(1), &control).unwrap();
    assert_eq!(twigs.skeleton, lone);
    assert_eq!(twigs.report.n_barren, 1);
    let mut builder = Skeleton::builder(Vec3::ONE, 0.1).unwrap();
    builder.add(0, Vec3::ONE, 0.1).unwrap();
    let twigs = grow_twigs(&builder.finish(), &TwigParams::DEFAULT, Seed(1), &control).unwrap();
    assert_eq!(twigs.report.n_twigs, 1);
}

#[test]
fn the_ends_of_the_world_are_no_place_for_a_panic() {
    let control = Control::default();
    let far = f32::MAX;
    for (from, to) in [(-far, far), (0.0, far), (far, far), (1e20, -1e20)] {
        let mut builder = Skeleton::builder(Vec3::splat(from), far).unwrap();
        builder.add(0, Vec3::splat(to), far).unwrap();
        let skeleton = builder.finish();
        let _: Result<Twigs, ModelError> =
            grow_twigs(&skeleton, &TwigParams::DEFAULT, Seed(1), &control);
        let _: Result<Foliage, ModelError> =
            grow_leaves(&skeleton, &LeafParams::DEFAULT, Seed(1), &control);
        assert!(from == to || refine(&skeleton, 1.0, 0.1, &control).is_err());
    }
}

#[test]
fn a_cancelled_growth_stops() {
    let flag = CancelFlag::default();
    flag.cancel();
    let control = Control::default().with_cancel(flag);
    let twigs = grow_twigs(&bush(), &TwigParams::DEFAULT, Seed(1), &control);
    assert!(matches!(twigs, Err(ModelError::Cancelled(_))));
    let leaves = grow_leaves(&bush(), &LeafParams::DEFAULT, Seed(1), &control);
    assert!(matches!(leaves, Err(ModelError::Cancelled(_))));
}

#[test]
fn every_field_out_of_range_is_named() {
    let leaves = |change: fn(&mut LeafParams), field: &str| {
        let mut params = LeafParams::DEFAULT;
        change(&mut params);
        let error = params.validate(1).unwrap_err().to_string();
        assert!(error.contains(field), "{field}: {error}");
    };
    leaves(|p| p.petiole = -1.0, "leaves.petiole");
    leaves(|p| p.petiole_radius = 9.0, "leaves.petiole_radius");
    leaves(|p| p.lamina_turn = f32::NAN, "leaves.lamina_turn");
    leaves(|p| p.size_gradient = 1.0, "leaves.size_gradient");
    leaves(|p| p.light = Vec3::ZERO, "leaves.light");
    leaves(|p| p.light = Vec3::NAN, "leaves.light");
    leaves(|p| p.form = LeafForm::Rosette { needles: 0, spread: 1.0 }, "leaves.form.needles");
    leaves(|p| p.kind = 1, "leaves.kind");
    let pinnate = Pinnate { profile: [1.0, 2.0, 1.0], ..Pinnate::DEFAULT };
    let params = LeafParams { form: LeafForm::Pinnate(pinnate), ..LeafParams::DEFAULT };
    assert!(params.validate(1).unwrap_err().to_string().contains("leaves.form.profile[1]"));
    let twigs = |change: fn(&mut TwigParams), field: &str| {
        let mut params = TwigParams::DEFAULT;
        change(&mut params);
        let error = params.validate().unwrap_err().to_string();
        assert!(error.contains(field), "{field}: {error}");
    };
    twigs(|p| p.levels = 4, "twigs.levels");
    twigs(|p| p.crowd = 0, "twigs.crowd");
    twigs(|p| p.per_metre = 0.0, "twigs.per_metre");
    twigs(|p| p.internode = 0.0, "twigs.internode");
    twigs(|p| p.taper = -1.5, "twigs.taper");
    twigs(|p| p.stiffness = 0.0, "twigs.stiffness");
    twigs(|p| p.light = Vec3::ZERO, "twigs.light");
    twigs(|p| p.branching = Branching::helicoid(0, 0.1), "twigs.branching.internodes");
    twigs(|p| p.arrangement = Phyllotaxis::Whorled { count: 2 }, "twigs.arrangement.count");
}
