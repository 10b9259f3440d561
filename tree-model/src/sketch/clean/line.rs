//! Polylines that are asked for what is nearest.

use super::sample::closest;
use super::tidy::Extent;
use glam::Vec2;

/// Segments in a box.
const BLOCK: usize = 16;

/// A polyline with boxes around runs of its segments.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) points: Vec<Vec2>,
    extent: Extent,
    blocks: Vec<Extent>,
}

/// A place on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// Index of the point before.
    pub(super) segment: u32,
    /// Share of the way to the next.
    pub(super) share: f32,
    pub(super) distance: f32,
}

impl Line {
    pub(super) fn new(points: Vec<Vec2>) -> Self {
        let n = points.len();
        let blocks = (0..n.saturating_sub(1))
            .step_by(BLOCK)
            .map(|from| Extent::of(&points[from..(from + BLOCK + 1).min(n)]))
            .collect();
        Self { extent: Extent::of(&points), points, blocks }
    }

    /// The place nearest to a point, if it is nearer than `below`. O(1) where the line's box is farther.
    pub(super) fn nearest(&self, point: Vec2, below: f32) -> Option<Place> {
        if self.extent.distance(point) >= below {
            return None;
        }
        let mut best: Option<Place> = None;
        let mut least = below;
        for (block, extent) in self.blocks.iter().enumerate() {
            if extent.distance(point) >= least {
                continue;
            }
            let from = block * BLOCK;
            let pairs = self.points[from..].windows(2).take(BLOCK).enumerate();
            for (i, pair) in pairs {
                let (share, distance) = closest(point, pair[0], pair[1]);
                if distance < least {
                    least = distance;
                    let segment = (from + i) as u32;
                    best = Some(Place { segment, share, distance });
                }
            }
        }
        best
    }

    /// Where a place is.
    pub(super) fn position(&self, place: &Place) -> Vec2 {
        let i = place.segment as usize;
        match (self.points.get(i), self.points.get(i + 1)) {
            (Some(&a), Some(&b)) => a.lerp(b, place.share),
            _ => self.points.get(i).copied().unwrap_or_default(),
        }
    }

    /// The place of an end: the first point, or the last.
    pub(super) fn end(&self, last: bool) -> Vec2 {
        let end = if last { self.points.last() } else { self.points.first() };
        end.copied().unwrap_or_default()
    }
}
