//! Segments of wood in a uniform grid, to find the nearest ones to a point.

use super::rows::Rows;
use glam::Vec3;

/// At most this many cells for each segment.
const CELLS_PER_SEGMENT: f32 = 8.0;
/// A segment is noted in the cells of points this share of a cell apart.
const SAMPLE_SHARE: f32 = 0.5;

/// A piece of wood between two nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// Lower end and radius there.
    pub(super) a: (Vec3, f32),
    pub(super) b: (Vec3, f32),
}

impl Segment {
    /// Share of the way from `a` to `b` of the place nearest to a point.
    pub(super) fn nearest(&self, point: Vec3) -> f32 {
        let run = self.b.0 - self.a.0;
        let share = (point - self.a.0).dot(run) / run.length_squared();
        // A segment without length gives NaN.
        if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Place and radius at a share of the way.
    pub(super) fn at(&self, share: f32) -> (Vec3, f32) {
        (self.a.0.lerp(self.b.0, share), self.a.1 + share * (self.b.1 - self.a.1))
    }
}

/// Segments in a grid.
#[derive(Debug)]
pub(super) struct Near {
    pub(super) segments: Vec<Segment>,
    low: Vec3,
    cell: f32,
    dims: [u32; 3],
    rows: Rows,
}

impl Near {
    pub(super) fn new(segments: Vec<Segment>) -> Self {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut total = 0.0;
        for segment in &segments {
            low = low.min(segment.a.0).min(segment.b.0);
            high = high.max(segment.a.0).max(segment.b.0);
            total += segment.a.0.distance(segment.b.0);
        }
        let size = (high - low).max(Vec3::ZERO);
        let n = segments.len().max(1) as f32;
        let mut cell = (total / n).max(1e-4 * size.max_element()).max(f32::MIN_POSITIVE);
        let dims = |cell: f32| (size / cell).to_array().map(|n| n.floor() + 1.0);
        while dims(cell).iter().product::<f32>() > CELLS_PER_SEGMENT * n + 64.0 {
            cell *= 1.26; // half the cells
        }
        let dims = dims(cell).map(|n| n as u32);
        let mut near = Self { segments, low, cell, dims, rows: Rows::new(&[], 1) };
        let mut pairs = Vec::new();
        for (segment, number) in near.segments.iter().zip(0..) {
            let length = segment.a.0.distance(segment.b.0);
            let n = (length / (SAMPLE_SHARE * cell)).ceil().max(1.0) as u32;
            let mut last = u32::MAX;
            for i in 0..=n {
                let key = near.number(near.cell_of(segment.at(i as f32 / n as f32).0));
                if key != last {
                    pairs.push((key, number));
                }
                last = key;
            }
        }
        let n_cells = dims.iter().map(|&n| n as usize).product();
        near.rows = Rows::of_pairs(pairs.iter().copied(), n_cells);
        near
    }

    fn cell_of(&self, point: Vec3) -> [u32; 3] {
        let at = ((point - self.low) / self.cell).to_array();
        // A cast from float saturates.
        std::array::from_fn(|i| (at[i] as u32).min(self.dims[i] - 1))
    }

    fn number(&self, [x, y, z]: [u32; 3]) -> u32 {
        (z * self.dims[1] + y) * self.dims[0] + x
    }

    /// Calls `visit` with segments, near ones first, until all that come are at least `reach` away;
    /// `visit` returns the reach from then on. A segment may come more than once.
    pub(super) fn search(&self, point: Vec3, mut reach: f32, mut visit: impl FnMut(u32) -> f32) {
        let center = self.cell_of(point);
        let most = self.dims.iter().copied().max().unwrap_or(0);
        for ring in 0..=most {
            // Samples lie a quarter cell from any point of their segment at most.
            if ring > 0 && ((ring - 1) as f32 - 0.5 * SAMPLE_SHARE) * self.cell >= reach {
                return;
            }
            self.ring(center, ring, &mut |segment| reach = visit(segment));
        }
    }

    /// All segments in the shell of cells `ring` cells away.
    fn ring(&self, center: [u32; 3], ring: u32, visit: &mut dyn FnMut(u32)) {
        let low = center.map(|c| c.saturating_sub(ring));
        let high: [u32; 3] = std::array::from_fn(|i| (center[i] + ring).min(self.dims[i] - 1));
        let on = |i: usize, at: u32| center[i].abs_diff(at) == ring;
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                let whole = on(2, z) || on(1, y);
                let mut x = low[0];
                while x <= high[0] {
                    if whole || on(0, x) {
                        for &segment in self.rows.of(self.number([x, y, z])) {
                            visit(segment);
                        }
                        x += 1;
                    } else {
                        // From one side of the shell to the other.
                        x = x.max(center[0] + ring);
                    }
                }
            }
        }
    }

    /// The segment nearest to a point, the share along it and the distance.
    pub(super) fn nearest(&self, point: Vec3) -> Option<(u32, f32, f32)> {
        let mut best: Option<(u32, f32, f32)> = None;
        self.search(point, f32::INFINITY, |number| {
            let segment = self.segments[number as usize];
            let share = segment.nearest(point);
            let distance = segment.at(share).0.distance(point);
            let nearer =
                |(other, _, d): (u32, f32, f32)| distance < d || (distance <= d && number < other);
            if best.is_none_or(nearer) {
                best = Some((number, share, distance));
            }
            best.map_or(f32::INFINITY, |(_, _, distance)| distance)
        });
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_segment_is_the_nearest(
            ends in prop::collection::vec([-1.0_f32..1.0, -0.1..0.1, -1.0..1.0, -1.0..1.0], 1..60),
            point in [-2.0_f32..2.0, -2.0..2.0, -2.0..2.0],
        ) {
            let segments: Vec<Segment> = ends
                .iter()
                .map(|&[x, y, z, w]| Segment {
                    a: (Vec3::new(x, y, z), 1.0),
                    b: (Vec3::new(z, x, w), 1.0),
                })
                .collect();
            let point = Vec3::from_array(point);
            let distance = |s: &Segment| s.at(s.nearest(point)).0.distance(point);
            let least = segments.iter().map(distance).fold(f32::INFINITY, f32::min);
            let (_, _, found) = Near::new(segments.clone()).nearest(point).unwrap();
            prop_assert_eq!(found, least);
        }
    }
}
