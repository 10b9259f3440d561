//! Leaves onto planes.

use super::crown::Crown;
use super::plain::Lit;
use super::{Cards, PLANES, Plane, planes};
use crate::element::Elements;
use crate::error::{LodError, Result, check_range};
use crate::impostor::boxes::{Boxes, LeafBox};
use crate::impostor::texel::{Atlas, Bytes, Grid, Samples, Tile, Window, bake};
use crate::preview::{Part, Scene};
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::Mesh;

/// How leaves are projected onto planes.
#[derive(Clone, Debug, PartialEq)]
pub struct CardParams {
    /// Side of a picture in texels, gutters included, 16 to 1024. Default 64, as the paper; 128 is its other.
    pub size: u32,
    /// Samples of a texel in each direction, 1 to 8. Default 4.
    pub samples: u32,
    /// Texels around each picture that repeat what is at its edge, 1 to 8: so that filters do not mix
    /// pictures. Default 1.
    pub gutter: u32,
}

impl Default for CardParams {
    fn default() -> Self {
        Self { size: 64, samples: 4, gutter: 1 }
    }
}

impl CardParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("cards.size", self.size.into(), 16.0, 1024.0)?;
        check_range("cards.samples", self.samples.into(), 1.0, 8.0)?;
        let most = 8.0_f64.min(f64::from(self.size) / 4.0);
        check_range("cards.gutter", self.gutter.into(), 1.0, most)
    }
}

/// What was baked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct CardReport {
    /// Number of boxes.
    pub n_boxes: usize,
    /// Number of pictures.
    pub n_images: usize,
    /// Texels of all pictures.
    pub n_texels: u64,
    /// Bytes of both atlases, as they are in memory.
    pub bytes: usize,
    /// Pictures in which nothing covers half a texel.
    pub n_empty: usize,
}

impl Cards {
    /// Projects the leaves of every box onto its planes. Progress is reported in the stage `cards`.
    ///
    /// # Errors
    /// [`LodError::Parameter`], also when the atlas would be wider than 16,384 texels; what
    /// [`Elements::check`] finds; [`LodError::Impostor`] when the boxes are of another mesh;
    /// [`LodError::Limit`] over the limits of triangles or pixels (both atlases, and the samples of a
    /// picture for each thread); [`LodError::Cancelled`].
    ///
    /// # Complexity
    /// O(boxes × 6 × samples of a picture + 6 × levels × triangles), in parallel over pictures.
    pub fn bake(
        mesh: &Mesh,
        elements: &Elements,
        boxes: &Boxes,
        params: &CardParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        let n = boxes.boxes().len();
        let grid = Grid::square(n * PLANES, params.size)?;
        let texels = u64::from(grid.width) * u64::from(grid.height);
        let across = u64::from(params.size * params.samples);
        let threads = rayon::current_num_threads() as u64;
        control.limits.check(Resource::Pixels, 2 * texels + threads * across * across)?;
        let scene = Scene::new(mesh, true, control)?;
        elements.check(mesh)?;
        if boxes.order().len() != elements.len() {
            return Err(LodError::Impostor(
                "the boxes have another number of leaves than the mesh",
            ));
        }
        let mut atlas = Atlas::new(grid, control)?;
        let mut empty = 0;
        // Some boxes at a time, so that tiles do not pile up.
        for (first, chunk) in (0..).step_by(CHUNK).zip(boxes.boxes().chunks(CHUNK)) {
            control.report("cards", first as f32 / n as f32)?;
            let part =
                |leaf_box: &LeafBox| part(&scene, elements, boxes.leaves(leaf_box.leaves.clone()));
            let parts: Vec<Part> = chunk.par_iter().map(part).collect();
            let bake_plane = |buffers: &mut Samples, tile: usize| {
                control.check()?;
                let (row, plane) = (tile / PLANES, tile % PLANES);
                let face = &planes(&chunk[row])[plane];
                let tile = tile_of(&scene, &parts[row], face, params, buffers);
                Ok(tile.bytes(face.reach, scene.srgb))
            };
            let baked = (0..chunk.len() * PLANES)
                .into_par_iter()
                .map_init(Samples::default, bake_plane)
                .collect::<Result<Vec<Bytes>>>()?;
            for (row, tile) in baked.iter().enumerate() {
                atlas.put(first * PLANES + row, tile);
                empty += usize::from(tile.covered() == 0);
            }
        }
        let leaf_size = |leaf_box: &LeafBox| {
            let leaves = boxes.leaves(leaf_box.leaves.clone());
            let area: f32 = leaves.iter().map(|&leaf| elements.areas[leaf as usize]).sum();
            (area / leaves.len().max(1) as f32).sqrt()
        };
        let report = CardReport {
            n_boxes: n,
            n_images: n * PLANES,
            n_texels: (n * PLANES) as u64 * u64::from(params.size) * u64::from(params.size),
            bytes: atlas.color.pixels.len() + atlas.detail.pixels.len(),
            n_empty: empty,
        };
        control.report("cards", 1.0)?;
        Ok(Self {
            boxes: boxes.clone(),
            color: atlas.color,
            detail: atlas.detail,
            size: params.size,
            gutter: params.gutter,
            columns: grid.columns,
            report,
            crown: Crown::new(mesh, elements, &|surface| scene.drawn_share(surface as usize)),
            leaf_sizes: boxes.boxes().iter().map(leaf_size).collect(),
            lit: Lit::default(),
        })
    }
}

/// Boxes baked before they are packed.
const CHUNK: usize = 16;

/// The triangles of leaves.
fn part(scene: &Scene<'_>, elements: &Elements, leaves: &[u32]) -> Part {
    let of_leaf = |&leaf: &u32| {
        let first = scene.first_triangle[elements.surface[leaf as usize] as usize];
        elements.triangles_of(leaf as usize).iter().map(move |triangle| first + triangle)
    };
    Part::new(scene, leaves.iter().flat_map(of_leaf))
}

/// The picture of a plane.
fn tile_of(
    scene: &Scene<'_>,
    part: &Part,
    plane: &Plane,
    params: &CardParams,
    buffers: &mut Samples,
) -> Tile {
    let outer = params.size as f32 / (params.size - 2 * params.gutter) as f32;
    let window = Window {
        center: plane.center,
        right: plane.right,
        up: plane.up,
        toward: plane.normal,
        half: plane.half * outer,
    };
    let mut tile = bake(scene, part, &window, params.size, params.samples, buffers);
    tile.dilate();
    tile
}
