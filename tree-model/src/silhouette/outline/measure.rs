//! Outlines measured: along their length, in rows, and against each other.

use super::{Outline, area};
use glam::{Vec2, Vec3Swizzles as _};

/// Rows over which the area that two outlines have in common is taken.
const ROWS: usize = 128;

impl Outline {
    /// The point at a length along it, in metres against the clock from the first corner; below 0 and beyond the
    /// perimeter it goes on round. O(log points).
    #[must_use]
    pub fn along(&self, length: f32) -> Vec2 {
        let (i, part) = self.place(length);
        let (a, b) = self.side(i);
        a.lerp(b, part)
    }

    /// The direction against the clock at a length along it, of unit length; smooth between the middles of its sides.
    /// The inside is to the left. O(log points).
    #[must_use]
    pub fn tangent(&self, length: f32) -> Vec2 {
        let (i, part) = self.place(length);
        let n = self.points.len();
        let direction = |i: usize| {
            let (a, b) = self.side(i);
            (b - a).normalize_or_zero()
        };
        let here = direction(i);
        let other = direction(if part < 0.5 { i + n - 1 } else { i + 1 } % n);
        here.lerp(other, (part - 0.5).abs()).try_normalize().unwrap_or(here)
    }

    /// The length along it of the place nearest to a point, and how far that is from the point, in metres. O(points).
    #[must_use]
    pub fn nearest(&self, point: Vec2) -> (f32, f32) {
        let mut best = (0.0, f32::INFINITY);
        for (i, (a, b)) in self.sides().enumerate() {
            let way = b - a;
            let part = ((point - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let distance = point.distance(a + part * way);
            if distance < best.1 {
                best = (self.along[i] + part * (self.end_of(i) - self.along[i]), distance);
            }
        }
        best
    }

    /// Points of the stretch from one length along it to another, both ends among them. `to` may exceed the perimeter
    /// where the stretch passes the first corner; it ends after once round. One point where `to` is not above `from`. O(points).
    #[must_use]
    pub fn part(&self, from: f32, to: f32) -> Vec<Vec2> {
        let start = self.wrap(from);
        let length = (to - from).min(self.perimeter);
        let mut points = vec![self.along(start)];
        if length > 0.0 {
            let n = self.points.len();
            let first = self.along.partition_point(|&a| a <= start);
            for i in first..first + n {
                let round = if i < n { 0.0 } else { self.perimeter };
                if self.along[i % n] + round >= start + length {
                    break;
                }
                points.push(self.points[i % n]);
            }
            points.push(self.along(start + length));
            points.dedup();
        }
        points
    }

    /// The same outline by `n` points at even lengths, 3 at least, from the first corner on. Where so few points would
    /// make it cross itself, it stays as it is. O(points + n log n).
    #[must_use]
    pub fn resampled(&self, n: usize) -> Self {
        let n = n.max(3);
        let at = |i: usize| self.along(self.perimeter * i as f32 / n as f32);
        Self::from_points((0..n).map(at).collect()).unwrap_or_else(|_| self.clone())
    }

    /// The outline with every corner moved by `map`, turned against the clock where that mirrors it; `None` where
    /// corners are not finite then, or nothing is enclosed. Meant for maps that keep lines straight: others may make
    /// it cross itself, which is not looked for. O(points).
    #[must_use]
    pub fn transformed(&self, map: impl Fn(Vec2) -> Vec2) -> Option<Self> {
        let mut points: Vec<Vec2> = self.points.iter().map(|&p| map(p)).collect();
        points.dedup();
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        let enclosed = area(&points);
        if points.len() < 3 || !enclosed.is_finite() || enclosed == 0.0 {
            return None;
        }
        if enclosed < 0.0 {
            points[1..].reverse();
        }
        Some(Self::of_simple(points))
    }

    /// Which of the `width` by `height` cells between `low` and `high` have their centres inside, row by row from the
    /// lowest, each from the left. O(points + rows passed by the sides + cells).
    #[must_use]
    pub fn mask(&self, low: Vec2, high: Vec2, width: usize, height: usize) -> Vec<bool> {
        let cell = (high - low) / Vec2::new(width as f32, height as f32);
        let rows = Rows::of(self, low.y + 0.5 * cell.y, cell.y, height);
        let mut mask = vec![false; width * height];
        // The number of cells whose centres are left of x.
        let column = |x: f32| (((x - low.x) / cell.x - 0.5).ceil().max(0.0) as usize).min(width);
        for (y, row) in mask.chunks_exact_mut(width.max(1)).enumerate() {
            for span in rows.spans(y) {
                row[column(span[0])..column(span[1]).max(column(span[0]))].fill(true);
            }
        }
        mask
    }

    /// Area that two outlines have in common, in square metres, over 128 rows: within about 1 %. O(points of both +
    /// rows passed by their sides): some microseconds.
    #[must_use]
    pub fn overlap(&self, other: &Self) -> f32 {
        let ((low, high), (low_2, high_2)) = (self.bounds(), other.bounds());
        let (low, high) = (low.max(low_2), high.min(high_2));
        if low.cmpge(high).any() {
            return 0.0;
        }
        self.shared(other, low.y, high.y).z
    }

    /// Area that two outlines have in common over the area they cover together, 0 to 1; 1 for an outline and itself.
    /// As [`overlap`](Self::overlap).
    #[must_use]
    pub fn iou(&self, other: &Self) -> f32 {
        let ((low, high), (low_2, high_2)) = (self.bounds(), other.bounds());
        let areas = self.shared(other, low.y.min(low_2.y), high.y.max(high_2.y));
        let union = areas.xy().element_sum() - areas.z;
        if union > 0.0 { (areas.z / union).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Areas of this, the other and both between two heights.
    fn shared(&self, other: &Self, low: f32, high: f32) -> glam::Vec3 {
        let step = (high - low) / ROWS as f32;
        let [one, two] = [self, other].map(|o| Rows::of(o, low + 0.5 * step, step, ROWS));
        let mut lengths = glam::Vec3::ZERO;
        for row in 0..ROWS {
            let mut others = two.spans(row).iter().copied().peekable();
            lengths.y += two.spans(row).iter().map(|span| span[1] - span[0]).sum::<f32>();
            for &[from, to] in one.spans(row) {
                lengths.x += to - from;
                while let Some(&[start, end]) = others.peek() {
                    lengths.z += (to.min(end) - from.max(start)).max(0.0);
                    if end > to {
                        break;
                    }
                    others.next();
                }
            }
        }
        lengths * step
    }

    /// A length brought to once round.
    fn wrap(&self, length: f32) -> f32 {
        let wrapped = length.rem_euclid(self.perimeter);
        // A NaN is not below anything; a tiny negative length wraps to the perimeter itself.
        if wrapped < self.perimeter { wrapped } else { 0.0 }
    }

    /// The side a length lies on, and how far along it, 0 to 1.
    fn place(&self, length: f32) -> (usize, f32) {
        let length = self.wrap(length);
        let i = self.along.partition_point(|&a| a <= length).max(1) - 1;
        let side = self.end_of(i) - self.along[i];
        (i, if side > 0.0 { ((length - self.along[i]) / side).min(1.0) } else { 0.0 })
    }

    fn side(&self, i: usize) -> (Vec2, Vec2) {
        (self.points[i], self.points[(i + 1) % self.points.len()])
    }

    /// The length along it at which side `i` ends.
    fn end_of(&self, i: usize) -> f32 {
        self.along.get(i + 1).copied().unwrap_or(self.perimeter)
    }
}

/// What an outline covers of rows of equal distance.
struct Rows {
    /// Where the spans of each row begin, and the end of the last.
    starts: Vec<u32>,
    /// From x to x, from the left.
    spans: Vec<[f32; 2]>,
}

impl Rows {
    /// `n` rows, the first at a height, `step` apart.
    fn of(outline: &Outline, first: f32, step: f32, n: usize) -> Self {
        // The number of rows below a height: a side meets those from its lower end to below its upper.
        let below = |y: f32| (((y - first) / step).ceil().max(0.0) as usize).min(n);
        let met = |a: Vec2, b: Vec2| below(a.y.min(b.y))..below(a.y.max(b.y));
        let mut starts = vec![0_u32; n + 1];
        for (a, b) in outline.sides() {
            met(a, b).for_each(|row| starts[row + 1] += 1);
        }
        for row in 0..n {
            starts[row + 1] += starts[row];
        }
        let mut next = starts.clone();
        let mut at = vec![0.0_f32; starts[n] as usize];
        for (a, b) in outline.sides() {
            for row in met(a, b) {
                let part = ((first + row as f32 * step - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                at[next[row] as usize] = a.x + part * (b.x - a.x);
                next[row] += 1;
            }
        }
        // A closed line meets every row an even number of times.
        for row in 0..n {
            at[starts[row] as usize..starts[row + 1] as usize].sort_unstable_by(f32::total_cmp);
        }
        starts.iter_mut().for_each(|start| *start /= 2);
        Self { starts, spans: at.as_chunks().0.to_vec() }
    }

    fn spans(&self, row: usize) -> &[[f32; 2]] {
        &self.spans[self.starts[row] as usize..self.starts[row + 1] as usize]
    }
}
