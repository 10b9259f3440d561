//! The solid that a closed triangle mesh bounds.
//!
//! 1. Positions with the same coordinates are welded: what matters is where a corner is, not its index.
//! 2. Closedness: each directed edge must be matched by its opposite. Then every point off the surface
//!    has a whole winding number, and inside is where it is not zero: shells that overlap merge, a
//!    shell turned inside out within another is a hole, and a mesh inside out as a whole is solid.
//! 3. Inside test: signed crossings of a vertical ray ([`columns`]).
//! 4. Distance: nearest triangle in a tree of boxes ([`nearest`]).

mod columns;
mod nearest;

use super::axial::signed;
use super::check;
use crate::bounds::Aabb;
use crate::error::{CoreError, Result, check_finite};
use columns::Columns;
use glam::{DVec3, Vec3};
use nearest::Nearest;

/// Most triangles of one solid, so that entries of the search structures are counted in u32.
pub(super) const MAX_TRIANGLES: usize = 1 << 27;

/// Corners of a triangle in space.
type Corners = [Vec3; 3];

/// The compiled mesh.
#[derive(Debug)]
pub(super) struct Mesh {
    triangles: Vec<Corners>,
    columns: Columns,
    nearest: Nearest,
    bounds: Aabb,
}

impl Mesh {
    pub(super) fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<Self> {
        if triangles.is_empty() {
            return Err(CoreError::Empty { what: "mesh.triangles" });
        }
        if triangles.len() > MAX_TRIANGLES {
            return Err(CoreError::OutOfRange {
                field: "mesh.triangles",
                index: 0,
                found: triangles.len() as f64,
                min: 1.0,
                max: MAX_TRIANGLES as f64,
            });
        }
        check_finite("mesh.positions", positions)?;
        let n_positions = positions.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(corner) = corners.iter().find(|&&c| c as usize >= n_positions) {
                return Err(check::problem(
                    "mesh",
                    format!(
                        "triangle {triangle} names position {corner}, but there are only {n_positions}"
                    ),
                ));
            }
        }
        let welded = weld(positions);
        check_closed(triangles, &welded)?;
        let mut solid: Vec<Corners> = triangles
            .iter()
            .map(|corners| corners.map(|c| positions[c as usize]))
            // A triangle that welding collapsed covers nothing, and its edges match each other.
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect();
        let bounds = Aabb::of_points(solid.as_flattened());
        if !bounds.min.cmplt(bounds.max).all() {
            return Err(check::problem(
                "mesh",
                "all triangles lie in one plane: a solid needs depth",
            ));
        }
        let nearest = Nearest::new(&mut solid);
        let columns = Columns::new(&solid, bounds);
        Ok(Self { triangles: solid, columns, nearest, bounds })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.columns.winding(&self.triangles, p) != 0
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let distance = self.nearest.distance_squared(&self.triangles, p).sqrt();
        signed(distance, self.contains(p))
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Signed tetrahedra from the middle of the box, which keeps them small.
    pub(super) fn measure(&self) -> f64 {
        let middle = self.bounds.center().as_dvec3();
        let sum: f64 = self
            .triangles
            .iter()
            .map(|corners| {
                let [a, b, c] = corners.map(|p| p.as_dvec3() - middle);
                a.dot(b.cross(c))
            })
            .sum();
        (sum / 6.0).abs()
    }
}

/// For each position the first index with the same coordinates (in sorted order; -0 equals 0).
fn weld(positions: &[Vec3]) -> Vec<u32> {
    let key = |i: u32| positions[i as usize] + Vec3::ZERO;
    let mut order: Vec<u32> = (0..positions.len() as u32).collect();
    order.sort_unstable_by(|&i, &j| {
        let (a, b) = (key(i), key(j));
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)).then(i.cmp(&j))
    });
    let mut welded = vec![0; positions.len()];
    let mut first = 0;
    for &i in &order {
        if key(i) != key(first) {
            first = i;
        }
        welded[i as usize] = first;
    }
    welded
}

/// One side of a triangle: its welded ends in ascending order, which way the triangle runs along it,
/// and where it is.
struct Side {
    low: u32,
    high: u32,
    rises: bool,
    triangle: u32,
    corner: u8,
}

/// Each directed edge occurs as often as its opposite.
fn check_closed(triangles: &[[u32; 3]], welded: &[u32]) -> Result<()> {
    let mut sides: Vec<Side> = Vec::with_capacity(3 * triangles.len());
    for (triangle, corners) in triangles.iter().enumerate() {
        for corner in 0..3_u8 {
            let from = welded[corners[usize::from(corner)] as usize];
            let to = welded[corners[usize::from(corner + 1) % 3] as usize];
            if from != to {
                sides.push(Side {
                    low: from.min(to),
                    high: from.max(to),
                    rises: from < to,
                    triangle: triangle as u32,
                    corner,
                });
            }
        }
    }
    sides.sort_unstable_by_key(|side| (side.low, side.high, side.triangle, side.corner));
    for edge in sides.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high)) {
        let rising = edge.iter().filter(|side| side.rises).count();
        let falling = edge.len() - rising;
        if rising == falling {
            continue;
        }
        let Some(open) = edge.iter().find(|side| side.rises == (rising > falling)) else {
            continue;
        };
        let corners = triangles[open.triangle as usize];
        let from = corners[usize::from(open.corner)];
        let to = corners[usize::from(open.corner + 1) % 3];
        return Err(check::problem(
            "mesh",
            format!(
                "the edge from position {from} to {to} of triangle {} is open: no other triangle \
                 runs along it the opposite way",
                open.triangle
            ),
        ));
    }
    Ok(())
}
