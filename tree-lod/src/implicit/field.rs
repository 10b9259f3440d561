//! Metaballs: the sum of what every point contributes to the places around it.
//!
//! Points are sorted into the cells of a uniform grid (counting sort), so that a place asks only the
//! cells its ball of influence touches. The cells of a row lie one after the other: a row is one run
//! of points.

use crate::Elements;
use crate::error::{LodError, Result, check_range};
use glam::Vec3;
use tree_core::Aabb;

/// Cells along the radius of influence: smaller cells fit the ball better, but are more runs to visit.
const CELLS: f32 = 2.0;
/// Cells per point at most: a few points far from each other must not ask for memory without end.
const CELLS_PER_POINT: f64 = 8.0;
/// Largest coordinate and radius in metres: squares of both stay far within 32-bit numbers.
const FAR: f32 = 1e9;
/// Smallest radius in metres, for the same reason.
const NEAR: f32 = 1e-9;
/// A crown whose lowest centre stands at most this many times its own height over the ground stands
/// on a trunk that starts there; higher up it is a model that is not based at the origin.
const CLEAR_TRUNK: f32 = 2.0;

/// A sum of metaballs of one radius; dimensionless, 1 or more at each point, 0 far from all.
#[derive(Clone, Debug)]
pub struct Metaballs {
    /// Points by cell.
    pub(super) points: Vec<Vec3>,
    /// The element or row of the input each point stems from.
    pub(crate) ids: Vec<u32>,
    /// Where the points of each cell begin; their number at the end. x runs fastest, then y, then z.
    starts: Vec<u32>,
    cells: [usize; 3],
    /// Side of a cell in metres.
    side: f32,
    bounds: Aabb,
    radius: f32,
}

impl Metaballs {
    /// The field of these points, each with `radius` metres of influence.
    ///
    /// # Errors
    /// [`LodError::Parameter`] when the radius is not within 10⁻⁹ to 10⁹ m, or a coordinate is not within
    /// ±10⁹ m; [`LodError::Foliage`] when there are no points.
    ///
    /// # Complexity
    /// O(points).
    pub fn new(points: &[Vec3], radius: f32) -> Result<Self> {
        Self::with_ids(points.to_vec(), (0..points.len() as u32).collect(), radius)
    }

    /// The field of the centres of all elements that have area.
    ///
    /// `radius` is a share of `height`, the height of the plant in metres, or of [`plant_height`] when
    /// `height` is 0.
    ///
    /// # Errors
    /// As [`Metaballs::new`]; [`LodError::Foliage`] also when no element has area.
    pub fn of_elements(elements: &Elements, radius: f32, height: f32) -> Result<Self> {
        check_columns(elements)?;
        let ids: Vec<u32> =
            (0..elements.len() as u32).filter(|&i| elements.areas[i as usize] > 0.0).collect();
        if ids.is_empty() {
            return Err(LodError::Foliage("no element has area"));
        }
        let height = if height > 0.0 { height } else { plant_height(elements)? };
        let points = ids.iter().map(|&i| elements.centers[i as usize]).collect();
        Self::with_ids(points, ids, radius * height)
    }

    fn with_ids(points: Vec<Vec3>, ids: Vec<u32>, radius: f32) -> Result<Self> {
        check_range("field.radius", radius.into(), NEAR.into(), FAR.into())?;
        let bounds = checked_bounds(&points)?;
        let size = bounds.size();
        let mut side = radius / CELLS;
        let allowed = CELLS_PER_POINT * points.len() as f64 + 64.0;
        let count =
            |side: f32| size.to_array().map(|x| (f64::from(x) / f64::from(side)).floor() + 1.0);
        while count(side).iter().product::<f64>() > allowed {
            side *= 1.25;
        }
        let cells = count(side).map(|n| n as usize);
        let mut field = Self { points, ids, starts: Vec::new(), cells, side, bounds, radius };
        field.sort();
        Ok(field)
    }

    /// Puts points in the order of their cells; within a cell they keep their order.
    fn sort(&mut self) {
        let cell_of: Vec<usize> = self.points.iter().map(|&p| self.cell_of(p)).collect();
        let mut starts = vec![0_u32; self.cells.iter().product::<usize>() + 1];
        for &cell in &cell_of {
            starts[cell + 1] += 1;
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        let (points, ids) = (self.points.clone(), self.ids.clone());
        for (i, &cell) in cell_of.iter().enumerate() {
            let row = next[cell] as usize;
            next[cell] += 1;
            (self.points[row], self.ids[row]) = (points[i], ids[i]);
        }
        self.starts = starts;
    }

    fn cell_of(&self, point: Vec3) -> usize {
        let [x, y, z] = [0, 1, 2].map(|axis| self.cell(point[axis], axis));
        x + self.cells[0] * (y + self.cells[1] * z)
    }

    /// The cell of a coordinate; the nearest one for places outside (casts saturate).
    fn cell(&self, x: f32, axis: usize) -> usize {
        (((x - self.bounds.min[axis]) / self.side) as usize).min(self.cells[axis] - 1)
    }

    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no points: never.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Radius of influence in metres.
    #[must_use]
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// The box around the points.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The field at a place: the sum over all points within the radius of (1 − (distance / radius)²)².
    /// 0 for a place that is not finite.
    ///
    /// # Complexity
    /// O(points within about the radius).
    #[must_use]
    pub fn value(&self, place: Vec3) -> f32 {
        let mut sum = 0.0;
        self.near(place, |_, share| sum += share * share);
        sum
    }

    /// Where the field grows fastest, and how fast per metre: its exact derivative. Zero outside.
    ///
    /// # Complexity
    /// As [`value`](Self::value).
    #[must_use]
    pub fn gradient(&self, place: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        self.near(place, |row, share| sum += share * (self.points[row] - place));
        sum * (4.0 / (self.radius * self.radius))
    }

    /// The point of a row.
    pub(crate) fn point(&self, row: usize) -> Vec3 {
        self.points[row]
    }

    /// Calls `visit` with the row of every point within the radius and 1 − (distance / radius)², in the
    /// order of rows.
    #[inline]
    pub(crate) fn near(&self, place: Vec3, mut visit: impl FnMut(usize, f32)) {
        let scale = 1.0 / (self.radius * self.radius);
        let range = |axis: usize, reach: f32| {
            self.cell(place[axis] - reach, axis)..=self.cell(place[axis] + reach, axis)
        };
        let square = self.radius * self.radius;
        for z in range(2, self.radius) {
            let from_z = self.outside(place.z, z, 2);
            for y in range(1, self.radius) {
                let from_y = self.outside(place.y, y, 1);
                let left = square - from_z * from_z - from_y * from_y;
                if left <= 0.0 {
                    continue;
                }
                let xs = range(0, left.sqrt());
                let row = self.cells[0] * (y + self.cells[1] * z);
                let begin = self.starts[row + xs.start()] as usize;
                let end = self.starts[row + xs.end() + 1] as usize;
                for (i, point) in self.points[begin..end].iter().enumerate() {
                    let share = 1.0 - point.distance_squared(place) * scale;
                    if share > 0.0 {
                        visit(begin + i, share);
                    }
                }
            }
        }
    }

    /// How far a coordinate lies outside of a cell, a little less for rounding.
    fn outside(&self, x: f32, cell: usize, axis: usize) -> f32 {
        let low = self.bounds.min[axis] + cell as f32 * self.side;
        let far = (low - x).max(x - low - self.side);
        (far - 1e-3 * self.side - 1e-6 * x.abs()).max(0.0)
    }

    /// Rows of all points that may lie between two heights along z.
    pub(super) fn rows_between(&self, low: f32, high: f32) -> std::ops::Range<usize> {
        let layer = self.cells[0] * self.cells[1];
        let (first, last) = (self.cell(low, 2), self.cell(high, 2));
        self.starts[first * layer] as usize..self.starts[(last + 1) * layer] as usize
    }
}

/// Columns are public, so they may have been cut.
pub(crate) fn check_columns(elements: &Elements) -> Result<()> {
    let n = elements.centers.len();
    if [elements.normals.len(), elements.areas.len()] == [n; 2] {
        return Ok(());
    }
    Err(LodError::Foliage("centres, normals and areas must be as many as elements"))
}

fn checked_bounds(points: &[Vec3]) -> Result<Aabb> {
    if points.is_empty() {
        return Err(LodError::Foliage("there are no elements"));
    }
    for x in points.iter().flat_map(|p| p.to_array()) {
        check_range("elements.centers", x.into(), (-FAR).into(), FAR.into())?;
    }
    Ok(Aabb::of_points(points))
}

/// Height in metres of the plant the elements belong to: from the ground at y = 0, where trees are
/// based, to the highest centre. Of a model that is not based there (something lies below, or all is
/// higher than two crown heights) the height of the crown. Flat foliage counts with its widest side, and
/// a single element with its size.
///
/// # Errors
/// [`LodError::Parameter`] when a coordinate is not within ±10⁹ m; [`LodError::Foliage`] when there are
/// no elements, or all are one point.
pub fn plant_height(elements: &Elements) -> Result<f32> {
    let bounds = checked_bounds(&elements.centers)?;
    let (low, size) = (bounds.min.y, bounds.size());
    let based = (0.0..=CLEAR_TRUNK * size.y).contains(&low);
    let height = if based { bounds.max.y } else { size.y };
    let largest = elements.radii.iter().fold(0.0_f32, |far, &r| far.max(r));
    [height, size.max_element(), 2.0 * largest]
        .into_iter()
        .find(|&height| height > 0.0 && height.is_finite())
        .ok_or(LodError::Foliage("all elements are one point"))
}
