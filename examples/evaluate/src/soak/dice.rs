//! Chance: numbers as people send them, and numbers as nobody should.

use ciborium::Value;
use serde::Serialize;
use serde::de::DeserializeOwned;
use tree_core::glam::{Quat, Vec2, Vec3};
use tree_core::seed::{uniform, unit_vector};
use tree_core::{Rng, Seed};

/// Numbers that have broken programs.
const NASTY: [f64; 20] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    -1.0,
    1.0,
    1e-45,
    1e-38,
    1e-20,
    1e-6,
    1e-3,
    0.5,
    100.0,
    1e4,
    1e9,
    1e19,
    3.4e38,
    -3.4e38,
    1e300,
];
/// Counts that have.
const COUNTS: [i64; 14] =
    [0, 1, 2, 3, -1, 7, 64, 255, 256, 1000, 65_536, 2_147_483_647, 4_294_967_295, i64::MAX];

/// All chance of one case.
pub(super) struct Dice(Rng);

impl Dice {
    pub(super) fn new(seed: Seed) -> Self {
        Self(seed.rng())
    }

    /// 0 to `n` less one; 0 for none.
    pub(super) fn below(&mut self, n: usize) -> usize {
        ((self.between(0.0, 1.0) * n as f32) as usize).min(n.saturating_sub(1))
    }

    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        uniform(&mut self.0, low, high)
    }

    pub(super) fn chance(&mut self, share: f32) -> bool {
        self.between(0.0, 1.0) < share
    }

    pub(super) fn pick<T: Copy>(&mut self, from: &[T]) -> Option<T> {
        let at = self.below(from.len());
        from.get(at).copied()
    }

    pub(super) fn seed(&mut self) -> Seed {
        Seed(self.below(1 << 20) as u64)
    }

    pub(super) fn nasty(&mut self) -> f64 {
        self.pick(&NASTY).unwrap_or(0.0)
    }

    /// A coordinate, mostly within `reach`.
    pub(super) fn coordinate(&mut self, reach: f32, nasty: f32) -> f32 {
        if self.chance(nasty) { self.nasty() as f32 } else { self.between(-reach, reach) }
    }

    pub(super) fn point(&mut self, reach: f32, nasty: f32) -> Vec3 {
        Vec3::from_array([0; 3].map(|_| self.coordinate(reach, nasty)))
    }

    pub(super) fn spot(&mut self, reach: f32, nasty: f32) -> Vec2 {
        Vec2::from_array([0; 2].map(|_| self.coordinate(reach, nasty)))
    }

    pub(super) fn direction(&mut self) -> Vec3 {
        unit_vector(&mut self.0)
    }

    pub(super) fn rotation(&mut self, nasty: f32) -> Quat {
        if self.chance(nasty) {
            return Quat::from_array([0; 4].map(|_| self.nasty() as f32));
        }
        Quat::from_rotation_arc(Vec3::Y, self.direction())
    }

    /// The parameters as they are, or up to three fields changed, whichever they are and however deep: a little, or to what
    /// they should not be. As they were, where the type itself refuses what came out.
    pub(super) fn changed<T: Serialize + DeserializeOwned + Clone>(&mut self, params: &T) -> T {
        let (n, wild) = match self.below(3) {
            0 => (0, false),
            1 => (1 + self.below(3), false),
            _ => (1 + self.below(3), true),
        };
        let Ok(mut value) = Value::serialized(params) else { return params.clone() };
        for _ in 0..n {
            let all = count(&value);
            let mut at = self.below(all);
            self.touch(&mut value, &mut at, wild);
        }
        value.deserialized().unwrap_or_else(|_| params.clone())
    }

    /// Changes the `at`-th of all numbers and flags, to anything if `wild`.
    fn touch(&mut self, value: &mut Value, at: &mut usize, wild: bool) -> bool {
        match value {
            Value::Map(rows) => rows.iter_mut().any(|(_, value)| self.touch(value, at, wild)),
            Value::Array(rows) => rows.iter_mut().any(|value| self.touch(value, at, wild)),
            Value::Integer(_) | Value::Float(_) | Value::Bool(_) if *at > 0 => {
                *at -= 1;
                false
            }
            Value::Bool(flag) => {
                *flag = !*flag;
                true
            }
            Value::Float(number) => {
                let factor = f64::from(self.between(0.6, 1.6));
                *number = if wild { self.nasty() } else { *number * factor };
                true
            }
            Value::Integer(number) => {
                let old = i64::try_from(*number).unwrap_or(0);
                let near = old.saturating_add(self.below(5) as i64 - 2);
                let any = self.pick(&COUNTS).unwrap_or(0);
                *number = (if wild { any } else { near.max(0) }).into();
                true
            }
            _ => false,
        }
    }
}

/// Numbers and flags of a value.
fn count(value: &Value) -> usize {
    match value {
        Value::Map(rows) => rows.iter().map(|(_, value)| count(value)).sum(),
        Value::Array(rows) => rows.iter().map(count).sum(),
        Value::Integer(_) | Value::Float(_) | Value::Bool(_) => 1,
        _ => 0,
    }
}
