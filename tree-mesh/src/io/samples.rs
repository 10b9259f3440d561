//! Meshes and broken files for the tests of this folder.

use crate::mesh::{Alpha, Material, Mesh, Surface, Texture};
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// Numbers without pattern, the same every time (`SplitMix64`, Steele et al. 2014).
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// 0 to n − 1.
    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// 0 to 1.
    pub(super) fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / 16_777_215.0
    }

    pub(super) fn between(&mut self, min: f32, max: f32) -> f32 {
        min + (max - min) * self.unit()
    }

    fn direction(&mut self) -> Vec3 {
        let v = Vec3::from(std::array::from_fn(|_| self.between(-1.0, 1.0)));
        v.try_normalize().unwrap_or(Vec3::X)
    }
}

/// A mesh of one to three surfaces, each of a material of its own, with or without the optional
/// columns, texture coordinates within 0 to 1 or beyond.
pub(super) fn mesh(seed: u64) -> Mesh {
    let mut dice = Dice(seed);
    let mut mesh = Mesh::default();
    let texture = Arc::new(texture(&mut dice));
    let spread = [0.01, 1.0, 30.0, 5000.0][dice.below(4)];
    for number in 0..1 + dice.below(3) {
        mesh.surfaces.push(surface(&mut dice, spread, number as u32));
        mesh.materials.push(Material {
            name: format!("material {number}"),
            base_color: std::array::from_fn(|_| dice.unit()),
            texture: (dice.below(3) > 0).then(|| Arc::clone(&texture)),
            roughness: dice.unit(),
            alpha: if dice.below(2) == 0 { Alpha::Opaque } else { Alpha::Mask(dice.unit()) },
            double_sided: dice.below(2) == 0,
            translucency: if dice.below(2) == 0 { 0.0 } else { dice.unit() },
        });
    }
    mesh
}

fn texture(dice: &mut Dice) -> Texture {
    let (width, height) = (1 + dice.below(5) as u32, 1 + dice.below(5) as u32);
    let pixels = (0..4 * width * height).map(|_| dice.bits() as u8).collect();
    Texture { name: "some leaf".into(), width, height, pixels }
}

fn surface(dice: &mut Dice, spread: f32, material: u32) -> Surface {
    let n = 3 + dice.below(40);
    let center = dice.direction() * spread;
    let tiles = dice.below(2) == 0;
    let uv = |dice: &mut Dice| {
        let (min, max) = if tiles { (-3.0, 9.0) } else { (0.0, 1.0) };
        Vec2::new(dice.between(min, max), dice.between(min, max))
    };
    // Every vertex is the corner of some triangle: formats that list corners keep no others.
    let mut indices: Vec<u32> = (0..n as u32).collect();
    while !indices.len().is_multiple_of(3) || dice.below(4) > 0 {
        indices.push(dice.below(n) as u32);
    }
    let mut surface = Surface {
        positions: (0..n).map(|_| center + dice.direction() * spread * dice.unit()).collect(),
        normals: (0..n).map(|_| dice.direction()).collect(),
        uvs: (0..n).map(|_| uv(dice)).collect(),
        indices,
        material,
        ..Default::default()
    };
    if dice.below(2) == 0 {
        surface.tangents = (0..n)
            .map(|_| dice.direction().extend(if dice.below(2) == 0 { 1.0 } else { -1.0 }))
            .collect();
    }
    if dice.below(2) == 0 {
        surface.uvs2 = (0..n).map(|_| Vec2::new(dice.unit(), dice.unit())).collect();
    }
    if dice.below(2) == 0 {
        surface.occlusion = (0..n).map(|_| dice.unit()).collect();
    }
    surface
}

/// A valid file, damaged: bytes turned over, numbers replaced by extreme ones, parts cut out or
/// doubled, ends cut off.
pub(super) fn damaged(file: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut file = file.to_vec();
    for _ in 0..1 + dice.below(4) {
        if file.is_empty() {
            break;
        }
        let at = dice.below(file.len());
        match dice.below(6) {
            0 => file[at] ^= 1 << dice.below(8),
            1 => file[at] = dice.bits() as u8,
            2 => file.truncate(at),
            3 => {
                let end = at + dice.below(file.len() - at).min(64);
                file.drain(at..end);
            }
            4 => {
                let part = file[at..at + dice.below(file.len() - at).min(64)].to_vec();
                file.splice(at..at, part);
            }
            _ => replace_number(&mut file, at, dice),
        }
    }
    file
}

/// Replaces the decimal number behind `at`, if there is one near.
fn replace_number(file: &mut Vec<u8>, at: usize, dice: &mut Dice) {
    const EXTREME: [&str; 10] = [
        "0",
        "-1",
        "1",
        "4294967295",
        "4294967296",
        "18446744073709551615",
        "9223372036854775807",
        "1e39",
        "99999999999999999999",
        "2000000000",
    ];
    let end = file.len().min(at + 200);
    let Some(start) = file[at..end].iter().position(u8::is_ascii_digit) else { return };
    let start = at + start;
    let length = file[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    file.splice(start..start + length, EXTREME[dice.below(EXTREME.len())].bytes());
}

/// Whether an error of a reader is one that says what is wrong with the file.
pub(super) fn is_typed(error: &crate::MeshError) -> bool {
    use crate::MeshError as E;
    matches!(
        error,
        E::Malformed { .. }
            | E::External { .. }
            | E::Unsupported { .. }
            | E::Limit(_)
            | E::NotFinite { .. }
            | E::TooManyVertices { .. }
    )
}
