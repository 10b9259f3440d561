//! The tree that has come of it: main branches as they bent, branchlets and leaves riding on them, as dense as the light allows
//! (Pirk et al. 2012, section 5.2).
//!
//! The filling of a cluster is the input's own: branchlets that stood in it, moved and turned with the branch they stand on.
//! Where a cluster gets less light than in the open, some are left out; where it gets more, some are set a second time, turned
//! about their branch. What would stand in a solid is left out, leaf by leaf.

use super::light::Light;
use super::obstacle::Placed;
use super::plan::Plan;
use super::scene::{Planted, Scene, TreeId};
use crate::error::Result;
use glam::{Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::{
    Control, Foliage, Leaf, NO_PARENT, Resource, Seed, Skeleton, SkeletonColumns, Tree,
};

/// Branchlets follow this share of the turn from the light of the input to that of today.
const SEEKING: f32 = 0.3;

/// No cluster is filled with more than this many times its branchlets.
const FULLEST: f32 = 1.6;

/// A tree of a scene as it is today.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Adapted {
    /// The tree, in its own frame.
    pub tree: Tree,
    /// Node of the input that each node of the tree comes from.
    pub source: Vec<u32>,
    /// How far each node of the input moved, in metres; for those that are gone, how far they would have.
    pub moved: Vec<f32>,
    /// Season in which the branch of each node of the input died; `None` for those that live.
    pub died: Vec<Option<u16>>,
    /// What happened.
    pub report: AdaptedReport,
}

/// What happened to a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct AdaptedReport {
    /// Main nodes that died.
    pub n_pruned: u32,
    /// Nodes of branchlets left out, with their branch, in the dark, or in a solid.
    pub n_branchlets_dropped: u32,
    /// Nodes of branchlets set once more in the light.
    pub n_branchlets_added: u32,
    /// Leaves left out.
    pub n_leaves_dropped: u32,
    /// Leaves set once more.
    pub n_leaves_added: u32,
    /// Farthest that a living node moved, in metres.
    pub farthest: f32,
}

impl Scene {
    /// The tree as of the last update. O(nodes + leaves), and for each that may touch an obstacle the cost of asking it.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there; limits; cancellation.
    pub fn adapted(&self, id: TreeId, control: &Control) -> Result<Adapted> {
        let tree = self.planted(id)?;
        let center = tree.pose.to_world(tree.model.around.center);
        let walls: Vec<&Placed> = self
            .placed()
            .filter(|wall| wall.near(center, 1.5 * tree.model.around.radius))
            .collect();
        Filling::new(tree, walls, self.response().density).run(control)
    }
}

/// How a node of the input stands today: what belonged to it at p is at `p + moved + (rotation * (p - node) - (p - node))`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NodeMotion {
    /// How far it moved, in the tree's own frame.
    pub moved: Vec3,
    /// How far its segment turned.
    pub rotation: Quat,
    /// Whether the branch that carries it lives.
    pub alive: bool,
}

impl Scene {
    /// How each node of the input stands as of the last update: the skin of a mesh of the input follows it, without meshing the
    /// adapted tree. Branchlets follow their main branch. O(nodes).
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn motions(&self, id: TreeId) -> Result<Vec<NodeMotion>> {
        let tree = self.planted(id)?;
        let positions = tree.model.tree.skeleton().positions();
        let of = |(&row, &at): (&u32, &Vec3)| {
            let row = row as usize;
            let rotation = tree.state.turned[row];
            let offset = at - tree.model.plan.position[row];
            NodeMotion {
                moved: tree.state.moved[row] + (rotation * offset - offset),
                rotation,
                alive: tree.lives(row),
            }
        };
        Ok(tree.model.row_of.iter().zip(positions).map(of).collect())
    }
}

struct Filling<'a> {
    planted: &'a Planted,
    plan: &'a Plan,
    walls: Vec<&'a Placed>,
    /// How many branchlets each piece of the crown has for one of the input.
    density: Vec<f32>,
    /// How each piece's branchlets turn towards the light.
    seek: Vec<Quat>,
    columns: SkeletonColumns,
    source: Vec<u32>,
    /// New node of each node of the input; `NO_PARENT` for what is gone.
    node: Vec<u32>,
    /// New node of its second setting.
    second: Vec<u32>,
    report: AdaptedReport,
}

/// Light brings branchlets in proportion (ρ of Eq. 12 with ρ(i) = i^`power`).
fn density(then: Light, now: Light, power: f32) -> f32 {
    if power == 0.0 || then.amount <= 0.0 || then.amount == now.amount {
        return 1.0;
    }
    libm::powf(now.amount / then.amount, power).min(FULLEST)
}

impl<'a> Filling<'a> {
    fn new(planted: &'a Planted, walls: Vec<&'a Placed>, power: f32) -> Self {
        let plan = &planted.model.plan;
        let n = planted.model.tree.skeleton().len();
        let of_piece = |cluster: &u32| {
            let index = *cluster as usize;
            match plan.clusters.get(index) {
                Some(cluster) => (cluster.light, planted.state.lights[index]),
                None => (Light::default(), Light::default()),
            }
        };
        let lights: Vec<(Light, Light)> = plan.last_cluster.iter().map(of_piece).collect();
        let seek = lights.iter().map(|&(then, now)| {
            let both = then.direction != Vec3::ZERO && now.direction != Vec3::ZERO;
            if !both || then.direction == now.direction {
                return Quat::IDENTITY;
            }
            Quat::IDENTITY.slerp(Quat::from_rotation_arc(then.direction, now.direction), SEEKING)
        });
        Self {
            planted,
            plan,
            walls,
            density: lights.iter().map(|&(then, now)| density(then, now, power)).collect(),
            seek: seek.collect(),
            columns: SkeletonColumns::default(),
            source: Vec::new(),
            node: vec![NO_PARENT; n],
            second: vec![NO_PARENT; n],
            report: AdaptedReport::default(),
        }
    }

    fn run(mut self, control: &Control) -> Result<Adapted> {
        let input = &self.planted.model.tree;
        control.limits.check(Resource::Nodes, 2 * input.skeleton().len() as u64)?;
        control.limits.check(Resource::Leaves, 2 * input.foliage().len() as u64)?;
        control.report("branches", 0.0)?;
        for node in 0..input.skeleton().len() {
            self.set(node);
        }
        control.report("leaves", 0.5)?;
        let foliage = self.leaves()?;
        control.report("done", 1.0)?;
        let skeleton = Skeleton::try_from(self.columns)?;
        let (moved, died, farthest) = self.planted.fates();
        self.report.farthest = farthest;
        let tree = Tree::new(skeleton, foliage, input.species().clone())?;
        Ok(Adapted { tree, source: self.source, moved, died, report: self.report })
    }

    /// A point of the input that rides on row `row`, as it is now.
    fn place(&self, row: usize, seek: Quat, point: Vec3) -> Vec3 {
        let base = self.plan.position[row];
        let offset = point - base;
        let turned = seek * (self.planted.state.turned[row] * offset);
        point + self.planted.state.moved[row] + (turned - offset)
    }

    fn blocked(&self, from: Vec3, to: Vec3) -> bool {
        let pose = self.planted.pose;
        self.walls.iter().any(|wall| wall.meets(pose.to_world(from), pose.to_world(to)))
    }

    fn set(&mut self, node: usize) {
        let model = &self.planted.model;
        let row = model.row_of[node] as usize;
        let lives = self.planted.lives(row);
        if model.is_main[node] {
            if lives {
                let at = self.plan.position[row] + self.planted.state.moved[row];
                self.push(node, at, |this, parent| this.node[parent]);
                self.node[node] = self.source.len() as u32 - 1;
            } else {
                self.report.n_pruned += 1;
            }
            return;
        }
        let skeleton = model.tree.skeleton();
        let parent = skeleton.parents()[node] as usize;
        let piece = self.plan.piece[row] as usize;
        let starts = model.is_main[parent];
        let at = self.place(row, self.seek[piece], skeleton.positions()[node]);
        // A branchlet comes and goes as a whole: its first node decides, by a number of its own.
        let chance = chance(node);
        let wanted = !starts || chance < self.density[piece];
        let carried = lives && self.node[parent] != NO_PARENT;
        let below = |this: &Self| this.columns.positions[this.node[parent] as usize];
        if carried && wanted && (self.walls.is_empty() || !self.blocked(below(self), at)) {
            self.push(node, at, |this, parent| this.node[parent]);
            self.node[node] = self.source.len() as u32 - 1;
        } else {
            self.report.n_branchlets_dropped += 1;
        }
        self.set_again(node, row, parent, chance);
    }

    /// Sets a branchlet a second time where there is more light than there was.
    fn set_again(&mut self, node: usize, row: usize, parent: usize, chance: f32) {
        let model = &self.planted.model;
        let piece = self.plan.piece[row] as usize;
        let starts = model.is_main[parent];
        let from = if starts { self.node[parent] } else { self.second[parent] };
        let wanted = !starts || chance < self.density[piece] - 1.0;
        if !wanted || from == NO_PARENT || !self.planted.lives(row) {
            return;
        }
        let turn = self.around_branch(row);
        let at = self.place(row, turn * self.seek[piece], model.tree.skeleton().positions()[node]);
        if !self.walls.is_empty() && self.blocked(self.columns.positions[from as usize], at) {
            return;
        }
        self.push(node, at, move |_, _| from);
        self.second[node] = self.source.len() as u32 - 1;
        self.report.n_branchlets_added += 1;
    }

    /// The turn of a second setting: about the main branch, by the golden angle, the same for the whole branchlet.
    fn around_branch(&self, row: usize) -> Quat {
        let axis =
            (self.planted.state.turned[row] * self.plan.direction[row]).normalize_or(Vec3::Y);
        let half = 0.5 * GOLDEN;
        Quat::from_xyzw(
            axis.x * libm::sinf(half),
            axis.y * libm::sinf(half),
            axis.z * libm::sinf(half),
            libm::cosf(half),
        )
    }

    fn push(&mut self, node: usize, at: Vec3, below: impl Fn(&Self, usize) -> u32) {
        let skeleton = self.planted.model.tree.skeleton();
        let parent = match skeleton.parents()[node] {
            NO_PARENT => NO_PARENT,
            parent => below(self, parent as usize),
        };
        self.columns.positions.push(at);
        self.columns.radii.push(skeleton.radii()[node]);
        self.columns.parents.push(parent);
        self.source.push(node as u32);
    }

    fn leaves(&mut self) -> Result<Foliage> {
        let model = &self.planted.model;
        let input = model.tree.foliage();
        let mut out = Foliage::with_capacity(input.len());
        for (index, leaf) in input.iter().enumerate() {
            let row = model.row_of[leaf.node as usize] as usize;
            let piece = self.plan.piece[row] as usize;
            let on_main = model.is_main[leaf.node as usize];
            let chance = chance(index);
            let turned = self.seek[piece] * self.planted.state.turned[row];
            // Leaves of branchlets come and go with them; those on main branches by their own number.
            let stays = self.node[leaf.node as usize] != NO_PARENT
                && (!on_main || chance < self.density[piece]);
            let at = self.place(row, self.seek[piece], leaf.position);
            if stays && !self.inside(at) {
                let rotation =
                    if turned == Quat::IDENTITY { leaf.rotation } else { turned * leaf.rotation };
                out.push(Leaf {
                    node: self.node[leaf.node as usize],
                    position: at,
                    rotation,
                    ..leaf
                })?;
            } else {
                self.report.n_leaves_dropped += 1;
            }
            let again = if on_main {
                self.node[leaf.node as usize]
            } else {
                self.second[leaf.node as usize]
            };
            let wanted = !on_main || chance < self.density[piece] - 1.0;
            if again != NO_PARENT && wanted {
                let turn = self.around_branch(row);
                let at = self.place(row, turn * self.seek[piece], leaf.position);
                if !self.inside(at) {
                    let rotation = turn * turned * leaf.rotation;
                    out.push(Leaf { node: again, position: at, rotation, ..leaf })?;
                    self.report.n_leaves_added += 1;
                }
            }
        }
        Ok(out)
    }

    fn inside(&self, point: Vec3) -> bool {
        self.walls.iter().any(|wall| wall.contains(self.planted.pose.to_world(point)))
    }
}

const GOLDEN: f32 = TAU * 0.381_966;

/// A number in [0, 1) that belongs to a branchlet or a leaf, whatever happens.
fn chance(index: usize) -> f32 {
    Seed(0).stream("filling").unit(index as u64)
}

impl Planted {
    pub(super) fn lives(&self, row: usize) -> bool {
        self.state.died[row] == super::scene::ALIVE
    }

    /// How far the nodes of the input moved, when they died, and the farthest that one moved that lives.
    fn fates(&self) -> (Vec<f32>, Vec<Option<u16>>, f32) {
        let skeleton = self.model.tree.skeleton();
        let mut farthest = 0.0_f32;
        let mut moved = Vec::with_capacity(skeleton.len());
        let mut died = Vec::with_capacity(skeleton.len());
        for (node, &point) in skeleton.positions().iter().enumerate() {
            let row = self.model.row_of[node] as usize;
            let offset = point - self.model.plan.position[row];
            let way = (self.state.moved[row] + (self.state.turned[row] * offset - offset)).length();
            moved.push(way);
            let when = self.state.died[row];
            died.push((when != super::scene::ALIVE).then_some(when));
            if when == super::scene::ALIVE {
                farthest = farthest.max(way);
            }
        }
        (moved, died, farthest)
    }
}
