//! Surfaces whose topology is known, for tests.

use crate::mesh::Surface;
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

pub(crate) fn surface(positions: Vec<Vec3>, indices: Vec<u32>) -> Surface {
    let n = positions.len();
    let normals = vec![Vec3::Y; n];
    Surface { positions, normals, uvs: vec![Vec2::ZERO; n], indices, ..Default::default() }
}

/// A cube with corners at ±1; every face has its own four vertices and its normal.
pub(crate) fn cube() -> Surface {
    let mut cube = surface(Vec::new(), Vec::new());
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = Vec3::from_array([0, 1, 2].map(|k| if k == axis { sign } else { 0.0 }));
            let across = Vec3::from_array([0, 1, 2].map(|k| f32::from(k == (axis + 1) % 3)));
            let other = normal.cross(across);
            let first = cube.positions.len() as u32;
            for (s, t) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                cube.positions.push(normal + s * across + t * other);
                cube.normals.push(normal);
                cube.uvs.push(Vec2::new(s, t));
            }
            cube.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
        }
    }
    cube
}

/// A unit ball of `n` rings of 2n vertices; the seam is doubled, and so is every vertex of the poles.
pub(crate) fn ball(n: u32) -> Surface {
    let mut ball = surface(Vec::new(), Vec::new());
    for i in 0..=n {
        for j in 0..=2 * n {
            let (theta, phi) =
                (PI * i as f32 / n as f32, TAU * (j % (2 * n)) as f32 / (2 * n) as f32);
            let pole = i == 0 || i == n;
            let sine = if pole { 0.0 } else { libm::sinf(theta) };
            let place =
                Vec3::new(sine * libm::cosf(phi), libm::cosf(theta), -sine * libm::sinf(phi));
            ball.positions.push(place);
            ball.normals.push(place.normalize());
            ball.uvs.push(Vec2::new(j as f32 / (2 * n) as f32, i as f32 / n as f32));
        }
    }
    let at = |i: u32, j: u32| i * (2 * n + 1) + j;
    for i in 0..n {
        for j in 0..2 * n {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            if i + 1 < n {
                ball.indices.extend([a, b, c]);
            }
            if i > 0 {
                ball.indices.extend([a, c, d]);
            }
        }
    }
    ball
}

/// A torus of radii 1 and `thin`, without copies.
pub(crate) fn torus(n: u32, m: u32, thin: f32) -> Surface {
    let mut torus = surface(Vec::new(), Vec::new());
    for i in 0..n {
        for j in 0..m {
            let (u, v) = (TAU * i as f32 / n as f32, TAU * j as f32 / m as f32);
            let outward = Vec3::new(libm::cosf(u), 0.0, libm::sinf(u));
            let normal = outward * libm::cosf(v) + Vec3::Y * libm::sinf(v);
            torus.positions.push(outward + thin * normal);
            torus.normals.push(normal);
            torus.uvs.push(Vec2::ZERO);
        }
    }
    let at = |i: u32, j: u32| (i % n) * m + j % m;
    for i in 0..n {
        for j in 0..m {
            let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
            torus.indices.extend([a, b, c, a, c, d]);
        }
    }
    torus
}

/// A closed cylinder of height 2 and radius 1 on the ground: a trunk. The rims have copies with
/// normals of wall and caps; the wall has a seam.
pub(crate) fn cylinder(n: u32, rings: u32) -> Surface {
    let mut trunk = surface(Vec::new(), Vec::new());
    let corner = |k: u32| {
        let angle = TAU * (k % n) as f32 / n as f32;
        Vec3::new(libm::cosf(angle), 0.0, -libm::sinf(angle))
    };
    let mut add = |place: Vec3, normal: Vec3, uv: Vec2| {
        trunk.positions.push(place);
        trunk.normals.push(normal);
        trunk.uvs.push(uv);
        trunk.positions.len() as u32 - 1
    };
    for ring in 0..=rings {
        let height = 2.0 * ring as f32 / rings as f32;
        for k in 0..=n {
            add(corner(k) + height * Vec3::Y, corner(k), Vec2::new(k as f32 / n as f32, height));
        }
    }
    let mut caps = Vec::new();
    for (height, normal) in [(0.0, Vec3::NEG_Y), (2.0, Vec3::Y)] {
        caps.push(add(height * Vec3::Y, normal, Vec2::ZERO));
        for k in 0..n {
            add(corner(k) + height * Vec3::Y, normal, corner(k).truncate());
        }
    }
    for ring in 0..rings {
        for k in 0..n {
            let a = ring * (n + 1) + k;
            let (b, c, d) = (a + 1, a + n + 2, a + n + 1);
            trunk.indices.extend([a, b, c, a, c, d]);
        }
    }
    for k in 0..n {
        let (this, next) = (1 + k, 1 + (k + 1) % n);
        trunk.indices.extend([caps[0], caps[0] + next, caps[0] + this]);
        trunk.indices.extend([caps[1], caps[1] + this, caps[1] + next]);
    }
    trunk
}

/// Both surfaces in one, the second moved.
pub(crate) fn both(a: &Surface, b: &Surface, by: Vec3) -> Surface {
    let mut sum = a.clone();
    let first = a.positions.len() as u32;
    sum.positions.extend(b.positions.iter().map(|&p| p + by));
    sum.normals.extend(&b.normals);
    sum.uvs.extend(&b.uvs);
    sum.indices.extend(b.indices.iter().map(|&i| first + i));
    sum
}
