//! Step 4: how far every point is from the base, along the tree.
//!
//! Dijkstra's search. What an arc costs grows faster than its length (Livny et al. 2010 take powers
//! too): of two ways, the one in many short steps runs along a branch, the one in few long ones jumps
//! between branches. The distance that levels are made of is the plain length of the way that was chosen.

use super::graph::Graph;
use glam::Vec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

pub(super) const NONE: u32 = u32::MAX;

/// The way of every point to the base.
#[derive(Debug)]
pub(super) struct Ways {
    /// Next point towards the base; itself at the base; `NONE` where none leads.
    pub(super) next: Vec<u32>,
    /// Length of the way in metres; infinite where none leads.
    pub(super) length: Vec<f32>,
    /// Which base the way ends at.
    pub(super) base: Vec<u32>,
    /// Points in the order of their cost.
    pub(super) order: Vec<u32>,
}

/// Searches from points of bases: (point, base, length to start with).
pub(super) fn reach(
    graph: &Graph,
    points: &[Vec3],
    spacing: f32,
    starts: &[(u32, u32, f32)],
) -> Ways {
    let n = points.len();
    let mut bridges = vec![Vec::new(); graph.bridges.len().min(1) * n];
    for &[a, b] in &graph.bridges {
        bridges[a as usize].push(b);
        bridges[b as usize].push(a);
    }
    let mut ways = Ways {
        next: vec![NONE; n],
        length: vec![f32::INFINITY; n],
        base: vec![NONE; n],
        order: Vec::new(),
    };
    let mut cost = vec![f32::INFINITY; n];
    let mut done = vec![false; n];
    // Bits of floats that are not negative are ordered like the floats.
    let mut queue = BinaryHeap::new();
    for &(point, base, length) in starts {
        let i = point as usize;
        if length < cost[i] {
            (cost[i], ways.length[i], ways.base[i], ways.next[i]) = (length, length, base, point);
            queue.push(Reverse((length.to_bits(), point)));
        }
    }
    while let Some(Reverse((_, point))) = queue.pop() {
        let i = point as usize;
        if done[i] {
            continue;
        }
        done[i] = true;
        ways.order.push(point);
        let across = bridges.get(i).into_iter().flatten();
        for &other in graph.arcs.of(point).iter().chain(across) {
            let j = other as usize;
            if done[j] {
                continue;
            }
            let step = points[i].distance(points[j]);
            let candidate = cost[i] + step * (1.0 + step / spacing);
            if candidate < cost[j] {
                cost[j] = candidate;
                ways.length[j] = ways.length[i] + step;
                (ways.next[j], ways.base[j]) = (point, ways.base[i]);
                queue.push(Reverse((candidate.to_bits(), other)));
            }
        }
    }
    ways
}
