//! Fast marching: the cheapest way to a point from everywhere in a grid (Sethian 1996, *A fast marching
//! level set method for monotonically advancing fronts*).
//!
//! Unlike a shortest path over voxels, the distances have no preference for the axes, and so neither have
//! the directions. O(n log n).

use super::super::grid::Grid;
use crate::error::Result;
use glam::IVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use tree_core::Control;

/// Voxels between two looks at the cancel flag.
const PATIENCE: usize = 1 << 14;

/// Cost of the cheapest way from the centre of each voxel to that of `start`, where `costs` holds the
/// cost of a metre, above 0, in each voxel.
pub(super) fn march(costs: &Grid, start: usize, control: &Control) -> Result<Vec<f32>> {
    let mut times = vec![f32::INFINITY; costs.values().len()];
    let mut settled = vec![false; times.len()];
    // The bits of a float that is not negative sort as the float does.
    let mut front = BinaryHeap::new();
    times[start] = 0.0;
    front.push(Reverse((0.0_f32.to_bits(), start as u32)));
    let mut n_settled = 0_usize;
    while let Some(Reverse((_, at))) = front.pop() {
        let at = at as usize;
        if std::mem::replace(&mut settled[at], true) {
            continue;
        }
        n_settled += 1;
        if n_settled.is_multiple_of(PATIENCE) {
            control.check()?;
        }
        for next in neighbours(costs, at).into_iter().flatten() {
            if settled[next] {
                continue;
            }
            let time = arrival(costs, &times, next);
            if time < times[next] {
                times[next] = time;
                front.push(Reverse((time.to_bits(), next as u32)));
            }
        }
    }
    Ok(times)
}

/// The six neighbours of a voxel: below and above along x, y, z.
pub(super) fn neighbours(grid: &Grid, at: usize) -> [Option<usize>; 6] {
    let voxel = grid.voxel_of(at);
    [IVec3::NEG_X, IVec3::X, IVec3::NEG_Y, IVec3::Y, IVec3::NEG_Z, IVec3::Z]
        .map(|step| grid.index(voxel + step))
}

/// When the front reaches a voxel, by the upwind scheme: the root of Σ (t − tₐ)² = (cost × side)² over the
/// axes along which it comes.
fn arrival(costs: &Grid, times: &[f32], at: usize) -> f32 {
    let near = neighbours(costs, at).map(|n| n.map_or(f32::INFINITY, |n| times[n]));
    let mut axes = [near[0].min(near[1]), near[2].min(near[3]), near[4].min(near[5])];
    axes.sort_unstable_by(f32::total_cmp);
    let way = costs.values()[at] * costs.voxel();
    let mut time = axes[0] + way;
    let (mut sum, mut squares) = (axes[0], axes[0] * axes[0]);
    for (n, &next) in (2_u8..).zip(&axes[1..]) {
        if time <= next {
            break;
        }
        sum += next;
        squares += next * next;
        let n = f32::from(n);
        let root = (sum * sum - n * (squares - way * way)).max(0.0).sqrt();
        time = (sum + root) / n;
    }
    time
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{UVec3, Vec3};
    use tree_core::Limits;

    fn grid(n: u32) -> Grid {
        let mut grid = Grid::new(Vec3::ZERO, 0.5, UVec3::splat(n), &Limits::default()).unwrap();
        grid.values_mut().fill(1.0);
        grid
    }

    #[test]
    fn in_the_open_the_way_is_the_straight_one() {
        let grid = grid(21);
        let center = IVec3::splat(10);
        let start = grid.index(center).unwrap();
        let times = march(&grid, start, &Control::default()).unwrap();
        for (i, &time) in times.iter().enumerate() {
            let exact = grid.center(grid.voxel_of(i)).distance(grid.center(center));
            // First order: the error is largest near the start, and never more than a voxel and a half.
            assert!((time - exact).abs() < 0.75, "{time} for {exact}");
        }
    }

    #[test]
    fn a_wall_is_gone_round_when_that_is_cheaper() {
        let mut grid = grid(11);
        for i in 0..grid.values().len() {
            let voxel = grid.voxel_of(i);
            if voxel.x == 5 && voxel.y < 8 {
                grid.values_mut()[i] = 100.0;
            }
        }
        let start = grid.index(IVec3::new(0, 0, 5)).unwrap();
        let far = grid.index(IVec3::new(10, 0, 5)).unwrap();
        let times = march(&grid, start, &Control::default()).unwrap();
        let straight = 5.0;
        assert!(times[far] > 1.5 * straight && times[far] < 3.0 * straight, "{}", times[far]);
    }
}
