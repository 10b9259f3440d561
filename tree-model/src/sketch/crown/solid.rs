//! The surface of local revolution (Okabe, Owada & Igarashi 2005, section 4).
//!
//! Between the heights of two corners that follow each other the polygons are trapezoids. In each the middle and the
//! half-width change linearly with height, so its surface is a (slanted, elliptic) cone, and where a straight way leaves
//! it is the root of a quadratic equation: no steps, and the same answer as [`Solid::level`] gives.

use glam::{DVec3, Vec2, Vec3};

/// Rows of equal height that say where to look for the band of a height.
const ROWS: usize = 512;

/// Ways that begin this little outside, as a share of the half-width, count as inside: rounding.
const ROUNDING: f64 = 1e-6;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Solid {
    /// Heights between which bands lie, rising.
    heights: Vec<f64>,
    /// Where the trapezoids of each band begin; one more than there are bands.
    starts: Vec<u32>,
    trapezoids: Vec<Trapezoid>,
    /// The band at the foot of each row.
    rows: Vec<u32>,
    rows_per_metre: f64,
    /// Depth over width.
    depth: f64,
}

/// A stretch of a band: ends of its foot, and how they move with height.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Trapezoid {
    left: f64,
    right: f64,
    left_slope: f64,
    right_slope: f64,
}

/// A side of a polygon, from its lower end.
struct Side {
    low: (f64, f64),
    high: (f64, f64),
}

impl Side {
    fn slope(&self) -> f64 {
        (self.high.0 - self.low.0) / (self.high.1 - self.low.1)
    }

    fn at(&self, y: f64) -> f64 {
        self.low.0 + self.slope() * (y - self.low.1)
    }
}

impl Solid {
    /// Of simple polygons that lie apart. O(corners · sides at a height).
    pub(super) fn of(polygons: &[Vec<Vec2>], depth: f32) -> Self {
        let corners = || polygons.iter().flatten();
        let mut heights: Vec<f64> = corners().map(|p| f64::from(p.y)).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup();
        let mut sides = sides(polygons);
        sides.sort_by(|a, b| a.low.1.total_cmp(&b.low.1));
        let mut waiting = sides.into_iter().peekable();
        let mut active: Vec<Side> = Vec::new();
        let (mut starts, mut trapezoids) = (vec![0], Vec::new());
        for band in heights.windows(2) {
            let (foot, top) = (band[0], band[1]);
            active.retain(|side| side.high.1 >= top);
            while let Some(side) = waiting.next_if(|side| side.low.1 <= foot) {
                active.push(side);
            }
            let middle = 0.5 * (foot + top);
            active.sort_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
            trapezoids.extend(active.chunks_exact(2).map(|pair| Trapezoid {
                left: pair[0].at(foot),
                right: pair[1].at(foot),
                left_slope: pair[0].slope(),
                right_slope: pair[1].slope(),
            }));
            starts.push(trapezoids.len() as u32);
        }
        let (low, high) = (heights.first(), heights.last());
        let height = high.zip(low).map_or(0.0, |(high, low)| high - low);
        let rows_per_metre = if height > 0.0 { ROWS as f64 / height } else { 0.0 };
        let low = low.copied().unwrap_or(0.0);
        let row = |i: usize| {
            let foot = low + i as f64 / rows_per_metre;
            heights.partition_point(|&h| h <= foot).saturating_sub(1) as u32
        };
        let rows = (0..ROWS).map(row).collect();
        Self { rows, heights, starts, trapezoids, rows_per_metre, depth: f64::from(depth) }
    }

    /// The band a height lies in.
    fn band(&self, y: f64) -> Option<usize> {
        let (&low, &high) = (self.heights.first()?, self.heights.last()?);
        if !(y >= low && y < high) {
            return None;
        }
        let row = ((y - low) * self.rows_per_metre) as usize;
        let mut band = *self.rows.get(row.min(ROWS - 1))? as usize;
        // The row's number is rounded.
        while band > 0 && self.heights[band] > y {
            band -= 1;
        }
        while band + 2 < self.heights.len() && self.heights[band + 1] <= y {
            band += 1;
        }
        Some(band)
    }

    fn stretches(&self, band: usize) -> &[Trapezoid] {
        &self.trapezoids[self.starts[band] as usize..self.starts[band + 1] as usize]
    }

    /// Share of the way from the axis to the surface in the stretch that holds the point's x; `None` where none does.
    pub(super) fn level(&self, point: Vec3) -> Option<f32> {
        let (x, half) = self.across(point.truncate())?;
        let z = f64::from(point.z) / (half * self.depth);
        Some((x * x + z * z).sqrt() as f32)
    }

    /// See [`Crown::half_depth`](super::Crown::half_depth).
    pub(super) fn half_depth(&self, point: Vec2) -> Option<f32> {
        let (x, half) = self.across(point)?;
        Some((half * self.depth * (1.0 - x * x).max(0.0).sqrt()) as f32)
    }

    /// Where a point of the plan is across its stretch, -1 to 1, and half the stretch's width.
    fn across(&self, point: Vec2) -> Option<(f64, f64)> {
        let point = point.as_dvec2();
        let band = self.band(point.y)?;
        let up = point.y - self.heights[band];
        for stretch in self.stretches(band) {
            let left = stretch.left + up * stretch.left_slope;
            let right = stretch.right + up * stretch.right_slope;
            if point.x >= left && point.x < right {
                let half = 0.5 * (right - left);
                return Some(((point.x - 0.5 * (left + right)) / half, half));
            }
        }
        None
    }

    /// See [`Crown::exit`](super::Crown::exit).
    pub(super) fn exit(&self, from: Vec3, to: Vec3) -> Option<f32> {
        let (origin, way) = (from.as_dvec3(), (to - from).as_dvec3());
        if !self.level(from).is_some_and(|level| level <= 1.0) {
            return Some(0.0);
        }
        let Some(mut band) = self.band(origin.y) else { return Some(0.0) };
        let mut t = 0.0;
        loop {
            let (foot, top) = (self.heights[band], self.heights[band + 1]);
            // Where the way leaves the band.
            let end = if way.y > 0.0 {
                (top - origin.y) / way.y
            } else if way.y < 0.0 {
                (foot - origin.y) / way.y
            } else {
                1.0
            };
            let Some(surface) = self.around(band, origin, way, t) else { return Some(t as f32) };
            let leaves = surface.leaves(t);
            if leaves < end.min(1.0) {
                return Some(leaves as f32);
            }
            if end >= 1.0 {
                return None;
            }
            t = end.max(t);
            let next = if way.y > 0.0 { band.checked_add(1) } else { band.checked_sub(1) };
            match next.filter(|next| next + 1 < self.heights.len()) {
                Some(next) => band = next,
                // Below the lowest level and above the highest there is nothing.
                None => return Some(t as f32),
            }
        }
    }

    /// The surface of the stretch that the way is in at `t`.
    fn around(&self, band: usize, origin: DVec3, way: DVec3, t: f64) -> Option<Surface> {
        let up = origin.y - self.heights[band];
        self.stretches(band).iter().find_map(|stretch| {
            let surface = Surface::of(stretch, up, origin, way, self.depth);
            surface.holds(t).then_some(surface)
        })
    }

    /// Volume of all stretches: cones with elliptic sections.
    pub(super) fn volume(&self) -> f64 {
        let mut volume = 0.0;
        for (band, pair) in self.heights.windows(2).enumerate() {
            let height = pair[1] - pair[0];
            for stretch in self.stretches(band) {
                let foot = 0.5 * (stretch.right - stretch.left);
                let top = foot + 0.5 * height * (stretch.right_slope - stretch.left_slope);
                volume += height * (foot * foot + foot * top + top * top) / 3.0;
            }
        }
        std::f64::consts::PI * self.depth * volume
    }
}

fn sides(polygons: &[Vec<Vec2>]) -> Vec<Side> {
    let mut out = Vec::new();
    for polygon in polygons {
        let next = polygon.iter().cycle().skip(1);
        for (a, b) in polygon.iter().zip(next) {
            let (a, b) = ((f64::from(a.x), f64::from(a.y)), (f64::from(b.x), f64::from(b.y)));
            if a.1 != b.1 {
                out.push(if a.1 < b.1 {
                    Side { low: a, high: b }
                } else {
                    Side { low: b, high: a }
                });
            }
        }
    }
    out
}

/// (x − m)² + (z / depth)² − r² along a way, as a polynomial of its parameter t, and r² for rounding.
struct Surface {
    squared: f64,
    linear: f64,
    constant: f64,
    half: (f64, f64),
}

impl Surface {
    fn of(stretch: &Trapezoid, up: f64, origin: DVec3, way: DVec3, depth: f64) -> Self {
        let left = (stretch.left + up * stretch.left_slope, way.y * stretch.left_slope);
        let right = (stretch.right + up * stretch.right_slope, way.y * stretch.right_slope);
        let half = (0.5 * (right.0 - left.0), 0.5 * (right.1 - left.1));
        let x = (origin.x - 0.5 * (left.0 + right.0), way.x - 0.5 * (left.1 + right.1));
        let z = (origin.z / depth, way.z / depth);
        Self {
            squared: x.1 * x.1 + z.1 * z.1 - half.1 * half.1,
            linear: 2.0 * (x.0 * x.1 + z.0 * z.1 - half.0 * half.1),
            constant: x.0 * x.0 + z.0 * z.0 - half.0 * half.0,
            half,
        }
    }

    /// Whether the way is inside at `t`.
    fn holds(&self, t: f64) -> bool {
        let half = self.half.0 + t * self.half.1;
        (self.squared * t + self.linear) * t + self.constant <= ROUNDING * half * half
    }

    /// Where it first goes outside after `t`, at which it is inside.
    fn leaves(&self, t: f64) -> f64 {
        // a t² + 2 b t + c.
        let (a, b, c) = (self.squared, 0.5 * self.linear, self.constant);
        let squared = b * b - a * c;
        if squared < 0.0 {
            return if a > 0.0 { t } else { f64::INFINITY };
        }
        // The roots without cancellation.
        let q = if b > 0.0 { -b - squared.sqrt() } else { squared.sqrt() - b };
        let (one, other) = (q / a, c / q);
        if a > 0.0 {
            return one.max(other).max(t);
        }
        if a == 0.0 {
            return if b > 0.0 { other.max(t) } else { f64::INFINITY };
        }
        // Outside between the roots.
        let (low, high) = (one.min(other), one.max(other));
        if t < high { low.max(t) } else { f64::INFINITY }
    }
}
