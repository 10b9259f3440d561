//! Hybrid models against full ones at four distances: triangles, outlines, colours, pictures.

use super::impostors::imported;
use super::pictures::{OUT, below, beside};
use super::{Outcome, SEED};
use crate::table::{Aim, Row, Table};
use std::path::Path;
use tree_core::glam::Vec3;
use tree_core::{Control, Skeleton, Tree};
use tree_lod::hybrid::{Hybrid, HybridParams};
use tree_lod::impostor::boxes::{Bearers, BoxParams, Boxes};
use tree_lod::impostor::cards::{CardParams, Cards};
use tree_lod::preview::{Backdrop, Camera, Framing, Picture, Style, View, mask, render};
use tree_lod::quality::Score;
use tree_lod::{Elements, Grain, LeafSurfaces};
use tree_mesh::{Look, Mesh, MeshParams, Surface, build};
use tree_model::lsystem::LSystem;
use tree_model::path;

/// Pixels of a tree's height at four distances.
const HEIGHTS: [f32; 4] = [1000.0, 250.0, 100.0, 40.0];
/// Widest picture that is drawn of a tree, in pixels.
const WIDEST: f32 = 500.0;
/// Leafy trees of L-systems, and a pine of least-cost paths.
const SYSTEMS: [&str; 6] = ["oak", "birch", "spruce", "willow", "palm", "fern"];
const PINE: &str = "e";
/// Of these, pictures are made.
const SHOWN: [&str; 2] = ["birch", "pine"];
/// Other people's oak. It has no branches to put boxes along: one box is the crown.
const IMPORTED: &str = "eztree_oak_medium";
/// Below this height the crown of an imported tree is planes.
const PLANES_BELOW: f32 = 200.0;
/// Directions it is looked at from, around and from a little above.
const AROUND: u8 = 2;
const PITCHES: [f32; 2] = [0.05, 0.4];
/// Samples of a pixel in each direction.
const SAMPLES: u32 = 2;
/// Coverage of a pixel, of 255, from which on its colour counts.
const COVERED: u8 = 200;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    for name in SYSTEMS {
        let tree = LSystem::preset(name)?.grow(SEED, &Control::default())?.tree;
        of_tree(table, name, &tree)?;
    }
    let pine = path::Preset::find(PINE)?.params()?.grow(SEED, &Control::default())?.tree;
    of_tree(table, "pine", &pine)?;
    match imported(IMPORTED)? {
        Some(mesh) => of_mesh(table, IMPORTED, &mesh),
        None => Ok(()),
    }
}

fn of_tree(table: &mut Table, name: &str, tree: &Tree) -> Outcome {
    let control = Control::default();
    let look = Look::built_in(tree.species())?;
    let hybrid = Hybrid::make(tree, &look, &HybridParams::default(), &control)?;
    let full = build(tree, &look, &MeshParams::default(), &control)?.mesh;
    let n_full = full.n_triangles() as f64;
    let mut levels = Vec::new();
    let mut before = f64::MAX;
    for height in HEIGHTS {
        let choice = hybrid.choice_for_height(height)?;
        let mesh = hybrid.mesh_of(&choice)?;
        // With shaders, and as a plain mesh: the larger of both.
        let n = (hybrid.n_triangles(&choice) as f64).max(mesh.n_triangles() as f64);
        let case = format!("hybrid of {name}, {height} px high");
        table.row(&Row {
            case: &case,
            metric: "triangles (peer: full)",
            paper: None,
            peer: Some(n_full),
            ours: n,
            unit: "",
            aim: Aim::AtMost(n_full.min(before)),
        });
        before = n;
        levels.push(mesh);
    }
    compare(table, name, &full, &levels)
}

/// Leaves near, planes of one box from afar; the wood as it is.
fn of_mesh(table: &mut Table, name: &str, mesh: &Mesh) -> Outcome {
    let control = Control::default();
    let elements = Elements::of_mesh(mesh, &LeafSurfaces::Found, Grain::Leaf, &control)?;
    let mut trunk = Skeleton::builder(Vec3::ZERO, 0.1)?;
    trunk.add(0, Vec3::Y * mesh.bounds().max.y.max(0.1), 0.1)?;
    let bearers = Bearers(vec![1; elements.len()]);
    let params = BoxParams { levels: 0, ..BoxParams::default() };
    let boxes = Boxes::along(&trunk.finish(), mesh, &elements, &bearers, &params, &control)?;
    let cards = Cards::bake(mesh, &elements, &boxes, &CardParams::default(), &control)?;
    let mut far = mesh.clone();
    for &surface in &elements.surfaces {
        let surface = &mut far.surfaces[surface as usize];
        *surface = Surface { material: surface.material, ..Surface::default() };
    }
    far.surfaces.retain(|surface| !surface.positions.is_empty());
    let plain = cards.plain(&[0])?;
    let first = far.materials.len() as u32;
    far.materials.extend(plain.materials);
    far.surfaces
        .extend(plain.surfaces.into_iter().map(|s| Surface { material: s.material + first, ..s }));
    let levels =
        HEIGHTS.map(|height| if height < PLANES_BELOW { far.clone() } else { mesh.clone() });
    compare(table, name, mesh, &levels)
}

/// Outlines and colours from some sides, and pictures from the first.
fn compare(table: &mut Table, name: &str, full: &Mesh, levels: &[Mesh]) -> Outcome {
    let (mut above, mut under) = (Vec::new(), Vec::new());
    for (&height, ours) in HEIGHTS.iter().zip(levels) {
        let side = height.min(WIDEST) as u32;
        let (mut quality, mut light, mut n) = (0.0, [0.0; 2], 0.0);
        for yaw in 0..AROUND {
            for pitch in PITCHES {
                let yaw = 0.3 + std::f32::consts::TAU * f32::from(yaw) / f32::from(AROUND);
                let camera = Camera::Framed(Framing { yaw, pitch, ..Framing::default() });
                let camera = Camera::Placed(camera.pose(full, 1.0)?);
                let view = View { width: side, height: side, samples: SAMPLES, camera };
                let (theirs, mine) = (seen(full, &view)?, seen(ours, &view)?);
                quality += score(&mine, &theirs);
                light[0] += theirs.light();
                light[1] += mine.light();
                n += 1.0;
                if above.len() == under.len() && n == 1.0 {
                    above.push(theirs.picture);
                    under.push(mine.picture);
                }
            }
        }
        let case = format!("hybrid of {name}, {height} px high");
        let mut row = |metric, peer, ours, unit| {
            table.row(&Row { case: &case, metric, paper: None, peer, ours, unit, aim: Aim::None });
        };
        row("Q of its outline", None, quality / n, "");
        row("green of its picture (full)", Some(light[0] / n), light[1] / n, "of 255");
    }
    if SHOWN.contains(&name) || name == IMPORTED {
        let sheet = below(&beside(&above), &beside(&under));
        sheet.save_png(Path::new(OUT).join(format!("hybrid_{name}.png")))?;
    }
    Ok(())
}

/// What a camera sees of a mesh.
struct Seen {
    picture: Picture,
    mask: tree_lod::preview::Mask,
}

impl Seen {
    /// Mean green of what is covered.
    fn light(&self) -> f64 {
        let texels = self.picture.pixels.chunks_exact(4).zip(&self.mask.coverage);
        let green: Vec<f64> = texels
            .filter(|&(_, &covered)| covered > COVERED)
            .map(|(texel, _)| f64::from(texel[1]))
            .collect();
        super::mean(&green)
    }
}

fn seen(mesh: &Mesh, view: &View) -> Outcome<Seen> {
    let style = Style { ground: None, backdrop: Backdrop::Studio, ..Style::default() };
    let control = Control::default();
    let picture = render(mesh, view, &style, &control)?;
    Ok(Seen { picture, mask: mask(mesh, view, &control)? })
}

fn score(ours: &Seen, full: &Seen) -> f64 {
    let mut score = Score::default();
    for (a, b) in ours.mask.bits().zip(full.mask.bits()) {
        score.both += u64::from(a && b);
        score.wrong += u64::from(a && !b);
        score.missed += u64::from(!a && b);
    }
    score.quality()
}
