use super::*;

/// Corners of a cube by the bits of their index: X, Y, Z.
fn cube_positions(min: Vec3, side: f32) -> Vec<Vec3> {
    (0..8_u8)
        .map(|i| {
            let bit = |n: u8| f32::from(i >> n & 1);
            min + side * Vec3::new(bit(0), bit(1), bit(2))
        })
        .collect()
}

/// Outwards; each face is split along the one diagonal or the other.
fn cube_triangles(diagonals: u8) -> Vec<[u32; 3]> {
    let faces: [[u32; 4]; 6] =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    (0..)
        .zip(faces)
        .flat_map(|(face, [a, b, c, d]): (u8, _)| match diagonals >> face & 1 {
            0 => [[a, b, c], [a, c, d]],
            _ => [[b, c, d], [b, d, a]],
        })
        .collect()
}

fn cube(min: Vec3, side: f32, diagonals: u8) -> Volume {
    Volume::mesh(cube_positions(min, side), cube_triangles(diagonals)).unwrap()
}

/// Winding number by solid angles (van Oosterom, Strackee 1983): another method altogether.
fn winding(positions: &[Vec3], triangles: &[[u32; 3]], p: Vec3) -> f64 {
    triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| positions[i as usize].as_dvec3() - p.as_dvec3());
            let (la, lb, lc) = (a.length(), b.length(), c.length());
            let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
            2.0 * libm::atan2(a.dot(b.cross(c)), below)
        })
        .sum::<f64>()
        / (4.0 * std::f64::consts::PI)
}

#[test]
fn points_in_line_with_edges_corners_and_diagonals_are_told_right() {
    for diagonals in 0..64 {
        let cube = cube(Vec3::ZERO, 1.0, diagonals);
        for i in 0..7_u16.pow(3) {
            let along = |n: u32| f32::from(i / 7_u16.pow(n) % 7) * 0.25 - 0.25;
            let p = Vec3::new(along(0), along(1), along(2));
            let surface = cube.distance(p) == Some(0.0);
            let inside = p.cmpgt(Vec3::ZERO).all() && p.cmplt(Vec3::ONE).all();
            assert!(surface || cube.contains(p) == inside, "{diagonals} {p}");
        }
    }
}

#[test]
fn cubes_side_by_side_leave_no_gap_and_share_no_point() {
    for diagonals in [0, 63, 21, 42, 5, 50] {
        let cubes: Vec<Volume> = (0..8_u8)
            .map(|i| {
                let bit = |n: u8| f32::from(i >> n & 1) - 1.0;
                cube(Vec3::new(bit(0), bit(1), bit(2)), 1.0, diagonals ^ i)
            })
            .collect();
        for x in -3..=3_i8 {
            for y in -3..=3_i8 {
                for z in -3..=3_i8 {
                    let p = Vec3::new(f32::from(x), f32::from(y), f32::from(z)) * 0.25;
                    let holders = cubes.iter().filter(|cube| cube.contains(p)).count();
                    assert_eq!(holders, 1, "{diagonals} {p}");
                }
            }
        }
    }
}

#[test]
fn an_icosphere_agrees_with_the_sphere_away_from_the_surface() {
    let (positions, triangles) = icosphere(4);
    let mesh = Volume::mesh(positions, triangles).unwrap();
    let sphere = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    for p in scattered(20_000, 1.2) {
        let distance = sphere.distance(p).unwrap();
        if distance.abs() > 0.005 {
            assert_eq!(mesh.contains(p), sphere.contains(p), "{p}");
        }
        assert!((mesh.distance(p).unwrap() - distance).abs() < 0.005, "{p}");
    }
    let shares = mesh.measure().unwrap() / sphere.measure().unwrap();
    assert!((0.99..1.0).contains(&shares), "{shares}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn above_and_below_corners_and_edges_the_winding_number_is_right(
        radii in proptest::collection::vec(prop_oneof![Just(1.0_f32), 0.4_f32..2.0], 42),
        map in any_map(),
        diagonals in 0_u8..64,
    ) {
        // A bumpy ball and a cube, turned: their corners and edges line up with nothing but the points.
        let (positions, triangles) = icosphere(1);
        let bumpy = positions.iter().map(|&p| {
            let nearest = radii[(p.dot(Vec3::new(7.0, 11.0, 13.0)) * 8.0).abs() as usize % 42];
            map.transform_point3(nearest * p)
        });
        let cube = cube_positions(Vec3::splat(-0.5), 1.0);
        let cube = cube.iter().map(|&p| map.transform_point3(p));
        let meshes = [(bumpy.collect(), triangles), (cube.collect(), cube_triangles(diagonals))];
        for (positions, triangles) in meshes {
            let positions: Vec<Vec3> = positions;
            let volume = Volume::mesh(positions.clone(), triangles.clone()).unwrap();
            for (i, &[a, b, _]) in triangles.iter().enumerate() {
                let (a, b) = (positions[a as usize], positions[b as usize]);
                for target in [a, 0.5 * (a + b)] {
                    for shift in [-1.0, -0.3, 0.1, 0.7] {
                        let p = target + shift * (1.0 + (i % 3) as f32) * Vec3::Y;
                        if volume.distance(p).unwrap().abs() < 1e-4 {
                            continue;
                        }
                        let expected = winding(&positions, &triangles, p).round() != 0.0;
                        prop_assert_eq!(volume.contains(p), expected, "{}", p);
                    }
                }
            }
        }
    }
}

#[test]
fn corners_that_are_doubled_or_negative_zero_are_welded() {
    let positions = cube_positions(Vec3::ZERO, 1.0);
    // Each triangle with corners of its own, zeros of either sign.
    let own: Vec<Vec3> = cube_triangles(9)
        .iter()
        .enumerate()
        .flat_map(|(i, t)| {
            let zero = if i % 2 == 0 { 0.0 } else { -0.0 };
            t.map(|c| positions[c as usize].map(|x| if x == 0.0 { zero } else { x }))
        })
        .collect();
    let triangles = (0..12).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Volume::mesh(own, triangles).unwrap();
    assert!(mesh.contains(Vec3::splat(0.5)));
    assert_eq!(mesh.measure(), Some(1.0));
}

#[test]
fn a_mesh_inside_out_is_solid_and_a_reversed_shell_is_a_hole() {
    let reversed = |triangles: Vec<[u32; 3]>| -> Vec<[u32; 3]> {
        triangles.into_iter().map(|[a, b, c]| [a, c, b]).collect()
    };
    let outer = cube_positions(Vec3::ZERO, 1.0);
    let inside_out = Volume::mesh(outer.clone(), reversed(cube_triangles(0))).unwrap();
    assert!(inside_out.contains(Vec3::splat(0.5)));
    assert_eq!(inside_out.measure(), Some(1.0));
    let both: Vec<Vec3> = [outer, cube_positions(Vec3::splat(0.25), 0.5)].concat();
    let shifted = |triangles: Vec<[u32; 3]>| triangles.into_iter().map(|t| t.map(|c| c + 8));
    let mut triangles = cube_triangles(0);
    triangles.extend(shifted(reversed(cube_triangles(7))));
    let hollow = Volume::mesh(both.clone(), triangles).unwrap();
    assert!(!hollow.contains(Vec3::splat(0.5)) && hollow.contains(Vec3::splat(0.1)));
    assert_eq!(hollow.measure(), Some(0.875));
    let mut triangles = cube_triangles(0);
    triangles.extend(shifted(cube_triangles(7)));
    let merged = Volume::mesh(both, triangles).unwrap();
    assert!(merged.contains(Vec3::splat(0.5)) && merged.contains(Vec3::splat(0.1)));
}

#[test]
fn collapsed_triangles_do_no_harm() {
    let mut triangles = cube_triangles(0);
    triangles.extend([[0, 0, 0], [1, 1, 2], [3, 5, 3]]);
    let mesh = Volume::mesh(cube_positions(Vec3::ZERO, 1.0), triangles).unwrap();
    assert!(mesh.contains(Vec3::splat(0.5)) && !mesh.contains(Vec3::splat(1.5)));
}

#[test]
fn an_open_mesh_is_refused_with_its_edge() {
    let mut triangles = cube_triangles(0);
    triangles.remove(3);
    let error = Volume::mesh(cube_positions(Vec3::ZERO, 1.0), triangles).unwrap_err();
    let text = error.to_string();
    assert!(text.starts_with("mesh: the edge from position ") && text.contains("open"), "{text}");
    // One triangle turned over: every edge has two triangles, but they run the same way.
    let mut triangles = cube_triangles(0);
    triangles[3].swap(0, 1);
    assert!(Volume::mesh(cube_positions(Vec3::ZERO, 1.0), triangles).is_err());
}

#[test]
fn a_mesh_without_depth_or_triangles_or_with_a_wrong_index_is_refused() {
    let positions = cube_positions(Vec3::ZERO, 1.0);
    assert!(matches!(
        Volume::mesh(positions.clone(), vec![]),
        Err(CoreError::Empty { what: "mesh.triangles" })
    ));
    let mut triangles = cube_triangles(0);
    triangles[5][1] = 8;
    let text = Volume::mesh(positions.clone(), triangles).unwrap_err().to_string();
    assert_eq!(text, "mesh: triangle 5 names position 8, but there are only 8");
    assert!(Volume::mesh(vec![], vec![[0, 1, 2]]).is_err());
    for flat in [vec![[0, 1, 2], [0, 2, 1]], vec![[0, 0, 0]]] {
        let text = Volume::mesh(positions.clone(), flat).unwrap_err().to_string();
        assert!(text.contains("one plane"), "{text}");
    }
}
