//! One step of a particle: Newton's law with drag, solved by an adaptive Runge-Kutta method.
//!
//! Drag makes a particle take up the wanted direction within a turning time τ that grows with its mass:
//! x″ = (d − x′) / τ, with all speeds near 1, so that time is way. The embedded pair of orders 3 and 2 of
//! Bogacki and Shampine (1989) tells the error; steps that are too wrong are halved.

use glam::Vec3;

/// A step is cut into at most so many parts: more would only follow a kink of the field.
const MOST_PARTS: u32 = 16;

/// Position and velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) position: Vec3,
    pub(super) velocity: Vec3,
}

/// Change of position and velocity.
#[derive(Clone, Copy)]
struct Rate(Vec3, Vec3);

impl State {
    fn plus(&self, h: f32, rate: Rate) -> Self {
        Self { position: self.position + h * rate.0, velocity: self.velocity + h * rate.1 }
    }
}

/// Moves `state` by `step`, where `wanted` gives the direction at a point and after a time. Steps whose error is
/// over `tolerance` in position are halved. Returns the new state and how many parts were taken.
pub(super) fn advance(
    mut state: State,
    step: f32,
    turning: f32,
    tolerance: f32,
    wanted: impl Fn(Vec3, f32) -> Vec3,
) -> (State, u32) {
    let rate = |state: &State, time: f32| {
        Rate(state.velocity, (wanted(state.position, time) - state.velocity) / turning)
    };
    let least = step / MOST_PARTS as f32;
    let (mut done, mut h, mut parts) = (0.0, step, 0);
    let mut first = rate(&state, 0.0);
    // The last part is what is left, so the sum of halves ends exactly.
    while done < step {
        h = f32::min(h, step - done);
        let second = rate(&state.plus(0.5 * h, first), done + 0.5 * h);
        let third = rate(&state.plus(0.75 * h, second), done + 0.75 * h);
        let mix = |a: Vec3, b: Vec3, c: Vec3| (2.0 * a + 3.0 * b + 4.0 * c) / 9.0;
        let next =
            state.plus(h, Rate(mix(first.0, second.0, third.0), mix(first.1, second.1, third.1)));
        let last = rate(&next, done + h);
        let miss = |a: Vec3, b: Vec3, c: Vec3, d: Vec3| {
            h * (-5.0 / 72.0 * a + b / 12.0 + c / 9.0 - d / 8.0)
        };
        let off = miss(first.0, second.0, third.0, last.0).length()
            + turning * miss(first.1, second.1, third.1, last.1).length();
        if off > tolerance && h > least {
            h = (0.5 * h).max(least);
            continue;
        }
        parts += 1;
        done += h;
        state = next;
        first = last;
    }
    (state, parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A particle that starts sideways in an even wind has a known course.
    fn exact(time: f32, turning: f32) -> State {
        let left = libm::expf(-time / turning);
        State {
            position: Vec3::new(turning * (1.0 - left), time - turning * (1.0 - left), 0.0),
            velocity: Vec3::new(left, 1.0 - left, 0.0),
        }
    }

    #[test]
    fn the_course_in_an_even_wind_is_the_exact_one() {
        let (step, turning) = (0.1, 0.3);
        let mut state = State { position: Vec3::ZERO, velocity: Vec3::X };
        for i in 1..=20 {
            (state, _) = advance(state, step, turning, 1e-4, |_, _| Vec3::Y);
            let exact = exact(step * i as f32, turning);
            assert!(state.position.distance(exact.position) < 1e-3, "{state:?} {exact:?}");
            assert!(state.velocity.distance(exact.velocity) < 1e-3);
        }
    }

    #[test]
    fn a_kink_of_the_field_takes_more_parts_than_an_even_one() {
        let wall = |p: Vec3, _| if p.x > 0.05 { Vec3::Y } else { Vec3::X };
        let start = State { position: Vec3::ZERO, velocity: Vec3::X };
        let (_, kinked) = advance(start, 0.1, 0.01, 1e-4, wall);
        let (_, even) = advance(start, 0.1, 0.3, 1e-4, |_, _| Vec3::X);
        assert_eq!(even, 1);
        assert!(kinked > 3 && kinked <= 40, "{kinked}");
    }
}
