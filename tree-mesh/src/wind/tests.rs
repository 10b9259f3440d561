use super::*;
use crate::mesh::Mesh;
use crate::sample;
use tree_core::Continuation;

fn table(levels: u32) -> (Skeleton, Vec<Branch>) {
    let skeleton = sample::skeleton(levels);
    let axes = skeleton.axes(Continuation::Thickest);
    let table = branches(&skeleton, &axes);
    (skeleton, table)
}

#[test]
fn thicker_and_shorter_branches_give_less() {
    assert!(stiffness(3.0, 0.05) > stiffness(3.0, 0.03));
    assert!(stiffness(2.0, 0.03) > stiffness(3.0, 0.03));
    assert_eq!(stiffness(0.0, 0.01), 1.0);
    assert!(stiffness(1.0, 0.0) < 1e-6);
    // Equal slenderness, equal stiffness: the turn of a beam grows with (length / radius)^3.
    assert!((stiffness(1.0, 0.01) - 0.5).abs() < 1e-6);
    let turn = |stiffness: f32| (1.0 - stiffness) / stiffness;
    assert!((turn(stiffness(2.0, 0.01)) / turn(stiffness(1.0, 0.01)) - 8.0).abs() < 1e-4);
}

#[test]
fn phases_are_spread_and_swings_lie_square_to_the_axis() {
    let (_, table) = table(3);
    let mut bins = [0_usize; 5];
    for branch in &table {
        assert!((0.0..1.0).contains(&branch.phase));
        bins[(branch.phase * 5.0) as usize] += 1;
        assert!(branch.swing().dot(branch.axis).abs() < 1e-5);
        assert!((branch.swing().length() - 1.0).abs() < 1e-5);
        assert!(branch.frequency() > 0.0);
    }
    let even = table.len() / 5;
    assert!(bins.iter().all(|&count| count.abs_diff(even) <= 2), "{bins:?}");
}

#[test]
fn reach_runs_from_the_collar_to_the_tip() {
    let (skeleton, table) = table(2);
    let axes = skeleton.axes(Continuation::Thickest);
    for (axis, branch) in axes.iter().zip(&table) {
        assert_eq!(branch.reach(branch.pivot), 0.0);
        assert_eq!(branch.reach(branch.pivot + branch.axis * branch.collar * 0.99), 0.0);
        let mut last = 0.0;
        for &node in axis.nodes {
            let reach = branch.reach(skeleton.positions()[node as usize]);
            assert!(reach >= last);
            last = reach;
        }
        assert!(last > 0.99, "straight branches reach 1 at the tip: {last}");
    }
}

#[test]
fn sway_is_the_deflection_of_a_clamped_beam() {
    assert_eq!((sway(0.0), sway(1.0)), (0.0, 1.0));
    for i in 1..=100 {
        assert!(sway(0.01 * i as f32) > sway(0.01 * (i - 1) as f32));
    }
    // Deflection at the middle of a clamped beam under even load: 17/48 of that at the tip.
    assert!((0.5 * sway(0.5) - 17.0 / 48.0).abs() < 1e-6);
}

#[test]
fn leaves_flutter_from_nothing_at_the_anchor_to_all_at_the_tip() {
    let mesh = sample::mesh(1);
    let size = mesh.surfaces[1].vertices_per_leaf().unwrap();
    for leaf in vertices(&mesh, 1).unwrap().chunks(size) {
        let most = leaf.iter().fold(0.0_f32, |most, vertex| most.max(vertex.flutter));
        assert!((most - 1.0).abs() < 1e-6);
        assert!(leaf.iter().all(|v| v.reach == leaf[0].reach && v.anchor == leaf[0].anchor));
        assert!(leaf.iter().all(|vertex| vertex.flutter >= 0.0));
    }
    assert!(vertices(&mesh, 0).unwrap().iter().all(|vertex| vertex.flutter == 0.0));
}

fn blown(mesh: &Mesh, seconds: f32) -> Vec<Vec<Vec3>> {
    bend(mesh, &Wind::default(), seconds).unwrap()
}

#[test]
fn copies_move_together_bit_by_bit() {
    let mesh = sample::mesh(3);
    let moved = &blown(&mesh, 0.7)[0];
    let welds = &mesh.surfaces[0].welds;
    assert!(welds.iter().enumerate().any(|(vertex, &first)| first != vertex as u32));
    for (vertex, &first) in welds.iter().enumerate() {
        assert_eq!(
            moved[vertex].to_array().map(f32::to_bits),
            moved[first as usize].to_array().map(f32::to_bits)
        );
    }
    assert!(moved.iter().zip(&mesh.surfaces[0].positions).any(|(a, b)| a.distance(*b) > 0.1));
}

#[test]
fn a_branch_starts_exactly_where_its_parent_takes_it() {
    let mesh = sample::mesh(3);
    // A point at each pivot, once as wood of the branch and once as wood of its parent.
    let mut probe = Mesh { branches: mesh.branches.clone(), ..Mesh::default() };
    let mut surface = crate::Surface::default();
    for (number, branch) in mesh.branches.iter().enumerate().skip(1) {
        surface.positions.extend([branch.pivot; 2]);
        surface.branches.extend([number as u32, branch.parent]);
    }
    probe.surfaces.push(surface);
    let moved = &blown(&probe, 1.3)[0];
    for (pair, start) in moved.chunks(2).zip(probe.surfaces[0].positions.chunks(2)) {
        assert!(pair[0].distance(pair[1]) < 1e-5, "{pair:?}");
        assert!(pair[0].distance(start[0]) > 1e-3, "a bough's pivot moves with the trunk");
    }
}

#[test]
fn the_root_flare_stands_still_and_calm_air_moves_nothing() {
    let mesh = sample::mesh(2);
    let moved = blown(&mesh, 0.4);
    let trunk = &mesh.branches[0];
    for (vertex, &position) in mesh.surfaces[0].positions.iter().enumerate() {
        if mesh.surfaces[0].branches[vertex] == 0 && position.distance(trunk.pivot) < trunk.collar {
            assert_eq!(moved[0][vertex], position);
        }
    }
    let calm = Wind { strength: 0.0, flutter: 0.0, ..Wind::default() };
    for (moved, surface) in bend(&mesh, &calm, 3.0).unwrap().iter().zip(&mesh.surfaces) {
        for (a, b) in moved.iter().zip(&surface.positions) {
            assert!(a.distance(*b) < 1e-4);
        }
    }
}

#[test]
fn wind_blows_downwind_and_tears_nothing() {
    let mesh = sample::mesh(3);
    let wind = Wind { gusts: 0.0, ..Wind::default() };
    let moved = bend(&mesh, &wind, 0.0).unwrap();
    let surface = &mesh.surfaces[0];
    let mean = moved[0].iter().zip(&surface.positions).map(|(a, b)| a.x - b.x).sum::<f32>();
    assert!(mean / moved[0].len() as f32 > 0.1);
    // No edge of a tube is stretched or squeezed much.
    for corners in surface.indices.chunks(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let [a, b] = [corners[a] as usize, corners[b] as usize];
            let before = surface.positions[a].distance(surface.positions[b]);
            let after = moved[0][a].distance(moved[0][b]);
            if before > 1e-4 {
                assert!((after / before - 1.0).abs() < 0.6, "{before} m became {after} m");
            }
        }
    }
}

#[test]
fn meshes_without_branches_stay_where_they_are() {
    let mut mesh = sample::mesh(1);
    mesh.branches.clear();
    mesh.surfaces.iter_mut().for_each(|surface| surface.branches.clear());
    assert_eq!(blown(&mesh, 1.0)[0], mesh.surfaces[0].positions);
    mesh.surfaces[0].branches = vec![5; mesh.surfaces[0].positions.len()];
    assert!(bend(&mesh, &Wind::default(), 0.0).is_err());
}

#[test]
fn one_surface_bends_as_all_do_and_a_wind_that_is_none_is_refused() {
    let mesh = sample::mesh(2);
    let wind = Wind::default();
    let all = bend(&mesh, &wind, 2.5).unwrap();
    for (number, surface) in all.iter().enumerate() {
        assert_eq!(&bend_surface(&mesh, &wind, 2.5, number).unwrap(), surface);
    }
    assert!(bend_surface(&mesh, &wind, 2.5, all.len()).is_err());
    assert!(wind.validate().is_ok());
    assert!(Wind { gusts: 1.5, ..wind }.validate().is_err());
    assert!(Wind { direction: Vec3::NAN, ..wind }.validate().is_err());
}
