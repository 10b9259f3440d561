//! How numbers become bytes.

use glam::{Quat, Vec3};
use tree_core::NO_PARENT;

/// First bytes of a stream.
pub(super) const MAGIC: [u8; 4] = *b"TREM";
/// Version that is written, and the only one that is read.
pub(super) const VERSION: u8 = 1;
/// Radii are finer than positions by this factor.
const RADIUS: f32 = 0.125;
/// Steps of a component of a rotation, either way.
const TURN: f32 = 511.0;
/// The largest magnitude of a component of a unit quaternion that is not its largest.
const TURN_MAX: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// How coordinates are coded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Steps {
    /// Metres; 0: exact.
    pub(super) precision: f32,
}

impl Steps {
    pub(super) fn positions(self) -> Step {
        Step(self.precision)
    }

    pub(super) fn radii(self) -> Step {
        Step(self.precision * RADIUS)
    }

    pub(super) fn is_exact(self) -> bool {
        self.precision == 0.0
    }
}

/// A step in metres; 0: floats in their order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step(f32);

impl Step {
    pub(super) fn code(self, x: f32) -> i64 {
        if self.0 == 0.0 {
            let bits = x.to_bits() as i32;
            return i64::from(bits ^ (((bits >> 31) as u32) >> 1) as i32);
        }
        libm::rint(f64::from(x) / f64::from(self.0)) as i64
    }

    /// None for what is no finite float.
    pub(super) fn value(self, code: i64) -> Option<f32> {
        if self.0 == 0.0 {
            let code = i32::try_from(code).ok()?;
            let x = f32::from_bits((code ^ (((code >> 31) as u32) >> 1) as i32) as u32);
            return x.is_finite().then_some(x);
        }
        let x = (code as f64 * f64::from(self.0)) as f32;
        x.is_finite().then_some(x)
    }
}

/// Where a child of `parent` is expected and how thick: straight on from the grandparent, if there is one.
pub(super) fn expected(
    positions: &[Vec3],
    radii: &[f32],
    parent: u32,
    grandparent: u32,
) -> (Vec3, f32) {
    let at = positions[parent as usize];
    let from = if grandparent == NO_PARENT { at } else { positions[grandparent as usize] };
    // Not beyond what floats hold.
    let on = at + (at - from);
    (if on.is_finite() { on } else { at }, radii[parent as usize])
}

pub(super) fn write_unsigned(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

pub(super) fn write_signed(bytes: &mut Vec<u8>, value: i64) {
    write_unsigned(bytes, ((value << 1) ^ (value >> 63)) as u64);
}

pub(super) fn write_text(bytes: &mut Vec<u8>, text: &str) {
    write_unsigned(bytes, text.len() as u64);
    bytes.extend_from_slice(text.as_bytes());
}

/// The three components that are not the largest, in 10 bits each, and which that is: 32 bits.
pub(super) fn pack_turn(turn: Quat) -> u32 {
    let parts = turn.to_array();
    let largest =
        (1..4).fold(0, |best, i| if parts[i].abs() > parts[best].abs() { i } else { best });
    let sign = if parts[largest] < 0.0 { -1.0 } else { 1.0 };
    let mut packed = largest as u32;
    for (i, part) in parts.iter().enumerate() {
        if i != largest {
            let step = (part * sign / TURN_MAX * TURN).round().clamp(-TURN, TURN);
            packed = packed << 10 | (step + TURN) as u32;
        }
    }
    packed
}

pub(super) fn unpack_turn(mut packed: u32) -> Quat {
    let largest = (packed >> 30) as usize;
    let mut parts = [0.0_f32; 4];
    let mut rest = 1.0;
    for i in (0..4).rev().filter(|&i| i != largest) {
        parts[i] = ((packed & 1023) as f32 - TURN) / TURN * TURN_MAX;
        rest -= parts[i] * parts[i];
        packed >>= 10;
    }
    parts[largest] = rest.max(0.0).sqrt();
    Quat::from_array(parts).normalize()
}

/// Bytes that are read one after another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    pub(super) at: usize,
}

/// The bytes end before what was to be read, or it is no number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bad {
    Short,
    Wrong(&'static str),
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    pub(super) fn take(&mut self, n: usize) -> Result<&'a [u8], Bad> {
        let end = self.at.checked_add(n).ok_or(Bad::Short)?;
        let taken = self.bytes.get(self.at..end).ok_or(Bad::Short)?;
        self.at = end;
        Ok(taken)
    }

    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], Bad> {
        let taken = self.take(N)?;
        taken.try_into().map_err(|_| Bad::Short)
    }

    pub(super) fn unsigned(&mut self) -> Result<u64, Bad> {
        let mut value = 0_u64;
        for shift in (0..64).step_by(7) {
            let [byte] = self.array()?;
            let bits = u64::from(byte & 0x7f);
            if shift == 63 && bits > 1 {
                break;
            }
            value |= bits << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(Bad::Wrong("a number is longer than 64 bits"))
    }

    pub(super) fn signed(&mut self) -> Result<i64, Bad> {
        let value = self.unsigned()?;
        Ok((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    /// A number of things of which each takes a byte or more.
    pub(super) fn count(&mut self) -> Result<u32, Bad> {
        u32::try_from(self.unsigned()?).map_err(|_| Bad::Wrong("a number is above 2³²"))
    }

    pub(super) fn text(&mut self) -> Result<String, Bad> {
        let n = self.count()? as usize;
        if n > TEXT_MAX {
            return Err(Bad::Wrong("a name is longer than 4096 bytes"));
        }
        let bytes = self.take(n)?.to_vec();
        String::from_utf8(bytes).map_err(|_| Bad::Wrong("a name is not UTF-8"))
    }
}

/// Most bytes of a name.
pub(super) const TEXT_MAX: usize = 4096;
