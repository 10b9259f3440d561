//! The trunk below the crown, as far as the matte shows it.

use super::plane::Plane;

/// A pixel counts as wood or leaf from this alpha on.
const SOLID: f32 = 0.5;

/// Rows above the base whose width counts as that of the trunk, as a share of the picture's height.
const FOOT: f32 = 0.08;

/// The trunk ends where the tree is wider than this times the foot.
const CROWN_WIDENS: f32 = 1.9;

/// Rows in a row that must be wide before the trunk ends, as a share of the height: a single leaf ends
/// none.
const CROWN_ROWS: f32 = 0.015;

/// A foot wider than this share of the widest row is no trunk but a crown that reaches the ground.
const WIDEST_TRUNK: f32 = 0.3;

/// The trunk below the crown, in working pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Trunk {
    /// Its rows from the bottom up: (row, middle, width). Empty where no trunk is seen.
    pub(super) rows: Vec<(usize, f32, f32)>,
    /// Its width, the median of the foot's.
    pub(super) width: f32,
}

impl Trunk {
    /// Follows the trunk upwards from the pixel in column `x` and row `y`.
    ///
    /// O(pixels).
    pub(super) fn find(alpha: &Plane, x: usize, y: usize) -> Self {
        let height = alpha.height;
        let foot = ((FOOT * height as f32) as usize).max(2);
        let mut rows: Vec<(usize, f32, f32)> = Vec::new();
        let (mut middle, mut wide) = (x as f32, 0);
        for row in (0..=y.min(height - 1)).rev() {
            let Some((left, right)) = run(alpha, row, middle) else {
                // The base may be marked a little below the matte's lowest pixel.
                if rows.is_empty() && y - row < foot {
                    continue;
                }
                break;
            };
            let width = (right - left + 1) as f32;
            let so_far = median(&rows, foot);
            if rows.len() >= foot && width > CROWN_WIDENS * so_far + 1.0 {
                wide += 1;
                if wide as f32 > CROWN_ROWS * height as f32 {
                    break;
                }
                continue;
            }
            wide = 0;
            middle = 0.5 * (left + right) as f32;
            rows.push((row, middle, width));
        }
        let width = median(&rows, foot);
        if rows.len() < foot || width > WIDEST_TRUNK * widest(alpha) {
            return Self::default();
        }
        Self { rows, width }
    }

    /// Distance of a pixel to the trunk's axis; infinite where no trunk is seen.
    pub(super) fn distance(&self, x: usize, y: usize) -> f32 {
        self.rows.iter().fold(f32::INFINITY, |nearest, &(row, middle, _)| {
            let (dx, dy) = (x as f32 - middle, y as f32 - row as f32);
            nearest.min((dx * dx + dy * dy).sqrt())
        })
    }
}

/// The run of solid pixels of a row that holds `middle`, or the nearest within a few pixels.
fn run(alpha: &Plane, row: usize, middle: f32) -> Option<(usize, usize)> {
    let values = &alpha.values[row * alpha.width..][..alpha.width];
    let center = (middle as usize).min(alpha.width - 1);
    let near = (alpha.width / 40).max(2);
    let start = (0..=near)
        .flat_map(|step| [center.checked_sub(step), Some(center + step)])
        .flatten()
        .find(|&x| values.get(x).is_some_and(|&value| value > SOLID))?;
    let left = (0..start).rev().take_while(|&x| values[x] > SOLID).last().unwrap_or(start);
    let right = (start..alpha.width).take_while(|&x| values[x] > SOLID).last().unwrap_or(start);
    Some((left, right))
}

/// The median width of the first `n` rows; infinite without any.
fn median(rows: &[(usize, f32, f32)], n: usize) -> f32 {
    let mut widths: Vec<f32> = rows.iter().take(n).map(|row| row.2).collect();
    widths.sort_by(f32::total_cmp);
    widths.get(widths.len() / 2).copied().unwrap_or(f32::INFINITY)
}

/// Distance between the outermost solid pixels of the widest row.
fn widest(alpha: &Plane) -> f32 {
    let solid = |&value: &f32| value > SOLID;
    let width = |row: &[f32]| {
        let first = row.iter().position(solid)?;
        Some(row.iter().rposition(solid)? - first + 1)
    };
    alpha.values.chunks_exact(alpha.width).filter_map(width).max().unwrap_or(0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A round crown on a trunk 6 wide.
    fn lollipop() -> Plane {
        let mut alpha = Plane::new(100, 100);
        for (i, value) in alpha.values.iter_mut().enumerate() {
            let (x, y) = ((i % 100) as f32 - 50.0, (i / 100) as f32);
            let crown = x * x + (y - 35.0) * (y - 35.0) < 30.0 * 30.0;
            let trunk = (-3.0..3.0).contains(&x) && y > 35.0 && y < 95.0;
            *value = if crown || trunk { 1.0 } else { 0.0 };
        }
        alpha
    }

    #[test]
    fn the_trunk_ends_where_the_crown_begins() {
        let trunk = Trunk::find(&lollipop(), 50, 96);
        assert_eq!(trunk.width, 6.0);
        let (top, middle, _) = *trunk.rows.last().unwrap();
        assert!((62..=66).contains(&top), "{top}");
        assert!((middle - 49.5).abs() < 1.0);
        assert!(trunk.distance(70, 80) > 19.0);
    }

    #[test]
    fn a_crown_that_reaches_the_ground_has_no_trunk() {
        let alpha = Plane::new(50, 50).map(|_| 1.0);
        assert_eq!(Trunk::find(&alpha, 25, 49), Trunk::default());
        assert_eq!(Trunk::find(&Plane::new(1, 1), 0, 0), Trunk::default());
    }
}
