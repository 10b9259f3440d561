//! Pictures to look at: levels at the distances they are meant for, and metrics side by side.

use super::orders;
use super::parts::Parts;
use super::trees::Case;
use super::{Outcome, information};
use crate::table::Table;
use std::path::Path;
use tree_core::Control;
use tree_lod::multires::{Adt, Metric, MultiMesh, Multires};
use tree_lod::preview::{Backdrop, Camera, Framing, Picture, Style, View, render};
use tree_mesh::{Look, Mesh, MeshParams};

/// Where pictures go.
pub(super) const OUT: &str = "out/multires";
/// Pixels of a tree at four distances, the nearest first.
const SIZES: [u32; 4] = [480, 240, 120, 60];
/// Trees of which pictures are made.
const SHOWN: [&str; 4] = ["oak", "birch", "aono-kunii-a", "cherry, scanned"];
/// Branches that are drawn to compare metrics, as a share.
const FEW: f64 = 0.1;

pub(super) fn evaluate(table: &mut Table, trees: &[Case]) -> Outcome {
    std::fs::create_dir_all(OUT)?;
    let shown: Vec<_> = trees.iter().filter(|case| SHOWN.contains(&case.name.as_str())).collect();
    for case in &shown {
        let name = case.name.replace([',', ' '], "_");
        distances(case, &name)?;
        metrics(case, &name)?;
    }
    information(table, &format!("pictures in {OUT}"), "trees", shown.len() as f64, "");
    Ok(())
}

/// Full trees above, below levels with triangles in proportion to the size on the screen.
fn distances(case: &Case, name: &str) -> Outcome {
    let control = Control::default();
    let multires = Multires::new(&case.tree, &Metric::default(), &control)?;
    let look = Look::built_in(case.tree.species())?;
    let mesh = MultiMesh::new(&multires, &look, &MeshParams::default(), &control)?;
    let all = mesh.mesh().surfaces.first().map_or(0, tree_mesh::Surface::n_triangles) as u64;
    let (mut full, mut levels) = (Vec::new(), Vec::new());
    for size in SIZES {
        let level = mesh.level_of_wood(all * u64::from(size) / u64::from(SIZES[0]));
        full.push(tree(mesh.mesh(), mesh.mesh(), size)?);
        levels.push(tree(&mesh.mesh_at(level as f32)?, mesh.mesh(), size)?);
    }
    let sheet = below(&beside(&full), &beside(&levels));
    Ok(sheet.save_png(Path::new(OUT).join(format!("{name}_distances.png")))?)
}

/// The wood of a tenth of the branches, by each order; the whole tree first.
fn metrics(case: &Case, name: &str) -> Outcome {
    let adt = Adt::of_skeleton(case.tree.skeleton());
    let parts = Parts::wood(&case.tree, &adt)?;
    let mut row = vec![tree(&parts.mesh, &parts.mesh, SIZES[1])?];
    let n = ((FEW * adt.len() as f64) as usize).max(1);
    for order in orders::all(&adt, None)? {
        row.push(tree(&parts.of(&order.branches[..n]), &parts.mesh, SIZES[1])?);
    }
    let half = row.len().div_ceil(2);
    let sheet = below(&beside(&row[..half]), &beside(&row[half..]));
    Ok(sheet.save_png(Path::new(OUT).join(format!("{name}_metrics.png")))?)
}

fn tree(mesh: &Mesh, framed: &Mesh, size: u32) -> Outcome<Picture> {
    let camera = Camera::Framed(Framing { yaw: 0.5, pitch: 0.1, ..Framing::default() });
    let camera = Camera::Placed(camera.pose(framed, 1.0)?);
    let view = View { width: size, height: size, samples: 2, camera };
    let style = Style { ground: None, backdrop: Backdrop::Studio, ..Style::default() };
    Ok(render(mesh, &view, &style, &Control::default())?)
}

/// Pictures in a row, on white.
pub(super) fn beside(pictures: &[Picture]) -> Picture {
    let height = pictures.iter().map(|p| p.height).max().unwrap_or(0);
    let width = pictures.iter().map(|p| p.width).sum();
    let mut sheet = blank(width, height);
    let mut left = 0;
    for picture in pictures {
        paste(&mut sheet, picture, left, (height - picture.height) / 2);
        left += picture.width;
    }
    sheet
}

pub(super) fn below(top: &Picture, bottom: &Picture) -> Picture {
    let mut sheet = blank(top.width.max(bottom.width), top.height + bottom.height);
    paste(&mut sheet, top, 0, 0);
    paste(&mut sheet, bottom, 0, top.height);
    sheet
}

fn blank(width: u32, height: u32) -> Picture {
    Picture { width, height, pixels: vec![255; 4 * width as usize * height as usize] }
}

fn paste(sheet: &mut Picture, picture: &Picture, left: u32, top: u32) {
    let row = 4 * picture.width as usize;
    for y in 0..picture.height as usize {
        let to = 4 * ((top as usize + y) * sheet.width as usize + left as usize);
        sheet.pixels[to..to + row].copy_from_slice(&picture.pixels[y * row..(y + 1) * row]);
    }
}
