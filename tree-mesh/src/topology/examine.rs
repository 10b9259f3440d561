//! Counts what makes a closed, consistently oriented 2-manifold.
//!
//! 1. Corners are put in order of their points (compressed rows): a corner of point p in the triangle
//!    (p, a, b) is the pair (a, b), so the row of p holds the half-edges p → a that leave it and the
//!    half-edges b → p that come back.
//! 2. Per point, the row is sorted by a. Each neighbour must leave once and come back once: otherwise
//!    the edge is a boundary, shared by more than two triangles, or has triangles that face opposite
//!    ways. An edge is counted at its lower point.
//! 3. Per point, corners are walked from b to the corner that starts with it. The triangles of a point
//!    of a manifold form one such fan.
//! 4. Components by union-find over points.
//!
//! Sums are taken over parts of fixed length in a fixed order: the same bits for any number of threads.

use super::weld::welded;
use crate::error::Result;
use crate::mesh::Surface;
use glam::DVec3;
use rayon::prelude::*;

/// A triangle counts as flat when its area is below this share of the squared diagonal of the box
/// around the surface: a square with a side of a ten-millionth of the diagonal, about the step of
/// an f32, and a tenth as high. For a tree of 10 m that is 10⁻¹³ m².
pub const FLAT_SHARE: f64 = 1e-15;
/// Triangles or points in one part of the work.
const PART: usize = 1 << 14;

/// What [`examine`] found. Lengths in metres.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Topology {
    /// Points that triangles use; copies at seams count once.
    pub n_points: u64,
    /// Edges between points.
    pub n_edges: u64,
    /// Triangles of three different points.
    pub n_triangles: u64,
    /// Triangles with two corners at one point. They have no area and are not counted elsewhere.
    pub collapsed_triangles: u64,
    /// Edges of one triangle only: holes.
    pub boundary_edges: u64,
    /// Edges of more than two triangles.
    pub non_manifold_edges: u64,
    /// Edges of two triangles that run along them in the same direction: one faces inwards.
    pub misoriented_edges: u64,
    /// Points whose triangles form more than one fan.
    pub non_manifold_points: u64,
    /// Vertices that do not stand exactly where the vertex they are welded to stands: cracks.
    pub cracks: u64,
    /// Pieces that share no point.
    pub components: u64,
    /// Enclosed volume in m³ by the divergence theorem; of a closed surface only. Negative when its
    /// triangles face inwards.
    pub volume: f64,
    /// Area in m².
    pub area: f64,
    /// Triangles with less area than [`FLAT_SHARE`] allows.
    pub flat_triangles: u64,
    /// Area of the smallest triangle in m²; infinite without triangles.
    pub smallest_area: f64,
    /// Smallest angle of any triangle in radians, up to π/3; infinite without triangles.
    pub smallest_angle: f64,
}

impl Topology {
    /// Whether this is a closed, consistently oriented 2-manifold, of any number of pieces.
    #[must_use]
    pub const fn is_closed(&self) -> bool {
        self.n_triangles > 0
            && self.boundary_edges == 0
            && self.non_manifold_edges == 0
            && self.misoriented_edges == 0
            && self.non_manifold_points == 0
            && self.cracks == 0
    }

    /// Euler characteristic: points − edges + triangles. 2 for each closed piece without handles.
    #[must_use]
    pub const fn euler(&self) -> i64 {
        self.n_points as i64 - self.n_edges as i64 + self.n_triangles as i64
    }
}

/// Counts points, edges, holes, pieces and the like of a surface.
///
/// # Errors
/// As [`welded`].
///
/// # Complexity
/// O(triangles · log triangles at a point) with welds, about 16 bytes a corner of memory; without
/// welds vertices are sorted by place first.
pub fn examine(surface: &Surface) -> Result<Topology> {
    let points = welded(surface)?;
    let all = points.triangles(surface);
    let places: Vec<DVec3> =
        points.first.par_iter().map(|&v| surface.positions[v as usize].as_dvec3()).collect();
    let mut found = Topology {
        smallest_area: f64::INFINITY,
        smallest_angle: f64::INFINITY,
        ..Topology::default()
    };
    let place = |vertex: usize| surface.positions[points.first[vertex] as usize];
    let crack = |(&p, &own): (&u32, &glam::Vec3)| place(p as usize) != own;
    found.cracks =
        points.of_vertex.par_iter().zip(&surface.positions).filter(|&pair| crack(pair)).count()
            as u64;

    let n_all = all.len();
    let triangles: Vec<[u32; 3]> =
        all.into_par_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect();
    found.n_triangles = triangles.len() as u64;
    found.collapsed_triangles = (n_all - triangles.len()) as u64;
    measure(&triangles, &places, &mut found);
    let rows = Rows::new(&triangles, points.len());
    rows.count(&mut found);
    found.components = components(&triangles, &rows);
    Ok(found)
}

/// Areas, angles and volume.
fn measure(triangles: &[[u32; 3]], places: &[DVec3], found: &mut Topology) {
    let (low, high) =
        places.iter().fold((DVec3::MAX, DVec3::MIN), |(low, high), &p| (low.min(p), high.max(p)));
    let diagonal = if places.is_empty() { 0.0 } else { (high - low).length_squared() };
    // Volume is summed about the middle: far from the origin terms would cancel.
    let middle = 0.5 * (low + high);
    let parts: Vec<_> = triangles
        .par_chunks(PART)
        .map(|part| {
            let mut sum = Topology {
                smallest_area: f64::INFINITY,
                smallest_angle: f64::INFINITY,
                ..Topology::default()
            };
            for corners in part {
                let [a, b, c] = corners.map(|point| places[point as usize] - middle);
                let cross = (b - a).cross(c - a);
                let area = 0.5 * cross.length();
                sum.area += area;
                sum.volume += a.dot(cross) / 6.0;
                sum.flat_triangles += u64::from(area < FLAT_SHARE * diagonal);
                sum.smallest_area = sum.smallest_area.min(area);
                let tangent = smallest_tangent([a, b, c], 2.0 * area);
                sum.smallest_angle = sum.smallest_angle.min(tangent);
            }
            sum
        })
        .collect();
    // Tangents up to here: one arc instead of millions.
    for part in parts {
        found.area += part.area;
        found.volume += part.volume;
        found.flat_triangles += part.flat_triangles;
        found.smallest_area = found.smallest_area.min(part.smallest_area);
        found.smallest_angle = found.smallest_angle.min(part.smallest_angle);
    }
    if found.smallest_angle.is_finite() {
        found.smallest_angle = libm::atan(found.smallest_angle);
    }
}

/// The tangent of the smallest angle, which lies opposite the shortest side and is 60° at most.
fn smallest_tangent([a, b, c]: [DVec3; 3], cross: f64) -> f64 {
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let squares = [bc.length_squared(), ca.length_squared(), ab.length_squared()];
    let dot = if squares[0] <= squares[1] && squares[0] <= squares[2] {
        -ab.dot(ca)
    } else if squares[1] <= squares[2] {
        -ab.dot(bc)
    } else {
        -bc.dot(ca)
    };
    if cross > 0.0 { cross / dot } else { 0.0 }
}

/// Corners by point: the corner of p in the triangle (p, a, b) is `a << 32 | b`.
struct Rows {
    starts: Vec<usize>,
    corners: Vec<u64>,
}

impl Rows {
    fn new(triangles: &[[u32; 3]], n_points: usize) -> Self {
        let mut starts = vec![0_usize; n_points + 1];
        for &point in triangles.as_flattened() {
            starts[point as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        // Filled from behind, so that ends become starts.
        let mut corners = vec![0_u64; 3 * triangles.len()];
        for &[a, b, c] in triangles.iter().rev() {
            for (p, next, last) in [(a, b, c), (b, c, a), (c, a, b)] {
                let slot = &mut starts[p as usize];
                *slot -= 1;
                corners[*slot] = u64::from(next) << 32 | u64::from(last);
            }
        }
        Self { starts, corners }
    }

    fn row(&self, point: usize) -> &[u64] {
        &self.corners[self.starts[point]..self.starts[point + 1]]
    }

    fn count(&self, found: &mut Topology) {
        let n_points = self.starts.len() - 1;
        let parts: Vec<Topology> = (0..n_points.div_ceil(PART))
            .into_par_iter()
            .map_init(Fan::default, |fan, part| {
                let mut sum = Topology::default();
                for point in part * PART..((part + 1) * PART).min(n_points) {
                    fan.count(point as u32, self.row(point), &mut sum);
                }
                sum
            })
            .collect();
        for part in parts {
            found.n_points += part.n_points;
            found.n_edges += part.n_edges;
            found.boundary_edges += part.boundary_edges;
            found.non_manifold_edges += part.non_manifold_edges;
            found.misoriented_edges += part.misoriented_edges;
            found.non_manifold_points += part.non_manifold_points;
        }
    }
}

/// Space for the corners of one point.
#[derive(Default)]
struct Fan {
    leaving: Vec<u64>,
    coming: Vec<u32>,
    group: Vec<u32>,
}

impl Fan {
    fn count(&mut self, point: u32, row: &[u64], sum: &mut Topology) {
        if row.is_empty() {
            return;
        }
        sum.n_points += 1;
        self.leaving.clear();
        self.leaving.extend_from_slice(row);
        self.leaving.sort_unstable();
        if self.is_one_ring() {
            let higher = self.leaving.partition_point(|&corner| corner >> 32 <= u64::from(point));
            sum.n_edges += (self.leaving.len() - higher) as u64;
            return;
        }
        self.count_edges(point, sum);
        sum.non_manifold_points += u64::from(self.n_fans() > 1);
    }

    /// The number of the first corner that starts with `neighbour`, if there is one.
    fn start(&self, neighbour: u32) -> Option<usize> {
        let at = self.leaving.partition_point(|&corner| corner >> 32 < u64::from(neighbour));
        let there =
            self.leaving.get(at).is_some_and(|&corner| corner >> 32 == u64::from(neighbour));
        there.then_some(at)
    }

    /// Whether the corners form one closed fan: the case of nearly every point.
    fn is_one_ring(&self) -> bool {
        let mut at = 0;
        for n_walked in 1..=self.leaving.len() {
            let next = self.start(self.leaving[at] as u32);
            match next {
                Some(0) => return n_walked == self.leaving.len(),
                Some(next) => at = next,
                None => return false,
            }
        }
        false
    }

    /// Edges to higher points, by how often they leave and come back.
    fn count_edges(&mut self, point: u32, sum: &mut Topology) {
        self.coming.clear();
        self.coming.extend(self.leaving.iter().map(|&corner| corner as u32));
        self.coming.sort_unstable();
        let (mut i, mut j) = (0, 0);
        loop {
            let leaving = self.leaving.get(i).map(|&corner| (corner >> 32) as u32);
            let coming = self.coming.get(j).copied();
            let Some(neighbour) = leaving.into_iter().chain(coming).min() else {
                return;
            };
            let (first_i, first_j) = (i, j);
            while self.leaving.get(i).is_some_and(|&c| (c >> 32) as u32 == neighbour) {
                i += 1;
            }
            while self.coming.get(j) == Some(&neighbour) {
                j += 1;
            }
            if neighbour < point {
                continue;
            }
            sum.n_edges += 1;
            match (i - first_i, j - first_j) {
                (1, 1) => {}
                (1, 0) | (0, 1) => sum.boundary_edges += 1,
                (2, 0) | (0, 2) => sum.misoriented_edges += 1,
                _ => sum.non_manifold_edges += 1,
            }
        }
    }

    /// Fans of triangles that hang together by edges.
    fn n_fans(&mut self) -> usize {
        // Neighbours, numbered by their place in the sorted list; each corner joins two of them.
        self.coming.extend(self.leaving.iter().map(|&corner| (corner >> 32) as u32));
        self.coming.sort_unstable();
        self.coming.dedup();
        self.group.clear();
        self.group.extend(0..self.coming.len() as u32);
        let mut n = self.coming.len();
        for &corner in &self.leaving {
            let number = |neighbour: u32| self.coming.partition_point(|&other| other < neighbour);
            let (a, b) = (number((corner >> 32) as u32), number(corner as u32));
            n -= usize::from(unite(&mut self.group, a as u32, b as u32));
        }
        n
    }
}

fn components(triangles: &[[u32; 3]], rows: &Rows) -> u64 {
    let n_points = rows.starts.len() - 1;
    let mut group: Vec<u32> = (0..n_points as u32).collect();
    let mut n = (0..n_points).filter(|&point| !rows.row(point).is_empty()).count() as u64;
    for &[a, b, c] in triangles {
        n -= u64::from(unite(&mut group, a, b)) + u64::from(unite(&mut group, b, c));
    }
    n
}

/// Joins two groups; false if they were one. The lower number stays, paths are halved.
fn unite(group: &mut [u32], a: u32, b: u32) -> bool {
    let mut find = |mut x: u32| {
        while group[x as usize] != x {
            group[x as usize] = group[group[x as usize] as usize];
            x = group[x as usize];
        }
        x
    };
    let (a, b) = (find(a), find(b));
    group[a.max(b) as usize] = a.min(b);
    a != b
}
