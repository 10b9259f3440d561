//! Step 7: each leaf component becomes a leaf on the nearest wood.
//!
//! With texture coordinates the midrib runs against v, since v runs down the picture of a leaf, and
//! the leaf starts at the middle of its lower side, unless the upper one is much nearer to wood.
//! Without them the leaf starts at the vertex nearest to wood and ends at the one farthest from
//! there.

use super::near::{Near, Segment};
use super::separate::Separated;
use super::stages::Leaves;
use super::weld::Soup;
use crate::error::Result;
use glam::{Mat3, Quat, Vec2, Vec3};
use rayon::prelude::*;
use std::collections::BTreeMap;
use tree_core::{Control, Foliage, Leaf, Part, Resource, Skeleton};

/// Most vertices of a leaf that are tried for its base.
const TRIED: usize = 32;
/// Vertices within this share of a leaf's length are its lower side.
const SIDE: f32 = 0.1;
/// The picture is upside down when the upper side is nearer to wood by this factor.
const UPSIDE_DOWN: f32 = 3.0;

/// A leaf of each component. `skeleton` is of unit size.
pub(super) fn leaves(
    soup: &Soup,
    separated: &Separated,
    components: &[u32],
    parts: &[Part<'_>],
    skeleton: &Skeleton,
    control: &Control,
) -> Result<Leaves> {
    control.limits.check(Resource::Leaves, components.len() as u64)?;
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let at = |node: u32| (positions[node as usize], radii[node as usize]);
    let mut segments: Vec<Segment> =
        skeleton.segments().map(|(a, b)| Segment { a: at(a), b: at(b) }).collect();
    if segments.is_empty() {
        segments.push(Segment { a: at(0), b: at(0) });
    }
    let near = Near::new(segments);
    let (kind_of, kinds) = kinds(soup, separated, parts, components);
    let found: Vec<Option<(Leaf, f32)>> = components
        .par_iter()
        .zip(&kind_of)
        .map(|(&component, &kind)| {
            control.check()?;
            let triangles = separated.triangles.of(component);
            let shape = &separated.shapes[component as usize];
            let held = hold(soup, triangles, parts, &near, shape.axes[2]);
            let width = held.as_ref().map_or(0.0, |held| held.width);
            Ok(held.map(|held| (Leaf { kind, ..bear(&held, soup, &near, skeleton) }, width)))
        })
        .collect::<Result<_>>()?;
    let mut foliage = Foliage::with_capacity(found.len());
    // Of each kind the sums of lengths and widths, in units of the mesh's size.
    let mut sums = vec![(0.0_f32, 0.0_f32); kinds.len()];
    for (leaf, width) in found.into_iter().flatten() {
        if let Some(sum) = sums.get_mut(usize::from(leaf.kind)) {
            *sum = (sum.0 + (f64::from(leaf.size) / soup.size) as f32, sum.1 + width);
        }
        foliage.push(leaf)?;
    }
    let widths = sums.iter().map(|(l, w)| if *l > 0.0 { w / l } else { 1.0 }).collect();
    Ok(Leaves { foliage, kinds, widths })
}

/// The kind of each component, by the name of its part.
fn kinds(
    soup: &Soup,
    separated: &Separated,
    parts: &[Part<'_>],
    components: &[u32],
) -> (Vec<u16>, Vec<String>) {
    let (mut numbers, mut names) = (BTreeMap::new(), Vec::new());
    let kind_of = components
        .iter()
        .map(|&component| {
            let first = separated.triangles.of(component).first();
            let part = first.map_or(0, |&triangle| soup.sources[triangle as usize].0);
            let name = match parts.get(part as usize).map(|part| part.name) {
                None | Some("") => "leaf",
                Some(name) => name,
            };
            *numbers.entry(name).or_insert_with(|| {
                // A mesh with more kinds than can be told apart gives its last ones one kind.
                if names.len() < usize::from(u16::MAX) {
                    names.push(name.to_owned());
                }
                (names.len() - 1) as u16
            })
        })
        .collect();
    (kind_of, names)
}

/// How a leaf is held, in units of the mesh's size.
struct Held {
    base: Vec3,
    midrib: Vec3,
    face: Vec3,
    length: f32,
    width: f32,
}

fn hold(
    soup: &Soup,
    triangles: &[u32],
    parts: &[Part<'_>],
    near: &Near,
    least: Vec3,
) -> Option<Held> {
    let mut vertices: Vec<u32> =
        triangles.iter().flat_map(|&t| soup.triangles[t as usize]).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |vertex: &u32| soup.positions[*vertex as usize];
    let distance = |p: Vec3| near.nearest(p).map_or(0.0, |(_, _, distance)| distance);
    let mut held = match up_the_picture(soup, triangles, parts) {
        Some(up) => {
            let along = |vertex: &u32| place(vertex).dot(up);
            let low = vertices.iter().map(along).fold(f32::INFINITY, f32::min);
            let high = vertices.iter().map(along).fold(f32::NEG_INFINITY, f32::max);
            let side = |from: f32| {
                let within = |v: &&u32| (along(v) - from).abs() <= SIDE * (high - low);
                let n = vertices.iter().filter(within).count().max(1);
                vertices.iter().filter(within).map(place).sum::<Vec3>() / n as f32
            };
            let (bottom, top) = (side(low), side(high));
            let upside_down = distance(bottom) > UPSIDE_DOWN * distance(top);
            let (base, midrib) = if upside_down { (top, -up) } else { (bottom, up) };
            Held { base, midrib, face: Vec3::ZERO, length: high - low, width: 0.0 }
        }
        None => {
            let stride = vertices.len().div_ceil(TRIED);
            let tried = vertices.iter().step_by(stride.max(1)).map(place);
            let base = tried
                .map(|p| (distance(p), p))
                .reduce(|best, other| if other.0 < best.0 { other } else { best })?
                .1;
            let tip = vertices
                .iter()
                .map(place)
                .reduce(|a, b| if b.distance(base) > a.distance(base) { b } else { a })?;
            let midrib = (tip - base).try_normalize()?;
            Held { base, midrib, face: Vec3::ZERO, length: tip.distance(base), width: 0.0 }
        }
    };
    let across = |v: Vec3| (v - held.midrib * v.dot(held.midrib)).try_normalize();
    let normal: Vec3 = triangles
        .iter()
        .map(|&triangle| {
            let [a, b, c] = soup.corners(triangle);
            (b - a).cross(c - a)
        })
        .sum();
    // Two-faced cards have no sum; they look up.
    let up = if least.y < 0.0 { -least } else { least };
    held.face =
        across(normal).or_else(|| across(up)).unwrap_or(held.midrib.any_orthonormal_vector());
    let side = held.midrib.cross(held.face);
    let across = |vertex: &u32| place(vertex).dot(side);
    held.width = vertices.iter().map(across).fold(f32::NEG_INFINITY, f32::max)
        - vertices.iter().map(across).fold(f32::INFINITY, f32::min);
    Some(held)
}

/// The direction on the surface against v, up the picture of the leaf.
fn up_the_picture(soup: &Soup, triangles: &[u32], parts: &[Part<'_>]) -> Option<Vec3> {
    let mut up = Vec3::ZERO;
    for &triangle in triangles {
        let (part, row) = soup.sources[triangle as usize];
        let part = parts.get(part as usize)?;
        let corners = part.indices.get(3 * row as usize..3 * row as usize + 3)?;
        let uv = |i: usize| part.uvs.get(corners[i] as usize).copied();
        let (p, t): (_, [Vec2; 3]) = (soup.corners(triangle), [uv(0)?, uv(1)?, uv(2)?]);
        let (e, f) = (p[1] - p[0], p[2] - p[0]);
        let (s, t) = (t[1] - t[0], t[2] - t[0]);
        let turned = s.perp_dot(t);
        // dP/dv, by area on the surface.
        let down = (f * s.x - e * t.x) / turned;
        if let Some(down) = down.try_normalize() {
            up -= down * e.cross(f).length();
        }
    }
    up.try_normalize()
}

fn bear(held: &Held, soup: &Soup, near: &Near, skeleton: &Skeleton) -> Leaf {
    let (segment, share, _) = near.nearest(held.base).unwrap_or((0, 0.0, 0.0));
    // Segment i ends at node i + 1.
    let upper = (segment + 1).min(skeleton.len() as u32 - 1);
    let node = if share > 0.5 { upper } else { skeleton.parent(upper).unwrap_or(0) };
    let columns = Mat3::from_cols(held.midrib.cross(held.face), held.midrib, held.face);
    Leaf {
        node,
        position: soup.outward(held.base),
        rotation: Quat::from_mat3(&columns).normalize(),
        size: (f64::from(held.length) * soup.size) as f32,
        kind: 0,
    }
}
