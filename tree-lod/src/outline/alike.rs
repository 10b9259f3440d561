//! Elements that share one answer.
//!
//! Leaves of one kind are copies, turned and scaled, so that one answer holds for thousands. Two elements
//! are alike when their triangles have the same pattern of vertices and their lengths differ little,
//! whatever their size.

use super::Tier;
use super::shape::Local;
use crate::element::Elements;
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use tree_core::Control;
use tree_mesh::Mesh;

/// Number of a shape for elements that stay as they are.
const NONE: u32 = u32::MAX;
/// Elements looked at between two looks at the control; bounds the memory for their lengths.
const PART: usize = 1 << 13;
/// Most shapes of one pattern that others are compared with. Elements unlike all of these get an answer
/// of their own, found without search.
const SHAPES_MAX: usize = 24;

/// Most shapes that are searched for in all: where every leaf has a pattern of its own, as optimisers may
/// leave them, others get a plain answer.
const SEARCHES_MAX: usize = 256;

/// Elements that are alike.
pub(super) struct Alike {
    /// The first of them.
    pub(super) element: u32,
    /// Fewest triangles they may get.
    pub(super) least: usize,
    /// Whether the best answer is worth a search.
    pub(super) search: bool,
}

/// Which elements are alike.
pub(super) struct Found {
    pub(super) shapes: Vec<Alike>,
    /// Row of `shapes` for each element; no row for elements that stay as they are.
    pub(super) of: Vec<u32>,
}

/// Fewest triangles, and the pattern of all: what must be the same.
type Key = (usize, Vec<[u32; 3]>);

/// What elements are compared by.
struct Traits {
    least: usize,
    /// Triangles in numbers of the element's own.
    pattern: Vec<[u32; 3]>,
    /// Lengths in square roots of the area.
    lengths: Vec<f32>,
}

impl Traits {
    fn is_like(&self, other: &Self, tolerance: f32) -> bool {
        let close = |(a, b): (&f32, &f32)| (a - b).abs() <= tolerance;
        self.lengths.iter().zip(&other.lengths).all(close)
    }
}

/// Finds elements that are alike, within `tolerance` square roots of their area.
pub(super) fn find(
    mesh: &Mesh,
    elements: &Elements,
    full: &Tier,
    least: impl Fn(usize) -> usize + Sync,
    tolerance: f32,
    control: &Control,
) -> Result<Found> {
    let mut found = Found { shapes: Vec::new(), of: vec![NONE; elements.len()] };
    let mut known: BTreeMap<Key, Vec<(u32, Traits)>> = BTreeMap::new();
    let all: Vec<u32> = (0..elements.len() as u32).collect();
    let mut searched = 0;
    for part in all.chunks(PART) {
        control.check()?;
        let traits: Vec<Option<Traits>> = part
            .par_iter()
            .with_min_len(64)
            .map(|&element| of_element(mesh, elements, full, element as usize, &least))
            .collect();
        for (&element, traits) in part.iter().zip(traits) {
            let Some(mut traits) = traits else { continue };
            let key = (traits.least, std::mem::take(&mut traits.pattern));
            let others = known.entry(key).or_default();
            let like = others.iter().find(|(_, other)| traits.is_like(other, tolerance));
            found.of[element as usize] =
                like.map_or(found.shapes.len() as u32, |(shape, _)| *shape);
            if like.is_none() {
                searched += usize::from(others.len() < SHAPES_MAX);
                let search = others.len() < SHAPES_MAX && searched <= SEARCHES_MAX;
                let number = found.shapes.len() as u32;
                found.shapes.push(Alike { element, least: traits.least, search });
                if search {
                    others.push((number, traits));
                }
            }
        }
    }
    Ok(found)
}

/// What an element is compared by; none when there is nothing to simplify.
fn of_element(
    mesh: &Mesh,
    elements: &Elements,
    full: &Tier,
    element: usize,
    least: &impl Fn(usize) -> usize,
) -> Option<Traits> {
    let (triangles, least) = (full.of(element), least(element));
    let scale = 1.0 / elements.areas[element].sqrt();
    if triangles.len() <= least || !scale.is_finite() || scale == 0.0 {
        return None;
    }
    let local = Local::of(triangles);
    let positions = &mesh.surfaces[elements.surface[element] as usize].positions;
    let point = |i: usize| positions[local.vertices[i] as usize];
    let n = local.vertices.len();
    let center = (0..n).map(point).sum::<Vec3>() / n as f32;
    // Distances to three places and along the row tell a shape up to mirroring, which keeps the
    // answer right.
    let lengths = (0..n)
        .flat_map(|i| [center, point(0), point(n / 2), point((i + 1) % n)].map(|p| (i, p)))
        .map(|(i, p)| point(i).distance(p) * scale)
        .collect();
    Some(Traits { least, pattern: local.triangles, lengths })
}
