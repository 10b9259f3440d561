//! The mesh of issue 1, reduced to what the comparison needs: a tube along every axis, run through its
//! parent, with nothing joined. Rings stand on a cubic through the nodes (Bessel's tangents) so densely
//! that chords stay within the error; sides by the same error; no caps, copies or textures.

use tree_core::glam::{Vec2, Vec3};
use tree_core::{Continuation, Skeleton};
use tree_mesh::{Material, Mesh, Surface};

/// Fewest and most sides, most rings a segment, thinnest wood, as they were.
const SIDES: (f32, f32) = (3.0, 128.0);
const MAX_SAMPLES: f32 = 16.0;
const RADIUS_MIN: f32 = 0.0005;
/// Nodes nearer than this share of the radius are left out.
const MERGE_SHARE: f32 = 0.1;

/// Open tubes whose sides and chords stay within `error` metres of round branches.
pub(super) fn tubes(skeleton: &Skeleton, error: f32) -> Mesh {
    let mut surface = Surface::default();
    for axis in skeleton.axes(Continuation::Thickest).iter() {
        let at = |place: u32, radius: u32| {
            let r = skeleton.radii()[radius as usize].max(RADIUS_MIN);
            (skeleton.positions()[place as usize], r)
        };
        let fork = axis.nodes.first().and_then(|&n| skeleton.parent(n).map(|fork| at(fork, n)));
        let mut nodes: Vec<(Vec3, f32)> = fork.into_iter().collect();
        for &node in axis.nodes {
            let (place, r) = at(node, node);
            if nodes.last().is_none_or(|last| last.0.distance(place) > MERGE_SHARE * last.1.max(r))
            {
                nodes.push((place, r));
            }
        }
        tube(&rings(&nodes, error), error, &mut surface);
    }
    surface.normals = vec![Vec3::Y; surface.positions.len()];
    surface.uvs = vec![Vec2::ZERO; surface.positions.len()];
    Mesh { surfaces: vec![surface], materials: vec![Material::default()], ..Mesh::default() }
}

/// Places and radii along the cubic.
fn rings(nodes: &[(Vec3, f32)], error: f32) -> Vec<(Vec3, f32)> {
    let slope = |i: usize| (nodes[i + 1].0 - nodes[i].0).normalize_or_zero();
    let length = |i: usize| nodes[i + 1].0.distance(nodes[i].0);
    let last = nodes.len().saturating_sub(1);
    let tangent = |i: usize| match i {
        _ if last == 0 => Vec3::ZERO,
        0 => slope(0),
        i if i == last => slope(i - 1),
        i => (slope(i - 1) * length(i) + slope(i) * length(i - 1)) / (length(i - 1) + length(i)),
    };
    let mut rings = Vec::new();
    for i in 0..last {
        let ((a, ra), (b, rb)) = (nodes[i], nodes[i + 1]);
        let (m0, m1, h) = (tangent(i), tangent(i + 1), length(i));
        let bend = |s: f32, t: f32| (6.0 * (b - a) - h * (s * m0 + t * m1)).length();
        let turn = (m0.normalize_or_zero() - m1.normalize_or_zero()).length_squared();
        let off = bend(4.0, 2.0).max(bend(2.0, 4.0)) + ra.max(rb) * turn;
        let n = (off / (8.0 * error)).sqrt().ceil().clamp(1.0, MAX_SAMPLES);
        for k in 0..n as u32 {
            let t = k as f32 / n;
            let s = 1.0 - t;
            let place = a * (s * s * (1.0 + 2.0 * t))
                + b * (t * t * (1.0 + 2.0 * s))
                + (m0 * s - m1 * t) * (h * s * t);
            rings.push((place, ra + t * (rb - ra)));
        }
    }
    rings.extend(nodes.last());
    rings
}

fn tube(rings: &[(Vec3, f32)], error: f32, out: &mut Surface) {
    let Some(&widest) = rings.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else {
        return;
    };
    if rings.len() < 2 {
        return;
    }
    // One count for the whole tube, of its widest ring: strips of unequal rings are not copied here.
    // To be fair to the plain mesh, tubes are cut where the count they need has halved.
    let n_sides = |r: f32| {
        let cosine = 1.0 - (error / r).min(0.999);
        (std::f32::consts::PI / libm::acosf(cosine)).ceil().clamp(SIDES.0, SIDES.1)
    };
    let n = n_sides(widest.1) as u32;
    let half = rings.iter().position(|r| 2.0 * n_sides(r.1) <= n as f32).unwrap_or(rings.len());
    let (own, rest) = rings.split_at(half.clamp(2, rings.len()));
    let mut direction = (own[1].0 - own[0].0).normalize_or(Vec3::Y);
    let mut normal = direction.any_orthonormal_vector();
    let first = out.positions.len() as u32;
    for (i, &(place, radius)) in own.iter().enumerate() {
        let next = own.get(i + 1).or(rest.first()).map_or(direction, |ahead| ahead.0 - place);
        let tangent = (direction + next.normalize_or(direction)).normalize_or(direction);
        direction = next.normalize_or(direction);
        let across = normal - tangent * tangent.dot(normal);
        normal = across.try_normalize().unwrap_or_else(|| tangent.any_orthonormal_vector());
        let binormal = tangent.cross(normal);
        for k in 0..n {
            let angle = std::f32::consts::TAU * k as f32 / n as f32;
            let arm = normal * libm::cosf(angle) + binormal * libm::sinf(angle);
            out.positions.push(place + radius * arm);
        }
    }
    for ring in 0..own.len() as u32 - 1 {
        for k in 0..n {
            let (a, b) = (first + ring * n + k, first + ring * n + (k + 1) % n);
            out.indices.extend([a, b, b + n, a, b + n, a + n]);
        }
    }
    if !rest.is_empty() {
        // The next piece starts at the last ring of this one.
        tube(&rings[own.len() - 1..], error, out);
    }
}
