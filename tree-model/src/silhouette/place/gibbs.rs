//! Positions of branches by a Gibbs process (sections 5.2 to 5.4; Diggle 1983, Ripley 1979).
//!
//! Every branch keeps others away; the process finds positions in the branches' domains at which the sum of costs over
//! all pairs is low.
//!
//! 1. nodes of the parent and a first arrangement on the pattern, drawn branches where they were drawn;
//! 2. depletion–replacement: one branch at a time tries another position of its domain, near or far, and keeps it only
//!    where the total cost falls;
//! 3. the end after 3000 moves, or when the cost has nearly stopped to fall.
//!
//! We depart from the paper in three things. It starts at random positions: 3000 moves of 50 branches then leave gaps
//! and half of a pattern; we start on the pattern, for [`Arrangement::Spread`] evenly. It counts nodes by distance: see
//! `nodes`. And branches of a pattern try positions at nodes, not anywhere along the parent, for the
//! cost alone would draw the branches of a whorl apart along it. The cost itself is the paper's.
//!
//! A move costs O(N). 50 branches and 3000 moves take half a millisecond, 300 branches one
//! and a half.

use super::arrangement::Arrangement;
use super::cost::{Columns, Spot, Weights};
use super::domain::{Domain, Site, in_turn};
use super::nodes::{Nodes, privileged_at};
use crate::error::{Result, check};
use std::f32::consts::TAU;
use tree_core::seed::{Rng, uniform};
use tree_core::{Control, Seed};

/// Most branches of one parent: the first sum over all pairs would take seconds.
pub const MAX_SITES: u32 = 20_000;

/// A move must lower the cost of a branch by this share of it: less is what sums of f32 lose, and the total could rise.
const LEAST_GAIN: f32 = 1e-5;

/// Moves between two looks at whether the cost still falls, for each branch; at least [`LEAST_WINDOW`].
const WINDOW: usize = 4;

/// Fewest moves between two looks.
const LEAST_WINDOW: usize = 100;

/// Moves between two questions whether to stop.
const CHECK_EVERY: u32 = 256;

/// Share of moves that look near the branch's position instead of anywhere in its domain.
const NEAR: f32 = 0.7;

/// How far a near move of [`Arrangement::Spread`] reaches, in average distances of two branches.
const NEAR_STEP: f32 = 0.6;

/// How far positions are strewn round a privileged one, as a share of the angle between two of a node.
const PHASE_STREW: f32 = 0.02;

/// How far positions are strewn at first when there is no pattern, in average distances of two branches.
const START_STREW: f32 = 0.5;

/// The golden section: its multiples fill a turn evenly, wherever one stops.
const GOLDEN: f32 = 0.618_034;

/// How positions are found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct GibbsParams {
    /// α, how quickly branches stop to keep others away, 0 to 1000 for a distance of the whole length. Default 20 (5.4).
    pub reach: f32,
    /// w1, weight of closeness, 0 to 1000. Default 2 (5.4).
    pub closeness: f32,
    /// w2, weight of the pattern, 0 to 1000. Default 1 (5.4). [`Arrangement::Spread`] has no pattern.
    pub pattern: f32,
    /// Most moves, 0 to 1,000,000. Default 3000 (5.4).
    pub moves: u32,
    /// The process ends when four moves of each branch lower the cost by less than this share, 0 to 1. Default 0.0001.
    /// 0 makes all moves.
    pub quiet: f32,
    /// How far branches of a node stand off from it along the parent, as a share of the average node length, 0 to 0.5.
    /// Default 0.06.
    pub scatter: f32,
}

impl Default for GibbsParams {
    fn default() -> Self {
        Self { reach: 20.0, closeness: 2.0, pattern: 1.0, moves: 3000, quiet: 1e-4, scatter: 0.06 }
    }
}

impl GibbsParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("gibbs.reach", self.reach, 0.0, 1e3)?;
        check("gibbs.closeness", self.closeness, 0.0, 1e3)?;
        check("gibbs.pattern", self.pattern, 0.0, 1e3)?;
        check("gibbs.moves", self.moves, 0_u32, 1_000_000_u32)?;
        check("gibbs.quiet", self.quiet, 0.0, 1.0)?;
        check("gibbs.scatter", self.scatter, 0.0, 0.5)
    }
}

/// Positions and how they came about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arranged {
    /// A site for each domain, in their order.
    pub sites: Vec<Site>,
    /// The total cost F of them.
    pub cost: f32,
    /// Moves tried.
    pub moves: u32,
    /// Moves kept.
    pub accepted: u32,
    /// F at the start and after each kept move; never rises.
    pub trace: Vec<f32>,
}

/// Finds a position in each domain.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first value out of range, and for more than
/// [`MAX_SITES`] domains; [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(N²) once for the first cost, then O(N) a move.
pub fn arrange(
    domains: &[Domain],
    arrangement: &Arrangement,
    params: &GibbsParams,
    seed: Seed,
    control: &Control,
) -> Result<Arranged> {
    check("domains.len()", domains.len() as f64, 0.0, MAX_SITES)?;
    params.validate()?;
    arrangement.validate()?;
    domains.iter().enumerate().try_for_each(|(i, domain)| domain.validate(i))?;
    if domains.is_empty() {
        return Ok(Arranged::default());
    }
    control.report("arranging branches", 0.0)?;
    let mut process = Process::new(domains, arrangement, params, seed.stream("gibbs").rng());
    let arranged = process.run(control)?;
    control.report("arranging branches", 1.0)?;
    Ok(arranged)
}

/// A ready pattern of `n` branches that may stand anywhere, sorted along the parent, with the default parameters. Other
/// variants are other draws of the same seed. For caches of patterns.
///
/// # Errors
/// As [`arrange`].
///
/// # Complexity
/// As [`arrange`].
pub fn ready(n: u32, arrangement: &Arrangement, variant: u64, seed: Seed) -> Result<Vec<Site>> {
    check("n", n, 0_u32, MAX_SITES)?;
    let domains = vec![Domain::default(); n as usize];
    let seed = seed.stream("ready").child(variant);
    let params = GibbsParams::default();
    let mut sites = arrange(&domains, arrangement, &params, seed, &Control::default())?.sites;
    sites.sort_by(|a, b| a.along.total_cmp(&b.along).then(a.azimuth.total_cmp(&b.azimuth)));
    Ok(sites)
}

/// The process at work.
struct Process<'a> {
    domains: &'a [Domain],
    arrangement: &'a Arrangement,
    params: &'a GibbsParams,
    nodes: Nodes,
    sites: Vec<Site>,
    columns: Columns,
    rng: Rng,
}

impl<'a> Process<'a> {
    fn new(
        domains: &'a [Domain],
        arrangement: &'a Arrangement,
        params: &'a GibbsParams,
        mut rng: Rng,
    ) -> Self {
        let nodes = Nodes::of(domains, arrangement, &mut rng);
        let pattern = if arrangement.has_pattern() { params.pattern } else { 0.0 };
        // A fixed plane pulls as strongly as if half of the branches stood in it already.
        let pulls = if arrangement.fixed().is_some() { 0.5 * domains.len() as f32 } else { 0.0 };
        let weights = Weights {
            reach: params.reach,
            closeness: params.closeness,
            pattern,
            fixed: pulls * pattern,
        };
        let mut process = Self {
            domains,
            arrangement,
            params,
            nodes,
            sites: Vec::new(),
            columns: Columns::new(&[], weights),
            rng,
        };
        process.sites =
            if arrangement.has_pattern() { process.on_pattern() } else { process.evenly() };
        let spots: Vec<Spot> = process.sites.iter().map(|site| process.spot(site)).collect();
        process.columns = Columns::new(&spots, weights);
        process
    }

    /// Depletion and replacement until the cost has settled.
    fn run(&mut self, control: &Control) -> Result<Arranged> {
        let domains = self.domains.iter().enumerate();
        let loose: Vec<usize> = domains.filter(|(_, d)| !d.is_point()).map(|(i, _)| i).collect();
        let window = (WINDOW * loose.len()).max(LEAST_WINDOW);
        let most = if loose.is_empty() { 0 } else { self.params.moves };
        let mut trace = vec![self.columns.total() as f32];
        let (mut moves, mut quiet_since, mut before) = (0, 0, self.columns.total());
        while moves < most {
            if moves % CHECK_EVERY == 0 {
                control.check()?;
            }
            moves += 1;
            quiet_since += 1;
            let i = loose[self.below(loose.len())];
            if self.try_move(i) {
                trace.push(self.columns.total() as f32);
            }
            if quiet_since == window {
                let now = self.columns.total();
                if before - now < f64::from(self.params.quiet) * now {
                    break;
                }
                (before, quiet_since) = (now, 0);
            }
        }
        if !self.arrangement.has_pattern() {
            rank(&mut self.sites);
        }
        Ok(Arranged {
            sites: std::mem::take(&mut self.sites),
            cost: self.columns.total() as f32,
            moves,
            accepted: (trace.len() - 1) as u32,
            trace,
        })
    }

    /// Tries another position for branch `i`. O(N).
    fn try_move(&mut self, i: usize) -> bool {
        let near = uniform(&mut self.rng, 0.0, 1.0) < NEAR;
        let site = match (self.arrangement.has_pattern(), near) {
            (true, true) => self.on_node(i),
            (false, true) => self.beside(i),
            (_, false) => self.anywhere(i),
        };
        let spot = self.spot(&site);
        let (here, there) = (self.columns.here(i), self.columns.row(i, spot));
        let falls = there < here - LEAST_GAIN * here.abs();
        if falls {
            self.columns.replace(i, spot, there);
            self.sites[i] = site;
        }
        falls
    }

    /// A privileged position with regard to another branch, at the same node or at any.
    fn on_node(&mut self, i: usize) -> Site {
        let own = self.sites[i].node;
        let other = self.below(self.sites.len());
        let with = self.sites[other];
        let stays = self.nodes.tied[i].is_some() || uniform(&mut self.rng, 0.0, 1.0) < 0.5;
        let node = if stays { own } else { self.below(self.nodes.along.len()) as u32 };
        let m = self.below(self.arrangement.per_node() as usize) as u32;
        let turned = privileged_at(self.arrangement, with.azimuth, node, m)
            - privileged_at(self.arrangement, 0.0, with.node, 0);
        self.near_node(i, node, turned)
    }

    /// A position near a node and an azimuth, brought into the domain of `i`.
    fn near_node(&mut self, i: usize, node: u32, azimuth: f32) -> Site {
        let (scatter, strew) =
            (self.params.scatter * self.nodes.length, PHASE_STREW * self.arrangement.spacing());
        let along = self.nodes.along[node as usize] + uniform(&mut self.rng, -scatter, scatter);
        let azimuth = azimuth + uniform(&mut self.rng, -strew, strew);
        self.within(i, along, azimuth)
    }

    /// A position near that of `i`.
    fn beside(&mut self, i: usize) -> Site {
        let step = NEAR_STEP / (self.sites.len() as f32).sqrt();
        let site = self.sites[i];
        let along = site.along + uniform(&mut self.rng, -step, step);
        let azimuth = site.azimuth + TAU * uniform(&mut self.rng, -step, step);
        self.within(i, along, azimuth)
    }

    /// Any position in the domain of `i`; in a pattern at a node.
    fn anywhere(&mut self, i: usize) -> Site {
        let domain = &self.domains[i];
        let azimuth = domain.azimuth[0] + uniform(&mut self.rng, 0.0, domain.width());
        if self.arrangement.has_pattern() {
            let node = self.nodes.tied[i].unwrap_or(self.below(self.nodes.along.len()) as u32);
            return self.near_node(i, node, azimuth);
        }
        let along = uniform(&mut self.rng, domain.along[0], domain.along[1]);
        self.within(i, along, azimuth)
    }

    /// A position brought into the domain of `i`, at its node.
    fn within(&self, i: usize, along: f32, azimuth: f32) -> Site {
        let domain = &self.domains[i];
        let along = along.clamp(domain.along[0], domain.along[1]);
        let node = self.nodes.tied[i].unwrap_or_else(|| self.nodes.nearest(along));
        Site { along, azimuth: domain.nearest(azimuth), node }
    }

    fn spot(&self, site: &Site) -> Spot {
        let base = privileged_at(self.arrangement, self.nodes.origin, site.node, 0);
        let phase = in_turn(site.azimuth - base) / self.arrangement.spacing();
        Spot { along: site.along, turn: site.azimuth / TAU, phase: phase - phase.floor() }
    }

    /// The start in a pattern: drawn branches as near to their privileged positions as they may be, the others on those
    /// that are left.
    fn on_pattern(&mut self) -> Vec<Site> {
        let per_node = self.arrangement.per_node();
        let slots = self.nodes.along.len() as u32 * per_node;
        let mut taken = vec![false; slots as usize];
        let mut sites = vec![Site::default(); self.domains.len()];
        let mut free = Vec::new();
        for (i, site) in sites.iter_mut().enumerate() {
            let Some(node) = self.nodes.tied[i] else {
                free.push(i);
                continue;
            };
            let slot = self.best_slot(i, node, &taken);
            taken[(node * per_node + slot) as usize] = true;
            *site = self.at_slot(i, node, slot);
        }
        // Who must stand low gets a low node.
        let middle = |i: usize| self.domains[i].along[0] + self.domains[i].along[1];
        free.sort_by(|&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
        let open = (0..slots).filter(|&slot| !taken[slot as usize]);
        for (i, slot) in free.into_iter().zip(open) {
            sites[i] = self.at_slot(i, slot / per_node, slot % per_node);
        }
        sites
    }

    /// The position of a node that lies nearest to the domain of `i`, of those not taken if there are any.
    fn best_slot(&self, i: usize, node: u32, taken: &[bool]) -> u32 {
        let per_node = self.arrangement.per_node();
        let rank = |m: u32| {
            let at = privileged_at(self.arrangement, self.nodes.origin, node, m);
            let penalty = if taken[(node * per_node + m) as usize] { TAU } else { 0.0 };
            self.domains[i].outside(at) + penalty
        };
        (1..per_node).fold(0, |best, m| if rank(m) < rank(best) { m } else { best })
    }

    fn at_slot(&mut self, i: usize, node: u32, slot: u32) -> Site {
        let azimuth = privileged_at(self.arrangement, self.nodes.origin, node, slot);
        self.near_node(i, node, azimuth)
    }

    /// The start without a pattern: each in a stretch of its own along its domain, azimuths by the golden section.
    fn evenly(&mut self) -> Vec<Site> {
        let n = self.domains.len();
        let strew = START_STREW / (n as f32).sqrt();
        let start = uniform(&mut self.rng, 0.0, 1.0);
        (0..n)
            .map(|i| {
                let Domain { along: [low, high], .. } = self.domains[i];
                let share = (i as f32 + uniform(&mut self.rng, 0.0, 1.0)) / n as f32;
                let golden = (i as f64 * f64::from(GOLDEN)).fract() as f32;
                let turn = start + golden + uniform(&mut self.rng, -strew, strew);
                self.within(i, low + share * (high - low), TAU * turn)
            })
            .collect()
    }

    /// A whole number below `n`.
    fn below(&mut self, n: usize) -> usize {
        (uniform(&mut self.rng, 0.0, n as f32) as usize).min(n.saturating_sub(1))
    }
}

/// Numbers sites along the parent.
fn rank(sites: &mut [Site]) {
    let mut order: Vec<usize> = (0..sites.len()).collect();
    order.sort_by(|&a, &b| sites[a].along.total_cmp(&sites[b].along).then(a.cmp(&b)));
    for (rank, i) in order.into_iter().enumerate() {
        sites[i].node = rank as u32;
    }
}

#[cfg(test)]
mod tests;
