use super::*;
use crate::MeshError;
use crate::sample;
use proptest::prelude::*;
use tree_core::CancelFlag;

fn make(skeleton: &Skeleton, params: &CapsuleParams) -> Capsules {
    capsules(skeleton, params, &Control::default()).unwrap()
}

#[test]
fn a_straight_pole_is_one_tight_capsule() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    for i in 1..=40 {
        builder.add(i - 1, Vec3::Y * 0.1 * i as f32, 0.1).unwrap();
    }
    let one = CapsuleParams { max_count: 1, share: 1.0, ..CapsuleParams::default() };
    let made = make(&builder.finish(), &one);
    let [capsule] = made.capsules[..] else { panic!("{made:?}") };
    assert!((capsule.radius - 0.1).abs() < 1e-4);
    assert!((capsule.a.distance(capsule.b) - 4.0).abs() < 1e-3);
    assert!(made.report.is_enough && made.report.held == 1.0);
    // Only the two round ends are too much: 4/3 r over the length.
    assert!((made.report.bulk - 1.0 - 4.0 / 3.0 * 0.1 / 4.0).abs() < 1e-3, "{:?}", made.report);
}

#[test]
fn more_capsules_are_tighter_and_hold_the_share_asked_for() {
    let skeleton = sample::skeleton(3);
    let mut last = f64::INFINITY;
    for max_count in [1, 4, 16, 32, 64] {
        let made = make(&skeleton, &CapsuleParams { max_count, ..CapsuleParams::default() });
        assert!(made.capsules.len() <= max_count as usize);
        assert!(made.report.is_enough, "{:?}", made.report);
        assert!(made.report.bulk <= last, "{max_count}: {:?}", made.report);
        last = made.report.bulk;
    }
    assert!(last < 2.5, "{last}");
}

#[test]
fn saplings_and_bare_points_are_no_special_case() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.01).unwrap();
    builder.add(0, Vec3::Y, 0.008).unwrap();
    let made = make(&builder.finish(), &CapsuleParams::default());
    assert_eq!(made.capsules.len(), 1);
    assert!((made.report.min_radius - 0.005).abs() < 1e-6);
    for radius in [0.0, 0.5] {
        let point = Skeleton::builder(Vec3::ONE, radius).unwrap().finish();
        let made = make(&point, &CapsuleParams::default());
        assert!(made.capsules.is_empty() && made.report.is_enough);
    }
}

#[test]
fn stems_that_share_only_the_root_are_merged_in_the_end() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    for x in [-2.0, 0.0, 2.0] {
        builder.add(0, Vec3::new(x, 3.0, 0.0), 0.15).unwrap();
    }
    let one = CapsuleParams { max_count: 1, ..CapsuleParams::default() };
    let made = make(&builder.finish(), &one);
    assert_eq!(made.capsules.len(), 1);
    assert!(made.report.is_enough);
}

#[test]
fn thousands_of_boughs_on_one_node_are_folded_and_still_held() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.5).unwrap();
    let top = builder.add(0, Vec3::Y * 3.0, 0.4).unwrap();
    for i in 0..3000 {
        let (sin, cos) = libm::sincosf(0.7 * i as f32);
        builder.add(top, Vec3::new(2.0 * cos, 3.5 + 1e-3 * i as f32, 2.0 * sin), 0.05).unwrap();
    }
    let made = make(&builder.finish(), &CapsuleParams::default());
    assert!(made.capsules.len() <= 32 && made.report.is_enough, "{:?}", made.report);
}

#[test]
fn bad_requests_are_refused() {
    let skeleton = sample::skeleton(1);
    for params in [
        CapsuleParams { max_count: 0, ..Default::default() },
        CapsuleParams { min_radius: -1.0, ..Default::default() },
        CapsuleParams { share: f32::NAN, ..Default::default() },
    ] {
        let refused = capsules(&skeleton, &params, &Control::default());
        assert!(matches!(refused, Err(MeshError::Parameter(_))));
    }
    let stop = CancelFlag::default();
    stop.cancel();
    let stopped = Control::default().with_cancel(stop);
    let cancelled = capsules(&skeleton, &CapsuleParams::default(), &stopped);
    assert!(matches!(cancelled, Err(MeshError::Cancelled(_))));
}

fn ball() -> impl Strategy<Value = (Vec3, f32)> {
    ([-3.0_f32..3.0, -3.0_f32..3.0, -3.0_f32..3.0], 0.0_f32..2.0)
        .prop_map(|(p, radius)| (Vec3::from_array(p), radius))
}

proptest! {
    #[test]
    fn every_ball_lies_in_its_capsule(balls in proptest::collection::vec(ball(), 1..20)) {
        let capsule = fit::around(&balls);
        for (p, radius) in balls {
            let room = capsule.radius - capsule.distance_to_core(p);
            prop_assert!(room >= radius - 1e-4, "{room} {radius}");
        }
    }

    #[test]
    fn any_skeleton_gets_capsules_that_hold_its_wood(
        rows in proptest::collection::vec((any::<u32>(), ball()), 1..60),
        max_count in 1_u32..40,
    ) {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.5).unwrap();
        for (number, (parent, (place, radius))) in rows.into_iter().enumerate() {
            builder.add(parent % (number as u32 + 1), place, radius).unwrap();
        }
        let made = make(&builder.finish(), &CapsuleParams { max_count, ..Default::default() });
        prop_assert!(made.capsules.len() <= max_count as usize);
        prop_assert!(made.report.is_enough, "{:?}", made.report);
    }
}
