//! Halves of an outline, right and left of an axis, as points at even shares of their length.

use glam::Vec2;

/// Sides of a half whose box is kept.
pub(super) const BLOCK: usize = 8;

/// Blocks of a half: 96 sides follow six bumps on a side within a hundredth of their area.
pub(super) const BLOCKS: usize = 12;

/// An axis is taken by this many points at most, evenly along it: more of its bends no split shows.
const AXIS_POINTS: usize = 32;

/// The axis is extended in the direction it has over this share of its points at either end.
const END_SHARE: usize = 5;

/// How much larger than it is a box is taken, as a share of the largest coordinate: rounding must not drop a crossing.
const MARGIN: f32 = 1e-5;

/// Points of a half.
pub(super) const POINTS: usize = BLOCK * BLOCKS + 1;

/// One half of an outline, in columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Half {
    /// In radians, 0 to 2π.
    pub(super) azimuth: f32,
    /// r and y of the points, from top to bottom.
    pub(super) points: [[f32; POINTS]; 2],
    /// Middle of each block's box, r and y, and half its extent.
    pub(super) boxes: [[f32; BLOCKS]; 4],
}

impl Half {
    /// Of a line from top to bottom.
    fn of(line: &[Vec2]) -> Self {
        let points = evenly(line, POINTS - 1);
        let mut half = Self { azimuth: 0.0, points: [[0.0; POINTS]; 2], boxes: [[0.0; BLOCKS]; 4] };
        for (i, point) in points.iter().enumerate().take(POINTS) {
            (half.points[0][i], half.points[1][i]) = (point.x, point.y);
        }
        for block in 0..BLOCKS {
            let (middle, reach) = bounds(&points[block * BLOCK..=(block + 1) * BLOCK]);
            let box_ = [middle.x, middle.y, reach.x, reach.y];
            half.boxes.iter_mut().zip(box_).for_each(|(column, value)| column[block] = value);
        }
        half
    }
}

/// The right and the left half of a polygon against the clock. Both in the frame of the axis; the left one with r to the
/// left. O(axis + polygon).
pub(super) fn split(outline: &[Vec2], axis: &[Vec2]) -> [Half; 2] {
    let [bottom, top] = ends(outline, axis);
    let mut right = between(outline, bottom, top);
    right.reverse();
    let left: Vec<Vec2> = between(outline, top, bottom);
    let left: Vec<Vec2> = left.into_iter().map(|point| point * Vec2::new(-1.0, 1.0)).collect();
    [Half::of(&right), Half::of(&left)]
}

/// A place on a polygon: the number of the side and how far along it.
type Place = (usize, f32);

/// Where the extended axis enters a polygon first and leaves it last; where it misses it, its lowest and highest corner.
fn ends(outline: &[Vec2], axis: &[Vec2]) -> [Place; 2] {
    let axis = extended(axis, outline);
    let mut first: Option<(f32, Place)> = None;
    let mut last: Option<(f32, Place)> = None;
    for (number, stretch) in axis.windows(2).enumerate() {
        let (from, way) = (stretch[0], stretch[1] - stretch[0]);
        let off = |point: Vec2| way.perp_dot(point - from);
        let mut off_a = outline.last().map_or(0.0, |&point| off(point));
        for (i, &b) in outline.iter().enumerate() {
            let side = (i + outline.len() - 1) % outline.len();
            let (a, off_b) = (outline[side], off(b));
            if (off_a >= 0.0) != (off_b >= 0.0) {
                let part = off_a / (off_a - off_b);
                let along = (a.lerp(b, part) - from).dot(way) / way.length_squared();
                if (0.0..1.0).contains(&along) {
                    let found = (number as f32 + along, (side, part));
                    first = first.filter(|best| best.0 <= found.0).or(Some(found));
                    last = last.filter(|best| best.0 >= found.0).or(Some(found));
                }
            }
            off_a = off_b;
        }
    }
    match (first, last) {
        (Some(first), Some(last)) if first.1 != last.1 => [first.1, last.1],
        _ => extremes(outline),
    }
}

/// The lowest and the highest corner.
fn extremes(outline: &[Vec2]) -> [Place; 2] {
    let height = |i: usize| outline[i].y;
    let all = || 0..outline.len();
    let lowest = all().fold(0, |best, i| if height(i) < height(best) { i } else { best });
    let highest = all().fold(0, |best, i| if height(i) > height(best) { i } else { best });
    [(lowest, 0.0), (highest, 0.0)]
}

/// The axis with straight ends that reach beyond the outline.
fn extended(axis: &[Vec2], outline: &[Vec2]) -> Vec<Vec2> {
    let thinned =
        if axis.len() > AXIS_POINTS { evenly(axis, AXIS_POINTS - 1) } else { axis.to_vec() };
    let (Some(&start), Some(&end)) = (thinned.first(), thinned.last()) else { return thinned };
    let (_, extent) = bounds(outline);
    let farthest =
        outline.iter().map(|p| p.distance(start).max(p.distance(end))).fold(0.0, f32::max);
    let reach = 2.0 * (farthest + extent.length());
    let inner = (thinned.len() / END_SHARE).max(1);
    let below = (start - thinned[inner]).try_normalize().unwrap_or(Vec2::NEG_Y);
    let above = (end - thinned[thinned.len() - 1 - inner]).try_normalize().unwrap_or(Vec2::Y);
    let mut out = vec![start + reach * below];
    out.extend(thinned);
    out.push(end + reach * above);
    out
}

/// The part of a polygon from one place to another, against the clock.
fn between(outline: &[Vec2], from: Place, to: Place) -> Vec<Vec2> {
    let n = outline.len();
    let at = |(side, part): Place| outline[side].lerp(outline[(side + 1) % n], part);
    let mut out = vec![at(from)];
    let same_side = from.0 == to.0 && from.1 < to.1;
    let steps = if same_side { 0 } else { (to.0 + n - from.0 - 1) % n + 1 };
    out.extend((1..=steps).map(|step| outline[(from.0 + step) % n]));
    out.push(at(to));
    out
}

/// A line by `n` + 1 points at even distances along it.
fn evenly(line: &[Vec2], n: usize) -> Vec<Vec2> {
    let mut along = Vec::with_capacity(line.len());
    let mut length = 0.0_f32;
    for (i, point) in line.iter().enumerate() {
        length += if i > 0 { point.distance(line[i - 1]) } else { 0.0 };
        along.push(length);
    }
    let mut out = Vec::with_capacity(n + 1);
    let mut i = 0;
    for k in 0..=n {
        let target = k as f32 / n as f32 * length;
        while i + 2 < line.len() && along[i + 1] < target {
            i += 1;
        }
        let (Some(&a), Some(&b)) = (line.get(i), line.get(i + 1)) else {
            out.push(line.first().copied().unwrap_or(Vec2::ZERO));
            continue;
        };
        let step = along[i + 1] - along[i];
        let part = if step > 0.0 { ((target - along[i]) / step).clamp(0.0, 1.0) } else { 0.0 };
        out.push(a.lerp(b, part));
    }
    out
}

/// Middle and half extent of points.
fn bounds(points: &[Vec2]) -> (Vec2, Vec2) {
    let low = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
    let high = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
    let margin = MARGIN * low.abs().max(high.abs()).max_element();
    (0.5 * (low + high), 0.5 * (high - low) + margin)
}
