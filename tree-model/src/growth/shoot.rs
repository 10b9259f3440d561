//! New shoots (Palubicki et al. 2009, section 4.3): where each metamer goes.

use super::habit::{Habit, Tropisms};
use super::stem::{Metamer, Shoot};
use super::surroundings::Surroundings;
use glam::{Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::{Rng, seed};

/// Shortest move that counts as one, as a share of an internode.
const LEAST_MOVE: f32 = 1e-3;

/// What a bud is to make.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order {
    pub(super) node: u32,
    pub(super) slot: usize,
    pub(super) n_metamers: u32,
    pub(super) internode: f32,
    /// Order of the axis to be.
    pub(super) axis_order: u8,
    /// What the bud has won of space, where space decides.
    pub(super) pull: Option<Vec3>,
}

/// Direction of the axillary bud in place `slot` (from 1) of a node.
pub(super) fn bud_direction(metamer: &Metamer, habit: &Habit, slot: usize, angle: f32) -> Vec3 {
    let around = TAU * (slot.saturating_sub(1)) as f32 / habit.buds.per_node() as f32;
    let side = Quat::from_axis_angle(metamer.direction, around) * metamer.side;
    let direction = libm::cosf(angle) * metamer.direction + libm::sinf(angle) * side;
    direction.normalize_or(metamer.direction)
}

/// A vector across `direction`: level where that is possible.
pub(super) fn across(direction: Vec3) -> Vec3 {
    direction
        .cross(Vec3::Y)
        .try_normalize()
        .unwrap_or_else(|| direction.cross(Vec3::X).normalize_or(Vec3::Z))
}

impl Order {
    /// Grows the metamers one after the other until something is in the way.
    pub(super) fn grow(
        &self,
        from: Metamer,
        habit: &Habit,
        surroundings: &Surroundings,
        rng: &mut Rng,
    ) -> Shoot {
        let mut last = from;
        if self.slot > 0 {
            let angle = habit.angle + habit.jitter * seed::normal(rng);
            last.direction = bud_direction(&from, habit, self.slot, angle);
            last.side = across(last.direction);
            if !habit.buds.is_flat() {
                let phase = seed::uniform(rng, 0.0, TAU);
                last.side = Quat::from_axis_angle(last.direction, phase) * last.side;
            }
        }
        let mut metamers = Vec::with_capacity(self.n_metamers as usize);
        for _ in 0..self.n_metamers {
            let next = self.next(&last, habit, surroundings, rng);
            if !self.is_free(last.position, next.position, surroundings) {
                break;
            }
            metamers.push(next);
            last = next;
        }
        let blocked = metamers.len() < self.n_metamers as usize;
        Shoot { node: self.node, slot: self.slot, metamers, blocked }
    }

    fn next(
        &self,
        last: &Metamer,
        habit: &Habit,
        surroundings: &Surroundings,
        rng: &mut Rng,
    ) -> Metamer {
        let pull = surroundings.pull(last.position, self.pull);
        let direction = turned(last.direction, pull, habit.tropisms(self.axis_order));
        let turn = habit.buds.divergence() + habit.jitter * seed::normal(rng);
        let side = (last.side - direction * direction.dot(last.side))
            .try_normalize()
            .unwrap_or_else(|| across(direction));
        let side = Quat::from_axis_angle(direction, turn) * side;
        let position = last.position + self.internode * direction;
        Metamer { position, direction, side }
    }

    fn is_free(&self, from: Vec3, to: Vec3, surroundings: &Surroundings) -> bool {
        to.is_finite()
            && from.distance(to) > LEAST_MOVE * self.internode
            && to.y >= surroundings.ground
            && surroundings.obstacle.as_ref().is_none_or(|obstacle| obstacle.is_free(from, to))
    }
}

/// The direction of the next metamer: where the axis points, drawn towards light, up and level.
fn turned(direction: Vec3, pull: Vec3, tropisms: &Tropisms) -> Vec3 {
    let level = Vec3::new(direction.x, 0.0, direction.z).normalize_or_zero();
    let sum =
        direction + tropisms.photo * pull + tropisms.gravi * Vec3::Y + tropisms.plagio * level;
    sum.normalize_or(direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tropisms_turn_by_their_weights() {
        let turn = |photo, gravi, plagio| {
            turned(Vec3::X, Vec3::Z, &Tropisms { photo, gravi, plagio }).to_array()
        };
        assert_eq!(turn(0.0, 0.0, 3.0), [1.0, 0.0, 0.0]);
        let half = 0.5_f32.sqrt();
        let near = |a: [f32; 3], b: [f32; 3]| Vec3::from(a).distance(b.into()) < 1e-6;
        assert!(near(turn(1.0, 0.0, 0.0), [half, 0.0, half]));
        assert!(near(turn(0.0, -1.0, 0.0), [half, -half, 0.0]));
        // What would stand still goes on.
        assert_eq!(
            turned(Vec3::Y, Vec3::ZERO, &Tropisms { gravi: -1.0, photo: 0.0, plagio: 0.0 }),
            Vec3::Y
        );
    }

    #[test]
    fn opposite_buds_stand_on_both_sides() {
        let habit = Habit { buds: crate::foliage::Phyllotaxis::Decussate, ..Habit::default() };
        let metamer = Metamer { position: Vec3::ZERO, direction: Vec3::Y, side: Vec3::X };
        let [a, b] = [1, 2].map(|slot| bud_direction(&metamer, &habit, slot, 0.5));
        assert!((a.x + b.x).abs() < 1e-6 && a.x > 0.4 && (a.y - b.y).abs() < 1e-6);
    }
}
