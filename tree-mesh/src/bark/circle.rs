//! Corners of regular polygons, and how many a ring gets.

use super::flare::Flare;
use crate::params::MeshParams;
use glam::Vec2;
use std::f32::consts::{PI, TAU};

/// Directions to the corners of regular polygons, so that rings need no sines.
#[derive(Debug)]
pub(crate) struct Circles {
    min_sides: u32,
    max_sides: u32,
    error: f32,
    /// The polygon of n sides starts at `starts[n]`.
    starts: Vec<usize>,
    corners: Vec<Vec2>,
    /// How far out the corners of the polygon of n sides stand, in radii of the circle.
    reaches: Vec<f32>,
    /// Radii from which a ring has more sides than `min_sides`: `(radius, sides)`, ascending.
    steps: Vec<(f32, u32)>,
}

impl Circles {
    pub(crate) fn new(params: &MeshParams) -> Self {
        let mut circles = Self {
            min_sides: params.min_sides,
            max_sides: params.max_sides,
            error: params.error.metres(),
            starts: Vec::new(),
            corners: Vec::new(),
            reaches: (0..=params.max_sides).map(reach).collect(),
            steps: Vec::new(),
        };
        for n in 0..=params.max_sides {
            circles.starts.push(circles.corners.len());
            if n >= params.min_sides {
                circles.corners.extend((0..n).map(|k| {
                    let angle = TAU * k as f32 / n as f32;
                    Vec2::new(libm::cosf(angle), libm::sinf(angle))
                }));
            }
        }
        circles.find_steps();
        circles
    }

    /// The chord of a regular n-gon within the circle lies r·(1 − cos(π/n)) inside it, which must stay within
    /// the error; [`reach`] brings it out again by a third. Counts grow in steps, so that most strips join equal rings.
    fn find_steps(&mut self) {
        let mut n = 3;
        while n < self.max_sides {
            let radius = self.error / (1.0 - libm::cosf(PI / n as f32));
            let more = match n {
                0..=5 => n + 1,
                6..=11 => n + 2,
                12..=31 => n + 4,
                _ => n + 8,
            };
            self.steps.push((radius, more.clamp(self.min_sides, self.max_sides)));
            n = more;
        }
    }

    /// Most sides of a ring.
    pub(crate) fn max_sides(&self) -> u32 {
        self.max_sides
    }

    /// How far sides may cut into the round branch, in metres.
    pub(crate) fn error(&self) -> f32 {
        self.error
    }

    /// Corners of the polygon of `n` sides, between the bounds of the parameters.
    pub(crate) fn corners(&self, n: u32) -> &[Vec2] {
        let start = self.starts[n as usize];
        &self.corners[start..start + n as usize]
    }

    /// How far out the corners of the polygon of `n` sides stand, in radii of the circle: see [`reach`].
    pub(crate) fn reach(&self, n: u32) -> f32 {
        self.reaches[n as usize]
    }

    /// How many sides a ring of this radius gets at this height.
    pub(crate) fn n_sides(&self, radius: f32, along: f32, flare: &Flare) -> u32 {
        let round = self.n_round(radius * flare.widest(along));
        round.max(flare.min_sides(along)).clamp(self.min_sides, self.max_sides)
    }

    /// How far out the corners of a ring of this radius stand where nothing asks for more of them, in metres.
    pub(crate) fn widest(&self, radius: f32) -> f32 {
        radius * self.reach(self.n_round(radius))
    }

    fn n_round(&self, radius: f32) -> u32 {
        let step = self.steps.partition_point(|&(from, _)| from < radius);
        match step.checked_sub(1).and_then(|i| self.steps.get(i)) {
            Some(&(_, n)) => n.clamp(self.min_sides, self.max_sides),
            None => self.min_sides,
        }
    }
}

/// A convex shape is as wide, averaged over the directions it is seen from, as its perimeter over π (Cauchy). So the
/// polygon gets the circle's perimeter: with corners on the circle, a branch of three sides would look a sixth
/// thinner than it is, and levels with fewer sides thinner than those before.
fn reach(n: u32) -> f32 {
    if n < 3 {
        return 1.0;
    }
    let half = PI / n as f32;
    half / libm::sinf(half)
}
