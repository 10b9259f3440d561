//! Mean colour of the foliage: what the contrast of colours is lowered towards (Cook et al. 2007).
//!
//! The texture is sampled where leaves show it, at [`SPOTS`] on each of up to [`TRIANGLES_MAX`] triangles,
//! weighted by their area; what is cut off does not count.

use glam::{DVec3, Vec2, Vec3};
use tree_mesh::{Alpha, Material, Surface, Texture};

/// Most triangles that are looked at: more hardly change the mean.
const TRIANGLES_MAX: usize = 4096;
/// Rows of samples in a triangle: 10 samples.
const SPOTS: usize = 4;

/// Mean linear colour of what is seen of these triangles; the base colour where nothing is.
///
/// # Complexity
/// O(1): at most 40,960 samples.
pub(super) fn mean(surface: &Surface, material: &Material, indices: &[u32]) -> Vec3 {
    let [r, g, b, alpha] = material.base_color;
    let base = Vec3::new(r, g, b);
    let Some(texture) = &material.texture else { return base };
    let cutoff = match material.alpha {
        Alpha::Opaque => 0.0,
        Alpha::Mask(cutoff) => cutoff,
    };
    let decode = linear();
    let (triangles, _) = indices.as_chunks::<3>();
    let step = triangles.len().div_ceil(TRIANGLES_MAX).max(1);
    let (mut sum, mut weights) = (DVec3::ZERO, 0.0);
    for triangle in triangles.iter().step_by(step) {
        let [a, b, c] = triangle.map(|vertex| surface.positions[vertex as usize]);
        let area = f64::from((b - a).cross(c - a).length());
        let uvs = triangle.map(|vertex| surface.uvs[vertex as usize]);
        for uv in spots(uvs) {
            let texel = texel(texture, uv);
            if alpha * f32::from(texel[3]) / 255.0 >= cutoff {
                let [r, g, b] = [0, 1, 2].map(|k| decode[usize::from(texel[k])]);
                sum += area * DVec3::new(r, g, b);
                weights += area;
            }
        }
    }
    let mean = sum / weights;
    if mean.is_finite() { base * mean.as_vec3() } else { base }
}

/// Places spread evenly within a triangle.
fn spots([a, b, c]: [Vec2; 3]) -> impl Iterator<Item = Vec2> {
    let at = |i: usize| (i as f32 + 1.0 / 3.0) / SPOTS as f32;
    (0..SPOTS).flat_map(move |i| (0..SPOTS - i).map(move |j| a + (b - a) * at(i) + (c - a) * at(j)))
}

/// The nearest texel of a texture that repeats.
fn texel(texture: &Texture, uv: Vec2) -> [u8; 4] {
    let place =
        |t: f32, size: u32| (((t - t.floor()) * size as f32) as usize).min(size as usize - 1);
    let (texels, _) = texture.pixels.as_chunks::<4>();
    let (x, y) = (place(uv.x, texture.width), place(uv.y, texture.height));
    texels.get(y * texture.width as usize + x).copied().unwrap_or_default()
}

/// Linear light of each sRGB byte (IEC 61966-2-1).
fn linear() -> [f64; 256] {
    std::array::from_fn(|byte| {
        let c = byte as f64 / 255.0;
        if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    /// A card in the unit square, its texture half white, half black and see-through.
    fn card() -> (Surface, Material) {
        let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        let surface = Surface {
            positions: corners.map(|p| p.extend(0.0)).to_vec(),
            uvs: corners.to_vec(),
            indices: vec![0, 1, 2, 0, 2, 3],
            ..Surface::default()
        };
        let pixels = vec![255, 255, 255, 255, 0, 0, 0, 0];
        let texture = Texture { name: "half".into(), width: 2, height: 1, pixels };
        let base_color = [0.5, 0.25, 1.0, 1.0];
        let texture = Some(Arc::new(texture));
        (surface, Material { base_color, texture, ..Material::default() })
    }

    #[test]
    fn what_is_cut_off_does_not_count() {
        let (surface, mut material) = card();
        material.alpha = Alpha::Mask(0.5);
        let found = mean(&surface, &material, &surface.indices);
        assert!(found.abs_diff_eq(Vec3::new(0.5, 0.25, 1.0), 1e-6), "{found}");
        material.alpha = Alpha::Opaque;
        let found = mean(&surface, &material, &surface.indices);
        assert!(found.abs_diff_eq(Vec3::new(0.25, 0.125, 0.5), 0.05), "{found}");
    }

    #[test]
    fn without_area_it_is_the_base_colour() {
        let (mut surface, material) = card();
        surface.positions.fill(Vec3::X);
        surface.uvs.fill(Vec2::splat(1e30));
        let found = mean(&surface, &material, &surface.indices);
        assert_eq!(found, Vec3::new(0.5, 0.25, 1.0));
    }
}
