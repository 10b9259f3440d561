//! Filled contours become cells that know how far they are covered.

use super::cells::Grid;
use glam::Vec2;

/// Lines through each row of cells on which what is covered is measured.
const LINES: usize = 4;

/// Tells for each cell that contours cover, by the even-odd or the non-zero rule, how far, 0 to 1.
///
/// O(rows passed by sides · log + cells covered).
pub(super) fn paint(
    grid: &Grid,
    contours: &[Vec<Vec2>],
    even_odd: bool,
    mut visit: impl FnMut(usize, f32),
) {
    let lines = grid.ny * LINES;
    let line = |y: f32| {
        let y = grid.to_cells(Vec2::new(0.0, y)).y;
        ((y * LINES as f32 - 0.5).ceil().max(0.0) as usize).min(lines)
    };
    let heights = || contours.iter().flatten().map(|p| p.y);
    let first = line(heights().fold(f32::INFINITY, f32::min)) / LINES * LINES;
    let last = line(heights().fold(f32::NEG_INFINITY, f32::max)).max(first);
    // Crossings by line: x in cells, and up or down.
    let mut crossings: Vec<Vec<(f32, i32)>> = vec![Vec::new(); last - first];
    for contour in contours {
        let next = contour.iter().skip(1).chain(contour.first());
        for (&from, &to) in contour.iter().zip(next) {
            let (a, b) = (grid.to_cells(from), grid.to_cells(to));
            for at in line(from.y.min(to.y))..line(from.y.max(to.y)) {
                let y = (at as f32 + 0.5) / LINES as f32;
                let x = a.x + ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0) * (b.x - a.x);
                crossings[at - first].push((x, if a.y < b.y { 1 } else { -1 }));
            }
        }
    }
    let mut row = vec![0.0; grid.nx];
    for (i, lines) in crossings.chunks_mut(LINES).enumerate() {
        let (mut low, mut high) = (grid.nx, 0);
        for met in lines {
            met.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let (mut winding, mut from) = (0_i32, 0.0);
            for &(x, turn) in met.iter() {
                let was = is_inside(winding, even_odd);
                winding += turn;
                match (was, is_inside(winding, even_odd)) {
                    (false, true) => from = x,
                    (true, false) => {
                        let cells = add(&mut row, from, x);
                        (low, high) = (low.min(cells.start), high.max(cells.end));
                    }
                    _ => {}
                }
            }
        }
        let start = (first / LINES + i) * grid.nx;
        for (x, cell) in row.iter_mut().enumerate().take(high).skip(low) {
            let part = std::mem::take(cell);
            if part > 0.0 {
                visit(start + x, part.min(1.0));
            }
        }
    }
}

/// Whether a mask's cells are covered by half.
pub(super) fn mask(grid: &Grid, contours: &[Vec<Vec2>]) -> Vec<bool> {
    let mut mask = vec![false; grid.nx * grid.ny];
    paint(grid, contours, false, |at, part| mask[at] = part >= 0.5);
    mask
}

fn is_inside(winding: i32, even_odd: bool) -> bool {
    if even_odd { winding % 2 != 0 } else { winding != 0 }
}

/// Adds a stretch of one line to a row; the cells it touches.
fn add(row: &mut [f32], from: f32, to: f32) -> std::ops::Range<usize> {
    let (from, to) = (from.clamp(0.0, row.len() as f32), to.clamp(0.0, row.len() as f32));
    let cells = from as usize..(to.ceil() as usize).max(from as usize);
    for (x, cell) in row.iter_mut().enumerate().take(cells.end).skip(cells.start) {
        let part = (to.min(x as f32 + 1.0) - from.max(x as f32)).max(0.0);
        *cell += part / LINES as f32;
    }
    cells
}
