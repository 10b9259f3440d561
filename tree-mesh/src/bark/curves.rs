//! The lines of all axes.

use super::curve::{Curve, Drawing, Station, length_min};
use super::frame::Frame;
use crate::error::Result;
use crate::params::{CurveFit, MeshParams};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Axes, Axis, Control, Skeleton};

/// Axes drawn by one piece of work.
pub(crate) const AXES_PER_PART: usize = 256;
/// A child of the root whose cosine to the trunk is below this is a root: it needs wood to start from.
const ROOT_COSINE: f32 = -0.2;
/// How far the trunk reaches below such roots, in its radii, and how thick it is there.
const STOCK_DEPTH: f32 = 0.9;
const STOCK_RADIUS: f32 = 0.75;
/// Shortest stock, in lengths that count as nothing.
const STOCK_MIN: f32 = 30.0;

/// The line of every axis, by number of the axis.
#[derive(Debug)]
pub(crate) struct Curves {
    parts: Vec<Part>,
    /// Where on its axis each node of the skeleton lies, by length from the base of the axis.
    pub(crate) along: Vec<f32>,
    /// Nodes passed over because they lie too near to the one before.
    pub(crate) n_dropped: u64,
    fit: CurveFit,
}

#[derive(Debug, Default)]
struct Part {
    spans: Vec<Span>,
    nodes: Vec<Station>,
    slopes: Vec<Vec3>,
    frames: Vec<Frame>,
    /// For each node of the skeleton on these axes, how far along it lies.
    along: Vec<f32>,
    n_dropped: u64,
}

#[derive(Clone, Copy, Debug)]
struct Span {
    start: u32,
    len: u32,
    pointed: bool,
}

impl Curves {
    /// Draws all axes, in parallel.
    ///
    /// # Complexity
    /// O(nodes).
    pub(crate) fn draw(
        skeleton: &Skeleton,
        axes: &Axes,
        params: &MeshParams,
        control: &Control,
    ) -> Result<Self> {
        let n_parts = axes.len().div_ceil(AXES_PER_PART);
        let parts = (0..n_parts)
            .into_par_iter()
            .map_init(Drawing::default, |drawing, part| {
                control.check()?;
                Ok(draw_part(drawing, part, skeleton, axes, params))
            })
            .collect::<Result<Vec<_>>>()?;
        let mut along = vec![0.0; skeleton.len()];
        for (number, part) in parts.iter().enumerate() {
            let mut rest = part.along.iter();
            for axis in (number * AXES_PER_PART..).take(part.spans.len()) {
                let nodes = axes.get(axis as u32).map_or(&[][..], |axis| axis.nodes);
                for (&node, &at) in nodes.iter().zip(rest.by_ref()) {
                    along[node as usize] = at;
                }
            }
        }
        let n_dropped = parts.iter().map(|part| part.n_dropped).sum();
        Ok(Self { parts, along, n_dropped, fit: params.fit })
    }

    /// The line of an axis; `None` when it has no length.
    pub(crate) fn get(&self, axis: u32) -> Option<Curve<'_>> {
        let part = self.parts.get(axis as usize / AXES_PER_PART)?;
        let span = part.spans.get(axis as usize % AXES_PER_PART)?;
        if span.len < 2 {
            return None;
        }
        let rows = span.start as usize..(span.start + span.len) as usize;
        Some(Curve {
            nodes: &part.nodes[rows.clone()],
            slopes: &part.slopes[rows.clone()],
            frames: &part.frames[rows],
            fit: self.fit,
            pointed: span.pointed,
        })
    }
}

fn draw_part(
    drawing: &mut Drawing,
    number: usize,
    skeleton: &Skeleton,
    axes: &Axes,
    params: &MeshParams,
) -> Part {
    let mut part = Part::default();
    let first = number * AXES_PER_PART;
    for axis in (first..axes.len().min(first + AXES_PER_PART)).filter_map(|i| axes.get(i as u32)) {
        let n_extra = load(&mut drawing.raw, skeleton, axis);
        let drawn = drawing.draw(params);
        part.n_dropped += u64::from(drawing.n_dropped);
        let start = part.nodes.len() as u32;
        // A tip that was left out after the node before it had gone is stood for by the last.
        let node = |kept: u32| drawing.nodes.get(kept as usize).or(drawing.nodes.last());
        let at = |&kept: &u32| node(kept).map_or(0.0, |node| node.along);
        part.along.extend(drawing.kept.iter().skip(n_extra).map(at));
        let len = if drawn { drawing.nodes.len() as u32 } else { 0 };
        part.spans.push(Span { start, len, pointed: drawing.pointed });
        if drawn {
            part.nodes.extend_from_slice(&drawing.nodes);
            part.slopes.extend_from_slice(&drawing.slopes);
            part.frames.extend_from_slice(&drawing.frames);
        }
    }
    part
}

/// Loads the nodes of an axis. A lateral starts on its parent's node, as thin as it is itself; a
/// trunk with roots reaches below its base. Returns how many nodes went before those of the axis.
fn load(raw: &mut Vec<Station>, skeleton: &Skeleton, axis: Axis<'_>) -> usize {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let station = |at: u32, radius_of: u32| Station {
        position: positions[at as usize],
        radius: radii[radius_of as usize],
        along: 0.0,
    };
    raw.clear();
    let fork = axis.nodes.first().and_then(|&first| Some((skeleton.parent(first)?, first)));
    if let Some((fork, first)) = fork {
        raw.push(station(fork, first));
    } else if let Some(stock) = stock(skeleton, axis) {
        raw.push(stock);
    }
    let n_extra = raw.len();
    raw.extend(axis.nodes.iter().map(|&node| station(node, node)));
    n_extra
}

/// Where the trunk of a tree with roots begins: below the root node, so that roots leave its wall.
/// A trunk without length becomes a stock that its branches can stand on.
fn stock(skeleton: &Skeleton, trunk: Axis<'_>) -> Option<Station> {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let base = positions[0];
    let nothing = 2.0 * length_min(base);
    let away = |node: u32| {
        let arm = positions[node as usize] - base;
        if arm.length() > nothing { arm.try_normalize() } else { None }
    };
    let children = || skeleton.segments().filter(|&(parent, _)| parent == 0).map(|(_, node)| node);
    let radius = radii[0];
    let Some(up) = trunk.nodes.iter().find_map(|&node| away(node)) else {
        let longest = skeleton.positions().iter().map(|p| p.distance(base)).fold(0.0, f32::max);
        let up = children().find_map(away).unwrap_or(Vec3::Y);
        return (longest > 0.0).then(|| Station {
            position: base - up * radius.max(0.01 * longest).max(STOCK_MIN * nothing),
            radius,
            along: 0.0,
        });
    };
    let rooted = children()
        .filter(|node| trunk.nodes.get(1) != Some(node))
        .filter_map(away)
        .any(|direction| direction.dot(up) < ROOT_COSINE);
    rooted.then(|| Station {
        position: base - up * (STOCK_DEPTH * radius),
        radius: STOCK_RADIUS * radius,
        along: 0.0,
    })
}
