//! Changes to a session. Each forgets what depends on it and keeps the rest.

use super::params::PhotoParams;
use super::shot::{Attractor, Placing, Shot};
use super::stages::{Session, Stage};
use crate::error::{ModelError, Result};
use crate::particle::attractor::AttractorGraph;
use crate::particle::density::{DensityBrush, DensityStroke, paint, paint_volume};
use crate::particle::{Grid, Matte};
use glam::Vec2;
use tree_core::{Control, Seed};

impl Session {
    /// Another seed: other particles, twigs and leaves in the same density.
    pub fn set_seed(&mut self, seed: Seed) {
        if seed != self.seed {
            self.seed = seed;
            self.redo_from(Stage::Flow);
        }
    }

    /// Other parameters; only stages whose parameters differ are done again. Painted density is lost when the
    /// density's parameters change.
    ///
    /// # Errors
    /// As [`PhotoParams::validate`]; nothing is changed then.
    pub fn set_params(&mut self, params: PhotoParams) -> Result<()> {
        params.validate()?;
        let old = std::mem::replace(&mut self.params, params);
        let new = &self.params;
        let changed = [
            (Stage::Views, old.height != new.height || old.imagine != new.imagine),
            (
                Stage::Attractors,
                (old.branches, old.attractor_seed, &old.seeds, &old.livewire, &old.strokes)
                    != (new.branches, new.attractor_seed, &new.seeds, &new.livewire, &new.strokes),
            ),
            (Stage::Density, old.density != new.density),
            (Stage::Fields, old.field != new.field),
            (Stage::Flow, old.flow != new.flow),
            (Stage::Wood, old.finish != new.finish),
        ];
        // The way through the density depends on a parameter of the flow.
        if old.flow.stem != new.flow.stem {
            self.forget_way();
        }
        for (stage, changed) in changed {
            if changed {
                self.redo_from(stage);
            }
        }
        Ok(())
    }

    /// Moves a photograph's camera.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there.
    pub fn set_placing(&mut self, view: usize, placing: Placing) -> Result<()> {
        self.shot_mut(view)?.placing = placing;
        self.redo_from(Stage::Views);
        Ok(())
    }

    /// Paints and erases density in a view, in pixels (Fig. 3.12). Branches found before stay as they are.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there, and as [`paint`].
    pub fn paint(&mut self, view: usize, strokes: &[DensityStroke]) -> Result<()> {
        let shot = self.shot_mut(view)?;
        let matte = paint(&shot.matte, strokes)?;
        self.set_matte(view, matte)
    }

    /// Replaces a view's matte, for instance after another matting. Cameras and branches found before stay as
    /// they are; [`redo_from`](Self::redo_from) finds them anew.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there, or a matte of another size.
    pub fn set_matte(&mut self, view: usize, matte: Matte) -> Result<()> {
        let shot = self.shot_mut(view)?;
        let (old, new) = [&shot.matte, &matte].map(|m| (m.width(), m.height())).into();
        if old != new {
            let problem = format!(
                "the new matte is {} × {} pixels, the old one {} × {}; both must be of one size",
                new.0, new.1, old.0, old.1
            );
            return Err(ModelError::View { view, problem });
        }
        shot.matte = matte.clone();
        if let Some(views) = &mut self.views {
            // The imagined side shows what the first photograph shows.
            if view == 0
                && views.len() > self.shots.len()
                && let Some(side) = views.last_mut()
            {
                side.matte = matte.mirrored();
            }
            views[view].matte = matte;
            self.redo_from(Stage::Density);
        }
        Ok(())
    }

    /// Paints density in space, after it has been found from the images.
    ///
    /// # Errors
    /// As [`density`](Self::density) and [`paint_volume`].
    pub fn paint_volume(&mut self, brushes: &[DensityBrush], control: &Control) -> Result<()> {
        let mut grid = self.density(control)?.clone();
        paint_volume(&mut grid, brushes)?;
        self.set_density(grid);
        Ok(())
    }

    /// Replaces the density, for instance by that of another source.
    pub fn set_density(&mut self, density: Grid) {
        self.redo_from(Stage::Density);
        self.density = Some(density);
    }

    /// Where a view's branches come from.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there.
    pub fn set_attractor(&mut self, view: usize, attractor: Attractor) -> Result<()> {
        self.shot_mut(view)?.attractor = attractor;
        self.redo_from(Stage::Attractors);
        Ok(())
    }

    /// Changes a view's branches, found or drawn, by hand: `edit` gets the graph and returns the new one, for
    /// instance by [`AttractorGraph::add_stroke`] or [`AttractorGraph::erase`]. Other views' are not found anew.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there, as [`attractors`](Self::attractors), and what `edit`
    /// returns.
    pub fn edit_attractor(
        &mut self,
        view: usize,
        control: &Control,
        edit: impl FnOnce(&AttractorGraph) -> Result<AttractorGraph>,
    ) -> Result<()> {
        self.shot_mut(view)?;
        let graph = edit(&self.attractors(control)?[view])?;
        if let Some(graphs) = &mut self.attractors {
            self.report.views[view].attracts = !graph.is_empty();
            graphs[view] = graph.clone();
            // The imagined side shows what the first photograph shows.
            if view == 0
                && graphs.len() > self.shots.len()
                && let Some(side) = graphs.last_mut()
            {
                *side = graph.mirrored(self.shots[0].matte.width() as f32);
            }
        }
        self.shot_mut(view)?.attractor = Attractor::Graph(graph);
        self.redo_from(Stage::Fields);
        Ok(())
    }

    /// A view's branches as strokes: what [`Attractor::Strokes`] takes.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there, and as [`attractors`](Self::attractors).
    pub fn strokes(&mut self, view: usize, control: &Control) -> Result<Vec<Vec<Vec2>>> {
        self.shot_mut(view)?;
        let graph = &self.attractors(control)?[view];
        Ok(graph.segments().map(|(a, b)| vec![a, b]).collect())
    }

    fn shot_mut(&mut self, view: usize) -> Result<&mut Shot> {
        let n = self.shots.len();
        self.shots.get_mut(view).ok_or_else(|| ModelError::View {
            view,
            problem: format!("there are {n} views, counted from 0"),
        })
    }
}
