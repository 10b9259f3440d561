//! Depth maps: what the sun sees, and what the sky sees from a number of directions.
//!
//! Shadows are looked up in depth maps (Williams 1978, "Casting curved shadows on curved surfaces"),
//! filtered after the comparison (Reeves, Salesin, Cook 1987, "Rendering antialiased shadows with
//! depth maps"). Light from the sky is the mean over maps from directions spread evenly over the
//! hemisphere: real occlusion, so the inside of a crown and the ground below it lie in soft shade.

use super::camera::Projector;
use super::project::{Spot, project_all};
use super::raster::Band;
use super::scene::Scene;
use super::visibility::{Bins, Stage};
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::Control;

/// Empty texels around a map, so that filters need no border case.
const BORDER: f32 = 3.0;
/// Rows of a depth map that one thread draws at a time.
const ROWS_PER_BAND: u32 = 64;

/// Depths along a direction of light; what lies beside the map is lit.
#[derive(Debug)]
pub(super) struct DepthMap {
    /// World to texel coordinates and depth (larger is nearer to the light).
    across: Vec3,
    down: Vec3,
    toward: Vec3,
    origin: Vec3,
    width: usize,
    height: usize,
    depth: Vec<f32>,
    /// Side of a texel in metres.
    pub(super) texel: f32,
}

impl DepthMap {
    fn empty(projector: &Projector) -> Self {
        let (width, height) = (projector.width as usize, projector.height as usize);
        let across = projector.right * projector.scale;
        let down = -projector.up * projector.scale;
        let toward = -projector.forward;
        let eye = projector.eye;
        let origin = Vec3::new(
            projector.center.x - across.dot(eye),
            projector.center.y - down.dot(eye),
            -toward.dot(eye),
        );
        let depth = vec![f32::NEG_INFINITY; width * height];
        Self { across, down, toward, origin, width, height, depth, texel: 1.0 / projector.scale }
    }

    /// The map of a direction from which light comes, drawn in parallel bands.
    pub(super) fn parallel(
        scene: &Scene<'_>,
        light: Vec3,
        side: u32,
        control: &Control,
    ) -> Result<Self> {
        let projector = Projector::over(scene.vertices(), -light, side, BORDER);
        let mut spots = Vec::new();
        project_all(scene, &projector, &mut spots);
        let stage = Stage { scene, projector: &projector, spots: &spots };
        let bins = Bins::new(&stage, ROWS_PER_BAND);
        let mut map = Self::empty(&projector);
        let (width, rows) = (map.width, ROWS_PER_BAND as usize);
        map.depth.par_chunks_mut(width * rows).enumerate().try_for_each(|(number, depth)| {
            control.check()?;
            let top = (number * rows) as i32;
            let mut band = Band { top, width: width as i32, depth, ids: &mut [] };
            stage.draw_band::<false>(&bins, number, &mut band);
            Ok::<_, crate::LodError>(())
        })?;
        Ok(map)
    }

    /// Maps of many directions, each drawn by one thread.
    pub(super) fn many(
        scene: &Scene<'_>,
        lights: &[Vec3],
        side: u32,
        control: &Control,
    ) -> Result<Vec<Self>> {
        let draw = |spots: &mut Vec<Spot>, &light: &Vec3| {
            control.check()?;
            let projector = Projector::over(scene.vertices(), -light, side, BORDER);
            project_all(scene, &projector, spots);
            let mut map = Self::empty(&projector);
            let stage = Stage { scene, projector: &projector, spots };
            let width = map.width as i32;
            let mut band = Band { top: 0, width, depth: &mut map.depth, ids: &mut [] };
            stage.draw_all(&mut band);
            Ok(map)
        };
        lights.par_iter().map_init(Vec::new, draw).collect()
    }

    #[inline]
    fn place(&self, p: Vec3) -> Vec3 {
        Vec3::new(self.across.dot(p), self.down.dot(p), self.toward.dot(p)) + self.origin
    }

    /// Share of light that reaches `p`, moved `bias` metres towards the light: 0 to 1, over 2×2
    /// texels. What is hidden by less than `soft` metres is hidden in part only: leaves let light
    /// pass, and it softens the texels.
    #[inline]
    pub(super) fn light_at(&self, p: Vec3, bias: f32, soft: f32) -> f32 {
        let q = self.place(p);
        let (x, y) = (q.x - 0.5, q.y - 0.5);
        if !(x >= 0.0 && y >= 0.0 && x < (self.width - 1) as f32 && y < (self.height - 1) as f32) {
            return 1.0;
        }
        let (column, row) = (x as i32, y as i32);
        let (fx, fy) = (x - column as f32, y - row as f32);
        let at = row as usize * self.width + column as usize;
        let (Some(&[a, b]), Some(&[c, d])) = (
            self.depth.get(at..).and_then(<[f32]>::first_chunk),
            self.depth.get(at + self.width..).and_then(<[f32]>::first_chunk),
        ) else {
            return 1.0;
        };
        let (near, per_soft) = (q.z + bias + soft, 1.0 / soft);
        let [a, b, c, d] = [a, b, c, d].map(|held| ((near - held) * per_soft).clamp(0.0, 1.0));
        let (upper, lower) = (a + (b - a) * fx, c + (d - c) * fx);
        upper + (lower - upper) * fy
    }

    /// As [`light_at`](Self::light_at), over a smooth window of 4×4 texels: for the sun.
    #[inline]
    pub(super) fn smooth_light_at(&self, p: Vec3, soft: f32) -> f32 {
        let q = self.place(p);
        let (x, y) = (q.x - 1.5, q.y - 1.5);
        if !(x >= 0.0 && y >= 0.0 && x < (self.width - 3) as f32 && y < (self.height - 3) as f32) {
            return 1.0;
        }
        let (column, row) = (x as usize, y as usize);
        let (fx, fy) = (x - column as f32, y - row as f32);
        let per_soft = 1.0 / soft;
        let mut sum = 0.0;
        for (i, weight) in [1.0 - fy, 1.0, 1.0, fy].into_iter().enumerate() {
            let at = (row + i) * self.width + column;
            let Some(&[a, b, c, d]) = self.depth.get(at..).and_then(<[f32]>::first_chunk) else {
                return 1.0;
            };
            let lit = |held: f32| (1.0 - (held - q.z) * per_soft).clamp(0.0, 1.0);
            sum += weight * (lit(a) * (1.0 - fx) + lit(b) + lit(c) + lit(d) * fx);
        }
        sum * (1.0 / 9.0)
    }
}

/// `count` directions spread evenly over the upper hemisphere: a spiral of golden angles
/// (Vogel 1979), equal solid angle each.
pub(crate) fn hemisphere(count: u32) -> Vec<Vec3> {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    (0..count)
        .map(|i| {
            let y = (i as f32 + 0.5) / count as f32;
            let (sin, cos) = libm::sincosf(i as f32 * GOLDEN_ANGLE);
            let across = (1.0 - y * y).sqrt();
            Vec3::new(across * cos, y, across * sin)
        })
        .collect()
}
