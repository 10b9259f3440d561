//! Unit vectors in few bits.

use glam::{Vec2, Vec3};

/// A unit vector on the octahedron: two coordinates within −1 to 1 (Cigolle and others 2014, "A survey
/// of efficient representations for independent unit vectors", section 3.8). Zero gives +Z.
#[must_use]
pub fn octahedral(v: Vec3) -> Vec2 {
    let sum = v.x.abs() + v.y.abs() + v.z.abs();
    if !(sum > 0.0 && sum.is_finite()) {
        return Vec2::ZERO;
    }
    let flat = v.truncate() / sum;
    if v.z >= 0.0 { flat } else { fold(flat) }
}

/// The unit vector at this place of the octahedron.
#[must_use]
pub fn from_octahedral(at: Vec2) -> Vec3 {
    let z = 1.0 - at.x.abs() - at.y.abs();
    let flat = if z >= 0.0 { at } else { fold(at) };
    flat.extend(z).normalize_or(Vec3::Z)
}

/// Exchanges the upper and the lower half of the octahedron.
fn fold(at: Vec2) -> Vec2 {
    let sign = |x: f32| if x >= 0.0 { 1.0 } else { -1.0 };
    Vec2::new((1.0 - at.y.abs()) * sign(at.x), (1.0 - at.x.abs()) * sign(at.y))
}

/// Octahedral coordinates in two signed 16-bit numbers: within 10⁻⁴ radians.
#[must_use]
pub fn octahedral_16(v: Vec3) -> [i16; 2] {
    octahedral(v).to_array().map(|x| (x * 32_767.0 + 0.5).floor() as i16)
}

/// The unit vector of [`octahedral_16`].
#[must_use]
pub fn from_octahedral_16(at: [i16; 2]) -> Vec3 {
    from_octahedral(Vec2::from_array(at.map(|x| (f32::from(x) / 32_767.0).max(-1.0))))
}

/// Largest value below 1 that survives the sums in the packings below.
const BELOW_ONE: f32 = 0.999;

/// A unit vector in one float, as `UnpackNormalFromFloat` of Unity's `SpeedTreeWind` reads it:
/// `frac(value / (16, 1, 1/16)) * 2 - 1`. x and y have 4 bits, z has what the float leaves.
///
/// The direction is within 0.18 radians. (Unity reads the three as they are, not normalised.)
#[must_use]
pub fn speedtree8(v: Vec3) -> f32 {
    pack(v, 16.0)
}

/// The unit vector of [`speedtree8`].
#[must_use]
pub fn from_speedtree8(value: f32) -> Vec3 {
    unpack(value, 16.0)
}

/// A unit vector in one float, as `WindUtil_UnpackNormalizedFloat` of Unity's SpeedTree 9 wind reads
/// it: `normalize(frac((value / 100, value, value * 100)) * 2 - 1)`. The direction is within 0.03
/// radians.
#[must_use]
pub fn speedtree9(v: Vec3) -> f32 {
    pack(v, 100.0)
}

/// The unit vector of [`speedtree9`].
#[must_use]
pub fn from_speedtree9(value: f32) -> Vec3 {
    unpack(value, 100.0)
}

/// value = X + (Y + z) / base, where the reader finds z, (Y + z) / base and (X + that) / base.
fn pack(v: Vec3, base: f32) -> f32 {
    let unit = v.normalize_or(Vec3::Y) * 0.5 + 0.5;
    let digit =
        |wanted: f32, below: f32| (wanted * base - below + 0.5).floor().clamp(0.0, base - 1.0);
    // Close to 0 a rounding could lead the reader's frac to 1.
    let z = unit.z.clamp(1.0 - BELOW_ONE, BELOW_ONE);
    let y = (digit(unit.y, z) + z) / base;
    digit(unit.x, y) + y
}

fn unpack(value: f32, base: f32) -> Vec3 {
    let frac = |x: f32| x - x.floor();
    let unit = Vec3::new(frac(value / base), frac(value), frac(value * base));
    (unit * 2.0 - 1.0).normalize_or(Vec3::Y)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Directions spread evenly, and those along the axes.
    fn directions() -> impl Iterator<Item = Vec3> {
        let spiral = (0..20_000).map(|i| {
            let y = 1.0 - 2.0 * (i as f32 + 0.5) / 20_000.0;
            let (sin, cos) = libm::sincosf(2.399_963_2 * i as f32);
            let across = (1.0 - y * y).sqrt();
            Vec3::new(across * cos, y, across * sin).normalize()
        });
        spiral.chain(Vec3::AXES).chain(Vec3::AXES.map(|axis| -axis))
    }

    fn worst(there_and_back: impl Fn(Vec3) -> Vec3) -> f32 {
        directions().fold(0.0_f32, |worst, v| worst.max(v.distance(there_and_back(v))))
    }

    #[test]
    fn errors_are_within_the_bounds_stated() {
        assert!(worst(|v| from_octahedral(octahedral(v))) < 1e-6);
        let found = worst(|v| from_octahedral_16(octahedral_16(v)));
        assert!(found < 1e-4, "{found}");
        let found = worst(|v| from_speedtree8(speedtree8(v)));
        assert!(found < 0.18, "{found}");
        let found = worst(|v| from_speedtree9(speedtree9(v)));
        assert!(found < 0.03, "{found}");
    }

    #[test]
    fn what_is_no_direction_gives_some_unit_vector() {
        for v in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY] {
            assert!((from_octahedral_16(octahedral_16(v)).length() - 1.0).abs() < 1e-5);
            assert!((from_speedtree8(speedtree8(v)).length() - 1.0).abs() < 1e-5);
            assert!((from_speedtree9(speedtree9(v)).length() - 1.0).abs() < 1e-5);
        }
    }
}
