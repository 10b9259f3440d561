//! The colour of what a sample sees.
//!
//! Light on a surface is the sum of
//! 1. the sun on its front, by Lambert, where the sun's depth map says it is reached;
//! 2. the sky, by direction, each weighted by its cosine and its depth map;
//! 3. light thrown back by the ground and between leaves;
//! 4. for leaves, sun and sky on the back that shine through, yellower and more saturated: light that
//!    passed a leaf went through its pigments twice;
//! 5. gloss of the sun (Trowbridge, Reitz 1975, in the mobile form of Karis 2013, which needs no
//!    transcendental function).

use super::camera::Projector;
use super::scene::{Cover, Scene};
use super::shadow::DepthMap;
use super::style::{Backdrop, Style};
use glam::Vec3;
use tree_core::Seed;

/// Distance from a surface, in texels of the sun's map, at which its own shadow begins. Less gives
/// shadow acne, more detaches shadows.
const SUN_BIAS_TEXELS: f32 = 2.0;
/// Depth over which the sun's shadow sets in, in texels.
const SUN_SOFT_TEXELS: f32 = 2.0;
/// As the two above, for the sky's maps. The depth is generous: leaves just behind leaves still get
/// light that passed through those.
const SKY_BIAS_TEXELS: f32 = 1.0;
const SKY_SOFT_TEXELS: f32 = 5.0;
/// Sky light that arrives even in the densest crown, by scattering between leaves.
const SCATTERED: f32 = 0.10;
/// Distance at which haze over the ground has a quarter of its strength, in sizes of the mesh.
const HAZE_REACH: f32 = 9.0;
/// Light reflected by a surface of no roughness seen head-on (glass and wax: 4 %;
/// less here, because the broken surface of leaves and bark scatters most of it).
const REFLECTANCE: f32 = 0.022;

/// Light and scene, ready to shade.
pub(super) struct Shader<'a> {
    pub(super) scene: &'a Scene<'a>,
    pub(super) style: &'a Style,
    pub(super) sun: Vec3,
    pub(super) sun_map: Option<DepthMap>,
    pub(super) sky: Vec<SkyLight>,
    /// Largest texel of the sky's maps, in metres.
    pub(super) sky_texel: f32,
    /// What the ground throws back where the sun shines.
    pub(super) bounce: Vec3,
    pub(super) noise: Seed,
}

/// Light from one direction of the sky.
pub(super) struct SkyLight {
    pub(super) direction: Vec3,
    /// Weighted so that the sum over directions, times cosine, is the light on a surface.
    pub(super) light: Vec3,
    /// None if nothing casts shade.
    pub(super) map: Option<DepthMap>,
}

/// Sky light on the two sides of a surface.
struct Ambient {
    front: Vec3,
    back: Vec3,
    /// Share of the sky that is seen.
    open: f32,
}

/// Where a ray meets a triangle.
pub(crate) struct Hit {
    pub(super) surface: usize,
    pub(crate) position: Vec3,
    /// Unit length, towards where the ray comes from if the material has two sides.
    pub(crate) normal: Vec3,
    /// Linear.
    pub(crate) albedo: Vec3,
}

impl Scene<'_> {
    /// The point of a triangle that a ray meets, or the nearest to it. `scale` is that of the
    /// [`Projector`], `per_pixel` the share of a pixel that a sample is.
    pub(crate) fn hit(
        &self,
        triangle: u32,
        (origin, direction): (Vec3, Vec3),
        perspective: bool,
        scale: f32,
        per_pixel: f32,
    ) -> Hit {
        let number = self.surface_of(triangle, 0);
        let rows = self.rows(number, triangle);
        let surface = self.surface(number);
        let skin = self.skin(number);
        // Möller, Trumbore 1997: barycentric coordinates of the ray on the plane.
        let [a, b, c] = rows.map(|row| surface.positions[row]);
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let facing = ab.dot(p);
        let from_a = origin - a;
        let (mut u, mut v) = (1.0 / 3.0, 1.0 / 3.0);
        if facing != 0.0 {
            u = (from_a.dot(p) / facing).clamp(0.0, 1.0);
            v = (direction.dot(from_a.cross(ab)) / facing).clamp(0.0, 1.0 - u);
        }
        let position = a + ab * u + ac * v;
        let [na, nb, nc] = rows.map(|row| surface.normals[row]);
        let mut normal = (na + (nb - na) * u + (nc - na) * v).normalize_or(Vec3::Y);
        let view = -direction.normalize();
        let behind = if skin.double_sided { normal.dot(view) < 0.0 } else { facing < 0.0 };
        if behind {
            normal = -normal;
        }
        let mut albedo = skin.color;
        if let Some(pyramid) = self.pyramid(skin) {
            let uvs = rows.map(|row| surface.uvs[row]);
            let [ta, tb, tc] = uvs;
            let uv = ta + (tb - ta) * u + (tc - ta) * v;
            let distance = if perspective {
                direction.dot(position - origin) / direction.length_squared()
            } else {
                1.0
            };
            let pixels = facing.abs() * (scale / distance) * (scale / distance) * per_pixel;
            let level = pyramid.level(pyramid.texel_area(uvs) / pixels);
            albedo *= level.color(uv.x, uv.y, skin.cover == Cover::Masked, self.srgb);
        }
        Hit { surface: number, position, normal, albedo }
    }
}

impl Shader<'_> {
    /// The colour of a triangle where the ray meets it.
    pub(super) fn triangle(
        &self,
        triangle: u32,
        ray: (Vec3, Vec3),
        projector: &Projector,
        per_pixel: f32,
    ) -> Vec3 {
        let hit = self.scene.hit(triangle, ray, projector.perspective, projector.scale, per_pixel);
        let skin = self.scene.skin(hit.surface);
        self.surface(
            hit.position,
            hit.normal,
            -ray.1.normalize(),
            hit.albedo.min(Vec3::ONE),
            skin.roughness,
            skin.translucency,
        )
    }

    fn surface(
        &self,
        position: Vec3,
        normal: Vec3,
        view: Vec3,
        albedo: Vec3,
        roughness: f32,
        translucency: f32,
    ) -> Vec3 {
        let sun_cosine = normal.dot(self.sun);
        let shining = self.sun_at(position, normal, sun_cosine, translucency > 0.0);
        let ambient = self.ambient(position, normal, translucency > 0.0);
        let sun = self.style.sun_light() * shining;
        // Light that is thrown back from below, and between leaves.
        let bounce = self.bounce * ((0.5 - 0.5 * normal.y) * (0.25 + 0.75 * ambient.open));
        let mut light = albedo * (sun * sun_cosine.max(0.0) + ambient.front + bounce);
        if translucency > 0.0 {
            let strongest = albedo.max_element().max(1e-4);
            let saturated = albedo.lerp(albedo * albedo / strongest, 0.5);
            let through = saturated * Vec3::new(1.25, 1.2, 0.75) * translucency;
            light = light * (1.0 - 0.3 * translucency)
                + through * (sun * (1.3 * (-sun_cosine).max(0.0)) + ambient.back);
        }
        if shining > 0.0 && sun_cosine > 0.0 {
            light += sun * (sun_cosine * gloss(normal, view, self.sun, roughness));
        }
        // Sky mirrored at grazing angles.
        let grazing = 1.0 - normal.dot(view).max(0.0);
        let grazing = grazing * grazing * grazing;
        let mirrored = (REFLECTANCE + 0.2 * grazing) * (1.0 - roughness) * (1.0 - roughness);
        light + ambient.front * mirrored
    }

    fn sun_at(&self, position: Vec3, normal: Vec3, cosine: f32, two_sided: bool) -> f32 {
        if self.style.sun == 0.0 || (cosine <= 0.0 && !two_sided) {
            return 0.0;
        }
        let Some(map) = &self.sun_map else { return 1.0 };
        // Off the surface, on the sunny side: the flatter the light the further, since a texel
        // then spans more depth.
        let outward = if cosine < 0.0 { -normal } else { normal };
        let slope = (1.0 - cosine * cosine).max(0.0).sqrt();
        let bias = map.texel * SUN_BIAS_TEXELS;
        let shifted = position + outward * (bias * slope) + self.sun * bias;
        map.smooth_light_at(shifted, SUN_SOFT_TEXELS * map.texel)
    }

    fn ambient(&self, position: Vec3, normal: Vec3, two_sided: bool) -> Ambient {
        let mut ambient = Ambient { front: Vec3::ZERO, back: Vec3::ZERO, open: 0.0 };
        let bias = SKY_BIAS_TEXELS * self.sky_texel;
        let (before, after) = (position + normal * bias, position - normal * bias);
        for sky in &self.sky {
            let cosine = normal.dot(sky.direction);
            if cosine <= 0.0 && !two_sided {
                continue;
            }
            let seen = match &sky.map {
                Some(map) => {
                    let shifted = if cosine < 0.0 { after } else { before };
                    let hidden = map.light_at(shifted, bias, SKY_SOFT_TEXELS * self.sky_texel);
                    SCATTERED + (1.0 - SCATTERED) * hidden
                }
                None => 1.0,
            };
            ambient.open += seen;
            let light = sky.light * (seen * cosine.abs());
            if cosine > 0.0 {
                ambient.front += light;
            } else {
                ambient.back += light;
            }
        }
        ambient.open /= self.sky.len().max(1) as f32;
        ambient
    }

    /// The colour of the ground where the ray meets it. `per_sample` is the angle of a pixel.
    pub(super) fn ground(&self, height: f32, ray: (Vec3, Vec3), angle: f32) -> Vec3 {
        let (origin, direction) = ray;
        let distance = (height - origin.y) / direction.y;
        if !(distance > 0.0 && distance < 1e7) {
            return self.style.backdrop(direction.normalize(), self.sun);
        }
        let position = origin + direction * distance;
        let mut albedo = Vec3::from_array(self.style.ground_color);
        if self.style.backdrop == Backdrop::Sky {
            albedo *= self.tufts(position, distance * angle);
        }
        let shining = match &self.sun_map {
            Some(map) => map.smooth_light_at(position, 0.5 * map.texel),
            None => 1.0,
        };
        let mut light = self.style.sun_light() * (shining * self.sun.y);
        for sky in &self.sky {
            let seen = match &sky.map {
                Some(map) => map.light_at(position, 0.0, 0.5 * map.texel),
                None => 1.0,
            };
            light += sky.light * (seen * sky.direction.y);
        }
        // Distance takes the colour of the horizon.
        let reach = HAZE_REACH * self.scene.size.max(1.0);
        let flat = Vec3::new(position.x - origin.x, 0.0, position.z - origin.z).length_squared();
        let haze = flat / (flat + reach * reach);
        let far = self
            .style
            .backdrop(Vec3::new(direction.x, 0.0, direction.z).normalize_or(Vec3::X), self.sun);
        (albedo * light).lerp(far, haze * haze)
    }

    /// Light and dark patches of the ground, around 1, without detail finer than `footprint`.
    fn tufts(&self, position: Vec3, footprint: f32) -> Vec3 {
        let mut sum = 0.0;
        // Size in metres and strength.
        for (octave, (size, strength)) in
            [(3.1, 0.16), (0.7, 0.14), (0.16, 0.20), (0.045, 0.26)].into_iter().enumerate()
        {
            let fine = footprint / size;
            let faded = strength / (1.0 + 4.0 * fine * fine);
            sum +=
                faded * (self.noise_at(octave as u64, position.x / size, position.z / size) - 0.5);
        }
        Vec3::new(1.0 + 2.1 * sum, 1.0 + 1.8 * sum, 1.0 + 1.4 * sum).max(Vec3::splat(0.2))
    }

    /// Smooth noise, 0 to 1: random values on a lattice, interpolated.
    fn noise_at(&self, octave: u64, x: f32, z: f32) -> f32 {
        let (column, row) = (libm::floorf(x), libm::floorf(z));
        let ease = |t: f32| t * t * (3.0 - 2.0 * t);
        let (fx, fz) = (ease(x - column), ease(z - row));
        let value = |dx: i64, dz: i64| {
            let (cx, cz) = (column as i64 + dx, row as i64 + dz);
            self.noise
                .unit(octave ^ (cx as u64 & 0x3fff_ffff) << 4 ^ (cz as u64 & 0x3fff_ffff) << 34)
        };
        let near = value(0, 0) * (1.0 - fx) + value(1, 0) * fx;
        let far = value(0, 1) * (1.0 - fx) + value(1, 1) * fx;
        near * (1.0 - fz) + far * fz
    }
}

/// Highlight of a light, per unit of its strength on the surface.
fn gloss(normal: Vec3, view: Vec3, light: Vec3, roughness: f32) -> f32 {
    let half = (view + light).normalize_or(normal);
    let n_h = normal.dot(half).max(0.0);
    let l_h = light.dot(half).max(0.1);
    let a = (roughness * roughness).max(0.02);
    let d = n_h * n_h * (a * a - 1.0) + 1.0;
    REFLECTANCE * a * a / (d * d * l_h * l_h * (roughness + 0.5) * 4.0)
}
