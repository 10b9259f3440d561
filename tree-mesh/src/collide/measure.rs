//! How much of the wood lies in the capsules.

use super::Capsule;
use super::wood::Frustum;
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::Control;

/// Discs across each frustum.
const SLICES: u32 = 3;
/// Points on each disc.
const POINTS: u32 = 8;
/// Frusta of one piece of work.
const FRUSTA_PER_PART: usize = 256;

/// The share of the frusta's volume that lies in a capsule, by points spread evenly through each.
pub(super) fn held(frusta: &[Frustum], capsules: &[Capsule], control: &Control) -> Result<f64> {
    let parts: Vec<(f64, f64)> = frusta
        .par_chunks(FRUSTA_PER_PART)
        .map(|frusta| {
            control.check()?;
            Ok(frusta.iter().fold((0.0, 0.0), |(inside, all), frustum| {
                let (more, volume) = held_of(frustum, capsules);
                (inside + more, all + volume)
            }))
        })
        .collect::<Result<_>>()?;
    let (inside, all) =
        parts.iter().fold((0.0, 0.0), |(inside, all), part| (inside + part.0, all + part.1));
    Ok(if all > 0.0 { (inside / all).min(1.0) } else { 1.0 })
}

/// Volume of a frustum inside the capsules, and all of it.
fn held_of(frustum: &Frustum, capsules: &[Capsule]) -> (f64, f64) {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    let along = frustum.b - frustum.a;
    let direction = along.normalize_or(Vec3::Y);
    let across = direction.any_orthonormal_vector();
    let up = direction.cross(across);
    let (mut inside, mut all) = (0.0, 0.0);
    for slice in 0..SLICES {
        let t = (slice as f32 + 0.5) / SLICES as f32;
        let radius = frustum.radius_a + (frustum.radius_b - frustum.radius_a) * t;
        let weight = f64::from(radius) * f64::from(radius);
        for point in 0..POINTS {
            // A sunflower: equal areas, the outermost near the bark.
            let out = radius * ((point as f32 + 0.5) / POINTS as f32).sqrt();
            let (sin, cos) = libm::sincosf(GOLDEN_ANGLE * (point + slice * POINTS) as f32);
            let at = frustum.a + along * t + (across * cos + up * sin) * out;
            all += weight;
            if capsules.iter().any(|capsule| capsule.contains(at)) {
                inside += weight;
            }
        }
    }
    let volume = frustum.volume();
    if all > 0.0 { (volume * inside / all, volume) } else { (0.0, volume) }
}
