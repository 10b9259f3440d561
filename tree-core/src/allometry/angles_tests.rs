use super::angles::*;
use super::pipe::PipeModel;
use crate::error::CoreError;
use proptest::prelude::*;

#[test]
fn murrays_angle_of_equal_branches_for_delta_three_is_that_of_the_textbook() {
    let r0 = libm::cbrtf(2.0);
    let angles = murray_angles(r0, 1.0, 1.0).unwrap();
    assert!((angles.sum().to_degrees() - 74.93).abs() < 0.01, "{angles:?}");
    // Eq. 5.4 for r1 = r2: cos a = r0² / (2 r1²).
    let cosine = libm::cosf(angles.alpha1);
    assert!((cosine - r0 * r0 / 2.0).abs() < 1e-6);
}

#[test]
fn da_vincis_radii_leave_no_angle() {
    for (r1, r2) in [(1.0_f32, 1.0_f32), (0.3, 0.1), (0.2, 0.7)] {
        let r0 = (r1 * r1 + r2 * r2).sqrt();
        let angles = murray_angles(r0, r1, r2).unwrap();
        assert!(angles.sum() < 5e-3, "{angles:?}");
    }
    for (r1, r2) in [(1.0, 1.0), (1e-3, 2.0), (2.0, 1e-30), (1e-37, 3e38)] {
        let angles = pipe_angles(PipeModel::DA_VINCI, r1, r2).unwrap();
        assert!(angles.sum() < 1e-6, "{r1} {r2} {angles:?}");
    }
}

#[test]
fn pipe_angles_at_their_limits() {
    let textbook = pipe_angles(3.0, 0.5, 0.5).unwrap();
    assert!((textbook.sum().to_degrees() - 74.93).abs() < 0.01, "{textbook:?}");
    assert_eq!(textbook.alpha1, textbook.alpha2);
    let twig = pipe_angles(PipeModel::MANDELBROT, 1e-30, 1.0).unwrap();
    assert!(
        (twig.alpha1 - std::f32::consts::FRAC_PI_2).abs() < 1e-6 && twig.alpha2 == 0.0,
        "{twig:?}"
    );
    assert!(matches!(
        pipe_angles(1.9, 1.0, 1.0),
        Err(CoreError::Parameter(error)) if error.field == "exponent"
    ));
    assert!(pipe_angles(3.0, 0.0, 1.0).is_err() && pipe_angles(3.0, 1.0, f32::NAN).is_err());
}

#[test]
fn an_impossible_fork_states_the_range_of_its_base() {
    assert!(matches!(
        murray_angles(2.0, 1.0, 1.0),
        Err(CoreError::Parameter(crate::ParameterError { field, found: 2.0, min: 0.0, max }))
            if field == "r0" && (max - 2.0_f64.sqrt()).abs() < 1e-12
    ));
    assert!(murray_angles(0.1, 2.0, 1.0).is_err());
    assert!(matches!(
        murray_angles(1.0, f32::NAN, 1.0),
        Err(CoreError::Parameter(error)) if error.field == "r1"
    ));
    assert!(
        matches!(murray_angles(1.0, 1.0, 0.0), Err(CoreError::Parameter(error)) if error.field == "r2")
    );
}

#[test]
fn strand_angles_refuse_a_fork_without_strands() {
    assert!(strand_angles(0, 0, 1.0).is_err());
    assert!(strand_angles(1, 1, f32::NAN).is_err());
    assert!(strand_angles(1, 1, -0.1).is_err());
    let all = strand_angles(u64::MAX, 0, 1.0).unwrap();
    assert_eq!((all.alpha1, all.alpha2), (0.0, 1.0));
}

proptest! {
    #[test]
    fn murrays_three_equations_agree(r1 in 0.01_f32..1.0, r2 in 0.01_f32..1.0, delta in 2.05_f32..8.0) {
        let power = |r: f32| libm::pow(f64::from(r), f64::from(delta));
        let r0 = libm::pow(power(r1) + power(r2), 1.0 / f64::from(delta)) as f32;
        let angles = murray_angles(r0, r1, r2).unwrap();
        let direct = pipe_angles(delta, r1, r2).unwrap();
        prop_assert!((direct.sum() - angles.sum()).abs() < 2e-2, "{:?} {:?}", angles, direct);
        let fourth = |r: f32| libm::pow(f64::from(r), 4.0);
        let cosine = (fourth(r0) - fourth(r1) - fourth(r2))
            / (2.0 * f64::from(r1) * f64::from(r1) * f64::from(r2) * f64::from(r2));
        let expected = libm::acos(cosine.clamp(-1.0, 1.0));
        // Eq. 5.6 loses digits to cancellation where a twig leaves a trunk.
        let tolerance = 1e-2;
        prop_assert!((f64::from(angles.sum()) - expected).abs() < tolerance, "{:?} {}", angles, expected);
        prop_assert!(r1 == r2 || (r1 > r2) == (direct.alpha1 < direct.alpha2));
    }
}
