//! The state of a session, and its past.

use super::{Change, SilhouetteParams};
use crate::error::{ModelError, Result};
use crate::silhouette::grow::{Grown, grow};
use crate::silhouette::outline::OutlineRepair;
use crate::silhouette::plan::{Coverage, Plan, Section};
use crate::silhouette::{Line, Outline};
use glam::Vec2;
use tree_core::{Control, Resource, Seed};

/// Edits that can be undone, at most.
const MOST_PAST: usize = 256;

/// What was drawn, and what follows of it in the plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Drawn {
    pub(super) params: SilhouetteParams,
    pub(super) trunk: Option<Line>,
    pub(super) crown: Option<Outline>,
    pub(super) sections: Vec<Section>,
    pub(super) plan: Option<Plan>,
    pub(super) coverage: Coverage,
    /// The last id that was given to a branch.
    pub(super) last_id: u32,
}

/// A tree being drawn. See the module.
#[derive(Clone, Debug)]
pub struct Session {
    pub(super) now: Drawn,
    past: Vec<Drawn>,
    future: Vec<Drawn>,
    seed: Seed,
}

impl Session {
    /// An empty session.
    ///
    /// # Errors
    /// [`ModelError::Parameter`].
    pub fn new(params: SilhouetteParams, seed: Seed) -> Result<Self> {
        params.validate()?;
        let now = Drawn { params, ..Drawn::default() };
        Ok(Self { now, past: Vec::new(), future: Vec::new(), seed })
    }

    /// The parameters.
    #[must_use]
    pub fn params(&self) -> &SilhouetteParams {
        &self.now.params
    }

    /// The plan; `None` before a crown was drawn.
    #[must_use]
    pub fn plan(&self) -> Option<&Plan> {
        self.now.plan.as_ref()
    }

    /// How well branches covered the crown when they were inferred last.
    #[must_use]
    pub fn coverage(&self) -> Coverage {
        self.now.coverage
    }

    /// The tree in space.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] before a crown was drawn; else as [`grow`].
    pub fn tree(&self, control: &Control) -> Result<Grown> {
        grow(self.drawn_plan()?, &self.now.params.grow, self.seed, control)
    }

    /// The seed.
    #[must_use]
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// Another seed: only what is drawn by chance changes.
    pub fn set_seed(&mut self, seed: Seed) {
        self.seed = seed;
    }

    /// Takes back the last edit; `None` where there is none.
    pub fn undo(&mut self) -> Option<Change> {
        let before = self.past.pop()?;
        let after = std::mem::replace(&mut self.now, before);
        let change = Change::between(after.plan.as_ref(), self.plan());
        self.future.push(after);
        Some(change)
    }

    /// Does again what was taken back last; `None` where there is nothing.
    pub fn redo(&mut self) -> Option<Change> {
        let after = self.future.pop()?;
        let before = std::mem::replace(&mut self.now, after);
        let change = Change::between(before.plan.as_ref(), self.plan());
        self.past.push(before);
        Some(change)
    }

    /// Edits that can be undone, and done again.
    #[must_use]
    pub fn depth(&self) -> (usize, usize) {
        (self.past.len(), self.future.len())
    }

    /// Forgets what could be taken back.
    pub(super) fn forget(&mut self) {
        self.past.clear();
        self.future.clear();
    }

    /// Does an edit, whole or not at all.
    pub(super) fn edit(
        &mut self,
        how: impl FnOnce(&mut Drawn, &mut Vec<String>) -> Result<()>,
    ) -> Result<Change> {
        let mut next = self.now.clone();
        let mut repairs = Vec::new();
        how(&mut next, &mut repairs)?;
        let change = Change::between(self.plan(), next.plan.as_ref());
        self.past.push(std::mem::replace(&mut self.now, next));
        if self.past.len() > MOST_PAST {
            self.past.remove(0);
        }
        self.future.clear();
        Ok(Change { repairs, ..change })
    }

    fn drawn_plan(&self) -> Result<&Plan> {
        self.plan().ok_or_else(|| no_crown("tree"))
    }
}

impl Drawn {
    /// The plan, to be changed.
    pub(super) fn plan_mut(&mut self, what: &str) -> Result<&mut Plan> {
        self.plan.as_mut().ok_or_else(|| no_crown(what))
    }

    /// An outline of a stroke.
    pub(super) fn outline(
        &self,
        stroke: &[Vec2],
        what: &str,
        repairs: &mut Vec<String>,
    ) -> Result<Outline> {
        check_count(stroke)?;
        let (outline, done) = Outline::close(stroke, what, &self.params.outline)?;
        // Which way round it was drawn is nobody's fault.
        let told = done.iter().filter(|repair| **repair != OutlineRepair::Turned);
        repairs.extend(told.map(|repair| format!("{what}: {repair}")));
        Ok(outline)
    }
}

fn no_crown(what: &str) -> ModelError {
    let problem = "there is no crown yet: draw its outline first".into();
    ModelError::Silhouette { what: what.into(), problem }
}

/// A line of a stroke: without points that are not finite, by few points.
pub(super) fn line_of(stroke: &[Vec2], what: &str, repairs: &mut Vec<String>) -> Result<Line> {
    /// Coordinates beyond are no metres of a tree.
    const LARGEST: f32 = 1e6;
    /// Points that a drawn line is kept by, evenly spaced: what is finer is the hand's.
    const POINTS: usize = 24;
    /// A line whose ends are nearer to each other than this share of its length has no direction.
    const LEAST_SPAN: f32 = 0.02;
    check_count(stroke)?;
    let good: Vec<Vec2> =
        stroke.iter().copied().filter(|p| p.x.abs() <= LARGEST && p.y.abs() <= LARGEST).collect();
    let n_bad = stroke.len() - good.len();
    if n_bad > 0 {
        repairs.push(format!(
            "{what}: {n_bad} points were not finite or too far away and were left out"
        ));
    }
    let line = Line::new(good).filter(|line| line.length() > 1e-6).ok_or_else(|| {
        let problem = "it has no length; a line needs two different points".into();
        ModelError::Silhouette { what: what.into(), problem }
    })?;
    if line.span().length() < LEAST_SPAN * line.length() {
        let problem = "it ends where it begins; draw it from base to tip".into();
        return Err(ModelError::Silhouette { what: what.into(), problem });
    }
    Ok(line.resampled(POINTS))
}

fn check_count(stroke: &[Vec2]) -> Result<()> {
    Ok(Control::default().limits.check(Resource::Nodes, stroke.len() as u64)?)
}
