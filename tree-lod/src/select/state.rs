//! What a view remembers from frame to frame, and the room a frame needs.

use super::occlude::Occluders;
use super::scene::Scene;
use crate::error::{LodError, Result};
use tree_core::{Control, Resource};

/// Memory of one view of a scene: a camera, or a cascade of a shadow map. All of it is allocated here.
#[derive(Clone, Debug)]
pub struct State {
    pub(super) memory: Vec<Memory>,
    /// Tiles in view: bits of the squared distance, number.
    pub(super) tiles: Vec<(u32, u32)>,
    /// Rows in view, roughly front to back.
    pub(super) drawn: Vec<u32>,
    /// For batches: number, then first row, of the instances of each level of each model.
    pub(super) buckets: Vec<u32>,
    pub(super) occluders: Occluders,
    pub(super) frame: u32,
}

/// What is remembered of an instance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Memory {
    /// Bits of the sample points that were seen when they were last tested.
    pub(super) seen: u64,
    /// Share that is drawn.
    pub(super) lambda: f32,
    /// Frame in which it was last in view.
    pub(super) frame: u32,
    pub(super) level: u16,
}

impl State {
    /// A state for one view of this scene, or of one with as many instances and the same models.
    ///
    /// # Errors
    /// The limit on nodes counts instances.
    ///
    /// # Complexity
    /// 32 bytes for each instance, 4 for each level of a model, and 144 KiB.
    pub fn new(scene: &Scene, control: &Control) -> Result<Self> {
        control.limits.check(Resource::Nodes, scene.len() as u64)?;
        let unseen = Memory { seen: u64::MAX, lambda: 1.0, frame: 0, level: 0 };
        Ok(Self {
            memory: vec![unseen; scene.len()],
            tiles: Vec::with_capacity(scene.tiles.len()),
            drawn: Vec::with_capacity(scene.len()),
            buckets: vec![0; scene.n_buckets()],
            occluders: Occluders::new(),
            frame: 1,
        })
    }

    /// Number of the instances that were in view in the last frame, in the order in which they are drawn.
    #[must_use]
    pub fn n_drawn(&self) -> usize {
        self.drawn.len()
    }

    /// How an instance was drawn in the last frame. None when it was not in view, or is not of this scene.
    #[must_use]
    pub fn shown(&self, scene: &Scene, instance: usize) -> Option<Shown> {
        let row = scene.row_of(instance)?;
        let memory = self.memory.get(row).filter(|memory| memory.frame == self.frame)?;
        let model = scene.models.get(scene.rows.get(row)?.model as usize)?;
        let visible = model.visible(memory.seen);
        Some(Shown { lambda: memory.lambda, level: memory.level.into(), visible })
    }

    /// Whether it was made for such a scene.
    pub(super) fn check(&self, scene: &Scene) -> Result<()> {
        if self.memory.len() == scene.len() && self.buckets.len() == scene.n_buckets() {
            return Ok(());
        }
        let problem = "made for a scene with so many instances or for other models; make a new one";
        Err(LodError::Scene { what: "state", row: self.memory.len(), problem })
    }
}

/// How an instance is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Share of the foliage's triangles.
    pub lambda: f32,
    /// Level of the model.
    pub level: usize,
    /// Share of the sample points that are seen, 0 to 1.
    pub visible: f32,
}
