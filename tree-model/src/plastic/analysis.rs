//! A tree, read so that it can react.

use super::age::{Ages, ages};
use super::light::{Ball, Light};
use super::lobe::Lobes;
use super::main_branches::Main;
use super::params::PlasticParams;
use super::plan::Plan;
use crate::error::Result;
use glam::Vec3;
use tree_core::{Aabb, Control, NO_PARENT, Resource, Skeleton, Tree};

/// A tree whose crown leans farther than this from above its base, in radians, was bent by something (Fig. 14).
const LEANING: f32 = 0.26;

/// Branchlets shorter than this share of an internode are buds: no cluster is smaller.
const LEAST_CLUSTER: f32 = 0.5;

/// A tree, read so that it can react: its main branches with ages, leaf clusters and their light in every season, directions
/// without tropisms, and the light each branch needs. Made once, and shared by any number of trees in scenes.
#[derive(Clone, Debug)]
pub struct PlasticTree {
    pub(super) tree: Tree,
    pub(super) plan: Plan,
    /// Row of the plan that carries each tree node: its own, or that of the main node below.
    pub(super) row_of: Vec<u32>,
    pub(super) is_main: Vec<bool>,
    /// Around the tree wherever it may bend.
    pub(super) around: Ball,
    /// Around the middles of its clusters, with some room for bending.
    pub(super) crown: Ball,
    params: PlasticParams,
    ages: Ages,
    report: PlasticReport,
}

/// What was found in a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct PlasticReport {
    /// Nodes of the main branches.
    pub n_main_nodes: u32,
    /// Nodes that follow them.
    pub n_branchlet_nodes: u32,
    /// Leaf clusters of the last season.
    pub n_clusters: u32,
    /// Seasons the tree lived.
    pub n_seasons: u32,
    /// Length of an internode in metres.
    pub internode: f32,
    /// How far the middle of the crown leans from above the base, in radians.
    pub lean: f32,
    /// Whether it leans so far that it cannot have grown alone in the open. The analysis takes a tree for one that did, and
    /// so this one keeps its lean whatever it reacts to (Fig. 14).
    pub already_bent: bool,
}

/// A leaf cluster in one season of the input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeafCluster {
    /// Where it is, how large, and how much light it lets through.
    pub ball: Ball,
    /// The light it gets in the open.
    pub light: Light,
    /// Tips it is made of.
    pub tips: u32,
}

impl PlasticTree {
    /// Analyses a tree, which should have grown alone in the open.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) names what is out of range; limits; cancellation.
    ///
    /// # Complexity
    /// O(n log n + nodes · seasons + seasons · clusters²), a few milliseconds for ten thousand nodes.
    pub fn new(tree: Tree, params: &PlasticParams, control: &Control) -> Result<Self> {
        params.validate()?;
        let skeleton = tree.skeleton();
        control.limits.check(Resource::Nodes, skeleton.len() as u64)?;
        control.report("main branches", 0.0)?;
        let main = Main::new(skeleton, params.main);
        let branches = branches(skeleton, &main)?;
        control.report("ages", 0.2)?;
        let ages = ages(&branches, params.internode, params.seasons);
        let reach = branches.distances_to_tip()[0];
        let least = LEAST_CLUSTER * ages.internode.min(reach.max(f32::MIN_POSITIVE));
        let lobes = Lobes::new(&tree, &main, &branches, params.lobe * reach, least);
        control.report("light and tropisms", 0.4)?;
        let plan = Plan::new(&branches, &ages, &lobes, params);
        let mut row_of_main = vec![0_u32; plan.len()];
        for (row, &node) in plan.main.iter().enumerate() {
            row_of_main[node as usize] = row as u32;
        }
        let row_of = main.of.iter().map(|&node| row_of_main[node as usize]).collect();
        let report = report(&tree, &plan, &ages);
        control.report("done", 1.0)?;
        let around = around(skeleton);
        let crown = crown(&plan);
        Ok(Self {
            plan,
            row_of,
            around,
            crown,
            is_main: main.is_main,
            params: *params,
            ages,
            report,
            tree,
        })
    }

    /// The tree as it came in.
    #[must_use]
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// How it was analysed.
    #[must_use]
    pub fn params(&self) -> &PlasticParams {
        &self.params
    }

    /// What was found.
    #[must_use]
    pub fn report(&self) -> &PlasticReport {
        &self.report
    }

    /// Whether each node of the tree belongs to the main branches.
    #[must_use]
    pub fn is_main(&self) -> &[bool] {
        &self.is_main
    }

    /// The season in which each node of the tree grew; that of the main branch for what follows it. O(nodes).
    #[must_use]
    pub fn seasons(&self) -> Vec<u16> {
        self.row_of
            .iter()
            .map(|&row| self.ages.season[self.plan.main[row as usize] as usize])
            .collect()
    }

    /// The leaf clusters of a season, 0 to `report().n_seasons - 1`; none for others.
    #[must_use]
    pub fn clusters(&self, season: u32) -> Vec<LeafCluster> {
        let Some(season) = self.plan.seasons.get(season as usize) else { return Vec::new() };
        self.plan.clusters[season.clusters.clone()]
            .iter()
            .map(|cluster| LeafCluster {
                ball: cluster.ball,
                light: cluster.light,
                tips: cluster.members.len() as u32,
            })
            .collect()
    }

    /// The direction each main segment would have grown in without tropisms, as [`unbend`](super::unbend) gives it; that of the
    /// main branch below for other nodes. O(nodes).
    #[must_use]
    pub fn own_directions(&self) -> Vec<Vec3> {
        self.row_of.iter().map(|&row| self.plan.own[row as usize]).collect()
    }

    /// Least light per metre on which the branch that starts at each node is known to live (ψ of Eq. 11 without its factor); `None`
    /// where no branch starts that could be pruned. O(nodes).
    #[must_use]
    pub fn pruning_factors(&self) -> Vec<Option<f32>> {
        self.row_of
            .iter()
            .zip(&self.is_main)
            .map(|(&row, &main)| {
                (main && self.plan.starved[row as usize] >= 0.0)
                    .then(|| self.plan.starved[row as usize])
            })
            .collect()
    }
}

/// The main branches as a skeleton of their own.
fn branches(skeleton: &Skeleton, main: &Main) -> Result<Skeleton> {
    let pick = |node: &u32| *node as usize;
    let positions = main.nodes.iter().map(|n| skeleton.positions()[pick(n)]).collect();
    let radii = main.nodes.iter().map(|n| skeleton.radii()[pick(n)]).collect();
    let parents = main
        .nodes
        .iter()
        .map(|n| match skeleton.parents()[pick(n)] {
            NO_PARENT => NO_PARENT,
            parent => main.of[parent as usize],
        })
        .collect();
    Ok(Skeleton::from_columns(positions, radii, parents)?)
}

/// A ball around the tree, with room for bending.
fn around(skeleton: &Skeleton) -> Ball {
    let bounds = skeleton.bounds();
    let radius = 0.75 * bounds.size().length();
    Ball { center: bounds.center(), radius, translucency: 0.0 }
}

/// A ball around the middles of all clusters, a fifth wider.
fn crown(plan: &Plan) -> Ball {
    let middles: Vec<Vec3> = plan.clusters.iter().map(|cluster| cluster.ball.center).collect();
    let bounds = Aabb::of_points(&middles);
    let center = bounds.center();
    let radius = middles.iter().map(|at| at.distance(center)).fold(0.0, f32::max);
    Ball { center, radius: 1.2 * radius, translucency: 0.0 }
}

fn report(tree: &Tree, plan: &Plan, ages: &Ages) -> PlasticReport {
    let last = plan.seasons.last().map_or(0..0, |season| season.clusters.clone());
    let (mut sum, mut volume) = (Vec3::ZERO, 0.0_f32);
    for cluster in &plan.clusters[last.clone()] {
        let cubed = cluster.ball.radius * cluster.ball.radius * cluster.ball.radius;
        sum += (cluster.ball.center - plan.position[0]) * cubed;
        volume += cubed;
    }
    let towards = if volume > 0.0 { sum / volume } else { Vec3::Y };
    let flat = (towards.x * towards.x + towards.z * towards.z).sqrt();
    let lean = libm::atan2f(flat, towards.y);
    PlasticReport {
        n_main_nodes: plan.len() as u32,
        n_branchlet_nodes: (tree.skeleton().len() - plan.len()) as u32,
        n_clusters: last.len() as u32,
        n_seasons: ages.n_seasons,
        internode: ages.internode,
        lean,
        already_bent: lean > LEANING,
    }
}
