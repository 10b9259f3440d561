//! Cells over a silhouette: parts, holes, bridges and gaps.

use glam::Vec2;

/// Cells along the longer side of what is looked at.
pub(super) const ALONG: usize = 400;

/// Empty cells round it: more than gaps are closed over.
pub(super) const MARGIN: usize = 24;

/// Squares in rows, y down.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    pub(super) nx: usize,
    pub(super) ny: usize,
    /// The corner of the first cell in the drawing.
    pub(super) low: Vec2,
    /// The side of a cell in units of the drawing.
    pub(super) cell: f32,
}

impl Grid {
    /// Cells over a rectangle, none smaller than `least`; `None` where it has no size.
    pub(super) fn over(low: Vec2, high: Vec2, least: f32) -> Option<Self> {
        let size = (high - low).max_element();
        let cell = (size / ALONG as f32).max(least);
        if !(size > 0.0 && size.is_finite() && cell > 0.0 && low.is_finite()) {
            return None;
        }
        let n = |size: f32| ((size / cell).ceil() as usize).clamp(1, ALONG + 1) + 2 * MARGIN;
        let (nx, ny) = (n(high.x - low.x), n(high.y - low.y));
        Some(Self { nx, ny, low: low - cell * MARGIN as f32, cell })
    }

    #[cfg(feature = "svg")]
    pub(super) fn to_cells(self, point: Vec2) -> Vec2 {
        (point - self.low) / self.cell
    }

    pub(super) fn to_drawing(self, point: Vec2) -> Vec2 {
        self.low + point * self.cell
    }

    /// The four neighbours of a cell.
    fn around(self, at: usize) -> impl Iterator<Item = usize> {
        let (x, y) = (at % self.nx, at / self.nx);
        let sides = [
            (x > 0).then(|| at - 1),
            (x + 1 < self.nx).then(|| at + 1),
            (y > 0).then(|| at - self.nx),
            (y + 1 < self.ny).then(|| at + self.nx),
        ];
        sides.into_iter().flatten()
    }

    /// Everything joined to `start` through cells like it, marked as seen.
    fn flood(self, start: usize, mask: &[bool], seen: &mut [bool]) -> Vec<usize> {
        let mut part = vec![start];
        seen[start] = true;
        let mut next = 0;
        while let Some(&at) = part.get(next) {
            next += 1;
            for to in self.around(at) {
                if !seen[to] && mask[to] == mask[start] {
                    seen[to] = true;
                    part.push(to);
                }
            }
        }
        part
    }

    /// Fills what is enclosed; how many cells that were.
    pub(super) fn fill_holes(self, mask: &mut [bool]) -> usize {
        let mut seen = vec![false; mask.len()];
        // The margin is empty and goes all round.
        self.flood(0, mask, &mut seen);
        let mut count = 0;
        for (cell, seen) in mask.iter_mut().zip(seen) {
            if !*cell && !seen {
                *cell = true;
                count += 1;
            }
        }
        count
    }

    /// The parts of a mask, the largest first.
    pub(super) fn parts(self, mask: &[bool]) -> Vec<Vec<usize>> {
        let mut seen = vec![false; mask.len()];
        let mut parts = Vec::new();
        for start in 0..mask.len() {
            if mask[start] && !seen[start] {
                parts.push(self.flood(start, mask, &mut seen));
            }
        }
        parts.sort_by_key(|part| std::cmp::Reverse(part.len()));
        parts
    }

    /// The largest part, and those of at least `least` cells joined to it by bridges of at most `reach` cells. Also
    /// how many were joined.
    pub(super) fn bridge(self, mask: &[bool], reach: usize, least: usize) -> (Vec<bool>, usize) {
        let mut kept = vec![false; mask.len()];
        let mut free = vec![false; mask.len()];
        let parts = self.parts(mask);
        let Some(first) = parts.first() else { return (kept, 0) };
        parts.iter().filter(|part| part.len() >= least).flatten().for_each(|&at| free[at] = true);
        // Cells by how far they lie from what is kept, and where they were come to from.
        let mut open: Vec<Vec<(usize, usize)>> = vec![Vec::new(); reach + 2];
        open[0] = first.iter().map(|&at| (at, at)).collect();
        let mut from = vec![usize::MAX; mask.len()];
        let mut bridges = 0;
        while let Some(gap) = open.iter().position(|cells| !cells.is_empty()) {
            let Some((at, before)) = open[gap].pop() else { break };
            if kept[at] || (gap > 0 && from[at] != usize::MAX) {
                continue;
            }
            from[at] = before;
            if free[at] {
                if gap > 0 {
                    bridges += 1;
                    self.lay(&mut kept, &free, &from, before);
                }
                kept[at] = true;
                open[0]
                    .extend(self.around(at).filter(|&to| free[to] && !kept[to]).map(|to| (to, at)));
            }
            let gap = if free[at] { 1 } else { gap + 1 };
            if gap <= reach + 1 {
                open[gap].extend(self.around(at).filter(|&to| !kept[to]).map(|to| (to, at)));
            }
        }
        (kept, bridges)
    }

    /// Marks the way back to what is kept, three cells wide.
    fn lay(self, kept: &mut [bool], free: &[bool], from: &[usize], mut at: usize) {
        while !kept[at] {
            kept[at] = true;
            let before = from[at];
            // Parts still free are come to in their own time.
            self.around(at).filter(|&to| to != before && !free[to]).for_each(|to| kept[to] = true);
            at = before;
        }
    }

    /// Cells within a distance of a cell of the mask. O(cells · distance).
    fn grown(self, mask: &[bool], distance: f32) -> Vec<bool> {
        let far = usize::MAX / 2;
        // Distance in the column.
        let mut height = vec![far; mask.len()];
        for at in 0..mask.len() {
            let above = if at >= self.nx { height[at - self.nx] + 1 } else { far };
            height[at] = if mask[at] { 0 } else { above.min(far) };
        }
        for at in (0..mask.len().saturating_sub(self.nx)).rev() {
            height[at] = height[at].min(height[at + self.nx] + 1);
        }
        let reach = distance as usize;
        // How high the disc is at each distance to the side.
        let tall: Vec<usize> = (0..=reach)
            .map(|x| (distance * distance - (x * x) as f32).max(0.0).sqrt() as usize)
            .collect();
        let mut out = vec![false; mask.len()];
        for (row, heights) in out.chunks_exact_mut(self.nx).zip(height.chunks_exact(self.nx)) {
            for (x, cell) in row.iter_mut().enumerate() {
                let (left, right) = (x.saturating_sub(reach), (x + reach).min(self.nx - 1));
                *cell = (left..=right).any(|to| heights[to] <= tall[x.abs_diff(to)]);
            }
        }
        out
    }

    /// Gaps of up to twice the distance are closed.
    pub(super) fn closed(self, mask: &[bool], distance: f32) -> Vec<bool> {
        let grown = self.grown(mask, distance);
        let outside: Vec<bool> = grown.iter().map(|cell| !cell).collect();
        self.grown(&outside, distance).iter().map(|cell| !cell).collect()
    }

    /// What is thinner than twice the distance is left out.
    pub(super) fn opened(self, mask: &[bool], distance: f32) -> Vec<bool> {
        let outside: Vec<bool> = mask.iter().map(|cell| !cell).collect();
        self.closed(&outside, distance).iter().map(|cell| !cell).collect()
    }
}
