//! A whole drawing at once.

use super::edit::DEEPEST;
use super::{Change, Session, SilhouetteParams, Transfer};
use crate::Modeler;
use crate::error::{ModelError, Result};
use crate::silhouette::plan::{DrawnLeaf, Lateral};
use crate::silhouette::read::{Kind, Level, LevelStroke, TreeStrokes};
use glam::Vec2;
use tree_core::{Control, Seed, Tree};

/// What became of a drawing's strokes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PlayReport {
    /// Strokes that were used.
    pub strokes: u32,
    /// What was repaired, in sentences.
    pub repairs: Vec<String>,
    /// Strokes that could not be used, and why, in sentences.
    pub refused: Vec<String>,
}

impl PlayReport {
    fn take(&mut self, name: &str, change: Result<Change>) -> Result<()> {
        match change {
            Ok(change) => {
                self.strokes += 1;
                self.repairs
                    .extend(change.repairs.into_iter().map(|repair| format!("{name}: {repair}")));
            }
            Err(ModelError::Silhouette { what, problem }) => {
                self.refused.push(format!("{name}: {what}: {problem}"));
            }
            Err(other) => return Err(other),
        }
        Ok(())
    }
}

/// A tree of a drawing, as a modeler.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SilhouetteModel {
    /// The strokes of the tree.
    pub strokes: TreeStrokes,
    /// All parameters.
    pub params: SilhouetteParams,
}

impl Modeler for SilhouetteModel {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        let (session, _) = Session::of_drawing(&self.strokes, self.params.clone(), seed)?;
        Ok(session.tree(control)?.tree)
    }
}

/// Where a drawing's tree stands, and its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ground {
    /// The trunk's base in the drawing.
    pub(crate) base: Vec2,
    /// Metres for a unit of the drawing.
    pub(crate) scale: f32,
}

impl Ground {
    pub(crate) fn to_plan(self, points: &[Vec2]) -> Vec<Vec2> {
        points
            .iter()
            .map(|&p| self.scale * Vec2::new(p.x - self.base.x, self.base.y - p.y))
            .collect()
    }
}

/// The base of a tree in its drawing, and its height there; `None` where level 0 has next to no height.
pub(crate) fn stand(tree: &TreeStrokes) -> Option<(Vec2, f32)> {
    let coarse = |stroke: &&LevelStroke| stroke.level == Level::Number(0);
    let good = |point: &&Vec2| point.is_finite();
    let points =
        || tree.strokes.iter().filter(coarse).flat_map(|stroke| &stroke.points).filter(good);
    let (top, bottom) = points()
        .fold((f32::INFINITY, f32::NEG_INFINITY), |(top, low), p| (top.min(p.y), low.max(p.y)));
    let trunk = tree.strokes.iter().filter(coarse).find(|stroke| stroke.kind == Kind::Axis);
    let lowest =
        |points: &[Vec2]| points.iter().filter(good).copied().max_by(|a, b| a.y.total_cmp(&b.y));
    let height = bottom - top;
    // What has no trunk stands on the middle of its lowest part.
    let low = points().filter(|p| p.y >= bottom - 0.04 * height);
    let (least, most) =
        low.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)));
    let foot = Vec2::new(0.5 * (least + most), bottom);
    let base = trunk.and_then(|stroke| lowest(&stroke.points)).unwrap_or(foot);
    // What is flatter than this has no height to scale by.
    const FLAT: f32 = 1e-3;
    let (left, right) =
        points().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)));
    let is_tall = height.is_finite() && height > FLAT * (right - left);
    is_tall.then_some((base, height))
}

impl Session {
    /// Draws all strokes of a tree of a drawing; its height becomes that of the parameters. Strokes of finer levels that
    /// cannot be used are left out and reported.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] where level 0 gives no crown; [`ModelError::Parameter`]; [`ModelError::Limit`].
    pub fn of_drawing(
        tree: &TreeStrokes,
        params: SilhouetteParams,
        seed: Seed,
    ) -> Result<(Self, PlayReport)> {
        let what = || if tree.name.is_empty() { "drawing".into() } else { tree.name.clone() };
        let (base, height) = stand(tree).ok_or_else(|| {
            let problem = "level 0 has no height: draw the crown's outline there".into();
            ModelError::Silhouette { what: what(), problem }
        })?;
        let scale = params.height / height;
        Self::of_ground(tree, Ground { base, scale }, params, seed)
    }

    pub(crate) fn of_ground(
        tree: &TreeStrokes,
        ground: Ground,
        mut params: SilhouetteParams,
        seed: Seed,
    ) -> Result<(Self, PlayReport)> {
        if let (None, Some(width)) = (params.grow.trunk_radius, tree.trunk_width) {
            params.grow.trunk_radius = Some((0.5 * width * ground.scale).clamp(1e-6, 100.0));
        }
        let mut session = Self::new(params, seed)?;
        let mut report = PlayReport::default();
        session.play_coarse(tree, ground, &mut report)?;
        let mut finer: Vec<&LevelStroke> =
            tree.strokes.iter().filter(|stroke| stroke.level != Level::Number(0)).collect();
        finer.sort_by_key(|stroke| stroke.level);
        for stroke in finer {
            if matches!(stroke.level, Level::Number(level) if level > DEEPEST) {
                report.refused.push(format!("{}: levels go to {DEEPEST}", name_of(stroke)));
                continue;
            }
            let points = ground.to_plan(&stroke.points);
            let change = match (stroke.level, stroke.kind) {
                (Level::Leaf, _) => session.draw_leaf(&points),
                (Level::Number(level), Kind::Outline) => session.refine(level, &points),
                (Level::Number(level), Kind::Axis) => {
                    session.redraw(level, &points, &Transfer::Siblings)
                }
            };
            report.take(&name_of(stroke), change)?;
        }
        // What was read cannot be taken back.
        session.forget();
        Ok((session, report))
    }

    /// Lets the plan copy branches of other trees, and gives it a leaf where it has none.
    pub(crate) fn lend(&mut self, lenders: Vec<Lateral>, leaf: Option<DrawnLeaf>) {
        if let Some(plan) = &mut self.now.plan {
            // New branches get other names than those that are lent.
            self.now.last_id = self.now.last_id.max(last_name(&lenders));
            plan.lenders = lenders;
            plan.leaf = plan.leaf.take().or(leaf);
        }
    }

    /// Trunk, crown and the crown's other planes.
    fn play_coarse(
        &mut self,
        tree: &TreeStrokes,
        ground: Ground,
        report: &mut PlayReport,
    ) -> Result<()> {
        let coarse = || tree.strokes.iter().filter(|stroke| stroke.level == Level::Number(0));
        let front = |stroke: &&LevelStroke| stroke.kind == Kind::Outline && stroke.azimuth == 0.0;
        let size = |stroke: &LevelStroke| {
            let all = || stroke.points.iter().copied();
            let low = all().fold(Vec2::INFINITY, Vec2::min);
            let high = all().fold(Vec2::NEG_INFINITY, Vec2::max);
            (high - low).length()
        };
        let crown = coarse().filter(front).max_by(|a, b| size(a).total_cmp(&size(b)));
        let Some(crown) = crown else {
            let problem = "no outline of a crown was drawn in level 0".into();
            return Err(ModelError::Silhouette { what: "crown".into(), problem });
        };
        for other in coarse().filter(front).filter(|&other| !std::ptr::eq(other, crown)) {
            report.refused.push(format!("{}: there is a larger crown", name_of(other)));
        }
        let change = self.draw_crown(&ground.to_plan(&crown.points))?;
        report.take(&name_of(crown), Ok(change))?;
        for (i, stroke) in coarse().filter(|stroke| stroke.kind == Kind::Axis).enumerate() {
            if i > 0 {
                report.refused.push(format!("{}: there is a trunk already", name_of(stroke)));
                continue;
            }
            let change = self.draw_trunk(&ground.to_plan(&stroke.points));
            report.take(&name_of(stroke), change)?;
        }
        for stroke in coarse() {
            if stroke.kind == Kind::Outline && stroke.azimuth != 0.0 {
                let change = self.draw_section(stroke.azimuth, &ground.to_plan(&stroke.points));
                report.take(&name_of(stroke), change)?;
            }
        }
        Ok(())
    }
}

fn name_of(stroke: &LevelStroke) -> String {
    match stroke.name.as_str() {
        "" => stroke.level.to_string(),
        name => format!("{} '{name}'", stroke.level),
    }
}

/// The last name among branches and those on them.
fn last_name(laterals: &[Lateral]) -> u32 {
    let inner =
        |lateral: &Lateral| lateral.system.as_ref().map_or(0, |system| last_name(&system.laterals));
    laterals.iter().map(|lateral| lateral.id.max(inner(lateral))).max().unwrap_or(0)
}
