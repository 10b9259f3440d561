use super::*;
use crate::subdivide::{SubdivideParams, subdivide};
use crate::topology::examine;
use crate::topology::shapes::{ball, cylinder};

/// A trunk fine enough for the relief of these tests.
fn trunk() -> Surface {
    let params = SubdivideParams { levels: 3, ..Default::default() };
    subdivide(&cylinder(24, 6), &params, &Control::default()).unwrap()
}

const COARSE: DisplaceParams = DisplaceParams {
    amplitude: 0.05,
    scale: 0.5,
    stretch: 2.0,
    octaves: 2,
    share: 0.5,
    radius: 1.0,
    ground: Some(0.0),
    seed: Seed(4),
};

fn displaced(mut surface: Surface, branches: &[Branch], displacement: &DisplaceParams) -> Surface {
    displace(&mut surface, branches, displacement, &Control::default()).unwrap();
    surface
}

#[test]
fn a_closed_surface_stays_closed_and_moves_no_more_than_it_may() {
    let before = trunk();
    let after = displaced(before.clone(), &[], &COARSE);
    let found = examine(&after).unwrap();
    assert!(found.is_closed() && found.euler() == 2 && found.cracks == 0, "{found:?}");
    let moved = before.positions.iter().zip(&after.positions).map(|(a, b)| a.distance(*b));
    let most = moved.fold(0.0_f32, f32::max);
    assert!((0.02..=0.0501).contains(&most), "{most}");
    let again = displaced(before.clone(), &[], &COARSE);
    assert_eq!(after, again);
    let other = displaced(before, &[], &DisplaceParams { seed: Seed(5), ..COARSE });
    assert_ne!(after, other);
}

#[test]
fn the_foot_stays_on_the_ground() {
    let before = trunk();
    let after = displaced(before.clone(), &[], &COARSE);
    let mut spread = 0.0_f32;
    for (a, b) in before.positions.iter().zip(&after.positions).filter(|(a, _)| a.y <= 0.0) {
        assert_eq!(a.y, b.y);
        spread = spread.max(a.distance(*b));
    }
    assert!(spread > 0.001, "the rim follows the bark");
    let free = displaced(before, &[], &DisplaceParams { ground: None, ..COARSE });
    assert!(free.positions.iter().any(|p| p.y < -0.001));
}

#[test]
fn normals_follow_the_relief() {
    let after = displaced(trunk(), &[], &COARSE);
    // Against the normals of the triangles themselves, on the wall away from the rims.
    let (mut new, mut old, mut n) = (0.0, 0.0, 0.0);
    for corners in after.indices.chunks(3) {
        let at = |k: usize| after.positions[corners[k] as usize];
        let face = (at(1) - at(0)).cross(at(2) - at(0)).normalize();
        let middle = (at(0) + at(1) + at(2)) / 3.0;
        if (0.3..1.7).contains(&middle.y) {
            let normal = corners.iter().map(|&i| after.normals[i as usize]).sum::<Vec3>();
            new += face.angle_between(normal);
            old += face.angle_between(Vec3::new(middle.x, 0.0, middle.z));
            n += 1.0;
        }
    }
    let (new, old) = (new / n, old / n);
    assert!(new < 0.25 * old, "mean angle {new} with the correction, {old} without");
    assert!(after.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
}

#[test]
fn thin_branches_move_less_and_tips_not_at_all() {
    let mut shape = ball(12);
    shape.branches = vec![0; shape.positions.len()];
    let branch = Branch {
        pivot: Vec3::NEG_Y,
        axis: Vec3::Y,
        length: 2.0,
        radius: 0.02,
        ..Default::default()
    };
    let strong = DisplaceParams { amplitude: 1.0, share: 0.5, ground: None, ..COARSE };
    let after = displaced(shape.clone(), &[branch], &strong);
    for (a, b) in shape.positions.iter().zip(&after.positions) {
        assert!(a.distance(*b) <= 0.5 * 0.02 + 1e-6);
        if a.y > 0.9999 {
            assert!(a.distance(*b) < 1e-6);
        }
    }
}

#[test]
fn odd_parameters_and_surfaces_are_refused_and_nothing_changes() {
    let mut shape = cylinder(6, 1);
    let control = Control::default();
    let bad = DisplaceParams { scale: 0.0, ..COARSE };
    let error = displace(&mut shape, &[], &bad, &control).unwrap_err();
    assert!(matches!(error, MeshError::Parameter(error) if error.field == "scale"));
    shape.branches = vec![1; shape.positions.len()];
    let before = shape.clone();
    let error = displace(&mut shape, &[Branch::default()], &COARSE, &control).unwrap_err();
    assert!(matches!(error, MeshError::Dangling { what: "branch", found: 1, count: 1, .. }));
    assert_eq!(shape, before);
    // No length, no radius: nothing moves, nothing is NaN.
    shape.branches = vec![0; shape.positions.len()];
    let after = displaced(shape.clone(), &[Branch::default()], &COARSE);
    assert_eq!(after.positions, shape.positions);
}
