//! What an adaptation needs of a tree, in columns sorted by season: nodes, clusters of every season, and what ties them.

use super::age::Ages;
use super::light::{Ball, Bins, Light};
use super::lobe::Lobes;
use super::params::PlasticParams;
use super::prune;
use super::shade::Casters;
use super::tropism::{Tropisms, unbend};
use glam::Vec3;
use std::ops::Range;
use tree_core::{Continuation, NO_PARENT, Skeleton};

/// One season of a tree's life.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Season {
    /// Nodes that grow in it.
    pub nodes: Range<usize>,
    /// Clusters there are in it.
    pub clusters: Range<usize>,
    /// How far a node of it can be from the older wood it stands on, in metres.
    pub stretch: f32,
}

/// A leaf cluster in one season.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cluster {
    pub ball: Ball,
    pub members: Range<usize>,
    /// What it gets where nothing but the tree itself is in the way.
    pub light: Light,
}

/// A tip of its season that a cluster is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Member {
    pub tip: u32,
    /// The nearest node below that stood before this season, or the tip itself where it did.
    pub carrier: u32,
    /// From carrier to tip.
    pub offset: Vec3,
}

/// All of it. Node columns are sorted by season, parents first; the root is 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Plan {
    /// Main node of each row.
    pub main: Vec<u32>,
    pub parent: Vec<u32>,
    pub position: Vec<Vec3>,
    /// From the parent; zero for the root.
    pub segment: Vec<Vec3>,
    /// Of the segment, unit.
    pub direction: Vec<Vec3>,
    pub length: Vec<f32>,
    /// The direction without tropisms, as [`unbend`] gives it.
    pub own: Vec<Vec3>,
    pub weight: Vec<f32>,
    /// The cluster whose light bends it, an index into `clusters`.
    pub lit_by: Vec<u32>,
    /// Least light per length on which the branch that starts here is known to have lived; below 0 for what is never pruned.
    pub starved: Vec<f32>,
    pub seasons: Vec<Season>,
    pub clusters: Vec<Cluster>,
    pub members: Vec<Member>,
    /// Piece of the crown each row belongs to.
    pub piece: Vec<u32>,
    /// Cluster of the last season of each piece; `u32::MAX` for none.
    pub last_cluster: Vec<u32>,
    pub tropisms: Tropisms,
}

impl Plan {
    pub(super) fn new(
        branches: &Skeleton,
        ages: &Ages,
        lobes: &Lobes,
        params: &PlasticParams,
    ) -> Self {
        let mut plan = Self::sorted(branches, ages, lobes);
        plan.form_clusters(branches, ages, lobes, params);
        let bins = Bins::new(params.sky.light.normalize(), Vec3::Y, params.sky.brightness);
        plan.light_up(&bins);
        plan.unbend_all(ages, params);
        let trunk = branches.axes(Continuation::Longest);
        prune::estimate(&mut plan, |main| trunk.order_of(main) == Some(0));
        plan
    }

    pub(super) fn len(&self) -> usize {
        self.parent.len()
    }

    fn sorted(branches: &Skeleton, ages: &Ages, lobes: &Lobes) -> Self {
        let n = branches.len();
        let mut main: Vec<u32> = (0..n as u32).collect();
        main.sort_by_key(|&node| ages.season[node as usize]);
        let mut row_of = vec![0_u32; n];
        for (row, &node) in main.iter().enumerate() {
            row_of[node as usize] = row as u32;
        }
        let mut plan = Self::default();
        let mut start = 0;
        for season in 0..ages.n_seasons {
            let end = main.partition_point(|&node| u32::from(ages.season[node as usize]) <= season);
            plan.seasons.push(Season { nodes: start..end, clusters: 0..0, stretch: 0.0 });
            start = end;
        }
        let positions = branches.positions();
        let mut straight = vec![Vec3::Y; n];
        for &node in &main {
            let i = node as usize;
            let below = branches.parents()[i];
            let (segment, along) = if below == NO_PARENT {
                (Vec3::ZERO, Vec3::Y)
            } else {
                let segment = positions[i] - positions[below as usize];
                // A segment without length goes on as its parent does.
                (segment, segment.try_normalize().unwrap_or(straight[below as usize]))
            };
            straight[i] = along;
            plan.parent.push(if below == NO_PARENT { 0 } else { row_of[below as usize] });
            plan.position.push(positions[i]);
            plan.segment.push(segment);
            plan.direction.push(along);
            plan.length.push(segment.length());
            plan.piece.push(lobes.piece[i]);
        }
        plan.main = main;
        plan.stretch();
        plan
    }

    fn stretch(&mut self) {
        let mut way = vec![0.0_f32; self.len()];
        for season in &mut self.seasons {
            let start = season.nodes.start;
            for row in season.nodes.clone() {
                let below = self.parent[row] as usize;
                let before = if below >= start { way[below] } else { 0.0 };
                way[row] = before + self.length[row];
                season.stretch = season.stretch.max(way[row]);
            }
        }
    }

    fn form_clusters(
        &mut self,
        branches: &Skeleton,
        ages: &Ages,
        lobes: &Lobes,
        params: &PlasticParams,
    ) {
        let n = self.len();
        let owned = self.owned_volumes(branches, lobes);
        let mut n_children = vec![0_u32; n];
        self.lit_by = vec![0; n];
        let mut slot = vec![u32::MAX; lobes.n_pieces as usize];
        self.last_cluster = slot.clone();
        for t in 0..self.seasons.len() {
            let nodes = self.seasons[t].nodes.clone();
            for row in nodes.clone().filter(|&row| row > 0) {
                n_children[self.parent[row] as usize] += 1;
            }
            let tips: Vec<u32> =
                (0..nodes.end as u32).filter(|&row| n_children[row as usize] == 0).collect();
            let first = self.clusters.len();
            self.gather_season(&tips, nodes.start, &owned, params, &mut slot);
            self.seasons[t].clusters = first..self.clusters.len();
            // Tips of earlier seasons keep the light they grew in.
            for &tip in tips.iter().filter(|&&tip| tip as usize >= nodes.start) {
                self.lit_by[tip as usize] = slot[self.piece[tip as usize] as usize];
            }
            // What is no tip has a child of the same season, which comes later in the row.
            for row in nodes.clone().rev().filter(|&row| row > 0) {
                let below = self.parent[row] as usize;
                if below >= nodes.start {
                    self.lit_by[below] = self.lit_by[row];
                }
            }
            if t + 1 == self.seasons.len() {
                for &tip in &tips {
                    let piece = self.piece[tip as usize] as usize;
                    self.last_cluster[piece] = slot[piece];
                }
            }
            for &tip in &tips {
                slot[self.piece[tip as usize] as usize] = u32::MAX;
            }
        }
        debug_assert_eq!(ages.season.len(), n);
    }

    /// Cubed radius that each row owns in a season in which it is a tip (Eq. 5): the volumes of the tips above, each scaled by the
    /// cube of how much nearer to the root this row is. Applied season after season the factors multiply to that of first
    /// and last, so one sum does it.
    fn owned_volumes(&self, branches: &Skeleton, lobes: &Lobes) -> Vec<f32> {
        let to_root = branches.distances_to_root();
        let cube = |row: usize| {
            let d = f64::from(to_root[self.main[row] as usize]);
            d * d * d
        };
        let mut sums = vec![0.0_f64; self.len()];
        for row in (0..self.len()).rev() {
            let volume = f64::from(lobes.volume[self.main[row] as usize]);
            if volume > 0.0 && cube(row) > 0.0 {
                sums[row] += volume / cube(row);
            }
            if row > 0 {
                sums[self.parent[row] as usize] += sums[row];
            }
        }
        (0..self.len()).map(|row| (sums[row] * cube(row)) as f32).collect()
    }

    fn gather_season(
        &mut self,
        tips: &[u32],
        start: usize,
        owned: &[f32],
        params: &PlasticParams,
        slot: &mut [u32],
    ) {
        let mut of_piece: Vec<(u32, u32)> =
            tips.iter().map(|&tip| (self.piece[tip as usize], tip)).collect();
        of_piece.sort_unstable();
        for group in of_piece.chunk_by(|a, b| a.0 == b.0) {
            let first = self.members.len();
            let (mut sum, mut cubed) = (Vec3::ZERO, 0.0_f32);
            for &(_, tip) in group {
                let at = self.position[tip as usize];
                let mut carrier = tip;
                while carrier as usize >= start && carrier > 0 {
                    carrier = self.parent[carrier as usize];
                }
                let offset = at - self.position[carrier as usize];
                self.members.push(Member { tip, carrier, offset });
                sum += at;
                cubed += owned[tip as usize];
            }
            let radius = libm::cbrtf(cubed);
            slot[group[0].0 as usize] = self.clusters.len() as u32;
            self.clusters.push(Cluster {
                ball: Ball {
                    center: sum / group.len() as f32,
                    radius,
                    translucency: libm::powf(params.translucency, radius),
                },
                members: first..self.members.len(),
                light: Light::default(),
            });
        }
    }

    fn light_up(&mut self, bins: &Bins) {
        let mut casters = Casters::default();
        for season in &self.seasons {
            casters.clear();
            let clusters = &mut self.clusters[season.clusters.clone()];
            clusters.iter().for_each(|cluster| casters.push(&cluster.ball));
            for (place, cluster) in clusters.iter_mut().enumerate() {
                let through = casters.through(cluster.ball.center, place, bins);
                cluster.light = Light::gather(bins, &through);
            }
        }
    }

    fn unbend_all(&mut self, ages: &Ages, params: &PlasticParams) {
        let tropisms = Tropisms { photo: params.phototropism, gravi: params.gravitropism };
        self.tropisms = tropisms;
        for row in 0..self.len() {
            let light = self.clusters[self.lit_by[row] as usize].light.direction;
            let weight = tropisms.own_weight(self.length[row], ages.internode);
            let tropism = tropisms.combined(light, Vec3::Y);
            self.weight.push(weight);
            self.own.push(unbend(self.direction[row], weight, tropism));
        }
    }
}
