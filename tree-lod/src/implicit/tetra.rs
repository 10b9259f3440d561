//! Marching tetrahedra (Doi and Koide 1991) on Kuhn's division of cubes into six tetrahedra.
//!
//! 1. Every edge of a tetrahedron leads from a node to one of seven neighbours, up along one, two or
//!    three axes. Where one end is inside and the other is not, the edge has a vertex: the place is
//!    found by bisection of the exact field, since the grid's values say nothing about where, between
//!    its nodes, the field becomes 0.
//! 2. Each tetrahedron with ends of both kinds has one or two triangles.
//!
//! All cubes are divided alike, so tetrahedra fill space and share whole faces: the surface is the
//! level set of a function that is linear on each of them, thus a closed 2-manifold, whatever the
//! values. A node with exactly the iso-value is inside. Vertices keep off the nodes, so that no two
//! share a place.

use super::field::Metaballs;
use super::grid::Grid;
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::Control;

/// Halvings of an edge: a vertex is found to a 128th of it.
const HALVINGS: usize = 6;
/// Vertices keep this share of their edge away from its ends.
const MARGIN: f32 = 0.02;
/// Corners of the six tetrahedra of a cube: bit 0 is a step along x, 1 along y, 2 along z. All turn the
/// same way: (b − a) × (c − a) · (d − a) > 0.
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 2, 7, 3], [0, 1, 7, 5], [0, 4, 7, 6]];
/// For each pair inside, it and the other two, as an even permutation.
const PAIRS: [[usize; 4]; 6] =
    [[0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 2, 0], [2, 3, 0, 1]];

/// Vertices by their edges.
#[derive(Default)]
pub(super) struct Vertices {
    /// Eight times the number of the lower node, plus the direction of the edge (1 to 7); rising.
    pub(super) keys: Vec<u64>,
    pub(super) positions: Vec<Vec3>,
    pub(super) normals: Vec<Vec3>,
}

fn corner([x, y, z]: [usize; 3], corner: usize) -> [usize; 3] {
    [x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)]
}

pub(super) fn vertices(
    field: &Metaballs,
    grid: &Grid,
    iso: f32,
    control: &Control,
) -> Result<Vertices> {
    let layers = (0..grid.nodes[2] - 1)
        .into_par_iter()
        .map(|z| {
            control.check()?;
            let mut found = Vertices::default();
            for y in 0..grid.nodes[1] - 1 {
                for x in 0..grid.nodes[0] - 1 {
                    edges_of([x, y, z], field, grid, iso, &mut found);
                }
            }
            Ok(found)
        })
        .collect::<Result<Vec<_>>>()?;
    let mut all = Vertices::default();
    for layer in layers {
        all.keys.extend(layer.keys);
        all.positions.extend(layer.positions);
        all.normals.extend(layer.normals);
    }
    Ok(all)
}

/// Vertices on the edges that lead up from a node.
fn edges_of(node: [usize; 3], field: &Metaballs, grid: &Grid, iso: f32, found: &mut Vertices) {
    let number = grid.number(node);
    let inside = grid.values[number] >= iso;
    for direction in 1..8 {
        let other = corner(node, direction);
        if (grid.values[grid.number(other)] >= iso) == inside {
            continue;
        }
        let (mut within, mut without) = (grid.place(node), grid.place(other));
        if !inside {
            std::mem::swap(&mut within, &mut without);
        }
        let (mut near, mut far) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (near + far);
            if field.value(within.lerp(without, middle)) >= iso {
                near = middle;
            } else {
                far = middle;
            }
        }
        let place = within.lerp(without, (0.5 * (near + far)).clamp(MARGIN, 1.0 - MARGIN));
        let out = -field.gradient(place);
        found.keys.push(8 * number as u64 + direction as u64);
        found.positions.push(place);
        // Where contributions cancel, out is where the field was seen to fall.
        found.normals.push(out.try_normalize().unwrap_or((without - within).normalize_or(Vec3::Y)));
    }
}

pub(super) fn triangles(
    grid: &Grid,
    iso: f32,
    keys: &[u64],
    control: &Control,
) -> Result<Vec<[u32; 3]>> {
    let layers = (0..grid.nodes[2] - 1)
        .into_par_iter()
        .map(|z| {
            control.check()?;
            let mut found = Vec::new();
            for y in 0..grid.nodes[1] - 1 {
                for x in 0..grid.nodes[0] - 1 {
                    cube([x, y, z], grid, iso, keys, &mut found);
                }
            }
            Ok(found)
        })
        .collect::<Result<Vec<_>>>()?;
    Ok(layers.concat())
}

/// Leaves out the walls of hollows within the plant, which no one sees: pieces that enclose a negative
/// volume. Vertices without triangles go too.
pub(super) fn without_hollows(vertices: &mut Vertices, triangles: &mut Vec<[u32; 3]>) {
    let mut parents: Vec<u32> = (0..vertices.keys.len() as u32).collect();
    for &[a, b, c] in triangles.iter() {
        join(&mut parents, a, b);
        join(&mut parents, a, c);
    }
    // Parents have lower numbers: after this every vertex knows its root.
    for vertex in 0..parents.len() {
        parents[vertex] = parents[parents[vertex] as usize];
    }
    let mut volumes = vec![0.0; parents.len()];
    for triangle in triangles.iter() {
        // About a place of the piece itself, so that no digits are lost.
        let root = parents[triangle[0] as usize] as usize;
        let middle = vertices.positions[root];
        let [a, b, c] = triangle.map(|v| (vertices.positions[v as usize] - middle).as_dvec3());
        volumes[root] += a.dot(b.cross(c));
    }
    let mut number = vec![0_u32; parents.len()];
    let mut n = 0;
    for (vertex, &root) in parents.iter().enumerate() {
        if volumes[root as usize] > 0.0 {
            number[vertex] = n as u32;
            vertices.positions[n] = vertices.positions[vertex];
            vertices.normals[n] = vertices.normals[vertex];
            n += 1;
        }
    }
    vertices.positions.truncate(n);
    vertices.normals.truncate(n);
    triangles.retain(|t| volumes[parents[t[0] as usize] as usize] > 0.0);
    for vertex in triangles.as_flattened_mut() {
        *vertex = number[*vertex as usize];
    }
}

/// Joins two trees, the later root under the earlier one, and shortens the ways.
fn join(parents: &mut [u32], a: u32, b: u32) {
    let mut root = |mut vertex: u32| {
        while parents[vertex as usize] != vertex {
            parents[vertex as usize] = parents[parents[vertex as usize] as usize];
            vertex = parents[vertex as usize];
        }
        vertex
    };
    let (a, b) = (root(a), root(b));
    parents[a.max(b) as usize] = a.min(b);
}

fn cube(cell: [usize; 3], grid: &Grid, iso: f32, keys: &[u64], found: &mut Vec<[u32; 3]>) {
    let mut inside = 0_usize;
    for i in 0..8 {
        inside |= usize::from(grid.values[grid.number(corner(cell, i))] >= iso) << i;
    }
    if inside == 0 || inside == 0xff {
        return;
    }
    let vertex = |a: usize, b: usize| {
        // Of two corners of a tetrahedron one is above the other along all axes in which they differ.
        let key = 8 * grid.number(corner(cell, a & b)) as u64 + (a ^ b) as u64;
        keys.partition_point(|&other| other < key) as u32
    };
    for corners in TETRAHEDRA {
        let is = |i: usize| inside >> corners[i] & 1 == 1;
        let at = |i: usize, j: usize| vertex(corners[i], corners[j]);
        let n = (0..4).filter(|&i| is(i)).count();
        if n == 2 {
            for [i, j, k, l] in PAIRS.into_iter().filter(|&[i, j, ..]| is(i) && is(j)) {
                let quad = [at(i, k), at(i, l), at(j, l), at(j, k)];
                found.extend([[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
            }
        } else if let Some(i) = (0..4).find(|&i| is(i) == (n == 1) && n % 2 == 1) {
            // i, i ^ 1, i ^ 2, i ^ 3 is an even permutation.
            let [a, b, c] = [at(i, i ^ 1), at(i, i ^ 2), at(i, i ^ 3)];
            found.push(if n == 1 { [a, b, c] } else { [a, c, b] });
        }
    }
}
