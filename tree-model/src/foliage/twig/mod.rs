//! Twigs on any skeleton. The steps are told in [`foliage`](crate::foliage).

mod params;
mod plan;
mod refine;
mod set;

pub use params::{Branching, TwigParams};
pub use refine::refine;

use super::sites::{Budget, DensityField, Site, Walk};
use crate::error::Result;
use glam::Vec3;
use plan::Planner;
use set::Setter;
use std::sync::atomic::AtomicU64;
use tree_core::{Continuation, Control, Resource, Seed, Skeleton, SkeletonColumns};

/// A skeleton with twigs.
#[derive(Clone, Debug, PartialEq)]
pub struct Twigs {
    /// The old skeleton, node for node, then the twigs, each with its laterals in one piece.
    pub skeleton: Skeleton,
    /// What was grown and what was not.
    pub report: TwigReport,
}

/// What growing twigs did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct TwigReport {
    /// Twigs that old nodes bear.
    pub n_twigs: u64,
    /// Twigs that twigs bear.
    pub n_laterals: u64,
    /// Nodes added.
    pub n_nodes: u64,
    /// Axes of the old skeleton without a place for a twig: too short, beyond the bearing zone, or
    /// left out by the density.
    pub n_barren: u64,
    /// Places that the density left out.
    pub n_thinned: u64,
    /// Places where the density was negative or not a number, and counted as 0.
    pub n_bad_density: u64,
    /// Twigs and laterals left out, shorter than half an internode.
    pub n_too_short: u64,
    /// Twigs left out because their node bears [`TwigParams::crowd`] already. Many mean that the
    /// skeleton has too few nodes; see [`refine`].
    pub n_crowded: u64,
    /// Largest distance in metres from a twig's place on the shoot to the node that bears it.
    pub moved: f32,
}

/// Grows twigs on the youngest shoots of `skeleton`.
///
/// Old nodes keep number, position, radius and parent. So a twig starts at the node nearest to its
/// place; [`refine`] gives long segments nodes first. Twigs are never thicker than what bears them;
/// what bears them is not made thicker (apply a
/// [`RadiusRule`](tree_core::allometry::RadiusRule) to the result if it should be).
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) or
/// [`ModelError::NotFinite`](crate::ModelError::NotFinite) for parameters out of range;
/// [`ModelError::Limit`](crate::ModelError::Limit) before memory for more nodes is taken;
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled);
/// [`ModelError::Core`](crate::ModelError::Core) where a twig would end beyond what an f32 holds.
///
/// # Complexity
/// O(nodes + places + nodes added).
pub fn grow_twigs(
    skeleton: &Skeleton,
    params: &TwigParams,
    seed: Seed,
    control: &Control,
) -> Result<Twigs> {
    grow(skeleton, params, None, seed, control)
}

/// Grows twigs where `density` asks for them, as [`grow_leaves_in`](super::grow_leaves_in) does leaves.
///
/// # Errors
/// As [`grow_twigs`].
///
/// # Complexity
/// As [`grow_twigs`], and one call of `density` for each place.
pub fn grow_twigs_in(
    skeleton: &Skeleton,
    params: &TwigParams,
    density: &DensityField<'_>,
    seed: Seed,
    control: &Control,
) -> Result<Twigs> {
    grow(skeleton, params, Some(density), seed, control)
}

/// Twigs of one part of the work.
#[derive(Default)]
struct Part {
    positions: Vec<Vec3>,
    radii: Vec<f32>,
    parents: Vec<Parent>,
    report: TwigReport,
}

#[derive(Clone, Copy)]
enum Parent {
    /// A node of the old skeleton.
    Host(u32),
    /// A node of the same part.
    Own(u32),
}

fn grow(
    skeleton: &Skeleton,
    params: &TwigParams,
    density: Option<&DensityField<'_>>,
    seed: Seed,
    control: &Control,
) -> Result<Twigs> {
    params.validate()?;
    let axes = skeleton.axes(Continuation::Thickest);
    let to_tip = skeleton.distances_to_tip();
    let walk = Walk {
        skeleton,
        axes: &axes,
        to_tip: &to_tip,
        spacing: 1.0 / params.per_metre,
        bearing: params.bearing,
        arrangement: params.arrangement,
        terminal: params.terminal > 0.0,
        density,
    };
    let n_old = skeleton.len() as u64;
    let n_sites = walk.n_sites();
    control.limits.check(Resource::Nodes, n_old.max(n_sites))?;
    let used = AtomicU64::new(n_old);
    let most = n_old.saturating_add(n_sites.saturating_mul(walk.most_each()));
    let budget = Budget { control, resource: Resource::Nodes, used, most };
    let axis_of = axes.axis_of();
    let (parts, tally) = walk.parts(seed, &budget, |sites| {
        // A segment at an axis's base starts on another axis: its twigs go to its own upper node.
        let host = |site: &Site| {
            let own = axis_of.get(site.below as usize) == axis_of.get(site.node as usize);
            if own && site.share < 0.5 { site.below } else { site.node }
        };
        grow_part(skeleton, params, sites, host, &budget)
    })?;
    let mut columns = SkeletonColumns::from(skeleton.clone());
    let mut report = TwigReport {
        n_barren: tally.barren,
        n_thinned: tally.thinned,
        n_bad_density: tally.bad_density,
        ..TwigReport::default()
    };
    for part in parts {
        let first = columns.parents.len() as u32;
        columns.positions.extend(part.positions);
        columns.radii.extend(part.radii);
        columns.parents.extend(part.parents.iter().map(|&parent| match parent {
            Parent::Host(node) => node,
            Parent::Own(node) => first + node,
        }));
        report.add(part.report);
        control.check()?;
    }
    Ok(Twigs { skeleton: Skeleton::try_from(columns)?, report })
}

/// Grows the twigs of these places.
fn grow_part(
    skeleton: &Skeleton,
    params: &TwigParams,
    sites: &[Site],
    host: impl Fn(&Site) -> u32,
    budget: &Budget<'_>,
) -> Result<Part> {
    let mut part = Part::default();
    let (mut planner, mut setter) = (Planner::new(params), Setter::default());
    // Places of one node come one after the other.
    let (mut last, mut crowd) = (u32::MAX, 0);
    for site in sites {
        let node = host(site);
        if node != last {
            (last, crowd) = (node, 0);
        }
        let Some(&position) = skeleton.positions().get(node as usize) else { continue };
        let radius = skeleton.radii().get(node as usize).copied().unwrap_or(0.0);
        let count = if site.terminal { 1 } else { params.arrangement.per_node() };
        let mut rng = site.seed.rng();
        for number in 0..count {
            // The twig that goes on is no lateral, and always finds room.
            if crowd >= params.crowd && !site.terminal {
                part.report.n_crowded += 1;
                continue;
            }
            planner.plan(site, number, &mut rng, &|more| budget.ask(more))?;
            if planner.internodes.is_empty() {
                continue;
            }
            crowd += u32::from(!site.terminal);
            part.report.n_twigs += 1;
            part.report.moved = part.report.moved.max(position.distance(site.point));
            let first = part.parents.len() as u32;
            part.parents.extend(planner.internodes.iter().map(|internode| {
                internode.below.map_or(Parent::Host(node), |below| Parent::Own(first + below))
            }));
            setter.set(params, &planner.internodes, position, radius, |position, radius| {
                part.positions.push(position);
                part.radii.push(radius);
            });
        }
    }
    part.report.n_nodes = part.parents.len() as u64;
    part.report.n_laterals = planner.n_twigs - part.report.n_twigs;
    part.report.n_too_short = planner.too_short;
    Ok(part)
}

impl TwigReport {
    fn add(&mut self, part: Self) {
        self.n_twigs += part.n_twigs;
        self.n_laterals += part.n_laterals;
        self.n_nodes += part.n_nodes;
        self.n_too_short += part.n_too_short;
        self.n_crowded += part.n_crowded;
        self.moved = self.moved.max(part.moved);
    }
}
