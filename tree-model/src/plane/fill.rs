//! Filled areas as triangles: contours that may cross, touch and nest become a triangulation whose triangles are
//! inside or outside, and a border without crossings.
//!
//! Coordinates are brought to whole numbers in a frame of ±2²² first, so that what nearly touches touches. That moves
//! points by 1 / 8,000,000 of the drawing's size, less than an `f32` resolves.

use super::arrange::{arrange, crossings};
use glam::{DVec2, Vec2};
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// Half the side of the frame that drawings are brought to.
pub(crate) const HALF: f64 = 4_194_304.0;

/// Contours with more corners than this together are thinned.
pub(crate) const MOST_CORNERS: usize = 4096;

/// Contours that cross themselves more often than this are thinned: a scribble has no outline to keep.
const MOST_CROSSINGS: usize = 20_000;

/// Coordinates beyond this are left out: differences and squares of them would overflow.
const LARGEST: f32 = 1e15;

/// No triangle lies there.
pub(crate) const NONE: u32 = u32::MAX;

/// Rows of the winding test: lines are sought only in the row of the point asked for.
const ROWS: usize = 256;

/// What is inside an area of several contours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FillRule {
    /// What the contours together wind round: a hole runs against its outer contour.
    #[default]
    NonZero,
    /// What an odd number of contours wind round: a hole may run either way.
    EvenOdd,
}

/// Where a drawing was before it was brought to ±[`HALF`].
pub(crate) struct Frame {
    center: DVec2,
    /// Units of the drawing for one unit of the frame.
    scale: f64,
}

impl Frame {
    /// The frame of contours, and the contours in it: finite, without repeated points, three points at least, at
    /// most [`MOST_CORNERS`] together. `None` where nothing is left.
    pub(crate) fn of(contours: &[Vec<Vec2>]) -> Option<(Self, Vec<Vec<DVec2>>)> {
        let good = |p: &&Vec2| p.x.abs() <= LARGEST && p.y.abs() <= LARGEST;
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in contours.iter().flatten().filter(good) {
            (low, high) = (low.min(point.as_dvec2()), high.max(point.as_dvec2()));
        }
        let size = (high - low).max_element();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let frame = Self { center: 0.5 * (low + high), scale: 0.5 * size / HALF };
        let mut out: Vec<Vec<DVec2>> = Vec::new();
        for contour in contours {
            let mut points: Vec<DVec2> =
                contour.iter().filter(good).map(|&p| frame.to_frame(p)).collect();
            tidy(&mut points);
            out.push(points);
        }
        thin(&mut out);
        out.retain(|contour| contour.len() > 2);
        (!out.is_empty()).then_some((frame, out))
    }

    pub(crate) fn to_frame(&self, point: Vec2) -> DVec2 {
        ((point.as_dvec2() - self.center) / self.scale).round()
    }

    pub(crate) fn to_drawing(&self, point: DVec2) -> Vec2 {
        (self.center + point * self.scale).as_vec2()
    }

    pub(crate) fn length(&self, length: f64) -> f32 {
        (length * self.scale) as f32
    }
}

/// Drops repeated points, and the last where it is the first again.
pub(crate) fn tidy(points: &mut Vec<DVec2>) {
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
}

/// Steps beyond this share of the frame are details no more: what then still is too much is a scribble.
const COARSEST: f64 = HALF / 128.0;

/// Drops points close to the last one kept, and of a scribble every other one, until there are few enough of them and
/// of their crossings.
fn thin(contours: &mut [Vec<DVec2>]) {
    let mut step = HALF / 4096.0;
    loop {
        let corners: usize = contours.iter().map(Vec::len).sum();
        if corners <= MOST_CORNERS && crossings(contours, MOST_CROSSINGS) < MOST_CROSSINGS {
            return;
        }
        for contour in contours.iter_mut() {
            let mut last: Option<DVec2> = None;
            contour.retain(|&point| {
                let keep = last.is_none_or(|last| last.distance_squared(point) > step * step);
                if keep {
                    last = Some(point);
                }
                keep
            });
            if step > COARSEST {
                let mut keep = false;
                contour.retain(|_| {
                    keep = !keep;
                    keep
                });
            }
            tidy(contour);
        }
        step = (2.0 * step).min(2.0 * COARSEST);
    }
}

/// The sides of a closed contour.
pub(crate) fn sides(contour: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    contour.iter().copied().zip(contour.iter().copied().cycle().skip(1))
}

/// Area of a contour, above 0 where it runs against the clock.
pub(crate) fn area(contour: &[DVec2]) -> f64 {
    0.5 * sides(contour).map(|(a, b)| a.perp_dot(b)).sum::<f64>()
}

/// The contour without points that lie within `tolerance` of the line between those kept (Douglas & Peucker 1973).
pub(crate) fn simplify(contour: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    let Some(&first) = contour.first() else { return Vec::new() };
    let far = |from: DVec2| {
        let ranked = contour.iter().map(|p| p.distance_squared(from)).enumerate();
        ranked.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i)
    };
    // Two corners that are sure to be some.
    let start = far(first);
    let mut ring: Vec<DVec2> = contour[start..].iter().chain(&contour[..start]).copied().collect();
    ring.push(ring[0]);
    let mut kept = simplify_line(&ring, tolerance);
    kept.pop();
    kept
}

/// The same for an open line; its ends stay.
pub(crate) fn simplify_line(line: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut keep = vec![false; line.len()];
    let mut open = vec![(0, line.len() - 1)];
    while let Some((from, to)) = open.pop() {
        (keep[from], keep[to]) = (true, true);
        let away = |i: usize| distance_to(line[i], line[from], line[to]);
        let farthest = (from + 1..to).map(|i| (i, away(i))).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((at, distance)) = farthest
            && distance > tolerance
        {
            open.extend([(from, at), (at, to)]);
        }
    }
    line.iter().zip(keep).filter(|(_, keep)| *keep).map(|(&point, _)| point).collect()
}

/// Distance from a point to a segment.
pub(crate) fn distance_to(point: DVec2, a: DVec2, b: DVec2) -> f64 {
    let side = b - a;
    let length = side.length_squared();
    let along = if length > 0.0 { ((point - a).dot(side) / length).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(a + along * side)
}

/// The inner triangles of an area.
pub(crate) struct Fill {
    pub(crate) points: Vec<DVec2>,
    /// Corners against the clock.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The inner triangle across the side from corner i to corner i + 1, or [`NONE`].
    pub(crate) neighbours: Vec<[u32; 3]>,
}

#[derive(Clone, Copy)]
struct Corner(Point2<f64>);

impl HasPosition for Corner {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        self.0
    }
}

impl Fill {
    /// Triangulates what lies inside contours in a [`Frame`]; `None` where nothing does.
    pub(crate) fn of(contours: &[Vec<DVec2>], rule: FillRule) -> Option<Self> {
        let contours = arrange(contours);
        let mut cdt = ConstrainedDelaunayTriangulation::<Corner>::new();
        // All corners come before the sides: a corner put on a side would have to cut it.
        let mut rings = Vec::new();
        for contour in &contours {
            let insert = |p: &DVec2| cdt.insert(Corner(Point2::new(p.x, p.y)));
            rings.push(contour.iter().map(insert).collect::<Result<Vec<_>, _>>().ok()?);
        }
        for ring in &rings {
            for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                // Leaves a side out that crosses another, as `add_constraint` panics and `add_constraint_and_split`
                // may (spade 2.15.1): none does but after the last round of cutting.
                cdt.try_add_constraint(from, to);
            }
        }
        let winding = Winding::of(&contours);
        let points: Vec<DVec2> =
            cdt.vertices().map(|v| DVec2::new(v.position().x, v.position().y)).collect();
        // Rows of the inner triangles by face.
        let mut rows = vec![NONE; cdt.num_all_faces()];
        let mut triangles = Vec::new();
        let mut faces = Vec::new();
        for face in cdt.inner_faces() {
            let corners = face.vertices().map(|v| v.fix().index() as u32);
            let middle = corners.iter().map(|&c| points[c as usize]).sum::<DVec2>() / 3.0;
            if winding.is_inside(middle, rule) {
                rows[face.fix().index()] = triangles.len() as u32;
                triangles.push(corners);
                faces.push(face);
            }
        }
        let across =
            |face: &spade::handles::FaceHandle<'_, spade::handles::InnerTag, _, _, _, _>| {
                face.adjacent_edges().map(|edge| rows[edge.rev().face().fix().index()])
            };
        let neighbours = faces.iter().map(across).collect();
        (!triangles.is_empty()).then_some(Self { points, triangles, neighbours })
    }

    /// The border of the area: contours that neither cross nor touch themselves, outer ones against the clock, holes with it.
    pub(crate) fn border(&self) -> Vec<Vec<DVec2>> {
        let mut seen = vec![[false; 3]; self.triangles.len()];
        let mut out = Vec::new();
        for first in 0..self.triangles.len() {
            for side in 0..3 {
                if self.neighbours[first][side] != NONE || seen[first][side] {
                    continue;
                }
                let mut ring = Vec::new();
                let mut at = (first, side);
                while !seen[at.0][at.1] {
                    seen[at.0][at.1] = true;
                    ring.push(self.triangles[at.0][at.1]);
                    at = self.next(at);
                }
                self.split(&ring, &mut out);
            }
        }
        out
    }

    /// The side of the border after this one: round its end through inner triangles.
    fn next(&self, (triangle, side): (usize, usize)) -> (usize, usize) {
        let end = self.triangles[triangle][(side + 1) % 3];
        let mut at = (triangle, (side + 1) % 3);
        loop {
            let across = self.neighbours[at.0][at.1];
            if across == NONE {
                return at;
            }
            let across = across as usize;
            let begins = self.triangles[across].iter().position(|&corner| corner == end);
            at = (across, begins.unwrap_or(0));
        }
    }

    /// Adds a ring, in parts where it comes to a corner twice.
    fn split(&self, ring: &[u32], out: &mut Vec<Vec<DVec2>>) {
        let mut place = vec![NONE; self.points.len()];
        let mut open: Vec<u32> = Vec::new();
        for &corner in ring {
            let before = place[corner as usize];
            if before != NONE {
                let part = open.split_off(before as usize);
                for &passed in &part {
                    place[passed as usize] = NONE;
                }
                out.push(part.iter().map(|&c| self.points[c as usize]).collect());
            }
            place[corner as usize] = open.len() as u32;
            open.push(corner);
        }
        out.push(open.iter().map(|&c| self.points[c as usize]).collect());
    }
}

/// Sides by rows, for winding numbers.
pub(crate) struct Winding {
    /// The contour and the ends of each side, by rows of equal height.
    rows: Vec<Vec<(u32, DVec2, DVec2)>>,
}

impl Winding {
    pub(crate) fn of(contours: &[Vec<DVec2>]) -> Self {
        let mut rows = vec![Vec::new(); ROWS];
        for (which, contour) in contours.iter().enumerate() {
            for (a, b) in sides(contour) {
                for row in &mut rows[Self::row(a.y.min(b.y))..=Self::row(a.y.max(b.y))] {
                    row.push((which as u32, a, b));
                }
            }
        }
        Self { rows }
    }

    fn row(y: f64) -> usize {
        let share = (y + HALF) / (2.0 * HALF);
        ((share * ROWS as f64) as usize).min(ROWS - 1)
    }

    pub(crate) fn is_inside(&self, point: DVec2, rule: FillRule) -> bool {
        let (mut contour, mut winding, mut wound) = (0, 0, 0);
        for &(which, a, b) in &self.rows[Self::row(point.y)] {
            if which != contour && rule == FillRule::EvenOdd {
                wound += i32::from(winding != 0);
                (contour, winding) = (which, 0);
            }
            if (a.y > point.y) == (b.y > point.y) {
                continue;
            }
            let left = (b - a).perp_dot(point - a) > 0.0;
            // Sides to the right of the point, upwards and downwards.
            if b.y > a.y && left {
                winding += 1;
            } else if b.y < a.y && !left {
                winding -= 1;
            }
        }
        match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => (wound + i32::from(winding != 0)) % 2 == 1,
        }
    }
}
