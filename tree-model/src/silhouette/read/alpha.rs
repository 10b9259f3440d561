//! Outlines from pictures: a matte, the alpha of a photograph, or a mask in black and white.

use super::cells::Grid;
use super::whole::Silhouette;
use super::{OutlineDrawing, TreeStrokes};
use crate::error::{ModelError, Result, check};
use crate::particle::{Matte, Photo, matting};
use glam::Vec2;

/// Trunk and crown of the tree that a matte shows, in pixels, y down. Pixels covered to `threshold` or more
/// belong to it, 0.01 to 1; 0.5 is usual. Details finer than about 1/200 of the tree are smoothed away, and the gaps
/// of a frayed crown closed, so that its outline is one that can be drawn: at most 400 points.
///
/// # Errors
/// [`ModelError::Silhouette`] where nothing is covered; [`ModelError::Parameter`] for the threshold.
///
/// # Complexity
/// O(pixels), and some tens of milliseconds.
pub fn from_mask(matte: &Matte, threshold: f32) -> Result<OutlineDrawing> {
    check("threshold", threshold, 0.01_f32, 1.0_f32)?;
    let refuse =
        |problem: &str| ModelError::Silhouette { what: "picture".into(), problem: problem.into() };
    let (low, high) = extent(matte, threshold).ok_or_else(|| {
        refuse("no pixel reaches the threshold; lower it, or give a matte of a tree")
    })?;
    let grid = Grid::over(low, high, 1.0).ok_or_else(|| refuse("it has no size"))?;
    let scale = 0.5 / threshold;
    // Values at the threshold come to a half, as the cells have it.
    let cover =
        (0..grid.nx * grid.ny).map(|at| (scale * mean(matte, &grid, at)).min(1.0)).collect();
    let silhouette = Silhouette { grid, cover, wood: Vec::new(), frayed: true };
    let mut drawing = OutlineDrawing::default();
    let tree: TreeStrokes = silhouette.strokes("", 0.0, &mut drawing.repairs)?;
    drawing.trees.push(tree);
    Ok(drawing)
}

/// Trunk and crown of the tree of a photograph that has been cut out, or of a mask in black and white: see
/// [`matte_of`] and [`from_mask`], which is asked for a half.
///
/// # Errors
/// As [`from_mask`].
pub fn from_photo(photo: &Photo) -> Result<OutlineDrawing> {
    from_mask(&matte_of(photo)?, 0.5)
}

/// The matte of a picture of one tree: its alpha where it has one; else how dark it is, for a tree on a light
/// border, or how light, for one on a dark border.
///
/// # Errors
/// [`ModelError::Picture`] where it is transparent everywhere.
///
/// # Complexity
/// O(pixels).
pub fn matte_of(photo: &Photo) -> Result<Matte> {
    if photo.has_alpha() {
        return matting::alpha_of(photo);
    }
    let (nx, ny) = (photo.width() as usize, photo.height() as usize);
    let light = |pixel: &[u8; 4]| {
        pixel[..3].iter().map(|&channel| f32::from(channel)).sum::<f32>() / (3.0 * 255.0)
    };
    let at_border = |at: usize| {
        let (x, y) = (at % nx, at / nx);
        x == 0 || y == 0 || x + 1 == nx || y + 1 == ny
    };
    let (mut sum, mut n) = (0.0_f64, 0_u32);
    for (at, pixel) in photo.pixels().iter().enumerate() {
        if at_border(at) {
            sum += f64::from(light(pixel));
            n += 1;
        }
    }
    let bright = sum > 0.5 * f64::from(n);
    let alpha = photo.pixels().iter().map(|p| if bright { 1.0 - light(p) } else { light(p) });
    Matte::new(photo.width(), photo.height(), alpha.collect())
}

/// The rectangle of the pixels that reach a threshold.
fn extent(matte: &Matte, threshold: f32) -> Option<(Vec2, Vec2)> {
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for (y, row) in matte.alpha().chunks_exact(matte.width() as usize).enumerate() {
        let Some(first) = row.iter().position(|&alpha| alpha >= threshold) else { continue };
        let last = row.iter().rposition(|&alpha| alpha >= threshold).unwrap_or(first);
        low = low.min(Vec2::new(first as f32, y as f32));
        high = high.max(Vec2::new(last as f32 + 1.0, y as f32 + 1.0));
    }
    (low.x < high.x).then_some((low, high))
}

/// The mean of a matte over a cell.
fn mean(matte: &Matte, grid: &Grid, at: usize) -> f32 {
    let corner = Vec2::new((at % grid.nx) as f32, (at / grid.nx) as f32);
    let n = (grid.cell.ceil() as usize).max(1);
    let step = 1.0 / n as f32;
    let mut sum = 0.0;
    for i in 0..n * n {
        let part = Vec2::new((i % n) as f32 + 0.5, (i / n) as f32 + 0.5) * step;
        sum += matte.sample(grid.to_drawing(corner + part));
    }
    sum / (n * n) as f32
}
