//! Twigs and leaves, as many as the images ask for and none where they are empty.

use super::demand::Demand;
use super::params::FinishParams;
use super::sight::Sight;
use crate::error::Result;
use crate::foliage::{LeafParams, TwigParams, grow_leaves, grow_leaves_in, grow_twigs_in, refine};
use crate::particle::grid::Grid;
use crate::particle::view::View;
use rayon::prelude::*;
use tree_core::{Control, Foliage, NO_PARENT, Seed, Skeleton, SkeletonColumns, Tree};

/// Places for leaves that twigs are to offer, against leaves asked for: some are in the wrong place.
const SPARE: f32 = 1.6;
/// Most and least twigs, against what their parameters say.
const TWIGS: (f32, f32) = (0.02, 4.0);
/// Twigs are at least this share of the usual distance between the traces' ends long.
const REACH: f32 = 0.8;
/// Twigs are made longer by at most this factor.
const LONGEST: f32 = 4.0;
/// Twigs may reach into pixels whose matte is this share of [`FinishParams::empty`]: leaves hide their tips.
const TWIG_SHARE: f32 = 0.5;
/// Where a twig begins, its host's node is at most this share of its length away.
const NODE_SHARE: f32 = 0.15;

/// What growing the crown did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CrownReport {
    /// Nodes of twigs.
    pub n_twig_nodes: u64,
    /// Nodes of twigs cut off because they reached where an image is empty.
    pub n_twig_nodes_cut: u64,
    /// Leaves (blades) that stayed.
    pub n_leaves: u64,
    /// Leaves discarded because an image is empty there.
    pub n_leaves_discarded: u64,
    /// Leaves the images ask for, as far as the last correction knows.
    pub leaves_asked: f64,
}

/// Grows twigs and leaves on `wood`, whose density and views they follow; `height` is the tree's in metres.
///
/// # Errors
/// As [`grow_twigs`](crate::foliage::grow_twigs) and [`grow_leaves`].
///
/// # Complexity
/// O((nodes + leaves + voxels) × corrections).
pub fn grow_crown(
    wood: &Skeleton,
    density: &Grid,
    views: &[View],
    height: f32,
    params: &FinishParams,
    seed: Seed,
    control: &Control,
) -> Result<(Tree, CrownReport)> {
    params.validate()?;
    let sights: Vec<Sight<'_>> = views.par_iter().map(|view| Sight::new(view, height)).collect();
    let crown = Crown { density, sights, params, seed, control };
    let mut report = CrownReport::default();
    let mut demand = match &params.leaves {
        Some(leaves) => {
            let area = params.blade * leaves.size * leaves.size;
            Some(Demand::new(density, area, params.fullness, &control.limits)?)
        }
        None => None,
    };
    let mut skeleton = wood.clone();
    if let Some(twigs) = &params.twigs {
        control.report("twigs", 0.1)?;
        skeleton = crown.twigs(wood, twigs, demand.as_ref(), &mut report)?;
    }
    let mut foliage = Foliage::default();
    if let (Some(leaves), Some(demand)) = (&params.leaves, &mut demand) {
        control.report("leaves", 0.4)?;
        foliage = crown.leaves(&skeleton, leaves, demand, &mut report)?;
    }
    let tree = Tree::new(skeleton, foliage, params.species.clone())?;
    control.report("done", 1.0)?;
    Ok((tree, report))
}

struct Crown<'a> {
    density: &'a Grid,
    sights: Vec<Sight<'a>>,
    params: &'a FinishParams,
    seed: Seed,
    control: &'a Control,
}

impl Crown<'_> {
    /// Grows twigs, so many that leaves have enough places, and cuts off what reaches out of the images.
    fn twigs(
        &self,
        wood: &Skeleton,
        twigs: &TwigParams,
        demand: Option<&Demand>,
        report: &mut CrownReport,
    ) -> Result<Skeleton> {
        let Self { density, params, seed, control, .. } = self;
        let twigs = &self.reaching(wood, twigs);
        let wood = refine(wood, twigs.bearing, NODE_SHARE * twigs.length, control)?.skeleton;
        let grow = |share: f32| {
            let wanted = |point| if density.sample(point) > 0.0 { share } else { 0.0 };
            grow_twigs_in(&wood, twigs, &wanted, seed.stream("twigs"), control)
        };
        let mut grown = grow(1.0)?.skeleton;
        if let (Some(demand), Some(leaves)) = (demand, &params.leaves) {
            let places = grow_leaves(&grown, leaves, seed.stream("leaves"), control)?.len();
            let share = SPARE * (demand.total() as f32) / (places as f32).max(1.0);
            if !(0.8..1.25).contains(&share) {
                grown = grow(share.clamp(TWIGS.0, TWIGS.1))?.skeleton;
            }
        }
        let cut = self.cut(&grown, wood.len())?;
        report.n_twig_nodes = (cut.len() - wood.len()) as u64;
        report.n_twig_nodes_cut = (grown.len() - cut.len()) as u64;
        Ok(cut)
    }

    /// Twigs long enough to fill the space between the ends of the traces: real trees have one or two more
    /// orders of branches there.
    fn reaching(&self, wood: &Skeleton, twigs: &TwigParams) -> TwigParams {
        let dense = self.density.values().iter().filter(|&&value| value > 0.0).count() as f32;
        let voxel = self.density.voxel();
        let n_tips = wood.children().starts().windows(2).filter(|run| run[0] == run[1]).count();
        let gap = voxel * libm::cbrtf(dense / n_tips.max(1) as f32);
        let longer = (REACH * gap / twigs.length).clamp(1.0, LONGEST);
        let mut twigs = twigs.clone();
        twigs.length = (twigs.length * longer).min(1e6);
        twigs.bearing = (twigs.bearing * longer).min(1e6);
        twigs.internode = (twigs.internode * longer.sqrt()).min(1e6);
        twigs.per_metre = (twigs.per_metre / longer).max(1e-3);
        twigs.stiffness = (twigs.stiffness * longer * longer).min(1e6);
        twigs
    }

    /// Cuts twigs off where they reach into an empty part of an image; the first `n_wood` nodes stay.
    fn cut(&self, skeleton: &Skeleton, n_wood: usize) -> Result<Skeleton> {
        let least = TWIG_SHARE * self.params.empty;
        let stays = |node: usize| {
            let point = skeleton.positions()[node];
            node < n_wood
                || self.sights.iter().all(|s| s.around(point).is_none_or(|alpha| alpha >= least))
        };
        let stays: Vec<bool> = (0..skeleton.len()).into_par_iter().map(stays).collect();
        let mut rows = vec![NO_PARENT; skeleton.len()];
        let mut columns =
            SkeletonColumns { positions: Vec::new(), radii: Vec::new(), parents: Vec::new() };
        for (node, &stays) in stays.iter().enumerate() {
            let parent = skeleton.parent(node as u32).map(|parent| rows[parent as usize]);
            if !stays || parent == Some(NO_PARENT) {
                continue;
            }
            rows[node] = columns.positions.len() as u32;
            columns.positions.push(skeleton.positions()[node]);
            columns.radii.push(skeleton.radii()[node]);
            columns.parents.push(parent.unwrap_or(NO_PARENT));
        }
        Ok(Skeleton::try_from(columns)?)
    }

    fn leaves(
        &self,
        skeleton: &Skeleton,
        leaves: &LeafParams,
        demand: &mut Demand,
        report: &mut CrownReport,
    ) -> Result<Foliage> {
        let Self { params, seed, control, .. } = self;
        let seed = seed.stream("leaves");
        let places = grow_leaves(skeleton, leaves, seed, control)?;
        let mut kept = Foliage::default();
        for round in 0..=params.corrections {
            let share = round as f32 / (params.corrections + 1) as f32;
            control.report("leaves", 0.5 + 0.5 * share)?;
            demand.spread_over(places.positions().iter().copied());
            let grown =
                grow_leaves_in(skeleton, leaves, &|point| demand.at(point), seed, control)?.foliage;
            kept = self.discard(&grown)?;
            report.n_leaves = kept.len() as u64;
            report.n_leaves_discarded = (grown.len() - kept.len()) as u64;
            report.leaves_asked = demand.total();
            if round < params.corrections {
                demand.correct(&self.sights, &kept, params.blade, params.fullness);
            }
        }
        Ok(kept)
    }

    /// Discards leaves that fall on empty parts of an image (section 5.4.1).
    fn discard(&self, foliage: &Foliage) -> Result<Foliage> {
        let rows: Vec<_> = foliage.iter().collect();
        let stays: Vec<bool> = rows
            .par_iter()
            .with_min_len(1024)
            .map(|leaf| {
                self.sights
                    .iter()
                    .all(|s| s.under(leaf).is_none_or(|alpha| alpha >= self.params.empty))
            })
            .collect();
        let mut kept = Foliage::with_capacity(rows.len());
        for (leaf, _) in rows.into_iter().zip(stays).filter(|&(_, stays)| stays) {
            kept.push(leaf)?;
        }
        Ok(kept)
    }
}
