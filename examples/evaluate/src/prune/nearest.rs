//! Which element is nearest in each pixel: depths and numbers by a plain rasterizer, seen from the side
//! in parallel projection.

use tree_core::glam::{Vec2, Vec3};
use tree_mesh::{Alpha, Mesh, Surface, Texture};

/// Pixels in which wood is nearest, and those of each element.
pub(super) struct Seen {
    pub(super) wood: u64,
    pub(super) elements: Vec<u64>,
}

impl Seen {
    /// Pixels that are covered.
    pub(super) fn covered(&self) -> u64 {
        self.wood + self.elements.iter().sum::<u64>()
    }
}

/// Number of wood.
const WOOD: u32 = u32::MAX;

/// Counts the pixels of each element over some azimuths (radians). `owners` tells the element of each triangle
/// of each surface. The picture is `size` pixels high and wide and shows a ball.
pub(super) fn nearest(
    mesh: &Mesh,
    owners: &[Option<Vec<u32>>],
    n_elements: usize,
    (center, radius): (Vec3, f32),
    azimuths: &[f32],
    size: u32,
) -> Seen {
    let mut seen = Seen { wood: 0, elements: vec![0; n_elements] };
    let n = (size * size) as usize;
    for &azimuth in azimuths {
        let mut target = Target { size, depths: vec![f32::NEG_INFINITY; n], owners: vec![None; n] };
        let (sin, cos) = libm::sincosf(azimuth);
        let per = 0.5 * size as f32 / radius;
        let place = |p: Vec3| {
            let p = p - center;
            let x = cos * p.x - sin * p.z;
            let half = 0.5 * size as f32;
            Vec3::new(half + per * x, half - per * p.y, sin * p.x + cos * p.z)
        };
        for (surface, owners) in mesh.surfaces.iter().zip(owners) {
            let material = &mesh.materials[surface.material as usize];
            let masked = match material.alpha {
                Alpha::Mask(cut) => material.texture.as_deref().map(|texture| (texture, cut)),
                _ => None,
            };
            for (t, rows) in surface.indices.as_chunks::<3>().0.iter().enumerate() {
                let owner = owners.as_ref().map_or(WOOD, |owners| owners[t]);
                target.triangle(surface, *rows, place, masked, owner);
            }
        }
        for owner in target.owners.into_iter().flatten() {
            match owner {
                WOOD => seen.wood += 1,
                element => seen.elements[element as usize] += 1,
            }
        }
    }
    seen
}

struct Target {
    size: u32,
    /// Towards the eye.
    depths: Vec<f32>,
    owners: Vec<Option<u32>>,
}

impl Target {
    fn triangle(
        &mut self,
        surface: &Surface,
        rows: [u32; 3],
        place: impl Fn(Vec3) -> Vec3,
        masked: Option<(&Texture, f32)>,
        owner: u32,
    ) {
        let [a, b, c] = rows.map(|i| place(surface.positions[i as usize]));
        let uvs = rows.map(|i| surface.uvs[i as usize]);
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        if area == 0.0 {
            return;
        }
        let last = self.size as f32 - 1.0;
        let low = a.min(b).min(c).floor().clamp(Vec3::ZERO, Vec3::splat(last));
        let high = a.max(b).max(c).ceil().clamp(Vec3::ZERO, Vec3::splat(last));
        for y in low.y as u32..=high.y as u32 {
            for x in low.x as u32..=high.x as u32 {
                let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let side = |from: Vec3, to: Vec3| {
                    (to - from).truncate().perp_dot(p - from.truncate()) / area
                };
                let weights = [side(b, c), side(c, a), side(a, b)];
                if weights.iter().any(|&w| w < 0.0) {
                    continue;
                }
                let depth = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
                let at = (y * self.size + x) as usize;
                if depth <= self.depths[at] {
                    continue;
                }
                let uv = weights[0] * uvs[0] + weights[1] * uvs[1] + weights[2] * uvs[2];
                if masked.is_none_or(|(texture, cut)| alpha(texture, uv) >= cut) {
                    self.depths[at] = depth;
                    self.owners[at] = Some(owner);
                }
            }
        }
    }
}

/// Alpha of the nearest texel, 0 to 1; the picture repeats.
fn alpha(texture: &Texture, uv: Vec2) -> f32 {
    let texel = |t: f32, n: u32| (((t - t.floor()) * n as f32) as u32).min(n - 1);
    let (x, y) = (texel(uv.x, texture.width), texel(uv.y, texture.height));
    f32::from(texture.pixels[4 * (y * texture.width + x) as usize + 3]) / 255.0
}
