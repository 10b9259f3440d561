use super::*;
use crate::topology::shapes::{ball, both, cube, cylinder, torus};
use crate::topology::{examine, welded};
use glam::{Vec2, Vec3};
use tree_core::Limits;

fn refined(surface: &Surface, levels: u32) -> Surface {
    let params = SubdivideParams { levels, ..Default::default() };
    subdivide(surface, &params, &Control::default()).unwrap()
}

#[test]
fn closed_shapes_stay_closed_and_keep_their_number_of_handles() {
    for (name, shape) in [
        ("ball", ball(8)),
        ("torus", torus(12, 8, 0.4)),
        ("cylinder", cylinder(8, 2)),
        ("cube", cube()),
        ("two", both(&cube(), &ball(6), 9.0 * Vec3::X)),
        ("corner to corner", both(&cube(), &cube(), Vec3::splat(2.0))),
    ] {
        let (before, after) = (examine(&shape).unwrap(), examine(&refined(&shape, 2)).unwrap());
        assert_eq!(after.n_triangles, 16 * before.n_triangles, "{name}");
        assert_eq!(after.is_closed(), before.is_closed(), "{name}: {after:?}");
        assert_eq!(after.euler(), before.euler(), "{name}");
        assert_eq!(after.components, before.components, "{name}");
        let share = after.volume / before.volume;
        assert!((0.99..1.2).contains(&share), "{name}: {share}");
    }
}

#[test]
fn a_fitted_surface_passes_through_the_points_and_loops_own_shrinks() {
    let coarse = torus(12, 8, 0.4);
    let with = |fit| {
        let params = SubdivideParams { fit, ..Default::default() };
        subdivide(&coarse, &params, &Control::default()).unwrap()
    };
    let (own, fitted) = (with(0), with(5));
    let missed = |fine: &Surface| {
        let pairs = fine.positions.iter().zip(&coarse.positions);
        pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max)
    };
    // Old vertices keep their numbers.
    assert!(missed(&own) > 0.05 && missed(&fitted) < 0.002, "{} {}", missed(&own), missed(&fitted));
    let volume = |fine: &Surface| examine(fine).unwrap().volume;
    let round = 2.0 * std::f64::consts::PI * std::f64::consts::PI * 0.16;
    assert!((volume(&fitted) / round - 1.0).abs() < 0.03, "{} {round}", volume(&fitted));
    assert!(volume(&own) < 0.9 * round);
}

#[test]
fn every_copy_of_a_point_has_the_same_bits() {
    let fine = refined(&cylinder(6, 2), 2);
    let by_place = examine(&Surface { welds: Vec::new(), ..fine.clone() }).unwrap();
    let by_welds = examine(&fine).unwrap();
    assert_eq!(by_place, by_welds);
    assert!(by_welds.cracks == 0 && by_welds.is_closed());
}

#[test]
fn drawn_edges_stay_where_they_are_and_others_are_rounded() {
    // A cube whose faces have their own normals is all creases.
    let fine = refined(&cube(), 2);
    let found = examine(&fine).unwrap();
    assert!((found.volume - 8.0).abs() < 1e-5 && (found.area - 24.0).abs() < 1e-5);
    let flat = |(p, n): (&Vec3, &Vec3)| (p.dot(*n) - 1.0).abs() < 1e-6;
    assert!(fine.positions.iter().zip(&fine.normals).all(flat));
    // The same cube with smooth normals becomes a ball.
    let mut smooth = cube();
    smooth.normals = smooth.positions.iter().map(|p| p.normalize()).collect();
    let fine = refined(&smooth, 3);
    let reach: Vec<f32> = fine.positions.iter().map(|p| p.length()).collect();
    let (low, high) = reach.iter().fold((9.0_f32, 0.0_f32), |(l, h), &r| (l.min(r), h.max(r)));
    assert!(high < 1.4 * low, "{low} {high}");
}

#[test]
fn the_rim_of_a_trunk_is_kept_and_its_foot_stays_flat() {
    let fine = refined(&cylinder(12, 3), 2);
    let on_ground = |i: &usize| fine.positions[*i].y < 1e-6;
    let ground: Vec<usize> = (0..fine.positions.len()).filter(on_ground).collect();
    let lowest = fine.positions.iter().map(|p| p.y).fold(f32::MAX, f32::min);
    assert!(lowest == 0.0, "nothing sinks below the ground");
    let rim = |i: &&usize| fine.positions[**i].length() > 0.9;
    // On the rim stand copies that look down and copies that look out, and no others.
    let normals: Vec<Vec3> = ground.iter().filter(rim).map(|&i| fine.normals[i]).collect();
    let down = normals.iter().filter(|n| n.y < -0.999).count();
    let out = normals.iter().filter(|n| n.y.abs() < 0.02).count();
    assert!(down >= 48 && out >= 48 && down + out == normals.len(), "{down} {out}");
    // The wall's circle is rounder than the polygon of 12 sides was.
    let radii: Vec<f32> = ground.iter().filter(rim).map(|&i| fine.positions[i].length()).collect();
    let (low, high) = radii.iter().fold((9.0_f32, 0.0_f32), |(l, h), &r| (l.min(r), h.max(r)));
    assert!(high - low < 0.01, "{low} {high}");
}

#[test]
fn normals_of_a_refined_ball_point_outwards_and_tangents_lie_across() {
    let mut coarse = ball(10);
    coarse.tangents =
        coarse.normals.iter().map(|n| n.any_orthonormal_vector().extend(-1.0)).collect();
    let fine = refined(&coarse, 2);
    for ((p, n), t) in fine.positions.iter().zip(&fine.normals).zip(&fine.tangents) {
        assert!((n.length() - 1.0).abs() < 1e-5);
        assert!(n.dot(p.normalize()) > 0.999, "{p} {n}");
        assert!(t.truncate().dot(*n).abs() < 1e-5 && t.w == -1.0);
        assert!((t.truncate().length() - 1.0).abs() < 1e-5);
    }
}

#[test]
fn textures_are_not_smeared_over_the_seam() {
    // u runs once round; a triangle that joins both sides of the seam would span nearly all of it.
    let coarse = ball(8);
    let widest = |s: &Surface| {
        s.indices
            .chunks(3)
            .map(|t| {
                let u: Vec<f32> = t.iter().map(|&i| s.uvs[i as usize].x).collect();
                u.iter().copied().fold(0.0, f32::max) - u.iter().copied().fold(1.0, f32::min)
            })
            .fold(0.0, f32::max)
    };
    let fine = refined(&coarse, 2);
    assert!(widest(&fine) < 0.3 * widest(&coarse), "{} {}", widest(&fine), widest(&coarse));
    let both_sides = fine.uvs.iter().filter(|uv| uv.x == 1.0).count();
    assert!(both_sides >= 30, "the seam keeps its copies: {both_sides}");
}

#[test]
fn columns_are_carried_and_copies_agree_on_their_branch() {
    let mut coarse = cylinder(8, 2);
    let points = welded(&coarse).unwrap();
    coarse.welds = points.of_vertex.iter().map(|&p| points.first[p as usize]).collect();
    let n = coarse.positions.len();
    coarse.branches = coarse.positions.iter().map(|p| u32::from(p.y > 0.5)).collect();
    coarse.occlusion = coarse.positions.iter().map(|p| 0.5 * p.y).collect();
    coarse.uvs2 = coarse.uvs.iter().map(|uv| uv * 0.5 + Vec2::splat(0.25)).collect();
    let fine = refined(&coarse, 1);
    let n_fine = fine.positions.len();
    assert!(n_fine > 2 * n);
    for length in [fine.branches.len(), fine.occlusion.len(), fine.uvs2.len(), fine.welds.len()] {
        assert_eq!(length, n_fine);
    }
    assert!(fine.branches.iter().zip(&fine.welds).all(|(&b, &w)| b == fine.branches[w as usize]));
    assert!(fine.uvs2.iter().zip(&fine.uvs).all(|(b, a)| b.distance(*a * 0.5 + 0.25) < 1e-6));
    // A midpoint of the wall between rings stands between them in the column too.
    assert!(fine.occlusion.contains(&0.25));
    crate::topology::weld(&fine).unwrap();
}

#[test]
fn open_and_broken_surfaces_are_refined_too() {
    let mut shape = torus(8, 6, 0.3);
    shape.indices.truncate(60);
    shape.indices.swap(0, 1);
    shape.indices.extend([0, 0, 1, 3, 3, 3, 0, 1, 30]);
    let before = examine(&shape).unwrap();
    let after = examine(&refined(&shape, 2)).unwrap();
    assert!(before.boundary_edges > 0 && before.misoriented_edges > 0);
    // Collapsed triangles give collapsed ones and, out of (a, a, b), none that are not.
    assert_eq!(after.misoriented_edges, 4 * before.misoriented_edges);
    assert_eq!(after.boundary_edges, 4 * before.boundary_edges);
}

#[test]
fn what_cannot_be_done_is_refused() {
    let control = Control::default();
    let limited = control.clone().with_limits(Limits { triangles: 100, ..Default::default() });
    let error = |surface: &Surface, params, control: &Control| {
        subdivide(surface, &params, control).unwrap_err()
    };
    let found = error(&cube(), SubdivideParams::default(), &limited);
    assert!(found.to_string().contains("192"), "{found}");
    let deep = SubdivideParams { levels: 9, ..Default::default() };
    assert!(error(&cube(), deep, &control).to_string().starts_with("levels is 9"));
    let odd = SubdivideParams { crease: f32::NAN, ..Default::default() };
    assert!(
        matches!(error(&cube(), odd, &control), MeshError::Parameter(error) if error.field == "crease")
    );
    let leaves = Surface { anchors: vec![Vec3::ZERO; 6], ..cube() };
    let found = error(&leaves, SubdivideParams::default(), &control);
    assert!(matches!(found, MeshError::Leaves { found: 6 }));
}
