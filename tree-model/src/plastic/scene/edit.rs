//! What a scene holds, and how it is changed.

use super::super::analysis::PlasticTree;
use super::super::light::{Ball, Bins, Light, Sky};
use super::super::obstacle::{Obstacle, Placed};
use super::super::params::{Response, scene_error};
use super::super::pose::Pose;
use super::state::State;
use crate::error::Result;
use glam::Vec3;
use std::sync::Arc;
use tree_core::Volume;

/// Names a tree of a scene. Not used again after it is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TreeId(pub u64);

/// Names an obstacle of a scene. Not used again after it is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ObstacleId(pub u64);

/// Trees, obstacles and a sky. See the [module](super).
///
/// An edit is checked at once and leaves the scene as it was where it is refused; [`update`](Self::update) works out what all
/// edits since the last one mean.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub(super) sky: Sky,
    pub(super) response: Response,
    pub(super) trees: Vec<Planted>,
    pub(super) obstacles: Vec<Standing>,
    pub(super) next_id: u64,
    /// Obstacles as they were before and are after edits that trees do not know of yet.
    pub(super) moved: Vec<Placed>,
    /// Trees that are gone or stood elsewhere: what their clusters shaded, in the world.
    pub(super) left: Vec<Ball>,
    /// Whether all trees must be worked out anew.
    pub(super) all: bool,
    /// For each tree those that may shade it, until a tree or the sky is another.
    pub(super) near: Option<Vec<Vec<u32>>>,
}

/// A tree where it stands.
#[derive(Clone, Debug)]
pub(in crate::plastic) struct Planted {
    pub id: TreeId,
    pub model: Arc<PlasticTree>,
    pub pose: Pose,
    /// The sky as the tree sees it.
    pub bins: Bins,
    pub state: State,
    /// Its clusters, season after season, in its own frame; one without radius is gone.
    pub balls: Vec<Ball>,
    /// Whether it must be worked out anew from the first season.
    pub anew: bool,
}

/// An obstacle where it stands.
#[derive(Clone, Debug)]
pub(super) struct Standing {
    pub id: ObstacleId,
    pub obstacle: Arc<Obstacle>,
    pub placed: Placed,
}

impl Scene {
    /// An empty scene.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn new(sky: Sky, response: Response) -> Result<Self> {
        sky.validate()?;
        response.validate()?;
        Ok(Self { sky, response, ..Self::default() })
    }

    /// Changes the sky.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn set_sky(&mut self, sky: Sky) -> Result<()> {
        sky.validate()?;
        if sky != self.sky {
            self.sky = sky;
            for tree in &mut self.trees {
                tree.bins = bins(&sky, tree.pose);
            }
            self.all = true;
            self.near = None;
        }
        Ok(())
    }

    /// Changes how much trees react.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn set_response(&mut self, response: Response) -> Result<()> {
        response.validate()?;
        self.all |= response != self.response;
        self.response = response;
        Ok(())
    }

    /// The sky.
    #[must_use]
    pub fn sky(&self) -> &Sky {
        &self.sky
    }

    /// How much trees react.
    #[must_use]
    pub fn response(&self) -> &Response {
        &self.response
    }

    /// Plants a tree. O(nodes), and O(obstacles) to see that none holds its base.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for a pose that is not finite, and where its base lies in an obstacle.
    pub fn add_tree(&mut self, model: Arc<PlasticTree>, pose: Pose) -> Result<TreeId> {
        let pose = pose.checked("tree")?;
        self.check_base(&model, pose, "the tree")?;
        let id = TreeId(self.next_id);
        self.next_id += 1;
        let (state, balls) = State::of_input(&model.plan);
        let bins = bins(&self.sky, pose);
        self.near = None;
        self.trees.push(Planted { id, model, pose, bins, state, balls, anew: true });
        Ok(id)
    }

    /// Moves a tree.
    ///
    /// # Errors
    /// As [`add_tree`](Self::add_tree), and for an id that is not there.
    pub fn move_tree(&mut self, id: TreeId, pose: Pose) -> Result<()> {
        let index = self.tree_index(id)?;
        let pose = pose.checked("tree")?;
        if pose == self.trees[index].pose {
            return Ok(());
        }
        self.check_base(&self.trees[index].model, pose, "the tree")?;
        self.leave(index);
        self.near = None;
        let tree = &mut self.trees[index];
        tree.pose = pose;
        tree.bins = bins(&self.sky, pose);
        tree.anew = true;
        Ok(())
    }

    /// Takes a tree away.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn remove_tree(&mut self, id: TreeId) -> Result<()> {
        let index = self.tree_index(id)?;
        self.leave(index);
        self.near = None;
        self.trees.remove(index);
        Ok(())
    }

    /// Puts an obstacle into the scene. Balls, boxes and half-spaces, moved, turned and united, cast their exact shadow; any other
    /// volume that of boxes a sixteenth of its size. Prepared once: moving it is cheap.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for a pose that is not finite, a volume that has no end and is no half-space (nor a
    /// union with them), and where it would hold the base of a tree.
    pub fn add_obstacle(&mut self, volume: Volume, pose: Pose) -> Result<ObstacleId> {
        let pose = pose.checked("obstacle")?;
        let obstacle = Arc::new(Obstacle::new(volume)?);
        let placed = Placed::new(&obstacle, pose);
        self.check_bases(&placed)?;
        let id = ObstacleId(self.next_id);
        self.next_id += 1;
        self.moved.push(placed.clone());
        self.obstacles.push(Standing { id, obstacle, placed });
        Ok(id)
    }

    /// Moves an obstacle.
    ///
    /// # Errors
    /// As [`add_obstacle`](Self::add_obstacle), and for an id that is not there.
    pub fn move_obstacle(&mut self, id: ObstacleId, pose: Pose) -> Result<()> {
        let index = self.obstacle_index(id)?;
        let pose = pose.checked("obstacle")?;
        let placed = Placed::new(&self.obstacles[index].obstacle, pose);
        if pose == self.obstacles[index].placed.pose {
            return Ok(());
        }
        self.check_bases(&placed)?;
        let old = std::mem::replace(&mut self.obstacles[index].placed, placed.clone());
        self.moved.push(old);
        self.moved.push(placed);
        Ok(())
    }

    /// Takes an obstacle away.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn remove_obstacle(&mut self, id: ObstacleId) -> Result<()> {
        let index = self.obstacle_index(id)?;
        self.moved.push(self.obstacles.remove(index).placed);
        Ok(())
    }

    /// The trees, in the order they were planted.
    pub fn trees(&self) -> impl ExactSizeIterator<Item = TreeId> + '_ {
        self.trees.iter().map(|tree| tree.id)
    }

    /// The obstacles, in the order they were put there.
    pub fn obstacles(&self) -> impl ExactSizeIterator<Item = ObstacleId> + '_ {
        self.obstacles.iter().map(|standing| standing.id)
    }

    /// Where a tree stands.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn pose(&self, id: TreeId) -> Result<Pose> {
        Ok(self.trees[self.tree_index(id)?].pose)
    }

    /// The model a tree was planted from.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn model(&self, id: TreeId) -> Result<&Arc<PlasticTree>> {
        Ok(&self.trees[self.tree_index(id)?].model)
    }

    /// A tree's leaf clusters today, with the light they get, in the tree's own frame, as of the last update.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for an id that is not there.
    pub fn clusters(&self, id: TreeId) -> Result<Vec<(Ball, Light)>> {
        let tree = &self.trees[self.tree_index(id)?];
        let last = tree.model.plan.seasons.last().map_or(0..0, |season| season.clusters.clone());
        let lights = tree.state.lights[last.clone()].iter().copied();
        Ok(tree.balls[last]
            .iter()
            .copied()
            .zip(lights)
            .filter(|(ball, _)| ball.radius > 0.0)
            .collect())
    }

    pub(in crate::plastic) fn planted(&self, id: TreeId) -> Result<&Planted> {
        Ok(&self.trees[self.tree_index(id)?])
    }

    pub(in crate::plastic) fn placed(&self) -> impl Iterator<Item = &Placed> {
        self.obstacles.iter().map(|standing| &standing.placed)
    }

    fn tree_index(&self, id: TreeId) -> Result<usize> {
        self.trees
            .binary_search_by_key(&id, |tree| tree.id)
            .map_err(|_| scene_error(format!("tree {}", id.0), "it is not in the scene"))
    }

    fn obstacle_index(&self, id: ObstacleId) -> Result<usize> {
        self.obstacles
            .binary_search_by_key(&id, |standing| standing.id)
            .map_err(|_| scene_error(format!("obstacle {}", id.0), "it is not in the scene"))
    }

    fn check_base(&self, model: &PlasticTree, pose: Pose, what: &str) -> Result<()> {
        let base = pose.to_world(model.plan.position[0]);
        match self.obstacles.iter().find(|standing| standing.placed.contains(base)) {
            Some(found) => Err(holds_base(what, base, found.id.0)),
            None => Ok(()),
        }
    }

    fn check_bases(&self, placed: &Placed) -> Result<()> {
        for tree in &self.trees {
            let base = tree.pose.to_world(tree.model.plan.position[0]);
            if placed.contains(base) {
                return Err(scene_error(
                    "obstacle",
                    format!("it would hold the base of tree {} at {base}", tree.id.0),
                ));
            }
        }
        Ok(())
    }

    /// Notes what a tree shaded that moves or goes.
    fn leave(&mut self, index: usize) {
        let tree = &self.trees[index];
        self.left.extend(
            tree.balls
                .iter()
                .filter(|ball| ball.radius > 0.0)
                .map(|ball| Ball { center: tree.pose.to_world(ball.center), ..*ball }),
        );
    }
}

fn holds_base(what: &str, base: Vec3, id: u64) -> crate::ModelError {
    scene_error(what, format!("its base at {base} lies in obstacle {id}"))
}

/// The sky as it is seen by who stands so.
fn bins(sky: &Sky, pose: Pose) -> Bins {
    let turn = pose.rotation.conjugate();
    Bins::new(turn * sky.light.normalize(), turn * Vec3::Y, sky.brightness)
}
