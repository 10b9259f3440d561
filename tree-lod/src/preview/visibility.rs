//! Which triangle each sample sees: all triangles of a scene drawn into bands of rows, in parallel.
//!
//! 1. Triangles are dealt to the bands they touch, in chunks; a chunk keeps its own lists, so that
//!    the order within a band is the order of the mesh whatever thread did the dealing. Triangles
//!    that miss every sample are dropped here.
//! 2. Each band is drawn by one thread into buffers that stay in its cache.

use super::camera::Projector;
use super::project::{Corner, MOST_CORNERS, Spot, clip};
use super::raster::{Band, Filter, Mask, cross, draw, sample_range};
use super::scene::{Cover, Scene, texel_area};
use glam::Vec2;
use rayon::prelude::*;
use std::ops::Range;

/// Fewest triangles per parallel piece of the dealing.
const FEWEST_PER_CHUNK: usize = 8192;
/// Most pieces, so that the lists of a large mesh stay few.
const MOST_CHUNKS: usize = 256;
/// Below this many texels per sample (an area) alpha is interpolated.
const MAGNIFIED: f32 = 0.4;

/// A scene on a picture, ready to be drawn.
pub(super) struct Stage<'a> {
    pub(super) scene: &'a Scene<'a>,
    pub(super) projector: &'a Projector,
    pub(super) spots: &'a [Spot],
}

/// The triangles of each band.
pub(super) struct Bins {
    chunks: Vec<Chunk>,
}

/// The triangles of band i are `triangles[starts[i]..starts[i + 1]]`.
struct Chunk {
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl Bins {
    /// # Complexity
    /// O(triangles × bands each touches), in parallel over chunks.
    pub(super) fn new(stage: &Stage<'_>, rows_per_band: u32) -> Self {
        let n = stage.scene.n_triangles() as usize;
        let per_chunk = n.div_ceil(MOST_CHUNKS).max(FEWEST_PER_CHUNK);
        let n_bands = stage.projector.height.div_ceil(rows_per_band) as usize;
        let chunks = (0..n.div_ceil(per_chunk)).into_par_iter().map(|chunk| {
            let range = chunk * per_chunk..n.min((chunk + 1) * per_chunk);
            stage.deal(range.start as u32..range.end as u32, rows_per_band, n_bands)
        });
        Self {
            chunks: chunks.collect(),
        }
    }

    fn of_band(&self, band: usize) -> impl Iterator<Item = &[u32]> + '_ {
        self.chunks.iter().map(move |chunk| {
            &chunk.triangles[chunk.starts[band] as usize..chunk.starts[band + 1] as usize]
        })
    }
}

impl Stage<'_> {
    fn deal(&self, range: Range<u32>, rows_per_band: u32, n_bands: usize) -> Chunk {
        let mut touched: Vec<(u32, u32, u32)> = Vec::with_capacity(range.len());
        let mut starts = vec![0_u32; n_bands + 1];
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
                starts[first as usize..=last as usize]
                    .iter_mut()
                    .for_each(|n| *n += 1);
            }
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
        Chunk { starts, triangles }
    }

    #[inline]
    fn spots_of(&self, surface: usize, triangle: u32) -> [Spot; 3] {
        let base = self.scene.first_vertex[surface];
        self.scene
            .rows(surface, triangle)
            .map(|row| self.spots[base + row])
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
        let mask_for = |area: f32, uvs: [Vec2; 3]| {
            pyramid.map(|pyramid| {
                // `area` is in steps².
                let texels = texel_area(uvs, pyramid) * 65536.0 / area.max(1.0);
                let filter = if texels < MAGNIFIED {
                    Filter::Smooth
                } else if uvs
                    .iter()
                    .all(|uv| uv.min_element() >= 0.0 && uv.max_element() <= 1.0)
                {
                    Filter::Within
                } else {
                    Filter::Repeat
                };
                Mask {
                    level: pyramid.level(texels),
                    filter,
                }
            })
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
            draw([0, 1, 2].map(|i| Corner {
                spot: spots[i],
                uv: uvs[i],
            }));
        }
    }
}
