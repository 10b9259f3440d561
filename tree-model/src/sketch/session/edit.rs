//! Changes to a session. Each forgets what depends on it and keeps the rest.

use super::params::SketchParams;
use super::stages::{Session, Stage};
use crate::error::{ModelError, Result};
use crate::sketch::Stroke;
use crate::sketch::infer::{Inferred, Pin};
use crate::sketch::template::Template;
use glam::Vec2;
use tree_core::{Control, NO_PARENT, Seed, Volume};

impl Session {
    /// The seed.
    #[must_use]
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// Another seed: other depths within Ω, another growth.
    pub fn set_seed(&mut self, seed: Seed) {
        if seed != self.seed {
            self.seed = seed;
            self.infer_anew();
        }
    }

    /// Other parameters; only stages whose parameters differ are done again.
    ///
    /// # Errors
    /// As [`SketchParams::validate`]; nothing is changed then.
    pub fn set_params(&mut self, params: SketchParams) -> Result<()> {
        params.validate()?;
        let old = std::mem::replace(&mut self.params, params);
        let new = &self.params;
        let anew =
            old.infer != new.infer || old.template != new.template || old.height != new.height;
        let changed = [
            (
                Stage::Clean,
                old.clean != new.clean || old.crown != new.crown || old.height != new.height,
            ),
            (Stage::Clean, old.select != new.select || old.template != new.template),
            (Stage::Infer, old.infer != new.infer),
            (Stage::Propagate, old.propagate != new.propagate),
            (Stage::Wood, old.finish != new.finish || old.species != new.species),
        ];
        if anew {
            self.infer_anew();
        }
        for (stage, changed) in changed {
            if changed {
                self.redo_from(stage);
            }
        }
        Ok(())
    }

    /// Templates of one's own instead of those built in.
    pub fn set_templates(&mut self, templates: Vec<Template>) {
        self.templates = Some(templates);
        self.infer_anew();
    }

    /// What new branches are to keep out of; `None` for nothing.
    pub fn set_obstacles(&mut self, obstacles: Option<Volume>) {
        self.obstacles = obstacles;
        self.redo_from(Stage::Propagate);
    }

    /// Forgets depths, Ω, scale and the choice of template that edits keep.
    pub fn infer_anew(&mut self) {
        self.kept = None;
        self.redo_from(Stage::Clean);
    }

    /// Draws one more stroke; returns its index. Depths of all other branches stay.
    pub fn add_stroke(&mut self, stroke: Stroke) -> usize {
        self.drawing.strokes.push(stroke);
        self.erased.push(false);
        self.redo_from(Stage::Clean);
        self.drawing.strokes.len() - 1
    }

    /// Erases a stroke, and with a branch all that it bears; returns the indices of what is gone. Depths of all other branches
    /// stay, and so do the indices of their strokes.
    ///
    /// # Errors
    /// [`ModelError::Stroke`] for a stroke that is not there, or erased before; as [`cleaned`](Self::cleaned).
    pub fn erase_stroke(&mut self, stroke: usize, control: &Control) -> Result<Vec<usize>> {
        self.check_stroke(stroke)?;
        let plan = self.cleaned(control)?.plan.clone();
        let mut gone = vec![false; self.drawing.strokes.len()];
        gone[stroke] = true;
        let strokes: Vec<usize> = plan.strokes().iter().map(|&stroke| stroke as usize).collect();
        let parents = plan.parents().to_vec();
        // A stroke that joins one that is gone is gone as well; parents come first.
        for (node, &parent) in parents.iter().enumerate() {
            if parent == NO_PARENT {
                continue;
            }
            let (own, below) = (strokes[node], strokes[parent as usize]);
            if own != below
                && gone.get(below) == Some(&true)
                && self.begins_at(&strokes, &parents, own, node)
                && let Some(slot) = gone.get_mut(own)
            {
                *slot = true;
            }
        }
        let list: Vec<usize> = (0..gone.len()).filter(|&i| gone[i] && !self.erased[i]).collect();
        for &index in &list {
            self.drawing.strokes[index].points.clear();
            self.erased[index] = true;
            if let Some(kept) = &mut self.kept {
                kept.depths.forget(index as u32);
            }
        }
        self.redo_from(Stage::Clean);
        Ok(list)
    }

    /// Whether `node` is the first of its stroke.
    fn begins_at(&self, strokes: &[usize], parents: &[u32], stroke: usize, node: usize) -> bool {
        (0..node).all(|before| strokes[before] != stroke || parents[before] == NO_PARENT)
    }

    /// Moves the tip or fork of a stroke that is nearest to `at` (in the drawing's units) to `depth` in metres, positive towards
    /// the viewer. What it bears is inferred anew; the rest stays. The end of the root segment stays in the plane.
    ///
    /// # Errors
    /// [`ModelError::Stroke`] for a stroke that is not there or has no tip or fork; [`ModelError::NotFinite`] for the place or
    /// depth; as [`inferred`](Self::inferred).
    pub fn set_depth(
        &mut self,
        stroke: usize,
        at: Vec2,
        depth: f32,
        control: &Control,
    ) -> Result<()> {
        self.check_stroke(stroke)?;
        if !at.is_finite() || !depth.is_finite() {
            return Err(ModelError::NotFinite { field: "set_depth".into() });
        }
        let name = self.drawing.name_of(stroke);
        self.inferred(control)?;
        let plan = self.cleaned(control)?.plan.clone();
        let place = plan.from_drawing(at);
        let inferred = self.inferred(control)?;
        let ends =
            (1..inferred.branches.len()).filter_map(|i| Some((i, *inferred.nodes(i).last()?)));
        let own = ends.filter(|&(_, node)| plan.strokes()[node as usize] as usize == stroke);
        let distance = |node: u32| plan.positions()[node as usize].distance(place);
        let nearest = own.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        let Some((segment, _)) = nearest else {
            let problem = "it has no tip or fork above the root segment to move".into();
            return Err(ModelError::Stroke { stroke: name, problem });
        };
        let pins = all_but_above(inferred, segment, depth);
        self.infer_with_pins(&pins, control)
    }

    fn check_stroke(&self, stroke: usize) -> Result<()> {
        let problem = match self.erased.get(stroke) {
            Some(false) => return Ok(()),
            Some(true) => "it is erased".into(),
            None => format!("there are {} strokes, counted from 0", self.erased.len()),
        };
        Err(ModelError::Stroke { stroke: format!("strokes[{stroke}]"), problem })
    }
}

/// The depths of all segments' ends but of those that `segment` bears; its own is new.
fn all_but_above(inferred: &Inferred, segment: usize, depth: f32) -> Vec<Pin> {
    let branches = &inferred.branches;
    let mut above = vec![false; branches.len()];
    let mut pins = Vec::with_capacity(branches.len());
    for i in 1..branches.len() {
        let parent = branches.parents()[i] as usize;
        above[i] = above[parent] || parent == segment;
        if let (false, Some(&node)) = (above[i], inferred.nodes(i).last()) {
            pins.push(Pin { node, depth: if i == segment { depth } else { branches.end(i).z } });
        }
    }
    pins
}
