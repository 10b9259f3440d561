//! The border of covered cells, between their centres (marching squares, Lorensen & Cline 1987 in the plane).

use super::cells::Grid;
use crate::plane::arrange;
use crate::plane::fill::{self, Frame};
use glam::{DVec2, Vec2};

/// A cell covered this far is inside.
pub(super) const HALF: f32 = 0.5;

/// Most corners of a border.
const MOST_CORNERS: usize = 400;

/// No way on.
const NONE: u32 = u32::MAX;

/// The longest border, in units of the drawing, closed, its inside to the same side all along; empty where nothing is
/// covered. Values beyond the cells count as 0.
pub(super) fn border(grid: &Grid, cover: &[f32]) -> Vec<Vec2> {
    let (nx, ny) = (grid.nx, grid.ny);
    // Sides between centres: 2 · cell to the right of it, 2 · cell + 1 below it.
    let mut next = vec![NONE; 2 * nx * ny];
    for y in 0..ny.saturating_sub(1) {
        for x in 0..nx - 1 {
            let at = y * nx + x;
            let sides = [2 * at, 2 * (at + 1) + 1, 2 * (at + nx), 2 * at + 1];
            let corners = [at, at + 1, at + nx + 1, at + nx].map(|c| cover[c] >= HALF);
            // Round the square: out of the inside over one side, back in over the next. Where two corners
            // opposite each other are inside, they are parted.
            for i in 0..4 {
                if !corners[i] || corners[(i + 1) % 4] {
                    continue;
                }
                let back = (1..4).map(|k| (i + 4 - k) % 4);
                let mut entering = back.filter(|&j| !corners[j] && corners[(j + 1) % 4]);
                if let Some(j) = entering.next() {
                    next[sides[i]] = sides[j] as u32;
                }
            }
        }
    }
    let mut best = Vec::new();
    let mut largest = 0.0;
    for start in 0..next.len() {
        if next[start] == NONE {
            continue;
        }
        let mut ring = Vec::new();
        let mut at = start;
        while next[at] != NONE {
            ring.push(crossing(grid, cover, at));
            at = std::mem::replace(&mut next[at], NONE) as usize;
        }
        let area = fill::area(&ring).abs();
        if area > largest {
            (best, largest) = (ring, area);
        }
    }
    best.iter().map(|&p| grid.to_drawing(p.as_vec2())).collect()
}

/// Where the border crosses a side, in cells.
fn crossing(grid: &Grid, cover: &[f32], side: usize) -> DVec2 {
    let at = side / 2;
    let (x, y) = (at % grid.nx, at / grid.nx);
    let (way, to) =
        if side.is_multiple_of(2) { (DVec2::X, at + 1) } else { (DVec2::Y, at + grid.nx) };
    let (a, b) = (f64::from(cover[at]), f64::from(cover[to]));
    let part = ((f64::from(HALF) - a) / (b - a)).clamp(0.0, 1.0);
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5) + part * way
}

/// A closed line without the corners that lie within `tolerance` (in its own units) of what is kept; more are left out
/// until there are few enough. One that does not cross itself still does not.
pub(super) fn simplified(ring: &[Vec2], tolerance: f32) -> Vec<Vec2> {
    let points: Vec<DVec2> = ring.iter().map(|p| p.as_dvec2()).collect();
    let mut tolerance = f64::from(tolerance);
    let back = |points: &[DVec2]| points.iter().map(|p| p.as_vec2()).collect::<Vec<Vec2>>();
    let mut few = fill::simplify(&points, tolerance);
    while few.len() > MOST_CORNERS {
        tolerance *= 1.3;
        few = fill::simplify(&points, tolerance);
    }
    // Leaving out corners may make sides cross where the shape is thin: then less is left out.
    let mut simple = back(&few);
    for _ in 0..8 {
        if !crosses(&simple) {
            break;
        }
        tolerance *= 0.6;
        simple = back(&fill::simplify(&points, tolerance));
    }
    simple
}

fn crosses(ring: &[Vec2]) -> bool {
    Frame::of(&[ring.to_vec()]).is_none_or(|(_, framed)| arrange::crossings(&framed, 1) > 0)
}
