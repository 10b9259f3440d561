//! Vertices that belong to one element each, and the index buffer of a part.
//!
//! A vertex shader moves every vertex towards the centre of its element, so no vertex may belong to two.
//! The most important element keeps a shared vertex, every other one gets a copy with all its columns.
//! Triangles as elements ([`Grain::Triangle`](crate::Grain::Triangle)) thus have 6 vertices a card instead
//! of 4: their places in the order differ even where their pivots do not.

use super::layout::Layout;
use crate::outline::Tier;
use glam::Vec3;
use tree_mesh::Surface;

/// No element.
const NONE: u32 = u32::MAX;

/// The rows that change in a surface.
pub(super) struct Rows {
    pub(super) indices: Vec<u32>,
    /// The vertex each added one is a copy of.
    pub(super) copies: Vec<u32>,
    /// Pivot, and λ from which on it is drawn, of each vertex, the added ones at the end.
    pub(super) centers: Vec<[f32; 4]>,
}

/// `elements` and `centers` in the order of the layout's ranks. Vertices must exist.
///
/// # Complexity
/// O(vertices + triangles of all blocks).
pub(super) fn rows(
    surface: &Surface,
    layout: &Layout,
    tiers: &[Tier],
    elements: &[u32],
    centers: &[[f32; 4]],
) -> Rows {
    let n = surface.positions.len();
    // Vertices of no element stand still.
    let still = |p: &Vec3| p.extend(0.0).to_array();
    let mut rows = Rows {
        indices: vec![0; 3 * layout.n_triangles() as usize],
        copies: Vec::new(),
        centers: surface.positions.iter().map(still).collect(),
    };
    let mut owners = vec![NONE; n];
    // The element each vertex was last copied for, and the copy.
    let mut copied = vec![(NONE, 0_u32); n];
    for (place, (&element, &center)) in elements.iter().zip(centers).enumerate() {
        let mut own = |vertex: u32| {
            let (v, place) = (vertex as usize, place as u32);
            if owners[v] == NONE {
                owners[v] = place;
                rows.centers[v] = center;
            }
            if owners[v] == place {
                return vertex;
            }
            if copied[v].0 != place {
                copied[v] = (place, rows.centers.len() as u32);
                rows.copies.push(vertex);
                rows.centers.push(center);
            }
            copied[v].1
        };
        for (block, &tier) in layout.tiers.iter().enumerate() {
            if place + 1 >= layout.starts[block].len() {
                continue;
            }
            let first = 3 * layout.starts[block][place] as usize;
            let corners = tiers[tier].of(element as usize).as_flattened();
            for (index, &corner) in rows.indices[first..].iter_mut().zip(corners) {
                *index = own(corner);
            }
        }
    }
    rows
}

/// Appends copies of vertices to every column. Leaves no longer have equal numbers of vertices then, so
/// their anchors go.
pub(super) fn append(surface: &mut Surface, copies: &[u32]) {
    fn column<T: Copy>(values: &mut Vec<T>, copies: &[u32]) {
        if values.is_empty() {
            return;
        }
        values.reserve(copies.len());
        for &row in copies {
            values.push(values[row as usize]);
        }
    }
    if copies.is_empty() {
        return;
    }
    column(&mut surface.positions, copies);
    column(&mut surface.normals, copies);
    column(&mut surface.uvs, copies);
    column(&mut surface.tangents, copies);
    column(&mut surface.uvs2, copies);
    column(&mut surface.branches, copies);
    column(&mut surface.occlusion, copies);
    column(&mut surface.welds, copies);
    surface.anchors = Vec::new();
}

/// Keeps the vertices that are marked, in their order, and renumbers the triangles. Copies at a seam stay
/// welded to the first of them that is left.
///
/// # Complexity
/// O(vertices + triangles).
pub(crate) fn compact(surface: &mut Surface, kept: &[bool]) {
    if kept.iter().all(|&keep| keep) {
        return;
    }
    fn column<T>(values: &mut Vec<T>, kept: &[bool]) {
        let mut keep = kept.iter();
        values.retain(|_| keep.next().copied().unwrap_or(false));
    }
    let mut number = 0;
    let new: Vec<u32> = kept
        .iter()
        .map(|&keep| {
            number += u32::from(keep);
            number.wrapping_sub(1)
        })
        .collect();
    for index in &mut surface.indices {
        *index = new[*index as usize];
    }
    keep_anchors(surface, kept);
    weld(&mut surface.welds, kept, &new);
    column(&mut surface.positions, kept);
    column(&mut surface.normals, kept);
    column(&mut surface.uvs, kept);
    column(&mut surface.tangents, kept);
    column(&mut surface.uvs2, kept);
    column(&mut surface.branches, kept);
    column(&mut surface.occlusion, kept);
    column(&mut surface.welds, kept);
}

/// Anchors of the leaves that are left; none at all when a leaf is left in part.
fn keep_anchors(surface: &mut Surface, kept: &[bool]) {
    let size = surface.vertices_per_leaf().filter(|&size| size > 0);
    let leaves = || kept.chunks(size.unwrap_or(1));
    if size.is_none() || leaves().any(|leaf| leaf.iter().any(|&keep| keep != leaf[0])) {
        surface.anchors = Vec::new();
        return;
    }
    let mut keep = leaves().map(|leaf| leaf[0]);
    surface.anchors.retain(|_| keep.next().unwrap_or(false));
}

/// Welds vertices to the first that is left of those at the same point; the column's rows are not dropped
/// yet.
fn weld(welds: &mut [u32], kept: &[bool], new: &[u32]) {
    let mut roots: Vec<u32> = Vec::with_capacity(welds.len());
    let mut first = vec![NONE; welds.len()];
    for (vertex, weld) in welds.iter_mut().enumerate() {
        let root = roots.get(*weld as usize).copied().unwrap_or(vertex as u32);
        roots.push(root);
        if kept[vertex] {
            let first = &mut first[root as usize];
            *first = (*first).min(new[vertex]);
            *weld = *first;
        }
    }
}
