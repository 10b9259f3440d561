//! The edges of triangles, each with the half-edges that run along it.
//!
//! Half-edge 3t + k runs from corner k of triangle t to its next corner. Half-edges are put in rows of
//! their lower point and sorted by the higher one: no hash map, and numbers that depend on the
//! triangles alone.

/// No half-edge.
pub(crate) const NONE: u32 = u32::MAX;

/// Edges of a list of triangles. Half-edges must fit u32.
#[derive(Debug, Default)]
pub(crate) struct Edges {
    /// The edge of each half-edge.
    pub(crate) of: Vec<u32>,
    /// Where the half-edges of each edge start in `halves`, and the end.
    pub(crate) starts: Vec<u32>,
    /// Half-edges by edge, lowest first.
    pub(crate) halves: Vec<u32>,
}

impl Edges {
    pub(crate) fn new(triangles: &[[u32; 3]], n_points: usize) -> Self {
        let mut rows = vec![0_u32; n_points + 1];
        for_each(triangles, |_, low, _| rows[low as usize] += 1);
        let mut sum = 0;
        for row in &mut rows {
            sum += *row;
            *row = sum;
        }
        let mut keys = vec![0_u64; 3 * triangles.len()];
        for_each(triangles, |half, low, high| {
            let slot = &mut rows[low as usize];
            *slot -= 1;
            keys[*slot as usize] = u64::from(high) << 32 | u64::from(half);
        });
        let mut edges = Self {
            of: vec![0; keys.len()],
            starts: Vec::with_capacity(keys.len() / 2 + 1),
            halves: Vec::with_capacity(keys.len()),
        };
        for point in 0..n_points {
            let row = &mut keys[rows[point] as usize..rows[point + 1] as usize];
            row.sort_unstable();
            for group in row.chunk_by(|a, b| a >> 32 == b >> 32) {
                for &key in group {
                    edges.of[key as u32 as usize] = edges.starts.len() as u32;
                }
                edges.starts.push(edges.halves.len() as u32);
                edges.halves.extend(group.iter().map(|&key| key as u32));
            }
        }
        edges.starts.push(edges.halves.len() as u32);
        edges
    }

    pub(crate) fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// The half-edges along an edge.
    pub(crate) fn halves(&self, edge: usize) -> &[u32] {
        &self.halves[self.starts[edge] as usize..self.starts[edge + 1] as usize]
    }

    /// The half-edge on the other side, where two triangles that face the same way share the edge.
    pub(crate) fn twin(&self, half: u32, triangles: &[[u32; 3]]) -> u32 {
        match *self.halves(self.of[half as usize] as usize) {
            [a, b] if start(triangles, a) != start(triangles, b) => a ^ b ^ half,
            _ => NONE,
        }
    }
}

/// The next half-edge of the triangle.
pub(crate) const fn next(half: u32) -> u32 {
    if half % 3 == 2 { half - 2 } else { half + 1 }
}

/// The half-edge before it in the triangle.
pub(crate) const fn before(half: u32) -> u32 {
    if half.is_multiple_of(3) { half + 2 } else { half - 1 }
}

/// The point a half-edge leaves.
pub(crate) fn start(triangles: &[[u32; 3]], half: u32) -> u32 {
    triangles.as_flattened()[half as usize]
}

/// The point a half-edge runs to.
pub(crate) fn end(triangles: &[[u32; 3]], half: u32) -> u32 {
    start(triangles, next(half))
}

fn for_each(triangles: &[[u32; 3]], mut visit: impl FnMut(u32, u32, u32)) {
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        for (k, (from, to)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            visit((3 * t + k) as u32, from.min(to), from.max(to));
        }
    }
}
