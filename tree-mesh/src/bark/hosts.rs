//! Which axis each lateral stands on, and where it leaves it.
//!
//! That is the axis it forks from, but for three cases:
//! * The fork lies in wood that belongs to another: before its parent has left its own parent, or in
//!   an axis that is not drawn. Then the lateral stands on what its parent stands on.
//! * It runs so close to a thicker sibling that both come out of the wall in one place. Then it stands
//!   on that sibling, and leaves it where it turns away.
//! * It never comes out. Then it is not drawn, and what it carries stands on what is below.

use super::attach::{Exit, Host};
use super::circle::Circles;
use super::curves::{AXES_PER_PART, Curves};
use super::flare::Flare;
use super::plan::NONE;
use super::storey::Wish;
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Axes, Control, Skeleton};

/// A lateral whose line comes out of the wall within this many of its radii from a thicker sibling's
/// wood stands on that sibling.
const FUSED: f32 = 0.4;
/// Rounds of handing on, after which what still has nothing to stand on is not drawn.
const ROUNDS: u32 = 8;
/// At most so many siblings on either side are looked at.
const NEIGHBOURS: usize = 12;

/// Where a lateral leaves which axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaving {
    pub(crate) host: u32,
    /// `None` when it stays inside, or has no length.
    pub(crate) exit: Option<Exit>,
}

impl Leaving {
    /// Whether it has a wall that others can stand on.
    fn carries(&self) -> bool {
        self.exit.is_some_and(|exit| !exit.stub)
    }
}

/// All axes and their lines.
pub(crate) struct Forest<'a> {
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) axes: &'a Axes,
    pub(crate) curves: &'a Curves,
    pub(crate) flare: Flare,
    pub(crate) circles: &'a Circles,
}

impl Forest<'_> {
    /// Hosts and exits of all axes; axis 0 has none.
    ///
    /// # Complexity
    /// O(axes · steps of a walk), in parallel; laterals that are handed on, one after the other.
    pub(crate) fn leave_all(&self, control: &Control) -> Result<Vec<Leaving>> {
        let mut all = (0..self.axes.len() as u32)
            .into_par_iter()
            .with_min_len(AXES_PER_PART)
            .map(|axis| {
                control.check()?;
                let Some((host, fork)) = self.fork(axis) else {
                    return Ok(Leaving { host: NONE, exit: None });
                };
                Ok(Leaving { host, exit: self.leave(axis, host, fork) })
            })
            .collect::<Result<Vec<_>>>()?;
        self.hand_on(&mut all, control)?;
        let wishes = Wishes::group(&all);
        let fused = (0..all.len())
            .into_par_iter()
            .with_min_len(AXES_PER_PART)
            .map(|host| {
                control.check()?;
                Ok(self.fuse(host as u32, wishes.of(host), &all))
            })
            .collect::<Result<Vec<_>>>()?;
        for (axis, leaving) in fused.into_iter().flatten() {
            all[axis as usize] = leaving;
        }
        // A sibling may come later in the order than what stands on it.
        for _ in 0..ROUNDS {
            if !self.hand_on(&mut all, control)? {
                break;
            }
        }
        while drop_unsettled(&mut all) {}
        Ok(all)
    }

    /// The axis that this one forks from, and where along it.
    fn fork(&self, axis: u32) -> Option<(u32, f32)> {
        let first = *self.axes.get(axis)?.nodes.first()?;
        let fork = self.skeleton.parent(first)? as usize;
        Some((self.axes.axis_of()[fork], self.curves.along[fork]))
    }

    fn leave(&self, axis: u32, host: u32, fork: f32) -> Option<Exit> {
        self.host(host)?.exit(fork, &self.curves.get(axis)?)
    }

    fn host(&self, axis: u32) -> Option<Host<'_>> {
        let flare = if axis == 0 { self.flare } else { Flare::NONE };
        Some(Host { curve: self.curves.get(axis)?, flare, circles: self.circles })
    }

    /// Hands on laterals that fork where their host has no wall. Parents come first. Tells whether
    /// there were any.
    fn hand_on(&self, all: &mut [Leaving], control: &Control) -> Result<bool> {
        let mut any = false;
        for axis in 1..all.len() {
            if axis % AXES_PER_PART == 0 {
                control.check()?;
            }
            let Leaving { mut host, mut exit } = all[axis];
            loop {
                if host == 0 || host == NONE {
                    break;
                }
                let below = all[host as usize];
                let start = below.exit.map_or(0.0, |exit| exit.start);
                if below.carries() && exit.is_none_or(|exit| exit.center > start) {
                    break;
                }
                let at = match below.exit {
                    Some(exit) => exit.center,
                    None => self.fork(host).map_or(0.0, |(_, fork)| fork),
                };
                host = below.host;
                exit = self.leave(axis as u32, host, at);
                any = true;
            }
            all[axis] = Leaving { host, exit };
        }
        Ok(any)
    }

    /// Laterals of a host that rather stand on thicker siblings.
    fn fuse(&self, host: u32, wishes: &[Wish], all: &[Leaving]) -> Vec<(u32, Leaving)> {
        let radius = |wish: &Wish| wish.half_width;
        let mut fused: Vec<(u32, Leaving)> = Vec::new();
        for (i, wish) in wishes.iter().enumerate() {
            let Some(exit) = all[wish.lateral as usize].exit else { continue };
            let Some(line) = self.curves.get(wish.lateral) else { continue };
            let near = i.saturating_sub(NEIGHBOURS)..(i + NEIGHBOURS + 1).min(wishes.len());
            let mut best: Option<(f32, u32, Exit)> = None;
            for other in near {
                let sibling = &wishes[other];
                let thicker = (radius(sibling), sibling.lateral) > (radius(wish), wish.lateral);
                let apart = (sibling.center - wish.center).abs();
                let Leaving { host: on, exit: Some(base) } = all[sibling.lateral as usize] else {
                    continue;
                };
                // On the other side of the host they cannot meet.
                let beside = sibling.out.dot(wish.out) > 0.0;
                if !thicker
                    || !beside
                    || on != host
                    || base.stub
                    || apart > wish.reach[0] + sibling.reach[0] + wish.reach[1] + sibling.reach[1]
                {
                    continue;
                }
                let Some(wood) = self.host(sibling.lateral) else { continue };
                let place = line.at(exit.start);
                let outside = wood.distance(&place, base.start);
                if outside > FUSED * place.station.radius
                    || best.is_some_and(|best| best.0 <= outside)
                {
                    continue;
                }
                if let Some(leaving) = wood.exit(base.start, &line)
                    && leaving.center > base.start
                {
                    best = Some((outside, sibling.lateral, leaving));
                }
            }
            if let Some((_, host, exit)) = best {
                fused.push((wish.lateral, Leaving { host, exit: Some(exit) }));
            }
        }
        fused
    }
}

/// Leaves out what stands on an axis without a wall; tells whether there was any, for then more may.
fn drop_unsettled(all: &mut [Leaving]) -> bool {
    let mut any = false;
    for axis in 1..all.len() {
        let Leaving { host, exit } = all[axis];
        if exit.is_some() && host != 0 && host != NONE && !all[host as usize].carries() {
            all[axis].exit = None;
            any = true;
        }
    }
    any
}

/// Holes wanted in each axis, lowest first.
pub(crate) struct Wishes {
    starts: Vec<u32>,
    wishes: Vec<Wish>,
}

impl Wishes {
    pub(crate) fn group(exits: &[Leaving]) -> Self {
        let mut starts = vec![0_u32; exits.len() + 1];
        let leaving = || {
            exits
                .iter()
                .enumerate()
                .filter_map(|(lateral, leaving)| Some((lateral, leaving.host, leaving.exit?)))
        };
        for (_, host, _) in leaving() {
            starts[host as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let nothing =
            Wish { lateral: 0, center: 0.0, reach: [0.0; 2], half_width: 0.0, out: Vec3::ZERO };
        let mut wishes = vec![nothing; starts.last().copied().unwrap_or(0) as usize];
        for (lateral, host, exit) in leaving() {
            let slot = &mut next[host as usize];
            wishes[*slot as usize] = Wish {
                lateral: lateral as u32,
                center: exit.center,
                reach: exit.reach,
                half_width: exit.half_width,
                out: exit.out,
            };
            *slot += 1;
        }
        for pair in starts.windows(2) {
            // Stable: those at one height stay in the order of their numbers.
            wishes[pair[0] as usize..pair[1] as usize]
                .sort_by(|a, b| a.center.total_cmp(&b.center));
        }
        Self { starts, wishes }
    }

    pub(crate) fn of(&self, axis: usize) -> &[Wish] {
        &self.wishes[self.starts[axis] as usize..self.starts[axis + 1] as usize]
    }
}
