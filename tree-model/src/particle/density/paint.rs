//! Painting and erasing density, in a view or in space (Neubert 2012, section 3.6 and figure 3.12).

use super::super::grid::Grid;
use super::super::matte::Matte;
use crate::error::{Result, check};
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Largest coordinate and width of a stroke.
const LARGEST: f32 = 1e6;

/// A stroke over a matte.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct DensityStroke {
    /// Its course in pixels from the top left. One point makes a dot, none nothing.
    pub points: Vec<Vec2>,
    /// Width in pixels, above 0. Default 20.
    pub width: f32,
    /// What the matte becomes in its middle, 0 (erase) to 1 (opaque). Default 1.
    pub value: f32,
    /// Share of its width over which it fades, 0 (hard) to 1. Default 0.5.
    pub softness: f32,
}

impl Default for DensityStroke {
    fn default() -> Self {
        Self { points: Vec::new(), width: 20.0, value: 1.0, softness: 0.5 }
    }
}

/// A stroke of a ball through a grid.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct DensityBrush {
    /// Its course in metres. One point makes a ball, none nothing.
    pub points: Vec<Vec3>,
    /// Radius in metres, above 0. Default 0.5.
    pub radius: f32,
    /// What the grid becomes in its middle, 0 (erase) to 1e6 per metre. Default 1.
    pub value: f32,
    /// Share of its radius over which it fades, 0 (hard) to 1. Default 0.5.
    pub softness: f32,
}

impl Default for DensityBrush {
    fn default() -> Self {
        Self { points: Vec::new(), radius: 0.5, value: 1.0, softness: 0.5 }
    }
}

/// `matte` with strokes over it, one after the other. Parts outside the picture do nothing.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) or
/// [`ModelError::NotFinite`](crate::ModelError::NotFinite) naming the stroke.
///
/// # Complexity
/// O(pixels near each segment).
pub fn paint(matte: &Matte, strokes: &[DensityStroke]) -> Result<Matte> {
    for (i, stroke) in strokes.iter().enumerate() {
        let field = format!("strokes[{i}]");
        check(format!("{field}.width"), stroke.width, f32::MIN_POSITIVE, LARGEST)?;
        check(format!("{field}.value"), stroke.value, 0.0, 1.0)?;
        check(format!("{field}.softness"), stroke.softness, 0.0, 1.0)?;
        for (k, point) in stroke.points.iter().enumerate() {
            for (axis, value) in ["x", "y"].iter().zip(point.to_array()) {
                check(format!("{field}.points[{k}].{axis}"), value, -LARGEST, LARGEST)?;
            }
        }
    }
    let width = matte.width() as usize;
    let mut alpha = matte.alpha().to_vec();
    alpha.par_chunks_mut(width).enumerate().with_min_len(16).for_each(|(y, row)| {
        for stroke in strokes {
            stroke_row(stroke, y as f32 + 0.5, row);
        }
    });
    Matte::new(matte.width(), matte.height(), alpha)
}

/// What a stroke does to one row of pixels.
fn stroke_row(stroke: &DensityStroke, y: f32, row: &mut [f32]) {
    let radius = 0.5 * stroke.width;
    let mut nearest: Vec<f32> = Vec::new();
    for segment in segments(&stroke.points) {
        let [a, b] = segment;
        if y < a.y.min(b.y) - radius || y > a.y.max(b.y) + radius {
            continue;
        }
        if nearest.is_empty() {
            nearest.resize(row.len(), f32::MAX);
        }
        let first = (a.x.min(b.x) - radius).clamp(0.0, row.len() as f32) as usize;
        let last = (a.x.max(b.x) + radius).ceil().clamp(0.0, row.len() as f32) as usize;
        for (x, near) in nearest.iter_mut().enumerate().take(last).skip(first) {
            let at = Vec2::new(x as f32 + 0.5, y);
            *near = near
                .min(at.distance(closest(at.extend(0.0), a.extend(0.0), b.extend(0.0)).truncate()));
        }
    }
    for (alpha, distance) in row.iter_mut().zip(nearest) {
        *alpha += (stroke.value - *alpha) * cover(distance, radius, stroke.softness);
    }
}

/// Changes `grid` by brushes, one after the other. Parts outside it do nothing.
///
/// # Errors
/// As [`paint`].
///
/// # Complexity
/// O(voxels in the box around each brush × its points).
pub fn paint_volume(grid: &mut Grid, brushes: &[DensityBrush]) -> Result<()> {
    for (i, brush) in brushes.iter().enumerate() {
        let field = format!("brushes[{i}]");
        check(format!("{field}.radius"), brush.radius, f32::MIN_POSITIVE, LARGEST)?;
        check(format!("{field}.value"), brush.value, 0.0, LARGEST)?;
        check(format!("{field}.softness"), brush.softness, 0.0, 1.0)?;
        for (k, point) in brush.points.iter().enumerate() {
            for (axis, value) in ["x", "y", "z"].iter().zip(point.to_array()) {
                check(format!("{field}.points[{k}].{axis}"), value, -LARGEST, LARGEST)?;
            }
        }
    }
    let (corner, voxel) = (grid.corner(), grid.voxel());
    let (nx, ny) = (grid.size().x as usize, grid.size().y as usize);
    let lines = grid.values_mut().par_chunks_mut(nx).enumerate().with_min_len(16);
    lines.for_each(|(line, values)| {
        for brush in brushes {
            for (x, value) in values.iter_mut().enumerate() {
                let at = Vec3::new(x as f32, (line % ny) as f32, (line / ny) as f32) + 0.5;
                let at = corner + voxel * at;
                let distance = segments(&brush.points)
                    .map(|[a, b]| at.distance(closest(at, a, b)))
                    .fold(f32::MAX, f32::min);
                *value += (brush.value - *value) * cover(distance, brush.radius, brush.softness);
            }
        }
    });
    Ok(())
}

/// The segments of a polyline; a single point is a segment of no length.
fn segments<P: Copy>(points: &[P]) -> impl Iterator<Item = [P; 2]> + '_ {
    let dot = (points.len() == 1).then(|| [points[0], points[0]]);
    dot.into_iter().chain(points.windows(2).map(|pair| [pair[0], pair[1]]))
}

/// The point of the segment from `a` to `b` closest to `at`.
fn closest(at: Vec3, a: Vec3, b: Vec3) -> Vec3 {
    let along = b - a;
    let squared = along.length_squared();
    if squared > 0.0 { a + along * ((at - a).dot(along) / squared).clamp(0.0, 1.0) } else { a }
}

/// How much a brush covers at a distance from its course: 1 in its core, fading to 0 at its rim.
fn cover(distance: f32, radius: f32, softness: f32) -> f32 {
    let core = radius * (1.0 - softness);
    if distance >= radius {
        return 0.0;
    }
    if distance <= core {
        return 1.0;
    }
    let t = (radius - distance) / (radius - core);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec3;
    use tree_core::Limits;

    fn blank() -> Matte {
        Matte::new(40, 20, vec![0.0; 800]).unwrap()
    }

    #[test]
    fn a_stroke_covers_its_width_and_fades() {
        let points = vec![Vec2::new(10.0, 10.0), Vec2::new(30.0, 10.0)];
        let stroke = DensityStroke { points, width: 8.0, value: 0.8, softness: 0.5 };
        let painted = paint(&blank(), &[stroke]).unwrap();
        assert!((painted.at(20, 10) - 0.8).abs() < 1e-6);
        assert!(painted.at(20, 12) > 0.3 && painted.at(20, 12) < 0.8);
        assert_eq!((painted.at(20, 15), painted.at(2, 10)), (0.0, 0.0));
    }

    #[test]
    fn erasing_takes_away_what_painting_added() {
        let stroke = DensityStroke {
            points: vec![Vec2::new(5.0, 5.0)],
            softness: 0.0,
            ..Default::default()
        };
        let eraser = DensityStroke { value: 0.0, ..stroke.clone() };
        assert!(paint(&blank(), std::slice::from_ref(&stroke)).unwrap().area() > 50.0);
        assert_eq!(paint(&blank(), &[stroke, eraser]).unwrap(), blank());
    }

    #[test]
    fn bad_strokes_are_named() {
        let bad = DensityStroke { width: f32::NAN, ..Default::default() };
        assert!(paint(&blank(), &[bad]).unwrap_err().to_string().contains("strokes[0].width"));
        let bad = DensityStroke { points: vec![Vec2::NAN], ..Default::default() };
        assert!(paint(&blank(), &[bad]).is_err());
    }

    #[test]
    fn a_ball_fills_its_volume() {
        let mut grid =
            Grid::new(Vec3::splat(-2.0), 0.1, UVec3::splat(40), &Limits::default()).unwrap();
        let ball =
            DensityBrush { points: vec![Vec3::ZERO], radius: 1.0, value: 2.0, softness: 0.0 };
        paint_volume(&mut grid, &[ball]).unwrap();
        let volume = super::super::crown_volume(&grid, 1.0);
        assert!((volume - 4.18879).abs() < 0.1, "{volume}");
        let eraser =
            DensityBrush { points: vec![Vec3::ZERO], radius: 9.0, value: 0.0, softness: 0.0 };
        paint_volume(&mut grid, &[eraser]).unwrap();
        assert_eq!(super::super::crown_volume(&grid, 0.0), 0.0);
    }
}
