//! Levels of meshes, checked against the skeletons they are drawn of.

use super::*;
use crate::LodError;
use glam::{Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree};
use tree_mesh::{Look, MeshParams, topology};

/// A trunk of four metres with a branch to either side at each metre, two leaves a branch.
fn tree() -> Tree {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    let mut foliage = Foliage::default();
    let mut trunk = 0;
    for i in 1..=4 {
        let y = i as f32;
        trunk = builder.add(trunk, Vec3::new(0.0, y, 0.0), 0.2 - 0.04 * y).unwrap();
        for side in [-1.0, 1.0] {
            let tip = Vec3::new(side * (1.5 - 0.2 * y), y + 0.5, 0.1);
            let node = builder.add(trunk, tip, 0.02).unwrap();
            for k in 0..2 {
                let rotation = Quat::from_rotation_y(k as f32);
                let leaf = Leaf { node, position: tip, rotation, size: 0.1, kind: 0 };
                foliage.push(leaf).unwrap();
            }
        }
    }
    Tree::new(builder.finish(), foliage, Species::default()).unwrap()
}

fn made() -> (Multires, MultiMesh) {
    let (tree, control) = (tree(), Control::default());
    let multires = Multires::new(&tree, &Metric::default(), &control).unwrap();
    let look = Look::plain(tree.species());
    let mesh = MultiMesh::new(&multires, &look, &MeshParams::default(), &control).unwrap();
    (multires, mesh)
}

#[test]
fn the_whole_tree_is_there_with_all_levels() {
    let (multires, multi) = made();
    assert_eq!((multi.n_levels(), multires.n_levels()), (8, 8));
    multi.mesh().check().unwrap();
    let all = multi.mesh_at(8.0).unwrap();
    assert_eq!(&all, multi.mesh());
    let mut draws = vec![Draw::default(); 2];
    let n = multi.draws(8.0, &mut draws).unwrap();
    assert_eq!(n as usize, multi.mesh().n_triangles());
    // Leaves stand on the branches that are drawn: of four paths, the first goes on from the trunk.
    multi.draws(4.0, &mut draws).unwrap();
    assert_eq!(draws[1].index_count as usize, multi.mesh().surfaces[1].indices.len() / 2);
}

#[test]
fn wood_of_every_level_is_open_only_inside_what_bears_it_and_looks_outwards() {
    let (multires, multi) = made();
    for level in [1.0, 3.0, 8.0] {
        let mut mesh = multi.mesh_at(level).unwrap();
        mesh.surfaces.truncate(1);
        mesh.check_normals().unwrap();
        let surface = &mesh.surfaces[0];
        let examined = topology::examine(surface).unwrap();
        assert_eq!([examined.non_manifold_edges, examined.misoriented_edges], [0; 2]);
        // Edges that only one triangle has lie about the forks, within the wood that is there.
        let mut edges = std::collections::BTreeMap::<[u32; 2], u32>::new();
        for [a, b, c] in surface.indices.as_chunks::<3>().0 {
            for [a, b] in
                [[a, b], [b, c], [c, a]].map(|ends| ends.map(|&i| surface.welds[i as usize]))
            {
                *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        let open: Vec<u32> =
            edges.iter().filter(|(_, n)| **n == 1).flat_map(|(ends, _)| *ends).collect();
        assert_eq!(examined.boundary_edges, open.len() as u64 / 2);
        assert!(open.len() >= 6 * (level as usize - 1));
        let whole = multires.level(8);
        for vertex in open {
            let at = surface.positions[vertex as usize];
            let within = |i: usize| at.distance(whole.positions[i]) <= whole.radii[i] + 1e-5;
            assert!((0..whole.positions.len()).any(within), "{at}");
        }
        let volume: f32 = surface
            .indices
            .chunks_exact(3)
            .map(|t| {
                let [a, b, c] = [t[0], t[1], t[2]].map(|i| surface.positions[i as usize]);
                a.dot(b.cross(c)) / 6.0
            })
            .sum();
        assert!(volume > 0.1, "{volume}");
    }
}

#[test]
fn a_branch_grows_out_of_its_fork_without_a_step() {
    let (multires, multi) = made();
    let reach = |level: f32| multi.mesh_at(level).unwrap();
    let last = multires.level(8).positions;
    let (fork, tip) = (multires.level(8).parents[last.len() - 1], last[last.len() - 1]);
    let way = tip - multires.level(8).positions[fork as usize];
    for fraction in [0.01_f32, 0.5, 0.99] {
        let mesh = reach(7.0 + fraction);
        let far =
            mesh.surfaces[1].positions.iter().rev().take(4).fold(Vec3::ZERO, |s, p| s + *p / 4.0);
        let grown = (far - (tip - way)).dot(way) / way.length_squared();
        assert!((grown - fraction).abs() < 0.15, "{fraction}: {grown}");
    }
    // Just above a whole level nothing has changed yet.
    let (a, b) = (reach(7.0).bounds(), reach(7.000_01).bounds());
    assert!((a.min - b.min).length() + (a.max - b.max).length() < 1e-3);
}

#[test]
fn levels_are_clamped_and_nan_is_an_error() {
    let (_, multi) = made();
    let mut draws = vec![Draw::default(); 2];
    assert_eq!(multi.draws(-5.0, &mut draws).unwrap(), multi.draws(1.0, &mut draws).unwrap());
    assert_eq!(multi.draws(1e9, &mut draws).unwrap() as usize, multi.mesh().n_triangles());
    assert!(matches!(multi.draws(f32::NAN, &mut draws), Err(LodError::Parameter(_))));
    assert!(matches!(multi.draws(1.0, &mut []), Err(LodError::Length { .. })));
    assert_eq!(multi.level_of_wood(0), 1);
    assert_eq!(multi.level_of_wood(u64::MAX), 8);
}

#[test]
fn a_single_node_is_a_tree_without_wood() {
    let tree = Tree::bare(Skeleton::builder(Vec3::ZERO, 1.0).unwrap().finish(), Species::default());
    let control = Control::default();
    let multires = Multires::new(&tree, &Metric::default(), &control).unwrap();
    let look = Look::plain(tree.species());
    let multi = MultiMesh::new(&multires, &look, &MeshParams::default(), &control).unwrap();
    assert_eq!((multi.n_levels(), multi.mesh().n_triangles()), (1, 0));
}

#[test]
fn every_path_is_a_branch_in_the_wind() {
    let (multires, multi) = made();
    let skeleton = multires.tree().skeleton();
    let branches = &multi.mesh().branches;
    assert_eq!(branches.len(), multires.n_levels());
    for (path, branch) in branches.iter().enumerate().skip(1) {
        let first = multires.counts(path).0;
        let fork = skeleton.parents()[first];
        assert_eq!(branch.pivot, skeleton.positions()[fork as usize]);
        // The path that the fork is on.
        let bearer = (1..=path).find(|&n| (fork as usize) < multires.counts(n).0).unwrap() - 1;
        assert_eq!(branch.parent as usize, bearer);
        assert_eq!(branch.level, branches[bearer].level + 1);
    }
    for level in [1.0, 3.5, 8.0] {
        let mesh = multi.mesh_at(level).unwrap();
        mesh.check().unwrap();
        let wind = tree_mesh::wind::vertices(&mesh, 1).unwrap();
        // Leaves hang on the paths that are drawn, at the nodes they grow from.
        assert!(wind.iter().all(|vertex| (vertex.branch as f32) < level));
        assert_eq!(mesh.surfaces[1].anchors.len(), 2 * level.ceil() as usize);
        assert!(wind.iter().any(|vertex| vertex.flutter == 1.0));
        // All paths but the first are straight, with their leaves at the tip.
        let mut whole = wind.iter().filter(|vertex| vertex.branch > 0 && level == level.floor());
        assert!(whole.all(|vertex| vertex.reach > 0.99));
    }
}

#[test]
fn wind_bends_twigs_and_leaves_the_foot_alone() {
    let (_, multi) = made();
    let mesh = multi.mesh();
    let bent = tree_mesh::wind::bend(mesh, &tree_mesh::wind::Wind::default(), 0.3).unwrap();
    let wood = mesh.surfaces[0].positions.iter().zip(&bent[0]);
    for (before, after) in wood.filter(|(before, _)| before.y < 0.1) {
        assert!(before.distance(*after) < 1e-6);
    }
    let leaves = mesh.surfaces[1].positions.iter().zip(&bent[1]);
    let n_moved = leaves.filter(|(before, after)| before.distance(**after) > 0.01).count();
    assert!(4 * n_moved > 3 * bent[1].len(), "{n_moved} of {}", bent[1].len());
}
