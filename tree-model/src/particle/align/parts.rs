//! Which of the covered pixels are the tree.

use super::super::matte::Matte;
use super::AlignWarning;
use glam::Vec2;

/// Larger pictures are reduced to this many pixels along their longer side.
const WORKING_SIZE: u32 = 1024;
/// Pixels covered at least so far count.
const COVERED: f32 = 0.3;
/// Gaps up to this share of the picture's longer side are bridged between the parts of one tree.
const BRIDGED: f32 = 0.012;
/// Parts of at least this share of the largest are of the tree, as tufts of a crown are.
const TUFT: f32 = 0.08;
/// Parts apart from the tree are reported from this share of all that is covered.
const REPORTED: f32 = 0.01;

/// Covered cells: pixels, or squares of pixels of a large picture.
pub(super) struct Mask {
    pub(super) nx: usize,
    pub(super) ny: usize,
    /// Pixels for a cell.
    pub(super) cell: f32,
    /// Size of the picture in pixels.
    pub(super) size: Vec2,
    /// Row by row from the top left.
    pub(super) covered: Vec<bool>,
    /// How far each cell is covered.
    pub(super) alpha: Vec<f32>,
}

impl Mask {
    pub(super) fn new(matte: &Matte) -> Self {
        let (width, height) = (matte.width() as usize, matte.height() as usize);
        let cell = matte.width().max(matte.height()).div_ceil(WORKING_SIZE) as usize;
        let (nx, ny) = (width.div_ceil(cell), height.div_ceil(cell));
        let mut alpha = vec![0.0; nx * ny];
        for (y, line) in matte.alpha().chunks_exact(width).enumerate() {
            let row = &mut alpha[y / cell * nx..][..nx];
            for (sum, part) in row.iter_mut().zip(line.chunks(cell)) {
                *sum += part.iter().sum::<f32>() / part.len() as f32;
            }
        }
        for (y, row) in alpha.chunks_exact_mut(nx).enumerate() {
            let lines = cell.min(height - y * cell) as f32;
            row.iter_mut().for_each(|sum| *sum /= lines);
        }
        let covered = alpha.iter().map(|&alpha| alpha >= COVERED).collect();
        let size = Vec2::new(width as f32, height as f32);
        Self { nx, ny, cell: cell as f32, size, covered, alpha }
    }

    pub(super) fn row(&self, y: usize) -> &[bool] {
        &self.covered[y * self.nx..(y + 1) * self.nx]
    }
}

/// The largest part and those nearly as large.
pub(super) fn tree_of(mask: &Mask, warnings: &mut Vec<AlignWarning>) -> Mask {
    let gap = (BRIDGED * 0.5 * mask.nx.max(mask.ny) as f32).round() as usize;
    let (labels, areas) = label(mask, &widened(mask, gap));
    let largest = areas.iter().copied().max().unwrap_or(0);
    let is_tree = |label: u32| {
        areas.get(label as usize).is_some_and(|&area| area as f32 >= TUFT * largest as f32)
    };
    let covered: Vec<bool> =
        mask.covered.iter().zip(&labels).map(|(&covered, &l)| covered && is_tree(l)).collect();
    let n_tree = (0..areas.len() as u32).filter(|&label| is_tree(label)).count();
    if n_tree > 1 {
        warnings.push(AlignWarning::Parts(n_tree));
    }
    let all: usize = areas.iter().sum();
    let out = all - covered.iter().filter(|&&covered| covered).count();
    let share = out as f32 / all.max(1) as f32;
    if share >= REPORTED {
        warnings.push(AlignWarning::LeftOut { parts: areas.len() - n_tree, share });
    }
    let alpha = mask.alpha.iter().zip(&covered).map(|(&a, &covered)| if covered { a } else { 0.0 });
    let alpha = alpha.collect();
    Mask { covered, alpha, ..*mask }
}

/// Cells within `gap` cells of a covered one, across and down.
fn widened(mask: &Mask, gap: usize) -> Vec<bool> {
    let (nx, ny) = (mask.nx, mask.ny);
    let mut across = vec![false; nx * ny];
    for y in 0..ny {
        spread(gap, nx, |x| mask.covered[y * nx + x], |x| across[y * nx + x] = true);
    }
    let mut both = vec![false; nx * ny];
    for x in 0..nx {
        spread(gap, ny, |y| across[y * nx + x], |y| both[y * nx + x] = true);
    }
    both
}

/// Calls `mark` for everything in a line within `gap` of what is `set`.
fn spread(gap: usize, n: usize, set: impl Fn(usize) -> bool, mut mark: impl FnMut(usize)) {
    // What lies before this is marked.
    let mut marked = 0;
    for i in (0..n).filter(|&i| set(i)) {
        let end = (i + gap + 1).min(n);
        (marked.max(i.saturating_sub(gap))..end).for_each(&mut mark);
        marked = marked.max(end);
    }
}

/// The part that each cell belongs to, and the covered cells of each part.
fn label(mask: &Mask, joined: &[bool]) -> (Vec<u32>, Vec<usize>) {
    let (nx, ny) = (mask.nx, mask.ny);
    let mut labels = vec![u32::MAX; nx * ny];
    let mut areas = Vec::new();
    let mut open = Vec::new();
    for start in 0..nx * ny {
        if !joined[start] || labels[start] != u32::MAX {
            continue;
        }
        let part = areas.len() as u32;
        let mut area = 0;
        labels[start] = part;
        open.push(start);
        while let Some(at) = open.pop() {
            area += usize::from(mask.covered[at]);
            let (x, y) = (at % nx, at / nx);
            let beside = [
                (x > 0).then(|| at - 1),
                (x + 1 < nx).then_some(at + 1),
                (y > 0).then(|| at - nx),
                (y + 1 < ny).then_some(at + nx),
            ];
            for next in beside.into_iter().flatten() {
                if joined[next] && labels[next] == u32::MAX {
                    labels[next] = part;
                    open.push(next);
                }
            }
        }
        areas.push(area);
    }
    (labels, areas)
}
