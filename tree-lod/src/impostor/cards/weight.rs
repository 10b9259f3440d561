//! How much each plane faces the viewer.

use super::PLANES;
use crate::error::{LodError, Result};
use glam::{Vec2, Vec3};

/// Weights of the six planes of a box of these half sides, for a `direction` to the viewer along the box's
/// own axes ([`LeafBox::turn`](crate::impostor::boxes::LeafBox::turn), inverted), of any length. They sum to
/// 1 and change continuously with the direction: the eighth power of the cosine, so that a plane that is seen
/// edge-on has none and one that faces the viewer nearly all.
///
/// # Errors
/// [`LodError::Impostor`] for a direction that is zero or not finite, or half sides that are not all
/// above 0.
///
/// ```
/// use tree_lod::{glam::Vec3, impostor::cards::weights};
/// let weights = weights(Vec3::ONE, Vec3::new(1.0, 1.0, 0.0))?;
/// assert!((weights.iter().sum::<f32>() - 1.0).abs() < 1e-6);
/// # Ok::<(), tree_lod::LodError>(())
/// ```
pub fn weights(half: Vec3, direction: Vec3) -> Result<[f32; PLANES]> {
    let Some(v) = direction.try_normalize() else {
        return Err(LodError::Impostor("the direction to the viewer must be finite and not zero"));
    };
    if !(half.min_element() > 0.0 && half.is_finite()) {
        return Err(LodError::Impostor("half sides of a box must be finite and above 0"));
    }
    Ok(shares(half / half.max_element(), v))
}

/// As the shaders do it.
fn shares(half: Vec3, v: Vec3) -> [f32; PLANES] {
    let (yzx, zxy) = (Vec3::new(half.y, half.z, half.x), Vec3::new(half.z, half.x, half.y));
    let length = (yzx * yzx + zxy * zxy).map(f32::sqrt);
    let p = yzx * Vec3::new(v.z, v.x, v.y) / length;
    let q = zxy * Vec3::new(v.y, v.z, v.x) / length;
    let (a, b) = ((p - q).abs(), (p + q).abs());
    let most = a.max(b).max_element();
    let power = |c: Vec3| {
        let c = c / most;
        let c = c * c;
        let c = c * c;
        c * c
    };
    let (a, b) = (power(a), power(b));
    let sum = (a + b).element_sum();
    [a.x, b.x, a.y, b.y, a.z, b.z].map(|w| w / sum)
}

/// The part of 0 to 1 that belongs to a plane: as long as its weight, after those of the planes before it.
/// A pixel draws the plane in whose interval its [`noise`] lies.
#[must_use]
pub fn interval(weights: &[f32; PLANES], plane: usize) -> [f32; 2] {
    let low = weights.iter().take(plane).sum();
    // The last one ends at 1 whatever was lost by rounding.
    let high = if plane + 1 >= PLANES { 1.0 } else { low + weights[plane] };
    [low, high]
}

/// A pattern over pixels, 0 to 1, whose neighbourhoods of 3 × 3 hold nearly even values (Jimenez 2014,
/// "Next generation post processing in Call of Duty: Advanced Warfare").
#[must_use]
pub fn noise(pixel: Vec2) -> f32 {
    let wave = pixel.dot(Vec2::new(0.067_110_56, 0.005_837_15));
    let wave = 52.982_918 * (wave - wave.floor());
    wave - wave.floor()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impostor::boxes::LeafBox;
    use crate::impostor::cards::planes;
    use glam::Quat;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = Vec3> {
        let c = || -1.0_f32..1.0;
        (c(), c(), c())
            .prop_map(Vec3::from)
            .prop_filter("not zero", |v| v.length() > 0.05)
            .prop_map(Vec3::normalize)
    }

    proptest! {
        #[test]
        fn weights_sum_to_one_and_change_continuously(
            half in (0.05_f32..3.0, 0.05_f32..3.0, 0.05_f32..3.0), v in unit(), step in unit(),
        ) {
            let half = Vec3::from(half);
            let before = weights(half, v).unwrap();
            prop_assert!((before.iter().sum::<f32>() - 1.0).abs() < 1e-5);
            prop_assert!(before.iter().all(|w| (0.0..=1.0).contains(w)));
            let after = weights(half, v + step * 1e-4).unwrap();
            // The steepest are those of a thin box seen along its length.
            let steep = 100.0 * half.max_element() / half.min_element();
            for (a, b) in before.iter().zip(after) {
                prop_assert!((a - b).abs() < 1e-4 * steep, "{a} {b}");
            }
        }

        #[test]
        fn weights_order_planes_by_how_much_they_face(
            half in (0.2_f32..3.0, 0.2_f32..3.0, 0.2_f32..3.0), v in unit(),
        ) {
            let leaf_box = LeafBox {
                parent: 0, level: 0, node: 0, center: Vec3::ZERO, half: Vec3::from(half),
                turn: Quat::IDENTITY, leaves: 0..0, own: 0..0, children: 0..0,
            };
            let found = weights(leaf_box.half, v).unwrap();
            let cosines = planes(&leaf_box).map(|plane| plane.normal.dot(v).abs());
            for i in 0..PLANES {
                for j in 0..PLANES {
                    prop_assert!(cosines[i] <= cosines[j] + 1e-4 || found[i] >= found[j] - 1e-6);
                }
            }
        }

        #[test]
        fn every_value_of_the_pattern_belongs_to_one_plane(v in unit(), value in 0.0_f32..1.0) {
            let weights = weights(Vec3::new(1.0, 2.0, 0.5), v).unwrap();
            let within = (0..PLANES).filter(|&plane| {
                let [low, high] = interval(&weights, plane);
                low <= value && value < high
            });
            prop_assert_eq!(within.count(), 1);
        }
    }

    #[test]
    fn directions_that_are_none_are_refused() {
        for bad in [Vec3::ZERO, Vec3::NAN, Vec3::X * f32::INFINITY] {
            assert!(matches!(weights(Vec3::ONE, bad), Err(LodError::Impostor(_))));
        }
        assert!(weights(Vec3::new(1.0, 0.0, 1.0), Vec3::X).is_err());
        assert!(weights(Vec3::new(1.0, f32::NAN, 1.0), Vec3::X).is_err());
    }

    #[test]
    fn the_pattern_is_even() {
        let values =
            (0..64 * 64).map(|i| noise(Vec2::new((i % 64) as f32 + 0.5, (i / 64) as f32 + 0.5)));
        let mean = values.clone().sum::<f32>() / 4096.0;
        assert!(
            (mean - 0.5).abs() < 0.01 && values.clone().all(|v| (0.0..1.0).contains(&v)),
            "{mean}"
        );
    }
}
