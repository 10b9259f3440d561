//! Step 3b: level lines of the distance field, and how they hang together (a Reeb graph; Y. Shinagawa
//! and T. L. Kunii 1991, here by slices as in A. Verroust and F. Lazarus, *Extracting skeletal curves
//! from 3D scattered data*, 2000).
//!
//! Levels are even. Each connected line on one level is a node: its middle lies on the axis, however
//! long the triangles are, because lines run through triangles. A line hangs on the line below
//! from which an edge, or a patch of surface without line, leads up to it. Where several do, two
//! branches have grown together: the longest line wins and the others end there.

use super::rows::{Rows, Sets};
use super::surface::Surface;
use glam::Vec3;

/// Parent of the first node of a piece.
pub(super) const NONE: u32 = u32::MAX;
/// Most levels in one surface: below, f32 distances run out of steps.
const MAX_LEVELS: f32 = 50_000.0;

/// Nodes, parents first: where the field starts, then lines by level, then where the field ends.
#[derive(Debug, Default)]
pub(super) struct Slices {
    /// Middle of each line.
    pub(super) middles: Vec<Vec3>,
    /// Length of each line; 0 for starts and ends.
    pub(super) lengths: Vec<f32>,
    pub(super) parents: Vec<u32>,
    /// Lines that lead nowhere because what is above hangs on another line.
    pub(super) cut: Vec<bool>,
    /// First of the end nodes.
    pub(super) first_end: u32,
    /// Points of all lines, and how much the line turns at each.
    pub(super) points: Vec<(Vec3, f32)>,
    /// Points of each node.
    pub(super) rows: Option<Rows>,
    /// Distance between levels.
    pub(super) step: f32,
}

/// Where level lines cross edges.
struct Crossings {
    /// Slab between levels in which each vertex lies.
    slabs: Vec<u32>,
    /// First crossing of each edge; those of one edge follow each other upwards.
    starts: Vec<u32>,
    points: Vec<Vec3>,
    levels: Vec<u32>,
}

impl Slices {
    /// Cuts `surface` so that an edge is crossed by `density` levels on average.
    ///
    /// # Complexity
    /// O(density · edges), up to the inverse Ackermann function.
    pub(super) fn new(surface: &Surface, distances: &[f32], density: f32) -> Self {
        let step = step(surface, distances, density);
        let crossings = Crossings::new(surface, distances, step);
        let (line_of, levels, turns, masses) = crossings.lines(surface);
        let n_lines = levels.len();
        let mut lengths = vec![0.0; n_lines];
        let mut moments = vec![Vec3::ZERO; n_lines];
        for ((&line, &point), &mass) in line_of.iter().zip(&crossings.points).zip(&masses) {
            lengths[line as usize] += mass;
            moments[line as usize] += point * mass;
        }
        for (crossing, &line) in line_of.iter().enumerate() {
            // A line around a single vertex at rounding distance has no length.
            if lengths[line as usize] <= 0.0 {
                moments[line as usize] = crossings.points[crossing];
            }
        }
        let patches = Patches::new(surface, &crossings, &line_of, &lengths);
        let mut slices = Self { step, ..Default::default() };
        let mut labels = vec![NONE; surface.positions.len()];
        let starts = patches.nodes(|patch| patches.below[patch] == NONE);
        slices.add_patches(surface, &patches, &starts, &mut labels);
        let first_line = slices.parents.len() as u32;
        for (length, moment) in lengths.iter().zip(&moments) {
            let middle = if *length > 0.0 { *moment / *length } else { *moment };
            slices.push(middle, *length, NONE);
        }
        slices.first_end = slices.parents.len() as u32;
        slices.link_lines(surface, &crossings, &line_of, &patches, first_line, &starts);
        let ends = patches.nodes(|patch| !patches.leads_up[patch] && patches.below[patch] != NONE);
        slices.add_patches(surface, &patches, &ends, &mut labels);
        for (&patch, node) in ends.iter().zip(slices.first_end as usize..) {
            slices.parents[node] = first_line + patches.below[patch as usize];
        }
        slices.find_cut(first_line);
        slices.gather_points(surface, &crossings, &line_of, &turns, first_line, &labels);
        slices
    }

    fn push(&mut self, middle: Vec3, length: f32, parent: u32) {
        self.middles.push(middle);
        self.lengths.push(length);
        self.parents.push(parent);
    }

    /// A node in the middle of each patch; notes it as the label of the patch's vertices.
    fn add_patches(
        &mut self,
        surface: &Surface,
        patches: &Patches,
        of: &[u32],
        labels: &mut [u32],
    ) {
        let first = self.parents.len() as u32;
        let mut node_of = vec![NONE; patches.below.len()];
        for (&patch, node) in of.iter().zip(first..) {
            node_of[patch as usize] = node;
            self.push(Vec3::ZERO, 0.0, NONE);
        }
        let mut counts = vec![0_u32; of.len()];
        for (vertex, &patch) in patches.of.iter().enumerate() {
            let node = node_of[patch as usize];
            if node != NONE {
                labels[vertex] = node;
                counts[(node - first) as usize] += 1;
                self.middles[node as usize] += surface.positions[vertex];
            }
        }
        for (middle, count) in self.middles[first as usize..].iter_mut().zip(counts) {
            *middle /= count as f32;
        }
    }

    /// Hangs each line on the longest line below it.
    fn link_lines(
        &mut self,
        surface: &Surface,
        crossings: &Crossings,
        line_of: &[u32],
        patches: &Patches,
        first_line: u32,
        starts: &[u32],
    ) {
        let mut start_of = vec![NONE; patches.below.len()];
        for (&patch, node) in starts.iter().zip(0..) {
            start_of[patch as usize] = node;
        }
        for edge in 0..surface.edges.len() {
            let row = crossings.of(edge);
            let mut below = crossings.low(surface, edge).map_or(NONE, |vertex| {
                let patch = patches.of[vertex as usize] as usize;
                match patches.below[patch] {
                    NONE => start_of[patch],
                    line => first_line + line,
                }
            });
            for crossing in row {
                let node = first_line + line_of[crossing];
                let old = self.parents[node as usize];
                let longer = |a: u32, b: u32| {
                    let length = |n: u32| self.lengths[n as usize];
                    length(a) > length(b) || (length(a) >= length(b) && a < b)
                };
                if below != NONE && below != node && (old == NONE || longer(below, old)) {
                    self.parents[node as usize] = below;
                }
                below = node;
            }
        }
    }

    fn find_cut(&mut self, first_line: u32) {
        self.cut = vec![false; self.parents.len()];
        self.cut[first_line as usize..self.first_end as usize].fill(true);
        for &parent in self.parents.iter().filter(|&&parent| parent != NONE) {
            self.cut[parent as usize] = false;
        }
    }

    fn gather_points(
        &mut self,
        surface: &Surface,
        crossings: &Crossings,
        line_of: &[u32],
        turns: &[Vec3],
        first_line: u32,
        labels: &[u32],
    ) {
        let mut nodes = Vec::with_capacity(line_of.len());
        for ((&line, &point), turn) in line_of.iter().zip(&crossings.points).zip(turns) {
            nodes.push(first_line + line);
            self.points.push((point, turn.length()));
        }
        for (&node, &position) in labels.iter().zip(&surface.positions) {
            if node != NONE {
                nodes.push(node);
                // Weighing by distance leaves the middle of a cap out.
                self.points.push((position, position.distance(self.middles[node as usize])));
            }
        }
        self.rows = Some(Rows::new(&nodes, self.parents.len()));
    }

    /// Points of one node.
    pub(super) fn points_of(&self, node: u32) -> impl Iterator<Item = (Vec3, f32)> + '_ {
        let row = self.rows.as_ref().map_or(&[][..], |rows| rows.of(node));
        row.iter().map(|&point| self.points[point as usize])
    }
}

/// Distance between levels.
fn step(surface: &Surface, distances: &[f32], density: f32) -> f32 {
    let mut sum = 0.0_f64;
    for &[a, b] in &surface.edges {
        sum += f64::from((distances[a as usize] - distances[b as usize]).abs());
    }
    let most = distances.iter().fold(0.0_f32, |most, &d| most.max(d));
    let even = (sum / (f64::from(density) * surface.edges.len().max(1) as f64)) as f32;
    even.max(most / MAX_LEVELS).max(f32::MIN_POSITIVE)
}

impl Crossings {
    fn new(surface: &Surface, distances: &[f32], step: f32) -> Self {
        let slabs: Vec<u32> = distances.iter().map(|d| (d / step + 0.5) as u32).collect();
        let mut starts = Vec::with_capacity(surface.edges.len() + 1);
        starts.push(0);
        let (mut points, mut levels) = (Vec::new(), Vec::new());
        for &[a, b] in &surface.edges {
            let (low, high) = if slabs[a as usize] <= slabs[b as usize] { (a, b) } else { (b, a) };
            let (from, to) = (distances[low as usize], distances[high as usize]);
            for level in slabs[low as usize]..slabs[high as usize] {
                let share = ((level as f32 + 0.5) * step - from) / (to - from);
                let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
                let (low, high) =
                    (surface.positions[low as usize], surface.positions[high as usize]);
                points.push(low.lerp(high, share));
                levels.push(level);
            }
            starts.push(points.len() as u32);
        }
        Self { slabs, starts, points, levels }
    }

    /// Crossings of one edge, upwards.
    fn of(&self, edge: usize) -> std::ops::Range<usize> {
        self.starts[edge] as usize..self.starts[edge + 1] as usize
    }

    /// The lower end of an edge that is crossed.
    fn low(&self, surface: &Surface, edge: usize) -> Option<u32> {
        let [a, b] = surface.edges[edge];
        let (at_a, at_b) = (self.slabs[a as usize], self.slabs[b as usize]);
        (at_a != at_b).then_some(if at_a < at_b { a } else { b })
    }

    /// The crossing of an edge at a level it is known to cross.
    fn at(&self, edge: u32, level: u32) -> usize {
        let first = self.starts[edge as usize] as usize;
        first + (level - self.levels[first]) as usize
    }

    /// Joins crossings through triangles. Returns the line of each crossing and the level of each
    /// line, lines sorted by level; for each crossing the sum of unit vectors along the line away
    /// from it (which vanishes where the line is straight), and half the length of line next to it.
    fn lines(&self, surface: &Surface) -> (Vec<u32>, Vec<u32>, Vec<Vec3>, Vec<f32>) {
        let n = self.points.len();
        let (mut sets, mut turns, mut masses) = (Sets::new(n), vec![Vec3::ZERO; n], vec![0.0; n]);
        for (corners, edges) in surface.triangles.iter().zip(&surface.edges_of) {
            // Edge i joins corners i and i + 1: opposite is corner i + 2.
            let slab = corners.map(|corner| self.slabs[corner as usize]);
            let span = |i: usize| slab[i].abs_diff(slab[(i + 1) % 3]);
            let long = (0..3).max_by_key(|&i| (span(i), i)).unwrap_or(0);
            let (start, end, middle) = (long, (long + 1) % 3, (long + 2) % 3);
            let (low_edge, high_edge) = if slab[start] <= slab[end] {
                (edges[middle], edges[end])
            } else {
                (edges[end], edges[middle])
            };
            for level in slab[start].min(slab[end])..slab[start].max(slab[end]) {
                let short = if level < slab[middle] { low_edge } else { high_edge };
                let (a, b) = (self.at(edges[long], level), self.at(short, level));
                sets.join(a as u32, b as u32);
                let run = self.points[b] - self.points[a];
                let length = run.length();
                let along = run / length.max(f32::MIN_POSITIVE);
                turns[a] += along;
                turns[b] -= along;
                masses[a] += 0.5 * length;
                masses[b] += 0.5 * length;
            }
        }
        let (mut line_of, n_lines) = sets.labels();
        let mut levels = vec![0; n_lines];
        for (&line, &level) in line_of.iter().zip(&self.levels) {
            levels[line as usize] = level;
        }
        let mut order: Vec<u32> = (0..n_lines as u32).collect();
        order.sort_by_key(|&line| levels[line as usize]);
        let mut rank = vec![0; n_lines];
        for (&line, number) in order.iter().zip(0..) {
            rank[line as usize] = number;
        }
        line_of.iter_mut().for_each(|line| *line = rank[*line as usize]);
        levels.sort_unstable();
        (line_of, levels, turns, masses)
    }
}

/// Connected vertices of one slab.
struct Patches {
    /// Patch of each vertex.
    of: Vec<u32>,
    /// Longest line below each patch.
    below: Vec<u32>,
    /// Whether a line lies above.
    leads_up: Vec<bool>,
}

impl Patches {
    fn new(surface: &Surface, crossings: &Crossings, line_of: &[u32], lengths: &[f32]) -> Self {
        let slabs = &crossings.slabs;
        let mut sets = Sets::new(slabs.len());
        for &[a, b] in &surface.edges {
            if slabs[a as usize] == slabs[b as usize] {
                sets.join(a, b);
            }
        }
        let (of, n) = sets.labels();
        let (mut below, mut leads_up) = (vec![NONE; n], vec![false; n]);
        for (edge, &[a, b]) in surface.edges.iter().enumerate() {
            let row = crossings.of(edge);
            let (Some(low), Some(last)) = (crossings.low(surface, edge), row.last()) else {
                continue;
            };
            let high = if low == a { b } else { a };
            leads_up[of[low as usize] as usize] = true;
            let slot = &mut below[of[high as usize] as usize];
            let line = line_of[last];
            if *slot == NONE || lengths[line as usize] > lengths[*slot as usize] {
                *slot = line;
            }
        }
        Self { of, below, leads_up }
    }

    fn nodes(&self, which: impl Fn(usize) -> bool) -> Vec<u32> {
        (0..self.below.len()).filter(|&patch| which(patch)).map(|patch| patch as u32).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::field::march;
    use super::super::surface::tests::{surface_of, tube};
    use super::*;

    fn slice(mesh: &(Vec<Vec3>, Vec<u32>), n_seeds: u32, density: f32) -> Slices {
        let surface = surface_of(mesh);
        let seeds: Vec<_> = (0..n_seeds).map(|v| (v, 0.0)).collect();
        Slices::new(&surface, &march(&surface, &surface.fans(), &seeds), density)
    }

    #[test]
    fn lines_of_a_tube_lie_on_its_axis_one_above_the_other() {
        let slices = slice(&tube(&[(Vec3::ZERO, 0.3), (Vec3::Y * 4.0, 0.3)], 6), 6, 8.0);
        assert!(slices.parents.len() > 8, "{}", slices.parents.len());
        for (node, &parent) in slices.parents.iter().enumerate() {
            assert_eq!(parent, if node == 0 { NONE } else { node as u32 - 1 });
            assert!(slices.middles[node].with_y(0.0).length() < 1e-5);
        }
        assert!((slices.middles[slices.middles.len() - 1].y - 4.0).abs() < 1e-5, "the end is kept");
        let mid = slices.parents.len() as u32 / 2;
        assert!((slices.lengths[mid as usize] - 1.8).abs() < 1e-4, "a hexagon's girth");
        // Six corners, and points on straight sides that do not count.
        let weight: f32 = slices.points_of(mid).map(|(_, turn)| turn).sum();
        assert!((weight - 6.0).abs() < 1e-2, "{weight}");
    }

    #[test]
    fn a_ring_is_cut_open_where_its_halves_meet() {
        // A torus: the field runs both ways round and meets itself.
        let turn = |i: u32| libm::sincosf(i as f32 * std::f32::consts::TAU / 16.0);
        let points: Vec<_> =
            (0..=16).map(|i| (Vec3::new(turn(i % 16).0, 0.0, turn(i % 16).1), 0.2)).collect();
        let (mut positions, mut indices) = tube(&points, 6);
        positions.truncate(96);
        indices.iter_mut().for_each(|i| *i %= 96);
        let slices = slice(&(positions, indices), 6, 6.0);
        let roots = slices.parents.iter().filter(|&&parent| parent == NONE).count();
        assert_eq!(roots, 1);
        // At the start, and perhaps in the last bit of surface.
        let forks = (0..slices.parents.len() as u32)
            .filter(|&n| slices.parents.iter().filter(|&&parent| parent == n).count() > 1);
        assert!((1..=2).contains(&forks.count()));
    }
}
