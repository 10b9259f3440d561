//! The closed surface, from the outside.

use crate::{Built, CurveFit, Look, MeshParams, Surface, build};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::collections::BTreeMap;
use tree_core::{Control, Skeleton, Species, Tree};

/// No flare, no rounding: shapes whose measures are known.
fn plain() -> MeshParams {
    MeshParams { flare: 0.0, fit: CurveFit::Straight, max_strip: 1000.0, ..Default::default() }
}

fn bare(skeleton: Skeleton) -> Tree {
    Tree::bare(skeleton, Species::default())
}

fn mesh_of(tree: &Tree, params: &MeshParams) -> Built {
    let look = Look::plain(tree.species());
    let built = build(tree, &look, params, &Control::default()).unwrap();
    built.mesh.check().unwrap();
    built.mesh.check_normals().unwrap();
    built
}

fn chain(points: &[(Vec3, f32)]) -> Skeleton {
    let mut builder = Skeleton::builder(points[0].0, points[0].1).unwrap();
    for (i, &(position, radius)) in points.iter().enumerate().skip(1) {
        builder.add(i as u32 - 1, position, radius).unwrap();
    }
    builder.finish()
}

/// Edges of the welded surface, each used once forwards and once backwards, and Euler's number.
fn assert_closed(surface: &Surface) {
    let edges = edges(surface);
    for (edge, uses) in &edges {
        assert_eq!(*uses, (1, 1), "edge {edge:?}");
    }
    for (vertex, &weld) in surface.welds.iter().enumerate() {
        assert_eq!(surface.positions[vertex], surface.positions[weld as usize]);
        assert_eq!(surface.branches[vertex], surface.branches[weld as usize]);
    }
    if surface.n_triangles() > 0 {
        let used: std::collections::BTreeSet<u32> =
            surface.indices.iter().map(|&i| surface.welds[i as usize]).collect();
        assert_eq!(used.len() + surface.n_triangles() - edges.len(), 2, "Euler");
        let all: std::collections::BTreeSet<u32> = surface.welds.iter().copied().collect();
        assert_eq!(used, all, "points that nothing uses");
    }
}

/// How often each edge is used, forwards and backwards.
fn edges(surface: &Surface) -> BTreeMap<(u32, u32), (u32, u32)> {
    let places = &surface.welds;
    let mut edges = BTreeMap::new();
    for triangle in surface.indices.chunks_exact(3) {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (places[triangle[from] as usize], places[triangle[to] as usize]);
            let entry: &mut (u32, u32) = edges.entry((a.min(b), a.max(b))).or_default();
            match a.cmp(&b) {
                std::cmp::Ordering::Less => entry.0 += 1,
                std::cmp::Ordering::Greater => entry.1 += 1,
                std::cmp::Ordering::Equal => {}
            }
        }
    }
    edges
}

fn volume(surface: &Surface) -> f32 {
    let corner = |i: u32| surface.positions[i as usize];
    surface
        .indices
        .chunks_exact(3)
        .map(|t| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0)
        .sum()
}

#[test]
fn a_straight_trunk_is_a_closed_frustum_with_a_cap() {
    let (r0, r1, h) = (0.3, 0.2, 4.0);
    let skeleton = chain(&[(Vec3::ZERO, r0), (Vec3::Y * h, r1)]);
    for sides in [3, 4, 7, 24, 128] {
        let params = MeshParams { min_sides: sides, max_sides: sides, ..plain() };
        let built = mesh_of(&bare(skeleton.clone()), &params);
        let n = sides as usize;
        // Two rings with a doubled seam, a bottom with a middle, a point for each side.
        assert_eq!(built.report.surfaces[0], (3 * (n + 1) + n, 4 * n));
        let bark = &built.mesh.surfaces[0];
        assert_closed(bark);
        let angle = std::f32::consts::TAU / sides as f32;
        let reach = 0.5 * angle / libm::sinf(0.5 * angle);
        let polygon = 0.5 * sides as f32 * libm::sinf(angle) * reach * reach;
        let frustum = polygon * h / 3.0 * (r0 * r0 + r0 * r1 + r1 * r1);
        let cap = polygon * r1 * r1 * (0.5 * r1) / 3.0;
        // The two triangles of a side fold inwards where rings shrink, by less than a hundredth.
        let share = volume(bark) / (frustum + cap);
        assert!((share - 1.0).abs() < 0.02, "{sides} sides: {share}");
        assert_eq!(built.report.surfaces[1], (0, 0));
    }
}

#[test]
fn seen_from_all_sides_a_branch_is_as_wide_as_its_skeleton_says() {
    let radius = 0.3;
    let skeleton = chain(&[(Vec3::ZERO, radius), (Vec3::Y * 4.0, radius)]);
    for sides in [3, 4, 7, 24] {
        let params = MeshParams { min_sides: sides, max_sides: sides, ..plain() };
        let bark = mesh_of(&bare(skeleton.clone()), &params).mesh.surfaces[0].clone();
        let width = |turn: i32| {
            let (sin, cos) = libm::sincosf(std::f32::consts::PI * turn as f32 / 360.0);
            let across = bark.positions.iter().map(|p| p.x * cos + p.z * sin);
            across.clone().fold(0.0, f32::max) - across.fold(0.0, f32::min)
        };
        let mean = (0..360).map(width).sum::<f32>() / 360.0;
        assert!((mean / (2.0 * radius) - 1.0).abs() < 1e-3, "{sides} sides: {mean}");
    }
}

#[test]
fn normals_and_triangles_look_outwards() {
    let skeleton = chain(&[
        (Vec3::ZERO, 0.4),
        (Vec3::new(0.2, 2.0, 0.1), 0.3),
        (Vec3::new(0.9, 4.0, 0.0), 0.02),
    ]);
    let bark = mesh_of(&bare(skeleton), &MeshParams::default()).mesh.surfaces[0].clone();
    assert!(volume(&bark) > 0.0);
    for triangle in bark.indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|k| bark.positions[triangle[k] as usize]);
        let face = (b - a).cross(c - a).normalize_or_zero();
        for &corner in triangle {
            let normal = bark.normals[corner as usize];
            assert!(face.dot(normal) > 0.3, "{a} {b} {c}: {face} {normal}");
        }
    }
}

#[test]
fn the_seam_repeats_a_whole_number_of_times_and_v_runs_in_metres() {
    let skeleton = chain(&[(Vec3::ZERO, 0.4), (Vec3::Y * 2.0, 0.3)]);
    let bark = mesh_of(&bare(skeleton), &plain()).mesh.surfaces[0].clone();
    let most = |pick: fn(&Vec2) -> f32| bark.uvs.iter().map(pick).fold(0.0, f32::max);
    assert_eq!(most(|uv| uv.x), 5.0, "a girth of 2.51 m, tiles of 0.5 m");
    assert!((most(|uv| -uv.y) - 4.67).abs() < 0.01, "2 m and a cap");
}

#[test]
fn a_lateral_stands_on_a_hole_in_its_parents_wall() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.0, 0.25).unwrap();
    builder.add(fork, Vec3::Y * 4.0, 0.2).unwrap();
    builder.add(fork, Vec3::new(1.0, 2.5, 0.0), 0.05).unwrap();
    let built = mesh_of(&bare(builder.finish()), &plain());
    assert_eq!(built.report.n_tubes, 2);
    let bark = &built.mesh.surfaces[0];
    assert_closed(bark);
    let inside = |p: &&Vec3| p.y > 0.1 && p.y < 3.9 && libm::hypotf(p.x, p.z) < 0.15;
    assert_eq!(bark.positions.iter().filter(inside).count(), 0, "vertices inside the trunk");
}

/// A trunk with three laterals, one of them over the seam.
fn branched() -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.0, 0.25).unwrap();
    builder.add(fork, Vec3::Y * 4.0, 0.2).unwrap();
    for side in [Vec3::new(1.0, 2.5, 0.0), Vec3::new(-0.5, 3.0, 0.9), Vec3::new(0.0, 2.2, -1.0)] {
        builder.add(fork, side, 0.12).unwrap();
    }
    builder.finish()
}

#[test]
fn no_two_triangles_share_a_place_in_the_light_map() {
    let params = MeshParams { lightmap: true, ..MeshParams::default() };
    let bark = mesh_of(&bare(branched()), &params).mesh.surfaces[0].clone();
    // Texels that the middle of a triangle or points inside it fall into belong to it alone.
    let mut owners = BTreeMap::new();
    let mut n_clashes = 0;
    for (number, corners) in bark.indices.chunks_exact(3).enumerate() {
        let [a, b, c] = [0, 1, 2].map(|k| bark.uvs2[corners[k] as usize]);
        for share in [[0.34, 0.33, 0.33], [0.6, 0.2, 0.2], [0.2, 0.6, 0.2], [0.2, 0.2, 0.6]] {
            let at = a * share[0] + b * share[1] + c * share[2];
            assert!(at.x >= 0.0 && at.x <= 1.0 && at.y >= 0.0 && at.y <= 0.5, "{at}");
            let texel = ((at.x * 16384.0) as u32, (at.y * 16384.0) as u32);
            let owner = *owners.entry(texel).or_insert(number);
            n_clashes += usize::from(owner != number);
        }
    }
    assert!(n_clashes * 100 < bark.n_triangles(), "{n_clashes} of {}", bark.n_triangles());
}

#[test]
fn tangents_run_with_u_and_complete_a_frame_up_the_picture() {
    let params = MeshParams { tangents: true, ..MeshParams::default() };
    let bark = mesh_of(&bare(branched()), &params).mesh.surfaces[0].clone();
    let (mut right, mut wrong) = (0, 0);
    for corners in bark.indices.chunks_exact(3) {
        let [p, q, r] = [0, 1, 2].map(|k| bark.positions[corners[k] as usize]);
        let [a, b, c] = [0, 1, 2].map(|k| bark.uvs[corners[k] as usize]);
        let (e, f, s, t) = (q - p, r - p, b - a, c - a);
        let area = s.x * t.y - s.y * t.x;
        if area.abs() < 1e-9 {
            continue;
        }
        let (by_u, by_v) = ((e * t.y - f * s.y) / area, (f * s.x - e * t.x) / area);
        let vertex = corners[0] as usize;
        let (tangent, normal) = (bark.tangents[vertex], bark.normals[vertex]);
        let up = tangent.w * normal.cross(tangent.truncate());
        let holds = tangent.truncate().dot(by_u) > 0.0 && up.dot(by_v) < 0.0;
        if holds { right += 1 } else { wrong += 1 }
    }
    assert!(wrong * 20 < right, "{wrong} of {}", right + wrong);
}

#[test]
fn no_strip_is_longer_than_allowed() {
    let skeleton = chain(&[(Vec3::ZERO, 0.2), (Vec3::Y * 10.0, 0.2)]);
    let params = MeshParams { max_strip: 1.0, ..plain() };
    let bark = mesh_of(&bare(skeleton), &params).mesh.surfaces[0].clone();
    let mut heights: Vec<f32> = bark.positions.iter().map(|p| p.y).collect();
    heights.sort_by(f32::total_cmp);
    let gap = heights.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f32::max);
    assert!(gap < 1.01, "{gap}");
}

#[test]
fn strips_that_no_memory_holds_are_refused() {
    let tree = bare(chain(&[(Vec3::ZERO, 10.0), (Vec3::Y * 1e6, 10.0)]));
    let params = MeshParams { max_strip: 0.001, ..plain() };
    let look = Look::plain(tree.species());
    let error = build(&tree, &look, &params, &Control::default()).unwrap_err();
    assert!(matches!(error, crate::MeshError::Limit(_)), "{error}");
}

#[test]
fn a_thread_along_a_giant_is_walked_in_bounded_time() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0005).unwrap();
    builder.add(0, Vec3::Y * 1e5, 100.0).unwrap();
    builder.add(0, Vec3::new(1.0, 1e5, 0.0), 0.001).unwrap();
    let built = mesh_of(&bare(builder.finish()), &plain());
    assert_closed(&built.mesh.surfaces[0]);
}

#[test]
fn rings_beyond_the_limit_are_refused_before_they_are_all_planned() {
    let points: Vec<_> =
        (0..5000).map(|i| (Vec3::new(0.1 * (i % 2) as f32, 0.05 * i as f32, 0.0), 0.01)).collect();
    let tree = bare(chain(&points));
    let limits = tree_core::Limits { triangles: 100, ..Default::default() };
    let control = Control::default().with_limits(limits);
    let error = build(&tree, &Look::plain(tree.species()), &plain(), &control).unwrap_err();
    assert!(matches!(error, crate::MeshError::Limit(_)), "{error}");
}

#[test]
fn thick_axes_that_end_thin_change_their_count_and_stay_closed() {
    let points: Vec<_> =
        (0..20).map(|i| (Vec3::Y * i as f32 * 0.5, 0.4 * (1.0 - i as f32 / 20.0))).collect();
    let built = mesh_of(&bare(chain(&points)), &plain());
    let bark = &built.mesh.surfaces[0];
    assert_closed(bark);
    assert!(built.report.n_triangles < 20 * 2 * 24);
}

#[test]
fn nothing_but_a_point_has_no_bark() {
    let built =
        mesh_of(&bare(Skeleton::builder(Vec3::Y, 0.5).unwrap().finish()), &MeshParams::default());
    assert_eq!(built.report.n_triangles, 0);
    assert_eq!((built.report.n_tubes, built.report.n_skipped_axes), (0, 1));
}

#[test]
fn the_flare_widens_the_foot_and_nothing_above() {
    let skeleton = chain(&[(Vec3::ZERO, 0.3), (Vec3::Y * 3.0, 0.3), (Vec3::Y * 6.0, 0.2)]);
    let bark = mesh_of(&bare(skeleton), &MeshParams::default()).mesh.surfaces[0].clone();
    assert_closed(&bark);
    let radius = |low: f32, high: f32| {
        let at = bark.positions.iter().filter(|p| p.y >= low && p.y <= high);
        at.map(|p| libm::hypotf(p.x, p.z)).fold(0.0, f32::max)
    };
    let corners = 1.0..1.01;
    assert!(corners.contains(&(radius(0.0, 0.0) / (0.3 * (1.0 + 0.35 * 1.5)))));
    assert!(corners.contains(&(radius(2.9, 3.1) / 0.3)));
}

#[test]
fn a_leaning_trunk_stands_level_on_the_ground() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.5).unwrap();
    builder.add(0, Vec3::new(2.0, 3.0, 0.0), 0.4).unwrap();
    let tree = Tree::bare(builder.finish(), Species::default());
    let params = MeshParams { flare: 0.35, ..plain() };
    let bark = mesh_of(&tree, &params).mesh.surfaces[0].clone();
    let foot = bark.positions.iter().filter(|p| p.y.abs() < 1e-5).count();
    assert!(foot > 12, "only {foot} vertices on the ground");
    assert!(bark.positions.iter().all(|p| p.y > -1e-5), "below the ground");
}

/// A step from one node to the next: mostly ordinary, often not.
fn nasty_step() -> impl Strategy<Value = Vec3> {
    let direction = prop::array::uniform3(-1.0_f32..1.0).prop_map(Vec3::from_array);
    prop_oneof![
        4 => direction.clone(),
        1 => Just(Vec3::ZERO),
        1 => Just(Vec3::Y),
        1 => Just(Vec3::NEG_Y),
        1 => Just(Vec3::Y * 1e-7),
        1 => direction.clone().prop_map(|d| d * 1e-4),
        1 => direction.prop_map(|d| d * 100.0),
    ]
}

fn nasty_radius() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => 0.001_f32..0.3,
        1 => Just(0.0),
        1 => Just(1e-30),
        1 => 1.0_f32..20.0,
    ]
}

fn nasty_skeleton() -> impl Strategy<Value = Skeleton> {
    let node = (nasty_step(), nasty_radius(), any::<prop::sample::Index>(), 0..4_u8);
    prop::collection::vec(node, 0..40).prop_map(|nodes| {
        let mut builder = Skeleton::builder(Vec3::new(0.5, 0.0, -3.0), 0.3).unwrap();
        let mut positions = vec![Vec3::new(0.5, 0.0, -3.0)];
        for (step, radius, parent, far) in nodes {
            let parent = if far == 0 { parent.index(positions.len()) } else { positions.len() - 1 };
            let position = positions[parent] + step;
            builder.add(parent as u32, position, radius).unwrap();
            positions.push(position);
        }
        builder.finish()
    })
}

fn any_params() -> impl Strategy<Value = MeshParams> {
    (0..3_u8, 0..3_u8, 3..20_u32, 0.0_f32..1.0).prop_map(|(fit, flare, sides, lobes)| MeshParams {
        fit: [CurveFit::Straight, CurveFit::Through, CurveFit::Near][fit as usize],
        flare: f32::from(flare),
        max_sides: sides,
        flare_lobe_depth: 0.9 * lobes,
        ..Default::default()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn nasty_skeletons_give_closed_tubes(skeleton in nasty_skeleton(), params in any_params()) {
        let built = mesh_of(&bare(skeleton), &params);
        assert_closed(&built.mesh.surfaces[0]);
    }

    #[test]
    fn ordinary_tubes_use_each_edge_twice(
        steps in prop::collection::vec((prop::array::uniform3(0.05_f32..1.0), 0.001_f32..0.2), 1..30),
        params in any_params(),
    ) {
        let mut at = Vec3::ZERO;
        let points: Vec<_> = steps
            .into_iter()
            .map(|(step, radius)| {
                at += Vec3::from_array(step);
                (at, radius)
            })
            .collect();
        let built = mesh_of(&bare(chain(&points)), &params);
        assert_closed(&built.mesh.surfaces[0]);
    }
}
