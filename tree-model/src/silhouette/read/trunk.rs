//! The trunk of a silhouette: followed upwards from the foot for as long as it is narrow.
//!
//! As the profile of a matte finds it ([`align`](crate::particle::align)), but along the one stretch of each row that goes on from
//! the row below. So fronds that hang down beside a trunk, and a trunk that leans, do not hide it.

use super::cells::Grid;
use crate::plane::fill;
use glam::Vec2;

/// How much higher a point counts, in heights of the tree, at half the tree's width from its middle, when the foot is
/// sought: more than low branches hang below it.
const ASIDE: f32 = 0.25;
/// The lowest share of the height: roots and rounded ends, of which the trunk's width is not taken.
const FLARE: f32 = 0.02;
/// The trunk's narrowest place is looked for in this lowest share of the height,
const LOWEST: f32 = 0.45;
/// over this share of the height, in which widths are alike.
const STEADY: f32 = 0.03;
/// Widths are alike within this factor.
const ALIKE: f32 = 1.3;
/// Below its narrowest place a trunk is hardly narrower, not by more than this factor; pointed crowns are.
const POINTED: f32 = 1.5;
/// But teeth of roots may be narrow, where something between them and the narrowest place is wider by this factor.
const ROOTS: f32 = 1.2;
/// A trunk is narrower than this share of the tree's width.
const NARROW: f32 = 0.4;
/// One in its own colour is narrower than this share.
const NARROW_GIVEN: f32 = 0.55;
/// The crown begins where the stretch is so many times as wide as the trunk at its narrowest, the second where there is no
/// such place above: twigs that hang down may lead away from the crown,
const WIDER: [f32; 2] = [1.6, 1.25];
/// and wider by this share of the tree's width,
const WIDER_BY: f32 = 0.04;
/// over this share of the height.
const OVER: f32 = 0.02;
/// A trunk is at least this share of the height long.
const SHORTEST: f32 = 0.05;
/// Where the trunk is wider or narrower than its middle width by this factor, by roots or limbs, its middle is that of
/// the nearest place where it is not.
const ODD: f32 = 1.2;
/// The trunk's middle line may deviate by this share of the silhouette's size when corners are left out.
const TOLERANCE: f64 = 0.006;

/// Stretches of rows, from the foot up.
pub(super) struct Trunk {
    /// The lowest row.
    base: usize,
    /// First cell and the one after the last, in the lowest row and each above it.
    runs: Vec<(usize, usize)>,
}

impl Trunk {
    /// The trunk of a silhouette in one part; `None` where it has none.
    pub(super) fn of(grid: &Grid, mask: &[bool]) -> Option<Self> {
        let tree = Extent::of(grid, mask)?;
        let mut trunk = Self::follow(grid, mask, &tree)?;
        let widths: Vec<f32> = trunk.runs.iter().map(|&(from, to)| (to - from) as f32).collect();
        let crown = WIDER.iter().find_map(|&wider| crown_above(&widths, &tree, wider))?;
        trunk.runs.truncate(crown);
        Some(trunk)
    }

    /// The trunk in a mask of nothing else, in one part. `None` where that is wider than a trunk in a silhouette of
    /// this width in cells.
    pub(super) fn given(grid: &Grid, mask: &[bool], full: f32) -> Option<Self> {
        let trunk = Self::follow(grid, mask, &Extent::of(grid, mask)?)?;
        (trunk.median() < NARROW_GIVEN * full).then_some(trunk)
    }

    /// Stretches from the foot to the top.
    fn follow(grid: &Grid, mask: &[bool], tree: &Extent) -> Option<Self> {
        let (column, base) = tree.foot(grid, mask);
        let mut run = run_at(grid, mask, base, column)?;
        let mut runs = vec![run];
        for y in (tree.top..base).rev() {
            let Some(next) = run_above(grid, mask, y, run) else { break };
            run = next;
            runs.push(run);
        }
        Some(Self { base, runs })
    }

    /// Takes the trunk out of a mask, and what lies beside its foot.
    pub(super) fn take_from(&self, grid: &Grid, mask: &mut [bool]) {
        for (i, &(from, to)) in self.runs.iter().enumerate() {
            let row = (self.base - i) * grid.nx;
            mask[row + from..row + to].fill(false);
        }
        // Roots and grass are parts of their own then.
        let foot = (self.base - self.runs.len() / 4) * grid.nx;
        for part in grid.parts(mask) {
            if part.iter().all(|&at| at >= foot) {
                part.into_iter().for_each(|at| mask[at] = false);
            }
        }
    }

    /// The middle line, from the foot up, in units of the drawing.
    pub(super) fn line(&self, grid: &Grid) -> Vec<Vec2> {
        let n = self.runs.len();
        let median = self.median();
        let is_odd = |&(from, to): &(usize, usize)| {
            let width = (to - from) as f32;
            width > ODD * median || width * ODD < median
        };
        // Teeth of roots may be as wide as the trunk: the longest stretch that is not odd is the trunk itself.
        let (mut first, mut longest, mut length) = (0, 0, 0);
        for (i, run) in self.runs.iter().enumerate() {
            length = if is_odd(run) { 0 } else { length + 1 };
            if length > longest {
                (first, longest) = (i + 1 - length, length);
            }
        }
        let mut last = 0.0;
        let mut middles = vec![0.0; n];
        for (i, run) in self.runs.iter().enumerate().skip(first) {
            if i == first || !is_odd(run) {
                last = 0.5 * (run.0 + run.1) as f32;
            }
            middles[i] = last;
        }
        let low = middles[first];
        middles[..first].fill(low);
        // Over some rows: knots make the middle jump.
        let reach = (n / 12).max(1);
        let mut points: Vec<Vec2> = (0..n)
            .map(|i| {
                let reach = reach.min(i).min(n - 1 - i);
                let sum: f32 = middles[i - reach..=i + reach].iter().sum();
                let y = (self.base - i) as f32 + 0.5;
                Vec2::new(sum / (2 * reach + 1) as f32, y)
            })
            .collect();
        if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
            points.insert(0, Vec2::new(first.x, self.base as f32 + 1.0));
            points.push(last - Vec2::new(0.0, 0.5));
        }
        let line: Vec<_> = points.iter().map(|p| p.as_dvec2()).collect();
        let tolerance = TOLERANCE * grid.nx.max(grid.ny) as f64;
        let few = fill::simplify_line(&line, tolerance);
        few.iter().map(|p| grid.to_drawing(p.as_vec2())).collect()
    }

    /// The middle of its widths, in units of the drawing.
    pub(super) fn width(&self, grid: &Grid) -> f32 {
        self.median() * grid.cell
    }

    /// The middle of its widths, in cells.
    fn median(&self) -> f32 {
        let mut widths: Vec<usize> = self.runs.iter().map(|&(from, to)| to - from).collect();
        widths.sort_unstable();
        widths.get(widths.len() / 2).copied().unwrap_or(0) as f32
    }
}

/// How many rows of these widths, from the foot up, are trunk; `None` where none is. The crown is `wider` by this factor.
fn crown_above(widths: &[f32], tree: &Extent, wider: f32) -> Option<usize> {
    let share = |share: f32| ((share * tree.height()).ceil() as usize).max(1);
    let least = |widths: &[f32]| widths.iter().copied().fold(f32::INFINITY, f32::min);
    let most = |widths: &[f32]| widths.iter().copied().fold(0.0, f32::max);
    let full = tree.width();
    let (flare, lowest) = (share(FLARE), share(LOWEST));
    // The narrowest place so far, and its width.
    let mut narrowest: Option<(usize, f32)> = None;
    for row in flare..widths.len() {
        let near = &widths[row..(row + share(STEADY)).min(widths.len())];
        let (low, high) = (least(near), most(near));
        let steady = high <= ALIKE * low && high < NARROW * full && row < lowest;
        if steady && narrowest.is_none_or(|(_, narrow)| high < narrow) {
            narrowest = Some((row, high));
        }
        let Some((at, narrow)) = narrowest else { continue };
        let over = widths.get(row..row + share(OVER))?;
        if least(over) > (wider * narrow).max(narrow + WIDER_BY * full) {
            let below = &widths[flare..at];
            let pointed = least(below) * POINTED < narrow && most(below) < ROOTS * narrow;
            return (!pointed && row >= share(SHORTEST)).then_some(row);
        }
    }
    None
}

/// The rows and columns a mask reaches over, with the ends.
struct Extent {
    top: usize,
    bottom: usize,
    left: usize,
    right: usize,
}

impl Extent {
    fn of(grid: &Grid, mask: &[bool]) -> Option<Self> {
        let mut extent = Self { top: usize::MAX, bottom: 0, left: usize::MAX, right: 0 };
        for at in (0..mask.len()).filter(|&at| mask[at]) {
            let (x, y) = (at % grid.nx, at / grid.nx);
            (extent.top, extent.bottom) = (extent.top.min(y), extent.bottom.max(y));
            (extent.left, extent.right) = (extent.left.min(x), extent.right.max(x));
        }
        (extent.top < usize::MAX).then_some(extent)
    }

    fn height(&self) -> f32 {
        (self.bottom + 1 - self.top) as f32
    }

    fn width(&self) -> f32 {
        (self.right + 1 - self.left) as f32
    }

    /// Column and row of the lowest cell near the middle.
    fn foot(&self, grid: &Grid, mask: &[bool]) -> (usize, usize) {
        let mut best = (f32::NEG_INFINITY, (self.left, self.bottom));
        let middle = 0.5 * (self.left + self.right) as f32;
        for x in self.left..=self.right {
            let covered = |y: &usize| mask[y * grid.nx + x];
            let Some(y) = (self.top..=self.bottom).rev().find(covered) else { continue };
            let aside = 2.0 * (x as f32 - middle) / self.width();
            let score = y as f32 - ASIDE * self.height() * aside * aside;
            if score > best.0 {
                best = (score, (x, y));
            }
        }
        best.1
    }
}

/// The stretch of a row that holds a column.
fn run_at(grid: &Grid, mask: &[bool], row: usize, column: usize) -> Option<(usize, usize)> {
    let cells = &mask[row * grid.nx..][..grid.nx];
    if !cells[column] {
        return None;
    }
    let from = column - cells[..column].iter().rev().take_while(|&&cell| cell).count();
    let to = column + cells[column..].iter().take_while(|&&cell| cell).count();
    Some((from, to))
}

/// The stretch of a row that shares most columns with one below.
fn run_above(
    grid: &Grid,
    mask: &[bool],
    row: usize,
    below: (usize, usize),
) -> Option<(usize, usize)> {
    let mut best = None;
    let mut column = below.0;
    while column < below.1 {
        if let Some(run) = run_at(grid, mask, row, column) {
            let shared = run.1.min(below.1) - run.0.max(below.0);
            if best.is_none_or(|(most, _)| shared > most) {
                best = Some((shared, run));
            }
            column = run.1;
        }
        column += 1;
    }
    best.map(|(_, run)| run)
}
