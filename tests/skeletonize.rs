//! From a tree to a mesh and back: the skeleton that comes out lies in the one that went in.

#![allow(clippy::unwrap_used)]

use tree_core::glam::Vec3;
use tree_core::{Continuation, Control, Seed, Skeleton, Tree};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{CurveFit, Look, Mesh, MeshParams};
use tree_model::path::Preset;
use tree_model::skeletonize::{SkeletonizeParams, Skeletonized, skeletonize};

/// Points of the cubic for each segment.
const SAMPLES: usize = 6;

fn read(mesh: &Mesh) -> Skeletonized {
    skeletonize(&mesh.parts(), &SkeletonizeParams::default(), &Control::default()).unwrap()
}

fn grow(preset: &str, bare: bool) -> Tree {
    let mut params = Preset::find(preset).unwrap().params().unwrap();
    if bare {
        params.leaves = None;
    }
    params.grow(Seed(3), &Control::default()).unwrap().tree
}

fn mesh_of(tree: &Tree, fit: CurveFit) -> Mesh {
    let look = Look::built_in(tree.species()).unwrap();
    let params = MeshParams { fit, ..MeshParams::default() };
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
        let most = 0.2;
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
        let n = ((pa.distance(pb) / 0.04).ceil() as u32).clamp(1, 200);
        let length = f64::from(pa.distance(pb)) / f64::from(n);
        for i in 0..n {
            total += length;
            let hit = near(pa.lerp(pb, (i as f32 + 0.5) / n as f32));
            within += if hit { length } else { 0.0 };
        }
    }
    within / total.max(1e-9)
}

/// The axes as the mesher draws them: straight, or each a cubic spline through its nodes.
fn drawn(skeleton: &Skeleton, fit: CurveFit) -> Skeleton {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let mut builder = Skeleton::builder(positions[0], radii[0]).unwrap();
    let mut new_of = vec![0; skeleton.len()];
    for axis in skeleton.axes(Continuation::Thickest).iter() {
        let fork = skeleton.parent(axis.nodes[0]);
        let nodes: Vec<u32> = fork.into_iter().chain(axis.nodes.iter().copied()).collect();
        let at: Vec<Vec3> = nodes.iter().map(|&node| positions[node as usize]).collect();
        let slopes = slopes(&at);
        let samples = if fit == CurveFit::Straight { 1 } else { SAMPLES };
        for i in 0..at.len() - 1 {
            let mut last = new_of[nodes[i] as usize];
            let length = at[i].distance(at[i + 1]);
            for k in 1..=samples {
                let t = k as f32 / samples as f32;
                let s = 1.0 - t;
                let place = at[i] * (s * s * (1.0 + 2.0 * t))
                    + at[i + 1] * (t * t * (1.0 + 2.0 * s))
                    + (slopes[i] * s - slopes[i + 1] * t) * (length * s * t);
                // A lateral is as thin at its fork as at its first own node.
                let first = if i == 0 && fork.is_some() { nodes[1] } else { nodes[i] };
                let (a, b) = (radii[first as usize], radii[nodes[i + 1] as usize]);
                last = builder.add(last, place, s * a + t * b).unwrap();
            }
            new_of[nodes[i + 1] as usize] = last;
        }
    }
    builder.finish()
}

/// Derivatives by length, at its nodes, of the spline with continuous curvature and none at the ends.
/// The system is solved by Gauss and Seidel's iteration, which shares nothing with the mesher's way.
fn slopes(at: &[Vec3]) -> Vec<Vec3> {
    let segment =
        |i: usize| (at[i].distance(at[i + 1]), (at[i + 1] - at[i]) / at[i].distance(at[i + 1]));
    let last = at.len() - 1;
    let mut slopes = vec![Vec3::ZERO; at.len()];
    if last == 0 {
        return slopes;
    }
    for _ in 0..40 {
        for i in 0..=last {
            slopes[i] = match i {
                0 => 0.5 * (3.0 * segment(0).1 - slopes[1]),
                i if i == last => 0.5 * (3.0 * segment(i - 1).1 - slopes[i - 1]),
                i => {
                    let ((h0, d0), (h1, d1)) = (segment(i - 1), segment(i));
                    let known = 3.0 * (h1 * d0 + h0 * d1) - h1 * slopes[i - 1] - h0 * slopes[i + 1];
                    known / (2.0 * (h0 + h1))
                }
            };
        }
    }
    slopes
}

/// The share of the result's length in the original's axes, and the other way round.
fn there_and_back(preset: &str, fit: CurveFit) -> (f64, f64) {
    let tree = grow(preset, true);
    let made = read(&mesh_of(&tree, fit));
    let (old, new) = (drawn(tree.skeleton(), fit), made.tree.skeleton());
    let there = share_within(new, &old, 0.5, 0.0);
    let back = share_within(&old, new, 0.5, 0.002);
    println!(
        "{preset} {fit:?}: {there:.4} of ours within half a radius, {back:.4} of theirs found; \
         {} nodes, {} before; trunk {:.3} m, {:.3} before; {:?}",
        new.len(),
        tree.skeleton().len(),
        new.radii()[0],
        tree.skeleton().radii()[0],
        made.report
    );
    assert_eq!((made.report.n_pieces, made.report.n_left_out), (1, 0));
    // The flare makes the foot thicker, never thinner.
    let (foot, trunk) = (new.radii()[0], tree.skeleton().radii()[0]);
    assert!((0.9 * trunk..2.0 * trunk).contains(&foot), "trunk of {foot} m, was {trunk} m");
    assert!(new.positions()[0].length() < 0.3 * trunk, "stands at {}", new.positions()[0]);
    (there, back)
}

fn lies_in_its_own_axes(preset: &str, fit: CurveFit) {
    let (there, back) = there_and_back(preset, fit);
    assert!(there > 0.95 && back > 0.95, "{preset} {fit:?}: {there} there, {back} back");
}

#[test]
fn an_oak_meshed_and_read_back_lies_in_its_own_axes() {
    lies_in_its_own_axes("oak", CurveFit::Through);
}

#[test]
fn so_does_a_conifer() {
    lies_in_its_own_axes("e", CurveFit::Through);
    lies_in_its_own_axes("e", CurveFit::Straight);
}

#[test]
fn so_does_a_tree_of_another_form() {
    lies_in_its_own_axes("g", CurveFit::Straight);
}

#[test]
fn leaves_come_back_where_they_were() {
    let tree = grow("i", false);
    let made = read(&mesh_of(&tree, CurveFit::Through));
    let (old, new) = (tree.foliage(), made.tree.foliage());
    assert_eq!(made.report.n_leaves, old.len());
    // Cards of a kind come in the order of its leaves.
    let turned = old
        .iter()
        .zip(new.iter())
        .filter(|(old, new)| {
            let midrib = (old.rotation * Vec3::Y).dot(new.rotation * Vec3::Y) > 0.99;
            let size = (0.9..1.1).contains(&(new.size / old.size));
            midrib && size && old.position.distance(new.position) < 0.1 * old.size
        })
        .count();
    assert!(turned as f64 > 0.95 * old.len() as f64, "{turned} of {}", old.len());
}

#[test]
fn every_shared_mesh_gives_one_skeleton_of_all_its_wood() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/meshes");
    if !folder.exists() {
        println!("skipped: {} is not here", folder.display());
        return;
    }
    let mut n_read = 0;
    for folder in [folder.clone(), folder.join("quaternius"), folder.join("waterways")] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if !path.extension().is_some_and(|extension| extension == "glb" || extension == "obj") {
                continue;
            }
            let made = read(
                &io::read(&path, &ImportOptions::default(), &Control::default()).unwrap().mesh,
            );
            let skeleton = made.tree.skeleton();
            let (height, trunk) = (skeleton.bounds().size().y, skeleton.radii()[0]);
            println!("{}: {height} high, trunk of {trunk}", path.display());
            assert!(made.report.covered > 0.999, "{}: {:?}", path.display(), made.report);
            let slender = trunk / height;
            assert!((0.005..0.15).contains(&slender), "{}: {slender}", path.display());
            let base = skeleton.positions()[0].y - skeleton.bounds().min.y;
            assert!(base < 0.1 * height, "{} stands on {base}", path.display());
            n_read += 1;
        }
    }
    assert_eq!(n_read, 17);
}
