//! Pictures whose alpha is known: trees over made backgrounds, and their trimaps.

use super::score::{mesh, seen};
use std::error::Error;
use std::path::PathBuf;
use tree_core::{Control, Seed};
use tree_mesh::Mesh;
use tree_model::glam::Vec2;
use tree_model::particle::matting::{Level, Trimap};
use tree_model::particle::{Camera, Matte, Photo, Projection};
use tree_model::path::Preset;

/// Pixels around everything clear of the tree that a trimap leaves unknown: a broad brush.
const OUTSIDE: usize = 5;
/// Pixels inside the tree's edges that it leaves unknown.
const INSIDE: usize = 1;

/// Where the photographs of the shared data are.
pub(super) fn photo_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/photos")
}

/// What is behind a tree.
#[derive(Clone, Copy, Debug)]
pub(super) enum Behind {
    /// From deep to pale blue, with soft clouds.
    Sky,
    /// Leaves and stems, as a hedge.
    Hedge,
}

impl Behind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Sky => "sky",
            Self::Hedge => "hedge",
        }
    }

    /// Colour 0 to 255 at a pixel of a picture `height` high.
    fn color(self, at: Vec2, height: f32) -> [f32; 3] {
        match self {
            Self::Sky => {
                let down = at.y / height;
                let cloud = (2.5 * noise(at * 4.0 / height, 5) - 1.2).clamp(0.0, 1.0);
                let clear = [60.0 + 110.0 * down, 120.0 + 90.0 * down, 205.0 + 30.0 * down];
                clear.map(|c| c + cloud * (240.0 - c))
            }
            Self::Hedge => {
                let light = 0.3 + 0.9 * noise(at * 40.0 / height, 4);
                let dry = noise(at * 12.0 / height + 50.0, 2);
                [90.0 + 50.0 * dry, 105.0 - 10.0 * dry, 60.0].map(|c| c * light)
            }
        }
    }
}

/// Noise 0 to 1 that varies over a length of 1, with finer `octaves` on it.
fn noise(at: Vec2, octaves: u32) -> f32 {
    let corner = |at: Vec2| Seed(7).unit((at.x as i64 + 1_000_003 * at.y as i64) as u64);
    let (mut sum, mut weights, mut at, mut weight) = (0.0, 0.0, at, 1.0);
    for _ in 0..octaves {
        let low = at.floor();
        let part = at - low;
        let row = |y: f32| {
            let (a, b) = (corner(low + Vec2::new(0.0, y)), corner(low + Vec2::new(1.0, y)));
            a + part.x * (b - a)
        };
        let (a, b) = (row(0.0), row(1.0));
        sum += weight * (a + part.y * (b - a));
        weights += weight;
        weight *= 0.6;
        at = 2.0 * at + 17.0;
    }
    sum / weights
}

/// A cut-out photograph before a background: opaque.
pub(super) fn compose(cut_out: &Photo, behind: Behind) -> Result<Photo, Box<dyn Error>> {
    let (width, height) = (cut_out.width(), cut_out.height());
    let pixels = cut_out.pixels().iter().enumerate().map(|(i, pixel)| {
        let at = Vec2::new((i % width as usize) as f32, (i / width as usize) as f32) + 0.5;
        let back = behind.color(at, height as f32);
        let alpha = f32::from(pixel[3]) / 255.0;
        let mix = |k: usize| alpha * f32::from(pixel[k]) + (1.0 - alpha) * back[k] + 0.5;
        [mix(0) as u8, mix(1) as u8, mix(2) as u8, 255]
    });
    Ok(Photo::new(width, height, pixels.collect())?)
}

/// What a person with a brush would know of a matte: all but its edges.
pub(super) fn trimap(matte: &Matte) -> Result<Trimap, Box<dyn Error>> {
    let (width, height) = (matte.width() as usize, matte.height() as usize);
    let most = spread(matte.alpha(), width, height, OUTSIDE, f32::max);
    let least = spread(matte.alpha(), width, height, INSIDE, f32::min);
    let levels = most.iter().zip(&least).map(|(&most, &least)| match () {
        () if most < 0.01 => Level::Background,
        () if least > 0.99 => Level::Foreground,
        () => Level::Unknown,
    });
    Ok(Trimap::new(matte.width(), matte.height(), levels.collect())?)
}

/// Each value joined with all within a square around it.
fn spread(
    values: &[f32],
    width: usize,
    height: usize,
    reach: usize,
    join: fn(f32, f32) -> f32,
) -> Vec<f32> {
    let line = |values: &[f32], i: usize, at: usize, n: usize, step: usize| {
        let (low, high) = (at - at.min(reach), (n - 1 - at).min(reach));
        let first = i - (at - low) * step;
        (0..=at - low + high).map(|k| values[first + k * step]).fold(values[i], join)
    };
    let across: Vec<f32> =
        (0..values.len()).map(|i| line(values, i, i % width, width, 1)).collect();
    (0..values.len()).map(|i| line(&across, i, i / width, height, width)).collect()
}

/// A known oak in leaf.
pub(super) fn known_tree() -> Result<Mesh, Box<dyn Error>> {
    let mut preset = Preset::find("oak")?.params()?;
    preset.roots = None;
    mesh(&preset.grow(Seed(11), &Control::default())?.tree, &Control::default())
}

/// What a square picture shows of the tree, from so far round it.
pub(super) fn known_matte(mesh: &Mesh, yaw: f32, pixels: f32) -> Result<Matte, Box<dyn Error>> {
    let bounds = mesh.bounds();
    let around = bounds.min.abs().max(bounds.max.abs());
    let extent = bounds.max.y.max(2.0 * around.x.max(around.z));
    let camera = Camera {
        yaw,
        pitch: 0.0,
        projection: Projection::Orthographic,
        size: Vec2::splat(pixels),
        base: Vec2::new(0.5 * pixels, 0.97 * pixels),
        scale: 1.1 * extent / pixels,
    };
    seen(mesh, &camera, &Control::default())
}

/// A matte as a cut-out, with leaves' colours.
pub(super) fn paint(matte: &Matte) -> Result<Photo, Box<dyn Error>> {
    let (width, height) = (matte.width(), matte.height());
    let pixels = matte.alpha().iter().enumerate().map(|(i, alpha)| {
        let at = Vec2::new((i % width as usize) as f32, (i / width as usize) as f32);
        let light = 0.35 + 1.1 * noise(at / 6.0, 3);
        let [r, g, b] = [58.0, 84.0, 30.0].map(|c: f32| (c * light) as u8);
        [r, g, b, (255.0 * alpha + 0.5) as u8]
    });
    Ok(Photo::new(width, height, pixels.collect())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trimap_leaves_the_edges_unknown() {
        let alpha = (0..20 * 20).map(|i| f32::from(u8::from(i % 20 < 10)));
        let trimap = trimap(&Matte::new(20, 20, alpha.collect()).unwrap()).unwrap();
        let row = &trimap.levels()[20 * 7..][..20];
        assert!(row[..9].iter().all(|&level| level == Level::Foreground));
        assert!(row[9..15].iter().all(|&level| level == Level::Unknown));
        assert!(row[15..].iter().all(|&level| level == Level::Background));
    }
}
