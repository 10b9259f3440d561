//! Step 4 of Xu & Mould's algorithm: every endpoint becomes the root of a smaller graph, level by
//! level; then smoothing, radii and leaves.

use super::draft::{Draft, join_roots};
use super::graph::Terrain;
use super::nursery::Nursery;
use super::params::PathParams;
use super::shoot::{GraphStats, Plot, Shoot, Workspace};
use super::smooth::smooth;
use crate::error::{ModelError, Result};
use crate::foliage;
use rayon::prelude::*;
use std::ops::Range;
use tree_core::allometry::RadiusRule;
use tree_core::{Control, Foliage, Resource, Seed, Skeleton, Tree};

/// A tree and how it came about.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PathTree {
    /// The tree.
    pub tree: Tree,
    /// Level (from 1) that each skeleton node was grown at; 0 for nodes of the root system.
    pub levels: Vec<u8>,
    /// What was done and what was left out.
    pub report: PathReport,
}

/// What growing a tree took, and what it left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PathReport {
    /// One entry a level, the first for the base volume.
    pub levels: Vec<LevelReport>,
    /// The root system's levels.
    pub roots: Vec<LevelReport>,
}

/// What one level took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LevelReport {
    /// Graphs, their nodes and arcs.
    pub graphs: GraphStats,
    /// Endpoints reached.
    pub n_endpoints: u64,
    /// Random endpoints asked for that the graphs had no nodes for.
    pub n_missing: u64,
    /// Endpoints of the levels before from which nothing grew, because an obstacle left no room or
    /// a narrow subgraph did not hang together.
    pub n_stunted: u64,
    /// Endpoints of the level before whose lifespan had ended.
    pub n_ended: u64,
}

impl PathReport {
    /// All graphs of all levels, roots included.
    #[must_use]
    pub fn graphs(&self) -> GraphStats {
        self.levels.iter().chain(&self.roots).fold(GraphStats::default(), |mut sum, level| {
            sum.add(level.graphs);
            sum
        })
    }

    /// All endpoints of all levels, roots included.
    #[must_use]
    pub fn endpoints(&self) -> u64 {
        self.levels.iter().chain(&self.roots).map(|level| level.n_endpoints).sum()
    }
}

impl PathParams {
    /// Grows the tree. The same seed gives the same bits for any number of threads.
    ///
    /// # Errors
    /// What [`PathParams::validate`] finds; [`ModelError::EmptyVolume`],
    /// [`ModelError::RootOutside`], [`ModelError::RootBlocked`],
    /// [`ModelError::EndpointUnreachable`], [`ModelError::Cost`]; [`ModelError::Limit`] before the
    /// level that would exceed a limit; [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// O(nodes of all graphs) time; memory for the largest graph of each thread, about 200 bytes a
    /// node, and the skeleton.
    pub fn grow(&self, seed: Seed, control: &Control) -> Result<PathTree> {
        self.validate()?;
        control.report("level 1", 0.0)?;
        let mut budget = Budget::default();
        let crown_share = if self.roots.is_some() { 0.0..0.6 } else { 0.0..0.8 };
        let (mut skeleton, mut levels, crown) =
            self.grow_part(seed, crown_share, &mut budget, control)?;
        let mut report = PathReport { levels: crown, ..Default::default() };
        control.report("leaves", 0.8)?;
        let leaves = match &self.leaves {
            Some(leaves) => {
                foliage::grow_leaves(&skeleton, leaves, seed.stream("leaves"), control)?
            }
            None => Foliage::default(),
        };
        if let Some(roots) = &self.roots {
            let (seed, share) = (seed.stream("roots"), 0.85..1.0);
            let (below, _, levels_below) =
                self.root_params(roots).grow_part(seed, share, &mut budget, control)?;
            // Roots come after all other nodes, so that the leaves' nodes stay right.
            skeleton = join_roots(&skeleton, &below)?;
            levels.resize(skeleton.len(), 0);
            report.roots = levels_below;
        }
        let tree = Tree::new(skeleton, leaves, self.species.clone())?;
        control.report("done", 1.0)?;
        Ok(PathTree { tree, levels, report })
    }

    /// Grows the branches of all levels: the skeleton, the level of each node, and a report.
    /// `share` is this part's share of the whole progress.
    fn grow_part(
        &self,
        seed: Seed,
        share: Range<f32>,
        budget: &mut Budget,
        control: &Control,
    ) -> Result<(Skeleton, Vec<u8>, Vec<LevelReport>)> {
        let obstacle = self.obstacle.as_ref();
        let terrain = self.terrain();
        let mut draft = Draft::default();
        let n_levels = self.levels.len() as f32 + 1.0;
        let mut reports = Vec::with_capacity(self.levels.len() + 1);
        budget.ask(1, self.graph_nodes, &draft, control)?;
        reports.push(self.grow_base(seed, &terrain, &mut draft, control)?);
        budget.spend(&reports[0]);
        for i in 0..self.levels.len() {
            let done = (i as f32 + 1.0) / n_levels;
            let fraction = share.start + (share.end - share.start) * done;
            control.report(LEVEL_NAMES[i.min(LEVEL_NAMES.len() - 1)], fraction)?;
            let report = self.grow_level(i, seed, &terrain, &mut draft, budget, control)?;
            budget.spend(&report);
            reports.push(report);
        }
        budget.close_part(&draft, control)?;
        let (mut skeleton, levels) = draft.finish()?;
        smooth(&mut skeleton, self.smoothing, obstacle, control)?;
        match &self.radii {
            // The paper's rule goes by level, which only the modeler knows.
            RadiusRule::TipDistance(rule) => {
                let levels: Vec<u32> = levels.iter().map(|&level| u32::from(level)).collect();
                rule.apply_at_levels(&mut skeleton, &levels)?;
            }
            rule => rule.apply(&mut skeleton)?,
        }
        Ok((skeleton, levels, reports))
    }

    fn grow_base(
        &self,
        seed: Seed,
        terrain: &Terrain<'_>,
        draft: &mut Draft,
        control: &Control,
    ) -> Result<LevelReport> {
        let bounds = self.volume.bounds();
        let plot = Plot {
            volume: &self.volume,
            root: self.root,
            graph_nodes: self.graph_nodes,
            random: self.endpoints.random,
            placed: &self.endpoints.placed,
            placing: self.endpoints.placing,
            candidates: self.endpoints.candidates,
            above: bounds.min.y + self.endpoints.above * bounds.size().y,
            linking: &self.linking,
            terrain,
        };
        let shoot = plot.grow(seed.stream("level 1"), &mut Workspace::default(), control)?;
        let (graphs, endpoints) = (shoot.stats, shoot.tips.len() as u64);
        let wanted = u64::from(self.endpoints.random) + self.endpoints.placed.len() as u64;
        draft.start(&shoot, self.levels.len() as u32);
        Ok(LevelReport {
            graphs,
            n_endpoints: endpoints,
            n_missing: wanted - endpoints,
            ..Default::default()
        })
    }

    fn grow_level(
        &self,
        i: usize,
        seed: Seed,
        terrain: &Terrain<'_>,
        draft: &mut Draft,
        budget: &Budget,
        control: &Control,
    ) -> Result<LevelReport> {
        let Some(level) = self.levels.get(i) else { return Ok(LevelReport::default()) };
        let size = self.level_size(i);
        let (from, ended) = draft.living_tips(level.from_all_levels);
        let mut report = LevelReport { n_ended: ended, ..Default::default() };
        budget.ask(from.len() as u64, level.graph_nodes, draft, control)?;
        let stream = seed.stream("levels").child(i as u64);
        let nursery = Nursery { level, size, linking: &self.linking, terrain, control };
        let shoots: Vec<Result<Shoot>> = from
            .par_iter()
            .enumerate()
            .map_init(Workspace::default, |workspace, (number, tip)| {
                control.check()?;
                nursery.grow(tip, stream.child(number as u64), workspace)
            })
            .collect();
        let mut tips = Vec::new();
        let mut why = None;
        for (number, (tip, shoot)) in from.iter().zip(shoots).enumerate() {
            let shoot = match shoot {
                Ok(shoot) => shoot,
                Err(error) if is_local(&error) => {
                    report.n_stunted += 1;
                    why.get_or_insert(error);
                    continue;
                }
                Err(error) => return Err(error),
            };
            report.graphs.add(shoot.stats);
            report.n_endpoints += shoot.tips.len() as u64;
            report.n_missing += u64::from(level.branching) - shoot.tips.len() as u64;
            let life = stream.stream("life").child(number as u64);
            draft.append(&shoot, tip, i as u8 + 2, &mut tips, |n| {
                self.lifespan.after(tip.life, life.child(u64::from(n)))
            });
        }
        if let (Some(error), true, None) = (why, tips.is_empty(), terrain.obstacle) {
            // Nothing grew at all and no obstacle is to blame: the level's shape is.
            return Err(ModelError::Level { index: i, source: Box::new(error) });
        }
        draft.close_level(tips);
        Ok(report)
    }
}

/// What all parts and levels of one model use together, held against the limits.
#[derive(Default)]
struct Budget {
    graph_nodes: u64,
    /// Skeleton nodes of the parts that are finished.
    nodes: u64,
}

impl Budget {
    /// Before a level: `n_graphs` of `graph_nodes` each, and at least one skeleton node for each.
    fn ask(&self, n_graphs: u64, graph_nodes: u32, draft: &Draft, control: &Control) -> Result<()> {
        let graph_nodes = self.graph_nodes + n_graphs * u64::from(graph_nodes);
        control.limits.check(Resource::GraphNodes, graph_nodes)?;
        let nodes = self.nodes + draft.positions.len() as u64 + n_graphs;
        control.limits.check(Resource::Nodes, nodes)?;
        Ok(())
    }

    fn spend(&mut self, report: &LevelReport) {
        self.graph_nodes += report.graphs.n_nodes;
    }

    fn close_part(&mut self, draft: &Draft, control: &Control) -> Result<()> {
        self.nodes += draft.positions.len() as u64;
        control.limits.check(Resource::Nodes, self.nodes)?;
        Ok(())
    }
}

/// Errors that end one branch and not the tree: its subgraph has no room, or does not hang together.
fn is_local(error: &ModelError) -> bool {
    matches!(
        error,
        ModelError::EmptyVolume { .. }
            | ModelError::RootOutside { .. }
            | ModelError::RootBlocked { .. }
            | ModelError::NoCandidates { .. }
    )
}

/// Stage names must live for ever; deeper levels share the last.
const LEVEL_NAMES: [&str; 8] =
    ["level 2", "level 3", "level 4", "level 5", "level 6", "level 7", "level 8", "level 9 and on"];
