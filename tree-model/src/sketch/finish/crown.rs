//! Twigs and leaves.

use super::params::FinishParams;
use super::spread::Cells;
use crate::error::Result;
use crate::foliage::{DENSITY_CAP, LeafParams, TwigParams, grow_leaves_in, grow_twigs_in, refine};
use crate::sketch::crown::Crown;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{
    Continuation, Control, Foliage, Leaf, NO_PARENT, Seed, Skeleton, SkeletonColumns, Tree,
};

/// Area of all leaves against that of the crown as seen: seen from one side, half of what stands face on hides the
/// other half, and some sky shines through.
const LEAF_AREA: f32 = 4.0;
/// Fewest and most leaves (sprays) of a tree in full leaf: fewer look bald, more no renderer bears. Beyond, leaves
/// are made larger by at most [`LARGER`].
const LEAVES: [f32; 2] = [600.0, 18_000.0];
/// Most blades: a compound leaf has many.
const MOST_BLADES: f32 = 120_000.0;
/// Leaves are made larger by at most this factor where there are no more of them.
const LARGER: f32 = 2.5;
/// Places for leaves that shoots are to offer, against leaves asked for: some are crowded, some outside the crown.
const SPARE: f32 = 1.5;
/// Twigs for each tip of a branch, at least: without, branches end bluntly.
const TIP_TWIGS: f32 = 0.5;
/// Twigs for each tip of a bare tree.
const BARE_TWIGS: f32 = 3.0;
/// Most nodes of all twigs, about.
const MOST_TWIG_NODES: f32 = 30_000.0;
/// Most internodes of a main twig: they are millimetres thick.
const INTERNODES: f32 = 7.0;
/// Twigs are at least this share of the usual distance between tips long.
const REACH: f32 = 0.8;
/// Twigs are made longer by at most this factor.
const LONGEST: f32 = 4.0;
/// Shoots within this share of the tree's size from a tip say where the crown is.
const OUTER: f32 = 0.15;
/// Where a twig begins, its host's node is at most this share of its length away.
const NODE_SHARE: f32 = 0.2;
/// Length of a twig with its laterals, in lengths of the longest, on average.
const TWIG_SHOOT: f32 = 1.3;

/// What the finish did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FinishReport {
    /// Nodes of branches.
    pub n_wood_nodes: u64,
    /// Nodes of twigs.
    pub n_twig_nodes: u64,
    /// Nodes of twigs cut off because they left the crown or entered the ground.
    pub n_twig_nodes_cut: u64,
    /// Blades that stayed: rows of the foliage.
    pub n_leaves: u64,
    /// Blades left out because they left the crown or entered the ground.
    pub n_leaves_outside: u64,
    /// How much larger leaves are than the species', because there would be too many.
    pub leaves_larger: f32,
}

/// Grows twigs and leaves of a species on `wood`; inside `crown`, where one is drawn, but for half a leaf.
///
/// # Errors
/// As [`FinishParams::validate`], [`grow_twigs`](crate::foliage::grow_twigs) and
/// [`grow_leaves`](crate::foliage::grow_leaves).
///
/// # Complexity
/// O(nodes + leaves).
pub fn grow_crown(
    wood: &Skeleton,
    crown: Option<&Crown>,
    params: &FinishParams,
    seed: Seed,
    control: &Control,
) -> Result<(Tree, FinishReport)> {
    params.validate()?;
    let fronds = if params.has_fronds() { frond_length(wood) } else { None };
    let sprays = params.sprays(fronds)?;
    let mut report =
        FinishReport { n_wood_nodes: wood.len() as u64, leaves_larger: 1.0, ..Default::default() };
    let shoots = Shoots::of(wood);
    let leaves = sprays.leaves.filter(|_| params.fullness > 0.0);
    let leaves = leaves.map(|leaves| {
        let leaves = shoots.demand(leaves, sprays.blade, params.fullness);
        report.leaves_larger = leaves.1.larger;
        leaves
    });
    let ground = wood.positions()[0].y;
    let finisher = Finisher { crown, ground, seed, control };
    let mut skeleton = wood.clone();
    if let Some(twigs) = &sprays.twigs {
        control.report("twigs", 0.1)?;
        skeleton = finisher.twigs(wood, &shoots, twigs, leaves.as_ref(), &mut report)?;
    }
    let mut foliage = Foliage::default();
    if let Some((leaves, demand)) = &leaves {
        control.report("leaves", 0.4)?;
        foliage = finisher.leaves(&skeleton, leaves, demand.leaves, &mut report)?;
    }
    let tree = Tree::new(skeleton, foliage, sprays.species)?;
    control.report("done", 1.0)?;
    Ok((tree, report))
}

/// Length of a palm's longest frond: of its lateral axes; `None` where there is none. Short ones bear leaflets all along,
/// long ones too.
fn frond_length(wood: &Skeleton) -> Option<f32> {
    let axes = wood.axes(Continuation::Thickest);
    let lengths = wood.segment_lengths();
    let length = |nodes: &[u32]| nodes.iter().map(|&node| lengths[node as usize]).sum::<f32>();
    let all = axes.iter().skip(1).map(|axis| length(axis.nodes));
    all.reduce(f32::max).filter(|&length| length > 0.0)
}

/// How many leaves are wanted.
struct Demand {
    leaves: f32,
    larger: f32,
}

/// What there is for twigs and leaves to stand on.
struct Shoots<'a> {
    skeleton: &'a Skeleton,
    to_tip: Vec<f32>,
    n_tips: f32,
    /// Where the crown is.
    cells: Cells,
}

impl<'a> Shoots<'a> {
    fn of(skeleton: &'a Skeleton) -> Self {
        let to_tip = skeleton.distances_to_tip();
        let outer = OUTER * skeleton.bounds().size().max_element();
        let mut cells = Cells::about(skeleton);
        let nodes = skeleton.positions().iter().zip(&to_tip).filter(|&(_, &way)| way <= outer);
        cells.count(nodes.map(|(&point, _)| point));
        let n_tips = skeleton.children().starts().windows(2).filter(|run| run[0] == run[1]).count();
        Self { skeleton, to_tip, n_tips: n_tips.max(1) as f32, cells }
    }

    /// Length of shoots within `bearing` of a tip.
    fn length(&self, bearing: f32) -> f32 {
        let lengths = self.skeleton.segment_lengths();
        let part = |(&length, &way): (&f32, &f32)| length.min((bearing - way).max(0.0));
        lengths.iter().zip(&self.to_tip).map(part).sum()
    }

    /// As many leaves as cover the crown; larger ones where they would be too many.
    fn demand(&self, mut leaves: LeafParams, blade: f32, fullness: f32) -> (LeafParams, Demand) {
        let n_blades = leaves.form.n_leaflets() as f32;
        let area = n_blades * blade * leaves.size * leaves.size;
        let wanted = fullness * LEAF_AREA * self.cells.area() / area.max(f32::MIN_POSITIVE);
        let most = (fullness * LEAVES[1]).min(MOST_BLADES / n_blades);
        let larger = (wanted / most).sqrt().clamp(1.0, LARGER);
        leaves.size = (leaves.size * larger).min(1e6);
        let wanted = (wanted / (larger * larger)).max(fullness * LEAVES[0] / n_blades.sqrt());
        (leaves, Demand { leaves: wanted.min(most), larger })
    }

    /// Twigs long enough to fill the space between tips, and so many to each place that there are about `wanted`.
    fn reaching(&self, twigs: &TwigParams) -> TwigParams {
        let gap = libm::cbrtf(self.cells.volume() / self.n_tips);
        let longer = (REACH * gap / twigs.length).clamp(1.0, LONGEST);
        let mut twigs = twigs.clone();
        twigs.length = (twigs.length * longer).min(1e6);
        twigs.bearing = (twigs.bearing * longer).min(1e6);
        twigs.internode = (twigs.internode * longer.sqrt()).max(twigs.length / INTERNODES).min(1e6);
        twigs.per_metre = (twigs.per_metre / longer).max(1e-3);
        twigs.stiffness = (twigs.stiffness * longer * longer).min(1e6);
        twigs
    }

    /// How many twigs to grow.
    fn n_twigs(&self, twigs: &TwigParams, leaves: Option<&(LeafParams, Demand)>) -> f32 {
        let laterals = (twigs.levels - 1) as f32 * twigs.per_metre * twigs.length * twigs.lateral;
        let each = (1.0 + laterals) * (twigs.length / twigs.internode).max(1.0);
        let most = MOST_TWIG_NODES / each;
        let Some((leaves, demand)) = leaves else {
            return (BARE_TWIGS * self.n_tips).min(most);
        };
        let places = |shoot: f32| leaves.arrangement.per_node() as f32 * shoot / leaves.spacing;
        let there = places(self.length(leaves.bearing)) + self.n_tips;
        let each = places(TWIG_SHOOT * twigs.length).max(1.0);
        let missing = (SPARE * demand.leaves - there) / each;
        missing.clamp((TIP_TWIGS * self.n_tips).min(most), most)
    }
}

/// Counts places for leaves without growing any: in proportion to the length of shoots that bear them.
fn places(skeleton: &Skeleton, leaves: &LeafParams) -> Cells {
    let mut cells = Cells::about(skeleton);
    let (positions, children) = (skeleton.positions(), skeleton.children());
    let to_tip = skeleton.distances_to_tip();
    let each = leaves.arrangement.per_node() as f32 / leaves.spacing;
    for (below, node) in skeleton.segments() {
        let [a, b] = [below, node].map(|node| positions[node as usize]);
        let bearing = a.distance(b).min((leaves.bearing - to_tip[node as usize]).max(0.0));
        let tip = if children.is_tip(node) && leaves.terminal { 1.0 } else { 0.0 };
        cells.add(b.lerp(a, 0.5), each * bearing + tip);
    }
    cells
}

struct Finisher<'a> {
    crown: Option<&'a Crown>,
    ground: f32,
    seed: Seed,
    control: &'a Control,
}

impl Finisher<'_> {
    /// Whether something may be here: in the crown and above the ground.
    fn may_be(&self, point: Vec3) -> bool {
        point.y >= self.ground && self.crown.is_none_or(|crown| crown.contains_3d(point))
    }

    /// Grows twigs, and cuts off what leaves the crown.
    fn twigs(
        &self,
        wood: &Skeleton,
        shoots: &Shoots<'_>,
        twigs: &TwigParams,
        leaves: Option<&(LeafParams, Demand)>,
        report: &mut FinishReport,
    ) -> Result<Skeleton> {
        let twigs = shoots.reaching(twigs);
        let sites =
            twigs.arrangement.per_node() as f32 * twigs.per_metre * shoots.length(twigs.bearing)
                + shoots.n_tips;
        let density = shoots.n_twigs(&twigs, leaves) / sites.max(1.0);
        let wood = refine(wood, twigs.bearing, NODE_SHARE * twigs.length, self.control)?.skeleton;
        let seed = self.seed.stream("twigs");
        let grown = grow_twigs_in(&wood, &twigs, &|_| density, seed, self.control)?.skeleton;
        let cut = self.cut(&grown, wood.len())?;
        report.n_twig_nodes = (cut.len() - wood.len()) as u64;
        report.n_twig_nodes_cut = (grown.len() - cut.len()) as u64;
        Ok(cut)
    }

    /// Cuts twigs off where they leave the crown or enter the ground; the first `n_wood` nodes stay.
    fn cut(&self, skeleton: &Skeleton, n_wood: usize) -> Result<Skeleton> {
        let positions = skeleton.positions();
        let inside: Vec<bool> = positions[n_wood..]
            .par_iter()
            .with_min_len(1024)
            .map(|&point| self.may_be(point))
            .collect();
        let mut rows = vec![NO_PARENT; skeleton.len()];
        let mut columns = SkeletonColumns::default();
        for node in 0..skeleton.len() {
            let parent = skeleton.parent(node as u32).map(|parent| rows[parent as usize]);
            if (node >= n_wood && !inside[node - n_wood]) || parent == Some(NO_PARENT) {
                continue;
            }
            rows[node] = columns.positions.len() as u32;
            columns.positions.push(positions[node]);
            columns.radii.push(skeleton.radii()[node]);
            columns.parents.push(parent.unwrap_or(NO_PARENT));
        }
        Ok(Skeleton::try_from(columns)?)
    }

    /// Grows about `wanted` leaves, and leaves out those outside the crown or in the ground.
    fn leaves(
        &self,
        skeleton: &Skeleton,
        leaves: &LeafParams,
        wanted: f32,
        report: &mut FinishReport,
    ) -> Result<Foliage> {
        let (seed, control) = (self.seed.stream("leaves"), self.control);
        let cells = places(skeleton, leaves);
        let cells = cells.spread(wanted, DENSITY_CAP);
        let grown =
            grow_leaves_in(skeleton, leaves, &|point| cells.at(point), seed, control)?.foliage;
        let kept = self.inside(&grown)?;
        report.n_leaves = kept.len() as u64;
        report.n_leaves_outside = (grown.len() - kept.len()) as u64;
        Ok(kept)
    }

    fn inside(&self, foliage: &Foliage) -> Result<Foliage> {
        let rows: Vec<Leaf> = foliage.iter().collect();
        let stays = |leaf: &Leaf| {
            let middle = leaf.position + leaf.rotation * Vec3::Y * (0.5 * leaf.size);
            self.may_be(leaf.position) && self.may_be(middle)
        };
        let stays: Vec<bool> = rows.par_iter().with_min_len(1024).map(stays).collect();
        let mut kept = Foliage::with_capacity(rows.len());
        for (leaf, _) in rows.into_iter().zip(stays).filter(|&(_, stays)| stays) {
            kept.push(leaf)?;
        }
        Ok(kept)
    }
}
