//! Step 2: the neighbourhood graph: arcs to the nearest points, and bridges over what was not seen.
//!
//! Pieces that no arc joins (shadows of other branches, thin twigs) are joined by shortest bridges:
//! Borůvka's rounds, in which each piece but the largest takes the shortest way to another one.

use super::super::rows::{Rows, Sets};
use super::kd::Kd;
use super::params::ScanParams;
use super::report::{Bridge, ScanReport};
use crate::error::Result;
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// Arcs are at most this many spacings long; farther neighbours are a matter of bridges.
const REACH: f32 = 3.0;
/// Pieces of fewer points than this...
const SPECK: usize = 4;
/// ...farther than this many spacings from all others are specks of noise.
const SPECK_REACH: f32 = 8.0;

/// Bridges of a piece that the ways to the base may choose of...
const WAYS: usize = 8;
/// ...each farther from the others than this many times its length.
const APART: f32 = 1.5;

/// Arcs of every point, both ways.
#[derive(Debug)]
pub(super) struct Graph {
    pub(super) arcs: Rows,
    /// Piece of each point before bridges.
    pub(super) piece: Vec<u32>,
    /// Bridges as pairs of points.
    pub(super) bridges: Vec<[u32; 2]>,
}

/// Arcs between neighbours, and pieces.
pub(super) fn near(kd: &Kd, spacing: f32, params: &ScanParams, control: &Control) -> Result<Graph> {
    let (points, k) = (kd.points(), params.neighbours as usize);
    control.limits.check(Resource::GraphArcs, 2 * (points.len() * k) as u64)?;
    let reach = REACH * spacing;
    let rows: Vec<Vec<u32>> = points
        .par_chunks(1024)
        .zip((0..points.len()).into_par_iter().step_by(1024))
        .map(|(chunk, first)| {
            let mut found = vec![(0.0, 0); k + 1];
            let mut row = Vec::with_capacity(k * chunk.len());
            for (&point, i) in chunk.iter().zip(first as u32..) {
                let n = kd.nearest(point, reach, &mut found);
                let others = found[..n].iter().map(|&(_, other)| other).filter(|&o| o != i);
                let start = row.len();
                row.extend(others.take(k));
                row.resize(start + k, u32::MAX);
            }
            row
        })
        .collect();
    control.check()?;
    let out: Vec<u32> = rows.concat();
    let arcs_of = |i: u32| {
        let row = &out[i as usize * k..(i as usize + 1) * k];
        row.iter().copied().take_while(|&other| other != u32::MAX)
    };
    let n = points.len() as u32;
    let pairs = (0..n).flat_map(|i| {
        // The way back too, where the other one has not taken it itself.
        arcs_of(i).flat_map(move |j| {
            let back = arcs_of(j).all(|other| other != i);
            [Some((i, j)), back.then_some((j, i))].into_iter().flatten()
        })
    });
    let mut sets = Sets::new(points.len());
    for i in 0..n {
        arcs_of(i).for_each(|j| sets.join(i, j));
    }
    let pairs: Vec<(u32, u32)> = pairs.collect();
    let arcs = Rows::of_pairs(pairs.iter().copied(), points.len());
    Ok(Graph { arcs, piece: sets.labels().0, bridges: Vec::new() })
}

/// Joins pieces by bridges of at most `widest`.
pub(super) fn bridge(
    graph: &mut Graph,
    kd: &Kd,
    spacing: f32,
    widest: f32,
    report: &mut ScanReport,
    control: &Control,
) -> Result<()> {
    let mut label = graph.piece.clone();
    let sizes = |label: &[u32]| {
        let mut sizes = vec![0_usize; label.iter().map(|&l| l as usize + 1).max().unwrap_or(0)];
        label.iter().for_each(|&l| sizes[l as usize] += 1);
        sizes
    };
    let first = sizes(&label);
    let piece = graph.piece.clone();
    loop {
        control.check()?;
        let sizes = sizes(&label);
        let largest = (0..sizes.len()).max_by_key(|&i| (sizes[i], std::cmp::Reverse(i)));
        let (shared, groups) = (kd.shared_labels(&label), Rows::new(&label, sizes.len()));
        let ways: Vec<(f32, u32, u32)> = (0..sizes.len() as u32)
            .into_par_iter()
            .filter(|&own| Some(own as usize) != largest)
            .filter_map(|own| {
                let speck = sizes[own as usize] < SPECK;
                let reach = if speck { widest.min(SPECK_REACH * spacing) } else { widest };
                let mut best = (reach * reach, u32::MAX, u32::MAX);
                for &i in groups.of(own) {
                    let at = kd.points()[i as usize];
                    if let Some((d2, j)) = kd.nearest_other(at, own, best.0, &label, &shared) {
                        best = (d2, i, j);
                    }
                }
                (best.1 != u32::MAX).then_some(best)
            })
            .collect();
        if ways.is_empty() {
            break;
        }
        let mut ways = ways;
        ways.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        let mut sets = Sets::new(sizes.len());
        for (d2, i, j) in ways {
            let (a, b) = (label[i as usize], label[j as usize]);
            if sets.find(a) != sets.find(b) {
                sets.join(a, b);
                graph.bridges.push([i, j]);
                let n_points =
                    first[piece[i as usize] as usize].min(first[piece[j as usize] as usize]);
                report.bridges.push(Bridge { length: d2.sqrt(), n_points });
            }
        }
        let (joined, _) = sets.labels();
        label.iter_mut().for_each(|l| *l = joined[*l as usize]);
    }
    more_ways(graph, kd, &first, widest, control)
}

/// The shortest bridge of a piece may touch its tip, and its branch would grow backwards. So pieces get
/// further bridges, apart from each other, and the ways to the base choose.
fn more_ways(
    graph: &mut Graph,
    kd: &Kd,
    sizes: &[usize],
    widest: f32,
    control: &Control,
) -> Result<()> {
    control.check()?;
    let (points, piece) = (kd.points(), &graph.piece);
    let largest = (0..sizes.len()).max_by_key(|&i| (sizes[i], std::cmp::Reverse(i)));
    let (shared, groups) = (kd.shared_labels(piece), Rows::new(piece, sizes.len()));
    let more: Vec<Vec<[u32; 2]>> = (0..sizes.len() as u32)
        .into_par_iter()
        .filter(|&own| Some(own as usize) != largest && sizes[own as usize] >= SPECK)
        .map(|own| {
            let mut ways: Vec<(f32, u32, u32)> = Vec::new();
            for &i in groups.of(own) {
                let at = points[i as usize];
                let other = kd.nearest_other(at, own, widest * widest, piece, &shared);
                ways.extend(other.map(|(d2, j)| (d2, i, j)));
            }
            ways.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            let mut taken: Vec<[u32; 2]> = Vec::new();
            for (d2, i, j) in ways {
                let apart = |&[a, _]: &[u32; 2]| {
                    points[a as usize].distance_squared(points[i as usize]) > APART * APART * d2
                };
                if taken.iter().all(apart) {
                    taken.push([i, j]);
                }
                if taken.len() == WAYS {
                    break;
                }
            }
            taken
        })
        .collect();
    graph.bridges.extend(more.into_iter().flatten());
    Ok(())
}
