//! Branch propagation: what the sketch leaves out, grown by its own pattern (Neubert 2012, section 4.7).
//!
//! 1. Replication blocks, a parent segment and its children, are taken from the sketch by the order of the parent's
//!    axis; where an order has few, blocks drawn from Ω are added.
//! 2. Along branches much longer than Ω's scale says against their parents, new forks are set at even distances,
//!    with laterals that turn about the axis by γ from one to the next, the longer the more of the axis is still to
//!    come.
//! 3. Each open end draws a block at random, which is scaled and turned to it and attached: its children are the
//!    open ends of the next generation. So for a fixed number of generations, or with a crown drawn until branches
//!    reach its surface of local revolution; those end there.
//!
//! Departures: the thesis draws blocks from all of the tree; here by order, so that a spruce's shoots do not grow as
//! its trunk does, and axes of an order without laterals do not branch. What grows on a sketched segment is made
//! smaller or larger to reach the crown's surface, not only cut. Beyond the thesis: obstacles, which new segments
//! are turned aside from, end before, or do not grow for, and the ground likewise; and streams of randomness that are named by the way from
//! the root, so that an edit of one branch leaves what grew on others as it was.
//!
//! Cost: O(segments × blocks of an order), at most 48; parallel over open ends, the same for any number of
//! threads.

mod block;
mod bound;
mod drawn;
#[cfg(test)]
pub(super) mod fixtures;
mod frame;
mod grow;
mod open;
mod params;
#[cfg(test)]
mod tests;

pub(super) use frame::point_at;
pub use params::PropagateParams;

use super::crown::Crown;
use super::{Branches, Omega};
use crate::error::Result;
use crate::path::Obstacle;
use block::Pools;
use bound::Bounds;
use drawn::Drawn;
use grow::{Grower, Open, Part, Tally};
use rayon::prelude::*;
use tree_core::{Control, Resource, Seed, Volume};

/// Open ends that one task grows: a few microseconds of work each.
const CHUNK: usize = 64;
/// Points of a new segment, at most.
const POINTS: u64 = 5;

/// A sketch with what grew on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Propagated {
    /// The sketched segments, number for number as they were, then the new.
    pub branches: Branches,
    /// How many segments are sketched.
    pub n_sketched: usize,
    /// The generation of each segment, 0 for the sketched.
    pub generations: Vec<u32>,
    /// Where on its parent each segment begins, counted in the parent's points: 2.25 is a quarter of the way from its
    /// point 2 to its point 3. The parent's end but for new laterals along sketched segments; 0 for the root.
    pub forks: Vec<f32>,
    /// What grew and what did not.
    pub report: PropagateReport,
}

/// What propagation did. Numbers count segments unless they say otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PropagateReport {
    /// New ones.
    pub n_new: u64,
    /// The last generation in which any grew.
    pub generations: u32,
    /// Replication blocks taken from the sketch.
    pub n_blocks: u32,
    /// Replication blocks drawn from Ω because the sketch has few of their order.
    pub n_blocks_from_omega: u32,
    /// Sketched ones so long that they got new laterals.
    pub n_long: u64,
    /// New forks along those.
    pub n_forks: u64,
    /// Open ends and forks of the sketch that lie outside the crown, where nothing grew.
    pub n_ends_outside: u64,
    /// Those that end at the crown's surface.
    pub n_touched: u64,
    /// Left out because the surface left too little of them.
    pub n_outside: u64,
    /// Left out because they would have been shorter than [`PropagateParams::shortest`].
    pub n_too_short: u64,
    /// Turned aside from an obstacle or the ground.
    pub n_turned_aside: u64,
    /// Shortened because of an obstacle or the ground.
    pub n_shortened: u64,
    /// Left out because of an obstacle or the ground.
    pub n_blocked: u64,
    /// Left out because there would have been more than [`PropagateParams::max_segments`].
    pub n_over_cap: u64,
}

impl Propagated {
    /// The sketch alone.
    #[must_use]
    pub fn bare(branches: Branches) -> Self {
        let n = branches.len();
        let forks = branches.parents().iter().map(|&parent| last_place(&branches, parent));
        let forks = forks.collect();
        let report = PropagateReport::default();
        Self { n_sketched: n, generations: vec![0; n], forks, branches, report }
    }
}

/// Where a segment ends, counted in its points; 0 where there is none.
fn last_place(branches: &Branches, segment: u32) -> f32 {
    branches.points(segment as usize).len().saturating_sub(1) as f32
}

/// Fills a sketch up with branches after the pattern of its own.
///
/// With a crown, growth stays inside it; without, it goes on for [`PropagateParams::generations`]. New segments stay
/// [`PropagateParams::clearance`] away from `obstacles`; sketched ones stay as they are. Sketched ends outside the
/// crown do not grow.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for a parameter or a number of Ω out of range;
/// [`ModelError::Sketch`](crate::ModelError::Sketch) for an Ω without orders and for points more than 1e6 m away;
/// [`ModelError::Limit`](crate::ModelError::Limit) before memory is taken;
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(segments × blocks of an order).
pub fn propagate(
    branches: &Branches,
    omega: &Omega,
    crown: Option<&Crown>,
    obstacles: Option<&Volume>,
    params: &PropagateParams,
    seed: Seed,
    control: &Control,
) -> Result<Propagated> {
    params.validate()?;
    control.report("propagate", 0.0)?;
    let drawn = Drawn::new(branches, omega, params, seed.stream("propagate"))?;
    let pools = Pools::new(&drawn, omega, seed.stream("blocks"));
    let obstacle =
        obstacles.map(|volume| Obstacle { volume: volume.clone(), clearance: params.clearance });
    let grower = Grower {
        pools: &pools,
        omega,
        bounds: Bounds { crown, obstacle: obstacle.as_ref(), ground: drawn.ground() },
        params,
        generations: if crown.is_some() { params.generations_in_crown } else { params.generations },
        shortest: (params.shortest * drawn.height).max(f32::MIN_POSITIVE),
    };
    let found = open::find(&drawn, &pools, &grower);
    let mut grown = Propagated::bare(branches.clone());
    grown.report = PropagateReport {
        n_blocks: pools.n_drawn,
        n_blocks_from_omega: pools.n_filled,
        n_long: found.long,
        n_forks: found.forks,
        n_ends_outside: found.outside,
        ..PropagateReport::default()
    };
    let mut opens = found.opens;
    for generation in 1..=grower.generations {
        if opens.is_empty() {
            break;
        }
        control.report("propagate", (generation - 1) as f32 / grower.generations as f32)?;
        opens = generate(&mut grown, &grower, &opens, generation, control)?;
    }
    control.report("propagate", 1.0)?;
    Ok(grown)
}

/// Grows one generation; returns its open ends.
fn generate(
    grown: &mut Propagated,
    grower: &Grower<'_>,
    opens: &[Open],
    generation: u32,
    control: &Control,
) -> Result<Vec<Open>> {
    let room = u64::from(grower.params.max_segments).saturating_sub(grown.branches.len() as u64);
    let most = (opens.len() as u64).saturating_mul(grower.pools.most_children());
    let n_points = grown.branches.points.len() as u64;
    control.limits.check(Resource::Nodes, n_points + POINTS * most.min(room))?;
    if room == 0 {
        return Ok(Vec::new());
    }
    let parts = opens
        .par_chunks(CHUNK)
        .map(|opens| {
            control.check()?;
            Ok(grower.grow(opens))
        })
        .collect::<Result<Vec<_>>>()?;
    let n_new: u64 = parts.iter().map(|part| part.parents.len() as u64).sum();
    let mut thinned = Thinned { seen: 0, n: n_new, room: room.min(n_new) };
    let before = grown.branches.len();
    let mut opens = Vec::new();
    for part in &parts {
        grown.join(part, generation, &mut thinned, &mut opens);
    }
    grown.report.n_over_cap += n_new - thinned.room;
    if grown.branches.len() > before {
        grown.report.generations = generation;
    }
    Ok(if n_new > room { Vec::new() } else { opens })
}

/// Keeps `room` of `n` rows, evenly spread.
struct Thinned {
    seen: u64,
    n: u64,
    room: u64,
}

impl Thinned {
    fn keeps(&mut self) -> bool {
        let before = self.seen * self.room / self.n;
        self.seen += 1;
        self.seen * self.room / self.n > before
    }
}

impl Propagated {
    /// Appends a part's segments, and its open ends to `opens`.
    fn join(&mut self, part: &Part, generation: u32, thinned: &mut Thinned, opens: &mut Vec<Open>) {
        let branches = &mut self.branches;
        let mut ends = part.opens.iter().peekable();
        for row in 0..part.parents.len() {
            let keeps = thinned.keeps();
            let end = ends.next_if(|open| open.segment as usize == row);
            if !keeps {
                continue;
            }
            opens.extend(end.map(|open| Open { segment: branches.parents.len() as u32, ..*open }));
            branches.parents.push(part.parents[row]);
            branches.labels.push(part.labels[row]);
            branches.points.extend(&part.points[row][..usize::from(part.n_points[row])]);
            branches.starts.push(branches.points.len() as u32);
            self.forks.push(part.forks[row]);
            self.generations.push(generation);
            self.report.n_new += 1;
        }
        let (report, tally) = (&mut self.report, part.tally);
        let Tally { touched, outside, too_short, aside, shortened, dropped } = tally;
        report.n_touched += touched;
        report.n_outside += outside;
        report.n_too_short += too_short;
        report.n_turned_aside += aside;
        report.n_shortened += shortened;
        report.n_blocked += dropped;
    }
}
