//! Which triangle each sample sees: all triangles of a scene drawn into bands of rows, in parallel.
//!
//! 1. Triangles are dealt to the bands they touch, in chunks; a chunk keeps its own lists, so that
//!    the order within a band is the order of the mesh whatever thread did the dealing. Triangles
//!    that miss every sample are dropped here. A chunk whose triangles touch so many bands that its
//!    lists would pass [`ENTRIES_PER_TRIANGLE`] keeps one list for 2, 4, 8, ... bands together;
//!    drawing passes over what misses the band at hand, so the samples are the same.
//! 2. Each band is drawn by one thread into buffers that stay in its cache.

use super::camera::Projector;
use super::project::{Corner, MOST_CORNERS, Spot, clip};
use super::raster::{Band, cross, draw, sample_range};
use super::scene::{Cover, Scene};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::ops::Range;

/// Fewest triangles per parallel piece of the dealing.
const FEWEST_PER_CHUNK: usize = 8192;
/// Most pieces, so that the lists of a large mesh stay few.
const MOST_CHUNKS: usize = 256;
/// Most list entries of a chunk, per triangle of a full chunk. Trees have 1 to 2; more happens where
/// the camera stands between the leaves. Memory is bounded by it whatever the camera sees.
const ENTRIES_PER_TRIANGLE: usize = 8;

/// A scene on a picture, ready to be drawn.
pub(crate) struct Stage<'a> {
    pub(crate) scene: &'a Scene<'a>,
    pub(crate) projector: &'a Projector,
    /// Empty where only lists are drawn.
    pub(crate) spots: &'a [Spot],
}

/// Triangles of a scene that many small pictures are taken of, and the vertices they need.
#[derive(Debug, Default)]
pub(crate) struct Part {
    triangles: Vec<u32>,
    corners: Vec<[u32; 3]>,
    positions: Vec<Vec3>,
}

impl Part {
    /// Of some triangles, by their numbers in the scene. Those that are never drawn are left out.
    ///
    /// # Complexity
    /// O(triangles + vertices of the scene).
    pub(crate) fn new(scene: &Scene<'_>, triangles: impl Iterator<Item = u32>) -> Self {
        let mut now = vec![u32::MAX; scene.n_vertices()];
        let mut part = Self::default();
        let mut surface = 0;
        for triangle in triangles {
            surface = scene.surface_of(triangle, surface);
            if scene.skin(surface).cover == Cover::None {
                continue;
            }
            let (first, positions) =
                (scene.first_vertex[surface], &scene.surface(surface).positions);
            part.corners.push(scene.rows(surface, triangle).map(|row| {
                let now = &mut now[first + row];
                if *now == u32::MAX {
                    *now = part.positions.len() as u32;
                    part.positions.push(positions[row]);
                }
                *now
            }));
            part.triangles.push(triangle);
        }
        part
    }

    pub(crate) fn len(&self) -> usize {
        self.triangles.len()
    }
}

/// The triangles of each band.
pub(super) struct Bins {
    chunks: Vec<Chunk>,
}

/// The triangles of band i are `triangles[starts[j]..starts[j + 1]]` with `j = i >> shift`, and maybe
/// others that miss it.
struct Chunk {
    shift: u32,
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl Bins {
    /// # Complexity
    /// O(triangles × bands each touches), in parallel over chunks. Memory: 4 bytes per entry, at most
    /// [`ENTRIES_PER_TRIANGLE`] for each triangle (no fewer than [`FEWEST_PER_CHUNK`]), and 4 per band
    /// and chunk; while a chunk is dealt, 12 per triangle of it.
    pub(super) fn new(stage: &Stage<'_>, rows_per_band: u32) -> Self {
        let n = stage.scene.n_triangles() as usize;
        let per_chunk = n.div_ceil(MOST_CHUNKS).max(FEWEST_PER_CHUNK);
        let n_bands = stage.projector.height.div_ceil(rows_per_band) as usize;
        let chunks = (0..n.div_ceil(per_chunk)).into_par_iter().map(|chunk| {
            let range = chunk * per_chunk..n.min((chunk + 1) * per_chunk);
            let range = range.start as u32..range.end as u32;
            stage.deal(range, rows_per_band, n_bands, per_chunk * ENTRIES_PER_TRIANGLE)
        });
        Self { chunks: chunks.collect() }
    }

    fn of_band(&self, band: usize) -> impl Iterator<Item = &[u32]> + '_ {
        self.chunks.iter().map(move |chunk| {
            let list = band >> chunk.shift;
            &chunk.triangles[chunk.starts[list] as usize..chunk.starts[list + 1] as usize]
        })
    }
}

impl Stage<'_> {
    /// `most` entries must be enough for each triangle to have one.
    fn deal(&self, range: Range<u32>, rows_per_band: u32, n_bands: usize, most: usize) -> Chunk {
        let mut touched: Vec<(u32, u32, u32)> = Vec::with_capacity(range.len());
        let mut n_entries = 0_u64;
        let mut surface = 0;
        for triangle in range {
            surface = self.scene.surface_of(triangle, surface);
            if self.scene.skin(surface).cover == Cover::None {
                continue;
            }
            let spots = self.spots_of(surface, triangle);
            let rows = if spots.iter().any(Spot::is_outside) {
                let (corners, count) = self.clipped(surface, triangle);
                self.rows_of(corners[..count].iter().map(|corner| corner.spot))
            } else {
                self.rows_of(spots.into_iter())
            };
            if let Some((top, bottom)) = rows {
                let (first, last) = (top / rows_per_band, bottom / rows_per_band);
                touched.push((triangle, first, last));
                n_entries += u64::from(last - first) + 1;
            }
        }
        let mut shift = 0;
        // Ends at the latest with all bands in one list.
        while n_entries > most as u64 && n_bands >> shift > 0 {
            shift += 1;
            n_entries =
                touched.iter().map(|&(_, a, b)| u64::from((b >> shift) - (a >> shift)) + 1).sum();
        }
        if shift > 0 {
            touched.iter_mut().for_each(|(_, a, b)| (*a, *b) = (*a >> shift, *b >> shift));
        }
        let mut starts = vec![0_u32; n_bands.div_ceil(1 << shift) + 1];
        for &(_, first, last) in &touched {
            starts[first as usize..=last as usize].iter_mut().for_each(|n| *n += 1);
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += std::mem::replace(start, sum);
        }
        let mut next = starts.clone();
        let mut triangles = vec![0; sum as usize];
        for (triangle, first, last) in touched {
            for next in &mut next[first as usize..=last as usize] {
                triangles[*next as usize] = triangle;
                *next += 1;
            }
        }
        Chunk { shift, starts, triangles }
    }

    #[inline]
    fn spots_of(&self, surface: usize, triangle: u32) -> [Spot; 3] {
        let base = self.scene.first_vertex[surface];
        self.scene.rows(surface, triangle).map(|row| self.spots[base + row])
    }

    fn clipped(&self, surface: usize, triangle: u32) -> ([Corner; MOST_CORNERS], usize) {
        let rows = self.scene.rows(surface, triangle);
        let surface = self.scene.surface(surface);
        clip(
            rows.map(|row| surface.positions[row]),
            rows.map(|row| surface.uvs[row]),
            self.projector,
        )
    }

    /// First and last row in which the corners' box holds a sample of the picture.
    #[inline]
    fn rows_of(&self, spots: impl Iterator<Item = Spot>) -> Option<(u32, u32)> {
        let (mut left, mut right, mut top, mut bottom) = (i32::MAX, i32::MIN, i32::MAX, i32::MIN);
        for spot in spots {
            (left, right) = (left.min(spot.x), right.max(spot.x));
            (top, bottom) = (top.min(spot.y), bottom.max(spot.y));
        }
        if left > right {
            return None;
        }
        let ((left, right), (top, bottom)) = (sample_range(left, right), sample_range(top, bottom));
        let (width, height) = (self.projector.width as i32, self.projector.height as i32);
        let (top, bottom) = (top.max(0), bottom.min(height - 1));
        (left <= right && right >= 0 && left < width && top <= bottom)
            .then_some((top as u32, bottom as u32))
    }

    /// Draws what touches band number `number`.
    pub(super) fn draw_band<const IDS: bool>(
        &self,
        bins: &Bins,
        number: usize,
        band: &mut Band<'_>,
    ) {
        let mut surface = 0;
        for triangles in bins.of_band(number) {
            for &triangle in triangles {
                surface = self.scene.surface_of(triangle, surface);
                self.draw_one::<IDS>(band, surface, triangle, self.spots_of(surface, triangle));
            }
        }
    }

    /// Draws all triangles into one band, which must hold the whole picture.
    pub(super) fn draw_all(&self, band: &mut Band<'_>) {
        for surface in 0..self.scene.mesh.surfaces.len() {
            if self.scene.skin(surface).cover == Cover::None {
                continue;
            }
            for triangle in
                self.scene.first_triangle[surface]..self.scene.first_triangle[surface + 1]
            {
                let spots = self.spots_of(surface, triangle);
                if spots.iter().any(Spot::is_outside) || self.rows_of(spots.into_iter()).is_some() {
                    self.draw_one::<false>(band, surface, triangle, spots);
                }
            }
        }
    }

    /// Draws a part of the mesh, and the numbers of its triangles, into a band that holds the whole picture.
    /// `spots` is room for its vertices.
    pub(crate) fn draw_part(&self, part: &Part, spots: &mut Vec<Spot>, band: &mut Band<'_>) {
        spots.clear();
        spots.extend(part.positions.iter().map(|&p| self.projector.spot(self.projector.view(p))));
        let mut surface = 0;
        for (&triangle, corners) in part.triangles.iter().zip(&part.corners) {
            let spots = corners.map(|corner| spots[corner as usize]);
            if spots.iter().any(Spot::is_outside) || self.rows_of(spots.into_iter()).is_some() {
                surface = self.scene.surface_of(triangle, surface);
                self.draw_one::<true>(band, surface, triangle, spots);
            }
        }
    }

    #[inline]
    fn draw_one<const IDS: bool>(
        &self,
        band: &mut Band<'_>,
        surface: usize,
        triangle: u32,
        spots: [Spot; 3],
    ) {
        let skin = self.scene.skin(surface);
        let pyramid = match skin.cover {
            Cover::All => None,
            Cover::None => return,
            Cover::Masked => self.scene.pyramid(skin),
        };
        let uvs = match pyramid {
            Some(_) => {
                let rows = self.scene.rows(surface, triangle);
                let surface = self.scene.surface(surface);
                rows.map(|row| surface.uvs[row])
            }
            None => [Vec2::ZERO; 3],
        };
        // `area` is in steps².
        let mask_for = |area: f32, uvs: [Vec2; 3]| {
            pyramid.map(|pyramid| pyramid.mask(area.max(1.0) / 65536.0, uvs))
        };
        let mut draw = |corners: [Corner; 3]| {
            let area = cross(&corners[0], &corners[1], &corners[2]).unsigned_abs() as f32;
            let mask = mask_for(area, corners.map(|corner| corner.uv));
            if self.projector.perspective {
                draw::<IDS, true>(band, corners, triangle, mask);
            } else {
                draw::<IDS, false>(band, corners, triangle, mask);
            }
        };
        if spots.iter().any(Spot::is_outside) {
            let (corners, count) = self.clipped(surface, triangle);
            for i in 2..count {
                draw([corners[0], corners[i - 1], corners[i]]);
            }
        } else {
            draw([0, 1, 2].map(|i| Corner { spot: spots[i], uv: uvs[i] }));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::project::project_all;
    use super::super::tests::{mesh, square, surface};
    use super::*;
    use tree_core::Control;
    use tree_mesh::{Material, Mesh};

    /// One row per band, and the depths that bands and the whole picture give.
    fn bins_and_depths(mesh: &Mesh, side: u32) -> (Bins, Vec<f32>, Vec<f32>) {
        let scene = Scene::new(mesh, false, &Control::default()).unwrap();
        let projector = Projector::over(scene.vertices(), Vec3::NEG_Z, side, 2.0);
        let mut spots = Vec::new();
        project_all(&scene, &projector, &mut spots);
        let stage = Stage { scene: &scene, projector: &projector, spots: &spots };
        let bins = Bins::new(&stage, 1);
        let (width, height) = (projector.width as usize, projector.height as usize);
        let mut all = vec![f32::NEG_INFINITY; width * height];
        let mut banded = all.clone();
        stage.draw_all(&mut Band { top: 0, width: width as i32, depth: &mut all, ids: &mut [] });
        for (row, depth) in banded.chunks_mut(width).enumerate() {
            let mut band = Band { top: row as i32, width: width as i32, depth, ids: &mut [] };
            stage.draw_band::<false>(&bins, row, &mut band);
        }
        (bins, all, banded)
    }

    #[test]
    fn triangles_over_the_whole_picture_share_lists_and_draw_the_same() {
        let mut surfaces: Vec<_> = (0..5000).map(|i| square(-1e-3 * i as f32, 0)).collect();
        let small = [Vec3::new(0.3, 0.2, 1.0), Vec3::new(0.4, 0.2, 1.5), Vec3::new(0.3, 0.3, 1.0)];
        surfaces.push(surface(&small, &[0, 1, 2], Vec3::Z, 0));
        let (bins, all, banded) = bins_and_depths(&mesh(surfaces, vec![Material::default()]), 100);
        for chunk in &bins.chunks {
            assert!(chunk.triangles.len() <= ENTRIES_PER_TRIANGLE * FEWEST_PER_CHUNK);
        }
        assert!(bins.chunks[0].shift > 0, "100 bands times 8192 triangles do not fit");
        for band in 20..80 {
            assert!(bins.of_band(band).flatten().is_sorted());
            assert!(bins.of_band(band).flatten().count() >= 5000);
        }
        assert_eq!(all, banded);
    }

    #[test]
    fn few_triangles_keep_a_list_per_band() {
        let (bins, all, banded) =
            bins_and_depths(&mesh(vec![square(0.0, 0)], vec![Material::default()]), 300);
        assert_eq!(bins.chunks[0].shift, 0);
        assert_eq!(all, banded);
    }
}
