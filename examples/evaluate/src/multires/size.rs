//! Memory and bytes of the paper's tree.

use super::model::{Model, PAPER, PAPER_BRANCHES, PAPER_LEAVES, of_paper, paper_species};
use super::{Outcome, SEED, information};
use crate::table::{Aim, Row, Table};
use std::mem::size_of;
use tree_core::glam::{Quat, Vec2, Vec3};
use tree_core::{Leaf, Tree};
use tree_lod::multires::stream::{StreamParams, encode};
use tree_lod::multires::{Adt, MultiMesh};
use tree_mesh::Look;

/// Bytes of the paper's model in memory, and of its scene compressed.
const MEMORY: f64 = 4e6;
const FILES: f64 = 250e3;
/// Polygons of its tree.
const POLYGONS: f64 = 10_409.0;
/// Bytes of a level in memory.
const A_LEVEL: usize = 16;
/// Precision of the stream in metres.
const MILLIMETRE: f32 = 1e-3;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let tree = of_paper(SEED)?;
    let branches = Adt::of_skeleton(tree.skeleton()).len();
    let leaves = tree.foliage().len();
    if (branches, leaves) != (PAPER_BRANCHES, PAPER_LEAVES) {
        return Err(format!("{branches} branches and {leaves} leaves, not the paper's").into());
    }
    let model = Model::new(&tree, &Look::built_in(&paper_species())?)?;
    let cards = model.cards.as_ref().ok_or("a tree without leaves")?;
    let case = format!("tree of {branches} branches, {leaves} leaves");
    let mut row = |metric: &str, paper: Option<f64>, ours: f64, unit: &str, aim: Aim| {
        table.row(&Row { case: &case, metric, paper, peer: None, ours, unit, aim });
    };
    let triangles = model.mesh.mesh().n_triangles() as f64;
    row("triangles (paper: polygons)", Some(POLYGONS), triangles, "", Aim::None);
    let levels = of_tree(model.multires.tree()) + A_LEVEL * model.multires.n_levels();
    let mesh = of_mesh(&model.mesh);
    let pictures = cards.report().bytes;
    let all = (levels + mesh + pictures) as f64;
    row("memory of all", Some(MEMORY), all, "bytes", Aim::AtMost(MEMORY));
    row("memory, levels", None, levels as f64, "bytes", Aim::None);
    row("memory, mesh", None, mesh as f64, "bytes", Aim::None);
    row("memory, pictures", None, pictures as f64, "bytes", Aim::None);
    let params = StreamParams { precision: MILLIMETRE };
    let stream = encode(&model.multires, model.multires.n_levels(), &params)?.len();
    std::fs::create_dir_all("out/multires")?;
    cards.color.save_png("out/multires/atlas.png")?;
    let color = cards.color.to_png()?.len();
    let detail = cards.detail.to_png()?.len();
    let files = (stream + color) as f64;
    row("stream of 1 mm + PNG", Some(FILES), files, "bytes", Aim::AtMost(FILES));
    row("stream of 1 mm", None, stream as f64, "bytes", Aim::None);
    row("PNG of colours", None, color as f64, "bytes", Aim::None);
    row("PNG of normals and depths", None, detail as f64, "bytes", Aim::None);
    let text = PAPER.len() as f64;
    information(table, "its grammar as text (paper: < 1 KB)", "size", text, "bytes");
    information(table, &case, "boxes", cards.boxes().boxes().len() as f64, "");
    Ok(())
}

fn of_tree(tree: &Tree) -> usize {
    let node = size_of::<Vec3>() + size_of::<f32>() + size_of::<u32>();
    let leaf = size_of::<u32>() + size_of::<Vec3>() + size_of::<Quat>() + size_of::<f32>() + 2;
    debug_assert!(leaf <= size_of::<Leaf>());
    node * tree.skeleton().len() + leaf * tree.foliage().len()
}

fn of_mesh(mesh: &MultiMesh) -> usize {
    let vertex = 2 * size_of::<Vec3>() + size_of::<Vec2>() + size_of::<[f32; 4]>();
    let surfaces = &mesh.mesh().surfaces;
    let buffers = |surface: &tree_mesh::Surface| {
        let anchors = size_of::<Vec3>() * surface.anchors.len();
        vertex * surface.positions.len() + 4 * surface.indices.len() + anchors
    };
    surfaces.iter().map(buffers).sum::<usize>() + 4 * surfaces.len() * (mesh.n_levels() + 1)
}
