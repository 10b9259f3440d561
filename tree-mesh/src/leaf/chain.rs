//! A line of few vertices around one side of a leaf, with the least area inside.
//!
//! Vertices lie on a grid of heights and distances; of all lines of at most `n_max` vertices that stay
//! outside of the leaf the one with the least area is found by dynamic programming over their number (as
//! Perez & Vidal 1994 do for polygonal curves). Then each vertex is drawn in until a line beside it
//! touches the leaf.
//!
//! Cost: O(vertices × (heights × distances)²), some milliseconds at most.

use glam::Vec2;

/// Heights that a vertex may have.
const HEIGHTS: usize = 33;
/// Distances that a vertex may have.
const DISTANCES: usize = 25;
/// Farthest vertex, in widths of the leaf: beyond it a line may cut across two bends.
const BEYOND: f32 = 1.2;
/// Rounds of drawing in.
const ROUNDS: usize = 4;

/// The line outside of `reach`, distances at `heights` that rise, as (distance, height) from low to
/// high. No distance is beyond `most`; `n_max` is at least 2.
pub(crate) fn around(heights: &[f32], reach: &[f32], n_max: usize, most: f32) -> Vec<Vec2> {
    let side = Side::new(heights, reach, most);
    let mut line = side.best(n_max.max(2));
    for _ in 0..ROUNDS {
        side.draw_in(&mut line);
    }
    line.into_iter().map(|(row, x)| Vec2::new(x, side.heights[row])).collect()
}

/// One side of a leaf.
struct Side<'a> {
    heights: &'a [f32],
    reach: &'a [f32],
    /// Rows where a vertex may be.
    stops: Vec<usize>,
    /// Widest distance a vertex may have.
    widest: f32,
}

/// The best line of so many vertices that ends in a state, and the state before.
#[derive(Clone, Copy)]
struct Best {
    area: f32,
    before: u32,
}

const NONE: Best = Best { area: f32::INFINITY, before: u32::MAX };

impl<'a> Side<'a> {
    fn new(heights: &'a [f32], reach: &'a [f32], most: f32) -> Self {
        let n = heights.len().min(reach.len());
        let last = n.saturating_sub(1);
        let mut stops: Vec<usize> = (0..HEIGHTS).map(|i| i * last / (HEIGHTS - 1)).collect();
        stops.dedup();
        let far = reach.iter().copied().fold(0.0, f32::max);
        Self {
            heights: &heights[..n],
            reach: &reach[..n],
            stops,
            widest: (far * BEYOND).min(most).max(far),
        }
    }

    fn distance(&self, level: usize) -> f32 {
        self.widest * level as f32 / (DISTANCES - 1) as f32
    }

    /// The least level at or beyond a distance.
    fn level(&self, distance: f32) -> usize {
        let level = distance * (DISTANCES - 1) as f32 / self.widest.max(1e-9);
        libm::ceilf(level - 1e-4).max(0.0) as usize
    }

    fn best(&self, n_max: usize) -> Vec<(usize, f32)> {
        let n_states = self.stops.len() * DISTANCES;
        let first = self.level(self.reach.first().copied().unwrap_or(0.0));
        let mut start = vec![NONE; n_states];
        start.iter_mut().take(DISTANCES).skip(first).for_each(|best| best.area = 0.0);
        let mut tables = vec![start];
        while tables.len() < n_max {
            let next = tables.last().map(|table| self.extend(table)).unwrap_or_default();
            tables.push(next);
        }
        // The end with the least area, of however many vertices.
        let last_stop = n_states - DISTANCES;
        let ends = tables.iter().enumerate().flat_map(|(number, table)| {
            table
                .iter()
                .enumerate()
                .skip(last_stop)
                .map(move |(state, best)| (best.area, number, state))
        });
        let end = ends.min_by(|a, b| a.0.total_cmp(&b.0));
        let (mut number, mut state) = end.map_or((0, 0), |(_, number, state)| (number, state));
        let mut line = Vec::with_capacity(n_max);
        loop {
            line.push((self.stops[state / DISTANCES], self.distance(state % DISTANCES)));
            let before = tables[number][state].before as usize;
            if number == 0 || before >= n_states {
                break;
            }
            (number, state) = (number - 1, before);
        }
        line.reverse();
        line
    }

    /// Adds a vertex to every line of a table.
    fn extend(&self, table: &[Best]) -> Vec<Best> {
        let mut next = vec![NONE; table.len()];
        for (state, best) in table.iter().enumerate().filter(|(_, best)| best.area < f32::INFINITY)
        {
            let (stop, x) = (state / DISTANCES, self.distance(state % DISTANCES));
            let mut row = self.stops[stop];
            let low = self.heights[row];
            let mut slope = f32::NEG_INFINITY;
            for (to, &end) in self.stops.iter().enumerate().skip(stop + 1) {
                while row < end {
                    row += 1;
                    slope = slope.max((self.reach[row] - x) / (self.heights[row] - low).max(1e-9));
                }
                let rise = self.heights[end] - low;
                for level in self.level(x + slope * rise)..DISTANCES {
                    let area = best.area + 0.5 * (x + self.distance(level)) * rise;
                    let slot = &mut next[to * DISTANCES + level];
                    if area < slot.area {
                        *slot = Best { area, before: state as u32 };
                    }
                }
            }
        }
        next
    }

    /// Moves each vertex in until a line beside it touches the leaf.
    fn draw_in(&self, line: &mut [(usize, f32)]) {
        for i in 0..line.len() {
            let (row, x) = line[i];
            let mut least = self.reach[row];
            let mut hold = |(other, fixed): (usize, f32)| {
                let (from, to) = (row.min(other), row.max(other));
                let across = (self.heights[row] - self.heights[other]).abs();
                for k in from + 1..to {
                    let part = (self.heights[k] - self.heights[other]).abs().max(1e-9);
                    least = least.max(fixed + (self.reach[k] - fixed) * across / part);
                }
            };
            if i > 0 {
                hold(line[i - 1]);
            }
            if let Some(&after) = line.get(i + 1) {
                hold(after);
            }
            line[i].1 = least.min(x);
        }
    }
}
