//! Normals of the subdivided surface, smooth within creases.

use super::tags::Tags;
use crate::mesh::Surface;
use crate::topology::edges::{before, end, start};
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Replaces all normals, and turns tangents so that they stay orthogonal to them.
pub(super) fn renew(surface: &mut Surface, of_vertex: &[u32], places: &[Vec3], tags: &Tags<'_>) {
    let triangles = tags.triangles;
    let place = |point: u32| places[point as usize].as_dvec3();
    // Max 1999: exact when the point and its neighbours lie on a sphere.
    let weighted = |half: u32| {
        let own = place(start(triangles, half));
        let (a, b) =
            (place(end(triangles, half)) - own, place(start(triangles, before(half))) - own);
        let size = a.length_squared() * b.length_squared();
        if size > 0.0 { a.cross(b) / size } else { DVec3::ZERO }
    };
    let n_halves = surface.indices.len() as u32;
    let weights: Vec<DVec3> = (0..n_halves).into_par_iter().map(weighted).collect();
    let mut smooth = vec![DVec3::ZERO; places.len()];
    for (half, &weight) in weights.iter().enumerate() {
        smooth[triangles.as_flattened()[half] as usize] += weight;
    }
    // Where creases divide a point, each copy gets the sum of the sectors it is in.
    let mut divided = vec![false; weights.len()];
    let mut sums: Vec<DVec3> = of_vertex
        .par_iter()
        .map(|&point| {
            let whole = tags.n_sharp[point as usize] < 2;
            if whole { smooth[point as usize] } else { DVec3::ZERO }
        })
        .collect();
    let mut sector = Vec::new();
    for half in 0..n_halves {
        let point = triangles.as_flattened()[half as usize];
        if tags.n_sharp[point as usize] < 2 || divided[half as usize] {
            continue;
        }
        walk(tags, half, &mut sector);
        let sum: DVec3 = sector.iter().map(|&half| weights[half as usize]).sum();
        let mut vertices: Vec<u32> = Vec::with_capacity(sector.len());
        for &half in &sector {
            divided[half as usize] = true;
            vertices.push(surface.indices[half as usize]);
        }
        vertices.sort_unstable();
        vertices.dedup();
        for vertex in vertices {
            sums[vertex as usize] += sum;
        }
    }
    surface.normals.par_iter_mut().zip(&sums).for_each(|(normal, sum)| {
        // Sums of weights of tiny triangles overflow an f32.
        *normal = sum.normalize_or(normal.as_dvec3()).as_vec3();
    });
    let turn = |(tangent, normal): (&mut glam::Vec4, &Vec3)| {
        let along = tangent.truncate();
        let across = along - *normal * normal.dot(along);
        let unit = across.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        *tangent = unit.extend(tangent.w);
    };
    surface.tangents.par_iter_mut().zip(&surface.normals).for_each(turn);
}

/// The half-edges that leave a point in the sector of `half`, from crease to crease.
fn walk(tags: &Tags<'_>, half: u32, sector: &mut Vec<u32>) {
    let mut first = half;
    while let Some(right) = tags.turn_right(first) {
        first = right;
        if first == half {
            break;
        }
    }
    sector.clear();
    sector.push(first);
    let mut at = first;
    while let Some(left) = tags.turn_left(at) {
        if left == first {
            return;
        }
        sector.push(left);
        at = left;
    }
}
