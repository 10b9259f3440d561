//! Where leaves or twigs stand: a walk along every axis, at even distances through its bearing zone.
//!
//! Axes draw from streams of their own, so that they can be walked in parallel; every place has a
//! stream of its own, so that thinning one out changes no other.

use super::Phyllotaxis;
use crate::error::{ModelError, Result};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::TAU;
use std::sync::atomic::{AtomicU64, Ordering};
use tree_core::seed::uniform;
use tree_core::{Axes, Axis, Control, LimitError, NO_PARENT, Resource, Seed, Skeleton};

/// Density at a point: 0 nothing grows, 1 all that the parameters say, up to [`DENSITY_CAP`] more.
pub type DensityField<'a> = dyn Fn(Vec3) -> f32 + Sync + 'a;

/// Densities above this count as this.
pub const DENSITY_CAP: f32 = 4.0;

/// Steps from one place to the next where a density may ask for places in between.
const DENSITY_STEPS: u32 = DENSITY_CAP as u32;

/// Axes handled by one task: long enough to be worth a task, short enough to cancel soon.
const CHUNK: usize = 256;

/// A place on a shoot.
pub(super) struct Site {
    /// The stream of this place.
    pub(super) seed: Seed,
    /// The ends of the segment it is on.
    pub(super) node: u32,
    pub(super) below: u32,
    /// How far it is from `below` to `node`, 0 to 1.
    pub(super) share: f32,
    pub(super) point: Vec3,
    pub(super) along: Vec3,
    /// A unit vector across the shoot, carried along without twist.
    pub(super) side: Vec3,
    /// Angle from `side` to the first organ, by phyllotaxis.
    pub(super) turn: f32,
    /// Radius of the shoot here.
    pub(super) radius: f32,
    /// Distance to the tip as a share of the bearing zone, 0 to 1.
    pub(super) age: f32,
    /// Whether this is the tip of the axis.
    pub(super) terminal: bool,
}

/// What the walk met.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    /// Places found.
    pub(super) sites: u64,
    /// Places that the density left out.
    pub(super) thinned: u64,
    /// Places where the density was negative or not a number.
    pub(super) bad_density: u64,
    /// Axes without a place.
    pub(super) barren: u64,
}

impl Tally {
    pub(super) fn add(&mut self, other: Self) {
        self.sites += other.sites;
        self.thinned += other.thinned;
        self.bad_density += other.bad_density;
        self.barren += other.barren;
    }
}

/// Counts what all tasks together ask for, and refuses more than the limits allow.
pub(super) struct Budget<'a> {
    pub(super) control: &'a Control,
    pub(super) resource: Resource,
    /// What there is already and is asked for so far.
    pub(super) used: AtomicU64,
    /// What the error names as asked for: the same whichever task comes too late.
    pub(super) most: u64,
}

impl Budget<'_> {
    /// Asks for `more`.
    pub(super) fn ask(&self, more: u64) -> Result<()> {
        self.control.check()?;
        let before = self.used.fetch_add(more, Ordering::Relaxed);
        if before.saturating_add(more) > self.cap() { Err(self.refusal()) } else { Ok(()) }
    }

    fn cap(&self) -> u64 {
        // Rows are named by 32 bits.
        self.control.limits.cap(self.resource).min(u64::from(NO_PARENT) - 1)
    }

    fn refusal(&self) -> ModelError {
        let cap = self.cap();
        let requested = self.most.max(cap.saturating_add(1));
        LimitError { resource: self.resource, requested, cap }.into()
    }
}

/// How to walk.
pub(super) struct Walk<'a> {
    pub(super) skeleton: &'a Skeleton,
    pub(super) axes: &'a Axes,
    pub(super) to_tip: &'a [f32],
    pub(super) spacing: f32,
    pub(super) bearing: f32,
    pub(super) arrangement: Phyllotaxis,
    pub(super) terminal: bool,
    pub(super) density: Option<&'a DensityField<'a>>,
}

impl Walk<'_> {
    /// About how many places there are at density 1.
    pub(super) fn n_sites(&self) -> u64 {
        let positions = self.skeleton.positions();
        let along: f64 = self
            .skeleton
            .segments()
            .filter(|&(_, node)| self.to_tip[node as usize] < self.bearing)
            .map(|(a, b)| {
                let [a, b] = [a, b].map(|node| positions[node as usize].as_dvec3());
                a.distance(b) / f64::from(self.spacing)
            })
            .sum();
        // A cast from float saturates.
        let tips = if self.terminal { self.axes.len() as u64 } else { 0 };
        (along as u64).saturating_add(tips)
    }

    /// The most that one place at density 1 may become.
    pub(super) fn most_each(&self) -> u64 {
        if self.density.is_some() { u64::from(DENSITY_STEPS) } else { 1 }
    }

    /// Walks all axes, and makes something of the places of each part of the work. Parts come back
    /// in the order of the axes.
    pub(super) fn parts<T: Send>(
        &self,
        seed: Seed,
        budget: &Budget<'_>,
        make: impl Fn(&[Site]) -> Result<T> + Sync,
    ) -> Result<(Vec<T>, Tally)> {
        let n_axes = self.axes.len() as u32;
        let starts: Vec<u32> = (0..n_axes).step_by(CHUNK).collect();
        let parts = starts
            .par_iter()
            .map(|&start| {
                let (mut sites, mut tally) = (Vec::new(), Tally::default());
                for number in start..(start + CHUNK as u32).min(n_axes) {
                    if let Some(axis) = self.axes.get(number) {
                        self.axis(axis, seed, budget, &mut sites, &mut tally)?;
                    }
                }
                Ok((make(&sites)?, tally))
            })
            .collect::<Result<Vec<_>>>()?;
        let mut total = Tally::default();
        let parts = parts.into_iter().map(|(part, tally)| {
            total.add(tally);
            part
        });
        let parts = parts.collect();
        Ok((parts, total))
    }

    /// Appends the places of one axis, from its base to its tip.
    fn axis(
        &self,
        axis: Axis<'_>,
        seed: Seed,
        budget: &Budget<'_>,
        sites: &mut Vec<Site>,
        tally: &mut Tally,
    ) -> Result<()> {
        let positions = self.skeleton.positions();
        let radii = self.skeleton.radii();
        let seed = seed.child(u64::from(axis.index));
        let mut rng = seed.rng();
        let steps = if self.density.is_some() { DENSITY_STEPS } else { 1 };
        let step = self.spacing / steps as f32;
        let before = tally.sites;
        let mut course = Course { seed, side: None, along: Vec3::Y, turn: 0.0, copies: 1, k: 0 };
        let random_turn = uniform(&mut rng, 0.0, TAU);
        // Two rows lie to the left and right of a shoot that does not stand upright.
        course.turn = if self.arrangement.is_flat() { 0.0 } else { random_turn };
        // Distance along the shoot until the next place.
        let mut ahead = uniform(&mut rng, 0.3, 1.0) * self.spacing;
        for &node in axis.nodes {
            budget.control.check()?;
            let Some(below) = self.skeleton.parent(node) else {
                continue;
            };
            let (a, b) = (positions[below as usize], positions[node as usize]);
            let length = a.distance(b);
            let bears = self.to_tip[node as usize] < self.bearing;
            if !bears || length <= 0.0 || !length.is_finite() {
                continue;
            }
            course.head((b - a) / length);
            let to_tip_at_a = self.to_tip[node as usize] + length;
            // A segment that reaches below the bearing zone starts bearing part of the way up.
            ahead = ahead.max(to_tip_at_a - self.bearing);
            // By number, not by adding up: small steps added to a large length go nowhere.
            let n_steps = ((length - ahead) / step).ceil().max(0.0) as u64;
            for i in 0..n_steps {
                let share = ((ahead + i as f32 * step) / length).min(1.0);
                let point = a.lerp(b, share);
                if !self.stands(&mut course, steps, point, tally) {
                    continue;
                }
                let (upper, lower) = (radii[node as usize], radii[below as usize]);
                let radius = upper * share + lower.min(2.0 * upper) * (1.0 - share);
                let to_tip = to_tip_at_a - share * length;
                let age = (to_tip / self.bearing).clamp(0.0, 1.0);
                let at = Site { node, below, share, point, radius, age, ..course.site() };
                sites.push(at);
                tally.sites += 1;
                if tally.sites > budget.cap() {
                    return Err(budget.refusal());
                }
            }
            ahead = (ahead + n_steps as f32 * step - length).max(0.0);
        }
        if let Some(&tip) = axis.nodes.last()
            && let Some(below) = self.skeleton.parent(tip)
            && self.terminal
            && self.bearing > 0.0
        {
            let point = positions[tip as usize];
            course.k = u64::MAX;
            course.copies = self.copies(course.site().seed, point, tally);
            if course.copies > 0 {
                let at =
                    Site { node: tip, below, share: 1.0, point, terminal: true, ..course.site() };
                sites.push(at);
                tally.sites += 1;
            }
        }
        tally.barren += u64::from(tally.sites == before);
        Ok(())
    }

    /// Whether an organ stands at this step; moves the course on to the next.
    fn stands(&self, course: &mut Course, steps: u32, point: Vec3, tally: &mut Tally) -> bool {
        let phase = (course.k % u64::from(steps)) as u32;
        course.k += 1;
        if phase == 0 {
            course.copies = self.copies(course.site().seed, point, tally);
        }
        // Copies are spread evenly over the steps, the first at step 0.
        let stands = (phase * course.copies) % steps < course.copies;
        if phase == 0 || stands {
            course.turn = (course.turn + self.arrangement.divergence()) % TAU;
        }
        stands
    }

    /// How many organs stand here and up to the next place: the density on average.
    fn copies(&self, seed: Seed, point: Vec3, tally: &mut Tally) -> u32 {
        let Some(density) = self.density else { return 1 };
        let mut density = density(point);
        if density.is_nan() || density < 0.0 {
            tally.bad_density += 1;
            density = 0.0;
        }
        let density = density.min(DENSITY_CAP);
        let whole = density as u32;
        let copies = whole + u32::from(seed.unit(0) < density - whole as f32);
        tally.thinned += u64::from(copies == 0);
        copies
    }
}

/// The state of a walk along one axis.
struct Course {
    seed: Seed,
    side: Option<Vec3>,
    along: Vec3,
    turn: f32,
    copies: u32,
    k: u64,
}

impl Course {
    /// Carries the frame on without twist: drops what is not across the shoot any more.
    fn head(&mut self, along: Vec3) {
        let level = || Vec3::Y.cross(along);
        let side = self.side.unwrap_or_else(level);
        let side = side - along * side.dot(along);
        self.side = Some(side.normalize_or(along.any_orthonormal_vector()));
        self.along = along;
    }

    fn site(&self) -> Site {
        Site {
            seed: self.seed.child(self.k),
            node: 0,
            below: 0,
            share: 0.0,
            point: Vec3::ZERO,
            along: self.along,
            side: self.side.unwrap_or(Vec3::X),
            turn: self.turn,
            radius: 0.0,
            age: 0.0,
            terminal: false,
        }
    }
}
