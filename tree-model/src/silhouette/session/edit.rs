//! Edits: trunk, crown, outlines of branches, leaf, styles.

use super::state::{Drawn, line_of};
use super::target::{bearer, find, length_inside, systems};
use super::{Change, Session, SilhouetteParams};
use crate::error::{ModelError, Result, check};
use crate::silhouette::bump::bumps;
use crate::silhouette::outline::LeafOutline;
use crate::silhouette::plan::{DrawnLeaf, Lateral, Plan, Section, System, axis_of};
use crate::silhouette::{Line, Outline};
use glam::Vec2;
use std::f32::consts::TAU;

/// A trunk whose end is farther from the crown than this share of the crown's size does not bear it.
const FAR: f32 = 0.5;
/// The finest level of branches.
pub(super) const DEEPEST: u32 = 8;
/// An outline is of a branch whose own it shares at least this share of its area with, where it misses all lines.
const COVERED: f32 = 0.2;
/// A branch is taken for the same when its end has moved by less than this share of its span.
const SAME: f32 = 0.35;

impl Session {
    /// Draws the trunk, from the ground up; one drawn downwards is turned. Branches are inferred anew when there is a crown.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for a line without length or one that stays away from the crown.
    pub fn draw_trunk(&mut self, stroke: &[Vec2]) -> Result<Change> {
        self.edit(|drawn, repairs| {
            let line = line_of(stroke, "trunk", repairs)?;
            let turned = line.start().y > line.end().y;
            if turned {
                repairs.push("trunk: it was drawn from the top down and was turned".into());
            }
            let reversed = || Line::new(line.points().iter().rev().copied().collect());
            drawn.trunk = if turned { reversed() } else { Some(line) };
            drawn.infer(repairs)
        })
    }

    /// Draws the crown's outline. Branches that were drawn or refined stay, where the new crown has a branch near.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for what encloses no area, or where the trunk stays away from it.
    ///
    /// # Complexity
    /// Some milliseconds.
    pub fn draw_crown(&mut self, stroke: &[Vec2]) -> Result<Change> {
        self.edit(|drawn, repairs| {
            drawn.crown = Some(drawn.outline(stroke, "crown", repairs)?);
            drawn.infer(repairs)
        })
    }

    /// Draws the crown in another upright plane through the trunk: the one whose right side is at `azimuth` radians (-2π to 2π, from +X
    /// towards +Z), as a viewer of yaw -`azimuth` sees it. An outline in that plane is replaced.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for what encloses no area, or before there is a crown; [`ModelError::Parameter`].
    pub fn draw_section(&mut self, azimuth: f32, stroke: &[Vec2]) -> Result<Change> {
        check("azimuth", azimuth, -TAU, TAU)?;
        self.edit(|drawn, repairs| {
            let outline = drawn.outline(stroke, "crown from the side", repairs)?;
            drawn.sections.retain(|section| (section.azimuth - azimuth).abs() > 1e-3);
            drawn.sections.push(Section { azimuth, outline });
            let sections = drawn.sections.clone();
            drawn.plan_mut("crown from the side")?.system.sections = sections;
            Ok(())
        })
    }

    /// Draws the outline of the foliage of a branch of a level, 1 for those on the trunk. The branch is the one with the
    /// greatest length inside, or where there is none the one whose foliage it covers most; its own branches are inferred.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for what encloses no area or no part of a branch of that level; [`ModelError::Parameter`].
    pub fn refine(&mut self, level: u32, stroke: &[Vec2]) -> Result<Change> {
        check("level", level, 1, DEEPEST)?;
        self.edit(|drawn, repairs| {
            let what = format!("outline of a branch of level {level}");
            let outline = drawn.outline(stroke, &what, repairs)?;
            let mut best: Option<(f32, u32)> = None;
            let plan = drawn.plan_mut(&what)?;
            let bearers = systems(&mut plan.system, level - 1);
            let refuse = |problem: String| ModelError::Silhouette { what: what.clone(), problem };
            if bearers.is_empty() {
                let above = level - 1;
                return Err(refuse(format!(
                    "no branch of level {above} has an outline: draw that first"
                )));
            }
            let in_plane = |lateral: &&Lateral| lateral.azimuth.is_none();
            for lateral in bearers.iter().flat_map(|system| &system.laterals).filter(in_plane) {
                let length = length_inside(lateral, &outline);
                if length > 0.0 && best.is_none_or(|(longest, _)| length > longest) {
                    best = Some((length, lateral.id));
                }
            }
            // Small outlines may miss the lines of branches: the one whose foliage it covers most is meant then.
            let by_foliage = || {
                let all = bearers.iter().flat_map(|system| &system.laterals);
                all.map(|lateral| (lateral.outline.overlap(&outline), lateral.id))
                    .filter(|&(shared, _)| shared > COVERED * outline.area())
                    .max_by(|a, b| a.0.total_cmp(&b.0))
            };
            let Some((_, id)) = best.or_else(by_foliage) else {
                return Err(refuse("no branch of that level runs through it".into()));
            };
            drawn.refine(id, outline, &what)
        })
    }

    /// Draws the outline of the foliage of the branch of this id.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for what encloses no area, or an id that is not there.
    pub fn refine_branch(&mut self, id: u32, stroke: &[Vec2]) -> Result<Change> {
        self.edit(|drawn, repairs| {
            let what = format!("outline of branch {id}");
            let outline = drawn.outline(stroke, &what, repairs)?;
            drawn.refine(id, outline, &what)
        })
    }

    /// Draws the leaf. Its length is as drawn.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for what encloses no area, or before there is a crown.
    pub fn draw_leaf(&mut self, stroke: &[Vec2]) -> Result<Change> {
        self.edit(|drawn, repairs| {
            let outline = drawn.outline(stroke, "leaf", repairs)?;
            let base = LeafOutline::base_of(&outline);
            let tip = LeafOutline::tip_of(&outline, base);
            let shape = LeafOutline::of(&outline, base, tip)?;
            let leaf = DrawnLeaf { outline: shape, length: base.distance(tip) };
            drawn.plan_mut("leaf")?.leaf = Some(leaf);
            Ok(())
        })
    }

    /// Has branches take the style of another branch, whose outline was drawn; `None`: of the nearest such branch again.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for ids that are not there, a source whose outline was not drawn, and one of a coarser level.
    pub fn copy_style(&mut self, source: Option<u32>, targets: &[u32]) -> Result<Change> {
        self.edit(|drawn, _| {
            let plan = drawn.plan_mut("style")?;
            if let Some(id) = source {
                let source = lateral(plan, id)?;
                if source.system.is_none() {
                    let problem = "its outline was not drawn, so it has no style to copy".into();
                    return Err(ModelError::Silhouette { what: format!("branch {id}"), problem });
                }
            }
            targets.iter().try_for_each(|&id| {
                if source.is_some_and(|source| level_of(plan, source) < level_of(plan, id)) {
                    let problem =
                        "the source is of a coarser level, whose branches do not fit on it".into();
                    return Err(ModelError::Silhouette { what: format!("branch {id}"), problem });
                }
                lateral(plan, id)?.style = source;
                Ok(())
            })
        })
    }

    /// Takes a branch away, with all on it.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] for an id that is not there.
    pub fn remove(&mut self, id: u32) -> Result<Change> {
        self.edit(|drawn, _| {
            let plan = drawn.plan_mut("branch")?;
            let (system, index, _) =
                bearer(&mut plan.system, id, 0).ok_or_else(|| no_branch(id))?;
            let mut gone = Vec::new();
            names(&[system.laterals.remove(index)], &mut gone);
            // Whoever had its style takes the nearest again.
            forget_styles(&mut plan.system, &gone);
            Ok(())
        })
    }

    /// Changes parameters. Where those of branches or angles change, branches are inferred anew.
    ///
    /// # Errors
    /// [`ModelError::Parameter`].
    pub fn set_params(&mut self, params: SilhouetteParams) -> Result<Change> {
        params.validate()?;
        self.edit(|drawn, repairs| {
            let same = drawn.params.system == params.system && drawn.params.angles == params.angles;
            drawn.params = params;
            if same { Ok(()) } else { drawn.infer(repairs) }
        })
    }
}

impl Drawn {
    /// Infers the branches of the trunk, and keeps what was drawn of the old ones.
    fn infer(&mut self, repairs: &mut Vec<String>) -> Result<()> {
        let Some(crown) = &self.crown else { return Ok(()) };
        self.check_trunk(crown, repairs)?;
        let refuse = || {
            let problem = "no axis leads through it".into();
            ModelError::Silhouette { what: "crown".into(), problem }
        };
        let found = bumps(crown, &self.params.system.bumps);
        let axis = axis_of(self.trunk.as_ref(), crown, &found).ok_or_else(refuse)?;
        let old = self.plan.take();
        let angles = match &old {
            Some(plan) if plan.system.laterals.iter().any(is_drawn) => plan.system.angles.clone(),
            _ => self.params.angles.clone(),
        };
        let mut system = System::new(axis, crown.clone(), angles);
        system.sections.clone_from(&self.sections);
        let (old, leaf, lenders) = match old {
            Some(plan) => (plan.system.laterals, plan.leaf, plan.lenders),
            None => (Vec::new(), None, Vec::new()),
        };
        for lateral in old.iter().filter(|lateral| is_drawn(lateral)) {
            let (t, _) = system.axis.nearest(lateral.line.start());
            let left = system.axis.tangent(t).perp_dot(lateral.line.span()) > 0.0;
            let lateral = Lateral { t, left, stretch: None, ..lateral.clone() };
            system.laterals.push(lateral);
        }
        self.coverage = system.grow_from(&found, &self.params.system, &mut self.last_id);
        adopt(&old, &mut system.laterals);
        self.plan = Some(Plan { system, leaf, lenders });
        Ok(())
    }

    /// A trunk must lead to the crown.
    fn check_trunk(&self, crown: &Outline, repairs: &mut Vec<String>) -> Result<()> {
        let Some(trunk) = &self.trunk else { return Ok(()) };
        let through = (0..=32).any(|i| crown.contains(trunk.at(i as f32 / 32.0)));
        if through {
            return Ok(());
        }
        let (low, high) = crown.bounds();
        let (_, gap) = crown.nearest(trunk.end());
        if gap > FAR * (high - low).max_element() {
            let problem = format!(
                "it stays {gap:.2} m away from the crown: draw it from the ground into the crown"
            );
            return Err(ModelError::Silhouette { what: "trunk".into(), problem });
        }
        repairs.push(format!("trunk: it ended {gap:.2} m outside the crown and was lengthened"));
        Ok(())
    }

    fn refine(&mut self, id: u32, outline: Outline, what: &str) -> Result<()> {
        let params = self.params.clone();
        let mut last_id = self.last_id;
        let plan = self.plan_mut(what)?;
        let (bearer, index, level) =
            bearer(&mut plan.system, id, 0).ok_or_else(|| no_branch(id))?;
        check("level", level + 1, 1, DEEPEST)?;
        let lateral = &mut bearer.laterals[index];
        if length_inside(lateral, &outline) <= 0.0 && lateral.outline.overlap(&outline) <= 0.0 {
            let problem = format!("branch {id} does not run through it");
            return Err(ModelError::Silhouette { what: what.into(), problem });
        }
        let angles = params.grow.level(level + 1).angles;
        let old = lateral.system.take();
        // What was drawn on it stays.
        let kept: Vec<Lateral> = old
            .iter()
            .flat_map(|system| &system.laterals)
            .filter(|lateral| is_drawn(lateral))
            .map(|inner| Lateral { stretch: None, ..inner.clone() })
            .collect();
        let angles = match &old {
            Some(old) if !kept.is_empty() => old.angles.clone(),
            _ => angles,
        };
        let mut system = System::new(lateral.line.clone(), outline.clone(), angles);
        system.laterals = kept;
        system.grow(&params.system, &mut last_id);
        if let Some(old) = old {
            adopt(&old.laterals, &mut system.laterals);
        }
        lateral.outline = outline;
        lateral.style = None;
        lateral.system = Some(Box::new(system));
        self.last_id = last_id;
        Ok(())
    }
}

/// Gives new branches the names, styles and systems of old ones that ended near.
fn adopt(old: &[Lateral], new: &mut [Lateral]) {
    let mut free: Vec<&Lateral> = old.iter().filter(|lateral| !is_drawn(lateral)).collect();
    for lateral in new.iter_mut().filter(|lateral| !is_drawn(lateral)) {
        let end = lateral.line.end();
        let distance = |other: &&Lateral| other.line.end().distance(end);
        let nearest = (0..free.len())
            .filter(|&i| free[i].left == lateral.left)
            .min_by(|&a, &b| distance(&free[a]).total_cmp(&distance(&free[b])));
        let Some(nearest) = nearest else { continue };
        if distance(&free[nearest]) > SAME * lateral.line.span().length() {
            continue;
        }
        let other = free.swap_remove(nearest);
        (lateral.id, lateral.style) = (other.id, other.style);
        if other.system.is_some() {
            let line = std::mem::replace(&mut lateral.line, other.line.clone());
            lateral.system.clone_from(&other.system);
            lateral.reshape(line, lateral.left);
            if let Some(system) = &lateral.system {
                lateral.outline = system.outline.clone();
            }
        }
    }
}

fn is_drawn(lateral: &Lateral) -> bool {
    lateral.origin == crate::silhouette::plan::Origin::Drawn
}

/// The level of a branch; `None` where it is not there.
fn level_of(plan: &mut Plan, id: u32) -> Option<u32> {
    bearer(&mut plan.system, id, 0).map(|(_, _, level)| level)
}

/// The names of branches and of all on them.
fn names(laterals: &[Lateral], out: &mut Vec<u32>) {
    for lateral in laterals {
        out.push(lateral.id);
        names(lateral.system.as_deref().map_or(&[], |inner| &inner.laterals), out);
    }
}

fn forget_styles(system: &mut System, gone: &[u32]) {
    for lateral in &mut system.laterals {
        lateral.style = lateral.style.filter(|id| !gone.contains(id));
        if let Some(inner) = &mut lateral.system {
            forget_styles(inner, gone);
        }
    }
}

fn lateral(plan: &mut Plan, id: u32) -> Result<&mut Lateral> {
    find(&mut plan.system, id).ok_or_else(|| no_branch(id))
}

pub(super) fn no_branch(id: u32) -> ModelError {
    let problem = "there is no branch of this id".into();
    ModelError::Silhouette { what: format!("branch {id}"), problem }
}
