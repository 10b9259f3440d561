//! New main branches where old ones have died and there is light: the growth model goes on where adaptation has pruned
//! (beyond Pirk et al. 2012, whose section 7 leaves it open).
//!
//! Each stump, a living main node that lost a branch, is a place for one. Brightest first, and no two nearer to each other than a
//! given distance, they become plants of a stand ([`growth`](crate::growth)) that grows in the shade of all leaves there are, kept out of all
//! obstacles, and is then joined to the tree.

use super::analysis::PlasticTree;
use super::obstacle::Placed;
use super::params::scene_error;
use super::pose::Pose;
use super::scene::{Planted, Scene, TreeId};
use crate::error::{Result, check};
use crate::growth::{Environment, Habit, Plant, Shadow, Simulation, World};
use crate::path;
use glam::{Affine3A, Vec3};
use tree_core::{
    Control, Foliage, Leaf, NO_PARENT, Resource, Seed, Skeleton, SkeletonColumns, Tree, Volume,
};

/// How new branches grow.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Regrowth {
    /// Their kind.
    pub habit: Habit,
    /// How leaves shade.
    pub shadow: Shadow,
    /// Iterations they grow for, 0 to 100. Default 6.
    pub years: u32,
    /// Least light at a stump, as a share of the open sky's, 0 to 1. Default 0.4.
    pub light: f32,
    /// Least distance between two new branches in metres, 0 to 1000. Default 0.4.
    pub spacing: f32,
    /// Most new branches, 0 to 10,000. Default 64.
    pub most: u32,
}

impl Default for Regrowth {
    fn default() -> Self {
        Self {
            habit: Habit::default(),
            shadow: Shadow::default(),
            years: 6,
            light: 0.4,
            spacing: 0.4,
            most: 64,
        }
    }
}

impl Regrowth {
    /// Defaults to the measure of a tree: internodes, voxels and distances by the length of its internodes, and no leaves where it
    /// has none.
    #[must_use]
    pub fn of(model: &PlasticTree) -> Self {
        let mut new = Self::default();
        let internode = (0.5 * model.report().internode).clamp(0.001, 50.0);
        new.habit.internode = internode;
        new.shadow.voxel = 1.6 * internode;
        new.spacing = (3.0 * internode).min(1000.0);
        if model.tree().foliage().is_empty() {
            new.habit.leaves = None;
        }
        new
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        self.habit.validate()?;
        self.shadow.validate()?;
        check("regrowth.years", self.years, 0, 100)?;
        check("regrowth.light", self.light, 0.0, 1.0)?;
        check("regrowth.spacing", self.spacing, 0.0, 1000.0)?;
        check("regrowth.most", self.most, 0, 10_000)
    }
}

/// A tree with new branches.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Regrown {
    /// The tree, in its own frame: first the nodes of the adapted tree, then new ones.
    pub tree: Tree,
    /// Nodes of the adapted tree.
    pub n_adapted: u32,
    /// The first new node of each new branch.
    pub branches: Vec<u32>,
    /// Stumps there were.
    pub n_stumps: u32,
    /// Of these, stumps with light and room enough.
    pub n_open: u32,
}

/// Where a branch was, in the world.
struct Stump {
    /// Node of the adapted tree.
    node: u32,
    at: Vec3,
    direction: Vec3,
}

impl Scene {
    /// The tree as of the last update, and new branches where old ones died and there is light. The scene does not change.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there; parameters; limits; cancellation; of leaves and radii as [`GrowthParams::grow`](crate::growth::GrowthParams::grow).
    ///
    /// # Complexity
    /// That of [`adapted`](Self::adapted), for this tree and those near it, and of growing the new branches.
    pub fn regrown(
        &self,
        id: TreeId,
        params: &Regrowth,
        seed: Seed,
        control: &Control,
    ) -> Result<Regrown> {
        params.validate()?;
        let planted = self.planted(id)?;
        let adapted = self.adapted(id, control)?;
        let (tree, pose) = (adapted.tree, planted.pose);
        let all = stumps(planted, &tree, &adapted.source);
        let n_stumps = all.len() as u32;
        let world = self.world(planted, &tree, params, control)?;
        let chosen = open_stumps(all, &world, params, seed, control)?;
        let n_open = chosen.len() as u32;
        let n_adapted = tree.skeleton().len() as u32;
        let mut joined = Joined::new(tree, pose);
        let mut branches = Vec::with_capacity(chosen.len());
        if !chosen.is_empty() {
            let plants: Vec<Plant> = chosen.iter().map(|stump| stump.plant(params)).collect();
            let mut stand = Simulation::new(&world, &plants, seed, control)?;
            for _ in 0..params.years {
                stand.step(control)?;
            }
            for (index, stump) in chosen.iter().enumerate() {
                let branch = stand.grown(index, control)?.tree;
                branches.push(joined.join(stump.node, &branch, control)?);
            }
        }
        Ok(Regrown { tree: joined.finish()?, n_adapted, branches, n_stumps, n_open })
    }

    /// What new branches meet: all leaves near, all obstacles, the sky.
    fn world(
        &self,
        planted: &Planted,
        tree: &Tree,
        params: &Regrowth,
        control: &Control,
    ) -> Result<World> {
        // Leaves stand closer than metamers do, which the shadow of one is made for.
        let spacing = params.habit.internode;
        let mut standing = leafy(tree, planted.pose, spacing);
        let center = planted.pose.to_world(planted.model.around.center);
        for other in self.trees().filter(|&other| other != planted.id) {
            let near = self.planted(other)?;
            let around = near.model.around;
            let far = center.distance(near.pose.to_world(around.center));
            if far < planted.model.around.radius + around.radius {
                let other = self.adapted(other, control)?.tree;
                standing.extend(leafy(&other, near.pose, spacing));
            }
        }
        let solids = self.placed().map(Placed::in_world).collect::<Result<Vec<_>>>()?;
        let obstacle = if solids.is_empty() {
            None
        } else {
            Some(path::Obstacle { volume: Volume::union_all(solids)?, clearance: 0.0 })
        };
        Ok(World {
            environment: Environment::Shadow(params.shadow),
            light: self.sky().light,
            brightness: self.sky().brightness,
            obstacle,
            standing,
        })
    }
}

impl Placed {
    /// The volume where it stands.
    fn in_world(&self) -> Result<Volume> {
        let place = Affine3A::from_rotation_translation(self.pose.rotation, self.pose.position);
        self.volume
            .transformed(place)
            .map_err(|error| scene_error("obstacle", format!("it cannot be grown around: {error}")))
    }
}

impl Stump {
    fn plant(&self, params: &Regrowth) -> Plant {
        Plant { habit: params.habit.clone(), base: self.at, direction: self.direction }
    }
}

/// Nodes that bear leaves, and tips where there are none, in the world; one in each cell of edge `spacing`.
fn leafy(tree: &Tree, pose: Pose, spacing: f32) -> Vec<Vec3> {
    let skeleton = tree.skeleton();
    let mut bears = vec![false; skeleton.len()];
    for leaf in tree.foliage().iter() {
        bears[leaf.node as usize] = true;
    }
    if tree.foliage().is_empty() {
        let children = skeleton.children();
        for (node, bears) in bears.iter_mut().enumerate() {
            *bears = children.is_tip(node as u32);
        }
    }
    let nodes = skeleton.positions().iter().zip(bears).filter(|&(_, bears)| bears);
    let cell = |at: &Vec3| (*at / spacing).floor().as_ivec3().to_array();
    let mut points: Vec<Vec3> = nodes.map(|(&at, _)| pose.to_world(at)).collect();
    points.sort_by_cached_key(cell);
    points.dedup_by_key(|at| cell(at));
    points
}

/// Living main nodes that lost a branch, with the direction it had.
fn stumps(planted: &Planted, tree: &Tree, source: &[u32]) -> Vec<Stump> {
    let model = &planted.model;
    let (plan, state) = (&model.plan, &planted.state);
    let mut lost = vec![None; plan.len()];
    for row in (1..plan.len()).rev() {
        let below = plan.parent[row] as usize;
        if !planted.lives(row) && planted.lives(below) {
            lost[below] = Some(state.turned[below] * plan.direction[row]);
        }
    }
    let mut found = Vec::new();
    for (node, &old) in source.iter().enumerate() {
        if !model.is_main[old as usize] {
            continue;
        }
        let row = model.row_of[old as usize] as usize;
        if let Some(direction) = lost[row].take() {
            found.push(Stump {
                node: node as u32,
                at: planted.pose.to_world(tree.skeleton().positions()[node]),
                direction: planted.pose.rotation * direction,
            });
        }
    }
    found
}

/// Those with light and room enough, brightest first.
fn open_stumps(
    mut stumps: Vec<Stump>,
    world: &World,
    params: &Regrowth,
    seed: Seed,
    control: &Control,
) -> Result<Vec<Stump>> {
    stumps.retain_mut(|stump| stump.turn_free(world, params.habit.internode));
    if stumps.is_empty() || params.most == 0 {
        return Ok(Vec::new());
    }
    control.limits.check(Resource::Nodes, 2 * stumps.len() as u64)?;
    // A simulation that does not begin knows the light.
    let plant = stumps[0].plant(params);
    let light = Simulation::new(world, &[plant], seed, control)?;
    let enough = params.light * world.brightness;
    let mut bright: Vec<(f32, Stump)> = stumps
        .into_iter()
        .map(|stump| (light.light(stump.at + stump.direction * params.habit.internode), stump))
        .filter(|(light, _)| *light >= enough && *light > 0.0)
        .collect();
    bright.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.node.cmp(&b.1.node)));
    let mut chosen: Vec<Stump> = Vec::new();
    for (_, stump) in bright {
        let near = |other: &Stump| other.at.distance(stump.at) < params.spacing;
        if chosen.len() < params.most as usize && !chosen.iter().any(near) {
            chosen.push(stump);
        }
    }
    Ok(chosen)
}

impl Stump {
    /// Points it to where its first internode is free: as the old branch went, or half way up, or up. Whether it is at all.
    fn turn_free(&mut self, world: &World, internode: f32) -> bool {
        let old = self.direction.normalize_or(Vec3::Y);
        let ways = [old, (old + Vec3::Y).normalize_or(Vec3::Y), Vec3::Y];
        let free = |way: &Vec3| {
            world.obstacle.as_ref().is_none_or(|obstacle| {
                !obstacle.holds(self.at) && obstacle.is_free(self.at, self.at + *way * internode)
            })
        };
        let found = ways.into_iter().find(free);
        self.direction = found.unwrap_or(old);
        found.is_some()
    }
}

/// The tree, as branches are joined to it.
struct Joined {
    columns: SkeletonColumns,
    leaves: Foliage,
    tree: Tree,
    pose: Pose,
}

impl Joined {
    fn new(tree: Tree, pose: Pose) -> Self {
        let skeleton = tree.skeleton();
        let columns = SkeletonColumns {
            positions: skeleton.positions().to_vec(),
            radii: skeleton.radii().to_vec(),
            parents: skeleton.parents().to_vec(),
        };
        Self { columns, leaves: tree.foliage().clone(), tree, pose }
    }

    /// Puts a branch that grew in the world on a node; its base becomes that node. Returns its first node.
    fn join(&mut self, on: u32, branch: &Tree, control: &Control) -> Result<u32> {
        let skeleton = branch.skeleton();
        let first = self.columns.positions.len() as u32;
        let n = u64::from(first) + skeleton.len() as u64;
        control.limits.check(Resource::Nodes, n)?;
        let new = |node: u32| if node == 0 { on } else { first + node - 1 };
        // No thicker than what it stands on.
        let widest = 0.8 * self.columns.radii[on as usize];
        let base = skeleton.radii()[0];
        let scale = if base > widest && base > 0.0 { widest / base } else { 1.0 };
        for node in 1..skeleton.len() {
            self.columns.positions.push(self.pose.to_local(skeleton.positions()[node]));
            self.columns.radii.push(scale * skeleton.radii()[node]);
            let parent = skeleton.parents()[node];
            self.columns.parents.push(if parent == NO_PARENT { on } else { new(parent) });
        }
        let turn = self.pose.rotation.conjugate();
        for leaf in branch.foliage().iter() {
            self.leaves.push(Leaf {
                node: new(leaf.node),
                position: self.pose.to_local(leaf.position),
                rotation: turn * leaf.rotation,
                kind: 0,
                ..leaf
            })?;
        }
        Ok(first)
    }

    fn finish(self) -> Result<Tree> {
        let skeleton = Skeleton::try_from(self.columns)?;
        Ok(Tree::new(skeleton, self.leaves, self.tree.species().clone())?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lsystem::LSystem;
    use crate::plastic::{PlasticParams, Response, Sky};
    use std::sync::Arc;

    fn scene() -> (Scene, TreeId, super::super::ObstacleId) {
        let control = Control::default();
        let tree = LSystem::preset("oak").unwrap().grow(Seed(1), &control).unwrap().tree;
        let model = PlasticTree::new(tree, &PlasticParams::default(), &control).unwrap();
        let reach = 0.5 * model.tree().skeleton().bounds().size().x;
        let mut scene = Scene::new(Sky::default(), Response::default()).unwrap();
        let id = scene.add_tree(Arc::new(model), Pose::at(Vec3::new(2.0, 0.0, 1.0))).unwrap();
        let wall = Volume::box_solid(Vec3::new(0.0, 0.0, -9.0), Vec3::new(0.2, 12.0, 9.0)).unwrap();
        let at = Vec3::new(2.0 + 0.3 * reach, 0.0, 1.0);
        let wall = scene.add_obstacle(wall, Pose::at(at)).unwrap();
        scene.update(&control).unwrap();
        (scene, id, wall)
    }

    fn regrown(scene: &Scene, id: TreeId) -> Regrown {
        let params = Regrowth::of(scene.model(id).unwrap());
        scene.regrown(id, &params, Seed(3), &Control::default()).unwrap()
    }

    #[test]
    fn a_pruned_tree_grows_new_branches_and_keeps_all_it_has() {
        let (scene, id, _) = scene();
        let adapted = scene.adapted(id, &Control::default()).unwrap();
        let new = regrown(&scene, id);
        assert!(!new.branches.is_empty(), "of {} stumps", new.n_stumps);
        let n = adapted.tree.skeleton().len();
        assert_eq!(new.n_adapted as usize, n);
        assert!(new.tree.skeleton().len() > n + new.branches.len());
        assert_eq!(&new.tree.skeleton().positions()[..n], adapted.tree.skeleton().positions());
        assert!(new.tree.foliage().len() > adapted.tree.foliage().len());
        for &first in &new.branches {
            assert!((new.tree.skeleton().parents()[first as usize] as usize) < n);
        }
        assert_eq!(regrown(&scene, id), new);
    }

    #[test]
    fn new_branches_stay_out_of_the_wall() {
        let (scene, id, _) = scene();
        let new = regrown(&scene, id);
        for &at in &new.tree.skeleton().positions()[new.n_adapted as usize..] {
            let at = scene.pose(id).unwrap().to_world(at);
            assert!(scene.placed().all(|wall| !wall.contains(at)), "{at}");
        }
    }

    #[test]
    fn a_tree_that_lost_nothing_grows_nothing() {
        let (mut scene, id, wall) = scene();
        scene.remove_obstacle(wall).unwrap();
        scene.update(&Control::default()).unwrap();
        let new = regrown(&scene, id);
        assert_eq!((new.n_stumps, new.branches.len()), (0, 0));
        assert!(&new.tree == scene.model(id).unwrap().tree());
    }

    #[test]
    fn in_the_dark_nothing_grows() {
        let (mut scene, id, _) = scene();
        scene.set_sky(Sky { brightness: 0.0, ..Sky::default() }).unwrap();
        scene.update(&Control::default()).unwrap();
        let params = Regrowth { light: 0.0, ..Regrowth::of(scene.model(id).unwrap()) };
        let new = scene.regrown(id, &params, Seed(3), &Control::default()).unwrap();
        assert!(new.n_stumps > 0);
        assert_eq!(new.n_open, 0);
    }

    #[test]
    fn bad_parameters_are_named() {
        let (scene, id, _) = scene();
        let params = Regrowth { light: 2.0, ..Regrowth::default() };
        let error = scene.regrown(id, &params, Seed(3), &Control::default()).unwrap_err();
        assert!(error.to_string().contains("regrowth.light"), "{error}");
    }
}
