//! From a tree to a mesh and back: the skeleton that comes out lies in the one that went in.

#![allow(clippy::unwrap_used)]

use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Skeleton, Tree};
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::path::Preset;
use tree_model::skeletonize::{Part, SkeletonizeParams, Skeletonized, skeletonize};

fn parts(mesh: &Mesh) -> Vec<Part<'_>> {
    let part = |surface: &'_ tree_mesh::Surface| {
        let material = &mesh.materials[surface.material as usize];
        (material.name.clone(), matches!(material.alpha, tree_mesh::Alpha::Mask(_)))
    };
    mesh.surfaces
        .iter()
        .map(|surface| Part {
            positions: &surface.positions,
            uvs: &surface.uvs,
            indices: &surface.indices,
            name: &mesh.materials[surface.material as usize].name,
            alpha_masked: part(surface).1,
            ..Default::default()
        })
        .collect()
}

fn read(mesh: &Mesh) -> Skeletonized {
    skeletonize(&parts(mesh), &SkeletonizeParams::default(), &Control::default()).unwrap()
}

fn grow(preset: &str, bare: bool) -> Tree {
    let mut params = Preset::find(preset).unwrap().params().unwrap();
    if bare {
        params.leaves = None;
    }
    params.grow(Seed(3), &Control::default()).unwrap().tree
}

fn mesh_of(tree: &Tree) -> Mesh {
    let look = Look::built_in(tree.species()).unwrap();
    let params = MeshParams { smooth: std::env::var("SMOOTH").is_ok(), ..Default::default() };
    tree_mesh::build(tree, &look, &params, &Control::default()).unwrap().mesh
}

/// Share of the length of `of` that lies within `share` local radii of `axes`, of wood thicker than
/// `thinnest`.
fn share_within(of: &Skeleton, axes: &Skeleton, share: f32, thinnest: f32) -> f64 {
    let segments: Vec<[(Vec3, f32); 2]> = axes
        .segments()
        .map(|(a, b)| [a, b].map(|n| (axes.positions()[n as usize], axes.radii()[n as usize])))
        .collect();
    // Sorted by x, with the longest extent known, near segments are a run.
    let mut order: Vec<usize> = (0..segments.len()).collect();
    let low = |i: usize| segments[i][0].0.x.min(segments[i][1].0.x);
    order.sort_by(|&a, &b| low(a).total_cmp(&low(b)));
    let reach = segments.iter().map(|s| (s[0].0.x - s[1].0.x).abs()).fold(0.0, f32::max);
    let near = |point: Vec3| {
        let most = 0.5;
        let from = order.partition_point(|&i| low(i) < point.x - reach - most);
        order[from..].iter().take_while(|&&i| low(i) <= point.x + most).any(|&i| {
            let [(a, ra), (b, rb)] = segments[i];
            let run = b - a;
            let t = ((point - a).dot(run) / run.length_squared().max(1e-20)).clamp(0.0, 1.0);
            // A millimetre's floor: thinner wood is drawn thicker than it is.
            point.distance(a + run * t) <= share * (ra + t * (rb - ra)).max(5e-4)
        })
    };
    let (mut within, mut total) = (0.0, 0.0);
    for (a, b) in of.segments() {
        let (pa, pb) = (of.positions()[a as usize], of.positions()[b as usize]);
        if of.radii()[b as usize] < thinnest {
            continue;
        }
        let n = ((pa.distance(pb) / 0.01).ceil() as u32).clamp(1, 200);
        let length = f64::from(pa.distance(pb)) / f64::from(n);
        for i in 0..n {
            total += length;
            let hit = near(pa.lerp(pb, (i as f32 + 0.5) / n as f32));
            within += if hit { length } else { 0.0 };
        }
    }
    within / total.max(1e-9)
}

/// The share of the result's length in the original's axes, and the other way round.
fn there_and_back(preset: &str) -> (f64, f64) {
    let tree = grow(preset, true);
    let made = read(&mesh_of(&tree));
    let (old, new) = (tree.skeleton(), made.tree.skeleton());
    let there = share_within(new, old, 0.5, 0.0);
    let back = share_within(old, new, 0.5, 0.002);
    let (r_old, r_new) = (old.radii()[old.len() / 50], new.radii()[0]);
    println!(
        "{preset}: {there:.4} of ours within half a radius, {back:.4} of theirs found; {} nodes of \
         {}, {r_new} {r_old}, {:?}",
        new.len(),
        old.len(),
        made.report
    );
    for t in [0.0, 0.001, 0.002, 0.004, 0.008, 0.016, 0.03] {
        println!("  {t}: {:.4} {:.4}", share_within(new, old, 0.5, t), share_within(old, new, 0.5, t));
    }
    assert_eq!(made.report.n_left_out, 0);
    (there, back)
}

#[test]
fn an_oak_meshed_and_read_back_lies_in_its_own_axes() {
    let (there, back) = there_and_back("oak");
    assert!(there > 0.95 && back > 0.95, "{there} there, {back} back");
}

#[test]
fn so_does_a_conifer() {
    let (there, back) = there_and_back("e");
    assert!(there > 0.95 && back > 0.95, "{there} there, {back} back");
}
