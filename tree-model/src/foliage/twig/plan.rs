//! The plan of one twig with all its laterals: which internodes there are, how long, and at which angles
//! they leave each other before anything bends.

use super::params::{Branching, TwigParams};
use crate::error::Result;
use crate::foliage::blade::size_share;
use crate::foliage::sites::Site;
use crate::foliage::vector::{frame, to_the_right};
use glam::{Mat3, Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::Rng;
use tree_core::seed::uniform;

/// Share of the jitter that one internode deviates from the last.
const WANDER: f32 = 0.25;

/// One internode, named by its upper node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Internode {
    /// Index of the internode below; `None` where the host bears it.
    pub(super) below: Option<u32>,
    pub(super) length: f32,
    /// Turn of its frame (+Y along, +Z the upper side) against the one below, or for the first one
    /// its frame in the tree.
    pub(super) turn: Quat,
    /// A further turn in that frame once it is levelled: of a module against the last.
    pub(super) swing: Quat,
    /// Whether it starts an axis, so that its frame is levelled.
    pub(super) starts: bool,
}

/// A twig still to be laid out.
struct Shoot {
    below: Option<u32>,
    turn: Quat,
    length: f32,
    level: u32,
}

/// Plans twigs, and keeps the memory for the next.
pub(super) struct Planner<'a> {
    params: &'a TwigParams,
    pub(super) internodes: Vec<Internode>,
    queue: Vec<Shoot>,
    /// Twigs left out, shorter than half an internode.
    pub(super) too_short: u64,
    /// Twigs planned, laterals too.
    pub(super) n_twigs: u64,
}

impl<'a> Planner<'a> {
    pub(super) fn new(params: &'a TwigParams) -> Self {
        Self { params, internodes: Vec::new(), queue: Vec::new(), too_short: 0, n_twigs: 0 }
    }

    /// Plans the `number`-th twig at this site. `ask` is asked for internodes before they are made.
    pub(super) fn plan(
        &mut self,
        site: &Site,
        number: u32,
        rng: &mut Rng,
        ask: &impl Fn(u64) -> Result<()>,
    ) -> Result<()> {
        let params = self.params;
        self.internodes.clear();
        self.queue.clear();
        let count = params.arrangement.per_node();
        let spread = 0.5 * params.jitter * uniform(rng, -1.0, 1.0);
        let azimuth = site.turn + TAU * number as f32 / count as f32 + spread;
        let outward = Quat::from_axis_angle(site.along, azimuth) * site.side;
        let (pitch, share) = if site.terminal {
            (WANDER * params.jitter * uniform(rng, -1.0, 1.0), params.terminal)
        } else {
            let pitch = params.angle + params.jitter * uniform(rng, -1.0, 1.0);
            (pitch, size_share(params.taper, site.age))
        };
        let vary = 1.0 + params.length_variation * uniform(rng, -1.0, 1.0);
        let host = Mat3::from_cols(outward, site.along, outward.cross(site.along));
        let turn = Quat::from_mat3(&host).normalize() * to_the_right(pitch);
        let length = params.length * share * vary;
        self.queue.push(Shoot { below: None, turn, length, level: 1 });
        let mut next = 0;
        while let Some(shoot) = self.queue.get(next) {
            let shoot = Shoot { ..*shoot };
            next += 1;
            self.lay(&shoot, rng, ask)?;
        }
        Ok(())
    }

    /// Lays out one axis and queues its laterals.
    fn lay(
        &mut self,
        shoot: &Shoot,
        rng: &mut Rng,
        ask: &impl Fn(u64) -> Result<()>,
    ) -> Result<()> {
        let params = self.params;
        let n = self.n_internodes(shoot.length);
        if n == 0 {
            self.too_short += 1;
            return Ok(());
        }
        let modules = Modules::of(params.branching);
        let bears = shoot.level < params.levels && params.lateral > 0.0;
        let per_node = params.arrangement.per_node();
        // A lateral's first internode was asked for when it was queued.
        let have = u64::from(shoot.level > 1);
        ask(n - have + modules.n_stubs(n))?;
        self.n_twigs += 1;
        let length = shoot.length / n as f32;
        let mut azimuth = if params.arrangement.is_flat() { 0.0 } else { uniform(rng, 0.0, TAU) };
        let mut below = shoot.below;
        for k in 0..n {
            let turn = if k == 0 { shoot.turn } else { self.wander(rng) };
            let swing = modules.turn(k);
            self.internodes.push(Internode { below, length, turn, swing, starts: k == 0 });
            let node = self.internodes.len() as u32 - 1;
            if modules.ends(k + 1, n) && modules.stub > 0.0 {
                let length = length * modules.stub;
                let turn = Quat::IDENTITY;
                self.internodes.push(Internode {
                    below: Some(node),
                    length,
                    turn,
                    swing: turn,
                    starts: false,
                });
            }
            below = Some(node);
            if bears && k + 1 < n {
                let share = (k + 1) as f32 / n as f32;
                let longest = shoot.length * params.lateral * size_share(params.taper, 1.0 - share);
                for i in 0..per_node {
                    let around = azimuth + TAU * i as f32 / per_node as f32;
                    self.branch(node, around, longest, shoot.level + 1, rng, ask)?;
                }
                azimuth = (azimuth + params.arrangement.divergence()) % TAU;
            }
        }
        Ok(())
    }

    /// Queues a lateral of at most `longest` metres, at an angle round the internode `node`.
    fn branch(
        &mut self,
        node: u32,
        around: f32,
        longest: f32,
        level: u32,
        rng: &mut Rng,
        ask: &impl Fn(u64) -> Result<()>,
    ) -> Result<()> {
        let params = self.params;
        let around = around + 0.5 * params.jitter * uniform(rng, -1.0, 1.0);
        let pitch = params.angle + params.jitter * uniform(rng, -1.0, 1.0);
        let vary = 1.0 + params.length_variation * uniform(rng, -1.0, 1.0);
        let turn = Quat::from_rotation_y(around) * to_the_right(pitch);
        let length = longest * vary;
        if self.n_internodes(length) == 0 {
            self.too_short += 1;
            return Ok(());
        }
        ask(1)?;
        self.queue.push(Shoot { below: Some(node), turn, length, level });
        Ok(())
    }

    /// Internodes of a twig of this length; none where it is shorter than half of one.
    fn n_internodes(&self, length: f32) -> u64 {
        (length / self.params.internode).round() as u64
    }

    fn wander(&self, rng: &mut Rng) -> Quat {
        let most = WANDER * self.params.jitter;
        if most == 0.0 {
            return Quat::IDENTITY;
        }
        let right = to_the_right(most * uniform(rng, -1.0, 1.0));
        right * Quat::from_rotation_x(most * uniform(rng, -1.0, 1.0))
    }
}

/// The frame of an axis that starts: the same direction, its upper side up.
pub(super) fn level(rotation: Quat) -> Quat {
    frame(rotation * Vec3::Y, Vec3::Y)
}

/// The modules of a sympodial axis; a monopodial one is a single module.
struct Modules {
    internodes: u64,
    turn: f32,
    divergence: f32,
    stub: f32,
}

impl Modules {
    fn of(branching: Branching) -> Self {
        match branching {
            Branching::Monopodial => {
                Self { internodes: u64::MAX, turn: 0.0, divergence: 0.0, stub: 0.0 }
            }
            Branching::Sympodial { internodes, turn, divergence, stub } => {
                Self { internodes: u64::from(internodes.max(1)), turn, divergence, stub }
            }
        }
    }

    /// Whether a module ends after `k` of `n` internodes, and another goes on.
    fn ends(&self, k: u64, n: u64) -> bool {
        k < n && k.is_multiple_of(self.internodes)
    }

    fn n_stubs(&self, n: u64) -> u64 {
        if self.stub > 0.0 { (n - 1) / self.internodes } else { 0 }
    }

    /// The turn of internode `k` that comes of modules, in the plane across the upper side.
    fn turn(&self, k: u64) -> Quat {
        if self.turn == 0.0 || !k.is_multiple_of(self.internodes) {
            return Quat::IDENTITY;
        }
        if k == 0 {
            // Half a turn back, so that a zig-zag as a whole keeps the twig's direction.
            return to_the_right(-0.5 * self.turn);
        }
        let module = (k / self.internodes - 1) as f32;
        let around = Quat::from_rotation_y(module * self.divergence % TAU);
        around * to_the_right(self.turn) * around.inverse()
    }
}
