//! The stages of a session, each done when it is first asked for.

use super::carry::Depths;
use super::params::SketchParams;
use super::report::{SketchReport, SketchTree};
use crate::error::{ModelError, Result};
use crate::sketch::clean::{Cleaned, clean};
use crate::sketch::crown::{Crown, CrownReport};
use crate::sketch::finish::{FinishParams, grow_crown, grow_wood};
use crate::sketch::infer::{InferParams, Inferred, Pin, infer_with};
use crate::sketch::omega::Omega;
use crate::sketch::propagate::{Propagated, propagate};
use crate::sketch::template::{Choice, DrawnShape, Template, select};
use crate::sketch::{Drawing, Plan};
use tree_core::{Control, Seed, Skeleton, Volume};

/// Orders of axes that grow on what has fronds: they do not branch.
const FROND_ORDERS: u32 = 1;

/// What a session makes, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// Strokes joined, the crown closed.
    Clean,
    /// Templates compared.
    Select,
    /// Depths inferred.
    Infer,
    /// Branches propagated.
    Propagate,
    /// Wood with radii.
    Wood,
    /// Twigs and leaves.
    Tree,
}

impl Stage {
    /// All stages in order.
    pub const ALL: [Self; 6] =
        [Self::Clean, Self::Select, Self::Infer, Self::Propagate, Self::Wood, Self::Tree];
}

/// A drawing on its way to a tree. See the [module](super).
#[derive(Clone, Debug)]
pub struct Session {
    pub(super) drawing: Drawing,
    pub(super) params: SketchParams,
    pub(super) templates: Option<Vec<Template>>,
    pub(super) obstacles: Option<Volume>,
    pub(super) seed: Seed,
    pub(super) erased: Vec<bool>,
    /// What edits keep.
    pub(super) kept: Option<Kept>,
    cleaned: Option<Clean>,
    choices: Option<Vec<Choice>>,
    inferred: Option<Inferred>,
    propagated: Option<Propagated>,
    wood: Option<Skeleton>,
    tree: Option<SketchTree>,
    runs: [u32; Stage::ALL.len()],
}

/// Strokes joined, and the crown.
#[derive(Clone, Debug)]
struct Clean {
    cleaned: Cleaned,
    crown: Option<(Crown, CrownReport)>,
}

/// What edits keep of an inference.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    pub(super) depths: Depths,
    omega: Omega,
    template: usize,
    /// Metres for one unit of the drawing.
    scale: f32,
}

impl Session {
    /// Begins with a drawing. Nothing is made yet.
    ///
    /// # Errors
    /// As [`SketchParams::validate`].
    pub fn new(drawing: Drawing, params: SketchParams, seed: Seed) -> Result<Self> {
        params.validate()?;
        let erased = vec![false; drawing.strokes.len()];
        Ok(Self {
            drawing,
            params,
            templates: None,
            obstacles: None,
            seed,
            erased,
            kept: None,
            cleaned: None,
            choices: None,
            inferred: None,
            propagated: None,
            wood: None,
            tree: None,
            runs: [0; Stage::ALL.len()],
        })
    }

    /// The drawing as it is after all edits; erased strokes are empty.
    #[must_use]
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// The parameters.
    #[must_use]
    pub fn params(&self) -> &SketchParams {
        &self.params
    }

    /// How often a stage has been done.
    #[must_use]
    pub fn runs(&self, stage: Stage) -> u32 {
        self.runs[stage as usize]
    }

    /// The templates there are: the session's own, or those built in.
    ///
    /// # Errors
    /// As [`Template::builtin`].
    pub fn templates(&self) -> Result<&[Template]> {
        match &self.templates {
            Some(own) => Ok(own),
            None => Template::builtin(),
        }
    }

    /// Forgets the results of a stage and of all later ones.
    pub fn redo_from(&mut self, stage: Stage) {
        for later in Stage::ALL.into_iter().filter(|&later| later >= stage) {
            match later {
                Stage::Clean => self.cleaned = None,
                Stage::Select => self.choices = None,
                Stage::Infer => self.inferred = None,
                Stage::Propagate => self.propagated = None,
                Stage::Wood => self.wood = None,
                Stage::Tree => self.tree = None,
            }
        }
    }

    /// The strokes as a tree in the plane, in metres.
    ///
    /// # Errors
    /// As [`clean`], [`Crown::close`], and of choosing the template, which gives the height.
    pub fn cleaned(&mut self, control: &Control) -> Result<&Cleaned> {
        Ok(&self.clean(control)?.cleaned)
    }

    /// The closed crown; `None` where none is drawn.
    ///
    /// # Errors
    /// As [`cleaned`](Self::cleaned).
    pub fn crown(&mut self, control: &Control) -> Result<Option<&Crown>> {
        Ok(self.clean(control)?.crown.as_ref().map(|(crown, _)| crown))
    }

    /// The templates compared with the drawing, best first.
    ///
    /// # Errors
    /// As [`cleaned`](Self::cleaned) and [`select`].
    pub fn choices(&mut self, control: &Control) -> Result<&[Choice]> {
        self.clean(control)?;
        Ok(self.choices.as_deref().unwrap_or(&[]))
    }

    /// The template taken.
    ///
    /// # Errors
    /// As [`choices`](Self::choices); [`ModelError::UnknownPreset`] for a name that is none.
    pub fn template(&mut self, control: &Control) -> Result<&Template> {
        self.clean(control)?;
        let index = self.template_index()?;
        Ok(&self.templates()?[index])
    }

    /// Depths, labels and Ω.
    ///
    /// # Errors
    /// As [`template`](Self::template) and [`infer`](crate::sketch::infer::infer).
    pub fn inferred(&mut self, control: &Control) -> Result<&Inferred> {
        if self.inferred.is_none() {
            let plan = &self.clean(control)?.cleaned.plan;
            let plan = plan.clone();
            let pins = self.kept.as_ref().map_or_else(Vec::new, |kept| kept.depths.pins(&plan));
            self.infer_with_pins(&pins, control)?;
        }
        missing(self.inferred.as_ref())
    }

    /// Infers anew where `pins` are known, and keeps it for edits.
    pub(super) fn infer_with_pins(&mut self, pins: &[Pin], control: &Control) -> Result<()> {
        let plan = self.clean(control)?.cleaned.plan.clone();
        let index = self.template_index()?;
        let template = &self.templates()?[index];
        let mut params =
            InferParams { slenderness: template.slenderness, ..self.params.infer.clone() };
        params.keep_omega |= self.kept.is_some();
        let omega = self.kept.as_ref().map_or(&template.omega, |kept| &kept.omega);
        let control = control.part(0.1, 0.5);
        let crown = self.cleaned.as_ref().and_then(|clean| clean.crown.as_ref());
        let known = (pins, crown.map(|(crown, _)| crown));
        let inferred = infer_with(&plan, omega, known, &params, self.seed, &control)?;
        self.kept = Some(Kept {
            depths: Depths::of(&plan, &inferred),
            omega: inferred.omega.clone(),
            template: index,
            scale: plan.scale,
        });
        self.redo_from(Stage::Infer);
        self.inferred = Some(inferred);
        self.runs[Stage::Infer as usize] += 1;
        Ok(())
    }

    /// What grew on the sketch.
    ///
    /// # Errors
    /// As [`inferred`](Self::inferred) and [`propagate`].
    pub fn propagated(&mut self, control: &Control) -> Result<&Propagated> {
        if self.propagated.is_none() {
            self.inferred(control)?;
            let mut params = self.params.propagate.clone();
            if self.finish_params()?.has_fronds() {
                params.orders = params.orders.min(FROND_ORDERS);
            }
            let inferred = missing(self.inferred.as_ref())?;
            let crown = self
                .cleaned
                .as_ref()
                .and_then(|clean| clean.crown.as_ref())
                .map(|(crown, _)| crown);
            let obstacles = self.obstacles.as_ref();
            let control = control.part(0.5, 0.7);
            let (branches, omega) = (&inferred.branches, &inferred.omega);
            let grown = propagate(branches, omega, crown, obstacles, &params, self.seed, &control)?;
            self.propagated = Some(grown);
            self.runs[Stage::Propagate as usize] += 1;
        }
        missing(self.propagated.as_ref())
    }

    /// The branches as a skeleton with radii.
    ///
    /// # Errors
    /// As [`propagated`](Self::propagated) and [`grow_wood`].
    pub fn wood(&mut self, control: &Control) -> Result<&Skeleton> {
        if self.wood.is_none() {
            self.propagated(control)?;
            let params = self.finish_params()?;
            let wood =
                grow_wood(missing(self.propagated.as_ref())?, &params, &control.part(0.7, 0.75))?;
            self.wood = Some(wood);
            self.runs[Stage::Wood as usize] += 1;
        }
        missing(self.wood.as_ref())
    }

    /// The tree.
    ///
    /// # Errors
    /// As [`wood`](Self::wood) and [`grow_crown`].
    pub fn tree(&mut self, control: &Control) -> Result<&SketchTree> {
        if self.tree.is_none() {
            self.wood(control)?;
            let params = self.finish_params()?;
            let clean = missing(self.cleaned.as_ref())?;
            let crown = clean.crown.as_ref().map(|(crown, _)| crown);
            let wood = missing(self.wood.as_ref())?;
            let (mut tree, finish) =
                grow_crown(wood, crown, &params, self.seed, &control.part(0.75, 1.0))?;
            let index = self.template_index()?;
            let template = &self.templates()?[index];
            if self.params.species.is_none() {
                tree = named(&tree, &template.name)?;
            }
            let inferred = missing(self.inferred.as_ref())?;
            let score = self
                .choices
                .as_ref()
                .and_then(|choices| choices.first())
                .map(|choice| choice.score);
            let mut repairs = clean.cleaned.report.clone();
            repairs.repairs.retain(|repair| {
                !self.erased.get(repair.stroke as usize).is_some_and(|&gone| gone)
            });
            let report = SketchReport {
                clean: repairs,
                crown: clean.crown.as_ref().map(|(_, report)| report.clone()),
                template: template.name.clone(),
                score: score.filter(|_| self.params.template.is_none()),
                segments: inferred.branches.len() as u32
                    - u32::from(inferred.branches.has_imagined_root()),
                posterior: inferred.posterior.total(),
                interpenetrations: inferred.interpenetrations,
                propagate: missing(self.propagated.as_ref())?.report,
                finish,
            };
            self.tree = Some(SketchTree { tree, report });
            self.runs[Stage::Tree as usize] += 1;
            control.report("done", 1.0)?;
        }
        missing(self.tree.as_ref())
    }

    /// Strokes joined, the crown closed, and with the template chosen all at its scale.
    fn clean(&mut self, control: &Control) -> Result<&Clean> {
        if self.cleaned.is_none() {
            control.report("strokes", 0.0)?;
            let mut cleaned = clean(&self.drawing, &self.params.clean, control)?;
            self.runs[Stage::Clean as usize] += 1;
            if self.params.template.is_none() && self.kept.is_none() {
                let points: Vec<_> = cleaned.crown.concat();
                let drawn = DrawnShape::measure(&cleaned.plan, &points);
                let cloud_alone = !points.is_empty() && !is_forked(&cleaned.plan);
                let mut params = self.params.select.clone();
                if cloud_alone {
                    // One stem under a cloud says nothing of branches: not that there are none.
                    (params.branches, params.shape, params.directions) = (0.0, 0.0, 0.0);
                }
                let templates = self.templates()?;
                let mut choices = select(&drawn, templates, &params)?;
                if cloud_alone {
                    // Nobody draws a palm's crown as a cloud.
                    choices.sort_by_key(|choice| is_palm(&templates[choice.template]));
                }
                self.choices = Some(choices);
                self.runs[Stage::Select as usize] += 1;
            }
            let height = match self.params.height {
                Some(height) => height,
                None => self.templates()?[self.template_index()?].height,
            };
            let factor = match &self.kept {
                Some(kept) => kept.scale / cleaned.plan.scale,
                None => height / self.params.clean.height,
            };
            cleaned.plan = cleaned.plan.scaled(factor)?;
            cleaned.crown.iter_mut().flatten().for_each(|point| *point *= factor);
            let crown = if cleaned.crown.is_empty() {
                None
            } else {
                let branches = above_root_branch(&cleaned.plan);
                Some(Crown::close(&cleaned.crown, &branches, &self.params.crown, control)?)
            };
            self.cleaned = Some(Clean { cleaned, crown });
        }
        missing(self.cleaned.as_ref())
    }

    /// Which template is taken: that of the name, that kept, or the best.
    fn template_index(&self) -> Result<usize> {
        let templates = self.templates()?;
        if let Some(name) = &self.params.template {
            return templates.iter().position(|template| template.name == *name).ok_or_else(|| {
                let known: Vec<_> =
                    templates.iter().map(|template| template.name.as_str()).collect();
                ModelError::UnknownPreset { name: name.clone(), known: known.join(", ") }
            });
        }
        let best =
            self.choices.as_ref().and_then(|choices| choices.first()).map(|choice| choice.template);
        let index = self.kept.as_ref().map(|kept| kept.template).or(best);
        index
            .filter(|&index| index < templates.len())
            .ok_or_else(|| ModelError::Template { problem: "there is none to choose from".into() })
    }

    /// The finish of the template, or of the species asked for.
    fn finish_params(&self) -> Result<FinishParams> {
        let template = &self.templates()?[self.template_index()?];
        let relative = self.params.finish.slenderness / FinishParams::default().slenderness;
        Ok(FinishParams {
            species: self.params.species.clone().unwrap_or_else(|| template.species.clone()),
            slenderness: (template.slenderness * relative).clamp(1e-4, 0.2),
            ..self.params.finish.clone()
        })
    }
}

/// Whether a template has fronds.
fn is_palm(template: &Template) -> bool {
    FinishParams { species: template.species.clone(), ..Default::default() }.has_fronds()
}

/// Whether a plan has a fork.
fn is_forked(plan: &Plan) -> bool {
    let mut parents = plan.parents()[1..].to_vec();
    parents.sort_unstable();
    parents.windows(2).any(|pair| pair[0] == pair[1])
}

/// The plan's nodes above its first fork; all of them where there is none.
fn above_root_branch(plan: &Plan) -> Vec<glam::Vec2> {
    let mut fan = vec![0_u32; plan.len()];
    for &parent in &plan.parents()[1..] {
        fan[parent as usize] += 1;
    }
    let fork = (0..plan.len()).find(|&node| fan[node] > 1).unwrap_or(0);
    // Nodes of a root branch come first along it only if nothing forks off before: all before the first fork in a
    // walk from the base are on it.
    let mut on_root = vec![false; plan.len()];
    let mut node = fork as u32;
    while let Some(slot) = on_root.get_mut(node as usize) {
        *slot = true;
        node = plan.parents()[node as usize];
    }
    (0..plan.len()).filter(|&node| !on_root[node]).map(|node| plan.positions()[node]).collect()
}

/// The tree under the name of its template.
fn named(tree: &tree_core::Tree, name: &str) -> Result<tree_core::Tree> {
    let species = tree_core::Species { name: name.into(), ..tree.species().clone() };
    Ok(tree_core::Tree::new(tree.skeleton().clone(), tree.foliage().clone(), species)?)
}

/// A stage that has been done has a result.
fn missing<T>(result: Option<T>) -> Result<T> {
    result.ok_or_else(|| ModelError::Sketch {
        problem: "a stage of the session has no result".into(),
    })
}
