//! The solid that a drawn profile sweeps when it turns about an axis.
//!
//! In the half-plane of (radius, height) the profile is closed to the axis by a level line at both
//! ends, and a point is inside when a level ray outwards crosses it an odd number of times. Level
//! pieces never count (half-open rule on the heights), so the closing lines need no storage there.
//! Cost: bins of height keep the segments a ray can meet, a handful for a drawn outline.

use super::axial::signed;
use super::check;
use super::math::{Meridian, segment_distance_squared_2d};
use crate::bounds::Aabb;
use crate::error::{CoreError, Result};
use glam::{DVec2, DVec3, Vec2, Vec3};
use std::f64::consts::PI;

/// Most bins of height. More would cost memory and no longer shorten the few segments per bin.
const MAX_BINS: usize = 4096;

/// Entries in the bins for each segment. Profiles that jump up and down all the time would fill
/// (segments x bins) entries; with fewer, wider bins they stay below this.
const MAX_ENTRIES_PER_SEGMENT: usize = 8;

/// The compiled profile.
#[derive(Debug)]
pub(super) struct Revolution {
    meridian: Meridian,
    /// (radius, height), as drawn.
    profile: Vec<DVec2>,
    low: f64,
    bins_per_metre: f64,
    /// Segments of bin `b` are `entries[starts[b]..starts[b + 1]]`; a segment is named by its start.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Revolution {
    pub(super) fn new(base: Vec3, axis: Vec3, profile: &[Vec2]) -> Result<Self> {
        let base = check::point("revolution.base", base)?;
        let axis = check::direction("revolution", "revolution.axis", axis)?;
        if profile.is_empty() {
            return Err(CoreError::Empty { what: "revolution.profile" });
        }
        for (index, point) in profile.iter().enumerate() {
            if !point.is_finite() {
                return Err(CoreError::NotFinite { field: "revolution.profile", index });
            }
            crate::error::check_range("revolution.profile", index, point.x, 0.0, f32::MAX)?;
        }
        if profile.len() > u32::MAX as usize / MAX_ENTRIES_PER_SEGMENT {
            return Err(check::problem("revolution", "the profile has too many points"));
        }
        let profile: Vec<DVec2> = profile.iter().map(|p| p.as_dvec2()).collect();
        let (low, high) =
            profile.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
                (low.min(p.y), high.max(p.y))
            });
        if low == high {
            return Err(check::problem(
                "revolution",
                "all profile points have the same height: at least two heights are needed",
            ));
        }
        if profile.iter().all(|p| p.x == 0.0) {
            return Err(check::problem(
                "revolution",
                "the whole profile lies on the axis: some radius must be positive",
            ));
        }
        let mut solid = Self {
            meridian: Meridian { base, axis },
            profile,
            low,
            bins_per_metre: 0.0,
            starts: Vec::new(),
            entries: Vec::new(),
        };
        solid.fill_bins(high - low);
        Ok(solid)
    }

    fn fill_bins(&mut self, height: f64) {
        let n_segments = self.profile.len() - 1;
        let mut n_bins = n_segments.next_power_of_two().min(MAX_BINS);
        loop {
            self.bins_per_metre = n_bins as f64 / height;
            let mut counts = vec![0_usize; n_bins];
            for segment in 0..n_segments {
                for bin in self.bins_of(segment, n_bins) {
                    counts[bin] += 1;
                }
            }
            let total: usize = counts.iter().sum();
            if n_bins == 1 || total <= MAX_ENTRIES_PER_SEGMENT * n_segments {
                let mut end = 0;
                self.starts = vec![0];
                self.starts.extend(counts.iter().map(|&count| {
                    end += count as u32;
                    end
                }));
                break;
            }
            n_bins /= 2;
        }
        let mut next = self.starts.clone();
        self.entries = vec![0; next[n_bins] as usize];
        for segment in 0..n_segments {
            for bin in self.bins_of(segment, n_bins) {
                self.entries[next[bin] as usize] = segment as u32;
                next[bin] += 1;
            }
        }
    }

    /// Never falls as `height` rises, so a segment is in the bin of every height it spans.
    #[inline]
    fn bin(&self, height: f64, n_bins: usize) -> usize {
        // `as` takes NaN and what is below the range to 0.
        (((height - self.low) * self.bins_per_metre) as usize).min(n_bins - 1)
    }

    /// Bins that a level ray through the segment can be in; none for a level segment.
    fn bins_of(&self, segment: usize, n_bins: usize) -> std::ops::Range<usize> {
        let (a, b) = (self.profile[segment].y, self.profile[segment + 1].y);
        if a == b {
            return 0..0;
        }
        self.bin(a.min(b), n_bins)..self.bin(a.max(b), n_bins) + 1
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.contains_2d(self.meridian.of(p))
    }

    #[inline]
    fn contains_2d(&self, q: DVec2) -> bool {
        let bin = self.bin(q.y, self.starts.len() - 1);
        let entries = &self.entries[self.starts[bin] as usize..self.starts[bin + 1] as usize];
        let mut inside = false;
        for &segment in entries {
            let (a, b) = (self.profile[segment as usize], self.profile[segment as usize + 1]);
            if (a.y <= q.y) != (b.y <= q.y) {
                // From the lower end up, so that direction of drawing does not matter.
                let (low, high) = if a.y <= q.y { (a, b) } else { (b, a) };
                let outside = (q.x - low.x) * (high.y - low.y) >= (high.x - low.x) * (q.y - low.y);
                inside ^= !outside;
            }
        }
        inside
    }

    /// Nearest of all pieces of the outline: the profile, and the level lines that close it.
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let q = self.meridian.of(p);
        let mut square = f64::INFINITY;
        let mut meet = |a: DVec2, b: DVec2| {
            square = square.min(segment_distance_squared_2d(q, a, b));
        };
        for side in self.profile.windows(2) {
            // A piece on the axis bounds nothing: the solid is on all sides of it.
            if side[0].x > 0.0 || side[1].x > 0.0 {
                meet(side[0], side[1]);
            }
        }
        if let (Some(&first), Some(&last)) = (self.profile.first(), self.profile.last()) {
            if first.y == last.y {
                // Both closing lines on one level: where they overlap they cancel.
                meet(first, last);
            } else {
                meet(first, DVec2::new(0.0, first.y));
                meet(last, DVec2::new(0.0, last.y));
            }
        }
        signed(square.sqrt(), self.contains_2d(q))
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.meridian.bounds_of_discs(self.profile.iter().copied())
    }

    /// Frusta under the profile, those drawn downwards taken away again (Pappus, Guldin).
    pub(super) fn measure(&self) -> f64 {
        let sum: f64 = self
            .profile
            .windows(2)
            .map(|side| {
                let (a, b) = (side[0], side[1]);
                (b.y - a.y) * (a.x * a.x + a.x * b.x + b.x * b.x)
            })
            .sum();
        (PI / 3.0 * sum).abs()
    }
}
