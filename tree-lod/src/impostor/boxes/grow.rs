//! Boxes from the root up.

use super::fit::{Fit, fit};
use super::{Bearers, BoxReport, Boxes, LeafBox, NO_BOX};
use crate::element::Elements;
use crate::error::{LodError, Result, check_range};
use glam::Vec3;
use std::ops::Range;
use tree_core::{Children, Control, Resource, Skeleton};
use tree_mesh::Mesh;

/// Which branches get a box.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxParams {
    /// Levels below the box of the whole tree, 0 to 16: the paper's top detail level. Default 4.
    pub levels: u32,
    /// A branch gets no box when its volume is less than this share of that of the box it is in
    /// (§4.2.4), 0 to 1. Less makes more boxes. Default 0.02.
    pub least_volume: f64,
    /// Nor when it is more than this share: its pictures would hardly be sharper. Its own branches are
    /// looked at instead. 0.01 to 1. Default 0.4.
    pub most_volume: f64,
    /// Nor when it has fewer leaves, 1 to 1,000,000: those are cheap as they are. Default 24.
    pub least_leaves: u32,
    /// Most boxes, 1 to 4096. Default 64. Larger ones come first.
    pub most_boxes: u32,
}

impl Default for BoxParams {
    fn default() -> Self {
        Self { levels: 4, least_volume: 0.02, most_volume: 0.4, least_leaves: 24, most_boxes: 64 }
    }
}

impl BoxParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("boxes.levels", self.levels.into(), 0.0, 16.0)?;
        check_range("boxes.least_volume", self.least_volume, 0.0, 1.0)?;
        check_range("boxes.most_volume", self.most_volume, 0.01, 1.0)?;
        check_range("boxes.least_leaves", self.least_leaves.into(), 1.0, 1e6)?;
        check_range("boxes.most_boxes", self.most_boxes.into(), 1.0, 4096.0)
    }
}

/// Leaves in the order of a walk through the skeleton, so that those of a subtree are one range.
struct Walk {
    children: Children,
    /// Leaves of the node itself, then of all above, are `leaves[first[node]..end[node]]`.
    first: Vec<u32>,
    end: Vec<u32>,
    leaves: Vec<u32>,
}

impl Walk {
    fn new(skeleton: &Skeleton, bearers: &[u32]) -> Self {
        let n = skeleton.len();
        let children = skeleton.children();
        let mut starts = vec![0_u32; n + 1];
        bearers.iter().for_each(|&node| starts[node as usize + 1] += 1);
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut of_node = vec![0_u32; bearers.len()];
        for (leaf, &node) in bearers.iter().enumerate() {
            of_node[next[node as usize] as usize] = leaf as u32;
            next[node as usize] += 1;
        }
        let mut walk = Self {
            children,
            first: vec![0; n],
            end: vec![0; n],
            leaves: Vec::with_capacity(bearers.len()),
        };
        // Deep trees must not overflow the stack: a node is met twice, before and after its branches.
        let mut stack = vec![(0_u32, false)];
        while let Some((node, done)) = stack.pop() {
            let row = node as usize;
            if done {
                walk.end[row] = walk.leaves.len() as u32;
                continue;
            }
            walk.first[row] = walk.leaves.len() as u32;
            walk.leaves.extend(&of_node[starts[row] as usize..starts[row + 1] as usize]);
            stack.push((node, true));
            stack.extend(walk.children.of(node).iter().rev().map(|&child| (child, false)));
        }
        walk
    }

    fn rows(&self, node: u32) -> Range<usize> {
        self.first[node as usize] as usize..self.end[node as usize] as usize
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.leaves[self.rows(node)]
    }

    /// Rows of a box.
    fn rows_of(&self, grown: &Grown) -> Vec<u32> {
        let rows = self.rows(grown.node);
        grown.group.clone().unwrap_or_else(|| (rows.start as u32..rows.end as u32).collect())
    }
}

/// A box before leaves are ordered.
struct Grown {
    parent: u32,
    level: u32,
    node: u32,
    fit: Fit,
    children: Vec<u32>,
    /// Rows of the walk, when they are not those of the node.
    group: Option<Vec<u32>>,
}

impl Boxes {
    /// Finds the boxes of a tree. `elements` are its leaves.
    ///
    /// # Errors
    /// [`LodError::Parameter`]; what [`Elements::check`] finds; [`LodError::Length`] when there is not one
    /// bearer for each leaf; [`LodError::Impostor`] when a bearer does not exist or all leaves are one
    /// point; [`LodError::Cancelled`].
    ///
    /// # Complexity
    /// O(nodes + vertices of leaves × levels × forks passed over).
    pub fn along(
        skeleton: &Skeleton,
        mesh: &Mesh,
        elements: &Elements,
        bearers: &Bearers,
        params: &BoxParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        mesh.check()?;
        elements.check(mesh)?;
        control.limits.check(Resource::Leaves, elements.len() as u64)?;
        let (found, expected) = (bearers.0.len(), elements.len());
        if found != expected {
            return Err(LodError::Length { what: "bearers", found, expected });
        }
        if bearers.0.iter().any(|&node| node as usize >= skeleton.len()) {
            return Err(LodError::Impostor("a leaf is borne by a node that the skeleton lacks"));
        }
        let walk = Walk::new(skeleton, &bearers.0);
        let base = |node: u32| skeleton.positions()[node as usize];
        let Some(whole) = fit(mesh, elements, walk.of(0), base(0)) else {
            return Err(LodError::Impostor("the leaves are all at one point, or beyond 1000 km"));
        };
        let root = Grown {
            parent: NO_BOX,
            level: 0,
            node: 0,
            fit: whole,
            children: Vec::new(),
            group: None,
        };
        let mut grown = vec![root];
        let mut dropped = 0;
        let mut at = 0;
        while at < grown.len() {
            control.report("boxes", at as f32 / params.most_boxes as f32)?;
            let here = &grown[at];
            if here.level < params.levels {
                let room = params.most_boxes as usize - grown.len();
                let volume = here.fit.volume();
                let fit_node = |node: u32| fit(mesh, elements, walk.of(node), base(node));
                let (mut found, mut small) = (Vec::new(), 0);
                if here.group.is_none() {
                    (found, small) =
                        branches(&walk, here.node, volume, params, &fit_node, control)?;
                }
                dropped += small + found.len().saturating_sub(room);
                small += usize::from(here.group.is_some());
                largest(&mut found, room);
                let mut children: Vec<_> =
                    found.into_iter().map(|(node, fit)| (node, fit, None)).collect();
                if small > 0 && children.len() < room {
                    let nodes: Vec<u32> = children.iter().map(|child| child.0).collect();
                    let fit_rows = |rows: &[u32]| {
                        let leaves: Vec<u32> =
                            rows.iter().map(|&row| walk.leaves[row as usize]).collect();
                        fit(mesh, elements, &leaves, base(here.node))
                    };
                    let rest = rest(&walk, walk.rows_of(here), &nodes);
                    let place = |row: u32| elements.centers[walk.leaves[row as usize] as usize];
                    let mut found = groups(rest, &here.fit, params, &fit_rows, &place);
                    largest(&mut found, room - children.len());
                    let node = here.node;
                    children.extend(found.into_iter().map(|(rows, fit)| (node, fit, Some(rows))));
                }
                let (first, level) = (grown.len() as u32, here.level + 1);
                grown[at].children = (first..first + children.len() as u32).collect();
                grown.extend(children.into_iter().map(|(node, fit, group)| Grown {
                    parent: at as u32,
                    level,
                    node,
                    fit,
                    children: Vec::new(),
                    group,
                }));
            }
            at += 1;
        }
        Ok(ordered(&grown, &walk, dropped))
    }
}

/// Keeps the largest, in the order they are in.
fn largest<T>(found: &mut Vec<(T, Fit)>, room: usize) {
    let mut by_size: Vec<usize> = (0..found.len()).collect();
    by_size.sort_by(|&a, &b| found[b].1.volume().total_cmp(&found[a].1.volume()));
    let mut kept = vec![false; found.len()];
    by_size.iter().take(room).for_each(|&i| kept[i] = true);
    let mut rows = kept.into_iter();
    found.retain(|_| rows.next().unwrap_or(false));
}

/// Rows that are on none of some branches.
fn rest(walk: &Walk, mut rows: Vec<u32>, nodes: &[u32]) -> Vec<u32> {
    // Branches that were found grow beside each other, in the order of the walk.
    let mut taken = nodes.iter().map(|&node| walk.rows(node)).peekable();
    rows.retain(|&row| {
        let row = row as usize;
        while taken.next_if(|range| range.end <= row).is_some() {}
        taken.peek().is_none_or(|range| row < range.start)
    });
    rows
}

/// What no branch takes, put together by place: halved across its longest side until the boxes are small
/// enough.
fn groups(
    rows: Vec<u32>,
    whole: &Fit,
    params: &BoxParams,
    fit: &dyn Fn(&[u32]) -> Option<Fit>,
    place: &dyn Fn(u32) -> Vec3,
) -> Vec<(Vec<u32>, Fit)> {
    let (volume, longest) = (whole.volume(), whole.half.max_element());
    let (n, mut found, mut stack) = (rows.len(), Vec::new(), vec![rows]);
    while let Some(mut rows) = stack.pop() {
        if rows.len() < params.least_leaves as usize {
            continue;
        }
        let Some(fit) = fit(&rows) else { continue };
        let share = fit.volume() / volume;
        if share < params.least_volume {
            continue;
        }
        // All of them would only be the same box again, and a box as long would be no sharper.
        let shorter = fit.half.max_element() <= SHORTER * longest;
        if share <= params.most_volume && shorter && rows.len() < n {
            rows.sort_unstable();
            found.push((rows, fit));
            continue;
        }
        if rows.len() < 2 {
            continue;
        }
        let axis = Vec3::AXES[fit.half.max_position()];
        let along = |row: u32| (fit.turn * axis).dot(place(row));
        rows.sort_by(|&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
        let upper = rows.split_off(rows.len() / 2);
        stack.extend([upper, rows]);
    }
    found
}

/// The lowest subtrees above `node` whose boxes are small enough, and how many were too small.
fn branches(
    walk: &Walk,
    node: u32,
    volume: f64,
    params: &BoxParams,
    fit: &dyn Fn(u32) -> Option<Fit>,
    control: &Control,
) -> Result<(Vec<(u32, Fit)>, usize)> {
    let (mut found, mut small) = (Vec::new(), 0);
    let mut stack: Vec<u32> = walk.children.of(node).iter().rev().copied().collect();
    // Along an unforked stretch the leaves hardly change: a box is only fitted where they become fewer by
    // this share since the last one that was too large.
    let mut last_count = vec![usize::MAX; stack.len()];
    while let (Some(node), Some(last)) = (stack.pop(), last_count.pop()) {
        let n = walk.of(node).len();
        if n < params.least_leaves as usize {
            small += usize::from(n > 0);
            continue;
        }
        let mut count = last;
        if n < last - last.min(usize::MAX - 1) / SHRUNK || last == usize::MAX {
            control.check()?;
            let Some(fit) = fit(node) else { continue };
            let share = fit.volume() / volume;
            if share < params.least_volume {
                small += 1;
                continue;
            }
            if share <= params.most_volume {
                found.push((node, fit));
                continue;
            }
            count = n;
        }
        for &child in walk.children.of(node).iter().rev() {
            stack.push(child);
            last_count.push(count);
        }
    }
    Ok((found, small))
}

/// Longest side of leaves put together by place, against that of the box they are in.
const SHORTER: f32 = 0.8;

/// A subtree is measured again when it has fewer leaves by one part in this many.
const SHRUNK: usize = 32;

/// Leaves box by box: own ones first, then those of the children.
fn ordered(grown: &[Grown], walk: &Walk, dropped: usize) -> Boxes {
    let n_leaves = walk.leaves.len();
    // The innermost box of each leaf. Children come after parents, so they overwrite.
    let mut innermost = vec![0_u32; n_leaves];
    for (number, grown) in grown.iter().enumerate() {
        match &grown.group {
            Some(rows) => rows.iter().for_each(|&row| innermost[row as usize] = number as u32),
            None => innermost[walk.rows(grown.node)].fill(number as u32),
        }
    }
    let mut own = vec![0_u32; grown.len()];
    innermost.iter().for_each(|&number| own[number as usize] += 1);
    let mut total = own.clone();
    for (number, grown) in grown.iter().enumerate().skip(1).rev() {
        total[grown.parent as usize] += total[number];
    }
    let mut starts = vec![0_u32; grown.len()];
    for (number, grown) in grown.iter().enumerate() {
        let mut next = starts[number] + own[number];
        for &child in &grown.children {
            starts[child as usize] = next;
            next += total[child as usize];
        }
    }
    let mut next = starts.clone();
    let mut order = vec![0_u32; n_leaves];
    for (&leaf, &number) in walk.leaves.iter().zip(&innermost) {
        order[next[number as usize] as usize] = leaf;
        next[number as usize] += 1;
    }
    let made = |(number, grown): (usize, &Grown)| {
        let first = starts[number];
        let children = grown.children.first().copied().unwrap_or(0);
        LeafBox {
            parent: grown.parent,
            level: grown.level,
            node: grown.node,
            center: grown.fit.center,
            half: grown.fit.half,
            turn: grown.fit.turn,
            leaves: first..first + total[number],
            own: first..first + own[number],
            children: children..children + grown.children.len() as u32,
        }
    };
    let boxes: Vec<LeafBox> = grown.iter().enumerate().map(made).collect();
    let report = BoxReport {
        n_boxes: boxes.len(),
        n_levels: boxes.iter().map(|b| b.level as usize + 1).max().unwrap_or(0),
        n_leaves,
        n_in_root_only: own.first().map_or(0, |&n| n as usize),
        n_dropped: dropped,
    };
    Boxes { boxes, order, report }
}
