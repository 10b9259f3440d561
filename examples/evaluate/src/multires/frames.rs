//! Triangles of a frame: wood by levels and leaves by pictures, against full geometry.

use super::model::{Model, of_paper, paper_species};
use super::scene::placed;
use super::{Outcome, SEED, information, mean};
use crate::table::{Aim, Row, Table};
use tree_core::glam::{Mat4, Vec3};
use tree_lod::impostor::cards::PLANES;
use tree_lod::impostor::choose::{Choice, ChooseParams, Watcher};
use tree_lod::multires::Draw;
use tree_mesh::Look;

/// Numbers of trees in Table 1 of the paper, and its average frames per second, hybrid and full.
const TABLE_1: [(u32, f64, f64); 7] = [
    (100, 73.0, 14.3),
    (250, 64.8, 6.3),
    (500, 52.9, 2.4),
    (750, 24.9, 1.5),
    (1000, 20.6, 0.6),
    (1500, 18.6, 0.1),
    (2000, 14.9, 0.1),
];
/// Frames of a walk through the scene.
const FRAMES: u32 = 40;
/// Height of the eye in metres.
const EYE: f32 = 1.7;
/// Height of the picture in pixels, its vertical field of view in radians.
const HEIGHT: f32 = 1080.0;
const FOV: f32 = 1.0;
/// Cosine of half the angle at which trees are in the picture, and metres within which they always are.
const SEEN: f32 = 0.64;
const NEAR: f32 = 8.0;
/// Pixels of a tree's height from which on all its wood is drawn; below, in proportion to its
/// pixels.
const ALL_WOOD: f32 = 600.0;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let tree = of_paper(SEED)?;
    let model = Model::new(&tree, &Look::built_in(&paper_species())?)?;
    let full = model.mesh.mesh().n_triangles() as f64;
    for (n, hybrid_fps, full_fps) in TABLE_1 {
        let (ours, all) = walk(&model, n, full)?;
        let case = format!("walk among {n} trees");
        table.row(&Row {
            case: &case,
            metric: "triangles a frame / full",
            paper: None,
            peer: Some(all),
            ours,
            unit: "triangles",
            aim: Aim::AtMost(all),
        });
        table.row(&Row {
            case: &case,
            metric: "times fewer (paper: fps)",
            paper: Some(hybrid_fps / full_fps),
            peer: None,
            ours: all / ours,
            unit: "",
            aim: Aim::None,
        });
    }
    information(table, "walk", "triangles of a full tree", full, "triangles");
    Ok(())
}

/// Mean triangles of a frame: ours, and with full trees.
fn walk(model: &Model, n: u32, full: f64) -> Outcome<(f64, f64)> {
    let trees = placed(n);
    let cards = model.cards.as_ref().ok_or("a tree without leaves")?;
    let mut choices = vec![Choice::new(cards)?; trees.len()];
    let reach = trees.iter().map(|(_, m)| m.w_axis.truncate().length()).fold(0.0, f32::max);
    let mut draws = model.draws();
    let (mut ours, mut all) = (Vec::new(), Vec::new());
    for frame in 0..FRAMES {
        let time = 2.0 * frame as f32 / (FRAMES - 1) as f32 - 1.0;
        let eye = Vec3::new(reach * time, EYE, 0.3 * reach * time);
        let forward = Vec3::new(1.0, 0.0, 0.3).normalize();
        let (mut here, mut seen) = (0, 0.0);
        for ((_, matrix), choice) in trees.iter().zip(&mut choices) {
            let to = (matrix.w_axis.truncate() - eye).with_y(0.0);
            if to.length() > NEAR && to.normalize().dot(forward) < SEEN {
                continue;
            }
            here += hybrid_triangles(model, choice, &watcher(matrix, eye), &mut draws)?;
            seen += full;
        }
        ours.push(here as f64);
        all.push(seen);
    }
    Ok((mean(&ours), mean(&all)))
}

fn watcher(matrix: &Mat4, eye: Vec3) -> Watcher {
    let pixels = 0.5 * HEIGHT / libm::tanf(0.5 * FOV);
    // In the space of the tree lengths are those of the tree: its scale cancels out.
    Watcher { eye: matrix.inverse().transform_point3(eye), pixels_per_metre: pixels }
}

/// Triangles of one tree: levels of wood, planes of the chosen boxes, leaves of the opened ones.
pub(super) fn hybrid_triangles(
    model: &Model,
    choice: &mut Choice,
    watcher: &Watcher,
    draws: &mut [Draw],
) -> Outcome<u64> {
    let cards = model.cards.as_ref().ok_or("a tree without leaves")?;
    choice.update(cards.boxes(), watcher, &ChooseParams::default())?;
    let bounds = model.bounds;
    let distance = watcher.eye.distance(watcher.eye.clamp(bounds.min, bounds.max)).max(0.1);
    let pixels = bounds.size().y * watcher.pixels_per_metre / distance;
    let all = model.wood_triangles(model.mesh.n_levels(), draws)?;
    let share = (pixels / ALL_WOOD).min(1.0);
    let budget = share * share * all as f32;
    let wood = model.wood_triangles(model.mesh.level_of_wood(budget as u64), draws)?;
    let leaves = &model.mesh.mesh().surfaces[1..];
    let per_leaf = leaves.iter().map(|s| s.n_triangles()).sum::<usize>()
        / model.multires.tree().foliage().len().max(1);
    let planes = 2 * PLANES * choice.boxes.len();
    Ok(wood + (per_leaf * choice.n_leaves() + planes) as u64)
}
