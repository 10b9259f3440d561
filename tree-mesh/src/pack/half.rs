//! Numbers of 16 bits (IEEE 754 binary16) and bytes.

/// The nearest 16-bit number, ties to even; beyond 65,504 infinite. A NaN stays one.
///
/// The error is at most 2⁻¹¹ of the number, and 2⁻²⁵ below 2⁻¹⁴.
#[must_use]
pub fn from_f32(value: f32) -> u16 {
    let bits = value.to_bits();
    let sign = (bits >> 16 & 0x8000) as u16;
    let magnitude = bits & 0x7FFF_FFFF;
    if magnitude > 0x7F80_0000 {
        return sign | 0x7E00;
    }
    if magnitude >= 0x4780_0000 {
        return sign | 0x7C00;
    }
    if magnitude < 0x3880_0000 {
        // Below 2^-14 the steps are even: 2^-24. Adding one half lets the hardware round.
        let steps = (f32::from_bits(magnitude) + 0.5).to_bits() - 0.5_f32.to_bits();
        return sign | steps as u16;
    }
    let odd = magnitude >> 13 & 1;
    let rounded = (magnitude + 0xFFF + odd) >> 13;
    // The exponent's bias is 127 in one and 15 in the other. A carry ends in infinity, as it should.
    sign | (rounded - ((127 - 15) << 10)) as u16
}

/// The same number in 32 bits, exactly.
#[must_use]
pub fn to_f32(bits: u16) -> f32 {
    let sign = u32::from(bits & 0x8000) << 16;
    let (exponent, fraction) = (u32::from(bits >> 10 & 0x1F), u32::from(bits & 0x3FF));
    let magnitude = match exponent {
        0 => (fraction as f32 / 16_777_216.0).to_bits(),
        31 => 0x7F80_0000 | fraction << 13,
        _ => (exponent + 127 - 15) << 23 | fraction << 13,
    };
    f32::from_bits(sign | magnitude)
}

/// 0 to 1 as a byte; the error is at most 1/510. What lies outside is clamped, NaN becomes 0.
#[must_use]
pub fn byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// A byte as 0 to 1.
#[must_use]
pub fn from_byte(value: u8) -> f32 {
    f32::from(value) / 255.0
}

/// 0 to 1 in 16 bits; the error is at most 1/131,070. What lies outside is clamped, NaN becomes 0.
#[must_use]
pub fn short(value: f32) -> u16 {
    (value.clamp(0.0, 1.0) * 65_535.0 + 0.5) as u16
}

/// 16 bits as 0 to 1.
#[must_use]
pub fn from_short(value: u16) -> f32 {
    f32::from(value) / 65_535.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_16_bit_number_survives() {
        for bits in 0..=u16::MAX {
            let back = from_f32(to_f32(bits));
            assert!(back == bits || to_f32(bits).is_nan() && to_f32(back).is_nan(), "{bits:#x}");
        }
    }

    #[test]
    fn rounding_is_to_the_nearest_number() {
        // Between two neighbours the nearer one is found, and the even one half way.
        for bits in (0..0x7BFF_u16).step_by(7) {
            let (low, high) = (to_f32(bits), to_f32(bits + 1));
            let at = |share: f32| from_f32(low + (high - low) * share);
            assert_eq!((at(0.25), at(0.75)), (bits, bits + 1), "{bits:#x}");
            assert_eq!(at(0.5), bits + (bits & 1), "{bits:#x}");
        }
        assert_eq!(from_f32(65_520.0), 0x7C00);
        assert_eq!(from_f32(-1e9), 0xFC00);
    }

    #[test]
    fn bytes_and_shorts_survive_and_clamp() {
        assert!((0..=u8::MAX).all(|value| byte(from_byte(value)) == value));
        assert!((0..=u16::MAX).all(|value| short(from_short(value)) == value));
        assert_eq!([byte(-1.0), byte(2.0), byte(f32::NAN)], [0, 255, 0]);
        assert_eq!([short(-1.0), short(2.0), short(f32::NAN)], [0, 65_535, 0]);
    }
}
